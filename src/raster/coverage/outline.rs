//! Coverage of smooth lines and polygons (OpenGL 1.5, sections 3.4.2 and 3.5.6): the exact area of the part of a pixel
//! that lies in a convex outline. The outline is clipped to a row of pixels once; then a pixel's area is what lies between
//! its left and right side under the upper edges, less what lies there under the lower ones.
//!
//! ```text
//!        _______________________________   y + 1/2
//!       /  :       :       :       :   /
//!      /   :       :  x    :       :  /    the part of pixel x is between the dots to its left and right
//!     /____:_______:_______:_______:_/     y - 1/2
//! ```

use crate::num::floor_f64_to_int;
use crate::raster::state::Rect;

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
    pub(crate) fn new(origin: [i32; 2], corners: &[[f64; 2]], clip: Rect) -> Self {
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

    /// The part in a row of pixels.
    #[must_use]
    pub fn row(&self, y: i32) -> OutlineRow {
        let y = f64::from(y - self.origin[1]);
        let mut polygon = [[0.0; 2]; CORNERS];
        for (to, from) in polygon.iter_mut().zip(self.corner) {
            *to = [from[0], from[1] - y];
        }
        let mut count = self.count;
        for side in [0.5, -0.5] {
            (polygon, count) = cut(&polygon, count, side);
        }
        let mut row =
            OutlineRow { origin: self.origin[0], columns: (0, 0), edges: [SlopedEdge::default(); CORNERS], count: 0 };
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..count {
            let (p, q) = (polygon[i], polygon[next(i, count)]);
            (least, most) = (least.min(p[0]), most.max(p[0]));
            // There is no area under a vertical edge.
            if p[0] != q[0] {
                let slope = (q[1] - p[1]) / (q[0] - p[0]);
                row.edges[row.count] = SlopedEdge { x: [p[0], q[0]], y: p[1], slope };
                row.count += 1;
            }
        }
        if least < most {
            let column = |x: f64| self.origin[0].saturating_add(floor_f64_to_int(x + 0.5));
            let (first, last) = (column(least).max(self.rect.x0), column(most).saturating_add(1).min(self.rect.x1));
            row.columns = (first, last.max(first));
        }
        row
    }
}

/// Most corners of the part in a row: each of the row's two sides adds one to four.
const CORNERS: usize = 6;

/// The part of an outline that lies in a row of pixels.
#[derive(Clone, Copy, Debug)]
pub struct OutlineRow {
    /// The pixel whose centre is 0.
    origin: i32,
    /// The columns that may have coverage: pixels from the first to before the second.
    pub columns: (i32, i32),
    edges: [SlopedEdge; CORNERS],
    count: usize,
}

/// An edge that is not vertical.
#[derive(Clone, Copy, Debug, Default)]
struct SlopedEdge {
    /// Where it begins and ends.
    x: [f64; 2],
    /// Its height at the beginning, from the middle of the row.
    y: f64,
    slope: f64,
}

impl OutlineRow {
    /// The covered area of a pixel of the row, in [0, 1]; exactly 0 where the outline does not reach it.
    #[must_use]
    pub fn coverage(&self, x: i32) -> f32 {
        let x = f64::from(x - self.origin);
        let (left, right) = (x - 0.5, x + 0.5);
        let mut twice = 0.0;
        for SlopedEdge { x: [p, q], y, slope } in self.edges.iter().take(self.count) {
            let (a, b) = (p.max(left).min(right), q.max(left).min(right));
            twice += (b - a) * ((y + slope * (a - p)) + (y + slope * (b - p)));
        }
        (twice.abs() * 0.5).min(1.0) as f32
    }
}

/// The part of a polygon that lies on the row's side of a height: below 1/2, or above -1/2.
fn cut(polygon: &[[f64; 2]; CORNERS], count: usize, height: f64) -> ([[f64; 2]; CORNERS], usize) {
    let inside = |p: [f64; 2]| if height > 0.0 { height - p[1] } else { p[1] - height };
    let (mut out, mut n) = ([[0.0; 2]; CORNERS], 0);
    let mut put = |p: [f64; 2]| {
        if let Some(slot) = out.get_mut(n) {
            *slot = p;
            n += 1;
        }
    };
    for i in 0..count {
        let (p, q) = (polygon[i], polygon[next(i, count)]);
        let (dp, dq) = (inside(p), inside(q));
        if dp >= 0.0 {
            put(p);
        }
        if (dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0) {
            put([p[0] + dp / (dp - dq) * (q[0] - p[0]), height]);
        }
    }
    (out, n)
}

#[cfg(test)]
mod tests {
    use super::{Outline, Rect};
    use crate::raster::testing::Random;

    /// The area of a convex polygon within a pixel: cut by its four sides, one corner after the other.
    fn area(corners: &[[f64; 2]], x: i32, y: i32) -> f64 {
        let middle = [f64::from(x), f64::from(y)];
        let mut polygon: Vec<[f64; 2]> = corners.iter().map(|c| [c[0] - middle[0], c[1] - middle[1]]).collect();
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            let inside = |p: [f64; 2]| 0.5 - sign * p[axis];
            let mut cut = Vec::new();
            for (i, &p) in polygon.iter().enumerate() {
                let q = polygon[(i + 1) % polygon.len()];
                let (dp, dq) = (inside(p), inside(q));
                if dp >= 0.0 {
                    cut.push(p);
                }
                if dp * dq < 0.0 {
                    let t = dp / (dp - dq);
                    cut.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
                }
            }
            polygon = cut;
        }
        let cross = |(i, p): (usize, &[f64; 2])| {
            let q = polygon[(i + 1) % polygon.len()];
            p[0] * q[1] - q[0] * p[1]
        };
        polygon.iter().enumerate().map(cross).sum::<f64>().abs() * 0.5
    }

    fn compare(corners: &[[f64; 2]], what: &str) {
        let clip = Rect { x0: -20, y0: -20, x1: 20, y1: 20 };
        let outline = Outline::new([0, 0], corners, clip);
        for y in -20..20 {
            let row = outline.row(y);
            for x in -20..20 {
                let inside = (row.columns.0..row.columns.1).contains(&x);
                let (got, want) = (if inside { row.coverage(x) } else { 0.0 }, area(corners, x, y));
                assert!((f64::from(got) - want).abs() < 1e-7, "{what} at {x}, {y}: {got}, not {want}; {corners:?}");
                assert!(got <= 1.0 && (want > 1e-12 || got < 1e-12), "{what} at {x}, {y}: {got}, not {want}");
            }
        }
    }

    #[test]
    fn coverage_is_the_area_within_the_pixel() {
        let mut random = Random(41);
        for round in 0..400 {
            let grid = if round % 2 == 0 { 256.0 } else { 2.0 };
            let mut at = || [0; 2].map(|_| (random.between(-17.0, 17.0) * grid).round() / grid);
            let (mut a, b, c) = (at(), at(), at());
            let turn = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            compare(&if turn < 0.0 { [a, c, b] } else { [a, b, c] }, "triangle");
            // A line of width 1.5; some are upright, some lie flat.
            if round % 3 == 0 {
                a[round % 2] = b[round % 2];
            }
            let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt();
            if length > 0.0 {
                let n = [(a[1] - b[1]) / length * 0.75, (b[0] - a[0]) / length * 0.75];
                let of = |p: [f64; 2], side: f64| [p[0] + n[0] * side, p[1] + n[1] * side];
                compare(&[of(a, -1.0), of(b, -1.0), of(b, 1.0), of(a, 1.0)], "line");
            }
        }
    }

    #[test]
    fn whole_pixels_are_covered_wholly_and_neighbours_not_at_all() {
        let corners = [[-2.5, -1.5], [3.5, -1.5], [3.5, 2.5], [-2.5, 2.5]];
        let outline = Outline::new([0, 0], &corners, Rect { x0: -9, y0: -9, x1: 9, y1: 9 });
        for y in -9..9 {
            let row = outline.row(y);
            for x in row.columns.0..row.columns.1 {
                let inside = (-2..4).contains(&x) && (-1..3).contains(&y);
                assert_eq!(row.coverage(x), if inside { 1.0 } else { 0.0 }, "{x}, {y}");
            }
            assert!(row.columns.0 >= row.columns.1 || row.columns.0 <= -2 && row.columns.1 >= 4, "{:?}", row.columns);
        }
    }
}
