//! What every example program shares: run a GL program without a window, say in words what went wrong, save the picture.
//! A port keeps its GL calls; only the window system around them is replaced by these few functions.

#![allow(dead_code, reason = "no example needs all of it")]

use fixedgl::c::{glViewport, make_current, take_current};
use fixedgl::{Context, Error};
use std::path::{Path, PathBuf};

/// Draws a scene into a framebuffer of a size: a new context becomes current, its debug messages go to standard error,
/// and the context comes back with the picture in it.
pub fn run_in(mut context: Context, draw: impl FnOnce()) -> Context {
    context.set_debug_callback(|message| eprintln!("{message}"));
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

/// Runs a port as a program: draws, checks for GL errors, saves `NAME.png` where the command line says (`-o FILE`) or in
/// `out/`, and prints where that is.
pub fn main(name: &str, [width, height]: [u32; 2], draw: impl FnOnce()) {
    let mut context = run_in(Context::new(width, height), draw);
    if let Err(error) = context.check() {
        fail(&error);
    }
    let mut arguments = std::env::args().skip(1);
    let mut path = PathBuf::from("out").join(format!("{name}.png"));
    while let Some(argument) = arguments.next() {
        match (argument.as_str(), arguments.next()) {
            ("-o", Some(file)) => path = PathBuf::from(file),
            _ => {
                eprintln!("usage: {name} [-o FILE.png]");
                std::process::exit(2);
            }
        }
    }
    save(&mut context, &path);
    println!("{name}: {}", path.display());
}

/// Saves the framebuffer as a PNG, making the folder where that is missing.
pub fn save(context: &mut Context, path: &Path) {
    if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
        if let Err(error) = std::fs::create_dir_all(folder) {
            eprintln!("cannot make {}: {error}", folder.display());
            std::process::exit(1);
        }
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
