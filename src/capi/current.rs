//! The current context of a thread behind the C ABI. A handle is a `Box` that C holds as a pointer; the thread keeps a
//! copy of the pointer of the one that is current. This file is where handles become references and where panics stop.

use super::osmesa::OsMesa;
use crate::Context;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr::null_mut;

thread_local! {
    static CURRENT: Cell<*mut OsMesa> = const { Cell::new(null_mut()) };
}

/// The handle that is current in this thread, or null.
pub(super) fn get() -> *mut OsMesa {
    CURRENT.get()
}

/// Makes a handle current, or none.
///
/// # Safety
/// The handle must be null or come from `Box::into_raw` and stay valid until it is not current any more, and no other
/// thread may use it meanwhile: what OSMesa asks of its users.
pub(super) unsafe fn set(handle: *mut OsMesa) {
    CURRENT.set(handle);
}

/// Calls `f` with what is current. A panic ends the command, not the program.
#[inline]
pub(super) fn with_handle<T: Default>(f: impl FnOnce(&mut OsMesa) -> T) -> T {
    let handle = CURRENT.get();
    // SAFETY: `set` was promised a valid handle of this thread. No command calls back into C, so no second reference
    // to it is alive.
    match unsafe { handle.as_mut() } {
        Some(os) => catch_unwind(AssertUnwindSafe(|| f(os))).unwrap_or_default(),
        None => T::default(),
    }
}

/// Calls `f` with the current context.
#[inline]
pub(super) fn with<T: Default>(f: impl FnOnce(&mut Context) -> T) -> T {
    with_handle(|os| f(&mut os.context))
}

/// Calls `f`, which needs no context. A panic ends the command, not the program.
pub(super) fn without<T: Default>(f: impl FnOnce() -> T) -> T {
    catch_unwind(AssertUnwindSafe(f)).unwrap_or_default()
}
