//! The current context of a thread (as GLX and WGL have it). A command takes the context out of its place for as long as
//! it runs, so nothing is borrowed and nothing can be borrowed twice: a callback that calls GL finds no context. It comes
//! back also where a callback panics.

use crate::context::Context;
use std::cell::Cell;

thread_local! {
    static CURRENT: Cell<Option<Box<Context>>> = const { Cell::new(None) };
    static MISSED: Cell<u64> = const { Cell::new(0) };
}

/// Makes a context current in this thread and returns the one that was.
pub fn make_current(context: Context) -> Option<Context> {
    swap(Some(Box::new(context)))
}

/// Leaves this thread without a current context and returns the one that was.
pub fn take_current() -> Option<Context> {
    swap(None)
}

fn swap(context: Option<Box<Context>>) -> Option<Context> {
    CURRENT.try_with(|current| current.replace(context)).ok().flatten().map(|context| *context)
}

/// Calls `f` with the current context of this thread; `None` without one.
pub fn with_current<T>(f: impl FnOnce(&mut Context) -> T) -> Option<T> {
    take().context().map(f)
}

/// How many commands of this thread found no current context and did nothing.
#[must_use]
pub fn calls_without_context() -> u64 {
    MISSED.get()
}

/// The context while a command runs, if there is one. Dropping it puts the context back in its place.
pub(crate) struct Taken(Option<Box<Context>>);

impl Taken {
    /// The context.
    #[inline]
    pub(crate) fn context(&mut self) -> Option<&mut Context> {
        self.0.as_deref_mut()
    }
}

impl Drop for Taken {
    /// The context becomes current again, unless a callback has made another one current meanwhile.
    #[inline]
    fn drop(&mut self) {
        let Some(context) = self.0.take() else { return };
        let _ = CURRENT.try_with(|current| {
            if let Some(newer) = current.replace(Some(context)) {
                current.set(Some(newer));
            }
        });
    }
}

/// Takes the context for one command.
#[inline]
pub(crate) fn take() -> Taken {
    Taken(CURRENT.try_with(Cell::take).ok().flatten())
}

/// A command without a context: the first one of a thread is reported.
#[cold]
#[track_caller]
pub(crate) fn missed(name: &str) {
    let place = std::panic::Location::caller();
    let _ = MISSED.try_with(|missed| {
        if missed.get() == 0 {
            eprintln!("{place}: {name} does nothing: no context is current in this thread (fixedgl::c::make_current)");
        }
        missed.set(missed.get() + 1);
    });
}
