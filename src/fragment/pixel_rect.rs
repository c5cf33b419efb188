//! Pixel rectangles as a source of fragments (OpenGL 1.5, section 3.6.4): DrawPixels and CopyPixels give each fragment a
//! colour or a depth of its own, where a primitive has planes. The zoom is resolved before, so that there is a value for
//! each pixel.

/// What a pixel rectangle gives its fragments, row by row from below.
#[derive(Clone, Debug)]
pub enum PixelValues {
    /// Colours as packed bytes R, G, B, A.
    Packed(Vec<u32>),
    /// Colours in [0, 1].
    Colors(Vec<[f32; 4]>),
    /// Depths in units of the depth buffer.
    Depths(Vec<u32>),
}

/// The values of one DrawPixels or CopyPixels; that of the primitive's origin comes first.
#[derive(Clone, Debug)]
pub struct PixelRect {
    /// Width in pixels.
    pub width: u32,
    /// A value for each pixel.
    pub values: PixelValues,
}

impl PixelRect {
    /// Bytes of memory that it takes.
    #[must_use]
    pub fn memory(&self) -> usize {
        match &self.values {
            PixelValues::Packed(v) | PixelValues::Depths(v) => size_of_val(&v[..]),
            PixelValues::Colors(v) => size_of_val(&v[..]),
        }
    }

    /// The index of the value of a pixel, relative to the primitive's origin.
    #[inline(always)]
    #[must_use]
    pub fn index(&self, x: i32, y: i32) -> usize {
        (y as usize).wrapping_mul(self.width as usize).wrapping_add(x as usize)
    }

    /// The packed colours from a pixel on.
    #[inline(always)]
    #[must_use]
    pub fn packed_from(&self, x: i32, y: i32) -> Option<&[u32]> {
        match &self.values {
            PixelValues::Packed(colors) => colors.get(self.index(x, y)..),
            _ => None,
        }
    }
}
