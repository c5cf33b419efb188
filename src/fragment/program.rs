//! The fragment program: what a key needs, built once for a draw. It has two paths that give the same bits: the reference
//! path, a list of stages that is run over every batch, and for the keys that have one a span kernel that does rows of a
//! primitive without batches. What the state makes a no-op is left out (`build` decides); the list of what was kept and left
//! out, with the reasons, stays with the program so that it can be explained.

use super::batch::{FragmentBatch, Segment};
use super::hiz::Hiz;
use super::key::FragmentKey;
use super::pixel_rect::PixelRect;
use super::planes::{Layout, PlanePool, Planes};
use super::reference::pack::constant;
use super::span::kernels::SpanKernel;
use super::uniforms::{FragFn, FragUniforms, LongFn, SpanCounts, Work};
use crate::framebuffer::Band;
use crate::simd::{LANES, Step, Tally};
use crate::texture::env::EnvPlan;
use crate::texture::sampler::Sampler;
use std::sync::Arc;

/// How a program is to be built, apart from the state.
#[derive(Clone, Debug)]
pub struct Options {
    /// Leave nothing out that could be kept: a program that gives the same bytes, for tests of exactly that.
    pub general: bool,
    /// The draw's primitives have coverage (smooth points, lines or polygons): the rasteriser writes
    /// [`FragmentBatch::coverage`] for each lane.
    pub coverage: bool,
    /// An occlusion query is active: count the fragments that pass the tests in [`Band::samples`].
    pub count_samples: bool,
    /// Bit u: vertices may give unit u a q that is not 1. A q from texture generation or the texture matrix is found in
    /// the state.
    pub q_units: u32,
    /// The image whose groups give fragments their colour or depth, in place of the primitive's planes.
    pub pixels: Option<Arc<PixelRect>>,
    /// Note no decisions, which takes longer than all the rest of building a program.
    pub silent: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { general: false, coverage: false, count_samples: false, q_units: u32::MAX, pixels: None, silent: false }
    }
}

/// What became of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fate {
    /// It is in the program.
    Kept,
    /// It is not: it would change nothing.
    LeftOut,
    /// It is done earlier or less often than for every fragment in the specification's order.
    Hoisted,
}

impl std::fmt::Display for Fate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Kept => "kept",
            Self::LeftOut => "left out",
            Self::Hoisted => "hoisted",
        })
    }
}

/// A line of a program's explanation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Decision {
    /// What the stage does, in a word or two.
    pub stage: String,
    /// What became of it.
    pub fate: Fate,
    /// Why, in a sentence.
    pub reason: String,
}

/// One step of a program.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// A fragment stage.
    Stage(Step<FragFn>),
    /// Samples the texture of the sampler with this index.
    Sample(usize),
    /// Runs the texture environments.
    Environments,
    /// Goes on only if a fragment is alive.
    StopIfDead,
}

/// A fragment program.
#[derive(Clone, Debug)]
pub struct Program {
    /// What it was built from.
    pub key: FragmentKey,
    /// Which values the vertex stages and setup have to provide.
    pub layout: Layout,
    /// Whether the program reads what earlier fragments wrote: then a pixel must not be twice in a batch.
    pub reads_framebuffer: bool,
    /// Whether the rasteriser has to write [`FragmentBatch::coverage`].
    pub coverage: bool,
    /// What was decided about each stage, in the order of the specification; nothing where [`Options::silent`] is set.
    pub decisions: Vec<Decision>,
    pub(super) uniforms: FragUniforms,
    /// The reference path: what is done with a batch.
    pub(super) reference: Vec<Action>,
    /// The span path: what does rows of a primitive instead, where there is a kernel for the key.
    pub(super) span: Option<SpanKernel>,
    /// Hierarchical depth, where it is of use to the depth test.
    pub(super) hiz: Option<Hiz>,
    /// Whether depths may be raised, after which hierarchical depth means nothing.
    pub(super) raises_depth: bool,
    pub(super) samplers: Vec<Sampler>,
    pub(super) environments: Option<EnvPlan>,
    /// Where what is done is counted, if counting is on.
    pub(super) tally: Option<Tally>,
}

/// From this length on a row, or what is left of it, is worth a batch of its own: stages that compute whole rows are
/// faster than those that go over the pieces of several, but compute unused lanes as well.
const OWN_BATCH_FROM: u32 = 32;
/// What a pixel costs that goes through batches, at the least, in pixels of one colour.
pub const ORDINARY: u64 = 32;

impl Program {
    /// Whether nothing can change by drawing: the whole draw may be dropped.
    #[must_use]
    pub fn draws_nothing(&self) -> bool {
        self.key.draws_nothing()
    }

    /// Runs the program over a batch: `segments` and `tex.n` are set, and for lanes of segments that are no rows
    /// `offset`, `dx` and `dy`. `planes` and `pool` are the scene's. The batch can be cleared and filled again after it.
    #[inline]
    pub fn run<'a>(
        &self,
        batch: &mut FragmentBatch,
        planes: &'a [Planes],
        pool: impl Into<PlanePool<'a>>,
        band: &mut Band<'_>,
    ) {
        if self.raises_depth {
            band.hier_z.invalidate();
        }
        self.run_reference(batch, &mut Work { planes, pool: pool.into(), band, counts: None });
    }

    #[inline]
    fn run_reference(&self, batch: &mut FragmentBatch, work: &mut Work<'_, '_>) {
        if let Some(tally) = &self.tally {
            return self.run_counted(batch, work, tally);
        }
        for action in &self.reference {
            if !self.act(action, batch, work) {
                return;
            }
        }
    }

    /// One action; false says that no fragment is alive and the rest can be left out.
    #[inline(always)]
    pub(super) fn act(&self, action: &Action, batch: &mut FragmentBatch, work: &mut Work<'_, '_>) -> bool {
        match action {
            Action::Stage(step) => {
                #[expect(unsafe_code, reason = "the level was checked when the program was built")]
                // SAFETY: a program is built for no level that the processor does not have.
                unsafe {
                    (step.run())(batch, &self.uniforms, work, step.arg);
                }
            }
            Action::Sample(i) => {
                if let Some(sampler) = self.samplers.get(*i) {
                    sampler.run(&mut batch.tex);
                }
            }
            Action::Environments => {
                if let Some(environments) = &self.environments {
                    environments.run(&mut batch.tex);
                }
            }
            Action::StopIfDead => return batch.alive,
        }
        true
    }

    /// Rows from this length on may be given to [`row`](Self::row).
    #[must_use]
    pub fn row_from(&self) -> u32 {
        self.span.as_ref().map_or(OWN_BATCH_FROM, |kernel| kernel.long_from)
    }

    /// Shorter rows than this may be collected, those of one primitive at a time, and given to [`rows`](Self::rows).
    #[must_use]
    pub fn rows_below(&self) -> u32 {
        self.span.as_ref().map_or(0, |kernel| kernel.short_below)
    }

    /// About what a pixel of a large primitive costs, in pixels of one colour: enough to tell whether its rows are worth
    /// a second thread.
    #[must_use]
    pub fn weight(&self, planes: &Planes, pool: PlanePool<'_>) -> u64 {
        let Some(kernel) = &self.span else { return ORDINARY };
        let depth = if kernel.tests_depth() { 2 } else { 0 };
        let is_flat = kernel.is_untextured() && (!kernel.has_primary_color() || self.has_one_color(planes, pool));
        depth + if is_flat { 1 } else { kernel.pixel }
    }

    /// Whether the primary colour of a primitive that stands alone is the same everywhere.
    fn has_one_color(&self, planes: &Planes, pool: PlanePool<'_>) -> bool {
        let Some(slot) = self.layout.color else { return true };
        let colors = pool.alone.get(planes.first as usize + slot..).and_then(|rest| rest.first_chunk());
        planes.member.is_none() && colors.is_some_and(|colors| constant(colors).is_some())
    }

    /// Draws rows of one primitive, which are the segments of the batch. Returns false, and draws nothing, where they
    /// must come one by one.
    #[inline]
    pub fn rows<'a>(
        &self,
        batch: &mut FragmentBatch,
        planes: &'a [Planes],
        pool: impl Into<PlanePool<'a>>,
        band: &mut Band<'_>,
    ) -> bool {
        let Some(step) = self.span.as_ref().and_then(|kernel| kernel.short.as_ref()) else { return false };
        if self.raises_depth {
            band.hier_z.invalidate();
        }
        let mut work = Work { planes, pool: pool.into(), band, counts: self.counts() };
        let pixels =
            work.counts.map(|_| batch.segments.iter().take(batch.segment_count).map(|s| u64::from(s.len)).sum());
        #[expect(unsafe_code, reason = "the level was checked when the program was built")]
        // SAFETY: a program is built for no level that the processor does not have.
        let done = unsafe { (step.run())(batch, &self.uniforms, &mut work, step.arg) };
        if let (Some(counts), Some(pixels)) = (&mut work.counts, pixels)
            && done
        {
            counts.fragments = pixels;
            self.add_counts(Some(step.id), counts);
        }
        done
    }

    /// Draws pixels of one row of a primitive, from its start on as many as pay. The rest, as a rule fewer than
    /// [`row_from`](Self::row_from), must come in batches. Returns how many pixels are drawn.
    #[inline]
    pub fn row<'a>(
        &self,
        batch: &mut FragmentBatch,
        run: Segment,
        planes: &'a [Planes],
        pool: impl Into<PlanePool<'a>>,
        band: &mut Band<'_>,
    ) -> u32 {
        if self.span.is_some() && self.raises_depth {
            band.hier_z.invalidate();
        }
        let mut work = Work { planes, pool: pool.into(), band, counts: self.counts() };
        let done = match &self.span {
            Some(kernel) if kernel.is_untextured() => self.span_step(&kernel.long, batch, &run, &mut work),
            _ => self.row_in_parts(batch, run, &mut work),
        };
        if let Some(counts) = &work.counts {
            self.add_counts(self.span.as_ref().map(|kernel| kernel.long.id), counts);
        }
        done
    }

    /// Draws a row in parts: some by the kernel, the others through batches.
    fn row_in_parts(&self, batch: &mut FragmentBatch, run: Segment, work: &mut Work<'_, '_>) -> u32 {
        let len = run.len;
        // Built field by field for a whole row as well: fields of a struct that was just copied are read slowly, since
        // each read waits until the wide stores of the copy have reached the cache.
        let rest = |done: u32| {
            let (x, offset) = (run.x.wrapping_add(done as i32), run.offset.wrapping_add(done));
            Segment { start: 0, len: len - done, x, offset, row: true, ..run }
        };
        let (mut done, mut kernel) = (0, self.span.as_ref());
        if let (Some(_), Some(hiz)) = (kernel, &self.hiz) {
            // First of all, since the whole row may be hidden.
            done = self.hiz_cull(hiz, batch, &rest(0), work);
            if done == len {
                return len;
            }
        }
        // The first pixel that went through a batch, and the first one after the last batch.
        let (mut first, mut last) = (len, 0);
        batch.alive = false;
        batch.lookahead.begin(len - done);
        loop {
            if let Some(span) = kernel {
                let filled = self.span_step(&span.long, batch, &rest(done), work);
                batch.lookahead.advance(filled);
                done += filled;
                // Where bounds of rho choose the mipmap levels, the kernel may draw what follows the next batch.
                kernel = kernel.filter(|kernel| kernel.resumes);
            }
            if len - done < OWN_BATCH_FROM {
                break;
            }
            if let Some(hiz) = &self.hiz
                && !batch.alive
            {
                // At the start of the row and after a batch that failed the test, more pixels may be hidden.
                let skipped = self.hiz_cull(hiz, batch, &rest(done), work);
                batch.lookahead.advance(skipped);
                done += skipped;
            }
            let n = (len - done).min(LANES as u32);
            if n > 0 {
                batch.segments[0] = Segment { len: n, ..rest(done) };
                batch.segment_count = 1;
                batch.tex.n = n as usize;
                if self.raises_depth {
                    work.band.hier_z.invalidate();
                }
                self.run_reference(batch, work);
                batch.lookahead.advance(n);
                first = first.min(done);
                done += n;
                last = done;
            }
        }
        batch.lookahead.begin(0);
        if let Some(Hiz { update: Some(step), .. }) = &self.hiz
            && first < last
        {
            self.step(step, batch, &Segment { len: last - first, ..rest(first) }, work);
        }
        done
    }

    /// Runs a step over a row. Returns how many pixels it has done, from the row's start on.
    #[inline]
    fn step(&self, step: &Step<LongFn>, batch: &mut FragmentBatch, run: &Segment, work: &mut Work<'_, '_>) -> u32 {
        #[expect(unsafe_code, reason = "the level was checked when the program was built")]
        // SAFETY: a program is built for no level that the processor does not have.
        let done = unsafe { (step.run())(batch, &self.uniforms, work, run, step.arg) };
        done.min(run.len)
    }

    /// Runs the kernel over a row and counts its pixels.
    #[inline]
    fn span_step(&self, step: &Step<LongFn>, batch: &mut FragmentBatch, run: &Segment, work: &mut Work<'_, '_>) -> u32 {
        let done = self.step(step, batch, run, work);
        if let Some(counts) = &mut work.counts {
            counts.fragments += u64::from(done);
        }
        done
    }

    /// How many pixels of a row hierarchical depth hides.
    #[inline]
    fn hiz_cull(&self, hiz: &Hiz, batch: &mut FragmentBatch, run: &Segment, work: &mut Work<'_, '_>) -> u32 {
        let hidden = self.step(&hiz.cull, batch, run, work);
        if let Some(counts) = &mut work.counts {
            counts.hidden += u64::from(hidden);
        }
        hidden
    }

    /// Counts for the span path, if counting is on.
    #[inline]
    fn counts(&self) -> Option<SpanCounts> {
        self.tally.as_ref().map(|_| SpanCounts::default())
    }

    /// The names of the stages of the reference path in the order in which they run.
    #[must_use]
    pub fn stage_names(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        for action in &self.reference {
            match action {
                Action::Stage(step) => names.push(step.id.name()),
                Action::Sample(i) => {
                    names.extend(self.samplers.get(*i).iter().flat_map(|s| s.plan.names()));
                }
                Action::Environments => {
                    names.extend(self.environments.iter().flat_map(|e| e.plan.names()));
                }
                Action::StopIfDead => {}
            }
        }
        names
    }

    /// The names of the span kernels that take the place of these stages: that of long rows, then that of short ones.
    #[must_use]
    pub fn span_names(&self) -> Vec<&'static str> {
        let kernel = self.span.iter();
        kernel.flat_map(|k| std::iter::once(k.long.id).chain(k.short.map(|step| step.id))).map(|id| id.name()).collect()
    }
}
