//! A thread that walks while the scene is still taking primitives. A long Begin/End is one thread's work as far as its
//! vertices and the setup of its primitives go, since GL calls come one after the other; what is set up can be walked
//! meanwhile. The scene hands over its primitives load by load, each in a geometry of its own, and with the first the
//! framebuffer itself, which comes back when the thread is waited for. Loads are walked in the order in which they come,
//! so a pixel sees the same fragments in the same order as without the thread, and the result is the same to the last bit.
//! Since walking small triangles takes less time than setting them up, a load may have primitives that the thread sets up
//! first.

use super::binning::{self, Flush};
use super::emit::Emitter;
use super::geometry::Geometry;
use super::program_trait::Shader;
use super::scene::{Builder, Draw};
use super::setup::planes::Recipe;
use super::worker_pool::Crew;
use crate::framebuffer::Framebuffer;
use crate::simd::Level;
use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

/// Sets primitives up: something that a thread can be told to do.
pub type SetUp<P> = Box<dyn FnOnce(&mut Builder<'_, P>) + Send>;

/// Primitives that are to be walked, and the draws that they belong to.
pub(super) struct Load<P> {
    pub draws: Vec<Arc<Draw<P>>>,
    pub geometry: Geometry,
    /// Primitives of the last draw that come after those.
    pub more: Option<(SetUp<P>, Recipe)>,
}

impl<P> fmt::Debug for Load<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = self.geometry.memory();
        f.debug_struct("Load").field("bytes", &bytes).field("more", &self.more.is_some()).finish()
    }
}

impl<P> Load<P> {
    fn set_up(&mut self) {
        let Some((more, recipe)) = self.more.take() else { return };
        let Some(draw) = self.draws.last() else { return };
        let (index, mut stipple) = ((self.draws.len() - 1) as u32, 0);
        let mut to = Builder::new(draw, index, &recipe, &mut self.geometry, &mut stipple);
        more(&mut to);
        to.settle();
    }
}

/// How loads are walked.
#[derive(Debug)]
pub(super) struct Manner {
    /// Fragments after which a batch is cut.
    pub cut: usize,
    /// What emitters work at.
    pub level: Level,
    /// Who walks, and how many of them.
    pub crew: Arc<Crew>,
    pub threads: usize,
}

/// What the thread has while it works.
#[derive(Debug)]
pub(super) struct Kit {
    pub framebuffer: Framebuffer,
    pub emitters: Vec<Emitter>,
    pub bins: Vec<Vec<u32>>,
    /// How many fragments have passed.
    pub samples: u64,
    /// The panic that has ended its work.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl Kit {
    /// Walks a load, unless one before it has come to a bad end.
    fn walk<P: Shader>(&mut self, load: &mut Load<P>, manner: &Manner) {
        if self.panic.is_some() {
            return;
        }
        let Self { framebuffer, emitters, bins, .. } = self;
        let walk = || {
            load.set_up();
            let flush = Flush { draws: &load.draws, geometry: &load.geometry, cut: manner.cut, level: manner.level };
            binning::flush(&flush, framebuffer, (&manner.crew, manner.threads), bins, emitters)
        };
        match catch_unwind(AssertUnwindSafe(walk)) {
            Ok(samples) => self.samples += samples,
            Err(panic) => self.panic = Some(panic),
        }
    }
}

/// Geometries that have been walked, for the next loads.
pub(super) type Empties = Arc<Mutex<Vec<Geometry>>>;

/// Loads that the thread may have: one that it walks, one that waits, and one that somebody was told it would take.
const MOST: usize = 3;

/// The thread, from the side of the scene.
#[derive(Debug)]
pub(super) struct Walker<P> {
    loads: Option<SyncSender<Box<Load<P>>>>,
    empties: Empties,
    /// How many loads the thread has.
    has: Arc<AtomicUsize>,
    thread: Option<JoinHandle<Option<Box<Kit>>>>,
}

impl<P: Shader + 'static> Walker<P> {
    /// Starts the thread. Gives the kit back where there can be no more threads.
    pub fn start(kit: Box<Kit>, empties: &Empties, manner: Manner) -> Result<Self, Box<Kit>> {
        let (loads, coming) = sync_channel::<Box<Load<P>>>(MOST);
        let (first, kits) = sync_channel::<Box<Kit>>(1);
        let (empties, back) = (Arc::clone(empties), Arc::clone(empties));
        let has = Arc::new(AtomicUsize::new(0));
        let left = Arc::clone(&has);
        let work = move || Some(work(kits.recv().ok()?, &coming, &back, &left, &manner));
        let thread = std::thread::Builder::new().name("fixedgl walker".into()).spawn(work);
        let Ok(thread) = thread else { return Err(kit) };
        let walker = Self { loads: Some(loads), empties, has, thread: Some(thread) };
        // The thread waits for its kit: it is not the closure's own, which is lost where no thread starts.
        first.send(kit).map_err(|unsent| unsent.0)?;
        Ok(walker)
    }
}

/// What the thread does.
fn work<P: Shader>(
    mut kit: Box<Kit>,
    loads: &Receiver<Box<Load<P>>>,
    empties: &Empties,
    left: &AtomicUsize,
    manner: &Manner,
) -> Box<Kit> {
    for mut load in loads {
        kit.walk(&mut load, manner);
        load.geometry.clear();
        empties.lock().unwrap_or_else(PoisonError::into_inner).push(load.geometry);
        left.fetch_sub(1, Ordering::Relaxed);
    }
    kit
}

impl<P> Walker<P> {
    /// How many loads the thread has that it has not walked.
    pub fn has(&self) -> usize {
        self.has.load(Ordering::Relaxed)
    }

    /// Hands a load over and gives an empty geometry for the next one. Where the thread has enough the load is given back.
    pub fn hand_over(&self, load: Box<Load<P>>) -> Result<Geometry, Box<Load<P>>> {
        let Some(loads) = &self.loads else { return Err(load) };
        self.has.fetch_add(1, Ordering::Relaxed);
        match loads.try_send(load) {
            Ok(()) => Ok(self.empties.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()),
            Err(TrySendError::Full(load) | TrySendError::Disconnected(load)) => {
                self.has.fetch_sub(1, Ordering::Relaxed);
                Err(load)
            }
        }
    }

    /// Waits until all is walked. The kit is lost only where the thread has been, for a reason that is given.
    pub fn wait(mut self) -> Result<Box<Kit>, Box<dyn Any + Send>> {
        self.loads = None;
        let kit = self.thread.take().map_or(Ok(None), JoinHandle::join)?;
        kit.ok_or_else(|| -> Box<dyn Any + Send> { Box::new("a walker without a kit") })
    }
}

impl<P> Drop for Walker<P> {
    fn drop(&mut self) {
        self.loads = None;
        if let Some(thread) = self.thread.take() {
            // Who drops a walker does not want its pixels, but its memory must not be drawn into any more.
            drop(thread.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::raster::VertexRef;
    use crate::raster::testing::{Board, Random, vertex};
    use std::panic::{AssertUnwindSafe, catch_unwind};

    /// Small triangles all over a board; after each of them something may be done.
    fn strew(board: &mut Board, count: usize, mut after: impl FnMut(&mut Board, usize)) {
        let mut random = Random(11);
        for i in 0..count {
            let [x, y] = [0; 2].map(|_| random.between(0.0, 60.0));
            board.plain([[x, y], [x + 3.0, y + 0.5], [x + 1.0, y + 3.0]]);
            after(board, i);
        }
    }

    fn board(threads: usize) -> Board {
        Board::new(64, 0, threads, 64, |_| {})
    }

    fn hand_over(board: &mut Board) {
        board.scene.hand_over(&mut board.framebuffer, board.threads);
    }

    #[test]
    fn what_is_handed_over_is_drawn_once_and_the_framebuffer_comes_back() {
        let mut alone = board(1);
        strew(&mut alone, 20_000, |board, _| hand_over(board));
        assert!(!alone.scene.is_walking(), "there is no other thread");
        let want = alone.hits();
        for threads in [2, 3, 8] {
            let mut shared = board(threads);
            let mut away = 0;
            strew(&mut shared, 20_000, |board, i| {
                if i % 64 == 0 {
                    hand_over(board);
                }
                away += usize::from(board.scene.is_walking());
                assert_eq!(board.framebuffer.width(), 64);
            });
            assert!(away > 1000 && !shared.scene.is_empty());
            assert!(shared.hits() == want, "{threads} threads");
            assert!(shared.scene.is_empty());
        }
    }

    #[test]
    fn what_the_walker_sets_up_comes_in_its_turn() {
        let drawn = |threads: usize| {
            let mut board = board(threads);
            let (mut given, mut taken) = (0, 0);
            strew(&mut board, 20_000, |board, i| {
                hand_over(board);
                if i % 500 == 499 {
                    given += 1;
                    taken += usize::from(board.scene.is_hungry());
                    let v = [[3.0, 3.0], [50.0, 7.0], [9.0, 60.0]].map(|[x, y]| vertex(x, y, 0.5, 1.0));
                    board.scene.set_up(Box::new(move |to| {
                        for _ in 0..9 {
                            let corners = v.each_ref().map(|head| VertexRef { head, slots: &[] });
                            to.triangle(corners, 2, [true; 3]);
                        }
                    }));
                    assert!(!board.scene.is_hungry());
                }
            });
            assert!(given == 40 && taken <= given);
            board.hits()
        };
        let want = drawn(1);
        assert!(want.iter().any(|hits| *hits >= 40 * 9));
        assert!(drawn(2) == want && drawn(4) == want);
    }

    #[test]
    fn a_scene_may_be_dropped_while_it_is_walked() {
        let mut board = board(2);
        strew(&mut board, 8000, |board, _| hand_over(board));
        assert!(board.scene.is_walking());
    }

    #[test]
    fn a_panic_of_the_walker_comes_to_who_waits_and_the_framebuffer_with_it() {
        let mut board = board(2);
        strew(&mut board, 8000, |board, i| {
            if i == 10 {
                let seen = &board.draw.program.seen;
                // From here on the shader panics.
                let poison = || {
                    let _seen = seen.lock();
                    panic!("meant");
                };
                std::thread::scope(|scope| drop(scope.spawn(poison).join()));
            }
            hand_over(board);
        });
        assert!(board.scene.is_walking());
        let Board { scene, framebuffer, .. } = &mut board;
        assert!(catch_unwind(AssertUnwindSafe(|| scene.wait(framebuffer))).is_err());
        assert!(!scene.is_walking());
        assert_eq!(framebuffer.band().rgba8.len(), 64 * 64);
    }
}
