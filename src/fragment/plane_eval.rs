//! The one evaluator of planes (OpenGL 1.5, section 3.5.1). Every value that is interpolated over a primitive is
//!
//! ```text
//!   clamp(c + N / D, min, max)      N = (n0 + ny dy) + nx dx,  D alike
//! ```
//!
//! in `f32`, or in `f64` for primitives whose coordinates or w range too far. Both paths evaluate it by the functions of
//! this file, generic over the number type and over where the lanes are, so that they give the same bits. Along a row the
//! terms of y may be summed beforehand, since they come first in the sum.

use super::planes::{GROUP, Linear, Plane, PlaneGroup};
use crate::num::{clamp_f32, clamp01, round_f64};
use crate::simd::LANES;
use crate::texture::wrap::bounded::CoordBounds;
use std::ops::{Add, Mul, Sub};

/// A number in which planes are evaluated.
pub trait Real: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A position or a limit, which is the same number in both types.
    fn of(v: f32) -> Self;
    /// A coefficient, rounded.
    fn coefficient(v: f64) -> Self;
    /// The result, rounded.
    fn to_f32(self) -> f32;
    /// 1 / D.
    fn reciprocal(self) -> Self;
    /// Limited to `min..=max`; NaN gives `min`.
    fn limited(self, min: Self, max: Self) -> Self;
}

impl Real for f32 {
    #[inline(always)]
    fn of(v: f32) -> Self {
        v
    }

    #[inline(always)]
    fn coefficient(v: f64) -> Self {
        v as f32
    }

    #[inline(always)]
    fn to_f32(self) -> f32 {
        self
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        1.0 / self
    }

    #[inline(always)]
    fn limited(self, min: Self, max: Self) -> Self {
        clamp_f32(self, min, max)
    }
}

impl Real for f64 {
    #[inline(always)]
    fn of(v: f32) -> Self {
        Self::from(v)
    }

    #[inline(always)]
    fn coefficient(v: f64) -> Self {
        v
    }

    #[inline(always)]
    fn to_f32(self) -> f32 {
        self as f32
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        reciprocal64(self)
    }

    #[inline(always)]
    fn limited(self, min: Self, max: Self) -> Self {
        let v = if self > min { self } else { min };
        if v < max { v } else { max }
    }
}

/// 1 / D with one Newton step in `f64`: what the planes of wide primitives are multiplied with.
#[inline(always)]
pub fn reciprocal64(d: f64) -> f64 {
    let r = f64::from(1.0 / d as f32);
    r * (2.0 - d * r)
}

/// Takes whole periods off: the result is within half a period of 0. `period` 0 leaves the value.
#[inline(always)]
pub fn without_periods(v: f64, period: f64, inverse: f64) -> f64 {
    v - period * round_f64(v * inverse)
}

/// Between which numbers coordinates are without whole periods that were not farther from 0 than `greatest`: half a period is
/// left of numbers that have a fraction, all of which is exact.
#[inline(always)]
pub fn without_periods_range(greatest: f32, period: f32) -> CoordBounds {
    let half = 0.5 * period;
    if greatest < 1e9 {
        CoordBounds { least: -half, limit: half }
    } else {
        CoordBounds { least: -greatest, limit: greatest }
    }
}

/// A linear function of the position, `(at + y dy) + x dx`; for a row the terms of y are in `at`.
#[derive(Clone, Copy)]
pub struct LinearEval<T> {
    pub at: T,
    pub x: T,
    pub y: T,
}

impl<T: Real> LinearEval<T> {
    /// A function, in a row of the primitive if there is one.
    #[inline(always)]
    pub fn new(f: &Linear, row: Option<f32>) -> Self {
        let (at, x, y) = (T::coefficient(f.at), T::coefficient(f.x), T::coefficient(f.y));
        match row {
            Some(row) => Self { at: at + y * T::of(row), x, y: T::of(0.0) },
            None => Self { at, x, y },
        }
    }
}

/// 0, 1, 2, ...
pub static IOTA: [f32; LANES] = {
    let mut iota = [0.0; LANES];
    let mut i = 0;
    while i < LANES {
        iota[i] = i as f32;
        i += 1;
    }
    iota
};

/// Where N lanes are, in pixels relative to the primitive's origin. Positions are whole numbers below 2^24, which `f32`
/// holds exactly.
pub trait Positions<const N: usize>: Copy {
    /// Whether lanes are neighbours in a row.
    const IS_ROW: bool;

    /// A function at lane i.
    fn sum<T: Real>(self, f: &LinearEval<T>, i: usize) -> T;
}

/// Neighbours in a row from this x on, for functions of that row.
#[derive(Clone, Copy)]
pub struct InRow(pub f32);

impl<const N: usize> Positions<N> for InRow {
    const IS_ROW: bool = true;

    #[inline(always)]
    fn sum<T: Real>(self, f: &LinearEval<T>, i: usize) -> T {
        f.at + f.x * T::of(self.0 + IOTA[i])
    }
}

/// Neighbours in a row from x on, for functions of no row.
#[derive(Clone, Copy)]
pub struct FromPixel {
    pub x: f32,
    pub y: f32,
}

impl<const N: usize> Positions<N> for FromPixel {
    const IS_ROW: bool = true;

    #[inline(always)]
    fn sum<T: Real>(self, f: &LinearEval<T>, i: usize) -> T {
        (f.at + f.y * T::of(self.y)) + f.x * T::of(self.x + IOTA[i])
    }
}

/// Lanes anywhere.
pub struct Points<const N: usize> {
    pub x: [f32; N],
    pub y: [f32; N],
}

impl<const N: usize> Positions<N> for &Points<N> {
    const IS_ROW: bool = false;

    #[inline(always)]
    fn sum<T: Real>(self, f: &LinearEval<T>, i: usize) -> T {
        (f.at + f.y * T::of(self.y[i])) + f.x * T::of(self.x[i])
    }
}

/// A function at all lanes.
#[inline(always)]
pub fn sums<T: Real, const N: usize>(f: &LinearEval<T>, at: impl Positions<N>) -> [T; N] {
    let mut out = [T::of(0.0); N];
    for i in 0..N {
        out[i] = at.sum(f, i);
    }
    out
}

/// 1 / D at all lanes.
#[inline(always)]
pub fn reciprocals<T: Real, const N: usize>(d: &LinearEval<T>, at: impl Positions<N>) -> [T; N] {
    let mut out = [T::of(0.0); N];
    for i in 0..N {
        out[i] = at.sum(d, i).reciprocal();
    }
    out
}

/// The derivative of N / D along an axis of the window: `n` and `d` are the changes of N and D, t is N / D, rq is 1 / D.
#[inline(always)]
pub fn derivative<T: Real>(n: T, d: T, t: T, rq: T) -> f32 {
    ((n - t * d) * rq).to_f32()
}

/// A plane.
#[derive(Clone, Copy)]
pub struct PlaneEval<T> {
    pub n: LinearEval<T>,
    pub c: T,
    pub min: T,
    pub max: T,
}

impl<T: Real> PlaneEval<T> {
    /// A plane, in a row of the primitive if there is one.
    #[inline(always)]
    pub fn new(p: &Plane, row: Option<f32>) -> Self {
        let n = LinearEval::new(&p.numerator(), row);
        Self { n, c: T::of(p.c), min: T::of(p.min), max: T::of(p.max) }
    }

    /// N / D at lane i, 1 / D being `rq`.
    #[inline(always)]
    pub fn offset<const N: usize>(&self, at: impl Positions<N>, i: usize, rq: T) -> T {
        at.sum(&self.n, i) * rq
    }

    /// The value with this offset.
    #[inline(always)]
    pub fn limited(&self, t: T) -> T {
        (self.c + t).limited(self.min, self.max)
    }

    /// The value at lane i where D is 1.
    #[inline(always)]
    pub fn even<const N: usize>(&self, at: impl Positions<N>, i: usize) -> T {
        self.limited(at.sum(&self.n, i))
    }

    /// The value at lane i, 1 / D being `rq`.
    #[inline(always)]
    pub fn divided<const N: usize>(&self, at: impl Positions<N>, i: usize, rq: T) -> T {
        self.limited(self.offset(at, i, rq))
    }

    /// N / D at all lanes, with 1 / D.
    #[inline(always)]
    pub fn offsets<const N: usize>(&self, at: impl Positions<N>, rq: &[T; N]) -> [T; N] {
        let mut t = [T::of(0.0); N];
        for i in 0..N {
            t[i] = self.offset(at, i, rq[i]);
        }
        t
    }
}

impl PlaneEval<f32> {
    /// The plane of a member of a group.
    #[inline(always)]
    pub fn of_member(p: &PlaneGroup, member: usize) -> Self {
        let at = member % GROUP;
        let n = LinearEval { at: p.n0[at], x: p.nx[at], y: p.ny[at] };
        Self { n, c: p.c[at], min: p.min[at], max: p.max[at] }
    }

    /// A plane that is the same everywhere.
    #[inline(always)]
    pub fn constant(v: f32) -> Self {
        Self { n: LinearEval { at: 0.0, x: 0.0, y: 0.0 }, c: v, min: v, max: v }
    }

    /// The plane of a colour channel: limits within [0, 1] save limiting the value once more.
    #[inline(always)]
    pub fn in_unit(p: &Plane, row: Option<f32>) -> Self {
        Self { min: clamp01(p.min), max: clamp01(p.max), ..Self::new(p, row) }
    }

    /// The values with these offsets.
    #[inline(always)]
    pub fn values<const N: usize>(&self, t: &[f32; N]) -> [f32; N] {
        let mut out = [0.0; N];
        for i in 0..N {
            out[i] = self.limited(t[i]);
        }
        out
    }

    /// Writes the values; `rw` is 1 / D, or 1 where `even` says that D is 1 everywhere.
    #[inline(always)]
    pub fn fill<const N: usize>(&self, at: impl Positions<N>, rw: &[f32; N], even: bool, out: &mut [f32; N]) {
        if even {
            for i in 0..N {
                out[i] = self.even(at, i);
            }
        } else {
            for i in 0..N {
                out[i] = self.divided(at, i, rw[i]);
            }
        }
    }

    /// The values that [`fill`](Self::fill) writes.
    #[inline(always)]
    pub fn at<const N: usize>(&self, at: impl Positions<N>, rw: &[f32; N], even: bool) -> [f32; N] {
        let mut out = [0.0; N];
        self.fill(at, rw, even, &mut out);
        out
    }
}

/// Pixels of a row relative to the primitive's origin: the first and the last x, and y.
#[derive(Clone, Copy, Debug)]
pub struct RowRange {
    pub x: [i32; 2],
    pub y: i32,
}

/// What planes are worked out for.
#[derive(Clone, Copy, Debug)]
pub enum Extent {
    /// A part of a row.
    Row(RowRange),
    /// Any rows of the primitive.
    All,
}

impl Extent {
    /// The row, if it is one.
    #[inline(always)]
    pub fn row(&self) -> Option<f32> {
        match self {
            Self::Row(range) => Some(range.y as f32),
            Self::All => None,
        }
    }
}
