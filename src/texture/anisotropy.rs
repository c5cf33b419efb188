//! Anisotropic filtering (EXT_texture_filter_anisotropic), by the method that the extension gives as its example.
//!
//! ```text
//!   Px, Py          lengths in texels of what a pixel spans in x and in y
//!   N               the least whole number not below Pmax / Pmin, at most MAX_ANISOTROPY
//!   lambda          log2(Pmax / N) + bias
//!   color           mean of N samples along the longer of the two, at i/(N+1) - 1/2 of it, i = 1..N
//! ```
//!
//! N is each lane's own. The taps of a batch are run as often as its widest lane needs; a lane that has had its N keeps its
//! sum. With N = 1 the one tap is the centre and lambda that of the isotropic filter, bit for bit. A ratio is allowed 2^-10
//! above a whole number before it counts as more, so that rounding does not turn a square footprint into N = 2.

use super::batch::{SamplerScratch, TexBatch};
use super::lod::{lambda, span};
use super::uniforms::{SamplerUniforms, TexFn, by_dims, sampler_stages};
use crate::num::{clamp_f32, floor_f32, max_f32, min_f32};
use crate::simd::{Cost, LANES, Stage, stage};

#[inline(always)]
fn footprint<const DIMS: usize>(b: &mut TexBatch, u: &SamplerUniforms, _arg: u32) {
    let TexBatch { coord, ddx, ddy, lambda: out, scratch, .. } = b;
    let SamplerScratch { lane_taps, tap_step, axis, center, .. } = scratch;
    let mut along_x = [0u32; LANES];
    for i in 0..LANES {
        let (x, y) = (span::<DIMS>(ddx, u, i), span::<DIMS>(ddy, u, i));
        along_x[i] = if x > y { u32::MAX } else { 0 };
        let (long, short) = (max_f32(x, y), min_f32(x, y));
        // 0 / 0 has no ratio: one tap. What is over 0 has the greatest.
        let ratio = clamp_f32((long / short).sqrt() - 0.000_976_562_5, 1.0, u.max_taps);
        let taps = -floor_f32(-ratio);
        lane_taps[i] = taps;
        tap_step[i] = 1.0 / (taps + 1.0);
        out[i] = lambda(long / (taps * taps), u);
    }
    for c in 0..DIMS {
        for i in 0..LANES {
            axis[c][i] = if along_x[i] != 0 { ddx[c][i] } else { ddy[c][i] };
        }
        center[c] = coord[c];
    }
}

/// Sets how many taps the batch needs: the most that a live lane has.
#[inline(always)]
fn count(b: &mut TexBatch) {
    let mut most = 1;
    for i in 0..LANES {
        let live = if (i as u32) < b.n as u32 { b.mask[i] } else { 0 };
        let taps = crate::num::round_to_int(b.scratch.lane_taps[i]) as u32 & live;
        most = if taps > most { taps } else { most };
    }
    b.scratch.taps = most;
}

sampler_stages! {
    FOOTPRINT_1D [Cost { logarithms: 1, ..Cost::NONE }] = footprint::<1>;
    FOOTPRINT_2D [Cost { logarithms: 1, ..Cost::NONE }] = footprint::<2>;
    FOOTPRINT_3D [Cost { logarithms: 1, ..Cost::NONE }] = footprint::<3>;
}

stage! {
    /// Lanes that read the nearest texel have one tap.
    pub fn NEAREST_ONE_TAP: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        for i in 0..LANES {
            if b.scratch.nearest[i] != 0 {
                b.scratch.lane_taps[i] = 1.0;
                b.scratch.tap_step[i] = 0.5;
            }
        }
    }
    /// How often the taps of this batch are run.
    pub fn COUNT_TAPS: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        count(b);
    }
    /// The coordinates of the tap at work; the argument says how many.
    pub fn TAP: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, arg: u32) {
        if b.scratch.taps == 1 {
            return;
        }
        b.limit = [f32::INFINITY; 3];
        b.least = [f32::NEG_INFINITY; 3];
        let TexBatch { coord, scratch: SamplerScratch { center, axis, tap_step, tap, .. }, .. } = b;
        let tap = *tap as f32;
        for c in 0..(arg as usize).min(3) {
            for i in 0..LANES {
                let offset = tap * tap_step[i] - 0.5;
                let moved = center[c][i] + offset * axis[c][i];
                coord[c][i] = if offset == 0.0 { center[c][i] } else { moved };
            }
        }
    }
    /// Adds the colours of the tap to the sums of the lanes that have it.
    pub fn ADD_TAP: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        let w = &mut b.scratch;
        if w.taps == 1 {
            return;
        }
        let tap = w.tap as f32;
        for pass in 0..if w.two_levels { 2 } else { 1 } {
            for c in 0..4 {
                let (sum, color) = (&mut w.sum[pass][c], &w.color[pass][c]);
                if w.tap == 1 {
                    *sum = *color;
                    continue;
                }
                for i in 0..LANES {
                    sum[i] += if tap <= w.lane_taps[i] { color[i] } else { 0.0 };
                }
            }
        }
    }
    /// The mean of the taps.
    pub fn MEAN_OF_TAPS: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        let w = &mut b.scratch;
        if w.taps == 1 {
            return;
        }
        for pass in 0..if w.two_levels { 2 } else { 1 } {
            for c in 0..4 {
                for i in 0..LANES {
                    w.color[pass][c][i] = w.sum[pass][c][i] / w.lane_taps[i];
                }
            }
        }
    }
}

/// The stage that finds taps, axis and lambda for this many coordinates.
pub fn footprint_stage(dims: usize) -> &'static Stage<TexFn> {
    by_dims(dims, [&FOOTPRINT_1D, &FOOTPRINT_2D, &FOOTPRINT_3D])
}

#[cfg(test)]
mod tests {
    use crate::enums::*;
    use crate::state::texture::Target;
    use crate::state::texture::TextureFilter;
    use crate::texture::object::TextureObject;
    use crate::texture::tests::support::*;

    /// Level l is grey of 10 + 30 l.
    fn levels(aniso: f32) -> TextureObject {
        let mut o = object(Target::D2, GL_LUMINANCE8, [64, 64, 1], 7, |_, l, _| grey(10 + 30 * l as i32));
        (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
        o.parameters.max_anisotropy = aniso;
        o
    }

    /// A footprint of x by y texels of 64.
    fn footprint(x: f32, y: f32) -> SamplePoint {
        SamplePoint { dx: [x / 64.0, 0.0, 0.0], dy: [0.0, y / 64.0, 0.0], ..at(0.4, 0.6, 0.0) }
    }

    #[test]
    fn lambda_is_that_of_the_longer_side_over_the_taps() {
        // (Px, Py, limit) -> N and from it log2(Pmax / N).
        let table: [(f32, f32, f32, f32); 9] = [
            (8.0, 8.0, 16.0, 1.0),
            (8.0, 4.0, 16.0, 2.0),
            (4.0, 8.0, 16.0, 2.0),
            (9.0, 4.0, 16.0, 3.0),
            (32.0, 2.0, 16.0, 16.0),
            (32.0, 2.0, 4.0, 4.0),
            (32.0, 2.0, 4.9, 4.0),
            (32.0, 0.0, 8.0, 8.0),
            (32.0, 1.0, 1000.0, 16.0),
        ];
        for (x, y, limit, n) in table {
            let want = 10.0 + 30.0 * (f64::from(x.max(y) / n)).log2();
            let got = f64::from(red(&levels(limit), footprint(x, y)));
            assert!((got - want).abs() < 0.02, "{x} by {y}, at most {limit}: {got}, not {want}");
        }
    }

    #[test]
    fn taps_lie_along_the_longer_side() {
        // Columns; lambda limited to 0, so that level 0 is read by each tap.
        let mut o = object(Target::D2, GL_LUMINANCE8, [16, 4, 1], 5, |_, _, [i, ..]| grey(i * i));
        (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
        o.parameters.max_anisotropy = 3.0;
        o.parameters.max_lod = 0.0;
        o.parameters.lod_bias = -9.0;
        o.parameters.max_lod = 1.0;
        // Px = 8 texels, Py = 1: three taps at -1/4, 0, +1/4 of 8 texels around the centre of texel 7.
        let p = SamplePoint { dx: [0.5, 0.0, 0.0], dy: [0.0, 0.25, 0.0], ..at(7.5 / 16.0, 0.4, 0.0) };
        assert!((red(&o, p) - (25.0 + 49.0 + 81.0) / 3.0).abs() < 0.001, "{}", red(&o, p));
    }

    #[test]
    fn a_square_footprint_is_the_isotropic_filter_bit_for_bit() {
        let points: Vec<SamplePoint> = (0..64)
            .map(|i| with_lambda(at(i as f32 * 0.37, i as f32 * 0.11, 0.0), f64::from(i) * 0.1 - 1.0, 64.0))
            .collect();
        let texels = |aniso| {
            let mut o = object(Target::D2, GL_RGBA8, [64, 64, 1], 7, |_, l, [i, j, _]| {
                [(i * 7 % 13) as f32 / 13.0, (j * 5 % 11) as f32 / 11.0, l as f32 / 7.0, 1.0]
            });
            (o.parameters.min_filter, o.parameters.mag_filter) =
                (TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
            o.parameters.max_anisotropy = aniso;
            sample(&o, &points)
        };
        let bits = |c: Vec<[f32; 4]>| c.into_iter().map(|c| c.map(f32::to_bits)).collect::<Vec<_>>();
        assert_eq!(bits(texels(1.0)), bits(texels(16.0)));
    }
}
