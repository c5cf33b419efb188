//! Triangles of what lies inside: a sweep cuts the inside into polygons that are monotone in the order of the sweep, and
//! each of them is cut into triangles while its vertices come in.
//!
//! Between two neighbouring edges of the boundary lies a gap, inside or outside in turn. An inner gap has a polygon that
//! is still open to the right, kept with the edge below the gap; after a node at which two polygons met and no edge
//! begins it has two, until the next node in the gap is joined to that one.

use super::arrange::{Edge, Starts};
use super::ordered::Ordered;
use super::points::{Point, cross, from_to, turn};

/// A triangle, counter-clockwise: its nodes, and for each whether the edge from it to the next lies on the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Triangle {
    pub(super) nodes: [u32; 3],
    pub(super) boundary: [bool; 3],
}

/// An edge of the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Border {
    pub(super) lo: u32,
    pub(super) hi: u32,
    /// Whether the inside is above (to the left of the way from `lo` to `hi`) or below.
    pub(super) inside_above: bool,
}

/// The two chains of a monotone polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Chain {
    Lower,
    Upper,
}

/// A monotone polygon while its vertices come in: those that still have no triangles on their inner side, all of one
/// chain except perhaps the first. With each vertex goes whether the edge to the one before lies on the boundary.
#[derive(Debug)]
struct Monotone {
    waiting: Vec<(u32, bool)>,
    chain: Chain,
}

impl Monotone {
    fn new(first: u32) -> Self {
        Self { waiting: vec![(first, false)], chain: Chain::Lower }
    }

    /// The vertex that came last.
    fn last(&self) -> u32 {
        self.waiting[self.waiting.len() - 1].0
    }

    /// The next vertex, on a chain; `boundary` tells of the edge to it along this chain.
    fn add(&mut self, node: u32, chain: Chain, boundary: bool, out: &mut Out) {
        if self.waiting.len() == 1 {
            self.chain = chain;
            self.waiting.push((node, boundary));
        } else if self.chain == chain {
            let mut edge = boundary;
            while let [.., (before, _), (top, to_before)] = self.waiting[..] {
                let turn = turn(out.point(before), out.point(top), out.point(node));
                if turn == 0 || (turn > 0) != (chain == Chain::Lower) {
                    break;
                }
                out.triangle(chain, [before, top, node], [to_before, edge, false]);
                self.waiting.pop();
                edge = false;
            }
            self.waiting.push((node, edge));
        } else {
            let last = self.last();
            self.fan(node, false, boundary, out);
            self.waiting = vec![(last, false), (node, false)];
            self.chain = chain;
        }
    }

    /// The last vertex; whether the edges to it on the lower and the upper chain lie on the boundary.
    fn close(self, node: u32, lower: bool, upper: bool, out: &mut Out) {
        match self.chain {
            Chain::Lower => self.fan(node, lower, upper, out),
            Chain::Upper => self.fan(node, upper, lower, out),
        }
    }

    /// Triangles from a vertex to all that wait: whether its edges to the last and the first of them are boundary.
    fn fan(&self, node: u32, to_last: bool, to_first: bool, out: &mut Out) {
        let last = self.waiting.len() - 1;
        for i in 1..=last {
            let ((a, _), (b, edge)) = (self.waiting[i - 1], self.waiting[i]);
            out.triangle(self.chain, [a, b, node], [edge, i == last && to_last, i == 1 && to_first]);
        }
    }
}

/// Where triangles go.
struct Out<'a> {
    points: &'a [Point],
    triangles: Vec<Triangle>,
}

impl Out<'_> {
    fn point(&self, node: u32) -> Point {
        self.points[node as usize]
    }

    /// A triangle `a b c`, `a` and `b` one after the other on a chain; whether ab, bc and ca lie on the boundary.
    fn triangle(&mut self, chain: Chain, [a, b, c]: [u32; 3], [ab, bc, ca]: [bool; 3]) {
        let (nodes, boundary) = match chain {
            Chain::Lower => ([a, b, c], [ab, bc, ca]),
            Chain::Upper => ([a, c, b], [ca, bc, ab]),
        };
        debug_assert!(turn(self.point(nodes[0]), self.point(nodes[1]), self.point(nodes[2])) > 0);
        self.triangles.push(Triangle { nodes, boundary });
    }
}

/// What is open in an inner gap: a polygon, or two that end at the same node, the lower first.
#[derive(Debug)]
struct Gap {
    lower: Monotone,
    upper: Option<Monotone>,
}

impl Gap {
    fn new(polygon: Monotone) -> Self {
        Self { lower: polygon, upper: None }
    }

    /// The gap's upper edge ends at a node: what goes on below it.
    fn under(mut self, node: u32, out: &mut Out) -> Monotone {
        match self.upper {
            Some(upper) => {
                upper.close(node, false, true, out);
                self.lower.add(node, Chain::Upper, false, out);
            }
            None => self.lower.add(node, Chain::Upper, true, out),
        }
        self.lower
    }

    /// The gap's lower edge ends at a node: what goes on above it.
    fn over(mut self, node: u32, out: &mut Out) -> Monotone {
        match self.upper {
            Some(mut upper) => {
                self.lower.close(node, true, false, out);
                upper.add(node, Chain::Lower, false, out);
                upper
            }
            None => {
                self.lower.add(node, Chain::Lower, true, out);
                self.lower
            }
        }
    }

    /// Both edges of the gap end at a node.
    fn close(self, node: u32, out: &mut Out) {
        match self.upper {
            Some(upper) => {
                self.lower.close(node, true, false, out);
                upper.close(node, false, true, out);
            }
            None => self.lower.close(node, true, true, out),
        }
    }

    /// Edges begin at a node within the gap: what goes on below and above them. The node is joined to the last one.
    fn part(mut self, node: u32, out: &mut Out) -> [Monotone; 2] {
        let [mut lower, mut upper] = match self.upper.take() {
            Some(upper) => [self.lower, upper],
            None => {
                let new = Monotone::new(self.lower.last());
                match self.lower.chain {
                    Chain::Lower => [new, self.lower],
                    Chain::Upper => [self.lower, new],
                }
            }
        };
        lower.add(node, Chain::Upper, false, out);
        upper.add(node, Chain::Lower, false, out);
        [lower, upper]
    }
}

/// The triangles between the edges of a boundary, which meet only at their ends.
pub(super) fn triangles(points: &[Point], borders: &[Border]) -> Vec<Triangle> {
    let edges: Vec<Edge> = borders.iter().map(|b| Edge { lo: b.lo, hi: b.hi, winding: 1 }).collect();
    let starts = Starts::new(points, &edges);
    let ends = |e: u32| [borders[e as usize].lo, borders[e as usize].hi].map(|n| points[n as usize]);
    let inside_above = |e: &u32| borders[*e as usize].inside_above;
    // What is open above each edge that has the inside above it.
    let mut gaps: Vec<Option<Gap>> = borders.iter().map(|_| None).collect();
    let mut out = Out { points, triangles: Vec::new() };
    let mut active = Ordered::default();
    let (mut ending, mut starting) = (Vec::new(), Vec::new());
    for &node in starts.nodes() {
        let p = points[node as usize];
        let side = |e: u32| turn(ends(e)[0], ends(e)[1], p);
        let (from, to) = (active.place(|e| side(e) > 0), active.place(|e| side(e) >= 0));
        active.between(from, to, &mut ending);
        starting.clear();
        starting.extend_from_slice(starts.at(node));
        starting.sort_unstable_by(|a, b| {
            let [a, b] = [a, b].map(|e| ends(*e)).map(|[lo, hi]| from_to(lo, hi));
            0.cmp(&cross(a, b))
        });
        let floor = active.before(from).filter(inside_above);
        active.replace(from, to, &starting);

        // What lies to the left of the node: the gap below its edges, those between them, the gap above them.
        let under = floor.and_then(|e| gaps[e as usize].take());
        let [under, over] = match ending[..] {
            [] => match under {
                Some(gap) => gap.part(node, &mut out).map(Some),
                None => [None, None],
            },
            [ref between @ .., highest] => {
                for e in between {
                    if let Some(gap) = gaps[*e as usize].take() {
                        gap.close(node, &mut out);
                    }
                }
                let over = gaps[highest as usize].take();
                [under.map(|gap| gap.under(node, &mut out)), over.map(|gap| gap.over(node, &mut out))]
            }
        };
        // What lies to the right of it.
        match starting[..] {
            [] => {
                if let (Some(e), Some(lower)) = (floor, under) {
                    gaps[e as usize] = Some(Gap { lower, upper: over });
                }
            }
            [ref between @ .., highest] => {
                if let (Some(e), Some(lower)) = (floor, under) {
                    gaps[e as usize] = Some(Gap::new(lower));
                }
                for e in between.iter().filter(|e| inside_above(e)) {
                    gaps[*e as usize] = Some(Gap::new(Monotone::new(node)));
                }
                gaps[highest as usize] = over.map(Gap::new);
            }
        }
    }
    out.triangles
}
