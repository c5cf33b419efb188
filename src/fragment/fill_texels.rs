//! Runs of a row, of any length, of programs that test depth and put the nearest texel of one 8-bit image in the place of
//! the colour (OpenGL 1.5, sections 3.8.7, 3.8.8 and 3.8.13): what [`fill`](super::fill) does for interpolated colours.
//! What is the same for all of a run (planes in its row, limits, wraps) is worked out once; then each block goes from
//! positions to texels without a batch in between, and where all its fragments are alive texels are copied straight into
//! the framebuffer. Every number comes from the same expressions as in the stages of batches, so the bits are the same.

use super::batch::Segment;
use super::buffers::write;
use super::coordinates::{Unit, unit};
use super::fill::Source;
use super::interpolate::reciprocal64;
use super::planes::{Linear, Plane};
use super::segments::IOTA;
use super::uniforms::{FragUniforms, Work};
use super::wide::without_periods;
use crate::num::{clamp_f32, max_f32};
use crate::texture::filter::{self, neighbours};
use crate::texture::near::Near;
use crate::texture::uniforms::NearestImage;

/// The image that a program copies texels from, and the unit whose coordinates say which.
#[derive(Clone, Debug)]
pub struct Copied {
    /// The unit's index.
    pub unit: u32,
    /// The image and its wraps.
    pub from: NearestImage,
}

/// A plane along a row, in `f32` or `f64`.
#[derive(Clone, Copy)]
struct Along<T> {
    at: T,
    x: T,
    c: T,
    min: T,
    max: T,
}

/// How coordinates come about.
enum Form {
    /// w is the same everywhere.
    Even([Along<f32>; 2]),
    /// They are divided by D, whose value and change along the row follow.
    Divided([Along<f32>; 2], [f32; 2]),
    /// The same in `f64`.
    Wide([Along<f64>; 2], [f64; 2]),
}

/// What all blocks of a run need to find their texels.
pub(super) struct Texels<'a> {
    form: Form,
    column: Near,
    row: Near,
    repeats: [bool; 2],
    origin: u32,
    stride: u32,
    texels: &'a [u32],
    or: u32,
}

fn along(p: &Plane, y: f32) -> Along<f32> {
    Along { at: p.n0 as f32 + p.ny as f32 * y, x: p.nx as f32, c: p.c, min: p.min, max: p.max }
}

fn along_wide(p: &Plane, y: f32) -> Along<f64> {
    let [c, min, max] = [p.c, p.min, p.max].map(f64::from);
    Along { at: p.n0 + p.ny * f64::from(y), x: p.nx, c, min, max }
}

impl Form {
    /// Coordinates in the row y, relative to the primitive's origin.
    #[inline(always)]
    fn new(unit: &Unit<'_, 2>, y: f32) -> Self {
        let [s, t] = unit.coords;
        let Linear { at, x, y: up } = unit.divisor;
        if unit.wide {
            Self::Wide([along_wide(s, y), along_wide(t, y)], [at + up * f64::from(y), x])
        } else if unit.planes.affine {
            Self::Even([along(s, y), along(t, y)])
        } else {
            Self::Divided([along(s, y), along(t, y)], [at as f32 + up as f32 * y, x as f32])
        }
    }
}

/// The texels of the row y of a segment's primitive, relative to its origin; `None` where batches must find them.
#[inline(always)]
pub(super) fn texels<'a>(u: &'a FragUniforms, w: &Work<'a, '_>, segment: &Segment, y: i32) -> Option<Texels<'a>> {
    let copied = u.copied.as_ref()?;
    let slots = u.layout.units.get(copied.unit as usize)?.as_ref()?;
    let unit = unit::<2>(w, segment, slots, copied.unit)?;
    Texels::new(&unit, &copied.from, y as f32, u.packed_or)
}

impl<'a> Texels<'a> {
    /// The texels of a row of a primitive; `None` where something is not as it is as a rule: coordinates that are not
    /// finite or too far from 0 for the simple wrap.
    #[inline(always)]
    fn new(unit: &Unit<'_, 2>, image: &'a NearestImage, y: f32, or: u32) -> Option<Self> {
        let limit = |k: usize| {
            let p = &unit.coords[k];
            let greatest = max_f32(p.max.abs(), p.min.abs());
            // As `wide_lanes` has it: half a period is left, and what rounding adds, of numbers that have a fraction.
            if unit.wide && image.repeats[k] && greatest < 1e9 { 2.0 } else { greatest }
        };
        let finite = unit.coords.iter().all(|p| p.min.is_finite() && p.max.is_finite());
        let level = &image.level;
        let column = Near::new(image.repeats[0], limit(0), level.size[0]).filter(|_| finite)?;
        let row = Near::new(image.repeats[1], limit(1), level.size[1])?;
        let (origin, stride, texels) = (level.origin, level.stride, filter::texels(level));
        let form = Form::new(unit, y);
        Some(Self { form, column, row, repeats: image.repeats, origin, stride, texels, or })
    }

    /// Where the texel at (s, t) is.
    #[inline(always)]
    fn place(&self, s: f32, t: f32) -> u32 {
        let start = self.origin.wrapping_add(self.row.index(t).wrapping_mul(self.stride));
        start.wrapping_add(self.column.index(s))
    }

    /// Where the texels are of the pixels from x on.
    #[inline(always)]
    fn places<const N: usize>(&self, x: i32) -> [u32; N] {
        let x = x as f32;
        let mut at = [0; N];
        match &self.form {
            Form::Even([s, t]) => {
                for i in 0..N {
                    let dx = x + IOTA[i];
                    let value = |p: &Along<f32>| clamp_f32(p.c + (p.at + p.x * dx), p.min, p.max);
                    at[i] = self.place(value(s), value(t));
                }
            }
            Form::Divided([s, t], [d_at, d_x]) => {
                for i in 0..N {
                    let dx = x + IOTA[i];
                    let rq = 1.0 / (d_at + d_x * dx);
                    let value = |p: &Along<f32>| clamp_f32(p.c + (p.at + p.x * dx) * rq, p.min, p.max);
                    at[i] = self.place(value(s), value(t));
                }
            }
            Form::Wide([s, t], [d_at, d_x]) => {
                let mut rq = [0.0; N];
                for i in 0..N {
                    rq[i] = reciprocal64(d_at + d_x * f64::from(x + IOTA[i]));
                }
                let s = wide(s, x, &rq, self.repeats[0]);
                let t = wide(t, x, &rq, self.repeats[1]);
                for i in 0..N {
                    at[i] = self.place(s[i], t[i]);
                }
            }
        }
        at
    }
}

/// Coordinates in `f64`, without whole periods.
#[inline(always)]
fn wide<const N: usize>(p: &Along<f64>, x: f32, rq: &[f64; N], repeats: bool) -> [f32; N] {
    let Along { at, x: step, c, min, max } = *p;
    let value = |i: usize| {
        let v = c + (at + step * f64::from(x + IOTA[i])) * rq[i];
        let v = if v > min { v } else { min };
        if v < max { v } else { max }
    };
    let mut out = [0.0; N];
    if repeats {
        for i in 0..N {
            out[i] = without_periods(value(i), 1.0, 1.0) as f32;
        }
    } else {
        for i in 0..N {
            out[i] = value(i) as f32;
        }
    }
    out
}

impl Source for Texels<'_> {
    #[inline(always)]
    fn all<const N: usize>(&self, x: i32, to: &mut [u32; N]) {
        let at = self.places::<N>(x);
        if let Form::Even(_) = self.form
            && let Some(run) =
                neighbours(&at).and_then(|first| self.texels.get(first..)).and_then(|t| t.first_chunk::<N>())
        {
            for i in 0..N {
                to[i] = run[i] | self.or;
            }
            return;
        }
        // As copies: the compiler cannot tell that what is written is not read from here.
        let (texels, or) = (self.texels, self.or);
        for i in 0..N {
            let Some(&texel) = texels.get(at[i] as usize) else { break };
            to[i] = texel | or;
        }
    }

    #[inline(always)]
    fn some<const N: usize>(&self, x: i32, mask: &[u32; N], to: &mut [u32; N]) {
        let at = self.places::<N>(x);
        let (texels, or) = (self.texels, self.or);
        let mut found = [0; N];
        for i in 0..N {
            let Some(&texel) = texels.get(at[i] as usize) else { break };
            found[i] = texel | or;
        }
        write(false, mask, &found, to);
    }
}
