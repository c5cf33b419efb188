//! The span path: kernels that do whole rows of a primitive without a batch in between.

pub mod depth;
pub mod levels;
pub mod long;
pub mod mip_fraction;
pub mod nearest;
pub mod sampled;
pub mod short;
pub mod two_units;
