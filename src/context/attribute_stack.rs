//! The attribute stack as data (OpenGL 1.5, section 6.1.14).

use crate::limits::MAX_ATTRIB_STACK_DEPTH;
use crate::state::State;
use crate::state::texture::{Target, TexParameters};

/// What one PushAttrib saved: a state beside the mask that says which of its groups count, so that one table serves both
/// directions.
#[derive(Clone, Debug, Default)]
pub(crate) struct SavedAttributes {
    pub(super) mask: u32,
    pub(super) state: Box<State>,
    /// Parameters of the textures bound to every target of every unit, where `GL_TEXTURE_BIT` is in the mask.
    pub(super) parameters: Vec<(u32, Target, TexParameters)>,
}

/// The attribute stack. What was popped is kept for the next push.
#[derive(Clone, Debug, Default)]
pub(crate) struct AttributeStack {
    saved: Vec<SavedAttributes>,
    depth: usize,
}

impl AttributeStack {
    /// How many groups it holds.
    pub(crate) fn depth(&self) -> usize {
        self.depth
    }

    /// The next place, whatever it has held; `None` where the stack is full.
    pub(super) fn push(&mut self) -> Option<&mut SavedAttributes> {
        if self.depth >= MAX_ATTRIB_STACK_DEPTH {
            return None;
        }
        if self.depth == self.saved.len() {
            self.saved.push(SavedAttributes::default());
        }
        self.depth += 1;
        self.saved.get_mut(self.depth - 1)
    }

    /// The last place in use, which no longer is.
    pub(super) fn pop(&mut self) -> Option<&mut SavedAttributes> {
        self.depth = self.depth.checked_sub(1)?;
        self.saved.get_mut(self.depth)
    }
}
