//! Coverage of smooth points (OpenGL 1.5, section 3.3): how much of a pixel a disc covers.

use crate::raster::state::Rect;

/// A smooth point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Pixels that may be touched.
    pub rect: Rect,
    /// The pixel that the centre is relative to.
    pub origin: [i32; 2],
    /// The centre, in pixels from the lower left corner of the origin pixel.
    pub center: [f64; 2],
    /// Radius in pixels.
    pub radius: f64,
}

impl Disc {
    /// How much of a pixel the disc covers: the mean, over 16 horizontal lines through the pixel, of the part of the line
    /// that is in the disc. The error is at most 2^-9.
    #[must_use]
    pub fn coverage(&self, x: i32, y: i32) -> f32 {
        let left = f64::from(x - self.origin[0]) - self.center[0];
        let low = f64::from(y - self.origin[1]) - self.center[1];
        let far = |a: f64| if a + 0.5 > 0.0 { a + 1.0 } else { -a };
        let near = |a: f64| a.max(-1.0 - a).max(0.0);
        let length = |[x, y]: [f64; 2]| x * x + y * y;
        let square = self.radius * self.radius;
        if length([left, low].map(far)) <= square {
            return 1.0;
        }
        // The margin is more than the rounding error.
        if length([left, low].map(near)) > square * (1.0 + 1e-9) {
            return 0.0;
        }
        // No branches, so that vector instructions compute several lines at once.
        let mut parts = [0.0; 16];
        for (line, part) in (0i32..).zip(&mut parts) {
            let dy = low + (f64::from(line) + 0.5) * (1.0 / 16.0);
            let rest = square - dy * dy;
            let half = rest.max(0.0).sqrt();
            let (end, start) =
                (if left + 1.0 < half { left + 1.0 } else { half }, if left > -half { left } else { -half });
            *part = if end > start { end - start } else { 0.0 };
        }
        let sum = parts.iter().fold(0.0, |sum, part| sum + part);
        (sum * (1.0 / 16.0)) as f32
    }
}

#[cfg(test)]
mod tests {
    use crate::raster::testing::{Random, TestCanvas};

    #[test]
    fn smooth_points_cover_the_area_of_their_disc() {
        let mut random = Random(22);
        for _ in 0..100 {
            let size = random.between(1.0, 20.0) as f32;
            let mut canvas = TestCanvas::new(64, 1, 1, 64, |state| state.point.smooth = true);
            let at = [random.between(20.0, 40.0), random.between(20.0, 40.0)];
            canvas.point(at, size);
            let seen = canvas.seen();
            let sum: f64 = seen.iter().map(|s| f64::from(s.coverage)).sum();
            let area = std::f64::consts::PI * f64::from(size) * f64::from(size) / 4.0;
            assert!((sum / area - 1.0).abs() < 0.02, "{size}: {sum} {area}");
            assert!(seen.iter().all(|s| s.coverage > 0.0 && s.coverage <= 1.0));
        }
    }
}
