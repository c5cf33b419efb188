//! Planes of interpolated values (OpenGL 1.5, sections 3.4.1, 3.5.1 and 3.8.2), set up in f64 from the unsnapped
//! positions. Every primitive becomes a [`Basis`]. The formulas are those of [`crate::fragment::planes`]; all of them work on
//! differences from corner 0, so equal values give slopes of exactly 0 and equal w a denominator of exactly 1.

use super::basis::{Basis, CornerValues, constant};
use super::plane_buffer::PlaneBuffer;
use super::texcoord_planes::{denominator_error, unit_planes};
use super::weights::{FOUR, FourPlanes, FourPlanesFn, Weights};
use crate::fragment::planes::{Layout, Plane, PlaneGroup, Planes, UnitSlots};
use crate::raster::state::RasterState;
use crate::raster::triangle_batch::TriangleBatch;
use crate::raster::triangle_batch::corners::MOST_SLOTS;
use crate::raster::triangle_batch::planes::{
    BatchState, SET_UP_BATCH, SetUpBatchFn, SlotRules, TRANSPOSE, TransposeFn,
};
use crate::simd::Level;
use crate::state::raster::PolygonMode;

/// The layout of a draw, prepared for setup.
#[derive(Clone, Debug)]
pub struct SetupPlan {
    four: FourPlanesFn,
    set_up_batch: SetUpBatchFn,
    transpose: TransposeFn,
    layout: Layout,
    flat: bool,
    /// The texture units in use, with their numbers.
    units: Vec<(u32, UnitSlots)>,
    /// The same for batches.
    rules: SlotRules,
    /// Whether filled triangles are set up in batches.
    batches: bool,
}

/// Replaces planes that are not finite by constants.
#[cold]
fn replace_non_finite(planes: &mut [Plane], values: &[f32]) {
    for (plane, value) in planes.iter_mut().zip(values) {
        if !(plane.n0 + plane.nx + plane.ny).is_finite() {
            *plane = constant(if value.is_finite() { *value } else { 0.0 });
        }
    }
}

/// Four slots from `at` on, where there are so many.
#[inline(always)]
fn four_of(slots: &[f32], at: usize) -> Option<&[f32; 4]> {
    slots.get(at..)?.first_chunk()
}

impl SetupPlan {
    /// The plan of no draw, for an instruction set.
    #[must_use]
    pub fn new(level: Level) -> Self {
        Self {
            four: FOUR.at(level),
            set_up_batch: SET_UP_BATCH.at(level),
            transpose: TRANSPOSE.at(level),
            layout: Layout::default(),
            flat: false,
            units: Vec::new(),
            rules: SlotRules::default(),
            batches: false,
        }
    }

    /// Takes a layout and a shade model. Each triangle is set up alone.
    pub fn set(&mut self, layout: &Layout, flat: bool) {
        self.batches = false;
        self.layout.clone_from(layout);
        self.flat = flat;
        self.units.clear();
        self.units.extend((0..).zip(&layout.units).filter_map(|(u, slots)| slots.map(|slots| (u, slots))));
        self.rules.set(layout);
    }

    /// Which values are interpolated.
    #[must_use]
    pub const fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Takes a draw. Triangles are set up in batches where all polygons are filled and no unit has a q.
    pub fn set_draw(&mut self, layout: &Layout, rs: &RasterState) {
        self.set(layout, rs.flat);
        let filled = (0..2).all(|face| rs.cull[face] || rs.mode[face] == PolygonMode::Fill) && !rs.smooth[2];
        self.batches = filled && layout.count <= MOST_SLOTS && !self.units.iter().any(|(_, unit)| unit.has_q);
    }

    /// Whether filled triangles are set up in batches.
    #[must_use]
    pub const fn is_batched(&self) -> bool {
        self.batches
    }

    /// From here on, until the next draw, each triangle is set up alone.
    #[cfg(test)]
    pub fn batch_nothing(&mut self) {
        self.batches = false;
    }

    /// Transposes the corners of a batch.
    pub(crate) fn transpose(&self, batch: &mut TriangleBatch) {
        #[expect(unsafe_code, reason = "the level was checked when the plan was made")]
        // SAFETY: a plan is made for no level that the processor does not have.
        unsafe {
            (self.transpose)(batch, self.layout.count);
        }
    }

    /// Sets up a batch; `out` gets a group of planes for each slot.
    #[inline]
    pub(crate) fn set_up_batch(&self, batch: &mut TriangleBatch, view: &BatchState, out: &mut [PlaneGroup]) {
        #[expect(unsafe_code, reason = "the level was checked when the plan was made")]
        // SAFETY: a plan is made for no level that the processor does not have.
        unsafe {
            (self.set_up_batch)(batch, &self.rules, view, out);
        }
    }

    /// Colours that are not those of the corners, because of flat shading or a back face: first slot, first slot of the
    /// values to be taken instead, how many.
    #[inline]
    pub(crate) fn color_slots(&self, back: bool) -> impl Iterator<Item = (usize, usize, usize)> {
        let back = if back { self.layout.back } else { None };
        let primary = self.layout.color.map(|slot| (slot, back.unwrap_or(slot), 4));
        // The back colours have slots for the primary one even where only the secondary one is wanted.
        let secondary = self.layout.secondary.map(|slot| (slot, back.map_or(slot, |b| b + 4), 3));
        let any = self.flat || back.is_some();
        [primary, secondary].into_iter().flatten().filter(move |_| any)
    }

    /// Appends the planes of a primitive's slots to the buffer, and fills in all of `planes` but origin and z. Slots that a
    /// vertex lacks become 0.
    #[inline]
    pub fn planes(&self, basis: &Basis, values: &CornerValues, planes: &mut Planes, pool: &mut PlaneBuffer) {
        let weights = Weights::new(basis, values.w);
        let count = self.layout.count;
        planes.first = pool.len() as u32;
        (planes.d, planes.affine, planes.wide) = (weights.d, weights.affine, 0);
        let (out, four) = pool.more(count);
        self.slots(&weights, values.corner, 0, four, out);
        self.colors(&weights, values, four, out);
        let d = weights.d;
        if weights.bound(d.at, d.x, d.y) > 2048.0 * weights.far && denominator_error(basis, &d, weights.r) > 2048.0 {
            planes.wide |= Planes::WIDE_W;
        }
        for (unit, slots) in &self.units {
            let wide_w = planes.wide & Planes::WIDE_W != 0;
            if unit_planes(basis, &weights, slots, values, wide_w, out) {
                planes.wide |= 1 << unit;
            }
        }
    }

    /// Gives one coordinate of each unit a slope of a texel a pixel, in x and in y: rho of a point is 1 (section 3.8.8), and
    /// its footprint is as wide as high. Its values stay, since they are limited to that of the vertex.
    pub(crate) fn point_footprint(&self, out: &mut [Plane]) {
        for (_, slots) in &self.units {
            let c = |k: usize| out.get(slots.base + k).map_or(0.0, |plane| f64::from(plane.c).abs());
            // s, but of a cube map a coordinate that is not the major axis, which is divided by twice that axis.
            let (k, major) = match slots.cube {
                true if c(0) >= c(1) && c(0) >= c(2) => (1, 2.0 * c(0)),
                true => (0, 2.0 * c(1).max(c(2))),
                false => (0, 1.0),
            };
            let q = if slots.has_q { out.get(slots.base + slots.count).map_or(0.0, |plane| plane.n0) } else { 1.0 };
            let size = slots.size[k];
            // Rounded down: a footprint of more than a texel would count as minified.
            let texel = f32::from_bits((1.0 / size as f32).to_bits() - u32::from(!size.is_power_of_two()));
            if let Some(plane) = out.get_mut(slots.base + k)
                && plane.min == plane.max
                && size > 0
            {
                plane.nx = f64::from(texel) * major * q;
                plane.ny = plane.nx;
            }
        }
    }

    /// The planes of the slots from `from` on. Slots that a vertex lacks become 0.
    #[inline]
    fn slots(&self, weights: &Weights, corner: [&[f32]; 3], from: usize, four: &mut FourPlanes, out: &mut [Plane]) {
        let [f0, f1, f2] = corner;
        let slots = from..from + out.len();
        let (Some(f0), Some(f1), Some(f2)) = (f0.get(slots.clone()), f1.get(slots.clone()), f2.get(slots)) else {
            out.fill(Plane::default());
            return;
        };
        let count = out.len();
        let mut at = 0;
        // The last four may repeat some, with the same result.
        while let (Some(a), Some(b), Some(c), Some(to)) =
            (four_of(f0, at), four_of(f1, at), four_of(f2, at), out.get_mut(at..at + 4))
        {
            self.four(weights, [a, b, c], four, to);
            if at + 4 == count {
                return;
            }
            at = (at + 4).min(count - 4);
        }
        let (mut a, mut b, mut c) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for (i, ((f0, f1), f2)) in f0.iter().zip(f1).zip(f2).enumerate().take(4) {
            (a[i], b[i], c[i]) = (*f0, *f1, *f2);
        }
        self.four(weights, [&a, &b, &c], four, out);
    }

    /// Up to four planes.
    #[inline]
    fn four(&self, weights: &Weights, slots: [&[f32; 4]; 3], four: &mut FourPlanes, out: &mut [Plane]) {
        #[expect(unsafe_code, reason = "the level was checked when the plan was made")]
        // SAFETY: a plan is made for no level that the processor does not have.
        unsafe {
            (self.four)(weights, slots, four);
        }
        for (i, plane) in out.iter_mut().enumerate().take(4) {
            *plane = four.plane(i);
        }
        let [a, b, c, d] = four.check;
        if (a + b + c + d).is_nan() {
            replace_non_finite(out, slots[0]);
        }
    }

    /// Makes the planes of a sprite's texture coordinates, in place of those of its vertex: s grows from 0 to 1 from the
    /// left edge to the right one, t from the upper edge to the lower one, r is 0 and q is 1. `center` is the middle of the
    /// sprite, `size` its side, both in pixels, from the middle of the origin pixel.
    pub(crate) fn sprite_planes(&self, units: u32, center: [f64; 2], size: f64, out: &mut [Plane]) {
        let step = 1.0 / size;
        let axis = |at: f64, x: f64, y: f64| Plane { c: 0.0, min: 0.0, max: 1.0, n0: at, nx: x, ny: y };
        let planes = [axis(0.5 - center[0] * step, step, 0.0), axis(0.5 + center[1] * step, 0.0, -step), constant(0.0)];
        for (_, slots) in self.units.iter().filter(|(unit, _)| units >> unit & 1 != 0) {
            for (k, plane) in planes.iter().enumerate().take(slots.count) {
                if let Some(out) = out.get_mut(slots.base + k) {
                    *out = *plane;
                }
            }
            if let Some(q) = out.get_mut(slots.base + slots.count).filter(|_| slots.has_q) {
                *q = Plane { n0: 1.0, ..Plane::default() };
            }
        }
    }

    /// Makes colours anew where they are not those of the corners: flat shading, back faces.
    fn colors(&self, weights: &Weights, values: &CornerValues, four: &mut FourPlanes, out: &mut [Plane]) {
        for (to, from, n) in self.color_slots(values.back) {
            let corners = if self.flat { [values.provoking; 3] } else { values.corner };
            if let Some(out) = out.get_mut(to..to + n) {
                self.slots(weights, corners, from, four, out);
            }
        }
    }
}

#[cfg(test)]
pub(crate) mod tests;
