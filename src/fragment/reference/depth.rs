//! Depth (OpenGL 1.5, sections 3.5.5 end and 4.1.6): the window depth of each fragment as an integer of the depth buffer,
//! and the depth test. Depth is linear in the window, so it is summed in `f64` and rounded once; the same primitive drawn
//! with other state gets the same integers, which EQUAL relies on.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{Func, any, compare};
use crate::fragment::reference::lanes::{CHUNK, linear64, pieces, positions, put, row_origin, single_row};
use crate::fragment::reference::places::{fresh_mask, load, places, store};
use crate::fragment::span::depth::Slope;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};

/// 2^52: a float whose unit in the last place is 1, so that the low half of its bits is the rounded integer.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// A depth as an integer of the buffer: limited to 0..=max (NaN gives 0), rounded to the nearest, ties to even.
#[inline(always)]
pub(crate) fn quantise(z: f64, max: f64) -> u32 {
    let z = if z > 0.0 { z } else { 0.0 };
    let z = if z < max { z } else { max };
    whole(z)
}

/// A depth that is within the limits, rounded.
#[inline(always)]
pub(crate) fn whole(z: f64) -> u32 {
    (z + WHOLE).to_bits() as u32
}

/// Bit of [`DEPTH_TEST`]'s number: depths are written. The function stands above it.
pub(crate) const WRITE: u32 = 1;

/// The depth of each fragment.
#[inline(always)]
pub(crate) fn depths(b: &mut FragmentBatch, u: &FragUniforms, w: &Work<'_, '_>) {
    let max = u.depth_max;
    if single_row(b)
        && let Some(planes) = w.planes.get(b.segments[0].prim as usize)
    {
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
#[inline(always)]
pub(crate) fn test(b: &mut FragmentBatch, w: &mut Work<'_, '_>, arg: u32) {
    load(places!(b), w.band.depth, &mut b.depth);
    compare(Func::from_arg(arg >> 1), &b.z, &b.depth, &mut b.tex.mask);
    b.alive = any(&b.tex.mask);
    if arg & WRITE != 0 && b.alive {
        store(places!(b), &b.tex.mask, &b.z, w.band.depth);
    }
}

stage! {
    /// All lanes in use are alive.
    pub(crate) fn BEGIN: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        fresh_mask(b);
    }

    /// The depth of each fragment.
    pub(crate) fn DEPTH: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        depths(b, u, w);
    }

    /// The depth test, and with [`WRITE`] the new depths of the fragments that pass.
    pub(crate) fn DEPTH_TEST: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        test(b, w, arg);
    }

    /// Counts the fragments that passed, for an occlusion query.
    pub(crate) fn COUNT_SAMPLES: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut passed = 0;
        for m in &b.tex.mask {
            passed += m & 1;
        }
        w.band.samples = w.band.samples.wrapping_add(u64::from(passed));
    }

    /// The new depths of the fragments that have passed all tests.
    pub(crate) fn DEPTH_WRITE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        store(places!(b), &b.tex.mask, &b.z, w.band.depth);
    }
}
