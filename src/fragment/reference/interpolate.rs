//! Interpolation of colours and fog coordinates (OpenGL 1.5, sections 3.4.1, 3.5.1): every slot's plane is evaluated at
//! the pixel, as `clamp(c + N / D, min, max)` (see [`planes`](crate::fragment::planes)). D is shared by all slots, so 1 / D is kept
//! for the stages that follow.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::plane_eval::{
    LinearEval, PlaneEval, Points, Positions, Real, reciprocals as all_reciprocals, sums,
};
use crate::fragment::planes::{Plane, PlaneGroup, Planes};
use crate::fragment::reference::lanes::{
    CHUNK, Chunk, Piece, all_positions, chunk, one_primitive, pieces, positions, put, row_positions, single_row,
};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{Cost, LANES, stage};
use crate::texture::batch::Lanes;

/// 1 / D of a piece.
#[inline(always)]
fn reciprocal(planes: &Planes, at: &Points<CHUNK>) -> Chunk {
    if planes.wide & Planes::WIDE_W != 0 {
        all_reciprocals(&LinearEval::<f64>::new(&planes.d, None), at).map(Real::to_f32)
    } else {
        all_reciprocals(&LinearEval::new(&planes.d, None), at)
    }
}

/// The value of a plane at the lanes of a piece; of a `wide` one the numerator is summed in `f64`.
#[inline(always)]
pub fn value(p: &Plane, wide: bool, at: &Points<CHUNK>, rw: &Chunk) -> Chunk {
    let plane = PlaneEval::<f32>::new(p, None);
    let mut n = sums(&plane.n, at);
    if wide {
        n = sums(&LinearEval::<f64>::new(&p.numerator(), None), at).map(Real::to_f32);
    }
    for i in 0..CHUNK {
        n[i] = plane.limited(n[i] * rw[i]);
    }
    n
}

/// The same for a member of a group.
#[inline(always)]
pub fn value_of_member(p: &PlaneGroup, member: usize, at: &Points<CHUNK>, rw: &Chunk) -> Chunk {
    PlaneEval::of_member(p, member).at(at, rw, false)
}

/// Makes sure that `rw` holds 1 / D: `first` is whether this stage is the first to need it.
#[inline(always)]
pub fn reciprocals(lanes: &mut Lanes, planes: &Planes, first: bool, piece: Piece, at: &Points<CHUNK>) -> Chunk {
    if first {
        let rw = reciprocal(planes, at);
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
    at: impl Positions<LANES>,
    planes: &Planes,
    pool: &[Plane; K],
    first: bool,
    rw: &mut Lanes,
    out: &mut [Lanes; K],
) {
    if first {
        *rw = if planes.affine { [1.0; LANES] } else { all_reciprocals(&LinearEval::new(&planes.d, None), at) };
    }
    for k in 0..K {
        if pool[k].min == pool[k].max {
            out[k] = [pool[k].max; LANES];
        } else {
            PlaneEval::new(&pool[k], None).fill(at, rw, planes.affine, &mut out[k]);
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
        && let Some((planes, pool)) = work.primitive::<K>(&segment, slot)
        && planes.wide & Planes::WIDE_W == 0
    {
        if b.single_row {
            whole(row_positions(&segment, planes), planes, pool, first, rw, out);
        } else {
            whole(&all_positions(b.segments, b.lanes, planes), planes, pool, first, rw, out);
        }
        return;
    }
    for segment in b.segments {
        if let Some(planes) = work.planes.get(segment.prim as usize)
            && let Some((groups, member)) = work.group::<K>(planes, slot)
        {
            for piece in pieces(segment) {
                let at = positions(b.lanes, segment, planes, piece);
                let rw = reciprocals(rw, planes, first, piece, &at);
                for k in 0..K {
                    put(&mut out[k], piece, &value_of_member(&groups[k], member, &at, &rw));
                }
            }
            continue;
        }
        let Some((planes, pool)) = work.primitive::<K>(segment, slot) else { continue };
        for piece in pieces(segment) {
            let at = positions(b.lanes, segment, planes, piece);
            let rw = reciprocals(rw, planes, first, piece, &at);
            for k in 0..K {
                let v = value(&pool[k], planes.wide & Planes::WIDE_W != 0, &at, &rw);
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
pub const DIVIDES: Cost = Cost { divides: true, ..Cost::NONE };

/// Bit of a stage's number: the stage is the first that needs 1 / D.
pub const FIRST: u32 = 1;

stage! {
    /// The primary colour, as the fragment's colour.
    pub fn COLOR: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.color, arg, &mut b.tex.previous);
    }

    /// The primary colour for texture environments, which read it by name or as what comes before the first unit.
    pub fn PRIMARY: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.color, arg, &mut b.tex.primary);
    }

    /// The secondary colour.
    pub fn SECONDARY: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.secondary, arg, &mut b.secondary);
    }

    /// The fog coordinate.
    pub fn FOG_COORDINATE: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        slots!(b, w, u.layout.fog, arg, std::array::from_mut(&mut b.fog));
    }
}
