//! A piece of a draw on its way from vertices to primitives (OpenGL 1.5, sections 2.6 to 2.14). Vertices are *placed*
//! first: position, window position, outcode. The assembler joins them and keeps the primitives that can be seen; only
//! the vertices of those get their *values* (lights, texture coordinates, colours), and then the primitives are handed
//! on, in the order in which they were issued. What nobody sees costs its positions and no more, and since a vertex
//! depends on nothing but itself, no bit changes.

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

/// Vertices and primitives under way.
#[derive(Clone, Debug)]
pub struct VertexProcessor {
    /// The batch that stages work on.
    pub batch: Box<VertexBatch>,
    pub(super) pool: TransformedVertices,
    assembler: Assembler,
    clipper: Clipper,
    seen: Vec<VisiblePrimitive>,
    /// What was done, for those who ask.
    pub counts: VertexCounts,
    /// Whether each vertex of the pool is used by something seen.
    used: Vec<bool>,
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
        }
    }
}

impl VertexProcessor {
    /// Starts a primitive.
    pub fn begin(&mut self, mode: PrimitiveMode) {
        self.assembler.begin(mode);
    }

    /// Assembles vertices of the pool.
    pub fn feed(&mut self, plan: &VertexPlan, culls: [bool; 2], ids: &[u32]) {
        let Self { assembler, pool, batch, seen, counts, .. } = self;
        assembler.feed(ids, pool, &mut AssemblyOutput { plan, culls, batch, seen, counts });
    }

    /// Assembles the vertices of the pool from one on: those of a batch.
    pub fn feed_batch(&mut self, plan: &VertexPlan, culls: [bool; 2], first: u32) {
        self.feed(plan, culls, consecutive(first, self.held()));
    }

    /// Ends the primitive.
    pub fn end(&mut self, plan: &VertexPlan, culls: [bool; 2]) {
        let Self { assembler, pool, batch, seen, counts, .. } = self;
        assembler.end(pool, &mut AssemblyOutput { plan, culls, batch, seen, counts });
    }

    /// Whether no vertex waits for others.
    #[must_use]
    pub fn is_between(&mut self) -> bool {
        self.waiting() == 0
    }

    /// How many vertices wait for others.
    #[must_use]
    pub fn waiting(&mut self) -> usize {
        self.assembler.held().len()
    }

    /// How many vertices the pool holds.
    #[must_use]
    pub fn held(&self) -> u32 {
        self.pool.len() as u32
    }

    /// Places the vertices of the batch.
    pub fn transform_positions(&mut self, plan: &VertexPlan) {
        let (places, _) = plan.plan.steps.split_at(plan.position_stages.min(plan.plan.steps.len()));
        plan.run(places, &mut self.batch);
        self.counts.placed += self.batch.n as u64;
    }

    /// Appends the vertices of the batch to the pool; the id of the first.
    pub fn append(&mut self) -> u32 {
        let first = self.held();
        self.pool.append(&self.batch);
        first
    }

    /// Gives the vertices of the batch, whose first has an id in the pool, their values, if something needs them.
    pub fn compute_varyings(&mut self, plan: &VertexPlan, first: u32) {
        if self.seen.is_empty() && self.assembler.held().is_empty() {
            return;
        }
        let steps = plan.plan.steps.get(plan.position_stages..).unwrap_or_default();
        plan.run(steps, &mut self.batch);
        self.counts.valued += self.batch.n as u64;
        self.pool.fill(&self.batch, first..first + self.batch.n as u32);
    }

    /// Places the vertices of elements, assembles them and gives those their values that can be seen. A batch is cut after
    /// `cut` vertices.
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

    /// Gives those vertices of the pool from `first` on their values that something needs. They run through all stages,
    /// since their batches are others than those that they were placed in. `keys` are their places in the source.
    fn compute_used_varyings<S: VertexSource>(&mut self, plan: &VertexPlan, source: &S, first: u32, keys: &Keys<'_>) {
        self.used.clear();
        self.used.resize(MAX_VERTICES, false);
        if let Some(used) = self.used.first_chunk_mut::<MAX_VERTICES>() {
            // What was held before comes out far behind the others.
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
                // Neighbours are read faster.
                let whole = matches!(keys, Keys::Range(_)) && at[n - 1] - at[0] == n as u32 - 1;
                let keys = if whole { Keys::Range(of[0]..of[0] + n as u32) } else { Keys::List(&of[..n]) };
                source.positions(&keys, &mut self.batch);
                source.attributes(&keys, &mut self.batch);
                plan.run(&plan.plan.steps, &mut self.batch);
                self.counts.valued += n as u64;
                self.pool.fill(&self.batch, at.into_iter().take(n).map(|at| first + at));
                n = 0;
            }
        }
    }

    /// Hands on some of what was seen, from a primitive on; how many primitives were seen.
    pub fn hand_on<S: TakePrimitives>(&mut self, plan: &VertexPlan, from: usize, most: usize, sink: &mut S) -> usize {
        let until = from.saturating_add(most).min(self.seen.len());
        let primitives = self.seen.get(from..until).unwrap_or_default();
        sink.take(primitives, plan, &self.pool, &mut self.clipper);
        self.seen.len()
    }

    /// Forgets what was seen and all vertices but those that the primitive still needs.
    pub fn clear(&mut self) {
        self.counts.seen += self.seen.len() as u64;
        self.counts.clipped += self.seen.iter().filter(|primitive| primitive.clips()).count() as u64;
        self.seen.clear();
        self.pool.keep(self.assembler.held());
    }
}

/// What a primitive may hold from the batch before, and a batch.
const IDS: [u32; 4 + LANES] = {
    let mut ids = [0; 4 + LANES];
    let mut i = 0;
    while i < ids.len() {
        ids[i] = i as u32;
        i += 1;
    }
    ids
};

/// The ids from one to before another.
pub(super) fn consecutive(from: u32, until: u32) -> &'static [u32] {
    static CONSECUTIVE: [u32; 4 + LANES] = IDS;
    CONSECUTIVE.get(from as usize..until as usize).unwrap_or(&[])
}
