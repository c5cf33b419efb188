//! Pixel rectangles (section 3.6) through the commands of a context: initial state, errors, where groups lie in memory,
//! how numbers become components, what pixel transfer does. The expected numbers are computed here in f64.

use fixedgl::Context;
use fixedgl::enums::*;

const TYPES: [GLenum; 7] = [GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT];
const FORMATS: [(GLenum, &[usize]); 11] = [
    (GL_RED, &[0]),
    (GL_GREEN, &[1]),
    (GL_BLUE, &[2]),
    (GL_ALPHA, &[3]),
    (GL_RGB, &[0, 1, 2]),
    (GL_RGBA, &[0, 1, 2, 3]),
    (GL_BGR, &[2, 1, 0]),
    (GL_BGRA, &[2, 1, 0, 3]),
    (GL_ABGR_EXT, &[3, 2, 1, 0]),
    (GL_LUMINANCE, &[0]),
    (GL_LUMINANCE_ALPHA, &[0, 3]),
];

fn integer(gl: &mut Context, pname: GLenum) -> i32 {
    let mut value = [-77; 4];
    gl.get_integerv(pname, &mut value);
    value[0]
}

/// The bound 2D texture's level 0 as floats R, G, B, A.
fn texels(gl: &mut Context, n: usize) -> Vec<f32> {
    let mut out = vec![0.0f32; n * 4];
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, &mut out[..]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    out
}

/// A context whose textures keep 16 bits a component, so that conversions can be seen.
fn context() -> Context {
    Context::new(4, 4)
}

fn upload(gl: &mut Context, size: [i32; 2], format: GLenum, type_: GLenum, bytes: &[u8]) {
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA16, size[0], size[1], 0, format, type_, bytes);
}

#[test]
fn the_initial_state_is_the_tables() {
    let mut gl = context();
    for (pname, want) in [
        (GL_UNPACK_SWAP_BYTES, 0),
        (GL_UNPACK_LSB_FIRST, 0),
        (GL_UNPACK_ROW_LENGTH, 0),
        (GL_UNPACK_SKIP_ROWS, 0),
        (GL_UNPACK_SKIP_PIXELS, 0),
        (GL_UNPACK_ALIGNMENT, 4),
        (GL_UNPACK_IMAGE_HEIGHT, 0),
        (GL_UNPACK_SKIP_IMAGES, 0),
        (GL_PACK_SWAP_BYTES, 0),
        (GL_PACK_ROW_LENGTH, 0),
        (GL_PACK_SKIP_PIXELS, 0),
        (GL_PACK_ALIGNMENT, 4),
        (GL_MAP_COLOR, 0),
        (GL_MAP_STENCIL, 0),
        (GL_INDEX_SHIFT, 0),
        (GL_INDEX_OFFSET, 0),
        (GL_RED_SCALE, 1),
        (GL_ALPHA_BIAS, 0),
        (GL_DEPTH_SCALE, 1),
        (GL_DEPTH_BIAS, 0),
        (GL_ZOOM_X, 1),
        (GL_ZOOM_Y, 1),
        (GL_PIXEL_MAP_I_TO_I_SIZE, 1),
        (GL_PIXEL_MAP_A_TO_A_SIZE, 1),
    ] {
        assert_eq!(integer(&mut gl, pname), want, "{}", name(pname));
    }
    assert!(integer(&mut gl, GL_MAX_PIXEL_MAP_TABLE) >= 32);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
}

#[test]
fn errors_change_nothing() {
    let mut gl = context();
    upload(&mut gl, [1, 1], GL_RGBA, GL_UNSIGNED_BYTE, &[255, 0, 255, 0]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    for (pname, value, code) in [
        (GL_UNPACK_ALIGNMENT, 3, GL_INVALID_VALUE),
        (GL_UNPACK_ALIGNMENT, 0, GL_INVALID_VALUE),
        (GL_PACK_SKIP_ROWS, -1, GL_INVALID_VALUE),
        (GL_RED_SCALE, 1, GL_INVALID_ENUM),
    ] {
        gl.pixel_storei(pname, value);
        assert_eq!(gl.get_error(), code, "{} {value}", name(pname));
    }
    assert_eq!((integer(&mut gl, GL_UNPACK_ALIGNMENT), integer(&mut gl, GL_PACK_SKIP_ROWS)), (4, 0));
    gl.pixel_transferf(GL_UNPACK_ALIGNMENT, 1.0);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
    gl.pixel_mapfv(GL_PIXEL_MAP_I_TO_R, 3, &[0.0f32; 3][..]);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    gl.pixel_mapfv(GL_RED, 1, &[0.0f32][..]);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
    let bytes = [7u8; 64];
    for (format, type_, code) in [
        (GL_RGBA, GL_BITMAP, GL_INVALID_ENUM),
        (GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_ENUM),
        (GL_TEXTURE_2D, GL_UNSIGNED_BYTE, GL_INVALID_ENUM),
        (GL_RGBA, GL_DOUBLE, GL_INVALID_ENUM),
        (GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION),
        (GL_BGR, GL_UNSIGNED_BYTE_3_3_2, GL_INVALID_OPERATION),
        (GL_RGB, GL_UNSIGNED_INT_8_8_8_8, GL_INVALID_OPERATION),
        (GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION),
    ] {
        upload(&mut gl, [1, 1], format, type_, &bytes);
        assert_eq!(gl.get_error(), code, "{} {}", name(format), name(type_));
    }
    // Memory that is shorter than the image.
    upload(&mut gl, [5, 4], GL_RGBA, GL_UNSIGNED_BYTE, &bytes);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert_eq!(texels(&mut gl, 1), [1.0, 0.0, 1.0, 0.0]);
}

/// The bytes of an element that stands (nearly) for a component in [0, 1], and the component it stands for exactly.
fn element(type_: GLenum, v: f64) -> (Vec<u8>, f64) {
    let unsigned = |bits: i32| (v * (2f64.powi(bits) - 1.0)).round();
    let signed = |bits: i32| ((v * (2f64.powi(bits) - 1.0) - 1.0) / 2.0).round();
    let from_unsigned = |bits: i32, c: f64| c / (2f64.powi(bits) - 1.0);
    let from_signed = |bits: i32, c: f64| (2.0 * c + 1.0) / (2f64.powi(bits) - 1.0);
    match type_ {
        GL_UNSIGNED_BYTE => ((unsigned(8) as u8).to_ne_bytes().to_vec(), from_unsigned(8, unsigned(8))),
        GL_BYTE => ((signed(8) as i8).to_ne_bytes().to_vec(), from_signed(8, signed(8))),
        GL_UNSIGNED_SHORT => ((unsigned(16) as u16).to_ne_bytes().to_vec(), from_unsigned(16, unsigned(16))),
        GL_SHORT => ((signed(16) as i16).to_ne_bytes().to_vec(), from_signed(16, signed(16))),
        GL_UNSIGNED_INT => ((unsigned(32) as u32).to_ne_bytes().to_vec(), from_unsigned(32, unsigned(32))),
        GL_INT => ((signed(32) as i32).to_ne_bytes().to_vec(), from_signed(32, signed(32))),
        _ => ((v as f32).to_ne_bytes().to_vec(), f64::from(v as f32)),
    }
}

/// What a group becomes: missing colours 0, missing alpha 1, luminance in all three.
fn expand(format: GLenum, channels: &[usize], values: &[f64]) -> [f64; 4] {
    let mut color = [0.0, 0.0, 0.0, 1.0];
    for (&c, &v) in channels.iter().zip(values) {
        color[c] = v.max(0.0);
    }
    if format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA {
        color[1] = color[0];
        color[2] = color[0];
    }
    color
}

#[test]
fn every_format_and_type_lies_where_the_pixel_store_says() {
    let mut gl = context();
    let mut seed = 1u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / f64::from(1u32 << 31)
    };
    let (w, h) = (5usize, 3usize);
    for (format, channels) in FORMATS {
        for type_ in TYPES {
            for (swap, length, skip_rows, skip_pixels, alignment) in
                [(0, 0, 0, 0, 4), (1, 7, 1, 2, 1), (0, 9, 0, 4, 8), (1, 0, 2, 0, 2)]
            {
                let size = element(type_, 0.0).0.len();
                let row = if length > 0 { length } else { w };
                let stride = (row * channels.len() * size).next_multiple_of(alignment);
                let mut memory = vec![0xEE; (skip_rows + h) * stride + (skip_pixels + w) * channels.len() * size];
                let mut want = Vec::new();
                for (x, y) in (0..h).flat_map(|y| (0..w).map(move |x| (x, y))) {
                    let values: Vec<f64> = channels.iter().map(|_| random()).collect();
                    let mut exact = Vec::new();
                    for (i, &v) in values.iter().enumerate() {
                        let (mut bytes, value) = element(type_, v);
                        exact.push(value);
                        if swap == 1 {
                            bytes.reverse();
                        }
                        let at = (skip_rows + y) * stride + ((skip_pixels + x) * channels.len() + i) * size;
                        memory[at..at + size].copy_from_slice(&bytes);
                    }
                    want.extend(expand(format, channels, &exact));
                }
                for (pname, value) in [
                    (GL_UNPACK_SWAP_BYTES, swap),
                    (GL_UNPACK_ROW_LENGTH, length as i32),
                    (GL_UNPACK_SKIP_ROWS, skip_rows as i32),
                    (GL_UNPACK_SKIP_PIXELS, skip_pixels as i32),
                    (GL_UNPACK_ALIGNMENT, alignment as i32),
                    // These two are for 3D images only and must not matter here.
                    (GL_UNPACK_SKIP_IMAGES, 3),
                    (GL_UNPACK_IMAGE_HEIGHT, 50),
                ] {
                    gl.pixel_storei(pname, value);
                }
                upload(&mut gl, [w as i32, h as i32], format, type_, &memory);
                for (i, (got, want)) in texels(&mut gl, w * h).iter().zip(want).enumerate() {
                    // Half a step of 16 bits, and what an f32 near 1 is rounded by.
                    let error = (f64::from(*got) - want).abs();
                    assert!(error <= 0.504 / 65535.0, "{} {} {i}", name(format), name(type_));
                }
            }
        }
    }
}

#[test]
fn packed_types_split_as_their_names_say() {
    let mut gl = context();
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    let cases: [(GLenum, GLenum, u32, usize, [f64; 4]); 17] = [
        (GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 0b1010_1001, 1, [5. / 7., 2. / 7., 1. / 3., 1.]),
        (GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, 0b01_010_101, 1, [5. / 7., 2. / 7., 1. / 3., 1.]),
        (GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 3 << 11 | 17 << 5 | 30, 2, [3. / 31., 17. / 63., 30. / 31., 1.]),
        (GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, 30 << 11 | 17 << 5 | 3, 2, [3. / 31., 17. / 63., 30. / 31., 1.]),
        (GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 0x19AF, 2, [1. / 15., 9. / 15., 10. / 15., 1.]),
        (GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4, 0x19AF, 2, [10. / 15., 9. / 15., 1. / 15., 1.]),
        (GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, 0xFA91, 2, [1. / 15., 9. / 15., 10. / 15., 1.]),
        (GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 8 << 11 | 9 << 6 | 10 << 1, 2, [8. / 31., 9. / 31., 10. / 31., 0.]),
        (
            GL_BGRA,
            GL_UNSIGNED_SHORT_1_5_5_5_REV,
            1 << 15 | 8 << 10 | 9 << 5 | 10,
            2,
            [8. / 31., 9. / 31., 10. / 31., 1.],
        ),
        (GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, 0x01_02_03_04, 4, [1. / 255., 2. / 255., 3. / 255., 4. / 255.]),
        (GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, 0x04_03_02_01, 4, [1. / 255., 2. / 255., 3. / 255., 4. / 255.]),
        (GL_ABGR_EXT, GL_UNSIGNED_SHORT_4_4_4_4, 0xFA91, 2, [1. / 15., 9. / 15., 10. / 15., 1.]),
        (GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8, 0x04_03_02_01, 4, [1. / 255., 2. / 255., 3. / 255., 4. / 255.]),
        (GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8_REV, 0x01_02_03_04, 4, [1. / 255., 2. / 255., 3. / 255., 4. / 255.]),
        (GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, 0x04_01_02_03, 4, [1. / 255., 2. / 255., 3. / 255., 4. / 255.]),
        (
            GL_RGBA,
            GL_UNSIGNED_INT_10_10_10_2,
            1000 << 22 | 2 << 12 | 512 << 2 | 1,
            4,
            [1000. / 1023., 2. / 1023., 512. / 1023., 1. / 3.],
        ),
        (
            GL_BGRA,
            GL_UNSIGNED_INT_2_10_10_10_REV,
            2 << 30 | 1000 << 20 | 2 << 10 | 512,
            4,
            [1000. / 1023., 2. / 1023., 512. / 1023., 2. / 3.],
        ),
    ];
    for swap in [0, 1] {
        gl.pixel_storei(GL_UNPACK_SWAP_BYTES, swap);
        for (format, type_, number, size, want) in cases {
            let mut bytes = match size {
                1 => vec![number as u8],
                2 => (number as u16).to_ne_bytes().to_vec(),
                _ => number.to_ne_bytes().to_vec(),
            };
            if swap == 1 {
                bytes.reverse();
            }
            upload(&mut gl, [1, 1], format, type_, &bytes);
            for (got, want) in texels(&mut gl, 1).iter().zip(want) {
                assert!((f64::from(*got) - want).abs() < 0.501 / 65535.0, "{} {}", name(format), name(type_));
            }
        }
    }
}

#[test]
fn packing_leaves_gaps_alone_and_rounds_to_the_nearest() {
    let mut gl = context();
    let colors: Vec<u8> = (0..12u8).flat_map(|i| [i * 20, 255 - i, i, i * 21]).collect();
    upload(&mut gl, [4, 3], GL_RGBA, GL_UNSIGNED_BYTE, &colors);
    gl.pixel_storei(GL_PACK_ROW_LENGTH, 6);
    gl.pixel_storei(GL_PACK_SKIP_ROWS, 1);
    gl.pixel_storei(GL_PACK_SKIP_PIXELS, 1);
    for alignment in [1, 2, 4, 8] {
        gl.pixel_storei(GL_PACK_ALIGNMENT, alignment);
        for (format, channels) in FORMATS {
            let n = channels.len();
            let stride = (6 * n).next_multiple_of(alignment as usize);
            let mut memory = vec![0x5Au8; 5 * stride];
            gl.get_tex_image(GL_TEXTURE_2D, 0, format, GL_UNSIGNED_BYTE, &mut memory[..]);
            assert_eq!(gl.get_error(), GL_NO_ERROR);
            let mut want = vec![0x5Au8; 5 * stride];
            for (x, y) in (0..3usize).flat_map(|y| (0..4usize).map(move |x| (x, y))) {
                let c = &colors[(y * 4 + x) * 4..][..4];
                // GetTexImage makes no sum for a luminance (section 6.1.4).
                for (i, &channel) in channels.iter().enumerate() {
                    want[(y + 1) * stride + (x + 1) * n + i] = c[channel];
                }
            }
            assert_eq!(memory, want, "{} {alignment}", name(format));
        }
    }
    // One byte too few for the last group: an error, and nothing is written.
    gl.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let mut memory = [0x5Au8; 3 * 24 + 5 * 4 - 1];
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut memory[..]);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert!(memory.iter().all(|&b| b == 0x5A));
}

#[test]
fn transfer_applies_to_textures_in_order() {
    let mut gl = context();
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    gl.pixel_transferf(GL_RED_SCALE, 2.0);
    gl.pixel_transferf(GL_RED_BIAS, -0.5);
    gl.pixel_transferf(GL_ALPHA_BIAS, -0.25);
    let close = |a: &[f32], b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-4);
    upload(&mut gl, [1, 1], GL_RGB, GL_UNSIGNED_BYTE, &[102, 51, 255]);
    assert!(close(&texels(&mut gl, 1), [0.3, 0.2, 1.0, 0.75]));
    // The maps come after scale and bias; they clamp what they look up.
    gl.pixel_transferi(GL_MAP_COLOR, 1);
    gl.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 11, &std::array::from_fn::<f32, 11, _>(|i| 1.0 - i as f32 / 10.0)[..]);
    gl.pixel_mapfv(GL_PIXEL_MAP_G_TO_G, 2, &[0.25f32, 0.5][..]);
    gl.pixel_mapfv(GL_PIXEL_MAP_B_TO_B, 2, &[0.0f32, 7.0][..]);
    gl.pixel_mapfv(GL_PIXEL_MAP_A_TO_A, 1, &[0.5f32][..]);
    upload(&mut gl, [1, 1], GL_RGB, GL_UNSIGNED_BYTE, &[102, 51, 255]);
    assert!(close(&texels(&mut gl, 1), [0.7, 0.25, 1.0, 0.5]));
    // Colour indices: shift, offset, index maps; neither scale nor colour maps.
    gl.pixel_transferi(GL_INDEX_SHIFT, 1);
    gl.pixel_transferi(GL_INDEX_OFFSET, -1);
    for (map, base) in [
        (GL_PIXEL_MAP_I_TO_R, 0.0f32),
        (GL_PIXEL_MAP_I_TO_G, 0.1),
        (GL_PIXEL_MAP_I_TO_B, 0.2),
        (GL_PIXEL_MAP_I_TO_A, 0.3),
    ] {
        gl.pixel_mapfv(map, 4, &[base, base + 0.1, base + 0.2, base + 0.3][..]);
    }
    upload(&mut gl, [2, 1], GL_COLOR_INDEX, GL_UNSIGNED_BYTE, &[2, 0]);
    let got = texels(&mut gl, 2);
    // 2 << 1 - 1 = 3; 0 << 1 - 1 = -1, whose low bits are 3 as well.
    assert!(close(&got[..4], [0.3, 0.4, 0.5, 0.6]) && close(&got[4..], [0.3, 0.4, 0.5, 0.6]), "{got:?}");
    // A bitmap is an image of indices 0 and 1.
    gl.pixel_transferi(GL_INDEX_SHIFT, 0);
    gl.pixel_transferi(GL_INDEX_OFFSET, 0);
    for (lsb_first, byte) in [(0, 0b0100_0000), (1, 0b0000_0010)] {
        gl.pixel_storei(GL_UNPACK_LSB_FIRST, lsb_first);
        upload(&mut gl, [2, 1], GL_COLOR_INDEX, GL_BITMAP, &[byte]);
        let got = texels(&mut gl, 2);
        assert!(close(&got[..4], [0.0, 0.1, 0.2, 0.3]) && close(&got[4..], [0.1, 0.2, 0.3, 0.4]));
    }
}

#[test]
fn three_dimensions_skip_images() {
    let mut gl = context();
    let memory: Vec<u8> = (0..=255).collect();
    for (pname, value) in [
        (GL_UNPACK_ALIGNMENT, 1),
        (GL_UNPACK_ROW_LENGTH, 3),
        (GL_UNPACK_IMAGE_HEIGHT, 4),
        (GL_UNPACK_SKIP_IMAGES, 1),
        (GL_UNPACK_SKIP_ROWS, 1),
        (GL_UNPACK_SKIP_PIXELS, 1),
    ] {
        gl.pixel_storei(pname, value);
    }
    gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_LUMINANCE8, 2, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &memory[..]);
    let mut out = [0u8; 8];
    gl.pixel_storei(GL_PACK_ALIGNMENT, 1);
    gl.get_tex_image(GL_TEXTURE_3D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut out[..]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    let at = |x: u8, y: u8, z: u8| (z + 1) * 12 + (y + 1) * 3 + x + 1;
    let want: Vec<u8> = (0..2).flat_map(|z| (0..2).flat_map(move |y| (0..2).map(move |x| at(x, y, z)))).collect();
    assert_eq!(out, want[..]);
}
