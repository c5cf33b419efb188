//! Which instruction set the stages run on. Picked once when a context is made, from what the processor has; the
//! environment variable `FIXEDGL_SIMD` (`baseline`, `avx2` or `avx512`) picks a lower one, never one that is missing.

use std::fmt;
use std::sync::OnceLock;

/// An instruction set that the processor has. Only this file makes one, from what was detected, so that holding one is
/// the proof that code compiled for it may run: `available()` has all of them, `detect()` the highest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct SimdLevel(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Set {
    /// What every processor of the target has (SSE2 on x86-64).
    Baseline = 0,
    /// AVX2 with the bit manipulation sets that came with it.
    Avx2 = 1,
    /// AVX-512 F, BW, DQ, VL and CD.
    Avx512 = 2,
}

impl SimdLevel {
    /// What every processor of the target has: SSE2 on x86-64.
    pub const BASELINE: Self = Self(Set::Baseline);

    /// The highest level that this processor has.
    #[must_use]
    pub fn detect() -> Self {
        // Each row of an upload asks.
        static TOP: OnceLock<SimdLevel> = OnceLock::new();
        *TOP.get_or_init(|| Self(Self::look()))
    }

    fn look() -> Set {
        #[cfg(target_arch = "x86_64")]
        {
            let bits = is_x86_feature_detected!("bmi1")
                && is_x86_feature_detected!("bmi2")
                && is_x86_feature_detected!("popcnt")
                && is_x86_feature_detected!("lzcnt");
            let avx2 = bits && is_x86_feature_detected!("avx2");
            let avx512 = avx2
                && is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512bw")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512cd");
            match (avx2, avx512) {
                (_, true) => Set::Avx512,
                (true, _) => Set::Avx2,
                _ => Set::Baseline,
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        Set::Baseline
    }

    /// The levels that this processor has, lowest first.
    pub fn available() -> impl Iterator<Item = Self> {
        let top = Self::detect();
        [Set::Baseline, Set::Avx2, Set::Avx512].into_iter().map(Self).filter(move |level| *level <= top)
    }

    /// The level of this name, as `FIXEDGL_SIMD` spells it: `baseline`, `avx2` or `avx512`. Where the processor lacks it,
    /// the highest that it has. `None` if there is no such name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let set = match name {
            "baseline" => Set::Baseline,
            "avx2" => Set::Avx2,
            "avx512" => Set::Avx512,
            _ => return None,
        };
        Some(Self(set).min(Self::detect()))
    }

    /// Its name, as `FIXEDGL_SIMD` spells it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self.0 {
            Set::Baseline => "baseline",
            Set::Avx2 => "avx2",
            Set::Avx512 => "avx512",
        }
    }

    /// Its place among the functions of a stage.
    pub(super) const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Debug for SimdLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::{Set, SimdLevel};

    #[test]
    fn a_level_is_never_above_what_the_processor_has() {
        let top = SimdLevel::detect();
        for name in ["baseline", "avx2", "avx512"] {
            let level = SimdLevel::from_name(name).expect("a name");
            assert!(level <= top && (level.name() == name || level == top), "{name}");
        }
        assert_eq!(SimdLevel::from_name("AVX2"), None);
        assert!(SimdLevel::available().all(|level| level <= top) && SimdLevel::available().any(|level| level == top));
        assert!(Set::Baseline < Set::Avx2 && Set::Avx2 < Set::Avx512);
    }
}
