//! Display lists (OpenGL 1.5, section 5.4): a list does what its commands did, at the time they were given; nesting, bases,
//! names, COMPILE_AND_EXECUTE, what is never recorded, the errors.

use crate::support::{get_f, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn picture(cx: &mut Context) {
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB, 2, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, &[255u8, 0, 0, 0, 255, 0, 0, 0]);
    cx.enable(GL_TEXTURE_2D);
    cx.push_matrix();
    cx.rotatef(30.0, 0.0, 0.0, 1.0);
    cx.begin(GL_TRIANGLES);
    for (i, [x, y]) in [[-0.9f32, -0.9], [0.9, -0.7], [0.1, 0.8]].into_iter().enumerate() {
        cx.color3f(1.0, i as f32 / 2.0, 0.5);
        cx.tex_coord2f(x, y);
        cx.vertex2f(x, y);
    }
    cx.end();
    cx.pop_matrix();
}

#[test]
fn a_list_draws_what_its_commands_draw() {
    let mut direct = Context::new(32, 32);
    picture(&mut direct);
    let want = pixels(&mut direct, 32, 32);
    assert!(want.iter().any(|p| p[0] > 0));
    let mut cx = Context::new(32, 32);
    cx.new_list(7, GL_COMPILE);
    picture(&mut cx);
    cx.end_list();
    no_error(&mut cx);
    assert!(pixels(&mut cx, 32, 32).iter().all(|p| *p == [0; 4]), "COMPILE draws nothing");
    cx.call_list(7);
    assert_eq!(pixels(&mut cx, 32, 32), want);
    let mut cx = Context::new(32, 32);
    cx.new_list(7, GL_COMPILE_AND_EXECUTE);
    picture(&mut cx);
    cx.end_list();
    assert_eq!(pixels(&mut cx, 32, 32), want);
}

#[test]
fn lists_nest_and_names_begin_at_the_base() {
    let mut cx = Context::new(4, 4);
    let base = cx.gen_lists(3);
    assert!(base > 0 && cx.is_list(base) && cx.is_list(base + 2) && !cx.is_list(base + 3));
    cx.new_list(base, GL_COMPILE);
    cx.translatef(1.0, 0.0, 0.0);
    cx.end_list();
    cx.new_list(base + 1, GL_COMPILE);
    cx.call_list(base);
    cx.call_list(base);
    cx.end_list();
    cx.list_base(base);
    cx.call_lists(3, GL_UNSIGNED_BYTE, &[1u8, 0, 1]);
    assert_eq!(get_f::<16>(&mut cx, GL_MODELVIEW_MATRIX)[12], 5.0);
    cx.load_identity();
    // A list that is changed later is called as it is then.
    cx.new_list(base, GL_COMPILE);
    cx.translatef(0.0, 2.0, 0.0);
    cx.end_list();
    cx.call_list(base + 1);
    assert_eq!(get_f::<16>(&mut cx, GL_MODELVIEW_MATRIX)[12..14], [0.0, 4.0]);
    cx.delete_lists(base, 3);
    assert!(!cx.is_list(base));
    cx.call_list(base);
    no_error(&mut cx);
}

#[test]
fn lists_that_call_themselves_end() {
    let mut cx = Context::new(4, 4);
    cx.new_list(1, GL_COMPILE);
    cx.translatef(1.0, 0.0, 0.0);
    cx.call_list(1);
    cx.end_list();
    cx.call_list(1);
    let _ = cx.get_error();
    let depth = get_i(&mut cx, GL_MAX_LIST_NESTING) as f32;
    assert!(depth >= 64.0);
    let x = get_f::<16>(&mut cx, GL_MODELVIEW_MATRIX)[12];
    assert!((1.0..=depth + 1.0).contains(&x), "{x}");
}

#[test]
fn what_is_carried_out_at_once() {
    let mut cx = Context::new(4, 4);
    cx.new_list(1, GL_COMPILE);
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 2);
    cx.enable_client_state(GL_VERTEX_ARRAY);
    let mut name = [0u32];
    cx.gen_textures(1, &mut name);
    assert!(name[0] != 0);
    assert_eq!(get_i(&mut cx, GL_LIST_INDEX), 1);
    assert_eq!(get_i(&mut cx, GL_LIST_MODE) as u32, GL_COMPILE);
    cx.end_list();
    assert_eq!(get_i(&mut cx, GL_UNPACK_ALIGNMENT), 2);
    assert_eq!(get_i(&mut cx, GL_VERTEX_ARRAY), 1);
    assert_eq!(get_i(&mut cx, GL_LIST_INDEX), 0);
}

#[test]
fn images_are_read_when_the_list_is_made() {
    let mut cx = Context::new(4, 4);
    let mut px = vec![200u8; 12];
    cx.new_list(1, GL_COMPILE);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB8, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, &px);
    cx.end_list();
    px.fill(3);
    cx.pixel_storei(GL_UNPACK_SKIP_PIXELS, 1);
    cx.call_list(1);
    let mut got = [0u8; 3];
    cx.get_tex_image(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, &mut got);
    no_error(&mut cx);
    assert_eq!(got, [200; 3]);
}

#[test]
fn errors_happen_when_the_list_is_called() {
    let mut cx = Context::new(4, 4);
    cx.new_list(1, GL_COMPILE);
    cx.enable(GL_TEXTURE_WRAP_S);
    cx.end_list();
    no_error(&mut cx);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.call_list(1));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.new_list(0, GL_COMPILE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.new_list(2, GL_RENDER));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.end_list());
    cx.new_list(2, GL_COMPILE);
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.new_list(3, GL_COMPILE));
    cx.end_list();
    raises(&mut cx, GL_INVALID_VALUE, |cx| {
        cx.gen_lists(-1);
    });
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.delete_lists(1, -1));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.call_lists(1, GL_RGBA, &[1u8]));
}
