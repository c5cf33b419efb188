//! Filled triangles wait in the batch until it is full, and are then set up together. What waits is stored before any
//! other primitive is, so that the order of issue is kept.

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
    /// Puts colours in place that are not simply those of the corners: flat shading, back faces.
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
    /// Lets a filled triangle wait. False, and nothing done, where a vertex lacks slots.
    #[inline]
    pub(crate) fn queue(&mut self, cx: &SetupContext, t: &TriangleInput) -> bool {
        let group = &mut *self.group;
        let lane = group.count % GROUP;
        let layout = cx.plan.layout();
        if !group.put_slots(&t.v, layout.count) {
            return false;
        }
        if cx.rs.flat || layout.back.is_some() {
            let area = twice_area(&t.v.map(|v| v.head.snapped));
            group.put_colors(cx, t, area == 0 || (area > 0) != cx.rs.ccw_is_front);
        }
        for (corner, v) in t.v.iter().enumerate() {
            let [x, y, z] = v.head.window;
            group.position[corner][lane] = [v.head.clip[3], x, y, z];
            for k in 0..2 {
                group.corners.snapped[corner][k][lane] = v.head.snapped[k];
            }
        }
        group.count += 1;
        if group.count == GROUP {
            self.set_up_batch(cx);
        }
        true
    }

    /// Whether triangles may wait [many at a time](Self::queue_all): where each corner has its own colours.
    pub(crate) fn can_batch(cx: &SetupContext, stride: usize) -> bool {
        let layout = cx.plan.layout();
        cx.plan.is_grouped() && !cx.rs.flat && layout.back.is_none() && layout.count <= stride
    }

    /// Lets filled triangles wait, whose corners are some of many vertices.
    pub(crate) fn queue_all(&mut self, cx: &SetupContext, vertices: &Vertices, triangles: &[[u32; 3]]) {
        let mut rest = triangles;
        while !rest.is_empty() {
            let free = GROUP - self.group.count % GROUP;
            let (now, later) = rest.split_at(free.min(rest.len()));
            self.group.put(vertices, now, cx.plan.layout().count);
            rest = later;
            if self.group.count == GROUP {
                self.set_up_batch(cx);
            }
        }
    }

    /// Files the triangles that wait.
    pub(crate) fn flush_batch(&mut self, cx: &SetupContext) {
        if self.group.count > 0 {
            self.set_up_batch(cx);
        }
    }

    /// Files triangles whose corners `fill` puts in place, a triangle a lane, in the first lanes.
    pub(crate) fn add_lanes(&mut self, cx: &SetupContext, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        self.flush_batch(cx);
        fill(&mut self.group.corners);
        self.set_up_lanes(cx, count.min(GROUP));
    }

    fn set_up_batch(&mut self, cx: &SetupContext) {
        let count = std::mem::take(&mut self.group.count).min(GROUP);
        cx.plan.turn(&mut self.group);
        self.set_up_lanes(cx, count);
    }

    /// Files the triangles of so many lanes.
    fn set_up_lanes(&mut self, cx: &SetupContext, count: usize) {
        let rs = cx.rs;
        let offset = rs.offset[PolygonMode::Fill as usize].then_some([rs.offset_factor, rs.offset_units]);
        let (ccw, cw) = if rs.ccw_is_front { (0, 1) } else { (1, 0) };
        let culls = [rs.cull[ccw], rs.cull[cw]];
        let (first, planes) = self.pool.more_groups(cx.plan.layout().count);
        cx.plan.group(&mut self.group, &BatchState { area: rs.area, culls, scale: rs.depth_scale, offset }, planes);
        let mut used = false;
        for lane in 0..count {
            match self.group.kind[lane] {
                NOTHING => {}
                ALONE => self.set_up_alone(cx, lane),
                kind => used |= self.push_member(cx, lane, first, kind),
            }
        }
        if !used {
            self.pool.drop_groups(first);
        }
    }

    /// Files a member of a group whose planes begin somewhere. False where it has no pixel.
    #[inline]
    fn push_member(&mut self, cx: &SetupContext, lane: usize, first: u32, kind: i32) -> bool {
        let group = &*self.group;
        let [x, y] = [group.first[0][lane], group.first[1][lane]];
        let bounds = Rect { x0: x, y0: y, x1: group.last[0][lane], y1: group.last[1][lane] };
        let (cover, pixels) = if kind == MASK {
            let mut bits = group.bits[lane];
            if group.cut[lane] != 0 || cx.rs.polygon_stipple.is_some() {
                bits &= clip_mask(cx, bounds, bounds.and(cx.rs.area));
            }
            if bits == 0 {
                return false;
            }
            (Coverage::Mask { x, y, bits }, u64::from(bits.count_ones()))
        } else {
            let mut pixels = u64::from(group.pixels[lane].unsigned_abs());
            if pixels == 0 {
                return false;
            }
            // Put together where they are kept: on their way through a variable they would be read back before they are
            // written.
            self.blocks.push(RowCoverage::new([x, y], bounds.y1 - bounds.y0));
            if let Some(rows) = self.blocks.last_mut() {
                rows.take(&group.ends, lane);
                if group.cut[lane] != 0 {
                    pixels = rows.cut(bounds.and(cx.rs.area));
                }
            }
            if pixels == 0 {
                self.blocks.pop();
                return false;
            }
            (Coverage::Rows(index(self.blocks.len() - 1)), pixels)
        };
        let group = &*self.group;
        if group.odd[lane].is_nan() {
            let planes = self.with_lane(cx, lane, |geometry, t, area| {
                geometry.triangle_planes(cx, t, area, false, PolygonMode::Fill)
            });
            self.file(cover, cx.draw, planes, pixels);
            return true;
        }
        // Made where they are filed: on their way through a variable they would be read back before they are written.
        let of = |l: &LinearLanes| Linear { at: l.at[lane], x: l.x[lane], y: l.y[lane] };
        self.prims.push(Prim { cover, draw: cx.draw });
        self.pixels += pixels;
        self.planes.push(Planes {
            origin: [group.origin[0][lane], group.origin[1][lane]],
            z: of(&group.z),
            d: of(&group.bases.d),
            affine: group.affine[lane],
            wide: 0,
            first,
            member: Some(lane as u8),
        });
        true
    }

    /// Files a triangle that has waited although it is large.
    fn set_up_alone(&mut self, cx: &SetupContext, lane: usize) {
        self.with_lane(cx, lane, |geometry, t, area| {
            let back = area == 0 || (area > 0) != cx.rs.ccw_is_front;
            if !cx.rs.cull[usize::from(back)] {
                geometry.fill(cx, t, t.v.map(|v| v.head.snapped), area, false);
            }
        });
    }

    /// Does something with a waiting triangle and its area. Colours have been put in place already: those of the side
    /// that is seen, and of the provoking vertex.
    fn with_lane<T>(
        &mut self,
        cx: &SetupContext,
        lane: usize,
        run: impl FnOnce(&mut Self, &TriangleInput, i64) -> T,
    ) -> T {
        let count = cx.plan.layout().count;
        let corners = &self.group.corners;
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
        // Some of the colour's slots come twice, behind the fog coordinate too.
        let fog = Layout { fog: Some(4), count: 5, stride: 5, ..color.clone() };
        [all, unit, color, fog, Layout { count: 1, stride: 1, ..Layout::default() }]
    }

    /// A small triangle: sometimes in perspective, sometimes a sliver, sometimes with values that are odd.
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
    fn a_group_gives_the_bits_of_single_triangles() {
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
                    canvas.scene = crate::raster::Scene::new(1, 64).at_level(level);
                    canvas.scene.begin_draw(canvas.draw.clone());
                } else {
                    canvas.scene.group_nothing();
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
