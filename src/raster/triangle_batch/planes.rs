//! The planes of a batch of triangles, a triangle a lane (OpenGL 1.5, section 3.5.1): what [`setup`] and [`weights`] do for
//! one triangle, by the same operations in the same order, so that both give the same bits. A triangle with NaN or infinite
//! planes, or whose ranges may need f64, is marked, and its planes are made alone.
//!
//! [`setup`]: crate::raster::setup::triangle
//! [`weights`]: crate::raster::setup::weights

use super::TriangleBatch;
use super::corners::CornerLanes;
use super::lanes::{ALONE, BLOCK, BasisLanes, F64x16, LINEAR_LANES, LinearLanes, MASK, NOTHING, ZERO};
use super::masks::masks;
use super::rows::{ROWS, rows};
use crate::fragment::planes::{GROUP, Layout, PlaneGroup};
use crate::raster::setup::depth::{beyond, limited, polygon_offset};
use crate::raster::setup::position::LIMIT as LIMIT_OF_POSITIONS;
use crate::raster::setup::texcoord_planes::{LIMIT, whole_periods};
use crate::raster::setup::weights::range;
use crate::raster::state::Rect;
use crate::simd::stage;

/// What the layout of a draw asks of each slot.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlotRules {
    /// The texture coordinate that each slot is, if it is one.
    pub slots: Vec<Option<TexcoordSlot>>,
}

/// A slot that is a texture coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexcoordSlot {
    period: u8,
    texels: f64,
    cube: bool,
    last: bool,
}

impl SlotRules {
    /// Takes a layout, none of whose units has a q.
    pub(crate) fn set(&mut self, layout: &Layout) {
        self.slots.clear();
        self.slots.resize(layout.count, None);
        for unit in layout.units.iter().flatten() {
            for k in 0..unit.count.min(3) {
                if let Some(slot) = self.slots.get_mut(unit.base + k) {
                    let (period, texels) = (unit.period[k], f64::from(unit.size[k]));
                    *slot = Some(TexcoordSlot { period, texels, cube: unit.cube, last: k + 1 == unit.count });
                }
            }
        }
    }
}

/// The state that decides what becomes of a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BatchState {
    /// Where pixels may be written.
    pub area: Rect,
    /// Whether triangles that wind counter-clockwise, or do not, are culled.
    pub culls: [bool; 2],
    /// The depth buffer's largest value, by which window z is multiplied.
    pub scale: f64,
    /// Factor and units of the polygon offset.
    pub offset: Option<[f64; 2]>,
}

/// Side of the largest bounding box of a member. Its runs of pixels are too short to be drawn as spans.
const MOST: i32 = ROWS as i32;

/// Where w, window x (then y) and z are among a corner's numbers.
const W: usize = 0;
const X: usize = 1;
const Z: usize = 3;

/// The numbers of each corner.
type CornerPositions = [[F64x16; 4]; 3];

/// Transposes positions, corner by corner, into lanes. All four numbers are moved in one loop: separate loops become scalar
/// code.
#[inline(always)]
fn lanes(quads: &[[[f64; 4]; GROUP]; 3], out: &mut CornerPositions) {
    for (quads, [a, b, c, d]) in quads.iter().zip(out) {
        for i in 0..GROUP {
            [a[i], b[i], c[i], d[i]] = quads[i];
        }
    }
}

/// The same for four slots.
#[inline(always)]
fn slot_lanes(quads: &[[[f32; 4]; GROUP]; 3], out: &mut [[[f32; GROUP]; 3]; 4]) {
    let [a, b, c, d] = out;
    for (corner, quads) in quads.iter().enumerate() {
        let (a, b, c, d) = (&mut a[corner], &mut b[corner], &mut c[corner], &mut d[corner]);
        for i in 0..GROUP {
            [a[i], b[i], c[i], d[i]] = quads[i];
        }
    }
}

/// Transposes the corners, with so many slots, into lanes.
pub(crate) type TransposeFn = unsafe fn(&mut TriangleBatch, usize);

/// Sets up a batch: coverage, and one batch of planes for each slot.
pub(crate) type SetUpBatchFn = unsafe fn(&mut TriangleBatch, &SlotRules, &BatchState, &mut [PlaneGroup]);

/// What the members of a batch are like.
struct BatchExtent {
    /// The largest width and height of masks.
    masks: [u32; 2],
    /// The most rows of the others.
    rows: u32,
    /// Whether there is a member.
    any: bool,
}

/// Bounding boxes, areas, and what becomes of each triangle.
#[inline(always)]
fn classify(batch: &mut TriangleBatch, view: &BatchState) -> BatchExtent {
    let TriangleBatch { corners: CornerLanes { snapped: p, .. }, first, last, area, kind, cut, .. } = batch;
    for i in 0..GROUP {
        // A triangle beyond the limit is made one that covers nothing: three times the same corner.
        let mut within = true;
        for corner in p.iter() {
            within &= ((corner[0][i].wrapping_add(LIMIT_OF_POSITIONS) | corner[1][i].wrapping_add(LIMIT_OF_POSITIONS))
                as u32)
                < 2 * LIMIT_OF_POSITIONS as u32;
        }
        for corner in p.iter_mut() {
            corner[0][i] = if within { corner[0][i] } else { 0 };
            corner[1][i] = if within { corner[1][i] } else { 0 };
        }
    }
    for k in 0..2 {
        for i in 0..GROUP {
            let [a, b, c] = [p[0][k][i], p[1][k][i], p[2][k][i]];
            first[k][i] = (a.min(b).min(c) + 127) >> 8;
            last[k][i] = (a.max(b).max(c) + 128) >> 8;
        }
    }
    let (mut width, mut height, mut rows, mut members) = (0, 0, 0, 0);
    let [positive, other] = view.culls;
    for i in 0..GROUP {
        let side = |k: usize, c: usize| p[c][k][i] - p[0][k][i];
        // This overflows for large triangles, which are set up alone.
        area[i] = side(0, 1).wrapping_mul(side(1, 2)).wrapping_sub(side(0, 2).wrapping_mul(side(1, 1)));
        let [x0, y0, x1, y1] = [first[0][i], first[1][i], last[0][i], last[1][i]];
        let (x, y) = (x1 - x0, y1 - y0);
        let (small, member) = ((x <= 8) & (y <= 8), (x <= MOST) & (y <= MOST));
        let r = &view.area;
        let seen = (x0.max(r.x0) < x1.min(r.x1)) & (y0.max(r.y0) < y1.min(r.y1));
        let culled = ((area[i] > 0) & positive) | ((area[i] <= 0) & other);
        let nothing = !seen | (member & (culled | (area[i] == 0)));
        let size = if small { MASK } else { BLOCK };
        let size = if member { size } else { ALONE };
        let size = if nothing { NOTHING } else { size };
        kind[i] = size;
        cut[i] = i32::from((x0 < r.x0) | (y0 < r.y0) | (x1 > r.x1) | (y1 > r.y1));
        width = width.max(if size == MASK { x } else { 0 });
        height = height.max(if size == MASK { y } else { 0 });
        rows = rows.max(if size == BLOCK { y } else { 0 });
        members |= i32::from((size == MASK) | (size == BLOCK));
    }
    BatchExtent { masks: [width, height].map(i32::unsigned_abs), rows: rows.unsigned_abs(), any: members != 0 }
}

/// The pixels that positions are relative to.
#[inline(always)]
fn origins(batch: &mut TriangleBatch) {
    let TriangleBatch { corners: CornerLanes { snapped: p, position, .. }, first, origin, .. } = batch;
    for k in 0..2 {
        for i in 0..GROUP {
            // The mean of the three in whole pixels, by a multiplication in place of a division: it is between -1 and 17
            // pixels from the box.
            let from = first[k][i];
            let sum = (p[0][k][i] + p[1][k][i] + p[2][k][i]) - 768 * from + 768;
            origin[k][i] = from - 1 + ((sum >> 8).wrapping_mul(43691) >> 17);
        }
    }
    let mut any = false;
    let varies = |i: usize| {
        let [a, b, c] = [position[0][W][i], position[1][W][i], position[2][W][i]];
        let most = if b > a { b } else { a };
        let most = if c > most { c } else { most };
        (most, (most > 2.0 * a) | (most > 2.0 * b) | (most > 2.0 * c))
    };
    for i in 0..GROUP {
        any |= varies(i).1;
    }
    // Few small triangles have their origin at the far end.
    for i in (0..GROUP).filter(|_| any) {
        let (most, varies) = varies(i);
        let far = (0..3).find(|c| position[*c][W][i] == most).unwrap_or(0);
        for k in 0..2 {
            origin[k][i] = if varies { p[far][k][i] >> 8 } else { origin[k][i] };
        }
    }
}

/// The weights of the corners, from the unsnapped positions where their area is about that of the snapped ones.
#[inline(always)]
fn bases(batch: &mut TriangleBatch) {
    let TriangleBatch { corners: CornerLanes { snapped: p, position, .. }, origin, area, bases, .. } = batch;
    for i in 0..GROUP {
        let snapped_det = f64::from(area[i]) * (1.0 / 65536.0);
        let from = [0, 1].map(|k: usize| f64::from(origin[k][i]) + 0.5);
        let exact = |c: usize, k: usize| position[c][X + k][i] - from[k];
        let grid = |c: usize, k: usize| f64::from(p[c][k][i] - (origin[k][i] << 8) - 128) * (1.0 / 256.0);
        let det = (exact(1, 0) - exact(0, 0)) * (exact(2, 1) - exact(0, 1))
            - (exact(2, 0) - exact(0, 0)) * (exact(1, 1) - exact(0, 1));
        let ratio = det * snapped_det;
        let square = snapped_det * snapped_det;
        let alike = (ratio > 0.5 * square) & (ratio < 2.0 * square);
        let at = |c: usize, k: usize| if alike { exact(c, k) } else { grid(c, k) };
        let [[x0, y0], [x1, y1], [x2, y2]] = [[at(0, 0), at(0, 1)], [at(1, 0), at(1, 1)], [at(2, 0), at(2, 1)]];
        let inv = 1.0 / if alike { det } else { snapped_det };
        let (ax, ay) = ((y2 - y0) * inv, (x0 - x2) * inv);
        let (bx, by) = ((y0 - y1) * inv, (x1 - x0) * inv);
        let [b1, b2] = &mut bases.b;
        (b1.at[i], b1.x[i], b1.y[i]) = (-(x0 * ax + y0 * ay), ax, ay);
        (b2.at[i], b2.x[i], b2.y[i]) = (-(x0 * bx + y0 * by), bx, by);
        bases.reach[0][i] = range([x0.abs(), x1.abs(), x2.abs()]).1;
        bases.reach[1][i] = range([y0.abs(), y1.abs(), y2.abs()]).1;
    }
}

/// The depth planes, and what the depths of fragments are limited to.
#[inline(always)]
fn depths(batch: &mut TriangleBatch, view: &BatchState, needs_scalar: &mut F64x16) {
    let TriangleBatch { corners: CornerLanes { position, .. }, bases, z, z_range: [lows, highs], .. } = batch;
    let [b1, b2] = &bases.b;
    for i in 0..GROUP {
        let [z0, z1, z2] = [position[0][Z][i], position[1][Z][i], position[2][Z][i]].map(|z| z * view.scale);
        let (g1, g2) = (z1 - z0, z2 - z0);
        let at = z0 + (g1 * b1.at[i] + g2 * b2.at[i]);
        let x = g1 * b1.x[i] + g2 * b2.x[i];
        let y = g1 * b1.y[i] + g2 * b2.y[i];
        let (low, high) = range([z0, z1, z2]);
        let beyond = beyond(x, y, low, high);
        (z.at[i], z.x[i], z.y[i]) = (at, x, y);
        (lows[i], highs[i]) = (low - beyond, high + beyond);
        needs_scalar[i] = (at + x + y) * 0.0;
    }
    if let Some(offset) = view.offset {
        for i in 0..GROUP {
            let offset = polygon_offset(z.x[i], z.y[i], offset, view.scale);
            z.at[i] += offset;
            lows[i] += offset;
            highs[i] += offset;
        }
    }
    for i in 0..GROUP {
        (lows[i], highs[i]) = (limited(lows[i], view.scale), limited(highs[i], view.scale));
    }
}

/// 1/w over each triangle, and the weights that belong to it.
#[inline(always)]
fn perspective(batch: &mut TriangleBatch, needs_scalar: &mut F64x16) {
    let TriangleBatch { corners: CornerLanes { position, .. }, bases, affine, .. } = batch;
    let mut most = false;
    for i in 0..GROUP {
        let w = [position[0][W][i], position[1][W][i], position[2][W][i]];
        let same = (w[0] == w[1]) & (w[1] == w[2]);
        let usual = (range(w).0 > 0.0) & (w[0] + w[1] + w[2] < f64::INFINITY);
        affine[i] = same | !usual;
        most |= !affine[i];
    }
    bases.d = LinearLanes { at: [1.0; GROUP], ..LINEAR_LANES };
    (bases.far, bases.scale, bases.denominator) = ([1.0; GROUP], [1.0; GROUP], ZERO);
    if most {
        denominators(position, affine, bases, needs_scalar);
    }
}

/// D, and the weights that belong to it, where w varies.
#[inline(always)]
fn denominators(position: &CornerPositions, affine: &[bool; GROUP], bases: &mut BasisLanes, needs_scalar: &mut F64x16) {
    let BasisLanes { d, b: [b1, b2], far, scale, reach, denominator } = bases;
    for i in 0..GROUP {
        let w = [position[0][W][i], position[1][W][i], position[2][W][i]];
        let least = range(w).0;
        let one = affine[i];
        let r = [least / w[0], least / w[1], least / w[2]];
        let (g1, g2) = (r[1] - r[0], r[2] - r[0]);
        let at = r[0] + (g1 * b1.at[i] + g2 * b2.at[i]);
        let x = g1 * b1.x[i] + g2 * b2.x[i];
        let y = g1 * b1.y[i] + g2 * b2.y[i];
        let (at, x, y) = (if one { 1.0 } else { at }, if one { 0.0 } else { x }, if one { 0.0 } else { y });
        let least_r = if one { 1.0 } else { range(r).0 };
        let good = (at >= 0.5 * least_r) & (at <= 2.0);
        far[i] = least_r;
        scale[i] = if good { 1.0 / at } else { 0.0 };
        (d.at[i], d.x[i], d.y[i]) = (at, x, y);
        let (r1, r2) = (if one { 1.0 } else { r[1] }, if one { 1.0 } else { r[2] });
        (b1.at[i], b1.x[i], b1.y[i]) = (r1 * b1.at[i], r1 * b1.x[i], r1 * b1.y[i]);
        (b2.at[i], b2.x[i], b2.y[i]) = (r2 * b2.at[i], r2 * b2.x[i], r2 * b2.y[i]);
        let bound = at.abs() + x.abs() * reach[0][i] + y.abs() * reach[1][i];
        denominator[i] = if one { 0.0 } else { bound };
        needs_scalar[i] = if bound > 2048.0 * least_r { f64::NAN } else { needs_scalar[i] };
    }
}

/// A slot's numerators before they are rounded.
struct Numerators {
    at: F64x16,
    x: F64x16,
    y: F64x16,
}

/// The planes of one slot.
#[inline(always)]
fn slot(bases: &BasisLanes, f: &[[f32; GROUP]; 3], needs_scalar: &mut F64x16, out: &mut PlaneGroup) -> Numerators {
    let BasisLanes { d, b: [b1, b2], scale, .. } = bases;
    let mut n = Numerators { at: ZERO, x: ZERO, y: ZERO };
    let [f0, f1, f2] = f;
    for i in 0..GROUP {
        let [f0, f1, f2] = [f0[i], f1[i], f2[i]];
        let base = f64::from(f0);
        let (g1, g2) = (f64::from(f1) - base, f64::from(f2) - base);
        let at = g1 * b1.at[i] + g2 * b2.at[i];
        let x = g1 * b1.x[i] + g2 * b2.x[i];
        let y = g1 * b1.y[i] + g2 * b2.y[i];
        let (min, max) = range([f0, f1, f2]);
        let here = (f64::from(f0) + at * scale[i]) as f32;
        let here = if here < min { min } else { here };
        let c = if here > max { max } else { here };
        let delta = f64::from(c) - f64::from(f0);
        let (at, x, y) = (at - delta * d.at[i], x - delta * d.x[i], y - delta * d.y[i]);
        needs_scalar[i] += (at + x + y) * 0.0;
        (out.c[i], out.min[i], out.max[i]) = (c, min, max);
        (out.n0[i], out.nx[i], out.ny[i]) = (at as f32, x as f32, y as f32);
        (n.at[i], n.x[i], n.y[i]) = (at, x, y);
    }
    n
}

/// How large the terms of a unit's coordinates become, in texels, and the limit for a cube map.
struct TexcoordError {
    error: F64x16,
    greatest: F64x16,
}

impl TexcoordError {
    const NONE: Self = Self { error: ZERO, greatest: ZERO };

    /// Adds a coordinate, before whole periods are subtracted.
    #[inline(always)]
    fn coordinate(&mut self, bases: &BasisLanes, of: &TexcoordSlot, n: &Numerators, planes: &PlaneGroup) {
        for i in 0..GROUP {
            let spread = f64::from(planes.max[i]) - f64::from(planes.min[i]);
            let bound = n.at[i].abs() + n.x[i].abs() * bases.reach[0][i] + n.y[i].abs() * bases.reach[1][i];
            let terms = (bound + bases.denominator[i] * spread) * of.texels;
            self.error[i] = if terms > self.error[i] { terms } else { self.error[i] };
        }
        for i in 0..GROUP {
            let (low, high) = (f64::from(planes.min[i]).abs(), f64::from(planes.max[i]).abs());
            let high = if high > low { high } else { low };
            let greatest = if high > self.greatest[i] { high } else { self.greatest[i] };
            self.greatest[i] = if of.cube { greatest } else { 1.0 };
        }
    }

    /// After the last coordinate of a unit: marks the triangles that may need f64.
    #[inline(always)]
    fn finish(&mut self, bases: &BasisLanes, needs_scalar: &mut F64x16) {
        for i in 0..GROUP {
            let narrow = self.error[i] <= LIMIT * bases.far[i] * self.greatest[i];
            needs_scalar[i] = if narrow { needs_scalar[i] } else { f64::NAN };
        }
        *self = Self::NONE;
    }
}

/// Subtracts whole periods.
#[inline(always)]
fn subtract_periods(planes: &mut PlaneGroup, period: u8) {
    if period == 0 {
        return;
    }
    for i in 0..GROUP {
        let whole = whole_periods(f64::from(planes.c[i]), period);
        planes.c[i] = (f64::from(planes.c[i]) - whole) as f32;
        planes.min[i] = (f64::from(planes.min[i]) - whole) as f32;
        planes.max[i] = (f64::from(planes.max[i]) - whole) as f32;
    }
}

stage! {
    /// Transposes the corners of a batch.
    pub(crate) fn TRANSPOSE: TransposeFn = (batch: &mut TriangleBatch, count: usize) {
        let TriangleBatch { quads, position, corners, .. } = batch;
        lanes(position, &mut corners.position);
        // The last quad first: where it repeats slots of the quad before it, that one has the right colours.
        for (k, quad) in quads.iter().enumerate().take(count.div_ceil(4)).rev() {
            let first = (4 * k).min(count.max(4) - 4);
            if let Some(slots) = corners.slots.get_mut(first..).and_then(|slots| slots.first_chunk_mut()) {
                slot_lanes(quad, slots);
            }
        }
    }

    /// Coverage and planes of a batch.
    pub(crate) fn SET_UP_BATCH: SetUpBatchFn = (batch: &mut TriangleBatch, rules: &SlotRules, view: &BatchState, out: &mut [PlaneGroup]) {
        let members = classify(batch, view);
        if !members.any {
            return;
        }
        let mut needs_scalar = ZERO;
        origins(batch);
        masks(&batch.corners.snapped, &batch.area, &batch.first, members.masks, &mut batch.bits);
        if members.rows > 0 {
            batch.pixels = rows(&batch.corners.snapped, &batch.area, &batch.first, members.rows, &mut batch.ends);
        }
        bases(batch);
        depths(batch, view, &mut needs_scalar);
        perspective(batch, &mut needs_scalar);
        let mut terms = TexcoordError::NONE;
        for (rule, (f, planes)) in rules.slots.iter().zip(batch.corners.slots.iter().zip(out)) {
            let numerators = slot(&batch.bases, f, &mut needs_scalar, planes);
            if let Some(of) = rule {
                terms.coordinate(&batch.bases, of, &numerators, planes);
                if of.last {
                    terms.finish(&batch.bases, &mut needs_scalar);
                }
                subtract_periods(planes, of.period);
            }
        }
        batch.needs_scalar = needs_scalar;
    }
}
