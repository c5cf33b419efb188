//! Commands of texture units (OpenGL 1.5, sections 2.7, 2.11.4 and 3.8.13): the active unit, the texture environment and
//! the generation of texture coordinates.

use super::Params;
use super::engine::Engine;
use super::raster_state::to_eye_plane;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_value, known};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::state::Dirty;
use crate::state::texture::CombineFunction;
use crate::state::texture::CombineOperand;
use crate::state::texture::CombineSource;
use crate::state::texture::Env;
use crate::state::texture::EnvMode;
use crate::state::texture::TexGenMode;

/// The number of a texture unit by its name.
pub(crate) fn unit_index(texture: GLenum) -> Outcome<usize> {
    let index = texture.wrapping_sub(GL_TEXTURE0) as usize;
    if index < MAX_TEXTURE_UNITS {
        return Ok(index);
    }
    let last = MAX_TEXTURE_UNITS - 1;
    Err(invalid_enum(format!("{} is not a texture unit; there are GL_TEXTURE0 to GL_TEXTURE{last}", name(texture))))
}

fn wrong(what: &str, value: GLenum) -> GlError {
    invalid_enum(format!("{} is not {what}", name(value)))
}

impl Engine {
    pub(crate) fn active_texture(&mut self, texture: GLenum) -> Outcome {
        self.state.texture.active = unit_index(texture)?;
        Ok(())
    }

    pub(crate) fn tex_env(&mut self, target: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let env = &mut self.state.texture.units[self.state.texture.active].env;
        match target {
            GL_TEXTURE_ENV => set_env(env, pname, params)?,
            GL_TEXTURE_FILTER_CONTROL if pname == GL_TEXTURE_LOD_BIAS => env.lod_bias = params.scalar()?,
            GL_POINT_SPRITE_ARB if pname == GL_COORD_REPLACE_ARB => {
                env.coord_replace = match params.enumerant()? {
                    0 => false,
                    1 => true,
                    _ => return Err(invalid_value("GL_COORD_REPLACE_ARB is GL_TRUE or GL_FALSE")),
                };
            }
            GL_POINT_SPRITE_ARB => return Err(wrong("GL_COORD_REPLACE_ARB, the parameter of that target", pname)),
            GL_TEXTURE_FILTER_CONTROL => return Err(wrong("GL_TEXTURE_LOD_BIAS, the parameter of that target", pname)),
            _ => return Err(wrong("GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL or GL_POINT_SPRITE_ARB", target)),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn tex_gen(&mut self, coord: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let index = coordinate_index(coord)?;
        let modelview = *self.state.transform.modelview.top();
        let generation = &mut self.state.texture.units[self.state.texture.active].generation[index];
        match pname {
            GL_TEXTURE_GEN_MODE => {
                let mode = params.enumerant()?;
                generation.mode = TexGenMode::from_gl(mode)
                    .filter(|mode| index < mode.coordinates())
                    .ok_or_else(|| invalid_enum(format!("{} cannot generate {}", name(mode), name(coord))))?;
            }
            GL_OBJECT_PLANE => {
                params.vector_only("TexGen", pname)?;
                generation.object_plane = params.numbers()?.map(f64::from);
            }
            GL_EYE_PLANE => {
                params.vector_only("TexGen", pname)?;
                generation.eye_plane = to_eye_plane(&modelview, params.numbers()?.map(f64::from));
            }
            _ => return Err(wrong("GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE or GL_EYE_PLANE", pname)),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }
}

/// The number of a texture coordinate by its name.
pub(crate) fn coordinate_index(coord: GLenum) -> Outcome<usize> {
    let index = coord.wrapping_sub(GL_S) as usize;
    if index < 4 { Ok(index) } else { Err(wrong("GL_S, GL_T, GL_R or GL_Q", coord)) }
}

const SOURCES: [[GLenum; 2]; 4] = [
    [GL_SOURCE0_RGB, GL_SOURCE0_ALPHA],
    [GL_SOURCE1_RGB, GL_SOURCE1_ALPHA],
    [GL_SOURCE2_RGB, GL_SOURCE2_ALPHA],
    [GL_SOURCE3_RGB_NV, GL_SOURCE3_ALPHA_NV],
];
const OPERANDS: [[GLenum; 2]; 4] = [
    [GL_OPERAND0_RGB, GL_OPERAND0_ALPHA],
    [GL_OPERAND1_RGB, GL_OPERAND1_ALPHA],
    [GL_OPERAND2_RGB, GL_OPERAND2_ALPHA],
    [GL_OPERAND3_RGB_NV, GL_OPERAND3_ALPHA_NV],
];

/// Where in a table of names (argument by RGB or alpha) a name stands.
fn find(table: &[[GLenum; 2]; 4], pname: GLenum) -> Option<(usize, usize)> {
    (0..4).flat_map(|i| [(i, 0), (i, 1)]).find(|&(i, k)| table[i][k] == pname)
}

fn set_env(env: &mut Env, pname: GLenum, params: &Params) -> Outcome {
    match pname {
        GL_TEXTURE_ENV_MODE => {
            let value = params.enumerant()?;
            // EXT_texture has a number of its own for REPLACE.
            let mode = if value == GL_REPLACE_EXT { GL_REPLACE } else { value };
            env.mode = known(EnvMode::from_gl(mode), value, "a texture environment mode")?;
        }
        GL_TEXTURE_ENV_COLOR => {
            params.vector_only("TexEnv", pname)?;
            env.color = params.color()?.map(clamp01);
        }
        GL_COMBINE_RGB | GL_COMBINE_ALPHA => {
            let (value, alpha) = (params.enumerant()?, pname == GL_COMBINE_ALPHA);
            let function = CombineFunction::from_gl(value).filter(|function| !alpha || !function.is_dot());
            env.combine[usize::from(alpha)] = known(function, value, "a combine function")?;
        }
        GL_RGB_SCALE | GL_ALPHA_SCALE => {
            let scale = params.scalar()?;
            if ![1.0, 2.0, 4.0].contains(&scale) {
                return Err(invalid_value(format!("a scale of {scale}; it is 1, 2 or 4")));
            }
            env.scale[usize::from(pname == GL_ALPHA_SCALE)] = scale;
        }
        _ => {
            if let Some((i, k)) = find(&SOURCES, pname) {
                let value = params.enumerant()?;
                env.source[i][k] = known(CombineSource::from_gl(value), value, "a combine source")?;
            } else if let Some((i, k)) = find(&OPERANDS, pname) {
                let value = params.enumerant()?;
                let operand = CombineOperand::from_gl(value).filter(|operand| k == 0 || operand.is_alpha());
                env.operand[i][k] = known(operand, value, "a combine operand for this argument")?;
            } else {
                return Err(wrong("a texture environment parameter", pname));
            }
        }
    }
    Ok(())
}

/// The parameters of an environment for Get: the value, and whether it is a colour.
pub(crate) fn env_value(env: &Env, pname: GLenum) -> Option<super::Values> {
    use super::Values;
    Some(match pname {
        GL_TEXTURE_ENV_MODE => Values::enumerant(env.mode.gl()),
        GL_TEXTURE_ENV_COLOR => Values::unit(&env.color),
        GL_COMBINE_RGB => Values::enumerant(env.combine[0].gl()),
        GL_COMBINE_ALPHA => Values::enumerant(env.combine[1].gl()),
        GL_RGB_SCALE => Values::float(env.scale[0]),
        GL_ALPHA_SCALE => Values::float(env.scale[1]),
        _ => {
            if let Some((i, k)) = find(&SOURCES, pname) {
                Values::enumerant(env.source[i][k].gl())
            } else {
                let (i, k) = find(&OPERANDS, pname)?;
                Values::enumerant(env.operand[i][k].gl())
            }
        }
    })
}
