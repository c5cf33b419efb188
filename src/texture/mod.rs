//! Texturing (OpenGL 1.5, section 3.8): the images of textures and what turns texture coordinates into colours.

pub mod batch;
pub mod format;
pub mod image;
pub mod mipmap;
pub mod object;
pub mod pads;
pub mod readback;
pub mod s3tc;
mod s3tc_encode;
pub mod upload;

#[cfg(test)]
mod image_tests;
