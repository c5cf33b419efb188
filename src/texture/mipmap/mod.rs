//! Levels made from a level (OpenGL 1.5, section 3.8.8, GENERATE_MIPMAP; GenerateMipmap). The specification leaves the
//! filter open and recommends a box. A dimension of even size n = 2m takes the mean of each two texels. An odd size
//! n = 2m + 1 takes three texels with the weights (m - i, m, i + 1)/n, the exact share that m equal texels have in n: so
//! the mean of the image stays the mean. Dimensions are reduced one after the other, so 1D, 2D and 3D are one filter;
//! rows are taken from the level above as they are needed, so that nothing of its size is kept beside it.
//!
//! A chain of levels is computed in floats from its base and each level is rounded once, on its way into its image, so
//! the rounding of one level never reaches the next.

mod rgba8;

use super::image::{FloatTexel, Image, Texels, zeroed};
use crate::error::Outcome;
use std::sync::Arc;

/// A level with its border, in floats, the first dimension fastest.
struct FloatLevel {
    size: [usize; 3],
    texels: Vec<FloatTexel>,
}

/// How many levels follow an image of this size, down to 1 x 1 x 1.
#[must_use]
pub fn levels_below(size: [u32; 3]) -> usize {
    size.into_iter().max().and_then(u32::checked_ilog2).unwrap_or(0) as usize
}

/// The levels below `base`, the first half its size: `count` of them, or as many as there are down to 1 x 1 x 1. `old`
/// are the levels that they replace: what nobody else holds gives its memory, and an error loses it. `simd` is the
/// instruction set.
pub fn levels(
    base: &Image,
    count: usize,
    simd: crate::simd::Level,
    old: &mut [Option<Arc<Image>>],
) -> Outcome<Vec<Image>> {
    let mut made: Vec<Image> = Vec::new();
    if base.is_null() {
        return Ok(made);
    }
    let border = base.border as usize;
    let count = count.min(levels_below([base.width, base.height, base.depth]));
    let means = rgba8::levels(base, count, simd, old, &mut made)?;
    let halved = |n: u32| (n >> made.len()) as usize;
    let mut above = means.map(|texels| FloatLevel { size: [halved(base.width), halved(base.height), 1], texels });
    for n in made.len()..count {
        let level = match &above {
            None => first_reduction(base)?,
            Some(FloatLevel { size: [w, h, d], texels }) if is_even(border, [*w, *h, *d]) => {
                quarter([*w, *h], |y| texels.get(y * w..(y + 1) * w).unwrap_or(&[]))?
            }
            Some(FloatLevel { size: [w, h, d], texels }) => reduce([*w, *h, *d], border, |y, z, to| {
                let at = (z * h + y) * w;
                to.copy_from_slice(texels.get(at..at + w).unwrap_or(&[]));
            })?,
        };
        let size = [base.width, base.height, base.depth].map(|size| (size >> (n + 1)).max(1));
        made.push(to_image(base, size, &level)?);
        above = Some(level);
    }
    Ok(made)
}

/// The first reduction reads the image itself, where it is not packed or not even.
fn first_reduction(base: &Image) -> Outcome<FloatLevel> {
    let full = base.full_size().map(|n| n as usize);
    let first = base.first();
    reduce(full, base.border as usize, |y, z, to| {
        read_row(base, base.index(first[0], first[1] + y as i32, first[2] + z as i32), to);
    })
}

/// Whether [`quarter`] may take the place of [`reduce`].
fn is_even(border: usize, [w, h, d]: [usize; 3]) -> bool {
    border == 0 && d == 1 && w.is_multiple_of(2) && h.is_multiple_of(2)
}

/// [`reduce`] for two even dimensions at once: the same sums, as only halves are taken of them.
fn quarter<'a>([w, h]: [usize; 2], row: impl Fn(usize) -> &'a [FloatTexel]) -> Outcome<FloatLevel> {
    let mut texels = zeroed(w / 2 * (h / 2), [0.0; 4])?;
    for (y, out) in texels.chunks_exact_mut(w / 2).enumerate() {
        let pairs = row(2 * y).as_chunks::<2>().0.iter().zip(row(2 * y + 1).as_chunks::<2>().0);
        for (to, ([a, b], [c, d])) in out.iter_mut().zip(pairs) {
            *to = std::array::from_fn(|i| ((a[i] + b[i]) + (c[i] + d[i])) * 0.25);
        }
    }
    Ok(FloatLevel { size: [w / 2, h / 2, 1], texels })
}

/// What an item of a reduced dimension is made of: `count` items from `first` on with weights, divided by `whole`.
#[derive(Clone, Copy, PartialEq)]
struct Taps {
    first: usize,
    count: usize,
    weights: [f32; 3],
    whole: f32,
}

/// The items of a dimension of `full` texels, border included, after it is reduced. A border is reduced along the edges
/// that it lies on and stays a border: across, it is copied.
fn taps(full: usize, border: usize) -> Outcome<Vec<Taps>> {
    let copy = |first| Taps { first, count: 1, weights: [1.0; 3], whole: 1.0 };
    // A dimension that the image has not is 1 long and has no border.
    let border = if full >= 3 { border } else { 0 };
    let n = full - 2 * border;
    let m = n / 2;
    if m == 0 {
        return Ok((0..full).map(copy).collect());
    }
    let mut taps = zeroed(m + 2 * border, copy(0))?;
    for (i, tap) in taps.iter_mut().enumerate() {
        *tap = if i < border {
            copy(0)
        } else if i >= border + m {
            copy(full - 1)
        } else {
            let i = i - border;
            let first = border + 2 * i;
            if n.is_multiple_of(2) {
                Taps { first, count: 2, weights: [1.0; 3], whole: 2.0 }
            } else {
                Taps { first, count: 3, weights: [m - i, m, i + 1].map(|w| w as f32), whole: n as f32 }
            }
        };
    }
    Ok(taps)
}

/// The next level of a level of `size`, border included. `row` writes row y of slice z.
fn reduce(size: [usize; 3], border: usize, row: impl Fn(usize, usize, &mut [FloatTexel])) -> Outcome<FloatLevel> {
    let [across, down, deep] = [taps(size[0], border)?, taps(size[1], border)?, taps(size[2], border)?];
    let width = across.len();
    let mut texels = zeroed(width * down.len() * deep.len(), [0.0; 4])?;
    let mut whole_row = zeroed(size[0], [0.0; 4])?;
    // Reduced rows of the level above, with their places: an odd dimension needs its last row once more.
    let mut rows = [zeroed(width, [0.0; 4])?, zeroed(width, [0.0; 4])?, zeroed(width, [0.0; 4])?];
    let mut places = [None; 3];
    let mut slices = [zeroed(width, [0.0; 4])?, zeroed(width, [0.0; 4])?, zeroed(width, [0.0; 4])?];
    for (n, out) in texels.chunks_exact_mut(width).enumerate() {
        let (y, z) = (down[n % down.len()], deep[n / down.len()]);
        for (dz, slice) in slices.iter_mut().enumerate().take(z.count) {
            for dy in 0..y.count {
                let place = Some((y.first + dy, z.first + dz));
                if places[dy] == place {
                    continue;
                }
                if let Some(have) = places.iter().position(|p| *p == place) {
                    rows.swap(dy, have);
                    places.swap(dy, have);
                    continue;
                }
                row(y.first + dy, z.first + dz, &mut whole_row);
                reduce_row(&whole_row, &across, &mut rows[dy]);
                places[dy] = place;
            }
            combine(y, &rows, slice);
        }
        combine(z, &slices, out);
    }
    Ok(FloatLevel { size: [width, down.len(), deep.len()], texels })
}

/// Reduces a row along itself.
fn reduce_row(from: &[FloatTexel], across: &[Taps], to: &mut [FloatTexel]) {
    for (to, taps) in to.iter_mut().zip(across) {
        let from = from.get(taps.first..taps.first + taps.count).unwrap_or(&[]);
        *to = match from {
            [a] => *a,
            [a, b] => mean(a, b),
            [a, b, c] => weigh(taps, a, b, c),
            _ => [0.0; 4],
        };
    }
}

/// Combines up to three rows texel by texel.
fn combine(taps: Taps, [a, b, c]: &[Vec<FloatTexel>; 3], to: &mut [FloatTexel]) {
    match taps.count {
        1 => to.copy_from_slice(a),
        2 => to.iter_mut().zip(a.iter().zip(b)).for_each(|(to, (a, b))| *to = mean(a, b)),
        _ => {
            let texels = a.iter().zip(b).zip(c);
            to.iter_mut().zip(texels).for_each(|(to, ((a, b), c))| *to = weigh(&taps, a, b, c));
        }
    }
}

#[inline]
fn mean(a: &FloatTexel, b: &FloatTexel) -> FloatTexel {
    std::array::from_fn(|i| (a[i] + b[i]) * 0.5)
}

#[inline]
fn weigh(taps: &Taps, a: &FloatTexel, b: &FloatTexel, c: &FloatTexel) -> FloatTexel {
    let [u, v, w] = taps.weights;
    std::array::from_fn(|i| (a[i] * u + b[i] * v + c[i] * w) / taps.whole)
}

/// The texels of an image from an index on: packed ones as whole numbers from 0 to 255, whose sums are exact.
fn read_row(image: &Image, at: usize, to: &mut [FloatTexel]) {
    match image.own_texels() {
        Texels::Rgba8(t) => {
            let row = t.get(at..at + to.len()).unwrap_or(&[]);
            to.iter_mut().zip(row).for_each(|(to, t)| *to = t.to_le_bytes().map(f32::from));
        }
        Texels::Float(t) => to.iter_mut().zip(t.iter().skip(at)).for_each(|(to, t)| *to = *t),
        Texels::Depth(t) => to.iter_mut().zip(t.iter().skip(at)).for_each(|(to, t)| *to = [*t; 4]),
    }
}

/// An image like `like`, of the given interior size, that holds a level: each texel rounded to what its format keeps.
fn to_image(like: &Image, size: [u32; 3], level: &FloatLevel) -> Outcome<Image> {
    let mut image = Image::new(like.format, like.dimensions, size, like.border)?;
    image.internal_format = like.internal_format;
    image.fit = like.fit;
    // The mean of 255 and 255 is 255.
    image.opaque = like.opaque;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::GL_RGBA8;
    use crate::texture::format::InternalFormat;
    use crate::texture::image::Dimensions;

    fn noise(size: [u32; 2], seed: u32) -> Image {
        let format = InternalFormat::of_tex_image(GL_RGBA8.cast_signed()).expect("a format");
        let mut image = Image::new(format, Dimensions::Two, [size[0], size[1], 1], 0).expect("memory");
        let mut random = seed;
        if let Texels::Rgba8(texels) = &mut image.texels {
            for t in texels {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                // Many whites, so that sums reach their limit.
                *t = if random >> 30 == 0 { random } else { u32::MAX };
            }
        }
        image
    }

    #[test]
    fn sums_give_what_floats_give_at_every_level_of_instructions_and_in_used_memory() {
        for size in [[512, 512], [64, 6], [6, 64], [2, 2], [48, 80], [32, 1024], [4, 12], [40, 8]] {
            let base = noise(size, 12_345);
            let mut wanted = Vec::new();
            let mut above = first_reduction(&base).expect("memory");
            while wanted.len() < levels_below([size[0], size[1], 1]) {
                let FloatLevel { size: [w, h, _], texels } = &above;
                wanted.push(to_image(&base, [*w as u32, *h as u32, 1], &above).expect("memory"));
                let next = reduce([*w, *h, 1], 0, |y, _, to| to.copy_from_slice(&texels[y * w..][..*w]));
                above = next.expect("memory");
            }
            for simd in crate::simd::Level::available() {
                let old = levels(&noise(size, 99), 20, simd, &mut []).expect("memory");
                let mut old: Vec<_> = old.into_iter().map(|image| Some(Arc::new(image))).collect();
                let held = old[0].clone();
                let before = held.as_ref().expect("a level").texels.clone();
                let made = levels(&base, 20, simd, &mut old).expect("memory");
                assert_eq!(made.len(), wanted.len());
                assert_eq!(held.expect("a level").texels, before, "a level that is held keeps its texels");
                for (i, (made, want)) in made.iter().zip(&wanted).enumerate() {
                    assert_eq!(made.full_size(), want.full_size());
                    assert_eq!(made.own_texels(), want.own_texels(), "level {} of {size:?} at {simd:?}", i + 1);
                }
            }
        }
    }
}
