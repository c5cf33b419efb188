//! GL's scalar types and the value of every enumerant, under GL's own names (OpenGL 1.5, section 2.1 and the enumerant
//! registry). Plain constants, not a Rust enum: a program must be able to pass a wrong value, because that is what
//! `GL_INVALID_ENUM` is about. [`name`] turns a value back into a name for messages and traces.

mod core_more_names;
mod core_names;
mod extension_names;
mod gl_enum;

pub use core_more_names::*;
pub use core_names::*;
pub use extension_names::*;
pub(crate) use gl_enum::gl_enum;

use std::fmt;

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

/// The boolean false.
pub const GL_FALSE: GLboolean = 0;
/// The boolean true.
pub const GL_TRUE: GLboolean = 1;

macro_rules! enumerants {
    ($($name:ident = $value:literal;)*) => {
        $(#[doc = concat!("`", stringify!($name), "`")] pub const $name: super::GLenum = $value;)*
        pub(super) const ALL: &[(super::GLenum, &str)] = &[$(($value, stringify!($name))),*];
    };
}
use enumerants;

/// The name of an enumerant for messages: the first name in the tables that has this value, else the number in hex.
/// Values below 0x100 stand for several things (0 is `GL_ZERO`, `GL_POINTS`, `GL_NO_ERROR`), so they stay numbers.
#[must_use]
pub fn name(value: GLenum) -> String {
    Named(value).to_string()
}

/// Shows itself as [`name`] spells it; the name is not looked for before somebody wants to see it.
#[derive(Clone, Copy, Debug)]
pub struct Named(pub GLenum);

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match all().find(|row| row.0 == self.0) {
            Some(row) if self.0 >= 0x100 => f.write_str(row.1),
            _ => write!(f, "0x{:04X}", self.0),
        }
    }
}

/// The value of an enumerant by its name, for tools that read traces and tables.
#[must_use]
pub fn value(name: &str) -> Option<GLenum> {
    all().find(|row| row.1 == name).map(|row| row.0)
}

fn all() -> impl Iterator<Item = &'static (GLenum, &'static str)> {
    core_names::ALL.iter().chain(core_more_names::ALL).chain(extension_names::ALL)
}
