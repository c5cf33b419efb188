//! Counting what a program does: fragments into each stage, fragments that a test kills, texels, divisions, logarithms. It is
//! the program itself that is counted, on both of its paths: stages of the reference path by the lanes that were alive, span
//! kernels by the pixels that they say have passed.

use super::batch::FragmentBatch;
use super::hiz::HIZ_CULL;
use super::planes::Planes;
use super::program::{Action, Program};
use super::reference::interpolate::FIRST;
use super::reference::texcoord::{COORDINATES, unit_of};
use super::uniforms::{FragFn, SpanCounts, Work};
use crate::simd::{Counters, StageId, Step, Tally};

/// Lanes of a batch whose fragment is alive.
fn alive(batch: &FragmentBatch) -> u64 {
    batch.tex.mask.iter().take(batch.tex.n).filter(|mask| **mask != 0).count() as u64
}

/// Lanes of a batch for which 1 / D is more than a copy of 1.
fn in_perspective(batch: &FragmentBatch, planes: &[Planes]) -> u64 {
    let segments = batch.segments.iter().take(batch.segment_count);
    let divided = segments.filter(|s| planes.get(s.prim as usize).is_some_and(|planes| !planes.affine));
    divided.map(|s| u64::from(s.len)).sum()
}

impl Program {
    /// The same program, which from now on counts what it does.
    #[must_use]
    pub fn counted(mut self, tally: &Tally) -> Self {
        self.tally = Some(Tally::clone(tally));
        self
    }

    /// Adds what a span kernel has done with a row, or the rows of a primitive.
    pub(super) fn add_counts(&self, kernel: Option<StageId>, counts: &SpanCounts) {
        let Some(tally) = &self.tally else { return };
        let SpanCounts { fragments, passed, hidden, cost } = *counts;
        Counters::with(tally, |all| {
            all.fragments += fragments + hidden;
            all.passed += passed;
            all.add_pixels(cost);
            if let Some(kernel) = kernel.filter(|_| fragments > 0) {
                all.add_stage(kernel.name(), fragments, passed);
            }
            if hidden > 0 {
                all.add_stage(HIZ_CULL.id.name(), hidden, 0);
            }
        });
    }

    /// Divisions of a step over a batch: by w where it is the first to need it, by q where its unit has one.
    fn divisions(&self, Step { id, arg, .. }: Step<FragFn>, batch: &FragmentBatch, planes: &[Planes]) -> u64 {
        let unit = if id == COORDINATES.id { self.layout.units.get(unit_of(arg)).copied().flatten() } else { None };
        if unit.is_some_and(|unit| unit.has_q && !unit.cube) {
            return batch.tex.n as u64;
        }
        if id.cost().divides && arg & FIRST != 0 { in_perspective(batch, planes) } else { 0 }
    }

    /// [`Program::run`] with every step counted.
    pub fn run_counted(&self, batch: &mut FragmentBatch, work: &mut Work<'_, '_>, tally: &Tally) {
        Counters::with(tally, |all| {
            all.fragments += batch.tex.n as u64;
            for action in &self.reference {
                let before = if batch.tex.n > 0 && self.begun(action) { alive(batch) } else { batch.tex.n as u64 };
                if !self.act(action, batch, work) {
                    return;
                }
                let left = alive(batch);
                match action {
                    Action::Stage(step) => {
                        all.divisions += self.divisions(*step, batch, work.planes);
                        all.add_stage(step.id.name(), before, left);
                    }
                    Action::Sample(i) => {
                        let Some(sampler) = self.samplers.get(*i) else { continue };
                        let done = sampler.done(&batch.tex);
                        all.texels += done.texels * before;
                        all.wraps += done.wraps * before;
                        all.logarithms += done.logarithms * before + done.logarithms_once;
                        sampler.plan.names().for_each(|name| all.add_stage(name, before, left));
                    }
                    Action::Environments => {
                        let names = self.environments.iter().flat_map(|e| e.plan.names());
                        names.for_each(|name| all.add_stage(name, before, left));
                    }
                    Action::StopIfDead => {}
                }
            }
            all.passed += alive(batch);
        });
    }

    /// Whether the mask has been set when an action comes: the first one sets it.
    fn begun(&self, action: &Action) -> bool {
        self.reference.first().is_some_and(|first| !std::ptr::eq(first, action))
    }
}
