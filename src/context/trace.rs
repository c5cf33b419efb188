//! The call trace: every command in the order of the calls, as data. A callback gets the command's name in C, its
//! arguments as text and the caller's file and line; without a callback a command pays one test of a flag. Commands of
//! Begin/End pairs and those that a display list only records are traced like all others, replayed ones are not.

use super::Context;
use crate::enums;
use crate::fragment::explain::in_one_line;
use std::fmt::{Debug, Write};
use std::panic::Location;
use std::sync::Arc;

/// One call of a command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// The command's name in C.
    pub name: &'static str,
    /// The arguments as text: enumerants by name, long arrays cut.
    pub args: String,
    /// The caller's file.
    pub file: &'static str,
    /// The caller's line.
    pub line: u32,
}

impl std::fmt::Display for Call {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}({})", self.name, self.args)
    }
}

/// A trace callback.
pub type TraceCallback = Box<dyn FnMut(&Call) + Send>;

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

impl Show for super::Pixels<'_> {
    fn show(&self, text: &mut String) {
        match self.bytes() {
            None => text.push_str("NULL"),
            Some(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for super::PixelsMut<'_> {
    fn show(&self, text: &mut String) {
        match self {
            Self::Null => text.push_str("NULL"),
            Self::Bytes(bytes) => drop(write!(text, "&mut [{} bytes]", bytes.len())),
        }
    }
}

impl Show for super::ArrayData {
    fn show(&self, text: &mut String) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Values(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
            Self::Client(address) => drop(write!(text, "{:#x}", address.get())),
        }
    }
}

impl Show for super::Indices<'_> {
    fn show(&self, text: &mut String) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Bytes(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for Vec<super::Indices<'_>> {
    fn show(&self, text: &mut String) {
        self.as_slice().show(text);
    }
}

impl Context {
    /// Calls `callback` with every command before it is carried out; `None` ends that. Where a draw has made a new plan, a
    /// line called `plan` follows with what is kept, hoisted and left out ([`Context::explain`] has the reasons).
    pub fn set_trace_callback(&mut self, callback: Option<TraceCallback>) {
        self.flags.set_tracing(callback.is_some());
        self.trace = callback;
    }

    /// Hands one call to the trace callback.
    #[cold]
    #[track_caller]
    pub(crate) fn trace(&mut self, name: &'static str, args: &[(&str, &dyn Show)]) {
        let place = Location::caller();
        let Some(callback) = &mut self.trace else { return };
        if let Some(program) = self.engine.program.as_ref().filter(|p| self.traced.as_ptr() != Arc::as_ptr(p)) {
            self.traced = Arc::downgrade(program);
            let args = in_one_line(&self.engine.decisions());
            callback(&Call { name: "plan", args, file: place.file(), line: place.line() });
        }
        let mut text = String::new();
        for (i, (_, value)) in args.iter().enumerate() {
            if i > 0 {
                text.push_str(", ");
            }
            value.show(&mut text);
        }
        callback(&Call { name, args: text, file: place.file(), line: place.line() });
    }
}
