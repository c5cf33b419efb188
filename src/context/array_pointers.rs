//! The vertex arrays as data (OpenGL 1.5, tables 6.6 and 6.7): what the pointer commands said of each array, and which
//! buffer objects are bound.

use super::pixels_arg::ArrayData;
use crate::enums::{GL_BYTE, GL_DOUBLE, GL_FLOAT, GL_SHORT, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GLenum};
use crate::limits::MAX_TEXTURE_UNITS;

/// The arrays, in the order of their places in [`Arrays::pointers`]; texture units follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub(crate) enum Attribute {
    Vertex,
    Normal,
    Color,
    SecondaryColor,
    Index,
    FogCoord,
    EdgeFlag,
    /// Coordinates of unit 0.
    TexCoord,
}

/// How many arrays there are.
pub(crate) const ATTRIBUTES: usize = Attribute::TexCoord as usize + MAX_TEXTURE_UNITS;

/// One array: what its pointer command said.
#[derive(Clone, Debug)]
pub(crate) struct Pointer {
    pub(crate) enabled: bool,
    pub(crate) size: i32,
    pub(crate) type_: GLenum,
    pub(crate) stride: i32,
    /// How many elements the program has promised not to change (EXT_vertex_array).
    pub(crate) count: i32,
    pub(crate) data: ArrayData,
    /// Bytes from where `data` begins (interleaved arrays).
    pub(crate) offset: usize,
    /// The buffer object that `data` is an offset into; 0 for client memory.
    pub(crate) buffer: u32,
}

impl Pointer {
    fn new(size: i32, type_: GLenum) -> Self {
        Self { enabled: false, size, type_, stride: 0, count: 0, data: ArrayData::Offset(0), offset: 0, buffer: 0 }
    }

    /// Bytes of one element.
    pub(crate) fn element_bytes(&self) -> usize {
        self.size.unsigned_abs() as usize * type_bytes(self.type_)
    }

    /// Bytes from one element to the next.
    pub(crate) fn stride_bytes(&self) -> usize {
        if self.stride > 0 { self.stride.unsigned_abs() as usize } else { self.element_bytes() }
    }
}

/// What a place in the list of arrays is called in a message.
pub(crate) fn place_name(place: usize) -> &'static str {
    const NAMES: [&str; Attribute::TexCoord as usize] =
        ["vertex", "normal", "colour", "secondary colour", "colour index", "fog coordinate", "edge flag"];
    NAMES.get(place).copied().unwrap_or("texture coordinate")
}

/// Bytes of one number of a type.
pub(crate) fn type_bytes(type_: GLenum) -> usize {
    match type_ {
        GL_BYTE | GL_UNSIGNED_BYTE => 1,
        GL_SHORT | GL_UNSIGNED_SHORT => 2,
        GL_DOUBLE => 8,
        _ => 4,
    }
}

/// All arrays, and the buffer objects that are bound.
#[derive(Clone, Debug)]
pub(crate) struct Arrays {
    pub(crate) pointers: [Pointer; ATTRIBUTES],
    /// The client's active texture unit.
    pub(crate) active: usize,
    /// First element and count of what LockArraysEXT has locked.
    pub(super) locked: Option<[i32; 2]>,
    pub(crate) array_buffer: u32,
    pub(crate) element_buffer: u32,
    /// The vertex array object that is bound.
    pub(crate) object: u32,
}

impl Default for Arrays {
    fn default() -> Self {
        Self {
            pointers: std::array::from_fn(|i| match i {
                _ if i == Attribute::Normal as usize => Pointer::new(3, GL_FLOAT),
                _ if i == Attribute::SecondaryColor as usize => Pointer::new(3, GL_FLOAT),
                _ if i == Attribute::Index as usize || i == Attribute::FogCoord as usize => Pointer::new(1, GL_FLOAT),
                _ if i == Attribute::EdgeFlag as usize => Pointer::new(1, GL_UNSIGNED_BYTE),
                _ => Pointer::new(4, GL_FLOAT),
            }),
            active: 0,
            locked: None,
            array_buffer: 0,
            element_buffer: 0,
            object: 0,
        }
    }
}

impl Arrays {
    /// The place of an attribute; texture coordinates are those of the client's active unit.
    fn place(&self, attribute: Attribute) -> usize {
        attribute as usize + if attribute == Attribute::TexCoord { self.active } else { 0 }
    }

    /// An attribute's array.
    pub(crate) fn get(&self, attribute: Attribute) -> &Pointer {
        &self.pointers[self.place(attribute)]
    }

    /// An attribute's array, to be changed.
    pub(super) fn get_mut(&mut self, attribute: Attribute) -> &mut Pointer {
        let place = self.place(attribute);
        &mut self.pointers[place]
    }

    /// Whether an enabled array lies in a C program's memory, whose length nobody knows.
    pub(crate) fn has_client_memory(&self) -> bool {
        self.pointers.iter().any(|p| p.enabled && p.buffer == 0 && matches!(p.data, ArrayData::Client(_)))
    }

    /// Bindings of a deleted buffer object become 0.
    pub(crate) fn forget_buffer(&mut self, buffer: u32) {
        let bindings = self.pointers.iter_mut().map(|p| &mut p.buffer);
        for binding in bindings.chain([&mut self.array_buffer, &mut self.element_buffer]) {
            if *binding == buffer {
                *binding = 0;
            }
        }
    }
}
