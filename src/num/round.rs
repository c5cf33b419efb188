//! Rounding `f32` to whole numbers without a call and without a saturating cast.
//!
//! `f32::floor` is a library call at SSE2, and `f32 as i32` saturates, which costs several instructions a lane. Adding
//! 1.5 * 2^23 instead pushes the fraction out of the mantissa: the sum is rounded to the nearest whole number by the
//! adder, and its low bits are that number as an integer. That holds while |x| < 2^22, which texel and pixel
//! coordinates are after they have been brought into range.

/// 1.5 * 2^23: a float whose unit in the last place is 1, with room on both sides.
const MAGIC: f32 = 12_582_912.0;
/// 1.5 * 2^52, the same of an `f64`: what is added to it is rounded to the nearest whole number, ties to even, for numbers
/// below 2^51; the low half of the sum's bits is that number.
pub const MAGIC_F64: f64 = 6_755_399_441_055_744.0;

/// The nearest whole number, ties to even, for |x| < 2^51.
#[inline(always)]
#[must_use]
pub fn round_f64(x: f64) -> f64 {
    (x + MAGIC_F64) - MAGIC_F64
}

/// The nearest whole number, ties to even. Exact for |x| <= 2^22; beyond that within one part in 2^23 of `x`.
/// NaN stays NaN and infinities stay infinite.
#[inline(always)]
#[must_use]
pub fn round_f32(x: f32) -> f32 {
    (x + MAGIC) - MAGIC
}

/// The nearest whole number as an integer, ties to even, for |x| <= 2^22. Beyond that, and for NaN and infinities, some
/// integer: the same one everywhere for finite numbers, but of no meaning, so limit `x` first.
#[inline(always)]
#[must_use]
pub fn round_to_int(x: f32) -> i32 {
    ((x + MAGIC).to_bits() as i32).wrapping_sub(MAGIC.to_bits() as i32)
}

/// The largest whole number that is not above `x`. Exact for |x| < 2^22; beyond that within two units (of 1 or of `x`'s
/// last place, whichever is larger) of `x`, and not always whole until 2^23. NaN stays NaN, infinities infinite.
#[inline(always)]
#[must_use]
pub fn floor_f32(x: f32) -> f32 {
    let r = round_f32(x);
    r - if r > x { 1.0 } else { 0.0 }
}

/// [`floor_f32`] as an integer, for |x| < 2^22; the remark at [`round_to_int`] holds beyond.
#[inline(always)]
#[must_use]
pub fn floor_to_int(x: f32) -> i32 {
    let biased = x + MAGIC;
    let down = (biased - MAGIC > x) as i32;
    (biased.to_bits() as i32).wrapping_sub(MAGIC.to_bits() as i32).wrapping_sub(down)
}

/// The greatest whole number that is not greater, for any number: the nearest `i32` beyond their range, 0 for NaN.
#[inline]
#[must_use]
pub fn floor_f64_to_int(x: f64) -> i32 {
    let n = x as i32;
    n.saturating_sub(i32::from(f64::from(n) > x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of every size and both signs, with the neighbours of whole numbers and halves.
    fn samples() -> impl Iterator<Item = f32> {
        let grid = (0..=0x7f80u32).map(|i| f32::from_bits(i << 16));
        let near = (-4000i32..4000).flat_map(|i| {
            let x = i as f32 * 0.5;
            [x.next_down(), x, x.next_up()]
        });
        let limit = (-9i32..9).map(|i| 4_194_304.0 + i as f32 * 0.5);
        grid.chain(near).chain(limit).flat_map(|x| [x, -x])
    }

    #[test]
    fn floors_and_roundings_are_exact_in_their_range() {
        let mut n = 0;
        for x in samples().filter(|x| x.abs() < 4_194_304.0) {
            assert_eq!(floor_f32(x), x.floor(), "floor {x}");
            assert_eq!(floor_to_int(x), x.floor() as i32, "floor_to_int {x}");
            assert_eq!(round_f32(x), x.round_ties_even(), "round {x}");
            assert_eq!(round_to_int(x), x.round_ties_even() as i32, "round_to_int {x}");
            n += 1;
        }
        assert!(n > 40_000, "only {n} samples were in range");
    }

    #[test]
    fn the_floor_of_an_f64_is_exact_everywhere() {
        let beyond = [f64::MAX, f64::INFINITY, f64::NAN, 2_147_483_647.5, -2_147_483_648.5, 0.1 + 0.2];
        for x in samples().map(f64::from).chain(beyond) {
            assert_eq!(floor_f64_to_int(x), x.floor() as i32, "{x}");
            assert_eq!(floor_f64_to_int(-x), (-x).floor() as i32, "-{x}");
        }
    }

    #[test]
    fn beyond_the_range_nothing_explodes() {
        for x in samples() {
            let f = floor_f32(x);
            assert!(!x.is_finite() || (f - x).abs() <= 2.0f32.max(x.abs() * 2.4e-7), "floor {x} = {f}");
            let _ = (floor_to_int(x), round_to_int(x));
        }
        assert!(floor_f32(f32::NAN).is_nan());
        assert_eq!(floor_f32(f32::INFINITY), f32::INFINITY);
    }
}
