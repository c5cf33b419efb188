//! Span shaders without a texture (OpenGL 1.5, section 3.5.1): one colour, and the interpolated primary colour.

use super::shader::SpanShader;
use crate::fragment::plane_eval::Positions;
use crate::fragment::reference::pack::{PackedColor, SmoothColor};
use crate::simd::PixelCost;

/// The same pixel everywhere.
pub struct FlatColor(pub u32);

impl SpanShader for FlatColor {
    const IS_SMALL: bool = true;

    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, _at: P, _below: &[u32; N], out: &mut [u32; N]) {
        *out = [self.0; N];
    }
}

impl SpanShader for SmoothColor {
    const IS_SMALL: bool = true;

    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, _below: &[u32; N], out: &mut [u32; N]) {
        SmoothColor::pixels(self, at, out);
    }

    fn cost(&self) -> PixelCost {
        PixelCost { divisions: u64::from(self.divides()), ..PixelCost::default() }
    }
}

impl SpanShader for PackedColor {
    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, _below: &[u32; N], out: &mut [u32; N]) {
        PackedColor::pixels(self, at, out);
    }

    fn cost(&self) -> PixelCost {
        match self {
            Self::Flat(_) => PixelCost::default(),
            Self::Smooth(smooth) => smooth.cost(),
        }
    }
}
