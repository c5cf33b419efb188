//! Images of every internal format and border: what goes in, what a sampler reads, what comes out, the ring, levels.

use crate::enums::*;
use crate::pixels::{ClientImage, PixelFormat, Transfer, format};
use crate::simd::Level;
use crate::state::pixel::PixelStore;
use crate::state::texture::WrapMode;
use crate::texture::format::BlockFit;
use crate::texture::format::{BaseFormat, FORMATS, InternalFormat, Storage};
use crate::texture::image::{Dimensions, Image, Texels};
use crate::texture::mipmap;
use crate::texture::padding::{Padding, PaddingKey};
use crate::texture::wrap;

fn find(name: GLenum) -> &'static InternalFormat {
    InternalFormat::find(name).unwrap()
}

fn padding_key(wraps: [WrapMode; 3], border_color: [f32; 4]) -> PaddingKey {
    PaddingKey::new(wraps.map(|mode| wrap::row(mode).padding), border_color)
}

fn noise(n: usize) -> Vec<u8> {
    let mut state = 0x9E37_79B9u32;
    let step = |_| {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        (state >> 7) as u8
    };
    (0..n).map(step).collect()
}

fn rgba(bytes: &[u8], size: [i32; 3]) -> ClientImage<'_> {
    ClientImage::new_3d(bytes, &PixelStore::TIGHT, size, PixelFormat::new(GL_RGBA, GL_UNSIGNED_BYTE).unwrap()).unwrap()
}

/// An image of noise; `full` is its size with the border.
fn noisy(format: GLenum, dimensions: Dimensions, full: [u32; 3], border: u32) -> (Image, Vec<u8>) {
    let bytes = noise((full[0] * full[1] * full[2]) as usize * 4);
    let depth = find(format).base == BaseFormat::Depth;
    let pair = if depth { (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT) } else { (GL_RGBA, GL_UNSIGNED_BYTE) };
    let pixel = PixelFormat::new(pair.0, pair.1).unwrap();
    let size = full.map(|n| n as i32);
    let pixels = ClientImage::new_3d(&bytes, &PixelStore::TIGHT, size, pixel).unwrap();
    let image = Image::from_client(
        find(format),
        dimensions,
        full,
        border,
        Some(&pixels),
        Transfer::NEUTRAL,
        BlockFit::default(),
    )
    .unwrap();
    (image, bytes)
}

#[test]
fn the_table_has_every_format_once() {
    for (i, row) in FORMATS.iter().enumerate() {
        assert!(FORMATS[..i].iter().all(|other| other.requested != row.requested), "{}", name(row.requested));
        let s = row.sizes();
        let bits = [s.red, s.green, s.blue, s.alpha, s.luminance, s.intensity, s.depth];
        assert!(bits.iter().any(|&b| b > 0));
        let most = bits.into_iter().max().unwrap();
        assert_eq!(row.storage == Storage::Rgba8, most <= 8, "{}", name(row.requested));
        assert!(InternalFormat::find(row.base.name()).unwrap().base == row.base);
    }
    assert_eq!(FORMATS.iter().filter(|r| r.requested > 4 && r.s3tc.is_none() && r.reported == r.requested).count(), 45);
    assert_eq!(InternalFormat::of_tex_image(5).unwrap_err().code, GL_INVALID_VALUE);
    assert_eq!(InternalFormat::of_tex_image(-1).unwrap_err().code, GL_INVALID_VALUE);
    assert_eq!(InternalFormat::of_copy_tex_image(3).unwrap_err().code, GL_INVALID_ENUM);
    assert_eq!(InternalFormat::of_compressed_tex_image(GL_COMPRESSED_RGB).unwrap_err().code, GL_INVALID_ENUM);
    assert_eq!(find(GL_COMPRESSED_INTENSITY).reported, GL_INTENSITY);
}

/// The components a format takes from a colour, from table 3.15, and what a sampler reads.
fn expected(base: BaseFormat, [r, g, b, a]: [f64; 4]) -> [f64; 4] {
    match base {
        BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
        BaseFormat::Luminance => [r, r, r, 1.0],
        BaseFormat::LuminanceAlpha => [r, r, r, a],
        BaseFormat::Intensity => [r, r, r, r],
        BaseFormat::Rgb => [r, g, b, 1.0],
        BaseFormat::Rgba | BaseFormat::Depth => [r, g, b, a],
    }
}

#[test]
fn every_internal_format_takes_every_color_pair() {
    for internal in FORMATS.iter().filter(|f| f.base != BaseFormat::Depth && f.s3tc.is_none()) {
        for (form, type_) in format::all_pairs() {
            let Ok(pixel) = PixelFormat::for_command(form, type_, format::Purpose::TexImage) else { continue };
            if pixel.kind() != format::PixelKind::Color {
                continue;
            }
            let mut bytes = noise(5 * 3 * 16);
            if type_ == GL_FLOAT {
                // Noise as floats is mostly far out of range: take fractions, and some that clamp.
                for (i, f) in bytes.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                    *f = (f32::from(f[0]) / 200.0 - 0.1 + i as f32 * 1e-4).to_ne_bytes();
                }
            }
            let client = ClientImage::new_2d(&bytes, &PixelStore::TIGHT, [5, 3], pixel).unwrap();
            let image = Image::from_client(
                internal,
                Dimensions::Two,
                [5, 3, 1],
                0,
                Some(&client),
                Transfer::NEUTRAL,
                BlockFit::default(),
            )
            .unwrap();
            for (x, y) in (0..5).flat_map(|x| (0..3).map(move |y| (x, y))) {
                let mut group = [[0.0; 4]];
                client.colors([x, y, 0], Transfer::NEUTRAL, &mut group);
                let want = expected(internal.base, group[0].map(f64::from));
                let got = image.texel(x as i32, y as i32, 0);
                for c in 0..4 {
                    let bits = match internal.storage {
                        Storage::Rgba8 => 8,
                        _ if c == 3 && internal.base != BaseFormat::Intensity => internal.alpha_bits.max(1),
                        _ => internal.color_bits.max(1),
                    };
                    let max = f64::from((1u32 << bits) - 1);
                    let steps = f64::from(got[c]) * max;
                    assert!((f64::from(got[c]) - want[c]).abs() <= 0.5001 / max, "{} {got:?} {want:?}", name(form));
                    assert!((steps - steps.round()).abs() < 1e-2, "{} keeps {bits} bits", name(internal.requested));
                }
            }
        }
    }
}

#[test]
fn depth_formats_keep_their_bits_and_refuse_colors() {
    for (format, bits) in [(GL_DEPTH_COMPONENT16, 16), (GL_DEPTH_COMPONENT24, 24), (GL_DEPTH_COMPONENT, 24)] {
        let (image, bytes) = noisy(format, Dimensions::Two, [4, 2, 1], 0);
        let max = f64::from((1u32 << bits) - 1);
        for (i, value) in bytes.as_chunks::<4>().0.iter().enumerate() {
            let want = f64::from(u32::from_ne_bytes(*value)) / f64::from(u32::MAX);
            let got = f64::from(image.texel(i as i32 % 4, i as i32 / 4, 0)[0]);
            // A float on the way costs up to half a step of 24 bits more.
            assert!((got - want).abs() <= (0.5 + 0.6 / f64::from(1u32 << (24 - bits))) / max);
            assert!((got * max - (got * max).round()).abs() < 0.51);
        }
        let wrong = Image::from_client(
            find(format),
            Dimensions::Two,
            [1, 1, 1],
            0,
            Some(&rgba(&[0; 4], [1, 1, 1])),
            Transfer::NEUTRAL,
            BlockFit::default(),
        );
        assert_eq!(wrong.unwrap_err().code, GL_INVALID_OPERATION);
        let mut out = [0; 64];
        assert_eq!(
            image.get_tex_image(&PixelStore::TIGHT, GL_RGBA, GL_UNSIGNED_BYTE, &mut out).unwrap_err().code,
            GL_INVALID_OPERATION
        );
        image.get_tex_image(&PixelStore::TIGHT, GL_DEPTH_COMPONENT, GL_FLOAT, &mut out).unwrap();
        assert_eq!(f32::from_ne_bytes(out[4..8].try_into().unwrap()), image.texel(1, 0, 0)[0]);
    }
}

#[test]
fn readback_puts_components_where_the_table_says() {
    for internal in FORMATS.iter().filter(|f| f.base != BaseFormat::Depth && f.s3tc.is_none()) {
        let (image, bytes) = noisy(internal.requested, Dimensions::Two, [3, 2, 1], 0);
        let mut out = [0; 24];
        image.get_tex_image(&PixelStore::TIGHT, GL_RGBA, GL_UNSIGNED_BYTE, &mut out).unwrap();
        for (got, &[r, g, b, a]) in out.as_chunks::<4>().0.iter().zip(bytes.as_chunks::<4>().0) {
            let a = if internal.alpha_bits == 2 || internal.alpha_bits == 4 && internal.storage == Storage::Float {
                let max = (1u32 << internal.alpha_bits) - 1;
                ((f64::from(a) / 255.0 * f64::from(max)).round() / f64::from(max) * 255.0).round() as u8
            } else {
                a
            };
            let want = match internal.base {
                BaseFormat::Alpha => [0, 0, 0, a],
                BaseFormat::Luminance | BaseFormat::Intensity => [r, 0, 0, 255],
                BaseFormat::LuminanceAlpha => [r, 0, 0, a],
                BaseFormat::Rgb => [r, g, b, 255],
                _ => [r, g, b, a],
            };
            assert_eq!(*got, want, "{}", name(internal.requested));
        }
        // A luminance read as luminance is itself.
        if internal.base == BaseFormat::Luminance {
            let mut out = [0; 6];
            image.get_tex_image(&PixelStore::TIGHT, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut out).unwrap();
            assert!(out.iter().zip(bytes.chunks(4)).all(|(l, c)| *l == c[0]));
        }
    }
}

#[test]
fn the_border_is_data() {
    let cases = [(Dimensions::One, [6, 1, 1]), (Dimensions::Two, [6, 4, 1]), (Dimensions::Three, [6, 4, 3])];
    for (dimensions, full) in cases {
        for format in [GL_RGBA8, GL_RGBA16, GL_DEPTH_COMPONENT24] {
            let (image, bytes) = noisy(format, dimensions, full, 1);
            assert_eq!(image.width, full[0] - 2);
            assert_eq!(image.full_size(), full);
            let pair = if format == GL_DEPTH_COMPONENT24 {
                (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT)
            } else {
                (GL_RGBA, GL_UNSIGNED_BYTE)
            };
            let len = image.get_tex_image_bytes(&PixelStore::TIGHT, pair.0, pair.1).unwrap();
            assert_eq!(len, bytes.len());
            let mut padded = image.clone();
            padded
                .fill_padding(&padding_key(
                    [WrapMode::Repeat, WrapMode::ClampToEdge, WrapMode::MirroredRepeat],
                    [1.0; 4],
                ))
                .unwrap();
            for image in [image, padded] {
                let mut out = vec![0; len];
                image.get_tex_image(&PixelStore::TIGHT, pair.0, pair.1, &mut out).unwrap();
                if format == GL_DEPTH_COMPONENT24 {
                    let high = |b: &[u8]| u32::from_ne_bytes(b.try_into().unwrap()) >> 9;
                    assert!(out.chunks(4).zip(bytes.chunks(4)).all(|(a, b)| high(a).abs_diff(high(b)) <= 1));
                } else {
                    assert_eq!(out, bytes);
                }
            }
        }
    }
}

/// Which texel stands at `i` of a dimension of `n` texels: another one, or `None` for the border.
fn wrapped(i: i32, n: i32, pad: Padding) -> Option<i32> {
    match pad {
        _ if (0..n).contains(&i) => Some(i),
        Padding::Repeat => Some(i.rem_euclid(n)),
        Padding::Edge => Some(i.clamp(0, n - 1)),
        Padding::MirrorBorder if i < 0 => Some(0),
        Padding::Border | Padding::MirrorBorder => None,
    }
}

#[test]
fn the_ring_is_what_the_wraps_ask_for() {
    let wraps = [WrapMode::Repeat, WrapMode::ClampToEdge, WrapMode::Clamp, WrapMode::MirrorClampToBorder];
    let cases = [
        (Dimensions::One, [4, 1, 1]),
        (Dimensions::One, [1, 1, 1]),
        (Dimensions::Two, [4, 3, 1]),
        (Dimensions::Two, [1, 5, 1]),
        (Dimensions::Three, [3, 1, 2]),
    ];
    for (dimensions, size) in cases {
        for (format, border) in [(GL_RGBA8, 0), (GL_RGBA8, 1), (GL_RGBA16, 1), (GL_DEPTH_COMPONENT24, 0)] {
            let has = [true, dimensions != Dimensions::One, dimensions == Dimensions::Three];
            let full: [u32; 3] = std::array::from_fn(|a| size[a] + if has[a] { 2 * border } else { 0 });
            let (mut image, _) = noisy(format, dimensions, full, border);
            let original = image.clone();
            for n in 0..64usize {
                let wrap = [wraps[n & 3], wraps[n >> 2 & 3], wraps[n >> 4]];
                let key = padding_key(wrap, [0.2, 0.4, 0.6, 0.8]);
                image.fill_padding(&key).unwrap();
                assert!(image.is_padded_for(&key));
                let range = |a: usize| if has[a] { -1..size[a] as i32 + 1 } else { 0..1 };
                for (i, j, k) in range(2).flat_map(|k| range(1).flat_map(move |j| range(0).map(move |i| (i, j, k)))) {
                    let at = [i, j, k];
                    let to: [Option<i32>; 3] = std::array::from_fn(|a| wrapped(at[a], size[a] as i32, key.pads()[a]));
                    let want = if let [Some(i), Some(j), Some(k)] = to {
                        original.texel(i, j, k)
                    } else if border == 0 {
                        if format == GL_RGBA8 { [0.2, 0.4, 0.6, 0.8] } else { [image.border_texel([0.2; 4])[0]; 4] }
                    } else {
                        // A mirror at its low end reads the edge, beyond that the border texel of that place.
                        original.texel(to[0].unwrap_or(i), to[1].unwrap_or(j), to[2].unwrap_or(k))
                    };
                    let got = image.texel(i, j, k);
                    let channels = if format == GL_DEPTH_COMPONENT24 { 3 } else { 4 };
                    assert_eq!(got[..channels], want[..channels], "{dimensions:?} {border} {wrap:?} {i} {j} {k}");
                }
            }
        }
    }
}

#[test]
fn writing_forgets_the_padding_and_keeps_the_border() {
    let (mut image, _) = noisy(GL_RGBA8, Dimensions::Two, [6, 6, 1], 1);
    let border = image.texel(-1, 2, 0);
    image.fill_padding(&padding_key([WrapMode::Repeat; 3], [0.0; 4])).unwrap();
    assert_ne!(image.texel(-1, 2, 0), border);
    image.upload([0, 0, 0], &rgba(&[9; 4], [1, 1, 1]), Transfer::NEUTRAL).unwrap();
    assert_eq!((image.texel(-1, 2, 0), image.texel(0, 0, 0)), (border, [9.0 / 255.0; 4]));
    image.upload([-1, 2, 0], &rgba(&[8; 4], [1, 1, 1]), Transfer::NEUTRAL).unwrap();
    assert_eq!(image.texel(-1, 2, 0), [8.0 / 255.0; 4]);
    let (mut image, _) = noisy(GL_RGBA8, Dimensions::Two, [4, 4, 1], 0);
    let key = padding_key([WrapMode::Repeat; 3], [0.0; 4]);
    image.fill_padding(&key).unwrap();
    image.write_rgba8([0, 0, 0], &[u32::MAX], Transfer::NEUTRAL);
    assert!(!image.is_padded_for(&key));
    image.fill_padding(&key).unwrap();
    assert_eq!(image.texel(4, 4, 0), [1.0; 4]);
}

#[test]
fn regions_are_checked_and_rows_are_clipped() {
    let (mut image, _) = noisy(GL_RGBA8, Dimensions::Two, [4, 4, 1], 0);
    let before = image.texels.clone();
    for (offset, size) in [
        ([-1, 0, 0], [1, 1, 1]),
        ([4, 0, 0], [1, 1, 1]),
        ([0, 3, 0], [1, 2, 1]),
        ([0, 0, 1], [1, 1, 1]),
        ([i32::MAX, 0, 0], [1, 1, 1]),
        ([0, i32::MIN, 0], [1, 1, 1]),
    ] {
        let bytes = [1; 16];
        let error = image.upload(offset, &rgba(&bytes, size), Transfer::NEUTRAL).unwrap_err();
        assert_eq!(error.code, GL_INVALID_VALUE);
    }
    assert!(image.check_region([4, 4, 0], [0, 0, 1]).is_ok(), "an empty region at the corner");
    for at in [[-5, 0, 0], [4, 0, 0], [0, -1, 0], [0, 4, 0], [0, 0, 1], [i32::MIN, 0, 0], [i32::MAX, 1, 0]] {
        image.write_rgba8(at, &[0x0102_0304; 4], Transfer::NEUTRAL);
    }
    assert_eq!(image.texels, before);
    image.write_rgba8([-2, 1, 0], &[1, 2, 3, 4, 5, 6, 7, 8], Transfer::NEUTRAL);
    let Texels::Rgba8(texels) = &image.texels else { panic!() };
    let at = image.index(0, 1, 0);
    assert_eq!(texels[at..at + 4], [3, 4, 5, 6]);
    assert_eq!((texels[at - 1], texels[at + 4]), (0, 0), "the ring is untouched");
}

#[test]
fn absurd_sizes_are_out_of_memory() {
    let error = Image::new(find(GL_RGBA16), Dimensions::Three, [u32::MAX, u32::MAX, u32::MAX], 0).unwrap_err();
    assert_eq!(error.code, GL_OUT_OF_MEMORY);
    let empty = Image::new(find(GL_RGBA), Dimensions::Two, [0, 5, 1], 0).unwrap();
    assert!(empty.is_null());
    let mut empty = empty;
    empty.fill_padding(&padding_key([WrapMode::Repeat; 3], [0.0; 4])).unwrap();
    assert!(mipmap::levels(&empty, 5, Level::BASELINE, &mut []).unwrap().is_empty());
    let mut out = [];
    empty.get_tex_image(&PixelStore::TIGHT, GL_RGBA, GL_FLOAT, &mut out).unwrap();
}

fn mean(image: &Image) -> [f64; 4] {
    let mut sum = [0.0; 4];
    let [w, h, d] = [image.width, image.height, image.depth].map(|n| n as i32);
    for (i, j, k) in (0..d).flat_map(|k| (0..h).flat_map(move |j| (0..w).map(move |i| (i, j, k)))) {
        for (s, v) in sum.iter_mut().zip(image.texel(i, j, k)) {
            *s += f64::from(v);
        }
    }
    sum.map(|s| s / f64::from(w * h * d))
}

#[test]
fn every_level_has_the_mean_of_the_image() {
    let cases = [
        (Dimensions::One, [37, 1, 1]),
        (Dimensions::Two, [64, 64, 1]),
        (Dimensions::Two, [31, 17, 1]),
        (Dimensions::Two, [1, 100, 1]),
        (Dimensions::Three, [8, 6, 5]),
    ];
    for (dimensions, size) in cases {
        for format in [GL_RGBA8, GL_RGBA16, GL_DEPTH_COMPONENT24] {
            let (image, _) = noisy(format, dimensions, size, 0);
            let levels = mipmap::levels(&image, usize::MAX, Level::BASELINE, &mut []).unwrap();
            assert_eq!(levels.len(), mipmap::levels_below(size));
            let (whole, mut want) = (mean(&image), size);
            for level in &levels {
                want = want.map(|n: u32| (n / 2).max(1));
                assert_eq!([level.width, level.height, level.depth], want);
                // Rounding of one level: half a step for one texel, less for the mean of many.
                let step = if format == GL_RGBA8 { 0.5 / 255.0 } else { 0.5 / 65535.0 };
                for (a, b) in mean(level).iter().zip(whole) {
                    assert!((a - b).abs() <= step * 1.001 + 1e-6, "{size:?} {want:?} {a} {b}");
                }
            }
            assert_eq!(levels.last().map(Image::full_size), Some([1, 1, 1]));
        }
    }
}

#[test]
fn levels_of_constants_ramps_and_known_texels_are_their_means() {
    let bytes = [10, 20, 30, 40].repeat(7 * 5);
    let image = Image::from_client(
        find(4),
        Dimensions::Two,
        [7, 5, 1],
        0,
        Some(&rgba(&bytes, [7, 5, 1])),
        Transfer::NEUTRAL,
        BlockFit::default(),
    )
    .unwrap();
    for level in mipmap::levels(&image, 9, Level::BASELINE, &mut []).unwrap() {
        let Texels::Rgba8(texels) = &level.texels else { panic!() };
        assert_eq!(texels[level.origin()], u32::from_le_bytes([10, 20, 30, 40]));
        assert_eq!(level.internal_format, 4);
    }
    // The mean of 1, 2, 2, 2 is 1.75, of 1, 1, 2, 2 a tie that goes up.
    let bytes: Vec<u8> = [1, 2, 2, 2].iter().zip([1, 1, 2, 2]).flat_map(|(&r, g)| [r, g, 0, 255]).collect();
    let image = Image::from_client(
        find(4),
        Dimensions::Two,
        [2, 2, 1],
        0,
        Some(&rgba(&bytes, [2, 2, 1])),
        Transfer::NEUTRAL,
        BlockFit::default(),
    )
    .unwrap();
    let levels = mipmap::levels(&image, 1, Level::BASELINE, &mut []).unwrap();
    assert_eq!(levels[0].texel(0, 0, 0).map(|c| (c * 255.0) as u8), [2, 2, 0, 255]);
    // A ramp stays a ramp: texel centres are where they should be (odd size, float texels).
    let n = 1023u16;
    let bytes: Vec<u8> = (0..n).flat_map(|i| (i * 64).to_ne_bytes()).collect();
    let pixel = PixelFormat::new(GL_LUMINANCE, GL_UNSIGNED_SHORT).unwrap();
    let client = ClientImage::new_2d(&bytes, &PixelStore::TIGHT, [n.into(), 1], pixel).unwrap();
    let image = Image::from_client(
        find(GL_LUMINANCE16),
        Dimensions::One,
        [n.into(), 1, 1],
        0,
        Some(&client),
        Transfer::NEUTRAL,
        BlockFit::default(),
    )
    .unwrap();
    for level in mipmap::levels(&image, 9, Level::BASELINE, &mut []).unwrap() {
        let scale = f64::from(n) / f64::from(level.width);
        for i in 1..level.width as i32 - 1 {
            let want = (f64::from(i) + 0.5) * scale - 0.5;
            let got = f64::from(level.texel(i, 0, 0)[0]) * 65535.0 / 64.0;
            assert!((got - want).abs() / scale < 0.03, "{i} of {}: {got} {want}", level.width);
        }
    }
}

#[test]
fn borders_are_reduced_along_their_edges() {
    let (image, _) = noisy(GL_RGBA16, Dimensions::Two, [6, 6, 1], 1);
    let level = &mipmap::levels(&image, 1, Level::BASELINE, &mut []).unwrap()[0];
    assert_eq!((level.width, level.border), (2, 1));
    let close = |a: [f32; 4], b: [f32; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(close(level.texel(-1, -1, 0), image.texel(-1, -1, 0)), "corners stay");
    assert!(close(level.texel(2, 2, 0), image.texel(4, 4, 0)));
    let half = |a: [f32; 4], b: [f32; 4]| std::array::from_fn(|c| (a[c] + b[c]) / 2.0);
    assert!(close(level.texel(1, -1, 0), half(image.texel(2, -1, 0), image.texel(3, -1, 0))));
    assert!(close(level.texel(-1, 0, 0), half(image.texel(-1, 0, 0), image.texel(-1, 1, 0))));
}
