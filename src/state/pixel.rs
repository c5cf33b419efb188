//! Pixel state (OpenGL 1.5, sections 3.6.1 to 3.6.3 and 3.6.5, tables 3.1 to 3.3, 6.22 to 6.24): how client memory is
//! laid out (`PixelStore`, client state), what is done to pixels on their way (`PixelTransfer`), the ten pixel maps, and
//! the zoom of DrawPixels. A setter checks its value before it changes anything.

use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_value};
use crate::limits::MAX_PIXEL_MAP_TABLE;
use crate::num::clamp01;

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

/// The names of the ten maps (table 3.3) in the order of the fields of [`PixelMaps`]: the map, its size.
pub const PIXEL_MAPS: [(GLenum, GLenum); 10] = [
    (GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_I_TO_I_SIZE),
    (GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_S_TO_S_SIZE),
    (GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_R_SIZE),
    (GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_G_SIZE),
    (GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_B_SIZE),
    (GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_I_TO_A_SIZE),
    (GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_R_TO_R_SIZE),
    (GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_G_TO_G_SIZE),
    (GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_B_TO_B_SIZE),
    (GL_PIXEL_MAP_A_TO_A, GL_PIXEL_MAP_A_TO_A_SIZE),
];

/// The pixel maps. Each has 1 to MAX_PIXEL_MAP_TABLE entries, at first one entry of 0. Not part of any attribute group.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelMaps {
    /// Indices to indices: I_TO_I.
    pub index_to_index: Vec<f32>,
    /// Stencil indices to stencil indices: S_TO_S.
    pub stencil_to_stencil: Vec<f32>,
    /// Indices to R, G, B, A: I_TO_R and its siblings.
    pub index_to_color: [Vec<f32>; 4],
    /// R, G, B, A to themselves: R_TO_R and its siblings.
    pub color_to_color: [Vec<f32>; 4],
}

impl Default for PixelMaps {
    fn default() -> Self {
        let map = || vec![0.0];
        Self {
            index_to_index: map(),
            stencil_to_stencil: map(),
            index_to_color: std::array::from_fn(|_| map()),
            color_to_color: std::array::from_fn(|_| map()),
        }
    }
}

impl PixelMaps {
    fn table(&self, slot: usize) -> &Vec<f32> {
        match slot {
            0 => &self.index_to_index,
            1 => &self.stencil_to_stencil,
            2..6 => &self.index_to_color[slot - 2],
            _ => &self.color_to_color[(slot - 6) & 3],
        }
    }

    fn table_mut(&mut self, slot: usize) -> &mut Vec<f32> {
        match slot {
            0 => &mut self.index_to_index,
            1 => &mut self.stencil_to_stencil,
            2..6 => &mut self.index_to_color[slot - 2],
            _ => &mut self.color_to_color[(slot - 6) & 3],
        }
    }

    fn slot(map: GLenum) -> Outcome<usize> {
        PIXEL_MAPS.iter().position(|row| row.0 == map).ok_or_else(|| {
            invalid_enum(format!("{} is not a pixel map; pass a name such as GL_PIXEL_MAP_R_TO_R", name(map)))
        })
    }

    /// Whether a map yields indices (kept as numbers) rather than colours (kept in [0, 1]).
    fn yields_indices(slot: usize) -> bool {
        slot < 2
    }

    /// PixelMapfv: entries of a colour map are clamped to [0, 1]; a map that is looked up by an index must have 2^n of them.
    pub fn set(&mut self, map: GLenum, values: &[f32]) -> Outcome {
        let slot = Self::slot(map)?;
        if values.is_empty() || values.len() > MAX_PIXEL_MAP_TABLE {
            return Err(invalid_value(format!("{} entries; a map has 1 to {MAX_PIXEL_MAP_TABLE}", values.len())));
        }
        if slot < 6 && !values.len().is_power_of_two() {
            return Err(invalid_value(format!(
                "{} entries for {}; a map of indices has a power of two of them",
                values.len(),
                name(map)
            )));
        }
        let limit = |v: f32| if Self::yields_indices(slot) { v } else { clamp01(v) };
        *self.table_mut(slot) = values.iter().map(|&v| limit(v)).collect();
        Ok(())
    }

    /// PixelMapuiv, and PixelMapusv with `max` 65535: entries of a colour map are divided by `max`.
    pub fn set_unsigned(&mut self, map: GLenum, max: u32, values: impl ExactSizeIterator<Item = u32>) -> Outcome {
        let slot = Self::slot(map)?;
        let scale = if Self::yields_indices(slot) { 1.0 } else { f64::from(max.max(1)) };
        let values: Vec<f32> = values.take(MAX_PIXEL_MAP_TABLE + 1).map(|v| (f64::from(v) / scale) as f32).collect();
        self.set(map, &values)
    }

    /// The entries of a map, for GetPixelMapfv.
    pub fn get(&self, map: GLenum) -> Outcome<&[f32]> {
        Ok(self.table(Self::slot(map)?))
    }

    /// The entries of a map as unsigned integers, for GetPixelMapuiv and (with `max` 65535) GetPixelMapusv.
    pub fn get_unsigned(&self, map: GLenum, max: u32) -> Outcome<impl Iterator<Item = u32>> {
        let slot = Self::slot(map)?;
        let scale = if Self::yields_indices(slot) { 1.0 } else { f64::from(max) };
        Ok(self
            .table(slot)
            .iter()
            .map(move |&v| (f64::from(v) * scale + 0.5).floor().clamp(0.0, f64::from(max)) as u32))
    }

    /// How many entries the map has whose `GL_PIXEL_MAP_*_SIZE` is `pname`; `None` for any other name.
    #[must_use]
    pub fn size(&self, pname: GLenum) -> Option<usize> {
        PIXEL_MAPS.iter().position(|row| row.1 == pname).map(|slot| self.table(slot).len())
    }
}

/// The pixel group of the state (`GL_PIXEL_MODE_BIT`) but for the maps.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixel {
    /// Scale, bias, shift, offset, map switches.
    pub transfer: PixelTransfer,
    /// ZOOM_X and ZOOM_Y of DrawPixels and CopyPixels.
    pub zoom: [f32; 2],
    /// Which colour buffer is read.
    pub read_buffer: GLenum,
}

impl Default for Pixel {
    fn default() -> Self {
        Self { transfer: PixelTransfer::default(), zoom: [1.0; 2], read_buffer: GL_FRONT }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn map_entries_convert_and_clamp() {
        let mut maps = PixelMaps::default();
        maps.set(GL_PIXEL_MAP_A_TO_A, &[-1.0, 0.5, 7.0, f32::NAN]).unwrap();
        assert_eq!(maps.color_to_color[3], [0.0, 0.5, 1.0, 0.0]);
        maps.set_unsigned(GL_PIXEL_MAP_I_TO_G, 65535, [0, 65535].into_iter()).unwrap();
        assert_eq!(maps.index_to_color[1], [0.0, 1.0]);
        maps.set_unsigned(GL_PIXEL_MAP_S_TO_S, 65535, [3, 9].into_iter()).unwrap();
        assert_eq!(maps.stencil_to_stencil, [3.0, 9.0]);
        assert_eq!(maps.get_unsigned(GL_PIXEL_MAP_S_TO_S, u32::MAX).unwrap().collect::<Vec<_>>(), [3, 9]);
        assert_eq!(maps.get_unsigned(GL_PIXEL_MAP_I_TO_G, u32::MAX).unwrap().collect::<Vec<_>>(), [0, u32::MAX]);
    }
}
