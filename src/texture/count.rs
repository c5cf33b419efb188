//! What a sampler did with a batch, for those who count: texels read, logarithms taken, coordinates wrapped. A row says what one run of a
//! stage costs a lane; stages that are in no row read no texel.

use super::address;
use super::batch::{Detail, TexBatch};
use super::filter::{REPEATS, SECOND};
use super::linear::WRAPS;
use super::near::{Form, Range};
use super::sampler::Sampler;
use super::uniforms::TexFn;
use crate::simd::Step;

/// Beginnings of the names of stages, and the texels that such a stage reads for a lane.
const TEXELS: &[(&str, u64)] = &[
    ("NEAREST_ONE_TAP", 0),
    ("NEAREST_LEVEL_", 0),
    ("NEAREST_", 1),
    ("WRAP_NEAREST_", 1),
    ("LINEAR_1D", 2),
    ("BILINEAR_", 4),
    ("TRILINEAR_", 8),
    ("DEPTH_NEAREST_", 1),
    ("DEPTH_LINEAR_1D", 2),
    ("DEPTH_BILINEAR_", 4),
    ("SHADOW_NEAREST_", 1),
    ("SHADOW_LINEAR_1D", 2),
    ("SHADOW_BILINEAR_", 4),
];

/// The same for logarithms.
const LOGARITHMS: &[(&str, u64)] = &[("LAMBDA_1D", 1), ("LAMBDA_2D", 1), ("LAMBDA_3D", 1), ("FOOTPRINT_", 1)];

fn cost(table: &[(&str, u64)], name: &str) -> u64 {
    table.iter().find(|(start, _)| name.starts_with(start)).map_or(0, |(_, cost)| *cost)
}

/// What a sampler did, for each lane if nothing else is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
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
    pub fn done(&self, batch: &TexBatch) -> Done {
        let mut done = Done::default();
        for (i, step) in self.plan.steps.iter().enumerate() {
            let texels = cost(TEXELS, step.name);
            let tap = self.taps.is_some_and(|(start, end)| (start..end).contains(&i));
            let times = if tap { u64::from(batch.work.taps) } else { 1 };
            let skipped = step.arg & super::filter::SECOND != 0 && !batch.work.two_levels;
            done.texels += if skipped { 0 } else { texels * times };
            done.wraps += if skipped { 0 } else { self.wraps(step, batch) * times };
            let by_lambda = u64::from(step.name.starts_with("NEAREST_LEVEL_") && batch.work.by_lambda);
            let logarithms = cost(LOGARITHMS, step.name) + by_lambda;
            if self.once && batch.detail == Detail::Even {
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
        let same = batch.work.same[usize::from(step.arg & SECOND != 0)].and_then(|same| u.images.get(same));
        let wrapped = |c: u32, repeats: bool| {
            let form = same.and_then(|image| {
                let n = image.size[c as usize];
                Form::new(repeats, Range::of(batch, c as usize), if u.unnormalised { 1.0 } else { n }, n)
            });
            u64::from(form.is_none_or(Form::wraps))
        };
        let dims = match step.name {
            name if name.starts_with("LINEAR_1D") => 1,
            name if name.starts_with("BILINEAR_2D_") => 2,
            name if name.starts_with("TRILINEAR_3D_") => 3,
            _ => 0,
        };
        match step.name {
            "WRAP_REPEAT_LINEAR" | "WRAP_CLAMP_LINEAR" if step.arg & address::PLAIN == 0 => {
                wrapped((step.arg & address::COORDINATE).min(2), step.name == "WRAP_REPEAT_LINEAR")
            }
            name if name.starts_with("WRAP_NEAREST_2D") => 2,
            name if name.starts_with("WRAP_") => 1,
            _ if step.arg & WRAPS != 0 => (0..dims).map(|c| wrapped(c, step.arg & REPEATS << c != 0)).sum(),
            _ => 0,
        }
    }
}
