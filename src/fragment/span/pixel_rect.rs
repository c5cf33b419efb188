//! The span shader of pixel rectangles of packed colours (OpenGL 1.5, section 3.6.4): a block is a copy.

use super::long::{DEPTH, whole_row};
use super::shader::SpanShader;
use crate::fragment::batch::Segment;
use crate::fragment::plane_eval::{LinearEval, Positions};
use crate::fragment::planes::Planes;
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::uniforms::{FragUniforms, Work};

/// The colours of a row.
struct PixelRow<'a> {
    /// Those from `first` on.
    colors: &'a [u32],
    /// The x, relative to the primitive's origin, of the first.
    first: i32,
    or: u32,
}

impl SpanShader for PixelRow<'_> {
    const IS_SMALL: bool = true;

    #[inline(always)]
    fn pixels<const N: usize, P: Positions<N>>(&self, at: P, _below: &[u32; N], out: &mut [u32; N]) {
        let x = at.sum(&LinearEval { at: 0.0, x: 1.0_f32, y: 0.0 }, 0) as i32;
        let x = x.wrapping_sub(self.first) as usize;
        let or = self.or;
        match self.colors.get(x..).and_then(|colors| colors.first_chunk::<N>()) {
            Some(colors) => {
                for i in 0..N {
                    out[i] = colors[i] | or;
                }
            }
            // The last block of the image.
            None => {
                for (out, color) in out.iter_mut().zip(self.colors.get(x..).unwrap_or(&[])) {
                    *out = color | or;
                }
            }
        }
    }
}

/// A row of the image; gives how many of its pixels are done.
#[inline(always)]
pub fn pixel_row(u: &FragUniforms, w: &mut Work<'_, '_>, segment: &Segment, planes: &Planes, arg: u32) -> u32 {
    let (first, y) = row_origin(segment, planes);
    let Some(colors) = u.pixels.as_ref().and_then(|rect| rect.packed_from(first, y)) else { return 0 };
    let or = u.packed_or;
    if arg & DEPTH == 0 {
        let (at, len) = (segment.offset as usize, segment.len as usize);
        let (Some(pixels), Some(colors)) = (w.band.rgba8.get_mut(at..at + len), colors.get(..len)) else { return 0 };
        if or == 0 {
            pixels.copy_from_slice(colors);
        } else {
            pixels.iter_mut().zip(colors).for_each(|(pixel, color)| *pixel = color | or);
        }
        if let Some(counts) = &mut w.counts {
            counts.passed += u64::from(segment.len);
        }
        return segment.len;
    }
    whole_row(w, (segment, planes), arg, Some(&PixelRow { colors, first, or }))
}
