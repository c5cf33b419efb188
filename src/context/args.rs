//! What the Rust doors take in the place of C's implicit conversions and pointers (OpenGL 1.5, section 2.3): integers
//! that are fed with enumerants, booleans, floats that are fed with enumerants, and slices in every shape that a C
//! program's arrays take in Rust. The one idea: a call that compiles in C should compile here without casts.

/// The types that a slice argument can hold: GL's own scalars.
pub use crate::num::Scalar as Element;

/// Keeps the traits of this file to the types that GL's arguments have: more may come without breaking anybody.
mod sealed {
    /// A type that stands for a scalar argument.
    pub trait Scalar {}
    /// A type that stands for an array argument of `T`.
    pub trait Array<T> {}
}

macro_rules! scalars { ($($t:ty)*) => { $(impl sealed::Scalar for $t {})* }; }
scalars!(bool u8 i32 u32 i64 u64 isize usize f32 f64);

/// A `GLint` that C programs also feed with enumerants and booleans.
pub trait IntoInt: sealed::Scalar {
    /// The value as `GLint`, bit for bit.
    fn into_int(self) -> i32;
}

/// A `GLfloat` that C programs also feed with enumerants and integers.
pub trait IntoFloat: sealed::Scalar {
    /// The value as `GLfloat`.
    fn into_float(self) -> f32;
}

/// A size or an offset in bytes: whatever integer the program has it in. What does not fit is -1, which no command takes.
pub trait IntoSize: sealed::Scalar {
    /// The value as `GLsizeiptr`.
    fn into_size(self) -> isize;
}

macro_rules! sizes { ($($t:ty)*) => { $(impl IntoSize for $t {
    #[inline]
    fn into_size(self) -> isize { isize::try_from(self).unwrap_or(-1) }
})* }; }
sizes!(i32 u32 i64 u64 isize usize);

/// A `GLboolean`: `true`, `GL_TRUE` or any number that is not zero.
pub trait IntoBool: sealed::Scalar {
    /// Whether the value is not zero.
    fn into_bool(self) -> bool;
}

macro_rules! conversions {
    ($($t:ty: $v:ident => $int:expr, $float:expr, $bool:expr;)*) => {
        $(
            impl IntoInt for $t { #[inline] fn into_int(self) -> i32 { let $v = self; $int } }
            impl IntoFloat for $t { #[inline] fn into_float(self) -> f32 { let $v = self; $float } }
            impl IntoBool for $t { #[inline] fn into_bool(self) -> bool { let $v = self; $bool } }
        )*
    };
}
conversions! {
    i32: v => v, v as f32, v != 0;
    u32: v => v as i32, v as f32, v != 0;
    u8: v => i32::from(v), f32::from(v), v != 0;
    bool: v => i32::from(v), f32::from(u8::from(v)), v;
}

impl IntoFloat for f32 {
    #[inline]
    fn into_float(self) -> f32 {
        self
    }
}

impl IntoFloat for f64 {
    #[inline]
    fn into_float(self) -> f32 {
        self as f32
    }
}

/// An array argument that a command reads: a slice, a `Vec`, an array, nested arrays, or one value.
pub trait InSlice<T>: sealed::Array<T> {
    /// The values in the order of memory.
    fn slice(&self) -> &[T];
}

/// An array argument that a command writes: a slice, a `Vec` as long as it is, an array, nested arrays, or one variable.
pub trait OutSlice<T>: sealed::Array<T> {
    /// The places in the order of memory.
    fn slice_mut(&mut self) -> &mut [T];
}

macro_rules! slices {
    ($([$($generic:tt)*] $t:ty: $v:ident => $read:expr, $write:expr;)*) => {
        $(
            impl<T: Element $($generic)*> sealed::Array<T> for $t {}
            impl<T: Element $($generic)*> InSlice<T> for $t { #[inline] fn slice(&self) -> &[T] { let $v = self; $read } }
            impl<T: Element $($generic)*> OutSlice<T> for $t {
                #[inline]
                fn slice_mut(&mut self) -> &mut [T] { let $v = self; $write }
            }
        )*
    };
}
slices! {
    [] T: v => std::slice::from_ref(v), std::slice::from_mut(v);
    [] [T]: v => v, v;
    [] Vec<T>: v => v, v;
    [, const N: usize] [T; N]: v => v, v;
    [, const N: usize] [[T; N]]: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize] Vec<[T; N]>: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize, const M: usize] [[T; N]; M]: v => v.as_flattened(), v.as_flattened_mut();
    [, const N: usize, const M: usize] [[[T; N]; M]]: v => v.as_flattened().as_flattened(), v.as_flattened_mut().as_flattened_mut();
    [, const N: usize, const M: usize, const K: usize] [[[T; N]; M]; K]:
        v => v.as_flattened().as_flattened(), v.as_flattened_mut().as_flattened_mut();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(v: &(impl InSlice<f32> + ?Sized)) -> f32 {
        v.slice().iter().sum()
    }

    #[test]
    fn arrays_of_every_shape_are_slices() {
        assert_eq!(sum(&[1.0, 2.0]), 3.0);
        assert_eq!(sum(&[[1.0, 2.0], [3.0, 4.0]]), 10.0);
        assert_eq!(sum(&vec![1.0, 2.0][1..]), 2.0);
        assert_eq!(sum(&vec![[1.0, 2.0]]), 3.0);
        assert_eq!(sum(&0.5), 0.5);
    }

    #[test]
    fn enumerants_and_booleans_are_integers() {
        assert_eq!(crate::enums::GL_REPEAT.into_int(), 0x2901);
        assert_eq!(crate::enums::GL_TRUE.into_int(), 1);
        assert!(!crate::enums::GL_FALSE.into_bool());
        assert_eq!(crate::enums::GL_REPEAT.into_float(), 10497.0);
    }
}
