//! Display lists (OpenGL 1.5, section 5.4): a list does what the calls in it do, it ends at the nesting limit, it keeps
//! images as they were, and names are reserved in runs.

use fixedgl::Context;
use fixedgl::enums::*;

/// A program and what it is about.
type Script = (&'static str, fn(&mut Context));

/// Programs that change state; each is carried out directly, compiled and called, and compiled while it is carried out.
const SCRIPTS: &[Script] = &[
    ("matrices", |cx| {
        cx.matrix_mode(GL_PROJECTION);
        cx.frustum(-1.0, 1.0, -0.5, 0.5, 1.0, 10.0);
        cx.matrix_mode(GL_MODELVIEW);
        cx.push_matrix();
        cx.load_transpose_matrixf(&[1., 2., 3., 4., 0., 1., 0., 5., 0., 0., 1., 6., 0., 0., 0., 1.]);
        cx.rotatef(30.0, 0.0, 1.0, 0.5);
        cx.scaled(1.0, 2.0, 3.0);
        cx.clip_plane(GL_CLIP_PLANE1, &[1.0, 2.0, 3.0, 4.0]);
    }),
    ("attributes", |cx| {
        cx.color4usv(&[65535, 0, 30000, 1]);
        cx.normal3b(127, -128, 5);
        cx.tex_coord3s(1, 2, 3);
        cx.multi_tex_coord2d(GL_TEXTURE1, 0.25, 0.5);
        cx.secondary_color3f(0.1, 0.2, 0.3);
        cx.fog_coordd(3.5);
        cx.indexi(7);
        cx.edge_flag(false);
    }),
    ("lighting", |cx| {
        cx.translatef(0.0, 0.0, -5.0);
        cx.lightiv(GL_LIGHT2, GL_DIFFUSE, &[i32::MAX, 0, i32::MIN, i32::MAX]);
        cx.lightfv(GL_LIGHT2, GL_POSITION, &[1.0, 2.0, 3.0, 1.0]);
        cx.lightf(GL_LIGHT2, GL_SPOT_CUTOFF, 30.0);
        cx.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
        cx.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &[0.5, 0.25, 0.125, 1.0]);
        cx.materiali(GL_BACK, GL_SHININESS, 20);
        cx.enable(GL_LIGHTING);
    }),
    ("fog and fragments", |cx| {
        cx.fogi(GL_FOG_MODE, GL_LINEAR);
        cx.fogfv(GL_FOG_COLOR, &[0.5, 0.5, 0.25, 1.0]);
        cx.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        cx.depth_func(GL_GEQUAL);
        cx.color_mask(true, false, true, false);
        cx.stencil_func(GL_LESS, 3, 0xF0);
        cx.clear_color(0.1, 0.2, 0.3, 0.4);
        cx.depth_range(0.25, 0.75);
        cx.push_attrib(GL_DEPTH_BUFFER_BIT);
        cx.depth_func(GL_NEVER);
        cx.pop_attrib();
    }),
    ("textures", |cx| {
        cx.active_texture(GL_TEXTURE1);
        cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
        cx.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.1, 0.2, 0.3, 0.4]);
        cx.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        cx.tex_gendv(GL_S, GL_OBJECT_PLANE, &[1.0, 2.0, 3.0, 4.0]);
        cx.bind_texture(GL_TEXTURE_2D, 5);
        cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        cx.pixel_transferf(GL_RED_SCALE, 0.5);
        cx.pixel_mapusv(GL_PIXEL_MAP_R_TO_R, 2, &[0, 65535]);
    }),
    ("errors", |cx| {
        cx.enable(0x1234);
        cx.pop_matrix();
    }),
    ("a draw from arrays leaves the current values", |cx| {
        cx.color3f(0.25, 0.5, 0.75);
        arrays(cx, 60);
        cx.draw_arrays(GL_TRIANGLES, 0, 60);
        cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &[0u8, 1, 2]);
    }),
    ("an array element sets the current values", |cx| {
        arrays(cx, 3);
        cx.array_element(2);
    }),
];

/// Arrays of small triangles with colours.
fn arrays(cx: &mut Context, n: u8) {
    let corner = |i: u8| [[-0.5f32, -0.5], [0.5, -0.5], [0.0, 0.5]][usize::from(i % 3)];
    let positions: Vec<[f32; 2]> = (0..n).map(corner).collect();
    let colors: Vec<[u8; 4]> = (0..n).map(|i| [255, i, 0, 255]).collect();
    cx.vertex_pointer(2, GL_FLOAT, 0, &positions);
    cx.color_pointer(4, GL_UNSIGNED_BYTE, 0, &colors);
    cx.enable_client_state(GL_VERTEX_ARRAY);
    cx.enable_client_state(GL_COLOR_ARRAY);
}

/// What a script can have changed, as text.
fn state(cx: &mut Context) -> Vec<String> {
    let first = cx.get_error();
    let names = [
        GL_MODELVIEW_MATRIX,
        GL_PROJECTION_MATRIX,
        GL_MODELVIEW_STACK_DEPTH,
        GL_MATRIX_MODE,
        GL_CURRENT_COLOR,
        GL_CURRENT_NORMAL,
        GL_CURRENT_TEXTURE_COORDS,
        GL_CURRENT_SECONDARY_COLOR,
        GL_CURRENT_FOG_COORD,
        GL_CURRENT_INDEX,
        GL_EDGE_FLAG,
        GL_LIGHT_MODEL_TWO_SIDE,
        GL_LIGHTING,
        GL_FOG_MODE,
        GL_FOG_COLOR,
        GL_BLEND_SRC,
        GL_BLEND_DST,
        GL_DEPTH_FUNC,
        GL_COLOR_WRITEMASK,
        GL_STENCIL_FUNC,
        GL_STENCIL_REF,
        GL_STENCIL_VALUE_MASK,
        GL_COLOR_CLEAR_VALUE,
        GL_DEPTH_RANGE,
        GL_ACTIVE_TEXTURE,
        GL_TEXTURE_BINDING_2D,
        GL_RED_SCALE,
        GL_PIXEL_MAP_R_TO_R_SIZE,
        GL_ATTRIB_STACK_DEPTH,
    ];
    let mut all = vec![format!("error {first:x}")];
    for name in names {
        let mut values = [-77.0_f64; 16];
        cx.get_doublev(name, &mut values);
        assert_eq!(cx.get_error(), GL_NO_ERROR, "{name:x}");
        all.push(format!("{name:x} {values:?}"));
    }
    let mut v = [0.0_f32; 16];
    cx.get_clip_plane(GL_CLIP_PLANE1, &mut [0.0; 4]);
    cx.get_lightfv(GL_LIGHT2, GL_DIFFUSE, &mut v[0..4]);
    cx.get_lightfv(GL_LIGHT2, GL_POSITION, &mut v[4..8]);
    cx.get_materialfv(GL_BACK, GL_DIFFUSE, &mut v[8..12]);
    cx.get_materialfv(GL_BACK, GL_SHININESS, &mut v[12..13]);
    all.push(format!("{v:?}"));
    cx.active_texture(GL_TEXTURE1);
    cx.get_multi(&mut all);
    all
}

trait More {
    fn get_multi(&mut self, all: &mut Vec<String>);
}

impl More for Context {
    /// The state of texture unit 1.
    fn get_multi(&mut self, all: &mut Vec<String>) {
        let mut v = [0.0_f32; 16];
        self.get_floatv(GL_CURRENT_TEXTURE_COORDS, &mut v[0..4]);
        self.get_tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &mut v[4..8]);
        self.get_tex_genfv(GL_S, GL_OBJECT_PLANE, &mut v[8..12]);
        self.get_tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mut v[12..13]);
        self.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &mut v[13..14]);
        all.push(format!("{v:?}"));
        assert_eq!(self.get_error(), GL_NO_ERROR);
    }
}

#[test]
fn a_list_does_what_the_calls_in_it_do() {
    let initial = state(&mut Context::new(8, 8));
    for (name, script) in SCRIPTS {
        let mut direct = Context::new(8, 8);
        script(&mut direct);
        let expected = state(&mut direct);
        assert_ne!(expected, initial, "{name} changes something");

        let mut compiled = Context::new(8, 8);
        compiled.new_list(3, GL_COMPILE);
        script(&mut compiled);
        compiled.end_list();
        assert_eq!(state(&mut compiled), initial, "{name}: compiling carries nothing out");
        compiled.active_texture(GL_TEXTURE0);
        compiled.call_list(3);
        assert_eq!(state(&mut compiled), expected, "{name}: called");

        let mut both = Context::new(8, 8);
        both.new_list(3, GL_COMPILE_AND_EXECUTE);
        script(&mut both);
        both.end_list();
        assert_eq!(state(&mut both), expected, "{name}: compiled and carried out");

        // Through a list that calls the list by an offset.
        let mut nested = Context::new(8, 8);
        nested.new_list(103, GL_COMPILE);
        script(&mut nested);
        nested.end_list();
        nested.new_list(1, GL_COMPILE);
        nested.list_base(100);
        nested.call_lists(1, GL_UNSIGNED_BYTE, &[3_u8]);
        nested.end_list();
        nested.call_list(1);
        assert_eq!(state(&mut nested), expected, "{name}: nested");
    }
}

#[test]
fn a_list_that_calls_itself_ends_at_the_nesting_limit() {
    let mut cx = Context::new(4, 4);
    cx.new_list(1, GL_COMPILE);
    cx.translatef(1.0, 0.0, 0.0);
    cx.call_list(1);
    cx.end_list();
    cx.call_list(1);
    let mut m = [0.0_f32; 16];
    cx.get_floatv(GL_MODELVIEW_MATRIX, &mut m);
    assert_eq!(m[12], 64.0);
    assert_eq!(cx.check(), Ok(()));
    // One that calls itself twice would run 2^64 times.
    cx.new_list(2, GL_COMPILE);
    cx.call_lists(2, GL_UNSIGNED_SHORT, &[2_u16, 2]);
    cx.end_list();
    cx.call_list(2);
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
}

#[test]
fn names_of_lists_are_reserved_in_runs() {
    let mut cx = Context::new(4, 4);
    let first = cx.gen_lists(5);
    let second = cx.gen_lists(i32::MAX);
    assert!(first > 0 && second >= first + 5);
    assert!(cx.is_list(first + 4) && cx.is_list(second + 1_000_000));
    cx.delete_lists(first + 1, 2);
    assert!(cx.is_list(first) && !cx.is_list(first + 1) && !cx.is_list(first + 2) && cx.is_list(first + 3));
    assert_eq!(cx.gen_lists(2), first + 1);
    assert_eq!(cx.gen_lists(0), 0);
    assert_eq!(cx.check(), Ok(()));
    assert_eq!(cx.gen_lists(-1), 0);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    cx.new_list(0, GL_COMPILE);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    cx.new_list(1, GL_POINTS);
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    cx.end_list();
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
    cx.new_list(1, GL_COMPILE);
    cx.new_list(2, GL_COMPILE);
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
    let mut open = [0; 2];
    cx.get_integerv(GL_LIST_INDEX, &mut open[0..1]);
    cx.get_integerv(GL_LIST_MODE, &mut open[1..2]);
    assert_eq!(open, [1, GL_COMPILE as i32]);
}

#[test]
fn a_list_keeps_an_image_as_it_was_compiled() {
    let mut cx = Context::new(4, 4);
    let mut texels = [0_u8, 10, 20, 99, 0, 30, 40, 99];
    cx.pixel_storei(GL_UNPACK_ROW_LENGTH, 3);
    cx.pixel_storei(GL_UNPACK_SKIP_PIXELS, 1);
    cx.new_list(1, GL_COMPILE);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_LUMINANCE, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, fixedgl::NULL);
    cx.end_list();
    let mut width = 0;
    cx.get_tex_level_parameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &mut width);
    assert_eq!(width, 16, "a proxy is answered at once");
    texels.fill(7);
    cx.pixel_storei(GL_UNPACK_ROW_LENGTH, 50);
    cx.call_list(1);
    let mut length = 0;
    cx.get_integerv(GL_UNPACK_ROW_LENGTH, &mut length);
    assert_eq!(length, 50);
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    let mut back = [0_u8; 4];
    cx.get_tex_image(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut back);
    assert_eq!(back, [10, 20, 30, 40]);
    assert_eq!(cx.check(), Ok(()));
}

fn picture(cx: &mut Context) -> Vec<u8> {
    let mut bytes = vec![0; 16 * 16 * 4];
    cx.read_pixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
    bytes
}

/// Draws from arrays, short ones and ones that a list keeps as an array of vertices.
const DRAWS: &[Script] = &[
    ("DrawArrays", |cx| cx.draw_arrays(GL_TRIANGLES, 0, 3)),
    ("a long DrawArrays", |cx| cx.draw_arrays(GL_TRIANGLES, 0, 60)),
    ("DrawElements", |cx| cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &[2u8, 1, 0])),
    ("DrawRangeElements", |cx| cx.draw_range_elements(GL_TRIANGLES, 0, 2, 3, GL_UNSIGNED_SHORT, &[2u16, 1, 0])),
    ("MultiDrawArrays", |cx| cx.multi_draw_arrays(GL_TRIANGLES, &[0, 3, 0], &[3, 0, 57], 3)),
    ("MultiDrawElements", |cx| {
        cx.multi_draw_elements(GL_TRIANGLES, &[3, 0], GL_UNSIGNED_INT, &[[0u32, 1, 2], [0; 3]]);
    }),
];

#[test]
fn a_draw_in_a_list_is_one_command_that_begin_refuses() {
    let mut alone = Context::new(16, 16);
    let triangle = |cx: &mut Context, between: &dyn Fn(&mut Context)| {
        cx.color3f(0.0, 0.0, 1.0);
        cx.begin(GL_TRIANGLES);
        cx.vertex2f(-1.0, -1.0);
        between(cx);
        cx.vertex2f(1.0, -1.0);
        cx.vertex2f(1.0, 1.0);
        cx.end();
    };
    triangle(&mut alone, &|_| {});
    let want = picture(&mut alone);
    for (name, draw) in DRAWS {
        for mode in [GL_COMPILE, GL_COMPILE_AND_EXECUTE] {
            let mut direct = Context::new(16, 16);
            arrays(&mut direct, 60);
            draw(&mut direct);
            let mut cx = Context::new(16, 16);
            arrays(&mut cx, 60);
            cx.new_list(1, mode);
            draw(&mut cx);
            cx.end_list();
            if mode == GL_COMPILE {
                cx.call_list(1);
            }
            assert_eq!(cx.get_error(), GL_NO_ERROR, "{name}");
            assert_eq!(picture(&mut cx), picture(&mut direct), "{name}");
            assert_ne!(picture(&mut cx), vec![0; 16 * 16 * 4], "{name} draws");
            cx.clear(GL_COLOR_BUFFER_BIT);
            triangle(&mut cx, &|cx| cx.call_list(1));
            assert_eq!(cx.get_error(), GL_INVALID_OPERATION, "{name}");
            assert_eq!(cx.get_error(), GL_NO_ERROR, "{name}: the outer primitive is still open");
            assert_eq!(picture(&mut cx), want, "{name} draws nothing and closes nothing");
        }
    }
}

/// A command that is wrong, and its error.
type Wrong = (&'static str, GLenum, fn(&mut Context));

const WRONG: &[Wrong] = &[
    ("DrawArrays: mode", GL_INVALID_ENUM, |cx| cx.draw_arrays(99, 0, 3)),
    ("DrawArrays: count", GL_INVALID_VALUE, |cx| cx.draw_arrays(GL_TRIANGLES, 0, -1)),
    ("DrawArrays: first", GL_INVALID_VALUE, |cx| cx.draw_arrays(GL_TRIANGLES, -1, 3)),
    ("DrawElements: type", GL_INVALID_ENUM, |cx| cx.draw_elements(GL_TRIANGLES, 3, GL_FLOAT, &[0u8; 3])),
    ("DrawElements: count", GL_INVALID_VALUE, |cx| cx.draw_elements(GL_TRIANGLES, -3, GL_UNSIGNED_BYTE, &[0u8; 3])),
    ("DrawElements: memory", GL_INVALID_VALUE, |cx| {
        cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &[0u8; 2]);
    }),
    ("DrawElements: mode before memory", GL_INVALID_ENUM, |cx| {
        cx.draw_elements(99, 3, GL_UNSIGNED_BYTE, &[0u8; 2]);
    }),
    ("DrawRangeElements", GL_INVALID_VALUE, |cx| {
        cx.draw_range_elements(GL_TRIANGLES, 2, 1, 3, GL_UNSIGNED_BYTE, &[0u8; 3]);
    }),
    ("MultiDrawArrays: mode", GL_INVALID_ENUM, |cx| cx.multi_draw_arrays(99, &[0], &[0], 1)),
    ("MultiDrawArrays: drawcount", GL_INVALID_VALUE, |cx| cx.multi_draw_arrays(GL_TRIANGLES, &[0], &[3], -1)),
    ("MultiDrawArrays: a count", GL_INVALID_VALUE, |cx| {
        cx.multi_draw_arrays(GL_TRIANGLES, &[0, 0], &[3, -1], 2);
    }),
    ("MultiDrawArrays: a first", GL_INVALID_VALUE, |cx| {
        cx.multi_draw_arrays(GL_TRIANGLES, &[0, -1], &[3, 3], 2);
    }),
    ("MultiDrawArrays: memory", GL_INVALID_VALUE, |cx| cx.multi_draw_arrays(GL_TRIANGLES, &[0], &[3, 3], 2)),
    ("MultiDrawElements: type", GL_INVALID_ENUM, |cx| {
        cx.multi_draw_elements(GL_TRIANGLES, &[3], GL_FLOAT, &[[0u8; 3]]);
    }),
    ("MultiDrawElements: a count", GL_INVALID_VALUE, |cx| {
        cx.multi_draw_elements(GL_TRIANGLES, &[3, -1], GL_UNSIGNED_BYTE, &[[0u8, 1, 2], [0, 1, 2]]);
    }),
    ("MultiDrawElements: memory", GL_INVALID_VALUE, |cx| {
        cx.multi_draw_elements(GL_TRIANGLES, &[3, 4], GL_UNSIGNED_BYTE, &[[0u8, 1, 2], [0, 1, 2]]);
    }),
    ("ArrayElement", GL_INVALID_VALUE, |cx| cx.array_element(-1)),
    ("CallLists: type", GL_INVALID_ENUM, |cx| cx.call_lists(1, GL_DOUBLE, &[0u8; 8])),
    ("CallLists: n", GL_INVALID_VALUE, |cx| cx.call_lists(-1, GL_UNSIGNED_BYTE, &[0u8; 8])),
];

#[test]
fn a_wrong_draw_draws_nothing_and_in_a_list_its_error_is_that_of_the_call() {
    for (name, error, command) in WRONG {
        let mut cx = Context::new(16, 16);
        arrays(&mut cx, 3);
        command(&mut cx);
        assert_eq!(cx.get_error(), *error, "{name}");
        cx.new_list(1, GL_COMPILE);
        command(&mut cx);
        assert_eq!(cx.get_error(), GL_NO_ERROR, "{name}: compiled");
        cx.end_list();
        cx.call_list(1);
        assert_eq!(cx.get_error(), *error, "{name}: called");
        cx.new_list(2, GL_COMPILE_AND_EXECUTE);
        command(&mut cx);
        cx.end_list();
        assert_eq!(cx.get_error(), *error, "{name}: compiled and carried out");
        assert_eq!(picture(&mut cx), vec![0; 16 * 16 * 4], "{name} draws nothing");
    }
}
