//! Texels into S3TC blocks, for images that a program gives uncompressed under an S3TC name. The specification leaves the
//! choice of blocks open. The two colours of a block are those of its texels that lie farthest apart, and every texel
//! takes the nearest colour of the palette; alpha takes its extremes. Two different colours are always kept. Under
//! TEXTURE_COMPRESSION_HINT NICEST the two colours are then moved to where they fit best what the texels have chosen.

use crate::texture::format::{BlockFit, S3tc};
use crate::texture::s3tc::{alpha_palette, color_palette};

/// The block of 16 texels (packed R, G, B, A); DXT1 uses the first 8 bytes.
#[must_use]
pub(super) fn encode(kind: S3tc, texels: &[u32; 16], fit: BlockFit) -> [u8; 16] {
    let mut block = [0; 16];
    let color = |transparent: bool| encode_color(texels, transparent, fit);
    match kind {
        S3tc::RgbDxt1 => block[..8].copy_from_slice(&color(false)),
        S3tc::RgbaDxt1 => block[..8].copy_from_slice(&color(texels.iter().any(|&t| t >> 24 < 128))),
        S3tc::RgbaDxt3 => {
            let alpha = |bits: u64, (i, &t): (usize, &u32)| bits | u64::from(((t >> 24) + 8) / 17) << (4 * i);
            let bits = texels.iter().enumerate().fold(0, alpha);
            block[..8].copy_from_slice(&bits.to_le_bytes());
            block[8..].copy_from_slice(&color(false));
        }
        S3tc::RgbaDxt5 => {
            block[..8].copy_from_slice(&encode_alpha(texels));
            block[8..].copy_from_slice(&color(false));
        }
    }
    block
}

fn encode_alpha(texels: &[u32; 16]) -> [u8; 8] {
    let alphas = texels.map(|t| (t >> 24) as u8);
    let high = alphas.iter().copied().max().unwrap_or(0);
    let low = alphas.iter().copied().min().unwrap_or(0);
    let palette = alpha_palette(high, low);
    let code = |a: u8| (0..8).min_by_key(|&i| palette[i].abs_diff(a)).unwrap_or(0) as u64;
    let codes = alphas.iter().enumerate().fold(0, |bits, (i, &a)| bits | code(a) << (3 * i));
    let mut block = (codes << 16).to_le_bytes();
    block[0] = high;
    block[1] = low;
    block
}

/// R, G or B of a texel.
fn channel(t: u32, i: usize) -> u8 {
    (t >> (8 * i)) as u8
}

/// The square of the distance of two colours.
fn distance(a: u32, b: u32) -> u32 {
    (0..3).map(|i| u32::from(channel(a, i).abs_diff(channel(b, i))).pow(2)).sum()
}

/// The largest value of 5, 6 and 5 bits.
const MAX_565: [u16; 3] = [31, 63, 31];

/// The nearest colour of 5, 6 and 5 bits to one in 0..=255.
fn to_565(color: [f64; 3]) -> u16 {
    let part = |i: usize| (color[i].clamp(0.0, 255.0) * f64::from(MAX_565[i]) / 255.0 + 0.5) as u16;
    part(0) << 11 | part(1) << 5 | part(2)
}

/// A block of colours: its two colours, and what each texel takes of them.
#[derive(Clone, Copy)]
struct Colors {
    ends: [u16; 2],
    codes: [u8; 16],
    /// The sum of the squared distances.
    error: u32,
}

/// Texels of which some may be transparent in the way of DXT1: those with an alpha below 128 take code 3.
struct ColorBlock<'a> {
    texels: &'a [u32; 16],
    transparent: bool,
}

impl ColorBlock<'_> {
    fn visible(&self, t: u32) -> bool {
        !self.transparent || t >> 24 >= 128
    }

    /// The two texels that lie farthest apart.
    fn extremes(&self) -> [u32; 2] {
        let mut visible = self.texels.iter().copied().enumerate().filter(|&(_, t)| self.visible(t)).peekable();
        let first = visible.peek().map_or(0, |&(_, t)| t);
        let mut ends = [first; 2];
        for (i, a) in visible {
            for &b in self.texels[i + 1..].iter().filter(|&&t| self.visible(t)) {
                if distance(a, b) > distance(ends[0], ends[1]) {
                    ends = [a, b];
                }
            }
        }
        ends
    }

    /// Every texel takes the nearest colour.
    fn choose(&self, [mut c0, mut c1]: [u16; 2]) -> Colors {
        // The order of the two colours says whether there is a transparent one.
        if (c0 < c1) != self.transparent {
            std::mem::swap(&mut c0, &mut c1);
        }
        // Equal colours read as the transparent kind in DXT1; its codes 0 to 2 are all that colour then.
        let three = self.transparent || c0 == c1;
        let palette = color_palette(c0, c1, three);
        let palette = &palette[..if three { 3 } else { 4 }];
        let mut colors = Colors { ends: [c0, c1], codes: [3; 16], error: 0 };
        for (code, &t) in colors.codes.iter_mut().zip(self.texels).filter(|(_, t)| self.visible(**t)) {
            let nearest = (0u8..).zip(palette).map(|(i, &p)| (distance(p, t), i)).min().unwrap_or((0, 0));
            *code = nearest.1;
            colors.error += nearest.0;
        }
        colors
    }

    /// The pair of colours that fits best what the texels have chosen, if they determine one: with s the share of the
    /// first colour in a texel's choice, the a and b that make the sum of (s a + (1 - s) b - texel)^2 least.
    fn fit(&self, colors: &Colors) -> Option<[u16; 2]> {
        let shares = if self.transparent { [1.0, 0.0, 0.5, 0.0] } else { [1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0] };
        let (mut aa, mut ab, mut bb, mut at, mut bt) = (0.0, 0.0, 0.0, [0.0; 3], [0.0; 3]);
        for (&code, &t) in colors.codes.iter().zip(self.texels).filter(|(_, t)| self.visible(**t)) {
            let s = shares[usize::from(code & 3)];
            let r = 1.0 - s;
            (aa, ab, bb) = (aa + s * s, ab + s * r, bb + r * r);
            for i in 0..3 {
                at[i] += s * f64::from(channel(t, i));
                bt[i] += r * f64::from(channel(t, i));
            }
        }
        let determinant: f64 = aa * bb - ab * ab;
        if determinant < 1e-6 {
            return None;
        }
        let a = std::array::from_fn(|i| (bb * at[i] - ab * bt[i]) / determinant);
        let b = std::array::from_fn(|i| (aa * bt[i] - ab * at[i]) / determinant);
        Some([to_565(a), to_565(b)])
    }
}

fn encode_color(texels: &[u32; 16], transparent: bool, fit: BlockFit) -> [u8; 8] {
    let given = ColorBlock { texels, transparent };
    let of_texel = |t: u32| to_565(std::array::from_fn(|i| f64::from(channel(t, i))));
    let mut colors = given.choose(given.extremes().map(of_texel));
    // The error is a whole number that becomes less each time, so this ends.
    while fit == BlockFit::LeastSquares
        && let Some(better) = given.fit(&colors).map(|ends| given.choose(ends))
        && better.error < colors.error
    {
        colors = better;
    }
    let codes = colors.codes.iter().enumerate().fold(0, |bits, (i, &code)| bits | u32::from(code) << (2 * i));
    let mut block = [0; 8];
    block[..2].copy_from_slice(&colors.ends[0].to_le_bytes());
    block[2..4].copy_from_slice(&colors.ends[1].to_le_bytes());
    block[4..].copy_from_slice(&codes.to_le_bytes());
    block
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::s3tc::split_565;

    /// The squared error of a block's colours.
    fn error(texels: &[u32; 16], kind: S3tc, fit: BlockFit) -> u32 {
        let shown = kind.decode(&encode(kind, texels, fit));
        shown.iter().zip(texels).map(|(&a, &b)| distance(a, b)).sum()
    }

    #[test]
    fn the_fit_is_never_worse_and_mostly_better() {
        let mut random = 7u32;
        let mut next = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            random >> 8
        };
        let (mut sums, mut better) = ([0u64; 2], 0);
        for _ in 0..2000 {
            let (a, b) = (next(), next());
            // Noise around the line between two colours, some of it transparent.
            let texels: [u32; 16] = std::array::from_fn(|_| {
                let (s, noise) = (next() % 256, [next(), next(), next()]);
                let of = |i: usize| {
                    let mean = (u32::from(channel(a, i)) * s + u32::from(channel(b, i)) * (255 - s)) / 255;
                    (mean + noise[i] % 24).min(255) << (8 * i)
                };
                of(0) | of(1) | of(2) | if next() % 8 == 0 { 0 } else { 0xFF00_0000 }
            });
            for kind in [S3tc::RgbDxt1, S3tc::RgbaDxt5] {
                let errors = [BlockFit::Extremes, BlockFit::LeastSquares].map(|fit| error(&texels, kind, fit));
                assert!(errors[1] <= errors[0], "{texels:x?}");
                better += u32::from(errors[1] < errors[0]);
                sums = [0, 1].map(|i| sums[i] + u64::from(errors[i]));
            }
            let shown = S3tc::RgbaDxt1.decode(&encode(S3tc::RgbaDxt1, &texels, BlockFit::LeastSquares));
            assert!(shown.iter().zip(texels).all(|(a, b)| a >> 24 == b >> 24), "holes stay where they are");
        }
        assert!(better > 3000, "{better} of 4000");
        assert!(2 * sums[1] < sums[0] + sums[0] / 2, "{sums:?}");
    }

    #[test]
    fn a_ramp_gets_its_ends_back() {
        // Sixteen greys: two texels of the ends and noise free steps; least squares finds colours beyond the second.
        let texels: [u32; 16] = std::array::from_fn(|i| 0xFF00_0000 | (0x0001_0101 * (i as u32 * 17)));
        let [low, high] = [BlockFit::LeastSquares, BlockFit::Extremes].map(|fit| error(&texels, S3tc::RgbDxt1, fit));
        assert!(low < high, "{low} {high}");
        let [a, b] = [0, 2].map(|at| {
            let block = encode(S3tc::RgbDxt1, &texels, BlockFit::LeastSquares);
            split_565(u16::from_le_bytes([block[at], block[at + 1]]))
        });
        assert!(a[0] > b[0], "the first colour is the brighter one: {a:?} {b:?}");
    }
}
