//! Bad input everywhere: thousands of commands with random enumerants, sizes, numbers and memory, in and out of
//! Begin/End, in and out of display lists. Nothing may panic (the tests run with overflow checks), nothing may hang, and
//! afterwards the context still draws what it should. The seeds are fixed, so a failure can be repeated.

use crate::allocator::{failing, within_budget};
use fixedgl::Context;
use fixedgl::c::*;

/// A small generator of random numbers (xorshift), so that a seed always makes the same commands.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() >> 11) as usize % n
    }

    fn of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// Mostly an enumerant of the list, sometimes any.
    fn en(&mut self, values: &[GLenum]) -> GLenum {
        if self.below(20) == 0 { self.next() as u32 & 0xFFFF } else { self.of(values) }
    }

    fn int(&mut self) -> i32 {
        let small = self.below(12) as i32 - 2;
        self.of(&[small, small, small, small, 17, 64, 65, 300, -1, i32::MAX, i32::MIN, 1 << 24])
    }

    fn size(&mut self) -> i32 {
        let small = self.below(20) as i32;
        self.of(&[small, small, small, small, small, 1, 8, 16, 16, -1, i32::MAX, 700])
    }

    fn float(&mut self) -> f32 {
        let unit = self.below(4001) as f32 / 1000.0 - 2.0;
        let odd =
            self.of(&[0.0, -0.0, 1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38, -1e30, 1e-40, 1e7, 180.0]);
        if self.below(5) == 0 { odd } else { unit }
    }

    fn double(&mut self) -> f64 {
        if self.below(30) == 0 { self.of(&[1e300, -1e300, 1e-310, f64::NAN]) } else { f64::from(self.float()) }
    }

    fn floats<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.float())
    }

    fn bool(&mut self) -> bool {
        self.below(2) == 0
    }
}

const CAPS: &[GLenum] = &[
    GL_ALPHA_TEST,
    GL_BLEND,
    GL_COLOR_LOGIC_OP,
    GL_COLOR_MATERIAL,
    GL_COLOR_SUM,
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_FOG,
    GL_LIGHTING,
    GL_LIGHT0,
    GL_LIGHT1,
    GL_LINE_SMOOTH,
    GL_LINE_STIPPLE,
    GL_NORMALIZE,
    GL_POINT_SMOOTH,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_RESCALE_NORMAL,
    GL_SCISSOR_TEST,
    GL_STENCIL_TEST,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_RECTANGLE_ARB,
    GL_TEXTURE_GEN_S,
    GL_TEXTURE_GEN_T,
    GL_TEXTURE_GEN_R,
    GL_TEXTURE_GEN_Q,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE5,
];
const TARGETS: &[GLenum] = &[
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_RECTANGLE_ARB,
    GL_PROXY_TEXTURE_2D,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
];
const FORMATS: &[GLenum] = &[
    GL_RGBA,
    GL_RGB,
    GL_BGRA,
    GL_ABGR_EXT,
    GL_DEPTH_STENCIL_EXT,
    GL_ALPHA,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_DEPTH_COMPONENT,
    GL_COLOR_INDEX,
    GL_RED,
    GL_STENCIL_INDEX,
];
const TYPES: &[GLenum] = &[
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_BYTE,
    GL_BYTE,
    GL_SHORT,
    GL_UNSIGNED_SHORT,
    GL_INT,
    GL_FLOAT,
    GL_BITMAP,
    GL_UNSIGNED_SHORT_5_6_5,
    GL_UNSIGNED_INT_8_8_8_8_REV,
    GL_UNSIGNED_BYTE_3_3_2,
];
const INTERNAL: &[GLenum] = &[
    1,
    2,
    3,
    4,
    GL_RGBA8,
    GL_RGB5,
    GL_ALPHA16,
    GL_INTENSITY8,
    GL_LUMINANCE_ALPHA,
    GL_DEPTH_COMPONENT24,
    GL_RGBA16,
    GL_COMPRESSED_RGBA,
    GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
    GL_R3_G3_B2,
];
const PNAMES: &[GLenum] = &[
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_TEXTURE_WRAP_R,
    GL_TEXTURE_BASE_LEVEL,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,
    GL_TEXTURE_LOD_BIAS,
    GL_GENERATE_MIPMAP,
    GL_TEXTURE_MAX_ANISOTROPY_EXT,
    GL_TEXTURE_COMPARE_MODE,
    GL_DEPTH_TEXTURE_MODE,
];
const VALUES: &[GLenum] = &[
    GL_NEAREST,
    GL_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_LINEAR_MIPMAP_LINEAR,
    GL_REPEAT,
    GL_CLAMP,
    GL_CLAMP_TO_EDGE,
    GL_CLAMP_TO_BORDER,
    GL_MIRRORED_REPEAT,
    GL_MIRROR_CLAMP_EXT,
    GL_COMPARE_R_TO_TEXTURE,
    GL_INTENSITY,
    0,
    1,
    2,
];
const ENVS: &[GLenum] = &[
    GL_TEXTURE_ENV_MODE,
    GL_COMBINE_RGB,
    GL_COMBINE_ALPHA,
    GL_SOURCE0_RGB,
    GL_SOURCE1_ALPHA,
    GL_OPERAND2_RGB,
    GL_RGB_SCALE,
];
const ENV_VALUES: &[GLenum] = &[
    GL_REPLACE,
    GL_MODULATE,
    GL_DECAL,
    GL_BLEND,
    GL_ADD,
    GL_COMBINE,
    GL_ADD_SIGNED,
    GL_INTERPOLATE,
    GL_SUBTRACT,
    GL_DOT3_RGBA,
    GL_PREVIOUS,
    GL_TEXTURE3,
    GL_SRC_ALPHA,
    4,
];
const FACTORS: &[GLenum] = &[
    GL_ZERO,
    GL_ONE,
    GL_SRC_COLOR,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_COLOR,
    GL_CONSTANT_ALPHA,
    GL_SRC_ALPHA_SATURATE,
];

/// State of all kinds.
fn state(cx: &mut Context, r: &mut Random) {
    match r.below(26) {
        0..=3 => cx.enable(r.en(CAPS)),
        4..=6 => cx.disable(r.en(CAPS)),
        7 => cx.depth_func(r.en(&[GL_LESS, GL_ALWAYS, GL_NEVER, GL_GEQUAL])),
        8 => cx.blend_func(r.en(FACTORS), r.en(FACTORS)),
        9 => cx.alpha_func(r.en(&[GL_GREATER, GL_EQUAL, GL_ALWAYS]), r.float()),
        10 => cx.fogf(r.en(&[GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END]), r.float()),
        11 => cx.fogi(GL_FOG_MODE, r.en(&[GL_EXP, GL_EXP2, GL_LINEAR])),
        12 => cx.viewport(r.int(), r.int(), r.size(), r.size()),
        13 => cx.scissor(r.int(), r.int(), r.size(), r.size()),
        14 => cx.depth_range(r.double(), r.double()),
        15 => cx.polygon_mode(r.en(&[GL_FRONT, GL_FRONT_AND_BACK]), r.en(&[GL_POINT, GL_LINE, GL_FILL])),
        16 => cx.polygon_offset(r.float(), r.float()),
        17 => cx.point_size(r.float()),
        18 => cx.line_width(r.float()),
        19 => cx.stencil_op(r.en(&[GL_KEEP, GL_INCR_WRAP]), r.en(&[GL_DECR]), r.en(&[GL_REPLACE, GL_INVERT])),
        20 => cx.lightfv(
            r.en(&[GL_LIGHT0, GL_LIGHT1]),
            r.en(&[GL_POSITION, GL_DIFFUSE, GL_SPOT_DIRECTION]),
            &r.floats::<4>(),
        ),
        21 => cx.materialfv(GL_FRONT_AND_BACK, r.en(&[GL_AMBIENT, GL_SHININESS, GL_SPECULAR]), &r.floats::<4>()),
        22 => cx.clip_plane(r.en(&[GL_CLIP_PLANE0, GL_CLIP_PLANE5]), &std::array::from_fn::<f64, 4, _>(|_| r.double())),
        23 => cx.shade_model(r.en(&[GL_FLAT, GL_SMOOTH])),
        24 => cx.push_attrib(r.next() as u32),
        _ => cx.pop_attrib(),
    }
}

fn matrices(cx: &mut Context, r: &mut Random) {
    match r.below(10) {
        0 => cx.matrix_mode(r.en(&[GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE, GL_COLOR])),
        1 => cx.load_identity(),
        2 => cx.load_matrixf(&r.floats::<16>()),
        3 => cx.rotatef(r.float(), r.float(), r.float(), r.float()),
        4 => cx.translated(r.double(), r.double(), r.double()),
        5 => cx.scalef(r.float(), r.float(), r.float()),
        6 => cx.frustum(r.double(), r.double(), r.double(), r.double(), r.double(), r.double()),
        7 => cx.push_matrix(),
        8 => cx.pop_matrix(),
        _ => cx.load_identity(),
    }
}

fn textures(cx: &mut Context, r: &mut Random, memory: &[u8]) {
    let (target, level) = (r.en(TARGETS), r.below(6) as i32 - 1);
    let (format, type_) = (r.en(FORMATS), r.en(TYPES));
    match r.below(15) {
        0..=2 => {
            let side = r.size();
            let other = if r.bool() { side } else { r.size() };
            let given = &memory[..r.of(&[0, 5, 4096, memory.len()])];
            cx.tex_image_2d(target, level, r.en(INTERNAL), side, other, r.below(3) as i32, format, type_, given);
        }
        3 => cx.tex_image_1d(target, level, r.en(INTERNAL), r.size(), 0, format, type_, memory),
        4 => cx.tex_image_3d(target, level, r.en(INTERNAL), r.size(), r.size(), r.size(), 0, format, type_, NULL),
        5 => cx.tex_sub_image_2d(target, level, r.int(), r.int(), r.size(), r.size(), format, type_, memory),
        6 => cx.copy_tex_image_2d(target, level, r.en(INTERNAL), r.int(), r.int(), r.size(), r.size(), 0),
        7 => cx.copy_tex_sub_image_2d(target, level, r.int(), r.int(), r.int(), r.int(), r.size(), r.size()),
        8 => cx.tex_parameteri(target, r.en(PNAMES), r.en(VALUES)),
        9 => cx.tex_parameterf(target, r.en(PNAMES), r.float()),
        10 => cx.tex_envi(GL_TEXTURE_ENV, r.en(ENVS), r.en(ENV_VALUES)),
        11 => cx.tex_geni(
            r.en(&[GL_S, GL_T, GL_R, GL_Q]),
            GL_TEXTURE_GEN_MODE,
            r.en(&[GL_SPHERE_MAP, GL_EYE_LINEAR, GL_REFLECTION_MAP]),
        ),
        12 => cx.bind_texture(target, r.below(6) as u32),
        13 => cx.active_texture(GL_TEXTURE0 + r.below(9) as u32),
        _ => cx.pixel_storei(
            r.en(&[GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS]),
            r.int(),
        ),
    }
}

fn drawing(cx: &mut Context, r: &mut Random, memory: &mut [u8]) {
    match r.below(9) {
        0..=3 => {
            cx.begin(r.below(11) as u32);
            for _ in 0..r.below(9) {
                cx.color4fv(&r.floats::<4>());
                cx.normal3fv(&r.floats::<3>());
                cx.tex_coord4fv(&r.floats::<4>());
                cx.vertex4fv(&r.floats::<4>());
                if r.below(40) == 0 {
                    state(cx, r);
                }
            }
            cx.end();
        }
        4 => {
            let positions: Vec<f32> = (0..30).map(|_| r.float()).collect();
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.vertex_pointer(r.size() % 6, GL_FLOAT, r.int(), &positions);
            cx.draw_arrays(r.below(11) as u32, r.int() % 64, r.int() % 64);
            let indices: Vec<u8> = (0..12).map(|_| r.next() as u8).collect();
            cx.draw_elements(r.below(10) as u32, r.int() % 16, r.en(&[GL_UNSIGNED_BYTE, GL_UNSIGNED_INT]), &indices);
        }
        5 => cx.read_pixels(r.int(), r.int(), r.size() % 40, r.size() % 40, r.en(FORMATS), r.en(TYPES), memory),
        6 => cx.clear(r.of(&[GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, 0xFFFF_FFFF])),
        7 => cx.rectf(r.float(), r.float(), r.float(), r.float()),
        _ => cx.flush(),
    }
}

fn lists(cx: &mut Context, r: &mut Random) {
    match r.below(5) {
        0 => cx.new_list(r.below(4) as u32, r.en(&[GL_COMPILE, GL_COMPILE_AND_EXECUTE])),
        1 | 2 => cx.end_list(),
        3 => cx.call_list(r.below(5) as u32),
        _ => cx.delete_lists(r.below(4) as u32, r.int() % 3),
    }
}

/// What must still work: a triangle in a known state.
fn still_draws(cx: &mut Context) {
    cx.end();
    cx.end_list();
    while cx.get_error() != GL_NO_ERROR {}
    for _ in 0..40 {
        cx.pop_attrib();
    }
    for cap in CAPS {
        cx.disable(*cap);
    }
    for unit in 0..8 {
        cx.active_texture(GL_TEXTURE0 + unit);
        for target in [GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE_ARB] {
            cx.disable(target);
        }
    }
    for mode in [GL_PROJECTION, GL_MODELVIEW] {
        cx.matrix_mode(mode);
        cx.load_identity();
    }
    cx.color_mask(true, true, true, true);
    cx.polygon_mode(GL_FRONT_AND_BACK, GL_FILL);
    cx.viewport(0, 0, 48, 48);
    while cx.get_error() != GL_NO_ERROR {}
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.color3f(0.0, 1.0, 0.0);
    cx.rectf(-1.0, -1.0, 1.0, 1.0);
    assert_eq!(cx.check(), Ok(()));
    assert!(cx.pixels().chunks(4).all(|p| p == [0, 255, 0, 255]), "the context no longer draws");
}

/// Where memory is short, one of the first large allocations of each command on textures fails.
fn run(seed: u64, commands: usize, short_of_memory: bool) {
    let mut r = Random(seed);
    let mut cx = match short_of_memory {
        true => Context::with_config(48, 48, fixedgl::Config::default().with_threads(1)),
        false => Context::new(48, 48),
    };
    let mut memory: Vec<u8> = (0..64 * 64 * 4).map(|_| r.next() as u8).collect();
    for i in 0..commands {
        within_budget((seed, i), || match r.below(20) {
            0..=6 => state(&mut cx, &mut r),
            7..=8 => matrices(&mut cx, &mut r),
            9..=13 => match short_of_memory.then(|| r.below(4) as u32 + 1) {
                Some(n) => _ = failing(n, || textures(&mut cx, &mut r, &memory)),
                None => textures(&mut cx, &mut r, &memory),
            },
            14..=18 => drawing(&mut cx, &mut r, &mut memory),
            _ => lists(&mut cx, &mut r),
        });
    }
    still_draws(&mut cx);
}

#[test]
fn random_commands_do_no_harm() {
    for seed in 1..=6_u64 {
        run(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15), 1500, false);
    }
}

#[test]
fn random_commands_do_no_harm_where_memory_is_short() {
    for seed in 11..=14_u64 {
        run(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15), 1500, true);
    }
}
