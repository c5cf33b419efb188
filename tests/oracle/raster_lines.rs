//! Lines and points (OpenGL 1.5, sections 3.3 and 3.4), not antialiased. A line makes the fragments whose diamonds it
//! leaves (the "diamond exit" rule of 3.4.1), where both ends are moved by the tiny (-e, -e^2) of the specification; here
//! e is 2^-26 pixel and all arithmetic is exact in integers of 2^-52 pixel, good for windows up to 256 pixels.

/// 2^-52 pixel is 1: a position in 1/256 pixel times this.
const UNIT: i128 = 1 << 44;
const PIXEL: i128 = 1 << 52;
const E: i128 = 1 << 26;

/// Whether the closed segment a-b meets the open diamond around the centre `c` (positions in 2^-52 pixel).
fn meets_diamond(a: [i128; 2], b: [i128; 2], c: [i128; 2]) -> bool {
    let half = PIXEL / 2;
    // Separating axes of an open square turned by 45 degrees: x + y, x - y, and the line's own normal.
    let axis = |f: &dyn Fn([i128; 2]) -> i128| {
        let (p, q, m) = (f(a), f(b), f(c));
        p.max(q) <= m - half || p.min(q) >= m + half
    };
    if axis(&|v| v[0] + v[1]) || axis(&|v| v[0] - v[1]) {
        return false;
    }
    let d = [b[0] - a[0], b[1] - a[1]];
    if d == [0, 0] {
        return true;
    }
    let side = |p: [i128; 2]| d[0] * (p[1] - a[1]) - d[1] * (p[0] - a[0]);
    let corners = [[c[0] + half, c[1]], [c[0] - half, c[1]], [c[0], c[1] + half], [c[0], c[1] - half]].map(side);
    corners.iter().any(|&s| s > 0) && corners.iter().any(|&s| s < 0)
}

/// The fragments of a line of width 1 from `a` to `b` (positions in 1/256 pixel), in no particular order.
pub fn line(a: [i64; 2], b: [i64; 2]) -> Vec<[i64; 2]> {
    let moved = |p: [i64; 2]| [i128::from(p[0]) * UNIT - E, i128::from(p[1]) * UNIT - 1];
    let (pa, pb) = (moved(a), moved(b));
    let mut out = Vec::new();
    let range = |k: usize| (a[k].min(b[k]) / 256 - 1)..=(a[k].max(b[k]) / 256 + 1);
    for y in range(1) {
        for x in range(0) {
            let c = [i128::from(x) * PIXEL + PIXEL / 2, i128::from(y) * PIXEL + PIXEL / 2];
            if meets_diamond(pa, pb, c) && !meets_diamond(pb, pb, c) {
                out.push([x, y]);
            }
        }
    }
    out
}

/// A line of whole width `w`: the ends move by (w - 1) / 2 in the minor direction, and every fragment of the thin line
/// becomes a row (y-major) or a column (x-major) of `w` fragments that begins there.
pub fn wide_line(a: [i64; 2], b: [i64; 2], w: i64) -> Vec<[i64; 2]> {
    let x_major = (b[0] - a[0]).abs() >= (b[1] - a[1]).abs();
    let k = usize::from(x_major);
    let shift = |mut p: [i64; 2]| {
        p[k] -= (w - 1) * 128;
        p
    };
    let grow = |p: [i64; 2]| (0..w).map(move |i| if x_major { [p[0], p[1] + i] } else { [p[0] + i, p[1]] });
    line(shift(a), shift(b)).into_iter().flat_map(grow).collect()
}

/// Where a fragment centre lies along the line: t of equation 3.1.
pub fn parameter(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let d = [b[0] - a[0], b[1] - a[1]];
    ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1])
}

/// The fragments of a point of whole size `n`: a square around the pixel (odd) or the pixel corner (even) that is nearest.
pub fn point(x: f64, y: f64, n: i64) -> Vec<[i64; 2]> {
    let first = |v: f64| {
        if n % 2 == 1 { v.floor() as i64 - (n - 1) / 2 } else { (v + 0.5).floor() as i64 - n / 2 }
    };
    let (x0, y0) = (first(x), first(y));
    (0..n).flat_map(|j| (0..n).map(move |i| [x0 + i, y0 + j])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_horizontal_line_leaves_out_its_last_pixel() {
        let at = |x: i64, y: i64| [x * 256 + 128, y * 256 + 128];
        let mut l = line(at(1, 3), at(5, 3));
        l.sort_unstable();
        assert_eq!(l, vec![[1, 3], [2, 3], [3, 3], [4, 3]]);
        let mut back = line(at(5, 3), at(1, 3));
        back.sort_unstable();
        assert_eq!(back, vec![[2, 3], [3, 3], [4, 3], [5, 3]]);
        assert!(line(at(2, 2), at(2, 2)).is_empty());
    }

    #[test]
    fn connected_lines_share_no_pixel() {
        let points = [[130, 140], [1500, 700], [3200, 900], [5000, 600]];
        let mut all: Vec<_> = points.windows(2).flat_map(|w| line(w[0], w[1])).collect();
        let n = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(n, all.len());
    }

    #[test]
    fn a_diagonal_takes_one_pixel_a_step() {
        let l = line([128, 128], [128 + 10 * 256, 128 + 10 * 256]);
        assert_eq!(l.len(), 10);
        assert!(l.iter().all(|p| p[0] == p[1]));
        assert_eq!(wide_line([128, 128], [128 + 10 * 256, 200], 3).len(), 30);
    }

    #[test]
    fn points_are_squares() {
        assert_eq!(point(3.7, 5.2, 1), vec![[3, 5]]);
        assert_eq!(point(3.7, 5.2, 2), vec![[3, 4], [4, 4], [3, 5], [4, 5]]);
        assert_eq!(point(3.7, 5.2, 3)[0], [2, 4]);
        assert_eq!(parameter([0.0, 0.0], [10.0, 0.0], [2.5, 1.0]), 0.25);
    }
}
