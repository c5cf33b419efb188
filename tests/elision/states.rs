//! Random states. Values are picked where a plan decides something: exact zeros and ones, equal w, factors that cancel,
//! tests that always pass, coordinates inside and outside of [0, 1]; and among them values that only nearly are.

use super::random::Random;
use fixedgl::Context;
use fixedgl::enums::*;

const FUNCS: &[GLenum] = &[GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS];
const OPS: &[GLenum] = &[GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP];
const WRAPS: &[GLenum] = &[GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT];
const FILTERS: &[GLenum] = &[
    GL_NEAREST,
    GL_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_LINEAR_MIPMAP_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
];
const SOURCES: &[GLenum] = &[
    GL_ZERO,
    GL_ONE,
    GL_DST_COLOR,
    GL_ONE_MINUS_DST_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_ALPHA,
    GL_SRC_ALPHA_SATURATE,
    GL_CONSTANT_COLOR,
];
const DESTINATIONS: &[GLenum] = &[
    GL_ZERO,
    GL_ONE,
    GL_SRC_COLOR,
    GL_ONE_MINUS_SRC_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_ALPHA,
    GL_ONE_MINUS_CONSTANT_ALPHA,
];
const ENVS: &[GLenum] = &[GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE, GL_COMBINE4_NV];

/// What a texture of the test is: target, internal format, size, whether it has all levels.
pub const TEXTURES: &[(GLenum, GLenum, [i32; 3], bool)] = &[
    (GL_TEXTURE_2D, GL_RGBA8, [16, 16, 1], true),
    (GL_TEXTURE_2D, GL_RGB8, [64, 32, 1], true),
    (GL_TEXTURE_2D, GL_LUMINANCE8, [8, 8, 1], true),
    (GL_TEXTURE_2D, GL_RGBA8, [13, 7, 1], true),
    (GL_TEXTURE_2D, GL_ALPHA8, [32, 4, 1], false),
    (GL_TEXTURE_2D, GL_LUMINANCE_ALPHA, [1, 1, 1], true),
    (GL_TEXTURE_2D, GL_INTENSITY8, [4, 64, 1], true),
    (GL_TEXTURE_1D, GL_RGBA8, [32, 1, 1], true),
    (GL_TEXTURE_3D, GL_RGBA8, [8, 8, 4], true),
    (GL_TEXTURE_CUBE_MAP, GL_RGBA8, [8, 8, 1], true),
];

/// Makes the textures; texture n has name n + 1.
pub fn textures(cx: &mut Context) {
    let mut r = Random::new(77);
    for (name, (target, internal, size, mipmap)) in (1..).zip(TEXTURES) {
        cx.bind_texture(*target, name);
        cx.tex_parameteri(*target, GL_GENERATE_MIPMAP, i32::from(*mipmap));
        let count = 4 * size[0] * size[1] * size[2];
        // One texture is opaque: what alpha decides differs.
        let opaque = name == 1;
        let mut texels = |_| {
            let all: Vec<u8> =
                (0..count).map(|i| if opaque && i % 4 == 3 { 255 } else { r.below(256) as u8 }).collect();
            all
        };
        let [w, h, d] = *size;
        match *target {
            GL_TEXTURE_1D => cx.tex_image_1d(*target, 0, *internal, w, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels(0)),
            GL_TEXTURE_3D => cx.tex_image_3d(*target, 0, *internal, w, h, d, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels(0)),
            GL_TEXTURE_CUBE_MAP => {
                for face in GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z {
                    cx.tex_image_2d(face, 0, *internal, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels(0));
                }
            }
            _ => cx.tex_image_2d(*target, 0, *internal, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels(0)),
        }
    }
    assert_eq!(cx.check(), Ok(()));
}

/// Sets a random state.
pub fn state(cx: &mut Context, r: &mut Random) {
    tests(cx, r);
    store(cx, r);
    cx.shade_model(r.of(&[GL_SMOOTH, GL_SMOOTH, GL_FLAT]));
    if r.once_in(6) {
        cx.enable(GL_CULL_FACE);
        cx.cull_face(r.of(&[GL_FRONT, GL_BACK]));
    }
    if r.once_in(3) {
        fog(cx, r);
    }
    if r.once_in(6) {
        cx.enable(GL_COLOR_SUM);
    }
    if r.once_in(5) {
        light(cx, r);
    }
    if r.once_in(8) {
        cx.enable(GL_SCISSOR_TEST);
        cx.scissor(r.below(20) as i32, r.below(8) as i32, 10 + r.below(80) as i32, 4 + r.below(20) as i32);
    }
    if r.once_in(8) {
        cx.enable(GL_POLYGON_OFFSET_FILL);
        cx.polygon_offset(r.of(&[0.0, 1.0, -2.0]), r.of(&[0.0, 1.0, -30.0]));
    }
    if r.once_in(6) {
        cx.point_size(r.of(&[1.0, 3.5, 12.0]));
        cx.enable(GL_POINT_SPRITE_ARB);
        cx.tex_envi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, r.below(2) as i32);
    }
    if r.once_in(12) {
        cx.enable(GL_CLIP_PLANE0);
        cx.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.3, 0.0, 0.2]);
    }
    let units = r.of(&[0, 1, 1, 1, 1, 2, 2, 3]);
    for unit in 0..units {
        texture_unit(cx, r, unit);
    }
    cx.active_texture(GL_TEXTURE0);
    matrices(cx, r);
}

fn tests(cx: &mut Context, r: &mut Random) {
    if r.once_in(2) {
        cx.enable(GL_DEPTH_TEST);
        let any = r.of(FUNCS);
        cx.depth_func(r.of(&[GL_LESS, GL_LEQUAL, GL_LEQUAL, GL_ALWAYS, any]));
        cx.depth_mask(!r.once_in(4));
    }
    if r.once_in(5) {
        cx.enable(GL_STENCIL_TEST);
        cx.stencil_func(r.of(FUNCS), r.below(6) as i32, r.of(&[u32::MAX, 3, 0]));
        cx.stencil_op(r.of(OPS), r.of(OPS), r.of(OPS));
        cx.stencil_mask(r.of(&[u32::MAX, 0x0F, 0]));
        if r.once_in(2) {
            cx.stencil_func_separate(r.of(FUNCS), r.of(FUNCS), r.below(6) as i32, r.of(&[u32::MAX, 3]));
            cx.stencil_op_separate(r.of(&[GL_FRONT, GL_BACK]), r.of(OPS), r.of(OPS), r.of(OPS));
        }
    }
    if r.once_in(4) {
        cx.enable(GL_ALPHA_TEST);
        cx.alpha_func(r.of(FUNCS), r.of(&[0.0, 0.5, 1.0, 254.0 / 255.0]));
    }
}

fn store(cx: &mut Context, r: &mut Random) {
    if r.once_in(3) {
        cx.enable(GL_BLEND);
        let (src, dst) = match r.below(3) {
            0 => (GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
            1 => r.of(&[(GL_ONE, GL_ZERO), (GL_ONE, GL_ONE), (GL_ZERO, GL_ONE), (GL_ONE, GL_ONE_MINUS_SRC_ALPHA)]),
            _ => (r.of(SOURCES), r.of(DESTINATIONS)),
        };
        cx.blend_func(src, dst);
        let [red, green, blue, alpha] = r.color();
        cx.blend_color(red, green, blue, alpha);
        let other = r.of(&[GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX]);
        let equation = r.of(&[GL_FUNC_ADD, GL_FUNC_ADD, GL_FUNC_ADD, other]);
        cx.blend_equation_separate(equation, if r.once_in(8) { GL_MAX } else { equation });
    }
    if r.once_in(12) {
        cx.enable(GL_COLOR_LOGIC_OP);
        cx.logic_op(GL_CLEAR + r.below(16) as u32);
    }
    if r.once_in(6) {
        let all = r.once_in(4);
        let mut bit = || all || r.once_in(2);
        let (red, green, blue, alpha) = (bit(), bit(), bit(), bit());
        cx.color_mask(red, green, blue, alpha);
    }
}

fn fog(cx: &mut Context, r: &mut Random) {
    cx.enable(GL_FOG);
    cx.fogi(GL_FOG_MODE, r.of(&[GL_LINEAR, GL_EXP, GL_EXP2]));
    cx.fogf(GL_FOG_DENSITY, r.of(&[0.0, 0.2, 1.5, 1e-7]));
    let (start, end) = r.of(&[(0.0, 1.0), (0.5, 4.0), (2.0, 2.0), (3.0, 1.0)]);
    cx.fogf(GL_FOG_START, start);
    cx.fogf(GL_FOG_END, end);
    cx.fogfv(GL_FOG_COLOR, &r.color());
    cx.fogi(GL_FOG_COORD_SRC, r.of(&[GL_FRAGMENT_DEPTH, GL_FRAGMENT_DEPTH, GL_FOG_COORD]));
    cx.fogi(GL_FOG_DISTANCE_MODE_NV, r.of(&[GL_EYE_PLANE_ABSOLUTE_NV, GL_EYE_RADIAL_NV, GL_EYE_PLANE]));
}

fn light(cx: &mut Context, r: &mut Random) {
    cx.enable(GL_LIGHTING);
    cx.enable(GL_LIGHT0);
    cx.lightfv(GL_LIGHT0, GL_POSITION, &[0.3, 0.5, 1.0, r.of(&[0.0, 1.0])]);
    cx.lightfv(GL_LIGHT0, GL_SPECULAR, &r.of(&[[0.0; 4], [1.0; 4]]));
    cx.lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, r.of(&[0.0, 0.0, 0.5]));
    cx.lightf(GL_LIGHT0, GL_SPOT_CUTOFF, r.of(&[180.0, 180.0, 40.0]));
    cx.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &r.of(&[[0.0; 4], [0.7, 0.6, 0.5, 1.0]]));
    cx.materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &r.color());
    cx.materialf(GL_FRONT_AND_BACK, GL_SHININESS, r.of(&[0.0, 1.0, 20.0]));
    cx.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, r.below(2) as i32);
    cx.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, r.below(2) as i32);
    cx.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, r.of(&[GL_SINGLE_COLOR, GL_SEPARATE_SPECULAR_COLOR]) as i32);
    if r.once_in(3) {
        cx.enable(GL_COLOR_MATERIAL);
    }
    if r.once_in(2) {
        cx.enable(GL_NORMALIZE);
    }
}

fn texture_unit(cx: &mut Context, r: &mut Random, unit: u32) {
    cx.active_texture(GL_TEXTURE0 + unit);
    let name = r.below(TEXTURES.len());
    let (target, _, _, mipmap) = TEXTURES[name];
    cx.bind_texture(target, name as u32 + 1);
    cx.enable(target);
    cx.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, r.of(if mipmap { FILTERS } else { &FILTERS[..2] }));
    cx.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, r.of(&[GL_NEAREST, GL_LINEAR]));
    let same = r.of(WRAPS);
    for axis in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
        let wrap = if r.once_in(3) { r.of(WRAPS) } else { same };
        cx.tex_parameteri(target, axis, wrap);
    }
    cx.tex_parameterfv(target, GL_TEXTURE_BORDER_COLOR, &r.color());
    cx.tex_parameterf(target, GL_TEXTURE_LOD_BIAS, r.of(&[0.0, 0.0, 0.0, 1e-7, -1.3]));
    cx.tex_parameterf(target, GL_TEXTURE_MIN_LOD, r.of(&[-1000.0, -1000.0, 0.7]));
    cx.tex_parameterf(target, GL_TEXTURE_MAX_LOD, r.of(&[1000.0, 1000.0, 1.6]));
    cx.tex_parameteri(target, GL_TEXTURE_MAX_LEVEL, r.of(&[1000, 1000, 0, 2]));
    cx.tex_parameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, r.of(&[1.0, 1.0, 1.0, 4.0]));
    let mode = r.of(ENVS);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    cx.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &r.color());
    if matches!(mode, GL_COMBINE | GL_COMBINE4_NV) {
        combine(cx, r);
    }
    if r.once_in(4) {
        for (coordinate, cap) in [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T)] {
            cx.tex_geni(coordinate, GL_TEXTURE_GEN_MODE, r.of(&[GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP]));
            cx.tex_genfv(coordinate, GL_OBJECT_PLANE, &[r.between(-2.0, 2.0), r.between(-2.0, 2.0), 0.0, 0.5]);
            cx.enable(cap);
        }
    }
    if r.once_in(4) {
        cx.matrix_mode(GL_TEXTURE);
        cx.rotatef(r.of(&[0.0, 30.0]), 0.0, 0.0, 1.0);
        cx.scalef(r.of(&[1.0, 1.0, 3.0]), 1.0, 1.0);
        cx.matrix_mode(GL_MODELVIEW);
    }
}

fn combine(cx: &mut Context, r: &mut Random) {
    let sources = [GL_TEXTURE, GL_PREVIOUS, GL_PRIMARY_COLOR, GL_CONSTANT, GL_ZERO];
    for (mode, first) in [(GL_COMBINE_RGB, GL_SOURCE0_RGB), (GL_COMBINE_ALPHA, GL_SOURCE0_ALPHA)] {
        let all = [GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB];
        let n = if mode == GL_COMBINE_RGB { all.len() } else { all.len() - 1 };
        cx.tex_envi(GL_TEXTURE_ENV, mode, r.of(&all[..n]));
        for i in 0..4 {
            cx.tex_envi(GL_TEXTURE_ENV, first + i, r.of(&sources));
        }
    }
    cx.tex_envi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, r.of(&[GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA]));
    cx.tex_envf(GL_TEXTURE_ENV, GL_RGB_SCALE, r.of(&[1.0, 1.0, 2.0]));
}

fn matrices(cx: &mut Context, r: &mut Random) {
    cx.matrix_mode(GL_PROJECTION);
    match r.below(3) {
        0 => cx.ortho(-1.0, 1.0, -1.0, 1.0, -3.0, 3.0),
        _ => cx.frustum(-0.5, 0.5, -0.5, 0.5, 0.5, 20.0),
    }
    cx.matrix_mode(GL_MODELVIEW);
    cx.translatef(0.0, 0.0, r.of(&[0.0, -1.0, -2.0]));
    if r.once_in(2) {
        cx.rotatef(r.between(-70.0, 70.0), r.between(-1.0, 1.0), r.between(-1.0, 1.0), 0.1);
    }
}

/// Draws a random primitive.
pub fn primitive(cx: &mut Context, r: &mut Random) {
    let (mode, vertices) = match r.below(16) {
        0 => (GL_POINTS, 3),
        1 => (GL_LINE_STRIP, 4),
        2..=6 => (GL_QUADS, 4),
        7..=8 => (GL_TRIANGLE_STRIP, 7),
        _ => (GL_TRIANGLES, 3),
    };
    let small = r.once_in(3);
    let (size, spread) = if small { (0.15, 1.0) } else { (2.4, 0.3) };
    let center = [r.between(-spread, spread), r.between(-spread, spread), r.of(&[0.0, 0.3])];
    let one_color = r.once_in(3);
    let (whole, alpha) = (r.color(), r.of(&[1.0, 1.0, 254.0 / 255.0, 0.5]));
    let (scale, tilt) = (r.of(&[1.0, 1.0, 0.4, 4.0, 40.0]), r.of(&[0.0, 0.0, 0.7]));
    let q = r.of(&[1.0, 1.0, 1.0, 1.0, 1.5]);
    cx.begin(mode);
    for i in 0..vertices {
        let c = if one_color { whole } else { r.color() };
        cx.color4f(c[0], c[1], c[2], alpha);
        cx.secondary_color3f(c[1], c[2], c[0]);
        cx.normal3f(c[0] - 0.5, c[1] - 0.5, 1.0);
        cx.fog_coordf(r.between(0.0, 3.0));
        // Corners around a square, so that quads are convex; strips go to and fro.
        let corner = if mode == GL_QUADS {
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]][i % 4]
        } else {
            [(i / 2) as f32 * 0.4, (i % 2) as f32]
        };
        for unit in 0..3 {
            let q = if unit == 0 && i % 2 == 1 { q } else { 1.0 };
            cx.multi_tex_coord4f(GL_TEXTURE0 + unit, scale * corner[0] * q, scale * corner[1] * q, 0.3 * q, q);
        }
        let jitter = if mode == GL_QUADS { 0.0 } else { r.between(-0.2, 0.2) };
        let z = center[2] + tilt * (corner[0] - 0.5);
        cx.vertex3f(center[0] + size * (corner[0] - 0.5 + jitter), center[1] + size * (corner[1] - 0.5), z);
    }
    cx.end();
}
