//! Rasterisation state (OpenGL 1.5, sections 3.3 to 3.5, tables 6.12 to 6.14 and 6.26): points, lines, polygons,
//! stipple, multisampling switches and hints.

use crate::enums::gl_enum;

gl_enum! {
    /// Which faces of polygons are meant.
    pub enum Face {
        Front = GL_FRONT,
        Back = GL_BACK,
        FrontAndBack = GL_FRONT_AND_BACK,
    }
}

impl Face {
    /// Whether front, back faces are meant.
    #[must_use]
    pub const fn chosen(self) -> [bool; 2] {
        match self {
            Self::Front => [true, false],
            Self::Back => [false, true],
            Self::FrontAndBack => [true, true],
        }
    }
}

gl_enum! {
    /// The order of a polygon's vertices in the window.
    pub enum Winding {
        Clockwise = GL_CW,
        CounterClockwise = GL_CCW,
    }
}

gl_enum! {
    /// How the polygons of one face are drawn (section 3.5.4).
    pub enum PolygonMode {
        /// Their vertices, as points.
        Point = GL_POINT,
        /// Their boundary edges, as lines.
        Line = GL_LINE,
        /// Their inside.
        Fill = GL_FILL,
    }
}

gl_enum! {
    /// What a hint asks for (section 5.6).
    pub enum HintMode {
        DontCare = GL_DONT_CARE,
        Fastest = GL_FASTEST,
        Nicest = GL_NICEST,
    }
}

/// Points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Size in pixels.
    pub size: f32,
    /// `GL_POINT_SMOOTH`.
    pub smooth: bool,
    /// `GL_POINT_SPRITE_ARB`.
    pub sprite: bool,
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
            sprite: false,
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
    pub cull_face: Face,
    /// Which winding is the front.
    pub front_face: Winding,
    /// `GL_POLYGON_SMOOTH`.
    pub smooth: bool,
    /// Modes of front and back faces.
    pub mode: [PolygonMode; 2],
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
            cull_face: Face::Back,
            front_face: Winding::CounterClockwise,
            smooth: false,
            mode: [PolygonMode::Fill; 2],
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
    pub perspective_correction: HintMode,
    /// `GL_POINT_SMOOTH_HINT`.
    pub point_smooth: HintMode,
    /// `GL_LINE_SMOOTH_HINT`.
    pub line_smooth: HintMode,
    /// `GL_POLYGON_SMOOTH_HINT`.
    pub polygon_smooth: HintMode,
    /// `GL_FOG_HINT`.
    pub fog: HintMode,
    /// `GL_GENERATE_MIPMAP_HINT`.
    pub generate_mipmap: HintMode,
    /// `GL_TEXTURE_COMPRESSION_HINT`.
    pub texture_compression: HintMode,
}

impl Default for Hint {
    fn default() -> Self {
        Self {
            perspective_correction: HintMode::DontCare,
            point_smooth: HintMode::DontCare,
            line_smooth: HintMode::DontCare,
            polygon_smooth: HintMode::DontCare,
            fog: HintMode::DontCare,
            generate_mipmap: HintMode::DontCare,
            texture_compression: HintMode::DontCare,
        }
    }
}
