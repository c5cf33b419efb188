//! Chapter of the table: vertex arrays, buffer objects, pixel-store and client state (OpenGL 1.5, sections 2.8, 2.9,
//! 3.6.1 and 6.1.14). Client state is never compiled into a list; a draw is compiled as the vertices it stands for.

macro_rules! arrays_table { ($generate:ident) => { $generate! {
    title "Vertex arrays, buffer objects and client state (sections 2.8, 2.9)";
    canonical {}
    commands {}
    forms {}
    context {
        /// Issues the vertex of an index of the enabled arrays (section 2.8).
        begin glArrayElement | glArrayElementEXT array_element(i: i32);
        /// Draws a primitive of consecutive elements of the enabled arrays (section 2.8). `INVALID_VALUE` for a negative
        /// count.
        #[doc = include_str!("examples/draw_arrays.md")]
        list glDrawArrays | glDrawArraysEXT draw_arrays(mode: enum, first: i32, count: i32);
        /// Draws a primitive of elements of the enabled arrays by their indices (section 2.8).
        #[doc = include_str!("examples/draw_elements.md")]
        list glDrawElements draw_elements(mode: enum, count: i32, type_: enum, indices: (indices count, type_));
        /// Draws elements whose indices lie in a range (section 2.8). `INVALID_VALUE` if `end` lies before `start`.
        list glDrawRangeElements | glDrawRangeElementsEXT draw_range_elements(mode: enum, start: uint, end: uint,
            count: i32, type_: enum, indices: (indices count, type_));
        /// Draws several primitives of consecutive elements (section 2.8).
        list glMultiDrawArrays | glMultiDrawArraysEXT multi_draw_arrays(mode: enum, first: (upto i32: count(drawcount)),
            count: (upto i32: count(drawcount)), drawcount: i32);
    }
    now {
        /// Sets the array of vertices (section 2.8).
        now glVertexPointer vertex_pointer(size: i32, type_: enum, stride: i32, pointer: array);
        /// Sets the array of normals (section 2.8).
        now glNormalPointer normal_pointer(type_: enum, stride: i32, pointer: array);
        /// Sets the array of colours (section 2.8).
        now glColorPointer color_pointer(size: i32, type_: enum, stride: i32, pointer: array);
        /// Sets the array of secondary colours (section 2.8).
        now glSecondaryColorPointer | glSecondaryColorPointerEXT secondary_color_pointer(size: i32, type_: enum,
            stride: i32, pointer: array);
        /// Sets the array of colour indices (section 2.8).
        now glIndexPointer index_pointer(type_: enum, stride: i32, pointer: array);
        /// Sets the array of fog coordinates (section 2.8).
        now glFogCoordPointer | glFogCoordPointerEXT fog_coord_pointer(type_: enum, stride: i32, pointer: array);
        /// Sets the array of texture coordinates of the client's active unit (section 2.8).
        now glTexCoordPointer tex_coord_pointer(size: i32, type_: enum, stride: i32, pointer: array);
        /// Sets the array of edge flags (section 2.8).
        now glEdgeFlagPointer edge_flag_pointer(stride: i32, pointer: array);
        /// Sets and enables arrays that share one piece of memory (section 2.8).
        now glInterleavedArrays interleaved_arrays(format: enum, stride: i32, pointer: array);
        /// Sets the array of vertices, of which the first `count` never change (EXT_vertex_array); the promise is not
        /// needed. `INVALID_VALUE` for a negative count.
        now glVertexPointerEXT vertex_pointer_ext(size: i32, type_: enum, stride: i32, count: i32, pointer: array);
        /// Sets the array of normals as `glVertexPointerEXT` does (EXT_vertex_array).
        now glNormalPointerEXT normal_pointer_ext(type_: enum, stride: i32, count: i32, pointer: array);
        /// Sets the array of colours as `glVertexPointerEXT` does (EXT_vertex_array).
        now glColorPointerEXT color_pointer_ext(size: i32, type_: enum, stride: i32, count: i32, pointer: array);
        /// Sets the array of colour indices as `glVertexPointerEXT` does (EXT_vertex_array).
        now glIndexPointerEXT index_pointer_ext(type_: enum, stride: i32, count: i32, pointer: array);
        /// Sets the array of texture coordinates as `glVertexPointerEXT` does (EXT_vertex_array).
        now glTexCoordPointerEXT tex_coord_pointer_ext(size: i32, type_: enum, stride: i32, count: i32, pointer: array);
        /// Sets the array of edge flags as `glVertexPointerEXT` does (EXT_vertex_array).
        now glEdgeFlagPointerEXT edge_flag_pointer_ext(stride: i32, count: i32, pointer: array);
        /// Turns an array on (section 2.8).
        now glEnableClientState enable_client_state(array: enum);
        /// Turns an array off (section 2.8).
        now glDisableClientState disable_client_state(array: enum);
        /// Selects the unit of texture coordinate arrays (section 2.8).
        now glClientActiveTexture | glClientActiveTextureARB client_active_texture(texture: enum);
        /// Saves client state (section 6.1.14). `STACK_OVERFLOW` on a full stack.
        now glPushClientAttrib push_client_attrib(mask: bits);
        /// Restores client state (section 6.1.14). `STACK_UNDERFLOW` on an empty stack.
        now glPopClientAttrib pop_client_attrib();
        /// Promises that arrays do not change (EXT_compiled_vertex_array); the promise is not needed.
        now glLockArraysEXT lock_arrays(first: i32, count: i32);
        /// Takes the promise of LockArrays back.
        now glUnlockArraysEXT unlock_arrays();
        /// Sets how pixels lie in memory (section 3.6.1). `INVALID_VALUE` for numbers out of range.
        now glPixelStorei pixel_storei(pname: enum, param: i32);
        /// Sets how pixels lie in memory (section 3.6.1). `INVALID_VALUE` for numbers out of range.
        now glPixelStoref pixel_storef(pname: enum, param: f32);
        /// Binds a buffer object and makes it if it is new (section 2.9).
        now glBindBuffer | glBindBufferARB bind_buffer(target: enum, buffer: uint);
        /// Deletes buffer objects; names that do not exist and 0 are ignored (section 2.9).
        now glDeleteBuffers | glDeleteBuffersARB delete_buffers(n: i32, buffers: (slice u32: count(n)));
        /// Makes names of buffer objects that are not in use (section 2.9).
        now glGenBuffers | glGenBuffersARB gen_buffers(n: i32, buffers: (out u32: count(n)));
        /// Whether a name is that of a buffer object (section 6.1.13).
        now glIsBuffer | glIsBufferARB is_buffer(buffer: uint) -> bool;
        /// Gives a buffer object its size and content (section 2.9). `OUT_OF_MEMORY` if there is not enough.
        now glBufferData | glBufferDataARB buffer_data(target: enum, size: size, data: (bytes size), usage: enum);
        /// Replaces a part of a buffer object (section 2.9). `INVALID_VALUE` if it lies outside.
        now glBufferSubData | glBufferSubDataARB buffer_sub_data(target: enum, offset: size, size: size,
            data: (bytes size));
        /// Reads a part of a buffer object (section 6.1.13). `INVALID_VALUE` if it lies outside.
        now glGetBufferSubData | glGetBufferSubDataARB get_buffer_sub_data(target: enum, offset: size, size: size,
            data: (bytes_out size));
        /// Binds a vertex array object (ARB_vertex_array_object). `INVALID_OPERATION` for a name that was not generated.
        now glBindVertexArray bind_vertex_array(array: uint);
        /// Deletes vertex array objects; names that do not exist and 0 are ignored (ARB_vertex_array_object).
        now glDeleteVertexArrays delete_vertex_arrays(n: i32, arrays: (slice u32: count(n)));
        /// Makes names of vertex array objects (ARB_vertex_array_object).
        now glGenVertexArrays gen_vertex_arrays(n: i32, arrays: (out u32: count(n)));
        /// Whether a name is that of a vertex array object that has been bound (ARB_vertex_array_object).
        now glIsVertexArray is_vertex_array(array: uint) -> bool;
        /// Ends the mapping of a buffer object (section 2.9). `INVALID_OPERATION` if it is not mapped.
        now glUnmapBuffer | glUnmapBufferARB unmap_buffer(target: enum) -> bool;
    }
    queries {
        family "A property of a buffer object (section 6.1.13)." {
            glGetBufferParameteriv | glGetBufferParameterivARB get_buffer_parameteriv(target: enum, pname: enum) -> i32
                => get_buffer_parameter(target, pname);
        }
        family "The address of a mapped buffer object, or 0 (section 6.1.13)." {
            glGetBufferPointerv | glGetBufferPointervARB get_buffer_pointerv(target: enum, pname: enum) -> usize
                => get_buffer_pointer(target, pname);
        }
    }
    answers {
        get_buffer_parameter(target: enum, pname: enum);
        get_buffer_pointer(target: enum, pname: enum);
    }
    manual {
        list glMultiDrawElements | glMultiDrawElementsEXT;
        now glMapBuffer | glMapBufferARB;
    }
} } }

pub(crate) use arrays_table;
