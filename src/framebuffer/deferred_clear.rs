//! Deferred clears (OpenGL 1.5, section 4.2.3). A clear of whole buffers is only noted. When the next scene is drawn, the
//! worker thread of each band fills it just before it draws into it, so that the band is in the cache already. Anything
//! that reads the framebuffer without drawing first calls [`Framebuffer::apply_deferred_clear`].

use super::{Band, Clear, Framebuffer, Rect};
use crate::num::{clamp01, f32_to_u8};

/// What whole buffers are filled with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeferredClear {
    /// The colour, packed and as floats.
    pub(super) color: Option<(u32, [f32; 4])>,
    pub(super) depth: Option<u32>,
    pub(super) stencil: Option<u8>,
}

impl Framebuffer {
    /// [`clear`](Self::clear), deferred where it fills whole buffers.
    pub fn defer_clear(&mut self, clear: &Clear, scissor: Option<Rect>) -> crate::error::Outcome {
        self.apply_deferred_clear();
        let all = self.rect(0, 0, i32::MAX, i32::MAX);
        let whole = scissor.is_none_or(|rect| rect == all)
            && clear.accum.is_none()
            && clear.color.is_none_or(|(_, mask)| mask == [true; 4])
            && clear.stencil.is_none_or(|(_, mask)| mask == 0xFF);
        if !whole {
            return self.clear(clear, scissor);
        }
        self.deferred = Some(DeferredClear {
            color: clear.color.map(|(color, _)| {
                let color = self.stored(color);
                (u32::from_le_bytes(color.map(f32_to_u8)), color.map(clamp01))
            }),
            depth: clear.depth.map(|depth| self.depth_value(depth)),
            stencil: clear.stencil.map(|(value, _)| value),
        });
        Ok(())
    }

    /// Whether a clear is deferred.
    #[must_use]
    pub fn has_deferred_clear(&self) -> bool {
        self.deferred.is_some()
    }

    /// Forgets the deferred clear.
    pub fn forget_deferred_clear(&mut self) {
        self.deferred = None;
    }

    /// Carries out the deferred clear, if there is one.
    pub fn apply_deferred_clear(&mut self) {
        if self.deferred.is_some() {
            self.band();
        }
    }
}

/// Fills rows of `width`, `stride` apart, but nothing between them.
fn fill<T: Copy>(pixels: &mut [T], value: T, width: u32, stride: u32) {
    if width == stride {
        pixels.fill(value);
    } else {
        for row in pixels.chunks_mut(stride.max(1) as usize) {
            let width = row.len().min(width as usize);
            if let Some(row) = row.get_mut(..width) {
                row.fill(value);
            }
        }
    }
}

impl Band<'_> {
    /// Carries out the deferred clear of the band, if there is one. To be called before the band is drawn into.
    pub fn apply_deferred_clear(&mut self) {
        let Some(clear) = self.deferred.take() else { return };
        if let Some((packed, float)) = clear.color {
            fill(self.rgba8, packed, self.width, self.stride);
            fill(self.float, float, self.width, self.stride);
        }
        if let Some(depth) = clear.depth {
            fill(self.depth, depth, self.width, self.stride);
            self.hier_z.cleared(depth);
        }
        if let Some(stencil) = clear.stencil {
            fill(self.stencil, stencil, self.width, self.stride);
        }
    }
}
