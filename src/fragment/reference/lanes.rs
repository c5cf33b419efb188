//! Walking the segments of a batch in chunks of 8 lanes. Large primitives fill whole batches with one row segment, small
//! ones leave many segments of a few lanes; a chunk is computed whole in either case, so that it stays SIMD code, and
//! what a chunk computes beyond its segment is overwritten by the next segment or belongs to no fragment.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::plane_eval::{FromPixel, IOTA, Points};
use crate::fragment::planes::Planes;
use crate::simd::LANES;
use crate::texture::batch::Lanes;

/// Lanes of a chunk.
pub const CHUNK: usize = 8;

/// Floats of a chunk.
pub type Chunk = [f32; CHUNK];

/// What stands in a lane. Selecting by bits keeps loops over lanes SIMD code: `if` on values from memory becomes a choice
/// between two addresses, lane by lane.
pub trait Lane: Copy + Default {
    /// `a` where the mask is all ones, `b` where it is 0.
    fn select(mask: u32, a: Self, b: Self) -> Self;
}

impl Lane for u32 {
    #[inline(always)]
    fn select(mask: u32, a: Self, b: Self) -> Self {
        (a & mask) | (b & !mask)
    }
}

impl Lane for u8 {
    #[inline(always)]
    fn select(mask: u32, a: Self, b: Self) -> Self {
        (a & mask as u8) | (b & !(mask as u8))
    }
}

impl Lane for f32 {
    #[inline(always)]
    fn select(mask: u32, a: Self, b: Self) -> Self {
        Self::from_bits(u32::select(mask, a.to_bits(), b.to_bits()))
    }
}

impl Lane for [f32; 4] {
    #[inline(always)]
    fn select(mask: u32, a: Self, b: Self) -> Self {
        if mask != 0 { a } else { b }
    }
}

/// Part of a segment: lanes `base..base + CHUNK`, of which those from `base + skip` on are to be written.
#[derive(Clone, Copy)]
pub struct Piece {
    pub base: usize,
    pub skip: usize,
    /// Lanes that belong to the segment, from `base + skip` on.
    pub len: usize,
}

/// Ones, then zeros, then ones: the masks of "from lane i on" and "before lane i" are windows of it.
static EDGE: [u32; 3 * CHUNK] = {
    let mut edge = [u32::MAX; 3 * CHUNK];
    let mut i = CHUNK;
    while i < 2 * CHUNK {
        edge[i] = 0;
        i += 1;
    }
    edge
};

/// All ones from lane `i` (at most 8) on.
#[inline(always)]
pub fn from_lane(i: usize) -> &'static [u32; CHUNK] {
    EDGE.get((2 * CHUNK).wrapping_sub(i)..).and_then(|e| e.first_chunk()).unwrap_or(&[0; CHUNK])
}

/// All ones before lane `i` (at most 8).
#[inline(always)]
pub fn before_lane(i: usize) -> &'static [u32; CHUNK] {
    EDGE.get(CHUNK.wrapping_sub(i)..).and_then(|e| e.first_chunk()).unwrap_or(&[0; CHUNK])
}

/// The pieces of a segment.
#[inline(always)]
pub fn pieces(segment: &Segment) -> Pieces {
    // After `sanitise` the segment ends within the batch.
    Pieces { first: segment.start as usize, end: segment.start as usize + segment.len as usize }
}

/// Goes over the pieces of a segment.
pub struct Pieces {
    first: usize,
    end: usize,
}

impl Iterator for Pieces {
    type Item = Piece;

    #[inline(always)]
    fn next(&mut self) -> Option<Piece> {
        if self.first >= self.end {
            return None;
        }
        // The last lanes of a batch are reached by a chunk that begins earlier.
        let base = if self.first > LANES - CHUNK { LANES - CHUNK } else { self.first };
        let left = self.end - self.first;
        let piece = Piece { base, skip: self.first - base, len: if left > CHUNK { CHUNK } else { left } };
        self.first += CHUNK;
        Some(piece)
    }
}

/// Cuts segments that reach beyond the batch, and notes whether there are only scattered lanes. Segments of a
/// correct rasteriser are not changed; the stages that follow rely on it.
#[inline(always)]
pub fn sanitise(b: &mut FragmentBatch) {
    let count = if b.segment_count > LANES { LANES } else { b.segment_count };
    b.segment_count = count;
    let mut scattered = true;
    for segment in &mut b.segments[..count] {
        // Written only where it must be: the next stage reads it at once and would wait for the store.
        let room = (LANES as u32).saturating_sub(segment.start);
        if segment.start > LANES as u32 || segment.len > room {
            segment.start = segment.start.min(LANES as u32);
            segment.len = segment.len.min(room);
        }
        scattered &= !segment.row;
    }
    b.scattered = scattered;
}

/// Whether one row segment fills the batch from lane 0, so that stages may compute all lanes as one row.
#[inline(always)]
pub fn single_row(b: &FragmentBatch) -> bool {
    b.segment_count == 1 && b.segments[0].row && b.segments[0].start == 0
}

/// A segment of the primitive that all lanes belong to, if it is one: then stages may compute the batch as a whole.
#[inline(always)]
pub fn one_primitive(segments: &[Segment]) -> Option<Segment> {
    let first = segments.first()?;
    segments.iter().all(|s| s.prim == first.prim).then_some(*first)
}

/// Where the lanes of a row segment are that begins at lane 0.
#[inline(always)]
pub fn row_positions(segment: &Segment, planes: &Planes) -> FromPixel {
    let (x, y) = row_origin(segment, planes);
    FromPixel { x: x as f32, y: y as f32 }
}

/// Where all lanes of a batch of one primitive are; `lanes` are the x and y of segments that are no rows.
#[inline(always)]
pub fn all_positions(segments: &[Segment], lanes: (&Lanes, &Lanes), planes: &Planes) -> Points<LANES> {
    let mut all = Points { x: [0.0; LANES], y: [0.0; LANES] };
    for segment in segments {
        for piece in pieces(segment) {
            let Points { x, y } = positions(lanes, segment, planes, piece);
            put(&mut all.x, piece, &x);
            put(&mut all.y, piece, &y);
        }
    }
    all
}

/// The lanes of a piece.
#[inline(always)]
pub fn chunk<T: Copy + Default>(lanes: &[T; LANES], piece: Piece) -> [T; CHUNK] {
    lanes.get(piece.base..).and_then(|l| l.first_chunk()).copied().unwrap_or([T::default(); CHUNK])
}

/// Writes the lanes of a piece.
#[inline(always)]
pub fn put<T: Lane>(lanes: &mut [T; LANES], piece: Piece, value: &[T; CHUNK]) {
    let Some(out) = lanes.get_mut(piece.base..).and_then(|l| l.first_chunk_mut::<CHUNK>()) else { return };
    if piece.skip == 0 {
        *out = *value;
    } else {
        let mask = from_lane(piece.skip);
        for i in 0..CHUNK {
            out[i] = T::select(mask[i], value[i], out[i]);
        }
    }
}

/// Where the lanes of a piece are, relative to the primitive's origin.
#[inline(always)]
pub fn positions(lanes: (&Lanes, &Lanes), segment: &Segment, planes: &Planes, piece: Piece) -> Points<CHUNK> {
    if segment.row {
        let (x, y) = row_origin(segment, planes);
        // Whole numbers below 2^24: the sum is exact.
        let x = x.wrapping_add(piece.base as i32) as f32;
        let mut dx = [0.0; CHUNK];
        for i in 0..CHUNK {
            dx[i] = x + IOTA[i];
        }
        Points { x: dx, y: [y as f32; CHUNK] }
    } else {
        Points { x: chunk(lanes.0, piece), y: chunk(lanes.1, piece) }
    }
}

/// Position, relative to the primitive's origin, that lane 0 would have if the row segment began there.
#[inline(always)]
pub fn row_origin(segment: &Segment, planes: &Planes) -> (i32, i32) {
    let x = segment.x.wrapping_sub(planes.origin[0]).wrapping_sub(segment.start as i32);
    (x, segment.y.wrapping_sub(planes.origin[1]))
}
