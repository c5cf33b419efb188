//! Reading the pixels of a batch from the framebuffer, and writing them. A row segment is contiguous memory; scattered
//! lanes are read and written one by one. Nothing is read or written outside the band, whatever the segments say.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{all, ones};
use crate::fragment::reference::lanes::{CHUNK, Lane, Piece, before_lane, from_lane, pieces, put, sanitise};
use crate::simd::LANES;

/// Where the lanes of a batch are.
#[derive(Clone, Copy)]
pub struct Places<'a> {
    pub segments: &'a [Segment],
    pub offset: &'a [u32; LANES],
    /// No segment is a row: lanes `0..n` are where `offset` says.
    pub scattered: bool,
    pub n: usize,
}

/// The places of a batch's lanes, leaving the other fields of the batch free to be borrowed.
macro_rules! places {
    ($b:expr) => {
        $crate::fragment::reference::places::Places {
            segments: $b.segments.get(..$b.segment_count).unwrap_or(&[]),
            offset: &$b.offset,
            scattered: $b.scattered,
            n: $b.tex.n,
        }
    };
}
pub(crate) use places;

/// Where the pixels begin, if the batch is one row segment, which may be shorter than the batch: the mask knows.
#[inline(always)]
fn one_row(segments: &[Segment]) -> Option<usize> {
    match segments {
        [s] if s.row && s.start == 0 => Some(s.offset as usize),
        _ => None,
    }
}

/// Where the chunk of a piece of a row segment begins in the buffer, if all of the chunk lies inside.
#[inline(always)]
fn run_start(segment: &Segment, piece: Piece) -> Option<usize> {
    (segment.offset as usize + piece.base).checked_sub(segment.start as usize)
}

/// Reads the lanes' pixels; pixels outside the band read as the default.
#[inline(always)]
pub fn load<T: Lane>(places: Places<'_>, from: &[T], to: &mut [T; LANES]) {
    if let Some(run) = one_row(places.segments).and_then(|at| from.get(at..)).and_then(|r| r.first_chunk()) {
        *to = *run;
        return;
    }
    if places.scattered {
        for (to, at) in to.iter_mut().zip(places.offset).take(places.n) {
            *to = match from.get(*at as usize) {
                Some(v) => *v,
                None => T::default(),
            };
        }
        return;
    }
    for segment in places.segments {
        for piece in pieces(segment) {
            let run = run_start(segment, piece).and_then(|at| from.get(at..)).and_then(|r| r.first_chunk());
            match run {
                Some(run) if segment.row => put(to, piece, run),
                _ => {
                    for lane in piece.base + piece.skip..piece.base + piece.skip + piece.len {
                        let at = at(segment, places.offset, lane);
                        if let Some(lane) = to.get_mut(lane) {
                            *lane = match from.get(at) {
                                Some(v) => *v,
                                None => T::default(),
                            };
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

/// Writes neighbouring pixels where the mask is set; if `full` says that all of it is, what was there is not read.
#[inline(always)]
pub fn write<T: Lane, const N: usize>(full: bool, mask: &[u32; N], from: &[T; N], to: &mut [T; N]) {
    if full {
        *to = *from;
    } else {
        for i in 0..N {
            to[i] = T::select(mask[i], from[i], to[i]);
        }
    }
}

/// Writes the lanes whose mask is not 0.
#[inline(always)]
pub fn store<T: Lane>(places: Places<'_>, mask: &[u32; LANES], from: &[T; LANES], to: &mut [T]) {
    if let Some(run) = one_row(places.segments).and_then(|at| to.get_mut(at..)).and_then(|r| r.first_chunk_mut()) {
        write(all(mask), mask, from, run);
        return;
    }
    if places.scattered {
        for ((from, at), mask) in from.iter().zip(places.offset).zip(mask).take(places.n) {
            if *mask != 0
                && let Some(pixel) = to.get_mut(*at as usize)
            {
                *pixel = *from;
            }
        }
        return;
    }
    for segment in places.segments {
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
                            && let Some(pixel) = to.get_mut(at(segment, places.offset, lane))
                        {
                            *pixel = *value;
                        }
                    }
                }
            }
        }
    }
}

/// The mask of the lanes in use: what a batch starts with.
#[inline(always)]
pub fn fresh_mask(b: &mut FragmentBatch) {
    sanitise(b);
    b.tex.n = if b.tex.n > LANES { LANES } else { b.tex.n };
    let n = b.tex.n.min(LANES) as i32;
    for i in 0..LANES {
        b.tex.mask[i] = ones((i as i32) < n);
    }
    b.alive = n > 0;
}
