//! Lighting, the part of the material (OpenGL 1.5, sections 2.14.1, 2.14.3 and 2.14.6): the sums over the lights
//! times the material colours, which the vertex's own colour replaces where COLOR_MATERIAL is on, and the clamp to
//! [0, 1] that every colour undergoes, lit or not.

use super::VertFn;
use crate::num::clamp01;
use crate::simd::{LANES, stage};
use crate::vertex::batch::{Lanes, VertexBatch};
use crate::vertex::uniforms::VertexUniforms;

/// Argument of [`MATERIAL`].
pub mod flag {
    /// Face 1, the back.
    pub const BACK: u32 = 1;
    /// Specular light goes to the secondary colour.
    pub const SEPARATE: u32 = 2;
    /// There is specular light at all.
    pub const SPECULAR: u32 = 4;
    /// There is ambient light that depends on the vertex.
    pub const AMBIENT: u32 = 8;
    /// Emission tracks the colour.
    pub const TRACK_EMISSION: u32 = 16;
    /// Ambient tracks the colour.
    pub const TRACK_AMBIENT: u32 = 32;
    /// Diffuse tracks the colour.
    pub const TRACK_DIFFUSE: u32 = 64;
    /// Specular tracks the colour.
    pub const TRACK_SPECULAR: u32 = 128;
}

/// `sum[i] += light[i] * colour`, where the colour is the material's or the vertex's own.
#[inline(always)]
fn add(sum: &mut Lanes, light: &Lanes, own: Option<&Lanes>, material: f32, n: usize) {
    match own {
        Some(color) => (0..n.min(LANES)).for_each(|i| sum[i] += light[i] * color[i]),
        None => (0..n.min(LANES)).for_each(|i| sum[i] += light[i] * material),
    }
}

#[inline(always)]
fn clamp(lanes: &mut Lanes, n: usize) {
    for v in lanes.iter_mut().take(n.min(LANES)) {
        *v = clamp01(*v);
    }
}

stage! {
    /// The colours of a lit face.
    pub fn MATERIAL: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let face = (arg & flag::BACK) as usize;
        let on = |bit: u32| arg & bit != 0;
        let VertexBatch { faces, color, out, .. } = b;
        let (Some(sums), Some(m)) = (faces.get(face), u.materials.get(face)) else { return };
        let slot = u.color_slot[face];
        let Some([primary @ .., alpha]) = out.get_mut(slot..).and_then(|o| o.first_chunk_mut::<4>()) else { return };
        for (c, primary) in primary.iter_mut().enumerate() {
            let own = |bit: u32| on(bit).then(|| &color[c]);
            if on(flag::TRACK_EMISSION | flag::TRACK_AMBIENT) {
                *primary = if on(flag::TRACK_EMISSION) { color[c] } else { [m.emission[c]; LANES] };
                add(primary, &[u.ambient[c]; LANES], own(flag::TRACK_AMBIENT), m.ambient[c], n);
            } else {
                *primary = [m.base[c]; LANES];
            }
            if on(flag::AMBIENT) {
                add(primary, &sums.ambient[c], own(flag::TRACK_AMBIENT), m.ambient[c], n);
            }
            add(primary, &sums.diffuse[c], own(flag::TRACK_DIFFUSE), m.diffuse[c], n);
            if on(flag::SPECULAR) && !on(flag::SEPARATE) {
                add(primary, &sums.specular[c], own(flag::TRACK_SPECULAR), m.specular[c], n);
            }
            clamp(primary, n);
        }
        *alpha = if on(flag::TRACK_DIFFUSE) { color[3] } else { [m.diffuse[3]; LANES] };
        clamp(alpha, n);
        if !on(flag::SEPARATE) {
            return;
        }
        let slot = u.secondary_slot[face];
        let Some(secondary) = out.get_mut(slot..).and_then(|o| o.first_chunk_mut::<3>()) else { return };
        for (c, secondary) in secondary.iter_mut().enumerate() {
            *secondary = [0.0; LANES];
            if on(flag::SPECULAR) {
                let own = on(flag::TRACK_SPECULAR).then(|| &color[c]);
                add(secondary, &sums.specular[c], own, m.specular[c], n);
                clamp(secondary, n);
            }
        }
    }

    /// The vertex's own colour, clamped.
    pub fn COLOR: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { color, out, .. } = b;
        let Some(to) = out.get_mut(u.color_slot[0]..).and_then(|o| o.first_chunk_mut::<4>()) else { return };
        for (to, from) in to.iter_mut().zip(color.iter()) {
            for i in 0..n {
                to[i] = clamp01(from[i]);
            }
        }
    }

    /// The vertex's own secondary colour, clamped.
    pub fn SECONDARY: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { secondary, out, .. } = b;
        let Some(to) = out.get_mut(u.secondary_slot[0]..).and_then(|o| o.first_chunk_mut::<3>()) else { return };
        for (to, from) in to.iter_mut().zip(secondary.iter()) {
            for i in 0..n {
                to[i] = clamp01(from[i]);
            }
        }
    }

    /// No secondary colour: lighting with GL_SINGLE_COLOR.
    pub fn SECONDARY_ZERO: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let slot = u.secondary_slot[(arg & 1) as usize];
        let Some(to) = b.out.get_mut(slot..).and_then(|o| o.first_chunk_mut::<3>()) else { return };
        *to = [[0.0; LANES]; 3];
    }
}
