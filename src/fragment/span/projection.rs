//! Texture coordinates of a part of a primitive for span kernels: what is the same for all of the part is worked out once.
//! The equations are those of the reference path (`reference::texcoord`), from the one evaluator of planes, so the bits
//! are the same.

use crate::fragment::plane_eval::{
    Extent, LinearEval, PlaneEval, Positions, RowRange, reciprocals, without_periods, without_periods_range,
};
use crate::fragment::planes::{Plane, Unit};
use crate::num::max_f32;
use crate::texture::wrap::bounded::CoordBounds;

/// A bound of the relative error of sums, products and quotients with this many terms in `f64`, with a margin (1 / D
/// has 2^-45).
const LOST: f64 = 1.0 / (1u64 << 40) as f64;

/// Whether the limits of a plane change nothing in a range of a row, rounding included. With D > 0 the value rises or falls
/// all the way, so the two ends are its least and its greatest. `terms`: what D is the sum of in the row, without signs.
#[inline(always)]
fn stays_inside(
    plane: &PlaneEval<f64>,
    p: &Plane,
    RowRange { x, y }: RowRange,
    (d, terms): (LinearEval<f64>, f64),
) -> bool {
    let far = f64::from(x[0]).abs() + f64::from(x[1]).abs();
    let terms = terms + d.x.abs() * far;
    let n_terms = p.n0.abs() + (p.ny * f64::from(y)).abs() + p.nx.abs() * far;
    let keeps_away = |x: i32| {
        let x = f64::from(x);
        let (d, n) = (d.at + d.x * x, plane.n.at + plane.n.x * x);
        let (rq, t) = (1.0 / (d - LOST * terms), n / d);
        let lost = LOST * (plane.c.abs() + (n_terms + t.abs() * terms) * rq);
        let v = plane.c + t;
        rq > 0.0 && v - lost >= plane.min && v + lost <= plane.max
    };
    keeps_away(x[0]) && keeps_away(x[1])
}

/// How the K coordinates of a unit come about.
#[derive(Clone, Copy)]
pub enum Projection<const K: usize> {
    /// w is the same everywhere.
    Even([PlaneEval<f32>; K]),
    /// They are divided by D.
    Divided([PlaneEval<f32>; K]),
    /// The same in `f64`; whether no coordinate of the part is to be limited.
    Wide([PlaneEval<f64>; K], LinearEval<f64>, bool),
}

impl<const K: usize> Projection<K> {
    /// That of a unit.
    #[inline(always)]
    pub fn new(unit: &Unit<'_, K>, extent: Extent) -> Self {
        let row = extent.row();
        if unit.wide {
            let planes = unit.coords.each_ref().map(|p| PlaneEval::<f64>::new(p, row));
            let d = LinearEval::new(&unit.divisor, row);
            // For several rows it is not checked.
            let mut inside = false;
            if let Extent::Row(range) = extent {
                let terms = unit.divisor.at.abs() + (unit.divisor.y * f64::from(range.y)).abs();
                inside = true;
                for k in 0..K {
                    inside &= stays_inside(&planes[k], &unit.coords[k], range, (d, terms));
                }
            }
            Self::Wide(planes, d, inside)
        } else if unit.planes.affine {
            Self::Even(unit.coords.each_ref().map(|p| PlaneEval::new(p, row)))
        } else {
            Self::Divided(unit.coords.each_ref().map(|p| PlaneEval::new(p, row)))
        }
    }

    /// Whether they are divided by D in `f32`.
    #[inline(always)]
    pub fn divides(&self) -> bool {
        matches!(self, Self::Divided(_))
    }

    /// Whether they need a division of their own.
    pub fn is_wide(&self) -> bool {
        matches!(self, Self::Wide(..))
    }

    /// The coordinates; `rq` is 1 / D where they are divided by it in `f32`.
    #[inline(always)]
    pub fn values<const N: usize, P: Positions<N>>(&self, at: P, rq: &[f32; N], repeats: &[bool; K]) -> [[f32; N]; K] {
        let mut out = [[0.0; N]; K];
        match self {
            Self::Even(planes) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].even(at, i);
                    }
                }
            }
            Self::Divided(planes) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].divided(at, i, rq[i]);
                    }
                }
            }
            Self::Wide(planes, d, inside) => {
                let rq: [f64; N] = reciprocals(d, at);
                for k in 0..K {
                    let t = planes[k].offsets(at, &rq);
                    out[k] = wide_values(&planes[k], &t, repeats[k], *inside);
                }
            }
        }
        out
    }
}

/// The values with these offsets, without whole periods where they repeat; `inside`: the limits change nothing.
#[inline(always)]
pub fn wide_values<const N: usize>(plane: &PlaneEval<f64>, t: &[f64; N], repeats: bool, inside: bool) -> [f32; N] {
    let mut out = [0.0; N];
    if repeats && inside {
        for i in 0..N {
            out[i] = without_periods(plane.c + t[i], 1.0, 1.0) as f32;
        }
    } else if repeats {
        for i in 0..N {
            out[i] = without_periods(plane.limited(t[i]), 1.0, 1.0) as f32;
        }
    } else {
        for i in 0..N {
            out[i] = plane.limited(t[i]) as f32;
        }
    }
    out
}

/// Between which numbers a coordinate is; `None` if it may not be finite.
#[inline(always)]
pub fn range<const K: usize>(unit: &Unit<'_, K>, repeats: &[bool; K], k: usize) -> Option<CoordBounds> {
    let p = &unit.coords[k];
    let greatest = max_f32(p.max.abs(), p.min.abs());
    if !(p.min.is_finite() && p.max.is_finite()) {
        return None;
    }
    if unit.wide && repeats[k] {
        return Some(without_periods_range(greatest, 1.0));
    }
    Some(CoordBounds { least: p.min, limit: greatest })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragment::plane_eval::reciprocal64;
    use crate::fragment::planes::{Linear, Planes};

    /// Where limits are said to change nothing they change nothing, and so it is said of most rows that keep away from them.
    #[test]
    fn limits_are_left_out_where_they_do_nothing() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let (mut inside, mut within, mut near) = (0, 0, 0);
        for _ in 0..40_000 {
            let steep = 10f64.powf(-3.0 + 2.0 * next());
            let divisor = Linear { at: 0.5 + 0.5 * next(), x: steep * next(), y: steep * next() };
            let odd = 10f64.powf(4.0 * next());
            let mut plane = Plane {
                c: 0.3,
                n0: odd * next(),
                nx: 0.01 * odd * next(),
                ny: 0.01 * odd * next(),
                ..Plane::default()
            };
            let (y, from, len) = ((300.0 * next()) as i32, (300.0 * next()) as i32, (31.9 * (next() + 1.0)) as i32);
            let run = RowRange { x: [from, from + len], y };
            let at = |p: &Plane, x: i32| {
                let PlaneEval { n: LinearEval { at, x: step, .. }, c, .. } = PlaneEval::<f64>::new(p, Some(y as f32));
                c + (at + step * f64::from(x))
                    * reciprocal64((divisor.at + divisor.y * f64::from(y)) + divisor.x * f64::from(x))
            };
            let ends = run.x.map(|x| at(&plane, x) as f32);
            // Just so, hardly so, or far away.
            let room = [0.0, 1e-6, 1e-3][(next().abs() * 3.0) as usize] * (1.0 + ends[0].abs());
            (plane.min, plane.max) = (ends[0].min(ends[1]) - room, ends[0].max(ends[1]) + room);
            let planes = Planes { d: divisor, ..Planes::default() };
            let coords = [plane];
            let unit = Unit { planes: &planes, coords: &coords, divisor, has_q: false, wide: true };
            let Projection::Wide(_, _, free) = Projection::new(&unit, Extent::Row(run)) else { panic!("wide") };
            let fits = (run.x[0]..=run.x[1]).all(|x| {
                let v = at(&plane, x);
                v >= f64::from(plane.min) && v <= f64::from(plane.max)
            });
            assert!(fits || !free, "{plane:?} over {divisor:?} in {run:?}");
            inside += u32::from(free);
            within += u32::from(fits);
            near += u32::from(fits && !free);
        }
        assert!(inside > 10_000 && near > 100, "{inside} of {within} free of limits, {near} not seen");
    }
}
