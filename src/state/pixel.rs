//! Pixel state (OpenGL 1.5, sections 3.6.1 to 3.6.3 and 3.6.5, tables 3.1, 3.2, 6.22 and 6.23): how client memory is laid
//! out (`PixelStore`, client state), what is done to pixels on their way (`PixelTransfer`), and the zoom of DrawPixels. A
//! setter checks its value before it changes anything.

use super::color_buffer::ColorBufferName;
use super::imaging::Imaging;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_value};

/// Layout of pixels in client memory, in one direction (table 3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelStore {
    /// Whether the bytes of each element of more than one byte are reversed.
    pub swap_bytes: bool,
    /// Whether the first pixel of a bitmap's byte is its lowest bit.
    pub lsb_first: bool,
    /// Groups in a row of memory, 0 for the width of the image.
    pub row_length: u32,
    /// Rows in a slice of memory, 0 for the height of the image; only 3D images have slices.
    pub image_height: u32,
    /// Rows left out at the start of each slice.
    pub skip_rows: u32,
    /// Groups left out at the start of each row.
    pub skip_pixels: u32,
    /// Slices left out; only 3D images have slices.
    pub skip_images: u32,
    /// Each row starts at a multiple of so many bytes: 1, 2, 4 or 8.
    pub alignment: u32,
}

impl Default for PixelStore {
    fn default() -> Self {
        Self::INITIAL
    }
}

impl PixelStore {
    /// The initial layout: rows aligned to 4 bytes, nothing left out.
    pub const INITIAL: Self = Self {
        swap_bytes: false,
        lsb_first: false,
        row_length: 0,
        image_height: 0,
        skip_rows: 0,
        skip_pixels: 0,
        skip_images: 0,
        alignment: 4,
    };

    /// Rows that follow each other without a gap: what callers inside the library use for their own images.
    pub const TIGHT: Self = Self { alignment: 1, ..Self::INITIAL };

    fn set(&mut self, field: Field, value: i32) -> Outcome {
        let number = || {
            u32::try_from(value)
                .map_err(|_| invalid_value(format!("a length or skip of {value}; it must not be negative")))
        };
        match field {
            Field::SwapBytes => self.swap_bytes = value != 0,
            Field::LsbFirst => self.lsb_first = value != 0,
            Field::RowLength => self.row_length = number()?,
            Field::ImageHeight => self.image_height = number()?,
            Field::SkipRows => self.skip_rows = number()?,
            Field::SkipPixels => self.skip_pixels = number()?,
            Field::SkipImages => self.skip_images = number()?,
            Field::Alignment => match value {
                1 | 2 | 4 | 8 => self.alignment = value.unsigned_abs(),
                _ => return Err(invalid_value(format!("an alignment of {value}; it is 1, 2, 4 or 8"))),
            },
        }
        Ok(())
    }

    fn get(&self, field: Field) -> u32 {
        match field {
            Field::SwapBytes => self.swap_bytes.into(),
            Field::LsbFirst => self.lsb_first.into(),
            Field::RowLength => self.row_length,
            Field::ImageHeight => self.image_height,
            Field::SkipRows => self.skip_rows,
            Field::SkipPixels => self.skip_pixels,
            Field::SkipImages => self.skip_images,
            Field::Alignment => self.alignment,
        }
    }
}

#[derive(Clone, Copy)]
enum Field {
    SwapBytes,
    LsbFirst,
    RowLength,
    ImageHeight,
    SkipRows,
    SkipPixels,
    SkipImages,
    Alignment,
}

/// The names of PixelStore: the parameter for unpacking, the one for packing.
const STORE: [(GLenum, GLenum, Field); 8] = [
    (GL_UNPACK_SWAP_BYTES, GL_PACK_SWAP_BYTES, Field::SwapBytes),
    (GL_UNPACK_LSB_FIRST, GL_PACK_LSB_FIRST, Field::LsbFirst),
    (GL_UNPACK_ROW_LENGTH, GL_PACK_ROW_LENGTH, Field::RowLength),
    (GL_UNPACK_IMAGE_HEIGHT, GL_PACK_IMAGE_HEIGHT, Field::ImageHeight),
    (GL_UNPACK_SKIP_ROWS, GL_PACK_SKIP_ROWS, Field::SkipRows),
    (GL_UNPACK_SKIP_PIXELS, GL_PACK_SKIP_PIXELS, Field::SkipPixels),
    (GL_UNPACK_SKIP_IMAGES, GL_PACK_SKIP_IMAGES, Field::SkipImages),
    (GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT, Field::Alignment),
];

/// Both directions of pixel storage: a group of client state (`GL_CLIENT_PIXEL_STORE_BIT`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelStores {
    /// From client memory to GL.
    pub unpack: PixelStore,
    /// From GL to client memory.
    pub pack: PixelStore,
}

impl PixelStores {
    /// PixelStorei.
    pub fn set(&mut self, pname: GLenum, value: i32) -> Outcome {
        for (unpack, pack, field) in STORE {
            if pname == unpack {
                return self.unpack.set(field, value);
            }
            if pname == pack {
                return self.pack.set(field, value);
            }
        }
        Err(invalid_enum(format!(
            "{} is not a parameter of PixelStore; pass a GL_UNPACK_* or GL_PACK_* name",
            name(pname)
        )))
    }

    /// PixelStoref: a number is rounded to the nearest integer, a boolean is false for 0 only.
    pub fn set_f32(&mut self, pname: GLenum, value: f32) -> Outcome {
        let boolean = STORE[..2].iter().any(|row| row.0 == pname || row.1 == pname);
        self.set(pname, if boolean { i32::from(value != 0.0) } else { round(value) })
    }

    /// The value of a parameter for Get; booleans are 0 and 1. `None` for any other name.
    #[must_use]
    pub fn get(&self, pname: GLenum) -> Option<u32> {
        STORE.iter().find_map(|&(unpack, pack, field)| {
            if pname == unpack {
                Some(self.unpack.get(field))
            } else if pname == pack {
                Some(self.pack.get(field))
            } else {
                None
            }
        })
    }
}

fn round(value: f32) -> i32 {
    (f64::from(value) + 0.5).floor() as i32
}

/// What is done to pixels between client memory and GL (table 3.2); part of `GL_PIXEL_MODE_BIT`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelTransfer {
    /// Whether colours and colour indices go through the pixel maps.
    pub map_color: bool,
    /// Whether stencil indices go through `GL_PIXEL_MAP_S_TO_S`.
    pub map_stencil: bool,
    /// Bits by which indices are shifted to the left, to the right if negative.
    pub index_shift: i32,
    /// What is added to indices.
    pub index_offset: i32,
    /// Factors of R, G, B, A.
    pub scale: [f32; 4],
    /// Summands of R, G, B, A.
    pub bias: [f32; 4],
    /// Factor of depths.
    pub depth_scale: f32,
    /// Summand of depths.
    pub depth_bias: f32,
}

impl Default for PixelTransfer {
    fn default() -> Self {
        Self {
            map_color: false,
            map_stencil: false,
            index_shift: 0,
            index_offset: 0,
            scale: [1.0; 4],
            bias: [0.0; 4],
            depth_scale: 1.0,
            depth_bias: 0.0,
        }
    }
}

impl PixelTransfer {
    /// PixelTransferf. An index shift or offset is rounded to the nearest integer.
    pub fn set(&mut self, pname: GLenum, value: f32) -> Outcome {
        match pname {
            GL_MAP_COLOR => self.map_color = value != 0.0,
            GL_MAP_STENCIL => self.map_stencil = value != 0.0,
            GL_INDEX_SHIFT => self.index_shift = round(value),
            GL_INDEX_OFFSET => self.index_offset = round(value),
            GL_RED_SCALE => self.scale[0] = value,
            GL_GREEN_SCALE => self.scale[1] = value,
            GL_BLUE_SCALE => self.scale[2] = value,
            GL_ALPHA_SCALE => self.scale[3] = value,
            GL_RED_BIAS => self.bias[0] = value,
            GL_GREEN_BIAS => self.bias[1] = value,
            GL_BLUE_BIAS => self.bias[2] = value,
            GL_ALPHA_BIAS => self.bias[3] = value,
            GL_DEPTH_SCALE => self.depth_scale = value,
            GL_DEPTH_BIAS => self.depth_bias = value,
            _ => {
                return Err(invalid_enum(format!(
                    "{} is not a parameter of PixelTransfer; pass a scale, a bias, GL_MAP_COLOR, GL_MAP_STENCIL, \
                     GL_INDEX_SHIFT or GL_INDEX_OFFSET",
                    name(pname)
                )));
            }
        }
        Ok(())
    }

    /// PixelTransferi: like [`PixelTransfer::set`], exact for large index offsets.
    pub fn set_i32(&mut self, pname: GLenum, value: i32) -> Outcome {
        match pname {
            GL_INDEX_SHIFT => self.index_shift = value,
            GL_INDEX_OFFSET => self.index_offset = value,
            _ => return self.set(pname, value as f32),
        }
        Ok(())
    }

    /// The value of a parameter for Get; booleans are 0 and 1. `None` for any other name.
    #[must_use]
    pub fn get(&self, pname: GLenum) -> Option<f64> {
        Some(match pname {
            GL_MAP_COLOR => f64::from(u8::from(self.map_color)),
            GL_MAP_STENCIL => f64::from(u8::from(self.map_stencil)),
            GL_INDEX_SHIFT => self.index_shift.into(),
            GL_INDEX_OFFSET => self.index_offset.into(),
            GL_RED_SCALE => self.scale[0].into(),
            GL_GREEN_SCALE => self.scale[1].into(),
            GL_BLUE_SCALE => self.scale[2].into(),
            GL_ALPHA_SCALE => self.scale[3].into(),
            GL_RED_BIAS => self.bias[0].into(),
            GL_GREEN_BIAS => self.bias[1].into(),
            GL_BLUE_BIAS => self.bias[2].into(),
            GL_ALPHA_BIAS => self.bias[3].into(),
            GL_DEPTH_SCALE => self.depth_scale.into(),
            GL_DEPTH_BIAS => self.depth_bias.into(),
            _ => return None,
        })
    }
}

/// The pixel group of the state (`GL_PIXEL_MODE_BIT`) but for the maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Scale, bias, shift, offset, map switches.
    pub transfer: PixelTransfer,
    /// ZOOM_X and ZOOM_Y of DrawPixels and CopyPixels.
    pub zoom: [f32; 2],
    /// Which colour buffer is read.
    pub read_buffer: ColorBufferName,
    /// The imaging subset.
    pub imaging: Imaging,
}

impl Default for Pixel {
    fn default() -> Self {
        Self {
            transfer: PixelTransfer::default(),
            zoom: [1.0; 2],
            read_buffer: ColorBufferName::Front,
            imaging: Imaging::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::pixel_maps::{PIXEL_MAPS, PixelMaps};

    #[test]
    fn initial_values_are_those_of_the_tables() {
        let stores = PixelStores::default();
        assert_eq!(stores.get(GL_UNPACK_ALIGNMENT), Some(4));
        assert_eq!(stores.get(GL_PACK_ALIGNMENT), Some(4));
        for (unpack, pack, _) in &STORE[..7] {
            assert_eq!((stores.get(*unpack), stores.get(*pack)), (Some(0), Some(0)));
        }
        let transfer = PixelTransfer::default();
        assert_eq!(transfer.get(GL_BLUE_SCALE), Some(1.0));
        assert_eq!(transfer.get(GL_DEPTH_SCALE), Some(1.0));
        assert_eq!(transfer.get(GL_DEPTH_BIAS), Some(0.0));
        let maps = PixelMaps::default();
        for (map, size) in PIXEL_MAPS {
            assert_eq!(maps.get(map).unwrap(), [0.0]);
            assert_eq!(maps.size(size), Some(1));
        }
    }

    #[test]
    fn bad_values_change_nothing() {
        let mut stores = PixelStores::default();
        for (pname, value, code) in [
            (GL_UNPACK_ALIGNMENT, 3, GL_INVALID_VALUE),
            (GL_PACK_ROW_LENGTH, -1, GL_INVALID_VALUE),
            (GL_UNPACK_SKIP_IMAGES, i32::MIN, GL_INVALID_VALUE),
            (GL_ZOOM_X, 1, GL_INVALID_ENUM),
        ] {
            assert_eq!(stores.set(pname, value).unwrap_err().code, code);
        }
        assert_eq!(stores, PixelStores::default());
        let mut maps = PixelMaps::default();
        assert_eq!(maps.set(GL_PIXEL_MAP_I_TO_R, &[0.0; 3]).unwrap_err().code, GL_INVALID_VALUE);
        assert_eq!(maps.set(GL_PIXEL_MAP_R_TO_R, &[0.0; 257]).unwrap_err().code, GL_INVALID_VALUE);
        assert_eq!(maps.set(GL_PIXEL_MAP_R_TO_R, &[]).unwrap_err().code, GL_INVALID_VALUE);
        assert_eq!(maps.set(GL_RED, &[0.0]).unwrap_err().code, GL_INVALID_ENUM);
        assert_eq!(maps, PixelMaps::default());
    }

    #[test]
    fn floats_are_rounded_and_booleans_tested() {
        let mut stores = PixelStores::default();
        stores.set_f32(GL_UNPACK_ROW_LENGTH, 6.5).unwrap();
        stores.set_f32(GL_PACK_SWAP_BYTES, 0.25).unwrap();
        assert_eq!((stores.unpack.row_length, stores.pack.swap_bytes), (7, true));
        assert_eq!(stores.set_f32(GL_UNPACK_ROW_LENGTH, f32::NAN), Ok(()));
        assert_eq!(stores.unpack.row_length, 0);
        let mut transfer = PixelTransfer::default();
        transfer.set_i32(GL_INDEX_OFFSET, 16_777_217).unwrap();
        assert_eq!(transfer.get(GL_INDEX_OFFSET), Some(16_777_217.0));
    }
}
