//! What the library says: advice about calls that are no errors and yet do not do what was meant, names in messages and
//! in traces, and the error of a framebuffer that cannot be.

use fixedgl::enums::*;
use fixedgl::{Call, Config, Context, glu};
use std::sync::{Arc, Mutex};

/// What the debug callback hears of some calls: the command and the sentence.
fn heard(calls: impl FnOnce(&mut Context)) -> Vec<(&'static str, String)> {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let mut cx = Context::new(8, 8);
    let sink = Arc::clone(&heard);
    cx.set_debug_callback(Some(Box::new(move |m| sink.lock().unwrap().push((m.command, m.message.to_string())))));
    calls(&mut cx);
    drop(cx);
    Arc::into_inner(heard).unwrap().into_inner().unwrap()
}

/// A trace of some calls.
fn traced(calls: impl FnOnce(&mut Context)) -> Vec<String> {
    let trace: Arc<Mutex<Vec<Call>>> = Arc::default();
    let mut cx = Context::new(8, 8);
    let sink = Arc::clone(&trace);
    cx.set_trace_callback(Some(Box::new(move |call| sink.lock().unwrap().push(call.clone()))));
    calls(&mut cx);
    let calls = trace.lock().unwrap();
    calls.iter().filter(|call| call.name != "plan").map(ToString::to_string).collect()
}

type Row = (&'static str, &'static str, fn(&mut Context));

#[test]
fn calls_that_are_no_errors_and_draw_nothing_right_get_a_sentence() {
    let triangle = [-1_f32, -1.0, 1.0, -1.0, 1.0, 1.0];
    let rows: &[Row] = &[
        ("glDrawElements", "element 7", |cx| {
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(2, GL_FLOAT, 0, &[-1_f32, -1.0, 1.0, -1.0, 1.0, 1.0]);
            cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, &[0_u16, 1, 7]);
        }),
        ("glDrawArrays", "the vertex array has only 3", |cx| {
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(2, GL_FLOAT, 0, &[-1_f32, -1.0, 1.0, -1.0, 1.0, 1.0]);
            cx.draw_arrays(GL_TRIANGLES, 0, 6);
        }),
        ("glDrawArrays", "glEnableClientState(GL_VERTEX_ARRAY)", |cx| cx.draw_arrays(GL_TRIANGLES, 0, 3)),
        ("glDrawElements", "glEnableClientState(GL_VERTEX_ARRAY)", |cx| {
            cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &[0_u8, 1, 2]);
        }),
        ("gluPerspective", "near is 0", |cx| glu::perspective(cx, 60.0, 1.0, 0.0, 10.0)),
        ("gluPerspective", "near is 1 and far is -1", |cx| glu::perspective(cx, 60.0, 1.0, 1.0, -1.0)),
        ("gluPerspective", "nothing is done", |cx| glu::perspective(cx, 60.0, 1.0, 5.0, 5.0)),
        ("gluPickMatrix", "nothing is done", |cx| glu::pick_matrix(cx, 1.0, 1.0, 0.0, 5.0, &[0, 0, 8, 8])),
        ("glRectf", "GL_TEXTURE_2D texture 0", |cx| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[255_u8; 16]);
            cx.enable(GL_TEXTURE_2D);
            cx.rectf(-1.0, -1.0, 1.0, 1.0);
        }),
    ];
    for (command, words, calls) in rows {
        let heard = heard(calls);
        let found = heard.iter().any(|(by, sentence)| by == command && sentence.contains(words));
        assert!(found && heard.len() <= 2, "{command}, {words}: {heard:?}");
    }
    // The same within its bounds says nothing.
    let quiet = heard(|cx| {
        cx.enable_client_state(GL_VERTEX_ARRAY);
        cx.vertex_pointer(2, GL_FLOAT, 0, &triangle);
        cx.draw_arrays(GL_TRIANGLES, 0, 3);
        cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, &[0_u16, 1, 2]);
        glu::perspective(cx, 60.0, 1.0, 0.1, 10.0);
    });
    assert!(quiet.is_empty(), "{quiet:?}");
}

#[test]
fn the_same_advice_is_given_once() {
    let heard = heard(|cx| {
        for texture in [1, 2] {
            cx.bind_texture(GL_TEXTURE_2D, texture);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[255_u8; 16]);
        }
        cx.enable(GL_TEXTURE_2D);
        for i in 0..30 {
            cx.bind_texture(GL_TEXTURE_2D, 1 + i % 2);
            cx.rectf(-1.0, -1.0, 1.0, 1.0);
        }
    });
    assert_eq!(heard.len(), 2, "one sentence for each texture: {heard:?}");
}

#[test]
fn messages_name_enumerants_and_commands_as_gl_does() {
    let rows: &[Row] = &[
        // 0x8000 is a bit of a mask, GL_HINT_BIT, and a pixel format, which is meant here.
        ("glTexImage2D", "GL_ABGR_EXT", |cx| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_ABGR_EXT as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
        }),
        ("glBindTexture", "a texture of GL_TEXTURE_1D and cannot be bound to GL_TEXTURE_2D", |cx| {
            cx.bind_texture(GL_TEXTURE_1D, 3);
            cx.bind_texture(GL_TEXTURE_2D, 3);
        }),
        // 0x0800 is GL_VIEWPORT_BIT and GL_EXP.
        ("glHint", "GL_EXP is not", |cx| cx.hint(GL_FOG_HINT, GL_EXP)),
    ];
    for (command, words, calls) in rows {
        let heard = heard(calls);
        let [(by, sentence)] = &heard[..] else { panic!("{command}: {heard:?}") };
        assert!(by == command && sentence.contains(words), "{command}, {words}: {heard:?}");
        assert!(!sentence.contains("_BIT"), "{sentence}");
    }
}

#[test]
fn a_trace_writes_enumerants_given_as_numbers_and_masks_by_name() {
    let calls = traced(|cx| {
        cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 2.0);
        cx.tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, &[GL_NONE as i32]);
        cx.tex_envf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL as f32);
        cx.tex_envi(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, 3, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0_u8; 4]);
        cx.fogi(GL_FOG_MODE, GL_LINEAR);
        cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        cx.clear(0);
        cx.push_attrib(GL_ALL_ATTRIB_BITS);
        cx.push_attrib(GL_CURRENT_BIT | 0x4000_0000);
        cx.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT | GL_CLIENT_PIXEL_STORE_BIT);
        cx.blend_func(GL_ZERO, GL_ONE);
        cx.stencil_op(GL_ZERO, GL_KEEP, GL_INCR);
        cx.stencil_mask(1);
        cx.draw_buffer(GL_NONE);
        cx.begin(GL_TRIANGLE_FAN);
        cx.end();
        cx.draw_arrays(GL_POINTS, 0, 1);
    });
    assert_eq!(
        calls,
        [
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)",
            "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 2.0)",
            "glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, [GL_NONE])",
            "glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL)",
            "glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 2)",
            "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[4 bytes])",
            "glTexImage2D(GL_TEXTURE_2D, 0, 3, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[4 bytes])",
            "glFogi(GL_FOG_MODE, GL_LINEAR)",
            "glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT)",
            "glClear(0x0)",
            "glPushAttrib(GL_ALL_ATTRIB_BITS)",
            "glPushAttrib(GL_CURRENT_BIT | 0x40000000)",
            "glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT | GL_CLIENT_VERTEX_ARRAY_BIT)",
            "glBlendFunc(GL_ZERO, GL_ONE)",
            "glStencilOp(GL_ZERO, GL_KEEP, GL_INCR)",
            "glStencilMask(1)",
            "glDrawBuffer(GL_NONE)",
            "glBegin(GL_TRIANGLE_FAN)",
            "glEnd()",
            "glDrawArrays(GL_POINTS, 0, 1)",
        ]
    );
}

#[test]
fn a_framebuffer_that_cannot_be_is_an_error_of_its_context() {
    let mut cx = Context::new(100_000, 100_000);
    let line = line!() - 1;
    assert_eq!(cx.size(), (0, 0));
    let error = cx.check().unwrap_err();
    assert_eq!((error.code, error.command, error.line), (GL_OUT_OF_MEMORY, "Context::new", line));
    assert!(error.message.contains("100000x100000") && error.file.ends_with("words.rs"), "{error}");
    assert_eq!(cx.check(), Ok(()));
    let error = Context::try_new(100_000, 1).unwrap_err();
    assert_eq!((error.code, error.line), (GL_OUT_OF_MEMORY, line!() - 1));
    let mut cx = Context::try_with_config(16, 9, Config::default().with_threads(1)).unwrap();
    assert_eq!((cx.size(), cx.check()), ((16, 9), Ok(())));
    // What is drawn into a framebuffer without pixels goes nowhere.
    let mut cx = Context::new(0, 0);
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.rectf(-1.0, -1.0, 1.0, 1.0);
    assert_eq!((cx.pixels(), cx.check()), (Vec::new(), Ok(())));
}
