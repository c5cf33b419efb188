//! Images as GLU works on them, and the one filter of GLU: the box (GLU 1.3, chapter 3).
//!
//! A [`Grid`] holds four floats a texel, unclamped and before pixel transfer, so that what a level holds goes through the
//! GL once, like an image of the program. The filter gives each new texel the mean of a box of old ones, axis by axis
//! (the box is separable). It is used for every halving of a mipmap, for the fit to a power of two and for
//! `gluScaleImage`; only where the box lies differs ([`Kernel`]).

use crate::pixels::format::{PixelFormat, PixelKind};
use crate::pixels::unpack::ClientImage;

/// An image of one to three dimensions; colours as R, G, B, A (a luminance in R, G and B), indices and depths in R.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    /// Width, height and depth: all at least 1.
    pub size: [usize; 3],
    /// The texels, rows from the bottom up, then slices.
    pub texels: Vec<[f32; 4]>,
}

/// Where the box of a new texel lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kernel {
    /// Over the area of the new texel: what is inside counts as far as it is inside. The mean of the image stays.
    Area,
    /// As `Area` where the image shrinks. Where it grows, a box of one old texel around the new texel's centre, going
    /// round to the other side at the edges: what `gluScaleImage` does.
    Centred,
}

/// A vector of `len` copies, or `None` if there is no memory for it.
pub(super) fn try_vec<T: Clone>(len: usize, value: T) -> Option<Vec<T>> {
    let mut v = Vec::new();
    v.try_reserve_exact(len).ok()?;
    v.resize(len, value);
    Some(v)
}

impl Grid {
    /// An image in client memory, as it stands there; `None` if there is no memory for it.
    pub fn unpack(image: &ClientImage<'_>) -> Option<Grid> {
        let size @ [width, height, depth] = image.size();
        let count = width.checked_mul(height)?.checked_mul(depth)?;
        let mut texels = try_vec(count, [0.0, 0.0, 0.0, 1.0])?;
        let mut numbers = try_vec(width, 0.0f64)?;
        for (row, texels) in texels.chunks_exact_mut(width.max(1)).enumerate() {
            let at = [0, row % height, row / height];
            match image.pixel().kind() {
                PixelKind::Color => image.components(at, texels),
                PixelKind::Index | PixelKind::Stencil => {
                    image.raw_indices(at, &mut numbers);
                    texels.iter_mut().zip(&numbers).for_each(|(texel, n)| texel[0] = *n as f32);
                }
                PixelKind::Depth | PixelKind::DepthStencil => {
                    let mut depths = try_vec(width, 0.0f32)?;
                    image.depths(at, crate::pixels::transfer::Transfer::NEUTRAL, &mut depths);
                    texels.iter_mut().zip(&depths).for_each(|(texel, d)| texel[0] = *d);
                }
            }
        }
        Some(Grid { size, texels })
    }

    /// The components that a format has, one after the other, ready to be handed to the GL with the type `GL_FLOAT`.
    pub fn components(&self, pixel: PixelFormat) -> Option<Vec<f32>> {
        let channels = pixel.format.channels();
        let mut out = Vec::new();
        out.try_reserve_exact(self.texels.len().checked_mul(channels.len())?).ok()?;
        for texel in &self.texels {
            out.extend(channels.iter().map(|&c| texel[c & 3]));
        }
        Some(out)
    }

    /// The image in another size; `None` if there is no memory for it.
    pub fn resized(self, size: [usize; 3], kernel: Kernel) -> Option<Grid> {
        let mut grid = self;
        for (axis, &len) in size.iter().enumerate() {
            if grid.size[axis] != len {
                grid = grid.resized_along(axis, len, kernel)?;
            }
        }
        Some(grid)
    }

    /// Makes the next level of a mipmap of it: half the size in every dimension that is not 1 yet.
    pub fn halve(&mut self) -> Option<()> {
        let size = self.size.map(|n| (n / 2).max(1));
        let old = std::mem::replace(self, Grid { size: [0; 3], texels: Vec::new() });
        *self = old.resized(size, Kernel::Area)?;
        Some(())
    }

    fn resized_along(self, axis: usize, len: usize, kernel: Kernel) -> Option<Grid> {
        let old = self.size[axis];
        let mut size = self.size;
        size[axis] = len;
        // Texels of one line along the axis are `stride` apart, and lines of one kind follow in blocks.
        let stride: usize = self.size[..axis].iter().product();
        let count = size.iter().try_fold(1usize, |n, &d| n.checked_mul(d))?;
        let mut texels = try_vec(count, [0.0f32; 4])?;
        let boxes = Boxes::new(old, len, kernel)?;
        let blocks =
            texels.chunks_exact_mut((stride * len).max(1)).zip(self.texels.chunks_exact((stride * old).max(1)));
        for (to, from) in blocks {
            for (j, to) in to.chunks_exact_mut(stride).enumerate() {
                let taps = boxes.taps(j);
                // Every halving of an even size: whole lines at once.
                if let [(a, wa), (b, wb)] = *taps
                    && let (Some(a), Some(b)) = (from.get(a * stride..), from.get(b * stride..))
                {
                    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
                        *to = std::array::from_fn(|c| (wa * f64::from(a[c]) + wb * f64::from(b[c])) as f32);
                    }
                    continue;
                }
                for (i, to) in to.iter_mut().enumerate() {
                    let mut sum = [0.0f64; 4];
                    for &(k, weight) in taps {
                        let texel = from.get(k * stride + i).copied().unwrap_or_default();
                        for (sum, c) in sum.iter_mut().zip(texel) {
                            *sum += weight * f64::from(c);
                        }
                    }
                    *to = sum.map(|v| v as f32);
                }
            }
        }
        Some(Grid { size, texels })
    }
}

/// For every new texel of a line the old ones in its box, with the part of the box that each fills.
struct Boxes {
    taps: Vec<(usize, f64)>,
    ends: Vec<usize>,
}

impl Boxes {
    fn new(old: usize, new: usize, kernel: Kernel) -> Option<Boxes> {
        let mut boxes = Boxes { taps: Vec::new(), ends: Vec::new() };
        boxes.ends.try_reserve_exact(new).ok()?;
        boxes.taps.try_reserve(old.checked_add(new.checked_mul(2)?)?).ok()?;
        // Exact as long as the products fit into 53 bits, which sizes of images do.
        let edge = |j: usize| (j * old) as f64 / new as f64;
        for j in 0..new {
            let (low, high) = if kernel == Kernel::Centred && new > old {
                let centre = ((2 * j + 1) * old) as f64 / (2 * new) as f64;
                (centre - 0.5, centre + 0.5)
            } else {
                (edge(j), edge(j + 1))
            };
            let mut k = if low < 0.0 { -1i64 } else { low as i64 };
            while (k as f64) < high {
                let part = high.min((k + 1) as f64) - low.max(k as f64);
                if part > 0.0 {
                    boxes.taps.push((k.rem_euclid(old as i64) as usize, part / (high - low)));
                }
                k += 1;
            }
            boxes.ends.push(boxes.taps.len());
        }
        Some(boxes)
    }

    fn taps(&self, j: usize) -> &[(usize, f64)] {
        let start = if j == 0 { 0 } else { self.ends.get(j - 1).copied().unwrap_or(0) };
        let end = self.ends.get(j).copied().unwrap_or(start);
        self.taps.get(start..end).unwrap_or(&[])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(values: &[f32]) -> Grid {
        Grid { size: [values.len(), 1, 1], texels: values.iter().map(|&v| [v, v * 2.0, -v, 1.0]).collect() }
    }

    fn reds(grid: &Grid) -> Vec<f32> {
        grid.texels.iter().map(|t| t[0]).collect()
    }

    #[test]
    fn halving_is_the_mean() {
        let mut grid = line(&[0.0, 100.0, 200.0, 255.0]);
        grid.halve().expect("memory");
        assert_eq!(reds(&grid), [50.0, 227.5]);
        assert_eq!(grid.texels[1], [227.5, 455.0, -227.5, 1.0]);
        grid.halve().expect("memory");
        assert_eq!(reds(&grid), [138.75]);
        let mut cube = Grid { size: [2, 2, 2], texels: (0..8).map(|i| [i as f32; 4]).collect() };
        cube.halve().expect("memory");
        assert_eq!((cube.size, cube.texels), ([1; 3], vec![[3.5; 4]]));
    }

    #[test]
    fn areas_keep_the_mean_and_stay_inside() {
        for old in 1..40usize {
            let values: Vec<f32> = (0..old).map(|i| ((i * 37) % 101) as f32).collect();
            let mean = values.iter().sum::<f32>() / old as f32;
            for new in 1..40usize {
                let grid = line(&values).resized([new, 1, 1], Kernel::Area).expect("memory");
                let reds = reds(&grid);
                assert!((reds.iter().sum::<f32>() / new as f32 - mean).abs() < 1e-4, "{old} to {new}");
                assert!(reds.iter().all(|v| (0.0..=100.01).contains(v)), "{old} to {new}");
            }
        }
        // Six texels on eight: the values that the original GLU makes of a ramp, without its truncation.
        let ramp = line(&[0.0, 50.0, 100.0, 150.0, 200.0, 250.0]).resized([8, 1, 1], Kernel::Area).expect("memory");
        let want = [0.0, 100.0 / 3.0, 200.0 / 3.0, 100.0, 150.0, 550.0 / 3.0, 650.0 / 3.0, 250.0];
        assert!(reds(&ramp).iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-4), "{ramp:?}");
    }

    #[test]
    fn two_dimensions_are_two_times_one() {
        let texels: Vec<[f32; 4]> = (0..15).map(|i| [(i * i % 17) as f32; 4]).collect();
        let grid = Grid { size: [5, 3, 1], texels };
        let both = grid.clone().resized([2, 2, 1], Kernel::Area).expect("memory");
        let across = grid.resized([2, 3, 1], Kernel::Area).expect("memory");
        assert_eq!(both, across.resized([2, 2, 1], Kernel::Area).expect("memory"));
    }

    #[test]
    fn a_constant_stays_constant() {
        for kernel in [Kernel::Area, Kernel::Centred] {
            for new in [1, 2, 3, 7, 13, 64] {
                let grid = line(&[0.7; 9]).resized([new, 1, 1], kernel).expect("memory");
                assert!(reds(&grid).iter().all(|v| *v == 0.7), "{kernel:?} {new} {:?}", reds(&grid));
            }
        }
    }
}
