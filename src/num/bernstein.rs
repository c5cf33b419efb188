//! Bernstein polynomials, in which evaluators are written (OpenGL 1.5, section 5.1):
//!
//! ```text
//!   B(i, n, t) = binomial(n, i) t^i (1 - t)^(n - i)       n = order - 1
//!   curve    p(u) = sum B(i, n, u) R_i
//!   surface  p(u, v) = sum sum B(i, n, u) B(j, m, v) R_ij
//! ```
//!
//! They are summed up from order to order (B(i, n) = (1 - t) B(i, n - 1) + t B(i - 1, n - 1)), which stays exact to a few
//! rounding errors where powers and binomials would not. All in `f64`, sums in written order.

use crate::limits::MAX_EVAL_ORDER;

/// The polynomials of one order at one parameter.
#[derive(Clone, Copy, Debug)]
pub struct Bernstein {
    /// Values: `order` of them.
    pub values: [f64; MAX_EVAL_ORDER],
    /// Derivatives.
    pub slopes: [f64; MAX_EVAL_ORDER],
    /// How many.
    pub order: usize,
}

impl Bernstein {
    /// Those of an order (1 to [`MAX_EVAL_ORDER`]) at t.
    #[must_use]
    pub fn new(order: usize, t: f64) -> Self {
        let order = order.clamp(1, MAX_EVAL_ORDER);
        let (mut values, mut slopes) = ([0.0; MAX_EVAL_ORDER], [0.0; MAX_EVAL_ORDER]);
        values[0] = 1.0;
        for degree in 1..order {
            if degree + 1 == order {
                // B'(i, n) = n (B(i - 1, n - 1) - B(i, n - 1)), from the values of the degree before.
                let n = degree as f64;
                slopes[0] = -n * values[0];
                for i in 1..degree {
                    slopes[i] = n * (values[i - 1] - values[i]);
                }
                slopes[degree] = n * values[degree - 1];
            }
            let mut carried = 0.0;
            for value in &mut values[..degree] {
                let before = *value;
                *value = carried + (1.0 - t) * before;
                carried = t * before;
            }
            values[degree] = carried;
        }
        Self { values, slopes, order }
    }
}

/// The sum of points of `N` components by weights.
fn sum<'a, const N: usize>(points: &[f64], weights: impl Iterator<Item = &'a f64>) -> [f64; N] {
    let mut out = [0.0; N];
    for (point, weight) in points.as_chunks::<N>().0.iter().zip(weights) {
        for k in 0..N {
            out[k] += weight * point[k];
        }
    }
    out
}

/// A point of a curve with control points of `N` components.
#[must_use]
pub fn curve<const N: usize>(points: &[f64], u: &Bernstein) -> [f64; N] {
    sum(points, u.values[..u.order].iter())
}

/// A point of a surface, the control points row by row (a row has one u and all v), and its derivatives by u and by v.
#[must_use]
pub fn surface<const N: usize>(points: &[f64], u: &Bernstein, v: &Bernstein) -> [[f64; N]; 3] {
    let mut out = [[0.0; N]; 3];
    for (i, row) in points.chunks_exact(v.order * N).take(u.order).enumerate() {
        let at: [f64; N] = sum(row, v.values[..v.order].iter());
        let along: [f64; N] = sum(row, v.slopes[..v.order].iter());
        for k in 0..N {
            out[0][k] += u.values[i] * at[k];
            out[1][k] += u.slopes[i] * at[k];
            out[2][k] += u.values[i] * along[k];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B(i, n, t) from its definition.
    fn defined(i: usize, n: usize, t: f64) -> f64 {
        let binomial = (0..i).fold(1.0, |b, k| b * (n - k) as f64 / (k + 1) as f64);
        binomial * (0..i).fold(1.0, |p, _| p * t) * (i..n).fold(1.0, |p, _| p * (1.0 - t))
    }

    #[test]
    fn values_and_slopes_are_those_of_the_definition() {
        for order in 1..=MAX_EVAL_ORDER {
            for t in [0.0, 0.125, 0.5, 0.7, 1.0, -0.25, 1.5] {
                let b = Bernstein::new(order, t);
                let n = order - 1;
                for i in 0..order {
                    let want = defined(i, n, t);
                    // Beyond [0, 1] the terms are large and of both signs.
                    let scale = (0..order).map(|i| defined(i, n, t).abs()).fold(1.0, f64::max);
                    assert!((b.values[i] - want).abs() <= 1e-13 * scale, "B({i}, {n}, {t})");
                    let below = |i: Option<usize>| i.filter(|i| n > 0 && *i < n).map_or(0.0, |i| defined(i, n - 1, t));
                    let slope = n as f64 * (below(i.checked_sub(1)) - below(Some(i)));
                    assert!((b.slopes[i] - slope).abs() <= 1e-12 * scale * order as f64, "slope of B({i}, {n}, {t})");
                }
            }
        }
    }

    #[test]
    fn curves_and_surfaces_begin_and_end_in_their_corners() {
        let points = [1.0, 2.0, 5.0, -3.0, 7.0, 11.0];
        assert_eq!(curve::<2>(&points, &Bernstein::new(3, 0.0)), [1.0, 2.0]);
        assert_eq!(curve::<2>(&points, &Bernstein::new(3, 1.0)), [7.0, 11.0]);
        let corner = |u, v| surface::<1>(&points, &Bernstein::new(2, u), &Bernstein::new(3, v))[0][0];
        assert_eq!([corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 0.0), corner(1.0, 1.0)], [1.0, 5.0, -3.0, 11.0]);
    }
}
