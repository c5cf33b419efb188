//! GLU, the utility library (GLU 1.3): mipmaps, image scaling, projections, quadrics, strings.
//!
//! Everything here is made of GL commands of a [`Context`], as a program could write it; only the pixel store is read and
//! set aside behind its back. Functions keep GLU's names in snake_case and take the context first: `gluPerspective` is
//! [`perspective`]`(cx, ..)`. Functions on images return 0 or a code (`GLU_INVALID_ENUM`, ...), as in C; the sentence that
//! goes with it reaches the debug callback. See spec-notes/glu.md.

pub mod constants;
mod grid;
mod matrices;
mod mipmap;
mod project;
mod pyramid;
mod quadrics;
mod revolution;
mod scale;
mod strings;

pub use constants::*;
pub use matrices::{
    IDENTITY, Matrix, look_at, look_at_matrix, ortho_2d, perspective, perspective_matrix, pick_matrix,
    pick_matrix_matrix,
};
pub use mipmap::MipmapLevels;
pub use project::{project, un_project, un_project4};
pub use quadrics::{ErrorCallback, Quadric};
pub use strings::{check_extension, error_string, get_string};
#[cfg(feature = "capi")]
pub(crate) use strings::{error_words, words};

use crate::context::{Context, IntoInt, Pixels, PixelsMut};
use crate::enums::GLenum;

/// Builds all levels of a 1D texture (`gluBuild1DMipmaps`). 0 or a code of GLU.
#[track_caller]
pub fn build_1d_mipmaps<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    format: GLenum,
    type_: GLenum,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, 1, 1], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 1, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild1DMipmaps", &job, None)
}

/// Builds all levels of a 2D texture or of a face of a cube map (`gluBuild2DMipmaps`). 0 or a code of GLU.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluBuild2DMipmaps")]
pub fn build_2d_mipmaps<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    height: i32,
    format: GLenum,
    type_: GLenum,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, height, 1], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 2, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild2DMipmaps", &job, None)
}

/// Builds all levels of a 3D texture (`gluBuild3DMipmaps`). 0 or a code of GLU.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluBuild3DMipmaps")]
pub fn build_3d_mipmaps<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    height: i32,
    depth: i32,
    format: GLenum,
    type_: GLenum,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, height, depth], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 3, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild3DMipmaps", &job, None)
}

/// Builds some levels of a 1D texture (`gluBuild1DMipmapLevels`). 0 or a code of GLU.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluBuild1DMipmapLevels")]
pub fn build_1d_mipmap_levels<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    format: GLenum,
    type_: GLenum,
    levels: MipmapLevels,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, 1, 1], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 1, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild1DMipmapLevels", &job, Some(levels))
}

/// Builds some levels of a 2D texture or of a face of a cube map (`gluBuild2DMipmapLevels`). 0 or a code of GLU.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluBuild2DMipmapLevels")]
pub fn build_2d_mipmap_levels<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    height: i32,
    format: GLenum,
    type_: GLenum,
    levels: MipmapLevels,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, height, 1], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 2, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild2DMipmapLevels", &job, Some(levels))
}

/// Builds some levels of a 3D texture (`gluBuild3DMipmapLevels`). 0 or a code of GLU.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluBuild3DMipmapLevels")]
pub fn build_3d_mipmap_levels<'a>(
    cx: &mut Context,
    target: GLenum,
    internal_format: impl IntoInt,
    width: i32,
    height: i32,
    depth: i32,
    format: GLenum,
    type_: GLenum,
    levels: MipmapLevels,
    data: impl Into<Pixels<'a>>,
) -> i32 {
    let (size, data) = ([width, height, depth], &data.into());
    let internal_format = internal_format.into_int();
    let job = mipmap::MipmapJob { dimensions: 3, target, internal_format, size, format, type_, data };
    mipmap::build(cx, "gluBuild3DMipmapLevels", &job, Some(levels))
}

/// Scales an image from one place in memory to another, under the unpack and pack state (`gluScaleImage`). 0 or a code
/// of GLU; memory that is too short is `GLU_INVALID_OPERATION`.
#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the arguments of gluScaleImage")]
pub fn scale_image<'a, 'b>(
    cx: &mut Context,
    format: GLenum,
    width_in: i32,
    height_in: i32,
    type_in: GLenum,
    data_in: impl Into<Pixels<'a>>,
    width_out: i32,
    height_out: i32,
    type_out: GLenum,
    data_out: impl Into<PixelsMut<'b>>,
) -> i32 {
    let (input, mut output) = (data_in.into(), data_out.into());
    let (unpack, pack) = (cx.engine.unpack_store(), cx.engine.pack_store());
    let from = scale::Side { size: [width_in, height_in], type_: type_in, store: &unpack };
    let to = scale::Side { size: [width_out, height_out], type_: type_out, store: &pack };
    let output: &mut [u8] = match &mut output {
        PixelsMut::Null => &mut [],
        PixelsMut::Bytes(bytes) => bytes,
    };
    match scale::scale(format, from, input.bytes().unwrap_or(&[]), to, output) {
        Ok(()) => 0,
        Err(error) => {
            if let scale::ImageError::Gl(error) = &error {
                cx.advise("gluScaleImage", &error.message);
            }
            error.code() as i32
        }
    }
}
