//! `f64` powers of two, for limits that are computed once a command (level of detail), and the series that the lane
//! functions share.

/// The natural logarithm of 2.
pub(super) const LN2: f64 = std::f64::consts::LN_2;

/// `2 * atanh(s)`, the logarithm of (1+s)/(1-s), with `N` terms of the series 2 s (1 + s^2/3 + s^4/5 + ...).
#[inline(always)]
pub(super) fn atanh_series<const N: usize>(s: f64) -> f64 {
    let z = s * s;
    let mut p = 0.0;
    let mut k = N;
    while k > 1 {
        k -= 1;
        p = z * (p + 1.0 / (2 * k + 1) as f64);
    }
    2.0 * s + 2.0 * s * p
}

/// `p * 2^n` with one rounding, for |n| < 2100.
fn scale(p: f64, n: i64) -> f64 {
    let power = |n: i64| f64::from_bits(((n + 1023) as u64) << 52);
    let half = n >> 1;
    p * power(half) * power(n - half)
}

/// The series of e^r for |r| <= ln 2 / 2: what follows r^13/13! is below 5e-18.
fn exp_series(r: f64) -> f64 {
    const INVERSE_FACTORIALS: [f64; 12] = {
        let mut table = [0.0; 12];
        let mut factorial = 1.0;
        let mut k = 0;
        while k < 12 {
            factorial *= (k + 2) as f64;
            table[k] = 1.0 / factorial;
            k += 1;
        }
        table
    };
    let q = INVERSE_FACTORIALS.iter().rev().fold(0.0, |q, c| q * r + c);
    1.0 + (r + r * r * q)
}

/// 2 to the power `x`: exact for whole `x`, 0 below -1075, infinity from 1024 on, NaN stays.
#[must_use]
pub fn exp2(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    let x = x.clamp(-1100.0, 1100.0);
    let n = nearest(x);
    scale(exp_series((x - n) * LN2), n as i64)
}

/// The nearest whole number, ties to even, for |x| < 2^51.
pub(super) fn nearest(x: f64) -> f64 {
    super::round_f64(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_two_are_good_to_the_last_places_and_exact_for_whole_numbers() {
        let mut worst = 0.0f64;
        for i in -102_000..102_000 {
            let x = f64::from(i) * 0.01;
            worst = worst.max((exp2(x) / x.exp2() - 1.0).abs());
        }
        println!("exp2: {worst:.2e} (relative)");
        assert!(worst < 1e-15);
        for e in -1074..1024 {
            assert_eq!(exp2(f64::from(e)), f64::from(e).exp2());
        }
        assert_eq!((exp2(-1e9), exp2(1e9)), (0.0, f64::INFINITY));
        assert!(exp2(f64::NAN).is_nan());
    }
}
