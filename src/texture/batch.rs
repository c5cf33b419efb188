//! The lanes that texture stages work on: the coordinates and derivatives of the unit at hand, its level of detail, the
//! texels of all units (crossbar reads any of them) and the colour as it passes through the environments. Part of a
//! fragment batch; kept apart so that the texture room needs to know nothing of fragments.

use crate::limits::MAX_TEXTURE_UNITS;
use crate::simd::LANES;
pub use crate::simd::Lanes;

/// What is known of the derivatives in all live lanes of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Derivatives {
    /// Nothing: each lane has its own.
    #[default]
    PerLane,
    /// They are the same in all lanes, so lane 0 tells for the others.
    Uniform,
    /// They are not there, since this level, counted from the base level, is the only one that live lanes read.
    OneLevel(u32),
}

/// The texture part of a fragment batch.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct TexBatch {
    /// All ones where the fragment is alive, 0 where it is not.
    pub mask: [u32; LANES],
    /// s/q, t/q, r/q of the unit at hand (cube maps: s, t, r up to a positive common factor). For REPEAT and
    /// MIRRORED_REPEAT a whole (even) number may already have been taken off; always finite. A sampler may overwrite
    /// them.
    pub coord: [Lanes; 3],
    /// d coord / dx in coordinate units per pixel; set only where the sampler asks for derivatives.
    pub ddx: [Lanes; 3],
    /// d coord / dy.
    pub ddy: [Lanes; 3],
    /// Level of detail of each lane, biased and clamped; set only where the sampler needs it.
    pub lambda: Lanes,
    /// Filtered texels of each unit, RGBA in [0, 1].
    pub texel: [[Lanes; 4]; MAX_TEXTURE_UNITS],
    /// Primary colour of the fragment, RGBA.
    pub primary: [Lanes; 4],
    /// The colour as it comes from the previous unit, RGBA; environments replace it. What it holds before the first
    /// environment does not matter: that one reads `primary`.
    pub previous: [Lanes; 4],
    /// Arguments of the combine functions: three RGBA colours.
    pub args: [[Lanes; 4]; 4],
    /// Texels of a sampler that gives them packed ([`Sampler::pack`](super::sampler::Sampler::pack)).
    pub packed: [u32; LANES],
    /// What the stages of a sampler hand to each other.
    pub(super) scratch: SamplerScratch,
    /// No coordinate of a lane is farther from 0; infinity where that is not known. Who writes coordinates writes this.
    pub limit: [f32; 3],
    /// No coordinate of a lane is less; minus infinity where that is not known. Who writes coordinates writes this.
    pub least: [f32; 3],
    /// What is known of the derivatives. Who writes derivatives writes this.
    pub derivatives: Derivatives,
    /// How many lanes are in use; stages may compute the rest, whose values mean nothing. (Last, so that all lanes are
    /// aligned to 64 bytes.)
    pub n: usize,
}

/// What the stages of a sampler hand to each other. Filters that blend two levels run their stages twice: arrays of two
/// are indexed by the pass.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(super) struct SamplerScratch {
    /// For each coordinate the first of the two texels along it, -1..=N-1 (NEAREST: the texel, -1..=N).
    pub first: [[i32; LANES]; 3],
    /// For each coordinate the weight of the second texel.
    pub weight: [Lanes; 3],
    /// Level of each lane, counted from the base level.
    pub level: [[u32; LANES]; 2],
    /// Cube map face of each lane.
    pub face: [u32; LANES],
    /// Weight of the second level.
    pub fraction: Lanes,
    /// All ones where the lane is to read the nearest texel although its neighbours filter.
    pub nearest: [u32; LANES],
    /// Filtered colour of each pass, in units of the texels (0 to 255 for 8-bit ones).
    pub color: [[Lanes; 4]; 2],
    /// Taps of each lane.
    pub lane_taps: Lanes,
    /// Distance between taps, in pixels.
    pub tap_step: Lanes,
    /// Coordinates of the fragment's centre, from which taps are counted.
    pub center: [Lanes; 3],
    /// Change of the coordinates along the longer axis of the pixel's footprint.
    pub axis: [Lanes; 3],
    /// Sums over the taps.
    pub sum: [[Lanes; 4]; 2],
    /// The image of a pass where all live lanes read the same one; `None` where it differs from lane to lane.
    pub same: [Option<usize>; 2],
    /// Whether the second pass has any weight in any live lane.
    pub two_levels: bool,
    /// Whether the nearest level was found by lambda: rho alone may have been enough.
    pub by_lambda: bool,
    /// How many taps of an anisotropic filter the batch needs.
    pub taps: u32,
    /// The tap in progress, from 1.
    pub tap: u32,
}

const Z: Lanes = [0.0; LANES];

impl SamplerScratch {
    fn new() -> Self {
        Self {
            first: [[0; LANES]; 3],
            weight: [Z; 3],
            same: [Some(0); 2],
            two_levels: false,
            by_lambda: false,
            level: [[0; LANES]; 2],
            face: [0; LANES],
            fraction: Z,
            nearest: [0; LANES],
            color: [[Z; 4]; 2],
            taps: 1,
            tap: 1,
            lane_taps: Z,
            tap_step: Z,
            center: [Z; 3],
            axis: [Z; 3],
            sum: [[Z; 4]; 2],
        }
    }
}

impl TexBatch {
    /// A batch with no lane in use.
    #[must_use]
    pub fn new() -> Self {
        Self {
            mask: [0; LANES],
            coord: [Z; 3],
            ddx: [Z; 3],
            ddy: [Z; 3],
            lambda: Z,
            texel: [[Z; 4]; MAX_TEXTURE_UNITS],
            primary: [Z; 4],
            previous: [Z; 4],
            args: [[Z; 4]; 4],
            packed: [0; LANES],
            scratch: SamplerScratch::new(),
            limit: [f32::INFINITY; 3],
            least: [f32::NEG_INFINITY; 3],
            derivatives: Derivatives::PerLane,
            n: 0,
        }
    }
}

impl Default for TexBatch {
    fn default() -> Self {
        Self::new()
    }
}
