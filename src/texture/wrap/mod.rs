//! Wrapping (OpenGL 1.5, sections 3.8.7 and 3.8.8): from a texture coordinate to the texels around it.

pub mod bounded;
pub mod general;
