//! Evaluator state (OpenGL 1.5, section 5.1, tables 6.22 and 6.23): which maps are enabled, the maps themselves and the
//! grids. The maps stand in the order of their names: colour 4, index, normal, texture coordinates 1 to 4, vertex 3, 4.

use crate::enums::{GL_MAP1_COLOR_4, GL_MAP2_COLOR_4, GLenum};

/// How many kinds of map there are in one dimension, and in two.
pub const MAPS: usize = 9;

/// Components of a control point of each kind.
pub const COMPONENTS: [usize; MAPS] = [4, 1, 3, 1, 2, 3, 4, 3, 4];

/// Kinds of map, as indices.
pub mod kind {
    /// Colours RGBA.
    pub const COLOR: usize = 0;
    /// Normals.
    pub const NORMAL: usize = 2;
    /// Texture coordinates s; s, t; s, t, r; s, t, r, q.
    pub const TEX_COORD: usize = 3;
    /// Vertices x, y, z; x, y, z, w.
    pub const VERTEX: usize = 7;
}

/// The kind of a one-dimensional map.
#[must_use]
pub fn map1_kind(target: GLenum) -> Option<usize> {
    Some(target.wrapping_sub(GL_MAP1_COLOR_4) as usize).filter(|kind| *kind < MAPS)
}

/// The kind of a two-dimensional map.
#[must_use]
pub fn map2_kind(target: GLenum) -> Option<usize> {
    Some(target.wrapping_sub(GL_MAP2_COLOR_4) as usize).filter(|kind| *kind < MAPS)
}

/// Enables and grids, which the attribute stack keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eval {
    /// `GL_AUTO_NORMAL`.
    pub auto_normal: bool,
    /// Enables of the one-dimensional maps.
    pub map1_enabled: [bool; MAPS],
    /// Enables of the two-dimensional maps.
    pub map2_enabled: [bool; MAPS],
    /// Grid of `glEvalMesh1`: segments, u1, u2.
    pub grid1: (i32, f64, f64),
    /// Grid of `glEvalMesh2`: segments, ends in u, then in v.
    pub grid2: [(i32, f64, f64); 2],
}

impl Default for Eval {
    fn default() -> Self {
        Self {
            auto_normal: false,
            map1_enabled: [false; MAPS],
            map2_enabled: [false; MAPS],
            grid1: (1, 0.0, 1.0),
            grid2: [(1, 0.0, 1.0); 2],
        }
    }
}

/// A map: polynomials in one or two parameters, all of one order and domain.
#[derive(Clone, Debug, PartialEq)]
pub struct EvalMap<const D: usize> {
    /// How many control points there are in u, and in v.
    pub order: [usize; D],
    /// Ends of the domain in u, and in v.
    pub domain: [[f64; 2]; D],
    /// Control points without gaps: all v of the first u, then all v of the second, and so on.
    pub points: Vec<f64>,
}

/// All maps, which no attribute group keeps.
#[derive(Clone, Debug, PartialEq)]
pub struct EvalMaps {
    /// The one-dimensional ones.
    pub map1: [EvalMap<1>; MAPS],
    /// The two-dimensional ones.
    pub map2: [EvalMap<2>; MAPS],
}

/// The one control point that a map has in the beginning: white, 1, the z axis, the origin.
fn initial<const D: usize>(kind: usize) -> EvalMap<D> {
    let point: [f64; 4] = match kind {
        kind::COLOR | 1 => [1.0; 4],
        kind::NORMAL => [0.0, 0.0, 1.0, 0.0],
        _ => [0.0, 0.0, 0.0, 1.0],
    };
    EvalMap { order: [1; D], domain: [[0.0, 1.0]; D], points: point[..COMPONENTS[kind]].to_vec() }
}

impl Default for EvalMaps {
    fn default() -> Self {
        Self { map1: std::array::from_fn(initial), map2: std::array::from_fn(initial) }
    }
}
