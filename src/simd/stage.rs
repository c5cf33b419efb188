//! Stages and plans. A stage has an identity, which carries its name and what it costs, and one function for each
//! instruction set; a plan is a list of stages with their arguments. Who wants to know whether a step is a certain stage
//! compares identities, never names.

use super::Level;
use std::fmt;

/// What a stage costs one lane, for those who count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Texels read.
    pub texels: u32,
    /// Logarithms taken.
    pub logarithms: u32,
    /// Texture coordinates wrapped in any case.
    pub wraps: u32,
    /// Texture coordinates that are wrapped only where the argument asks for it.
    pub may_wrap: u32,
    /// Whether it multiplies with 1 / D, and divides where it is the first that does.
    pub divides: bool,
}

impl Cost {
    /// Nothing that is counted.
    pub const NONE: Self = Self { texels: 0, logarithms: 0, wraps: 0, may_wrap: 0, divides: false };

    /// So many texels.
    #[must_use]
    pub const fn texels(texels: u32) -> Self {
        Self { texels, ..Self::NONE }
    }

    /// So many texels at so many coordinates, wrapped where the argument asks for it.
    #[must_use]
    pub const fn filter(texels: u32, may_wrap: u32) -> Self {
        Self { texels, may_wrap, ..Self::NONE }
    }

    /// Wraps so many coordinates.
    #[must_use]
    pub const fn wraps(wraps: u32) -> Self {
        Self { wraps, ..Self::NONE }
    }
}

/// What is known of a stage apart from its code.
#[derive(Debug)]
pub struct StageInfo {
    /// What the stage is called in a printed plan.
    pub name: &'static str,
    /// What it costs a lane.
    pub cost: Cost,
}

/// Which stage it is.
#[derive(Clone, Copy)]
pub struct StageId(&'static StageInfo);

impl StageId {
    /// What the stage is called in a printed plan.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.0.name
    }

    /// What it costs a lane.
    #[must_use]
    pub const fn cost(self) -> Cost {
        self.0.cost
    }
}

impl PartialEq for StageId {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

impl Eq for StageId {}

impl fmt::Debug for StageId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A stage: its identity, and one function for each [`Level`]. `F` is an `unsafe fn` pointer type, because a function
/// compiled for AVX-512 must only run where AVX-512 is.
#[derive(Debug)]
pub struct Stage<F> {
    /// Which stage it is.
    pub id: StageId,
    /// The body compiled for each level, lowest first.
    levels: [F; 3],
}

impl<F: Copy> Stage<F> {
    /// A stage of a body compiled for each level; only [`stage!`] makes them.
    pub(crate) const fn new(info: &'static StageInfo, levels: [F; 3]) -> Self {
        Self { id: StageId(info), levels }
    }

    /// The body for a level. The processor has what it needs: see [`Level`].
    #[must_use]
    pub fn at(&self, level: Level) -> F {
        self.levels[level.index()]
    }

    /// The stage as a step at a level.
    #[must_use]
    pub fn step(&self, level: Level, arg: u32) -> Step<F> {
        Step { id: self.id, run: self.at(level), arg }
    }
}

/// A stage in a plan, with the number (a unit, a channel, a table index) that it works with.
#[derive(Clone, Copy, Debug)]
pub struct Step<F> {
    /// Which stage it is.
    pub id: StageId,
    /// The function for the level that was picked. Nobody else writes it, so that the processor has what it needs.
    run: F,
    /// What the stage is told: its meaning is the stage's own.
    pub arg: u32,
}

impl<F: Copy> Step<F> {
    /// The function for the level that was picked.
    #[inline(always)]
    #[must_use]
    pub fn run(&self) -> F {
        self.run
    }

    /// The same stage with another argument.
    #[must_use]
    pub fn with_arg(self, arg: u32) -> Self {
        Self { arg, ..self }
    }

    /// Whether the step is this stage.
    #[must_use]
    pub fn is(&self, stage: &Stage<F>) -> bool {
        self.id == stage.id
    }
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
        self.steps.push(stage.step(self.level, arg));
    }

    /// The level that the plan was made for.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }

    /// The names of the stages in order.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.steps.iter().map(|step| step.id.name())
    }
}

/// Builds for measuring may pass `--cfg fixedgl_only_avx512` (or `_avx2`) to compile one level only, which takes a third
/// of the time; what they build must run on a processor that has it.
///
/// Defines stages: `stage! { /// doc
/// pub fn NAME: FnType = (b: &mut Batch, u: &Uniforms, arg: u32) { body } }` makes `pub static NAME: Stage<FnType>`.
/// What it costs stands behind the type: `pub fn NAME: FnType [Cost::texels(4)] = ...`.
macro_rules! stage {
    ($($(#[$meta:meta])* $vis:vis fn $name:ident: $f:ty $([$cost:expr])? = ($($arg:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? $body:block)*) => {$(
        $(#[$meta])*
        $vis static $name: $crate::simd::Stage<$f> = {
            #[inline(always)]
            fn body($($arg: $ty),*) $(-> $ret)? $body
            #[cfg(not(all(target_arch = "x86_64", any(fixedgl_only_avx2, fixedgl_only_avx512))))]
            fn baseline($($arg: $ty),*) $(-> $ret)? { body($($arg),*) }
            #[cfg(all(target_arch = "x86_64", not(fixedgl_only_avx512)))]
            #[target_feature(enable = "avx2,bmi1,bmi2,popcnt,lzcnt")]
            fn avx2($($arg: $ty),*) $(-> $ret)? { body($($arg),*) }
            #[cfg(all(target_arch = "x86_64", not(fixedgl_only_avx2)))]
            #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx512cd,avx2,bmi1,bmi2,popcnt,lzcnt")]
            fn avx512($($arg: $ty),*) $(-> $ret)? { body($($arg),*) }
            #[cfg(not(target_arch = "x86_64"))]
            use {baseline as avx2, baseline as avx512};
            #[cfg(all(target_arch = "x86_64", fixedgl_only_avx2))]
            use {avx2 as baseline, avx2 as avx512};
            #[cfg(all(target_arch = "x86_64", fixedgl_only_avx512))]
            use {avx512 as baseline, avx512 as avx2};
            #[allow(unused_assignments, unused_mut, reason = "a stage that says nothing costs nothing")]
            static INFO: $crate::simd::StageInfo = {
                let mut cost = $crate::simd::Cost::NONE;
                $( cost = $cost; )?
                $crate::simd::StageInfo { name: stringify!($name), cost }
            };
            $crate::simd::Stage::new(&INFO, [baseline, avx2, avx512])
        };
    )*};
}
pub(crate) use stage;

#[cfg(test)]
mod tests {
    use super::super::LANES;
    use super::*;

    type TestFn = for<'a> unsafe fn(&mut [f32; LANES], &'a [f32], u32);

    stage! {
        /// Adds.
        fn ADD: TestFn [Cost::texels(2)] = (b: &mut [f32; LANES], u: &[f32], arg: u32) {
            let k = u.get(arg as usize).copied().unwrap_or(0.0);
            for lane in b.iter_mut() { *lane += k; }
        }

        /// Does the same under another name.
        fn ADD_AGAIN: TestFn [Cost::texels(2)] = (b: &mut [f32; LANES], u: &[f32], arg: u32) {
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
                    (step.run())(&mut batch, &[5.0, 2.0], step.arg);
                }
            }
            assert_eq!(batch, [3.0; LANES]);
        }
    }

    #[test]
    fn a_step_knows_its_stage() {
        let step = ADD.step(Level::BASELINE, 0);
        assert!(step.is(&ADD) && !step.is(&ADD_AGAIN));
        assert_eq!((step.id.name(), step.id.cost().texels), ("ADD", 2));
    }
}
