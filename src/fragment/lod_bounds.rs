//! The level of detail of many fragments at once (OpenGL 1.5, section 3.8.8): where limits of rho over a part of a row leave
//! one mipmap level, no fragment of it needs derivatives. With D > 0,
//!
//! ```text
//!   du/dx = K_x / D^2    K_x = N_x D - N D_x    constant along a row
//!   du/dy = K_y / D^2    K_y = N_y D - N D_y    linear along a row
//! ```
//!
//! so the greatest and the least of |K_x|, |K_y| and D follow from the two ends. What rounding may add, here and in the
//! derivatives that are not worked out, widens the limits. They are computed once for several batches of a row: for all
//! of it, or for as many pixels as they were of use for before.

use super::mip_range::{Axis, LodLookahead, MipRange, MipWeight};
use super::planes::Unit;
use super::span::mip_fraction::even_rho2;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::simd::LANES;
use crate::texture::batch::{Derivatives, TexBatch};
use crate::texture::rho_ranges::RhoRanges;

/// Bounds of the relative error of sums and products with this many terms, with a margin: in `f64` (1/D has 2^-45) and
/// in `f32`.
const LOST_WIDE: f64 = 1.0 / (1u64 << 40) as f64;
const LOST: f64 = 1.0 / (1u64 << 18) as f64;
/// The same for the squares of rho, which are `f32` everywhere.
const LOST_RHO: f64 = 1.0 / (1u64 << 18) as f64;
/// For how many pixels limits are computed at most.
const FARTHEST: u32 = 4096;

/// Pixels of some rows relative to the primitive's origin, both ends included.
#[derive(Clone, Copy, Debug)]
struct Span {
    x: [f64; 2],
    y: [f64; 2],
}

#[inline(always)]
fn positive(v: f64) -> f64 {
    if v > 0.0 { v } else { 0.0 }
}

#[inline(always)]
fn ordered(a: f64, b: f64) -> [f64; 2] {
    if a < b { [a, b] } else { [b, a] }
}

/// What is known of a span.
struct Limits {
    /// Between which numbers the squares of rho of all pixels are, as fragments compute them.
    rho2: [f64; 2],
    /// The axis of which they are the squares.
    axis: Axis,
}

/// What is known of rho in all pixels of a span; `None` where D may come near 0.
/// `SEVERAL`: it may have more than one row.
fn limits<const K: usize, const SEVERAL: bool>(unit: &Unit<'_, K>, span: Span, scale: &[f64; 3]) -> Option<Limits> {
    let Span { x, y } = span;
    let d = &unit.divisor;
    let lost = if unit.wide { LOST_WIDE } else { LOST };
    let far = x[0].abs() + x[1].abs();
    let high = ordered(y[0].abs(), y[1].abs())[1];
    let start = y.map(|y| d.at + d.y * y);
    let at = x.map(|x| start[0] + d.x * x);
    let terms = d.at.abs() + d.y.abs() * high + d.x.abs() * far;
    let [mut least, mut most] = ordered(at[0], at[1]);
    if SEVERAL {
        let [low, high] = ordered(start[1] + d.x * x[0], start[1] + d.x * x[1]);
        (least, most) = (ordered(least, low)[0], ordered(most, high)[1]);
    }
    let (least, most) = (least - lost * terms, most + lost * terms);
    if least.is_nan() || least <= 0.0 {
        return None;
    }
    // Least and greatest sums of (K_x size)^2 and (K_y size)^2.
    let (mut across, mut up) = ([0.0f64; 2], [0.0f64; 2]);
    for k in 0..K {
        let p = &unit.coords[k];
        let n = p.n0 + p.ny * y[0];
        // The first is the same along a row, the second along a column; where they change their sign they are 0.
        let mut kx = [p.nx * start[0] - n * d.x; 2];
        if SEVERAL {
            kx[1] = p.nx * start[1] - (p.n0 + p.ny * y[1]) * d.x;
        }
        let ky = [0, 1].map(|i: usize| p.ny * at[i] - (n + p.nx * x[i]) * d.y);
        let n_terms = p.n0.abs() + p.ny.abs() * high + p.nx.abs() * far;
        let off = lost * ((p.nx.abs() + p.ny.abs()) * terms + n_terms * (d.x.abs() + d.y.abs()));
        let square = |v: f64| v * scale[k] * (v * scale[k]);
        for (sums, ends) in [(&mut across, kx), (&mut up, ky)] {
            let [low, high] = ordered(ends[0].abs(), ends[1].abs());
            let low = if ends[0] * ends[1] > 0.0 { low } else { 0.0 };
            sums[0] += square(positive(low - off));
            sums[1] += square(high + off);
        }
    }
    let [low, high] = [0, 1].map(|i: usize| ordered(across[i], up[i])[1]);
    let fourth = |d: f64| (d * d) * (d * d);
    let exceeds = |a: [f64; 2], b: [f64; 2]| a[0] * (1.0 - LOST_RHO) > b[1] * (1.0 + LOST_RHO);
    let axis = match (exceeds(across, up), exceeds(up, across)) {
        (true, _) => Axis::X,
        (_, true) => Axis::Y,
        _ => Axis::Either,
    };
    Some(Limits { rho2: [low / fourth(most) * (1.0 - LOST_RHO), high / fourth(least) * (1.0 + LOST_RHO)], axis })
}

/// What is known of the levels that the fragments of a row read, of the unit with this index. The row is so many pixels
/// long from (x, y) on, relative to the primitive's origin.
#[inline(always)]
pub fn of_row<const K: usize>(
    lookahead: &mut LodLookahead,
    index: usize,
    b: &TexBatch,
    unit: &Unit<'_, K>,
    (x, y, len): (i32, i32, u32),
    levels: &RhoRanges,
) -> Derivatives {
    let index = index % MAX_TEXTURE_UNITS;
    let Some(after) = lookahead.left.checked_sub(len) else { return Derivatives::PerLane };
    let (level, end) = lookahead.levels[index];
    if after >= end {
        return Derivatives::OneLevel(level);
    }
    if (lookahead.blended >> index) & 1 != 0 {
        return Derivatives::PerLane;
    }
    let reach = lookahead.reach[index].max(len);
    let pixels = if reach < lookahead.left { reach } else { lookahead.left };
    match reads::<K, false>(b, unit, along(x, y, pixels), levels) {
        Some(MipRange::One(level)) => {
            lookahead.levels[index] = (level, lookahead.left - pixels);
            lookahead.reach[index] = (2 * reach).min(FARTHEST);
            Derivatives::OneLevel(level)
        }
        _ => {
            lookahead.reach[index] = pixels / 2;
            lookahead.blended |= u32::from(levels.blends) << index;
            Derivatives::PerLane
        }
    }
}

/// The levels that the next pixels of a row read, and how many pixels that holds for. The row has `left` pixels from
/// (x, y) on. `None` where limits do not determine the levels of as many pixels as a batch has.
#[inline(always)]
pub fn part<const K: usize>(
    lookahead: &mut LodLookahead,
    index: u32,
    b: &TexBatch,
    unit: &Unit<'_, K>,
    (x, y, left): (i32, i32, u32),
    levels: &RhoRanges,
) -> Option<(MipRange, u32)> {
    let reach = lookahead.reach.get_mut(index as usize)?;
    loop {
        let pixels = (*reach).max(LANES as u32).min(left);
        if let Some(reads) = reads::<K, false>(b, unit, along(x, y, pixels), levels) {
            *reach = (2 * *reach).clamp(LANES as u32, FARTHEST);
            return Some((reads, pixels));
        }
        *reach = pixels / 2;
        if pixels <= LANES as u32 {
            return None;
        }
    }
}

/// The span of so many pixels from (x, y) on.
#[inline(always)]
fn along(x: i32, y: i32, pixels: u32) -> Span {
    let (x, y) = (f64::from(x), f64::from(y));
    Span { x: [x, x + f64::from(pixels.saturating_sub(1))], y: [y; 2] }
}

/// The levels that pixels read whose x and y, relative to the primitive's origin, are in these limits; `None` where
/// bounds do not determine them.
#[inline(always)]
pub fn of_rows<const K: usize>(
    b: &TexBatch,
    unit: &Unit<'_, K>,
    [x, y]: [[i32; 2]; 2],
    levels: &RhoRanges,
) -> Option<MipRange> {
    reads::<K, true>(b, unit, Span { x: x.map(f64::from), y: y.map(f64::from) }, levels)
}

/// The levels that the pixels of a span read, if limits determine them.
#[inline(never)]
fn reads<const K: usize, const SEVERAL: bool>(
    b: &TexBatch,
    unit: &Unit<'_, K>,
    span: Span,
    levels: &RhoRanges,
) -> Option<MipRange> {
    // Lambda is the same in all pixels, and is computed: bounds would not do where it lies exactly on the step between
    // two levels, as it does for an image that is drawn in its own size.
    if unit.is_even()
        && let Some((level, share)) = levels.exactly(even_rho2(unit, levels))
    {
        return Some(share.map_or(MipRange::One(level), |share| MipRange::Two(level, MipWeight::Same(share))));
    }
    let Limits { rho2, axis } = limits::<K, SEVERAL>(unit, span, &levels.scale)?;
    match levels.only(b, rho2) {
        Some(level) => Some(MipRange::One(level)),
        None => Some(MipRange::Two(levels.first_of_two(rho2)?, MipWeight::By(axis))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragment::batch::{FragmentBatch, Segment};
    use crate::fragment::planes::{Linear, Plane, Planes, UnitSlots};
    use crate::fragment::reference::lanes::row_positions;
    use crate::fragment::reference::texcoord::{First, whole};
    use crate::simd::LANES;

    /// Numbers between -1 and 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 1u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }
    }

    /// The squares of rho that fragments find are between the limits, and these are close where the row is far from the
    /// horizon.
    #[test]
    fn limits_hold_every_fragment() {
        const SLOTS: UnitSlots =
            UnitSlots { base: 0, count: 2, has_q: false, period: [1; 3], size: [256, 64, 1], cube: false };
        let mut next = numbers();
        let mut b = Box::new(FragmentBatch::new());
        let (mut known, mut close, mut either, mut all) = (0, 0, 0, 0);
        for round in 0..40_000 {
            let (steep, odd) = (10f64.powf(-2.0 + 2.5 * next()), 10f64.powf(4.0 * next()));
            let divisor = Linear { at: 0.5 + 0.5 * next(), x: 1e-3 * steep * next(), y: 1e-3 * steep * next() };
            let plane = |v: [f64; 3]| Plane { c: 0.3, min: -1e9, max: 1e9, n0: v[0], nx: v[1], ny: v[2] };
            let mut numerator = || plane([odd * next(), 1e-2 * odd * next(), 1e-2 * odd * next()]);
            let mut coords = [numerator(), numerator()];
            if round % 5 == 0 {
                // Nearly proportional to D: K is what is left of large terms.
                let (k, off) = (odd * next(), 1e-4 * next());
                coords[0] = plane([k * divisor.at, k * divisor.x * (1.0 + off), k * divisor.y * (1.0 - off)]);
            }
            let planes = Planes { d: divisor, ..Planes::default() };
            let unit = Unit { planes: &planes, coords: &coords, divisor, has_q: false, wide: round % 2 == 0 };
            let (x, y) = ((300.0 * next()) as i32, (300.0 * next()) as i32);
            let len = 1 + (31.9 * (next() + 1.0)) as u32;
            // One row or several.
            let last = y + round % 3;
            let scale = SLOTS.size.map(f64::from);
            let ends = [f64::from(x), f64::from(x) + f64::from(len - 1)];
            let span = Span { x: ends, y: [f64::from(y), f64::from(last)] };
            let size = [scale[0], scale[1], 0.0];
            let found =
                if last > y { limits::<2, true>(&unit, span, &size) } else { limits::<2, false>(&unit, span, &size) };
            let Some(Limits { rho2: [least, greatest], axis }) = found else { continue };
            known += 1;
            close += u32::from(greatest < 1.1 * least);
            for y in y..=last {
                whole(
                    &mut b,
                    &unit,
                    row_positions(&Segment { len, x, y, row: true, ..Segment::default() }, &planes),
                    &SLOTS,
                    First { computes: true, leaves: true, shared: false },
                    true,
                );
                for i in 0..LANES.min(len as usize) {
                    let span = |d: &[crate::texture::batch::Lanes; 3]| {
                        let (s, t) = (d[0][i] * scale[0] as f32, d[1][i] * scale[1] as f32);
                        s * s + t * t
                    };
                    let [across, up] = [span(&b.tex.ddx), span(&b.tex.ddy)];
                    let found = f64::from(across.max(up));
                    match axis {
                        Axis::X => assert!(across >= up, "{round}, lane {i}: {across:e}, {up:e}"),
                        Axis::Y => assert!(up >= across, "{round}, lane {i}: {across:e}, {up:e}"),
                        Axis::Either => either += 1,
                    }
                    all += 1;
                    assert!(
                        least <= found && found <= greatest,
                        "{round}, lane {i}: {found:e} in {least:e} to {greatest:e}"
                    );
                }
            }
        }
        assert!(2 * either < all, "{either} of {all} along either axis");
        assert!(known > 20_000 && close > 10_000, "{known} rows, {close} of them with close limits");
    }
}
