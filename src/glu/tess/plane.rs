//! From space to the grid: which way the polygon faces, its projection along that normal, and the size of a cell.

use super::points::{MOST_CELLS, Point};

/// How points of space become points of a plane, seen so that the normal points to the eye.
struct Projection {
    /// The axis along which the normal is longest, which is dropped.
    dropped: usize,
    /// How far the others move for a step along it.
    lean: [f64; 2],
    /// Whether the second axis of the plane is turned around.
    mirrored: bool,
}

impl Projection {
    /// The projection along a normal.
    fn along(normal: [f64; 3]) -> Self {
        let dropped = longest(normal.map(f64::abs));
        let lean = [1, 2].map(|i| normal[(dropped + i) % 3] / normal[dropped]);
        Self { dropped, lean, mirrored: normal[dropped] < 0.0 }
    }

    fn of(&self, p: [f64; 3]) -> [f64; 2] {
        let [u, v] = [0, 1].map(|i| p[(self.dropped + 1 + i) % 3] - self.lean[i] * p[self.dropped]);
        [u, if self.mirrored { -v } else { v }]
    }
}

/// The greatest of three numbers, of equal ones the last.
fn longest(v: [f64; 3]) -> usize {
    [1, 0].into_iter().fold(2, |best, i| if v[i] > v[best] { i } else { best })
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// A normal of the plane through points: the two that are farthest apart along an axis, and the one that makes the largest
/// triangle with them. Its longest coordinate is positive.
fn normal_of(points: &[[f64; 3]]) -> [f64; 3] {
    let nowhere = [0.0, 0.0, 1.0];
    let Some(first) = points.first() else { return nowhere };
    let (mut low, mut high) = ([*first; 3], [*first; 3]);
    for p in points {
        for i in 0..3 {
            if p[i] < low[i][i] {
                low[i] = *p;
            }
            if p[i] > high[i][i] {
                high[i] = *p;
            }
        }
    }
    let extent = [0, 1, 2].map(|i| high[i][i] - low[i][i]);
    let axis = longest(extent);
    let size = extent[axis];
    if size == 0.0 {
        return nowhere;
    }
    // Differences in units of the extent: their products cannot overflow.
    let base = low[axis];
    let a = minus(high[axis], base).map(|c| c / size);
    let (mut normal, mut most) = ([0.0; 3], 0.0);
    for p in points {
        let b = minus(*p, base).map(|c| c / size);
        let n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        if length > most {
            (normal, most) = (n, length);
        }
    }
    if most == 0.0 {
        // All on a line: there is nothing inside. Any direction across will do.
        normal[longest(a.map(|c| -c.abs()))] = 1.0;
    }
    let turned = normal[longest(normal.map(f64::abs))] < 0.0;
    normal.map(|c| if turned { -c } else { c })
}

/// The smallest power of two that is greater than a number, at least the smallest normal number.
fn power_above(v: f64) -> f64 {
    let bits = v.max(f64::MIN_POSITIVE).to_bits();
    f64::from_bits(((bits >> 52) + 1) << 52)
}

/// Points of space as points of the grid. A `normal` of zero asks for one that is computed, such that the contours, which
/// end at the indices `contours`, have an area of at least 0 together. A cell is so small that the polygon has 2^28 of them
/// across, or the largest power of two within `tolerance` times the largest coordinate. Cells are powers of two and begin at
/// a multiple of their size: where coordinates are such numbers, nothing moves.
pub(super) fn to_grid(points: &[[f64; 3]], contours: &[usize], normal: [f64; 3], tolerance: f64) -> Vec<Point> {
    let given = normal != [0.0; 3] && normal.iter().all(|c| c.is_finite());
    let projection = Projection::along(if given { normal } else { normal_of(points) });
    let flat: Vec<[f64; 2]> = points.iter().map(|p| projection.of(*p)).collect();
    let range = [0, 1].map(|i| {
        let first = flat.first().map_or(0.0, |p| p[i]);
        flat.iter().fold([first; 2], |[low, high], p| [low.min(p[i]), high.max(p[i])])
    });
    let extent = range.iter().fold(0.0, |e: f64, [low, high]| e.max(high - low));
    let largest = points.iter().flatten().fold(0.0, |m: f64, c| m.max(c.abs()));
    let cell = power_above(extent / MOST_CELLS as f64).max(power_above(tolerance * largest) / 2.0);
    let origin = range.map(|[low, high]| {
        let middle = low / 2.0 + high / 2.0;
        let on_cell = (middle / cell).round() * cell;
        if on_cell.is_finite() { on_cell } else { middle }
    });
    let most = MOST_CELLS as f64;
    let index = |p: &[f64; 2]| [0, 1].map(|i| ((p[i] - origin[i]) / cell).round().max(-most).min(most) as i64);
    let mut grid: Vec<Point> = flat.iter().map(index).collect();
    if !given && area(&grid, contours) < 0 {
        for p in &mut grid {
            p[1] = -p[1];
        }
    }
    grid
}

/// Twice the area that contours enclose together, counter-clockwise positive.
fn area(grid: &[Point], contours: &[usize]) -> i128 {
    let (mut sum, mut first) = (0, 0);
    for &end in contours {
        let contour = &grid[first..end];
        for (a, b) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            sum += i128::from(a[0]) * i128::from(b[1]) - i128::from(a[1]) * i128::from(b[0]);
        }
        first = end;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle, counter-clockwise seen from where the normal points to.
    const TILTED: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn the_eye_is_where_the_normal_points_to() {
        for (normal, positive) in
            [([1.0, 1.0, 1.0], true), ([-1.0, -1.0, -1.0], false), ([0.1, 0.2, 3.0], true), ([-5.0, 1.0, 1.0], false)]
        {
            let grid = to_grid(&TILTED, &[3], normal, 0.0);
            assert_eq!(area(&grid, &[3]) > 0, positive, "{normal:?}");
        }
    }

    #[test]
    fn without_a_normal_the_area_is_positive() {
        for order in [[0, 1, 2], [2, 1, 0]] {
            let points = order.map(|i| TILTED[i]);
            for scale in [1.0, 1e-300, 1e150, -3.0] {
                let grid = to_grid(&points.map(|p| p.map(|c| c * scale)), &[3], [0.0; 3], 0.0);
                assert!(area(&grid, &[3]) > 1 << 50, "{order:?} {scale}");
            }
        }
    }

    #[test]
    fn whole_numbers_stay_where_they_are() {
        let points: Vec<[f64; 3]> = (0..20).map(|i| [f64::from(i * 7 % 20), f64::from(i * 3 % 20), 5.0]).collect();
        let grid = to_grid(&points, &[20], [0.0, 0.0, 1.0], 0.0);
        let unit = (grid[1][0] - grid[0][0]) / 7;
        for (g, p) in grid.iter().zip(&points) {
            assert_eq!([g[0] - grid[0][0], g[1] - grid[0][1]], [p[0] as i64 * unit, p[1] as i64 * unit]);
        }
    }

    #[test]
    fn what_is_far_out_small_flat_or_a_point_has_its_cells() {
        let rows: [&[[f64; 3]]; 5] = [
            &[[1e150; 3], [-1e150; 3], [1e150, -1e150, 0.0]],
            &[[1e150, 0.0, 0.0], [1e150, 1e-300, 0.0], [1e150, 0.0, 1e-300]],
            &[[5e-324, 0.0, 0.0], [0.0, 5e-324, 0.0], [0.0; 3]],
            &[[3.0; 3], [3.0; 3]],
            &[],
        ];
        for points in rows {
            let grid = to_grid(points, &[points.len()], [0.0; 3], 0.0);
            assert!(grid.iter().flatten().all(|c| c.abs() <= MOST_CELLS), "{points:?}");
        }
    }

    #[test]
    fn tolerance_makes_cells_larger() {
        let points = [[0.0, 0.0, 0.0], [8.0, 0.4, 0.0], [8.0, 0.6, 0.0], [0.0, 8.0, 0.0]];
        let grid = to_grid(&points, &[4], [0.0, 0.0, 1.0], 0.25);
        // A quarter of 8 is 2: cells of 2 by 2.
        assert_eq!(grid[1], grid[2]);
        assert_eq!(grid[1][0] - grid[0][0], 4);
    }
}
