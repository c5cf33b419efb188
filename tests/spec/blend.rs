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
                equation: [equation; 2],
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
fn separate_equations_blend_as_the_oracle_does() {
    const EQUATIONS: [GLenum; 5] = [GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX];
    let mut random = Random(71);
    let mut all = Figures::default();
    for rgb in EQUATIONS {
        for alpha in EQUATIONS {
            let blend = Blend {
                equation: [rgb, alpha],
                source: [random.pick(&FACTORS), random.pick(&FACTORS)],
                destination: [random.pick(&FACTORS), random.pick(&FACTORS)],
                constant: std::array::from_fn(|_| random.range(0.0, 1.0)),
            };
            let f = blended(blend, u64::from(rgb + alpha));
            assert_eq!(f.off, 0, "{blend:?}: {f:?}");
            all.merge(&f);
        }
    }
    all.within_one_lsb("25 pairs of blend equations");
    let mut cx = Context::new(4, 4);
    cx.blend_equation_separate(GL_MIN, GL_FUNC_SUBTRACT);
    let equations =
        |cx: &mut Context| [GL_BLEND_EQUATION_RGB_EXT, GL_BLEND_EQUATION_ALPHA_EXT].map(|p| get_i(cx, p) as u32);
    assert_eq!(equations(&mut cx), [GL_MIN, GL_FUNC_SUBTRACT]);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.blend_equation_separate(GL_FUNC_ADD, GL_ADD));
    assert_eq!(equations(&mut cx), [GL_MIN, GL_FUNC_SUBTRACT]);
    cx.blend_equation(GL_MAX);
    assert_eq!(equations(&mut cx), [GL_MAX; 2]);
}

/// The stencil operations on 8 bits with the reference value 5 (section 4.1.5).
fn operated(op: GLenum, s: u8) -> u8 {
    match op {
        GL_KEEP => s,
        GL_ZERO => 0,
        GL_REPLACE => 5,
        GL_INCR => s.saturating_add(1),
        GL_DECR => s.saturating_sub(1),
        GL_INVERT => !s,
        GL_INCR_WRAP => s.wrapping_add(1),
        GL_DECR_WRAP => s.wrapping_sub(1),
        other => panic!("no stencil operation {other:#x}"),
    }
}

#[test]
fn front_and_back_faces_have_stencil_tests_of_their_own() {
    const OPERATIONS: [GLenum; 8] =
        [GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP];
    let mut random = Random(5);
    let pick = |random: &mut Random, all: &[GLenum]| random.pick(all);
    for case in 0..300 {
        let before = random.pick(&[0_u8, 4, 5, 6, 255]);
        let funcs: [GLenum; 2] = std::array::from_fn(|_| pick(&mut random, &COMPARISONS));
        let ops: [[GLenum; 3]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| pick(&mut random, &OPERATIONS)));
        let depth_passes = random.below(2) == 0;
        let clockwise_is_front = random.below(3) == 0;
        let mut cx = Context::new(24, 8);
        cx.clear_stencil(i32::from(before));
        cx.clear(GL_STENCIL_BUFFER_BIT);
        cx.front_face(if clockwise_is_front { GL_CW } else { GL_CCW });
        cx.enable(GL_STENCIL_TEST);
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(if depth_passes { GL_ALWAYS } else { GL_NEVER });
        cx.stencil_func_separate(funcs[0], funcs[1], 5, 0xFF);
        for (face, [fail, depth_fail, pass]) in [GL_FRONT, GL_BACK].into_iter().zip(ops) {
            cx.stencil_op_separate(face, fail, depth_fail, pass);
        }
        // Left: counter-clockwise; middle: clockwise; right: a line and points, which are front faces. Large and small
        // triangles are set up in different ways, and so are batches of them.
        cx.matrix_mode(GL_PROJECTION);
        cx.ortho(0.0, 24.0, 0.0, 8.0, -1.0, 1.0);
        let quad = |cx: &mut Context, x: f32, size: f32, clockwise: bool| {
            let mut corners = [[x, 0.0], [x + size, 0.0], [x + size, size], [x, size]];
            if clockwise {
                corners.reverse();
            }
            corners.iter().for_each(|corner| cx.vertex2fv(corner));
        };
        let (size, step) = if case % 2 == 0 { (8.0, 8.0) } else { (2.0, 8.0) };
        cx.begin(GL_QUADS);
        quad(&mut cx, 0.0, size, false);
        quad(&mut cx, step, size, true);
        cx.end();
        cx.begin(GL_LINES);
        cx.vertex2f(16.0, 0.5);
        cx.vertex2f(24.0, 0.5);
        cx.end();
        // Polygon mode POINT: the points of a polygon are of its face.
        cx.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
        cx.begin(GL_TRIANGLES);
        [[20.5, 7.5], [18.5, 5.5], [22.5, 5.5]].iter().rev().for_each(|p: &[f32; 2]| cx.vertex2fv(p));
        cx.end();
        no_error(&mut cx);
        let expected = |face: usize| {
            let passes = crate::oracle::fragment::passes(funcs[face], 5.0, f64::from(before));
            let [fail, depth_fail, pass] = ops[face];
            operated(
                if !passes {
                    fail
                } else if depth_passes {
                    pass
                } else {
                    depth_fail
                },
                before,
            )
        };
        let (ccw, cw) = if clockwise_is_front { (1, 0) } else { (0, 1) };
        let stencils = cx.stencils();
        let at = |x: usize, y: usize| stencils[y * 24 + x];
        let what = format!("case {case}: {funcs:x?} {ops:x?} {before} depth {depth_passes} cw {clockwise_is_front}");
        assert_eq!([at(0, 0), at(1, 1)], [expected(ccw); 2], "counter-clockwise, {what}");
        assert_eq!([at(8, 0), at(9, 1)], [expected(cw); 2], "clockwise, {what}");
        assert_eq!(at(18, 0), expected(0), "line, {what}");
        assert_eq!(at(20, 7), expected(cw), "a point of a clockwise polygon, {what}");
        assert_eq!(at(7, 7), if size > 7.0 { expected(ccw) } else { before }, "{what}");
    }
}

#[test]
fn separate_stencil_state_can_be_asked_for_and_is_set_by_both_commands() {
    let mut cx = Context::new(4, 4);
    let ask = |cx: &mut Context| {
        [
            GL_STENCIL_FUNC,
            GL_STENCIL_FAIL,
            GL_STENCIL_PASS_DEPTH_FAIL,
            GL_STENCIL_PASS_DEPTH_PASS,
            GL_STENCIL_BACK_FUNC_ATI,
            GL_STENCIL_BACK_FAIL_ATI,
            GL_STENCIL_BACK_PASS_DEPTH_FAIL_ATI,
            GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI,
        ]
        .map(|pname| get_i(cx, pname) as u32)
    };
    assert_eq!(ask(&mut cx), [GL_ALWAYS, GL_KEEP, GL_KEEP, GL_KEEP, GL_ALWAYS, GL_KEEP, GL_KEEP, GL_KEEP]);
    cx.stencil_func_separate(GL_LESS, GL_GREATER, 3, 7);
    cx.stencil_op_separate(GL_BACK, GL_INCR, GL_DECR, GL_INVERT);
    let set = [GL_LESS, GL_KEEP, GL_KEEP, GL_KEEP, GL_GREATER, GL_INCR, GL_DECR, GL_INVERT];
    assert_eq!(ask(&mut cx), set);
    assert_eq!([get_i(&mut cx, GL_STENCIL_REF), get_i(&mut cx, GL_STENCIL_VALUE_MASK)], [3, 7]);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.stencil_func_separate(GL_LESS, GL_ADD, 0, 0));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.stencil_op_separate(GL_LEFT, GL_ZERO, GL_ZERO, GL_ZERO));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.stencil_op_separate(GL_FRONT, GL_ZERO, GL_ZERO, GL_ADD));
    assert_eq!(ask(&mut cx), set);
    cx.stencil_func(GL_EQUAL, 1, 1);
    cx.stencil_op(GL_ZERO, GL_KEEP, GL_REPLACE);
    let one = [GL_EQUAL, GL_ZERO, GL_KEEP, GL_REPLACE];
    assert_eq!(ask(&mut cx), [one, one].concat()[..]);
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
