//! The span kernels and the one table that picks them. A kernel does whole rows of a primitive in place of the reference
//! path's stages: `long` one row at a time, `short` the short rows of a primitive together. A row of the table says what a
//! kernel shows, from which length on it pays, and why it is there; a new kernel is a new row. What no row covers goes
//! through the reference path, which gives the same bits.

use super::color::FlatColor;
use super::long::{COLOR, DEPTH, textured_row, whole_row};
use super::pixel_rect::pixel_row;
use super::short::{colored_rows, textured_rows};
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::key::{ColorWrites, FragmentKey, FragmentSource, SpanTexture};
use crate::fragment::planes::Planes;
use crate::fragment::reference::depth::WRITE;
use crate::fragment::reference::lanes::row_origin;
use crate::fragment::reference::pack::PackedColor;
use crate::fragment::uniforms::{FragUniforms, LongFn, ShortFn, Work};
use crate::simd::{Level, Stage, Step, stage};

/// What a kernel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// The primary colour, or depth alone.
    Color,
    /// Packed colours of a pixel rectangle.
    Pixels,
    /// Nearest texels.
    Nearest,
    /// A linear filter of three channels, perhaps with a light map.
    LinearRgb,
    /// A linear filter of four channels.
    LinearRgba,
    /// A linear filter of three channels in three dimensions.
    LinearRgb3d,
}

/// A row of the table.
struct Row {
    shows: Shows,
    long: &'static Stage<LongFn>,
    short: Option<&'static Stage<ShortFn>>,
    /// Rows from this length on, in pixels, are worth a call of `long`: shorter ones of several rows make a batch.
    long_from: u32,
    /// Rows below this length are done by `short`, together with the others of their primitive.
    short_below: u32,
    /// About what a pixel costs, in pixels of one colour.
    pixel: u64,
    reason: &'static str,
}

/// All kernels.
static KERNELS: [Row; 6] = [
    Row {
        shows: Shows::Color,
        long: &LONG_COLOR,
        short: Some(&SHORT_COLOR),
        long_from: 8,
        short_below: 64,
        pixel: 4,
        reason: "only depth and the primary colour",
    },
    Row {
        shows: Shows::Pixels,
        long: &LONG_PIXELS,
        short: None,
        long_from: 8,
        short_below: 0,
        pixel: 2,
        reason: "only depth and a pixel rectangle of packed colours",
    },
    Row {
        shows: Shows::Nearest,
        long: &LONG_NEAREST,
        short: Some(&SHORT_NEAREST),
        long_from: 48,
        short_below: 48,
        pixel: 6,
        reason: "only depth and nearest texels as they are",
    },
    Row {
        shows: Shows::LinearRgb,
        long: &LONG_LINEAR_RGB,
        short: Some(&SHORT_LINEAR_RGB),
        long_from: 48,
        short_below: 128,
        pixel: 24,
        reason: "only depth and a linear filter of opaque texels, perhaps with a light map",
    },
    Row {
        shows: Shows::LinearRgba,
        long: &LONG_LINEAR_RGBA,
        short: Some(&SHORT_LINEAR_RGBA),
        long_from: 48,
        short_below: 128,
        pixel: 24,
        reason: "only depth and a linear filter, blended by a usual pair of factors or not at all",
    },
    Row {
        shows: Shows::LinearRgb3d,
        long: &LONG_LINEAR_RGB_3D,
        short: None,
        long_from: 48,
        short_below: 0,
        pixel: 24,
        reason: "only depth and a linear filter in three dimensions",
    },
];

/// The kernel of a program, ready to run.
#[derive(Clone, Debug)]
pub struct SpanKernel {
    /// What it shows.
    pub shows: Shows,
    /// One row at a time.
    pub long: Step<LongFn>,
    /// The short rows of a primitive.
    pub short: Option<Step<ShortFn>>,
    /// Rows from this length on go to `long`.
    pub long_from: u32,
    /// Rows below this length go to `short`.
    pub short_below: u32,
    /// About what a pixel costs, in pixels of one colour.
    pub pixel: u64,
    /// Whether the kernel may go on with a row after a batch: there are mipmap levels, and bounds that do not determine
    /// the levels of some pixels may determine those of the rest.
    pub resumes: bool,
    /// Why it is there.
    pub reason: &'static str,
}

impl SpanKernel {
    /// The kernel for a key, or why there is none. `texture`: what texturing comes to, where that is simple enough;
    /// `mipmapped`: bounds of rho choose its levels.
    pub fn select(
        level: Level,
        key: &FragmentKey,
        texture: Option<&SpanTexture>,
        mipmapped: bool,
    ) -> Result<Self, &'static str> {
        if let Some(obstacle) = key.span_obstacle() {
            return Err(obstacle);
        }
        let has_color = key.colors != ColorWrites::Nothing;
        let shows = match texture {
            _ if !has_color => Shows::Color,
            _ if key.source == FragmentSource::PixelColors { packed: true } && key.stores_primary() => Shows::Pixels,
            _ if key.source != FragmentSource::Primitive => return Err("a pixel rectangle gives the colours"),
            None if key.is_plain() => Shows::Color,
            None if key.textured => return Err("texturing is more than a filter and a simple environment"),
            None => return Err("untextured colours are blended"),
            Some(SpanTexture::Nearest(_)) => Shows::Nearest,
            Some(SpanTexture::LinearRgb(_)) => Shows::LinearRgb,
            Some(SpanTexture::LinearRgba(_)) => Shows::LinearRgba,
            Some(SpanTexture::LinearRgb3d(_)) => Shows::LinearRgb3d,
        };
        let row = KERNELS.iter().find(|row| row.shows == shows).ok_or("no kernel shows that")?;
        let write = if key.tests.depth_write { WRITE } else { 0 };
        let depth = key.tests.depth.map_or(0, |func| DEPTH | (func as u32) << 1 | write);
        let color = if has_color && shows == Shows::Color { COLOR } else { 0 };
        let arg = depth | color;
        // Short rows of the primary colour gain from being done together only by waiting for their depths at once.
        let short = row.short.filter(|_| shows != Shows::Color || depth != 0 && has_color);
        Ok(Self {
            shows,
            long: row.long.step(level, arg),
            short: short.map(|short| short.step(level, arg)),
            long_from: row.long_from,
            short_below: short.map_or(0, |_| row.short_below),
            pixel: row.pixel,
            resumes: mipmapped,
            reason: row.reason,
        })
    }

    /// Whether depth is tested.
    pub fn tests_depth(&self) -> bool {
        self.long.arg & DEPTH != 0
    }

    /// Whether it reads no texture.
    pub fn is_untextured(&self) -> bool {
        self.shows == Shows::Color
    }

    /// Whether colour is written that is not a texture's.
    pub fn has_primary_color(&self) -> bool {
        self.long.arg & COLOR != 0
    }
}

/// A row of the primary colour, or of depth alone.
#[inline(always)]
fn long_color(u: &FragUniforms, w: &mut Work<'_, '_>, segment: &Segment, planes: &Planes, arg: u32) -> u32 {
    let (_, y) = row_origin(segment, planes);
    let mut color = None;
    if arg & COLOR != 0 {
        let planes = u.layout.color.and_then(|slot| w.primitive::<4>(segment, slot));
        color = planes.and_then(|(planes, pool)| PackedColor::new(planes, pool, Some(y), u.packed_or));
        if color.is_none() {
            return 0;
        }
    }
    if arg & DEPTH == 0
        && let Some(PackedColor::Flat(packed)) = color
    {
        let at = segment.offset as usize;
        let Some(pixels) = w.band.rgba8.get_mut(at..at + segment.len as usize) else { return 0 };
        pixels.fill(packed);
        if let Some(counts) = &mut w.counts {
            counts.passed += u64::from(segment.len);
        }
        return segment.len;
    }
    // One call for each kind, so that no loop tests which kind it is.
    match color {
        Some(PackedColor::Flat(packed)) => whole_row(w, (segment, planes), arg, Some(&FlatColor(packed))),
        Some(PackedColor::Smooth(smooth)) => whole_row(w, (segment, planes), arg, Some(&smooth)),
        None => whole_row(w, (segment, planes), arg, None::<&FlatColor>),
    }
}

stage! {
    /// Depth and the primary colour.
    fn LONG_COLOR: LongFn = (_b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(planes) = w.planes.get(s.prim as usize) else { return 0 };
        long_color(u, w, s, planes, arg)
    }

    /// Depth and a pixel rectangle.
    fn LONG_PIXELS: LongFn = (_b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(planes) = w.planes.get(s.prim as usize) else { return 0 };
        pixel_row(u, w, s, planes, arg)
    }

    /// Depth and nearest texels.
    fn LONG_NEAREST: LongFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(SpanTexture::Nearest(texture)) = &u.span else { return 0 };
        textured_row(b, u, w, s, arg, texture)
    }

    /// Depth and a linear filter of three channels.
    fn LONG_LINEAR_RGB: LongFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(SpanTexture::LinearRgb(texture)) = &u.span else { return 0 };
        textured_row(b, u, w, s, arg, texture)
    }

    /// Depth and a linear filter of four channels.
    fn LONG_LINEAR_RGBA: LongFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(SpanTexture::LinearRgba(texture)) = &u.span else { return 0 };
        textured_row(b, u, w, s, arg, texture)
    }

    /// Depth and a linear filter in three dimensions.
    fn LONG_LINEAR_RGB_3D: LongFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, s: &Segment, arg: u32) -> u32 {
        let Some(SpanTexture::LinearRgb3d(texture)) = &u.span else { return 0 };
        textured_row(b, u, w, s, arg, texture)
    }

    /// Short rows of the primary colour with depth.
    fn SHORT_COLOR: ShortFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) -> bool {
        let rows = b.segments.get(..b.segment_count).unwrap_or(&[]);
        let (Some(first), Some(slot)) = (rows.first(), u.layout.color) else { return false };
        let Some((planes, pool)) = w.primitive::<4>(first, slot) else { return false };
        let Some(color) = PackedColor::new(planes, pool, None, u.packed_or) else { return false };
        colored_rows(rows, (planes, &color), w, arg)
    }

    /// Short rows of nearest texels.
    fn SHORT_NEAREST: ShortFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) -> bool {
        let Some(SpanTexture::Nearest(texture)) = &u.span else { return false };
        textured_rows(b, u, w, arg, texture)
    }

    /// Short rows of a linear filter of three channels.
    fn SHORT_LINEAR_RGB: ShortFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) -> bool {
        let Some(SpanTexture::LinearRgb(texture)) = &u.span else { return false };
        textured_rows(b, u, w, arg, texture)
    }

    /// Short rows of a linear filter of four channels.
    fn SHORT_LINEAR_RGBA: ShortFn = (b: &mut FragmentBatch, u: &FragUniforms, w: &mut Work<'_, '_>, arg: u32) -> bool {
        let Some(SpanTexture::LinearRgba(texture)) = &u.span else { return false };
        textured_rows(b, u, w, arg, texture)
    }
}
