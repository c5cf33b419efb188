//! Levels of detail without a logarithm (OpenGL 1.5, section 3.8.8): for each mipmap level the squares of rho with which it
//! is certainly the one that is read, or certainly blended with the next one. Lambda as it is computed is within 2^-14 of
//! the true one, and the ranges keep a distance of 2^-11 from its steps: what lies in a range cannot come to another level.

use super::batch::TexBatch;
use super::uniforms::SamplerUniforms;
use crate::num::{clamp_f32, floor_f32, log2_f32};

/// For each level of *_MIPMAP_NEAREST from which rho squared on, and up to which, it is certainly the one to be read. The
/// computed lambda is within 2^-14 of lambda; these ranges keep a distance of 2^-11 from its steps, so no lane that is
/// within a range can come to another level.
#[must_use]
pub fn level_ranges(bias: f32, min_lod: f32, max_lod: f32, last: f32) -> Vec<[f32; 2]> {
    if min_lod.is_nan() || max_lod.is_nan() {
        return Vec::new();
    }
    let level = |lambda: f32| (-floor_f32(-clamp_f32(lambda - 0.5, 0.0, last))) as i32;
    let (least, greatest) = (level(min_lod), level(if max_lod > min_lod { max_lod } else { min_lod }));
    let rho2 = |step: i32, off: f64| crate::num::exp2(2.0 * (f64::from(step) - 0.5 - f64::from(bias) + off)) as f32;
    (0..=last as i32)
        .map(|n| match (n < least, n > greatest) {
            (false, false) => {
                let from = if n == least { 0.0 } else { rho2(n, OFF) };
                [from, if n == greatest { f32::INFINITY } else { rho2(n + 1, -OFF) }]
            }
            _ => [f32::INFINITY, 0.0],
        })
        .collect()
}

/// The levels of a filter of mipmaps, for which limits of rho may be enough.
#[derive(Clone, Debug)]
pub struct RhoRanges {
    /// Texels of the base level per unit of the coordinates; 0 for those that address no texels.
    pub scale: [f64; 3],
    /// What is added to lambda.
    pub bias: f32,
    /// For each level the squares of rho with which it is certainly the only one to be read.
    ranges: Vec<[f32; 2]>,
    /// For each level those with which it is certainly blended with the next one, by a lambda that no limit touches.
    pairs: Vec<[f32; 2]>,
    /// Whether two levels may be blended.
    pub blends: bool,
}

impl RhoRanges {
    /// Those of *_MIPMAP_NEAREST or, if it `blends`, of *_MIPMAP_LINEAR, whose levels stand alone only at both ends.
    #[must_use]
    pub fn new(u: &SamplerUniforms, dims: usize, blends: bool) -> Self {
        let ranges = if blends { end_ranges(u.bias, u.min_lod, u.max_lod, u.last) } else { u.level_ranges.clone() };
        let pairs = if blends { pair_ranges(u.bias, u.min_lod, u.max_lod, u.last) } else { Vec::new() };
        let scale = std::array::from_fn(|c| if c < dims { f64::from(u.scale[c]) } else { 0.0 });
        Self { scale, bias: u.bias, ranges, pairs, blends }
    }

    /// What is read with one square of rho, as fragments compute it: a level, and how much of the next one if the two are
    /// blended. `None` where that is not so simple.
    #[must_use]
    pub fn exactly(&self, rho2: f32) -> Option<(u32, Option<f32>)> {
        let lambda = 0.5 * log2_f32(rho2) + self.bias;
        if !self.blends || !lambda.is_finite() {
            return None;
        }
        if lambda <= 0.0 {
            return self.ranges.first().is_some_and(|[_, end]| *end > 0.0).then_some((0, None));
        }
        let level = lambda as usize;
        self.pairs.get(level).is_some_and(|[from, to]| from < to).then_some((level as u32, Some(lambda - level as f32)))
    }

    /// The first of the two levels that are blended with squares of rho in these limits.
    #[inline(always)]
    #[must_use]
    pub fn first_of_two(&self, [least, greatest]: [f64; 2]) -> Option<u32> {
        let within = |[from, to]: &[f32; 2]| least >= f64::from(*from) && greatest < f64::from(*to);
        self.pairs.iter().position(within).map(|level| level as u32)
    }

    /// The only level that is read with squares of rho in these limits. As a rule it is that of the batch before.
    #[inline(always)]
    #[must_use]
    pub fn only(&self, b: &TexBatch, [least, greatest]: [f64; 2]) -> Option<u32> {
        // Beyond, f32 might come to infinity.
        const FINITE: f64 = 1e30;
        let within = |[from, to]: &[f32; 2]| least >= f64::from(*from) && greatest < f64::from(*to);
        let before = b.scratch.same[0].unwrap_or(0);
        if !(greatest < FINITE) {
            None
        } else if self.ranges.get(before).is_some_and(within) {
            Some(before as u32)
        } else {
            self.ranges.iter().position(within).map(|level| level as u32)
        }
    }
}

/// [`level_ranges`] of *_MIPMAP_LINEAR: the base level alone where lambda is certainly below 0, the last one where it is
/// certainly above it.
fn end_ranges(bias: f32, min_lod: f32, max_lod: f32, last: f32) -> Vec<[f32; 2]> {
    if min_lod.is_nan() || max_lod.is_nan() {
        return Vec::new();
    }
    let mut ranges = vec![[f32::INFINITY, 0.0]; last as usize + 1];
    let rho2 = |lambda: f32, off: f64| crate::num::exp2(2.0 * (f64::from(lambda) - f64::from(bias) + off)) as f32;
    if max_lod >= last
        && let Some(range) = ranges.last_mut()
    {
        *range = [rho2(last, OFF), f32::INFINITY];
    }
    if min_lod <= 0.0
        && let Some(range) = ranges.first_mut()
    {
        *range = [0.0, rho2(0.0, -OFF)];
    }
    ranges
}

/// For each level but the last the squares of rho of which lambda is certainly between it and the next one.
fn pair_ranges(bias: f32, min_lod: f32, max_lod: f32, last: f32) -> Vec<[f32; 2]> {
    let rho2 = |lambda: f32, off: f64| crate::num::exp2(2.0 * (f64::from(lambda) - f64::from(bias) + off)) as f32;
    let range = |level: f32| match min_lod <= level && max_lod >= level + 1.0 {
        true => [rho2(level, OFF), rho2(level + 1.0, -OFF)],
        false => [f32::INFINITY, 0.0],
    };
    (0..last as i32).map(|level| range(level as f32)).collect()
}

/// The distance in lambda that ranges keep from its steps.
const OFF: f64 = 1.0 / 2048.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::{max_f32, min_f32};

    #[test]
    fn a_range_holds_its_level_only() {
        for (bias, min, max, last) in [
            (0.0, -1000.0, 1000.0, 10.0f32),
            (0.7, -1000.0, 1000.0, 10.0),
            (-3.2, 0.3, 4.4, 10.0),
            (0.0, 2.5, 2.6, 3.0),
        ] {
            let ranges = level_ranges(bias, min, max, last);
            assert_eq!(ranges.len(), last as usize + 1);
            let mut inside = 0;
            for bits in (0..0x7f80_0000u32).step_by(1009) {
                let rho2 = f32::from_bits(bits);
                let lambda = max_f32(min_f32(0.5 * log2_f32(rho2) + bias, max), min);
                let level = -floor_f32(-clamp_f32(lambda - 0.5, 0.0, last));
                for (n, [from, to]) in ranges.iter().enumerate() {
                    if (*from..*to).contains(&rho2) {
                        assert_eq!(level, n as f32, "{rho2:e} with bias {bias}");
                        inside += 1;
                    }
                }
            }
            assert!(inside > 2_000_000, "nearly every rho is in a range: {inside}");
        }
        assert!(level_ranges(0.0, f32::NAN, 1.0, 5.0).is_empty());
    }

    #[test]
    fn a_pair_is_blended_by_the_fraction_alone() {
        for (bias, min, max, last) in [(0.0, -1000.0, 1000.0, 10.0f32), (-3.2, 0.3, 4.4, 10.0)] {
            let pairs = pair_ranges(bias, min, max, last);
            let mut inside = 0;
            for bits in (0..0x7f80_0000u32).step_by(1009) {
                let rho2 = f32::from_bits(bits);
                let free = 0.5 * log2_f32(rho2) + bias;
                let l = clamp_f32(max_f32(min_f32(free, max), min), 0.0, last);
                for (n, _) in pairs.iter().enumerate().filter(|(_, [from, to])| (*from..*to).contains(&rho2)) {
                    assert_eq!((floor_f32(l), l), (n as f32, free), "{rho2:e} with bias {bias}");
                    inside += 1;
                }
            }
            assert!(inside > 40_000, "{inside}");
        }
    }
}
