//! Tests of large draws: the same mesh from arrays, from Begin and End and from a display list, with one thread and with
//! several, is the same to the last bit; and what a list leaves behind is what its commands would have left.

use crate::Context;
use crate::context::Config;
use crate::enums::*;

const SIDE: usize = 72;
const SIZE: u32 = 160;

/// Position, normal, texture coordinate, colour of a corner of a wavy grid.
type Corner = ([f32; 3], [f32; 3], [f32; 2], [f32; 4]);

fn corner(i: usize, j: usize) -> Corner {
    let (s, t) = (i as f32 / SIDE as f32, j as f32 / SIDE as f32);
    let wave = ((i * 7 + j * 13) % 17) as f32 / 17.0;
    // Some of it lies before the near plane and beside the window.
    let position = [2.4 * s - 1.2, 2.4 * t - 1.2, 1.3 * wave - 0.3];
    (position, [wave - 0.5, 0.3, 0.8], [3.0 * s, 2.0 * t], [s, t, wave, 1.0])
}

fn corners() -> Vec<Corner> {
    (0..=SIDE).flat_map(|j| (0..=SIDE).map(move |i| corner(i, j))).collect()
}

/// Two triangles a cell, of which some look the other way.
fn triangles() -> Vec<u32> {
    let at = |i: usize, j: usize| (j * (SIDE + 1) + i) as u32;
    let cells = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if (i + j) % 5 == 0 { [a, c, b, a, c, d] } else { [a, b, c, a, c, d] }
        })
        .collect()
}

/// Rows of the grid one after the other in one strip, joined by triangles without area.
fn strip() -> Vec<u32> {
    let at = |i: usize, j: usize| (j * (SIDE + 1) + i) as u32;
    (0..SIDE)
        .flat_map(|j| {
            let row = (0..=SIDE).flat_map(move |i| [at(i, j + 1), at(i, j)]);
            [at(0, j + 1)].into_iter().chain(row).chain([at(SIDE, j)])
        })
        .collect()
}

fn context(threads: usize) -> Context {
    prepared(Context::with_config(SIZE, SIZE, Config { threads, ..Config::default() }))
}

fn prepared(mut gl: Context) -> Context {
    let texels: Vec<u8> = (0..4 * 64u32).map(|i| (i * 37 % 251) as u8).collect();
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    for what in [GL_TEXTURE_2D, GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL] {
        gl.enable(what);
    }
    gl.matrix_mode(GL_PROJECTION);
    gl.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 4.0);
    gl.matrix_mode(GL_MODELVIEW);
    gl.translatef(0.0, 0.0, -1.2);
    gl
}

fn bind(gl: &mut Context) {
    let all = corners();
    gl.vertex_pointer(3, GL_FLOAT, 0, all.iter().map(|c| c.0).collect::<Vec<_>>().as_flattened());
    gl.normal_pointer(GL_FLOAT, 0, all.iter().map(|c| c.1).collect::<Vec<_>>().as_flattened());
    gl.tex_coord_pointer(2, GL_FLOAT, 0, all.iter().map(|c| c.2).collect::<Vec<_>>().as_flattened());
    gl.color_pointer(4, GL_FLOAT, 0, all.iter().map(|c| c.3).collect::<Vec<_>>().as_flattened());
    for array in [GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY] {
        gl.enable_client_state(array);
    }
}

fn elements(gl: &mut Context, mode: GLenum, indices: &[u32]) {
    bind(gl);
    gl.draw_elements(mode, indices.len() as i32, GL_UNSIGNED_INT, indices);
}

fn issue(gl: &mut Context, mode: GLenum, indices: &[u32], mut before: impl FnMut(&mut Context, usize)) {
    let all = corners();
    gl.begin(mode);
    for (i, index) in indices.iter().enumerate() {
        before(gl, i);
        let (position, normal, coordinate, color) = all[*index as usize];
        gl.color4fv(&color);
        gl.normal3fv(&normal);
        gl.tex_coord2fv(&coordinate);
        gl.vertex3fv(&position);
    }
    gl.end();
}

fn picture(threads: usize, draw: impl Fn(&mut Context)) -> Vec<u8> {
    let mut gl = context(threads);
    draw(&mut gl);
    assert_eq!(gl.check(), Ok(()));
    gl.pixels()
}

/// The same picture with any number of threads; returns it.
fn same(draw: impl Fn(&mut Context)) -> Vec<u8> {
    let want = picture(1, &draw);
    let drawn = want.as_chunks::<4>().0.iter().filter(|p| **p != [0; 4]).count();
    assert!(drawn > 8000, "{drawn} pixels");
    for threads in [2, 5] {
        assert!(picture(threads, &draw) == want, "{threads} threads");
    }
    want
}

#[test]
fn a_mesh_is_the_same_however_it_is_issued() {
    let list = triangles();
    assert!(list.len() > crate::vertex::draw_worker::WORTH_CUTTING);
    let want = same(|gl| elements(gl, GL_TRIANGLES, &list));
    assert!(same(|gl| issue(gl, GL_TRIANGLES, &list, |_, _| {})) == want, "Begin and End");
    let listed = |gl: &mut Context| {
        gl.new_list(3, GL_COMPILE);
        issue(gl, GL_TRIANGLES, &list, |_, _| {});
        gl.end_list();
        gl.call_list(3);
    };
    assert!(same(listed) == want, "display list");
    // From a primitive that waits already, so that the long one does not begin a batch.
    let after = |gl: &mut Context| {
        issue(gl, GL_TRIANGLES, &[0, 0, 0, 1], |_, _| {});
        issue(gl, GL_TRIANGLES, &list, |_, _| {});
    };
    assert!(same(after) == want, "after another");
    // So many that what is collected is drawn before the end, and that a thread that walks is given some of it.
    let often = list.repeat(5);
    for mode in [GL_TRIANGLES, GL_QUADS] {
        same(|gl| issue(gl, mode, &often, |_, _| {}));
    }
}

#[test]
fn triangles_in_step_with_their_batches_are_as_others() {
    let list = triangles().repeat(2);
    let drawn = |batch_cut: usize, faces: GLenum| {
        let mut gl = prepared(Context::with_config(SIZE, SIZE, Config { threads: 1, batch_cut, ..Config::default() }));
        gl.set_counting(true);
        gl.cull_face(faces);
        let (mut rest, mut piece) = (&list[..], 0);
        while !rest.is_empty() {
            piece += 1;
            // Whole triangles and others, few and many, with something else between.
            let (now, later) = rest.split_at((piece * 37 % 331).min(rest.len()));
            match piece % 7 {
                0 => issue(&mut gl, GL_LINE_STRIP, now, |_, _| {}),
                1 => issue(&mut gl, GL_TRIANGLES, &now[..now.len() / 3 * 3], |_, _| {}),
                2 => {
                    let places: Vec<_> =
                        now.iter().map(|at| corner(*at as usize % SIDE, *at as usize / SIDE).0).collect();
                    gl.vertex_pointer(3, GL_FLOAT, 0, places.as_flattened());
                    gl.enable_client_state(GL_VERTEX_ARRAY);
                    gl.draw_arrays(GL_TRIANGLES, 1, places.len() as i32 - 1);
                }
                _ => issue(&mut gl, GL_TRIANGLES, now, |_, _| {}),
            }
            rest = later;
        }
        let c = gl.counters();
        (gl.pixels(), [c.vertices, c.primitives, c.clipped, c.culled, c.outside])
    };
    for faces in [GL_BACK, GL_FRONT] {
        let want = drawn(64, faces);
        for cut in [1, 48, 63] {
            assert!(drawn(cut, faces) == want, "batches of {cut}");
        }
    }
}

#[test]
fn strips_are_the_same_in_parts() {
    let strips: Vec<u32> = strip().into_iter().chain(strip()).collect();
    assert!(strips.len() > crate::vertex::draw_worker::WORTH_CUTTING);
    for mode in [GL_TRIANGLE_STRIP, GL_QUAD_STRIP] {
        for shade in [GL_SMOOTH, GL_FLAT] {
            same(|gl| {
                gl.shade_model(shade);
                elements(gl, mode, &strips);
            });
        }
    }
}

#[test]
fn a_change_within_a_long_primitive_counts_from_then_on() {
    let list = triangles();
    let change = |gl: &mut Context, i: usize| match i {
        // In the middle of a triangle and of a batch.
        5003 => gl.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 9.0),
        5004 => gl.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &[1.0; 4]),
        9001 => gl.tex_coord4f(0.5, 0.5, 0.0, 2.0),
        _ => {}
    };
    let changed = same(|gl| issue(gl, GL_TRIANGLES, &list, change));
    assert!(changed != same(|gl| issue(gl, GL_TRIANGLES, &list, |_, _| {})));
}

#[test]
fn what_is_drawn_while_a_primitive_goes_on_is_the_same() {
    let strips: Vec<u32> = strip().into_iter().chain(strip()).collect();
    for mode in [GL_TRIANGLE_STRIP, GL_LINE_STRIP] {
        same(|gl| {
            gl.enable(GL_LINE_STIPPLE);
            gl.line_stipple(3, 0x5A5A);
            issue(gl, mode, &strips, |_, _| {});
        });
    }
}

#[test]
fn larger_triangles_are_the_same_and_so_is_what_comes_after_them() {
    let (wide, high) = (5, 5 * (SIDE as u32 + 1));
    let corners = (0..(SIDE as u32 + 1) * (SIDE as u32 - 5)).filter(|at| at % (SIDE as u32 + 1) < SIDE as u32 - wide);
    let large: Vec<u32> = corners.flat_map(|at| [at, at + wide, at + high]).collect();
    let small = triangles();
    same(|gl| {
        issue(gl, GL_TRIANGLES, &large.repeat(6), |_, _| {});
        issue(gl, GL_TRIANGLES, &small.repeat(2), |_, _| {});
    });
}

#[test]
fn who_looks_between_begin_and_end_sees_what_was_drawn() {
    let list = triangles().repeat(3);
    let looks = |threads: usize| {
        let mut gl = context(threads);
        gl.set_counting(true);
        gl.begin_query(GL_SAMPLES_PASSED, 1);
        let mut looks = Vec::new();
        issue(&mut gl, GL_TRIANGLES, &list, |gl, i| {
            if i % 35_000 == 34_999 {
                looks.push((gl.pixels(), gl.counters().primitives));
            }
        });
        gl.end_query(GL_SAMPLES_PASSED);
        let mut passed = [0];
        gl.get_query_objectuiv(1, GL_QUERY_RESULT, &mut passed);
        looks.push((gl.pixels(), u64::from(passed[0])));
        looks
    };
    let want = looks(1);
    assert!(want.len() > 2 && want[0] != want[1]);
    for threads in [2, 5] {
        assert!(looks(threads) == want, "{threads} threads");
    }
    // A context may go while it is being drawn into, and a new size may come.
    for new_size in [false, true] {
        let mut gl = context(2);
        gl.begin(GL_TRIANGLES);
        for (i, index) in list.iter().chain(&list).enumerate() {
            if new_size && i == 30_000 {
                assert_eq!(gl.resize(50, 50), Ok(()));
            }
            gl.vertex3fv(&corner(*index as usize % SIDE, *index as usize / SIDE).0);
        }
    }
}

#[test]
fn a_list_leaves_the_current_values_of_its_commands() {
    let mut gl = context(1);
    gl.new_list(1, GL_COMPILE);
    gl.begin(GL_QUADS);
    gl.color4f(0.25, 0.5, 0.75, 0.5);
    for i in 0..80 {
        gl.indexi(i);
        gl.multi_tex_coord2f(GL_TEXTURE1, i as f32, 2.0);
        gl.vertex2i(i, i % 3);
    }
    gl.normal3f(0.0, 1.0, 0.0);
    gl.secondary_color3f(0.5, 0.25, 0.125);
    gl.end();
    gl.end_list();
    let values = |gl: &mut Context| {
        let mut v = [0.0f32; 20];
        gl.get_floatv(GL_CURRENT_COLOR, &mut v[..4]);
        gl.get_floatv(GL_CURRENT_NORMAL, &mut v[4..7]);
        gl.get_floatv(GL_CURRENT_SECONDARY_COLOR, &mut v[7..11]);
        gl.get_floatv(GL_CURRENT_INDEX, &mut v[11..12]);
        gl.active_texture(GL_TEXTURE1);
        gl.get_floatv(GL_CURRENT_TEXTURE_COORDS, &mut v[12..16]);
        gl.get_materialfv(GL_FRONT, GL_DIFFUSE, &mut v[16..]);
        v
    };
    gl.call_list(1);
    let want = [0.25, 0.5, 0.75, 0.5, 0.0, 1.0, 0.0, 0.5, 0.25, 0.125];
    let got = values(&mut gl);
    assert_eq!(got[..10], want);
    assert_eq!(got[11..], [79.0, 79.0, 2.0, 0.0, 1.0, 0.25, 0.5, 0.75, 0.5]);
    assert_eq!(gl.check(), Ok(()));
    // Between Begin and End its Begin is the error that it would be by itself, and its End ends.
    gl.begin(GL_POINTS);
    gl.call_list(1);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert_eq!(values(&mut gl), got);
    assert_eq!(gl.check(), Ok(()));
}
