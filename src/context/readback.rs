//! The framebuffer as a Rust program sees it: its size, its pixels, a new size. What a window system does for GL
//! (OpenGL 1.5, section 2.1 leaves it out), a program without a window does here.

use super::{Config, Context};
use crate::error::{Outcome, out_of_memory};

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
    /// `GL_OUT_OF_MEMORY` is recorded, and there are no bytes, where there is no memory for them.
    #[must_use]
    #[track_caller]
    pub fn pixels(&mut self) -> Vec<u8> {
        let mut bytes = self.whole_framebuffer("fixedgl::Context::pixels", 4, 0);
        let width = self.engine.framebuffer.width() as usize;
        let mut row = vec![0; width];
        for (y, bytes) in bytes.chunks_exact_mut((4 * width).max(1)).enumerate() {
            self.engine.framebuffer.read_rgba8(0, y as i32, &mut row);
            for (to, pixel) in bytes.chunks_exact_mut(4).zip(&row) {
                to.copy_from_slice(&pixel.to_le_bytes());
            }
        }
        bytes
    }

    /// The depths of the whole framebuffer in [0, 1], rows from the bottom up. Finishes what was drawn first.
    /// `GL_OUT_OF_MEMORY` is recorded, and there are no depths, where there is no memory for them.
    #[must_use]
    #[track_caller]
    pub fn depths(&mut self) -> Vec<f64> {
        let mut depths = self.whole_framebuffer("fixedgl::Context::depths", 1, 0.0);
        let width = self.engine.framebuffer.width() as usize;
        for (y, row) in depths.chunks_mut(width.max(1)).enumerate() {
            self.engine.framebuffer.read_depth(0, y as i32, row);
        }
        depths
    }

    /// The stencil values of the whole framebuffer, rows from the bottom up. Finishes what was drawn first.
    /// `GL_OUT_OF_MEMORY` is recorded, and there are no values, where there is no memory for them.
    #[must_use]
    #[track_caller]
    pub fn stencils(&mut self) -> Vec<u8> {
        let mut stencils = self.whole_framebuffer("fixedgl::Context::stencils", 1, 0);
        let width = self.engine.framebuffer.width() as usize;
        for (y, row) in stencils.chunks_mut(width.max(1)).enumerate() {
            self.engine.framebuffer.read_stencil(0, y as i32, row);
        }
        stencils
    }

    /// `each` values for each pixel, once all is drawn; none where there is no memory, which is recorded.
    #[track_caller]
    fn whole_framebuffer<T: Clone>(&mut self, name: &'static str, each: usize, value: T) -> Vec<T> {
        self.engine.flush_scene();
        let (width, height) = self.size();
        let len = width as usize * height as usize * each;
        let mut values = Vec::new();
        if values.try_reserve_exact(len).is_err() {
            return self.fail(name, out_of_memory(format!("no memory for {len} values of the framebuffer")));
        }
        values.resize(len, value);
        values
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
