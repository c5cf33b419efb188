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

/// The lists of `MultiDrawElements`: a slice of slices, or of arrays, or of offsets into a buffer object.
pub trait IndexLists {
    /// One index list for each primitive.
    fn lists(&self) -> Vec<Indices<'_>>;
}

impl<T> IndexLists for [T]
where
    for<'a> &'a T: Into<Indices<'a>>,
{
    fn lists(&self) -> Vec<Indices<'_>> {
        self.iter().map(Into::into).collect()
    }
}

impl<T, const N: usize> IndexLists for [T; N]
where
    for<'a> &'a T: Into<Indices<'a>>,
{
    fn lists(&self) -> Vec<Indices<'_>> {
        self.iter().map(Into::into).collect()
    }
}

impl<T> IndexLists for Vec<T>
where
    for<'a> &'a T: Into<Indices<'a>>,
{
    fn lists(&self) -> Vec<Indices<'_>> {
        self.iter().map(Into::into).collect()
    }
}

/// The bytes of a slice of scalars.
fn bytes<T: Element>(values: &[T]) -> &[u8] {
    as_bytes(values)
}

macro_rules! readable {
    ($([$($generic:tt)*] $t:ty: $v:ident => $slice:expr;)*) => {
        $(
            impl<'a, T: Element $($generic)*> From<&'a $t> for Pixels<'a> {
                fn from($v: &'a $t) -> Self { Pixels::Bytes(Cow::Borrowed(bytes($slice))) }
            }
            impl<'a, T: Element $($generic)*> From<&'a $t> for Indices<'a> {
                fn from($v: &'a $t) -> Self { Indices::Bytes(Cow::Borrowed(bytes($slice))) }
            }
            impl<T: Element $($generic)*> From<&$t> for ArrayData {
                fn from($v: &$t) -> Self { ArrayData::copied(bytes($slice)) }
            }
            impl<'a, T: Element $($generic)*> From<&'a mut $t> for PixelsMut<'a> {
                fn from($v: &'a mut $t) -> Self { PixelsMut::Bytes(as_bytes_mut($slice)) }
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

macro_rules! nulls {
    ($($t:ident $(<$l:lifetime>)?: $null:expr;)*) => {
        $(
            impl $(<$l>)? From<Null> for $t $(<$l>)? { fn from(_: Null) -> Self { $null } }
        )*
    };
}
nulls! {
    Pixels<'a>: Pixels::Null;
    PixelsMut<'a>: PixelsMut::Null;
    ArrayData: ArrayData::Offset(0);
    Indices<'a>: Indices::Offset(0);
}

impl<'a> From<&'a str> for Pixels<'a> {
    fn from(text: &'a str) -> Self {
        Pixels::Bytes(Cow::Borrowed(text.as_bytes()))
    }
}

impl<'a> From<Option<&'a [u8]>> for Pixels<'a> {
    fn from(bytes: Option<&'a [u8]>) -> Self {
        bytes.map_or(Pixels::Null, |bytes| Pixels::Bytes(Cow::Borrowed(bytes)))
    }
}

impl From<usize> for ArrayData {
    fn from(offset: usize) -> Self {
        ArrayData::Offset(offset)
    }
}

impl From<i32> for ArrayData {
    fn from(offset: i32) -> Self {
        ArrayData::Offset(offset as usize)
    }
}

impl From<usize> for Indices<'_> {
    fn from(offset: usize) -> Self {
        Indices::Offset(offset)
    }
}

impl From<i32> for Indices<'_> {
    fn from(offset: i32) -> Self {
        Indices::Offset(offset as usize)
    }
}

impl From<&usize> for Indices<'_> {
    fn from(offset: &usize) -> Self {
        Indices::Offset(*offset)
    }
}

impl<'a, T: Element> From<&'a &[T]> for Indices<'a> {
    fn from(indices: &'a &[T]) -> Self {
        Indices::Bytes(Cow::Borrowed(bytes(indices)))
    }
}

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
