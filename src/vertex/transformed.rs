//! Transformed vertices waiting to be assembled: the output of the vertex stages, transposed from lanes into one record a
//! vertex. When a batch ends, the vertices that a strip, fan or loop still needs move to the front.

use super::batch::VertexBatch;
use super::plan::VertexPlan;
use crate::fragment::planes::Layout;
use crate::limits::MAX_CLIP_PLANES;
use crate::raster::vertex::{ScreenPosition, Vertex, VertexRef, Vertices};
use crate::simd::LANES;

/// Most vertices; ids are taken modulo this number.
pub const MAX_VERTICES: usize = 8192;

/// Transformed vertices, by id.
#[derive(Clone, Debug, Default)]
pub struct TransformedVertices {
    /// How many vertices there are.
    count: usize,
    /// Window positions and outcodes, which decide over most triangles, apart from the rest. Empty, or [`MAX_VERTICES`]
    /// long.
    screen: Vec<ScreenPosition>,
    /// Edge flags.
    edges: Vec<bool>,
    /// Position parts and varyings, of those vertices for which they were computed.
    pub vertices: Vertices,
    /// Distances to the user clip planes, `user_stride` for each vertex.
    user: Vec<f64>,
    user_stride: usize,
    kept: Vec<f32>,
}

impl TransformedVertices {
    /// Forgets all vertices and takes the shape of a plan's output.
    pub fn reset(&mut self, plan: &VertexPlan) {
        self.count = 0;
        self.vertices.stride = plan.layout.stride;
        self.user.clear();
        self.user_stride = plan.uniforms.user_count.min(MAX_CLIP_PLANES);
    }

    /// How many vertices there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Window position and outcode of a vertex.
    #[inline]
    #[must_use]
    pub fn screen(&self, id: u32) -> ScreenPosition {
        self.screen.get(id as usize % MAX_VERTICES).copied().unwrap_or_default()
    }

    /// Window positions and outcodes of the corners of triangles.
    #[inline]
    pub fn corners(&self, triangles: &[[u32; 3]], corners: &mut [[ScreenPosition; LANES]; 3]) {
        let Some(places) = self.screen.first_chunk::<MAX_VERTICES>() else { return };
        let [a, b, c] = corners;
        for (ids, ((a, b), c)) in triangles.iter().zip(a.iter_mut().zip(b).zip(c)) {
            *a = places[ids[0] as usize % MAX_VERTICES];
            *b = places[ids[1] as usize % MAX_VERTICES];
            *c = places[ids[2] as usize % MAX_VERTICES];
        }
    }

    /// Whether the edge that begins at a vertex is a boundary edge.
    #[inline]
    #[must_use]
    pub fn edge(&self, id: u32) -> bool {
        self.edges.get(id as usize).is_none_or(|edge| *edge)
    }

    /// A vertex.
    #[inline]
    #[must_use]
    pub fn get(&self, id: u32) -> Option<VertexRef<'_>> {
        let i = id as usize;
        let head = self.vertices.head.get(i)?;
        Some(VertexRef { head, slots: self.vertices.slots(i) })
    }

    /// Distances of a vertex to the user clip planes.
    #[must_use]
    pub fn user(&self, id: u32) -> &[f64] {
        let i = id as usize * self.user_stride;
        self.user.get(i..i + self.user_stride).unwrap_or(&[])
    }

    /// Appends the vertices of a batch, without varyings.
    pub fn append(&mut self, b: &VertexBatch) {
        let n = b.n.min(LANES).min(MAX_VERTICES - self.count.min(MAX_VERTICES));
        self.make_room(n);
        let new = self.count..self.count + n;
        if let Some(places) = self.screen.get_mut(new.clone()) {
            places.copy_from_slice(&b.screen[..n]);
        }
        if let Some(edges) = self.edges.get_mut(new.clone()) {
            edges.copy_from_slice(&b.edge[..n]);
        }
        self.count = new.end;
        if self.user_stride > 0 {
            for i in 0..n {
                self.user.extend(b.user.iter().take(self.user_stride).map(|lanes| lanes[i]));
            }
        }
    }

    /// Makes room for more vertices. They keep what earlier ones had there: it is not read before it is written.
    fn make_room(&mut self, more: usize) {
        let count = self.count + more;
        if self.screen.is_empty() {
            self.screen.resize(MAX_VERTICES, ScreenPosition::default());
        }
        if self.edges.len() < count {
            self.edges.resize(count, true);
            self.vertices.head.resize(count, Vertex::default());
        }
        // Setup copies four slots at a time.
        let slots = count * self.vertices.stride + 4;
        if self.vertices.slots.len() < slots {
            self.vertices.slots.resize(slots, 0.0);
        }
    }

    /// Stores the position and the varyings of each lane of a batch, as the vertices with these ids.
    pub fn fill(&mut self, b: &VertexBatch, ids: impl Iterator<Item = u32> + Clone) {
        for (i, id) in (0..LANES).zip(ids.clone()) {
            let Some(head) = self.vertices.head.get_mut(id as usize) else { return };
            *head = Vertex {
                clip: [b.clip[0][i], b.clip[1][i], b.clip[2][i], b.clip[3][i]],
                window: [b.window[0][i], b.window[1][i], b.window[2][i]],
                snapped: b.screen[i].snapped(),
                outcode: b.screen[i].outcode(),
                edge: b.edge[i],
                point_size: b.point_size[i],
            };
        }
        let stride = self.vertices.stride.min(b.out.len());
        let (quads, rest) = b.out[..stride].as_chunks::<4>();
        for (i, id) in (0..LANES).zip(ids) {
            let at = id as usize * stride;
            let Some(vertex) = self.vertices.slots.get_mut(at..at + stride) else { return };
            let (four, one) = vertex.as_chunks_mut::<4>();
            for (slots, lanes) in four.iter_mut().zip(quads) {
                *slots = [lanes[0][i], lanes[1][i], lanes[2][i], lanes[3][i]];
            }
            for (slot, lanes) in one.iter_mut().zip(rest) {
                *slot = lanes[i];
            }
        }
    }

    /// Brings the slots of all vertices from one layout to another; a q that had no slot is 1.
    pub fn lay_out(&mut self, from: &Layout, to: &Layout) {
        if from == to {
            return;
        }
        let pairs = slot_pairs(from, to);
        self.kept.clear();
        for i in 0..self.len() {
            let old = self.vertices.slots(i);
            let first = self.kept.len();
            self.kept.resize(first + to.stride, 0.0);
            for unit in to.units.iter().flatten().filter(|unit| unit.has_q) {
                if let Some(q) = self.kept.get_mut(first + unit.base + unit.count) {
                    *q = 1.0;
                }
            }
            for &(at, place, n) in &pairs {
                for k in 0..n {
                    if let (Some(from), Some(to)) = (old.get(at + k), self.kept.get_mut(first + place + k)) {
                        *to = *from;
                    }
                }
            }
        }
        std::mem::swap(&mut self.vertices.slots, &mut self.kept);
        self.vertices.stride = to.stride;
    }

    /// Keeps only the vertices of these ids, at the front and in this order, and renames the ids to where they are.
    pub fn keep(&mut self, ids: &mut [u32]) {
        const MOST: usize = 4;
        let mut heads = [Vertex::default(); MOST];
        let mut user = [[0.0; MAX_CLIP_PLANES]; MOST];
        let mut places = [(ScreenPosition::default(), true); MOST];
        self.kept.clear();
        let mut count = 0;
        for ((id, place), (head, distances)) in
            ids.iter_mut().zip(&mut places).zip(heads.iter_mut().zip(user.iter_mut()))
        {
            *place = (self.screen(*id), self.edge(*id));
            if let Some(v) = self.get(*id) {
                *head = *v.head;
            }
            for (to, from) in distances.iter_mut().zip(self.user(*id)) {
                *to = *from;
            }
            let from = *id as usize * self.vertices.stride;
            let slots = self.vertices.slots.get(from..from + self.vertices.stride).unwrap_or(&[]);
            self.kept.extend_from_slice(slots);
            *id = count as u32;
            count += 1;
        }
        // One vertex may be kept twice.
        self.count = 0;
        self.make_room(count);
        self.count = count;
        for (to, from) in self.vertices.head.iter_mut().zip(&heads[..count]) {
            *to = *from;
        }
        for ((place, edge), from) in self.screen.iter_mut().zip(&mut self.edges).zip(&places[..count]) {
            (*place, *edge) = *from;
        }
        for (to, from) in self.vertices.slots.iter_mut().zip(&self.kept) {
            *to = *from;
        }
        self.user.clear();
        for distances in &user[..count] {
            self.user.extend_from_slice(&distances[..self.user_stride]);
        }
    }
}

/// What two layouts have in common: first slot in the one, first slot in the other, how many slots.
fn slot_pairs(from: &Layout, to: &Layout) -> Vec<(usize, usize, usize)> {
    let back = if to.secondary.is_some() { 7 } else { 4 };
    let mut pairs = Vec::new();
    let whole = [
        (from.color, to.color, 4),
        (from.secondary, to.secondary, 3),
        (from.fog, to.fog, 1),
        (from.back, to.back, back),
    ];
    pairs.extend(whole.into_iter().filter_map(|(a, b, n)| Some((a?, b?, n))));
    for (a, b) in from.units.iter().zip(&to.units) {
        if let (Some(a), Some(b)) = (a, b) {
            pairs.push((a.base, b.base, a.count.min(b.count)));
            if a.has_q && b.has_q {
                pairs.push((a.base + a.count, b.base + b.count, 1));
            }
        }
    }
    pairs
}
