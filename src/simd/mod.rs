//! Batches, stages and plans. A *batch* is 64 of something (vertices, fragments) as structures of arrays; a *stage* is a
//! plain loop over the lanes of a batch; a *plan* is the list of stages that the current state needs. Each stage body is
//! compiled three times (baseline x86-64, AVX2, AVX-512) from one source, and one of the three is picked at start. Since
//! rustc never contracts `a*b+c`, all three give the same bits.

mod bits;
mod counters;
mod level;

pub use bits::{BITS, Bits, count};
pub use counters::{Counters, StageCount, Tally};
pub use level::Level;

/// How many lanes a batch has.
pub const LANES: usize = 64;

/// A stage: its name for `explain`, and one function for each [`Level`]. `F` is an `unsafe fn` pointer type, because a
/// function compiled for AVX-512 must only run where AVX-512 is.
#[derive(Debug)]
pub struct Stage<F> {
    /// What the stage is called in a printed plan.
    pub name: &'static str,
    /// The body compiled for each level, indexed by [`Level`].
    pub levels: [F; 3],
}

/// A stage in a plan, with the number (a unit, a channel, a table index) that it works with.
#[derive(Clone, Copy, Debug)]
pub struct Step<F> {
    /// The stage's name.
    pub name: &'static str,
    /// The function for the level that was picked.
    pub run: F,
    /// What the stage is told: its meaning is the stage's own.
    pub arg: u32,
}

/// A list of stages, ready to run over batches.
#[derive(Clone, Debug)]
pub struct Plan<F> {
    /// The steps in order.
    pub steps: Vec<Step<F>>,
    level: Level,
}

impl<F: Copy> Plan<F> {
    /// An empty plan for a level.
    #[must_use]
    pub const fn new(level: Level) -> Self {
        Self { steps: Vec::new(), level }
    }

    /// Appends a stage.
    pub fn push(&mut self, stage: &Stage<F>, arg: u32) {
        self.steps.push(Step { name: stage.name, run: stage.levels[self.level as usize], arg });
    }

    /// The level that the plan was made for.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }
}

/// Builds for measuring may pass `--cfg fixedgl_only_avx512` (or `_avx2`) to compile one level only, which takes a third
/// of the time; what they build must run on a processor that has it.
///
/// Defines stages: `stage! { /// doc
/// pub fn NAME: FnType = (b: &mut Batch, u: &Uniforms, arg: u32) { body } }` makes `pub static NAME: Stage<FnType>`.
macro_rules! stage {
    ($($(#[$meta:meta])* $vis:vis fn $name:ident: $f:ty = ($($arg:ident: $ty:ty),* $(,)?) $body:block)*) => {$(
        $(#[$meta])*
        $vis static $name: $crate::simd::Stage<$f> = {
            #[inline(always)]
            fn body($($arg: $ty),*) $body
            #[cfg(not(all(target_arch = "x86_64", any(fixedgl_only_avx2, fixedgl_only_avx512))))]
            fn baseline($($arg: $ty),*) { body($($arg),*) }
            #[cfg(all(target_arch = "x86_64", not(fixedgl_only_avx512)))]
            #[target_feature(enable = "avx2,bmi1,bmi2,popcnt,lzcnt")]
            fn avx2($($arg: $ty),*) { body($($arg),*) }
            #[cfg(all(target_arch = "x86_64", not(fixedgl_only_avx2)))]
            #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx512cd,avx2,bmi1,bmi2,popcnt,lzcnt")]
            fn avx512($($arg: $ty),*) { body($($arg),*) }
            #[cfg(not(target_arch = "x86_64"))]
            use {baseline as avx2, baseline as avx512};
            #[cfg(all(target_arch = "x86_64", fixedgl_only_avx2))]
            use {avx2 as baseline, avx2 as avx512};
            #[cfg(all(target_arch = "x86_64", fixedgl_only_avx512))]
            use {avx512 as baseline, avx512 as avx2};
            $crate::simd::Stage { name: stringify!($name), levels: [baseline, avx2, avx512] }
        };
    )*};
}
pub(crate) use stage;

#[cfg(test)]
mod tests {
    use super::*;

    type TestFn = for<'a> unsafe fn(&mut [f32; LANES], &'a [f32], u32);

    stage! {
        /// Adds.
        fn ADD: TestFn = (b: &mut [f32; LANES], u: &[f32], arg: u32) {
            let k = u.get(arg as usize).copied().unwrap_or(0.0);
            for lane in b.iter_mut() { *lane += k; }
        }
    }

    #[test]
    fn a_stage_runs_at_every_level_that_is_there() {
        for level in Level::available() {
            let mut plan = Plan::new(level);
            plan.push(&ADD, 1);
            let mut batch = [1.0; LANES];
            for step in &plan.steps {
                #[expect(unsafe_code, reason = "the level is one that the processor has")]
                unsafe {
                    (step.run)(&mut batch, &[5.0, 2.0], step.arg);
                }
            }
            assert_eq!(batch, [3.0; LANES]);
        }
    }
}
