//! The store into float colour buffers. The fragment's colour is limited to [0, 1] as the specification has it; what
//! blending makes of it is not, since there is no fixed-point number that it must fit.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::clamp01;
use crate::simd::{LANES, stage};

stage! {
    /// Reads the pixels.
    pub fn LOAD_FLOAT: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut pixels = [[0.0; 4]; LANES];
        load(places!(b), w.band.float, &mut pixels);
        for c in 0..4 {
            for i in 0..LANES {
                b.dst[c][i] = pixels[i][c];
            }
        }
    }

    /// The fragment's colour takes the place of what blending would give.
    pub fn COPY_FLOAT: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for c in 0..4 {
            for i in 0..LANES {
                b.dst[c][i] = clamp01(b.tex.previous[c][i]);
            }
        }
    }

    /// Writes the channels that the colour mask lets through.
    pub fn STORE_FLOAT: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut pixels = [[0.0; 4]; LANES];
        let mask = u.color_mask.to_le_bytes();
        if u.color_mask != u32::MAX {
            load(places!(b), w.band.float, &mut pixels);
        }
        for c in 0..4 {
            if mask[c] != 0 {
                let opaque = c == 3 && u.packed_or != 0;
                for i in 0..LANES {
                    pixels[i][c] = if opaque { 1.0 } else { b.dst[c][i] };
                }
            }
        }
        store(places!(b), &b.tex.mask, &pixels, w.band.float);
    }
}
