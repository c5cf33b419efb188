//! A thread that rasterises while the scene still takes primitives. The vertices of a long Begin/End, and the setup of its
//! primitives, are one thread's work, since GL calls come one after the other; what is set up can be rasterised meanwhile.
//! The scene sends jobs, each with a geometry of its own, and lends the framebuffer until the thread is waited for. Jobs are
//! done in order, so a pixel sees the same fragments in the same order as without the thread. Rasterising small triangles
//! takes less time than setting them up, so a job may carry primitives that the thread sets up itself.

use super::draw::{Draw, PrimitiveBuilder};
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::rasteriser::Rasteriser;
use super::setup::planes::SetupPlan;
use crate::framebuffer::Framebuffer;
use std::any::Any;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

/// Sets up primitives: work that can be given to another thread.
pub type SetupFn<P> = Box<dyn FnOnce(&mut PrimitiveBuilder<'_, P>) + Send>;

/// Primitives to be rasterised, and the draws that they belong to.
pub(super) struct RasterJob<P> {
    pub draws: Vec<Arc<Draw<P>>>,
    pub geometry: SceneGeometry,
    /// Primitives of the last draw that come after those, not yet set up.
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

/// What the thread has while it works, and gives back when it is waited for.
#[derive(Debug)]
pub(super) struct FramebufferLease {
    pub framebuffer: Framebuffer,
    pub rasteriser: Rasteriser,
    /// With how many threads the rasteriser works.
    pub threads: usize,
    /// How many fragments have passed.
    pub samples: u64,
    /// The panic that has ended the work.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl FramebufferLease {
    /// Does a job, unless one before it has panicked.
    fn run<P: FragmentProgram>(&mut self, job: &mut RasterJob<P>) {
        if self.panic.is_some() {
            return;
        }
        let Self { framebuffer, rasteriser, threads, .. } = self;
        let work = || {
            job.set_up();
            rasteriser.flush(&job.draws, &job.geometry, framebuffer, *threads)
        };
        match catch_unwind(AssertUnwindSafe(work)) {
            Ok(samples) => self.samples += samples,
            Err(panic) => self.panic = Some(panic),
        }
    }
}

/// Free list of geometries, for the next jobs.
pub(super) type GeometryPool = Arc<Mutex<Vec<SceneGeometry>>>;

/// Most jobs in the queue: one at work, one that waits, and one that the scene was told there is room for.
const MOST_JOBS: usize = 3;

/// The thread, as the scene sees it.
#[derive(Debug)]
pub(super) struct RasterThread<P> {
    jobs: Option<SyncSender<Box<RasterJob<P>>>>,
    free: GeometryPool,
    /// How many jobs have been sent and not been done.
    pending: Arc<AtomicUsize>,
    thread: Option<JoinHandle<Option<Box<FramebufferLease>>>>,
}

impl<P: FragmentProgram + 'static> RasterThread<P> {
    /// Starts the thread. Gives the lease back where the system has no more threads.
    pub fn start(lease: Box<FramebufferLease>, free: &GeometryPool) -> Result<Self, Box<FramebufferLease>> {
        let (jobs, receiver) = sync_channel::<Box<RasterJob<P>>>(MOST_JOBS);
        let (first, leases) = sync_channel::<Box<FramebufferLease>>(1);
        let pending = Arc::new(AtomicUsize::new(0));
        let (done, back) = (Arc::clone(&pending), Arc::clone(free));
        let work = move || Some(run_jobs(leases.recv().ok()?, &receiver, &back, &done));
        let thread = std::thread::Builder::new().name("fixedgl raster".into()).spawn(work);
        let Ok(thread) = thread else { return Err(lease) };
        let raster_thread = Self { jobs: Some(jobs), free: Arc::clone(free), pending, thread: Some(thread) };
        // The lease is sent: what the closure owns is lost where no thread starts.
        first.send(lease).map_err(|unsent| unsent.0)?;
        Ok(raster_thread)
    }
}

/// What the thread does: jobs in order, until there will be no more.
fn run_jobs<P: FragmentProgram>(
    mut lease: Box<FramebufferLease>,
    jobs: &Receiver<Box<RasterJob<P>>>,
    free: &GeometryPool,
    pending: &AtomicUsize,
) -> Box<FramebufferLease> {
    for mut job in jobs {
        lease.run(&mut job);
        job.geometry.clear();
        free.lock().unwrap_or_else(PoisonError::into_inner).push(job.geometry);
        pending.fetch_sub(1, Ordering::Relaxed);
    }
    lease
}

impl<P> RasterThread<P> {
    /// Whether another job should be sent now: there is none in the queue besides the one at work.
    pub fn wants_job(&self) -> bool {
        self.pending.load(Ordering::Relaxed) < 2
    }

    /// Sends a job and returns an empty geometry for the next one; the job where the queue is full.
    pub fn send(&self, job: Box<RasterJob<P>>) -> Result<SceneGeometry, Box<RasterJob<P>>> {
        let Some(jobs) = &self.jobs else { return Err(job) };
        self.pending.fetch_add(1, Ordering::Relaxed);
        match jobs.try_send(job) {
            Ok(()) => Ok(self.free.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()),
            Err(TrySendError::Full(job) | TrySendError::Disconnected(job)) => {
                self.pending.fetch_sub(1, Ordering::Relaxed);
                Err(job)
            }
        }
    }

    /// Waits until all jobs are done. The lease is lost only with the thread itself, whose panic is returned.
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
            // Nobody wants the pixels any more, but the thread must not outlive the scene.
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
    fn scatter(canvas: &mut TestCanvas, count: usize, mut after: impl FnMut(&mut TestCanvas, usize)) {
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
        canvas.scene.start_rasterising(&mut canvas.framebuffer, canvas.threads);
    }

    #[test]
    fn what_is_sent_is_drawn_once_and_the_framebuffer_comes_back() {
        let mut alone = canvas(1);
        scatter(&mut alone, 20_000, |canvas, _| hand_over(canvas));
        assert!(!alone.scene.is_rasterising(), "there is no other thread");
        let want = alone.hits();
        for threads in [2, 3, 8] {
            let mut shared = canvas(threads);
            let mut away = 0;
            scatter(&mut shared, 20_000, |canvas, i| {
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
    fn what_the_raster_thread_sets_up_comes_in_its_turn() {
        let drawn = |threads: usize| {
            let mut canvas = canvas(threads);
            let (mut given, mut taken) = (0, 0);
            scatter(&mut canvas, 20_000, |canvas, i| {
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
    fn a_scene_may_be_dropped_while_it_is_rasterised() {
        let mut canvas = canvas(2);
        scatter(&mut canvas, 8000, |canvas, _| hand_over(canvas));
        assert!(canvas.scene.is_rasterising());
    }

    #[test]
    fn a_panic_of_the_raster_thread_reaches_who_waits_and_the_framebuffer_with_it() {
        let mut canvas = canvas(2);
        scatter(&mut canvas, 8000, |canvas, i| {
            if i == 10 {
                let seen = &canvas.draw.program.seen;
                // From here on the program panics.
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
