//! The arrangement of edges: edges that cross are cut at a new point, edges that go through a point are cut there, edges
//! that lie on each other become one with the sum of their windings, until edges meet at their ends only.
//!
//! One round is a sweep with exact crossings (Bentley and Ottmann's): it finds all places where edges have to be cut, in
//! O((n + k) log n) for n edges and k crossings. A crossing is rounded to the grid, which moves its edges a little and may
//! make them cross others, so rounds are repeated until one finds nothing. Mostly the second does. The third, if there is
//! one, also cuts every edge at all nodes whose cells it passes (snap rounding): edges moved so cross no other (Guibas and
//! Marimont, "Rounding arrangements dynamically", 1998), so the fourth finds nothing.

use super::ordered::Ordered;
use super::points::{Meeting, Point, Spot, cross, from_to, turn};
use super::snap::Cells;
use std::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashMap};

/// More places than this where edges cross in one round are too many to keep.
const MOST_CUTS: usize = 1 << 20;

/// For each of these places edges may have so many more pieces.
const PIECES: usize = 4;

/// From this round on edges are cut at all nodes whose cells they pass.
const SNAPS: usize = 3;

/// No more rounds than this are needed.
const MOST_ROUNDS: usize = SNAPS + 1;

/// An edge between two nodes, `lo` before `hi`. Going up through it, the winding number grows by `winding`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edge {
    pub(super) lo: u32,
    pub(super) hi: u32,
    pub(super) winding: i64,
}

/// A new node: where two edges crossed, as the part of each from its `lo` to its `hi`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) edges: [[u32; 2]; 2],
    pub(super) parts: [f64; 2],
}

/// There are more crossings than can be kept.
#[derive(Debug)]
pub(super) struct TooMany;

/// Nodes, and edges that meet only there.
pub(super) struct Arrangement {
    /// Nodes: those that were given, then the new ones.
    pub(super) points: Vec<Point>,
    /// How the new ones came to be, in order; they speak of nodes with smaller numbers.
    pub(super) crossings: Vec<Crossing>,
    /// The edges.
    pub(super) edges: Vec<Edge>,
    /// The winding number just below each edge.
    pub(super) below: Vec<i64>,
    /// How many sweeps it took.
    pub(super) rounds: usize,
}

/// Arranges edges. Nodes lie at different points.
pub(super) fn arrange(points: Vec<Point>, edges: Vec<Edge>) -> Result<Arrangement, TooMany> {
    arrange_within(MOST_CUTS, points, edges)
}

/// Arranges edges, if they do not cross in more places than so many.
pub(super) fn arrange_within(most: usize, points: Vec<Point>, edges: Vec<Edge>) -> Result<Arrangement, TooMany> {
    let most_edges = edges.len() + PIECES * most;
    let mut all = Arrangement { points, crossings: Vec::new(), edges, below: Vec::new(), rounds: 0 };
    let mut nodes: Option<HashMap<Point, u32>> = None;
    while all.rounds < MOST_ROUNDS {
        all.rounds += 1;
        all.edges = join(&all.points, &all.edges);
        let found = Round::new(&all, most).sweep()?;
        all.below = found.below;
        if found.cuts.is_empty() {
            return Ok(all);
        }
        let nodes = nodes.get_or_insert_with(|| (0..).zip(&all.points).map(|(i, p)| (*p, i)).collect());
        let mut pieces = Vec::new();
        for cut in found.cuts {
            let node = match cut.at {
                At::Node(node) => node,
                At::Crossing(point, crossing) => *nodes.entry(point).or_insert_with(|| {
                    all.points.push(point);
                    all.crossings.push(crossing);
                    all.points.len() as u32 - 1
                }),
            };
            pieces.extend(cut.edges.iter().map(|e| (*e, node)));
            if all.edges.len() + pieces.len() > most_edges {
                return Err(TooMany);
            }
        }
        if all.rounds >= SNAPS {
            pieces.clear();
            let (cells, mut passed) = (Cells::new(&all.points), Vec::new());
            for (i, edge) in (0..).zip(&all.edges) {
                cells.passed([edge.lo, edge.hi].map(|n| all.points[n as usize]), &mut passed);
                pieces.extend(passed.iter().map(|node| (i, *node)));
                if all.edges.len() + pieces.len() > 3 * most_edges {
                    return Err(TooMany);
                }
            }
        }
        all.edges = split(&all.points, &all.edges, pieces);
    }
    Err(TooMany)
}

/// The edge between two nodes that adds `winding` on its left side when it is gone along from `a` to `b`.
pub(super) fn directed(points: &[Point], a: u32, b: u32, winding: i64) -> Edge {
    if points[a as usize] < points[b as usize] {
        Edge { lo: a, hi: b, winding }
    } else {
        Edge { lo: b, hi: a, winding: -winding }
    }
}

/// Cuts edges at nodes. The nodes of an edge come in order.
fn split(points: &[Point], edges: &[Edge], mut cuts: Vec<(u32, u32)>) -> Vec<Edge> {
    cuts.sort_by_key(|(edge, _)| *edge);
    let mut pieces = Vec::with_capacity(edges.len() + cuts.len());
    let mut cuts = cuts.into_iter().peekable();
    for (i, edge) in (0..).zip(edges) {
        let mut from = edge.lo;
        while let Some((_, node)) = cuts.next_if(|(e, _)| *e == i) {
            if node != from && node != edge.hi {
                pieces.push(directed(points, from, node, edge.winding));
                from = node;
            }
        }
        pieces.push(directed(points, from, edge.hi, edge.winding));
    }
    pieces
}

/// Joins edges that lie on each other, whole or in part. Those whose windings cancel disappear.
fn join(points: &[Point], edges: &[Edge]) -> Vec<Edge> {
    let ends = |e: &Edge| [points[e.lo as usize], points[e.hi as usize]];
    // The line of an edge, the same numbers for all edges on it.
    let line = |e: &Edge| {
        let [lo, hi] = ends(e);
        let d = from_to(lo, hi);
        let common = gcd(d[0], d[1]);
        let d = d.map(|c| c / common);
        (d, cross(d, lo))
    };
    let mut lines: Vec<_> = edges.iter().map(|e| (line(e), ends(e), *e)).collect();
    lines.sort_unstable_by_key(|(line, ends, e)| (*line, *ends, e.lo, e.winding));
    let mut joined = Vec::with_capacity(edges.len());
    let mut marks = Vec::new();
    for group in lines.chunk_by(|a, b| a.0 == b.0) {
        if let [(_, _, edge)] = group {
            joined.push(*edge);
            continue;
        }
        marks.clear();
        for (_, [lo, hi], edge) in group {
            marks.extend([(*lo, edge.lo, edge.winding), (*hi, edge.hi, -edge.winding)]);
        }
        marks.sort_unstable();
        let (mut from, mut winding) = (marks[0].1, 0);
        for (_, node, step) in &marks {
            if *node != from && winding != 0 {
                joined.push(Edge { lo: from, hi: *node, winding });
            }
            (from, winding) = (*node, winding + step);
        }
    }
    joined.retain(|e| e.winding != 0);
    joined
}

/// The greatest common divisor of two numbers, not both 0.
fn gcd(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// Nodes in the order of a sweep, each with the edges that begin there.
pub(super) struct Starts {
    nodes: Vec<u32>,
    first: Vec<u32>,
    edges: Vec<u32>,
}

impl Starts {
    /// The nodes that are an end of an edge.
    pub(super) fn new(points: &[Point], edges: &[Edge]) -> Self {
        let mut first = vec![0; points.len() + 1];
        let mut used = vec![false; points.len()];
        for e in edges {
            first[e.lo as usize + 1] += 1;
            used[e.lo as usize] = true;
            used[e.hi as usize] = true;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut next = first.clone();
        let mut sorted = vec![0; edges.len()];
        for (i, e) in (0..).zip(edges) {
            let place = &mut next[e.lo as usize];
            sorted[*place as usize] = i;
            *place += 1;
        }
        let mut nodes: Vec<u32> = (0..points.len() as u32).filter(|n| used[*n as usize]).collect();
        nodes.sort_unstable_by_key(|n| points[*n as usize]);
        Self { nodes, first, edges: sorted }
    }

    /// The nodes in order.
    pub(super) fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// The edges that begin at a node.
    pub(super) fn at(&self, node: u32) -> &[u32] {
        &self.edges[self.first[node as usize] as usize..self.first[node as usize + 1] as usize]
    }
}

/// A place where edges are to be cut.
struct Cut {
    at: At,
    edges: Vec<u32>,
}

enum At {
    Node(u32),
    Crossing(Point, Crossing),
}

/// What a sweep finds.
struct Found {
    cuts: Vec<Cut>,
    below: Vec<i64>,
}

/// One sweep.
struct Round<'a> {
    points: &'a [Point],
    edges: &'a [Edge],
    active: Ordered,
    ahead: BinaryHeap<Reverse<Spot>>,
    asked: usize,
    most: usize,
    found: Found,
}

impl<'a> Round<'a> {
    fn new(all: &'a Arrangement, most: usize) -> Self {
        let found = Found { cuts: Vec::new(), below: vec![0; all.edges.len()] };
        let (active, ahead) = (Ordered::default(), BinaryHeap::new());
        Self { points: &all.points, edges: &all.edges, active, ahead, asked: 0, most, found }
    }

    fn ends(&self, edge: u32) -> [Point; 2] {
        let e = &self.edges[edge as usize];
        [self.points[e.lo as usize], self.points[e.hi as usize]]
    }

    fn sweep(mut self) -> Result<Found, TooMany> {
        let starts = Starts::new(self.points, self.edges);
        let mut nodes = starts.nodes().iter().copied().peekable();
        loop {
            let node_spot = nodes.peek().map(|n| Spot::on_grid(self.points[*n as usize]));
            let crossing = self.ahead.peek().map(|r| r.0);
            let Some(spot) = node_spot.into_iter().chain(crossing).min() else { break };
            while self.ahead.peek().is_some_and(|r| r.0 == spot) {
                self.ahead.pop();
            }
            let node = nodes.next_if(|_| node_spot == Some(spot));
            self.visit(spot, node, node.map_or(&[], |n| starts.at(n)))?;
        }
        debug_assert!(self.active.is_empty());
        Ok(self.found)
    }

    /// What the sweep does at one spot.
    fn visit(&mut self, spot: Spot, node: Option<u32>, starts: &[u32]) -> Result<(), TooMany> {
        let from = self.active.place(|e| spot.side_of(self.ends(e)) == Ordering::Greater);
        let to = self.active.place(|e| spot.side_of(self.ends(e)) != Ordering::Less);
        let (below, above) = (self.active.before(from), self.active.after(to));
        let mut here = Vec::new();
        self.active.between(from, to, &mut here);
        here.retain(|e| Some(self.edges[*e as usize].hi) != node);
        if !here.is_empty() {
            self.cut(spot, node, here.clone())?;
        }
        here.extend_from_slice(starts);
        // From the lowest to the highest behind the spot. No two have the same direction: `join` saw to that.
        here.sort_unstable_by(|a, b| {
            let [a, b] = [a, b].map(|e| self.ends(*e)).map(|[lo, hi]| from_to(lo, hi));
            0.cmp(&cross(a, b))
        });
        let mut winding = below.map_or(0, |e| self.found.below[e as usize] + self.edges[e as usize].winding);
        for e in &here {
            self.found.below[*e as usize] = winding;
            winding += self.edges[*e as usize].winding;
        }
        self.active.replace(from, to, &here);
        match (here.first(), here.last()) {
            (Some(lowest), Some(highest)) => {
                self.look(below, Some(*lowest))?;
                self.look(Some(*highest), above)
            }
            _ => self.look(below, above),
        }
    }

    /// Notes that edges go through a spot.
    fn cut(&mut self, spot: Spot, node: Option<u32>, edges: Vec<u32>) -> Result<(), TooMany> {
        let at = match node {
            Some(node) => At::Node(node),
            None => {
                let pair = [edges[0], edges[edges.len() - 1]];
                let [a, b] = pair.map(|e| self.ends(e));
                let ends = pair.map(|e| self.edges[e as usize]).map(|e| [e.lo, e.hi]);
                At::Crossing(spot.rounded(), Crossing { edges: ends, parts: Meeting::of(a, b).parts() })
            }
        };
        self.found.cuts.push(Cut { at, edges });
        if self.found.cuts.len() > self.most { Err(TooMany) } else { Ok(()) }
    }

    /// Looks whether two neighbours, the lower first, cross ahead. (Where one only touches the other, it ends there.)
    fn look(&mut self, lower: Option<u32>, upper: Option<u32>) -> Result<(), TooMany> {
        let Some((lower, upper)) = lower.zip(upper) else { return Ok(()) };
        let (a, b) = (self.ends(lower), self.ends(upper));
        if turn(a[0], a[1], b[1]) < 0 && turn(b[0], b[1], a[1]) > 0 {
            let meeting = Meeting::of(a, b);
            self.ahead.push(Reverse(Spot::on_edge(a, meeting.along[0], meeting.of)));
            self.asked += 1;
            if self.asked > PIECES * self.most {
                return Err(TooMany);
            }
        }
        Ok(())
    }
}
