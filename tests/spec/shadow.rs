//! Depth textures and their comparison (OpenGL 1.5, section 3.8.14): every comparison function and every mode against the
//! oracle, and depth copied from the frame buffer.

use crate::oracle::texel::{Image, Texture};
use crate::support::compare::{EDGES, NEAREST, compare};
use crate::support::images::nearest;
use crate::support::scenes::{facing, replace};
use crate::support::{Random, no_error, pixels};
use fixedgl::Context;
use fixedgl::enums::*;

fn depths() -> Texture {
    let random = std::cell::RefCell::new(Random(5));
    let image = Image::from_fn(16, 16, |_, _| [random.borrow_mut().range(0.1, 0.9), 0.0, 0.0, 0.0]);
    nearest(Texture::flat(GL_DEPTH_COMPONENT, image))
}

#[test]
fn every_comparison_and_mode_agrees_with_the_oracle() {
    let functions = [GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER];
    for func in functions {
        for mode in [GL_LUMINANCE, GL_INTENSITY, GL_ALPHA] {
            let mut t = depths();
            t.compare = Some(func);
            t.depth_mode = mode;
            let mut scene = facing(64, 64, [0.0, 0.0], [1.0, 1.0]);
            for v in scene.triangles.iter_mut().flatten() {
                v.color = [0.25, 0.5, 0.75, 1.0];
                v.tex[0][2] = f64::from((v.tex[0][0] * 0.6 + v.tex[0][1] * 0.3) as f32);
            }
            scene.units = vec![replace(t)];
            // r meets a texel's depth in a handful of pixels only.
            let f = compare(&scene, NEAREST);
            assert!(f.drawn > 3000 && f.share() < 2e-3, "{func:#x} {mode:#x}: {f:?}");
        }
    }
}

#[test]
fn without_comparison_depth_is_a_colour() {
    for mode in [GL_LUMINANCE, GL_INTENSITY, GL_ALPHA] {
        let mut t = depths();
        t.depth_mode = mode;
        t.lod.min_filter = GL_LINEAR;
        t.lod.mag_filter = GL_LINEAR;
        let mut scene = facing(64, 64, [0.2, 0.1], [1.5, 1.3]);
        scene.units = vec![replace(t)];
        compare(&scene, EDGES).within_one_lsb(&format!("depth as {}", fixedgl::enums::name(mode)));
    }
}

#[test]
fn depth_is_copied_from_the_frame_buffer() {
    let mut cx = Context::new(16, 16);
    cx.clear_depth(0.25);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.scissor(0, 0, 8, 16);
    cx.enable(GL_SCISSOR_TEST);
    cx.clear_depth(0.75);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.disable(GL_SCISSOR_TEST);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 16, 16, 0);
    no_error(&mut cx);
    cx.enable(GL_TEXTURE_2D);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.begin(GL_QUADS);
    for [x, y] in [[-1.0f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        cx.tex_coord3f((x + 1.0) / 2.0, (y + 1.0) / 2.0, 0.5);
        cx.vertex2f(x, y);
    }
    cx.end();
    let got = pixels(&mut cx, 16, 16);
    for (i, p) in got.iter().enumerate() {
        let want = if i % 16 < 8 { 255 } else { 0 };
        assert_eq!(p[0], want, "pixel {i}");
    }
}
