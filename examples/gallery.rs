//! Draws every scene of the scene table and writes the pictures and one HTML page with captions, the GL calls that matter
//! and how long each took. No arguments needed; `--out DIR` chooses the folder.

#[path = "../tests/golden/scenes.rs"]
mod scenes;
#[path = "support/mod.rs"]
mod support;

use fixedgl::Context;
use indicatif::{ProgressBar, ProgressStyle};
use scenes::{SCENES, Scene};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

const STYLE: &str = "
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 70rem; padding: 0 1rem; color: #222; }
section { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 1.5rem; margin: 2rem 0; align-items: start; }
img { max-width: 100%; image-rendering: pixelated; border: 1px solid #ccc; }
h2 { margin: 0 0 .3rem; font-size: 1.2rem; }
pre { background: #f4f2ee; padding: .7rem; overflow-x: auto; font-size: .8rem; }
small { color: #777; }
@media (max-width: 45rem) { section { grid-template-columns: 1fr; } }
";

/// What one scene came to.
struct Drawn {
    scene: Scene,
    milliseconds: f64,
    error: Option<String>,
}

fn draw(scene: Scene, folder: &Path) -> Drawn {
    let start = Instant::now();
    let mut context = support::run_in(Context::new(scene.size[0], scene.size[1]), scene.draw);
    let pixels = context.pixels();
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;
    drop(pixels);
    let error = context.check().err().map(|error| error.to_string());
    support::save(&mut context, &folder.join(format!("{}.png", scene.name)));
    Drawn { scene, milliseconds, error }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn page(drawn: &[Drawn]) -> Result<String, std::fmt::Error> {
    let mut html = String::new();
    write!(
        html,
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n<meta name=\"viewport\" \
         content=\"width=device-width\">\n<title>fixedgl: gallery</title>\n<style>{STYLE}</style>\n<h1>fixedgl: \
         gallery</h1>\n<p>{} scenes, drawn in software by the ports in <code>examples/</code>. The times include setting \
         up, uploading textures and drawing one frame.</p>\n",
        drawn.len()
    )?;
    for Drawn { scene, milliseconds, error } in drawn {
        let [w, h] = scene.size;
        write!(
            html,
            "<section><img src=\"{0}.png\" width=\"{w}\" height=\"{h}\" alt=\"{1}\">\n<div><h2>{0}</h2>\n<p>{1}</p>\n\
             <pre>{2}</pre>\n<small>examples/{0}.rs, {w} x {h}, {milliseconds:.1} ms</small>{3}</div></section>\n",
            scene.name,
            escape(scene.caption),
            escape(&scene.calls.join("\n")),
            error.as_ref().map_or(String::new(), |e| format!("<p><strong>{}</strong></p>", escape(e)))
        )?;
    }
    html.push_str("</html>\n");
    Ok(html)
}

fn folder() -> PathBuf {
    let usage =
        "usage: gallery [--out FOLDER]\n\nDraws every scene into FOLDER (out/gallery) and writes a page about them.\n";
    support::arguments(usage, |arguments| match (arguments.next().as_deref(), arguments.next()) {
        (None, _) => Ok(PathBuf::from("out/gallery")),
        (Some("--out"), Some(folder)) => Ok(PathBuf::from(folder)),
        (Some("--out"), None) => Err("--out needs a folder".into()),
        (Some(other), _) => Err(format!("{other} is not known")),
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = folder();
    std::fs::create_dir_all(&folder)?;
    let bar = ProgressBar::new(SCENES.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:32} {pos}/{len} {msg}")?);
    let mut drawn = Vec::new();
    for scene in SCENES {
        bar.set_message(scene.name);
        drawn.push(draw(*scene, &folder));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let index = folder.join("index.html");
    std::fs::write(&index, page(&drawn)?)?;
    let failed: Vec<&Drawn> = drawn.iter().filter(|d| d.error.is_some()).collect();
    for drawn in &failed {
        eprintln!("{}: {}", drawn.scene.name, drawn.error.as_deref().unwrap_or_default());
    }
    println!("{} scenes: {}", drawn.len(), index.display());
    if failed.is_empty() { Ok(()) } else { Err("a scene caused a GL error".into()) }
}
