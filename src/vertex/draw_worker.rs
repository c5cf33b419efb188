//! A draw from a source of vertices (OpenGL 1.5, section 2.8): consecutive ones, or those that a list of indices names. A
//! [`DrawWorker`] is what one thread needs for it. A large draw is a [`SplitSourceDraw`], whose parts are drawn on several
//! threads: a part of a strip begins with the two vertices that its first triangle shares with the part before.

use super::cache::{IndexList, VertexCache};
use super::hand_on::TakePrimitives;
use super::plan::VertexPlan;
use super::processor::VertexProcessor;
use super::source::{ElementList, ElementOrder, Keys, VertexSource};
use crate::raster::{FragmentProgram, PrimitiveBuilder, SplitDraw};
use crate::simd::LANES;
use crate::state::primitive::PrimitiveMode;
use std::ops::Range;

/// Primitives that are handed on before the sink is asked whether it is full.
const HAND_ON: usize = 256;
/// Parts have a multiple of so many vertices: whole triangles, quadrilaterals and batches.
const UNIT: usize = 192;
/// Most vertices of a part: it and its primitives stay in a second-level cache.
const MOST: usize = 16 * UNIT;
/// Most indices of a part. Vertices that two parts have in common are computed twice: of a mesh those of a row or two.
const MOST_INDICES: usize = 64 * UNIT;
/// Least vertices of a part, unless there are very many threads.
const LEAST: usize = 8 * UNIT;
/// Vertices from which on a draw is worth cutting: starting a thread takes about as long as drawing a thousand triangles
/// that are all culled.
pub const WORTH_CUTTING: usize = 12_288;

/// A draw.
#[derive(Debug)]
pub struct SourceDraw<'a, S> {
    /// The stages.
    pub plan: &'a VertexPlan,
    /// The vertices.
    pub source: &'a S,
    /// What they make.
    pub mode: PrimitiveMode,
    /// Vertices of a batch.
    pub cut: usize,
}

/// What a thread needs to draw from a source.
#[derive(Clone, Debug, Default)]
pub struct DrawWorker {
    /// Vertices and primitives under way.
    pub processor: VertexProcessor,
    cache: VertexCache,
}

impl DrawWorker {
    /// Copies from another worker what is the same for all vertices of a draw.
    pub fn prepare(&mut self, plan: &VertexPlan, like: &Self) {
        self.processor.pool.reset(plan);
        *self.processor.batch = *like.processor.batch;
    }

    /// Draws. `room` is called every few hundred primitives, and may make room in the sink.
    pub fn draw<T: TakePrimitives, S: VertexSource>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        order: ElementOrder<IndexList<'_>>,
        sink: &mut T,
        mut room: impl FnMut(&mut T),
    ) {
        let culls = sink.culls();
        self.processor.begin(draw.mode);
        self.processor.clear();
        match order {
            ElementOrder::Range(range) => self.range(draw, range, culls, sink, &mut room),
            ElementOrder::List(list) => self.list(draw, list, culls, sink, &mut room),
        }
        self.processor.end(draw.plan, culls);
        self.processor.hand_on(draw.plan, 0, usize::MAX, sink);
        self.processor.begin(PrimitiveMode::default());
        self.processor.clear();
        self.processor.batch.clear();
    }

    fn range<T: TakePrimitives, S: VertexSource>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        range: Range<u32>,
        culls: [bool; 2],
        sink: &mut T,
        room: &mut impl FnMut(&mut T),
    ) {
        let Self { processor, .. } = self;
        let block = draw.source.block(draw.mode).clamp(1, LANES) as u32;
        let cut = draw.cut.clamp(1, LANES) as u32;
        let mut at = range.start;
        while at < range.end {
            // Batches end where the blocks of a source do.
            let n = cut.min(block - (at - range.start) % block).min(range.end - at);
            let keys = Keys::Range(at..at + n);
            draw.source.positions(&keys, &mut processor.batch);
            draw.source.attributes(&keys, &mut processor.batch);
            if !processor.run_triangle_list(draw.plan, draw.mode == PrimitiveMode::Triangles, culls, sink) {
                let first = processor.append();
                processor.feed_batch(draw.plan, culls, first);
                processor.compute_varyings(draw.plan, first);
                processor.hand_on(draw.plan, 0, usize::MAX, sink);
                processor.clear();
            }
            room(sink);
            at += n;
        }
    }

    fn list<T: TakePrimitives, S: VertexSource>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        mut list: IndexList<'_>,
        culls: [bool; 2],
        sink: &mut T,
        room: &mut impl FnMut(&mut T),
    ) {
        let Self { processor, cache } = self;
        while !list.is_empty() {
            let taken = cache.next_chunk(list, processor.held());
            processor.elements(draw.plan, draw.source, cache.elements(), draw.cut, culls);
            list = list.part(taken, usize::MAX);
            // A few hundred at a time, so that the sink can be flushed in between.
            let mut done = 0;
            while processor.hand_on(draw.plan, done, HAND_ON, sink) > done {
                done += HAND_ON;
                room(sink);
            }
            processor.clear();
        }
    }
}

/// A draw that is split into parts.
#[derive(Debug)]
pub struct SplitSourceDraw<'a, S> {
    draw: SourceDraw<'a, S>,
    order: ElementOrder<IndexList<'a>>,
    /// Vertices of a part.
    each: usize,
    /// How many vertices two parts share.
    shared: usize,
}

impl<'a, S: VertexSource> SplitSourceDraw<'a, S> {
    /// Splits a draw for a number of threads, if that is possible and worth it; otherwise gives it back.
    pub fn new(
        draw: SourceDraw<'a, S>,
        order: ElementOrder<IndexList<'a>>,
        threads: usize,
    ) -> Result<Self, (SourceDraw<'a, S>, ElementOrder<IndexList<'a>>)> {
        let shared = match draw.mode {
            PrimitiveMode::Triangles | PrimitiveMode::Quads => 0,
            PrimitiveMode::TriangleStrip | PrimitiveMode::QuadStrip => 2,
            PrimitiveMode::Points
            | PrimitiveMode::Lines
            | PrimitiveMode::LineLoop
            | PrimitiveMode::LineStrip
            | PrimitiveMode::TriangleFan
            | PrimitiveMode::Polygon => return Err((draw, order)),
        };
        if threads < 2 || order.len() < WORTH_CUTTING {
            return Err((draw, order));
        }
        // More threads take smaller parts, so that what is set up at a time stays within some ten megabytes.
        let most = if matches!(order, ElementOrder::List(_)) { MOST_INDICES } else { MOST };
        let most = (6 * most / threads).clamp(UNIT, most);
        let each = (order.len() / (4 * threads)).max(LEAST).min(most).next_multiple_of(UNIT);
        Ok(Self { draw, order, each, shared })
    }
}

impl<S: VertexSource, P: FragmentProgram> SplitDraw<P> for SplitSourceDraw<'_, S> {
    type Scratch = DrawWorker;

    fn count(&self) -> usize {
        self.order.len().saturating_sub(self.shared).div_ceil(self.each)
    }

    fn set_up(&self, part: usize, worker: &mut DrawWorker, to: &mut PrimitiveBuilder<'_, P>) {
        let from = part * self.each;
        let order = self.order.part(from, from + self.each + self.shared);
        worker.draw(&self.draw, order, to, |_| {});
    }
}
