//! The memory of a scene's planes (OpenGL 1.5, section 3.5.1): those of single primitives, and groups of 16 for the
//! triangles of a batch. It is never shrunk and not cleared, so that planes are written once.

use super::weights::FourPlanes;
use crate::fragment::planes::{Plane, PlaneGroup, PlanePool};

/// The planes of a scene's slots.
#[derive(Clone, Debug, Default)]
pub struct PlaneBuffer {
    planes: Vec<Plane>,
    used: usize,
    groups: Vec<PlaneGroup>,
    used_groups: usize,
    /// Where planes are computed before they are stored.
    four: FourPlanes,
}

impl PlaneBuffer {
    /// All planes; those in use come first.
    #[must_use]
    pub fn all(&self) -> PlanePool<'_> {
        PlanePool { alone: &self.planes, groups: &self.groups }
    }

    /// Bytes in use.
    #[must_use]
    pub const fn memory(&self) -> usize {
        self.used * size_of::<Plane>() + self.used_groups * size_of::<PlaneGroup>()
    }

    /// Forgets all planes.
    pub fn clear(&mut self) {
        (self.used, self.used_groups) = (0, 0);
    }

    /// Forgets the groups from an index on.
    pub(crate) fn drop_groups(&mut self, first: u32) {
        self.used_groups = self.used_groups.min(first as usize);
    }

    /// Appends groups of planes with any contents. Returns the index of the first, and the groups.
    pub(crate) fn more_groups(&mut self, count: usize) -> (u32, &mut [PlaneGroup]) {
        let first = self.used_groups;
        self.used_groups += count;
        if self.used_groups > self.groups.len() {
            self.groups.resize((2 * self.groups.len()).max(self.used_groups + 64), PlaneGroup::default());
        }
        (first as u32, self.groups.get_mut(first..first + count).unwrap_or(&mut []))
    }

    /// How many are in use.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.used
    }

    /// The last planes, to be changed.
    pub(crate) fn last_mut(&mut self, count: usize) -> &mut [Plane] {
        self.planes.get_mut(self.used.saturating_sub(count)..self.used).unwrap_or(&mut [])
    }

    /// Forgets all but the first planes.
    pub fn truncate(&mut self, len: usize) {
        self.used = self.used.min(len);
    }

    /// Appends planes with any contents. Returns them, and where they can be computed.
    #[inline]
    pub(crate) fn more(&mut self, count: usize) -> (&mut [Plane], &mut FourPlanes) {
        let first = self.used;
        self.used += count;
        if self.used > self.planes.len() {
            self.planes.resize((2 * self.planes.len()).max(self.used + 256), Plane::default());
        }
        (self.planes.get_mut(first..first + count).unwrap_or(&mut []), &mut self.four)
    }
}
