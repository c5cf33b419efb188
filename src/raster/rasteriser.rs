//! What rasterises a scene: threads, and the memory that they work with. With one thread, or little to do, primitives are
//! rasterised in issue order over the whole framebuffer. Otherwise they are filed in bands of rows, and workers take one
//! band after the other.

use super::binning::{RasterPass, band_rows, bin_primitives};
use super::draw::Draw;
use super::emit::Emitter;
use super::geometry::SceneGeometry;
use super::program_trait::FragmentProgram;
use super::worker_pool::WorkerPool;
use crate::framebuffer::Framebuffer;
use crate::simd::{LANES, Level};
use std::sync::{Arc, Mutex, RwLock};

/// What has been set up of a part of a draw, and which of its primitives touch which band.
#[derive(Debug, Default)]
pub(super) struct BinnedGeometry {
    pub geometry: SceneGeometry,
    pub bins: Vec<Vec<u32>>,
}

/// Threads and scratch memory for rasterising.
#[derive(Debug)]
pub(super) struct Rasteriser {
    pub workers: WorkerPool,
    /// One for each worker.
    pub emitters: Vec<Emitter>,
    bins: Vec<Vec<u32>>,
    /// Parts of a split draw.
    pub parts: Vec<RwLock<BinnedGeometry>>,
    /// Fragments after which a batch is cut.
    pub cut: usize,
    /// The instruction set of the emitters.
    level: Level,
}

impl Rasteriser {
    /// For a number of threads, none of which is started yet.
    pub fn new(threads: usize, cut: usize, level: Level) -> Self {
        let (emitters, bins, parts) = (Vec::new(), Vec::new(), Vec::new());
        Self { workers: WorkerPool::new(threads), emitters, bins, parts, cut: cut.clamp(1, LANES), level }
    }

    /// Takes it out of its place, where one without threads remains.
    pub fn take(&mut self) -> Self {
        let empty = Self::new(1, self.cut, self.level);
        std::mem::replace(self, empty)
    }

    /// Makes sure that there is an emitter for each worker.
    pub fn reserve_emitters(&mut self, workers: usize) {
        let level = self.level;
        self.emitters.resize_with(self.emitters.len().max(workers), || Emitter::new(level));
    }

    /// Rasterises primitives with at most so many threads. Returns how many fragments passed.
    pub fn flush<P: FragmentProgram>(
        &mut self,
        draws: &[Arc<Draw<P>>],
        geometry: &SceneGeometry,
        framebuffer: &mut Framebuffer,
        threads: usize,
    ) -> u64 {
        let pass = RasterPass { draws, geometry, cut: self.cut };
        let height = framebuffer.height();
        let rows = band_rows(framebuffer.width(), height);
        let count = height.div_ceil(rows) as usize;
        let workers = if threads == 1 { 1 } else { threads.min(count).min(pass.useful_threads()) };
        self.reserve_emitters(workers);
        let Self { workers: pool, emitters, bins, .. } = self;
        // One thread, too, goes band by band where pixels are drawn over and over: a band stays in the cache.
        let area = u64::from(framebuffer.width()) * u64::from(height);
        let layered = geometry.pixels >= 2 * area && pass.is_large();
        // So it does with a deferred clear, if most of what that fills is drawn into.
        let clears = framebuffer.has_deferred_clear() && geometry.pixels >= area / 2;
        if workers == 1 && !layered && !clears {
            let mut band = framebuffer.band();
            if let Some(emitter) = emitters.first_mut() {
                let all = 0..u32::try_from(geometry.prims.len()).unwrap_or(u32::MAX);
                pass.rasterise(all, &mut band, emitter);
            }
            return band.samples;
        }
        bin_primitives(geometry, bins, count, rows);
        let mut bands = framebuffer.bands(rows);
        let queue = Mutex::new(interleaved(bands.iter_mut().zip(bins.iter()).collect(), workers));
        let work = |emitter: &mut Emitter| {
            loop {
                let next = queue.lock().ok().and_then(|mut queue| queue.next());
                let Some((band, bin)) = next else { break };
                pass.rasterise(bin.iter().copied(), band, emitter);
            }
        };
        if workers == 1 {
            emitters.iter_mut().take(1).for_each(work);
        } else {
            pool.share(emitters.iter_mut().take(workers), work);
        }
        drop(queue);
        bands.iter().map(|band| band.samples).sum()
    }
}

/// Bands in an order in which those that are worked on at the same time are not neighbours. A processor that prefetches
/// beyond the end of a band takes cache lines of the next one away from the processor that writes them.
fn interleaved<T>(bands: Vec<T>, workers: usize) -> impl Iterator<Item = T> {
    let each = bands.len().div_ceil(workers.max(1)).max(1);
    let mut bands: Vec<_> = bands.into_iter().enumerate().collect();
    bands.sort_by_key(|(i, _)| i % each);
    bands.into_iter().map(|(_, band)| band)
}

#[cfg(test)]
mod tests {
    use super::interleaved;

    #[test]
    fn bands_worked_on_at_the_same_time_are_not_neighbours() {
        let rows: [(usize, usize, &[usize]); 4] =
            [(8, 2, &[0, 4, 1, 5, 2, 6, 3, 7]), (7, 3, &[0, 3, 6, 1, 4, 2, 5]), (3, 5, &[0, 1, 2]), (0, 1, &[])];
        for (bands, workers, want) in rows {
            assert_eq!(
                Vec::from_iter(interleaved((0..bands).collect(), workers)),
                want,
                "{bands} bands, {workers} workers"
            );
        }
    }
}
