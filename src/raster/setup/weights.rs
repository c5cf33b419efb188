//! The arithmetic of planes: weights of the corners, and the planes of four slots at a time (OpenGL 1.5, sections 3.4.1 and
//! 3.5.1). The loop over slots is a stage, compiled for each instruction set; its sums are in written order, so all of them
//! give the same bits.

use super::basis::Basis;
use crate::fragment::planes::{Linear, Plane};
use crate::simd::stage;

/// Basis and w together: the denominator D, and the corners' parts of a numerator.
pub(crate) struct Weights {
    pub d: Linear,
    pub affine: bool,
    pub r: [f64; 3],
    /// The least of r.
    pub far: f64,
    /// The greatest distance of a corner from the origin, in x and in y.
    pub reach: [f64; 2],
    b1: Linear,
    b2: Linear,
    /// 1 / D at the origin, or 0 where D is not in the range that it has within the primitive.
    scale: f64,
}

/// The least and the greatest of three.
#[inline(always)]
pub(crate) fn range<T: PartialOrd + Copy>([a, b, c]: [T; 3]) -> (T, T) {
    let (low, high) = if b < a { (b, a) } else { (a, b) };
    (if c < low { c } else { low }, if c > high { c } else { high })
}

impl Weights {
    #[inline]
    pub(crate) fn new(basis: &Basis, w: [f64; 3]) -> Self {
        let [b1, b2] = basis.b;
        let [p0, p1, p2] = basis.corner;
        let reach =
            [range([p0[0].abs(), p1[0].abs(), p2[0].abs()]).1, range([p0[1].abs(), p1[1].abs(), p2[1].abs()]).1];
        let least = range(w).0;
        let affine = (w[0] == w[1] && w[1] == w[2]) || !(least > 0.0 && w[0] + w[1] + w[2] < f64::INFINITY);
        if affine {
            let d = Linear { at: 1.0, x: 0.0, y: 0.0 };
            return Self { d, affine, r: [1.0; 3], far: 1.0, reach, b1, b2, scale: 1.0 };
        }
        let r = [least / w[0], least / w[1], least / w[2]];
        let d = basis.linear(r);
        let far = range(r).0;
        let scale = if d.at >= 0.5 * far && d.at <= 2.0 { 1.0 / d.at } else { 0.0 };
        let times = |k: f64, b: Linear| Linear { at: k * b.at, x: k * b.x, y: k * b.y };
        Self { d, affine, r, far, reach, b1: times(r[1], b1), b2: times(r[2], b2), scale }
    }

    /// An upper bound, within the primitive, of the sum of the absolute terms of a linear function.
    #[inline]
    pub fn bound(&self, at: f64, x: f64, y: f64) -> f64 {
        at.abs() + x.abs() * self.reach[0] + y.abs() * self.reach[1]
    }

    /// The planes of four slots: loops over arrays, without branches on the values.
    #[inline(always)]
    fn four(&self, f0: &[f32; 4], f1: &[f32; 4], f2: &[f32; 4], out: &mut FourPlanes) {
        let Self { d, b1, b2, scale, .. } = self;
        let (mut at, mut x, mut y) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for i in 0..4 {
            let base = f64::from(f0[i]);
            let (g1, g2) = (f64::from(f1[i]) - base, f64::from(f2[i]) - base);
            at[i] = g1 * b1.at + g2 * b2.at;
            x[i] = g1 * b1.x + g2 * b2.x;
            y[i] = g1 * b1.y + g2 * b2.y;
        }
        for i in 0..4 {
            (out.min[i], out.max[i]) = range([f0[i], f1[i], f2[i]]);
        }
        for i in 0..4 {
            let here = (f64::from(f0[i]) + at[i] * scale) as f32;
            let here = if here < out.min[i] { out.min[i] } else { here };
            out.c[i] = if here > out.max[i] { out.max[i] } else { here };
        }
        for i in 0..4 {
            let delta = f64::from(out.c[i]) - f64::from(f0[i]);
            out.n0[i] = at[i] - delta * d.at;
            out.nx[i] = x[i] - delta * d.x;
            out.ny[i] = y[i] - delta * d.y;
        }
        for i in 0..4 {
            out.check[i] = (out.n0[i] + out.nx[i] + out.ny[i]) * 0.0;
        }
    }
}

/// Planes of four slots as structure of arrays, so that vector instructions compute them.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(32))]
pub(crate) struct FourPlanes {
    n0: [f64; 4],
    nx: [f64; 4],
    ny: [f64; 4],
    /// 0 for finite planes, NaN for all others.
    pub(crate) check: [f64; 4],
    c: [f32; 4],
    min: [f32; 4],
    max: [f32; 4],
}

impl FourPlanes {
    pub(crate) fn plane(&self, i: usize) -> Plane {
        let Self { n0, nx, ny, c, min, max, .. } = self;
        Plane { c: c[i], min: min[i], max: max[i], n0: n0[i], nx: nx[i], ny: ny[i] }
    }
}

/// Makes planes of four slots of three corners.
pub(crate) type FourPlanesFn = unsafe fn(&Weights, [&[f32; 4]; 3], &mut FourPlanes);

stage! {
    /// Planes of four slots.
    pub(crate) fn FOUR: FourPlanesFn = (weights: &Weights, slots: [&[f32; 4]; 3], out: &mut FourPlanes) {
        weights.four(slots[0], slots[1], slots[2], out);
    }
}
