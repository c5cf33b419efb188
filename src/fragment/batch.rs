//! Sixty-four fragments as structures of arrays. The rasteriser appends *segments*: runs of lanes that belong to one
//! primitive. Stages that need the primitive (interpolation) walk the segments; all others see 64 lanes.

use crate::batch::LANES;
use crate::texture::batch::{Lanes, TexBatch};

/// A run of lanes of one primitive.
#[derive(Clone, Copy, Debug, Default)]
pub struct Segment {
    /// Index of the primitive's [`Planes`](super::planes::Planes) in the scene.
    pub prim: u32,
    /// First lane.
    pub start: u32,
    /// Number of lanes.
    pub len: u32,
    /// Whether all lanes of the segment lie in one row with ascending x: lane i is at x + (i - start), y.
    pub row: bool,
}

/// A batch of fragments. A pixel is in it at most once.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct FragmentBatch {
    /// Segments in use: `segments[..segment_count]`.
    pub segments: [Segment; LANES],
    /// How many segments are in use.
    pub segment_count: usize,
    /// Window x of the pixel.
    pub x: [i32; LANES],
    /// Window y of the pixel.
    pub y: [i32; LANES],
    /// Index of the pixel in the rows of the band (colour, depth and stencil alike).
    pub offset: [u32; LANES],
    /// Pixel x minus the primitive's origin.
    pub dx: Lanes,
    /// Pixel y minus the primitive's origin.
    pub dy: Lanes,
    /// 1 / (relative 1/w): what a numerator plane is multiplied with.
    pub rw: Lanes,
    /// Window depth in units of the depth buffer.
    pub z: [u32; LANES],
    /// Secondary colour RGB.
    pub secondary: [Lanes; 3],
    /// Fog coordinate, then fog factor.
    pub fog: Lanes,
    /// What the framebuffer holds, RGBA, for blending.
    pub dst: [Lanes; 4],
    /// Coverage in [0, 1] of smooth points, lines and polygons.
    pub coverage: Lanes,
    /// Lanes in use, mask, colours and everything of texturing. `tex.primary` is the interpolated colour and
    /// `tex.previous` the colour that reaches the later stages.
    pub tex: TexBatch,
}

impl FragmentBatch {
    /// An empty batch.
    #[must_use]
    pub fn new() -> Self {
        const Z: Lanes = [0.0; LANES];
        Self {
            segments: [Segment::default(); LANES],
            segment_count: 0,
            x: [0; LANES],
            y: [0; LANES],
            offset: [0; LANES],
            dx: Z,
            dy: Z,
            rw: Z,
            z: [0; LANES],
            secondary: [Z; 3],
            fog: Z,
            dst: [Z; 4],
            coverage: Z,
            tex: TexBatch::new(),
        }
    }
}

impl Default for FragmentBatch {
    fn default() -> Self {
        Self::new()
    }
}
