//! Interpolation of colours and fog coordinates (OpenGL 1.5, sections 3.4.1, 3.5.1): every slot's plane is evaluated at
//! the pixel, as `clamp(c + N / D, min, max)` (see [`planes`](crate::fragment::planes)). D is shared by all slots, so 1 / D is kept
//! for the stages that follow.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{GROUP, Plane, PlaneGroup, Planes};
use crate::fragment::reference::lanes::{
    CHUNK, Chunk, Piece, Positions, Row, Rows, chunk, linear, linear64, one_primitive, pieces, positions, put,
    single_row,
};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::clamp_f32;
use crate::simd::{Cost, LANES, stage};
use crate::texture::batch::Lanes;

/// 1 / D with one Newton step in `f64`: what the planes of wide primitives are multiplied with.
#[inline(always)]
pub(crate) fn reciprocal64(d: f64) -> f64 {
    let r = f64::from(1.0 / d as f32);
    r * (2.0 - d * r)
}

/// 1 / D of a piece.
#[inline(always)]
fn reciprocal(planes: &Planes, dx: &Chunk, dy: &Chunk) -> Chunk {
    let mut rw = [0.0; CHUNK];
    if planes.wide & Planes::WIDE_W != 0 {
        let d = linear64(&planes.d, dx, dy);
        for i in 0..CHUNK {
            rw[i] = reciprocal64(d[i]) as f32;
        }
    } else {
        let d = linear(planes.d.at as f32, planes.d.x as f32, planes.d.y as f32, dx, dy);
        for i in 0..CHUNK {
            rw[i] = 1.0 / d[i];
        }
    }
    rw
}

/// The value of a plane at the lanes of a piece.
#[inline(always)]
pub(crate) fn value(p: &Plane, wide: bool, dx: &Chunk, dy: &Chunk, rw: &Chunk) -> Chunk {
    let mut n = linear(p.n0 as f32, p.nx as f32, p.ny as f32, dx, dy);
    if wide {
        for i in 0..CHUNK {
            n[i] = ((p.n0 + p.ny * f64::from(dy[i])) + p.nx * f64::from(dx[i])) as f32;
        }
    }
    for i in 0..CHUNK {
        n[i] = clamp_f32(p.c + n[i] * rw[i], p.min, p.max);
    }
    n
}

/// The same for a member of a group.
#[inline(always)]
pub(crate) fn value_of_member(p: &PlaneGroup, member: usize, dx: &Chunk, dy: &Chunk, rw: &Chunk) -> Chunk {
    let at = member % GROUP;
    let mut n = linear(p.n0[at], p.nx[at], p.ny[at], dx, dy);
    for i in 0..CHUNK {
        n[i] = clamp_f32(p.c[at] + n[i] * rw[i], p.min[at], p.max[at]);
    }
    n
}

/// The group of a primitive that is in one, for its slots from `slot` on, and which one it is of the group.
#[inline(always)]
pub(crate) fn group<'a, const K: usize>(
    work: &Work<'a, '_>,
    planes: &Planes,
    slot: usize,
) -> Option<(&'a [PlaneGroup; K], usize)> {
    let member = planes.member?;
    let first = (planes.first as usize).checked_add(slot)?;
    Some((work.pool.groups.get(first..)?.first_chunk()?, member as usize))
}

/// The primitive of a segment, which is in no group, and the planes of its slots from `slot` on.
#[inline(always)]
pub(crate) fn primitive<'a, const K: usize>(
    work: &Work<'a, '_>,
    segment: &Segment,
    slot: usize,
) -> Option<(&'a Planes, &'a [Plane; K])> {
    let planes = work.planes.get(segment.prim as usize)?;
    let first = (planes.first as usize).checked_add(slot)?;
    if planes.member.is_some() {
        return None;
    }
    Some((planes, work.pool.alone.get(first..)?.first_chunk()?))
}

/// Makes sure that `rw` holds 1 / D: `first` is whether this stage is the first to need it.
#[inline(always)]
pub(crate) fn reciprocals(
    lanes: &mut Lanes,
    planes: &Planes,
    first: bool,
    piece: Piece,
    dx: &Chunk,
    dy: &Chunk,
) -> Chunk {
    if first {
        let rw = reciprocal(planes, dx, dy);
        put(lanes, piece, &rw);
        rw
    } else {
        chunk(lanes, piece)
    }
}

/// The lanes that interpolation reads, apart from those that it writes.
struct Places<'a> {
    segments: &'a [Segment],
    lanes: (&'a Lanes, &'a Lanes),
    single_row: bool,
}

/// Lanes of one primitive that fill the batch.
#[inline(always)]
fn whole<const K: usize>(
    places: &impl Positions,
    planes: &Planes,
    pool: &[Plane; K],
    first: bool,
    rw: &mut Lanes,
    out: &mut [Lanes; K],
) {
    if first {
        if planes.affine {
            *rw = [1.0; LANES];
        } else {
            let (at, x, y) = (planes.d.at as f32, planes.d.x as f32, planes.d.y as f32);
            for i in 0..LANES {
                rw[i] = 1.0 / ((at + y * places.y(i)) + x * places.x(i));
            }
        }
    }
    for k in 0..K {
        let p = &pool[k];
        let (at, x, y) = (p.n0 as f32, p.nx as f32, p.ny as f32);
        let n = |i: usize| (at + y * places.y(i)) + x * places.x(i);
        let (c, min, max) = (p.c, p.min, p.max);
        let out = &mut out[k];
        if min == max {
            *out = [max; LANES];
        } else if planes.affine {
            for i in 0..LANES {
                out[i] = clamp_f32(c + n(i), min, max);
            }
        } else {
            for i in 0..LANES {
                out[i] = clamp_f32(c + n(i) * rw[i], min, max);
            }
        }
    }
}

/// K slots from `slot` on for all segments.
#[inline(always)]
fn slots<const K: usize>(
    b: &Places<'_>,
    work: &Work<'_, '_>,
    slot: Option<usize>,
    first: bool,
    rw: &mut Lanes,
    out: &mut [Lanes; K],
) {
    let Some(slot) = slot else { return };
    if let Some(segment) = one_primitive(b.segments)
        && let Some((planes, pool)) = primitive::<K>(work, &segment, slot)
        && planes.wide & Planes::WIDE_W == 0
    {
        if b.single_row {
            whole(&Row::new(&segment, planes), planes, pool, first, rw, out);
        } else {
            whole(&Rows::new(b.segments, b.lanes, planes), planes, pool, first, rw, out);
        }
        return;
    }
    for segment in b.segments {
        if let Some(planes) = work.planes.get(segment.prim as usize)
            && let Some((groups, member)) = group::<K>(work, planes, slot)
        {
            for piece in pieces(segment) {
                let (dx, dy) = positions(b.lanes, segment, planes, piece);
                let rw = reciprocals(rw, planes, first, piece, &dx, &dy);
                for k in 0..K {
                    put(&mut out[k], piece, &value_of_member(&groups[k], member, &dx, &dy, &rw));
                }
            }
            continue;
        }
        let Some((planes, pool)) = primitive::<K>(work, segment, slot) else { continue };
        for piece in pieces(segment) {
            let (dx, dy) = positions(b.lanes, segment, planes, piece);
            let rw = reciprocals(rw, planes, first, piece, &dx, &dy);
            for k in 0..K {
                let v = value(&pool[k], planes.wide & Planes::WIDE_W != 0, &dx, &dy, &rw);
                put(&mut out[k], piece, &v);
            }
        }
    }
}

/// [`slots`] with lanes of a batch.
macro_rules! slots {
    ($b:expr, $w:expr, $slot:expr, $arg:expr, $out:expr) => {{
        let single_row = single_row($b);
        let segments = $b.segments.get(..$b.segment_count).unwrap_or(&[]);
        let places = Places { segments, lanes: (&$b.dx, &$b.dy), single_row };
        slots(&places, $w, $slot, $arg & FIRST != 0, &mut $b.rw, $out);
    }};
}

/// The cost of stages that multiply with 1 / D.
pub(crate) const DIVIDES: Cost = Cost { divides: true, ..Cost::NONE };

/// Bit of a stage's number: the stage is the first that needs 1 / D.
pub(crate) const FIRST: u32 = 1;

stage! {
    /// The primary colour, as the fragment's colour.
    pub(crate) fn COLOR: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.color, arg, &mut b.tex.previous);
    }

    /// The primary colour for texture environments, which read it by name or as what comes before the first unit.
    pub(crate) fn PRIMARY: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.color, arg, &mut b.tex.primary);
    }

    /// The secondary colour.
    pub(crate) fn SECONDARY: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.secondary, arg, &mut b.secondary);
    }

    /// The fog coordinate.
    pub(crate) fn FOG_COORDINATE: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.fog, arg, std::array::from_mut(&mut b.fog));
    }
}
