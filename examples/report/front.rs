//! Which settings are worth their time. A setting is on the Pareto front when no other is both as fast and as near the
//! ideal. Of those on the front the best bargain is the one with the least product of squared error and time: averaging n
//! pictures divides the one by n and multiplies the other by it, so this is the measure in which plain repetition gains
//! nothing. The conclusions are made from these figures.

/// Time and error of a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// ns a fragment.
    pub time: f64,
    /// Root of the mean square against the ideal, in LSB.
    pub error: f64,
}

/// Whether each point is on the front: no other is at least as good in both and better in one.
pub fn front(points: &[Point]) -> Vec<bool> {
    let beats = |a: &Point, b: &Point| a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
    points.iter().map(|p| !points.iter().any(|q| beats(q, p))).collect()
}

/// The place of the best bargain.
pub fn bargain(points: &[Point]) -> Option<usize> {
    least(points, |p| p.error * p.error * p.time)
}

/// The place of the fastest point, and of the one with the least error.
pub fn fastest(points: &[Point]) -> Option<usize> {
    least(points, |p| p.time)
}

/// The place of the point with the least error.
pub fn nearest(points: &[Point]) -> Option<usize> {
    least(points, |p| p.error)
}

fn least(points: &[Point], value: impl Fn(&Point) -> f64) -> Option<usize> {
    (0..points.len()).min_by(|&a, &b| value(&points[a]).total_cmp(&value(&points[b])))
}

/// The geometric mean.
pub fn mean(values: &[f64]) -> f64 {
    let logs: f64 = values.iter().map(|v| v.max(1e-9).ln()).sum();
    (logs / values.len().max(1) as f64).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beaten_is_not_on_the_front() {
        let p = |time, error| Point { time, error };
        let points = [p(1.0, 50.0), p(2.0, 20.0), p(2.5, 25.0), p(8.0, 19.0), p(2.0, 20.0)];
        assert_eq!(front(&points), [true, true, false, true, true]);
        assert_eq!((fastest(&points), nearest(&points), bargain(&points)), (Some(0), Some(3), Some(1)));
        assert_eq!(bargain(&[]), None);
        assert!((mean(&[1.0, 4.0]) - 2.0).abs() < 1e-12);
    }
}
