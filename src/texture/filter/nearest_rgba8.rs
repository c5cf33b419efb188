//! NEAREST of 8-bit texels (OpenGL 1.5, sections 3.8.8 and 3.8.9). A stage first fetches lane by lane, then unpacks all
//! lanes at once. Texels are whole numbers 0 to 255; the factor 1/255 comes last, once.

use super::{INV_255, REPEATS, SECOND, byte, destination, lane_image, lane_offset, neighbours, offsets, texels};
use crate::simd::{Cost, LANES, Stage};
use crate::texture::batch::{SamplerScratch, TexBatch};
use crate::texture::uniforms::{MipLevel, SamplerUniforms, TexFn, by_dims, sampler_stages};
use crate::texture::wrap::bounded::NearestWrap;
use crate::texture::wrap::general::repeat_or_clamp_nearest;

/// The nearest texel of every lane.
#[inline(always)]
fn nearest_texels<const DIMS: usize>(
    found: &mut [u32; LANES],
    scratch: &SamplerScratch,
    u: &SamplerUniforms,
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
fn wrap_nearest(found: &mut [u32; LANES], b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
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
    repeat_or_clamp_nearest(b, u, arg & SECOND, across);
    repeat_or_clamp_nearest(b, u, arg & SECOND | 1, up);
    nearest_texels::<2>(found, &b.scratch, u, pass);
}

#[inline(always)]
fn sample_nearest<const DIMS: usize, const WRAPS: bool>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
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

/// [`sample_nearest`] that leaves the texels packed.
#[inline(always)]
fn copy_nearest<const DIMS: usize, const WRAPS: bool>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    if WRAPS {
        let mut found = [0; LANES];
        wrap_nearest(&mut found, b, u, arg);
        b.packed = found;
    } else {
        nearest_texels::<DIMS>(&mut b.packed, &b.scratch, u, 0);
    }
}

/// What the stages cost that wrap s and t by REPEAT, CLAMP or CLAMP_TO_EDGE, too.
const WRAPPED: Cost = Cost { texels: 1, wraps: 2, ..Cost::NONE };

sampler_stages! {
    NEAREST_1D [Cost::texels(1)] = sample_nearest::<1, false>;
    NEAREST_2D [Cost::texels(1)] = sample_nearest::<2, false>;
    NEAREST_3D [Cost::texels(1)] = sample_nearest::<3, false>;
    NEAREST_1D_PACKED [Cost::texels(1)] = copy_nearest::<1, false>;
    NEAREST_2D_PACKED [Cost::texels(1)] = copy_nearest::<2, false>;
    NEAREST_3D_PACKED [Cost::texels(1)] = copy_nearest::<3, false>;
    WRAP_NEAREST_2D [WRAPPED] = sample_nearest::<2, true>;
    WRAP_NEAREST_2D_PACKED [WRAPPED] = copy_nearest::<2, true>;
}

/// The stage that reads the nearest texel.
pub fn nearest(dims: usize) -> &'static Stage<TexFn> {
    by_dims(dims, [&NEAREST_1D, &NEAREST_2D, &NEAREST_3D])
}

/// The stage that reads the nearest texel and leaves it packed.
pub fn nearest_packed(dims: usize) -> &'static Stage<TexFn> {
    by_dims(dims, [&NEAREST_1D_PACKED, &NEAREST_2D_PACKED, &NEAREST_3D_PACKED])
}
