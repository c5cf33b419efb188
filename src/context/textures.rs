//! Texture objects by name (OpenGL 1.5, sections 3.8.4, 3.8.11 and 3.8.12): generating, binding and deleting names, and
//! the parameters of the bound object.

use super::enable::texture_target;
use super::engine::Engine;
use super::{Params, Values};
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation, invalid_value, known, out_of_memory};
use crate::num::clamp01;
use crate::state::Dirty;
use crate::state::compare::CompareFunc;
use crate::state::texture::DepthTextureMode;
use crate::state::texture::TextureCompareMode;
use crate::state::texture::TextureFilter;
use crate::state::texture::WrapMode;
use crate::state::texture::{Target, TexParameters};
use crate::texture::object::TextureObject;
use crate::texture::wrap;

/// A target that textures are bound to, or INVALID_ENUM.
pub(crate) fn bindable(target: GLenum) -> Outcome<Target> {
    texture_target(target).ok_or_else(|| invalid_enum(format!("{} is not a texture target", name(target))))
}

fn wrong(what: &str, value: GLenum) -> GlError {
    invalid_enum(format!("{} is not {what}", name(value)))
}

impl Engine {
    /// The name bound to a target of the active unit.
    pub(crate) fn bound_name(&self, target: Target) -> u32 {
        self.state.texture.units[self.state.texture.active].bound[target as usize]
    }

    /// The object bound to a target of the active unit.
    pub(crate) fn bound_texture(&self, target: Target) -> &TextureObject {
        self.textures.object(target, self.bound_name(target))
    }

    /// The object bound to a target of the active unit, to be changed.
    pub(crate) fn bound_texture_mut(&mut self, target: Target) -> &mut TextureObject {
        let name = self.bound_name(target);
        self.dirty.add(Dirty { vertex: true, fragment: true, raster: false });
        self.textures.object_mut(target, name)
    }

    pub(crate) fn gen_textures(&mut self, n: i32, names: &mut [u32]) -> Outcome {
        not_negative("n", n)?;
        let names = names.iter_mut().take(n as usize);
        let all = &mut self.textures.named;
        all.try_reserve(names.len()).map_err(|_| out_of_memory("no memory for names of textures"))?;
        for to in names {
            *to = self.textures.generate();
        }
        Ok(())
    }

    pub(crate) fn delete_textures(&mut self, n: i32, names: &[u32]) -> Outcome {
        not_negative("n", n)?;
        for deleted in names.iter().take(n as usize).filter(|v| **v != 0) {
            self.textures.named.remove(deleted);
            for bound in self.state.texture.units.iter_mut().flat_map(|unit| &mut unit.bound) {
                if bound == deleted {
                    *bound = 0;
                    self.dirty = Dirty::ALL;
                }
            }
        }
        Ok(())
    }

    pub(crate) fn bind_texture(&mut self, target: GLenum, texture: u32) -> Outcome {
        let to = bindable(target)?;
        if texture != 0 {
            match self.textures.named.get(&texture) {
                Some(Some(object)) if object.target != to => {
                    return Err(invalid_operation(format!(
                        "texture {texture} is a texture of {} and cannot be bound to {}; a name keeps its first target",
                        name(object.target.gl()),
                        name(target)
                    )));
                }
                Some(Some(_)) => {}
                _ => {
                    self.textures.named.insert(texture, Some(TextureObject::new(to)));
                }
            }
        }
        let bound = &mut self.state.texture.units[self.state.texture.active].bound[to as usize];
        if *bound != texture {
            *bound = texture;
            self.dirty = Dirty::ALL;
        }
        Ok(())
    }

    pub(crate) fn is_texture(&mut self, texture: u32) -> bool {
        self.textures.exists(texture)
    }

    /// Every texture is resident: there is one memory.
    pub(crate) fn are_textures_resident(&mut self, n: i32, names: &[u32], residences: &mut [u8]) -> Outcome<bool> {
        not_negative("n", n)?;
        let asked = &names[..names.len().min(n as usize)];
        if let Some(unknown) = asked.iter().find(|v| !self.textures.exists(**v)) {
            return Err(invalid_value(format!("{unknown} is not the name of a texture")));
        }
        residences.iter_mut().take(asked.len()).for_each(|to| *to = GL_TRUE);
        Ok(true)
    }

    pub(crate) fn prioritize_textures(&mut self, n: i32, names: &[u32], priorities: &[f32]) -> Outcome {
        not_negative("n", n)?;
        for (texture, priority) in names.iter().zip(priorities).take(n as usize) {
            if let Some(Some(object)) = self.textures.named.get_mut(texture) {
                object.parameters.priority = clamp01(*priority);
            }
        }
        Ok(())
    }

    pub(crate) fn tex_parameter(&mut self, target: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let to = bindable(target)?;
        let mut changed = self.bound_texture(to).parameters;
        set_parameter(&mut changed, to, pname, params)?;
        let object = self.bound_texture_mut(to);
        if object.parameters != changed {
            object.parameters = changed;
        }
        Ok(())
    }

    pub(crate) fn get_tex_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        let object = self.bound_texture(bindable(target)?);
        parameter_value(&object.parameters, pname).ok_or_else(|| wrong("a texture parameter", pname))
    }
}

pub(crate) fn not_negative(what: &str, n: i32) -> Outcome {
    if n >= 0 { Ok(()) } else { Err(invalid_value(format!("{what} is {n}; it must not be negative"))) }
}

fn set_parameter(p: &mut TexParameters, target: Target, pname: GLenum, params: &Params) -> Outcome {
    let rectangle = target == Target::Rectangle;
    match pname {
        GL_TEXTURE_WRAP_S | GL_TEXTURE_WRAP_T | GL_TEXTURE_WRAP_R => {
            let value = params.enumerant()?;
            let mode = WrapMode::from_gl(value).filter(|mode| !rectangle || wrap::row(*mode).on_rectangles);
            let mode = known(mode, value, "a wrap mode of this target")?;
            let coordinate = match pname {
                GL_TEXTURE_WRAP_S => 0,
                GL_TEXTURE_WRAP_T => 1,
                _ => 2,
            };
            p.wrap[coordinate] = mode;
        }
        GL_TEXTURE_MIN_FILTER => {
            let value = params.enumerant()?;
            let filter = TextureFilter::from_gl(value).filter(|filter| !rectangle || !filter.has_mipmaps());
            p.min_filter = known(filter, value, "a minification filter of this target")?;
        }
        GL_TEXTURE_MAG_FILTER => {
            let value = params.enumerant()?;
            let filter = TextureFilter::from_gl(value).filter(|filter| !filter.has_mipmaps());
            p.mag_filter = known(filter, value, "a magnification filter (GL_NEAREST or GL_LINEAR)")?;
        }
        GL_TEXTURE_BORDER_COLOR => {
            params.vector_only("TexParameter", pname)?;
            p.border_color = params.color()?.map(clamp01);
        }
        GL_TEXTURE_PRIORITY => p.priority = clamp01(params.scalar()?),
        GL_TEXTURE_MIN_LOD => p.min_lod = params.scalar()?,
        GL_TEXTURE_MAX_LOD => p.max_lod = params.scalar()?,
        GL_TEXTURE_LOD_BIAS => p.lod_bias = params.scalar()?,
        GL_TEXTURE_BASE_LEVEL | GL_TEXTURE_MAX_LEVEL => {
            let level = params.integer()?;
            not_negative("a level", level)?;
            if pname == GL_TEXTURE_MAX_LEVEL {
                p.max_level = level;
            } else if rectangle && level != 0 {
                return Err(invalid_operation("a rectangle texture has only level 0, so that is its base level"));
            } else {
                p.base_level = level;
            }
        }
        GL_TEXTURE_MAX_ANISOTROPY_EXT => {
            let degree = params.scalar()?;
            if degree.is_nan() || degree < 1.0 {
                return Err(invalid_value(format!("a degree of anisotropy of {degree}; it is at least 1")));
            }
            p.max_anisotropy = degree.min(crate::limits::MAX_TEXTURE_MAX_ANISOTROPY);
        }
        GL_DEPTH_TEXTURE_MODE => {
            let value = params.enumerant()?;
            let mode = DepthTextureMode::from_gl(value);
            p.depth_mode = known(mode, value, "GL_LUMINANCE, GL_INTENSITY or GL_ALPHA")?;
        }
        GL_TEXTURE_COMPARE_MODE => {
            let value = params.enumerant()?;
            let mode = TextureCompareMode::from_gl(value);
            p.compare_mode = known(mode, value, "GL_NONE or GL_COMPARE_R_TO_TEXTURE")?;
        }
        GL_TEXTURE_COMPARE_FUNC => {
            let value = params.enumerant()?;
            p.compare_func = known(CompareFunc::from_gl(value), value, "a comparison function")?;
        }
        GL_GENERATE_MIPMAP => p.generate_mipmap = params.boolean()?,
        _ => return Err(wrong("a texture parameter", pname)),
    }
    Ok(())
}

fn parameter_value(p: &TexParameters, pname: GLenum) -> Option<Values> {
    Some(match pname {
        GL_TEXTURE_WRAP_S => Values::enumerant(p.wrap[0].gl()),
        GL_TEXTURE_WRAP_T => Values::enumerant(p.wrap[1].gl()),
        GL_TEXTURE_WRAP_R => Values::enumerant(p.wrap[2].gl()),
        GL_TEXTURE_MIN_FILTER => Values::enumerant(p.min_filter.gl()),
        GL_TEXTURE_MAG_FILTER => Values::enumerant(p.mag_filter.gl()),
        GL_TEXTURE_BORDER_COLOR => Values::unit(&p.border_color),
        GL_TEXTURE_PRIORITY => Values::unit(&[p.priority]),
        GL_TEXTURE_RESIDENT => Values::boolean(true),
        GL_TEXTURE_MIN_LOD => Values::float(p.min_lod),
        GL_TEXTURE_MAX_LOD => Values::float(p.max_lod),
        GL_TEXTURE_LOD_BIAS => Values::float(p.lod_bias),
        GL_TEXTURE_BASE_LEVEL => Values::int(p.base_level),
        GL_TEXTURE_MAX_LEVEL => Values::int(p.max_level),
        GL_TEXTURE_MAX_ANISOTROPY_EXT => Values::float(p.max_anisotropy),
        GL_DEPTH_TEXTURE_MODE => Values::enumerant(p.depth_mode.gl()),
        GL_TEXTURE_COMPARE_MODE => Values::enumerant(p.compare_mode.gl()),
        GL_TEXTURE_COMPARE_FUNC => Values::enumerant(p.compare_func.gl()),
        GL_GENERATE_MIPMAP => Values::boolean(p.generate_mipmap),
        _ => return None,
    })
}
