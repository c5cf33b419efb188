//! Scaling an image in client memory (GLU 1.3, section 3.1).
//!
//! The image is unpacked under the unpack state, filtered with a box, brought to whole numbers of 16 bits and packed
//! under the pack state. The step over 16 bits, of which a byte takes the upper eight, is not the specification's: it
//! is what the original GLU computes, and programs compare its results ((0, 100, 200, 255) on two texels is (50, 228)).

use super::constants::*;
use super::grid::{Grid, Kernel};
use crate::enums::*;
use crate::error::{GlError, invalid_value};
use crate::num::clamp01;
use crate::pixels::format::{PixelFormat, PixelKind, Type};
use crate::pixels::pack::ClientTarget;
use crate::pixels::transfer::Transfer;
use crate::pixels::unpack::ClientImage;
use crate::state::pixel::PixelStore;

/// What can go wrong in a function on images: a code of GLU, or an error of GL with its sentence.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ImageError {
    Memory,
    Gl(GlError),
}

impl From<GlError> for ImageError {
    fn from(error: GlError) -> Self {
        ImageError::Gl(error)
    }
}

impl ImageError {
    /// GLU's code.
    pub fn code(&self) -> GLenum {
        match self {
            ImageError::Memory => GLU_OUT_OF_MEMORY,
            ImageError::Gl(error) => match error.code {
                GL_INVALID_ENUM => GLU_INVALID_ENUM,
                GL_INVALID_VALUE => GLU_INVALID_VALUE,
                GL_OUT_OF_MEMORY => GLU_OUT_OF_MEMORY,
                _ => GLU_INVALID_OPERATION,
            },
        }
    }
}

/// One side of a scaling: the size, the type and how the memory is laid out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<'a> {
    pub size: [i32; 2],
    pub type_: GLenum,
    pub store: &'a PixelStore,
}

/// Scales `input` into `output`. Nothing is written if there is an error; a size of 0 on either side scales nothing.
pub(super) fn scale(
    format: GLenum,
    from: Side<'_>,
    input: &[u8],
    to: Side<'_>,
    output: &mut [u8],
) -> Result<(), ImageError> {
    if from.size.iter().chain(&to.size).any(|&n| n < 0) {
        return Err(invalid_value("the size of an image must not be negative").into());
    }
    let (pixel_in, pixel_out) = (PixelFormat::new(format, from.type_)?, PixelFormat::new(format, to.type_)?);
    if from.size.contains(&0) || to.size.contains(&0) {
        return Ok(());
    }
    let image = ClientImage::new_2d(input, from.store, from.size, pixel_in)?;
    let mut target = ClientTarget::new_2d(output, to.store, to.size, pixel_out)?;
    let [width, height] = to.size.map(|n| n.unsigned_abs() as usize);
    let grid = Grid::unpack(&image).ok_or(ImageError::Memory)?;
    let mut grid = grid.resized([width, height, 1], Kernel::Centred).ok_or(ImageError::Memory)?;
    for (y, row) in grid.texels.chunks_exact_mut(width).enumerate() {
        pack_row(&mut target, y, row)?;
    }
    Ok(())
}

/// Packs a row of the result.
fn pack_row(target: &mut ClientTarget<'_>, y: usize, row: &mut [[f32; 4]]) -> Result<(), ImageError> {
    let pixel = target.pixel();
    let at = [0, y, 0];
    match pixel.kind() {
        PixelKind::Color => {
            for texel in &mut *row {
                *texel = texel.map(|v| quantised(v, pixel.type_));
                if pixel.format.is_luminance() {
                    // Packing adds R, G and B to a luminance.
                    *texel = [texel[0], 0.0, 0.0, texel[3]];
                }
            }
            target.colors(at, Transfer::NEUTRAL, row);
        }
        PixelKind::Index | PixelKind::Stencil => {
            let mut indices = super::grid::try_vec(row.len(), 0u32).ok_or(ImageError::Memory)?;
            for (index, texel) in indices.iter_mut().zip(&*row) {
                // A number of 16 bits as everything here; `as` limits and makes NaN 0.
                let whole = u32::from((texel[0] + 0.5) as u16);
                // A bit of a bitmap is on from the middle of the range up.
                *index = if pixel.type_ == Type::Bitmap { u32::from(texel[0] >= 0.5) } else { whole };
            }
            target.raw_indices(at, &indices);
        }
        PixelKind::Depth | PixelKind::DepthStencil => {
            let mut depths = super::grid::try_vec(row.len(), 0.0f32).ok_or(ImageError::Memory)?;
            for (depth, texel) in depths.iter_mut().zip(&*row) {
                *depth = quantised(texel[0], pixel.type_);
            }
            target.depths(at, Transfer::NEUTRAL, &depths);
        }
    }
    Ok(())
}

/// A component as the number of 16 bits that it becomes, and for bytes as the upper half of that.
fn quantised(v: f32, type_: Type) -> f32 {
    // The fit to 16 bits in f64: a whole number plus a half must not move.
    let whole = (f64::from(clamp01(v)) * 65535.0 + 0.5) as u32;
    match type_ {
        Type::UnsignedByte => (whole >> 8) as f32 / 255.0,
        Type::Byte => crate::num::snorm_to_f32((whole >> 9) as i32, 8),
        Type::Short => crate::num::snorm_to_f32((whole >> 1) as i32, 16),
        _ => crate::num::u16_to_f32(whole as u16),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIGHT: PixelStore = PixelStore::TIGHT;

    fn side(size: [i32; 2], type_: GLenum) -> Side<'static> {
        Side { size, type_, store: &TIGHT }
    }

    fn luminance(values: &[u8], size: [i32; 2], to: [i32; 2]) -> Vec<u8> {
        let mut out = vec![0; (to[0] * to[1]) as usize];
        let byte = GL_UNSIGNED_BYTE;
        scale(GL_LUMINANCE, side(size, byte), values, side(to, byte), &mut out).expect("legal");
        out
    }

    #[test]
    fn scaling_gives_the_values_of_the_original_glu() {
        let row = [0, 100, 200, 255];
        assert_eq!(luminance(&row, [4, 1], [2, 1]), [50, 228]);
        assert_eq!(luminance(&row, [4, 1], [3, 1]), [25, 150, 242]);
        assert_eq!(luminance(&row, [4, 1], [4, 1]), row);
        assert_eq!(luminance(&row, [4, 1], [8, 1]), [64, 25, 75, 125, 175, 214, 242, 191]);
        let rows = [0, 100, 200, 255, 10, 20, 30, 40];
        let both = luminance(&rows, [4, 2], [3, 3]);
        assert_eq!(both[..6], [23, 129, 208, 18, 87, 139]);
    }

    #[test]
    fn every_type_comes_out() {
        let row = [0u8, 100, 200, 255];
        let run = |type_, out: &mut [u8]| {
            scale(GL_LUMINANCE, side([4, 1], GL_UNSIGNED_BYTE), &row, side([4, 1], type_), out).expect("legal");
        };
        let mut out = [0u8; 16];
        run(GL_UNSIGNED_SHORT, &mut out);
        let shorts: Vec<u16> = out.chunks_exact(2).take(4).map(|b| u16::from_ne_bytes([b[0], b[1]])).collect();
        assert_eq!(shorts, [0, 25700, 51400, 65535]);
        run(GL_BYTE, &mut out);
        assert_eq!(out[..4], [0, 50, 100, 127]);
        run(GL_UNSIGNED_INT, &mut out);
        let ints: Vec<u32> = out.chunks_exact(4).map(|b| u32::from_ne_bytes([b[0], b[1], b[2], b[3]])).collect();
        // The float on the way has 24 bits.
        assert!(ints.iter().zip([0u32, 1_684_300_900, 3_368_601_800, u32::MAX]).all(|(a, b)| a.abs_diff(b) <= 256));
        let mut out = [0u8; 2];
        let rgb = [255, 128, 7];
        let to = side([1, 1], GL_UNSIGNED_SHORT_5_6_5);
        scale(GL_RGB, side([1, 1], GL_UNSIGNED_BYTE), &rgb, to, &mut out).expect("legal");
        assert_eq!(u16::from_ne_bytes(out), 0xfc01);
    }

    #[test]
    fn indices_keep_their_size() {
        let mut out = [0; 2];
        let byte = GL_UNSIGNED_BYTE;
        scale(GL_COLOR_INDEX, side([4, 1], byte), &[0, 100, 200, 254], side([2, 1], byte), &mut out).expect("legal");
        assert_eq!(out, [50, 227]);
        let mut bits = [0];
        let to = side([8, 1], GL_BITMAP);
        scale(GL_COLOR_INDEX, side([4, 1], byte), &[0, 1, 1, 0], to, &mut bits).expect("legal");
        assert_eq!(bits, [0b0011_1100]);
    }

    #[test]
    fn errors_have_codes_and_write_nothing() {
        let code = |format, size: [i32; 2], type_, len: usize| {
            let mut out = [7; 4];
            let input = vec![0; len];
            let result = scale(format, side(size, type_), &input, side([1, 1], GL_UNSIGNED_BYTE), &mut out);
            assert_eq!(out, [7; 4]);
            result.err().map(|e| e.code())
        };
        assert_eq!(code(GL_RGB, [-1, 1], GL_BYTE, 9), Some(GLU_INVALID_VALUE));
        assert_eq!(code(77, [1, 1], GL_BYTE, 9), Some(GLU_INVALID_ENUM));
        assert_eq!(code(GL_RGB, [1, 1], 77, 9), Some(GLU_INVALID_ENUM));
        assert_eq!(code(GL_RGBA, [1, 1], GL_UNSIGNED_BYTE_3_3_2, 9), Some(GLU_INVALID_OPERATION));
        assert_eq!(code(GL_RGB, [2, 2], GL_BYTE, 9), Some(GLU_INVALID_OPERATION));
        assert_eq!(code(GL_RGB, [0, 2], GL_BYTE, 0), None);
        assert_eq!(code(GL_RGB, [i32::MAX, i32::MAX], GL_BYTE, 9), Some(GLU_INVALID_OPERATION));
    }
}
