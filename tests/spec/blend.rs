//! Per-fragment operations (OpenGL 1.5, section 4.1): every pair of blend factors, every equation, the alpha test, the
//! depth test, logic operations, masks and scissor.

use crate::oracle::fragment::{Blend, logic_op};
use crate::oracle::vertex::Vertex;
use crate::support::compare::{EDGES, Figures, compare};
use crate::support::scenes::heap;
use crate::support::{Random, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;

const FACTORS: [GLenum; 14] = [
    GL_ZERO,
    GL_ONE,
    GL_SRC_COLOR,
    GL_ONE_MINUS_SRC_COLOR,
    GL_DST_COLOR,
    GL_ONE_MINUS_DST_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_ALPHA,
    GL_ONE_MINUS_DST_ALPHA,
    GL_CONSTANT_COLOR,
    GL_ONE_MINUS_CONSTANT_COLOR,
    GL_CONSTANT_ALPHA,
    GL_ONE_MINUS_CONSTANT_ALPHA,
];
const COMPARISONS: [GLenum; 8] =
    [GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS];

/// Rows of random pixels, source over destination: one triangle covers the window, so every pixel is blended once.
fn blended(blend: Blend, seed: u64) -> Figures {
    let mut scene = heap(24, 24, 3, 1.0, seed);
    scene.triangles.truncate(0);
    scene.clear = crate::support::images::bytes([204, 77, 140, 102]);
    scene.vertex.projection = crate::oracle::matrix::M4::IDENTITY;
    let mut random = Random(seed);
    let mut v = |x, y| Vertex::at(x, y, 0.0).colored(std::array::from_fn(|_| random.range(0.0, 1.0)));
    scene.quad([v(-1.0, -1.0), v(1.0, -1.0), v(1.0, 1.0), v(-1.0, 1.0)]);
    scene.blend = Some(blend);
    compare(&scene, EDGES)
}

#[test]
fn the_initial_state_is_the_tables_and_errors_are_told() {
    let mut cx = Context::new(4, 4);
    for (pname, want) in [
        (GL_BLEND, 0),
        (GL_BLEND_SRC_RGB, GL_ONE),
        (GL_BLEND_DST_ALPHA, GL_ZERO),
        (GL_BLEND_EQUATION, GL_FUNC_ADD),
        (GL_ALPHA_TEST_FUNC, GL_ALWAYS),
        (GL_DEPTH_FUNC, GL_LESS),
        (GL_DEPTH_WRITEMASK, 1),
        (GL_LOGIC_OP_MODE, GL_COPY),
        (GL_SCISSOR_TEST, 0),
        (GL_DITHER, 1),
    ] {
        assert_eq!(get_i(&mut cx, pname) as u32, want, "{}", fixedgl::enums::name(pname));
    }
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.blend_func(GL_SRC_ALPHA, GL_SRC_ALPHA_SATURATE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.blend_func(GL_LESS, GL_ONE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.blend_equation(GL_ADD));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.alpha_func(GL_ONE, 0.5));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.depth_func(GL_ADD));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.logic_op(GL_ADD));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.scissor(0, 0, -1, 4));
}

#[test]
fn every_pair_of_factors_blends_as_the_oracle_does() {
    let mut all = Figures::default();
    for source in FACTORS.into_iter().chain([GL_SRC_ALPHA_SATURATE]) {
        for destination in FACTORS {
            let constant = [0.25, 0.6, 0.9, 0.45];
            let f =
                blended(Blend { constant, ..Blend::func(source, destination) }, u64::from(source * 31 + destination));
            assert_eq!(f.off, 0, "{source:#x} {destination:#x}: {f:?}");
            all.merge(&f);
        }
    }
    all.within_one_lsb("210 pairs of blend factors");
}

#[test]
fn every_equation_and_separate_function_blends_as_the_oracle_does() {
    let mut random = Random(12);
    for equation in [GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX] {
        let mut all = Figures::default();
        for seed in 0..10 {
            let blend = Blend {
                equation,
                source: [random.pick(&FACTORS), random.pick(&FACTORS)],
                destination: [random.pick(&FACTORS), random.pick(&FACTORS)],
                constant: std::array::from_fn(|_| random.range(0.0, 1.0)),
            };
            let f = blended(blend, seed + 1);
            assert_eq!(f.off, 0, "{blend:?}: {f:?}");
            all.merge(&f);
        }
        all.within_one_lsb(&format!("blend equation {}", fixedgl::enums::name(equation)));
    }
}

#[test]
fn alpha_and_depth_tests_drop_fragments() {
    for func in COMPARISONS {
        let mut scene = heap(96, 96, 14, 1.0, 4);
        scene.alpha = Some((func, 0.5));
        let f = compare(&scene, EDGES);
        f.print(&format!("alpha {}", fixedgl::enums::name(func)));
        // Alpha is rounded before it is compared, so a pixel next to a half may fall to the other side.
        assert!(f.share() < 2e-3, "{func:#x}: {f:?}");
        let mut scene = heap(96, 96, 14, 1.0, 4);
        scene.depth = Some((func, true));
        let f = compare(&scene, EDGES);
        f.print(&format!("depth {}", fixedgl::enums::name(func)));
        assert!(f.share() < 2e-3, "{func:#x}: {f:?}");
    }
}

/// One pixel-sized quad of a colour given in bytes.
fn fill(cx: &mut Context, c: [u8; 4]) {
    cx.color4ubv(&c);
    cx.rectf(-1.0, -1.0, 1.0, 1.0);
}

#[test]
fn logic_operations_work_bit_by_bit() {
    let operations = GL_CLEAR..=GL_SET;
    let (s, d) = ([0b1100_1010, 0x0F, 0xAA, 0x77], [0b1010_0110, 0x3C, 0x55, 0xE1]);
    for op in operations {
        let mut cx = Context::new(2, 2);
        fill(&mut cx, d);
        cx.enable(GL_COLOR_LOGIC_OP);
        cx.logic_op(op);
        fill(&mut cx, s);
        no_error(&mut cx);
        let want: [u8; 4] = std::array::from_fn(|k| logic_op(op, s[k], d[k]));
        assert_eq!(pixels(&mut cx, 2, 2), vec![want; 4], "{op:#x}");
    }
}

#[test]
fn masks_and_the_scissor_box_keep_what_was_there() {
    let mut cx = Context::new(4, 4);
    fill(&mut cx, [10, 20, 30, 40]);
    cx.color_mask(true, false, true, false);
    fill(&mut cx, [200, 201, 202, 203]);
    assert_eq!(pixels(&mut cx, 4, 4), vec![[200, 20, 202, 40]; 16]);
    cx.color_mask(true, true, true, true);
    cx.enable(GL_SCISSOR_TEST);
    cx.scissor(1, 2, 2, 1);
    fill(&mut cx, [1, 2, 3, 4]);
    let got = pixels(&mut cx, 4, 4);
    for (i, p) in got.iter().enumerate() {
        let inside = i == 9 || i == 10;
        assert_eq!(*p, if inside { [1, 2, 3, 4] } else { [200, 20, 202, 40] }, "pixel {i}");
    }
    cx.clear_color(0.0, 0.0, 0.0, 0.0);
    cx.clear(GL_COLOR_BUFFER_BIT);
    assert_eq!(pixels(&mut cx, 4, 4).iter().filter(|p| **p == [0; 4]).count(), 2);
}
