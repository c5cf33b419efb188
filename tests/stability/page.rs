//! The page `spec-notes/stability.md` has every row, word for word. Its tables stand between two marks for each part and
//! are written by `FIXEDGL_BLESS=1 cargo test --test spec the_page`.

use crate::stability::row::Row;
use std::fmt::Write;
use std::path::PathBuf;

/// The parts of the page and their rows.
const PARTS: &[(&str, &[Row])] = &[
    ("clip", crate::stability::clip::ROWS),
    ("raster", crate::stability::raster::ROWS),
    ("coords", crate::stability::coords::ROWS),
    ("texels", crate::stability::texels::ROWS),
    ("lod", crate::stability::lod::ROWS),
    ("vertex", crate::stability::vertex::ROWS),
    ("fragment", crate::stability::fragment::ROWS),
];

/// The table of a part, with figures where they are measured.
fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| row | input | expected | formulation | allowed | worst | cases | random |\n|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let worst = row.measure();
        writeln!(text, "{}", row.line(&worst)).expect("a string takes text");
    }
    text
}

#[test]
fn the_page_has_every_row() {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("spec-notes/stability.md");
    let mut page = std::fs::read_to_string(&file).expect("the page");
    if std::env::var_os("FIXEDGL_BLESS").is_some() {
        for (part, rows) in PARTS {
            let (begin, end) = (format!("<!-- {part} -->\n"), format!("<!-- end of {part} -->"));
            let from = page.find(&begin).expect("the mark of the part") + begin.len();
            let to = page.find(&end).expect("the mark of its end");
            page.replace_range(from..to, &table(rows));
        }
        std::fs::write(&file, &page).expect("the page can be written");
    }
    let mut names = std::collections::HashSet::new();
    for row in PARTS.iter().flat_map(|(_, rows)| *rows) {
        assert!(names.insert(row.name), "{} stands twice", row.name);
        let found = page.lines().any(|line| line.starts_with(&row.beginning()));
        assert!(found, "row {} is not on the page; FIXEDGL_BLESS=1 writes it", row.name);
    }
    let listed = page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| row ")).count();
    eprintln!("{} rows, {listed} lines on the page", names.len());
}
