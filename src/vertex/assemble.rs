//! Primitive assembly (OpenGL 1.5, section 2.6.1): the ten primitives of Begin/End as a stream of vertices. The
//! assembler keeps the ids of those vertices that later ones may need, so a primitive may have any length and be cut
//! anywhere into batches; what is incomplete at the end is dropped.
//!
//! ```text
//!   TRIANGLE_STRIP   0 1 2 | 2 1 3 | 2 3 4 ...    the odd ones turned, so that all wind the same way
//!   TRIANGLE_FAN     0 1 2 | 0 2 3 ...            POLYGON the same, but its first vertex gives the flat colour
//!   QUADS  0 1 2 3   0 1 3 | 1 2 3                both with vertex 3, which gives the flat colour
//!   QUAD_STRIP       0 1 3 2 ...                  cut so that both halves have vertex 3
//! ```

use super::batch::{CullBatch, VertexBatch, needs};
use super::clip::Clipper;
use super::counts::VertexCounts;
use super::cull::is_outside;
use super::plan::VertexPlan;
use super::transformed::TransformedVertices;
use crate::raster::PrimitiveSink;
use crate::raster::vertex::{ScreenPosition, twice_area};
use crate::simd::LANES;
use crate::state::primitive::PrimitiveMode;
use std::mem::take;

/// Joins vertices into primitives.
#[derive(Clone, Debug, Default)]
pub struct Assembler {
    mode: PrimitiveMode,
    /// Ids of the vertices that are kept.
    hold: [u32; 4],
    held: usize,
    /// How many vertices the primitive has had, modulo something even.
    count: u32,
}

/// What a primitive is, and what its vertices mean to it.
#[derive(Clone, Copy, Debug)]
enum PrimitiveKind {
    /// A triangle: which corner is the provoking one, and which edges are boundaries.
    Triangle { provoking: u8, edges: [bool; 3] },
    /// A line.
    Line { provoking: u8 },
    /// A point.
    Point,
}

/// A primitive that may be visible: outcodes and culling, by positions alone, have not dropped it.
#[derive(Clone, Copy, Debug)]
pub struct VisiblePrimitive {
    ids: [u32; 3],
    kind: PrimitiveKind,
    /// Whether it must be clipped.
    clip: bool,
    /// Whether the line stipple starts anew before it.
    restart: bool,
}

impl VisiblePrimitive {
    /// The vertices that it uses; of points and lines some more than once.
    #[inline]
    #[must_use]
    pub fn ids(&self) -> [u32; 3] {
        self.ids
    }

    /// Whether it must be clipped.
    #[inline]
    #[must_use]
    pub fn clips(&self) -> bool {
        self.clip
    }

    /// Whether it is a triangle that need not be clipped.
    #[inline]
    #[must_use]
    pub fn is_plain(&self) -> bool {
        matches!(self.kind, PrimitiveKind::Triangle { .. }) && !self.clip
    }

    /// Hands the primitive on.
    #[inline]
    pub fn hand_on<S: PrimitiveSink>(
        &self,
        plan: &VertexPlan,
        pool: &TransformedVertices,
        clipper: &mut Clipper,
        sink: &mut S,
    ) {
        let [a, b, c] = self.ids;
        if self.restart {
            sink.restart_stipple();
        }
        match self.kind {
            PrimitiveKind::Triangle { provoking, edges } if self.clip => {
                clipper.triangle(plan, pool, self.ids, usize::from(provoking), edges, sink);
            }
            PrimitiveKind::Triangle { provoking, edges } => {
                if let (Some(a), Some(b), Some(c)) = (pool.get(a), pool.get(b), pool.get(c)) {
                    sink.triangle([a, b, c], usize::from(provoking), edges);
                }
            }
            PrimitiveKind::Line { provoking } if self.clip => {
                clipper.line(plan, pool, [a, b], usize::from(provoking), sink);
            }
            PrimitiveKind::Line { provoking } => {
                if let (Some(a), Some(b)) = (pool.get(a), pool.get(b)) {
                    sink.line([a, b], usize::from(provoking));
                }
            }
            PrimitiveKind::Point => {
                if let Some(v) = pool.get(a) {
                    sink.point(v);
                }
            }
        }
    }
}

/// Where the assembler puts primitives that may be visible.
#[derive(Debug)]
pub struct AssemblyOutput<'a> {
    /// The plan of the vertices.
    pub plan: &'a VertexPlan,
    /// What the sink [culls](PrimitiveSink::culls).
    pub culls: [bool; 2],
    /// The batch that the cull stage works on.
    pub batch: &'a mut VertexBatch,
    /// Primitives that may be visible.
    pub seen: &'a mut Vec<VisiblePrimitive>,
    /// What became of the others.
    pub counts: &'a mut VertexCounts,
    /// Whether the next line starts the stipple anew. What is dropped before leaves that to those after it.
    pub restart: &'a mut bool,
}

impl AssemblyOutput<'_> {
    /// Whether edge flags matter.
    fn edges(&self) -> bool {
        self.plan.needs & needs::EDGE != 0
    }

    /// A polygon begins: its first edge that is drawn starts the line stipple anew (section 3.5.4).
    #[inline]
    fn begin_polygon(&mut self) {
        *self.restart = true;
    }

    #[inline]
    fn triangle(&mut self, pool: &TransformedVertices, ids: [u32; 3], provoking: u8, edges: [bool; 3]) {
        let [a, b, c] = ids.map(|id| pool.screen(id));
        let any = a.0 | b.0 | c.0;
        if is_outside(a.0 & b.0 & c.0, any) {
            self.counts.outside += 1;
            return;
        }
        let clip = any & u64::from(self.plan.clip_mask) != 0;
        let [positive, other] = self.culls;
        if !clip && (positive | other) {
            let counter_clockwise = twice_area(&[a.snapped(), b.snapped(), c.snapped()]) > 0;
            if if counter_clockwise { positive } else { other } {
                self.counts.culled += 1;
                return;
            }
        }
        let restart = self.edges() && take(self.restart);
        self.seen.push(VisiblePrimitive { ids, kind: PrimitiveKind::Triangle { provoking, edges }, clip, restart });
    }

    /// Separate triangles, 64 at a time: most draws are made of them.
    fn triangles(&mut self, pool: &TransformedVertices, triangles: &[[u32; 3]]) {
        let with_edges = self.edges();
        let cull = self.plan.cull(self.culls);
        for block in triangles.chunks(LANES) {
            self.batch.triangles.n = block.len();
            pool.corners(block, &mut self.batch.triangles.corners);
            self.plan.run(&[cull], self.batch);
            let CullBatch { mut seen, clipped, outside, culled, .. } = self.batch.triangles;
            self.counts.outside += u64::from(outside.count_ones());
            self.counts.culled += u64::from(culled.count_ones());
            while seen != 0 {
                let i = seen.trailing_zeros();
                seen &= seen - 1;
                let Some(&ids) = block.get(i as usize) else { break };
                let edges = if with_edges { ids.map(|id| pool.edge(id)) } else { [true; 3] };
                let kind = PrimitiveKind::Triangle { provoking: 2, edges };
                self.seen.push(VisiblePrimitive { ids, kind, restart: with_edges, clip: clipped >> i & 1 != 0 });
            }
        }
    }

    #[inline]
    fn line(&mut self, pool: &TransformedVertices, [a, b]: [u32; 2]) {
        let [p, q] = [pool.screen(a), pool.screen(b)];
        let any = p.0 | q.0;
        if !is_outside(p.0 & q.0, any) {
            let (kind, clip) = (PrimitiveKind::Line { provoking: 1 }, ScreenPosition(any).outcode() != 0);
            self.seen.push(VisiblePrimitive { ids: [a, b, b], kind, clip, restart: take(self.restart) });
        } else {
            self.counts.outside += 1;
        }
    }

    #[inline]
    fn point(&mut self, pool: &TransformedVertices, id: u32) {
        if pool.screen(id).outcode() == 0 {
            self.seen.push(VisiblePrimitive { ids: [id; 3], kind: PrimitiveKind::Point, clip: false, restart: false });
        } else {
            self.counts.outside += 1;
        }
    }

    /// A quadrilateral in the order of its outline, whose corner 3 gives the flat colour: its diagonal runs from 1 to 3.
    #[inline]
    fn quad(&mut self, pool: &TransformedVertices, [a, b, c, d]: [u32; 4], edges: [bool; 4]) {
        self.triangle(pool, [a, b, d], 2, [edges[0], false, edges[3]]);
        self.triangle(pool, [b, c, d], 2, [edges[1], edges[2], false]);
    }
}

impl Assembler {
    /// Starts a primitive.
    pub fn begin(&mut self, mode: PrimitiveMode) {
        *self = Self { mode, ..Self::default() };
    }

    /// The ids of the vertices that must survive, to be renamed by [`TransformedVertices::keep`].
    pub fn held(&mut self) -> &mut [u32] {
        &mut self.hold[..self.held]
    }

    /// Groups of `N` vertices: the one that earlier calls have begun, if it is complete now, and those after it.
    #[inline]
    fn groups<'a, const N: usize>(&mut self, mut ids: &'a [u32]) -> (Option<[u32; N]>, &'a [[u32; N]]) {
        let mut begun = None;
        if self.held > 0 {
            let mut group = [0; N];
            let held = self.held.min(N - 1);
            let missing = (N - held).min(ids.len());
            let (first, rest) = ids.split_at(missing);
            group[..held].copy_from_slice(&self.hold[..held]);
            group[held..held + missing].copy_from_slice(first);
            if held + missing < N {
                self.hold[..held + missing].copy_from_slice(&group[..held + missing]);
                self.held = held + missing;
                return (None, &[]);
            }
            begun = Some(group);
            ids = rest;
        }
        let (groups, rest) = ids.as_chunks::<N>();
        self.hold[..rest.len()].copy_from_slice(rest);
        self.held = rest.len();
        (begun, groups)
    }

    /// Takes the next vertices of the primitive.
    pub fn feed(&mut self, ids: &[u32], pool: &TransformedVertices, out: &mut AssemblyOutput<'_>) {
        let each = ids.iter().copied();
        match self.mode {
            PrimitiveMode::Points => each.for_each(|id| out.point(pool, id)),
            PrimitiveMode::Lines => {
                let (begun, lines) = self.groups(ids);
                for ids in begun.iter().chain(lines) {
                    *out.restart = true;
                    out.line(pool, *ids);
                }
            }
            PrimitiveMode::Triangles => {
                let (begun, triangles) = self.groups(ids);
                out.triangles(pool, begun.as_slice());
                out.triangles(pool, triangles);
            }
            PrimitiveMode::Quads => {
                let (begun, quads) = self.groups(ids);
                for ids in begun.iter().chain(quads) {
                    let edges = ids.map(|id| pool.edge(id));
                    out.begin_polygon();
                    out.quad(pool, *ids, edges);
                }
            }
            PrimitiveMode::LineStrip => each.for_each(|id| {
                if self.held == 1 {
                    out.line(pool, [self.hold[0], id]);
                }
                (self.hold[0], self.held) = (id, 1);
            }),
            PrimitiveMode::LineLoop => each.for_each(|id| {
                // Held: the last vertex, then the first.
                match self.held {
                    0 => (self.hold[0], self.hold[1], self.held) = (id, id, 2),
                    _ => {
                        out.line(pool, [self.hold[0], id]);
                        (self.hold[0], self.count) = (id, 1);
                    }
                }
            }),
            PrimitiveMode::TriangleStrip => each.for_each(|id| {
                if self.held < 2 {
                    self.hold[self.held] = id;
                    self.held += 1;
                    return;
                }
                let [a, b, ..] = self.hold;
                let corners = if self.count & 1 == 0 { [a, b, id] } else { [b, a, id] };
                out.begin_polygon();
                out.triangle(pool, corners, 2, [true; 3]);
                self.count ^= 1;
                (self.hold[0], self.hold[1]) = (b, id);
            }),
            PrimitiveMode::TriangleFan => each.for_each(|id| self.fan(id, pool, out)),
            PrimitiveMode::Polygon => each.for_each(|id| self.polygon(id, pool, out)),
            PrimitiveMode::QuadStrip => each.for_each(|id| {
                if self.held < 3 {
                    self.hold[self.held] = id;
                    self.held += 1;
                    return;
                }
                let [a, b, c, _] = self.hold;
                // The outline is a b id c and id gives the flat colour: turned, so that id stands last.
                out.begin_polygon();
                out.quad(pool, [c, a, b, id], [true; 4]);
                (self.hold[0], self.hold[1], self.held) = (c, id, 2);
            }),
        }
    }

    fn fan(&mut self, id: u32, pool: &TransformedVertices, out: &mut AssemblyOutput<'_>) {
        if self.held < 2 {
            self.hold[self.held] = id;
            self.held += 1;
            return;
        }
        out.begin_polygon();
        out.triangle(pool, [self.hold[0], self.hold[1], id], 2, [true; 3]);
        self.hold[1] = id;
    }

    /// A polygon's last edge is known only at its end, so a triangle waits for the next vertex: held are the first, the last
    /// and the newest vertex.
    fn polygon(&mut self, id: u32, pool: &TransformedVertices, out: &mut AssemblyOutput<'_>) {
        if self.held < 3 {
            self.hold[self.held] = id;
            self.held += 1;
            return;
        }
        self.polygon_triangle(pool, out, false);
        (self.hold[1], self.hold[2]) = (self.hold[2], id);
        self.count = 1;
    }

    fn polygon_triangle(&mut self, pool: &TransformedVertices, out: &mut AssemblyOutput<'_>, last: bool) {
        let [first, a, b, _] = self.hold;
        if self.count == 0 {
            out.begin_polygon();
        }
        let edges = [self.count == 0 && pool.edge(first), pool.edge(a), last && pool.edge(b)];
        out.triangle(pool, [first, a, b], 0, edges);
    }

    /// Ends the primitive: a loop is closed, a polygon gets its last triangle, the rest is dropped.
    pub fn end(&mut self, pool: &TransformedVertices, out: &mut AssemblyOutput<'_>) {
        match self.mode {
            // A loop of one vertex draws nothing, of two the same segment twice.
            PrimitiveMode::LineLoop if self.count != 0 => out.line(pool, [self.hold[0], self.hold[1]]),
            PrimitiveMode::Polygon if self.held == 3 => self.polygon_triangle(pool, out, true),
            PrimitiveMode::Points
            | PrimitiveMode::Lines
            | PrimitiveMode::LineLoop
            | PrimitiveMode::LineStrip
            | PrimitiveMode::Triangles
            | PrimitiveMode::TriangleStrip
            | PrimitiveMode::TriangleFan
            | PrimitiveMode::Quads
            | PrimitiveMode::QuadStrip
            | PrimitiveMode::Polygon => {}
        }
        self.held = 0;
        self.count = 0;
    }
}
