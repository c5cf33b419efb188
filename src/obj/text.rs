//! The check of an OBJ file before `tobj` reads it. What can be read is read, and for the rest there is a note with the
//! line: numbers must be finite, indices must exist. What comes out is a plain form of the same model: positions near the
//! origin, triangles with absolute indices whose corners all have the same parts, materials named by numbers.

use super::faces::Cutter;
use super::notes::Notes;
use super::source::{self, Statement, number, numbers, short, words};
use std::fmt::Write;

/// A checked file.
#[derive(Debug, Default)]
pub(super) struct Checked {
    /// The model in its plain form.
    pub text: String,
    /// What was subtracted from the file's positions.
    pub offset: [f64; 3],
    /// Whether the corners have texture coordinates; those without got (0, 0).
    pub has_tex_coords: bool,
    /// Whether the vertices have colours; those without got white.
    pub has_colors: bool,
    /// The names of objects and groups; the plain form has their numbers.
    pub names: Vec<String>,
    /// How the triangles are smoothed where they have no normals: from which triangle on.
    pub smoothing: Vec<(usize, Smoothing)>,
}

/// Which faces share the normals that are computed where they meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Smoothing {
    /// The file does not say: those that lean less than a certain angle from each other.
    #[default]
    ByAngle,
    /// `s off`: none.
    Off,
    /// `s n`: those of the same group, whatever the angle.
    Group(u32),
}

/// A corner as indices that count from 1; 0 for a part that is not there.
type Corner = [u32; 3];

const PARTS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// From how many times its own size a model is so far from the origin that f32 would take its shape.
const FAR: f64 = 16.0;

/// Colours of vertices lie between 0 and 1; a file with one beyond this has them between 0 and 255.
const BRIGHTEST: f64 = 2.0;

/// The longest name of a group that is kept. Each group has its own copy.
const LONGEST_NAME: usize = 128;

/// What is between two faces, by the number of the face before which it stands.
enum Change {
    Name(String),
    Material(String),
    Smoothing(Smoothing),
}

/// A file as it was read, line by line.
#[derive(Default)]
pub(super) struct Parsed {
    /// A position that could not be read is none.
    positions: Vec<Option<[f64; 3]>>,
    /// Empty, or one for each position.
    colors: Vec<[f64; 3]>,
    tex_coords: Vec<[f64; 2]>,
    /// (0, 0, 0) for one that has to be computed.
    normals: Vec<[f64; 3]>,
    corners: Vec<Corner>,
    /// The line of each face, and where its corners end.
    faces: Vec<(usize, usize)>,
    changes: Vec<(usize, Change)>,
    /// What `mtllib` statements name.
    pub libraries: Vec<String>,
    /// Whether any statement was one of an OBJ file.
    pub is_obj: bool,
}

/// Statements of OBJ files that say nothing about what is drawn here.
const WITHOUT_EFFECT: [&str; 22] = [
    "vp",
    "cstype",
    "deg",
    "bmat",
    "step",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "maplib",
    "usemap",
    "shadow_obj",
    "trace_obj",
    "ctech",
];

impl Parsed {
    /// Reads the statements.
    pub fn new(text: &str, notes: &mut Notes) -> Self {
        let mut parsed = Self::default();
        for statement in source::statements(text) {
            parsed.statement(&statement, notes);
        }
        parsed
    }

    fn statement(&mut self, statement: &Statement<'_>, notes: &mut Notes) {
        let (line, rest) = (statement.line, statement.rest.as_ref());
        let keyword = statement.keyword.to_ascii_lowercase();
        let change = |change| (self.faces.len(), change);
        match keyword.as_str() {
            "v" => self.position(line, rest, notes),
            "vt" => {
                let one = words(rest).nth(1).is_none();
                let uv = if one { numbers(rest).map(|[u]| [u, 0.0]) } else { numbers(rest) };
                let uv = uv.unwrap_or_else(|why| {
                    notes.add(line, || why, "the texture coordinate is (0, 0)");
                    [0.0; 2]
                });
                self.tex_coords.push(uv);
            }
            "vn" => self.normals.push(numbers(rest).unwrap_or_else(|why| {
                notes.add(line, || why, "the normal is computed instead");
                [0.0; 3]
            })),
            "f" | "fo" => self.face(line, rest, notes),
            "o" | "g" => {
                let end =
                    rest.char_indices().map(|(i, c)| i + c.len_utf8()).take_while(|&end| end <= LONGEST_NAME).last();
                self.changes.push(change(Change::Name(rest[..end.unwrap_or(0)].to_owned())));
            }
            "usemtl" => self.changes.push(change(Change::Material(rest.to_owned()))),
            "s" => match words(rest).next() {
                Some("off" | "0") => self.changes.push(change(Change::Smoothing(Smoothing::Off))),
                word => match word.map(str::parse) {
                    Some(Ok(group)) => self.changes.push(change(Change::Smoothing(Smoothing::Group(group)))),
                    _ => notes.add(line, || format!("`s {}`", short(rest)), "a smoothing group is a number or `off`"),
                },
            },
            "mtllib" => self.libraries.push(rest.to_owned()),
            "p" | "l" => notes.add(line, || format!("`{keyword}`"), "points and lines are left out"),
            "curv" | "curv2" | "surf" => notes.add(line, || format!("`{keyword}`"), "curves and surfaces are left out"),
            other if WITHOUT_EFFECT.contains(&other) => {}
            other => {
                notes.add(
                    line,
                    || format!("`{}` is no statement of an OBJ file", short(other)),
                    "the line is left out",
                );
                return;
            }
        }
        self.is_obj = true;
    }

    /// `v x y z [w]` or `v x y z r g b`; a weight is of use for curves only.
    fn position(&mut self, line: usize, rest: &str, notes: &mut Notes) {
        let position = numbers::<3>(rest).map_err(|why| notes.add(line, || why, "faces with this vertex are left out"));
        let mut colour = words(rest).skip(3);
        let colour = [colour.next(), colour.next(), colour.next()];
        if let [Some(r), Some(g), Some(b)] = colour {
            self.colors.resize(self.positions.len(), [1.0; 3]);
            let read = [r, g, b].map(number);
            self.colors.push(match read {
                [Ok(r), Ok(g), Ok(b)] => [r, g, b],
                [r, g, b] => {
                    let why = [r, g, b].into_iter().find_map(Result::err).unwrap_or_default();
                    notes.add(line, || why, "the vertex is white");
                    [1.0; 3]
                }
            });
        } else if !self.colors.is_empty() {
            self.colors.push([1.0; 3]);
        }
        self.positions.push(position.ok());
    }

    fn face(&mut self, line: usize, rest: &str, notes: &mut Notes) {
        let start = self.corners.len();
        let there = [self.positions.len(), self.tex_coords.len(), self.normals.len()];
        for word in words(rest) {
            match corner(word, there) {
                Ok(corner) => self.corners.push(corner),
                Err(why) => {
                    self.corners.truncate(start);
                    return notes.add(line, || why, LEFT_OUT);
                }
            }
        }
        if self.corners.len() - start < 3 {
            let count = self.corners.len() - start;
            self.corners.truncate(start);
            return notes.add(
                line,
                || format!("a face of {count} corners"),
                "faces of less than three corners are left out",
            );
        }
        self.faces.push((line, self.corners.len()));
    }

    /// Leaves out the faces whose corners do not exist.
    fn drop_bad_faces(&mut self, notes: &mut Notes) {
        let there = [self.positions.len(), self.tex_coords.len(), self.normals.len()];
        let mut start = 0;
        for (line, end) in &mut self.faces {
            let corners = &self.corners[start..*end];
            start = *end;
            let missing = corners.iter().flat_map(|corner| (0..3).map(|i| (i, corner[i] as usize)));
            let missing = missing.into_iter().find(|&(i, index)| index > there[i]);
            if let Some((i, index)) = missing {
                notes.add(*line, || beyond(i, index as i64, there[i]), LEFT_OUT);
                *line = 0;
            } else if corners.iter().any(|c| self.positions[c[0] as usize - 1].is_none()) {
                *line = 0;
            }
        }
    }

    /// The faces that are kept, with their numbers.
    fn kept(&self) -> impl Iterator<Item = (usize, &[Corner])> {
        let starts = std::iter::once(0).chain(self.faces.iter().map(|&(_, end)| end));
        let faces = self.faces.iter().zip(starts).enumerate();
        faces.filter(|(_, ((line, _), _))| *line != 0).map(|(f, (&(_, end), start))| (f, &self.corners[start..end]))
    }

    fn at(&self, corner: Corner) -> [f64; 3] {
        self.positions[corner[0] as usize - 1].unwrap_or_default()
    }

    /// The middle of what is drawn if f32 would not keep the shape there, else (0, 0, 0).
    fn offset(&self) -> [f64; 3] {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &corner in self.kept().flat_map(|(_, corners)| corners) {
            for (i, c) in self.at(corner).into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(c), high[i].max(c));
            }
        }
        let middle: [f64; 3] = std::array::from_fn(|i| (low[i] + high[i]) / 2.0);
        let size = (0..3).map(|i| (high[i] - low[i]) / 2.0).fold(0.0, f64::max);
        if middle.iter().any(|c| c.abs() > FAR * size) { middle } else { [0.0; 3] }
    }

    /// The plain form. `material` finds materials by their names.
    pub fn plain(mut self, notes: &mut Notes, material: impl Fn(&str) -> Option<usize>) -> Checked {
        self.drop_bad_faces(notes);
        let mut out = Checked { offset: self.offset(), has_colors: !self.colors.is_empty(), ..Checked::default() };
        let used = |part: usize| self.kept().flat_map(|(_, corners)| corners).map(move |corner| corner[part]);
        out.has_tex_coords = used(1).any(|index| index != 0);
        let has_normals = used(2).any(|index| index != 0);
        out.text = String::with_capacity(self.positions.len() * 40 + self.corners.len() * 24);
        self.write_vertices(&mut out, notes);

        let mut changes = self.changes.iter().peekable();
        let mut cutter = Cutter::default();
        let mut polygon = Vec::new();
        let (mut written, mut name, mut drawn, mut asked) = (0, 0, usize::MAX, None);
        out.names.push(String::new());
        for (f, corners) in self.kept() {
            while let Some((_, change)) = changes.next_if(|(at, _)| *at <= f) {
                match change {
                    Change::Name(new) => {
                        name = out.names.len();
                        out.names.push(new.clone());
                    }
                    Change::Material(new) => {
                        asked = material(new);
                        if asked.is_none() && !new.is_empty() {
                            let what = || format!("the material `{}` is not in any file", short(new));
                            notes.add(self.faces[f].0, what, "the faces from here on have none");
                        }
                    }
                    Change::Smoothing(smoothing) => out.smoothing.push((written, *smoothing)),
                }
            }
            let number = asked.map_or(0, |m| m + 1);
            if number != drawn {
                drawn = number;
                let _ = writeln!(out.text, "g {name}\nusemtl {number}");
            }
            polygon.clear();
            polygon.extend(corners.iter().map(|&corner| self.at(corner)));
            if !cutter.cut(&polygon) {
                let what = || format!("a face of {} corners with notches", corners.len());
                notes.add(self.faces[f].0, what, "so large a face is drawn without them");
            }
            for triangle in &cutter.triangles {
                out.text.push('f');
                for &i in triangle {
                    let [v, vt, vn] = corners[i as usize];
                    let or_default = |index: u32, count: usize| if index == 0 { count + 1 } else { index as usize };
                    let _ = write!(out.text, " {v}");
                    if out.has_tex_coords {
                        let _ = write!(out.text, "/{}", or_default(vt, self.tex_coords.len()));
                    }
                    if has_normals {
                        let slashes = if out.has_tex_coords { "/" } else { "//" };
                        let _ = write!(out.text, "{slashes}{}", or_default(vn, self.normals.len()));
                    }
                }
                out.text.push('\n');
                written += 1;
            }
        }
        out
    }

    /// Writes positions with their colours, texture coordinates and normals, and after those of the file one for the
    /// corners that have none.
    fn write_vertices(&self, out: &mut Checked, notes: &mut Notes) {
        let most = self.colors.as_flattened().iter().copied().fold(0.0, f64::max);
        let scale = if most > BRIGHTEST { 1.0 / 255.0 } else { 1.0 };
        if most > BRIGHTEST {
            notes.add(0, || format!("colours of vertices go up to {most}"), "they are taken as 0 to 255");
        }
        for (i, position) in self.positions.iter().enumerate() {
            let position = position.unwrap_or(out.offset);
            let [x, y, z]: [f32; 3] = std::array::from_fn(|i| (position[i] - out.offset[i]) as f32);
            let _ = write!(out.text, "v {x} {y} {z}");
            if let Some(color) = self.colors.get(i) {
                let [r, g, b] = color.map(|c| crate::num::clamp01((c * scale) as f32));
                let _ = write!(out.text, " {r} {g} {b}");
            }
            out.text.push('\n');
        }
        for [u, v] in self.tex_coords.iter().chain([&[0.0; 2]]) {
            let _ = writeln!(out.text, "vt {} {}", *u as f32, *v as f32);
        }
        for [x, y, z] in self.normals.iter().chain([&[0.0; 3]]) {
            let _ = writeln!(out.text, "vn {} {} {}", *x as f32, *y as f32, *z as f32);
        }
    }
}

const LEFT_OUT: &str = "the face is left out";

/// A corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`; negative indices count back from what is there.
fn corner(word: &str, there: [usize; 3]) -> Result<Corner, String> {
    let wrong = || format!("`{}` is not a corner of a face", short(word));
    let mut corner = [0; 3];
    let mut parts = word.split('/');
    for (i, part) in parts.by_ref().take(3).enumerate() {
        if part.is_empty() {
            continue;
        }
        let index: i64 = part.parse().map_err(|_| wrong())?;
        if index == 0 {
            return Err(format!("`{}` has the index 0; OBJ counts from 1", short(word)));
        }
        let absolute =
            if index > 0 { Some(index) } else { (there[i] as i64 + 1).checked_add(index).filter(|i| *i > 0) };
        corner[i] = match absolute.map(u32::try_from) {
            Some(Ok(absolute)) => absolute,
            _ => return Err(beyond(i, index, there[i])),
        };
    }
    if corner[0] == 0 || parts.next().is_some() { Err(wrong()) } else { Ok(corner) }
}

fn beyond(part: usize, index: i64, there: usize) -> String {
    let before = if index < 0 { " before it" } else { "" };
    format!("a face refers to {} {index}, but there are {there}{before}", PARTS[part])
}
