//! What happens to a fragment (OpenGL 1.5, sections 3.8 to 3.10 and chapter 4): interpolation, texturing, colour sum, fog,
//! tests, blending and the store into the framebuffer, as a plan of stages over batches of 64 fragments.

pub mod batch;
mod buffers;
pub mod compare;
mod depth;
mod interpolate;
mod pack;
pub mod planes;
pub mod program;
mod segments;
pub mod uniforms;
