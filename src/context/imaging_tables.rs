//! Tables and filters of the imaging subset as data (OpenGL 1.5, section 3.6.3).

use crate::enums::*;
use crate::error::{Outcome, not_one};
use crate::state::imaging::{FilterTarget, TableTarget};
use crate::texture::format::{BaseFormat, InternalFormat};

/// Stands for the column of the separable filter where a size is asked for by its target.
#[cfg(feature = "capi")]
pub(crate) const COLUMN: GLenum = u32::MAX;

/// Which components a base format has, where its luminance or intensity stands for several.
pub(crate) const fn components_of(base: BaseFormat) -> [bool; 4] {
    match base {
        BaseFormat::Alpha => [false, false, false, true],
        BaseFormat::Luminance | BaseFormat::Rgb => [true, true, true, false],
        BaseFormat::LuminanceAlpha | BaseFormat::Intensity | BaseFormat::Rgba | BaseFormat::Depth => [true; 4],
    }
}

/// The colour format of a table or filter, or INVALID_ENUM.
pub(crate) fn color_format(internal_format: GLenum) -> Outcome<&'static InternalFormat> {
    InternalFormat::find(internal_format)
        .filter(|format| format.base != BaseFormat::Depth && format.s3tc.is_none())
        .ok_or_else(|| not_one(internal_format, "the format of a table; pass GL_RGBA, GL_LUMINANCE8 or the like"))
}

/// A colour table or a convolution filter: entries in the colours that its base format expands to.
#[derive(Clone, Debug)]
pub(crate) struct Entries {
    pub(crate) format: &'static InternalFormat,
    pub(crate) size: [usize; 2],
    pub(crate) colors: Vec<[f32; 4]>,
}

impl Default for Entries {
    fn default() -> Self {
        Self { format: InternalFormat::rgba(), size: [0, 1], colors: Vec::new() }
    }
}

impl Entries {
    /// Which components it replaces or filters.
    pub(super) fn components(&self) -> [bool; 4] {
        components_of(self.format.base)
    }

    /// The components as a query assigns them to R, G, B, A (table 6.1).
    pub(crate) fn queried(&self) -> Vec<[f32; 4]> {
        let base = self.format.base;
        let of = |[r, g, b, a]: [f32; 4]| match base {
            BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
            BaseFormat::Luminance | BaseFormat::Intensity => [r, 0.0, 0.0, 1.0],
            BaseFormat::LuminanceAlpha => [r, 0.0, 0.0, a],
            BaseFormat::Rgb => [r, g, b, 1.0],
            BaseFormat::Rgba | BaseFormat::Depth => [r, g, b, a],
        };
        self.colors.iter().copied().map(of).collect()
    }
}

/// A histogram.
#[derive(Clone, Debug, Default)]
pub(crate) struct Histogram {
    pub(crate) entries: Entries,
    pub(crate) bins: Vec<[u32; 4]>,
    pub(crate) sink: bool,
}

/// The ranges of the components.
#[derive(Clone, Debug)]
pub(crate) struct Minmax {
    pub(crate) format: &'static InternalFormat,
    pub(crate) range: [[f32; 4]; 2],
    pub(crate) sink: bool,
}

impl Minmax {
    /// No range at all.
    pub(crate) const EMPTY: [[f32; 4]; 2] = [[f32::MAX; 4], [-f32::MAX; 4]];
}

impl Default for Minmax {
    fn default() -> Self {
        Self { format: InternalFormat::rgba(), range: Self::EMPTY, sink: false }
    }
}

/// Tables, filters, histogram and minmax.
#[derive(Clone, Debug, Default)]
pub(crate) struct ImagingTables {
    pub(crate) tables: [Entries; TableTarget::ALL.len()],
    pub(crate) table_proxies: [Entries; TableTarget::ALL.len()],
    /// The filters; of the separable one the row.
    pub(crate) filters: [Entries; FilterTarget::ALL.len()],
    /// The column of the separable filter.
    pub(crate) column: Entries,
    pub(crate) histogram: Histogram,
    pub(crate) histogram_proxy: Entries,
    pub(crate) minmax: Minmax,
}
