//! Memory that a command reads or writes (OpenGL 1.5, sections 2.8, 3.6.4 and 4.3.2): pixels to unpack, pixels to pack,
//! vertex arrays and indices. In C all four are a `void *`; here each is a small enum that a slice, a `Vec`, a (nested)
//! array or [`NULL`] turns into, so that a length always travels with the memory and is checked before it is used.

use super::args::Element;
use crate::enums::GLenum;
use crate::num::{as_bytes, as_bytes_mut};
use std::borrow::Cow;
use std::sync::Arc;

/// No memory: C's `NULL`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Null;

/// No memory: C's `NULL`.
pub const NULL: Null = Null;

/// Pixels (or other bytes) that a command reads.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Pixels<'a> {
    /// No memory: an image of undefined content is allocated.
    Null,
    /// Memory that is laid out as the unpack state says.
    Bytes(Cow<'a, [u8]>),
    /// Pixels that a display list holds: rows without padding, native byte order, nothing skipped. While a list is
    /// carried out the unpack state is such.
    Kept(Arc<Vec<u8>>),
}

impl Pixels<'_> {
    /// The bytes, unless there is no memory.
    pub(crate) fn bytes(&self) -> Option<&[u8]> {
        match self {
            Pixels::Null => None,
            Pixels::Bytes(bytes) => Some(bytes),
            Pixels::Kept(bytes) => Some(bytes),
        }
    }

    /// Whether a display list has kept them: then the unpack state at the time of the call does not apply.
    pub(crate) fn is_tight(&self) -> bool {
        matches!(self, Pixels::Kept(_))
    }
}

/// Memory that a command writes pixels to.
#[derive(Debug)]
#[non_exhaustive]
pub enum PixelsMut<'a> {
    /// No memory.
    Null,
    /// Memory that is laid out as the pack state says.
    Bytes(&'a mut [u8]),
}

impl<'a> PixelsMut<'a> {
    /// The bytes; none if there is no memory.
    pub(crate) fn into_bytes(self) -> &'a mut [u8] {
        match self {
            PixelsMut::Null => &mut [],
            PixelsMut::Bytes(bytes) => bytes,
        }
    }
}

/// A vertex array: where `VertexPointer` and its sisters point to.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum ArrayData {
    /// An offset into the buffer object that is bound to `ARRAY_BUFFER`, or no memory at all.
    Offset(usize),
    /// Values copied at the time of the call. (In C the memory is read when something is drawn; a Rust program that
    /// changes its array calls the pointer command again, or uses a buffer object.)
    Values(Arc<Vec<u8>>),
    /// Values that there was no memory to copy: the command answers `OUT_OF_MEMORY`.
    NoMemory,
    /// Memory of a C program, read when something is drawn. An offset if a buffer object is bound.
    Client(ClientAddress),
}

/// An address of a C program's memory, of unknown length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClientAddress(usize);

impl ClientAddress {
    /// Takes an address.
    ///
    /// # Safety
    /// As long as this value or a copy of it is the pointer of a vertex array of some context, the elements that are drawn
    /// from that array must lie in readable memory at this address, which nobody writes meanwhile: what GL asks of the
    /// pointer of a vertex array.
    #[expect(unsafe_code, reason = "a raw address from C")]
    #[must_use]
    pub unsafe fn new(address: usize) -> Self {
        Self(address)
    }

    /// The number.
    pub(crate) fn get(self) -> usize {
        self.0
    }
}

/// A copy, unless there is no memory for it.
pub(crate) fn try_copy<T: Copy>(values: &[T]) -> Option<Vec<T>> {
    let mut copy = Vec::new();
    copy.try_reserve_exact(values.len()).ok()?;
    copy.extend_from_slice(values);
    Some(copy)
}

impl ArrayData {
    /// The values of a Rust program's array.
    fn copied(values: &[u8]) -> Self {
        try_copy(values).map_or(Self::NoMemory, |values| Self::Values(Arc::new(values)))
    }

    /// Bytes of an array that is not in a buffer object: those that a draw reads at a distance from the start. `None`
    /// where there is no memory or not enough.
    pub(crate) fn bytes(&self, offset: usize, len: usize) -> Option<&[u8]> {
        match self {
            ArrayData::Offset(_) | ArrayData::NoMemory => None,
            ArrayData::Values(values) => values.get(offset..)?.get(..len),
            ArrayData::Client(ClientAddress(0)) => None,
            ArrayData::Client(ClientAddress(address)) => {
                let start = address.checked_add(offset)?;
                start.checked_add(len).filter(|end| *end <= isize::MAX.cast_unsigned())?;
                #[expect(unsafe_code, reason = "client memory has no other door")]
                // SAFETY: `ClientAddress::new` was promised that what a draw reads is readable.
                Some(unsafe { std::slice::from_raw_parts(start as *const u8, len) })
            }
        }
    }

    /// What `GetPointerv` reports: the address or the offset.
    pub(crate) fn address(&self) -> usize {
        match self {
            ArrayData::Offset(offset) => *offset,
            ArrayData::NoMemory => 0,
            ArrayData::Values(values) => values.as_ptr() as usize,
            ArrayData::Client(address) => address.get(),
        }
    }
}

/// The index list of `DrawElements` and its sisters.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Indices<'a> {
    /// An offset into the buffer object that is bound to `ELEMENT_ARRAY_BUFFER`, or no memory at all.
    Offset(usize),
    /// The indices themselves.
    Bytes(Cow<'a, [u8]>),
}

macro_rules! conversions {
    ($($(#[$meta:meta])* $trait:ident $(<$l:lifetime>)? $method:ident $to:ty;)*) => { $(
        $(#[$meta])*
        pub trait $trait $(<$l>)? {
            /// The memory that the command reads or writes.
            fn $method(self) -> $to;
        }
        impl $(<$l>)? $trait $(<$l>)? for $to {
            fn $method(self) -> $to { self }
        }
    )* };
}
conversions! {
    /// Pixels or other bytes that a command reads: a slice, a `Vec` or a (nested) array, by reference or by value, a string,
    /// or [`NULL`].
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no memory that a command can read",
        label = "a slice, a `Vec`, an array or `NULL` is needed",
        note = "write `NULL` (or `None`) where C passes 0; structs go by `Pixels::of(&values)` (feature `bytemuck`)"
    )]
    IntoPixels<'a> into_pixels Pixels<'a>;
    /// Memory that a command writes pixels to: a mutable reference to a slice, a `Vec` or a (nested) array, or [`NULL`].
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no memory that a command can write",
        label = "`&mut` of a slice, a `Vec` or an array is needed",
        note = "write `NULL` where C passes 0"
    )]
    IntoPixelsMut<'a> into_pixels_mut PixelsMut<'a>;
    /// A vertex array: a slice, a `Vec` or a (nested) array, by reference or by value, an offset into the bound buffer
    /// object, or [`NULL`].
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no vertex array",
        label = "a slice, a `Vec`, an array, an offset into the bound buffer object or `NULL` is needed",
        note = "structs go by `ArrayData::of(&vertices)` and `ArrayData::field(&vertices, offset_of!(Vertex, name))` \
                (feature `bytemuck`)"
    )]
    IntoArray into_array ArrayData;
    /// A list of indices: a slice, a `Vec` or an array, by reference or by value, an offset into the bound buffer object, or
    /// [`NULL`].
    #[diagnostic::on_unimplemented(
        message = "`{Self}` is no list of indices",
        label = "a slice, a `Vec`, an array, an offset into the bound buffer object or `NULL` is needed"
    )]
    IntoIndices<'a> into_indices Indices<'a>;
}

/// The lists of `MultiDrawElements`: a slice of slices, or of arrays, or of offsets into a buffer object.
pub trait IndexLists {
    /// One index list for each primitive.
    fn lists(&self) -> Vec<Indices<'_>>;
}

macro_rules! lists {
    ($([$($generic:tt)*] $t:ty;)*) => { $(
        impl<T $($generic)*> IndexLists for $t
        where
            for<'a> &'a T: IntoIndices<'a>,
        {
            fn lists(&self) -> Vec<Indices<'_>> {
                self.iter().map(IntoIndices::into_indices).collect()
            }
        }
    )* };
}
lists! {
    [] [T];
    [] &[T];
    [] Vec<T>;
    [] &Vec<T>;
    [, const N: usize] [T; N];
    [, const N: usize] &[T; N];
}

macro_rules! readable {
    ($([$($generic:tt)*] $t:ty: $v:ident => $slice:expr;)*) => {
        $(
            impl<'a, T: Element $($generic)*> IntoPixels<'a> for &'a $t {
                fn into_pixels(self) -> Pixels<'a> { let $v = self; Pixels::Bytes(Cow::Borrowed(as_bytes($slice))) }
            }
            impl<'a, T: Element $($generic)*> IntoPixels<'a> for &'a mut $t {
                fn into_pixels(self) -> Pixels<'a> { IntoPixels::into_pixels(&*self) }
            }
            impl<'a, T: Element $($generic)*> IntoIndices<'a> for &'a $t {
                fn into_indices(self) -> Indices<'a> { let $v = self; Indices::Bytes(Cow::Borrowed(as_bytes($slice))) }
            }
            impl<T: Element $($generic)*> IntoArray for &$t {
                fn into_array(self) -> ArrayData { let $v = self; ArrayData::copied(as_bytes($slice)) }
            }
            impl<'a, T: Element $($generic)*> IntoPixelsMut<'a> for &'a mut $t {
                fn into_pixels_mut(self) -> PixelsMut<'a> { let $v = self; PixelsMut::Bytes(as_bytes_mut($slice)) }
            }
        )*
    };
}
readable! {
    [] [T]: v => v;
    [, const N: usize] [T; N]: v => v;
    [, const N: usize] [[T; N]]: v => Flat::flat(v);
    [, const N: usize, const M: usize] [[T; N]; M]: v => Flat::flat(v);
    [, const N: usize, const M: usize] [[[T; N]; M]]: v => Flat::flat(Flat::flat(v));
    [, const N: usize, const M: usize, const K: usize] [[[T; N]; M]; K]: v => Flat::flat(Flat::flat(v));
    [] Vec<T>: v => Flat::whole(v);
    [, const N: usize] Vec<[T; N]>: v => Flat::flat(Flat::whole(v));
    [, const N: usize, const M: usize] Vec<[[T; N]; M]>: v => Flat::flat(Flat::flat(Flat::whole(v)));
}

macro_rules! by_value {
    ($([$($generic:tt)*] $t:ty;)*) => {
        $(
            impl<T: Element $($generic)*> IntoPixels<'_> for $t {
                fn into_pixels(self) -> Pixels<'static> {
                    let Pixels::Bytes(bytes) = IntoPixels::into_pixels(&self) else { return Pixels::Null };
                    Pixels::Bytes(Cow::Owned(bytes.into_owned()))
                }
            }
            impl<T: Element $($generic)*> IntoIndices<'_> for $t {
                fn into_indices(self) -> Indices<'static> {
                    let Indices::Bytes(bytes) = IntoIndices::into_indices(&self) else { return Indices::Offset(0) };
                    Indices::Bytes(Cow::Owned(bytes.into_owned()))
                }
            }
            impl<T: Element $($generic)*> IntoArray for $t {
                fn into_array(self) -> ArrayData { IntoArray::into_array(&self) }
            }
        )*
    };
}
by_value! {
    [, const N: usize] [T; N];
    [, const N: usize, const M: usize] [[T; N]; M];
    [, const N: usize, const M: usize, const K: usize] [[[T; N]; M]; K];
    [] Vec<T>;
    [, const N: usize] Vec<[T; N]>;
    [, const N: usize, const M: usize] Vec<[[T; N]; M]>;
}

/// Takes one level of nesting away from a shared or a mutable slice alike.
trait Flat {
    type Flat;
    type Whole;
    fn flat(self) -> Self::Flat;
    fn whole(self) -> Self::Whole;
}

macro_rules! flats {
    ($([$($generic:tt)*] $t:ty, $flat:ty, $whole:ty: $v:ident => $f:expr, $w:expr;)*) => {
        $(impl<'a, $($generic)*> Flat for $t {
            type Flat = $flat;
            type Whole = $whole;
            fn flat(self) -> $flat { let $v = self; $f }
            fn whole(self) -> $whole { let $v = self; $w }
        })*
    };
}
flats! {
    [T, const N: usize] &'a [[T; N]], &'a [T], &'a [[T; N]]: v => v.as_flattened(), v;
    [T, const N: usize] &'a mut [[T; N]], &'a mut [T], &'a mut [[T; N]]: v => v.as_flattened_mut(), v;
    [T, const N: usize, const M: usize] &'a [[T; N]; M], &'a [T], &'a [[T; N]]: v => v.as_flattened(), v;
    [T, const N: usize, const M: usize] &'a mut [[T; N]; M], &'a mut [T], &'a mut [[T; N]]: v => v.as_flattened_mut(), v;
    [T] &'a Vec<T>, &'a [T], &'a [T]: v => v, v;
    [T] &'a mut Vec<T>, &'a mut [T], &'a mut [T]: v => v, v;
}

macro_rules! others {
    ($($from:ty: $trait:ident $(<$l:lifetime>)? $method:ident $to:ty, $v:ident => $e:expr;)*) => { $(
        impl $(<$l>)? $trait $(<$l>)? for $from {
            fn $method(self) -> $to { let $v = self; $e }
        }
    )* };
}
others! {
    Null: IntoPixels<'a> into_pixels Pixels<'a>, _v => Pixels::Null;
    &'a str: IntoPixels<'a> into_pixels Pixels<'a>, v => Pixels::Bytes(Cow::Borrowed(v.as_bytes()));
    Option<&'a [u8]>: IntoPixels<'a> into_pixels Pixels<'a>,
        v => v.map_or(Pixels::Null, |bytes| Pixels::Bytes(Cow::Borrowed(bytes)));
    Null: IntoPixelsMut<'a> into_pixels_mut PixelsMut<'a>, _v => PixelsMut::Null;
    Null: IntoArray into_array ArrayData, _v => ArrayData::Offset(0);
    usize: IntoArray into_array ArrayData, v => ArrayData::Offset(v);
    i32: IntoArray into_array ArrayData, v => ArrayData::Offset(v as usize);
    Null: IntoIndices<'a> into_indices Indices<'a>, _v => Indices::Offset(0);
    usize: IntoIndices<'a> into_indices Indices<'a>, v => Indices::Offset(v);
    i32: IntoIndices<'a> into_indices Indices<'a>, v => Indices::Offset(v as usize);
    &usize: IntoIndices<'a> into_indices Indices<'a>, v => Indices::Offset(*v);
}

impl<'a, T: Element> IntoIndices<'a> for &'a &[T] {
    fn into_indices(self) -> Indices<'a> {
        Indices::Bytes(Cow::Borrowed(as_bytes(self)))
    }
}

#[cfg(feature = "bytemuck")]
#[cfg_attr(docsrs, doc(cfg(feature = "bytemuck")))]
impl<'a> Pixels<'a> {
    /// The bytes of structs without padding, such as vertices for a buffer object.
    pub fn of<V: bytemuck::NoUninit>(values: &'a [V]) -> Self {
        Pixels::Bytes(Cow::Borrowed(bytemuck::cast_slice(values)))
    }
}

#[cfg(feature = "bytemuck")]
#[cfg_attr(docsrs, doc(cfg(feature = "bytemuck")))]
impl ArrayData {
    /// An array of structs without padding (`#[repr(C)]`, or vectors of glam), interleaved: the stride is the size of one.
    pub fn of<V: bytemuck::NoUninit>(vertices: &[V]) -> Self {
        Self::field(vertices, 0)
    }

    /// The array of one field of such structs, from its place (`offset_of!(Vertex, normal)`) in the first of them on.
    ///
    /// ```
    /// # use fixedgl::{Context, args::ArrayData, enums::*};
    /// use std::mem::offset_of;
    ///
    /// #[repr(C)]
    /// #[derive(Clone, Copy)] // and bytemuck::Pod, bytemuck::Zeroable (feature `derive` of that crate)
    /// struct Vertex {
    ///     position: [f32; 3],
    ///     color: [u8; 4],
    /// }
    /// # unsafe impl bytemuck::Zeroable for Vertex {}
    /// # unsafe impl bytemuck::Pod for Vertex {}
    /// # let mut cx = Context::new(4, 4);
    /// let vertices = vec![Vertex { position: [0.0; 3], color: [255; 4] }; 3];
    /// let stride = size_of::<Vertex>();
    /// cx.vertex_pointer(3, GL_FLOAT, stride, ArrayData::of(&vertices));
    /// cx.color_pointer(4, GL_UNSIGNED_BYTE, stride, ArrayData::field(&vertices, offset_of!(Vertex, color)));
    /// # cx.check().unwrap();
    /// ```
    pub fn field<V: bytemuck::NoUninit>(vertices: &[V], offset: usize) -> Self {
        let bytes: &[u8] = bytemuck::cast_slice(vertices);
        ArrayData::copied(bytes.get(offset..).unwrap_or_default())
    }
}

#[cfg(feature = "bytemuck")]
macro_rules! glam_arrays {
    ($($t:ident)*) => { $(
        impl IntoArray for &[glam::$t] {
            fn into_array(self) -> ArrayData { ArrayData::of(self) }
        }
        impl IntoArray for &Vec<glam::$t> {
            fn into_array(self) -> ArrayData { ArrayData::of(self) }
        }
        impl IntoArray for Vec<glam::$t> {
            fn into_array(self) -> ArrayData { ArrayData::of(&self) }
        }
        impl<const N: usize> IntoArray for &[glam::$t; N] {
            fn into_array(self) -> ArrayData { ArrayData::of(self) }
        }
    )* };
}
#[cfg(feature = "bytemuck")]
glam_arrays!(Vec2 Vec3 Vec4 DVec2 DVec3 DVec4);

/// Bytes of one index of a type, if it is one.
#[must_use]
pub(crate) fn index_size(type_: GLenum) -> Option<usize> {
    match type_ {
        crate::enums::GL_UNSIGNED_BYTE => Some(1),
        crate::enums::GL_UNSIGNED_SHORT => Some(2),
        crate::enums::GL_UNSIGNED_INT => Some(4),
        _ => None,
    }
}
