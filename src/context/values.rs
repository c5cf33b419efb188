//! What a query yields before it takes the type of the asking command (OpenGL 1.5, section 6.1.2). The engine answers
//! every `Get` once, with the kind of the state variable; `GetBooleanv`, `GetIntegerv`, `GetFloatv`, `GetDoublev` and the
//! typed forms of the other queries convert it here, in one place.

use crate::enums::GLenum;

/// What kind of state a value is: it decides how it becomes an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A boolean.
    Boolean,
    /// An integer or an enumerant.
    Integer,
    /// A float that is rounded to the nearest integer.
    Float,
    /// A colour, a normal, a depth: [-1, 1] becomes the whole range of the integer type.
    Unit,
}

/// The values of one state variable.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Values {
    kind: Kind,
    numbers: Vec<f64>,
}

impl Values {
    /// Values of any kind.
    pub(crate) fn new(kind: Kind, numbers: impl IntoIterator<Item = f64>) -> Self {
        Self { kind, numbers: numbers.into_iter().collect() }
    }

    /// One boolean.
    pub(crate) fn boolean(value: bool) -> Self {
        Self::new(Kind::Boolean, [f64::from(u8::from(value))])
    }

    /// Several booleans.
    pub(crate) fn booleans(values: &[bool]) -> Self {
        Self::new(Kind::Boolean, values.iter().map(|v| f64::from(u8::from(*v))))
    }

    /// One integer.
    pub(crate) fn int(value: i32) -> Self {
        Self::new(Kind::Integer, [f64::from(value)])
    }

    /// Several integers.
    pub(crate) fn ints(values: &[i32]) -> Self {
        Self::new(Kind::Integer, values.iter().map(|v| f64::from(*v)))
    }

    /// One unsigned integer: a name, a mask.
    pub(crate) fn uint(value: u32) -> Self {
        Self::new(Kind::Integer, [f64::from(value)])
    }

    /// One enumerant.
    pub(crate) fn enumerant(value: GLenum) -> Self {
        Self::uint(value)
    }

    /// Several enumerants.
    pub(crate) fn enumerants(values: &[GLenum]) -> Self {
        Self::new(Kind::Integer, values.iter().map(|v| f64::from(*v)))
    }

    /// An address or an offset.
    pub(crate) fn address(value: usize) -> Self {
        Self::new(Kind::Integer, [value as f64])
    }

    /// One float.
    pub(crate) fn float(value: f32) -> Self {
        Self::new(Kind::Float, [f64::from(value)])
    }

    /// Several floats.
    pub(crate) fn floats(values: &[f32]) -> Self {
        Self::new(Kind::Float, values.iter().map(|v| f64::from(*v)))
    }

    /// Several doubles: a matrix, a clip plane.
    pub(crate) fn doubles(values: &[f64]) -> Self {
        Self::new(Kind::Float, values.iter().copied())
    }

    /// Colour components, a normal, depths.
    pub(crate) fn unit(values: &[f32]) -> Self {
        Self::new(Kind::Unit, values.iter().map(|v| f64::from(*v)))
    }

    /// Depths kept as doubles.
    pub(crate) fn unit_doubles(values: &[f64]) -> Self {
        Self::new(Kind::Unit, values.iter().copied())
    }

    /// How many values there are.
    pub(crate) fn len(&self) -> usize {
        self.numbers.len()
    }

    /// The values in the type of the asking command.
    pub(crate) fn converted<T: FromState>(&self) -> impl Iterator<Item = T> + '_ {
        self.numbers.iter().map(|v| T::from_state(self.kind, *v))
    }
}

/// A type in which a query gives its answer.
pub(crate) trait FromState: Copy {
    /// The value of a state variable of a kind in this type.
    fn from_state(kind: Kind, value: f64) -> Self;
}

/// The nearest integer, the ends of the range for what lies beyond them, 0 for a NaN.
#[must_use]
pub(crate) fn round_to_int(value: f64) -> i32 {
    (value + 0.5).floor() as i32
}

impl FromState for bool {
    fn from_state(_: Kind, value: f64) -> Self {
        value != 0.0
    }
}

impl FromState for u8 {
    fn from_state(_: Kind, value: f64) -> Self {
        u8::from(value != 0.0)
    }
}

impl FromState for i32 {
    fn from_state(kind: Kind, value: f64) -> Self {
        match kind {
            // Unsigned names and masks keep their bits: a mask of all ones is -1.
            Kind::Boolean | Kind::Integer => value as i64 as i32,
            Kind::Float => round_to_int(value),
            Kind::Unit => round_to_int((4_294_967_295.0 * value - 1.0) / 2.0),
        }
    }
}

impl FromState for u32 {
    fn from_state(kind: Kind, value: f64) -> Self {
        match kind {
            Kind::Boolean | Kind::Integer => value as i64 as u32,
            Kind::Float => (value + 0.5).floor() as u32,
            Kind::Unit => (4_294_967_295.0 * value + 0.5).floor() as u32,
        }
    }
}

impl FromState for u16 {
    fn from_state(kind: Kind, value: f64) -> Self {
        match kind {
            Kind::Boolean | Kind::Integer => value as i64 as u16,
            Kind::Float => (value + 0.5).floor() as u16,
            Kind::Unit => (65_535.0 * value + 0.5).floor() as u16,
        }
    }
}

impl FromState for usize {
    fn from_state(_: Kind, value: f64) -> Self {
        value as usize
    }
}

impl FromState for f32 {
    fn from_state(_: Kind, value: f64) -> Self {
        value as f32
    }
}

impl FromState for f64 {
    fn from_state(_: Kind, value: f64) -> Self {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ints(values: &Values) -> Vec<i32> {
        values.converted().collect()
    }

    #[test]
    fn colours_fill_the_range_of_integers_and_floats_are_rounded() {
        assert_eq!(ints(&Values::unit(&[1.0, -1.0, 0.0])), [i32::MAX, i32::MIN, 0]);
        assert_eq!(ints(&Values::floats(&[1.5, -1.4, 1e20])), [2, -1, i32::MAX]);
        assert_eq!(ints(&Values::uint(u32::MAX)), [-1]);
        assert_eq!(Values::float(0.25).converted::<bool>().collect::<Vec<_>>(), [true]);
        assert_eq!(ints(&Values::booleans(&[true, false])), [1, 0]);
    }
}
