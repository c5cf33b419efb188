//! The end of the pipeline (OpenGL 1.5, sections 4.2.3, 4.3.2 and 5.5): Flush and Finish let what was issued reach the
//! framebuffer, Clear fills it, ReadPixels packs rows of it. Drawing is deferred, so everything that looks at the
//! framebuffer flushes first.

use super::Values;
use super::engine::Engine;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, invalid_value};
use crate::framebuffer::{AccumOp, Clear, Rect};
use crate::pixels::{ClientTarget, PixelFormat, PixelKind, Purpose};
use crate::state::color_buffer::ColorBufferName;

impl Engine {
    pub(crate) fn flush(&mut self) {
        self.flush_scene();
    }

    pub(crate) fn finish(&mut self) {
        self.flush_scene();
    }

    pub(crate) fn clear(&mut self, mask: u32) -> Outcome {
        let all = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
        if mask & !all != 0 {
            return Err(invalid_value(format!(
                "0x{:X} in the mask of glClear; it takes GL_COLOR_, GL_DEPTH_, GL_STENCIL_ and GL_ACCUM_BUFFER_BIT",
                mask & !all
            )));
        }
        if !self.renders() {
            return Ok(());
        }
        self.flush_scene();
        let s = &self.state;
        let has = |bit: u32| mask & bit != 0;
        let color = has(GL_COLOR_BUFFER_BIT) && s.color_buffer.draw_buffer != ColorBufferName::None;
        let clear = Clear {
            color: color.then_some((s.color_buffer.clear_color, s.color_buffer.color_mask)),
            depth: (has(GL_DEPTH_BUFFER_BIT) && s.depth.mask).then_some(s.depth.clear),
            stencil: has(GL_STENCIL_BUFFER_BIT).then_some((s.stencil.clear as u8, s.stencil.write_mask as u8)),
            accum: has(GL_ACCUM_BUFFER_BIT).then_some(s.accum.clear),
        };
        let scissor = self.scissor_rect();
        self.unseen = true;
        // A clear of whole buffers waits, and one of a part is a copy of rows.
        self.pixels_written += self.framebuffer_pixels() / 16;
        self.framebuffer.defer_clear(&clear, scissor)
    }

    /// The accumulation buffer is as large as the framebuffer and is made when it is used first (section 4.2.4).
    pub(crate) fn accum(&mut self, op: GLenum, value: f32) -> Outcome {
        let op = match op {
            GL_ACCUM => AccumOp::Accumulate,
            GL_LOAD => AccumOp::Load,
            GL_RETURN => AccumOp::Return,
            GL_MULT => AccumOp::Multiply,
            GL_ADD => AccumOp::Add,
            _ => return Err(invalid_enum(format!("{} is not an accumulation operation", name(op)))),
        };
        if !self.renders() {
            return Ok(());
        }
        self.flush_scene();
        let rect = self.scissor_rect().unwrap_or_else(|| self.framebuffer.rect(0, 0, i32::MAX, i32::MAX));
        let none = self.state.color_buffer.draw_buffer == ColorBufferName::None;
        let mask = if none { [false; 4] } else { self.state.color_buffer.color_mask };
        self.unseen = true;
        self.pixels_written += self.framebuffer_pixels();
        self.framebuffer.accumulate(op, value, rect, mask)
    }

    pub(crate) fn framebuffer_pixels(&self) -> u64 {
        u64::from(self.framebuffer.width()) * u64::from(self.framebuffer.height())
    }

    /// The scissor box where the scissor test is on.
    fn scissor_rect(&self) -> Option<Rect> {
        let s = &self.state.scissor;
        s.enabled.then(|| self.framebuffer.rect(s.x, s.y, s.width, s.height))
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn read_pixels(
        &mut self,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &mut [u8],
    ) -> Outcome {
        if width < 0 || height < 0 {
            return Err(invalid_value(format!("an area of {width} by {height} pixels; neither may be negative")));
        }
        let pixel = PixelFormat::for_command(format, type_, Purpose::ReadPixels)?;
        if pixel.kind() == PixelKind::Index {
            return Err(invalid_operation("the framebuffer holds colours, not colour indices; read GL_RGBA"));
        }
        self.check_has_buffers(pixel.kind())?;
        self.flush_scene();
        if pixel.kind() == PixelKind::Color && self.uses_imaging() {
            return self.read_imaged([x, y], [width, height], pixel, pixels);
        }
        let transfer = crate::pixels::Transfer { mode: &self.state.pixel.transfer, maps: &self.state.pixel_maps };
        let mut target = ClientTarget::new_2d(pixels, &self.client.pixel_store.pack, [width, height], pixel)?;
        // Pixels outside the framebuffer are undefined: the memory that stands for them stays as it was.
        let (first, last) = (x.max(0), x.saturating_add(width).min(self.framebuffer.width() as i32));
        if first >= last {
            return Ok(());
        }
        let (left, count) = ((i64::from(first) - i64::from(x)) as usize, (last - first) as usize);
        let (mut depths, mut stencils) = (vec![0.0; count], vec![0; count]);
        let (mut floats, mut texels) = (vec![[0.0; 4]; count], vec![0; count]);
        let rows = y.max(0)..y.saturating_add(height).min(self.framebuffer.height() as i32);
        for row in rows {
            let at = [left, (i64::from(row) - i64::from(y)) as usize, 0];
            match pixel.kind() {
                PixelKind::Depth => {
                    self.framebuffer.read_depth(first, row, &mut depths);
                    target.depths(at, transfer, &depths);
                }
                PixelKind::Stencil => {
                    self.framebuffer.read_stencil(first, row, &mut stencils);
                    target.stencils(at, transfer, &to_u32(&stencils));
                }
                PixelKind::DepthStencil => {
                    self.framebuffer.read_depth(first, row, &mut depths);
                    self.framebuffer.read_stencil(first, row, &mut stencils);
                    target.depth_stencils(at, transfer, &depths, &to_u32(&stencils));
                }
                _ if self.framebuffer.format().float => {
                    self.framebuffer.read_float(first, row, &mut floats);
                    target.colors(at, transfer, &floats);
                }
                _ => {
                    self.framebuffer.read_rgba8(first, row, &mut texels);
                    target.colors_rgba8(at, transfer, &texels);
                }
            }
        }
        Ok(())
    }

    /// Colours that the imaging subset changes, perhaps with their number.
    fn read_imaged(&mut self, from: [i32; 2], size: [i32; 2], pixel: PixelFormat, pixels: &mut [u8]) -> Outcome {
        let image = self.read_colors(from, size.map(|n| n.unsigned_abs() as usize))?;
        let Some(image) = self.transfer_image(image, 2)? else { return Ok(()) };
        let size = image.size.map(|n| i32::try_from(n).unwrap_or(i32::MAX));
        let mut target = ClientTarget::new_2d(pixels, &self.client.pixel_store.pack, size, pixel)?;
        for (y, row) in image.colors.chunks_exact(image.size[0].max(1)).enumerate() {
            target.colors([0, y, 0], crate::pixels::Transfer::NEUTRAL, row);
        }
        Ok(())
    }

    /// INVALID_OPERATION unless the framebuffer has the buffers of a kind of pixels.
    pub(crate) fn check_has_buffers(&self, kind: PixelKind) -> Outcome {
        let bits = self.framebuffer.format();
        let missing = match kind {
            PixelKind::Depth if bits.depth_bits == 0 => "depth",
            PixelKind::Stencil if bits.stencil_bits == 0 => "stencil",
            PixelKind::DepthStencil if bits.depth_bits == 0 || bits.stencil_bits == 0 => "depth and stencil",
            _ => return Ok(()),
        };
        Err(invalid_operation(format!("the framebuffer has no {missing} buffer")))
    }

    /// Sizes of the buffers, for Get.
    pub(crate) fn framebuffer_value(&self, pname: GLenum) -> Option<Values> {
        let f = self.framebuffer.format();
        let bits = |n: u8| Values::int(i32::from(n));
        Some(match pname {
            GL_RED_BITS => bits(f.color_bits[0]),
            GL_GREEN_BITS => bits(f.color_bits[1]),
            GL_BLUE_BITS => bits(f.color_bits[2]),
            GL_ALPHA_BITS => bits(f.color_bits[3]),
            GL_DEPTH_BITS => bits(f.depth_bits),
            GL_STENCIL_BITS => bits(f.stencil_bits),
            GL_ACCUM_RED_BITS | GL_ACCUM_GREEN_BITS | GL_ACCUM_BLUE_BITS | GL_ACCUM_ALPHA_BITS => bits(f.accum_bits),
            _ => return None,
        })
    }
}

fn to_u32(values: &[u8]) -> Vec<u32> {
    values.iter().map(|v| u32::from(*v)).collect()
}
