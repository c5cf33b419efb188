//! The lanes that texture stages work on: the coordinates and derivatives of the unit at hand, its level of detail, the
//! texels of all units (crossbar reads any of them) and the colour as it passes through the environments. Part of a
//! fragment batch; kept apart so that the texture room needs to know nothing of fragments.

use crate::batch::LANES;
use crate::limits::MAX_TEXTURE_UNITS;

/// One float for each lane.
pub type Lanes = [f32; LANES];

/// The texture part of a fragment batch.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct TexBatch {
    /// How many lanes are in use; stages may compute the rest, whose values are finite but mean nothing.
    pub n: usize,
    /// All ones where the fragment is alive, 0 where it is not.
    pub mask: [u32; LANES],
    /// s/q, t/q, r/q of the unit at hand (cube maps: s, t, r up to a positive common factor). For REPEAT and
    /// MIRRORED_REPEAT a whole (even) number may already have been taken off; always finite.
    pub coord: [Lanes; 3],
    /// d coord / dx in coordinate units per pixel; set only where the sampler asks for derivatives.
    pub ddx: [Lanes; 3],
    /// d coord / dy.
    pub ddy: [Lanes; 3],
    /// Level of detail of each lane (clamped, biased), scratch of the samplers.
    pub lambda: Lanes,
    /// Filtered texels of each unit, RGBA in [0, 1] (floats of float formats unclamped).
    pub texel: [[Lanes; 4]; MAX_TEXTURE_UNITS],
    /// Primary colour of the fragment, RGBA.
    pub primary: [Lanes; 4],
    /// The colour as it comes from the previous unit (at first the primary colour), RGBA; environments replace it.
    pub previous: [Lanes; 4],
    /// Arguments of the combine functions: three RGBA colours.
    pub args: [[Lanes; 4]; 3],
    /// Integer scratch of the samplers (texel offsets, levels).
    pub index: [[u32; LANES]; 4],
    /// Float scratch of the samplers (weights, second level).
    pub scratch: [Lanes; 8],
}

impl TexBatch {
    /// A batch with no lane in use.
    #[must_use]
    pub fn new() -> Self {
        const Z: Lanes = [0.0; LANES];
        Self {
            n: 0,
            mask: [0; LANES],
            coord: [Z; 3],
            ddx: [Z; 3],
            ddy: [Z; 3],
            lambda: Z,
            texel: [[Z; 4]; MAX_TEXTURE_UNITS],
            primary: [Z; 4],
            previous: [Z; 4],
            args: [[Z; 4]; 3],
            index: [[0; LANES]; 4],
            scratch: [Z; 8],
        }
    }
}

impl Default for TexBatch {
    fn default() -> Self {
        Self::new()
    }
}
