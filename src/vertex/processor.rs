//! From vertices to primitives (OpenGL 1.5, sections 2.6 to 2.14), a part of a draw at a time. Positions are transformed
//! first: clip and window coordinates, outcode. The assembler joins the vertices and keeps the primitives that may be
//! visible; only the vertices of those get their varyings (lighting, texture coordinates, colours). Then the primitives are
//! handed on in issue order. A vertex depends on nothing but itself, so leaving one out changes no bit.

use super::assemble::{Assembler, AssemblyOutput, VisiblePrimitive};
use super::batch::VertexBatch;
use super::cache::IndexedChunk;
use super::clip::Clipper;
use super::counts::VertexCounts;
use super::hand_on::TakePrimitives;
use super::plan::VertexPlan;
use super::source::{Keys, VertexSource};
use super::transformed::{MAX_VERTICES, TransformedVertices};
use crate::simd::LANES;
use crate::state::primitive::PrimitiveMode;

/// Vertices and primitives of a part of a draw.
#[derive(Clone, Debug)]
pub struct VertexProcessor {
    /// The batch that stages work on.
    pub batch: Box<VertexBatch>,
    pub(super) pool: TransformedVertices,
    assembler: Assembler,
    clipper: Clipper,
    seen: Vec<VisiblePrimitive>,
    /// What became of vertices and primitives.
    pub counts: VertexCounts,
    /// Whether each vertex is used by a primitive that may be visible.
    used: Vec<bool>,
    /// Whether the next line starts the stipple anew.
    restart: bool,
}

impl Default for VertexProcessor {
    fn default() -> Self {
        Self {
            batch: VertexBatch::new(),
            pool: TransformedVertices::default(),
            assembler: Assembler::default(),
            clipper: Clipper::default(),
            seen: Vec::new(),
            counts: VertexCounts::default(),
            used: Vec::new(),
            restart: true,
        }
    }
}

impl VertexProcessor {
    /// Starts a primitive.
    pub fn begin(&mut self, mode: PrimitiveMode) {
        self.assembler.begin(mode);
        self.restart = true;
    }

    /// Assembles transformed vertices.
    pub fn feed(&mut self, plan: &VertexPlan, culls: [bool; 2], ids: &[u32]) {
        let Self { assembler, pool, batch, seen, counts, restart, .. } = self;
        assembler.feed(ids, pool, &mut AssemblyOutput { plan, culls, batch, seen, counts, restart });
    }

    /// Assembles the transformed vertices from `first` on.
    pub fn feed_batch(&mut self, plan: &VertexPlan, culls: [bool; 2], first: u32) {
        self.feed(plan, culls, consecutive(first, self.held()));
    }

    /// Ends the primitive.
    pub fn end(&mut self, plan: &VertexPlan, culls: [bool; 2]) {
        let Self { assembler, pool, batch, seen, counts, restart, .. } = self;
        assembler.end(pool, &mut AssemblyOutput { plan, culls, batch, seen, counts, restart });
    }

    /// Whether no vertex waits for others of its primitive.
    #[must_use]
    pub fn is_between(&mut self) -> bool {
        self.waiting() == 0
    }

    /// How many vertices wait for others of their primitive.
    #[must_use]
    pub fn waiting(&mut self) -> usize {
        self.assembler.held().len()
    }

    /// How many transformed vertices there are.
    #[must_use]
    pub fn held(&self) -> u32 {
        self.pool.len() as u32
    }

    /// Transforms the positions of the batch.
    pub fn transform_positions(&mut self, plan: &VertexPlan) {
        let (places, _) = plan.plan.steps.split_at(plan.position_stages.min(plan.plan.steps.len()));
        plan.run(places, &mut self.batch);
        self.counts.positions += self.batch.n as u64;
    }

    /// Appends the batch to the transformed vertices. Returns the id of the first.
    pub fn append(&mut self) -> u32 {
        let first = self.held();
        self.pool.append(&self.batch);
        first
    }

    /// Computes the varyings of the batch, whose first vertex has the id `first`, if a primitive needs them.
    pub fn compute_varyings(&mut self, plan: &VertexPlan, first: u32) {
        if self.seen.is_empty() && self.assembler.held().is_empty() {
            return;
        }
        let steps = plan.plan.steps.get(plan.position_stages..).unwrap_or_default();
        plan.run(steps, &mut self.batch);
        self.counts.varyings += self.batch.n as u64;
        self.pool.fill(&self.batch, first..first + self.batch.n as u32);
    }

    /// Transforms, assembles, and computes the varyings of the vertices of an indexed draw that are needed. A batch is cut
    /// after `cut` vertices.
    pub fn elements<S: VertexSource>(
        &mut self,
        plan: &VertexPlan,
        source: &S,
        elements: IndexedChunk<'_>,
        cut: usize,
        culls: [bool; 2],
    ) {
        let first = self.held();
        let cut = cut.clamp(1, LANES);
        for from in (0..elements.keys.len()).step_by(cut) {
            source.positions(&elements.keys.part(from, from + cut), &mut self.batch);
            self.transform_positions(plan);
            self.append();
        }
        self.feed(plan, culls, elements.ids);
        if !self.seen.is_empty() || !self.assembler.held().is_empty() {
            self.compute_used_varyings(plan, source, first, &elements.keys);
        }
    }

    /// Computes the varyings of those vertices from `first` on that a primitive needs. They run through all stages again,
    /// since their batches are others than those of the positions. `keys` says which elements of the source they are.
    fn compute_used_varyings<S: VertexSource>(&mut self, plan: &VertexPlan, source: &S, first: u32, keys: &Keys<'_>) {
        self.used.clear();
        self.used.resize(MAX_VERTICES, false);
        if let Some(used) = self.used.first_chunk_mut::<MAX_VERTICES>() {
            // Ids below `first` wrap around to the end, which is not looked at.
            let mut mark = |id: u32| used[id.wrapping_sub(first) as usize % MAX_VERTICES] = true;
            self.seen.iter().for_each(|primitive| primitive.ids().into_iter().for_each(&mut mark));
            self.assembler.held().iter().for_each(|id| mark(*id));
        }
        let (mut at, mut of, mut n) = ([0; LANES], [0; LANES], 0);
        let last = keys.len().saturating_sub(1);
        for (i, used) in self.used.iter().enumerate().take(keys.len()) {
            if *used {
                (at[n], of[n]) = (i as u32, keys.get(i).unwrap_or(0));
                n += 1;
            }
            if n == LANES || (i == last && n > 0) {
                // A range is read faster than a list.
                let whole = matches!(keys, Keys::Range(_)) && at[n - 1] - at[0] == n as u32 - 1;
                let keys = if whole { Keys::Range(of[0]..of[0] + n as u32) } else { Keys::List(&of[..n]) };
                source.positions(&keys, &mut self.batch);
                source.attributes(&keys, &mut self.batch);
                plan.run(&plan.plan.steps, &mut self.batch);
                self.counts.varyings += n as u64;
                self.pool.fill(&self.batch, at.into_iter().take(n).map(|at| first + at));
                n = 0;
            }
        }
    }

    /// Hands on at most so many visible primitives, from one on. Returns how many there are in all.
    pub fn hand_on<S: TakePrimitives>(&mut self, plan: &VertexPlan, from: usize, most: usize, sink: &mut S) -> usize {
        let until = from.saturating_add(most).min(self.seen.len());
        let primitives = self.seen.get(from..until).unwrap_or_default();
        sink.take(primitives, plan, &self.pool, &mut self.clipper);
        self.seen.len()
    }

    /// Forgets the primitives and all vertices but those that the assembler still needs.
    pub fn clear(&mut self) {
        self.counts.seen += self.seen.len() as u64;
        self.counts.clipped += self.seen.iter().filter(|primitive| primitive.clips()).count() as u64;
        self.seen.clear();
        self.pool.keep(self.assembler.held());
    }
}

/// Ids of the vertices that a primitive may still need from the batch before, and of a batch.
const IDS: [u32; 4 + LANES] = {
    let mut ids = [0; 4 + LANES];
    let mut i = 0;
    while i < ids.len() {
        ids[i] = i as u32;
        i += 1;
    }
    ids
};

/// The ids `from..until`.
pub(super) fn consecutive(from: u32, until: u32) -> &'static [u32] {
    static CONSECUTIVE: [u32; 4 + LANES] = IDS;
    CONSECUTIVE.get(from as usize..until as usize).unwrap_or(&[])
}
