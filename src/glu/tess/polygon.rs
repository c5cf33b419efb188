//! A polygon that is complete, from its contours to the callbacks.

use super::arrange::{Arrangement, Crossing, arrange, directed};
use super::loops::loops;
use super::monotone::{Border, triangles};
use super::plane::to_grid;
use super::{Settings, TessCallbacks, WindingRule};
use crate::enums::{GL_LINE_LOOP, GL_TRIANGLES, GLenum};
use crate::glu::constants::{GLU_OUT_OF_MEMORY, GLU_TESS_NEED_COMBINE_CALLBACK};
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Contours with what the program said of their vertices.
#[derive(Clone, Debug)]
pub(crate) struct Polygon<V> {
    pub(super) settings: Settings,
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) data: Vec<V>,
    /// The index behind the last vertex of each contour.
    pub(super) ends: Vec<usize>,
}

/// A place of the grid at which there are vertices.
struct Node<V> {
    position: [f64; 3],
    data: V,
}

impl<V> Polygon<V> {
    pub(super) fn new(settings: Settings) -> Self {
        Self { settings, positions: Vec::new(), data: Vec::new(), ends: Vec::new() }
    }

    /// Tells the callbacks the triangles or the boundary.
    pub(crate) fn tessellate(self, to: &mut impl TessCallbacks<V>) {
        if let Err(error) = self.try_tessellate(to) {
            to.error(error);
        }
    }

    fn try_tessellate(self, to: &mut impl TessCallbacks<V>) -> Result<(), GLenum> {
        let settings = self.settings;
        let (arrangement, mut nodes) = self.arranged(to)?;
        for crossing in &arrangement.crossings {
            let node = crossed(&nodes, crossing, to).ok_or(GLU_TESS_NEED_COMBINE_CALLBACK)?;
            nodes.push(node);
        }
        let borders = borders(&arrangement, settings.rule);
        if settings.boundary_only {
            for nodes_of_loop in loops(&arrangement.points, &borders) {
                to.begin(GL_LINE_LOOP);
                for node in nodes_of_loop {
                    to.vertex(&nodes[node as usize].data);
                }
                to.end();
            }
            return Ok(());
        }
        let triangles = triangles(&arrangement.points, &borders);
        if triangles.is_empty() {
            return Ok(());
        }
        to.begin(GL_TRIANGLES);
        let mut flag = None;
        for triangle in triangles {
            for (node, boundary) in triangle.nodes.into_iter().zip(triangle.boundary) {
                if flag != Some(boundary) {
                    flag = Some(boundary);
                    to.edge_flag(boundary);
                }
                to.vertex(&nodes[node as usize].data);
            }
        }
        to.end();
        Ok(())
    }

    /// The edges of all contours, cut where they meet, and the nodes of the vertices.
    fn arranged(self, to: &mut impl TessCallbacks<V>) -> Result<(Arrangement, Vec<Node<V>>), GLenum> {
        // Numbers of nodes and edges have 32 bits.
        if self.positions.len() >= 1 << 30 {
            return Err(GLU_OUT_OF_MEMORY);
        }
        let grid = to_grid(&self.positions, &self.ends, self.settings.normal, self.settings.tolerance);
        let (mut points, mut nodes, mut node_at) = (Vec::new(), Vec::<Node<V>>::new(), HashMap::new());
        let mut node_of = Vec::with_capacity(grid.len());
        for ((point, position), data) in grid.into_iter().zip(self.positions).zip(self.data) {
            let node = match node_at.entry(point) {
                Entry::Vacant(place) => {
                    points.push(point);
                    nodes.push(Node { position, data });
                    *place.insert(nodes.len() as u32 - 1)
                }
                Entry::Occupied(place) => {
                    let node = &mut nodes[*place.get() as usize];
                    merge(node, &Node { position, data }, to);
                    *place.get()
                }
            };
            node_of.push(node);
        }
        let (mut edges, mut first) = (Vec::with_capacity(node_of.len()), 0);
        for end in self.ends {
            let contour = &node_of[first..end];
            for (a, b) in contour.iter().zip(contour.iter().cycle().skip(1)) {
                if a != b {
                    edges.push(directed(&points, *a, *b, 1));
                }
            }
            first = end;
        }
        let arrangement = arrange(points, edges).map_err(|_| GLU_OUT_OF_MEMORY)?;
        Ok((arrangement, nodes))
    }
}

/// Puts a vertex into a node that is there already. Without a combine callback the first data stay.
fn merge<V>(node: &mut Node<V>, vertex: &Node<V>, to: &mut impl TessCallbacks<V>) {
    let position = [0, 1, 2].map(|i| node.position[i] / 2.0 + vertex.position[i] / 2.0);
    let data = [Some(&node.data), Some(&vertex.data), None, None];
    if let Some(data) = to.combine(position, data, [0.5, 0.5, 0.0, 0.0]) {
        *node = Node { position, data };
    }
}

/// The node where two edges cross: half of it comes from each of them.
fn crossed<V>(nodes: &[Node<V>], crossing: &Crossing, to: &mut impl TessCallbacks<V>) -> Option<Node<V>> {
    let [[a, b], [c, d]] = crossing.edges;
    let ends = [a, b, c, d].map(|n| &nodes[n as usize]);
    let [s, t] = crossing.parts;
    let weights = [(1.0 - s) / 2.0, s / 2.0, (1.0 - t) / 2.0, t / 2.0];
    let position = [0, 1, 2].map(|i| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|n| weights[n] * ends[n].position[i]);
        (a + b) + (c + d)
    });
    let data = to.combine(position, ends.map(|n| Some(&n.data)), weights.map(|w| w as f32))?;
    Some(Node { position, data })
}

/// The edges with the inside on exactly one side.
pub(super) fn borders(arrangement: &Arrangement, rule: WindingRule) -> Vec<Border> {
    let sides = arrangement.edges.iter().zip(&arrangement.below);
    sides
        .filter_map(|(edge, below)| {
            let (below, above) = (rule.inside(*below), rule.inside(below + edge.winding));
            (below != above).then_some(Border { lo: edge.lo, hi: edge.hi, inside_above: above })
        })
        .collect()
}
