//! Internal formats of texture images (OpenGL 1.5, section 3.8.1, tables 3.15 and 3.16). One row a name: its base format,
//! how its texels are stored here, and how many bits each component really keeps. Formats of at most 8 bits a component
//! are stored as 8-bit RGBA, larger ones as floats rounded to their size, depth as floats. A generic compressed name is
//! stored uncompressed, as the specification permits, and reports its base format.

use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_value};
use crate::pixels::element::quantise;

/// The base internal formats: which components a texture has (table 3.15).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BaseFormat {
    /// A only; sampled as (0, 0, 0, A).
    Alpha,
    /// L only; sampled as (L, L, L, 1).
    Luminance,
    /// L and A; sampled as (L, L, L, A).
    LuminanceAlpha,
    /// I only; sampled as (I, I, I, I).
    Intensity,
    /// R, G, B; sampled as (R, G, B, 1).
    Rgb,
    /// All four.
    Rgba,
    /// A depth; sampled through DEPTH_TEXTURE_MODE and the comparison.
    Depth,
}

impl BaseFormat {
    /// GL's name of the base format.
    #[must_use]
    pub fn name(self) -> GLenum {
        match self {
            BaseFormat::Alpha => GL_ALPHA,
            BaseFormat::Luminance => GL_LUMINANCE,
            BaseFormat::LuminanceAlpha => GL_LUMINANCE_ALPHA,
            BaseFormat::Intensity => GL_INTENSITY,
            BaseFormat::Rgb => GL_RGB,
            BaseFormat::Rgba => GL_RGBA,
            BaseFormat::Depth => GL_DEPTH_COMPONENT,
        }
    }

    /// Takes from an RGBA colour the components that the format has (table 3.15) and expands them to what a sampler
    /// reads: luminance and intensity are R, missing colours are 0, a missing alpha is 1. Depth leaves it alone.
    #[inline]
    #[must_use]
    pub fn expand(self, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
        match self {
            BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
            BaseFormat::Luminance => [r, r, r, 1.0],
            BaseFormat::LuminanceAlpha => [r, r, r, a],
            BaseFormat::Intensity => [r; 4],
            BaseFormat::Rgb => [r, g, b, 1.0],
            BaseFormat::Rgba | BaseFormat::Depth => [r, g, b, a],
        }
    }

    /// [`BaseFormat::expand`] for a packed texel with the bytes R, G, B, A from low to high.
    #[inline]
    #[must_use]
    pub fn expand_rgba8(self, texel: u32) -> u32 {
        let red = texel & 0xFF;
        match self {
            BaseFormat::Alpha => texel & 0xFF00_0000,
            BaseFormat::Luminance => (red * 0x0001_0101) | 0xFF00_0000,
            BaseFormat::LuminanceAlpha => (red * 0x0001_0101) | (texel & 0xFF00_0000),
            BaseFormat::Intensity => red * 0x0101_0101,
            BaseFormat::Rgb => texel | 0xFF00_0000,
            BaseFormat::Rgba | BaseFormat::Depth => texel,
        }
    }
}

/// How the texels of an image are kept in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// One `u32` a texel, bytes R, G, B, A from low to high.
    Rgba8,
    /// Four floats a texel, each rounded to the bits of its component.
    Float,
    /// One float a texel in [0, 1], rounded to the bits of the depth.
    Depth,
}

impl Storage {
    /// Bytes of a texel.
    #[must_use]
    pub const fn bytes(self) -> u64 {
        match self {
            Storage::Rgba8 | Storage::Depth => 4,
            Storage::Float => 16,
        }
    }
}

/// The block formats of EXT_texture_compression_s3tc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum S3tc {
    /// DXT1 read as opaque colour.
    RgbDxt1,
    /// DXT1 with one bit of alpha.
    RgbaDxt1,
    /// DXT3: four explicit bits of alpha.
    RgbaDxt3,
    /// DXT5: interpolated alpha.
    RgbaDxt5,
}

/// How the two colours of an S3TC block are chosen for texels that are given uncompressed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BlockFit {
    /// Those of two texels.
    #[default]
    Extremes,
    /// The pair that is nearest to all texels: least squares, as long as the error becomes less.
    LeastSquares,
}

/// The sizes that GetTexLevelParameter reports (TEXTURE_RED_SIZE and so on); 0 for a component that is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComponentSizes {
    /// TEXTURE_RED_SIZE
    pub red: u8,
    /// TEXTURE_GREEN_SIZE
    pub green: u8,
    /// TEXTURE_BLUE_SIZE
    pub blue: u8,
    /// TEXTURE_ALPHA_SIZE
    pub alpha: u8,
    /// TEXTURE_LUMINANCE_SIZE
    pub luminance: u8,
    /// TEXTURE_INTENSITY_SIZE
    pub intensity: u8,
    /// TEXTURE_DEPTH_SIZE
    pub depth: u8,
}

/// One internal format: a row of the table.
#[derive(Debug, PartialEq, Eq)]
pub struct InternalFormat {
    /// The value that a program passes.
    pub requested: GLenum,
    /// The value that TEXTURE_INTERNAL_FORMAT reports (differs for generic compressed names only).
    pub reported: GLenum,
    /// Which components it has.
    pub base: BaseFormat,
    /// How its texels are kept.
    pub storage: Storage,
    /// Bits kept of each colour component, of luminance or intensity, or of depth.
    pub color_bits: u8,
    /// Bits kept of alpha, 0 where the format has none.
    pub alpha_bits: u8,
    /// Bits kept of a stencil index, 0 where the format has none.
    pub stencil_bits: u8,
    /// The block format, for compressed images.
    pub s3tc: Option<S3tc>,
}

impl InternalFormat {
    /// GL_RGBA, the format of tables and filters that nobody has specified.
    #[must_use]
    pub fn rgba() -> &'static InternalFormat {
        Self::find(GL_RGBA).unwrap_or(&FORMATS[0])
    }

    /// The row of `value`, whatever command it came from; `None` if it is no internal format.
    #[must_use]
    pub fn find(value: GLenum) -> Option<&'static InternalFormat> {
        FORMATS.iter().find(|row| row.requested == value)
    }

    /// The `internalformat` of TexImage: any row, else INVALID_VALUE (section 3.8.1).
    pub fn of_tex_image(value: i32) -> Outcome<&'static InternalFormat> {
        InternalFormat::find(value.cast_unsigned()).ok_or_else(|| {
            invalid_value(format!(
                "{} is not an internal format; pass 1 to 4, or a name such as GL_RGBA8 or GL_LUMINANCE",
                name(value.cast_unsigned())
            ))
        })
    }

    /// The `internalformat` of CopyTexImage: a named row; the counts 1 to 4 are not taken (section 3.8.2).
    pub fn of_copy_tex_image(value: GLenum) -> Outcome<&'static InternalFormat> {
        InternalFormat::find(value).filter(|row| row.requested > 4).ok_or_else(|| {
            invalid_enum(format!(
                "{} is not an internal format that CopyTexImage takes; pass a name such as GL_RGB8",
                name(value)
            ))
        })
    }

    /// The `internalformat` of CompressedTexImage: an S3TC name, else INVALID_ENUM (section 3.8.3).
    pub fn of_compressed_tex_image(value: GLenum) -> Outcome<&'static InternalFormat> {
        InternalFormat::find(value).filter(|row| row.s3tc.is_some()).ok_or_else(|| {
            invalid_enum(format!(
                "{} is not a specific compressed format; pass one of the GL_COMPRESSED_*_S3TC_DXT* names",
                name(value)
            ))
        })
    }

    /// The format that takes its place where blocks cannot be used: its base format.
    #[must_use]
    pub fn uncompressed(&'static self) -> &'static InternalFormat {
        if self.s3tc.is_none() {
            return self;
        }
        InternalFormat::find(self.base.name()).unwrap_or(self)
    }

    /// A colour (or a depth in R) rounded to the bits that the components keep here; 8-bit storage rounds by itself.
    #[inline]
    #[must_use]
    pub fn round(&self, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
        match self.storage {
            Storage::Rgba8 => [r, g, b, a],
            Storage::Float => {
                let c = self.color_bits;
                [quantise(r, c), quantise(g, c), quantise(b, c), quantise(a, self.alpha_bits)]
            }
            Storage::Depth => [quantise(r, self.color_bits), g, b, a],
        }
    }

    /// Whether TEXTURE_COMPRESSED reports true.
    #[must_use]
    pub fn is_compressed(&self) -> bool {
        self.s3tc.is_some()
    }

    /// What GetTexLevelParameter reports for the component sizes.
    #[must_use]
    pub fn sizes(&self) -> ComponentSizes {
        let none = ComponentSizes::default();
        let (color, alpha) = (self.color_bits, self.alpha_bits);
        match self.base {
            BaseFormat::Alpha => ComponentSizes { alpha, ..none },
            BaseFormat::Luminance => ComponentSizes { luminance: color, ..none },
            BaseFormat::LuminanceAlpha => ComponentSizes { luminance: color, alpha, ..none },
            BaseFormat::Intensity => ComponentSizes { intensity: color, ..none },
            BaseFormat::Rgb | BaseFormat::Rgba => {
                ComponentSizes { red: color, green: color, blue: color, alpha, ..none }
            }
            BaseFormat::Depth => ComponentSizes { depth: color, ..none },
        }
    }
}

const fn row(requested: GLenum, base: BaseFormat, storage: Storage, color_bits: u8, alpha_bits: u8) -> InternalFormat {
    InternalFormat {
        requested,
        reported: requested,
        base,
        storage,
        color_bits,
        alpha_bits,
        stencil_bits: 0,
        s3tc: None,
    }
}

const fn generic(requested: GLenum, reported: GLenum, base: BaseFormat, color: u8, alpha: u8) -> InternalFormat {
    InternalFormat { reported, ..row(requested, base, Storage::Rgba8, color, alpha) }
}

/// EXT_packed_depth_stencil: sampled as a depth texture; the stencil indices are only kept.
const fn depth_stencil(requested: GLenum) -> InternalFormat {
    InternalFormat { stencil_bits: 8, ..row(requested, BaseFormat::Depth, Storage::Depth, 24, 0) }
}

const fn block(requested: GLenum, base: BaseFormat, alpha_bits: u8, s3tc: S3tc) -> InternalFormat {
    InternalFormat { s3tc: Some(s3tc), ..row(requested, base, Storage::Rgba8, 5, alpha_bits) }
}

use BaseFormat::{Alpha, Depth, Intensity, Luminance, LuminanceAlpha, Rgb, Rgba};
use Storage::{Float, Rgba8};

/// Every internal format of OpenGL 1.0 to 1.5 and the S3TC names.
pub static FORMATS: [InternalFormat; 59] = [
    row(1, Luminance, Rgba8, 8, 0),
    row(2, LuminanceAlpha, Rgba8, 8, 8),
    row(3, Rgb, Rgba8, 8, 0),
    row(4, Rgba, Rgba8, 8, 8),
    row(GL_ALPHA, Alpha, Rgba8, 0, 8),
    row(GL_ALPHA4, Alpha, Rgba8, 0, 8),
    row(GL_ALPHA8, Alpha, Rgba8, 0, 8),
    row(GL_ALPHA12, Alpha, Float, 0, 12),
    row(GL_ALPHA16, Alpha, Float, 0, 16),
    row(GL_LUMINANCE, Luminance, Rgba8, 8, 0),
    row(GL_LUMINANCE4, Luminance, Rgba8, 8, 0),
    row(GL_LUMINANCE8, Luminance, Rgba8, 8, 0),
    row(GL_LUMINANCE12, Luminance, Float, 12, 0),
    row(GL_LUMINANCE16, Luminance, Float, 16, 0),
    row(GL_LUMINANCE_ALPHA, LuminanceAlpha, Rgba8, 8, 8),
    row(GL_LUMINANCE4_ALPHA4, LuminanceAlpha, Rgba8, 8, 8),
    row(GL_LUMINANCE6_ALPHA2, LuminanceAlpha, Rgba8, 8, 8),
    row(GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Rgba8, 8, 8),
    row(GL_LUMINANCE12_ALPHA4, LuminanceAlpha, Float, 12, 4),
    row(GL_LUMINANCE12_ALPHA12, LuminanceAlpha, Float, 12, 12),
    row(GL_LUMINANCE16_ALPHA16, LuminanceAlpha, Float, 16, 16),
    row(GL_INTENSITY, Intensity, Rgba8, 8, 0),
    row(GL_INTENSITY4, Intensity, Rgba8, 8, 0),
    row(GL_INTENSITY8, Intensity, Rgba8, 8, 0),
    row(GL_INTENSITY12, Intensity, Float, 12, 0),
    row(GL_INTENSITY16, Intensity, Float, 16, 0),
    row(GL_R3_G3_B2, Rgb, Rgba8, 8, 0),
    row(GL_RGB, Rgb, Rgba8, 8, 0),
    row(GL_RGB2_EXT, Rgb, Rgba8, 8, 0),
    row(GL_RGB4, Rgb, Rgba8, 8, 0),
    row(GL_RGB5, Rgb, Rgba8, 8, 0),
    row(GL_RGB8, Rgb, Rgba8, 8, 0),
    row(GL_RGB10, Rgb, Float, 10, 0),
    row(GL_RGB12, Rgb, Float, 12, 0),
    row(GL_RGB16, Rgb, Float, 16, 0),
    row(GL_RGBA, Rgba, Rgba8, 8, 8),
    row(GL_RGBA2, Rgba, Rgba8, 8, 8),
    row(GL_RGBA4, Rgba, Rgba8, 8, 8),
    row(GL_RGB5_A1, Rgba, Rgba8, 8, 8),
    row(GL_RGBA8, Rgba, Rgba8, 8, 8),
    row(GL_RGB10_A2, Rgba, Float, 10, 2),
    row(GL_RGBA12, Rgba, Float, 12, 12),
    row(GL_RGBA16, Rgba, Float, 16, 16),
    row(GL_DEPTH_COMPONENT, Depth, Storage::Depth, 24, 0),
    row(GL_DEPTH_COMPONENT16, Depth, Storage::Depth, 16, 0),
    row(GL_DEPTH_COMPONENT24, Depth, Storage::Depth, 24, 0),
    // A float keeps 24 bits near 1: that is what is kept and reported of 32.
    row(GL_DEPTH_COMPONENT32, Depth, Storage::Depth, 24, 0),
    depth_stencil(GL_DEPTH_STENCIL_EXT),
    depth_stencil(GL_DEPTH24_STENCIL8_EXT),
    generic(GL_COMPRESSED_ALPHA, GL_ALPHA, Alpha, 0, 8),
    generic(GL_COMPRESSED_LUMINANCE, GL_LUMINANCE, Luminance, 8, 0),
    generic(GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, LuminanceAlpha, 8, 8),
    generic(GL_COMPRESSED_INTENSITY, GL_INTENSITY, Intensity, 8, 0),
    generic(GL_COMPRESSED_RGB, GL_RGB, Rgb, 8, 0),
    generic(GL_COMPRESSED_RGBA, GL_RGBA, Rgba, 8, 8),
    block(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, Rgb, 0, S3tc::RgbDxt1),
    block(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, Rgba, 1, S3tc::RgbaDxt1),
    block(GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, Rgba, 4, S3tc::RgbaDxt3),
    block(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, Rgba, 8, S3tc::RgbaDxt5),
];
