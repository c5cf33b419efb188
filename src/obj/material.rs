//! Materials of an OBJ file (MTL): colours for `glMaterial` and the image of `map_Kd`.

use crate::context::Context;
use crate::enums::*;
use std::path::PathBuf;

/// A material. What the file does not say has GL's initial value.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// Its name.
    pub name: String,
    /// `Ka`, with the opacity.
    pub ambient: [f32; 4],
    /// `Kd`, with the opacity (`d`, or 1 - `Tr`). Below 1 it means blending, which is the program's to switch on.
    pub diffuse: [f32; 4],
    /// `Ks`, with the opacity.
    pub specular: [f32; 4],
    /// `Ke`, with the opacity.
    pub emission: [f32; 4],
    /// `Ns`, limited to GL's 128.
    pub shininess: f32,
    /// The file of `map_Kd`: where it was found, or else where it should be, relative to the material's file.
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
            emission: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            texture: None,
        }
    }
}

impl Material {
    /// The material that `tobj` has read from a checked file.
    pub(super) fn new(name: String, read: &tobj::Material, texture: Option<PathBuf>) -> Self {
        let alpha = crate::num::clamp01(read.dissolve.unwrap_or(1.0));
        let color = |color: Option<[f32; 3]>, initial: f32| {
            let [r, g, b] = color.unwrap_or([initial; 3]).map(crate::num::clamp01);
            [r, g, b, alpha]
        };
        Self {
            name,
            ambient: color(read.ambient, 0.2),
            diffuse: color(read.diffuse, 0.8),
            specular: color(read.specular, 0.0),
            emission: color(read.emissive, 0.0),
            shininess: crate::num::clamp_f32(read.shininess.unwrap_or(0.0), 0.0, 128.0),
            texture,
        }
    }

    /// Sets the material of both faces: ambient, diffuse, specular and emitted colour, shininess.
    #[track_caller]
    pub fn apply(&self, cx: &mut Context) {
        cx.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &self.ambient);
        cx.materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &self.diffuse);
        cx.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &self.specular);
        cx.materialfv(GL_FRONT_AND_BACK, GL_EMISSION, &self.emission);
        cx.materialf(GL_FRONT_AND_BACK, GL_SHININESS, self.shininess);
    }

    /// Whether a highlight has no edge: any specular colour with `Ns` 0, which lights all of a lit surface alike.
    pub(super) fn shines_everywhere(&self) -> bool {
        self.shininess == 0.0 && self.specular[..3].iter().any(|&c| c > 0.1)
    }
}
