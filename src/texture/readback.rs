//! Reading images back (OpenGL 1.5, section 6.1.4): GetTexImage and GetCompressedTexImage. The components of the base
//! format are put where table 6.1 puts them: a luminance or an intensity comes back as red alone, so that a luminance,
//! packed as the sum of R, G and B, is itself again. No pixel transfer applies. The border comes along.

use super::format::BaseFormat;
use super::image::{Dimensions, Image, Texels};
use crate::enums::GLenum;
use crate::error::{Outcome, invalid_operation};
use crate::pixels::layout::ClientLayout;
use crate::pixels::{ClientTarget, PixelFormat, PixelKind, Purpose, Transfer};
use crate::state::pixel::PixelStore;

/// How many texels are converted at a time.
const CHUNK: usize = 64;

impl Image {
    /// How many bytes GetTexImage writes, skips included.
    pub fn get_tex_image_bytes(&self, store: &PixelStore, format: GLenum, type_: GLenum) -> Outcome<usize> {
        let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        let [w, h, d] = self.full_size().map(u32::cast_signed);
        Ok(match self.dimensions {
            Dimensions::Three => ClientLayout::of_3d(store, [w, h, d], pixel)?,
            _ => ClientLayout::of_2d(store, [w, h], pixel)?,
        }
        .total)
    }

    /// GetTexImage: writes the whole image, border included, under the pack state.
    pub fn get_tex_image(&self, store: &PixelStore, format: GLenum, type_: GLenum, out: &mut [u8]) -> Outcome {
        let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        if pixel.kind() == PixelKind::DepthStencil && self.stencil.is_none() {
            return Err(invalid_operation(
                "stencil indices of a texture that has none; its internal format must be GL_DEPTH24_STENCIL8_EXT",
            ));
        }
        let depth = matches!(pixel.kind(), PixelKind::Depth | PixelKind::DepthStencil);
        match (depth, self.base == BaseFormat::Depth) {
            (true, false) => return Err(invalid_operation("depths of a colour texture; ask for GL_RGBA or the like")),
            (false, true) => return Err(invalid_operation("colours of a depth texture; ask for GL_DEPTH_COMPONENT")),
            _ => {}
        }
        let [w, h, d] = self.full_size();
        let size = [w, h, d].map(u32::cast_signed);
        let mut target = match self.dimensions {
            Dimensions::Three => ClientTarget::new_3d(out, store, size, pixel)?,
            _ => ClientTarget::new_2d(out, store, [size[0], size[1]], pixel)?,
        };
        if self.is_null() && self.border == 0 {
            return Ok(());
        }
        // A luminance is packed as the sum of R, G and B; it is red alone once the others are 0.
        let base = match self.base {
            BaseFormat::Rgb if pixel.format.is_luminance() => BaseFormat::Luminance,
            BaseFormat::Rgba if pixel.format.is_luminance() => BaseFormat::LuminanceAlpha,
            base => base,
        };
        let first = self.first();
        for z in 0..size[2] {
            for y in 0..size[1] {
                let start = self.index(first[0], first[1] + y, first[2] + z);
                self.pack_row(&mut target, base, [0, y as usize, z as usize], start..start + w as usize);
            }
        }
        Ok(())
    }

    fn pack_row(
        &self,
        target: &mut ClientTarget<'_>,
        base: BaseFormat,
        at: [usize; 3],
        texels: std::ops::Range<usize>,
    ) {
        match self.own_texels() {
            Texels::Rgba8(t) => {
                let row = t.get(texels).unwrap_or(&[]);
                if matches!(base, BaseFormat::Rgba | BaseFormat::Rgb | BaseFormat::Alpha) {
                    target.colors_rgba8(at, Transfer::NEUTRAL, row);
                    return;
                }
                let mut work = [0; CHUNK];
                for (n, part) in row.chunks(CHUNK).enumerate() {
                    let work = &mut work[..part.len()];
                    let keep = if base == BaseFormat::LuminanceAlpha { 0xFF00_00FF } else { 0xFF };
                    let set = if base == BaseFormat::LuminanceAlpha { 0 } else { 0xFF00_0000 };
                    work.iter_mut().zip(part).for_each(|(to, &from)| *to = from & keep | set);
                    target.colors_rgba8([at[0] + n * CHUNK, at[1], at[2]], Transfer::NEUTRAL, work);
                }
            }
            Texels::Float(t) => {
                let mut work = [[0.0; 4]; CHUNK];
                for (n, part) in t.get(texels).unwrap_or(&[]).chunks(CHUNK).enumerate() {
                    let work = &mut work[..part.len()];
                    work.iter_mut().zip(part).for_each(|(to, &from)| *to = group(base, from));
                    target.colors([at[0] + n * CHUNK, at[1], at[2]], Transfer::NEUTRAL, work);
                }
            }
            Texels::Depth(t) => {
                let depths = t.get(texels.clone()).unwrap_or(&[]);
                match self.stencil.as_ref().and_then(|all| all.get(texels)) {
                    Some(stencils) if target.pixel().kind() == PixelKind::DepthStencil => {
                        for (n, (depths, stencils)) in depths.chunks(CHUNK).zip(stencils.chunks(CHUNK)).enumerate() {
                            let mut work = [0; CHUNK];
                            work.iter_mut().zip(stencils).for_each(|(to, &from)| *to = from.into());
                            let at = [at[0] + n * CHUNK, at[1], at[2]];
                            target.depth_stencils(at, Transfer::NEUTRAL, depths, &work);
                        }
                    }
                    _ => target.depths(at, Transfer::NEUTRAL, depths),
                }
            }
        }
    }

    /// GetCompressedTexImage: the blocks as they are kept.
    pub fn get_compressed(&self, out: &mut [u8]) -> Outcome {
        let Some(blocks) = &self.compressed else {
            return Err(invalid_operation("the image is not compressed; read it with GetTexImage"));
        };
        let have = out.len();
        match out.get_mut(..blocks.len()) {
            Some(out) => {
                out.copy_from_slice(blocks);
                Ok(())
            }
            None => Err(invalid_operation(format!("{have} bytes for an image of {} bytes", blocks.len()))),
        }
    }
}

/// A texel as the group of table 6.1.
fn group(base: BaseFormat, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
    match base {
        BaseFormat::Luminance | BaseFormat::Intensity => [r, 0.0, 0.0, 1.0],
        BaseFormat::LuminanceAlpha => [r, 0.0, 0.0, a],
        _ => [r, g, b, a],
    }
}
