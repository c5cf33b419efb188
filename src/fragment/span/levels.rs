//! Runs of a row, as those of [`fill_linear`](crate::fragment::span::sampled), of which two levels of one image are blended (OpenGL 1.5,
//! section 3.8.8, *_MIPMAP_LINEAR): limits of rho have told which two. The derivatives, the fraction of lambda, both levels'
//! texels and their mix follow each other block by block. Every number comes from the same expressions as in the stages of
//! batches, so the bits are the same.

use crate::fragment::lod_bounds::MipRange;
use crate::fragment::plane_eval::{Divisor, Place, Projection};
use crate::fragment::span::long::{Part, Parts, SpanShader};
use crate::fragment::span::mip_fraction::Mixing;
use crate::fragment::span::sampled::{Environment, Level, Shown, divided};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::texture::filter::linear_rgba8::RGB;
use crate::texture::filter::{INV_255, lerp};
use crate::texture::uniforms::WrappedImage;

/// Between two levels of a 2D image.
pub(crate) struct Between<'a, const FORMAT: u8>(&'a Shown, &'a WrappedImage<2>);

impl<'a, const FORMAT: u8> Between<'a, FORMAT> {
    /// The image that is shown.
    #[inline(always)]
    pub(crate) fn of(shown: &'a Shown) -> Option<Self> {
        Some(Self(shown, shown.image.in_2d()?))
    }
}

impl<'a, const FORMAT: u8> Parts<2> for Between<'a, FORMAT> {
    type SpanShader = TwoLevels<'a, FORMAT>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.0.unit
    }

    #[inline(always)]
    fn source(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, 2>) -> Option<Self::SpanShader> {
        let Part { segment, extent, unit, reads } = part;
        let &MipRange::Two(first, share) = reads else { return None };
        let environment = Environment::of_run::<FORMAT, 2>(u, w, segment, *extent, unit, self.0)?;
        let mixing = Mixing::new(unit, u.levels.get(self.0.unit as usize)?.as_ref()?, first, share)?;
        let levels = [Level::new(self.1, first, unit)?, Level::new(self.1, first + 1, unit)?];
        let form = Projection::new(unit, *extent);
        let d = environment.divisor(form.divides(), unit.planes, *extent);
        Some(TwoLevels { form, repeats: self.1.repeats, levels, mixing, environment, d })
    }
}

/// What all blocks of a run need.
pub(crate) struct TwoLevels<'a, const FORMAT: u8> {
    form: Projection<2>,
    repeats: [bool; 2],
    levels: [Level<'a, 2>; 2],
    mixing: Mixing<2>,
    environment: Environment,
    /// D, if something is divided by it in `f32`.
    d: Option<Divisor<f32>>,
}

/// A channel of two levels, mixed and brought to 0..=1.
#[inline(always)]
pub(crate) fn mixed<const N: usize>(near: &[f32; N], far: &[f32; N], fractions: &[f32; N]) -> [f32; N] {
    let mut out = [0.0; N];
    for i in 0..N {
        out[i] = lerp(near[i], far[i], fractions[i]) * INV_255;
    }
    out
}

impl<const FORMAT: u8> SpanShader for TwoLevels<'_, FORMAT> {
    #[inline(always)]
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        let mut rw = [1.0; N];
        if let Some(d) = &self.d {
            divided(d, place, &mut rw);
        }
        let (coordinates, fractions) = self.mixing.values(&self.form, place, &rw, &self.repeats);
        let (mut near, mut far) = ([[0.0; N]; 4], [[0.0; N]; 4]);
        self.levels[0].texels::<2, FORMAT, N>(&coordinates, 1.0, &mut near);
        self.levels[1].texels::<2, FORMAT, N>(&coordinates, 1.0, &mut far);
        let mix = |c: usize| mixed(&near[c], &far[c], &fractions);
        let mut texels = [mix(0), mix(1), mix(2), if FORMAT == RGB { [1.0; N] } else { mix(3) }];
        self.environment.pixels::<N, false>(&mut texels, place, &rw, self.d.is_none(), out);
    }
}
