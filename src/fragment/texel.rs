//! Texels that reach the store as they are (OpenGL 1.5, sections 3.8.13 and 4.1.4). Where the one texture is read by NEAREST
//! from 8-bit texels and its environment puts the texel in the place of the colour, a pixel is a texel: as floats it would
//! be c/255 in every channel, and 255 times that rounds to c again. So the word goes from fetch to store as it is.

use super::batch::FragmentBatch;
use super::compare::{Func, any, compare};
use super::pack::byte;
use super::uniforms::{FragFn, FragUniforms, Work};
use crate::batch::{LANES, stage};

/// In the number of [`PACK_TEXEL`]: alpha is that of the primary colour, not of the texel.
pub(super) const PRIMARY_ALPHA: u32 = 1;

const COLOR: u32 = 0x00FF_FFFF;

stage! {
    /// The texels as pixels.
    pub(super) fn PACK_TEXEL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let or = u.packed_or;
        if arg & PRIMARY_ALPHA == 0 {
            for i in 0..LANES {
                b.packed[i] = b.tex.packed[i] | or;
            }
        } else {
            let alpha = &b.tex.primary[3];
            for i in 0..LANES {
                b.packed[i] = (b.tex.packed[i] & COLOR) | byte(alpha[i]) << 24 | or;
            }
        }
    }

    /// The alpha test on the bytes of the texels.
    pub(super) fn ALPHA_TEST_TEXEL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let mut alpha = [0; LANES];
        for i in 0..LANES {
            alpha[i] = b.tex.packed[i] >> 24;
        }
        compare(Func::from_arg(arg), &alpha, &[byte(u.alpha_ref); LANES], &mut b.tex.mask);
        b.alive = any(&b.tex.mask);
    }
}
