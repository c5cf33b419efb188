//! Texture coordinates in `f64` (OpenGL 1.5, section 3.8.8): those of primitives whose coordinates or w range too far for
//! `f32`. The equations are those of [`coordinates`](crate::fragment::reference::texcoord), whole periods come off before the result becomes
//! `f32`, and 1 / D is one `f32` division with a Newton step.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::planes::{Linear, Planes, UnitSlots};
use crate::fragment::reference::interpolate::{reciprocal64, reciprocals};
use crate::fragment::reference::lanes::{CHUNK, Chunk, Piece, Positions, linear64, put};
use crate::fragment::reference::texcoord::{First, Unit, all_finite, divisors, finite, is_even};
use crate::num::{max_f32, round_f64};
use crate::simd::LANES;
use crate::texture::batch::{Derivatives, Lanes, TexBatch};
use crate::texture::wrap::bounded::CoordBounds;

/// Takes whole periods off: the result is within half a period of 0. `period` 0 leaves the value.
#[inline(always)]
pub(crate) fn without_periods(v: f64, period: f64, inverse: f64) -> f64 {
    v - period * round_f64(v * inverse)
}

/// Between which numbers coordinates are without whole periods that were not farther from 0 than `greatest`: half a period is
/// left of numbers that have a fraction, all of which is exact.
#[inline(always)]
pub(crate) fn rest(greatest: f32, period: f32) -> CoordBounds {
    let half = 0.5 * period;
    if greatest < 1e9 {
        CoordBounds { least: -half, limit: half }
    } else {
        CoordBounds { least: -greatest, limit: greatest }
    }
}

/// Lanes of one primitive that fill the batch, in `f64`: [`wide_piece`] for all lanes at once.
#[inline(always)]
pub(crate) fn wide_lanes<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    slots: &UnitSlots,
    first: First,
    derivatives: bool,
) {
    // As in the pieces of a segment, positions are whole numbers that went through `f32`.
    let (px, py) = (|i: usize| f64::from(places.x(i)), |i: usize| f64::from(places.y(i)));
    let d = &unit.divisor;
    let even = is_even(unit);
    let mut rq = [1.0; LANES];
    if even {
        b.tex.derivatives = Derivatives::Uniform;
    } else if b.has_rw64 && !unit.has_q {
        rq = b.rw64;
    } else {
        for i in 0..LANES {
            rq[i] = reciprocal64((d.at + d.y * py(i)) + d.x * px(i));
        }
        if first.shared {
            (b.rw64, b.has_rw64) = (rq, true);
        }
    }
    if first.leaves && !unit.has_q {
        // What colours are multiplied with is f64 only where the whole primitive is wide.
        if unit.planes.wide & Planes::WIDE_W != 0 {
            for i in 0..LANES {
                b.rw[i] = rq[i] as f32;
            }
        } else {
            divisors(&mut b.rw, unit, places, first);
        }
    }
    for k in 0..K {
        let p = &unit.coords[k];
        let (c, min, max) = (f64::from(p.c), f64::from(p.min), f64::from(p.max));
        let TexBatch { coord, ddx, ddy, limit, least, .. } = &mut b.tex;
        let (out, ddx, ddy) = (&mut coord[k], &mut ddx[k], &mut ddy[k]);
        let of = Wide { n0: p.n0, nx: p.nx, ny: p.ny, c, min, max, d_x: d.x, d_y: d.y, even };
        let period = f64::from(slots.period[k]);
        let greatest = max_f32(p.max.abs(), p.min.abs());
        (limit[k], least[k]) = match slots.period[k] {
            0 => (greatest, p.min),
            _ => {
                let CoordBounds { least, limit } = rest(greatest, f32::from(slots.period[k]));
                (limit, least)
            }
        };
        match slots.period[k] {
            0 => of.lanes([out, ddx, ddy], &rq, places, derivatives, |v| v),
            1 => of.lanes([out, ddx, ddy], &rq, places, derivatives, |v| without_periods(v, 1.0, 1.0)),
            _ => of.lanes([out, ddx, ddy], &rq, places, derivatives, |v| without_periods(v, period, 1.0 / period)),
        }
        all_finite(out, p.min, p.max);
    }
}

/// What [`wide_lanes`] reads for one coordinate.
struct Wide {
    n0: f64,
    nx: f64,
    ny: f64,
    c: f64,
    min: f64,
    max: f64,
    d_x: f64,
    d_y: f64,
    even: bool,
}

impl Wide {
    /// The coordinate, and its derivatives where they are asked for.
    #[inline(always)]
    fn lanes(
        &self,
        [out, ddx, ddy]: [&mut Lanes; 3],
        rq: &[f64; LANES],
        places: &impl Positions,
        derivatives: bool,
        near: impl Fn(f64) -> f64,
    ) {
        let Self { n0, nx, ny, c, min, max, d_x, d_y, even } = *self;
        let t = |i: usize| ((n0 + ny * f64::from(places.y(i))) + nx * f64::from(places.x(i))) * rq[i];
        let limited = |t: f64| {
            let v = c + t;
            let v = if v > min { v } else { min };
            near(if v < max { v } else { max }) as f32
        };
        if derivatives && even {
            for i in 0..LANES {
                out[i] = limited(t(i));
            }
            // (N_x - t 0) 1 is N_x.
            *ddx = [nx as f32; LANES];
            *ddy = [ny as f32; LANES];
        } else if derivatives {
            for i in 0..LANES {
                let t = t(i);
                out[i] = limited(t);
                ddx[i] = ((nx - t * d_x) * rq[i]) as f32;
                ddy[i] = ((ny - t * d_y) * rq[i]) as f32;
            }
        } else {
            for i in 0..LANES {
                out[i] = limited(t(i));
            }
        }
    }
}

/// A piece of a segment in `f64`.
#[inline(always)]
pub(crate) fn wide_piece<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    slots: &UnitSlots,
    leaves: bool,
    derivatives: bool,
    piece: Piece,
    (dx, dy): (&Chunk, &Chunk),
) {
    if leaves && !unit.has_q {
        reciprocals(&mut b.rw, unit.planes, true, piece, dx, dy);
    }
    let mut rq = linear64(&unit.divisor, dx, dy);
    for q in &mut rq {
        *q = reciprocal64(*q);
    }
    let d = &unit.divisor;
    for k in 0..K {
        let p = &unit.coords[k];
        let n = linear64(&Linear { at: p.n0, x: p.nx, y: p.ny }, dx, dy);
        let (c, min, max) = (f64::from(p.c), f64::from(p.min), f64::from(p.max));
        let period = f64::from(slots.period[k]);
        let inverse = if period > 0.0 { 1.0 / period } else { 0.0 };
        let mut out = [0.0; CHUNK];
        for i in 0..CHUNK {
            let v = c + n[i] * rq[i];
            let v = if v > min { v } else { min };
            let v = if v < max { v } else { max };
            out[i] = finite(without_periods(v, period, inverse) as f32);
        }
        put(&mut b.tex.coord[k], piece, &out);
        if derivatives {
            let mut out_y = [0.0; CHUNK];
            for i in 0..CHUNK {
                let t = n[i] * rq[i];
                out[i] = ((p.nx - t * d.x) * rq[i]) as f32;
                out_y[i] = ((p.ny - t * d.y) * rq[i]) as f32;
            }
            put(&mut b.tex.ddx[k], piece, &out);
            put(&mut b.tex.ddy[k], piece, &out_y);
        }
    }
}
