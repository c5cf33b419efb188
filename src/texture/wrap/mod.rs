//! Wrapping (OpenGL 1.5, sections 3.8.7 and 3.8.8): from a texture coordinate to the texels around it. [`row`] is the one
//! place that knows what a wrap mode needs; `general` holds the stages for any coordinates, `bounded` the shorter forms
//! for coordinates whose bounds are known.

pub mod bounded;
pub mod general;

use super::padding::Padding;
use super::uniforms::TexFn;
use crate::simd::Stage;
use crate::state::texture::WrapMode;
use general::*;

/// What sampling knows of a wrap mode.
#[derive(Clone, Copy, Debug)]
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
    /// Whether rectangle textures have the mode.
    pub on_rectangles: bool,
}

/// The row of a wrap mode.
#[must_use]
pub const fn row(mode: WrapMode) -> Wrap {
    let (linear, nearest, padding, period, repeats, on_rectangles) = match mode {
        WrapMode::Repeat => (&WRAP_REPEAT_LINEAR, &WRAP_REPEAT_NEAREST, Padding::Repeat, 1, Some(true), false),
        WrapMode::Clamp => (&WRAP_CLAMP_LINEAR, &WRAP_CLAMP_NEAREST, Padding::Border, 0, Some(false), true),
        WrapMode::ClampToEdge => (&WRAP_CLAMP_LINEAR, &WRAP_CLAMP_NEAREST, Padding::Edge, 0, Some(false), true),
        WrapMode::ClampToBorder => (&WRAP_BORDER_LINEAR, &WRAP_BORDER_NEAREST, Padding::Border, 0, None, true),
        WrapMode::MirroredRepeat => (&WRAP_MIRRORED_LINEAR, &WRAP_MIRRORED_NEAREST, Padding::Edge, 2, None, false),
        WrapMode::MirrorClamp => {
            (&WRAP_MIRROR_CLAMP_LINEAR, &WRAP_MIRROR_CLAMP_NEAREST, Padding::MirrorBorder, 0, None, false)
        }
        WrapMode::MirrorClampToEdge => {
            (&WRAP_MIRROR_CLAMP_LINEAR, &WRAP_MIRROR_CLAMP_NEAREST, Padding::Edge, 0, None, false)
        }
        WrapMode::MirrorClampToBorder => {
            (&WRAP_MIRROR_BORDER_LINEAR, &WRAP_MIRROR_BORDER_NEAREST, Padding::MirrorBorder, 0, None, false)
        }
    };
    Wrap { linear, nearest, padding, period, repeats, on_rectangles }
}
