//! Hierarchical depth: the greatest depth of each block of a row of the depth buffer, kept up to date by the programs. Depth
//! along a row of a primitive is monotonic, rounding included, so the depths at its two ends are its least and its greatest:
//! a row whose nearest end lies behind what is kept of its blocks fails the depth test unread (OpenGL 1.5, section 4.1.6).
//! After a row was drawn the greatest depths of the blocks that it has touched are computed again.

use super::batch::{FragmentBatch, Segment};
use super::compare::CompareFunc;
use super::reference::depth::DepthSlope;
use super::reference::lanes::row_origin;
use super::uniforms::{FragUniforms, LongFn, Work};
use crate::framebuffer::{BLOCK, Band};
use crate::simd::{Step, stage};

/// The stages of a program that uses it.
#[derive(Clone, Copy, Debug)]
pub struct Hiz {
    /// Gives how many pixels of a row, from its start on, are hidden.
    pub cull: Step<LongFn>,
    /// Computes the greatest depths of the blocks that a row has touched, if depths are written.
    pub update: Option<Step<LongFn>>,
}

/// Whether fragments from `least` on fail the test against all depths up to `limit`.
#[inline(always)]
fn fails(func: CompareFunc, least: u32, limit: u32) -> bool {
    match func {
        CompareFunc::Less => least >= limit,
        CompareFunc::Lequal | CompareFunc::Equal => least > limit,
        _ => false,
    }
}

/// Whether hierarchical depth is of use to a test: depths never rise, and what is behind them fails.
pub fn uses_hiz(func: CompareFunc) -> bool {
    matches!(func, CompareFunc::Less | CompareFunc::Lequal | CompareFunc::Equal)
}

/// How many pixels of a row, from its start on, fail the test because their blocks are nearer.
#[inline(always)]
pub fn hiz_cull(band: &Band<'_>, run: &Segment, slope: &DepthSlope, x: i32, func: CompareFunc) -> u32 {
    let Ok(start) = usize::try_from(run.x) else { return 0 };
    let least = slope.least(x, x.wrapping_add(run.len.wrapping_sub(1).cast_signed()));
    let end = start.saturating_add(run.len as usize);
    let mut at = start;
    for limit in band.hier_z.row(band.memory_row(run.y)).iter().skip(start / BLOCK) {
        if at >= end || !fails(func, least, *limit) {
            break;
        }
        at = (at / BLOCK + 1) * BLOCK;
    }
    at.min(end).wrapping_sub(start) as u32
}

/// Updates hierarchical depth for the blocks that the first `len` pixels of a row touch.
#[inline(always)]
pub fn hiz_update(band: &mut Band<'_>, run: &Segment, len: usize) {
    let (Ok(x), row) = (usize::try_from(run.x), band.memory_row(run.y)) else { return };
    let Some(start) = (run.offset as usize).checked_sub(x) else { return };
    let Some(depths) = band.depth.get(start..).map(|d| d.get(..band.width as usize).unwrap_or(d)) else { return };
    let (first, last) = (x / BLOCK, (x + len).div_ceil(BLOCK));
    for (block, depths) in depths.chunks(BLOCK).enumerate().take(last).skip(first) {
        let mut limit = 0;
        if let Some(depths) = depths.first_chunk::<BLOCK>() {
            for i in 0..BLOCK {
                limit = if depths[i] > limit { depths[i] } else { limit };
            }
        } else {
            for depth in depths {
                limit = limit.max(*depth);
            }
        }
        band.hier_z.set(row, block, limit);
    }
}

stage! {
    /// How many pixels of a row, from its start on, may be skipped.
    pub fn HIZ_CULL: LongFn = (_b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(planes) = w.planes.get(s.prim as usize) else { return 0 };
        let (x, y) = row_origin(s, planes);
        let slope = DepthSlope::new(planes, y);
        hiz_cull(w.band, s, &slope, x, CompareFunc::from_arg(arg >> 1))
    }

    /// Updates hierarchical depth after a row was drawn.
    pub fn HIZ_UPDATE: LongFn = (_b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, _arg: u32) -> u32 {
        hiz_update(w.band, s, s.len as usize);
        s.len
    }
}
