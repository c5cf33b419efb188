//! Pixel transfer (OpenGL 1.5, section 3.6.5): what is done to groups between client memory and GL. Colours are scaled
//! and biased, then go through the colour maps; colour indices are shifted and offset, then become colours through the
//! index maps (the framebuffer and textures hold colours only); stencil indices are shifted, offset and mapped; depths
//! are scaled and biased. Each step is left out when the state makes it neutral.

use crate::num::clamp01;
use crate::state::pixel::PixelTransfer;
use crate::state::pixel_maps::PixelMaps;

/// The pixel transfer state that applies to one command.
#[derive(Clone, Copy, Debug)]
pub struct Transfer<'a> {
    /// Scales, biases, shifts, switches.
    pub mode: &'a PixelTransfer,
    /// The maps.
    pub maps: &'a PixelMaps,
}

static NO_MODE: PixelTransfer = PixelTransfer {
    map_color: false,
    map_stencil: false,
    index_shift: 0,
    index_offset: 0,
    scale: [1.0; 4],
    bias: [0.0; 4],
    depth_scale: 1.0,
    depth_bias: 0.0,
};

static NO_MAPS: PixelMaps = PixelMaps {
    index_to_index: Vec::new(),
    stencil_to_stencil: Vec::new(),
    index_to_color: [Vec::new(), Vec::new(), Vec::new(), Vec::new()],
    color_to_color: [Vec::new(), Vec::new(), Vec::new(), Vec::new()],
};

impl Transfer<'static> {
    /// Pixel transfer that changes nothing: for GetTexImage, polygon stipples and images made by the library.
    pub const NEUTRAL: Transfer<'static> = Transfer { mode: &NO_MODE, maps: &NO_MAPS };
}

impl Transfer<'_> {
    /// Whether colours come out as they went in.
    #[must_use]
    pub fn keeps_colors(&self) -> bool {
        !self.mode.map_color && self.scale_is_neutral()
    }

    fn scale_is_neutral(&self) -> bool {
        self.mode.scale == [1.0; 4] && self.mode.bias == [0.0; 4]
    }

    /// Whether depths come out as they went in.
    #[must_use]
    pub fn keeps_depths(&self) -> bool {
        self.mode.depth_scale == 1.0 && self.mode.depth_bias == 0.0
    }

    /// Scale, bias and the colour maps, in this order. Only a map clamps.
    pub fn colors(&self, colors: &mut [[f32; 4]]) {
        if !self.scale_is_neutral() {
            for color in &mut *colors {
                for ((c, scale), bias) in color.iter_mut().zip(self.mode.scale).zip(self.mode.bias) {
                    *c = *c * scale + bias;
                }
            }
        }
        if self.mode.map_color {
            for color in colors {
                for (c, map) in color.iter_mut().zip(&self.maps.color_to_color) {
                    let last = map.len().saturating_sub(1);
                    let entry = (clamp01(*c) * last as f32 + 0.5) as usize;
                    *c = map.get(entry.min(last)).copied().unwrap_or(0.0);
                }
            }
        }
    }

    /// Scale and bias of a depth, then the clamp to [0, 1]; 0 for NaN.
    #[must_use]
    pub fn depth(&self, depth: f64) -> f64 {
        let moved = if self.keeps_depths() {
            depth
        } else {
            depth * f64::from(self.mode.depth_scale) + f64::from(self.mode.depth_bias)
        };
        if moved > 0.0 { moved.min(1.0) } else { 0.0 }
    }

    /// The same for many.
    pub fn depths(&self, depths: &mut [f32]) {
        depths.iter_mut().for_each(|d| *d = self.depth((*d).into()) as f32);
    }

    /// Shift and offset of an index. The shift is a power of two, so bits that leave to the right become a fraction.
    #[must_use]
    pub fn index(&self, index: f64) -> f64 {
        // 2^shift from its bits; no index has a use for more than this range.
        let exponent = i64::from(self.mode.index_shift.clamp(-1000, 1000)) + 1023;
        let factor = f64::from_bits(exponent.unsigned_abs() << 52);
        index * factor + f64::from(self.mode.index_offset)
    }

    /// The colour of a colour index: the integer part, cut to the size of each map, looks up R, G, B and A.
    #[must_use]
    pub fn index_color(&self, index: f64) -> [f32; 4] {
        let index = integer(self.index(index));
        std::array::from_fn(|c| lookup(&self.maps.index_to_color[c], index))
    }

    /// The stencil index that a client's index becomes, before it is cut to the bits of the stencil buffer.
    #[must_use]
    pub fn stencil(&self, index: f64) -> u32 {
        let index = integer(self.index(index));
        if self.mode.map_stencil { integer(lookup(&self.maps.stencil_to_stencil, index).into()) } else { index }
    }
}

/// The integer part in two's complement; what is not a number is 0.
fn integer(index: f64) -> u32 {
    (index.floor() as i64) as u32
}

fn lookup(map: &[f32], index: u32) -> f32 {
    // The sizes of these maps are powers of two: the mask is the size less one.
    map.get(index as usize & map.len().saturating_sub(1)).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::*;

    #[test]
    fn colors_are_scaled_then_biased_then_mapped() {
        let mut mode =
            PixelTransfer { scale: [2.0, 1.0, 1.0, 1.0], bias: [-0.25, 0.0, 0.5, 0.0], ..Default::default() };
        let mut maps = PixelMaps::default();
        maps.set(GL_PIXEL_MAP_R_TO_R, &[0.0, 0.1, 0.2, 0.3, 0.4]).unwrap();
        maps.set(GL_PIXEL_MAP_G_TO_G, &[1.0, 0.0]).unwrap();
        maps.set(GL_PIXEL_MAP_B_TO_B, &[0.7, 0.8]).unwrap();
        let mut color = [[0.5, 0.25, 0.75, 1.0]];
        Transfer { mode: &mode, maps: &maps }.colors(&mut color);
        assert_eq!(color, [[0.75, 0.25, 1.25, 1.0]]);
        mode.map_color = true;
        let mut color = [[0.5, 0.25, 0.75, 1.0]];
        Transfer { mode: &mode, maps: &maps }.colors(&mut color);
        assert_eq!(color, [[0.3, 1.0, 0.8, 0.0]]);
        assert!(Transfer::NEUTRAL.keeps_colors() && !Transfer { mode: &mode, maps: &maps }.keeps_colors());
    }

    #[test]
    fn indices_shift_and_look_up() {
        let mut maps = PixelMaps::default();
        maps.set(GL_PIXEL_MAP_I_TO_R, &[0.0, 0.25, 0.5, 0.75]).unwrap();
        maps.set(GL_PIXEL_MAP_I_TO_A, &[0.5, 1.0]).unwrap();
        let mode = PixelTransfer { index_shift: 1, index_offset: 1, ..Default::default() };
        let t = Transfer { mode: &mode, maps: &maps };
        assert_eq!(t.index_color(5.0), [0.75, 0.0, 0.0, 1.0], "11 & 3 is 3, 11 & 1 is 1");
        let mode = PixelTransfer { index_shift: -2, ..mode };
        assert_eq!(Transfer { mode: &mode, maps: &maps }.index(7.0), 2.75);
        assert_eq!(Transfer { mode: &mode, maps: &maps }.index_color(7.0)[0], 0.5);
    }

    #[test]
    fn stencils_map_and_wrap() {
        let mut maps = PixelMaps::default();
        maps.set(GL_PIXEL_MAP_S_TO_S, &[7.0, 9.0]).unwrap();
        let mut mode = PixelTransfer { index_offset: -3, ..Default::default() };
        assert_eq!(Transfer { mode: &mode, maps: &maps }.stencil(1.0), u32::MAX - 1);
        mode.map_stencil = true;
        assert_eq!(Transfer { mode: &mode, maps: &maps }.stencil(4.0), 9);
    }

    #[test]
    fn wild_shifts_and_numbers_are_harmless() {
        for shift in [i32::MIN, i32::MAX, -64, 64] {
            let mode =
                PixelTransfer { index_shift: shift, index_offset: i32::MIN, map_stencil: true, ..Default::default() };
            let maps = PixelMaps::default();
            for index in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 4e9, -1.5] {
                let t = Transfer { mode: &mode, maps: &maps };
                let _ = (t.index_color(index), t.stencil(index));
            }
        }
        let mode = PixelTransfer { depth_scale: f32::NAN, ..Default::default() };
        let mut depths = [0.5];
        Transfer { mode: &mode, maps: Transfer::NEUTRAL.maps }.depths(&mut depths);
        assert_eq!(depths, [0.0]);
    }
}
