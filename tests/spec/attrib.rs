//! Attribute stacks (OpenGL 1.5, section 6.1.14): every group comes back, nothing else does, the stacks have ends.

use crate::support::{get_f, get_i, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

/// A change of state, the mask of its group, what asks for it, the value before and after.
type Row = (GLenum, fn(&mut Context), GLenum, i32, i32);

const ROWS: &[Row] = &[
    (GL_ENABLE_BIT, |cx| cx.enable(GL_LIGHTING), GL_LIGHTING, 0, 1),
    (GL_LIGHTING_BIT, |cx| cx.enable(GL_LIGHTING), GL_LIGHTING, 0, 1),
    (GL_LIGHTING_BIT, |cx| cx.shade_model(GL_FLAT), GL_SHADE_MODEL, GL_SMOOTH as i32, GL_FLAT as i32),
    (GL_DEPTH_BUFFER_BIT, |cx| cx.depth_func(GL_ALWAYS), GL_DEPTH_FUNC, GL_LESS as i32, GL_ALWAYS as i32),
    (GL_DEPTH_BUFFER_BIT, |cx| cx.depth_mask(false), GL_DEPTH_WRITEMASK, 1, 0),
    (GL_COLOR_BUFFER_BIT, |cx| cx.blend_func(GL_ZERO, GL_ONE), GL_BLEND_SRC, GL_ONE as i32, GL_ZERO as i32),
    (GL_COLOR_BUFFER_BIT, |cx| cx.enable(GL_ALPHA_TEST), GL_ALPHA_TEST, 0, 1),
    (GL_POLYGON_BIT, |cx| cx.cull_face(GL_FRONT), GL_CULL_FACE_MODE, GL_BACK as i32, GL_FRONT as i32),
    (GL_POINT_BIT, |cx| cx.point_size(5.0), GL_POINT_SIZE, 1, 5),
    (GL_LINE_BIT, |cx| cx.line_width(3.0), GL_LINE_WIDTH, 1, 3),
    (GL_FOG_BIT, |cx| cx.fogi(GL_FOG_MODE, GL_LINEAR), GL_FOG_MODE, GL_EXP as i32, GL_LINEAR as i32),
    (GL_TRANSFORM_BIT, |cx| cx.matrix_mode(GL_TEXTURE), GL_MATRIX_MODE, GL_MODELVIEW as i32, GL_TEXTURE as i32),
    (GL_TRANSFORM_BIT, |cx| cx.enable(GL_NORMALIZE), GL_NORMALIZE, 0, 1),
    (GL_SCISSOR_BIT, |cx| cx.enable(GL_SCISSOR_TEST), GL_SCISSOR_TEST, 0, 1),
    (GL_STENCIL_BUFFER_BIT, |cx| cx.stencil_func(GL_LESS, 1, 1), GL_STENCIL_FUNC, GL_ALWAYS as i32, GL_LESS as i32),
    (GL_TEXTURE_BIT, |cx| cx.bind_texture(GL_TEXTURE_2D, 5), GL_TEXTURE_BINDING_2D, 0, 5),
    (GL_TEXTURE_BIT, |cx| cx.active_texture(GL_TEXTURE1), GL_ACTIVE_TEXTURE, GL_TEXTURE0 as i32, GL_TEXTURE1 as i32),
    (GL_TEXTURE_BIT, |cx| cx.enable(GL_TEXTURE_2D), GL_TEXTURE_2D, 0, 1),
    (GL_HINT_BIT, |cx| cx.hint(GL_FOG_HINT, GL_NICEST), GL_FOG_HINT, GL_DONT_CARE as i32, GL_NICEST as i32),
    (GL_LIST_BIT, |cx| cx.list_base(9), GL_LIST_BASE, 0, 9),
    (GL_PIXEL_MODE_BIT, |cx| cx.pixel_transferf(GL_RED_SCALE, 3.0), GL_RED_SCALE, 1, 3),
    (GL_VIEWPORT_BIT, |cx| cx.viewport(2, 1, 1, 1), GL_VIEWPORT, 0, 2),
];

#[test]
fn every_group_comes_back() {
    for (mask, change, pname, before, after) in ROWS {
        let name = fixedgl::enums::name(*pname);
        for push in [*mask, GL_ALL_ATTRIB_BITS] {
            let mut cx = Context::new(4, 4);
            assert_eq!(get_i(&mut cx, *pname), *before, "{name}");
            cx.push_attrib(push);
            change(&mut cx);
            assert_eq!(get_i(&mut cx, *pname), *after, "{name}");
            cx.pop_attrib();
            assert_eq!(get_i(&mut cx, *pname), *before, "{name} comes back");
        }
        let mut cx = Context::new(4, 4);
        cx.push_attrib(if *mask == GL_ENABLE_BIT { 0 } else { GL_ALL_ATTRIB_BITS & !mask & !GL_ENABLE_BIT });
        change(&mut cx);
        cx.pop_attrib();
        assert_eq!(get_i(&mut cx, *pname), *after, "{name} stays where its group was not pushed");
    }
}

#[test]
fn the_current_values_and_texture_parameters() {
    let mut cx = Context::new(4, 4);
    cx.color4f(0.25, 0.5, 0.75, 1.0);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
    cx.push_attrib(GL_CURRENT_BIT | GL_TEXTURE_BIT);
    cx.color4f(1.0, 1.0, 1.0, 0.0);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    cx.pop_attrib();
    assert_eq!(get_f::<4>(&mut cx, GL_CURRENT_COLOR), [0.25, 0.5, 0.75, 1.0]);
    let mut v = [0i32];
    cx.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &mut v);
    assert_eq!(v[0] as u32, GL_CLAMP);
    cx.get_tex_enviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mut v);
    assert_eq!(v[0] as u32, GL_BLEND);
}

#[test]
fn the_stacks_have_ends() {
    let mut cx = Context::new(4, 4);
    raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_attrib());
    raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_client_attrib());
    let limit = get_i(&mut cx, GL_MAX_ATTRIB_STACK_DEPTH);
    assert!(limit >= 16);
    for _ in 0..limit {
        cx.push_attrib(GL_ALL_ATTRIB_BITS);
    }
    assert_eq!(get_i(&mut cx, GL_ATTRIB_STACK_DEPTH), limit);
    raises(&mut cx, GL_STACK_OVERFLOW, |cx| cx.push_attrib(GL_FOG_BIT));
    for _ in 0..limit {
        cx.pop_attrib();
    }
    no_error(&mut cx);
}

#[test]
fn client_groups_come_back() {
    let mut cx = Context::new(4, 4);
    cx.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    cx.enable_client_state(GL_NORMAL_ARRAY);
    cx.client_active_texture(GL_TEXTURE2);
    cx.pop_client_attrib();
    assert_eq!(get_i(&mut cx, GL_UNPACK_ALIGNMENT), 4);
    assert_eq!(get_i(&mut cx, GL_NORMAL_ARRAY), 0);
    assert_eq!(get_i(&mut cx, GL_CLIENT_ACTIVE_TEXTURE) as u32, GL_TEXTURE0);
}
