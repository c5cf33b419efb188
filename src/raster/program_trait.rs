//! What rasterisation needs to know of a fragment program, as a trait, so that tests can use a simpler one.

use crate::fragment::batch::{FragmentBatch, Segment as Run};
use crate::fragment::planes::{Layout, PlanePool, Planes};
use crate::fragment::program::{ORDINARY, Program};
use crate::framebuffer::Band;

/// What a draw does with its fragments.
pub trait FragmentProgram: Send + Sync {
    /// What it interpolates.
    fn layout(&self) -> &Layout;
    /// Whether fragments of one pixel must be worked on in order.
    fn ordered(&self) -> bool;
    /// Whether it reads the coverage of each fragment.
    fn coverage(&self) -> bool;
    /// Whether it can change nothing: then no primitive is set up.
    fn draws_nothing(&self) -> bool;
    /// Works on a batch.
    fn run(&self, batch: &mut FragmentBatch, planes: &[Planes], pool: PlanePool<'_>, band: &mut Band<'_>);
    /// About what a pixel of a large primitive costs, in the unit of [`ORDINARY`].
    fn weight(&self, _planes: &Planes, _pool: PlanePool<'_>) -> u64 {
        ORDINARY
    }
    /// Runs from this length on may be given to [`row`](Self::row).
    fn row_from(&self) -> u32;
    /// Shorter runs than this, of one primitive, may be given to [`rows`](Self::rows).
    fn rows_below(&self) -> u32 {
        0
    }
    /// Draws rows of one primitive, which are the segments of the batch; false if it has drawn none.
    fn rows(&self, _batch: &mut FragmentBatch, _planes: &[Planes], _pool: PlanePool<'_>, _band: &mut Band<'_>) -> bool {
        false
    }
    /// Draws a run of a row, which is not in the batch, from its start on as far as that pays. Returns how many pixels it
    /// has drawn.
    fn row(
        &self,
        batch: &mut FragmentBatch,
        run: Run,
        planes: &[Planes],
        pool: PlanePool<'_>,
        band: &mut Band<'_>,
    ) -> u32;
}

impl FragmentProgram for Program {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn ordered(&self) -> bool {
        self.reads_framebuffer
    }

    fn coverage(&self) -> bool {
        self.coverage
    }

    fn draws_nothing(&self) -> bool {
        Program::draws_nothing(self)
    }

    fn run(&self, batch: &mut FragmentBatch, planes: &[Planes], pool: PlanePool<'_>, band: &mut Band<'_>) {
        Program::run(self, batch, planes, pool, band);
    }

    fn weight(&self, planes: &Planes, pool: PlanePool<'_>) -> u64 {
        Program::weight(self, planes, pool)
    }

    fn row_from(&self) -> u32 {
        Program::row_from(self)
    }

    fn rows_below(&self) -> u32 {
        Program::rows_below(self)
    }

    fn rows(&self, batch: &mut FragmentBatch, planes: &[Planes], pool: PlanePool<'_>, band: &mut Band<'_>) -> bool {
        Program::rows(self, batch, planes, pool, band)
    }

    fn row(
        &self,
        batch: &mut FragmentBatch,
        run: Run,
        planes: &[Planes],
        pool: PlanePool<'_>,
        band: &mut Band<'_>,
    ) -> u32 {
        Program::row(self, batch, run, planes, pool, band)
    }
}
