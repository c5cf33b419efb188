//! Errors of commands that were given bad pointers (OpenGL 1.5, section 2.5): the pointer is the last thing that a command
//! looks at, and a command in error has no effect, not on the memory that the door remembers either.

use super::manual::{glFeedbackBuffer, glMultiDrawElements, glRenderMode, glSelectBuffer};
use super::osmesa::{OSMesaCreateContext, OSMesaDestroyContext, OSMesaMakeCurrent};
use super::rows::arrays::{glDrawElements, glGetBufferSubData, glMultiDrawArrays};
use super::rows::get::glGetError;
use super::rows::lighting::{glLightModelfv, glLightfv, glMaterialfv};
use super::rows::lists::{glCallLists, glPassThrough};
use super::rows::pixels::glPixelMapfv;
use super::rows::texture::{glTexEnvfv, glTexParameterfv};
use super::rows::transform::{glClipPlane, glLoadMatrixf, glTexGenfv};
use super::rows::vertex::{glBegin, glEnd, glMultiTexCoord2fv};
use crate::enums::*;
use std::ptr::{null, null_mut};

/// Runs with a current context.
fn with_context(f: impl FnOnce()) {
    let mut pixels = vec![0_u32; 64];
    // SAFETY: the memory is large enough and outlives the context.
    unsafe {
        let handle = OSMesaCreateContext(GL_RGBA, null_mut());
        assert_eq!(OSMesaMakeCurrent(handle, pixels.as_mut_ptr().cast(), GL_UNSIGNED_BYTE, 8, 8), 1);
        f();
        OSMesaDestroyContext(handle);
    }
}

/// A call with a null pointer, and its error outside of Begin and End.
type Call = (&'static str, GLenum, fn());

/// SAFETY of the calls: a null pointer is memory that holds nothing.
const CALLS: &[Call] = unsafe {
    &[
        ("light", GL_INVALID_ENUM, || glLightfv(GL_LIGHT0 + 1000, GL_AMBIENT, null())),
        ("memory of a light", GL_INVALID_VALUE, || glLightfv(GL_LIGHT0, GL_AMBIENT, null())),
        ("light model", GL_INVALID_ENUM, || glLightModelfv(GL_LIGHT0, null())),
        ("plane", GL_INVALID_ENUM, || glClipPlane(GL_CLIP_PLANE0 + 100, null())),
        ("memory of a plane", GL_INVALID_VALUE, || glClipPlane(GL_CLIP_PLANE0, null())),
        ("texture", GL_INVALID_ENUM, || glTexParameterfv(GL_TEXTURE, GL_TEXTURE_BORDER_COLOR, null())),
        ("environment", GL_INVALID_ENUM, || glTexEnvfv(GL_TEXTURE, GL_TEXTURE_ENV_COLOR, null())),
        ("name of the other target", GL_INVALID_ENUM, || {
            glTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, null());
        }),
        ("coordinate", GL_INVALID_ENUM, || glTexGenfv(GL_TEXTURE, GL_EYE_PLANE, null())),
        ("map", GL_INVALID_ENUM, || glPixelMapfv(GL_TEXTURE, 4, null())),
        ("size of a map", GL_INVALID_VALUE, || glPixelMapfv(GL_PIXEL_MAP_R_TO_R, i32::MAX, null())),
        ("buffer target", GL_INVALID_ENUM, || glGetBufferSubData(GL_TEXTURE, 0, 4, null_mut())),
        ("no buffer bound", GL_INVALID_OPERATION, || glGetBufferSubData(GL_ARRAY_BUFFER, 0, 4, null_mut())),
        ("mode of elements", GL_INVALID_ENUM, || glDrawElements(99, 3, GL_UNSIGNED_BYTE, null())),
        ("mode of many", GL_INVALID_ENUM, || glMultiDrawArrays(99, null(), null(), 2)),
        ("mode of many lists", GL_INVALID_ENUM, || glMultiDrawElements(99, null(), GL_UNSIGNED_INT, null(), 2)),
        ("how many lists", GL_INVALID_VALUE, || glMultiDrawElements(0, null(), GL_UNSIGNED_INT, null(), -1)),
        ("memory of many lists", GL_INVALID_VALUE, || glMultiDrawElements(0, null(), GL_UNSIGNED_INT, null(), 2)),
        ("matrix", GL_INVALID_VALUE, || glLoadMatrixf(null())),
    ]
};

/// The same of commands that may stand between Begin and End.
const INSIDE: &[Call] = unsafe {
    &[
        ("face", GL_INVALID_ENUM, || glMaterialfv(GL_LEFT, GL_DIFFUSE, null())),
        ("memory of a material", GL_INVALID_VALUE, || glMaterialfv(GL_FRONT, GL_DIFFUSE, null())),
        ("unit", GL_INVALID_ENUM, || glMultiTexCoord2fv(GL_TEXTURE0 + 100, null())),
        ("memory of coordinates", GL_INVALID_VALUE, || glMultiTexCoord2fv(GL_TEXTURE0, null())),
        ("type of names", GL_INVALID_ENUM, || glCallLists(2, GL_DOUBLE, null())),
        ("memory of names", GL_INVALID_VALUE, || glCallLists(2, GL_UNSIGNED_BYTE, null())),
    ]
};

#[test]
fn a_null_pointer_is_the_last_error_of_a_command() {
    with_context(|| {
        for inside in [false, true] {
            for (name, error, call) in CALLS.iter().chain(INSIDE) {
                // SAFETY: no pointers.
                unsafe {
                    if inside {
                        glBegin(GL_POINTS);
                    }
                    call();
                    if inside {
                        glEnd();
                    }
                    let refused = inside && !INSIDE.iter().any(|row| row.0 == *name);
                    assert_eq!(glGetError(), if refused { GL_INVALID_OPERATION } else { *error }, "{name}");
                }
            }
        }
    });
}

#[test]
fn memory_of_feedback_and_selection_that_is_refused_is_not_taken() {
    with_context(|| {
        let (mut taken, mut refused) = ([0_f32; 4], [0_f32; 4]);
        let (mut hits, mut no_hits) = ([0_u32; 4], [0_u32; 4]);
        // SAFETY: the memory is as large as said and outlives the calls.
        unsafe {
            glFeedbackBuffer(4, GL_2D, taken.as_mut_ptr());
            glSelectBuffer(4, hits.as_mut_ptr());
            assert_eq!(glGetError(), GL_NO_ERROR);
            glFeedbackBuffer(4, GL_RGBA, refused.as_mut_ptr());
            assert_eq!(glGetError(), GL_INVALID_ENUM);
            glSelectBuffer(-1, no_hits.as_mut_ptr());
            assert_eq!(glGetError(), GL_INVALID_VALUE);
            glRenderMode(GL_FEEDBACK);
            glPassThrough(7.0);
            glFeedbackBuffer(4, GL_2D, refused.as_mut_ptr());
            assert_eq!(glGetError(), GL_INVALID_OPERATION);
            assert_eq!(glRenderMode(GL_RENDER), 2);
            assert_eq!(glGetError(), GL_NO_ERROR);
        }
        assert_eq!(taken[..2], [GL_PASS_THROUGH_TOKEN as f32, 7.0]);
        assert_eq!(refused, [0.0; 4]);
        assert_eq!(no_hits, [0; 4]);
    });
}
