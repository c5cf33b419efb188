//! S3TC blocks (EXT_texture_compression_s3tc; OpenGL 1.5, section 3.8.3). A block is 4 x 4 texels: two colours of 16
//! bits and 2 bits a texel that choose them or what lies between; DXT3 and DXT5 put 8 bytes of alpha before. Images are
//! decoded when they are given and the blocks are kept beside the texels. Texels that arrive uncompressed are encoded,
//! so that what is sampled is always what the blocks say.

mod encode;

use super::format::{BaseFormat, InternalFormat, S3tc};
use super::image::{Dimensions, Image, Texels, zeroed};
use crate::error::{Outcome, invalid_operation, invalid_value};
use encode::encode;

impl S3tc {
    /// Bytes of a block.
    #[must_use]
    pub fn block_bytes(self) -> usize {
        match self {
            S3tc::RgbDxt1 | S3tc::RgbaDxt1 => 8,
            S3tc::RgbaDxt3 | S3tc::RgbaDxt5 => 16,
        }
    }

    /// Bytes of an image: blocks are whole even where the image is not.
    #[must_use]
    pub fn image_bytes(self, width: u32, height: u32) -> usize {
        width.div_ceil(4) as usize * height.div_ceil(4) as usize * self.block_bytes()
    }

    /// The 16 texels of a block, row after row, packed as R, G, B, A.
    #[must_use]
    pub fn decode(self, block: &[u8]) -> [u32; 16] {
        let eight =
            |at: usize| -> [u8; 8] { block.get(at..at + 8).and_then(|b| b.try_into().ok()).unwrap_or_default() };
        match self {
            S3tc::RgbDxt1 => decode_color(eight(0), true).map(|t| t | 0xFF00_0000),
            S3tc::RgbaDxt1 => decode_color(eight(0), true),
            S3tc::RgbaDxt3 => {
                let bits = u64::from_le_bytes(eight(0));
                let alpha = |i: usize| (bits >> (4 * i) & 15) as u32 * 17;
                merge(decode_color(eight(8), false), alpha)
            }
            S3tc::RgbaDxt5 => {
                let palette = alpha_palette(block.first().copied().unwrap_or(0), block.get(1).copied().unwrap_or(0));
                let bits = u64::from_le_bytes(eight(0)) >> 16;
                let alpha = |i: usize| u32::from(palette[(bits >> (3 * i) & 7) as usize]);
                merge(decode_color(eight(8), false), alpha)
            }
        }
    }
}

fn merge(colors: [u32; 16], alpha: impl Fn(usize) -> u32) -> [u32; 16] {
    std::array::from_fn(|i| (colors[i] & 0x00FF_FFFF) | alpha(i) << 24)
}

/// The numerators of R, G, B in a colour of 5, 6 and 5 bits.
pub(super) fn split_565(color: u16) -> [u32; 3] {
    [u32::from(color >> 11), u32::from(color >> 5 & 63), u32::from(color & 31)]
}

/// The four colours of a block, packed. Three steps lie between the two colours, or (`two_steps`, for DXT1 with the
/// first colour not above the second) one step, and the fourth colour is transparent black. Everything is rounded to 8
/// bits once.
pub(super) fn color_palette(c0: u16, c1: u16, transparent: bool) -> [u32; 4] {
    let (a, b) = (split_565(c0), split_565(c1));
    let max = [31, 63, 31];
    // (wa a + wb b) / (wa + wb) / max, in 255ths, rounded to nearest.
    let mix = |wa: u32, wb: u32| -> u32 {
        let channel = |i: usize| {
            let whole = (wa + wb) * max[i];
            ((wa * a[i] + wb * b[i]) * 510 + whole) / (2 * whole)
        };
        channel(0) | channel(1) << 8 | channel(2) << 16 | 0xFF00_0000
    };
    if transparent { [mix(1, 0), mix(0, 1), mix(1, 1), 0] } else { [mix(1, 0), mix(0, 1), mix(2, 1), mix(1, 2)] }
}

/// The eight alphas of a DXT5 block.
pub(super) fn alpha_palette(a0: u8, a1: u8) -> [u8; 8] {
    let (a, b) = (u32::from(a0), u32::from(a1));
    let mix = |wa: u32, wb: u32| ((2 * (wa * a + wb * b) + wa + wb) / (2 * (wa + wb))) as u8;
    if a0 > a1 {
        [a0, a1, mix(6, 1), mix(5, 2), mix(4, 3), mix(3, 4), mix(2, 5), mix(1, 6)]
    } else {
        [a0, a1, mix(4, 1), mix(3, 2), mix(2, 3), mix(1, 4), 0, 255]
    }
}

fn decode_color(block: [u8; 8], dxt1: bool) -> [u32; 16] {
    let [l0, h0, l1, h1, codes @ ..] = block;
    let (c0, c1) = (u16::from_le_bytes([l0, h0]), u16::from_le_bytes([l1, h1]));
    let palette = color_palette(c0, c1, dxt1 && c0 <= c1);
    let codes = u32::from_le_bytes(codes);
    std::array::from_fn(|i| palette[(codes >> (2 * i) & 3) as usize])
}

/// Which blocks a region touches: first column and row, one past the last.
fn block_range(offset: [i32; 3], size: [i32; 3]) -> [[usize; 2]; 2] {
    let first = |axis: usize| offset[axis].max(0) as usize / 4;
    let end = |axis: usize| (offset[axis].max(0) as usize + size[axis].max(0) as usize).div_ceil(4);
    [[first(0), first(1)], [end(0), end(1)]]
}

impl Image {
    /// CompressedTexImage2D: decodes the blocks and keeps them. `size` is width and height; there is no border.
    pub fn from_blocks(format: &'static InternalFormat, size: [u32; 2], blocks: &[u8]) -> Outcome<Image> {
        let mut image = Image::new(format, Dimensions::Two, [size[0], size[1], 1], 0)?;
        image.write_blocks([0; 3], [size[0].cast_signed(), size[1].cast_signed(), 1], blocks)?;
        Ok(image)
    }

    /// INVALID_OPERATION unless a region of a compressed image consists of whole blocks (or ends where the image does).
    /// Images of other formats take every region.
    pub fn check_block_region(&self, offset: [i32; 3], size: [i32; 3]) -> Outcome {
        if self.format.s3tc.is_none() {
            return Ok(());
        }
        let full = self.full_size();
        for axis in 0..2 {
            let end = i64::from(offset[axis]) + i64::from(size[axis]);
            if offset[axis] % 4 != 0 || (size[axis] % 4 != 0 && end != i64::from(full[axis])) {
                return Err(invalid_operation(format!(
                    "texels {} to {end} of a compressed image; begin and end at a multiple of 4 or at its edge",
                    offset[axis]
                )));
            }
        }
        Ok(())
    }

    /// CompressedTexSubImage2D: replaces the blocks of a region. INVALID_VALUE if their bytes are not as many as the
    /// region needs.
    pub fn write_blocks(&mut self, offset: [i32; 3], size: [i32; 3], blocks: &[u8]) -> Outcome {
        let Some(kind) = self.format.s3tc else {
            return Err(invalid_operation("compressed blocks for an image that is not compressed; use TexSubImage"));
        };
        self.check_region(offset, size)?;
        self.check_block_region(offset, size)?;
        let need = kind.image_bytes(size[0].unsigned_abs(), size[1].unsigned_abs());
        if blocks.len() != need {
            return Err(invalid_value(format!(
                "an image size of {} bytes; {} x {} texels are {need} bytes in this format",
                blocks.len(),
                size[0],
                size[1]
            )));
        }
        let mut kept = self.take_blocks(kind)?;
        let columns = self.width.div_ceil(4) as usize;
        let [first, end] = block_range(offset, size);
        let mut given = blocks.chunks_exact(kind.block_bytes());
        for by in first[1]..end[1] {
            for bx in first[0]..end[0] {
                let at = (by * columns + bx) * kind.block_bytes();
                if let (Some(block), Some(to)) = (given.next(), kept.get_mut(at..at + kind.block_bytes())) {
                    to.copy_from_slice(block);
                    self.show_block(kind, bx, by, block);
                }
            }
        }
        self.compressed = Some(kept);
        Ok(())
    }

    /// After texels of a region were written uncompressed: encodes its blocks and shows what they hold. Does nothing for
    /// a format without blocks.
    pub fn recompress(&mut self, offset: [i32; 3], size: [i32; 3]) -> Outcome {
        let Some(kind) = self.format.s3tc else { return Ok(()) };
        let mut kept = self.take_blocks(kind)?;
        let columns = self.width.div_ceil(4) as usize;
        let [first, end] = block_range(offset, size);
        for by in first[1]..end[1].min(self.height.div_ceil(4) as usize) {
            for bx in first[0]..end[0].min(columns) {
                let block = encode(kind, &self.block_texels(bx, by), self.fit);
                let block = &block[..kind.block_bytes()];
                let at = (by * columns + bx) * kind.block_bytes();
                if let Some(to) = kept.get_mut(at..at + kind.block_bytes()) {
                    to.copy_from_slice(block);
                    self.show_block(kind, bx, by, block);
                }
            }
        }
        self.compressed = Some(kept);
        Ok(())
    }

    fn take_blocks(&mut self, kind: S3tc) -> Outcome<Vec<u8>> {
        match self.compressed.take() {
            Some(blocks) => Ok(blocks),
            None => zeroed(kind.image_bytes(self.width, self.height), 0),
        }
    }

    /// The texels of a block; where it sticks out of the image, the last texels are repeated.
    fn block_texels(&self, bx: usize, by: usize) -> [u32; 16] {
        let (Texels::Rgba8(texels), false) = (&self.texels, self.is_null()) else { return [0; 16] };
        std::array::from_fn(|n| {
            let x = (bx * 4 + n % 4).min(self.width as usize - 1);
            let y = (by * 4 + n / 4).min(self.height as usize - 1);
            texels.get(self.origin() + y * self.row_stride() + x).copied().unwrap_or(0)
        })
    }

    /// Decodes a block into the texels that lie in the image.
    fn show_block(&mut self, kind: S3tc, bx: usize, by: usize, block: &[u8]) {
        self.show_border();
        let (origin, stride) = (self.origin(), self.row_stride());
        let (width, height) = (self.width as usize, self.height as usize);
        let base: BaseFormat = self.base;
        let Texels::Rgba8(texels) = &mut self.texels else { return };
        for (n, texel) in kind.decode(block).into_iter().enumerate() {
            let (x, y) = (bx * 4 + n % 4, by * 4 + n / 4);
            if x < width
                && y < height
                && let Some(to) = texels.get_mut(origin + y * stride + x)
            {
                *to = base.expand_rgba8(texel);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::*;
    use crate::pixels::{ClientImage, PixelFormat, Transfer};
    use crate::simd::Level;
    use crate::state::pixel::PixelStore;
    use crate::texture::format::BlockFit;

    fn find(name: u32) -> &'static InternalFormat {
        InternalFormat::find(name).unwrap()
    }

    fn bytes(texel: u32) -> [u8; 4] {
        texel.to_le_bytes()
    }

    #[test]
    fn palettes_are_the_fractions_rounded_once() {
        for (c0, c1) in [(0xFFFFu16, 0), (0xF81F, 0x07E0), (0x1234, 0x0ABC), (0, 0)] {
            for transparent in [false, true] {
                let palette = color_palette(c0, c1, transparent);
                let exact = |c: u16, i: usize| f64::from(split_565(c)[i]) / [31.0, 63.0, 31.0][i];
                let weights = if transparent { vec![1.0, 0.0, 0.5] } else { vec![1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0] };
                for (texel, w) in palette.into_iter().zip(weights) {
                    for i in 0..3 {
                        let want = (exact(c0, i) * w + exact(c1, i) * (1.0 - w)) * 255.0;
                        assert!((f64::from(bytes(texel)[i]) - want).abs() <= 0.5 + 1e-9);
                    }
                    assert_eq!(bytes(texel)[3], 255);
                }
                assert_eq!(palette[3] == 0, transparent);
            }
        }
        assert_eq!(alpha_palette(255, 0), [255, 0, 219, 182, 146, 109, 73, 36]);
        assert_eq!(alpha_palette(0, 255), [0, 255, 51, 102, 153, 204, 0, 255]);
    }

    #[test]
    fn known_blocks_decode_to_known_texels() {
        // Red and blue, codes 0 1 2 3 in the first row, 0 elsewhere.
        let opaque = [0x00, 0xF8, 0x1F, 0x00, 0b11_10_01_00, 0, 0, 0];
        let texels = S3tc::RgbDxt1.decode(&opaque);
        assert_eq!(
            texels[..4].iter().map(|&t| bytes(t)).collect::<Vec<_>>(),
            [[255, 0, 0, 255], [0, 0, 255, 255], [170, 0, 85, 255], [85, 0, 170, 255]]
        );
        assert!(texels[4..].iter().all(|&t| t == texels[0]));
        let mut swapped = opaque;
        swapped[..4].copy_from_slice(&[0x1F, 0x00, 0x00, 0xF8]);
        assert_eq!(bytes(S3tc::RgbaDxt1.decode(&swapped)[2]), [128, 0, 128, 255]);
        assert_eq!(bytes(S3tc::RgbaDxt1.decode(&swapped)[3]), [0, 0, 0, 0]);
        assert_eq!(bytes(S3tc::RgbDxt1.decode(&swapped)[3]), [0, 0, 0, 255], "black, but opaque");
        let mut dxt3 = [0; 16];
        dxt3[..2].copy_from_slice(&[0x10, 0xF2]);
        dxt3[8..].copy_from_slice(&swapped);
        let texels = S3tc::RgbaDxt3.decode(&dxt3);
        assert_eq!(texels[..4].iter().map(|&t| t >> 24).collect::<Vec<_>>(), [0, 17, 34, 255]);
        assert_eq!(bytes(texels[3])[..3], [170, 0, 85], "DXT3 has no transparent colour");
        let mut dxt5 = dxt3;
        dxt5[..8].copy_from_slice(&[255, 0, 0b10_001_000, 0, 0, 0, 0, 0b111_00000]);
        let texels = S3tc::RgbaDxt5.decode(&dxt5);
        assert_eq!([texels[0] >> 24, texels[1] >> 24, texels[2] >> 24, texels[15] >> 24], [255, 0, 219, 36]);
    }

    #[test]
    fn what_two_colors_can_hold_is_encoded_without_loss() {
        for kind in [S3tc::RgbDxt1, S3tc::RgbaDxt1, S3tc::RgbaDxt3, S3tc::RgbaDxt5] {
            for (c0, c1) in [(0xFFFFu16, 0u16), (0xABCD, 0x1234), (0x8888, 0x8888)] {
                let palette = color_palette(c0.max(c1), c0.min(c1), false);
                let texels: [u32; 16] = std::array::from_fn(|i| palette[(i * 7 + i / 4) % 4]);
                for fit in [BlockFit::Extremes, BlockFit::LeastSquares] {
                    let block = encode(kind, &texels, fit);
                    assert_eq!(kind.decode(&block), texels, "{kind:?} {c0:x} {c1:x}");
                }
            }
        }
        let holes: [u32; 16] = std::array::from_fn(|i| if i % 3 == 0 { 0 } else { 0xFF00_00FF });
        assert_eq!(S3tc::RgbaDxt1.decode(&encode(S3tc::RgbaDxt1, &holes, BlockFit::LeastSquares)), holes);
        let fade: [u32; 16] = std::array::from_fn(|i| (i as u32 * 17) << 24);
        assert_eq!(S3tc::RgbaDxt3.decode(&encode(S3tc::RgbaDxt3, &fade, BlockFit::Extremes)), fade);
        let near = S3tc::RgbaDxt5.decode(&encode(S3tc::RgbaDxt5, &fade, BlockFit::Extremes));
        assert!(near.iter().zip(fade).all(|(a, b)| (a >> 24).abs_diff(b >> 24) <= 19));
    }

    #[test]
    fn images_with_odd_edges_and_regions_are_decoded() {
        let format = find(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
        let blocks: Vec<u8> = (0..2 * 2 * 16).map(|i| (i * 37 + 11) as u8).collect();
        let mut image = Image::from_blocks(format, [5, 7], &blocks).unwrap();
        let mut out = vec![0; 64];
        image.get_compressed(&mut out).unwrap();
        assert_eq!(out, blocks);
        let corner = S3tc::RgbaDxt5.decode(&blocks[48..])[2 * 4];
        assert_eq!(image.texel(4, 6, 0).map(|c| (c * 255.0 + 0.5) as u8), bytes(corner));
        for (offset, size, len, code) in [
            ([2, 0, 0], [3, 4, 1], 16, GL_INVALID_OPERATION),
            ([0, 0, 0], [3, 4, 1], 16, GL_INVALID_OPERATION),
            ([4, 4, 0], [4, 4, 1], 16, GL_INVALID_VALUE),
            ([4, 4, 0], [1, 3, 1], 15, GL_INVALID_VALUE),
        ] {
            assert_eq!(image.write_blocks(offset, size, &blocks[..len]).unwrap_err().code, code);
        }
        image.write_blocks([4, 4, 0], [1, 3, 1], &blocks[..16]).unwrap();
        image.get_compressed(&mut out).unwrap();
        assert_eq!((&out[..48], &out[48..]), (&blocks[..48], &blocks[..16]));
        assert_eq!(Image::from_blocks(format, [5, 7], &blocks[1..]).unwrap_err().code, GL_INVALID_VALUE);
    }

    #[test]
    fn uncompressed_pixels_become_blocks() {
        let rgba = PixelFormat::new(GL_RGBA, GL_UNSIGNED_BYTE).unwrap();
        let pixels = [255, 0, 0, 255].repeat(36);
        let client = ClientImage::new_2d(&pixels, &PixelStore::TIGHT, [6, 6], rgba).unwrap();
        for name in [GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT] {
            let make = |border| {
                let size = [6, 6, 1];
                Image::from_client(
                    find(name),
                    Dimensions::Two,
                    size,
                    border,
                    Some(&client),
                    Transfer::NEUTRAL,
                    BlockFit::default(),
                )
                .unwrap()
            };
            let mut image = make(0);
            assert_eq!(image.texel(5, 5, 0), [1.0, 0.0, 0.0, 1.0]);
            assert_eq!(image.compressed.as_ref().map(Vec::len), Some(find(name).s3tc.unwrap().image_bytes(6, 6)));
            let green = [0, 255, 0, 255].repeat(16);
            let part = ClientImage::new_2d(&green, &PixelStore::TIGHT, [4, 4], rgba).unwrap();
            assert_eq!(image.upload([1, 0, 0], &part, Transfer::NEUTRAL).unwrap_err().code, GL_INVALID_OPERATION);
            image.upload([0, 0, 0], &part, Transfer::NEUTRAL).unwrap();
            assert_eq!((image.texel(3, 3, 0), image.texel(4, 3, 0)), ([0.0, 1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0]));
            let levels = crate::texture::mipmap::levels(&image, 9, Level::BASELINE, &mut []).unwrap();
            assert!(levels.iter().all(|level| level.compressed.is_some() && level.internal_format == name));
            let bordered = make(1);
            assert!(bordered.compressed.is_none() && bordered.internal_format != name);
        }
    }
}
