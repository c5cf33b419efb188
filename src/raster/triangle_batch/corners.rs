//! The corners of a batch of triangles, a triangle a lane.

use crate::fragment::planes::GROUP;
use crate::raster::vertex::Vertex;

/// Most slots of the triangles in a batch: colours, fog and eight units of s, t, r and q.
pub const MOST_SLOTS: usize = 40;

/// Corners of 16 triangles.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct CornerLanes {
    /// w and window x, y, z of each corner, in the order of a vertex.
    pub position: [[[f64; GROUP]; 4]; 3],
    /// Snapped x and y of each corner.
    pub snapped: [[[i32; GROUP]; 2]; 3],
    /// Each slot at each corner.
    pub slots: [[[f32; GROUP]; 3]; MOST_SLOTS],
}

impl Default for CornerLanes {
    fn default() -> Self {
        Self { position: [[[0.0; GROUP]; 4]; 3], snapped: [[[0; GROUP]; 2]; 3], slots: [[[0.0; GROUP]; 3]; MOST_SLOTS] }
    }
}

impl CornerLanes {
    /// Copies the slots of a corner, as many as `to` has room for.
    pub(crate) fn slots(&self, lane: usize, corner: usize, to: &mut [f32]) {
        for (to, from) in to.iter_mut().zip(&self.slots) {
            *to = from[corner % 3][lane % GROUP];
        }
    }

    /// The vertex at a corner, as far as setup depends on it.
    pub(crate) fn vertex(&self, lane: usize, corner: usize) -> Vertex {
        let [w, x, y, z] = self.position[corner].map(|lanes| lanes[lane]);
        let snapped = self.snapped[corner].map(|lanes| lanes[lane]);
        Vertex { clip: [0.0, 0.0, 0.0, w], window: [x, y, z], snapped, ..Vertex::default() }
    }
}
