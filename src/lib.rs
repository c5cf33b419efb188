//! Fixed-function OpenGL 1.0-1.5 in software.

pub mod enums;
pub mod error;
pub mod limits;
pub mod pixels;
pub mod state;
pub mod texture;
