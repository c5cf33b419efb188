//! Wrapping (OpenGL 1.5, sections 3.8.7 and 3.8.8): from a texture coordinate to the texels around it. [`row`] is the one
//! place that knows what a wrap mode needs; `general` holds the stages for any coordinates, `bounded` the shorter forms
//! for coordinates whose bounds are known.

pub mod bounded;
pub mod general;

use super::padding::Padding;
use super::uniforms::TexFn;
use crate::enums::*;
use crate::simd::Stage;
use general::*;

/// What sampling knows of a wrap mode.
#[derive(Debug)]
pub struct Wrap {
    /// Finds two texels and the weight of the second.
    pub linear: &'static Stage<TexFn>,
    /// Finds the nearest texel.
    pub nearest: &'static Stage<TexFn>,
    /// What stands beyond the two ends of the image.
    pub padding: Padding,
    /// The whole number that may be taken off a coordinate: 1, 2, or 0 for none.
    pub period: u8,
    /// Whether the mode has a form in [`bounded`], and then whether that is REPEAT or CLAMP.
    pub repeats: Option<bool>,
}

const fn wrap(linear: &'static Stage<TexFn>, nearest: &'static Stage<TexFn>, padding: Padding) -> Wrap {
    Wrap { linear, nearest, padding, period: 0, repeats: None }
}

static REPEAT: Wrap =
    Wrap { period: 1, repeats: Some(true), ..wrap(&WRAP_REPEAT_LINEAR, &WRAP_REPEAT_NEAREST, Padding::Repeat) };
static CLAMP: Wrap = Wrap { repeats: Some(false), ..wrap(&WRAP_CLAMP_LINEAR, &WRAP_CLAMP_NEAREST, Padding::Border) };
static CLAMP_TO_EDGE: Wrap =
    Wrap { repeats: Some(false), ..wrap(&WRAP_CLAMP_LINEAR, &WRAP_CLAMP_NEAREST, Padding::Edge) };
static CLAMP_TO_BORDER: Wrap = wrap(&WRAP_BORDER_LINEAR, &WRAP_BORDER_NEAREST, Padding::Border);
static MIRRORED_REPEAT: Wrap = Wrap { period: 2, ..wrap(&WRAP_MIRRORED_LINEAR, &WRAP_MIRRORED_NEAREST, Padding::Edge) };
static MIRROR_CLAMP: Wrap = wrap(&WRAP_MIRROR_CLAMP_LINEAR, &WRAP_MIRROR_CLAMP_NEAREST, Padding::MirrorBorder);
static MIRROR_CLAMP_TO_EDGE: Wrap = wrap(&WRAP_MIRROR_CLAMP_LINEAR, &WRAP_MIRROR_CLAMP_NEAREST, Padding::Edge);
static MIRROR_CLAMP_TO_BORDER: Wrap =
    wrap(&WRAP_MIRROR_BORDER_LINEAR, &WRAP_MIRROR_BORDER_NEAREST, Padding::MirrorBorder);

/// The row of a wrap mode.
#[must_use]
pub fn row(mode: GLenum) -> &'static Wrap {
    match mode {
        GL_CLAMP => &CLAMP,
        GL_CLAMP_TO_EDGE => &CLAMP_TO_EDGE,
        GL_CLAMP_TO_BORDER => &CLAMP_TO_BORDER,
        GL_MIRRORED_REPEAT => &MIRRORED_REPEAT,
        GL_MIRROR_CLAMP_EXT => &MIRROR_CLAMP,
        GL_MIRROR_CLAMP_TO_EDGE_EXT => &MIRROR_CLAMP_TO_EDGE,
        GL_MIRROR_CLAMP_TO_BORDER_EXT => &MIRROR_CLAMP_TO_BORDER,
        _ => &REPEAT,
    }
}
