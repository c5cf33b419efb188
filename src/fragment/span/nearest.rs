//! Runs of a row, of any length, of programs that test depth and put the nearest texel of one 8-bit image in the place of
//! the colour (OpenGL 1.5, sections 3.8.7, 3.8.8 and 3.8.13): what [`fill`](crate::fragment::span::long) does for interpolated colours.
//! What is the same for all of a run (planes in its row, limits, wraps) is worked out once; then each block goes from
//! positions to texels without a batch in between, and where all its fragments are alive texels are copied straight into
//! the framebuffer. Every number comes from the same expressions as in the stages of batches, so the bits are the same.

use crate::fragment::lod_bounds::MipRange;
use crate::fragment::plane_eval::{Divisor, Extent, From, Place, Projection, Terms, range};
use crate::fragment::reference::texcoord::Unit;
use crate::fragment::span::long::{Part, Parts, SpanShader};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::texture::filter::{self, neighbours};
use crate::texture::uniforms::WrappedImage;
use crate::texture::wrap::bounded::NearestWrap;

/// The images that a program copies texels from, and the unit whose coordinates say which.
#[derive(Clone, Debug)]
pub struct Copied {
    /// The unit's index.
    pub unit: u32,
    /// The images and their wraps.
    pub from: WrappedImage<2>,
}

/// What all blocks of a run need to find their texels.
pub(crate) struct Texels<'a> {
    form: Projection<2>,
    /// D, if coordinates are divided by it in `f32`.
    d: Option<Divisor<f32>>,
    column: NearestWrap,
    row: NearestWrap,
    repeats: [bool; 2],
    origin: u32,
    stride: u32,
    texels: &'a [u32],
    or: u32,
}

impl<'a> Parts<2> for &'a Copied {
    type SpanShader = Texels<'a>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.unit
    }

    #[inline(always)]
    fn source(&self, u: &FragUniforms, _w: &Work<'_, '_>, part: &Part<'_, 2>) -> Option<Texels<'a>> {
        let MipRange::One(level) = part.reads else { return None };
        Texels::new(&part.unit, &self.from, level, part.extent, u.packed_or)
    }
}

impl<'a> Texels<'a> {
    /// The texels, of a level, of a run; `None` where something is not as it is as a rule: coordinates that are not finite or
    /// too far from 0 for the simple wrap.
    #[inline(always)]
    fn new(unit: &Unit<'_, 2>, image: &'a WrappedImage<2>, level: u32, extent: Extent, or: u32) -> Option<Self> {
        let (level, repeats) = (image.levels.get(level as usize)?, image.repeats);
        let wrap = |k: usize| NearestWrap::new(repeats[k], range(unit, &repeats, k)?.limit, level.size[k]);
        let (column, row) = (wrap(0)?, wrap(1)?);
        let (origin, stride, texels) = (level.origin, level.stride, filter::texels(level));
        let form = Projection::new(unit, extent);
        let d = form.divides().then(|| Terms::new(&unit.divisor, extent.row()));
        Some(Self { form, d, column, row, repeats, origin, stride, texels, or })
    }

    /// Where the texel at (s, t) is.
    #[inline(always)]
    fn place(&self, s: f32, t: f32) -> u32 {
        let start = self.origin.wrapping_add(self.row.index(t).wrapping_mul(self.stride));
        start.wrapping_add(self.column.index(s))
    }

    /// Where the texels of pixels are.
    #[inline(always)]
    fn places<const N: usize>(&self, place: impl Place<N>) -> [u32; N] {
        let mut at = [0; N];
        match (&self.form, &self.d) {
            (Projection::Even([s, t]), _) => {
                for i in 0..N {
                    at[i] = self.place(s.even(place, i), t.even(place, i));
                }
            }
            (Projection::Divided([s, t]), Some(d)) => {
                for i in 0..N {
                    let rq = 1.0 / place.sum(d, i);
                    at[i] = self.place(s.divided(place, i, rq), t.divided(place, i, rq));
                }
            }
            _ => {
                let [s, t] = self.form.values(place, &[1.0; N], &self.repeats);
                for i in 0..N {
                    at[i] = self.place(s[i], t[i]);
                }
            }
        }
        at
    }

    /// The pixels of the texels at these places.
    #[inline(always)]
    fn found<const N: usize>(&self, at: &[u32; N], out: &mut [u32; N]) {
        // As copies: the compiler cannot tell that what is written is not read from here.
        let (texels, or) = (self.texels, self.or);
        for i in 0..N {
            let Some(&texel) = texels.get(at[i] as usize) else { break };
            out[i] = texel | or;
        }
    }
}

impl SpanShader for Texels<'_> {
    #[inline(always)]
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        self.found(&self.places(place), out);
    }

    #[inline(always)]
    fn all<const N: usize>(&self, x: i32, to: &mut [u32; N]) {
        let at = self.places::<N>(From(x as f32));
        if let Projection::Even(_) = self.form
            && let Some(run) =
                neighbours(&at).and_then(|first| self.texels.get(first..)).and_then(|t| t.first_chunk::<N>())
        {
            for i in 0..N {
                to[i] = run[i] | self.or;
            }
            return;
        }
        self.found(&at, to);
    }
}
