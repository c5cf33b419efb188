//! Texture coordinates at the fragment (OpenGL 1.5, sections 3.5.1 and 3.8.8): s/q, t/q, r/q of one unit and, where the
//! sampler asks for them, their exact derivatives in the window, from the planes and not from neighbouring fragments:
//!
//! ```text
//!   u = c + N / Q        du/dx = (N_x - (N / Q) Q_x) / Q        Q = D where the unit has no q
//! ```
//!
//! Primitives whose coordinates or w range too far are evaluated in `f64`, and whole periods are taken off before the
//! result becomes `f32`. Whatever comes in, a finite coordinate goes out: what is not finite becomes 0.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::lod_bounds;
use crate::fragment::plane_eval::{
    LinearEval, PlaneEval, Points, Positions, Real, derivative, reciprocals as all_reciprocals, without_periods,
    without_periods_range,
};
use crate::fragment::planes::{PlaneGroup, Planes, Unit, UnitSlots};
use crate::fragment::reference::interpolate::{DIVIDES, FIRST, reciprocals};
use crate::fragment::reference::lanes::{
    CHUNK, Chunk, Piece, all_positions, one_primitive, pieces, positions, put, row_origin, row_positions, single_row,
};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::max_f32;
use crate::simd::{LANES, stage};
use crate::texture::batch::{Derivatives, Lanes};

/// Bits of the number of [`COORDINATES`]: [`FIRST`], this one for derivatives, the unit from bit 2 on, then [`ALONE`].
pub const DERIVATIVES: u32 = 2;
/// No later stage reads 1 / D: it need not be left behind.
pub const ALONE: u32 = 1 << 8;
/// A later unit is divided by D as well and may take what 1 / D this one leaves in `f64`.
pub const SHARED: u32 = 1 << 9;
/// An earlier unit may have left 1 / D in `f64`.
pub const AGAIN: u32 = 1 << 10;

/// The unit in the number of [`COORDINATES`].
pub fn unit_of(number: u32) -> usize {
    (number >> 2) as usize & 31
}

/// What is not finite becomes 0.
#[inline(always)]
fn finite(v: f32) -> f32 {
    // The exponent of infinities and NaN is all ones; a comparison of floats would do, but this selects by bits.
    let bits = v.to_bits();
    let keep = u32::from(bits & 0x7F80_0000 != 0x7F80_0000).wrapping_neg();
    f32::from_bits(bits & keep)
}

/// [`finite`] for all lanes. Between finite limits it has nothing to do.
#[inline(always)]
fn all_finite<T: Real, const N: usize>(out: &mut [f32; N], plane: &PlaneEval<T>) {
    if !(plane.min.to_f32().is_finite() && plane.max.to_f32().is_finite()) {
        for v in out {
            *v = finite(*v);
        }
    }
}

/// Whether a stage has to compute 1 / D, whether to leave it for later ones, and whether for later units in `f64`.
#[derive(Clone, Copy)]
pub struct First {
    pub computes: bool,
    pub leaves: bool,
    pub shared: bool,
}

/// How one coordinate is evaluated.
struct Coordinate<T> {
    plane: PlaneEval<T>,
    /// How D, or Q, changes in x and y.
    d: [T; 2],
    /// Nothing is divided.
    undivided: bool,
    /// The derivatives are those of the numerator; `None` where derivatives are not needed.
    derivatives: Option<bool>,
}

impl<T: Real> Coordinate<T> {
    /// Writes the coordinate and its derivatives; `finish` takes periods off and rounds.
    #[inline(always)]
    fn write<const N: usize>(
        &self,
        at: impl Positions<N>,
        rq: &[T; N],
        finish: impl Fn(T) -> f32,
        [out, ddx, ddy]: [&mut [f32; N]; 3],
    ) {
        let Self { plane, d: [d_x, d_y], undivided, derivatives } = self;
        let (n_x, n_y) = (plane.n.x, plane.n.y);
        match derivatives {
            Some(false) if !undivided => {
                for i in 0..N {
                    let t = plane.offset(at, i, rq[i]);
                    out[i] = finish(plane.limited(t));
                    ddx[i] = derivative(n_x, *d_x, t, rq[i]);
                    ddy[i] = derivative(n_y, *d_y, t, rq[i]);
                }
            }
            _ if *undivided => {
                for i in 0..N {
                    out[i] = finish(plane.even(at, i));
                }
            }
            _ => {
                for i in 0..N {
                    out[i] = finish(plane.divided(at, i, rq[i]));
                }
            }
        }
        match derivatives {
            // (N_x - t 0) 1 is N_x.
            Some(true) => (*ddx, *ddy) = ([n_x.to_f32(); N], [n_y.to_f32(); N]),
            Some(false) if *undivided => {
                for i in 0..N {
                    let t = at.sum(&plane.n, i);
                    ddx[i] = derivative(n_x, *d_x, t, T::of(1.0));
                    ddy[i] = derivative(n_y, *d_y, t, T::of(1.0));
                }
            }
            _ => {}
        }
        all_finite(out, plane);
    }
}

/// 1 / D, or 1 / Q where the unit has a q. 1 / D is left for later stages that read it, or taken from an earlier one.
#[inline(always)]
fn divisors<const K: usize>(rw: &mut Lanes, unit: &Unit<'_, K>, at: impl Positions<LANES>, first: First) -> Lanes {
    if !unit.has_q && !first.computes {
        return *rw;
    }
    let mut rq = [1.0; LANES];
    if unit.has_q || !unit.planes.affine {
        rq = all_reciprocals(&LinearEval::new(&unit.divisor, None), at);
    }
    if !unit.has_q && first.leaves {
        *rw = rq;
    }
    rq
}

/// The same in `f64`; later units may find it in the batch.
#[inline(always)]
fn wide_divisors<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    at: impl Positions<LANES>,
    first: First,
) -> [f64; LANES] {
    let mut rq = [1.0; LANES];
    if unit.is_even() {
    } else if b.has_rw64 && !unit.has_q {
        rq = b.rw64;
    } else {
        rq = all_reciprocals(&LinearEval::<f64>::new(&unit.divisor, None), at);
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
            divisors(&mut b.rw, unit, at, first);
        }
    }
    rq
}

/// All lanes of a batch of one primitive.
#[inline(always)]
pub fn whole<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    at: impl Positions<LANES>,
    slots: &UnitSlots,
    first: First,
    derivatives: bool,
) {
    let even = unit.is_even();
    if even {
        b.tex.derivatives = Derivatives::Uniform;
    }
    let derivatives = derivatives.then_some(even);
    if unit.wide {
        let rq = wide_divisors(b, unit, at, first);
        for k in 0..K {
            let plane = PlaneEval::<f64>::new(&unit.coords[k], None);
            let d = [unit.divisor.x, unit.divisor.y];
            let of = Coordinate { plane, d, undivided: even, derivatives };
            let greatest = max_f32(unit.coords[k].max.abs(), unit.coords[k].min.abs());
            let period = f64::from(slots.period[k]);
            (b.tex.limit[k], b.tex.least[k]) = match slots.period[k] {
                0 => (greatest, unit.coords[k].min),
                period => {
                    let range = without_periods_range(greatest, f32::from(period));
                    (range.limit, range.least)
                }
            };
            let out = [&mut b.tex.coord[k], &mut b.tex.ddx[k], &mut b.tex.ddy[k]];
            match slots.period[k] {
                0 => of.write(at, &rq, |v| v as f32, out),
                1 => of.write(at, &rq, |v| without_periods(v, 1.0, 1.0) as f32, out),
                _ => of.write(at, &rq, |v| without_periods(v, period, 1.0 / period) as f32, out),
            }
        }
        return;
    }
    let undivided = unit.planes.affine && !unit.has_q;
    let rq = if undivided && !first.computes { [1.0; LANES] } else { divisors(&mut b.rw, unit, at, first) };
    for k in 0..K {
        let plane = PlaneEval::<f32>::new(&unit.coords[k], None);
        b.tex.limit[k] = max_f32(plane.max.abs(), plane.min.abs());
        b.tex.least[k] = plane.min;
        let d = [unit.divisor.x as f32, unit.divisor.y as f32];
        let out = [&mut b.tex.coord[k], &mut b.tex.ddx[k], &mut b.tex.ddy[k]];
        Coordinate { plane, d, undivided, derivatives }.write(at, &rq, |v| v, out);
    }
}

/// A coordinate of a piece, and its derivatives if they are needed. `d`: how D, or Q, changes in x and y.
#[inline(always)]
fn write_piece<T: Real>(
    b: &mut FragmentBatch,
    (k, piece): (usize, Piece),
    (plane, d): (&PlaneEval<T>, [T; 2]),
    (at, rq): (&Points<CHUNK>, &[T; CHUNK]),
    derivatives: bool,
    finish: impl Fn(T) -> f32,
) {
    let t = plane.offsets(at, rq);
    let mut out = [0.0; CHUNK];
    for i in 0..CHUNK {
        out[i] = finite(finish(plane.limited(t[i])));
    }
    put(&mut b.tex.coord[k], piece, &out);
    if derivatives {
        let mut out_y = [0.0; CHUNK];
        for i in 0..CHUNK {
            out[i] = derivative(plane.n.x, d[0], t[i], rq[i]);
            out_y[i] = derivative(plane.n.y, d[1], t[i], rq[i]);
        }
        put(&mut b.tex.ddx[k], piece, &out);
        put(&mut b.tex.ddy[k], piece, &out_y);
    }
}

/// A piece of a segment.
#[inline(always)]
fn piece_of_unit<const K: usize>(
    b: &mut FragmentBatch,
    unit: &Unit<'_, K>,
    slots: &UnitSlots,
    (first, derivatives): (First, bool),
    piece: Piece,
    at: &Points<CHUNK>,
) {
    if unit.wide {
        if first.leaves && !unit.has_q {
            reciprocals(&mut b.rw, unit.planes, true, piece, at);
        }
        let rq = all_reciprocals(&LinearEval::<f64>::new(&unit.divisor, None), at);
        for k in 0..K {
            let plane = PlaneEval::<f64>::new(&unit.coords[k], None);
            let d = [unit.divisor.x, unit.divisor.y];
            let period = f64::from(slots.period[k]);
            let inverse = if period > 0.0 { 1.0 / period } else { 0.0 };
            let finish = |v| without_periods(v, period, inverse) as f32;
            write_piece(b, (k, piece), (&plane, d), (at, &rq), derivatives, finish);
        }
        return;
    }
    let rq: Chunk = if unit.has_q {
        all_reciprocals(&LinearEval::new(&unit.divisor, None), at)
    } else {
        reciprocals(&mut b.rw, unit.planes, first.computes, piece, at)
    };
    for k in 0..K {
        let d = [unit.divisor.x as f32, unit.divisor.y as f32];
        let plane = PlaneEval::new(&unit.coords[k], None);
        write_piece(b, (k, piece), (&plane, d), (at, &rq), derivatives, |v| v);
    }
}

/// A piece of a segment whose primitive is in a group; those have no q.
#[inline(always)]
fn piece_of_member<const K: usize>(
    b: &mut FragmentBatch,
    planes: &Planes,
    (groups, member): (&[PlaneGroup; K], usize),
    (first, derivatives): (First, bool),
    piece: Piece,
    at: &Points<CHUNK>,
) {
    let rw = reciprocals(&mut b.rw, planes, first.computes, piece, at);
    for k in 0..K {
        let d = [planes.d.x as f32, planes.d.y as f32];
        let plane = PlaneEval::of_member(&groups[k], member);
        write_piece(b, (k, piece), (&plane, d), (at, &rw), derivatives, |v| v);
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
        && let Some(unit) = w.unit::<K>(&segment, slots, index)
    {
        if single_row(b) {
            let mut derivatives = derivatives;
            if let Some(Some(levels)) = u.levels.get(index as usize)
                && !unit.is_even()
            {
                let (x, y) = row_origin(&segment, unit.planes);
                let row = (x, y, segment.len);
                b.tex.derivatives = lod_bounds::of_row(&mut b.lookahead, index as usize, &b.tex, &unit, row, levels);
                derivatives &= b.tex.derivatives == Derivatives::PerLane;
            }
            whole(b, &unit, row_positions(&segment, unit.planes), slots, first, derivatives);
        } else {
            let at = all_positions(segments, (&b.dx, &b.dy), unit.planes);
            whole(b, &unit, &at, slots, first, derivatives);
        }
        return;
    }
    b.tex.limit = [f32::INFINITY; 3];
    b.tex.least = [f32::NEG_INFINITY; 3];
    let needs = (first, derivatives);
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        if let Some(planes) = w.planes.get(segment.prim as usize)
            && let Some(group) = w.group::<K>(planes, slots.base)
        {
            for piece in pieces(&segment) {
                let at = positions((&b.dx, &b.dy), &segment, planes, piece);
                piece_of_member(b, planes, group, needs, piece, &at);
            }
            continue;
        }
        let Some(unit) = w.unit::<K>(&segment, slots, index) else { continue };
        for piece in pieces(&segment) {
            let at = positions((&b.dx, &b.dy), &segment, unit.planes, piece);
            piece_of_unit(b, &unit, slots, needs, piece, &at);
        }
    }
}

stage! {
    /// The coordinates of one unit, and their derivatives where the sampler needs them.
    pub fn COORDINATES: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(Some(slots)) = u.layout.units.get(unit_of(arg)) else { return };
        match slots.count {
            1 => coordinates::<1>(b, u, w, slots, arg),
            2 => coordinates::<2>(b, u, w, slots, arg),
            _ => coordinates::<3>(b, u, w, slots, arg),
        }
    }
}
