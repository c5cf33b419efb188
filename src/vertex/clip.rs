//! Clipping (OpenGL 1.5, section 2.12) in f64 and homogeneous coordinates, before any division: against near, far and
//! user planes, and for triangles against the guard band (window positions of +-32767) instead of the viewport's sides,
//! which the rasteriser cuts itself.
//!
//! A new vertex on the edge from a to b, at signed distances da and db, is `a * (db / (db - da)) + b * (da / (da - db))`.
//! Exchanging a and b, or turning the plane round, exchanges equal terms of a sum: both sides of a shared edge and both
//! halves of a scene cut by a plane and its opposite get the same bits. Vertices inside keep their bits.

use super::batch::MAX_SLOTS;
use super::plan::VertexPlan;
use super::stages::transform::{GUARD_BAND, to_window};
use super::transformed::TransformedVertices;
use super::uniforms::ViewportUniforms;
use crate::limits::MAX_CLIP_PLANES;
use crate::raster::PrimitiveSink;
use crate::raster::vertex::{Vertex, VertexRef, Vertices, outcode};

/// w of every vertex that comes out is at least this: far below what any position in a picture has, so that triangles
/// through the eye are cut by the guard band and not by this.
const LEAST_W: f64 = 1e-250;
/// A triangle gains at most one corner from each plane.
const MAX_CORNERS: usize = 3 + 1 + 2 + MAX_CLIP_PLANES + 8;

/// A corner of a polygon that is being clipped.
#[derive(Clone, Copy, Debug, Default)]
struct ClipCorner {
    clip: [f64; 4],
    user: [f64; MAX_CLIP_PLANES],
    /// Whether the edge that starts here is a boundary edge.
    edge: bool,
    point_size: f32,
    /// Where its slots are in the arena.
    slots: usize,
    /// Which of the original vertices it is, if it is one.
    original: Option<u32>,
}

/// A plane: which distance of a corner it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ClipPlane {
    W,
    Near,
    Far,
    User(usize),
    /// A side of the view volume: coordinate 0 or 1, and whether the side where it is greatest.
    Side(usize, bool),
    /// A side of the guard band.
    Guard(usize, bool),
}

impl ClipPlane {
    /// The signed distance, not negative inside.
    fn distance(self, c: &ClipCorner, v: &ViewportUniforms) -> f64 {
        let w = c.clip[3];
        match self {
            Self::W => w - LEAST_W,
            Self::Near => w + c.clip[2],
            Self::Far => w - c.clip[2],
            Self::User(k) => c.user.get(k).copied().unwrap_or(0.0),
            Self::Side(i, false) => w + c.clip[i],
            Self::Side(i, true) => w - c.clip[i],
            Self::Guard(i, false) => (GUARD_BAND + v.center[i]) * w + v.half[i] * c.clip[i],
            Self::Guard(i, true) => (GUARD_BAND - v.center[i]) * w - v.half[i] * c.clip[i],
        }
    }

    /// Moves a computed corner exactly onto the plane.
    fn snap_to_plane(self, c: &mut ClipCorner) {
        match self {
            Self::Near => c.clip[2] = -c.clip[3],
            Self::Far => c.clip[2] = c.clip[3],
            Self::Side(i, false) => c.clip[i] = -c.clip[3],
            Self::Side(i, true) => c.clip[i] = c.clip[3],
            Self::User(k) => {
                if let Some(d) = c.user.get_mut(k) {
                    *d = 0.0;
                }
            }
            Self::W => c.clip[3] = LEAST_W,
            Self::Guard(..) => {}
        }
    }

    /// Moves a corner between a and b onto a side of the guard band, and computes both its coordinates anew. Corners may be
    /// 1e38 pixels away, where a weighted sum is nothing but rounding error; products with their errors give the line
    /// through a and b more precisely.
    fn snap_to_guard_band(self, c: &mut ClipCorner, a: &[f64; 4], b: &[f64; 4], v: &ViewportUniforms) {
        let Self::Guard(i, greatest) = self else { return };
        let other = 1 - i;
        let (g, h) =
            if greatest { (GUARD_BAND - v.center[i], -v.half[i]) } else { (GUARD_BAND + v.center[i], v.half[i]) };
        let d = |k: usize, l: usize| determinant([a[k], a[l]], [b[k], b[l]]);
        let on = -g * c.clip[3] / h;
        let across = c.clip[3] * ((g * d(other, 3) + h * d(other, i)) / (h * d(3, i)));
        // Numbers near the ends of f64's range keep what the sum gave.
        if on.is_finite() && across.is_finite() {
            c.clip[i] = on;
            c.clip[other] = across;
        }
    }
}

/// a0 b1 - a1 b0, rounded as if the products were exact. Exchanging a and b changes the sign and nothing else.
fn determinant(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (p, p_error) = product(a[0], b[1]);
    let (q, q_error) = product(a[1], b[0]);
    (p - q) + (p_error - q_error)
}

/// A product and its rounding error (Dekker's, of halves of 26 bits).
fn product(a: f64, b: f64) -> (f64, f64) {
    let halves = |v: f64| {
        let high = f64::from_bits(v.to_bits() & !0x7FF_FFFF);
        (high, v - high)
    };
    let ((a1, a0), (b1, b0)) = (halves(a), halves(b));
    let p = a * b;
    (p, ((a1 * b1 - p) + (a1 * b0 + a0 * b1)) + a0 * b0)
}

/// Both weights of a point between a and b; their products' sum does not depend on the order of the two.
#[derive(Clone, Copy)]
struct EdgeMix {
    a: f64,
    b: f64,
}

impl EdgeMix {
    fn new(da: f64, db: f64) -> Self {
        Self { a: db / (db - da), b: da / (da - db) }
    }

    /// Equal values stay as they are, to the last bit.
    fn of(self, a: f64, b: f64) -> f64 {
        if a == b { a } else { a * self.a + b * self.b }
    }
}

/// The clipper's scratch memory.
#[derive(Clone, Debug, Default)]
pub struct Clipper {
    polygon: Vec<ClipCorner>,
    next: Vec<ClipCorner>,
    /// Slots of all corners, old and new, in f64.
    arena: Vec<f64>,
    /// What is handed on.
    out: Vertices,
    edges: Vec<bool>,
}

impl Clipper {
    /// Takes the corners of a primitive. Under flat shading every corner gets the colours of the provoking one.
    fn load(&mut self, plan: &VertexPlan, pool: &TransformedVertices, ids: &[u32], provoking: usize, edges: &[bool]) {
        let stride = plan.layout.stride.min(MAX_SLOTS);
        self.polygon.clear();
        self.arena.clear();
        for (&id, &edge) in ids.iter().zip(edges) {
            let Some(v) = pool.get(id) else { continue };
            let mut user = [0.0; MAX_CLIP_PLANES];
            for (to, from) in user.iter_mut().zip(pool.user(id)) {
                *to = *from;
            }
            self.polygon.push(ClipCorner {
                clip: v.head.clip,
                user,
                edge,
                point_size: v.head.point_size,
                slots: self.arena.len(),
                original: Some(id),
            });
            self.arena.extend(v.slots.iter().take(stride).map(|s| f64::from(*s)));
        }
        if plan.flat && self.arena.len() == ids.len() * stride {
            for slot in flat_slots(plan) {
                let Some(color) = self.arena.get(provoking * stride + slot).copied() else { continue };
                self.arena.iter_mut().skip(slot).step_by(stride).for_each(|v| *v = color);
            }
        }
    }

    /// The corner where the edge from a to b meets a plane.
    fn cut(
        &mut self,
        plan: &VertexPlan,
        plane: ClipPlane,
        (a, da): (&ClipCorner, f64),
        (b, db): (&ClipCorner, f64),
    ) -> ClipCorner {
        let mix = EdgeMix::new(da, db);
        let slots = self.arena.len();
        for k in 0..plan.layout.stride.min(MAX_SLOTS) {
            let (Some(&p), Some(&q)) = (self.arena.get(a.slots + k), self.arena.get(b.slots + k)) else { break };
            self.arena.push(mix.of(p, q));
        }
        let mut corner = ClipCorner {
            clip: std::array::from_fn(|k| mix.of(a.clip[k], b.clip[k])),
            user: std::array::from_fn(|k| mix.of(a.user[k], b.user[k])),
            edge: true,
            point_size: mix.of(f64::from(a.point_size), f64::from(b.point_size)) as f32,
            slots,
            original: None,
        };
        plane.snap_to_plane(&mut corner);
        plane.snap_to_guard_band(&mut corner, &a.clip, &b.clip, &plan.uniforms.viewport);
        corner
    }

    /// Cuts the polygon by a plane; false where nothing is left.
    fn cut_polygon(&mut self, plan: &VertexPlan, plane: ClipPlane) -> bool {
        let view = &plan.uniforms.viewport;
        if self.polygon.iter().all(|c| plane.distance(c, view) >= 0.0) {
            return !self.polygon.is_empty();
        }
        let polygon = std::mem::take(&mut self.polygon);
        let mut next = std::mem::take(&mut self.next);
        next.clear();
        for (i, a) in polygon.iter().enumerate() {
            let Some(b) = polygon.get((i + 1) % polygon.len()) else { break };
            let (da, db) = (plane.distance(a, view), plane.distance(b, view));
            if next.len() + 2 > MAX_CORNERS {
                break;
            }
            match (da >= 0.0, db >= 0.0) {
                (true, true) => next.push(*a),
                (true, false) => {
                    next.push(*a);
                    // The edge along the plane is a boundary edge. A corner on the plane is not doubled.
                    if da > 0.0 {
                        next.push(self.cut(plan, plane, (a, da), (b, db)));
                    } else if let Some(last) = next.last_mut() {
                        last.edge = true;
                    }
                }
                // The rest of an edge keeps its flag.
                (false, true) if db > 0.0 => {
                    let corner = self.cut(plan, plane, (a, da), (b, db));
                    next.push(ClipCorner { edge: a.edge, ..corner });
                }
                _ => {}
            }
        }
        self.next = polygon;
        self.polygon = next;
        self.polygon.len() >= 3
    }

    /// Clips a triangle and hands on what is left of it as a fan.
    pub fn triangle<S: PrimitiveSink>(
        &mut self,
        plan: &VertexPlan,
        pool: &TransformedVertices,
        ids: [u32; 3],
        provoking: usize,
        edges: [bool; 3],
        sink: &mut S,
    ) {
        self.load(plan, pool, &ids, provoking, &edges);
        let any = self.any_outcode(pool, &ids);
        let exact = plan.clip_mask & outcode::FRUSTUM == outcode::FRUSTUM;
        let planes = planes(any, exact, plan.uniforms.user_count, &plan.uniforms.user_bit);
        for plane in planes.into_iter().flatten() {
            if !self.cut_polygon(plan, plane) {
                return;
            }
        }
        if !self.finish(plan, pool) {
            return;
        }
        // Under flat shading all corners have the same colour, so the first may be the provoking one.
        let n = self.out.head.len();
        let corner = |i: usize| -> Option<VertexRef<'_>> {
            Some(VertexRef { head: self.out.head.get(i)?, slots: self.out.slots(i) })
        };
        let edge = |i: usize| self.edges.get(i).copied().unwrap_or(true);
        for i in 1..n.saturating_sub(1) {
            let (Some(a), Some(b), Some(c)) = (corner(0), corner(i), corner(i + 1)) else { return };
            sink.triangle([a, b, c], 0, [i == 1 && edge(0), edge(i), i + 2 == n && edge(n - 1)]);
        }
    }

    /// Clips a line segment to the view volume and hands it on.
    pub fn line<S: PrimitiveSink>(
        &mut self,
        plan: &VertexPlan,
        pool: &TransformedVertices,
        ids: [u32; 2],
        provoking: usize,
        sink: &mut S,
    ) {
        self.load(plan, pool, &ids, provoking, &[true; 2]);
        let any = self.any_outcode(pool, &ids);
        let view = plan.uniforms.viewport;
        for plane in planes(any, true, plan.uniforms.user_count, &plan.uniforms.user_bit).into_iter().flatten() {
            let &[a, b] = self.polygon.as_slice() else { return };
            let (da, db) = (plane.distance(&a, &view), plane.distance(&b, &view));
            match (da >= 0.0, db >= 0.0) {
                (true, true) => {}
                (false, false) => return,
                (first_inside, _) => {
                    let corner = self.cut(plan, plane, (&a, da), (&b, db));
                    self.polygon[usize::from(first_inside)] = corner;
                }
            }
        }
        if !self.finish(plan, pool) {
            return;
        }
        let [a, b] = [0, 1].map(|i| self.out.head.get(i).map(|head| VertexRef { head, slots: self.out.slots(i) }));
        if let (Some(a), Some(b)) = (a, b) {
            sink.line([a, b], provoking);
        }
    }

    fn any_outcode(&self, pool: &TransformedVertices, ids: &[u32]) -> u32 {
        ids.iter().filter_map(|id| pool.get(*id)).fold(0, |all, v| all | v.head.outcode)
    }

    /// Writes the polygon's corners as vertices; false where one of them has no window position.
    fn finish(&mut self, plan: &VertexPlan, pool: &TransformedVertices) -> bool {
        let stride = plan.layout.stride.min(MAX_SLOTS);
        self.out.clear(stride);
        self.edges.clear();
        for corner in &self.polygon {
            let head = match corner.original.and_then(|id| pool.get(id)) {
                Some(v) => Vertex { edge: corner.edge, ..*v.head },
                None => {
                    let (window, snapped) = to_window(&plan.uniforms.viewport, corner.clip);
                    Vertex {
                        clip: corner.clip,
                        window,
                        snapped,
                        outcode: 0,
                        edge: corner.edge,
                        point_size: corner.point_size,
                    }
                }
            };
            // A little beyond the guard band is rounding of the cut.
            let placed = head.window.iter().take(2).all(|v| v.abs() <= GUARD_BAND + 0.5) && head.window[2].is_finite();
            if !placed || head.clip[3] <= 0.0 || head.clip[3].is_nan() {
                return false;
            }
            self.out.head.push(head);
            self.edges.push(corner.edge);
            let slots = self.arena.get(corner.slots..corner.slots + stride).unwrap_or(&[]);
            self.out.slots.extend(slots.iter().map(|v| *v as f32));
        }
        true
    }
}

/// The sides of the view volume: coordinate, whether the side where it is greatest, outcode.
const SIDES: [(usize, bool, u32); 4] =
    [(0, false, outcode::LEFT), (0, true, outcode::RIGHT), (1, false, outcode::BOTTOM), (1, true, outcode::TOP)];

/// The planes that a primitive with these outcode bits must be cut by, in the one order that all primitives use. Cutting
/// makes no corner that is outside where all corners were inside, so that a plane without a bit has nothing to do.
fn planes(any: u32, exact: bool, user_count: usize, user_bit: &[u32]) -> [Option<ClipPlane>; MAX_CORNERS - 3] {
    let on = |bit: u32, plane: ClipPlane| (any & bit != 0).then_some(plane);
    let mut list = [None; MAX_CORNERS - 3];
    list[0] = on(outcode::BEHIND, ClipPlane::W);
    list[1] = on(outcode::NEAR, ClipPlane::Near);
    list[2] = on(outcode::FAR, ClipPlane::Far);
    for (place, (k, bit)) in list[3..].iter_mut().zip(user_bit.iter().enumerate().take(user_count)) {
        *place = on(*bit, ClipPlane::User(k));
    }
    for (k, (i, greatest, bit)) in SIDES.into_iter().enumerate() {
        list[3 + MAX_CLIP_PLANES + k] = if exact { on(bit, ClipPlane::Side(i, greatest)) } else { None };
        list[7 + MAX_CLIP_PLANES + k] = on(outcode::GUARD | outcode::BEHIND, ClipPlane::Guard(i, greatest));
    }
    list
}

/// The slots that flat shading takes from the provoking vertex.
fn flat_slots(plan: &VertexPlan) -> impl Iterator<Item = usize> {
    let layout = &plan.layout;
    let back = layout.back.map(|slot| slot..slot + if layout.secondary.is_some() { 7 } else { 4 });
    let color = layout.color.map(|slot| slot..slot + 4);
    let secondary = layout.secondary.map(|slot| slot..slot + 3);
    [color, secondary, back].into_iter().flatten().flatten()
}
