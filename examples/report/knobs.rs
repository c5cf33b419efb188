//! The configurations: what GL lets a program turn. A configuration is applied to a scene's state, so the oracle and every
//! GL are given the same; only accumulation is more than state: the picture is drawn several times, moved by fractions of
//! a pixel, and averaged by Accum.

use super::gl::Gl;
use super::oracle::scene::Scene;
use super::patterns::{Kernel, pyramid};
use super::scenes::Depth;
use super::translate::{picture, projection};
use fixedgl::enums::*;

/// One setting of all knobs.
#[derive(Clone, Debug, PartialEq)]
pub struct Knobs {
    /// Its name in the tables.
    pub name: &'static str,
    /// Minification and magnification.
    pub min: GLenum,
    pub mag: GLenum,
    /// TEXTURE_MAX_ANISOTROPY.
    pub anisotropy: u32,
    /// TEXTURE_LOD_BIAS.
    pub bias: f64,
    /// What the levels are made with.
    pub kernel: Kernel,
    /// How many pictures are accumulated.
    pub frames: u32,
}

const DEFAULT: Knobs = Knobs {
    name: "trilinear",
    min: GL_LINEAR_MIPMAP_LINEAR,
    mag: GL_LINEAR,
    anisotropy: 1,
    bias: 0.0,
    kernel: Kernel::Box,
    frames: 1,
};

/// The settings of a scene; the first is the default.
pub fn settings(depth: Depth, quick: bool) -> Vec<Knobs> {
    let filter = |name, min, mag| Knobs { name, min, mag, ..DEFAULT };
    let short =
        [DEFAULT, filter("LINEAR", GL_LINEAR, GL_LINEAR), Knobs { name: "anisotropic 8", anisotropy: 8, ..DEFAULT }];
    let medium = [
        filter("NEAREST", GL_NEAREST, GL_NEAREST),
        filter("LINEAR_MIPMAP_NEAREST", GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR),
        Knobs { name: "4 accumulated", frames: 4, ..DEFAULT },
    ];
    let full = [
        filter("NEAREST_MIPMAP_NEAREST", GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST),
        filter("NEAREST_MIPMAP_LINEAR", GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST),
        Knobs { name: "anisotropic 2", anisotropy: 2, ..DEFAULT },
        Knobs { name: "anisotropic 4", anisotropy: 4, ..DEFAULT },
        Knobs { name: "anisotropic 16", anisotropy: 16, ..DEFAULT },
        Knobs { name: "trilinear, bias -0.5", bias: -0.5, ..DEFAULT },
        Knobs { name: "trilinear, bias +0.5", bias: 0.5, ..DEFAULT },
        Knobs { name: "16 accumulated", frames: 16, ..DEFAULT },
        Knobs { name: "4 accumulated, bias -1", frames: 4, bias: -1.0, ..DEFAULT },
        Knobs { name: "trilinear, Lanczos levels", kernel: Kernel::Lanczos, ..DEFAULT },
        Knobs { name: "anisotropic 8, Lanczos levels", anisotropy: 8, kernel: Kernel::Lanczos, ..DEFAULT },
    ];
    let mut settings = short.to_vec();
    if depth != Depth::Short && !quick {
        settings.extend(medium);
    }
    if depth == Depth::Full && !quick {
        settings.extend(full);
    }
    settings
}

impl Knobs {
    /// Whether a texel is taken as it is, so that a coordinate next to a boundary of texels may fall to either side.
    pub fn takes_nearest(&self) -> bool {
        self.mag == GL_NEAREST
    }

    /// The scene with this setting.
    pub fn apply(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        for texture in scene.units.iter_mut().filter_map(|unit| unit.texture.as_mut()) {
            texture.lod.min_filter = self.min;
            texture.lod.mag_filter = self.mag;
            texture.lod.anisotropy = f64::from(self.anisotropy);
            texture.lod.object_bias = self.bias;
            if self.kernel != Kernel::Box {
                texture.levels = pyramid(self.kernel, &texture.levels[0][0]);
            }
        }
        scene
    }

    /// Where the pictures that are accumulated are moved to, in pixels: a Hammersley sequence in [-1/2, 1/2).
    pub fn shifts(&self) -> Vec<[f64; 2]> {
        let n = self.frames;
        let shift = |i: u32| {
            let mirrored = f64::from(i.reverse_bits()) / 2f64.powi(32);
            [(f64::from(i) + 0.5) / f64::from(n) - 0.5, mirrored + 0.5 / f64::from(n) - 0.5]
        };
        (0..n).map(shift).collect()
    }

    /// Draws one whole picture into a context that is in the state of `scene`.
    pub fn draw(&self, gl: &mut dyn Gl, scene: &Scene) {
        if self.frames == 1 {
            return picture(gl);
        }
        let share = 1.0 / self.frames as f32;
        for (i, by) in self.shifts().into_iter().enumerate() {
            projection(gl, scene, by);
            picture(gl);
            gl.accum(if i == 0 { GL_LOAD } else { GL_ACCUM }, share);
        }
        gl.accum(GL_RETURN, 1.0);
    }

    /// Draws what a further picture costs: without clearing, unless it accumulates.
    pub fn draw_again(&self, gl: &mut dyn Gl, scene: &Scene) {
        if self.frames == 1 { gl.call_list(1) } else { self.draw(gl, scene) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifts_are_balanced() {
        for frames in [4, 16] {
            let shifts = Knobs { frames, ..DEFAULT }.shifts();
            for k in 0..2 {
                assert!(shifts.iter().map(|s| s[k]).sum::<f64>().abs() < 1e-12);
                let mut places: Vec<i64> =
                    shifts.iter().map(|s| ((s[k] + 0.5) * f64::from(frames)).floor() as i64).collect();
                places.sort_unstable();
                assert_eq!(places, (0..i64::from(frames)).collect::<Vec<_>>());
            }
        }
        assert_eq!(DEFAULT.shifts(), [[0.0, 0.0]]);
    }

    #[test]
    fn a_quick_run_draws_what_every_run_draws() {
        let quick = settings(Depth::Full, true);
        for depth in [Depth::Full, Depth::Medium, Depth::Short] {
            assert_eq!(settings(depth, false)[..quick.len()], quick);
        }
    }
}
