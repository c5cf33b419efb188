//! GLU's C names as safe functions on the current context (GLU 1.3). Numbers that C converts to double may be given as
//! any Rust number that fits; arrays and results are references, as in the rest of this door.
//!
//! ```
//! use fixedgl::c::*;
//! make_current(fixedgl::Context::new(64, 64));
//! glMatrixMode(GL_PROJECTION);
//! gluPerspective(60.0, 64.0 / 48.0, 1, 30);
//! let q = gluNewQuadric();
//! gluQuadricTexture(&q, GL_TRUE);
//! gluSphere(&q, 1.0, 20, 20);
//! gluDeleteQuadric(q);
//! take_current();
//! ```
#![expect(non_snake_case, reason = "the names are GLU's own")]
#![expect(clippy::too_many_arguments, reason = "the functions are GLU's")]

use super::current;
use super::manual::with;
use crate::context::{InSlice, IntoGl, IntoPixels, IntoPixelsMut};
use crate::enums::{GLboolean, GLdouble, GLenum, GLint, GLsizei};
use crate::glu::rows::{mipmap_rows, quadric_rows};
use crate::glu::{self, Matrix, MipmapLevels, Quadric};
use std::cell::RefCell;

pub use crate::glu::constants::*;

/// A quadric: what `gluNewQuadric` returns and every quadric function takes by reference.
#[derive(Debug, Default)]
pub struct GLUquadric(RefCell<Quadric>);

/// The older name of [`GLUquadric`].
pub type GLUquadricObj = GLUquadric;

impl GLUquadric {
    /// Calls `f` with the quadric; while an error callback runs, nothing.
    fn with(&self, f: impl FnOnce(&mut Quadric)) {
        if let Ok(mut quadric) = self.0.try_borrow_mut() {
            f(&mut quadric);
        }
    }
}

macro_rules! mipmaps {
    ($($dims:literal $name:ident $build:ident $levels_name:ident $build_levels:ident
       ($($size:ident),*) [$($in_memory:tt)*];)*) => {$(
        #[doc = concat!("See [`", stringify!($build), "`](crate::glu::", stringify!($build), ").")]
        #[track_caller]
        pub fn $name<'a>(
            target: GLenum,
            internalformat: impl IntoGl<GLint>,
            $($size: GLsizei,)*
            format: GLenum,
            type_: GLenum,
            data: impl IntoPixels<'a>,
        ) -> GLint {
            with!($name, cx => glu::$build(cx, target, internalformat, $($size,)* format, type_, data))
        }

        #[doc = concat!("See [`", stringify!($build_levels), "`](crate::glu::", stringify!($build_levels), ").")]
        #[track_caller]
        pub fn $levels_name<'a>(
            target: GLenum,
            internalformat: impl IntoGl<GLint>,
            $($size: GLsizei,)*
            format: GLenum,
            type_: GLenum,
            level: GLint,
            base: GLint,
            max: GLint,
            data: impl IntoPixels<'a>,
        ) -> GLint {
            let levels = MipmapLevels { level, base, max };
            with!($levels_name, cx => {
                glu::$build_levels(cx, target, internalformat, $($size,)* format, type_, levels, data)
            })
        }
    )*};
}

mipmap_rows!(mipmaps);

/// See [`scale_image`](crate::glu::scale_image).
#[track_caller]
pub fn gluScaleImage<'a, 'b>(
    format: GLenum,
    width_in: GLsizei,
    height_in: GLsizei,
    type_in: GLenum,
    data_in: impl IntoPixels<'a>,
    width_out: GLsizei,
    height_out: GLsizei,
    type_out: GLenum,
    data_out: impl IntoPixelsMut<'b>,
) -> GLint {
    with!(gluScaleImage, cx => {
        glu::scale_image(cx, format, width_in, height_in, type_in, data_in, width_out, height_out, type_out, data_out)
    })
}

/// See [`perspective`](crate::glu::perspective).
#[track_caller]
pub fn gluPerspective(
    fovy: impl IntoGl<GLdouble>,
    aspect: impl IntoGl<GLdouble>,
    near: impl IntoGl<GLdouble>,
    far: impl IntoGl<GLdouble>,
) {
    with!(gluPerspective, cx => glu::perspective(cx, fovy.into_gl(), aspect.into_gl(), near.into_gl(), far.into_gl()));
}

/// See [`ortho_2d`](crate::glu::ortho_2d).
#[track_caller]
pub fn gluOrtho2D(
    left: impl IntoGl<GLdouble>,
    right: impl IntoGl<GLdouble>,
    bottom: impl IntoGl<GLdouble>,
    top: impl IntoGl<GLdouble>,
) {
    with!(gluOrtho2D, cx => glu::ortho_2d(cx, left.into_gl(), right.into_gl(), bottom.into_gl(), top.into_gl()));
}

/// See [`look_at`](crate::glu::look_at).
#[track_caller]
pub fn gluLookAt(
    eye_x: impl IntoGl<GLdouble>,
    eye_y: impl IntoGl<GLdouble>,
    eye_z: impl IntoGl<GLdouble>,
    center_x: impl IntoGl<GLdouble>,
    center_y: impl IntoGl<GLdouble>,
    center_z: impl IntoGl<GLdouble>,
    up_x: impl IntoGl<GLdouble>,
    up_y: impl IntoGl<GLdouble>,
    up_z: impl IntoGl<GLdouble>,
) {
    let eye = [eye_x.into_gl(), eye_y.into_gl(), eye_z.into_gl()];
    let center = [center_x.into_gl(), center_y.into_gl(), center_z.into_gl()];
    let up = [up_x.into_gl(), up_y.into_gl(), up_z.into_gl()];
    with!(gluLookAt, cx => glu::look_at(cx, eye, center, up));
}

/// See [`pick_matrix`](crate::glu::pick_matrix). A viewport of less than four numbers picks nothing.
#[track_caller]
pub fn gluPickMatrix(
    x: impl IntoGl<GLdouble>,
    y: impl IntoGl<GLdouble>,
    width: impl IntoGl<GLdouble>,
    height: impl IntoGl<GLdouble>,
    viewport: impl InSlice<GLint>,
) {
    let Some(viewport) = viewport.slice().first_chunk() else { return };
    with!(gluPickMatrix, cx => glu::pick_matrix(cx, x.into_gl(), y.into_gl(), width.into_gl(), height.into_gl(), viewport));
}

/// The two matrices and the viewport of a projection, if the arrays are long enough.
fn view<'a>(
    model: &'a [f64],
    projection: &'a [f64],
    viewport: &'a [i32],
) -> Option<(&'a Matrix, &'a Matrix, &'a [i32; 4])> {
    Some((model.first_chunk()?, projection.first_chunk()?, viewport.first_chunk()?))
}

/// Stores a point, if there is one: what the functions below return.
fn store<const N: usize>(point: Option<[f64; N]>, places: [&mut GLdouble; N]) -> GLint {
    let Some(point) = point else { return 0 };
    for (place, v) in places.into_iter().zip(point) {
        *place = v;
    }
    1
}

/// See [`project`](crate::glu::project). Returns `GL_TRUE`, or `GL_FALSE` if there is no such point.
pub fn gluProject(
    obj_x: impl IntoGl<GLdouble>,
    obj_y: impl IntoGl<GLdouble>,
    obj_z: impl IntoGl<GLdouble>,
    model: impl InSlice<GLdouble>,
    projection: impl InSlice<GLdouble>,
    viewport: impl InSlice<GLint>,
    win_x: &mut GLdouble,
    win_y: &mut GLdouble,
    win_z: &mut GLdouble,
) -> GLint {
    let object = [obj_x.into_gl(), obj_y.into_gl(), obj_z.into_gl()];
    let point =
        view(model.slice(), projection.slice(), viewport.slice()).and_then(|(m, p, v)| glu::project(object, m, p, v));
    store(point, [win_x, win_y, win_z])
}

/// See [`un_project`](crate::glu::un_project). Returns `GL_TRUE`, or `GL_FALSE` if there is no such point.
pub fn gluUnProject(
    win_x: impl IntoGl<GLdouble>,
    win_y: impl IntoGl<GLdouble>,
    win_z: impl IntoGl<GLdouble>,
    model: impl InSlice<GLdouble>,
    projection: impl InSlice<GLdouble>,
    viewport: impl InSlice<GLint>,
    obj_x: &mut GLdouble,
    obj_y: &mut GLdouble,
    obj_z: &mut GLdouble,
) -> GLint {
    let window = [win_x.into_gl(), win_y.into_gl(), win_z.into_gl()];
    let point = view(model.slice(), projection.slice(), viewport.slice())
        .and_then(|(m, p, v)| glu::un_project(window, m, p, v));
    store(point, [obj_x, obj_y, obj_z])
}

/// See [`un_project4`](crate::glu::un_project4). Returns `GL_TRUE`, or `GL_FALSE` if there is no such point.
pub fn gluUnProject4(
    win_x: impl IntoGl<GLdouble>,
    win_y: impl IntoGl<GLdouble>,
    win_z: impl IntoGl<GLdouble>,
    clip_w: impl IntoGl<GLdouble>,
    model: impl InSlice<GLdouble>,
    projection: impl InSlice<GLdouble>,
    viewport: impl InSlice<GLint>,
    near: impl IntoGl<GLdouble>,
    far: impl IntoGl<GLdouble>,
    obj_x: &mut GLdouble,
    obj_y: &mut GLdouble,
    obj_z: &mut GLdouble,
    obj_w: &mut GLdouble,
) -> GLint {
    let (window, w) = ([win_x.into_gl(), win_y.into_gl(), win_z.into_gl()], clip_w.into_gl());
    let range = (near.into_gl(), far.into_gl());
    let point = view(model.slice(), projection.slice(), viewport.slice())
        .and_then(|(m, p, v)| glu::un_project4(window, w, m, p, v, range.0, range.1));
    store(point, [obj_x, obj_y, obj_z, obj_w])
}

/// A new quadric: filled, smooth normals that point outward, no texture coordinates.
#[must_use]
pub fn gluNewQuadric() -> GLUquadric {
    GLUquadric::default()
}

/// Ends a quadric. (Going out of scope does the same.)
pub fn gluDeleteQuadric(_quadric: GLUquadric) {}

/// See [`Quadric::draw_style`](crate::glu::Quadric::draw_style).
pub fn gluQuadricDrawStyle(quadric: &GLUquadric, style: GLenum) {
    quadric.with(|q| q.draw_style(style));
}

/// See [`Quadric::normals`](crate::glu::Quadric::normals).
pub fn gluQuadricNormals(quadric: &GLUquadric, normals: GLenum) {
    quadric.with(|q| q.normals(normals));
}

/// See [`Quadric::orientation`](crate::glu::Quadric::orientation).
pub fn gluQuadricOrientation(quadric: &GLUquadric, orientation: GLenum) {
    quadric.with(|q| q.orientation(orientation));
}

/// See [`Quadric::texture`](crate::glu::Quadric::texture).
pub fn gluQuadricTexture(quadric: &GLUquadric, texture: impl IntoGl<bool>) {
    quadric.with(|q| q.texture(texture.into_gl()));
}

/// See [`Quadric::callback`](crate::glu::Quadric::callback). The callback must not use the quadric that calls it.
pub fn gluQuadricCallback(quadric: &GLUquadric, which: GLenum, callback: Option<fn(GLenum)>) {
    quadric.with(|q| q.callback(which, callback));
}

/// Defines the functions that draw a quadric with the current context.
macro_rules! quadrics {
    ($($name:ident $method:ident ($($number:ident),*) ($($count:ident),*) ($($more:ident),*);)*) => {$(
        #[doc = concat!("See [`Quadric::", stringify!($method), "`](crate::glu::Quadric::", stringify!($method), ").")]
        #[track_caller]
        pub fn $name(
            quadric: &GLUquadric,
            $($number: impl IntoGl<GLdouble>,)*
            $($count: GLint,)*
            $($more: impl IntoGl<GLdouble>,)*
        ) {
            with!($name, cx => {
                if let Ok(mut quadric) = quadric.0.try_borrow_mut() {
                    quadric.$method(cx, $($number.into_gl(),)* $($count,)* $($more.into_gl(),)*);
                }
            });
        }
    )*};
}
quadric_rows!(quadrics);

/// An error code of GL or GLU in words; empty for a number that is neither.
#[must_use]
pub fn gluErrorString(error: GLenum) -> &'static str {
    glu::error_string(error).unwrap_or_default()
}

/// GLU's version or extensions; empty for another name.
#[must_use]
pub fn gluGetString(name: GLenum) -> &'static str {
    glu::get_string(name).unwrap_or_default()
}

/// Whether a list of extensions has a name.
#[must_use]
pub fn gluCheckExtension(name: &str, extensions: &str) -> GLboolean {
    u8::from(glu::check_extension(name, extensions))
}
