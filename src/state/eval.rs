//! Evaluator state (OpenGL 1.5, section 5.1, tables 6.22 and 6.23): which maps are enabled, the maps themselves and the
//! grids. The maps stand in the order of their names: colour 4, index, normal, texture coordinates 1 to 4, vertex 3, 4.

/// Enables, grids and maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eval {
    /// `GL_AUTO_NORMAL`.
    pub auto_normal: bool,
    /// Enables of the one-dimensional maps.
    pub map1_enabled: [bool; 9],
    /// Enables of the two-dimensional maps.
    pub map2_enabled: [bool; 9],
    /// Grid of `glEvalMesh1`: segments, u1, u2.
    pub grid1: (i32, f64, f64),
    /// Grid of `glEvalMesh2`: segments, ends in u, then in v.
    pub grid2: [(i32, f64, f64); 2],
}

impl Default for Eval {
    fn default() -> Self {
        Self {
            auto_normal: false,
            map1_enabled: [false; 9],
            map2_enabled: [false; 9],
            grid1: (1, 0.0, 1.0),
            grid2: [(1, 0.0, 1.0); 2],
        }
    }
}
