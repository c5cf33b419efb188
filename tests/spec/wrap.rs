//! Wrap modes (OpenGL 1.5, section 3.8.7, with the mirror clamps of EXT_texture_mirror_clamp): every mode with every kind of
//! image against the oracle, and coordinates far out, infinite or not numbers at all: always a colour of the texture.

use crate::oracle::scene::Scene;
use crate::oracle::texel::Texture;
use crate::oracle::vertex::Vertex;
use crate::support::bridge::{self, draw};
use crate::support::compare::{EDGES, NEAREST, compare};
use crate::support::images::{bytes, noise, numbered};
use crate::support::scenes::{facing, replace};
use crate::support::{no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;

pub const MODES: [GLenum; 8] = [
    GL_REPEAT,
    GL_CLAMP,
    GL_CLAMP_TO_EDGE,
    GL_CLAMP_TO_BORDER,
    GL_MIRRORED_REPEAT,
    GL_MIRROR_CLAMP_EXT,
    GL_MIRROR_CLAMP_TO_EDGE_EXT,
    GL_MIRROR_CLAMP_TO_BORDER_EXT,
];

fn filtered(mut t: Texture, filter: GLenum) -> Texture {
    t.lod.min_filter = filter;
    t.lod.mag_filter = filter;
    t
}

#[test]
fn the_initial_modes_and_wrong_ones() {
    let mut cx = Context::new(4, 4);
    for (target, want) in [(GL_TEXTURE_2D, GL_REPEAT), (GL_TEXTURE_RECTANGLE_ARB, GL_CLAMP_TO_EDGE)] {
        for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
            let mut v = [0i32];
            cx.get_tex_parameteriv(target, pname, &mut v);
            assert_eq!(v[0] as u32, want);
        }
    }
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_parameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_WRAP_S, GL_REPEAT));
    raises(&mut cx, GL_INVALID_ENUM, |cx| {
        cx.tex_parameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    });
}

#[test]
fn every_mode_is_that_of_the_oracle() {
    for s in MODES {
        for t in MODES {
            for (filter, doubt) in [(GL_NEAREST, NEAREST), (GL_LINEAR, EDGES)] {
                for size in [[16, 8, 1], [13, 5, 1]] {
                    let image = noise(size, [0; 3], u64::from(s + 7 * t), GL_RGBA);
                    let mut texture = filtered(Texture::flat(GL_RGBA, image), filter);
                    texture.wrap = [s, t, GL_REPEAT];
                    texture.border_color = bytes([10, 250, 30, 99]);
                    let mut scene = facing(64, 64, [-2.37, 2.61], [3.19, -2.83]);
                    scene.units = vec![replace(texture)];
                    let f = compare(&scene, doubt);
                    assert!(f.off == 0 && f.share() < 2e-3, "{s:#x} {t:#x} {filter:#x} {size:?}: {f:?}");
                }
            }
        }
    }
    eprintln!("wrap: {} combinations of modes, filters and sizes within 1 LSB", MODES.len() * MODES.len() * 4);
}

#[test]
fn every_mode_in_one_and_three_dimensions() {
    for mode in MODES {
        for (filter, doubt) in [(GL_NEAREST, NEAREST), (GL_LINEAR, EDGES)] {
            for (target, size) in [(GL_TEXTURE_1D, [8, 1, 1]), (GL_TEXTURE_3D, [4, 8, 4])] {
                let image = noise(size, [0; 3], 5, GL_RGBA);
                let mut texture = filtered(Texture::new(target, GL_RGBA, vec![vec![image]]), filter);
                texture.wrap = [mode, GL_REPEAT, mode];
                texture.border_color = bytes([10, 250, 30, 99]);
                let mut scene = facing(64, 64, [-2.37, -1.61], [3.19, 2.83]);
                for v in scene.triangles.iter_mut().flatten() {
                    v.tex[0][2] = f64::from((v.tex[0][0] * 0.7 + v.tex[0][1] * 0.3) as f32);
                }
                scene.units = vec![replace(texture)];
                let f = compare(&scene, doubt);
                assert!(f.off == 0 && f.share() < 2e-3, "{mode:#x} {filter:#x} {target:#x}: {f:?}");
            }
        }
    }
}

#[test]
fn border_texels_take_the_place_of_the_border_colour() {
    for mode in [GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER] {
        for (filter, doubt) in [(GL_NEAREST, NEAREST), (GL_LINEAR, EDGES)] {
            let image = noise([8, 8, 1], [1, 1, 0], 5, GL_RGBA);
            let mut texture = filtered(Texture::flat(GL_RGBA, image), filter);
            texture.wrap = [mode; 3];
            texture.border_color = bytes([1, 1, 1, 1]);
            let mut scene = facing(64, 64, [-1.37, -0.61], [2.19, 1.83]);
            scene.units = vec![replace(texture)];
            let f = compare(&scene, doubt);
            assert!(f.off == 0 && f.share() < 2e-3, "{mode:#x} {filter:#x}: {f:?}");
        }
    }
}

#[test]
fn clamp_with_linear_mixes_the_border_in() {
    // At s = 0 CLAMP takes half of the first texel and half of the border, as OpenGL 1.0 has it.
    let image = crate::oracle::texel::Image::from_fn(4, 4, |_, _| bytes([100, 100, 100, 255]));
    let mut texture = filtered(Texture::flat(GL_RGBA, image), GL_LINEAR);
    texture.wrap = [GL_CLAMP; 3];
    texture.border_color = bytes([200, 0, 50, 255]);
    let mut scene = facing(8, 8, [-3.0, 0.5], [-2.0, 0.5]);
    scene.units = vec![replace(texture)];
    let got = draw(&scene);
    assert!(got.iter().all(|p| *p == [150, 50, 75, 255]), "{:?}", got[0]);
}

/// A quad with the same coordinates at all corners.
fn constant(texture: &Texture, s: f64, t: f64) -> Scene {
    let mut scene = Scene::new(4, 4);
    let v = |x, y| Vertex::at(x, y, 0.0).strq([s, t, s, 1.0]);
    scene.quad([v(-1.0, -1.0), v(1.0, -1.0), v(1.0, 1.0), v(-1.0, 1.0)]);
    scene.units = vec![replace(texture.clone())];
    scene
}

#[test]
fn coordinates_far_out_stay_within_the_texture() {
    let mut checked = 0;
    for mode in MODES {
        for filter in [GL_NEAREST, GL_LINEAR] {
            let image = numbered([16, 16, 1], [0; 3], 0);
            let mut texture = filtered(Texture::flat(GL_RGBA, image), filter);
            texture.wrap = [mode; 3];
            texture.border_color = bytes([9, 9, 17, 255]);
            for far in [1e3f32, 12345.67, 1e5, 1e6, 16_777_216.0, 1e9, 2.5e9, 1e20, 1e38] {
                for s in [far, -far] {
                    let scene = constant(&texture, f64::from(s), 0.3);
                    let got = draw(&scene);
                    let ideal = scene.render();
                    for (i, p) in got.iter().enumerate() {
                        assert!(
                            (9..=54).contains(&p[0]) && (9..=54).contains(&p[1]) && p[2] == 17 && p[3] == 255,
                            "{p:?}"
                        );
                        let want = ideal.pixels[i].bytes();
                        let near = (0..4).all(|k| (i16::from(want[k]) - i16::from(p[k])).abs() <= 1);
                        let doubtful =
                            filter == GL_NEAREST && ideal.pixels[i].story.as_ref().unwrap().to_boundary < 1e-3;
                        assert!(near || doubtful, "{mode:#x} {filter:#x} s = {s}: {p:?}, want {want:?}");
                    }
                    checked += 1;
                }
            }
        }
    }
    eprintln!("wrap: {checked} coordinates up to 1e38 give the oracle's colour");
}

#[test]
fn coordinates_that_vary_around_a_million() {
    for mode in MODES {
        for filter in [GL_NEAREST, GL_LINEAR] {
            let image = numbered([16, 16, 1], [0; 3], 0);
            let mut texture = filtered(Texture::flat(GL_RGBA, image), filter);
            texture.wrap = [mode; 3];
            texture.border_color = bytes([9, 9, 17, 255]);
            let mut scene = facing(32, 32, [999_999.5, -1_000_001.5], [1_000_002.25, -999_998.0]);
            scene.units = vec![replace(texture)];
            let f = compare(&scene, if filter == GL_NEAREST { NEAREST } else { EDGES });
            assert!(f.off == 0, "{mode:#x} {filter:#x}: {f:?}");
        }
    }
}

#[test]
fn coordinates_that_are_no_numbers_give_some_texel() {
    for mode in MODES {
        for filter in [GL_NEAREST, GL_LINEAR] {
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE] {
                let image = numbered([16, 16, 1], [0; 3], 0);
                let mut texture = filtered(Texture::flat(GL_RGBA, image), filter);
                texture.wrap = [mode; 3];
                texture.border_color = bytes([9, 9, 17, 255]);
                let scene = constant(&texture, 0.5, 0.5);
                let mut cx = Context::new(4, 4);
                bridge::state(&mut cx, &scene);
                cx.begin(GL_TRIANGLES);
                for [x, y] in [[-1.0f32, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
                    cx.tex_coord4f(bad, if x > 0.0 { bad } else { 0.25 }, bad, 1.0);
                    cx.vertex2f(x, y);
                }
                cx.end();
                no_error(&mut cx);
                for p in pixels(&mut cx, 4, 4) {
                    assert!(
                        (9..=54).contains(&p[0]) && (9..=54).contains(&p[1]) && p[2] == 17,
                        "{mode:#x} {bad}: {p:?}"
                    );
                }
            }
        }
    }
}
