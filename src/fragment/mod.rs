//! What happens to a fragment (OpenGL 1.5, sections 3.8 to 3.10 and chapter 4): interpolation, texturing, colour sum, fog,
//! tests, blending and the store into the framebuffer. Two paths give the same bits: `reference`, stages over batches of 64
//! fragments, which does everything, and `span`, kernels for rows of a primitive in states that are drawn often. `build`
//! makes both from a `key`.

pub mod batch;
mod build;
pub mod compare;
mod counted;
pub mod explain;
mod hiz;
pub mod key;
mod lod_bounds;
mod mip_range;
pub mod pixel_rect;
mod plane_eval;
pub mod planes;
pub mod program;
mod reference;
mod span;
pub mod uniforms;

#[cfg(test)]
mod tests;
