//! What became of vertices and primitives. These sums are always kept: an addition for each batch and for each primitive
//! that is dropped costs nothing that can be measured.

use crate::simd::Counters;

/// Sums since counting began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VertexCounts {
    /// Vertices whose position was transformed.
    pub positions: u64,
    /// Vertices whose varyings were computed.
    pub varyings: u64,
    /// Primitives that are neither culled nor outside, before clipping.
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
        let Self { positions, varyings, seen, clipped, culled, outside } = std::mem::take(self);
        counters.vertices += positions;
        counters.vertices_valued += varyings;
        counters.primitives += seen;
        counters.clipped += clipped;
        counters.culled += culled;
        counters.outside += outside;
    }
}
