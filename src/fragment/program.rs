//! The fragment program: the list of stages that the state needs, built once for a draw and run over every batch. What
//! the state makes a no-op is left out (`build` decides); the list of what was kept and left out, with
//! the reasons, stays with the program so that it can be explained.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{Layout, PlanePool, Planes};
use crate::fragment::reference::pack::constant;
use crate::fragment::span::long::{COLOR, DEPTH};
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::framebuffer::Band;
use crate::simd::{LANES, Step, Tally};
use crate::texture::env::EnvPlan;
use crate::texture::sampler::Sampler;

/// How a program is to be built, apart from the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Note no decisions, which takes longer than all the rest of building a program.
    pub silent: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { general: false, coverage: false, count_samples: false, q_units: u32::MAX, silent: false }
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
    /// Which values the vertex stages and setup have to provide.
    pub layout: Layout,
    /// Whether the program reads what earlier fragments wrote: then a pixel must not be twice in a batch.
    pub reads_framebuffer: bool,
    /// Whether nothing can change by drawing: the whole draw may be dropped.
    pub draws_nothing: bool,
    /// Whether the rasteriser has to write [`FragmentBatch::coverage`].
    pub coverage: bool,
    /// What was decided about each stage, in the order of the specification; nothing where [`Options::silent`] is set.
    pub decisions: Vec<Decision>,
    pub(super) uniforms: FragUniforms,
    pub(super) actions: Vec<Action>,
    /// The stage that does whole runs by itself, where the program is so simple that there is one.
    pub(super) fill: Option<Step<FragFn>>,
    /// The stage that does parts of runs which that one leaves, because two levels of a texture are blended.
    pub(super) fill_levels: Option<Step<FragFn>>,
    /// The stage that does rows of a primitive that are too short for those two, and the one that does what it leaves.
    pub(super) rows: [Option<Step<FragFn>>; 2],
    /// Whether the stage for whole runs reads no texture.
    pub(super) untextured: bool,
    /// Whether the stages for whole runs leave parts of which batches must find out the levels.
    pub(super) levelled: bool,
    /// The stage that says which pixels of a run the coarse depths hide.
    pub(super) hiz_cull: Option<Step<FragFn>>,
    /// The stage that tells the coarse depths of what a run has left behind.
    pub(super) hiz_update: Option<Step<FragFn>>,
    /// Whether depths may be raised, after which the coarse depths mean nothing.
    pub(super) raises_depth: bool,
    pub(super) samplers: Vec<Sampler>,
    pub(super) environments: Option<EnvPlan>,
    /// Where what is done is counted, if somebody wants to know.
    pub(super) tally: Option<Tally>,
}

/// From this length on a run is worth a call of the stage that fills.
const FILLED: u32 = 8;
/// The same of a stage that shows a texture: shorter runs of several rows make a batch that is computed as a whole.
const SHOWN: u32 = 48;
/// Shorter rows than this are done together with the others of their primitive.
const COLLECTED: u32 = 128;
/// The same of a stage that reads no texture. Texels that are copied are so faster row by row, from [`SHOWN`] on.
const PAINTED: u32 = 64;
/// From this length on a run, or what is left of it, is worth a batch of its own: stages that compute whole rows are
/// faster than those that go over the pieces of several, but compute unused lanes as well.
const SPLIT: u32 = 32;
/// What a pixel costs that goes through batches, at the least, in pixels of one colour.
pub const ORDINARY: u64 = 32;

impl Program {
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
        let mut work = Work { planes, pool: pool.into(), band };
        if let Some(tally) = &self.tally {
            return self.run_counted(batch, &mut work, tally);
        }
        for action in &self.actions {
            if !self.act(action, batch, &mut work) {
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
                    (step.run)(batch, &self.uniforms, work, step.arg);
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

    /// Runs of a row from this length on may be given to [`row`](Self::row).
    #[must_use]
    pub fn row_from(&self) -> u32 {
        match (&self.fill, self.untextured) {
            (Some(_), true) => FILLED,
            (Some(_), false) => SHOWN,
            _ => SPLIT,
        }
    }

    /// Shorter runs than this may be collected, those of one primitive at a time, and given to [`rows`](Self::rows).
    #[must_use]
    pub fn rows_below(&self) -> u32 {
        match (&self.rows[0], self.untextured, &self.uniforms.copied) {
            (None, ..) => 0,
            (_, true, _) => PAINTED,
            (.., Some(_)) => SHOWN,
            _ => COLLECTED,
        }
    }

    /// Works on rows of one primitive, the segments of the batch; gives whether it has: otherwise they must come one by one.
    #[inline]
    pub fn rows<'a>(
        &self,
        batch: &mut FragmentBatch,
        planes: &'a [Planes],
        pool: impl Into<PlanePool<'a>>,
        band: &mut Band<'_>,
    ) -> bool {
        if self.raises_depth {
            band.hier_z.invalidate();
        }
        let mut work = Work { planes, pool: pool.into(), band };
        for step in self.rows.iter().flatten() {
            #[expect(unsafe_code, reason = "the level was checked when the program was built")]
            // SAFETY: a program is built for no level that the processor does not have.
            unsafe {
                (step.run)(batch, &self.uniforms, &mut work, step.arg);
            }
            if batch.tex.n > 0 {
                return true;
            }
        }
        false
    }

    /// About what a pixel of a large primitive costs, in pixels of one colour: enough to tell whether its rows are worth
    /// a second thread.
    #[must_use]
    pub fn weight(&self, planes: &Planes, pool: PlanePool<'_>) -> u64 {
        let Some(fill) = self.fill else { return ORDINARY };
        let depth = if fill.arg & DEPTH == 0 { 0 } else { 2 };
        let color = match (self.untextured, &self.uniforms.copied) {
            (true, _) if fill.arg & COLOR == 0 || self.has_one_color(planes, pool) => 1,
            (true, _) => 4,
            (_, Some(_)) => 6,
            _ => 24,
        };
        color + depth
    }

    /// Whether the primary colour of a primitive that stands alone is the same everywhere.
    fn has_one_color(&self, planes: &Planes, pool: PlanePool<'_>) -> bool {
        let Some(slot) = self.layout.color else { return true };
        let colors = pool.alone.get(planes.first as usize + slot..).and_then(|rest| rest.first_chunk());
        planes.member.is_none() && colors.is_some_and(|colors| constant(colors).is_some())
    }

    /// Works on pixels of one primitive and row, from its start on as many as pay: the rest, whose number is less than
    /// [`row_from`](Self::row_from) as a rule, must come in batches. Returns how many it has done.
    #[inline]
    pub fn row<'a>(
        &self,
        batch: &mut FragmentBatch,
        run: Segment,
        planes: &'a [Planes],
        pool: impl Into<PlanePool<'a>>,
        band: &mut Band<'_>,
    ) -> u32 {
        let (len, pool) = (run.len, pool.into());
        // For all of a run as well: a copy of it in one piece is read by parts, which has to wait for it.
        let rest = |done: u32| {
            let (x, offset) = (run.x.wrapping_add(done as i32), run.offset.wrapping_add(done));
            Segment { start: 0, len: len - done, x, offset, row: true, ..run }
        };
        if self.fill.is_some() && self.raises_depth {
            band.hier_z.invalidate();
        }
        let (mut done, mut fill) = (0, self.fill.as_ref());
        if self.untextured
            && let Some(step) = fill
        {
            return self.measure(step, batch, rest(0), Work { planes, pool, band });
        }
        if let (Some(_), Some(step)) = (fill, &self.hiz_cull) {
            // Before anything is worked out for a run that may be hidden as a whole.
            done = self.measure(step, batch, rest(0), Work { planes, pool, band });
            if done == len {
                return len;
            }
        }
        // The first pixel that was worked on, and the first after those that were.
        let (mut first, mut last) = (len, 0);
        batch.alive = false;
        batch.lookahead.begin(len - done);
        loop {
            if let Some(step) = fill {
                let filled = self.measure(step, batch, rest(done), Work { planes, pool, band });
                batch.lookahead.advance(filled);
                done += filled;
                if let Some(step) = self.fill_levels.as_ref().filter(|_| done < len) {
                    let filled = self.measure(step, batch, rest(done), Work { planes, pool, band });
                    batch.lookahead.advance(filled);
                    done += filled;
                }
                // What was in its way for one batch may not be for the next one, where it has to know the level.
                fill = fill.filter(|_| self.levelled);
            }
            if len - done < SPLIT {
                break;
            }
            if let Some(step) = &self.hiz_cull
                && !batch.alive
            {
                // At the start of the run and where nothing was alive, something may be hidden.
                let skipped = self.measure(step, batch, rest(done), Work { planes, pool, band });
                batch.lookahead.advance(skipped);
                done += skipped;
            }
            let n = (len - done).min(LANES as u32);
            if n > 0 {
                batch.segments[0] = Segment { len: n, ..rest(done) };
                batch.segment_count = 1;
                batch.tex.n = n as usize;
                self.run(batch, planes, pool, band);
                batch.lookahead.advance(n);
                first = first.min(done);
                done += n;
                last = done;
            }
        }
        batch.lookahead.begin(0);
        if let Some(step) = &self.hiz_update
            && first < last
        {
            let run = Segment { len: last - first, ..rest(first) };
            self.measure(step, batch, run, Work { planes, pool, band });
        }
        done
    }

    /// Runs a stage over a run of any length, of which it does some pixels from the start on, and says how many.
    #[inline]
    fn measure(&self, step: &Step<FragFn>, batch: &mut FragmentBatch, run: Segment, work: Work<'_, '_>) -> u32 {
        batch.segments[0] = run;
        batch.segment_count = 1;
        let mut work = work;
        #[expect(unsafe_code, reason = "the level was checked when the program was built")]
        // SAFETY: a program is built for no level that the processor does not have.
        unsafe {
            (step.run)(batch, &self.uniforms, &mut work, step.arg);
        }
        (batch.tex.n as u32).min(run.len)
    }

    /// The names of the stages in the order in which they run.
    #[must_use]
    pub fn stage_names(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        for action in &self.actions {
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
}
