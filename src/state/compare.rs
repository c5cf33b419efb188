//! The comparison functions that the alpha, stencil and depth tests and depth textures share (OpenGL 1.5, sections 4.1.4
//! to 4.1.6 and 3.8.14).

use crate::enums::gl_enum;

gl_enum! {
    /// A comparison of an incoming value with a stored one.
    pub enum CompareFunc {
        /// Never passes.
        Never = GL_NEVER,
        /// Passes where the incoming value is less.
        Less = GL_LESS,
        /// Passes where it is equal.
        Equal = GL_EQUAL,
        /// Passes where it is less or equal.
        Lequal = GL_LEQUAL,
        /// Passes where it is greater.
        Greater = GL_GREATER,
        /// Passes where it differs.
        Notequal = GL_NOTEQUAL,
        /// Passes where it is greater or equal.
        Gequal = GL_GEQUAL,
        /// Always passes.
        Always = GL_ALWAYS,
    }
}
