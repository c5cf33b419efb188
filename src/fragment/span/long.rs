//! Long spans: a row of a primitive, of any length, block by block without a batch in between (OpenGL 1.5, section 4.1.6):
//! depth is computed, compared and written, then the colour of what passed is computed and written. Blocks are of 64
//! pixels, the last ones of a row of 16.

use super::shader::{Part, SpanShader, SpanSource};
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::compare::{CompareFunc, compare, holds, living};
use crate::fragment::hiz::{hiz_cull, hiz_update, uses_hiz};
use crate::fragment::lod_bounds;
use crate::fragment::mip_range::MipRange;
use crate::fragment::plane_eval::{Extent, InRow, RowRange};
use crate::fragment::planes::{Planes, Unit};
use crate::fragment::reference::depth::{DepthSlope, WRITE, lanes};
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::reference::places::write;
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::simd::{LANES, PixelCost};

/// Bits of a kernel's argument above those of the depth test: depth is tested, colour is written.
pub const DEPTH: u32 = 1 << 4;
pub const COLOR: u32 = 1 << 5;

/// From this length on, in pixels, hierarchical depth is updated after a row. It reads the depths of whole blocks,
/// which pays only where it lets later rows be skipped.
const HIZ_UPDATE_FROM: usize = 32;
/// Pixels of the last blocks of a row.
const SHORT: usize = 16;

/// The depth test of a row.
struct DepthTest {
    slope: DepthSlope,
    func: CompareFunc,
    writes: bool,
}

impl DepthTest {
    /// That of a kernel's argument along `len` pixels from (x, y) on; `None` where there is none.
    #[inline(always)]
    fn new(planes: &Planes, (x, y, len): (i32, i32, u32), arg: u32) -> Option<Self> {
        let last = x.wrapping_add(len.wrapping_sub(1).cast_signed());
        let slope = || DepthSlope::new(planes, y).between(x, last);
        (arg & DEPTH != 0).then(|| Self {
            slope: slope(),
            func: CompareFunc::from_arg(arg >> 1),
            writes: arg & WRITE != 0,
        })
    }
}

/// What all blocks of a row need.
struct Row<'a, S> {
    depth: Option<DepthTest>,
    shader: Option<&'a S>,
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

impl<S: SpanShader> Row<'_, S> {
    /// `N` pixels from `at` on, of which the first `n` are of the row; lane 0 is at `x`, relative to the primitive's
    /// origin.
    #[inline(always)]
    fn block<const N: usize>(&self, w: &mut Work<'_, '_>, at: usize, x: i32, n: usize) -> Block {
        let mut color = None;
        if let Some(shader) = self.shader {
            let Some(pixels) = w.band.rgba8.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) else {
                return Block::Outside;
            };
            color = Some((shader, pixels));
        }
        let mut full = n == N;
        let mut depth = None;
        if let Some(DepthTest { slope, func, writes }) = &self.depth {
            let Some(buffer) = w.band.depth.get_mut(at..).and_then(|r| r.first_chunk_mut::<N>()) else {
                return Block::Outside;
            };
            let mut z = [0; N];
            slope.depths(x, &mut z);
            full &= holds(*func, &z, buffer);
            if full && *writes {
                *buffer = z;
            }
            depth = Some((z, *func, *writes, buffer));
        }
        if S::IS_SMALL && full {
            if let Some(counts) = &mut w.counts {
                counts.passed += N as u64;
            }
            if let Some((shader, pixels)) = color {
                shader.pixels(InRow(x as f32), &[0; N], pixels);
            }
            return Block::Alive;
        }
        let mut mask = [0; N];
        if !full {
            mask = if n == N { [u32::MAX; N] } else { lanes(n) };
            if let Some((z, func, writes, buffer)) = depth {
                compare(func, &z, buffer, &mut mask);
                // In a block of 16 pixels the question costs more than going on.
                if N > SHORT && living(&mask) == 0 {
                    return Block::Dead;
                }
                if writes {
                    write(false, &mask, &z, buffer);
                }
            }
        }
        if let Some(counts) = &mut w.counts {
            counts.passed += if full { N as u64 } else { u64::from(living(&mask)) };
        }
        if let Some((shader, pixels)) = color {
            let mut out = [0; N];
            shader.pixels(InRow(x as f32), pixels, &mut out);
            write(full, &mask, &out, pixels);
        }
        Block::Alive
    }

    /// The next pixel of a row from its pixel `from` on that hierarchical depth does not hide.
    #[inline(always)]
    fn skip(&self, w: &Work<'_, '_>, run: &Segment, x: i32, from: usize) -> usize {
        let Some(DepthTest { slope, func, .. }) = &self.depth else { return from };
        let (first, step) = (from as u32, from as i32);
        let rest = Segment { x: run.x.wrapping_add(step), len: run.len - first, ..*run };
        from + hiz_cull(w.band, &rest, slope, x.wrapping_add(step), *func) as usize
    }

    /// The row of a segment that begins at x, relative to the primitive's origin; gives how many of its pixels are done.
    #[inline(always)]
    fn run(&self, w: &mut Work<'_, '_>, segment: &Segment, x0: i32) -> usize {
        let (len, at) = (segment.len as usize, segment.offset as usize);
        let mut done = self.skip(w, segment, x0, 0);
        let first = done;
        while done < len {
            let (at, x) = (at + done, x0.wrapping_add(done as i32));
            let left = len - done;
            let (block, n) = if left >= LANES {
                (self.block::<LANES>(w, at, x, LANES), LANES)
            } else {
                let n = if left > SHORT { SHORT } else { left };
                (self.block::<SHORT>(w, at, x, n), n)
            };
            match block {
                Block::Outside => break,
                Block::Alive => done += n,
                Block::Dead => done = self.skip(w, segment, x0, done + n),
            }
        }
        if let Some(DepthTest { func, writes: true, .. }) = self.depth
            && done - first >= HIZ_UPDATE_FROM
            && uses_hiz(func)
        {
            let (x, offset) = (segment.x.wrapping_add(first as i32), segment.offset.wrapping_add(first as u32));
            hiz_update(w.band, &Segment { x, offset, ..*segment }, done - first);
        }
        done
    }
}

/// A row whose pixels all have one shader, or none; gives how many of its pixels are done.
#[inline(always)]
pub fn whole_row<S: SpanShader>(
    w: &mut Work<'_, '_>,
    (segment, planes): (&Segment, &Planes),
    arg: u32,
    shader: Option<&S>,
) -> u32 {
    let (x, y) = row_origin(segment, planes);
    let row = Row { depth: DepthTest::new(planes, (x, y, segment.len), arg), shader };
    let (before, done) = (w.passed(), row.run(w, segment, x) as u32);
    if w.counts.is_some() {
        w.count(before, row.shader.map_or(PixelCost::default(), S::cost));
    }
    done
}

/// The part of a row, with `left` pixels from (x, y) on, that reads the same mipmap levels, and these; `None` at the end, and
/// where there are levels and bounds do not determine which.
#[inline(always)]
fn next_part<const K: usize>(
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

/// A row of a textured primitive, part by part; gives how many of its pixels are done.
#[inline(always)]
pub fn textured_row<const K: usize, S: SpanSource<K>>(
    b: &mut FragmentBatch,
    u: &FragUniforms,
    w: &mut Work<'_, '_>,
    segment: &Segment,
    arg: u32,
    source: S,
) -> u32 {
    let Some(planes) = w.planes.get(segment.prim as usize) else { return 0 };
    let (x, y) = row_origin(segment, planes);
    let Some(Some(slots)) = u.layout.units.get(source.unit() as usize) else { return 0 };
    let mut done = 0;
    while let Some(unit) = w.unit::<K>(segment, slots, source.unit())
        && let x = x.wrapping_add(done as i32)
        && let Some((levels, n)) = next_part(b, u, (&unit, source.unit()), (x, y, segment.len - done))
    {
        let extent = Extent::Row(RowRange { x: [x, x.wrapping_add(n.wrapping_sub(1).cast_signed())], y });
        let (at, offset) = (segment.x.wrapping_add(done as i32), segment.offset.wrapping_add(done));
        let part = Part { segment: Segment { x: at, offset, len: n, ..*segment }, extent, unit, levels };
        w.count_lambda(&unit, u.levels.get(source.unit() as usize).unwrap_or(&None));
        // By reference: a shader is large, and would be copied field by field.
        let shader = source.shader(u, w, &part);
        let Some(shader) = &shader else { break };
        let did = whole_row(w, (&part.segment, planes), arg, Some(shader));
        done += did;
        if did < n {
            break;
        }
    }
    done
}
