//! Arguments that are memory on their way into a display list (OpenGL 1.5, sections 3.6.1, 3.6.4 and 5.4): a list keeps
//! an image as it is under the unpack state when it is compiled. It is kept tight: whole elements in native byte order,
//! rows without a gap, bitmaps with the highest bit first; so the unpack state at the time of the call does not matter.

use super::engine::Engine;
use super::pixels_arg::{Pixels, try_copy};
use crate::enums::GLenum;
use crate::error::{Outcome, out_of_memory};
use crate::pixels::format::{PixelFormat, Type};
use crate::pixels::layout::ClientLayout;
use crate::state::pixel::PixelStore;
use std::sync::Arc;

/// The size of an image: two numbers for a 1D or 2D image, three for a 3D image, whose slices can be skipped.
pub(crate) trait ImageSize: Copy {
    /// Where the image lies in client memory.
    fn geometry(self, store: &PixelStore, pixel: PixelFormat) -> Outcome<ClientLayout>;
}

impl ImageSize for [i32; 2] {
    fn geometry(self, store: &PixelStore, pixel: PixelFormat) -> Outcome<ClientLayout> {
        ClientLayout::of_2d(store, self, pixel)
    }
}

impl ImageSize for [i32; 3] {
    fn geometry(self, store: &PixelStore, pixel: PixelFormat) -> Outcome<ClientLayout> {
        ClientLayout::of_3d(store, self, pixel)
    }
}

/// Bytes from the pointer to the end of the last row; 0 for an image that is an error anyway. For the C door.
#[cfg_attr(not(feature = "capi"), allow(dead_code, reason = "only C has pointers without a length"))]
pub(crate) fn image_bytes(store: &PixelStore, size: impl ImageSize, format: GLenum, type_: GLenum) -> usize {
    PixelFormat::new(format, type_).and_then(|pixel| size.geometry(store, pixel)).map_or(0, |g| g.total)
}

/// Values of a slice argument that a list keeps.
pub(crate) fn keep<T: Copy>(values: &[T]) -> Outcome<Box<[T]>> {
    let kept = try_copy(values).ok_or_else(|| out_of_memory("no memory left for a display list"))?;
    Ok(kept.into_boxed_slice())
}

/// Bytes of a memory argument that a list keeps as they are.
pub(crate) fn keep_bytes(pixels: &Pixels<'_>) -> Outcome<Pixels<'static>> {
    match pixels {
        Pixels::Null => Ok(Pixels::Null),
        Pixels::Kept(bytes) => Ok(Pixels::Kept(bytes.clone())),
        Pixels::Bytes(bytes) => {
            let kept = try_copy(bytes).ok_or_else(|| out_of_memory("no memory left for a display list"))?;
            Ok(Pixels::Kept(Arc::new(kept)))
        }
    }
}

/// An image as a display list keeps it. One that is an error is kept as it is: the error belongs to the execution.
pub(crate) fn capture(
    engine: &mut Engine,
    size: impl ImageSize,
    format: GLenum,
    type_: GLenum,
    pixels: &Pixels<'_>,
) -> Outcome<Pixels<'static>> {
    let store = engine.unpack_store();
    let Pixels::Bytes(bytes) = pixels else { return keep_bytes(pixels) };
    let Ok(pixel) = PixelFormat::new(format, type_) else { return keep_bytes(pixels) };
    let Ok(geometry) = size.geometry(&store, pixel) else { return keep_bytes(pixels) };
    geometry.check_len(bytes.len())?;
    Ok(Pixels::Kept(Arc::new(tight(bytes, &store, &geometry, pixel)?)))
}

/// The bytes of an image without what the store puts between them. `bytes` has been checked against the geometry.
fn tight(bytes: &[u8], store: &PixelStore, geometry: &ClientLayout, pixel: PixelFormat) -> Outcome<Vec<u8>> {
    let bitmap = pixel.type_ == Type::Bitmap;
    let row_bytes = if bitmap { geometry.width.div_ceil(8) } else { geometry.row_bytes };
    let rows = geometry.height.saturating_mul(geometry.depth);
    let mut kept = Vec::new();
    if row_bytes == 0 {
        // Rows without a byte may be very many.
        return Ok(kept);
    }
    kept.try_reserve_exact(row_bytes.saturating_mul(rows))
        .map_err(|_| out_of_memory("no memory left to keep the image in the display list"))?;
    let element = if store.swap_bytes { pixel.type_.bytes().max(1) } else { 1 };
    for (z, y) in (0..geometry.depth).flat_map(|z| (0..geometry.height).map(move |y| (z, y))) {
        let start = geometry.row_start(y, z);
        let Some(row) = bytes.get(start..).and_then(|row| row.get(..geometry.row_bytes)) else { break };
        if bitmap {
            let bit = |x: usize| {
                let at = geometry.first_bit + x;
                let byte = row.get(at / 8).copied().unwrap_or(0);
                let shift = if store.lsb_first { at % 8 } else { 7 - at % 8 };
                if x < geometry.width { byte >> shift & 1 } else { 0 }
            };
            kept.extend((0..row_bytes).map(|i| (0..8).fold(0, |byte, x| byte << 1 | bit(8 * i + x))));
        } else if element == 1 {
            kept.extend_from_slice(row);
        } else {
            kept.extend(row.chunks(element).flat_map(|e| e.iter().rev()));
        }
    }
    Ok(kept)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::*;

    fn kept(bytes: &[u8], store: PixelStore, size: [i32; 2], format: GLenum, type_: GLenum) -> Vec<u8> {
        let pixel = PixelFormat::new(format, type_).unwrap();
        tight(bytes, &store, &size.geometry(&store, pixel).unwrap(), pixel).unwrap()
    }

    #[test]
    fn rows_lose_their_padding_and_skips() {
        let store = PixelStore { skip_pixels: 1, row_length: 3, ..PixelStore::INITIAL };
        let bytes = [0, 1, 2, 99, 0, 3, 4, 99];
        assert_eq!(kept(&bytes, store, [2, 2], GL_LUMINANCE, GL_UNSIGNED_BYTE), [1, 2, 3, 4]);
    }

    #[test]
    fn swapped_elements_are_put_right() {
        let store = PixelStore { swap_bytes: true, ..PixelStore::TIGHT };
        assert_eq!(kept(&[1, 2, 3, 4], store, [2, 1], GL_LUMINANCE, GL_UNSIGNED_SHORT), [2, 1, 4, 3]);
    }

    #[test]
    fn bitmaps_lose_skipped_bits_and_turn_highest_bit_first() {
        let store = PixelStore { lsb_first: true, skip_pixels: 3, ..PixelStore::TIGHT };
        // Bits from the lowest: 000 1 0110 1000 0000; ten of them from the fourth on: 1 0110 1000 0.
        let bytes = [0b0110_1000, 0b0000_0001];
        assert_eq!(kept(&bytes, store, [10, 1], GL_COLOR_INDEX, GL_BITMAP), [0b1011_0100, 0b0000_0000]);
    }
}
