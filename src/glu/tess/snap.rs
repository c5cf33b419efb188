//! Which cells an edge passes: the search of snap rounding.

use super::points::{Point, from_to, turn};

/// A leaf of the tree has at most this many nodes.
const LEAF: usize = 8;

/// A part of the tree: the box around its points, the first of them and the one behind the last, and its right half (its
/// left half is the next part); 0 for a leaf.
struct Part {
    low: Point,
    high: Point,
    first: usize,
    end: usize,
    right: usize,
}

/// Nodes, halved again and again along the longer side of the box around them.
pub(super) struct Cells<'a> {
    points: &'a [Point],
    order: Vec<u32>,
    parts: Vec<Part>,
}

impl<'a> Cells<'a> {
    /// The cells of all points.
    pub(super) fn new(points: &'a [Point]) -> Self {
        let mut cells = Self { points, order: (0..points.len() as u32).collect(), parts: Vec::new() };
        if !points.is_empty() {
            cells.halve(0, points.len());
        }
        cells
    }

    /// Builds the part for a range of the order. The depth is the logarithm of the number of points.
    fn halve(&mut self, first: usize, end: usize) -> usize {
        let (points, order) = (self.points, &mut self.order[first..end]);
        let (mut low, mut high) = ([i64::MAX; 2], [i64::MIN; 2]);
        for node in order.iter() {
            for i in 0..2 {
                low[i] = low[i].min(points[*node as usize][i]);
                high[i] = high[i].max(points[*node as usize][i]);
            }
        }
        let part = self.parts.len();
        self.parts.push(Part { low, high, first, end, right: 0 });
        if end - first > LEAF {
            let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
            let half = (end - first) / 2;
            order.select_nth_unstable_by_key(half, |node| (points[*node as usize][axis], *node));
            self.halve(first, first + half);
            self.parts[part].right = self.halve(first + half, end);
        }
        part
    }

    /// The nodes whose cells an edge passes, in order along it.
    pub(super) fn passed(&self, [a, b]: [Point; 2], found: &mut Vec<u32>) {
        found.clear();
        let mut open = if self.parts.is_empty() { vec![] } else { vec![0] };
        while let Some(part) = open.pop() {
            let Part { low, high, first, end, right } = self.parts[part];
            if !may_pass([a, b], [low.map(|c| c - 1), high.map(|c| c + 1)]) {
                continue;
            }
            if right == 0 {
                let here = self.order[first..end].iter().filter(|n| passes([a, b], self.points[**n as usize]));
                found.extend(here);
            } else {
                open.extend([part + 1, right]);
            }
        }
        // Along an edge neither coordinate of the cells ever turns back.
        let d = from_to(a, b);
        found.sort_unstable_by_key(|n| {
            let to = from_to(a, self.points[*n as usize]);
            d[0] * to[0] + d[1] * to[1]
        });
    }
}

/// Whether an edge may have points within a box: unless the box lies on one side of the edge, or of the box around it.
fn may_pass([a, b]: [Point; 2], [low, high]: [Point; 2]) -> bool {
    let beside = (0..2).any(|i| a[i].max(b[i]) < low[i] || a[i].min(b[i]) > high[i]);
    if beside {
        return false;
    }
    let corners = [low, [low[0], high[1]], high, [high[0], low[1]]].map(|c| turn(a, b, c).signum());
    !(corners.iter().all(|s| *s > 0) || corners.iter().all(|s| *s < 0))
}

/// Whether an edge passes the cell around a point of the grid: half a unit to each side, the lower sides included.
fn passes([a, b]: [Point; 2], cell: Point) -> bool {
    // A bound of the part of the edge, `.0 / .1` of its length, and whether the bound belongs to what it bounds.
    let (mut from, mut to) = ((0, 1, true), (1, 1, true));
    for i in 0..2 {
        // In halves of a unit: from -1, included, to 1, excluded.
        let (start, step) = (2 * (a[i] - cell[i]), 2 * (b[i] - a[i]));
        let (low, high) = match step {
            0 if (-1..1).contains(&start) => continue,
            0 => return false,
            1.. => ((-1 - start, step, true), (1 - start, step, false)),
            _ => ((start - 1, -step, false), (start + 1, -step, true)),
        };
        let order = |p: (i64, i64, bool), q: (i64, i64, bool)| (p.0 * q.1).cmp(&(q.0 * p.1));
        if order(low, from).is_gt() || order(low, from).is_eq() && !low.2 {
            from = low;
        }
        if order(high, to).is_lt() || order(high, to).is_eq() && !high.2 {
            to = high;
        }
        if order(from, to).is_gt() || order(from, to).is_eq() && !(from.2 && to.2) {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_has_its_lower_sides_and_not_its_upper_ones() {
        let rows = [
            ([[0, 0], [4, 2]], [2, 1], true),
            // Through (1, 1/2) and (3, 3/2): on the upper side of one cell, on the lower of the next.
            ([[0, 0], [4, 2]], [1, 1], true),
            ([[0, 0], [4, 2]], [1, 0], true),
            ([[0, 0], [4, 2]], [0, 1], false),
            ([[0, 0], [3, 3]], [0, 1], false),
            // Through (1/2, -1/2), a corner of four cells.
            ([[0, 0], [3, -3]], [1, 0], true),
            ([[0, 0], [3, -3]], [0, -1], false),
            ([[0, 0], [3, -3]], [1, -1], true),
            ([[0, 1], [1, 0]], [1, 1], true),
            ([[0, 1], [1, 0]], [0, 0], false),
            ([[0, 0], [0, 5]], [0, 5], true),
            ([[0, 0], [0, 5]], [1, 3], false),
            ([[0, 0], [0, 5]], [0, 6], false),
        ];
        for (edge, cell, expected) in rows {
            assert_eq!(passes(edge, cell), expected, "{edge:?} {cell:?}");
            assert_eq!(passes([edge[1], edge[0]], cell), expected, "{edge:?} {cell:?} backwards");
        }
    }

    #[test]
    fn the_tree_finds_what_every_cell_would() {
        let points: Vec<Point> = (0..900).map(|i| [i * i % 61, i * 7 % 59]).collect();
        let cells = Cells::new(&points);
        let mut found = Vec::new();
        for edge in points.windows(2).map(|w| [w[0], w[1]]) {
            cells.passed(edge, &mut found);
            let mut all: Vec<u32> = (0..900).filter(|n| passes(edge, points[*n as usize])).collect();
            let along = |n: &u32| from_to(edge[0], points[*n as usize]).map(i64::abs).iter().sum::<i64>();
            assert!(found.windows(2).all(|w| along(&w[0]) <= along(&w[1])));
            found.sort_unstable();
            all.sort_unstable();
            assert_eq!(found, all);
        }
    }
}
