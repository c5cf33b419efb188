//! Reading vertex arrays (OpenGL 1.5, section 2.8): from bytes with a stride to lanes of a vertex batch. One loop a type and
//! size, made from one generic function; an element that lies outside of what is there reads as zeros, so that a wrong
//! index or a buffer object that is too small never reads foreign memory.

use super::array_pointers::{ATTRIBUTES, Arrays, Attribute, Pointer};
use super::buffer_objects::Buffers;
use super::convert::{Component, Coordinate};
use super::pixels_arg::ArrayData;
use crate::enums::*;
use crate::simd::LANES;
use crate::vertex::batch::{Lanes, VertexBatch, needs};
use crate::vertex::source::{Keys, VertexSource};

/// A number in memory.
trait Stored: Coordinate + Component {
    const BYTES: usize;
    fn read(bytes: &[u8]) -> Self;
}

macro_rules! stored {
    ($($t:ty)*) => { $(impl Stored for $t {
        const BYTES: usize = size_of::<$t>();
        #[inline(always)]
        fn read(bytes: &[u8]) -> Self {
            bytes.first_chunk().map_or_else(Self::default, |b| Self::from_ne_bytes(*b))
        }
    })* };
}
stored!(u8 i8 u16 i16 u32 i32 f32 f64);

/// Reads the elements of some indices into lanes: bytes, stride, the index that the bytes begin with, the indices.
type Reader = fn(&[u8], usize, u32, &Keys<'_>, &mut [Lanes]);

#[inline(always)]
fn read<T: Stored, const N: usize>(
    (bytes, stride, first): (&[u8], usize, u32),
    keys: &Keys<'_>,
    out: &mut [Lanes],
    convert: impl Fn(T) -> f32,
) {
    let Some(out) = out.first_chunk_mut::<N>() else { return };
    let mut put = |lane: usize, element: Option<&[u8]>| {
        for (c, lanes) in out.iter_mut().enumerate() {
            lanes[lane] = match element {
                Some(element) => convert(T::read(&element[c * T::BYTES..])),
                None => 0.0,
            };
        }
    };
    let at = |id: u32| id.wrapping_sub(first) as usize * stride;
    match keys {
        Keys::Range(range) => {
            let mut rest = bytes.get(at(range.start)..).unwrap_or_default();
            for lane in 0..range.len().min(LANES) {
                put(lane, rest.get(..N * T::BYTES));
                rest = rest.get(stride..).unwrap_or_default();
            }
        }
        Keys::List(ids) => {
            for (lane, id) in ids.iter().enumerate().take(LANES) {
                put(lane, bytes.get(at(*id)..).and_then(|b| b.get(..N * T::BYTES)));
            }
        }
    }
}

fn numbers<T: Stored, const N: usize>(bytes: &[u8], stride: usize, first: u32, keys: &Keys<'_>, out: &mut [Lanes]) {
    read::<T, N>((bytes, stride, first), keys, out, T::float);
}

fn fractions<T: Stored, const N: usize>(bytes: &[u8], stride: usize, first: u32, keys: &Keys<'_>, out: &mut [Lanes]) {
    read::<T, N>((bytes, stride, first), keys, out, T::unit);
}

/// The reader of a type and size; `unit` takes integers as fractions of their range (colours, normals).
fn reader(type_: GLenum, size: i32, unit: bool) -> Option<Reader> {
    macro_rules! sizes {
        ($f:ident, $t:ty) => {
            match size {
                1 => $f::<$t, 1>,
                2 => $f::<$t, 2>,
                3 => $f::<$t, 3>,
                _ => $f::<$t, 4>,
            }
        };
    }
    Some(match (type_, unit) {
        (GL_FLOAT, _) => sizes!(numbers, f32),
        (GL_DOUBLE, _) => sizes!(numbers, f64),
        (GL_BYTE, _) => sizes!(fractions, i8),
        (GL_UNSIGNED_BYTE, true) => sizes!(fractions, u8),
        (GL_UNSIGNED_BYTE, false) => sizes!(numbers, u8),
        (GL_SHORT, true) => sizes!(fractions, i16),
        (GL_SHORT, false) => sizes!(numbers, i16),
        (GL_UNSIGNED_SHORT, _) => sizes!(fractions, u16),
        (GL_INT, true) => sizes!(fractions, i32),
        (GL_INT, false) => sizes!(numbers, i32),
        (GL_UNSIGNED_INT, _) => sizes!(fractions, u32),
        _ => return None,
    })
}

/// One enabled array, ready to be read.
#[derive(Clone, Copy)]
struct Array<'a> {
    bytes: &'a [u8],
    stride: usize,
    first: u32,
    size: usize,
    /// Bytes of one element.
    bytes_each: usize,
    reader: Reader,
}

/// The enabled arrays that a draw reads.
pub(crate) struct Sources<'a> {
    sources: [Option<Array<'a>>; ATTRIBUTES],
}

/// Whether an attribute's integers are fractions.
fn is_unit(place: usize) -> bool {
    place == Attribute::Normal as usize
        || place == Attribute::Color as usize
        || place == Attribute::SecondaryColor as usize
}

/// The bytes of an array from the element `first` on, at least to `last` where they are there.
fn bytes_from<'a>(p: &'a Pointer, buffers: &'a Buffers, first: u32, last: u32) -> &'a [u8] {
    let stride = p.stride_bytes();
    let skip = first as usize * stride + p.offset;
    if p.buffer != 0 {
        let start = match &p.data {
            ArrayData::Values(_) => 0,
            data => data.address(),
        };
        let data = buffers.get(p.buffer).map_or(&[][..], |buffer| &buffer.data);
        return start.checked_add(skip).and_then(|start| data.get(start..)).unwrap_or_default();
    }
    match &p.data {
        ArrayData::Values(values) => values.get(skip..).unwrap_or_default(),
        data => {
            let len = last.saturating_sub(first) as usize * stride + p.element_bytes();
            data.bytes(skip, len).unwrap_or_default()
        }
    }
}

impl<'a> Sources<'a> {
    /// The arrays for elements from `first` to `last`; `wanted` says which places of the table are read.
    pub(crate) fn new(
        arrays: &'a Arrays,
        buffers: &'a Buffers,
        (first, last): (u32, u32),
        wanted: impl Fn(usize) -> bool,
    ) -> Self {
        let mut sources = [None; ATTRIBUTES];
        for (place, (source, p)) in sources.iter_mut().zip(&arrays.pointers).enumerate() {
            if p.enabled && wanted(place) {
                *source = reader(p.type_, p.size, is_unit(place)).map(|reader| Array {
                    bytes: bytes_from(p, buffers, first, last),
                    stride: p.stride_bytes(),
                    first,
                    size: p.size.unsigned_abs() as usize,
                    bytes_each: p.element_bytes(),
                    reader,
                });
            }
        }
        Self { sources }
    }

    /// What a plan with these needs reads.
    pub(crate) fn wanted(place: usize, needs: u32) -> bool {
        let on = |bit: u32| needs & bit != 0;
        match place.checked_sub(Attribute::TexCoord as usize) {
            Some(unit) => on(needs::TEX << unit),
            None if place == Attribute::Vertex as usize => true,
            None if place == Attribute::Normal as usize => on(needs::NORMAL),
            None if place == Attribute::Color as usize => on(needs::COLOR),
            None if place == Attribute::SecondaryColor as usize => on(needs::SECONDARY),
            None if place == Attribute::FogCoord as usize => on(needs::FOG),
            None if place == Attribute::EdgeFlag as usize => on(needs::EDGE),
            None => false,
        }
    }

    /// The first array that does not reach to an element, and how many elements from the draw's first on it has.
    pub(crate) fn too_short(&self, last: u32) -> Option<(usize, usize)> {
        self.sources.iter().enumerate().find_map(|(place, source)| {
            let s = source.as_ref()?;
            let needed = last.saturating_sub(s.first) as usize * s.stride + s.bytes_each;
            let there = match s.bytes.len().checked_sub(s.bytes_each) {
                Some(rest) => rest / s.stride.max(1) + 1,
                None => 0,
            };
            (s.bytes.len() < needed).then_some((place, there))
        })
    }

    /// Sets what an array does not give of its attribute: the rest of (0, 0, 0, 1). Once a draw.
    pub(crate) fn defaults(&self, batch: &mut VertexBatch) {
        for (place, source) in self.sources.iter().enumerate() {
            let Some(source) = source else { continue };
            let Some(lanes) = lanes(batch, place) else { continue };
            for (c, lanes) in lanes.iter_mut().enumerate().skip(source.size) {
                *lanes = [if c == 3 { 1.0 } else { 0.0 }; LANES];
            }
        }
    }

    /// One element of an array, where the array is enabled.
    pub(crate) fn element(&self, place: usize, id: u32) -> Option<[f32; 4]> {
        let s = self.sources.get(place)?.as_ref()?;
        let mut lanes = [[0.0; LANES]; 4];
        (s.reader)(s.bytes, s.stride, s.first, &Keys::List(&[id]), &mut lanes);
        let mut value = [0.0, 0.0, 0.0, 1.0];
        for (to, from) in value.iter_mut().zip(&lanes).take(s.size) {
            *to = from[0];
        }
        Some(value)
    }
}

impl VertexSource for Sources<'_> {
    fn positions(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        batch.n = keys.len().min(LANES);
        if let Some(s) = &self.sources[Attribute::Vertex as usize] {
            batch.w_is_one = s.size < 4;
            (s.reader)(s.bytes, s.stride, s.first, keys, &mut batch.position);
        }
        if let Some(s) = &self.sources[Attribute::EdgeFlag as usize] {
            for (i, flag) in batch.edge.iter_mut().enumerate() {
                let Some(id) = keys.get(i) else { break };
                let at = id.wrapping_sub(s.first) as usize * s.stride;
                *flag = s.bytes.get(at).is_some_and(|b| *b != 0);
            }
        }
    }

    fn attributes(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        for (place, source) in self.sources.iter().enumerate() {
            let Some(s) = source else { continue };
            if place != Attribute::Vertex as usize
                && let Some(lanes) = lanes(batch, place)
            {
                (s.reader)(s.bytes, s.stride, s.first, keys, lanes);
            }
        }
    }
}

/// The lanes of a batch that an array fills.
fn lanes(batch: &mut VertexBatch, place: usize) -> Option<&mut [Lanes]> {
    match place.checked_sub(Attribute::TexCoord as usize) {
        Some(unit) => batch.tex.get_mut(unit).map(<[Lanes; 4]>::as_mut_slice),
        None if place == Attribute::Vertex as usize => Some(&mut batch.position),
        None if place == Attribute::Normal as usize => Some(&mut batch.normal),
        None if place == Attribute::Color as usize => Some(&mut batch.color),
        None if place == Attribute::SecondaryColor as usize => Some(&mut batch.secondary),
        None if place == Attribute::FogCoord as usize => Some(std::slice::from_mut(&mut batch.fog)),
        None => None,
    }
}
