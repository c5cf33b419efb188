//! The last arguments of a parameter command (`TexParameter`, `TexEnv`, `TexGen`, `Light`, `Material`, `Fog`, ...) in one
//! shape for its forms `f`, `i`, `fv`, `iv`, `d` and `dv` (OpenGL 1.5, section 2.3). The engine asks for what the
//! parameter needs: an enumerant, a number, or colour components, which integer forms give as table 2.6 maps them.

use crate::enums::GLenum;
use crate::error::{GlError, Outcome, invalid_enum};

/// One to four numbers and which form of the command they came through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Params {
    bits: [u32; 4],
    integers: bool,
    scalar: bool,
}

impl Params {
    /// From the form `f`.
    #[must_use]
    pub(crate) fn float(value: f32) -> Self {
        Self { bits: [value.to_bits(), 0, 0, 0], integers: false, scalar: true }
    }

    /// From the form `i`.
    #[must_use]
    pub(crate) fn int(value: i32) -> Self {
        Self { bits: [value as u32, 0, 0, 0], integers: true, scalar: true }
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
        let mut all = [0; 4];
        for (to, from) in all.iter_mut().zip(values) {
            *to = bits(*from);
        }
        Self { bits: all, integers, scalar: false }
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

    /// The first value as an enumerant (a float that holds one counts too).
    #[must_use]
    pub(crate) fn enumerant(&self) -> GLenum {
        if self.integers { self.bits[0] } else { f32::from_bits(self.bits[0]) as i64 as u32 }
    }

    /// The value `i` as a number.
    #[must_use]
    pub(crate) fn number(&self, i: usize) -> f32 {
        let bits = self.bits[i & 3];
        if self.integers { bits as i32 as f32 } else { f32::from_bits(bits) }
    }

    /// The first value as a number.
    #[must_use]
    pub(crate) fn scalar(&self) -> f32 {
        self.number(0)
    }

    /// The four values as numbers: a position, a plane.
    #[must_use]
    pub(crate) fn vector4(&self) -> [f32; 4] {
        std::array::from_fn(|i| self.number(i))
    }

    /// The value `i` as an integer; floats are rounded to the nearest.
    #[must_use]
    pub(crate) fn integer(&self, i: usize) -> i32 {
        let bits = self.bits[i & 3];
        if self.integers { bits as i32 } else { super::values::round_to_int(f64::from(f32::from_bits(bits))) }
    }

    /// The first value as a boolean.
    #[must_use]
    pub(crate) fn boolean(&self) -> bool {
        self.number(0) != 0.0
    }

    /// The value `i` as a colour component: integers are mapped to [-1, 1], floats are taken as they are.
    #[must_use]
    pub(crate) fn component(&self, i: usize) -> f32 {
        let bits = self.bits[i & 3];
        if self.integers { super::convert::Component::unit(bits as i32) } else { f32::from_bits(bits) }
    }

    /// The four values as a colour.
    #[must_use]
    pub(crate) fn color(&self) -> [f32; 4] {
        std::array::from_fn(|i| self.component(i))
    }
}
