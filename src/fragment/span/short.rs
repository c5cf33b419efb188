//! Rows of one primitive that are too short to be runs of their own, all at once: what is the same for all of it (planes,
//! wraps, levels, what the environment comes to) is worked out once, and depth is tested row by row. Of textured ones what is
//! alive is gathered until there are 64 pixels, so that filters work on full blocks whatever the shape is and however much
//! of it is hidden. Every number comes from the same expressions as in the stages of batches, so the bits are the same.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{Func, any, compare, digits};
use crate::fragment::lod_bounds::{self, MipRange};
use crate::fragment::plane_eval::{Extent, Points, Step};
use crate::fragment::planes::Planes;
use crate::fragment::reference::depth::WRITE;
use crate::fragment::reference::interpolate::primitive;
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::reference::pack::Paint;
use crate::fragment::reference::places::write;
use crate::fragment::reference::texcoord::unit;
use crate::fragment::span::depth::{Slope, coarse, hiz_cull, lanes};
use crate::fragment::span::levels::Between;
use crate::fragment::span::long::{DEPTH, Part, Parts, SpanShader};
use crate::fragment::span::sampled::Flat;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{BITS, LANES, stage};
use crate::texture::filter::linear_rgba8::{RGB, RGBA};

/// Pixels whose depth is tested at a time.
const STEP: usize = 16;
/// Pixels that are tested and painted at a time where colours are not gathered: loops over 16 are unrolled before they become
/// SIMD code.
const WIDE: usize = 32;
/// Pixels that are filtered at a time where few are left.
const FEW: usize = 16;
/// Depths of a cache line.
const LINE: usize = 16;
/// Rows from this length on are asked for whether the coarse depths hide them.
const HIDES: u32 = 64;
/// What a list holds: up to 64 pixels, and what a step may add.
const ROOM: usize = LANES + STEP + 8;

/// Pixels that are alive.
#[repr(align(64))]
struct List {
    /// Their distance from the first row's first pixel: 2^16 y + x + 2^15.
    place: [u32; ROOM],
    /// Where they are in the buffers.
    offset: [u32; ROOM],
    n: usize,
}

impl List {
    /// Appends the pixels that have a bit, of 16 from a place on.
    #[inline(always)]
    fn append(&mut self, bits: u32, place: u32, offset: u32) {
        for half in [0, 8] {
            let byte = (bits >> half & 0xFF) as usize;
            let columns = BITS.columns[byte];
            let (Some(places), Some(offsets)) = (
                self.place.get_mut(self.n..).and_then(|l| l.first_chunk_mut::<8>()),
                self.offset.get_mut(self.n..).and_then(|l| l.first_chunk_mut::<8>()),
            ) else {
                return;
            };
            // What is written beyond the pixels in use is overwritten by the next ones.
            for i in 0..8 {
                let column = u32::from(columns[i]) + half;
                places[i] = place.wrapping_add(column);
                offsets[i] = offset.wrapping_add(column);
            }
            self.n += usize::from(BITS.count[byte]);
        }
    }

    /// Takes the first 64 away.
    #[inline(always)]
    fn advance(&mut self) {
        for lanes in [&mut self.place, &mut self.offset] {
            if let Some((first, rest)) = lanes.split_first_chunk_mut::<LANES>()
                && let (Some(to), Some(from)) = (first.first_chunk_mut::<STEP>(), rest.first_chunk::<STEP>())
            {
                *to = *from;
            }
        }
        self.n = self.n.saturating_sub(LANES);
    }

    /// Gives the first N pixels of the list from `start` on, of which `n` are in use, their colours. `origin` is that of
    /// places, relative to the primitive's.
    #[inline(always)]
    fn shade<const N: usize, S: SpanShader>(
        &self,
        source: &S,
        (start, n): (usize, usize),
        origin: [i32; 2],
        pixels: &mut [u32],
    ) {
        let (Some(places), Some(offsets)) = (
            self.place.get(start..).and_then(|l| l.first_chunk::<N>()),
            self.offset.get(start..).and_then(|l| l.first_chunk::<N>()),
        ) else {
            return;
        };
        let mut points = Points { x: [0.0; N], y: [0.0; N] };
        for i in 0..N {
            // Lanes that are not in use are where the first one is.
            let place = if i < n { places[i] } else { places[0] };
            points.x[i] = ((place & 0xFFFF).cast_signed() + origin[0]) as f32;
            points.y[i] = ((place >> 16).cast_signed() + origin[1]) as f32;
        }
        let mut out = [0; N];
        if S::BLENDS {
            for (out, at) in out.iter_mut().zip(offsets).take(n) {
                *out = pixels.get(*at as usize).copied().unwrap_or(0);
            }
        }
        source.pixels(&points, &mut out);
        for (out, at) in out.iter().zip(offsets).take(n) {
            if let Some(pixel) = pixels.get_mut(*at as usize) {
                *pixel = *out;
            }
        }
    }
}

/// The depth test.
#[derive(Clone, Copy)]
struct Test {
    func: Func,
    writes: bool,
}

impl Test {
    /// That of a stage's number.
    #[inline(always)]
    fn new(arg: u32) -> Option<Self> {
        (arg & DEPTH != 0).then(|| Self { func: Func::from_arg(arg >> 1), writes: arg & WRITE != 0 })
    }

    /// Which of the first `n` pixels from x on pass.
    #[inline(always)]
    fn pass<const N: usize>(self, slope: &Slope, x: i32, n: u32, depth: &mut [u32; N]) -> [u32; N] {
        let mut z = [0; N];
        slope.depths(x, &mut z);
        let mut mask = lanes::<N>(n as usize);
        compare(self.func, &z, depth, &mut mask);
        if self.writes {
            write(false, &mask, &z, depth);
        }
        mask
    }

    /// A bit for each of the first `n` pixels from x on that passes.
    #[inline(always)]
    fn bits(self, slope: &Slope, x: i32, n: u32, depth: &mut [u32], offset: u32) -> u32 {
        if let Some(depth) = chunk(depth, offset) {
            return digits(&self.pass::<STEP>(slope, x, n, depth));
        }
        // The buffer's end.
        let mut bits = 0;
        for i in 0..n {
            if let Some(depth) = chunk(depth, offset.wrapping_add(i)) {
                bits |= digits(&self.pass::<1>(slope, x.wrapping_add(i.cast_signed()), 1, depth)) << i;
            }
        }
        bits
    }
}

/// N elements of a buffer, if it has so many from there on.
#[inline(always)]
fn chunk<const N: usize>(buffer: &mut [u32], at: u32) -> Option<&mut [u32; N]> {
    buffer.get_mut(at as usize..)?.first_chunk_mut()
}

/// Depth along a row of a primitive.
#[inline(always)]
fn slope(row: &Segment, planes: &Planes, u: &FragUniforms) -> Slope {
    let (x, y) = row_origin(row, planes);
    let last = x.wrapping_add(row.len.wrapping_sub(1).cast_signed());
    Slope::new(&planes.z, y, u.depth_max).between(x, last)
}

/// Between which numbers x and y of some rows are, relative to the primitive's origin.
#[inline(always)]
fn limits(rows: &[Segment], planes: &Planes) -> [[i32; 2]; 2] {
    let (mut least, mut greatest) = ([i32::MAX; 2], [i32::MIN; 2]);
    for row in rows {
        let (x, y) = row_origin(row, planes);
        let last = x.wrapping_add(row.len.cast_signed()).wrapping_sub(1);
        least = [least[0].min(x), least[1].min(y)];
        greatest = [greatest[0].max(last), greatest[1].max(y)];
    }
    [[least[0], greatest[0]], [least[1], greatest[1]]]
}

/// Takes pixels off the rows' starts that the coarse depths hide.
#[inline(always)]
fn trim(rows: &mut [Segment], planes: &Planes, u: &FragUniforms, w: &Work<'_, '_>, func: Func) {
    if !coarse(func) {
        return;
    }
    for row in rows {
        if row.len >= HIDES {
            let x = row.x.wrapping_sub(planes.origin[0]);
            let n = hiz_cull(w.band, row, &slope(row, planes, u), x, func);
            *row = Segment {
                x: row.x.wrapping_add(n.cast_signed()),
                offset: row.offset.wrapping_add(n),
                len: row.len.saturating_sub(n),
                ..*row
            };
        }
    }
}

/// Reads a depth of each cache line that rows will read. Processors foresee what comes next in a row, but not where the next
/// one begins: so that is not waited for row by row, but for all rows at once.
#[inline(always)]
fn touch(rows: &[Segment], depth: &[u32]) {
    let mut sum = 0u32;
    for row in rows {
        let (start, len) = (row.offset as usize, row.len as usize);
        if len == 0 {
            continue;
        }
        for at in (0..len).step_by(LINE) {
            sum ^= depth.get(start + at).copied().unwrap_or(0);
        }
        sum ^= depth.get((start + len).wrapping_sub(1)).copied().unwrap_or(0);
    }
    std::hint::black_box(sum);
}

/// What an image gives the rows of the batch's segments, all of one primitive; leaves in `tex.n` how many of them are done, which
/// is all or none.
#[inline(always)]
fn textured<const K: usize, P: Parts<K>>(
    b: &mut FragmentBatch,
    u: &FragUniforms,
    w: &mut Work<'_, '_>,
    arg: u32,
    of: Option<P>,
) {
    b.tex.n = 0;
    let rows = b.segments.get(..b.segment_count).unwrap_or(&[]);
    let Some(first) = rows.first() else { return };
    let (Some(planes), Some(of)) = (w.planes.get(first.prim as usize), of) else { return };
    let Some(Some(slots)) = u.layout.units.get(of.unit() as usize) else { return };
    let Some(unit) = unit::<K>(w, first, slots, of.unit()) else { return };
    let reads = match u.levels.get(of.unit() as usize) {
        Some(Some(levels)) => lod_bounds::of_rows(&b.tex, &unit, limits(rows, planes), levels),
        _ => Some(MipRange::One(0)),
    };
    let Some(reads) = reads else { return };
    let part = Part { segment: *first, extent: Extent::All, unit, reads };
    let Some(source) = of.source(u, w, &part) else { return };
    let rows = b.segments.get_mut(..b.segment_count).unwrap_or(&mut []);
    if let Some(test) = Test::new(arg) {
        trim(rows, planes, u, w, test.func);
    }
    colored(rows, (planes, &source), u, w, arg);
    b.tex.n = rows.len();
}

/// Colours of the rows of a primitive.
#[inline(always)]
fn colored<S: SpanShader>(
    rows: &[Segment],
    (planes, source): (&Planes, &S),
    u: &FragUniforms,
    w: &mut Work<'_, '_>,
    arg: u32,
) {
    let Some(first) = rows.first() else { return };
    let test = Test::new(arg);
    if test.is_some() {
        touch(rows, w.band.depth);
    }
    let (x0, y0) = row_origin(first, planes);
    let origin = [x0.wrapping_sub(1 << 15), y0];
    let mut list = List { place: [0; ROOM], offset: [0; ROOM], n: 0 };
    let mut rest = rows.iter();
    let (mut row, mut along, mut done, mut len) = (*first, Slope::new(&planes.z, 0, 0.0), 0, 0);
    loop {
        while list.n < LANES {
            if done >= len {
                let Some(next) = rest.next() else { break };
                (row, done, len) = (*next, 0, next.len);
                along = slope(next, planes, u);
            }
            let n = if len - done < STEP as u32 { len - done } else { STEP as u32 };
            let (x, offset) = (row.x.wrapping_add(done.cast_signed()), row.offset.wrapping_add(done));
            let mut bits = (1u32 << n) - 1;
            if let Some(test) = test {
                let x = x.wrapping_sub(planes.origin[0]);
                bits = test.bits(&along, x, n, w.band.depth, offset);
            }
            let (dx, dy) = (x.wrapping_sub(first.x), row.y.wrapping_sub(first.y));
            let place = (dy.cast_unsigned() << 16).wrapping_add(dx.cast_unsigned()).wrapping_add(1 << 15);
            if bits != 0 {
                list.append(bits, place, offset);
            }
            done += n;
        }
        let n = list.n.min(LANES);
        if n > 2 * FEW {
            list.shade::<LANES, _>(source, (0, n), origin, w.band.rgba8);
        } else {
            let mut start = 0;
            while start < n {
                list.shade::<FEW, _>(source, (start, n - start), origin, w.band.rgba8);
                start += FEW;
            }
        }
        if n < LANES {
            break;
        }
        list.advance();
    }
}

/// Pixels of a row from (x, y) on, the first `n` of N; false, and nothing done, where a buffer ends before.
#[inline(always)]
fn paint_step<const N: usize>(
    w: &mut Work<'_, '_>,
    (paint, slope, test): (&Paint, &Slope, Test),
    (x, y, n): (i32, i32, u32),
    offset: u32,
) -> bool {
    let (Some(depth), Some(pixels)) = (chunk(w.band.depth, offset), chunk(w.band.rgba8, offset)) else { return false };
    let mask = test.pass::<N>(slope, x, n, depth);
    if any(&mask) {
        let mut out = [0; N];
        paint.pixels(Step { x: x as f32, y: y as f32 }, &mut out);
        write(false, &mask, &out, pixels);
    }
    true
}

/// The same where colours cost so little that they are not gathered: 32 pixels of a row at a time.
#[inline(always)]
fn painted(rows: &[Segment], (planes, paint): (&Planes, &Paint), u: &FragUniforms, w: &mut Work<'_, '_>, test: Test) {
    touch(rows, w.band.depth);
    for row in rows {
        let (x, y) = row_origin(row, planes);
        let along = slope(row, planes, u);
        let mut done = 0;
        while done < row.len {
            let n = if row.len - done < WIDE as u32 { row.len - done } else { WIDE as u32 };
            let (x, offset) = (x.wrapping_add(done.cast_signed()), row.offset.wrapping_add(done));
            if !paint_step::<WIDE>(w, (paint, &along, test), (x, y, n), offset) {
                for i in 0..n {
                    let x = x.wrapping_add(i.cast_signed());
                    paint_step::<1>(w, (paint, &along, test), (x, y, 1), offset.wrapping_add(i));
                }
            }
            done += n;
        }
    }
}

stage! {
    /// [`FILL`](crate::fragment::span::long::FILL) of many rows, with a colour.
    pub(crate) fn ROWS_COLOR: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        b.tex.n = 0;
        let rows = b.segments.get(..b.segment_count).unwrap_or(&[]);
        if let (Some(first), Some(slot)) = (rows.first(), u.layout.color)
            && let Some((planes, pool)) = primitive::<4>(w, first, slot)
            && let Some(paint) = Paint::new(planes, pool, None, u.packed_or)
            && let Some(test) = Test::new(arg)
        {
            painted(rows, (planes, &paint), u, w, test);
            b.tex.n = rows.len();
        }
    }

    /// [`FILL_TEXELS`](crate::fragment::span::long::FILL_TEXELS) of many rows.
    pub(crate) fn ROWS_TEXELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.copied.as_ref());
    }

    /// [`FILL_RGB`](crate::fragment::span::long::FILL_RGB) of many rows.
    pub(crate) fn ROWS_RGB: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGB, false>::of));
    }

    /// [`ROWS_RGB`] with four channels.
    pub(crate) fn ROWS_RGBA: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGBA, false>::of));
    }

    /// [`ROWS_RGB`] with blending.
    pub(crate) fn ROWS_RGB_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGB, true>::of));
    }

    /// [`ROWS_RGBA`] with blending.
    pub(crate) fn ROWS_RGBA_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGBA, true>::of));
    }

    /// What [`ROWS_RGB`] leaves because two levels are blended.
    pub(crate) fn ROWS_RGB_LEVELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Between::<RGB>::of));
    }

    /// What [`ROWS_RGBA`] leaves because two levels are blended.
    pub(crate) fn ROWS_RGBA_LEVELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        textured(b, u, w, arg, u.shown.as_ref().and_then(Between::<RGBA>::of));
    }
}
