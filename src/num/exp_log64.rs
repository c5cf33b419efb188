//! `f64` exponentials and logarithms for what is computed once a command (fog tables, teaching, GLU).
//!
//! The same decomposition as in the lane functions, with series long enough for `f64`. Errors are a few units in the
//! last place; `pow` loses as many bits as its exponent `y * log2 x` is large.

/// The natural logarithm of 2.
pub(super) const LN2: f64 = std::f64::consts::LN_2;
/// ln 2 in two parts: the first has 32 bits, so that a binary exponent times it is exact.
const LN2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN2_LOW: f64 = 1.908_214_929_270_587_7e-10;

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

/// A positive finite number as `m * 2^e` with `m` in sqrt(1/2)..sqrt(2).
fn split(x: f64) -> (f64, i64) {
    let (x, bias) = if x < f64::MIN_POSITIVE { (x * 18_014_398_509_481_984.0, -54) } else { (x, 0) };
    let bits = x.to_bits() as i64;
    let e = (bits - 0x3fe6_a09e_667f_3bcd) >> 52;
    (f64::from_bits((bits - (e << 52)) as u64), e + bias)
}

/// The natural logarithm: minus infinity at 0, NaN below.
#[must_use]
pub fn ln(x: f64) -> f64 {
    match special_log(x) {
        Some(v) => v,
        None => {
            let (m, e) = split(x);
            let f = m - 1.0;
            let e = e as f64;
            e * LN2_HIGH + (e * LN2_LOW + atanh_series::<11>(f / (2.0 + f)))
        }
    }
}

/// The base-2 logarithm, exact at powers of two: minus infinity at 0, NaN below.
#[must_use]
pub fn log2(x: f64) -> f64 {
    match special_log(x) {
        Some(v) => v,
        None => {
            let (m, e) = split(x);
            let f = m - 1.0;
            e as f64 + atanh_series::<11>(f / (2.0 + f)) * std::f64::consts::LOG2_E
        }
    }
}

/// The logarithm where it needs no series.
fn special_log(x: f64) -> Option<f64> {
    if x.is_nan() || x < 0.0 {
        Some(f64::NAN)
    } else if x == 0.0 {
        Some(f64::NEG_INFINITY)
    } else if x == f64::INFINITY {
        Some(x)
    } else {
        None
    }
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

/// e to the power `x`: 0 below -745.2, infinity above 709.8, NaN stays.
#[must_use]
pub fn exp(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    let x = x.clamp(-800.0, 800.0);
    let n = nearest(x * std::f64::consts::LOG2_E);
    scale(exp_series((x - n * LN2_HIGH) - n * LN2_LOW), n as i64)
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

/// `x` to the power `y`, with 0^0 = 1. A negative `x` has a power only for whole `y`, else NaN.
#[must_use]
pub fn pow(x: f64, y: f64) -> f64 {
    if y == 0.0 || x == 1.0 {
        return 1.0;
    }
    if x < 0.0 {
        let whole = nearest(y) == y || y.abs() >= 4_503_599_627_370_496.0;
        let odd = nearest(y * 0.5) != y * 0.5 && y.abs() < 9_007_199_254_740_992.0;
        return match (whole, odd) {
            (false, _) => f64::NAN,
            (true, true) => -pow(-x, y),
            (true, false) => pow(-x, y),
        };
    }
    exp2(y * log2(x))
}

/// The nearest whole number, ties to even, for |x| < 2^51.
pub(super) fn nearest(x: f64) -> f64 {
    super::round_f64(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn relative(got: f64, want: f64) -> f64 {
        if got == want { 0.0 } else { ((got - want) / want.abs().max(f64::MIN_POSITIVE)).abs() }
    }

    #[test]
    fn logarithms_and_exponentials_are_good_to_the_last_places() {
        let (mut worst_ln, mut worst_log2, mut worst_exp, mut worst_exp2) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
        let mut x = 1e-300f64;
        while x < 1e300 {
            worst_ln = worst_ln.max((ln(x) - x.ln()).abs() / x.ln().abs().max(1e-3));
            worst_log2 = worst_log2.max((log2(x) - x.log2()).abs() / x.log2().abs().max(1e-3));
            x *= 1.000_7;
        }
        for i in -70_000..70_000 {
            let x = f64::from(i) * 0.01;
            worst_exp = worst_exp.max(relative(exp(x), x.exp()));
            worst_exp2 = worst_exp2.max(relative(exp2(x), x.exp2()));
        }
        println!("ln {worst_ln:.2e} log2 {worst_log2:.2e} exp {worst_exp:.2e} exp2 {worst_exp2:.2e} (relative)");
        assert!(worst_ln < 1e-15 && worst_log2 < 1e-15 && worst_exp < 1e-15 && worst_exp2 < 1e-15);
        for e in -1074..1024 {
            let x = exp2(f64::from(e));
            assert_eq!(x, f64::from(e).exp2());
            assert_eq!(log2(x), f64::from(e));
        }
    }

    #[test]
    fn edges_are_ieee() {
        assert_eq!(ln(0.0), f64::NEG_INFINITY);
        assert!(ln(-1.0).is_nan() && ln(f64::NAN).is_nan() && exp(f64::NAN).is_nan());
        assert_eq!(ln(f64::INFINITY), f64::INFINITY);
        assert_eq!(exp(-1e9), 0.0);
        assert_eq!(exp(1e9), f64::INFINITY);
        assert_eq!(exp(0.0), 1.0);
    }

    #[test]
    fn powers() {
        let mut worst = 0.0f64;
        for i in 1..300 {
            for j in -60..60 {
                let (x, y) = (f64::from(i) * 0.05, f64::from(j) * 0.37);
                worst = worst.max(relative(pow(x, y), x.powf(y)));
            }
        }
        println!("pow {worst:.2e} (relative, |y log2 x| < 90)");
        assert!(worst < 5e-14);
        assert_eq!(pow(0.0, 0.0), 1.0);
        assert_eq!(pow(0.0, 2.0), 0.0);
        assert_eq!(pow(0.0, -2.0), f64::INFINITY);
        assert_eq!(pow(-2.0, 3.0), -8.0);
        assert_eq!(pow(-2.0, 4.0), 16.0);
        assert!(pow(-2.0, 0.5).is_nan());
    }
}
