//! Where the groups of a client image lie in memory (OpenGL 1.5, section 3.6.4, figure 3.8). Everything follows from a
//! start, a stride from row to row and one from slice to slice; a bitmap counts bits within a row. All sizes come from
//! the program, so every product is checked: an image that no memory can hold is an error, not a wrapped number.

use super::format::{PixelFormat, Type};
use crate::error::{GlError, Outcome, invalid_operation, invalid_value};
use crate::state::pixel::PixelStore;

/// The layout of an image in client memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClientLayout {
    /// Groups in a row of the image.
    pub width: usize,
    /// Rows of the image.
    pub height: usize,
    /// Slices of the image.
    pub depth: usize,
    /// Offset of the byte that holds the first group.
    pub start: usize,
    /// The first group's bit within that byte, for bitmaps.
    pub first_bit: usize,
    /// Bytes from row to row.
    pub row_stride: usize,
    /// Bytes from slice to slice.
    pub slice_stride: usize,
    /// Bytes that a row of the image touches.
    pub row_bytes: usize,
    /// Bytes from the start of memory to the end of the last row; 0 if the image is empty.
    pub total: usize,
}

impl ClientLayout {
    /// The layout of a 1D or 2D image: skipped slices and the image height do not apply.
    pub fn of_2d(store: &PixelStore, size: [i32; 2], pixel: PixelFormat) -> Outcome<ClientLayout> {
        let store = PixelStore { skip_images: 0, image_height: 0, ..*store };
        ClientLayout::of_3d(&store, [size[0], size[1], 1], pixel)
    }

    /// The layout of a 3D image.
    pub fn of_3d(store: &PixelStore, size: [i32; 3], pixel: PixelFormat) -> Outcome<ClientLayout> {
        let [width, height, depth] = size.map(u64::try_from);
        let (Ok(width), Ok(height), Ok(depth)) = (width, height, depth) else {
            return Err(invalid_value(format!(
                "a size of {} x {} x {}; none may be negative",
                size[0], size[1], size[2]
            )));
        };
        ClientLayout::compute(store, [width, height, depth], pixel).ok_or_else(|| {
            invalid_operation(format!(
                "an image of {width} x {height} x {depth} groups with these row lengths and skips is beyond memory"
            ))
        })
    }

    fn compute(store: &PixelStore, [width, height, depth]: [u64; 3], pixel: PixelFormat) -> Option<ClientLayout> {
        let or = |n: u32, size: u64| if n > 0 { u64::from(n) } else { size };
        let row_length = or(store.row_length, width);
        let rows = or(store.image_height, height);
        let align = u64::from(store.alignment.max(1));
        let bitmap = pixel.type_ == Type::Bitmap;
        let group = pixel.group_bytes() as u64;
        let bytes = |groups: u64| if bitmap { Some(groups.div_ceil(8)) } else { groups.checked_mul(group) };

        let row_stride = bytes(row_length)?.checked_next_multiple_of(align)?;
        let slice_stride = row_stride.checked_mul(rows)?;
        let skip = u64::from(store.skip_pixels);
        let (skip_bytes, first_bit) = if bitmap { (skip / 8, skip % 8) } else { (skip.checked_mul(group)?, 0) };
        let start = slice_stride
            .checked_mul(store.skip_images.into())?
            .checked_add(row_stride.checked_mul(store.skip_rows.into())?)?
            .checked_add(skip_bytes)?;
        let row_bytes = bytes(first_bit.checked_add(width)?)?;
        let total = if width == 0 || height == 0 || depth == 0 {
            0
        } else {
            start
                .checked_add(slice_stride.checked_mul(depth - 1)?)?
                .checked_add(row_stride.checked_mul(height - 1)?)?
                .checked_add(row_bytes)?
        };
        let narrow = |n: u64| usize::try_from(n).ok().filter(|&n| n <= isize::MAX as usize);
        Some(ClientLayout {
            width: narrow(width)?,
            height: narrow(height)?,
            depth: narrow(depth)?,
            start: narrow(start)?,
            first_bit: narrow(first_bit)?,
            row_stride: narrow(row_stride)?,
            slice_stride: narrow(slice_stride)?,
            row_bytes: narrow(row_bytes)?,
            total: narrow(total)?,
        })
    }

    /// Where row `y` of slice `z` begins.
    #[must_use]
    pub fn row_start(&self, y: usize, z: usize) -> usize {
        self.start + z * self.slice_stride + y * self.row_stride
    }

    /// The error for memory that holds `len` bytes only, if that is too few.
    pub fn check_len(&self, len: usize) -> Outcome {
        if len < self.total { Err(self.too_short(len)) } else { Ok(()) }
    }

    #[cold]
    fn too_short(&self, len: usize) -> GlError {
        invalid_operation(format!(
            "the pixels are {len} bytes, but {} x {} x {} groups with this format, type and pixel store span {} bytes \
             (rows are {} bytes apart; see GL_*_ALIGNMENT, GL_*_ROW_LENGTH and the skips)",
            self.width, self.height, self.depth, self.total, self.row_stride
        ))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::enums::*;

    /// How many bytes of client memory a 3D image spans, from its pointer to the end of its last row, skips included.
    /// For TexImage3D, TexSubImage3D and the slices of GetTexImage; everything else is [`image_bytes_2d`].
    pub(in crate::pixels) fn image_bytes(
        store: &PixelStore,
        width: i32,
        height: i32,
        depth: i32,
        format: GLenum,
        type_: GLenum,
    ) -> Outcome<usize> {
        Ok(ClientLayout::of_3d(store, [width, height, depth], PixelFormat::new(format, type_)?)?.total)
    }

    /// How many bytes of client memory a 1D or 2D image spans: as [`image_bytes`], without skipped slices and image height.
    pub(in crate::pixels) fn image_bytes_2d(
        store: &PixelStore,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
    ) -> Outcome<usize> {
        Ok(ClientLayout::of_2d(store, [width, height], PixelFormat::new(format, type_)?)?.total)
    }

    fn rgb(store: &PixelStore, size: [i32; 3]) -> usize {
        image_bytes(store, size[0], size[1], size[2], GL_RGB, GL_UNSIGNED_BYTE).unwrap()
    }

    #[test]
    fn rows_are_padded_to_the_alignment_but_not_the_last_one() {
        let at = |alignment| PixelStore { alignment, ..PixelStore::INITIAL };
        assert_eq!(rgb(&at(1), [5, 3, 1]), 45);
        assert_eq!(rgb(&at(2), [5, 3, 1]), 16 * 2 + 15);
        assert_eq!(rgb(&at(4), [5, 3, 1]), 16 * 2 + 15);
        assert_eq!(rgb(&at(8), [3, 2, 1]), 16 + 9);
        assert_eq!(image_bytes_2d(&at(8), 3, 2, GL_RED, GL_FLOAT), Ok(16 + 12));
        assert_eq!(image_bytes_2d(&at(4), 3, 2, GL_RGB, GL_UNSIGNED_SHORT_5_6_5), Ok(8 + 6));
    }

    #[test]
    fn skips_and_row_lengths_move_the_groups() {
        let store = PixelStore {
            row_length: 10,
            image_height: 7,
            skip_rows: 2,
            skip_pixels: 3,
            skip_images: 1,
            alignment: 1,
            ..PixelStore::INITIAL
        };
        assert_eq!(rgb(&store, [4, 5, 2]), 210 + 60 + 9 + 210 + 4 * 30 + 12);
        assert_eq!(image_bytes_2d(&store, 4, 5, GL_RGB, GL_UNSIGNED_BYTE), Ok(60 + 9 + 4 * 30 + 12));
        // A row length shorter than the image: rows overlap, as the equations say.
        let store = PixelStore { row_length: 1, alignment: 1, ..PixelStore::INITIAL };
        assert_eq!(rgb(&store, [4, 2, 1]), 3 + 12);
    }

    #[test]
    fn bitmaps_count_bits() {
        let store = PixelStore { alignment: 1, ..PixelStore::INITIAL };
        assert_eq!(image_bytes_2d(&store, 9, 3, GL_COLOR_INDEX, GL_BITMAP), Ok(6));
        let store = PixelStore { skip_pixels: 13, row_length: 32, alignment: 2, ..PixelStore::INITIAL };
        // Bit 13 is bit 5 of byte 1; 5 + 4 bits are two bytes.
        assert_eq!(image_bytes_2d(&store, 4, 2, GL_COLOR_INDEX, GL_BITMAP), Ok(1 + 4 + 2));
        assert_eq!(image_bytes_2d(&store, 3, 2, GL_COLOR_INDEX, GL_BITMAP), Ok(1 + 4 + 1));
    }

    #[test]
    fn empty_images_take_no_memory_and_absurd_ones_are_errors() {
        let store = PixelStore { skip_rows: 1000, ..PixelStore::INITIAL };
        assert_eq!(rgb(&store, [0, 5, 5]), 0);
        assert_eq!(rgb(&store, [5, 5, 0]), 0);
        let huge = PixelStore {
            row_length: i32::MAX as u32,
            image_height: i32::MAX as u32,
            skip_images: i32::MAX as u32,
            ..PixelStore::INITIAL
        };
        let got = image_bytes(&huge, i32::MAX, i32::MAX, i32::MAX, GL_RGBA, GL_FLOAT);
        assert_eq!(got.unwrap_err().code, GL_INVALID_OPERATION);
        assert_eq!(image_bytes_2d(&store, -1, 2, GL_RGB, GL_FLOAT).unwrap_err().code, GL_INVALID_VALUE);
    }
}
