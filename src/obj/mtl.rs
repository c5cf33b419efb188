//! Material files (MTL). As for the model itself, a file is checked first and given to `tobj` in a plain form, which it
//! takes without exception. A line that is wrong costs what it says, with a note, and nothing else.

use super::files::{Finder, portable};
use super::material::Material;
use super::notes::Notes;
use super::source::{self, number, numbers, short, without_comment, word, words};
use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The materials of a model's files.
#[derive(Default)]
pub(super) struct Library {
    pub materials: Vec<Material>,
    /// Which material has a name; the last of a name counts, as for `tobj`.
    by_name: HashMap<String, usize>,
    /// What was wrong in which file.
    pub notes: Vec<String>,
    finder: Finder,
    seen: HashSet<PathBuf>,
}

impl Library {
    /// Reads what a `mtllib` statement names: one file with blanks in its name, or several files.
    pub fn load(&mut self, folder: &Path, names: &str) {
        let whole = [names, without_comment(names)].into_iter().find_map(|name| self.finder.find(folder, name));
        let files: Vec<_> = match whole {
            Some(path) => vec![(names, Some(path))],
            None => words(names).map(|name| (name, self.finder.find(folder, name))).collect(),
        };
        for (name, path) in files {
            let path = path.unwrap_or_else(|| folder.join(portable(name)));
            if !self.seen.insert(path.clone()) {
                continue;
            }
            // Only a regular file has an end.
            let there = path.is_file() || !path.exists();
            match std::fs::read(if there { &path } else { Path::new("") }) {
                Ok(bytes) => self.read(&path, &bytes),
                Err(why) => {
                    self.notes.push(format!("{}: cannot be read: {why}; its materials are left out", path.display()));
                }
            }
        }
    }

    /// The material of a `usemtl` statement.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).or_else(|| self.by_name.get(without_comment(name))).copied()
    }

    fn read(&mut self, path: &Path, bytes: &[u8]) {
        let checked = check(&source::decode(bytes));
        let folder = path.parent().unwrap_or(Path::new(""));
        // The check leaves nothing over which `tobj` could fail.
        let read = tobj::load_mtl_buf(&mut checked.text.as_bytes()).map(|(materials, _)| materials).unwrap_or_default();
        self.notes.extend(checked.notes.sentences(Some(path)));
        for (material, name) in read.iter().zip(checked.names) {
            let texture = material.diffuse_texture.as_deref();
            let texture = texture.map(|file| self.finder.find(folder, file).unwrap_or_else(|| folder.join(file)));
            let material = Material::new(name, material, texture);
            if material.shines_everywhere() {
                let name = short(&material.name);
                self.notes.push(format!(
                    "{}: `{name}` has a Ks but no Ns above 0; its highlight covers all that is lit",
                    path.display()
                ));
            }
            let place = self.materials.len();
            for name in [without_comment(&material.name), &material.name] {
                self.by_name.insert(name.to_owned(), place);
            }
            self.materials.push(material);
        }
    }
}

/// A material file in its plain form.
struct Checked {
    /// What `tobj` reads: materials are named by numbers.
    text: String,
    /// The names of the materials.
    names: Vec<String>,
    notes: Notes,
}

fn check(text: &str) -> Checked {
    let mut checked = Checked { text: String::with_capacity(text.len()), names: Vec::new(), notes: Notes::default() };
    let mut opacity = Opacity::default();
    for statement in source::statements(text) {
        let (line, rest) = (statement.line, statement.rest.as_ref());
        let keyword = statement.keyword.to_ascii_lowercase();
        if keyword == "newmtl" {
            opacity.finish(&mut checked);
            let _ = writeln!(checked.text, "newmtl {}", checked.names.len());
            checked.names.push(rest.to_owned());
            continue;
        }
        let known = KEYWORDS.iter().find(|(name, ..)| name.eq_ignore_ascii_case(&keyword));
        let Some(&(name, kind)) = known else {
            continue;
        };
        if checked.names.is_empty() {
            checked.notes.add(line, || format!("`{name}` before any `newmtl`"), "it is left out");
            continue;
        }
        if let Err(why) = kind.check(name, line, rest, &mut checked, &mut opacity) {
            checked.notes.add(line, || format!("{name}: {why}"), "the line is left out");
        }
    }
    opacity.finish(&mut checked);
    checked
}

/// What follows a keyword.
#[derive(Clone, Copy)]
enum Kind {
    Color,
    Shininess,
    Opacity,
    Transparency,
    Map,
    /// What GL's materials do not have, and whose absence shows.
    Missing,
}

const KEYWORDS: [(&str, Kind); 9] = [
    ("Ka", Kind::Color),
    ("Kd", Kind::Color),
    ("Ks", Kind::Color),
    ("Ke", Kind::Color),
    ("Ns", Kind::Shininess),
    ("d", Kind::Opacity),
    ("Tr", Kind::Transparency),
    ("map_Kd", Kind::Map),
    ("map_d", Kind::Missing),
];

impl Kind {
    fn check(self, name: &str, line: usize, rest: &str, to: &mut Checked, opacity: &mut Opacity) -> Result<(), String> {
        match self {
            Self::Color => {
                let [r, g, b] = match words(rest).collect::<Vec<_>>()[..] {
                    ["spectral" | "xyz", ..] => return Err("spectral curves and CIE XYZ are not read".into()),
                    // The format's own rule for one number.
                    [gray] => {
                        let gray = number(gray)?;
                        to.notes.add(line, || format!("{name} has one number"), "it is taken as red, green and blue");
                        [gray; 3]
                    }
                    _ => numbers::<3>(rest)?,
                };
                let _ = writeln!(to.text, "{name} {r} {g} {b}");
            }
            Self::Shininess => {
                let [exponent] = numbers(rest)?;
                let _ = writeln!(to.text, "{name} {exponent}");
            }
            Self::Opacity => {
                let value = rest.strip_prefix("-halo");
                let [d] = numbers(value.unwrap_or(rest))?;
                if value.is_some() {
                    to.notes.add(line, || "`d -halo`".into(), "it is taken as a `d` without a halo");
                }
                opacity.d = Some(d);
            }
            Self::Transparency => {
                let [tr] = numbers(rest)?;
                opacity.tr = Some((tr, line));
            }
            Self::Map => match file_of_map(rest) {
                Some(file) => {
                    let _ = writeln!(to.text, "{name} {file}");
                }
                None => return Err("no file is named".into()),
            },
            Self::Missing => {
                to.notes.add(
                    line,
                    || format!("`{name}`"),
                    "opacity from an image is not read: use the alpha of `map_Kd`",
                );
            }
        }
        Ok(())
    }
}

/// The two ways to say how opaque a material is. `d` counts where there are both.
#[derive(Default)]
struct Opacity {
    d: Option<f64>,
    /// With its line.
    tr: Option<(f64, usize)>,
}

impl Opacity {
    /// Writes the opacity of the material that ends here.
    fn finish(&mut self, to: &mut Checked) {
        let Self { d, tr } = std::mem::take(self);
        if let (None, Some((tr, line))) = (d, tr)
            && tr >= 1.0
        {
            to.notes.add(line, || format!("`Tr {tr}` without a `d`"), "nothing of the material can be seen");
        }
        if let Some(d) = d.or(tr.map(|(tr, _)| 1.0 - tr)) {
            let _ = writeln!(to.text, "d {d}");
        }
    }
}

/// The file name of a texture statement: what follows the options, with slashes between folders.
pub(super) fn file_of_map(statement: &str) -> Option<String> {
    let mut rest = statement.trim();
    while let Some(option) = rest.strip_prefix('-') {
        let (name, after) = word(option);
        rest = after;
        match name {
            // Up to three numbers.
            "o" | "s" | "t" => {
                for _ in 0..3 {
                    let (number, after) = word(rest);
                    if number.parse::<f32>().is_err() {
                        break;
                    }
                    rest = after;
                }
            }
            "mm" => rest = word(word(rest).1).1,
            _ => rest = word(rest).1,
        }
    }
    (!rest.is_empty()).then(|| portable(rest))
}
