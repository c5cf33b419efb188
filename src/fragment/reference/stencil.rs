//! The stencil test (OpenGL 1.5, section 4.1.5). It comes in two stages, because what is written depends on the depth test
//! between them: `STENCIL_TEST` compares and notes who failed, `STENCIL_WRITE` applies the operations of the three
//! cases (stencil failed, depth failed, both passed) and writes the bits that the mask lets through. Each has a form for
//! front and back faces of polygons that differ (ATI_separate_stencil).

use crate::fragment::batch::FragmentBatch;
use crate::fragment::compare::{CompareFunc, any, compare, ones};
use crate::fragment::reference::lanes::Lane;
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, StencilOps, Work};
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

/// Reads the stencil buffer; gives what is to be compared with the reference value.
#[inline(always)]
fn read(b: &mut FragmentBatch, u: &FragUniforms, w: &Work<'_, '_>) -> [u32; LANES] {
    let mut bytes = [0; LANES];
    load(places!(b), w.band.stencil, &mut bytes);
    let mut masked = [0; LANES];
    for i in 0..LANES {
        b.stencil[i] = u32::from(bytes[i]);
        masked[i] = b.stencil[i] & u.stencil.value_mask;
    }
    b.before[0] = b.tex.mask;
    masked
}

/// Applies the operations of a face to the lanes of a mask.
#[inline(always)]
fn operate(b: &FragmentBatch, ops: &StencilOps, reference: u32, mask: &[u32; LANES], new: &mut [u32; LANES]) {
    let (mut failed, mut depth_failed, mut passed) = ([0; LANES], [0; LANES], [0; LANES]);
    for i in 0..LANES {
        failed[i] = b.before[0][i] & !b.before[1][i] & mask[i];
        depth_failed[i] = b.before[1][i] & !b.tex.mask[i] & mask[i];
        passed[i] = b.tex.mask[i] & mask[i];
    }
    apply(ops.fail, reference, &failed, new);
    apply(ops.depth_fail, reference, &depth_failed, new);
    apply(ops.pass, reference, &passed, new);
}

/// Writes the bits of new values that the mask lets through, for all fragments that came to the stencil test.
#[inline(always)]
fn write(b: &FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, new: &[u32; LANES]) {
    let write_mask = u.stencil.write_mask;
    let mut bytes = [0; LANES];
    for i in 0..LANES {
        bytes[i] = ((new[i] & write_mask) | (b.stencil[i] & !write_mask)) as u8;
    }
    store(places!(b), &b.before[0], &bytes, w.band.stencil);
}

stage! {
    /// Reads the stencil buffer and kills the fragments that fail.
    pub fn STENCIL_TEST: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let masked = read(b, u, w);
        let reference = [u.stencil.reference & u.stencil.value_mask; LANES];
        compare(CompareFunc::from_arg(arg), &reference, &masked, &mut b.tex.mask);
        b.before[1] = b.tex.mask;
        b.alive = any(&b.tex.mask);
    }

    /// The same with a function for front faces in the lowest three bits and one for back faces in the next three.
    pub fn STENCIL_TEST_TWO_SIDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let masked = read(b, u, w);
        let reference = [u.stencil.reference & u.stencil.value_mask; LANES];
        for segment in b.segments.iter().take(b.segment_count) {
            let back = w.planes.get(segment.prim as usize).is_some_and(|planes| planes.back);
            let lanes = b.back.iter_mut().skip(segment.start as usize).take(segment.len as usize);
            lanes.for_each(|lane| *lane = if back { u32::MAX } else { 0 });
        }
        let (mut front, mut back) = ([0; LANES], [0; LANES]);
        for i in 0..LANES {
            front[i] = b.tex.mask[i] & !b.back[i];
            back[i] = b.tex.mask[i] & b.back[i];
        }
        compare(CompareFunc::from_arg(arg & 7), &reference, &masked, &mut front);
        compare(CompareFunc::from_arg(arg >> 3 & 7), &reference, &masked, &mut back);
        for i in 0..LANES {
            b.tex.mask[i] = front[i] | back[i];
        }
        b.before[1] = b.tex.mask;
        b.alive = any(&b.tex.mask);
    }

    /// Changes the stencil buffer, for all fragments that came to the stencil test.
    pub fn STENCIL_WRITE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut new = b.stencil;
        operate(b, &u.stencil.faces[0], u.stencil.reference, &[u32::MAX; LANES], &mut new);
        write(b, u, w, &new);
    }

    /// The same with operations for front faces and others for back faces.
    pub fn STENCIL_WRITE_TWO_SIDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut new = b.stencil;
        let mut front = [0; LANES];
        for i in 0..LANES {
            front[i] = !b.back[i];
        }
        operate(b, &u.stencil.faces[0], u.stencil.reference, &front, &mut new);
        operate(b, &u.stencil.faces[1], u.stencil.reference, &b.back, &mut new);
        write(b, u, w, &new);
    }
}
