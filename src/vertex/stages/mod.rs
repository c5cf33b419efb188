//! The vertex stages (OpenGL 1.5, sections 2.11 to 2.14): loops over the lanes of a [batch](super::batch), from which
//! a [plan](super::plan) chooses those that the state needs.

pub mod lighting;
pub mod material;
pub mod normal;
pub mod tex_coord;
pub mod transform;
pub mod triangle_corners;

use super::batch::VertexBatch;
use super::uniforms::VertexUniforms;

/// A vertex stage.
pub type VertFn = unsafe fn(&mut VertexBatch, &VertexUniforms, u32);
