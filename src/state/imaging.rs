//! State of the imaging subset that the attribute stack keeps (OpenGL 1.5, section 3.6.3, tables 6.24 to 6.27): what is
//! enabled, scales and biases, borders. Tables and filters themselves are no part of it.

use crate::enums::{
    GL_POST_COLOR_MATRIX_RED_BIAS, GL_POST_COLOR_MATRIX_RED_SCALE, GL_POST_CONVOLUTION_RED_BIAS,
    GL_POST_CONVOLUTION_RED_SCALE, GLenum, gl_enum,
};

/// A scale and a bias for R, G, B, A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleBias {
    pub scale: [f32; 4],
    pub bias: [f32; 4],
}

impl Default for ScaleBias {
    fn default() -> Self {
        Self { scale: [1.0; 4], bias: [0.0; 4] }
    }
}

impl ScaleBias {
    /// Whether it changes nothing.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        *self == Self::default()
    }

    /// A colour scaled and biased.
    #[must_use]
    pub fn apply(&self, color: [f32; 4]) -> [f32; 4] {
        std::array::from_fn(|c| color[c] * self.scale[c] + self.bias[c])
    }
}

gl_enum! {
    /// What stands for groups beyond the image where a filter reaches there.
    #[derive(Default)]
    pub enum ConvolutionBorder {
        /// There are none: the image gets smaller.
        #[default]
        Reduce = GL_REDUCE,
        Constant = GL_CONSTANT_BORDER,
        Replicate = GL_REPLICATE_BORDER,
    }
}

gl_enum! {
    /// The three colour tables, in the order of pixel transfer.
    pub enum TableTarget {
        Color = GL_COLOR_TABLE,
        PostConvolution = GL_POST_CONVOLUTION_COLOR_TABLE,
        PostColorMatrix = GL_POST_COLOR_MATRIX_COLOR_TABLE,
    }
}

gl_enum! {
    /// The three convolution filters.
    pub enum FilterTarget {
        One = GL_CONVOLUTION_1D,
        Two = GL_CONVOLUTION_2D,
        Separable = GL_SEPARABLE_2D,
    }
}

/// Parameters of a convolution filter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FilterParameters {
    pub border: ConvolutionBorder,
    pub border_color: [f32; 4],
    /// Applied to a filter when it is specified.
    pub scale: ScaleBias,
}

/// All of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Imaging {
    /// Which colour tables are on.
    pub tables: [bool; TableTarget::ALL.len()],
    /// Scale and bias that are applied to a table when it is specified.
    pub table_scale: [ScaleBias; TableTarget::ALL.len()],
    /// Which convolutions are on.
    pub convolutions: [bool; FilterTarget::ALL.len()],
    /// Parameters of the filters.
    pub filters: [FilterParameters; FilterTarget::ALL.len()],
    /// After convolution.
    pub post_convolution: ScaleBias,
    /// After the colour matrix.
    pub post_color_matrix: ScaleBias,
    /// `GL_HISTOGRAM`.
    pub histogram: bool,
    /// `GL_MINMAX`.
    pub minmax: bool,
}

impl Imaging {
    /// The parameter of PixelTransfer that a name stands for: scales and biases of R, G, B, A after convolution and after the
    /// colour matrix.
    pub fn parameter(&mut self, pname: GLenum) -> Option<&mut f32> {
        let of = |first: GLenum| Some(pname.wrapping_sub(first) as usize).filter(|i| *i < 4);
        let (convolution, matrix) = (&mut self.post_convolution, &mut self.post_color_matrix);
        let tables = [
            (GL_POST_CONVOLUTION_RED_SCALE, &mut convolution.scale),
            (GL_POST_CONVOLUTION_RED_BIAS, &mut convolution.bias),
            (GL_POST_COLOR_MATRIX_RED_SCALE, &mut matrix.scale),
            (GL_POST_COLOR_MATRIX_RED_BIAS, &mut matrix.bias),
        ];
        tables.into_iter().find_map(|(first, values)| of(first).map(|i| &mut values[i]))
    }
}
