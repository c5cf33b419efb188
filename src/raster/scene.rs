//! The scene: draws that have been issued and not yet rasterised, their primitives set up in issue order. Nothing touches
//! the framebuffer until the scene is flushed (`glFlush`, `glFinish`, reading pixels, or when its memory is full), so that
//! the work of many small draws can be shared among threads, by bands of rows.

use super::draw::{Draw, PrimitiveBuilder};
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::raster_thread::{FramebufferLease, GeometryPool, RasterJob, RasterThread, SetupFn};
use super::rasteriser::Rasteriser;
use super::scheduler::SplitDraw;
use super::setup::planes::SetupPlan;
use super::sink::PrimitiveSink;
use super::triangle_batch::corners::CornerLanes;
use super::vertex::VertexRef;
use crate::framebuffer::Framebuffer;
use crate::simd::Level;
use crate::state::raster::PolygonMode;
use std::mem::take;
use std::panic::resume_unwind;
use std::sync::Arc;

/// Bytes from which on a scene asks to be flushed, with one thread: about what the second-level cache holds.
const FULL_ALONE: usize = 256 << 10;
/// The same with more threads: work for some milliseconds, which is long against the start of a thread, and still within
/// the last-level cache.
const FULL_SHARED: usize = 4 << 20;
/// Bytes of small primitives that make a job for the raster thread: some two thousand triangles, which take long against
/// waking a thread. With 256 KiB the whole frame takes 9 % longer, with 1 MiB the same time.
const JOB_BYTES: usize = 512 << 10;
/// Average pixels of a primitive up to which a scene is rasterised in jobs; with more, all threads share a flush.
const SMALL_PIXELS: u64 = 16;

/// Draws and primitives that wait for a flush.
#[derive(Debug)]
pub struct Scene<P> {
    draws: Vec<Arc<Draw<P>>>,
    geometry: SceneGeometry,
    plan: SetupPlan,
    /// Counter of the line stipple.
    stipple: u32,
    /// Bytes from which on the scene asks to be flushed.
    most_bytes: usize,
    rasteriser: Rasteriser,
    /// The thread that has the framebuffer and the rasteriser, if one has them.
    raster_thread: Option<RasterThread<P>>,
    free: GeometryPool,
    wants_setup_work: bool,
    has_large_primitives: bool,
}

impl<P: FragmentProgram> Scene<P> {
    /// An empty scene for a number of threads and an instruction set. Batches are cut after `cut` fragments; any number
    /// gives the same result.
    #[must_use]
    pub fn new(threads: usize, cut: usize, level: Level) -> Self {
        Self {
            draws: Vec::new(),
            geometry: SceneGeometry::default(),
            plan: SetupPlan::new(level),
            stipple: 0,
            most_bytes: if threads > 1 { FULL_SHARED } else { FULL_ALONE },
            rasteriser: Rasteriser::new(threads, cut, level),
            raster_thread: None,
            free: GeometryPool::default(),
            wants_setup_work: false,
            has_large_primitives: false,
        }
    }

    /// From here on, until the next draw, each triangle is set up alone.
    #[cfg(test)]
    pub(super) fn batch_nothing(&mut self) {
        self.plan.batch_nothing();
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
        self.memory() > self.most_bytes || self.draws.len() > 4096
    }

    /// Takes the primitives of the current draw, unless that draws nothing.
    #[must_use]
    pub fn builder(&mut self) -> Option<PrimitiveBuilder<'_, P>> {
        let draw = self.draws.last().filter(|draw| !draw.program.draws_nothing())?;
        let index = (self.draws.len() - 1) as u32;
        Some(PrimitiveBuilder::new(draw, index, &self.plan, &mut self.geometry, &mut self.stipple))
    }

    /// Sets up the triangles that wait in the batch.
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

    /// Forgets all that waits and goes on with the current draw. To be called when no other thread has the framebuffer.
    pub fn discard(&mut self) {
        self.flush_batch();
        self.geometry.clear();
        let passed = self.draws.len().saturating_sub(1);
        self.draws.drain(..passed);
    }

    /// Draws all that waits and goes on with the current draw.
    pub fn make_room(&mut self, framebuffer: &mut Framebuffer, threads: usize) -> u64 {
        let samples = self.rasterise(framebuffer, threads);
        let passed = self.draws.len().saturating_sub(1);
        self.draws.drain(..passed);
        samples
    }

    /// Whether parts of the current draw may be set up apart from each other. Filled triangles have nothing in common, but
    /// a line stipple goes on from one line to the next.
    #[must_use]
    pub fn can_be_split(&self) -> bool {
        self.draws
            .last()
            .is_some_and(|draw| draw.raster.mode == [PolygonMode::Fill; 2] && !draw.program.draws_nothing())
    }

    /// Draws the parts of the current draw, after all that waits, with as many threads as there are of `scratch`. Returns
    /// how many fragments passed.
    pub fn draw_split<W: SplitDraw<P>>(
        &mut self,
        framebuffer: &mut Framebuffer,
        split: &W,
        scratch: &mut [W::Scratch],
    ) -> u64 {
        let before = self.make_room(framebuffer, scratch.len());
        let workers = scratch.len().min(split.count());
        let scratch = scratch.get_mut(..workers).unwrap_or_default();
        let Some(draw) = self.draws.last() else { return before };
        before + self.rasteriser.draw_split((draw, &self.plan), split, scratch, framebuffer)
    }

    /// Whether another thread has the framebuffer.
    #[must_use]
    pub fn is_rasterising(&self) -> bool {
        self.raster_thread.is_some()
    }

    /// Waits for the [raster thread](Self::start_rasterising) and takes the framebuffer back. Returns how many fragments
    /// passed.
    pub fn wait(&mut self, framebuffer: &mut Framebuffer) -> u64 {
        let Some(raster_thread) = self.raster_thread.take() else { return 0 };
        let lease = raster_thread.wait().unwrap_or_else(|panic| resume_unwind(panic));
        *framebuffer = lease.framebuffer;
        self.rasteriser = lease.rasteriser;
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
        let samples = self.rasteriser.flush(&self.draws, &self.geometry, framebuffer, threads);
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

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize) {
        if let Some(mut builder) = self.builder() {
            builder.line(ends, provoking);
        }
    }

    fn restart_stipple(&mut self) {
        self.stipple = 0;
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
    /// Gives the primitives that wait to the raster thread, if they are many and small and the thread has little to do.
    /// From then on the thread has the framebuffer, until somebody [waits](Self::wait).
    pub fn start_rasterising(&mut self, framebuffer: &mut Framebuffer, threads: usize) {
        if threads < 2 || self.memory() < JOB_BYTES {
            return;
        }
        if self.geometry.pixels > SMALL_PIXELS * self.geometry.prims.len() as u64 {
            self.has_large_primitives = self.raster_thread.is_none();
            return;
        }
        self.flush_batch();
        let is_first = self.raster_thread.is_none();
        if is_first {
            self.start_raster_thread(framebuffer, threads - 1);
        }
        let wants_job = |scene: &Self| scene.raster_thread.as_ref().is_some_and(RasterThread::wants_job);
        if wants_job(self) {
            drop(self.send_job(None));
            // Not at the first job: the Begin/End may end before enough vertices are collected for a setup job.
            self.wants_setup_work = !is_first && wants_job(self);
        }
    }

    /// Whether the primitives of this draw are many and so large that threads had better share a flush.
    #[must_use]
    pub fn has_large_primitives(&self) -> bool {
        self.has_large_primitives
    }

    /// Whether the raster thread would set up primitives, too: it rasterises faster than this thread sets up.
    #[must_use]
    pub fn wants_setup_work(&self) -> bool {
        self.wants_setup_work && self.raster_thread.is_some()
    }

    /// Draws primitives of the current draw. The raster thread sets them up if it can, otherwise this one.
    pub fn set_up(&mut self, more: SetupFn<P>) {
        self.flush_batch();
        self.wants_setup_work = false;
        if let (Some(more), Some(mut builder)) = (self.send_job(Some(more)), self.builder()) {
            more(&mut builder);
        }
    }

    /// Sends what waits, and primitives that are to be set up. Those are returned where the thread takes no job.
    fn send_job(&mut self, more: Option<SetupFn<P>>) -> Option<SetupFn<P>> {
        let Some(raster_thread) = &self.raster_thread else { return more };
        let more = more.map(|more| (more, self.plan.clone()));
        let job = RasterJob { draws: self.draws.clone(), geometry: take(&mut self.geometry), more };
        match raster_thread.send(Box::new(job)) {
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
        let (framebuffer_lent, rasteriser) = (framebuffer.take(), self.rasteriser.take());
        let lease = FramebufferLease { framebuffer: framebuffer_lent, rasteriser, threads, samples: 0, panic: None };
        match RasterThread::start(Box::new(lease), &self.free) {
            Ok(raster_thread) => self.raster_thread = Some(raster_thread),
            Err(lease) => {
                *framebuffer = lease.framebuffer;
                self.rasteriser = lease.rasteriser;
            }
        }
    }
}
