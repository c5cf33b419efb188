//! Numeric functions that give the same bits everywhere (spec-notes/exactness.md).
//!
//! The specification asks for about one part in 10^5 of accuracy (section 2.1.1); this library asks for more: the same
//! bytes on every processor. So nothing here comes from the platform's maths library, nothing contracts `a * b + c`,
//! and only the operations that IEEE 754 defines to the last bit are used: `+ - * /`, square root, comparisons and
//! integer arithmetic on the bits of a number.
//!
//! Two kinds live here. The `f32` functions are *lane functions*: no branch, no call, no saturating cast, so that a loop
//! of them over a batch becomes SIMD code at every level. The `f64` functions serve what is computed once a command:
//! matrices, quadrics, tables.

pub mod bernstein;
mod bytes;
mod exp_log;
mod exp_log64;
mod round;
mod trig;
mod unorm;

pub use bytes::{Scalar, as_bytes, as_bytes_mut};
pub use exp_log::{exp_f32, log2_f32, pow_f32};
pub use exp_log64::exp2;
pub use round::{MAGIC_F64, floor_f32, floor_f64_to_int, floor_to_int, round_f32, round_f64, round_to_int};
pub use trig::{cos, sin, sin_cos, sin_cos_deg, tan};
pub use unorm::{
    f32_to_snorm, f32_to_u8, f32_to_u16, f32_to_unorm, f64_to_snorm, f64_to_unorm, i8_to_f32, i16_to_f32, snorm_to_f32,
    u8_to_f32, u16_to_f32, unorm_to_f32,
};

/// The larger of two numbers; `b` when `a` is NaN. One `maxps`.
#[inline(always)]
#[must_use]
pub fn max_f32(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller of two numbers; `b` when `a` is NaN. One `minps`.
#[inline(always)]
#[must_use]
pub fn min_f32(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// A number limited to `lo..=hi`; NaN gives `lo`. Where `lo > hi` the result is `hi`.
#[inline(always)]
#[must_use]
pub fn clamp_f32(x: f32, lo: f32, hi: f32) -> f32 {
    min_f32(max_f32(x, lo), hi)
}

/// A number limited to 0..=1; NaN and -0 give +0.
#[inline(always)]
#[must_use]
pub fn clamp01(x: f32) -> f32 {
    clamp_f32(x, 0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clamp01_is_total() {
        for (x, want) in [
            (f32::NAN, 0.0f32),
            (-f32::NAN, 0.0),
            (f32::INFINITY, 1.0),
            (f32::NEG_INFINITY, 0.0),
            (-0.0, 0.0),
            (0.25, 0.25),
            (1.5, 1.0),
        ] {
            assert_eq!(clamp01(x).to_bits(), want.to_bits(), "clamp01({x})");
        }
    }
}
