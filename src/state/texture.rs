//! Texture unit and texture object parameters (OpenGL 1.5, sections 3.8.4 to 3.8.13 and 2.11.4, tables 6.15 to 6.19).
//! A unit holds its enables, the names bound to its targets, its environment and its coordinate generation; what belongs
//! to a texture object ([`TexParameters`]) is stored with the object.

use super::PerUnit;
use super::compare::CompareFunc;
use crate::enums::{
    GL_CONSTANT, GL_EYE_LINEAR, GL_LINEAR, GL_LUMINANCE, GL_MODULATE, GL_NEAREST_MIPMAP_LINEAR, GL_NONE, GL_PREVIOUS,
    GL_REPEAT, GL_SRC_ALPHA, GL_SRC_COLOR, GL_TEXTURE, GLenum,
};

/// Texture targets in the order of ascending precedence: of several enabled targets of a unit the last one applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Target {
    /// `GL_TEXTURE_1D`.
    D1,
    /// `GL_TEXTURE_2D`.
    D2,
    /// `GL_TEXTURE_RECTANGLE_ARB`.
    Rectangle,
    /// `GL_TEXTURE_3D`.
    D3,
    /// `GL_TEXTURE_CUBE_MAP`.
    Cube,
}

impl Target {
    /// All targets, lowest precedence first.
    pub const ALL: [Self; 5] = [Self::D1, Self::D2, Self::Rectangle, Self::D3, Self::Cube];
}

/// The state of all texture units.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct TextureState {
    /// The active unit, 0-based.
    pub active: usize,
    /// The units.
    pub units: PerUnit<Unit>,
}

/// One texture unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Which targets are enabled, indexed by [`Target`].
    pub enabled: [bool; 5],
    /// Which texture name is bound to each target, indexed by [`Target`].
    pub bound: [u32; 5],
    /// The environment.
    pub env: Env,
    /// Coordinate generation of s, t, r, q.
    pub generation: [Gen; 4],
}

impl Default for Unit {
    fn default() -> Self {
        let plane = |i: usize| std::array::from_fn(|k| if k == i && i < 2 { 1.0 } else { 0.0 });
        Self {
            enabled: [false; 5],
            bound: [0; 5],
            env: Env::default(),
            generation: std::array::from_fn(|i| Gen {
                enabled: false,
                mode: GL_EYE_LINEAR,
                object_plane: plane(i),
                eye_plane: plane(i),
            }),
        }
    }
}

/// Texture environment (section 3.8.13).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Env {
    /// Environment mode.
    pub mode: GLenum,
    /// Environment colour.
    pub color: [f32; 4],
    /// LOD bias of the unit.
    pub lod_bias: f32,
    /// Combine functions for RGB and alpha.
    pub combine: [GLenum; 2],
    /// Sources 0..2 for RGB and alpha: `source[i][0]` is `GL_SOURCEi_RGB`.
    pub source: [[GLenum; 2]; 3],
    /// Operands 0..2 for RGB and alpha.
    pub operand: [[GLenum; 2]; 3],
    /// Scale factors 1, 2 or 4 for RGB and alpha.
    pub scale: [f32; 2],
}

impl Default for Env {
    fn default() -> Self {
        Self {
            mode: GL_MODULATE,
            color: [0.0; 4],
            lod_bias: 0.0,
            combine: [GL_MODULATE; 2],
            source: [[GL_TEXTURE; 2], [GL_PREVIOUS; 2], [GL_CONSTANT; 2]],
            operand: [[GL_SRC_COLOR, GL_SRC_ALPHA], [GL_SRC_COLOR, GL_SRC_ALPHA], [GL_SRC_ALPHA; 2]],
            scale: [1.0; 2],
        }
    }
}

/// Generation of one texture coordinate (section 2.11.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gen {
    /// `GL_TEXTURE_GEN_S` and its siblings.
    pub enabled: bool,
    /// Object linear, eye linear, sphere map, reflection map, normal map.
    pub mode: GLenum,
    /// Plane of object linear.
    pub object_plane: [f64; 4],
    /// Plane of eye linear, already times the inverse modelview of when it was given.
    pub eye_plane: [f64; 4],
}

/// The parameters of a texture object (table 6.16).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexParameters {
    /// Wraps of s, t, r.
    pub wrap: [GLenum; 3],
    /// Minification filter.
    pub min_filter: GLenum,
    /// Magnification filter.
    pub mag_filter: GLenum,
    /// Border colour, as given for float formats, clamped to [0, 1] when sampled otherwise.
    pub border_color: [f32; 4],
    /// Priority in [0, 1].
    pub priority: f32,
    /// Least LOD.
    pub min_lod: f32,
    /// Greatest LOD.
    pub max_lod: f32,
    /// Base level.
    pub base_level: i32,
    /// Last level.
    pub max_level: i32,
    /// LOD bias of the object (EXT_texture_lod_bias in GL 1.4's form).
    pub lod_bias: f32,
    /// Greatest degree of anisotropy, at least 1.
    pub max_anisotropy: f32,
    /// What a depth texture is read as: luminance, intensity or alpha.
    pub depth_mode: GLenum,
    /// `GL_NONE` or `GL_COMPARE_R_TO_TEXTURE`.
    pub compare_mode: GLenum,
    /// Comparison function.
    pub compare_func: CompareFunc,
    /// `GL_GENERATE_MIPMAP`.
    pub generate_mipmap: bool,
}

impl Default for TexParameters {
    fn default() -> Self {
        Self {
            wrap: [GL_REPEAT; 3],
            min_filter: GL_NEAREST_MIPMAP_LINEAR,
            mag_filter: GL_LINEAR,
            border_color: [0.0; 4],
            priority: 1.0,
            min_lod: -1000.0,
            max_lod: 1000.0,
            base_level: 0,
            max_level: 1000,
            lod_bias: 0.0,
            max_anisotropy: 1.0,
            depth_mode: GL_LUMINANCE,
            compare_mode: GL_NONE,
            compare_func: CompareFunc::Lequal,
            generate_mipmap: false,
        }
    }
}

impl TexParameters {
    /// The initial parameters of an object of this target: a rectangle texture has no mipmaps and does not repeat.
    #[must_use]
    pub fn for_target(target: Target) -> Self {
        match target {
            Target::Rectangle => {
                Self { wrap: [crate::enums::GL_CLAMP_TO_EDGE; 3], min_filter: GL_LINEAR, ..Self::default() }
            }
            _ => Self::default(),
        }
    }
}
