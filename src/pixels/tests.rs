//! Both directions together: every legal pair of format and type comes back, the fast paths agree with the general one,
//! storage modes put each group where the equations say.

use super::element::{from_rgba8, to_rgba8};
use super::format::all_pairs;
use super::layout::tests::{image_bytes, image_bytes_2d};
use super::*;
use crate::enums::*;
use crate::state::pixel::{PixelStore, PixelTransfer};
use crate::state::pixel_maps::PixelMaps;

/// A sequence of bytes that repeats late.
fn noise(n: usize) -> Vec<u8> {
    let mut state = 0x2545_F491u32;
    let step = |_| {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        (state >> 11) as u8
    };
    (0..n).map(step).collect()
}

fn odd_store() -> PixelStore {
    PixelStore { row_length: 11, skip_rows: 2, skip_pixels: 3, alignment: 8, ..PixelStore::INITIAL }
}

fn pixel(format: GLenum, type_: GLenum) -> PixelFormat {
    PixelFormat::new(format, type_).unwrap()
}

/// Packs rows of colours (7 x 3) into fresh memory of 0xA5 bytes.
fn pack_colors(store: &PixelStore, pixel: PixelFormat, rows: &[Vec<[f32; 4]>]) -> Vec<u8> {
    let size = [rows[0].len() as i32, rows.len() as i32];
    let mut bytes = vec![0xA5; layout::ClientLayout::of_2d(store, size, pixel).unwrap().total];
    let mut target = ClientTarget::new_2d(&mut bytes, store, size, pixel).unwrap();
    for (y, row) in rows.iter().enumerate() {
        target.colors([0, y, 0], Transfer::NEUTRAL, row);
    }
    bytes
}

fn unpack_colors(store: &PixelStore, pixel: PixelFormat, bytes: &[u8], size: [usize; 2]) -> Vec<Vec<[f32; 4]>> {
    let image = ClientImage::new_2d(bytes, store, size.map(|n| n as i32), pixel).unwrap();
    (0..size[1])
        .map(|y| {
            let mut row = vec![[9.0; 4]; size[0]];
            image.colors([0, y, 0], Transfer::NEUTRAL, &mut row);
            row
        })
        .collect()
}

#[test]
fn every_color_pair_comes_back() {
    let mut seen = 0;
    for (format, type_) in all_pairs() {
        let Ok(pair) = PixelFormat::new(format, type_) else { continue };
        if pair.kind() != PixelKind::Color {
            continue;
        }
        for swap_bytes in [false, true] {
            let store = PixelStore { swap_bytes, ..odd_store() };
            let raw = noise(7 * 3 * 4);
            // Colours that the type holds: unpack noise once, through the type itself.
            let rows: Vec<Vec<[f32; 4]>> = raw
                .chunks(28)
                .map(|row| row.as_chunks::<4>().0.iter().map(|&c| from_rgba8(u32::from_le_bytes(c))).collect())
                .collect();
            let single = |rows: Vec<Vec<[f32; 4]>>| -> Vec<Vec<[f32; 4]>> {
                // A luminance is packed as R + G + B: leave only R of what was unpacked.
                let strip = |c: [f32; 4]| if pair.format.is_luminance() { [c[0], 0.0, 0.0, c[3]] } else { c };
                rows.into_iter().map(|row| row.into_iter().map(strip).collect()).collect()
            };
            let first = pack_colors(&store, pair, &single(rows));
            let colors = unpack_colors(&store, pair, &first, [7, 3]);
            let second = pack_colors(&store, pair, &single(colors.clone()));
            assert_eq!(first, second, "{} {} {swap_bytes}", name(format), name(type_));
            // Components that the format lacks are 0, alpha is 1.
            for color in colors.iter().flatten() {
                for (c, &v) in color.iter().enumerate() {
                    let has = pair.format.channels().contains(&c) || pair.format.is_luminance() && c < 3;
                    assert!(has || v == if c == 3 { 1.0 } else { 0.0 });
                }
            }
            seen += 1;
        }
    }
    assert_eq!(seen, 2 * (11 * 7 + 4 + 24));
}

#[test]
fn fast_paths_give_what_the_general_path_gives() {
    for (format, type_) in all_pairs() {
        let Ok(pair) = PixelFormat::new(format, type_) else { continue };
        if pair.kind() != PixelKind::Color {
            continue;
        }
        for swap_bytes in [false, true] {
            let store = PixelStore { swap_bytes, ..odd_store() };
            let len = image_bytes_2d(&store, 7, 5, format, type_).unwrap();
            let bytes = noise(len);
            let image = ClientImage::new_2d(&bytes, &store, [7, 5], pair).unwrap();
            for y in 0..5 {
                let (mut short, mut long) = ([0; 7], [[0.0; 4]; 7]);
                image.colors_rgba8([0, y, 0], Transfer::NEUTRAL, &mut short);
                image.colors([0, y, 0], Transfer::NEUTRAL, &mut long);
                assert_eq!(short, long.map(to_rgba8), "{} {}", name(format), name(type_));
                // A start within the row.
                let mut tail = [0; 4];
                image.colors_rgba8([3, y, 0], Transfer::NEUTRAL, &mut tail);
                assert_eq!(tail, short[3..]);
            }
            let texels: Vec<u32> = noise(140).as_chunks::<4>().0.iter().map(|&c| u32::from_le_bytes(c)).collect();
            let (mut short, mut long) = (vec![0x5A; len], vec![0x5A; len]);
            let mut to = ClientTarget::new_2d(&mut short, &store, [7, 5], pair).unwrap();
            texels.chunks(7).enumerate().for_each(|(y, row)| to.colors_rgba8([0, y, 0], Transfer::NEUTRAL, row));
            let mut to = ClientTarget::new_2d(&mut long, &store, [7, 5], pair).unwrap();
            for (y, row) in texels.chunks(7).enumerate() {
                let row: Vec<_> = row.iter().map(|&t| from_rgba8(t)).collect();
                to.colors([0, y, 0], Transfer::NEUTRAL, &row);
            }
            assert_eq!(short, long, "{} {}", name(format), name(type_));
        }
    }
}

#[test]
fn known_colors_pack_to_known_bytes() {
    let store = PixelStore::TIGHT;
    let color = vec![vec![[1.0, 0.4, 0.2, 0.0]]];
    let packed = |format, type_| pack_colors(&store, pixel(format, type_), &color);
    assert_eq!(packed(GL_RGBA, GL_UNSIGNED_BYTE), [255, 102, 51, 0]);
    assert_eq!(packed(GL_BGR, GL_UNSIGNED_BYTE), [51, 102, 255]);
    assert_eq!(packed(GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE), [255, 0], "1.6 is clamped");
    assert_eq!(packed(GL_RGB, GL_BYTE).iter().map(|&b| b as i8).collect::<Vec<_>>(), [127, 51, 25]);
    assert_eq!(packed(GL_RGB, GL_UNSIGNED_SHORT_5_6_5), (31u16 << 11 | 25 << 5 | 6).to_ne_bytes());
    assert_eq!(packed(GL_RGB, GL_UNSIGNED_BYTE_3_3_2), [7 << 5 | 3 << 2 | 1]);
    assert_eq!(packed(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV), 0x00FF_6633u32.to_ne_bytes());
    assert_eq!(packed(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8), 0xFF66_3300u32.to_ne_bytes());
    assert_eq!(packed(GL_BGRA, GL_UNSIGNED_SHORT_5_5_5_1), (6u16 << 11 | 12 << 6 | 31 << 1).to_ne_bytes());
    assert_eq!(packed(GL_GREEN, GL_FLOAT), 0.4f32.to_ne_bytes());
    let one = |format, type_, bytes: &[u8]| unpack_colors(&store, pixel(format, type_), bytes, [1, 1])[0][0];
    assert_eq!(one(GL_LUMINANCE, GL_UNSIGNED_BYTE, &[51]), [0.2, 0.2, 0.2, 1.0]);
    assert_eq!(one(GL_ALPHA, GL_UNSIGNED_SHORT, &0x8000u16.to_ne_bytes()), [0.0, 0.0, 0.0, 32768.0 / 65535.0]);
    assert_eq!(one(GL_RGB, GL_BYTE, &[0x80, 0, 127]), [0.0, 1.0 / 255.0, 1.0, 1.0], "-1 is clamped");
    assert_eq!(
        one(GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, &(1u32 << 30 | 1023 << 10).to_ne_bytes()),
        [0.0, 1.0, 0.0, 1.0 / 3.0]
    );
    assert_eq!(one(GL_RED, GL_FLOAT, &f32::NAN.to_ne_bytes()), [0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn groups_lie_where_the_equations_put_them_and_gaps_stay() {
    let store = PixelStore {
        row_length: 5,
        image_height: 4,
        skip_rows: 1,
        skip_pixels: 2,
        skip_images: 1,
        alignment: 8,
        ..PixelStore::INITIAL
    };
    // Rows of 5 groups of 3 bytes, padded to 16; slices of 4 rows.
    let at = |x: usize, y: usize, z: usize| (z + 1) * 64 + (y + 1) * 16 + (x + 2) * 3;
    let mut bytes = vec![7; image_bytes(&store, 2, 2, 2, GL_RGB, GL_UNSIGNED_BYTE).unwrap()];
    assert_eq!(bytes.len(), at(1, 1, 1) + 3);
    let mut target = ClientTarget::new_3d(&mut bytes, &store, [2, 2, 2], pixel(GL_RGB, GL_UNSIGNED_BYTE)).unwrap();
    for (y, z) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        target.colors_rgba8([0, y, z], Transfer::NEUTRAL, &[u32::MAX; 2]);
    }
    for (i, &byte) in bytes.iter().enumerate() {
        let inside = (0..8).any(|n| {
            let start = at(n & 1, n >> 1 & 1, n >> 2);
            (start..start + 3).contains(&i)
        });
        assert_eq!(byte, if inside { 255 } else { 7 }, "byte {i}");
    }
    let mut small = vec![0; bytes.len() - 1];
    let short = ClientTarget::new_3d(&mut small, &store, [2, 2, 2], pixel(GL_RGB, GL_UNSIGNED_BYTE)).unwrap_err();
    assert_eq!(short.code, GL_INVALID_OPERATION);
    assert!(short.message.contains(&bytes.len().to_string()), "{}", short.message);
}

#[test]
fn indices_depths_and_bitmaps_come_back() {
    for lsb_first in [false, true] {
        let store = PixelStore { lsb_first, skip_pixels: 5, ..odd_store() };
        let bits = pixel(GL_COLOR_INDEX, GL_BITMAP);
        let mut bytes = vec![0; image_bytes_2d(&store, 6, 2, GL_COLOR_INDEX, GL_BITMAP).unwrap()];
        let mut target = ClientTarget::new_2d(&mut bytes, &store, [6, 2], bits).unwrap();
        target.raw_indices([0, 0, 0], &[1, 0, 1, 1, 0, 1]);
        target.raw_indices([1, 1, 0], &[1, 1]);
        // Bits 5.. of the third row; rows are 8 bytes apart.
        assert_eq!(bytes[16], if lsb_first { 0b1010_0000 } else { 0b0000_0101 });
        assert_eq!(bytes[17], if lsb_first { 0b0000_0101 } else { 0b1010_0000 });
        let image = ClientImage::new_2d(&bytes, &store, [6, 2], bits).unwrap();
        let row = |y| std::array::from_fn::<bool, 6, _>(|x| image.bit([x, y, 0]));
        assert_eq!(row(0), [true, false, true, true, false, true]);
        assert_eq!(row(1), [false, true, true, false, false, false]);
    }
    for type_ in [GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT] {
        let store = odd_store();
        let mut bytes = vec![0; image_bytes_2d(&store, 4, 1, GL_STENCIL_INDEX, type_).unwrap()];
        let pair = pixel(GL_STENCIL_INDEX, type_);
        let mut to = ClientTarget::new_2d(&mut bytes, &store, [4, 1], pair).unwrap();
        to.stencils([0, 0, 0], Transfer::NEUTRAL, &[0, 1, 127, 200]);
        let mut back = [9; 4];
        let image = ClientImage::new_2d(&bytes, &store, [4, 1], pair).unwrap();
        image.stencils([0, 0, 0], Transfer::NEUTRAL, &mut back);
        assert_eq!(back, [0, 1, 127, if type_ == GL_BYTE { 200 & 127 } else { 200 }], "table 4.6 masks bytes");

        let pair = pixel(GL_DEPTH_COMPONENT, type_);
        let mut to = ClientTarget::new_2d(&mut bytes, &store, [4, 1], pair).unwrap();
        to.depths([0, 0, 0], Transfer::NEUTRAL, &[0.0, 1.0, 0.25, 7.0]);
        let mut back = [9.0; 4];
        let image = ClientImage::new_2d(&bytes, &store, [4, 1], pair).unwrap();
        image.depths([0, 0, 0], Transfer::NEUTRAL, &mut back);
        assert!((back[0], back[1], back[3]) == (back[0], 1.0, 1.0) && back[0] <= 1.0 / 255.0);
        assert!((back[2] - 0.25).abs() < 0.004);
    }
}

#[test]
fn depth_and_stencil_share_an_element() {
    let pair = pixel(GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT);
    let mut bytes = [0; 8];
    let mut to = ClientTarget::new_2d(&mut bytes, &PixelStore::TIGHT, [2, 1], pair).unwrap();
    to.depth_stencils([0, 0, 0], Transfer::NEUTRAL, &[1.0, 0.0], &[0x1AB, 3]);
    assert_eq!(bytes[..4], 0xFFFF_FFABu32.to_ne_bytes());
    let image = ClientImage::new_2d(&bytes, &PixelStore::TIGHT, [2, 1], pair).unwrap();
    let (mut depths, mut stencils) = ([0.5; 2], [0; 2]);
    image.depths([0, 0, 0], Transfer::NEUTRAL, &mut depths);
    image.stencils([0, 0, 0], Transfer::NEUTRAL, &mut stencils);
    assert_eq!((depths, stencils), ([1.0, 0.0], [0xAB, 3]));
}

#[test]
fn transfer_applies_on_the_way_in_and_out() {
    let mode = PixelTransfer { scale: [0.5; 4], bias: [0.25, 0.0, 0.0, 0.0], ..Default::default() };
    let mut maps = PixelMaps::default();
    maps.set(GL_PIXEL_MAP_I_TO_B, &[0.0, 1.0]).unwrap();
    let transfer = Transfer { mode: &mode, maps: &maps };
    let bytes = [255, 102, 0, 51];
    let image = ClientImage::new_2d(&bytes, &PixelStore::TIGHT, [1, 1], pixel(GL_RGBA, GL_UNSIGNED_BYTE)).unwrap();
    let mut texel = [0];
    image.colors_rgba8([0, 0, 0], transfer, &mut texel);
    assert_eq!(texel[0].to_le_bytes(), [191, 51, 0, 26]);
    let mut out = [0; 1];
    let mut to =
        ClientTarget::new_2d(&mut out, &PixelStore::TIGHT, [1, 1], pixel(GL_LUMINANCE, GL_UNSIGNED_BYTE)).unwrap();
    to.colors_rgba8([0, 0, 0], transfer, &[u32::from_le_bytes([51, 51, 102, 0])]);
    assert_eq!(out, [64 + 26 + 25 + 51], "(.1 + .25) + .1 + .2 = .65");
    // Scale and bias do not apply to colour indices.
    let index = [1, 0];
    let image =
        ClientImage::new_2d(&index, &PixelStore::TIGHT, [2, 1], pixel(GL_COLOR_INDEX, GL_UNSIGNED_BYTE)).unwrap();
    let mut colors = [[0.0; 4]; 2];
    image.colors([0, 0, 0], transfer, &mut colors);
    assert_eq!(colors, [[0.0, 0.0, 1.0, 0.0], [0.0; 4]]);
}
