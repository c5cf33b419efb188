//! A draw: one state of the machine as rasterisation sees it, and the builder that takes its primitives.

use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::setup::SetupContext;
use super::setup::line::LineInput;
use super::setup::pixel_rect::BitmapBlock;
use super::setup::planes::SetupPlan;
use super::setup::point::PointInput;
use super::setup::triangle::TriangleInput;
use super::sink::PrimitiveSink;
use super::state::{RasterState, Rect};
use super::triangle_batch::corners::CornerLanes;
use super::vertex::VertexRef;
use super::vertex::Vertices;
use std::sync::Arc;

/// One state of the machine as the back end sees it.
#[derive(Debug)]
pub struct Draw<P> {
    /// What happens to fragments.
    pub program: Arc<P>,
    /// How primitives become fragments.
    pub raster: RasterState,
}

impl<P: FragmentProgram> Draw<P> {
    /// Whether triangles are culled, or come to nothing, whose area in the window is positive (counter-clockwise), or is
    /// not.
    #[must_use]
    pub fn culls(&self) -> [bool; 2] {
        let nothing = self.program.draws_nothing();
        self.raster.culls().map(|culls| nothing || culls)
    }
}

/// What the primitives of a draw are set up with, and where they are kept.
#[derive(Debug)]
pub struct PrimitiveBuilder<'a, P> {
    draw: &'a Draw<P>,
    cx: SetupContext<'a>,
    geometry: &'a mut SceneGeometry,
    stipple: &'a mut u32,
}

impl<'a, P> PrimitiveBuilder<'a, P> {
    /// For the draw that has an index.
    #[inline]
    pub(super) fn new(
        draw: &'a Draw<P>,
        index: u32,
        plan: &'a SetupPlan,
        geometry: &'a mut SceneGeometry,
        stipple: &'a mut u32,
    ) -> Self {
        Self { draw, cx: SetupContext { rs: &draw.raster, plan, draw: index }, geometry, stipple }
    }

    /// Sets up the triangles that wait in the batch.
    pub(super) fn flush_batch(&mut self) {
        self.geometry.flush_batch(&self.cx);
    }

    /// Whether whole batches of triangles may be handed on ([`Self::triangles`], [`PrimitiveSink::take_batch`]), of
    /// vertices with so many slots.
    #[must_use]
    pub fn can_batch(&self, stride: usize) -> bool {
        SceneGeometry::can_batch(&self.cx, stride)
    }

    /// Draws a pixel rectangle at a raster position; its pixels must lie within the clip rectangle. `memory` is what the
    /// image of its program takes, in bytes.
    pub fn pixel_rect(&mut self, position: VertexRef<'_>, rect: Rect, memory: usize) {
        self.flush_batch();
        self.geometry.pixel_rect(&self.cx, position, rect, memory);
    }

    /// Draws blocks of a bitmap with the values of a raster position.
    pub fn bitmap(&mut self, position: VertexRef<'_>, blocks: impl Iterator<Item = BitmapBlock>) {
        self.flush_batch();
        self.geometry.bitmap(&self.cx, position, blocks);
    }

    /// Draws triangles whose corners are some of many vertices; none must need clipping.
    pub fn triangles(&mut self, vertices: &Vertices, triangles: &[[u32; 3]]) {
        self.geometry.queue_all(&self.cx, vertices, triangles);
    }
}

impl<P: FragmentProgram> PrimitiveSink for PrimitiveBuilder<'_, P> {
    #[inline]
    fn triangle(&mut self, [a, b, c]: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        // Corner by corner: an index into the array would have it written and read again at once.
        let provoking = match provoking {
            0 => a.slots,
            1 => b.slots,
            _ => c.slots,
        };
        self.geometry.triangle(&self.cx, &TriangleInput { v: [a, b, c], provoking, edges }, self.stipple);
    }

    fn line(&mut self, v: [VertexRef<'_>; 2], provoking: usize) {
        self.flush_batch();
        let provoking = if provoking == 0 { v[0].slots } else { v[1].slots };
        self.geometry.line(&self.cx, &LineInput { v, provoking, back: false, offset: 0.0 }, self.stipple);
    }

    fn restart_stipple(&mut self) {
        *self.stipple = 0;
    }

    fn point(&mut self, v: VertexRef<'_>) {
        self.flush_batch();
        self.geometry.point(&self.cx, &PointInput::front(v));
    }

    fn culls(&self) -> [bool; 2] {
        self.draw.culls()
    }

    fn takes_batches(&mut self, stride: usize) -> bool {
        self.can_batch(stride)
    }

    fn take_batch(&mut self, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        self.geometry.add_lanes(&self.cx, count, fill);
    }
}
