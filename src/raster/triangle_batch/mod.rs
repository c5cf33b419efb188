//! Filled triangles wait for each other until there are as many as a group holds, and are then set up together, a triangle
//! a lane: facing and culling, masks, planes. Those that are not small (8 by 8 pixels) have edges in place of a mask, and the
//! large ones (above 16 by 16) are then set up alone. What waits is filed before anything else is, so that the order of
//! issue is kept.
//!
//! Corners come one by one, their slots in quads: those of slots 0 to 3, 4 to 7 and so on, and one of the last four slots
//! where their number is no multiple of 4 (then some are in two quads). They are turned into [`CornerLanes`], unless somebody
//! has them in that form already.

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

/// Triangles on their way to being filed.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct TriangleBatch {
    /// Slots of each corner.
    pub quads: [[[[f32; 4]; GROUP]; 3]; MOST_SLOTS / 4],
    /// w, window x, y and z of each corner, in the order of a vertex.
    pub position: [[[f64; 4]; GROUP]; 3],
    /// The same, and the snapped positions, a triangle a lane.
    pub corners: CornerLanes,
    /// The first pixel of each bounding box, and the one after the last.
    pub first: [I32x16; 2],
    pub last: [I32x16; 2],
    /// What becomes of each triangle.
    pub kind: I32x16,
    /// Whether its bounding box leaves what may be written.
    pub cut: I32x16,
    /// The result: covered pixels, before clipping.
    pub bits: [u64; GROUP],
    /// The rows of triangles that are too large for that.
    pub ends: RowEnds,
    /// How many pixels those cover.
    pub pixels: I32x16,
    pub area: I32x16,
    pub origin: [I32x16; 2],
    pub z: LinearLanes,
    pub bases: BasisLanes,
    pub affine: [bool; GROUP],
    /// NaN where a triangle must be done alone.
    pub odd: F64x16,
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
            bases: BasisLanes::default(),
            affine: [true; GROUP],
            odd: [0.0; GROUP],
            count: 0,
        }
    }
}

/// The quad that holds a slot of so many, and the slot's position in it.
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
    /// Puts the slots of a triangle's corners in place. False where a vertex lacks some.
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

    /// Puts triangles in place, as many as there is room for.
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
                // The last quad may have slots of the one before it, or more than the vertex has, which nobody reads.
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
