//! The vertex pipe as the context holds it: vertices go in one by one (Begin/End) or in whole batches (arrays),
//! primitives come out. Vertices wait until 64 are there; a new Begin/End pair with the same state joins the ones that
//! wait, so that many small primitives fill batches as one large one does. The cut into batches changes no bit.

use super::Assembled;
use super::batch::needs;
use super::chunk::{Chunk, consecutive};
use super::draw_worker::{Lane, WORTH_CUTTING};
use super::plan::{VertexPlan, Wants};
use super::setup_job::Pieces;
use super::triangle_list::{self, IN_STEP};
use super::vertex_store::Store;
use crate::enums::{GL_QUADS, GL_TRIANGLES, GLenum};
use crate::fragment::planes::Layout;
use crate::raster::{SetUp, Shader};
use crate::simd::{LANES, Level};
use crate::state::State;
use crate::state::current::Current;

/// A piece of a primitive in the waiting batch.
#[derive(Clone, Copy, Debug)]
struct Span {
    mode: GLenum,
    /// The primitive begins here; otherwise it goes on from the batch before.
    begins: bool,
    /// The primitive ends here.
    ends: bool,
    /// The lane after its last vertex.
    until: u32,
}

/// The vertex pipe.
#[derive(Clone, Debug)]
pub struct Pipe {
    /// The plan that waiting vertices run by.
    pub plan: VertexPlan,
    /// Vertices that wait, and those that the primitive still needs.
    pub lane: Lane,
    cut: usize,
    /// With how many vertices the batch at hand is full: as many as `cut`, or fewer so that triangles are in step.
    limit: usize,
    spans: Vec<Span>,
    inside: bool,
    /// Vertices before those that wait, all of one primitive: a long one is collected for several threads.
    store: Store,
}

/// How many vertices are collected at most; a multiple of 3, 4 and 64.
const MOST_COLLECTED: usize = 256 * 192;
/// Vertices of a piece for a thread that walks; a multiple of 3, 4 and 64.
const PIECE: usize = 24 * 192;
/// How many pieces of primitives may wait, so that empty Begin/End pairs do not pile up.
const MOST_SPANS: usize = 64;

impl Pipe {
    /// A pipe with no vertices. `cut` limits how many vertices make a batch, for tests that compare cuts.
    #[must_use]
    pub fn new(level: Level, cut: usize) -> Self {
        Self {
            plan: VertexPlan::new(level),
            lane: Lane::default(),
            cut: cut.clamp(1, LANES),
            limit: cut.clamp(1, LANES),
            spans: Vec::new(),
            inside: false,
            store: Store::default(),
        }
    }

    /// How many vertices make a batch.
    #[must_use]
    pub fn cut(&self) -> usize {
        self.cut
    }

    /// Whether vertices wait, or a primitive is under way.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        !self.spans.is_empty()
    }

    /// Takes a state; vertices that wait must have been [run](Self::run) before.
    pub fn rebuild(&mut self, state: &State, layout: &Layout, wants: Wants) {
        if self.inside {
            // A material, or a q that is not 1, between Begin and End: vertices that a strip holds stay as they are.
            self.lane.chunk.pool.lay_out(&self.plan.layout, layout);
            self.plan.build(state, layout, wants);
        } else {
            self.plan.build(state, layout, wants);
            self.lane.chunk.pool.reset(&self.plan);
        }
        if self.plan.needs & needs::EDGE == 0 {
            self.lane.chunk.batch.edge = [true; LANES];
        }
    }

    /// Begins a primitive.
    #[inline]
    pub fn begin(&mut self, mode: GLenum) {
        let n = self.lane.chunk.batch.n;
        let in_step = n == 0 || (self.limit == IN_STEP && n.is_multiple_of(3));
        self.limit = if in_step { self.cut.min(triangle_list::block(mode)) } else { self.cut };
        self.inside = true;
        self.spans.push(Span { mode, begins: true, ends: false, until: n as u32 });
    }

    /// Appends a vertex if the batch is not full with it; false says that nothing has been done.
    #[inline(always)]
    pub fn vertex_at_once(&mut self, position: [f32; 4], current: &Current) -> bool {
        let batch = &mut self.lane.chunk.batch;
        let at_once = batch.n + 1 < self.limit;
        if at_once {
            batch.push(position, current, self.plan.needs);
        }
        at_once
    }

    /// Appends a vertex; true says that the batch is full and wants to [run](Self::run).
    #[inline]
    pub fn vertex(&mut self, position: [f32; 4], current: &Current) -> bool {
        self.lane.chunk.batch.push(position, current, self.plan.needs);
        self.lane.chunk.batch.n >= self.limit
    }

    /// Ends the primitive; true says that enough waits to [run](Self::run).
    #[inline]
    pub fn end(&mut self) -> bool {
        self.inside = false;
        let until = self.lane.chunk.batch.n as u32;
        if let Some(span) = self.spans.last_mut() {
            span.until = until;
            span.ends = true;
        }
        self.spans.len() >= MOST_SPANS || self.lane.chunk.batch.n >= self.limit
    }

    /// Collects the full batch instead of running it: vertices of one long primitive, of which any three or four in a row
    /// are a triangle or a quadrilateral. False where they are not.
    pub fn collect(&mut self) -> bool {
        let Self { plan, lane: Lane { chunk, .. }, store, spans, .. } = self;
        let [Span { mode: mode @ (GL_TRIANGLES | GL_QUADS), begins, ends: false, .. }] = spans.as_mut_slice() else {
            return false;
        };
        // Between two triangles the primitive might as well begin anew.
        *begins |= chunk.is_between();
        let batch = &mut chunk.batch;
        if !*begins || batch.n != triangle_list::block(*mode) || plan.needs & needs::EDGE != 0 {
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

    /// What was collected as a piece for another thread, if it is enough.
    pub fn take_piece<P: Shader>(&mut self, pieces: &Pieces) -> Option<SetUp<P>> {
        let mode = self.spans.first()?.mode;
        let enough = self.store.len() >= PIECE;
        enough.then(|| pieces.make(&self.plan, mode, self.cut, &mut self.store))
    }

    /// What was collected, if it is enough to be drawn by itself: whole triangles and quadrilaterals. The primitive goes
    /// on as if it had just begun, unless it has ended.
    pub fn take_collected(&mut self) -> Option<(GLenum, Store)> {
        let Span { mode, ends, .. } = *self.spans.first()?;
        if self.store.len() < if ends { WORTH_CUTTING } else { MOST_COLLECTED } {
            return None;
        }
        if ends {
            let batch = &mut self.lane.chunk.batch;
            if batch.n > 0 && !self.store.push(batch) {
                return None;
            }
            batch.clear();
            self.spans.clear();
        }
        Some((mode, std::mem::take(&mut self.store)))
    }

    /// Gives the memory of what was collected back.
    pub fn give_back(&mut self, mut store: Store) {
        store.clear(0, LANES);
        self.store = store;
    }

    /// Runs the waiting vertices and hands on the primitives.
    pub fn run<S: Assembled>(&mut self, sink: &mut S) {
        if !self.store.is_empty() {
            self.run_collected(sink);
        }
        self.run_batch(sink);
    }

    /// Runs what was collected; the batch that waits stays.
    fn run_collected<S: Assembled>(&mut self, sink: &mut S) {
        let (spans, inside) = (self.spans.clone(), self.inside);
        let store = std::mem::take(&mut self.store);
        let waiting = self.lane.chunk.batch.clone();
        for block in 0..store.blocks() {
            store.load(block, &mut self.lane.chunk.batch);
            let mode = spans.first().map_or(GL_TRIANGLES, |span| span.mode);
            self.spans = vec![Span { mode, begins: block == 0, ends: false, until: 0 }];
            self.inside = true;
            self.run_batch(sink);
        }
        self.lane.chunk.batch = waiting;
        (self.spans, self.inside) = (spans, inside);
        if let Some(span) = self.spans.first_mut() {
            span.begins = false;
        }
        self.give_back(store);
    }

    fn run_batch<S: Assembled>(&mut self, sink: &mut S) {
        let Self { plan, lane: Lane { chunk, .. }, spans, .. } = self;
        let Some(last) = spans.last_mut() else { return };
        if self.inside {
            last.until = chunk.batch.n as u32;
        }
        let open = self.inside.then_some(last.mode);
        let culls = sink.culls();
        let triangles = spans.iter().all(|span| span.mode == GL_TRIANGLES && span.until.is_multiple_of(3));
        if chunk.place_in_step(plan, triangles, culls, sink) {
            spans.iter().filter(|span| span.begins).for_each(|span| chunk.begin(span.mode));
        } else {
            Self::assemble(plan, chunk, spans, culls, sink);
        }
        chunk.batch.clear();
        spans.clear();
        let cut = self.cut;
        self.limit = cut;
        if let Some(mode) = open {
            if mode == GL_TRIANGLES && cut == LANES {
                // Where vertices are left over, the batch ends so that none will be.
                let waiting = chunk.waiting();
                self.limit = if waiting == 0 { IN_STEP } else { cut - (cut + waiting) % 3 };
            }
            spans.push(Span { mode, begins: false, ends: false, until: 0 });
        }
    }

    /// Makes primitives of the batch, which has been placed.
    fn assemble<S: Assembled>(plan: &VertexPlan, chunk: &mut Chunk, spans: &[Span], culls: [bool; 2], sink: &mut S) {
        let mut next = chunk.held();
        let first = chunk.append();
        for span in spans {
            if span.begins {
                chunk.begin(span.mode);
            }
            let until = (first + span.until).max(next);
            chunk.feed(plan, culls, consecutive(next, until));
            next = until;
            if span.ends {
                chunk.end(plan, culls);
            }
        }
        chunk.value_batch(plan, first);
        chunk.hand_on(plan, 0, usize::MAX, sink);
        chunk.clear();
    }
}
