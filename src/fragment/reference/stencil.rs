//! The stencil test (OpenGL 1.5, section 4.1.5). It comes in two stages, because what is written depends on the depth test
//! between them: `STENCIL_TEST` compares and notes who failed, `STENCIL_WRITE` applies the operations of the three
//! cases (stencil failed, depth failed, both passed) and writes the bits that the mask lets through.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, any, compare, ones};
use crate::fragment::reference::lanes::Lane;
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};
use crate::state::depth_stencil::StencilOp;

/// Applies an operation to the lanes of a mask.
#[inline(always)]
fn apply(op: StencilOp, reference: u32, mask: &[u32; LANES], s: &mut [u32; LANES]) {
    #[inline(always)]
    fn each(mask: &[u32; LANES], s: &mut [u32; LANES], f: impl Fn(u32) -> u32) {
        for i in 0..LANES {
            s[i] = u32::select(mask[i], f(s[i]), s[i]);
        }
    }
    match op {
        StencilOp::Keep => {}
        StencilOp::Zero => each(mask, s, |_| 0),
        StencilOp::Replace => each(mask, s, |_| reference),
        StencilOp::Incr => each(mask, s, |s| s + (ones(s < 255) & 1)),
        StencilOp::Decr => each(mask, s, |s| s - (ones(s > 0) & 1)),
        StencilOp::Invert => each(mask, s, |s| !s & 0xFF),
        StencilOp::IncrWrap => each(mask, s, |s| s.wrapping_add(1) & 0xFF),
        StencilOp::DecrWrap => each(mask, s, |s| s.wrapping_sub(1) & 0xFF),
    }
}

stage! {
    /// Reads the stencil buffer and kills the fragments that fail.
    pub fn STENCIL_TEST: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let mut bytes = [0; LANES];
        load(places!(b), w.band.stencil, &mut bytes);
        let mut masked = [0; LANES];
        for i in 0..LANES {
            b.stencil[i] = u32::from(bytes[i]);
            masked[i] = b.stencil[i] & u.stencil.value_mask;
        }
        b.before[0] = b.tex.mask;
        compare(CompareFunc::from_arg(arg), &[u.stencil.reference & u.stencil.value_mask; LANES], &masked, &mut b.tex.mask);
        b.before[1] = b.tex.mask;
        b.alive = any(&b.tex.mask);
    }

    /// Changes the stencil buffer, for all fragments that came to the stencil test.
    pub fn STENCIL_WRITE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let s = &u.stencil;
        let (mut failed, mut depth_failed) = ([0; LANES], [0; LANES]);
        for i in 0..LANES {
            failed[i] = b.before[0][i] & !b.before[1][i];
            depth_failed[i] = b.before[1][i] & !b.tex.mask[i];
        }
        let mut new = b.stencil;
        apply(s.fail, s.reference, &failed, &mut new);
        apply(s.depth_fail, s.reference, &depth_failed, &mut new);
        apply(s.pass, s.reference, &b.tex.mask, &mut new);
        let mut bytes = [0; LANES];
        for i in 0..LANES {
            bytes[i] = ((new[i] & s.write_mask) | (b.stencil[i] & !s.write_mask)) as u8;
        }
        let from = &bytes;
        store(places!(b), &b.before[0], from, w.band.stencil);
    }
}
