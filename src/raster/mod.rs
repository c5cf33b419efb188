//! Rasterisation (OpenGL 1.5, sections 3.3 to 3.5): from processed vertices to runs of fragments.

pub mod vertex;
