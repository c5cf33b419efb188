//! Coordinate transformations (OpenGL 1.5, sections 2.10 and 2.11): matrix commands against the oracle's matrices, the
//! stacks, viewport and depth range, their errors.

use crate::oracle::matrix::M4;
use crate::support::compare::{EDGES, compare};
use crate::support::scenes::heap;
use crate::support::{Random, get_f, get_i, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn matrix(cx: &mut Context, name: GLenum) -> M4 {
    let mut v = [0f64; 16];
    cx.get_doublev(name, &mut v);
    no_error(cx);
    M4::from_gl(v)
}

/// The largest difference, relative to the largest element.
fn distance(a: M4, b: M4) -> f64 {
    let size = b.to_gl().iter().fold(1.0f64, |m, v| m.max(v.abs()));
    a.to_gl().iter().zip(b.to_gl()).map(|(x, y)| (x - y).abs() / size).fold(0.0, f64::max)
}

#[test]
fn the_initial_state_is_the_tables() {
    let mut cx = Context::new(320, 200);
    for name in [GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX] {
        assert_eq!(matrix(&mut cx, name), M4::IDENTITY);
    }
    assert_eq!(get_i(&mut cx, GL_MATRIX_MODE) as u32, GL_MODELVIEW);
    for depth in [GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH] {
        assert_eq!(get_i(&mut cx, depth), 1);
    }
    assert_eq!(get_f::<4>(&mut cx, GL_VIEWPORT), [0.0, 0.0, 320.0, 200.0]);
    assert_eq!(get_f::<2>(&mut cx, GL_DEPTH_RANGE), [0.0, 1.0]);
    assert_eq!(get_i(&mut cx, GL_NORMALIZE), 0);
}

#[test]
fn every_matrix_command_multiplies_as_the_oracle_does() {
    let mut random = Random(9);
    let mut worst = 0.0f64;
    for _ in 0..200 {
        let mut cx = Context::new(4, 4);
        let mut want = M4::IDENTITY;
        for _ in 0..6 {
            let v: [f64; 16] = std::array::from_fn(|_| random.range(-3.0, 3.0));
            let f = v.map(|x| x as f32);
            let m = M4::from_gl(v);
            let step = match random.below(10) {
                0 => {
                    cx.translated(v[0], v[1], v[2]);
                    M4::translation(v[0], v[1], v[2])
                }
                1 => {
                    cx.scalef(f[0], f[1], f[2]);
                    M4::scaling(v[0], v[1], v[2])
                }
                2 => {
                    cx.rotated(v[0] * 100.0, v[1], v[2], v[3]);
                    M4::rotation(v[0] * 100.0, [v[1], v[2], v[3]])
                }
                3 => {
                    cx.mult_matrixd(&v);
                    m
                }
                4 => {
                    cx.mult_matrixf(&f);
                    m
                }
                5 => {
                    cx.mult_transpose_matrixd(&v);
                    m.transpose()
                }
                6 => {
                    cx.ortho(v[0], v[0] + 1.5, v[1], v[1] + 2.5, v[2], v[2] + 0.75);
                    M4::ortho(v[0], v[0] + 1.5, v[1], v[1] + 2.5, v[2], v[2] + 0.75)
                }
                7 => {
                    let n = v[2].abs() + 0.1;
                    cx.frustum(v[0], v[0] + 1.5, v[1], v[1] + 2.5, n, n + 2.0);
                    M4::frustum(v[0], v[0] + 1.5, v[1], v[1] + 2.5, n, n + 2.0)
                }
                8 => {
                    cx.load_matrixf(&f);
                    want = M4::IDENTITY;
                    m
                }
                _ => {
                    cx.load_transpose_matrixf(&f);
                    want = M4::IDENTITY;
                    m.transpose()
                }
            };
            want = want.times(step);
            worst = worst.max(distance(matrix(&mut cx, GL_MODELVIEW_MATRIX), want));
        }
    }
    eprintln!("matrices: worst relative difference {worst:.1e}");
    assert!(worst < 1e-12, "{worst}");
}

#[test]
fn stacks_push_pop_and_refuse() {
    let mut cx = Context::new(4, 4);
    for (mode, depth, limit) in [
        (GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH),
        (GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH),
        (GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH),
    ] {
        cx.matrix_mode(mode);
        raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_matrix());
        let limit = get_i(&mut cx, limit);
        for _ in 1..limit {
            cx.push_matrix();
        }
        assert_eq!(get_i(&mut cx, depth), limit);
        raises(&mut cx, GL_STACK_OVERFLOW, |cx| cx.push_matrix());
        assert_eq!(get_i(&mut cx, depth), limit);
        for _ in 1..limit {
            cx.pop_matrix();
        }
        no_error(&mut cx);
    }
    cx.matrix_mode(GL_MODELVIEW);
    cx.translatef(1.0, 2.0, 3.0);
    cx.push_matrix();
    cx.load_identity();
    cx.pop_matrix();
    assert_eq!(matrix(&mut cx, GL_MODELVIEW_MATRIX), M4::translation(1.0, 2.0, 3.0));
    let mut t = [0f64; 16];
    cx.get_doublev(GL_TRANSPOSE_MODELVIEW_MATRIX, &mut t);
    assert_eq!(t[3], 1.0);
}

#[test]
fn a_texture_stack_for_each_unit() {
    let mut cx = Context::new(4, 4);
    cx.matrix_mode(GL_TEXTURE);
    cx.active_texture(GL_TEXTURE3);
    cx.push_matrix();
    cx.scalef(2.0, 2.0, 2.0);
    cx.active_texture(GL_TEXTURE0);
    assert_eq!(matrix(&mut cx, GL_TEXTURE_MATRIX), M4::IDENTITY);
    assert_eq!(get_i(&mut cx, GL_TEXTURE_STACK_DEPTH), 1);
    cx.active_texture(GL_TEXTURE3);
    assert_eq!(matrix(&mut cx, GL_TEXTURE_MATRIX), M4::scaling(2.0, 2.0, 2.0));
    assert_eq!(get_i(&mut cx, GL_TEXTURE_STACK_DEPTH), 2);
}

#[test]
fn wrong_arguments_are_refused() {
    let mut cx = Context::new(4, 4);
    cx.translatef(1.0, 2.0, 3.0);
    let before = matrix(&mut cx, GL_MODELVIEW_MATRIX);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.matrix_mode(GL_TEXTURE_2D));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.frustum(-1.0, 1.0, -1.0, 1.0, 0.0, 1.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, -1.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.frustum(1.0, 1.0, -1.0, 1.0, 1.0, 2.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.ortho(0.0, 1.0, 2.0, 2.0, 0.0, 1.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.ortho(0.0, 1.0, 1.0, 2.0, 1.0, 1.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.viewport(0, 0, -1, 1));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.viewport(0, 0, 1, -1));
    assert_eq!(matrix(&mut cx, GL_MODELVIEW_MATRIX), before);
    assert_eq!(get_f::<4>(&mut cx, GL_VIEWPORT), [0.0, 0.0, 4.0, 4.0]);
}

#[test]
fn a_viewport_somewhere_with_a_depth_range() {
    for (viewport, range) in
        [([10, 20, 50, 30], (0.0, 1.0)), ([-20, -10, 100, 90], (1.0, 0.0)), ([3, 3, 90, 91], (0.25, 0.25))]
    {
        let mut scene = heap(96, 96, 14, 1.0, 6);
        scene.depth = Some((GL_LEQUAL, true));
        scene.viewport.x = f64::from(viewport[0]);
        scene.viewport.y = f64::from(viewport[1]);
        scene.viewport.width = f64::from(viewport[2]);
        scene.viewport.height = f64::from(viewport[3]);
        (scene.viewport.near, scene.viewport.far) = range;
        let f = compare(&scene, EDGES);
        f.print(&format!("viewport {viewport:?}"));
        // Two surfaces may meet within a step of depth.
        assert!(f.share() < 2e-3 && f.drawn > 300, "{f:?}");
    }
}
