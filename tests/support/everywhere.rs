//! The ways of running that must not change a bit: every instruction set that the processor has, 1, 2 and 7 threads, two
//! batch cuts, the plan that leaves nothing out. And what a picture is compared by: colours, depths and stencil values.

#![allow(dead_code, reason = "every test binary that includes this uses another part of it")]

use fixedgl::Config;
use fixedgl::Context;
use fixedgl::SimdLevel;

/// All that drawing leaves in the framebuffer.
#[derive(PartialEq)]
pub struct Frame {
    pub colors: Vec<u8>,
    pub depths: Vec<u64>,
    pub stencils: Vec<u8>,
}

impl Frame {
    /// What the context has drawn.
    pub fn of(context: &mut Context) -> Frame {
        let depths = context.depths().iter().map(|depth| depth.to_bits()).collect();
        Frame { colors: context.pixels(), depths, stencils: context.stencils() }
    }

    /// How many pixels have another colour than in the other frame.
    pub fn differing(&self, other: &Frame) -> usize {
        self.colors.chunks(4).zip(other.colors.chunks(4)).filter(|(a, b)| a != b).count()
    }
}

/// The reference: one thread, full batches, the best instruction set.
pub fn reference() -> Config {
    Config::default().with_threads(1)
}

/// All other ways.
pub fn variants() -> Vec<Config> {
    let base = reference();
    let mut all: Vec<Config> = SimdLevel::available().map(|level| base.with_level(level)).collect();
    all.extend([2, 7].map(|threads| base.with_threads(threads)));
    all.extend([17, 1].map(|batch_cut| base.with_batch_cut(batch_cut)));
    all.push(base.with_general_plan(true));
    all.push(base.with_level(SimdLevel::BASELINE).with_threads(7).with_batch_cut(17).with_general_plan(true));
    all
}
