//! Depth of primitives (OpenGL 1.5, sections 3.4.1, 3.5.1 and 3.5.5): the plane, the polygon offset, and the limits of the
//! fragments' depths.

use super::position::finite;
use super::weights::range;
use crate::fragment::planes::Linear;
use crate::raster::state::RasterState;

/// How far a snapped position can be from the unsnapped one, in pixels in x and in y. A covered centre is no farther from the
/// unsnapped triangle.
pub(crate) const SNAP: f64 = 1.0 / 512.0;

/// The most, in parts of the range of its corners, by which a triangle's depths may leave it. A covered centre may lie beyond
/// the unsnapped corners, and there the triangle has to agree with others in its plane. In triangles narrower than about
/// 1/50 pixel the plane would lead too far.
pub(crate) const BEYOND: f64 = 0.125;

/// The depth of a primitive in units of the depth buffer.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Depth {
    /// As a function of the position.
    pub plane: Linear,
    /// Limits of a fragment's depth.
    pub range: [f64; 2],
}

impl Depth {
    /// For a plane and the depths at the corners, which fragments may leave by `beyond`.
    pub(crate) fn new(rs: &RasterState, plane: Linear, corner: [f64; 3], beyond: f64, offset: f64) -> Self {
        let scale = rs.depth_scale;
        let (low, high) = range(corner);
        let mut plane = finite(plane);
        plane.at += offset;
        Self { plane, range: [limited(low - beyond + offset, scale), limited(high + beyond + offset, scale)] }
    }
}

/// A depth within the range of the depth buffer; 0 for NaN.
#[inline(always)]
pub(crate) fn limited(z: f64, scale: f64) -> f64 {
    let z = if z > 0.0 { z } else { 0.0 };
    if z < scale { z } else { scale }
}

/// By how much fragments of a triangle may leave the range of its corners' depths, for a plane with these slopes.
#[inline(always)]
pub(crate) fn beyond(x: f64, y: f64, low: f64, high: f64) -> f64 {
    let (snap, most) = ((x.abs() + y.abs()) * SNAP, (high - low) * BEYOND);
    if snap < most { snap } else { most }
}

/// The polygon offset for the greatest slope of depth along x or y. Depths are limited to the range afterwards.
#[inline(always)]
pub(crate) fn polygon_offset(x: f64, y: f64, [factor, units]: [f64; 2], scale: f64) -> f64 {
    let slope = x.abs().max(y.abs());
    let steep = if factor == 0.0 { 0.0 } else { slope * factor };
    (steep + units).max(-2.0 * scale).min(2.0 * scale)
}
