//! The shape of the house: arrows between rooms only point down the list of the design, files keep to a readable length,
//! few files form a circle, and what the pages of spec-notes name does exist. A change that breaks the plan fails here, not
//! in a review.

#[path = "support/imports.rs"]
mod imports;

use imports::Graph;
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms, from the top of the house to its ground. A room may use what stands below it.
const ROOMS: &[&[&str]] = &[
    &["spec_notes", "soundness"],
    &["capi"],
    &["c"],
    &["explain"],
    &["image_io", "obj"],
    &["glu"],
    &["context"],
    &["vertex"],
    &["raster"],
    &["fragment"],
    &["texture"],
    &["framebuffer"],
    &["pixels"],
    &["state"],
    &["simd"],
    &["num", "enums", "error", "limits"],
];

/// Generated-looking tables of names may be longer than a page of logic.
const MOST_LINES: usize = 500;

/// Files that may use each other in one circle: more of them can only be understood, changed and tested together.
const LARGEST_CIRCLE: usize = 3;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn rust_files(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).expect("a folder of the crate").flatten() {
        let path = entry.path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

fn sources() -> Vec<PathBuf> {
    let mut found = Vec::new();
    rust_files(&root().join("src"), &mut found);
    found.sort();
    found
}

fn level(room: &str) -> Option<usize> {
    ROOMS.iter().position(|rooms| rooms.contains(&room))
}

fn room_of(file: &Path) -> String {
    let inside = file.strip_prefix(root().join("src")).expect("a file of src");
    let first = inside.components().next().expect("a name").as_os_str().to_string_lossy();
    first.trim_end_matches(".rs").to_string()
}

#[test]
fn every_room_is_in_the_plan() {
    for file in sources() {
        let room = room_of(&file);
        assert!(room == "lib" || level(&room).is_some(), "{}: room {room} is not in the plan", file.display());
    }
}

#[test]
fn arrows_only_point_down() {
    let mut wrong = Vec::new();
    for file in sources() {
        let room = room_of(&file);
        let Some(from) = level(&room) else { continue };
        let text = fs::read_to_string(&file).expect("a source file");
        for (number, line) in text.lines().enumerate().filter(|(_, l)| !l.trim_start().starts_with("//")) {
            for part in line.split("crate::").skip(1) {
                let used: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                if used != room && level(&used).is_some_and(|to| to < from) {
                    wrong.push(format!("{}:{}: {room} uses {used}", file.display(), number + 1));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "arrows that point up:\n{}", wrong.join("\n"));
}

#[test]
fn circles_of_imports_are_small() {
    let graph = Graph::read(&root().join("src"));
    let circles = graph.circles();
    let list = |circle: &Vec<&str>| format!("{} files: {}", circle.len(), circle.join(" "));
    let large: Vec<String> = circles.iter().filter(|circle| circle.len() > LARGEST_CIRCLE).map(list).collect();
    circles.iter().for_each(|circle| eprintln!("{}", list(circle)));
    assert!(large.is_empty(), "circles of more than {LARGEST_CIRCLE} files:\n{}", large.join("\n"));
}

#[test]
fn files_have_a_readable_length() {
    let long: Vec<String> = sources()
        .iter()
        .filter_map(|file| {
            let lines = fs::read_to_string(file).expect("a source file").lines().count();
            (lines > MOST_LINES).then(|| format!("{} has {lines} lines", file.display()))
        })
        .collect();
    assert!(long.is_empty(), "split these files:\n{}", long.join("\n"));
}

#[test]
fn every_file_says_what_it_is() {
    for file in sources() {
        let text = fs::read_to_string(&file).expect("a source file");
        assert!(text.starts_with("//!"), "{} does not open with what it is", file.display());
    }
}

#[test]
fn paths_on_the_pages_of_spec_notes_exist() {
    let mut missing = Vec::new();
    for entry in fs::read_dir(root().join("spec-notes")).expect("spec-notes").flatten() {
        let page = entry.path();
        if page.extension().is_none_or(|e| e != "md") {
            continue;
        }
        let text = fs::read_to_string(&page).expect("a page");
        for word in text.split(|c: char| c.is_whitespace() || "`()[],;\"'|".contains(c)) {
            let word = word.trim_end_matches(['.', ':']);
            let path = word.split('#').next().unwrap_or(word);
            let named = ["src/", "tests/", "examples/", "spec-notes/"].iter().any(|dir| path.starts_with(dir));
            if named
                && !path.contains(['*', '{', '<', '…'])
                && !root().join(path.split("::").next().unwrap_or(path)).exists()
            {
                missing.push(format!("{} names {path}", page.display()));
            }
        }
    }
    assert!(missing.is_empty(), "paths that do not exist:\n{}", missing.join("\n"));
}

#[test]
fn links_between_pages_of_spec_notes_have_their_definitions() {
    let links = fs::read_to_string(root().join("src/spec_notes/links.md")).expect("the links of rustdoc");
    let pages = fs::read_to_string(root().join("src/spec_notes/mod.rs")).expect("the pages of rustdoc");
    let mut wrong = Vec::new();
    for entry in fs::read_dir(root().join("spec-notes")).expect("spec-notes").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.ends_with(".md") {
            continue;
        }
        let text = fs::read_to_string(entry.path()).expect("a page");
        for link in text.split('[').skip(1).filter_map(|part| part.split(']').next()).filter(|l| l.ends_with(".md")) {
            if !text.contains(&format!("\n[{link}]: {link}\n")) {
                wrong.push(format!("{name} links to {link} and does not define it"));
            }
        }
        if text.contains(".md)") {
            wrong.push(format!("{name} has a link that documentation cannot follow: write [text][page.md]"));
        }
        let listed = links.contains(&format!("[{name}]: ")) && pages.contains(&format!("\"{name}\""));
        if name != "README.md" && !listed {
            wrong.push(format!("{name} is not in src/spec_notes"));
        }
    }
    assert!(wrong.is_empty(), "links between pages:\n{}", wrong.join("\n"));
}
