//! What the Rust doors take in the place of C's implicit conversions and pointers (OpenGL 1.5, section 2.3): any number where
//! a command takes one, and slices in every shape that a C program's arrays take in Rust. The one idea: a call that
//! compiles in C should compile here without casts.

/// The types that a slice argument can hold: GL's own scalars.
pub use crate::num::Scalar as Element;

/// Keeps the traits of this file to the types that GL's arguments have: more may come without breaking anybody.
mod sealed {
    /// A type that stands for a scalar argument.
    pub trait Number {}
    /// A type that stands for an array argument of `T`.
    pub trait Array<T> {}
}

/// A number that C would convert to the type `T` of an argument: `glRotatef(20, 0, 0, 1)` compiles there, so it does here.
///
/// Floats lose precision and fractions as in C, and stop at the ends of a range where C leaves open what happens. An
/// integer of 32 bits becomes the other kind bit for bit, one of 64 bits that does not fit stops at the end of the range (a
/// `GLsizeiptr` becomes -1, which no command takes). Booleans are 0 and 1. An enumerant, a bit field or a name (`u32`) is
/// given as an integer, never as a float.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number that C would convert to `{T}`",
    label = "a number for an argument of type `{T}` is needed",
    note = "arrays are taken by the commands that end in `v`; an enumerant, a bit field or a name is an integer",
    note = "behind a reference write `*value`"
)]
pub trait IntoGl<T>: sealed::Number {
    /// The value as `T`.
    fn into_gl(self) -> T;
}

macro_rules! numbers { ($($t:ty)*) => { $(impl sealed::Number for $t {})* }; }
numbers!(bool u8 i8 u16 i16 u32 i32 u64 i64 usize isize f32 f64);

macro_rules! conversions {
    ($($to:ty: $([$($from:ty)*] $v:ident => $e:expr),*;)*) => { $($($(
        impl IntoGl<$to> for $from {
            #[inline]
            fn into_gl(self) -> $to {
                let $v = self;
                $e
            }
        }
    )*)*)* };
}
conversions! {
    f32: [u8 i8 u16 i16 u32 i32 u64 i64 usize isize f32 f64] v => v as f32, [bool] v => f32::from(u8::from(v));
    f64: [u8 i8 u16 i16 u32 i32 u64 i64 usize isize f32 f64] v => v as f64, [bool] v => f64::from(u8::from(v));
    i8: [bool u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => v as i8, [f32 f64] v => v as i8;
    u8: [bool u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => v as u8, [f32 f64] v => v as u8;
    i16: [bool u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => v as i16, [f32 f64] v => v as i16;
    u16: [bool u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => v as u16, [f32 f64] v => v as u16;
    i32: [bool u8 i8 u16 i16 u32 i32 f32 f64] v => v as i32, [u64 i64 usize isize] v => of_64_bits(v as i128) as i32;
    u32: [bool u8 i8 u16 i16 u32 i32] v => v as u32, [u64 i64 usize isize] v => of_64_bits(v as i128);
    isize: [u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => isize::try_from(v as i128).unwrap_or(-1);
    bool: [bool] v => v, [u8 i8 u16 i16 u32 i32 u64 i64 usize isize] v => v != 0;
}

/// The 32 bits of an integer that may be a signed or an unsigned one of 32 bits; what is neither stops at the nearer end.
#[inline]
fn of_64_bits(value: i128) -> u32 {
    let signed = i32::try_from(value).map(i32::cast_unsigned);
    signed.or_else(|_| u32::try_from(value)).unwrap_or(if value < 0 {
        i32::MIN.cast_unsigned()
    } else {
        i32::MAX as u32
    })
}

/// An array argument that a command reads, by reference or by value: a slice, a `Vec`, an array, nested arrays, a vector or
/// matrix of glam; or a reference to one value.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no array of `{T}`",
    label = "an array of `{T}` is needed",
    note = "C does not convert arrays: `f` and `fv` commands take `f32`, `d` and `dv` take `f64`, `i` and `iv` take `i32`; \
            so a matrix of `f64` goes to `glLoadMatrixd`, one of `f32` to `glLoadMatrixf`",
    note = "one value is given as `&value`"
)]
pub trait InSlice<T>: sealed::Array<T> {
    /// The values in the order of memory.
    fn slice(&self) -> &[T];
}

/// An array argument that a command writes: a slice, a `Vec` as long as it is, an array, nested arrays, or one variable.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no array of `{T}` to be written to",
    label = "an array of `{T}`, or one variable of this type, is needed",
    note = "C does not convert arrays: `f` and `fv` commands take `f32`, `d` and `dv` take `f64`, `i` and `iv` take `i32`"
)]
pub trait OutSlice<T>: sealed::Array<T> {
    /// The places in the order of memory.
    fn slice_mut(&mut self) -> &mut [T];
}

macro_rules! slices {
    ($([$($generic:tt)*] $t:ty: $v:ident => $read:expr, $write:expr;)*) => {
        $(
            impl<T: Element $($generic)*> sealed::Array<T> for $t {}
            impl<T: Element $($generic)*> OutSlice<T> for $t {
                #[inline]
                fn slice_mut(&mut self) -> &mut [T] { let $v = self; $write }
            }
            slices!(read [$($generic)*] &$t: $v => $read);
            slices!(read [$($generic)*] &mut $t: $v => $read);
        )*
    };
    (read [$($generic:tt)*] $t:ty: $v:ident => $read:expr) => {
        impl<T: Element $($generic)*> sealed::Array<T> for $t {}
        impl<T: Element $($generic)*> InSlice<T> for $t { #[inline] fn slice(&self) -> &[T] { let $v = self; $read } }
    };
}
slices! {
    [] T: v => std::slice::from_ref(&**v), std::slice::from_mut(v);
    [] [T]: v => v, v;
    [] Vec<T>: v => v, v;
    [, const N: usize] [T; N]: v => &v[..], v;
    [, const N: usize] [[T; N]]: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize] Vec<[T; N]>: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize, const M: usize] [[T; N]; M]: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize, const M: usize] [[[T; N]; M]]: v => v.as_flattened().as_flattened(), v.as_flattened_mut().as_flattened_mut();
    [, const N: usize, const M: usize, const K: usize] [[[T; N]; M]; K]:
        v => v.as_flattened().as_flattened(), v.as_flattened_mut().as_flattened_mut();
}

macro_rules! by_value {
    ($([$($generic:tt)*] $t:ty: $v:ident => $read:expr;)*) => { $(
        impl<T: Element $($generic)*> InSlice<T> for $t { #[inline] fn slice(&self) -> &[T] { let $v = self; $read } }
    )* };
}
by_value! {
    [] Vec<T>: v => v;
    [, const N: usize] [T; N]: v => v;
    [, const N: usize] Vec<[T; N]>: v => v.as_flattened();
    [, const N: usize, const M: usize] [[T; N]; M]: v => v.as_flattened();
    [, const N: usize, const M: usize, const K: usize] [[[T; N]; M]; K]: v => v.as_flattened().as_flattened();
}

macro_rules! glam_types {
    ($($of:ty: $($t:ident $n:literal)*;)*) => { $($(
        impl sealed::Array<$of> for glam::$t {}
        impl sealed::Array<$of> for &glam::$t {}
        impl InSlice<$of> for glam::$t {
            #[inline]
            fn slice(&self) -> &[$of] { AsRef::<[$of; $n]>::as_ref(self) }
        }
        impl InSlice<$of> for &glam::$t {
            #[inline]
            fn slice(&self) -> &[$of] { AsRef::<[$of; $n]>::as_ref(*self) }
        }
    )*)* };
}
glam_types! {
    f32: Vec2 2 Vec3 3 Vec3A 3 Vec4 4 Mat4 16;
    f64: DVec2 2 DVec3 3 DVec4 4 DMat4 16;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Context;
    use crate::enums::*;

    fn sum(v: impl InSlice<f32>) -> f32 {
        v.slice().iter().sum()
    }

    #[test]
    fn arrays_of_every_shape_are_slices() {
        assert_eq!(sum(&[1.0, 2.0]), 3.0);
        assert_eq!(sum([1.0, 2.0]), 3.0);
        assert_eq!(sum(&[[1.0, 2.0], [3.0, 4.0]]), 10.0);
        assert_eq!(sum(&vec![1.0, 2.0][1..]), 2.0);
        assert_eq!(sum(vec![[1.0, 2.0]]), 3.0);
        assert_eq!(sum(&mut vec![[1.0, 2.0]]), 3.0);
        assert_eq!(sum(&0.5), 0.5);
        assert_eq!((sum(glam::Vec3::new(1.0, 2.0, 4.0)), sum(&glam::Mat4::IDENTITY)), (7.0, 4.0));
    }

    #[test]
    fn numbers_become_what_c_makes_of_them() {
        fn to<T>(v: impl IntoGl<T>) -> T {
            v.into_gl()
        }
        assert_eq!((to::<i32>(GL_REPEAT), to::<i32>(GL_TRUE), to::<i32>(true)), (0x2901, 1, 1));
        assert_eq!((to::<i32>(2.9), to::<i32>(-2.9f32), to::<i32>(u32::MAX)), (2, -2, -1));
        assert_eq!((to::<i32>(vec![0; 7].len()), to::<i32>(u64::MAX), to::<i32>(i64::MIN)), (7, i32::MAX, i32::MIN));
        assert_eq!((to::<u32>(-1), to::<u32>(0x8000_0000_usize)), (u32::MAX, 0x8000_0000));
        assert_eq!(
            (to::<f32>(GL_REPEAT), to::<f32>(0.1), to::<f64>(0.5f32), to::<f32>(true)),
            (10497.0, 0.1, 0.5, 1.0)
        );
        assert_eq!((to::<u8>(-1), to::<i16>(0x1_0002), to::<u16>(1.5)), (255, 2, 1));
        assert_eq!((to::<isize>(u64::MAX), to::<isize>(5u8)), (-1, 5));
        assert!(!to::<bool>(GL_FALSE) && to::<bool>(2) && to::<bool>(true));
    }

    #[test]
    fn calls_as_a_c_program_writes_them() {
        let mut cx = Context::new(4, 4);
        let (mode, corners) = (GL_QUADS as i32, vec![[0u8; 3]; 4]);
        cx.matrix_mode(GL_PROJECTION);
        cx.ortho(0, 4, 0, 4.0f32, -1, 1);
        cx.rotatef(20, 0, 0, 1);
        cx.rotated(-20, 0, 0, 1.0f32);
        cx.alpha_func(GL_GREATER, 0.5f64);
        cx.viewport(0, 0, 4.0, 4u8);
        cx.color3f(1, 0, 0);
        cx.begin(mode);
        for (x, y) in [(0, 0), (4, 0), (4, 4), (0, 4)] {
            cx.vertex3f(x, y, 0);
        }
        cx.end();
        assert_eq!(cx.pixels()[..4], [255, 0, 0, 255]);
        cx.load_matrixf(glam::Mat4::from_scale(glam::Vec3::splat(2.0)));
        cx.mult_matrixd(&glam::DMat4::from_scale(glam::DVec3::splat(0.5)));
        let mut matrix = [0.0f64; 16];
        cx.get_doublev(GL_PROJECTION_MATRIX, &mut matrix);
        assert_eq!(matrix, glam::DMat4::IDENTITY.to_cols_array());
        cx.color4fv(glam::Vec4::new(0.0, 1.0, 0.0, 1.0));
        cx.lightfv(GL_LIGHT0, GL_POSITION, [1.0, 0.0, 0.0, 0.0]);
        cx.enable_client_state(GL_VERTEX_ARRAY);
        cx.vertex_pointer(2, GL_FLOAT, 0, vec![[0.0f32, 0.0], [4.0, 0.0], [4.0, 4.0]]);
        cx.draw_arrays(GL_TRIANGLES, 0, corners.len() - 1);
        cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, [0u8, 1, 2]);
        cx.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &vec![0u8, 1, 2]);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, vec![0u8; 16]);
        cx.check().expect("no error");
    }
    #[cfg(feature = "bytemuck")]
    #[test]
    fn structs_and_vectors_are_interleaved_arrays() {
        use crate::context::ArrayData;
        // Six numbers: the first three are the colour, the last two the position.
        type Vertex = [f32; 6];
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| [0.0, 1.0, 0.0, 0.0, x, y]);
        let mut cx = Context::new(2, 2);
        cx.enable_client_state(GL_VERTEX_ARRAY);
        cx.enable_client_state(GL_COLOR_ARRAY);
        cx.color_pointer(3, GL_FLOAT, size_of::<Vertex>(), ArrayData::of(&square));
        cx.vertex_pointer(2, GL_FLOAT, size_of::<Vertex>(), ArrayData::field(&square, 16));
        cx.draw_arrays(GL_QUADS, 0, square.len());
        assert_eq!(cx.pixels()[..4], [0, 255, 0, 255]);
        // A field that begins beyond the end leaves nothing to read.
        cx.vertex_pointer(2, GL_FLOAT, 0, ArrayData::field(&square[..1], 1000));
        cx.color4f(1, 0, 0, 1);
        cx.disable_client_state(GL_COLOR_ARRAY);
        cx.vertex_pointer(2, GL_FLOAT, 0, &square.map(|v| glam::Vec2::new(v[4], v[5])));
        cx.draw_arrays(GL_QUADS, 0, 4);
        assert_eq!(cx.pixels()[..4], [255, 0, 0, 255]);
        cx.check().expect("no error");
    }
}
