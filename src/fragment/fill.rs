//! Fill: runs of a row, of any length, of programs that do nothing but test depth (OpenGL 1.5, section 4.1.6) and store an
//! interpolated colour. One stage does it all, block by block, without a batch in between: depth is computed, compared and
//! written, then the colour of what passed is computed and written. Blocks are of 64 pixels, the last of a run of 16.
//! Every number comes from the same expressions as in the stages of batches, so the bits are the same.

use super::batch::FragmentBatch;
use super::compare::{Func, all, any, compare};
use super::depth::{Slope, WRITE};
use super::interpolate::primitive;
use super::pack::Paint;
use super::segments::{IOTA, Lane, ones, row_origin};
use super::uniforms::{FragFn, FragUniforms, Work};
use crate::batch::{LANES, stage};

/// Bits of [`FILL`]'s number above those of the depth test: depth is tested, colour is written.
pub(super) const DEPTH: u32 = 1 << 4;
pub(super) const COLOR: u32 = 1 << 5;

/// Pixels of the last blocks of a run.
const SHORT: usize = 16;

/// What all blocks of a run need.
struct Run {
    depth: Option<(Slope, Func, bool)>,
    paint: Option<Paint>,
}

impl Run {
    /// `N` pixels from `at` on, of which the first `n` are of the run; lane 0 is at `x`, relative to the primitive's
    /// origin. False, and nothing done, where the buffers end before the block does.
    #[inline(always)]
    fn block<const N: usize>(&self, w: &mut Work<'_, '_>, at: usize, x: i32, n: usize) -> bool {
        let mut mask = [0; N];
        for (mask, i) in mask.iter_mut().zip(IOTA) {
            *mask = ones(i < n as f32);
        }
        let color = match &self.paint {
            Some(paint) => match w.band.rgba8.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) {
                Some(pixels) => Some((paint, pixels)),
                None => return false,
            },
            None => None,
        };
        if let Some((slope, func, write)) = &self.depth {
            let Some(depth) = w.band.depth.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) else { return false };
            let mut z = [0; N];
            slope.depths(x, &mut z);
            compare(*func, &z, depth, &mut mask);
            if !any(&mask) {
                return true;
            }
            if *write {
                put(&mask, &z, depth);
            }
        }
        if let Some((paint, pixels)) = color {
            let mut packed = [0; N];
            paint.pixels(x, &mut packed);
            put(&mask, &packed, pixels);
        }
        true
    }
}

/// Writes where the mask is set.
#[inline(always)]
fn put<const N: usize>(mask: &[u32; N], from: &[u32; N], to: &mut [u32; N]) {
    if all(mask) {
        *to = *from;
    } else {
        for i in 0..N {
            to[i] = u32::select(mask[i], from[i], to[i]);
        }
    }
}

stage! {
    /// The run of the first segment; leaves in `tex.n` how many of its pixels it has done. The rest, which is at the end of
    /// the buffers or of a primitive whose planes need `f64`, must go through batches.
    pub(super) fn FILL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        b.tex.n = 0;
        let segment = b.segments[0];
        let Some(planes) = w.planes.get(segment.prim as usize) else { return };
        let (x, y) = row_origin(&segment, planes);
        let mut paint = None;
        if arg & COLOR != 0 {
            let planes = u.layout.color.and_then(|slot| primitive::<4>(w, &segment, slot));
            paint = planes.and_then(|(planes, pool)| Paint::new(planes, pool, y, u.packed_or));
            if paint.is_none() {
                return;
            }
        }
        let depth = if arg & DEPTH == 0 {
            None
        } else {
            Some((Slope::new(&planes.z, y, u.depth_max), Func::from_arg(arg >> 1), arg & WRITE != 0))
        };
        let len = segment.len as usize;
        let at = segment.offset as usize;
        if depth.is_none() && let Some(Paint::Flat(packed)) = paint {
            if let Some(pixels) = w.band.rgba8.get_mut(at..at + len) {
                pixels.fill(packed);
                b.tex.n = len;
            }
            return;
        }
        let run = Run { depth, paint };
        let mut done = 0;
        while len - done >= LANES {
            if !run.block::<LANES>(w, at + done, x.wrapping_add(done as i32), LANES) {
                break;
            }
            done += LANES;
        }
        while len > done {
            let n = if len - done > SHORT { SHORT } else { len - done };
            if !run.block::<SHORT>(w, at + done, x.wrapping_add(done as i32), n) {
                break;
            }
            done += n;
        }
        b.tex.n = done;
    }
}
