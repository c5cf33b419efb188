//! The framebuffer (OpenGL 1.5, chapter 4): colour, depth, stencil and accumulation buffers of one size. Colours are
//! packed RGBA bytes, in memory of the library or of the client, or floats where a client asked for floats. All buffers
//! have the same row order and the same distance between rows, so that one offset finds a pixel in all of them.

mod accum;
mod band;
mod clear;
mod deferred_clear;
mod hier_z;
mod rows;
mod user_memory;

pub use accum::AccumOp;
pub use band::Band;
pub(crate) use clear::packed_mask;
pub use clear::{Clear, Rect};
pub use deferred_clear::DeferredClear;
pub use hier_z::BLOCK;
pub use user_memory::UserMemory;

use crate::error::{Outcome, invalid_value, out_of_memory};
use crate::limits::MAX_VIEWPORT_DIM;

/// What the buffers hold: what `glGet` reports of them and what the fragment stages are built for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct FramebufferFormat {
    /// Bits of red, green, blue and alpha: 8 each, 32 for floats; alpha may have none and then always reads as 1.
    pub color_bits: [u8; 4],
    /// Whether colours are stored as floats.
    pub float: bool,
    /// Bits of depth: 0 (no buffer), 16, 24 or 32.
    pub depth_bits: u8,
    /// Bits of stencil: 0 (no buffer) or 8.
    pub stencil_bits: u8,
    /// Bits of each channel of the accumulation buffer: 0 (no buffer) or, since it holds floats, 16 at least.
    pub accum_bits: u8,
}

impl Default for FramebufferFormat {
    fn default() -> Self {
        Self { color_bits: [8; 4], float: false, depth_bits: 24, stencil_bits: 8, accum_bits: 16 }
    }
}

impl FramebufferFormat {
    /// The largest depth value, which stands for 1.
    #[must_use]
    pub fn depth_max(&self) -> u32 {
        match self.depth_bits {
            0 => 0,
            bits => u32::MAX >> (32 - u32::from(bits).min(32)),
        }
    }

    /// A depth as the buffer holds it: limited to [0, 1] (NaN gives 0), in units of the buffer, rounded to the nearest.
    #[must_use]
    pub fn quantised_depth(&self, depth: f64) -> u32 {
        let limited = if depth > 0.0 { depth.min(1.0) } else { 0.0 };
        (limited * f64::from(self.depth_max())).round_ties_even() as u32
    }
}

/// Where colours are kept.
#[derive(Debug)]
enum ColorStore {
    /// Packed bytes in memory of the library.
    Owned(Vec<u32>),
    /// Packed bytes in memory of the client.
    User(UserMemory),
    /// Floats.
    Float(Vec<[f32; 4]>),
}

impl ColorStore {
    /// The packed and the float pixels; one of the two is empty.
    fn slices(&self) -> (&[u32], &[[f32; 4]]) {
        match self {
            Self::Owned(v) => (v, &[]),
            Self::User(m) => (m.pixels(), &[]),
            Self::Float(v) => (&[], v),
        }
    }

    /// The same to write.
    fn slices_mut(&mut self) -> (&mut [u32], &mut [[f32; 4]]) {
        match self {
            Self::Owned(v) => (v, &mut []),
            Self::User(m) => (m.pixels_mut(), &mut []),
            Self::Float(v) => (&mut [], v),
        }
    }
}

/// All buffers that a context draws into.
#[derive(Debug)]
pub struct Framebuffer {
    width: u32,
    height: u32,
    stride: u32,
    flipped: bool,
    format: FramebufferFormat,
    color: ColorStore,
    depth: Vec<u32>,
    hier_z: Vec<u32>,
    stencil: Vec<u8>,
    accum: Vec<[f32; 4]>,
    /// A clear of whole buffers that is carried out when something is drawn or read.
    deferred: Option<DeferredClear>,
}

/// A buffer of `len` equal values, or OUT_OF_MEMORY.
fn filled<T: Clone>(len: usize, value: T, what: &str) -> Outcome<Vec<T>> {
    let mut buffer = Vec::new();
    buffer
        .try_reserve_exact(len)
        .map_err(|_| out_of_memory(format!("no memory for a {what} buffer of {len} pixels; use a smaller window")))?;
    buffer.resize(len, value);
    Ok(buffer)
}

/// Checks a size and gives the number of pixels from the first to the last.
fn pixel_count(width: u32, height: u32, stride: u32) -> Outcome<usize> {
    if width > MAX_VIEWPORT_DIM || height > MAX_VIEWPORT_DIM {
        return Err(invalid_value(format!(
            "a framebuffer of {width}x{height} pixels is too large; the limit is {MAX_VIEWPORT_DIM} each way"
        )));
    }
    if stride < width {
        return Err(invalid_value(format!("a row length of {stride} pixels is less than the width, {width}")));
    }
    let len = if width == 0 || height == 0 { 0 } else { u64::from(stride) * u64::from(height - 1) + u64::from(width) };
    // Offsets within the buffers are u32.
    match u32::try_from(len) {
        Ok(len) => Ok(len as usize),
        Err(_) => {
            Err(out_of_memory(format!("rows of {stride} pixels make the framebuffer too large; use shorter rows")))
        }
    }
}

impl Framebuffer {
    /// A framebuffer without pixels.
    #[must_use]
    pub fn empty(format: FramebufferFormat) -> Self {
        let color = if format.float { ColorStore::Float(Vec::new()) } else { ColorStore::Owned(Vec::new()) };
        Self {
            width: 0,
            height: 0,
            stride: 0,
            flipped: false,
            format,
            color,
            depth: Vec::new(),
            hier_z: Vec::new(),
            stencil: Vec::new(),
            accum: Vec::new(),
            deferred: None,
        }
    }

    /// A framebuffer in memory of the library: colours and stencil 0, depth 1.
    pub fn new(width: u32, height: u32, format: FramebufferFormat) -> Outcome<Self> {
        let len = pixel_count(width, height, width)?;
        let color = if format.float {
            ColorStore::Float(filled(len, [0.0, 0.0, 0.0, no_alpha_float(&format)], "colour")?)
        } else {
            ColorStore::Owned(filled(len, no_alpha_bits(&format), "colour")?)
        };
        Self::with_store(width, height, width, false, format, color, len)
    }

    /// A framebuffer whose colours are in the client's memory: rows `row_length` pixels apart, the lowest first unless
    /// `flipped`. The pixels stay as they are. `memory` must have `row_length * (height - 1) + width` pixels at least.
    #[cfg_attr(not(any(test, feature = "capi")), expect(dead_code, reason = "only C hands over its own memory"))]
    pub fn with_user_memory(
        width: u32,
        height: u32,
        row_length: u32,
        flipped: bool,
        format: FramebufferFormat,
        memory: UserMemory,
    ) -> Outcome<Self> {
        let len = pixel_count(width, height, row_length)?;
        if memory.pixels().len() < len {
            return Err(invalid_value(format!(
                "the colour memory has {} pixels; {width}x{height} with rows of {row_length} needs {len}",
                memory.pixels().len()
            )));
        }
        let mut memory = memory;
        memory.truncate(len);
        let format = FramebufferFormat { float: false, ..format };
        Self::with_store(width, height, row_length, flipped, format, ColorStore::User(memory), len)
    }

    fn with_store(
        width: u32,
        height: u32,
        stride: u32,
        flipped: bool,
        format: FramebufferFormat,
        color: ColorStore,
        len: usize,
    ) -> Outcome<Self> {
        let depth = filled(if format.depth_bits == 0 { 0 } else { len }, format.depth_max(), "depth")?;
        let blocks = if format.depth_bits == 0 { 0 } else { hier_z::columns(width) * height as usize };
        let hier_z = filled(blocks, format.depth_max(), "coarse depth")?;
        let stencil = filled(if format.stencil_bits == 0 { 0 } else { len }, 0, "stencil")?;
        Ok(Self {
            width,
            height,
            stride,
            flipped,
            format,
            color,
            depth,
            hier_z,
            stencil,
            accum: Vec::new(),
            deferred: None,
        })
    }

    /// Changes the size of a framebuffer in the library's memory; contents start anew, as in [`Framebuffer::new`].
    /// A framebuffer in the client's memory must be made anew instead, since the memory has a size of its own.
    pub fn resize(&mut self, width: u32, height: u32) -> Outcome {
        *self = Self::new(width, height, self.format)?;
        Ok(())
    }

    /// Takes the buffers out. What is left knows its size and format and has no pixels.
    #[must_use]
    pub fn take(&mut self) -> Self {
        let Self { width, height, stride, flipped, format, .. } = *self;
        let rest = Self { width, height, stride, flipped, ..Self::empty(format) };
        std::mem::replace(self, rest)
    }

    /// Pixels of a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Number of rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What the buffers hold.
    #[must_use]
    pub fn format(&self) -> &FramebufferFormat {
        &self.format
    }

    /// Index of the first pixel of row `y` in every buffer; `None` above the top.
    fn row_start(&self, y: u32) -> Option<usize> {
        let row = if self.flipped { self.height.checked_sub(1)?.checked_sub(y)? } else { y };
        (y < self.height).then_some(row as usize * self.stride as usize)
    }
}

/// The packed bits that a format without alpha has set in every pixel, so that alpha reads as 1.
pub(crate) fn no_alpha_bits(format: &FramebufferFormat) -> u32 {
    if format.color_bits[3] == 0 { 0xFF00_0000 } else { 0 }
}

/// The alpha of a fresh float pixel.
fn no_alpha_float(format: &FramebufferFormat) -> f32 {
    if format.color_bits[3] == 0 { 1.0 } else { 0.0 }
}

#[cfg(test)]
mod tests;
