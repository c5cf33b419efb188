//! LINEAR of 8-bit texels (OpenGL 1.5, section 3.8.8).
//!
//! Two steps in each stage: fetch, lane by lane, the two adjacent texels of each row as one 64-bit word; then unpack and
//! blend, as many lanes at once as the widest registers hold. Texels are blended as whole numbers 0 to 255 by nested
//! a + t (b - a): that is exact where a and b are equal, so a constant texture stays constant, and never leaves the range
//! of the texels. The factor 1/255 comes last, once.

use crate::simd::{Cost, LANES, Stage};
use crate::texture::batch::{SamplerScratch, TexBatch};
use crate::texture::filter::{
    INV_255, REPEATS, SECOND, byte, destination, lane_image, lane_offset, lerp, offsets, texels,
};
use crate::texture::format::BaseFormat;
use crate::texture::uniforms::{MipLevel, SamplerUniforms, TexFn, sampler_stages};
use crate::texture::wrap::bounded::{CoordBounds, LinearWrap};
use crate::texture::wrap::general::repeat_or_clamp_linear;

/// In a stage's argument: it wraps its coordinates, each by REPEAT ([`REPEATS`] and the next two bits) or by CLAMP and
/// CLAMP_TO_EDGE.
pub const WRAPS: u32 = 4096;

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

/// The two neighbours of every lane in a row of the image.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct TexelPairs<const N: usize>([[u32; 2]; N]);

impl<const N: usize> TexelPairs<N> {
    /// No texels yet.
    pub const NONE: Self = Self([[0; 2]; N]);
}

/// Where the texels of every lane are. Aligned like [`TexelPairs`]: a wide store across the end of a cache line delays the load after it.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct TexelIndices<const N: usize>(pub [u32; N]);

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
fn pairs<const ROWS: usize, const N: usize>(
    out: &mut [TexelPairs<N>; ROWS],
    lane: usize,
    rows: &[&[u32]; ROWS],
    o: usize,
) -> Option<()> {
    let len = rows[0].len();
    for r in 0..ROWS {
        let t = rows[r].get(..len)?.get(o..o + 2)?;
        out[r].0[lane] = [t[0], t[1]];
    }
    Some(())
}

/// The one image that all lanes read, if they do, and where in it.
struct SharedImage<'a> {
    image: &'a MipLevel,
    at: [u32; LANES],
}

/// Wraps the coordinates if this is asked for, and finds the image and the places where all lanes read one.
#[inline(always)]
fn shared<'a, const DIMS: usize>(
    b: &mut TexBatch,
    u: &'a SamplerUniforms,
    arg: u32,
    pass: usize,
) -> Option<SharedImage<'a>> {
    let image = b.scratch.same[pass].and_then(|same| u.images.get(same));
    if arg & WRAPS != 0 {
        let repeats = |c: usize| arg & REPEATS << c != 0;
        let form = |c: usize| LinearWrap::new(repeats(c), CoordBounds::of(b, c), image?.size[c], image?.size[c]);
        let forms = [form(0), form(1), form(2)];
        if let Some(image) = image
            && forms.iter().take(DIMS).all(Option::is_some)
        {
            let mut at = [image.origin; LANES];
            for (c, step) in [1, image.stride, image.slice].into_iter().enumerate().take(DIMS) {
                let (Some(form), n) = (forms[c], image.size[c]) else { return None };
                form.run(&b.coord[c], n, n, &mut b.scratch.weight[c], |i, index| {
                    at[i] = at[i].wrapping_add(index.cast_unsigned().wrapping_mul(step));
                });
            }
            return Some(SharedImage { image, at });
        }
        for c in 0..DIMS {
            repeat_or_clamp_linear(b, u, arg & SECOND | c as u32, repeats(c));
        }
    }
    let image = image?;
    Some(SharedImage { image, at: offsets::<DIMS>(&b.scratch, image.origin, image.stride, image.slice) })
}

/// Fetches the pairs of lanes that read one image. An index beyond the image cannot come out of the wraps; were there one,
/// the loop would end. (That it may end also keeps it a loop of plain loads: gather instructions are slower.)
#[inline(always)]
pub fn fetch_at<const ROWS: usize, const N: usize>(out: &mut [TexelPairs<N>; ROWS], image: &MipLevel, at: &[u32; N]) {
    let Some(rows) = rows(image) else { return };
    for i in 0..N {
        if pairs(out, i, &rows, at[i] as usize).is_none() {
            break;
        }
    }
}

/// Fetches the pairs of all lanes.
#[inline(always)]
fn fetch<const DIMS: usize, const ROWS: usize>(
    out: &mut [TexelPairs<LANES>; ROWS],
    shared: Option<SharedImage<'_>>,
    w: &SamplerScratch,
    u: &SamplerUniforms,
    pass: usize,
) {
    if let Some(SharedImage { image, at }) = shared {
        fetch_at(out, image, &at);
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

#[inline(always)]
fn sample_linear<const DIMS: usize, const ROWS: usize, const FORMAT: u8>(
    b: &mut TexBatch,
    u: &SamplerUniforms,
    arg: u32,
) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.scratch.two_levels {
        return;
    }
    let mut rows = [TexelPairs::NONE; ROWS];
    let shared = shared::<DIMS>(b, u, arg, pass);
    fetch::<DIMS, ROWS>(&mut rows, shared, &b.scratch, u, pass);
    let TexBatch { texel, scratch: SamplerScratch { weight: [ws, wt, wr], color, .. }, .. } = b;
    let Some((out, k)) = destination(texel, color, u.unit, arg, INV_255) else { return };
    for start in (0..LANES).step_by(CHUNK) {
        let chunk = blend::<ROWS, FORMAT, LANES>(&rows, [ws, wt, wr], start, k);
        for c in 0..4 {
            if let Some(to) = out[c].get_mut(start..).and_then(|to| to.first_chunk_mut()) {
                *to = chunk[c];
            }
        }
    }
}

/// Lanes that are blended at a time: as many as fit in the registers of the widest level.
pub const CHUNK: usize = 16;

/// Blends the rows of the lanes of a chunk. Everything is a copy: with references into the batch the compiler would test
/// at run time whether what is written is also what is read.
#[inline(always)]
pub fn blend<const ROWS: usize, const FORMAT: u8, const N: usize>(
    rows: &[TexelPairs<N>; ROWS],
    [ws, wt, wr]: [&[f32; N]; 3],
    start: usize,
    k: f32,
) -> [[f32; CHUNK]; 4] {
    let none = [0.0; CHUNK];
    let mut out = [none; 4];
    let part = |w: &[f32; N]| w.get(start..).and_then(|w| w.first_chunk()).copied().unwrap_or(none);
    let (ws, wt, wr) = (part(ws), part(wt), part(wr));
    // As arrays of their own, so that the loops below are over registers.
    let mut texels = [[[0u32; CHUNK]; 2]; ROWS];
    for r in 0..ROWS {
        let Some(pairs) = rows[r].0.get(start..).and_then(|p| p.first_chunk::<CHUNK>()) else { return out };
        for i in 0..CHUNK {
            texels[r][0][i] = pairs[i][0];
            texels[r][1][i] = pairs[i][1];
        }
    }
    let channel = |c: u32| {
        let mut v = none;
        for i in 0..CHUNK {
            let across = |r: usize| lerp(byte(texels[r][0][i], c), byte(texels[r][1][i], c), ws[i]);
            let flat = |r: usize| lerp(across(r), across(r + 1), wt[i]);
            v[i] = k * match ROWS {
                1 => across(0),
                2 => flat(0),
                _ => lerp(flat(0), flat(2), wr[i]),
            };
        }
        v
    };
    let full = [255.0 * k; CHUNK];
    match FORMAT {
        RGBA => out = [channel(0), channel(1), channel(2), channel(3)],
        RGB => out = [channel(0), channel(1), channel(2), full],
        LUMINANCE | LUMINANCE_ALPHA => {
            let l = channel(0);
            out = [l, l, l, if FORMAT == LUMINANCE { full } else { channel(3) }];
        }
        INTENSITY => out = [channel(0); 4],
        _ => out[3] = channel(3),
    }
    out
}

sampler_stages! {
    LINEAR_1D [Cost::filter(2, 1)] = sample_linear::<1, 1, RGBA>;
    BILINEAR_2D_RGBA [Cost::filter(4, 2)] = sample_linear::<2, 2, RGBA>;
    BILINEAR_2D_RGB [Cost::filter(4, 2)] = sample_linear::<2, 2, RGB>;
    BILINEAR_2D_LUMINANCE [Cost::filter(4, 2)] = sample_linear::<2, 2, LUMINANCE>;
    BILINEAR_2D_LUMINANCE_ALPHA [Cost::filter(4, 2)] = sample_linear::<2, 2, LUMINANCE_ALPHA>;
    BILINEAR_2D_INTENSITY [Cost::filter(4, 2)] = sample_linear::<2, 2, INTENSITY>;
    BILINEAR_2D_ALPHA [Cost::filter(4, 2)] = sample_linear::<2, 2, ALPHA>;
    TRILINEAR_3D_RGBA [Cost::filter(8, 3)] = sample_linear::<3, 4, RGBA>;
    TRILINEAR_3D_RGB [Cost::filter(8, 3)] = sample_linear::<3, 4, RGB>;
    TRILINEAR_3D_LUMINANCE [Cost::filter(8, 3)] = sample_linear::<3, 4, LUMINANCE>;
}

/// The stage that filters linearly, with as few channels as the format has.
#[must_use]
pub fn stage(dims: usize, format: BaseFormat) -> &'static Stage<TexFn> {
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
