//! Texture unit and texture object parameters (OpenGL 1.5, sections 3.8.4 to 3.8.13 and 2.11.4, tables 6.15 to 6.19).
//! A unit holds its enables, the names bound to its targets, its environment and its coordinate generation; what belongs
//! to a texture object ([`TexParameters`]) is stored with the object.

use super::compare::CompareFunc;
use super::per_unit::PerUnit;
use crate::enums::*;
use crate::limits::MAX_TEXTURE_UNITS;

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

    /// The enumerant.
    #[must_use]
    pub const fn gl(self) -> GLenum {
        match self {
            Self::D1 => GL_TEXTURE_1D,
            Self::D2 => GL_TEXTURE_2D,
            Self::Rectangle => GL_TEXTURE_RECTANGLE_ARB,
            Self::D3 => GL_TEXTURE_3D,
            Self::Cube => GL_TEXTURE_CUBE_MAP,
        }
    }
}

gl_enum! {
    /// What a coordinate beyond the image reads (section 3.8.7). What sampling does for a mode is its row in
    /// `texture::wrap`.
    pub enum WrapMode {
        Repeat = GL_REPEAT,
        Clamp = GL_CLAMP,
        ClampToEdge = GL_CLAMP_TO_EDGE,
        ClampToBorder = GL_CLAMP_TO_BORDER,
        MirroredRepeat = GL_MIRRORED_REPEAT,
        MirrorClamp = GL_MIRROR_CLAMP_EXT,
        MirrorClampToEdge = GL_MIRROR_CLAMP_TO_EDGE_EXT,
        MirrorClampToBorder = GL_MIRROR_CLAMP_TO_BORDER_EXT,
    }
}

gl_enum! {
    /// How texels become a colour: all are minification filters, the first two are also magnification filters.
    pub enum TextureFilter {
        Nearest = GL_NEAREST,
        Linear = GL_LINEAR,
        NearestMipmapNearest = GL_NEAREST_MIPMAP_NEAREST,
        LinearMipmapNearest = GL_LINEAR_MIPMAP_NEAREST,
        NearestMipmapLinear = GL_NEAREST_MIPMAP_LINEAR,
        LinearMipmapLinear = GL_LINEAR_MIPMAP_LINEAR,
    }
}

impl TextureFilter {
    /// Whether it is linear within a level.
    #[must_use]
    pub const fn is_linear(self) -> bool {
        match self {
            Self::Linear | Self::LinearMipmapNearest | Self::LinearMipmapLinear => true,
            Self::Nearest | Self::NearestMipmapNearest | Self::NearestMipmapLinear => false,
        }
    }

    /// Whether it reads mipmaps.
    #[must_use]
    pub const fn has_mipmaps(self) -> bool {
        match self {
            Self::Nearest | Self::Linear => false,
            Self::NearestMipmapNearest
            | Self::LinearMipmapNearest
            | Self::NearestMipmapLinear
            | Self::LinearMipmapLinear => true,
        }
    }

    /// Whether it blends two levels.
    #[must_use]
    pub const fn blends_levels(self) -> bool {
        match self {
            Self::NearestMipmapLinear | Self::LinearMipmapLinear => true,
            Self::Nearest | Self::Linear | Self::NearestMipmapNearest | Self::LinearMipmapNearest => false,
        }
    }
}

gl_enum! {
    /// What a depth texture is read as (section 3.8.14).
    pub enum DepthTextureMode {
        Luminance = GL_LUMINANCE,
        Intensity = GL_INTENSITY,
        Alpha = GL_ALPHA,
    }
}

gl_enum! {
    /// Whether the depths of a texture are compared with r (section 3.8.14).
    pub enum TextureCompareMode {
        None = GL_NONE,
        CompareRToTexture = GL_COMPARE_R_TO_TEXTURE,
    }
}

gl_enum! {
    /// A texture environment (section 3.8.13). What a mode does is its arm in `texture::env::combine`.
    pub enum EnvMode {
        Modulate = GL_MODULATE,
        Replace = GL_REPLACE,
        Decal = GL_DECAL,
        Blend = GL_BLEND,
        Add = GL_ADD,
        Combine = GL_COMBINE,
        /// `GL_COMBINE` whose sums are sums of products, of four arguments
        Combine4 = GL_COMBINE4_NV,
    }
}

gl_enum! {
    /// A function of `GL_COMBINE_RGB` and `GL_COMBINE_ALPHA` on arguments a0, a1, a2 (table 3.23).
    pub enum CombineFunction {
        /// a0
        Replace = GL_REPLACE,
        /// a0 a1
        Modulate = GL_MODULATE,
        /// a0 + a1
        Add = GL_ADD,
        /// a0 + a1 - 1/2
        AddSigned = GL_ADD_SIGNED,
        /// a0 a2 + a1 (1 - a2)
        Interpolate = GL_INTERPOLATE,
        /// a0 - a1
        Subtract = GL_SUBTRACT,
        /// 4 times the dot product of a0 - 1/2 and a1 - 1/2, to R, G and B
        Dot3Rgb = GL_DOT3_RGB,
        /// The same, to alpha too
        Dot3Rgba = GL_DOT3_RGBA,
        /// As `Dot3Rgb`, never scaled
        Dot3RgbExt = GL_DOT3_RGB_EXT,
        /// As `Dot3Rgba`, never scaled
        Dot3RgbaExt = GL_DOT3_RGBA_EXT,
    }
}

impl CombineFunction {
    /// How many arguments it has.
    #[must_use]
    pub const fn arity(self) -> usize {
        match self {
            Self::Replace => 1,
            Self::Interpolate => 3,
            Self::Modulate
            | Self::Add
            | Self::AddSigned
            | Self::Subtract
            | Self::Dot3Rgb
            | Self::Dot3Rgba
            | Self::Dot3RgbExt
            | Self::Dot3RgbaExt => 2,
        }
    }

    /// Whether it is a dot product, and so a function of the colour half only.
    #[must_use]
    pub const fn is_dot(self) -> bool {
        match self {
            Self::Dot3Rgb | Self::Dot3Rgba | Self::Dot3RgbExt | Self::Dot3RgbaExt => true,
            Self::Replace | Self::Modulate | Self::Add | Self::AddSigned | Self::Interpolate | Self::Subtract => false,
        }
    }

    /// Whether it gives alpha, too.
    #[must_use]
    pub const fn gives_alpha(self) -> bool {
        matches!(self, Self::Dot3Rgba | Self::Dot3RgbaExt)
    }
}

gl_enum! {
    /// How an argument of `GL_COMBINE` reads its source (table 3.25).
    pub enum CombineOperand {
        /// The colour, for the alpha half alpha.
        SrcColor = GL_SRC_COLOR,
        /// 1 less the colour.
        OneMinusSrcColor = GL_ONE_MINUS_SRC_COLOR,
        /// Alpha.
        SrcAlpha = GL_SRC_ALPHA,
        /// 1 less alpha.
        OneMinusSrcAlpha = GL_ONE_MINUS_SRC_ALPHA,
    }
}

impl CombineOperand {
    /// Whether it reads alpha alone, as the alpha half does.
    #[must_use]
    pub const fn is_alpha(self) -> bool {
        match self {
            Self::SrcAlpha | Self::OneMinusSrcAlpha => true,
            Self::SrcColor | Self::OneMinusSrcColor => false,
        }
    }
}

/// What an argument of `GL_COMBINE` reads (table 3.25).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CombineSource {
    /// The texel of the unit itself.
    Texture,
    /// The texel of a unit by its number.
    Unit(usize),
    /// The environment colour.
    Constant,
    /// The colour of the fragment.
    PrimaryColor,
    /// The result of the unit before.
    Previous,
    /// 0 (NV_texture_env_combine4).
    Zero,
}

impl CombineSource {
    /// The source that an enumerant stands for, if it stands for one.
    #[must_use]
    pub const fn from_gl(value: GLenum) -> Option<Self> {
        Some(match value {
            GL_TEXTURE => Self::Texture,
            GL_CONSTANT => Self::Constant,
            GL_PRIMARY_COLOR => Self::PrimaryColor,
            GL_PREVIOUS => Self::Previous,
            GL_ZERO => Self::Zero,
            _ => {
                let unit = value.wrapping_sub(GL_TEXTURE0) as usize;
                if unit >= MAX_TEXTURE_UNITS {
                    return None;
                }
                Self::Unit(unit)
            }
        })
    }

    /// The enumerant.
    #[must_use]
    pub const fn gl(self) -> GLenum {
        match self {
            Self::Texture => GL_TEXTURE,
            Self::Unit(unit) => GL_TEXTURE0 + unit as GLenum,
            Self::Constant => GL_CONSTANT,
            Self::PrimaryColor => GL_PRIMARY_COLOR,
            Self::Previous => GL_PREVIOUS,
            Self::Zero => GL_ZERO,
        }
    }
}

gl_enum! {
    /// How a texture coordinate is generated (section 2.11.4).
    pub enum TexGenMode {
        EyeLinear = GL_EYE_LINEAR,
        ObjectLinear = GL_OBJECT_LINEAR,
        SphereMap = GL_SPHERE_MAP,
        ReflectionMap = GL_REFLECTION_MAP,
        NormalMap = GL_NORMAL_MAP,
    }
}

impl TexGenMode {
    /// How many of s, t, r, q it can generate.
    #[must_use]
    pub const fn coordinates(self) -> usize {
        match self {
            Self::EyeLinear | Self::ObjectLinear => 4,
            Self::ReflectionMap | Self::NormalMap => 3,
            Self::SphereMap => 2,
        }
    }
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
                mode: TexGenMode::EyeLinear,
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
    pub mode: EnvMode,
    /// Environment colour.
    pub color: [f32; 4],
    /// LOD bias of the unit.
    pub lod_bias: f32,
    /// Whether point sprites replace the unit's coordinates (ARB_point_sprite).
    pub coord_replace: bool,
    /// Combine functions for RGB and alpha.
    pub combine: [CombineFunction; 2],
    /// Sources 0..3 for RGB and alpha: `source[i][0]` is `GL_SOURCEi_RGB`. The last is one of `GL_COMBINE4_NV` only.
    pub source: [[CombineSource; 2]; 4],
    /// Operands 0..3 for RGB and alpha.
    pub operand: [[CombineOperand; 2]; 4],
    /// Scale factors 1, 2 or 4 for RGB and alpha.
    pub scale: [f32; 2],
}

impl Default for Env {
    fn default() -> Self {
        Self {
            mode: EnvMode::Modulate,
            color: [0.0; 4],
            lod_bias: 0.0,
            coord_replace: false,
            combine: [CombineFunction::Modulate; 2],
            source: [
                [CombineSource::Texture; 2],
                [CombineSource::Previous; 2],
                [CombineSource::Constant; 2],
                [CombineSource::Zero; 2],
            ],
            operand: [
                [CombineOperand::SrcColor, CombineOperand::SrcAlpha],
                [CombineOperand::SrcColor, CombineOperand::SrcAlpha],
                [CombineOperand::SrcAlpha; 2],
                [CombineOperand::OneMinusSrcColor, CombineOperand::OneMinusSrcAlpha],
            ],
            scale: [1.0; 2],
        }
    }
}

/// Generation of one texture coordinate (section 2.11.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gen {
    /// `GL_TEXTURE_GEN_S` and its siblings.
    pub enabled: bool,
    /// How it is generated.
    pub mode: TexGenMode,
    /// Plane of object linear.
    pub object_plane: [f64; 4],
    /// Plane of eye linear, already times the inverse modelview of when it was given.
    pub eye_plane: [f64; 4],
}

/// The parameters of a texture object (table 6.16).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexParameters {
    /// Wraps of s, t, r.
    pub wrap: [WrapMode; 3],
    /// Minification filter.
    pub min_filter: TextureFilter,
    /// Magnification filter.
    pub mag_filter: TextureFilter,
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
    /// What a depth texture is read as.
    pub depth_mode: DepthTextureMode,
    /// Whether depths are compared with r.
    pub compare_mode: TextureCompareMode,
    /// Comparison function.
    pub compare_func: CompareFunc,
    /// `GL_GENERATE_MIPMAP`.
    pub generate_mipmap: bool,
}

impl Default for TexParameters {
    fn default() -> Self {
        Self {
            wrap: [WrapMode::Repeat; 3],
            min_filter: TextureFilter::NearestMipmapLinear,
            mag_filter: TextureFilter::Linear,
            border_color: [0.0; 4],
            priority: 1.0,
            min_lod: -1000.0,
            max_lod: 1000.0,
            base_level: 0,
            max_level: 1000,
            lod_bias: 0.0,
            max_anisotropy: 1.0,
            depth_mode: DepthTextureMode::Luminance,
            compare_mode: TextureCompareMode::None,
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
                Self { wrap: [WrapMode::ClampToEdge; 3], min_filter: TextureFilter::Linear, ..Self::default() }
            }
            Target::D1 | Target::D2 | Target::D3 | Target::Cube => Self::default(),
        }
    }
}
