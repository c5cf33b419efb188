//! Triangles that have no vertex in common with others, in step with their batches (OpenGL 1.5, section 2.6.1): 48 vertices
//! are the 16 triangles of a group, so corners go from the lanes of the batch straight into those of the group. No vertex
//! is written down, and no triangle. Where some of a batch need more than that, it goes the long way, with the same result.

use super::batch::{LIST_VERTICES, needs};
use super::plan::VertexPlan;
use super::processor::VertexProcessor;
use super::stages::triangle_corners::CORNERS;
use crate::fragment::planes::GROUP;
use crate::raster::PrimitiveSink;

/// Triangles that must be seen: setting up what else a group has room for, or what nobody sees, is then less than what is
/// saved.
const ENOUGH: usize = GROUP / 2;

impl VertexProcessor {
    /// Does all there is to do with the batch if its vertices are triangles in step, which the caller says, and if nothing
    /// else keeps it from that. Otherwise the batch has been placed.
    pub fn run_triangle_list<S: PrimitiveSink>(
        &mut self,
        plan: &VertexPlan,
        triangles: bool,
        culls: [bool; 2],
        sink: &mut S,
    ) -> bool {
        let n = self.batch.n;
        let in_step = triangles && n.is_multiple_of(3) && (3 * ENOUGH..=LIST_VERTICES).contains(&n);
        let in_step = in_step && self.held() == 0 && plan.needs & needs::EDGE == 0;
        self.transform_positions(plan);
        in_step && self.hand_on_triangle_list(plan, culls, sink)
    }

    /// Hands the triangles of a batch on that has been placed and has at most [`LIST_VERTICES`] vertices, if they can be handed on
    /// as they are. False, and nothing done, if not.
    fn hand_on_triangle_list<S: PrimitiveSink>(&mut self, plan: &VertexPlan, culls: [bool; 2], sink: &mut S) -> bool {
        let Self { batch, counts, .. } = self;
        plan.run(&[plan.corner_positions, plan.cull(culls)], batch);
        let t = &batch.triangles;
        let (seen, outside, culled) = (t.seen.count_ones(), t.outside.count_ones(), t.culled.count_ones());
        if seen > 0 {
            if t.clipped != 0 || outside > 0 || (seen as usize) < ENOUGH || !sink.takes_batches(plan.layout.stride) {
                return false;
            }
            plan.run(plan.plan.steps.get(plan.position_stages..).unwrap_or_default(), batch);
            let corners = CORNERS.levels[plan.plan.level() as usize];
            let count = plan.layout.count;
            sink.take_batch(batch.n / 3, |to| {
                #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
                unsafe {
                    corners(batch, count, to);
                }
            });
            counts.valued += batch.n as u64;
        }
        counts.seen += u64::from(seen);
        counts.outside += u64::from(outside);
        counts.culled += u64::from(culled);
        true
    }
}
