//! Commands in no sensible order with arguments of every kind (OpenGL 1.5, section 2.5): whatever a program sends, the
//! library answers with a GL error or does it; it never ends the program, and a picture can still be drawn afterwards.

use crate::allocator::within_budget;
use crate::support::{Random, pixels};
use fixedgl::Context;
use fixedgl::NULL;
use fixedgl::enums::*;

const ENUMS: &[GLenum] = &[
    0,
    1,
    2,
    3,
    4,
    5,
    6,
    7,
    8,
    9,
    10,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
    GL_TEXTURE_RECTANGLE_ARB,
    GL_PROXY_TEXTURE_2D,
    GL_RGBA,
    GL_RGB,
    GL_BGRA,
    GL_ABGR_EXT,
    GL_DEPTH_STENCIL_EXT,
    GL_ALPHA,
    GL_LUMINANCE,
    GL_LUMINANCE_ALPHA,
    GL_INTENSITY,
    GL_RGBA8,
    GL_RGB16,
    GL_DEPTH_COMPONENT,
    GL_DEPTH_COMPONENT24,
    GL_STENCIL_INDEX,
    GL_COLOR_INDEX,
    GL_UNSIGNED_BYTE,
    GL_BYTE,
    GL_SHORT,
    GL_UNSIGNED_SHORT,
    GL_UNSIGNED_INT,
    GL_INT,
    GL_FLOAT,
    GL_DOUBLE,
    GL_BITMAP,
    GL_UNSIGNED_SHORT_5_6_5,
    GL_UNSIGNED_INT_8_8_8_8_REV,
    GL_LIGHTING,
    GL_LIGHT0,
    GL_LIGHT7,
    GL_FOG,
    GL_BLEND,
    GL_DEPTH_TEST,
    GL_ALPHA_TEST,
    GL_STENCIL_TEST,
    GL_SCISSOR_TEST,
    GL_CULL_FACE,
    GL_NORMALIZE,
    GL_COLOR_MATERIAL,
    GL_COLOR_LOGIC_OP,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE5,
    GL_POLYGON_OFFSET_FILL,
    GL_LINE_SMOOTH,
    GL_POINT_SMOOTH,
    GL_POLYGON_SMOOTH,
    GL_LINE_STIPPLE,
    GL_POLYGON_STIPPLE,
    GL_TEXTURE_GEN_S,
    GL_TEXTURE_GEN_Q,
    GL_COLOR_SUM,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_TEXTURE,
    GL_COLOR,
    GL_FRONT,
    GL_BACK,
    GL_FRONT_AND_BACK,
    GL_CW,
    GL_CCW,
    GL_FLAT,
    GL_SMOOTH,
    GL_POINT,
    GL_LINE,
    GL_FILL,
    GL_NEVER,
    GL_LESS,
    GL_EQUAL,
    GL_ALWAYS,
    GL_ZERO,
    GL_SRC_ALPHA,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_DST_COLOR,
    GL_SRC_ALPHA_SATURATE,
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_R,
    GL_TEXTURE_BORDER_COLOR,
    GL_TEXTURE_BASE_LEVEL,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,
    GL_TEXTURE_LOD_BIAS,
    GL_TEXTURE_MAX_ANISOTROPY_EXT,
    GL_GENERATE_MIPMAP,
    GL_TEXTURE_COMPARE_MODE,
    GL_COMPARE_R_TO_TEXTURE,
    GL_DEPTH_TEXTURE_MODE,
    GL_NEAREST,
    GL_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_REPEAT,
    GL_CLAMP,
    GL_CLAMP_TO_EDGE,
    GL_CLAMP_TO_BORDER,
    GL_MIRRORED_REPEAT,
    GL_TEXTURE_ENV,
    GL_TEXTURE_FILTER_CONTROL,
    GL_TEXTURE_ENV_MODE,
    GL_TEXTURE_ENV_COLOR,
    GL_COMBINE,
    GL_COMBINE_RGB,
    GL_SOURCE0_RGB,
    GL_OPERAND0_RGB,
    GL_RGB_SCALE,
    GL_MODULATE,
    GL_DECAL,
    GL_REPLACE,
    GL_ADD,
    GL_DOT3_RGBA,
    GL_INTERPOLATE,
    GL_S,
    GL_T,
    GL_R,
    GL_Q,
    GL_TEXTURE_GEN_MODE,
    GL_OBJECT_PLANE,
    GL_EYE_PLANE,
    GL_EYE_LINEAR,
    GL_OBJECT_LINEAR,
    GL_SPHERE_MAP,
    GL_REFLECTION_MAP,
    GL_NORMAL_MAP,
    GL_AMBIENT,
    GL_DIFFUSE,
    GL_SPECULAR,
    GL_EMISSION,
    GL_SHININESS,
    GL_POSITION,
    GL_SPOT_CUTOFF,
    GL_SPOT_DIRECTION,
    GL_QUADRATIC_ATTENUATION,
    GL_LIGHT_MODEL_TWO_SIDE,
    GL_LIGHT_MODEL_AMBIENT,
    GL_FOG_MODE,
    GL_FOG_DENSITY,
    GL_FOG_START,
    GL_FOG_END,
    GL_FOG_COLOR,
    GL_EXP,
    GL_EXP2,
    GL_FOG_COORDINATE_SOURCE,
    GL_FOG_COORDINATE,
    GL_COMPILE,
    GL_COMPILE_AND_EXECUTE,
    GL_RENDER,
    GL_FEEDBACK,
    GL_SELECT,
    GL_VERTEX_ARRAY,
    GL_COLOR_ARRAY,
    GL_TEXTURE_COORD_ARRAY,
    GL_NORMAL_ARRAY,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_STATIC_DRAW,
    GL_READ_ONLY,
    GL_TEXTURE0,
    GL_TEXTURE7,
    GL_TEXTURE31,
    GL_ALL_ATTRIB_BITS,
    GL_COLOR_BUFFER_BIT,
    GL_DEPTH_BUFFER_BIT,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SWAP_BYTES,
    GL_PACK_ROW_LENGTH,
    GL_PACK_SKIP_ROWS,
    GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_IMAGES,
    GL_MAP_COLOR,
    GL_RED_SCALE,
    GL_DEPTH_BIAS,
    GL_ACCUM,
    GL_LOAD,
    GL_RETURN,
    GL_T2F_C4F_N3F_V3F,
    GL_V2F,
    GL_MAX_TEXTURE_SIZE,
    GL_VIEWPORT,
    GL_MODELVIEW_MATRIX,
    GL_CURRENT_COLOR,
    GL_EXTENSIONS,
    GL_VENDOR,
    GL_KEEP,
    GL_INCR_WRAP,
    GL_INVERT,
    GL_XOR,
    GL_FUNC_ADD,
    GL_MIN,
    GL_DEPTH,
    GL_STENCIL,
    GL_FOG_HINT,
    GL_NICEST,
];
const INTS: &[i32] = &[-1, 0, 0, 1, 1, 2, 3, 4, 5, 7, 8, 16, 31, 64, 100_000, i32::MAX, i32::MIN, i32::MAX - 1];
const FLOATS: &[f32] = &[
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.25,
    2.0,
    3.75,
    8.0,
    100.0,
    1e-30,
    1e-45,
    1e30,
    -1e30,
    f32::MAX,
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    128.0,
    90.0,
    16_777_216.0,
];

/// A source of arguments.
struct Args {
    r: Random,
}

impl Args {
    fn e(&mut self) -> GLenum {
        if self.r.below(40) == 0 { self.r.bits() as u32 } else { self.r.pick(ENUMS) }
    }

    fn i(&mut self) -> i32 {
        self.r.pick(INTS)
    }

    /// A size that is mostly small, so that time goes into commands and not into memory.
    fn n(&mut self) -> i32 {
        if self.r.below(8) == 0 { self.i() } else { self.r.below(9) as i32 }
    }

    fn f(&mut self) -> f32 {
        if self.r.below(3) == 0 { self.r.pick(FLOATS) } else { self.r.range(-2.0, 2.0) as f32 }
    }

    fn fs<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.f())
    }

    fn d(&mut self) -> f64 {
        f64::from(self.f())
    }

    fn bytes(&mut self) -> Vec<u8> {
        let n = self.r.pick(&[0usize, 1, 7, 64, 1024, 5000]);
        (0..n).map(|_| self.r.bits() as u8).collect()
    }
}

type Command = fn(&mut Context, &mut Args);

/// The commands between Begin and End, several times as likely as the others.
const VERTICES: &[Command] = &[
    |cx, a| cx.vertex2f(a.f(), a.f()),
    |cx, a| cx.vertex4fv(&a.fs::<4>()),
    |cx, a| cx.vertex3f(a.f(), a.f(), a.f()),
    |cx, a| cx.color4f(a.f(), a.f(), a.f(), a.f()),
    |cx, a| cx.color3b(a.i() as i8, a.i() as i8, a.i() as i8),
    |cx, a| cx.normal3fv(&a.fs::<3>()),
    |cx, a| cx.tex_coord4fv(&a.fs::<4>()),
    |cx, a| cx.tex_coord2s(a.i() as i16, a.i() as i16),
    |cx, a| cx.multi_tex_coord2f(a.e(), a.f(), a.f()),
    |cx, a| cx.secondary_color3f(a.f(), a.f(), a.f()),
    |cx, a| cx.fog_coordf(a.f()),
    |cx, a| cx.edge_flag(a.n() > 3),
    |cx, a| cx.materialfv(a.e(), a.e(), &a.fs::<4>()),
    |cx, a| cx.array_element(a.i()),
    |cx, a| cx.call_list(a.n() as u32),
];

const COMMANDS: &[Command] = &[
    |cx, a| cx.begin(a.r.below(11) as u32),
    |cx, a| cx.begin(a.r.below(11) as u32),
    |cx, _| cx.end(),
    |cx, _| cx.end(),
    |cx, _| cx.end(),
    |cx, a| cx.enable(a.e()),
    |cx, a| cx.disable(a.e()),
    |cx, a| cx.matrix_mode(a.e()),
    |cx, _| cx.load_identity(),
    |cx, a| cx.load_matrixf(&a.fs::<16>()),
    |cx, a| cx.mult_matrixf(&a.fs::<16>()),
    |cx, a| cx.rotatef(a.f(), a.f(), a.f(), a.f()),
    |cx, a| cx.translatef(a.f(), a.f(), a.f()),
    |cx, a| cx.scalef(a.f(), a.f(), a.f()),
    |cx, a| cx.frustum(a.d(), a.d(), a.d(), a.d(), a.d(), a.d()),
    |cx, a| cx.ortho(a.d(), a.d(), a.d(), a.d(), a.d(), a.d()),
    |cx, _| cx.push_matrix(),
    |cx, _| cx.pop_matrix(),
    |cx, a| cx.viewport(a.i(), a.i(), a.i(), a.i()),
    |cx, a| cx.viewport(a.n(), a.n(), 8, 8),
    |cx, a| cx.depth_range(a.d(), a.d()),
    |cx, a| cx.clip_plane(a.e(), &[a.d(), a.d(), a.d(), a.d()]),
    |cx, a| cx.lightfv(a.e(), a.e(), &a.fs::<4>()),
    |cx, a| cx.lightf(a.e(), a.e(), a.f()),
    |cx, a| cx.light_modelfv(a.e(), &a.fs::<4>()),
    |cx, a| cx.color_material(a.e(), a.e()),
    |cx, a| cx.shade_model(a.e()),
    |cx, a| cx.fogf(a.e(), a.f()),
    |cx, a| cx.fogi(a.e(), a.e()),
    |cx, a| cx.fogfv(a.e(), &a.fs::<4>()),
    |cx, a| cx.tex_envi(a.e(), a.e(), a.e()),
    |cx, a| cx.tex_envi(GL_TEXTURE_ENV, a.e(), a.e()),
    |cx, a| cx.tex_envfv(a.e(), a.e(), &a.fs::<4>()),
    |cx, a| cx.tex_geni(a.e(), a.e(), a.e()),
    |cx, a| cx.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, a.e()),
    |cx, a| cx.tex_genfv(a.e(), a.e(), &a.fs::<4>()),
    |cx, a| cx.tex_parameteri(a.e(), a.e(), a.e()),
    |cx, a| cx.tex_parameteri(GL_TEXTURE_2D, a.e(), a.e()),
    |cx, a| cx.tex_parameterf(GL_TEXTURE_2D, a.e(), a.f()),
    |cx, a| cx.tex_parameteri(GL_TEXTURE_2D, a.e(), a.i()),
    |cx, a| cx.tex_parameterfv(a.e(), a.e(), &a.fs::<4>()),
    |cx, a| cx.bind_texture(a.e(), a.n() as u32),
    |cx, a| cx.active_texture(a.e()),
    |cx, a| cx.client_active_texture(a.e()),
    |cx, a| cx.delete_textures(2, &[a.n() as u32, a.n() as u32]),
    |cx, a| {
        let px = a.bytes();
        cx.tex_image_1d(GL_TEXTURE_1D, a.n(), a.e(), a.n(), a.n() / 4, a.e(), a.e(), &px);
    },
    |cx, a| {
        let px = a.bytes();
        cx.tex_image_2d(a.e(), a.n(), a.e(), a.n(), a.n(), a.n() / 4, a.e(), a.e(), &px);
    },
    |cx, a| {
        let px = a.bytes();
        cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, a.n(), a.n(), 0, GL_RGBA, GL_UNSIGNED_BYTE, &px);
    },
    |cx, a| cx.tex_image_2d(GL_TEXTURE_2D, a.n(), a.e(), a.n(), a.n(), 0, GL_RGB, GL_UNSIGNED_BYTE, NULL),
    |cx, a| cx.tex_image_3d(GL_TEXTURE_3D, a.n(), a.e(), a.n(), a.n(), a.n(), 0, GL_RGB, GL_UNSIGNED_BYTE, NULL),
    |cx, a| {
        let px = a.bytes();
        cx.tex_sub_image_2d(a.e(), a.n(), a.n(), a.n(), a.n(), a.n(), a.e(), a.e(), &px);
    },
    |cx, a| cx.copy_tex_image_2d(a.e(), a.n(), a.e(), a.i(), a.i(), a.n(), a.n(), a.n() / 4),
    |cx, a| cx.copy_tex_sub_image_2d(a.e(), a.n(), a.n(), a.n(), a.i(), a.i(), a.n(), a.n()),
    |cx, a| {
        let mut out = a.bytes();
        cx.get_tex_image(a.e(), a.n(), a.e(), a.e(), &mut out);
    },
    |cx, a| {
        let mut out = a.bytes();
        cx.read_pixels(a.i(), a.i(), a.n(), a.n(), a.e(), a.e(), &mut out);
    },
    |cx, a| {
        let px = a.bytes();
        cx.draw_pixels(a.n(), a.n(), a.e(), a.e(), &px);
    },
    |cx, a| cx.copy_pixels(a.i(), a.i(), a.n(), a.n(), a.e()),
    |cx, a| cx.raster_pos4fv(&a.fs::<4>()),
    |cx, a| cx.pixel_zoom(a.f(), a.f()),
    |cx, a| cx.pixel_storei(a.e(), a.i()),
    |cx, a| cx.pixel_transferf(a.e(), a.f()),
    |cx, a| cx.pixel_transferi(a.e(), a.i()),
    |cx, a| cx.blend_func(a.e(), a.e()),
    |cx, a| cx.blend_equation(a.e()),
    |cx, a| cx.blend_equation_separate(a.e(), a.e()),
    |cx, a| cx.stencil_func_separate(a.e(), a.e(), a.i(), a.n() as u32),
    |cx, a| cx.stencil_op_separate(a.e(), a.e(), a.e(), a.e()),
    |cx, a| cx.polygon_offset_ext(a.f(), a.f()),
    |cx, a| cx.vertex_pointer_ext(a.i(), a.e(), a.i(), a.i(), &[0.5_f32; 32]),
    |cx, a| cx.alpha_func(a.e(), a.f()),
    |cx, a| cx.depth_func(a.e()),
    |cx, a| cx.stencil_func(a.e(), a.i(), a.i() as u32),
    |cx, a| cx.stencil_op(a.e(), a.e(), a.e()),
    |cx, a| cx.logic_op(a.e()),
    |cx, a| cx.scissor(a.i(), a.i(), a.i(), a.i()),
    |cx, a| cx.clear_color(a.f(), a.f(), a.f(), a.f()),
    |cx, a| cx.clear_depth(a.d()),
    |cx, a| cx.clear(a.e()),
    |cx, a| cx.accum(a.e(), a.f()),
    |cx, a| cx.point_size(a.f()),
    |cx, a| cx.line_width(a.f()),
    |cx, a| cx.line_stipple(a.i(), a.i() as u16),
    |cx, a| cx.polygon_mode(a.e(), a.e()),
    |cx, a| cx.polygon_offset(a.f(), a.f()),
    |cx, a| cx.cull_face(a.e()),
    |cx, a| cx.front_face(a.e()),
    |cx, a| cx.hint(a.e(), a.e()),
    |cx, a| cx.push_attrib(a.e()),
    |cx, _| cx.pop_attrib(),
    |cx, a| cx.push_client_attrib(a.e()),
    |cx, _| cx.pop_client_attrib(),
    |cx, a| cx.new_list(a.n() as u32, a.e()),
    |cx, _| cx.end_list(),
    |cx, _| cx.end_list(),
    |cx, a| cx.call_lists(a.n(), a.e(), &a.bytes()),
    |cx, a| cx.delete_lists(a.n() as u32, a.n()),
    |cx, a| _ = cx.gen_lists(a.n()),
    |cx, a| cx.list_base(a.i() as u32),
    |cx, a| cx.enable_client_state(a.e()),
    |cx, a| cx.disable_client_state(a.e()),
    |cx, a| {
        let data = a.bytes();
        cx.vertex_pointer(a.n(), a.e(), a.n(), &data);
    },
    |cx, a| {
        let data = a.bytes();
        cx.color_pointer(a.n(), a.e(), a.n(), &data);
    },
    |cx, a| {
        let data = a.bytes();
        cx.tex_coord_pointer(a.n(), a.e(), a.n(), &data);
    },
    |cx, a| cx.vertex_pointer(3, GL_FLOAT, a.n(), a.n() as usize),
    |cx, a| {
        let data = a.bytes();
        cx.interleaved_arrays(a.e(), a.n(), &data);
    },
    |cx, a| cx.draw_arrays(a.r.below(11) as u32, a.n(), a.n()),
    |cx, a| cx.draw_arrays(a.r.below(11) as u32, a.i(), a.n()),
    |cx, a| {
        let data = a.bytes();
        cx.draw_elements(a.r.below(11) as u32, a.n(), a.e(), &data);
    },
    |cx, a| cx.bind_buffer(a.e(), a.n() as u32),
    |cx, a| {
        let data = a.bytes();
        cx.buffer_data(a.e(), a.n() as isize, &data, a.e());
    },
    |cx, a| {
        let data = a.bytes();
        cx.buffer_sub_data(a.e(), a.i() as isize, a.n() as isize, &data);
    },
    |cx, a| cx.delete_buffers(1, &[a.n() as u32]),
    |cx, a| {
        if let Some(bytes) = cx.map_buffer(a.e(), a.e()) {
            bytes.fill(3);
        }
    },
    |cx, a| _ = cx.unmap_buffer(a.e()),
    |cx, a| cx.rectf(a.f(), a.f(), a.f(), a.f()),
    |cx, a| cx.get_floatv(a.e(), &mut [0.0; 64]),
    |cx, a| cx.get_integerv(a.e(), &mut [0; 2]),
    |cx, a| cx.get_tex_parameterfv(a.e(), a.e(), &mut [0.0; 4]),
    |cx, a| cx.get_lightfv(a.e(), a.e(), &mut [0.0; 4]),
    |cx, a| _ = cx.get_string(a.e()),
    |cx, a| _ = cx.is_enabled(a.e()),
    |cx, a| _ = cx.render_mode(a.e()),
    |cx, a| cx.feedback_buffer(a.n(), a.e()),
    |cx, a| cx.select_buffer(a.n()),
    |cx, a| cx.push_name(a.i() as u32),
    |cx, _| cx.flush(),
    |cx, _| cx.finish(),
    |cx, _| _ = cx.get_error(),
];

#[test]
fn no_sequence_of_commands_ends_the_program() {
    // FIXEDGL_ROUNDS=n tries more sequences than the usual 40.
    let rounds = std::env::var("FIXEDGL_ROUNDS").ok().and_then(|n| n.parse().ok()).unwrap_or(40u64);
    let mut commands = 0u32;
    for seed in 1..=rounds {
        let mut a = Args { r: Random(seed * 7919) };
        let mut cx = Context::new(16, 16);
        for _ in 0..1500 {
            let list = if a.r.below(3) == 0 { VERTICES } else { COMMANDS };
            let command = a.r.pick(list);
            within_budget((seed, commands), || command(&mut cx, &mut a));
            commands += 1;
        }
        cx.end();
        cx.end_list();
        cx.finish();
        while cx.get_error() != 0 {}
    }
    eprintln!("{commands} commands in no order: all of them came back");
}

#[test]
fn a_context_that_has_seen_everything_still_draws() {
    let mut a = Args { r: Random(4242) };
    let mut cx = Context::new(16, 16);
    cx.push_attrib(GL_ALL_ATTRIB_BITS);
    for _ in 0..2000 {
        let command = a.r.pick(COMMANDS);
        command(&mut cx, &mut a);
    }
    cx.end();
    cx.end_list();
    let _ = cx.render_mode(GL_RENDER);
    while cx.get_error() != 0 {}
    // Out of all stacks again, and everything that shows switched off.
    loop {
        cx.pop_attrib();
        if cx.get_error() != 0 {
            break;
        }
    }
    for cap in 0..0x9000 {
        cx.disable(cap);
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
    cx.viewport(0, 0, 16, 16);
    cx.color_mask(true, true, true, true);
    cx.polygon_mode(GL_FRONT_AND_BACK, GL_FILL);
    cx.draw_buffer(GL_BACK);
    cx.color4ub(10, 20, 30, 40);
    cx.rectf(-1.0, -1.0, 1.0, 1.0);
    cx.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
    for store in [GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES] {
        cx.pixel_storei(store, 0);
    }
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    for scale in [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE] {
        cx.pixel_transferf(scale, 1.0);
    }
    for bias in [GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_MAP_COLOR] {
        cx.pixel_transferf(bias, 0.0);
    }
    while cx.get_error() != 0 {}
    assert!(pixels(&mut cx, 16, 16).iter().all(|p| *p == [10, 20, 30, 40]));
}
