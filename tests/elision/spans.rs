//! The program that really runs can be seen and counted: rows of a large textured primitive go to a span kernel, which the
//! explanation names, and what the counters say of it is right.

use fixedgl::enums::*;
use fixedgl::{Config, Context};

const SIZE: [u32; 2] = [256, 64];
const PIXELS: u64 = SIZE[0] as u64 * SIZE[1] as u64;

/// A picture-filling quadrilateral at a depth, with one texel a pixel.
fn quad(gl: &mut Context, z: f32) {
    gl.begin(GL_QUADS);
    for [s, t] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        gl.tex_coord2f(s, t);
        gl.vertex3f(2.0 * s - 1.0, 2.0 * t - 1.0, z);
    }
    gl.end();
}

/// A context with an opaque texture, a depth test, and counting on.
fn textured(min_filter: GLenum, format: GLenum) -> Context {
    let mut gl = Context::with_config(SIZE[0], SIZE[1], Config::default().with_threads(1));
    let texels: Vec<u8> = (0..4 * 64 * 64).map(|i| (i * 7 % 251) as u8).collect();
    gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    gl.enable(GL_TEXTURE_2D);
    gl.enable(GL_DEPTH_TEST);
    gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.set_counting(true);
    gl
}

/// How many fragments the kernels of the plan and the stage that reads texels in batches have seen.
fn seen(gl: &mut Context, batches: &str) -> (u64, u64) {
    let kernels = gl.explain().span_kernels;
    let counters = gl.counters();
    let spans = kernels.iter().map(|kernel| counters.stage(kernel).fragments).sum();
    (spans, counters.stage(batches).fragments)
}

#[test]
fn the_kernel_of_a_large_textured_primitive_is_named_and_counted() {
    let rows = [
        (GL_LINEAR, GL_RGB8, ["LONG_LINEAR_RGB", "SHORT_LINEAR_RGB"], "BILINEAR_2D_RGB"),
        (GL_LINEAR, GL_RGBA8, ["LONG_LINEAR_RGBA", "SHORT_LINEAR_RGBA"], "BILINEAR_2D_RGBA"),
    ];
    for (filter, format, kernels, batches) in rows {
        let mut gl = textured(filter, format);
        let plan = gl.explain();
        assert!(plan.kept("span kernel"), "{plan}");
        assert_eq!(plan.span_kernels, kernels);
        quad(&mut gl, 0.0);
        let counters = gl.counters();
        assert_eq!([counters.fragments, counters.passed, counters.texels], [PIXELS, PIXELS, 4 * PIXELS], "{counters}");
        let (spans, rest) = seen(&mut gl, batches);
        assert_eq!(spans + rest, PIXELS, "{counters}");
        assert!(spans > rest, "{counters}");
        // What lies behind comes, fails and reads nothing.
        quad(&mut gl, 0.5);
        let behind = gl.counters();
        assert_eq!([behind.fragments, behind.passed, behind.texels], [2 * PIXELS, PIXELS, 4 * PIXELS], "{behind}");
        assert_eq!(gl.check(), Ok(()));
    }
}

#[test]
fn without_a_kernel_the_explanation_says_why() {
    let mut gl = textured(GL_LINEAR, GL_RGB8);
    gl.enable(GL_STENCIL_TEST);
    gl.stencil_func(GL_EQUAL, 0, 0xFF);
    let plan = gl.explain();
    assert!(plan.span_kernels.is_empty() && !plan.kept("span kernel"), "{plan}");
    assert_eq!(plan.decision("span kernel").map(|line| line.reason.as_str()), Some("there is a stencil test"));
    quad(&mut gl, 0.0);
    let counters = gl.counters();
    assert_eq!([counters.fragments, counters.passed, counters.texels], [PIXELS, PIXELS, 4 * PIXELS], "{counters}");
}

#[test]
fn short_rows_of_a_primitive_are_counted_together() {
    let mut gl = textured(GL_NEAREST, GL_RGBA8);
    gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.viewport(0, 0, 40, 40);
    quad(&mut gl, 0.0);
    let counters = gl.counters();
    assert_eq!([counters.fragments, counters.passed, counters.texels], [1600; 3], "{counters}");
    assert!(counters.stage("SHORT_NEAREST").fragments > 1000, "{counters}");
}
