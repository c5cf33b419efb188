//! Commands of lighting state (OpenGL 1.5, section 2.14): lights, light model, materials, colour material, shade model.
//! Positions and spot directions are taken to eye coordinates when they are given, by the modelview matrix of then.

use super::Params;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_value, known};
use crate::limits::MAX_LIGHTS;
use crate::state::Dirty;
use crate::state::lighting::{ColorControl, MaterialColor, ShadeModel};
use crate::state::raster::Face;
use glam::{DMat3, DVec3, DVec4};

const VERTEX: Dirty = Dirty { vertex: true, fragment: false, raster: false };

fn wrong_pname(command: &str, pname: GLenum) -> GlError {
    invalid_enum(format!("{} is not a parameter of gl{command}", name(pname)))
}

/// The faces of a name.
pub(crate) fn faces(face: GLenum) -> Outcome<Face> {
    known(Face::from_gl(face), face, "GL_FRONT, GL_BACK or GL_FRONT_AND_BACK")
}

fn in_range(what: &str, value: f32, range: std::ops::RangeInclusive<f32>) -> Outcome<f32> {
    if range.contains(&value) {
        return Ok(value);
    }
    Err(invalid_value(format!("{what} of {value} is not in [{}, {}]", range.start(), range.end())))
}

/// What a Material command sets.
#[derive(Clone, Copy)]
enum MaterialChange {
    Color(MaterialColor, [f32; 4]),
    Shininess(f32),
    Indexes([f32; 3]),
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
        match pname {
            GL_AMBIENT => l.ambient = params.color()?,
            GL_DIFFUSE => l.diffuse = params.color()?,
            GL_SPECULAR => l.specular = params.color()?,
            GL_POSITION => {
                let p = params.numbers()?.map(f64::from);
                l.position = (modelview * DVec4::from_array(p)).to_array();
            }
            GL_SPOT_DIRECTION => {
                let [x, y, z] = params.numbers()?.map(f64::from);
                l.spot_direction = (DMat3::from_mat4(modelview) * DVec3::new(x, y, z)).to_array();
            }
            GL_SPOT_EXPONENT => {
                l.spot_exponent = in_range("a spot exponent", params.scalar()?, 0.0..=128.0)?;
            }
            GL_SPOT_CUTOFF => {
                l.spot_cutoff = match params.scalar()? {
                    180.0 => 180.0,
                    degrees => in_range("a spot cutoff that is not 180", degrees, 0.0..=90.0)?,
                };
            }
            GL_CONSTANT_ATTENUATION | GL_LINEAR_ATTENUATION | GL_QUADRATIC_ATTENUATION => {
                l.attenuation[(pname - GL_CONSTANT_ATTENUATION) as usize] =
                    in_range("an attenuation", params.scalar()?, 0.0..=f32::MAX)?;
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
                model.ambient = params.color()?;
            }
            GL_LIGHT_MODEL_LOCAL_VIEWER => model.local_viewer = params.boolean()?,
            GL_LIGHT_MODEL_TWO_SIDE => model.two_side = params.boolean()?,
            GL_LIGHT_MODEL_COLOR_CONTROL => {
                let value = params.enumerant()?;
                let what = "GL_SINGLE_COLOR or GL_SEPARATE_SPECULAR_COLOR";
                model.color_control = known(ColorControl::from_gl(value), value, what)?;
            }
            _ => return Err(wrong_pname("LightModel", pname)),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn material(&mut self, face: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let faces = faces(face)?;
        let change = match (MaterialColor::from_gl(pname), pname) {
            (Some(which), _) => {
                params.vector_only("Material", pname)?;
                MaterialChange::Color(which, params.color()?)
            }
            (None, GL_SHININESS) => MaterialChange::Shininess(in_range("a shininess", params.scalar()?, 0.0..=128.0)?),
            (None, GL_COLOR_INDEXES) => {
                params.vector_only("Material", pname)?;
                MaterialChange::Indexes(params.numbers()?)
            }
            _ => return Err(wrong_pname("Material", pname)),
        };
        // Vertices that were issued before keep the material of their time.
        self.before_material_change();
        for material in chosen(&mut self.state.lighting.materials, faces) {
            match change {
                MaterialChange::Color(which, color) => material.set_color(which, color),
                MaterialChange::Shininess(shininess) => material.shininess = shininess,
                MaterialChange::Indexes(indexes) => material.indexes = indexes,
            }
        }
        self.track_color();
        self.dirty.add(VERTEX);
        Ok(())
    }

    pub(crate) fn color_material(&mut self, face: GLenum, mode: GLenum) -> Outcome {
        let face = faces(face)?;
        let mode = known(MaterialColor::from_gl(mode), mode, "a material colour that can track")?;
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
        for material in chosen(&mut lighting.materials, lighting.color_material_face) {
            material.set_color(lighting.color_material_mode, self.state.current.color);
        }
    }

    pub(crate) fn shade_model(&mut self, mode: GLenum) -> Outcome {
        self.state.lighting.shade_model = known(ShadeModel::from_gl(mode), mode, "GL_FLAT or GL_SMOOTH")?;
        self.dirty = Dirty::ALL;
        Ok(())
    }
}

/// Those of a pair, front and back, that are meant.
pub(crate) fn chosen<T>(of: &mut [T; 2], faces: Face) -> impl Iterator<Item = &mut T> {
    of.iter_mut().zip(faces.chosen()).filter_map(|(of, chosen)| chosen.then_some(of))
}

/// The number of a light by its name.
pub(crate) fn light_index(light: GLenum) -> Outcome<usize> {
    let index = light.wrapping_sub(GL_LIGHT0) as usize;
    if index < MAX_LIGHTS {
        return Ok(index);
    }
    Err(invalid_enum(format!("{} is not a light; there are GL_LIGHT0 to GL_LIGHT{}", name(light), MAX_LIGHTS - 1)))
}
