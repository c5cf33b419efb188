//! NEAREST of 8-bit texels (OpenGL 1.5, sections 3.8.8 and 3.8.9). A stage first fetches lane by lane, then unpacks all
//! lanes at once. Texels are whole numbers 0 to 255; the factor 1/255 comes last, once.

use super::{INV_255, REPEATS, SECOND, byte, destination, lane_image, lane_offset, neighbours, offsets, texels};
use crate::simd::{Cost, LANES, Stage, stage};
use crate::texture::batch::{SamplerScratch, TexBatch};
use crate::texture::uniforms::{MipLevel, TexFn, UnitUniforms};
use crate::texture::wrap::bounded::NearestWrap;
use crate::texture::wrap::general::far_nearest;

/// The nearest texel of every lane.
#[inline(always)]
fn nearest_texels<const DIMS: usize>(
    found: &mut [u32; LANES],
    scratch: &SamplerScratch,
    u: &UnitUniforms,
    pass: usize,
) {
    if let Some(same) = scratch.same[pass] {
        let Some(image) = u.images.get(same) else { return };
        texels_at(found, image, &offsets::<DIMS>(scratch, image.origin, image.stride, image.slice));
    } else {
        for i in 0..LANES {
            let Some(image) = lane_image(u, scratch, pass, i) else { break };
            let Some(&texel) = texels(image).get(lane_offset::<DIMS>(scratch, image, i)) else { break };
            found[i] = texel;
        }
    }
}

/// The texels at these indices of an image.
#[inline(always)]
fn texels_at(found: &mut [u32; LANES], image: &MipLevel, at: &[u32; LANES]) {
    let t = texels(image);
    if let Some(run) = neighbours(at).and_then(|first| t.get(first..)).and_then(|t| t.first_chunk()) {
        *found = *run;
        return;
    }
    for i in 0..LANES {
        let Some(&texel) = t.get(at[i] as usize) else { break };
        found[i] = texel;
    }
}

/// Wraps s and t, and fetches the nearest texel of every lane.
#[inline(always)]
fn wrap_nearest(found: &mut [u32; LANES], b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let (across, up) = (arg & REPEATS != 0, arg & (2 * REPEATS) != 0);
    let pass = usize::from(arg & SECOND != 0);
    let TexBatch { coord: [s, t, _], limit, scratch, .. } = b;
    if let Some(image) = scratch.same[pass].and_then(|same| u.images.get(same))
        && let Some(column) = NearestWrap::new(across, limit[0], image.size[0])
        && let Some(row) = NearestWrap::new(up, limit[1], image.size[1])
    {
        let mut at = [0; LANES];
        for i in 0..LANES {
            let start = image.origin.wrapping_add(row.index(t[i]).wrapping_mul(image.stride));
            at[i] = start.wrapping_add(column.index(s[i]));
        }
        return texels_at(found, image, &at);
    }
    far_nearest(b, u, arg & SECOND, across);
    far_nearest(b, u, arg & SECOND | 1, up);
    nearest_texels::<2>(found, &b.scratch, u, pass);
}

#[inline(always)]
fn sample_nearest<const DIMS: usize, const WRAPS: bool>(b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.scratch.two_levels {
        return;
    }
    let mut found = [0; LANES];
    if WRAPS {
        wrap_nearest(&mut found, b, u, arg);
    } else {
        nearest_texels::<DIMS>(&mut found, &b.scratch, u, pass);
    }
    let TexBatch { texel, scratch, .. } = b;
    let Some((out, k)) = destination(texel, &mut scratch.color, u.unit, arg, INV_255) else { return };
    for c in 0..4 {
        for i in 0..LANES {
            out[c][i] = byte(found[i], c as u32) * k;
        }
    }
}

stage! {
    /// The nearest texel of a 1D image.
    pub fn NEAREST_1D: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<1, false>(b, u, arg);
    }
    /// The nearest texel of a 2D image.
    pub fn NEAREST_2D: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<2, false>(b, u, arg);
    }
    /// The nearest texel of a 3D image.
    pub fn NEAREST_3D: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<3, false>(b, u, arg);
    }
    /// The nearest texel of a 1D image, packed.
    pub fn NEAREST_1D_PACKED: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<1>(&mut b.packed, &b.scratch, u, 0);
    }
    /// The nearest texel of a 2D image, packed.
    pub fn NEAREST_2D_PACKED: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<2>(&mut b.packed, &b.scratch, u, 0);
    }
    /// REPEAT, CLAMP or CLAMP_TO_EDGE in s and in t, and the nearest texel of a 2D image.
    pub fn WRAP_NEAREST_2D: TexFn [Cost { texels: 1, wraps: 2, ..Cost::NONE }] = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<2, true>(b, u, arg);
    }
    /// The same, packed.
    pub fn WRAP_NEAREST_2D_PACKED: TexFn [Cost { texels: 1, wraps: 2, ..Cost::NONE }] = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        let mut found = [0; LANES];
        wrap_nearest(&mut found, b, u, arg);
        b.packed = found;
    }
    /// The nearest texel of a 3D image, packed.
    pub fn NEAREST_3D_PACKED: TexFn [Cost::texels(1)] = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<3>(&mut b.packed, &b.scratch, u, 0);
    }
}

/// The stage that reads the nearest texel.
#[must_use]
pub fn nearest(dims: usize) -> &'static Stage<TexFn> {
    match dims {
        1 => &NEAREST_1D,
        2 => &NEAREST_2D,
        _ => &NEAREST_3D,
    }
}

/// The stage that reads the nearest texel and leaves it packed.
#[must_use]
pub fn nearest_packed(dims: usize) -> &'static Stage<TexFn> {
    match dims {
        1 => &NEAREST_1D_PACKED,
        2 => &NEAREST_2D_PACKED,
        _ => &NEAREST_3D_PACKED,
    }
}
