//! Hierarchical depth: for every block of 64 pixels of a row an upper bound of its depths. A span whose fragments are all
//! beyond the bounds of its blocks fails LESS, LEQUAL and EQUAL (OpenGL 1.5, section 4.1.6) without a read of the depth
//! buffer. Bounds are integers of the depth buffer; one may be too great, never too small. Clears set them, long spans
//! lower them after they have written, and whatever may raise depths sets all of them to the greatest value.

use super::{Framebuffer, Rect};

/// Pixels of a block.
pub const BLOCK: usize = 64;

/// Blocks of a row of `width` pixels.
pub(super) fn columns(width: u32) -> usize {
    (width as usize).div_ceil(BLOCK)
}

/// The bounds of a band, rows in the order of memory.
#[derive(Debug)]
pub struct HierZ<'a> {
    pub(super) limits: &'a mut [u32],
    pub(super) columns: usize,
    pub(super) invalid: bool,
}

impl HierZ<'_> {
    /// The limits of a row, counted in the order of memory from the band's first one.
    #[inline(always)]
    #[must_use]
    pub fn row(&self, row: usize) -> &[u32] {
        let first = row.wrapping_mul(self.columns);
        self.limits.get(first..first.wrapping_add(self.columns)).unwrap_or(&[])
    }

    /// Notes that no depth of a block is above `limit`.
    #[inline(always)]
    pub fn set(&mut self, row: usize, block: usize, limit: u32) {
        let at = row.wrapping_mul(self.columns).wrapping_add(block);
        if block < self.columns
            && let Some(old) = self.limits.get_mut(at)
        {
            *old = limit;
            self.invalid = false;
        }
    }

    /// Notes that all depths of the band are `value`.
    pub fn cleared(&mut self, value: u32) {
        self.limits.fill(value);
        self.invalid = false;
    }

    /// Notes that depths may be raised anywhere in the band.
    #[inline(always)]
    pub fn invalidate(&mut self) {
        if !self.invalid {
            self.limits.fill(u32::MAX);
            self.invalid = true;
        }
    }
}

impl Framebuffer {
    /// Notes that the depths of a rectangle have been set to `value`.
    pub(super) fn hier_z_cleared(&mut self, rect: Rect, value: u32) {
        let columns = columns(self.width);
        for y in rect.y..rect.y + rect.height {
            let row = if self.flipped { self.height - 1 - y } else { y } as usize;
            let limits = self.hier_z.get_mut(row * columns..(row + 1) * columns).unwrap_or_default();
            let (x0, x1) = (rect.x as usize, (rect.x + rect.width) as usize);
            let end = x1.div_ceil(BLOCK);
            for (block, limit) in limits.iter_mut().enumerate().take(end).skip(x0 / BLOCK) {
                let covered = x0 <= block * BLOCK && x1 >= (block * BLOCK + BLOCK).min(self.width as usize);
                *limit = if covered { value } else { value.max(*limit) };
            }
        }
    }
}
