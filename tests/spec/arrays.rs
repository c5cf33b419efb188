//! Vertex arrays and buffer objects (OpenGL 1.5, sections 2.8 and 2.9): whatever way the vertices come, the picture is that
//! of Begin and End; types, strides, interleaved formats, index types, and the errors.

use crate::support::{get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::NULL;
use fixedgl::enums::*;

const SIZE: u32 = 32;
/// Four corners with a colour each, in an order that makes a strip.
const POSITIONS: [[f32; 3]; 6] =
    [[-0.9, -0.9, 0.0], [0.9, -0.8, 0.1], [-0.5, 0.25, 0.2], [0.5, 0.5, 0.3], [-0.25, 0.75, 0.5], [0.8, 0.9, 0.5]];
const COLORS: [[u8; 4]; 6] =
    [[255, 0, 0, 255], [0, 255, 0, 200], [0, 0, 255, 100], [255, 255, 0, 50], [10, 200, 90, 255], [1, 2, 3, 4]];

fn immediate(mode: GLenum, order: &[usize]) -> Vec<[u8; 4]> {
    let mut cx = Context::new(SIZE, SIZE);
    cx.begin(mode);
    for &i in order {
        cx.color4ubv(&COLORS[i]);
        cx.vertex3fv(&POSITIONS[i]);
    }
    cx.end();
    pixels(&mut cx, SIZE, SIZE)
}

fn with_arrays() -> Context {
    let mut cx = Context::new(SIZE, SIZE);
    cx.enable_client_state(GL_VERTEX_ARRAY);
    cx.enable_client_state(GL_COLOR_ARRAY);
    cx.vertex_pointer(3, GL_FLOAT, 0, &POSITIONS);
    cx.color_pointer(4, GL_UNSIGNED_BYTE, 0, &COLORS);
    cx
}

#[test]
fn the_initial_state_is_the_tables_and_errors_are_told() {
    let mut cx = Context::new(4, 4);
    for (pname, want) in [
        (GL_VERTEX_ARRAY, 0),
        (GL_VERTEX_ARRAY_SIZE, 4),
        (GL_VERTEX_ARRAY_TYPE, GL_FLOAT),
        (GL_VERTEX_ARRAY_STRIDE, 0),
        (GL_COLOR_ARRAY_SIZE, 4),
        (GL_TEXTURE_COORD_ARRAY_SIZE, 4),
        (GL_NORMAL_ARRAY_TYPE, GL_FLOAT),
        (GL_SECONDARY_COLOR_ARRAY_SIZE, 3),
        (GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0),
        (GL_ARRAY_BUFFER_BINDING, 0),
        (GL_ELEMENT_ARRAY_BUFFER_BINDING, 0),
    ] {
        assert_eq!(get_i(&mut cx, pname) as u32, want, "{}", fixedgl::enums::name(pname));
    }
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.vertex_pointer(1, GL_FLOAT, 0, &[0f32; 4]));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.vertex_pointer(3, GL_FLOAT, -4, &[0f32; 4]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.vertex_pointer(3, GL_UNSIGNED_BYTE, 0, &[0u8; 4]));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.color_pointer(2, GL_FLOAT, 0, &[0f32; 4]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.normal_pointer(GL_UNSIGNED_INT, 0, &[0u32; 4]));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_coord_pointer(5, GL_FLOAT, 0, &[0f32; 4]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.enable_client_state(GL_TEXTURE_2D));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.draw_arrays(GL_TRIANGLES, 0, -3));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.draw_arrays(17, 0, 3));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.draw_elements(GL_TRIANGLES, 1, GL_FLOAT, &[0f32]));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.draw_range_elements(GL_TRIANGLES, 3, 1, 1, GL_UNSIGNED_BYTE, &[0u8]));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.bind_buffer(GL_TEXTURE_2D, 1));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.buffer_data(GL_ARRAY_BUFFER, 4, &[0u8; 4], GL_STATIC_DRAW));
}

#[test]
fn every_mode_of_draw_arrays() {
    for mode in GL_POINTS..=GL_POLYGON {
        let want = immediate(mode, &[0, 1, 2, 3, 4, 5]);
        let mut cx = with_arrays();
        cx.draw_arrays(mode, 0, 6);
        assert_eq!(pixels(&mut cx, SIZE, SIZE), want, "mode {mode}");
    }
}

#[test]
fn every_index_type_and_array_element() {
    let order = [0usize, 1, 3, 3, 2, 0, 5, 4, 3];
    let want = immediate(GL_TRIANGLES, &order);
    let mut cx = with_arrays();
    cx.draw_elements(GL_TRIANGLES, 9, GL_UNSIGNED_BYTE, &order.map(|i| i as u8));
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let mut cx = with_arrays();
    cx.draw_elements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, &order.map(|i| i as u16));
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let mut cx = with_arrays();
    cx.draw_range_elements(GL_TRIANGLES, 0, 5, 9, GL_UNSIGNED_INT, &order.map(|i| i as u32));
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let mut cx = with_arrays();
    cx.begin(GL_TRIANGLES);
    for i in order {
        cx.array_element(i as i32);
    }
    cx.end();
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let mut cx = with_arrays();
    cx.multi_draw_arrays(GL_TRIANGLES, &[0, 3], &[3, 3], 2);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), immediate(GL_TRIANGLES, &[0, 1, 2, 3, 4, 5]));
    let mut cx = with_arrays();
    cx.multi_draw_elements(GL_TRIANGLES, &[3, 6], GL_UNSIGNED_BYTE, &[&[0u8, 1, 3][..], &[3, 2, 0, 5, 4, 3]]);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
}

#[test]
fn every_type_and_stride_draws_the_same() {
    let want = immediate(GL_TRIANGLE_STRIP, &[0, 1, 2, 3, 4, 5]);
    // Doubles, with two numbers between the vertices.
    let wide: Vec<[f64; 5]> = POSITIONS.iter().map(|p| [p[0].into(), p[1].into(), p[2].into(), 7.0, 8.0]).collect();
    let mut cx = with_arrays();
    cx.vertex_pointer(3, GL_DOUBLE, 40, &wide);
    cx.draw_arrays(GL_TRIANGLE_STRIP, 0, 6);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    // Colours as floats and as shorts that stand for the same bytes.
    let floats: Vec<[f32; 4]> = COLORS.iter().map(|c| c.map(|v| f32::from(v) / 255.0)).collect();
    let mut cx = with_arrays();
    cx.color_pointer(4, GL_FLOAT, 0, &floats);
    cx.draw_arrays(GL_TRIANGLE_STRIP, 0, 6);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let shorts: Vec<[u16; 4]> = COLORS.iter().map(|c| c.map(|v| u16::from(v) * 257)).collect();
    let mut cx = with_arrays();
    cx.color_pointer(4, GL_UNSIGNED_SHORT, 0, &shorts);
    cx.draw_arrays(GL_TRIANGLE_STRIP, 0, 6);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    // Whole numbers as positions, under a matrix.
    let mut by_int = Vec::new();
    for kind in 0..2 {
        let mut cx = Context::new(SIZE, SIZE);
        cx.scalef(0.125, 0.125, 1.0);
        cx.enable_client_state(GL_VERTEX_ARRAY);
        if kind == 0 {
            cx.vertex_pointer(2, GL_SHORT, 0, &[[-7i16, -6], [7, -3], [1, 7]]);
        } else {
            cx.vertex_pointer(2, GL_INT, 12, &[[-7i32, -6, 99], [7, -3, 99], [1, 7, 99]]);
        }
        cx.draw_arrays(GL_TRIANGLES, 0, 3);
        by_int.push(pixels(&mut cx, SIZE, SIZE));
    }
    assert!(by_int[0] == by_int[1] && by_int[0].iter().any(|p| p[0] > 0));
}

#[test]
fn buffer_objects_hold_arrays_and_indices() {
    let order = [0u16, 1, 3, 3, 2, 0];
    let want = immediate(GL_TRIANGLES, &order.map(usize::from));
    let mut cx = Context::new(SIZE, SIZE);
    let mut names = [0u32; 2];
    cx.gen_buffers(2, &mut names);
    cx.bind_buffer(GL_ARRAY_BUFFER, names[0]);
    let mut bytes = Vec::new();
    for (p, c) in POSITIONS.iter().zip(COLORS) {
        bytes.extend(p.iter().flat_map(|v| v.to_ne_bytes()));
        bytes.extend(c);
    }
    cx.buffer_data(GL_ARRAY_BUFFER, bytes.len() as isize, &bytes, GL_STATIC_DRAW);
    cx.vertex_pointer(3, GL_FLOAT, 16, 0usize);
    cx.color_pointer(4, GL_UNSIGNED_BYTE, 16, 12usize);
    cx.enable_client_state(GL_VERTEX_ARRAY);
    cx.enable_client_state(GL_COLOR_ARRAY);
    cx.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
    cx.buffer_data(GL_ELEMENT_ARRAY_BUFFER, 12, &order, GL_STATIC_DRAW);
    cx.draw_elements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, NULL);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let mut back = [0u16; 2];
    cx.get_buffer_sub_data(GL_ELEMENT_ARRAY_BUFFER, 4, 4, &mut back);
    assert_eq!(back, [3, 3]);
    // The draw keeps what it was issued with.
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.draw_elements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, NULL);
    cx.buffer_sub_data(GL_ARRAY_BUFFER, 0, 16, &[0u8; 16]);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.buffer_sub_data(GL_ARRAY_BUFFER, 90, 16, &[0u8; 16]));
    cx.delete_buffers(2, &names);
    assert!(!cx.is_buffer(names[0]));
    assert_eq!(get_i(&mut cx, GL_ARRAY_BUFFER_BINDING), 0);
}

#[test]
fn indices_out_of_range_never_end_the_program() {
    let mut cx = with_arrays();
    cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, &[0u32, u32::MAX, 77]);
    let _ = cx.get_error();
    cx.draw_arrays(GL_TRIANGLES, 4, 300);
    let _ = cx.get_error();
    cx.draw_arrays(GL_TRIANGLES, i32::MAX - 2, 3);
    let _ = cx.get_error();
    cx.draw_arrays(GL_TRIANGLES, 0, 6);
    no_error(&mut cx);
    assert_eq!(pixels(&mut cx, SIZE, SIZE).len(), 1024);
}

#[test]
fn interleaved_arrays_draw_what_separate_ones_do() {
    let want = immediate(GL_TRIANGLE_STRIP, &[0, 1, 2, 3, 4, 5]);
    let mut bytes = Vec::new();
    for (p, c) in POSITIONS.iter().zip(COLORS) {
        bytes.extend(c);
        bytes.extend(p.iter().flat_map(|v| v.to_ne_bytes()));
    }
    let mut cx = Context::new(SIZE, SIZE);
    cx.interleaved_arrays(GL_C4UB_V3F, 0, &bytes);
    cx.draw_arrays(GL_TRIANGLE_STRIP, 0, 6);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    let t2: Vec<[f32; 12]> = POSITIONS
        .iter()
        .zip(COLORS)
        .map(|(p, c)| {
            let [r, g, b, a] = c.map(|v| f32::from(v) / 255.0);
            [0.5, 0.5, r, g, b, a, 0.0, 0.0, 1.0, p[0], p[1], p[2]]
        })
        .collect();
    let mut cx = Context::new(SIZE, SIZE);
    cx.interleaved_arrays(GL_T2F_C4F_N3F_V3F, 0, &t2);
    cx.draw_arrays(GL_TRIANGLE_STRIP, 0, 6);
    assert_eq!(pixels(&mut cx, SIZE, SIZE), want);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.interleaved_arrays(GL_RGBA, 0, &t2));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.interleaved_arrays(GL_V3F, -1, &t2));
}
