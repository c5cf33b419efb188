//! Commands of pixel storage and transfer (OpenGL 1.5, sections 3.6.1 to 3.6.3), the polygon stipple, and what the doors
//! ask about the size of images in client memory.

use super::engine::Engine;
use super::{Params, Pixels, Values};
use crate::enums::*;
use crate::error::{Outcome, invalid_value, too_short};
use crate::pixels::{ClientImage, ClientTarget, PixelFormat, Transfer};
use crate::state::pixel::PixelStore;
use crate::state::pixel_maps::PixelMaps;
use crate::state::raster::HintMode;
use crate::texture::format::BlockFit;

impl Engine {
    pub(crate) fn pixel_storei(&mut self, pname: GLenum, param: i32) -> Outcome {
        self.client.pixel_store.set(pname, param)
    }

    pub(crate) fn pixel_storef(&mut self, pname: GLenum, param: f32) -> Outcome {
        self.client.pixel_store.set_f32(pname, param)
    }

    pub(crate) fn pixel_transfer(&mut self, pname: GLenum, params: &Params) -> Outcome {
        if let Some(parameter) = self.state.pixel.imaging.parameter(pname) {
            *parameter = params.scalar()?;
            return Ok(());
        }
        let transfer = &mut self.state.pixel.transfer;
        if params.is_int() { transfer.set_i32(pname, params.integer()?) } else { transfer.set(pname, params.scalar()?) }
    }

    pub(crate) fn pixel_map(&mut self, map: GLenum, size: i32, values: &[f32]) -> Outcome {
        let entries = PixelMaps::check(map, size)?;
        let values = values.get(..entries).ok_or_else(|| too_short("values", entries, values.len(), "values"))?;
        self.state.pixel_maps.set(map, values)
    }

    pub(crate) fn get_pixel_map(&mut self, map: GLenum) -> Outcome<Values> {
        let values = self.state.pixel_maps.get(map)?;
        let index = matches!(map, GL_PIXEL_MAP_I_TO_I | GL_PIXEL_MAP_S_TO_S);
        Ok(if index { Values::floats(values) } else { Values::unit(values) })
    }

    pub(crate) fn pixel_zoom(&mut self, x: f32, y: f32) {
        self.state.pixel.zoom = [x, y];
    }

    /// Pixel transfer values and map sizes, for Get.
    pub(crate) fn pixel_value(&self, pname: GLenum) -> Option<Values> {
        if let Some(size) = self.state.pixel_maps.size(pname) {
            return Some(Values::int(size as i32));
        }
        let mut imaging = self.state.pixel.imaging;
        if let Some(parameter) = imaging.parameter(pname) {
            return Some(Values::float(*parameter));
        }
        let value = self.state.pixel.transfer.get(pname)?;
        Some(match pname {
            GL_MAP_COLOR | GL_MAP_STENCIL => Values::boolean(value != 0.0),
            GL_INDEX_SHIFT | GL_INDEX_OFFSET => Values::int(value as i32),
            _ => Values::doubles(&[value]),
        })
    }

    pub(crate) fn polygon_stipple(&mut self, mask: &Pixels<'_>) -> Outcome {
        let Some(bytes) = mask.bytes() else {
            return Err(invalid_value("a polygon stipple needs a pattern of 32 by 32 bits"));
        };
        let pixel = PixelFormat::new(GL_COLOR_INDEX, GL_BITMAP)?;
        let image = ClientImage::new_2d(bytes, &self.client.pixel_store.unpack, [32, 32], pixel)?;
        let row = |y: usize| (0..32).fold(0, |row, x| (row << 1) | u32::from(image.bit([x, y, 0])));
        self.set_polygon_stipple(std::array::from_fn(row));
        Ok(())
    }

    pub(crate) fn get_polygon_stipple(&mut self, mask: &mut [u8]) -> Outcome {
        let pixel = PixelFormat::new(GL_COLOR_INDEX, GL_BITMAP)?;
        let mut target = ClientTarget::new_2d(mask, &self.client.pixel_store.pack, [32, 32], pixel)?;
        for (y, row) in self.state.polygon_stipple.0.iter().enumerate() {
            let bits: [u32; 32] = std::array::from_fn(|x| (row >> (31 - x)) & 1);
            target.raw_indices([0, y, 0], &bits);
        }
        Ok(())
    }

    /// The transfer state for colours, depths and indices on their way.
    pub(crate) fn transfer(&self) -> Transfer<'_> {
        Transfer { mode: &self.state.pixel.transfer, maps: &self.state.pixel_maps }
    }

    /// How the blocks of compressed images are chosen from here on.
    pub(crate) fn fit(&self) -> BlockFit {
        match self.state.hint.texture_compression {
            HintMode::Nicest => BlockFit::LeastSquares,
            HintMode::DontCare | HintMode::Fastest => BlockFit::Extremes,
        }
    }

    /// How client memory is laid out for commands that read images.
    pub(crate) fn unpack_store(&self) -> PixelStore {
        self.client.pixel_store.unpack
    }

    /// How client memory is laid out for commands that write images.
    pub(crate) fn pack_store(&self) -> PixelStore {
        self.client.pixel_store.pack
    }

    /// Sets the layout that `unpack_store` tells.
    pub(crate) fn set_unpack_store(&mut self, store: PixelStore) {
        self.client.pixel_store.unpack = store;
    }
}
