//! Culling (OpenGL 1.5, sections 2.12 and 2.13.1): outcodes and facing of 64 triangles at once, by the positions of their
//! corners alone.

use super::batch::{CullBatch, VertexBatch};
use super::stages::VertFn;
use super::uniforms::VertexUniforms;
use crate::raster::vertex::outcode;
use crate::simd::{LANES, stage};

/// Bits of the stage's argument, beside the outcode bits that make a triangle go through the clipper: triangles whose window
/// area is positive are culled; those whose area is not are culled.
pub const CULLS: [u32; 2] = [1 << 16, 1 << 17];

const SEEN: u64 = 1;
const CLIPPED: u64 = 2;
const OUTSIDE: u64 = 4;
const CULLED: u64 = 8;

/// Whether all corners are outside of one plane, or a vertex is NaN.
#[inline(always)]
pub fn is_outside(all: u64, any: u64) -> bool {
    const ANY: u64 = outcode::NAN as u64;
    const ALL: u64 = (outcode::FRUSTUM | outcode::USER_ALL) as u64;
    (all & ALL != 0) | (any & ANY != 0)
}

/// A bit for each lane whose fate has a bit.
#[inline(always)]
fn lanes_with(fate: &[u64; LANES], bit: u64) -> u64 {
    let mut bits = 0;
    for i in 0..LANES {
        bits |= u64::from(fate[i] & bit != 0) << i;
    }
    bits
}

stage! {
    /// What becomes of triangles.
    pub fn CULL: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, arg: u32) {
        let CullBatch { corners: [a, b, c], fate, n, seen, clipped, outside, culled } = &mut b.triangles;
        let clip_mask = u64::from(arg & 0xFFFF);
        let [positive, other] = CULLS.map(|bit| if arg & bit != 0 { CULLED } else { SEEN });
        for i in 0..n.next_multiple_of(16).min(LANES) {
            let any = a[i].0 | b[i].0 | c[i].0;
            let [p, q, r] = [a[i].snapped(), b[i].snapped(), c[i].snapped()];
            // Exact: products of numbers of 25 bits.
            let side = |v: [i32; 2], k: usize| f64::from(v[k] - p[k]);
            let area = side(q, 0) * side(r, 1) - side(r, 0) * side(q, 1);
            let facing = if area > 0.0 { positive } else { other };
            let inside = if any & clip_mask != 0 { SEEN | CLIPPED } else { facing };
            fate[i] = if is_outside(a[i].0 & b[i].0 & c[i].0, any) { OUTSIDE } else { inside };
        }
        let there = if *n < LANES { (1 << *n) - 1 } else { u64::MAX };
        *seen = lanes_with(fate, SEEN) & there;
        *clipped = lanes_with(fate, CLIPPED) & there;
        *outside = lanes_with(fate, OUTSIDE) & there;
        *culled = lanes_with(fate, CULLED) & there;
    }
}
