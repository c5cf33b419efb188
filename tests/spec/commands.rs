//! The way through the table of commands: the first error sticks and is told in words with its place, a trace shows every
//! call, and C's names work on the context of the thread.

use fixedgl::Call;
use fixedgl::Context;
use fixedgl::enums::*;
use std::sync::{Arc, Mutex};

#[test]
fn the_first_error_sticks_and_reading_clears_it() {
    let mut cx = Context::new(4, 4);
    cx.enable(0x1234);
    cx.viewport(0, 0, -1, 4);
    cx.matrix_mode(GL_LINES);
    let line = line!() - 3;
    let error = cx.check().expect_err("three errors");
    assert_eq!((error.code, error.command, error.line), (GL_INVALID_ENUM, "glEnable", line));
    assert!(error.file.ends_with("commands.rs"));
    assert!(!error.message.is_empty());
    assert_eq!(cx.check(), Ok(()));
    cx.viewport(0, 0, -1, 4);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn the_debug_callback_hears_every_error_with_its_place() {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let mut cx = Context::new(4, 4);
    let sink = Arc::clone(&heard);
    cx.set_debug_callback(Some(Box::new(move |m| {
        sink.lock().unwrap().push((m.source, m.type_, m.id, m.severity, m.command, m.line, m.message.to_string()));
    })));
    cx.enable(0x1234);
    cx.load_matrixf(&[1.0; 15]);
    let line = line!() - 1;
    let heard = heard.lock().unwrap();
    assert_eq!(heard.len(), 2);
    let (source, type_, id, severity, command, at, message) = &heard[1];
    assert_eq!(
        (*source, *type_, *id, *severity),
        (GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_ERROR, GL_INVALID_VALUE, GL_DEBUG_SEVERITY_HIGH)
    );
    assert_eq!((*command, *at), ("glLoadMatrixf", line));
    assert!(message.contains("16 values") && message.contains("15"), "{message}");
}

#[test]
fn a_trace_shows_the_calls_in_order_with_enumerants_by_name() {
    let calls: Arc<Mutex<Vec<Call>>> = Arc::default();
    let mut cx = Context::new(4, 4);
    let sink = Arc::clone(&calls);
    cx.set_trace_callback(Some(Box::new(move |call| sink.lock().unwrap().push(call.clone()))));
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    cx.new_list(1, GL_COMPILE);
    cx.color3ub(1, 2, 3);
    cx.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 1.0, 0.0, 0.0]);
    cx.end_list();
    cx.set_trace_callback(None);
    cx.call_list(1);
    let calls: Vec<String> = calls.lock().unwrap().iter().map(ToString::to_string).collect();
    assert_eq!(
        calls,
        [
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT)",
            "glNewList(1, GL_COMPILE)",
            "glColor3ub(1, 2, 3)",
            "glLightfv(GL_LIGHT0, GL_POSITION, [0.0, 1.0, 0.0, 0.0])",
            "glEndList()",
        ]
    );
}

#[test]
fn the_c_names_work_on_the_current_context_of_the_thread() {
    use fixedgl::c::*;
    assert!(take_current().is_none());
    glEnable(GL_BLEND);
    assert_eq!(glGetError(), GL_NO_ERROR);
    assert_eq!(calls_without_context(), 2);
    assert!(make_current(Context::new(4, 4)).is_none());
    glEnable(GL_BLEND);
    assert_eq!(glIsEnabled(GL_BLEND), GL_TRUE);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    let mut names = [0; 2];
    glGenTextures(2, &mut names);
    assert!(name != 0 && names[0] != 0 && names[1] != names[0]);
    let px = vec![[[255_u8, 0, 0]; 2]; 2];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, &px);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glLightfv(GL_LIGHT0, GL_POSITION, &[1.0, 1.0, 1.0, 0.0]);
    glDepthMask(GL_FALSE);
    let m = [[1.0_f32, 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    glLoadMatrixf(&m);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let short = [0_u8; 3];
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, &short);
    let error = with_current(Context::check).expect("a context").expect_err("three bytes are too few");
    assert!(error.message.contains("12") && error.message.contains('3'), "{}", error.message);
    assert!(glGetString(GL_VERSION).starts_with("1.5"));
    // A context moves to another thread, and back.
    let cx = take_current().expect("the context");
    let cx = std::thread::spawn(move || {
        make_current(cx);
        glDisable(GL_BLEND);
        take_current().expect("the context")
    });
    make_current(cx.join().expect("the thread"));
    assert_eq!(glIsEnabled(GL_BLEND), GL_FALSE);
}

#[test]
fn a_context_is_send_and_sizes_come_in_any_integer() {
    fn send<T: Send>(_: &T) {}
    let mut cx = Context::new(4, 4);
    send(&cx);
    let data = [1.0_f32, 2.0, 3.0];
    cx.bind_buffer(GL_ARRAY_BUFFER, 1);
    cx.buffer_data(GL_ARRAY_BUFFER, size_of_val(&data), &data, GL_STATIC_DRAW);
    let mut back = [0.0_f32; 2];
    cx.get_buffer_sub_data(GL_ARRAY_BUFFER, 4, 8, &mut back);
    assert_eq!(back, [2.0, 3.0]);
    assert_eq!(cx.check(), Ok(()));
    cx.buffer_data(GL_ARRAY_BUFFER, u64::MAX, &data, GL_STATIC_DRAW);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
}
