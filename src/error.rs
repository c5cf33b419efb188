//! GL errors (OpenGL 1.5, section 2.5). An engine command that cannot be carried out returns a [`GlError`]: the code
//! that `glGetError` will report and a sentence that says what was wrong and what to do. The doors keep the first code
//! until it is read and hand the sentence to the debug callback; the command itself has changed nothing.

use crate::enums::{
    GL_INVALID_ENUM, GL_INVALID_OPERATION, GL_INVALID_VALUE, GL_OUT_OF_MEMORY, GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW,
    GLenum, Named,
};

/// An error of one GL command: the code of table 2.3 and its meaning in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GlError {
    /// The code that `glGetError` reports.
    pub code: GLenum,
    /// What was wrong with the call and what to do about it.
    pub message: String,
}

/// What an engine command returns: nothing changes when it is an error.
pub type Outcome<T = ()> = Result<T, GlError>;

macro_rules! constructors {
    ($($(#[$doc:meta])* $name:ident = $code:ident;)*) => {
        $($(#[$doc])* #[cold] pub fn $name(message: impl Into<String>) -> GlError {
            GlError { code: $code, message: message.into() }
        })*
    };
}

constructors! {
    /// An enumerant that the command does not take.
    invalid_enum = GL_INVALID_ENUM;
    /// A number out of range.
    invalid_value = GL_INVALID_VALUE;
    /// A command that the present state does not allow.
    invalid_operation = GL_INVALID_OPERATION;
    /// A push on a full stack.
    stack_overflow = GL_STACK_OVERFLOW;
    /// A pop of the last element of a stack.
    stack_underflow = GL_STACK_UNDERFLOW;
    /// Not enough memory left to execute the command.
    out_of_memory = GL_OUT_OF_MEMORY;
}

/// The error of memory that holds fewer values, bytes or the like than a command needs.
#[cold]
pub fn too_short(argument: &str, needed: usize, there: usize, unit: &str) -> GlError {
    invalid_value(format!("`{argument}` must hold {needed} {unit}, but holds {there}: pass a longer slice"))
}

/// The value that an enumerant was found to stand for, or `INVALID_ENUM` with "... is not `what`".
#[inline]
pub fn known<T>(found: Option<T>, value: GLenum, what: &str) -> Outcome<T> {
    found.ok_or_else(|| not_one(value, what))
}

/// The error of an enumerant that is not one of those that a command takes.
#[cold]
pub fn not_one(value: GLenum, what: &str) -> GlError {
    invalid_enum(format!("{} is not {what}", Named(value)))
}

impl std::fmt::Display for GlError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", code_name(self.code), self.message)
    }
}

impl std::error::Error for GlError {}

/// A file that cannot be read, written or understood.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FileError {
    /// The file.
    pub path: std::path::PathBuf,
    /// What is wrong with it, to be read after its name.
    pub message: String,
}

impl FileError {
    /// An error with a file.
    pub fn new(path: impl Into<std::path::PathBuf>, message: impl Into<String>) -> Self {
        Self { path: path.into(), message: message.into() }
    }
}

impl std::fmt::Display for FileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.message)
    }
}

impl std::error::Error for FileError {}

/// The name of an error code as the specification writes it.
#[must_use]
pub fn code_name(code: GLenum) -> &'static str {
    match code {
        0 => "GL_NO_ERROR",
        GL_INVALID_ENUM => "GL_INVALID_ENUM",
        GL_INVALID_VALUE => "GL_INVALID_VALUE",
        GL_INVALID_OPERATION => "GL_INVALID_OPERATION",
        GL_STACK_OVERFLOW => "GL_STACK_OVERFLOW",
        GL_STACK_UNDERFLOW => "GL_STACK_UNDERFLOW",
        GL_OUT_OF_MEMORY => "GL_OUT_OF_MEMORY",
        _ => "unknown error code",
    }
}
