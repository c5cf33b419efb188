//! Setup of triangles (OpenGL 1.5, sections 2.13.1, 3.5): facing by the sign of the snapped area, culling, polygon modes
//! and offset, and the planes. Triangles that draw nothing are dropped as early as possible: culled ones first, small ones
//! that contain no pixel centre before their planes are made.

use super::SetupContext;
use super::basis::{Basis, CornerValues};
use super::depth::{Depth, beyond, polygon_offset};
use super::line::LineInput;
use super::point::PointInput;
use super::position::{finite, relative, relative_snapped, within_limit};
use super::weights::range;
use crate::fragment::planes::Planes;
use crate::raster::coverage::edges::{Edges, bounds};
use crate::raster::geometry::{Coverage, SceneGeometry, index};
use crate::raster::state::Rect;
use crate::raster::vertex::{Vertex, VertexRef, twice_area};
use crate::state::raster::PolygonMode;

/// A triangle to be set up.
pub(crate) struct TriangleInput<'a> {
    pub v: [VertexRef<'a>; 3],
    pub provoking: &'a [f32],
    /// Whether the edge from each vertex to the next is a boundary.
    pub edges: [bool; 3],
}

/// The origin pixel of a triangle.
#[inline]
fn origin(v: &[&Vertex; 3]) -> [i32; 2] {
    let [a, b, c] = v.map(|v| v.clip[3]);
    let most = if b > a { b } else { a };
    let most = if c > most { c } else { most };
    // Where w varies much, 1/w is small at the far end, where rounding errors show most. With the origin there, what is added
    // to it is small, too.
    if most > 2.0 * a || most > 2.0 * b || most > 2.0 * c {
        return v.iter().find(|v| v.clip[3] == most).map_or(v[0].snapped, |v| v.snapped).map(|x| x >> 8);
    }
    [0, 1].map(|k: usize| (v[0].snapped[k] + v[1].snapped[k] + v[2].snapped[k]).div_euclid(3 * 256))
}

/// The weights of the corners, from the unsnapped positions where their area is about that of the snapped ones.
#[inline]
fn basis(v: &[&Vertex; 3], origin: [i32; 2], snapped_det: f64) -> Basis {
    let corner = v.map(|v| relative(v.window, origin));
    let [[x0, y0], [x1, y1], [x2, y2]] = corner;
    let det = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    // In slivers the two areas may differ much, and values would leave the range of the corners.
    let ratio = det * snapped_det;
    let square = snapped_det * snapped_det;
    if ratio > 0.5 * square && ratio < 2.0 * square {
        Basis::triangle(corner, det)
    } else {
        Basis::triangle(v.map(|v| relative_snapped(v.snapped, origin)), snapped_det)
    }
}

/// The depth of a triangle with the offset of its mode, and that offset. `exact` says that fragments may leave the range of
/// the corners by what a position can move when it is snapped.
#[inline]
fn depth(cx: &SetupContext, v: &[&Vertex; 3], basis: &Basis, mode: PolygonMode, exact: bool) -> (Depth, f64) {
    let rs = cx.rs;
    let corner = v.map(|v| v.window[2] * rs.depth_scale);
    let plane = basis.linear(corner);
    let (low, high) = range(corner);
    let beyond = if exact { beyond(plane.x, plane.y, low, high) } else { 0.0 };
    let offset = if rs.offset[mode as usize] {
        let plane = finite(plane);
        polygon_offset(plane.x, plane.y, [rs.offset_factor, rs.offset_units], rs.depth_scale)
    } else {
        0.0
    };
    (Depth::new(rs, plane, corner, beyond, offset), offset)
}

/// Twice the area in pixels of a triangle whose area is given in units of the grid.
#[inline]
fn pixels(area: i64) -> f64 {
    area as f64 * (1.0 / 65536.0)
}

impl SceneGeometry {
    /// Sets up a triangle: culls it, or adds what its polygon mode draws.
    pub(crate) fn triangle(&mut self, cx: &SetupContext, t: &TriangleInput, stipple: &mut u32) {
        if cx.plan.is_batched() && self.queue(cx, t) {
            return;
        }
        self.flush_batch(cx);
        let rs = cx.rs;
        let p = t.v.map(|v| v.head.snapped);
        if !within_limit(&p) {
            return;
        }
        let area = twice_area(&p);
        let back = area == 0 || (area > 0) != rs.ccw_is_front;
        let face = usize::from(back);
        if rs.cull[face] {
            return;
        }
        match rs.mode[face] {
            PolygonMode::Fill if rs.smooth[2] => self.smooth_triangle(cx, t, area, back),
            PolygonMode::Fill => self.fill(cx, t, p, area, back),
            mode => self.outline(cx, t, area, back, mode, stipple),
        }
    }

    /// Adds a filled triangle that is not culled.
    pub(crate) fn fill(&mut self, cx: &SetupContext, t: &TriangleInput, mut p: [[i32; 2]; 3], area: i64, back: bool) {
        let bounds = bounds(&p);
        let rect = bounds.and(cx.rs.area);
        if area == 0 || rect.is_empty() {
            return;
        }
        let (width, height) = (bounds.x1 - bounds.x0, bounds.y1 - bounds.y0);
        if area < 0 {
            p.swap(1, 2);
        }
        let (cover, pixels) = if width <= 8 && height <= 8 {
            let bits = Edges::new(&p, bounds).mask() & clip_mask(cx, bounds, rect);
            if bits == 0 {
                return;
            }
            (Coverage::Mask { x: bounds.x0, y: bounds.y0, bits }, u64::from(bits.count_ones()))
        } else {
            self.edges(&p, rect)
        };
        let planes = self.triangle_planes(cx, t, area, back, PolygonMode::Fill);
        self.push(cover, cx.draw, planes, pixels);
    }

    /// Adds the edges of a counter-clockwise triangle. Returns its coverage, and about how many pixels that is.
    #[inline]
    pub(crate) fn edges(&mut self, p: &[[i32; 2]; 3], rect: Rect) -> (Coverage, u64) {
        self.edges.push(Edges::new(p, rect));
        let pixels = i64::from(rect.x1 - rect.x0) * i64::from(rect.y1 - rect.y0) / 2;
        (Coverage::Edges(index(self.edges.len() - 1)), pixels.unsigned_abs())
    }

    /// The planes of a filled triangle; those of its slots go to the plane buffer.
    #[inline(always)]
    pub(crate) fn triangle_planes(
        &mut self,
        cx: &SetupContext,
        t: &TriangleInput,
        area: i64,
        back: bool,
        mode: PolygonMode,
    ) -> Planes {
        let v = t.v.map(|v| v.head);
        let (origin, det) = (origin(&v), pixels(area));
        let basis = basis(&v, origin, det);
        let z = depth(cx, &v, &basis, mode, !cx.rs.smooth[2]).0;
        // Not `back`: the colours of a triangle of a batch are those of the visible side already.
        let back_face = area == 0 || (area > 0) != cx.rs.ccw_is_front;
        let mut planes = Planes { origin, z: z.plane, z_range: z.range, back: back_face, ..Planes::default() };
        let values =
            CornerValues { corner: t.v.map(|v| v.slots), provoking: t.provoking, back, w: v.map(|v| v.clip[3]) };
        cx.plan.planes(&basis, &values, &mut planes, &mut self.pool);
        planes
    }
}

impl SceneGeometry {
    /// Polygon modes LINE and POINT: the boundary edges as lines, or the vertices that begin them as points.
    fn outline(
        &mut self,
        cx: &SetupContext,
        t: &TriangleInput,
        area: i64,
        back: bool,
        mode: PolygonMode,
        stipple: &mut u32,
    ) {
        let offset = if area == 0 {
            if cx.rs.offset[mode as usize] { cx.rs.offset_units } else { 0.0 }
        } else {
            let v = t.v.map(|v| v.head);
            depth(cx, &v, &basis(&v, origin(&v), pixels(area)), mode, true).1
        };
        // The first half of a quadrilateral has its inner edge in the middle: there the outline goes on from edge 2 to 0.
        let order = if t.edges == [true, false, true] { [2, 0, 1] } else { [0, 1, 2] };
        for i in order {
            let (v, next, boundary) = (t.v[i], t.v[(i + 1) % 3], t.edges[i]);
            let provoking = if cx.rs.flat { t.provoking } else { v.slots };
            match mode {
                _ if !boundary => {}
                PolygonMode::Point if cx.rs.viewport.holds(v.head.snapped) => {
                    self.point(cx, &PointInput { v, provoking, back, offset });
                }
                PolygonMode::Point => {}
                _ => self.line(cx, &LineInput { v: [v, next], provoking, back, offset }, stipple),
            }
        }
    }
}

/// The bits of a small triangle's mask that may be drawn: clip rectangle and polygon stipple.
#[inline]
pub(crate) fn clip_mask(cx: &SetupContext, bounds: Rect, rect: Rect) -> u64 {
    let stipple = cx.rs.polygon_stipple.as_deref();
    if rect == bounds && stipple.is_none() {
        return u64::MAX;
    }
    let columns = (0xFFu32 << (rect.x0 - bounds.x0)) & (0xFFu32 >> (8 - (rect.x1 - bounds.x0)));
    let mut mask = 0;
    for y in rect.y0..rect.y1 {
        let pattern = stipple.map_or(u32::MAX, |rows| rows[y as usize & 31]);
        let turned = pattern.rotate_left(bounds.x0 as u32 & 31).reverse_bits();
        mask |= u64::from(columns & turned) << (8 * (y - bounds.y0));
    }
    mask
}

#[cfg(test)]
mod tests {
    use crate::raster::PrimitiveSink;
    use crate::raster::state::RESOLVABLE;
    use crate::raster::testing::{Random, TestCanvas, vertex};
    use crate::raster::vertex::VertexRef;
    use crate::state::State;
    use crate::state::raster::Face;
    use crate::state::raster::PolygonMode;
    use crate::state::raster::Winding;

    const CCW: [[f64; 2]; 3] = [[2.0, 2.0], [30.0, 3.0], [4.0, 28.0]];
    const CW: [[f64; 2]; 3] = [[4.0, 28.0], [30.0, 3.0], [2.0, 2.0]];

    fn count(change: impl Fn(&mut State), p: [[f64; 2]; 3]) -> u32 {
        let mut canvas = TestCanvas::new(32, 0, 1, 64, change);
        canvas.plain(p);
        canvas.hits().iter().sum()
    }

    #[test]
    fn facing_decides_what_is_culled() {
        let all = count(|_| {}, CCW);
        assert!(all > 300 && count(|_| {}, CW) == all);
        for (front, face, ccw, cw) in [
            (Winding::CounterClockwise, Face::Back, all, 0),
            (Winding::CounterClockwise, Face::Front, 0, all),
            (Winding::Clockwise, Face::Back, 0, all),
            (Winding::Clockwise, Face::Front, all, 0),
            (Winding::CounterClockwise, Face::FrontAndBack, 0, 0),
        ] {
            let cull = |state: &mut State| {
                (state.polygon.cull, state.polygon.front_face, state.polygon.cull_face) = (true, front, face);
            };
            assert_eq!((count(cull, CCW), count(cull, CW)), (ccw, cw));
        }
    }

    #[test]
    fn small_triangles_without_a_centre_cost_nothing() {
        let mut canvas = TestCanvas::new(32, 2, 1, 64, |_| {});
        for p in [
            [[3.6, 3.6], [4.4, 3.6], [3.6, 4.4]],
            [[1.0, 1.0], [1.0, 1.0], [9.0, 9.0]],
            [[40.0, 1.0], [44.0, 1.0], [40.0, 5.0]],
        ] {
            canvas.triangle(&p.map(|[x, y]| vertex(x, y, 0.5, 1.0)), &[vec![0.0; 2], vec![1.0; 2], vec![2.0; 2]]);
        }
        canvas.scene.flush_batch();
        assert!(canvas.scene.is_empty());
        assert_eq!(canvas.scene.memory(), 0);
    }

    #[test]
    fn modes_draw_boundary_edges_and_vertices() {
        let mode = |mode: PolygonMode| move |state: &mut State| state.polygon.mode = [mode; 2];
        let corners = [[2.5, 2.5], [20.5, 2.5], [2.5, 12.5]];
        let v = corners.map(|[x, y]| vertex(x, y, 0.5, 1.0));
        for (edges, lines, points) in
            [([true; 3], 18 + 18 + 10, 3), ([true, false, true], 18 + 10, 2), ([false; 3], 0, 0)]
        {
            for (mode, want) in [(mode(PolygonMode::Line), lines), (mode(PolygonMode::Point), points)] {
                let mut canvas = TestCanvas::new(32, 0, 1, 64, mode);
                canvas.scene.triangle([0, 1, 2].map(|i: usize| VertexRef { head: &v[i], slots: &[] }), 2, edges);
                assert_eq!(canvas.hits().iter().sum::<u32>(), want, "{edges:?}");
            }
        }
        // Edge-on polygons still have edges; they are back faces.
        assert_eq!(count(mode(PolygonMode::Line), [[2.5, 2.5], [9.5, 2.5], [5.5, 2.5]]), 7 + 4 + 3);
    }

    #[test]
    fn offset_follows_the_slope() {
        let z = |change: fn(&mut State), mode: PolygonMode| {
            let mut canvas = TestCanvas::new(32, 1, 1, 64, |state| {
                (state.polygon.offset_factor, state.polygon.offset_units) = (2.0, 3.0);
                state.polygon.mode = [mode; 2];
                change(state);
            });
            let v = [vertex(0.0, 0.0, 0.0, 1.0), vertex(32.0, 0.0, 0.25, 1.0), vertex(0.0, 32.0, 0.5, 1.0)];
            canvas.triangle(&v, &[vec![0.0], vec![0.0], vec![0.0]]);
            canvas.seen()
        };
        // The greater slope is 1/2 over 32 pixels.
        let want = 2.0 * (0.5 / 32.0) * 16_777_215.0 + 3.0 * RESOLVABLE;
        let set = [
            (PolygonMode::Fill, (|s| s.polygon.offset[2] = true) as fn(&mut State)),
            (PolygonMode::Line, |s| s.polygon.offset[1] = true),
            (PolygonMode::Point, |s| s.polygon.offset[0] = true),
        ];
        for (mode, change) in set {
            let (plain, moved) = (z(|_| {}, mode), z(change, mode));
            assert!(!plain.is_empty() && plain.len() == moved.len());
            for (a, b) in plain.iter().zip(&moved) {
                assert!((b.z - a.z - want).abs() < 1e-6, "{mode:?} {} {}", a.z, b.z);
            }
        }
    }

    #[test]
    fn stipple_and_scissor_choose_among_the_same_fragments() {
        let mut random = Random(31);
        let pattern: [u32; 32] = std::array::from_fn(|_| (random.unit() * 4_294_967_296.0) as u32);
        let masked = |state: &mut State| {
            state.polygon.stipple = true;
            state.polygon_stipple.0 = pattern;
            state.scissor.enabled = true;
            (state.scissor.x, state.scissor.y, state.scissor.width, state.scissor.height) = (5, 9, 71, 43);
        };
        let mut all = TestCanvas::new(96, 1, 1, 64, |_| {});
        let mut some = TestCanvas::new(96, 1, 3, 23, masked);
        for round in 0..600 {
            let size = [3.0, 8.0, 60.0][round % 3];
            let at = [random.between(0.0, 90.0), random.between(0.0, 90.0)];
            let p = [0; 3].map(|_| at.map(|v| v + random.between(0.0, size)));
            let w = random.between(1.0, 3.0);
            let v = p.map(|[x, y]| vertex(x, y, random.unit(), w));
            let slots = [0; 3].map(|_| vec![random.unit() as f32]);
            all.triangle(&v, &slots);
            some.triangle(&v, &slots);
            let want: Vec<_> = all
                .seen()
                .into_iter()
                .filter(|s| {
                    let [x, y] = s.at;
                    (5..76).contains(&x) && (9..52).contains(&y) && pattern[y as usize % 32] >> (31 - x % 32) & 1 != 0
                })
                .map(|s| (s.at, s.z.to_bits(), s.values))
                .collect();
            let got: Vec<_> = some.seen().into_iter().map(|s| (s.at, s.z.to_bits(), s.values)).collect();
            assert_eq!(want, got);
        }
    }

    #[test]
    fn threads_and_cuts_change_no_bit() {
        let draw = |threads: usize, cut: usize| {
            let mut random = Random(32);
            let mut canvas = TestCanvas::new(300, 2, threads, cut, |_| {});
            for round in 0..900 {
                let size = [4.0, 12.0, 200.0][round % 3];
                let at = [random.between(-20.0, 300.0), random.between(-20.0, 300.0)];
                let v = [0; 3].map(|_| {
                    vertex(
                        at[0] + random.between(0.0, size),
                        at[1] + random.between(0.0, size),
                        random.unit(),
                        random.between(1.0, 2.0),
                    )
                });
                let slots = [0; 3].map(|_| vec![random.unit() as f32, random.unit() as f32]);
                canvas.triangle(&v, &slots);
            }
            let hits = canvas.hits();
            let mut seen: Vec<_> = canvas
                .seen()
                .into_iter()
                .map(|s| (s.at, s.z.to_bits(), s.values.iter().map(|v| v.to_bits()).collect::<Vec<_>>()))
                .collect();
            seen.sort();
            (hits, seen)
        };
        let want = draw(1, 64);
        assert!(want.1.len() > 300_000);
        for (threads, cut) in [(1, 17), (2, 64), (7, 33)] {
            assert!(draw(threads, cut) == want, "{threads} threads, cut at {cut}");
        }
    }
}
