//! Questions about texture images (OpenGL 1.5, sections 6.1.3 and 6.1.4, table 6.17), mipmap generation (3.8.8), and what
//! follows when an image has changed.

use super::Values;
use super::engine::Engine;
use super::tex_image::{Place, any_place, level_index};
use super::textures::bindable;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation};
use crate::limits::MAX_TEXTURE_LEVELS;
use crate::pixels::{PixelFormat, Purpose};
use crate::state::Dirty;
use crate::state::texture::Target;
use crate::texture::format::InternalFormat;
use crate::texture::image::Image;
use crate::texture::mipmap;
use crate::texture::object::TextureObject;
use std::sync::Arc;

/// A property of an image: of its format and size, all 0 where there is none.
fn level_value(format: Option<&InternalFormat>, size: [u32; 3], border: u32, pname: GLenum) -> Option<Values> {
    let sizes = format.map(InternalFormat::sizes).unwrap_or_default();
    Some(match pname {
        GL_TEXTURE_WIDTH => Values::uint(size[0]),
        GL_TEXTURE_HEIGHT => Values::uint(size[1]),
        GL_TEXTURE_DEPTH => Values::uint(size[2]),
        GL_TEXTURE_BORDER => Values::uint(border),
        // A component count is reported as it was given.
        GL_TEXTURE_INTERNAL_FORMAT => Values::uint(format.map_or(1, |f| f.reported)),
        GL_TEXTURE_RED_SIZE => Values::int(i32::from(sizes.red)),
        GL_TEXTURE_GREEN_SIZE => Values::int(i32::from(sizes.green)),
        GL_TEXTURE_BLUE_SIZE => Values::int(i32::from(sizes.blue)),
        GL_TEXTURE_ALPHA_SIZE => Values::int(i32::from(sizes.alpha)),
        GL_TEXTURE_LUMINANCE_SIZE => Values::int(i32::from(sizes.luminance)),
        GL_TEXTURE_INTENSITY_SIZE => Values::int(i32::from(sizes.intensity)),
        GL_TEXTURE_DEPTH_SIZE => Values::int(i32::from(sizes.depth)),
        GL_TEXTURE_STENCIL_SIZE_EXT => Values::int(format.map_or(0, |f| i32::from(f.stencil_bits))),
        GL_TEXTURE_COMPRESSED => Values::boolean(format.is_some_and(InternalFormat::is_compressed)),
        _ => return None,
    })
}

impl Engine {
    pub(crate) fn get_tex_level_parameter(&mut self, target: GLenum, level: i32, pname: GLenum) -> Outcome<Values> {
        let place = any_place(target)?;
        let level = level_index(place.target, level)?;
        self.ensure_mip_levels(place.target, self.bound_name(place.target))?;
        let found = if place.proxy {
            let proxy = self.proxies[place.target as usize][level];
            level_value(proxy.format, proxy.size, proxy.border, pname)
        } else {
            let image = self.bound_texture(place.target).image(place.face, level);
            if pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE {
                return match image.and_then(|image| image.compressed.as_ref()) {
                    Some(blocks) => Ok(Values::int(blocks.len() as i32)),
                    None => Err(invalid_operation("the image is not compressed, so it has no compressed size")),
                };
            }
            match image {
                Some(image) => level_value(Some(image.format), image.full_size(), image.border, pname),
                None => level_value(None, [0; 3], 0, pname),
            }
        };
        found.ok_or_else(|| invalid_enum(format!("{} is not a property of a texture image", name(pname))))
    }

    /// The image that a query reads.
    fn queried_image(&mut self, target: GLenum, level: i32) -> Outcome<Option<Arc<Image>>> {
        let place = any_place(target)?;
        if place.proxy {
            return Err(invalid_enum("a proxy target holds no image; use the target itself"));
        }
        let level = level_index(place.target, level)?;
        self.ensure_mip_levels(place.target, self.bound_name(place.target))?;
        Ok(self.bound_texture(place.target).image(place.face, level).cloned())
    }

    pub(crate) fn get_tex_image(
        &mut self,
        target: GLenum,
        level: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &mut [u8],
    ) -> Outcome {
        PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        match self.queried_image(target, level)? {
            Some(image) => image.get_tex_image(&self.client.pixel_store.pack, format, type_, pixels),
            None => Ok(()),
        }
    }

    #[cfg_attr(not(feature = "capi"), expect(dead_code, reason = "only memory that comes as a pointer is measured"))]
    pub(crate) fn tex_image_bytes(&mut self, target: GLenum, level: i32, format: GLenum, type_: GLenum) -> usize {
        let store = self.client.pixel_store.pack;
        match self.queried_image(target, level) {
            Ok(Some(image)) => image.get_tex_image_bytes(&store, format, type_).unwrap_or(0),
            _ => 0,
        }
    }

    pub(crate) fn get_compressed_tex_image(&mut self, target: GLenum, level: i32, data: &mut [u8]) -> Outcome {
        match self.queried_image(target, level)? {
            Some(image) => image.get_compressed(data),
            None => Err(invalid_operation("there is no image at this level")),
        }
    }

    #[cfg_attr(not(feature = "capi"), expect(dead_code, reason = "only memory that comes as a pointer is measured"))]
    pub(crate) fn compressed_tex_image_bytes(&mut self, target: GLenum, level: i32) -> usize {
        match self.queried_image(target, level) {
            Ok(Some(image)) => image.compressed.as_ref().map_or(0, Vec::len),
            _ => 0,
        }
    }

    pub(crate) fn generate_mipmap(&mut self, target: GLenum) -> Outcome {
        let target = bindable(target)?;
        if target == Target::Rectangle {
            return Err(invalid_enum("rectangle textures have no mipmaps"));
        }
        self.ensure_mip_levels(target, self.bound_name(target))?;
        let faces = self.bound_texture(target).faces.len();
        for face in 0..faces {
            self.defer_mip_levels(target, face);
        }
        self.ensure_mip_levels(target, self.bound_name(target))
    }

    /// After an image has changed: GENERATE_MIPMAP owes the levels below a base level.
    pub(crate) fn after_image_change(&mut self, place: Place, level: usize) -> Outcome {
        let object = self.bound_texture_mut(place.target);
        let wanted = object.parameters.generate_mipmap && usize::try_from(object.parameters.base_level) == Ok(level);
        if wanted && place.target != Target::Rectangle {
            self.defer_mip_levels(place.target, place.face);
        }
        Ok(())
    }

    /// The base level and the last one that can be made of it, as the object says now.
    fn chain(object: &TextureObject) -> (usize, usize) {
        let base = usize::try_from(object.parameters.base_level).unwrap_or(usize::MAX);
        let last = usize::try_from(object.parameters.max_level).unwrap_or(0).min(MAX_TEXTURE_LEVELS - 1);
        (base, last)
    }

    fn defer_mip_levels(&mut self, target: Target, face: usize) {
        let object = self.bound_texture_mut(target);
        let chain = Self::chain(object);
        if let Some(pending) = object.pending_mip_levels.get_mut(face) {
            *pending = Some(chain);
        }
        self.dirty.add(Dirty { vertex: false, fragment: true, raster: false });
    }

    /// Before an image changes: pending levels are made of what is there, unless the change makes them anew.
    pub(crate) fn before_image_change(&mut self, place: Place, level: usize) -> Outcome {
        let object = self.bound_texture(place.target);
        let chain = Self::chain(object);
        let again = object.parameters.generate_mipmap && chain.0 == level;
        let pending = object.pending_mip_levels.get(place.face).copied().flatten();
        if pending.is_none_or(|pending| again && pending == chain) {
            return Ok(());
        }
        self.ensure_mip_levels(place.target, self.bound_name(place.target))
    }

    /// Makes the pending levels of a texture object.
    pub(crate) fn ensure_mip_levels(&mut self, target: Target, texture: u32) -> Outcome {
        for face in 0..6 {
            let pending = &mut self.textures.object_mut(target, texture).pending_mip_levels;
            if let Some(chain) = pending.get_mut(face).and_then(Option::take) {
                self.make_face_levels((target, texture), face, chain)?;
            }
        }
        Ok(())
    }

    /// Makes all levels below the base level of a face, down to 1 x 1 x 1 or the last level.
    fn make_face_levels(
        &mut self,
        (target, texture): (Target, u32),
        face: usize,
        (base, last): (usize, usize),
    ) -> Outcome {
        let object = self.textures.object_mut(target, texture);
        let Some(image) = object.image(face, base).cloned() else { return Ok(()) };
        let simd = self.config.level;
        self.pixels_written += image.texels.len() as u64;
        let Some(levels) = object.faces.get_mut(face) else { return Ok(()) };
        let below = levels.get_mut(base + 1..).unwrap_or(&mut []);
        let levels = mipmap::levels(&image, last.saturating_sub(base), simd, below)?;
        let built = levels.len() as u64;
        for (made, slot) in levels.into_iter().zip(below) {
            *slot = Some(Arc::new(made));
        }
        self.textures.levels_built += built;
        self.dirty.add(Dirty { vertex: false, fragment: true, raster: false });
        Ok(())
    }
}
