//! Depth and stencil test state (OpenGL 1.5, sections 4.1.5 and 4.1.6, table 6.20).

use super::compare::CompareFunc;
use crate::enums::gl_enum;

gl_enum! {
    /// What happens to a stencil value.
    #[derive(Default)]
    pub enum StencilOp {
        /// It stays.
        #[default]
        Keep = GL_KEEP,
        /// It becomes 0.
        Zero = GL_ZERO,
        /// It becomes the reference value.
        Replace = GL_REPLACE,
        /// One more, at most the largest value.
        Incr = GL_INCR,
        /// One less, at least 0.
        Decr = GL_DECR,
        /// All bits change.
        Invert = GL_INVERT,
        /// One more, 0 after the largest value.
        IncrWrap = GL_INCR_WRAP,
        /// One less, the largest value after 0.
        DecrWrap = GL_DECR_WRAP,
    }
}

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
    /// What differs between front faces (with points and lines) and back faces of polygons.
    pub faces: [StencilFace; 2],
    /// Reference value.
    pub reference: i32,
    /// Comparison mask.
    pub value_mask: u32,
    /// Which bits are written.
    pub write_mask: u32,
    /// Clear value.
    pub clear: i32,
}

/// The stencil test of the front or the back faces of polygons (ATI_separate_stencil).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StencilFace {
    /// Comparison function.
    pub func: CompareFunc,
    /// Operation where the stencil test fails.
    pub fail: StencilOp,
    /// Operation where the depth test fails.
    pub depth_fail: StencilOp,
    /// Operation where both pass.
    pub depth_pass: StencilOp,
}

impl Default for StencilFace {
    fn default() -> Self {
        let keep = StencilOp::Keep;
        Self { func: CompareFunc::Always, fail: keep, depth_fail: keep, depth_pass: keep }
    }
}

impl Default for Stencil {
    fn default() -> Self {
        Self {
            test: false,
            faces: [StencilFace::default(); 2],
            reference: 0,
            value_mask: u32::MAX,
            write_mask: u32::MAX,
            clear: 0,
        }
    }
}
