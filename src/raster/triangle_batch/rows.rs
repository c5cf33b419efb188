//! The rows of a batch's triangles that are too large for masks, a triangle a lane (OpenGL 1.5, section 3.5.1): within 16 by
//! 16 pixels, where the covered pixels of each row begin and end. It is the scan conversion of [`edges`] in the same
//! integers, for 16 triangles at once: where an edge crosses a row is a quotient, which is stepped from row to row together
//! with its remainder.
//!
//! [`edges`]: crate::raster::coverage::edges

use super::lanes::I32x16;
use super::masks::{edge_function, turns};
use crate::fragment::planes::GROUP;
use crate::num::MAGIC_F64;
use crate::raster::state::Rect;

/// Rows of a triangle, and columns.
pub(crate) const ROWS: usize = 16;

/// For each row and triangle: its first covered column + 256 times the column after its last.
pub(crate) type RowEnds = [[u16; GROUP]; ROWS];

/// The covered pixels of a triangle, row by row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RowCoverage {
    /// The pixel that columns and rows are counted from.
    pub x: i32,
    /// Its row.
    pub y: i32,
    /// The first row in use, and the one after the last.
    pub used: [u8; 2],
    /// The first column of each row, and the one after the last.
    pub ends: [[u8; 2]; ROWS],
}

impl RowCoverage {
    /// No pixels yet, for a bounding box that begins at a pixel and has so many rows.
    #[inline]
    pub(crate) const fn new([x, y]: [i32; 2], height: i32) -> Self {
        Self { x, y, used: [0, height as u8], ends: [[0; 2]; ROWS] }
    }

    /// Takes the rows of a lane. All 16 are copied: a loop over those in use would end at a branch that cannot be predicted.
    #[inline]
    pub(crate) fn take(&mut self, ends: &RowEnds, lane: usize) {
        for (to, from) in self.ends.iter_mut().zip(ends) {
            *to = from[lane % GROUP].to_le_bytes();
        }
    }

    /// Clips them to a rectangle. Returns how many pixels are left.
    pub(crate) fn cut(&mut self, rect: Rect) -> u64 {
        let column = |at: i32| at.wrapping_sub(self.x).clamp(0, ROWS as i32) as u8;
        let row = |at: i32| at.wrapping_sub(self.y).clamp(0, ROWS as i32) as u8;
        let (left, right) = (column(rect.x0), column(rect.x1));
        self.used = [row(rect.y0), row(rect.y1)];
        let mut pixels = 0;
        let [first, end] = self.used.map(usize::from);
        for run in self.ends.iter_mut().take(end).skip(first) {
            *run = [run[0].max(left), run[1].min(right)];
            pixels += u64::from(run[1].saturating_sub(run[0]));
        }
        pixels
    }

    /// The rows in use, in pixels of the window.
    #[must_use]
    pub fn range(&self) -> std::ops::Range<i32> {
        self.y + i32::from(self.used[0])..self.y + i32::from(self.used[1])
    }

    /// The runs of covered pixels (column, row, length) in some rows of the window, from below.
    #[inline]
    pub fn runs(&self, rows: &std::ops::Range<i32>) -> impl Iterator<Item = [i32; 3]> {
        let from = i32::from(self.used[0]).max(rows.start.saturating_sub(self.y));
        let to = i32::from(self.used[1]).min(rows.end.saturating_sub(self.y));
        let used = self.ends.iter().zip(0..).take(to.max(0) as usize).skip(from.max(0) as usize);
        used.map(|([first, end], row)| [i32::from(*first), row, i32::from(*end) - i32::from(*first)])
    }
}

/// An edge of each triangle: the quotient of its function in a row by |a|, kept exact with its remainder.
struct EdgeSteppers {
    /// All ones where the inside lies to the right; where it lies to the left; where the edge crosses no row.
    right: I32x16,
    left: I32x16,
    level: I32x16,
    modulus: I32x16,
    quotient: I32x16,
    remainder: I32x16,
    quotient_step: I32x16,
    remainder_step: I32x16,
}

/// Quotients, rounded down, and remainders. A float's quotient of two integers of 32 bits is rounded down to the right one:
/// unless it is whole, it is farther away from the next whole number than it is rounded.
#[inline(always)]
fn divide(e: &I32x16, modulus: &I32x16) -> (I32x16, I32x16) {
    let (mut quotient, mut remainder) = ([0; GROUP], [0; GROUP]);
    for i in 0..GROUP {
        let exact = f64::from(e[i]) / f64::from(modulus[i]);
        let sum = exact + MAGIC_F64;
        quotient[i] = (sum.to_bits() as i32).wrapping_sub(i32::from(sum - MAGIC_F64 > exact));
        remainder[i] = e[i].wrapping_sub(quotient[i].wrapping_mul(modulus[i]));
    }
    (quotient, remainder)
}

impl EdgeSteppers {
    /// The edge between two corners, as [`edge_function`] has it. `first` is the pixel where rows and columns begin.
    #[inline(always)]
    fn new(p: &[I32x16; 2], q: &[I32x16; 2], turn: &I32x16, first: &[I32x16; 2]) -> Self {
        let zero = [0; GROUP];
        let [mut e, mut b] = [zero; 2];
        let [mut right, mut left, mut level, mut modulus] = [zero; 4];
        for i in 0..GROUP {
            let a;
            [a, b[i], e[i]] = edge_function(p, q, turn, first, i);
            (right[i], left[i], level[i]) = (-i32::from(a > 0), -i32::from(a < 0), -i32::from(a == 0));
            modulus[i] = a.abs().max(1);
        }
        let ((quotient, remainder), (quotient_step, remainder_step)) = (divide(&e, &modulus), divide(&b, &modulus));
        Self { right, left, level, modulus, quotient, remainder, quotient_step, remainder_step }
    }

    /// Cuts the columns of this row down to those inside the edge, and goes on to the next row.
    #[inline(always)]
    fn narrow(&mut self, low: &mut I32x16, high: &mut I32x16) {
        const END: i32 = ROWS as i32;
        for i in 0..GROUP {
            let q = self.quotient[i];
            // a x + E >= 0  <=>  x >= ceil(-E / a) = -floor(E / a)
            low[i] = low[i].max(q.wrapping_neg() & self.right[i]);
            // x <= floor(E / -a); an edge along the row has all of it inside, or nothing.
            let along = END & !(q >> 31);
            let end = (q.wrapping_add(1) & self.left[i]) | (along & self.level[i]) | (END & self.right[i]);
            high[i] = high[i].min(end);
            let full = self.remainder[i].wrapping_add(self.remainder_step[i]);
            let over = -i32::from(full >= self.modulus[i]);
            self.remainder[i] = full.wrapping_sub(self.modulus[i] & over);
            self.quotient[i] = q.wrapping_add(self.quotient_step[i]).wrapping_sub(over);
        }
    }
}

/// The first `count` rows of triangles by their corners' snapped positions, from the pixel `first` on, which is the first
/// one of the bounding box, and how many pixels they cover. `area` is positive where a triangle winds counter-clockwise. Of
/// triangles that are larger than 16 by 16 anything may come out.
#[inline(always)]
pub(crate) fn rows(p: &[[I32x16; 2]; 3], area: &I32x16, first: &[I32x16; 2], count: u32, out: &mut RowEnds) -> I32x16 {
    let turn = turns(area);
    let mut steps = [
        EdgeSteppers::new(&p[0], &p[1], &turn, first),
        EdgeSteppers::new(&p[1], &p[2], &turn, first),
        EdgeSteppers::new(&p[2], &p[0], &turn, first),
    ];
    let mut pixels = [0; GROUP];
    for row in out.iter_mut().take(count as usize) {
        let (mut low, mut high) = ([0; GROUP], [ROWS as i32; GROUP]);
        for step in &mut steps {
            step.narrow(&mut low, &mut high);
        }
        for i in 0..GROUP {
            let first = low[i].min(ROWS as i32);
            let end = high[i].max(first);
            row[i] = (first | end << 8) as u16;
            pixels[i] += end - first;
        }
    }
    pixels
}
