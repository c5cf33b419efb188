//! Tests of images and of whole samplers.

mod against_oracle;
mod image;
#[path = "../../../tests/oracle/mod.rs"]
mod oracle;
mod sampler;
pub mod support;
