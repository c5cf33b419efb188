//! What the fragment stages read: the numbers of the state, already in the form in which the stages use them. Which
//! stages run is the program's matter; nothing here selects code apart from table indices.

use super::batch::{FragmentBatch, Segment};
use super::key::SpanTexture;
use super::pixel_rect::PixelRect;
use super::planes::{Layout, Linear, Plane, PlaneGroup, PlanePool, Planes, Unit, UnitSlots};
use crate::framebuffer::Band;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::simd::PixelCost;
use crate::state::color_buffer::{BlendEquation, BlendFactor};
use crate::state::depth_stencil::StencilOp;
use crate::texture::rho_ranges::RhoRanges;
use std::sync::Arc;

/// The numbers behind a program.
#[derive(Clone, Debug, Default)]
pub struct FragUniforms {
    /// Which slot holds what.
    pub layout: Layout,
    /// For each unit the levels of a filter that may do without derivatives.
    pub levels: [Option<RhoRanges>; MAX_TEXTURE_UNITS],
    /// Bits that are set in every packed pixel: alpha where the format has none.
    pub packed_or: u32,
    /// Bits of a packed pixel that may be written.
    pub color_mask: u32,
    /// What the store's unit is: 255 for bytes, 1 for floats.
    pub scale: f32,
    /// The largest value that blending may give: 255 for bytes; floats have no limit.
    pub limit: f32,
    /// The alpha test's reference value in [0, 1].
    pub alpha_ref: f32,
    /// The fog's colour.
    pub fog_color: [f32; 3],
    /// Density of exponential fog, 1 / (end - start) of linear fog.
    pub fog_scale: f32,
    /// Where linear fog ends.
    pub fog_end: f32,
    /// Bits of the interpolated value that make the fog coordinate: those of its absolute value where it is z in eye
    /// coordinates.
    pub fog_bits: u32,
    /// The stencil test.
    pub stencil: StencilUniforms,
    /// Blending.
    pub blend: BlendUniforms,
    /// What a span kernel shows, where that is a texture.
    pub span: Option<SpanTexture>,
    /// The image of a pixel rectangle, where fragments are those of one.
    pub pixels: Option<Arc<PixelRect>>,
}

/// The numbers of the stencil test.
#[derive(Clone, Copy, Debug, Default)]
pub struct StencilUniforms {
    /// Reference value, limited to a byte.
    pub reference: u32,
    /// Which bits are compared.
    pub value_mask: u32,
    /// Which bits are written.
    pub write_mask: u32,
    /// What becomes of the values under front faces (with points and lines) and under back faces.
    pub faces: [StencilOps; 2],
}

/// What becomes of a stencil value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StencilOps {
    /// Operation where the stencil test fails.
    pub fail: StencilOp,
    /// Operation where the depth test fails.
    pub depth_fail: StencilOp,
    /// Operation where both pass.
    pub pass: StencilOp,
}

/// The numbers of blending.
#[derive(Clone, Copy, Debug, Default)]
pub struct BlendUniforms {
    /// Source factors of RGB and alpha.
    pub src: [BlendFactor; 2],
    /// Destination factors of RGB and alpha.
    pub dst: [BlendFactor; 2],
    /// The equations of RGB and alpha.
    pub equation: [BlendEquation; 2],
    /// The constant colour.
    pub color: [f32; 4],
}

/// What a stage works with besides the batch: the primitives of the scene and the rows of the framebuffer.
#[derive(Debug)]
pub struct Work<'a, 'b> {
    /// What fragments need to know of each primitive.
    pub planes: &'a [Planes],
    /// The planes of the primitives' slots.
    pub pool: PlanePool<'a>,
    /// The rows that are drawn into.
    pub band: &'a mut Band<'b>,
    /// What span kernels have done, if counting is on.
    pub counts: Option<SpanCounts>,
}

/// What span kernels have done.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpanCounts {
    /// Pixels of the rows that the kernels have done.
    pub fragments: u64,
    /// Pixels that passed all tests.
    pub passed: u64,
    /// Pixels that hierarchical depth has hidden, which no kernel has seen.
    pub hidden: u64,
    /// The sums of their costs.
    pub cost: PixelCost,
}

impl<'a> Work<'a, '_> {
    /// The planes of a segment's primitive for a unit of K coordinates; `None` for a member of a group.
    #[inline(always)]
    pub fn unit<const K: usize>(&self, segment: &Segment, slots: &UnitSlots, index: u32) -> Option<Unit<'a, K>> {
        let planes = self.planes.get(segment.prim as usize)?;
        let first = (planes.first as usize).checked_add(slots.base)?;
        if planes.member.is_some() {
            return None;
        }
        let coords = self.pool.alone.get(first..)?.first_chunk()?;
        let has_q = slots.has_q && !slots.cube;
        let divisor = if has_q {
            let q = self.pool.alone.get(first + K)?;
            Linear { at: q.n0, x: q.nx, y: q.ny }
        } else {
            planes.d
        };
        let wide = (planes.wide >> (index & 31)) & 1 != 0 || (planes.wide & Planes::WIDE_W != 0 && !has_q);
        Some(Unit { planes, coords, divisor, has_q, wide })
    }

    /// The primitive of a segment, which is in no group, and the planes of its slots from `slot` on.
    #[inline(always)]
    pub fn primitive<const K: usize>(&self, segment: &Segment, slot: usize) -> Option<(&'a Planes, &'a [Plane; K])> {
        let planes = self.planes.get(segment.prim as usize)?;
        let first = (planes.first as usize).checked_add(slot)?;
        if planes.member.is_some() {
            return None;
        }
        Some((planes, self.pool.alone.get(first..)?.first_chunk()?))
    }

    /// The group of a primitive that is in one, for its slots from `slot` on, and which one it is of the group.
    #[inline(always)]
    pub fn group<const K: usize>(&self, planes: &Planes, slot: usize) -> Option<(&'a [PlaneGroup; K], usize)> {
        let member = planes.member?;
        let first = (planes.first as usize).checked_add(slot)?;
        Some((self.pool.groups.get(first..)?.first_chunk()?, member as usize))
    }

    /// Counts the logarithm by which a part's levels are found, where lambda is the same in all of it.
    #[inline(always)]
    pub fn count_lambda<const K: usize>(&mut self, unit: &Unit<'_, K>, levels: &Option<RhoRanges>) {
        if let Some(counts) = &mut self.counts {
            counts.cost.logarithms += u64::from(levels.is_some() && unit.is_even());
        }
    }

    /// How many pixels have passed so far, if counting is on.
    #[inline(always)]
    pub fn passed(&self) -> u64 {
        self.counts.map_or(0, |counts| counts.passed)
    }

    /// Adds the costs of the pixels that passed since there were `before`.
    #[inline(always)]
    pub fn count(&mut self, before: u64, cost: PixelCost) {
        if let Some(counts) = &mut self.counts {
            counts.cost += cost.times(counts.passed - before);
        }
    }
}

/// A fragment stage.
pub type FragFn = for<'a, 'b> unsafe fn(&mut FragmentBatch, &FragUniforms, &mut Work<'a, 'b>, u32);

/// Does a row of a primitive, or what it can of it from its start on; gives how many pixels it has done.
pub type LongFn =
    for<'a, 'b, 'c> unsafe fn(&mut FragmentBatch, &FragUniforms, &mut Work<'a, 'b>, &'c Segment, u32) -> u32;

/// Does the rows of a primitive, which are the segments of the batch; gives whether it has.
pub type ShortFn = for<'a, 'b> unsafe fn(&mut FragmentBatch, &FragUniforms, &mut Work<'a, 'b>, u32) -> bool;
