//! The scene: draws that have been issued and not yet rasterised, their primitives set up in issue order. Nothing touches
//! the framebuffer until the scene is flushed (`glFlush`, `glFinish`, reading pixels, or when its memory is full), so the
//! work of many small draws can be shared out to bands of rows and their workers.

use super::binning::{self, RasterPass};
use super::draw::{Draw, PrimitiveBuilder};
use super::emit::Emitter;
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::raster_thread::{FramebufferLease, GeometryPool, RasterJob, RasterOptions, RasterThread, SetupFn};
use super::scheduler::{BinnedGeometry, SplitDraw, SplitDrawRun};
use super::setup::planes::SetupPlan;
use super::sink::PrimitiveSink;
use super::triangle_batch::corners::CornerLanes;
use super::vertex::VertexRef;
use super::worker_pool::WorkerPool;
use crate::framebuffer::Framebuffer;
use crate::simd::{LANES, Level};
use crate::state::raster::PolygonMode;
use std::mem::take;
use std::panic::resume_unwind;
use std::sync::{Arc, RwLock};

/// Bytes after which a scene wants to be flushed where one thread works on it: about what the second-level cache holds.
const SMALL: usize = 256 << 10;
/// The same where the work is shared out: enough for all workers to be busy for some milliseconds, which is long against the
/// start of a thread, and still within the last cache.
const LARGE: usize = 4 << 20;
/// Bytes of small primitives that are worth handing over to a raster thread: some two thousand triangles, whose walk is long
/// against waking a thread. With 256 KiB the whole frame takes 9 % longer, with 1 MiB as long.
const JOB_BYTES: usize = 512 << 10;
/// Pixels of a primitive, on average, up to which a scene is walked in jobs; with more, all threads share the walk.
const FEW: u64 = 16;

/// Draws and primitives that wait for a flush.
#[derive(Debug)]
pub struct Scene<P> {
    draws: Vec<Arc<Draw<P>>>,
    geometry: SceneGeometry,
    plan: SetupPlan,
    stipple: u32,
    cut: usize,
    bound: usize,
    bins: Vec<Vec<u32>>,
    workers: Arc<WorkerPool>,
    emitters: Vec<Emitter>,
    binned: Vec<RwLock<BinnedGeometry>>,
    /// The thread that has the framebuffer, if one has it.
    raster_thread: Option<RasterThread<P>>,
    free: GeometryPool,
    wants_setup_work: bool,
    has_large_primitives: bool,
}

impl<P: FragmentProgram> Scene<P> {
    /// An empty scene for a number of threads. Batches are cut after `cut` fragments; any number gives the same result.
    #[must_use]
    pub fn new(threads: usize, cut: usize) -> Self {
        Self {
            draws: Vec::new(),
            geometry: SceneGeometry::default(),
            plan: SetupPlan::new(Level::detect()),
            stipple: 0,
            cut: cut.clamp(1, LANES),
            bound: if threads > 1 { LARGE } else { SMALL },
            bins: Vec::new(),
            workers: Arc::new(WorkerPool::new(threads)),
            emitters: Vec::new(),
            binned: Vec::new(),
            raster_thread: None,
            free: GeometryPool::default(),
            wants_setup_work: false,
            has_large_primitives: false,
        }
    }

    /// The same scene, whose planes are made at a level.
    #[must_use]
    pub fn at_level(mut self, level: Level) -> Self {
        self.plan = SetupPlan::new(level);
        self
    }

    /// From here on, until the next draw, each triangle is set up alone.
    #[cfg(test)]
    pub(super) fn group_nothing(&mut self) {
        self.plan.group_nothing();
    }

    /// Says what the primitives to come are drawn with. Returns the index of the draw.
    pub fn begin_draw(&mut self, draw: Arc<Draw<P>>) -> u32 {
        self.flush_batch();
        self.plan.set_draw(draw.program.layout(), &draw.raster);
        self.has_large_primitives = false;
        self.draws.push(draw);
        (self.draws.len() - 1) as u32
    }

    /// Whether nothing waits and nothing is being drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.geometry.is_empty() && self.raster_thread.is_none()
    }

    /// Bytes that the waiting primitives take.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.geometry.memory()
    }

    /// Whether the scene should be flushed before more is drawn ([`make_room`](Self::make_room)). To be asked after
    /// every few hundred primitives at most.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.memory() > self.bound || self.draws.len() > 4096
    }

    /// Where the primitives of the current draw go, unless nothing can come of them.
    #[must_use]
    pub fn builder(&mut self) -> Option<PrimitiveBuilder<'_, P>> {
        let draw = self.draws.last().filter(|draw| !draw.program.draws_nothing())?;
        let index = (self.draws.len() - 1) as u32;
        Some(PrimitiveBuilder::new(draw, index, &self.plan, &mut self.geometry, &mut self.stipple))
    }

    /// Files the small triangles that wait.
    pub(super) fn flush_batch(&mut self) {
        if let Some(mut builder) = self.builder() {
            builder.flush_batch();
        }
    }

    /// Draws all that waits and forgets it, draws included. Returns how many fragments passed, as far as programs count.
    pub fn flush(&mut self, framebuffer: &mut Framebuffer, threads: usize) -> u64 {
        let samples = self.rasterise(framebuffer, threads);
        self.draws.clear();
        samples
    }

    /// Draws all that waits and goes on with the current draw.
    pub fn make_room(&mut self, framebuffer: &mut Framebuffer, threads: usize) -> u64 {
        let samples = self.rasterise(framebuffer, threads);
        let passed = self.draws.len().saturating_sub(1);
        self.draws.drain(..passed);
        samples
    }

    /// Whether pieces of the current draw may be set up apart from each other: filled triangles have nothing in common,
    /// but the stipple of lines goes on from one to the next.
    #[must_use]
    pub fn can_be_split(&self) -> bool {
        self.draws
            .last()
            .is_some_and(|draw| draw.raster.mode == [PolygonMode::Fill; 2] && !draw.program.draws_nothing())
    }

    /// Draws pieces of the current draw, after all that waits, with as many threads as there are of `scratch`. Returns how
    /// many fragments passed.
    pub fn draw_split<W: SplitDraw<P>>(
        &mut self,
        framebuffer: &mut Framebuffer,
        pieces: &W,
        scratch: &mut [W::Scratch],
    ) -> u64 {
        let before = self.make_room(framebuffer, scratch.len());
        let workers = scratch.len().min(pieces.count());
        let scratch = scratch.get_mut(..workers).unwrap_or_default();
        let Some(draw) = self.draws.last() else { return before };
        let round = SplitDrawRun { draw, plan: &self.plan, workers: &self.workers, cut: self.cut };
        before + round.run(pieces, scratch, framebuffer, &mut self.binned, &mut self.emitters)
    }

    /// Whether another thread has the framebuffer.
    #[must_use]
    pub fn is_rasterising(&self) -> bool {
        self.raster_thread.is_some()
    }

    /// Waits for what was [handed over](Self::hand_over): the framebuffer is back. Returns how many fragments passed.
    pub fn wait(&mut self, framebuffer: &mut Framebuffer) -> u64 {
        let Some(raster_thread) = self.raster_thread.take() else { return 0 };
        let lease = raster_thread.wait().unwrap_or_else(|panic| resume_unwind(panic));
        *framebuffer = lease.framebuffer;
        (self.emitters, self.bins) = (lease.emitters, lease.bins);
        if let Some(panic) = lease.panic {
            resume_unwind(panic);
        }
        lease.samples
    }

    fn rasterise(&mut self, framebuffer: &mut Framebuffer, threads: usize) -> u64 {
        let before = self.wait(framebuffer);
        self.flush_batch();
        if self.geometry.is_empty() {
            return before;
        }
        let flush =
            RasterPass { draws: &self.draws, geometry: &self.geometry, cut: self.cut, level: self.plan.level() };
        let samples = binning::flush(&flush, framebuffer, (&self.workers, threads), &mut self.bins, &mut self.emitters);
        self.geometry.clear();
        before + samples
    }
}

impl<P: FragmentProgram> PrimitiveSink for Scene<P> {
    #[inline]
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        if let Some(mut builder) = self.builder() {
            builder.triangle(corners, provoking, edges);
        }
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize, restart: bool) {
        if let Some(mut builder) = self.builder() {
            builder.line(ends, provoking, restart);
        }
    }

    fn point(&mut self, vertex: VertexRef<'_>) {
        if let Some(mut builder) = self.builder() {
            builder.point(vertex);
        }
    }

    fn culls(&self) -> [bool; 2] {
        self.draws.last().map_or([true; 2], |draw| draw.culls())
    }

    fn takes_batches(&mut self, stride: usize) -> bool {
        self.builder().is_some_and(|builder| builder.can_batch(stride))
    }

    fn take_batch(&mut self, count: usize, fill: impl FnOnce(&mut CornerLanes)) {
        if let Some(mut builder) = self.builder() {
            builder.take_batch(count, fill);
        }
    }
}

impl<P: FragmentProgram + 'static> Scene<P> {
    /// Hands the primitives that wait over to a thread that walks them while others are drawn, if they are many and small
    /// and the thread has little to do. From then on the framebuffer is away, until somebody [waits](Self::wait).
    pub fn hand_over(&mut self, framebuffer: &mut Framebuffer, threads: usize) {
        if threads < 2 || self.memory() < JOB_BYTES {
            return;
        }
        if self.geometry.pixels > FEW * self.geometry.prims.len() as u64 {
            self.has_large_primitives = self.raster_thread.is_none();
            return;
        }
        self.flush_batch();
        let is_first = self.raster_thread.is_none();
        if is_first {
            self.start_raster_thread(framebuffer, threads - 1);
        }
        let has_little =
            |scene: &Self| scene.raster_thread.as_ref().is_some_and(|raster_thread| raster_thread.has() < 2);
        if has_little(self) {
            drop(self.send_job(None));
            // A primitive that has come so far may end before more is collected.
            self.wants_setup_work = !is_first && has_little(self);
        }
    }

    /// Whether the primitives of this draw, of which there are many, are so large that threads had better share their walk.
    #[must_use]
    pub fn has_large_primitives(&self) -> bool {
        self.has_large_primitives
    }

    /// Whether the thread would take primitives to set up, besides what it has: it has walked faster than others set up.
    #[must_use]
    pub fn wants_setup_work(&self) -> bool {
        self.wants_setup_work && self.raster_thread.is_some()
    }

    /// Draws primitives of the current draw: the thread that walks sets them up, if there is one, or else this one.
    pub fn set_up(&mut self, more: SetupFn<P>) {
        self.flush_batch();
        self.wants_setup_work = false;
        if let (Some(more), Some(mut builder)) = (self.send_job(Some(more)), self.builder()) {
            more(&mut builder);
        }
    }

    /// Hands over what waits, and primitives that are to be set up, which are given back where that cannot be.
    fn send_job(&mut self, more: Option<SetupFn<P>>) -> Option<SetupFn<P>> {
        let Some(raster_thread) = &self.raster_thread else { return more };
        let more = more.map(|more| (more, self.plan.clone()));
        let job = RasterJob { draws: self.draws.clone(), geometry: take(&mut self.geometry), more };
        match raster_thread.hand_over(Box::new(job)) {
            Ok(empty) => {
                self.geometry = empty;
                let passed = self.draws.len().saturating_sub(1);
                self.draws.drain(..passed);
                None
            }
            Err(job) => {
                self.geometry = job.geometry;
                job.more.map(|(more, _)| more)
            }
        }
    }

    fn start_raster_thread(&mut self, framebuffer: &mut Framebuffer, threads: usize) {
        let (emitters, bins) = (take(&mut self.emitters), take(&mut self.bins));
        let lease = FramebufferLease { framebuffer: framebuffer.take(), emitters, bins, samples: 0, panic: None };
        let workers = Arc::clone(&self.workers);
        let options = RasterOptions { cut: self.cut, level: self.plan.level(), workers, threads };
        match RasterThread::start(Box::new(lease), &self.free, options) {
            Ok(raster_thread) => self.raster_thread = Some(raster_thread),
            Err(lease) => {
                *framebuffer = lease.framebuffer;
                (self.emitters, self.bins) = (lease.emitters, lease.bins);
            }
        }
    }
}
