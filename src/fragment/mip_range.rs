//! Which mipmap levels the pixels of a part of a row read, and what is kept of that from one part of a row to the next
//! (OpenGL 1.5, section 3.8.8). `lod_bounds` computes both.

use crate::limits::MAX_TEXTURE_UNITS;

/// Along which axis of the window rho is greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along x for some pixels, along y for others.
    Either,
}

/// Where the weight of the second of two levels comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MipWeight {
    /// It is this everywhere.
    Same(f32),
    /// From rho of each pixel, along this axis.
    By(Axis),
}

/// The levels that a part of a row reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MipRange {
    /// One level.
    One(u32),
    /// This level and the next one.
    Two(u32, MipWeight),
}

/// What is known of the levels ahead in the row that a batch or a part is cut from.
#[derive(Clone, Copy, Debug, Default)]
pub struct LodLookahead {
    /// Pixels from the batch's first one to the end of the row; 0 where the batch is no part of one.
    pub left: u32,
    /// For each unit the level of the next pixels, and how many pixels of the row are left where it is known no longer.
    pub levels: [(u32, u32); MAX_TEXTURE_UNITS],
    /// For each unit for how many pixels to compute bounds the next time.
    pub reach: [u32; MAX_TEXTURE_UNITS],
    /// Bit u: unit u blends two levels in this row, so that its bounds are not computed again before the row ends.
    pub blended: u32,
}

impl LodLookahead {
    /// A row begins.
    #[inline(always)]
    pub fn begin(&mut self, len: u32) {
        self.left = len;
        self.levels = [(0, u32::MAX); MAX_TEXTURE_UNITS];
        self.blended = 0;
    }

    /// So many pixels are done.
    #[inline(always)]
    pub fn advance(&mut self, done: u32) {
        self.left = self.left.saturating_sub(done);
    }
}
