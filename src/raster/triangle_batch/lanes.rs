//! Types of a batch: one value for each of its triangles.

use crate::fragment::planes::GROUP;

/// One integer for each triangle.
pub(crate) type I32x16 = [i32; GROUP];

/// One number for each triangle.
pub(crate) type F64x16 = [f64; GROUP];
pub(super) const ZERO: F64x16 = [0.0; GROUP];

/// A linear function for each triangle.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LinearLanes {
    pub at: F64x16,
    pub x: F64x16,
    pub y: F64x16,
}

pub(super) const LINEAR_LANES: LinearLanes = LinearLanes { at: ZERO, x: ZERO, y: ZERO };

/// What interpolation needs of each triangle; see [`Weights`](crate::raster::setup::weights::Weights).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BasisLanes {
    pub d: LinearLanes,
    pub(super) b: [LinearLanes; 2],
    pub(super) far: F64x16,
    pub(super) scale: F64x16,
    pub(super) reach: [F64x16; 2],
    /// The greatest sum of terms of D; 0 where D is 1.
    pub(super) denominator: F64x16,
}

/// What becomes of a triangle: it covers nothing, or it is a member of the batch with a mask, or one with rows since it is
/// too large for a mask, or it must be set up alone since it is larger still.
pub(crate) const NOTHING: i32 = 0;
pub(crate) const MASK: i32 = 1;
pub(crate) const BLOCK: i32 = 2;
pub(crate) const ALONE: i32 = 3;
