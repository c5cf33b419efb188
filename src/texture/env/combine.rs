//! The COMBINE functions (OpenGL 1.5, section 3.8.13, tables 3.23 to 3.25): the one form that every texture environment
//! is brought into, and the stages that run it. Colour and alpha are separate halves: each takes up to four arguments
//! (a source seen through an operand), a function, a scale, and ends limited to [0, 1].
//!
//! The general way loads arguments into `args` and then runs a function. What occurs in nearly every scene has stages of
//! its own that read their sources in place: they give the same bits, because with operand and scale 1 the general way
//! does nothing else.

use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::{clamp01, min_f32};
use crate::simd::{LANES, stage};
use crate::state::texture::{CombineFunction, CombineOperand};
use crate::texture::batch::{Lanes, TexBatch};

/// A stage of an environment plan.
pub type EnvFn = for<'a, 'b> unsafe fn(&'a mut TexBatch, &'b EnvUniforms, u32);

/// What environment stages read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnvUniforms {
    /// TEXTURE_ENV_COLOR of each unit, limited to [0, 1].
    pub colors: [[f32; 4]; MAX_TEXTURE_UNITS],
}

/// What an argument reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorSource {
    /// The texel of a unit.
    Texture(usize),
    /// The environment colour of a unit.
    Constant(usize),
    /// The colour of the fragment.
    Primary,
    /// The result of the unit before, or of none the primary colour.
    Previous,
    /// 0.
    Zero,
}

/// An argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Argument {
    /// What is read.
    pub source: ColorSource,
    /// How.
    pub operand: CombineOperand,
}

/// The colour or the alpha half of an environment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CombineHalf {
    /// The function.
    pub function: CombineFunction,
    /// Whether the function is one of the products of the first and of the last two arguments (COMBINE4).
    pub products: bool,
    /// Its arguments; those beyond its arity mean nothing.
    pub args: [Argument; 4],
    /// 1, 2 or 4.
    pub scale: f32,
}

/// An environment in COMBINE form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combine {
    /// R, G and B.
    pub rgb: CombineHalf,
    /// Alpha.
    pub alpha: CombineHalf,
}

/// The channels of the colour half, as bits.
pub const RGB: u32 = 0b0111;
/// The channel of the alpha half.
pub const ALPHA: u32 = 0b1000;

/// The argument of a stage: the channels in bits 0 to 3, the rest as each stage says.
const CHANNELS: u32 = 15;

/// Argument of the stages that read one source in place: channels, the source in bits 4 to 8 and, where they also read
/// the colour so far, whether that is the primary colour in bit 9.
#[must_use]
pub fn direct(channels: u32, source: ColorSource, from_primary: bool) -> u32 {
    channels | source_code(source) << 4 | u32::from(from_primary) << 9
}

/// Argument of [`ENV_INTERPOLATE`]: as [`direct`], and where the weight comes from in bits 10 to 14, its alpha if bit 15.
#[must_use]
pub fn weighted(channels: u32, source: ColorSource, weight: ColorSource, of_alpha: bool, from_primary: bool) -> u32 {
    direct(channels, source, from_primary) | source_code(weight) << 10 | u32::from(of_alpha) << 15
}

/// Argument of [`ENV_ARGUMENT`]: half, source, operand in bits 9 and 10, slot in bits 11 and 12.
#[must_use]
pub fn argument(channels: u32, slot: usize, argument: Argument) -> u32 {
    channels | source_code(argument.source) << 4 | (argument.operand as u32) << 9 | (slot as u32) << 11
}

/// Argument of the functions: channels, and the scale of colour and alpha as powers of two in bits 4 and 6.
#[must_use]
pub fn function(channels: u32, rgb_scale: f32, alpha_scale: f32) -> u32 {
    let power = |scale: f32| if scale >= 4.0 { 2 } else { u32::from(scale >= 2.0) };
    channels | power(rgb_scale) << 4 | power(alpha_scale) << 6
}

fn source_code(source: ColorSource) -> u32 {
    match source {
        ColorSource::Texture(unit) => unit as u32 & 7,
        ColorSource::Constant(unit) => 8 | (unit as u32 & 7),
        ColorSource::Primary => 16,
        ColorSource::Previous => 17,
        ColorSource::Zero => 18,
    }
}

fn channels(arg: u32) -> impl Iterator<Item = usize> {
    (0..4).filter(move |c| arg >> c & 1 != 0)
}

/// Writes `f(source, so far)` to the channels of `previous`.
#[inline(always)]
fn in_place(b: &mut TexBatch, u: &EnvUniforms, arg: u32, f: impl Fn(f32, f32) -> f32) {
    let TexBatch { texel, primary, previous, .. } = b;
    let code = arg >> 4 & 31;
    let mut constant = [0.0; LANES];
    for c in channels(arg & CHANNELS) {
        let source = channel(code, c, texel, primary, u, &mut constant);
        let out = &mut previous[c];
        if arg >> 9 & 1 != 0 {
            for i in 0..LANES {
                out[i] = f(source[i], primary[c][i]);
            }
        } else {
            for i in 0..LANES {
                out[i] = f(source[i], out[i]);
            }
        }
    }
}

/// A channel of a texel, of a constant (spread out in `constant`) or of the primary colour.
#[inline(always)]
fn channel<'a>(
    code: u32,
    c: usize,
    texel: &'a [[Lanes; 4]; MAX_TEXTURE_UNITS],
    primary: &'a [Lanes; 4],
    u: &EnvUniforms,
    constant: &'a mut Lanes,
) -> &'a Lanes {
    match code {
        0..8 => &texel[code as usize & 7][c],
        16 => &primary[c],
        18 => {
            *constant = [0.0; LANES];
            constant
        }
        _ => {
            *constant = [u.colors[code as usize & 7][c]; LANES];
            constant
        }
    }
}

/// The scale of a channel.
#[inline(always)]
fn scale(arg: u32, c: usize) -> f32 {
    let power = if c < 3 { arg >> 4 & 3 } else { arg >> 6 & 3 };
    [1.0, 2.0, 4.0, 4.0][power as usize]
}

/// Writes `f(a0, a1, a2)`, scaled and limited, to the channels of `previous`.
#[inline(always)]
fn per_channel(b: &mut TexBatch, arg: u32, f: impl Fn(f32, f32, f32) -> f32) {
    let TexBatch { previous, args: [a0, a1, a2, _], .. } = b;
    for c in channels(arg & CHANNELS) {
        let k = scale(arg, c);
        let (out, a0, a1, a2) = (&mut previous[c], &a0[c], &a1[c], &a2[c]);
        for i in 0..LANES {
            out[i] = clamp01(f(a0[i], a1[i], a2[i]) * k);
        }
    }
}

/// Writes the sum of the two products and `plus`, scaled and limited, to the channels of `previous`.
#[inline(always)]
fn products(b: &mut TexBatch, arg: u32, plus: f32) {
    let TexBatch { previous, args: [a0, a1, a2, a3], .. } = b;
    for c in channels(arg & CHANNELS) {
        let k = scale(arg, c);
        let (out, a0, a1, a2, a3) = (&mut previous[c], &a0[c], &a1[c], &a2[c], &a3[c]);
        for i in 0..LANES {
            out[i] = clamp01((a0[i] * a1[i] + a2[i] * a3[i] + plus) * k);
        }
    }
}

stage! {
    /// The source replaces the colour.
    pub fn ENV_REPLACE: EnvFn = (b: &mut TexBatch, u: &EnvUniforms, arg: u32) {
        in_place(b, u, arg & !(1 << 9), |source, _| source);
    }
    /// The source times the colour so far.
    pub fn ENV_MODULATE: EnvFn = (b: &mut TexBatch, u: &EnvUniforms, arg: u32) {
        in_place(b, u, arg, |source, so_far| source * so_far);
    }
    /// The source plus the colour so far.
    pub fn ENV_ADD: EnvFn = (b: &mut TexBatch, u: &EnvUniforms, arg: u32) {
        in_place(b, u, arg, |source, so_far| min_f32(source + so_far, 1.0));
    }
    /// The source and the colour so far, weighted by another source.
    pub fn ENV_INTERPOLATE: EnvFn = (b: &mut TexBatch, u: &EnvUniforms, arg: u32) {
        let TexBatch { texel, primary, previous, .. } = b;
        let (mut of_source, mut of_weight) = ([0.0; LANES], [0.0; LANES]);
        for c in channels(arg & CHANNELS) {
            let w = if arg >> 15 & 1 != 0 { 3 } else { c };
            let source = channel(arg >> 4 & 31, c, texel, primary, u, &mut of_source);
            let weight = channel(arg >> 10 & 31, w, texel, primary, u, &mut of_weight);
            let out = &mut previous[c];
            if arg >> 9 & 1 != 0 {
                for i in 0..LANES {
                    out[i] = min_f32(source[i] * weight[i] + primary[c][i] * (1.0 - weight[i]), 1.0);
                }
            } else {
                for i in 0..LANES {
                    out[i] = min_f32(source[i] * weight[i] + out[i] * (1.0 - weight[i]), 1.0);
                }
            }
        }
    }
    /// Loads an argument: a source seen through an operand.
    pub fn ENV_ARGUMENT: EnvFn = (b: &mut TexBatch, u: &EnvUniforms, arg: u32) {
        let TexBatch { texel, primary, previous, args, .. } = b;
        let code = arg >> 4 & 31;
        let constant: [Lanes; 4];
        let source = match code {
            0..8 => &texel[code as usize & 7],
            16 => &*primary,
            17 => &*previous,
            18 => &[[0.0; LANES]; 4],
            _ => {
                constant = u.colors[code as usize & 7].map(|c| [c; LANES]);
                &constant
            }
        };
        let out = &mut args[(arg >> 11 & 3) as usize];
        for c in channels(arg & CHANNELS) {
            let source = &source[if arg >> 10 & 1 != 0 { 3 } else { c }];
            if arg >> 9 & 1 == 0 {
                out[c] = *source;
            } else {
                for i in 0..LANES {
                    out[c][i] = 1.0 - source[i];
                }
            }
        }
    }
    /// COMBINE with REPLACE.
    pub fn COMBINE_REPLACE: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, _, _| a0);
    }
    /// COMBINE with MODULATE.
    pub fn COMBINE_MODULATE: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, a1, _| a0 * a1);
    }
    /// COMBINE with ADD.
    pub fn COMBINE_ADD: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, a1, _| a0 + a1);
    }
    /// COMBINE with ADD_SIGNED.
    pub fn COMBINE_ADD_SIGNED: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, a1, _| a0 + a1 - 0.5);
    }
    /// COMBINE4 with ADD.
    pub fn COMBINE4_ADD: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        products(b, arg, 0.0);
    }
    /// COMBINE4 with ADD_SIGNED.
    pub fn COMBINE4_ADD_SIGNED: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        products(b, arg, -0.5);
    }
    /// COMBINE with INTERPOLATE.
    pub fn COMBINE_INTERPOLATE: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, a1, a2| a0 * a2 + a1 * (1.0 - a2));
    }
    /// COMBINE with SUBTRACT.
    pub fn COMBINE_SUBTRACT: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        per_channel(b, arg, |a0, a1, _| a0 - a1);
    }
    /// COMBINE with DOT3_RGB or DOT3_RGBA, by the channels of the argument.
    pub fn COMBINE_DOT3: EnvFn = (b: &mut TexBatch, _u: &EnvUniforms, arg: u32) {
        let TexBatch { previous, args: [x, y, dot, _], .. } = b;
        for i in 0..LANES {
            let term = |c: usize| (x[c][i] - 0.5) * (y[c][i] - 0.5);
            dot[0][i] = 4.0 * (term(0) + term(1) + term(2));
        }
        for c in channels(arg & CHANNELS) {
            let k = scale(arg, c);
            for i in 0..LANES {
                previous[c][i] = clamp01(dot[0][i] * k);
            }
        }
    }
}
