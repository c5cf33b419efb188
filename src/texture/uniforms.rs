//! The numbers that the stages of a sampler read (OpenGL 1.5, sections 3.8.8 to 3.8.9): the images from the base level to
//! the last one that may be used, with their sizes as floats, and the level-of-detail parameters. Everything is worked out
//! once a draw, so that a stage finds what it needs where it needs it.

use super::batch::TexBatch;
use super::image::Image;
use super::mipmap::levels_below;
use super::object::TextureObject;
use super::rho_ranges::level_ranges;
use crate::limits::{MAX_TEXTURE_LEVELS, MAX_TEXTURE_LOD_BIAS};
use crate::num::{clamp_f32, max_f32, min_f32};
use crate::simd::Stage;
use crate::state::compare::CompareFunc;
use crate::state::texture::Target;
use std::sync::Arc;

/// A stage of a sampler.
pub type TexFn = for<'a, 'b> unsafe fn(&'a mut TexBatch, &'b SamplerUniforms, u32);

/// Stages of samplers that are one function each, a row a stage: `NAME [cost] = function;`, or with more arguments
/// `NAME [cost] = function, argument;`.
macro_rules! sampler_stages {
    ($($(#[$meta:meta])* $name:ident [$cost:expr] = $run:expr $(, $more:expr)*;)*) => {
        $crate::simd::stage! {$(
            $(#[$meta])*
            pub fn $name: $crate::texture::uniforms::TexFn [$cost] = (b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
                $run(b, u, arg $(, $more)*);
            }
        )*}
    };
}
pub(crate) use sampler_stages;

/// The stage for so many coordinates, of those for one, two and three.
pub fn by_dims(dims: usize, [one, two, three]: [&'static Stage<TexFn>; 3]) -> &'static Stage<TexFn> {
    match dims {
        1 => one,
        2 => two,
        _ => three,
    }
}

/// An image as a sampler sees it.
#[derive(Clone, Debug)]
pub struct MipLevel {
    /// The image, its ring filled for the wraps of the object.
    pub image: Arc<Image>,
    /// Width, height and depth.
    pub size: [f32; 3],
    /// Texels from one row to the next.
    pub stride: u32,
    /// Texels from one slice to the next.
    pub slice: u32,
    /// Index of texel (0, 0, 0).
    pub origin: u32,
}

impl MipLevel {
    fn new(image: &Arc<Image>) -> Self {
        Self {
            image: Arc::clone(image),
            size: [image.width as f32, image.height as f32, image.depth as f32],
            stride: image.row_stride() as u32,
            slice: image.slice_stride() as u32,
            origin: image.origin() as u32,
        }
    }
}

/// The images of 8-bit texels that a sampler reads, of K dimensions: one, or one of many levels.
#[derive(Clone, Debug)]
pub struct WrappedImage<const K: usize> {
    /// The images, from the base level on; only the first is read where the sampler has no levels to choose from.
    pub levels: Vec<MipLevel>,
    /// For each coordinate whether it is wrapped by REPEAT; by CLAMP or CLAMP_TO_EDGE where not.
    pub repeats: [bool; K],
}

/// Images that are filtered linearly, by their dimensions and channels.
#[derive(Clone, Debug)]
pub enum LinearImage {
    /// Three channels of 2D images; alpha is 1.
    Rgb(WrappedImage<2>),
    /// All channels of 2D images.
    Rgba(WrappedImage<2>),
    /// Three channels of 3D images; alpha is 1.
    Rgb3d(WrappedImage<3>),
}

/// What the stages of one unit's sampler read.
#[derive(Clone, Debug)]
pub struct SamplerUniforms {
    /// The unit, which is where the texels go.
    pub unit: usize,
    /// The images: all levels of the first face from the base level on, then those of the next face.
    pub images: Vec<MipLevel>,
    /// How many images further the next face starts: 0 for textures that have no faces.
    pub face_step: usize,
    /// Size of the base level; lambda is measured in its texels.
    pub size: [f32; 3],
    /// Texels per unit of the coordinate at the base level: `size`, or 1 for rectangles.
    pub scale: [f32; 3],
    /// Whether coordinates count texels (rectangles).
    pub unnormalised: bool,
    /// LOD bias of the object and the unit, limited to MAX_TEXTURE_LOD_BIAS.
    pub bias: f32,
    /// Least level of detail.
    pub min_lod: f32,
    /// Greatest level of detail.
    pub max_lod: f32,
    /// The last level, counted from the base level.
    pub last: f32,
    /// Up to which level of detail the texture is magnified: 0 or 0.5.
    pub magnify_below: f32,
    /// Whether magnified fragments read the nearest texel and minified ones filter (else the other way round). Only
    /// read where the two differ.
    pub magnify_nearest: bool,
    /// For each level the squares of rho with which it is certainly the nearest ([`level_ranges`]).
    pub level_ranges: Vec<[f32; 2]>,
    /// Greatest number of taps of the anisotropic filter.
    pub max_taps: f32,
    /// TEXTURE_COMPARE_FUNC.
    pub compare_func: CompareFunc,
}

/// The base level and the last level that a filter of `object` may read (p and q of section 3.8.8): TEXTURE_MAX_LEVEL,
/// the level of size 1 or the last one that is there, whichever comes first.
#[must_use]
pub fn level_range(object: &TextureObject) -> (usize, usize) {
    let p = &object.parameters;
    let top = MAX_TEXTURE_LEVELS as i32 - 1;
    let base = if object.target == Target::Rectangle { 0 } else { p.base_level.clamp(0, top) as usize };
    let mipmapped = p.min_filter.has_mipmaps() && object.target != Target::Rectangle;
    let Some(image) = object.image(0, base).filter(|_| mipmapped) else { return (base, base) };
    let last = (base + levels_below([image.width, image.height, image.depth]))
        .min(p.max_level.clamp(0, top) as usize)
        .max(base);
    let there = |level: usize| (0..object.faces.len()).all(|face| object.image(face, level).is_some());
    let last = (base..=last).take_while(|&level| there(level)).last().unwrap_or(base);
    (base, last)
}

impl SamplerUniforms {
    /// The uniforms of a texture object with a unit's LOD bias.
    #[must_use]
    pub fn new(object: &TextureObject, unit_bias: f32, unit: usize) -> Self {
        let p = &object.parameters;
        let (base, last) = level_range(object);
        let images: Vec<MipLevel> = (0..object.faces.len())
            .flat_map(|face| (base..=last).filter_map(move |level| object.image(face, level)))
            .map(MipLevel::new)
            .collect();
        let size = images.first().map_or([1.0; 3], |image| image.size);
        let unnormalised = object.target == Target::Rectangle;
        let sharper = p.mag_filter.is_linear() && p.min_filter.has_mipmaps() && !p.min_filter.is_linear();
        let magnify_below = if sharper { 0.5 } else { 0.0 };
        let bias = clamp_f32(p.lod_bias + unit_bias, -MAX_TEXTURE_LOD_BIAS, MAX_TEXTURE_LOD_BIAS);
        Self {
            unit,
            images,
            face_step: if object.faces.len() > 1 { last - base + 1 } else { 0 },
            size,
            scale: if unnormalised { [1.0; 3] } else { size },
            unnormalised,
            bias,
            min_lod: p.min_lod,
            max_lod: p.max_lod,
            last: (last - base) as f32,
            magnify_below,
            level_ranges: level_ranges(bias, p.min_lod, p.max_lod, (last - base) as f32),
            magnify_nearest: !p.mag_filter.is_linear(),
            max_taps: max_f32(1.0, min_f32(p.max_anisotropy, crate::limits::MAX_TEXTURE_MAX_ANISOTROPY)).trunc(),
            compare_func: p.compare_func,
        }
    }
}
