//! The proxy textures as data (OpenGL 1.5, section 3.8.11).

use crate::limits::MAX_TEXTURE_LEVELS;
use crate::texture::format::InternalFormat;

/// What a proxy keeps of the image that it was asked about: nothing, if the image does not fit.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Proxy {
    pub(crate) format: Option<&'static InternalFormat>,
    pub(crate) size: [u32; 3],
    pub(crate) border: u32,
}

/// The proxies: one for each target and level.
pub(crate) type Proxies = [[Proxy; MAX_TEXTURE_LEVELS]; 5];
