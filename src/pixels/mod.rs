//! Pixel rectangles (OpenGL 1.5, sections 3.6 and 4.3): the way between the bytes of a client and rows of colours, depths
//! or indices. `format` says which pairs of format and type there are, `layout` where the groups of an image lie in
//! memory, `element` how one number is coded, `transfer` what is done to groups on the way; `unpack` and `pack` are the
//! two directions. Nothing here knows of textures or framebuffers: callers hand over and take rows.

pub mod element;
pub mod format;
pub mod imaging;
pub mod layout;
pub mod pack;
pub mod transfer;
pub mod unpack;
pub mod zoom;

pub use format::{PixelFormat, PixelKind, Purpose};
pub use pack::ClientTarget;
pub use transfer::Transfer;
pub use unpack::ClientImage;
pub use zoom::Placement;

#[cfg(test)]
mod tests;
