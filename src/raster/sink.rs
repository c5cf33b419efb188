//! Where assembled and clipped primitives go: a scene, or whatever else wants them in place of pixels.

use super::triangle_batch::corners::CornerLanes;
use super::vertex::VertexRef;

/// Takes primitives that need no clipping.
pub trait PrimitiveSink {
    /// A triangle of three vertices in the order of issue. Under flat shading the colour is that of the `provoking` one;
    /// `edges[i]` says whether the edge from corner i to the next is a boundary edge of its polygon.
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]);
    /// A line.
    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize);
    /// The line stipple starts anew: after Begin, and before each line of `GL_LINES`.
    fn restart_stipple(&mut self);
    /// A point, of its vertex's point size.
    fn point(&mut self, vertex: VertexRef<'_>);
    /// Whether triangles whose window area is positive (counter-clockwise), and those whose area is not, draw nothing.
    /// They need not be handed on.
    fn culls(&self) -> [bool; 2] {
        [false; 2]
    }
    /// Whether [`take_batch`](Self::take_batch) may be called for vertices of so many slots.
    fn takes_batches(&mut self, _stride: usize) -> bool {
        false
    }
    /// Takes `count` triangles, at most 16, whose corners `fill` writes, a triangle a lane.
    fn take_batch(&mut self, _count: usize, _fill: impl FnOnce(&mut CornerLanes)) {}
}
