//! What the doors ask the engine apart from commands, with the answers of an engine that does not know: whether a
//! Begin is open, how images lie in client memory, what an array element consists of. An
//! inherent method of `Engine` with the same name takes the place of an answer here.

use super::Indices;
use super::engine::Engine;
use super::errors::missing;
use crate::enums::GLenum;
use crate::error::Outcome;
use crate::state::pixel::PixelStore;

/// The values of one element of the enabled vertex arrays, as the attribute commands would give them.
#[derive(Clone, Debug, Default)]
pub(crate) struct ArrayElement {
    /// Edge flag, if its array is enabled.
    pub(crate) edge_flag: Option<bool>,
    /// Fog coordinate.
    pub(crate) fog_coord: Option<f32>,
    /// Colour index.
    pub(crate) index: Option<f32>,
    /// Texture coordinates of each unit whose array is enabled: unit number and coordinates.
    pub(crate) tex_coords: Vec<(u32, [f32; 4])>,
    /// Normal.
    pub(crate) normal: Option<[f32; 3]>,
    /// Secondary colour.
    pub(crate) secondary_color: Option<[f32; 4]>,
    /// Colour.
    pub(crate) color: Option<[f32; 4]>,
    /// Position: without it no vertex is issued.
    pub(crate) vertex: Option<[f32; 4]>,
}

/// The engine's part of the contract with the doors.
#[allow(dead_code, reason = "an answer is dead as soon as the engine has the method")]
pub(crate) trait Questions {
    /// Whether a Begin has been carried out and its End has not.
    fn inside_begin_end(&mut self) -> bool {
        false
    }
    /// Bytes that a query of the imaging subset writes; 0 if it is an error.
    fn imaging_bytes(&mut self, _target: GLenum, _format: GLenum, _type: GLenum) -> usize {
        0
    }
    /// Whether a buffer object is bound to `ELEMENT_ARRAY_BUFFER`: then `DrawElements` takes an offset.
    fn element_array_buffer_bound(&mut self) -> bool {
        false
    }
    /// The values of the enabled arrays at an index, for a display list.
    fn array_element_values(&mut self, _index: i32) -> Outcome<ArrayElement> {
        Err(missing("array_element_values"))
    }
    /// The checks of `DrawArrays` (mode, count) without the drawing, for a display list.
    fn check_draw(&mut self, _mode: GLenum, _count: i32) -> Outcome {
        Ok(())
    }
    /// The indices of `DrawElements` as numbers, for a display list.
    fn element_indices(&mut self, _count: i32, _type: GLenum, _indices: &Indices<'_>) -> Outcome<Vec<u32>> {
        Err(missing("element_indices"))
    }
    /// `ArrayElement`.
    fn array_element(&mut self, _i: i32) -> Outcome {
        Err(missing("array_element"))
    }
    /// `DrawArrays`.
    fn draw_arrays(&mut self, _mode: GLenum, _first: i32, _count: i32) -> Outcome {
        Err(missing("draw_arrays"))
    }
    /// `DrawElements`.
    fn draw_elements(&mut self, _mode: GLenum, _count: i32, _type: GLenum, _indices: &Indices<'_>) -> Outcome {
        Err(missing("draw_elements"))
    }
    /// `DrawRangeElements`; `end` is not before `start`.
    fn draw_range_elements(
        &mut self,
        mode: GLenum,
        _start: u32,
        _end: u32,
        count: i32,
        type_: GLenum,
        indices: &Indices<'_>,
    ) -> Outcome {
        self.draw_elements(mode, count, type_, indices)
    }
    /// `RenderMode`.
    fn render_mode(&mut self, _mode: GLenum) -> Outcome<i32> {
        Err(missing("render_mode"))
    }
    /// `FeedbackBuffer`, with memory of the engine's own.
    fn feedback_buffer(&mut self, _size: i32, _type: GLenum) -> Outcome {
        Err(missing("feedback_buffer"))
    }
    /// `SelectBuffer`, with memory of the engine's own.
    fn select_buffer(&mut self, _size: i32) -> Outcome {
        Err(missing("select_buffer"))
    }
    /// What feedback mode has written until it was left.
    fn feedback_values(&mut self) -> &[f32] {
        &[]
    }
    /// What selection mode has written until it was left.
    fn select_values(&mut self) -> &[u32] {
        &[]
    }
    /// `MapBuffer`.
    fn map_buffer(&mut self, _target: GLenum, _access: GLenum) -> Outcome<&mut [u8]> {
        Err(missing("map_buffer"))
    }
}

impl Questions for Engine {}

impl Engine {
    /// How client memory is laid out for commands that read images.
    pub(crate) fn unpack_store(&self) -> PixelStore {
        self.client.pixel_store.unpack
    }

    /// How client memory is laid out for commands that write images.
    pub(crate) fn pack_store(&self) -> PixelStore {
        self.client.pixel_store.pack
    }

    /// Sets the layout that `unpack_store` tells.
    pub(crate) fn set_unpack_store(&mut self, store: PixelStore) {
        self.client.pixel_store.unpack = store;
    }
}
