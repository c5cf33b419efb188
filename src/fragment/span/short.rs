//! Short spans: the rows of one primitive that are too short to be done each by itself, all at once. What is the same for
//! all of it (planes, wraps, levels, what the environment comes to) is worked out once, and depth is tested row by row. Of
//! textured ones what is alive is gathered until there are 64 pixels, so that filters work on full blocks whatever the shape
//! is and however much of it is hidden.

use super::long::DEPTH;
use super::shader::{Part, SpanShader, SpanSource};
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{CompareFunc, any, compare, digits, living};
use crate::fragment::hiz::{hiz_cull, uses_hiz};
use crate::fragment::lod_bounds;
use crate::fragment::mip_range::MipRange;
use crate::fragment::plane_eval::{Extent, FromPixel, Points};
use crate::fragment::planes::Planes;
use crate::fragment::reference::depth::{DepthSlope, WRITE, lanes};
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::reference::places::write;
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::simd::{BITS, LANES};

/// Pixels whose depth is tested at a time.
const STEP: usize = 16;
/// Pixels that are tested and coloured at a time where pixels are not gathered: loops over 16 are unrolled before they
/// become SIMD code.
const WIDE: usize = 32;
/// Pixels that are filtered at a time where few are left.
const FEW: usize = 16;
/// Depths of a cache line.
const LINE: usize = 16;
/// Rows from this length on, in pixels, are tested against hierarchical depth.
const HIZ_FROM: u32 = 64;
/// The capacity of a list: up to 64 pixels, and what a step may add.
const ROOM: usize = LANES + STEP + 8;

/// A list of pixels that are alive.
#[repr(align(64))]
struct LivePixels {
    /// Their distance from the first row's first pixel: 2^16 y + x + 2^15.
    place: [u32; ROOM],
    /// Where they are in the buffers.
    offset: [u32; ROOM],
    n: usize,
}

impl LivePixels {
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
        shader: &S,
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
        let (mut below, mut out) = ([0; N], [0; N]);
        if shader.blends() {
            for (out, at) in below.iter_mut().zip(offsets).take(n) {
                *out = pixels.get(*at as usize).copied().unwrap_or(0);
            }
        }
        shader.pixels(&points, &below, &mut out);
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
    func: CompareFunc,
    writes: bool,
}

impl Test {
    /// The test in a kernel's argument, if there is one.
    #[inline(always)]
    fn new(arg: u32) -> Option<Self> {
        (arg & DEPTH != 0).then(|| Self { func: CompareFunc::from_arg(arg >> 1), writes: arg & WRITE != 0 })
    }

    /// Which of the first `n` pixels from x on pass.
    #[inline(always)]
    fn pass<const N: usize>(self, slope: &DepthSlope, x: i32, n: u32, depth: &mut [u32; N]) -> [u32; N] {
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
    fn bits(self, slope: &DepthSlope, x: i32, n: u32, depth: &mut [u32], offset: u32) -> u32 {
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
fn slope(row: &Segment, planes: &Planes) -> DepthSlope {
    let (x, y) = row_origin(row, planes);
    let last = x.wrapping_add(row.len.wrapping_sub(1).cast_signed());
    DepthSlope::new(planes, y).between(x, last)
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

/// Takes pixels off the rows' starts that hierarchical depth hides.
#[inline(always)]
fn trim(rows: &mut [Segment], planes: &Planes, w: &Work<'_, '_>, func: CompareFunc) {
    if !uses_hiz(func) {
        return;
    }
    for row in rows {
        if row.len >= HIZ_FROM {
            let x = row.x.wrapping_sub(planes.origin[0]);
            let n = hiz_cull(w.band, row, &slope(row, planes), x, func);
            *row = Segment {
                x: row.x.wrapping_add(n.cast_signed()),
                offset: row.offset.wrapping_add(n),
                len: row.len.saturating_sub(n),
                ..*row
            };
        }
    }
}

/// Reads one depth of each cache line that the rows cover. Processors prefetch along a row but cannot foresee where the
/// next row begins; read beforehand, the cache misses of all rows overlap.
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

/// Colours the rows of a textured primitive, which are the segments of the batch; gives whether it has.
#[inline(always)]
pub fn textured_rows<const K: usize, S: SpanSource<K>>(
    b: &mut FragmentBatch,
    u: &FragUniforms,
    w: &mut Work<'_, '_>,
    arg: u32,
    source: S,
) -> bool {
    let rows = b.segments.get(..b.segment_count).unwrap_or(&[]);
    let Some(first) = rows.first() else { return false };
    let Some(planes) = w.planes.get(first.prim as usize) else { return false };
    let Some(Some(slots)) = u.layout.units.get(source.unit() as usize) else { return false };
    let Some(unit) = w.unit::<K>(first, slots, source.unit()) else { return false };
    let levels = match u.levels.get(source.unit() as usize) {
        Some(Some(levels)) => lod_bounds::of_rows(&b.tex, &unit, limits(rows, planes), levels),
        _ => Some(MipRange::One(0)),
    };
    let Some(levels) = levels else { return false };
    w.count_lambda(&unit, u.levels.get(source.unit() as usize).unwrap_or(&None));
    let part = Part { segment: *first, extent: Extent::All, unit, levels };
    let shader = source.shader(u, w, &part);
    let Some(shader) = &shader else { return false };
    let rows = b.segments.get_mut(..b.segment_count).unwrap_or(&mut []);
    if let Some(test) = Test::new(arg) {
        trim(rows, planes, w, test.func);
    }
    let before = w.passed();
    gathered(rows, (planes, shader), w, arg);
    if w.counts.is_some() {
        w.count(before, shader.cost());
    }
    true
}

/// Colours of the rows of a primitive, 64 living pixels at a time.
#[inline(always)]
fn gathered<S: SpanShader>(rows: &[Segment], (planes, shader): (&Planes, &S), w: &mut Work<'_, '_>, arg: u32) {
    let Some(first) = rows.first() else { return };
    let test = Test::new(arg);
    if test.is_some() {
        touch(rows, w.band.depth);
    }
    let (x0, y0) = row_origin(first, planes);
    let origin = [x0.wrapping_sub(1 << 15), y0];
    let mut list = LivePixels { place: [0; ROOM], offset: [0; ROOM], n: 0 };
    let mut rest = rows.iter();
    let (mut row, mut along, mut done, mut len) = (*first, DepthSlope::new(planes, 0), 0, 0);
    loop {
        while list.n < LANES {
            if done >= len {
                let Some(next) = rest.next() else { break };
                (row, done, len) = (*next, 0, next.len);
                along = slope(next, planes);
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
        if let Some(counts) = &mut w.counts {
            counts.passed += n as u64;
        }
        if n > 2 * FEW {
            list.shade::<LANES, _>(shader, (0, n), origin, w.band.rgba8);
        } else {
            let mut start = 0;
            while start < n {
                list.shade::<FEW, _>(shader, (start, n - start), origin, w.band.rgba8);
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
fn color_step<const N: usize, S: SpanShader>(
    w: &mut Work<'_, '_>,
    (shader, slope, test): (&S, &DepthSlope, Test),
    (x, y, n): (i32, i32, u32),
    offset: u32,
) -> bool {
    let (Some(depth), Some(pixels)) = (chunk(w.band.depth, offset), chunk(w.band.rgba8, offset)) else { return false };
    let mask = test.pass::<N>(slope, x, n, depth);
    if let Some(counts) = &mut w.counts {
        counts.passed += u64::from(living(&mask));
    }
    if any(&mask) {
        let mut out = [0; N];
        shader.pixels(FromPixel { x: x as f32, y: y as f32 }, &[0; N], &mut out);
        write(false, &mask, &out, pixels);
    }
    true
}

/// Colours the rows of a primitive that is tested for depth and whose colours cost so little that pixels are not gathered: 32
/// of a row at a time. Gives whether it has.
#[inline(always)]
pub fn colored_rows<S: SpanShader>(
    rows: &[Segment],
    (planes, shader): (&Planes, &S),
    w: &mut Work<'_, '_>,
    arg: u32,
) -> bool {
    let Some(test) = Test::new(arg) else { return false };
    let before = w.passed();
    touch(rows, w.band.depth);
    for row in rows {
        let (x, y) = row_origin(row, planes);
        let along = slope(row, planes);
        let mut done = 0;
        while done < row.len {
            let n = if row.len - done < WIDE as u32 { row.len - done } else { WIDE as u32 };
            let (x, offset) = (x.wrapping_add(done.cast_signed()), row.offset.wrapping_add(done));
            if !color_step::<WIDE, S>(w, (shader, &along, test), (x, y, n), offset) {
                for i in 0..n {
                    let x = x.wrapping_add(i.cast_signed());
                    color_step::<1, S>(w, (shader, &along, test), (x, y, 1), offset.wrapping_add(i));
                }
            }
            done += n;
        }
    }
    if w.counts.is_some() {
        w.count(before, shader.cost());
    }
    true
}
