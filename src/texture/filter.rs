//! NEAREST and LINEAR of 8-bit texels (OpenGL 1.5, sections 3.8.8 and 3.8.9).
//!
//! Two steps in each stage: fetch, lane by lane, the two adjacent texels of each row as one 64-bit word; then unpack and
//! blend all lanes at once. Texels are blended as whole numbers 0 to 255 by nested a + t (b - a): that is exact where a
//! and b are equal, so a constant texture stays constant, and never leaves the range of the texels. The factor 1/255 comes
//! last, once.

use super::batch::{Lanes, TexBatch, Work};
use super::image::Texels;
use super::uniforms::{MipLevel, TexFn, UnitUniforms};
use crate::batch::{LANES, Stage, stage};
use crate::texture::format::BaseFormat;

/// In a stage's argument: the second pass, of two levels.
pub const SECOND: u32 = super::address::SECOND;
/// In a stage's argument: the colour is not the final one but one of two levels or of several taps.
pub const PARTIAL: u32 = 16;

/// 1/255, rounded once. 255 times it is exactly 1.
pub const INV_255: f32 = 1.0 / 255.0;

/// Which channels of the texels differ: for the others nothing is computed. The bytes that a format does not have hold
/// what it expands to, so all of these give the same bits as `RGBA`.
pub const RGBA: u8 = 0;
/// Alpha is 1.
pub const RGB: u8 = 1;
/// Green and blue are red, alpha is 1.
pub const LUMINANCE: u8 = 2;
/// Green and blue are red.
pub const LUMINANCE_ALPHA: u8 = 3;
/// All are red.
pub const INTENSITY: u8 = 4;
/// Colour is 0.
pub const ALPHA: u8 = 5;

/// `a + t (b - a)`.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + t * (b - a)
}

/// Byte `c` of a texel as a float.
#[inline(always)]
fn byte(texel: u32, c: u32) -> f32 {
    ((texel >> (8 * c)) & 255) as i32 as f32
}

/// The 8-bit texels of an image; none if it stores others.
#[inline(always)]
fn texels(image: &MipLevel) -> &[u32] {
    match &image.image.texels {
        Texels::Rgba8(texels) => texels,
        _ => &[],
    }
}

/// Index of each lane's first texel, `origin` being that of texel (0, 0, 0).
#[inline(always)]
pub(super) fn offsets<const DIMS: usize>(work: &Work, origin: u32, stride: u32, slice: u32) -> [u32; LANES] {
    let mut at = [0; LANES];
    for i in 0..LANES {
        let mut o = origin.wrapping_add_signed(work.first[0][i]);
        if DIMS > 1 {
            o = o.wrapping_add((work.first[1][i] as u32).wrapping_mul(stride));
        }
        if DIMS > 2 {
            o = o.wrapping_add((work.first[2][i] as u32).wrapping_mul(slice));
        }
        at[i] = o;
    }
    at
}

/// The image that a lane reads in a pass where lanes differ.
#[inline(always)]
pub(super) fn lane_image<'a>(u: &'a UnitUniforms, work: &Work, pass: usize, i: usize) -> Option<&'a MipLevel> {
    u.images.get(work.face[i] as usize * u.face_step + work.level[pass][i] as usize)
}

/// Index of a lane's first texel in its own image.
#[inline(always)]
pub(super) fn lane_offset<const DIMS: usize>(work: &Work, image: &MipLevel, i: usize) -> usize {
    let mut o = image.origin.wrapping_add_signed(work.first[0][i]);
    if DIMS > 1 {
        o = o.wrapping_add((work.first[1][i] as u32).wrapping_mul(image.stride));
    }
    if DIMS > 2 {
        o = o.wrapping_add((work.first[2][i] as u32).wrapping_mul(image.slice));
    }
    o as usize
}

/// The two neighbours of every lane in a row: texel i of lane l at 2 l, texel i+1 at 2 l + 1.
type Pairs = [u32; 2 * LANES];

/// Copies the neighbours at `o` in each of the rows that a filter reads: row j, row j+1, then those of slice k+1.
#[inline(always)]
fn pairs<const ROWS: usize>(
    out: &mut [Pairs; ROWS],
    lane: usize,
    texels: &[u32],
    o: usize,
    stride: usize,
    slice: usize,
) -> Option<()> {
    let row = |r: usize| (r & 1) * stride + (r >> 1) * slice;
    let t = texels.get(o..o + row(ROWS - 1) + 2)?;
    for r in 0..ROWS {
        out[r][2 * lane] = t[row(r)];
        out[r][2 * lane + 1] = t[row(r) + 1];
    }
    Some(())
}

/// Fetches the pairs of all lanes. An index beyond the image cannot come out of the wrap stages; were there one, the loop
/// would end. (That it may end also keeps it a loop of plain loads: gather instructions are slower.)
#[inline(always)]
fn fetch<const DIMS: usize, const ROWS: usize>(out: &mut [Pairs; ROWS], w: &Work, u: &UnitUniforms, pass: usize) {
    if let Some(same) = w.same[pass] {
        let Some(image) = u.images.get(same) else { return };
        let at = offsets::<DIMS>(w, image.origin, image.stride, image.slice);
        let (t, stride, slice) = (texels(image), image.stride as usize, image.slice as usize);
        for i in 0..LANES {
            if pairs::<ROWS>(out, i, t, at[i] as usize, stride, slice).is_none() {
                break;
            }
        }
    } else {
        for i in 0..LANES {
            let Some(image) = lane_image(u, w, pass, i) else { break };
            let (stride, slice) = (image.stride as usize, image.slice as usize);
            let o = lane_offset::<DIMS>(w, image, i);
            if pairs::<ROWS>(out, i, texels(image), o, stride, slice).is_none() {
                break;
            }
        }
    }
}

/// Writes the channels that `value(c)` gives for a lane, times `k`, as the format expands them; `one` is a full channel.
#[inline(always)]
fn put<const FORMAT: u8>(out: &mut [Lanes; 4], i: usize, k: f32, one: f32, value: impl Fn(u32) -> f32) {
    let [r, g, b, a] = out;
    match FORMAT {
        RGBA | RGB => {
            r[i] = value(0) * k;
            g[i] = value(1) * k;
            b[i] = value(2) * k;
            a[i] = if FORMAT == RGB { one * k } else { value(3) * k };
        }
        LUMINANCE | LUMINANCE_ALPHA => {
            let l = value(0) * k;
            r[i] = l;
            g[i] = l;
            b[i] = l;
            a[i] = if FORMAT == LUMINANCE { one * k } else { value(3) * k };
        }
        INTENSITY => {
            let v = value(0) * k;
            r[i] = v;
            g[i] = v;
            b[i] = v;
            a[i] = v;
        }
        _ => {
            r[i] = 0.0;
            g[i] = 0.0;
            b[i] = 0.0;
            a[i] = value(3) * k;
        }
    }
}

/// Where a stage's colour goes, and its factor.
#[inline(always)]
pub(super) fn destination<'a>(
    texel: &'a mut [[Lanes; 4]],
    color: &'a mut [[Lanes; 4]; 2],
    unit: usize,
    arg: u32,
    k: f32,
) -> Option<(&'a mut [Lanes; 4], f32)> {
    if arg & PARTIAL != 0 {
        color.get_mut(usize::from(arg & SECOND != 0)).map(|out| (out, 1.0))
    } else {
        texel.get_mut(unit).map(|out| (out, k))
    }
}

#[inline(always)]
fn sample_linear<const DIMS: usize, const ROWS: usize, const FORMAT: u8>(b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.work.two_levels {
        return;
    }
    let mut rows = [[0; 2 * LANES]; ROWS];
    fetch::<DIMS, ROWS>(&mut rows, &b.work, u, pass);
    let TexBatch { texel, work, .. } = b;
    let Work { weight: [ws, wt, wr], color, .. } = work;
    let Some((out, k)) = destination(texel, color, u.unit, arg, INV_255) else { return };
    if ROWS < 4 {
        blend::<ROWS, FORMAT>(out, &rows, 0, ws, wt, k);
        return;
    }
    let (mut near, mut far) = ([[0.0; LANES]; 4], [[0.0; LANES]; 4]);
    blend::<2, FORMAT>(&mut near, &rows, 0, ws, wt, 1.0);
    blend::<2, FORMAT>(&mut far, &rows, 2, ws, wt, 1.0);
    for c in 0..4 {
        for i in 0..LANES {
            out[c][i] = lerp(near[c][i], far[c][i], wr[i]) * k;
        }
    }
}

/// Blends one row, or two from `row` on, of every lane.
#[inline(always)]
fn blend<const ROWS: usize, const FORMAT: u8>(
    out: &mut [Lanes; 4],
    rows: &[Pairs],
    row: usize,
    ws: &Lanes,
    wt: &Lanes,
    k: f32,
) {
    let lower = &rows[row];
    let upper = &rows[row + ROWS - 1];
    for i in 0..LANES {
        let across = |pairs: &Pairs, c: u32| lerp(byte(pairs[2 * i], c), byte(pairs[2 * i + 1], c), ws[i]);
        put::<FORMAT>(out, i, k, 255.0, |c| {
            if ROWS == 1 { across(lower, c) } else { lerp(across(lower, c), across(upper, c), wt[i]) }
        });
    }
}

#[inline(always)]
fn sample_nearest<const DIMS: usize>(b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.work.two_levels {
        return;
    }
    let TexBatch { texel, work, .. } = b;
    let mut found = [0; LANES];
    if let Some(same) = work.same[pass] {
        let Some(image) = u.images.get(same) else { return };
        let at = offsets::<DIMS>(work, image.origin, image.stride, image.slice);
        let t = texels(image);
        for i in 0..LANES {
            let Some(&texel) = t.get(at[i] as usize) else { break };
            found[i] = texel;
        }
    } else {
        for i in 0..LANES {
            let Some(image) = lane_image(u, work, pass, i) else { break };
            let Some(&texel) = texels(image).get(lane_offset::<DIMS>(work, image, i)) else { break };
            found[i] = texel;
        }
    }
    let Some((out, k)) = destination(texel, &mut work.color, u.unit, arg, INV_255) else { return };
    for i in 0..LANES {
        put::<RGBA>(out, i, k, 255.0, |c| byte(found[i], c));
    }
}

stage! {
    /// The nearest texel of a 1D image.
    pub fn NEAREST_1D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<1>(b, u, arg);
    }
    /// The nearest texel of a 2D image.
    pub fn NEAREST_2D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<2>(b, u, arg);
    }
    /// The nearest texel of a 3D image.
    pub fn NEAREST_3D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<3>(b, u, arg);
    }
    /// Two texels of a 1D image.
    pub fn LINEAR_1D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<1, 1, RGBA>(b, u, arg);
    }
    /// Four texels of a 2D image, all channels.
    pub fn BILINEAR_2D_RGBA: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, RGBA>(b, u, arg);
    }
    /// Four texels of a 2D image, three channels.
    pub fn BILINEAR_2D_RGB: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, RGB>(b, u, arg);
    }
    /// Four texels of a 2D image, luminance only.
    pub fn BILINEAR_2D_LUMINANCE: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, LUMINANCE>(b, u, arg);
    }
    /// Four texels of a 2D image, luminance and alpha.
    pub fn BILINEAR_2D_LUMINANCE_ALPHA: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, LUMINANCE_ALPHA>(b, u, arg);
    }
    /// Four texels of a 2D image, intensity only.
    pub fn BILINEAR_2D_INTENSITY: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, INTENSITY>(b, u, arg);
    }
    /// Four texels of a 2D image, alpha only.
    pub fn BILINEAR_2D_ALPHA: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<2, 2, ALPHA>(b, u, arg);
    }
    /// Eight texels of a 3D image, all channels.
    pub fn TRILINEAR_3D_RGBA: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<3, 4, RGBA>(b, u, arg);
    }
    /// Eight texels of a 3D image, three channels.
    pub fn TRILINEAR_3D_RGB: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<3, 4, RGB>(b, u, arg);
    }
    /// Eight texels of a 3D image, luminance only.
    pub fn TRILINEAR_3D_LUMINANCE: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_linear::<3, 4, LUMINANCE>(b, u, arg);
    }
}

/// The stage that reads the nearest texel.
#[must_use]
pub fn nearest(dims: usize) -> &'static Stage<TexFn> {
    match dims {
        1 => &NEAREST_1D,
        2 => &NEAREST_2D,
        _ => &NEAREST_3D,
    }
}

/// The stage that filters linearly, with as few channels as the format has.
#[must_use]
pub fn linear(dims: usize, format: BaseFormat) -> &'static Stage<TexFn> {
    match (dims, format) {
        (1, _) => &LINEAR_1D,
        (2, BaseFormat::Rgb) => &BILINEAR_2D_RGB,
        (2, BaseFormat::Luminance) => &BILINEAR_2D_LUMINANCE,
        (2, BaseFormat::LuminanceAlpha) => &BILINEAR_2D_LUMINANCE_ALPHA,
        (2, BaseFormat::Intensity) => &BILINEAR_2D_INTENSITY,
        (2, BaseFormat::Alpha) => &BILINEAR_2D_ALPHA,
        (2, _) => &BILINEAR_2D_RGBA,
        (_, BaseFormat::Rgb) => &TRILINEAR_3D_RGB,
        (_, BaseFormat::Luminance) => &TRILINEAR_3D_LUMINANCE,
        _ => &TRILINEAR_3D_RGBA,
    }
}
