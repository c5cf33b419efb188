//! The same bytes everywhere: the pictures of the gallery, the scenes of the benchmark and work of other kinds are drawn at
//! every instruction set that the processor has, with 1, 2 and 7 threads, with two batch cuts and by the plan that leaves
//! nothing out; colours, depths and stencil values must not differ in one bit. Their hashes are kept in `tests/golden/`,
//! so that other processors and later versions are held to them too; `FIXEDGL_BLESS=1 cargo test --test invariance
//! kept` writes the files anew after a deliberate change (look at the pictures first).

#[path = "golden/bench.rs"]
mod bench;
#[path = "elision/mod.rs"]
mod elision;
#[path = "support/everywhere.rs"]
mod everywhere;
#[path = "golden/scenes.rs"]
mod scenes;
#[path = "golden/work.rs"]
mod work;

use bench::stage::Stage;
use everywhere::{Frame, reference, variants};
use fixedgl::Config;
use fixedgl::Context;
use fixedgl::c::{make_current, take_current};
use scenes::{SCENES, Scene};
use std::fmt::Write;
use std::path::PathBuf;

/// Width and height of the framebuffer for the benchmark's scenes and other work: rows are long enough for every kernel
/// of whole rows, and there are several bands for the threads.
const SIZE: u32 = 192;

/// Something to draw: its name, and what a context of a configuration has drawn.
struct Drawing {
    name: &'static str,
    draw: Box<dyn Fn(Config) -> Context>,
}

fn draw_scene(scene: &Scene, config: Config) -> Context {
    make_current(Context::with_config(scene.size[0], scene.size[1], config));
    (scene.draw)();
    take_current().expect("the context from above")
}

fn gallery() -> Vec<Drawing> {
    let drawing =
        |scene: &'static Scene| Drawing { name: scene.name, draw: Box::new(move |config| draw_scene(scene, config)) };
    SCENES.iter().map(drawing).collect()
}

/// Two drawings of each scene: the second one finds textures, plans and depths that the first has left.
fn benchmark() -> Vec<Drawing> {
    let drawing = |scene: &'static bench::Scene| Drawing {
        name: scene.id,
        draw: Box::new(move |config| {
            let mut stage = Stage::new(SIZE, config);
            stage.coarser = 3;
            (scene.set_up)(&mut stage);
            (0..2).for_each(|_| (scene.draw)(&mut stage));
            stage.gl
        }),
    };
    bench::SCENES.iter().map(drawing).collect()
}

fn other_work() -> Vec<Drawing> {
    let drawing = |(name, draw): work::Work| Drawing {
        name,
        draw: Box::new(move |config| {
            let mut stage = Stage::new(SIZE, config);
            draw(&mut stage);
            stage.gl
        }),
    };
    work::WORK.iter().copied().map(drawing).collect()
}

/// What a drawing leaves in the framebuffer.
fn frame(drawing: &Drawing, config: Config) -> Frame {
    let mut context = (drawing.draw)(config);
    assert_eq!(context.check(), Ok(()), "{} causes a GL error", drawing.name);
    Frame::of(&mut context)
}

/// FNV-1a.
fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xCBF2_9CE4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01B3))
}

/// A line of a file of hashes: the name, colours, and depths and stencil values where they are not all the same.
fn line(name: &str, frame: &Frame) -> String {
    let mut line = format!("{name} {:016x}", hash(frame.colors.iter().copied()));
    let buffers = [&frame.depths, &frame.stencils.iter().copied().map(u64::from).collect()];
    for values in buffers {
        if values.iter().all(|value| value == &values[0]) {
            line.push_str(" -");
        } else {
            write!(line, " {:016x}", hash(values.iter().flat_map(|v| v.to_le_bytes()))).expect("a string takes text");
        }
    }
    line
}

/// Draws all in every way, compares them with each other and with the hashes that are kept in a file of `tests/golden`.
fn hold(file: &str, drawings: &[Drawing]) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(file);
    let (mut found, mut wrong) = (String::new(), String::new());
    for drawing in drawings {
        let expected = frame(drawing, reference());
        writeln!(found, "{}", line(drawing.name, &expected)).expect("a string takes text");
        for config in variants() {
            let other = frame(drawing, config);
            if other != expected {
                let pixels = expected.differing(&other);
                writeln!(wrong, "{}: {pixels} colours differ with {config:?}", drawing.name)
                    .expect("a string takes text");
            }
        }
    }
    assert!(wrong.is_empty(), "not the same everywhere:\n{wrong}");
    if std::env::var_os("FIXEDGL_BLESS").is_some() {
        std::fs::write(&file, &found).expect("the file of hashes can be written");
    }
    let kept = std::fs::read_to_string(&file).expect("the file of hashes");
    for (kept, found) in kept.lines().zip(found.lines()).filter(|(kept, found)| kept != found) {
        writeln!(wrong, "kept  {kept}\nfound {found}").expect("a string takes text");
    }
    assert!(wrong.is_empty(), "pictures have changed; if that is meant, look at them and bless them:\n{wrong}");
    assert_eq!(kept.lines().count(), drawings.len(), "{} has other lines than there are drawings", file.display());
}

#[test]
fn pictures_of_the_gallery_are_the_same_everywhere_and_those_that_are_kept() {
    hold("gallery.txt", &gallery());
}

#[test]
fn scenes_of_the_benchmark_are_the_same_everywhere_and_those_that_are_kept() {
    hold("bench.txt", &benchmark());
}

#[test]
fn other_work_is_the_same_everywhere_and_that_which_is_kept() {
    hold("work.txt", &other_work());
}

#[test]
fn a_context_can_be_sent_to_another_thread() {
    let expected = draw_scene(&SCENES[0], reference()).pixels();
    let found =
        std::thread::spawn(|| draw_scene(&SCENES[0], reference()).pixels()).join().expect("the thread has drawn");
    assert!(found == expected);
    fn sendable<T: Send>() {}
    sendable::<Context>();
}
