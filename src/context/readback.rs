//! The framebuffer as a Rust program sees it: its size, its pixels, a new size. What a window system does for GL
//! (OpenGL 1.5, section 2.1 leaves it out), a program without a window does here.

use super::{Config, Context};
use crate::error::Outcome;

impl Context {
    /// Width and height of the framebuffer in pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.engine.framebuffer.width(), self.engine.framebuffer.height())
    }

    /// How the context runs.
    #[must_use]
    pub fn config(&self) -> Config {
        self.engine.config
    }

    /// The colours of the whole framebuffer: four bytes R, G, B, A for each pixel, rows from the bottom up as GL counts
    /// them, without padding. Finishes what was drawn first. Pixel-store and pixel-transfer state play no part.
    #[must_use]
    pub fn pixels(&mut self) -> Vec<u8> {
        self.engine.flush_scene();
        let (width, height) = self.size();
        let mut row = vec![0; width as usize];
        let mut bytes = Vec::with_capacity(width as usize * height as usize * 4);
        for y in 0..height {
            self.engine.framebuffer.read_rgba8(0, y.cast_signed(), &mut row);
            bytes.extend(row.iter().flat_map(|pixel| pixel.to_le_bytes()));
        }
        bytes
    }

    /// The depths of the whole framebuffer in [0, 1], rows from the bottom up. Finishes what was drawn first.
    #[must_use]
    pub fn depths(&mut self) -> Vec<f64> {
        self.engine.flush_scene();
        let (width, height) = self.size();
        let mut depths = vec![0.0; width as usize * height as usize];
        for (y, row) in depths.chunks_mut((width as usize).max(1)).enumerate() {
            self.engine.framebuffer.read_depth(0, y as i32, row);
        }
        depths
    }

    /// The stencil values of the whole framebuffer, rows from the bottom up. Finishes what was drawn first.
    #[must_use]
    pub fn stencils(&mut self) -> Vec<u8> {
        self.engine.flush_scene();
        let (width, height) = self.size();
        let mut stencils = vec![0; width as usize * height as usize];
        for (y, row) in stencils.chunks_mut((width as usize).max(1)).enumerate() {
            self.engine.framebuffer.read_stencil(0, y as i32, row);
        }
        stencils
    }

    /// Gives the framebuffer a new size. Its content is undefined afterwards (zeros, depth 1); viewport and scissor box
    /// stay as they are, as when a window is resized: a program calls `glViewport` itself. An error, with nothing
    /// changed, where a side is beyond the limit or there is no memory.
    pub fn resize(&mut self, width: u32, height: u32) -> Outcome {
        self.engine.flush_scene();
        self.engine.framebuffer.resize(width, height)?;
        self.engine.dirty = crate::state::Dirty::ALL;
        Ok(())
    }
}
