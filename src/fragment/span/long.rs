//! Fill: runs of a row, of any length, of programs that do nothing but test depth (OpenGL 1.5, section 4.1.6) and store an
//! interpolated colour. One stage does it all, block by block, without a batch in between: depth is computed, compared and
//! written, then the colour of what passed is computed and written. Blocks are of 64 pixels, the last of a run of 16.
//! Every number comes from the same expressions as in the stages of batches, so the bits are the same.

use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{Func, compare, holds, living};
use crate::fragment::lod_bounds::{self, MipRange};
use crate::fragment::plane_eval::{self, Extent, From, Place};
use crate::fragment::planes::Planes;
use crate::fragment::reference::depth::WRITE;
use crate::fragment::reference::interpolate::primitive;
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::reference::pack::Paint;
use crate::fragment::reference::places::write;
use crate::fragment::reference::texcoord::{Unit, unit};
use crate::fragment::span::depth::{Slope, coarse, hiz_cull, hiz_update, lanes};
use crate::fragment::span::levels::Between;
use crate::fragment::span::sampled::{Flat, Solid};
use crate::fragment::span::two_units::TwoImages;
use crate::fragment::uniforms::{FragFn, FragUniforms, Work};
use crate::simd::{LANES, stage};
use crate::texture::filter::linear_rgba8::{RGB, RGBA};

/// Bits of [`FILL`]'s number above those of the depth test: depth is tested, colour is written.
pub(crate) const DEPTH: u32 = 1 << 4;
pub(crate) const COLOR: u32 = 1 << 5;

/// From this length on it pays to look at the depths that a run leaves behind: whole blocks, for the sake of other runs.
const LOOK_FROM: usize = 32;
/// Pixels of the last blocks of a run.
const SHORT: usize = 16;

/// What gives a run its colours.
pub(crate) trait SpanShader {
    /// Whether what is there before is blended with.
    const BLENDS: bool = false;

    /// The pixels at a place; `out` holds what is there before where that is blended with.
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]);

    /// Writes the pixels of a row from x on, relative to the primitive's origin.
    #[inline(always)]
    fn all<const N: usize>(&self, x: i32, to: &mut [u32; N]) {
        let mut pixels = if Self::BLENDS { *to } else { [0; N] };
        self.pixels(From(x as f32), &mut pixels);
        *to = pixels;
    }

    /// The same where the mask is set.
    #[inline(always)]
    fn some<const N: usize>(&self, x: i32, mask: &[u32; N], to: &mut [u32; N]) {
        let mut pixels = if Self::BLENDS { *to } else { [0; N] };
        self.pixels(From(x as f32), &mut pixels);
        write(false, mask, &pixels, to);
    }
}

/// The same pixel everywhere.
struct Same(u32);

impl SpanShader for Same {
    #[inline(always)]
    fn pixels<const N: usize>(&self, _place: impl Place<N>, out: &mut [u32; N]) {
        *out = [self.0; N];
    }
}

impl SpanShader for Paint {
    #[inline(always)]
    fn pixels<const N: usize>(&self, place: impl Place<N>, out: &mut [u32; N]) {
        Paint::pixels(self, place, out);
    }
}

/// What all blocks of a run need.
struct Run<S> {
    depth: Option<(Slope, Func, bool)>,
    source: Option<S>,
}

/// What became of a block.
#[derive(Clone, Copy, PartialEq)]
enum Block {
    /// Some fragments passed.
    Alive,
    /// None passed.
    Dead,
    /// Nothing was done, because the buffers end before the block does.
    Outside,
}

impl<S: SpanShader> Run<S> {
    /// `N` pixels from `at` on, of which the first `n` are of the run; lane 0 is at `x`, relative to the primitive's
    /// origin.
    #[inline(always)]
    fn block<const N: usize>(&self, w: &mut Work<'_, '_>, at: usize, x: i32, n: usize) -> Block {
        let mut color = None;
        if let Some(source) = &self.source {
            let Some(pixels) = w.band.rgba8.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) else {
                return Block::Outside;
            };
            color = Some((source, pixels));
        }
        let mut mask = lanes::<N>(n);
        let mut full = n == N;
        if let Some((slope, func, writes)) = &self.depth {
            let Some(depth) = w.band.depth.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) else {
                return Block::Outside;
            };
            let mut z = [0; N];
            slope.depths(x, &mut z);
            full &= holds(*func, &z, depth);
            if full {
                if *writes {
                    *depth = z;
                }
            } else {
                compare(*func, &z, depth, &mut mask);
                // Of a few pixels it takes longer to know than to go on.
                if N > SHORT && living(&mask) == 0 {
                    return Block::Dead;
                }
                if *writes {
                    write(false, &mask, &z, depth);
                }
                if let Some((source, pixels)) = color {
                    source.some(x, &mask, pixels);
                }
                return Block::Alive;
            }
        }
        match color {
            Some((source, pixels)) if full => source.all(x, pixels),
            Some((source, pixels)) => source.some(x, &mask, pixels),
            None => {}
        }
        Block::Alive
    }

    /// The next pixel of a run from its pixel `from` on that the coarse depths do not hide.
    #[inline(always)]
    fn skip(&self, w: &Work<'_, '_>, run: &Segment, x: i32, from: usize) -> usize {
        let Some((slope, func, _)) = &self.depth else { return from };
        let (first, step) = (from as u32, from as i32);
        let rest = Segment { x: run.x.wrapping_add(step), len: run.len - first, ..*run };
        from + hiz_cull(w.band, &rest, slope, x.wrapping_add(step), *func) as usize
    }
}

/// The depth test of a stage's number along a row: `None` where there is none, else with the function and whether depths
/// are written.
#[inline(always)]
fn depth_test(
    planes: &Planes,
    (x, y, len): (i32, i32, u32),
    u: &FragUniforms,
    arg: u32,
) -> Option<(Slope, Func, bool)> {
    let last = x.wrapping_add(len.wrapping_sub(1).cast_signed());
    let slope = || Slope::new(&planes.z, y, u.depth_max).between(x, last);
    (arg & DEPTH != 0).then(|| (slope(), Func::from_arg(arg >> 1), arg & WRITE != 0))
}

/// The run of a segment that begins at x, relative to the primitive's origin; gives how many of its pixels are done.
#[inline(always)]
fn run<S: SpanShader>(w: &mut Work<'_, '_>, segment: &Segment, x0: i32, run: &Run<S>) -> usize {
    let (len, at) = (segment.len as usize, segment.offset as usize);
    let mut done = run.skip(w, segment, x0, 0);
    let first = done;
    while done < len {
        let (at, x) = (at + done, x0.wrapping_add(done as i32));
        let left = len - done;
        let (block, n) = if left >= LANES {
            (run.block::<LANES>(w, at, x, LANES), LANES)
        } else {
            let n = if left > SHORT { SHORT } else { left };
            (run.block::<SHORT>(w, at, x, n), n)
        };
        match block {
            Block::Outside => break,
            Block::Alive => done += n,
            Block::Dead => done = run.skip(w, segment, x0, done + n),
        }
    }
    if let Some((_, func, true)) = run.depth
        && done - first >= LOOK_FROM
        && coarse(func)
    {
        let (x, offset) = (segment.x.wrapping_add(first as i32), segment.offset.wrapping_add(first as u32));
        hiz_update(w.band, &Segment { x, offset, ..*segment }, done - first);
    }
    done
}

/// The part of a run, with `left` pixels from (x, y) on, that the same images serve, and their levels; `None` at the end, and
/// where there are levels and no limits tell which.
#[inline(always)]
fn reads<const K: usize>(
    b: &mut FragmentBatch,
    u: &FragUniforms,
    (unit, index): (&Unit<'_, K>, u32),
    (x, y, left): (i32, i32, u32),
) -> Option<(MipRange, u32)> {
    match u.levels.get(index as usize) {
        _ if left == 0 => None,
        Some(Some(levels)) => lod_bounds::part(&mut b.lookahead, index, &b.tex, unit, (x, y, left), levels),
        _ => Some((MipRange::One(0), left)),
    }
}

/// What is left of a run when so many of its pixels are done.
#[inline(always)]
fn rest(run: &Segment, done: u32, len: u32) -> Segment {
    Segment { x: run.x.wrapping_add(done as i32), offset: run.offset.wrapping_add(done), len, ..*run }
}

/// So many pixels from (x, y) on.
#[inline(always)]
fn along(x: i32, y: i32, n: u32) -> Extent {
    Extent::Row(plane_eval::Run { x: [x, x.wrapping_add(n.wrapping_sub(1).cast_signed())], y })
}

/// What gives the parts of a run that read the same levels of one unit's image their pixels.
pub(crate) trait Parts<const K: usize> {
    /// The pixels of a part.
    type SpanShader: SpanShader;

    /// The unit's index.
    fn unit(&self) -> u32;

    /// The source for a part of a run; `None` where batches must do it.
    fn source(&self, u: &FragUniforms, w: &Work<'_, '_>, part: &Part<'_, K>) -> Option<Self::SpanShader>;
}

/// A part of a primitive.
pub(crate) struct Part<'a, const K: usize> {
    pub segment: Segment,
    pub extent: Extent,
    pub unit: Unit<'a, K>,
    pub reads: MipRange,
}

/// The run of the first segment, part by part; leaves in `tex.n` how many of its pixels are done.
#[inline(always)]
fn parts<const K: usize, P: Parts<K>>(
    b: &mut FragmentBatch,
    u: &FragUniforms,
    w: &mut Work<'_, '_>,
    arg: u32,
    of: Option<P>,
) {
    b.tex.n = 0;
    let segment = b.segments[0];
    let (Some(planes), Some(of)) = (w.planes.get(segment.prim as usize), of) else { return };
    let (x, y) = row_origin(&segment, planes);
    let Some(Some(slots)) = u.layout.units.get(of.unit() as usize) else { return };
    let mut done = 0;
    while let Some(unit) = unit::<K>(w, &segment, slots, of.unit())
        && let x = x.wrapping_add(done as i32)
        && let Some((reads, n)) = reads(b, u, (&unit, of.unit()), (x, y, segment.len - done))
    {
        let part = Part { segment: rest(&segment, done, n), extent: along(x, y, n), unit, reads };
        let Some(source) = of.source(u, w, &part) else { break };
        let depth = depth_test(planes, (x, y, n), u, arg);
        let did = run(w, &part.segment, x, &Run { depth, source: Some(source) }) as u32;
        done += did;
        if did < n {
            break;
        }
    }
    b.tex.n = done as usize;
}

stage! {
    /// The run of the first segment; leaves in `tex.n` how many of its pixels it has done. The rest, which is at the end of
    /// the buffers or of a primitive whose planes need `f64`, must go through batches.
    pub(crate) fn FILL: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        b.tex.n = 0;
        let segment = b.segments[0];
        let Some(planes) = w.planes.get(segment.prim as usize) else { return };
        let (x, y) = row_origin(&segment, planes);
        let mut paint = None;
        if arg & COLOR != 0 {
            let planes = u.layout.color.and_then(|slot| primitive::<4>(w, &segment, slot));
            paint = planes.and_then(|(planes, pool)| Paint::new(planes, pool, Some(y), u.packed_or));
            if paint.is_none() {
                return;
            }
        }
        let depth = depth_test(planes, (x, y, segment.len), u, arg);
        let (len, at) = (segment.len as usize, segment.offset as usize);
        if depth.is_none() && let Some(Paint::Flat(packed)) = paint {
            if let Some(pixels) = w.band.rgba8.get_mut(at..at + len) {
                pixels.fill(packed);
                b.tex.n = len;
            }
            return;
        }
        // Apart, so that neither loop asks of which kind it is.
        b.tex.n = match paint {
            Some(Paint::Flat(packed)) => run(w, &segment, x, &Run { depth, source: Some(Same(packed)) }),
            _ => run(w, &segment, x, &Run { depth, source: paint }),
        };
    }

    /// The same with the nearest texel of one image in the place of a colour. What it does not do (at the end of the
    /// buffers, or coordinates far from 0) must go through batches.
    pub(crate) fn FILL_TEXELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.copied.as_ref());
    }

    /// The same with what one linearly filtered image shows: three channels in two dimensions.
    pub(crate) fn FILL_RGB: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGB, false>::of));
    }

    /// [`FILL_RGB`] with four channels.
    pub(crate) fn FILL_RGBA: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGBA, false>::of));
    }

    /// [`FILL_RGB`] in three dimensions.
    pub(crate) fn FILL_RGB_3D: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Solid::of));
    }

    /// [`FILL_RGB`] with blending.
    pub(crate) fn FILL_RGB_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGB, true>::of));
    }

    /// [`FILL_RGBA`] with blending.
    pub(crate) fn FILL_RGBA_BLENDED: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Flat::<RGBA, true>::of));
    }

    /// [`FILL_RGB`] of two units, and between levels.
    pub(crate) fn FILL_TWO_UNITS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, TwoImages::of(u));
    }

    /// What [`FILL_RGB`] leaves of a run because two levels are blended.
    pub(crate) fn FILL_RGB_LEVELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Between::<RGB>::of));
    }

    /// What [`FILL_RGBA`] leaves of a run because two levels are blended.
    pub(crate) fn FILL_RGBA_LEVELS: FragFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) {
        parts(b, u, w, arg, u.shown.as_ref().and_then(Between::<RGBA>::of));
    }
}
