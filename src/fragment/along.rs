//! Texture coordinates along a row, for stages that do whole runs: what is the same for all of a run is worked out once.
//! Every number comes from the same expressions as in [`coordinates`](super::coordinates) and [`wide`](super::wide), so the
//! bits are the same.

use super::coordinates::Unit;
use super::interpolate::reciprocal64;
use super::planes::{Linear, Plane};
use super::segments::IOTA;
use super::wide::without_periods;
use crate::num::{clamp_f32, max_f32};
use crate::texture::near::Range;

/// A plane along a row, in `f32` or `f64`.
#[derive(Clone, Copy)]
pub(super) struct Along<T> {
    at: T,
    x: T,
    c: T,
    min: T,
    max: T,
}

impl Along<f32> {
    /// A plane in the row y, relative to the primitive's origin.
    #[inline(always)]
    pub(super) fn new(p: &Plane, y: f32) -> Self {
        Self { at: p.n0 as f32 + p.ny as f32 * y, x: p.nx as f32, c: p.c, min: p.min, max: p.max }
    }

    /// A plane that is the same everywhere.
    #[inline(always)]
    pub(super) fn constant(v: f32) -> Self {
        Self { at: 0.0, x: 0.0, c: v, min: v, max: v }
    }

    /// The value at x where w is the same everywhere.
    #[inline(always)]
    pub(super) fn even(&self, x: f32) -> f32 {
        clamp_f32(self.c + (self.at + self.x * x), self.min, self.max)
    }

    /// The value at x, 1 / D being `rq`.
    #[inline(always)]
    pub(super) fn divided(&self, x: f32, rq: f32) -> f32 {
        clamp_f32(self.c + (self.at + self.x * x) * rq, self.min, self.max)
    }
}

impl Along<f64> {
    #[inline(always)]
    fn wide(p: &Plane, y: f32) -> Self {
        let [c, min, max] = [p.c, p.min, p.max].map(f64::from);
        Self { at: p.n0 + p.ny * f64::from(y), x: p.nx, c, min, max }
    }

    /// The values from x on, without whole periods where they repeat.
    #[inline(always)]
    fn values<const N: usize>(&self, x: f32, rq: &[f64; N], repeats: bool) -> [f32; N] {
        let Self { at, x: step, c, min, max } = *self;
        let value = |i: usize| {
            let v = c + (at + step * f64::from(x + IOTA[i])) * rq[i];
            let v = if v > min { v } else { min };
            if v < max { v } else { max }
        };
        let mut out = [0.0; N];
        if repeats {
            for i in 0..N {
                out[i] = without_periods(value(i), 1.0, 1.0) as f32;
            }
        } else {
            for i in 0..N {
                out[i] = value(i) as f32;
            }
        }
        out
    }
}

/// D along a row: its value at 0 and its change.
pub(super) type Divisor<T> = [T; 2];

/// How the K coordinates of a unit come about.
#[derive(Clone, Copy)]
pub(super) enum Form<const K: usize> {
    /// w is the same everywhere.
    Even([Along<f32>; K]),
    /// They are divided by D.
    Divided([Along<f32>; K], Divisor<f32>),
    /// The same in `f64`.
    Wide([Along<f64>; K], Divisor<f64>),
}

impl<const K: usize> Form<K> {
    /// Coordinates in the row y, relative to the primitive's origin.
    #[inline(always)]
    pub(super) fn new(unit: &Unit<'_, K>, y: f32) -> Self {
        let Linear { at, x, y: up } = unit.divisor;
        if unit.wide {
            Self::Wide(unit.coords.each_ref().map(|p| Along::wide(p, y)), [at + up * f64::from(y), x])
        } else if unit.planes.affine {
            Self::Even(unit.coords.each_ref().map(|p| Along::new(p, y)))
        } else {
            Self::Divided(unit.coords.each_ref().map(|p| Along::new(p, y)), divisor(&unit.divisor, y))
        }
    }

    /// The coordinates from x on; `rq` is 1 / D where they are divided by it in `f32`.
    #[inline(always)]
    pub(super) fn values<const N: usize>(&self, x: f32, rq: &[f32; N], repeats: &[bool; K]) -> [[f32; N]; K] {
        let mut out = [[0.0; N]; K];
        match self {
            Self::Even(planes) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].even(x + IOTA[i]);
                    }
                }
            }
            Self::Divided(planes, _) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].divided(x + IOTA[i], rq[i]);
                    }
                }
            }
            Self::Wide(planes, [at, step]) => {
                let mut rq = [0.0; N];
                for i in 0..N {
                    rq[i] = reciprocal64(at + step * f64::from(x + IOTA[i]));
                }
                for k in 0..K {
                    out[k] = planes[k].values(x, &rq, repeats[k]);
                }
            }
        }
        out
    }
}

/// D along the row y in `f32`.
#[inline(always)]
pub(super) fn divisor(d: &Linear, y: f32) -> Divisor<f32> {
    [d.at as f32 + d.y as f32 * y, d.x as f32]
}

/// Between which numbers a coordinate is; `None` if it may not be finite.
#[inline(always)]
pub(super) fn range<const K: usize>(unit: &Unit<'_, K>, repeats: &[bool; K], k: usize) -> Option<Range> {
    let p = &unit.coords[k];
    let greatest = max_f32(p.max.abs(), p.min.abs());
    if !(p.min.is_finite() && p.max.is_finite()) {
        return None;
    }
    if unit.wide && repeats[k] {
        // As `wide_lanes` has it: half a period is left, and what rounding adds, of numbers that have a fraction.
        return Some(Range { least: f32::NEG_INFINITY, limit: if greatest < 1e9 { 2.0 } else { greatest } });
    }
    Some(Range { least: p.min, limit: greatest })
}
