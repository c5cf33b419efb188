//! The current context of a thread behind the C ABI. A handle is a `Box` that C holds as a pointer; the thread keeps a
//! copy of the pointer of the one that is current. This file is where handles become references and where panics stop.

use super::float_control::{self, InitialState};
use super::osmesa::OsMesa;
use crate::Context;
use crate::context::{Config, standard_error};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// A word of each thread for its handle. A shared library asks a function of the C library where a thread's variables are,
/// at each access; that took a third of a glColor. Where the linker and the loader are known, two instructions do: the
/// word lies at a fixed distance from the thread pointer, as in other libraries of GL ("initial exec").
#[cfg(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu", target_pointer_width = "64"))]
mod word {
    use super::OsMesa;
    use std::arch::{asm, global_asm};

    global_asm!(
        ".pushsection .tbss.fixedgl_current, \"awT\", @nobits",
        ".globl fixedgl_current",
        ".hidden fixedgl_current",
        ".type fixedgl_current, @object",
        ".p2align 3",
        "fixedgl_current:",
        ".zero 8",
        ".size fixedgl_current, 8",
        ".popsection",
    );

    #[inline(always)]
    pub(super) fn get() -> *mut OsMesa {
        let handle: *mut OsMesa;
        // SAFETY: reads the word above, which every thread has and which begins as zero.
        unsafe {
            asm!(
                "mov {0}, qword ptr [rip + fixedgl_current@GOTTPOFF]",
                "mov {0}, qword ptr fs:[{0}]",
                out(reg) handle,
                options(pure, readonly, nostack, preserves_flags),
            );
        }
        handle
    }

    pub(super) fn set(handle: *mut OsMesa) {
        // SAFETY: writes the word above.
        unsafe {
            asm!(
                "mov {0}, qword ptr [rip + fixedgl_current@GOTTPOFF]",
                "mov qword ptr fs:[{0}], {1}",
                out(reg) _,
                in(reg) handle,
                options(nostack, preserves_flags),
            );
        }
    }
}

#[cfg(not(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu", target_pointer_width = "64")))]
mod word {
    use super::OsMesa;
    use std::cell::Cell;
    use std::ptr::null_mut;

    thread_local! {
        static CURRENT: Cell<*mut OsMesa> = const { Cell::new(null_mut()) };
    }

    pub(super) fn get() -> *mut OsMesa {
        CURRENT.get()
    }

    pub(super) fn set(handle: *mut OsMesa) {
        CURRENT.set(handle);
    }
}

/// The handle that is current in this thread, or null.
#[inline]
pub(super) fn get() -> *mut OsMesa {
    word::get()
}

/// Makes a handle current, or none.
///
/// # Safety
/// The handle must be null or come from `Box::into_raw` and stay valid until it is not current any more, and no other
/// thread may use it meanwhile: what OSMesa asks of its users.
pub(super) unsafe fn set(handle: *mut OsMesa) {
    word::set(handle);
}

/// Calls `f` with what is current. A panic ends the command, not the program, and leaves a GL error.
#[inline]
pub(super) fn with_handle<T: Default>(f: impl FnOnce(&mut OsMesa) -> T) -> T {
    let (handle, _state) = (get(), InitialState::enter());
    // SAFETY: `set` was promised a valid handle of this thread. No command calls back into C, so no second reference
    // to it is alive.
    match unsafe { handle.as_mut() } {
        Some(os) => catch_unwind(AssertUnwindSafe(|| f(&mut *os))).unwrap_or_else(|_| {
            os.context.has_panicked();
            T::default()
        }),
        None => T::default(),
    }
}

/// Calls `f` with the current context, for a command of this name.
#[inline]
pub(super) fn command<T: Default>(name: &'static str, f: impl FnOnce(&mut Context) -> T) -> T {
    if get().is_null() {
        missed(name);
    }
    with(f)
}

/// A command without a current context.
#[cold]
fn missed(name: &str) {
    say(name, || "does nothing: no context is current in this thread; call OSMesaMakeCurrent first".to_string());
}

/// Writes a sentence about a command to standard error, once, if `FIXEDGL_DEBUG` asks for it.
#[cold]
pub(super) fn say(command: &str, sentence: impl FnOnce() -> String) {
    without(|| {
        if Config::from_env().debug {
            standard_error::say(&format!("{command}: {}", sentence()));
        }
    });
}

/// Calls `f` with the current context.
#[inline]
pub(super) fn with<T: Default>(f: impl FnOnce(&mut Context) -> T) -> T {
    with_handle(|os| f(&mut os.context))
}

/// Calls `f`, which needs no context. A panic ends the command, not the program.
pub(super) fn without<T: Default>(f: impl FnOnce() -> T) -> T {
    let _state = InitialState::enter();
    catch_unwind(AssertUnwindSafe(f)).unwrap_or_default()
}

/// The current context, if nobody traces, no list is open and the thread computes as usual: then a command is nothing but
/// what the engine does. For code that cannot panic and keeps the context no longer than its call.
#[inline(always)]
pub(super) fn quiet<'a>() -> Option<&'a mut Context> {
    // SAFETY: as in `with_handle`.
    let context = unsafe { &mut get().as_mut()?.context };
    (context.flags.none() && float_control::is_initial()).then_some(context)
}
