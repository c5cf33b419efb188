//! Positions relative to the origin pixel of a primitive, and which positions can be rasterised.

use crate::fragment::planes::Linear;

/// Vertices that are farther than this from the window's origin, in 1/256 pixel, are not rasterised: the guard band and some
/// room.
pub(crate) const LIMIT: i32 = 1 << 23;

/// Whether all positions are within the limit.
#[inline]
pub(crate) fn within_limit(points: &[[i32; 2]]) -> bool {
    points.iter().flatten().fold(0u32, |all, v| all | (v.wrapping_add(LIMIT) as u32)) < (2 * LIMIT) as u32
}

/// A position in 1/256 pixel as pixels from the centre of the origin pixel; exact.
pub(crate) fn relative_snapped(p: [i32; 2], origin: [i32; 2]) -> [f64; 2] {
    [0, 1].map(|k: usize| f64::from(p[k] - (origin[k] << 8) - 128) * (1.0 / 256.0))
}

/// An unsnapped position as pixels from the centre of the origin pixel.
pub(crate) fn relative(p: [f64; 3], origin: [i32; 2]) -> [f64; 2] {
    [p[0] - (f64::from(origin[0]) + 0.5), p[1] - (f64::from(origin[1]) + 0.5)]
}

/// A depth function without infinities.
pub(super) fn finite(z: Linear) -> Linear {
    if (z.at + z.x + z.y).is_finite() { z } else { Linear::default() }
}
