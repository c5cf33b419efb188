//! Writing texels (OpenGL 1.5, sections 3.8.1 and 3.8.2): TexImage, TexSubImage, and rows that the framebuffer gives to
//! CopyTexImage. Whatever comes in is an RGBA colour or a depth; the base format takes its components, the texel is
//! rounded to what the format keeps and stored expanded. Positions count from the interior, so a border is at -1.

use super::format::{BaseFormat, BlockFit, InternalFormat, Storage};
use super::image::{Dimensions, Image, Texels};
use crate::error::{Outcome, invalid_operation, invalid_value};
use crate::pixels::element::{from_rgba8, to_rgba8};
use crate::pixels::{ClientImage, PixelFormat, PixelKind, Transfer};

/// How many texels are converted at a time.
const CHUNK: usize = 64;
/// The least texel whose alpha is 255.
const OPAQUE: u32 = 0xFF00_0000;

/// INVALID_OPERATION unless pixels of this format can become texels of this format: depths go to depth textures and
/// nothing else does.
pub fn check_formats(pixel: PixelFormat, internal: &InternalFormat) -> Outcome {
    let depth = matches!(pixel.kind(), PixelKind::Depth | PixelKind::DepthStencil);
    match (depth, internal.base == BaseFormat::Depth) {
        (true, false) => Err(invalid_operation(
            "depth pixels for a colour texture; give it an internal format such as GL_DEPTH_COMPONENT24",
        )),
        (false, true) => Err(invalid_operation(
            "colour pixels for a depth texture; its pixel format must be GL_DEPTH_COMPONENT or GL_DEPTH_STENCIL_EXT",
        )),
        _ => Ok(()),
    }
}

impl Image {
    /// An image of `size` (as TexImage counts it, border included) from client pixels, or of zeros without them. `fit` is
    /// how the blocks of a compressed format are chosen.
    pub fn from_client(
        format: &'static InternalFormat,
        dimensions: Dimensions,
        size: [u32; 3],
        border: u32,
        pixels: Option<&ClientImage<'_>>,
        transfer: Transfer<'_>,
        fit: BlockFit,
    ) -> Outcome<Image> {
        let interior = size.map(|n| n.saturating_sub(2 * border));
        let mut image = Image::new(format, dimensions, interior, border)?;
        image.fit = fit;
        match pixels {
            Some(pixels) => image.upload(image.first(), pixels, transfer)?,
            None => image.recompress([0; 3], size.map(u32::cast_signed))?,
        }
        Ok(image)
    }

    /// The position of the first texel: -1 in each dimension that has a border.
    #[must_use]
    pub fn first(&self) -> [i32; 3] {
        let b = -self.border.cast_signed();
        match self.dimensions {
            Dimensions::One => [b, 0, 0],
            Dimensions::Two => [b, b, 0],
            Dimensions::Three => [b, b, b],
        }
    }

    /// INVALID_VALUE unless a region lies in the image, border included.
    pub fn check_region(&self, offset: [i32; 3], size: [i32; 3]) -> Outcome {
        let full = self.full_size();
        for (axis, (first, label)) in self.first().into_iter().zip(["x", "y", "z"]).enumerate() {
            let end = i64::from(offset[axis]) + i64::from(size[axis]);
            if size[axis] < 0 || offset[axis] < first || end > i64::from(first) + i64::from(full[axis]) {
                return Err(invalid_value(format!(
                    "{label} from {} to {end}, but the image has texels {first} to {}",
                    offset[axis],
                    i64::from(first) + i64::from(full[axis])
                )));
            }
        }
        Ok(())
    }

    /// Writes client pixels at `offset`: TexSubImage, and TexImage with the whole image. Checks first, then writes.
    pub fn upload(&mut self, offset: [i32; 3], pixels: &ClientImage<'_>, transfer: Transfer<'_>) -> Outcome {
        check_formats(pixels.pixel(), self.format)?;
        let [width, height, depth] = pixels.size();
        let size = [width, height, depth].map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        self.check_region(offset, size)?;
        self.check_block_region(offset, size)?;
        if width == 0 || height == 0 || depth == 0 {
            return Ok(());
        }
        let whole = size == self.full_size().map(u32::cast_signed);
        // Only of these is it ever asked: others have no alpha, or no other channel.
        let asked = matches!(self.base, BaseFormat::Rgba | BaseFormat::LuminanceAlpha);
        let mut opaque = (whole || self.opaque) && asked && self.format.storage == Storage::Rgba8;
        self.show_border();
        let (base, format) = (self.base, self.format);
        for z in 0..depth {
            for y in 0..height {
                let start = self.index(offset[0], offset[1] + y as i32, offset[2] + z as i32);
                match &mut self.texels {
                    Texels::Rgba8(texels) => {
                        let Some(row) = texels.get_mut(start..start + width) else { continue };
                        if opaque && base == BaseFormat::Rgba {
                            opaque = pixels.common_rgba8([0, y, z], transfer, row) >= OPAQUE;
                        } else {
                            pixels.colors_rgba8([0, y, z], transfer, row);
                            expand_rgba8(base, row);
                            opaque = opaque && row.iter().all(|texel| *texel >= OPAQUE);
                        }
                    }
                    Texels::Float(texels) => {
                        let Some(row) = texels.get_mut(start..start + width) else { continue };
                        pixels.colors([0, y, z], transfer, row);
                        row.iter_mut().for_each(|t| *t = base.expand(format.round(*t)));
                    }
                    Texels::Depth(texels) => {
                        let Some(row) = texels.get_mut(start..start + width) else { continue };
                        pixels.depths([0, y, z], transfer, row);
                        row.iter_mut().for_each(|t| *t = format.round([*t; 4])[0]);
                        // Depths alone leave the stencil indices as they are.
                        let row = self.stencil.as_mut().and_then(|all| all.get_mut(start..start + width));
                        if let Some(row) = row.filter(|_| pixels.pixel().kind() == PixelKind::DepthStencil) {
                            pixels.stencils8([0, y, z], transfer, row);
                        }
                    }
                }
            }
        }
        self.recompress(offset, size)?;
        self.opaque = opaque && self.compressed.is_none();
        Ok(())
    }

    /// Writes a row of packed colours, as the framebuffer holds them, through pixel transfer. What lies outside the image
    /// is left out; a depth image stays as it is. When all rows are written, [`Image::recompress`] brings the blocks
    /// of a compressed image up to date.
    pub fn write_rgba8(&mut self, at: [i32; 3], row: &[u32], transfer: Transfer<'_>) {
        if !transfer.keeps_colors() || self.format.storage != Storage::Rgba8 {
            let mut colors = [[0.0; 4]; CHUNK];
            for (n, part) in row.chunks(CHUNK).enumerate() {
                let colors = &mut colors[..part.len()];
                colors.iter_mut().zip(part).for_each(|(to, &from)| *to = from_rgba8(from));
                let Some(x) = at[0].checked_add_unsigned((n * CHUNK) as u32) else { return };
                self.write_colors([x, at[1], at[2]], colors, transfer);
            }
            return;
        }
        let Some((start, from, len)) = self.clip(at, row.len()) else { return };
        self.show_border();
        let base = self.base;
        if let Texels::Rgba8(texels) = &mut self.texels
            && let (Some(to), Some(from)) = (texels.get_mut(start..start + len), row.get(from..from + len))
        {
            to.copy_from_slice(from);
            expand_rgba8(base, to);
        }
    }

    /// Writes a row of colours through pixel transfer; otherwise as [`Image::write_rgba8`].
    pub fn write_colors(&mut self, at: [i32; 3], row: &mut [[f32; 4]], transfer: Transfer<'_>) {
        transfer.colors(row);
        let Some((start, from, len)) = self.clip(at, row.len()) else { return };
        self.show_border();
        let (base, format) = (self.base, self.format);
        let Some(row) = row.get(from..from + len) else { return };
        match &mut self.texels {
            Texels::Rgba8(texels) => {
                for (to, &from) in texels.iter_mut().skip(start).zip(row) {
                    *to = base.expand_rgba8(to_rgba8(from));
                }
            }
            Texels::Float(texels) => {
                for (to, &from) in texels.iter_mut().skip(start).zip(row) {
                    *to = base.expand(format.round(from.map(crate::num::clamp01)));
                }
            }
            Texels::Depth(_) => {}
        }
    }

    /// Writes a row of depths through pixel transfer. What lies outside the image is left out; a colour image stays.
    pub fn write_depths(&mut self, at: [i32; 3], row: &mut [f32], transfer: Transfer<'_>) {
        transfer.depths(row);
        let Some((start, from, len)) = self.clip(at, row.len()) else { return };
        self.show_border();
        let format = self.format;
        if let (Texels::Depth(texels), Some(row)) = (&mut self.texels, row.get(from..from + len)) {
            for (to, &from) in texels.iter_mut().skip(start).zip(row) {
                *to = format.round([from; 4])[0];
            }
        }
    }

    /// Writes a row of stencil indices through pixel transfer. What lies outside the image is left out.
    pub fn write_stencils(&mut self, at: [i32; 3], row: &[u8], transfer: Transfer<'_>) {
        let Some((start, from, len)) = self.clip(at, row.len()) else { return };
        if let (Some(all), Some(row)) = (&mut self.stencil, row.get(from..from + len)) {
            for (to, &from) in all.iter_mut().skip(start).zip(row) {
                *to = transfer.stencil(from.into()) as u8;
            }
        }
    }

    /// The part of a row that lies in the image: its index, how many are cut off before it, its length.
    fn clip(&self, [x, y, z]: [i32; 3], len: usize) -> Option<(usize, usize, usize)> {
        let (first, full) = (self.first(), self.full_size());
        let inside =
            |v: i32, axis: usize| v >= first[axis] && i64::from(v) < i64::from(first[axis]) + i64::from(full[axis]);
        if !inside(y, 1) || !inside(z, 2) {
            return None;
        }
        let end = (i64::from(x) + i64::try_from(len).ok()?).min(i64::from(first[0]) + i64::from(full[0]));
        let start = i64::from(x).max(i64::from(first[0]));
        let len = usize::try_from(end - start).ok().filter(|&len| len > 0)?;
        let cut = usize::try_from(start - i64::from(x)).ok()?;
        Some((self.index(i32::try_from(start).ok()?, y, z), cut, len))
    }
}

/// Expands a row in place; nothing is left to do for RGBA.
fn expand_rgba8(base: BaseFormat, row: &mut [u32]) {
    if base != BaseFormat::Rgba {
        row.iter_mut().for_each(|t| *t = base.expand_rgba8(*t));
    }
}
