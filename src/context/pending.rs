//! What other rooms will answer soon.

use super::Values;
use super::engine::Engine;
use crate::enums::GLenum;

impl Engine {
    pub(crate) fn client_capability(&self, _cap: GLenum) -> Option<bool> {
        None
    }

    pub(crate) fn array_value(&self, _pname: GLenum) -> Option<Values> {
        None
    }

    pub(crate) fn before_material_change(&mut self) {}
}
