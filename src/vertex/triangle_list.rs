//! Triangles that have no vertex in common with others, in step with their batches (OpenGL 1.5, section 2.6.1): 48 vertices
//! are the 16 triangles of a group, so corners go from the lanes of the batch straight into those of the group. No vertex
//! is written down, and no triangle. Where some of a batch need more than that, it goes the long way, with the same result.

use super::Assembled;
use super::batch::{VertexBatch, needs};
use super::plan::{VertFn, VertexPlan};
use super::processor::{VertexProcessor, run};
use super::uniforms::VertexUniforms;
use crate::enums::{GL_TRIANGLES, GLenum};
use crate::fragment::planes::GROUP;
use crate::raster::CornerLanes;
use crate::simd::{LANES, stage};

/// Vertices of a batch that is in step.
pub const LIST_VERTICES: usize = 3 * GROUP;
/// Triangles that must be seen: setting up what else a group has room for, or what nobody sees, is then less than what is
/// saved.
const ENOUGH: usize = GROUP / 2;

/// How many vertices of a primitive are best taken at a time.
#[must_use]
pub const fn block(mode: GLenum) -> usize {
    if mode == GL_TRIANGLES { LIST_VERTICES } else { LANES }
}

/// Puts so many slots, and all else, of the triangles of a batch in place.
type CornersFn = unsafe fn(&VertexBatch, usize, &mut CornerLanes);

/// Every third lane.
#[inline(always)]
fn thirds<T: Copy>(from: &[T; LANES], [a, b, c]: [&mut [T; GROUP]; 3]) {
    for i in 0..GROUP {
        (a[i], b[i], c[i]) = (from[3 * i], from[3 * i + 1], from[3 * i + 2]);
    }
}

stage! {
    /// Where the corners of triangles are.
    pub fn CORNER_POSITIONS: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, _arg: u32) {
        let VertexBatch { screen, triangles, .. } = b;
        let corners = triangles.corners.each_mut().map(|lanes| lanes.first_chunk_mut());
        if let [Some(a), Some(b), Some(c)] = corners {
            thirds(screen, [a, b, c]);
        }
        triangles.n = b.n / 3;
    }

    /// The corners of triangles.
    fn CORNERS: CornersFn = (b: &VertexBatch, count: usize, to: &mut CornerLanes) {
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

impl VertexProcessor {
    /// Does all there is to do with the batch if its vertices are triangles in step, which the caller says, and if nothing
    /// else keeps it from that. Otherwise the batch has been placed.
    pub fn run_triangle_list<S: Assembled>(
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
    fn hand_on_triangle_list<S: Assembled>(&mut self, plan: &VertexPlan, culls: [bool; 2], sink: &mut S) -> bool {
        let Self { batch, counts, .. } = self;
        run(plan, &[plan.corner_positions, plan.cull(culls)], batch);
        let t = &batch.triangles;
        let (seen, outside, culled) = (t.seen.count_ones(), t.outside.count_ones(), t.culled.count_ones());
        if seen > 0 {
            if t.clipped != 0 || outside > 0 || (seen as usize) < ENOUGH || !sink.takes_groups(plan.layout.stride) {
                return false;
            }
            run(plan, plan.plan.steps.get(plan.position_stages..).unwrap_or_default(), batch);
            let corners = CORNERS.levels[plan.plan.level() as usize];
            let count = plan.layout.count;
            sink.take_group(batch.n / 3, |to| {
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
