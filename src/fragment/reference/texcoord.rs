//! Texture coordinates at the fragment (OpenGL 1.5, sections 3.5.1 and 3.8.8): s/q, t/q, r/q of one unit and, where the
//! sampler asks for them, their exact derivatives in the window, from the planes and not from neighbouring fragments:
//!
//! ```text
//!   u = c + N / Q        du/dx = (N_x - (N / Q) Q_x) / Q        Q = D where the unit has no q
//! ```
//!
//! Primitives whose coordinates or w range too far are evaluated in `f64`, and whole periods are taken off before the
//! result becomes `f32`. Whatever comes in, a finite coordinate goes out: what is not finite becomes 0.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::lod_bounds;
use crate::fragment::planes::{GROUP, Linear, Plane, PlaneGroup, Planes, UnitSlots};
use crate::fragment::reference::interpolate::{DIVIDES, FIRST, group, reciprocals};
use crate::fragment::reference::lanes::{
    CHUNK, Chunk, Piece, Positions, Row, Rows, linear, one_primitive, pieces, positions, put, row_origin, single_row,
};
use crate::fragment::reference::texcoord_f64::{wide_lanes, wide_piece};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::{clamp_f32, max_f32};
use crate::simd::{LANES, stage};
use crate::texture::batch::{Derivatives, Lanes};

/// Bits of the number of [`COORDINATES`]: [`FIRST`], this one for derivatives, the unit from bit 2 on, then [`ALONE`].
pub(crate) const DERIVATIVES: u32 = 2;
/// No later stage reads 1 / D: it need not be left behind.
pub(crate) const ALONE: u32 = 1 << 8;

/// A later unit is divided by D as well and may take what 1 / D this one leaves in `f64`.
pub(crate) const SHARED: u32 = 1 << 9;
/// An earlier unit may have left 1 / D in `f64`.
pub(crate) const AGAIN: u32 = 1 << 10;

/// The unit in the number of [`COORDINATES`].
pub(crate) fn unit_of(number: u32) -> usize {
    (number >> 2) as usize & 31
}

/// What is not finite becomes 0.
#[inline(always)]
pub(crate) fn finite(v: f32) -> f32 {
    // The exponent of infinities and NaN is all ones; a comparison of floats would do, but this selects by bits.
    let bits = v.to_bits();
    let keep = u32::from(bits & 0x7F80_0000 != 0x7F80_0000).wrapping_neg();
    f32::from_bits(bits & keep)
}

/// One unit's planes: those of its coordinates and the divisor.
pub(crate) struct Unit<'a, const K: usize> {
    pub planes: &'a Planes,
    pub coords: &'a [Plane; K],
    /// Q, or D where the unit has no q.
    pub divisor: Linear,
    pub has_q: bool,
    pub wide: bool,
}

/// The planes of a segment's primitive for a unit.
#[inline(always)]
pub(crate) fn unit<'a, const K: usize>(
    w: &Work<'a, '_>,
    segment: &Segment,
    slots: &UnitSlots,
    index: u32,
) -> Option<Unit<'a, K>> {
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

/// 1 / D, or 1 / Q where the unit has a q. 1 / D is left for later stages that read it, or taken from an earlier one.
#[inline(always)]
pub(crate) fn divisors<const K: usize>(
    rw: &mut Lanes,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    first: First,
) -> Lanes {
    let d = &unit.divisor;
    let (d_at, d_x, d_y) = (d.at as f32, d.x as f32, d.y as f32);
    if !unit.has_q && !first.computes {
        return *rw;
    }
    let mut rq = [1.0; LANES];
    if unit.has_q || !unit.planes.affine {
        for i in 0..LANES {
            rq[i] = 1.0 / ((d_at + d_y * places.y(i)) + d_x * places.x(i));
        }
    }
    if !unit.has_q && first.leaves {
        *rw = rq;
    }
    rq
}

/// Whether a unit's derivatives are the same everywhere: those of its numerators.
#[inline(always)]
pub(crate) fn is_even<const K: usize>(unit: &Unit<'_, K>) -> bool {
    let d = &unit.divisor;
    unit.planes.affine && !unit.has_q && d.at == 1.0 && d.x == 0.0 && d.y == 0.0
}

/// Lanes of one primitive that fill the batch, all in `f32`.
#[inline(always)]
fn lanes<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    first: First,
    derivatives: bool,
) {
    let one = unit.planes.affine && !unit.has_q;
    let (d_x, d_y) = (unit.divisor.x as f32, unit.divisor.y as f32);
    let even = is_even(unit);
    if even {
        b.tex.derivatives = Derivatives::Uniform;
    }
    let rq = if one && !first.computes { [1.0; LANES] } else { divisors(&mut b.rw, unit, places, first) };
    for k in 0..K {
        let p = &unit.coords[k];
        let (c, min, max) = (p.c, p.min, p.max);
        let (at, x, y) = (p.n0 as f32, p.nx as f32, p.ny as f32);
        let n = |i: usize| (at + y * places.y(i)) + x * places.x(i);
        b.tex.limit[k] = max_f32(max.abs(), min.abs());
        b.tex.least[k] = min;
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
            if even {
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
pub(crate) fn all_finite(out: &mut Lanes, min: f32, max: f32) {
    if !(min.is_finite() && max.is_finite()) {
        for v in out {
            *v = finite(*v);
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

/// Whether a stage has to compute 1 / D, whether to leave it for later ones, and whether for later units in `f64`.
#[derive(Clone, Copy)]
pub(crate) struct First {
    pub computes: bool,
    pub leaves: bool,
    pub shared: bool,
}

/// All lanes of a batch of one primitive.
#[inline(always)]
pub(crate) fn whole<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    places: &impl Positions,
    slots: &UnitSlots,
    first: First,
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
fn coordinates<const K: usize>(b: &mut FragmentBatch, u: &FragUniforms, w: &Work<'_, '_>, slots: &UnitSlots, arg: u32) {
    let (index, derivatives) = (unit_of(arg) as u32, arg & DERIVATIVES != 0);
    let first =
        First { computes: arg & FIRST != 0, leaves: arg & FIRST != 0 && arg & ALONE == 0, shared: arg & SHARED != 0 };
    if arg & AGAIN == 0 {
        b.has_rw64 = false;
    }
    b.tex.derivatives = Derivatives::PerLane;
    let segments = b.segments.get(..b.segment_count).unwrap_or(&[]);
    if let Some(segment) = one_primitive(segments)
        && let Some(unit) = unit::<K>(w, &segment, slots, index)
    {
        if single_row(b) {
            let mut derivatives = derivatives;
            if let Some(Some(levels)) = u.levels.get(index as usize)
                && !is_even(&unit)
            {
                let (x, y) = row_origin(&segment, unit.planes);
                b.tex.derivatives =
                    lod_bounds::of_row(&mut b.lookahead, index as usize, &b.tex, &unit, (x, y, segment.len), levels);
                derivatives &= b.tex.derivatives == Derivatives::PerLane;
            }
            whole(b, &unit, &Row::new(&segment, unit.planes), slots, first, derivatives);
        } else {
            let rows = Rows::new(segments, (&b.dx, &b.dy), unit.planes);
            whole(b, &unit, &rows, slots, first, derivatives);
        }
        return;
    }
    b.tex.limit = [f32::INFINITY; 3];
    b.tex.least = [f32::NEG_INFINITY; 3];
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        if let Some(planes) = w.planes.get(segment.prim as usize)
            && let Some(group) = group::<K>(w, planes, slots.base)
        {
            for piece in pieces(&segment) {
                let (dx, dy) = positions((&b.dx, &b.dy), &segment, planes, piece);
                grouped(b, planes, group, first.computes, derivatives, piece, (&dx, &dy));
            }
            continue;
        }
        let Some(unit) = unit::<K>(w, &segment, slots, index) else { continue };
        for piece in pieces(&segment) {
            let (dx, dy) = positions((&b.dx, &b.dy), &segment, unit.planes, piece);
            if unit.wide {
                wide_piece(b, &unit, slots, first.leaves, derivatives, piece, (&dx, &dy));
            } else {
                narrow(b, &unit, first.computes, derivatives, piece, (&dx, &dy));
            }
        }
    }
}

stage! {
    /// The coordinates of one unit, and their derivatives where the sampler needs them.
    pub(crate) fn COORDINATES: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(Some(slots)) = u.layout.units.get(unit_of(arg)) else { return };
        match slots.count {
            1 => coordinates::<1>(b, u, w, slots, arg),
            2 => coordinates::<2>(b, u, w, slots, arg),
            _ => coordinates::<3>(b, u, w, slots, arg),
        }
    }
}
