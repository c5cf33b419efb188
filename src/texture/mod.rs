//! Texturing (OpenGL 1.5, section 3.8): the images of textures and what turns texture coordinates into colours.

pub mod anisotropy;
pub mod batch;
pub mod completeness;
pub mod count;
pub mod cube;
pub mod env;
pub mod filter;
pub mod format;
pub mod image;
pub mod lod;
pub mod mipmap;
pub mod object;
pub mod padding;
pub mod readback;
pub mod rho_ranges;
pub mod s3tc;
pub mod sampler;
#[cfg(test)]
mod tests;
pub mod uniforms;
pub mod upload;
pub mod wrap;
