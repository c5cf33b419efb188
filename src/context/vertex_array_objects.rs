//! Vertex array objects (ARB_vertex_array_object) for the arrays of the fixed functions: an object keeps what the pointer
//! commands said, which arrays are on, and the buffer object of indices. The bound object's content is the client state
//! itself; that of the others waits here. Object 0 is the one that always is.

use super::array_pointers::{ATTRIBUTES, Arrays, Pointer};
use crate::error::{Outcome, invalid_operation, out_of_memory};
use std::collections::{HashMap, HashSet};

/// What an object keeps.
#[derive(Clone, Debug)]
struct Content {
    pointers: [Pointer; ATTRIBUTES],
    element_buffer: u32,
}

impl Default for Content {
    fn default() -> Self {
        let Arrays { pointers, element_buffer, .. } = Arrays::default();
        Self { pointers, element_buffer }
    }
}

/// All objects but the bound one.
#[derive(Clone, Debug, Default)]
pub(crate) struct VertexArrays {
    /// Names in use. `None`: generated and not bound yet, or bound now.
    named: HashMap<u32, Option<Box<Content>>>,
    /// Names that have been bound.
    made: HashSet<u32>,
    last: u32,
}

impl VertexArrays {
    /// Makes room for so many names.
    pub(super) fn reserve(&mut self, count: usize) -> Outcome {
        let room = self.named.try_reserve(count);
        room.map_err(|_| out_of_memory("no memory for names of vertex array objects"))
    }

    pub(super) fn generate(&mut self) -> u32 {
        loop {
            self.last = self.last.wrapping_add(1);
            if self.last != 0 && !self.named.contains_key(&self.last) {
                self.named.insert(self.last, None);
                return self.last;
            }
        }
    }

    /// Makes an object's content that of the client state, and keeps that of the one which was bound.
    pub(super) fn bind(&mut self, arrays: &mut Arrays, array: u32) -> Outcome {
        if array == arrays.object {
            return Ok(());
        }
        if array != 0 && !self.named.contains_key(&array) {
            return Err(invalid_operation(format!(
                "{array} is no name of a vertex array object; ask glGenVertexArrays for one"
            )));
        }
        let next = self.named.insert(array, None).flatten().unwrap_or_default();
        let before = Content {
            pointers: std::mem::replace(&mut arrays.pointers, next.pointers),
            element_buffer: std::mem::replace(&mut arrays.element_buffer, next.element_buffer),
        };
        if arrays.object == 0 || self.named.contains_key(&arrays.object) {
            self.named.insert(arrays.object, Some(Box::new(before)));
        }
        self.made.insert(array);
        arrays.object = array;
        Ok(())
    }

    /// Forgets a name that is not bound.
    pub(super) fn remove(&mut self, array: u32) {
        self.named.remove(&array);
        self.made.remove(&array);
    }

    /// Whether an object has been bound.
    pub(super) fn is_made(&self, array: u32) -> bool {
        array != 0 && self.made.contains(&array)
    }
}
