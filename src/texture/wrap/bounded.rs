//! Short forms of wrapping (OpenGL 1.5, section 3.8.7) for coordinates whose bounds are known and lanes that all read one
//! image. The bounds come from the planes of the primitive, so no lane is tested. The bits are those of `general`.
//!
//! ```text
//!   within 0..=1   REPEAT   N s is N (s - nearest whole number) or N more, both exact: the index is the same modulo N
//!                  CLAMP    limits nothing
//!   |s| < 512      REPEAT   of a power of two N: the low bits of the index
//! ```

use crate::num::{clamp_f32, round_to_int};
use crate::texture::batch::TexBatch;

/// Below this one addition of [`MAGIC`] finds the whole part of a coordinate, and the coordinate times any N is below 2^22.
const NEAR: f32 = 512.0;
/// Adding it rounds to a whole number, which then stands in the low bits (see `num`).
const MAGIC: f32 = 12_582_912.0;
/// No coordinate below [`NEAR`] reaches this when it is multiplied by N: a limit that limits nothing.
const BEYOND: f32 = 4_194_304.0;

/// Bounds of a coordinate that hold in all lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordBounds {
    /// No lane is below this.
    pub least: f32,
    /// None is farther from 0.
    pub limit: f32,
}

impl CoordBounds {
    /// Those of coordinate `c` of a batch.
    #[inline(always)]
    pub(crate) fn of(b: &TexBatch, c: usize) -> Self {
        Self { least: b.least[c], limit: b.limit[c] }
    }

    /// Whether it is within 0..=1.
    #[inline(always)]
    pub(crate) fn inside(self) -> bool {
        self.least >= 0.0 && self.limit <= 1.0
    }
}

/// N less 1 if N is a power of two from 2 on, and no coordinate is as far from 0 as [`NEAR`]: then REPEAT comes down to the
/// last bits of an index. As N s is exact here, floor(N s) modulo N is the index of N (s - nearest whole number).
#[inline(always)]
fn repeat_mask(limit: f32, scale: f32, n: f32) -> Option<u32> {
    let size = round_to_int(n).cast_unsigned();
    (limit < NEAR && scale == n && size >= 2 && size.is_power_of_two()).then(|| size.wrapping_sub(1))
}

/// REPEAT of powers of two, CLAMP and CLAMP_TO_EDGE in one form, for the nearest texel of an image in one step.
#[derive(Clone, Copy)]
pub struct NearestWrap {
    n: f32,
    least: f32,
    greatest: f32,
    mask: u32,
}

impl NearestWrap {
    /// For coordinates no farther from 0 than `limit` and N texels; `None` where REPEAT does not come down to a mask.
    #[inline(always)]
    pub fn new(repeats: bool, limit: f32, n: f32) -> Option<Self> {
        if !repeats {
            // Limited to just below N, the index is at most N - 1.
            return Some(Self { n, least: 0.0, greatest: n.next_down(), mask: u32::MAX >> 10 });
        }
        let mask = repeat_mask(limit, n, n)?;
        Some(Self { n, least: -BEYOND, greatest: BEYOND, mask })
    }

    /// The index of the texel at `s`.
    #[inline(always)]
    pub fn index(&self, s: f32) -> u32 {
        let x = clamp_f32(s * self.n, self.least, self.greatest);
        let biased = x + MAGIC;
        biased.to_bits().wrapping_sub(u32::from(biased - MAGIC > x)) & self.mask
    }
}

/// How a dimension is wrapped for a linear filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinearWrap {
    /// The coordinates need no wrapping: they are only multiplied by N. The mask leaves all bits of the index, or those
    /// that REPEAT needs.
    InRange(u32),
    /// REPEAT: the nearest whole number is subtracted, and the mask is applied to the index.
    Repeat(u32),
    /// CLAMP and CLAMP_TO_EDGE.
    Clamp,
}

impl LinearWrap {
    /// For coordinates in `range`, which are multiplied with `scale`, and N texels; `None` where REPEAT does not come down
    /// to a mask.
    #[inline(always)]
    pub fn new(repeats: bool, range: CoordBounds, scale: f32, n: f32) -> Option<Self> {
        let inside = range.inside() && scale == n;
        if !repeats {
            return Some(if inside { Self::InRange(u32::MAX) } else { Self::Clamp });
        }
        let mask = repeat_mask(range.limit, scale, n)?;
        // Ties go to even numbers, so 0.5 is taken for a fraction, too.
        let whole = range.limit > 0.5;
        Some(if inside || !whole { Self::InRange(mask) } else { Self::Repeat(mask) })
    }

    /// Whether it does more than to multiply.
    #[must_use]
    pub fn wraps(self) -> bool {
        !matches!(self, Self::InRange(_))
    }

    /// Gives each lane the index of the first of its two texels, and writes the weight of the second.
    #[inline(always)]
    pub fn run<const N: usize>(
        self,
        s: &[f32; N],
        scale: f32,
        n: f32,
        weight: &mut [f32; N],
        mut put: impl FnMut(usize, i32),
    ) {
        match self {
            Self::InRange(mask) => {
                for i in 0..N {
                    let (bits, w) = pair(s[i] * n);
                    weight[i] = w;
                    put(i, (bits.wrapping_sub(MAGIC.to_bits()) & mask).cast_signed());
                }
            }
            Self::Repeat(mask) => {
                for i in 0..N {
                    let (bits, w) = pair((s[i] - ((s[i] + MAGIC) - MAGIC)) * n);
                    weight[i] = w;
                    // The low bits of MAGIC are 0.
                    put(i, (bits & mask).cast_signed());
                }
            }
            Self::Clamp => {
                for i in 0..N {
                    let (bits, w) = pair(clamp_f32(s[i] * scale, 0.0, n));
                    weight[i] = w;
                    put(i, bits.wrapping_sub(MAGIC.to_bits()).cast_signed());
                }
            }
        }
    }
}

/// The index of the first texel above the bits of [`MAGIC`], and the weight of the second.
#[inline(always)]
fn pair(x: f32) -> (u32, f32) {
    let biased = x + (MAGIC - 1.0);
    (biased.to_bits(), (x - 0.5) - (biased - MAGIC))
}

#[cfg(test)]
mod tests {
    use super::super::general::tests::both;
    use super::*;
    use crate::simd::LANES;
    use crate::state::texture::WrapMode;

    const ANYWHERE: CoordBounds = CoordBounds { least: f32::NEG_INFINITY, limit: f32::INFINITY };

    /// Index and weight of one coordinate.
    fn linear(form: LinearWrap, s: f32, n: f32) -> (i32, u32) {
        let (mut at, mut weight) = ([0; LANES], [0.0; LANES]);
        form.run(&[s; LANES], n, n, &mut weight, |i, index| at[i] = index);
        (at[LANES - 1], weight[LANES - 1].to_bits())
    }

    #[test]
    fn bounded_forms_find_the_same_texels_as_the_general_ones() {
        let near = (-200_000..200_000).map(|i| i as f32 / 512.0).flat_map(|s| [s.next_down(), s, s.next_up()]);
        let small = (0..NEAR.to_bits()).step_by(40_009).map(f32::from_bits).flat_map(|s| [s, -s]);
        for s in near.chain(small) {
            let range = CoordBounds { least: s, limit: s.abs() };
            for n in [2.0f32, 8.0, 256.0, 8192.0] {
                let (Some(form), Some(nearest)) =
                    (LinearWrap::new(true, range, n, n), NearestWrap::new(true, s.abs(), n))
                else {
                    continue;
                };
                let ((i, w), j) = both(WrapMode::Repeat, s, n);
                let (first, weight) = linear(form, s, n);
                assert!(first == i && weight == w.to_bits(), "{s:e} of {n}: {first}, not {i}");
                assert_eq!(nearest.index(s), j.cast_unsigned(), "{s:e} of {n}");
            }
            for n in [1.0f32, 2.0, 3.0, 100.0, 8191.0, 8192.0] {
                for range in [range, ANYWHERE] {
                    let clamps = NearestWrap::new(false, range.limit, n).unwrap();
                    let ((i, w), j) = both(WrapMode::Clamp, s, n);
                    assert_eq!(clamps.index(s), j.cast_unsigned(), "{s:e} of {n}");
                    let form = LinearWrap::new(false, range, n, n).unwrap();
                    assert_eq!(linear(form, s, n), (i, w.to_bits()), "{s:e} of {n}");
                }
            }
        }
        for n in [1.0, 3.0, 100.0] {
            assert_eq!(repeat_mask(0.5, n, n), None);
        }
        assert_eq!(repeat_mask(0.5, 1.0, 256.0), None);
        assert_eq!(repeat_mask(512.0, 256.0, 256.0), None);
        assert_eq!(repeat_mask(f32::INFINITY, 256.0, 256.0), None);
    }

    #[test]
    fn inside_is_from_0_to_1() {
        let inside = |least: f32, limit: f32| CoordBounds { least, limit }.inside();
        assert!(inside(0.0, 1.0) && inside(0.3, 0.3));
        assert!(!inside(-f32::from_bits(1), 1.0) && !inside(0.0, 1.0f32.next_up()));
        assert!(!inside(f32::NAN, 1.0) && !inside(0.0, f32::NAN));
        assert_eq!(LinearWrap::new(true, CoordBounds { least: 0.0, limit: 1.0 }, 3.0, 3.0), None, "N s is not exact");
        assert_eq!(
            LinearWrap::new(true, CoordBounds { least: 0.0, limit: 1.0 }, 4.0, 4.0),
            Some(LinearWrap::InRange(3))
        );
        assert_eq!(
            LinearWrap::new(true, CoordBounds { least: 0.0, limit: 1.5 }, 4.0, 4.0),
            Some(LinearWrap::Repeat(3))
        );
        assert_eq!(LinearWrap::new(false, CoordBounds { least: 0.0, limit: 1.5 }, 4.0, 4.0), Some(LinearWrap::Clamp));
        assert_eq!(
            LinearWrap::new(false, CoordBounds { least: 0.0, limit: 0.5 }, 1.0, 4.0),
            Some(LinearWrap::Clamp),
            "rectangles"
        );
    }
}
