//! Setup of 16 filled triangles at once, a triangle a lane (OpenGL 1.5, section 3.5.1): facing and culling, coverage,
//! planes. Triangles of at most 8 by 8 pixels have a mask, those of at most 16 by 16 the ends of their rows; larger ones are
//! set up alone.
//!
//! Corners are stored one by one, their slots in quads: slots 0 to 3, 4 to 7 and so on, and the last four slots where the
//! number is no multiple of 4 (some slots are then in two quads). Before setup they are transposed into [`CornerLanes`],
//! unless they come in that form.

pub(super) mod corners;
pub(super) mod lanes;
pub(super) mod masks;
pub(super) mod planes;
mod queue;
pub(super) mod rows;

use crate::fragment::planes::GROUP;
use crate::raster::vertex::{VertexRef, Vertices};
use corners::{CornerLanes, MOST_SLOTS};
use lanes::{BasisLanes, F64x16, I32x16, LinearLanes, NOTHING};
use rows::{ROWS, RowEnds};

/// Triangles that are set up together, with all intermediate results.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct TriangleBatch {
    /// Slots of each corner.
    pub quads: [[[[f32; 4]; GROUP]; 3]; MOST_SLOTS / 4],
    /// w and window x, y, z of each corner, in the order of a vertex.
    pub position: [[[f64; 4]; GROUP]; 3],
    /// The same a triangle a lane, and the snapped positions.
    pub corners: CornerLanes,
    /// The first pixel of each bounding box, and the one after the last.
    pub first: [I32x16; 2],
    pub last: [I32x16; 2],
    /// What becomes of each triangle: see [`lanes`].
    pub kind: I32x16,
    /// Whether its bounding box reaches beyond what may be written.
    pub cut: I32x16,
    /// The masks, before clipping.
    pub bits: [u64; GROUP],
    /// The rows of triangles that are too large for a mask.
    pub ends: RowEnds,
    /// How many pixels those rows have.
    pub pixels: I32x16,
    pub area: I32x16,
    pub origin: [I32x16; 2],
    pub z: LinearLanes,
    /// The least and the greatest depth of a fragment.
    pub z_range: [F64x16; 2],
    pub bases: BasisLanes,
    pub affine: [bool; GROUP],
    /// NaN where the planes of a triangle must be made alone.
    pub needs_scalar: F64x16,
    /// How many triangles there are.
    pub count: usize,
}

impl Default for TriangleBatch {
    fn default() -> Self {
        Self {
            quads: [[[[0.0; 4]; GROUP]; 3]; MOST_SLOTS / 4],
            position: [[[0.0; 4]; GROUP]; 3],
            corners: CornerLanes::default(),
            first: [[0; GROUP]; 2],
            last: [[0; GROUP]; 2],
            kind: [NOTHING; GROUP],
            cut: [0; GROUP],
            bits: [0; GROUP],
            ends: [[0; GROUP]; ROWS],
            pixels: [0; GROUP],
            area: [0; GROUP],
            origin: [[0; GROUP]; 2],
            z: LinearLanes::default(),
            z_range: [[0.0; GROUP]; 2],
            bases: BasisLanes::default(),
            affine: [true; GROUP],
            needs_scalar: [0.0; GROUP],
            count: 0,
        }
    }
}

/// The quad that holds a slot of `count` slots, and where in it.
#[inline(always)]
pub(crate) const fn quad_of(count: usize, slot: usize) -> (usize, usize) {
    let whole = count / 4;
    if slot / 4 < whole {
        (slot / 4, slot % 4)
    } else if whole == 0 {
        (0, slot)
    } else {
        (whole, slot + 4 - count)
    }
}

impl TriangleBatch {
    /// Stores the slots of a triangle's corners. False where a vertex lacks some.
    #[inline]
    fn put_slots(&mut self, v: &[VertexRef<'_>; 3], count: usize) -> bool {
        let lane = self.count % GROUP;
        let [Some(a), Some(b), Some(c)] = v.map(|v| v.slots.get(..count)) else { return false };
        let ((a4, a), (b4, b), (c4, c)) = (a.as_chunks::<4>(), b.as_chunks::<4>(), c.as_chunks::<4>());
        for (quad, ((qa, qb), qc)) in self.quads.iter_mut().zip(a4.iter().zip(b4).zip(c4)) {
            quad[0][lane] = *qa;
            quad[1][lane] = *qb;
            quad[2][lane] = *qc;
        }
        let whole = count / 4;
        if let Some(quad) = self.quads.get_mut(whole).filter(|_| !count.is_multiple_of(4)) {
            for (corner, (v, rest)) in v.iter().zip([a, b, c]).enumerate() {
                if let Some(last) = count.checked_sub(4).and_then(|at| v.slots.get(at..)?.first_chunk()) {
                    quad[corner][lane] = *last;
                } else {
                    quad[corner][lane] = [0, 1, 2, 3].map(|k: usize| rest.get(k).copied().unwrap_or(0.0));
                }
            }
        }
        true
    }

    /// Stores triangles, as many as there is room for.
    #[inline]
    fn put(&mut self, vertices: &Vertices, triangles: &[[u32; 3]], count: usize) {
        let lanes = self.count..GROUP;
        for corner in 0..3 {
            let (position, [xs, ys]) = (&mut self.position[corner], &mut self.corners.snapped[corner]);
            for (ids, lane) in triangles.iter().zip(lanes.clone()) {
                let Some(v) = vertices.head.get(ids[corner] as usize) else { continue };
                let [x, y, z] = v.window;
                position[lane] = [v.clip[3], x, y, z];
                [xs[lane], ys[lane]] = v.snapped;
            }
            for (k, quad) in self.quads.iter_mut().enumerate().take(count.div_ceil(4)) {
                // The last quad may repeat slots of the one before it, or have more than the vertex has, which are not read.
                let from = (4 * k).min(count.max(4) - 4);
                for (ids, lane) in triangles.iter().zip(lanes.clone()) {
                    let at = ids[corner] as usize * vertices.stride + from;
                    if let Some(four) = vertices.slots.get(at..).and_then(<[f32]>::first_chunk) {
                        quad[corner][lane] = *four;
                    }
                }
            }
        }
        self.count = (self.count + triangles.len()).min(GROUP);
    }
}
