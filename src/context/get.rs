//! GetBooleanv and its siblings (OpenGL 1.5, section 6.1.1): one table from name to value, group by group in the order
//! of the state tables 6.5 to 6.32. What a value becomes in the type of the asking command is the business of
//! [`Values`].

use super::Values;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum};
use crate::state::State;
use crate::state::raster::PolygonMode;
use crate::state::texture::Target;
use glam::DMat4;

fn matrix(m: &DMat4) -> Values {
    Values::doubles(&m.to_cols_array())
}

fn transposed(m: &DMat4) -> Values {
    matrix(&m.transpose())
}

/// Current values and transformation (tables 6.5, 6.7).
fn current(s: &State, pname: GLenum) -> Option<Values> {
    let unit = s.texture.active;
    let (c, r, t) = (&s.current, &s.current.raster, &s.transform);
    Some(match pname {
        GL_CURRENT_COLOR => Values::unit(&c.color),
        GL_CURRENT_SECONDARY_COLOR => Values::unit(&c.secondary_color),
        GL_CURRENT_INDEX => Values::float(c.index),
        GL_CURRENT_TEXTURE_COORDS => Values::floats(&c.tex_coord[unit]),
        GL_CURRENT_NORMAL => Values::unit(&c.normal),
        GL_CURRENT_FOG_COORD => Values::float(c.fog_coord),
        GL_EDGE_FLAG => Values::boolean(c.edge_flag),
        GL_CURRENT_RASTER_POSITION => Values::doubles(&r.position),
        GL_CURRENT_RASTER_DISTANCE => Values::float(r.distance),
        GL_CURRENT_RASTER_COLOR => Values::unit(&r.color),
        GL_CURRENT_RASTER_SECONDARY_COLOR => Values::unit(&r.secondary_color),
        GL_CURRENT_RASTER_INDEX => Values::float(r.index),
        GL_CURRENT_RASTER_TEXTURE_COORDS => Values::floats(&r.tex_coord[unit]),
        GL_CURRENT_RASTER_POSITION_VALID => Values::boolean(r.valid),
        GL_MATRIX_MODE => Values::enumerant(t.matrix_mode.gl()),
        GL_MODELVIEW_MATRIX => matrix(t.modelview.top()),
        GL_PROJECTION_MATRIX => matrix(t.projection.top()),
        GL_TEXTURE_MATRIX => matrix(t.texture[unit].top()),
        GL_COLOR_MATRIX => matrix(t.color.top()),
        GL_TRANSPOSE_MODELVIEW_MATRIX => transposed(t.modelview.top()),
        GL_TRANSPOSE_PROJECTION_MATRIX => transposed(t.projection.top()),
        GL_TRANSPOSE_TEXTURE_MATRIX => transposed(t.texture[unit].top()),
        GL_TRANSPOSE_COLOR_MATRIX => transposed(t.color.top()),
        GL_MODELVIEW_STACK_DEPTH => Values::int(t.modelview.depth() as i32),
        GL_PROJECTION_STACK_DEPTH => Values::int(t.projection.depth() as i32),
        GL_TEXTURE_STACK_DEPTH => Values::int(t.texture[unit].depth() as i32),
        GL_COLOR_MATRIX_STACK_DEPTH => Values::int(t.color.depth() as i32),
        GL_VIEWPORT => Values::ints(&[s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height]),
        GL_DEPTH_RANGE => Values::unit_doubles(&[s.viewport.near, s.viewport.far]),
        _ => return None,
    })
}

/// Fog, lighting, points, lines, polygons (tables 6.8 to 6.13).
fn raster(s: &State, pname: GLenum) -> Option<Values> {
    let (l, p) = (&s.lighting, &s.polygon);
    Some(match pname {
        GL_FOG_COLOR => Values::unit(&s.fog.color),
        GL_FOG_INDEX => Values::float(s.fog.index),
        GL_FOG_DENSITY => Values::float(s.fog.density),
        GL_FOG_START => Values::float(s.fog.start),
        GL_FOG_END => Values::float(s.fog.end),
        GL_FOG_MODE => Values::enumerant(s.fog.mode.gl()),
        GL_FOG_COORD_SRC => Values::enumerant(s.fog.coord_source.gl()),
        GL_FOG_DISTANCE_MODE_NV => Values::enumerant(s.fog.distance_mode.gl()),
        GL_SHADE_MODEL => Values::enumerant(l.shade_model.gl()),
        GL_COLOR_MATERIAL_FACE => Values::enumerant(l.color_material_face.gl()),
        GL_COLOR_MATERIAL_PARAMETER => Values::enumerant(l.color_material_mode.gl()),
        GL_LIGHT_MODEL_AMBIENT => Values::unit(&l.model.ambient),
        GL_LIGHT_MODEL_LOCAL_VIEWER => Values::boolean(l.model.local_viewer),
        GL_LIGHT_MODEL_TWO_SIDE => Values::boolean(l.model.two_side),
        GL_LIGHT_MODEL_COLOR_CONTROL => Values::enumerant(l.model.color_control.gl()),
        GL_POINT_SIZE => Values::float(s.point.size),
        GL_POINT_SIZE_MIN => Values::float(s.point.size_min),
        GL_POINT_SIZE_MAX => Values::float(s.point.size_max),
        GL_POINT_FADE_THRESHOLD_SIZE => Values::float(s.point.fade_threshold),
        GL_POINT_DISTANCE_ATTENUATION => Values::floats(&s.point.distance_attenuation),
        GL_LINE_WIDTH => Values::float(s.line.width),
        GL_LINE_STIPPLE_PATTERN => Values::int(i32::from(s.line.stipple_pattern)),
        GL_LINE_STIPPLE_REPEAT => Values::int(s.line.stipple_factor),
        GL_CULL_FACE_MODE => Values::enumerant(p.cull_face.gl()),
        GL_FRONT_FACE => Values::enumerant(p.front_face.gl()),
        GL_POLYGON_MODE => Values::enumerants(&p.mode.map(PolygonMode::gl)),
        GL_POLYGON_OFFSET_FACTOR => Values::float(p.offset_factor),
        GL_POLYGON_OFFSET_UNITS => Values::float(p.offset_units),
        GL_SAMPLE_COVERAGE_VALUE => Values::float(s.multisample.coverage_value),
        GL_SAMPLE_COVERAGE_INVERT => Values::boolean(s.multisample.coverage_invert),
        _ => return None,
    })
}

/// Textures as units see them (tables 6.15, 6.18).
fn texture(s: &State, pname: GLenum) -> Option<Values> {
    let unit = &s.texture.units[s.texture.active];
    let bound = |target: Target| Values::uint(unit.bound[target as usize]);
    Some(match pname {
        GL_ACTIVE_TEXTURE => Values::enumerant(GL_TEXTURE0 + s.texture.active as u32),
        GL_TEXTURE_BINDING_1D => bound(Target::D1),
        GL_TEXTURE_BINDING_2D => bound(Target::D2),
        GL_TEXTURE_BINDING_3D => bound(Target::D3),
        GL_TEXTURE_BINDING_CUBE_MAP => bound(Target::Cube),
        GL_TEXTURE_BINDING_RECTANGLE_ARB => bound(Target::Rectangle),
        _ => return None,
    })
}

/// Per-fragment state and the framebuffer's clear values (tables 6.20, 6.21).
fn fragment(s: &State, pname: GLenum) -> Option<Values> {
    let (c, st) = (&s.color_buffer, &s.stencil);
    Some(match pname {
        GL_SCISSOR_BOX => Values::ints(&[s.scissor.x, s.scissor.y, s.scissor.width, s.scissor.height]),
        GL_ALPHA_TEST_FUNC => Values::enumerant(c.alpha_func.gl()),
        GL_ALPHA_TEST_REF => Values::unit(&[c.alpha_ref]),
        GL_STENCIL_FUNC => Values::enumerant(st.faces[0].func.gl()),
        GL_STENCIL_BACK_FUNC_ATI => Values::enumerant(st.faces[1].func.gl()),
        GL_STENCIL_VALUE_MASK => Values::uint(st.value_mask),
        GL_STENCIL_REF => Values::int(st.reference.clamp(0, 255)),
        GL_STENCIL_FAIL => Values::enumerant(st.faces[0].fail.gl()),
        GL_STENCIL_BACK_FAIL_ATI => Values::enumerant(st.faces[1].fail.gl()),
        GL_STENCIL_PASS_DEPTH_FAIL => Values::enumerant(st.faces[0].depth_fail.gl()),
        GL_STENCIL_BACK_PASS_DEPTH_FAIL_ATI => Values::enumerant(st.faces[1].depth_fail.gl()),
        GL_STENCIL_PASS_DEPTH_PASS => Values::enumerant(st.faces[0].depth_pass.gl()),
        GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI => Values::enumerant(st.faces[1].depth_pass.gl()),
        GL_STENCIL_WRITEMASK => Values::uint(st.write_mask),
        GL_STENCIL_CLEAR_VALUE => Values::int(st.clear),
        GL_DEPTH_FUNC => Values::enumerant(s.depth.func.gl()),
        GL_DEPTH_WRITEMASK => Values::boolean(s.depth.mask),
        GL_DEPTH_CLEAR_VALUE => Values::unit_doubles(&[s.depth.clear]),
        GL_BLEND_SRC | GL_BLEND_SRC_RGB => Values::enumerant(c.blend_src[0].gl()),
        GL_BLEND_SRC_ALPHA => Values::enumerant(c.blend_src[1].gl()),
        GL_BLEND_DST | GL_BLEND_DST_RGB => Values::enumerant(c.blend_dst[0].gl()),
        GL_BLEND_DST_ALPHA => Values::enumerant(c.blend_dst[1].gl()),
        GL_BLEND_EQUATION => Values::enumerant(c.blend_equation[0].gl()),
        GL_BLEND_EQUATION_ALPHA_EXT => Values::enumerant(c.blend_equation[1].gl()),
        GL_BLEND_COLOR => Values::unit(&c.blend_color),
        GL_LOGIC_OP_MODE => Values::enumerant(c.logic_op.gl()),
        GL_COLOR_WRITEMASK => Values::booleans(&c.color_mask),
        GL_INDEX_WRITEMASK => Values::uint(c.index_mask),
        GL_COLOR_CLEAR_VALUE => Values::unit(&c.clear_color),
        GL_INDEX_CLEAR_VALUE => Values::float(c.clear_index),
        GL_DRAW_BUFFER => Values::enumerant(c.draw_buffer.gl()),
        GL_READ_BUFFER => Values::enumerant(s.pixel.read_buffer.gl()),
        GL_ACCUM_CLEAR_VALUE => Values::unit(&s.accum.clear),
        _ => return None,
    })
}

/// Evaluators, hints, lists (tables 6.22, 6.26, 6.27).
fn rest(s: &State, pname: GLenum) -> Option<Values> {
    let (e, h) = (&s.eval, &s.hint);
    Some(match pname {
        GL_MAP1_GRID_DOMAIN => Values::doubles(&[e.grid1.1, e.grid1.2]),
        GL_MAP2_GRID_DOMAIN => Values::doubles(&[e.grid2[0].1, e.grid2[0].2, e.grid2[1].1, e.grid2[1].2]),
        GL_MAP1_GRID_SEGMENTS => Values::int(e.grid1.0),
        GL_MAP2_GRID_SEGMENTS => Values::ints(&[e.grid2[0].0, e.grid2[1].0]),
        GL_PERSPECTIVE_CORRECTION_HINT => Values::enumerant(h.perspective_correction.gl()),
        GL_POINT_SMOOTH_HINT => Values::enumerant(h.point_smooth.gl()),
        GL_LINE_SMOOTH_HINT => Values::enumerant(h.line_smooth.gl()),
        GL_POLYGON_SMOOTH_HINT => Values::enumerant(h.polygon_smooth.gl()),
        GL_FOG_HINT => Values::enumerant(h.fog.gl()),
        GL_GENERATE_MIPMAP_HINT => Values::enumerant(h.generate_mipmap.gl()),
        GL_TEXTURE_COMPRESSION_HINT => Values::enumerant(h.texture_compression.gl()),
        GL_LIST_BASE => Values::uint(s.list_base),
        _ => return None,
    })
}

impl Engine {
    /// The value of a state variable. Names of lists belong to the context, which answers before the engine is asked.
    pub(crate) fn get(&mut self, pname: GLenum) -> Outcome<Values> {
        let s = &self.state;
        if let Some(found) = [current, raster, texture, fragment, rest].iter().find_map(|table| table(s, pname)) {
            return Ok(found);
        }
        if let Some(found) = super::get_limits::limit(pname) {
            return Ok(found);
        }
        if let Some(on) = self.capability(pname) {
            return Ok(Values::boolean(on));
        }
        self.get_objects(pname).ok_or_else(|| {
            invalid_enum(format!("{} is not a state variable that glGet knows (chapter 6 of OpenGL 1.5)", name(pname)))
        })
    }

    /// What hangs on objects, client state, the framebuffer and the stacks.
    fn get_objects(&mut self, pname: GLenum) -> Option<Values> {
        if let Some(value) = self.client.pixel_store.get(pname) {
            let boolean =
                matches!(pname, GL_UNPACK_SWAP_BYTES | GL_PACK_SWAP_BYTES | GL_UNPACK_LSB_FIRST | GL_PACK_LSB_FIRST);
            return Some(if boolean { Values::boolean(value != 0) } else { Values::uint(value) });
        }
        Some(match pname {
            GL_ATTRIB_STACK_DEPTH => Values::int(self.attributes.depth() as i32),
            GL_CLIENT_ATTRIB_STACK_DEPTH => Values::int(self.client_attributes.len() as i32),
            GL_POLYGON_OFFSET_BIAS_EXT => {
                Values::float((f64::from(self.state.polygon.offset_units) / self.depth_units()) as f32)
            }
            GL_ZOOM_X => Values::float(self.state.pixel.zoom[0]),
            GL_ZOOM_Y => Values::float(self.state.pixel.zoom[1]),
            _ => {
                return self
                    .pixel_value(pname)
                    .or_else(|| self.framebuffer_value(pname))
                    .or_else(|| self.render_mode_value(pname))
                    .or_else(|| self.array_value(pname));
            }
        })
    }
}
