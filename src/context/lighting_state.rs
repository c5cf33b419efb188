//! Commands of lighting state (OpenGL 1.5, section 2.14): lights, light model, materials, colour material, shade model.
//! Positions and spot directions are taken to eye coordinates when they are given, by the modelview matrix of then.

use super::Params;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_value};
use crate::limits::MAX_LIGHTS;
use crate::state::Dirty;
use crate::state::lighting::Material;
use glam::{DMat3, DVec3, DVec4};

const VERTEX: Dirty = Dirty { vertex: true, fragment: false, raster: false };

fn wrong_pname(command: &str, pname: GLenum) -> GlError {
    invalid_enum(format!("{} is not a parameter of gl{command}", name(pname)))
}

/// Which of the two materials a face name means.
pub(crate) fn faces(face: GLenum) -> Outcome<[bool; 2]> {
    match face {
        GL_FRONT => Ok([true, false]),
        GL_BACK => Ok([false, true]),
        GL_FRONT_AND_BACK => Ok([true, true]),
        _ => Err(invalid_enum(format!("{} is not GL_FRONT, GL_BACK or GL_FRONT_AND_BACK", name(face)))),
    }
}

fn in_range(what: &str, value: f32, range: std::ops::RangeInclusive<f32>) -> Outcome {
    if range.contains(&value) {
        return Ok(());
    }
    Err(invalid_value(format!("{what} of {value} is not in [{}, {}]", range.start(), range.end())))
}

impl Engine {
    pub(crate) fn light(&mut self, light: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let index = light_index(light)?;
        let modelview = *self.state.transform.modelview.top();
        let vector = matches!(pname, GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_POSITION | GL_SPOT_DIRECTION);
        if vector {
            params.vector_only("Light", pname)?;
        }
        let l = &mut self.state.lighting.lights[index];
        let value = params.scalar();
        match pname {
            GL_AMBIENT => l.ambient = params.color(),
            GL_DIFFUSE => l.diffuse = params.color(),
            GL_SPECULAR => l.specular = params.color(),
            GL_POSITION => {
                let p = params.vector4().map(f64::from);
                l.position = (modelview * DVec4::from_array(p)).to_array();
            }
            GL_SPOT_DIRECTION => {
                let [x, y, z, _] = params.vector4().map(f64::from);
                l.spot_direction = (DMat3::from_mat4(modelview) * DVec3::new(x, y, z)).to_array();
            }
            GL_SPOT_EXPONENT => {
                in_range("a spot exponent", value, 0.0..=128.0)?;
                l.spot_exponent = value;
            }
            GL_SPOT_CUTOFF => {
                if value != 180.0 {
                    in_range("a spot cutoff that is not 180", value, 0.0..=90.0)?;
                }
                l.spot_cutoff = value;
            }
            GL_CONSTANT_ATTENUATION | GL_LINEAR_ATTENUATION | GL_QUADRATIC_ATTENUATION => {
                in_range("an attenuation", value, 0.0..=f32::MAX)?;
                l.attenuation[(pname - GL_CONSTANT_ATTENUATION) as usize] = value;
            }
            _ => return Err(wrong_pname("Light", pname)),
        }
        self.dirty.add(VERTEX);
        Ok(())
    }

    pub(crate) fn light_model(&mut self, pname: GLenum, params: &Params) -> Outcome {
        let model = &mut self.state.lighting.model;
        match pname {
            GL_LIGHT_MODEL_AMBIENT => {
                params.vector_only("LightModel", pname)?;
                model.ambient = params.color();
            }
            GL_LIGHT_MODEL_LOCAL_VIEWER => model.local_viewer = params.boolean(),
            GL_LIGHT_MODEL_TWO_SIDE => model.two_side = params.boolean(),
            GL_LIGHT_MODEL_COLOR_CONTROL => match params.enumerant() {
                value @ (GL_SINGLE_COLOR | GL_SEPARATE_SPECULAR_COLOR) => model.color_control = value,
                value => {
                    return Err(invalid_enum(format!(
                        "{} is not GL_SINGLE_COLOR or GL_SEPARATE_SPECULAR_COLOR",
                        name(value)
                    )));
                }
            },
            _ => return Err(wrong_pname("LightModel", pname)),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn material(&mut self, face: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let faces = faces(face)?;
        match pname {
            GL_SHININESS => in_range("a shininess", params.scalar(), 0.0..=128.0)?,
            GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_EMISSION | GL_AMBIENT_AND_DIFFUSE | GL_COLOR_INDEXES => {
                params.vector_only("Material", pname)?;
            }
            _ => return Err(wrong_pname("Material", pname)),
        }
        // Vertices that were issued before keep the material of their time.
        self.before_material_change();
        for (material, _) in self.state.lighting.materials.iter_mut().zip(faces).filter(|(_, chosen)| *chosen) {
            set_material(material, pname, params);
        }
        self.track_color();
        self.dirty.add(VERTEX);
        Ok(())
    }

    pub(crate) fn color_material(&mut self, face: GLenum, mode: GLenum) -> Outcome {
        faces(face)?;
        match mode {
            GL_EMISSION | GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_AMBIENT_AND_DIFFUSE => {}
            _ => return Err(invalid_enum(format!("{} is not a material colour that can track", name(mode)))),
        }
        self.state.lighting.color_material_face = face;
        self.state.lighting.color_material_mode = mode;
        self.track_color();
        self.dirty.add(VERTEX);
        Ok(())
    }

    /// Where `GL_COLOR_MATERIAL` is on, the tracked properties are the current colour (section 2.14.3).
    pub(crate) fn track_color(&mut self) {
        let lighting = &mut self.state.lighting;
        if !lighting.color_material {
            return;
        }
        let color = Params::floats(&self.state.current.color);
        let chosen = faces(lighting.color_material_face).unwrap_or([false; 2]);
        for (material, _) in lighting.materials.iter_mut().zip(chosen).filter(|(_, chosen)| *chosen) {
            set_material(material, lighting.color_material_mode, &color);
        }
    }

    pub(crate) fn shade_model(&mut self, mode: GLenum) -> Outcome {
        match mode {
            GL_FLAT | GL_SMOOTH => self.state.lighting.shade_model = mode,
            _ => return Err(invalid_enum(format!("{} is not GL_FLAT or GL_SMOOTH", name(mode)))),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }
}

/// The number of a light by its name.
pub(crate) fn light_index(light: GLenum) -> Outcome<usize> {
    let index = light.wrapping_sub(GL_LIGHT0) as usize;
    if index < MAX_LIGHTS {
        return Ok(index);
    }
    Err(invalid_enum(format!("{} is not a light; there are GL_LIGHT0 to GL_LIGHT{}", name(light), MAX_LIGHTS - 1)))
}

fn set_material(material: &mut Material, pname: GLenum, params: &Params) {
    match pname {
        GL_AMBIENT => material.ambient = params.color(),
        GL_DIFFUSE => material.diffuse = params.color(),
        GL_SPECULAR => material.specular = params.color(),
        GL_EMISSION => material.emission = params.color(),
        GL_AMBIENT_AND_DIFFUSE => {
            material.ambient = params.color();
            material.diffuse = params.color();
        }
        GL_SHININESS => material.shininess = params.scalar(),
        _ => material.indexes = std::array::from_fn(|i| params.number(i)),
    }
}
