//! How a position becomes weights of a primitive's corners (OpenGL 1.5, sections 3.4.1 and 3.5.1), and the values at the
//! corners that the weights are applied to.

use crate::fragment::planes::{Linear, Plane};

/// The weights of the corners as linear functions of a position relative to the origin: b1 and b2 are the weights of corners
/// 1 and 2, and corner 0 has the rest. A line repeats its second corner with b2 = 0; a point has no slopes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Basis {
    /// Weights of corners 1 and 2.
    pub b: [Linear; 2],
    /// The corners, in pixels from the centre of the origin pixel.
    pub corner: [[f64; 2]; 3],
}

impl Basis {
    /// The basis of a triangle; `det` is twice its area and not 0.
    #[inline]
    #[must_use]
    pub fn triangle(corner: [[f64; 2]; 3], det: f64) -> Self {
        let [[x0, y0], [x1, y1], [x2, y2]] = corner;
        let inv = 1.0 / det;
        let (ax, ay) = ((y2 - y0) * inv, (x0 - x2) * inv);
        let (bx, by) = ((y0 - y1) * inv, (x1 - x0) * inv);
        let line = |x: f64, y: f64| Linear { at: -(x0 * x + y0 * y), x, y };
        Self { b: [line(ax, ay), line(bx, by)], corner }
    }

    /// The basis of a line from a to b: the weight of b grows along the line and is constant across it.
    #[must_use]
    pub fn line(a: [f64; 2], b: [f64; 2]) -> Self {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let square = dx * dx + dy * dy;
        let (x, y) = if square > 0.0 { (dx / square, dy / square) } else { (0.0, 0.0) };
        Self { b: [Linear { at: -(a[0] * x + a[1] * y), x, y }, Linear::default()], corner: [a, b, b] }
    }

    /// The linear function that has these values at the corners.
    #[inline]
    #[must_use]
    pub fn linear(&self, f: [f64; 3]) -> Linear {
        let (g1, g2) = (f[1] - f[0], f[2] - f[0]);
        let [b1, b2] = &self.b;
        Linear { at: f[0] + (g1 * b1.at + g2 * b2.at), x: g1 * b1.x + g2 * b2.x, y: g1 * b1.y + g2 * b2.y }
    }
}

/// The values at the corners of a primitive.
#[derive(Clone, Copy, Debug)]
pub struct CornerValues<'a> {
    /// Slots of each corner.
    pub corner: [&'a [f32]; 3],
    /// Slots of the provoking vertex.
    pub provoking: &'a [f32],
    /// Whether the back-face colours are taken.
    pub back: bool,
    /// w of each corner.
    pub w: [f64; 3],
}

/// The plane of a value that is the same everywhere.
pub(crate) const fn constant(c: f32) -> Plane {
    Plane { c, min: c, max: c, n0: 0.0, nx: 0.0, ny: 0.0 }
}
