//! What every example program shares: run a GL program without a window, say in words what went wrong, save the picture.
//! A port keeps its GL calls; only the window system around them is replaced by these few functions.

#![allow(dead_code, reason = "no example needs all of it")]

pub mod shapes;
pub mod textures;

use fixedgl::c::{glViewport, make_current, take_current};
use fixedgl::{Context, Error};
use std::path::{Path, PathBuf};

/// Draws into a context: it becomes current, its messages go to standard error, and it comes back with the picture.
pub fn run_in(mut context: Context, draw: impl FnOnce()) -> Context {
    context.set_debug_callback(Some(Box::new(|message| eprintln!("{message}"))));
    let (width, height) = context.size();
    let previous = make_current(context);
    glViewport(0, 0, width as i32, height as i32);
    draw();
    let drawn = take_current().unwrap_or_else(|| Context::new(width, height));
    if let Some(previous) = previous {
        make_current(previous);
    }
    drawn
}

/// What the command line asks for. `--help` prints the usage and ends the program with 0; arguments that are wrong end it
/// with 2, as is the custom, so that 1 means that the program itself failed.
pub fn arguments<T>(usage: &str, parse: impl FnOnce(&mut dyn Iterator<Item = String>) -> Result<T, String>) -> T {
    if std::env::args().skip(1).any(|argument| argument == "--help" || argument == "-h") {
        print!("{usage}");
        std::process::exit(0);
    }
    parse(&mut std::env::args().skip(1)).unwrap_or_else(|message| {
        eprint!("{message}\n{usage}");
        std::process::exit(2);
    })
}

/// Runs a port as a program: draws, checks for GL errors, saves `NAME.png` where the command line says (`-o FILE`) or in
/// `out/`, and prints where that is.
pub fn main(name: &str, [width, height]: [u32; 2], draw: impl FnOnce()) {
    let usage = format!("usage: {name} [-o FILE.png]\n\nDraws its picture into FILE.png (out/{name}.png).\n");
    let path = arguments(&usage, |arguments| match (arguments.next().as_deref(), arguments.next()) {
        (None, _) => Ok(PathBuf::from("out").join(format!("{name}.png"))),
        (Some("-o"), Some(file)) => match arguments.next() {
            None => Ok(PathBuf::from(file)),
            Some(more) => Err(format!("{more} is not known")),
        },
        (Some("-o"), None) => Err("-o needs a file".into()),
        (Some(other), _) => Err(format!("{other} is not an option")),
    });
    let mut context = run_in(Context::new(width, height), draw);
    if let Err(error) = context.check() {
        fail(&error);
    }
    save(&mut context, &path);
    println!("{name}: {}", path.display());
}

/// Saves the framebuffer as a PNG, making the folder where that is missing.
pub fn save(context: &mut Context, path: &Path) {
    if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty())
        && let Err(error) = std::fs::create_dir_all(folder)
    {
        eprintln!("cannot make {}: {error}", folder.display());
        std::process::exit(1);
    }
    if let Err(error) = fixedgl::image_io::save_png(context, path) {
        eprintln!("cannot write {}: {error}", path.display());
        std::process::exit(1);
    }
}

fn fail(error: &Error) -> ! {
    eprintln!("the program caused a GL error: {error}");
    std::process::exit(1);
}

/// Sets a perspective projection and the modelview matrix to identity: the reshape function of most programs.
pub fn reshape(fovy: f64, [w, h]: [u32; 2], near: f64, far: f64) {
    use fixedgl::c::*;
    glViewport(0, 0, w as GLsizei, h as GLsizei);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(fovy, f64::from(w) / f64::from(h), near, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/// The constants, the entry and the module of helpers that every port has.
#[allow(unused_macros, reason = "the gallery and the viewer are no ports")]
macro_rules! port {
    ($name:literal, $size:expr, $caption:literal, $calls:expr) => {
        pub(crate) const NAME: &str = $name;
        pub(crate) const SIZE: [u32; 2] = $size;
        #[allow(dead_code, reason = "only the gallery prints it")]
        pub(crate) const CAPTION: &str = $caption;
        #[allow(dead_code, reason = "only the gallery prints them")]
        pub(crate) const CALLS: &[&str] = &$calls;

        #[allow(dead_code, reason = "the scene table uses this file as a module")]
        fn main() {
            support::main(NAME, SIZE, draw);
        }
    };
}
#[allow(unused_imports, reason = "the gallery and the viewer are no ports")]
pub(crate) use port;
