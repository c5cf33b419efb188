//! Which instruction set the stages run on. Picked once when a context is made, from what the processor has; the
//! environment variable `FIXEDGL_SIMD` (`baseline`, `avx2` or `avx512`) picks a lower one, never one that is missing.

use std::sync::OnceLock;

/// An instruction set that every stage is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum SimdLevel {
    /// What every processor of the target has (SSE2 on x86-64).
    Baseline = 0,
    /// AVX2 with the bit manipulation sets that came with it.
    Avx2 = 1,
    /// AVX-512 F, BW, DQ, VL and CD.
    Avx512 = 2,
}

impl SimdLevel {
    /// All levels, lowest first.
    pub(crate) const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The highest level that this processor has.
    #[must_use]
    pub fn detect() -> Self {
        // Each row of an upload asks.
        static TOP: OnceLock<SimdLevel> = OnceLock::new();
        *TOP.get_or_init(Self::look)
    }

    fn look() -> Self {
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
                (_, true) => Self::Avx512,
                (true, _) => Self::Avx2,
                _ => Self::Baseline,
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        Self::Baseline
    }

    /// The levels that this processor has.
    pub fn available() -> impl Iterator<Item = Self> {
        let top = Self::detect();
        Self::ALL.into_iter().filter(move |level| *level <= top)
    }

    /// The level of this name, as `FIXEDGL_SIMD` spells it.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "baseline" => Some(Self::Baseline),
            "avx2" => Some(Self::Avx2),
            "avx512" => Some(Self::Avx512),
            _ => None,
        }
    }

    /// This level, or the highest that the processor has where that is lower.
    #[must_use]
    pub fn at_most_available(self) -> Self {
        self.min(Self::detect())
    }
}
