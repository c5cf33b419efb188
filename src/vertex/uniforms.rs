//! The uniforms of vertex stages, derived from the state when it changes: matrices in f64, lights and materials in f32.
//! Stages see only these and the batch, never the state.

use crate::limits::{MAX_CLIP_PLANES, MAX_LIGHTS, MAX_TEXTURE_UNITS};

/// A matrix as four columns.
pub type Columns = [[f64; 4]; 4];

/// The matrix for normals as three columns.
pub type NormalMatrix = [[f64; 3]; 3];

/// From clip to window coordinates (section 2.11.1).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewportUniforms {
    /// Half of width and height.
    pub half: [f64; 2],
    /// Centre in pixels.
    pub center: [f64; 2],
    /// Centre in 1/256 pixel.
    pub center_snapped: [i32; 2],
    /// Half of the depth range.
    pub depth_half: f64,
    /// Centre of the depth range.
    pub depth_center: f64,
}

/// A light source, ready for the stages.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightUniforms {
    /// Ambient intensity.
    pub ambient: [f32; 3],
    /// Diffuse intensity.
    pub diffuse: [f32; 3],
    /// Specular intensity.
    pub specular: [f32; 3],
    /// Position in eye coordinates, divided by w, of a light that has one.
    pub position: [f64; 3],
    /// Unit vector to a light at infinity.
    pub direction: [f32; 3],
    /// Unit vector half way between a light at infinity and a viewer at infinity.
    pub half: [f32; 3],
    /// Constant, linear, quadratic attenuation.
    pub attenuation: [f32; 3],
    /// Unit vector of the spot direction.
    pub spot_direction: [f32; 3],
    /// Cosine of the spot cutoff, below -1 where there is no cutoff.
    pub spot_cos: f32,
    /// Spot exponent.
    pub spot_exponent: f32,
}

/// A material face, ready for the stages.
#[derive(Clone, Copy, Debug, Default)]
pub struct MaterialUniforms {
    /// Emission plus, where the colour tracks neither, the ambient light that is the same for all vertices.
    pub base: [f32; 3],
    /// Emission alone.
    pub emission: [f32; 3],
    /// Ambient colour.
    pub ambient: [f32; 3],
    /// Diffuse colour.
    pub diffuse: [f32; 4],
    /// Specular colour.
    pub specular: [f32; 3],
    /// Specular exponent.
    pub shininess: f32,
}

/// What a texture unit asks of its coordinates.
#[derive(Clone, Copy, Debug, Default)]
pub struct UnitUniforms {
    /// Planes of object linear and eye linear generation, for s, t, r, q.
    pub planes: [[f64; 4]; 4],
    /// Texture matrix.
    pub matrix: Columns,
    /// First slot.
    pub base: usize,
    /// How many of s, t, r are handed on.
    pub count: usize,
    /// Whether q is handed on.
    pub has_q: bool,
}

/// All uniforms.
#[derive(Clone, Debug, Default)]
pub struct VertexUniforms {
    /// Projection times modelview.
    pub to_clip: Columns,
    /// Modelview.
    pub to_eye: Columns,
    /// Whether the modelview keeps w.
    pub eye_affine: bool,
    /// For normals.
    pub to_normal: NormalMatrix,
    /// Enabled user clip planes, packed.
    pub user: [[f64; 4]; MAX_CLIP_PLANES],
    /// The outcode bit of each packed plane.
    pub user_bit: [u32; MAX_CLIP_PLANES],
    /// How many user planes are enabled.
    pub user_count: usize,
    /// Viewport.
    pub viewport: ViewportUniforms,
    /// Ambient light of the scene and of all lights that are not attenuated.
    pub ambient: [f32; 3],
    /// The lights.
    pub lights: [LightUniforms; MAX_LIGHTS],
    /// Front and back material.
    pub materials: [MaterialUniforms; 2],
    /// Whether both faces are lit.
    pub two_side: bool,
    /// Slots of front and back colour.
    pub color_slot: [usize; 2],
    /// Slots of front and back secondary colour.
    pub secondary_slot: [usize; 2],
    /// Slot of the fog coordinate.
    pub fog_slot: usize,
    /// Texture units.
    pub units: [UnitUniforms; MAX_TEXTURE_UNITS],
    /// Point size, least, greatest, and distance attenuation.
    pub point: [f32; 3],
    /// Distance attenuation of the point size.
    pub point_attenuation: [f32; 3],
}
