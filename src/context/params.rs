//! The last arguments of a parameter command (`TexParameter`, `TexEnv`, `TexGen`, `Light`, `Material`, `Fog`, ...) in one
//! shape for its forms `f`, `i`, `fv`, `iv`, `d` and `dv` (OpenGL 1.5, section 2.3). The engine asks for what the
//! parameter needs: an enumerant, a number, or colour components, which integer forms give as table 2.6 maps them.

use crate::enums::GLenum;
use crate::error::{GlError, Outcome, invalid_enum, too_short};

/// One to four numbers and which form of the command they came through. The program's memory may hold fewer than the
/// parameter needs; that is an error when they are asked for, after the enumerants have been checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Params {
    bits: [u32; 4],
    count: u8,
    integers: bool,
    scalar: bool,
}

impl Params {
    /// From the form `f`.
    #[must_use]
    pub(crate) fn float(value: f32) -> Self {
        Self { scalar: true, ..Self::floats(&[value]) }
    }

    /// From the form `i`.
    #[must_use]
    pub(crate) fn int(value: i32) -> Self {
        Self { scalar: true, ..Self::ints(&[value]) }
    }

    /// From the form `fv`; at most four values count.
    #[must_use]
    pub(crate) fn floats(values: &[f32]) -> Self {
        Self::vector(values, false, |v| v.to_bits())
    }

    /// From the form `iv`; at most four values count.
    #[must_use]
    pub(crate) fn ints(values: &[i32]) -> Self {
        Self::vector(values, true, |v| v as u32)
    }

    /// From the form `dv`; at most four values count.
    #[must_use]
    pub(crate) fn doubles(values: &[f64]) -> Self {
        Self::vector(values, false, |v| (v as f32).to_bits())
    }

    fn vector<T: Copy>(values: &[T], integers: bool, bits: impl Fn(T) -> u32) -> Self {
        let (mut all, mut count) = ([0; 4], 0);
        for (to, from) in all.iter_mut().zip(values) {
            *to = bits(*from);
            count += 1;
        }
        Self { bits: all, count, integers, scalar: false }
    }

    /// Whether the values are integers.
    #[must_use]
    pub(crate) fn is_int(&self) -> bool {
        self.integers
    }

    /// An error for the forms `f`, `i` and `d` of a parameter that takes several values.
    pub(crate) fn vector_only(&self, command: &str, pname: GLenum) -> Outcome {
        if self.scalar { Err(self.needs_vector(command, pname)) } else { Ok(()) }
    }

    fn needs_vector(&self, command: &str, pname: GLenum) -> GlError {
        let v = if self.integers { "iv" } else { "fv" };
        invalid_enum(format!("{} takes several values: use gl{command}{v}", crate::enums::name(pname)))
    }

    /// The first values as bits; INVALID_VALUE where there are fewer.
    fn bits<const N: usize>(&self) -> Outcome<[u32; N]> {
        let there = self.bits.get(..usize::from(self.count)).unwrap_or_default();
        there.first_chunk().copied().ok_or_else(|| too_short("params", N, there.len(), "values"))
    }

    /// The first values as numbers: a position, a plane.
    pub(crate) fn numbers<const N: usize>(&self) -> Outcome<[f32; N]> {
        Ok(self.bits()?.map(|bits| if self.integers { bits as i32 as f32 } else { f32::from_bits(bits) }))
    }

    /// The first value as a number.
    pub(crate) fn scalar(&self) -> Outcome<f32> {
        self.numbers().map(|[value]| value)
    }

    /// The first value as an enumerant (a float that holds one counts too).
    pub(crate) fn enumerant(&self) -> Outcome<GLenum> {
        let [bits] = self.bits()?;
        Ok(if self.integers { bits } else { f32::from_bits(bits) as i64 as u32 })
    }

    /// The first value as an integer; floats are rounded to the nearest.
    pub(crate) fn integer(&self) -> Outcome<i32> {
        let [bits] = self.bits()?;
        let rounded = || super::values::round_to_int(f64::from(f32::from_bits(bits)));
        Ok(if self.integers { bits as i32 } else { rounded() })
    }

    /// The first value as a boolean.
    pub(crate) fn boolean(&self) -> Outcome<bool> {
        Ok(self.scalar()? != 0.0)
    }

    /// The four values as a colour: integers are mapped to [-1, 1], floats are taken as they are.
    pub(crate) fn color(&self) -> Outcome<[f32; 4]> {
        let component = |bits: u32| super::convert::Component::unit(bits as i32);
        Ok(self.bits()?.map(|bits| if self.integers { component(bits) } else { f32::from_bits(bits) }))
    }
}
