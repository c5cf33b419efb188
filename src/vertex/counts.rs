//! What a piece of a draw did with vertices and primitives. These sums are kept always: an addition for each batch and for
//! each primitive that is dropped costs nothing that could be measured.

use crate::simd::Counters;

/// Sums since counting began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VertexCounts {
    /// Vertices whose position was transformed.
    pub placed: u64,
    /// Vertices that were lit, and whose coordinates were made.
    pub valued: u64,
    /// Primitives that can be seen, before clipping.
    pub seen: u64,
    /// Those that had to be clipped.
    pub clipped: u64,
    /// Triangles that were culled.
    pub culled: u64,
    /// Primitives outside of the view volume.
    pub outside: u64,
}

impl VertexCounts {
    /// Moves the sums to counters.
    pub fn drain_into(&mut self, counters: &mut Counters) {
        let Self { placed, valued, seen, clipped, culled, outside } = std::mem::take(self);
        counters.vertices += placed;
        counters.vertices_valued += valued;
        counters.primitives += seen;
        counters.clipped += clipped;
        counters.culled += culled;
        counters.outside += outside;
    }
}
