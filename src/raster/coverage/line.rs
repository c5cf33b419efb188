//! Aliased lines (OpenGL 1.5, section 3.4): the diamond-exit rule in integers, width by replication across the minor axis,
//! stipple. Along its major axis a line has one fragment a step, since |slope| <= 1 means that it crosses the middle of
//! exactly one diamond in each column; only in the first and the last column the diamond itself must be looked at:
//!
//! ```text
//!        /\   the pixel's diamond |x - cx| + |y - cy| < 1/2       a ......>      a starts left of the middle or inside: drawn
//!       /  \                                                      ......> b      b ends right of the middle and outside: drawn
//!       \  /  a fragment is made where the line *leaves* the      an end on the diamond's border counts as moved by
//!        \/   diamond, so lines that meet share no pixel          (-e, -e*e), e tiny, as the specification says
//! ```

use crate::raster::emit::{Emitter, FragmentSink};
use crate::raster::state::{RasterState, Rect};
use std::ops::Range;

/// An aliased line, ready to be rasterised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AliasedLine {
    /// Pixels that may be touched.
    pub rect: Rect,
    /// Whether x is the major axis.
    x_major: bool,
    /// Steps along the major axis.
    pub(crate) from: i32,
    pub(crate) to: i32,
    /// Minor coordinate at step `from`: quotient and remainder of a division by `modulus`, and their change a step.
    minor: i64,
    remainder: i64,
    minor_step: i64,
    remainder_step: i64,
    modulus: i64,
    /// Minor coordinates that are drawn.
    view: (i32, i32),
    /// Stipple counter at step `from`, and its change a step.
    count: u32,
    direction: i32,
}

/// Whether p lies in the diamond of the pixel. On the border p counts as moved a little to the left, and less down.
fn in_diamond(p: [i32; 2], pixel: [i32; 2]) -> bool {
    let [x, y] = [0, 1].map(|k: usize| i64::from(p[k]) - (i64::from(pixel[k]) * 256 + 128));
    let distance = x.abs() + y.abs();
    distance < 128 || (distance == 128 && x > 0)
}

/// The axis, 0 or 1, across which a line in a direction is wide.
pub(crate) fn minor_axis([x, y]: [i32; 2]) -> usize {
    usize::from(x.abs() >= y.abs())
}

impl AliasedLine {
    /// The lowest line of width 1 of a line of `width` between two snapped positions, `None` where no fragment is seen;
    /// [`raised`](Self::raised) gives the others. The second value is the number of fragments along it, with those outside
    /// the scissor rectangle: the stipple counter goes on by it.
    pub(crate) fn new(a: [i32; 2], b: [i32; 2], width: i32, counter: u32, rs: &RasterState) -> (Option<Self>, u32) {
        let d = [b[0] - a[0], b[1] - a[1]];
        let minor = minor_axis(d);
        let (x_major, major) = (minor == 1, 1 - minor);
        let length = i64::from(d[major].abs());
        if length == 0 {
            return (None, 0);
        }
        // Width w: the line moves down by (w - 1) / 2 and each fragment becomes w of them upwards.
        let shifted = |mut p: [i32; 2]| {
            p[minor] -= (width - 1) * 128;
            p
        };
        let (a, b) = (shifted(a), shifted(b));
        let forward = d[major] > 0;
        let direction = if forward { 1 } else { -1 };
        let rise = i64::from(d[minor]) * i64::from(direction);
        // Where the line runs exactly between two pixels, the tiny displacement chooses one.
        let down = !x_major || rise <= 0;
        let numerator = |step: i32| {
            let middle = i64::from(step) * 256 + 128 - i64::from(a[major]);
            i64::from(a[minor]) * length + middle * rise - i64::from(down)
        };
        let modulus = 256 * length;
        let pixel = |step: i32| {
            let across = numerator(step).div_euclid(modulus) as i32;
            if x_major { [step, across] } else { [across, step] }
        };
        let (first, last) = ((a[major] - 1) >> 8, (b[major] - 1) >> 8);
        let middle = |step: i32| step * 256 + 128;
        let (starts, ends) = if forward {
            (a[major] <= middle(first), b[major] > middle(last))
        } else {
            (a[major] > middle(first), b[major] <= middle(last))
        };
        let first = if starts || in_diamond(a, pixel(first)) { first } else { first + direction };
        let last = if ends && !in_diamond(b, pixel(last)) { last } else { last - direction };
        let fragments = (last - first) * direction + 1;
        if fragments <= 0 {
            return (None, 0);
        }
        let advance = fragments.unsigned_abs();
        let view = rs.viewport;
        let (view_major, view_minor) =
            if x_major { ((view.x0, view.x1), (view.y0, view.y1)) } else { ((view.y0, view.y1), (view.x0, view.x1)) };
        let clip = rs.clip;
        let (clip_low, clip_high) = if x_major { (clip.x0, clip.x1) } else { (clip.y0, clip.y1) };
        let from = first.min(last).max(view_major.0).max(clip_low);
        let to = (first.max(last) + 1).min(view_major.1).min(clip_high);
        if from >= to {
            return (None, advance);
        }
        let ends = [numerator(from).div_euclid(modulus), numerator(to - 1).div_euclid(modulus)];
        let (low, high) = (ends[0].min(ends[1]) as i32, ends[0].max(ends[1]) as i32 + 1);
        let rect = if x_major {
            Rect { x0: from, y0: low, x1: to, y1: high }
        } else {
            Rect { x0: low, y0: from, x1: high, y1: to }
        };
        let middle = (width - 1) / 2;
        let line = Self {
            rect,
            x_major,
            from,
            to,
            minor: ends[0],
            remainder: numerator(from).rem_euclid(modulus),
            minor_step: (256 * rise).div_euclid(modulus),
            remainder_step: (256 * rise).rem_euclid(modulus),
            modulus,
            // The middle of a column must be in the viewport.
            view: (view_minor.0 - middle, view_minor.1 - middle),
            count: counter.wrapping_add(((from - first) * direction) as u32),
            direction,
        };
        (Some(line), advance)
    }

    /// The line `by` pixels higher in the minor direction, cut by a rectangle; `None` where nothing is left.
    pub(crate) fn raised(&self, by: i32, clip: Rect) -> Option<Self> {
        let (x, y) = if self.x_major { (0, by) } else { (by, 0) };
        let Rect { x0, y0, x1, y1 } = self.rect;
        let rect = Rect { x0: x0 + x, y0: y0 + y, x1: x1 + x, y1: y1 + y }.and(clip);
        let view = (self.view.0 + by, self.view.1 + by);
        (!rect.is_empty()).then_some(Self { rect, minor: self.minor + i64::from(by), view, ..*self })
    }

    /// Emits the fragments in `rows`.
    pub fn rasterise(
        &self,
        rows: Range<i32>,
        stipple: Option<(u16, u32)>,
        to: &mut Emitter,
        sink: &mut impl FragmentSink,
    ) {
        let rect = self.rect;
        let (y0, y1) = (rows.start.max(rect.y0), rows.end.min(rect.y1));
        let low = self.view.0.max(if self.x_major { y0 } else { rect.x0 });
        let high = self.view.1.min(if self.x_major { y1 } else { rect.x1 });
        let (mut minor, mut remainder, mut count) = (self.minor, self.remainder, self.count);
        // Neighbouring fragments of one row that are not emitted yet: x, y, length.
        let mut run = (0, 0, 0);
        for step in self.from..self.to {
            let across = minor as i32;
            let drawn = stipple.is_none_or(|(pattern, factor)| (pattern >> ((count / factor) & 15)) & 1 != 0);
            if drawn && (low..high).contains(&across) {
                if !self.x_major {
                    if (y0..y1).contains(&step) {
                        to.run(across, step, 1, 1.0, sink);
                    }
                } else if run.2 > 0 && run.1 == across && run.0 + run.2 == step {
                    run.2 += 1;
                } else {
                    to.run(run.0, run.1, run.2, 1.0, sink);
                    run = (step, across, 1);
                }
            }
            count = count.wrapping_add_signed(self.direction);
            minor += self.minor_step;
            remainder += self.remainder_step;
            if remainder >= self.modulus {
                remainder -= self.modulus;
                minor += 1;
            }
        }
        to.run(run.0, run.1, run.2, 1.0, sink);
    }
}

#[cfg(test)]
mod tests {
    use crate::raster::PrimitiveSink;
    use crate::raster::testing::{Random, TestCanvas};
    use crate::raster::vertex::VertexRef;
    use crate::state::State;

    /// Tells whether a line makes a fragment, straight from the rule: the segment, both ends moved by (-e, -e*e), meets
    /// the open diamond and does not end in it. In units of 2^-16 pixel e is 1 / 256 and e * e far smaller; the segment is
    /// cut by the diamond's four sides in exact fractions.
    fn exits(a: [i32; 2], b: [i32; 2], pixel: [i32; 2]) -> bool {
        const ONE: i128 = 1 << 40;
        let moved = |p: [i32; 2]| {
            let rel = [0, 1].map(|k: usize| (i128::from(p[k]) - i128::from(pixel[k]) * 256 - 128) * ONE);
            [rel[0] - (1 << 20), rel[1] - 1]
        };
        let (a, b) = (moved(a), moved(b));
        // The parameter range of the segment inside the four half-planes, as fractions low / den, high / den.
        let (mut low, mut high) = ((0i128, 1i128), (1i128, 1i128));
        let mut end_inside = true;
        for (sx, sy) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let da = 128 * ONE - (sx * a[0] + sy * a[1]);
            let db = 128 * ONE - (sx * b[0] + sy * b[1]);
            end_inside &= db > 0;
            match (da > 0, db > 0) {
                (true, true) => {}
                (false, false) => return false,
                (true, false) => {
                    if da as f64 * (high.1 as f64) < high.0 as f64 * (da - db) as f64 {
                        high = (da, da - db);
                    }
                }
                (false, true) => {
                    if -da as f64 * (low.1 as f64) > low.0 as f64 * (db - da) as f64 {
                        low = (-da, db - da);
                    }
                }
            }
        }
        let meets = (low.0 as f64) * (high.1 as f64) < (high.0 as f64) * (low.1 as f64);
        meets && !end_inside
    }

    #[test]
    fn fragments_are_those_whose_diamonds_are_left() {
        let mut random = Random(11);
        let mut total = 0;
        for round in 0..3000 {
            let grid = [1.0, 128.0, 64.0][round % 3];
            let reach = [2.0, 14.0][round % 2];
            let mut end =
                || [0, 1].map(|_| ((random.between(8.0 - reach, 8.0 + reach) * 256.0 / grid).round() * grid) as i32);
            let (a, b) = (end(), end());
            // Exactly diagonal lines along the border of diamonds need more than this test's arithmetic.
            if (b[0] - a[0]).abs() == (b[1] - a[1]).abs() {
                continue;
            }
            let mut canvas = TestCanvas::new(16, 0, 1, 64, |_| {});
            canvas.line(a.map(|v| f64::from(v) / 256.0), b.map(|v| f64::from(v) / 256.0));
            let hits = canvas.hits();
            for (i, n) in hits.iter().enumerate() {
                let pixel = [i as i32 % 16, i as i32 / 16];
                assert_eq!(*n == 1, exits(a, b, pixel), "{a:?} {b:?} {pixel:?}");
            }
            total += hits.iter().sum::<u32>();
        }
        assert!(total > 10_000, "{total}");
    }

    #[test]
    fn closed_loops_hit_each_pixel_of_a_corner_once() {
        let mut canvas = TestCanvas::new(32, 0, 2, 64, |_| {});
        let corner = [[4.5, 4.5], [24.5, 4.5], [24.5, 20.5], [4.5, 20.5]];
        for i in 0..4 {
            canvas.line(corner[i], corner[(i + 1) % 4]);
        }
        let hits = canvas.hits();
        assert_eq!(hits.iter().sum::<u32>(), 2 * (20 + 16));
        assert!(hits.iter().all(|n| *n <= 1));
    }

    fn rows(canvas: &mut TestCanvas, side: usize) -> Vec<String> {
        let text = |row: &[u32]| row.iter().map(|n| char::from(b'0' + *n as u8)).collect();
        canvas.hits().chunks(side).map(text).collect()
    }

    #[test]
    fn width_is_across_the_minor_axis_and_stipple_along_the_major_one() {
        let stipple = |state: &mut State| {
            state.line.width = 3.0;
            state.line.stipple = true;
            state.line.stipple_pattern = 0b1011;
            state.line.stipple_factor = 2;
        };
        let mut canvas = TestCanvas::new(12, 0, 1, 5, stipple);
        canvas.line([1.0, 5.25], [11.0, 5.25]);
        let want = "011110011000";
        let found = rows(&mut canvas, 12);
        assert_eq!(
            [&found[3], &found[4], &found[5], &found[6], &found[7]],
            ["000000000000", want, want, want, "000000000000"]
        );
        let mut canvas = TestCanvas::new(12, 0, 1, 5, stipple);
        canvas.line([5.25, 11.0], [5.25, 1.0]);
        let found = rows(&mut canvas, 12);
        let column: String = (0..12).rev().map(|y| found[y].chars().nth(4).unwrap()).collect();
        assert_eq!(column, "011110011000");
        assert_eq!(&found[10][3..9], "011100");
    }

    #[test]
    fn strips_go_on_with_the_stipple_and_bands_change_nothing() {
        let stipple = |state: &mut State| {
            state.line.stipple = true;
            state.line.stipple_pattern = 0x5A5A;
            state.line.stipple_factor = 3;
        };
        let mut random = Random(12);
        let ends: Vec<[f64; 2]> =
            (0..400).map(|_| [random.between(-50.0, 306.0), random.between(-50.0, 306.0)]).collect();
        let mut pictures = vec![];
        for (threads, cut) in [(1, 64), (2, 17), (7, 1)] {
            let mut canvas = TestCanvas::new(256, 0, threads, cut, stipple);
            for (i, pair) in ends.windows(2).enumerate() {
                let v = [0, 1].map(|k: usize| crate::raster::testing::vertex(pair[k][0], pair[k][1], 0.5, 1.0));
                if i == 0 {
                    canvas.scene.restart_stipple();
                }
                canvas.scene.line([0, 1].map(|k: usize| VertexRef { head: &v[k], slots: &[] }), 1);
            }
            pictures.push(canvas.hits());
        }
        assert!(pictures[0].iter().sum::<u32>() > 20_000);
        assert!(pictures[0] == pictures[1] && pictures[0] == pictures[2]);
    }

    #[test]
    fn smooth_lines_cover_their_area() {
        let mut random = Random(13);
        for _ in 0..50 {
            let width = random.between(1.0, 6.0) as f32;
            let mut canvas = TestCanvas::new(64, 1, 1, 64, |state| {
                state.line.smooth = true;
                state.line.width = width;
            });
            let end = |random: &mut Random| {
                [random.between(8.0, 56.0), random.between(8.0, 56.0)].map(|v: f64| (v * 256.0).round() / 256.0)
            };
            let (a, b) = (end(&mut random), end(&mut random));
            canvas.line(a, b);
            let sum: f64 = canvas.seen().iter().map(|s| f64::from(s.coverage)).sum();
            let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt();
            assert!((sum - length * f64::from(width)).abs() < 1e-3 * length + 1e-3, "{sum} {length} {width}");
        }
    }

    #[test]
    fn values_run_along_the_line() {
        let mut canvas = TestCanvas::new(32, 1, 1, 64, |_| {});
        let v =
            [crate::raster::testing::vertex(2.0, 3.25, 0.0, 1.0), crate::raster::testing::vertex(18.0, 3.25, 1.0, 3.0)];
        let slots = [[0.0f32], [1.0]];
        canvas.scene.line([0, 1].map(|k: usize| VertexRef { head: &v[k], slots: &slots[k] }), 1);
        let seen = canvas.seen();
        assert_eq!(seen.len(), 16);
        for (i, s) in seen.iter().enumerate() {
            let t = (i as f64 + 0.5) / 16.0;
            let want = (t / 3.0) / ((1.0 - t) + t / 3.0);
            assert!((f64::from(s.values[0]) - want).abs() < 1e-6);
            assert!((s.z / 16_777_215.0 - t).abs() < 1e-9);
        }
    }
}
