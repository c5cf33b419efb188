//! Fog and colour sum (OpenGL 1.5, sections 3.9 and 3.10, table 6.8).

use crate::enums::{GL_EXP, GL_FRAGMENT_DEPTH, GLenum};

/// Fog parameters and the colour sum enable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    /// `GL_FOG`.
    pub enabled: bool,
    /// Fog colour RGBA, clamped to [0, 1].
    pub color: [f32; 4],
    /// Fog colour index.
    pub index: f32,
    /// Density of the exponential modes, not negative.
    pub density: f32,
    /// Where linear fog starts.
    pub start: f32,
    /// Where linear fog ends.
    pub end: f32,
    /// `GL_EXP`, `GL_EXP2` or `GL_LINEAR`.
    pub mode: GLenum,
    /// `GL_FRAGMENT_DEPTH` or `GL_FOG_COORD`.
    pub coord_source: GLenum,
    /// `GL_COLOR_SUM`.
    pub color_sum: bool,
}

impl Default for Fog {
    fn default() -> Self {
        Self {
            enabled: false,
            color: [0.0; 4],
            index: 0.0,
            density: 1.0,
            start: 0.0,
            end: 1.0,
            mode: GL_EXP,
            coord_source: GL_FRAGMENT_DEPTH,
            color_sum: false,
        }
    }
}
