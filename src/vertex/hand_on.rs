//! From the processor's list of visible primitives to a sink.

use super::assemble::VisiblePrimitive;
use super::clip::Clipper;
use super::plan::VertexPlan;
use super::transformed::TransformedVertices;
use crate::fragment::planes::GROUP;
use crate::raster::{FragmentProgram, PrimitiveBuilder, PrimitiveSink, Scene};

/// A sink that takes lists of primitives.
pub trait TakePrimitives: PrimitiveSink {
    /// Takes primitives one after the other.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        vertices: &TransformedVertices,
        clipper: &mut Clipper,
    ) where
        Self: Sized,
    {
        for primitive in primitives {
            primitive.hand_on(plan, vertices, clipper, self);
        }
    }
}

impl<P: FragmentProgram> TakePrimitives for Scene<P> {
    /// The builder is the same for all of them.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        vertices: &TransformedVertices,
        clipper: &mut Clipper,
    ) {
        if !primitives.is_empty()
            && let Some(mut builder) = self.builder()
        {
            builder.take(primitives, plan, vertices, clipper);
        }
    }
}

impl<P: FragmentProgram> TakePrimitives for PrimitiveBuilder<'_, P> {
    /// Triangles that need no clipping are queued up to 16 at a time.
    fn take(
        &mut self,
        primitives: &[VisiblePrimitive],
        plan: &VertexPlan,
        vertices: &TransformedVertices,
        clipper: &mut Clipper,
    ) {
        let many = self.can_batch(vertices.vertices.stride);
        let mut rest = primitives;
        while let Some((first, others)) = rest.split_first() {
            if !(many && first.is_plain()) {
                first.hand_on(plan, vertices, clipper, self);
                rest = others;
                continue;
            }
            let (mut ids, mut n) = ([[0; 3]; GROUP], 0);
            for (ids, primitive) in ids.iter_mut().zip(rest).take_while(|(_, primitive)| primitive.is_plain()) {
                *ids = primitive.ids();
                n += 1;
            }
            self.triangles(&vertices.vertices, &ids[..n]);
            rest = &rest[n..];
        }
    }
}
