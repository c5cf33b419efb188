//! The vertex pipeline (OpenGL 1.5, sections 2.6 to 2.14): from vertices as a program gives them to triangles, lines and
//! points in clip and window coordinates.
//!
//! 64 vertices make a [`VertexBatch`](batch). A [`plan`] lists the stages that the state needs: transformation, lighting,
//! texture coordinate generation. The results are [`transformed`] vertices, which the [assembler](assemble) joins into
//! primitives; those that leave the view volume are [clipped](clip). What is left goes to a
//! [sink](crate::raster::PrimitiveSink). A [`processor`] runs all that.

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
