//! Wrapping (OpenGL 1.5, sections 3.8.7 and 3.8.8, table 3.19): from a texture coordinate to the texels around it.
//!
//! Every wrap mode comes down to a position x in texels, and x to an index and a weight. The ring around each image holds
//! what a wrap mode puts beyond the ends, so an index from -1 to N is all that is asked for, whatever the coordinate was.
//!
//! ```text
//!   REPEAT                  x = N r, r = s - nearest whole number; N is added to an index below 0
//!   CLAMP, CLAMP_TO_EDGE    x = N s limited to 0..N            (the ring tells the two apart)
//!   CLAMP_TO_BORDER         x = N s limited to -1/2..N+1/2
//!   MIRRORED_REPEAT         x = N |s - nearest even number|
//!   MIRROR_CLAMP[_TO_EDGE]  x = N |s| limited to 0..N
//!   MIRROR_CLAMP_TO_BORDER  x = N |s| limited to 0..N+1/2
//!   NEAREST                 i = floor(x), at most N-1 (to border: at most N)
//!   LINEAR                  i = floor(x - 1/2), weight of texel i+1: x - 1/2 - i
//! ```
//!
//! The range is reduced before the multiplication by N, so a coordinate of 10^6 loses no more than it had lost already.
//! LINEAR rounds x - 1 instead of cutting x - 1/2: at a texel's centre the weight may be 1 of i-1 instead of 0 of i, which
//! is the same colour.

use super::bounded::{CoordBounds, LinearWrap};
use crate::num::{clamp_f32, floor_to_int, max_f32, round_to_int};
use crate::simd::{Cost, LANES};
use crate::texture::batch::{SamplerScratch, TexBatch};
use crate::texture::uniforms::{SamplerUniforms, sampler_stages};

/// In a stage's argument: which coordinate (0 to 2).
pub const COORDINATE: u32 = 3;
/// In a stage's argument: the second pass, of two levels.
pub const SECOND: u32 = 4;
/// In the argument of a NEAREST stage: only for lanes marked in `nearest`; the others keep what LINEAR found.
pub const MERGE: u32 = 8;
/// In the argument of a LINEAR stage: the forms of [`bounded`](super::bounded) are not used.
pub const PLAIN: u32 = 16;

/// From here on every float is a whole number.
const WHOLE: f32 = 8_388_608.0;
/// Adding it rounds to a whole number, which then stands in the low bits (see `num`).
const MAGIC: f32 = 12_582_912.0;
const SIGN: u32 = 0x8000_0000;

/// |s| less the nearest whole number, -0.5..=0.5; 0 for what is no number.
#[inline(always)]
fn off_whole(s: f32) -> f32 {
    let a = s.abs();
    let r = a - ((a + WHOLE) - WHOLE);
    if r.abs() <= 0.5 { r } else { 0.0 }
}

/// Texel position of REPEAT, -N/2..=N/2.
#[inline(always)]
fn repeat(s: f32, scale: f32, _n: f32) -> f32 {
    f32::from_bits(off_whole(s).to_bits() ^ (s.to_bits() & SIGN)) * scale
}

/// Texel position of CLAMP and CLAMP_TO_EDGE.
#[inline(always)]
fn clamp(s: f32, scale: f32, n: f32) -> f32 {
    clamp_f32(s * scale, 0.0, n)
}

/// Texel position of CLAMP_TO_BORDER.
#[inline(always)]
fn border(s: f32, scale: f32, n: f32) -> f32 {
    clamp_f32(s * scale, -0.5, n + 0.5)
}

/// Texel position of MIRRORED_REPEAT.
#[inline(always)]
fn mirrored(s: f32, scale: f32, _n: f32) -> f32 {
    (2.0 * off_whole(0.5 * s)).abs() * scale
}

/// Texel position of MIRROR_CLAMP and MIRROR_CLAMP_TO_EDGE.
#[inline(always)]
fn mirror_clamp(s: f32, scale: f32, n: f32) -> f32 {
    clamp_f32(s.abs() * scale, 0.0, n)
}

/// Texel position of MIRROR_CLAMP_TO_BORDER.
#[inline(always)]
fn mirror_border(s: f32, scale: f32, n: f32) -> f32 {
    clamp_f32(s.abs() * scale, 0.0, n + 0.5)
}

/// Index and weight of a linear filter. `END` says how an index beyond the range comes back.
#[inline(always)]
fn linear<const END: u8>(x: f32, n: f32) -> (i32, f32) {
    // The whole number nearest to x - 1, rounded once: subtracting 1 first would round twice.
    let biased = x + (MAGIC - 1.0);
    let i = biased - MAGIC;
    match END {
        TO_BORDER => {
            let i = clamp_f32(i, -1.0, n - 1.0);
            (round_to_int(i), (x - 0.5) - i)
        }
        _ => {
            let index = (biased.to_bits() as i32).wrapping_sub(MAGIC.to_bits() as i32);
            let again = if END == AROUND { index >> 31 & round_to_int(n) } else { 0 };
            (index + again, (x - 0.5) - i)
        }
    }
}

/// Index of the nearest texel.
#[inline(always)]
fn nearest<const END: u8>(x: f32, n: f32) -> i32 {
    let i = floor_to_int(x);
    match END {
        AROUND => i + (i >> 31 & round_to_int(n)),
        TO_BORDER => i,
        _ => {
            let last = round_to_int(n) - 1;
            if i < last { i } else { last }
        }
    }
}

/// The index stops at the last texel.
const TO_EDGE: u8 = 0;
/// The index may be that of a border texel.
const TO_BORDER: u8 = 1;
/// N is added to a negative index.
const AROUND: u8 = 2;

/// NEAREST of any coordinates by REPEAT or, if not `repeats`, by CLAMP or CLAMP_TO_EDGE. The argument is that of the
/// stages.
#[inline(always)]
pub(crate) fn repeat_or_clamp_nearest(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, repeats: bool) {
    if repeats {
        wrap_nearest::<AROUND>(b, u, arg, repeat);
    } else {
        wrap_nearest::<TO_EDGE>(b, u, arg, clamp);
    }
}

/// LINEAR, as [`repeat_or_clamp_nearest`].
#[inline(always)]
pub(crate) fn repeat_or_clamp_linear(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, repeats: bool) {
    if repeats {
        wrap_linear::<AROUND>(b, u, arg, repeat);
    } else {
        wrap_linear::<TO_EDGE>(b, u, arg, clamp);
    }
}

/// REPEAT, or CLAMP and CLAMP_TO_EDGE, by the [`LinearWrap`] that the coordinates allow.
#[inline(always)]
fn bounded_or_general_linear(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, repeats: bool) {
    let c = (arg & COORDINATE).min(2) as usize;
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.scratch.two_levels {
        return;
    }
    let image = b.scratch.same[pass].and_then(|same| u.images.get(same)).filter(|_| arg & PLAIN == 0);
    let n = image.map_or(1.0, |image| image.size[c]);
    let scale = if u.unnormalised { 1.0 } else { n };
    match LinearWrap::new(repeats, CoordBounds::of(b, c), scale, n) {
        Some(form) if image.is_some() => {
            let SamplerScratch { first, weight, .. } = &mut b.scratch;
            let first = &mut first[c];
            form.run(&b.coord[c], scale, n, &mut weight[c], |i, index| first[i] = index);
        }
        _ => repeat_or_clamp_linear(b, u, arg, repeats),
    }
}

/// Size of a level's dimension from that of the base level: halved `level` times, rounded down, at least 1.
#[inline(always)]
fn level_size(base: f32, level: u32) -> f32 {
    let half = f32::from_bits(127u32.wrapping_sub(level) << 23);
    max_f32(crate::num::floor_f32(base * half), 1.0)
}

/// Runs `f(s, scale, n)` over the lanes, with the size of the image that each lane reads.
#[inline(always)]
fn over_lanes(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, f: impl Fn(f32, f32, f32) -> (i32, f32), merge: bool) {
    let c = (arg & COORDINATE).min(2) as usize;
    let pass = usize::from(arg & SECOND != 0);
    let TexBatch { coord, scratch, .. } = b;
    if pass == 1 && !scratch.two_levels {
        return;
    }
    let (s, level, marked) = (&coord[c], &scratch.level[pass], &scratch.nearest);
    let (first, weight) = (&mut scratch.first[c], &mut scratch.weight[c]);
    let mut put = |i: usize, (at, w): (i32, f32)| {
        let keep = merge && marked[i] == 0;
        first[i] = if keep { first[i] } else { at };
        weight[i] = if keep { weight[i] } else { w };
    };
    if let Some(image) = scratch.same[pass] {
        let n = u.images.get(image).map_or(1.0, |image| image.size[c]);
        let scale = if u.unnormalised { 1.0 } else { n };
        for i in 0..LANES {
            put(i, f(s[i], scale, n));
        }
    } else {
        let base = u.size[c];
        for i in 0..LANES {
            let n = level_size(base, level[i]);
            put(i, f(s[i], n, n));
        }
    }
}

#[inline(always)]
fn wrap_linear<const END: u8>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, x: impl Fn(f32, f32, f32) -> f32) {
    over_lanes(b, u, arg, |s, scale, n| linear::<END>(x(s, scale, n), n), false);
}

#[inline(always)]
fn wrap_nearest<const END: u8>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32, x: impl Fn(f32, f32, f32) -> f32) {
    if arg & MERGE == 0 {
        over_lanes(b, u, arg, |s, scale, n| (nearest::<END>(x(s, scale, n), n), 0.0), false);
    } else {
        // A filter reads texels i and i+1: N itself is texel i+1 of N-1.
        let f = |s, scale, n| {
            let i = nearest::<END>(x(s, scale, n), n);
            let beyond = i >= round_to_int(n);
            (i - i32::from(beyond), if beyond { 1.0 } else { 0.0 })
        };
        over_lanes(b, u, arg, f, true);
    }
}

sampler_stages! {
    WRAP_REPEAT_LINEAR [Cost::wraps(1)] = bounded_or_general_linear, true;
    WRAP_REPEAT_NEAREST [Cost::wraps(1)] = wrap_nearest::<AROUND>, repeat;
    /// CLAMP and CLAMP_TO_EDGE: the padding of the image tells them apart.
    WRAP_CLAMP_LINEAR [Cost::wraps(1)] = bounded_or_general_linear, false;
    WRAP_CLAMP_NEAREST [Cost::wraps(1)] = wrap_nearest::<TO_EDGE>, clamp;
    WRAP_BORDER_LINEAR [Cost::wraps(1)] = wrap_linear::<TO_BORDER>, border;
    WRAP_BORDER_NEAREST [Cost::wraps(1)] = wrap_nearest::<TO_BORDER>, border;
    WRAP_MIRRORED_LINEAR [Cost::wraps(1)] = wrap_linear::<TO_EDGE>, mirrored;
    WRAP_MIRRORED_NEAREST [Cost::wraps(1)] = wrap_nearest::<TO_EDGE>, mirrored;
    /// MIRROR_CLAMP and MIRROR_CLAMP_TO_EDGE.
    WRAP_MIRROR_CLAMP_LINEAR [Cost::wraps(1)] = wrap_linear::<TO_EDGE>, mirror_clamp;
    WRAP_MIRROR_CLAMP_NEAREST [Cost::wraps(1)] = wrap_nearest::<TO_EDGE>, mirror_clamp;
    WRAP_MIRROR_BORDER_LINEAR [Cost::wraps(1)] = wrap_linear::<TO_BORDER>, mirror_border;
    WRAP_MIRROR_BORDER_NEAREST [Cost::wraps(1)] = wrap_nearest::<TO_BORDER>, mirror_border;
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::state::texture::WrapMode;

    /// The linear and the nearest result of a wrap mode.
    pub fn both(wrap: WrapMode, s: f32, n: f32) -> ((i32, f32), i32) {
        let x: fn(f32, f32, f32) -> f32 = match wrap {
            WrapMode::Clamp | WrapMode::ClampToEdge => clamp,
            WrapMode::ClampToBorder => border,
            WrapMode::MirroredRepeat => mirrored,
            WrapMode::MirrorClamp | WrapMode::MirrorClampToEdge => mirror_clamp,
            WrapMode::MirrorClampToBorder => mirror_border,
            _ => repeat,
        };
        let x = x(s, n, n);
        match wrap {
            WrapMode::ClampToBorder | WrapMode::MirrorClampToBorder => {
                (linear::<TO_BORDER>(x, n), nearest::<TO_BORDER>(x, n))
            }
            WrapMode::Repeat => (linear::<AROUND>(x, n), nearest::<AROUND>(x, n)),
            _ => (linear::<TO_EDGE>(x, n), nearest::<TO_EDGE>(x, n)),
        }
    }

    #[test]
    fn every_float_gives_an_index_in_range() {
        let wraps = [
            WrapMode::Repeat,
            WrapMode::Clamp,
            WrapMode::ClampToBorder,
            WrapMode::MirroredRepeat,
            WrapMode::MirrorClamp,
            WrapMode::MirrorClampToBorder,
        ];
        // Every 40,009th bit pattern: all magnitudes, both signs, infinities and NaNs.
        let patterns = (0..=u32::MAX).step_by(40_009).map(f32::from_bits);
        let near = (-4000..4000).map(|i| i as f32 / 1000.0).flat_map(|s| [s.next_down(), s, s.next_up()]);
        for s in patterns.chain(near) {
            for wrap in wraps {
                for n in [1.0, 2.0, 3.0, 7.0, 100.0, 256.0, 8192.0] {
                    let ((i, w), j) = both(wrap, s, n);
                    assert!((-1..n as i32).contains(&i), "{wrap:?} {s:e} of {n}: {i}");
                    assert!((0.0..=1.0).contains(&w), "{wrap:?} {s:e} of {n}: weight {w}");
                    assert!((-1..=n as i32).contains(&j), "{wrap:?} {s:e} of {n}: nearest {j}");
                    if matches!(wrap, WrapMode::Clamp | WrapMode::MirroredRepeat | WrapMode::MirrorClamp) {
                        assert!((0..n as i32).contains(&j), "{wrap:?} {s:e} of {n}: nearest {j}");
                    }
                }
            }
        }
    }

    #[test]
    fn repeat_keeps_the_fraction_of_every_number() {
        for bits in (0..=0x7f7f_ffffu32).step_by(9973) {
            for s in [f32::from_bits(bits), -f32::from_bits(bits)] {
                let exact = (f64::from(s) * 256.0).floor().rem_euclid(256.0) as i32;
                assert_eq!(both(WrapMode::Repeat, s, 256.0).1 & 255, exact, "{s:e}");
            }
        }
    }

    #[test]
    fn level_sizes_are_halved_and_rounded_down() {
        for base in [1u32, 2, 3, 5, 100, 255, 256, 1023, 8192] {
            for level in 0..14 {
                assert_eq!(level_size(base as f32, level), (base >> level).max(1) as f32, "{base} at {level}");
            }
        }
    }
}
