//! What a machine or a program may do to the library (OpenGL 1.5, section 2.5): no thread to be had, no memory left, and
//! commands that ask for work without end. The rules are those of the page on state and errors.

use crate::allocator::{failing, within_budget};
use crate::support::Random;
use fixedgl::enums::*;
use fixedgl::{Config, Context, NULL, glu};
use std::process::Command;

const SIDE: i32 = 64;

fn alone() -> Context {
    Context::with_config(SIDE as u32, SIDE as u32, Config::default().with_threads(1))
}

/// A picture that is worth sharing in each of the three ways: many draws, a large draw, a long Begin/End.
fn shared_picture(threads: usize) -> Vec<u8> {
    let mut cx = Context::with_config(1024, 1024, Config::default().with_threads(threads));
    for k in 0..3u8 {
        cx.begin(GL_QUADS);
        for _ in 0..8 {
            cx.color3ub(255, 60 * k, 0);
            cx.vertex2f(-1.0, -1.0);
            cx.color3ub(0, 255, 0);
            cx.vertex2f(1.0, -1.0);
            cx.vertex2f(1.0, 1.0);
            cx.color3ub(0, 0, 255);
            cx.vertex2f(-1.0, 1.0);
        }
        cx.end();
        cx.finish();
    }
    let mut r = Random(77);
    let mut at = || r.range(-1.0, 1.0) as f32;
    let corners: Vec<[f32; 2]> = (0..10_000)
        .flat_map(|_| {
            let [x, y] = [at(), at()];
            [[x, y], [x + 0.02, y], [x, y + 0.02]]
        })
        .collect();
    cx.enable_client_state(GL_VERTEX_ARRAY);
    cx.vertex_pointer(2, GL_FLOAT, 0, &corners);
    cx.color3ub(200, 200, 10);
    cx.draw_arrays(GL_TRIANGLES, 0, corners.len() as i32);
    cx.begin(GL_TRIANGLES);
    for (i, [x, y]) in corners.iter().enumerate() {
        cx.color3ub((i / 3 % 256) as u8, 0, 99);
        cx.vertex2f(-x, *y);
    }
    cx.end();
    let picture = cx.pixels();
    assert_eq!(cx.check(), Ok(()));
    picture
}

#[test]
fn work_is_shared_or_done_by_the_calling_thread() {
    if std::env::var_os("FIXEDGL_NO_THREADS").is_some() {
        let other = std::thread::Builder::new().spawn(|| ());
        assert!(other.is_err(), "there is a thread to be had after all");
    }
    assert!(shared_picture(1) == shared_picture(5));
}

/// A thread that asks for more stack than there are addresses is refused, as one is where a container has no more threads.
#[cfg(target_pointer_width = "64")]
#[test]
fn without_a_thread_to_be_had_the_picture_is_the_same() {
    let program = std::env::current_exe().expect("a test knows its program");
    for test in ["hostile::work_is_shared_or_done_by_the_calling_thread", "fuzz::random_commands_do_no_harm"] {
        let run = Command::new(&program)
            .args(["--exact", test, "--test-threads=1"])
            .env("RUST_MIN_STACK", (1u64 << 47).to_string())
            .env("FIXEDGL_NO_THREADS", "1")
            .output()
            .expect("the program runs again");
        let said = String::from_utf8_lossy(&run.stdout);
        assert!(run.status.success() && said.contains("1 passed"), "{said}{}", String::from_utf8_lossy(&run.stderr));
    }
}

/// A list with some points, or none, that calls itself twice.
fn calls_itself_twice(cx: &mut Context, points: i32) {
    cx.new_list(1, GL_COMPILE);
    cx.begin(GL_POINTS);
    for _ in 0..points {
        cx.vertex2f(0.5, 0.5);
    }
    cx.end();
    cx.call_list(1);
    cx.call_list(1);
    cx.end_list();
    cx.call_list(1);
}

#[test]
fn no_command_asks_for_work_without_end() {
    type Row = (&'static str, fn(&mut Context));
    const MOST: i32 = i32::MAX;
    let rows: &[Row] = &[
        ("rows without pixels in a list, 3D", |cx| {
            cx.new_list(1, GL_COMPILE);
            cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA, 0, MOST, MOST, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.tex_sub_image_3d(GL_TEXTURE_3D, 0, 0, 0, 0, 0, MOST, MOST, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.bitmap(0, MOST, 0.0, 0.0, 0.0, 0.0, &[0u8; 4]);
            cx.draw_pixels(0, MOST, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.end_list();
            cx.call_list(1);
        }),
        ("rows without pixels", |cx| {
            cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA, 0, MOST, MOST, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.read_pixels(0, 0, 0, MOST, GL_RGBA, GL_UNSIGNED_BYTE, &mut [0u8; 4]);
            cx.read_pixels(0, 0, MOST, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut [0u8; 4]);
            glu::build_3d_mipmaps(cx, GL_TEXTURE_3D, GL_RGBA, 1, MOST, MOST, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            glu::build_2d_mipmaps(cx, GL_TEXTURE_2D, GL_RGBA, 1, MOST, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            glu::scale_image(
                cx,
                GL_RGBA,
                0,
                MOST,
                GL_UNSIGNED_BYTE,
                &[0u8; 4],
                0,
                MOST,
                GL_UNSIGNED_BYTE,
                &mut [0u8; 4],
            );
            cx.copy_pixels(0, 0, 0, MOST, GL_COLOR);
            cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, i32::MIN, i32::MIN, 64, 64, 0);
        }),
        ("a list that calls itself twice", |cx| calls_itself_twice(cx, 0)),
        ("a list of points that calls itself twice", |cx| calls_itself_twice(cx, 1000)),
        ("a draw without memory in a list that calls itself twice", |cx| {
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(2, GL_FLOAT, 0, &[0.5f32, 0.5]);
            cx.new_list(1, GL_COMPILE);
            cx.draw_arrays(GL_POINTS, 0, MOST);
            cx.call_list(1);
            cx.call_list(1);
            cx.end_list();
            cx.call_list(1);
        }),
        ("images and whole buffers in a list that calls itself twice", |cx| {
            cx.new_list(1, GL_COMPILE);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            cx.accum(GL_LOAD, 1.0);
            cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 64, 64, 0);
            cx.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 64, 64);
            cx.call_list(1);
            cx.call_list(1);
            cx.end_list();
            cx.call_list(1);
        }),
        ("state in a list that calls itself twice", |cx| {
            cx.new_list(1, GL_COMPILE);
            for cap in [GL_LIGHTING, GL_FOG, GL_BLEND] {
                cx.enable(cap);
                cx.rectf(0.0, 0.0, 0.1, 0.1);
                cx.disable(cap);
            }
            cx.call_list(1);
            cx.call_list(1);
            cx.end_list();
            cx.call_list(1);
        }),
        ("a list that calls itself by many names", |cx| {
            cx.new_list(1, GL_COMPILE);
            cx.call_lists(10_000, GL_UNSIGNED_BYTE, &[1u8; 10_000]);
            cx.end_list();
            cx.call_list(1);
        }),
        ("ten thousand draws of all elements there could be", |cx| {
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(2, GL_FLOAT, 0, &[0.5f32, 0.5]);
            cx.multi_draw_arrays(GL_POINTS, &[0; 10_000], &[MOST; 10_000], 10_000);
        }),
        ("draws from no memory", |cx| {
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(4, GL_DOUBLE, 0, NULL);
            cx.draw_arrays(GL_TRIANGLES, 0, MOST);
            cx.draw_arrays(GL_POLYGON, MOST, MOST);
            cx.new_list(1, GL_COMPILE);
            cx.draw_arrays(GL_TRIANGLE_STRIP, 0, MOST);
            cx.end_list();
        }),
        ("quadrics of all slices there could be", |cx| {
            let mut quadric = glu::Quadric::new();
            quadric.sphere(cx, 1.0, MOST, MOST);
            quadric.draw_style(glu::GLU_LINE);
            quadric.disk(cx, 0.0, 1.0, MOST, 1);
        }),
        ("meshes and pixels without end", |cx| {
            cx.map2f(GL_MAP2_VERTEX_3, 0.0, 1.0, 3, 2, 0.0, 1.0, 6, 2, &[0.5f32; 12]);
            cx.enable(GL_MAP2_VERTEX_3);
            cx.eval_mesh2(GL_FILL, i32::MIN, MOST, i32::MIN, MOST);
            cx.eval_mesh2(GL_LINE, 0, 0, 0, MOST);
            cx.eval_mesh1(GL_LINE, i32::MIN, MOST);
            cx.raster_pos2f(0.0, 0.0);
            cx.pixel_zoom(f32::MAX, f32::MAX);
            cx.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.copy_pixels(i32::MIN, i32::MIN, MOST, MOST, GL_COLOR);
            cx.pixel_zoom(1e-30, -1e-30);
            cx.copy_pixels(0, 0, MOST, MOST, GL_COLOR);
            cx.feedback_buffer(MOST, GL_2D);
            cx.select_buffer(MOST);
        }),
        ("names and lists", |cx| {
            let first = cx.gen_lists(MOST);
            cx.delete_lists(first, MOST);
            cx.delete_lists(0, MOST);
        }),
        ("an image of the greatest size without memory", |cx| {
            for format in [GL_RGBA8, GL_RGBA16] {
                cx.tex_image_3d(GL_TEXTURE_3D, 0, format, 1024, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            }
        }),
        ("a buffer object of the greatest size without memory", |cx| {
            cx.bind_buffer(GL_ARRAY_BUFFER, 1);
            cx.buffer_data(GL_ARRAY_BUFFER, isize::MAX, NULL, GL_STATIC_DRAW);
            cx.buffer_data(GL_ARRAY_BUFFER, MOST as isize, NULL, GL_STATIC_DRAW);
        }),
    ];
    for (name, command) in rows {
        let mut cx = alone();
        within_budget(name, || command(&mut cx));
        within_budget(name, || cx.finish());
    }
}

#[test]
fn lists_that_a_program_means_are_carried_out_whole() {
    // 64 x 64 x 64 calls of a list of 16 points: four million vertices from a hundred commands.
    let mut cx = alone();
    cx.new_list(1, GL_COMPILE);
    cx.begin(GL_POINTS);
    (0..16).for_each(|_| cx.vertex2f(0.5, 0.5));
    cx.end();
    cx.end_list();
    for list in 2..=4 {
        cx.new_list(list, GL_COMPILE);
        (0..64).for_each(|_| cx.call_list(list - 1));
        cx.end_list();
    }
    cx.call_list(4);
    assert_eq!(cx.check(), Ok(()));
}

/// A context whose pools are as large as they become.
fn warm() -> Context {
    let mut cx = alone();
    cx.begin(GL_TRIANGLES);
    for i in 0..30_000 {
        cx.color3ub(i as u8, 0, 0);
        cx.vertex2f((i % 7) as f32 / 7.0, (i % 11) as f32 / 11.0);
    }
    cx.end();
    cx.finish();
    let _ = cx.check();
    cx
}

const MANY: usize = 1 << 20;

/// Memory of a program.
struct Memory {
    bytes: Vec<u8>,
    floats: Vec<f32>,
    names: Vec<u32>,
}

#[test]
fn a_large_allocation_that_fails_is_out_of_memory() {
    type Row = (&'static str, fn(&mut Context, &mut Memory) -> bool);
    /// Whether an error of GL says it.
    fn said(cx: &mut Context) -> bool {
        cx.check().is_err_and(|e| e.code == GL_OUT_OF_MEMORY)
    }
    let rows: &[Row] = &[
        ("TexImage2D", |cx, m| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 512, 512, 0, GL_RGBA, GL_UNSIGNED_BYTE, &m.bytes);
            said(cx)
        }),
        ("TexImage3D of floats", |cx, m| {
            cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA16, 64, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, &m.bytes);
            said(cx)
        }),
        ("CompressedTexImage2D", |cx, m| {
            let format = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
            cx.compressed_tex_image_2d(GL_TEXTURE_2D, 0, format, 1024, 1024, 0, MANY as i32, &m.bytes);
            said(cx)
        }),
        ("CopyTexImage2D", |cx, _| {
            cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 512, 512, 0);
            said(cx)
        }),
        ("GENERATE_MIPMAP", |cx, m| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
            cx.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
            cx.get_tex_image(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut m.bytes);
            said(cx)
        }),
        ("BufferData", |cx, _| {
            cx.bind_buffer(GL_ARRAY_BUFFER, 1);
            cx.buffer_data(GL_ARRAY_BUFFER, MANY as isize, NULL, GL_STATIC_DRAW);
            said(cx)
        }),
        ("VertexPointer", |cx, m| {
            cx.vertex_pointer(2, GL_FLOAT, 0, &m.floats);
            said(cx)
        }),
        ("an image in a list", |cx, m| {
            cx.new_list(1, GL_COMPILE);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 512, 512, 0, GL_RGBA, GL_UNSIGNED_BYTE, &m.bytes);
            cx.end_list();
            said(cx)
        }),
        ("an image that is an error in a list", |cx, m| {
            cx.new_list(1, GL_COMPILE);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, -1, 512, 0, GL_RGBA, GL_UNSIGNED_BYTE, &m.bytes);
            cx.end_list();
            said(cx)
        }),
        ("names in a list", |cx, m| {
            cx.new_list(1, GL_COMPILE);
            cx.call_lists(MANY as i32, GL_UNSIGNED_BYTE, &m.bytes);
            cx.end_list();
            said(cx)
        }),
        ("names", |cx, m| {
            cx.gen_textures(100_000, &mut m.names);
            cx.gen_buffers(100_000, &mut m.names);
            cx.gen_queries(100_000, &mut m.names);
            cx.gen_vertex_arrays(100_000, &mut m.names);
            said(cx)
        }),
        ("a framebuffer and its values", |cx, _| {
            // The error of resize is its result.
            let resized = cx.resize(512, 512).is_err_and(|e| e.code == GL_OUT_OF_MEMORY);
            cx.accum(GL_LOAD, 1.0);
            let (pixels, depths, stencils) = (cx.pixels(), cx.depths(), cx.stencils());
            let said = said(cx);
            assert!(said || resized || !(pixels.is_empty() || depths.is_empty() || stencils.is_empty()));
            said || resized
        }),
        ("mipmaps of GLU", |cx, m| {
            let px = &m.bytes[..];
            let code = glu::build_2d_mipmaps(cx, GL_TEXTURE_2D, GL_RGBA8, 700, 700, GL_RGBA, GL_UNSIGNED_BYTE, px);
            let code = if code == 0 {
                glu::build_2d_mipmaps(cx, GL_TEXTURE_2D, GL_RGBA8, 512, 512, GL_RGBA, GL_UNSIGNED_BYTE, px)
            } else {
                code
            };
            said(cx) || code as u32 == glu::GLU_OUT_OF_MEMORY
        }),
    ];
    for (name, command) in rows {
        let mut failures = 0;
        for n in 1.. {
            let mut cx = warm();
            // What the program itself allocates must not fail.
            let mut memory = Memory { bytes: vec![9; 2 * MANY], floats: vec![0.5; MANY], names: vec![0; 100_000] };
            let (out_of_memory, failed) = failing(n, || command(&mut cx, &mut memory));
            if !failed {
                assert!(!out_of_memory, "{name}: out of memory although nothing has failed");
                break;
            }
            failures += 1;
            assert!(out_of_memory, "{name}: allocation {n} has failed and nothing says so");
            cx.end_list();
            cx.disable_client_state(GL_VERTEX_ARRAY);
            cx.resize(16, 16).expect("a small framebuffer");
            cx.viewport(0, 0, 16, 16);
            let _ = cx.check();
            cx.clear_color(0.0, 0.0, 1.0, 1.0);
            cx.clear(GL_COLOR_BUFFER_BIT);
            cx.color3ub(0, 255, 0);
            cx.rectf(-1.0, -1.0, 1.0, 1.0);
            assert!(cx.pixels().chunks(4).all(|p| p == [0, 255, 0, 255]), "{name}: the context no longer draws");
            assert_eq!(cx.check(), Ok(()), "{name}");
        }
        assert!(failures > 0, "{name}: no large allocation to fail");
    }
}

#[test]
fn a_list_that_finds_no_memory_to_be_made_faster_is_kept_as_it_is() {
    for n in 1.. {
        let mut cx = warm();
        cx.clear(GL_COLOR_BUFFER_BIT);
        cx.color3ub(0, 255, 0);
        let (_, failed) = failing(n, || {
            cx.new_list(1, GL_COMPILE);
            cx.begin(GL_QUADS);
            for i in 0..10_000 {
                let side = if i == 0 { 1.0 } else { 0.5 };
                [[-side, -side], [side, -side], [side, side], [-side, side]].iter().for_each(|v| cx.vertex2fv(v));
            }
            cx.end();
            cx.end_list();
        });
        let first = cx.check();
        cx.call_list(1);
        // A command that found no room in the list has said so and is not in it.
        assert!(
            first.is_err_and(|e| e.code == GL_OUT_OF_MEMORY) || cx.pixels().chunks(4).all(|p| p == [0, 255, 0, 255])
        );
        if !failed {
            break;
        }
    }
}

#[test]
fn a_callback_that_panics_loses_nothing() {
    use fixedgl::c::*;
    let panics = |command: fn()| std::panic::catch_unwind(command).is_err();
    let value = |name: GLenum| {
        let mut value = [0];
        glGetIntegerv(name, &mut value);
        value[0]
    };
    let mut cx = alone();
    cx.set_debug_callback(Some(Box::new(|_| panic!("meant"))));
    make_current(cx);
    assert!(panics(|| glEnable(1)));
    assert_eq!(glGetError(), GL_INVALID_ENUM, "the error and the context are there");
    glNewList(1, GL_COMPILE);
    glEnable(1);
    glEndList();
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
    glNewList(2, GL_COMPILE_AND_EXECUTE);
    assert!(panics(|| glCallList(1)));
    assert_eq!((value(GL_LIST_INDEX), value(GL_UNPACK_ROW_LENGTH)), (2, 7), "the open list and the unpack state");
    glEndList();
    assert_eq!(glGetError(), GL_INVALID_ENUM);
    let mut cx = take_current().expect("still current");
    cx.set_debug_callback(None);
    cx.set_trace_callback(Some(Box::new(|call| assert_ne!(call.name, "glFinish", "meant"))));
    make_current(cx);
    assert!(panics(glFinish));
    assert!(panics(|| assert_eq!(with_current(|_| -> u8 { panic!("meant") }), None)));
    glFlush();
    assert_eq!((glGetError(), calls_without_context()), (GL_NO_ERROR, 0));
    assert!(take_current().is_some());
}

#[test]
fn a_context_is_made_on_a_small_stack() {
    let make = || {
        fixedgl::c::make_current(alone());
        fixedgl::c::take_current().is_some()
    };
    let made = std::thread::Builder::new().stack_size(96 << 10).spawn(make).expect("a thread");
    assert!(made.join().expect("it ends"));
}
