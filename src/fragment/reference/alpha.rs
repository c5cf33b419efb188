//! The alpha test (OpenGL 1.5, section 4.1.4). The specification compares the fragment's alpha and the reference value
//! after both were converted to the fixed-point numbers of the colour buffer, so what is compared here are bytes, rounded
//! to the nearest as the store does. A float buffer has no such conversion; there floats are compared.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, any, compare};
use crate::fragment::reference::pack::byte;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::clamp01;
use crate::simd::{LANES, stage};

stage! {
    /// The alpha test on bytes.
    pub fn ALPHA_TEST: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let mut alpha = [0; LANES];
        for i in 0..LANES {
            alpha[i] = byte(b.tex.previous[3][i]);
        }
        compare(CompareFunc::from_arg(arg), &alpha, &[byte(u.alpha_ref); LANES], &mut b.tex.mask);
        b.alive = any(&b.tex.mask);
    }

    /// The alpha test on floats.
    pub fn ALPHA_TEST_FLOAT: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, arg: u32) {
        let mut alpha = [0.0; LANES];
        for i in 0..LANES {
            alpha[i] = clamp01(b.tex.previous[3][i]);
        }
        compare(CompareFunc::from_arg(arg), &alpha, &[u.alpha_ref; LANES], &mut b.tex.mask);
        b.alive = any(&b.tex.mask);
    }
}
