//! Exact predicates on the grid. Coordinates are below 2^29 in magnitude plus a few, so a product of two differences is
//! below 2^61 and everything here is exact.

use std::cmp::Ordering;

/// A point of the grid. Points are ordered by x, then by y: the order in which a sweep meets them.
pub(super) type Point = [i64; 2];

/// The differences of coordinates are at most this.
pub(super) const MOST_CELLS: i64 = 1 << 29;

/// The vector from `a` to `b`.
pub(super) fn from_to(a: Point, b: Point) -> Point {
    [b[0] - a[0], b[1] - a[1]]
}

/// The cross product of two vectors.
pub(super) fn cross(a: Point, b: Point) -> i64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Twice the signed area of a triangle: more than 0 if `c` is to the left of the line from `a` to `b`.
pub(super) fn turn(a: Point, b: Point, c: Point) -> i64 {
    cross(from_to(a, b), from_to(a, c))
}

/// Where two lines meet: the parts `along[i] / of` of both from their first points, `of` more than 0.
pub(super) struct Meeting {
    pub(super) along: [i64; 2],
    pub(super) of: i64,
}

impl Meeting {
    /// The meeting of two lines that are not parallel.
    pub(super) fn of(a: [Point; 2], b: [Point; 2]) -> Self {
        let (da, db, between) = (from_to(a[0], a[1]), from_to(b[0], b[1]), from_to(a[0], b[0]));
        let (of, along) = (cross(da, db), [cross(between, db), cross(between, da)]);
        if of < 0 { Self { along: along.map(|t| -t), of: -of } } else { Self { along, of } }
    }

    /// Both parts as numbers from 0 to 1.
    pub(super) fn parts(&self) -> [f64; 2] {
        self.along.map(|t| t as f64 / self.of as f64)
    }
}

/// A point with rational coordinates: `whole + part / of`, `0 <= part < of`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spot {
    whole: Point,
    part: [i64; 2],
    of: i64,
}

impl Spot {
    /// A point of the grid.
    pub(super) fn on_grid(whole: Point) -> Self {
        Self { whole, part: [0, 0], of: 1 }
    }

    /// The point at the part `along / of` of an edge.
    pub(super) fn on_edge(edge: [Point; 2], along: i64, of: i64) -> Self {
        let step = from_to(edge[0], edge[1]).map(|d| i128::from(d) * i128::from(along));
        let whole = step.map(|s| s.div_euclid(i128::from(of)) as i64);
        let part = step.map(|s| s.rem_euclid(i128::from(of)) as i64);
        let whole = [edge[0][0] + whole[0], edge[0][1] + whole[1]];
        // One form for a point of the grid, so that equal points are equal.
        if part == [0, 0] { Self::on_grid(whole) } else { Self { whole, part, of } }
    }

    /// The nearest point of the grid; between two the greater. This never turns the order of two coordinates around.
    pub(super) fn rounded(&self) -> Point {
        let up = |i: usize| i64::from(2 * i128::from(self.part[i]) >= i128::from(self.of));
        [self.whole[0] + up(0), self.whole[1] + up(1)]
    }

    /// On which side of an edge the point is: `Greater` to the left, `Equal` on its line.
    pub(super) fn side_of(&self, edge: [Point; 2]) -> Ordering {
        let (d, to) = (from_to(edge[0], edge[1]), from_to(edge[0], self.whole));
        if self.of == 1 {
            return cross(d, to).cmp(&0);
        }
        let of = i128::from(self.of);
        let [x, y] = [0, 1].map(|i| i128::from(to[i]) * of + i128::from(self.part[i]));
        (i128::from(d[0]) * y).cmp(&(i128::from(d[1]) * x))
    }
}

impl Ord for Spot {
    fn cmp(&self, other: &Self) -> Ordering {
        let axis = |i: usize| {
            self.whole[i].cmp(&other.whole[i]).then_with(|| {
                let (a, b) = (i128::from(self.part[i]), i128::from(other.part[i]));
                (a * i128::from(other.of)).cmp(&(b * i128::from(self.of)))
            })
        };
        axis(0).then_with(|| axis(1))
    }
}

impl PartialOrd for Spot {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_between_cells_are_compared_exactly() {
        let far = MOST_CELLS;
        // Two crossings whose x differ by less than 2^-57.
        let m = Meeting::of([[0, 0], [far, far - 1]], [[0, 1], [far, far - 1 - 5]]);
        let n = Meeting::of([[0, 0], [far, far - 1]], [[0, 1], [far - 1, far - 2 - 5]]);
        let a = Spot::on_edge([[0, 0], [far, far - 1]], m.along[0], m.of);
        let b = Spot::on_edge([[0, 0], [far, far - 1]], n.along[0], n.of);
        assert_eq!(a.side_of([[0, 0], [far, far - 1]]), Ordering::Equal);
        assert_eq!(a.side_of([[0, 1], [far, far - 6]]), Ordering::Equal);
        assert_eq!(b.side_of([[0, 1], [far - 1, far - 7]]), Ordering::Equal);
        assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        assert_ne!(a, b);
    }

    #[test]
    fn the_same_point_of_two_edges_is_the_same_spot() {
        let (a, b) = ([[0, 0], [6, 4]], [[0, 4], [6, 0]]);
        let m = Meeting::of(a, b);
        let spots = [Spot::on_edge(a, m.along[0], m.of), Spot::on_edge(b, m.along[1], m.of), Spot::on_grid([3, 2])];
        assert!(spots.iter().all(|s| *s == spots[0]));
        let third = Spot::on_edge([[0, 0], [3, 3]], 1, 9);
        assert_eq!(third.rounded(), [0, 0]);
        assert_eq!(Spot::on_edge([[0, 0], [1, -1]], 1, 2).rounded(), [1, 0]);
        assert_eq!(third.cmp(&Spot::on_edge([[0, 0], [1, 1]], 1, 3)), Ordering::Equal);
    }
}
