//! Level of detail (OpenGL 1.5, section 3.8.8, equations 3.17 to 3.22): how many texels of the base level a pixel spans, as
//! a logarithm, and which levels follow from it.
//!
//! ```text
//!   rho^2  = max(ux^2 + vx^2 + wx^2, uy^2 + vy^2 + wy^2)     ux = width * ds/dx and so on: the ideal formula, no estimate
//!   lambda = log2(rho^2) / 2 + bias, limited to MIN_LOD..MAX_LOD
//!   lambda <= c: magnified
//!   *_MIPMAP_NEAREST: level ceil(lambda - 1/2), a tie goes to the finer level; limited to 0..q
//!   *_MIPMAP_LINEAR: levels floor(lambda) and the next, weight frac(lambda); lambda limited to 0..q first
//! ```
//!
//! Levels count from the base level here. Derivatives are those of the primitive's planes at the fragment itself, so every
//! fragment has its own lambda; where w is constant over a batch's primitive they are constants, and one lambda serves all
//! its fragments. What is no number ends as MIN_LOD.

use super::batch::{Derivatives, Lanes, TexBatch};
use super::uniforms::{SamplerUniforms, TexFn, by_dims, sampler_stages};
use crate::num::{clamp_f32, floor_f32, log2_f32, max_f32, min_f32, round_to_int};
use crate::simd::{Cost, LANES, Stage, stage};

/// In the argument of a level stage: the images are those of a cube map, by face and level.
pub const CUBE: u32 = 1;
/// In the argument of a stage of lambda or levels, not of cube maps: one lane is worked out for all where their derivatives
/// are the same.
pub const ONCE: u32 = 2;

/// Lambda of a squared rho, biased and limited. Where MIN_LOD is above MAX_LOD, MIN_LOD counts.
#[inline(always)]
pub(super) fn lambda(rho2: f32, u: &SamplerUniforms) -> f32 {
    max_f32(min_f32(0.5 * log2_f32(rho2) + u.bias, u.max_lod), u.min_lod)
}

/// Squared length, in texels, of what a pixel spans in the direction of the derivatives `d`.
#[inline(always)]
pub(super) fn span<const DIMS: usize>(d: &[Lanes; 3], u: &SamplerUniforms, i: usize) -> f32 {
    let first = d[0][i] * u.scale[0];
    let mut sum = first * first;
    for c in 1..DIMS {
        let texels = d[c][i] * u.scale[c];
        sum += texels * texels;
    }
    sum
}

/// Lambda of a lane.
#[inline(always)]
fn lambda_at<const DIMS: usize>(b: &TexBatch, u: &SamplerUniforms, i: usize) -> f32 {
    lambda(max_f32(span::<DIMS>(&b.ddx, u, i), span::<DIMS>(&b.ddy, u, i)), u)
}

/// Whether lane 0 is worked out for all lanes.
#[inline(always)]
fn once(b: &TexBatch, arg: u32) -> bool {
    arg & ONCE != 0 && b.derivatives == Derivatives::Uniform
}

#[inline(always)]
fn lambdas<const DIMS: usize>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    if once(b, arg) {
        b.lambda = [lambda_at::<DIMS>(b, u, 0); LANES];
        return;
    }
    if matches!(b.derivatives, Derivatives::OneLevel(_)) {
        return;
    }
    for i in 0..LANES {
        b.lambda[i] = lambda_at::<DIMS>(b, u, i);
    }
}

/// The two levels of *_MIPMAP_LINEAR by the lambda of each lane, and the weight of the second.
#[inline(always)]
fn linear_levels(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    if let Derivatives::OneLevel(level) = b.derivatives {
        return only(b, level);
    }
    if once(b, arg) {
        let l = clamp_f32(b.lambda[0], 0.0, u.last);
        let d = floor_f32(l);
        b.scratch.fraction = [l - d; LANES];
        b.scratch.two_levels = l - d != 0.0;
        b.scratch.same = [d, min_f32(d + 1.0, u.last)].map(|level| Some(round_to_int(level) as usize));
        return;
    }
    let mut weights = 0;
    for i in 0..LANES {
        let l = clamp_f32(b.lambda[i], 0.0, u.last);
        let d = floor_f32(l);
        let live = if (i as u32) < b.n as u32 { b.mask[i] } else { 0 };
        b.scratch.level[0][i] = round_to_int(d) as u32;
        b.scratch.level[1][i] = round_to_int(min_f32(d + 1.0, u.last)) as u32;
        b.scratch.fraction[i] = l - d;
        weights |= (l - d).to_bits() & live;
    }
    b.scratch.two_levels = weights != 0;
    set_same(b, u, arg);
}

/// All lanes read this one level. Not for cube maps.
#[inline(always)]
fn only(b: &mut TexBatch, level: u32) {
    b.scratch.two_levels = false;
    b.scratch.same[0] = Some(level as usize);
}

/// The level that all lanes read, if the squares of rho (in `rho2`) are all well within the range of one level.
#[inline(always)]
fn one_level(rho2: &Lanes, u: &SamplerUniforms) -> Option<u32> {
    // The bits of floats that are not negative are in their order; those of NaN are above all of them.
    let (mut least, mut greatest) = (u32::MAX, 0);
    for i in 0..LANES {
        let bits = rho2[i].to_bits();
        least = if bits < least { bits } else { least };
        greatest = if bits > greatest { bits } else { greatest };
    }
    let within = |[from, to]: &[f32; 2]| least >= from.to_bits() && greatest < to.to_bits();
    u.level_ranges.iter().position(within).map(|level| level as u32)
}

/// The level of *_MIPMAP_NEAREST, without lambda where all lanes certainly read the same.
#[inline(always)]
fn nearest_level<const DIMS: usize>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    if once(b, arg) {
        b.scratch.by_lambda = true;
        b.lambda[0] = lambda_at::<DIMS>(b, u, 0);
        return nearest_levels(b, u, arg);
    }
    if let Derivatives::OneLevel(level) = b.derivatives {
        b.scratch.by_lambda = false;
        return only(b, level);
    }
    let TexBatch { ddx, ddy, lambda: rho2, .. } = b;
    for i in 0..LANES {
        rho2[i] = max_f32(span::<DIMS>(ddx, u, i), span::<DIMS>(ddy, u, i));
    }
    let level = one_level(rho2, u);
    b.scratch.by_lambda = level.is_none();
    match level {
        Some(level) => {
            b.scratch.level[0] = [level; LANES];
            b.scratch.two_levels = false;
            if arg & CUBE == 0 {
                b.scratch.same[0] = Some(level as usize);
            } else {
                set_same(b, u, arg);
            }
        }
        None => {
            for i in 0..LANES {
                b.lambda[i] = lambda(b.lambda[i], u);
            }
            nearest_levels(b, u, arg);
        }
    }
}

/// The level of *_MIPMAP_NEAREST by lambda.
#[inline(always)]
fn nearest_levels(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    let level = |lambda: f32| round_to_int(-floor_f32(-clamp_f32(lambda - 0.5, 0.0, u.last))) as u32;
    if once(b, arg) {
        return only(b, level(b.lambda[0]));
    }
    for i in 0..LANES {
        b.scratch.level[0][i] = level(b.lambda[i]);
    }
    b.scratch.two_levels = false;
    set_same(b, u, arg);
}

/// Whether all live lanes have the same value, and a live lane's value.
#[inline(always)]
fn uniform(n: usize, mask: &[u32; LANES], values: &[u32; LANES]) -> Option<u32> {
    let live = |i: usize| if i < n { mask[i] } else { 0 };
    let first = (0..LANES).find(|&i| live(i) != 0).map_or(values[0], |i| values[i]);
    let mut differs = 0;
    for i in 0..LANES {
        let live = if (i as u32) < n as u32 { mask[i] } else { 0 };
        differs |= (values[i] ^ first) & live;
    }
    (differs == 0).then_some(first)
}

/// Sets what the passes read: one image for all live lanes, where they agree.
#[inline(always)]
fn set_same(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    let n = b.n;
    let mask = &b.mask;
    let w = &mut b.scratch;
    let face = if arg & CUBE == 0 { Some(0) } else { uniform(n, mask, &w.face) };
    for pass in 0..if w.two_levels { 2 } else { 1 } {
        let level = face.and_then(|_| uniform(n, mask, &w.level[pass]));
        w.same[pass] = match (face, level) {
            (Some(face), Some(level)) => Some(face as usize * u.face_step + level as usize),
            _ => None,
        };
    }
}

/// What a logarithm costs.
const LOGARITHM: Cost = Cost { logarithms: 1, ..Cost::NONE };

sampler_stages! {
    LAMBDA_1D [LOGARITHM] = lambdas::<1>;
    LAMBDA_2D [LOGARITHM] = lambdas::<2>;
    LAMBDA_3D [LOGARITHM] = lambdas::<3>;
    /// The level of *_MIPMAP_NEAREST by the lambda that another stage has computed.
    LEVEL_NEAREST [Cost::NONE] = nearest_levels;
    /// Lambda, where it is needed, and the level of *_MIPMAP_NEAREST.
    NEAREST_LEVEL_1D [Cost::NONE] = nearest_level::<1>;
    NEAREST_LEVEL_2D [Cost::NONE] = nearest_level::<2>;
    NEAREST_LEVEL_3D [Cost::NONE] = nearest_level::<3>;
    /// The two levels of *_MIPMAP_LINEAR and the weight of the second.
    LEVEL_LINEAR [Cost::NONE] = linear_levels;
}

stage! {
    /// A lambda that its limits make the same everywhere: the bits of the argument.
    pub fn LAMBDA_CONSTANT: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, arg: u32) {
        b.lambda = [f32::from_bits(arg); LANES];
    }
    /// Marks the lanes that read the nearest texel while others filter, by magnification or minification. A magnified
    /// lane reads the base level only.
    pub fn MAGNIFY: TexFn = (b: &mut TexBatch, u: &SamplerUniforms, _arg: u32) {
        let flip = if u.magnify_nearest { 0 } else { u32::MAX };
        for i in 0..LANES {
            let magnified = if b.lambda[i] <= u.magnify_below { u32::MAX } else { 0 };
            b.scratch.nearest[i] = magnified ^ flip;
            b.lambda[i] = if magnified != 0 { min_f32(b.lambda[i], 0.0) } else { b.lambda[i] };
        }
    }
    /// The base level of each lane's face.
    pub fn LEVEL_BASE: TexFn = (b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
        b.scratch.level[0] = [0; LANES];
        b.scratch.two_levels = false;
        set_same(b, u, arg);
    }
    /// Blends the colours of two levels and brings them to 0..1.
    pub fn MIX_LEVELS: TexFn = (b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
        let k = f32::from_bits(arg);
        let Some(texel) = b.texel.get_mut(u.unit) else { return };
        let w = &b.scratch;
        for c in 0..4 {
            let (out, near, far) = (&mut texel[c], &w.color[0][c], &w.color[1][c]);
            if w.two_levels {
                for i in 0..LANES {
                    out[i] = super::filter::lerp(near[i], far[i], w.fraction[i]) * k;
                }
            } else {
                for i in 0..LANES {
                    out[i] = near[i] * k;
                }
            }
        }
    }
}

/// The stage that finds the level of *_MIPMAP_NEAREST for this many coordinates.
pub fn nearest_level_stage(dims: usize) -> &'static Stage<TexFn> {
    by_dims(dims, [&NEAREST_LEVEL_1D, &NEAREST_LEVEL_2D, &NEAREST_LEVEL_3D])
}

/// The stage that computes lambda for this many coordinates.
pub fn lambda_stage(dims: usize) -> &'static Stage<TexFn> {
    by_dims(dims, [&LAMBDA_1D, &LAMBDA_2D, &LAMBDA_3D])
}
