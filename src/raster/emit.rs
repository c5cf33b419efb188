//! From runs of covered pixels to batches of fragments. The emitter appends pixels to a batch in segments of one primitive:
//! a long run as a row segment, short ones lane by lane. It hands the batch to the sink when the batch is full, or when a
//! pixel would be in it twice: stages work on all lanes at once, so two fragments whose order matters may not share a
//! batch. Where a batch is cut changes no bit. Runs that the program can draw as spans bypass the batch: long ones one by
//! one, the short ones of a triangle together.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::framebuffer::Band;
use crate::simd::{BITS, LANES, Level, count, stage};

/// What takes full batches.
pub trait FragmentSink {
    /// Works on a batch: segments and `tex.n` are set, `coverage` where asked for.
    fn run(&mut self, batch: &mut FragmentBatch);
    /// Draws a run of a row from its start on, as far as that pays, with `batch` as scratch. Returns how many pixels it has
    /// drawn.
    fn row(&mut self, batch: &mut FragmentBatch, run: Segment) -> u32;
    /// Draws rows of one primitive, which are the segments of the batch; false if it has drawn none.
    fn rows(&mut self, _batch: &mut FragmentBatch) -> bool {
        false
    }
}

/// Runs from this length on become row segments.
const ROW: usize = 16;

/// Pixels to a side of the block that scattered lanes are relative to.
const BLOCK: i32 = 16;

/// Where scattered lanes are, in the form in which they are appended: a block of 16 by 16 pixels, which many lanes share, and
/// the pixel in the block. What is written beyond the lanes in use is overwritten by the next ones.
#[derive(Debug)]
#[repr(C, align(64))]
struct PendingLanes {
    /// Offset of the block's first pixel, and its distance from the primitive's origin.
    offset: [u32; LANES + 8],
    x: [i32; LANES + 8],
    y: [i32; LANES + 8],
    /// 16 row + column.
    pixel: [u8; LANES + BLOCK as usize],
    /// What one row up adds to an offset.
    step: u32,
}

/// Writes offsets and positions of all scattered lanes of a batch.
type ExpandFn = unsafe fn(&PendingLanes, &mut FragmentBatch);

stage! {
    /// Offsets and positions of lanes from their blocks and pixels.
    fn EXPAND: ExpandFn = (p: &PendingLanes, b: &mut FragmentBatch) {
        for i in 0..LANES {
            let pixel = u32::from(p.pixel[i]);
            let (column, row) = (pixel & 15, pixel >> 4);
            b.offset[i] = p.offset[i].wrapping_add(p.step.wrapping_mul(row)).wrapping_add(column);
            b.dx[i] = p.x[i].wrapping_add(column as i32) as f32;
            b.dy[i] = p.y[i].wrapping_add(row as i32) as f32;
        }
    }
}

/// Collects fragments in batches for a sink.
#[derive(Debug)]
pub struct Emitter {
    batch: Box<FragmentBatch>,
    /// Scratch of the sink for long runs.
    row: Box<FragmentBatch>,
    /// Collected rows of one triangle.
    rows: Box<FragmentBatch>,
    /// Runs from this length on go to the sink at once, as spans.
    row_from: i32,
    /// Runs of a triangle that are shorter than this are collected.
    rows_below: i32,
    /// Which pixels the batch may hold: bit x mod 64 of word y mod 64.
    held: [u64; 64],
    pending: Box<PendingLanes>,
    /// Whether the batch has scattered lanes, which must be expanded.
    scattered: bool,
    expand: ExpandFn,
    cut: usize,
    /// Offset of pixel (0, 0), and of one row up, in wrapping arithmetic.
    base: u32,
    step: u32,
    /// Whether fragments carry coverage.
    pub smooth: bool,
    /// Whether a pixel may be in a batch once only.
    pub ordered: bool,
    prim: u32,
    origin: [i32; 2],
    /// Whether the primitive's planes are those of a triangle batch: such pixels are always scattered lanes.
    batched: bool,
}

impl Emitter {
    /// An emitter with an empty batch, for an instruction set or the highest one that the processor has.
    #[must_use]
    pub fn new(level: Level) -> Self {
        const N: usize = LANES + 8;
        let pixel = [0; LANES + BLOCK as usize];
        let pending = PendingLanes { offset: [0; N], x: [0; N], y: [0; N], pixel, step: 0 };
        Self {
            pending: Box::new(pending),
            scattered: false,
            expand: EXPAND.at(level),
            batch: Box::default(),
            row: Box::default(),
            row_from: i32::MAX,
            rows: Box::default(),
            rows_below: 0,
            held: [0; 64],
            cut: LANES,
            base: 0,
            step: 0,
            smooth: false,
            ordered: true,
            prim: 0,
            origin: [0; 2],
            batched: false,
        }
    }

    /// Begins a band. Batches are cut after `cut` fragments.
    pub fn begin(&mut self, band: &Band<'_>, cut: usize) {
        self.cut = cut.clamp(1, LANES);
        self.base = band.offset(0, 0);
        self.step = band.offset(0, 1).wrapping_sub(self.base);
    }

    /// Says from which length on runs go to the sink at once. None do where batches are cut early, nor where fragments
    /// carry coverage, which only batches have.
    pub fn row_from(&mut self, len: u32) {
        let never = self.smooth || self.cut < LANES;
        self.row_from = if never { i32::MAX } else { i32::try_from(len).unwrap_or(i32::MAX).max(1) };
    }

    /// Says below which length the runs of a triangle are collected, under the same conditions.
    pub fn rows_below(&mut self, len: u32) {
        let never = self.smooth || self.cut < LANES;
        self.rows_below = if never { 0 } else { i32::try_from(len).unwrap_or(0) };
    }

    /// Says whose pixels come next, and where its planes have their origin.
    #[inline]
    pub fn primitive(&mut self, prim: u32, origin: [i32; 2], batched: bool) {
        (self.prim, self.origin, self.batched) = (prim, origin, batched);
    }

    /// Hands the batch to the sink.
    pub fn finish(&mut self, sink: &mut impl FragmentSink) {
        if self.batch.tex.n > 0 {
            if self.scattered {
                self.pending.step = self.step;
                self.scattered = false;
                #[expect(unsafe_code, reason = "the level was checked when the emitter was made")]
                // SAFETY: an emitter is made for no level that the processor does not have.
                unsafe {
                    (self.expand)(&self.pending, &mut self.batch);
                }
            }
            sink.run(&mut self.batch);
            self.batch.tex.n = 0;
            self.batch.segment_count = 0;
            self.held = [0; 64];
        }
    }

    /// Appends the pixels x..x + len of a row, all of the same coverage.
    #[inline]
    pub fn run(&mut self, x: i32, y: i32, len: i32, coverage: f32, sink: &mut impl FragmentSink) {
        let (mut x, mut len) = (x, len);
        if len >= self.row_from && !self.batched {
            // If the batch holds one of its pixels, the batch comes first, even where the program does not ask for order.
            let bits = (u64::MAX >> (64 - len.min(64))).rotate_left(x as u32 & 63);
            if self.held[y as usize & 63] & bits != 0 {
                self.finish(sink);
            }
            let offset = self.offset(x, y);
            let run = Segment { prim: self.prim, start: 0, len: len.cast_unsigned(), x, y, offset, row: true };
            let done = sink.row(&mut self.row, run).min(len.cast_unsigned()).cast_signed();
            x += done;
            len -= done;
        }
        while len > 0 {
            let room = (self.cut - self.batch.tex.n.min(self.cut)) as i32;
            let take = len.min(room);
            let bits = (u64::MAX >> (64 - take.max(1))).rotate_left(x as u32 & 63);
            let held = &mut self.held[y as usize & 63];
            if take == 0 || (self.ordered && *held & bits != 0) {
                self.finish(sink);
                continue;
            }
            *held |= bits;
            if take as usize >= ROW && !self.batched {
                self.append_row(x, y, take as u32);
            } else {
                self.append_lanes(x, y, take as usize);
            }
            if self.smooth {
                let n = self.batch.tex.n;
                if let Some(lanes) = self.batch.coverage.get_mut(n - take as usize..n) {
                    lanes.fill(coverage);
                }
            }
            x += take;
            len -= take;
        }
    }

    /// Collects a run of a triangle, until [`collected`](Self::collected) says that it was the last.
    #[inline]
    pub fn collect(&mut self, x: i32, y: i32, len: i32, sink: &mut impl FragmentSink) {
        if len >= self.rows_below || self.batched {
            return self.run(x, y, len, 1.0, sink);
        }
        if self.rows.segment_count == LANES {
            self.collected(sink);
        }
        let bits = (u64::MAX >> (64 - len.clamp(1, 64))).rotate_left(x as u32 & 63);
        if self.held[y as usize & 63] & bits != 0 {
            self.finish(sink);
        }
        let offset = self.offset(x, y);
        if let Some(segment) = self.rows.segments.get_mut(self.rows.segment_count) {
            *segment = Segment { prim: self.prim, start: 0, len: len.cast_unsigned(), x, y, offset, row: true };
            self.rows.segment_count += 1;
        }
    }

    /// Hands on the collected runs of a triangle.
    #[inline]
    pub fn collected(&mut self, sink: &mut impl FragmentSink) {
        if self.rows.segment_count > 0 && !sink.rows(&mut self.rows) {
            for i in 0..self.rows.segment_count.min(LANES) {
                let Segment { x, y, len, .. } = self.rows.segments[i];
                self.run(x, y, len.cast_signed(), 1.0, sink);
            }
        }
        self.rows.segment_count = 0;
    }

    /// Appends the pixels of a mask of 8 by 8.
    #[inline]
    pub fn mask(&mut self, x: i32, y: i32, bits: u64, sink: &mut impl FragmentSink) {
        if self.mark_held(x, y, bits) && self.ordered {
            self.finish(sink);
            self.mark_held(x, y, bits);
        }
        if self.batch.tex.n + count(bits) <= self.cut {
            self.append_mask(x, y, bits);
            return;
        }
        let mut rest = bits;
        while rest != 0 {
            if self.batch.tex.n >= self.cut {
                self.finish(sink);
                self.mark_held(x, y, rest);
            }
            rest = self.append_pixels(x, y, rest);
        }
    }

    /// Marks the pixels of a mask as held, and says whether one of them was held already.
    #[inline]
    fn mark_held(&mut self, x: i32, y: i32, bits: u64) -> bool {
        let turn = x as u32 & 63;
        let (mut rest, mut row, mut twice) = (bits, y as usize, 0);
        // Four rows at a time, whether they have pixels or not: a branch for each row could not be predicted.
        while rest != 0 {
            for _ in 0..4 {
                let pixels = (rest & 0xFF).rotate_left(turn);
                let held = &mut self.held[row & 63];
                twice |= *held & pixels;
                *held |= pixels;
                rest >>= 8;
                row += 1;
            }
        }
        twice != 0
    }

    /// Appends all pixels of a mask; there is room for them.
    #[inline]
    fn append_mask(&mut self, x: i32, y: i32, bits: u64) {
        let offset = self.offset(x, y);
        let block = [x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1])];
        let start = self.batch.tex.n;
        let (mut n, mut rest, mut row) = (start, bits, 0);
        while rest != 0 {
            for _ in 0..4 {
                let pixels = rest as u8 as usize;
                // What is written beyond the pixels of the row is overwritten by the next row.
                if let Some(to) = self.pending.pixel.get_mut(n..).and_then(|p| p.first_chunk_mut()) {
                    *to = (u64::from_le_bytes(BITS.columns[pixels]) + row).to_le_bytes();
                }
                n += usize::from(BITS.count[pixels]);
                rest >>= 8;
                row += 16 * (u64::MAX / 0xFF);
            }
        }
        if self.smooth {
            self.batch.coverage.iter_mut().take(n).skip(start).for_each(|coverage| *coverage = 1.0);
        }
        self.put_block(start, n, block, offset);
    }

    /// Appends pixels of a mask until the batch is full; returns the rest.
    #[inline]
    fn append_pixels(&mut self, x: i32, y: i32, bits: u64) -> u64 {
        let offset = self.offset(x, y);
        let (x, y) = (x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1]));
        let (b, p) = (&mut *self.batch, &mut *self.pending);
        let (start, end) = (b.tex.n, self.cut.min(LANES));
        let (mut n, mut rest) = (start, bits);
        while n < end && rest != 0 {
            let bit = rest.trailing_zeros();
            // From 8 row + column.
            p.pixel[n] = (bit + (bit & 0x38)) as u8;
            rest &= rest - 1;
            n += 1;
        }
        if self.smooth {
            b.coverage.iter_mut().take(n).skip(start).for_each(|coverage| *coverage = 1.0);
        }
        self.put_block(start, n, [x, y], offset);
        rest
    }

    /// Gives the new lanes from `start` to `n` their block: its first pixel relative to the primitive's origin, its offset.
    #[inline]
    fn put_block(&mut self, start: usize, n: usize, [x, y]: [i32; 2], offset: u32) {
        if start >= n {
            return;
        }
        let (b, p) = (&mut *self.batch, &mut *self.pending);
        b.tex.n = n;
        // Eight lanes at a time: most triangles have no more.
        let mut at = start;
        while at < n {
            let (Some(offsets), Some(xs), Some(ys)) = (
                p.offset.get_mut(at..).and_then(|l| l.first_chunk_mut::<8>()),
                p.x.get_mut(at..).and_then(|l| l.first_chunk_mut::<8>()),
                p.y.get_mut(at..).and_then(|l| l.first_chunk_mut::<8>()),
            ) else {
                break;
            };
            (*offsets, *xs, *ys) = ([offset; 8], [x; 8], [y; 8]);
            at += 8;
        }
        self.scattered = true;
        if let Some(segment) = b.segments.get_mut(b.segment_count) {
            let (start, len) = (start as u32, (n - start) as u32);
            *segment = Segment { prim: self.prim, start, len, x, y, offset, row: false };
            b.segment_count += 1;
        }
    }

    /// Appends runs (column, row, length) of the 16 by 16 pixels from (x, y) on, without coverage.
    #[inline]
    pub fn block(&mut self, [x, y]: [i32; 2], runs: impl Iterator<Item = [i32; 3]>, sink: &mut impl FragmentSink) {
        let block = [x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1])];
        let offset = self.offset(x, y);
        let (mut start, mut n) = (self.batch.tex.n, self.batch.tex.n);
        for [column, row, len] in runs {
            let (mut column, mut len) = (column, len.min(BLOCK));
            while len > 0 {
                let take = len.min((self.cut - n.min(self.cut)) as i32);
                let bits = (u64::MAX >> (64 - take.max(1))).rotate_left((x + column) as u32 & 63);
                let held = &mut self.held[(y + row) as usize & 63];
                if take == 0 || (self.ordered && *held & bits != 0) {
                    self.put_block(start, n, block, offset);
                    self.finish(sink);
                    (start, n) = (0, 0);
                    continue;
                }
                *held |= bits;
                let first = (16 * row + column) as u8;
                if let Some(pixels) = self.pending.pixel.get_mut(n..).and_then(|p| p.first_chunk_mut::<16>()) {
                    for (pixel, column) in pixels.iter_mut().zip(0..) {
                        *pixel = first.wrapping_add(column);
                    }
                }
                n += take as usize;
                column += take;
                len -= take;
            }
        }
        self.put_block(start, n, block, offset);
    }

    /// Appends the pixels of a row where a stipple has a bit. Bit 31 holds for the columns that are multiples of 32.
    pub fn stippled(&mut self, x: i32, y: i32, len: i32, row: u32, coverage: f32, sink: &mut impl FragmentSink) {
        let mut at = x;
        let end = x + len;
        while at < end {
            let turned = row.rotate_left(at as u32 & 31);
            let ones = (turned.leading_ones() as i32).min(end - at);
            let zeros = (turned.leading_zeros() as i32).min(end - at);
            self.run(at, y, ones, coverage, sink);
            at += ones.max(zeros);
        }
    }

    #[inline]
    fn offset(&self, x: i32, y: i32) -> u32 {
        self.base.wrapping_add(self.step.wrapping_mul(y as u32)).wrapping_add(x as u32)
    }

    /// Appends a row segment; there is room for it.
    #[inline]
    fn append_row(&mut self, x: i32, y: i32, len: u32) {
        let offset = self.offset(x, y);
        let b = &mut *self.batch;
        if let Some(segment) = b.segments.get_mut(b.segment_count) {
            *segment = Segment { prim: self.prim, start: b.tex.n as u32, len, x, y, offset, row: true };
            b.segment_count += 1;
            b.tex.n += len as usize;
        }
    }

    /// Appends pixels of a row lane by lane; there is room for them.
    #[inline]
    fn append_lanes(&mut self, x: i32, y: i32, take: usize) {
        let offset = self.offset(x, y);
        let b = &mut *self.batch;
        let n = b.tex.n;
        let (dx, dy) = (x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1]));
        let p = &mut *self.pending;
        // Eight lanes at a time, so that short runs need no loop.
        let mut at = 0;
        while at < take {
            let (Some(offsets), Some(xs), Some(ys), Some(pixels)) = (
                p.offset.get_mut(n + at..).and_then(|l| l.first_chunk_mut::<8>()),
                p.x.get_mut(n + at..).and_then(|l| l.first_chunk_mut::<8>()),
                p.y.get_mut(n + at..).and_then(|l| l.first_chunk_mut::<8>()),
                p.pixel.get_mut(n + at..).and_then(|l| l.first_chunk_mut::<8>()),
            ) else {
                break;
            };
            (*offsets, *xs) = ([offset.wrapping_add(at as u32); 8], [dx.wrapping_add(at as i32); 8]);
            (*ys, *pixels) = ([dy; 8], [0, 1, 2, 3, 4, 5, 6, 7]);
            at += 8;
        }
        self.scattered = true;
        b.tex.n = n + take;
        if let Some(last) = b.segment_count.checked_sub(1).and_then(|i| b.segments.get_mut(i))
            && last.prim == self.prim
            && !last.row
        {
            last.len += take as u32;
        } else if let Some(segment) = b.segments.get_mut(b.segment_count) {
            *segment = Segment { prim: self.prim, start: n as u32, len: take as u32, x, y, offset, row: false };
            b.segment_count += 1;
        }
    }
}
