//! How many values a pointer argument stands for (OpenGL 1.5, the parameter lists of each command): the count
//! expressions of the table's rows. The Rust doors check the length of a slice with them and the C door makes slices of
//! them. An enumerant that the command does not take counts nothing, so that the engine can say what is wrong with it.

#[cfg(feature = "capi")]
use super::pixels_arg::index_size;
use crate::enums::*;
use crate::limits::{MAX_EVAL_ORDER, MAX_PIXEL_MAP_TABLE};
use crate::state::eval::{COMPONENTS, map1_kind, map2_kind};

/// A count argument: a negative one counts nothing.
pub(crate) fn count(n: i32) -> usize {
    usize::try_from(n).unwrap_or(0)
}

/// A size in bytes: a negative one counts nothing.
#[cfg(feature = "capi")]
pub(crate) fn size(n: impl TryInto<usize>) -> usize {
    n.try_into().unwrap_or(0)
}

/// A vector of four values.
pub(crate) fn four() -> usize {
    4
}

/// `Light`.
pub(crate) fn light(pname: GLenum) -> usize {
    match pname {
        GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_POSITION => 4,
        GL_SPOT_DIRECTION => 3,
        GL_SPOT_EXPONENT
        | GL_SPOT_CUTOFF
        | GL_CONSTANT_ATTENUATION
        | GL_LINEAR_ATTENUATION
        | GL_QUADRATIC_ATTENUATION => 1,
        _ => 0,
    }
}

/// `LightModel`.
pub(crate) fn light_model(pname: GLenum) -> usize {
    match pname {
        GL_LIGHT_MODEL_AMBIENT => 4,
        GL_LIGHT_MODEL_LOCAL_VIEWER | GL_LIGHT_MODEL_TWO_SIDE | GL_LIGHT_MODEL_COLOR_CONTROL => 1,
        _ => 0,
    }
}

/// `Material`.
pub(crate) fn material(pname: GLenum) -> usize {
    match pname {
        GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_EMISSION | GL_AMBIENT_AND_DIFFUSE => 4,
        GL_COLOR_INDEXES => 3,
        GL_SHININESS => 1,
        _ => 0,
    }
}

/// `Fog`.
pub(crate) fn fog(pname: GLenum) -> usize {
    match pname {
        GL_FOG_COLOR => 4,
        GL_FOG_DISTANCE_MODE_NV
        | GL_FOG_MODE
        | GL_FOG_DENSITY
        | GL_FOG_START
        | GL_FOG_END
        | GL_FOG_INDEX
        | GL_FOG_COORD_SRC => 1,
        _ => 0,
    }
}

/// `TexParameter`.
pub(crate) fn tex_parameter(pname: GLenum) -> usize {
    match pname {
        GL_TEXTURE_BORDER_COLOR => 4,
        GL_TEXTURE_MIN_FILTER
        | GL_TEXTURE_MAG_FILTER
        | GL_TEXTURE_WRAP_S
        | GL_TEXTURE_WRAP_T
        | GL_TEXTURE_WRAP_R
        | GL_TEXTURE_PRIORITY
        | GL_TEXTURE_MIN_LOD
        | GL_TEXTURE_MAX_LOD
        | GL_TEXTURE_BASE_LEVEL
        | GL_TEXTURE_MAX_LEVEL
        | GL_TEXTURE_LOD_BIAS
        | GL_DEPTH_TEXTURE_MODE
        | GL_TEXTURE_COMPARE_MODE
        | GL_TEXTURE_COMPARE_FUNC
        | GL_GENERATE_MIPMAP
        | GL_TEXTURE_MAX_ANISOTROPY_EXT => 1,
        _ => 0,
    }
}

/// `TexEnv`.
pub(crate) fn tex_env(pname: GLenum) -> usize {
    match pname {
        GL_TEXTURE_ENV_COLOR => 4,
        GL_TEXTURE_ENV_MODE
        | GL_TEXTURE_LOD_BIAS
        | GL_COMBINE_RGB
        | GL_COMBINE_ALPHA
        | GL_SRC0_RGB..=GL_SOURCE3_RGB_NV
        | GL_SRC0_ALPHA..=GL_SOURCE3_ALPHA_NV
        | GL_OPERAND0_RGB..=GL_OPERAND3_RGB_NV
        | GL_OPERAND0_ALPHA..=GL_OPERAND3_ALPHA_NV
        | GL_COORD_REPLACE_ARB
        | GL_RGB_SCALE
        | GL_ALPHA_SCALE => 1,
        _ => 0,
    }
}

/// `TexGen`.
pub(crate) fn tex_gen(pname: GLenum) -> usize {
    match pname {
        GL_OBJECT_PLANE | GL_EYE_PLANE => 4,
        GL_TEXTURE_GEN_MODE => 1,
        _ => 0,
    }
}

/// `PointParameter`.
pub(crate) fn point_parameter(pname: GLenum) -> usize {
    match pname {
        GL_POINT_DISTANCE_ATTENUATION => 3,
        GL_POINT_SIZE_MIN | GL_POINT_SIZE_MAX | GL_POINT_FADE_THRESHOLD_SIZE => 1,
        _ => 0,
    }
}

/// `ColorTableParameter` and `ConvolutionParameter` with their vectors of four.
pub(crate) fn imaging_parameter(pname: GLenum) -> usize {
    match pname {
        GL_COLOR_TABLE_SCALE
        | GL_COLOR_TABLE_BIAS
        | GL_CONVOLUTION_FILTER_SCALE
        | GL_CONVOLUTION_FILTER_BIAS
        | GL_CONVOLUTION_BORDER_COLOR => 4,
        GL_CONVOLUTION_BORDER_MODE => 1,
        _ => 0,
    }
}

/// Entries of a pixel map: those of a size that no map has are not looked at.
pub(crate) fn pixel_map(size: i32) -> usize {
    Some(count(size)).filter(|n| *n <= MAX_PIXEL_MAP_TABLE).unwrap_or(0)
}

/// Components of a control point of an evaluator map.
pub(crate) fn map_components(target: GLenum) -> usize {
    map1_kind(target).or_else(|| map2_kind(target)).map_or(0, |kind| COMPONENTS[kind])
}

/// Numbers that the control points of a one-dimensional map span.
pub(crate) fn map1(target: GLenum, stride: i32, order: i32) -> usize {
    map2(target, stride, order, stride, 1)
}

/// Numbers that the control points of a two-dimensional map span.
pub(crate) fn map2(target: GLenum, ustride: i32, uorder: i32, vstride: i32, vorder: i32) -> usize {
    let components = map_components(target);
    // What lies beyond the highest order is an error, and its points are not touched.
    let orders = 1..=MAX_EVAL_ORDER as i32;
    if components == 0 || !orders.contains(&uorder) || !orders.contains(&vorder) {
        return 0;
    }
    let (us, vs) = (count(ustride), count(vstride));
    if us < components || vs < components {
        return 0;
    }
    us.saturating_mul(count(uorder - 1)).saturating_add(vs.saturating_mul(count(vorder - 1))).saturating_add(components)
}

/// Bytes of an index list.
#[cfg(feature = "capi")]
pub(crate) fn indices(n: i32, type_: GLenum) -> usize {
    index_size(type_).map_or(0, |size| count(n).saturating_mul(size))
}

/// Bytes of one name in `CallLists`, if the type is one.
pub(crate) fn list_name_size(type_: GLenum) -> Option<usize> {
    match type_ {
        GL_BYTE | GL_UNSIGNED_BYTE => Some(1),
        GL_SHORT | GL_UNSIGNED_SHORT | GL_2_BYTES => Some(2),
        GL_3_BYTES => Some(3),
        GL_INT | GL_UNSIGNED_INT | GL_FLOAT | GL_4_BYTES => Some(4),
        _ => None,
    }
}

/// Bytes of the names of `CallLists`.
pub(crate) fn list_names(n: i32, type_: GLenum) -> usize {
    list_name_size(type_).map_or(0, |size| count(n).saturating_mul(size))
}

/// Whether a target is a proxy: a question that is answered at once, even while a display list is open.
pub(crate) fn is_proxy(target: GLenum) -> bool {
    matches!(
        target,
        GL_PROXY_TEXTURE_1D
            | GL_PROXY_TEXTURE_2D
            | GL_PROXY_TEXTURE_3D
            | GL_PROXY_TEXTURE_CUBE_MAP
            | GL_PROXY_TEXTURE_RECTANGLE_ARB
            | GL_PROXY_COLOR_TABLE
            | GL_PROXY_POST_CONVOLUTION_COLOR_TABLE
            | GL_PROXY_POST_COLOR_MATRIX_COLOR_TABLE
            | GL_PROXY_HISTOGRAM
    )
}
