//! Per-fragment and whole-framebuffer state (OpenGL 1.5, sections 4.1 and 4.2, tables 6.20 and 6.21): scissor, alpha
//! test, blending, logic op, masks, clear values.

use super::compare::CompareFunc;
use crate::enums::gl_enum;

gl_enum! {
    /// What blending multiplies the source or the framebuffer's colour by (tables 4.1 and 4.2).
    #[derive(Default)]
    pub enum BlendFactor {
        /// 0.
        Zero = GL_ZERO,
        /// 1.
        #[default]
        One = GL_ONE,
        /// The source's channel.
        SrcColor = GL_SRC_COLOR,
        /// 1 less the source's channel.
        OneMinusSrcColor = GL_ONE_MINUS_SRC_COLOR,
        /// The framebuffer's channel.
        DstColor = GL_DST_COLOR,
        /// 1 less the framebuffer's channel.
        OneMinusDstColor = GL_ONE_MINUS_DST_COLOR,
        /// The source's alpha.
        SrcAlpha = GL_SRC_ALPHA,
        /// 1 less the source's alpha.
        OneMinusSrcAlpha = GL_ONE_MINUS_SRC_ALPHA,
        /// The framebuffer's alpha.
        DstAlpha = GL_DST_ALPHA,
        /// 1 less the framebuffer's alpha.
        OneMinusDstAlpha = GL_ONE_MINUS_DST_ALPHA,
        /// The constant colour's channel.
        ConstantColor = GL_CONSTANT_COLOR,
        /// 1 less the constant colour's channel.
        OneMinusConstantColor = GL_ONE_MINUS_CONSTANT_COLOR,
        /// The constant colour's alpha.
        ConstantAlpha = GL_CONSTANT_ALPHA,
        /// 1 less the constant colour's alpha.
        OneMinusConstantAlpha = GL_ONE_MINUS_CONSTANT_ALPHA,
        /// For RGB the smaller of source alpha and 1 less the framebuffer's alpha, for alpha 1. A source factor only.
        SrcAlphaSaturate = GL_SRC_ALPHA_SATURATE,
    }
}

gl_enum! {
    /// How blending puts source and framebuffer together.
    #[derive(Default)]
    pub enum BlendEquation {
        /// The sum of the products.
        #[default]
        Add = GL_FUNC_ADD,
        /// The source's product less the framebuffer's.
        Subtract = GL_FUNC_SUBTRACT,
        /// The framebuffer's product less the source's.
        ReverseSubtract = GL_FUNC_REVERSE_SUBTRACT,
        /// The smaller of the two colours.
        Min = GL_MIN,
        /// The larger of the two colours.
        Max = GL_MAX,
    }
}

gl_enum! {
    /// A logical operation on the bits of source and framebuffer. GL numbers them by their truth tables (table 4.3), and
    /// so do the rows: bit 0 of a row's number is the result for (s, d) = (1, 1), bit 1 for (1, 0), bit 2 for (0, 1), bit
    /// 3 for (0, 0).
    pub enum LogicOp {
        Clear = GL_CLEAR,
        And = GL_AND,
        AndReverse = GL_AND_REVERSE,
        Copy = GL_COPY,
        AndInverted = GL_AND_INVERTED,
        Noop = GL_NOOP,
        Xor = GL_XOR,
        Or = GL_OR,
        Nor = GL_NOR,
        Equiv = GL_EQUIV,
        Invert = GL_INVERT,
        OrReverse = GL_OR_REVERSE,
        CopyInverted = GL_COPY_INVERTED,
        OrInverted = GL_OR_INVERTED,
        Nand = GL_NAND,
        Set = GL_SET,
    }
}

gl_enum! {
    /// The name of a colour buffer or of several.
    pub enum ColorBufferName {
        None = GL_NONE,
        Front = GL_FRONT,
        FrontLeft = GL_FRONT_LEFT,
        Left = GL_LEFT,
        FrontAndBack = GL_FRONT_AND_BACK,
        Back = GL_BACK,
        BackLeft = GL_BACK_LEFT,
        Right = GL_RIGHT,
        FrontRight = GL_FRONT_RIGHT,
        BackRight = GL_BACK_RIGHT,
        Aux0 = GL_AUX0,
        Aux1 = GL_AUX1,
        Aux2 = GL_AUX2,
        Aux3 = GL_AUX3,
    }
}

impl ColorBufferName {
    /// Whether it names the one colour buffer that there is. By the letter only the front left one exists, but programs
    /// that were made for two buffers name the back one, so that is another name of it.
    #[must_use]
    pub const fn exists(self) -> bool {
        match self {
            Self::Front | Self::FrontLeft | Self::Left | Self::FrontAndBack | Self::Back | Self::BackLeft => true,
            Self::None
            | Self::Right
            | Self::FrontRight
            | Self::BackRight
            | Self::Aux0
            | Self::Aux1
            | Self::Aux2
            | Self::Aux3 => false,
        }
    }
}

/// The scissor box. The context sets its initial size to the window's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scissor {
    /// `GL_SCISSOR_TEST`.
    pub enabled: bool,
    /// Left edge.
    pub x: i32,
    /// Lower edge.
    pub y: i32,
    /// Width.
    pub width: i32,
    /// Height.
    pub height: i32,
}

/// Colour buffer state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorBuffer {
    /// `GL_ALPHA_TEST`.
    pub alpha_test: bool,
    /// Alpha comparison function.
    pub alpha_func: CompareFunc,
    /// Alpha reference in [0, 1].
    pub alpha_ref: f32,
    /// `GL_BLEND`.
    pub blend: bool,
    /// Source factors for RGB and alpha.
    pub blend_src: [BlendFactor; 2],
    /// Destination factors for RGB and alpha.
    pub blend_dst: [BlendFactor; 2],
    /// Blend equations for RGB and alpha.
    pub blend_equation: [BlendEquation; 2],
    /// Constant blend colour.
    pub blend_color: [f32; 4],
    /// `GL_DITHER`.
    pub dither: bool,
    /// `GL_COLOR_LOGIC_OP`.
    pub logic_op_enabled: bool,
    /// `GL_INDEX_LOGIC_OP`.
    pub index_logic_op_enabled: bool,
    /// The logic operation.
    pub logic_op: LogicOp,
    /// Which colour channels are written.
    pub color_mask: [bool; 4],
    /// Which index bits are written.
    pub index_mask: u32,
    /// Clear colour in [0, 1].
    pub clear_color: [f32; 4],
    /// Clear index.
    pub clear_index: f32,
    /// Which buffer is drawn into; the context sets the initial value.
    pub draw_buffer: ColorBufferName,
}

impl Default for ColorBuffer {
    fn default() -> Self {
        Self {
            alpha_test: false,
            alpha_func: CompareFunc::Always,
            alpha_ref: 0.0,
            blend: false,
            blend_src: [BlendFactor::One; 2],
            blend_dst: [BlendFactor::Zero; 2],
            blend_equation: [BlendEquation::Add; 2],
            blend_color: [0.0; 4],
            dither: true,
            logic_op_enabled: false,
            index_logic_op_enabled: false,
            logic_op: LogicOp::Copy,
            color_mask: [true; 4],
            index_mask: u32::MAX,
            clear_color: [0.0; 4],
            clear_index: 0.0,
            draw_buffer: ColorBufferName::Front,
        }
    }
}

/// Accumulation buffer state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accum {
    /// Clear value in [-1, 1].
    pub clear: [f32; 4],
}
