//! Texturing (OpenGL 1.5, section 3.8): the images of textures and what turns texture coordinates into colours.

pub mod address;
pub mod anisotropy;
pub mod batch;
pub mod combine;
pub mod complete;
pub mod count;
pub mod cube;
pub mod env;
pub mod filter;
pub mod filter_float;
pub mod format;
pub mod image;
#[cfg(test)]
mod image_tests;
pub mod linear;
pub mod lod;
pub mod mipmap;
pub mod near;
pub mod object;
pub mod pads;
pub mod readback;
pub mod s3tc;
mod s3tc_encode;
pub mod sampler;
#[cfg(test)]
mod sampler_tests;
pub mod shadow;
mod sums;
#[cfg(test)]
mod test_support;
pub mod uniforms;
pub mod upload;
pub mod whole;
