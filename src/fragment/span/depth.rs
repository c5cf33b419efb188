//! The depth test on runs of a row (OpenGL 1.5, section 4.1.6): depth along a row, the test as the first stage of a
//! program, and what the coarse depth buffer is good for. Depth along a row is monotonic, rounding included, so the depths
//! at its two ends are its least and its greatest: a run whose nearest end lies behind what the coarse buffer says of its
//! blocks is skipped unread. After a run the blocks that it has touched are looked at again.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{Func, compare, holds, living};
use crate::fragment::planes::Linear;
use crate::fragment::reference::depth::{WRITE, depths, quantise, test, whole};
use crate::fragment::reference::lanes::{IOTA, ones, row_origin, single_row};
use crate::fragment::reference::places::{fresh_mask, write};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::framebuffer::{BLOCK, Band};
use crate::simd::{LANES, stage};

/// Depth along a row.
#[derive(Clone, Copy)]
pub(crate) struct Slope {
    at: f64,
    x: f64,
    max: f64,
    /// No depth that matters is to be limited.
    inside: bool,
}

impl Slope {
    /// Depth in the row y, relative to the primitive's origin.
    #[inline(always)]
    pub(crate) fn new(z: &Linear, y: i32, max: f64) -> Self {
        Self { at: z.at + z.y * f64::from(y), x: z.x, max, inside: false }
    }

    /// For the depths from x to `last`: where both ends lie within the limits, all between do, rounding included.
    #[inline(always)]
    pub(crate) fn between(self, x: i32, last: i32) -> Self {
        let within = |x: i32| {
            let z = self.at + self.x * f64::from(x);
            z >= 0.0 && z <= self.max
        };
        Self { inside: x <= last && within(x) && within(last), ..self }
    }

    /// The depth at x, relative to the primitive's origin.
    #[inline(always)]
    fn depth(&self, x: i32) -> u32 {
        quantise(self.at + self.x * f64::from(x), self.max)
    }

    /// The depths from x on.
    #[inline(always)]
    pub(crate) fn depths<const N: usize>(&self, x: i32, out: &mut [u32; N]) {
        if self.x == 0.0 {
            // (at + 0 x) is at, or at with the sign of a zero changed.
            *out = [quantise(self.at, self.max); N];
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
    fn least(&self, x: i32, last: i32) -> u32 {
        // Where a sum may be infinity less infinity, or x has wrapped, nothing is known.
        if !(self.at.is_finite() && self.x.is_finite()) || last < x {
            return 0;
        }
        let (a, b) = (self.depth(x), self.depth(last));
        if a < b { a } else { b }
    }
}

/// Whether fragments from `least` on fail the test against all depths up to `limit`.
#[inline(always)]
fn fails(func: Func, least: u32, limit: u32) -> bool {
    match func {
        Func::Less => least >= limit,
        Func::Lequal | Func::Equal => least > limit,
        _ => false,
    }
}

/// Whether the coarse depths are of use to a test: depths never rise, and what is behind them fails.
pub(crate) fn coarse(func: Func) -> bool {
    matches!(func, Func::Less | Func::Lequal | Func::Equal)
}

/// How many pixels of a run, from its start on, fail the test because their blocks are nearer.
#[inline(always)]
pub(crate) fn hiz_cull(band: &Band<'_>, run: &Segment, slope: &Slope, x: i32, func: Func) -> u32 {
    let Ok(start) = usize::try_from(run.x) else { return 0 };
    let least = slope.least(x, x.wrapping_add(run.len.wrapping_sub(1).cast_signed()));
    let end = start.saturating_add(run.len as usize);
    let mut at = start;
    for limit in band.hier_z.row(band.memory_row(run.y)).iter().skip(start / BLOCK) {
        if at >= end || !fails(func, least, *limit) {
            break;
        }
        at = (at / BLOCK + 1) * BLOCK;
    }
    at.min(end).wrapping_sub(start) as u32
}

/// Tells the coarse buffer of the blocks that the first `len` pixels of a run touch.
#[inline(always)]
pub(crate) fn hiz_update(band: &mut Band<'_>, run: &Segment, len: usize) {
    let (Ok(x), row) = (usize::try_from(run.x), band.memory_row(run.y)) else { return };
    let Some(start) = (run.offset as usize).checked_sub(x) else { return };
    let Some(depths) = band.depth.get(start..).map(|d| d.get(..band.width as usize).unwrap_or(d)) else { return };
    let (first, last) = (x / BLOCK, (x + len).div_ceil(BLOCK));
    for (block, depths) in depths.chunks(BLOCK).enumerate().take(last).skip(first) {
        let mut limit = 0;
        if let Some(depths) = depths.first_chunk::<BLOCK>() {
            for i in 0..BLOCK {
                limit = if depths[i] > limit { depths[i] } else { limit };
            }
        } else {
            for depth in depths {
                limit = limit.max(*depth);
            }
        }
        band.hier_z.set(row, block, limit);
    }
}

/// All ones in the first `n` lanes.
#[inline(always)]
pub(crate) fn lanes<const N: usize>(n: usize) -> [u32; N] {
    let mut mask = [0; N];
    for i in 0..N {
        mask[i] = ones(IOTA[i] < n as f32);
    }
    mask
}

/// The test on a batch of one row; false, and nothing done, where it is none or where the buffer ends within 64 pixels.
#[inline(always)]
fn row(b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) -> bool {
    let segment = b.segments[0];
    let n = if segment.len < LANES as u32 { segment.len } else { LANES as u32 };
    let Some(planes) = w.planes.get(segment.prim as usize) else { return false };
    let Some(depth) = w.band.depth.get_mut(segment.offset as usize..).and_then(|r| r.first_chunk_mut::<LANES>()) else {
        return false;
    };
    let func = Func::from_arg(arg >> 1);
    let (x, y) = row_origin(&segment, planes);
    let slope = Slope::new(&planes.z, y, u.depth_max);
    // Lanes of their own, written to the batch once: lanes that were just written through a mask are read again only when
    // they have reached the cache.
    let mut z = [0; LANES];
    slope.depths(x, &mut z);
    b.tex.n = n as usize;
    b.scattered = false;
    if n == LANES as u32 && holds(func, &z, depth) {
        b.alive = true;
        if arg & WRITE != 0 {
            *depth = z;
        }
        (b.z, b.tex.mask) = (z, [u32::MAX; LANES]);
        return true;
    }
    let mut mask = lanes(n as usize);
    compare(func, &z, depth, &mut mask);
    b.alive = living(&mask) != 0;
    if arg & WRITE != 0 && b.alive {
        write(false, &mask, &z, depth);
    }
    (b.z, b.tex.mask) = (z, mask);
    true
}

stage! {
    /// What [`BEGIN`](crate::fragment::reference::depth::BEGIN), [`DEPTH`](crate::fragment::reference::depth::DEPTH) and [`DEPTH_TEST`](crate::fragment::reference::depth::DEPTH_TEST)
    /// do one after the other, at once for batches of one row.
    pub(crate) fn EARLY_DEPTH: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        if single_row(b) && row(b, u, w, arg) {
            return;
        }
        fresh_mask(b);
        depths(b, u, w);
        test(b, w, arg);
    }

    /// How many pixels of the run of the first segment, of any length, may be skipped from its start on; in `tex.n`.
    pub(crate) fn HIZ_CULL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let segment = b.segments[0];
        b.tex.n = 0;
        if let Some(planes) = w.planes.get(segment.prim as usize) {
            let (x, y) = row_origin(&segment, planes);
            let slope = Slope::new(&planes.z, y, u.depth_max);
            b.tex.n = hiz_cull(w.band, &segment, &slope, x, Func::from_arg(arg >> 1)) as usize;
        }
    }

    /// Tells the coarse buffer of what the run of the first segment has left behind.
    pub(crate) fn HIZ_UPDATE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let run = b.segments[0];
        hiz_update(w.band, &run, run.len as usize);
    }
}
