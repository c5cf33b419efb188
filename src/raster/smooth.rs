//! Coverage of smooth lines and polygons (OpenGL 1.5, sections 3.4.2 and 3.5.6): the exact area of the part of a pixel
//! that lies in a convex outline. A smooth line is a rectangle around the segment; stippling cuts it into shorter ones.

use super::geometry::{Context, Cover, Geometry, index};
use super::line::Segment;
use super::setup::{Triangle, relative_snapped};
use super::state::{Mode, Rect};
use crate::num::floor_f64_to_int;

/// A convex outline of three or four corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Pixels that may be touched.
    pub rect: Rect,
    /// The pixel whose centre the corners are relative to.
    pub origin: [i32; 2],
    /// Corners, counter-clockwise, in pixels.
    pub corner: [[f64; 2]; 4],
    /// How many corners there are.
    pub count: usize,
}

/// The corner after corner i.
fn next(i: usize, count: usize) -> usize {
    if i + 1 < count { i + 1 } else { 0 }
}

impl Outline {
    fn new(origin: [i32; 2], corners: &[[f64; 2]], clip: Rect) -> Self {
        let mut corner = [[0.0; 2]; 4];
        let count = corners.len().min(4);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (to, from) in corner.iter_mut().zip(corners) {
            *to = *from;
            for k in 0..2 {
                low[k] = low[k].min(from[k]);
                high[k] = high[k].max(from[k]);
            }
        }
        // Truncation and a pixel to spare on each side; pixels outside have coverage 0 and make no fragment.
        let first = |k: usize| origin[k].saturating_add(low[k] as i32).saturating_sub(2);
        let last = |k: usize| origin[k].saturating_add(high[k] as i32).saturating_add(3);
        let rect = Rect { x0: first(0), y0: first(1), x1: last(0), y1: last(1) }.and(clip);
        Self { rect, origin, corner, count }
    }

    /// The columns that a row may have coverage in: pixels from the first to before the second.
    #[must_use]
    pub fn columns(&self, y: i32) -> (i32, i32) {
        let middle = f64::from(y - self.origin[1]);
        let (low, high) = (middle - 0.5, middle + 0.5);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..self.count {
            let (p, q) = (self.corner[i], self.corner[next(i, self.count)]);
            let (below, above) = if p[1] <= q[1] { (p, q) } else { (q, p) };
            if above[1] < low || below[1] > high {
                continue;
            }
            let at = |y: f64| {
                let t = (y - below[1]) / (above[1] - below[1]);
                if t > 0.0 && t < 1.0 { below[0] + t * (above[0] - below[0]) } else { f64::NAN }
            };
            for x in
                [if below[1] >= low { below[0] } else { at(low) }, if above[1] <= high { above[0] } else { at(high) }]
            {
                least = least.min(x);
                most = most.max(x);
            }
        }
        if least > most {
            return (0, 0);
        }
        // A pixel reaches half a pixel to either side; a little is to spare for rounding.
        let first = self.origin[0].saturating_add(floor_f64_to_int(least + (0.5 - 1e-6)));
        let last = self.origin[0].saturating_add(floor_f64_to_int(most + (0.5 + 1e-6))).saturating_add(1);
        (first.max(self.rect.x0), last.min(self.rect.x1))
    }

    /// How much of a pixel is inside.
    #[must_use]
    pub fn coverage(&self, x: i32, y: i32) -> f32 {
        let (x, y) = (f64::from(x - self.origin[0]), f64::from(y - self.origin[1]));
        // The outline, cut by the four sides of the pixel one after the other.
        let mut polygon = [[0.0; 2]; 8];
        for (to, from) in polygon.iter_mut().zip(self.corner) {
            *to = [from[0] - x, from[1] - y];
        }
        let mut count = self.count;
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            let inside = polygon.iter().take(count).filter(|p| 0.5 - sign * p[axis] >= 0.0).count();
            if inside == 0 {
                return 0.0;
            }
            if inside < count {
                (polygon, count) = cut(&polygon, count, axis, sign);
            }
        }
        let mut twice = 0.0;
        for i in 0..count {
            let (p, q) = (polygon[i], polygon[next(i, count)]);
            twice += p[0] * q[1] - q[0] * p[1];
        }
        (twice.abs() * 0.5).min(1.0) as f32
    }
}

/// The part of a polygon where sign * coordinate <= 1/2.
fn cut(polygon: &[[f64; 2]; 8], count: usize, axis: usize, sign: f64) -> ([[f64; 2]; 8], usize) {
    let (mut out, mut n) = ([[0.0; 2]; 8], 0);
    let mut put = |p: [f64; 2]| {
        if let Some(slot) = out.get_mut(n) {
            *slot = p;
            n += 1;
        }
    };
    for i in 0..count {
        let (p, q) = (polygon[i], polygon[next(i, count)]);
        let (dp, dq) = (0.5 - sign * p[axis], 0.5 - sign * q[axis]);
        if dp >= 0.0 {
            put(p);
        }
        if (dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0) {
            let t = dp / (dp - dq);
            put([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    (out, n)
}

impl Geometry {
    /// Files a smooth filled triangle.
    pub(super) fn smooth_triangle(&mut self, cx: &Context, t: &Triangle, area: i64, back: bool) {
        if area == 0 {
            return;
        }
        let first = self.pool.len();
        let planes = self.triangle_planes(cx, t, area, back, Mode::Fill);
        let mut corners = t.v.map(|v| relative_snapped(v.head.snapped, planes.origin));
        if area < 0 {
            corners.swap(1, 2);
        }
        let outline = Outline::new(planes.origin, &corners, cx.rs.area);
        if outline.rect.is_empty() {
            self.pool.truncate(first);
            return;
        }
        self.outlines.push(outline);
        let cover = Cover::Outline(index(self.outlines.len() - 1));
        self.file(cover, cx.draw, planes, area.unsigned_abs() >> 17);
    }

    /// Files a smooth line: one rectangle, or one for each run of ones of the stipple.
    pub(super) fn smooth_line(&mut self, cx: &Context, s: &Segment, stipple: &mut u32) {
        let planes = self.line_planes(cx, s);
        let [a, b] = s.v.map(|v| relative_snapped(v.head.snapped, planes.origin));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = (dx * dx + dy * dy).sqrt();
        if length == 0.0 {
            self.pool.truncate(planes.first as usize);
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let half = f64::from(cx.rs.line_width) * 0.5;
        let (nx, ny) = (-uy * half, ux * half);
        let units = length.ceil() as u32;
        let mut rectangle = |from: f64, to: f64| {
            let at = |t: f64, side: f64| [a[0] + ux * t + nx * side, a[1] + uy * t + ny * side];
            let corners = [at(from, -1.0), at(to, -1.0), at(to, 1.0), at(from, 1.0)];
            let outline = Outline::new(planes.origin, &corners, cx.rs.clip);
            if !outline.rect.is_empty() {
                self.outlines.push(outline);
                let cover = Cover::Outline(index(self.outlines.len() - 1));
                self.file(cover, cx.draw, planes, ((to - from) * (2.0 * half + 2.0)) as u64 + 1);
            }
        };
        match cx.rs.line_stipple {
            None => rectangle(0.0, length),
            Some((pattern, factor)) => {
                let on = |unit: u32| (pattern >> ((stipple.wrapping_add(unit) / factor) & 15)) & 1 != 0;
                let mut unit = 0;
                while unit < units {
                    let first = unit;
                    while unit < units && on(unit) {
                        unit += 1;
                    }
                    if unit > first {
                        rectangle(f64::from(first), f64::from(unit).min(length));
                    }
                    while unit < units && !on(unit) {
                        unit += 1;
                    }
                }
            }
        }
        *stipple = stipple.wrapping_add(units);
    }
}
