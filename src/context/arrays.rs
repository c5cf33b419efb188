//! Vertex array state (OpenGL 1.5, section 2.8, tables 6.6 and 6.7): where each attribute's values lie and whether its
//! array is on. One table says which sizes and types each array takes; all pointer commands are a row's worth of check
//! and one assignment. Nothing is read here: that happens when something is drawn.

use super::Values;
use super::array_pointers::{Attribute, Pointer, type_bytes};
use super::engine::Engine;
use super::pixels_arg::ArrayData;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation, invalid_value, out_of_memory};
use crate::limits::MAX_TEXTURE_UNITS;

const COORDINATES: &[GLenum] = &[GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE];
const COLORS: &[GLenum] =
    &[GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE];

/// Sizes and types of an array (table 2.4).
fn allowed(attribute: Attribute) -> (&'static [i32], &'static [GLenum]) {
    match attribute {
        Attribute::Vertex => (&[2, 3, 4], COORDINATES),
        Attribute::Normal => (&[3], &[GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE]),
        Attribute::Color => (&[3, 4], COLORS),
        Attribute::SecondaryColor => (&[3], COLORS),
        Attribute::Index => (&[1], &[GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE]),
        Attribute::FogCoord => (&[1], &[GL_FLOAT, GL_DOUBLE]),
        Attribute::EdgeFlag => (&[1], &[GL_UNSIGNED_BYTE]),
        Attribute::TexCoord => (&[1, 2, 3, 4], COORDINATES),
    }
}

/// A format of InterleavedArrays (table 2.5): texture coordinates, colour (size, type), whether a normal, vertex size.
type Interleaved = (GLenum, i32, (i32, GLenum), bool, i32);

const INTERLEAVED: [Interleaved; 14] = [
    (GL_V2F, 0, (0, 0), false, 2),
    (GL_V3F, 0, (0, 0), false, 3),
    (GL_C4UB_V2F, 0, (4, GL_UNSIGNED_BYTE), false, 2),
    (GL_C4UB_V3F, 0, (4, GL_UNSIGNED_BYTE), false, 3),
    (GL_C3F_V3F, 0, (3, GL_FLOAT), false, 3),
    (GL_N3F_V3F, 0, (0, 0), true, 3),
    (GL_C4F_N3F_V3F, 0, (4, GL_FLOAT), true, 3),
    (GL_T2F_V3F, 2, (0, 0), false, 3),
    (GL_T4F_V4F, 4, (0, 0), false, 4),
    (GL_T2F_C4UB_V3F, 2, (4, GL_UNSIGNED_BYTE), false, 3),
    (GL_T2F_C3F_V3F, 2, (3, GL_FLOAT), false, 3),
    (GL_T2F_N3F_V3F, 2, (0, 0), true, 3),
    (GL_T2F_C4F_N3F_V3F, 2, (4, GL_FLOAT), true, 3),
    (GL_T4F_C4F_N3F_V4F, 4, (4, GL_FLOAT), true, 4),
];

fn negative_stride(stride: i32) -> GlError {
    invalid_value(format!("a stride of {stride} bytes; a stride is not negative, and 0 means tightly packed"))
}

impl Engine {
    /// What all pointer commands do.
    fn set_pointer(&mut self, attribute: Attribute, size: i32, type_: GLenum, stride: i32, data: ArrayData) -> Outcome {
        let (sizes, types) = allowed(attribute);
        if !sizes.contains(&size) {
            return Err(invalid_value(format!("{size} components; the array takes {sizes:?}")));
        }
        if !types.contains(&type_) {
            let names: Vec<String> = types.iter().map(|t| name(*t)).collect();
            return Err(invalid_enum(format!("{} is not a type of this array: {}", name(type_), names.join(", "))));
        }
        if stride < 0 {
            return Err(negative_stride(stride));
        }
        let (data, buffer) = self.resolve_array(data)?;
        let pointer = self.client.arrays.get_mut(attribute);
        *pointer = Pointer { enabled: pointer.enabled, size, type_, stride, count: 0, data, offset: 0, buffer };
        Ok(())
    }

    /// What the pointer commands of EXT_vertex_array do.
    fn set_static_pointer(
        &mut self,
        attribute: Attribute,
        (size, type_): (i32, GLenum),
        stride: i32,
        count: i32,
        data: ArrayData,
    ) -> Outcome {
        if count < 0 {
            return Err(invalid_value(format!("{count} elements that do not change; the count must not be negative")));
        }
        self.set_pointer(attribute, size, type_, stride, data)?;
        self.client.arrays.get_mut(attribute).count = count;
        Ok(())
    }

    /// With a buffer object bound, a pointer is an offset into it.
    fn resolve_array(&self, data: ArrayData) -> Outcome<(ArrayData, u32)> {
        let buffer = self.client.arrays.array_buffer;
        match data {
            ArrayData::Values(_) if buffer != 0 => Err(invalid_operation(format!(
                "buffer object {buffer} is bound to GL_ARRAY_BUFFER, so that an array is an offset into it; give a \
                 number, or bind buffer 0 first"
            ))),
            ArrayData::Values(_) | ArrayData::Client(_)
                if self.client.arrays.object != 0 && buffer == 0 && data.address() != 0 =>
            {
                Err(invalid_operation(format!(
                    "vertex array object {} is bound, whose arrays lie in buffer objects; bind a buffer object, or vertex \
                 array object 0 first",
                    self.client.arrays.object
                )))
            }
            ArrayData::NoMemory => Err(out_of_memory("no memory to copy the array; use a buffer object")),
            _ => Ok((data, buffer)),
        }
    }

    pub(crate) fn vertex_pointer(&mut self, size: i32, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::Vertex, size, type_, stride, pointer)
    }

    pub(crate) fn normal_pointer(&mut self, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::Normal, 3, type_, stride, pointer)
    }

    pub(crate) fn color_pointer(&mut self, size: i32, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::Color, size, type_, stride, pointer)
    }

    pub(crate) fn secondary_color_pointer(
        &mut self,
        size: i32,
        type_: GLenum,
        stride: i32,
        pointer: ArrayData,
    ) -> Outcome {
        self.set_pointer(Attribute::SecondaryColor, size, type_, stride, pointer)
    }

    pub(crate) fn index_pointer(&mut self, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::Index, 1, type_, stride, pointer)
    }

    pub(crate) fn fog_coord_pointer(&mut self, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::FogCoord, 1, type_, stride, pointer)
    }

    pub(crate) fn tex_coord_pointer(&mut self, size: i32, type_: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::TexCoord, size, type_, stride, pointer)
    }

    pub(crate) fn edge_flag_pointer(&mut self, stride: i32, pointer: ArrayData) -> Outcome {
        self.set_pointer(Attribute::EdgeFlag, 1, GL_UNSIGNED_BYTE, stride, pointer)
    }

    pub(crate) fn vertex_pointer_ext(
        &mut self,
        size: i32,
        type_: GLenum,
        stride: i32,
        count: i32,
        pointer: ArrayData,
    ) -> Outcome {
        self.set_static_pointer(Attribute::Vertex, (size, type_), stride, count, pointer)
    }

    pub(crate) fn normal_pointer_ext(&mut self, type_: GLenum, stride: i32, count: i32, pointer: ArrayData) -> Outcome {
        self.set_static_pointer(Attribute::Normal, (3, type_), stride, count, pointer)
    }

    pub(crate) fn color_pointer_ext(
        &mut self,
        size: i32,
        type_: GLenum,
        stride: i32,
        count: i32,
        pointer: ArrayData,
    ) -> Outcome {
        self.set_static_pointer(Attribute::Color, (size, type_), stride, count, pointer)
    }

    pub(crate) fn index_pointer_ext(&mut self, type_: GLenum, stride: i32, count: i32, pointer: ArrayData) -> Outcome {
        self.set_static_pointer(Attribute::Index, (1, type_), stride, count, pointer)
    }

    pub(crate) fn tex_coord_pointer_ext(
        &mut self,
        size: i32,
        type_: GLenum,
        stride: i32,
        count: i32,
        pointer: ArrayData,
    ) -> Outcome {
        self.set_static_pointer(Attribute::TexCoord, (size, type_), stride, count, pointer)
    }

    pub(crate) fn edge_flag_pointer_ext(&mut self, stride: i32, count: i32, pointer: ArrayData) -> Outcome {
        self.set_static_pointer(Attribute::EdgeFlag, (1, GL_UNSIGNED_BYTE), stride, count, pointer)
    }

    /// Arrays in one piece of memory: texture coordinates, colour, normal, vertex, in this order.
    pub(crate) fn interleaved_arrays(&mut self, format: GLenum, stride: i32, pointer: ArrayData) -> Outcome {
        let Some(&(_, tex, (color, color_type), normal, vertex)) = INTERLEAVED.iter().find(|row| row.0 == format)
        else {
            return Err(invalid_enum(format!("{} is not a format like GL_T2F_N3F_V3F", name(format))));
        };
        if stride < 0 {
            return Err(negative_stride(stride));
        }
        let (data, buffer) = self.resolve_array(pointer)?;
        let parts = [
            (Attribute::TexCoord, tex, GL_FLOAT),
            (Attribute::Color, color, color_type),
            (Attribute::Normal, if normal { 3 } else { 0 }, GL_FLOAT),
            (Attribute::Vertex, vertex, GL_FLOAT),
        ];
        let bytes = |size: i32, type_: GLenum| size.unsigned_abs() as usize * type_bytes(type_);
        let all: usize = parts.iter().map(|(_, size, type_)| bytes(*size, *type_)).sum();
        let stride = if stride == 0 { all as i32 } else { stride };
        let mut offset = 0;
        for (attribute, size, type_) in parts {
            let place = self.client.arrays.get_mut(attribute);
            place.enabled = size > 0;
            if size > 0 {
                let data = data.clone();
                *place = Pointer { enabled: true, size, type_, stride, count: 0, data, offset, buffer };
                offset += bytes(size, type_);
            }
        }
        for other in [Attribute::EdgeFlag, Attribute::Index, Attribute::SecondaryColor, Attribute::FogCoord] {
            self.client.arrays.get_mut(other).enabled = false;
        }
        Ok(())
    }

    pub(crate) fn enable_client_state(&mut self, array: GLenum) -> Outcome {
        self.set_client_state(array, true)
    }

    pub(crate) fn disable_client_state(&mut self, array: GLenum) -> Outcome {
        self.set_client_state(array, false)
    }

    pub(crate) fn set_client_state(&mut self, array: GLenum, on: bool) -> Outcome {
        let attribute = attribute(array)
            .ok_or_else(|| invalid_enum(format!("{} is not an array like GL_VERTEX_ARRAY", name(array))))?;
        self.client.arrays.get_mut(attribute).enabled = on;
        Ok(())
    }

    pub(crate) fn client_active_texture(&mut self, texture: GLenum) -> Outcome {
        let unit = texture.wrapping_sub(GL_TEXTURE0) as usize;
        if unit >= MAX_TEXTURE_UNITS {
            return Err(invalid_enum(format!(
                "{} is not a texture unit; there are GL_TEXTURE0 to GL_TEXTURE{}",
                name(texture),
                MAX_TEXTURE_UNITS - 1
            )));
        }
        self.client.arrays.active = unit;
        Ok(())
    }

    /// A promise that needs nothing: vertices are transformed once a draw anyway.
    pub(crate) fn lock_arrays(&mut self, first: i32, count: i32) -> Outcome {
        if first < 0 || count <= 0 {
            return Err(invalid_value(format!(
                "first = {first}, count = {count}; first must not be negative and count must be positive"
            )));
        }
        if self.client.arrays.locked.is_some() {
            return Err(invalid_operation("the arrays are locked already; call glUnlockArraysEXT first"));
        }
        self.client.arrays.locked = Some([first, count]);
        Ok(())
    }

    pub(crate) fn unlock_arrays(&mut self) -> Outcome {
        if self.client.arrays.locked.take().is_none() {
            return Err(invalid_operation("the arrays are not locked"));
        }
        Ok(())
    }

    /// Whether an array is on, for IsEnabled and Get.
    pub(crate) fn client_capability(&self, cap: GLenum) -> Option<bool> {
        attribute(cap).map(|attribute| self.client.arrays.get(attribute).enabled)
    }

    /// Array state, for Get.
    pub(crate) fn array_value(&self, pname: GLenum) -> Option<Values> {
        let arrays = &self.client.arrays;
        if let Some(on) = self.client_capability(pname) {
            return Some(Values::boolean(on));
        }
        let [first, count] = arrays.locked.unwrap_or_default();
        match pname {
            GL_CLIENT_ACTIVE_TEXTURE => return Some(Values::enumerant(GL_TEXTURE0 + arrays.active as u32)),
            GL_ARRAY_BUFFER_BINDING => return Some(Values::uint(arrays.array_buffer)),
            GL_VERTEX_ARRAY_BINDING => return Some(Values::uint(arrays.object)),
            GL_ELEMENT_ARRAY_BUFFER_BINDING => return Some(Values::uint(arrays.element_buffer)),
            GL_ARRAY_ELEMENT_LOCK_FIRST_EXT => return Some(Values::int(first)),
            GL_ARRAY_ELEMENT_LOCK_COUNT_EXT => return Some(Values::int(count)),
            _ => {}
        }
        let row = QUERIES.iter().find(|row| pname != 0 && row.1.contains(&pname))?;
        let pointer = arrays.get(row.0);
        Some(match row.1.iter().position(|p| *p == pname) {
            Some(0) => Values::int(pointer.size),
            Some(1) => Values::enumerant(pointer.type_),
            Some(2) => Values::int(pointer.stride),
            Some(3) => Values::int(pointer.count),
            _ => Values::uint(pointer.buffer),
        })
    }

    /// The address or offset of an array (section 6.1.11).
    pub(crate) fn get_pointer(&mut self, pname: GLenum) -> Outcome<Values> {
        let Some(row) = QUERIES.iter().find(|row| row.2 == pname) else {
            // The memory of feedback and selection is the context's own.
            return match pname {
                GL_FEEDBACK_BUFFER_POINTER | GL_SELECTION_BUFFER_POINTER => Ok(Values::address(0)),
                _ => Err(invalid_enum(format!("{} is not a pointer like GL_VERTEX_ARRAY_POINTER", name(pname)))),
            };
        };
        let pointer = self.client.arrays.get(row.0);
        Ok(Values::address(pointer.data.address().wrapping_add(pointer.offset)))
    }
}

/// The array that an enumerant of EnableClientState means.
fn attribute(array: GLenum) -> Option<Attribute> {
    Some(match array {
        GL_VERTEX_ARRAY => Attribute::Vertex,
        GL_NORMAL_ARRAY => Attribute::Normal,
        GL_COLOR_ARRAY => Attribute::Color,
        GL_SECONDARY_COLOR_ARRAY => Attribute::SecondaryColor,
        GL_INDEX_ARRAY => Attribute::Index,
        GL_FOG_COORD_ARRAY => Attribute::FogCoord,
        GL_EDGE_FLAG_ARRAY => Attribute::EdgeFlag,
        GL_TEXTURE_COORD_ARRAY => Attribute::TexCoord,
        _ => return None,
    })
}

/// Whether an enumerant is one of the arrays that `glEnable` turns on as well (EXT_vertex_array).
pub(crate) const fn is_array(capability: GLenum) -> bool {
    matches!(
        capability,
        GL_VERTEX_ARRAY
            | GL_NORMAL_ARRAY
            | GL_COLOR_ARRAY
            | GL_INDEX_ARRAY
            | GL_TEXTURE_COORD_ARRAY
            | GL_EDGE_FLAG_ARRAY
    )
}

/// For each array the names of its size, type, stride, count and buffer binding (0 where there is none), and of its
/// pointer.
const QUERIES: [(Attribute, [GLenum; 5], GLenum); 8] = [
    (
        Attribute::Vertex,
        [
            GL_VERTEX_ARRAY_SIZE,
            GL_VERTEX_ARRAY_TYPE,
            GL_VERTEX_ARRAY_STRIDE,
            GL_VERTEX_ARRAY_COUNT_EXT,
            GL_VERTEX_ARRAY_BUFFER_BINDING,
        ],
        GL_VERTEX_ARRAY_POINTER,
    ),
    (
        Attribute::Normal,
        [0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_NORMAL_ARRAY_COUNT_EXT, GL_NORMAL_ARRAY_BUFFER_BINDING],
        GL_NORMAL_ARRAY_POINTER,
    ),
    (
        Attribute::Color,
        [
            GL_COLOR_ARRAY_SIZE,
            GL_COLOR_ARRAY_TYPE,
            GL_COLOR_ARRAY_STRIDE,
            GL_COLOR_ARRAY_COUNT_EXT,
            GL_COLOR_ARRAY_BUFFER_BINDING,
        ],
        GL_COLOR_ARRAY_POINTER,
    ),
    (
        Attribute::SecondaryColor,
        [
            GL_SECONDARY_COLOR_ARRAY_SIZE,
            GL_SECONDARY_COLOR_ARRAY_TYPE,
            GL_SECONDARY_COLOR_ARRAY_STRIDE,
            0,
            GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING,
        ],
        GL_SECONDARY_COLOR_ARRAY_POINTER,
    ),
    (
        Attribute::Index,
        [0, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE, GL_INDEX_ARRAY_COUNT_EXT, GL_INDEX_ARRAY_BUFFER_BINDING],
        GL_INDEX_ARRAY_POINTER,
    ),
    (
        Attribute::FogCoord,
        [0, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE, 0, GL_FOG_COORD_ARRAY_BUFFER_BINDING],
        GL_FOG_COORD_ARRAY_POINTER,
    ),
    (
        Attribute::EdgeFlag,
        [0, 0, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_COUNT_EXT, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING],
        GL_EDGE_FLAG_ARRAY_POINTER,
    ),
    (
        Attribute::TexCoord,
        [
            GL_TEXTURE_COORD_ARRAY_SIZE,
            GL_TEXTURE_COORD_ARRAY_TYPE,
            GL_TEXTURE_COORD_ARRAY_STRIDE,
            GL_TEXTURE_COORD_ARRAY_COUNT_EXT,
            GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
        ],
        GL_TEXTURE_COORD_ARRAY_POINTER,
    ),
];
