//! Pixel zoom (OpenGL 1.5, sections 3.6.4 "Conversion to Fragments" and 3.6.5): which pixels of the window a rectangle of
//! groups covers, and which group each of them shows.
//!
//! ```text
//!   group (n, m) covers   x from xr + zx n to xr + zx (n + 1),   y from yr + zy m to yr + zy (m + 1)
//!   a pixel shows the group that its centre lies in, or on whose left or lower border it lies
//! ```

use crate::error::{Outcome, out_of_memory};

/// A vector of `len` defaults, or OUT_OF_MEMORY.
pub fn zeroed<T: Clone + Default>(len: usize) -> Outcome<Vec<T>> {
    let mut values = Vec::new();
    values
        .try_reserve_exact(len)
        .map_err(|_| out_of_memory(format!("no memory for a pixel rectangle of {len} groups; draw it in parts")))?;
    values.resize(len, T::default());
    Ok(values)
}

/// Where a rectangle of groups is in the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placement {
    /// The lower left pixel.
    pub origin: [i32; 2],
    /// For each column of pixels the column of groups that it shows.
    pub columns: Vec<u32>,
    /// For each row of pixels the row of groups that it shows.
    pub rows: Vec<u32>,
}

/// The first pixel along an axis, and for it and its successors in `window` which of `count` groups they show.
fn along(start: f64, zoom: f64, count: u32, window: [i32; 2]) -> Outcome<(i32, Vec<u32>)> {
    let border = |n: u32| start + zoom * f64::from(n);
    let (low, high) = if zoom < 0.0 { (border(count), border(0)) } else { (border(0), border(count)) };
    if low.is_nan() || high.is_nan() || window[0] >= window[1] {
        return Ok((window[0], Vec::new()));
    }
    // The first pixel whose centre lies at or beyond a border.
    let pixel = |at: f64| (at - 0.5).ceil().clamp(f64::from(window[0]), f64::from(window[1])) as i32;
    let (first, end) = (pixel(low), pixel(high));
    let mut groups = zeroed((end - first).max(0).unsigned_abs() as usize)?;
    let covers = |n: u32, centre: f64| {
        let (a, b) = (border(n), border(n + 1));
        let (a, b) = if a > b { (b, a) } else { (a, b) };
        a <= centre && centre < b
    };
    for (x, group) in (first..end).zip(&mut groups) {
        let centre = f64::from(x) + 0.5;
        // The quotient may be rounded across a border.
        let guess = ((centre - start) / zoom).clamp(0.0, f64::from(count - 1)) as u32;
        let near = [guess, guess.saturating_sub(1), guess.saturating_add(1).min(count - 1)];
        *group = near.into_iter().find(|n| covers(*n, centre)).unwrap_or(guess);
    }
    Ok((first, groups))
}

impl Placement {
    /// Of `size` groups at a raster position; only what lies within the columns and rows of `window` counts.
    pub fn new(size: [u32; 2], position: [f64; 2], zoom: [f32; 2], window: [[i32; 2]; 2]) -> Outcome<Self> {
        let [zx, zy] = zoom.map(f64::from);
        let (x, columns) = along(position[0], zx, size[0], window[0])?;
        let (y, rows) = along(position[1], zy, size[1], window[1])?;
        Ok(Self { origin: [x, y], columns, rows })
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.columns.len(), self.rows.len()]
    }

    /// What each pixel shows, row by row. `read` gives the groups from a column and a row on. Whatever the size of the
    /// rectangle, no more is read and kept than the window shows, but for a few times the width of a row.
    pub fn resolve<T: Copy + Default>(&self, mut read: impl FnMut([u32; 2], &mut [T])) -> Outcome<Vec<T>> {
        let width = self.columns.len();
        let mut pixels = zeroed(width * self.rows.len())?;
        let (Some(&first), Some(&last)) = (self.columns.iter().min(), self.columns.iter().max()) else {
            return Ok(pixels);
        };
        let shown = (last - first) as usize + 1;
        let is_unzoomed = self.columns.first() == Some(&first) && shown == width;
        // Where few of many groups are shown, those are read one by one.
        let mut row = zeroed(if is_unzoomed || shown > 4 * width { 0 } else { shown })?;
        let mut done: Option<u32> = None;
        for (i, &y) in self.rows.iter().enumerate() {
            let (before, rest) = pixels.split_at_mut(i * width);
            let Some(out) = rest.get_mut(..width) else { break };
            if done == Some(y)
                && let Some(same) = before.len().checked_sub(width).and_then(|at| before.get(at..))
            {
                out.copy_from_slice(same);
            } else if is_unzoomed {
                read([first, y], out);
            } else if row.is_empty() {
                self.columns.iter().zip(out).for_each(|(column, out)| read([*column, y], std::slice::from_mut(out)));
            } else {
                read([first, y], &mut row);
                for (column, out) in self.columns.iter().zip(out) {
                    *out = row.get((column - first) as usize).copied().unwrap_or_default();
                }
            }
            done = Some(y);
        }
        Ok(pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::{Placement, along};

    /// The groups that the pixels of a window show by the definition, `None` where there is none.
    fn defined(start: f64, zoom: f64, count: u32, window: [i32; 2]) -> Vec<Option<u32>> {
        let group = |x: i32| {
            let centre = f64::from(x) + 0.5;
            (0..count).find(|n| {
                let (a, b) = (start + zoom * f64::from(*n), start + zoom * f64::from(n + 1));
                a.min(b) <= centre && centre < a.max(b)
            })
        };
        (window[0]..window[1]).map(group).collect()
    }

    #[test]
    fn a_pixel_shows_the_group_that_its_centre_lies_in() {
        let mut state = 5_u64;
        let mut between = |low: f64, high: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * ((state >> 32) as f64 / 4_294_967_296.0)
        };
        for round in 0..3000 {
            let quarter = |v: f64| (v * 4.0).round() / 4.0;
            let (start, zoom) = (between(-4.0, 16.0), between(-4.0, 4.0));
            let (start, zoom) = match round % 3 {
                0 => (quarter(start), quarter(zoom)),
                1 => (start, zoom),
                _ => (start.floor(), 1.0),
            };
            let count = between(0.0, 9.0) as u32;
            let window = [between(0.0, 5.0) as i32, between(5.0, 17.0) as i32];
            let (first, groups) = along(start, zoom, count, window).expect("there is memory");
            let got = |x: i32| usize::try_from(x - first).ok().and_then(|i| groups.get(i)).copied();
            let got: Vec<_> = (window[0]..window[1]).map(got).collect();
            assert_eq!(got, defined(start, zoom, count, window), "start {start} zoom {zoom} count {count} {window:?}");
        }
    }

    #[test]
    fn what_is_read_is_what_the_pixels_show() {
        for zoom in [[1.0, 1.0], [2.5, 1.0], [-1.0, 1.0], [0.3, -2.0], [0.01, 0.02], [1e-6, 1.0]] {
            let size = [2_000_000, 700];
            let placed = Placement::new(size, [10.0, 9.0], zoom, [[2, 30], [0, 20]]).expect("there is memory");
            let mut read = 0;
            let pixels = placed
                .resolve(|[x, y], out: &mut [u64]| {
                    read += out.len();
                    (u64::from(x)..).zip(out).for_each(|(x, out)| *out = x << 32 | u64::from(y));
                })
                .expect("there is memory");
            let want = placed
                .rows
                .iter()
                .flat_map(|y| placed.columns.iter().map(move |x| u64::from(*x) << 32 | u64::from(*y)));
            assert!(pixels.iter().copied().eq(want), "{zoom:?}");
            assert!(read <= 4 * pixels.len() + 4, "{zoom:?}: {read} groups for {} pixels", pixels.len());
        }
    }

    #[test]
    fn wild_positions_and_zooms_are_harmless() {
        for start in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
            for zoom in [0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, 1e-300] {
                for count in [0, 1, 3, u32::MAX] {
                    let (_, groups) = along(start, zoom, count, [0, 16]).expect("there is memory");
                    assert!(groups.len() <= 16, "{start} {zoom}");
                }
            }
        }
    }
}
