//! From row runs to batches of fragments. The emitter appends the pixels of shapes to a batch, as segments of one
//! primitive each: long runs as row segments, short ones lane by lane behind each other. It hands the batch on when it is
//! full or when a pixel would be in it twice: within a batch stages see all lanes at once, so what must happen in order
//! may not share a batch. Where a batch is cut changes no bit of the result. Long runs go past the batch straight to the
//! sink, so that nearly all batches of a large primitive are one row.

use crate::batch::LANES;
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::framebuffer::Band;

/// What takes full batches.
pub trait Sink {
    /// Works on a batch: segments and `tex.n` are set, `coverage` where asked for.
    fn run(&mut self, batch: &mut FragmentBatch);
    /// Works on a run of a row, from its start on as far as that pays, with a batch to use for it. Returns how many pixels
    /// it has done.
    fn row(&mut self, batch: &mut FragmentBatch, run: Segment) -> u32;
}

/// Runs from this length on become row segments.
const ROW: usize = 16;

/// The fragments to come, and where they go in the band.
#[derive(Debug)]
pub struct Emitter {
    batch: Box<FragmentBatch>,
    /// For the sink to work on long runs.
    row: Box<FragmentBatch>,
    /// Runs from this length on go to the sink at once.
    row_from: i32,
    /// Which pixels the batch may hold already: bit x mod 64 of word y mod 64.
    seen: [u64; 64],
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
}

impl Default for Emitter {
    fn default() -> Self {
        Self::new()
    }
}

impl Emitter {
    /// An emitter with an empty batch.
    #[must_use]
    pub fn new() -> Self {
        Self {
            batch: Box::default(),
            row: Box::default(),
            row_from: i32::MAX,
            seen: [0; 64],
            cut: LANES,
            base: 0,
            step: 0,
            smooth: false,
            ordered: true,
            prim: 0,
            origin: [0; 2],
        }
    }

    /// Goes to a band, and says after how many fragments batches are cut.
    pub fn begin(&mut self, band: &Band<'_>, cut: usize) {
        self.cut = cut.clamp(1, LANES);
        self.base = band.offset(0, 0);
        self.step = band.offset(0, 1).wrapping_sub(self.base);
    }

    /// Says from which length on runs go to the sink at once; never where batches are cut early, nor with coverage,
    /// which only batches have.
    pub fn row_from(&mut self, len: u32) {
        let never = self.smooth || self.cut < LANES;
        self.row_from = if never { i32::MAX } else { i32::try_from(len).unwrap_or(i32::MAX).max(1) };
    }

    /// Says whose pixels come next.
    #[inline]
    pub fn primitive(&mut self, prim: u32, origin: [i32; 2]) {
        (self.prim, self.origin) = (prim, origin);
    }

    /// Hands on what there is.
    pub fn finish(&mut self, sink: &mut impl Sink) {
        if self.batch.tex.n > 0 {
            sink.run(&mut self.batch);
            self.batch.tex.n = 0;
            self.batch.segment_count = 0;
            self.seen = [0; 64];
        }
    }

    /// Appends the pixels x..x + len of a row, all of the same coverage.
    #[inline]
    pub fn run(&mut self, x: i32, y: i32, len: i32, coverage: f32, sink: &mut impl Sink) {
        let (mut x, mut len) = (x, len);
        if len >= self.row_from {
            // Pixels of the batch that the run covers come first, whether the order of a batch matters or not.
            let bits = (u64::MAX >> (64 - len.min(64))).rotate_left(x as u32 & 63);
            if self.seen[y as usize & 63] & bits != 0 {
                self.finish(sink);
            }
            let offset = self.offset(x, y);
            let run = Segment { prim: self.prim, start: 0, len: len.cast_unsigned(), x, y, offset, row: true };
            let done = sink.row(&mut self.row, run).min(len.cast_unsigned()).cast_signed();
            x += done;
            len -= done;
        }
        self.short_run(x, y, len, coverage, sink);
    }

    /// The same for runs that must come in batches.
    #[inline]
    pub fn short_run(&mut self, x: i32, y: i32, len: i32, coverage: f32, sink: &mut impl Sink) {
        let (mut x, mut len) = (x, len);
        while len > 0 {
            let room = (self.cut - self.batch.tex.n.min(self.cut)) as i32;
            let take = len.min(room);
            let bits = (u64::MAX >> (64 - take.max(1))).rotate_left(x as u32 & 63);
            let seen = &mut self.seen[y as usize & 63];
            if take == 0 || (self.ordered && *seen & bits != 0) {
                self.finish(sink);
                continue;
            }
            *seen |= bits;
            if take as usize >= ROW {
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

    /// Appends the pixels of a mask of 8 by 8 whose rows are runs without gaps; false, and nothing done, where there is no
    /// room, a pixel is in the batch already, or fragments carry coverage: then the rows must be appended one by one.
    #[inline]
    pub fn mask(&mut self, x: i32, y: i32, bits: u64) -> bool {
        let b = &mut *self.batch;
        let start = b.tex.n;
        // Rows are written eight lanes at a time, so that many must be free behind the last one.
        let count = bits.count_ones() as usize;
        if start + count > self.cut.min(LANES - 8) || self.smooth {
            return false;
        }
        let turn = x as u32 & 63;
        let mut rest = bits;
        let mut row = y as usize;
        while rest != 0 && self.ordered {
            if self.seen[row & 63] & (rest & 0xFF).rotate_left(turn) != 0 {
                return false;
            }
            rest >>= 8;
            row += 1;
        }
        let mut n = start;
        let mut rest = bits;
        let mut y = y;
        let mut first = self.base.wrapping_add(self.step.wrapping_mul(y as u32)).wrapping_add(x as u32);
        let dx = x.wrapping_sub(self.origin[0]);
        while rest != 0 {
            let byte = rest as u32 & 0xFF;
            if byte != 0 {
                self.seen[y as usize & 63] |= u64::from(byte).rotate_left(turn);
                let skip = byte.trailing_zeros();
                let len = (byte >> skip).trailing_ones();
                let offset = first.wrapping_add(skip);
                let (dx, dy) = (dx.wrapping_add(skip as i32) as f32, y.wrapping_sub(self.origin[1]) as f32);
                let offsets = b.offset.get_mut(n..).and_then(|l| l.first_chunk_mut::<8>());
                let dxs = b.dx.get_mut(n..).and_then(|l| l.first_chunk_mut::<8>());
                let dys = b.dy.get_mut(n..).and_then(|l| l.first_chunk_mut::<8>());
                let (Some(offsets), Some(dxs), Some(dys)) = (offsets, dxs, dys) else { return false };
                for i in 0..8 {
                    offsets[i] = offset.wrapping_add(i as u32);
                    dxs[i] = dx + i as f32;
                    dys[i] = dy;
                }
                n += len as usize;
            }
            rest >>= 8;
            y = y.wrapping_add(1);
            first = first.wrapping_add(self.step);
        }
        b.tex.n = n;
        if let Some(segment) = b.segments.get_mut(b.segment_count) {
            let (start, len) = (start as u32, (n - start) as u32);
            *segment = Segment { prim: self.prim, start, len, x, y, offset: first, row: false };
            b.segment_count += 1;
        }
        true
    }

    /// Appends the pixels of a row where a stipple has a bit: bit 31 belongs to the columns that 32 divides.
    pub fn stippled(&mut self, x: i32, y: i32, len: i32, row: u32, coverage: f32, sink: &mut impl Sink) {
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

    /// Appends fewer than [`ROW`] lanes; there is room for them.
    #[inline]
    fn append_lanes(&mut self, x: i32, y: i32, take: usize) {
        let offset = self.offset(x, y);
        let b = &mut *self.batch;
        let n = b.tex.n;
        let (dx, dy) = (x.wrapping_sub(self.origin[0]), y.wrapping_sub(self.origin[1]) as f32);
        // Eight lanes at a time, so that short runs need no loop; what is written beyond the run is overwritten later.
        let mut at = 0;
        while at < take {
            let offsets = b.offset.get_mut(n + at..n + at + 8);
            let (dxs, dys) = (b.dx.get_mut(n + at..n + at + 8), b.dy.get_mut(n + at..n + at + 8));
            let (Some(offsets), Some(dxs), Some(dys)) = (offsets, dxs, dys) else { break };
            let step = at as i32;
            for i in 0..8i32 {
                let lane = i as usize;
                offsets[lane] = offset.wrapping_add((step + i) as u32);
                dxs[lane] = dx.wrapping_add(step + i) as f32;
                dys[lane] = dy;
            }
            at += 8;
        }
        // The last lanes of the batch, where eight do not fit.
        for i in at..take {
            let lane = (n + i) & (LANES - 1);
            b.offset[lane] = offset.wrapping_add(i as u32);
            b.dx[lane] = dx.wrapping_add(i as i32) as f32;
            b.dy[lane] = dy;
        }
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
