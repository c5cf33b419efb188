//! Fog and colour sum (OpenGL 1.5, sections 3.9 and 3.10, table 6.8).

use crate::enums::gl_enum;

gl_enum! {
    /// How fog grows with the distance.
    pub enum FogMode {
        /// Exponentially with the density.
        Exp = GL_EXP,
        /// The same with the square.
        Exp2 = GL_EXP2,
        /// Linearly from start to end.
        Linear = GL_LINEAR,
    }
}

gl_enum! {
    /// What fog takes as the distance.
    pub enum FogCoordSource {
        /// The distance from the eye.
        FragmentDepth = GL_FRAGMENT_DEPTH,
        /// The fog coordinate that the vertices have.
        FogCoord = GL_FOG_COORD,
    }
}

gl_enum! {
    /// What the distance from the eye is (NV_fog_distance).
    #[expect(clippy::enum_variant_names, reason = "the names are GL's")]
    pub enum FogDistanceMode {
        /// The length of the way to the eye.
        EyeRadial = GL_EYE_RADIAL_NV,
        /// Eye z, negative in front of the eye.
        EyePlane = GL_EYE_PLANE,
        /// The distance from the plane z = 0 through the eye.
        EyePlaneAbsolute = GL_EYE_PLANE_ABSOLUTE_NV,
    }
}

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
    /// How fog grows with the distance.
    pub mode: FogMode,
    /// What fog takes as the distance.
    pub coord_source: FogCoordSource,
    /// What the distance from the eye is.
    pub distance_mode: FogDistanceMode,
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
            mode: FogMode::Exp,
            coord_source: FogCoordSource::FragmentDepth,
            distance_mode: FogDistanceMode::EyePlaneAbsolute,
            color_sum: false,
        }
    }
}
