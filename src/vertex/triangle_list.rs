//! The fast path of separate triangles (OpenGL 1.5, section 2.6.1): 48 vertices are the 16 triangles of a triangle batch, so
//! corners go from the lanes of the vertex batch straight to those of the triangle batch, and neither vertices nor primitives
//! are stored. If a triangle of the batch must be clipped, or few are visible, the batch takes the general path, with the
//! same result.

use super::batch::{LIST_VERTICES, needs};
use super::plan::VertexPlan;
use super::processor::VertexProcessor;
use super::stages::triangle_corners::CORNERS;
use crate::fragment::planes::GROUP;
use crate::raster::PrimitiveSink;

/// Least visible triangles of a batch: with fewer, setting up lanes that draw nothing costs more than is saved.
const LEAST_VISIBLE: usize = GROUP / 2;

impl VertexProcessor {
    /// Transforms the positions of the batch. If its vertices are whole `triangles` of one list, draws them, if it can;
    /// false if it has not.
    pub fn run_triangle_list<S: PrimitiveSink>(
        &mut self,
        plan: &VertexPlan,
        triangles: bool,
        culls: [bool; 2],
        sink: &mut S,
    ) -> bool {
        let n = self.batch.n;
        let is_list = triangles && n.is_multiple_of(3) && (3 * LEAST_VISIBLE..=LIST_VERTICES).contains(&n);
        let is_list = is_list && self.held() == 0 && plan.needs & needs::EDGE == 0;
        self.transform_positions(plan);
        is_list && self.hand_on_triangle_list(plan, culls, sink)
    }

    /// Hands on the triangles of a batch of at most [`LIST_VERTICES`] transformed vertices, if none must be clipped. False,
    /// and nothing done, if not.
    fn hand_on_triangle_list<S: PrimitiveSink>(&mut self, plan: &VertexPlan, culls: [bool; 2], sink: &mut S) -> bool {
        let Self { batch, counts, .. } = self;
        plan.run(&[plan.corner_positions, plan.cull(culls)], batch);
        let t = &batch.triangles;
        let (seen, outside, culled) = (t.seen.count_ones(), t.outside.count_ones(), t.culled.count_ones());
        if seen > 0 {
            if t.clipped != 0
                || outside > 0
                || (seen as usize) < LEAST_VISIBLE
                || !sink.takes_batches(plan.layout.stride)
            {
                return false;
            }
            plan.run(plan.plan.steps.get(plan.position_stages..).unwrap_or_default(), batch);
            let corners = CORNERS.at(plan.plan.level());
            let count = plan.layout.count;
            sink.take_batch(batch.n / 3, |to| {
                #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
                unsafe {
                    corners(batch, count, to);
                }
            });
            counts.varyings += batch.n as u64;
        }
        counts.seen += u64::from(seen);
        counts.outside += u64::from(outside);
        counts.culled += u64::from(culled);
        true
    }
}
