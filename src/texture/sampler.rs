//! Samplers (OpenGL 1.5, sections 3.8.7 to 3.8.9): from the state of a complete texture object to the list of stages that
//! turn texture coordinates into a filtered colour. Only what the state needs is in the list: no derivatives and no level
//! of detail where the level cannot differ, no filter for channels that the format does not have.

use super::batch::TexBatch;
use super::format::BaseFormat;
use super::object::TextureObject;
use super::pads::PadKey;
use super::uniforms::{TexFn, UnitUniforms, is_mipmap_filter, level_range};
use super::{address, filter};
use crate::batch::{Level, Plan};
use crate::enums::*;
use crate::error::Outcome;
use crate::state::texture::Target;
use std::sync::Arc;

/// What a sampler wants to be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// How many of s, t, r it reads.
    pub coordinates: usize,
    /// Whether it reads their derivatives.
    pub derivatives: bool,
    /// Whether s, t, r are a direction (cube maps), so that q plays no part.
    pub cube: bool,
    /// For each coordinate the whole number that may be taken off: 0 none, 1 or 2.
    pub period: [u8; 3],
    /// Size of the base level in texels; 1 where the coordinate is not one of texels.
    pub size: [u32; 3],
}

/// The stages that sample one texture, with the numbers and images that they read.
#[derive(Clone, Debug)]
pub struct Sampler {
    /// The stages in order.
    pub plan: Plan<TexFn>,
    /// What they read.
    pub uniforms: UnitUniforms,
    /// What they want.
    pub needs: Needs,
    /// The base format as environments see it: that of the texture, or for a depth texture its DEPTH_TEXTURE_MODE.
    pub base: BaseFormat,
    /// The steps that are run once for each tap of an anisotropic filter: start and end in the plan.
    pub taps: Option<(usize, usize)>,
}

/// Fills the rings of the images that sampling reads, for the wraps and the border colour of the object. To be called
/// before a draw when the object has changed; costs little when nothing is to be done.
pub fn prepare(object: &mut TextureObject) -> Outcome {
    let key = PadKey::new(object.parameters.wrap, object.parameters.border_color);
    let (base, last) = level_range(object);
    for face in &mut object.faces {
        for image in face.iter_mut().skip(base).take(last - base + 1).flatten() {
            if !image.pads_are(&key) {
                Arc::make_mut(image).fill_pads(&key)?;
            }
        }
    }
    Ok(())
}

/// How many coordinates address the texels of a target.
#[must_use]
pub fn dimensions(target: Target) -> usize {
    match target {
        Target::D1 => 1,
        Target::D2 | Target::Rectangle | Target::Cube => 2,
        Target::D3 => 3,
    }
}

impl Sampler {
    /// The sampler of a complete texture object whose rings are filled ([`prepare`]), for a unit with this LOD bias.
    #[must_use]
    pub fn build(level: Level, object: &TextureObject, unit_bias: f32, unit: usize) -> Self {
        let p = &object.parameters;
        let uniforms = UnitUniforms::new(object, unit_bias, unit);
        let dims = dimensions(object.target);
        let format = uniforms.images.first().map_or(BaseFormat::Rgba, |image| image.image.base);
        let mut plan = Plan::new(level);
        let _ = is_mipmap_filter(p.min_filter);
        for (c, &wrap) in p.wrap.iter().enumerate().take(dims) {
            let (linear, nearest) = address::stages(wrap);
            plan.push(if p.mag_filter == GL_LINEAR { linear } else { nearest }, c as u32);
        }
        plan.push(if p.mag_filter == GL_LINEAR { filter::linear(dims, format) } else { filter::nearest(dims) }, 0);
        let size = uniforms.size;
        let needs = Needs {
            coordinates: dims,
            derivatives: false,
            cube: false,
            period: std::array::from_fn(|c| if c < dims { address::period(p.wrap[c]) } else { 0 }),
            size: std::array::from_fn(|c| if c < dims { size[c] as u32 } else { 1 }),
        };
        Self { plan, uniforms, needs, base: format, taps: None }
    }

    /// Samples all lanes of a batch: reads coordinates and derivatives, writes the texel of the unit.
    pub fn run(&self, batch: &mut TexBatch) {
        batch.work.same = [Some(0); 2];
        batch.work.two_levels = false;
        for step in &self.plan.steps {
            #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
            unsafe {
                (step.run)(batch, &self.uniforms, step.arg);
            }
        }
    }
}
