//! Numbers as fractions: unsigned and signed normalised integers and back (section 2.14.9, table 2.9).
//!
//! An unsigned `n`-bit colour `c` stands for `c / (2^n - 1)`, a signed one for `(2c + 1) / (2^n - 1)` as GL 1.x has it.
//! Both are computed as the division that they are. Back, the fraction is limited to its range, scaled and rounded to
//! the nearest integer (ties to even): `u8 -> f32 -> u8` gives every value back, and so does every other width to 24 bits.

use super::clamp01;

/// `c / 255`.
#[inline(always)]
#[must_use]
pub fn u8_to_f32(c: u8) -> f32 {
    f32::from(c) / 255.0
}

/// `c / 65535`.
#[inline(always)]
#[must_use]
pub fn u16_to_f32(c: u16) -> f32 {
    f32::from(c) / 65535.0
}

/// The nearest of 0..=255 to `v * 255`; below 0 and NaN give 0, above 1 gives 255.
#[inline(always)]
#[must_use]
pub fn f32_to_u8(v: f32) -> u8 {
    super::round_to_int(clamp01(v) * 255.0) as u8
}

/// The nearest of 0..=65535 to `v * 65535`; below 0 and NaN give 0, above 1 gives 65535.
#[inline(always)]
#[must_use]
pub fn f32_to_u16(v: f32) -> u16 {
    super::round_to_int(clamp01(v) * 65535.0) as u16
}

/// The largest value of `bits` bits (1..=32; other widths count as the nearest of these).
#[inline(always)]
fn largest(bits: u32) -> u32 {
    u32::MAX >> (32 - bits.clamp(1, 32))
}

/// `c / (2^bits - 1)` for 1..=32 bits, rounded once.
#[inline(always)]
#[must_use]
pub fn unorm_to_f32(c: u32, bits: u32) -> f32 {
    (f64::from(c) / f64::from(largest(bits))) as f32
}

/// The nearest of 0..=2^bits - 1 to `v * (2^bits - 1)` for 1..=32 bits; below 0 and NaN give 0, above 1 the largest.
#[inline(always)]
#[must_use]
pub fn f32_to_unorm(v: f32, bits: u32) -> u32 {
    nearest_unorm(f64::from(clamp01(v)), bits)
}

/// The same for an f64, which holds every fraction of 32 bits.
#[inline(always)]
#[must_use]
pub fn f64_to_unorm(v: f64, bits: u32) -> u32 {
    nearest_unorm(if v > 0.0 { v.min(1.0) } else { 0.0 }, bits)
}

#[inline(always)]
fn nearest_unorm(v: f64, bits: u32) -> u32 {
    // 2^52 pushes the fraction out; the low half of the mantissa is then the integer.
    (v * f64::from(largest(bits)) + 4_503_599_627_370_496.0).to_bits() as u32
}

/// `(2c + 1) / 255`: a signed byte as a colour or normal component.
#[inline(always)]
#[must_use]
pub fn i8_to_f32(c: i8) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 255.0
}

/// `(2c + 1) / 65535`: a signed short as a colour or normal component.
#[inline(always)]
#[must_use]
pub fn i16_to_f32(c: i16) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 65535.0
}

/// `(2c + 1) / (2^bits - 1)` for 1..=32 bits, rounded once.
#[inline(always)]
#[must_use]
pub fn snorm_to_f32(c: i32, bits: u32) -> f32 {
    ((2.0 * f64::from(c) + 1.0) / f64::from(largest(bits))) as f32
}

/// The nearest integer to `((2^bits - 1) v - 1) / 2`, the inverse of [`snorm_to_f32`] (table 4.9): `v` is limited to
/// -1..=1 first, NaN gives the smallest.
#[inline(always)]
#[must_use]
pub fn f32_to_snorm(v: f32, bits: u32) -> i32 {
    nearest_snorm(f64::from(super::clamp_f32(v, -1.0, 1.0)), bits)
}

/// The same for an f64.
#[inline(always)]
#[must_use]
pub fn f64_to_snorm(v: f64, bits: u32) -> i32 {
    nearest_snorm(if v > -1.0 { v.min(1.0) } else { -1.0 }, bits)
}

#[inline(always)]
fn nearest_snorm(v: f64, bits: u32) -> i32 {
    // The low half of the sum's mantissa is the integer in two's complement.
    let x = (f64::from(largest(bits)) * v - 1.0) * 0.5 + super::MAGIC_F64;
    x.to_bits() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back() {
        for c in 0..=255u8 {
            assert_eq!(u8_to_f32(c).to_bits(), (f32::from(c) / 255.0).to_bits());
            assert_eq!(f32_to_u8(u8_to_f32(c)), c);
            assert_eq!(unorm_to_f32(u32::from(c), 8), u8_to_f32(c));
            assert_eq!(f32_to_snorm(i8_to_f32(c as i8), 8), i32::from(c as i8));
        }
        for c in 0..=65535u16 {
            assert_eq!(f32_to_u16(u16_to_f32(c)), c);
            assert_eq!(unorm_to_f32(u32::from(c), 16), u16_to_f32(c));
            assert_eq!(f32_to_snorm(i16_to_f32(c as i16), 16), i32::from(c as i16));
        }
    }

    #[test]
    fn every_width_comes_back() {
        for bits in 1..=24 {
            let most = largest(bits);
            for i in 0..=4096u64 {
                let c = (u64::from(most) * i / 4096) as u32;
                assert_eq!(f32_to_unorm(unorm_to_f32(c, bits), bits), c, "{c} of {bits} bits");
            }
        }
        assert_eq!(f32_to_unorm(1.0, 32), u32::MAX);
        assert_eq!(f32_to_unorm(0.5, 32), 0x8000_0000);
        assert_eq!(f32_to_snorm(1.0, 32), i32::MAX);
        assert_eq!(f32_to_snorm(-1.0, 32), i32::MIN);
    }

    #[test]
    fn rounding_is_to_the_nearest_and_limits_hold() {
        for i in 0..=100_000 {
            let v = i as f32 / 100_000.0;
            assert_eq!(f32_to_u8(v), (v * 255.0).round_ties_even() as u8, "{v}");
        }
        for (v, want) in
            [(f32::NAN, 0), (-1.0, 0), (2.0, 255), (f32::INFINITY, 255), (f32::NEG_INFINITY, 0), (0.5, 128)]
        {
            assert_eq!(f32_to_u8(v), want, "{v}");
            assert_eq!(f32_to_unorm(v, 8), u32::from(want), "{v}");
        }
        assert_eq!(f32_to_u16(f32::NAN), 0);
        assert_eq!(f32_to_snorm(f32::NAN, 8), -128);
    }
}
