//! What happens to the result of a command (OpenGL 1.5, section 2.5): the first error stays until it is read, every
//! error reaches the debug callback as a sentence with the caller's file and line, and the command that failed has
//! changed nothing. The message has the shape of KHR_debug, so that tools made for it feel at home.

use super::Context;
use super::values::{FromState, Values};
use crate::enums::*;
use crate::error::{GlError, Outcome, code_name, too_short};
use std::panic::Location;

/// The first error since the last question, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Error {
    /// The code that `glGetError` reports.
    pub code: GLenum,
    /// The command, with its name in C.
    pub command: &'static str,
    /// What was wrong and what to do about it.
    pub message: String,
    /// The caller's file.
    pub file: &'static str,
    /// The caller's line.
    pub line: u32,
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { code, command, message, file, line } = self;
        write!(f, "{file}:{line}: {command}: {} ({message})", code_name(*code))
    }
}

impl std::error::Error for Error {}

/// What the debug callback gets.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct DebugMessage<'a> {
    /// [`GL_DEBUG_SOURCE_API`].
    pub source: GLenum,
    /// [`GL_DEBUG_TYPE_ERROR`] or [`GL_DEBUG_TYPE_OTHER`].
    pub type_: GLenum,
    /// The error code, or 0.
    pub id: u32,
    /// [`GL_DEBUG_SEVERITY_HIGH`] or [`GL_DEBUG_SEVERITY_MEDIUM`].
    pub severity: GLenum,
    /// The sentence.
    pub message: &'a str,
    /// The command, with its name in C.
    pub command: &'static str,
    /// The caller's file.
    pub file: &'static str,
    /// The caller's line.
    pub line: u32,
}

impl std::fmt::Display for DebugMessage<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}: {}: {}", self.file, self.line, self.command, self.message)
    }
}

/// A debug callback.
pub type DebugCallback = Box<dyn FnMut(&DebugMessage<'_>) + Send>;

/// What an engine method may return: every shape becomes an outcome.
pub(crate) trait IntoOutcome {
    type Value: Default;
    fn outcome(self) -> Outcome<Self::Value>;
}

impl<T: Default> IntoOutcome for Outcome<T> {
    type Value = T;
    #[inline]
    fn outcome(self) -> Outcome<T> {
        self
    }
}

macro_rules! plain_results {
    ($($t:ty)*) => { $(impl IntoOutcome for $t {
        type Value = $t;
        #[inline]
        fn outcome(self) -> Outcome<$t> { Ok(self) }
    })* };
}
plain_results!(() bool i32 u32 &'static str);

/// Notes an error in the two places that keep it.
#[cold]
#[track_caller]
pub(crate) fn note<T: Default>(
    first: &mut Option<Box<Error>>,
    debug: &mut Option<DebugCallback>,
    name: &'static str,
    GlError { code, message }: GlError,
) -> T {
    let place = Location::caller();
    let (file, line) = (place.file(), place.line());
    // Before the callback, which may panic.
    if first.is_none() {
        *first = Some(Box::new(Error { code, command: name, message: message.clone(), file, line }));
    }
    if let Some(callback) = debug {
        callback(&DebugMessage {
            source: GL_DEBUG_SOURCE_API,
            type_: GL_DEBUG_TYPE_ERROR,
            id: code,
            severity: GL_DEBUG_SEVERITY_HIGH,
            message: &message,
            command: name,
            file,
            line,
        });
    }
    T::default()
}

/// Whether a command hands over advice that the engine has for the program: not the attributes of a vertex, of which
/// there are many.
pub(crate) const fn tells(outside: bool, method: &str) -> bool {
    outside || matches!(method.as_bytes(), b"end")
}

impl Context {
    /// Hands the engine's advice to the debug callback.
    #[inline]
    #[track_caller]
    pub(crate) fn deliver(&mut self, name: &'static str) {
        if self.engine.has_notes() {
            for note in self.engine.take_notes() {
                self.advise(name, &note);
            }
        }
    }

    /// Hands advice to the debug callback, once.
    #[track_caller]
    pub(crate) fn advise_once(&mut self, name: &'static str, message: String) {
        self.engine.note(message);
        self.deliver(name);
    }

    /// The value of a command, after its error has been noted.
    #[inline]
    #[track_caller]
    pub(crate) fn record_result<R: IntoOutcome>(&mut self, name: &'static str, result: R) -> R::Value {
        match result.outcome() {
            Ok(value) => value,
            Err(error) => self.fail(name, error),
        }
    }

    /// Writes the answer of a query in the type of the asking command.
    #[track_caller]
    pub(crate) fn answer<T: FromState>(&mut self, name: &'static str, values: &Values, out: &mut [T]) {
        if out.len() < values.len() {
            return self.short(name, "params", values.len(), out.len(), "values");
        }
        for (to, from) in out.iter_mut().zip(values.converted()) {
            *to = from;
        }
    }

    /// Notes an error: the first one stays, the callback hears all of them.
    #[cold]
    #[track_caller]
    pub(crate) fn fail<T: Default>(&mut self, name: &'static str, error: GlError) -> T {
        note(&mut self.error, &mut self.debug, name, error)
    }

    /// Hands advice of the engine to the debug callback; it is dropped if there is none.
    #[track_caller]
    pub(crate) fn advise(&mut self, name: &'static str, message: &str) {
        let place = Location::caller();
        if let Some(callback) = &mut self.debug {
            callback(&DebugMessage {
                source: GL_DEBUG_SOURCE_API,
                type_: GL_DEBUG_TYPE_OTHER,
                id: 0,
                severity: GL_DEBUG_SEVERITY_MEDIUM,
                message,
                command: name,
                file: place.file(),
                line: place.line(),
            });
        }
    }

    /// The error of a command that has panicked, which is a fault of the library. Only OUT_OF_MEMORY lets the state be
    /// undefined (section 2.5).
    #[cfg(feature = "capi")]
    #[cold]
    pub(crate) fn has_panicked(&mut self) {
        let message = "the command has panicked, which is a fault of fixedgl; what it has done is undefined";
        self.fail("fixedgl", crate::error::out_of_memory(message))
    }

    /// The error of a command that is not allowed between Begin and End.
    #[cold]
    #[track_caller]
    pub(crate) fn refuse_inside<T: Default>(&mut self, name: &'static str) -> T {
        let message = format!("{name} is not allowed between glBegin and glEnd; call glEnd first");
        self.fail(name, GlError { code: GL_INVALID_OPERATION, message })
    }

    /// The error of memory that is too short.
    #[cold]
    #[track_caller]
    pub(crate) fn short<T: Default>(
        &mut self,
        name: &'static str,
        argument: &str,
        needed: usize,
        there: usize,
        unit: &str,
    ) -> T {
        self.fail(name, too_short(argument, needed, there, unit))
    }

    /// The first error since the last question as a `Result`, with its place and its sentence; asking clears it.
    ///
    /// # Errors
    /// The first error of the commands since the last `check` or `get_error`.
    pub fn check(&mut self) -> Result<(), Error> {
        self.error.take().map_or(Ok(()), |error| Err(*error))
    }

    /// The code of the first error since the last question; asking clears it.
    pub(crate) fn take_error_code(&mut self) -> GLenum {
        self.error.take().map_or(GL_NO_ERROR, |error| error.code)
    }

    /// Calls `callback` with every error (and with advice about what will not draw) as it happens; `None` ends that.
    pub fn set_debug_callback(&mut self, callback: Option<DebugCallback>) {
        self.engine.advised = callback.is_some();
        self.debug = callback;
    }
}
