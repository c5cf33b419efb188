//! How a trace shows the arguments of a command: enumerants by name, bits in hex, long arrays cut.

use super::pixels_arg::{ArrayData, Indices, Pixels, PixelsMut};
use crate::enums;
use std::fmt::{Debug, Write};

/// Arrays longer than this are cut in a trace.
const MAX_SHOWN: usize = 16;

/// An argument as a trace shows it.
pub(crate) trait Show {
    fn show(&self, text: &mut String);
}

/// An enumerated value, shown by its name.
pub(crate) struct Enumerant(pub(crate) u32);

/// A set of bits, shown in hex.
pub(crate) struct Bits(pub(crate) u32);

/// Writes to a `String` cannot fail, so their results carry nothing.
fn debug(text: &mut String, value: &dyn Debug) {
    let _ = write!(text, "{value:?}");
}

impl Show for Enumerant {
    fn show(&self, text: &mut String) {
        text.push_str(&enums::name(self.0));
    }
}

impl Show for Bits {
    fn show(&self, text: &mut String) {
        let _ = write!(text, "0x{:X}", self.0);
    }
}

macro_rules! shown_by_debug {
    ($($t:ty)*) => { $(impl Show for $t { fn show(&self, text: &mut String) { debug(text, self); } })* };
}
shown_by_debug!(u8 i8 u16 i16 u32 i32 f32 f64 bool isize usize);

impl<T: Show> Show for &[T] {
    fn show(&self, text: &mut String) {
        text.push('[');
        for (i, value) in self.iter().take(MAX_SHOWN).enumerate() {
            if i > 0 {
                text.push_str(", ");
            }
            value.show(text);
        }
        if self.len() > MAX_SHOWN {
            let _ = write!(text, ", ... {} values", self.len());
        }
        text.push(']');
    }
}

impl<T> Show for &mut [T] {
    fn show(&self, text: &mut String) {
        let _ = write!(text, "&mut [{}]", self.len());
    }
}

impl Show for Pixels<'_> {
    fn show(&self, text: &mut String) {
        match self.bytes() {
            None => text.push_str("NULL"),
            Some(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for PixelsMut<'_> {
    fn show(&self, text: &mut String) {
        match self {
            Self::Null => text.push_str("NULL"),
            Self::Bytes(bytes) => drop(write!(text, "&mut [{} bytes]", bytes.len())),
        }
    }
}

impl Show for ArrayData {
    fn show(&self, text: &mut String) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Values(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
            Self::Client(address) => drop(write!(text, "{:#x}", address.get())),
        }
    }
}

impl Show for Indices<'_> {
    fn show(&self, text: &mut String) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Bytes(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for Vec<Indices<'_>> {
    fn show(&self, text: &mut String) {
        self.as_slice().show(text);
    }
}
