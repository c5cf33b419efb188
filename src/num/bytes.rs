//! Slices of GL's scalars as the bytes that they are made of. Client memory is bytes to the pixel paths, numbers to the
//! program that owns it; this is the one place where the one becomes the other without a copy.

/// A scalar of client memory: any bits are a value, and no bits are left out.
pub trait Scalar: Copy + private::Sealed {}

mod private {
    /// Only this file says what is a scalar.
    pub trait Sealed {}
}

macro_rules! scalars { ($($t:ty)*) => { $(impl private::Sealed for $t {} impl Scalar for $t {})* }; }
scalars!(u8 i8 u16 i16 u32 i32 f32 f64 usize);

/// The bytes of a slice, in the processor's order.
#[inline]
#[must_use]
#[expect(unsafe_code, reason = "the standard library has no safe form of it yet")]
pub const fn as_bytes<T: Scalar>(values: &[T]) -> &[u8] {
    // SAFETY: the scalars above have no padding, bytes need no alignment, and the length is that of the slice.
    unsafe { std::slice::from_raw_parts(values.as_ptr().cast(), size_of_val(values)) }
}

/// The bytes of a slice, to be written.
#[inline]
#[must_use]
#[expect(unsafe_code, reason = "the standard library has no safe form of it yet")]
pub const fn as_bytes_mut<T: Scalar>(values: &mut [T]) -> &mut [u8] {
    // SAFETY: as above, and whatever is written is a value of every scalar above.
    unsafe { std::slice::from_raw_parts_mut(values.as_mut_ptr().cast(), size_of_val(values)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_those_of_the_numbers() {
        let numbers = [1.5f32, -0.0, f32::NAN];
        let expected: Vec<u8> = numbers.iter().flat_map(|n| n.to_ne_bytes()).collect();
        assert_eq!(as_bytes(&numbers), expected);
        assert_eq!(as_bytes::<f64>(&[]), [0u8; 0]);
        let mut numbers = [0u16; 3];
        as_bytes_mut(&mut numbers)[2..4].copy_from_slice(&0xABCDu16.to_ne_bytes());
        assert_eq!(numbers, [0, 0xABCD, 0]);
    }
}
