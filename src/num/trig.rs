//! `f64` circular functions: rotations, projections, quadrics.
//!
//! GL takes degrees, so the degree form is the exact one: the multiple of 90 is removed before pi comes in, and every
//! multiple of 90 gives 0, 1 or -1 exactly. Radians are reduced by pi/2 in three parts. What is left is the Taylor
//! series on -pi/4..pi/4.

use super::exp_log64::nearest;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

/// sqrt(3)/2.
const HALF_SQRT_3: f64 = 0.866_025_403_784_438_6;
/// pi/2 in three parts: the first two have at most 33 bits, so that a quadrant below 2^20 times them is exact.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_503_593_46e-11, 2.912_732_056_093_356e-20];

/// The sine and cosine of `r` in -pi/4..pi/4.
fn series(r: f64) -> (f64, f64) {
    let z = r * r;
    // Coefficients of the series: (-1)^k / (2k+1)! and (-1)^k / (2k)!.
    const SIN: [f64; 8] = taylor::<8>(3);
    const COS: [f64; 8] = taylor::<8>(2);
    let sin = r + r * z * SIN.iter().rev().fold(0.0, |p, c| p * z + c);
    let cos = 1.0 + z * COS.iter().rev().fold(0.0, |p, c| p * z + c);
    (sin, cos)
}

/// A sine and a cosine turned by `quadrant` right angles.
fn turned((sin, cos): (f64, f64), quadrant: i64) -> (f64, f64) {
    match quadrant.rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// -1/first!, 1/(first+2)!, -1/(first+4)!, ...
const fn taylor<const N: usize>(first: u32) -> [f64; N] {
    let mut table = [0.0; N];
    let mut factorial = 1.0;
    let (mut i, mut k) = (1, 0);
    while k < N {
        while i <= first + 2 * k as u32 {
            factorial *= i as f64;
            i += 1;
        }
        table[k] = if k % 2 == 0 { -1.0 } else { 1.0 } / factorial;
        k += 1;
    }
    table
}

/// The sine and the cosine of an angle in radians: within 3e-16 up to |x| = 1e6, slowly worse beyond (the reduction
/// error grows with x * 1e-26); NaN for NaN and infinities.
#[must_use]
pub fn sin_cos(x: f64) -> (f64, f64) {
    if !x.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    // Beyond 2^50 a unit in the last place is a good part of a turn: the angle has no meaning left.
    let x = if x.abs() < 1_125_899_906_842_624.0 { x } else { x % (2.0 * PI) };
    let n = nearest(x / FRAC_PI_2);
    turned(series(((x - n * HALF_PI[0]) - n * HALF_PI[1]) - n * HALF_PI[2]), n as i64)
}

/// The sine of an angle in radians.
#[must_use]
pub fn sin(x: f64) -> f64 {
    sin_cos(x).0
}

/// The cosine of an angle in radians.
#[must_use]
pub fn cos(x: f64) -> f64 {
    sin_cos(x).1
}

/// The tangent of an angle in radians.
#[must_use]
pub fn tan(x: f64) -> f64 {
    let (sin, cos) = sin_cos(x);
    sin / cos
}

/// The sine and the cosine of an angle in degrees: 0, 1/2 and 1 exactly where they belong, sine and cosine
/// equal at 45, within 3e-16 everywhere (the reduction is exact for every finite number); NaN for NaN and infinities.
#[must_use]
pub fn sin_cos_deg(degrees: f64) -> (f64, f64) {
    if !degrees.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    // The remainder is exact by IEEE 754, whoever computes it.
    let d = degrees % 360.0;
    let n = nearest(d / 90.0);
    let r = d - n * 90.0;
    // Multiples of 30 and 45 degrees, which programs use most, are exact: 1/2, and equal sine and cosine.
    let rest = match r.abs() {
        30.0 => (0.5f64.copysign(r), HALF_SQRT_3),
        45.0 => (FRAC_1_SQRT_2.copysign(r), FRAC_1_SQRT_2),
        _ => series(r * (PI / 180.0)),
    };
    turned(rest, n as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_are_exact_at_right_angles() {
        for n in -4000i32..4000 {
            let want = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
            assert_eq!(Some(&sin_cos_deg(f64::from(n) * 90.0)), want.get(n.rem_euclid(4) as usize));
        }
        assert_eq!(sin_cos_deg(360.0 * 2f64.powi(80)), (0.0, 1.0));
        for (d, sin, cos) in [(30.0, 0.5, HALF_SQRT_3), (60.0, HALF_SQRT_3, 0.5), (-210.0, 0.5, -HALF_SQRT_3)] {
            assert_eq!(sin_cos_deg(d), (sin, cos));
            assert!((sin_cos(d.to_radians()).0 - sin).abs() < 3e-16 && (sin_cos(d.to_radians()).1 - cos).abs() < 3e-16);
        }
        assert_eq!(sin_cos_deg(405.0), (FRAC_1_SQRT_2, FRAC_1_SQRT_2));
        assert_eq!(sin_cos_deg(-45.0), (-FRAC_1_SQRT_2, FRAC_1_SQRT_2));
        assert!(sin_cos_deg(f64::INFINITY).0.is_nan());
    }

    #[test]
    fn sines_and_cosines_are_good_to_the_last_places() {
        let (mut worst, mut worst_big, mut worst_deg) = (0.0f64, 0.0f64, 0.0f64);
        for i in -400_000..400_000 {
            let x = f64::from(i) * 1.3e-4;
            let big = f64::from(i) * 2.5;
            worst = worst.max((sin(x) - x.sin()).abs()).max((cos(x) - x.cos()).abs());
            worst_big = worst_big.max((sin(big) - big.sin()).abs()).max((cos(big) - big.cos()).abs());
            // A whole turn more must change nothing, and small angles agree with the radian form.
            let d = f64::from(i) * 0.125;
            let (s, c) = sin_cos_deg(d);
            let small = (d % 360.0).to_radians();
            worst_deg = worst_deg.max((s - small.sin()).abs() - small.abs() * 2.3e-16);
            worst_deg = worst_deg.max((c - small.cos()).abs() - small.abs() * 2.3e-16);
            assert_eq!(sin_cos_deg(d + 360.0 * 2_000_000.0), (s, c));
        }
        println!("sin, cos: {worst:.2e} below 52, {worst_big:.2e} below 1e6; degrees {worst_deg:.2e} (absolute)");
        assert!(worst < 4e-16 && worst_big < 4e-16 && worst_deg < 1e-15);
        let tangent =
            (-150..150).map(|i| f64::from(i) * 0.01).fold(0.0f64, |w, x| w.max((tan(x) / x.tan() - 1.0).abs()));
        assert!(tangent < 1e-15, "tan {tangent:e}");
    }
}
