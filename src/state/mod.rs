//! The state of the machine as data: one struct for each group of the state tables (OpenGL 1.5, chapter 6.2), whose
//! `Default` is the initial state. Nothing here is derived from anything else, so a group can be cloned by
//! `glPushAttrib` and put back as it was. Commands change a group through `Engine`, which marks what a change makes
//! stale ([`Dirty`]); plans and uniforms are built from the groups when something is drawn.

pub mod color_buffer;
pub mod compare;
pub mod current;
pub mod depth_stencil;
pub mod eval;
pub mod fog;
pub mod imaging;
pub mod lighting;
pub mod per_unit;
pub mod pixel;
pub mod pixel_maps;
pub mod primitive;
pub mod raster;
pub mod texture;
pub mod transform;

/// Every group of state that belongs to a context, apart from objects (textures, buffers, lists) and client state.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// Current values and associated data (table 6.5).
    pub current: current::Current,
    /// Transformation state (table 6.7).
    pub transform: transform::Transform,
    /// Viewport and depth range (table 6.7).
    pub viewport: transform::Viewport,
    /// Fog, colour sum (table 6.8).
    pub fog: fog::Fog,
    /// Lighting, materials, shade model (tables 6.8 to 6.11).
    pub lighting: lighting::Lighting,
    /// Points (table 6.12).
    pub point: raster::Point,
    /// Lines (table 6.12).
    pub line: raster::Line,
    /// Polygons (table 6.13).
    pub polygon: raster::Polygon,
    /// Polygon stipple pattern (table 6.13), a group of its own in the attribute stack.
    pub polygon_stipple: raster::PolygonStipple,
    /// Multisampling (table 6.14).
    pub multisample: raster::Multisample,
    /// Texture units: enables, bindings, environment, generation (tables 6.15, 6.18, 6.19).
    pub texture: texture::TextureState,
    /// Scissor (table 6.20).
    pub scissor: color_buffer::Scissor,
    /// Alpha test, blending, logic op, masks, clear values (tables 6.20, 6.21).
    pub color_buffer: color_buffer::ColorBuffer,
    /// Depth test (table 6.20).
    pub depth: depth_stencil::Depth,
    /// Stencil test (table 6.20).
    pub stencil: depth_stencil::Stencil,
    /// Accumulation buffer (table 6.21).
    pub accum: color_buffer::Accum,
    /// Pixel transfer and zoom (tables 6.22, 6.23).
    pub pixel: pixel::Pixel,
    /// Pixel maps (table 6.24), in no attribute group.
    pub pixel_maps: pixel_maps::PixelMaps,
    /// Evaluators (table 6.22).
    pub eval: eval::Eval,
    /// Their maps, in no attribute group.
    pub eval_maps: eval::EvalMaps,
    /// Hints (table 6.26).
    pub hint: raster::Hint,
    /// Base of `glCallLists` (table 6.27).
    pub list_base: u32,
}

/// What a change of state makes stale. Drawing rebuilds the stale part before it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dirty {
    /// The vertex plan and its uniforms: matrices, lighting, texture generation, fog coordinate.
    pub vertex: bool,
    /// The fragment plan and its uniforms: textures, environment, tests, blending, masks.
    pub fragment: bool,
    /// Viewport, culling, offset, polygon modes, sizes.
    pub raster: bool,
}

impl Default for Dirty {
    fn default() -> Self {
        Self::ALL
    }
}

impl Dirty {
    /// Everything is stale.
    pub const ALL: Self = Self { vertex: true, fragment: true, raster: true };
    /// Nothing is stale.
    pub const NONE: Self = Self { vertex: false, fragment: false, raster: false };

    /// Makes stale what `other` says, too.
    pub const fn add(&mut self, other: Self) {
        self.vertex |= other.vertex;
        self.fragment |= other.fragment;
        self.raster |= other.raster;
    }

    /// Whether anything is stale.
    #[must_use]
    pub const fn any(self) -> bool {
        self.vertex || self.fragment || self.raster
    }
}
