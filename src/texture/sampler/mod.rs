//! Samplers (OpenGL 1.5, sections 3.8.7 to 3.8.9): from the state of a complete texture object to the list of stages that
//! turn texture coordinates into a filtered colour. Only what the state needs is in the list: no derivatives and no level
//! of detail where the level cannot differ, no filter for channels that the format does not have.

mod builder;

use super::batch::TexBatch;
use super::format::BaseFormat;
use super::image::Image;
use super::object::TextureObject;
use super::padding::PaddingKey;
use super::rho_ranges::RhoRanges;
use super::uniforms::{LinearImage, SamplerUniforms, TexFn, WrappedImage, level_range};
use super::wrap;
use crate::error::Outcome;
use crate::simd::{Level, Plan, Stage, Step};
use crate::state::texture::Target;

/// What a sampler has to be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplerNeeds {
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

/// What a sampler comes to as a whole. All but [`General`](SamplerKind::General) read one image without borders, which
/// spans of a row can do without batches: of the base level or, where the sampler has [`Sampler::rho_ranges`], of one
/// level that rho is known to select. Each coordinate is wrapped by REPEAT where its flag is set, by CLAMP or
/// CLAMP_TO_EDGE where it is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplerKind {
    /// The nearest texel of 8-bit 2D images, left packed ([`Sampler::pack`]).
    NearestPacked([bool; 2]),
    /// LINEAR in three channels of 8-bit 2D images; alpha is 1.
    LinearRgb([bool; 2]),
    /// LINEAR in all channels of 8-bit 2D images.
    LinearRgba([bool; 2]),
    /// LINEAR in three channels of 8-bit 3D images; alpha is 1.
    LinearRgb3d([bool; 3]),
    /// Anything else: only the stages tell.
    General,
}

/// The stages that sample one texture, with the numbers and images that they read.
#[derive(Clone, Debug)]
pub struct Sampler {
    /// The stages in order.
    pub plan: Plan<TexFn>,
    /// What they read.
    pub uniforms: SamplerUniforms,
    /// What they have to be given.
    pub needs: SamplerNeeds,
    /// The base format as environments see it: that of the texture, or for a depth texture its DEPTH_TEXTURE_MODE.
    pub base: BaseFormat,
    /// Whether lambda is worked out once a batch where derivatives are the same in all lanes.
    pub once: bool,
    /// The levels of a filter that may get one level instead of derivatives ([`Derivatives::OneLevel`](super::batch::Derivatives)).
    pub rho_ranges: Option<RhoRanges>,
    /// The steps that are run once for each tap of an anisotropic filter: start and end in the plan.
    pub taps: Option<(usize, usize)>,
    /// Whether alpha is not filtered although the format has it: it is 255 in every texel.
    pub opaque: bool,
    /// Whether the filter stage wraps the coordinates too.
    pub wraps: bool,
    /// What the stages come to.
    pub kind: SamplerKind,
    /// Where the last stage reads the nearest texel of 8-bit images: how to read it packed.
    packed: Option<Packed>,
}

/// The last stage of a sampler of nearest texels that leaves them packed.
#[derive(Clone, Debug)]
struct Packed {
    stage: &'static Stage<TexFn>,
    arg: u32,
    kind: SamplerKind,
}

/// Fills the rings of the images that sampling reads, for the wraps and the border colour of the object. To be called
/// before a draw when the object has changed; costs little when nothing is to be done.
pub fn prepare(object: &mut TextureObject) -> Outcome {
    let key =
        PaddingKey::new(object.parameters.wrap.map(|mode| wrap::row(mode).padding), object.parameters.border_color);
    let (base, last) = level_range(object);
    for face in &mut object.faces {
        for image in face.iter_mut().skip(base).take(last - base + 1).flatten() {
            if !image.is_padded_for(&key) {
                Image::writable(image)?.fill_padding(&key)?;
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
    #[cfg(test)]
    pub fn build(level: Level, object: &TextureObject, unit_bias: f32, unit: usize) -> Self {
        Self::build_with(level, object, unit_bias, unit, false)
    }

    /// [`Sampler::build`]; with `general` nothing is left out that could be: lambda is worked out and levels are chosen
    /// whatever the limits, and all four channels are filtered. The bits are the same.
    #[must_use]
    pub fn build_with(level: Level, object: &TextureObject, unit_bias: f32, unit: usize, general: bool) -> Self {
        builder::build(level, object, unit_bias, unit, general)
    }

    /// Makes the sampler write packed texels (`packed` of the batch) and nothing else, if each of its texels is one 8-bit
    /// texel of an image; says whether it is so.
    pub fn pack(&mut self) -> bool {
        let Some(Packed { stage, arg, kind }) = self.packed else { return false };
        self.plan.steps.pop();
        self.plan.push(stage, arg);
        self.kind = kind;
        true
    }

    /// The images with their wraps, if the sampler leaves their nearest texels packed and does nothing else.
    #[must_use]
    pub fn nearest_image(&self) -> Option<WrappedImage<2>> {
        match self.kind {
            SamplerKind::NearestPacked(repeats) => Some(self.wrapped(repeats)),
            _ => None,
        }
    }

    /// The images with their wraps, if the sampler filters one of them linearly and does nothing else.
    #[must_use]
    pub fn linear_image(&self) -> Option<LinearImage> {
        match self.kind {
            SamplerKind::LinearRgb(repeats) => Some(LinearImage::Rgb(self.wrapped(repeats))),
            SamplerKind::LinearRgba(repeats) => Some(LinearImage::Rgba(self.wrapped(repeats))),
            SamplerKind::LinearRgb3d(repeats) => Some(LinearImage::Rgb3d(self.wrapped(repeats))),
            SamplerKind::NearestPacked(_) | SamplerKind::General => None,
        }
    }

    fn wrapped<const K: usize>(&self, repeats: [bool; K]) -> WrappedImage<K> {
        WrappedImage { levels: self.uniforms.images.clone(), repeats }
    }

    /// Samples all lanes of a batch: reads coordinates and derivatives, writes the texel of the unit.
    pub fn run(&self, batch: &mut TexBatch) {
        batch.scratch.same = [Some(0); 2];
        batch.scratch.two_levels = false;
        let steps = &self.plan.steps;
        let Some((start, end)) = self.taps else { return self.run_steps(batch, steps) };
        let (before, rest) = steps.split_at(start.min(steps.len()));
        let (each, after) = rest.split_at((end.saturating_sub(start)).min(rest.len()));
        batch.scratch.taps = 1;
        self.run_steps(batch, before);
        for tap in 1..=batch.scratch.taps {
            batch.scratch.tap = tap;
            self.run_steps(batch, each);
        }
        self.run_steps(batch, after);
    }

    fn run_steps(&self, batch: &mut TexBatch, steps: &[Step<TexFn>]) {
        for step in steps {
            #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
            unsafe {
                (step.run())(batch, &self.uniforms, step.arg);
            }
        }
    }
}
