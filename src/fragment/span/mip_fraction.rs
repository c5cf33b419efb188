//! How much of each of two levels pixels along a row read (OpenGL 1.5, section 3.8.8), for stages that do whole runs: where
//! limits of rho say which two levels a part of a run blends ([`detail`](crate::fragment::lod_bounds)), what is left of lambda is its
//! fraction, and where they say along which axis rho is greater, the derivatives of that one are enough. Every number comes
//! from the same expressions as in the stages of batches, so the bits are the same.

use crate::fragment::lod_bounds::{Axis, MipWeight};
use crate::fragment::plane_eval::{Place, Projection};
use crate::fragment::reference::texcoord::Unit;
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

/// What all blocks of a run need to find the weight of the second of two levels.
pub(crate) struct Mixing<const K: usize> {
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
pub(crate) fn even_rho2<const K: usize>(unit: &Unit<'_, K>, levels: &RhoRanges) -> f32 {
    let (mut x, mut y) = (0.0, 0.0);
    for k in 0..K {
        let (plane, scale) = (&unit.coords[k], levels.scale[k] as f32);
        add(k, plane.nx as f32 * scale, &mut x);
        add(k, plane.ny as f32 * scale, &mut y);
    }
    max_f32(x, y)
}

impl<const K: usize> Mixing<K> {
    /// For a part of a run that reads `level` and such a share of the next one.
    #[inline(always)]
    pub(crate) fn new(unit: &Unit<'_, K>, levels: &RhoRanges, level: u32, share: MipWeight) -> Option<Self> {
        let (mut x, mut y) = (Slope { n: [0.0; K], d: unit.divisor.x }, Slope { n: [0.0; K], d: unit.divisor.y });
        let mut scale = [0.0; K];
        for k in 0..K {
            (x.n[k], y.n[k]) = (unit.coords[k].nx, unit.coords[k].ny);
            scale[k] = levels.scale[k] as f32;
        }
        let lambda = match share {
            MipWeight::Same(share) => Lambda::Same(share),
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
    fn wide<const N: usize>(&self, slope: &Slope<K>, t: &[[f64; N]; K], rq: &[f64; N]) -> [f32; N] {
        let mut rho2 = [0.0; N];
        for k in 0..K {
            let (n, d) = (slope.n[k], slope.d);
            for i in 0..N {
                self.add(k, ((n - t[k][i] * d) * rq[i]) as f32, &mut rho2[i]);
            }
        }
        rho2
    }

    /// The same in `f32`.
    #[inline(always)]
    fn narrow<const N: usize>(&self, slope: &Slope<K>, t: &[[f32; N]; K], rq: &[f32; N]) -> [f32; N] {
        let mut rho2 = [0.0; N];
        for k in 0..K {
            let (n, d) = (slope.n[k] as f32, slope.d as f32);
            for i in 0..N {
                self.add(k, (n - t[k][i] * d) * rq[i], &mut rho2[i]);
            }
        }
        rho2
    }

    /// The coordinates, and the weights of the second level; `rw` is 1 / D where it is needed in `f32`.
    #[inline(always)]
    pub(crate) fn values<const N: usize>(
        &self,
        form: &Projection<K>,
        place: impl Place<N>,
        rw: &[f32; N],
        repeats: &[bool; K],
    ) -> ([[f32; N]; K], [f32; N]) {
        let (mut out, mut rho2) = ([[0.0; N]; K], [0.0; N]);
        match (&self.lambda, form) {
            (Lambda::Same(fraction), _) => return (form.values(place, rw, repeats), [*fraction; N]),
            (lambda, Projection::Wide(planes, d, inside)) => {
                let rq = crate::fragment::plane_eval::reciprocals(d, place);
                let mut t = [[0.0; N]; K];
                for k in 0..K {
                    t[k] = planes[k].offsets(place, &rq);
                    out[k] = planes[k].limited(&t[k], repeats[k], *inside);
                }
                match lambda {
                    Lambda::One(slope) => rho2 = self.wide(slope, &t, &rq),
                    Lambda::Two([a, b]) => {
                        let (a, b) = (self.wide(a, &t, &rq), self.wide(b, &t, &rq));
                        for i in 0..N {
                            rho2[i] = max_f32(a[i], b[i]);
                        }
                    }
                    Lambda::Same(_) => {}
                }
            }
            (lambda, Projection::Even(planes) | Projection::Divided(planes)) => {
                let mut t = [[0.0; N]; K];
                for k in 0..K {
                    t[k] = planes[k].offsets(place, rw);
                    out[k] = planes[k].limited(&t[k]);
                }
                match lambda {
                    Lambda::One(slope) => rho2 = self.narrow(slope, &t, rw),
                    Lambda::Two([a, b]) => {
                        let (a, b) = (self.narrow(a, &t, rw), self.narrow(b, &t, rw));
                        for i in 0..N {
                            rho2[i] = max_f32(a[i], b[i]);
                        }
                    }
                    Lambda::Same(_) => {}
                }
            }
        }
        for i in 0..N {
            rho2[i] = self.fraction(rho2[i]);
        }
        (out, rho2)
    }
}
