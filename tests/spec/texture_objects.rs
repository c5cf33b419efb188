//! Texture images and objects (OpenGL 1.5, sections 3.8.1 to 3.8.5, 3.8.10 to 3.8.12, 6.1.4): what goes in comes out again
//! in every format, pixel storage, subimages, proxies, completeness, objects, and the errors of every row.

use crate::support::{Random, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::NULL;
use fixedgl::enums::*;

const T: GLenum = GL_TEXTURE_2D;

fn level_parameter(cx: &mut Context, target: GLenum, level: i32, pname: GLenum) -> i32 {
    let mut v = [-7i32];
    cx.get_tex_level_parameteriv(target, level, pname, &mut v);
    no_error(cx);
    v[0]
}

fn image(cx: &mut Context, format: GLenum, channels: usize, texels: usize) -> Vec<u8> {
    let mut out = vec![0u8; channels * texels];
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    cx.get_tex_image(T, 0, format, GL_UNSIGNED_BYTE, &mut out);
    no_error(cx);
    out
}

fn noise(n: usize, seed: u64) -> Vec<u8> {
    let mut random = Random(seed);
    (0..n).map(|_| random.bits() as u8).collect()
}

#[test]
fn the_initial_state_is_the_tables() {
    let mut cx = Context::new(4, 4);
    for target in [GL_TEXTURE_1D, T, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE_ARB] {
        let mut v = [0f32; 4];
        cx.get_tex_parameterfv(target, GL_TEXTURE_PRIORITY, &mut v);
        assert_eq!(v[0], 1.0);
        cx.get_tex_parameterfv(target, GL_TEXTURE_MIN_LOD, &mut v);
        assert_eq!(v[0], -1000.0);
        cx.get_tex_parameterfv(target, GL_TEXTURE_MAX_LOD, &mut v);
        assert_eq!(v[0], 1000.0);
        cx.get_tex_parameterfv(target, GL_TEXTURE_BORDER_COLOR, &mut v);
        assert_eq!(v, [0.0; 4]);
        let mut i = [9i32];
        for (pname, want) in [
            (GL_TEXTURE_BASE_LEVEL, 0),
            (GL_TEXTURE_MAX_LEVEL, 1000),
            (GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE),
            (GL_TEXTURE_COMPARE_MODE, GL_NONE),
            (GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL),
            (GL_GENERATE_MIPMAP, 0),
        ] {
            cx.get_tex_parameteriv(target, pname, &mut i);
            assert_eq!(i[0] as u32, want, "{}", fixedgl::enums::name(pname));
        }
        assert_eq!(get_i(&mut cx, target), 0);
    }
    for pname in [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER, GL_TEXTURE_RED_SIZE] {
        assert_eq!(level_parameter(&mut cx, T, 0, pname), 0);
    }
    assert_eq!(level_parameter(&mut cx, T, 0, GL_TEXTURE_INTERNAL_FORMAT), 1);
    assert_eq!(get_i(&mut cx, GL_ACTIVE_TEXTURE) as u32, GL_TEXTURE0);
    assert_eq!(get_i(&mut cx, GL_TEXTURE_BINDING_2D), 0);
}

#[test]
fn every_base_format_keeps_its_components() {
    let rgba = noise(4 * 35, 3);
    for (inner, format, keep) in [
        (GL_ALPHA8, GL_ALPHA, &[3usize][..]),
        (GL_LUMINANCE8, GL_LUMINANCE, &[0]),
        (GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, &[0, 3]),
        (GL_RGB8, GL_RGB, &[0, 1, 2]),
        (GL_RGBA8, GL_RGBA, &[0, 1, 2, 3]),
        (3, GL_RGB, &[0, 1, 2]),
        (4, GL_BGRA, &[2, 1, 0, 3]),
        (4, GL_ABGR_EXT, &[3, 2, 1, 0]),
        (1, GL_LUMINANCE, &[0]),
        (2, GL_LUMINANCE_ALPHA, &[0, 3]),
    ] {
        let mut cx = Context::new(4, 4);
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        cx.tex_image_2d(T, 0, inner, 7, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, &rgba);
        no_error(&mut cx);
        let want: Vec<u8> = rgba.chunks(4).flat_map(|p| keep.iter().map(|&k| p[k])).collect();
        assert_eq!(image(&mut cx, format, keep.len(), 35), want, "{inner:#x}");
    }
}

#[test]
fn levels_tell_their_parameters() {
    let mut cx = Context::new(4, 4);
    cx.tex_image_2d(T, 2, GL_RGBA8, 18, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    no_error(&mut cx);
    for (pname, want) in [
        (GL_TEXTURE_WIDTH, 18),
        (GL_TEXTURE_HEIGHT, 6),
        (GL_TEXTURE_DEPTH, 1),
        (GL_TEXTURE_BORDER, 1),
        (GL_TEXTURE_INTERNAL_FORMAT, GL_RGBA8 as i32),
        (GL_TEXTURE_RED_SIZE, 8),
        (GL_TEXTURE_ALPHA_SIZE, 8),
        (GL_TEXTURE_LUMINANCE_SIZE, 0),
        (GL_TEXTURE_COMPRESSED, 0),
    ] {
        assert_eq!(level_parameter(&mut cx, T, 2, pname), want, "{}", fixedgl::enums::name(pname));
    }
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.get_tex_level_parameteriv(T, -1, GL_TEXTURE_WIDTH, &mut [0]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.get_tex_level_parameteriv(T, 0, GL_TEXTURE_WRAP_S, &mut [0]));
}

#[test]
fn pixel_storage_finds_the_texels() {
    let mut cx = Context::new(4, 4);
    let memory = noise(4 * 20 * 20, 9);
    cx.pixel_storei(GL_UNPACK_ROW_LENGTH, 13);
    cx.pixel_storei(GL_UNPACK_SKIP_PIXELS, 3);
    cx.pixel_storei(GL_UNPACK_SKIP_ROWS, 2);
    for alignment in [1, 2, 4, 8] {
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, alignment);
        cx.tex_image_2d(T, 0, GL_RGB8, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, &memory);
        no_error(&mut cx);
        let row = (13usize * 3).next_multiple_of(alignment as usize);
        let want: Vec<u8> = (0..4).flat_map(|j| memory[(j + 2) * row + 9..][..12].to_vec()).collect();
        assert_eq!(image(&mut cx, GL_RGB, 3, 16), want, "alignment {alignment}");
    }
}

#[test]
fn packed_types_and_swapped_bytes_are_read() {
    let mut cx = Context::new(4, 4);
    cx.tex_image_2d(T, 0, GL_RGB8, 2, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, &[0xF81Fu16, 0x07E0]);
    assert_eq!(image(&mut cx, GL_RGB, 3, 2), [255, 0, 255, 0, 255, 0]);
    cx.tex_image_2d(T, 0, GL_RGBA8, 1, 1, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, &[0x8040_20FFu32]);
    assert_eq!(image(&mut cx, GL_RGBA, 4, 1), [0x40, 0x20, 0xFF, 0x80]);
    cx.tex_image_2d(T, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, &[0x1F80u16]);
    assert_eq!(image(&mut cx, GL_RGBA, 4, 1), [0x11, 0xFF, 0x88, 0]);
    let packed = (31u16 << 11) | (16 << 1) | 1;
    cx.tex_image_2d(T, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, &[packed]);
    assert_eq!(image(&mut cx, GL_RGBA, 4, 1), [255, 0, 132, 255]);
    cx.pixel_storei(GL_UNPACK_SWAP_BYTES, 1);
    cx.tex_image_2d(T, 0, GL_LUMINANCE8, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_SHORT, &[0x00FFu16]);
    // 0xFF00 of 0xFFFF.
    assert_eq!(image(&mut cx, GL_LUMINANCE, 1, 1), [254]);
    no_error(&mut cx);
    raises(&mut cx, GL_INVALID_OPERATION, |cx| {
        cx.tex_image_2d(T, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, &[0u16]);
    });
    raises(&mut cx, GL_INVALID_OPERATION, |cx| {
        cx.tex_image_2d(T, 0, GL_RGBA, 1, 1, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, &[0u16]);
    });
}

#[test]
fn subimages_replace_a_part() {
    let mut cx = Context::new(4, 4);
    let base = noise(4 * 64, 1);
    cx.tex_image_2d(T, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, &base);
    let part = noise(4 * 6, 2);
    cx.tex_sub_image_2d(T, 0, 5, 2, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, &part);
    no_error(&mut cx);
    let mut want = base;
    for j in 0..2 {
        want[((2 + j) * 8 + 5) * 4..][..12].copy_from_slice(&part[j * 12..][..12]);
    }
    assert_eq!(image(&mut cx, GL_RGBA, 4, 64), want);
    let sub = |cx: &mut Context, x, y, w, h| cx.tex_sub_image_2d(T, 0, x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, &part);
    raises(&mut cx, GL_INVALID_VALUE, |cx| sub(cx, 6, 0, 3, 1));
    raises(&mut cx, GL_INVALID_VALUE, |cx| sub(cx, -1, 0, 1, 1));
    raises(&mut cx, GL_INVALID_VALUE, |cx| sub(cx, 0, 0, -1, 1));
    raises(&mut cx, GL_INVALID_VALUE, |cx| sub(cx, i32::MAX, 0, 2, 1));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| {
        cx.tex_sub_image_2d(T, 3, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &part);
    });
    assert_eq!(image(&mut cx, GL_RGBA, 4, 64), want, "a wrong command must change nothing");
}

#[test]
fn tex_image_refuses_wrong_arguments() {
    let mut cx = Context::new(4, 4);
    let px = noise(4 * 64, 1);
    let give = |cx: &mut Context, target, level, inner: GLenum, w, h, border, format, type_| {
        cx.tex_image_2d(target, level, inner, w, h, border, format, type_, &px);
    };
    let b = GL_UNSIGNED_BYTE;
    cx.tex_image_2d(T, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, b, &px);
    raises(&mut cx, GL_INVALID_ENUM, |cx| give(cx, GL_TEXTURE_1D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, -1, GL_RGBA, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 40, GL_RGBA, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, 5, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, GL_TEXTURE_2D, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, GL_RGBA, -4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, GL_RGBA, 1 << 20, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, GL_RGBA, 4, 4, 2, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, T, 0, GL_RGBA, 4, 4, -1, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_ENUM, |cx| give(cx, T, 0, GL_RGBA, 4, 4, 0, GL_RGBA8, b));
    raises(&mut cx, GL_INVALID_ENUM, |cx| give(cx, T, 0, GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX, b));
    raises(&mut cx, GL_INVALID_ENUM, |cx| give(cx, T, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_DOUBLE));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| give(cx, T, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, b));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| give(cx, T, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_RGBA, b));
    let rect = GL_TEXTURE_RECTANGLE_ARB;
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, rect, 1, GL_RGBA, 4, 4, 0, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_VALUE, |cx| give(cx, rect, 0, GL_RGBA, 4, 4, 1, GL_RGBA, b));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| {
        cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 4, 4, 1, 0, GL_DEPTH_COMPONENT, b, &px);
    });
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_RGBA, -1, 0, GL_RGBA, b, &px));
    // A slice that is too short for what the command reads.
    cx.tex_image_2d(T, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, b, &px[..100]);
    assert_ne!(cx.get_error(), 0);
    assert_eq!(level_parameter(&mut cx, T, 0, GL_TEXTURE_WIDTH), 2, "a wrong command must change nothing");
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_parameteri(T, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_parameteri(rect, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_parameteri(T, GL_TEXTURE_BASE_LEVEL, -1));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_parameteri(T, GL_TEXTURE_ENV_MODE, 1));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.active_texture(GL_TEXTURE0 + 200));
}

#[test]
fn proxies_say_yes_or_no() {
    let mut cx = Context::new(4, 4);
    let p = GL_PROXY_TEXTURE_2D;
    cx.tex_image_2d(p, 0, GL_RGB8, 64, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    assert_eq!(level_parameter(&mut cx, p, 0, GL_TEXTURE_WIDTH), 64);
    assert_eq!(level_parameter(&mut cx, T, 0, GL_TEXTURE_WIDTH), 0);
    cx.tex_image_2d(p, 0, GL_RGB8, 1 << 20, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    assert_eq!(level_parameter(&mut cx, p, 0, GL_TEXTURE_WIDTH), 0);
    assert_eq!(level_parameter(&mut cx, p, 0, GL_TEXTURE_RED_SIZE), 0);
    cx.tex_image_3d(GL_PROXY_TEXTURE_3D, 0, GL_RGBA8, 1024, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    assert_eq!(level_parameter(&mut cx, GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH), 0, "4 GiB are too much");
}

#[test]
fn objects_are_made_bound_and_deleted() {
    let mut cx = Context::new(4, 4);
    let mut names = [0u32; 3];
    cx.gen_textures(3, &mut names);
    assert!(names[0] != 0 && names[0] != names[1] && names[1] != names[2]);
    assert!(!cx.is_texture(names[0]), "a name becomes an object when it is bound");
    cx.bind_texture(T, names[0]);
    assert!(cx.is_texture(names[0]) && !cx.is_texture(0));
    assert_eq!(get_i(&mut cx, GL_TEXTURE_BINDING_2D) as u32, names[0]);
    cx.tex_parameteri(T, GL_TEXTURE_WRAP_S, GL_CLAMP);
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.bind_texture(GL_TEXTURE_3D, names[0]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.bind_texture(GL_PROXY_TEXTURE_2D, names[1]));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.gen_textures(-1, &mut names));
    cx.bind_texture(T, 0);
    let mut v = [0i32];
    cx.get_tex_parameteriv(T, GL_TEXTURE_WRAP_S, &mut v);
    assert_eq!(v[0] as u32, GL_REPEAT, "the object has its own parameters");
    cx.bind_texture(T, names[0]);
    cx.delete_textures(2, &names);
    assert!(!cx.is_texture(names[0]));
    assert_eq!(get_i(&mut cx, GL_TEXTURE_BINDING_2D), 0, "a deleted texture is unbound");
    cx.bind_texture(T, 4711);
    assert!(cx.is_texture(4711), "any name will do");
    no_error(&mut cx);
}

fn textured_square(cx: &mut Context) -> [u8; 4] {
    cx.enable(T);
    cx.color4ub(10, 20, 30, 40);
    cx.begin(GL_QUADS);
    for [x, y] in [[-1.0f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        cx.tex_coord2f((x + 1.0) / 2.0, (y + 1.0) / 2.0);
        cx.vertex2f(x, y);
    }
    cx.end();
    pixels(cx, 4, 4)[5]
}

#[test]
fn an_incomplete_texture_is_as_if_disabled() {
    let mut cx = Context::new(4, 4);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    let white = [255u8; 4 * 16];
    cx.tex_image_2d(T, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    assert_eq!(textured_square(&mut cx), [10, 20, 30, 40], "the initial filter needs mipmaps");
    cx.tex_parameteri(T, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    assert_eq!(textured_square(&mut cx), [255; 4]);
    cx.tex_parameteri(T, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    cx.tex_image_2d(T, 1, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    assert_eq!(textured_square(&mut cx), [10, 20, 30, 40], "level 2 is missing");
    cx.tex_parameteri(T, GL_TEXTURE_MAX_LEVEL, 1);
    assert_eq!(textured_square(&mut cx), [255; 4], "levels 0 to 1 are enough now");
    cx.tex_image_2d(T, 1, GL_RGB8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &white);
    assert_eq!(textured_square(&mut cx), [10, 20, 30, 40], "another internal format");
    cx.tex_parameteri(T, GL_TEXTURE_MAX_LEVEL, 0);
    assert_eq!(textured_square(&mut cx), [255; 4]);
    cx.tex_parameteri(T, GL_TEXTURE_BASE_LEVEL, 3);
    assert_eq!(textured_square(&mut cx), [10, 20, 30, 40], "the base level has no image");
}

#[test]
fn an_earlier_draw_keeps_its_texels() {
    let mut cx = Context::new(4, 4);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.tex_parameteri(T, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.enable(T);
    let square = |cx: &mut Context, x: f32| {
        cx.begin(GL_QUADS);
        for [dx, dy] in [[0.0f32, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, 1.0]] {
            cx.vertex2f(x + dx, dy);
        }
        cx.end();
    };
    cx.tex_image_2d(T, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[255u8, 0, 0, 255]);
    square(&mut cx, -1.0);
    cx.tex_sub_image_2d(T, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8, 255, 0, 255]);
    square(&mut cx, 0.0);
    cx.tex_image_2d(T, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[9u8; 16]);
    let got = pixels(&mut cx, 4, 4);
    assert_eq!((got[0], got[3]), ([255, 0, 0, 255], [0, 255, 0, 255]));
}

#[test]
fn images_are_copied_from_the_framebuffer() {
    let mut cx = Context::new(8, 8);
    cx.enable(GL_SCISSOR_TEST);
    for y in 0..8u8 {
        for x in 0..8u8 {
            cx.scissor(i32::from(x), i32::from(y), 1, 1);
            cx.clear_color(f32::from(x) / 8.0, f32::from(y) / 8.0, 1.0, 1.0);
            cx.clear(GL_COLOR_BUFFER_BIT);
        }
    }
    let screen = pixels(&mut cx, 8, 8);
    cx.copy_tex_image_2d(T, 0, GL_RGB8, 2, 3, 4, 2, 0);
    no_error(&mut cx);
    let got = image(&mut cx, GL_RGB, 3, 8);
    for j in 0..2 {
        for i in 0..4 {
            assert_eq!(got[(j * 4 + i) * 3..][..3], screen[(j + 3) * 8 + i + 2][..3]);
        }
    }
    cx.copy_tex_sub_image_2d(T, 0, 1, 1, 7, 7, 1, 1);
    no_error(&mut cx);
    assert_eq!(image(&mut cx, GL_RGB, 3, 8)[15..18], screen[63][..3]);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.copy_tex_sub_image_2d(T, 0, 3, 1, 0, 0, 2, 1));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.copy_tex_image_2d(T, 0, 3, 0, 0, 4, 4, 0));
}

#[test]
fn pixel_transfer_applies_to_images() {
    let mut cx = Context::new(4, 4);
    cx.pixel_transferf(GL_RED_SCALE, 0.5);
    cx.pixel_transferf(GL_GREEN_BIAS, 0.25);
    cx.pixel_transferf(GL_ALPHA_SCALE, 2.0);
    cx.tex_image_2d(T, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[200u8, 100, 50, 200]);
    cx.pixel_transferf(GL_RED_SCALE, 1.0);
    cx.pixel_transferf(GL_GREEN_BIAS, 0.0);
    cx.pixel_transferf(GL_ALPHA_SCALE, 1.0);
    assert_eq!(image(&mut cx, GL_RGBA, 4, 1), [100, 164, 50, 255]);
}

#[test]
fn generate_mipmap_makes_means() {
    let mut cx = Context::new(4, 4);
    cx.tex_parameteri(T, GL_GENERATE_MIPMAP, true);
    let px: Vec<u8> = (0..64u32).flat_map(|i| [(i * 4) as u8, 80, (255 - i) as u8, 255]).collect();
    cx.tex_image_2d(T, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, &px);
    no_error(&mut cx);
    for level in 0..4 {
        assert_eq!(level_parameter(&mut cx, T, level, GL_TEXTURE_WIDTH), 8 >> level);
    }
    let mut top = [0u8; 4];
    cx.get_tex_image(T, 3, GL_RGBA, GL_UNSIGNED_BYTE, &mut top);
    let mean = |k: usize| px.iter().skip(k).step_by(4).map(|v| f64::from(*v)).sum::<f64>() / 64.0;
    for k in 0..4 {
        assert!((f64::from(top[k]) - mean(k)).abs() <= 1.0, "{top:?}");
    }
    let mut second = [0u8; 64];
    cx.get_tex_image(T, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut second);
    // Mean of texels 0, 1, 8 and 9 of level 0: red 0, 4, 32, 36.
    assert!(second[..4].iter().zip([18, 80, 250, 255]).all(|(a, b)| a.abs_diff(b) <= 1), "{:?}", &second[..4]);
}
