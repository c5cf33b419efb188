//! Fragments of pixel rectangles (OpenGL 1.5, section 3.6.4): colour and depth come from the image in place of planes.

use crate::fragment::batch::FragmentBatch;
use crate::fragment::pixel_rect::{PixelRect, PixelValues};
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::u8_to_f32;
use crate::simd::{LANES, stage};

/// Which values the lanes of a batch have.
#[inline(always)]
fn indices(b: &FragmentBatch, w: &Work<'_, '_>, rect: &PixelRect) -> [usize; LANES] {
    let mut indices = [0; LANES];
    for segment in b.segments.iter().take(b.segment_count) {
        let Some(planes) = w.planes.get(segment.prim as usize) else { continue };
        let (x, y) = row_origin(segment, planes);
        let lanes = segment.start as usize..(segment.start as usize).saturating_add(segment.len as usize).min(LANES);
        for lane in lanes {
            indices[lane] = if segment.row {
                rect.index(x.wrapping_add(lane as i32), y)
            } else {
                rect.index(b.dx[lane] as i32, b.dy[lane] as i32)
            };
        }
    }
    indices
}

/// The argument of [`PIXEL_COLOR`]: the colour is what the first texture environment reads.
pub const TEXTURED: u32 = 1;

stage! {
    /// The colour of each fragment, as the fragment's colour or, with [`TEXTURED`], as the primary colour.
    pub fn PIXEL_COLOR: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        let Some(rect) = &u.pixels else { return };
        let indices = indices(b, w, rect);
        let out = if arg & TEXTURED != 0 { &mut b.tex.primary } else { &mut b.tex.previous };
        for i in 0..LANES {
            let color = match &rect.values {
                PixelValues::Packed(colors) => colors.get(indices[i]).map(|c| c.to_le_bytes().map(u8_to_f32)),
                PixelValues::Colors(colors) => colors.get(indices[i]).copied(),
                PixelValues::Depths(_) => None,
            };
            let color = color.unwrap_or([0.0; 4]);
            for k in 0..4 {
                out[k][i] = color[k];
            }
        }
    }

    /// The depth of each fragment.
    pub fn PIXEL_DEPTH: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, _arg: u32) {
        let Some(rect) = &u.pixels else { return };
        let PixelValues::Depths(depths) = &rect.values else { return };
        let indices = indices(b, w, rect);
        for i in 0..LANES {
            b.z[i] = depths.get(indices[i]).copied().unwrap_or(0);
        }
    }
}
