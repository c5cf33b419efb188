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
    for cap in (0..0x9000u32).chain([0xFFFF_FFFF, 0x8000_0000]) {
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

/// A scalar form with the name of a parameter that is a vector.
type Scalar = (&'static str, fn(&mut Context));

const SCALARS: &[Scalar] = &[
    ("TexParameterf", |cx| cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 0.5)),
    ("TexParameteri", |cx| cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1)),
    ("TexEnvf", |cx| cx.tex_envf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 0.5)),
    ("TexEnvi", |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1)),
    ("TexGenf object", |cx| cx.tex_genf(GL_S, GL_OBJECT_PLANE, 0.5)),
    ("TexGeni eye", |cx| cx.tex_geni(GL_T, GL_EYE_PLANE, 1)),
    ("TexGend eye", |cx| cx.tex_gend(GL_S, GL_EYE_PLANE, 0.5)),
    ("Materialf ambient", |cx| cx.materialf(GL_FRONT, GL_AMBIENT, 0.5)),
    ("Materialf diffuse", |cx| cx.materialf(GL_FRONT, GL_DIFFUSE, 0.5)),
    ("Materiali specular", |cx| cx.materiali(GL_FRONT, GL_SPECULAR, 1)),
    ("Materialf emission", |cx| cx.materialf(GL_FRONT, GL_EMISSION, 0.5)),
    ("Materialf two", |cx| cx.materialf(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, 0.5)),
    ("Materialf indexes", |cx| cx.materialf(GL_FRONT, GL_COLOR_INDEXES, 0.5)),
    ("LightModelf", |cx| cx.light_modelf(GL_LIGHT_MODEL_AMBIENT, 0.5)),
    ("LightModeli", |cx| cx.light_modeli(GL_LIGHT_MODEL_AMBIENT, 1)),
    ("Lightf ambient", |cx| cx.lightf(GL_LIGHT0, GL_AMBIENT, 0.5)),
    ("Lighti diffuse", |cx| cx.lighti(GL_LIGHT0, GL_DIFFUSE, 1)),
    ("Lightf specular", |cx| cx.lightf(GL_LIGHT0, GL_SPECULAR, 0.5)),
    ("Lightf position", |cx| cx.lightf(GL_LIGHT0, GL_POSITION, 0.5)),
    ("Lightf direction", |cx| cx.lightf(GL_LIGHT0, GL_SPOT_DIRECTION, 0.5)),
    ("Fogf", |cx| cx.fogf(GL_FOG_COLOR, 0.5)),
    ("Fogi", |cx| cx.fogi(GL_FOG_COLOR, 1)),
    ("PointParameterf", |cx| cx.point_parameterf(GL_POINT_DISTANCE_ATTENUATION, 0.5)),
    ("ConvolutionParameterf border", |cx| {
        cx.convolution_parameterf(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, 0.5);
    }),
    ("ConvolutionParameteri scale", |cx| {
        cx.convolution_parameteri(GL_CONVOLUTION_1D, GL_CONVOLUTION_FILTER_SCALE, 1);
    }),
    ("PointParameteri", |cx| cx.point_parameteri(GL_POINT_DISTANCE_ATTENUATION, 1)),
];

/// What the commands of [`SCALARS`] could have changed.
fn vectors(cx: &mut Context) -> Vec<[f32; 4]> {
    let mut all = Vec::new();
    let mut ask = |question: &mut dyn FnMut(&mut [f32; 4])| {
        let mut v = [-7.0; 4];
        question(&mut v);
        all.push(v);
    };
    ask(&mut |v| cx.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, v));
    ask(&mut |v| cx.get_tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v));
    ask(&mut |v| cx.get_floatv(GL_LIGHT_MODEL_AMBIENT, v));
    ask(&mut |v| cx.get_floatv(GL_FOG_COLOR, v));
    ask(&mut |v| cx.get_floatv(GL_POINT_DISTANCE_ATTENUATION, v));
    for (coord, pname) in [(GL_S, GL_OBJECT_PLANE), (GL_S, GL_EYE_PLANE), (GL_T, GL_EYE_PLANE)] {
        ask(&mut |v| cx.get_tex_genfv(coord, pname, v));
    }
    for pname in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_COLOR_INDEXES] {
        ask(&mut |v| cx.get_materialfv(GL_FRONT, pname, v));
    }
    for pname in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION] {
        ask(&mut |v| cx.get_lightfv(GL_LIGHT0, pname, v));
    }
    no_error(cx);
    all
}

#[test]
fn a_scalar_form_does_not_take_the_name_of_a_vector() {
    for (name, command) in SCALARS {
        let mut cx = Context::new(4, 4);
        let before = vectors(&mut cx);
        raises(&mut cx, GL_INVALID_ENUM, command);
        cx.new_list(1, GL_COMPILE);
        command(&mut cx);
        cx.end_list();
        no_error(&mut cx);
        raises(&mut cx, GL_INVALID_ENUM, |cx| cx.call_list(1));
        cx.new_list(1, GL_COMPILE_AND_EXECUTE);
        raises(&mut cx, GL_INVALID_ENUM, command);
        cx.end_list();
        assert_eq!(vectors(&mut cx), before, "{name}");
    }
}
