//! When the memory of a program is written, and which functions have an address.

use super::osmesa::*;
use super::proc_address::OSMesaGetProcAddress;
use super::rows::{fragment::*, get::glGetError, lists::*, raster::glLineWidth, vertex::*};
use crate::context::table::rows::rows;
use crate::enums::*;
use std::ffi::CString;
use std::ptr::null_mut;

/// A context that draws into memory of 4 by 4 pixels.
unsafe fn current(format: GLenum, memory: &mut [u32; 16]) -> *mut OsMesa {
    // SAFETY: the memory is large enough; the tests keep it as long as it is used.
    unsafe {
        let handle = OSMesaCreateContext(format, null_mut());
        assert_eq!(OSMesaMakeCurrent(handle, memory.as_mut_ptr().cast(), GL_UNSIGNED_BYTE, 4, 4), GL_TRUE);
        handle
    }
}

/// Draws without finishing.
unsafe fn draw() {
    // SAFETY: a context is current.
    unsafe {
        glClearColor(1.0, 1.0, 1.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1.0, -1.0, 0.0, 0.0);
        glBegin(GL_POINTS);
        glVertex2f(0.5, 0.5);
        glEnd();
    }
}

const UNTOUCHED: u32 = 0x1234_5678;

#[test]
fn memory_that_is_left_unfinished_is_not_written_when_its_context_gets_other_memory() {
    for format in [GL_RGBA, BGRA] {
        let (mut old, mut new) = ([UNTOUCHED; 16], [UNTOUCHED; 16]);
        // SAFETY: both pieces of memory live to the end.
        unsafe {
            let handle = current(format, &mut old);
            draw();
            // Here a program may free the old memory.
            assert_eq!(OSMesaMakeCurrent(handle, new.as_mut_ptr().cast(), GL_UNSIGNED_BYTE, 4, 4), GL_TRUE);
            assert_eq!(old, [UNTOUCHED; 16]);
            glClearColor(0.0, 0.0, 0.0, 0.0);
            glClear(GL_COLOR_BUFFER_BIT);
            glFinish();
            assert_eq!((old, new), ([UNTOUCHED; 16], [0; 16]));
            OSMesaDestroyContext(handle);
        }
    }
}

#[test]
fn memory_of_a_finished_picture_is_not_written_when_another_context_is_made_current() {
    for format in [GL_RGBA, BGRA] {
        let (mut old, mut new) = ([0; 16], [0; 16]);
        // SAFETY: both pieces of memory live to the end.
        unsafe {
            let first = current(format, &mut old);
            draw();
            glFinish();
            assert_eq!(old, [u32::MAX; 16]);
            // Commands that draw nothing finish nothing.
            glLineWidth(2.0);
            assert_eq!(glGetError(), GL_NO_ERROR);
            // Here a program may free the memory.
            old = [UNTOUCHED; 16];
            let second = current(format, &mut new);
            assert_eq!(old, [UNTOUCHED; 16]);
            OSMesaDestroyContext(first);
            OSMesaDestroyContext(second);
            assert_eq!(old, [UNTOUCHED; 16]);
        }
    }
}

#[test]
fn what_is_unfinished_is_finished_when_another_context_is_made_current() {
    for format in [GL_RGBA, BGRA] {
        let (mut old, mut new) = ([0; 16], [0; 16]);
        // SAFETY: both pieces of memory live to the end.
        unsafe {
            let first = current(format, &mut old);
            draw();
            let second = current(format, &mut new);
            assert_eq!((old, new), ([u32::MAX; 16], [0; 16]));
            OSMesaDestroyContext(first);
            OSMesaDestroyContext(second);
        }
    }
}

#[test]
fn a_context_that_is_destroyed_leaves_its_memory_alone() {
    let mut memory = [UNTOUCHED; 16];
    // SAFETY: the memory lives to the end.
    unsafe {
        let handle = current(GL_RGBA, &mut memory);
        draw();
        OSMesaDestroyContext(handle);
    }
    assert_eq!(memory, [UNTOUCHED; 16]);
}

#[test]
fn every_name_of_every_row_has_an_address() {
    for name in rows().flat_map(|row| std::iter::once(&row.name).chain(row.aliases)) {
        let text = CString::new(*name).unwrap();
        // SAFETY: a string that ends with a zero.
        assert!(!unsafe { OSMesaGetProcAddress(text.as_ptr()) }.is_null(), "{name}");
    }
}

#[test]
fn a_list_that_is_open_does_not_keep_a_context_from_other_memory() {
    let (mut old, mut new) = ([UNTOUCHED; 16], [UNTOUCHED; 16]);
    // SAFETY: both pieces of memory live to the end.
    unsafe {
        let handle = current(GL_RGBA, &mut old);
        glNewList(1, GL_COMPILE_AND_EXECUTE);
        draw();
        assert_eq!(OSMesaMakeCurrent(handle, new.as_mut_ptr().cast(), GL_UNSIGNED_BYTE, 2, 2), GL_TRUE);
        OSMesaDestroyContext(handle);
    }
    assert_eq!((old, new), ([UNTOUCHED; 16], [UNTOUCHED; 16]));
}
