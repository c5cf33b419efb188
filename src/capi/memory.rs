//! Pointers of C as slices. Every function here asks the same of its caller as GL does of a C program: a pointer that is
//! not null points to as much memory of the type as the command's parameters say, and nobody else writes it meanwhile.
//! A null pointer is an empty slice, which the safe doors refuse in words where memory is needed.

use crate::context::capture::{ImageSize, image_bytes};
use crate::context::{ArrayData, ClientAddress, Context, Element, Indices, Pixels, PixelsMut, param_counts};
use crate::enums::*;
use std::borrow::Cow;
use std::ffi::c_void;

/// Values that a command reads.
///
/// # Safety
/// See the head of this file; `n` values.
pub(super) unsafe fn slice<'a, T: Element>(pointer: *const T, n: usize) -> &'a [T] {
    if pointer.is_null() || n == 0 {
        return &[];
    }
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts(pointer, n) }
}

/// Values that a command writes.
///
/// # Safety
/// See the head of this file; `n` values.
pub(super) unsafe fn slice_mut<'a, T: Element>(pointer: *mut T, n: usize) -> &'a mut [T] {
    if pointer.is_null() || n == 0 {
        return &mut [];
    }
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts_mut(pointer, n) }
}

/// Bytes that a command reads.
///
/// # Safety
/// See the head of this file; `n` bytes.
pub(super) unsafe fn bytes<'a>(pointer: *const c_void, n: usize) -> Pixels<'a> {
    if pointer.is_null() {
        return Pixels::Null;
    }
    // SAFETY: the caller's promise.
    Pixels::Bytes(Cow::Borrowed(unsafe { slice(pointer.cast::<u8>(), n) }))
}

/// Bytes that a command writes.
///
/// # Safety
/// See the head of this file; `n` bytes.
pub(super) unsafe fn bytes_mut<'a>(pointer: *mut c_void, n: usize) -> PixelsMut<'a> {
    if pointer.is_null() {
        return PixelsMut::Null;
    }
    // SAFETY: the caller's promise.
    PixelsMut::Bytes(unsafe { slice_mut(pointer.cast::<u8>(), n) })
}

/// Bytes of an image under the unpack state.
pub(super) fn unpack_bytes(cx: &mut Context, size: impl ImageSize, format: GLenum, type_: GLenum) -> usize {
    image_bytes(&cx.engine.unpack_store(), size, format, type_)
}

/// Bytes of an image under the pack state.
pub(super) fn pack_bytes(cx: &mut Context, size: impl ImageSize, format: GLenum, type_: GLenum) -> usize {
    image_bytes(&cx.engine.pack_store(), size, format, type_)
}

/// A vertex array. The engine takes the address for an offset if a buffer object is bound.
///
/// # Safety
/// What GL asks of the pointer of a vertex array: what is drawn must be readable when it is drawn.
pub(super) unsafe fn array(pointer: *const c_void) -> ArrayData {
    // SAFETY: the caller's promise.
    ArrayData::Client(unsafe { ClientAddress::new(pointer as usize) })
}

/// An index list, or an offset if a buffer object is bound.
///
/// # Safety
/// See the head of this file; `n` indices of the type, unless a buffer object is bound.
pub(super) unsafe fn indices<'a>(cx: &mut Context, pointer: *const c_void, n: i32, type_: GLenum) -> Indices<'a> {
    if pointer.is_null() || cx.engine.element_array_buffer_bound() {
        return Indices::Offset(pointer as usize);
    }
    // SAFETY: the caller's promise.
    Indices::Bytes(Cow::Borrowed(unsafe { slice(pointer.cast::<u8>(), param_counts::indices(n, type_)) }))
}

/// Writes the values of a query.
///
/// # Safety
/// See the head of this file; as many values as the query has.
pub(super) unsafe fn write<T: Element>(pointer: *mut T, values: impl Iterator<Item = T>) {
    if pointer.is_null() {
        return;
    }
    for (i, value) in values.enumerate() {
        // SAFETY: the caller's promise.
        unsafe { pointer.add(i).write(value) };
    }
}

/// Bytes that a query of the imaging subset writes.
pub(super) fn imaging_bytes(cx: &mut Context, target: GLenum, format: GLenum, type_: GLenum) -> usize {
    let size = cx.engine.imaging_size(target);
    pack_bytes(cx, size, format, type_)
}
