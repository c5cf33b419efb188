//! Lighting state (OpenGL 1.5, section 2.14, tables 6.8 to 6.11): shade model, colour material, the light model, two
//! materials and eight lights. Positions and directions are kept in eye coordinates, as the spec stores them.

use crate::enums::{GL_AMBIENT_AND_DIFFUSE, GL_FRONT_AND_BACK, GL_SINGLE_COLOR, GL_SMOOTH, GLenum};
use crate::limits::MAX_LIGHTS;

/// Lighting, shading and materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// `GL_LIGHTING`.
    pub enabled: bool,
    /// `GL_SMOOTH` or `GL_FLAT`.
    pub shade_model: GLenum,
    /// `GL_COLOR_MATERIAL`.
    pub color_material: bool,
    /// Which faces the current colour tracks.
    pub color_material_face: GLenum,
    /// Which properties the current colour tracks.
    pub color_material_mode: GLenum,
    /// The light model.
    pub model: LightModel,
    /// Front and back material.
    pub materials: [Material; 2],
    /// The light sources.
    pub lights: [Light; MAX_LIGHTS],
}

/// Parameters of the lighting model (table 2.9, last group).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightModel {
    /// Ambient colour of the scene.
    pub ambient: [f32; 4],
    /// `GL_LIGHT_MODEL_LOCAL_VIEWER`.
    pub local_viewer: bool,
    /// `GL_LIGHT_MODEL_TWO_SIDE`.
    pub two_side: bool,
    /// `GL_SINGLE_COLOR` or `GL_SEPARATE_SPECULAR_COLOR`.
    pub color_control: GLenum,
}

/// A material (table 2.9, first group).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Ambient colour.
    pub ambient: [f32; 4],
    /// Diffuse colour.
    pub diffuse: [f32; 4],
    /// Specular colour.
    pub specular: [f32; 4],
    /// Emissive colour.
    pub emission: [f32; 4],
    /// Specular exponent in [0, 128].
    pub shininess: f32,
    /// Colour indices: ambient, diffuse, specular.
    pub indexes: [f32; 3],
}

/// A light source (table 2.9, second group).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// `GL_LIGHTi`.
    pub enabled: bool,
    /// Ambient intensity.
    pub ambient: [f32; 4],
    /// Diffuse intensity.
    pub diffuse: [f32; 4],
    /// Specular intensity.
    pub specular: [f32; 4],
    /// Position in eye coordinates; w = 0 is a direction.
    pub position: [f64; 4],
    /// Spot direction in eye coordinates.
    pub spot_direction: [f64; 3],
    /// Spot exponent in [0, 128].
    pub spot_exponent: f32,
    /// Spot cutoff in degrees: [0, 90] or 180.
    pub spot_cutoff: f32,
    /// Constant, linear and quadratic attenuation.
    pub attenuation: [f32; 3],
}

impl Default for Lighting {
    fn default() -> Self {
        let mut lights: [Light; MAX_LIGHTS] = std::array::from_fn(|_| Light::default());
        lights[0].diffuse = [1.0; 4];
        lights[0].specular = [1.0; 4];
        Self {
            enabled: false,
            shade_model: GL_SMOOTH,
            color_material: false,
            color_material_face: GL_FRONT_AND_BACK,
            color_material_mode: GL_AMBIENT_AND_DIFFUSE,
            model: LightModel::default(),
            materials: [Material::default(), Material::default()],
            lights,
        }
    }
}

impl Default for LightModel {
    fn default() -> Self {
        Self { ambient: [0.2, 0.2, 0.2, 1.0], local_viewer: false, two_side: false, color_control: GL_SINGLE_COLOR }
    }
}

impl Default for Material {
    fn default() -> Self {
        Self {
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            emission: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            indexes: [0.0, 1.0, 1.0],
        }
    }
}

/// The initial values of every light but light 0, whose diffuse and specular intensities are white.
impl Default for Light {
    fn default() -> Self {
        Self {
            enabled: false,
            ambient: [0.0, 0.0, 0.0, 1.0],
            diffuse: [0.0, 0.0, 0.0, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            position: [0.0, 0.0, 1.0, 0.0],
            spot_direction: [0.0, 0.0, -1.0],
            spot_exponent: 0.0,
            spot_cutoff: 180.0,
            attenuation: [1.0, 0.0, 0.0],
        }
    }
}
