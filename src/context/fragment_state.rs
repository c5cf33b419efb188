//! Commands of per-fragment state (OpenGL 1.5, sections 4.1 and 4.2): alpha, stencil and depth tests, blending, logic
//! op, masks, clear values, draw and read buffer.

use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, known};
use crate::num::clamp01;
use crate::state::Dirty;
use crate::state::compare::CompareFunc;

const FRAGMENT: Dirty = Dirty { vertex: false, fragment: true, raster: false };

fn compare_function(func: GLenum) -> Outcome<CompareFunc> {
    known(CompareFunc::from_gl(func), func, "a comparison function (GL_NEVER to GL_ALWAYS)")
}

fn blend_factor(factor: GLenum, source: bool) -> Outcome {
    let both = matches!(
        factor,
        GL_ZERO
            | GL_ONE
            | GL_SRC_COLOR
            | GL_ONE_MINUS_SRC_COLOR
            | GL_DST_COLOR
            | GL_ONE_MINUS_DST_COLOR
            | GL_SRC_ALPHA
            | GL_ONE_MINUS_SRC_ALPHA
            | GL_DST_ALPHA
            | GL_ONE_MINUS_DST_ALPHA
            | GL_CONSTANT_COLOR
            | GL_ONE_MINUS_CONSTANT_COLOR
            | GL_CONSTANT_ALPHA
            | GL_ONE_MINUS_CONSTANT_ALPHA
    );
    if both || (source && factor == GL_SRC_ALPHA_SATURATE) {
        return Ok(());
    }
    let side = if source { "source" } else { "destination" };
    Err(invalid_enum(format!("{} is not a {side} blend factor", name(factor))))
}

impl Engine {
    pub(crate) fn alpha_func(&mut self, func: GLenum, reference: f32) -> Outcome {
        self.state.color_buffer.alpha_func = compare_function(func)?;
        self.state.color_buffer.alpha_ref = clamp01(reference);
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn blend_func(&mut self, src: GLenum, dst: GLenum) -> Outcome {
        self.blend_func_separate(src, dst, src, dst)
    }

    pub(crate) fn blend_func_separate(&mut self, src: GLenum, dst: GLenum, src_a: GLenum, dst_a: GLenum) -> Outcome {
        blend_factor(src, true)?;
        blend_factor(dst, false)?;
        blend_factor(src_a, true)?;
        blend_factor(dst_a, false)?;
        self.state.color_buffer.blend_src = [src, src_a];
        self.state.color_buffer.blend_dst = [dst, dst_a];
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn blend_equation(&mut self, mode: GLenum) -> Outcome {
        match mode {
            GL_FUNC_ADD | GL_FUNC_SUBTRACT | GL_FUNC_REVERSE_SUBTRACT | GL_MIN | GL_MAX => {}
            _ => return Err(invalid_enum(format!("{} is not a blend equation", name(mode)))),
        }
        self.state.color_buffer.blend_equation = mode;
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn blend_color(&mut self, r: f32, g: f32, b: f32, a: f32) {
        self.state.color_buffer.blend_color = [r, g, b, a].map(clamp01);
        self.dirty.add(FRAGMENT);
    }

    pub(crate) fn depth_func(&mut self, func: GLenum) -> Outcome {
        self.state.depth.func = compare_function(func)?;
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn depth_mask(&mut self, on: bool) {
        self.state.depth.mask = on;
        self.dirty.add(FRAGMENT);
    }

    pub(crate) fn stencil_func(&mut self, func: GLenum, reference: i32, mask: u32) -> Outcome {
        let func = compare_function(func)?;
        let stencil = &mut self.state.stencil;
        (stencil.func, stencil.reference, stencil.value_mask) = (func, reference, mask);
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn stencil_op(&mut self, fail: GLenum, depth_fail: GLenum, depth_pass: GLenum) -> Outcome {
        for op in [fail, depth_fail, depth_pass] {
            match op {
                GL_KEEP | GL_ZERO | GL_REPLACE | GL_INCR | GL_DECR | GL_INVERT | GL_INCR_WRAP | GL_DECR_WRAP => {}
                _ => return Err(invalid_enum(format!("{} is not a stencil operation", name(op)))),
            }
        }
        let stencil = &mut self.state.stencil;
        (stencil.fail, stencil.depth_fail, stencil.depth_pass) = (fail, depth_fail, depth_pass);
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn stencil_mask(&mut self, mask: u32) {
        self.state.stencil.write_mask = mask;
        self.dirty.add(FRAGMENT);
    }

    pub(crate) fn logic_op(&mut self, op: GLenum) -> Outcome {
        if !(GL_CLEAR..=GL_SET).contains(&op) {
            return Err(invalid_enum(format!("{} is not a logic operation (GL_CLEAR to GL_SET)", name(op))));
        }
        self.state.color_buffer.logic_op = op;
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn color_mask(&mut self, r: bool, g: bool, b: bool, a: bool) {
        self.state.color_buffer.color_mask = [r, g, b, a];
        self.dirty.add(FRAGMENT);
    }

    pub(crate) fn index_mask(&mut self, mask: u32) {
        self.state.color_buffer.index_mask = mask;
    }

    pub(crate) fn clear_color(&mut self, r: f32, g: f32, b: f32, a: f32) {
        self.state.color_buffer.clear_color = [r, g, b, a].map(clamp01);
    }

    pub(crate) fn clear_index(&mut self, index: f32) {
        self.state.color_buffer.clear_index = index;
    }

    pub(crate) fn clear_depth(&mut self, depth: f64) {
        self.state.depth.clear = depth.max(0.0).min(1.0);
    }

    pub(crate) fn clear_stencil(&mut self, value: i32) {
        self.state.stencil.clear = value;
    }

    pub(crate) fn clear_accum(&mut self, r: f32, g: f32, b: f32, a: f32) {
        self.state.accum.clear = [r, g, b, a].map(|v| v.max(-1.0).min(1.0));
    }

    /// The framebuffer has one colour buffer, the front left one.
    pub(crate) fn draw_buffer(&mut self, buffer: GLenum) -> Outcome {
        if buffer != GL_NONE {
            one_colour_buffer(buffer)?;
        }
        self.state.color_buffer.draw_buffer = buffer;
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn read_buffer(&mut self, buffer: GLenum) -> Outcome {
        one_colour_buffer(buffer)?;
        self.state.pixel.read_buffer = buffer;
        Ok(())
    }
}

/// Whether a buffer name means the front left buffer, the only one there is.
fn one_colour_buffer(buffer: GLenum) -> Outcome {
    match buffer {
        GL_FRONT | GL_FRONT_LEFT | GL_LEFT | GL_FRONT_AND_BACK => Ok(()),
        GL_BACK | GL_BACK_LEFT | GL_RIGHT | GL_FRONT_RIGHT | GL_BACK_RIGHT | GL_AUX0 | GL_AUX1 | GL_AUX2 | GL_AUX3 => {
            Err(invalid_operation(format!(
                "there is no buffer {}: the framebuffer has one colour buffer, GL_FRONT_LEFT",
                name(buffer)
            )))
        }
        _ => Err(invalid_enum(format!("{} is not the name of a colour buffer", name(buffer)))),
    }
}
