//! Colours as packed pixels (OpenGL 1.5, section 2.14.9: to fixed point by rounding to the nearest), and their store.
//!
//! Where nothing comes between interpolation and the store, [`COLOR_PACKED`] does both at once: a primitive of one colour
//! is rounded once for a whole segment, others are rounded in registers.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::plane_eval::{InRow, LinearEval, PlaneEval, Positions, Real};
use crate::fragment::planes::{Plane, Planes};
use crate::fragment::reference::interpolate::{DIVIDES, FIRST, reciprocals, value, value_of_member};
use crate::fragment::reference::lanes::{CHUNK, pieces, positions, put, row_origin, single_row};
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::{clamp01, round_to_int};
use crate::simd::{LANES, stage};
use crate::texture::batch::Lanes;

/// A channel in [0, 1] as a byte.
#[inline(always)]
pub fn byte(v: f32) -> u32 {
    whole(clamp01(v) * 255.0)
}

/// A value in 0..=255 as a byte.
#[inline(always)]
pub fn whole(v: f32) -> u32 {
    round_to_int(v).cast_unsigned()
}

/// Four values in 0..=255 as a pixel of bytes: [`pixel`] of [`whole`] of each. The bits of 1.5 * 2^23 that rounding leaves
/// above a byte are taken off once for all; of blue and alpha the shift drops them.
#[inline(always)]
pub fn whole_pixel(r: f32, g: f32, b: f32, a: f32) -> u32 {
    const MAGIC: f32 = 12_582_912.0;
    const LEFT: u32 = MAGIC.to_bits().wrapping_add(MAGIC.to_bits() << 8);
    let bits = |v: f32| (v + MAGIC).to_bits();
    let high = bits(b) << 16 | bits(a) << 24;
    high.wrapping_add(bits(g) << 8).wrapping_add(bits(r)).wrapping_sub(LEFT)
}

/// Four bytes as a pixel.
#[inline(always)]
pub fn pixel(r: u32, g: u32, b: u32, a: u32) -> u32 {
    r | g << 8 | b << 16 | a << 24
}

/// The packed colour of a primitive whose four colour planes are constant.
#[inline(always)]
pub fn constant(pool: &[Plane; 4]) -> Option<u32> {
    let [r, g, b, a] = pool;
    let flat = r.min == r.max && g.min == g.max && b.min == b.max && a.min == a.max;
    if flat { Some(pixel(byte(r.max), byte(g.max), byte(b.max), byte(a.max))) } else { None }
}

/// The packed primary colour of a row of a primitive, or of all of it.
#[derive(Clone, Copy)]
pub enum PackedColor {
    /// The same everywhere.
    Flat(u32),
    /// Interpolated.
    Smooth(SmoothColor),
}

/// An interpolated colour.
#[derive(Clone, Copy)]
pub struct SmoothColor {
    channels: [PlaneEval<f32>; 4],
    /// D where it is not 1.
    d: Option<LinearEval<f32>>,
    /// Alpha is constant and stands in `or`.
    opaque: bool,
    or: u32,
}

impl PackedColor {
    /// The colours of a row, relative to the primitive's origin, or of all of it; `None` where the primitive is wide.
    #[inline(always)]
    pub fn new(planes: &Planes, pool: &[Plane; 4], row: Option<i32>, or: u32) -> Option<Self> {
        let alpha = &pool[3];
        if let Some(packed) = constant(pool) {
            return Some(Self::Flat(packed | or));
        }
        if planes.wide & Planes::WIDE_W != 0 {
            return None;
        }
        let row = row.map(|y| y as f32);
        let opaque = alpha.min == alpha.max;
        let [r, g, b, a] = pool;
        let channels = [
            PlaneEval::in_unit(r, row),
            PlaneEval::in_unit(g, row),
            PlaneEval::in_unit(b, row),
            PlaneEval::in_unit(a, row),
        ];
        let d = if planes.affine { None } else { Some(LinearEval::new(&planes.d, row)) };
        let or = if opaque { or | byte(alpha.max) << 24 } else { or };
        Some(Self::Smooth(SmoothColor { channels, d, opaque, or }))
    }

    /// The pixels at N positions.
    #[inline(always)]
    pub fn pixels<const N: usize>(&self, at: impl Positions<N>, out: &mut [u32; N]) {
        match self {
            Self::Flat(packed) => *out = [*packed; N],
            Self::Smooth(smooth) => smooth.pixels(at, out),
        }
    }
}

impl SmoothColor {
    /// The pixels at N positions.
    #[inline(always)]
    pub fn pixels<const N: usize>(&self, at: impl Positions<N>, out: &mut [u32; N]) {
        if self.opaque { self.packed::<true, N>(at, out) } else { self.packed::<false, N>(at, out) }
    }

    /// Whether something is divided by D.
    pub fn divides(&self) -> bool {
        self.d.is_some()
    }

    #[inline(always)]
    fn packed<const OPAQUE: bool, const N: usize>(&self, at: impl Positions<N>, out: &mut [u32; N]) {
        let [red, green, blue, alpha] = self.channels;
        if let Some(d) = &self.d {
            for i in 0..N {
                let rw = at.sum(d, i).reciprocal();
                let v = |plane: &PlaneEval<f32>| plane.divided(at, i, rw) * 255.0;
                let a = if OPAQUE { 0.0 } else { v(&alpha) };
                out[i] = whole_pixel(v(&red), v(&green), v(&blue), a) | self.or;
            }
        } else {
            for i in 0..N {
                let v = |plane: &PlaneEval<f32>| plane.even(at, i) * 255.0;
                let a = if OPAQUE { 0.0 } else { v(&alpha) };
                out[i] = whole_pixel(v(&red), v(&green), v(&blue), a) | self.or;
            }
        }
    }
}

/// The packed colours of all segments.
#[inline(always)]
fn color_packed(b: &mut FragmentBatch, slot: usize, or: u32, w: &Work<'_, '_>, arg: u32) {
    if single_row(b)
        && let Some((planes, pool)) = w.primitive::<4>(&b.segments[0], slot)
        && let (x, y) = row_origin(&b.segments[0], planes)
        && let Some(color) = PackedColor::new(planes, pool, Some(y), or)
    {
        color.pixels(InRow(x as f32), &mut b.packed);
        return;
    }
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        if let Some(planes) = w.planes.get(segment.prim as usize)
            && let Some((groups, member)) = w.group::<4>(planes, slot)
        {
            for piece in pieces(&segment) {
                let at = positions((&b.dx, &b.dy), &segment, planes, piece);
                let rw = reciprocals(&mut b.rw, planes, arg & FIRST != 0, piece, &at);
                let v = [0, 1, 2, 3].map(|k: usize| value_of_member(&groups[k], member, &at, &rw));
                let mut out = [0; CHUNK];
                for i in 0..CHUNK {
                    out[i] = pixel(byte(v[0][i]), byte(v[1][i]), byte(v[2][i]), byte(v[3][i])) | or;
                }
                put(&mut b.packed, piece, &out);
            }
            continue;
        }
        let Some((planes, pool)) = w.primitive::<4>(&segment, slot) else { continue };
        let flat = constant(pool);
        for piece in pieces(&segment) {
            let mut out = [0; CHUNK];
            if let Some(packed) = flat {
                out = [packed | or; CHUNK];
            } else {
                let at = positions((&b.dx, &b.dy), &segment, planes, piece);
                let rw = reciprocals(&mut b.rw, planes, arg & FIRST != 0, piece, &at);
                let wide = planes.wide & Planes::WIDE_W != 0;
                let v = [
                    value(&pool[0], wide, &at, &rw),
                    value(&pool[1], wide, &at, &rw),
                    value(&pool[2], wide, &at, &rw),
                    value(&pool[3], wide, &at, &rw),
                ];
                for i in 0..CHUNK {
                    out[i] = pixel(byte(v[0][i]), byte(v[1][i]), byte(v[2][i]), byte(v[3][i])) | or;
                }
            }
            put(&mut b.packed, piece, &out);
        }
    }
}

/// Colours in [0, 1], packed.
#[inline(always)]
fn packed(color: &[Lanes; 4], or: u32, out: &mut [u32; LANES]) {
    let [red, green, blue, alpha] = color;
    let v = |v: f32| clamp01(v) * 255.0;
    for i in 0..LANES {
        out[i] = whole_pixel(v(red[i]), v(green[i]), v(blue[i]), v(alpha[i])) | or;
    }
}

stage! {
    /// The interpolated primary colour, packed: what [`COLOR`](crate::fragment::reference::interpolate::COLOR) and [`PACK`] would give.
    pub fn COLOR_PACKED: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        if let Some(slot) = u.layout.color {
            color_packed(b, slot, u.packed_or, w, arg);
        }
    }

    /// [`COLOR_PACKED`] and [`STORE`] where nothing comes between them.
    pub fn COLOR_STORE: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(slot) = u.layout.color else { return };
        color_packed(b, slot, u.packed_or, w, arg);
        store(places!(b), &b.tex.mask, &b.packed, w.band.rgba8);
    }

    /// The fragment's colour, packed.
    pub fn PACK: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        packed(&b.tex.previous, u.packed_or, &mut b.packed);
    }

    /// [`PACK`] and [`STORE`] where nothing comes between them.
    pub fn PACK_STORE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut pixels = [0; LANES];
        packed(&b.tex.previous, u.packed_or, &mut pixels);
        store(places!(b), &b.tex.mask, &pixels, w.band.rgba8);
    }

    /// What blending gave, packed: it is in the store's unit and within its limits.
    pub fn PACK_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        let [red, green, blue, alpha] = &b.dst;
        for i in 0..LANES {
            b.packed[i] = whole_pixel(red[i], green[i], blue[i], alpha[i]) | u.packed_or;
        }
    }

    /// The pixels' channels as floats for blending.
    pub fn UNPACK: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            let p = b.packed_dst[i];
            b.dst[0][i] = (p & 0xFF).cast_signed() as f32;
            b.dst[1][i] = (p >> 8 & 0xFF).cast_signed() as f32;
            b.dst[2][i] = (p >> 16 & 0xFF).cast_signed() as f32;
            b.dst[3][i] = (p >> 24).cast_signed() as f32;
        }
    }

    /// Reads the pixels.
    pub fn LOAD: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        load(places!(b), w.band.rgba8, &mut b.packed_dst);
    }

    /// Bytes that the colour mask protects stay as they are.
    pub fn COLOR_MASK: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            b.packed[i] = (b.packed[i] & u.color_mask) | (b.packed_dst[i] & !u.color_mask);
        }
    }

    /// Writes the pixels of the fragments that are alive.
    pub fn STORE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        store(places!(b), &b.tex.mask, &b.packed, w.band.rgba8);
    }
}
