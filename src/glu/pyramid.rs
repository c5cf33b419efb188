//! The levels of a mipmap of an image of bytes (GLU 1.3, section 3.2) with sizes that are powers of two: what [`Grid`] makes
//! by halving, bit for bit, without a float image of any level. Two rows of the image give one of level 1, two of level 1
//! one of level 2 and so on: each level keeps its last two rows only, and a finished row leaves as packed bytes at once.
//! A mean of two is half of a rounded sum, and halving is exact here (nothing is smaller than 2^-40), so the halves of
//! both axes are taken together; the sums keep their order, first along the row, then across.

use super::grid::{Grid, try_vec};
use crate::num::f32_to_u8;
use crate::pixels::transfer::Transfer;
use crate::pixels::unpack::ClientImage;
use crate::simd::{Level, stage};

/// One level.
pub(super) struct PyramidLevel {
    pub width: usize,
    /// The row of an even number and that of an odd one: four planes of components, one after the other.
    rows: [Vec<f32>; 2],
    /// All of it: R, G, B, A from the low byte to the high one.
    pub texels: Vec<u32>,
}

/// The levels of an image, as long as both sizes are even.
pub(super) struct Pyramid {
    /// Two rows of the image, packed as the texels of a level are.
    image_rows: [Vec<u32>; 2],
    /// The levels in order.
    pub levels: Vec<PyramidLevel>,
    /// The last level before it is rounded; one of its sizes is 1.
    pub last: Grid,
}

type RowsFn = for<'a> unsafe fn(&'a mut Pyramid, usize);

stage! {
    /// Makes row `y` of level 1 and all rows of further levels that can be made then.
    fn ROWS: RowsFn = (pyramid: &mut Pyramid, y: usize) {
        let Pyramid { image_rows, levels, .. } = pyramid;
        let mut above: Option<&[Vec<f32>; 2]> = None;
        let mut y = y;
        for PyramidLevel { width, rows, texels } in levels {
            let row = &mut rows[y & 1];
            match above {
                None => halve_bytes(image_rows, *width, row),
                Some(above) => halve_rows(above, *width, row),
            }
            pack(row, *width, texels.get_mut(y * *width..).unwrap_or(&mut []));
            if y & 1 == 0 {
                return;
            }
            y /= 2;
            above = Some(&*rows);
        }
    }
}

/// `c / 255` for a byte, without a division: 1/255 is 257/65536 and a 65536th of itself. The first product is exact, so
/// only the sum is rounded in a way that counts (the test tries all bytes).
#[inline(always)]
fn component(texel: u32, shift: u32) -> f32 {
    let c = (texel >> shift & 0xFF) as f32;
    c * (257.0 / 65536.0) + c * (1.0 / (255.0 * 65536.0))
}

/// A row of means of two texels by two.
#[inline(always)]
fn halve_bytes([low, high]: &[Vec<u32>; 2], width: usize, to: &mut [f32]) {
    for (to, shift) in to.chunks_exact_mut(width.max(1)).zip([0, 8, 16, 24]) {
        for (to, (low, high)) in to.iter_mut().zip(low.as_chunks::<2>().0.iter().zip(high.as_chunks::<2>().0)) {
            let low = component(low[0], shift) + component(low[1], shift);
            let high = component(high[0], shift) + component(high[1], shift);
            *to = (low + high) * 0.25;
        }
    }
}

/// A row of means of two means by two; planes of twice the width lie one after the other, as those of the result do.
#[inline(always)]
fn halve_rows([low, high]: &[Vec<f32>; 2], width: usize, to: &mut [f32]) {
    let pairs = low.as_chunks::<2>().0.iter().zip(high.as_chunks::<2>().0);
    for (to, (low, high)) in to.iter_mut().take(4 * width).zip(pairs) {
        *to = ((low[0] + low[1]) + (high[0] + high[1])) * 0.25;
    }
}

/// A row as bytes, rounded as the GL rounds components.
#[inline(always)]
fn pack(row: &[f32], width: usize, to: &mut [u32]) {
    let plane = |n: usize| row.get(n * width..(n + 1) * width).unwrap_or(&[]);
    let (low, high) = (plane(0).iter().zip(plane(1)), plane(2).iter().zip(plane(3)));
    for (to, ((r, g), (b, a))) in to.iter_mut().zip(low.zip(high)) {
        let [r, g, b, a] = [*r, *g, *b, *a].map(|c| u32::from(f32_to_u8(c)));
        *to = r | g << 8 | b << 16 | a << 24;
    }
}

impl Pyramid {
    /// Makes the levels below an image of bytes whose sizes are powers of two, until a size is 1; `None` if there is no
    /// memory for them.
    pub fn of(image: &ClientImage<'_>, simd: Level) -> Option<Pyramid> {
        let [width, height, _] = image.size();
        let count = width.min(height).checked_ilog2().filter(|&count| count > 0)?;
        let mut levels = Vec::new();
        for l in 1..=count {
            let (width, height) = (width >> l, height >> l);
            let row = || try_vec(4 * width, 0.0f32);
            levels.push(PyramidLevel { width, rows: [row()?, row()?], texels: try_vec(width * height, 0u32)? });
        }
        let last = [width >> count, height >> count, 1];
        let last = Grid { size: last, texels: try_vec(last[0] * last[1], [0.0; 4])? };
        let mut pyramid = Pyramid { image_rows: [try_vec(width, 0)?, try_vec(width, 0)?], levels, last };
        for y in 0..height / 2 {
            for (n, row) in pyramid.image_rows.iter_mut().enumerate() {
                image.colors_rgba8([0, 2 * y + n, 0], Transfer::NEUTRAL, row);
            }
            #[expect(unsafe_code, reason = "the processor has every level up to the one that a context was made for")]
            unsafe {
                (ROWS.at(simd))(&mut pyramid, y);
            }
            if (y + 1).is_multiple_of(1 << (count - 1)) {
                pyramid.keep_last(y >> (count - 1));
            }
        }
        Some(pyramid)
    }

    /// Row `y` of the last level is done.
    fn keep_last(&mut self, y: usize) {
        let (Some(PyramidLevel { width, rows, .. }), to) = (self.levels.last(), &mut self.last.texels) else { return };
        for (x, to) in to.iter_mut().skip(y * width).take(*width).enumerate() {
            *to = std::array::from_fn(|c| rows[y & 1].get(c * width + x).copied().unwrap_or(0.0));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::{GL_BGRA, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA, GL_UNSIGNED_BYTE};
    use crate::num::u8_to_f32;
    use crate::pixels::element::to_rgba8;
    use crate::pixels::format::PixelFormat;
    use crate::state::pixel::PixelStore;

    #[test]
    fn a_byte_becomes_what_a_division_gives() {
        for c in 0..=255u8 {
            assert_eq!(component(u32::from(c) << 16, 16).to_bits(), u8_to_f32(c).to_bits(), "{c}");
        }
    }

    #[test]
    fn every_level_is_that_of_the_float_image() {
        for size in [[256, 256], [2, 2], [8, 64], [64, 4], [2, 128], [512, 2]] {
            for (format, bytes) in [(GL_RGBA, 4), (GL_RGB, 3), (GL_BGRA, 4), (GL_LUMINANCE_ALPHA, 2)] {
                // Small numbers, so that many means lie between two bytes, and among them all others.
                let noise = |i: usize| (i.wrapping_mul(2_654_435_761) >> 9) as u8;
                let data: Vec<u8> =
                    (0..size[0] * size[1] * bytes).map(|i| if i % 3 == 0 { noise(i) } else { noise(i) & 3 }).collect();
                let pixel = PixelFormat::new(format, GL_UNSIGNED_BYTE).expect("a format");
                let image = ClientImage::new_2d(&data, &PixelStore::TIGHT, size.map(|n| n as i32), pixel);
                let image = image.expect("an image");
                for simd in Level::available() {
                    let pyramid = Pyramid::of(&image, simd).expect("memory");
                    let mut grid = Grid::unpack(&image).expect("memory");
                    for PyramidLevel { width, texels, .. } in &pyramid.levels {
                        grid.halve().expect("memory");
                        let want: Vec<u32> = grid.texels.iter().map(|&texel| to_rgba8(texel)).collect();
                        assert_eq!((*width, texels), (grid.size[0], &want), "{size:?} {format:#x} {simd:?}");
                    }
                    assert_eq!(pyramid.last, grid);
                }
            }
        }
    }
}
