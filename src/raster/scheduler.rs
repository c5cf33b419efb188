//! Large draws on several threads. A draw is cut into pieces, and workers do what is to be done next: one sets up the
//! primitives of a piece, in a geometry of its own, another walks a band of rows through the pieces that are set up, in the
//! order of the pieces. A pixel sees the same fragments in the same order as with one thread, so the result is the same to
//! the last bit. A worker waits only where nothing may be done: pieces are set up so far ahead of the slowest band and no
//! farther, and a band is one worker's at a time. A worker would rather walk what it has set up itself, which is in its
//! cache.

use super::binning::{self, RasterPass};
use super::draw::{Draw, PrimitiveBuilder};
use super::emit::Emitter;
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::setup::planes::SetupPlan;
use super::worker_pool::WorkerPool;
use crate::framebuffer::{Band, Framebuffer};
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock};

/// A draw in pieces.
pub trait SplitDraw<P>: Sync {
    /// What a worker needs for itself.
    type Scratch: Send;
    /// How many pieces there are.
    fn count(&self) -> usize;
    /// Sets up the primitives of a piece, whose number is less than [`count`](Self::count).
    fn set_up(&self, piece: usize, scratch: &mut Self::Scratch, to: &mut PrimitiveBuilder<'_, P>);
}

/// Parts under way for each worker: one that it sets up, one that waits to be walked.
const EACH: usize = 2;

/// What has been set up of a piece.
#[derive(Debug, Default)]
pub(super) struct BinnedGeometry {
    geometry: SceneGeometry,
    bins: Vec<Vec<u32>>,
}

/// A slot for a piece under way: piece p has slot p modulo the number of slots.
#[derive(Clone, Debug, Default)]
struct Slot {
    /// Whether the piece is set up.
    ready: bool,
    /// Who did that.
    by: usize,
    /// Which bands it touches.
    touched: Vec<bool>,
    /// Bands that have not passed it yet; 0 where the slot is free.
    left: usize,
}

/// What a worker does next.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Task {
    /// Sets up a piece.
    SetUp(usize),
    /// Walks a band through pieces.
    Rasterise(usize, Range<usize>),
}

/// What has been done and what is being done.
#[derive(Debug)]
struct Schedule {
    /// SplitDraw of the draw, and the next of them to be set up.
    pieces: usize,
    next: usize,
    slots: Vec<Slot>,
    /// The piece that each band comes to next, and whether somebody walks it.
    bands: Vec<(usize, bool)>,
    /// Workers that wait.
    waiting: usize,
    /// Whether a worker has ended early.
    panicked: bool,
}

impl Schedule {
    fn new(pieces: usize, slots: usize, bands: usize) -> Self {
        let slots = vec![Slot::default(); slots.max(1)];
        Self { pieces, next: 0, slots, bands: vec![(0, false); bands], waiting: 0, panicked: false }
    }

    fn slot(&self, piece: usize) -> &Slot {
        &self.slots[piece % self.slots.len()]
    }

    /// Whether a piece is set up and not passed by all bands.
    fn is_ready(&self, piece: usize) -> bool {
        piece < self.next && self.slot(piece).ready
    }

    /// Lets a band that nobody walks pass the pieces that do not touch it.
    fn pass(&mut self, band: usize) {
        let (mut piece, busy) = self.bands[band];
        while !busy && self.is_ready(piece) && !self.slot(piece).touched[band] {
            self.has_passed(piece);
            piece += 1;
        }
        self.bands[band].0 = piece;
    }

    /// A band has passed a piece. The last one makes its slot free.
    fn has_passed(&mut self, piece: usize) {
        let at = piece % self.slots.len();
        let slot = &mut self.slots[at];
        slot.left -= 1;
        slot.ready = slot.left > 0;
    }

    /// What a worker may do. What it has set up itself comes first, then setting up, then what others have set up.
    fn find(&self, worker: usize) -> Option<Task> {
        let open = self.bands.iter().enumerate().filter(|(_, (piece, busy))| !busy && self.is_ready(*piece));
        let open = open.map(|(band, (piece, _))| (self.slot(*piece).by != worker, *piece, band)).min();
        let free = self.next < self.pieces && self.slot(self.next).left == 0;
        match open {
            Some((others, piece, band)) if !(others && free) => {
                let until = (piece..self.next).find(|piece| !self.is_ready(*piece)).unwrap_or(self.next);
                Some(Task::Rasterise(band, piece..until))
            }
            _ => free.then_some(Task::SetUp(self.next)),
        }
    }

    /// A worker begins a task.
    fn begin(&mut self, task: &Task) {
        match task {
            Task::SetUp(piece) => {
                self.next = piece + 1;
                let (at, bands) = (piece % self.slots.len(), self.bands.len());
                (self.slots[at].ready, self.slots[at].left) = (false, bands);
            }
            Task::Rasterise(band, _) => self.bands[*band].1 = true,
        }
    }

    /// A worker has done a task; of a piece that was set up `touched` tells the bands.
    fn end(&mut self, worker: usize, task: Task, touched: impl Iterator<Item = bool>) {
        match task {
            Task::SetUp(piece) => {
                let at = piece % self.slots.len();
                let slot = &mut self.slots[at];
                (slot.ready, slot.by) = (true, worker);
                slot.touched.clear();
                slot.touched.extend(touched);
                slot.touched.resize(self.bands.len(), false);
                (0..self.bands.len()).for_each(|band| self.pass(band));
            }
            Task::Rasterise(band, pieces) => {
                self.bands[band] = (pieces.end, false);
                pieces.for_each(|piece| self.has_passed(piece));
                self.pass(band);
            }
        }
    }

    /// Whether all is done, or never will be.
    fn is_over(&self) -> bool {
        self.panicked || self.bands.iter().all(|(piece, _)| *piece >= self.pieces)
    }
}

/// The schedule on the wall, and what those who wait listen for.
struct SharedSchedule {
    schedule: Mutex<Schedule>,
    changed: Condvar,
}

impl SharedSchedule {
    fn schedule(&self) -> MutexGuard<'_, Schedule> {
        self.schedule.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next task of a worker, once there is one. None where there will be none any more.
    fn next(&self, mut schedule: MutexGuard<'_, Schedule>, worker: usize) -> Option<Task> {
        loop {
            if schedule.is_over() {
                self.changed.notify_all();
                return None;
            }
            if let Some(task) = schedule.find(worker) {
                schedule.begin(&task);
                if schedule.waiting > 0 && schedule.find(usize::MAX).is_some() {
                    self.changed.notify_one();
                }
                return Some(task);
            }
            schedule.waiting += 1;
            schedule = self.changed.wait(schedule).unwrap_or_else(PoisonError::into_inner);
            schedule.waiting -= 1;
        }
    }
}

/// Tells the others when a worker ends by a panic.
struct PanicGuard<'a>(&'a SharedSchedule);

impl Drop for PanicGuard<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.schedule().panicked = true;
            self.0.changed.notify_all();
        }
    }
}

/// What is drawn, and what it is drawn with.
pub(super) struct SplitDrawRun<'a, P> {
    pub draw: &'a Arc<Draw<P>>,
    pub plan: &'a SetupPlan,
    pub workers: &'a WorkerPool,
    pub cut: usize,
}

impl<P: FragmentProgram> SplitDrawRun<'_, P> {
    /// Draws all pieces, with a worker for each of `scratch`. Returns how many fragments passed.
    pub fn run<W: SplitDraw<P>>(
        &self,
        pieces: &W,
        scratch: &mut [W::Scratch],
        framebuffer: &mut Framebuffer,
        binned: &mut Vec<RwLock<BinnedGeometry>>,
        emitters: &mut Vec<Emitter>,
    ) -> u64 {
        let workers = scratch.len().max(1);
        let rows = binning::band_rows(framebuffer.width(), framebuffer.height());
        let bands: Vec<_> = framebuffer.bands(rows).into_iter().map(Mutex::new).collect();
        let level = self.plan.level();
        emitters.resize_with(emitters.len().max(workers), || Emitter::new(level));
        let slots = (EACH * workers).min(pieces.count()).max(1);
        binned.resize_with(binned.len().max(slots), RwLock::default);
        let binned = binned.get(..slots).unwrap_or_default();
        let schedule = Schedule::new(pieces.count(), slots, bands.len());
        let shared = SharedSchedule { schedule: Mutex::new(schedule), changed: Condvar::new() };
        let number = AtomicUsize::new(0);
        let work = |(scratch, emitter): (&mut W::Scratch, &mut Emitter)| {
            let _guard = PanicGuard(&shared);
            let worker = number.fetch_add(1, Ordering::Relaxed);
            let mut schedule = shared.schedule();
            while let Some(task) = shared.next(schedule, worker) {
                match &task {
                    Task::SetUp(piece) => {
                        let Ok(mut binned) = binned[piece % slots].write() else { return };
                        self.set_up(pieces, *piece, scratch, &mut binned, (bands.len(), rows));
                        schedule = shared.schedule();
                        schedule.end(worker, task, binned.bins.iter().map(|bin| !bin.is_empty()));
                    }
                    Task::Rasterise(number, pieces) => {
                        let Ok(mut band) = bands[*number].lock() else { return };
                        for piece in pieces.clone() {
                            let Ok(binned) = binned[piece % slots].read() else { return };
                            let draws = std::slice::from_ref(self.draw);
                            let flush = RasterPass { draws, geometry: &binned.geometry, cut: self.cut, level };
                            if let Some(bin) = binned.bins.get(*number).filter(|bin| !bin.is_empty()) {
                                flush.walk(bin.iter().copied(), &mut band, emitter);
                            }
                        }
                        drop(band);
                        schedule = shared.schedule();
                        schedule.end(worker, task, std::iter::empty());
                    }
                }
            }
        };
        self.workers.share(scratch.iter_mut().zip(emitters.iter_mut()), work);
        let passed = |band: &Mutex<Band<'_>>| {
            let mut band = band.lock().ok()?;
            // A draw without pieces walks over no band, but a clear that waits must not get lost.
            band.apply_deferred_clear();
            Some(band.samples)
        };
        bands.iter().filter_map(passed).sum()
    }

    /// Sets up a piece and files its primitives in their bands.
    fn set_up<W: SplitDraw<P>>(
        &self,
        pieces: &W,
        piece: usize,
        scratch: &mut W::Scratch,
        binned: &mut BinnedGeometry,
        bands: (usize, u32),
    ) {
        binned.geometry.clear();
        let mut stipple = 0;
        let mut to = PrimitiveBuilder::new(self.draw, 0, self.plan, &mut binned.geometry, &mut stipple);
        pieces.set_up(piece, scratch, &mut to);
        to.flush_batch();
        binning::file(&binned.geometry, &mut binned.bins, bands.0, bands.1);
    }
}

#[cfg(test)]
mod tests {
    use super::{Schedule, Task};
    use crate::raster::testing::Random;

    /// Workers take and end tasks in a random order; what each band has been walked through.
    fn walked(
        random: &mut Random,
        pieces: usize,
        slots: usize,
        workers: usize,
        touched: &[Vec<bool>],
    ) -> Vec<Vec<usize>> {
        let bands = touched.first().map_or(1, Vec::len);
        let mut schedule = Schedule::new(pieces, slots, bands);
        let mut tasks: Vec<Option<Task>> = vec![None; workers];
        let mut walked = vec![Vec::new(); bands];
        while !schedule.is_over() {
            assert!(tasks.iter().any(Option::is_some) || schedule.find(0).is_some(), "nothing may be done");
            let worker = (random.unit() * workers as f64) as usize % workers;
            match tasks[worker].take() {
                None => {
                    tasks[worker] = schedule.find(worker);
                    if let Some(task) = &tasks[worker] {
                        schedule.begin(task);
                    }
                }
                Some(task) => {
                    if let Task::Rasterise(band, pieces) = &task {
                        walked[*band].extend(pieces.clone().filter(|piece| touched[*piece][*band]));
                    }
                    let piece = if let Task::SetUp(piece) = task { piece } else { 0 };
                    schedule.end(worker, task, touched[piece].iter().copied());
                }
            }
        }
        walked
    }

    #[test]
    fn every_band_meets_its_pieces_in_order_whoever_works_when() {
        let mut random = Random(5);
        for round in 0..300 {
            let (pieces, bands) = (1 + round % 23, 1 + round % 7);
            let density = random.unit();
            let touched: Vec<Vec<bool>> =
                (0..pieces).map(|_| (0..bands).map(|_| random.unit() < density).collect()).collect();
            let (slots, workers) = (1 + round % 5, 1 + round % 4);
            let walked = walked(&mut random, pieces, slots, workers, &touched);
            for (band, walked) in walked.iter().enumerate() {
                let want: Vec<usize> = (0..pieces).filter(|piece| touched[*piece][band]).collect();
                assert_eq!(*walked, want, "round {round}, band {band}");
            }
        }
    }
}
