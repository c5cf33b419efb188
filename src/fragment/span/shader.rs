//! What gives the pixels of a span their colours: a shader is made for a part of a primitive, with all that is the same
//! for the part worked out (planes in its row, wraps, levels, environment), and then gives block after block its
//! pixels. The drivers (`long`, `short`) know shaders only by these traits.

use crate::fragment::batch::Segment;
use crate::fragment::mip_range::MipRange;
use crate::fragment::plane_eval::{Extent, Positions};
use crate::fragment::planes::Unit;
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::simd::PixelCost;

/// Gives blocks of pixels their colours.
pub trait SpanShader {
    /// Whether its code is so small that it may stand twice in a kernel. Blocks of which all pixels are written then
    /// have a call of their own that writes straight into the framebuffer, without a copy in between.
    const IS_SMALL: bool = false;

    /// Whether what is there before is blended with.
    #[inline(always)]
    fn blends(&self) -> bool {
        false
    }

    /// The pixels at N positions; `below` is what is there before where that is blended with.
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, below: &[u32; N], out: &mut [u32; N]);

    /// What a pixel costs, for the counters.
    fn cost(&self) -> PixelCost {
        PixelCost::default()
    }
}

/// A part of a primitive whose pixels read the same mipmap levels.
pub struct Part<'a, const K: usize> {
    /// Its first row.
    pub segment: Segment,
    /// Whether it is part of one row.
    pub extent: Extent,
    /// The unit whose coordinates it interpolates.
    pub unit: Unit<'a, K>,
    /// The levels.
    pub levels: MipRange,
}

/// Makes shaders for the parts of a primitive.
pub trait SpanSource<const K: usize> {
    /// The shader of a part.
    type Shader: SpanShader;

    /// The unit's index.
    fn unit(&self) -> u32;

    /// The shader for a part; `None` where the part must be drawn through batches.
    fn shader(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, K>) -> Option<Self::Shader>;
}
