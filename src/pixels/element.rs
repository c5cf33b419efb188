//! One number of client memory (OpenGL 1.5, tables 2.9, 4.6 and 4.7). An unsigned number of n bits stands for c/(2^n - 1),
//! a signed one for (2c + 1)/(2^n - 1), a float for itself; numbers of 32 bits go through f64 so that nothing is lost
//! before the one rounding to f32 (`num` has the conversions). The way back rounds to the nearest number. Memory is in the order of the machine's
//! bytes, reversed on request.

use crate::num;

/// A type whose elements hold one component.
pub trait Element: Copy {
    /// Bytes of an element.
    const BYTES: usize;
    /// Takes an element out of memory; 0 if there are too few bytes.
    fn read(bytes: &[u8], swap: bool) -> Self;
    /// Puts an element into memory; nothing if there is too little room.
    fn write(self, bytes: &mut [u8], swap: bool);
    /// The component that it stands for: [0, 1] or [-1, 1] for integers.
    fn to_component(self) -> f32;
    /// The element that stands for a component, which is clamped to [0, 1] already.
    fn from_component(component: f32) -> Self;
    /// The index that it holds, fraction included.
    fn to_index(self) -> f64;
    /// The element that holds an index, cut to the bits of table 4.6.
    fn from_index(index: u32) -> Self;
}

macro_rules! element {
    ($type:ty, $to_component:expr, $from_component:expr, $to_index:expr, $from_index:expr) => {
        impl Element for $type {
            const BYTES: usize = size_of::<$type>();
            #[inline]
            fn read(bytes: &[u8], swap: bool) -> Self {
                let mut bytes: [u8; size_of::<$type>()] = bytes.try_into().unwrap_or_default();
                if swap {
                    bytes.reverse();
                }
                <$type>::from_ne_bytes(bytes)
            }
            #[inline]
            fn write(self, out: &mut [u8], swap: bool) {
                let mut bytes = self.to_ne_bytes();
                if swap {
                    bytes.reverse();
                }
                if let Ok(out) = <&mut [u8; size_of::<$type>()]>::try_from(out) {
                    *out = bytes;
                }
            }
            #[inline]
            fn to_component(self) -> f32 {
                $to_component(self)
            }
            #[inline]
            fn from_component(component: f32) -> Self {
                $from_component(component)
            }
            #[inline]
            fn to_index(self) -> f64 {
                $to_index(self)
            }
            #[inline]
            fn from_index(index: u32) -> Self {
                $from_index(index)
            }
        }
    };
}

element!(u8, num::u8_to_f32, num::f32_to_u8, f64::from, |i: u32| i as u8);
element!(i8, num::i8_to_f32, |f| num::f32_to_snorm(f, 8) as i8, f64::from, |i: u32| (i & 0x7F) as i8);
element!(u16, num::u16_to_f32, num::f32_to_u16, f64::from, |i: u32| i as u16);
element!(i16, num::i16_to_f32, |f| num::f32_to_snorm(f, 16) as i16, f64::from, |i: u32| (i & 0x7FFF) as i16);
element!(u32, |c| num::unorm_to_f32(c, 32), |f| num::f32_to_unorm(f, 32), f64::from, |i: u32| i);
element!(i32, |c| num::snorm_to_f32(c, 32), |f| num::f32_to_snorm(f, 32), f64::from, |i: u32| (i & 0x7FFF_FFFF) as i32);
element!(f32, |c| c, |f| f, f64::from, |i: u32| i as f32);

/// A colour as packed bytes R, G, B, A from low to high, each component clamped and rounded to nearest.
#[inline]
#[must_use]
pub fn to_rgba8(color: [f32; 4]) -> u32 {
    u32::from_le_bytes(color.map(num::f32_to_u8))
}

/// A packed colour as floats.
#[inline]
#[must_use]
pub fn from_rgba8(texel: u32) -> [f32; 4] {
    texel.to_le_bytes().map(num::u8_to_f32)
}

/// A component in [0, 1] rounded to what `bits` bits can hold; 0 bits leave it as it is.
#[inline]
#[must_use]
pub fn quantise(v: f32, bits: u8) -> f32 {
    if bits == 0 { v } else { num::unorm_to_f32(num::f32_to_unorm(v, bits.into()), bits.into()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_and_short_comes_back() {
        for c in 0..=u8::MAX {
            assert_eq!(u8::from_component(c.to_component()), c);
            assert_eq!(f64::from(c.to_component()), f64::from((f64::from(c) / 255.0) as f32));
        }
        for c in 0..=u16::MAX {
            assert_eq!(u16::from_component(c.to_component()), c);
        }
        for c in 0..=i8::MAX {
            assert_eq!(i8::from_component(c.to_component()), c);
        }
        for c in 0..=i16::MAX {
            assert_eq!(i16::from_component(c.to_component()), c);
        }
    }

    #[test]
    fn the_ends_are_exact() {
        assert_eq!((u32::MAX.to_component(), 0u32.to_component()), (1.0, 0.0));
        assert_eq!((u32::from_component(1.0), u32::from_component(0.0)), (u32::MAX, 0));
        assert_eq!((i32::MAX.to_component(), i32::MIN.to_component()), (1.0, -1.0));
        assert_eq!((i8::MAX.to_component(), i8::MIN.to_component()), (1.0, -1.0));
        assert_eq!(
            (i32::from_component(1.0), i16::from_component(1.0), i8::from_component(1.0)),
            (i32::MAX, 32767, 127)
        );
        assert_eq!((i32::from_component(0.0), i16::from_component(0.0), i8::from_component(0.0)), (0, 0, 0));
        assert_eq!(0i8.to_component(), 1.0 / 255.0);
        assert_eq!((-1i8).to_component(), -1.0 / 255.0);
    }

    #[test]
    fn depths_of_24_bits_survive_an_unsigned_int() {
        for d in (0..1u32 << 24).step_by(257).chain([(1 << 24) - 1, (1 << 24) - 2]) {
            let depth = (f64::from(d) / 16_777_215.0) as f32;
            let back = u32::from_component(depth).to_component();
            assert_eq!((f64::from(back) * 16_777_215.0 + 0.5) as u32, d);
        }
    }

    #[test]
    fn bytes_are_swapped_on_request() {
        assert_eq!(u16::read(&0x1234u16.to_ne_bytes(), true), 0x3412);
        let mut out = [0; 4];
        1.0f32.write(&mut out, true);
        assert_eq!(f32::read(&out, true), 1.0);
        assert_ne!(f32::read(&out, false), 1.0);
    }

    #[test]
    fn bad_floats_clamp() {
        assert_eq!(to_rgba8([f32::NAN, f32::INFINITY, -1.0, 0.5]), u32::from_le_bytes([0, 255, 0, 128]));
        assert_eq!(quantise(0.5, 2), 2.0 / 3.0);
        assert_eq!(quantise(1.0, 12), 1.0);
        assert_eq!(quantise(0.3, 0), 0.3);
    }
}
