//! Commands of per-fragment state (OpenGL 1.5, sections 4.1 and 4.2): alpha, stencil and depth tests, blending, logic
//! op, masks, clear values, draw and read buffer.

use super::engine::Engine;
use crate::enums::{GL_FRONT_AND_BACK, GL_NONE, GLenum};
use crate::error::{Outcome, invalid_operation, known, not_one};
use crate::num::clamp01;
use crate::state::Dirty;
use crate::state::color_buffer::{BlendEquation, BlendFactor, ColorBufferName, LogicOp};
use crate::state::compare::CompareFunc;
use crate::state::depth_stencil::StencilOp;
use crate::state::raster::Face;

const FRAGMENT: Dirty = Dirty { vertex: false, fragment: true, raster: false };

fn compare_function(func: GLenum) -> Outcome<CompareFunc> {
    known(CompareFunc::from_gl(func), func, "a comparison function (GL_NEVER to GL_ALWAYS)")
}

fn source_factor(factor: GLenum) -> Outcome<BlendFactor> {
    known(BlendFactor::from_gl(factor), factor, "a source blend factor")
}

fn destination_factor(factor: GLenum) -> Outcome<BlendFactor> {
    let found = BlendFactor::from_gl(factor).filter(|factor| *factor != BlendFactor::SrcAlphaSaturate);
    known(found, factor, "a destination blend factor")
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
        let (src, dst) = (source_factor(src)?, destination_factor(dst)?);
        let (src_a, dst_a) = (source_factor(src_a)?, destination_factor(dst_a)?);
        self.state.color_buffer.blend_src = [src, src_a];
        self.state.color_buffer.blend_dst = [dst, dst_a];
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn blend_equation(&mut self, mode: GLenum) -> Outcome {
        self.blend_equation_separate(mode, mode)
    }

    pub(crate) fn blend_equation_separate(&mut self, rgb: GLenum, alpha: GLenum) -> Outcome {
        let equation = |mode| known(BlendEquation::from_gl(mode), mode, "a blend equation");
        self.state.color_buffer.blend_equation = [equation(rgb)?, equation(alpha)?];
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
        self.stencil_func_separate(func, func, reference, mask)
    }

    /// The reference value and the mask are those of both faces.
    pub(crate) fn stencil_func_separate(&mut self, front: GLenum, back: GLenum, reference: i32, mask: u32) -> Outcome {
        let (front, back) = (compare_function(front)?, compare_function(back)?);
        let stencil = &mut self.state.stencil;
        (stencil.faces[0].func, stencil.faces[1].func) = (front, back);
        (stencil.reference, stencil.value_mask) = (reference, mask);
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn stencil_op(&mut self, fail: GLenum, depth_fail: GLenum, depth_pass: GLenum) -> Outcome {
        self.stencil_op_separate(GL_FRONT_AND_BACK, fail, depth_fail, depth_pass)
    }

    pub(crate) fn stencil_op_separate(
        &mut self,
        face: GLenum,
        fail: GLenum,
        depth_fail: GLenum,
        depth_pass: GLenum,
    ) -> Outcome {
        let chosen = known(Face::from_gl(face), face, "a face: GL_FRONT, GL_BACK or GL_FRONT_AND_BACK")?.chosen();
        let op = |op| known(StencilOp::from_gl(op), op, "a stencil operation");
        let (fail, depth_fail, depth_pass) = (op(fail)?, op(depth_fail)?, op(depth_pass)?);
        for (face, _) in self.state.stencil.faces.iter_mut().zip(chosen).filter(|(_, chosen)| *chosen) {
            (face.fail, face.depth_fail, face.depth_pass) = (fail, depth_fail, depth_pass);
        }
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn stencil_mask(&mut self, mask: u32) {
        self.state.stencil.write_mask = mask;
        self.dirty.add(FRAGMENT);
    }

    pub(crate) fn logic_op(&mut self, op: GLenum) -> Outcome {
        let op = known(LogicOp::from_gl(op), op, "a logic operation (GL_CLEAR to GL_SET)")?;
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

    /// The framebuffer has one colour buffer: front and back are the same.
    pub(crate) fn draw_buffer(&mut self, buffer: GLenum) -> Outcome {
        let none = buffer == GL_NONE;
        let buffer = if none { ColorBufferName::None } else { one_colour_buffer(buffer)? };
        self.state.color_buffer.draw_buffer = buffer;
        self.dirty.add(FRAGMENT);
        Ok(())
    }

    pub(crate) fn read_buffer(&mut self, buffer: GLenum) -> Outcome {
        self.state.pixel.read_buffer = one_colour_buffer(buffer)?;
        Ok(())
    }
}

/// The colour buffer of a name, which must mean the only one there is.
fn one_colour_buffer(buffer: GLenum) -> Outcome<ColorBufferName> {
    match ColorBufferName::from_gl(buffer) {
        None | Some(ColorBufferName::None) => Err(not_one(buffer, "the name of a colour buffer")),
        Some(name) if name.exists() => Ok(name),
        Some(name) => Err(invalid_operation(format!(
            "there is no buffer {}: the framebuffer has one colour buffer, GL_FRONT_LEFT or GL_BACK_LEFT",
            name.name()
        ))),
    }
}
