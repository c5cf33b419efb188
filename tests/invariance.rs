//! The same bytes everywhere: every scene of the table is drawn at every instruction set that the processor has, with 1, 2
//! and 7 threads, with two batch cuts and by the plan that leaves nothing out; colours, depths and stencil values must not
//! differ in one bit. The hashes of the pictures are kept in `tests/golden/hashes.txt`, so that other processors and later
//! versions are held to them too; `FIXEDGL_BLESS=1 cargo test --test invariance` writes the file anew after a deliberate
//! change (look at the pictures first).

#[path = "support/everywhere.rs"]
mod everywhere;
#[path = "golden/scenes.rs"]
mod scenes;

use everywhere::{Frame, reference, variants};
use fixedgl::Config;
use fixedgl::Context;
use fixedgl::c::{make_current, take_current};
use scenes::{SCENES, Scene};
use std::fmt::Write;
use std::path::PathBuf;

fn draw(scene: &Scene, config: Config) -> Frame {
    make_current(Context::with_config(scene.size[0], scene.size[1], config));
    (scene.draw)();
    let mut context = take_current().expect("the context from above");
    assert_eq!(context.check(), Ok(()), "{} causes a GL error", scene.name);
    Frame::of(&mut context)
}

/// FNV-1a.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01B3))
}

#[test]
fn every_way_of_running_gives_the_same_bytes() {
    let mut compared = 0;
    for scene in SCENES {
        let expected = draw(scene, reference());
        for config in variants() {
            let found = draw(scene, config);
            let pixels = expected.differing(&found);
            assert!(found == expected, "{}: {pixels} pixels differ with {config:?}", scene.name);
            compared += 1;
        }
    }
    eprintln!("{} scenes, {compared} comparisons, all equal", SCENES.len());
}

#[test]
fn pictures_are_the_golden_ones() {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden/hashes.txt");
    let mut found = String::new();
    for scene in SCENES {
        let frame = draw(scene, reference());
        writeln!(found, "{} {:016x}", scene.name, hash(&frame.colors)).expect("a string takes text");
    }
    if std::env::var_os("FIXEDGL_BLESS").is_some() {
        std::fs::write(&file, &found).expect("the file of hashes can be written");
    }
    let expected = std::fs::read_to_string(&file).expect("the file of hashes");
    for (expected, found) in expected.lines().zip(found.lines()) {
        assert_eq!(expected, found, "a picture has changed; if that is meant, look at it and bless it");
    }
    assert_eq!(expected.lines().count(), SCENES.len());
}

#[test]
fn a_context_can_be_sent_to_another_thread() {
    let scene = SCENES[0];
    let expected = draw(&scene, reference());
    let found = std::thread::spawn(move || draw(&scene, reference())).join().expect("the thread has drawn");
    assert!(found == expected);
    fn sendable<T: Send>() {}
    sendable::<Context>();
}
