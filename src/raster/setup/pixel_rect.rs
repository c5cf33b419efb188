//! Pixel rectangles and bitmaps (OpenGL 1.5, sections 3.6.4 and 3.7) as primitives: the values of the raster position are the
//! same for all of their fragments, so their planes have no slope, as those of a point.

use super::SetupContext;
use super::point::PointInput;
use crate::raster::geometry::{Coverage, SceneGeometry};
use crate::raster::state::Rect;
use crate::raster::vertex::VertexRef;

/// Pixels of a bitmap: those of 8 by 8 from (x, y) on whose bit (8 row + column) is set.
pub type BitmapBlock = ([i32; 2], u64);

/// The bits of a block that lie in a rectangle.
fn clipped(([x, y], bits): BitmapBlock, clip: Rect) -> u64 {
    if x >= clip.x0 && y >= clip.y0 && x.saturating_add(8) <= clip.x1 && y.saturating_add(8) <= clip.y1 {
        return bits;
    }
    let within = |at: i32, low: i32, high: i32| at >= low && at < high;
    let mut kept = 0;
    for i in 0..8 {
        if within(y.saturating_add(i), clip.y0, clip.y1) {
            kept |= 0xFF << (8 * i);
        }
    }
    let mut columns = 0u64;
    for i in 0..8 {
        if within(x.saturating_add(i), clip.x0, clip.x1) {
            columns |= 0x0101_0101_0101_0101 << i;
        }
    }
    bits & kept & columns
}

impl SceneGeometry {
    /// Sets up a pixel rectangle, whose origin is its lower left pixel. It lies within the clip rectangle; `memory` is what
    /// its image takes.
    pub(crate) fn pixel_rect(&mut self, cx: &SetupContext, v: VertexRef<'_>, rect: Rect, memory: usize) {
        if rect.is_empty() {
            return;
        }
        let planes = self.point_planes(cx, &PointInput::front(v), [rect.x0, rect.y0]);
        let side = |low: i32, high: i32| u64::from((high - low).unsigned_abs());
        self.image_memory += memory;
        self.push(Coverage::Rect(rect), cx.draw, planes, side(rect.x0, rect.x1) * side(rect.y0, rect.y1));
    }

    /// Sets up blocks of a bitmap, all with the same planes.
    pub(crate) fn bitmap(&mut self, cx: &SetupContext, v: VertexRef<'_>, blocks: impl Iterator<Item = BitmapBlock>) {
        let mut planes = None;
        for (at, bits) in blocks {
            let bits = clipped((at, bits), cx.rs.clip);
            if bits != 0 {
                let planes = *planes.get_or_insert_with(|| self.point_planes(cx, &PointInput::front(v), at));
                let [x, y] = at;
                self.push(Coverage::Mask { x, y, bits }, cx.draw, planes, bits.count_ones().into());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Rect, clipped};

    #[test]
    fn a_block_keeps_the_bits_that_lie_in_the_clip() {
        let clip = Rect { x0: 3, y0: 5, x1: 20, y1: 17 };
        for (x, y) in [(4, 6), (-2, 0), (0, 5), (15, 12), (19, 16), (20, 5), (3, 17), (i32::MAX - 3, i32::MIN)] {
            let got = clipped(([x, y], u64::MAX), clip);
            for i in 0..64 {
                let (px, py) = (i64::from(x) + i % 8, i64::from(y) + i / 8);
                let inside = (3..20).contains(&px) && (5..17).contains(&py);
                assert_eq!(got >> i & 1 == 1, inside, "{x} {y} bit {i}");
            }
        }
    }
}
