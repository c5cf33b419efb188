//! GL's scalar types under their own names (OpenGL 1.5, table 2.2).

/// An enumerated value.
pub type GLenum = u32;
/// A set of bits.
pub type GLbitfield = u32;
/// `GL_TRUE` or `GL_FALSE`.
pub type GLboolean = u8;
/// A signed 8-bit integer.
pub type GLbyte = i8;
/// An unsigned 8-bit integer.
pub type GLubyte = u8;
/// A signed 16-bit integer.
pub type GLshort = i16;
/// An unsigned 16-bit integer.
pub type GLushort = u16;
/// A signed 32-bit integer.
pub type GLint = i32;
/// An unsigned 32-bit integer.
pub type GLuint = u32;
/// A size: a signed integer that must not be negative.
pub type GLsizei = i32;
/// A 32-bit float.
pub type GLfloat = f32;
/// A 32-bit float that is clamped to [0, 1].
pub type GLclampf = f32;
/// A 64-bit float.
pub type GLdouble = f64;
/// A 64-bit float that is clamped to [0, 1].
pub type GLclampd = f64;
/// An offset into a buffer object.
pub type GLintptr = isize;
/// A size of a buffer object.
pub type GLsizeiptr = isize;
