//! Large draws on several threads. A draw is cut into pieces, and workers do what is to be done next: one sets up the
//! primitives of a piece, in a geometry of its own, another walks a band of rows through the pieces that are set up, in the
//! order of the pieces. A pixel sees the same fragments in the same order as with one thread, so the result is the same to
//! the last bit. A worker waits only where nothing may be done: pieces are set up so far ahead of the slowest band and no
//! farther, and a band is one worker's at a time. A worker would rather walk what it has set up itself, which is in its
//! cache.

use super::binning::{self, Flush};
use super::emit::Emitter;
use super::geometry::Geometry;
use super::program_trait::Shader;
use super::scene::{Builder, Draw};
use super::setup::planes::Recipe;
use super::worker_pool::Crew;
use crate::framebuffer::{Band, Framebuffer};
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock};

/// A draw in pieces.
pub trait Pieces<P>: Sync {
    /// What a worker needs for itself.
    type Own: Send;
    /// How many pieces there are.
    fn count(&self) -> usize;
    /// Sets up the primitives of a piece, whose number is less than [`count`](Self::count).
    fn set_up(&self, piece: usize, own: &mut Self::Own, to: &mut Builder<'_, P>);
}

/// Pieces under way for each worker: one that it sets up, one that waits to be walked.
const EACH: usize = 2;

/// What has been set up of a piece.
#[derive(Debug, Default)]
pub(super) struct Part {
    geometry: Geometry,
    bins: Vec<Vec<u32>>,
}

/// A place for a piece under way: piece p has place p modulo the number of places.
#[derive(Clone, Debug, Default)]
struct Place {
    /// Whether the piece is set up.
    ready: bool,
    /// Who did that.
    by: usize,
    /// Which bands it touches.
    touched: Vec<bool>,
    /// Bands that have not passed it yet; 0 where the place is free.
    left: usize,
}

/// What a worker does next.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Task {
    /// Sets up a piece.
    SetUp(usize),
    /// Walks a band through pieces.
    Walk(usize, Range<usize>),
}

/// What has been done and what is being done.
#[derive(Debug)]
struct Board {
    /// Pieces of the draw, and the next of them to be set up.
    pieces: usize,
    next: usize,
    places: Vec<Place>,
    /// The piece that each band comes to next, and whether somebody walks it.
    bands: Vec<(usize, bool)>,
    /// Workers that wait.
    waiting: usize,
    /// Whether a worker has ended early.
    broken: bool,
}

impl Board {
    fn new(pieces: usize, places: usize, bands: usize) -> Self {
        let places = vec![Place::default(); places.max(1)];
        Self { pieces, next: 0, places, bands: vec![(0, false); bands], waiting: 0, broken: false }
    }

    fn place(&self, piece: usize) -> &Place {
        &self.places[piece % self.places.len()]
    }

    /// Whether a piece is set up and not passed by all bands.
    fn is_ready(&self, piece: usize) -> bool {
        piece < self.next && self.place(piece).ready
    }

    /// Lets a band that nobody walks pass the pieces that do not touch it.
    fn pass(&mut self, band: usize) {
        let (mut piece, busy) = self.bands[band];
        while !busy && self.is_ready(piece) && !self.place(piece).touched[band] {
            self.has_passed(piece);
            piece += 1;
        }
        self.bands[band].0 = piece;
    }

    /// A band has passed a piece. The last one makes its place free.
    fn has_passed(&mut self, piece: usize) {
        let at = piece % self.places.len();
        let place = &mut self.places[at];
        place.left -= 1;
        place.ready = place.left > 0;
    }

    /// What a worker may do. What it has set up itself comes first, then setting up, then what others have set up.
    fn find(&self, worker: usize) -> Option<Task> {
        let open = self.bands.iter().enumerate().filter(|(_, (piece, busy))| !busy && self.is_ready(*piece));
        let open = open.map(|(band, (piece, _))| (self.place(*piece).by != worker, *piece, band)).min();
        let free = self.next < self.pieces && self.place(self.next).left == 0;
        match open {
            Some((others, piece, band)) if !(others && free) => {
                let until = (piece..self.next).find(|piece| !self.is_ready(*piece)).unwrap_or(self.next);
                Some(Task::Walk(band, piece..until))
            }
            _ => free.then_some(Task::SetUp(self.next)),
        }
    }

    /// A worker begins a task.
    fn begin(&mut self, task: &Task) {
        match task {
            Task::SetUp(piece) => {
                self.next = piece + 1;
                let (at, bands) = (piece % self.places.len(), self.bands.len());
                (self.places[at].ready, self.places[at].left) = (false, bands);
            }
            Task::Walk(band, _) => self.bands[*band].1 = true,
        }
    }

    /// A worker has done a task; of a piece that was set up `touched` tells the bands.
    fn end(&mut self, worker: usize, task: Task, touched: impl Iterator<Item = bool>) {
        match task {
            Task::SetUp(piece) => {
                let at = piece % self.places.len();
                let place = &mut self.places[at];
                (place.ready, place.by) = (true, worker);
                place.touched.clear();
                place.touched.extend(touched);
                place.touched.resize(self.bands.len(), false);
                (0..self.bands.len()).for_each(|band| self.pass(band));
            }
            Task::Walk(band, pieces) => {
                self.bands[band] = (pieces.end, false);
                pieces.for_each(|piece| self.has_passed(piece));
                self.pass(band);
            }
        }
    }

    /// Whether all is done, or never will be.
    fn is_over(&self) -> bool {
        self.broken || self.bands.iter().all(|(piece, _)| *piece >= self.pieces)
    }
}

/// The board on the wall, and what those who wait listen for.
struct Office {
    board: Mutex<Board>,
    news: Condvar,
}

impl Office {
    fn board(&self) -> MutexGuard<'_, Board> {
        self.board.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next task of a worker, once there is one. None where there will be none any more.
    fn next(&self, mut board: MutexGuard<'_, Board>, worker: usize) -> Option<Task> {
        loop {
            if board.is_over() {
                self.news.notify_all();
                return None;
            }
            if let Some(task) = board.find(worker) {
                board.begin(&task);
                if board.waiting > 0 && board.find(usize::MAX).is_some() {
                    self.news.notify_one();
                }
                return Some(task);
            }
            board.waiting += 1;
            board = self.news.wait(board).unwrap_or_else(PoisonError::into_inner);
            board.waiting -= 1;
        }
    }
}

/// Tells the others when a worker ends by a panic.
struct Leaving<'a>(&'a Office);

impl Drop for Leaving<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.board().broken = true;
            self.0.news.notify_all();
        }
    }
}

/// What is drawn, and what it is drawn with.
pub(super) struct Round<'a, P> {
    pub draw: &'a Arc<Draw<P>>,
    pub recipe: &'a Recipe,
    pub crew: &'a Crew,
    pub cut: usize,
}

impl<P: Shader> Round<'_, P> {
    /// Draws all pieces, with a worker for each of `owns`. Returns how many fragments passed.
    pub fn run<W: Pieces<P>>(
        &self,
        pieces: &W,
        owns: &mut [W::Own],
        framebuffer: &mut Framebuffer,
        parts: &mut Vec<RwLock<Part>>,
        emitters: &mut Vec<Emitter>,
    ) -> u64 {
        let workers = owns.len().max(1);
        let rows = binning::band_rows(framebuffer.width(), framebuffer.height());
        let bands: Vec<_> = framebuffer.bands(rows).into_iter().map(Mutex::new).collect();
        let level = self.recipe.level();
        emitters.resize_with(emitters.len().max(workers), || Emitter::new(level));
        let places = (EACH * workers).min(pieces.count()).max(1);
        parts.resize_with(parts.len().max(places), RwLock::default);
        let parts = parts.get(..places).unwrap_or_default();
        let board = Board::new(pieces.count(), places, bands.len());
        let office = Office { board: Mutex::new(board), news: Condvar::new() };
        let number = AtomicUsize::new(0);
        let work = |(own, emitter): (&mut W::Own, &mut Emitter)| {
            let _leaving = Leaving(&office);
            let worker = number.fetch_add(1, Ordering::Relaxed);
            let mut board = office.board();
            while let Some(task) = office.next(board, worker) {
                match &task {
                    Task::SetUp(piece) => {
                        let Ok(mut part) = parts[piece % places].write() else { return };
                        self.set_up(pieces, *piece, own, &mut part, (bands.len(), rows));
                        board = office.board();
                        board.end(worker, task, part.bins.iter().map(|bin| !bin.is_empty()));
                    }
                    Task::Walk(number, pieces) => {
                        let Ok(mut band) = bands[*number].lock() else { return };
                        for piece in pieces.clone() {
                            let Ok(part) = parts[piece % places].read() else { return };
                            let draws = std::slice::from_ref(self.draw);
                            let flush = Flush { draws, geometry: &part.geometry, cut: self.cut, level };
                            if let Some(bin) = part.bins.get(*number).filter(|bin| !bin.is_empty()) {
                                flush.walk(bin.iter().copied(), &mut band, emitter);
                            }
                        }
                        drop(band);
                        board = office.board();
                        board.end(worker, task, std::iter::empty());
                    }
                }
            }
        };
        self.crew.share(owns.iter_mut().zip(emitters.iter_mut()), work);
        let passed = |band: &Mutex<Band<'_>>| {
            let mut band = band.lock().ok()?;
            // A draw without pieces walks over no band, but a clear that waits must not get lost.
            band.apply_deferred_clear();
            Some(band.samples)
        };
        bands.iter().filter_map(passed).sum()
    }

    /// Sets up a piece and files its primitives in their bands.
    fn set_up<W: Pieces<P>>(&self, pieces: &W, piece: usize, own: &mut W::Own, part: &mut Part, bands: (usize, u32)) {
        part.geometry.clear();
        let mut stipple = 0;
        let mut to = Builder::new(self.draw, 0, self.recipe, &mut part.geometry, &mut stipple);
        pieces.set_up(piece, own, &mut to);
        to.settle();
        binning::file(&part.geometry, &mut part.bins, bands.0, bands.1);
    }
}

#[cfg(test)]
mod tests {
    use super::{Board, Task};
    use crate::raster::testing::Random;

    /// Workers take and end tasks in a random order; what each band has been walked through.
    fn walked(
        random: &mut Random,
        pieces: usize,
        places: usize,
        workers: usize,
        touched: &[Vec<bool>],
    ) -> Vec<Vec<usize>> {
        let bands = touched.first().map_or(1, Vec::len);
        let mut board = Board::new(pieces, places, bands);
        let mut tasks: Vec<Option<Task>> = vec![None; workers];
        let mut walked = vec![Vec::new(); bands];
        while !board.is_over() {
            assert!(tasks.iter().any(Option::is_some) || board.find(0).is_some(), "nothing may be done");
            let worker = (random.unit() * workers as f64) as usize % workers;
            match tasks[worker].take() {
                None => {
                    tasks[worker] = board.find(worker);
                    if let Some(task) = &tasks[worker] {
                        board.begin(task);
                    }
                }
                Some(task) => {
                    if let Task::Walk(band, pieces) = &task {
                        walked[*band].extend(pieces.clone().filter(|piece| touched[*piece][*band]));
                    }
                    let piece = if let Task::SetUp(piece) = task { piece } else { 0 };
                    board.end(worker, task, touched[piece].iter().copied());
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
            let (places, workers) = (1 + round % 5, 1 + round % 4);
            let walked = walked(&mut random, pieces, places, workers, &touched);
            for (band, walked) in walked.iter().enumerate() {
                let want: Vec<usize> = (0..pieces).filter(|piece| touched[*piece][band]).collect();
                assert_eq!(*walked, want, "round {round}, band {band}");
            }
        }
    }
}
