//! NEAREST and LINEAR of texels kept as floats (OpenGL 1.5, sections 3.8.8 and 3.8.9): the formats with more than eight
//! bits a component. The same nested a + t (b - a) as for 8-bit texels, four channels of a lane at a time, since that is
//! how these texels lie in memory.

use crate::simd::{Cost, LANES, Stage};
use crate::texture::batch::{Lanes, SamplerScratch, TexBatch};
use crate::texture::filter::{SECOND, destination, lane_image, lane_offset, lerp, offsets};
use crate::texture::image::{FloatTexel, Texels};
use crate::texture::uniforms::{MipLevel, SamplerUniforms, TexFn, by_dims, sampler_stages};

#[inline(always)]
fn texels(image: &MipLevel) -> &[FloatTexel] {
    match &image.image.texels {
        Texels::Float(texels) => texels,
        _ => &[],
    }
}

/// Two neighbours in each of the `ROWS` rows that a filter reads: row j, row j+1, then those of slice k+1.
#[inline(always)]
pub(super) fn neighbours<T: Copy + Default, const ROWS: usize>(
    texels: &[T],
    o: usize,
    stride: usize,
    slice: usize,
) -> [[T; 2]; ROWS] {
    let row = |r: usize| (r & 1) * stride + (r >> 1) * slice;
    match texels.get(o..o + row(ROWS - 1) + 2) {
        Some(t) => std::array::from_fn(|r| [t[row(r)], t[row(r) + 1]]),
        None => [[T::default(); 2]; ROWS],
    }
}

/// Runs `f(lane, image, index of its first texel)` over the lanes in use.
#[inline(always)]
pub(super) fn each_lane<const DIMS: usize>(
    w: &SamplerScratch,
    n: usize,
    u: &SamplerUniforms,
    pass: usize,
    mut f: impl FnMut(usize, &MipLevel, usize),
) {
    let n = n.min(LANES);
    if let Some(same) = w.same[pass] {
        let Some(image) = u.images.get(same) else { return };
        let at = offsets::<DIMS>(w, image.origin, image.stride, image.slice);
        for i in 0..n {
            f(i, image, at[i] as usize);
        }
    } else {
        for i in 0..n {
            let Some(image) = lane_image(u, w, pass, i) else { continue };
            f(i, image, lane_offset::<DIMS>(w, image, i));
        }
    }
}

#[inline(always)]
fn mix(a: FloatTexel, b: FloatTexel, t: f32) -> FloatTexel {
    std::array::from_fn(|c| lerp(a[c], b[c], t))
}

#[inline(always)]
fn sample<const DIMS: usize, const ROWS: usize, const LINEAR: bool>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.scratch.two_levels {
        return;
    }
    let n = b.n;
    let TexBatch { texel, scratch, .. } = b;
    let mut colors = [[0.0; LANES]; 4];
    let [ws, wt, wr] = &scratch.weight;
    each_lane::<DIMS>(scratch, n, u, pass, |i, image, at| {
        let color = if LINEAR {
            let rows = neighbours::<FloatTexel, ROWS>(texels(image), at, image.stride as usize, image.slice as usize);
            let across = |r: usize| mix(rows[r][0], rows[r][1], ws[i]);
            match ROWS {
                1 => across(0),
                2 => mix(across(0), across(1), wt[i]),
                _ => mix(mix(across(0), across(1), wt[i]), mix(across(2), across(3), wt[i]), wr[i]),
            }
        } else {
            texels(image).get(at).copied().unwrap_or_default()
        };
        for c in 0..4 {
            colors[c][i] = color[c];
        }
    });
    let out: Option<(&mut [Lanes; 4], f32)> = destination(texel, &mut scratch.color, u.unit, arg, 1.0);
    if let Some((out, _)) = out {
        *out = colors;
    }
}

sampler_stages! {
    NEAREST_1D_FLOAT [Cost::texels(1)] = sample::<1, 1, false>;
    NEAREST_2D_FLOAT [Cost::texels(1)] = sample::<2, 2, false>;
    NEAREST_3D_FLOAT [Cost::texels(1)] = sample::<3, 4, false>;
    LINEAR_1D_FLOAT [Cost::texels(2)] = sample::<1, 1, true>;
    BILINEAR_2D_FLOAT [Cost::texels(4)] = sample::<2, 2, true>;
    TRILINEAR_3D_FLOAT [Cost::texels(8)] = sample::<3, 4, true>;
}

/// The stage for this many dimensions.
pub fn stage(dims: usize, linear: bool) -> &'static Stage<TexFn> {
    if linear {
        by_dims(dims, [&LINEAR_1D_FLOAT, &BILINEAR_2D_FLOAT, &TRILINEAR_3D_FLOAT])
    } else {
        by_dims(dims, [&NEAREST_1D_FLOAT, &NEAREST_2D_FLOAT, &NEAREST_3D_FLOAT])
    }
}
