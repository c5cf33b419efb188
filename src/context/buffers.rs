//! Buffer objects (OpenGL 1.5, sections 2.9 and 6.1.13): bytes that the context owns, which vertex arrays and index lists
//! may come from. A data store is plain memory; usage is remembered and plays no part.

use super::buffer_objects::Buffer;
use super::engine::Engine;
use super::{Pixels, Values};
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation, invalid_value, out_of_memory, too_short};
use crate::limits::MAX_BUFFER_BYTES;

fn range(buffer: &Buffer, offset: isize, size: isize) -> Outcome<std::ops::Range<usize>> {
    let there = buffer.data.len();
    let range = usize::try_from(offset).ok().zip(usize::try_from(size).ok());
    match range.and_then(|(start, size)| Some(start..start.checked_add(size)?)).filter(|range| range.end <= there) {
        Some(range) => Ok(range),
        None => Err(invalid_value(format!(
            "{size} bytes from offset {offset} are not inside the buffer object, which holds {there}"
        ))),
    }
}

fn mapped() -> GlError {
    invalid_operation("the buffer object is mapped; call glUnmapBuffer first")
}

impl Engine {
    fn buffer_binding(&mut self, target: GLenum) -> Outcome<&mut u32> {
        match target {
            GL_ARRAY_BUFFER => Ok(&mut self.client.arrays.array_buffer),
            GL_ELEMENT_ARRAY_BUFFER => Ok(&mut self.client.arrays.element_buffer),
            _ => Err(invalid_enum(format!("{} is not GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER", name(target)))),
        }
    }

    fn bound_buffer(&mut self, target: GLenum) -> Outcome<&mut Buffer> {
        let bound = *self.buffer_binding(target)?;
        self.buffers.get_mut(bound).ok_or_else(|| {
            invalid_operation(format!("no buffer object is bound to {}; call glBindBuffer first", name(target)))
        })
    }

    pub(crate) fn bind_buffer(&mut self, target: GLenum, buffer: u32) -> Outcome {
        *self.buffer_binding(target)? = buffer;
        if buffer != 0 {
            self.buffers.named.entry(buffer).or_default().get_or_insert_default();
        }
        Ok(())
    }

    pub(crate) fn gen_buffers(&mut self, n: i32, buffers: &mut [u32]) -> Outcome {
        if n < 0 {
            return Err(invalid_value(format!("{n} names; a number of names is not negative")));
        }
        let all = &mut self.buffers.named;
        all.try_reserve(buffers.len()).map_err(|_| out_of_memory("no memory for names of buffer objects"))?;
        buffers.iter_mut().for_each(|name| *name = self.buffers.generate());
        Ok(())
    }

    pub(crate) fn delete_buffers(&mut self, n: i32, buffers: &[u32]) -> Outcome {
        if n < 0 {
            return Err(invalid_value(format!("{n} names; a number of names is not negative")));
        }
        for name in buffers.iter().filter(|name| **name != 0) {
            if self.buffers.named.remove(name).is_some() {
                self.client.arrays.forget_buffer(*name);
            }
        }
        Ok(())
    }

    pub(crate) fn is_buffer(&mut self, buffer: u32) -> bool {
        self.buffers.get(buffer).is_some()
    }

    pub(crate) fn buffer_data(&mut self, target: GLenum, size: isize, data: &Pixels<'_>, usage: GLenum) -> Outcome {
        self.buffer_binding(target)?;
        if !matches!(
            usage,
            GL_STREAM_DRAW
                | GL_STREAM_READ
                | GL_STREAM_COPY
                | GL_STATIC_DRAW
                | GL_STATIC_READ
                | GL_STATIC_COPY
                | GL_DYNAMIC_DRAW
                | GL_DYNAMIC_READ
                | GL_DYNAMIC_COPY
        ) {
            return Err(invalid_enum(format!("{} is not a usage like GL_STATIC_DRAW", name(usage))));
        }
        let size = usize::try_from(size)
            .map_err(|_| invalid_value(format!("a size of {size} bytes; a size is not negative")))?;
        let buffer = self.bound_buffer(target)?;
        if let Some(bytes) = data.bytes().filter(|bytes| bytes.len() < size) {
            return Err(too_short("data", size, bytes.len(), "bytes"));
        }
        if size > MAX_BUFFER_BYTES {
            let message = format!("a buffer object of {size} bytes; the most is {MAX_BUFFER_BYTES}");
            return Err(out_of_memory(message));
        }
        let mut store = std::mem::take(&mut buffer.data);
        if store.capacity() < size {
            let mut larger = Vec::new();
            if larger.try_reserve_exact(size).is_err() {
                buffer.data = store;
                return Err(out_of_memory(format!("no memory for a buffer object of {size} bytes")));
            }
            store = larger;
        }
        store.clear();
        let given = data.bytes().unwrap_or_default();
        store.extend_from_slice(given.get(..size).unwrap_or(given));
        store.resize(size, 0);
        *buffer = Buffer { data: store, usage, ..Buffer::default() };
        Ok(())
    }

    pub(crate) fn buffer_sub_data(&mut self, target: GLenum, offset: isize, size: isize, data: &Pixels<'_>) -> Outcome {
        let buffer = self.bound_buffer(target)?;
        let range = range(buffer, offset, size)?;
        if buffer.mapped {
            return Err(mapped());
        }
        let from = data.bytes().unwrap_or_default();
        let from = from.get(..range.len()).ok_or_else(|| too_short("data", range.len(), from.len(), "bytes"))?;
        if let Some(to) = buffer.data.get_mut(range) {
            to.copy_from_slice(from);
        }
        Ok(())
    }

    pub(crate) fn get_buffer_sub_data(
        &mut self,
        target: GLenum,
        offset: isize,
        size: isize,
        data: &mut [u8],
    ) -> Outcome {
        let buffer = self.bound_buffer(target)?;
        let range = range(buffer, offset, size)?;
        if buffer.mapped {
            return Err(mapped());
        }
        let there = data.len();
        let to = data.get_mut(..range.len()).ok_or_else(|| too_short("data", range.len(), there, "bytes"))?;
        if let Some(from) = buffer.data.get(range) {
            to.copy_from_slice(from);
        }
        Ok(())
    }

    pub(crate) fn map_buffer(&mut self, target: GLenum, access: GLenum) -> Outcome<&mut [u8]> {
        self.buffer_binding(target)?;
        if !matches!(access, GL_READ_ONLY | GL_WRITE_ONLY | GL_READ_WRITE) {
            return Err(invalid_enum(format!("{} is not GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE", name(access))));
        }
        let buffer = self.bound_buffer(target)?;
        if buffer.mapped {
            return Err(mapped());
        }
        (buffer.mapped, buffer.access) = (true, access);
        Ok(&mut buffer.data)
    }

    /// Memory is never lost, so that the answer is always that the data store is intact.
    pub(crate) fn unmap_buffer(&mut self, target: GLenum) -> Outcome<bool> {
        let buffer = self.bound_buffer(target)?;
        if !std::mem::take(&mut buffer.mapped) {
            return Err(invalid_operation("the buffer object is not mapped; call glMapBuffer first"));
        }
        Ok(true)
    }

    pub(crate) fn get_buffer_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        self.buffer_binding(target)?;
        if !matches!(pname, GL_BUFFER_SIZE | GL_BUFFER_USAGE | GL_BUFFER_ACCESS | GL_BUFFER_MAPPED) {
            return Err(invalid_enum(format!("{} is not a parameter of a buffer object", name(pname))));
        }
        let buffer = self.bound_buffer(target)?;
        Ok(match pname {
            GL_BUFFER_SIZE => Values::int(i32::try_from(buffer.data.len()).unwrap_or(i32::MAX)),
            GL_BUFFER_USAGE => Values::enumerant(buffer.usage),
            GL_BUFFER_ACCESS => Values::enumerant(buffer.access),
            _ => Values::boolean(buffer.mapped),
        })
    }

    pub(crate) fn get_buffer_pointer(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        self.buffer_binding(target)?;
        if pname != GL_BUFFER_MAP_POINTER {
            return Err(invalid_enum(format!("{} is not GL_BUFFER_MAP_POINTER", name(pname))));
        }
        let buffer = self.bound_buffer(target)?;
        Ok(Values::address(if buffer.mapped { buffer.data.as_ptr() as usize } else { 0 }))
    }

    /// Whether a buffer object is bound to `ELEMENT_ARRAY_BUFFER`: then `DrawElements` takes an offset.
    #[cfg_attr(not(feature = "capi"), expect(dead_code, reason = "only memory that comes as a pointer is measured"))]
    pub(crate) fn element_array_buffer_bound(&mut self) -> bool {
        self.client.arrays.element_buffer != 0
    }
}
