//! Sixty-four fragments as structures of arrays. The rasteriser appends *segments*: successive lanes of one
//! primitive. Stages that need the primitive (interpolation) walk the segments; all others see 64 lanes.

use super::mip_range::LodLookahead;
use crate::simd::LANES;
use crate::texture::batch::{Lanes, TexBatch};

/// Successive lanes of one primitive. The segments of a batch follow each other: the first starts at lane 0, each next
/// one where the one before ends.
///
/// There are two kinds. A *row* segment is neighbouring pixels of a row: lane i is the pixel (x + (i - start), y) at
/// `offset + (i - start)`; the lane arrays `offset`, `dx`, `dy` of the batch are not read and need not be written. The
/// lanes of the other kind are *scattered* (the few pixels of a small primitive): `offset`, `dx`, `dy` say where each
/// is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Segment {
    /// Index of the primitive's [`Planes`](crate::fragment::planes::Planes) in the scene.
    pub prim: u32,
    /// First lane.
    pub start: u32,
    /// Number of lanes, at least 1.
    pub len: u32,
    /// Row segments: window x of the first pixel.
    pub x: i32,
    /// Row segments: window y.
    pub y: i32,
    /// Row segments: [`Band::offset`](crate::framebuffer::Band::offset) of the first pixel.
    pub offset: u32,
    /// Whether this is a row segment.
    pub row: bool,
}

/// A batch of fragments. A pixel is in it at most once, unless the program says that it does not care
/// ([`Program::reads_framebuffer`](crate::fragment::program::Program::reads_framebuffer) is false).
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct FragmentBatch {
    /// Index of the pixel in the rows of the band (colour, depth and stencil alike); not of row segments.
    pub offset: [u32; LANES],
    /// Pixel x minus the primitive's origin; not of row segments.
    pub dx: Lanes,
    /// Pixel y minus the primitive's origin; not of row segments.
    pub dy: Lanes,
    /// 1 / (relative 1/w): what a numerator plane is multiplied with.
    pub rw: Lanes,
    /// The same in `f64`, where a unit has computed it for the units that follow.
    pub rw64: [f64; LANES],
    /// Window depth in units of the depth buffer.
    pub z: [u32; LANES],
    /// What the depth buffer holds.
    pub depth: [u32; LANES],
    /// What the stencil buffer holds, then what it is to hold.
    pub stencil: [u32; LANES],
    /// All ones where a lane belongs to the back face of a polygon; written by the stencil test if the faces differ.
    pub back: [u32; LANES],
    /// The mask as it was before the stencil test and, second, before the depth test.
    pub before: [[u32; LANES]; 2],
    /// Secondary colour RGB.
    pub secondary: [Lanes; 3],
    /// Fog coordinate, then fog factor.
    pub fog: Lanes,
    /// What the framebuffer holds, RGBA in units of the colour store, then what blending makes of it.
    pub dst: [Lanes; 4],
    /// What the framebuffer holds, packed.
    pub packed_dst: [u32; LANES],
    /// What is to be stored, packed.
    pub packed: [u32; LANES],
    /// Coverage in [0, 1] of smooth points, lines and polygons; the rasteriser writes it for programs that use it.
    pub coverage: Lanes,
    /// Lanes in use, mask, colours and everything of texturing. `tex.primary` is the interpolated colour and
    /// `tex.previous` the colour that reaches the later stages.
    pub tex: TexBatch,
    /// Segments in use: `segments[..segment_count]`.
    pub segments: [Segment; LANES],
    /// How many segments are in use.
    pub segment_count: usize,
    /// What is known of the mipmap levels in the row that the batch is a part of.
    pub lookahead: LodLookahead,
    /// Whether `rw64` is that of this batch.
    pub has_rw64: bool,
    /// Whether no segment is a row. The first stage of a program sets it.
    pub scattered: bool,
    /// Whether a fragment is still alive after the last test.
    pub alive: bool,
}

impl FragmentBatch {
    /// An empty batch.
    #[must_use]
    pub fn new() -> Self {
        const Z: Lanes = [0.0; LANES];
        Self {
            segments: [Segment::default(); LANES],
            segment_count: 0,
            offset: [0; LANES],
            dx: Z,
            dy: Z,
            rw: Z,
            z: [0; LANES],
            depth: [0; LANES],
            stencil: [0; LANES],
            back: [0; LANES],
            before: [[0; LANES]; 2],
            secondary: [Z; 3],
            fog: Z,
            dst: [Z; 4],
            packed_dst: [0; LANES],
            packed: [0; LANES],
            coverage: Z,
            lookahead: LodLookahead::default(),
            rw64: [0.0; LANES],
            has_rw64: false,
            scattered: false,
            alive: false,
            tex: TexBatch::new(),
        }
    }
}

/// How tests fill a batch.
#[cfg(test)]
impl FragmentBatch {
    /// Takes all fragments out.
    #[inline]
    pub fn clear(&mut self) {
        self.segment_count = 0;
        self.tex.n = 0;
    }

    /// How many more fragments fit in.
    #[inline]
    #[must_use]
    pub fn room(&self) -> usize {
        LANES - self.tex.n.min(LANES)
    }

    /// Appends neighbouring pixels of a row: as many of `len` as fit in, whose number it returns.
    #[inline]
    pub fn push_row(&mut self, prim: u32, x: i32, y: i32, offset: u32, len: u32) -> u32 {
        let len = len.min(self.room() as u32);
        match self.segments.get_mut(self.segment_count) {
            Some(segment) if len > 0 => {
                *segment = Segment { prim, start: self.tex.n as u32, len, x, y, offset, row: true };
                self.segment_count += 1;
                self.tex.n += len as usize;
                len
            }
            _ => 0,
        }
    }
}

impl Default for FragmentBatch {
    fn default() -> Self {
        Self::new()
    }
}
