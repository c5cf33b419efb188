//! Rows of pixels out of the buffers (OpenGL 1.5, section 4.3.2): what ReadPixels and CopyTexImage read. A row may reach
//! beyond the window on both sides; pixels outside are left as they are, as the specification leaves them undefined.

use super::Framebuffer;
use super::Rect;
use crate::num::f32_to_u8;
use std::ops::Range;

impl Framebuffer {
    /// Where pixels `x..x + len` of row `y` are in the buffers, and which elements of the caller's row they are.
    fn span(&self, x: i32, y: i32, len: usize) -> Option<(Range<usize>, Range<usize>)> {
        let row = self.row_start(u32::try_from(y).ok()?)?;
        let low = i64::from(x).clamp(0, i64::from(self.width));
        let len = i64::try_from(len).unwrap_or(i64::MAX);
        let high = i64::from(x).saturating_add(len).clamp(low, i64::from(self.width));
        let first = (low - i64::from(x)) as usize;
        let n = (high - low) as usize;
        (n > 0).then(|| (row + low as usize..row + high as usize, first..first + n))
    }

    /// Colours of row `y` from `x` on, packed with the bytes R, G, B, A from low to high.
    pub fn read_rgba8(&self, x: i32, y: i32, out: &mut [u32]) {
        debug_assert!(!self.has_deferred_clear(), "a clear waits: apply_deferred_clear first");
        let Some((from, to)) = self.span(x, y, out.len()) else { return };
        let (packed, float) = self.color.slices();
        let Some(out) = out.get_mut(to) else { return };
        match (packed.get(from.clone()), float.get(from)) {
            (Some(p), _) => out.copy_from_slice(p),
            (_, Some(f)) => {
                out.iter_mut().zip(f).for_each(|(out, c)| *out = u32::from_le_bytes(c.map(f32_to_u8)));
            }
            _ => {}
        }
    }

    /// Colours of row `y` from `x` on as floats.
    pub fn read_float(&self, x: i32, y: i32, out: &mut [[f32; 4]]) {
        debug_assert!(!self.has_deferred_clear(), "a clear waits: apply_deferred_clear first");
        let Some((from, to)) = self.span(x, y, out.len()) else { return };
        let (packed, float) = self.color.slices();
        let Some(out) = out.get_mut(to) else { return };
        match (packed.get(from.clone()), float.get(from)) {
            (Some(p), _) => {
                out.iter_mut().zip(p).for_each(|(out, p)| *out = p.to_le_bytes().map(crate::num::u8_to_f32));
            }
            (_, Some(f)) => out.copy_from_slice(f),
            _ => {}
        }
    }

    /// Depths of row `y` from `x` on, in [0, 1].
    pub fn read_depth(&self, x: i32, y: i32, out: &mut [f64]) {
        debug_assert!(!self.has_deferred_clear(), "a clear waits: apply_deferred_clear first");
        let Some((from, to)) = self.span(x, y, out.len()) else { return };
        let max = f64::from(self.format.depth_max());
        if let (Some(from), Some(out)) = (self.depth.get(from), out.get_mut(to)) {
            out.iter_mut().zip(from).for_each(|(out, &z)| *out = f64::from(z) / max);
        }
    }

    /// Stencil values of row `y` from `x` on.
    pub fn read_stencil(&self, x: i32, y: i32, out: &mut [u8]) {
        debug_assert!(!self.has_deferred_clear(), "a clear waits: apply_deferred_clear first");
        let Some((from, to)) = self.span(x, y, out.len()) else { return };
        if let (Some(from), Some(out)) = (self.stencil.get(from), out.get_mut(to)) {
            out.copy_from_slice(from);
        }
    }
}

/// Rows written without any fragment operation: what DrawPixels does with stencil indices.
impl Framebuffer {
    /// Writes colours to row `y` from `x` on, channels that `mask` lets through; no fragment operation is applied.
    #[cfg(test)]
    pub fn write_float(&mut self, x: i32, y: i32, colors: &[[f32; 4]], mask: [bool; 4]) {
        self.apply_deferred_clear();
        let Some((to, from)) = self.span(x, y, colors.len()) else { return };
        let mask = [mask[0], mask[1], mask[2], mask[3] && self.format.color_bits[3] != 0];
        let Some(colors) = colors.get(from) else { return };
        let (packed, float) = self.color.slices_mut();
        for (p, c) in packed.get_mut(to.clone()).unwrap_or_default().iter_mut().zip(colors) {
            let mut bytes = p.to_le_bytes();
            for k in 0..4 {
                if mask[k] {
                    bytes[k] = f32_to_u8(c[k]);
                }
            }
            *p = u32::from_le_bytes(bytes);
        }
        for (p, c) in float.get_mut(to).unwrap_or_default().iter_mut().zip(colors) {
            for k in 0..4 {
                if mask[k] {
                    p[k] = c[k];
                }
            }
        }
    }

    /// Writes depths, in units of the depth buffer, to row `y` from `x` on.
    pub fn write_depth(&mut self, x: i32, y: i32, depths: &[u32]) {
        self.apply_deferred_clear();
        let Some((to, from)) = self.span(x, y, depths.len()) else { return };
        self.hier_z_cleared(Rect { x: 0, y: y.cast_unsigned(), width: self.width, height: 1 }, u32::MAX);
        if let (Some(to), Some(from)) = (self.depth.get_mut(to), depths.get(from)) {
            to.copy_from_slice(from);
        }
    }

    /// Writes stencil values to row `y` from `x` on, bits that `mask` lets through.
    pub fn write_stencil(&mut self, x: i32, y: i32, values: &[u8], mask: u8) {
        self.apply_deferred_clear();
        let Some((to, from)) = self.span(x, y, values.len()) else { return };
        if let (Some(to), Some(from)) = (self.stencil.get_mut(to), values.get(from)) {
            to.iter_mut().zip(from).for_each(|(s, &v)| *s = (*s & !mask) | (v & mask));
        }
    }
}
