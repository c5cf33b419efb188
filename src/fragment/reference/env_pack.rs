//! Texels that become pixels at once (OpenGL 1.5, sections 3.8.13 and 4.1.4), where nothing but the alpha test comes between
//! the last texture environment and the store.
//!
//! Where the one texture is read by NEAREST from 8-bit texels and its environment puts the texel in the place of the colour,
//! a pixel is a texel: as floats it would be c/255 in every channel, and 255 times that rounds to c again. So the word goes
//! from fetch to store as it is. Other texels are rounded by the stage that replaces the colour or multiplies it.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, any, compare};
use crate::fragment::key::EnvStep;
use crate::fragment::reference::pack::{byte, whole_pixel};
use crate::fragment::reference::places::{places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};
use crate::texture::batch::{Lanes, TexBatch};

/// In the number of a stage that packs: the alpha test follows, which is to see alpha as it is.
pub const TESTED: u32 = 1;
/// In the number of [`PACK_TEXEL`]: alpha is that of the primary colour, not of the texel.
pub const PRIMARY_ALPHA: u32 = 2;
/// In the number of [`ENV_PACK`]: the colour so far is that of the environment before, not the primary colour.
pub const LATER: u32 = 2;

const COLOR: u32 = 0x00FF_FFFF;

/// The number of [`ENV_PACK`] for a unit, of what it does to colour and alpha, and flags.
pub fn env_pack(unit: usize, [color, alpha]: [EnvStep; 2], flags: u32) -> u32 {
    flags | (unit as u32) << 2 | (color as u32) << 8 | (alpha as u32) << 10
}

/// The bits to be set in a pixel when no later stage reads its alpha.
#[inline(always)]
fn or(u: &FragUniforms, arg: u32) -> u32 {
    if arg & TESTED == 0 { u.packed_or } else { 0 }
}

/// A channel of a step, in 0..=255. Texels and colours are in 0..=1, and so is their product: nothing is to be limited.
#[inline(always)]
fn channel<const STEP: u32>(texel: f32, so_far: f32) -> f32 {
    255.0
        * match STEP {
            0 => texel,
            1 => texel * so_far,
            _ => so_far,
        }
}

/// The pixels of all lanes.
#[inline(always)]
fn pixels<const COLOR: u32, const ALPHA: u32>(
    texel: &[Lanes; 4],
    so_far: &[Lanes; 4],
    or: u32,
    out: &mut [u32; LANES],
) {
    let color = |c: usize, i: usize| channel::<COLOR>(texel[c][i], so_far[c][i]);
    for i in 0..LANES {
        let alpha = channel::<ALPHA>(texel[3][i], so_far[3][i]);
        out[i] = whole_pixel(color(0, i), color(1, i), color(2, i), alpha) | or;
    }
}

/// What the environment of [`ENV_PACK`]'s number gives.
#[inline(always)]
fn environment(tex: &TexBatch, or: u32, arg: u32, out: &mut [u32; LANES]) {
    let TexBatch { texel, primary, previous, .. } = tex;
    let Some(texel) = texel.get((arg >> 2 & 63) as usize) else { return };
    let so_far = if arg & LATER == 0 { primary } else { previous };
    match arg >> 8 {
        0 => pixels::<0, 0>(texel, so_far, or, out),
        1 => pixels::<1, 0>(texel, so_far, or, out),
        2 => pixels::<2, 0>(texel, so_far, or, out),
        4 => pixels::<0, 1>(texel, so_far, or, out),
        5 => pixels::<1, 1>(texel, so_far, or, out),
        6 => pixels::<2, 1>(texel, so_far, or, out),
        8 => pixels::<0, 2>(texel, so_far, or, out),
        9 => pixels::<1, 2>(texel, so_far, or, out),
        _ => pixels::<2, 2>(texel, so_far, or, out),
    }
}

stage! {
    /// The last environment and the rounding of what it gives.
    pub fn ENV_PACK: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        environment(&b.tex, or(u, arg), arg, &mut b.packed);
    }

    /// [`ENV_PACK`] and [`STORE`](crate::fragment::reference::pack::STORE) where nothing comes between them.
    pub fn ENV_STORE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let mut out = [0; LANES];
        environment(&b.tex, or(u, arg), arg, &mut out);
        store(places!(b), &b.tex.mask, &out, w.band.rgba8);
    }

    /// The texels as pixels.
    pub fn PACK_TEXEL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let or = or(u, arg);
        if arg & PRIMARY_ALPHA == 0 {
            for i in 0..LANES {
                b.packed[i] = b.tex.packed[i] | or;
            }
        } else {
            let alpha = &b.tex.primary[3];
            for i in 0..LANES {
                b.packed[i] = (b.tex.packed[i] & COLOR) | byte(alpha[i]) << 24 | or;
            }
        }
    }

    /// The alpha test on the bytes of the pixels.
    pub fn ALPHA_TEST_PACKED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let mut alpha = [0; LANES];
        for i in 0..LANES {
            alpha[i] = b.packed[i] >> 24;
            b.packed[i] |= u.packed_or;
        }
        compare(CompareFunc::from_arg(arg), &alpha, &[byte(u.alpha_ref); LANES], &mut b.tex.mask);
        b.alive = any(&b.tex.mask);
    }
}
