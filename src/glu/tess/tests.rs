//! The arrangement and its triangles on grids so coarse that every crossing is moved: what is exact must stay exact.

use super::WindingRule;
use super::arrange::{Arrangement, Edge, arrange, arrange_within, directed};
use super::loops::loops;
use super::monotone::{Border, triangles};
use super::points::{Point, Spot, turn};
use super::polygon::borders;
use std::cmp::Ordering;
use std::collections::HashMap;

struct Random(u64);

impl Random {
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as i64 % n
    }
}

/// Nodes and edges of closed ways through points.
fn graph(contours: &[Vec<Point>]) -> (Vec<Point>, Vec<Edge>) {
    let (mut points, mut at, mut ways) = (Vec::new(), HashMap::new(), Vec::new());
    for contour in contours {
        let nodes: Vec<u32> = contour
            .iter()
            .map(|p| {
                *at.entry(*p).or_insert_with(|| {
                    points.push(*p);
                    points.len() as u32 - 1
                })
            })
            .collect();
        ways.extend((0..nodes.len()).map(|i| [nodes[i], nodes[(i + 1) % nodes.len()]]));
    }
    let edges = ways.iter().filter(|[a, b]| a != b).map(|[a, b]| directed(&points, *a, *b, 1)).collect();
    (points, edges)
}

fn ends(all: &Arrangement, e: &Edge) -> [Point; 2] {
    [all.points[e.lo as usize], all.points[e.hi as usize]]
}

/// Whether two edges have a point in common that is not an end of both.
fn meet(a: [Point; 2], b: [Point; 2]) -> bool {
    let on = |e: [Point; 2], p: Point| turn(e[0], e[1], p) == 0 && e[0] < p && p < e[1];
    let apart = |e: [Point; 2], f: [Point; 2]| turn(e[0], e[1], f[0]).signum() * turn(e[0], e[1], f[1]).signum() < 0;
    a == b || b.iter().any(|p| on(a, *p)) || a.iter().any(|p| on(b, *p)) || apart(a, b) && apart(b, a)
}

/// Twice the area to the left of borders.
fn enclosed(all: &Arrangement, borders: &[Border]) -> i64 {
    let way = |b: &Border| if b.inside_above { [b.lo, b.hi] } else { [b.hi, b.lo] };
    borders.iter().map(way).map(|w| w.map(|n| all.points[n as usize])).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum()
}

/// Everything that has to hold of an arrangement and what is made of it.
fn examine(all: &Arrangement, rule: WindingRule) {
    for (i, e) in all.edges.iter().enumerate() {
        assert!(ends(all, e)[0] < ends(all, e)[1] && e.winding != 0);
        for f in &all.edges[..i] {
            assert!(!meet(ends(all, e), ends(all, f)), "{:?} {:?}", ends(all, e), ends(all, f));
        }
        // The winding number just below the middle: the edges below it, and those that it ends or begins with do not count.
        let [lo, hi] = ends(all, e);
        let middle = Spot::on_edge([lo, hi], 1, 2);
        let spans = |f: &Edge| Spot::on_grid(ends(all, f)[0]) < middle && middle < Spot::on_grid(ends(all, f)[1]);
        let under = all.edges.iter().filter(|f| spans(f) && middle.side_of(ends(all, f)) == Ordering::Greater);
        assert_eq!(all.below[i], under.map(|f| f.winding).sum::<i64>());
    }
    let borders = borders(all, rule);
    let found = triangles(&all.points, &borders);
    let mut sides = HashMap::new();
    let mut area = 0;
    for t in &found {
        let [a, b, c] = t.nodes.map(|n| all.points[n as usize]);
        assert!(turn(a, b, c) > 0);
        area += turn(a, b, c);
        for i in 0..3 {
            let before = sides.insert([t.nodes[i], t.nodes[(i + 1) % 3]], t.boundary[i]);
            assert!(before.is_none(), "two triangles on one side of an edge");
        }
    }
    assert_eq!(area, enclosed(all, &borders));
    let inner = sides.iter().filter(|(_, boundary)| !**boundary);
    assert!(inner.clone().all(|([a, b], _)| sides.get(&[*b, *a]) == Some(&false)), "a diagonal has two sides");
    let mut flagged: Vec<_> = sides.iter().filter(|(_, boundary)| **boundary).map(|(side, _)| *side).collect();
    let way = |b: &Border| if b.inside_above { [b.lo, b.hi] } else { [b.hi, b.lo] };
    let mut expected: Vec<_> = borders.iter().map(way).collect();
    let around = loops(&all.points, &borders);
    let mut looped: Vec<_> = around.iter().flat_map(|l| (0..l.len()).map(|i| [l[i], l[(i + 1) % l.len()]])).collect();
    for sides in [&mut flagged, &mut expected, &mut looped] {
        sides.sort_unstable();
    }
    assert_eq!(flagged, expected);
    assert_eq!(looped, expected);
}

const RULES: [WindingRule; 5] =
    [WindingRule::Odd, WindingRule::Nonzero, WindingRule::Positive, WindingRule::Negative, WindingRule::AbsGeqTwo];

#[test]
fn on_a_coarse_grid_edges_meet_only_at_their_ends_and_triangles_fill_the_inside() {
    let (mut r, mut rounds) = (Random(5), [0; 5]);
    for set in 0..1500 {
        let size = [3, 5, 8, 12, 20, 60, 400][r.below(7) as usize];
        let contours: Vec<Vec<Point>> = (0..1 + r.below(3))
            .map(|_| (0..r.below(if size < 20 { 10 } else { 18 })).map(|_| [r.below(size), r.below(size)]).collect())
            .collect();
        let (points, edges) = graph(&contours);
        let all = arrange(points, edges).expect("few crossings");
        rounds[all.rounds] += 1;
        examine(&all, RULES[set % 5]);
    }
    println!("sets by rounds: {rounds:?}");
    assert!(rounds[4] > 0, "the last round was not needed");
}

#[test]
fn edges_on_each_other_are_one_with_the_sum_of_their_windings() {
    // Twice from 0 to 8, back over a part, in three pieces: what lies on a line only leaves nothing.
    let contours = [vec![[0, 0], [8, 4], [2, 1], [6, 3]], vec![[4, 2], [0, 0]]];
    let (points, edges) = graph(&contours);
    let all = arrange(points, edges).expect("no crossing");
    assert!(all.edges.is_empty() && all.crossings.is_empty());
    // The same square three times: each edge once, winding 3.
    let square = vec![[0, 0], [4, 0], [4, 4], [0, 4]];
    let (points, edges) = graph(&[square.clone(), square.clone(), square]);
    let all = arrange(points, edges).expect("no crossing");
    assert_eq!((all.edges.len(), all.rounds), (4, 1));
    assert!(all.edges.iter().all(|e| e.winding.abs() == 3));
    examine(&all, WindingRule::AbsGeqTwo);
}

#[test]
fn edges_through_one_point_get_one_node() {
    let star: Vec<Vec<Point>> = [[9, 0], [9, 3], [9, 9], [5, 9], [0, 9], [-4, 9]]
        .iter()
        .map(|[x, y]| vec![[-*x, -*y], [*x, *y], [*x + 1, *y + 1]])
        .collect();
    let (points, edges) = graph(&star);
    let all = arrange(points, edges).expect("few crossings");
    let middle = all.points.iter().filter(|p| **p == [0, 0]).count();
    assert_eq!(middle, 1);
    examine(&all, WindingRule::Odd);
}

#[test]
fn too_many_crossings_are_refused() {
    // 12 by 12 lines cross in 144 places, the ways back in more.
    let across = (0..12).flat_map(|i| [[-1, 2 * i], [48, 2 * i + 1]]).collect();
    let up = (0..12).flat_map(|i| [[2 * i, -1], [2 * i + 1, 48]]).collect();
    let (points, edges) = graph(&[across, up]);
    assert!(arrange_within(100, points.clone(), edges.clone()).is_err());
    examine(&arrange(points, edges).expect("few crossings"), WindingRule::Odd);
}
