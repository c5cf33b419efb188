//! Vertex arrays and buffer objects (spec-notes/vertex-arrays.md): every way to give the same vertices must give the same
//! bytes as Begin/End; what is wrong must be an error that changes nothing.

use fixedgl::Context;
use fixedgl::NULL;
use fixedgl::enums::*;

const SIZE: u32 = 32;

fn context() -> Context {
    let mut gl = Context::new(SIZE, SIZE);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl
}

/// A grid of 3 x 3 vertices with colours, and the indices of its 8 triangles.
const POSITIONS: [[i16; 2]; 9] = [[-9, -9], [0, -8], [9, -9], [-8, 0], [1, 1], [8, 0], [-9, 9], [0, 8], [9, 9]];
const COLORS: [[u8; 4]; 9] = [
    [255, 0, 0, 255],
    [0, 255, 0, 255],
    [0, 0, 255, 255],
    [255, 255, 0, 255],
    [0, 255, 255, 255],
    [255, 0, 255, 255],
    [255, 255, 255, 255],
    [128, 64, 32, 255],
    [1, 2, 3, 255],
];
const INDICES: [u8; 24] = [0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 3, 4, 6, 4, 7, 6, 4, 5, 7, 5, 8, 7];

fn scaled(gl: &mut Context) {
    gl.matrix_mode(GL_MODELVIEW);
    gl.load_identity();
    gl.scalef(0.1, 0.1, 1.0);
}

/// The picture as Begin/End draws it.
fn wanted() -> Vec<u8> {
    let mut gl = context();
    scaled(&mut gl);
    gl.begin(GL_TRIANGLES);
    for i in INDICES {
        gl.color4ubv(&COLORS[usize::from(i)]);
        gl.vertex2sv(&POSITIONS[usize::from(i)]);
    }
    gl.end();
    gl.check().unwrap();
    let pixels = gl.pixels();
    assert!(pixels.chunks(4).filter(|p| p[..3] != [0, 0, 0]).count() > 600, "the grid covers most of the picture");
    pixels
}

/// The picture of a way to draw.
fn drawn(f: impl FnOnce(&mut Context)) -> Vec<u8> {
    let mut gl = context();
    scaled(&mut gl);
    gl.enable_client_state(GL_VERTEX_ARRAY);
    gl.enable_client_state(GL_COLOR_ARRAY);
    f(&mut gl);
    gl.check().unwrap();
    gl.pixels()
}

fn positions<T: From<i8>>() -> Vec<T> {
    POSITIONS.iter().flatten().map(|v| T::from(*v as i8)).collect()
}

/// Colour bytes as a wider type whose value is the same fraction of its range.
fn colors<T>(f: impl Fn(u8) -> T) -> Vec<T> {
    COLORS.iter().flatten().map(|c| f(*c)).collect()
}

#[test]
fn every_type_of_position_and_colour_gives_the_picture_of_begin_and_end() {
    let want = wanted();
    let elements = |gl: &mut Context| gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, &INDICES);
    let bytes = |gl: &mut Context| gl.color_pointer(4, GL_UNSIGNED_BYTE, 0, &COLORS);
    macro_rules! position_types { ($($t:ty: $name:ident;)*) => { $(
        assert!(drawn(|gl| {
            bytes(gl);
            gl.vertex_pointer(2, $name, 0, &positions::<$t>());
            elements(gl);
        }) == want, "positions of {}", stringify!($name));
    )* } }
    position_types! { i16: GL_SHORT; i32: GL_INT; f32: GL_FLOAT; f64: GL_DOUBLE; }
    macro_rules! color_types { ($($name:ident: $f:expr;)*) => { $(
        assert!(drawn(|gl| {
            gl.vertex_pointer(2, GL_SHORT, 0, &POSITIONS);
            gl.color_pointer(4, $name, 0, &colors($f));
            elements(gl);
        }) == want, "colours of {}", stringify!($name));
    )* } }
    color_types! {
        GL_UNSIGNED_SHORT: |c| u16::from(c) * 257;
        GL_UNSIGNED_INT: |c| u32::from(c) * 0x0101_0101;
        GL_FLOAT: |c| f32::from(c) / 255.0;
        GL_DOUBLE: |c| f64::from(f32::from(c) / 255.0);
    }
}

#[test]
fn every_stride_and_index_type_draws_the_same() {
    let want = wanted();
    // Position and colour in one record of 11 bytes: nothing is aligned.
    let mut records = Vec::new();
    for (position, color) in POSITIONS.iter().zip(COLORS) {
        records.extend(position.iter().flat_map(|v| v.to_ne_bytes()));
        records.extend(color);
        records.extend([99; 3]);
    }
    let arrays = |gl: &mut Context| {
        gl.vertex_pointer(2, GL_SHORT, 11, &records);
        gl.color_pointer(4, GL_UNSIGNED_BYTE, 11, &records[4..]);
    };
    let short = INDICES.map(u16::from);
    let long = INDICES.map(u32::from);
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, &INDICES)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_SHORT, &short)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_INT, &long)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.draw_range_elements(GL_TRIANGLES, 0, 8, 24, GL_UNSIGNED_INT, &long)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.begin(GL_TRIANGLES);
            INDICES.iter().for_each(|i| gl.array_element(i32::from(*i)));
            gl.end();
        }),
        want
    );
}

#[test]
fn consecutive_elements_and_several_primitives_at_once() {
    let want = wanted();
    let all = |of: fn(usize) -> Vec<f32>| -> Vec<f32> { INDICES.iter().flat_map(|i| of(usize::from(*i))).collect() };
    let position = all(|i| POSITIONS[i].iter().map(|v| f32::from(*v)).collect());
    let color = all(|i| COLORS[i].iter().map(|c| f32::from(*c) / 255.0).collect());
    let arrays = |gl: &mut Context| {
        gl.vertex_pointer(2, GL_FLOAT, 0, &position);
        gl.color_pointer(4, GL_FLOAT, 0, &color);
    };
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.draw_arrays(GL_TRIANGLES, 0, 24)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            arrays(gl);
            gl.multi_draw_arrays(GL_TRIANGLES, &[0, 3, 12], &[3, 9, 12], 3)
        }),
        want
    );
    let (a, b) = INDICES.split_at(9);
    assert_eq!(
        drawn(|gl| {
            gl.vertex_pointer(2, GL_SHORT, 0, &POSITIONS);
            gl.color_pointer(4, GL_UNSIGNED_BYTE, 0, &COLORS);
            gl.multi_draw_elements(GL_TRIANGLES, &[9, 15], GL_UNSIGNED_BYTE, &[a, b]);
        }),
        want
    );
}

#[test]
fn buffer_objects_hold_arrays_and_indices() {
    let want = wanted();
    let buffers = |gl: &mut Context| {
        let mut names = [0; 2];
        gl.gen_buffers(2, &mut names);
        assert!(!gl.is_buffer(names[0]));
        gl.bind_buffer(GL_ARRAY_BUFFER, names[0]);
        assert!(gl.is_buffer(names[0]));
        gl.buffer_data(GL_ARRAY_BUFFER, 4 + 36 + 36, NULL, GL_STATIC_DRAW);
        gl.buffer_sub_data(GL_ARRAY_BUFFER, 4, 36, &POSITIONS);
        gl.buffer_sub_data(GL_ARRAY_BUFFER, 40, 36, &COLORS);
        gl.vertex_pointer(2, GL_SHORT, 0, 4);
        gl.color_pointer(4, GL_UNSIGNED_BYTE, 0, 40);
        gl.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
        gl.buffer_data(GL_ELEMENT_ARRAY_BUFFER, 26, NULL, GL_STATIC_DRAW);
        gl.map_buffer(GL_ELEMENT_ARRAY_BUFFER, GL_WRITE_ONLY).unwrap()[2..].copy_from_slice(&INDICES);
        assert!(gl.unmap_buffer(GL_ELEMENT_ARRAY_BUFFER));
        names
    };
    assert_eq!(
        drawn(|gl| {
            buffers(gl);
            gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, 2)
        }),
        want
    );
    let mut gl = context();
    let names = buffers(&mut gl);
    let mut back = [0; 24];
    gl.get_buffer_sub_data(GL_ELEMENT_ARRAY_BUFFER, 2, 24, &mut back);
    assert_eq!(back, INDICES);
    let mut value = [0];
    gl.get_buffer_parameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &mut value);
    assert_eq!(value, [76]);
    gl.get_integerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &mut value);
    assert_eq!(value, [names[0] as i32]);
    // Indices beyond the buffer object, and elements beyond the array: an error and nothing, or zeros, never foreign memory.
    gl.enable_client_state(GL_VERTEX_ARRAY);
    gl.draw_elements(GL_TRIANGLES, 25, GL_UNSIGNED_BYTE, 2);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    gl.draw_arrays(GL_TRIANGLES, 0, 3000);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    gl.delete_buffers(2, &names);
    assert!(!gl.is_buffer(names[0]));
    gl.get_integerv(GL_ARRAY_BUFFER_BINDING, &mut value);
    assert_eq!(value, [0]);
    gl.draw_arrays(GL_TRIANGLES, 0, 9);
    gl.check().unwrap();
}

#[test]
fn interleaved_formats_lie_as_table_2_5_says() {
    // T2F_C4F_N3F_V3F and C4UB_V2F against the same in separate arrays.
    let want = wanted();
    let mut records: Vec<f32> = Vec::new();
    let mut packed = Vec::new();
    for (position, color) in POSITIONS.iter().zip(COLORS) {
        records.extend([0.5, 0.5]);
        records.extend(color.map(|c| f32::from(c) / 255.0));
        records.extend([0.0, 0.0, 1.0]);
        records.extend([f32::from(position[0]), f32::from(position[1]), 0.0]);
        packed.extend(color);
        packed.extend(position.iter().flat_map(|v| f32::from(*v).to_ne_bytes()));
    }
    let elements = |gl: &mut Context| gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, &INDICES);
    assert_eq!(
        drawn(|gl| {
            gl.interleaved_arrays(GL_T2F_C4F_N3F_V3F, 0, &records);
            elements(gl)
        }),
        want
    );
    assert_eq!(
        drawn(|gl| {
            gl.interleaved_arrays(GL_C4UB_V2F, 0, &packed);
            elements(gl)
        }),
        want
    );
    let mut gl = context();
    gl.enable_client_state(GL_FOG_COORD_ARRAY);
    gl.interleaved_arrays(GL_T4F_C4F_N3F_V4F, 0, &records);
    for (array, on) in [
        (GL_VERTEX_ARRAY, true),
        (GL_COLOR_ARRAY, true),
        (GL_NORMAL_ARRAY, true),
        (GL_TEXTURE_COORD_ARRAY, true),
        (GL_FOG_COORD_ARRAY, false),
    ] {
        assert_eq!(gl.is_enabled(array), on, "{}", name(array));
    }
    let mut values = [0];
    gl.get_integerv(GL_NORMAL_ARRAY_STRIDE, &mut values);
    assert_eq!(values, [60]);
}

#[test]
fn a_mesh_larger_than_a_chunk_is_the_same_by_index_and_in_sequence() {
    // 100 x 100 cells, 10,201 vertices, in an order that reuses them over and over.
    const N: u32 = 100;
    let at = |i: u32| i as f32 / N as f32 * 1.9 - 0.95;
    let mut vertices = Vec::new();
    let mut colors = Vec::new();
    for y in 0..=N {
        for x in 0..=N {
            vertices.push([at(x), at(y), 0.0]);
            colors.push([(x * 7 % 13) as f32 / 13.0, (y * 5 % 11) as f32 / 11.0, 0.5]);
        }
    }
    let mut indices = Vec::new();
    for y in 0..N {
        for x in 0..N {
            let i = y * (N + 1) + x;
            indices.extend([i, i + 1, i + N + 1, i + 1, i + N + 2, i + N + 1]);
        }
    }
    let by_index = drawn(|gl| {
        gl.load_identity();
        gl.vertex_pointer(3, GL_FLOAT, 0, &vertices);
        gl.color_pointer(3, GL_FLOAT, 0, &colors);
        gl.draw_elements(GL_TRIANGLES, indices.len() as i32, GL_UNSIGNED_INT, &indices);
    });
    let in_sequence = drawn(|gl| {
        gl.load_identity();
        let pick = |from: &[[f32; 3]]| -> Vec<[f32; 3]> { indices.iter().map(|i| from[*i as usize]).collect() };
        gl.vertex_pointer(3, GL_FLOAT, 0, &pick(&vertices));
        gl.color_pointer(3, GL_FLOAT, 0, &pick(&colors));
        gl.draw_arrays(GL_TRIANGLES, 0, indices.len() as i32);
    });
    assert!(by_index.chunks(4).any(|p| p[0] > 0));
    assert_eq!(by_index, in_sequence);
}

#[test]
fn errors_change_nothing() {
    let mut gl = context();
    gl.vertex_pointer(3, GL_SHORT, 7, 12);
    let mut expect = |f: &dyn Fn(&mut Context), code: GLenum| {
        f(&mut gl);
        assert_eq!(gl.get_error(), code);
        let mut values = [0; 3];
        gl.get_integerv(GL_VERTEX_ARRAY_SIZE, &mut values[..1]);
        gl.get_integerv(GL_VERTEX_ARRAY_TYPE, &mut values[1..2]);
        gl.get_integerv(GL_VERTEX_ARRAY_STRIDE, &mut values[2..]);
        assert_eq!(values, [3, GL_SHORT as i32, 7]);
    };
    expect(&|gl| gl.vertex_pointer(1, GL_FLOAT, 0, NULL), GL_INVALID_VALUE);
    expect(&|gl| gl.vertex_pointer(5, GL_FLOAT, 0, NULL), GL_INVALID_VALUE);
    expect(&|gl| gl.vertex_pointer(3, GL_BYTE, 0, NULL), GL_INVALID_ENUM);
    expect(&|gl| gl.vertex_pointer(3, GL_FLOAT, -4, NULL), GL_INVALID_VALUE);
    expect(&|gl| gl.color_pointer(2, GL_FLOAT, 0, NULL), GL_INVALID_VALUE);
    expect(&|gl| gl.normal_pointer(GL_UNSIGNED_BYTE, 0, NULL), GL_INVALID_ENUM);
    expect(&|gl| gl.fog_coord_pointer(GL_INT, 0, NULL), GL_INVALID_ENUM);
    expect(&|gl| gl.interleaved_arrays(GL_FLOAT, 0, NULL), GL_INVALID_ENUM);
    expect(&|gl| gl.interleaved_arrays(GL_V3F, -1, NULL), GL_INVALID_VALUE);
    expect(&|gl| gl.enable_client_state(GL_LIGHTING), GL_INVALID_ENUM);
    expect(&|gl| gl.client_active_texture(GL_TEXTURE0 + 8), GL_INVALID_ENUM);
    expect(&|gl| gl.draw_arrays(GL_POLYGON + 1, 0, 3), GL_INVALID_ENUM);
    expect(&|gl| gl.draw_arrays(GL_TRIANGLES, 0, -3), GL_INVALID_VALUE);
    expect(&|gl| gl.draw_elements(GL_TRIANGLES, 3, GL_FLOAT, &[0u32; 3]), GL_INVALID_ENUM);
    expect(&|gl| gl.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, NULL), GL_INVALID_OPERATION);
    expect(&|gl| gl.draw_range_elements(GL_TRIANGLES, 2, 1, 3, GL_UNSIGNED_INT, &[0u32; 3]), GL_INVALID_VALUE);
    expect(&|gl| gl.lock_arrays(0, 0), GL_INVALID_VALUE);
    expect(&|gl| gl.unlock_arrays(), GL_INVALID_OPERATION);
    expect(&|gl| gl.bind_buffer(GL_TEXTURE_2D, 1), GL_INVALID_ENUM);
    expect(&|gl| gl.buffer_data(GL_ARRAY_BUFFER, 4, NULL, GL_STATIC_DRAW), GL_INVALID_OPERATION);
    expect(&|gl| _ = gl.map_buffer(GL_ARRAY_BUFFER, GL_READ_ONLY), GL_INVALID_OPERATION);
    gl.bind_buffer(GL_ARRAY_BUFFER, 7);
    gl.buffer_data(GL_ARRAY_BUFFER, 4, &[1u8, 2, 3, 4], GL_STATIC_DRAW);
    for (offset, size) in [(-1, 1), (0, 5), (4, 1), (isize::MAX, isize::MAX)] {
        gl.buffer_sub_data(GL_ARRAY_BUFFER, offset, size, NULL);
        assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    }
    gl.buffer_data(GL_ARRAY_BUFFER, -1, NULL, GL_STATIC_DRAW);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    gl.buffer_data(GL_ARRAY_BUFFER, isize::MAX, NULL, GL_STATIC_DRAW);
    assert_eq!(gl.get_error(), GL_OUT_OF_MEMORY);
    gl.buffer_data(GL_ARRAY_BUFFER, 4, NULL, GL_TRIANGLES);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
    let mut bytes = [0u8; 4];
    gl.get_buffer_sub_data(GL_ARRAY_BUFFER, 0, 4, &mut bytes);
    assert_eq!(bytes, [1, 2, 3, 4]);
    // A mapped buffer object may not be drawn from.
    gl.vertex_pointer(2, GL_FLOAT, 0, 0);
    gl.enable_client_state(GL_VERTEX_ARRAY);
    assert!(gl.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE).is_some());
    gl.draw_arrays(GL_TRIANGLES, 0, 3);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert!(gl.map_buffer(GL_ARRAY_BUFFER, GL_READ_WRITE).is_none());
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert!(gl.unmap_buffer(GL_ARRAY_BUFFER));
    gl.check().unwrap();
}

#[test]
fn an_array_that_is_too_short_reads_as_zeros_and_says_so() {
    let heard = std::sync::Arc::new(std::sync::Mutex::new(Vec::new()));
    let messages = heard.clone();
    let mut gl = context();
    gl.set_debug_callback(Some(Box::new(move |m| messages.lock().unwrap().push(m.message.to_string()))));
    gl.enable_client_state(GL_VERTEX_ARRAY);
    // Two of three vertices are there; the third becomes the centre.
    gl.vertex_pointer(2, GL_FLOAT, 0, &[[-1.0f32, -1.0], [1.0, -1.0]]);
    gl.draw_arrays(GL_TRIANGLES, 0, 3);
    gl.check().unwrap();
    let pixels = gl.pixels();
    let lit = |x: usize, y: usize| pixels[(y * SIZE as usize + x) * 4] == 255;
    assert!(lit(16, 1) && lit(16, 14) && !lit(16, 18) && !lit(1, 8));
    let heard = heard.lock().unwrap();
    assert!(heard.len() == 1 && heard[0].contains("vertex array has only 2"), "{heard:?}");
}

#[test]
fn the_commands_of_ext_vertex_array_draw_as_those_of_opengl_1_1() {
    let set = |gl: &mut Context| {
        gl.vertex_pointer_ext(2, GL_SHORT, 0, 9, POSITIONS.as_flattened());
        gl.color_pointer_ext(4, GL_UNSIGNED_BYTE, 4, 0, COLORS.as_flattened());
    };
    let picture = |f: &dyn Fn(&mut Context)| {
        let mut gl = context();
        scaled(&mut gl);
        set(&mut gl);
        f(&mut gl);
        gl.check().unwrap();
        gl.pixels()
    };
    let draw = |gl: &mut Context| gl.draw_elements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, &INDICES);
    // The arrays are turned on and off by Enable and Disable.
    let enable = |gl: &mut Context| [GL_VERTEX_ARRAY_EXT, GL_COLOR_ARRAY_EXT].map(|array| gl.enable(array));
    assert!(
        picture(&|gl| {
            enable(gl);
            draw(gl);
        }) == wanted()
    );
    // They are client state: a list that is open does not keep the switch, it happens at once.
    assert!(
        picture(&|gl| {
            gl.new_list(1, GL_COMPILE);
            enable(gl);
            draw(gl);
            gl.end_list();
            gl.disable(GL_VERTEX_ARRAY_EXT);
            gl.call_list(1);
            assert!(!gl.is_enabled(GL_VERTEX_ARRAY_EXT) && gl.is_enabled(GL_COLOR_ARRAY_EXT));
        }) == wanted()
    );
    assert!(
        picture(&|gl| {
            enable(gl);
            gl.disable(GL_VERTEX_ARRAY_EXT);
            draw(gl);
        }) == context().pixels()
    );
}

#[test]
fn the_state_of_ext_vertex_array_can_be_asked_for() {
    let mut gl = context();
    let get = |gl: &mut Context, pname| {
        let mut value = [-1];
        gl.get_integerv(pname, &mut value);
        gl.check().unwrap();
        value[0]
    };
    gl.vertex_pointer_ext(2, GL_SHORT, 8, 5, POSITIONS.as_flattened());
    gl.normal_pointer_ext(GL_BYTE, 0, 6, &[0_i8; 27]);
    gl.color_pointer_ext(3, GL_FLOAT, 0, 7, &[0_f32; 27]);
    gl.index_pointer_ext(GL_SHORT, 0, 8, &[0_i16; 9]);
    gl.tex_coord_pointer_ext(1, GL_FLOAT, 0, 9, &[0_f32; 9]);
    gl.edge_flag_pointer_ext(0, 4, &[0_u8; 9]);
    for (pname, value) in [
        (GL_VERTEX_ARRAY_COUNT_EXT, 5),
        (GL_VERTEX_ARRAY_STRIDE_EXT, 8),
        (GL_NORMAL_ARRAY_COUNT_EXT, 6),
        (GL_COLOR_ARRAY_COUNT_EXT, 7),
        (GL_COLOR_ARRAY_SIZE_EXT, 3),
        (GL_INDEX_ARRAY_COUNT_EXT, 8),
        (GL_TEXTURE_COORD_ARRAY_COUNT_EXT, 9),
        (GL_EDGE_FLAG_ARRAY_COUNT_EXT, 4),
    ] {
        assert_eq!(get(&mut gl, pname), value, "{}", name(pname));
    }
    // A pointer command of OpenGL 1.1 promises nothing, and what is wrong changes nothing.
    gl.vertex_pointer(3, GL_FLOAT, 0, &[0_f32; 27]);
    assert_eq!(get(&mut gl, GL_VERTEX_ARRAY_COUNT_EXT), 0);
    gl.color_pointer_ext(4, GL_FLOAT, 0, -1, &[0_f32; 27]);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    gl.color_pointer_ext(2, GL_FLOAT, 0, 1, &[0_f32; 27]);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    assert_eq!((get(&mut gl, GL_COLOR_ARRAY_SIZE_EXT), get(&mut gl, GL_COLOR_ARRAY_COUNT_EXT)), (3, 7));
    // Arrays that the extension does not have are not enabled so.
    gl.enable(GL_FOG_COORD_ARRAY);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
}
