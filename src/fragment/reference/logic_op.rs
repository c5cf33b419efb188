//! Logical operations (OpenGL 1.5, section 4.1.10) between the bits of the fragment's packed colour and those of the pixel.
//! They take the place of blending. Float buffers have no bits to combine: there the fragment's colour is stored.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};

stage! {
    /// The logic op of the stage's number.
    pub fn LOGIC_OP: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        // Bit 0 of the operation's number is what (s, d) = (1, 1) gives, bit 1 (1, 0), bit 2 (0, 1), bit 3 (0, 0): GL
        // has numbered the operations by their truth tables.
        let bit = |k: u32| ((arg >> k) & 1).wrapping_neg();
        let (both, only_s, only_d, none) = (bit(0), bit(1), bit(2), bit(3));
        for i in 0..LANES {
            let (s, d) = (b.packed[i], b.packed_dst[i]);
            b.packed[i] = (both & s & d) | (only_s & s & !d) | (only_d & !s & d) | (none & !s & !d);
        }
    }
}
