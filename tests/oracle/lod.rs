//! Level of detail (OpenGL 1.5, section 3.8.8, and EXT_texture_filter_anisotropic): rho from the derivatives of the texel
//! coordinates, lambda with its biases and limits, whether a fragment magnifies, which levels it reads. The derivatives
//! come from `raster::Triangle::interpolate`, already analytic.

use super::V3;
use fixedgl::enums::*;

/// The parameters that decide the level: the object's, the unit's bias, the implementation's limit.
#[derive(Clone, Copy, Debug)]
pub struct LodState {
    pub min_filter: GLenum,
    pub mag_filter: GLenum,
    pub min_lod: f64,
    pub max_lod: f64,
    /// TEXTURE_LOD_BIAS of the object and of the unit.
    pub object_bias: f64,
    pub unit_bias: f64,
    /// MAX_TEXTURE_LOD_BIAS.
    pub max_bias: f64,
    pub base_level: u32,
    pub max_level: u32,
    /// TEXTURE_MAX_ANISOTROPY_EXT.
    pub anisotropy: f64,
}

impl Default for LodState {
    fn default() -> Self {
        LodState {
            min_filter: GL_NEAREST_MIPMAP_LINEAR,
            mag_filter: GL_LINEAR,
            min_lod: -1000.0,
            max_lod: 1000.0,
            object_bias: 0.0,
            unit_bias: 0.0,
            max_bias: 16.0,
            base_level: 0,
            max_level: 1000,
            anisotropy: 1.0,
        }
    }
}

/// Which texels a fragment reads: how a level is filtered, and of which levels how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Levels {
    /// One level, GL_NEAREST or GL_LINEAR within it.
    One { level: u32, filter: GLenum },
    /// (1 - t) of `d1` and t of `d2`.
    Two { d1: u32, d2: u32, t: f64, filter: GLenum },
}

/// The derivatives of (u, v, w) by x and by y, in texels of the base level.
#[derive(Clone, Copy, Debug, Default)]
pub struct Footprint {
    pub by_x: V3,
    pub by_y: V3,
}

impl Footprint {
    /// Equation 3.15: the longer of the two derivatives.
    pub fn rho(&self) -> f64 {
        super::length(&self.by_x).max(super::length(&self.by_y))
    }

    /// The number of taps and the rho to use, by the example method of EXT_texture_filter_anisotropic.
    pub fn anisotropic(&self, max: f64) -> (u32, f64) {
        let (px, py) = (super::length(&self.by_x), super::length(&self.by_y));
        let (longer, shorter) = (px.max(py), px.min(py));
        if longer == 0.0 {
            return (1, 0.0);
        }
        let n = if shorter == 0.0 { max } else { (longer / shorter).ceil().min(max) };
        (n as u32, longer / n)
    }

    /// The taps along the longer axis: offsets in (u, v, w) from the fragment's own coordinates.
    pub fn taps(&self, n: u32) -> Vec<V3> {
        let along_x = super::length(&self.by_x) > super::length(&self.by_y);
        let axis = if along_x { self.by_x } else { self.by_y };
        (1..=n).map(|i| super::scale(axis, f64::from(i) / (f64::from(n) + 1.0) - 0.5)).collect()
    }
}

/// Equations 3.14 and the clamps after it: lambda from rho.
pub fn lambda(s: &LodState, rho: f64) -> f64 {
    let biased = rho.log2() + (s.object_bias + s.unit_bias).clamp(-s.max_bias, s.max_bias);
    if biased > s.max_lod {
        s.max_lod
    } else if biased < s.min_lod {
        s.min_lod
    } else {
        biased
    }
}

/// The constant c that separates magnification from minification.
pub fn switch_over(s: &LodState) -> f64 {
    let nearest_mipmap = matches!(s.min_filter, GL_NEAREST_MIPMAP_NEAREST | GL_NEAREST_MIPMAP_LINEAR);
    if s.mag_filter == GL_LINEAR && nearest_mipmap { 0.5 } else { 0.0 }
}

/// The number of the last level (q): p = floor(log2(largest side of the base level)) + base, limited by max_level.
pub fn last_level(s: &LodState, largest_side: u32) -> u32 {
    (largest_side.max(1).ilog2() + s.base_level).min(s.max_level)
}

/// What is read at this lambda (3.8.8 and 3.8.9).
pub fn levels(s: &LodState, lambda: f64, largest_side: u32) -> Levels {
    let base = s.base_level;
    let q = last_level(s, largest_side);
    if lambda <= switch_over(s) {
        return Levels::One { level: base, filter: s.mag_filter };
    }
    let at = f64::from(base) + lambda;
    match s.min_filter {
        GL_NEAREST | GL_LINEAR => Levels::One { level: base, filter: s.min_filter },
        GL_NEAREST_MIPMAP_NEAREST | GL_LINEAR_MIPMAP_NEAREST => {
            let filter = if s.min_filter == GL_NEAREST_MIPMAP_NEAREST { GL_NEAREST } else { GL_LINEAR };
            let level = if lambda <= 0.5 {
                base
            } else if at <= f64::from(q) + 0.5 {
                (at + 0.5).ceil() as u32 - 1
            } else {
                q
            };
            Levels::One { level, filter }
        }
        GL_NEAREST_MIPMAP_LINEAR | GL_LINEAR_MIPMAP_LINEAR => {
            let filter = if s.min_filter == GL_NEAREST_MIPMAP_LINEAR { GL_NEAREST } else { GL_LINEAR };
            let (d1, d2) = if at >= f64::from(q) { (q, q) } else { (at.floor() as u32, at.floor() as u32 + 1) };
            Levels::Two { d1, d2, t: lambda - lambda.floor(), filter }
        }
        other => panic!("the oracle has no filter {other:#x}"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    fn level_of(s: &LodState, l: f64) -> u32 {
        match levels(s, l, 64) {
            Levels::One { level, .. } => level,
            Levels::Two { d1, .. } => d1,
        }
    }

    #[test]
    fn ties_of_the_nearest_level_go_down() {
        let s = LodState { min_filter: GL_LINEAR_MIPMAP_NEAREST, ..LodState::default() };
        let got: Vec<u32> = [0.25, 0.5, 0.51, 1.5, 1.51, 2.5, 5.5, 9.0].iter().map(|&l| level_of(&s, l)).collect();
        assert_eq!(got, [0, 0, 1, 1, 2, 2, 5, 6]);
        let shifted = LodState { base_level: 2, max_level: 4, ..s };
        assert_eq!([0.4, 0.6, 1.6, 9.0].map(|l| level_of(&shifted, l)), [2, 3, 4, 4]);
    }

    #[test]
    fn two_levels_have_their_share() {
        let s = LodState { min_filter: GL_LINEAR_MIPMAP_LINEAR, ..LodState::default() };
        assert_eq!(levels(&s, 2.25, 64), Levels::Two { d1: 2, d2: 3, t: 0.25, filter: GL_LINEAR });
        assert_eq!(levels(&s, 6.75, 64), Levels::Two { d1: 6, d2: 6, t: 0.75, filter: GL_LINEAR });
        assert_eq!(levels(&s, 0.0, 64), Levels::One { level: 0, filter: GL_LINEAR });
    }

    #[test]
    fn the_switch_over_moves_to_one_half() {
        let s = LodState::default();
        assert_eq!(levels(&s, 0.5, 64), Levels::One { level: 0, filter: GL_LINEAR });
        assert!(matches!(levels(&s, 0.51, 64), Levels::Two { filter: GL_NEAREST, .. }));
        let s = LodState { mag_filter: GL_NEAREST, ..s };
        assert!(matches!(levels(&s, 0.25, 64), Levels::Two { .. }));
    }

    #[test]
    fn lambda_is_biased_and_limited() {
        let s = LodState { object_bias: 1.0, unit_bias: 0.5, ..LodState::default() };
        assert_near(&[lambda(&s, 4.0)], &[3.5], 1e-15);
        assert_near(&[lambda(&LodState { max_bias: 1.25, ..s }, 4.0)], &[3.25], 1e-15);
        assert_near(&[lambda(&LodState { max_lod: 2.0, ..s }, 4.0)], &[2.0], 1e-15);
        assert_near(&[lambda(&LodState { min_lod: 5.0, ..s }, 4.0)], &[5.0], 1e-15);
        assert_near(&[lambda(&s, 0.0)], &[-1000.0], 0.0);
    }

    #[test]
    fn rho_and_the_taps_of_a_long_footprint() {
        let f = Footprint { by_x: [6.0, 8.0, 0.0], by_y: [0.0, 2.5, 0.0] };
        assert_near(&[f.rho()], &[10.0], 1e-15);
        assert_eq!(f.anisotropic(16.0), (4, 2.5));
        assert_eq!(f.anisotropic(2.0), (2, 5.0));
        let taps = f.taps(4);
        assert_near(&taps[0], &[-0.3 * 6.0, -0.3 * 8.0, 0.0], 1e-15);
        assert_near(&taps[3], &[0.3 * 6.0, 0.3 * 8.0, 0.0], 1e-15);
        assert_eq!(f.taps(1), vec![[0.0; 3]]);
    }
}
