//! Rasterising primitives over a band of rows, and filing them in the bands that they touch. A pixel lies in one band, and
//! a band sees its primitives in issue order. A fragment depends on nothing but its primitive and its position, so the
//! result is the same to the last bit whether there is one band, the whole framebuffer, or many, on any number of threads.

use super::draw::Draw;
use super::emit::{Emitter, FragmentSink};
use super::geometry::{Coverage, Prim, SceneGeometry};
use super::program_trait::FragmentProgram;
use super::worker_pool::WORTH_A_THREAD;
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{PlanePool, Planes};
use crate::fragment::program::ORDINARY;
use crate::framebuffer::Band;
use std::ops::Range;
use std::sync::Arc;

/// Primitives to be rasterised, and the draws that they belong to.
#[derive(Debug)]
pub(super) struct RasterPass<'a, P> {
    pub draws: &'a [Arc<Draw<P>>],
    pub geometry: &'a SceneGeometry,
    /// Fragments after which a batch is cut; any number gives the same result.
    pub cut: usize,
}

/// What a primitive costs besides its fragments, in the unit of [`ORDINARY`].
const PRIMITIVE: u64 = 16 * ORDINARY;
/// Average pixels of a primitive from which on it pays to ask the program what the pixels of each one cost.
const LARGE: u64 = 256;

/// Most bytes of colour and depth in a band, unless that leaves fewer than 8 rows: they stay in the second-level cache.
const BAND_BYTES: u32 = 512 << 10;

/// Rows of a band, a power of two: about 32 bands, so that workers end at about the same time, but at least 8 rows, since
/// the edges of a large triangle are set up anew for each band.
pub(super) fn band_rows(width: u32, height: u32) -> u32 {
    let fit = (BAND_BYTES / 8 / width.clamp(1, BAND_BYTES)).max(1);
    (height / 32).next_power_of_two().min(1 << fit.ilog2()).clamp(8, 64)
}

/// A fragment program with all that it works on.
struct BandProgram<'a, 'b, P> {
    program: &'a P,
    planes: &'a [Planes],
    pool: PlanePool<'a>,
    band: &'a mut Band<'b>,
}

impl<P: FragmentProgram> FragmentSink for BandProgram<'_, '_, P> {
    fn run(&mut self, batch: &mut FragmentBatch) {
        self.program.run(batch, self.planes, self.pool, self.band);
    }

    fn row(&mut self, batch: &mut FragmentBatch, run: Segment) -> u32 {
        self.program.row(batch, run, self.planes, self.pool, self.band)
    }

    fn rows(&mut self, batch: &mut FragmentBatch) -> bool {
        self.program.rows(batch, self.planes, self.pool, self.band)
    }
}

/// Files each primitive in the bands that it touches, in issue order.
pub(super) fn bin_primitives(geometry: &SceneGeometry, bins: &mut Vec<Vec<u32>>, count: usize, rows: u32) {
    bins.resize_with(bins.len().max(count), Vec::new);
    bins.iter_mut().for_each(Vec::clear);
    let shift = rows.trailing_zeros();
    for (i, prim) in (0u32..).zip(&geometry.prims) {
        let touched = geometry.rows(prim);
        let first = (touched.start.max(0) >> shift) as usize;
        let last = ((touched.end - 1) >> shift).max(-1);
        let last = usize::try_from(last + 1).unwrap_or(0).min(count);
        for bin in bins.get_mut(first..last).into_iter().flatten() {
            bin.push(i);
        }
    }
}

impl<P: FragmentProgram> RasterPass<'_, P> {
    /// Whether its primitives are large, and so not many.
    pub fn is_large(&self) -> bool {
        self.geometry.pixels >= LARGE * self.geometry.prims.len() as u64
    }

    /// How many threads the work is worth.
    pub fn useful_threads(&self) -> usize {
        let (prims, pool) = (&self.geometry.prims, self.geometry.pool.all());
        let work = if self.is_large() {
            let work = prims.iter().zip(&self.geometry.planes).map(|(prim, planes)| {
                let draw = self.draws.get(prim.draw as usize);
                draw.map_or(0, |draw| self.geometry.pixels_of(prim) * draw.program.weight(planes, pool))
            });
            work.sum()
        } else {
            self.geometry.pixels * ORDINARY + prims.len() as u64 * PRIMITIVE
        };
        usize::try_from(work / WORTH_A_THREAD).unwrap_or(usize::MAX).saturating_add(1)
    }

    /// Rasterises primitives over a band, in the order in which their indices come.
    pub fn rasterise(&self, prims: impl Iterator<Item = u32>, band: &mut Band<'_>, to: &mut Emitter) {
        let rows = band.y0 as i32..band.y0.saturating_add(band.rows) as i32;
        band.apply_deferred_clear();
        to.begin(band, self.cut);
        let Some(first) = self.draws.first() else { return };
        let (planes, pool) = (&self.geometry.planes[..], self.geometry.pool.all());
        let mut sink = BandProgram { program: &*first.program, planes, pool, band };
        let mut current = u32::MAX;
        let mut draw = first;
        for i in prims {
            let (Some(prim), Some(of)) = (self.geometry.prims.get(i as usize), planes.get(i as usize)) else { break };
            if prim.draw != current {
                to.finish(&mut sink);
                let Some(next) = self.draws.get(prim.draw as usize) else { continue };
                (draw, current) = (next, prim.draw);
                sink.program = &draw.program;
                to.smooth = draw.program.coverage();
                to.ordered = draw.program.ordered();
                to.row_from(draw.program.row_from());
                to.rows_below(draw.program.rows_below());
            }
            to.primitive(i, of.origin, of.member.is_some());
            match prim.cover {
                Coverage::Mask { x, y, bits } => Self::mask([x, y], bits, &rows, to, &mut sink),
                _ => self.primitive(prim, draw, &rows, to, &mut sink),
            }
        }
        to.finish(&mut sink);
    }

    /// A small triangle. Most primitives of large scenes are such, so that they have a path of their own.
    #[inline(always)]
    fn mask([x, y]: [i32; 2], mut bits: u64, rows: &Range<i32>, to: &mut Emitter, sink: &mut impl FragmentSink) {
        let mut row = y;
        if row < rows.start {
            let skip = (rows.start - row).min(8);
            bits = bits.checked_shr(8 * skip.unsigned_abs()).unwrap_or(0);
            row += skip;
        }
        if rows.end - row < 8 {
            // Rows above the band belong to another one.
            bits &= u64::MAX.checked_shr(64 - 8 * (rows.end - row).clamp(0, 8).unsigned_abs()).unwrap_or(0);
        }
        to.mask(x, row, bits, sink);
    }

    fn primitive(
        &self,
        prim: &Prim,
        draw: &Draw<P>,
        rows: &Range<i32>,
        to: &mut Emitter,
        sink: &mut impl FragmentSink,
    ) {
        let geometry = self.geometry;
        let rs = &draw.raster;
        let stipple = rs.polygon_stipple.as_deref();
        let cut = |y0: i32, y1: i32| y0.max(rows.start)..y1.min(rows.end);
        match prim.cover {
            Coverage::Mask { x, y, bits } => Self::mask([x, y], bits, rows, to, sink),
            Coverage::Edges(i) => {
                let Some(edges) = geometry.edges.get(i as usize) else { return };
                match stipple {
                    None => {
                        edges.spans(rows.clone(), |x, y, len| to.collect(x, y, len, sink));
                        to.collected(sink);
                    }
                    Some(pattern) => edges.spans(rows.clone(), |x, y, len| {
                        to.stippled(x, y, len, pattern[y as usize & 31], 1.0, sink);
                    }),
                }
            }
            Coverage::Rows(i) => {
                let Some(block) = geometry.blocks.get(i as usize) else { return };
                match stipple {
                    None if !to.smooth => to.block([block.x, block.y], block.runs(rows), sink),
                    None => block.runs(rows).for_each(|[x, y, len]| to.run(block.x + x, block.y + y, len, 1.0, sink)),
                    Some(pattern) => block.runs(rows).for_each(|[x, y, len]| {
                        let y = block.y + y;
                        to.stippled(block.x + x, y, len, pattern[y as usize & 31], 1.0, sink);
                    }),
                }
            }
            Coverage::Line(i) => {
                let Some(line) = geometry.lines.get(i as usize) else { return };
                line.rasterise(rows.clone(), rs.line_stipple, to, sink);
            }
            Coverage::Rect(rect) => {
                for y in cut(rect.y0, rect.y1) {
                    to.run(rect.x0, y, rect.x1 - rect.x0, 1.0, sink);
                }
            }
            Coverage::Disc(i) => {
                let Some(disc) = geometry.discs.get(i as usize) else { return };
                for y in cut(disc.rect.y0, disc.rect.y1) {
                    for x in disc.rect.x0..disc.rect.x1 {
                        let coverage = disc.coverage(x, y);
                        if coverage > 0.0 {
                            to.run(x, y, 1, coverage, sink);
                        }
                    }
                }
            }
            Coverage::Outline(i) => {
                let Some(outline) = geometry.outlines.get(i as usize) else { return };
                // The polygon stipple holds for triangles. A smooth line, whose outline has 4 corners, is stippled by setup.
                let pattern = stipple.filter(|_| outline.count == 3);
                for y in cut(outline.rect.y0, outline.rect.y1) {
                    let row = outline.row(y);
                    for x in row.columns.0..row.columns.1 {
                        let bit = pattern.is_none_or(|rows| rows[y as usize & 31] << (x as u32 & 31) >> 31 != 0);
                        let coverage = if bit { row.coverage(x) } else { 0.0 };
                        if coverage > 0.0 {
                            to.run(x, y, 1, coverage, sink);
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ORDINARY, RasterPass, WORTH_A_THREAD};
    use crate::raster::geometry::{Coverage, SceneGeometry};
    use crate::raster::state::Rect;
    use crate::raster::testing::TestCanvas;
    use std::slice::from_ref;

    #[test]
    fn threads_are_worth_more_the_more_there_is_to_do() {
        let canvas = TestCanvas::new(64, 0, 1, 64, |_| {});
        let worth = |side: i32, count: usize| {
            let mut geometry = SceneGeometry::default();
            for _ in 0..count {
                let cover = Coverage::Rect(Rect { x0: 0, y0: 0, x1: side, y1: side });
                geometry.push(cover, 0, Default::default(), u64::from(side.unsigned_abs().pow(2)));
            }
            let draws = from_ref(&canvas.draw);
            RasterPass { draws, geometry: &geometry, cut: 64 }.useful_threads()
        };
        // A pixel of the test program has the ordinary cost. A small primitive costs 16 of them besides.
        let pays = usize::try_from(WORTH_A_THREAD / ORDINARY).expect("it is small");
        for (side, each) in [(64, 4096), (16, 256), (2, 4 + 16)] {
            let first = pays.div_ceil(each);
            for (count, want) in [(0, 1), (first - 1, 1), (first, 2), (3 * first, 4)] {
                assert_eq!(worth(side, count), want, "{count} squares of {side}");
            }
        }
    }
}
