//! The few commands whose C form keeps a pointer or takes pointers to pointers.

use super::osmesa::ClientBuffer;
use super::{current, memory};
use crate::context::context_commands::multi_draw_elements;
use crate::context::{Context, Indices, param_counts};
use crate::enums::*;
use std::ffi::c_void;

/// # Safety
/// `count` and `indices` must hold `drawcount` values, and each list as many indices as its count says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawElements(
    mode: GLenum,
    count: *const i32,
    type_: GLenum,
    indices: *const *const c_void,
    drawcount: i32,
) {
    current::with(|cx| {
        // SAFETY: the caller's promise.
        let count = unsafe { memory::slice(count, param_counts::count(drawcount)) };
        let list = |cx: &mut Context, (i, n): (usize, &i32)| {
            // SAFETY: the caller's promise; the pointer is not null.
            unsafe { memory::indices(cx, *indices.add(i), *n, type_) }
        };
        let lists: Vec<Indices<'_>> = match indices.is_null() {
            true => Vec::new(),
            false => count.iter().enumerate().map(|i| list(cx, i)).collect(),
        };
        multi_draw_elements(cx, "glMultiDrawElements", mode, count, type_, &lists, drawcount);
    });
}

/// # Safety
/// See [`glMultiDrawElements`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawElementsEXT(
    mode: GLenum,
    count: *const i32,
    type_: GLenum,
    indices: *const *const c_void,
    drawcount: i32,
) {
    // SAFETY: the caller's promise.
    unsafe { glMultiDrawElements(mode, count, type_, indices, drawcount) }
}

/// # Safety
/// `buffer` must be writable for `size` values until RenderMode is called or another buffer is set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFeedbackBuffer(size: i32, type_: GLenum, buffer: *mut f32) {
    current::with_handle(|os| {
        if os.context.takes_feedback_buffer(size, type_) {
            os.feedback = ClientBuffer { address: buffer, len: param_counts::count(size) };
        }
    });
}

/// # Safety
/// `buffer` must be writable for `size` values until RenderMode is called or another buffer is set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSelectBuffer(size: i32, buffer: *mut u32) {
    current::with_handle(|os| {
        if os.context.takes_select_buffer(size) {
            os.select = ClientBuffer { address: buffer, len: param_counts::count(size) };
        }
    });
}

/// # Safety
/// The buffers of FeedbackBuffer and SelectBuffer must still be writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderMode(mode: GLenum) -> i32 {
    current::with_handle(|os| {
        let mut ended = [0];
        os.context.get_integerv(GL_RENDER_MODE, &mut ended);
        let result = os.context.render_mode(mode);
        match ended[0].cast_unsigned() {
            // SAFETY: the caller's promise.
            GL_FEEDBACK => unsafe { os.feedback.write(os.context.feedback_values()) },
            // SAFETY: the caller's promise.
            GL_SELECT => unsafe { os.select.write(os.context.select_values()) },
            _ => {}
        }
        result
    })
}

/// Maps the buffer object that is bound to a target. The address is good until `glUnmapBuffer`.
#[unsafe(no_mangle)]
pub extern "C" fn glMapBuffer(target: GLenum, access: GLenum) -> *mut c_void {
    let address = current::with(|cx| cx.map_buffer(target, access).map(|bytes| bytes.as_mut_ptr() as usize));
    address.unwrap_or(0) as *mut c_void
}

/// See [`glMapBuffer`].
#[unsafe(no_mangle)]
pub extern "C" fn glMapBufferARB(target: GLenum, access: GLenum) -> *mut c_void {
    glMapBuffer(target, access)
}

/// The address of a function of this file.
pub(super) fn find(name: &str) -> Option<*const c_void> {
    Some(match name {
        "glMultiDrawElements" => glMultiDrawElements as *const c_void,
        "glMultiDrawElementsEXT" => glMultiDrawElementsEXT as *const c_void,
        "glFeedbackBuffer" => glFeedbackBuffer as *const c_void,
        "glSelectBuffer" => glSelectBuffer as *const c_void,
        "glRenderMode" => glRenderMode as *const c_void,
        "glMapBuffer" => glMapBuffer as *const c_void,
        "glMapBufferARB" => glMapBufferARB as *const c_void,
        _ => return None,
    })
}
