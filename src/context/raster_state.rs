//! Commands of rasterisation and viewport state (OpenGL 1.5, sections 2.11.1, 2.12, 2.13, 3.3 to 3.5, 3.10, 4.1.2, 5.6):
//! points, lines, polygons, culling, viewport, depth range, clip planes, scissor, fog and hints.

use super::Params;
use super::engine::Engine;
use super::lighting_state::{chosen, faces};
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_value, too_short};
use crate::limits::{MAX_CLIP_PLANES, MAX_VIEWPORT_DIM};
use crate::num::clamp01;
use crate::state::Dirty;
use crate::state::fog::{FogCoordSource, FogDistanceMode, FogMode};
use crate::state::raster::{Face, HintMode, PolygonMode, Winding};
use glam::{DMat4, DVec4};

const RASTER: Dirty = Dirty { vertex: false, fragment: false, raster: true };

/// `Ok` where a size is greater than 0 (and a number).
fn positive(what: &str, value: f32) -> Outcome {
    if value > 0.0 { Ok(()) } else { Err(invalid_value(format!("a {what} of {value}; it must be greater than 0"))) }
}

/// The value that an enumerant was found to stand for, or `INVALID_ENUM` with all names.
fn one_of<T, const N: usize>(found: Option<T>, value: GLenum, names: [&str; N], what: &str) -> Outcome<T> {
    found.ok_or_else(|| invalid_enum(format!("{} is not a {what}; it is one of {}", name(value), names.join(", "))))
}

impl Engine {
    pub(crate) fn point_size(&mut self, size: f32) -> Outcome {
        positive("point size", size)?;
        self.state.point.size = size;
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn point_parameter(&mut self, pname: GLenum, params: &Params) -> Outcome {
        let point = &mut self.state.point;
        match pname {
            GL_POINT_SIZE_MIN | GL_POINT_SIZE_MAX | GL_POINT_FADE_THRESHOLD_SIZE => {
                let value = params.scalar()?;
                if value.is_nan() || value < 0.0 {
                    return Err(invalid_value(format!("{} of {value}; it must not be negative", name(pname))));
                }
                match pname {
                    GL_POINT_SIZE_MIN => point.size_min = value,
                    GL_POINT_SIZE_MAX => point.size_max = value,
                    _ => point.fade_threshold = value,
                }
            }
            GL_POINT_DISTANCE_ATTENUATION => {
                params.vector_only("PointParameter", pname)?;
                point.distance_attenuation = params.numbers()?;
            }
            _ => return Err(invalid_enum(format!("{} is not a point parameter", name(pname)))),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn line_width(&mut self, width: f32) -> Outcome {
        positive("line width", width)?;
        self.state.line.width = width;
        self.dirty.add(RASTER);
        Ok(())
    }

    pub(crate) fn line_stipple(&mut self, factor: i32, pattern: u16) {
        self.state.line.stipple_factor = factor.clamp(1, 256);
        self.state.line.stipple_pattern = pattern;
        self.dirty.add(RASTER);
    }

    pub(crate) fn polygon_mode(&mut self, face: GLenum, mode: GLenum) -> Outcome {
        let faces = faces(face)?;
        let mode = one_of(PolygonMode::from_gl(mode), mode, PolygonMode::ALL.map(PolygonMode::name), "polygon mode")?;
        for to in chosen(&mut self.state.polygon.mode, faces) {
            *to = mode;
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn polygon_offset(&mut self, factor: f32, units: f32) {
        self.state.polygon.offset_factor = factor;
        self.state.polygon.offset_units = units;
        self.dirty.add(RASTER);
    }

    /// The same with the constant part in depths instead of smallest differences.
    pub(crate) fn polygon_offset_ext(&mut self, factor: f32, bias: f32) {
        let units = bias * self.depth_units() as f32;
        self.polygon_offset(factor, units);
    }

    /// How many units of polygon offset the range of depths has.
    pub(crate) fn depth_units(&self) -> f64 {
        f64::from(self.framebuffer.format().depth_max())
    }

    /// The pattern, already unpacked: 32 rows, lowest first, the highest bit of a row leftmost.
    pub(crate) fn set_polygon_stipple(&mut self, rows: [u32; 32]) {
        self.state.polygon_stipple.0 = rows;
        self.dirty.add(RASTER);
    }

    pub(crate) fn cull_face(&mut self, face: GLenum) -> Outcome {
        let face = one_of(Face::from_gl(face), face, Face::ALL.map(Face::name), "face")?;
        self.state.polygon.cull_face = face;
        self.dirty.add(RASTER);
        Ok(())
    }

    pub(crate) fn front_face(&mut self, winding: GLenum) -> Outcome {
        let winding = one_of(Winding::from_gl(winding), winding, Winding::ALL.map(Winding::name), "winding")?;
        self.state.polygon.front_face = winding;
        self.dirty.add(RASTER);
        Ok(())
    }

    pub(crate) fn viewport(&mut self, x: i32, y: i32, width: i32, height: i32) -> Outcome {
        if width < 0 || height < 0 {
            return Err(invalid_value(format!("a viewport of {width} by {height}; neither may be negative")));
        }
        let viewport = &mut self.state.viewport;
        let limit = MAX_VIEWPORT_DIM as i32;
        (viewport.x, viewport.y) = (x, y);
        (viewport.width, viewport.height) = (width.min(limit), height.min(limit));
        self.dirty.add(Dirty { vertex: true, fragment: false, raster: true });
        Ok(())
    }

    pub(crate) fn depth_range(&mut self, near: f64, far: f64) {
        self.state.viewport.near = near.max(0.0).min(1.0);
        self.state.viewport.far = far.max(0.0).min(1.0);
        self.dirty.add(Dirty { vertex: true, fragment: false, raster: true });
    }

    pub(crate) fn scissor(&mut self, x: i32, y: i32, width: i32, height: i32) -> Outcome {
        if width < 0 || height < 0 {
            return Err(invalid_value(format!("a scissor box of {width} by {height}; neither may be negative")));
        }
        let scissor = &mut self.state.scissor;
        (scissor.x, scissor.y, scissor.width, scissor.height) = (x, y, width, height);
        self.dirty.add(RASTER);
        Ok(())
    }

    /// The plane is kept in eye coordinates: times the inverse of the modelview matrix of now. Where that matrix has no
    /// inverse the plane becomes (0, 0, 0, 0), which everything is inside of.
    pub(crate) fn clip_plane(&mut self, plane: GLenum, equation: &[f64]) -> Outcome {
        let index = clip_plane_index(plane)?;
        let equation = equation.first_chunk().ok_or_else(|| too_short("equation", 4, equation.len(), "values"))?;
        self.state.transform.clip_planes[index] = to_eye_plane(self.state.transform.modelview.top(), *equation);
        self.dirty.add(Dirty { vertex: true, fragment: false, raster: false });
        Ok(())
    }

    pub(crate) fn fog(&mut self, pname: GLenum, params: &Params) -> Outcome {
        let fog = &mut self.state.fog;
        match pname {
            GL_FOG_MODE => {
                let mode = params.enumerant()?;
                fog.mode = one_of(FogMode::from_gl(mode), mode, FogMode::ALL.map(FogMode::name), "fog mode")?;
            }
            GL_FOG_COORD_SRC => {
                let source = params.enumerant()?;
                let names = FogCoordSource::ALL.map(FogCoordSource::name);
                fog.coord_source = one_of(FogCoordSource::from_gl(source), source, names, "fog coordinate source")?;
            }
            GL_FOG_DISTANCE_MODE_NV => {
                let mode = params.enumerant()?;
                let names = FogDistanceMode::ALL.map(FogDistanceMode::name);
                fog.distance_mode = one_of(FogDistanceMode::from_gl(mode), mode, names, "fog distance mode")?;
            }
            GL_FOG_COLOR => {
                params.vector_only("Fog", pname)?;
                fog.color = params.color()?.map(clamp01);
            }
            GL_FOG_DENSITY => {
                let density = params.scalar()?;
                if density.is_nan() || density < 0.0 {
                    return Err(invalid_value(format!("a fog density of {density}; it must not be negative")));
                }
                fog.density = density;
            }
            GL_FOG_START => fog.start = params.scalar()?,
            GL_FOG_END => fog.end = params.scalar()?,
            GL_FOG_INDEX => fog.index = params.scalar()?,
            _ => return Err(invalid_enum(format!("{} is not a fog parameter", name(pname)))),
        }
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn hint(&mut self, target: GLenum, mode: GLenum) -> Outcome {
        let mode = one_of(HintMode::from_gl(mode), mode, HintMode::ALL.map(HintMode::name), "hint")?;
        let hint = &mut self.state.hint;
        let place = match target {
            GL_PERSPECTIVE_CORRECTION_HINT => &mut hint.perspective_correction,
            GL_POINT_SMOOTH_HINT => &mut hint.point_smooth,
            GL_LINE_SMOOTH_HINT => &mut hint.line_smooth,
            GL_POLYGON_SMOOTH_HINT => &mut hint.polygon_smooth,
            GL_FOG_HINT => &mut hint.fog,
            GL_GENERATE_MIPMAP_HINT => &mut hint.generate_mipmap,
            GL_TEXTURE_COMPRESSION_HINT => &mut hint.texture_compression,
            _ => return Err(invalid_enum(format!("{} is not something that takes a hint", name(target)))),
        };
        *place = mode;
        self.dirty = Dirty::ALL;
        Ok(())
    }

    pub(crate) fn sample_coverage(&mut self, value: f32, invert: bool) {
        self.state.multisample.coverage_value = clamp01(value);
        self.state.multisample.coverage_invert = invert;
        self.dirty.add(Dirty { vertex: false, fragment: true, raster: false });
    }
}

/// The number of a user clip plane by its name.
pub(crate) fn clip_plane_index(plane: GLenum) -> Outcome<usize> {
    let index = plane.wrapping_sub(GL_CLIP_PLANE0) as usize;
    if index < MAX_CLIP_PLANES {
        return Ok(index);
    }
    Err(invalid_enum(format!(
        "{} is not a clip plane; there are GL_CLIP_PLANE0 to GL_CLIP_PLANE{}",
        name(plane),
        MAX_CLIP_PLANES - 1
    )))
}

/// A plane (a row vector) times the inverse of a matrix, or zeros where the matrix has no finite inverse.
pub(crate) fn to_eye_plane(modelview: &DMat4, plane: [f64; 4]) -> [f64; 4] {
    let eye = modelview.inverse().transpose() * DVec4::from_array(plane);
    if eye.is_finite() { eye.to_array() } else { [0.0; 4] }
}
