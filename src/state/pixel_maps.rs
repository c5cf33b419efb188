//! The ten pixel maps (OpenGL 1.5, section 3.6.3, tables 3.3 and 6.24). A setter checks its values before it changes anything.

use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_value};
use crate::limits::MAX_PIXEL_MAP_TABLE;
use crate::num::clamp01;

/// The names of the ten maps (table 3.3) in the order of the fields of [`PixelMaps`]: the map, its size.
pub const PIXEL_MAPS: [(GLenum, GLenum); 10] = [
    (GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_I_TO_I_SIZE),
    (GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_S_TO_S_SIZE),
    (GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_R_SIZE),
    (GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_G_SIZE),
    (GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_B_SIZE),
    (GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_I_TO_A_SIZE),
    (GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_R_TO_R_SIZE),
    (GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_G_TO_G_SIZE),
    (GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_B_TO_B_SIZE),
    (GL_PIXEL_MAP_A_TO_A, GL_PIXEL_MAP_A_TO_A_SIZE),
];

/// The pixel maps. Each has 1 to MAX_PIXEL_MAP_TABLE entries, at first one entry of 0. Not part of any attribute group.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelMaps {
    /// Indices to indices: I_TO_I.
    pub index_to_index: Vec<f32>,
    /// Stencil indices to stencil indices: S_TO_S.
    pub stencil_to_stencil: Vec<f32>,
    /// Indices to R, G, B, A: I_TO_R and its siblings.
    pub index_to_color: [Vec<f32>; 4],
    /// R, G, B, A to themselves: R_TO_R and its siblings.
    pub color_to_color: [Vec<f32>; 4],
}

impl Default for PixelMaps {
    fn default() -> Self {
        let map = || vec![0.0];
        Self {
            index_to_index: map(),
            stencil_to_stencil: map(),
            index_to_color: std::array::from_fn(|_| map()),
            color_to_color: std::array::from_fn(|_| map()),
        }
    }
}

impl PixelMaps {
    fn table(&self, slot: usize) -> &Vec<f32> {
        match slot {
            0 => &self.index_to_index,
            1 => &self.stencil_to_stencil,
            2..6 => &self.index_to_color[slot - 2],
            _ => &self.color_to_color[(slot - 6) & 3],
        }
    }

    fn table_mut(&mut self, slot: usize) -> &mut Vec<f32> {
        match slot {
            0 => &mut self.index_to_index,
            1 => &mut self.stencil_to_stencil,
            2..6 => &mut self.index_to_color[slot - 2],
            _ => &mut self.color_to_color[(slot - 6) & 3],
        }
    }

    fn slot(map: GLenum) -> Outcome<usize> {
        PIXEL_MAPS.iter().position(|row| row.0 == map).ok_or_else(|| {
            invalid_enum(format!("{} is not a pixel map; pass a name such as GL_PIXEL_MAP_R_TO_R", name(map)))
        })
    }

    /// Whether a map yields indices (kept as numbers) rather than colours (kept in [0, 1]).
    fn yields_indices(slot: usize) -> bool {
        slot < 2
    }

    /// How many entries a map is given; INVALID_ENUM where there is no such map, INVALID_VALUE for a size that it does not
    /// have. A map that is looked up by an index has a power of two of them.
    pub fn check(map: GLenum, size: i32) -> Outcome<usize> {
        let slot = Self::slot(map)?;
        let entries = usize::try_from(size).ok().filter(|n| (1..=MAX_PIXEL_MAP_TABLE).contains(n));
        match entries {
            None => Err(invalid_value(format!("{size} entries; a map has 1 to {MAX_PIXEL_MAP_TABLE}"))),
            Some(entries) if slot < 6 && !entries.is_power_of_two() => Err(invalid_value(format!(
                "{entries} entries for {}; a map of indices has a power of two of them",
                name(map)
            ))),
            Some(entries) => Ok(entries),
        }
    }

    /// PixelMapfv: entries of a colour map are clamped to [0, 1].
    pub fn set(&mut self, map: GLenum, values: &[f32]) -> Outcome {
        let slot = Self::slot(map)?;
        Self::check(map, i32::try_from(values.len()).unwrap_or(i32::MAX))?;
        let limit = |v: f32| if Self::yields_indices(slot) { v } else { clamp01(v) };
        *self.table_mut(slot) = values.iter().map(|&v| limit(v)).collect();
        Ok(())
    }

    /// The entries of a map, for GetPixelMapfv.
    pub fn get(&self, map: GLenum) -> Outcome<&[f32]> {
        Ok(self.table(Self::slot(map)?))
    }

    /// How many entries the map has whose `GL_PIXEL_MAP_*_SIZE` is `pname`; `None` for any other name.
    #[must_use]
    pub fn size(&self, pname: GLenum) -> Option<usize> {
        PIXEL_MAPS.iter().position(|row| row.1 == pname).map(|slot| self.table(slot).len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn map_entries_convert_and_clamp() {
        let mut maps = PixelMaps::default();
        maps.set(GL_PIXEL_MAP_A_TO_A, &[-1.0, 0.5, 7.0, f32::NAN]).unwrap();
        assert_eq!(maps.color_to_color[3], [0.0, 0.5, 1.0, 0.0]);
    }
}
