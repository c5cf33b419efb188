//! Current values (OpenGL 1.5, sections 2.7 and 2.12, table 6.5): what a vertex takes with it when it is issued, and
//! the current raster position.

use super::per_unit::PerUnit;
use crate::limits::MAX_TEXTURE_UNITS;

/// Current vertex attributes and raster position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Current {
    /// Primary colour RGBA.
    pub color: [f32; 4],
    /// Secondary colour RGB; the fourth component is not used.
    pub secondary_color: [f32; 4],
    /// Colour index.
    pub index: f32,
    /// Normal vector, not normalised.
    pub normal: [f32; 3],
    /// Texture coordinates s, t, r, q of each unit.
    pub tex_coord: PerUnit<[f32; 4]>,
    /// Fog coordinate.
    pub fog_coord: f32,
    /// Edge flag.
    pub edge_flag: bool,
    /// Current raster position and what belongs to it.
    pub raster: RasterPos,
}

/// The current raster position (section 2.12).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RasterPos {
    /// Window coordinates x, y, z and clip w.
    pub position: [f64; 4],
    /// Distance from the eye for fog.
    pub distance: f32,
    /// Colour.
    pub color: [f32; 4],
    /// Secondary colour.
    pub secondary_color: [f32; 4],
    /// Colour index.
    pub index: f32,
    /// Texture coordinates of each unit.
    pub tex_coord: PerUnit<[f32; 4]>,
    /// Whether the position is valid.
    pub valid: bool,
}

impl Default for RasterPos {
    fn default() -> Self {
        Self {
            position: [0.0, 0.0, 0.0, 1.0],
            distance: 0.0,
            color: [1.0; 4],
            secondary_color: [0.0, 0.0, 0.0, 1.0],
            index: 1.0,
            tex_coord: [[0.0, 0.0, 0.0, 1.0]; MAX_TEXTURE_UNITS],
            valid: true,
        }
    }
}

impl Default for Current {
    fn default() -> Self {
        Self {
            color: [1.0; 4],
            secondary_color: [0.0, 0.0, 0.0, 1.0],
            index: 1.0,
            normal: [0.0, 0.0, 1.0],
            tex_coord: [[0.0, 0.0, 0.0, 1.0]; MAX_TEXTURE_UNITS],
            fog_coord: 0.0,
            edge_flag: true,
            raster: RasterPos::default(),
        }
    }
}
