//! Rasterisation of triangles (OpenGL 1.5, sections 2.10, 3.5): the viewport, which fragments a triangle makes, and the
//! value of an associated datum at a fragment (equations 3.5 to 3.7), with its derivatives. Coverage follows the project's
//! rule: window positions are rounded to 1/256 pixel and the edges are exact integers; a centre on an edge belongs to the
//! triangle when the edge is a left one or a horizontal one with the triangle below it. Data are interpolated with the
//! positions as they are, not the rounded ones. Lines and points stand in `lines`.

#[path = "raster_lines.rs"]
pub mod lines;

use super::{V2, V4};

/// Viewport(x, y, w, h) and DepthRange(n, f).
#[derive(Clone, Copy, Debug)]
pub struct Viewport {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
    pub near: f64,
    pub far: f64,
}

impl Viewport {
    /// (0, 0, w, h) and depth range 0 to 1.
    pub fn whole(w: u32, h: u32) -> Viewport {
        Viewport { x: 0.0, y: 0.0, width: f64::from(w), height: f64::from(h), near: 0.0, far: 1.0 }
    }

    /// Clip coordinates to window coordinates (2.10.1), with 1/w beside them.
    pub fn window(&self, clip: V4) -> Window {
        let d = [clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3]];
        Window {
            x: self.width / 2.0 * d[0] + self.x + self.width / 2.0,
            y: self.height / 2.0 * d[1] + self.y + self.height / 2.0,
            z: (self.far - self.near) / 2.0 * d[2] + (self.near + self.far) / 2.0,
            inv_w: 1.0 / clip[3],
        }
    }
}

/// A vertex in window coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub inv_w: f64,
}

/// A window coordinate in units of 1/256 pixel.
pub fn snap(v: f64) -> i64 {
    (v * 256.0).round() as i64
}

/// The pixels whose centres a triangle of snapped positions covers, row by row. No centre is covered by two triangles
/// that share an edge, and none between them is left out.
pub fn coverage(tri: [[i64; 2]; 3]) -> Vec<[i64; 2]> {
    coverage_within(tri, [[i64::MIN, i64::MAX]; 2])
}

/// The same within a range of x and one of y (both ends included), so that what lies far out costs no time.
pub fn coverage_within(tri: [[i64; 2]; 3], window: [[i64; 2]; 2]) -> Vec<[i64; 2]> {
    let cross = |a: [i64; 2], b: [i64; 2], p: [i64; 2]| {
        i128::from(b[0] - a[0]) * i128::from(p[1] - a[1]) - i128::from(b[1] - a[1]) * i128::from(p[0] - a[0])
    };
    let area = cross(tri[0], tri[1], tri[2]);
    if area == 0 {
        return Vec::new();
    }
    let [a, b, c] = if area > 0 { tri } else { [tri[0], tri[2], tri[1]] };
    // Counterclockwise now: the inside is to the left of each edge.
    let inside = |from: [i64; 2], to: [i64; 2], p: [i64; 2]| {
        let left_edge = to[1] < from[1];
        let top_edge = to[1] == from[1] && to[0] < from[0];
        match cross(from, to, p) {
            0 => left_edge || top_edge,
            e => e > 0,
        }
    };
    let range = |k: usize| {
        let (lo, hi) = (tri.iter().map(|v| v[k]).min(), tri.iter().map(|v| v[k]).max());
        let (lo, hi) = ((lo.unwrap_or(0) - 128).div_euclid(256), (hi.unwrap_or(0) + 128).div_euclid(256));
        lo.max(window[k][0])..=hi.min(window[k][1])
    };
    let mut out = Vec::new();
    for y in range(1) {
        for x in range(0) {
            let p = [x * 256 + 128, y * 256 + 128];
            if inside(a, b, p) && inside(b, c, p) && inside(c, a, p) {
                out.push([x, y]);
            }
        }
    }
    out
}

/// A triangle in window coordinates, ready for interpolation.
#[derive(Clone, Copy, Debug)]
pub struct Triangle(pub [Window; 3]);

impl Triangle {
    /// Twice the signed area (equation 3.4, times 2): positive is counterclockwise.
    pub fn area2(&self) -> f64 {
        let [a, b, c] = self.0;
        (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
    }

    /// The positions in 1/256 pixel.
    pub fn snapped(&self) -> [[i64; 2]; 3] {
        self.0.map(|v| [snap(v.x), snap(v.y)])
    }

    /// Barycentric coordinates of a point (equation 3.5).
    pub fn barycentric(&self, x: f64, y: f64) -> [f64; 3] {
        let area = self.area2();
        std::array::from_fn(|i| {
            let (p, q) = (self.0[(i + 1) % 3], self.0[(i + 2) % 3]);
            ((p.x - x) * (q.y - y) - (p.y - y) * (q.x - x)) / area
        })
    }

    /// Their derivatives by x and by y: constants.
    pub fn barycentric_gradient(&self) -> [V2; 3] {
        let area = self.area2();
        std::array::from_fn(|i| {
            let (p, q) = (self.0[(i + 1) % 3], self.0[(i + 2) % 3]);
            [(p.y - q.y) / area, (q.x - p.x) / area]
        })
    }

    /// The distance of a point to the nearest of the three edges, in pixels (negative outside).
    pub fn edge_distance(&self, x: f64, y: f64) -> f64 {
        let area = self.area2().abs();
        let b = self.barycentric(x, y);
        let distance = |i: usize| {
            let (p, q) = (self.0[(i + 1) % 3], self.0[(i + 2) % 3]);
            b[i] * area / ((p.x - q.x).powi(2) + (p.y - q.y).powi(2)).sqrt()
        };
        distance(0).min(distance(1)).min(distance(2))
    }

    /// Equation 3.6: f = sum(b f / w) / sum(b q / w), and its derivatives by x and y. `q` is 1 for everything but s, t, r.
    pub fn interpolate(&self, at: V2, f: [f64; 3], q: [f64; 3]) -> (f64, V2) {
        let b = self.barycentric(at[0], at[1]);
        let g = self.barycentric_gradient();
        let w = self.0.map(|v| v.inv_w);
        let sum = |b: &dyn Fn(usize) -> f64, v: &[f64; 3]| (0..3).map(|i| b(i) * v[i] * w[i]).sum::<f64>();
        let (n, d) = (sum(&|i| b[i], &f), sum(&|i| b[i], &q));
        let slope = |k: usize| {
            let (dn, dd) = (sum(&|i| g[i][k], &f), sum(&|i| g[i][k], &q));
            (dn * d - n * dd) / (d * d)
        };
        (n / d, [slope(0), slope(1)])
    }

    /// Equation 3.7: depth is linear in window coordinates.
    pub fn depth(&self, at: V2) -> f64 {
        let b = self.barycentric(at[0], at[1]);
        (0..3).map(|i| b[i] * self.0[i].z).sum()
    }

    fn depth_slope(&self, k: usize) -> f64 {
        let g = self.barycentric_gradient();
        (0..3).map(|i| g[i][k] * self.0[i].z).sum()
    }

    /// The polygon offset (3.5.5): m factor + r units, m the steepest slope of depth.
    pub fn offset(&self, factor: f64, units: f64, r: f64) -> f64 {
        (self.depth_slope(0).powi(2) + self.depth_slope(1).powi(2)).sqrt() * factor + r * units
    }

    /// The same with the other m that the specification allows: the greater of the two slopes.
    pub fn offset_by_max(&self, factor: f64, units: f64) -> f64 {
        self.depth_slope(0).abs().max(self.depth_slope(1).abs()) * factor + units / f64::from((1 << 24) - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    fn window(x: f64, y: f64, z: f64, w: f64) -> Window {
        Window { x, y, z, inv_w: 1.0 / w }
    }

    #[test]
    fn the_viewport_maps_the_cube_to_the_window() {
        let v = Viewport { x: 10.0, y: 20.0, width: 100.0, height: 50.0, near: 0.25, far: 0.75 };
        let w = v.window([2.0, -2.0, 0.0, 2.0]);
        assert_near(&[w.x, w.y, w.z, w.inv_w], &[110.0, 20.0, 0.5, 0.5], 1e-15);
    }

    #[test]
    fn a_square_of_two_triangles_has_each_pixel_once() {
        // Corners on pixel centres: the hard case of the rule.
        let at = |x: i64, y: i64| [x * 256 + 128, y * 256 + 128];
        let (a, b, c, d) = (at(0, 0), at(4, 0), at(4, 4), at(0, 4));
        let mut hits = coverage([a, b, c]);
        hits.extend(coverage([a, d, c]));
        hits.sort_unstable();
        let once = hits.len();
        hits.dedup();
        assert_eq!((once, hits.len()), (16, 16));
        // Left and top edges are in, right and bottom ones are not.
        assert!(hits.contains(&[0, 4]) && !hits.contains(&[4, 4]) && !hits.contains(&[0, 0]));
    }

    #[test]
    fn small_triangles_and_lines_cover_what_they_should() {
        assert!(coverage([[0, 0], [1000, 1000], [2000, 2000]]).is_empty());
        assert!(coverage([[0, 0], [100, 0], [0, 100]]).is_empty());
        assert_eq!(coverage([[0, 0], [300, 0], [0, 300]]), vec![[0, 0]]);
        assert_eq!(coverage([[-512, -512], [0, -512], [-512, 0]]), vec![[-2, -2]]);
    }

    #[test]
    fn a_midpoint_in_perspective_is_that_worked_out_by_hand() {
        // w = 1 at the left, 3 at the right: halfway in the window, f = (0/1 + 1/3) / (1/1 + 1/3) = 1/4.
        let t = Triangle([window(0.0, 0.0, 0.0, 1.0), window(10.0, 0.0, 1.0, 3.0), window(0.0, 10.0, 0.0, 1.0)]);
        let (f, [dx, dy]) = t.interpolate([5.0, 0.0], [0.0, 1.0, 0.0], [1.0; 3]);
        assert_near(&[f], &[0.25], 1e-15);
        let step = 1e-6;
        let ahead = t.interpolate([5.0 + step, 0.0], [0.0, 1.0, 0.0], [1.0; 3]).0;
        let above = t.interpolate([5.0, step], [0.0, 1.0, 0.0], [1.0; 3]).0;
        assert_near(&[dx, dy], &[(ahead - f) / step, (above - f) / step], 1e-6);
        assert_near(&[t.depth([5.0, 0.0])], &[0.5], 1e-15);
        // q = 1, 2: (1/2 . 2/3) / (1/2 . 1 + 1/2 . 2/3) with f = q = 2 at the right corner.
        let (f, _) = t.interpolate([5.0, 0.0], [0.0, 2.0, 0.0], [1.0, 2.0, 1.0]);
        assert_near(&[f], &[0.4], 1e-15);
        assert_near(&[t.edge_distance(2.0, 1.0)], &[1.0], 1e-14);
        assert_near(&[t.offset(2.0, 3.0, 0.5)], &[0.2 + 1.5], 1e-14);
    }
}
