//! The weights of the second of two mipmap levels along a span (OpenGL 1.5, section 3.8.8): where bounds of rho say which
//! two levels a part blends (`lod_bounds`), what is left of lambda is the fraction, and where they say along which axis rho
//! is greater, the derivatives of that one are enough.

use super::projection::{Projection, wide_values};
use crate::fragment::mip_range::{Axis, MipWeight};
use crate::fragment::plane_eval::{Positions, Real, derivative, reciprocals};
use crate::fragment::planes::Unit;
use crate::num::{log2_f32, max_f32};
use crate::texture::rho_ranges::RhoRanges;

/// The derivatives along an axis of the window of the numerators of K coordinates, and of D.
#[derive(Clone, Copy)]
struct Slope<const K: usize> {
    n: [f64; K],
    d: f64,
}

/// Where the fraction of lambda comes from.
enum Lambda<const K: usize> {
    /// It is the same everywhere.
    Same(f32),
    /// The derivatives along this axis.
    One(Slope<K>),
    /// The greater one of those along both.
    Two([Slope<K>; 2]),
}

/// What all blocks of a part of a primitive need to find the weight of the second of two levels.
pub struct MipFraction<const K: usize> {
    lambda: Lambda<K>,
    scale: [f32; K],
    bias: f32,
    level: f32,
}

/// Adds what coordinate k moves, in texels, to the square of rho.
#[inline(always)]
fn add(k: usize, texels: f32, rho2: &mut f32) {
    *rho2 = if k == 0 { texels * texels } else { *rho2 + texels * texels };
}

/// The square of rho of a unit whose derivatives are the same everywhere, as fragments compute it.
pub fn even_rho2<const K: usize>(unit: &Unit<'_, K>, levels: &RhoRanges) -> f32 {
    let (mut x, mut y) = (0.0, 0.0);
    for k in 0..K {
        let (plane, scale) = (&unit.coords[k], levels.scale[k] as f32);
        add(k, plane.nx as f32 * scale, &mut x);
        add(k, plane.ny as f32 * scale, &mut y);
    }
    max_f32(x, y)
}

impl<const K: usize> MipFraction<K> {
    /// For a part of a primitive that reads `level` and the next one, whose weight comes from `weight`.
    #[inline(always)]
    pub fn new(unit: &Unit<'_, K>, levels: &RhoRanges, level: u32, weight: MipWeight) -> Option<Self> {
        let (mut x, mut y) = (Slope { n: [0.0; K], d: unit.divisor.x }, Slope { n: [0.0; K], d: unit.divisor.y });
        let mut scale = [0.0; K];
        for k in 0..K {
            (x.n[k], y.n[k]) = (unit.coords[k].nx, unit.coords[k].ny);
            scale[k] = levels.scale[k] as f32;
        }
        let lambda = match weight {
            MipWeight::Same(weight) => Lambda::Same(weight),
            MipWeight::By(_) if unit.planes.affine && !unit.wide => return None,
            MipWeight::By(Axis::X) => Lambda::One(x),
            MipWeight::By(Axis::Y) => Lambda::One(y),
            MipWeight::By(Axis::Either) => Lambda::Two([x, y]),
        };
        Some(Self { lambda, scale, bias: levels.bias, level: level as f32 })
    }

    /// Adds what a derivative of coordinate k contributes to the square of rho.
    #[inline(always)]
    fn add(&self, k: usize, derivative: f32, rho2: &mut f32) {
        add(k, derivative * self.scale[k], rho2);
    }

    /// The weight of the second level. No limit touches lambda here, and its whole part is the first level.
    #[inline(always)]
    fn fraction(&self, rho2: f32) -> f32 {
        (0.5 * log2_f32(rho2) + self.bias) - self.level
    }

    /// The squares of rho along an axis, with the offsets t = N / D of the coordinates and 1 / D.
    #[inline(always)]
    fn rho2<T: Real, const N: usize>(&self, slope: &Slope<K>, t: &[[T; N]; K], rq: &[T; N]) -> [f32; N] {
        let mut rho2 = [0.0; N];
        for k in 0..K {
            let (n, d) = (T::coefficient(slope.n[k]), T::coefficient(slope.d));
            for i in 0..N {
                self.add(k, derivative(n, d, t[k][i], rq[i]), &mut rho2[i]);
            }
        }
        rho2
    }

    /// The squares of rho: those along one axis, or the greater ones.
    #[inline(always)]
    fn greatest_rho2<T: Real, const N: usize>(&self, t: &[[T; N]; K], rq: &[T; N], rho2: &mut [f32; N]) {
        match &self.lambda {
            Lambda::One(slope) => *rho2 = self.rho2(slope, t, rq),
            Lambda::Two([a, b]) => {
                let (a, b) = (self.rho2(a, t, rq), self.rho2(b, t, rq));
                for i in 0..N {
                    rho2[i] = max_f32(a[i], b[i]);
                }
            }
            Lambda::Same(_) => {}
        }
    }

    /// Logarithms that a pixel takes.
    pub fn logarithms(&self) -> u64 {
        u64::from(!matches!(self.lambda, Lambda::Same(_)))
    }

    /// The coordinates, and the weights of the second level; `rw` is 1 / D where it is needed in `f32`.
    #[inline(always)]
    pub fn values<const N: usize, P: Positions<N>>(
        &self,
        projection: &Projection<K>,
        at: P,
        rw: &[f32; N],
        repeats: &[bool; K],
    ) -> ([[f32; N]; K], [f32; N]) {
        let (mut out, mut rho2) = ([[0.0; N]; K], [0.0; N]);
        match projection {
            _ if let Lambda::Same(fraction) = &self.lambda => {
                return (projection.values(at, rw, repeats), [*fraction; N]);
            }
            Projection::Wide(planes, d, inside) => {
                let rq: [f64; N] = reciprocals(d, at);
                let mut t = [[0.0; N]; K];
                for k in 0..K {
                    t[k] = planes[k].offsets(at, &rq);
                    out[k] = wide_values(&planes[k], &t[k], repeats[k], *inside);
                }
                self.greatest_rho2(&t, &rq, &mut rho2);
            }
            Projection::Even(planes) | Projection::Divided(planes) => {
                let mut t = [[0.0; N]; K];
                for k in 0..K {
                    t[k] = planes[k].offsets(at, rw);
                    out[k] = planes[k].values(&t[k]);
                }
                self.greatest_rho2(&t, rw, &mut rho2);
            }
        }
        for i in 0..N {
            rho2[i] = self.fraction(rho2[i]);
        }
        (out, rho2)
    }
}
