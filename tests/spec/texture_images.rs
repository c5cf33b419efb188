//! Texture images (sections 3.8.1 to 3.8.3, 3.8.8, 6.1.3, 6.1.4) through the commands of a context: what every internal
//! format keeps and reports, borders, parts, levels, compressed blocks, errors that change nothing.

use fixedgl::Context;
use fixedgl::enums::*;

/// Which of R, G, B, A a format keeps (a luminance or an intensity is R) and the bits of colour and alpha that it must
/// keep at least.
const FORMATS: [(i32, &str, u32, u32); 42] = [
    (1, "L", 8, 0),
    (2, "LA", 8, 8),
    (3, "RGB", 8, 0),
    (4, "RGBA", 8, 8),
    (GL_ALPHA as i32, "A", 0, 8),
    (GL_ALPHA4 as i32, "A", 0, 4),
    (GL_ALPHA8 as i32, "A", 0, 8),
    (GL_ALPHA12 as i32, "A", 0, 12),
    (GL_ALPHA16 as i32, "A", 0, 16),
    (GL_LUMINANCE as i32, "L", 8, 0),
    (GL_LUMINANCE4 as i32, "L", 4, 0),
    (GL_LUMINANCE8 as i32, "L", 8, 0),
    (GL_LUMINANCE12 as i32, "L", 12, 0),
    (GL_LUMINANCE16 as i32, "L", 16, 0),
    (GL_LUMINANCE_ALPHA as i32, "LA", 8, 8),
    (GL_LUMINANCE4_ALPHA4 as i32, "LA", 4, 4),
    (GL_LUMINANCE6_ALPHA2 as i32, "LA", 6, 2),
    (GL_LUMINANCE8_ALPHA8 as i32, "LA", 8, 8),
    (GL_LUMINANCE12_ALPHA4 as i32, "LA", 12, 4),
    (GL_LUMINANCE12_ALPHA12 as i32, "LA", 12, 12),
    (GL_LUMINANCE16_ALPHA16 as i32, "LA", 16, 16),
    (GL_INTENSITY as i32, "I", 8, 0),
    (GL_INTENSITY4 as i32, "I", 4, 0),
    (GL_INTENSITY8 as i32, "I", 8, 0),
    (GL_INTENSITY12 as i32, "I", 12, 0),
    (GL_INTENSITY16 as i32, "I", 16, 0),
    (GL_R3_G3_B2 as i32, "RGB", 3, 0),
    (GL_RGB as i32, "RGB", 8, 0),
    (GL_RGB4 as i32, "RGB", 4, 0),
    (GL_RGB5 as i32, "RGB", 5, 0),
    (GL_RGB8 as i32, "RGB", 8, 0),
    (GL_RGB10 as i32, "RGB", 10, 0),
    (GL_RGB12 as i32, "RGB", 12, 0),
    (GL_RGB16 as i32, "RGB", 16, 0),
    (GL_RGBA as i32, "RGBA", 8, 8),
    (GL_RGBA2 as i32, "RGBA", 2, 2),
    (GL_RGBA4 as i32, "RGBA", 4, 4),
    (GL_RGB5_A1 as i32, "RGBA", 5, 1),
    (GL_RGBA8 as i32, "RGBA", 8, 8),
    (GL_RGB10_A2 as i32, "RGBA", 10, 2),
    (GL_RGBA12 as i32, "RGBA", 12, 12),
    (GL_RGBA16 as i32, "RGBA", 16, 16),
];

fn level(gl: &mut Context, target: GLenum, level: i32, pname: GLenum) -> i32 {
    let mut value = [-77; 4];
    gl.get_tex_level_parameteriv(target, level, pname, &mut value);
    assert_eq!(gl.get_error(), GL_NO_ERROR, "{}", name(pname));
    value[0]
}

fn read(gl: &mut Context, target: GLenum, at: i32, texels: usize) -> Vec<f32> {
    let mut out = vec![-7.0f32; texels * 4];
    gl.get_tex_image(target, at, GL_RGBA, GL_FLOAT, &mut out[..]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    out
}

/// Texels that differ everywhere.
fn noise(n: usize) -> Vec<u8> {
    (0..n as u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 21) as u8).collect()
}

#[test]
fn every_internal_format_keeps_its_components() {
    let mut gl = Context::new(4, 4);
    let pixels: Vec<f32> = (0..64u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 8) as f32 / 16_777_216.0).collect();
    for (format, components, color, alpha) in FORMATS {
        gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_RGBA, GL_FLOAT, &pixels[..]);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT), format);
        let sizes = [
            (GL_TEXTURE_RED_SIZE, "R"),
            (GL_TEXTURE_GREEN_SIZE, "G"),
            (GL_TEXTURE_BLUE_SIZE, "B"),
            (GL_TEXTURE_ALPHA_SIZE, "A"),
            (GL_TEXTURE_LUMINANCE_SIZE, "L"),
            (GL_TEXTURE_INTENSITY_SIZE, "I"),
        ]
        .map(|(pname, letter)| (letter, level(&mut gl, GL_TEXTURE_2D, 0, pname) as u32));
        let mut kept = [0; 2];
        for (letter, bits) in sizes {
            let least = if letter == "A" { alpha } else { color };
            assert_eq!(bits > 0, components.contains(letter), "{format:#x} {letter}");
            if bits > 0 {
                assert!(bits >= least, "{format:#x} keeps {bits} bits of {letter}");
                kept[usize::from(letter == "A")] = bits;
            }
        }
        for (got, want) in read(&mut gl, GL_TEXTURE_2D, 0, 16).chunks(4).zip(pixels.chunks(4)) {
            let has = |letter: &str| components.contains(letter);
            let red = has("R") || has("L") || has("I");
            let want =
                [(red, want[0], 0.0), (has("G"), want[1], 0.0), (has("B"), want[2], 0.0), (has("A"), want[3], 1.0)];
            for (c, (has, value, missing)) in want.into_iter().enumerate() {
                let bits = kept[usize::from(c == 3)];
                if has {
                    assert!((got[c] - value).abs() <= 0.501 / ((1u32 << bits) - 1) as f32, "{format:#x} {got:?}");
                } else if components == "A" || c == 3 {
                    assert_eq!(got[c], if c == 3 { 1.0 } else { 0.0 });
                } else {
                    assert_eq!(got[c], missing);
                }
            }
        }
    }
}

#[test]
fn generic_compressed_formats_are_stored_uncompressed() {
    let mut gl = Context::new(4, 4);
    for (generic, base) in [
        (GL_COMPRESSED_ALPHA, GL_ALPHA),
        (GL_COMPRESSED_LUMINANCE, GL_LUMINANCE),
        (GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA),
        (GL_COMPRESSED_INTENSITY, GL_INTENSITY),
        (GL_COMPRESSED_RGB, GL_RGB),
        (GL_COMPRESSED_RGBA, GL_RGBA),
    ] {
        gl.tex_image_2d(GL_TEXTURE_2D, 0, generic, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &noise(64)[..]);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT), base as i32);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED), 0);
    }
}

#[test]
fn depth_images_take_and_give_depths_only() {
    let mut gl = Context::new(4, 4);
    let depths: Vec<f32> = (0..16).map(|i| i as f32 / 15.0).collect();
    for (format, bits) in
        [(GL_DEPTH_COMPONENT, 16), (GL_DEPTH_COMPONENT16, 16), (GL_DEPTH_COMPONENT24, 24), (GL_DEPTH_COMPONENT32, 24)]
    {
        gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depths[..]);
        let kept = level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE);
        assert!(kept >= bits, "{}", name(format));
        let mut out = [7.0f32; 16];
        gl.get_tex_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &mut out[..]);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        for (got, want) in out.iter().zip(&depths) {
            assert!((f64::from(*got) - f64::from(*want)).abs() <= 0.51 / (2f64.powi(kept) - 1.0));
        }
        let mut color = [0u8; 64];
        gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut color[..]);
        assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
        gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &color[..]);
        assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    }
    gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 1, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depths[..]);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
}

#[test]
fn borders_belong_to_the_image() {
    let mut gl = Context::new(4, 4);
    let pixels = noise(6 * 4 * 4 * 4);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 6, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..96]);
    assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), 6);
    assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT), 4);
    assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER), 1);
    let mut out = vec![0u8; 96];
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out[..]);
    assert_eq!(out, pixels[..96]);
    // Offsets count from the interior: -1 is the border.
    gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, -1, 2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[9u8; 8]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    let mut want = pixels[..96].to_vec();
    want[3 * 24..3 * 24 + 8].fill(9);
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out[..]);
    assert_eq!(out, want);
    for (x, y, w, h) in [(-2, 0, 1, 1), (5, 0, 1, 1), (-1, -2, 1, 1), (0, 2, 1, 2), (i32::MAX, 0, 1, 1)] {
        gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
        assert_eq!(gl.get_error(), GL_INVALID_VALUE, "{x} {y}");
    }
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out[..]);
    assert_eq!(out, want);
    gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8, 6, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
    let mut out = vec![0u8; pixels.len()];
    gl.get_tex_image(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out[..]);
    assert_eq!((out, gl.get_error()), (pixels, GL_NO_ERROR));
}

#[test]
fn bad_images_leave_the_old_one() {
    let mut gl = Context::new(4, 4);
    let pixels = noise(16);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
    for (format, w, h, border, code) in [
        (5, 2, 2, 0, GL_INVALID_VALUE),
        (0, 2, 2, 0, GL_INVALID_VALUE),
        (-1, 2, 2, 0, GL_INVALID_VALUE),
        (GL_RGBA as i32, -1, 2, 0, GL_INVALID_VALUE),
        (GL_RGBA as i32, 2, 2, 2, GL_INVALID_VALUE),
        (GL_RGBA as i32, 2, 1 << 20, 0, GL_INVALID_VALUE),
        (GL_RGBA as i32, 3, 2, 0, GL_INVALID_OPERATION),
        (GL_DEPTH_COMPONENT as i32, 2, 2, 0, GL_INVALID_OPERATION),
    ] {
        gl.tex_image_2d(GL_TEXTURE_2D, 0, format, w, h, border, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
        let error = gl.get_error();
        // Too little memory for the pixels is said before the engine sees them, as a value.
        assert!(
            error == code || code == GL_INVALID_OPERATION && error == GL_INVALID_VALUE,
            "{format} {w} {h}: {error:x}"
        );
        let mut out = [0u8; 16];
        gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut out[..]);
        assert_eq!(out, pixels[..]);
    }
}

#[test]
fn generated_levels_are_means_of_the_base() {
    let mut gl = Context::new(4, 4);
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    for (w, h) in [(64usize, 32usize), (31, 17), (100, 1)] {
        let pixels = noise(w * h * 3);
        gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB, w as i32, h as i32, 0, GL_RGB, GL_UNSIGNED_BYTE, &pixels[..]);
        let mean: Vec<f64> = (0..3)
            .map(|c| pixels.iter().skip(c).step_by(3).map(|&v| f64::from(v)).sum::<f64>() / (w * h) as f64)
            .collect();
        let (mut lw, mut lh, mut n) = (w, h, 0);
        while lw > 1 || lh > 1 {
            (lw, lh, n) = ((lw / 2).max(1), (lh / 2).max(1), n + 1);
            assert_eq!(level(&mut gl, GL_TEXTURE_2D, n, GL_TEXTURE_WIDTH), lw as i32);
            assert_eq!(level(&mut gl, GL_TEXTURE_2D, n, GL_TEXTURE_HEIGHT), lh as i32);
            let texels = read(&mut gl, GL_TEXTURE_2D, n, lw * lh);
            for c in 0..3 {
                let sum: f64 = texels.iter().skip(c).step_by(4).map(|&v| f64::from(v) * 255.0).sum();
                assert!((sum / (lw * lh) as f64 - mean[c]).abs() <= 0.501, "level {n} of {w} x {h}");
            }
        }
        // An even size: every texel is the mean of four.
        if w % 2 == 0 && h % 2 == 0 {
            let level1 = read(&mut gl, GL_TEXTURE_2D, 1, w / 2 * (h / 2));
            for (x, y) in (0..h / 2).flat_map(|y| (0..w / 2).map(move |x| (x, y))) {
                let at = |dx: usize, dy: usize| u32::from(pixels[((2 * y + dy) * w + 2 * x + dx) * 3]);
                let want = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4;
                assert_eq!((level1[(y * (w / 2) + x) * 4] * 255.0).round() as u32, want);
            }
        }
    }
    assert_eq!(gl.get_error(), GL_NO_ERROR);
}

#[test]
fn compressed_images_come_back_as_they_were_given() {
    let mut gl = Context::new(4, 4);
    for (format, bytes) in [
        (GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8),
        (GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8),
        (GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 16),
        (GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16),
    ] {
        let blocks = noise(2 * 2 * bytes);
        let size = blocks.len() as i32;
        gl.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 6, 5, 0, size, &blocks[..]);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT), format as i32);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED), 1);
        assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE), size);
        let mut out = vec![0u8; blocks.len()];
        gl.get_compressed_tex_image(GL_TEXTURE_2D, 0, &mut out[..]);
        assert_eq!((&out, gl.get_error()), (&blocks, GL_NO_ERROR));
        gl.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 6, 5, 0, size - 1, &blocks[..]);
        assert_eq!(gl.get_error(), GL_INVALID_VALUE);
        gl.compressed_tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 0, 4, 4, format, bytes as i32, &blocks[..]);
        assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
        gl.compressed_tex_sub_image_2d(GL_TEXTURE_2D, 0, 4, 4, 2, 1, format, bytes as i32, &blocks[..]);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        gl.get_compressed_tex_image(GL_TEXTURE_2D, 0, &mut out[..]);
        assert_eq!(out[3 * bytes..], blocks[..bytes]);
    }
    // A red and a blue end: codes 0 and 1 are the ends, 2 and 3 lie at a third and two thirds.
    let block = [0x00u8, 0xF8, 0x1F, 0x00, 0b11_10_01_00, 0, 0, 0];
    gl.compressed_tex_image_2d(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8, &block[..]);
    let got = read(&mut gl, GL_TEXTURE_2D, 0, 16);
    for (texel, red) in got.chunks(4).zip([1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0]) {
        assert!((texel[0] - red).abs() < 0.5 / 255.0 && (texel[2] - (1.0 - red)).abs() < 0.5 / 255.0);
    }
    let mut out = [0u8; 8];
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, &noise(48)[..]);
    gl.get_compressed_tex_image(GL_TEXTURE_2D, 0, &mut out[..]);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    for (border, code) in [(1, GL_INVALID_OPERATION), (2, GL_INVALID_VALUE), (-1, GL_INVALID_VALUE)] {
        gl.compressed_tex_image_2d(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, border, 8, &block[..]);
        assert_eq!(gl.get_error(), code, "border {border}");
    }
    gl.compressed_tex_image_3d(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 1, 0, 8, &block[..]);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
}

#[test]
fn uncompressed_pixels_under_a_block_format_become_blocks() {
    let mut gl = Context::new(4, 4);
    let pixels: Vec<u8> = (0..64).flat_map(|i| if i % 8 < 4 { [255, 0, 0, 255] } else { [0, 255, 0, 0] }).collect();
    let format = GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
    gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
    assert_eq!(level(&mut gl, GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE), 32);
    let got = read(&mut gl, GL_TEXTURE_2D, 0, 64);
    for (i, texel) in got.chunks(4).enumerate() {
        assert_eq!(texel, if i % 8 < 4 { [1.0, 0.0, 0.0, 1.0] } else { [0.0; 4] }, "texel {i}");
    }
}

#[test]
fn nicest_blocks_are_nearer_and_the_hint_of_the_image_counts() {
    let format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    let pixels: Vec<u8> = noise(16 * 16 * 4).iter().zip(0u32..).map(|(n, i)| (i / 5 % 200) as u8 + n % 50).collect();
    let error = |gl: &mut Context, at: i32, want: &[f32]| -> f32 {
        let got = read(gl, GL_TEXTURE_2D, at, want.len() / 4);
        got.iter().zip(want).enumerate().filter(|(i, _)| i % 4 != 3).map(|(_, (a, b))| (a - b).powi(2)).sum()
    };
    // The image itself, its level 1 against the uncompressed one, and a part written under another hint.
    let make = |format: u32, specify: u32, change: u32| {
        let mut gl = Context::new(4, 4);
        gl.hint(GL_TEXTURE_COMPRESSION_HINT, specify);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
        gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..]);
        gl.hint(GL_TEXTURE_COMPRESSION_HINT, change);
        gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, &pixels[..256]);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        gl
    };
    let want = read(&mut make(GL_RGBA8, GL_DONT_CARE, GL_DONT_CARE), GL_TEXTURE_2D, 0, 256);
    let errors = |specify, change, at| {
        let mut gl = make(format, specify, change);
        let of_base = if at == 0 {
            want.clone()
        } else {
            // What the level is made of are the decoded texels of the base level.
            let base: Vec<f32> = read(&mut gl, GL_TEXTURE_2D, 0, 256);
            let mut plain = Context::new(4, 4);
            plain.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
            plain.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_FLOAT, &base[..]);
            read(&mut plain, GL_TEXTURE_2D, 1, 64)
        };
        error(&mut gl, at, &of_base)
    };
    for at in [0, 1] {
        let (fast, dont_care, nice) = (
            errors(GL_FASTEST, GL_FASTEST, at),
            errors(GL_DONT_CARE, GL_DONT_CARE, at),
            errors(GL_NICEST, GL_NICEST, at),
        );
        assert_eq!(fast, dont_care);
        assert!(nice < 0.9 * fast, "level {at}: {nice} against {fast}");
        assert_eq!(errors(GL_NICEST, GL_FASTEST, at), nice, "the hint of TexImage counts");
        assert_eq!(errors(GL_FASTEST, GL_NICEST, at), fast, "the hint of TexImage counts");
    }
}

/// A pixel format and which of R, G, B, A its components are. A luminance is R: GetTexImage packs the groups of table 6.1
/// and makes no sum (section 6.1.4).
const READ_FORMATS: [(GLenum, &[usize]); 10] = [
    (GL_RED, &[0]),
    (GL_GREEN, &[1]),
    (GL_BLUE, &[2]),
    (GL_ALPHA, &[3]),
    (GL_RGB, &[0, 1, 2]),
    (GL_BGR, &[2, 1, 0]),
    (GL_RGBA, &[0, 1, 2, 3]),
    (GL_BGRA, &[2, 1, 0, 3]),
    (GL_LUMINANCE, &[0]),
    (GL_LUMINANCE_ALPHA, &[0, 3]),
];

#[test]
fn every_base_format_is_read_back_in_every_format_by_table_6_1() {
    // A base format in 8 and in 16 bits, and what (0.2, 0.4, 0.6, 0.8) is in table 6.1.
    let bases: [([i32; 2], [f32; 4]); 6] = [
        ([GL_ALPHA8, GL_ALPHA16].map(|f| f as i32), [0.0, 0.0, 0.0, 0.8]),
        ([GL_LUMINANCE8, GL_LUMINANCE16].map(|f| f as i32), [0.2, 0.0, 0.0, 1.0]),
        ([GL_LUMINANCE8_ALPHA8, GL_LUMINANCE16_ALPHA16].map(|f| f as i32), [0.2, 0.0, 0.0, 0.8]),
        ([GL_INTENSITY8, GL_INTENSITY16].map(|f| f as i32), [0.2, 0.0, 0.0, 1.0]),
        ([GL_RGB8, GL_RGB16].map(|f| f as i32), [0.2, 0.4, 0.6, 1.0]),
        ([GL_RGBA8, GL_RGBA16].map(|f| f as i32), [0.2, 0.4, 0.6, 0.8]),
    ];
    let mut gl = Context::new(4, 4);
    gl.pixel_storei(GL_PACK_ALIGNMENT, 1);
    for (formats, group) in bases {
        for internal in formats {
            gl.tex_image_2d(GL_TEXTURE_2D, 0, internal, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[51u8, 102, 153, 204]);
            for (format, channels) in READ_FORMATS {
                let mut bytes = [7u8; 4];
                gl.get_tex_image(GL_TEXTURE_2D, 0, format, GL_UNSIGNED_BYTE, &mut bytes);
                let mut floats = [7f32; 4];
                gl.get_tex_image(GL_TEXTURE_2D, 0, format, GL_FLOAT, &mut floats);
                assert_eq!(gl.get_error(), GL_NO_ERROR);
                for (i, &channel) in channels.iter().enumerate() {
                    let what = format!("{} as {}", name(internal as u32), name(format));
                    assert_eq!(bytes[i], (group[channel] * 255.0).round() as u8, "{what}");
                    assert!((floats[i] - group[channel]).abs() < 1e-6, "{what} {floats:?}");
                }
                assert_eq!((bytes.get(channels.len()), floats.get(channels.len())).0.unwrap_or(&7), &7);
            }
        }
    }
}

#[test]
fn a_base_level_above_the_last_level_counts_only_for_mipmaps() {
    for (filter, textured) in
        [(GL_NEAREST, true), (GL_LINEAR, true), (GL_NEAREST_MIPMAP_NEAREST, false), (GL_LINEAR_MIPMAP_LINEAR, false)]
    {
        let mut gl = Context::new(4, 4);
        gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        for level in 0..4 {
            let size = 8 >> level;
            let texels = vec![40 * (level as u8 + 1); size * size];
            gl.tex_image_2d(
                GL_TEXTURE_2D,
                level,
                GL_LUMINANCE as i32,
                size as i32,
                size as i32,
                0,
                GL_LUMINANCE,
                GL_UNSIGNED_BYTE,
                &texels,
            );
        }
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
        gl.enable(GL_TEXTURE_2D);
        gl.rectf(-1.0, -1.0, 1.0, 1.0);
        let mut pixel = [0u8; 4];
        gl.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        assert_eq!(pixel[0], if textured { 120 } else { 255 }, "{}", name(filter));
    }
}

#[test]
fn a_proxy_cube_map_that_is_not_square_is_no_error_and_has_no_size() {
    let mut gl = Context::new(4, 4);
    let ask = |gl: &mut Context, target: GLenum, width: i32, height: i32| {
        gl.tex_image_2d(target, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, fixedgl::NULL);
        gl.get_error()
    };
    assert_eq!(ask(&mut gl, GL_PROXY_TEXTURE_CUBE_MAP, 8, 8), GL_NO_ERROR);
    assert_eq!(level(&mut gl, GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH), 8);
    assert_eq!(ask(&mut gl, GL_PROXY_TEXTURE_CUBE_MAP, 8, 4), GL_NO_ERROR);
    for pname in [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_RED_SIZE] {
        assert_eq!(level(&mut gl, GL_PROXY_TEXTURE_CUBE_MAP, 0, pname), 0);
    }
    assert_eq!(ask(&mut gl, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 8, 4), GL_INVALID_VALUE);
    assert_eq!(ask(&mut gl, GL_PROXY_TEXTURE_CUBE_MAP, 8, -1), GL_INVALID_VALUE);
}

#[test]
fn the_size_of_compressed_data_is_checked_even_of_no_texels() {
    let mut gl = Context::new(4, 4);
    let (target, format) = (GL_TEXTURE_2D, GL_COMPRESSED_RGB_S3TC_DXT1_EXT);
    let block = [0u8; 64];
    // Size of the image data, width and height of the part, the error.
    for (image_size, [width, height], error) in [
        (0, [0, 0], GL_NO_ERROR),
        (-1, [0, 0], GL_INVALID_VALUE),
        (i32::MIN, [0, 0], GL_INVALID_VALUE),
        (8, [0, 0], GL_INVALID_VALUE),
        (-8, [4, 4], GL_INVALID_VALUE),
        (8, [4, 4], GL_NO_ERROR),
        (16, [4, 4], GL_INVALID_VALUE),
        (0, [0, 4], GL_NO_ERROR),
        (-4, [4, 0], GL_INVALID_VALUE),
    ] {
        let what = format!("{image_size} bytes of {width} x {height}");
        gl.compressed_tex_image_2d(target, 0, format, 8, 8, 0, 32, &block[..32]);
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        gl.compressed_tex_sub_image_2d(target, 0, 0, 0, width, height, format, image_size, &block);
        assert_eq!(gl.get_error(), error, "{what}, a part");
        gl.compressed_tex_image_2d(target, 1, format, width, height, 0, image_size, &block);
        assert_eq!(gl.get_error(), error, "{what}, an image");
    }
}
