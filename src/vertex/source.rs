//! Where vertices come from (OpenGL 1.5, section 2.8), and which of them a draw takes in which order.

use super::batch::{self, VertexBatch};
use crate::state::primitive::PrimitiveMode;
use std::ops::Range;

/// Elements of a source in the order of a draw: a range, or a list.
#[derive(Clone, Debug)]
pub enum ElementOrder<L> {
    /// Consecutive ones.
    Range(Range<u32>),
    /// Those of a list.
    List(L),
}

/// A list of elements, by their numbers in the source.
pub trait ElementList: Copy {
    /// How many there are.
    fn count(self) -> usize;
    /// Some of them.
    #[must_use]
    fn part(self, from: usize, until: usize) -> Self;
}

impl ElementList for &[u32] {
    fn count(self) -> usize {
        self.len()
    }

    fn part(self, from: usize, until: usize) -> Self {
        self.get(from..until.min(self.len())).unwrap_or_default()
    }
}

impl<L: ElementList> ElementOrder<L> {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Range(range) => range.len(),
            Self::List(list) => list.count(),
        }
    }

    /// Some of them.
    #[must_use]
    pub fn part(&self, from: usize, until: usize) -> Self {
        match self {
            Self::Range(range) => {
                let at = |i: usize| range.start.saturating_add(u32::try_from(i).unwrap_or(u32::MAX)).min(range.end);
                Self::Range(at(from)..at(until))
            }
            Self::List(list) => Self::List(list.part(from, until)),
        }
    }
}

/// Some elements of a source, in memory.
pub type Keys<'a> = ElementOrder<&'a [u32]>;

impl Keys<'_> {
    /// The element at some place.
    #[inline]
    #[must_use]
    pub fn get(&self, i: usize) -> Option<u32> {
        match self {
            Self::Range(range) => (i < range.len()).then(|| range.start.wrapping_add(i as u32)),
            Self::List(list) => list.get(i).copied(),
        }
    }
}

/// Where vertices come from: arrays, or what Begin and End have collected.
pub trait VertexSource: Sync {
    /// Fills a batch with the positions and edge flags of at most 64 elements.
    fn positions(&self, keys: &Keys<'_>, batch: &mut VertexBatch);
    /// Fills a batch with all other attributes of the elements.
    fn attributes(&self, keys: &Keys<'_>, batch: &mut VertexBatch);
    /// How many vertices of a primitive make a batch.
    fn block(&self, mode: PrimitiveMode) -> usize {
        batch::block(mode)
    }
}
