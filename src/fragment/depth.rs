//! Depth (OpenGL 1.5, sections 3.5.5 end and 4.1.6): the window depth of each fragment as an integer of the depth buffer,
//! and the depth test. Depth is linear in the window, so it is summed in `f64` and rounded once; the same primitive drawn
//! with other state gets the same integers, which EQUAL relies on.

use super::batch::FragmentBatch;
use super::buffers::{fresh_mask, load, places, store};
use super::compare::{Func, any, compare};
use super::planes::Linear;
use super::segments::{CHUNK, linear64, pieces, positions, put, row_origin, single_row};
use super::uniforms::{FragFn, FragUniforms, Work};
use crate::batch::{LANES, stage};

/// 2^52: a float whose unit in the last place is 1, so that the low half of its bits is the rounded integer.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// A depth as an integer of the buffer: limited to 0..=max (NaN gives 0), rounded to the nearest, ties to even.
#[inline(always)]
fn quantise(z: f64, max: f64) -> u32 {
    let z = if z > 0.0 { z } else { 0.0 };
    let z = if z < max { z } else { max };
    (z + WHOLE).to_bits() as u32
}

/// Depth along a row.
#[derive(Clone, Copy)]
pub(super) struct Slope {
    at: f64,
    x: f64,
    max: f64,
}

impl Slope {
    /// Depth in the row y, relative to the primitive's origin.
    #[inline(always)]
    pub(super) fn new(z: &Linear, y: i32, max: f64) -> Self {
        Self { at: z.at + z.y * f64::from(y), x: z.x, max }
    }

    /// The depths from x, relative to the primitive's origin, on.
    #[inline(always)]
    pub(super) fn depths<const N: usize>(&self, x: i32, out: &mut [u32; N]) {
        if self.x == 0.0 {
            // (at + 0 x) is at, or at with the sign of a zero changed.
            *out = [quantise(self.at, self.max); N];
        } else {
            for i in 0..N {
                out[i] = quantise(self.at + self.x * f64::from(x.wrapping_add(i as i32)), self.max);
            }
        }
    }
}

/// Bit of [`DEPTH_TEST`]'s number: depths are written. The function stands above it.
pub(super) const WRITE: u32 = 1;

stage! {
    /// All lanes in use are alive.
    pub(super) fn BEGIN: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        fresh_mask(b);
    }

    /// The depth of each fragment.
    pub(super) fn DEPTH: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let max = u.depth_max;
        if single_row(b) && let Some(planes) = w.planes.get(b.segments[0].prim as usize) {
            let (x0, y) = row_origin(&b.segments[0], planes);
            Slope::new(&planes.z, y, max).depths(x0, &mut b.z);
            return;
        }
        for s in 0..b.segment_count.min(LANES) {
            let segment = b.segments[s];
            let Some(planes) = w.planes.get(segment.prim as usize) else { continue };
            for piece in pieces(&segment) {
                let (dx, dy) = positions((&b.dx, &b.dy), &segment, planes, piece);
                let z = linear64(&planes.z, &dx, &dy);
                let mut out = [0; CHUNK];
                for i in 0..CHUNK {
                    out[i] = quantise(z[i], max);
                }
                put(&mut b.z, piece, &out);
            }
        }
    }

    /// The depth test, and with [`WRITE`] the new depths of the fragments that pass.
    pub(super) fn DEPTH_TEST: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        load(places!(b), w.band.depth, &mut b.depth);
        compare(Func::from_arg(arg >> 1), &b.z, &b.depth, &mut b.tex.mask);
        b.alive = any(&b.tex.mask);
        if arg & WRITE != 0 && b.alive {
            store(places!(b), &b.tex.mask, &b.z, w.band.depth);
        }
    }

    /// Counts the fragments that passed, for an occlusion query.
    pub(super) fn COUNT_SAMPLES: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut passed = 0;
        for m in &b.tex.mask {
            passed += m & 1;
        }
        w.band.samples = w.band.samples.wrapping_add(u64::from(passed));
    }

    /// The new depths of the fragments that have passed all tests.
    pub(super) fn DEPTH_WRITE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        store(places!(b), &b.tex.mask, &b.z, w.band.depth);
    }
}
