//! Large draws on several threads. A draw is cut into pieces, and pieces are taken in rounds: first workers set up the
//! primitives of one piece after the other, each piece in a geometry of its own, then they walk one band of rows after
//! the other, through the geometries in the order of the pieces. A pixel sees the same fragments in the same order as
//! with one thread, so the result is the same to the last bit. The threads live as long as the draw; between the halves
//! of a round they wait for each other at a gate.

use super::bands::{self, Flush};
use super::emit::Emitter;
use super::geometry::Geometry;
use super::plane::Recipe;
use super::scene::{Builder, Draw, Shader};
use crate::framebuffer::{Band, Framebuffer};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, RwLock};

/// A draw in pieces.
pub trait Pieces<P>: Sync {
    /// What a worker needs for itself.
    type Own: Send;
    /// How many pieces there are.
    fn count(&self) -> usize;
    /// Sets up the primitives of a piece, whose number is less than [`count`](Self::count).
    fn set_up(&self, piece: usize, own: &mut Self::Own, to: &mut Builder<'_, P>);
}

/// Pieces of a round for each worker: enough for workers to end a half at about the same time.
const EACH: usize = 2;

/// What has been set up of a piece.
#[derive(Debug, Default)]
pub(super) struct Part {
    geometry: Geometry,
    bins: Vec<Vec<u32>>,
}

/// Where workers wait until all have come. A worker that ends early, by a panic, opens it for good.
#[derive(Debug)]
struct Gate {
    workers: usize,
    /// How many wait, how often the gate has opened, whether a worker has gone.
    state: Mutex<(usize, u64, bool)>,
    open: Condvar,
}

impl Gate {
    /// Waits for the others. The last one to come does something before they go on. False if a worker has gone.
    fn wait(&self, last: impl FnOnce()) -> bool {
        let Ok(mut state) = self.state.lock() else { return false };
        let round = state.1;
        state.0 += 1;
        if state.0 == self.workers {
            last();
            *state = (0, round + 1, state.2);
            self.open.notify_all();
        }
        while state.1 == round && !state.2 {
            state = match self.open.wait(state) {
                Ok(state) => state,
                Err(_) => return false,
            };
        }
        !state.2
    }
}

/// Tells the gate when its worker ends in whatever way.
struct Leaving<'a>(&'a Gate);

impl Drop for Leaving<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let mut state = self.0.state.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            state.2 = true;
            self.0.open.notify_all();
        }
    }
}

/// What is drawn, and what it is drawn with.
pub(super) struct Round<'a, P> {
    pub draw: &'a Arc<Draw<P>>,
    pub recipe: &'a Recipe,
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
        let rows = bands::band_rows(framebuffer.width(), framebuffer.height());
        let bands: Vec<_> = framebuffer.bands(rows).into_iter().map(Mutex::new).collect();
        let level = self.recipe.level();
        emitters.resize_with(emitters.len().max(workers), || Emitter::new(level));
        let all = pieces.count();
        let each = (EACH * workers).min(all);
        parts.resize_with(parts.len().max(each), RwLock::default);
        let parts = parts.get(..each).unwrap_or_default();
        let gate = Gate { workers, state: Mutex::default(), open: Condvar::new() };
        let (next_part, next_band) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let work = |own: &mut W::Own, emitter: &mut Emitter| {
            let _leaving = Leaving(&gate);
            for first in (0..all).step_by(each.max(1)) {
                let parts = parts.get(..each.min(all - first)).unwrap_or_default();
                loop {
                    let number = next_part.fetch_add(1, Ordering::Relaxed);
                    let Some(Ok(mut part)) = parts.get(number).map(RwLock::write) else { break };
                    self.set_up(pieces, first + number, own, &mut part, (bands.len(), rows));
                }
                if !gate.wait(|| next_part.store(0, Ordering::Relaxed)) {
                    return;
                }
                loop {
                    let number = next_band.fetch_add(1, Ordering::Relaxed);
                    let Some(Ok(mut band)) = bands.get(number).map(Mutex::lock) else { break };
                    for part in parts.iter().filter_map(|part| part.read().ok()) {
                        let draws = std::slice::from_ref(self.draw);
                        let flush = Flush { draws, geometry: &part.geometry, cut: self.cut, level };
                        let bin = part.bins.get(number).map_or(&[][..], Vec::as_slice);
                        flush.walk(bin.iter().copied(), &mut band, emitter);
                    }
                }
                if !gate.wait(|| next_band.store(0, Ordering::Relaxed)) {
                    return;
                }
            }
        };
        std::thread::scope(|scope| {
            let mut pairs = owns.iter_mut().zip(emitters.iter_mut());
            let first = pairs.next();
            for (own, emitter) in pairs {
                scope.spawn(|| work(own, emitter));
            }
            if let Some((own, emitter)) = first {
                work(own, emitter);
            }
        });
        let passed = |band: &Mutex<Band<'_>>| {
            let mut band = band.lock().ok()?;
            // A draw without pieces walks over no band, but a clear that waits must not get lost.
            band.settle();
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
        bands::file(&part.geometry, &mut part.bins, bands.0, bands.1);
    }
}
