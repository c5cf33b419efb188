//! Processed vertices waiting to be assembled: the output of the vertex stages, lane by lane turned into one record a
//! vertex. The vertices that a strip, fan or loop still needs when a batch ends move to the front of the pool.

use super::VertexRef;
use super::batch::VertexBatch;
use super::plan::VertexPlan;
use crate::batch::LANES;
use crate::fragment::planes::Layout;
use crate::limits::MAX_CLIP_PLANES;
use crate::raster::vertex::{Vertex, Vertices};

/// What decides over most triangles, close together: facing and outcodes are found without touching the rest.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(16))]
pub struct Place {
    /// Window position in 1/256 pixel.
    pub snapped: [i32; 2],
    /// Outcode.
    pub outcode: u32,
}

/// Processed vertices.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    places: Vec<Place>,
    /// Position parts and slots.
    pub vertices: Vertices,
    /// Distances to the user clip planes, `user_stride` for each vertex.
    user: Vec<f64>,
    user_stride: usize,
    kept: Vec<f32>,
}

impl Pool {
    /// Forgets all vertices and takes the shape of a plan's output.
    pub fn reset(&mut self, plan: &VertexPlan) {
        self.places.clear();
        self.vertices.head.clear();
        self.vertices.stride = plan.layout.stride;
        self.user.clear();
        self.user_stride = plan.uniforms.user_count.min(MAX_CLIP_PLANES);
    }

    /// How many vertices there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vertices.head.len()
    }

    /// Whether there is no vertex.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.vertices.head.is_empty()
    }

    /// What decides over a triangle with these corners.
    #[inline(always)]
    #[must_use]
    pub fn places(&self, [a, b, c]: [u32; 3]) -> Option<[&Place; 3]> {
        let place = |id: u32| self.places.get(id as usize);
        Some([place(a)?, place(b)?, place(c)?])
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

    /// Appends the places of the vertices of a batch; they have no values yet.
    pub fn append(&mut self, b: &VertexBatch) {
        let n = b.n.min(LANES);
        self.vertices.head.extend((0..n).map(|i| Vertex {
            clip: [b.clip[0][i], b.clip[1][i], b.clip[2][i], b.clip[3][i]],
            window: [b.window[0][i], b.window[1][i], b.window[2][i]],
            snapped: [b.snapped[0][i], b.snapped[1][i]],
            outcode: b.outcode[i],
            edge: b.edge[i],
            point_size: b.point_size[i],
        }));
        let [xs, ys] = &b.snapped;
        self.places.extend((0..n).map(|i| Place { snapped: [xs[i], ys[i]], outcode: b.outcode[i] }));
        self.make_slots();
        if self.user_stride > 0 {
            for i in 0..n {
                self.user.extend(b.user.iter().take(self.user_stride).map(|lanes| lanes[i]));
            }
        }
    }

    /// Makes room for the values of all vertices. Those that nobody has given yet are never read, so what earlier vertices
    /// had may stay there.
    fn make_slots(&mut self) {
        let slots = self.vertices.head.len() * self.vertices.stride;
        if self.vertices.slots.len() < slots {
            self.vertices.slots.resize(slots, 0.0);
        }
    }

    /// Gives the vertex of each lane of a batch its values.
    pub fn fill(&mut self, b: &VertexBatch, ids: impl Iterator<Item = u32>) {
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
        self.kept.clear();
        let mut count = 0;
        for (id, (head, distances)) in ids.iter_mut().zip(heads.iter_mut().zip(user.iter_mut())) {
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
        self.vertices.head.clear();
        self.vertices.head.extend_from_slice(&heads[..count]);
        self.places.clear();
        self.places.extend(heads[..count].iter().map(|v| Place { snapped: v.snapped, outcode: v.outcode }));
        // One vertex may be kept twice.
        self.make_slots();
        for (to, from) in self.vertices.slots.iter_mut().zip(&self.kept) {
            *to = *from;
        }
        self.user.clear();
        for distances in &user[..count] {
            self.user.extend_from_slice(&distances[..self.user_stride]);
        }
    }
}

/// What two layouts have in common: place in the first, place in the second, how many slots.
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
