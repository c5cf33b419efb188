//! Texture objects (OpenGL 1.5, section 3.8.11): the parameters and images that a name stands for. Images are shared
//! (`Arc`) and copied on write, so a draw that was issued earlier keeps the texels it was issued with.

use super::image::Image;
use crate::limits::MAX_TEXTURE_LEVELS;
use crate::state::texture::{Target, TexParameters};
use std::sync::Arc;

/// The images of one face, by level.
pub type MipChain = [Option<Arc<Image>>; MAX_TEXTURE_LEVELS];

/// A texture object.
#[derive(Clone, Debug)]
pub struct TextureObject {
    /// The target that the object was first bound to, which it keeps for ever.
    pub target: Target,
    /// Filters, wraps, levels and the rest of table 6.16.
    pub parameters: TexParameters,
    /// One array of levels, or six for a cube map in the order +x, -x, +y, -y, +z, -z.
    pub faces: Vec<MipChain>,
    /// For each face the levels that GENERATE_MIPMAP has still to make: the base level and the last level. They are made
    /// when they are first read, or before the images that they depend on change in another way.
    pub pending_mip_levels: [Option<(usize, usize)>; 6],
}

impl TextureObject {
    /// An object as it is when its name is first bound to a target: initial parameters, no images.
    #[must_use]
    pub fn new(target: Target) -> Self {
        let faces = if target == Target::Cube { 6 } else { 1 };
        Self {
            target,
            parameters: TexParameters::for_target(target),
            faces: (0..faces).map(|_| std::array::from_fn(|_| None)).collect(),
            pending_mip_levels: [None; 6],
        }
    }

    /// The image of a face and level, if it was given.
    #[must_use]
    pub fn image(&self, face: usize, level: usize) -> Option<&Arc<Image>> {
        self.faces.get(face)?.get(level)?.as_ref()
    }
}
