//! The call trace: every command in the order of the calls, as data. A callback gets the command's name in C, its
//! arguments as text and the caller's file and line; without a callback a command pays one test of a flag. Commands of
//! Begin/End pairs and those that a display list only records are traced like all others, replayed ones are not.

use super::Context;
use super::show::{Names, Show};
use crate::fragment::explain::in_one_line;
use std::panic::Location;
use std::sync::Arc;

/// One call of a command.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Call {
    /// The command's name in C.
    pub name: &'static str,
    /// The arguments as text: enumerants and bits of masks by name, long arrays cut.
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
        let pname = args.iter().find(|arg| arg.0 == "pname").and_then(|arg| arg.1.enumerant());
        for (i, (argument, value)) in args.iter().enumerate() {
            if i > 0 {
                text.push_str(", ");
            }
            value.show(&mut text, Names::of(name, argument, pname));
        }
        callback(&Call { name, args: text, file: place.file(), line: place.line() });
    }
}
