//! Blending (OpenGL 1.5, section 4.1.7). It is done in floats in the unit of the colour store: bytes are whole numbers
//! from 0 to 255, so that what is in the framebuffer needs no division, a factor of 1 or 0 is exact, and the result is
//! rounded once. With S the source's colour in that unit and D the framebuffer's:
//!
//! ```text
//!   ADD  S s + D d     SUBTRACT  S s - D d     REVERSE_SUBTRACT  D d - S s     MIN, MAX  of S and D, without factors
//! ```

use crate::fragment::batch::FragmentBatch;
use crate::fragment::reference::pack::whole_pixel;
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{BlendUniforms, FragFn, FragUniforms, Work};
use crate::num::{clamp_f32, clamp01, max_f32, min_f32};
use crate::simd::{LANES, stage};
use crate::state::color_buffer::{BlendEquation, BlendFactor};
use crate::texture::batch::Lanes;

/// The factor of channel `c` for all lanes.
#[inline(always)]
fn factor(f: BlendFactor, c: usize, b: &FragmentBatch, u: &FragUniforms) -> Lanes {
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
        BlendFactor::Zero => {}
        BlendFactor::One => out = [1.0; LANES],
        BlendFactor::SrcColor => each(&mut out, |i| clamp01(src[c][i])),
        BlendFactor::OneMinusSrcColor => each(&mut out, |i| 1.0 - clamp01(src[c][i])),
        BlendFactor::DstColor => each(&mut out, |i| dst[c][i] * unit),
        BlendFactor::OneMinusDstColor => each(&mut out, |i| 1.0 - dst[c][i] * unit),
        BlendFactor::SrcAlpha => each(&mut out, |i| clamp01(src[3][i])),
        BlendFactor::OneMinusSrcAlpha => each(&mut out, |i| 1.0 - clamp01(src[3][i])),
        BlendFactor::DstAlpha => each(&mut out, |i| dst[3][i] * unit),
        BlendFactor::OneMinusDstAlpha => each(&mut out, |i| 1.0 - dst[3][i] * unit),
        BlendFactor::ConstantColor => out = [constant[c]; LANES],
        BlendFactor::OneMinusConstantColor => out = [1.0 - constant[c]; LANES],
        BlendFactor::ConstantAlpha => out = [constant[3]; LANES],
        BlendFactor::OneMinusConstantAlpha => out = [1.0 - constant[3]; LANES],
        BlendFactor::SrcAlphaSaturate if c == 3 => out = [1.0; LANES],
        BlendFactor::SrcAlphaSaturate => each(&mut out, |i| min_f32(clamp01(src[3][i]), 1.0 - dst[3][i] * unit)),
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
pub fn pair<const N: usize>(
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
    pub fn BLEND: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for c in 0..4 {
            let half = usize::from(c == 3);
            match u.blend.equation[half] {
                BlendEquation::Min => combine(b, u, c, |s, d, _| min_f32(s, d)),
                BlendEquation::Max => combine(b, u, c, |s, d, _| max_f32(s, d)),
                equation => {
                    let s_factor = factor(u.blend.src[half], c, b, u);
                    let d_factor = factor(u.blend.dst[half], c, b, u);
                    match equation {
                        BlendEquation::Subtract => combine(b, u, c, |s, d, i| s * s_factor[i] - d * d_factor[i]),
                        BlendEquation::ReverseSubtract => combine(b, u, c, |s, d, i| d * d_factor[i] - s * s_factor[i]),
                        BlendEquation::Add | BlendEquation::Min | BlendEquation::Max => {
                            combine(b, u, c, |s, d, i| s * s_factor[i] + d * d_factor[i]);
                        }
                    }
                }
            }
        }
    }

    /// The usual pairs of factors on packed pixels, by number (see [`PACKED_PAIRS`]): what [`BLEND`] between unpacking and
    /// packing gives, without the products by 0 and 1.
    pub fn BLEND_PACKED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        pair(&b.tex.previous, &b.packed_dst, (u.scale, u.packed_or), &mut b.packed, arg);
    }

    /// [`LOAD`](crate::fragment::reference::pack::LOAD), [`BLEND_PACKED`] and [`STORE`](crate::fragment::reference::pack::STORE) where nothing comes between them.
    pub fn BLEND_STORE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let (mut dst, mut out) = ([0; LANES], [0; LANES]);
        load(places!(b), w.band.rgba8, &mut dst);
        pair(&b.tex.previous, &dst, (u.scale, u.packed_or), &mut out, arg);
        store(places!(b), &b.tex.mask, &out, w.band.rgba8);
    }
}

/// The pairs of factors that [`BLEND_PACKED`] knows.
const PACKED_PAIRS: [(BlendFactor, BlendFactor); 6] = [
    (BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha),
    (BlendFactor::One, BlendFactor::OneMinusSrcAlpha),
    (BlendFactor::SrcAlpha, BlendFactor::One),
    (BlendFactor::One, BlendFactor::One),
    (BlendFactor::DstColor, BlendFactor::Zero),
    (BlendFactor::Zero, BlendFactor::SrcColor),
];

/// The number of [`BLEND_PACKED`] that does this blending, if there is one.
pub fn packed_pair(blend: &BlendUniforms) -> Option<u32> {
    let same =
        blend.src[0] == blend.src[1] && blend.dst[0] == blend.dst[1] && blend.equation == [BlendEquation::Add; 2];
    let at = PACKED_PAIRS.iter().position(|pair| *pair == (blend.src[0], blend.dst[0]))?;
    same.then_some(at as u32)
}
