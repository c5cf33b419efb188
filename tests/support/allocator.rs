//! The allocator of the test program: the system's, with two things that tests ask for. A large allocation of a thread
//! can be made to fail, and the bytes that a thread holds are counted. Both are the thread's own, so tests that run
//! beside each other do not see each other; what is measured draws with one thread.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// Bytes from which on an allocation can be made to fail: beyond what the pools of a context hold, which are bounded and
/// may abort.
pub const LARGE: usize = 600 << 10;

thread_local! {
    /// Large allocations until one fails; 0 while none is to.
    static UNTIL: Cell<u32> = const { Cell::new(0) };
    static HAS_FAILED: Cell<bool> = const { Cell::new(false) };
    /// Bytes allocated less bytes freed by this thread, and the most since [`measure`] began.
    static HELD: Cell<isize> = const { Cell::new(0) };
    static MOST: Cell<isize> = const { Cell::new(0) };
}

struct Allocator;

#[global_allocator]
static ALLOCATOR: Allocator = Allocator;

/// Whether this allocation fails.
fn fails(bytes: usize) -> bool {
    if bytes < LARGE {
        return false;
    }
    let until = UNTIL.get();
    UNTIL.set(until.saturating_sub(1));
    HAS_FAILED.set(HAS_FAILED.get() || until == 1);
    until == 1
}

fn count(bytes: isize) {
    HELD.set(HELD.get() + bytes);
    MOST.set(MOST.get().max(HELD.get()));
}

#[expect(unsafe_code, reason = "an allocator is unsafe to write")]
// SAFETY: everything is the system allocator's answer, or null.
unsafe impl GlobalAlloc for Allocator {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if fails(layout.size()) {
            return std::ptr::null_mut();
        }
        count(layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        if fails(layout.size()) {
            return std::ptr::null_mut();
        }
        count(layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count(-layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        if fails(size) {
            return std::ptr::null_mut();
        }
        count(size.cast_signed() - layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.realloc(memory, layout, size) }
    }
}

/// Runs `f` while the n-th large allocation of this thread (from 1 on) fails, and says whether there were so many.
pub fn failing<T>(n: u32, f: impl FnOnce() -> T) -> (T, bool) {
    HAS_FAILED.set(false);
    UNTIL.set(n);
    let result = f();
    UNTIL.set(0);
    (result, HAS_FAILED.get())
}

/// What a command took.
#[derive(Clone, Copy, Debug)]
pub struct Taken {
    /// Seconds of this thread on a processor.
    pub seconds: f64,
    /// The most bytes that this thread held beyond those that it held before.
    pub bytes: usize,
}

/// Runs `f` and says what it took.
pub fn measure<T>(f: impl FnOnce() -> T) -> (T, Taken) {
    let (seconds, held) = (seconds_on_processor(), HELD.get());
    MOST.set(held);
    let result = f();
    let bytes = (MOST.get() - held).max(0).cast_unsigned();
    (result, Taken { seconds: seconds_on_processor() - seconds, bytes })
}

/// Time of this thread on a processor, so that a machine with more to do does not fail a test; the clock where the system
/// does not tell.
fn seconds_on_processor() -> f64 {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let told = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    told.map_or_else(
        || START.get_or_init(std::time::Instant::now).elapsed().as_secs_f64(),
        |nanoseconds| nanoseconds / 1e9,
    )
}

/// Fails where a command took more than two seconds, or held more than 1 GiB beyond what was handed over: the budget that
/// the page on errors states.
#[track_caller]
pub fn within_budget<T>(what: impl std::fmt::Debug, f: impl FnOnce() -> T) -> T {
    let (result, taken) = measure(f);
    // A build for tests is about six times as slow as a release.
    let most = if cfg!(debug_assertions) { 12.0 } else { 2.0 };
    assert!(taken.seconds < most && taken.bytes <= (1 << 30) + (1 << 22), "{what:?} took {taken:?}");
    result
}
