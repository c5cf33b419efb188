//! Per-fragment and whole-framebuffer state (OpenGL 1.5, sections 4.1 and 4.2, tables 6.20 and 6.21): scissor, alpha
//! test, blending, logic op, masks, clear values.

use super::compare::CompareFunc;
use crate::enums::{GL_COPY, GL_FRONT, GL_FUNC_ADD, GL_ONE, GL_ZERO, GLenum};

/// The scissor box. The context sets its initial size to the window's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scissor {
    /// `GL_SCISSOR_TEST`.
    pub enabled: bool,
    /// Left edge.
    pub x: i32,
    /// Lower edge.
    pub y: i32,
    /// Width.
    pub width: i32,
    /// Height.
    pub height: i32,
}

/// Colour buffer state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorBuffer {
    /// `GL_ALPHA_TEST`.
    pub alpha_test: bool,
    /// Alpha comparison function.
    pub alpha_func: CompareFunc,
    /// Alpha reference in [0, 1].
    pub alpha_ref: f32,
    /// `GL_BLEND`.
    pub blend: bool,
    /// Source factors for RGB and alpha.
    pub blend_src: [GLenum; 2],
    /// Destination factors for RGB and alpha.
    pub blend_dst: [GLenum; 2],
    /// Blend equation (GL 1.5 has one for RGB and alpha).
    pub blend_equation: GLenum,
    /// Constant blend colour.
    pub blend_color: [f32; 4],
    /// `GL_DITHER`.
    pub dither: bool,
    /// `GL_COLOR_LOGIC_OP`.
    pub logic_op_enabled: bool,
    /// `GL_INDEX_LOGIC_OP`.
    pub index_logic_op_enabled: bool,
    /// The logic operation.
    pub logic_op: GLenum,
    /// Which colour channels are written.
    pub color_mask: [bool; 4],
    /// Which index bits are written.
    pub index_mask: u32,
    /// Clear colour in [0, 1].
    pub clear_color: [f32; 4],
    /// Clear index.
    pub clear_index: f32,
    /// Which buffer is drawn into; the context sets the initial value.
    pub draw_buffer: GLenum,
}

impl Default for ColorBuffer {
    fn default() -> Self {
        Self {
            alpha_test: false,
            alpha_func: CompareFunc::Always,
            alpha_ref: 0.0,
            blend: false,
            blend_src: [GL_ONE; 2],
            blend_dst: [GL_ZERO; 2],
            blend_equation: GL_FUNC_ADD,
            blend_color: [0.0; 4],
            dither: true,
            logic_op_enabled: false,
            index_logic_op_enabled: false,
            logic_op: GL_COPY,
            color_mask: [true; 4],
            index_mask: u32::MAX,
            clear_color: [0.0; 4],
            clear_index: 0.0,
            draw_buffer: GL_FRONT,
        }
    }
}

/// Accumulation buffer state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accum {
    /// Clear value in [-1, 1].
    pub clear: [f32; 4],
}
