//! Texturing (OpenGL 1.5, section 3.8): the images of textures and what turns texture coordinates into colours.

pub mod batch;
pub mod format;
pub mod image;
pub mod object;
pub mod pads;
