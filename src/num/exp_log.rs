//! Lane functions of the powers: `log2`, `exp`, `pow` in `f32`.
//!
//! A float is `m * 2^e`, so a logarithm is `e + log2 m` and a power of two puts its whole part back into the exponent
//! field; what is left is a short series on a small interval. Used by level of detail (section 3.8.8), fog (3.10) and
//! the specular and spot exponents of lighting (2.14.1). Every function is total: whatever comes in, a number comes out.

use super::MAGIC_F64 as MAGIC;
use super::exp_log64::{LN2, atanh_series};
use super::{clamp_f32, max_f32, min_f32};

/// Bits of sqrt(1/2): splits the mantissas so that `m` lies in sqrt(1/2)..sqrt(2) and `log2 m` is small on both sides.
const SQRT_HALF: i32 = 0x3f35_04f3;

/// The base-2 logarithm. Within 1e-6 (plus the rounding of the result to `f32`) for every positive normal number, and
/// exact at powers of two. Denormals give a value between -127 and -126, 0, negative numbers and NaN give -127, infinity
/// gives 128: the result is always finite.
#[inline(always)]
#[must_use]
pub fn log2_f32(x: f32) -> f32 {
    let bits = if x > 0.0 { x.to_bits() as i32 } else { 0 };
    let e = bits.wrapping_sub(SQRT_HALF) >> 23;
    let m = f32::from_bits(bits.wrapping_sub(e << 23) as u32);
    // log2 m = 2/ln 2 * atanh s with s = (m-1)/(m+1), |s| <= 0.1716: the terms up to s^7 leave 4.1e-8.
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let p = 0.961_796_7 + z * (0.577_078_04 + z * 0.412_198_6);
    e as f32 + s * (2.885_39 + z * p)
}

/// 2 to the power `n`, built in the exponent field, for -126 <= n <= 127.
#[inline(always)]
fn power_of_two(n: i32) -> f32 {
    f32::from_bits((n.wrapping_add(127) << 23) as u32)
}

/// `p * 2^n` for -152 <= n <= 130 with one rounding, in two steps because the outer exponents have no factor of their
/// own; at most the largest finite number.
#[inline(always)]
fn scale(p: f32, n: i32) -> f32 {
    let half = n >> 1;
    min_f32(p * power_of_two(half) * power_of_two(n - half), f32::MAX)
}

/// e to the power `x`, within 2e-7 of the value. Below -104 it is 0, from 88.73 on `f32::MAX`; NaN gives 0.
#[inline(always)]
#[must_use]
pub fn exp_f32(x: f32) -> f32 {
    // ln 2 in two parts: the first has 16 bits, so that n times it is exact.
    const LN2_HIGH: f32 = 45_426.0 / 65_536.0;
    const LN2_LOW: f32 = 1.428_606_8e-6;
    let x = clamp_f32(x, -105.0, 89.0);
    let t = x * std::f32::consts::LOG2_E;
    let n = super::round_to_int(t);
    let n_float = super::round_f32(t);
    let r = (x - n_float * LN2_HIGH) - n_float * LN2_LOW;
    // The exponential series; what follows r^7/7! is below 6e-9.
    let q = 1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0));
    let q = 0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * q));
    scale(1.0 + (r + r * r * q), n)
}

/// `x` to the power `y` for `x >= 0`, within 1e-6 of the value (computed in `f64`, so that the large exponents of spot
/// lights and shininess lose nothing). As the specification asks, 0 to the power 0 is 1. Results too large are
/// `f32::MAX`; a negative or NaN `x` counts as 0, a NaN product as minus infinity.
#[inline(always)]
#[must_use]
pub fn pow_f32(x: f32, y: f32) -> f32 {
    let wide = f64::from(if x > 0.0 { x } else { 1.0 });
    let bits = wide.to_bits() as i64;
    // Bits of sqrt(1/2) as an f64; an f32 is never a denormal f64.
    let e = bits.wrapping_sub(0x3fe6_a09e_667f_3bcd) >> 52;
    let m = f64::from_bits(bits.wrapping_sub(e << 52) as u64);
    let f = m - 1.0;
    let s = f / (2.0 + f);
    // e is small: bring it to f64 by the magic sum, since SSE2 and AVX2 have no conversion of 64-bit integers.
    let e = f64::from_bits((e + MAGIC_BITS) as u64) - MAGIC;
    let log = e + atanh_series::<6>(s) * (1.0 / LN2);
    let t = f64::from(y) * log;
    let t = if t > -160.0 { t } else { -160.0 };
    let t = if t < 129.0 { t } else { 129.0 };
    let biased = t + MAGIC;
    let n = (biased.to_bits() as i64).wrapping_sub(MAGIC_BITS);
    let r = (t - (biased - MAGIC)) * LN2;
    let q = 1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0 + r * (1.0 / 40320.0)));
    let p = 1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * q))));
    let power = min_f32((p * f64::from_bits((n.wrapping_add(1023) << 52) as u64)) as f32, f32::MAX);
    let of_zero = if y == 0.0 {
        1.0
    } else if y < 0.0 {
        f32::MAX
    } else {
        0.0
    };
    if x > 0.0 { max_f32(power, 0.0) } else { of_zero }
}

const MAGIC_BITS: i64 = MAGIC.to_bits() as i64;

#[cfg(test)]
mod tests {
    use super::*;

    /// Every 97th positive normal number.
    fn normals() -> impl Iterator<Item = f32> {
        (0x0080_0000..0x7f80_0000u32).step_by(97).map(f32::from_bits)
    }

    #[test]
    fn log2_is_accurate_and_exact_at_powers_of_two() {
        let (mut worst, mut worst_near) = (0.0f64, 0.0f64);
        for x in normals() {
            let want = f64::from(x).log2();
            let err = (f64::from(log2_f32(x)) - want).abs();
            worst = worst.max(err - f64::from((want as f32).abs()) * 2f64.powi(-24));
            if want.abs() <= 8.0 {
                worst_near = worst_near.max(err);
            }
        }
        println!("log2_f32: worst error {worst:.3e} beyond the result's rounding, {worst_near:.3e} for 1/256..256");
        assert!(worst <= 1e-6, "{worst:e}");
        assert!(worst_near <= 1e-6, "{worst_near:e}");
        for e in -126..128 {
            assert_eq!(log2_f32(2f32.powi(e)), e as f32);
        }
        for x in [0.0, -0.0, -1.0, f32::NEG_INFINITY, f32::NAN, -f32::NAN] {
            assert_eq!(log2_f32(x), -127.0, "log2 {x}");
        }
        assert_eq!(log2_f32(f32::INFINITY), 128.0);
        assert!((-127.0..=-126.0).contains(&log2_f32(f32::from_bits(0x0040_0000))));
    }

    #[test]
    fn log2_never_falls() {
        let mut last = -127.0f32;
        for x in normals() {
            let y = log2_f32(x);
            // Neighbours may swap within the error; samples 97 apart far from 1 may not.
            assert!(y >= last - 3e-7f32.max(last.abs() * 1.2e-7), "log2 falls at {x}: {last} then {y}");
            last = y;
        }
    }

    /// The relative error of a result in f32, counting a denormal's last place as its unit.
    fn relative(got: f32, want: f64) -> f64 {
        (f64::from(got) - want).abs() / want.abs().max(f64::from(f32::MIN_POSITIVE))
    }

    #[test]
    fn the_exponential_is_accurate() {
        let mut worst = 0.0f64;
        for i in -1_040_000..887_000 {
            let x = i as f32 * 1e-4;
            worst = worst.max(relative(exp_f32(x), f64::from(x).exp()));
        }
        println!("exp_f32: worst relative error {worst:.3e}");
        assert!(worst <= 2e-7, "{worst:e}");
        assert_eq!(exp_f32(f32::NEG_INFINITY), 0.0);
        assert_eq!(exp_f32(-1e9), 0.0);
        assert_eq!(exp_f32(f32::NAN), 0.0);
        assert_eq!(exp_f32(0.0), 1.0);
        assert_eq!(exp_f32(f32::INFINITY), f32::MAX);
        assert_eq!(exp_f32(200.0), f32::MAX);
    }

    #[test]
    fn powers_are_accurate_for_shininess_and_spot() {
        let mut worst = 0.0f64;
        for i in 1..=2000 {
            let x = i as f32 / 2000.0;
            for j in 0..=512 {
                let y = j as f32 * 0.25;
                worst = worst.max(relative(pow_f32(x, y), f64::from(x).powf(f64::from(y))));
            }
        }
        println!("pow_f32: worst relative error {worst:.3e} for bases in (0, 1], exponents 0..=128");
        assert!(worst <= 1e-6, "{worst:e}");
        assert_eq!(pow_f32(0.0, 0.0), 1.0);
        assert_eq!(pow_f32(-3.0, 0.0), 1.0);
        assert_eq!(pow_f32(0.0, 5.0), 0.0);
        assert_eq!(pow_f32(0.0, -1.0), f32::MAX);
        assert_eq!(pow_f32(1.0, 128.0), 1.0);
        assert_eq!(pow_f32(0.5, 128.0), 2f32.powi(-64) * 2f32.powi(-64));
        assert_eq!(pow_f32(2.0, 10.0), 1024.0);
        assert_eq!(pow_f32(10.0, 128.0), f32::MAX);
        assert_eq!(pow_f32(1e-30, 128.0), 0.0);
        assert_eq!(pow_f32(f32::NAN, 2.0), 0.0);
        for (x, y) in [(f32::INFINITY, 1.0), (0.5, f32::NAN), (1.0, f32::INFINITY), (f32::NAN, f32::NAN)] {
            assert!(pow_f32(x, y).is_finite(), "pow({x}, {y})");
        }
    }
}
