//! Colours as packed pixels (OpenGL 1.5, section 2.14.9: to fixed point by rounding to the nearest), and their store.
//!
//! Where nothing comes between interpolation and the store, [`COLOR_PACKED`] does both at once: a primitive of one colour
//! is rounded once for a whole segment, others are rounded in registers.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::plane_eval::{Divisor, From, Place, Terms};
use crate::fragment::planes::{Linear, Plane, Planes};
use crate::fragment::reference::interpolate::{DIVIDES, FIRST, group, primitive, reciprocals, value, value_of_member};
use crate::fragment::reference::lanes::{CHUNK, pieces, positions, put, row_origin, single_row};
use crate::fragment::reference::places::{load, places, store};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::{clamp_f32, clamp01, round_to_int};
use crate::simd::{LANES, stage};
use crate::texture::batch::Lanes;

/// A channel in [0, 1] as a byte.
#[inline(always)]
pub(crate) fn byte(v: f32) -> u32 {
    whole(clamp01(v) * 255.0)
}

/// A value in 0..=255 as a byte.
#[inline(always)]
pub(crate) fn whole(v: f32) -> u32 {
    round_to_int(v).cast_unsigned()
}

/// Four values in 0..=255 as a pixel of bytes: [`pixel`] of [`whole`] of each. The bits of 1.5 * 2^23 that rounding leaves
/// above a byte are taken off once for all; of blue and alpha the shift drops them.
#[inline(always)]
pub(crate) fn whole_pixel(r: f32, g: f32, b: f32, a: f32) -> u32 {
    const MAGIC: f32 = 12_582_912.0;
    const LEFT: u32 = MAGIC.to_bits().wrapping_add(MAGIC.to_bits() << 8);
    let bits = |v: f32| (v + MAGIC).to_bits();
    let high = bits(b) << 16 | bits(a) << 24;
    high.wrapping_add(bits(g) << 8).wrapping_add(bits(r)).wrapping_sub(LEFT)
}

/// Four bytes as a pixel.
#[inline(always)]
pub(crate) fn pixel(r: u32, g: u32, b: u32, a: u32) -> u32 {
    r | g << 8 | b << 16 | a << 24
}

/// The packed colour of a primitive whose four colour planes are constant.
#[inline(always)]
pub(crate) fn constant(pool: &[Plane; 4]) -> Option<u32> {
    let [r, g, b, a] = pool;
    let flat = r.min == r.max && g.min == g.max && b.min == b.max && a.min == a.max;
    if flat { Some(pixel(byte(r.max), byte(g.max), byte(b.max), byte(a.max))) } else { None }
}

/// A colour plane along a row: a linear function, plus c, between min and max.
#[derive(Clone, Copy)]
struct Run {
    n: Terms<f32>,
    c: f32,
    min: f32,
    max: f32,
}

impl Run {
    /// The plane, in a row if there is one. Limits within [0, 1] save limiting the value once more.
    #[inline(always)]
    fn new(p: &Plane, row: Option<f32>) -> Self {
        let n = Terms::new(&Linear { at: p.n0, x: p.nx, y: p.ny }, row);
        Self { n, c: p.c, min: clamp01(p.min), max: clamp01(p.max) }
    }

    /// 255 times the channel of a value of the numerator, already multiplied with 1 / D.
    #[inline(always)]
    fn times_255(&self, n: f32) -> f32 {
        clamp_f32(self.c + n, self.min, self.max) * 255.0
    }
}

/// The packed colours of a row of a primitive.
#[derive(Clone, Copy)]
pub(crate) enum Paint {
    /// All the same.
    Flat(u32),
    /// Interpolated.
    Smooth(Smooth),
}

/// Interpolated colours of a row.
#[derive(Clone, Copy)]
pub(crate) struct Smooth {
    channels: [Run; 4],
    /// D along the row and its change, where it is not 1.
    d: Option<Divisor<f32>>,
    /// Alpha is constant and stands in `or`.
    opaque: bool,
    or: u32,
}

impl Paint {
    /// The colours of a row, relative to the primitive's origin, or of all of it; `None` where the primitive is wide.
    #[inline(always)]
    pub(crate) fn new(planes: &Planes, pool: &[Plane; 4], row: Option<i32>, or: u32) -> Option<Self> {
        let alpha = &pool[3];
        if let Some(packed) = constant(pool) {
            return Some(Self::Flat(packed | or));
        }
        if planes.wide & Planes::WIDE_W != 0 {
            return None;
        }
        let row = row.map(|y| y as f32);
        let opaque = alpha.min == alpha.max;
        let channels =
            [Run::new(&pool[0], row), Run::new(&pool[1], row), Run::new(&pool[2], row), Run::new(&pool[3], row)];
        let d = if planes.affine { None } else { Some(Terms::new(&planes.d, row)) };
        let or = if opaque { or | byte(alpha.max) << 24 } else { or };
        Some(Self::Smooth(Smooth { channels, d, opaque, or }))
    }

    /// The pixels at a place.
    #[inline(always)]
    pub(crate) fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        match self {
            Self::Flat(packed) => *out = [*packed; N],
            Self::Smooth(smooth) if smooth.opaque => smooth.pixels::<true, N>(place, out),
            Self::Smooth(smooth) => smooth.pixels::<false, N>(place, out),
        }
    }
}

impl Smooth {
    #[inline(always)]
    fn pixels<const OPAQUE: bool, const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        let [red, green, blue, alpha] = self.channels;
        if let Some(d) = &self.d {
            for i in 0..N {
                let rw = 1.0 / place.sum(d, i);
                let v = |run: &Run| run.times_255(place.sum(&run.n, i) * rw);
                let a = if OPAQUE { 0.0 } else { v(&alpha) };
                out[i] = whole_pixel(v(&red), v(&green), v(&blue), a) | self.or;
            }
        } else {
            for i in 0..N {
                let v = |run: &Run| run.times_255(place.sum(&run.n, i));
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
        && let Some((planes, pool)) = primitive::<4>(w, &b.segments[0], slot)
        && let (x, y) = row_origin(&b.segments[0], planes)
        && let Some(paint) = Paint::new(planes, pool, Some(y), or)
    {
        paint.pixels(From(x as f32), &mut b.packed);
        return;
    }
    for s in 0..b.segment_count.min(LANES) {
        let segment = b.segments[s];
        if let Some(planes) = w.planes.get(segment.prim as usize)
            && let Some((groups, member)) = group::<4>(w, planes, slot)
        {
            for piece in pieces(&segment) {
                let (dx, dy) = positions((&b.dx, &b.dy), &segment, planes, piece);
                let rw = reciprocals(&mut b.rw, planes, arg & FIRST != 0, piece, &dx, &dy);
                let v = [0, 1, 2, 3].map(|k: usize| value_of_member(&groups[k], member, &dx, &dy, &rw));
                let mut out = [0; CHUNK];
                for i in 0..CHUNK {
                    out[i] = pixel(byte(v[0][i]), byte(v[1][i]), byte(v[2][i]), byte(v[3][i])) | or;
                }
                put(&mut b.packed, piece, &out);
            }
            continue;
        }
        let Some((planes, pool)) = primitive::<4>(w, &segment, slot) else { continue };
        let flat = constant(pool);
        for piece in pieces(&segment) {
            let mut out = [0; CHUNK];
            if let Some(packed) = flat {
                out = [packed | or; CHUNK];
            } else {
                let (dx, dy) = positions((&b.dx, &b.dy), &segment, planes, piece);
                let rw = reciprocals(&mut b.rw, planes, arg & FIRST != 0, piece, &dx, &dy);
                let wide = planes.wide & Planes::WIDE_W != 0;
                let v = [
                    value(&pool[0], wide, &dx, &dy, &rw),
                    value(&pool[1], wide, &dx, &dy, &rw),
                    value(&pool[2], wide, &dx, &dy, &rw),
                    value(&pool[3], wide, &dx, &dy, &rw),
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
    pub(crate) fn COLOR_PACKED: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        if let Some(slot) = u.layout.color {
            color_packed(b, slot, u.packed_or, w, arg);
        }
    }

    /// [`COLOR_PACKED`] and [`STORE`] where nothing comes between them.
    pub(crate) fn COLOR_STORE: FragFn [DIVIDES] = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(slot) = u.layout.color else { return };
        color_packed(b, slot, u.packed_or, w, arg);
        store(places!(b), &b.tex.mask, &b.packed, w.band.rgba8);
    }

    /// The fragment's colour, packed.
    pub(crate) fn PACK: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        packed(&b.tex.previous, u.packed_or, &mut b.packed);
    }

    /// [`PACK`] and [`STORE`] where nothing comes between them.
    pub(crate) fn PACK_STORE: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let mut pixels = [0; LANES];
        packed(&b.tex.previous, u.packed_or, &mut pixels);
        store(places!(b), &b.tex.mask, &pixels, w.band.rgba8);
    }

    /// What blending gave, packed: it is in the store's unit and within its limits.
    pub(crate) fn PACK_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        let [red, green, blue, alpha] = &b.dst;
        for i in 0..LANES {
            b.packed[i] = whole_pixel(red[i], green[i], blue[i], alpha[i]) | u.packed_or;
        }
    }

    /// The pixels' channels as floats for blending.
    pub(crate) fn UNPACK: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            let p = b.packed_dst[i];
            b.dst[0][i] = (p & 0xFF).cast_signed() as f32;
            b.dst[1][i] = (p >> 8 & 0xFF).cast_signed() as f32;
            b.dst[2][i] = (p >> 16 & 0xFF).cast_signed() as f32;
            b.dst[3][i] = (p >> 24).cast_signed() as f32;
        }
    }

    /// Reads the pixels.
    pub(crate) fn LOAD: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        load(places!(b), w.band.rgba8, &mut b.packed_dst);
    }

    /// Bytes that the colour mask protects stay as they are.
    pub(crate) fn COLOR_MASK: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            b.packed[i] = (b.packed[i] & u.color_mask) | (b.packed_dst[i] & !u.color_mask);
        }
    }

    /// Writes the pixels of the fragments that are alive.
    pub(crate) fn STORE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        store(places!(b), &b.tex.mask, &b.packed, w.band.rgba8);
    }
}
