//! Test images: texels that are exact in 8 bits, expanded to what a base format reads (table 3.20).

use super::Random;
use crate::oracle::texel::{Image, Texture};
use crate::oracle::{V4, scale};
use fixedgl::enums::*;

/// Every base format of a colour texture.
pub const BASE_FORMATS: [GLenum; 6] = [GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA];

/// A colour of four bytes.
pub fn bytes(c: [u8; 4]) -> V4 {
    scale(c.map(f64::from), 1.0 / 255.0)
}

/// What a texture of this base format reads where RGBA was given.
pub fn expand(base: GLenum, [r, g, b, a]: V4) -> V4 {
    match base {
        GL_ALPHA => [0.0, 0.0, 0.0, a],
        GL_LUMINANCE => [r, r, r, 1.0],
        GL_LUMINANCE_ALPHA => [r, r, r, a],
        GL_INTENSITY => [r; 4],
        GL_RGB => [r, g, b, 1.0],
        _ => [r, g, b, a],
    }
}

/// Every texel has another colour: (i, j, k + 64 * level) in the channels.
pub fn numbered(size: [i64; 3], border: [i64; 3], level: i64) -> Image {
    Image::new(size, border, |[i, j, k]| bytes([byte(i * 3 + 9), byte(j * 3 + 9), byte(k * 16 + level * 40 + 17), 255]))
}

fn byte(v: i64) -> u8 {
    v.rem_euclid(256) as u8
}

/// Noise in all four channels.
pub fn noise(size: [i64; 3], border: [i64; 3], seed: u64, base: GLenum) -> Image {
    let random = std::cell::RefCell::new(Random(seed * 2 + 1));
    Image::new(size, border, |_| {
        let r = random.borrow_mut().bits();
        expand(base, bytes([(r >> 56) as u8, (r >> 48) as u8, (r >> 40) as u8, (r >> 32) as u8]))
    })
}

/// A whole chain of levels from `size` down to 1, each made by `f(size, level)`.
pub fn chain(target: GLenum, base: GLenum, size: [i64; 3], f: impl Fn([i64; 3], i64) -> Image) -> Texture {
    let faces = if target == GL_TEXTURE_CUBE_MAP { 6 } else { 1 };
    let largest = size.iter().max().copied().unwrap_or(1);
    let levels = (0..=largest.ilog2()).map(|l| {
        let size = size.map(|n| (n >> l).max(1));
        (0..faces).map(|face| f(size, i64::from(l) + 8 * face)).collect()
    });
    Texture::new(target, base, levels.collect())
}

/// One level, NEAREST.
pub fn nearest(mut texture: Texture) -> Texture {
    texture.lod.min_filter = GL_NEAREST;
    texture.lod.mag_filter = GL_NEAREST;
    texture
}
