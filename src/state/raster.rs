//! Rasterisation state (OpenGL 1.5, sections 3.3 to 3.5, tables 6.12 to 6.14 and 6.26): points, lines, polygons,
//! stipple, multisampling switches and hints.

use crate::enums::{GL_BACK, GL_CCW, GL_DONT_CARE, GL_FILL, GLenum};

/// Points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Size in pixels.
    pub size: f32,
    /// `GL_POINT_SMOOTH`.
    pub smooth: bool,
    /// Least derived size.
    pub size_min: f32,
    /// Greatest derived size.
    pub size_max: f32,
    /// Size below which a point fades (multisampling only).
    pub fade_threshold: f32,
    /// Constant, linear, quadratic distance attenuation.
    pub distance_attenuation: [f32; 3],
}

impl Default for Point {
    fn default() -> Self {
        Self {
            size: 1.0,
            smooth: false,
            size_min: 0.0,
            size_max: crate::limits::POINT_SIZE_RANGE[1],
            fade_threshold: 1.0,
            distance_attenuation: [1.0, 0.0, 0.0],
        }
    }
}

/// Lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Width in pixels.
    pub width: f32,
    /// `GL_LINE_SMOOTH`.
    pub smooth: bool,
    /// `GL_LINE_STIPPLE`.
    pub stipple: bool,
    /// Stipple pattern, low bit first.
    pub stipple_pattern: u16,
    /// Stipple repeat factor in [1, 256].
    pub stipple_factor: i32,
}

impl Default for Line {
    fn default() -> Self {
        Self { width: 1.0, smooth: false, stipple: false, stipple_pattern: 0xFFFF, stipple_factor: 1 }
    }
}

/// Polygons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon {
    /// `GL_CULL_FACE`.
    pub cull: bool,
    /// Which faces are culled.
    pub cull_face: GLenum,
    /// Which winding is the front.
    pub front_face: GLenum,
    /// `GL_POLYGON_SMOOTH`.
    pub smooth: bool,
    /// Front and back: `GL_POINT`, `GL_LINE` or `GL_FILL`.
    pub mode: [GLenum; 2],
    /// Offset factor (times the slope).
    pub offset_factor: f32,
    /// Offset units (times the least resolvable difference).
    pub offset_units: f32,
    /// Offset enables for point, line and fill modes.
    pub offset: [bool; 3],
    /// `GL_POLYGON_STIPPLE`.
    pub stipple: bool,
}

impl Default for Polygon {
    fn default() -> Self {
        Self {
            cull: false,
            cull_face: GL_BACK,
            front_face: GL_CCW,
            smooth: false,
            mode: [GL_FILL; 2],
            offset_factor: 0.0,
            offset_units: 0.0,
            offset: [false; 3],
            stipple: false,
        }
    }
}

/// The polygon stipple: row 0 is the lowest, the top bit of a row is its leftmost pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonStipple(pub [u32; 32]);

impl Default for PolygonStipple {
    fn default() -> Self {
        Self([u32::MAX; 32])
    }
}

/// Multisampling state. The framebuffer has no sample buffers, so these are kept and reported only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multisample {
    /// `GL_MULTISAMPLE`.
    pub enabled: bool,
    /// `GL_SAMPLE_ALPHA_TO_COVERAGE`.
    pub alpha_to_coverage: bool,
    /// `GL_SAMPLE_ALPHA_TO_ONE`.
    pub alpha_to_one: bool,
    /// `GL_SAMPLE_COVERAGE`.
    pub coverage: bool,
    /// Coverage value.
    pub coverage_value: f32,
    /// Whether the coverage mask is inverted.
    pub coverage_invert: bool,
}

impl Default for Multisample {
    fn default() -> Self {
        Self {
            enabled: true,
            alpha_to_coverage: false,
            alpha_to_one: false,
            coverage: false,
            coverage_value: 1.0,
            coverage_invert: false,
        }
    }
}

/// Hints (section 5.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hint {
    /// `GL_PERSPECTIVE_CORRECTION_HINT`.
    pub perspective_correction: GLenum,
    /// `GL_POINT_SMOOTH_HINT`.
    pub point_smooth: GLenum,
    /// `GL_LINE_SMOOTH_HINT`.
    pub line_smooth: GLenum,
    /// `GL_POLYGON_SMOOTH_HINT`.
    pub polygon_smooth: GLenum,
    /// `GL_FOG_HINT`.
    pub fog: GLenum,
    /// `GL_GENERATE_MIPMAP_HINT`.
    pub generate_mipmap: GLenum,
    /// `GL_TEXTURE_COMPRESSION_HINT`.
    pub texture_compression: GLenum,
}

impl Default for Hint {
    fn default() -> Self {
        Self {
            perspective_correction: GL_DONT_CARE,
            point_smooth: GL_DONT_CARE,
            line_smooth: GL_DONT_CARE,
            polygon_smooth: GL_DONT_CARE,
            fog: GL_DONT_CARE,
            generate_mipmap: GL_DONT_CARE,
            texture_compression: GL_DONT_CARE,
        }
    }
}
