//! The first levels of a mipmap of packed texels (OpenGL 1.5, section 3.8.8), as sums of whole numbers: R and B of a
//! texel in one word, G and A in the other, 16 bits each. As many as 256 bytes have a sum that fits, so up to four levels
//! come out of additions alone, exactly what floats would give. The image is walked in strips of as many rows as make one
//! row of the last of these levels: a texel is read once, and the sums of a strip stay in the nearest cache.

use crate::error::Outcome;
use crate::simd::{Level, stage};
use crate::texture::image::{Image, Texels, zeroed};
use std::sync::Arc;

/// The most levels that sums give.
const MOST: usize = 4;
/// The bytes of a word that are added.
const BYTES: u32 = 0x00FF_00FF;

/// Rows of 32-bit words, so many apart.
struct WordRows<T> {
    words: T,
    stride: usize,
}

/// What the strips are made of and what they make.
struct StripJob<'a> {
    /// The base, from its first texel on, and its size.
    base: WordRows<&'a [u32]>,
    size: [usize; 2],
    /// The levels, each from its first texel on; as many as are made.
    levels: Vec<WordRows<&'a mut [u32]>>,
    /// Room for the sums of a strip, level after level.
    sums: &'a mut [u32],
    /// The means of the last level before they are rounded.
    means: &'a mut [[f32; 4]],
}

type StripFn = for<'a, 'b> unsafe fn(&'a mut StripJob<'b>);

stage! {
    /// Makes all levels, from the last strip to the first: the end of the base is what an upload has left in the cache.
    fn STRIPS: StripFn = (job: &mut StripJob<'_>) {
        let StripJob { base, size: [w, h], levels, sums, means } = job;
        let count = levels.len();
        for strip in (0..*h >> count).rev() {
            let (mut above, mut rest) = (&[][..], &mut **sums);
            for (l, level) in levels.iter_mut().enumerate() {
                let (width, rows) = (*w >> (l + 1), 1 << (count - 1 - l));
                let (here, next) = rest.split_at_mut((2 * width * rows).min(rest.len()));
                for (r, sums) in here.chunks_exact_mut((2 * width).max(1)).enumerate() {
                    let (rb, ga) = sums.split_at_mut(width);
                    if l == 0 {
                        let at = 2 * (strip * rows + r) * base.stride;
                        add_texels(base.words.get(at..).unwrap_or(&[]), base.stride, rb, ga);
                    } else {
                        add_sums(above.get(8 * width * r..).unwrap_or(&[]), rb, ga);
                    }
                    let at = (strip * rows + r) * level.stride;
                    round(rb, ga, 2 * (l as u32 + 1), level.words.get_mut(at..).unwrap_or(&mut []));
                }
                (above, rest) = (here, next);
            }
            let width = *w >> count;
            let (rb, ga) = above.split_at(width.min(above.len()));
            mean(rb, ga, count, means.get_mut(strip * width..).unwrap_or(&mut []));
        }
    }
}

/// A row of sums of two texels by two: those of the row that `texels` begins with and of the next.
#[inline(always)]
fn add_texels(texels: &[u32], stride: usize, rb: &mut [u32], ga: &mut [u32]) {
    let low = texels.as_chunks::<2>().0;
    let high = texels.get(stride..).unwrap_or(&[]).as_chunks::<2>().0;
    for ((low, high), (rb, ga)) in low.iter().zip(high).zip(rb.iter_mut().zip(ga)) {
        let sum = |shift: u32| {
            let [a, b, c, d] = [low[0], low[1], high[0], high[1]].map(|t| t >> shift & BYTES);
            (a + b) + (c + d)
        };
        (*rb, *ga) = (sum(0), sum(8));
    }
}

/// A row of sums of two sums by two. `above` begins with the two rows: R and B, G and A of each, twice as wide.
#[inline(always)]
fn add_sums(above: &[u32], rb: &mut [u32], ga: &mut [u32]) {
    let wide = 2 * rb.len();
    let plane = |n: usize| above.get(n * wide..(n + 1) * wide).unwrap_or(&[]).as_chunks::<2>().0;
    for (to, low, high) in [(rb, plane(0), plane(2)), (ga, plane(1), plane(3))] {
        for (to, (low, high)) in to.iter_mut().zip(low.iter().zip(high)) {
            *to = (low[0] + low[1]) + (high[0] + high[1]);
        }
    }
}

/// The means, rounded half up, as texels.
#[inline(always)]
fn round(rb: &[u32], ga: &[u32], shift: u32, to: &mut [u32]) {
    let half = 0x0001_0001 << (shift - 1);
    for (to, (rb, ga)) in to.iter_mut().zip(rb.iter().zip(ga)) {
        *to = ((rb + half) >> shift & BYTES) | ((ga + half) >> shift & BYTES) << 8;
    }
}

/// The means as they are.
#[inline(always)]
fn mean(rb: &[u32], ga: &[u32], halvings: usize, to: &mut [[f32; 4]]) {
    let part = 1.0 / (1u32 << (2 * halvings)) as f32;
    for (to, (rb, ga)) in to.iter_mut().zip(rb.iter().zip(ga)) {
        *to = [rb & 0xFFFF, ga & 0xFFFF, rb >> 16, ga >> 16].map(|sum| sum as f32 * part);
    }
}

/// How many levels of an image sums can give: they need packed texels, two dimensions, even sizes and no border.
fn halvings(base: &Image, count: usize) -> usize {
    let [w, h, d] = base.full_size();
    if base.border != 0 || d != 1 || !matches!(base.own_texels(), Texels::Rgba8(_)) {
        return 0;
    }
    count.min(MOST).min(w.trailing_zeros() as usize).min(h.trailing_zeros() as usize)
}

/// Appends the levels that sums can give to `made` and returns the last one unrounded; `None` if there is none. Images
/// of `old` that nobody else holds give their memory for those of the same shape.
pub(super) fn levels(
    base: &Image,
    count: usize,
    simd: Level,
    old: &mut [Option<Arc<Image>>],
    made: &mut Vec<Image>,
) -> Outcome<Option<Vec<[f32; 4]>>> {
    let count = halvings(base, count);
    let (Texels::Rgba8(texels), true) = (base.own_texels(), count > 0) else { return Ok(None) };
    let [w, h] = [base.width as usize, base.height as usize];
    let mut old = old.iter_mut();
    for l in 1..=count {
        let size = [base.width >> l, base.height >> l, 1];
        made.push(match old.next().and_then(|slot| recycled(slot, base, size)) {
            Some(image) => image,
            None => Image::new(base.format, base.dimensions, size, 0)?,
        });
    }
    let mut sums = zeroed(w << count, 0)?;
    let mut means = zeroed((w >> count) * (h >> count), [0.0; 4])?;
    let mut job = StripJob {
        base: WordRows { words: texels.get(base.origin()..).unwrap_or(&[]), stride: base.row_stride() },
        size: [w, h],
        levels: made.iter_mut().map(rows_of).collect(),
        sums: &mut sums,
        means: &mut means,
    };
    #[expect(unsafe_code, reason = "the processor has every level up to the one that a context was made for")]
    unsafe {
        (STRIPS.at(simd))(&mut job);
    }
    for image in made {
        image.internal_format = base.internal_format;
        image.fit = base.fit;
        image.opaque = base.opaque;
        image.recompress([0; 3], [image.width, image.height, 1].map(u32::cast_signed))?;
    }
    Ok(Some(means))
}

/// The texels of an image from its first one on.
fn rows_of(image: &mut Image) -> WordRows<&mut [u32]> {
    let (at, stride) = (image.origin(), image.row_stride());
    let words = match &mut image.texels {
        Texels::Rgba8(texels) => texels.get_mut(at..).unwrap_or(&mut []),
        _ => &mut [],
    };
    WordRows { words, stride }
}

/// The image of a slot, to be written over, if it has the shape of a level of this size and nobody else holds it.
fn recycled(slot: &mut Option<Arc<Image>>, base: &Image, size: [u32; 3]) -> Option<Image> {
    let like = slot.as_ref().is_some_and(|image| image.is_like(base.format, base.dimensions, size, 0));
    let mut image = if like { Arc::into_inner(slot.take()?)? } else { return None };
    image.show_border();
    Some(image)
}
