//! The buffer objects of a context as data (OpenGL 1.5, section 2.9).

use crate::enums::{GL_READ_WRITE, GL_STATIC_DRAW, GLenum};
use std::collections::HashMap;

/// A buffer object.
#[derive(Clone, Debug)]
pub(crate) struct Buffer {
    /// The data store.
    pub(crate) data: Vec<u8>,
    pub(super) usage: GLenum,
    pub(super) access: GLenum,
    /// Whether MapBuffer has lent the data store to the program.
    pub(crate) mapped: bool,
}

impl Default for Buffer {
    fn default() -> Self {
        Self { data: Vec::new(), usage: GL_STATIC_DRAW, access: GL_READ_WRITE, mapped: false }
    }
}

/// All buffer objects, and which are bound.
#[derive(Clone, Debug, Default)]
pub(crate) struct Buffers {
    /// Names in use; `None` for a generated name that was not bound yet.
    pub(super) named: HashMap<u32, Option<Buffer>>,
    last: u32,
}

impl Buffers {
    /// The object of a name.
    pub(crate) fn get(&self, name: u32) -> Option<&Buffer> {
        self.named.get(&name).and_then(Option::as_ref)
    }

    /// The object of a name, to be changed.
    pub(super) fn get_mut(&mut self, name: u32) -> Option<&mut Buffer> {
        self.named.get_mut(&name).and_then(Option::as_mut)
    }

    /// A name that is not in use, which now is.
    pub(super) fn generate(&mut self) -> u32 {
        loop {
            self.last = self.last.wrapping_add(1);
            if self.last != 0 && !self.named.contains_key(&self.last) {
                self.named.insert(self.last, None);
                return self.last;
            }
        }
    }
}
