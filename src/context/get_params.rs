//! Queries of parameters by object (OpenGL 1.5, section 6.1.3): lights, materials, clip planes, texture environments and
//! texture coordinate generation.

use super::Values;
use super::engine::Engine;
use super::lighting_state::light_index;
use super::raster_state::clip_plane_index;
use super::tex_unit::{coordinate_index, env_value};
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum};

fn wrong(what: &str, value: GLenum) -> GlError {
    invalid_enum(format!("{} is not {what}", name(value)))
}

impl Engine {
    pub(crate) fn get_light(&mut self, light: GLenum, pname: GLenum) -> Outcome<Values> {
        let l = &self.state.lighting.lights[light_index(light)?];
        Ok(match pname {
            GL_AMBIENT => Values::unit(&l.ambient),
            GL_DIFFUSE => Values::unit(&l.diffuse),
            GL_SPECULAR => Values::unit(&l.specular),
            GL_POSITION => Values::doubles(&l.position),
            GL_SPOT_DIRECTION => Values::doubles(&l.spot_direction),
            GL_SPOT_EXPONENT => Values::float(l.spot_exponent),
            GL_SPOT_CUTOFF => Values::float(l.spot_cutoff),
            GL_CONSTANT_ATTENUATION => Values::float(l.attenuation[0]),
            GL_LINEAR_ATTENUATION => Values::float(l.attenuation[1]),
            GL_QUADRATIC_ATTENUATION => Values::float(l.attenuation[2]),
            _ => return Err(wrong("a light parameter", pname)),
        })
    }

    pub(crate) fn get_material(&mut self, face: GLenum, pname: GLenum) -> Outcome<Values> {
        let m = match face {
            GL_FRONT => &self.state.lighting.materials[0],
            GL_BACK => &self.state.lighting.materials[1],
            _ => return Err(wrong("GL_FRONT or GL_BACK", face)),
        };
        Ok(match pname {
            GL_AMBIENT => Values::unit(&m.ambient),
            GL_DIFFUSE => Values::unit(&m.diffuse),
            GL_SPECULAR => Values::unit(&m.specular),
            GL_EMISSION => Values::unit(&m.emission),
            GL_SHININESS => Values::float(m.shininess),
            GL_COLOR_INDEXES => Values::floats(&m.indexes),
            _ => return Err(wrong("a material parameter", pname)),
        })
    }

    pub(crate) fn get_clip_plane_values(&mut self, plane: GLenum) -> Outcome<Values> {
        Ok(Values::doubles(&self.state.transform.clip_planes[clip_plane_index(plane)?]))
    }

    pub(crate) fn get_tex_env(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        let env = &self.state.texture.units[self.state.texture.active].env;
        match target {
            GL_TEXTURE_ENV => env_value(env, pname).ok_or_else(|| wrong("a texture environment parameter", pname)),
            GL_TEXTURE_FILTER_CONTROL if pname == GL_TEXTURE_LOD_BIAS => Ok(Values::float(env.lod_bias)),
            GL_TEXTURE_FILTER_CONTROL => Err(wrong("GL_TEXTURE_LOD_BIAS, the parameter of that target", pname)),
            GL_POINT_SPRITE_ARB if pname == GL_COORD_REPLACE_ARB => Ok(Values::boolean(env.coord_replace)),
            GL_POINT_SPRITE_ARB => Err(wrong("GL_COORD_REPLACE_ARB, the parameter of that target", pname)),
            _ => Err(wrong("GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL or GL_POINT_SPRITE_ARB", target)),
        }
    }

    pub(crate) fn get_tex_gen(&mut self, coord: GLenum, pname: GLenum) -> Outcome<Values> {
        let index = coordinate_index(coord)?;
        let generation = &self.state.texture.units[self.state.texture.active].generation[index];
        Ok(match pname {
            GL_TEXTURE_GEN_MODE => Values::enumerant(generation.mode.gl()),
            GL_OBJECT_PLANE => Values::doubles(&generation.object_plane),
            GL_EYE_PLANE => Values::doubles(&generation.eye_plane),
            _ => return Err(wrong("a parameter of texture coordinate generation", pname)),
        })
    }
}
