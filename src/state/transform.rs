//! Coordinate transformation state (OpenGL 1.5, sections 2.11 and 2.12, table 6.7): the matrix stacks in f64, the user
//! clip planes in eye coordinates, viewport and depth range. f64 keeps a matrix right after hundreds of thousands of
//! incremental rotations.

use super::per_unit::PerUnit;
use crate::enums::gl_enum;
use crate::limits::MAX_CLIP_PLANES;
use glam::DMat4;

gl_enum! {
    /// Which stack the matrix commands address.
    pub enum MatrixMode {
        Modelview = GL_MODELVIEW,
        Projection = GL_PROJECTION,
        Texture = GL_TEXTURE,
        Color = GL_COLOR,
    }
}

/// A matrix stack: the last element is the current matrix; there is always one.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixStack {
    top: DMat4,
    below: Vec<DMat4>,
    /// How many matrices the stack may hold.
    pub limit: usize,
}

impl MatrixStack {
    /// A stack of one identity matrix that may grow to `limit`.
    #[must_use]
    pub const fn new(limit: usize) -> Self {
        Self { top: DMat4::IDENTITY, below: Vec::new(), limit }
    }

    /// The current matrix.
    #[must_use]
    pub const fn top(&self) -> &DMat4 {
        &self.top
    }

    /// The current matrix, to be changed.
    pub const fn top_mut(&mut self) -> &mut DMat4 {
        &mut self.top
    }

    /// How many matrices the stack holds, at least 1.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.below.len() + 1
    }

    /// Duplicates the current matrix; false, with nothing changed, where the stack is full.
    #[must_use]
    pub fn push(&mut self) -> bool {
        let room = self.depth() < self.limit;
        if room {
            self.below.push(self.top);
        }
        room
    }

    /// Drops the current matrix; false, with nothing changed, where it is the last one.
    #[must_use]
    pub fn pop(&mut self) -> bool {
        self.below.pop().map(|matrix| self.top = matrix).is_some()
    }
}

/// Matrices, clip planes, normal treatment.
#[derive(Clone, Debug, PartialEq)]
pub struct Transform {
    /// Which stack the matrix commands address: modelview, projection, texture or colour.
    pub matrix_mode: MatrixMode,
    /// Modelview stack.
    pub modelview: MatrixStack,
    /// Projection stack.
    pub projection: MatrixStack,
    /// Texture stack of each unit.
    pub texture: PerUnit<MatrixStack>,
    /// Colour matrix stack (ARB_imaging).
    pub color: MatrixStack,
    /// User clip planes in eye coordinates.
    pub clip_planes: [[f64; 4]; MAX_CLIP_PLANES],
    /// Which user clip planes are enabled.
    pub clip_plane_enabled: [bool; MAX_CLIP_PLANES],
    /// `GL_NORMALIZE`.
    pub normalize: bool,
    /// `GL_RESCALE_NORMAL`.
    pub rescale_normal: bool,
}

impl Default for Transform {
    fn default() -> Self {
        use crate::limits::{
            MAX_COLOR_MATRIX_STACK_DEPTH, MAX_MODELVIEW_STACK_DEPTH, MAX_PROJECTION_STACK_DEPTH,
            MAX_TEXTURE_STACK_DEPTH,
        };
        Self {
            matrix_mode: MatrixMode::Modelview,
            modelview: MatrixStack::new(MAX_MODELVIEW_STACK_DEPTH),
            projection: MatrixStack::new(MAX_PROJECTION_STACK_DEPTH),
            texture: std::array::from_fn(|_| MatrixStack::new(MAX_TEXTURE_STACK_DEPTH)),
            color: MatrixStack::new(MAX_COLOR_MATRIX_STACK_DEPTH),
            clip_planes: [[0.0; 4]; MAX_CLIP_PLANES],
            clip_plane_enabled: [false; MAX_CLIP_PLANES],
            normalize: false,
            rescale_normal: false,
        }
    }
}

/// Viewport rectangle and depth range. The size of the initial viewport is set by the context.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Left edge in pixels.
    pub x: i32,
    /// Lower edge in pixels.
    pub y: i32,
    /// Width in pixels.
    pub width: i32,
    /// Height in pixels.
    pub height: i32,
    /// Window depth of the near plane, in [0, 1].
    pub near: f64,
    /// Window depth of the far plane, in [0, 1].
    pub far: f64,
}

impl Default for Viewport {
    fn default() -> Self {
        Self { x: 0, y: 0, width: 0, height: 0, near: 0.0, far: 1.0 }
    }
}
