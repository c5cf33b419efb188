//! The eight comparison functions of the alpha, stencil and depth tests (OpenGL 1.5, sections 4.1.4 to 4.1.6), over the
//! lanes of a batch.

pub use crate::state::compare::CompareFunc;

/// All ones or 0.
#[inline(always)]
pub fn ones(yes: bool) -> u32 {
    u32::from(yes).wrapping_neg()
}

impl CompareFunc {
    /// The function that a stage's number stands for.
    #[inline(always)]
    #[must_use]
    pub fn from_arg(arg: u32) -> Self {
        Self::ALL[(arg & 7) as usize]
    }
}

/// Kills the lanes where `a func b` does not hold.
#[inline(always)]
pub(super) fn compare<T: Copy + PartialOrd, const N: usize>(
    func: CompareFunc,
    a: &[T; N],
    b: &[T; N],
    mask: &mut [u32; N],
) {
    #[inline(always)]
    fn each<T: Copy, const N: usize>(a: &[T; N], b: &[T; N], mask: &mut [u32; N], test: impl Fn(T, T) -> bool) {
        for i in 0..N {
            mask[i] &= ones(test(a[i], b[i]));
        }
    }
    match func {
        CompareFunc::Never => *mask = [0; N],
        CompareFunc::Less => each(a, b, mask, |a, b| a < b),
        CompareFunc::Equal => each(a, b, mask, |a, b| a == b),
        CompareFunc::Lequal => each(a, b, mask, |a, b| a <= b),
        CompareFunc::Greater => each(b, a, mask, |a, b| a < b),
        CompareFunc::Notequal => each(a, b, mask, |a, b| a != b),
        CompareFunc::Gequal => each(b, a, mask, |a, b| a <= b),
        CompareFunc::Always => {}
    }
}

/// Whether `a func b` holds in all lanes: cheaper to find out than in which ones, and so it is as a rule.
#[inline(always)]
pub(super) fn holds<T: Copy + PartialOrd, const N: usize>(func: CompareFunc, a: &[T; N], b: &[T; N]) -> bool {
    #[inline(always)]
    fn each<T: Copy, const N: usize>(a: &[T; N], b: &[T; N], test: impl Fn(T, T) -> bool) -> bool {
        let mut all = true;
        for i in 0..N {
            all &= test(a[i], b[i]);
        }
        all
    }
    match func {
        CompareFunc::Never => false,
        CompareFunc::Less => each(a, b, |a, b| a < b),
        CompareFunc::Equal => each(a, b, |a, b| a == b),
        CompareFunc::Lequal => each(a, b, |a, b| a <= b),
        CompareFunc::Greater => each(b, a, |a, b| a < b),
        CompareFunc::Notequal => each(a, b, |a, b| a != b),
        CompareFunc::Gequal => each(b, a, |a, b| a <= b),
        CompareFunc::Always => true,
    }
}

/// How many lanes are alive. Any other question about a mask is answered by this one: two reductions of different
/// kinds over one mask (one of `|`, one of `&`) are compiled lane by lane.
#[inline(always)]
pub(super) fn living<const N: usize>(mask: &[u32; N]) -> u32 {
    let mut n = 0u32;
    for m in mask {
        n = n.wrapping_sub(*m);
    }
    n
}

/// A bit for each lane that is alive, the lowest for the first one.
#[inline(always)]
pub(super) fn digits<const N: usize>(mask: &[u32; N]) -> u32 {
    let mut bits = 0;
    for i in 0..N {
        bits |= mask[i] & (1 << i);
    }
    bits
}

/// Whether any lane is alive.
#[inline(always)]
pub(super) fn any<const N: usize>(mask: &[u32; N]) -> bool {
    living(mask) != 0
}

/// Whether all lanes are alive.
#[inline(always)]
pub(super) fn all<const N: usize>(mask: &[u32; N]) -> bool {
    living(mask) == N as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::LANES;

    #[test]
    fn the_functions_do_what_their_names_say() {
        let a: [u32; LANES] = std::array::from_fn(|i| i as u32 % 3);
        let b: [u32; LANES] = std::array::from_fn(|i| i as u32 / 3 % 3);
        let pass: [fn(u32, u32) -> bool; 8] = [
            |_, _| false,
            |a, b| a < b,
            |a, b| a == b,
            |a, b| a <= b,
            |a, b| a > b,
            |a, b| a != b,
            |a, b| a >= b,
            |_, _| true,
        ];
        for func in CompareFunc::ALL {
            let mut mask = [u32::MAX; LANES];
            compare(func, &a, &b, &mut mask);
            for i in 0..LANES {
                assert_eq!(mask[i] != 0, pass[func as usize](a[i], b[i]), "{func:?} {} {}", a[i], b[i]);
            }
            assert_eq!(holds(func, &a, &b), mask == [u32::MAX; LANES], "{func:?}");
            for (a, b) in [(1, 2), (2, 2), (2, 1)] {
                assert_eq!(holds(func, &[a; LANES], &[b; LANES]), pass[func as usize](a, b), "{func:?} {a} {b}");
            }
            assert_eq!(CompareFunc::from_arg(func as u32), func);
        }
    }
}
