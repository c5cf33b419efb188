//! The query objects of a context as data (OpenGL 1.5, section 4.1.7).

use std::collections::HashMap;

/// All query objects and the one that is counting.
#[derive(Debug, Default)]
pub(crate) struct Queries {
    /// Results by name; `None` for a generated name that was never begun.
    pub(super) results: HashMap<u32, Option<u64>>,
    pub(super) active: Option<u32>,
    pub(super) next: u32,
    /// Fragments that have passed since BeginQuery.
    pub(crate) passed: u64,
}

impl Queries {
    /// Whether a query is counting.
    pub(crate) fn is_counting(&self) -> bool {
        self.active.is_some()
    }
}
