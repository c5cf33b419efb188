//! GL's scalar types and the value of every enumerant, under GL's own names (OpenGL 1.5, section 2.1 and the enumerant
//! registry). Plain constants, not a Rust enum: a program must be able to pass a wrong value, because that is what
//! `GL_INVALID_ENUM` is about. [`name`] turns a value back into a name for messages and traces.

mod core_more_names;
mod core_names;
mod enumerants;
mod extension_names;
mod gl_enum;
mod types;
mod vendor_names;

pub use core_more_names::*;
pub use core_names::*;
pub use extension_names::*;
pub(crate) use gl_enum::gl_enum;
pub use types::*;
pub use vendor_names::*;

use std::fmt;

/// The boolean false.
pub const GL_FALSE: GLboolean = 0;
/// The boolean true.
pub const GL_TRUE: GLboolean = 1;

/// The name of an enumerant for messages: the first name in the tables that has this value, else the number in hex.
/// Values below 0x100 stand for several things (0 is `GL_ZERO`, `GL_POINTS`, `GL_NO_ERROR`), so they stay numbers, and no
/// bit of a mask is meant by a value that is an enumerant as well.
#[must_use]
pub fn name(value: GLenum) -> String {
    Named(value).to_string()
}

/// Shows itself as [`name`] spells it; the name is not looked for before somebody wants to see it.
#[derive(Clone, Copy, Debug)]
pub struct Named(pub GLenum);

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match all().find(|row| row.0 == self.0 && !is_bit(row.1)) {
            Some(row) if self.0 >= 0x100 => f.write_str(row.1),
            _ => write!(f, "0x{:04X}", self.0),
        }
    }
}

/// Whether a name is one of bits in a mask.
fn is_bit(name: &str) -> bool {
    let name = name.trim_end_matches("_ARB").trim_end_matches("_EXT");
    name.ends_with("_BIT") || name.ends_with("_BITS") && name.contains("ATTRIB")
}

/// A mask with its bits by name, those of client state or those of the server's; what has no name is left as a number.
#[must_use]
pub fn bit_names(mask: GLbitfield, client: bool) -> String {
    let rows = || all().filter(move |row| is_bit(row.1) && row.1.starts_with("GL_CLIENT_") == client && row.0 != 0);
    if let Some(whole) = rows().find(|row| row.0 == mask) {
        return whole.1.to_string();
    }
    let mut names = Vec::new();
    let mut rest = mask;
    for (bit, name) in rows().filter(|row| row.0.is_power_of_two()) {
        if rest & bit != 0 {
            names.push((*name).to_string());
            rest &= !bit;
        }
    }
    if rest != 0 || names.is_empty() {
        names.push(format!("0x{rest:X}"));
    }
    names.join(" | ")
}

/// The value of an enumerant by its name, for tools that read traces and tables.
#[must_use]
pub fn value(name: &str) -> Option<GLenum> {
    all().find(|row| row.1 == name).map(|row| row.0)
}

/// Every enumerant with its name.
pub(crate) fn all() -> impl Iterator<Item = &'static (GLenum, &'static str)> {
    core_names::ALL.iter().chain(core_more_names::ALL).chain(extension_names::ALL).chain(vendor_names::ALL)
}
