//! Lanes of a batch out of the framebuffer and back. Row segments are runs of memory; other lanes are found one by one.
//! Nothing is read or written outside the band, whatever the segments say.

use super::batch::{FragmentBatch, Segment};
use super::segments::{CHUNK, Lane, Piece, before_lane, from_lane, ones, pieces, put};
use crate::batch::LANES;

/// Whether the batch is one row segment of all lanes.
#[inline(always)]
fn full_row(segments: &[Segment; LANES], count: usize) -> bool {
    let s = &segments[0];
    count == 1 && s.row && s.start == 0 && s.len as usize == LANES
}

/// Where the chunk of a piece of a row segment begins in the buffer, if all of the chunk lies inside.
#[inline(always)]
fn run_start(segment: &Segment, piece: Piece) -> Option<usize> {
    (segment.offset as usize + piece.base).checked_sub(segment.start as usize)
}

/// Reads the lanes' pixels; pixels outside the band read as the default.
#[inline(always)]
pub(super) fn load<T: Lane>(
    segments: &[Segment; LANES],
    count: usize,
    offset: &[u32; LANES],
    from: &[T],
    to: &mut [T; LANES],
) {
    if full_row(segments, count) {
        if let Some(run) = from.get(segments[0].offset as usize..).and_then(|r| r.first_chunk()) {
            *to = *run;
            return;
        }
    }
    for segment in &segments[..count.min(LANES)] {
        for piece in pieces(segment) {
            let run = run_start(segment, piece).and_then(|at| from.get(at..)).and_then(|r| r.first_chunk());
            match run {
                Some(run) if segment.row => put(to, piece, run),
                _ => {
                    for i in piece.skip..piece.skip + piece.len {
                        let at = at(segment, offset, piece.base + i);
                        if let Some(lane) = to.get_mut(piece.base + i) {
                            *lane = from.get(at).copied().unwrap_or_default();
                        }
                    }
                }
            }
        }
    }
}

/// Where the pixel of a lane is in the buffer.
#[inline(always)]
fn at(segment: &Segment, offset: &[u32; LANES], lane: usize) -> usize {
    if segment.row {
        (segment.offset as usize + lane).wrapping_sub(segment.start as usize)
    } else {
        offset.get(lane).map_or(usize::MAX, |o| *o as usize)
    }
}

/// Writes the lanes whose mask is not 0.
#[inline(always)]
pub(super) fn store<T: Lane>(
    segments: &[Segment; LANES],
    count: usize,
    offset: &[u32; LANES],
    mask: &[u32; LANES],
    from: &[T; LANES],
    to: &mut [T],
) {
    if full_row(segments, count) {
        if let Some(run) = to.get_mut(segments[0].offset as usize..).and_then(|r| r.first_chunk_mut::<LANES>()) {
            for i in 0..LANES {
                run[i] = T::select(mask[i], from[i], run[i]);
            }
            return;
        }
    }
    for segment in &segments[..count.min(LANES)] {
        for piece in pieces(segment) {
            let lanes = (
                from.get(piece.base..).and_then(|r| r.first_chunk::<CHUNK>()),
                mask.get(piece.base..).and_then(|r| r.first_chunk::<CHUNK>()),
                run_start(segment, piece).and_then(|at| to.get_mut(at..)).and_then(|r| r.first_chunk_mut::<CHUNK>()),
            );
            match lanes {
                (Some(from), Some(mask), Some(run)) if segment.row => {
                    let (after, before) = (from_lane(piece.skip), before_lane(piece.skip + piece.len));
                    for i in 0..CHUNK {
                        run[i] = T::select(mask[i] & after[i] & before[i], from[i], run[i]);
                    }
                }
                _ => {
                    for lane in piece.base + piece.skip..piece.base + piece.skip + piece.len {
                        if mask.get(lane).is_some_and(|m| *m != 0)
                            && let Some(value) = from.get(lane)
                            && let Some(pixel) = to.get_mut(at(segment, offset, lane))
                        {
                            *pixel = *value;
                        }
                    }
                }
            }
        }
    }
}

/// [`load`] with the segments of a batch, which is borrowed apart from the lanes that are read into.
macro_rules! load_lanes {
    ($b:expr, $from:expr, $to:ident) => {
        $crate::fragment::buffers::load(&$b.segments, $b.segment_count, &$b.offset, $from, &mut $b.$to)
    };
}

/// [`store`] of lanes of a batch.
macro_rules! store_lanes {
    ($b:expr, $mask:expr, $from:ident, $to:expr) => {
        $crate::fragment::buffers::store(&$b.segments, $b.segment_count, &$b.offset, $mask, &$b.$from, $to)
    };
}
pub(super) use {load_lanes, store_lanes};

/// The mask of the lanes in use: what a batch starts with.
#[inline(always)]
pub(super) fn fresh_mask(b: &mut FragmentBatch) {
    let n = b.tex.n.min(LANES) as i32;
    for i in 0..LANES {
        b.tex.mask[i] = ones((i as i32) < n);
    }
    b.alive = n > 0;
}
