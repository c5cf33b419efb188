//! Texture coordinates at the fragment (OpenGL 1.5, sections 3.5.1 and 3.8.8): s/q, t/q, r/q of one unit and, where the
//! sampler asks for them, their exact derivatives in the window, from the planes and not from neighbouring fragments:
//!
//! ```text
//!   u = c + N / Q        du/dx = (N_x - (N / Q) Q_x) / Q        Q = D where the unit has no q
//! ```
//!
//! Primitives whose coordinates or w range too far are evaluated in `f64`, and whole periods are taken off before the
//! result becomes `f32`. Whatever comes in, a finite coordinate goes out: what is not finite becomes 0.

use super::batch::{FragmentBatch, Segment};
use super::interpolate::{FIRST, group, reciprocal64, reciprocals};
use super::planes::{GROUP, Linear, Plane, PlaneGroup, Planes, UnitSlots};
use super::segments::{
    CHUNK, Chunk, Piece, Positions, Row, Rows, linear, linear64, one_primitive, pieces, positions, put, single_row,
};
use super::uniforms::{FragFn, FragUniforms, Work};
use crate::batch::{LANES, stage};
use crate::num::{clamp_f32, max_f32};
use crate::texture::batch::{Lanes, TexBatch};

/// Bits of the number of [`COORDINATES`]: [`FIRST`], this one for derivatives, the unit from bit 2 on.
pub(super) const DERIVATIVES: u32 = 2;

/// What is not finite becomes 0.
#[inline(always)]
fn finite(v: f32) -> f32 {
    // The exponent of infinities and NaN is all ones; a comparison of floats would do, but this selects by bits.
    let bits = v.to_bits();
    let keep = u32::from(bits & 0x7F80_0000 != 0x7F80_0000).wrapping_neg();
    f32::from_bits(bits & keep)
}

/// Takes whole periods off: the result is within half a period of 0. `period` 0 leaves the value.
#[inline(always)]
fn without_periods(v: f64, period: f64, inverse: f64) -> f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    v - period * ((v * inverse + MAGIC) - MAGIC)
}

/// One unit's planes: those of its coordinates and the divisor.
struct Unit<'a, const K: usize> {
    planes: &'a Planes,
    coords: &'a [Plane; K],
    /// Q, or D where the unit has no q.
    divisor: Linear,
    has_q: bool,
    wide: bool,
}

/// The planes of a segment's primitive for a unit.
#[inline(always)]
fn unit<'a, const K: usize>(w: &Work<'a, '_>, segment: &Segment, slots: &UnitSlots, index: u32) -> Option<Unit<'a, K>> {
    let planes = w.planes.get(segment.prim as usize)?;
    let first = (planes.first as usize).checked_add(slots.base)?;
    if planes.member.is_some() {
        return None;
    }
    let coords = w.pool.alone.get(first..)?.first_chunk()?;
    let has_q = slots.has_q && !slots.cube;
    let divisor = if has_q {
        let q = w.pool.alone.get(first + K)?;
        Linear { at: q.n0, x: q.nx, y: q.ny }
    } else {
        planes.d
    };
    let wide = (planes.wide >> (index & 31)) & 1 != 0 || (planes.wide & Planes::WIDE_W != 0 && !has_q);
    Some(Unit { planes, coords, divisor, has_q, wide })
}

/// 1 / D, or 1 / Q where the unit has a q. 1 / D is kept for the stages that follow, or taken from the one before.
#[inline(always)]
fn divisors<const K: usize>(rw: &mut Lanes, unit: &Unit<'_, K>, places: &impl Positions, first: bool) -> Lanes {
    let d = &unit.divisor;
    let (d_at, d_x, d_y) = (d.at as f32, d.x as f32, d.y as f32);
    if !unit.has_q && !first {
        return *rw;
    }
    let mut rq = [1.0; LANES];
    if unit.has_q || !unit.planes.affine {
        for i in 0..LANES {
            rq[i] = 1.0 / ((d_at + d_y * places.y(i)) + d_x * places.x(i));
        }
    }
    if !unit.has_q {
        *rw = rq;
    }
    rq
}

/// Lanes of one primitive that fill the batch, all in `f32`.
#[inline(always)]
fn lanes<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    first: bool,
    derivatives: bool,
) {
    let one = unit.planes.affine && !unit.has_q;
    let (d_x, d_y) = (unit.divisor.x as f32, unit.divisor.y as f32);
    let rq = if one && !first { [1.0; LANES] } else { divisors(&mut b.rw, unit, places, first) };
    for k in 0..K {
        let p = &unit.coords[k];
        let (c, min, max) = (p.c, p.min, p.max);
        let (at, x, y) = (p.n0 as f32, p.nx as f32, p.ny as f32);
        let n = |i: usize| (at + y * places.y(i)) + x * places.x(i);
        b.tex.limit[k] = max_f32(max.abs(), min.abs());
        let out = &mut b.tex.coord[k];
        let (ddx, ddy) = (&mut b.tex.ddx[k], &mut b.tex.ddy[k]);
        if one {
            for i in 0..LANES {
                out[i] = clamp_f32(c + n(i), min, max);
            }
        } else if !derivatives {
            for i in 0..LANES {
                out[i] = clamp_f32(c + n(i) * rq[i], min, max);
            }
        } else {
            for i in 0..LANES {
                let t = n(i) * rq[i];
                out[i] = clamp_f32(c + t, min, max);
                ddx[i] = (x - t * d_x) * rq[i];
                ddy[i] = (y - t * d_y) * rq[i];
            }
        }
        if one && derivatives {
            if d_x == 0.0 && d_y == 0.0 {
                // (N_x - t 0) 1 is N_x.
                *ddx = [x; LANES];
                *ddy = [y; LANES];
            } else {
                for i in 0..LANES {
                    ddx[i] = x - n(i) * d_x;
                    ddy[i] = y - n(i) * d_y;
                }
            }
        }
        all_finite(out, min, max);
    }
}

/// [`finite`] for all lanes. Between finite limits it has nothing to do.
#[inline(always)]
fn all_finite(out: &mut Lanes, min: f32, max: f32) {
    if !(min.is_finite() && max.is_finite()) {
        for v in out {
            *v = finite(*v);
        }
    }
}

/// Lanes of one primitive that fill the batch, in `f64`: [`wide`] for all lanes at once.
#[inline(always)]
fn wide_lanes<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    slots: &UnitSlots,
    first: bool,
    derivatives: bool,
) {
    // As in the pieces of a segment, positions are whole numbers that went through `f32`.
    let (px, py) = (|i: usize| f64::from(places.x(i)), |i: usize| f64::from(places.y(i)));
    let d = &unit.divisor;
    let mut rq = [0.0; LANES];
    for i in 0..LANES {
        rq[i] = reciprocal64((d.at + d.y * py(i)) + d.x * px(i));
    }
    if first && !unit.has_q {
        // What colours are multiplied with is f64 only where the whole primitive is wide.
        if unit.planes.wide & Planes::WIDE_W != 0 {
            for i in 0..LANES {
                b.rw[i] = rq[i] as f32;
            }
        } else {
            divisors(&mut b.rw, unit, places, true);
        }
    }
    for k in 0..K {
        let p = &unit.coords[k];
        let (c, min, max) = (f64::from(p.c), f64::from(p.min), f64::from(p.max));
        let TexBatch { coord, ddx, ddy, limit, .. } = &mut b.tex;
        let (out, ddx, ddy) = (&mut coord[k], &mut ddx[k], &mut ddy[k]);
        let of = Wide { n0: p.n0, nx: p.nx, ny: p.ny, c, min, max, d_x: d.x, d_y: d.y };
        let period = f64::from(slots.period[k]);
        // Half a period is left, and what rounding adds, of numbers that have a fraction.
        let greatest = max_f32(p.max.abs(), p.min.abs());
        limit[k] = if slots.period[k] != 0 && greatest < 1e9 { 2.0 } else { greatest };
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
        let Self { n0, nx, ny, c, min, max, d_x, d_y } = *self;
        let t = |i: usize| ((n0 + ny * f64::from(places.y(i))) + nx * f64::from(places.x(i))) * rq[i];
        let limited = |t: f64| {
            let v = c + t;
            let v = if v > min { v } else { min };
            near(if v < max { v } else { max }) as f32
        };
        if derivatives {
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

/// A piece of a segment in `f32`.
#[inline(always)]
fn narrow<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    first: bool,
    derivatives: bool,
    piece: Piece,
    (dx, dy): (&Chunk, &Chunk),
) {
    let d = &unit.divisor;
    let (d_x, d_y) = (d.x as f32, d.y as f32);
    let rq = if unit.has_q {
        let mut rq = linear(d.at as f32, d_x, d_y, dx, dy);
        for q in &mut rq {
            *q = 1.0 / *q;
        }
        rq
    } else {
        reciprocals(&mut b.rw, unit.planes, first, piece, dx, dy)
    };
    for k in 0..K {
        let p = &unit.coords[k];
        let (x, y) = (p.nx as f32, p.ny as f32);
        let n = linear(p.n0 as f32, x, y, dx, dy);
        let mut out = [0.0; CHUNK];
        for i in 0..CHUNK {
            out[i] = finite(clamp_f32(p.c + n[i] * rq[i], p.min, p.max));
        }
        put(&mut b.tex.coord[k], piece, &out);
        if derivatives {
            let mut out_y = [0.0; CHUNK];
            for i in 0..CHUNK {
                let t = n[i] * rq[i];
                out[i] = (x - t * d_x) * rq[i];
                out_y[i] = (y - t * d_y) * rq[i];
            }
            put(&mut b.tex.ddx[k], piece, &out);
            put(&mut b.tex.ddy[k], piece, &out_y);
        }
    }
}

/// A piece of a segment whose primitive is in a group; those have no q.
#[inline(always)]
fn grouped<const K: usize>(
    b: &mut FragmentBatch,
    planes: &Planes,
    (groups, member): (&[PlaneGroup; K], usize),
    first: bool,
    derivatives: bool,
    piece: Piece,
    (dx, dy): (&Chunk, &Chunk),
) {
    let (d_x, d_y) = (planes.d.x as f32, planes.d.y as f32);
    let rw = reciprocals(&mut b.rw, planes, first, piece, dx, dy);
    let at = member % GROUP;
    for k in 0..K {
        let p = &groups[k];
        let (x, y) = (p.nx[at], p.ny[at]);
        let n = linear(p.n0[at], x, y, dx, dy);
        let mut out = [0.0; CHUNK];
        for i in 0..CHUNK {
            out[i] = finite(clamp_f32(p.c[at] + n[i] * rw[i], p.min[at], p.max[at]));
        }
        put(&mut b.tex.coord[k], piece, &out);
        if derivatives {
            let mut out_y = [0.0; CHUNK];
            for i in 0..CHUNK {
                let t = n[i] * rw[i];
                out[i] = (x - t * d_x) * rw[i];
                out_y[i] = (y - t * d_y) * rw[i];
            }
            put(&mut b.tex.ddx[k], piece, &out);
            put(&mut b.tex.ddy[k], piece, &out_y);
        }
    }
}

/// A piece of a segment in `f64`.
#[inline(always)]
fn wide<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    slots: &UnitSlots,
    first: bool,
    derivatives: bool,
    piece: Piece,
    (dx, dy): (&Chunk, &Chunk),
) {
    if first && !unit.has_q {
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

/// All lanes of a batch of one primitive.
#[inline(always)]
fn whole<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    slots: &UnitSlots,
    first: bool,
    derivatives: bool,
) {
    if unit.wide {
        wide_lanes(b, unit, places, slots, first, derivatives);
    } else {
        lanes(b, unit, places, first, derivatives);
    }
}

/// All segments of a batch for a unit of K coordinates.
#[inline(always)]
fn coordinates<const K: usize>(b: &mut FragmentBatch, w: &Work<'_, '_>, slots: &UnitSlots, arg: u32) {
    let (index, first, derivatives) = (arg >> 2, arg & FIRST != 0, arg & DERIVATIVES != 0);
    let segments = b.segments.get(..b.segment_count).unwrap_or(&[]);
    if let Some(segment) = one_primitive(segments)
        && let Some(unit) = unit::<K>(w, &segment, slots, index)
    {
        if single_row(b) {
            whole(b, &unit, &Row::new(&segment, unit.planes), slots, first, derivatives);
        } else {
            let rows = Rows::new(segments, (&b.dx, &b.dy), unit.planes);
            whole(b, &unit, &rows, slots, first, derivatives);
        }
        return;
    }
    b.tex.limit = [f32::INFINITY; 3];
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        if let Some(planes) = w.planes.get(segment.prim as usize)
            && let Some(group) = group::<K>(w, planes, slots.base)
        {
            for piece in pieces(&segment) {
                let (dx, dy) = positions((&b.dx, &b.dy), &segment, planes, piece);
                grouped(b, planes, group, first, derivatives, piece, (&dx, &dy));
            }
            continue;
        }
        let Some(unit) = unit::<K>(w, &segment, slots, index) else { continue };
        for piece in pieces(&segment) {
            let (dx, dy) = positions((&b.dx, &b.dy), &segment, unit.planes, piece);
            if unit.wide {
                wide(b, &unit, slots, first, derivatives, piece, (&dx, &dy));
            } else {
                narrow(b, &unit, first, derivatives, piece, (&dx, &dy));
            }
        }
    }
}

stage! {
    /// The coordinates of one unit, and their derivatives where the sampler needs them.
    pub(super) fn COORDINATES: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(Some(slots)) = u.layout.units.get((arg >> 2) as usize) else { return };
        match slots.count {
            1 => coordinates::<1>(b, w, slots, arg),
            2 => coordinates::<2>(b, w, slots, arg),
            _ => coordinates::<3>(b, w, slots, arg),
        }
    }
}
