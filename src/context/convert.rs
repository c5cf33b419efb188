//! Conversions of attribute values to the canonical float vectors (OpenGL 1.5, section 2.7 and table 2.6): positions and
//! coordinates take the defaults 0, 0, 1 for what a form leaves out; integer colours and normals are fractions of their
//! type's range, so that a program may give 8-bit colours and normals in any integer type.

use crate::enums::{GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_S_TO_S, GLenum};

/// A number of a coordinate: it keeps its value.
pub(crate) trait Coordinate: Copy {
    /// The value as a float.
    fn float(self) -> f32;
}

/// A component of a colour or a normal: integers are fractions of their type's range.
pub(crate) trait Component: Copy {
    /// The component in [0, 1] (unsigned), [-1, 1] (signed) or as it is (floats).
    fn unit(self) -> f32;
}

macro_rules! numbers {
    ($($t:ty: $v:ident => $unit:expr;)*) => {
        $(
            impl Coordinate for $t { #[inline] fn float(self) -> f32 { self as f32 } }
            impl Component for $t { #[inline] fn unit(self) -> f32 { let $v = self; $unit } }
        )*
    };
}
numbers! {
    f32: v => v;
    f64: v => v as f32;
    u8: v => f32::from(v) / 255.0;
    u16: v => f32::from(v) / 65535.0;
    u32: v => (f64::from(v) / 4_294_967_295.0) as f32;
    i8: v => (2.0 * f32::from(v) + 1.0) / 255.0;
    i16: v => (2.0 * f32::from(v) + 1.0) / 65535.0;
    i32: v => ((2.0 * f64::from(v) + 1.0) / 4_294_967_295.0) as f32;
}

/// Any number of coordinates with the defaults (0, 0, 0, 1) for the rest.
#[inline]
pub(crate) fn point<T: Coordinate, const N: usize>(v: [T; N]) -> [f32; 4] {
    let mut all = [0.0, 0.0, 0.0, 1.0];
    for (to, from) in all.iter_mut().zip(v) {
        *to = from.float();
    }
    all
}

/// Two or three window coordinates with the default z = 0.
#[inline]
pub(crate) fn window<T: Coordinate, const N: usize>(v: [T; N]) -> [f32; 3] {
    let [x, y, z, _] = point(v);
    [x, y, z]
}

/// Three or four colour components with the default alpha = 1.
#[inline]
pub(crate) fn color<T: Component, const N: usize>(v: [T; N]) -> [f32; 4] {
    let mut all = [0.0, 0.0, 0.0, 1.0];
    for (to, from) in all.iter_mut().zip(v) {
        *to = from.unit();
    }
    all
}

/// The three components of a normal.
#[inline]
pub(crate) fn normal<T: Component>(v: [T; 3]) -> [f32; 3] {
    v.map(Component::unit)
}

/// One number.
#[inline]
pub(crate) fn number(v: impl Coordinate) -> f32 {
    v.float()
}

/// Two opposite corners of a rectangle in one vector.
#[inline]
pub(crate) fn corners<T: Coordinate>([x1, y1]: [T; 2], [x2, y2]: [T; 2]) -> [f32; 4] {
    [x1.float(), y1.float(), x2.float(), y2.float()]
}

/// A matrix of floats or doubles, column by column as GL stores it.
pub(crate) fn matrix<T: Copy + Into<f64>>(m: &[T; 16]) -> [f64; 16] {
    m.map(Into::into)
}

/// A matrix that is stored row by row.
pub(crate) fn transposed<T: Copy + Into<f64>>(m: &[T; 16]) -> [f64; 16] {
    let m = matrix(m);
    std::array::from_fn(|i| m[(i % 4) * 4 + i / 4])
}

/// Floats as doubles.
pub(crate) fn doubles(v: &[f32]) -> Vec<f64> {
    v.iter().map(|x| f64::from(*x)).collect()
}

/// The entries of a pixel map in an integer form: maps to indices hold numbers, maps to colours hold fractions.
pub(crate) fn map_of<T: Coordinate + Component>(map: GLenum, values: &[T]) -> Vec<f32> {
    let to_index = matches!(map, GL_PIXEL_MAP_I_TO_I | GL_PIXEL_MAP_S_TO_S);
    values.iter().map(|v| if to_index { v.float() } else { v.unit() }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_2_6_reaches_both_ends_of_every_range() {
        assert_eq!(color([255_u8, 0, 51]), [1.0, 0.0, 0.2, 1.0]);
        assert_eq!(color([i8::MAX, i8::MIN, 0]), [1.0, -1.0, 1.0 / 255.0, 1.0]);
        assert_eq!(color([u32::MAX, 0, 0, u32::MAX]), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(normal([i32::MAX, i32::MIN, i32::MAX]), [1.0, -1.0, 1.0]);
        assert_eq!(normal([i16::MAX, i16::MIN, i16::MAX]), [1.0, -1.0, 1.0]);
        assert_eq!(color([u16::MAX, 0, 0]), [1.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn a_form_with_fewer_coordinates_takes_the_defaults() {
        assert_eq!(point([1_i16]), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(point([1.0_f64, 2.0, 3.0]), [1.0, 2.0, 3.0, 1.0]);
        assert_eq!(window([5_i32, 6]), [5.0, 6.0, 0.0]);
    }
}
