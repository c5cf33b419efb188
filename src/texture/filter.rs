//! NEAREST and LINEAR of 8-bit texels (OpenGL 1.5, sections 3.8.8 and 3.8.9).
//!
//! Two steps in each stage: fetch, lane by lane, the two adjacent texels of each row as one 64-bit word; then unpack and
//! blend all lanes at once. Texels are blended as whole numbers 0 to 255 by nested a + t (b - a): that is exact where a
//! and b are equal, so a constant texture stays constant, and never leaves the range of the texels. The factor 1/255 comes
//! last, once.

use super::address::{Near, far_nearest};
use super::batch::{Lanes, TexBatch, Work};
use super::image::Texels;
use super::uniforms::{MipLevel, TexFn, UnitUniforms};
use crate::batch::{LANES, Stage, stage};
use crate::texture::format::BaseFormat;

/// In a stage's argument: the second pass, of two levels.
pub const SECOND: u32 = super::address::SECOND;
/// In a stage's argument: the colour is not the final one but one of two levels or of several taps.
pub const PARTIAL: u32 = 16;

/// In the argument of a stage that wraps too: s is REPEAT; the next bit is that of t.
pub const REPEATS: u32 = 32;

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

/// The texels of an image from each of the rows on that a filter reads: row j, row j+1, then those of slice k+1. All are
/// equally long, so that an index is checked once.
#[inline(always)]
fn rows<const ROWS: usize>(image: &MipLevel) -> Option<[&[u32]; ROWS]> {
    let (t, stride, slice) = (texels(image), image.stride as usize, image.slice as usize);
    let row = |r: usize| (r & 1) * stride + (r >> 1) * slice;
    let len = t.len().checked_sub(row(ROWS - 1))?;
    let mut rows: [&[u32]; ROWS] = [&[]; ROWS];
    for r in 0..ROWS {
        rows[r] = t.get(row(r)..row(r) + len)?;
    }
    Some(rows)
}

/// Copies the neighbours at `o` in each of the rows.
#[inline(always)]
fn pairs<const ROWS: usize>(out: &mut [Pairs; ROWS], lane: usize, rows: &[&[u32]; ROWS], o: usize) -> Option<()> {
    let len = rows[0].len();
    for r in 0..ROWS {
        let t = rows[r].get(..len)?.get(o..o + 2)?;
        out[r][2 * lane] = t[0];
        out[r][2 * lane + 1] = t[1];
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
        let Some(rows) = rows(image) else { return };
        for i in 0..LANES {
            if pairs(out, i, &rows, at[i] as usize).is_none() {
                break;
            }
        }
    } else {
        for i in 0..LANES {
            let Some(image) = lane_image(u, w, pass, i) else { break };
            let Some(rows) = rows(image) else { break };
            if pairs(out, i, &rows, lane_offset::<DIMS>(w, image, i)).is_none() {
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
    let TexBatch { texel, work: Work { weight: [ws, wt, wr], color, .. }, .. } = b;
    let Some((out, k)) = destination(texel, color, u.unit, arg, INV_255) else { return };
    for start in (0..LANES).step_by(CHUNK) {
        let mut chunk = [[0; 2 * CHUNK]; ROWS];
        for r in 0..ROWS {
            if let Some(pairs) = rows[r].get(2 * start..).and_then(|pairs| pairs.first_chunk()) {
                chunk[r] = *pairs;
            }
        }
        blend::<ROWS, FORMAT>(out, &chunk, [ws, wt, wr], start, k);
    }
}

/// Lanes that are blended at a time: as many as fit in the registers of the widest level.
const CHUNK: usize = 16;

/// Blends the rows of the lanes of a chunk.
#[inline(always)]
fn blend<const ROWS: usize, const FORMAT: u8>(
    out: &mut [Lanes; 4],
    rows: &[[u32; 2 * CHUNK]; ROWS],
    [ws, wt, wr]: [&Lanes; 3],
    start: usize,
    k: f32,
) {
    for i in 0..CHUNK {
        let lane = start + i;
        let across = |r: usize, c: u32| lerp(byte(rows[r][2 * i], c), byte(rows[r][2 * i + 1], c), ws[lane]);
        let flat = |r: usize, c: u32| lerp(across(r, c), across(r + 1, c), wt[lane]);
        put::<FORMAT>(out, lane, k, 255.0, |c| match ROWS {
            1 => across(0, c),
            2 => flat(0, c),
            _ => lerp(flat(0, c), flat(2, c), wr[lane]),
        });
    }
}

/// The nearest texel of every lane.
#[inline(always)]
fn nearest_texels<const DIMS: usize>(found: &mut [u32; LANES], work: &Work, u: &UnitUniforms, pass: usize) {
    if let Some(same) = work.same[pass] {
        let Some(image) = u.images.get(same) else { return };
        texels_at(found, image, &offsets::<DIMS>(work, image.origin, image.stride, image.slice));
    } else {
        for i in 0..LANES {
            let Some(image) = lane_image(u, work, pass, i) else { break };
            let Some(&texel) = texels(image).get(lane_offset::<DIMS>(work, image, i)) else { break };
            found[i] = texel;
        }
    }
}

/// The texels at these indices of an image.
#[inline(always)]
fn texels_at(found: &mut [u32; LANES], image: &MipLevel, at: &[u32; LANES]) {
    let t = texels(image);
    if let Some(run) = neighbours(at).and_then(|first| t.get(first..)).and_then(|t| t.first_chunk()) {
        *found = *run;
        return;
    }
    for i in 0..LANES {
        let Some(&texel) = t.get(at[i] as usize) else { break };
        found[i] = texel;
    }
}

/// Wraps s and t, and fetches the nearest texel of every lane.
#[inline(always)]
fn wrap_nearest(found: &mut [u32; LANES], b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let (across, up) = (arg & REPEATS != 0, arg & (2 * REPEATS) != 0);
    let pass = usize::from(arg & SECOND != 0);
    let TexBatch { coord: [s, t, _], limit, work, .. } = b;
    if let Some(image) = work.same[pass].and_then(|same| u.images.get(same))
        && let Some(column) = Near::new(across, limit[0], image.size[0])
        && let Some(row) = Near::new(up, limit[1], image.size[1])
    {
        let mut at = [0; LANES];
        for i in 0..LANES {
            let start = image.origin.wrapping_add(row.index(t[i]).wrapping_mul(image.stride));
            at[i] = start.wrapping_add(column.index(s[i]));
        }
        return texels_at(found, image, &at);
    }
    far_nearest(b, u, arg & SECOND, across);
    far_nearest(b, u, arg & SECOND | 1, up);
    nearest_texels::<2>(found, &b.work, u, pass);
}

/// The first index, if each lane reads the texel after that of the lane before it: an image drawn in its own size.
#[inline(always)]
fn neighbours(at: &[u32; LANES]) -> Option<usize> {
    let first = at[0];
    if at[LANES - 1].wrapping_sub(first) != LANES as u32 - 1 {
        return None;
    }
    let mut differs = 0;
    for i in 0..LANES {
        differs |= at[i].wrapping_sub(first) ^ i as u32;
    }
    (differs == 0).then_some(first as usize)
}

#[inline(always)]
fn sample_nearest<const DIMS: usize, const WRAPS: bool>(b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.work.two_levels {
        return;
    }
    let mut found = [0; LANES];
    if WRAPS {
        wrap_nearest(&mut found, b, u, arg);
    } else {
        nearest_texels::<DIMS>(&mut found, &b.work, u, pass);
    }
    let TexBatch { texel, work, .. } = b;
    let Some((out, k)) = destination(texel, &mut work.color, u.unit, arg, INV_255) else { return };
    for i in 0..LANES {
        put::<RGBA>(out, i, k, 255.0, |c| byte(found[i], c));
    }
}

stage! {
    /// The nearest texel of a 1D image.
    pub fn NEAREST_1D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<1, false>(b, u, arg);
    }
    /// The nearest texel of a 2D image.
    pub fn NEAREST_2D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<2, false>(b, u, arg);
    }
    /// The nearest texel of a 3D image.
    pub fn NEAREST_3D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<3, false>(b, u, arg);
    }
    /// The nearest texel of a 1D image, packed.
    pub fn NEAREST_1D_PACKED: TexFn = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<1>(&mut b.packed, &b.work, u, 0);
    }
    /// The nearest texel of a 2D image, packed.
    pub fn NEAREST_2D_PACKED: TexFn = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<2>(&mut b.packed, &b.work, u, 0);
    }
    /// REPEAT, CLAMP or CLAMP_TO_EDGE in s and in t, and the nearest texel of a 2D image.
    pub fn WRAP_NEAREST_2D: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        sample_nearest::<2, true>(b, u, arg);
    }
    /// The same, packed.
    pub fn WRAP_NEAREST_2D_PACKED: TexFn = (b: &mut TexBatch, u: &UnitUniforms, arg: u32) {
        let mut found = [0; LANES];
        wrap_nearest(&mut found, b, u, arg);
        b.packed = found;
    }
    /// The nearest texel of a 3D image, packed.
    pub fn NEAREST_3D_PACKED: TexFn = (b: &mut TexBatch, u: &UnitUniforms, _arg: u32) {
        nearest_texels::<3>(&mut b.packed, &b.work, u, 0);
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

/// The stage that reads the nearest texel and leaves it packed.
#[must_use]
pub fn nearest_packed(dims: usize) -> &'static Stage<TexFn> {
    match dims {
        1 => &NEAREST_1D_PACKED,
        2 => &NEAREST_2D_PACKED,
        _ => &NEAREST_3D_PACKED,
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
