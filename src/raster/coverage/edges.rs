//! Which pixels a triangle covers (OpenGL 1.5, section 3.5.1): those whose centres are inside, an edge that two triangles
//! share giving each centre on it to exactly one of them. All of it is integer arithmetic on positions in 1/256 pixel.
//!
//! An edge from p to q of a counter-clockwise triangle is the function E(x, y) = b (y - py) + a (x - px), a = py - qy,
//! b = qx - px, positive on the inside. At pixel centres it changes by 256 a and 256 b a pixel, so that E >= 0 may be asked
//! of `floor(E / 256)`, which changes by a and b:
//!
//! ```text
//!     q                     a > 0: inside is to the right of the edge, "left edge"
//!     |\      .  .  .       a < 0: inside is to the left
//!     | \     .  +  .       a = 0: the edge is horizontal; b < 0: inside is below it, "top edge"
//!     |  \    .  .  .       a centre on an edge is inside where the edge is a left or a top one (E >= 0),
//!     p---r                 outside otherwise (E - 1 >= 0)
//! ```

use crate::raster::state::Rect;

/// Fraction bits of a position.
const SUB: i32 = 8;
/// Half a pixel.
const HALF: i32 = 128;

/// The three edges of a triangle, over the rectangle of pixels where it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edges {
    /// Pixels to look at.
    pub rect: Rect,
    /// Change of each edge function per pixel in x.
    pub a: [i32; 3],
    /// Change per pixel in y.
    pub b: [i32; 3],
    /// Value at the rectangle's first pixel.
    pub c: [i64; 3],
}

/// The pixels whose centres are in the bounding box of positions.
#[inline]
#[must_use]
pub fn bounds(p: &[[i32; 2]; 3]) -> Rect {
    let [[x0, y0], [x1, y1], [x2, y2]] = *p;
    let first = |v: i32| (v + HALF - 1) >> SUB;
    let last = |v: i32| (v + HALF) >> SUB;
    Rect {
        x0: first(x0.min(x1).min(x2)),
        y0: first(y0.min(y1).min(y2)),
        x1: last(x0.max(x1).max(x2)),
        y1: last(y0.max(y1).max(y2)),
    }
}

impl Edges {
    /// The edges of a counter-clockwise triangle over a rectangle. Positions are below 2^24 in magnitude.
    #[inline]
    #[must_use]
    pub fn new(p: &[[i32; 2]; 3], rect: Rect) -> Self {
        let x = (i64::from(rect.x0) << SUB) + i64::from(HALF);
        let y = (i64::from(rect.y0) << SUB) + i64::from(HALF);
        let mut edges = Self { rect, a: [0; 3], b: [0; 3], c: [0; 3] };
        let ends = [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])];
        for (k, (from, to)) in ends.into_iter().enumerate() {
            let (a, b) = (from[1] - to[1], to[0] - from[0]);
            let inclusive = a > 0 || (a == 0 && b < 0);
            let e = i64::from(b) * (y - i64::from(from[1])) + i64::from(a) * (x - i64::from(from[0]));
            edges.a[k] = a;
            edges.b[k] = b;
            edges.c[k] = (e - i64::from(!inclusive)) >> SUB;
        }
        edges
    }

    /// The covered pixels of a rectangle of at most 8 by 8, a byte a row from below, the low bit leftmost. The
    /// rectangle must be the triangle's bounding box.
    #[inline]
    #[must_use]
    pub fn mask(&self) -> u64 {
        let (width, height) = (self.rect.x1 - self.rect.x0, self.rect.y1 - self.rect.y0);
        let c = self.c.map(|c| c as i32);
        let low = half_mask(self.a, self.b, c, height);
        if width <= 4 {
            // What was computed beyond the width is outside of the triangle.
            return low;
        }
        let mut right = c;
        for (c, a) in right.iter_mut().zip(self.a) {
            *c = c.wrapping_add(a.wrapping_mul(4));
        }
        low | half_mask(self.a, self.b, right, height) << 4
    }

    /// Calls `run(x, y, length)` for the covered pixels of each row in `rows`, from below.
    #[inline]
    pub fn spans(&self, rows: std::ops::Range<i32>, mut run: impl FnMut(i32, i32, i32)) {
        let (from, to) = (rows.start.max(self.rect.y0), rows.end.min(self.rect.y1));
        if from >= to {
            return;
        }
        let width = i64::from(self.rect.x1 - self.rect.x0);
        let mut steps =
            [0, 1, 2].map(|k: usize| EdgeStepper::new(self.a[k], self.b[k], self.c[k], from - self.rect.y0));
        for y in from..to {
            let (mut low, mut high) = (0, width);
            for step in &mut steps {
                step.narrow(&mut low, &mut high);
            }
            if low < high {
                run(self.rect.x0 + low as i32, y, (high - low) as i32);
            }
        }
    }
}

/// Four columns of a mask: bit i of byte j is set where all three functions are not negative at (i, j).
///
/// The four values of a row are the 16-bit digits of a u64, each with 2^15 added, so that a digit's top bit says "not
/// negative". Adding b to all digits is one wrapping addition, right as long as no digit leaves 0..2^16: within 8 by 8
/// pixels |E| / 256 is at most the area of the square that holds them, in 1/256 pixel over 256, which is below 23,700.
#[inline]
fn half_mask(a: [i32; 3], b: [i32; 3], c: [i32; 3], height: i32) -> u64 {
    const ONES: u64 = 0x0001_0001_0001_0001;
    const COUNT: u64 = 0x0003_0002_0001_0000;
    const TOP: u64 = 0x8000_8000_8000_8000;
    // Multiplied with digits of 0 or 1, gathers them in bits 48 to 51.
    const GATHER: u64 = (1 << 48) | (1 << 33) | (1 << 18) | (1 << 3);
    let row = |k: usize| {
        let start = (i64::from(c[k]) + 0x8000) as u64;
        start.wrapping_mul(ONES).wrapping_add((i64::from(a[k]) as u64).wrapping_mul(COUNT))
    };
    let up = |k: usize| (i64::from(b[k]) as u64).wrapping_mul(ONES);
    let (mut e0, mut e1, mut e2) = (row(0), row(1), row(2));
    let (b0, b1, b2) = (up(0), up(1), up(2));
    let mut mask = 0;
    for j in 0..height.clamp(0, 8) {
        let inside = (e0 & e1 & e2 & TOP) >> 15;
        mask |= (inside.wrapping_mul(GATHER) >> 48 & 15) << (8 * j);
        (e0, e1, e2) = (e0.wrapping_add(b0), e1.wrapping_add(b1), e2.wrapping_add(b2));
    }
    mask
}

/// Where an edge crosses the rows, one row after the other: the quotient of E by |a|, kept exact with its remainder.
#[derive(Clone, Copy, Debug)]
struct EdgeStepper {
    sign: i64,
    modulus: i64,
    quotient: i64,
    remainder: i64,
    quotient_step: i64,
    remainder_step: i64,
}

impl EdgeStepper {
    #[inline(always)]
    fn new(a: i32, b: i32, c: i64, row: i32) -> Self {
        let (a, b) = (i64::from(a), i64::from(b));
        let e = c + b * i64::from(row);
        let modulus = a.abs().max(1);
        let ((quotient, remainder), (quotient_step, remainder_step)) = (divide(e, modulus), divide(b, modulus));
        Self { sign: a.signum(), modulus, quotient, remainder, quotient_step, remainder_step }
    }

    /// Cuts the columns of this row down to those inside the edge, and goes on to the next row.
    #[inline]
    fn narrow(&mut self, low: &mut i64, high: &mut i64) {
        match self.sign {
            // a x + E >= 0  <=>  x >= ceil(-E / a) = -floor(E / a)
            1 => *low = (*low).max(-self.quotient),
            // x <= floor(E / -a)
            -1 => *high = (*high).min(self.quotient + 1),
            _ if self.quotient < 0 => *high = *low,
            _ => {}
        }
        self.quotient += self.quotient_step;
        self.remainder += self.remainder_step;
        if self.remainder >= self.modulus {
            self.remainder -= self.modulus;
            self.quotient += 1;
        }
    }
}

/// Quotient, rounded down, and remainder of E by a modulus greater than 0. Below 2^53 a float's quotient is right: unless
/// E / m is whole, it is 1 / m away from the next whole number, and rounding moves it by at most 2^-53 |E| / m.
#[inline(always)]
fn divide(e: i64, modulus: i64) -> (i64, i64) {
    let exact = e as f64 / modulus as f64;
    let toward_zero = exact as i64;
    let quotient = toward_zero - i64::from(toward_zero as f64 > exact);
    (quotient, e - quotient * modulus)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::testing::{Random, TestCanvas};

    #[test]
    fn quotients_are_those_of_whole_numbers() {
        let mut random = Random(9);
        for round in 0..200_000 {
            let m = (random.unit() * f64::from(1u32 << (round % 25 + 1))) as i64 + 1;
            let near = (random.between(-1.0, 1.0) * 2f64.powi(52)) as i64 / m * m;
            for e in [near - 1, near, near + 1, near / 3, -m, m - 1, 0] {
                assert_eq!(divide(e, m), (e.div_euclid(m), e.rem_euclid(m)), "{e} by {m}");
            }
        }
    }

    /// Whether a pixel's centre is inside, in 128-bit arithmetic straight from the rule.
    fn inside(p: &[[i32; 2]; 3], x: i32, y: i32) -> bool {
        let c = [i128::from(x) * 256 + 128, i128::from(y) * 256 + 128];
        let at = |i: usize, k: usize| i128::from(p[i][k]);
        [(0, 1), (1, 2), (2, 0)].into_iter().all(|(i, j)| {
            let (dx, dy) = (at(j, 0) - at(i, 0), at(j, 1) - at(i, 1));
            let e = dx * (c[1] - at(i, 1)) - dy * (c[0] - at(i, 0));
            e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx < 0)))
        })
    }

    fn area(p: &[[i32; 2]; 3]) -> i64 {
        let d = |i: usize, k: usize| i64::from(p[i][k] - p[0][k]);
        d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1)
    }

    #[test]
    fn spans_and_masks_agree_with_128_bit_arithmetic() {
        let mut random = Random(1);
        let mut covered = 0;
        for round in 0..4000 {
            let size = [8.0, 40.0, 900.0, 32_000.0][round % 4] * 256.0;
            let at = random.between(-100.0, 100.0) * 256.0;
            // Every other triangle has its corners on pixel centres or corners, so that ties happen.
            let grid = if round % 8 < 4 { 1.0 } else { 128.0 };
            let mut p = [[0; 2]; 3].map(|p: [i32; 2]| {
                p.map(|_| ((at + random.between(-0.5, 0.5) * size) / grid).round() as i32 * grid as i32)
            });
            if area(&p) < 0 {
                p.swap(1, 2);
            }
            if area(&p) == 0 {
                continue;
            }
            let all = bounds(&p);
            let window = all.and(Rect { x0: -60, y0: -60, x1: 60, y1: 60 });
            if window.is_empty() {
                continue;
            }
            let edges = Edges::new(&p, window);
            let mut found = vec![];
            edges.spans(-1000..1000, |x, y, len| found.extend((x..x + len).map(|x| (x, y))));
            let mut late = vec![];
            edges.spans(7..1000, |x, y, len| late.extend((x..x + len).map(|x| (x, y))));
            let mut want = vec![];
            for y in -60..60 {
                want.extend((-60..60).filter(|x| inside(&p, *x, y)).map(|x| (x, y)));
            }
            assert_eq!(found, want, "{p:?}");
            assert_eq!(late, want.iter().copied().filter(|(_, y)| *y >= 7).collect::<Vec<_>>());
            if all.x1 - all.x0 <= 8 && all.y1 - all.y0 <= 8 {
                let mask = Edges::new(&p, all).mask();
                for i in 0..64 {
                    let (x, y) = (all.x0 + i % 8, all.y0 + i / 8);
                    assert_eq!(mask >> i & 1 != 0, inside(&p, x, y), "{p:?} {x} {y}");
                }
            }
            covered += want.len();
        }
        assert!(covered > 100_000, "{covered}");
    }

    #[test]
    fn edge_functions_at_the_guard_band_fit_their_types() {
        let far = (1 << 23) - 1;
        let p = [[-far, -far], [far, -far], [-far, far]];
        for rect in [bounds(&p), Rect { x0: 0, y0: 0, x1: 16384, y1: 16384 }] {
            let edges = Edges::new(&p, rect);
            let mut rows = 0;
            edges.spans(rect.y0..rect.y1, |x, y, len| {
                assert!(inside(&p, x, y) && inside(&p, x + len - 1, y) && !inside(&p, x + len, y));
                rows += 1;
            });
            assert!(rows > 0 || rect.x0 == 0);
        }
    }

    /// Draws triangles that cover a canvas exactly, in both windings, and expects each pixel once.
    fn once(triangles: &[[[f64; 2]; 3]], side: u32) {
        for (threads, cut) in [(1, 64), (3, 17)] {
            let mut canvas = TestCanvas::new(side, 0, threads, cut, |_| {});
            for (i, t) in triangles.iter().enumerate() {
                let [a, b, c] = *t;
                canvas.plain(if i % 2 == 0 { [a, b, c] } else { [c, b, a] });
            }
            let hits = canvas.hits();
            let wrong = hits.iter().filter(|n| **n != 1).count();
            assert_eq!(wrong, 0, "{} triangles, {threads} threads", triangles.len());
        }
    }

    #[test]
    fn grids_cover_each_pixel_once() {
        let mut random = Random(2);
        let (n, side) = (71, 256.0);
        // Inner corners are moved about; the outer ones lie beyond the canvas.
        let mut corner = vec![];
        for i in 0..=n {
            for j in 0..=n {
                let mut place = |k: i32| {
                    let at = (f64::from(k) / f64::from(n)) * (side + 16.0) - 8.0;
                    let free = if k == 0 || k == n { 0.0 } else { 0.8 };
                    at + random.between(-free, free)
                };
                corner.push([place(j), place(i)]);
            }
        }
        let mut triangles = vec![];
        for i in 0..n {
            for j in 0..n {
                let at = |i: i32, j: i32| corner[(i * (n + 1) + j) as usize];
                let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)];
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        assert!(triangles.len() > 10_000);
        once(&triangles, 256);
        // On pixel centres exactly.
        let tied: Vec<_> = triangles.iter().map(|t| t.map(|p| p.map(|v| (v + 0.5).round() - 0.5))).collect();
        once(&tied, 256);
    }

    #[test]
    fn fans_and_strips_cover_each_pixel_once() {
        let mut random = Random(3);
        let center = [101.3, 90.7];
        let mut rim: Vec<f64> = (0..5000).map(|_| random.unit()).chain([0.0, 0.25, 0.5, 0.75]).collect();
        rim.sort_by(f64::total_cmp);
        // Once around a square beyond the canvas.
        let around = |t: f64| {
            let (side, part) = ((t * 4.0).floor(), (t * 4.0).fract() * 400.0 - 100.0);
            match side as i32 {
                0 => [part, -100.0],
                1 => [300.0, part],
                2 => [200.0 - part, 300.0],
                _ => [-100.0, 200.0 - part],
            }
        };
        let fan: Vec<_> = (0..rim.len()).map(|i| [center, around(rim[i]), around(rim[(i + 1) % rim.len()])]).collect();
        once(&fan, 200);
        let mut strip = vec![];
        let mut ends = [[-5.0, -5.0], [-5.0, 205.0]];
        while ends[0][0] < 205.0 || ends[1][0] < 205.0 {
            let k = usize::from(ends[1][0] < ends[0][0]);
            let next = [ends[k][0] + random.between(0.0, 0.1), ends[k][1]];
            strip.push([ends[0], ends[1], next]);
            ends[k] = next;
        }
        assert!(strip.len() > 5000);
        once(&strip, 200);
    }
}
