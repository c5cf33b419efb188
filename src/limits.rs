//! The implementation-dependent limits (OpenGL 1.5, table 6.28 to 6.31), in one place: what `glGet` reports and what the
//! code sizes its arrays by.

/// Texture units with coordinates, images, generation and environment.
pub const MAX_TEXTURE_UNITS: usize = 8;
/// Light sources.
pub const MAX_LIGHTS: usize = 8;
/// User clip planes.
pub const MAX_CLIP_PLANES: usize = 6;
/// Depth of the modelview stack.
pub const MAX_MODELVIEW_STACK_DEPTH: usize = 32;
/// Depth of the projection stack.
pub const MAX_PROJECTION_STACK_DEPTH: usize = 32;
/// Depth of each unit's texture stack.
pub const MAX_TEXTURE_STACK_DEPTH: usize = 10;
/// Depth of the colour matrix stack.
pub const MAX_COLOR_MATRIX_STACK_DEPTH: usize = 10;
/// Depth of the server attribute stack.
pub const MAX_ATTRIB_STACK_DEPTH: usize = 16;
/// Depth of the client attribute stack.
pub const MAX_CLIENT_ATTRIB_STACK_DEPTH: usize = 16;
/// Depth of the selection name stack.
pub const MAX_NAME_STACK_DEPTH: usize = 128;
/// Nesting of display lists.
pub const MAX_LIST_NESTING: usize = 64;
/// Greatest width or height of a 1D, 2D, cube face or rectangle image, without border.
pub const MAX_TEXTURE_SIZE: u32 = 8192;
/// Greatest extent of a 3D image, without border.
pub const MAX_3D_TEXTURE_SIZE: u32 = 1024;
/// Levels that a texture of the greatest size has.
pub const MAX_TEXTURE_LEVELS: usize = 14;
/// Greatest number of bytes of one image as it is kept; beyond it a proxy says no and an image is `GL_OUT_OF_MEMORY`.
pub const MAX_IMAGE_BYTES: u64 = 1 << 30;
/// Greatest number of bytes of a buffer object; beyond it `GL_OUT_OF_MEMORY`.
pub const MAX_BUFFER_BYTES: usize = 1 << 30;
/// Greatest absolute LOD bias.
pub const MAX_TEXTURE_LOD_BIAS: f32 = 14.0;
/// Greatest degree of anisotropy.
pub const MAX_TEXTURE_MAX_ANISOTROPY: f32 = 16.0;
/// Greatest viewport and framebuffer extent.
pub const MAX_VIEWPORT_DIM: u32 = 16384;
/// Fraction bits of a window position.
pub const SUBPIXEL_BITS: u32 = 8;
/// Greatest length of a pixel map.
pub const MAX_PIXEL_MAP_TABLE: usize = 256;
/// Greatest order of an evaluator polynomial.
pub const MAX_EVAL_ORDER: usize = 30;
/// Greatest width and height of a convolution filter.
pub const MAX_CONVOLUTION_SIZE: usize = 11;
/// Range of aliased point sizes.
pub const POINT_SIZE_RANGE: [f32; 2] = [1.0, 256.0];
/// Range of aliased line widths.
pub const LINE_WIDTH_RANGE: [f32; 2] = [1.0, 256.0];
