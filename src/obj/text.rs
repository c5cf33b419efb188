//! The check of an OBJ file before it is read. Each line that matters is looked at: numbers must be finite, indices must
//! exist. What comes out is a plain form of the same model: absolute indices, two texture coordinates, corners that
//! all have the same parts, no points, lines, curves or comments.

use std::borrow::Cow;
use std::fmt::Write;

/// A checked file.
#[derive(Debug)]
pub(super) struct Checked {
    /// The model in its plain form.
    pub text: String,
    /// Whether the corners have texture coordinates; those without got (0, 0).
    pub has_tex_coords: bool,
    /// Whether every corner of the file has a normal; if one has none, all are left out.
    pub has_normals: bool,
    /// What was left out.
    pub notes: Vec<String>,
}

/// How many positions, texture coordinates and normals there are.
type ElementCounts = [usize; 3];

/// A corner as the file has it: numbers that count from 1, or back from here; 0 for a part that is not there.
type FaceCorner = [i64; 3];

const PARTS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Checks a file; the error says in which line it is and what to do.
pub(super) fn check(source: &str) -> Result<Checked, String> {
    let lines = logical_lines(source);
    let mut total: ElementCounts = [0; 3];
    let (mut any_tex_coord, mut all_tex_coords, mut all_normals) = (false, true, true);
    for (number, line) in &lines {
        let at = |message: String| format!("line {number}: {message}");
        let (keyword, rest) = keyword(line);
        match keyword {
            "v" => numbers(rest, 3).map(|_| total[0] += 1).map_err(at)?,
            "vt" => numbers(rest, 1).map(|_| total[1] += 1).map_err(at)?,
            "vn" => numbers(rest, 3).map(|_| total[2] += 1).map_err(at)?,
            "f" => {
                for corner in corners(rest).map_err(at)? {
                    any_tex_coord |= corner[1] != 0;
                    all_tex_coords &= corner[1] != 0;
                    all_normals &= corner[2] != 0;
                }
            }
            _ => {}
        }
    }
    let default_tex_coord = any_tex_coord && !all_tex_coords;
    let has_normals = all_normals && total[2] > 0;
    let mut out = String::with_capacity(source.len());
    if default_tex_coord {
        out.push_str("vt 0 0\n");
    }
    let (mut seen, mut small): (ElementCounts, usize) = ([0; 3], 0);
    for (number, line) in &lines {
        let at = |message: String| format!("line {number}: {message}");
        let (keyword, rest) = keyword(line);
        match keyword {
            "v" | "vn" => {
                seen[if keyword == "v" { 0 } else { 2 }] += 1;
                let _ = writeln!(out, "{keyword} {}", first_words(rest, 3));
            }
            "vt" => {
                seen[1] += 1;
                let v = if rest.split_whitespace().count() < 2 { " 0" } else { "" };
                let _ = writeln!(out, "vt {}{v}", first_words(rest, 2));
            }
            "f" => {
                let corners = corners(rest).map_err(at)?;
                if corners.len() < 3 {
                    small += 1;
                    continue;
                }
                out.push('f');
                for corner in corners {
                    let [v, vt, vn] = absolute(corner, seen, total).map_err(at)?;
                    let _ = write!(out, " {v}");
                    if any_tex_coord {
                        let _ = write!(out, "/{}", vt + usize::from(default_tex_coord));
                    }
                    if has_normals {
                        let _ = write!(out, "{}{vn}", if any_tex_coord { "/" } else { "//" });
                    }
                }
                out.push('\n');
            }
            "o" | "g" | "usemtl" | "mtllib" if !rest.is_empty() => {
                let _ = writeln!(out, "{keyword} {rest}");
            }
            _ => {}
        }
    }
    let mut notes = Vec::new();
    if small > 0 {
        notes.push(format!("{small} faces of less than three corners were left out"));
    }
    Ok(Checked { text: out, has_tex_coords: any_tex_coord, has_normals, notes })
}

/// The lines with their numbers, without comments, and with those that end in a backslash joined to the next.
fn logical_lines(source: &str) -> Vec<(usize, Cow<'_, str>)> {
    let mut lines: Vec<(usize, Cow<'_, str>)> = Vec::new();
    let mut open = false;
    for (i, line) in source.lines().enumerate() {
        let line = line.split_once('#').map_or(line, |(before, _)| before).trim();
        let (text, continues) = line.strip_suffix('\\').map_or((line, false), |text| (text, true));
        match lines.last_mut() {
            Some((_, last)) if open => {
                let joined = last.to_mut();
                joined.push(' ');
                joined.push_str(text);
            }
            _ => lines.push((i + 1, Cow::Borrowed(text))),
        }
        open = continues;
    }
    lines
}

fn keyword(line: &str) -> (&str, &str) {
    line.split_once(char::is_whitespace).map_or((line, ""), |(k, rest)| (k, rest.trim()))
}

fn first_words(rest: &str, n: usize) -> String {
    rest.split_whitespace().take(n).collect::<Vec<_>>().join(" ")
}

/// Checks that there are at least `least` numbers and that they are finite.
fn numbers(rest: &str, least: usize) -> Result<(), String> {
    let mut count = 0;
    for word in rest.split_whitespace() {
        match word.parse::<f32>() {
            Ok(v) if v.is_finite() => count += 1,
            Ok(_) => return Err(format!("`{word}` is not a finite number")),
            Err(_) => return Err(format!("`{word}` is not a number")),
        }
    }
    if count < least { Err(format!("{least} numbers are needed, there are {count}")) } else { Ok(()) }
}

/// The corners of a face.
fn corners(rest: &str) -> Result<Vec<FaceCorner>, String> {
    rest.split_whitespace()
        .map(|word| {
            let mut corner = [0; 3];
            let mut parts = word.split('/');
            for (place, part) in corner.iter_mut().zip(parts.by_ref()) {
                if !part.is_empty() {
                    *place = part.parse().map_err(|_| format!("`{word}` is not a corner of a face"))?;
                    if *place == 0 {
                        return Err(format!("`{word}` has the index 0; OBJ counts from 1"));
                    }
                }
            }
            if corner[0] == 0 || parts.next().is_some() {
                return Err(format!("`{word}` is not a corner of a face"));
            }
            Ok(corner)
        })
        .collect()
}

/// A corner with absolute indices, after a look whether they exist.
fn absolute(corner: FaceCorner, seen: ElementCounts, total: ElementCounts) -> Result<[usize; 3], String> {
    let mut out = [0; 3];
    for (i, index) in corner.into_iter().enumerate() {
        let there = if index < 0 { seen[i] } else { total[i] };
        out[i] = if index < 0 {
            // Relative: -1 is the last one before this line.
            usize::try_from(index.unsigned_abs()).ok().and_then(|back| (there + 1).checked_sub(back)).unwrap_or(0)
        } else {
            usize::try_from(index).unwrap_or(usize::MAX)
        };
        if index != 0 && (out[i] == 0 || out[i] > there) {
            let before = if index < 0 { " before it" } else { "" };
            return Err(format!("a face refers to {} {index}, but there are {there}{before}", PARTS[i]));
        }
    }
    Ok(out)
}
