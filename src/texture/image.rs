//! One image of a texture (OpenGL 1.5, section 3.8.1): a level of a 1D, 2D, 3D or rectangle texture or of a cube face.
//! Texels are stored as a sampler reads them: already converted to the internal format and expanded from its base format.
//! Every dimension that the target has is padded by one texel on both sides. The ring holds the image's own border
//! texels when it has a border, else what the wrap modes need there ([`Image::fill_padding`]), so that a linear filter
//! reads texels i and i + 1 for every i in -1..N and wraps no index.

use super::format::{BaseFormat, BlockFit, InternalFormat, Storage};
use super::padding::PaddingKey;
use crate::enums::GLenum;
use crate::error::{Outcome, out_of_memory};
use crate::limits::MAX_IMAGE_BYTES;
use std::sync::Arc;

/// How many dimensions of an image are padded: those that its target has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimensions {
    /// TEXTURE_1D: width.
    One,
    /// TEXTURE_2D, TEXTURE_RECTANGLE, cube faces: width and height.
    Two,
    /// TEXTURE_3D: width, height and depth.
    Three,
}

impl Dimensions {
    /// How many there are.
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Dimensions::One => 1,
            Dimensions::Two => 2,
            Dimensions::Three => 3,
        }
    }
}

/// A texel of floats, or one before it is rounded.
pub type FloatTexel = [f32; 4];

/// The texels of an image with its ring, row after row, slice after slice.
#[derive(Clone, Debug, PartialEq)]
pub enum Texels {
    /// Bytes R, G, B, A from low to high.
    Rgba8(Vec<u32>),
    /// R, G, B, A of the formats with more than 8 bits a component.
    Float(Vec<FloatTexel>),
    /// Depths in [0, 1].
    Depth(Vec<f32>),
}

/// A texture image.
#[derive(Clone, Debug)]
pub struct Image {
    /// What TEXTURE_INTERNAL_FORMAT reports.
    pub internal_format: GLenum,
    /// The row of the format table.
    pub format: &'static InternalFormat,
    /// Which components the image has.
    pub base: BaseFormat,
    /// Which dimensions are padded.
    pub dimensions: Dimensions,
    /// Width of the interior (without border).
    pub width: u32,
    /// Height of the interior; 1 for 1D images.
    pub height: u32,
    /// Depth of the interior; 1 for 1D and 2D images.
    pub depth: u32,
    /// 0 or 1: whether the ring holds border texels of the image.
    pub border: u32,
    /// The texels with the ring around them, which [`Image::fill_padding`] fills.
    pub texels: Texels,
    /// The stencil indices beside the depths of a DEPTH_STENCIL image, at the places of the texels.
    pub stencil: Option<Vec<u8>>,
    /// The S3TC blocks of a compressed image as they were given; `texels` holds them decoded.
    pub compressed: Option<Vec<u8>>,
    /// How its blocks are chosen when texels are given uncompressed: the TEXTURE_COMPRESSION_HINT of the command that
    /// specified it. Parts written later and the levels below it follow.
    pub fit: BlockFit,
    /// Whether alpha is known to be 255 in every texel, border texels included.
    pub(super) opaque: bool,
    /// What the ring is filled for now; `None` when it holds border texels or nothing yet.
    pub(super) padded_for: Option<PaddingKey>,
    /// The texels with their border, kept while the ring of a bordered image is filled for other wraps.
    pub(super) bordered: Option<Box<Texels>>,
}

impl Texels {
    /// `len` texels of zero, or OUT_OF_MEMORY.
    pub fn zeroed(storage: Storage, len: usize) -> Outcome<Texels> {
        Ok(match storage {
            Storage::Rgba8 => Texels::Rgba8(zeroed(len, 0)?),
            Storage::Float => Texels::Float(zeroed(len, [0.0; 4])?),
            Storage::Depth => Texels::Depth(zeroed(len, 0.0)?),
        })
    }

    /// A copy, or OUT_OF_MEMORY.
    pub fn try_clone(&self) -> Outcome<Texels> {
        Ok(match self {
            Texels::Rgba8(t) => Texels::Rgba8(copy(t)?),
            Texels::Float(t) => Texels::Float(copy(t)?),
            Texels::Depth(t) => Texels::Depth(copy(t)?),
        })
    }

    /// How many texels there are, ring included.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Texels::Rgba8(t) => t.len(),
            Texels::Float(t) => t.len(),
            Texels::Depth(t) => t.len(),
        }
    }
}

/// A copy of texels, or OUT_OF_MEMORY.
fn copy<T: Copy>(from: &[T]) -> Outcome<Vec<T>> {
    let mut to = Vec::new();
    to.try_reserve_exact(from.len()).map_err(|_| out_of_memory(format!("no memory to copy {} texels", from.len())))?;
    to.extend_from_slice(from);
    Ok(to)
}

/// A buffer of a size that a program chose: OUT_OF_MEMORY instead of an abort.
pub(crate) fn zeroed<T: Clone>(len: usize, value: T) -> Outcome<Vec<T>> {
    let mut buffer = Vec::new();
    buffer.try_reserve_exact(len).map_err(|_| {
        out_of_memory(format!("no memory for {len} texels; use a smaller image, or ask a PROXY target"))
    })?;
    buffer.resize(len, value);
    Ok(buffer)
}

impl Image {
    /// An image of zeros. `size` is the interior: the width, height and depth of the command less twice the border in
    /// each dimension that the target has, 1 in the others. S3TC needs two dimensions and no border; elsewhere such a
    /// format gives way to its base format, as the specification has it for compressed formats with restrictions.
    pub fn new(format: &'static InternalFormat, dimensions: Dimensions, size: [u32; 3], border: u32) -> Outcome<Image> {
        let format = if dimensions != Dimensions::Two || border != 0 { format.uncompressed() } else { format };
        let [width, height, depth] = match dimensions {
            Dimensions::One => [size[0], 1, 1],
            Dimensions::Two => [size[0], size[1], 1],
            Dimensions::Three => size,
        };
        let padded = |n: u32, has: bool| if has { u64::from(n) + 2 } else { u64::from(n) };
        let len = [
            padded(width, true),
            padded(height, dimensions != Dimensions::One),
            padded(depth, dimensions == Dimensions::Three),
        ]
        .into_iter()
        .try_fold(1u64, u64::checked_mul)
        .filter(|&len| len <= MAX_IMAGE_BYTES / format.storage.bytes() * 2)
        .and_then(|len| usize::try_from(len).ok())
        .ok_or_else(|| out_of_memory(format!("an image of {width}x{height}x{depth} texels is beyond memory")))?;
        Ok(Image {
            internal_format: format.reported,
            format,
            base: format.base,
            dimensions,
            width,
            height,
            depth,
            border,
            texels: Texels::zeroed(format.storage, len)?,
            stencil: (format.stencil_bits > 0).then(|| zeroed(len, 0)).transpose()?,
            compressed: None,
            fit: BlockFit::default(),
            opaque: false,
            padded_for: None,
            bordered: None,
        })
    }

    /// The image in an `Arc`, to be written: the same memory where nobody else holds it, else a copy.
    pub fn writable(image: &mut Arc<Image>) -> Outcome<&mut Image> {
        if Arc::get_mut(image).is_none() {
            *image = Arc::new(image.try_clone()?);
        }
        Arc::get_mut(image).ok_or_else(|| out_of_memory("no memory for a copy of the image"))
    }

    /// A copy, or OUT_OF_MEMORY.
    pub fn try_clone(&self) -> Outcome<Image> {
        let bordered = self.bordered.as_ref().map(|texels| texels.try_clone().map(Box::new)).transpose()?;
        Ok(Image {
            texels: self.texels.try_clone()?,
            stencil: self.stencil.as_deref().map(copy).transpose()?,
            compressed: self.compressed.as_deref().map(copy).transpose()?,
            bordered,
            padded_for: self.padded_for,
            ..*self
        })
    }

    /// Whether an image that [`Image::new`] would make has the shape and format of this one, `size` with the border. Not
    /// so for compressed images, which keep their blocks too.
    #[must_use]
    pub fn is_like(&self, format: &InternalFormat, dimensions: Dimensions, size: [u32; 3], border: u32) -> bool {
        std::ptr::eq(self.format, format)
            && self.internal_format == format.reported
            && self.compressed.is_none()
            && (self.dimensions, self.border) == (dimensions, border)
            && self.full_size() == size
    }

    /// Whether a sampler finds alpha 255 wherever it looks: in the texels, and in the ring as it is filled now.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.opaque && (self.border != 0 || self.padded_for.is_some_and(|key| !key.reads_border()))
    }

    /// Texels from one row to the next.
    #[inline]
    #[must_use]
    pub fn row_stride(&self) -> usize {
        self.width as usize + 2
    }

    /// Texels from one slice to the next.
    #[inline]
    #[must_use]
    pub fn slice_stride(&self) -> usize {
        let rows = if self.dimensions == Dimensions::One { 1 } else { self.height as usize + 2 };
        self.row_stride() * rows
    }

    /// The index of the interior's texel (0, 0, 0).
    #[inline]
    #[must_use]
    pub fn origin(&self) -> usize {
        match self.dimensions {
            Dimensions::One => 1,
            Dimensions::Two => self.row_stride() + 1,
            Dimensions::Three => self.slice_stride() + self.row_stride() + 1,
        }
    }

    /// The index of texel (i, j, k), each from -1 to N in the dimensions that the target has and 0 in the others.
    #[inline]
    #[must_use]
    pub fn index(&self, i: i32, j: i32, k: i32) -> usize {
        self.origin()
            .wrapping_add_signed(k as isize * self.slice_stride() as isize)
            .wrapping_add_signed(j as isize * self.row_stride() as isize)
            .wrapping_add_signed(i as isize)
    }

    /// Width, height and depth as the commands count them: with the border.
    #[must_use]
    pub fn full_size(&self) -> [u32; 3] {
        let b = 2 * self.border;
        match self.dimensions {
            Dimensions::One => [self.width + b, 1, 1],
            Dimensions::Two => [self.width + b, self.height + b, 1],
            Dimensions::Three => [self.width + b, self.height + b, self.depth + b],
        }
    }

    /// Whether a dimension is 0: such an image counts as not defined.
    #[must_use]
    pub fn is_null(&self) -> bool {
        self.width == 0 || self.height == 0 || self.depth == 0
    }

    /// The texels that belong to the image: with its border, whatever the ring is filled for now.
    #[must_use]
    pub fn own_texels(&self) -> &Texels {
        self.bordered.as_deref().unwrap_or(&self.texels)
    }

    /// Texel (i, j, k) as a sampler reads it; a depth gives (d, d, d, 1). Zero outside the ring.
    #[cfg(test)]
    pub fn texel(&self, i: i32, j: i32, k: i32) -> [f32; 4] {
        let inside = |v: i32, n: u32, has: bool| if has { v >= -1 && i64::from(v) <= i64::from(n) } else { v == 0 };
        if !inside(i, self.width, true)
            || !inside(j, self.height, self.dimensions != Dimensions::One)
            || !inside(k, self.depth, self.dimensions == Dimensions::Three)
        {
            return [0.0; 4];
        }
        let at = self.index(i, j, k);
        match &self.texels {
            Texels::Rgba8(t) => t.get(at).map_or([0.0; 4], |t| t.to_le_bytes().map(|c| f32::from(c) / 255.0)),
            Texels::Float(t) => t.get(at).copied().unwrap_or_default(),
            Texels::Depth(t) => t.get(at).map_or([0.0; 4], |&d| [d, d, d, 1.0]),
        }
    }
}
