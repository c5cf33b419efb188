//! Commands of vertex array objects (ARB_vertex_array_object).

use super::engine::Engine;
use crate::error::{Outcome, invalid_value};

fn not_negative(n: i32) -> Outcome {
    if n < 0 { Err(invalid_value(format!("{n} names; a number of names is not negative"))) } else { Ok(()) }
}

impl Engine {
    pub(crate) fn gen_vertex_arrays(&mut self, n: i32, arrays: &mut [u32]) -> Outcome {
        not_negative(n)?;
        self.vertex_arrays.reserve(arrays.len())?;
        arrays.iter_mut().for_each(|name| *name = self.vertex_arrays.generate());
        Ok(())
    }

    pub(crate) fn bind_vertex_array(&mut self, array: u32) -> Outcome {
        self.vertex_arrays.bind(&mut self.client.arrays, array)
    }

    /// The bound object is unbound first: then object 0 is bound.
    pub(crate) fn delete_vertex_arrays(&mut self, n: i32, arrays: &[u32]) -> Outcome {
        not_negative(n)?;
        for array in arrays.iter().copied().filter(|array| *array != 0) {
            if self.client.arrays.object == array {
                self.vertex_arrays.bind(&mut self.client.arrays, 0)?;
            }
            self.vertex_arrays.remove(array);
        }
        Ok(())
    }

    pub(crate) fn is_vertex_array(&mut self, array: u32) -> bool {
        self.vertex_arrays.is_made(array)
    }
}
