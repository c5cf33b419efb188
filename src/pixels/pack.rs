//! From rows of groups to client memory (OpenGL 1.5, sections 4.3.2 and 6.1.4, figure 4.2): pixel transfer, a luminance
//! is the sum of R, G and B, the clamp to [0, 1], then each component is rounded to the nearest number of the type.
//! The mirror of `unpack`, with the same fast path for 8-bit colours that nothing changes. Bytes between the groups
//! (alignment, skips, the rest of long rows) are never touched.

use super::element::{Element, from_rgba8};
use super::format::{Format, Packing, PixelFormat, Type};
use super::layout::ClientLayout;
use super::transfer::Transfer;
use super::unpack::swap_red_blue;
use crate::enums::GL_UNSIGNED_INT_8_8_8_8;
use crate::error::Outcome;
use crate::num::{clamp01, f32_to_unorm, f64_to_snorm, f64_to_unorm};
use crate::state::pixel::PixelStore;

/// How many groups are converted at a time.
const CHUNK: usize = 64;

/// Client memory that an image is written to, checked against the length of that memory.
#[derive(Debug)]
pub struct ClientTarget<'a> {
    bytes: &'a mut [u8],
    layout: ClientLayout,
    pixel: PixelFormat,
    swap: bool,
    lsb_first: bool,
}

impl<'a> ClientTarget<'a> {
    /// A 1D (height 1) or 2D image; skipped slices do not apply.
    pub fn new_2d(
        bytes: &'a mut [u8],
        store: &PixelStore,
        size: [i32; 2],
        pixel: PixelFormat,
    ) -> Outcome<ClientTarget<'a>> {
        ClientTarget::checked(bytes, store, ClientLayout::of_2d(store, size, pixel)?, pixel)
    }

    /// A 3D image.
    pub fn new_3d(
        bytes: &'a mut [u8],
        store: &PixelStore,
        size: [i32; 3],
        pixel: PixelFormat,
    ) -> Outcome<ClientTarget<'a>> {
        ClientTarget::checked(bytes, store, ClientLayout::of_3d(store, size, pixel)?, pixel)
    }

    fn checked(
        bytes: &'a mut [u8],
        store: &PixelStore,
        layout: ClientLayout,
        pixel: PixelFormat,
    ) -> Outcome<ClientTarget<'a>> {
        layout.check_len(bytes.len())?;
        Ok(ClientTarget { bytes, layout, pixel, swap: store.swap_bytes, lsb_first: store.lsb_first })
    }

    /// Its format and type.
    #[must_use]
    pub fn pixel(&self) -> PixelFormat {
        self.pixel
    }

    /// The bytes of groups `x`.. of row `y`; empty outside the image. Not for bitmaps.
    fn groups(&mut self, [x, y, z]: [usize; 3]) -> &mut [u8] {
        let g = &self.layout;
        if x >= g.width || y >= g.height || z >= g.depth {
            return &mut [];
        }
        let start = g.row_start(y, z);
        self.bytes.get_mut(start + x * self.pixel.group_bytes()..start + g.row_bytes).unwrap_or(&mut [])
    }

    fn set_bit(&mut self, [x, y, z]: [usize; 3], on: bool) {
        let g = &self.layout;
        if x >= g.width || y >= g.height || z >= g.depth {
            return;
        }
        let at = g.first_bit + x;
        let mask = 1 << if self.lsb_first { at % 8 } else { 7 - at % 8 };
        if let Some(byte) = self.bytes.get_mut(g.row_start(y, z) + at / 8) {
            *byte = if on { *byte | mask } else { *byte & !mask };
        }
    }

    /// Writes colours from group `at` on.
    pub fn colors(&mut self, at: [usize; 3], transfer: Transfer<'_>, colors: &[[f32; 4]]) {
        let mut work = [[0.0; 4]; CHUNK];
        for (n, part) in colors.chunks(CHUNK).enumerate() {
            let work = &mut work[..part.len()];
            work.copy_from_slice(part);
            transfer.colors(work);
            if self.pixel.format.is_luminance() {
                work.iter_mut().for_each(|c| c[0] = c[0] + c[1] + c[2]);
            }
            work.iter_mut().for_each(|c| *c = c.map(clamp01));
            self.components([at[0] + n * CHUNK, at[1], at[2]], work);
        }
    }

    /// Writes colours from group `at` on as a query assigned them: a luminance stands in R. Floats are not limited.
    pub fn values(&mut self, at: [usize; 3], colors: &[[f32; 4]]) {
        if self.pixel.type_ == Type::Float {
            return self.components(at, colors);
        }
        let limited: Vec<[f32; 4]> = colors.iter().map(|color| color.map(clamp01)).collect();
        self.components(at, &limited);
    }

    /// Writes counts as numbers of the type, no larger than that holds.
    pub fn counts(&mut self, counts: &[[u32; 4]]) {
        let (type_, swap, channels) = (self.pixel.type_, self.swap, self.pixel.format.channels());
        let groups = self.groups([0; 3]);
        match type_ {
            Type::UnsignedByte => gather_counts::<u8>(groups, swap, channels, counts, 0xFF),
            Type::Byte => gather_counts::<i8>(groups, swap, channels, counts, 0x7F),
            Type::UnsignedShort => gather_counts::<u16>(groups, swap, channels, counts, 0xFFFF),
            Type::Short => gather_counts::<i16>(groups, swap, channels, counts, 0x7FFF),
            Type::UnsignedInt => gather_counts::<u32>(groups, swap, channels, counts, u32::MAX),
            Type::Int => gather_counts::<i32>(groups, swap, channels, counts, 0x7FFF_FFFF),
            Type::Float => gather_counts::<f32>(groups, swap, channels, counts, u32::MAX),
            Type::Packed(packing) => {
                // The share of a component's range that a count is.
                let share = |n: u32, i: usize| n as f32 / ((1u64 << packing.bits[i].max(1)) - 1) as f32;
                let shares: Vec<[f32; 4]> = counts
                    .iter()
                    .map(|count| {
                        let mut color = [0.0; 4];
                        channels
                            .iter()
                            .enumerate()
                            .for_each(|(i, c)| color[c & 3] = clamp01(share(count[c & 3], i & 3)));
                        color
                    })
                    .collect();
                pack_packed(groups, swap, packing, channels, &shares);
            }
            Type::Bitmap | Type::UnsignedInt248 => {}
        }
    }

    /// Writes final components; a luminance stands in R.
    fn components(&mut self, at: [usize; 3], colors: &[[f32; 4]]) {
        let (type_, swap, channels) = (self.pixel.type_, self.swap, self.pixel.format.channels());
        let groups = self.groups(at);
        match type_ {
            Type::UnsignedByte => gather::<u8>(groups, swap, channels, colors),
            Type::Byte => gather::<i8>(groups, swap, channels, colors),
            Type::UnsignedShort => gather::<u16>(groups, swap, channels, colors),
            Type::Short => gather::<i16>(groups, swap, channels, colors),
            Type::UnsignedInt => gather::<u32>(groups, swap, channels, colors),
            Type::Int => gather::<i32>(groups, swap, channels, colors),
            Type::Float => gather::<f32>(groups, swap, channels, colors),
            Type::Packed(packing) => pack_packed(groups, swap, packing, channels, colors),
            Type::Bitmap | Type::UnsignedInt248 => {}
        }
    }

    /// Writes packed colours (bytes R, G, B, A from low to high) from group `at` on.
    pub fn colors_rgba8(&mut self, at: [usize; 3], transfer: Transfer<'_>, texels: &[u32]) {
        if transfer.keeps_colors() && self.copy_rgba8(at, texels) {
            return;
        }
        let mut work = [[0.0; 4]; CHUNK];
        for (n, part) in texels.chunks(CHUNK).enumerate() {
            let work = &mut work[..part.len()];
            for (to, &from) in work.iter_mut().zip(part) {
                *to = from_rgba8(from);
            }
            self.colors([at[0] + n * CHUNK, at[1], at[2]], transfer, work);
        }
    }

    /// The fast path for components of 8 bits and for floats. False if it is another type.
    fn copy_rgba8(&mut self, at: [usize; 3], texels: &[u32]) -> bool {
        let (type_, format, swap) = (self.pixel.type_, self.pixel.format, self.swap);
        let groups = self.groups(at);
        let sum = |t: u32| {
            let [r, g, b, _] = t.to_le_bytes();
            r.saturating_add(g).saturating_add(b)
        };
        match (type_, format) {
            (Type::UnsignedByte, Format::Rgba) => each(groups, texels, u32::to_le_bytes),
            (Type::UnsignedByte, Format::Bgra) => each(groups, texels, |t| swap_red_blue(t).to_le_bytes()),
            (Type::UnsignedByte, Format::Abgr) => each(groups, texels, u32::to_be_bytes),
            (Type::UnsignedByte, Format::Rgb) => each(groups, texels, |t| [t as u8, (t >> 8) as u8, (t >> 16) as u8]),
            (Type::UnsignedByte, Format::Bgr) => each(groups, texels, |t| [(t >> 16) as u8, (t >> 8) as u8, t as u8]),
            (Type::UnsignedByte, Format::Luminance) => each(groups, texels, |t| [sum(t)]),
            (Type::UnsignedByte, Format::LuminanceAlpha) => each(groups, texels, |t| [sum(t), (t >> 24) as u8]),
            (Type::UnsignedByte, Format::Alpha) => each(groups, texels, |t| [(t >> 24) as u8]),
            (Type::UnsignedByte, Format::Red) => each(groups, texels, |t| [t as u8]),
            (Type::UnsignedByte, Format::Green) => each(groups, texels, |t| [(t >> 8) as u8]),
            (Type::UnsignedByte, Format::Blue) => each(groups, texels, |t| [(t >> 16) as u8]),
            (Type::Packed(packing), format) if packing.bits == [8; 4] => {
                let reverse = ((packing.name == GL_UNSIGNED_INT_8_8_8_8) != swap) != (format == Format::Abgr);
                each(groups, texels, |t| {
                    let number = if format == Format::Bgra { swap_red_blue(t) } else { t };
                    if reverse { number.swap_bytes().to_ne_bytes() } else { number.to_ne_bytes() }
                });
            }
            (Type::Float, format) if !swap && !format.is_luminance() => match *format.channels() {
                [a, b, c, d] => each(groups, texels, |t| floats::<4, 16>(t, [a, b, c, d])),
                [a, b, c] => each(groups, texels, |t| floats::<3, 12>(t, [a, b, c])),
                [a] => each(groups, texels, |t| floats::<1, 4>(t, [a])),
                _ => return false,
            },
            _ => return false,
        }
        true
    }

    /// Writes depths from group `at` on; into DEPTH_STENCIL groups together with stencil indices, see
    /// [`ClientTarget::depth_stencils`].
    pub fn depths<D: Copy + Into<f64>>(&mut self, at: [usize; 3], transfer: Transfer<'_>, depths: &[D]) {
        let (type_, swap) = (self.pixel.type_, self.swap);
        let groups = self.groups(at);
        // In f64: an f32 cannot hold every depth of 24 or 32 bits.
        let unsigned = |d: D, bits: u32| f64_to_unorm(transfer.depth(d.into()), bits);
        let signed = |d: D, bits: u32| f64_to_snorm(transfer.depth(d.into()), bits);
        match type_ {
            Type::UnsignedByte => numbers(groups, swap, depths, |d| unsigned(d, 8) as u8),
            Type::Byte => numbers(groups, swap, depths, |d| signed(d, 8) as i8),
            Type::UnsignedShort => numbers(groups, swap, depths, |d| unsigned(d, 16) as u16),
            Type::Short => numbers(groups, swap, depths, |d| signed(d, 16) as i16),
            Type::UnsignedInt => numbers(groups, swap, depths, |d| unsigned(d, 32)),
            Type::Int => numbers(groups, swap, depths, |d| signed(d, 32)),
            Type::Float => numbers(groups, swap, depths, |d| transfer.depth(d.into()) as f32),
            Type::Bitmap | Type::Packed(_) | Type::UnsignedInt248 => {}
        }
    }

    /// Writes stencil indices from group `at` on.
    pub fn stencils(&mut self, at: [usize; 3], transfer: Transfer<'_>, stencils: &[u32]) {
        let mut work = [0; CHUNK];
        for (n, part) in stencils.chunks(CHUNK).enumerate() {
            let work = &mut work[..part.len()];
            for (to, &from) in work.iter_mut().zip(part) {
                *to = transfer.stencil(from.into());
            }
            self.raw_indices([at[0] + n * CHUNK, at[1], at[2]], work);
        }
    }

    /// Writes indices from group `at` on as they are, cut to the bits that the type has.
    pub fn raw_indices(&mut self, at: [usize; 3], indices: &[u32]) {
        let (type_, swap) = (self.pixel.type_, self.swap);
        if type_ == Type::Bitmap {
            for (i, &index) in indices.iter().enumerate() {
                self.set_bit([at[0] + i, at[1], at[2]], index & 1 != 0);
            }
            return;
        }
        let groups = self.groups(at);
        match type_ {
            Type::UnsignedByte => numbers(groups, swap, indices, u8::from_index),
            Type::Byte => numbers(groups, swap, indices, i8::from_index),
            Type::UnsignedShort => numbers(groups, swap, indices, u16::from_index),
            Type::Short => numbers(groups, swap, indices, i16::from_index),
            Type::UnsignedInt => numbers(groups, swap, indices, u32::from_index),
            Type::Int => numbers(groups, swap, indices, i32::from_index),
            Type::Float => numbers(groups, swap, indices, f32::from_index),
            Type::Bitmap | Type::Packed(_) | Type::UnsignedInt248 => {}
        }
    }

    /// Writes pairs of a depth and a stencil index as UNSIGNED_INT_24_8 from group `at` on.
    pub fn depth_stencils<D: Copy + Into<f64>>(
        &mut self,
        at: [usize; 3],
        transfer: Transfer<'_>,
        depths: &[D],
        stencils: &[u32],
    ) {
        if self.pixel.type_ != Type::UnsignedInt248 {
            return;
        }
        let swap = self.swap;
        let pairs = depths.iter().zip(stencils);
        for ((&depth, &stencil), group) in pairs.zip(self.groups(at).chunks_exact_mut(4)) {
            let bits = f64_to_unorm(transfer.depth(depth.into()), 24);
            (bits << 8 | transfer.stencil(stencil.into()) & 0xFF).write(group, swap);
        }
    }
}

/// Bytes as fractions of 255.
static FRACTIONS: [f32; 256] = {
    let mut fractions = [0.0; 256];
    let mut i = 0;
    while i < 256 {
        fractions[i] = i as f32 / 255.0;
        i += 1;
    }
    fractions
};

/// Some channels of a texel as floats.
#[inline(always)]
fn floats<const N: usize, const BYTES: usize>(texel: u32, channels: [usize; N]) -> [u8; BYTES] {
    let mut bytes = [0; BYTES];
    for (to, channel) in bytes.as_chunks_mut::<4>().0.iter_mut().zip(channels) {
        *to = FRACTIONS[usize::from((texel >> (8 * (channel & 3))) as u8)].to_ne_bytes();
    }
    bytes
}

fn each<const N: usize>(groups: &mut [u8], texels: &[u32], convert: impl Fn(u32) -> [u8; N]) {
    for (to, &from) in groups.as_chunks_mut::<N>().0.iter_mut().zip(texels) {
        *to = convert(from);
    }
}

fn numbers<E: Element, T: Copy>(groups: &mut [u8], swap: bool, from: &[T], convert: impl Fn(T) -> E) {
    for (to, &from) in groups.chunks_exact_mut(E::BYTES).zip(from) {
        convert(from).write(to, swap);
    }
}

fn gather<E: Element>(groups: &mut [u8], swap: bool, channels: &[usize], colors: &[[f32; 4]]) {
    for (to, from) in groups.chunks_exact_mut(E::BYTES * channels.len()).zip(colors) {
        for (&channel, bytes) in channels.iter().zip(to.chunks_exact_mut(E::BYTES)) {
            E::from_component(from[channel & 3]).write(bytes, swap);
        }
    }
}

fn gather_counts<E: Element>(groups: &mut [u8], swap: bool, channels: &[usize], counts: &[[u32; 4]], most: u32) {
    for (to, from) in groups.chunks_exact_mut(E::BYTES * channels.len()).zip(counts) {
        for (&channel, bytes) in channels.iter().zip(to.chunks_exact_mut(E::BYTES)) {
            E::from_index(from[channel & 3].min(most)).write(bytes, swap);
        }
    }
}

fn pack_packed(groups: &mut [u8], swap: bool, packing: &Packing, channels: &[usize], colors: &[[f32; 4]]) {
    for (to, from) in groups.chunks_exact_mut(packing.bytes).zip(colors) {
        let mut element = 0u32;
        for (i, &channel) in channels.iter().enumerate() {
            element |= f32_to_unorm(from[channel & 3], packing.bits[i & 3]) << packing.shifts[i & 3];
        }
        match packing.bytes {
            1 => (element as u8).write(to, swap),
            2 => (element as u16).write(to, swap),
            _ => element.write(to, swap),
        }
    }
}
