//! A thread that walks while the scene is still taking primitives. A long Begin/End is one thread's work as far as its
//! vertices and the setup of its primitives go, since GL calls come one after the other; what is set up can be walked
//! meanwhile. The scene hands over its primitives job by job, each in a geometry of its own, and with the first the
//! framebuffer itself, which comes back when the thread is waited for. Loads are walked in the order in which they come,
//! so a pixel sees the same fragments in the same order as without the thread, and the result is the same to the last bit.
//! Since walking small triangles takes less time than setting them up, a job may have primitives that the thread sets up
//! first.

use super::binning::{self, RasterPass};
use super::draw::{Draw, PrimitiveBuilder};
use super::emit::Emitter;
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::setup::planes::SetupPlan;
use super::worker_pool::WorkerPool;
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
pub type SetupFn<P> = Box<dyn FnOnce(&mut PrimitiveBuilder<'_, P>) + Send>;

/// Primitives that are to be walked, and the draws that they belong to.
pub(super) struct RasterJob<P> {
    pub draws: Vec<Arc<Draw<P>>>,
    pub geometry: SceneGeometry,
    /// Primitives of the last draw that come after those.
    pub more: Option<(SetupFn<P>, SetupPlan)>,
}

impl<P> fmt::Debug for RasterJob<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = self.geometry.memory();
        f.debug_struct("RasterJob").field("bytes", &bytes).field("more", &self.more.is_some()).finish()
    }
}

impl<P> RasterJob<P> {
    fn set_up(&mut self) {
        let Some((more, plan)) = self.more.take() else { return };
        let Some(draw) = self.draws.last() else { return };
        let (index, mut stipple) = ((self.draws.len() - 1) as u32, 0);
        let mut to = PrimitiveBuilder::new(draw, index, &plan, &mut self.geometry, &mut stipple);
        more(&mut to);
        to.flush_batch();
    }
}

/// How jobs are walked.
#[derive(Debug)]
pub(super) struct RasterOptions {
    /// Fragments after which a batch is cut.
    pub cut: usize,
    /// What emitters work at.
    pub level: Level,
    /// Who walks, and how many of them.
    pub workers: Arc<WorkerPool>,
    pub threads: usize,
}

/// What the thread has while it works.
#[derive(Debug)]
pub(super) struct FramebufferLease {
    pub framebuffer: Framebuffer,
    pub emitters: Vec<Emitter>,
    pub bins: Vec<Vec<u32>>,
    /// How many fragments have passed.
    pub samples: u64,
    /// The panic that has ended its work.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl FramebufferLease {
    /// Walks a job, unless one before it has come to a bad end.
    fn walk<P: FragmentProgram>(&mut self, job: &mut RasterJob<P>, options: &RasterOptions) {
        if self.panic.is_some() {
            return;
        }
        let Self { framebuffer, emitters, bins, .. } = self;
        let walk = || {
            job.set_up();
            let flush =
                RasterPass { draws: &job.draws, geometry: &job.geometry, cut: options.cut, level: options.level };
            binning::flush(&flush, framebuffer, (&options.workers, options.threads), bins, emitters)
        };
        match catch_unwind(AssertUnwindSafe(walk)) {
            Ok(samples) => self.samples += samples,
            Err(panic) => self.panic = Some(panic),
        }
    }
}

/// Geometries that have been walked, for the next jobs.
pub(super) type GeometryPool = Arc<Mutex<Vec<SceneGeometry>>>;

/// Loads that the thread may have: one that it walks, one that waits, and one that somebody was told it would take.
const MOST: usize = 3;

/// The thread, from the side of the scene.
#[derive(Debug)]
pub(super) struct RasterThread<P> {
    jobs: Option<SyncSender<Box<RasterJob<P>>>>,
    free: GeometryPool,
    /// How many jobs the thread has.
    has: Arc<AtomicUsize>,
    thread: Option<JoinHandle<Option<Box<FramebufferLease>>>>,
}

impl<P: FragmentProgram + 'static> RasterThread<P> {
    /// Starts the thread. Gives the lease back where there can be no more threads.
    pub fn start(
        lease: Box<FramebufferLease>,
        free: &GeometryPool,
        options: RasterOptions,
    ) -> Result<Self, Box<FramebufferLease>> {
        let (jobs, coming) = sync_channel::<Box<RasterJob<P>>>(MOST);
        let (first, leases) = sync_channel::<Box<FramebufferLease>>(1);
        let (free, back) = (Arc::clone(free), Arc::clone(free));
        let has = Arc::new(AtomicUsize::new(0));
        let left = Arc::clone(&has);
        let work = move || Some(work(leases.recv().ok()?, &coming, &back, &left, &options));
        let thread = std::thread::Builder::new().name("fixedgl raster".into()).spawn(work);
        let Ok(thread) = thread else { return Err(lease) };
        let raster_thread = Self { jobs: Some(jobs), free, has, thread: Some(thread) };
        // The thread waits for its lease: it is not the closure's own, which is lost where no thread starts.
        first.send(lease).map_err(|unsent| unsent.0)?;
        Ok(raster_thread)
    }
}

/// What the thread does.
fn work<P: FragmentProgram>(
    mut lease: Box<FramebufferLease>,
    jobs: &Receiver<Box<RasterJob<P>>>,
    free: &GeometryPool,
    left: &AtomicUsize,
    options: &RasterOptions,
) -> Box<FramebufferLease> {
    for mut job in jobs {
        lease.walk(&mut job, options);
        job.geometry.clear();
        free.lock().unwrap_or_else(PoisonError::into_inner).push(job.geometry);
        left.fetch_sub(1, Ordering::Relaxed);
    }
    lease
}

impl<P> RasterThread<P> {
    /// How many jobs the thread has that it has not walked.
    pub fn has(&self) -> usize {
        self.has.load(Ordering::Relaxed)
    }

    /// Hands a job over and gives an empty geometry for the next one. Where the thread has enough the job is given back.
    pub fn hand_over(&self, job: Box<RasterJob<P>>) -> Result<SceneGeometry, Box<RasterJob<P>>> {
        let Some(jobs) = &self.jobs else { return Err(job) };
        self.has.fetch_add(1, Ordering::Relaxed);
        match jobs.try_send(job) {
            Ok(()) => Ok(self.free.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()),
            Err(TrySendError::Full(job) | TrySendError::Disconnected(job)) => {
                self.has.fetch_sub(1, Ordering::Relaxed);
                Err(job)
            }
        }
    }

    /// Waits until all is walked. The lease is lost only where the thread has been, for a reason that is given.
    pub fn wait(mut self) -> Result<Box<FramebufferLease>, Box<dyn Any + Send>> {
        self.jobs = None;
        let lease = self.thread.take().map_or(Ok(None), JoinHandle::join)?;
        lease.ok_or_else(|| -> Box<dyn Any + Send> { Box::new("a raster thread without its lease") })
    }
}

impl<P> Drop for RasterThread<P> {
    fn drop(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            // Who drops a raster thread does not want its pixels, but its memory must not be drawn into any more.
            drop(thread.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::raster::PrimitiveSink;
    use crate::raster::testing::{Random, TestCanvas, vertex};
    use crate::raster::vertex::VertexRef;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    /// Small triangles all over a canvas; after each of them something may be done.
    fn strew(canvas: &mut TestCanvas, count: usize, mut after: impl FnMut(&mut TestCanvas, usize)) {
        let mut random = Random(11);
        for i in 0..count {
            let [x, y] = [0; 2].map(|_| random.between(0.0, 60.0));
            canvas.plain([[x, y], [x + 3.0, y + 0.5], [x + 1.0, y + 3.0]]);
            after(canvas, i);
        }
    }

    fn canvas(threads: usize) -> TestCanvas {
        TestCanvas::new(64, 0, threads, 64, |_| {})
    }

    fn hand_over(canvas: &mut TestCanvas) {
        canvas.scene.hand_over(&mut canvas.framebuffer, canvas.threads);
    }

    #[test]
    fn what_is_handed_over_is_drawn_once_and_the_framebuffer_comes_back() {
        let mut alone = canvas(1);
        strew(&mut alone, 20_000, |canvas, _| hand_over(canvas));
        assert!(!alone.scene.is_rasterising(), "there is no other thread");
        let want = alone.hits();
        for threads in [2, 3, 8] {
            let mut shared = canvas(threads);
            let mut away = 0;
            strew(&mut shared, 20_000, |canvas, i| {
                if i % 64 == 0 {
                    hand_over(canvas);
                }
                away += usize::from(canvas.scene.is_rasterising());
                assert_eq!(canvas.framebuffer.width(), 64);
            });
            assert!(away > 1000 && !shared.scene.is_empty());
            assert!(shared.hits() == want, "{threads} threads");
            assert!(shared.scene.is_empty());
        }
    }

    #[test]
    fn what_the_walker_sets_up_comes_in_its_turn() {
        let drawn = |threads: usize| {
            let mut canvas = canvas(threads);
            let (mut given, mut taken) = (0, 0);
            strew(&mut canvas, 20_000, |canvas, i| {
                hand_over(canvas);
                if i % 500 == 499 {
                    given += 1;
                    taken += usize::from(canvas.scene.wants_setup_work());
                    let v = [[3.0, 3.0], [50.0, 7.0], [9.0, 60.0]].map(|[x, y]| vertex(x, y, 0.5, 1.0));
                    canvas.scene.set_up(Box::new(move |to| {
                        for _ in 0..9 {
                            let corners = v.each_ref().map(|head| VertexRef { head, slots: &[] });
                            to.triangle(corners, 2, [true; 3]);
                        }
                    }));
                    assert!(!canvas.scene.wants_setup_work());
                }
            });
            assert!(given == 40 && taken <= given);
            canvas.hits()
        };
        let want = drawn(1);
        assert!(want.iter().any(|hits| *hits >= 40 * 9));
        assert!(drawn(2) == want && drawn(4) == want);
    }

    #[test]
    fn a_scene_may_be_dropped_while_it_is_walked() {
        let mut canvas = canvas(2);
        strew(&mut canvas, 8000, |canvas, _| hand_over(canvas));
        assert!(canvas.scene.is_rasterising());
    }

    #[test]
    fn a_panic_of_the_walker_comes_to_who_waits_and_the_framebuffer_with_it() {
        let mut canvas = canvas(2);
        strew(&mut canvas, 8000, |canvas, i| {
            if i == 10 {
                let seen = &canvas.draw.program.seen;
                // From here on the shader panics.
                let poison = || {
                    let _seen = seen.lock();
                    panic!("meant");
                };
                std::thread::scope(|scope| drop(scope.spawn(poison).join()));
            }
            hand_over(canvas);
        });
        assert!(canvas.scene.is_rasterising());
        let TestCanvas { scene, framebuffer, .. } = &mut canvas;
        assert!(catch_unwind(AssertUnwindSafe(|| scene.wait(framebuffer))).is_err());
        assert!(!scene.is_rasterising());
        assert_eq!(framebuffer.band().rgba8.len(), 64 * 64);
    }
}
