//! Planes of interpolated values (OpenGL 1.5, sections 3.4.1, 3.5.1 and 3.8.2), set up in f64 from the unsnapped
//! positions. Every primitive becomes a [`Basis`]: three corners and the two linear functions b1, b2 that say how much of
//! corner 1 and 2 a pixel has (corner 0 has the rest); a line repeats its second corner with b2 = 0, a point has no
//! slopes at all. The formulas are those of [`crate::fragment::planes`]; all of them work on differences from corner 0,
//! so equal values give slopes of exactly 0 and equal w a denominator of exactly 1.

use crate::fragment::planes::{Layout, Linear, Plane, Planes, UnitSlots};

/// Bit of [`Planes::wide`]: the denominator itself, and with it colours and fog, needs f64.
pub const WIDE_DENOMINATOR: u32 = 1 << 8;

/// How a position relative to the origin becomes weights of the corners.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Basis {
    /// Weights of corners 1 and 2.
    pub b: [Linear; 2],
    /// The corners, in pixels from the centre of the origin pixel.
    pub corner: [[f64; 2]; 3],
}

impl Basis {
    /// The basis of a triangle; `det` is twice its area and not 0.
    #[inline]
    #[must_use]
    pub fn triangle(corner: [[f64; 2]; 3], det: f64) -> Self {
        let [[x0, y0], [x1, y1], [x2, y2]] = corner;
        let inv = 1.0 / det;
        let (ax, ay) = ((y2 - y0) * inv, (x0 - x2) * inv);
        let (bx, by) = ((y0 - y1) * inv, (x1 - x0) * inv);
        let line = |x: f64, y: f64| Linear { at: -(x0 * x + y0 * y), x, y };
        Self { b: [line(ax, ay), line(bx, by)], corner }
    }

    /// The basis of a line from a to b: the weight of b grows along the line and is constant across it.
    #[must_use]
    pub fn line(a: [f64; 2], b: [f64; 2]) -> Self {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let square = dx * dx + dy * dy;
        let (x, y) = if square > 0.0 { (dx / square, dy / square) } else { (0.0, 0.0) };
        Self { b: [Linear { at: -(a[0] * x + a[1] * y), x, y }, Linear::default()], corner: [a, b, b] }
    }

    /// The linear function that has these values at the corners.
    #[inline]
    #[must_use]
    pub fn linear(&self, f: [f64; 3]) -> Linear {
        let (g1, g2) = (f[1] - f[0], f[2] - f[0]);
        let [b1, b2] = &self.b;
        Linear { at: f[0] + (g1 * b1.at + g2 * b2.at), x: g1 * b1.x + g2 * b2.x, y: g1 * b1.y + g2 * b2.y }
    }
}

/// The layout of a draw, prepared for setup.
#[derive(Clone, Debug, Default)]
pub struct Recipe {
    layout: Layout,
    flat: bool,
    units: Vec<(u32, UnitSlots)>,
}

/// The values at the corners of a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Values<'a> {
    /// Slots of each corner.
    pub corner: [&'a [f32]; 3],
    /// Slots of the provoking vertex.
    pub provoking: &'a [f32],
    /// Whether the back-face colours are taken.
    pub back: bool,
    /// w of each corner.
    pub w: [f64; 3],
}

/// Basis and w together: the denominator, and the corners' parts of a numerator.
struct Weights {
    d: Linear,
    affine: bool,
    r: [f64; 3],
    b1: Linear,
    b2: Linear,
    /// 1 / D at the origin, or 0 where D is not of the size it has in the primitive.
    scale: f64,
}

impl Weights {
    fn new(basis: &Basis, w: [f64; 3]) -> Self {
        let [b1, b2] = basis.b;
        let least = w[0].min(w[1]).min(w[2]);
        let affine = (w[0] == w[1] && w[1] == w[2]) || !(least > 0.0 && w[0] + w[1] + w[2] < f64::INFINITY);
        if affine {
            let d = Linear { at: 1.0, x: 0.0, y: 0.0 };
            return Self { d, affine, r: [1.0; 3], b1, b2, scale: 1.0 };
        }
        let r = w.map(|w| least / w);
        let d = basis.linear(r);
        let far = r[0].min(r[1]).min(r[2]);
        let scale = if d.at >= 0.5 * far && d.at <= 2.0 { 1.0 / d.at } else { 0.0 };
        let times = |k: f64, b: Linear| Linear { at: k * b.at, x: k * b.x, y: k * b.y };
        Self { d, affine, r, b1: times(r[1], b1), b2: times(r[2], b2), scale }
    }

    /// The planes of a run of slots. One loop without branches on the values.
    #[inline]
    fn span(&self, f: [&[f32]; 3], out: &mut [Plane]) {
        let Self { d, b1, b2, scale, .. } = self;
        for (((&f0, &f1), &f2), plane) in f[0].iter().zip(f[1]).zip(f[2]).zip(out) {
            let base = f64::from(f0);
            let (g1, g2) = (f64::from(f1) - base, f64::from(f2) - base);
            let at = g1 * b1.at + g2 * b2.at;
            let x = g1 * b1.x + g2 * b2.x;
            let y = g1 * b1.y + g2 * b2.y;
            let low = if f1 < f0 { f1 } else { f0 };
            let min = if f2 < low { f2 } else { low };
            let high = if f1 > f0 { f1 } else { f0 };
            let max = if f2 > high { f2 } else { high };
            let here = (base + at * scale) as f32;
            let here = if here < min { min } else { here };
            let c = if here > max { max } else { here };
            let delta = f64::from(c) - base;
            let n = [at - delta * d.at, x - delta * d.x, y - delta * d.y];
            *plane = Plane { c, min, max, n0: n[0], nx: n[1], ny: n[2] };
            if !(n[0] + n[1] + n[2]).is_finite() {
                *plane = constant(if f0.is_finite() { f0 } else { 0.0 });
            }
        }
    }
}

/// The plane of a value that is the same everywhere.
const fn constant(c: f32) -> Plane {
    Plane { c, min: c, max: c, n0: 0.0, nx: 0.0, ny: 0.0 }
}

impl Recipe {
    /// Takes over what a draw's layout and shade model ask for.
    pub fn set(&mut self, layout: &Layout, flat: bool) {
        self.layout.clone_from(layout);
        self.flat = flat;
        self.units.clear();
        self.units.extend((0..).zip(&layout.units).filter_map(|(u, slots)| slots.map(|slots| (u, slots))));
    }

    /// Appends the planes of a primitive's slots to the pool and says the rest in `planes` (whose origin and z are the
    /// caller's). Slots that a vertex lacks become 0.
    pub fn planes(&self, basis: &Basis, values: &Values, planes: &mut Planes, pool: &mut Vec<Plane>) {
        let weights = Weights::new(basis, values.w);
        let first = pool.len();
        planes.first = u32::try_from(first).unwrap_or(u32::MAX);
        (planes.d, planes.affine, planes.wide) = (weights.d, weights.affine, 0);
        pool.resize(first + self.layout.count, Plane::default());
        let Some(out) = pool.get_mut(first..) else { return };
        weights.span(values.corner.map(|slots| slots.get(..self.layout.count).unwrap_or(&[])), out);
        self.colors(&weights, values, out);
        if !weights.affine && denominator_error(basis, &weights.d, weights.r) > 2048.0 {
            planes.wide |= WIDE_DENOMINATOR;
        }
        for (unit, slots) in &self.units {
            if self.unit(basis, &weights, slots, values, out) {
                planes.wide |= 1 << unit;
            }
        }
    }

    /// Colours once more where they are not simply those of the corners: flat shading, back faces.
    fn colors(&self, weights: &Weights, values: &Values, out: &mut [Plane]) {
        let back = if values.back { self.layout.back } else { None };
        if !self.flat && back.is_none() {
            return;
        }
        let primary = self.layout.color.map(|slot| (slot, back.unwrap_or(slot), 4));
        let after = if self.layout.color.is_some() { 4 } else { 0 };
        let secondary = self.layout.secondary.map(|slot| (slot, back.map_or(slot, |b| b + after), 3));
        for (to, from, n) in [primary, secondary].into_iter().flatten() {
            let take = |slots| {
                let slots: &[f32] = slots;
                slots.get(from..from + n).unwrap_or(&[])
            };
            let corners = if self.flat { [values.provoking; 3] } else { values.corner };
            if let Some(out) = out.get_mut(to..to + n) {
                weights.span(corners.map(take), out);
            }
        }
    }

    /// Coordinates of a unit: q, periods, and whether f64 is needed.
    fn unit(&self, basis: &Basis, weights: &Weights, slots: &UnitSlots, values: &Values, out: &mut [Plane]) -> bool {
        let UnitSlots { base, count, has_q, period, size, cube } = *slots;
        let Some(out) = out.get_mut(base..base + count + usize::from(has_q)) else { return false };
        let at = |corner: usize, k: usize| {
            let slots: &[f32] = values.corner.get(corner).copied().unwrap_or(&[]);
            f64::from(slots.get(base + k).copied().unwrap_or(0.0))
        };
        let (d, r) = if has_q {
            let q = [0, 1, 2].map(|i| at(i, count));
            projective(basis, weights, [0, 1, 2].map(|i| [at(i, 0), at(i, 1), at(i, 2)]), q, out)
        } else {
            (weights.d, weights.r)
        };
        let denominator = if has_q || !weights.affine { denominator_error(basis, &d, r) } else { 0.0 };
        let mut error = 0.0f64;
        let mut greatest = 0.0f64;
        for (plane, (period, size)) in out.iter_mut().take(count).zip(period.into_iter().zip(size)) {
            let spread = f64::from(plane.max) - f64::from(plane.min);
            let texels = if cube { f64::from(size) * 0.5 } else { f64::from(size) };
            let part = texels * (numerator_error(basis, plane, r) + denominator * spread);
            error = error.max(part);
            greatest = greatest.max(f64::from(plane.max).abs()).max(f64::from(plane.min).abs());
            take_period_off(plane, period);
        }
        if cube && greatest > 0.0 {
            error /= greatest;
        }
        // An f32 evaluation is off by about 2^-23 of the terms it adds; 2^-11 texel is what may be lost.
        !(error <= 4096.0)
    }
}

/// Takes whole periods off a plane, so that its values are near 0.
fn take_period_off(plane: &mut Plane, period: u8) {
    let c = f64::from(plane.c);
    let whole = match period {
        1 => c.floor(),
        2 => (c * 0.5).floor() * 2.0,
        _ => return,
    };
    plane.c = (c - whole) as f32;
    plane.min = (f64::from(plane.min) - whole) as f32;
    plane.max = (f64::from(plane.max) - whole) as f32;
}

/// How large, against the value at the corners, the terms of a denominator become.
fn denominator_error(basis: &Basis, d: &Linear, r: [f64; 3]) -> f64 {
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
    let big = basis.linear(rq);
    let greatest = rq[0].abs().max(rq[1].abs()).max(rq[2].abs());
    let least = rq[0].abs().min(rq[1].abs()).min(rq[2].abs());
    let one_sign = rq.iter().all(|q| *q > 0.0) || rq.iter().all(|q| *q < 0.0);
    let healthy = one_sign && big.at.abs() >= 0.5 * least && big.at.abs() <= 2.0 * greatest;
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
        let here = if at[0] == at[1] && at[1] == at[2] || !healthy { at[0] } else { (s.at / big.at) as f32 };
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
        let ok = (big.at + big.x + big.y).is_finite();
        let q = if ok { big } else { Linear { at: 1.0, x: 0.0, y: 0.0 } };
        *plane = Plane { c: 0.0, min: f32::MIN, max: f32::MAX, n0: q.at, nx: q.x, ny: q.y };
    }
    (big, rq)
}
