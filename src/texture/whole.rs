//! Samplers that whole runs of a row can do without batches (OpenGL 1.5, sections 3.8.8 and 3.8.9): those whose list of stages
//! comes to one fetch or one linear filter of one image. The list itself tells, so that what is true of it is asked in one
//! place.

use super::filter::{self, linear_rgba8, nearest_rgba8};
use super::lod;
use super::sampler::Sampler;
use super::uniforms::{TexFn, WrappedImage};
use crate::simd::Stage;

/// An image that is filtered linearly, by its dimensions and channels.
#[derive(Clone, Debug)]
pub enum Filtered {
    /// Three channels of a 2D image; alpha is 1.
    Rgb(WrappedImage<2>),
    /// All channels of a 2D image.
    Rgba(WrappedImage<2>),
    /// Three channels of a 3D image; alpha is 1.
    Rgb3d(WrappedImage<3>),
}

impl Filtered {
    /// The image, if it has two dimensions.
    #[must_use]
    pub fn flat(&self) -> Option<&WrappedImage<2>> {
        match self {
            Self::Rgb(image) | Self::Rgba(image) => Some(image),
            Self::Rgb3d(_) => None,
        }
    }
}

impl Sampler {
    /// The images and their wraps, if the sampler does nothing but this stage: on the base level, or where it has
    /// [`Sampler::rho_ranges`] on the one that is known to be the only one.
    fn only<const K: usize>(&self, stage: &Stage<TexFn>, flags: u32) -> Option<WrappedImage<K>> {
        let step = match (self.plan.steps.as_slice(), &self.rho_ranges) {
            ([step], None) => step,
            ([level, step], Some(_)) if level.is(lod::nearest_level_stage(K)) => step,
            // Where one level is all that is read, the second pass and the mix do nothing but bring it to 0..1.
            ([lambda, _, step, _, mix], Some(levels))
                if levels.blends && lambda.is(lod::lambda_stage(K)) && mix.is(&lod::MIX_LEVELS) =>
            {
                step
            }
            _ => return None,
        };
        let wraps = (0..3).fold(filter::PARTIAL, |bits, c| bits | filter::REPEATS << c);
        let this = step.is(stage) && step.arg & !wraps == flags;
        let repeats = std::array::from_fn(|c| step.arg & filter::REPEATS << c != 0);
        this.then(|| WrappedImage { levels: self.uniforms.images.clone(), repeats })
    }

    /// The images and their wraps, if the sampler does nothing but give its nearest texels, packed, by a wrap that
    /// [`NearestWrap`](super::wrap::bounded::NearestWrap) knows.
    #[must_use]
    pub fn copies(&self) -> Option<WrappedImage<2>> {
        self.only(&nearest_rgba8::WRAP_NEAREST_2D_PACKED, 0)
    }

    /// The images and their wraps, if the sampler does nothing but filter one of them linearly, by wraps that
    /// [`LinearWrap`](super::wrap::bounded::LinearWrap) knows.
    #[must_use]
    pub fn filters(&self) -> Option<Filtered> {
        if let Some(image) = self.only(&linear_rgba8::BILINEAR_2D_RGB, linear_rgba8::WRAPS) {
            return Some(Filtered::Rgb(image));
        }
        if let Some(image) = self.only(&linear_rgba8::BILINEAR_2D_RGBA, linear_rgba8::WRAPS) {
            return Some(Filtered::Rgba(image));
        }
        self.only(&linear_rgba8::TRILINEAR_3D_RGB, linear_rgba8::WRAPS).map(Filtered::Rgb3d)
    }
}
