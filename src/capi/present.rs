//! The picture in the program's memory: what Flush and Finish show behind OSMesa. RGBA bytes are drawn in place; every
//! other format is converted here, row by row, under the row length and the direction of rows that the program chose.

use super::current;
use super::osmesa::{Layout, OsMesa, Target};
use crate::enums::*;
use crate::num::f32_to_u8;

/// Shows the picture of the current context.
pub(super) fn present() {
    current::with_handle(OsMesa::present);
}

/// Shows the picture of the current context if something has been drawn since it was shown last: the memory of a picture
/// that is finished is the program's, which may have freed it.
pub(super) fn present_the_rest() {
    current::with_handle(|os| {
        if os.context.engine.unseen {
            os.present();
        }
    });
}

/// Offsets of R, G, B, A in a pixel of a format and how many components it has; `None` for other formats.
pub(super) fn components(format: GLenum) -> Option<([usize; 4], usize)> {
    match format {
        GL_RGBA => Some(([0, 1, 2, 3], 4)),
        super::osmesa::BGRA => Some(([2, 1, 0, 3], 4)),
        super::osmesa::ARGB => Some(([1, 2, 3, 0], 4)),
        GL_RGB => Some(([0, 1, 2, 3], 3)),
        super::osmesa::BGR => Some(([2, 1, 0, 3], 3)),
        _ => None,
    }
}

/// Writes one component of a type in the native byte order.
fn put(out: &mut [u8], type_: GLenum, value: f32) {
    match type_ {
        GL_FLOAT => out.copy_from_slice(&value.to_ne_bytes()),
        GL_UNSIGNED_SHORT => {
            out.copy_from_slice(&((value.clamp(0.0, 1.0) * 65535.0 + 0.5) as u16).to_ne_bytes());
        }
        _ => out.fill(f32_to_u8(value)),
    }
}

/// Bytes of one component.
fn component_bytes(type_: GLenum) -> usize {
    match type_ {
        GL_FLOAT => 4,
        GL_UNSIGNED_SHORT => 2,
        _ => 1,
    }
}

/// Bytes of a pixel of a target, if the format and the type go together.
pub(super) fn pixel_bytes(format: GLenum, type_: GLenum) -> Option<usize> {
    match (format, type_) {
        (super::osmesa::RGB_565, GL_UNSIGNED_SHORT_5_6_5) => Some(2),
        (_, GL_UNSIGNED_BYTE | GL_UNSIGNED_SHORT | GL_FLOAT) => {
            components(format).map(|(_, n)| n * component_bytes(type_))
        }
        _ => None,
    }
}

/// Converts one row of colours.
fn row(colors: &[[f32; 4]], format: GLenum, type_: GLenum, pixel_bytes: usize, out: &mut [u8]) {
    let Some((offsets, n)) = components(format) else {
        let level = |v: f32, max: f32| (v.clamp(0.0, 1.0) * max + 0.5) as u16;
        for (c, out) in colors.iter().zip(out.chunks_exact_mut(pixel_bytes)) {
            let packed = level(c[0], 31.0) << 11 | level(c[1], 63.0) << 5 | level(c[2], 31.0);
            out.copy_from_slice(&packed.to_ne_bytes());
        }
        return;
    };
    let size = component_bytes(type_);
    for (c, out) in colors.iter().zip(out.chunks_exact_mut(pixel_bytes)) {
        for (value, offset) in c.iter().zip(offsets).filter(|(_, offset)| *offset < n) {
            if let Some(out) = out.get_mut(offset * size..(offset + 1) * size) {
                put(out, type_, *value);
            }
        }
    }
}

impl OsMesa {
    /// Finishes what was drawn and, unless it was drawn in place, converts it into the program's memory.
    pub(super) fn present(&mut self) {
        self.context.engine.flush_scene();
        self.context.engine.unseen = false;
        let (Some(target), Layout { row_length, y_up }) = (&self.target, self.layout) else { return };
        let Target { address, type_, width, height, in_place } = *target;
        let Some(bytes) = pixel_bytes(self.format, type_).filter(|_| !in_place) else { return };
        let stride = if row_length == 0 { width } else { row_length } as usize * bytes;
        let mut colors = vec![[0.0; 4]; width as usize];
        for y in 0..height {
            let at = if y_up { y } else { height - 1 - y };
            self.context.engine.framebuffer.read_float(0, y.cast_signed(), &mut colors);
            // SAFETY: OSMesaMakeCurrent asks for memory of so many rows that is the context's while it is current.
            let out = unsafe {
                std::slice::from_raw_parts_mut(address.wrapping_add(at as usize * stride), width as usize * bytes)
            };
            row(&colors, self.format, type_, bytes, out);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_format_puts_its_bytes_in_order() {
        let color = [[1.0, 0.0, 0.2, 0.4]];
        let bytes = |format, type_| {
            let n = pixel_bytes(format, type_).unwrap();
            let mut out = vec![0; n];
            row(&color, format, type_, n, &mut out);
            out
        };
        assert_eq!(bytes(GL_RGBA, GL_UNSIGNED_BYTE), [255, 0, 51, 102]);
        assert_eq!(bytes(super::super::osmesa::BGRA, GL_UNSIGNED_BYTE), [51, 0, 255, 102]);
        assert_eq!(bytes(super::super::osmesa::ARGB, GL_UNSIGNED_BYTE), [102, 255, 0, 51]);
        assert_eq!(bytes(GL_RGB, GL_UNSIGNED_BYTE), [255, 0, 51]);
        assert_eq!(bytes(super::super::osmesa::BGR, GL_UNSIGNED_BYTE), [51, 0, 255]);
        assert_eq!(bytes(super::super::osmesa::RGB_565, GL_UNSIGNED_SHORT_5_6_5), (0xF806_u16).to_ne_bytes());
        assert_eq!(bytes(GL_RGB, GL_UNSIGNED_SHORT)[0..2], u16::MAX.to_ne_bytes());
        assert_eq!(bytes(GL_RGBA, GL_FLOAT)[8..12], 0.2_f32.to_ne_bytes());
        assert_eq!(pixel_bytes(GL_RGBA, GL_INT), None);
    }
}
