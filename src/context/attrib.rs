//! Attribute stacks (OpenGL 1.5, section 6.1.14, tables 6.3 and 6.4): PushAttrib copies the groups of state that a mask
//! names, PopAttrib puts them back. Groups hold nothing derived, so that is all there is to it; the enables of a group
//! travel with it, and `GL_ENABLE_BIT` keeps the enables of all groups.

use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, stack_overflow, stack_underflow};
use crate::limits::{MAX_ATTRIB_STACK_DEPTH, MAX_CLIENT_ATTRIB_STACK_DEPTH};
use crate::state::texture::TextureState;
use crate::state::{Dirty, State};

macro_rules! groups {
    ($to:expr, $from:expr, $mask:expr; $($bit:ident: $($($field:ident).+),+;)*) => {
        $(if $mask & $bit != 0 { $($to.$($field).+ = $from.$($field).+;)+ })*
    };
}

/// Copies the groups that a mask names (table 6.3 and the "Attribute" column of the state tables).
fn copy_groups(to: &mut State, from: &State, mask: u32) {
    groups! { to, from, mask;
        GL_CURRENT_BIT: current;
        GL_POINT_BIT: point;
        GL_LINE_BIT: line;
        GL_POLYGON_BIT: polygon;
        GL_POLYGON_STIPPLE_BIT: polygon_stipple;
        GL_PIXEL_MODE_BIT: pixel.transfer, pixel.zoom, pixel.read_buffer, pixel.imaging;
        GL_LIGHTING_BIT: lighting;
        GL_FOG_BIT: fog;
        GL_DEPTH_BUFFER_BIT: depth;
        GL_ACCUM_BUFFER_BIT: accum;
        GL_STENCIL_BUFFER_BIT: stencil;
        GL_VIEWPORT_BIT: viewport;
        GL_TRANSFORM_BIT: transform.matrix_mode, transform.clip_planes, transform.clip_plane_enabled,
            transform.normalize, transform.rescale_normal;
        GL_COLOR_BUFFER_BIT: color_buffer;
        GL_HINT_BIT: hint;
        GL_EVAL_BIT: eval.auto_normal, eval.map1_enabled, eval.map2_enabled, eval.grid1, eval.grid2;
        GL_LIST_BIT: list_base;
        GL_TEXTURE_BIT: texture;
        GL_SCISSOR_BIT: scissor;
        GL_MULTISAMPLE_BIT: multisample;
        GL_ENABLE_BIT: color_buffer.alpha_test, color_buffer.blend, color_buffer.dither,
            color_buffer.logic_op_enabled, color_buffer.index_logic_op_enabled, eval.auto_normal, eval.map1_enabled,
            eval.map2_enabled, lighting.color_material, lighting.enabled, polygon.cull, polygon.smooth,
            polygon.stipple, polygon.offset, depth.test, stencil.test, fog.enabled, fog.color_sum, line.smooth,
            line.stipple, point.smooth, point.sprite, transform.normalize, transform.rescale_normal, transform.clip_plane_enabled,
            scissor.enabled, multisample.enabled, multisample.alpha_to_coverage, multisample.alpha_to_one,
            multisample.coverage, pixel.imaging.tables, pixel.imaging.convolutions, pixel.imaging.histogram,
            pixel.imaging.minmax;
    }
    if mask & GL_ENABLE_BIT != 0 {
        for (to, from) in to.lighting.lights.iter_mut().zip(&from.lighting.lights) {
            to.enabled = from.enabled;
        }
        copy_texture_enables(&mut to.texture, &from.texture);
    }
    // The colour sum is listed with fog and with enables; the enable of the colour material belongs to lighting.
}

fn copy_texture_enables(to: &mut TextureState, from: &TextureState) {
    for (to, from) in to.units.iter_mut().zip(&from.units) {
        to.enabled = from.enabled;
        for (to, from) in to.generation.iter_mut().zip(&from.generation) {
            to.enabled = from.enabled;
        }
    }
}

/// Groups that no plan is made of.
const IN_NO_PLAN: u32 =
    GL_CURRENT_BIT | GL_PIXEL_MODE_BIT | GL_ACCUM_BUFFER_BIT | GL_HINT_BIT | GL_EVAL_BIT | GL_LIST_BIT;

impl Engine {
    pub(crate) fn push_attrib(&mut self, mask: u32) -> Outcome {
        let saved = self.attributes.push().ok_or_else(|| {
            stack_overflow(format!(
                "the attribute stack is full: it holds {MAX_ATTRIB_STACK_DEPTH} groups; pop one first"
            ))
        })?;
        saved.mask = mask;
        copy_groups(&mut saved.state, &self.state, mask);
        saved.parameters.clear();
        if mask & GL_TEXTURE_BIT != 0 {
            self.textures.bound_parameters(&self.state.texture, &mut saved.parameters);
        }
        Ok(())
    }

    pub(crate) fn pop_attrib(&mut self) -> Outcome {
        let saved = self.attributes.pop().ok_or_else(|| {
            stack_underflow("the attribute stack is empty; every glPopAttrib needs a glPushAttrib before it")
        })?;
        copy_groups(&mut self.state, &saved.state, saved.mask);
        for (name, target, parameters) in saved.parameters.drain(..) {
            self.textures.restore_parameters(name, target, parameters);
        }
        if saved.mask & GL_TEXTURE_BIT != 0 {
            self.textures.forget_deleted_bindings(&mut self.state.texture);
        }
        let mask = saved.mask;
        // A colour, a material or the enable that came back: what tracks the colour follows at once.
        if mask & (GL_CURRENT_BIT | GL_LIGHTING_BIT | GL_ENABLE_BIT) != 0 {
            self.track_color();
        }
        if mask & !IN_NO_PLAN != 0 {
            self.dirty = Dirty::ALL;
        }
        Ok(())
    }

    pub(crate) fn push_client_attrib(&mut self, mask: u32) -> Outcome {
        if self.client_attributes.len() >= MAX_CLIENT_ATTRIB_STACK_DEPTH {
            return Err(stack_overflow(format!(
                "the client attribute stack is full: it holds {MAX_CLIENT_ATTRIB_STACK_DEPTH} groups; pop one first"
            )));
        }
        self.client_attributes.push((mask, self.client.clone()));
        Ok(())
    }

    pub(crate) fn pop_client_attrib(&mut self) -> Outcome {
        let (mask, saved) = self.client_attributes.pop().ok_or_else(|| {
            stack_underflow("the client attribute stack is empty; every pop needs a glPushClientAttrib before it")
        })?;
        if mask & GL_CLIENT_PIXEL_STORE_BIT != 0 {
            self.client.pixel_store = saved.pixel_store;
        }
        if mask & GL_CLIENT_VERTEX_ARRAY_BIT != 0 {
            // The object that was bound is bound again, unless it has been deleted.
            self.bind_vertex_array(saved.arrays.object)?;
            self.client.arrays = saved.arrays;
        }
        Ok(())
    }
}
