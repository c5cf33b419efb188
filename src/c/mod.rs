//! GL's own C names as safe functions (OpenGL 1.5, all chapters): `use fixedgl::c::*;` and a C program ports line by
//! line. The functions work on the current context of the calling thread, as in C; every name and type of the headers is
//! here too. They are made from the rows of the one table, so they are the same commands as the methods of [`Context`].
//!
//! ```
//! use fixedgl::c::*;
//! make_current(fixedgl::Context::new(64, 64));
//! let mut name: GLuint = 0;
//! glGenTextures(1, &mut name);
//! glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
//! glLightfv(GL_LIGHT0, GL_POSITION, &[1.0, 1.0, 1.0, 0.0]);
//! take_current();
//! ```
//!
//! # What differs from C
//! - A pointer is a reference to an array, a slice, a `Vec` or one variable; [`NULL`] stands for no memory. Memory that is too
//!   short is an error that says how much is needed.
//! - Vertex arrays are copied when the pointer command is called: call it again after a change, or use buffer objects.
//! - `glMapBuffer` takes a closure that gets the bytes; `glFeedbackBuffer` and `glSelectBuffer` take no buffer: read the
//!   values with [`Context::feedback_values`] and [`Context::select_values`] after `glRenderMode`.
//! - Without a current context a command does nothing and returns 0. The first such call of a thread says so on standard
//!   error; [`calls_without_context`] counts them.

mod current;
mod glu;
mod manual;
mod rows;
mod tess;

pub use crate::context::{ArrayData, Context, Indices, NULL, Null, Pixels, PixelsMut};
pub use crate::enums::*;
pub use current::{calls_without_context, make_current, take_current, with_current};
pub use glu::*;
pub use manual::*;
pub use rows::*;
pub use tess::*;
