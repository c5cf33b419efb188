//! What an implementation may choose (OpenGL 1.5, tables 6.28 to 6.31): limits, ranges, formats, and the strings.

use super::Values;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum};
use crate::limits::*;

/// The compressed formats that `glGet` lists.
pub(crate) const COMPRESSED_FORMATS: [GLenum; 4] = [
    GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
    GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
    GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
    GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
];

/// The value of an implementation-dependent limit.
pub(crate) fn limit(pname: GLenum) -> Option<Values> {
    let size = |v: usize| Values::int(v as i32);
    Some(match pname {
        GL_MAX_LIGHTS => size(MAX_LIGHTS),
        GL_MAX_CLIP_PLANES => size(MAX_CLIP_PLANES),
        GL_MAX_COLOR_MATRIX_STACK_DEPTH => size(MAX_COLOR_MATRIX_STACK_DEPTH),
        GL_MAX_MODELVIEW_STACK_DEPTH => size(MAX_MODELVIEW_STACK_DEPTH),
        GL_MAX_PROJECTION_STACK_DEPTH => size(MAX_PROJECTION_STACK_DEPTH),
        GL_MAX_TEXTURE_STACK_DEPTH => size(MAX_TEXTURE_STACK_DEPTH),
        GL_SUBPIXEL_BITS => Values::uint(SUBPIXEL_BITS),
        GL_MAX_3D_TEXTURE_SIZE => Values::uint(MAX_3D_TEXTURE_SIZE),
        GL_MAX_TEXTURE_SIZE | GL_MAX_CUBE_MAP_TEXTURE_SIZE | GL_MAX_RECTANGLE_TEXTURE_SIZE_ARB => {
            Values::uint(MAX_TEXTURE_SIZE)
        }
        GL_MAX_TEXTURE_LOD_BIAS => Values::float(MAX_TEXTURE_LOD_BIAS),
        GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT => Values::float(MAX_TEXTURE_MAX_ANISOTROPY),
        GL_MAX_PIXEL_MAP_TABLE => size(MAX_PIXEL_MAP_TABLE),
        GL_MAX_NAME_STACK_DEPTH => size(MAX_NAME_STACK_DEPTH),
        GL_MAX_LIST_NESTING => size(MAX_LIST_NESTING),
        GL_MAX_EVAL_ORDER => size(MAX_EVAL_ORDER),
        GL_MAX_VIEWPORT_DIMS => Values::ints(&[MAX_VIEWPORT_DIM as i32; 2]),
        GL_MAX_ATTRIB_STACK_DEPTH => size(MAX_ATTRIB_STACK_DEPTH),
        GL_MAX_CLIENT_ATTRIB_STACK_DEPTH => size(MAX_CLIENT_ATTRIB_STACK_DEPTH),
        GL_MAX_ELEMENTS_INDICES | GL_MAX_ELEMENTS_VERTICES => Values::int(1 << 16),
        GL_MAX_TEXTURE_UNITS => size(MAX_TEXTURE_UNITS),
        GL_POINT_SIZE_RANGE | GL_ALIASED_POINT_SIZE_RANGE => Values::floats(&POINT_SIZE_RANGE),
        GL_POINT_SIZE_GRANULARITY => Values::float(0.125),
        GL_LINE_WIDTH_RANGE | GL_ALIASED_LINE_WIDTH_RANGE => Values::floats(&LINE_WIDTH_RANGE),
        GL_LINE_WIDTH_GRANULARITY => Values::float(0.125),
        GL_AUX_BUFFERS | GL_SAMPLE_BUFFERS | GL_SAMPLES | GL_INDEX_BITS => Values::int(0),
        GL_RGBA_MODE => Values::boolean(true),
        GL_INDEX_MODE | GL_STEREO | GL_DOUBLEBUFFER => Values::boolean(false),
        GL_NUM_COMPRESSED_TEXTURE_FORMATS => size(COMPRESSED_FORMATS.len()),
        GL_COMPRESSED_TEXTURE_FORMATS => Values::enumerants(&COMPRESSED_FORMATS),
        _ => return None,
    })
}

/// The extensions beyond GL 1.5, and those whose names older programs look for. A space follows each name: programs look
/// for a name with the space behind it. `table/extensions.rs` checks that each of them is really there.
const EXTENSIONS: &str = concat!(
    "GL_ARB_depth_texture GL_ARB_imaging GL_ARB_multisample GL_ARB_multitexture GL_ARB_occlusion_query ",
    "GL_ARB_point_parameters GL_ARB_point_sprite GL_ARB_shadow GL_ARB_texture_border_clamp ",
    "GL_ARB_texture_compression GL_ARB_texture_cube_map GL_ARB_texture_env_add GL_ARB_texture_env_combine ",
    "GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat ",
    "GL_ARB_texture_non_power_of_two GL_ARB_texture_rectangle GL_ARB_transpose_matrix GL_ARB_vertex_array_object ",
    "GL_ARB_vertex_buffer_object GL_ARB_window_pos GL_ATI_separate_stencil GL_ATI_texture_mirror_once GL_EXT_abgr ",
    "GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_equation_separate GL_EXT_blend_func_separate GL_EXT_blend_minmax ",
    "GL_EXT_blend_subtract GL_EXT_compiled_vertex_array GL_EXT_copy_texture GL_EXT_draw_range_elements ",
    "GL_EXT_fog_coord GL_EXT_multi_draw_arrays GL_EXT_packed_depth_stencil GL_EXT_packed_pixels ",
    "GL_EXT_point_parameters GL_EXT_polygon_offset GL_EXT_rescale_normal GL_EXT_secondary_color ",
    "GL_EXT_separate_specular_color GL_EXT_shadow_funcs GL_EXT_stencil_wrap GL_EXT_subtexture GL_EXT_texture ",
    "GL_EXT_texture3D GL_EXT_texture_compression_s3tc GL_EXT_texture_cube_map GL_EXT_texture_edge_clamp ",
    "GL_EXT_texture_env_add GL_EXT_texture_env_combine GL_EXT_texture_env_dot3 GL_EXT_texture_filter_anisotropic ",
    "GL_EXT_texture_lod_bias GL_EXT_texture_mirror_clamp GL_EXT_texture_object GL_EXT_texture_rectangle ",
    "GL_EXT_vertex_array GL_NV_fog_distance GL_NV_texgen_reflection GL_NV_texture_env_combine4 ",
    "GL_NV_texture_rectangle GL_SGIS_generate_mipmap GL_SGIS_texture_border_clamp GL_SGIS_texture_edge_clamp ",
    "GL_SGIS_texture_lod ",
);

impl Engine {
    /// Vendor, renderer, version and extensions (section 6.1.11).
    pub(crate) fn get_string(&mut self, which: GLenum) -> Outcome<&'static str> {
        match which {
            GL_VENDOR => Ok("fixedgl"),
            GL_RENDERER => Ok(concat!("fixedgl ", env!("CARGO_PKG_VERSION"), " (software)")),
            GL_VERSION => Ok(concat!("1.5 fixedgl ", env!("CARGO_PKG_VERSION"))),
            GL_EXTENSIONS => Ok(EXTENSIONS),
            _ => {
                Err(invalid_enum(format!("{} is not GL_VENDOR, GL_RENDERER, GL_VERSION or GL_EXTENSIONS", name(which))))
            }
        }
    }
}
