//! Levels made from a level (OpenGL 1.5, section 3.8.8, GENERATE_MIPMAP; GenerateMipmap; GLU). The specification leaves
//! the filter open and recommends a box. A dimension of even size n = 2m takes the mean of each two texels. An odd size
//! n = 2m + 1 takes three texels with the weights (m - i, m, i + 1)/n, the exact share that m equal texels have in n: so
//! the mean of the image stays the mean. Dimensions are reduced one after the other, so 1D, 2D and 3D are one filter.
//!
//! A chain of levels is computed in floats from its base and each level is rounded once, on its way into its image, so
//! the rounding of one level never reaches the next.

use super::image::{Image, Texels, zeroed};
use crate::error::Outcome;

/// Groups of four floats in a box, the first dimension fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Texels in each dimension, with the border.
    pub size: [usize; 3],
    /// The texels.
    pub texels: Vec<[f32; 4]>,
}

/// The size of the next level: half of each dimension, rounded down, at least 1.
#[must_use]
pub fn next_size(size: [u32; 3]) -> [u32; 3] {
    size.map(|n| (n / 2).max(1))
}

/// How many levels follow an image of this size, down to 1 x 1 x 1.
#[must_use]
pub fn levels_below(size: [u32; 3]) -> usize {
    size.into_iter().max().and_then(u32::checked_ilog2).unwrap_or(0) as usize
}

/// The levels below `base`, the first half its size: `count` of them, or as many as there are down to 1 x 1 x 1.
pub fn levels(base: &Image, count: usize) -> Outcome<Vec<Image>> {
    let mut made: Vec<Image> = Vec::new();
    if base.is_null() {
        return Ok(made);
    }
    let mut size = [base.width, base.height, base.depth];
    let mut level = None;
    for _ in 0..count.min(levels_below(size)) {
        let next = match &level {
            None => first_reduction(base)?,
            Some(level) => reduce(level, base.border as usize)?,
        };
        size = next_size(size);
        made.push(to_image(base, size, &next)?);
        level = Some(next);
    }
    Ok(made)
}

/// The next level of `level`. With a border (1) the outer texels are a border: they are reduced along the edges that
/// they lie on and stay a border.
pub fn reduce(level: &Level, border: usize) -> Outcome<Level> {
    let [w, h, d] = level.size;
    if border == 0 && d == 1 && w % 2 == 0 && h % 2 == 0 {
        return quarter(w, |at| level.texels.get(at..at + w).unwrap_or(&[]), h, |&t| t);
    }
    let mut level = reduce_axis(level, 0, border)?;
    for axis in 1..3 {
        level = reduce_axis(&level, axis, border)?;
    }
    Ok(level)
}

/// The first reduction reads the image itself where the short way applies.
fn first_reduction(base: &Image) -> Outcome<Level> {
    let (w, h) = (base.width as usize, base.height as usize);
    if base.border == 0 && base.depth == 1 && w % 2 == 0 && h % 2 == 0 {
        let (origin, stride) = (base.origin(), base.row_stride());
        let at = |tight: usize| origin + tight / w * stride;
        match base.own_texels() {
            Texels::Rgba8(t) => return quarter(w, |y| t.get(at(y)..at(y) + w).unwrap_or(&[]), h, numbers),
            Texels::Float(t) => return quarter(w, |y| t.get(at(y)..at(y) + w).unwrap_or(&[]), h, |&t| t),
            Texels::Depth(_) => {}
        }
    }
    reduce(&from_image(base)?, base.border as usize)
}

/// A packed texel as whole numbers from 0 to 255: sums of those are exact.
#[inline]
fn numbers(texel: &u32) -> [f32; 4] {
    texel.to_le_bytes().map(f32::from)
}

/// The mean of each 2 x 2 texels: both dimensions at once. `row` gives the row that begins at an index of a tight image.
fn quarter<'a, T: 'a>(
    w: usize,
    row: impl Fn(usize) -> &'a [T],
    h: usize,
    fetch: impl Fn(&T) -> [f32; 4],
) -> Outcome<Level> {
    let size = [w / 2, h / 2, 1];
    let mut texels = zeroed(size[0] * size[1], [0.0; 4])?;
    for (y, out) in texels.chunks_exact_mut(size[0]).enumerate() {
        let (upper, lower) = (row(2 * y * w), row((2 * y + 1) * w));
        let pairs = upper.as_chunks::<2>().0.iter().zip(lower.as_chunks::<2>().0);
        for (to, (upper, lower)) in out.iter_mut().zip(pairs) {
            let [a, b, c, d] = [&upper[0], &upper[1], &lower[0], &lower[1]].map(&fetch);
            *to = std::array::from_fn(|i| ((a[i] + b[i]) + (c[i] + d[i])) * 0.25);
        }
    }
    Ok(Level { size, texels })
}

/// Halves one dimension.
fn reduce_axis(level: &Level, axis: usize, border: usize) -> Outcome<Level> {
    let full = level.size[axis];
    // A dimension that the image has not is 1 long and has no border.
    let border = if full >= 3 { border } else { 0 };
    let n = full - 2 * border;
    let m = n / 2;
    if m == 0 {
        return Ok(level.clone());
    }
    let inner: usize = level.size[..axis].iter().product();
    let outer: usize = level.size[axis + 1..].iter().product();
    let mut size = level.size;
    size[axis] = m + 2 * border;
    let mut texels = zeroed(inner * size[axis] * outer, [0.0; 4])?;
    let slices = texels.chunks_exact_mut(inner * size[axis]).zip(level.texels.chunks_exact(inner * full));
    for (to, from) in slices {
        let line = |i: usize| from.get(i * inner..(i + 1) * inner).unwrap_or(&[]);
        for (i, to) in to.chunks_exact_mut(inner).enumerate() {
            if i < border {
                to.copy_from_slice(line(0));
            } else if i >= border + m {
                to.copy_from_slice(line(full - 1));
            } else {
                let i = i - border;
                let from = border + 2 * i;
                if n.is_multiple_of(2) {
                    mean(to, line(from), line(from + 1));
                } else {
                    let weights = [m - i, m, i + 1].map(|w| w as f32);
                    polyphase(to, [line(from), line(from + 1), line(from + 2)], weights, n as f32);
                }
            }
        }
    }
    Ok(Level { size, texels })
}

fn mean(to: &mut [[f32; 4]], a: &[[f32; 4]], b: &[[f32; 4]]) {
    for (to, (a, b)) in to.iter_mut().zip(a.iter().zip(b)) {
        *to = std::array::from_fn(|c| (a[c] + b[c]) * 0.5);
    }
}

fn polyphase(to: &mut [[f32; 4]], [a, b, c]: [&[[f32; 4]]; 3], w: [f32; 3], whole: f32) {
    for (to, ((a, b), c)) in to.iter_mut().zip(a.iter().zip(b).zip(c)) {
        *to = std::array::from_fn(|i| (a[i] * w[0] + b[i] * w[1] + c[i] * w[2]) / whole);
    }
}

/// The texels of an image with its border: packed ones as numbers from 0 to 255, others as they are.
pub fn from_image(image: &Image) -> Outcome<Level> {
    let size = image.full_size().map(|n| n as usize);
    let mut texels = zeroed(size.iter().product(), [0.0; 4])?;
    let first = image.first();
    for (n, to) in texels.chunks_exact_mut(size[0].max(1)).enumerate() {
        let (y, z) = ((n % size[1]) as i32, (n / size[1]) as i32);
        let at = image.index(first[0], first[1] + y, first[2] + z);
        match image.own_texels() {
            Texels::Rgba8(t) => to.iter_mut().zip(t.iter().skip(at)).for_each(|(to, t)| *to = numbers(t)),
            Texels::Float(t) => to.iter_mut().zip(t.iter().skip(at)).for_each(|(to, t)| *to = *t),
            Texels::Depth(t) => to.iter_mut().zip(t.iter().skip(at)).for_each(|(to, t)| *to = [*t; 4]),
        }
    }
    Ok(Level { size, texels })
}

/// An image like `like`, of the given interior size, that holds a level: each texel rounded to what its format keeps.
fn to_image(like: &Image, size: [u32; 3], level: &Level) -> Outcome<Image> {
    let mut image = Image::new(like.format, like.dimensions, size, like.border)?;
    image.internal_format = like.internal_format;
    let first = image.first();
    let full = level.size;
    let format = image.format;
    for (n, from) in level.texels.chunks_exact(full[0].max(1)).enumerate() {
        let (y, z) = ((n % full[1]) as i32, (n / full[1]) as i32);
        let at = image.index(first[0], first[1] + y, first[2] + z);
        match &mut image.texels {
            Texels::Rgba8(t) => {
                for (to, from) in t.iter_mut().skip(at).zip(from) {
                    *to = u32::from_le_bytes(from.map(|c| (c + 0.5) as u8));
                }
            }
            Texels::Float(t) => {
                for (to, &from) in t.iter_mut().skip(at).zip(from) {
                    *to = like.base.expand(format.round(from));
                }
            }
            Texels::Depth(t) => {
                for (to, &from) in t.iter_mut().skip(at).zip(from) {
                    *to = format.round(from)[0];
                }
            }
        }
    }
    image.recompress([0; 3], full.map(|n| n as i32))?;
    Ok(image)
}
