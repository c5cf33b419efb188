//! Parts of texture images and copies from the framebuffer (OpenGL 1.5, sections 3.8.2 and 3.8.3). A draw that was issued
//! before keeps the texels it was issued with: an image that somebody else still holds is copied before it is written.

use super::Pixels;
use super::engine::Engine;
use super::param_counts;
use super::tex_image::{Place, Request, client_image, dimensions_of, place};
use super::textures::not_negative;
use crate::enums::*;
use crate::error::{Outcome, invalid_operation, invalid_value, too_short};
use crate::pixels::imaging::ColorImage;
use crate::pixels::{PixelFormat, Purpose, Transfer};
use crate::texture::format::{BaseFormat, InternalFormat};
use crate::texture::image::Image;
use crate::texture::upload::check_formats;
use std::sync::Arc;

impl Engine {
    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_sub_image_1d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        width: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        self.tex_sub_image(place(target, 1)?, level, [x, 0, 0], [width, 1, 1], (format, type_), pixels)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_sub_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        self.tex_sub_image(place(target, 2)?, level, [x, y, 0], [width, height, 1], (format, type_), pixels)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_sub_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        y: i32,
        z: i32,
        width: i32,
        height: i32,
        depth: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        self.tex_sub_image(place(target, 3)?, level, [x, y, z], [width, height, depth], (format, type_), pixels)
    }

    fn tex_sub_image(
        &mut self,
        place: Place,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
        (format, type_): (GLenum, GLenum),
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let place = not_proxy(place)?;
        let pixel = PixelFormat::for_command(format, type_, Purpose::TexImage)?;
        if let Some(image) = self.imaged_pixels(place.target, size, pixel, pixels)? {
            let Some(image) = self.transfer_image(image, dimensions_of(place.target).count())? else { return Ok(()) };
            let size = image.size_3d(size[2]);
            return self.with_transferred(&image, |engine, pair, pixels| {
                engine.tex_sub_image(place, level, offset, size, pair, pixels)
            });
        }
        let (level, image) = self.existing_image(place, level)?;
        check_formats(pixel, image.format)?;
        image.check_region(offset, size)?;
        image.check_block_region(offset, size)?;
        let store = self.client.pixel_store.unpack;
        let Some(client) = client_image(pixels, &store, dimensions_of(place.target), size, pixel)? else {
            return Ok(());
        };
        drop(image);
        self.write_image(place, level, |image, transfer| image.upload(offset, &client, transfer))
    }

    /// Lets `write` change an image in place, under the state of pixel transfer.
    fn write_image(
        &mut self,
        place: Place,
        level: usize,
        write: impl FnOnce(&mut Image, Transfer<'_>) -> Outcome,
    ) -> Outcome {
        self.free_image(place, level);
        let bound = self.bound_name(place.target);
        let object = self.textures.object_mut(place.target, bound);
        if let Some(Some(image)) = object.faces.get_mut(place.face).and_then(|levels| levels.get_mut(level)) {
            let transfer = Transfer { mode: &self.state.pixel.transfer, maps: &self.state.pixel_maps };
            write(Image::writable(image)?, transfer)?;
        }
        self.after_image_change(place, level)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn copy_tex_image_1d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
        border: i32,
    ) -> Outcome {
        self.copy_tex_image(place(target, 1)?, level, internal_format, [x, y], [width, 1, 1], border)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn copy_tex_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        border: i32,
    ) -> Outcome {
        self.copy_tex_image(place(target, 2)?, level, internal_format, [x, y], [width, height, 1], border)
    }

    fn copy_tex_image(
        &mut self,
        place: Place,
        level: i32,
        internal_format: GLenum,
        from: [i32; 2],
        size: [i32; 3],
        border: i32,
    ) -> Outcome {
        let place = not_proxy(place)?;
        let format = InternalFormat::of_copy_tex_image(internal_format)?;
        self.check_source(format)?;
        if format.base != BaseFormat::Depth && self.uses_imaging() {
            let Some(image) = self.copied(place, from, [size[0], size[1]])? else { return Ok(()) };
            let size = image.size_3d(1);
            return self.with_transferred(&image, |engine, pair, pixels| {
                engine.tex_image(place, level, internal_format.cast_signed(), size, border, pair, pixels)
            });
        }
        let Some(level) = self.admit(&Request { place, level, size, border, format })? else { return Ok(()) };
        let border = border.unsigned_abs();
        let interior = size.map(|n| n.unsigned_abs().saturating_sub(2 * border));
        let mut image = Image::new(format, dimensions_of(place.target), interior, border)?;
        image.fit = self.fit();
        let first = image.first();
        self.flush_scene();
        self.copy_rows(&mut image, first, from, [size[0], size[1]])?;
        self.put_image(place, level, Arc::new(image))
    }

    pub(crate) fn copy_tex_sub_image_1d(
        &mut self,
        target: GLenum,
        level: i32,
        xoffset: i32,
        x: i32,
        y: i32,
        width: i32,
    ) -> Outcome {
        self.copy_tex_sub_image(place(target, 1)?, level, [xoffset, 0, 0], [x, y], [width, 1])
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn copy_tex_sub_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        xoffset: i32,
        yoffset: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
    ) -> Outcome {
        self.copy_tex_sub_image(place(target, 2)?, level, [xoffset, yoffset, 0], [x, y], [width, height])
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn copy_tex_sub_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        xoffset: i32,
        yoffset: i32,
        zoffset: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
    ) -> Outcome {
        self.copy_tex_sub_image(place(target, 3)?, level, [xoffset, yoffset, zoffset], [x, y], [width, height])
    }

    fn copy_tex_sub_image(
        &mut self,
        place: Place,
        level: i32,
        offset: [i32; 3],
        from: [i32; 2],
        size: [i32; 2],
    ) -> Outcome {
        let place = not_proxy(place)?;
        let (level, image) = self.existing_image(place, level)?;
        self.check_source(image.format)?;
        if image.base != BaseFormat::Depth && self.uses_imaging() {
            drop(image);
            let Some(image) = self.copied(place, from, size)? else { return Ok(()) };
            let size = image.size_3d(1);
            return self.with_transferred(&image, |engine, pair, pixels| {
                engine.tex_sub_image(place, level as i32, offset, size, pair, pixels)
            });
        }
        let region = [size[0], size[1], 1];
        image.check_region(offset, region)?;
        image.check_block_region(offset, region)?;
        drop(image);
        self.pixels_written += region.iter().map(|n| u64::from(n.unsigned_abs())).product::<u64>();
        self.flush_scene();
        self.release_draws();
        // The image is taken out while rows of the framebuffer, which the engine owns too, are written into it.
        let bound = self.bound_name(place.target);
        let slot = |engine: &mut Self| {
            let object = engine.textures.object_mut(place.target, bound);
            object.faces.get_mut(place.face).and_then(|levels| levels.get_mut(level)).and_then(Option::take)
        };
        let Some(mut image) = slot(self) else { return Ok(()) };
        let written = Image::writable(&mut image).and_then(|image| self.copy_rows(image, offset, from, size));
        let object = self.textures.object_mut(place.target, bound);
        object.faces[place.face][level] = Some(image);
        written?;
        self.after_image_change(place, level)
    }

    /// Colours of the framebuffer that the imaging subset changes, perhaps with their number.
    fn copied(&mut self, place: Place, from: [i32; 2], size: [i32; 2]) -> Outcome<Option<ColorImage>> {
        if size[0] < 0 || size[1] < 0 {
            return Err(invalid_value(format!("an area of {} by {}; neither may be negative", size[0], size[1])));
        }
        self.flush_scene();
        let image = self.read_colors(from, size.map(|n| n.unsigned_abs() as usize))?;
        self.transfer_image(image, dimensions_of(place.target).count().min(2))
    }

    /// A depth texture is copied from the depth buffer, any other from the colour buffer.
    fn check_source(&self, format: &InternalFormat) -> Outcome {
        let bits = self.framebuffer.format();
        let missing = match format.base {
            BaseFormat::Depth if bits.depth_bits == 0 => "depth",
            BaseFormat::Depth if format.stencil_bits > 0 && bits.stencil_bits == 0 => "stencil",
            _ => return Ok(()),
        };
        Err(invalid_operation(format!("the texture cannot be copied: the framebuffer has no {missing} buffer")))
    }

    /// Rows of the framebuffer from `from` into an image at `to`. What lies outside the framebuffer is undefined by the
    /// specification and becomes zero here.
    fn copy_rows(&self, image: &mut Image, to: [i32; 3], from: [i32; 2], size: [i32; 2]) -> Outcome {
        let transfer = self.transfer();
        let count = size[0].max(0) as usize;
        let (mut depths, mut depths32, mut stencils) = (vec![0.0; count], vec![0.0; count], vec![0; count]);
        let (mut texels, mut floats) = (vec![0; count], vec![[0.0; 4]; count]);
        for row in 0..size[1].max(0) {
            let at = [to[0], to[1] + row, to[2]];
            let y = from[1].saturating_add(row);
            if image.base == BaseFormat::Depth {
                self.framebuffer.read_depth(from[0], y, &mut depths);
                depths32.iter_mut().zip(&depths).for_each(|(to, from)| *to = *from as f32);
                image.write_depths(at, &mut depths32, transfer);
                if image.stencil.is_some() {
                    self.framebuffer.read_stencil(from[0], y, &mut stencils);
                    image.write_stencils(at, &stencils, transfer);
                }
            } else if self.framebuffer.format().float {
                self.framebuffer.read_float(from[0], y, &mut floats);
                image.write_colors(at, &mut floats, transfer);
            } else {
                self.framebuffer.read_rgba8(from[0], y, &mut texels);
                image.write_rgba8(at, &texels, transfer);
            }
        }
        image.recompress(to, [size[0], size[1], 1])
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        width: i32,
        height: i32,
        border: i32,
        image_size: i32,
        data: &Pixels<'_>,
    ) -> Outcome {
        let place = place(target, 2)?;
        let format = InternalFormat::of_compressed_tex_image(internal_format)?;
        // EXT_texture_compression_s3tc; any other border is no border at all and is refused with the rest of the request.
        if border == 1 {
            return Err(invalid_operation("a border of 1; S3TC images have none"));
        }
        not_negative("the image size", image_size)?;
        let request = Request { place, level, size: [width, height, 1], border, format };
        let Some(level) = self.admit(&request)? else { return Ok(()) };
        let size = [width.unsigned_abs(), height.unsigned_abs()];
        check_image_size(format, size, image_size)?;
        let image = Image::from_blocks(format, size, blocks_of(data, image_size)?)?;
        self.put_image(place, level, Arc::new(image))
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_sub_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        format: GLenum,
        image_size: i32,
        data: &Pixels<'_>,
    ) -> Outcome {
        let place = not_proxy(place(target, 2)?)?;
        let given = InternalFormat::of_compressed_tex_image(format)?;
        let (level, image) = self.existing_image(place, level)?;
        if image.format.requested != given.requested {
            return Err(invalid_operation(format!(
                "blocks of {} for an image of {}; they must be of the same format",
                name(format),
                name(image.internal_format)
            )));
        }
        let (offset, size) = ([x, y, 0], [width, height, 1]);
        image.check_region(offset, size)?;
        image.check_block_region(offset, size)?;
        drop(image);
        check_image_size(given, [width.unsigned_abs(), height.unsigned_abs()], image_size)?;
        let blocks = blocks_of(data, image_size)?;
        self.write_image(place, level, |image, _| image.write_blocks(offset, size, blocks))
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_image_1d(
        &mut self,
        target: GLenum,
        _level: i32,
        internal_format: GLenum,
        _width: i32,
        _border: i32,
        _image_size: i32,
        _data: &Pixels<'_>,
    ) -> Outcome {
        no_blocks(target, 1, internal_format)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_image_3d(
        &mut self,
        target: GLenum,
        _level: i32,
        internal_format: GLenum,
        _width: i32,
        _height: i32,
        _depth: i32,
        _border: i32,
        _image_size: i32,
        _data: &Pixels<'_>,
    ) -> Outcome {
        no_blocks(target, 3, internal_format)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_sub_image_1d(
        &mut self,
        target: GLenum,
        _level: i32,
        _x: i32,
        _width: i32,
        format: GLenum,
        _image_size: i32,
        _data: &Pixels<'_>,
    ) -> Outcome {
        no_blocks(target, 1, format)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn compressed_tex_sub_image_3d(
        &mut self,
        target: GLenum,
        _level: i32,
        _x: i32,
        _y: i32,
        _z: i32,
        _width: i32,
        _height: i32,
        _depth: i32,
        format: GLenum,
        _image_size: i32,
        _data: &Pixels<'_>,
    ) -> Outcome {
        no_blocks(target, 3, format)
    }
}

/// S3TC has images of two dimensions only.
fn no_blocks(target: GLenum, dimensions: usize, format: GLenum) -> Outcome {
    place(target, dimensions)?;
    let format = InternalFormat::of_compressed_tex_image(format)?;
    Err(crate::error::invalid_enum(format!(
        "{} is a format of two-dimensional images; there are no compressed images of {dimensions} dimensions",
        name(format.requested)
    )))
}

/// INVALID_VALUE unless the size that a command names is that of its blocks.
fn check_image_size(format: &InternalFormat, [width, height]: [u32; 2], image_size: i32) -> Outcome {
    let Some(kind) = format.s3tc else { return Ok(()) };
    let need = kind.image_bytes(width, height);
    if usize::try_from(image_size) == Ok(need) {
        return Ok(());
    }
    Err(invalid_value(format!(
        "an image size of {image_size} bytes; {width} x {height} texels are {need} bytes in this format"
    )))
}

/// The blocks of a command, as many bytes as it names.
fn blocks_of<'a>(data: &'a Pixels<'_>, image_size: i32) -> Outcome<&'a [u8]> {
    let (bytes, needed) = (data.bytes().unwrap_or(&[]), param_counts::count(image_size));
    bytes.get(..needed).ok_or_else(|| too_short("data", needed, bytes.len(), "bytes"))
}

fn not_proxy(place: Place) -> Outcome<Place> {
    if place.proxy {
        return Err(crate::error::invalid_enum("a proxy target holds no image; use the target itself"));
    }
    Ok(place)
}
