//! GLU on a real context (spec-notes/glu.md): the levels that a mipmap gets against means in f64, the unpack state read
//! and put back, fits to the limits, codes, the C-named door.

use fixedgl::Context;
use fixedgl::DebugMessage;
use fixedgl::c::*;
use fixedgl::glu::{self, MipmapLevels};
use std::sync::{Arc, Mutex};

fn context() -> Context {
    let mut cx = Context::new(8, 8);
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    cx
}

fn get(cx: &mut Context, pname: GLenum) -> i32 {
    let mut v = [0];
    cx.get_integerv(pname, &mut v);
    v[0]
}

fn level_size(cx: &mut Context, target: GLenum, level: i32) -> [i32; 3] {
    [GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH].map(|pname| {
        let mut v = [0];
        cx.get_tex_level_parameteriv(target, level, pname, &mut v);
        v[0]
    })
}

/// A level as bytes of R, G, B, A; a luminance comes back in R (table 6.1).
fn level(cx: &mut Context, target: GLenum, n: i32) -> Vec<u8> {
    let [w, h, d] = level_size(cx, target, n);
    let mut out = vec![0u8; (w * h * d.max(1) * 4) as usize];
    cx.get_tex_image(target, n, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
    cx.check().expect("a level");
    out
}

/// The mean of a byte image of `channels` over the area of each texel of a smaller or larger one, in f64.
fn areas(image: &[u8], [w, h]: [usize; 2], channels: usize, [nw, nh]: [usize; 2]) -> Vec<f64> {
    let overlap = |i: usize, n: usize, k: usize, old: usize| {
        let scale = old as f64 / n as f64;
        ((k + 1) as f64).min((i + 1) as f64 * scale) - (k as f64).max(i as f64 * scale)
    };
    let mut out = Vec::new();
    for y in 0..nh {
        for x in 0..nw {
            for c in 0..channels {
                let (mut sum, mut area) = (0.0, 0.0);
                for ky in 0..h {
                    for kx in 0..w {
                        let part = overlap(x, nw, kx, w).max(0.0) * overlap(y, nh, ky, h).max(0.0);
                        sum += part * f64::from(image[(ky * w + kx) * channels + c]);
                        area += part;
                    }
                }
                out.push(sum / area);
            }
        }
    }
    out
}

fn noise(n: usize) -> Vec<u8> {
    (0..n).map(|i| (i.wrapping_mul(2_654_435_761) >> 7) as u8).collect()
}

#[test]
fn every_level_is_the_mean_of_its_area() {
    for (size, fitted) in
        [([6usize, 3usize], [8usize, 4usize]), ([16, 4], [16, 4]), ([5, 11], [4, 8]), ([1, 7], [1, 8])]
    {
        let mut cx = context();
        let image = noise(size[0] * size[1] * 3);
        let (w, h) = (size[0] as i32, size[1] as i32);
        let code = glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, GL_RGB8, w, h, GL_RGB, GL_UNSIGNED_BYTE, &image);
        assert_eq!(code, 0);
        cx.check().expect("no error");
        let (mut n, mut at) = (0, fitted);
        loop {
            assert_eq!(level_size(&mut cx, GL_TEXTURE_2D, n)[..2], at.map(|v| v as i32), "level {n} of {size:?}");
            // All levels are halvings of the fitted image, so each is the mean over its area of the original.
            let want = areas(&image, size, 3, at);
            let got = level(&mut cx, GL_TEXTURE_2D, n);
            for (i, want) in want.iter().enumerate() {
                let got = f64::from(got[i / 3 * 4 + i % 3]);
                assert!((got - want).abs() <= 0.501, "level {n} of {size:?}: {got} instead of {want}");
            }
            if at == [1, 1] {
                break;
            }
            (n, at) = (n + 1, at.map(|v| (v / 2).max(1)));
        }
        assert_eq!(level_size(&mut cx, GL_TEXTURE_2D, n + 1), [0; 3]);
    }
}

#[test]
fn one_and_three_dimensions_and_faces() {
    let mut cx = context();
    assert_eq!(
        glu::build_1d_mipmaps(&mut cx, GL_TEXTURE_1D, 1, 4, GL_LUMINANCE, GL_UNSIGNED_BYTE, &[0u8, 100, 200, 255]),
        0
    );
    assert_eq!(level(&mut cx, GL_TEXTURE_1D, 1), [50, 0, 0, 255, 228, 0, 0, 255]);
    assert_eq!(level(&mut cx, GL_TEXTURE_1D, 2), [139, 0, 0, 255]);
    let cube: Vec<u8> = (0..8).map(|i| i * 10).collect();
    assert_eq!(glu::build_3d_mipmaps(&mut cx, GL_TEXTURE_3D, GL_ALPHA8, 2, 2, 2, GL_ALPHA, GL_UNSIGNED_BYTE, &cube), 0);
    assert_eq!(level_size(&mut cx, GL_TEXTURE_3D, 0), [2, 2, 2]);
    assert_eq!(level(&mut cx, GL_TEXTURE_3D, 1)[3], 35);
    for face in GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z {
        assert_eq!(glu::build_2d_mipmaps(&mut cx, face, GL_RGBA, 3, 3, GL_RGB, GL_UNSIGNED_BYTE, &noise(27)), 0);
        assert_eq!(level_size(&mut cx, face, 0)[..2], [4, 4]);
        assert_eq!(level_size(&mut cx, face, 2)[..2], [1, 1]);
    }
    cx.check().expect("no error");
}

#[test]
fn the_unpack_state_is_read_and_put_back() {
    let mut cx = context();
    let state = [
        (GL_UNPACK_ROW_LENGTH, 5),
        (GL_UNPACK_SKIP_ROWS, 1),
        (GL_UNPACK_SKIP_PIXELS, 2),
        (GL_UNPACK_ALIGNMENT, 4),
        (GL_UNPACK_SWAP_BYTES, 1),
    ];
    for (pname, value) in state {
        cx.pixel_storei(pname, value);
    }
    // Rows of 5 shorts padded to 12 bytes; the image is 2 x 2 at (2, 1).
    let mut shorts = [0u16; 18];
    for (at, v) in [(8, 0x1000u16), (9, 0x3000), (14, 0x5000), (15, 0x7000)] {
        shorts[at] = v.swap_bytes();
    }
    let code =
        glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, GL_LUMINANCE16, 2, 2, GL_LUMINANCE, GL_UNSIGNED_SHORT, &shorts);
    assert_eq!(code, 0);
    for (pname, value) in state {
        assert_eq!(get(&mut cx, pname), value);
    }
    let mut mean = [0u16];
    cx.get_tex_image(GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_SHORT, &mut mean);
    assert_eq!(mean, [0x4000]);
    let mut first = [0u16; 4];
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    cx.get_tex_image(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_SHORT, &mut first);
    assert_eq!(first, [0x1000, 0x3000, 0x5000, 0x7000]);
    cx.check().expect("no error");
}

#[test]
fn packed_types_and_pixel_transfer_reach_the_levels() {
    let mut cx = context();
    // 5_6_5: pure red, green, blue, white.
    let texels = [0xf800u16, 0x07e0, 0x001f, 0xffff];
    let kind = GL_UNSIGNED_SHORT_5_6_5;
    assert_eq!(glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, GL_RGB8, 2, 2, GL_RGB, kind, &texels), 0);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 1), [128, 128, 128, 255]);
    // The scale acts once a level, not once a halving.
    cx.pixel_transferf(GL_RED_SCALE, 0.5);
    let bytes = [200u8; 16];
    assert_eq!(glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, 1, 4, 4, GL_LUMINANCE, GL_UNSIGNED_BYTE, &bytes), 0);
    for n in 0..3 {
        assert_eq!(level(&mut cx, GL_TEXTURE_2D, n)[0], 100, "level {n}");
    }
    // Floats are not limited before the scale.
    let floats = [4.0f32, 0.0, 0.0, 0.0];
    cx.pixel_transferf(GL_RED_SCALE, 0.25);
    assert_eq!(glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, 1, 2, 2, GL_LUMINANCE, GL_FLOAT, &floats), 0);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 1)[0], 64);
}

#[test]
fn sizes_are_fitted_to_the_limit() {
    let mut cx = context();
    let most = get(&mut cx, GL_MAX_TEXTURE_SIZE);
    let image = vec![7u8; most as usize * 2];
    let byte = GL_UNSIGNED_BYTE;
    assert_eq!(glu::build_1d_mipmaps(&mut cx, GL_TEXTURE_1D, 1, most * 2, GL_LUMINANCE, byte, &image), 0);
    assert_eq!(level_size(&mut cx, GL_TEXTURE_1D, 0)[0], most);
    assert_eq!(glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, 1, most * 2, 1, GL_LUMINANCE, byte, &image), 0);
    assert_eq!(level_size(&mut cx, GL_TEXTURE_2D, 0)[..2], [most, 1]);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 3)[..5], [7, 0, 0, 255, 7]);
    cx.check().expect("no error");
}

#[test]
fn some_levels_can_be_built_alone() {
    let mut cx = context();
    let row: [u8; 8] = [0, 100, 200, 255, 10, 20, 30, 40];
    let mut build = |levels, size: [i32; 2]| {
        let (format, kind) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
        glu::build_2d_mipmap_levels(&mut cx, GL_TEXTURE_2D, 1, size[0], size[1], format, kind, levels, &row)
    };
    let bad = GLU_INVALID_VALUE as i32;
    assert_eq!(build(MipmapLevels { level: 0, base: 0, max: 4 }, [8, 1]), bad);
    assert_eq!(build(MipmapLevels { level: 1, base: 0, max: 2 }, [8, 1]), bad);
    assert_eq!(build(MipmapLevels { level: 0, base: 0, max: 1 }, [6, 1]), bad);
    assert_eq!(build(MipmapLevels { level: 1, base: 2, max: 3 }, [8, 1]), 0);
    let widths: Vec<i32> = (0..5).map(|n| level_size(&mut cx, GL_TEXTURE_2D, n)[0]).collect();
    assert_eq!(widths, [0, 0, 4, 2, 0]);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 2)[..5], [50, 0, 0, 255, 228]);
}

#[test]
fn failures_give_codes_and_sentences() {
    let mut cx = context();
    let heard = Arc::new(Mutex::new(Vec::new()));
    let ears = Arc::clone(&heard);
    cx.set_debug_callback(Some(Box::new(move |m: &DebugMessage<'_>| {
        ears.lock().expect("ears").push(m.message.to_string());
    })));
    let image = noise(64);
    let (tex, byte) = (GL_TEXTURE_2D, GL_UNSIGNED_BYTE);
    let mut code = |target, w, h, format, kind, image: &[u8]| {
        glu::build_2d_mipmaps(&mut cx, target, GL_RGB, w, h, format, kind, image) as u32
    };
    assert_eq!(code(tex, 4, 2, GL_STENCIL_INDEX, byte, &image), GLU_INVALID_ENUM);
    assert_eq!(code(tex, 4, 2, 77, byte, &image), GLU_INVALID_ENUM);
    assert_eq!(code(tex, 4, 2, GL_RGB, 77, &image), GLU_INVALID_ENUM);
    assert_eq!(code(tex, 4, 2, GL_RGB, GL_BITMAP, &image), GLU_INVALID_ENUM);
    assert_eq!(code(GL_TEXTURE_1D, 4, 2, GL_RGB, byte, &image), GLU_INVALID_ENUM);
    assert_eq!(code(tex, 0, 2, GL_RGB, byte, &image), GLU_INVALID_VALUE);
    assert_eq!(code(tex, -1, 2, GL_RGB, byte, &image), GLU_INVALID_VALUE);
    assert_eq!(code(tex, 4, 2, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, &image), GLU_INVALID_OPERATION);
    assert_eq!(code(tex, 5, 5, GL_RGB, byte, &image), GLU_INVALID_OPERATION);
    assert_eq!(code(tex, i32::MAX, i32::MAX, GL_RGB, byte, &image), GLU_INVALID_OPERATION);
    let sentences = heard.lock().expect("ears").clone();
    assert_eq!(sentences.len(), 10, "{sentences:#?}");
    assert_eq!(get(&mut cx, GL_UNPACK_ALIGNMENT), 1);
    // None of this is an error of the GL; a bad internal format is.
    cx.check().expect("no error of the GL");
    assert_eq!(glu::build_2d_mipmaps(&mut cx, tex, 99, 3, 3, GL_RGB, byte, &image), 0);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    // No memory: levels without content.
    assert_eq!(glu::build_2d_mipmaps(&mut cx, tex, 3, 3, 3, GL_RGB, byte, NULL), 0);
    assert_eq!(level_size(&mut cx, tex, 2)[..2], [1, 1]);
}

#[test]
fn the_door_with_the_names_of_c() {
    make_current(context());
    glMatrixMode(GL_PROJECTION);
    gluPerspective(90, 2.0f32, 1.0, 3);
    let mut m = [0.0f64; 16];
    glGetDoublev(GL_PROJECTION_MATRIX, &mut m);
    assert_eq!((m[0], m[5], m[10], m[11], m[14]), (0.5, 1.0, -2.0, -1.0, -3.0));
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
    let (mut model, mut x, mut y, mut z) = ([0.0f64; 16], 0.0, 0.0, 0.0);
    glGetDoublev(GL_MODELVIEW_MATRIX, &mut model);
    assert_eq!(model[14], -5.0);
    let viewport = [0, 0, 100, 100];
    assert_eq!(gluProject(0, 0, 3, &model, &m, &viewport, &mut x, &mut y, &mut z), 1);
    assert_eq!((x, y), (50.0, 50.0));
    let (mut ox, mut oy, mut oz) = (0.0, 0.0, 0.0);
    assert_eq!(gluUnProject(x, y, z, &model, &m, &viewport, &mut ox, &mut oy, &mut oz), 1);
    assert!(ox.abs() + oy.abs() + (oz - 3.0).abs() < 1e-12, "({ox}, {oy}, {oz})");
    assert_eq!(gluProject(0, 0, 3, &model[..3], &m, &viewport, &mut x, &mut y, &mut z), 0);
    let q = gluNewQuadric();
    gluQuadricDrawStyle(&q, GLU_LINE);
    gluQuadricTexture(&q, GL_TRUE);
    gluSphere(&q, 1, 8, 8);
    gluDeleteQuadric(q);
    let mut out = [0u8; 2];
    let row = [0u8, 100, 200, 255];
    let byte = GL_UNSIGNED_BYTE;
    assert_eq!(gluScaleImage(GL_LUMINANCE, 4, 1, byte, &row, 2, 1, byte, &mut out), 0);
    assert_eq!(out, [50, 228]);
    assert_eq!(gluErrorString(GLU_INVALID_VALUE), "invalid value");
    assert_eq!(gluBuild2DMipmaps(GL_TEXTURE_2D, 3, 4, 1, GL_LUMINANCE, byte, &row), 0);
    take_current();
}
