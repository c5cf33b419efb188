//! Texture coordinates along a row, for stages that do whole runs: what is the same for all of a run is worked out once.
//! Every number comes from the same expressions as in [`coordinates`](crate::fragment::reference::texcoord) and [`wide`](crate::fragment::reference::texcoord_f64), so the
//! bits are the same.

use crate::fragment::planes::{Linear, Plane};
use crate::fragment::reference::interpolate::reciprocal64;
use crate::fragment::reference::lanes::IOTA;
use crate::fragment::reference::texcoord::Unit;
use crate::fragment::reference::texcoord_f64::{rest, without_periods};
use crate::num::{clamp_f32, max_f32};
use crate::texture::wrap::bounded::CoordBounds;

/// What rounding leaves of sums, products and quotients of this many parts in `f64`, generously (1 / D has 2^-45).
const LOST: f64 = 1.0 / (1u64 << 40) as f64;

/// A linear function of the place, `(at + y dy) + x dx`; along a row y is among the rest.
#[derive(Clone, Copy)]
pub(crate) struct Terms<T> {
    at: T,
    x: T,
    y: T,
}

impl Terms<f32> {
    /// In a row, if there is one, and rounded.
    #[inline(always)]
    pub(crate) fn new(f: &Linear, row: Option<f32>) -> Self {
        let (at, x, y) = (f.at as f32, f.x as f32, f.y as f32);
        match row {
            Some(row) => Self { at: at + y * row, x, y: 0.0 },
            None => Self { at, x, y },
        }
    }
}

impl Terms<f64> {
    #[inline(always)]
    fn wide(f: &Linear, row: Option<f32>) -> Self {
        match row {
            Some(row) => Self { at: f.at + f.y * f64::from(row), x: f.x, y: 0.0 },
            None => Self { at: f.at, x: f.x, y: f.y },
        }
    }
}

/// Where N pixels are, relative to the primitive's origin.
pub(crate) trait Place<const N: usize>: Copy {
    /// A function at lane i.
    fn sum(self, f: &Terms<f32>, i: usize) -> f32;
    /// The same in `f64`.
    fn sum64(self, f: &Terms<f64>, i: usize) -> f64;
}

/// Pixels of a row from this x on.
#[derive(Clone, Copy)]
pub(crate) struct From(pub f32);

impl<const N: usize> Place<N> for From {
    #[inline(always)]
    fn sum(self, f: &Terms<f32>, i: usize) -> f32 {
        f.at + f.x * (self.0 + IOTA[i])
    }

    #[inline(always)]
    fn sum64(self, f: &Terms<f64>, i: usize) -> f64 {
        f.at + f.x * f64::from(self.0 + IOTA[i])
    }
}

/// Pixels of a row from this x on and with this y, where functions are not those of the row.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    pub x: f32,
    pub y: f32,
}

impl<const N: usize> Place<N> for Step {
    #[inline(always)]
    fn sum(self, f: &Terms<f32>, i: usize) -> f32 {
        (f.at + f.y * self.y) + f.x * (self.x + IOTA[i])
    }

    #[inline(always)]
    fn sum64(self, f: &Terms<f64>, i: usize) -> f64 {
        (f.at + f.y * f64::from(self.y)) + f.x * f64::from(self.x + IOTA[i])
    }
}

/// Pixels anywhere.
pub(crate) struct Points<const N: usize> {
    pub x: [f32; N],
    pub y: [f32; N],
}

impl<const N: usize> Place<N> for &Points<N> {
    #[inline(always)]
    fn sum(self, f: &Terms<f32>, i: usize) -> f32 {
        (f.at + f.y * self.y[i]) + f.x * self.x[i]
    }

    #[inline(always)]
    fn sum64(self, f: &Terms<f64>, i: usize) -> f64 {
        (f.at + f.y * f64::from(self.y[i])) + f.x * f64::from(self.x[i])
    }
}

/// A plane along a row or anywhere, in `f32` or `f64`.
#[derive(Clone, Copy)]
pub(crate) struct Along<T> {
    n: Terms<T>,
    c: T,
    min: T,
    max: T,
}

/// The numerator of a plane.
#[inline(always)]
fn numerator(p: &Plane) -> Linear {
    Linear { at: p.n0, x: p.nx, y: p.ny }
}

impl Along<f32> {
    /// A plane in a row, relative to the primitive's origin, if there is one.
    #[inline(always)]
    pub(crate) fn new(p: &Plane, row: Option<f32>) -> Self {
        Self { n: Terms::new(&numerator(p), row), c: p.c, min: p.min, max: p.max }
    }

    /// A plane that is the same everywhere.
    #[inline(always)]
    pub(crate) fn constant(v: f32) -> Self {
        Self { n: Terms { at: 0.0, x: 0.0, y: 0.0 }, c: v, min: v, max: v }
    }

    /// The value at lane i where w is the same everywhere.
    #[inline(always)]
    pub(crate) fn even<const N: usize>(&self, place: impl Place<N>, i: usize) -> f32 {
        clamp_f32(self.c + place.sum(&self.n, i), self.min, self.max)
    }

    /// The value at lane i, 1 / D being `rq`.
    #[inline(always)]
    pub(crate) fn divided<const N: usize>(&self, place: impl Place<N>, i: usize, rq: f32) -> f32 {
        clamp_f32(self.c + place.sum(&self.n, i) * rq, self.min, self.max)
    }
}

impl Along<f32> {
    /// N / D, with 1 / D.
    #[inline(always)]
    pub(crate) fn offsets<const N: usize>(&self, place: impl Place<N>, rq: &[f32; N]) -> [f32; N] {
        let mut t = [0.0; N];
        for i in 0..N {
            t[i] = place.sum(&self.n, i) * rq[i];
        }
        t
    }

    /// The values with these offsets.
    #[inline(always)]
    pub(crate) fn limited<const N: usize>(&self, t: &[f32; N]) -> [f32; N] {
        let mut out = [0.0; N];
        for i in 0..N {
            out[i] = clamp_f32(self.c + t[i], self.min, self.max);
        }
        out
    }
}

impl Along<f64> {
    /// N / D, with 1 / D.
    #[inline(always)]
    pub(crate) fn offsets<const N: usize>(&self, place: impl Place<N>, rq: &[f64; N]) -> [f64; N] {
        let mut t = [0.0; N];
        for i in 0..N {
            t[i] = place.sum64(&self.n, i) * rq[i];
        }
        t
    }

    #[inline(always)]
    fn wide(p: &Plane, row: Option<f32>) -> Self {
        let [c, min, max] = [p.c, p.min, p.max].map(f64::from);
        Self { n: Terms::wide(&numerator(p), row), c, min, max }
    }

    /// Whether its limits change nothing from `x[0]` to `x[1]`, rounding included. With D > 0 the value rises or falls all the
    /// way, so the two ends are its least and its greatest. `terms`: what D is the sum of in the row, without signs.
    #[inline(always)]
    fn inside(&self, p: &Plane, Run { x, y }: Run, (Terms { at, x: step, .. }, terms): (Divisor<f64>, f64)) -> bool {
        let far = f64::from(x[0]).abs() + f64::from(x[1]).abs();
        let terms = terms + step.abs() * far;
        let n_terms = p.n0.abs() + (p.ny * f64::from(y)).abs() + p.nx.abs() * far;
        let keeps_away = |x: i32| {
            let x = f64::from(x);
            let (d, n) = (at + step * x, self.n.at + self.n.x * x);
            let (rq, t) = (1.0 / (d - LOST * terms), n / d);
            let lost = LOST * (self.c.abs() + (n_terms + t.abs() * terms) * rq);
            let v = self.c + t;
            rq > 0.0 && v - lost >= self.min && v + lost <= self.max
        };
        keeps_away(x[0]) && keeps_away(x[1])
    }

    /// The values with these offsets, without whole periods where they repeat; `inside`: the limits change nothing.
    #[inline(always)]
    pub(crate) fn limited<const N: usize>(&self, t: &[f64; N], repeats: bool, inside: bool) -> [f32; N] {
        let Self { c, min, max, .. } = *self;
        let value = |i: usize| {
            let v = c + t[i];
            let v = if v > min { v } else { min };
            if v < max { v } else { max }
        };
        let mut out = [0.0; N];
        if repeats && inside {
            for i in 0..N {
                out[i] = without_periods(c + t[i], 1.0, 1.0) as f32;
            }
        } else if repeats {
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

/// 1 / D.
#[inline(always)]
pub(crate) fn reciprocals<const N: usize>(d: &Divisor<f64>, place: impl Place<N>) -> [f64; N] {
    let mut rq = [0.0; N];
    for i in 0..N {
        rq[i] = reciprocal64(place.sum64(d, i));
    }
    rq
}

/// D.
pub(crate) type Divisor<T> = Terms<T>;

/// Pixels of a row relative to the primitive's origin: the first and the last x, and y.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub x: [i32; 2],
    pub y: i32,
}

/// What planes are worked out for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent {
    /// A part of a row.
    Row(Run),
    /// Any rows of the primitive.
    All,
}

impl Extent {
    /// The row, if it is one.
    #[inline(always)]
    pub(crate) fn row(&self) -> Option<f32> {
        match self {
            Self::Row(run) => Some(run.y as f32),
            Self::All => None,
        }
    }
}

/// How the K coordinates of a unit come about.
#[derive(Clone, Copy)]
pub(crate) enum Projection<const K: usize> {
    /// w is the same everywhere.
    Even([Along<f32>; K]),
    /// They are divided by D.
    Divided([Along<f32>; K]),
    /// The same in `f64`; whether no coordinate of the run is to be limited.
    Wide([Along<f64>; K], Divisor<f64>, bool),
}

impl<const K: usize> Projection<K> {
    /// Coordinates of pixels, relative to the primitive's origin.
    #[inline(always)]
    pub(crate) fn new(unit: &Unit<'_, K>, extent: Extent) -> Self {
        let row = extent.row();
        if unit.wide {
            let planes = unit.coords.each_ref().map(|p| Along::wide(p, row));
            let d = Terms::wide(&unit.divisor, row);
            // Of several rows nobody has asked.
            let mut inside = false;
            if let Extent::Row(run) = extent {
                let terms = unit.divisor.at.abs() + (unit.divisor.y * f64::from(run.y)).abs();
                inside = true;
                for k in 0..K {
                    inside &= planes[k].inside(&unit.coords[k], run, (d, terms));
                }
            }
            Self::Wide(planes, d, inside)
        } else if unit.planes.affine {
            Self::Even(unit.coords.each_ref().map(|p| Along::new(p, row)))
        } else {
            Self::Divided(unit.coords.each_ref().map(|p| Along::new(p, row)))
        }
    }

    /// Whether they are divided by D in `f32`.
    #[inline(always)]
    pub(crate) fn divides(&self) -> bool {
        matches!(self, Self::Divided(_))
    }

    /// The coordinates; `rq` is 1 / D where they are divided by it in `f32`.
    #[inline(always)]
    pub(crate) fn values<const N: usize>(
        &self,
        place: impl Place<N>,
        rq: &[f32; N],
        repeats: &[bool; K],
    ) -> [[f32; N]; K] {
        let mut out = [[0.0; N]; K];
        match self {
            Self::Even(planes) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].even(place, i);
                    }
                }
            }
            Self::Divided(planes) => {
                for k in 0..K {
                    for i in 0..N {
                        out[k][i] = planes[k].divided(place, i, rq[i]);
                    }
                }
            }
            Self::Wide(planes, d, inside) => {
                let rq: [f64; N] = reciprocals(d, place);
                for k in 0..K {
                    let t = planes[k].offsets(place, &rq);
                    out[k] = planes[k].limited(&t, repeats[k], *inside);
                }
            }
        }
        out
    }
}

/// Between which numbers a coordinate is; `None` if it may not be finite.
#[inline(always)]
pub(crate) fn range<const K: usize>(unit: &Unit<'_, K>, repeats: &[bool; K], k: usize) -> Option<CoordBounds> {
    let p = &unit.coords[k];
    let greatest = max_f32(p.max.abs(), p.min.abs());
    if !(p.min.is_finite() && p.max.is_finite()) {
        return None;
    }
    if unit.wide && repeats[k] {
        // As `wide_lanes` has it.
        return Some(rest(greatest, 1.0));
    }
    Some(CoordBounds { least: p.min, limit: greatest })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragment::planes::Planes;

    /// Where limits are said to change nothing they change nothing, and so it is said of most runs that keep away from them.
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
            let run = Run { x: [from, from + len], y };
            let at = |p: &Plane, x: i32| {
                let Along { n: Terms { at, x: step, .. }, c, .. } = Along::wide(p, Some(y as f32));
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
