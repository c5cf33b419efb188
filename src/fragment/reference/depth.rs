//! Depth (OpenGL 1.5, sections 3.5.5 end and 4.1.6): the window depth of each fragment as an integer of the depth buffer,
//! and the depth test. Depth is linear in the window, so it is summed in `f64` and rounded once; the same primitive drawn
//! with other state gets the same integers, which EQUAL relies on.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, any, compare, ones};
use crate::fragment::plane_eval::{IOTA, LinearEval, sums};
use crate::fragment::planes::Planes;
use crate::fragment::reference::lanes::{CHUNK, pieces, positions, put, row_origin, single_row};
use crate::fragment::reference::places::{fresh_mask, load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};

/// 2^52: a float whose unit in the last place is 1, so that the low half of its bits is the rounded integer.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// A depth as an integer of the buffer: limited to a range (NaN gives its least), rounded to the nearest, ties to even.
#[inline(always)]
pub fn quantise(z: f64, [low, high]: [f64; 2]) -> u32 {
    let z = if z > low { z } else { low };
    let z = if z < high { z } else { high };
    whole(z)
}

/// A depth that is within the limits, rounded.
#[inline(always)]
pub fn whole(z: f64) -> u32 {
    (z + WHOLE).to_bits() as u32
}

/// Bit of [`DEPTH_TEST`]'s number: depths are written. The function stands above it.
pub const WRITE: u32 = 1;

/// Depth along a row.
#[derive(Clone, Copy)]
pub struct DepthSlope {
    at: f64,
    x: f64,
    range: [f64; 2],
    /// No depth that matters is to be limited.
    inside: bool,
}

impl DepthSlope {
    /// Depth of a primitive in the row y, relative to its origin.
    #[inline(always)]
    pub fn new(of: &Planes, y: i32) -> Self {
        Self { at: of.z.at + of.z.y * f64::from(y), x: of.z.x, range: of.z_range, inside: false }
    }

    /// For the depths from x to `last`: where both ends lie within the limits, all between do, rounding included.
    #[inline(always)]
    pub fn between(self, x: i32, last: i32) -> Self {
        let within = |x: i32| {
            let z = self.at + self.x * f64::from(x);
            z >= self.range[0] && z <= self.range[1]
        };
        Self { inside: x <= last && within(x) && within(last), ..self }
    }

    /// The depth at x, relative to the primitive's origin.
    #[inline(always)]
    pub fn depth(&self, x: i32) -> u32 {
        quantise(self.at + self.x * f64::from(x), self.range)
    }

    /// The depths from x on.
    #[inline(always)]
    pub fn depths<const N: usize>(&self, x: i32, out: &mut [u32; N]) {
        if self.x == 0.0 {
            // (at + 0 x) is at, or at with the sign of a zero changed.
            *out = [quantise(self.at, self.range); N];
        } else if self.inside {
            for i in 0..N {
                out[i] = whole(self.at + self.x * f64::from(x.wrapping_add(i as i32)));
            }
        } else {
            for i in 0..N {
                out[i] = self.depth(x.wrapping_add(i as i32));
            }
        }
    }

    /// The least depth from x to `last`.
    #[inline(always)]
    pub fn least(&self, x: i32, last: i32) -> u32 {
        // Where a sum may be infinity less infinity, or x has wrapped, nothing is known.
        if !(self.at.is_finite() && self.x.is_finite()) || last < x {
            return 0;
        }
        let (a, b) = (self.depth(x), self.depth(last));
        if a < b { a } else { b }
    }
}

/// All ones in the first `n` lanes.
#[inline(always)]
pub fn lanes<const N: usize>(n: usize) -> [u32; N] {
    let mut mask = [0; N];
    for i in 0..N {
        mask[i] = ones(IOTA[i] < n as f32);
    }
    mask
}

/// The depth of each fragment.
#[inline(always)]
pub fn depths(b: &mut FragmentBatch, w: &Work<'_, '_>) {
    if single_row(b)
        && let Some(planes) = w.planes.get(b.segments[0].prim as usize)
    {
        let (x0, y) = row_origin(&b.segments[0], planes);
        DepthSlope::new(planes, y).depths(x0, &mut b.z);
        return;
    }
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        let Some(planes) = w.planes.get(segment.prim as usize) else { continue };
        for piece in pieces(&segment) {
            let at = positions((&b.dx, &b.dy), &segment, planes, piece);
            let z = sums(&LinearEval::<f64>::new(&planes.z, None), &at);
            let mut out = [0; CHUNK];
            for i in 0..CHUNK {
                out[i] = quantise(z[i], planes.z_range);
            }
            put(&mut b.z, piece, &out);
        }
    }
}

/// The depth test, and with [`WRITE`] the new depths of the fragments that pass.
#[inline(always)]
pub fn test(b: &mut FragmentBatch, w: &mut Work<'_, '_>, arg: u32) {
    load(places!(b), w.band.depth, &mut b.depth);
    compare(CompareFunc::from_arg(arg >> 1), &b.z, &b.depth, &mut b.tex.mask);
    b.alive = any(&b.tex.mask);
    if arg & WRITE != 0 && b.alive {
        store(places!(b), &b.tex.mask, &b.z, w.band.depth);
    }
}

stage! {
    /// All lanes in use are alive.
    pub fn BEGIN: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        fresh_mask(b);
    }

    /// The depth of each fragment.
    pub fn DEPTH: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        depths(b, w);
    }

    /// The depth test, and with [`WRITE`] the new depths of the fragments that pass.
    pub fn DEPTH_TEST: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        test(b, w, arg);
    }

    /// Counts the fragments that passed, for an occlusion query.
    pub fn COUNT_SAMPLES: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut passed = 0;
        for m in &b.tex.mask {
            passed += m & 1;
        }
        w.band.samples = w.band.samples.wrapping_add(u64::from(passed));
    }

    /// The new depths of the fragments that have passed all tests.
    pub fn DEPTH_WRITE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        store(places!(b), &b.tex.mask, &b.z, w.band.depth);
    }
}
