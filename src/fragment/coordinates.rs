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
use super::segments::{CHUNK, Chunk, IOTA, Piece, linear, linear64, pieces, positions, put, row_origin, single_row};
use super::uniforms::{FragFn, FragUniforms, Work};
use crate::batch::{LANES, stage};
use crate::num::clamp_f32;

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

/// A row of one primitive that fills the batch, all in `f32`.
#[inline(always)]
fn row<const K: usize>(b: &mut FragmentBatch, unit: &Unit<'_, K>, first: bool, derivatives: bool) {
    let (x0, y) = row_origin(&b.segments[0], unit.planes);
    let (x0, y) = (x0 as f32, y as f32);
    let d = &unit.divisor;
    let (d_at, d_x, d_y) = (d.at as f32 + d.y as f32 * y, d.x as f32, d.y as f32);
    let one = unit.planes.affine && !unit.has_q;
    let mut rq = [1.0; LANES];
    if unit.has_q || (first && !one) {
        for i in 0..LANES {
            rq[i] = 1.0 / (d_at + d_x * (x0 + IOTA[i]));
        }
    } else if !one {
        rq = b.rw;
    }
    if first && !unit.has_q {
        b.rw = rq;
    }
    for k in 0..K {
        let p = &unit.coords[k];
        let (c, min, max) = (p.c, p.min, p.max);
        let (at, x, y) = (p.n0 as f32 + p.ny as f32 * y, p.nx as f32, p.ny as f32);
        let out = &mut b.tex.coord[k];
        if one {
            for i in 0..LANES {
                out[i] = finite(clamp_f32(c + (at + x * (x0 + IOTA[i])), min, max));
            }
        } else {
            for i in 0..LANES {
                out[i] = finite(clamp_f32(c + (at + x * (x0 + IOTA[i])) * rq[i], min, max));
            }
        }
        if derivatives {
            let (ddx, ddy) = (&mut b.tex.ddx[k], &mut b.tex.ddy[k]);
            if one && d_x == 0.0 && d_y == 0.0 {
                // (N_x - t 0) 1 is N_x.
                *ddx = [x; LANES];
                *ddy = [y; LANES];
                continue;
            }
            for i in 0..LANES {
                let t = (at + x * (x0 + IOTA[i])) * rq[i];
                ddx[i] = (x - t * d_x) * rq[i];
                ddy[i] = (y - t * d_y) * rq[i];
            }
        }
    }
}

/// A row of one primitive that fills the batch, in `f64`: [`wide`] for all lanes at once.
#[inline(always)]
fn wide_row<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    slots: &UnitSlots,
    first: bool,
    derivatives: bool,
) {
    let (x0, y) = row_origin(&b.segments[0], unit.planes);
    // As in the pieces of a segment, positions are whole numbers that went through `f32`.
    let (x0, y) = (x0 as f32, f64::from(y as f32));
    let d = &unit.divisor;
    let d_at = d.at + d.y * y;
    let mut rq = [0.0; LANES];
    for i in 0..LANES {
        rq[i] = reciprocal64(d_at + d.x * f64::from(x0 + IOTA[i]));
    }
    if first && !unit.has_q {
        // What colours are multiplied with is f64 only where the whole primitive is wide.
        if unit.planes.wide & Planes::WIDE_W != 0 {
            for i in 0..LANES {
                b.rw[i] = rq[i] as f32;
            }
        } else {
            let (d_at, d_x) = (d.at as f32 + d.y as f32 * y as f32, d.x as f32);
            for i in 0..LANES {
                b.rw[i] = 1.0 / (d_at + d_x * (x0 + IOTA[i]));
            }
        }
    }
    for k in 0..K {
        let p = &unit.coords[k];
        let at = p.n0 + p.ny * y;
        let (c, min, max) = (f64::from(p.c), f64::from(p.min), f64::from(p.max));
        let period = f64::from(slots.period[k]);
        let inverse = if period > 0.0 { 1.0 / period } else { 0.0 };
        let out = &mut b.tex.coord[k];
        for i in 0..LANES {
            let v = c + (at + p.nx * f64::from(x0 + IOTA[i])) * rq[i];
            let v = if v > min { v } else { min };
            let v = if v < max { v } else { max };
            out[i] = finite(without_periods(v, period, inverse) as f32);
        }
        if derivatives {
            let (ddx, ddy) = (&mut b.tex.ddx[k], &mut b.tex.ddy[k]);
            for i in 0..LANES {
                let t = (at + p.nx * f64::from(x0 + IOTA[i])) * rq[i];
                ddx[i] = ((p.nx - t * d.x) * rq[i]) as f32;
                ddy[i] = ((p.ny - t * d.y) * rq[i]) as f32;
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

/// All segments of a batch for a unit of K coordinates.
#[inline(always)]
fn coordinates<const K: usize>(b: &mut FragmentBatch, w: &Work<'_, '_>, slots: &UnitSlots, arg: u32) {
    let (index, first, derivatives) = (arg >> 2, arg & FIRST != 0, arg & DERIVATIVES != 0);
    if single_row(b)
        && let Some(unit) = unit::<K>(w, &b.segments[0], slots, index)
    {
        if unit.wide {
            wide_row(b, &unit, slots, first, derivatives);
        } else {
            row(b, &unit, first, derivatives);
        }
        return;
    }
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
