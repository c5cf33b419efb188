//! The span path: kernels that do whole rows of a primitive without a batch in between. `kernels` has the table that picks
//! one for a key; `long` and `short` drive them; a shader (`color`, `nearest`, `sampled`) gives blocks of pixels their
//! colours. Every number comes from the functions that the reference path uses, so the bits are the same.

mod color;
mod environment;
pub mod kernels;
mod long;
pub mod mip_fraction;
mod nearest;
mod pixel_rect;
pub mod projection;
mod sampled;
mod shader;
mod short;
