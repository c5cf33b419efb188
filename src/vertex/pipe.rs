//! The vertex pipe as the context holds it: vertices go in one by one (Begin/End) or in whole batches (arrays),
//! primitives come out. Vertices wait until 64 are there; a new Begin/End pair with the same state joins the ones that
//! wait, so that many small primitives fill batches as one large one does. The cut into batches changes no bit.

use super::Assembled;
use super::assemble::{Assembler, Output};
use super::batch::{VertexBatch, needs};
use super::clip::Clipper;
use super::plan::{VertexPlan, Wants};
use super::pool::Pool;
use crate::batch::{LANES, Level};
use crate::enums::GLenum;
use crate::fragment::planes::Layout;
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
    /// Vertices that wait.
    pub batch: Box<VertexBatch>,
    cut: usize,
    spans: Vec<Span>,
    inside: bool,
    pool: Pool,
    assembler: Assembler,
    clipper: Clipper,
}

/// How many pieces of primitives may wait, so that empty Begin/End pairs do not pile up.
const MOST_SPANS: usize = 64;

impl Pipe {
    /// A pipe with no vertices. `cut` limits how many vertices make a batch, for tests that compare cuts.
    #[must_use]
    pub fn new(level: Level, cut: usize) -> Self {
        Self {
            plan: VertexPlan::new(level),
            batch: VertexBatch::new(),
            cut: cut.clamp(1, LANES),
            spans: Vec::new(),
            inside: false,
            pool: Pool::default(),
            assembler: Assembler::default(),
            clipper: Clipper::default(),
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
            self.pool.lay_out(&self.plan.layout, layout);
            self.plan.build(state, layout, wants);
        } else {
            self.plan.build(state, layout, wants);
            self.pool.reset(&self.plan);
        }
        if self.plan.needs & needs::EDGE == 0 {
            self.batch.edge = [true; LANES];
        }
    }

    /// Begins a primitive.
    #[inline]
    pub fn begin(&mut self, mode: GLenum) {
        self.inside = true;
        self.spans.push(Span { mode, begins: true, ends: false, until: self.batch.n as u32 });
    }

    /// Appends a vertex; true says that the batch is full and wants to [run](Self::run).
    #[inline]
    pub fn vertex(&mut self, position: [f32; 4], current: &Current) -> bool {
        self.batch.push(position, current, self.plan.needs);
        self.batch.n >= self.cut
    }

    /// Ends the primitive; true says that enough waits to [run](Self::run).
    #[inline]
    pub fn end(&mut self) -> bool {
        self.inside = false;
        let until = self.batch.n as u32;
        if let Some(span) = self.spans.last_mut() {
            span.until = until;
            span.ends = true;
        }
        self.spans.len() >= MOST_SPANS || self.batch.n >= self.cut
    }

    /// Runs the waiting vertices and hands on the primitives.
    pub fn run<S: Assembled>(&mut self, sink: &mut S) {
        let Some(last) = self.spans.last_mut() else { return };
        if self.inside {
            last.until = self.batch.n as u32;
        }
        let open = self.inside.then_some(last.mode);
        let mut next = self.pool.len() as u32;
        transform(&self.plan, &mut self.batch);
        self.pool.append(&self.batch);
        self.batch.clear();
        let first = next;
        let mut out = Output::new(&self.plan, &mut self.clipper, sink);
        for span in &self.spans {
            if span.begins {
                self.assembler.begin(span.mode);
            }
            let until = (first + span.until).max(next);
            self.assembler.feed(consecutive(next, until), &self.pool, &mut out);
            next = until;
            if span.ends {
                self.assembler.end(&self.pool, &mut out);
            }
        }
        self.pool.keep(self.assembler.held());
        self.spans.clear();
        if let Some(mode) = open {
            self.spans.push(Span { mode, begins: false, ends: false, until: 0 });
        }
    }

    /// Starts a primitive whose vertices come as whole batches. Waiting vertices must have been run.
    pub fn array_begin(&mut self, mode: GLenum) {
        self.assembler.begin(mode);
        self.pool.keep(&mut []);
        self.batch.clear();
    }

    /// Runs the batch and appends its vertices to the pool; the id of its first vertex.
    pub fn array_batch(&mut self) -> u32 {
        let first = self.pool.len() as u32;
        transform(&self.plan, &mut self.batch);
        self.pool.append(&self.batch);
        self.batch.clear();
        first
    }

    /// Assembles the vertices of the batch that begins with an id.
    pub fn array_feed_batch<S: Assembled>(&mut self, first: u32, sink: &mut S) {
        let ids = consecutive(first, self.pool.len() as u32);
        self.array_feed(ids, sink);
    }

    /// Assembles vertices of the pool by their ids.
    pub fn array_feed<S: Assembled>(&mut self, ids: &[u32], sink: &mut S) {
        let mut out = Output::new(&self.plan, &mut self.clipper, sink);
        self.assembler.feed(ids, &self.pool, &mut out);
    }

    /// How many vertices the pool holds.
    #[must_use]
    pub fn held(&self) -> usize {
        self.pool.len()
    }

    /// Empties the pool up to what the primitive still needs.
    pub fn array_flush(&mut self) {
        self.pool.keep(self.assembler.held());
    }

    /// Ends the primitive.
    pub fn array_end<S: Assembled>(&mut self, sink: &mut S) {
        let mut out = Output::new(&self.plan, &mut self.clipper, sink);
        self.assembler.end(&self.pool, &mut out);
        self.pool.keep(&mut []);
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
fn consecutive(from: u32, until: u32) -> &'static [u32] {
    static CONSECUTIVE: [u32; 4 + LANES] = IDS;
    CONSECUTIVE.get(from as usize..until as usize).unwrap_or(&[])
}

/// Runs the plan over a batch.
fn transform(plan: &VertexPlan, batch: &mut VertexBatch) {
    if batch.n == 0 {
        return;
    }
    batch.n = batch.n.min(LANES);
    batch.span = batch.n.next_multiple_of(16).min(LANES);
    for step in &plan.plan.steps {
        #[expect(unsafe_code, reason = "stages of a plan are compiled for a level that the processor has")]
        unsafe {
            (step.run)(batch, &plan.uniforms, step.arg);
        }
    }
}
