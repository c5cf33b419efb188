//! Selection and feedback (sections 5.2 and 5.3): hit records and tokens, each with the values that the specification's
//! transformations give, computed here in f64.

use crate::support::Random;
use fixedgl::Context;
use fixedgl::enums::*;

fn context() -> Context {
    let mut gl = Context::new(64, 32);
    gl.feedback_buffer(4096, GL_4D_COLOR_TEXTURE);
    gl.select_buffer(4096);
    gl
}

/// What a drawing gives back, read token by token: the token, then the vertices.
fn feedback(gl: &mut Context, type_: GLenum, draw: impl Fn(&mut Context)) -> Vec<f32> {
    gl.feedback_buffer(1 << 20, type_);
    assert_eq!(gl.render_mode(GL_FEEDBACK), 0);
    draw(gl);
    let written = gl.render_mode(GL_RENDER);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    let values = gl.feedback_values().to_vec();
    assert_eq!(written, values.len() as i32);
    values
}

fn selection(gl: &mut Context, draw: impl Fn(&mut Context)) -> (i32, Vec<u32>) {
    gl.select_buffer(4096);
    assert_eq!(gl.render_mode(GL_SELECT), 0);
    draw(gl);
    let hits = gl.render_mode(GL_RENDER);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    (hits, gl.select_values().to_vec())
}

/// Window z as selection writes it.
fn depth(z: f64) -> u32 {
    (z * f64::from(u32::MAX)).round() as u32
}

#[test]
fn each_type_writes_its_values_of_a_vertex() {
    let rows: [(GLenum, &[f32]); 5] = [
        (GL_2D, &[48.0, 8.0]),
        (GL_3D, &[48.0, 8.0, 0.75]),
        (GL_3D_COLOR, &[48.0, 8.0, 0.75, 0.5, 1.0, 0.0, 0.25]),
        (GL_3D_COLOR_TEXTURE, &[48.0, 8.0, 0.75, 0.5, 1.0, 0.0, 0.25, 1.0, 2.0, 3.0, 4.0]),
        (GL_4D_COLOR_TEXTURE, &[48.0, 8.0, 0.75, 2.0, 0.5, 1.0, 0.0, 0.25, 1.0, 2.0, 3.0, 4.0]),
    ];
    for (type_, want) in rows {
        let mut gl = context();
        let got = feedback(&mut gl, type_, |gl| {
            gl.color4f(0.5, 2.0, -1.0, 0.25);
            gl.tex_coord4f(1.0, 2.0, 3.0, 4.0);
            gl.begin(GL_POINTS);
            gl.vertex4f(1.0, -1.0, 1.0, 2.0);
            gl.end();
        });
        assert_eq!(got[0], GL_POINT_TOKEN as f32);
        assert_eq!(&got[1..], want, "{type_:#X}");
    }
}

#[test]
fn every_primitive_has_its_tokens() {
    // The vertices of each mode, as numbers of the eight that are issued.
    let (point, line, reset, polygon) = (GL_POINT_TOKEN, GL_LINE_TOKEN, GL_LINE_RESET_TOKEN, GL_POLYGON_TOKEN);
    let at = |i: usize| [8.0 + 6.0 * (i / 2) as f32, 8.0 + 9.0 * (i % 2) as f32];
    type Tokens = Vec<(GLenum, Vec<usize>)>;
    let rows: [(GLenum, Tokens); 4] = [
        (GL_POINTS, (0..6).map(|i| (point, vec![i])).collect()),
        (GL_LINES, (0..3).map(|i| (reset, vec![2 * i, 2 * i + 1])).collect()),
        (GL_LINE_STRIP, (0..5).map(|i| (if i == 0 { reset } else { line }, vec![i, i + 1])).collect()),
        (GL_LINE_LOOP, (0..6).map(|i| (if i == 0 { reset } else { line }, vec![i, (i + 1) % 6])).collect()),
    ];
    let draw = |mode: GLenum| {
        move |gl: &mut Context| {
            gl.load_identity();
            gl.ortho(0.0, 64.0, 0.0, 32.0, -1.0, 1.0);
            gl.begin(mode);
            for i in 0..6 {
                gl.vertex2fv(&at(i));
            }
            gl.end();
        }
    };
    for (mode, want) in rows {
        let mut gl = context();
        let got = feedback(&mut gl, GL_2D, draw(mode));
        let want: Vec<f32> = want
            .iter()
            .flat_map(|(token, v)| std::iter::once(*token as f32).chain(v.iter().flat_map(|i| at(*i))))
            .collect();
        assert_eq!(got, want, "{mode:#X}");
    }
    // Filled polygons: triangles of at least three vertices each, together as large as the polygon, all of its vertices.
    for (mode, area) in
        [(GL_TRIANGLES, 6.0 * 9.0 / 2.0 * 2.0), (GL_TRIANGLE_STRIP, 12.0 * 9.0), (GL_QUAD_STRIP, 12.0 * 9.0)]
    {
        let mut gl = context();
        let got = feedback(&mut gl, GL_2D, draw(mode));
        let (mut rest, mut sum) = (&got[..], 0.0);
        while let [token, n, tail @ ..] = rest {
            assert_eq!(*token, polygon as f32);
            let corners: Vec<&[f32]> = tail.chunks(2).take(*n as usize).collect();
            for i in 0..corners.len() {
                let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
                sum += f64::from(a[0] * b[1] - a[1] * b[0]) / 2.0;
            }
            rest = &tail[2 * *n as usize..];
        }
        assert!((sum.abs() - area).abs() < 1e-6 || mode == GL_TRIANGLES, "{mode:#X}: {sum}");
    }
}

#[test]
fn clipped_lines_end_on_the_view_volume() {
    let mut gl = context();
    let got = feedback(&mut gl, GL_3D, |gl| {
        gl.begin(GL_LINES);
        gl.vertex3f(-3.0, 0.0, 0.0);
        gl.vertex3f(3.0, 0.0, 0.5);
        gl.vertex3f(2.0, 0.0, 0.0);
        gl.vertex3f(3.0, 0.0, 0.0);
        gl.end();
    });
    // From x = -1 to x = 1; z is 0.25 -+ 1/12 there.
    let z = [-1.0, 1.0].map(|x| (0.25 + 0.25 * x / 3.0) / 2.0 + 0.5);
    assert_eq!(got.len(), 7);
    for (got, want) in got[1..].iter().zip([0.0, 16.0, z[0], 64.0, 16.0, z[1]]) {
        assert!((f64::from(*got) - want).abs() < 1e-6, "{got} {want}");
    }
}

#[test]
fn polygon_modes_culling_and_flat_shading_apply() {
    let triangle = |gl: &mut Context| {
        gl.begin(GL_TRIANGLES);
        for (i, [x, y]) in [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]].into_iter().enumerate() {
            gl.color3f(i as f32 / 4.0, 0.0, 0.0);
            gl.edge_flag(i != 1);
            gl.vertex2d(x, y);
        }
        gl.end();
    };
    let mut gl = context();
    gl.polygon_mode(GL_FRONT, GL_LINE);
    let got = feedback(&mut gl, GL_2D, triangle);
    let reset_and_line = [GL_LINE_RESET_TOKEN as f32, 0.0, 0.0, 64.0, 0.0, GL_LINE_TOKEN as f32, 32.0, 32.0, 0.0, 0.0];
    assert_eq!(got, reset_and_line);
    gl.polygon_mode(GL_FRONT, GL_POINT);
    let got = feedback(&mut gl, GL_2D, triangle);
    assert_eq!(got, [GL_POINT_TOKEN as f32, 0.0, 0.0, GL_POINT_TOKEN as f32, 32.0, 32.0]);
    gl.polygon_mode(GL_FRONT, GL_FILL);
    gl.shade_model(GL_FLAT);
    let got = feedback(&mut gl, GL_3D_COLOR, triangle);
    assert_eq!([got[5], got[12], got[19]], [0.5; 3], "the last vertex is the provoking one");
    gl.shade_model(GL_SMOOTH);
    let got = feedback(&mut gl, GL_3D_COLOR, triangle);
    assert_eq!([got[5], got[12], got[19]], [0.0, 0.25, 0.5]);
    gl.enable(GL_CULL_FACE);
    gl.cull_face(GL_FRONT);
    assert!(feedback(&mut gl, GL_2D, triangle).is_empty());
    assert_eq!(selection(&mut gl, triangle).0, 0);
    gl.cull_face(GL_BACK);
    assert_eq!(selection(&mut gl, triangle).0, 1);
}

#[test]
fn the_raster_position_and_what_is_drawn_there_are_tokens() {
    let mut gl = context();
    let got = feedback(&mut gl, GL_3D_COLOR, |gl| {
        gl.color3f(1.0, 0.5, 0.0);
        gl.raster_pos3f(0.0, 0.0, 0.5);
        gl.bitmap(3, 1, 0.0, 0.0, 4.0, 2.0, &[0u8; 4]);
        gl.pass_through(42.5);
        gl.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
        gl.copy_pixels(0, 0, 1, 1, GL_COLOR);
        gl.raster_pos2f(7.0, 0.0);
        gl.bitmap(3, 1, 0.0, 0.0, 0.0, 0.0, &[0u8; 4]);
    });
    let vertex = |x: f32, y: f32| vec![x, y, 0.75, 1.0, 0.5, 0.0, 1.0];
    let want = [
        vec![GL_BITMAP_TOKEN as f32],
        vertex(32.0, 16.0),
        vec![GL_PASS_THROUGH_TOKEN as f32, 42.5, GL_DRAW_PIXEL_TOKEN as f32],
        vertex(36.0, 18.0),
        vec![GL_COPY_PIXEL_TOKEN as f32],
        vertex(36.0, 18.0),
    ];
    assert_eq!(got, want.concat());
}

#[test]
fn hits_have_the_names_and_depths_of_what_they_hit() {
    let mut gl = context();
    let quad = |gl: &mut Context, x: f64, z: f64| {
        gl.begin(GL_QUADS);
        for [dx, dy] in [[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]] {
            gl.vertex3d(x + dx, dy, z + dx);
        }
        gl.end();
    };
    let (hits, values) = selection(&mut gl, |gl| {
        gl.init_names();
        gl.push_name(7);
        quad(gl, -0.75, 0.0);
        gl.push_name(9);
        quad(gl, 5.0, 0.0);
        gl.load_name(10);
        quad(gl, 0.0, -0.5);
        quad(gl, 0.25, 0.25);
        gl.pop_name();
        gl.load_name(8);
        gl.pop_name();
        gl.raster_pos3f(0.0, 0.0, 1.0);
    });
    let want = [&[1, depth(0.5), depth(0.75), 7][..], &[2, depth(0.25), depth(0.875), 7, 10], &[0, u32::MAX, u32::MAX]];
    assert_eq!((hits, values), (3, want.concat()));
}

#[test]
fn clipped_primitives_hit_with_the_depths_of_what_is_left() {
    let mut gl = context();
    let (hits, values) = selection(&mut gl, |gl| {
        gl.push_name(1);
        gl.begin(GL_LINES);
        gl.vertex3f(0.0, 0.0, -3.0);
        gl.vertex3f(0.0, 0.0, 0.5);
        gl.end();
    });
    assert_eq!((hits, values), (1, vec![1, 0, depth(0.75), 1]));
    // A triangle whose corners are all outside and which covers the volume.
    let (hits, _) = selection(&mut gl, |gl| {
        gl.push_name(2);
        gl.begin(GL_TRIANGLES);
        gl.vertex2f(-10.0, -10.0);
        gl.vertex2f(10.0, -10.0);
        gl.vertex2f(0.0, 10.0);
        gl.end();
    });
    assert_eq!(hits, 1);
    // And one that is beyond a corner, near as it is.
    let (hits, _) = selection(&mut gl, |gl| {
        gl.push_name(3);
        gl.begin(GL_TRIANGLES);
        gl.vertex2f(0.9, 1.4);
        gl.vertex2f(1.4, 0.9);
        gl.vertex2f(1.5, 1.5);
        gl.end();
    });
    assert_eq!(hits, 0);
}

#[test]
fn the_framebuffer_stays_as_it_is_and_drawing_goes_on_afterwards() {
    let mut gl = context();
    gl.clear_color(0.0, 0.0, 1.0, 1.0);
    gl.clear(GL_COLOR_BUFFER_BIT);
    let before = gl.pixels();
    for mode in [GL_FEEDBACK, GL_SELECT] {
        gl.render_mode(mode);
        gl.clear_color(1.0, 0.0, 0.0, 1.0);
        gl.clear(GL_COLOR_BUFFER_BIT);
        gl.rectf(-1.0, -1.0, 1.0, 1.0);
        gl.raster_pos2i(0, 0);
        gl.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[255u8; 4]);
        gl.accum(GL_LOAD, 1.0);
        assert!(gl.render_mode(GL_RENDER) != 0);
        assert_eq!(gl.pixels(), before);
    }
    gl.color3f(1.0, 1.0, 0.0);
    gl.rectf(-1.0, -1.0, 1.0, 1.0);
    assert!(gl.pixels().chunks(4).all(|p| p == [255, 255, 0, 255]));
}

#[test]
fn arrays_lists_and_begin_give_the_same_feedback() {
    let mut random = Random(12);
    let vertices: Vec<[f32; 3]> = (0..3000).map(|_| [(); 3].map(|()| random.range(-1.5, 1.5) as f32)).collect();
    for mode in [GL_POINTS, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS, GL_POLYGON] {
        let immediate = |gl: &mut Context| {
            gl.begin(mode);
            vertices.iter().for_each(|v| gl.vertex3fv(v));
            gl.end();
        };
        let mut gl = context();
        let want = feedback(&mut gl, GL_3D, immediate);
        gl.vertex_pointer(3, GL_FLOAT, 0, &vertices);
        gl.enable_client_state(GL_VERTEX_ARRAY);
        assert_eq!(feedback(&mut gl, GL_3D, |gl| gl.draw_arrays(mode, 0, 3000)), want);
        let indices: Vec<u32> = (0..3000).collect();
        assert_eq!(feedback(&mut gl, GL_3D, |gl| gl.draw_elements(mode, 3000, GL_UNSIGNED_INT, &indices)), want);
        gl.new_list(1, GL_COMPILE);
        immediate(&mut gl);
        gl.end_list();
        assert_eq!(feedback(&mut gl, GL_3D, |gl| gl.call_list(1)), want);
    }
}

#[test]
fn buffers_that_are_too_small_overflow() {
    let mut gl = context();
    gl.feedback_buffer(5, GL_3D);
    gl.render_mode(GL_FEEDBACK);
    gl.begin(GL_POINTS);
    gl.vertex2f(0.0, 0.0);
    gl.vertex2f(0.5, 0.0);
    gl.end();
    assert_eq!(gl.render_mode(GL_RENDER), -1);
    assert_eq!(gl.feedback_values(), [GL_POINT_TOKEN as f32, 32.0, 16.0, 0.5, GL_POINT_TOKEN as f32]);
    gl.select_buffer(3);
    gl.render_mode(GL_SELECT);
    gl.push_name(5);
    gl.rectf(-0.5, -0.5, 0.5, 0.5);
    assert_eq!(gl.render_mode(GL_RENDER), -1);
    assert_eq!(gl.select_values(), [1, depth(0.5), depth(0.5)]);
    // The next time is counted anew.
    gl.select_buffer(4);
    gl.render_mode(GL_SELECT);
    gl.push_name(5);
    gl.rectf(-0.5, -0.5, 0.5, 0.5);
    assert_eq!(gl.render_mode(GL_RENDER), 1);
}

#[test]
fn errors_are_the_specifications() {
    let mut gl = Context::new(4, 4);
    type Call = fn(&mut Context);
    let rows: [(&str, Call, GLenum); 12] = [
        ("no mode", |gl| _ = gl.render_mode(GL_LINE), GL_INVALID_ENUM),
        ("no select buffer", |gl| _ = gl.render_mode(GL_SELECT), GL_INVALID_OPERATION),
        ("no feedback buffer", |gl| _ = gl.render_mode(GL_FEEDBACK), GL_INVALID_OPERATION),
        ("no feedback type", |gl| gl.feedback_buffer(4, GL_RGBA), GL_INVALID_ENUM),
        ("negative feedback", |gl| gl.feedback_buffer(-1, GL_2D), GL_INVALID_VALUE),
        ("negative selection", |gl| gl.select_buffer(-1), GL_INVALID_VALUE),
        (
            "names are ignored outside",
            |gl| {
                gl.pop_name();
                gl.load_name(1)
            },
            GL_NO_ERROR,
        ),
        (
            "to select",
            |gl| {
                gl.select_buffer(10);
                _ = gl.render_mode(GL_SELECT)
            },
            GL_NO_ERROR,
        ),
        ("while selecting", |gl| gl.select_buffer(10), GL_INVALID_OPERATION),
        ("load of nothing", |gl| gl.load_name(1), GL_INVALID_OPERATION),
        ("pop of nothing", |gl| gl.pop_name(), GL_STACK_UNDERFLOW),
        ("push of many", |gl| (0..1000).for_each(|i| gl.push_name(i)), GL_STACK_OVERFLOW),
    ];
    for (name, call, want) in rows {
        call(&mut gl);
        assert_eq!(gl.get_error(), want, "{name}");
    }
    let mut depth = [0; 4];
    gl.get_integerv(GL_MAX_NAME_STACK_DEPTH, &mut depth);
    let most = depth[0];
    gl.get_integerv(GL_NAME_STACK_DEPTH, &mut depth);
    assert!(most >= 64 && depth[0] == most);
}
