//! The vertex pipe (OpenGL 1.5, sections 2.6 to 2.14): from vertices as a program gives them to triangles, lines and
//! points in clip and window coordinates.
//!
//! 64 vertices stand in a [`VertexBatch`](batch); a [`VertexPlan`] of the stages that the
//! state needs takes them through transformation, lighting and texture coordinate generation; the results stand in a
//! [`TransformedVertices`], where the [`Assembler`](assemble::Assembler) joins them into primitives and
//! [`Clipper`] cuts those that leave the view volume. What comes out goes to an [`PrimitiveSink`]. A
//! [`VertexProcessor`](processor::VertexProcessor) leads them through all that.

pub mod assemble;
pub mod batch;
pub mod cache;
pub mod clip;
pub mod counts;
pub mod cull;
pub mod draw_worker;
pub mod hand_on;
pub mod pipeline;
pub mod plan;
pub mod processor;
pub mod setup_job;
pub mod source;
pub mod stages;
pub mod transformed;
pub mod triangle_list;
pub mod uniforms;
pub mod vertex_store;
pub mod weld;

#[cfg(test)]
mod tests;
