//! What the doors and the engine tell each other apart from commands: the values of an array element for a display list,
//! how images lie in client memory, and the answers of an engine that has no selection, feedback or imaging yet. An
//! inherent method of `Engine` with the same name takes the place of such an answer.

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
    /// Bytes that a query of the imaging subset writes; 0 if it is an error.
    fn imaging_bytes(&mut self, _target: GLenum, _format: GLenum, _type: GLenum) -> usize {
        0
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
