//! Fixed-function OpenGL 1.0-1.5 in software.

pub mod batch;
pub mod c;
#[cfg(feature = "capi")]
pub mod capi;
pub mod context;
pub mod enums;
pub mod error;
pub mod fragment;
pub mod framebuffer;
pub mod glu;
#[cfg(feature = "image")]
pub mod image_io;
pub mod limits;
pub mod num;
#[cfg(feature = "tobj")]
pub mod obj;
pub mod pixels;
pub mod raster;
pub mod state;
pub mod texture;

pub use context::{Context, Error};
pub mod vertex;
