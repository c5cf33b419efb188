//! The queue of filled triangles: they wait in the batch until it is full, and are then set up together. The batch is flushed
//! before any other primitive is added, so that the order of issue is kept.

use super::corners::{CornerLanes, MOST_SLOTS};
use super::lanes::{ALONE, LinearLanes, MASK, NOTHING};
use super::planes::BatchState;
use super::rows::RowCoverage;
use super::{TriangleBatch, quad_of};
use crate::fragment::planes::{GROUP, Linear, Planes};
use crate::raster::geometry::{Coverage, Prim, SceneGeometry, index};
use crate::raster::setup::SetupContext;
use crate::raster::setup::triangle::{TriangleInput, clip_mask};
use crate::raster::state::Rect;
use crate::raster::vertex::{VertexRef, Vertices, twice_area};
use crate::state::raster::PolygonMode;

impl TriangleBatch {
    /// Replaces the colours where they are not those of the corners: flat shading, back faces.
    fn put_colors(&mut self, cx: &SetupContext, t: &TriangleInput, back: bool) {
        let lane = self.count % GROUP;
        let layout = cx.plan.layout();
        for (to, from, n) in cx.plan.color_slots(back) {
            for k in 0..n {
                let (quad, column) = quad_of(layout.count, to + k);
                for (corner, v) in t.v.iter().enumerate() {
                    let slots = if cx.rs.flat { t.provoking } else { v.slots };
                    if let (Some(quad), Some(value)) = (self.quads.get_mut(quad), slots.get(from + k)) {
                        quad[corner][lane][column & 3] = *value;
                    }
                }
            }
        }
    }
}

impl SceneGeometry {
    /// Queues a filled triangle. False, and nothing done, where a vertex lacks slots.
    #[inline]
    pub(crate) fn queue(&mut self, cx: &SetupContext, t: &TriangleInput) -> bool {
        let batch = &mut *self.batch;
        let lane = batch.count % GROUP;
        let layout = cx.plan.layout();
        if !batch.put_slots(&t.v, layout.count) {
            return false;
        }
        if cx.rs.flat || layout.back.is_some() {
            let area = twice_area(&t.v.map(|v| v.head.snapped));
            batch.put_colors(cx, t, area == 0 || (area > 0) != cx.rs.ccw_is_front);
        }
        for (corner, v) in t.v.iter().enumerate() {
            let [x, y, z] = v.head.window;
            batch.position[corner][lane] = [v.head.clip[3], x, y, z];
            for k in 0..2 {
                batch.corners.snapped[corner][k][lane] = v.head.snapped[k];
            }
        }
        batch.count += 1;
        if batch.count == GROUP {
            self.set_up_batch(cx);
        }
        true
    }

    /// Whether triangles may be queued [many at a time](Self::queue_all): where each corner has its own colours.
    pub(crate) fn can_batch(cx: &SetupContext, stride: usize) -> bool {
        let layout = cx.plan.layout();
        cx.plan.is_batched() && !cx.rs.flat && layout.back.is_none() && layout.count <= stride
    }

    /// Queues filled triangles by the indices of their corners.
    pub(crate) fn queue_all(&mut self, cx: &SetupContext, vertices: &Vertices, triangles: &[[u32; 3]]) {
        let mut rest = triangles;
        while !rest.is_empty() {
            let free = GROUP - self.batch.count % GROUP;
            let (now, later) = rest.split_at(free.min(rest.len()));
            self.batch.put(vertices, now, cx.plan.layout().count);
            rest = later;
            if self.batch.count == GROUP {
                self.set_up_batch(cx);
            }
        }
    }

    /// Sets up the triangles that wait.
    pub(crate) fn flush_batch(&mut self, cx: &SetupContext) {
        if self.batch.count > 0 {
            self.set_up_batch(cx);
        }
    }

    /// Sets up `count` triangles, whose corners `fill` writes to the first lanes.
    pub(crate) fn add_lanes(&mut self, cx: &SetupContext, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        self.flush_batch(cx);
        fill(&mut self.batch.corners);
        self.set_up_lanes(cx, count.min(GROUP));
    }

    fn set_up_batch(&mut self, cx: &SetupContext) {
        let count = std::mem::take(&mut self.batch.count).min(GROUP);
        cx.plan.transpose(&mut self.batch);
        self.set_up_lanes(cx, count);
    }

    /// Sets up the triangles of the first lanes.
    fn set_up_lanes(&mut self, cx: &SetupContext, count: usize) {
        let rs = cx.rs;
        let offset = rs.offset[PolygonMode::Fill as usize].then_some([rs.offset_factor, rs.offset_units]);
        let (ccw, cw) = if rs.ccw_is_front { (0, 1) } else { (1, 0) };
        let culls = [rs.cull[ccw], rs.cull[cw]];
        let (first, planes) = self.pool.more_groups(cx.plan.layout().count);
        cx.plan.set_up_batch(
            &mut self.batch,
            &BatchState { area: rs.area, culls, scale: rs.depth_scale, offset },
            planes,
        );
        let mut used = false;
        for lane in 0..count {
            match self.batch.kind[lane] {
                NOTHING => {}
                ALONE => self.set_up_alone(cx, lane),
                kind => used |= self.push_member(cx, lane, first, kind),
            }
        }
        if !used {
            self.pool.drop_groups(first);
        }
    }

    /// Adds the triangle of a lane, with planes that begin at `first`. False where it has no pixel.
    #[inline]
    fn push_member(&mut self, cx: &SetupContext, lane: usize, first: u32, kind: i32) -> bool {
        let batch = &*self.batch;
        let [x, y] = [batch.first[0][lane], batch.first[1][lane]];
        let bounds = Rect { x0: x, y0: y, x1: batch.last[0][lane], y1: batch.last[1][lane] };
        let (cover, pixels) = if kind == MASK {
            let mut bits = batch.bits[lane];
            if batch.cut[lane] != 0 || cx.rs.polygon_stipple.is_some() {
                bits &= clip_mask(cx, bounds, bounds.and(cx.rs.area));
            }
            if bits == 0 {
                return false;
            }
            (Coverage::Mask { x, y, bits }, u64::from(bits.count_ones()))
        } else {
            let mut pixels = u64::from(batch.pixels[lane].unsigned_abs());
            if pixels == 0 {
                return false;
            }
            // Built in the vector: a local variable would be read back by wide loads before its narrow stores have
            // finished.
            self.blocks.push(RowCoverage::new([x, y], bounds.y1 - bounds.y0));
            if let Some(rows) = self.blocks.last_mut() {
                rows.take(&batch.ends, lane);
                if batch.cut[lane] != 0 {
                    pixels = rows.cut(bounds.and(cx.rs.area));
                }
            }
            if pixels == 0 {
                self.blocks.pop();
                return false;
            }
            (Coverage::Rows(index(self.blocks.len() - 1)), pixels)
        };
        let batch = &*self.batch;
        if batch.needs_scalar[lane].is_nan() {
            let planes = self.with_lane(cx, lane, |geometry, t, area| {
                geometry.triangle_planes(cx, t, area, false, PolygonMode::Fill)
            });
            self.push(cover, cx.draw, planes, pixels);
            return true;
        }
        // Built in the vector, for the same reason.
        let of = |l: &LinearLanes| Linear { at: l.at[lane], x: l.x[lane], y: l.y[lane] };
        self.prims.push(Prim { cover, draw: cx.draw });
        self.pixels += pixels;
        self.planes.push(Planes {
            origin: [batch.origin[0][lane], batch.origin[1][lane]],
            z: of(&batch.z),
            z_range: [batch.z_range[0][lane], batch.z_range[1][lane]],
            d: of(&batch.bases.d),
            affine: batch.affine[lane],
            back: (batch.area[lane] > 0) != cx.rs.ccw_is_front,
            wide: 0,
            first,
            member: Some(lane as u8),
        });
        true
    }

    /// Sets up the triangle of a lane alone: it is too large for the batch.
    fn set_up_alone(&mut self, cx: &SetupContext, lane: usize) {
        self.with_lane(cx, lane, |geometry, t, area| {
            let back = area == 0 || (area > 0) != cx.rs.ccw_is_front;
            if !cx.rs.cull[usize::from(back)] {
                geometry.fill(cx, t, t.v.map(|v| v.head.snapped), area, false);
            }
        });
    }

    /// Calls `run` with the triangle of a lane and its area. Its colours are already those of the visible side and of the
    /// provoking vertex.
    fn with_lane<T>(
        &mut self,
        cx: &SetupContext,
        lane: usize,
        run: impl FnOnce(&mut Self, &TriangleInput, i64) -> T,
    ) -> T {
        let count = cx.plan.layout().count;
        let corners = &self.batch.corners;
        let vertex = [0, 1, 2].map(|corner| corners.vertex(lane, corner));
        let mut room = [0.0; 3 * MOST_SLOTS];
        let count = count.min(MOST_SLOTS);
        for (corner, to) in room.chunks_exact_mut(count.max(1)).enumerate().take(3) {
            corners.slots(lane, corner, to);
        }
        let slots = |corner: usize| room.get(corner * count..(corner + 1) * count).unwrap_or_default();
        let v = [0, 1, 2].map(|corner: usize| VertexRef { head: &vertex[corner], slots: slots(corner) });
        let t = TriangleInput { v, provoking: v[2].slots, edges: [true; 3] };
        run(self, &t, twice_area(&v.map(|v| v.head.snapped)))
    }
}

#[cfg(test)]
mod tests {
    use crate::fragment::planes::{Layout, UnitSlots};
    use crate::raster::testing::{Random, TestCanvas, vertex};
    use crate::raster::vertex::{Vertex, Vertices};
    use crate::simd::Level;
    use crate::state::State;
    use crate::state::lighting::ShadeModel;

    /// Colours, fog, a unit of two coordinates and a cube map; or only the first of that.
    fn layouts() -> [Layout; 5] {
        let plane = UnitSlots { base: 8, count: 2, has_q: false, period: [1, 2, 0], size: [64; 3], cube: false };
        let cube = UnitSlots { base: 10, count: 3, has_q: false, period: [0; 3], size: [256; 3], cube: true };
        let mut all = Layout { color: Some(0), secondary: Some(4), fog: Some(7), ..Layout::default() };
        (all.units[0], all.units[2]) = (Some(plane), Some(cube));
        (all.count, all.back, all.stride) = (13, Some(13), 20);
        let mut unit = Layout { count: 2, stride: 2, ..Layout::default() };
        unit.units[1] = Some(UnitSlots { base: 0, period: [1; 3], ..plane });
        let color = Layout { color: Some(0), count: 4, stride: 4, ..Layout::default() };
        // Five slots: the last quad repeats slots of the colour.
        let fog = Layout { fog: Some(4), count: 5, stride: 5, ..color.clone() };
        [all, unit, color, fog, Layout { count: 1, stride: 1, ..Layout::default() }]
    }

    /// A small triangle: sometimes in perspective, sometimes a sliver, sometimes with infinite values or NaN.
    fn triangle(random: &mut Random, stride: usize) -> ([Vertex; 3], [Vec<f32>; 3]) {
        let size = [1.5, 4.0, 7.9, 12.0, 16.5, 30.0][(random.unit() * 6.0) as usize];
        let at = [0; 2].map(|_| random.between(-4.0, 60.0));
        let ratio = [1.0, 1.0, 1.5, 100.0, 1e7][(random.unit() * 5.0) as usize];
        let range = [0.0, 1.0, 1.0, 1000.0, 1e7, 1e38][(random.unit() * 6.0) as usize];
        let odd = [0.5f32, f32::NAN, f32::INFINITY, -0.0][(random.unit() * 4.0) as usize];
        let v = [0; 3].map(|_| {
            let [x, y] = at.map(|at| at + random.between(0.0, size));
            let z = if random.unit() < 0.01 { f64::NAN } else { random.unit() };
            vertex(x, y, z, random.between(1.0, ratio))
        });
        let slots = [0; 3].map(|_| {
            let value = |random: &mut Random| {
                let v = random.between(-range, range) as f32;
                if random.unit() < 0.003 { odd } else { v }
            };
            (0..stride).map(|_| value(random)).collect::<Vec<_>>()
        });
        (v, slots)
    }

    #[test]
    fn a_batch_gives_the_bits_of_single_triangles() {
        let mut random = Random(77);
        let mut fragments = 0;
        for round in 0..60 {
            let layout = layouts()[round % 5].clone();
            let triangles: Vec<_> = (0..150).map(|_| triangle(&mut random, layout.stride)).collect();
            let change = |state: &mut State| {
                state.lighting.shade_model = if round & 4 != 0 { ShadeModel::Flat } else { ShadeModel::Smooth };
                (state.polygon.offset[2], state.polygon.offset_factor) = (round & 8 != 0, 3.5);
                state.polygon.stipple = round & 16 != 0;
                state.polygon_stipple.0 = [0x0F3C_55A1; 32];
                state.scissor.enabled = round & 32 != 0;
                (state.scissor.x, state.scissor.y, state.scissor.width, state.scissor.height) = (9, 5, 41, 43);
            };
            let list = Vertices {
                head: triangles.iter().flat_map(|(v, _)| *v).collect(),
                slots: triangles.iter().flat_map(|(_, s)| s.concat()).chain([f32::NAN; 4]).collect(),
                stride: layout.stride,
            };
            let ids: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            let draw = |level: Option<Level>, many: bool| {
                let mut canvas = TestCanvas::with_layout(64, layout.clone(), 1, 64, change);
                if let Some(level) = level {
                    canvas.scene = crate::raster::Scene::new(1, 64, level);
                    canvas.scene.begin_draw(canvas.draw.clone());
                } else {
                    canvas.scene.batch_nothing();
                }
                let builder = canvas.scene.builder().filter(|builder| many && builder.can_batch(list.stride));
                if let Some(mut builder) = builder {
                    ids.chunks(11).for_each(|ids| builder.triangles(&list, ids));
                } else {
                    triangles.iter().for_each(|(v, slots)| canvas.triangle(v, slots));
                }
                let seen = canvas.seen();
                let bits = |s: &crate::raster::testing::Seen| {
                    let values: Vec<_> = s.values.iter().map(|v| v.to_bits()).collect();
                    (s.at, s.z.to_bits(), values)
                };
                seen.iter().map(bits).collect::<Vec<_>>()
            };
            let single = draw(None, false);
            for level in Level::available() {
                assert!(draw(Some(level), false) == single, "round {round}, {level:?}");
                assert!(draw(Some(level), true) == single, "round {round}, {level:?}, many at a time");
            }
            fragments += single.len();
        }
        assert!(fragments > 30_000, "{fragments}");
    }
}
