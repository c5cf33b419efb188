//! The scheduler of large draws. A draw is split into parts, and each worker takes the task that is next: set up the
//! primitives of a part, in a geometry of its own, or rasterise a band through the parts that are set up, in the order of
//! the parts. A pixel sees the same fragments in the same order as with one thread, so the result is the same to the last
//! bit. Parts are set up only so far ahead of the slowest band, which bounds the memory, and one worker at a time has a
//! band. A worker prefers to rasterise what it has set up itself, which is in its cache.

use super::binning::{RasterPass, band_rows, bin_primitives};
use super::draw::{Draw, PrimitiveBuilder};
use super::emit::Emitter;
use super::program_trait::FragmentProgram;
use super::rasteriser::{BinnedGeometry, Rasteriser};
use super::setup::planes::SetupPlan;
use crate::framebuffer::{Band, Framebuffer};
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock};

/// A draw that is split into parts, which can be set up apart from each other.
pub trait SplitDraw<P>: Sync {
    /// What a worker needs for itself.
    type Scratch: Send;
    /// How many parts there are.
    fn count(&self) -> usize;
    /// Sets up the primitives of a part, whose number is less than [`count`](Self::count).
    fn set_up(&self, part: usize, scratch: &mut Self::Scratch, to: &mut PrimitiveBuilder<'_, P>);
}

/// Parts under way for each worker: one that it sets up, one that waits to be rasterised.
const SLOTS_PER_WORKER: usize = 2;

/// The state of a part under way: part p has slot p modulo the number of slots.
#[derive(Clone, Debug, Default)]
struct Slot {
    /// Whether the part is set up.
    ready: bool,
    /// The worker that did that.
    by: usize,
    /// Which bands its primitives touch.
    touched: Vec<bool>,
    /// How many bands have not been rasterised through it; 0 where the slot is free.
    left: usize,
}

/// What a worker does next.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Task {
    /// Set up a part.
    SetUp(usize),
    /// Rasterise a band through parts.
    Rasterise(usize, Range<usize>),
}

/// What has been done and what is being done.
#[derive(Debug)]
struct Schedule {
    /// SplitDraw of the draw, and the next of them to be set up.
    parts: usize,
    next: usize,
    slots: Vec<Slot>,
    /// For each band the part that is next, and whether a worker has the band.
    bands: Vec<(usize, bool)>,
    /// How many workers wait.
    waiting: usize,
    /// Whether a worker has panicked.
    panicked: bool,
}

impl Schedule {
    fn new(parts: usize, slots: usize, bands: usize) -> Self {
        let slots = vec![Slot::default(); slots.max(1)];
        Self { parts, next: 0, slots, bands: vec![(0, false); bands], waiting: 0, panicked: false }
    }

    fn slot(&self, part: usize) -> &Slot {
        &self.slots[part % self.slots.len()]
    }

    /// Whether a part is set up, and some band has not been rasterised through it.
    fn is_ready(&self, part: usize) -> bool {
        part < self.next && self.slot(part).ready
    }

    /// Lets a band that no worker has skip the parts that do not touch it.
    fn skip_untouched(&mut self, band: usize) {
        let (mut part, busy) = self.bands[band];
        while !busy && self.is_ready(part) && !self.slot(part).touched[band] {
            self.band_done(part);
            part += 1;
        }
        self.bands[band].0 = part;
    }

    /// A band is done with a part. The last band frees the slot.
    fn band_done(&mut self, part: usize) {
        let at = part % self.slots.len();
        let slot = &mut self.slots[at];
        slot.left -= 1;
        slot.ready = slot.left > 0;
    }

    /// The best task for a worker: rasterise what it has set up itself, or set up, or rasterise what others have set up.
    fn find(&self, worker: usize) -> Option<Task> {
        let open = self.bands.iter().enumerate().filter(|(_, (part, busy))| !busy && self.is_ready(*part));
        let open = open.map(|(band, (part, _))| (self.slot(*part).by != worker, *part, band)).min();
        let free = self.next < self.parts && self.slot(self.next).left == 0;
        match open {
            Some((others, part, band)) if !(others && free) => {
                let until = (part..self.next).find(|part| !self.is_ready(*part)).unwrap_or(self.next);
                Some(Task::Rasterise(band, part..until))
            }
            _ => free.then_some(Task::SetUp(self.next)),
        }
    }

    /// A worker begins a task.
    fn begin(&mut self, task: &Task) {
        match task {
            Task::SetUp(part) => {
                self.next = part + 1;
                let (at, bands) = (part % self.slots.len(), self.bands.len());
                (self.slots[at].ready, self.slots[at].left) = (false, bands);
            }
            Task::Rasterise(band, _) => self.bands[*band].1 = true,
        }
    }

    /// A worker has done a task. Of a part that was set up, `touched` says for each band whether it touches it.
    fn end(&mut self, worker: usize, task: Task, touched: impl Iterator<Item = bool>) {
        match task {
            Task::SetUp(part) => {
                let at = part % self.slots.len();
                let slot = &mut self.slots[at];
                (slot.ready, slot.by) = (true, worker);
                slot.touched.clear();
                slot.touched.extend(touched);
                slot.touched.resize(self.bands.len(), false);
                (0..self.bands.len()).for_each(|band| self.skip_untouched(band));
            }
            Task::Rasterise(band, parts) => {
                self.bands[band] = (parts.end, false);
                parts.for_each(|part| self.band_done(part));
                self.skip_untouched(band);
            }
        }
    }

    /// Whether all is done, or a panic has put an end to it.
    fn is_over(&self) -> bool {
        self.panicked || self.bands.iter().all(|(part, _)| *part >= self.parts)
    }
}

/// The schedule and its condition variable.
struct SharedSchedule {
    schedule: Mutex<Schedule>,
    changed: Condvar,
}

impl SharedSchedule {
    fn lock(&self) -> MutexGuard<'_, Schedule> {
        self.schedule.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next task of a worker, once there is one; `None` when the schedule is over.
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

/// Wakes the others when a worker ends by a panic.
struct PanicGuard<'a>(&'a SharedSchedule);

impl Drop for PanicGuard<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.lock().panicked = true;
            self.0.changed.notify_all();
        }
    }
}

/// A split draw under way: what its workers have in common.
struct SplitDrawRun<'a, 'b, P, W> {
    draw: &'a Arc<Draw<P>>,
    plan: &'a SetupPlan,
    split: &'a W,
    cut: usize,
    /// Rows of a band.
    rows: u32,
    bands: Vec<Mutex<Band<'b>>>,
    /// One for each slot of the schedule.
    parts: &'a [RwLock<BinnedGeometry>],
    shared: SharedSchedule,
}

impl<P: FragmentProgram, W: SplitDraw<P>> SplitDrawRun<'_, '_, P, W> {
    /// What each worker does.
    fn work(&self, worker: usize, scratch: &mut W::Scratch, emitter: &mut Emitter) {
        let _guard = PanicGuard(&self.shared);
        let mut schedule = self.shared.lock();
        while let Some(task) = self.shared.next(schedule, worker) {
            match &task {
                Task::SetUp(part) => {
                    let Ok(mut binned) = self.parts[part % self.parts.len()].write() else { return };
                    self.set_up(*part, scratch, &mut binned);
                    schedule = self.shared.lock();
                    schedule.end(worker, task, binned.bins.iter().map(|bin| !bin.is_empty()));
                }
                Task::Rasterise(band, parts) => {
                    let Ok(mut target) = self.bands[*band].lock() else { return };
                    for part in parts.clone() {
                        let Ok(binned) = self.parts[part % self.parts.len()].read() else { return };
                        let draws = std::slice::from_ref(self.draw);
                        let pass = RasterPass { draws, geometry: &binned.geometry, cut: self.cut };
                        if let Some(bin) = binned.bins.get(*band).filter(|bin| !bin.is_empty()) {
                            pass.rasterise(bin.iter().copied(), &mut target, emitter);
                        }
                    }
                    drop(target);
                    schedule = self.shared.lock();
                    schedule.end(worker, task, std::iter::empty());
                }
            }
        }
    }

    /// Sets up a part and files its primitives in their bands.
    fn set_up(&self, part: usize, scratch: &mut W::Scratch, binned: &mut BinnedGeometry) {
        binned.geometry.clear();
        let mut stipple = 0;
        let mut to = PrimitiveBuilder::new(self.draw, 0, self.plan, &mut binned.geometry, &mut stipple);
        self.split.set_up(part, scratch, &mut to);
        to.flush_batch();
        bin_primitives(&binned.geometry, &mut binned.bins, self.bands.len(), self.rows);
    }
}

impl Rasteriser {
    /// Draws all parts of a split draw, with a worker for each of `scratch`. Returns how many fragments passed.
    pub fn draw_split<P: FragmentProgram, W: SplitDraw<P>>(
        &mut self,
        (draw, plan): (&Arc<Draw<P>>, &SetupPlan),
        split: &W,
        scratch: &mut [W::Scratch],
        framebuffer: &mut Framebuffer,
    ) -> u64 {
        let workers = scratch.len().max(1);
        let rows = band_rows(framebuffer.width(), framebuffer.height());
        let bands: Vec<_> = framebuffer.bands(rows).into_iter().map(Mutex::new).collect();
        self.reserve_emitters(workers);
        let slots = (SLOTS_PER_WORKER * workers).min(split.count()).max(1);
        self.parts.resize_with(self.parts.len().max(slots), RwLock::default);
        let parts = self.parts.get(..slots).unwrap_or_default();
        let schedule = Mutex::new(Schedule::new(split.count(), slots, bands.len()));
        let shared = SharedSchedule { schedule, changed: Condvar::new() };
        let run = SplitDrawRun { draw, plan, split, cut: self.cut, rows, bands, parts, shared };
        let number = AtomicUsize::new(0);
        self.workers.share(scratch.iter_mut().zip(&mut self.emitters), |(scratch, emitter)| {
            run.work(number.fetch_add(1, Ordering::Relaxed), scratch, emitter);
        });
        let passed = |band: &Mutex<Band<'_>>| {
            let mut band = band.lock().ok()?;
            // A draw without parts rasterises no band, but a deferred clear must not get lost.
            band.apply_deferred_clear();
            Some(band.samples)
        };
        run.bands.iter().filter_map(passed).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::{Schedule, Task};
    use crate::raster::testing::Random;

    /// Lets workers take and end tasks in a random order; which parts each band was rasterised through.
    fn rasterised(
        random: &mut Random,
        parts: usize,
        slots: usize,
        workers: usize,
        touched: &[Vec<bool>],
    ) -> Vec<Vec<usize>> {
        let bands = touched.first().map_or(1, Vec::len);
        let mut schedule = Schedule::new(parts, slots, bands);
        let mut tasks: Vec<Option<Task>> = vec![None; workers];
        let mut rasterised = vec![Vec::new(); bands];
        while !schedule.is_over() {
            assert!(tasks.iter().any(Option::is_some) || schedule.find(0).is_some(), "there is no task");
            let worker = (random.unit() * workers as f64) as usize % workers;
            match tasks[worker].take() {
                None => {
                    tasks[worker] = schedule.find(worker);
                    if let Some(task) = &tasks[worker] {
                        schedule.begin(task);
                    }
                }
                Some(task) => {
                    if let Task::Rasterise(band, parts) = &task {
                        rasterised[*band].extend(parts.clone().filter(|part| touched[*part][*band]));
                    }
                    let part = if let Task::SetUp(part) = task { part } else { 0 };
                    schedule.end(worker, task, touched[part].iter().copied());
                }
            }
        }
        rasterised
    }

    #[test]
    fn every_band_meets_its_parts_in_order_whoever_works_when() {
        let mut random = Random(5);
        for round in 0..300 {
            let (parts, bands) = (1 + round % 23, 1 + round % 7);
            let density = random.unit();
            let touched: Vec<Vec<bool>> =
                (0..parts).map(|_| (0..bands).map(|_| random.unit() < density).collect()).collect();
            let (slots, workers) = (1 + round % 5, 1 + round % 4);
            let rasterised = rasterised(&mut random, parts, slots, workers, &touched);
            for (band, rasterised) in rasterised.iter().enumerate() {
                let want: Vec<usize> = (0..parts).filter(|part| touched[*part][band]).collect();
                assert_eq!(*rasterised, want, "round {round}, band {band}");
            }
        }
    }
}
