//! Runs of a row, of any length, of programs that test depth and store what the environment of one linearly filtered 8-bit
//! image gives (OpenGL 1.5, sections 3.8.8 and 3.8.13): what [`fill`](crate::fragment::span::long) does for interpolated colours. Coordinates,
//! wraps, fetch, filter, environment, rounding and store follow each other block by block, without a batch in between. Every
//! number comes from the same expressions as in the stages of batches, so the bits are the same.

use crate::fragment::batch::Segment;
use crate::fragment::lod_bounds::MipRange;
use crate::fragment::plane_eval::{Along, Divisor, Extent, Place, Projection, Terms, range};
use crate::fragment::planes::{Plane, Planes};
use crate::fragment::reference::blend::pair;
use crate::fragment::reference::env_pack::Step;
use crate::fragment::reference::interpolate::primitive;
use crate::fragment::reference::pack::{whole, whole_pixel};
use crate::fragment::reference::texcoord::Unit;
use crate::fragment::span::long::{Part, Parts, SpanShader};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::texture::filter::INV_255;
use crate::texture::filter::linear_rgba8::{self, CHUNK, RGB, TexelIndices, TexelPairs};
use crate::texture::uniforms::LinearImage;
use crate::texture::uniforms::{MipLevel, WrappedImage};
use crate::texture::wrap::bounded;

/// What a program does that filters one image: which, of which unit, and what the environment does with colour and alpha.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The unit's index.
    pub unit: u32,
    /// The image.
    pub image: LinearImage,
    /// What becomes of the colour, and of alpha.
    pub(crate) steps: [Step; 2],
    /// The number of the pair of factors by which the outcome is blended, if it is.
    pub(crate) blend: Option<u32>,
}

/// Where a channel comes from besides the texel.
#[derive(Clone, Copy)]
enum Primary {
    /// From nowhere: the texel stays as it is.
    Texel,
    /// The texel is multiplied with the primary colour.
    Product(Along<f32>),
    /// The primary colour takes its place.
    Stays(Along<f32>),
    /// It is the same in all of the run, and among the bits that are set in each pixel.
    Constant,
}

/// What the environment makes of texels along a row.
pub(crate) struct Environment {
    /// Planes by which red, green and blue are multiplied, if they are.
    pub(crate) color: Option<[Along<f32>; 3]>,
    alpha: Primary,
    /// Bits that are set in each pixel.
    or: u32,
    /// The number of the pair of factors that it is blended by, if it is, and the unit of the store.
    blend: Option<(u32, f32)>,
}

/// An image that is filtered along a row.
pub(crate) struct Level<'a, const K: usize> {
    wraps: [bounded::LinearWrap; K],
    level: &'a MipLevel,
}

impl<'a, const K: usize> Level<'a, K> {
    /// A level of an image; `None` where the simple wraps are not enough for the coordinates of a unit.
    #[inline(always)]
    pub(crate) fn new(image: &'a WrappedImage<K>, level: u32, unit: &Unit<'_, K>) -> Option<Self> {
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
    pub(crate) fn texels<const ROWS: usize, const FORMAT: u8, const N: usize>(
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
        for start in (0..N).step_by(CHUNK) {
            let [s, t, r] = &weights;
            let chunk = linear_rgba8::blend::<ROWS, FORMAT, N>(&rows, [s, t, r], start, k);
            for c in 0..4 {
                if let Some(to) = texels[c].get_mut(start..).and_then(|to| to.first_chunk_mut()) {
                    *to = chunk[c];
                }
            }
        }
    }
}

/// What all blocks of a run need.
pub(crate) struct Linear<'a, const K: usize, const ROWS: usize, const FORMAT: u8, const BLENDED: bool> {
    form: Projection<K>,
    repeats: [bool; K],
    level: Level<'a, K>,
    environment: Environment,
    /// D, if something is divided by it in `f32`.
    d: Option<Divisor<f32>>,
}

/// 1 / D.
#[inline(always)]
pub(crate) fn divided<const N: usize>(d: &Divisor<f32>, place: impl Place<N>, rw: &mut [f32; N]) {
    for i in 0..N {
        rw[i] = 1.0 / place.sum(d, i);
    }
}

/// The values of a plane from x on; `rw` is 1 / D, or 1 where `even` says that w is the same everywhere.
#[inline(always)]
pub(crate) fn primary<const N: usize>(p: &Along<f32>, place: impl Place<N>, rw: &[f32; N], even: bool) -> [f32; N] {
    let mut out = [0.0; N];
    if even {
        for i in 0..N {
            out[i] = p.even(place, i);
        }
    } else {
        for i in 0..N {
            out[i] = p.divided(place, i, rw[i]);
        }
    }
    out
}

impl Environment {
    /// What the steps come to with these planes of the primary colour, in a row if there is one.
    #[inline(always)]
    fn new<const FORMAT: u8>(
        shown: &Shown,
        planes: Option<&[Plane; 4]>,
        row: Option<f32>,
        (scale, or): (f32, u32),
    ) -> Option<Self> {
        let ([color, alpha], blend) = (shown.steps, shown.blend.map(|number| (number, scale)));
        let channels = match color {
            Step::Texel => None,
            Step::Product => {
                let [r, g, b, _] = planes?;
                // A product with 1 is what it was.
                let white = [r, g, b].iter().all(|p| p.min == 1.0 && p.max == 1.0);
                (!white).then(|| [Along::new(r, row), Along::new(g, row), Along::new(b, row)])
            }
            Step::Stays => return None,
        };
        // The texel's alpha is exactly 1 where it is not filtered.
        let one = FORMAT == RGB;
        let (alpha, constant) = match alpha {
            Step::Texel if one => (Primary::Constant, 1.0),
            Step::Texel => (Primary::Texel, 0.0),
            step => {
                let a = &planes?[3];
                let known = a.min == a.max;
                match step {
                    Step::Product if !one && a.min == 1.0 && known => (Primary::Texel, 0.0),
                    Step::Product if !one => (Primary::Product(Along::new(a, row)), 0.0),
                    _ if known => (Primary::Constant, a.max),
                    _ => (Primary::Stays(Along::new(a, row)), 0.0),
                }
            }
        };
        if blend.is_some() {
            let alpha = if let Primary::Constant = alpha { Primary::Stays(Along::constant(constant)) } else { alpha };
            return Some(Self { color: channels, alpha, or, blend });
        }
        Some(Self { color: channels, alpha, or: or | whole(255.0 * constant) << 24, blend })
    }

    /// [`Environment::new`] for a part of a primitive; `None` as well where something is interpolated that needs `f64`.
    #[inline(always)]
    pub(crate) fn of_run<const FORMAT: u8, const K: usize>(
        u: &FragUniforms,
        w: &Work<'_, '_>,
        segment: &Segment,
        extent: Extent,
        unit: &Unit<'_, K>,
        shown: &Shown,
    ) -> Option<Self> {
        let colors = u.layout.color.and_then(|slot| primitive::<4>(w, segment, slot)).map(|(_, planes)| planes);
        let environment = Self::new::<FORMAT>(shown, colors, extent.row(), (u.scale, u.packed_or))?;
        let wide = environment.interpolates() && unit.planes.wide & Planes::WIDE_W != 0;
        (!wide).then_some(environment)
    }

    /// D, if coordinates (`divides`) or what is interpolated here are divided by it in `f32`.
    #[inline(always)]
    pub(crate) fn divisor(&self, divides: bool, planes: &Planes, extent: Extent) -> Option<Divisor<f32>> {
        ((divides || self.interpolates()) && !planes.affine).then(|| Terms::new(&planes.d, extent.row()))
    }

    /// Whether it reads planes that are interpolated.
    fn interpolates(&self) -> bool {
        self.color.is_some() || matches!(self.alpha, Primary::Product(_) | Primary::Stays(_))
    }

    /// The pixels of texels in 0..=1; `rw` is 1 / D, or 1 where `even` says that w is the same everywhere.
    #[inline(always)]
    pub(crate) fn pixels<const N: usize, const BLENDED: bool>(
        &self,
        texels: &mut [[f32; N]; 4],
        place: impl Place<N>,
        rw: &[f32; N],
        even: bool,
        out: &mut [u32; N],
    ) {
        let [r, g, b, a] = texels;
        match &self.alpha {
            Primary::Texel => {}
            Primary::Product(plane) => {
                let so_far = primary(plane, place, rw, even);
                for i in 0..N {
                    a[i] *= so_far[i];
                }
            }
            Primary::Stays(plane) => *a = primary(plane, place, rw, even),
            Primary::Constant => *a = [0.0; N],
        }
        let or = self.or;
        if BLENDED && let Some((number, scale)) = self.blend {
            if let Some([red, green, blue]) = &self.color {
                for (channel, plane) in [r, g, b].into_iter().zip([red, green, blue]) {
                    let so_far = primary(plane, place, rw, even);
                    for i in 0..N {
                        channel[i] *= so_far[i];
                    }
                }
            }
            let dst = *out;
            return pair(texels, &dst, (scale, or), out, number);
        }
        if let Some([red, green, blue]) = &self.color {
            let red = primary(red, place, rw, even);
            let green = primary(green, place, rw, even);
            let blue = primary(blue, place, rw, even);
            for i in 0..N {
                let (r, g, b) = (r[i] * red[i], g[i] * green[i], b[i] * blue[i]);
                out[i] = whole_pixel(255.0 * r, 255.0 * g, 255.0 * b, 255.0 * a[i]) | or;
            }
        } else {
            for i in 0..N {
                out[i] = whole_pixel(255.0 * r[i], 255.0 * g[i], 255.0 * b[i], 255.0 * a[i]) | or;
            }
        }
    }
}

/// Two dimensions.
pub(crate) struct Flat<'a, const FORMAT: u8, const BLENDED: bool>(&'a Shown, &'a WrappedImage<2>);

impl<'a, const FORMAT: u8, const BLENDED: bool> Flat<'a, FORMAT, BLENDED> {
    /// The image that is shown.
    #[inline(always)]
    pub(crate) fn of(shown: &'a Shown) -> Option<Self> {
        Some(Self(shown, shown.image.in_2d()?))
    }
}

impl<'a, const FORMAT: u8, const BLENDED: bool> Parts<2> for Flat<'a, FORMAT, BLENDED> {
    type SpanShader = Linear<'a, 2, 2, FORMAT, BLENDED>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.0.unit
    }

    #[inline(always)]
    fn source(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, 2>) -> Option<Self::SpanShader> {
        Linear::new(u, w, part, self.0, self.1)
    }
}

/// Three dimensions.
pub(crate) struct Solid<'a>(&'a Shown, &'a WrappedImage<3>);

impl<'a> Solid<'a> {
    /// The image that is shown.
    #[inline(always)]
    pub(crate) fn of(shown: &'a Shown) -> Option<Self> {
        match &shown.image {
            LinearImage::Rgb3d(image) => Some(Self(shown, image)),
            _ => None,
        }
    }
}

impl<'a> Parts<3> for Solid<'a> {
    type SpanShader = Linear<'a, 3, 4, RGB, false>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.0.unit
    }

    #[inline(always)]
    fn source(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, 3>) -> Option<Self::SpanShader> {
        Linear::new(u, w, part, self.0, self.1)
    }
}

impl<'a, const K: usize, const ROWS: usize, const FORMAT: u8, const BLENDED: bool>
    Linear<'a, K, ROWS, FORMAT, BLENDED>
{
    /// The source of a part of a run; `None` where batches must do it.
    #[inline(always)]
    fn new(
        u: &FragUniforms,
        w: &Work<'_, '_>,
        Part { segment, extent, unit, reads }: &Part<'_, K>,
        shown: &Shown,
        image: &'a WrappedImage<K>,
    ) -> Option<Self> {
        let &MipRange::One(level) = reads else { return None };
        let environment = Environment::of_run::<FORMAT, K>(u, w, segment, *extent, unit, shown)?;
        let level = Level::new(image, level, unit)?;
        let form = Projection::new(unit, *extent);
        let d = environment.divisor(form.divides(), unit.planes, *extent);
        Some(Self { form, repeats: image.repeats, level, environment, d })
    }
}

impl<const K: usize, const ROWS: usize, const FORMAT: u8, const BLENDED: bool> SpanShader
    for Linear<'_, K, ROWS, FORMAT, BLENDED>
{
    const BLENDS: bool = BLENDED;

    #[inline(always)]
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        let mut rw = [1.0; N];
        if let Some(d) = &self.d {
            divided(d, place, &mut rw);
        }
        let coordinates = self.form.values(place, &rw, &self.repeats);
        let mut texels = [[0.0; N]; 4];
        self.level.texels::<ROWS, FORMAT, N>(&coordinates, INV_255, &mut texels);
        self.environment.pixels::<N, BLENDED>(&mut texels, place, &rw, self.d.is_none(), out);
    }
}
