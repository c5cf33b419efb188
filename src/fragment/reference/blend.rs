//! Blending (OpenGL 1.5, section 4.1.7). It is done in floats in the unit of the colour store: bytes are whole numbers
//! from 0 to 255, so that what is in the framebuffer needs no division, a factor of 1 or 0 is exact, and the result is
//! rounded once. With S the source's colour in that unit and D the framebuffer's:
//!
//! ```text
//!   ADD  S s + D d     SUBTRACT  S s - D d     REVERSE_SUBTRACT  D d - S s     MIN, MAX  of S and D, without factors
//! ```

use crate::enums::*;
use crate::fragment::batch::FragmentBatch;
use crate::fragment::reference::pack::whole_pixel;
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{BlendUniforms, FragFn, FragUniforms, Work};
use crate::num::{clamp_f32, clamp01, max_f32, min_f32};
use crate::simd::{LANES, stage};
use crate::texture::batch::Lanes;

/// A blending factor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Factor {
    /// 0.
    Zero,
    /// 1.
    #[default]
    One,
    /// The source's channel.
    SrcColor,
    /// 1 less the source's channel.
    OneMinusSrcColor,
    /// The framebuffer's channel.
    DstColor,
    /// 1 less the framebuffer's channel.
    OneMinusDstColor,
    /// The source's alpha.
    SrcAlpha,
    /// 1 less the source's alpha.
    OneMinusSrcAlpha,
    /// The framebuffer's alpha.
    DstAlpha,
    /// 1 less the framebuffer's alpha.
    OneMinusDstAlpha,
    /// The constant colour's channel.
    ConstantColor,
    /// 1 less the constant colour's channel.
    OneMinusConstantColor,
    /// The constant colour's alpha.
    ConstantAlpha,
    /// 1 less the constant colour's alpha.
    OneMinusConstantAlpha,
    /// For RGB the smaller of source alpha and 1 less the framebuffer's alpha, for alpha 1.
    SrcAlphaSaturate,
}

const FACTORS: [(GLenum, Factor); 15] = [
    (GL_ZERO, Factor::Zero),
    (GL_ONE, Factor::One),
    (GL_SRC_COLOR, Factor::SrcColor),
    (GL_ONE_MINUS_SRC_COLOR, Factor::OneMinusSrcColor),
    (GL_DST_COLOR, Factor::DstColor),
    (GL_ONE_MINUS_DST_COLOR, Factor::OneMinusDstColor),
    (GL_SRC_ALPHA, Factor::SrcAlpha),
    (GL_ONE_MINUS_SRC_ALPHA, Factor::OneMinusSrcAlpha),
    (GL_DST_ALPHA, Factor::DstAlpha),
    (GL_ONE_MINUS_DST_ALPHA, Factor::OneMinusDstAlpha),
    (GL_CONSTANT_COLOR, Factor::ConstantColor),
    (GL_ONE_MINUS_CONSTANT_COLOR, Factor::OneMinusConstantColor),
    (GL_CONSTANT_ALPHA, Factor::ConstantAlpha),
    (GL_ONE_MINUS_CONSTANT_ALPHA, Factor::OneMinusConstantAlpha),
    (GL_SRC_ALPHA_SATURATE, Factor::SrcAlphaSaturate),
];

impl Factor {
    /// The factor of an enumerant; ONE for what is none (the commands let no such value into the state).
    #[must_use]
    pub fn from_enum(value: GLenum) -> Self {
        FACTORS.iter().find(|row| row.0 == value).map_or(Self::One, |row| row.1)
    }
}

/// How source and framebuffer are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Equation {
    /// The sum of the products.
    #[default]
    Add,
    /// The source's product less the framebuffer's.
    Subtract,
    /// The framebuffer's product less the source's.
    ReverseSubtract,
    /// The smaller of the two colours.
    Min,
    /// The larger of the two colours.
    Max,
}

impl Equation {
    /// The equation of an enumerant; ADD for what is none (the commands let no such value into the state).
    #[must_use]
    pub fn from_enum(value: GLenum) -> Self {
        match value {
            GL_FUNC_SUBTRACT => Self::Subtract,
            GL_FUNC_REVERSE_SUBTRACT => Self::ReverseSubtract,
            GL_MIN => Self::Min,
            GL_MAX => Self::Max,
            _ => Self::Add,
        }
    }
}

/// The factor of channel `c` for all lanes.
#[inline(always)]
fn factor(f: Factor, c: usize, b: &FragmentBatch, u: &FragUniforms) -> Lanes {
    // From the store's unit to [0, 1]: 255 times the rounded 1/255 is exactly 1.
    let unit = 1.0 / u.scale;
    let (src, dst) = (&b.tex.previous, &b.dst);
    let constant = u.blend.color;
    let mut out = [0.0; LANES];
    #[inline(always)]
    fn each(out: &mut Lanes, f: impl Fn(usize) -> f32) {
        for (i, out) in out.iter_mut().enumerate() {
            *out = f(i);
        }
    }
    match f {
        Factor::Zero => {}
        Factor::One => out = [1.0; LANES],
        Factor::SrcColor => each(&mut out, |i| clamp01(src[c][i])),
        Factor::OneMinusSrcColor => each(&mut out, |i| 1.0 - clamp01(src[c][i])),
        Factor::DstColor => each(&mut out, |i| dst[c][i] * unit),
        Factor::OneMinusDstColor => each(&mut out, |i| 1.0 - dst[c][i] * unit),
        Factor::SrcAlpha => each(&mut out, |i| clamp01(src[3][i])),
        Factor::OneMinusSrcAlpha => each(&mut out, |i| 1.0 - clamp01(src[3][i])),
        Factor::DstAlpha => each(&mut out, |i| dst[3][i] * unit),
        Factor::OneMinusDstAlpha => each(&mut out, |i| 1.0 - dst[3][i] * unit),
        Factor::ConstantColor => out = [constant[c]; LANES],
        Factor::OneMinusConstantColor => out = [1.0 - constant[c]; LANES],
        Factor::ConstantAlpha => out = [constant[3]; LANES],
        Factor::OneMinusConstantAlpha => out = [1.0 - constant[3]; LANES],
        Factor::SrcAlphaSaturate if c == 3 => out = [1.0; LANES],
        Factor::SrcAlphaSaturate => each(&mut out, |i| min_f32(clamp01(src[3][i]), 1.0 - dst[3][i] * unit)),
    }
    out
}

/// Channel `c` of source and framebuffer put together, in place, limited to what the store can hold.
#[inline(always)]
fn combine(b: &mut FragmentBatch, u: &FragUniforms, c: usize, f: impl Fn(f32, f32, usize) -> f32) {
    let (src, dst) = (&b.tex.previous[c], &mut b.dst[c]);
    // Floats are only freed of NaN.
    let low = if u.scale == 1.0 { -u.limit } else { 0.0 };
    for i in 0..LANES {
        dst[i] = clamp_f32(f(clamp01(src[i]) * u.scale, dst[i], i), low, u.limit);
    }
}

/// Blending of packed pixels in one loop: `f` of source and framebuffer in 0..=255, the source's channel and its alpha in
/// [0, 1]. All are positive, so a sum of products needs a limit above only.
#[inline(always)]
fn packed<const N: usize>(
    color: &[[f32; N]; 4],
    dst: &[u32; N],
    or: u32,
    out: &mut [u32; N],
    f: impl Fn(f32, f32, f32, f32) -> f32,
) {
    let [red, green, blue, alpha] = color;
    for i in 0..N {
        let p = dst[i];
        let a = clamp01(alpha[i]);
        let channel = |v: f32, shift: u32| {
            let v = clamp01(v);
            let d = (p >> shift & 0xFF).cast_signed() as f32;
            min_f32(f(v * 255.0, d, v, a), 255.0)
        };
        out[i] =
            whole_pixel(channel(red[i], 0), channel(green[i], 8), channel(blue[i], 16), channel(alpha[i], 24)) | or;
    }
}

/// The usual pairs of factors, by number (see [`PACKED_PAIRS`]).
#[inline(always)]
pub(crate) fn pair<const N: usize>(
    color: &[[f32; N]; 4],
    dst: &[u32; N],
    (scale, or): (f32, u32),
    out: &mut [u32; N],
    number: u32,
) {
    let unit = 1.0 / scale;
    match number {
        0 => packed(color, dst, or, out, |s, d, _, a| s * a + d * (1.0 - a)),
        1 => packed(color, dst, or, out, |s, d, _, a| s + d * (1.0 - a)),
        2 => packed(color, dst, or, out, |s, d, _, a| s * a + d),
        3 => packed(color, dst, or, out, |s, d, _, _| s + d),
        4 => packed(color, dst, or, out, |s, d, _, _| s * (d * unit)),
        _ => packed(color, dst, or, out, |_, d, v, _| d * v),
    }
}

stage! {
    /// Blending with any factors and equation. Alpha comes last, since factors of the colours read it.
    pub(crate) fn BLEND: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for c in 0..4 {
            let half = usize::from(c == 3);
            match u.blend.equation {
                Equation::Min => combine(b, u, c, |s, d, _| min_f32(s, d)),
                Equation::Max => combine(b, u, c, |s, d, _| max_f32(s, d)),
                equation => {
                    let s_factor = factor(u.blend.src[half], c, b, u);
                    let d_factor = factor(u.blend.dst[half], c, b, u);
                    match equation {
                        Equation::Subtract => combine(b, u, c, |s, d, i| s * s_factor[i] - d * d_factor[i]),
                        Equation::ReverseSubtract => combine(b, u, c, |s, d, i| d * d_factor[i] - s * s_factor[i]),
                        _ => combine(b, u, c, |s, d, i| s * s_factor[i] + d * d_factor[i]),
                    }
                }
            }
        }
    }

    /// The usual pairs of factors on packed pixels, by number (see [`PACKED_PAIRS`]): what [`BLEND`] between unpacking and
    /// packing gives, without the products by 0 and 1.
    pub(crate) fn BLEND_PACKED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        pair(&b.tex.previous, &b.packed_dst, (u.scale, u.packed_or), &mut b.packed, arg);
    }

    /// [`LOAD`](crate::fragment::reference::pack::LOAD), [`BLEND_PACKED`] and [`STORE`](crate::fragment::reference::pack::STORE) where nothing comes between them.
    pub(crate) fn BLEND_STORE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let (mut dst, mut out) = ([0; LANES], [0; LANES]);
        load(places!(b), w.band.rgba8, &mut dst);
        pair(&b.tex.previous, &dst, (u.scale, u.packed_or), &mut out, arg);
        store(places!(b), &b.tex.mask, &out, w.band.rgba8);
    }
}

/// The pairs of factors that [`BLEND_PACKED`] knows.
const PACKED_PAIRS: [(Factor, Factor); 6] = [
    (Factor::SrcAlpha, Factor::OneMinusSrcAlpha),
    (Factor::One, Factor::OneMinusSrcAlpha),
    (Factor::SrcAlpha, Factor::One),
    (Factor::One, Factor::One),
    (Factor::DstColor, Factor::Zero),
    (Factor::Zero, Factor::SrcColor),
];

/// The number of [`BLEND_PACKED`] that does this blending, if there is one.
pub(crate) fn packed_pair(blend: &BlendUniforms) -> Option<u32> {
    let same = blend.src[0] == blend.src[1] && blend.dst[0] == blend.dst[1] && blend.equation == Equation::Add;
    let at = PACKED_PAIRS.iter().position(|pair| *pair == (blend.src[0], blend.dst[0]))?;
    same.then_some(at as u32)
}
