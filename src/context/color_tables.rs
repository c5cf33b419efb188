//! Colour tables (OpenGL 1.5, sections 3.6.3 and 6.1.7): specification from client memory or the framebuffer, parts of
//! them, proxies, parameters, queries.

use super::engine::Engine;
use super::imaging_tables::{Entries, color_format};
use super::{Params, Pixels, Values};
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_value, known, not_one};
use crate::num::clamp01;
use crate::pixels::{ClientImage, ClientTarget, PixelFormat, PixelKind, Purpose, Transfer};
use crate::state::imaging::{ScaleBias, TableTarget};
use crate::state::pixel::PixelStore;
use crate::texture::format::InternalFormat;

/// The greatest width of a colour table and of a histogram.
pub(crate) const MAX_TABLE_WIDTH: usize = 1 << 16;

fn table_target(target: GLenum) -> Outcome<TableTarget> {
    known(TableTarget::from_gl(target), target, "a colour table such as GL_COLOR_TABLE")
}

/// The table that a proxy asks about.
fn proxy_target(target: GLenum) -> Option<TableTarget> {
    match target {
        GL_PROXY_COLOR_TABLE => Some(TableTarget::Color),
        GL_PROXY_POST_CONVOLUTION_COLOR_TABLE => Some(TableTarget::PostConvolution),
        GL_PROXY_POST_COLOR_MATRIX_COLOR_TABLE => Some(TableTarget::PostColorMatrix),
        _ => None,
    }
}

/// TABLE_TOO_LARGE.
pub(crate) fn too_large(width: usize) -> GlError {
    GlError { code: GL_TABLE_TOO_LARGE, message: format!("a width of {width}; the greatest is {MAX_TABLE_WIDTH}") }
}

/// A width that is 0 or a power of two.
pub(crate) fn power_of_two(width: i32) -> Outcome<usize> {
    usize::try_from(width)
        .ok()
        .filter(|width| *width == 0 || width.is_power_of_two())
        .ok_or_else(|| invalid_value(format!("a width of {width}; it must be 0 or a power of two")))
}

/// The pair of a command that takes colours, without colour indices where `indices` is not set.
pub(crate) fn color_pixels(format: GLenum, type_: GLenum) -> Outcome<PixelFormat> {
    let pixel = PixelFormat::for_command(format, type_, Purpose::TexImage)?;
    match pixel.kind() {
        PixelKind::Color | PixelKind::Index => Ok(pixel),
        PixelKind::Depth | PixelKind::Stencil | PixelKind::DepthStencil => Err(not_one(format, "a format of colours")),
    }
}

/// The pixels of a command, row by row, expanded to R, G, B, A and nothing else.
pub(crate) fn expanded(
    pixels: &Pixels<'_>,
    store: &PixelStore,
    [width, height]: [i32; 2],
    pixel: PixelFormat,
) -> Outcome<Vec<[f32; 4]>> {
    let store = if pixels.is_tight() { &PixelStore::TIGHT } else { store };
    let image = ClientImage::new_2d(pixels.bytes().unwrap_or(&[]), store, [width, height], pixel)?;
    let [width, height, _] = image.size();
    let mut colors = crate::pixels::zoom::zeroed::<[f32; 4]>(width * height)?;
    for (y, row) in colors.chunks_exact_mut(width.max(1)).enumerate() {
        if pixel.kind() == PixelKind::Index {
            image.colors([0, y, 0], Transfer::NEUTRAL, row);
        } else {
            image.components([0, y, 0], row);
        }
    }
    Ok(colors)
}

/// Colours as entries of a table: scaled, biased, limited, of the format's components and precision.
fn table_entries(colors: &[[f32; 4]], by: &ScaleBias, format: &InternalFormat) -> Vec<[f32; 4]> {
    let entry = |color: &[f32; 4]| format.base.expand(format.round(by.apply(*color).map(clamp01)));
    colors.iter().map(entry).collect()
}

/// Bits of a format's red, green, blue, alpha, luminance and intensity, in the order of the names of a query.
pub(crate) fn component_bits(format: &InternalFormat) -> [u8; 6] {
    let sizes = format.sizes();
    [sizes.red, sizes.green, sizes.blue, sizes.alpha, sizes.luminance, sizes.intensity]
}

impl Engine {
    pub(crate) fn color_table(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        width: i32,
        format: GLenum,
        type_: GLenum,
        table: &Pixels<'_>,
    ) -> Outcome {
        let proxy = proxy_target(target);
        let target = proxy.map_or_else(|| table_target(target), Ok)?;
        let internal = color_format(internal_format)?;
        let pixel = color_pixels(format, type_)?;
        let size = power_of_two(width)?;
        if proxy.is_some() {
            let fits = size <= MAX_TABLE_WIDTH;
            self.imaging.table_proxies[target as usize] = if fits {
                Entries { format: internal, size: [size, 1], colors: Vec::new() }
            } else {
                Entries::default()
            };
            return Ok(());
        }
        if size > MAX_TABLE_WIDTH {
            return Err(too_large(size));
        }
        let colors = expanded(table, &self.client.pixel_store.unpack, [width, 1], pixel)?;
        self.put_table(target, internal, &colors);
        Ok(())
    }

    fn put_table(&mut self, target: TableTarget, format: &'static InternalFormat, colors: &[[f32; 4]]) {
        let by = &self.state.pixel.imaging.table_scale[target as usize];
        let colors = table_entries(colors, by, format);
        self.imaging.tables[target as usize] = Entries { format, size: [colors.len(), 1], colors };
    }

    pub(crate) fn color_sub_table(
        &mut self,
        target: GLenum,
        start: i32,
        count: i32,
        format: GLenum,
        type_: GLenum,
        data: &Pixels<'_>,
    ) -> Outcome {
        let target = table_target(target)?;
        let pixel = color_pixels(format, type_)?;
        self.check_sub_table(target, start, count)?;
        let colors = expanded(data, &self.client.pixel_store.unpack, [count, 1], pixel)?;
        self.put_sub_table(target, start, &colors);
        Ok(())
    }

    fn check_sub_table(&self, target: TableTarget, start: i32, count: i32) -> Outcome {
        let width = self.imaging.tables[target as usize].colors.len();
        let inside = start >= 0 && count >= 0 && i64::from(start) + i64::from(count) <= width as i64;
        if inside {
            Ok(())
        } else {
            Err(invalid_value(format!("{count} entries from {start} on of a table of {width}")))
        }
    }

    fn put_sub_table(&mut self, target: TableTarget, start: i32, colors: &[[f32; 4]]) {
        let by = &self.state.pixel.imaging.table_scale[target as usize];
        let table = &mut self.imaging.tables[target as usize];
        let entries = table_entries(colors, by, table.format);
        for (to, from) in table.colors.iter_mut().skip(start.unsigned_abs() as usize).zip(entries) {
            *to = from;
        }
    }

    pub(crate) fn copy_color_table(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
    ) -> Outcome {
        let (target, internal) = (table_target(target)?, color_format(internal_format)?);
        let size = power_of_two(width)?;
        if size > MAX_TABLE_WIDTH {
            return Err(too_large(size));
        }
        self.flush_scene();
        let mut colors = crate::pixels::zoom::zeroed(size)?;
        self.framebuffer.read_float(x, y, &mut colors);
        self.put_table(target, internal, &colors);
        Ok(())
    }

    pub(crate) fn copy_color_sub_table(&mut self, target: GLenum, start: i32, x: i32, y: i32, width: i32) -> Outcome {
        let target = table_target(target)?;
        self.check_sub_table(target, start, width)?;
        self.flush_scene();
        let mut colors = crate::pixels::zoom::zeroed(width.unsigned_abs() as usize)?;
        self.framebuffer.read_float(x, y, &mut colors);
        self.put_sub_table(target, start, &colors);
        Ok(())
    }

    pub(crate) fn color_table_parameter(&mut self, target: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let target = table_target(target)?;
        let by = &mut self.state.pixel.imaging.table_scale[target as usize];
        match pname {
            GL_COLOR_TABLE_SCALE => by.scale = params.numbers()?,
            GL_COLOR_TABLE_BIAS => by.bias = params.numbers()?,
            _ => return Err(not_one(pname, "GL_COLOR_TABLE_SCALE or GL_COLOR_TABLE_BIAS")),
        }
        Ok(())
    }

    pub(crate) fn get_color_table_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        let entries = match proxy_target(target) {
            Some(proxy) => &self.imaging.table_proxies[proxy as usize],
            None => &self.imaging.tables[table_target(target)? as usize],
        };
        let bits = component_bits(entries.format);
        let size = |i: usize| Values::int(if entries.size[0] == 0 { 0 } else { i32::from(bits[i]) });
        let by = |target: TableTarget| self.state.pixel.imaging.table_scale[target as usize];
        Ok(match pname {
            GL_COLOR_TABLE_SCALE => Values::floats(&by(table_target(target)?).scale),
            GL_COLOR_TABLE_BIAS => Values::floats(&by(table_target(target)?).bias),
            GL_COLOR_TABLE_FORMAT => Values::enumerant(entries.format.requested),
            GL_COLOR_TABLE_WIDTH => Values::int(entries.size[0] as i32),
            GL_COLOR_TABLE_RED_SIZE => size(0),
            GL_COLOR_TABLE_GREEN_SIZE => size(1),
            GL_COLOR_TABLE_BLUE_SIZE => size(2),
            GL_COLOR_TABLE_ALPHA_SIZE => size(3),
            GL_COLOR_TABLE_LUMINANCE_SIZE => size(4),
            GL_COLOR_TABLE_INTENSITY_SIZE => size(5),
            _ => return Err(not_one(pname, "a parameter of a colour table")),
        })
    }

    pub(crate) fn get_color_table(&mut self, target: GLenum, format: GLenum, type_: GLenum, out: &mut [u8]) -> Outcome {
        let target = table_target(target)?;
        let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        self.pack_colors(self.imaging.tables[target as usize].queried(), 1, pixel, out)
    }

    /// Writes rows of colours under the pack state, without pixel transfer.
    pub(crate) fn pack_colors(
        &self,
        colors: Vec<[f32; 4]>,
        height: usize,
        pixel: PixelFormat,
        out: &mut [u8],
    ) -> Outcome {
        let width = colors.len() / height.max(1);
        let size = [width, height].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        let mut target = ClientTarget::new_2d(out, &self.client.pixel_store.pack, size, pixel)?;
        for (y, row) in colors.chunks_exact(width.max(1)).enumerate() {
            target.values([0, y, 0], row);
        }
        Ok(())
    }
}
