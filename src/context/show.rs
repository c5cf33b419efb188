//! How a trace shows the arguments of a command: enumerants by name, also where they come as plain numbers, masks by
//! the names of their bits, long arrays cut.

use super::pixels_arg::{ArrayData, Indices, Pixels, PixelsMut};
use crate::enums::{self, *};
use crate::state::color_buffer::{BlendFactor, ColorBufferName};
use crate::state::depth_stencil::StencilOp;
use crate::state::primitive::PrimitiveMode;
use crate::state::texture::TextureCompareMode;
use std::fmt::{Debug, Write};

/// Arrays longer than this are cut in a trace.
const MAX_SHOWN: usize = 16;

/// What the numbers of an argument are, as far as they have names. Values below 0x100 stand for several things: the place
/// of the argument says for which.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Names {
    /// Numbers.
    None,
    /// Enumerants; small values are numbers.
    Enums,
    /// A primitive.
    Primitive,
    /// A blend factor.
    BlendFactor,
    /// A stencil operation.
    StencilOp,
    /// A colour buffer.
    ColorBuffer,
    /// A comparison mode of a texture.
    CompareMode,
    /// Bits of client state.
    ClientBits,
}

/// Parameters whose values are enumerants, although commands take them as numbers.
const NAMED_PARAMETERS: &[GLenum] = &[
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_TEXTURE_WRAP_R,
    GL_TEXTURE_COMPARE_MODE,
    GL_TEXTURE_COMPARE_FUNC,
    GL_DEPTH_TEXTURE_MODE,
    GL_TEXTURE_ENV_MODE,
    GL_COMBINE_RGB,
    GL_COMBINE_ALPHA,
    GL_SOURCE0_RGB,
    GL_SOURCE1_RGB,
    GL_SOURCE2_RGB,
    GL_SOURCE3_RGB_NV,
    GL_SOURCE0_ALPHA,
    GL_SOURCE1_ALPHA,
    GL_SOURCE2_ALPHA,
    GL_SOURCE3_ALPHA_NV,
    GL_OPERAND0_RGB,
    GL_OPERAND1_RGB,
    GL_OPERAND2_RGB,
    GL_OPERAND3_RGB_NV,
    GL_OPERAND0_ALPHA,
    GL_OPERAND1_ALPHA,
    GL_OPERAND2_ALPHA,
    GL_OPERAND3_ALPHA_NV,
    GL_TEXTURE_GEN_MODE,
    GL_FOG_MODE,
    GL_FOG_COORD_SRC,
    GL_FOG_DISTANCE_MODE_NV,
    GL_LIGHT_MODEL_COLOR_CONTROL,
    GL_CONVOLUTION_BORDER_MODE,
    GL_COLOR_TABLE_FORMAT,
    GL_CONVOLUTION_FORMAT,
];

impl Names {
    /// What the values of an argument of a command are; `pname` is the parameter that it belongs to.
    pub(crate) fn of(command: &str, argument: &str, pname: Option<GLenum>) -> Self {
        match argument {
            _ if matches!(command, "glDrawBuffer" | "glReadBuffer") => Self::ColorBuffer,
            "mode" if command == "glBegin" || command.starts_with("glDraw") || command.starts_with("glMultiDraw") => {
                Self::Primitive
            }
            _ if command.starts_with("glBlendFunc") => Self::BlendFactor,
            _ if command.starts_with("glStencilOp") => Self::StencilOp,
            "mask" if command == "glPushClientAttrib" => Self::ClientBits,
            "internal_format" => Self::Enums,
            "param" | "params" => match pname {
                Some(GL_TEXTURE_COMPARE_MODE) => Self::CompareMode,
                Some(pname) if NAMED_PARAMETERS.contains(&pname) => Self::Enums,
                _ => Self::None,
            },
            _ => Self::None,
        }
    }

    /// The name of a value, if it has one.
    fn name(self, value: GLenum) -> Option<String> {
        let found = match self {
            Self::None | Self::Enums | Self::ClientBits => None,
            Self::Primitive => PrimitiveMode::from_gl(value).map(PrimitiveMode::name),
            Self::BlendFactor => BlendFactor::from_gl(value).map(BlendFactor::name),
            Self::StencilOp => StencilOp::from_gl(value).map(StencilOp::name),
            Self::ColorBuffer => ColorBufferName::from_gl(value).map(ColorBufferName::name),
            Self::CompareMode => TextureCompareMode::from_gl(value).map(TextureCompareMode::name),
        };
        let any = || (self != Self::None && value >= 0x100).then(|| enums::name(value));
        found.map(str::to_string).or_else(any)
    }
}

/// An argument as a trace shows it.
pub(crate) trait Show {
    /// Writes it; `names` says what numbers in it mean.
    fn show(&self, text: &mut String, names: Names);

    /// Its value, if it is an enumerant.
    fn enumerant(&self) -> Option<GLenum> {
        None
    }
}

/// An enumerated value, shown by its name.
pub(crate) struct Enumerant(pub(crate) u32);

/// A set of bits, shown by their names.
pub(crate) struct Bits(pub(crate) u32);

impl Show for Enumerant {
    fn show(&self, text: &mut String, names: Names) {
        text.push_str(&names.name(self.0).unwrap_or_else(|| enums::name(self.0)));
    }

    fn enumerant(&self) -> Option<GLenum> {
        Some(self.0)
    }
}

impl Show for Bits {
    fn show(&self, text: &mut String, names: Names) {
        text.push_str(&enums::bit_names(self.0, names == Names::ClientBits));
    }
}

/// Writes to a `String` cannot fail, so their results carry nothing.
fn debug(text: &mut String, value: &dyn Debug) {
    let _ = write!(text, "{value:?}");
}

macro_rules! shown_by_debug {
    ($($t:ty)*) => { $(impl Show for $t {
        fn show(&self, text: &mut String, _names: Names) {
            debug(text, self);
        }
    })* };
}
shown_by_debug!(u8 i8 u16 i16 u32 bool isize usize);

macro_rules! shown_by_name {
    ($($t:ty)*) => { $(impl Show for $t {
        fn show(&self, text: &mut String, names: Names) {
            let value = *self as u32;
            match names.name(value) {
                Some(name) if value as $t == *self => text.push_str(&name),
                _ => debug(text, self),
            }
        }
    })* };
}
shown_by_name!(i32 f32 f64);

impl<T: Show> Show for &[T] {
    fn show(&self, text: &mut String, names: Names) {
        text.push('[');
        for (i, value) in self.iter().take(MAX_SHOWN).enumerate() {
            if i > 0 {
                text.push_str(", ");
            }
            value.show(text, names);
        }
        if self.len() > MAX_SHOWN {
            let _ = write!(text, ", ... {} values", self.len());
        }
        text.push(']');
    }
}

impl<T> Show for &mut [T] {
    fn show(&self, text: &mut String, _names: Names) {
        let _ = write!(text, "&mut [{}]", self.len());
    }
}

impl Show for Pixels<'_> {
    fn show(&self, text: &mut String, _names: Names) {
        match self.bytes() {
            None => text.push_str("NULL"),
            Some(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for PixelsMut<'_> {
    fn show(&self, text: &mut String, _names: Names) {
        match self {
            Self::Null => text.push_str("NULL"),
            Self::Bytes(bytes) => drop(write!(text, "&mut [{} bytes]", bytes.len())),
        }
    }
}

impl Show for ArrayData {
    fn show(&self, text: &mut String, _names: Names) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Values(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
            Self::Client(address) => drop(write!(text, "{:#x}", address.get())),
            Self::NoMemory => text.push_str("no memory"),
        }
    }
}

impl Show for Indices<'_> {
    fn show(&self, text: &mut String, _names: Names) {
        match self {
            Self::Offset(offset) => drop(write!(text, "offset {offset}")),
            Self::Bytes(bytes) => drop(write!(text, "&[{} bytes]", bytes.len())),
        }
    }
}

impl Show for Vec<Indices<'_>> {
    fn show(&self, text: &mut String, names: Names) {
        self.as_slice().show(text, names);
    }
}
