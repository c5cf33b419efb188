//! The span shader of linearly filtered 8-bit textures (OpenGL 1.5, sections 3.8.8 and 3.8.13): one description for two and
//! three dimensions, three and four channels, one mipmap level and two, with a light map in a second unit and with blending.
//! Coordinates, wraps, fetch, filter, environment and rounding follow each other block by block, without a batch in between.

use super::environment::Environment;
use super::mip_fraction::MipFraction;
use super::projection::{Projection, range};
use super::shader::{Part, SpanShader, SpanSource};
use crate::fragment::key::LinearTexture;
use crate::fragment::mip_range::MipRange;
use crate::fragment::plane_eval::{Extent, LinearEval, PlaneEval, Positions, reciprocals};
use crate::fragment::planes::Unit;
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::simd::PixelCost;
use crate::texture::filter::linear_rgba8::{self, CHUNK, RGB, RGBA, TexelIndices, TexelPairs};
use crate::texture::filter::{INV_255, lerp};
use crate::texture::uniforms::{MipLevel, WrappedImage};
use crate::texture::wrap::bounded;

/// One mipmap level, and how coordinates are wrapped on it.
struct SampledLevel<'a, const K: usize> {
    wraps: [bounded::LinearWrap; K],
    level: &'a MipLevel,
}

impl<'a, const K: usize> SampledLevel<'a, K> {
    /// A level of an image; `None` where the simple wraps are not enough for the coordinates of a unit.
    #[inline(always)]
    fn new(image: &'a WrappedImage<K>, level: u32, unit: &Unit<'_, K>) -> Option<Self> {
        let (level, repeats) = (image.levels.get(level as usize)?, image.repeats);
        let mut wraps = [bounded::LinearWrap::Clamp; K];
        for k in 0..K {
            let n = level.size[k];
            wraps[k] = bounded::LinearWrap::new(repeats[k], range(unit, &repeats, k)?, n, n)?;
        }
        Some(Self { wraps, level })
    }

    /// The texels at these coordinates, filtered, times k.
    #[inline(always)]
    fn texels<const ROWS: usize, const FORMAT: u8, const N: usize>(
        &self,
        coordinates: &[[f32; N]; K],
        k: f32,
        texels: &mut [[f32; N]; 4],
    ) {
        let (steps, mut at) = ([1, self.level.stride, self.level.slice], TexelIndices([self.level.origin; N]));
        let mut weights = [[0.0; N]; 3];
        for c in 0..K {
            let (n, step) = (self.level.size[c], steps[c]);
            self.wraps[c].run(&coordinates[c], n, n, &mut weights[c], |i, index| {
                at.0[i] = at.0[i].wrapping_add(index.cast_unsigned().wrapping_mul(step));
            });
        }
        let mut rows = [TexelPairs::<N>::NONE; ROWS];
        linear_rgba8::fetch_at(&mut rows, self.level, &at.0);
        let [s, t, r] = &weights;
        for start in (0..N).step_by(CHUNK) {
            let chunk = linear_rgba8::blend::<ROWS, FORMAT, N>(&rows, [s, t, r], start, k);
            for c in 0..4 {
                if let Some(to) = texels[c].get_mut(start..).and_then(|to| to.first_chunk_mut()) {
                    *to = chunk[c];
                }
            }
        }
    }

    /// How many coordinates are more than multiplied.
    fn wraps(&self) -> u64 {
        self.wraps.iter().map(|wrap| u64::from(wrap.wraps())).sum()
    }
}

/// An image and the coordinates at which it is read.
struct SampledImage<'a, const K: usize> {
    projection: Projection<K>,
    repeats: [bool; K],
    level: SampledLevel<'a, K>,
}

impl<'a, const K: usize> SampledImage<'a, K> {
    #[inline(always)]
    fn new(image: &'a WrappedImage<K>, level: u32, unit: &Unit<'_, K>, extent: Extent) -> Option<Self> {
        let projection = Projection::new(unit, extent);
        Some(Self { projection, repeats: image.repeats, level: SampledLevel::new(image, level, unit)? })
    }

    /// What one level costs a pixel.
    fn cost(&self) -> PixelCost {
        let (texels, divisions) = (1 << K, u64::from(self.projection.is_wide()));
        PixelCost { texels, divisions, wraps: self.level.wraps(), ..PixelCost::default() }
    }
}

/// What all blocks of a part need. A filter of K dimensions reads ROWS rows of two texels.
pub struct Sampled<'a, const K: usize, const ROWS: usize, const FORMAT: u8> {
    image: SampledImage<'a, K>,
    /// The next level, and how much of it.
    next: Option<(SampledLevel<'a, K>, MipFraction<K>)>,
    light_map: Option<SampledImage<'a, 2>>,
    /// Planes by which the colour is multiplied before the light map, if there is one.
    color: Option<[PlaneEval<f32>; 3]>,
    environment: Environment,
    /// D, if something is divided by it in `f32`.
    d: Option<LinearEval<f32>>,
}

/// The source of each kind of texture: its dimensions, rows and format.
macro_rules! sources {
    ($($k:literal, $rows:literal, $format:ident;)*) => {$(
        impl<'a> SpanSource<$k> for &'a LinearTexture<$k, $format> {
            type Shader = Sampled<'a, $k, $rows, $format>;

            #[inline(always)]
            fn unit(&self) -> u32 {
                self.unit
            }

            #[inline(always)]
            fn shader(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, $k>) -> Option<Self::Shader> {
                Sampled::new(self, u, w, part)
            }
        }
    )*};
}
sources! {
    2, 2, RGB;
    2, 2, RGBA;
    3, 4, RGB;
}

impl<'a, const K: usize, const ROWS: usize, const FORMAT: u8> Sampled<'a, K, ROWS, FORMAT> {
    #[inline(always)]
    fn new(
        texture: &'a LinearTexture<K, FORMAT>,
        u: &FragUniforms,
        w: &Work<'_, '_>,
        part: &Part<'_, K>,
    ) -> Option<Self> {
        let Part { segment, extent, unit, levels } = part;
        let mut environment = Environment::new(u, w, (segment, *extent, unit.planes), texture)?;
        let (level, next) = match levels {
            MipRange::One(level) => (*level, None),
            MipRange::Two(level, weight) => {
                let limits = u.levels.get(texture.unit as usize)?.as_ref()?;
                let fraction = MipFraction::new(unit, limits, *level, *weight)?;
                (*level, Some((SampledLevel::new(&texture.image, level + 1, unit)?, fraction)))
            }
        };
        let image = SampledImage::new(&texture.image, level, unit, *extent)?;
        let (mut light_map, mut color, mut divides) = (None, None, image.projection.divides());
        if let Some(light) = texture.light_map.as_ref().filter(|_| FORMAT == RGB) {
            let slots = u.layout.units.get(light.unit as usize)?.as_ref()?;
            let unit = w.unit::<2>(segment, slots, light.unit)?;
            let image = SampledImage::new(&light.image, 0, &unit, *extent)?;
            divides |= image.projection.divides();
            light_map = Some(image);
        }
        let d = environment.divisor(divides, unit.planes, *extent);
        if light_map.is_some() {
            color = environment.color.take();
        }
        Some(Self { image, next, light_map, color, environment, d })
    }
}

impl<const K: usize, const ROWS: usize, const FORMAT: u8> SpanShader for Sampled<'_, K, ROWS, FORMAT> {
    #[inline(always)]
    fn blends(&self) -> bool {
        self.environment.blends()
    }

    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, below: &[u32; N], out: &mut [u32; N]) {
        let (mut rw, even) = ([1.0; N], self.d.is_none());
        if let Some(d) = &self.d {
            rw = reciprocals(d, at);
        }
        let SampledImage { projection, repeats, level } = &self.image;
        let mut texels = [[0.0; N]; 4];
        if let Some((next, fraction)) = &self.next {
            let (coordinates, fractions) = fraction.values(projection, at, &rw, repeats);
            let mut far = [[0.0; N]; 4];
            level.texels::<ROWS, FORMAT, N>(&coordinates, 1.0, &mut texels);
            next.texels::<ROWS, FORMAT, N>(&coordinates, 1.0, &mut far);
            for c in 0..3 {
                texels[c] = mixed(&texels[c], &far[c], &fractions);
            }
            texels[3] = if FORMAT == RGB { [1.0; N] } else { mixed(&texels[3], &far[3], &fractions) };
        } else {
            let coordinates = projection.values(at, &rw, repeats);
            level.texels::<ROWS, FORMAT, N>(&coordinates, INV_255, &mut texels);
        }
        if FORMAT == RGB
            && let Some(light) = &self.light_map
        {
            if let Some(planes) = &self.color {
                for c in 0..3 {
                    texels[c] = product(&texels[c], &planes[c].at(at, &rw, even));
                }
            }
            let coordinates = light.projection.values(at, &rw, &light.repeats);
            let mut factor = [[0.0; N]; 4];
            light.level.texels::<2, RGB, N>(&coordinates, INV_255, &mut factor);
            for c in 0..3 {
                texels[c] = product(&texels[c], &factor[c]);
            }
        }
        self.environment.pixels(&mut texels, at, (&rw, even), below, out);
    }

    fn cost(&self) -> PixelCost {
        let mut cost = self.image.cost();
        if let Some((next, fraction)) = &self.next {
            cost.texels *= 2;
            cost.wraps += next.wraps();
            cost.logarithms = fraction.logarithms();
        }
        if let Some(light) = &self.light_map {
            cost += light.cost();
        }
        cost.divisions += u64::from(self.d.is_some());
        cost
    }
}

/// A channel of two levels, mixed and brought to 0..=1.
#[inline(always)]
fn mixed<const N: usize>(near: &[f32; N], far: &[f32; N], fractions: &[f32; N]) -> [f32; N] {
    let mut out = [0.0; N];
    for i in 0..N {
        out[i] = lerp(near[i], far[i], fractions[i]) * INV_255;
    }
    out
}

/// A channel multiplied with another one.
#[inline(always)]
fn product<const N: usize>(channel: &[f32; N], by: &[f32; N]) -> [f32; N] {
    let mut out = [0.0; N];
    for i in 0..N {
        out[i] = channel[i] * by[i];
    }
    out
}
