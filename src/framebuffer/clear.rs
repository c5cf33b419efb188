//! Clearing (OpenGL 1.5, section 4.2.3): whole buffers or the scissor box, under the colour and stencil masks. Rows that
//! need no mask are filled, so that a clear runs at the speed of memory.

use super::Framebuffer;
use crate::num::{clamp01, f32_to_u8};

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rect {
    /// Left edge.
    pub x: u32,
    /// Lower edge.
    pub y: u32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

impl Rect {
    /// A rectangle of window coordinates, cut to a framebuffer of `width` by `height` pixels.
    #[must_use]
    pub fn cut(x: i32, y: i32, w: i32, h: i32, width: u32, height: u32) -> Self {
        let range = |at: i32, len: i32, limit: u32| {
            let low = i64::from(at).clamp(0, i64::from(limit));
            let high = (i64::from(at) + i64::from(len)).clamp(low, i64::from(limit));
            (low as u32, (high - low) as u32)
        };
        let (x, width) = range(x, w, width);
        let (y, height) = range(y, h, height);
        Self { x, y, width, height }
    }
}

/// What a clear does to each buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clear {
    /// The colour, and which channels are written.
    pub color: Option<([f32; 4], [bool; 4])>,
    /// The depth in [0, 1].
    pub depth: Option<f64>,
    /// The stencil value, and which bits are written.
    pub stencil: Option<(u8, u8)>,
    /// The colour of the accumulation buffer.
    pub accum: Option<[f32; 4]>,
}

/// The four bytes of a packed pixel that a colour mask lets through.
pub(crate) fn packed_mask(mask: [bool; 4]) -> u32 {
    u32::from_le_bytes(mask.map(|on| if on { 0xFF } else { 0 }))
}

impl Framebuffer {
    /// A rectangle cut to this framebuffer.
    #[must_use]
    pub fn rect(&self, x: i32, y: i32, width: i32, height: i32) -> Rect {
        Rect::cut(x, y, width, height, self.width, self.height)
    }

    /// A depth in [0, 1] in units of the depth buffer, rounded to the nearest.
    #[must_use]
    pub fn depth_value(&self, depth: f64) -> u32 {
        let limited = if depth > 0.0 { depth.min(1.0) } else { 0.0 };
        (limited * f64::from(self.format.depth_max())).round_ties_even() as u32
    }

    /// Clears buffers inside `scissor`, or whole buffers. OUT_OF_MEMORY where the accumulation buffer cannot be made;
    /// then nothing is cleared.
    pub fn clear(&mut self, clear: &Clear, scissor: Option<Rect>) -> crate::error::Outcome {
        self.apply_deferred_clear();
        let all = self.rect(0, 0, i32::MAX, i32::MAX);
        let rect = match scissor {
            Some(r) => {
                let x = r.x.min(self.width);
                let y = r.y.min(self.height);
                Rect { x, y, width: r.width.min(self.width - x), height: r.height.min(self.height - y) }
            }
            None => all,
        };
        if let Some(value) = clear.accum {
            self.clear_accum(value, rect)?;
        }
        if let Some((color, mask)) = clear.color {
            self.clear_color(color, mask, rect);
        }
        if let Some(depth) = clear.depth {
            let value = self.depth_value(depth);
            let runs = self.runs(rect, self.depth.len());
            for run in runs {
                if let Some(row) = self.depth.get_mut(run) {
                    row.fill(value);
                }
            }
            self.hier_z_cleared(rect, value);
        }
        if let Some((value, mask)) = clear.stencil {
            let runs = self.runs(rect, self.stencil.len());
            for row in runs {
                match self.stencil.get_mut(row) {
                    Some(row) if mask == 0xFF => row.fill(value),
                    Some(row) => row.iter_mut().for_each(|s| *s = (*s & !mask) | (value & mask)),
                    None => {}
                }
            }
        }
        Ok(())
    }

    /// A colour as the buffer holds it: where it has no alpha, that is 1.
    pub(super) fn stored(&self, color: [f32; 4]) -> [f32; 4] {
        if self.format.color_bits[3] != 0 { color } else { [color[0], color[1], color[2], 1.0] }
    }

    fn clear_color(&mut self, color: [f32; 4], mask: [bool; 4], rect: Rect) {
        let color = self.stored(color);
        let packed = u32::from_le_bytes(color.map(f32_to_u8));
        let bits = packed_mask(mask);
        let float = color.map(clamp01);
        let (packed_len, float_len) = {
            let (a, b) = self.color.slices();
            (a.len(), b.len())
        };
        let runs = self.runs(rect, packed_len.max(float_len));
        let (rgba8, floats) = self.color.slices_mut();
        for run in runs {
            match rgba8.get_mut(run.clone()) {
                Some(row) if bits == u32::MAX => row.fill(packed),
                Some(row) => row.iter_mut().for_each(|p| *p = (*p & !bits) | (packed & bits)),
                None => {}
            }
            for pixel in floats.get_mut(run).unwrap_or_default() {
                for c in 0..4 {
                    if mask[c] {
                        pixel[c] = float[c];
                    }
                }
            }
        }
    }

    /// The ranges of buffer elements that a rectangle covers: one for the whole buffer, else one a row.
    pub(super) fn runs(&self, rect: Rect, len: usize) -> impl Iterator<Item = std::ops::Range<usize>> + use<> {
        let whole = rect.width == self.width && rect.height == self.height && self.stride == self.width;
        let first = if self.flipped { self.height.saturating_sub(rect.y).saturating_sub(rect.height) } else { rect.y };
        let stride = self.stride as usize;
        let (count, width) = match (whole, rect.width) {
            (true, _) => (usize::from(len > 0), len),
            (_, 0) => (0, 0),
            (_, width) => (rect.height as usize, width as usize),
        };
        let start = first as usize * stride + rect.x as usize;
        (0..count).map(move |i| start + i * stride..start + i * stride + width)
    }
}
