//! GLU 1.3: the matrices against the oracle's, projection and its way back, the sizes and texels of mipmaps, image scaling
//! with the numbers of the reference implementation, a textured sphere.

use crate::oracle::matrix::{M4, project, unproject};
use crate::support::{Random, no_error, pixels};
use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::glu;

fn current(cx: &mut Context) -> M4 {
    let mut v = [0f64; 16];
    cx.get_doublev(GL_MODELVIEW_MATRIX, &mut v);
    no_error(cx);
    M4::from_gl(v)
}

#[track_caller]
fn near(a: M4, b: M4, eps: f64) {
    crate::oracle::assert_near(&a.to_gl(), &b.to_gl(), eps);
}

#[test]
fn matrices_are_those_of_the_oracle() {
    let mut cx = Context::new(4, 4);
    glu::perspective(&mut cx, 40.0, 1.5, 0.5, 30.0);
    near(current(&mut cx), M4::perspective(40.0, 1.5, 0.5, 30.0), 1e-12);
    cx.load_identity();
    glu::look_at(&mut cx, [1.0, 2.0, 5.0], [0.5, 0.0, -1.0], [0.0, 1.0, 0.2]);
    near(current(&mut cx), M4::look_at([1.0, 2.0, 5.0], [0.5, 0.0, -1.0], [0.0, 1.0, 0.2]), 1e-12);
    cx.load_identity();
    glu::ortho_2d(&mut cx, -1.0, 3.0, 2.0, 5.0);
    near(current(&mut cx), M4::ortho(-1.0, 3.0, 2.0, 5.0, -1.0, 1.0), 1e-12);
    cx.load_identity();
    glu::pick_matrix(&mut cx, 25.0, 70.0, 5.0, 8.0, &[10, 20, 100, 200]);
    near(current(&mut cx), M4::pick(25.0, 70.0, 5.0, 8.0, [10.0, 20.0, 100.0, 200.0]), 1e-12);
    // Nothing sensible can come of these; nothing bad either.
    glu::perspective(&mut cx, 40.0, 0.0, 0.5, 30.0);
    glu::perspective(&mut cx, f64::NAN, 1.0, 0.0, 0.0);
    glu::look_at(&mut cx, [0.0; 3], [0.0; 3], [0.0; 3]);
    let _ = cx.get_error();
}

#[test]
fn unproject_undoes_project() {
    let mut random = Random(3);
    let viewport = [10, -5, 300, 200];
    let view = viewport.map(f64::from);
    for _ in 0..100 {
        let at = [random.range(-2.0, 2.0), random.range(-2.0, 2.0), random.range(-2.0, 2.0)];
        let model = M4::translation(0.0, 0.0, -6.0).times(M4::rotation(random.range(0.0, 360.0), [1.0, 2.0, 3.0]));
        let projection = M4::perspective(60.0, 1.5, 0.5, 20.0);
        let got = glu::project(at, &model.to_gl(), &projection.to_gl(), &viewport).unwrap();
        crate::oracle::assert_near(&got, &project(at, model, projection, view).unwrap(), 1e-9);
        let back = glu::un_project(got, &model.to_gl(), &projection.to_gl(), &viewport).unwrap();
        crate::oracle::assert_near(&back, &at, 1e-9);
        crate::oracle::assert_near(&back, &unproject(got, model, projection, view).unwrap(), 1e-9);
    }
    assert!(glu::un_project([1.0; 3], &[0.0; 16], &[0.0; 16], &viewport).is_none());
}

fn width(cx: &mut Context, level: i32) -> i32 {
    let mut v = [0i32];
    cx.get_tex_level_parameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &mut v);
    no_error(cx);
    v[0]
}

#[test]
fn sizes_are_rounded_to_powers_of_two() {
    // Halfway is at 1.5 times a power of two, inclusive upwards.
    for (n, want) in [
        (1, 1),
        (2, 2),
        (3, 4),
        (5, 4),
        (6, 8),
        (7, 8),
        (10, 8),
        (12, 16),
        (23, 16),
        (24, 32),
        (48, 64),
        (60, 64),
        (95, 64),
        (97, 128),
        (100, 128),
        (191, 128),
        (193, 256),
    ] {
        let mut cx = Context::new(4, 4);
        let px = vec![77u8; n as usize * 3 + 8];
        let code = glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, 3, n, 1, GL_RGB, GL_UNSIGNED_BYTE, &px);
        assert_eq!(code, 0);
        assert_eq!(width(&mut cx, 0), want, "{n}");
        for level in 1..=want.ilog2() {
            assert_eq!(width(&mut cx, level as i32), want >> level);
        }
        assert_eq!(width(&mut cx, want.ilog2() as i32 + 1), 0);
        let mut got = vec![0u8; 4];
        cx.get_tex_image(GL_TEXTURE_2D, want.ilog2() as i32, GL_RGB, GL_UNSIGNED_BYTE, &mut got);
        assert_eq!(got[..3], [77; 3], "one colour stays one colour");
    }
}

#[test]
fn levels_are_means_of_four() {
    let mut cx = Context::new(4, 4);
    let mut random = Random(8);
    let px: Vec<u8> = (0..64).map(|_| random.bits() as u8).collect();
    glu::build_2d_mipmaps(&mut cx, GL_TEXTURE_2D, GL_LUMINANCE, 8, 8, GL_LUMINANCE, GL_UNSIGNED_BYTE, &px);
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let mut got = [0u8; 16];
    cx.get_tex_image(GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut got);
    no_error(&mut cx);
    for j in 0..4 {
        for i in 0..4 {
            let at = |a: usize, b: usize| f64::from(px[(2 * j + b) * 8 + 2 * i + a]);
            let mean = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4.0;
            assert!((f64::from(got[j * 4 + i]) - mean).abs() <= 1.0);
        }
    }
}

#[test]
fn scale_image_has_the_numbers_of_the_reference() {
    let mut cx = Context::new(4, 4);
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let b = GL_UNSIGNED_BYTE;
    let input = [0u8, 100, 200, 255];
    let mut half = [0u8; 2];
    assert_eq!(glu::scale_image(&mut cx, GL_LUMINANCE, 4, 1, b, &input, 2, 1, b, &mut half), 0);
    let mut three = [0u8; 3];
    assert_eq!(glu::scale_image(&mut cx, GL_LUMINANCE, 4, 1, b, &input, 3, 1, b, &mut three), 0);
    let mut eight = [0u8; 8];
    assert_eq!(glu::scale_image(&mut cx, GL_LUMINANCE, 4, 1, b, &input, 8, 1, b, &mut eight), 0);
    let close = |got: &[u8], want: &[i32]| {
        assert!(got.iter().zip(want).all(|(g, w)| (i32::from(*g) - w).abs() <= 1), "{got:?}, want {want:?}");
    };
    close(&half, &[50, 228]);
    close(&three, &[25, 150, 242]);
    close(&eight, &[64, 25, 75, 125, 175, 214, 242, 191]);
    let mut short = [0u8; 1];
    assert_ne!(glu::scale_image(&mut cx, GL_LUMINANCE, 4, 1, b, &input, 8, 1, b, &mut short), 0);
    assert_ne!(glu::scale_image(&mut cx, GL_LUMINANCE, -4, 1, b, &input, 8, 1, b, &mut eight), 0);
}

#[test]
fn a_sphere_wears_its_texture() {
    let mut cx = Context::new(64, 64);
    let ramp: Vec<u8> = (0..256).flat_map(|t| (0..256).flat_map(move |s| [s as u8, t as u8, 9])).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB8, 256, 256, 0, GL_RGB, GL_UNSIGNED_BYTE, &ramp);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
    cx.enable(GL_CULL_FACE);
    let mut q = glu::Quadric::new();
    q.texture(true);
    // The reference implementation counts s down: 1 at +y, 3/4 at +x, 1/2 at -y, 1/4 at -x, so that a text on the
    // sphere is read from the outside (its manual page says the opposite). Turn +x, then -x, towards the viewer.
    for (angle, s) in [(-90.0, 192), (90.0, 64)] {
        cx.load_identity();
        cx.rotatef(angle, 0.0, 1.0, 0.0);
        cx.clear(GL_COLOR_BUFFER_BIT);
        q.sphere(&mut cx, 0.9, 64, 32);
        no_error(&mut cx);
        let got = pixels(&mut cx, 64, 64);
        let centre = got[32 * 64 + 32];
        assert!((i32::from(centre[0]) - s).abs() <= 4 && (i32::from(centre[1]) - 128).abs() <= 4, "{centre:?}");
        let covered = got.iter().filter(|p| p[2] == 9).count() as f64;
        let disc = std::f64::consts::PI * (0.9f64 * 32.0).powi(2);
        assert!((covered / disc - 1.0).abs() < 0.01, "{covered} pixels of {disc}");
    }
}

#[test]
fn errors_have_sentences() {
    assert!(glu::error_string(GL_INVALID_ENUM).is_some_and(|s| s.contains("enum")));
    assert!(glu::error_string(glu::GLU_OUT_OF_MEMORY).is_some_and(|s| s.contains("memory")));
    assert_eq!(glu::get_string(glu::GLU_VERSION), Some("1.3"));
}
