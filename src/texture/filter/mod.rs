//! Filters (OpenGL 1.5, sections 3.8.8, 3.8.9 and 3.8.14): from the texels that a wrap has found to a colour. This file
//! holds what all of them share: where texels are, and where the colour goes.

pub mod depth;
pub mod float;
pub mod linear_rgba8;
pub mod nearest_rgba8;

use super::batch::{Lanes, SamplerScratch};
use super::image::Texels;
use super::uniforms::{MipLevel, SamplerUniforms};
use super::wrap::general;
use crate::simd::LANES;

/// In a stage's argument: the second pass, of two levels.
pub const SECOND: u32 = general::SECOND;
/// In a stage's argument: the colour is not the final one but one of two levels or of several taps.
pub const PARTIAL: u32 = 16;

/// In the argument of a stage that wraps too: s is REPEAT; the next bits are those of t and r.
pub const REPEATS: u32 = 32;

/// [`REPEATS`] and the next two bits: which of s, t, r are wrapped by REPEAT.
#[must_use]
pub fn repeat_flags([s, t, r]: [bool; 3]) -> u32 {
    (u32::from(s) | u32::from(t) << 1 | u32::from(r) << 2) * REPEATS
}

/// 1/255, rounded once. 255 times it is exactly 1.
pub const INV_255: f32 = 1.0 / 255.0;

/// `a + t (b - a)`.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + t * (b - a)
}

/// Byte `c` of a texel as a float.
#[inline(always)]
pub(super) fn byte(texel: u32, c: u32) -> f32 {
    ((texel >> (8 * c)) & 255) as i32 as f32
}

/// The 8-bit texels of an image; none if it stores others.
#[inline(always)]
pub fn texels(image: &MipLevel) -> &[u32] {
    match &image.image.texels {
        Texels::Rgba8(texels) => texels,
        _ => &[],
    }
}

/// Index of each lane's first texel, `origin` being that of texel (0, 0, 0).
#[inline(always)]
pub(super) fn offsets<const DIMS: usize>(
    scratch: &SamplerScratch,
    origin: u32,
    stride: u32,
    slice: u32,
) -> [u32; LANES] {
    let mut at = [0; LANES];
    for i in 0..LANES {
        let mut o = origin.wrapping_add_signed(scratch.first[0][i]);
        if DIMS > 1 {
            o = o.wrapping_add((scratch.first[1][i] as u32).wrapping_mul(stride));
        }
        if DIMS > 2 {
            o = o.wrapping_add((scratch.first[2][i] as u32).wrapping_mul(slice));
        }
        at[i] = o;
    }
    at
}

/// The image that a lane reads in a pass where lanes differ.
#[inline(always)]
pub(super) fn lane_image<'a>(
    u: &'a SamplerUniforms,
    scratch: &SamplerScratch,
    pass: usize,
    i: usize,
) -> Option<&'a MipLevel> {
    u.images.get(scratch.face[i] as usize * u.face_step + scratch.level[pass][i] as usize)
}

/// Index of a lane's first texel in its own image.
#[inline(always)]
pub(super) fn lane_offset<const DIMS: usize>(scratch: &SamplerScratch, image: &MipLevel, i: usize) -> usize {
    let mut o = image.origin.wrapping_add_signed(scratch.first[0][i]);
    if DIMS > 1 {
        o = o.wrapping_add((scratch.first[1][i] as u32).wrapping_mul(image.stride));
    }
    if DIMS > 2 {
        o = o.wrapping_add((scratch.first[2][i] as u32).wrapping_mul(image.slice));
    }
    o as usize
}

/// Where a stage's colour goes, and its factor.
#[inline(always)]
pub(super) fn destination<'a>(
    texel: &'a mut [[Lanes; 4]],
    color: &'a mut [[Lanes; 4]; 2],
    unit: usize,
    arg: u32,
    k: f32,
) -> Option<(&'a mut [Lanes; 4], f32)> {
    if arg & PARTIAL != 0 {
        color.get_mut(usize::from(arg & SECOND != 0)).map(|out| (out, 1.0))
    } else {
        texel.get_mut(unit).map(|out| (out, k))
    }
}

/// The first index, if each lane reads the texel after that of the lane before it: an image drawn in its own size.
#[inline(always)]
pub fn neighbours<const N: usize>(at: &[u32; N]) -> Option<usize> {
    let first = *at.first()?;
    if at.last()?.wrapping_sub(first) != N as u32 - 1 {
        return None;
    }
    let mut differs = 0;
    for i in 0..N {
        differs |= at[i].wrapping_sub(first) ^ i as u32;
    }
    (differs == 0).then_some(first as usize)
}
