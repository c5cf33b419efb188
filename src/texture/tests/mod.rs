//! Tests of images and of whole samplers.

mod image;
mod sampler;
pub mod support;
