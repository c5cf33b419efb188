//! What the fragment stages are told: the numbers of the state, already in the form in which the stages use them. Which
//! stages run is the program's matter; nothing here selects code apart from table indices.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::planes::{Layout, PlanePool, Planes};
use crate::fragment::span::nearest::Copied;
use crate::fragment::span::sampled::Shown;
use crate::fragment::span::two_units::Last;
use crate::framebuffer::Band;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::color_buffer::{BlendEquation, BlendFactor};
use crate::state::depth_stencil::StencilOp;
use crate::texture::rho_ranges::RhoRanges;

/// The numbers behind a program.
#[derive(Clone, Debug, Default)]
pub struct FragUniforms {
    /// Which slot holds what.
    pub layout: Layout,
    /// For each unit the levels of a filter that may do without derivatives.
    pub levels: [Option<RhoRanges>; MAX_TEXTURE_UNITS],
    /// The largest depth value, as a float.
    pub depth_max: f64,
    /// Bits that are set in every packed pixel: alpha where the format has none.
    pub packed_or: u32,
    /// Bits of a packed pixel that may be written.
    pub color_mask: u32,
    /// What the store's unit is: 255 for bytes, 1 for floats.
    pub scale: f32,
    /// The largest value that blending may give: 255 for bytes; floats have no limit.
    pub limit: f32,
    /// The alpha test's reference value in [0, 1].
    pub alpha_ref: f32,
    /// The fog's colour.
    pub fog_color: [f32; 3],
    /// Density of exponential fog, 1 / (end - start) of linear fog.
    pub fog_scale: f32,
    /// Where linear fog ends.
    pub fog_end: f32,
    /// The stencil test.
    pub stencil: StencilUniforms,
    /// Blending.
    pub blend: BlendUniforms,
    /// Which texels a program copies that does nothing else with textures, and no more to colours.
    pub copied: Option<Copied>,
    /// What a program shows that does nothing with textures but to filter one image.
    pub shown: Option<Shown>,
    /// What its colour is multiplied with at the end, by a program with two units.
    pub last: Option<Last>,
}

/// The numbers of the stencil test.
#[derive(Clone, Copy, Debug, Default)]
pub struct StencilUniforms {
    /// Reference value, limited to a byte.
    pub reference: u32,
    /// Which bits are compared.
    pub value_mask: u32,
    /// Which bits are written.
    pub write_mask: u32,
    /// Operation where the stencil test fails.
    pub fail: StencilOp,
    /// Operation where the depth test fails.
    pub depth_fail: StencilOp,
    /// Operation where both pass.
    pub pass: StencilOp,
}

/// The numbers of blending.
#[derive(Clone, Copy, Debug, Default)]
pub struct BlendUniforms {
    /// SpanShader factors of RGB and alpha.
    pub src: [BlendFactor; 2],
    /// Destination factors of RGB and alpha.
    pub dst: [BlendFactor; 2],
    /// The equation.
    pub equation: BlendEquation,
    /// The constant colour.
    pub color: [f32; 4],
}

/// What a stage works with besides the batch: the primitives of the scene and the rows of the framebuffer.
#[derive(Debug)]
pub struct Work<'a, 'b> {
    /// What fragments need to know of each primitive.
    pub planes: &'a [Planes],
    /// The planes of the primitives' slots.
    pub pool: PlanePool<'a>,
    /// The rows that are drawn into.
    pub band: &'a mut Band<'b>,
}

/// A fragment stage.
pub type FragFn = for<'a, 'b> unsafe fn(&mut FragmentBatch, &FragUniforms, &mut Work<'a, 'b>, u32);
