//! Texels into S3TC blocks, for images that a program gives uncompressed under an S3TC name. The specification leaves the
//! choice of blocks open. Here the two colours of a block are those of its texels that lie farthest apart, and every
//! texel takes the nearest colour of the palette; alpha takes its extremes. Two different colours are always kept.

use super::format::S3tc;
use super::s3tc::{alpha_palette, color_palette};

/// The block of 16 texels (packed R, G, B, A); DXT1 uses the first 8 bytes.
#[must_use]
pub(super) fn encode(kind: S3tc, texels: &[u32; 16]) -> [u8; 16] {
    let mut block = [0; 16];
    match kind {
        S3tc::RgbDxt1 => block[..8].copy_from_slice(&encode_color(texels, false)),
        S3tc::RgbaDxt1 => block[..8].copy_from_slice(&encode_color(texels, texels.iter().any(|&t| t >> 24 < 128))),
        S3tc::RgbaDxt3 => {
            let alpha = |bits: u64, (i, &t): (usize, &u32)| bits | u64::from(((t >> 24) + 8) / 17) << (4 * i);
            let bits = texels.iter().enumerate().fold(0, alpha);
            block[..8].copy_from_slice(&bits.to_le_bytes());
            block[8..].copy_from_slice(&encode_color(texels, false));
        }
        S3tc::RgbaDxt5 => {
            block[..8].copy_from_slice(&encode_alpha(texels));
            block[8..].copy_from_slice(&encode_color(texels, false));
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

/// The square of the distance of two colours.
fn distance(a: u32, b: u32) -> u32 {
    (0..3).map(|i| ((a >> (8 * i)) as u8).abs_diff((b >> (8 * i)) as u8)).map(|d| u32::from(d).pow(2)).sum()
}

/// The nearest colour of 5, 6 and 5 bits.
fn to_565(t: u32) -> u16 {
    let channel = |shift: u32, max: u32| ((t >> shift & 0xFF) * max * 2 + 255) / 510;
    (channel(0, 31) << 11 | channel(8, 63) << 5 | channel(16, 31)) as u16
}

fn encode_color(texels: &[u32; 16], transparent: bool) -> [u8; 8] {
    let visible = |t: u32| !transparent || t >> 24 >= 128;
    let first = texels.iter().copied().find(|&t| visible(t)).unwrap_or(0);
    let mut ends = (first, first);
    for (i, &a) in texels.iter().enumerate().filter(|t| visible(*t.1)) {
        for &b in texels[i + 1..].iter().filter(|&&t| visible(t)) {
            if distance(a, b) > distance(ends.0, ends.1) {
                ends = (a, b);
            }
        }
    }
    let (mut c0, mut c1) = (to_565(ends.0), to_565(ends.1));
    // The order of the two colours says whether there is a transparent one.
    if (c0 < c1) != transparent {
        std::mem::swap(&mut c0, &mut c1);
    }
    // Equal colours read as the transparent kind in DXT1; its codes 0 to 2 are all that colour then.
    let palette = color_palette(c0, c1, transparent || c0 == c1);
    let colors = if transparent || c0 == c1 { 3 } else { 4 };
    let code = |t: u32| {
        if visible(t) { (0..colors).min_by_key(|&i| distance(palette[i], t)).unwrap_or(0) as u32 } else { 3 }
    };
    let codes = texels.iter().enumerate().fold(0, |bits, (i, &t)| bits | code(t) << (2 * i));
    let mut block = [0; 8];
    block[..2].copy_from_slice(&c0.to_le_bytes());
    block[2..4].copy_from_slice(&c1.to_le_bytes());
    block[4..].copy_from_slice(&codes.to_le_bytes());
    block
}
