//! The vertex pipeline as the context holds it: vertices go in one by one (Begin/End) or in whole batches (arrays),
//! primitives come out. Vertices wait until 64 are there. Those of the next Begin/End pair join them while the state is the
//! same, so that many small primitives fill batches as one large one does. Where batches are cut changes no bit.

use super::batch::{self, LIST_VERTICES, needs};
use super::draw_worker::{DrawWorker, WORTH_CUTTING};
use super::hand_on::TakePrimitives;
use super::plan::{VertexPlan, Wants};
use super::processor::{VertexProcessor, consecutive};
use super::setup_job::SetupJobPool;
use super::vertex_store::VertexStore;
use crate::fragment::planes::Layout;
use crate::raster::{FragmentProgram, SetupFn};
use crate::simd::{LANES, Level};
use crate::state::State;
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;

/// A primitive, or a part of one, in the waiting batch.
#[derive(Clone, Copy, Debug)]
struct PrimitiveRange {
    mode: PrimitiveMode,
    /// The primitive begins here; otherwise it goes on from the batch before.
    begins: bool,
    /// The primitive ends here.
    ends: bool,
    /// The lane after its last vertex.
    until: u32,
}

/// The vertex pipeline.
#[derive(Clone, Debug)]
pub struct VertexPipeline {
    /// The plan of the waiting vertices.
    pub plan: VertexPlan,
    /// Vertices that wait, and those that the primitive still needs.
    pub worker: DrawWorker,
    cut: usize,
    /// With how many vertices the batch is full: `cut`, or fewer so that it holds whole triangles.
    limit: usize,
    ranges: Vec<PrimitiveRange>,
    /// Whether a primitive has begun and not ended.
    inside: bool,
    /// Collected vertices of one long primitive, before those that wait: several threads may share them.
    store: VertexStore,
}

/// Most vertices that are collected; a multiple of 3, 4 and 64.
const MOST_COLLECTED: usize = 256 * 192;
/// Vertices of a setup job for the raster thread; a multiple of 3, 4 and 64.
const JOB_VERTICES: usize = 24 * 192;
/// Most ranges that wait: empty Begin/End pairs must not pile up.
const MOST_RANGES: usize = 64;

impl VertexPipeline {
    /// A pipeline without vertices. `cut` limits how many make a batch, for tests that compare cuts.
    #[must_use]
    pub fn new(level: Level, cut: usize) -> Self {
        Self {
            plan: VertexPlan::new(level),
            worker: DrawWorker::default(),
            cut: cut.clamp(1, LANES),
            limit: cut.clamp(1, LANES),
            ranges: Vec::new(),
            inside: false,
            store: VertexStore::default(),
        }
    }

    /// How many vertices make a batch.
    #[must_use]
    pub fn cut(&self) -> usize {
        self.cut
    }

    /// Whether vertices wait, or a primitive has begun.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        !self.ranges.is_empty()
    }

    /// Takes a state; vertices that wait must have been [run](Self::run) before.
    pub fn rebuild(&mut self, state: &State, layout: &Layout, wants: Wants) {
        if self.inside {
            // A material, or a q that is not 1, between Begin and End: vertices that a strip still needs keep their values.
            self.worker.processor.pool.lay_out(&self.plan.layout, layout);
            self.plan.build(state, layout, wants);
        } else {
            self.plan.build(state, layout, wants);
            self.worker.processor.pool.reset(&self.plan);
        }
        if self.plan.needs & needs::EDGE == 0 {
            self.worker.processor.batch.edge = [true; LANES];
        }
    }

    /// Begins a primitive.
    #[inline]
    pub fn begin(&mut self, mode: PrimitiveMode) {
        let n = self.worker.processor.batch.n;
        let in_step = n == 0 || (self.limit == LIST_VERTICES && n.is_multiple_of(3));
        self.limit = if in_step { self.cut.min(batch::block(mode)) } else { self.cut };
        self.inside = true;
        self.ranges.push(PrimitiveRange { mode, begins: true, ends: false, until: n as u32 });
    }

    /// Appends a vertex unless the batch would be full with it; false says that nothing has been done.
    #[inline(always)]
    pub fn vertex_at_once(&mut self, position: [f32; 4], current: &Current) -> bool {
        let batch = &mut self.worker.processor.batch;
        let at_once = batch.n + 1 < self.limit;
        if at_once {
            batch.push(position, current, self.plan.needs);
        }
        at_once
    }

    /// Appends a vertex; true says that the batch is full and wants to [run](Self::run).
    #[inline]
    pub fn vertex(&mut self, position: [f32; 4], current: &Current) -> bool {
        self.worker.processor.batch.push(position, current, self.plan.needs);
        self.worker.processor.batch.n >= self.limit
    }

    /// Ends the primitive; true says that enough waits to [run](Self::run).
    #[inline]
    pub fn end(&mut self) -> bool {
        self.inside = false;
        let until = self.worker.processor.batch.n as u32;
        if let Some(range) = self.ranges.last_mut() {
            range.until = until;
            range.ends = true;
        }
        self.ranges.len() >= MOST_RANGES || self.worker.processor.batch.n >= self.limit
    }

    /// Collects the full batch instead of running it, if its vertices are separate triangles or quadrilaterals of one long
    /// primitive. False if they are not.
    pub fn collect(&mut self) -> bool {
        let Self { plan, worker: DrawWorker { processor, .. }, store, ranges, .. } = self;
        let [
            PrimitiveRange {
                mode: mode @ (PrimitiveMode::Triangles | PrimitiveMode::Quads), begins, ends: false, ..
            },
        ] = ranges.as_mut_slice()
        else {
            return false;
        };
        // Between two triangles the primitive may as well begin anew.
        *begins |= processor.is_between();
        let batch = &mut processor.batch;
        if !*begins || batch.n != batch::block(*mode) || plan.needs & needs::EDGE != 0 {
            return false;
        }
        if store.is_empty() {
            store.clear(plan.needs, batch.n);
        }
        let collected = store.push(batch);
        if collected {
            batch.clear();
        }
        collected
    }

    /// Whether vertices have been collected.
    #[must_use]
    pub fn has_collected(&self) -> bool {
        !self.store.is_empty()
    }

    /// What was collected, as a job for another thread, if it is enough.
    pub fn take_setup_job<P: FragmentProgram>(&mut self, jobs: &SetupJobPool) -> Option<SetupFn<P>> {
        let mode = self.ranges.first()?.mode;
        let enough = self.store.len() >= JOB_VERTICES;
        enough.then(|| jobs.make(&self.plan, mode, self.cut, &mut self.store))
    }

    /// What was collected, if it is enough for a draw of its own. The primitive goes on as if it had just begun, unless it
    /// has ended.
    pub fn take_collected(&mut self) -> Option<(PrimitiveMode, VertexStore)> {
        let PrimitiveRange { mode, ends, .. } = *self.ranges.first()?;
        if self.store.len() < if ends { WORTH_CUTTING } else { MOST_COLLECTED } {
            return None;
        }
        if ends {
            let batch = &mut self.worker.processor.batch;
            if batch.n > 0 && !self.store.push(batch) {
                return None;
            }
            batch.clear();
            self.ranges.clear();
        }
        Some((mode, std::mem::take(&mut self.store)))
    }

    /// Takes the memory of a store back.
    pub fn give_back(&mut self, mut store: VertexStore) {
        store.clear(0, LANES);
        self.store = store;
    }

    /// Runs the waiting vertices and hands on the primitives.
    pub fn run<S: TakePrimitives>(&mut self, sink: &mut S) {
        if !self.store.is_empty() {
            self.run_collected(sink);
        }
        self.run_batch(sink);
    }

    /// Runs the collected vertices; those in the batch go on waiting.
    fn run_collected<S: TakePrimitives>(&mut self, sink: &mut S) {
        let (ranges, inside) = (self.ranges.clone(), self.inside);
        let store = std::mem::take(&mut self.store);
        let waiting = self.worker.processor.batch.clone();
        for block in 0..store.blocks() {
            store.load(block, &mut self.worker.processor.batch);
            let mode = ranges.first().map_or(PrimitiveMode::Triangles, |range| range.mode);
            self.ranges = vec![PrimitiveRange { mode, begins: block == 0, ends: false, until: 0 }];
            self.inside = true;
            self.run_batch(sink);
        }
        self.worker.processor.batch = waiting;
        (self.ranges, self.inside) = (ranges, inside);
        if let Some(range) = self.ranges.first_mut() {
            range.begins = false;
        }
        self.give_back(store);
    }

    fn run_batch<S: TakePrimitives>(&mut self, sink: &mut S) {
        let Self { plan, worker: DrawWorker { processor, .. }, ranges, .. } = self;
        let Some(last) = ranges.last_mut() else { return };
        if self.inside {
            last.until = processor.batch.n as u32;
        }
        let open = self.inside.then_some(last.mode);
        let culls = sink.culls();
        let triangles =
            ranges.iter().all(|range| range.mode == PrimitiveMode::Triangles && range.until.is_multiple_of(3));
        if processor.run_triangle_list(plan, triangles, culls, sink) {
            ranges.iter().filter(|range| range.begins).for_each(|range| processor.begin(range.mode));
        } else {
            Self::assemble(plan, processor, ranges, culls, sink);
        }
        processor.batch.clear();
        ranges.clear();
        let cut = self.cut;
        self.limit = cut;
        if let Some(mode) = open {
            if mode == PrimitiveMode::Triangles && cut == LANES {
                // The next batch ends with a whole triangle.
                let waiting = processor.waiting();
                self.limit = if waiting == 0 { LIST_VERTICES } else { cut - (cut + waiting) % 3 };
            }
            ranges.push(PrimitiveRange { mode, begins: false, ends: false, until: 0 });
        }
    }

    /// Makes primitives of the batch, whose positions have been transformed.
    fn assemble<S: TakePrimitives>(
        plan: &VertexPlan,
        processor: &mut VertexProcessor,
        ranges: &[PrimitiveRange],
        culls: [bool; 2],
        sink: &mut S,
    ) {
        let mut next = processor.held();
        let first = processor.append();
        for range in ranges {
            if range.begins {
                processor.begin(range.mode);
            }
            let until = (first + range.until).max(next);
            processor.feed(plan, culls, consecutive(next, until));
            next = until;
            if range.ends {
                processor.end(plan, culls);
            }
        }
        processor.compute_varyings(plan, first);
        processor.hand_on(plan, 0, usize::MAX, sink);
        processor.clear();
    }
}
