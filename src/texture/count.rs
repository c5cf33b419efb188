//! What a sampler did with a batch, for those who count: texels read, logarithms taken, coordinates wrapped. Each stage says
//! what one run of it costs a lane.

use super::batch::{Derivatives, TexBatch};
use super::filter::linear_rgba8::WRAPS;
use super::filter::{REPEATS, SECOND};
use super::lod;
use super::sampler::Sampler;
use super::uniforms::TexFn;
use super::wrap::bounded::{CoordBounds, LinearWrap};
use super::wrap::general;
use crate::simd::Step;

/// What a sampler did, for each lane if nothing else is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SamplerCounts {
    /// Texels read.
    pub texels: u64,
    /// Logarithms taken.
    pub logarithms: u64,
    /// Logarithms taken once for all lanes.
    pub logarithms_once: u64,
    /// Coordinates wrapped.
    pub wraps: u64,
}

impl Sampler {
    /// What the last run over this batch did for each lane.
    #[must_use]
    pub fn done(&self, batch: &TexBatch) -> SamplerCounts {
        let mut done = SamplerCounts::default();
        for (i, step) in self.plan.steps.iter().enumerate() {
            let cost = step.id.cost();
            let tap = self.taps.is_some_and(|(start, end)| (start..end).contains(&i));
            let times = if tap { u64::from(batch.scratch.taps) } else { 1 };
            let skipped = step.arg & super::filter::SECOND != 0 && !batch.scratch.two_levels;
            done.texels += if skipped { 0 } else { u64::from(cost.texels) * times };
            done.wraps += if skipped { 0 } else { self.wraps(step, batch) * times };
            let chooses = (1..=3).any(|dims| step.is(lod::nearest_level_stage(dims)));
            let logarithms = u64::from(cost.logarithms) + u64::from(chooses && batch.scratch.by_lambda);
            if self.once && batch.derivatives == Derivatives::Uniform {
                done.logarithms_once += logarithms;
            } else {
                done.logarithms += logarithms;
            }
        }
        done
    }

    /// Coordinates that a stage wrapped. Those within 0..=1 it may only have multiplied.
    fn wraps(&self, step: &Step<TexFn>, batch: &TexBatch) -> u64 {
        let u = &self.uniforms;
        let same = batch.scratch.same[usize::from(step.arg & SECOND != 0)].and_then(|same| u.images.get(same));
        let wrapped = |c: u32, repeats: bool| {
            let form = same.and_then(|image| {
                let n = image.size[c as usize];
                LinearWrap::new(repeats, CoordBounds::of(batch, c as usize), if u.unnormalised { 1.0 } else { n }, n)
            });
            u64::from(form.is_none_or(LinearWrap::wraps))
        };
        let cost = step.id.cost();
        let repeats = step.is(&general::WRAP_REPEAT_LINEAR);
        if (repeats || step.is(&general::WRAP_CLAMP_LINEAR)) && step.arg & general::PLAIN == 0 {
            return wrapped((step.arg & general::COORDINATE).min(2), repeats);
        }
        let itself = if step.arg & WRAPS == 0 { 0 } else { cost.may_wrap };
        u64::from(cost.wraps) + (0..itself).map(|c| wrapped(c, step.arg & REPEATS << c != 0)).sum::<u64>()
    }
}
