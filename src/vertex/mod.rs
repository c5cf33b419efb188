//! The vertex pipe (OpenGL 1.5, sections 2.6 to 2.14): from vertices as a program gives them to triangles, lines and
//! points in clip and window coordinates.
//!
//! 64 vertices stand in a [`VertexBatch`](batch); a [`VertexPlan`] of the stages that the
//! state needs takes them through transformation, lighting and texture coordinate generation; the results stand in a
//! [`TransformedVertices`], where the [`Assembler`](assemble::Assembler) joins them into primitives and
//! [`Clipper`] cuts those that leave the view volume. What comes out goes to an [`Assembled`]. A
//! [`VertexProcessor`](processor::VertexProcessor) leads them through all that.

pub mod assemble;
pub mod batch;
pub mod cache;
pub mod clip;
pub mod counts;
pub mod cull;
pub mod draw_worker;
pub mod pipeline;
pub mod plan;
pub mod processor;
pub mod setup_job;
pub mod stages;
pub mod transformed;
pub mod triangle_list;
pub mod uniforms;
pub mod vertex_store;
pub mod weld;

use crate::enums::GLenum;
use crate::fragment::planes::GROUP;
pub use crate::raster::VertexRef;
use crate::raster::{CornerLanes, FragmentProgram, PrimitiveBuilder, Scene};
use assemble::VisiblePrimitive;
use batch::VertexBatch;
use clip::Clipper;
use plan::VertexPlan;
use std::ops::Range;
use transformed::TransformedVertices;

/// Where assembled and clipped primitives go: the scene when something is rendered, the feedback buffer, the selection
/// hit record.
pub trait Assembled {
    /// A triangle. `provoking` is the corner whose colour holds under flat shading, `edges[i]` says whether the edge from
    /// corner i to the next is a boundary edge of its polygon.
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]);
    /// A line segment; `restart` says that the line stipple starts anew with it.
    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize, restart: bool);
    /// A point.
    fn point(&mut self, vertex: VertexRef<'_>);
    /// Whether triangles come to nothing whose area in the window is positive (counter-clockwise), or is not: those need
    /// not be handed on.
    fn culls(&self) -> [bool; 2] {
        [false; 2]
    }
    /// Whether groups of triangles may be [taken](Self::take_group) with vertices of so many slots.
    fn takes_groups(&mut self, _stride: usize) -> bool {
        false
    }
    /// Takes so many triangles, at most a group of them, which need no clipping and whose corners `fill` puts in place.
    fn take_group(&mut self, _count: usize, _fill: impl FnOnce(&mut CornerLanes)) {}
    /// Takes primitives one after the other.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        pool: &TransformedVertices,
        clipper: &mut Clipper,
    ) where
        Self: Sized,
    {
        for primitive in primitives {
            primitive.hand_on(plan, pool, clipper, self);
        }
    }
}

impl<P: FragmentProgram> Assembled for Scene<P> {
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        Scene::triangle(self, corners, provoking, edges);
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize, restart: bool) {
        Scene::line(self, ends, provoking, restart);
    }

    fn point(&mut self, vertex: VertexRef<'_>) {
        Scene::point(self, vertex);
    }

    fn culls(&self) -> [bool; 2] {
        Scene::culls(self)
    }

    fn takes_groups(&mut self, stride: usize) -> bool {
        self.builder().is_some_and(|builder| builder.takes_many(stride))
    }

    fn take_group(&mut self, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        if let Some(mut builder) = self.builder() {
            builder.group(count, fill);
        }
    }

    /// What a scene has to know of its draw is the same for all of them.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        pool: &TransformedVertices,
        clipper: &mut Clipper,
    ) {
        if !primitives.is_empty()
            && let Some(mut builder) = self.builder()
        {
            builder.take(primitives, plan, pool, clipper);
        }
    }
}

impl<P: FragmentProgram> Assembled for PrimitiveBuilder<'_, P> {
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        PrimitiveBuilder::triangle(self, corners, provoking, edges);
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize, restart: bool) {
        PrimitiveBuilder::line(self, ends, provoking, restart);
    }

    fn point(&mut self, vertex: VertexRef<'_>) {
        PrimitiveBuilder::point(self, vertex);
    }

    fn culls(&self) -> [bool; 2] {
        self.draw().culls()
    }

    fn takes_groups(&mut self, stride: usize) -> bool {
        self.takes_many(stride)
    }

    fn take_group(&mut self, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        self.group(count, fill);
    }

    /// Triangles that need no more than their vertices go a group at a time.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        pool: &TransformedVertices,
        clipper: &mut Clipper,
    ) {
        let many = self.takes_many(pool.vertices.stride);
        let mut rest = primitives;
        while let Some((first, others)) = rest.split_first() {
            if !(many && first.is_plain()) {
                first.hand_on(plan, pool, clipper, self);
                rest = others;
                continue;
            }
            let (mut ids, mut n) = ([[0; 3]; GROUP], 0);
            for (ids, primitive) in ids.iter_mut().zip(rest).take_while(|(_, primitive)| primitive.is_plain()) {
                *ids = primitive.ids();
                n += 1;
            }
            self.triangles(&pool.vertices, &ids[..n]);
            rest = &rest[n..];
        }
    }
}

/// Some elements of a source in an order: all from one to another, or those of a list.
#[derive(Clone, Debug)]
pub enum ElementOrder<L> {
    /// One after the other.
    Range(Range<u32>),
    /// Those of a list.
    List(L),
}

/// A list of elements, by their places in the source.
pub trait ElementList: Copy {
    /// How many there are.
    fn count(self) -> usize;
    /// Some of them.
    #[must_use]
    fn part(self, from: usize, until: usize) -> Self;
}

impl ElementList for &[u32] {
    fn count(self) -> usize {
        self.len()
    }

    fn part(self, from: usize, until: usize) -> Self {
        self.get(from..until.min(self.len())).unwrap_or_default()
    }
}

impl<L: ElementList> ElementOrder<L> {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Range(range) => range.len(),
            Self::List(list) => list.count(),
        }
    }

    /// Some of them.
    #[must_use]
    pub fn part(&self, from: usize, until: usize) -> Self {
        match self {
            Self::Range(range) => {
                let at = |i: usize| range.start.saturating_add(u32::try_from(i).unwrap_or(u32::MAX)).min(range.end);
                Self::Range(at(from)..at(until))
            }
            Self::List(list) => Self::List(list.part(from, until)),
        }
    }
}

/// Some elements of a source, each of which can be asked for.
pub type Keys<'a> = ElementOrder<&'a [u32]>;

impl Keys<'_> {
    /// The element at some place.
    #[inline]
    #[must_use]
    pub fn get(&self, i: usize) -> Option<u32> {
        match self {
            Self::Range(range) => (i < range.len()).then(|| range.start.wrapping_add(i as u32)),
            Self::List(list) => list.get(i).copied(),
        }
    }
}

/// Where vertices come from: arrays, or what Begin and End have collected.
pub trait VertexSource: Sync {
    /// Fills the batch with positions and edge flags of some elements, at most 64.
    fn positions(&self, keys: &Keys<'_>, batch: &mut VertexBatch);
    /// Fills the batch with all other attributes of some elements.
    fn attributes(&self, keys: &Keys<'_>, batch: &mut VertexBatch);
    /// How many vertices of a primitive are best taken at a time.
    fn block(&self, mode: GLenum) -> usize {
        triangle_list::block(mode)
    }
}

#[cfg(test)]
mod tests;
