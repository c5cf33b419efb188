//! Materials of an OBJ file (MTL): colours for `glMaterial` and the image of `map_Kd`.

use crate::context::Context;
use crate::enums::*;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A material. What the file does not say has GL's initial value.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// Its name.
    pub name: String,
    /// `Ka`, with the opacity.
    pub ambient: [f32; 4],
    /// `Kd`, with the opacity.
    pub diffuse: [f32; 4],
    /// `Ks`, with the opacity.
    pub specular: [f32; 4],
    /// `Ns`, limited to GL's 128.
    pub shininess: f32,
    /// The file of `map_Kd`, relative to where the material's file is.
    pub texture: Option<PathBuf>,
}

impl Default for Material {
    /// GL's initial material, without a name or a texture.
    fn default() -> Self {
        Self {
            name: String::new(),
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            texture: None,
        }
    }
}

impl Material {
    pub(super) fn new(material: &tobj::Material, folder: &Path) -> Self {
        let alpha = crate::num::clamp01(material.dissolve.unwrap_or(1.0));
        let color = |color: Option<[f32; 3]>, initial: f32| {
            let [r, g, b] = color.unwrap_or([initial; 3]).map(crate::num::clamp01);
            [r, g, b, alpha]
        };
        Self {
            name: material.name.clone(),
            ambient: color(material.ambient, 0.2),
            diffuse: color(material.diffuse, 0.8),
            specular: color(material.specular, 0.0),
            shininess: crate::num::clamp_f32(material.shininess.unwrap_or(0.0), 0.0, 128.0),
            texture: material.diffuse_texture.as_deref().and_then(file_of_map).map(|file| folder.join(file)),
        }
    }

    /// Sets the material of both faces: ambient, diffuse and specular colour, shininess.
    #[track_caller]
    pub fn apply(&self, cx: &mut Context) {
        cx.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &self.ambient);
        cx.materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &self.diffuse);
        cx.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &self.specular);
        cx.materialf(GL_FRONT_AND_BACK, GL_SHININESS, self.shininess);
    }
}

/// The file name of a texture statement: what follows the options. A backslash separates folders, as it does where such
/// files are written.
pub(super) fn file_of_map(statement: &str) -> Option<PathBuf> {
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
    (!rest.is_empty()).then(|| PathBuf::from(rest.replace('\\', "/")))
}

/// The first word and what follows it.
fn word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    text.split_once(char::is_whitespace).map_or((text, ""), |(word, rest)| (word, rest.trim_start()))
}

/// What the material files of a model hold.
#[derive(Default)]
pub(super) struct Library {
    /// Where the file of each material is.
    pub homes: HashMap<String, PathBuf>,
    /// Files that could not be read.
    pub notes: Vec<String>,
}

impl Library {
    /// Reads what a `mtllib` line names: one file with blanks in its name, or several files.
    pub fn load(&mut self, folder: &Path, names: &Path) -> tobj::MTLLoadResult {
        let line = names.to_string_lossy().replace('\\', "/");
        let whole = folder.join(&line);
        let files = if whole.is_file() { vec![line.as_str()] } else { line.split_whitespace().collect() };
        let mut all: tobj::MTLLoadResult = Ok(Default::default());
        for file in files {
            let path = folder.join(file);
            match (read(&path), &mut all) {
                (Ok(materials), Ok((list, places))) => {
                    for material in materials {
                        let home = path.parent().unwrap_or(folder).to_path_buf();
                        self.homes.insert(material.name.clone(), home);
                        places.insert(material.name.clone(), list.len());
                        list.push(material);
                    }
                }
                (Err(why), _) => self.notes.push(format!("{}: {why}; its materials are left out", path.display())),
                _ => {}
            }
        }
        all
    }
}

/// Reads a material file.
fn read(path: &Path) -> Result<Vec<tobj::Material>, String> {
    let bytes = std::fs::read(path).map_err(|e| format!("cannot be read: {e}"))?;
    let text = String::from_utf8_lossy(&bytes);
    tobj::load_mtl_buf(&mut text.as_bytes()).map(|(materials, _)| materials).map_err(|e| e.to_string())
}
