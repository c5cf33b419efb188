//! The corners of triangles that have no vertex in common (OpenGL 1.5, section 2.6.1): every third lane of a batch goes to
//! the lanes of a triangle batch.

use super::VertFn;
use crate::fragment::planes::GROUP;
use crate::raster::CornerLanes;
use crate::simd::{LANES, stage};
use crate::vertex::batch::VertexBatch;
use crate::vertex::uniforms::VertexUniforms;

/// Writes the corners of the triangles of a batch, with so many slots.
pub type CornersFn = unsafe fn(&VertexBatch, usize, &mut CornerLanes);

/// Every third lane.
#[inline(always)]
fn thirds<T: Copy>(from: &[T; LANES], [a, b, c]: [&mut [T; GROUP]; 3]) {
    for i in 0..GROUP {
        (a[i], b[i], c[i]) = (from[3 * i], from[3 * i + 1], from[3 * i + 2]);
    }
}

stage! {
    /// Positions of the corners of triangles.
    pub fn CORNER_POSITIONS: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, _arg: u32) {
        let VertexBatch { screen, triangles, .. } = b;
        let corners = triangles.corners.each_mut().map(|lanes| lanes.first_chunk_mut());
        if let [Some(a), Some(b), Some(c)] = corners {
            thirds(screen, [a, b, c]);
        }
        triangles.n = b.n / 3;
    }

    /// The corners of triangles.
    pub fn CORNERS: CornersFn = (b: &VertexBatch, count: usize, to: &mut CornerLanes) {
        let CornerLanes { position, snapped, slots } = to;
        let [[wa, xa, ya, za], [wb, xb, yb, zb], [wc, xc, yc, zc]] = position;
        thirds(&b.clip[3], [wa, wb, wc]);
        thirds(&b.window[0], [xa, xb, xc]);
        thirds(&b.window[1], [ya, yb, yc]);
        thirds(&b.window[2], [za, zb, zc]);
        for (snapped, places) in snapped.iter_mut().zip(&b.triangles.corners) {
            for i in 0..GROUP {
                [snapped[0][i], snapped[1][i]] = places[i].snapped();
            }
        }
        for (slot, lanes) in slots.iter_mut().zip(&b.out).take(count) {
            let [a, b, c] = slot;
            thirds(lanes, [a, b, c]);
        }
    }
}
