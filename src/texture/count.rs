//! What a sampler did with a batch, for those who count: texels read and logarithms taken. A row says what one run of a
//! stage costs a lane; stages that are in no row read no texel.

use super::batch::TexBatch;
use super::sampler::Sampler;

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

/// What a sampler did for one lane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Texels read.
    pub texels: u64,
    /// Logarithms taken.
    pub logarithms: u64,
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
            done.logarithms += cost(LOGARITHMS, step.name);
            done.logarithms += u64::from(step.name.starts_with("NEAREST_LEVEL_") && batch.work.by_lambda);
        }
        done
    }
}
