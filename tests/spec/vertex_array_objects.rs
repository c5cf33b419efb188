//! Vertex array objects (ARB_vertex_array_object): what an object keeps, what belongs to the context, names, errors.

use fixedgl::Context;
use fixedgl::enums::*;

fn integer(gl: &mut Context, pname: GLenum) -> i32 {
    let mut value = [-1; 4];
    gl.get_integerv(pname, &mut value);
    value[0]
}

/// A buffer object with values.
fn buffer(gl: &mut Context, target: GLenum, bytes: &[u8]) -> u32 {
    let mut name = [0];
    gl.gen_buffers(1, &mut name);
    gl.bind_buffer(target, name[0]);
    gl.buffer_data(target, bytes.len() as isize, bytes, GL_STATIC_DRAW);
    name[0]
}

fn bytes(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_ne_bytes()).collect()
}

#[test]
fn an_object_keeps_its_arrays_and_its_buffer_of_indices() {
    let mut gl = Context::new(16, 16);
    let mut names = [0; 2];
    gl.gen_vertex_arrays(2, &mut names);
    assert!(names[0] != 0 && names[0] != names[1]);
    assert!(!gl.is_vertex_array(names[0]), "a name is no object before it is bound");
    // A triangle on the left in one object, one on the right in the other.
    for (array, x, color) in [(names[0], -1.0, [1.0, 0.0, 0.0]), (names[1], 0.0, [0.0, 1.0, 0.0])] {
        gl.bind_vertex_array(array);
        assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_BINDING), array.cast_signed());
        assert_eq!(integer(&mut gl, GL_ELEMENT_ARRAY_BUFFER_BINDING), 0, "a new object has the initial state");
        assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY), 0);
        buffer(&mut gl, GL_ARRAY_BUFFER, &bytes(&[x, -1.0, x + 1.0, -1.0, x + 1.0, 1.0, x, 1.0]));
        gl.vertex_pointer(2, GL_FLOAT, 0, 0);
        gl.enable_client_state(GL_VERTEX_ARRAY);
        buffer(&mut gl, GL_ARRAY_BUFFER, &bytes(&[color; 4].concat()));
        gl.color_pointer(3, GL_FLOAT, 0, 0);
        gl.enable_client_state(GL_COLOR_ARRAY);
        buffer(&mut gl, GL_ELEMENT_ARRAY_BUFFER, &[0, 1, 2, 3]);
    }
    let bound = integer(&mut gl, GL_ARRAY_BUFFER_BINDING);
    gl.bind_vertex_array(0);
    assert_eq!(integer(&mut gl, GL_ARRAY_BUFFER_BINDING), bound, "that binding is the context's");
    assert_eq!(integer(&mut gl, GL_COLOR_ARRAY), 0);
    for array in names {
        gl.bind_vertex_array(array);
        gl.draw_elements(GL_QUADS, 4, GL_UNSIGNED_BYTE, 0);
    }
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    for (i, pixel) in gl.pixels().chunks(4).enumerate() {
        let want = if i % 16 < 8 { [255, 0, 0, 255] } else { [0, 255, 0, 255] };
        assert_eq!(pixel, want, "pixel {i}");
    }
}

#[test]
fn deleting_the_bound_object_binds_object_0() {
    let mut gl = Context::new(4, 4);
    gl.bind_buffer(GL_ARRAY_BUFFER, 7);
    gl.vertex_pointer(2, GL_FLOAT, 12, 0);
    let mut name = [0];
    gl.gen_vertex_arrays(1, &mut name);
    gl.bind_vertex_array(name[0]);
    assert!(gl.is_vertex_array(name[0]));
    gl.vertex_pointer(4, GL_SHORT, 16, 0);
    gl.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.bind_vertex_array(0);
    assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_STRIDE), 12);
    gl.pop_client_attrib();
    assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_BINDING), name[0].cast_signed());
    assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_STRIDE), 16);
    gl.delete_vertex_arrays(1, &name);
    assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_BINDING), 0);
    assert_eq!(integer(&mut gl, GL_VERTEX_ARRAY_STRIDE), 12);
    assert!(!gl.is_vertex_array(name[0]));
    assert_eq!(gl.get_error(), GL_NO_ERROR);
}

#[test]
fn errors_are_those_of_the_extension() {
    let mut gl = Context::new(4, 4);
    gl.bind_vertex_array(99);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    gl.gen_vertex_arrays(-1, &mut [0u32; 0]);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    gl.delete_vertex_arrays(-1, &[0u32; 0]);
    assert_eq!(gl.get_error(), GL_INVALID_VALUE);
    let mut name = [0];
    gl.gen_vertex_arrays(1, &mut name);
    gl.bind_vertex_array(name[0]);
    gl.vertex_pointer(2, GL_FLOAT, 0, &[0.0f32; 8]);
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION, "arrays of an object lie in buffer objects");
    gl.vertex_pointer(2, GL_FLOAT, 0, 0);
    assert_eq!(gl.get_error(), GL_NO_ERROR, "null is no memory");
    gl.begin(GL_POINTS);
    gl.bind_vertex_array(0);
    gl.end();
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
}
