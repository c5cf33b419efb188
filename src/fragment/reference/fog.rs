//! Colour sum and fog (OpenGL 1.5, sections 3.9 and 3.10), and the coverage of smooth primitives (section 3.11), which
//! comes after them. The fog factor is computed for every fragment from its fog coordinate.
//!
//! ```text
//!   EXP     f = e^(-d c)          LINEAR  f = (e - c) / (e - s)
//!   EXP2    f = e^(-(d c)^2)      C = f C_fragment + (1 - f) C_fog, alpha stays
//! ```

use crate::fragment::batch::FragmentBatch;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::num::{clamp_f32, clamp01, exp_f32};
use crate::simd::{LANES, stage};

/// The fog coordinate of an interpolated value, without infinities and NaN, so that density 0 means no fog for every
/// fragment.
#[inline(always)]
fn coordinate(interpolated: f32, u: &FragUniforms) -> f32 {
    clamp_f32(f32::from_bits(interpolated.to_bits() & u.fog_bits), -3e38, 3e38)
}

/// Fog's choice between the fragment's colour (f = 1) and its own (f = 0), exact at both ends.
#[inline(always)]
fn mix(b: &mut FragmentBatch, u: &FragUniforms) {
    for c in 0..3 {
        let fog = u.fog_color[c];
        let color = &mut b.tex.previous[c];
        for i in 0..LANES {
            let f = b.fog[i];
            color[i] = f * color[i] + (1.0 - f) * fog;
        }
    }
}

stage! {
    /// Adds the secondary colour.
    pub fn COLOR_SUM: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for c in 0..3 {
            let color = &mut b.tex.previous[c];
            let secondary = &b.secondary[c];
            for i in 0..LANES {
                color[i] = clamp01(color[i] + secondary[i]);
            }
        }
    }

    /// Exponential fog.
    pub fn FOG_EXP: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            b.fog[i] = clamp01(exp_f32(-(u.fog_scale * coordinate(b.fog[i], u))));
        }
        mix(b, u);
    }

    /// Squared exponential fog.
    pub fn FOG_EXP2: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            let dc = u.fog_scale * coordinate(b.fog[i], u);
            b.fog[i] = clamp01(exp_f32(-(dc * dc)));
        }
        mix(b, u);
    }

    /// Linear fog: the scale is 1 / (e - s).
    pub fn FOG_LINEAR: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            b.fog[i] = clamp01((u.fog_end - coordinate(b.fog[i], u)) * u.fog_scale);
        }
        mix(b, u);
    }

    /// Linear fog that ends where it starts, which the specification leaves undefined: none before, all after.
    pub fn FOG_STEP: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        for i in 0..LANES {
            b.fog[i] = if coordinate(b.fog[i], u) < u.fog_end { 1.0 } else { 0.0 };
        }
        mix(b, u);
    }

    /// Full coverage, for programs that are not to leave coverage out.
    pub fn FULL_COVERAGE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        b.coverage = [1.0; LANES];
    }

    /// Alpha times the coverage of a smooth primitive.
    pub fn COVERAGE: FragFn = (b: &mut FragmentBatch, _u: &FragUniforms, _w: &mut Work<'_, '_>, _arg: u32) {
        let alpha = &mut b.tex.previous[3];
        for i in 0..LANES {
            alpha[i] = clamp01(alpha[i]) * b.coverage[i];
        }
    }
}
