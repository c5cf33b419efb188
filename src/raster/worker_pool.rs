//! Threads that share work with the calling thread and are done when the call returns. With the feature `pool` they wait
//! for the next call as long as their scene lives: waking one takes 5 to 20 us, starting and joining one 40 to 60. Without
//! the feature they are started for each call. Where the system has no more threads the calling thread does their work.

use std::sync::{Mutex, PoisonError};
#[cfg(feature = "pool")]
use std::sync::{
    OnceLock,
    atomic::{AtomicUsize, Ordering},
};

/// Work that another thread is worth, in pixels of one colour: about 60 us on the machine that was measured, and 120
/// where threads are started for it.
pub(super) const WORTH_A_THREAD: u64 = if cfg!(feature = "pool") { 1 << 20 } else { 1 << 21 };

/// How often a thread that has nothing left to do asks whether the others have ended, before it sleeps.
#[cfg(feature = "pool")]
const SPINS: u32 = 1000;

/// Threads that help the calling thread.
#[derive(Debug)]
pub(super) struct WorkerPool {
    /// How many threads there are, the calling one included.
    #[cfg(feature = "pool")]
    threads: usize,
    /// The waiting threads, from the first call on. None inside where the system has no more threads.
    #[cfg(feature = "pool")]
    pool: OnceLock<Option<rayon_core::ThreadPool>>,
}

impl WorkerPool {
    /// A pool of a number of threads, the calling one included. None of them is started yet.
    #[cfg_attr(
        not(feature = "pool"),
        expect(unused_variables, reason = "as many threads are started as there is work for")
    )]
    pub fn new(threads: usize) -> Self {
        Self {
            #[cfg(feature = "pool")]
            threads,
            #[cfg(feature = "pool")]
            pool: OnceLock::new(),
        }
    }

    /// Calls `work` once with each of `items`, the first of them on the calling thread, and waits for all. There may be
    /// fewer threads than calls, down to the calling one alone, so no call may wait for another that has not begun.
    pub fn share<T: Send>(&self, mut items: impl ExactSizeIterator<Item = T> + Send, work: impl Fn(T) + Sync) {
        let Some(first) = items.next() else { return };
        let work = &work;
        #[cfg(feature = "pool")]
        if let Some(pool) = self.pool() {
            let (mut begun, ended) = (0, &AtomicUsize::new(0));
            return pool.in_place_scope(|scope| {
                for item in items {
                    begun += 1;
                    scope.spawn(move |_| {
                        work(item);
                        ended.fetch_add(1, Ordering::Release);
                    });
                }
                work(first);
                spin_until(|| ended.load(Ordering::Acquire) == begun);
            });
        }
        let helpers = items.len();
        let items = Mutex::new(items);
        let work_on = || {
            loop {
                let next = items.lock().unwrap_or_else(PoisonError::into_inner).next();
                let Some(item) = next else { break };
                work(item);
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..helpers {
                // Who finds no thread leaves the items to the others.
                if std::thread::Builder::new().name("fixedgl".into()).spawn_scoped(scope, work_on).is_err() {
                    break;
                }
            }
            work(first);
            work_on();
        });
    }

    #[cfg(feature = "pool")]
    fn pool(&self) -> Option<&rayon_core::ThreadPool> {
        let build = || {
            let named = rayon_core::ThreadPoolBuilder::new().thread_name(|i| format!("fixedgl {i}"));
            named.num_threads(self.threads.saturating_sub(1).max(1)).build().ok()
        };
        self.pool.get_or_init(build).as_ref()
    }
}

/// Waits 20 to 40 us for something that is about to happen: waking a sleeping thread takes as long.
#[cfg(feature = "pool")]
fn spin_until(until: impl Fn() -> bool) {
    for _ in 0..SPINS {
        if until() {
            break;
        }
        std::hint::spin_loop();
    }
}

#[cfg(test)]
mod tests {
    use super::WorkerPool;
    use std::sync::Mutex;

    #[test]
    fn each_item_is_worked_on_once_whatever_the_number_of_threads() {
        for threads in [1, 2, 5] {
            let pool = WorkerPool::new(threads);
            for count in [0, 1, 2, 5, 40] {
                let done = Mutex::new(Vec::new());
                pool.share(0..count, |item| done.lock().expect("nobody panics").push(item));
                let mut done = done.into_inner().expect("nobody panics");
                done.sort_unstable();
                assert_eq!(done, Vec::from_iter(0..count), "{threads} threads");
            }
        }
    }

    #[test]
    fn a_panic_of_a_helper_reaches_the_caller_and_the_pool_goes_on() {
        let pool = WorkerPool::new(3);
        let work = |item: u32| assert_ne!(item, 2, "the third one");
        let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| pool.share(0..3, work)));
        assert!(caught.is_err(), "the panic is lost");
        pool.share(3..9, work);
    }
}
