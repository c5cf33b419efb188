//! The exported `glu*` functions (GLU 1.3) with the signatures of the ordinary header. A `GLUquadric *` of C is a boxed
//! [`CQuadric`]; images are slices as long as the pixel store says; everything else is the safe GLU.

use super::{current, memory};
use crate::Context;
use crate::enums::*;
use crate::glu::rows::{mipmap_rows, quadric_rows};
use crate::glu::{self, Matrix, MipmapLevels, Quadric};
use std::ffi::{CStr, c_char, c_void};
use std::ptr::null;

/// What C holds as a `GLUquadric *`.
#[derive(Default)]
pub struct CQuadric {
    quadric: Quadric,
    callback: Option<extern "C" fn(GLenum)>,
}

/// Defines exported functions, and a function that knows them by their names.
macro_rules! exports {
    ($find:ident: $( $(#[$doc:meta])* fn $name:ident($($a:ident: $t:ty),* $(,)?) $(-> $r:ty)? $body:block )*) => {
        $(
            $(#[$doc])*
            /// # Safety
            /// Pointers must be null or point to as much memory as the function reads or writes.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name($($a: $t),*) $(-> $r)? $body
        )*

        /// The address of one of these functions.
        pub(super) fn $find(name: &str) -> Option<*const c_void> {
            match name {
                $( stringify!($name) => Some($name as *const c_void), )*
                _ => None,
            }
        }
    };
}

pub(super) use exports;

/// Calls `f` with a quadric, then its error callback if there was an error.
///
/// # Safety
/// `quadric` must be null or come from `gluNewQuadric`.
unsafe fn with(quadric: *mut CQuadric, f: impl FnOnce(&mut Quadric)) {
    // SAFETY: the caller's promise; the reference ends before the callback, which may use the quadric again.
    let error = match unsafe { quadric.as_mut() } {
        Some(c) => {
            current::without(|| f(&mut c.quadric));
            c.quadric.take_error().zip(c.callback)
        }
        None => None,
    };
    if let Some((error, callback)) = error {
        callback(error);
    }
}

/// Draws with a quadric and the current context.
///
/// # Safety
/// `quadric` must be null or come from `gluNewQuadric`.
unsafe fn draw(quadric: *mut CQuadric, f: impl FnOnce(&mut Quadric, &mut Context)) {
    // SAFETY: the caller's promise.
    unsafe { with(quadric, |q| current::with(|cx| f(q, cx))) }
}

/// The matrices and the viewport of a projection, if none is null.
///
/// # Safety
/// The pointers must be null or point to 16, 16 and 4 numbers.
unsafe fn view<'a>(model: *const f64, projection: *const f64, viewport: *const i32) -> Option<View<'a>> {
    // SAFETY: the caller's promise.
    unsafe {
        let model = memory::slice(model, 16).first_chunk()?;
        let projection = memory::slice(projection, 16).first_chunk()?;
        Some((model, projection, memory::slice(viewport, 4).first_chunk()?))
    }
}

type View<'a> = (&'a Matrix, &'a Matrix, &'a [i32; 4]);

/// Stores a point, if there is one.
///
/// # Safety
/// The places must be null or writable.
unsafe fn store<const N: usize>(point: Option<[f64; N]>, places: [*mut f64; N]) -> i32 {
    let Some(point) = point else { return 0 };
    for (place, v) in places.into_iter().zip(point) {
        if !place.is_null() {
            // SAFETY: the caller's promise.
            unsafe { place.write(v) };
        }
    }
    1
}

/// Defines the functions that build mipmaps.
macro_rules! mipmaps {
    ($($dims:literal $name:ident $build:ident $levels_name:ident $build_levels:ident
       ($($size:ident),*) [$($in_memory:tt)*];)*) => {
        exports! { find_mipmaps: $(
            fn $name(
                target: GLenum, internalformat: i32, $($size: i32,)* format: GLenum, type_: GLenum, data: *const c_void,
            ) -> i32 {
                current::with(|cx| {
                    let n = memory::unpack_bytes(cx, [$($in_memory)*], format, type_);
                    // SAFETY: the caller's promise.
                    let data = unsafe { memory::bytes(data, n) };
                    glu::$build(cx, target, internalformat, $($size,)* format, type_, data)
                })
            }

            fn $levels_name(
                target: GLenum, internalformat: i32, $($size: i32,)* format: GLenum, type_: GLenum, level: i32, base: i32,
                max: i32, data: *const c_void,
            ) -> i32 {
                current::with(|cx| {
                    let n = memory::unpack_bytes(cx, [$($in_memory)*], format, type_);
                    let levels = MipmapLevels { level, base, max };
                    // SAFETY: the caller's promise.
                    let data = unsafe { memory::bytes(data, n) };
                    glu::$build_levels(cx, target, internalformat, $($size,)* format, type_, levels, data)
                })
            }
        )* }
    };
}
mipmap_rows!(mipmaps);

/// Defines the functions that draw a quadric with the current context.
macro_rules! quadrics {
    ($($name:ident $method:ident ($($number:ident),*) ($($count:ident),*) ($($more:ident),*);)*) => {
        exports! { find_quadrics: $(
            fn $name(quadric: *mut CQuadric, $($number: f64,)* $($count: i32,)* $($more: f64,)*) {
                // SAFETY: the caller's promise.
                unsafe { draw(quadric, |q, cx| q.$method(cx, $($number,)* $($count,)* $($more,)*)) }
            }
        )* }
    };
}
quadric_rows!(quadrics);

/// The address of a function.
pub(super) fn find(name: &str) -> Option<*const c_void> {
    find_others(name).or_else(|| find_mipmaps(name)).or_else(|| find_quadrics(name))
}

exports! { find_others:
    fn gluScaleImage(
        format: GLenum, width_in: i32, height_in: i32, type_in: GLenum, data_in: *const c_void, width_out: i32,
        height_out: i32, type_out: GLenum, data_out: *mut c_void,
    ) -> i32 {
        current::with(|cx| {
            let n_in = memory::unpack_bytes(cx, [width_in, height_in], format, type_in);
            let n_out = memory::pack_bytes(cx, [width_out, height_out], format, type_out);
            // SAFETY: the caller's promise; the two images do not overlap.
            let (input, output) = unsafe { (memory::bytes(data_in, n_in), memory::bytes_mut(data_out, n_out)) };
            glu::scale_image(
                cx, format, width_in, height_in, type_in, input, width_out, height_out, type_out, output,
            )
        })
    }

    fn gluPerspective(fovy: f64, aspect: f64, near: f64, far: f64) {
        current::with(|cx| glu::perspective(cx, fovy, aspect, near, far));
    }

    fn gluOrtho2D(left: f64, right: f64, bottom: f64, top: f64) {
        current::with(|cx| glu::ortho_2d(cx, left, right, bottom, top));
    }

    fn gluLookAt(
        eye_x: f64, eye_y: f64, eye_z: f64, center_x: f64, center_y: f64, center_z: f64, up_x: f64, up_y: f64,
        up_z: f64,
    ) {
        let (eye, center, up) = ([eye_x, eye_y, eye_z], [center_x, center_y, center_z], [up_x, up_y, up_z]);
        current::with(|cx| glu::look_at(cx, eye, center, up));
    }

    fn gluPickMatrix(x: f64, y: f64, width: f64, height: f64, viewport: *const i32) {
        // SAFETY: the caller's promise.
        let Some(viewport) = (unsafe { memory::slice(viewport, 4) }).first_chunk() else { return };
        current::with(|cx| glu::pick_matrix(cx, x, y, width, height, viewport));
    }

    fn gluProject(
        obj_x: f64, obj_y: f64, obj_z: f64, model: *const f64, projection: *const f64, viewport: *const i32,
        win_x: *mut f64, win_y: *mut f64, win_z: *mut f64,
    ) -> i32 {
        // SAFETY: the caller's promise.
        unsafe {
            let point = view(model, projection, viewport)
                .and_then(|(m, p, v)| current::without(|| glu::project([obj_x, obj_y, obj_z], m, p, v)));
            store(point, [win_x, win_y, win_z])
        }
    }

    fn gluUnProject(
        win_x: f64, win_y: f64, win_z: f64, model: *const f64, projection: *const f64, viewport: *const i32,
        obj_x: *mut f64, obj_y: *mut f64, obj_z: *mut f64,
    ) -> i32 {
        // SAFETY: the caller's promise.
        unsafe {
            let point = view(model, projection, viewport)
                .and_then(|(m, p, v)| current::without(|| glu::un_project([win_x, win_y, win_z], m, p, v)));
            store(point, [obj_x, obj_y, obj_z])
        }
    }

    fn gluUnProject4(
        win_x: f64, win_y: f64, win_z: f64, clip_w: f64, model: *const f64, projection: *const f64,
        viewport: *const i32, near: f64, far: f64, obj_x: *mut f64, obj_y: *mut f64, obj_z: *mut f64, obj_w: *mut f64,
    ) -> i32 {
        // SAFETY: the caller's promise.
        unsafe {
            let point = view(model, projection, viewport).and_then(|(m, p, v)| {
                current::without(|| glu::un_project4([win_x, win_y, win_z], clip_w, m, p, v, near, far))
            });
            store(point, [obj_x, obj_y, obj_z, obj_w])
        }
    }

    fn gluNewQuadric() -> *mut CQuadric {
        Box::into_raw(Box::default())
    }

    fn gluDeleteQuadric(quadric: *mut CQuadric) {
        if !quadric.is_null() {
            // SAFETY: the caller's promise: it comes from `gluNewQuadric` and is deleted once.
            drop(unsafe { Box::from_raw(quadric) });
        }
    }

    fn gluQuadricDrawStyle(quadric: *mut CQuadric, style: GLenum) {
        // SAFETY: the caller's promise.
        unsafe { with(quadric, |q| q.draw_style(style)) }
    }

    fn gluQuadricNormals(quadric: *mut CQuadric, normals: GLenum) {
        // SAFETY: the caller's promise.
        unsafe { with(quadric, |q| q.normals(normals)) }
    }

    fn gluQuadricOrientation(quadric: *mut CQuadric, orientation: GLenum) {
        // SAFETY: the caller's promise.
        unsafe { with(quadric, |q| q.orientation(orientation)) }
    }

    fn gluQuadricTexture(quadric: *mut CQuadric, texture: GLboolean) {
        // SAFETY: the caller's promise.
        unsafe { with(quadric, |q| q.texture(texture != 0)) }
    }

    fn gluQuadricCallback(quadric: *mut CQuadric, which: GLenum, callback: Option<extern "C" fn(GLenum)>) {
        // SAFETY: the caller's promise.
        match unsafe { quadric.as_mut() } {
            Some(c) if which == glu::GLU_ERROR => c.callback = callback,
            // SAFETY: the caller's promise.
            _ => unsafe { with(quadric, |q| q.callback(which, None)) },
        }
    }

    fn gluErrorString(error: GLenum) -> *const c_char {
        glu::error_words(error).map_or(null(), CStr::as_ptr)
    }

    fn gluGetString(name: GLenum) -> *const c_char {
        glu::words(name).map_or(null(), CStr::as_ptr)
    }

    fn gluCheckExtension(name: *const c_char, extensions: *const c_char) -> GLboolean {
        if name.is_null() || extensions.is_null() {
            return 0;
        }
        // SAFETY: the caller's promise: both end with a zero byte.
        let words = unsafe { (CStr::from_ptr(name).to_str(), CStr::from_ptr(extensions).to_str()) };
        let (Ok(name), Ok(extensions)) = words else { return 0 };
        u8::from(glu::check_extension(name, extensions))
    }
}
