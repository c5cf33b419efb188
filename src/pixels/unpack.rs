//! From client memory to rows of groups (OpenGL 1.5, section 3.6.4, figure 3.7): bytes become numbers, numbers become
//! components, missing components are 0 and a missing alpha is 1, a luminance is all three colours; then pixel transfer
//! and the final clamp. A caller asks for a row as floats, as packed 8-bit colours, as depths or as stencil indices.
//! Bytes that go to packed colours unchanged are copied.

use super::element::{Element, to_rgba8};
use super::format::{Format, Packing, PixelFormat, PixelKind, Type};
use super::layout::ClientLayout;
use super::transfer::Transfer;
use crate::enums::GL_UNSIGNED_INT_8_8_8_8;
use crate::error::Outcome;
use crate::num::{clamp01, unorm_to_f32};
use crate::simd::{Level, stage};
use crate::state::pixel::PixelStore;

/// How many groups are converted at a time.
const CHUNK: usize = 64;

/// An image in client memory, checked against the length of that memory.
#[derive(Clone, Copy, Debug)]
pub struct ClientImage<'a> {
    bytes: &'a [u8],
    layout: ClientLayout,
    pixel: PixelFormat,
    swap: bool,
    lsb_first: bool,
}

impl<'a> ClientImage<'a> {
    /// A 1D (height 1) or 2D image; skipped slices do not apply.
    pub fn new_2d(bytes: &'a [u8], store: &PixelStore, size: [i32; 2], pixel: PixelFormat) -> Outcome<ClientImage<'a>> {
        ClientImage::checked(bytes, store, ClientLayout::of_2d(store, size, pixel)?, pixel)
    }

    /// A 3D image.
    pub fn new_3d(bytes: &'a [u8], store: &PixelStore, size: [i32; 3], pixel: PixelFormat) -> Outcome<ClientImage<'a>> {
        ClientImage::checked(bytes, store, ClientLayout::of_3d(store, size, pixel)?, pixel)
    }

    fn checked(
        bytes: &'a [u8],
        store: &PixelStore,
        layout: ClientLayout,
        pixel: PixelFormat,
    ) -> Outcome<ClientImage<'a>> {
        layout.check_len(bytes.len())?;
        Ok(ClientImage { bytes, layout, pixel, swap: store.swap_bytes, lsb_first: store.lsb_first })
    }

    /// Width, height and depth.
    #[must_use]
    pub fn size(&self) -> [usize; 3] {
        [self.layout.width, self.layout.height, self.layout.depth]
    }

    /// Its format and type.
    #[must_use]
    pub fn pixel(&self) -> PixelFormat {
        self.pixel
    }

    /// The bytes from group `x` of row `y` on, to the end of the row; empty outside the image. Not for bitmaps.
    fn groups(&self, [x, y, z]: [usize; 3]) -> &'a [u8] {
        let g = &self.layout;
        if x >= g.width || y >= g.height || z >= g.depth {
            return &[];
        }
        let start = g.row_start(y, z);
        self.bytes.get(start + x * self.pixel.group_bytes()..start + g.row_bytes).unwrap_or(&[])
    }

    /// The bit of group (x, y, z) of a bitmap; false outside.
    #[must_use]
    pub fn bit(&self, [x, y, z]: [usize; 3]) -> bool {
        let g = &self.layout;
        if x >= g.width || y >= g.height || z >= g.depth {
            return false;
        }
        let at = g.first_bit + x;
        let byte = self.bytes.get(g.row_start(y, z) + at / 8).copied().unwrap_or(0);
        let bit = if self.lsb_first { at % 8 } else { 7 - at % 8 };
        byte >> bit & 1 != 0
    }

    /// Eight bits of a bitmap from group `at` on, the first in the lowest bit; 0 outside.
    #[must_use]
    pub fn eight_bits(&self, [x, y, z]: [usize; 3]) -> u8 {
        let g = &self.layout;
        if x >= g.width || y >= g.height || z >= g.depth {
            return 0;
        }
        let at = g.first_bit + x;
        let byte = |i: usize| {
            let byte = self.bytes.get(g.row_start(y, z) + at / 8 + i).copied().unwrap_or(0);
            u16::from(if self.lsb_first { byte } else { byte.reverse_bits() })
        };
        let bits = (byte(0) | byte(1) << 8) >> (at % 8);
        let inside = if g.width - x < 8 { (1 << (g.width - x)) - 1 } else { 0xFF };
        (bits & inside) as u8
    }

    /// The indices from group `at` on, as they stand in memory (before transfer).
    pub fn raw_indices(&self, at: [usize; 3], out: &mut [f64]) {
        let (groups, swap) = (self.groups(at), self.swap);
        match self.pixel.type_ {
            Type::Bitmap => {
                for (i, index) in out.iter_mut().enumerate() {
                    *index = f64::from(u8::from(self.bit([at[0] + i, at[1], at[2]])));
                }
            }
            Type::UnsignedByte => indices::<u8>(groups, swap, out),
            Type::Byte => indices::<i8>(groups, swap, out),
            Type::UnsignedShort => indices::<u16>(groups, swap, out),
            Type::Short => indices::<i16>(groups, swap, out),
            Type::UnsignedInt => indices::<u32>(groups, swap, out),
            Type::Int => indices::<i32>(groups, swap, out),
            Type::Float => indices::<f32>(groups, swap, out),
            Type::UnsignedInt248 => {
                indices::<u32>(groups, swap, out);
                out.iter_mut().for_each(|v| *v = f64::from(*v as u32 & 0xFF));
            }
            Type::Packed(_) => out.fill(0.0),
        }
    }

    /// The stencil indices from group `at` on, after transfer, cut to 8 bits.
    pub fn stencils8(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [u8]) {
        let mut raw = [0.0; CHUNK];
        for (n, part) in out.chunks_mut(CHUNK).enumerate() {
            let raw = &mut raw[..part.len()];
            self.raw_indices([at[0] + n * CHUNK, at[1], at[2]], raw);
            for (to, &from) in part.iter_mut().zip(&*raw) {
                *to = transfer.stencil(from) as u8;
            }
        }
    }

    /// The stencil indices from group `at` on, after transfer; the caller cuts them to the bits of its buffer.
    pub fn stencils(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [u32]) {
        let mut raw = [0.0; CHUNK];
        for (n, part) in out.chunks_mut(CHUNK).enumerate() {
            let raw = &mut raw[..part.len()];
            self.raw_indices([at[0] + n * CHUNK, at[1], at[2]], raw);
            for (to, &from) in part.iter_mut().zip(&*raw) {
                *to = transfer.stencil(from);
            }
        }
    }

    /// The depths from group `at` on, after transfer, in [0, 1].
    pub fn depths(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [f32]) {
        let (groups, swap) = (self.groups(at), self.swap);
        match self.pixel.type_ {
            Type::UnsignedByte => components::<u8>(groups, swap, out),
            Type::Byte => components::<i8>(groups, swap, out),
            Type::UnsignedShort => components::<u16>(groups, swap, out),
            Type::Short => components::<i16>(groups, swap, out),
            Type::UnsignedInt => components::<u32>(groups, swap, out),
            Type::Int => components::<i32>(groups, swap, out),
            Type::Float => components::<f32>(groups, swap, out),
            Type::UnsignedInt248 => {
                for (to, from) in out.iter_mut().zip(groups.chunks_exact(4)) {
                    *to = unorm_to_f32(u32::read(from, swap) >> 8, 24);
                }
            }
            Type::Bitmap | Type::Packed(_) => out.fill(0.0),
        }
        transfer.depths(out);
    }

    /// The colours from group `at` on, after transfer, in [0, 1]. Colour indices become colours through the maps.
    pub fn colors(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [[f32; 4]]) {
        if self.pixel.kind() == PixelKind::Index {
            let mut raw = [0.0; CHUNK];
            for (n, part) in out.chunks_mut(CHUNK).enumerate() {
                let raw = &mut raw[..part.len()];
                self.raw_indices([at[0] + n * CHUNK, at[1], at[2]], raw);
                for (to, &from) in part.iter_mut().zip(&*raw) {
                    *to = transfer.index_color(from);
                }
            }
        } else {
            self.components(at, out);
            transfer.colors(out);
        }
        out.iter_mut().for_each(|color| *color = color.map(clamp01));
    }

    /// The components of colour groups before transfer, expanded to R, G, B, A.
    pub fn components(&self, at: [usize; 3], out: &mut [[f32; 4]]) {
        let (groups, swap, channels) = (self.groups(at), self.swap, self.pixel.format.channels());
        out.fill([0.0, 0.0, 0.0, 1.0]);
        match self.pixel.type_ {
            Type::UnsignedByte => scatter::<u8>(groups, swap, channels, out),
            Type::Byte => scatter::<i8>(groups, swap, channels, out),
            Type::UnsignedShort => scatter::<u16>(groups, swap, channels, out),
            Type::Short => scatter::<i16>(groups, swap, channels, out),
            Type::UnsignedInt => scatter::<u32>(groups, swap, channels, out),
            Type::Int => scatter::<i32>(groups, swap, channels, out),
            Type::Float => scatter::<f32>(groups, swap, channels, out),
            Type::Packed(packing) => unpack_packed(groups, swap, packing, channels, out),
            Type::Bitmap | Type::UnsignedInt248 => {}
        }
        if self.pixel.format.is_luminance() {
            out.iter_mut().for_each(|c| *c = [c[0], c[0], c[0], c[3]]);
        }
    }

    /// The colours from group `at` on as packed bytes R, G, B, A.
    pub fn colors_rgba8(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [u32]) {
        if transfer.keeps_colors() && self.copy_rgba8(at, out) {
            return;
        }
        let mut colors = [[0.0; 4]; CHUNK];
        for (n, part) in out.chunks_mut(CHUNK).enumerate() {
            let colors = &mut colors[..part.len()];
            self.colors([at[0] + n * CHUNK, at[1], at[2]], transfer, colors);
            for (to, &from) in part.iter_mut().zip(&*colors) {
                *to = to_rgba8(from);
            }
        }
    }

    /// Whether [`ClientImage::colors_rgba8`] gives the same colours as [`ClientImage::colors`]: components of 8 bits that
    /// pixel transfer leaves as they are.
    #[must_use]
    pub fn is_rgba8(&self, transfer: Transfer<'_>) -> bool {
        let bytes = match self.pixel.type_ {
            Type::UnsignedByte => self.pixel.kind() == PixelKind::Color,
            Type::Packed(packing) => packing.bits == [8; 4],
            _ => false,
        };
        bytes && transfer.keeps_colors()
    }

    /// [`ClientImage::colors_rgba8`], and the bits that are set in all of them.
    #[must_use]
    pub fn common_rgba8(&self, at: [usize; 3], transfer: Transfer<'_>, out: &mut [u32]) -> u32 {
        let same = (self.pixel.type_, self.pixel.format) == (Type::UnsignedByte, Format::Rgba);
        if same && transfer.keeps_colors() {
            let mut common = u32::MAX;
            #[expect(unsafe_code, reason = "the level is the one that the processor has")]
            unsafe {
                (COPY.at(Level::detect()))(self.groups(at), out, &mut common);
            }
            return common;
        }
        self.colors_rgba8(at, transfer, out);
        out.iter().fold(u32::MAX, |common, texel| common & texel)
    }

    /// The fast path for components of 8 bits: bytes are moved, never computed with. False if the type is another.
    fn copy_rgba8(&self, at: [usize; 3], out: &mut [u32]) -> bool {
        let groups = self.groups(at);
        let opaque = 0xFF00_0000;
        match (self.pixel.type_, self.pixel.format) {
            (Type::UnsignedByte, Format::Rgba) => each(groups, out, u32::from_le_bytes),
            (Type::UnsignedByte, Format::Bgra) => each(groups, out, |[b, g, r, a]| u32::from_le_bytes([r, g, b, a])),
            (Type::UnsignedByte, Format::Abgr) => each(groups, out, u32::from_be_bytes),
            (Type::UnsignedByte, Format::Rgb) => each(groups, out, |[r, g, b]| u32::from_le_bytes([r, g, b, 255])),
            (Type::UnsignedByte, Format::Bgr) => each(groups, out, |[b, g, r]| u32::from_le_bytes([r, g, b, 255])),
            (Type::UnsignedByte, Format::Luminance) => each(groups, out, |[l]| gray(l) | opaque),
            (Type::UnsignedByte, Format::LuminanceAlpha) => {
                each(groups, out, |[l, a]| gray(l) | (u32::from(a) << 24));
            }
            (Type::UnsignedByte, Format::Alpha) => each(groups, out, |[a]| u32::from(a) << 24),
            (Type::UnsignedByte, Format::Red) => each(groups, out, |[r]| u32::from(r) | opaque),
            (Type::UnsignedByte, Format::Green) => each(groups, out, |[g]| u32::from(g) << 8 | opaque),
            (Type::UnsignedByte, Format::Blue) => each(groups, out, |[b]| u32::from(b) << 16 | opaque),
            (Type::Packed(packing), format) if packing.bits == [8; 4] => {
                // As a number, 8_8_8_8_REV has its first component in the low byte, as texels are stored.
                // ABGR is RGBA from the other end.
                let reverse = ((packing.name == GL_UNSIGNED_INT_8_8_8_8) != self.swap) != (format == Format::Abgr);
                let number =
                    |bytes| if reverse { u32::from_ne_bytes(bytes).swap_bytes() } else { u32::from_ne_bytes(bytes) };
                if format == Format::Bgra {
                    each(groups, out, |bytes| swap_red_blue(number(bytes)));
                } else {
                    each(groups, out, number);
                }
            }
            _ => return false,
        }
        true
    }
}

/// Exchanges R and B of a packed colour.
#[inline]
#[must_use]
pub fn swap_red_blue(texel: u32) -> u32 {
    (texel & 0xFF00_FF00) | (texel >> 16 & 0xFF) | (texel & 0xFF) << 16
}

/// A luminance in R, G and B.
fn gray(l: u8) -> u32 {
    u32::from(l) * 0x01_0101
}

type CopyFn = unsafe fn(&[u8], &mut [u32], &mut u32);

stage! {
    /// Copies texels and clears the bits of a word that are not set in all of them, at the memory's speed.
    fn COPY: CopyFn = (from: &[u8], to: &mut [u32], common: &mut u32) {
        *common = to.iter_mut().zip(from.as_chunks::<4>().0).fold(*common, |common, (to, from)| {
            *to = u32::from_le_bytes(*from);
            common & *to
        });
    }
}

fn each<const N: usize>(groups: &[u8], out: &mut [u32], convert: impl Fn([u8; N]) -> u32) {
    for (to, from) in out.iter_mut().zip(groups.as_chunks::<N>().0) {
        *to = convert(*from);
    }
}

fn indices<E: Element>(groups: &[u8], swap: bool, out: &mut [f64]) {
    for (to, from) in out.iter_mut().zip(groups.chunks_exact(E::BYTES)) {
        *to = E::read(from, swap).to_index();
    }
}

fn components<E: Element>(groups: &[u8], swap: bool, out: &mut [f32]) {
    for (to, from) in out.iter_mut().zip(groups.chunks_exact(E::BYTES)) {
        *to = E::read(from, swap).to_component();
    }
}

fn scatter<E: Element>(groups: &[u8], swap: bool, channels: &[usize], out: &mut [[f32; 4]]) {
    for (to, from) in out.iter_mut().zip(groups.chunks_exact(E::BYTES * channels.len())) {
        for (&channel, bytes) in channels.iter().zip(from.chunks_exact(E::BYTES)) {
            to[channel & 3] = E::read(bytes, swap).to_component();
        }
    }
}

fn unpack_packed(groups: &[u8], swap: bool, packing: &Packing, channels: &[usize], out: &mut [[f32; 4]]) {
    let element = |from: &[u8]| match packing.bytes {
        1 => u8::read(from, swap).into(),
        2 => u16::read(from, swap).into(),
        _ => u32::read(from, swap),
    };
    for (i, &channel) in channels.iter().enumerate() {
        let (shift, max) = (packing.shifts[i & 3], (1u32 << packing.bits[i & 3]) - 1);
        for (to, from) in out.iter_mut().zip(groups.chunks_exact(packing.bytes)) {
            // Both numbers are small and exact, so the quotient is rounded once.
            to[channel & 3] = (element(from) >> shift & max) as f32 / max as f32;
        }
    }
}
