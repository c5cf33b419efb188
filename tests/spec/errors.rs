//! Errors (OpenGL 1.5, section 2.5 and 2.6.3): the first error stays until it is read, a wrong command changes nothing,
//! what is not allowed between Begin and End is refused there, and the callback gets a sentence and a place.

use crate::support::{get_f, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;
use std::sync::{Arc, Mutex};

#[test]
fn the_first_error_stays() {
    let mut cx = Context::new(4, 4);
    no_error(&mut cx);
    cx.enable(GL_RGBA);
    cx.viewport(0, 0, -1, 0);
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    cx.pop_matrix();
    let error = cx.check().expect_err("the stack is empty");
    assert!(error.to_string().contains("PopMatrix"), "{error}");
    assert!(cx.check().is_ok());
}

#[test]
fn between_begin_and_end() {
    let refused: &[fn(&mut Context)] = &[
        |cx| cx.begin(GL_POINTS),
        |cx| cx.enable(GL_LIGHTING),
        |cx| cx.matrix_mode(GL_TEXTURE),
        |cx| cx.load_identity(),
        |cx| cx.translatef(1.0, 1.0, 1.0),
        |cx| cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP),
        |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL),
        |cx| cx.bind_texture(GL_TEXTURE_2D, 3),
        |cx| cx.clear(GL_COLOR_BUFFER_BIT),
        |cx| cx.flush(),
        |cx| cx.viewport(0, 0, 1, 1),
        |cx| cx.blend_func(GL_ONE, GL_ONE),
        |cx| cx.push_attrib(GL_FOG_BIT),
        |cx| cx.rectf(0.0, 0.0, 1.0, 1.0),
        |cx| cx.draw_arrays(GL_POINTS, 0, 1),
        |cx| cx.shade_model(GL_FLAT),
        |cx| cx.new_list(1, GL_COMPILE),
        |cx| _ = cx.gen_lists(1),
        |cx| _ = cx.is_texture(1),
        |cx| cx.get_integerv(GL_MATRIX_MODE, &mut [0; 16]),
        |cx| cx.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut [0u8; 4]),
    ];
    for (i, command) in refused.iter().enumerate() {
        let mut cx = Context::new(4, 4);
        cx.begin(GL_TRIANGLES);
        command(&mut cx);
        cx.end();
        assert_eq!(cx.get_error(), GL_INVALID_OPERATION, "command {i}");
        assert_eq!(get_i(&mut cx, GL_MATRIX_MODE) as u32, GL_MODELVIEW);
        assert_eq!(get_i(&mut cx, GL_LIGHTING), 0);
        assert_eq!(get_i(&mut cx, GL_SHADE_MODEL) as u32, GL_SMOOTH);
    }
    let mut cx = Context::new(4, 4);
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.end());
    cx.begin(GL_TRIANGLES);
    cx.color3f(0.5, 0.5, 0.5);
    cx.materialf(GL_FRONT, GL_SHININESS, 3.0);
    cx.tex_coord2f(0.0, 0.0);
    cx.normal3f(1.0, 0.0, 0.0);
    cx.edge_flag(false);
    cx.call_list(77);
    cx.end();
    no_error(&mut cx);
    assert_eq!(get_f::<3>(&mut cx, GL_CURRENT_COLOR), [0.5; 3]);
}

#[test]
fn every_enumerant_that_enable_does_not_know() {
    let mut cx = Context::new(4, 4);
    let mut taken = 0;
    for cap in (0..0x9000).chain([0xFFFF_FFFF, 0x8000_0000]) {
        cx.enable(cap);
        match cx.get_error() {
            0 => taken += 1,
            code => assert_eq!(code, GL_INVALID_ENUM, "{cap:#x}"),
        }
        cx.disable(cap);
        let _ = cx.get_error();
    }
    assert!((50..200).contains(&taken), "{taken}");
}

#[test]
fn the_callback_hears_of_it() {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let ear = heard.clone();
    let mut cx = Context::new(4, 4);
    cx.set_debug_callback(Some(Box::new(move |m| ear.lock().unwrap().push(format!("{m:?}")))));
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR);
    let heard = heard.lock().unwrap().clone();
    assert_eq!(heard.len(), 1, "{heard:?}");
    assert!(heard[0].contains("errors.rs"), "the caller's place: {heard:?}");
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
}

#[test]
fn absurd_input_never_ends_the_program() {
    let mut cx = Context::new(4, 4);
    let nan = f32::NAN;
    cx.rotatef(nan, nan, 0.0, f32::INFINITY);
    cx.scalef(0.0, f32::MAX, nan);
    cx.lightfv(GL_LIGHT0, GL_POSITION, &[nan; 4]);
    cx.enable(GL_LIGHTING);
    cx.enable(GL_LIGHT0);
    cx.enable(GL_FOG);
    cx.fogf(GL_FOG_END, nan);
    cx.clear_color(nan, f32::INFINITY, -1.0, 2.0);
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.depth_range(f64::NAN, f64::INFINITY);
    cx.viewport(i32::MIN, i32::MAX, i32::MAX, i32::MAX);
    cx.line_width(nan);
    cx.point_size(f32::INFINITY);
    for mode in GL_POINTS..=GL_POLYGON {
        cx.begin(mode);
        for k in 0..7 {
            cx.color4f(nan, 1e38, -1e38, 0.5);
            cx.normal3f(0.0, 0.0, 0.0);
            cx.tex_coord4f(nan, 1e38, -1e38, 0.0);
            cx.vertex4f(if k == 3 { nan } else { 1e38 }, -1e38, 1e-45, k as f32 - 3.0);
        }
        cx.end();
    }
    while cx.get_error() != 0 {}
    cx.viewport(0, 0, 4, 4);
    assert_eq!(pixels(&mut cx, 4, 4).len(), 16);
}
