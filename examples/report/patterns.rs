//! Textures made by code and the levels below them. A pyramid is computed in floats from its base, and each level is
//! rounded to bytes once, so that the oracle and every GL are given the same bytes. Two kernels reduce an image: the box
//! (each texel is the mean of what it covers, also where a side is odd) and Lanczos with three lobes, which keeps more
//! of what a level can show.

use super::oracle::texel::{Image, Texture};
use super::oracle::{V4, clamp01};
use fixedgl::enums::*;
use std::f64::consts::PI;

/// How a level is made from the one above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kernel {
    /// The mean of the texels that it covers.
    Box,
    /// sinc(x) sinc(x / 3).
    Lanczos,
}

/// A number that looks random, from 0 to 1.
pub fn noise(x: i64, y: i64) -> f64 {
    let mut h = (x as u32).wrapping_mul(0x9E37_79B1) ^ (y as u32).wrapping_mul(0x85EB_CA77);
    h = (h ^ (h >> 15)).wrapping_mul(0x2C1B_3C6D);
    h = (h ^ (h >> 12)).wrapping_mul(0x297A_2D39);
    f64::from((h ^ (h >> 15)) >> 8) / f64::from(1u32 << 24)
}

/// What a byte keeps of a colour.
fn rounded(c: V4) -> V4 {
    clamp01(c).map(|v| (v * 255.0).round() / 255.0)
}

/// An image of bytes from a function of the texel.
pub fn image(width: i64, height: i64, f: impl Fn(i64, i64) -> V4) -> Image {
    Image::from_fn(width, height, |i, j| rounded(f(i, j)))
}

/// An opaque grey.
fn grey(v: f64) -> V4 {
    [v, v, v, 1.0]
}

/// Squares of 8 texels, light and dark, with noise of 30 steps to either side.
pub fn checks(size: i64) -> Image {
    image(size, size, |i, j| {
        let base = if ((i / 8) ^ (j / 8)) & 1 == 0 { 225.0 } else { 30.0 };
        grey((base + 60.0 * noise(i, j) - 30.0) / 255.0)
    })
}

/// The same in two colours.
pub fn colored_checks(size: i64, cell: i64, a: [f64; 3], b: [f64; 3]) -> Image {
    image(size, size, |i, j| {
        let c = if ((i / cell) ^ (j / cell)) & 1 == 0 { a } else { b };
        let n = 0.15 * (noise(i, j) - 0.5);
        [c[0] + n, c[1] + n, c[2] + n, 1.0]
    })
}

/// Rings whose frequency grows with the radius, to 0.4 periods a texel at the middle of an edge.
pub fn zone_plate(size: i64) -> Image {
    let half = size as f64 / 2.0;
    image(size, size, |i, j| {
        let (x, y) = (i as f64 + 0.5 - half, j as f64 + 0.5 - half);
        grey(0.5 + 0.5 * (PI * 0.4 / half * (x * x + y * y)).cos())
    })
}

/// Light and dark spokes, each edge smooth over a texel.
pub fn star(size: i64, spokes: f64) -> Image {
    let half = size as f64 / 2.0;
    image(size, size, |i, j| {
        let (x, y) = (i as f64 + 0.5 - half, j as f64 + 0.5 - half);
        let r = x.hypot(y).max(0.5);
        let wave = (spokes * y.atan2(x)).sin();
        grey(0.5 + 0.5 * (wave * (r / spokes).max(0.25)).clamp(-1.0, 1.0))
    })
}

/// A disc of light with rings in it, dark at its edge.
pub fn spot(size: i64) -> Image {
    let half = size as f64 / 2.0;
    image(size, size, |i, j| {
        let (x, y) = (i as f64 + 0.5 - half, j as f64 + 0.5 - half);
        let r = x.hypot(y) / half;
        let edge = ((0.95 - r) / 0.1).clamp(0.0, 1.0);
        let rings = if (r * 9.0) as i64 % 2 == 0 { 1.0 } else { 0.55 };
        [edge * rings, edge * rings * 0.95, edge * 0.8, 1.0]
    })
}

/// A sky, a horizon of dark and light posts and a chequered ground, as a sphere map.
pub fn surroundings(size: i64) -> Image {
    let half = size as f64 / 2.0;
    image(size, size, |i, j| {
        let (x, y) = ((i as f64 + 0.5 - half) / half, (j as f64 + 0.5 - half) / half);
        let r2 = (x * x + y * y).min(1.0);
        let up = 2.0 * y * (1.0 - r2).sqrt();
        let around = x.atan2(1.0 - 2.0 * r2) / PI;
        if up > 0.12 {
            [0.35 + 0.3 * (1.0 - up), 0.55 + 0.25 * (1.0 - up), 0.95, 1.0]
        } else if up > -0.08 {
            if (around * 24.0).floor() as i64 % 2 == 0 { [0.1, 0.1, 0.12, 1.0] } else { [0.95, 0.9, 0.8, 1.0] }
        } else {
            let (u, v) = (x * 2.0 / -up, (1.0 - 2.0 * r2) * 2.0 / -up);
            if (u.floor() as i64 + v.floor() as i64) & 1 == 0 { [0.5, 0.3, 0.2, 1.0] } else { [0.8, 0.7, 0.5, 1.0] }
        }
    })
}

/// A leaf on a transparent ground.
pub fn sprite(width: i64, height: i64) -> Image {
    image(width, height, |i, j| {
        let (x, y) = ((i as f64 + 0.5) / width as f64 * 2.0 - 1.0, (j as f64 + 0.5) / height as f64 * 2.0 - 1.0);
        let inside = 1.0 - (x * x + 2.5 * (y - 0.3 * (3.0 * x).sin()).powi(2));
        let alpha = (inside * 6.0).clamp(0.0, 1.0);
        let vein = if (x * 14.0).fract().abs() < 0.3 { 0.35 } else { 0.75 };
        [0.3 * vein + 0.2 * noise(i, j), vein, 0.15, alpha]
    })
}

/// The weights of the texels of a line of `n` for texel `i` of a line of `m`: (first texel, weights).
fn weights(kernel: Kernel, n: i64, m: i64, i: i64) -> (i64, Vec<f64>) {
    let ratio = n as f64 / m as f64;
    let (low, high) = (i as f64 * ratio, (i + 1) as f64 * ratio);
    let (first, mut w): (i64, Vec<f64>) = match kernel {
        _ if n == m => (i, vec![1.0]),
        Kernel::Box => {
            let first = low.floor() as i64;
            let share = |t: i64| ((t + 1) as f64).min(high) - (t as f64).max(low);
            (first, (first..high.ceil() as i64).map(share).collect())
        }
        Kernel::Lanczos => {
            let centre = (low + high) / 2.0;
            let first = (centre - 3.0 * ratio).ceil() as i64;
            let sinc = |x: f64| if x == 0.0 { 1.0 } else { (PI * x).sin() / (PI * x) };
            let weight = |t: i64| {
                let x = (t as f64 + 0.5 - centre) / ratio;
                if x.abs() < 3.0 { sinc(x) * sinc(x / 3.0) } else { 0.0 }
            };
            (first, (first..(centre + 3.0 * ratio).floor() as i64).map(weight).collect())
        }
    };
    let sum: f64 = w.iter().sum();
    w.iter_mut().for_each(|v| *v /= sum);
    (first, w)
}

/// The next level of an image that repeats, not rounded.
fn reduced(kernel: Kernel, image: &Image) -> Image {
    let [w, h, _] = image.size;
    let (half_w, half_h) = ((w / 2).max(1), (h / 2).max(1));
    let sum = |from: &Image, line: (i64, Vec<f64>), at: &dyn Fn(i64) -> [i64; 3]| -> V4 {
        let mut sum = [0.0; 4];
        for (k, weight) in line.1.iter().enumerate() {
            let texel = from.texel(at(line.0 + k as i64)).unwrap_or([0.0; 4]);
            sum = std::array::from_fn(|c| sum[c] + weight * texel[c]);
        }
        sum
    };
    let rows =
        Image::from_fn(half_w, h, |i, j| sum(image, weights(kernel, w, half_w, i), &|t| [t.rem_euclid(w), j, 0]));
    Image::from_fn(half_w, half_h, |i, j| sum(&rows, weights(kernel, h, half_h, j), &|t| [i, t.rem_euclid(h), 0]))
}

/// All levels of an image, each rounded once.
pub fn pyramid(kernel: Kernel, base: &Image) -> Vec<Vec<Image>> {
    let bytes = |image: &Image| {
        let texels = image.texels.iter().map(|&c| rounded(c)).collect();
        Image { size: image.size, border: image.border, texels }
    };
    let mut levels = vec![vec![bytes(base)]];
    let mut level = base.clone();
    while level.size[0] > 1 || level.size[1] > 1 {
        level = reduced(kernel, &level);
        levels.push(vec![bytes(&level)]);
    }
    levels
}

/// A texture with all its levels, trilinear.
pub fn texture(base: &Image) -> Texture {
    let mut texture = Texture::new(GL_TEXTURE_2D, GL_RGBA, pyramid(Kernel::Box, base));
    texture.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    texture
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_keep_the_mean() {
        for kernel in [Kernel::Box, Kernel::Lanczos] {
            for (n, m) in [(8, 4), (9, 4), (100, 50), (25, 12), (3, 1), (1, 1)] {
                let mut share = vec![0.0; n as usize];
                for i in 0..m {
                    let (first, w) = weights(kernel, n, m, i);
                    assert!((w.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                    for (k, v) in w.iter().enumerate() {
                        share[(first + k as i64).rem_euclid(n) as usize] += v;
                    }
                }
                if kernel == Kernel::Box {
                    let even = m as f64 / n as f64;
                    assert!(share.iter().all(|s| (s - even).abs() < 1e-12), "{n} to {m}: {share:?}");
                }
            }
        }
    }

    #[test]
    fn the_last_level_is_the_mean() {
        let base = image(100, 60, |i, j| [noise(i, j), 0.0, 0.0, 1.0]);
        let mean = base.texels.iter().map(|c| c[0]).sum::<f64>() / 6000.0;
        let levels = pyramid(Kernel::Box, &base);
        assert_eq!(levels.iter().map(|l| l[0].size[0]).collect::<Vec<_>>(), [100, 50, 25, 12, 6, 3, 1]);
        assert!((levels[6][0].texels[0][0] - mean).abs() <= 0.5 / 255.0 + 1e-12);
    }
}
