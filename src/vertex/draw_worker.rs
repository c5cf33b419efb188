//! A draw from a source of vertices (OpenGL 1.5, section 2.8): consecutive ones, or those that a list of indices names. A
//! [`Lane`] is what one thread needs for it. A large draw is cut into [`Parts`], which lanes work on side by side: a part
//! of a strip begins with the two vertices that its first triangle shares with the part before, all others have no vertex
//! in common that matters.

use super::cache::{IndexList, VertexCache};
use super::chunk::Chunk;
use super::plan::VertexPlan;
use super::{Assembled, Keys, List, Order, Source};
use crate::enums::*;
use crate::raster::{Builder, Pieces, Shader};
use crate::simd::LANES;
use std::ops::Range;

/// Primitives that are handed on before the sink is asked whether it is full.
const FEED: usize = 256;
/// Parts have a multiple of so many vertices: whole triangles, quadrilaterals and batches.
const UNIT: usize = 192;
/// Vertices of a part at most: a part and its primitives stay in a second-level cache.
const MOST: usize = 16 * UNIT;
/// The same of an indexed draw, whose parts have vertices in common that each of them computes: of a mesh those of a row
/// or two.
const MOST_INDICES: usize = 64 * UNIT;
/// Vertices of a part at least, where there are not very many threads.
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
    pub mode: GLenum,
    /// Vertices of a batch.
    pub cut: usize,
}

/// What a thread needs to draw from a source.
#[derive(Clone, Debug, Default)]
pub struct Lane {
    /// Vertices and primitives under way.
    pub chunk: Chunk,
    cache: VertexCache,
}

impl Lane {
    /// Takes over from another lane what is the same for all vertices of a draw.
    pub fn prepare(&mut self, plan: &VertexPlan, like: &Self) {
        self.chunk.pool.reset(plan);
        self.chunk.batch.clone_from(&like.chunk.batch);
    }

    /// Draws. Every now and then `room` may make room in the sink.
    pub fn draw<T: Assembled, S: Source>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        order: Order<IndexList<'_>>,
        sink: &mut T,
        mut room: impl FnMut(&mut T),
    ) {
        let culls = sink.culls();
        self.chunk.begin(draw.mode);
        self.chunk.clear();
        match order {
            Order::Range(range) => self.range(draw, range, culls, sink, &mut room),
            Order::List(list) => self.list(draw, list, culls, sink, &mut room),
        }
        self.chunk.end(draw.plan, culls);
        self.chunk.hand_on(draw.plan, 0, usize::MAX, sink);
        self.chunk.begin(0);
        self.chunk.clear();
        self.chunk.batch.clear();
    }

    fn range<T: Assembled, S: Source>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        range: Range<u32>,
        culls: [bool; 2],
        sink: &mut T,
        room: &mut impl FnMut(&mut T),
    ) {
        let Self { chunk, .. } = self;
        let block = draw.source.block(draw.mode).clamp(1, LANES) as u32;
        let cut = draw.cut.clamp(1, LANES) as u32;
        let mut at = range.start;
        while at < range.end {
            // Batches end where a source may have its own batches end.
            let n = cut.min(block - (at - range.start) % block).min(range.end - at);
            let keys = Keys::Range(at..at + n);
            draw.source.places(&keys, &mut chunk.batch);
            draw.source.values(&keys, &mut chunk.batch);
            if !chunk.place_in_step(draw.plan, draw.mode == GL_TRIANGLES, culls, sink) {
                let first = chunk.append();
                chunk.feed_batch(draw.plan, culls, first);
                chunk.value_batch(draw.plan, first);
                chunk.hand_on(draw.plan, 0, usize::MAX, sink);
                chunk.clear();
            }
            room(sink);
            at += n;
        }
    }

    fn list<T: Assembled, S: Source>(
        &mut self,
        draw: &SourceDraw<'_, S>,
        mut list: IndexList<'_>,
        culls: [bool; 2],
        sink: &mut T,
        room: &mut impl FnMut(&mut T),
    ) {
        let Self { chunk, cache } = self;
        while !list.is_empty() {
            let taken = cache.next_chunk(list, chunk.held());
            chunk.elements(draw.plan, draw.source, cache.elements(), draw.cut, culls);
            list = list.part(taken, usize::MAX);
            // A little at a time, so that the sink stays as small as it wants to be.
            let mut done = 0;
            while chunk.hand_on(draw.plan, done, FEED, sink) > done {
                done += FEED;
                room(sink);
            }
            chunk.clear();
        }
    }
}

/// A draw in parts, for several lanes.
#[derive(Debug)]
pub struct Parts<'a, S> {
    draw: SourceDraw<'a, S>,
    order: Order<IndexList<'a>>,
    /// Vertices of a part.
    each: usize,
    /// How many vertices of the next part each part has too.
    shared: usize,
}

impl<'a, S: Source> Parts<'a, S> {
    /// Cuts a draw for a number of threads, if that is possible.
    pub fn new(
        draw: SourceDraw<'a, S>,
        order: Order<IndexList<'a>>,
        threads: usize,
    ) -> Result<Self, (SourceDraw<'a, S>, Order<IndexList<'a>>)> {
        let shared = match draw.mode {
            GL_TRIANGLES | GL_QUADS => 0,
            GL_TRIANGLE_STRIP | GL_QUAD_STRIP => 2,
            _ => return Err((draw, order)),
        };
        if threads < 2 || order.len() < WORTH_CUTTING {
            return Err((draw, order));
        }
        // Many threads take smaller parts, so that what is set up at a time stays within some ten megabytes.
        let most = if matches!(order, Order::List(_)) { MOST_INDICES } else { MOST };
        let most = (6 * most / threads).clamp(UNIT, most);
        let each = (order.len() / (4 * threads)).max(LEAST).min(most).next_multiple_of(UNIT);
        Ok(Self { draw, order, each, shared })
    }
}

impl<S: Source, P: Shader> Pieces<P> for Parts<'_, S> {
    type Own = Lane;

    fn count(&self) -> usize {
        self.order.len().saturating_sub(self.shared).div_ceil(self.each)
    }

    fn set_up(&self, piece: usize, lane: &mut Lane, to: &mut Builder<'_, P>) {
        let from = piece * self.each;
        let order = self.order.part(from, from + self.each + self.shared);
        lane.draw(&self.draw, order, to, |_| {});
    }
}
