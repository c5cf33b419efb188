//! What a program is built from: a typed summary of the state. Two states with the same key need the same stages; the
//! numbers behind them (reference values, colours, densities, coefficients) travel apart, in the uniforms. Both paths are
//! chosen from it: the stages of the reference path, and the span kernel that takes its place for rows of a primitive.

use super::compare::CompareFunc;
use crate::state::color_buffer::LogicOp;
use crate::texture::filter::linear_rgba8::{RGB, RGBA};
use crate::texture::uniforms::WrappedImage;

/// The tests that fragments go through. A test that passes every fragment and writes nothing is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tests {
    /// Alpha test.
    pub alpha: Option<CompareFunc>,
    /// Stencil test of front and of back faces.
    pub stencil: Option<[CompareFunc; 2]>,
    /// Whether the stencil test or what it writes differs between front and back faces.
    pub two_sided: bool,
    /// Whether stencil values may change.
    pub stencil_write: bool,
    /// Depth test.
    pub depth: Option<CompareFunc>,
    /// Whether depths may change.
    pub depth_write: bool,
}

impl Tests {
    /// Whether any of them may kill a fragment or writes.
    pub fn any(&self) -> bool {
        self.alpha.is_some() || self.stencil.is_some() || self.depth.is_some()
    }
}

/// How colours are blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blending {
    /// By a pair of factors that has a loop of its own; its number.
    Pair(u32),
    /// By any factors and equation.
    Any,
}

/// Where the colour and the depth of a fragment come from before texturing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FragmentSource {
    /// Both from the planes of its primitive.
    #[default]
    Primitive,
    /// The colour from a pixel rectangle.
    PixelColors {
        /// Whether they are packed bytes.
        packed: bool,
    },
    /// The depth from a pixel rectangle.
    PixelDepths,
}

/// Which formula gives the fog factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FogFactor {
    /// GL_LINEAR whose end is its start.
    Step,
    /// GL_LINEAR.
    Linear,
    /// GL_EXP.
    Exp,
    /// GL_EXP2.
    Exp2,
}

/// Which channels of the colour buffer are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorWrites {
    /// None.
    #[default]
    Nothing,
    /// Some: the others are read and written back.
    Masked,
    /// All.
    All,
}

/// The summary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FragmentKey {
    /// Where colour and depth come from.
    pub source: FragmentSource,
    /// The tests.
    pub tests: Tests,
    /// Whether a unit has an enabled and complete texture.
    pub textured: bool,
    /// Whether the secondary colour is added.
    pub color_sum: bool,
    /// Fog.
    pub fog: Option<FogFactor>,
    /// Whether alpha is multiplied with the coverage of smooth primitives.
    pub coverage: bool,
    /// Blending.
    pub blend: Option<Blending>,
    /// The logic op.
    pub logic_op: Option<LogicOp>,
    /// Which channels are written.
    pub colors: ColorWrites,
    /// Whether the colour buffer holds floats.
    pub float: bool,
    /// Whether an occlusion query counts the fragments that pass.
    pub counts_samples: bool,
    /// Whether nothing is to be left out or done earlier.
    pub general: bool,
}

impl FragmentKey {
    /// Whether any colour is needed: it is written, or the alpha test reads it.
    pub fn needs_color(&self) -> bool {
        self.colors != ColorWrites::Nothing || self.tests.alpha.is_some()
    }

    /// Whether drawing changes nothing at all.
    pub fn draws_nothing(&self) -> bool {
        let Tests { stencil_write, depth_write, .. } = self.tests;
        self.colors == ColorWrites::Nothing && !depth_write && !stencil_write && !self.counts_samples
    }

    /// Whether stencil and depth come before anything that makes a colour.
    pub fn tests_first(&self) -> bool {
        self.tests.alpha.is_none() && !self.general
    }

    /// Whether the depth test alone comes first and depths are written after the alpha test.
    pub fn depth_first(&self) -> bool {
        !self.tests_first() && !self.general && self.tests.stencil.is_none() && self.tests.depth.is_some()
    }

    /// Whether a pixel is the packed colour, or texel, and nothing else.
    pub fn is_packed(&self) -> bool {
        !self.float && self.blend.is_none() && self.logic_op.is_none()
    }

    /// Whether nothing comes between texturing and the alpha test.
    pub fn ends_with_texturing(&self) -> bool {
        !self.color_sum && self.fog.is_none() && !self.coverage && !self.general
    }

    /// Whether the primary colour is packed and stored, without an alpha test.
    pub fn stores_primary(&self) -> bool {
        self.is_packed() && !self.textured && self.ends_with_texturing() && self.tests.alpha.is_none()
    }

    /// Whether that colour is interpolated.
    pub fn is_plain(&self) -> bool {
        self.stores_primary() && !matches!(self.source, FragmentSource::PixelColors { .. })
    }

    /// Whether no fragment can be killed and all channels are written packed.
    pub fn stores_at_once(&self) -> bool {
        self.is_packed() && self.colors == ColorWrites::All && !self.tests.any()
    }

    /// Why there is no span kernel, if something rules it out.
    pub fn span_obstacle(&self) -> Option<&'static str> {
        let blends = !matches!(self.blend, None | Some(Blending::Pair(_)));
        let rows: [(bool, &'static str); 11] = [
            (self.general, "nothing is to be left out"),
            (self.source == FragmentSource::PixelDepths, "a pixel rectangle gives the depths"),
            (self.tests.alpha.is_some(), "the alpha test decides late who is stored"),
            (self.tests.stencil.is_some(), "there is a stencil test"),
            (self.counts_samples, "an occlusion query counts fragments"),
            (self.colors == ColorWrites::Nothing && self.tests.depth.is_none(), "nothing is written"),
            (self.colors == ColorWrites::Masked, "some channels are protected"),
            (self.float, "the colour buffer holds floats"),
            (self.color_sum || self.fog.is_some() || self.coverage, "colour sum, fog or coverage follow"),
            (self.logic_op.is_some(), "there is a logic op"),
            (blends, "this blending has no loop of its own"),
        ];
        let written = self.colors != ColorWrites::Nothing;
        // The rows from the seventh on are about colours, which need not be written.
        rows.iter().take(if written { 11 } else { 6 }).find(|(holds, _)| *holds).map(|(_, reason)| *reason)
    }
}

/// What a texture environment does to the colour half or to alpha, where that is one of three simple things.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnvStep {
    /// The texel takes its place.
    Texel = 0,
    /// The texel is multiplied with it.
    Product = 1,
    /// It stays.
    Keep = 2,
}

/// A texture whose nearest texels are stored as they are.
#[derive(Clone, Debug)]
pub struct NearestTexture {
    /// The unit whose coordinates say which.
    pub unit: u32,
    /// The images and their wraps.
    pub image: WrappedImage<2>,
}

/// A texture of K dimensions that is filtered linearly and shown by one environment. FORMAT is that of the filter:
/// with [`RGB`] alpha is 1 in all texels.
#[derive(Clone, Debug)]
pub struct LinearTexture<const K: usize, const FORMAT: u8> {
    /// The unit's index.
    pub unit: u32,
    /// The images and their wraps.
    pub image: WrappedImage<K>,
    /// What becomes of the colour, and of alpha.
    pub steps: [EnvStep; 2],
    /// The number of the pair of factors by which the outcome is blended, if it is.
    pub blend: Option<u32>,
    /// A texture by whose colour the outcome is multiplied.
    pub light_map: Option<LightMap>,
}

/// A linearly filtered texture of one level and three channels, by which the colour of another one is multiplied.
#[derive(Clone, Debug)]
pub struct LightMap {
    /// The unit's index.
    pub unit: u32,
    /// The image.
    pub image: WrappedImage<2>,
}

/// What a span kernel shows, where that is a texture.
#[derive(Clone, Debug)]
pub enum SpanTexture {
    /// Nearest texels as they are.
    Nearest(NearestTexture),
    /// A linear filter of three channels, perhaps with a light map.
    LinearRgb(LinearTexture<2, RGB>),
    /// A linear filter of four channels.
    LinearRgba(LinearTexture<2, RGBA>),
    /// A linear filter of three channels in three dimensions.
    LinearRgb3d(LinearTexture<3, RGB>),
}
