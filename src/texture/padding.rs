//! The ring of texels around an image (OpenGL 1.5, section 3.8.7). After a coordinate is wrapped, a linear filter reads
//! texels from -1 to N in each dimension. What stands at -1 and at N follows from the wrap mode alone, so it is copied
//! there once, before a draw, and a filter need not wrap the index of its second texel.

use super::image::{Dimensions, Image, Texels};
use crate::error::Outcome;
use crate::num::clamp01;
use crate::pixels::element::{from_rgba8, to_rgba8};

/// What stands beyond the two ends of one dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Padding {
    /// The texel of the opposite end: REPEAT.
    Repeat,
    /// The last texel again: CLAMP_TO_EDGE, MIRRORED_REPEAT and MIRROR_CLAMP_TO_EDGE.
    Edge,
    /// The border texel or the border colour: CLAMP and CLAMP_TO_BORDER.
    Border,
    /// The first texel again at -1, the border at N: MIRROR_CLAMP and MIRROR_CLAMP_TO_BORDER.
    MirrorBorder,
}

/// What a ring is filled for: the pads of s, t, r and the border colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PaddingKey {
    pads: [Padding; 3],
    border: [u32; 4],
}

impl PaddingKey {
    /// The key of the paddings of s, t and r and of TEXTURE_BORDER_COLOR. The colour only counts where one reads it.
    #[must_use]
    pub fn new(pads: [Padding; 3], border_color: [f32; 4]) -> PaddingKey {
        let key = PaddingKey { pads, border: [0; 4] };
        PaddingKey { border: if key.reads_border() { border_color.map(f32::to_bits) } else { [0; 4] }, ..key }
    }

    /// Whether a wrap reads the border.
    #[must_use]
    pub fn reads_border(&self) -> bool {
        self.pads.iter().any(|p| matches!(p, Padding::Border | Padding::MirrorBorder))
    }

    /// The pads of s, t and r.
    #[cfg(test)]
    pub fn pads(&self) -> [Padding; 3] {
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
    pub fn is_padded_for(&self, key: &PaddingKey) -> bool {
        self.padded_for.as_ref() == Some(key)
    }

    /// Fills the ring for `key`, unless it is filled for it already. The border texels of an image with a border stay
    /// where a wrap reads the border; where it does not, they are put aside and come back before the image is written.
    pub fn fill_padding(&mut self, key: &PaddingKey) -> Outcome {
        if self.is_padded_for(key) || self.is_null() {
            return Ok(());
        }
        let border = if self.border == 0 {
            Some(self.border_texel(key.border_color()))
        } else {
            let opaque = self.opaque;
            self.show_border();
            self.opaque = opaque;
            let used = &key.pads[..self.dimensions as usize + 1];
            if used.iter().all(|&pad| pad == Padding::Border) {
                self.padded_for = Some(*key);
                return Ok(());
            }
            self.bordered = Some(Box::new(self.texels.try_clone()?));
            None
        };
        let layout = RingLayout::of(self);
        match &mut self.texels {
            Texels::Rgba8(t) => layout.fill(t, key.pads, border.map(to_rgba8)),
            Texels::Float(t) => layout.fill(t, key.pads, border),
            Texels::Depth(t) => layout.fill(t, key.pads, border.map(|color| color[0])),
        }
        self.padded_for = Some(*key);
        Ok(())
    }

    /// Puts the image's own border back into the ring. To be called before texels are written: it also forgets
    /// what the ring was filled for and whether alpha is 255 everywhere.
    pub(super) fn show_border(&mut self) {
        if let Some(bordered) = self.bordered.take() {
            self.texels = *bordered;
        }
        self.padded_for = None;
        self.opaque = false;
    }

    /// TEXTURE_BORDER_COLOR as a texel: clamped, the components of the base format taken and expanded (table 3.15),
    /// rounded as the image's texels are. A depth is R.
    #[must_use]
    pub fn border_texel(&self, color: [f32; 4]) -> [f32; 4] {
        let color = self.base.expand(self.format.round(color.map(clamp01)));
        match self.texels {
            Texels::Rgba8(_) => from_rgba8(to_rgba8(color)),
            Texels::Float(_) => color,
            Texels::Depth(_) => [color[0], color[0], color[0], 1.0],
        }
    }
}

/// Where rows and slices lie, for copying between them.
#[derive(Clone, Copy)]
struct RingLayout {
    size: [usize; 3],
    dimensions: Dimensions,
}

impl RingLayout {
    fn of(image: &Image) -> RingLayout {
        let size = [image.width as usize, image.height as usize, image.depth as usize];
        RingLayout { size, dimensions: image.dimensions }
    }

    /// Fills the ring dimension by dimension: first the two ends of every row, then whole rows, then whole slices. A
    /// corner thus gets what both dimensions ask for, and the border wins where either asks for it.
    fn fill<T: Copy>(self, texels: &mut [T], pads: [Padding; 3], border: Option<T>) {
        let row = self.size[0] + 2;
        for texels in texels.chunks_exact_mut(row) {
            ends(texels, 1, self.size[0], pads[0], border);
        }
        if self.dimensions == Dimensions::One {
            return;
        }
        let slice = row * (self.size[1] + 2);
        for texels in texels.chunks_exact_mut(slice) {
            ends(texels, row, self.size[1], pads[1], border);
        }
        if self.dimensions == Dimensions::Three {
            ends(texels, slice, self.size[2], pads[2], border);
        }
    }
}

/// Fills the first and the last of n + 2 items of `unit` texels each. Without a border colour the border stays as it is.
fn ends<T: Copy>(texels: &mut [T], unit: usize, n: usize, pad: Padding, border: Option<T>) {
    let last = n + 1;
    let mut copy = |from: usize, to: usize| texels.copy_within(from * unit..(from + 1) * unit, to * unit);
    match pad {
        Padding::Repeat => {
            copy(n, 0);
            copy(1, last);
        }
        Padding::Edge => {
            copy(1, 0);
            copy(n, last);
        }
        Padding::MirrorBorder => copy(1, 0),
        Padding::Border => {}
    }
    let Some(color) = border else { return };
    if pad == Padding::Border {
        texels[..unit].fill(color);
    }
    if matches!(pad, Padding::Border | Padding::MirrorBorder) {
        texels[last * unit..].fill(color);
    }
}
