//! GLU, the utility library (GLU 1.3): mipmaps, image scaling, projections, quadrics, the tessellator, strings.
//!
//! Everything here is made of GL commands of a [`Context`], as a program could write it; only the pixel store is read and
//! replaced for the time of a call without a command. Functions keep GLU's names in snake_case and take the context first: `gluPerspective` is
//! [`perspective`]`(cx, ..)`. Functions on images return 0 or a code (`GLU_INVALID_ENUM`, ...), as in C; the sentence that
//! goes with it reaches the debug callback. See spec-notes/glu.md.

#![expect(clippy::too_many_arguments, reason = "the functions are GLU's")]

pub mod constants;
mod grid;
mod matrices;
mod mipmap;
mod project;
mod pyramid;
mod quadrics;
mod revolution;
pub(crate) mod rows;
mod scale;
mod strings;
mod tess;

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
pub(crate) use tess::Polygon;
pub use tess::{TessCallbacks, Tessellator};

use crate::context::{Context, IntoGl, IntoPixels, IntoPixelsMut, PixelsMut};
use crate::enums::GLenum;

/// Defines the functions that build mipmaps.
macro_rules! mipmaps {
    ($($dims:literal $c_name:ident $name:ident $c_levels_name:ident $levels_name:ident
       ($($size:ident),*) [$($in_memory:tt)*];)*) => {$(
        #[doc = concat!("Builds all levels of a ", $dims, "D texture (`", stringify!($c_name), "`); in two dimensions also ")]
        #[doc = "those of a face of a cube map. 0 or a code of GLU."]
        #[track_caller]
        pub fn $name<'a>(
            cx: &mut Context,
            target: GLenum,
            internal_format: impl IntoGl<i32>,
            $($size: i32,)*
            format: GLenum,
            type_: GLenum,
            data: impl IntoPixels<'a>,
        ) -> i32 {
            let (size, internal_format, data) = (sizes([$($size),*]), internal_format.into_gl(), &data.into_pixels());
            let job = mipmap::MipmapJob { dimensions: $dims, target, internal_format, size, format, type_, data };
            mipmap::build(cx, stringify!($c_name), &job, None)
        }

        #[doc = concat!("[`", stringify!($name), "`] for some levels only (`", stringify!($c_levels_name), "`).")]
        #[track_caller]
        pub fn $levels_name<'a>(
            cx: &mut Context,
            target: GLenum,
            internal_format: impl IntoGl<i32>,
            $($size: i32,)*
            format: GLenum,
            type_: GLenum,
            levels: MipmapLevels,
            data: impl IntoPixels<'a>,
        ) -> i32 {
            let (size, internal_format, data) = (sizes([$($size),*]), internal_format.into_gl(), &data.into_pixels());
            let job = mipmap::MipmapJob { dimensions: $dims, target, internal_format, size, format, type_, data };
            mipmap::build(cx, stringify!($c_levels_name), &job, Some(levels))
        }
    )*};
}
rows::mipmap_rows!(mipmaps);

/// Width, height and depth of an image of one to three dimensions.
fn sizes<const N: usize>(size: [i32; N]) -> [i32; 3] {
    std::array::from_fn(|i| size.get(i).copied().unwrap_or(1))
}

/// Scales an image from one place in memory to another, under the unpack and pack state (`gluScaleImage`). 0 or a code
/// of GLU; memory that is too short is `GLU_INVALID_OPERATION`.
#[track_caller]
pub fn scale_image<'a, 'b>(
    cx: &mut Context,
    format: GLenum,
    width_in: i32,
    height_in: i32,
    type_in: GLenum,
    data_in: impl IntoPixels<'a>,
    width_out: i32,
    height_out: i32,
    type_out: GLenum,
    data_out: impl IntoPixelsMut<'b>,
) -> i32 {
    let (input, mut output) = (data_in.into_pixels(), data_out.into_pixels_mut());
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
