//! Runs of a row, as those of [`fill_linear`](crate::fragment::span::sampled), of programs with two units (OpenGL 1.5, section 3.8.14): a
//! linearly filtered image, of one level or between two, and one without levels whose colour is multiplied with what the
//! first one gives, as light maps are. Every number comes from the same expressions as in the stages of batches, so the bits
//! are the same.

use crate::fragment::lod_bounds::MipRange;
use crate::fragment::plane_eval::{Along, Divisor, Place, Projection};
use crate::fragment::reference::texcoord::unit;
use crate::fragment::span::levels::mixed;
use crate::fragment::span::long::{Part, Parts, SpanShader};
use crate::fragment::span::mip_fraction::Mixing;
use crate::fragment::span::sampled::{Environment, Level, Shown, divided, primary};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::texture::filter::INV_255;
use crate::texture::filter::linear_rgba8::RGB;
use crate::texture::uniforms::WrappedImage;

/// The image by whose texels the colour is multiplied last, and its unit.
#[derive(Clone, Debug)]
pub struct Last {
    /// The unit's index.
    pub unit: u32,
    /// The image.
    pub image: WrappedImage<2>,
}

/// Two images of three channels.
pub(crate) struct TwoImages<'a> {
    shown: &'a Shown,
    first: &'a WrappedImage<2>,
    last: &'a Last,
}

impl<'a> TwoImages<'a> {
    /// Those of a program.
    #[inline(always)]
    pub(crate) fn of(u: &'a FragUniforms) -> Option<Self> {
        let shown = u.shown.as_ref()?;
        Some(Self { shown, first: shown.image.in_2d()?, last: u.last.as_ref()? })
    }
}

impl<'a> Parts<2> for TwoImages<'a> {
    type SpanShader = TwoUnits<'a>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.shown.unit
    }

    #[inline(always)]
    fn source(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, 2>) -> Option<TwoUnits<'a>> {
        let mut environment = Environment::of_run::<RGB, 2>(u, w, &part.segment, part.extent, &part.unit, self.shown)?;
        let (level, between) = match part.reads {
            MipRange::One(level) => (level, None),
            MipRange::Two(level, share) => {
                let levels = u.levels.get(self.shown.unit as usize)?.as_ref()?;
                let mixing = Mixing::new(&part.unit, levels, level, share)?;
                (level, Some((Level::new(self.first, level + 1, &part.unit)?, mixing)))
            }
        };
        let slots = u.layout.units.get(self.last.unit as usize)?.as_ref()?;
        let last_unit = unit::<2>(w, &part.segment, slots, self.last.unit)?;
        let first = Filtered::new(Projection::new(&part.unit, part.extent), self.first, level, &part.unit)?;
        let last = Filtered::new(Projection::new(&last_unit, part.extent), &self.last.image, 0, &last_unit)?;
        let divides = first.form.divides() || last.form.divides();
        let d = environment.divisor(divides, part.unit.planes, part.extent);
        let color = environment.color.take();
        Some(TwoUnits { first, between, color, last, environment, d })
    }
}

/// A level of an image along a run.
struct Filtered<'a> {
    form: Projection<2>,
    repeats: [bool; 2],
    level: Level<'a, 2>,
}

impl<'a> Filtered<'a> {
    #[inline(always)]
    fn new(
        form: Projection<2>,
        image: &'a WrappedImage<2>,
        level: u32,
        unit: &crate::fragment::reference::texcoord::Unit<'_, 2>,
    ) -> Option<Self> {
        Some(Self { form, repeats: image.repeats, level: Level::new(image, level, unit)? })
    }
}

/// What all blocks of a run need.
pub(crate) struct TwoUnits<'a> {
    first: Filtered<'a>,
    /// The level after that, and how much of it.
    between: Option<(Level<'a, 2>, Mixing<2>)>,
    /// Planes by which the first image's colour is multiplied, if it is.
    color: Option<[Along<f32>; 3]>,
    last: Filtered<'a>,
    /// What is left of the environment: alpha.
    environment: Environment,
    /// D, if something is divided by it in `f32`.
    d: Option<Divisor<f32>>,
}

/// Multiplies a channel.
#[inline(always)]
fn times<const N: usize>(channel: &[f32; N], by: &[f32; N]) -> [f32; N] {
    let mut out = [0.0; N];
    for i in 0..N {
        out[i] = channel[i] * by[i];
    }
    out
}

impl SpanShader for TwoUnits<'_> {
    #[inline(always)]
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        let (mut rw, even) = ([1.0; N], self.d.is_none());
        if let Some(d) = &self.d {
            divided(d, place, &mut rw);
        }
        let (first, last) = (&self.first, &self.last);
        let mut texels = [[0.0; N]; 4];
        if let Some((level, mixing)) = &self.between {
            let (coordinates, fractions) = mixing.values(&first.form, place, &rw, &first.repeats);
            let (mut near, mut far) = ([[0.0; N]; 4], [[0.0; N]; 4]);
            first.level.texels::<2, RGB, N>(&coordinates, 1.0, &mut near);
            level.texels::<2, RGB, N>(&coordinates, 1.0, &mut far);
            for c in 0..3 {
                texels[c] = mixed(&near[c], &far[c], &fractions);
            }
        } else {
            let coordinates = first.form.values(place, &rw, &first.repeats);
            first.level.texels::<2, RGB, N>(&coordinates, INV_255, &mut texels);
        }
        if let Some(planes) = &self.color {
            for c in 0..3 {
                texels[c] = times(&texels[c], &primary(&planes[c], place, &rw, even));
            }
        }
        let coordinates = last.form.values(place, &rw, &last.repeats);
        let mut light = [[0.0; N]; 4];
        last.level.texels::<2, RGB, N>(&coordinates, INV_255, &mut light);
        for c in 0..3 {
            texels[c] = times(&texels[c], &light[c]);
        }
        self.environment.pixels::<N, false>(&mut texels, place, &rw, even, out);
    }
}
