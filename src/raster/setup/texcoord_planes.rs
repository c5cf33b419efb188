//! Planes of texture coordinates (OpenGL 1.5, sections 3.5.1 and 3.8.8): q in place of w, whole periods subtracted, and
//! whether f32 is precise enough to evaluate them.

use super::basis::{Basis, CornerValues, constant};
use super::weights::Weights;
use crate::fragment::planes::{Linear, Plane, UnitSlots};
use crate::num::round_f64;

/// Completes the planes of a unit's coordinates: q and periods. Returns whether they need f64, as those of all units without
/// q do where `wide_w` says that w does.
#[inline]
pub(super) fn unit_planes(
    basis: &Basis,
    weights: &Weights,
    slots: &UnitSlots,
    values: &CornerValues,
    wide_w: bool,
    out: &mut [Plane],
) -> bool {
    let UnitSlots { base, count, has_q, period, size, cube } = *slots;
    let Some(out) = out.get_mut(base..base + count + usize::from(has_q)) else { return false };
    let d = weights.d;
    if has_q {
        if corners_q(slots, values) != [1.0; 3] {
            return projective_unit(basis, weights, slots, values, out);
        }
        // Where q is 1 the planes are those of a unit without q, to the last bit.
        if let Some(plane) = out.get_mut(count) {
            *plane = Plane { c: 0.0, min: f32::MIN, max: f32::MAX, n0: d.at, nx: d.x, ny: d.y };
        }
    }
    let denominator = if weights.affine { 0.0 } else { weights.bound(d.at, d.x, d.y) };
    let (mut error, mut greatest) = (0.0f64, if cube { 0.0f64 } else { 1.0 });
    for (plane, size) in out.iter().take(count).zip(size) {
        let spread = f64::from(plane.max) - f64::from(plane.min);
        let terms = weights.bound(plane.n0, plane.nx, plane.ny) + denominator * spread;
        let terms = terms * f64::from(size);
        error = if terms > error { terms } else { error };
        if cube {
            greatest = greatest.max(f64::from(plane.max).abs()).max(f64::from(plane.min).abs());
        }
    }
    // Most primitives are far from the limit, which a bound without divisions shows.
    let narrow = error <= LIMIT * weights.far * greatest;
    let wide = wide_w || (!narrow && wide(basis, slots, &d, weights.r, weights.affine, out));
    for (plane, period) in out.iter_mut().zip(period).take(count) {
        subtract_periods(plane, period);
    }
    wide
}

/// An f32 evaluation is off by about 2^-23 of the terms it adds, in texels; 2^-11 texel is what may be lost.
pub(crate) const LIMIT: f64 = 4096.0;

/// A unit's q at the corners.
fn corners_q(slots: &UnitSlots, values: &CornerValues) -> [f64; 3] {
    values.corner.map(|corner| f64::from(corner.get(slots.base + slots.count).copied().unwrap_or(0.0)))
}

/// Coordinates of a unit with q.
fn projective_unit(
    basis: &Basis,
    weights: &Weights,
    slots: &UnitSlots,
    values: &CornerValues,
    out: &mut [Plane],
) -> bool {
    let UnitSlots { base, count, period, .. } = *slots;
    let at = |corner: usize, k: usize| {
        let slots: &[f32] = values.corner.get(corner).copied().unwrap_or(&[]);
        f64::from(slots.get(base + k).copied().unwrap_or(0.0))
    };
    let q = corners_q(slots, values);
    let (d, r) = projective(basis, weights, [0, 1, 2].map(|i| [at(i, 0), at(i, 1), at(i, 2)]), q, out);
    let wide = wide(basis, slots, &d, r, false, out);
    for (plane, period) in out.iter_mut().zip(period).take(count) {
        subtract_periods(plane, period);
    }
    wide
}

/// Whether f32 is not enough at one of the corners, where quotients of linear functions have their extremes.
fn wide(basis: &Basis, slots: &UnitSlots, d: &Linear, r: [f64; 3], affine: bool, out: &[Plane]) -> bool {
    let denominator = if affine { 0.0 } else { denominator_error(basis, d, r) };
    let (mut error, mut greatest) = (0.0f64, 0.0f64);
    for (plane, size) in out.iter().take(slots.count).zip(slots.size) {
        let spread = f64::from(plane.max) - f64::from(plane.min);
        let texels = if slots.cube { f64::from(size) * 0.5 } else { f64::from(size) };
        error = error.max(texels * (numerator_error(basis, plane, r) + denominator * spread));
        greatest = greatest.max(f64::from(plane.max).abs()).max(f64::from(plane.min).abs());
    }
    if slots.cube && greatest > 0.0 {
        error /= greatest;
    }
    error.is_nan() || error > LIMIT
}

/// The largest whole number that is not above a number that came from an f32.
#[inline(always)]
fn floor(x: f64) -> f64 {
    if x.abs() >= 16_777_216.0 {
        // Floats from 2^24 on are whole, and even.
        return x;
    }
    let r = round_f64(x);
    r - if r > x { 1.0 } else { 0.0 }
}

/// The whole periods to be subtracted from a value, which is then in 0..period, or below 0 by less than f32 can tell from a
/// whole period.
#[inline(always)]
pub(crate) fn whole_periods(c: f64, period: u8) -> f64 {
    let (whole, one) = match period {
        0 => return 0.0,
        1 => (floor(c), 1.0),
        _ if c.abs() >= 16_777_216.0 => return c,
        _ => (floor(c * 0.5) * 2.0, 2.0),
    };
    // What is just below 0 would be rounded to a period, which is the texture's other end.
    if (c - whole) as f32 >= one as f32 { whole + one } else { whole }
}

/// Subtracts whole periods from a plane, so that its values are near 0.
#[inline(always)]
fn subtract_periods(plane: &mut Plane, period: u8) {
    let whole = whole_periods(f64::from(plane.c), period);
    if whole != 0.0 {
        plane.c = (f64::from(plane.c) - whole) as f32;
        plane.min = (f64::from(plane.min) - whole) as f32;
        plane.max = (f64::from(plane.max) - whole) as f32;
    }
}

/// How large, against the value at the corners, the terms of a denominator become.
pub(crate) fn denominator_error(basis: &Basis, d: &Linear, r: [f64; 3]) -> f64 {
    terms(basis, d.at, d.x, d.y, r)
}

/// How large the terms of a numerator become after the division.
fn numerator_error(basis: &Basis, plane: &Plane, r: [f64; 3]) -> f64 {
    terms(basis, plane.n0, plane.nx, plane.ny, r)
}

fn terms(basis: &Basis, at: f64, x: f64, y: f64, r: [f64; 3]) -> f64 {
    let mut most = 0.0f64;
    for (p, r) in basis.corner.iter().zip(r) {
        most = most.max((at.abs() + (x * p[0]).abs() + (y * p[1]).abs()) / r.abs());
    }
    most
}

/// The planes of a unit whose q is not 1: Q in place of D. Returns Q and its values at the corners.
fn projective(
    basis: &Basis,
    weights: &Weights,
    s: [[f64; 3]; 3],
    q: [f64; 3],
    out: &mut [Plane],
) -> (Linear, [f64; 3]) {
    let r = weights.r;
    let rq = [r[0] * q[0], r[1] * q[1], r[2] * q[2]];
    let q_plane = basis.linear(rq);
    let greatest = rq[0].abs().max(rq[1].abs()).max(rq[2].abs());
    let least = rq[0].abs().min(rq[1].abs()).min(rq[2].abs());
    let one_sign = rq.iter().all(|q| *q > 0.0) || rq.iter().all(|q| *q < 0.0);
    let well_defined = one_sign && q_plane.at.abs() >= 0.5 * least && q_plane.at.abs() <= 2.0 * greatest;
    // Where q changes its sign the reference is the corner with the greatest q: the s/q of one near 0 would be so large that
    // the others' digits get lost.
    let reference = (0..3).fold(0, |best, i: usize| if rq[i].abs() > rq[best].abs() { i } else { best });
    let count = out.len().saturating_sub(1);
    for (k, plane) in out.iter_mut().enumerate().take(count.min(3)) {
        let values = [0, 1, 2].map(|i: usize| s.get(i).and_then(|s| s.get(k)).copied().unwrap_or(0.0));
        let quotient = |i: usize| {
            let (s, q) = (values.get(i).copied().unwrap_or(0.0), q.get(i).copied().unwrap_or(0.0));
            if q == 0.0 { 0.0 } else { (s / q) as f32 }
        };
        let at = [quotient(0), quotient(1), quotient(2)];
        let mut min = at[0].min(at[1]).min(at[2]);
        let mut max = at[0].max(at[1]).max(at[2]);
        let s = basis.linear([r[0] * values[0], r[1] * values[1], r[2] * values[2]]);
        let here =
            if at[0] == at[1] && at[1] == at[2] || !well_defined { at[reference] } else { (s.at / q_plane.at) as f32 };
        let here = if here < min { min } else { here };
        let mut c = if here > max { max } else { here };
        if !c.is_finite() {
            c = 0.0;
        }
        if !(one_sign && min.is_finite() && max.is_finite()) {
            (min, max) = (f32::MIN, f32::MAX);
        }
        let wide = f64::from(c);
        let n = |i: usize| {
            let (s, q) = (values.get(i).copied().unwrap_or(0.0), q.get(i).copied().unwrap_or(0.0));
            r.get(i).copied().unwrap_or(0.0) * (s - wide * q)
        };
        let n = basis.linear([n(0), n(1), n(2)]);
        *plane = if (n.at + n.x + n.y).is_finite() {
            Plane { c, min, max, n0: n.at, nx: n.x, ny: n.y }
        } else {
            constant(c)
        };
    }
    if let Some(plane) = out.get_mut(count) {
        let ok = (q_plane.at + q_plane.x + q_plane.y).is_finite();
        let q = if ok { q_plane } else { Linear { at: 1.0, x: 0.0, y: 0.0 } };
        *plane = Plane { c: 0.0, min: f32::MIN, max: f32::MAX, n0: q.at, nx: q.x, ny: q.y };
    }
    (q_plane, rq)
}

#[cfg(test)]
mod tests {
    use crate::fragment::planes::{Layout, UnitSlots};
    use crate::raster::setup::planes::tests::planes;
    use crate::raster::testing::value;

    fn unit(has_q: bool, period: u8, size: u32) -> Layout {
        let slots = UnitSlots { base: 0, count: 2, has_q, period: [period; 3], size: [size; 3], cube: false };
        let mut layout = Layout { count: 2 + usize::from(has_q), ..Layout::default() };
        layout.units[3] = Some(slots);
        layout.stride = layout.count;
        layout
    }

    #[test]
    fn whole_periods_are_subtracted() {
        let s = 1_000_003.0f32;
        let values = [vec![s, 0.25], vec![s + 2.0, 0.5], vec![s, 0.75]];
        for (period, off) in [(0, 0.0), (1, 1_000_003.0), (2, 1_000_002.0)] {
            let (of, pool) = planes(&unit(false, period, 64), false, &values, [1.0; 3], false);
            let at = |x, y| value(&pool[0], &of, x, y);
            assert!((f64::from(at(5.5, -2.5)) - (f64::from(s) + 2.0 - off)).abs() <= 1.0, "{period}");
            assert!(period == 0 || (pool[0].c >= 0.0 && pool[0].c < f32::from(period)), "{:?}", pool[0]);
            assert_eq!(of.wide, 0);
        }
    }

    #[test]
    fn q_divides_and_odd_q_stays_finite() {
        let layout = unit(true, 0, 64);
        let q = [1.0f32, 2.0, 4.0];
        let values = [0, 1, 2].map(|i: usize| vec![i as f32 * q[i], 3.0 * q[i], q[i]]);
        let (of, pool) = planes(&layout, false, &values, [1.0, 3.0, 0.5], false);
        for (i, (x, y)) in [(-2.5, -2.5), (5.5, -2.5), (-2.5, 5.5)].into_iter().enumerate() {
            let [s, t, q] = [0, 1, 2].map(|k: usize| pool[k].n0 + pool[k].nx * x + pool[k].ny * y);
            assert!((f64::from(pool[0].c) + s / q - i as f64).abs() < 1e-6);
            assert!((f64::from(pool[1].c) + t / q - 3.0).abs() < 1e-6);
        }
        assert_eq!((pool[1].min, pool[1].max), (3.0, 3.0));
        // Q where q is 1 is D, to the last bit.
        let ones = [0.0f32, 1.0, 2.0].map(|i| vec![i, -i, 1.0]);
        let (of_ones, pool) = planes(&layout, false, &ones, [1.0, 3.0, 0.5], false);
        assert_eq!(of_ones.d, of.d);
        assert_eq!([pool[2].n0, pool[2].nx, pool[2].ny], [of.d.at, of.d.x, of.d.y]);
        for bad in [[0.0, 0.0, 0.0], [1.0, -1.0, 1.0], [f32::NAN, 1.0, 1.0], [f32::INFINITY; 3], [-1.0, -2.0, -0.5]] {
            let values = [0, 1, 2].map(|i: usize| vec![i as f32, 1e30, bad[i]]);
            let (_, pool) = planes(&layout, false, &values, [1.0, 3.0, 0.5], false);
            for plane in &pool {
                let all =
                    [plane.n0, plane.nx, plane.ny, f64::from(plane.c), f64::from(plane.min), f64::from(plane.max)];
                assert!(all.iter().all(|v| v.is_finite()), "{bad:?} {plane:?}");
            }
        }
    }

    #[test]
    fn wide_primitives_are_found() {
        let values = |range: f32| [vec![0.0, 0.0], vec![range, 0.0], vec![0.0, range]];
        let wide =
            |range: f32, size: u32, w: [f64; 3]| planes(&unit(false, 1, size), false, &values(range), w, false).0.wide;
        assert_eq!(wide(1.0, 1024, [1.0; 3]), 0);
        assert_eq!(wide(40.0, 1024, [1.0; 3]), 8);
        assert_eq!(wide(1.0, 64, [1.0, 2.0, 1.5]), 0);
        assert_eq!(wide(1.0, 64, [1.0, 1e6, 1e6]) & 8, 8);
    }
}
