//! Depth and stencil test state (OpenGL 1.5, sections 4.1.5 and 4.1.6, table 6.20).

use super::compare::CompareFunc;
use crate::enums::{GL_KEEP, GLenum};

/// Depth test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depth {
    /// `GL_DEPTH_TEST`.
    pub test: bool,
    /// Comparison function.
    pub func: CompareFunc,
    /// Whether the depth buffer is written.
    pub mask: bool,
    /// Clear value in [0, 1].
    pub clear: f64,
}

impl Default for Depth {
    fn default() -> Self {
        Self { test: false, func: CompareFunc::Less, mask: true, clear: 1.0 }
    }
}

/// Stencil test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stencil {
    /// `GL_STENCIL_TEST`.
    pub test: bool,
    /// Comparison function.
    pub func: CompareFunc,
    /// Reference value.
    pub reference: i32,
    /// Comparison mask.
    pub value_mask: u32,
    /// Operation where the stencil test fails.
    pub fail: GLenum,
    /// Operation where the depth test fails.
    pub depth_fail: GLenum,
    /// Operation where both pass.
    pub depth_pass: GLenum,
    /// Which bits are written.
    pub write_mask: u32,
    /// Clear value.
    pub clear: i32,
}

impl Default for Stencil {
    fn default() -> Self {
        Self {
            test: false,
            func: CompareFunc::Always,
            reference: 0,
            value_mask: u32::MAX,
            fail: GL_KEEP,
            depth_fail: GL_KEEP,
            depth_pass: GL_KEEP,
            write_mask: u32::MAX,
            clear: 0,
        }
    }
}
