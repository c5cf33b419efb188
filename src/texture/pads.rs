//! The ring of texels around an image (OpenGL 1.5, section 3.8.7). After a coordinate is wrapped, a linear filter reads
//! texels from -1 to N in each dimension. What stands at -1 and at N follows from the wrap mode alone, so it is copied
//! there once, before a draw, and the filter itself knows nothing of wrapping.

use super::image::Image;
use crate::enums::*;

/// What stands beyond the two ends of one dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pad {
    /// The texel of the opposite end: REPEAT.
    Repeat,
    /// The last texel again: CLAMP_TO_EDGE, MIRRORED_REPEAT and MIRROR_CLAMP_TO_EDGE.
    Edge,
    /// The border texel or the border colour: CLAMP and CLAMP_TO_BORDER.
    Border,
    /// The first texel again at -1, the border at N: MIRROR_CLAMP and MIRROR_CLAMP_TO_BORDER.
    MirrorBorder,
}

impl Pad {
    /// The pad that a wrap mode needs.
    #[must_use]
    pub fn of_wrap(wrap: GLenum) -> Pad {
        match wrap {
            GL_CLAMP | GL_CLAMP_TO_BORDER => Pad::Border,
            GL_CLAMP_TO_EDGE | GL_MIRRORED_REPEAT | GL_MIRROR_CLAMP_TO_EDGE_EXT => Pad::Edge,
            GL_MIRROR_CLAMP_EXT | GL_MIRROR_CLAMP_TO_BORDER_EXT => Pad::MirrorBorder,
            _ => Pad::Repeat,
        }
    }
}

/// What a ring is filled for: the pads of s, t, r and the border colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PadKey {
    pads: [Pad; 3],
    border: [u32; 4],
}

impl PadKey {
    /// The key of three wrap modes (as enumerants) and TEXTURE_BORDER_COLOR. The colour only counts where a wrap reads it.
    #[must_use]
    pub fn new(wraps: [GLenum; 3], border_color: [f32; 4]) -> PadKey {
        let pads = wraps.map(Pad::of_wrap);
        let reads_border = pads.iter().any(|p| matches!(p, Pad::Border | Pad::MirrorBorder));
        PadKey { pads, border: if reads_border { border_color.map(f32::to_bits) } else { [0; 4] } }
    }

    /// The pads of s, t and r.
    #[must_use]
    pub fn pads(&self) -> [Pad; 3] {
        self.pads
    }

    /// The border colour as it was given.
    #[must_use]
    pub fn border_color(&self) -> [f32; 4] {
        self.border.map(f32::from_bits)
    }
}

impl Image {
    /// Whether the ring already holds what `key` needs.
    #[must_use]
    pub fn pads_are(&self, key: &PadKey) -> bool {
        self.pads.as_ref() == Some(key)
    }
}
