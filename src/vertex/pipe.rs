//! The vertex pipe as the context holds it: vertices go in one by one (Begin/End) or in whole batches (arrays),
//! primitives come out. Vertices wait until 64 are there; a new Begin/End pair with the same state joins the ones that
//! wait, so that many small primitives fill batches as one large one does. The cut into batches changes no bit.

use super::batch::needs;
use super::chunk::Chunk;
use super::plan::{VertexPlan, Wants};
use super::{Assembled, Source};
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
    /// Vertices that wait, and those that the primitive still needs.
    pub chunk: Chunk,
    cut: usize,
    spans: Vec<Span>,
    inside: bool,
}

/// How many pieces of primitives may wait, so that empty Begin/End pairs do not pile up.
const MOST_SPANS: usize = 64;

impl Pipe {
    /// A pipe with no vertices. `cut` limits how many vertices make a batch, for tests that compare cuts.
    #[must_use]
    pub fn new(level: Level, cut: usize) -> Self {
        Self {
            plan: VertexPlan::new(level),
            chunk: Chunk::default(),
            cut: cut.clamp(1, LANES),
            spans: Vec::new(),
            inside: false,
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
            self.chunk.pool.lay_out(&self.plan.layout, layout);
            self.plan.build(state, layout, wants);
        } else {
            self.plan.build(state, layout, wants);
            self.chunk.pool.reset(&self.plan);
        }
        if self.plan.needs & needs::EDGE == 0 {
            self.chunk.batch.edge = [true; LANES];
        }
    }

    /// Begins a primitive.
    #[inline]
    pub fn begin(&mut self, mode: GLenum) {
        self.inside = true;
        self.spans.push(Span { mode, begins: true, ends: false, until: self.chunk.batch.n as u32 });
    }

    /// Appends a vertex; true says that the batch is full and wants to [run](Self::run).
    #[inline]
    pub fn vertex(&mut self, position: [f32; 4], current: &Current) -> bool {
        self.chunk.batch.push(position, current, self.plan.needs);
        self.chunk.batch.n >= self.cut
    }

    /// Ends the primitive; true says that enough waits to [run](Self::run).
    #[inline]
    pub fn end(&mut self) -> bool {
        self.inside = false;
        let until = self.chunk.batch.n as u32;
        if let Some(span) = self.spans.last_mut() {
            span.until = until;
            span.ends = true;
        }
        self.spans.len() >= MOST_SPANS || self.chunk.batch.n >= self.cut
    }

    /// Runs the waiting vertices and hands on the primitives.
    pub fn run<S: Assembled>(&mut self, sink: &mut S) {
        let Self { plan, chunk, spans, .. } = self;
        let Some(last) = spans.last_mut() else { return };
        if self.inside {
            last.until = chunk.batch.n as u32;
        }
        let open = self.inside.then_some(last.mode);
        let mut next = chunk.held();
        let first = chunk.place(plan);
        let culls = sink.culls();
        for span in spans.iter() {
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
        chunk.batch.clear();
        spans.clear();
        if let Some(mode) = open {
            spans.push(Span { mode, begins: false, ends: false, until: 0 });
        }
    }

    /// Starts a primitive whose vertices come from a source. Waiting vertices must have been run.
    pub fn array_begin(&mut self, mode: GLenum) {
        self.chunk.begin(mode);
        self.chunk.clear();
        self.chunk.batch.clear();
    }

    /// Draws the vertices of a source that have these places, at most a batch.
    pub fn array_batch<S: Assembled>(&mut self, source: &impl Source, keys: &[u32], sink: &mut S) {
        let Self { plan, chunk, .. } = self;
        source.places(keys, &mut chunk.batch);
        source.values(keys, &mut chunk.batch);
        let first = chunk.place(plan);
        chunk.feed(plan, sink.culls(), consecutive(first, chunk.held()));
        chunk.value_batch(plan, first);
        chunk.hand_on(plan, 0, usize::MAX, sink);
        chunk.clear();
    }

    /// Ends the primitive.
    pub fn array_end<S: Assembled>(&mut self, sink: &mut S) {
        self.chunk.end(&self.plan, sink.culls());
        self.chunk.hand_on(&self.plan, 0, usize::MAX, sink);
        self.chunk.begin(0);
        self.chunk.clear();
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
