//! The span shader of the nearest texel of one 8-bit texture in the place of the colour (OpenGL 1.5, sections 3.8.7, 3.8.8
//! and 3.8.13). What is the same for all of a part (planes in its row, limits, wraps) is worked out once; then each block goes
//! from positions to texels, and texels that are neighbours are copied straight into the framebuffer.

use super::projection::{Projection, range};
use super::shader::{Part, SpanShader, SpanSource};
use crate::fragment::key::NearestTexture;
use crate::fragment::mip_range::MipRange;
use crate::fragment::plane_eval::{Extent, LinearEval, Positions, Real};
use crate::fragment::planes::Unit;
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::simd::PixelCost;
use crate::texture::filter::{self, neighbours};
use crate::texture::uniforms::WrappedImage;
use crate::texture::wrap::bounded::NearestWrap;

/// What all blocks of a part need to find their texels.
pub struct NearestTexels<'a> {
    projection: Projection<2>,
    /// D, if coordinates are divided by it in `f32`.
    d: Option<LinearEval<f32>>,
    column: NearestWrap,
    row: NearestWrap,
    repeats: [bool; 2],
    origin: u32,
    stride: u32,
    texels: &'a [u32],
    or: u32,
}

impl<'a> SpanSource<2> for &'a NearestTexture {
    type Shader = NearestTexels<'a>;

    #[inline(always)]
    fn unit(&self) -> u32 {
        self.unit
    }

    #[inline(always)]
    fn shader(&self, u: &FragUniforms, _w: &Work<'_, '_>, part: &Part<'_, 2>) -> Option<NearestTexels<'a>> {
        let MipRange::One(level) = part.levels else { return None };
        NearestTexels::new(&part.unit, &self.image, level, part.extent, u.packed_or)
    }
}

impl<'a> NearestTexels<'a> {
    /// The texels of a mipmap level; `None` where coordinates may not be finite, or are too far from 0 for the simple
    /// wrap.
    #[inline(always)]
    fn new(unit: &Unit<'_, 2>, image: &'a WrappedImage<2>, level: u32, extent: Extent, or: u32) -> Option<Self> {
        let (level, repeats) = (image.levels.get(level as usize)?, image.repeats);
        let wrap = |k: usize| NearestWrap::new(repeats[k], range(unit, &repeats, k)?.limit, level.size[k]);
        let (column, row) = (wrap(0)?, wrap(1)?);
        let (origin, stride, texels) = (level.origin, level.stride, filter::texels(level));
        let projection = Projection::new(unit, extent);
        let d = projection.divides().then(|| LinearEval::new(&unit.divisor, extent.row()));
        Some(Self { projection, d, column, row, repeats, origin, stride, texels, or })
    }

    /// The index of the texel at (s, t).
    #[inline(always)]
    fn index(&self, s: f32, t: f32) -> u32 {
        let start = self.origin.wrapping_add(self.row.index(t).wrapping_mul(self.stride));
        start.wrapping_add(self.column.index(s))
    }

    /// The indices of the texels of pixels.
    #[inline(always)]
    fn indices<const N: usize, P: Positions<N>>(&self, at: P) -> [u32; N] {
        let mut index = [0; N];
        match (&self.projection, &self.d) {
            (Projection::Even([s, t]), _) => {
                for i in 0..N {
                    index[i] = self.index(s.even(at, i), t.even(at, i));
                }
            }
            (Projection::Divided([s, t]), Some(d)) => {
                for i in 0..N {
                    let rq = at.sum(d, i).reciprocal();
                    index[i] = self.index(s.divided(at, i, rq), t.divided(at, i, rq));
                }
            }
            _ => {
                let [s, t] = self.projection.values(at, &[1.0; N], &self.repeats);
                for i in 0..N {
                    index[i] = self.index(s[i], t[i]);
                }
            }
        }
        index
    }
}

impl SpanShader for NearestTexels<'_> {
    const IS_SMALL: bool = true;

    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, _below: &[u32; N], out: &mut [u32; N]) {
        let index = self.indices(at);
        // Copied out of `self`: the compiler cannot prove that writing pixels leaves these fields as they are.
        let (texels, or) = (self.texels, self.or);
        if P::IS_ROW
            && let Projection::Even(_) = self.projection
            && let Some(run) =
                neighbours(&index).and_then(|first| texels.get(first..)).and_then(|t| t.first_chunk::<N>())
        {
            for i in 0..N {
                out[i] = run[i] | or;
            }
            return;
        }
        for i in 0..N {
            let Some(&texel) = texels.get(index[i] as usize) else { break };
            out[i] = texel | or;
        }
    }

    fn cost(&self) -> PixelCost {
        let divisions = u64::from(!matches!(self.projection, Projection::Even(_)));
        PixelCost { texels: 1, divisions, wraps: 2, ..PixelCost::default() }
    }
}
