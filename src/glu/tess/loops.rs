//! The boundary of what lies inside as loops, the inside to the left. Where several boundaries meet at a node each goes
//! on around the inside that it came along, so loops touch there and do not cross.

use super::monotone::Border;
use super::points::{Point, cross, from_to};
use std::cmp::Ordering;

/// The nodes of each loop in order.
pub(super) fn loops(points: &[Point], borders: &[Border]) -> Vec<Vec<u32>> {
    // The way along an edge that has the inside to the left.
    let way = |b: &Border| if b.inside_above { [b.lo, b.hi] } else { [b.hi, b.lo] };
    let mut ends: Vec<(u32, u32)> = Vec::with_capacity(2 * borders.len());
    for (i, b) in (0..).zip(borders) {
        ends.extend([(b.lo, i), (b.hi, i)]);
    }
    ends.sort_unstable();
    let mut next = vec![0u32; borders.len()];
    for here in ends.chunk_by_mut(|a, b| a.0 == b.0) {
        let node = here[0].0;
        let direction = |edge: u32| {
            let b = &borders[edge as usize];
            let other = if b.lo == node { b.hi } else { b.lo };
            from_to(points[node as usize], points[other as usize])
        };
        here.sort_unstable_by(|a, b| around(direction(a.1), direction(b.1)));
        // Counter-clockwise around the node, the inside lies before each edge that comes in and behind each that goes out.
        for i in 0..here.len() {
            let (edge, before) = (here[i].1, here[(i + here.len() - 1) % here.len()].1);
            if way(&borders[edge as usize])[1] == node {
                next[edge as usize] = before;
            }
        }
    }
    let mut done = vec![false; borders.len()];
    let mut found = Vec::new();
    for first in 0..borders.len() {
        let (mut edge, mut nodes) = (first, Vec::new());
        while !done[edge] {
            done[edge] = true;
            nodes.push(way(&borders[edge])[0]);
            edge = next[edge] as usize;
        }
        if !nodes.is_empty() {
            found.push(nodes);
        }
    }
    found
}

/// The order of directions counter-clockwise, from just behind straight down.
fn around(a: Point, b: Point) -> Ordering {
    let left = |d: Point| d < [0, 0];
    left(a).cmp(&left(b)).then_with(|| 0.cmp(&cross(a, b)))
}
