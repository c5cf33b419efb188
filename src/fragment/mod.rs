//! What happens to a fragment (OpenGL 1.5, sections 3.8 to 3.10 and chapter 4): interpolation, texturing, colour sum, fog,
//! tests, blending and the store into the framebuffer, as a plan of stages over batches of 64 fragments.

mod along;
mod alpha;
pub mod batch;
pub mod blend;
mod buffers;
mod build;
pub mod compare;
mod coordinates;
mod depth;
mod depth_rows;
mod detail;
mod fill;
mod fill_levels;
mod fill_linear;
mod fill_rows;
mod fill_texels;
mod fill_two_units;
mod float_store;
mod fog;
mod interpolate;
mod logic_op;
mod mixing;
mod pack;
pub mod planes;
pub mod program;
mod segments;
pub mod stencil;
mod tally;
mod texel;
pub mod uniforms;
mod wide;
pub mod words;

#[cfg(test)]
mod tests;
