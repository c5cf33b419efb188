//! Lighting state (OpenGL 1.5, section 2.14, tables 6.8 to 6.11): shade model, colour material, the light model, two
//! materials and eight lights. Positions and directions are kept in eye coordinates, as the spec stores them.

use super::raster::Face;
use crate::enums::gl_enum;
use crate::limits::MAX_LIGHTS;

gl_enum! {
    /// Where the specular part of lighting goes.
    pub enum ColorControl {
        /// Into the primary colour.
        SingleColor = GL_SINGLE_COLOR,
        /// Into the secondary colour, which is added after texturing.
        SeparateSpecularColor = GL_SEPARATE_SPECULAR_COLOR,
    }
}

gl_enum! {
    /// Whether colours are interpolated over a primitive.
    pub enum ShadeModel {
        /// They are those of one vertex.
        Flat = GL_FLAT,
        /// They are.
        Smooth = GL_SMOOTH,
    }
}

gl_enum! {
    /// The colours of a material that may follow the current colour.
    pub enum MaterialColor {
        Emission = GL_EMISSION,
        Ambient = GL_AMBIENT,
        Diffuse = GL_DIFFUSE,
        Specular = GL_SPECULAR,
        AmbientAndDiffuse = GL_AMBIENT_AND_DIFFUSE,
    }
}

/// Lighting, shading and materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// `GL_LIGHTING`.
    pub enabled: bool,
    /// Whether colours are interpolated.
    pub shade_model: ShadeModel,
    /// `GL_COLOR_MATERIAL`.
    pub color_material: bool,
    /// Which faces the current colour tracks.
    pub color_material_face: Face,
    /// Which properties the current colour tracks.
    pub color_material_mode: MaterialColor,
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
    /// Where the specular part goes.
    pub color_control: ColorControl,
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

impl Material {
    /// Sets one colour, or two.
    pub const fn set_color(&mut self, which: MaterialColor, color: [f32; 4]) {
        match which {
            MaterialColor::Emission => self.emission = color,
            MaterialColor::Ambient => self.ambient = color,
            MaterialColor::Diffuse => self.diffuse = color,
            MaterialColor::Specular => self.specular = color,
            MaterialColor::AmbientAndDiffuse => (self.ambient, self.diffuse) = (color, color),
        }
    }
}

impl Default for Lighting {
    fn default() -> Self {
        let mut lights: [Light; MAX_LIGHTS] = std::array::from_fn(|_| Light::default());
        lights[0].diffuse = [1.0; 4];
        lights[0].specular = [1.0; 4];
        Self {
            enabled: false,
            shade_model: ShadeModel::Smooth,
            color_material: false,
            color_material_face: Face::FrontAndBack,
            color_material_mode: MaterialColor::AmbientAndDiffuse,
            model: LightModel::default(),
            materials: [Material::default(), Material::default()],
            lights,
        }
    }
}

impl Default for LightModel {
    fn default() -> Self {
        Self {
            ambient: [0.2, 0.2, 0.2, 1.0],
            local_viewer: false,
            two_side: false,
            color_control: ColorControl::SingleColor,
        }
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
