//! The few C-named functions whose C form keeps a pointer beyond the call, which a safe function cannot do.
#![expect(non_snake_case, reason = "the names are GL's own")]

use super::current;
use crate::context::context_commands::multi_draw_elements;
use crate::context::{InSlice, IndexLists, param_counts};
use crate::enums::{GL_FALSE, GL_TRUE, GLboolean, GLenum, GLint, GLsizei};

/// Runs an expression with the current context; without one the call is counted and does nothing.
macro_rules! with {
    ($name:ident, $cx:ident => $e:expr) => {
        match current::take().context() {
            Some($cx) => $e,
            None => {
                current::missed(stringify!($name));
                Default::default()
            }
        }
    };
}
pub(super) use with;

/// See [`Context::multi_draw_elements`](crate::Context::multi_draw_elements). `drawcount` lists are drawn.
#[track_caller]
pub fn glMultiDrawElements(
    mode: GLenum,
    count: impl InSlice<GLsizei>,
    type_: GLenum,
    indices: impl IndexLists,
    drawcount: GLsizei,
) {
    with!(glMultiDrawElements, cx => {
        let count = count.slice();
        let count = count.get(..param_counts::count(drawcount)).unwrap_or(count);
        multi_draw_elements(cx, "glMultiDrawElements", mode, count, type_, &indices.lists(), drawcount);
    });
}
pub use self::glMultiDrawElements as glMultiDrawElementsEXT;

/// See [`Context::render_mode`](crate::Context::render_mode).
#[track_caller]
pub fn glRenderMode(mode: GLenum) -> GLint {
    with!(glRenderMode, cx => cx.render_mode(mode))
}

/// See [`Context::feedback_buffer`](crate::Context::feedback_buffer).
#[track_caller]
pub fn glFeedbackBuffer(size: GLsizei, type_: GLenum) {
    with!(glFeedbackBuffer, cx => cx.feedback_buffer(size, type_));
}

/// See [`Context::select_buffer`](crate::Context::select_buffer).
#[track_caller]
pub fn glSelectBuffer(size: GLsizei) {
    with!(glSelectBuffer, cx => cx.select_buffer(size));
}

/// Maps a buffer object, hands its bytes to `f` and leaves it mapped: `glUnmapBuffer` ends that. Returns `GL_TRUE` if `f`
/// was called. See [`Context::map_buffer`](crate::Context::map_buffer).
#[track_caller]
pub fn glMapBuffer(target: GLenum, access: GLenum, f: impl FnOnce(&mut [u8])) -> GLboolean {
    with!(glMapBuffer, cx => match cx.map_buffer(target, access) {
        Some(bytes) => {
            f(bytes);
            GL_TRUE
        }
        None => GL_FALSE,
    })
}
pub use self::glMapBuffer as glMapBufferARB;
