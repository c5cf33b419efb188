//! The depth test as the first stage of a program (OpenGL 1.5, section 4.1.6), where nothing before it can kill a fragment:
//! a batch of one row needs no mask before it, and none after it where all fragments pass.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, compare, holds, living};
use crate::fragment::reference::depth::{DepthSlope, WRITE, depths, lanes, test};
use crate::fragment::reference::lanes::{row_origin, single_row};
use crate::fragment::reference::places::{fresh_mask, write};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};

/// The test on a batch of one row; false, and nothing done, where it is none or where the buffer ends within 64 pixels.
#[inline(always)]
fn row(b: &mut FragmentBatch, w: &mut Work<'_, '_>, arg: u32) -> bool {
    let segment = b.segments[0];
    let n = if segment.len < LANES as u32 { segment.len } else { LANES as u32 };
    let Some(planes) = w.planes.get(segment.prim as usize) else { return false };
    let Some(depth) = w.band.depth.get_mut(segment.offset as usize..).and_then(|r| r.first_chunk_mut::<LANES>()) else {
        return false;
    };
    let func = CompareFunc::from_arg(arg >> 1);
    let (x, y) = row_origin(&segment, planes);
    let slope = DepthSlope::new(planes, y);
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
    /// What [`BEGIN`](super::depth::BEGIN), [`DEPTH`](super::depth::DEPTH) and [`DEPTH_TEST`](super::depth::DEPTH_TEST)
    /// do one after the other, at once for batches of one row.
    pub fn EARLY_DEPTH: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        if single_row(b) && row(b, w, arg) {
            return;
        }
        fresh_mask(b);
        depths(b, w);
        test(b, w, arg);
    }
}
