//! A band: consecutive rows of all buffers, which one worker thread draws into. Bands of one framebuffer do not overlap, so
//! workers need no locks, and because a pixel lies in one band only, the number of workers changes no result.

use super::hier_z::{self, HierZ};
use super::{DeferredClear, Framebuffer};
use std::mem::take;

/// Rows `y0..y0 + rows` of a framebuffer. Each has cache lines to itself: it is written for every run of pixels, while other
/// threads work on its neighbours.
#[derive(Debug)]
#[repr(align(128))]
pub struct Band<'a> {
    /// Lowest row (window y).
    pub y0: u32,
    /// Number of rows.
    pub rows: u32,
    /// Pixels of a row.
    pub width: u32,
    /// Pixels from the start of a row to the start of the next one in memory.
    pub stride: u32,
    /// Whether the highest row comes first in memory.
    pub flipped: bool,
    /// Colours, bytes R, G, B, A from low to high; empty where the colours are floats.
    pub rgba8: &'a mut [u32],
    /// Colours as floats; empty where they are bytes.
    pub float: &'a mut [[f32; 4]],
    /// Depths; empty where there is no depth buffer.
    pub depth: &'a mut [u32],
    /// Upper bounds of the depths of blocks. Code that may raise a depth calls [`HierZ::invalidate`].
    pub hier_z: HierZ<'a>,
    /// Stencil values; empty where there is no stencil buffer.
    pub stencil: &'a mut [u8],
    /// A clear that is carried out before the band is drawn into ([`Band::apply_deferred_clear`]).
    pub deferred: Option<DeferredClear>,
    /// How many fragments passed the tests (occlusion queries); counted only by programs that were built to count.
    pub samples: u64,
}

impl Band<'_> {
    /// Index of pixel (x, y) of the window in every slice of the band; y must be one of the band's rows.
    #[inline(always)]
    #[must_use]
    pub fn offset(&self, x: u32, y: u32) -> u32 {
        let row = self.memory_row(y.cast_signed()) as u32;
        row.wrapping_mul(self.stride).wrapping_add(x)
    }

    /// Number of row y in the order of memory.
    #[inline(always)]
    #[must_use]
    pub fn memory_row(&self, y: i32) -> usize {
        let row = y.cast_unsigned().wrapping_sub(self.y0);
        let row = if self.flipped { self.rows.wrapping_sub(1).wrapping_sub(row) } else { row };
        row as usize
    }
}

/// Cuts `n` elements off the front, or all where there are fewer.
fn cut<'a, T>(rest: &mut &'a mut [T], n: usize) -> &'a mut [T] {
    let all = take(rest);
    let n = n.min(all.len());
    let (front, back) = all.split_at_mut(n);
    *rest = back;
    front
}

impl Framebuffer {
    /// The whole framebuffer as one band; a deferred clear is carried out.
    pub fn band(&mut self) -> Band<'_> {
        let deferred = self.deferred.take();
        let (width, stride, flipped, rows) = (self.width, self.stride, self.flipped, self.height);
        let (rgba8, float) = self.color.slices_mut();
        let (depth, stencil) = (&mut self.depth[..], &mut self.stencil[..]);
        let hier_z = HierZ { limits: &mut self.hier_z, columns: hier_z::columns(width), invalid: false };
        let mut band =
            Band { y0: 0, rows, width, stride, flipped, rgba8, float, depth, hier_z, stencil, deferred, samples: 0 };
        band.apply_deferred_clear();
        band
    }

    /// The framebuffer cut into bands of `rows` rows (the highest may have fewer), lowest first: row y is in band
    /// `y / rows`. A deferred clear goes to each of them.
    pub fn bands(&mut self, rows: u32) -> Vec<Band<'_>> {
        let rows = rows.max(1);
        let deferred = self.deferred.take();
        let (width, stride, flipped, height) = (self.width, self.stride, self.flipped, self.height);
        let (mut rgba8, mut float) = self.color.slices_mut();
        let (mut depth, mut stencil) = (&mut self.depth[..], &mut self.stencil[..]);
        let (mut limits, columns) = (&mut self.hier_z[..], hier_z::columns(width));
        let count = height.div_ceil(rows);
        let mut bands = Vec::with_capacity(count as usize);
        for i in 0..count {
            // In memory order, which for flipped rows is from the highest band down.
            let y0 = if flipped { count - 1 - i } else { i } * rows;
            let rows = rows.min(height - y0);
            let n = rows as usize * stride as usize;
            let limits = cut(&mut limits, rows as usize * columns);
            bands.push(Band {
                y0,
                rows,
                width,
                stride,
                flipped,
                rgba8: cut(&mut rgba8, n),
                float: cut(&mut float, n),
                depth: cut(&mut depth, n),
                hier_z: HierZ { limits, columns, invalid: false },
                stencil: cut(&mut stencil, n),
                deferred,
                samples: 0,
            });
        }
        if flipped {
            bands.reverse();
        }
        bands
    }
}
