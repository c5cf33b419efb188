//! The state tables (OpenGL 1.5, section 6.2, tables 6.5 to 6.32, without the imaging subset): every variable can be asked
//! for in a new context, and has its initial value.

use crate::support::{no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

const IDENTITY: [f64; 16] = [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.];

/// 0.2 as the state keeps it.
const FIFTH: f64 = 0.2f32 as f64;

/// Variables with the initial value in common.
const NUMBERS: &[(&[f64], &[GLenum])] = &[
    (&[1., 1., 1., 1.], &[GL_CURRENT_COLOR, GL_CURRENT_RASTER_COLOR, GL_COLOR_WRITEMASK]),
    (
        &[0., 0., 0., 1.],
        &[
            GL_CURRENT_SECONDARY_COLOR,
            GL_CURRENT_RASTER_SECONDARY_COLOR,
            GL_CURRENT_TEXTURE_COORDS,
            GL_CURRENT_RASTER_TEXTURE_COORDS,
            GL_CURRENT_RASTER_POSITION,
        ],
    ),
    (&[0., 0., 0., 0.], &[GL_FOG_COLOR, GL_BLEND_COLOR, GL_COLOR_CLEAR_VALUE, GL_ACCUM_CLEAR_VALUE]),
    (&[FIFTH, FIFTH, FIFTH, 1.], &[GL_LIGHT_MODEL_AMBIENT]),
    (&[0., 0., 4., 6.], &[GL_VIEWPORT, GL_SCISSOR_BOX]),
    (&[0., 1.], &[GL_DEPTH_RANGE, GL_MAP1_GRID_DOMAIN]),
    (&[0., 1., 0., 1.], &[GL_MAP2_GRID_DOMAIN]),
    (&[1., 1.], &[GL_MAP2_GRID_SEGMENTS]),
    (&[0., 0., 1.], &[GL_CURRENT_NORMAL]),
    (&[1., 0., 0.], &[GL_POINT_DISTANCE_ATTENUATION]),
    (
        &IDENTITY,
        &[
            GL_MODELVIEW_MATRIX,
            GL_PROJECTION_MATRIX,
            GL_TEXTURE_MATRIX,
            GL_TRANSPOSE_MODELVIEW_MATRIX,
            GL_TRANSPOSE_PROJECTION_MATRIX,
            GL_TRANSPOSE_TEXTURE_MATRIX,
        ],
    ),
    (
        &[1.],
        &[
            GL_CURRENT_INDEX,
            GL_CURRENT_RASTER_INDEX,
            GL_CURRENT_RASTER_POSITION_VALID,
            GL_EDGE_FLAG,
            GL_MODELVIEW_STACK_DEPTH,
            GL_PROJECTION_STACK_DEPTH,
            GL_TEXTURE_STACK_DEPTH,
            GL_FOG_DENSITY,
            GL_FOG_END,
            GL_POINT_SIZE,
            GL_POINT_FADE_THRESHOLD_SIZE,
            GL_LINE_WIDTH,
            GL_LINE_STIPPLE_REPEAT,
            GL_MULTISAMPLE,
            GL_SAMPLE_COVERAGE_VALUE,
            GL_DITHER,
            GL_DEPTH_WRITEMASK,
            GL_DEPTH_CLEAR_VALUE,
            GL_RED_SCALE,
            GL_GREEN_SCALE,
            GL_BLUE_SCALE,
            GL_ALPHA_SCALE,
            GL_DEPTH_SCALE,
            GL_ZOOM_X,
            GL_ZOOM_Y,
            GL_PIXEL_MAP_I_TO_I_SIZE,
            GL_PIXEL_MAP_S_TO_S_SIZE,
            GL_PIXEL_MAP_I_TO_R_SIZE,
            GL_PIXEL_MAP_I_TO_G_SIZE,
            GL_PIXEL_MAP_I_TO_B_SIZE,
            GL_PIXEL_MAP_I_TO_A_SIZE,
            GL_PIXEL_MAP_R_TO_R_SIZE,
            GL_PIXEL_MAP_G_TO_G_SIZE,
            GL_PIXEL_MAP_B_TO_B_SIZE,
            GL_PIXEL_MAP_A_TO_A_SIZE,
            GL_MAP1_GRID_SEGMENTS,
            GL_RGBA_MODE,
        ],
    ),
    (
        &[4.],
        &[
            GL_VERTEX_ARRAY_SIZE,
            GL_COLOR_ARRAY_SIZE,
            GL_TEXTURE_COORD_ARRAY_SIZE,
            GL_UNPACK_ALIGNMENT,
            GL_PACK_ALIGNMENT,
        ],
    ),
    (&[3.], &[GL_SECONDARY_COLOR_ARRAY_SIZE]),
    (&[65535.], &[GL_LINE_STIPPLE_PATTERN]),
    (
        &[0.],
        &[
            GL_CURRENT_FOG_COORD,
            GL_CURRENT_RASTER_DISTANCE,
            GL_VERTEX_ARRAY,
            GL_VERTEX_ARRAY_STRIDE,
            GL_VERTEX_ARRAY_BUFFER_BINDING,
            GL_NORMAL_ARRAY,
            GL_NORMAL_ARRAY_STRIDE,
            GL_NORMAL_ARRAY_BUFFER_BINDING,
            GL_FOG_COORD_ARRAY,
            GL_FOG_COORD_ARRAY_STRIDE,
            GL_FOG_COORD_ARRAY_BUFFER_BINDING,
            GL_COLOR_ARRAY,
            GL_COLOR_ARRAY_STRIDE,
            GL_COLOR_ARRAY_BUFFER_BINDING,
            GL_SECONDARY_COLOR_ARRAY,
            GL_SECONDARY_COLOR_ARRAY_STRIDE,
            GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING,
            GL_INDEX_ARRAY,
            GL_INDEX_ARRAY_STRIDE,
            GL_INDEX_ARRAY_BUFFER_BINDING,
            GL_TEXTURE_COORD_ARRAY,
            GL_TEXTURE_COORD_ARRAY_STRIDE,
            GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
            GL_EDGE_FLAG_ARRAY,
            GL_EDGE_FLAG_ARRAY_STRIDE,
            GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
            GL_ARRAY_BUFFER_BINDING,
            GL_ELEMENT_ARRAY_BUFFER_BINDING,
            GL_NORMALIZE,
            GL_RESCALE_NORMAL,
            GL_CLIP_PLANE0,
            GL_CLIP_PLANE5,
            GL_FOG_INDEX,
            GL_FOG_START,
            GL_FOG,
            GL_COLOR_SUM,
            GL_LIGHTING,
            GL_COLOR_MATERIAL,
            GL_LIGHT_MODEL_LOCAL_VIEWER,
            GL_LIGHT_MODEL_TWO_SIDE,
            GL_LIGHT0,
            GL_LIGHT7,
            GL_POINT_SMOOTH,
            GL_POINT_SIZE_MIN,
            GL_LINE_SMOOTH,
            GL_LINE_STIPPLE,
            GL_CULL_FACE,
            GL_POLYGON_SMOOTH,
            GL_POLYGON_OFFSET_FACTOR,
            GL_POLYGON_OFFSET_UNITS,
            GL_POLYGON_OFFSET_POINT,
            GL_POLYGON_OFFSET_LINE,
            GL_POLYGON_OFFSET_FILL,
            GL_POLYGON_STIPPLE,
            GL_SAMPLE_ALPHA_TO_COVERAGE,
            GL_SAMPLE_ALPHA_TO_ONE,
            GL_SAMPLE_COVERAGE,
            GL_SAMPLE_COVERAGE_INVERT,
            GL_TEXTURE_1D,
            GL_TEXTURE_2D,
            GL_TEXTURE_3D,
            GL_TEXTURE_CUBE_MAP,
            GL_TEXTURE_BINDING_1D,
            GL_TEXTURE_BINDING_2D,
            GL_TEXTURE_BINDING_3D,
            GL_TEXTURE_BINDING_CUBE_MAP,
            GL_TEXTURE_GEN_S,
            GL_TEXTURE_GEN_T,
            GL_TEXTURE_GEN_R,
            GL_TEXTURE_GEN_Q,
            GL_SCISSOR_TEST,
            GL_ALPHA_TEST,
            GL_ALPHA_TEST_REF,
            GL_STENCIL_TEST,
            GL_STENCIL_REF,
            GL_DEPTH_TEST,
            GL_BLEND,
            GL_INDEX_LOGIC_OP,
            GL_COLOR_LOGIC_OP,
            GL_INDEX_CLEAR_VALUE,
            GL_STENCIL_CLEAR_VALUE,
            GL_UNPACK_SWAP_BYTES,
            GL_UNPACK_LSB_FIRST,
            GL_UNPACK_IMAGE_HEIGHT,
            GL_UNPACK_SKIP_IMAGES,
            GL_UNPACK_ROW_LENGTH,
            GL_UNPACK_SKIP_ROWS,
            GL_UNPACK_SKIP_PIXELS,
            GL_PACK_SWAP_BYTES,
            GL_PACK_LSB_FIRST,
            GL_PACK_IMAGE_HEIGHT,
            GL_PACK_SKIP_IMAGES,
            GL_PACK_ROW_LENGTH,
            GL_PACK_SKIP_ROWS,
            GL_PACK_SKIP_PIXELS,
            GL_MAP_COLOR,
            GL_MAP_STENCIL,
            GL_INDEX_SHIFT,
            GL_INDEX_OFFSET,
            GL_RED_BIAS,
            GL_GREEN_BIAS,
            GL_BLUE_BIAS,
            GL_ALPHA_BIAS,
            GL_DEPTH_BIAS,
            GL_MAP1_VERTEX_3,
            GL_MAP1_VERTEX_4,
            GL_MAP1_INDEX,
            GL_MAP1_COLOR_4,
            GL_MAP1_NORMAL,
            GL_MAP1_TEXTURE_COORD_1,
            GL_MAP1_TEXTURE_COORD_2,
            GL_MAP1_TEXTURE_COORD_3,
            GL_MAP1_TEXTURE_COORD_4,
            GL_MAP2_VERTEX_3,
            GL_MAP2_VERTEX_4,
            GL_MAP2_INDEX,
            GL_MAP2_COLOR_4,
            GL_MAP2_NORMAL,
            GL_MAP2_TEXTURE_COORD_1,
            GL_MAP2_TEXTURE_COORD_2,
            GL_MAP2_TEXTURE_COORD_3,
            GL_MAP2_TEXTURE_COORD_4,
            GL_AUTO_NORMAL,
            GL_AUX_BUFFERS,
            GL_INDEX_MODE,
            GL_DOUBLEBUFFER,
            GL_STEREO,
            GL_SAMPLE_BUFFERS,
            GL_SAMPLES,
            GL_INDEX_BITS,
            GL_LIST_BASE,
            GL_LIST_INDEX,
            GL_LIST_MODE,
            GL_SELECTION_BUFFER_SIZE,
            GL_FEEDBACK_BUFFER_SIZE,
            GL_ATTRIB_STACK_DEPTH,
            GL_CLIENT_ATTRIB_STACK_DEPTH,
            GL_NAME_STACK_DEPTH,
        ],
    ),
];

/// Variables that hold an enumerant.
const ENUMERANTS: &[(GLenum, GLenum)] = &[
    (GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0),
    (GL_VERTEX_ARRAY_TYPE, GL_FLOAT),
    (GL_NORMAL_ARRAY_TYPE, GL_FLOAT),
    (GL_FOG_COORD_ARRAY_TYPE, GL_FLOAT),
    (GL_COLOR_ARRAY_TYPE, GL_FLOAT),
    (GL_SECONDARY_COLOR_ARRAY_TYPE, GL_FLOAT),
    (GL_INDEX_ARRAY_TYPE, GL_FLOAT),
    (GL_TEXTURE_COORD_ARRAY_TYPE, GL_FLOAT),
    (GL_MATRIX_MODE, GL_MODELVIEW),
    (GL_FOG_MODE, GL_EXP),
    (GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH),
    (GL_SHADE_MODEL, GL_SMOOTH),
    (GL_COLOR_MATERIAL_PARAMETER, GL_AMBIENT_AND_DIFFUSE),
    (GL_COLOR_MATERIAL_FACE, GL_FRONT_AND_BACK),
    (GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR),
    (GL_CULL_FACE_MODE, GL_BACK),
    (GL_FRONT_FACE, GL_CCW),
    (GL_POLYGON_MODE, GL_FILL),
    (GL_ACTIVE_TEXTURE, GL_TEXTURE0),
    (GL_ALPHA_TEST_FUNC, GL_ALWAYS),
    (GL_STENCIL_FUNC, GL_ALWAYS),
    (GL_STENCIL_FAIL, GL_KEEP),
    (GL_STENCIL_PASS_DEPTH_FAIL, GL_KEEP),
    (GL_STENCIL_PASS_DEPTH_PASS, GL_KEEP),
    (GL_DEPTH_FUNC, GL_LESS),
    (GL_BLEND_SRC_RGB, GL_ONE),
    (GL_BLEND_SRC_ALPHA, GL_ONE),
    (GL_BLEND_DST_RGB, GL_ZERO),
    (GL_BLEND_DST_ALPHA, GL_ZERO),
    (GL_BLEND_EQUATION, GL_FUNC_ADD),
    (GL_LOGIC_OP_MODE, GL_COPY),
    (GL_DRAW_BUFFER, GL_FRONT),
    (GL_READ_BUFFER, GL_FRONT),
    (GL_PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE),
    (GL_POINT_SMOOTH_HINT, GL_DONT_CARE),
    (GL_LINE_SMOOTH_HINT, GL_DONT_CARE),
    (GL_POLYGON_SMOOTH_HINT, GL_DONT_CARE),
    (GL_FOG_HINT, GL_DONT_CARE),
    (GL_GENERATE_MIPMAP_HINT, GL_DONT_CARE),
    (GL_TEXTURE_COMPRESSION_HINT, GL_DONT_CARE),
    (GL_RENDER_MODE, GL_RENDER),
    (GL_FEEDBACK_BUFFER_TYPE, GL_2D),
];

/// Limits and the least that they may be (tables 6.28 to 6.32).
const LIMITS: &[(GLenum, f64)] = &[
    (GL_MAX_LIGHTS, 8.),
    (GL_MAX_CLIP_PLANES, 6.),
    (GL_MAX_MODELVIEW_STACK_DEPTH, 32.),
    (GL_MAX_PROJECTION_STACK_DEPTH, 2.),
    (GL_MAX_TEXTURE_STACK_DEPTH, 2.),
    (GL_SUBPIXEL_BITS, 4.),
    (GL_MAX_3D_TEXTURE_SIZE, 16.),
    (GL_MAX_TEXTURE_SIZE, 64.),
    (GL_MAX_TEXTURE_LOD_BIAS, 2.),
    (GL_MAX_CUBE_MAP_TEXTURE_SIZE, 16.),
    (GL_MAX_PIXEL_MAP_TABLE, 32.),
    (GL_MAX_NAME_STACK_DEPTH, 64.),
    (GL_MAX_LIST_NESTING, 64.),
    (GL_MAX_EVAL_ORDER, 8.),
    (GL_MAX_ATTRIB_STACK_DEPTH, 16.),
    (GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 16.),
    (GL_MAX_TEXTURE_UNITS, 2.),
    (GL_MAX_ELEMENTS_INDICES, 0.),
    (GL_MAX_ELEMENTS_VERTICES, 0.),
    (GL_ALIASED_POINT_SIZE_RANGE, 1.),
    (GL_SMOOTH_POINT_SIZE_RANGE, 0.),
    (GL_SMOOTH_POINT_SIZE_GRANULARITY, 0.),
    (GL_ALIASED_LINE_WIDTH_RANGE, 0.),
    (GL_SMOOTH_LINE_WIDTH_RANGE, 0.),
    (GL_SMOOTH_LINE_WIDTH_GRANULARITY, 0.),
    (GL_NUM_COMPRESSED_TEXTURE_FORMATS, 0.),
    (GL_COMPRESSED_TEXTURE_FORMATS, 0.),
    (GL_RED_BITS, 1.),
    (GL_GREEN_BITS, 1.),
    (GL_BLUE_BITS, 1.),
    (GL_ALPHA_BITS, 0.),
    (GL_DEPTH_BITS, 12.),
    (GL_STENCIL_BITS, 1.),
    (GL_ACCUM_RED_BITS, 0.),
    (GL_ACCUM_GREEN_BITS, 0.),
    (GL_ACCUM_BLUE_BITS, 0.),
    (GL_ACCUM_ALPHA_BITS, 0.),
    (GL_POINT_SIZE_MAX, 1.),
    (GL_STENCIL_VALUE_MASK, 255.),
    (GL_STENCIL_WRITEMASK, 255.),
    (GL_INDEX_WRITEMASK, 255.),
];

fn get(cx: &mut Context, pname: GLenum) -> [f64; 16] {
    let mut v = [-77.0; 16];
    cx.get_doublev(pname, &mut v);
    assert_eq!(cx.get_error(), GL_NO_ERROR, "{}", name(pname));
    v
}

#[test]
fn every_variable_has_its_initial_value() {
    let mut cx = Context::new(4, 6);
    for (values, pnames) in NUMBERS {
        for pname in *pnames {
            let got = get(&mut cx, *pname);
            assert_eq!(got[..values.len()], **values, "{}", name(*pname));
            assert_eq!(got.get(values.len()).copied().unwrap_or(-77.0), -77.0, "{} has more values", name(*pname));
        }
    }
    for (pname, value) in ENUMERANTS {
        assert_eq!(get(&mut cx, *pname)[0], f64::from(*value), "{}", name(*pname));
    }
    for (pname, least) in LIMITS {
        assert!(get(&mut cx, *pname)[0] >= *least, "{}", name(*pname));
    }
}

#[test]
fn what_is_enabled_is_what_get_says() {
    let mut cx = Context::new(4, 4);
    let mut asked = 0;
    for pname in NUMBERS.iter().flat_map(|row| row.1.iter().copied()) {
        let on = cx.is_enabled(pname);
        match cx.get_error() {
            GL_NO_ERROR => {
                assert_eq!(f64::from(u8::from(on)), get(&mut cx, pname)[0], "{}", name(pname));
                asked += 1;
            }
            code => assert_eq!(code, GL_INVALID_ENUM, "{}", name(pname)),
        }
    }
    assert!(asked > 60, "{asked}");
    cx.sample_coverage(0.5, true);
    assert!(cx.is_enabled(GL_SAMPLE_COVERAGE_INVERT));
    no_error(&mut cx);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.enable(GL_SAMPLE_COVERAGE_INVERT));
}

#[test]
fn the_back_buffer_is_the_one_buffer_and_others_do_not_exist() {
    for (buffer, error) in [
        (GL_FRONT, GL_NO_ERROR),
        (GL_FRONT_LEFT, GL_NO_ERROR),
        (GL_LEFT, GL_NO_ERROR),
        (GL_BACK, GL_NO_ERROR),
        (GL_BACK_LEFT, GL_NO_ERROR),
        (GL_RIGHT, GL_INVALID_OPERATION),
        (GL_FRONT_RIGHT, GL_INVALID_OPERATION),
        (GL_BACK_RIGHT, GL_INVALID_OPERATION),
        (GL_AUX0, GL_INVALID_OPERATION),
        (GL_RGBA, GL_INVALID_ENUM),
    ] {
        let mut cx = Context::new(4, 4);
        cx.draw_buffer(GL_NONE);
        cx.rectf(-1.0, -1.0, 1.0, 1.0);
        cx.draw_buffer(buffer);
        assert_eq!(cx.get_error(), error, "DrawBuffer({})", name(buffer));
        cx.read_buffer(buffer);
        assert_eq!(cx.get_error(), error, "ReadBuffer({})", name(buffer));
        let good = error == GL_NO_ERROR;
        let want = if good { [buffer; 2] } else { [GL_NONE, GL_FRONT] };
        assert_eq!(get(&mut cx, GL_DRAW_BUFFER)[0], f64::from(want[0]));
        assert_eq!(get(&mut cx, GL_READ_BUFFER)[0], f64::from(want[1]));
        let mut pixel = [0u8; 4];
        cx.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
        assert_eq!(pixel[0], 0, "nothing is drawn into GL_NONE");
        cx.rectf(-1.0, -1.0, 1.0, 1.0);
        cx.read_pixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixel);
        assert_eq!(pixel[0], if good { 255 } else { 0 }, "{}", name(buffer));
    }
}
