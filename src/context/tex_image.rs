//! TexImage and its relatives (OpenGL 1.5, sections 3.8.1 and 3.8.3): which images a target takes, the checks that all of
//! them share, proxies, and putting a new image in its place. A command makes the whole image first and only then
//! replaces the old one, so an error changes nothing.

use super::Pixels;
use super::engine::Engine;
use super::proxies::Proxy;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation, invalid_value, out_of_memory};
use crate::limits::{MAX_3D_TEXTURE_SIZE, MAX_IMAGE_BYTES, MAX_TEXTURE_LEVELS, MAX_TEXTURE_SIZE};
use crate::pixels::imaging::ColorImage;
use crate::pixels::{ClientImage, PixelFormat, Purpose, Transfer};
use crate::state::pixel::PixelStore;
use crate::state::texture::Target;
use crate::texture::format::{BaseFormat, InternalFormat};
use crate::texture::image::{Dimensions, Image};
use crate::texture::upload::check_formats;
use std::sync::Arc;

/// What a target of an image command addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) target: Target,
    pub(crate) face: usize,
    pub(crate) proxy: bool,
}

/// A request for an image, as the commands give it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request {
    pub(crate) place: Place,
    pub(crate) level: i32,
    pub(crate) size: [i32; 3],
    pub(crate) border: i32,
    pub(crate) format: &'static InternalFormat,
}

/// The image that a target names, for commands of so many dimensions.
pub(crate) fn place(target: GLenum, dimensions: usize) -> Outcome<Place> {
    let place = |target, face, proxy| Ok(Place { target, face, proxy });
    match (dimensions, target) {
        (1, GL_TEXTURE_1D) => place(Target::D1, 0, false),
        (1, GL_PROXY_TEXTURE_1D) => place(Target::D1, 0, true),
        (2, GL_TEXTURE_2D) => place(Target::D2, 0, false),
        (2, GL_PROXY_TEXTURE_2D) => place(Target::D2, 0, true),
        (2, GL_TEXTURE_RECTANGLE_ARB) => place(Target::Rectangle, 0, false),
        (2, GL_PROXY_TEXTURE_RECTANGLE_ARB) => place(Target::Rectangle, 0, true),
        (2, GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z) => {
            place(Target::Cube, (target - GL_TEXTURE_CUBE_MAP_POSITIVE_X) as usize, false)
        }
        (2, GL_PROXY_TEXTURE_CUBE_MAP) => place(Target::Cube, 0, true),
        (3, GL_TEXTURE_3D) => place(Target::D3, 0, false),
        (3, GL_PROXY_TEXTURE_3D) => place(Target::D3, 0, true),
        _ => Err(invalid_enum(format!("{} is not a target of {dimensions}-dimensional images", name(target)))),
    }
}

/// The same for queries, which take targets of any number of dimensions.
pub(crate) fn any_place(target: GLenum) -> Outcome<Place> {
    (1..=3)
        .find_map(|dimensions| place(target, dimensions).ok())
        .ok_or_else(|| invalid_enum(format!("{} is not the target of a texture image", name(target))))
}

/// How an image of a target is stored.
pub(crate) const fn dimensions_of(target: Target) -> Dimensions {
    match target {
        Target::D1 => Dimensions::One,
        Target::D3 => Dimensions::Three,
        _ => Dimensions::Two,
    }
}

/// A level that the target has.
pub(crate) fn level_index(target: Target, level: i32) -> Outcome<usize> {
    let last = if target == Target::Rectangle { 0 } else { MAX_TEXTURE_LEVELS - 1 };
    match usize::try_from(level) {
        Ok(level) if level <= last => Ok(level),
        _ => Err(invalid_value(format!("level {level}; this target has levels 0 to {last}"))),
    }
}

/// The greatest interior size that a level of a target may have.
fn limit(target: Target, level: usize) -> u32 {
    let base = if target == Target::D3 { MAX_3D_TEXTURE_SIZE } else { MAX_TEXTURE_SIZE };
    (base >> level).max(1)
}

impl Request {
    /// Checks what is an error for images and proxies alike, and gives the level and the size with border.
    fn check(&self) -> Outcome<(usize, [u32; 3])> {
        let Place { target, .. } = self.place;
        let level = level_index(target, self.level)?;
        if !(self.border == 0 || (self.border == 1 && target != Target::Rectangle)) {
            return Err(invalid_value(format!("a border of {}; it is 0 or 1, and 0 for rectangles", self.border)));
        }
        for (extent, label) in self.size.iter().zip(["width", "height", "depth"]) {
            if *extent < 0 {
                return Err(invalid_value(format!("a {label} of {extent}; it must not be negative")));
            }
        }
        if self.format.base == BaseFormat::Depth && matches!(target, Target::D3 | Target::Cube) {
            return Err(invalid_operation("depth textures are 1D, 2D or rectangle textures"));
        }
        Ok((level, self.size.map(i32::unsigned_abs)))
    }

    /// Whether the implementation takes an image of this size, and if not why.
    fn fits(&self, level: usize, size: [u32; 3]) -> Outcome {
        let target = self.place.target;
        let border = 2 * self.border.unsigned_abs();
        let most = limit(target, level);
        for extent in &size[..dimensions_of(target).count()] {
            if *extent < border || *extent - border > most {
                return Err(invalid_value(format!(
                    "an image of {} x {} x {} at level {level}; each side is from {border} to {} texels there",
                    size[0],
                    size[1],
                    size[2],
                    most + border
                )));
            }
        }
        if target == Target::Cube && self.size[0] != self.size[1] {
            return Err(invalid_value("the faces of a cube map are square: width and height must be equal"));
        }
        let texels: u64 = size.iter().map(|n| u64::from(*n)).product();
        let most = MAX_IMAGE_BYTES / self.format.storage.bytes();
        if texels > most {
            return Err(out_of_memory(format!("an image of {texels} texels; the most of this format is {most}")));
        }
        Ok(())
    }
}

/// Pixels of a command with the pixel store that they are laid out by.
pub(crate) fn client_image<'a>(
    pixels: &'a Pixels<'_>,
    store: &PixelStore,
    dimensions: Dimensions,
    size: [i32; 3],
    pixel: PixelFormat,
) -> Outcome<Option<ClientImage<'a>>> {
    let Some(bytes) = pixels.bytes() else { return Ok(None) };
    let store = if pixels.is_tight() { &PixelStore::TIGHT } else { store };
    Ok(Some(match dimensions {
        Dimensions::Three => ClientImage::new_3d(bytes, store, size, pixel)?,
        _ => ClientImage::new_2d(bytes, store, [size[0], size[1]], pixel)?,
    }))
}

impl Engine {
    /// The colours of a command's pixels, where the imaging subset is to change them.
    pub(crate) fn imaged_pixels(
        &self,
        target: Target,
        size: [i32; 3],
        pixel: PixelFormat,
        pixels: &Pixels<'_>,
    ) -> Outcome<Option<ColorImage>> {
        if !self.uses_imaging() {
            return Ok(None);
        }
        let client = client_image(pixels, &self.client.pixel_store.unpack, dimensions_of(target), size, pixel)?;
        client.map_or(Ok(None), |client| self.client_colors(&client))
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_image_1d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        border: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let (place, size) = (place(target, 1)?, [width, 1, 1]);
        self.tex_image(place, level, internal_format, size, border, (format, type_), pixels)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        height: i32,
        border: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let (place, size) = (place(target, 2)?, [width, height, 1]);
        self.tex_image(place, level, internal_format, size, border, (format, type_), pixels)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        height: i32,
        depth: i32,
        border: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let (place, size) = (place(target, 3)?, [width, height, depth]);
        self.tex_image(place, level, internal_format, size, border, (format, type_), pixels)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn tex_image(
        &mut self,
        place: Place,
        level: i32,
        internal_format: i32,
        size: [i32; 3],
        border: i32,
        (format, type_): (GLenum, GLenum),
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let pixel = PixelFormat::for_command(format, type_, Purpose::TexImage)?;
        let internal = InternalFormat::of_tex_image(internal_format)?;
        check_formats(pixel, internal)?;
        if let Some(image) = self.imaged_pixels(place.target, size, pixel, pixels)? {
            let Some(image) = self.transfer_image(image, dimensions_of(place.target).count())? else { return Ok(()) };
            let size = image.size_3d(size[2]);
            return self.with_transferred(&image, |engine, pair, pixels| {
                engine.tex_image(place, level, internal_format, size, border, pair, pixels)
            });
        }
        let request = Request { place, level, size, border, format: internal };
        let Some(level) = self.admit(&request)? else { return Ok(()) };
        let dimensions = dimensions_of(place.target);
        let store = self.client.pixel_store.unpack;
        let client = client_image(pixels, &store, dimensions, size, pixel)?;
        let size = size.map(i32::unsigned_abs);
        let border = border.unsigned_abs();
        if let Some(client) = &client
            && self.rewrite(place, level, |image| image.is_like(internal, dimensions, size, border), client)?
        {
            return self.after_image_change(place, level);
        }
        let image =
            Image::from_client(internal, dimensions, size, border, client.as_ref(), self.transfer(), self.fit())?;
        self.put_image(place, level, Arc::new(image))
    }

    /// Writes the memory of the old image again where it has the shape that is wanted and no draw holds it: uploading a
    /// texture every frame then costs no allocation. False where there is no such image.
    fn rewrite(
        &mut self,
        place: Place,
        level: usize,
        fits: impl Fn(&Image) -> bool,
        pixels: &ClientImage<'_>,
    ) -> Outcome<bool> {
        let old = self.bound_texture(place.target).image(place.face, level);
        if !old.is_some_and(|image| fits(image)) {
            return Ok(false);
        }
        self.free_image(place, level);
        let fit = self.fit();
        let bound = self.bound_name(place.target);
        let object = self.textures.object_mut(place.target, bound);
        let slot = object.faces.get_mut(place.face).and_then(|levels| levels.get_mut(level));
        let Some(image) = slot.and_then(Option::as_mut).and_then(Arc::get_mut) else { return Ok(false) };
        let transfer = Transfer { mode: &self.state.pixel.transfer, maps: &self.state.pixel_maps };
        image.fit = fit;
        image.upload(image.first(), pixels, transfer)?;
        Ok(true)
    }

    /// Before an image is written: draws that are done let go of it. A large image that waiting draws hold is worth
    /// carrying them out, since copying it would cost more.
    pub(crate) fn free_image(&mut self, place: Place, level: usize) {
        const LARGE: usize = 1 << 14;
        let image = self.bound_texture(place.target).image(place.face, level);
        if image.is_some_and(|image| image.texels.len() >= LARGE && Arc::strong_count(image) > 1) {
            self.flush_scene();
        }
        self.release_draws();
    }

    /// Checks a request. A proxy is answered here, and then there is no level to go on with.
    pub(crate) fn admit(&mut self, request: &Request) -> Outcome<Option<usize>> {
        let (level, size) = request.check()?;
        let fits = request.fits(level, size);
        if !request.place.proxy {
            fits?;
            self.before_image_change(request.place, level)?;
            self.pixels_written += size.iter().map(|n| u64::from(*n)).product::<u64>();
            return Ok(Some(level));
        }
        let proxy = &mut self.proxies[request.place.target as usize][level];
        *proxy = match fits {
            Ok(()) => Proxy { format: Some(request.format), size, border: request.border.unsigned_abs() },
            Err(_) => Proxy::default(),
        };
        Ok(None)
    }

    /// Puts an image in its place and makes the levels below it where the object asks for that.
    pub(crate) fn put_image(&mut self, place: Place, level: usize, image: Arc<Image>) -> Outcome {
        let object = self.bound_texture_mut(place.target);
        if let Some(slot) = object.faces.get_mut(place.face).and_then(|levels| levels.get_mut(level)) {
            *slot = Some(image);
        }
        self.after_image_change(place, level)
    }

    /// The image that a command changes a part of.
    pub(crate) fn existing_image(&mut self, place: Place, level: i32) -> Outcome<(usize, Arc<Image>)> {
        let level = level_index(place.target, level)?;
        self.before_image_change(place, level)?;
        match self.bound_texture(place.target).image(place.face, level) {
            Some(image) => Ok((level, Arc::clone(image))),
            None => Err(no_image(level)),
        }
    }
}

fn no_image(level: usize) -> GlError {
    invalid_operation(format!("there is no image at level {level} yet; specify it with glTexImage first"))
}
