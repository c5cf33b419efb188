//! What every texture unit has one of.

use crate::limits::MAX_TEXTURE_UNITS;

/// One value for each texture unit.
pub type PerUnit<T> = [T; MAX_TEXTURE_UNITS];
