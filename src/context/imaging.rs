//! The imaging subset within pixel transfer (OpenGL 1.5, sections 3.6.3 and 3.6.5): its tables and filters, and the steps that
//! they add. As long as nothing of it is in use, pixels go their usual way; else a whole image is transferred here, and
//! what comes out goes on as floats under a neutral transfer.
//!
//! ```text
//!   scale and bias, maps > colour table > convolution > scale and bias > table > colour matrix > scale and bias > table
//!     > histogram > minmax
//! ```

use super::Pixels;
use super::engine::Engine;
#[cfg(feature = "capi")]
use super::imaging_tables::COLUMN;
use super::imaging_tables::Histogram;
use super::pixels_arg::try_copy;
use crate::enums::*;
use crate::error::{Outcome, out_of_memory};
use crate::pixels::imaging::{ColorImage, Kernel, convolve, count, look_up, widen};
use crate::pixels::{ClientImage, PixelKind};
use crate::state::imaging::{FilterTarget, ScaleBias, TableTarget};
use glam::DMat4;
use std::sync::Arc;

/// Most groups of an image that is transferred as a whole.
const MOST_GROUPS: usize = 1 << 26;

fn scale(colors: &mut [[f32; 4]], by: &ScaleBias) {
    if !by.is_neutral() {
        colors.iter_mut().for_each(|color| *color = by.apply(*color));
    }
}

/// Colours times the colour matrix, in written order.
fn multiply(colors: &mut [[f32; 4]], matrix: &DMat4) {
    if *matrix == DMat4::IDENTITY {
        return;
    }
    let m = matrix.to_cols_array_2d();
    for color in colors {
        let [r, g, b, a] = color.map(f64::from);
        *color = std::array::from_fn(|k| (m[0][k] * r + m[1][k] * g + m[2][k] * b + m[3][k] * a) as f32);
    }
}

impl Engine {
    /// Width and height of what a query of a target writes.
    #[cfg(feature = "capi")]
    pub(crate) fn imaging_size(&self, target: GLenum) -> [i32; 2] {
        let size = if target == COLUMN {
            self.imaging.column.size
        } else if let Some(table) = TableTarget::from_gl(target) {
            self.imaging.tables[table as usize].size
        } else if let Some(filter) = FilterTarget::from_gl(target) {
            self.imaging.filters[filter as usize].size
        } else if target == GL_HISTOGRAM {
            self.imaging.histogram.entries.size
        } else {
            [0; 2]
        };
        size.map(|n| i32::try_from(n).unwrap_or(i32::MAX))
    }

    /// Whether pixel transfer of colours has more to do than scales, biases and maps.
    pub(crate) fn uses_imaging(&self) -> bool {
        let imaging = &self.state.pixel.imaging;
        imaging.histogram
            || imaging.minmax
            || imaging.tables.contains(&true)
            || imaging.convolutions.contains(&true)
            || !imaging.post_convolution.is_neutral()
            || !imaging.post_color_matrix.is_neutral()
            || *self.state.transform.color.top() != DMat4::IDENTITY
    }

    /// The kernel that applies to images of so many dimensions, and the filter that it is of.
    fn kernel(&self, dimensions: usize) -> Option<(Kernel, FilterTarget)> {
        let on = |target: FilterTarget| self.state.pixel.imaging.convolutions[target as usize];
        let target = match dimensions {
            1 => Some(FilterTarget::One),
            2 if on(FilterTarget::Two) => Some(FilterTarget::Two),
            2 => Some(FilterTarget::Separable),
            _ => None,
        };
        let target = target.filter(|target| on(*target))?;
        let filter = &self.imaging.filters[target as usize];
        let kernel = if target == FilterTarget::Separable {
            Kernel::separable(&filter.colors, &self.imaging.column.colors, filter.components())
        } else {
            Kernel { size: filter.size, weights: filter.colors.clone(), filters: filter.components() }
        };
        Some((kernel, target))
    }

    /// The steps after scale, bias and maps for an image that has `dimensions`; `None` where a sink has taken it.
    pub(crate) fn transfer_image(&mut self, mut image: ColorImage, dimensions: usize) -> Outcome<Option<ColorImage>> {
        let imaging = self.state.pixel.imaging;
        let table = |engine: &Self, target: TableTarget, image: &mut ColorImage| {
            if imaging.tables[target as usize] {
                let entries = &engine.imaging.tables[target as usize];
                look_up(&entries.colors, entries.components(), &mut image.colors);
            }
        };
        table(self, TableTarget::Color, &mut image);
        if let Some((kernel, target)) = self.kernel(dimensions) {
            let parameters = &imaging.filters[target as usize];
            image = convolve(&image, &kernel, parameters.border, parameters.border_color)?;
        }
        scale(&mut image.colors, &imaging.post_convolution);
        table(self, TableTarget::PostConvolution, &mut image);
        multiply(&mut image.colors, self.state.transform.color.top());
        scale(&mut image.colors, &imaging.post_color_matrix);
        table(self, TableTarget::PostColorMatrix, &mut image);
        if imaging.histogram {
            let Histogram { entries, bins, sink } = &mut self.imaging.histogram;
            count(bins, entries.components(), &image.colors);
            if *sink {
                return Ok(None);
            }
        }
        if imaging.minmax {
            widen(&mut self.imaging.minmax.range, &image.colors);
            if self.imaging.minmax.sink {
                return Ok(None);
            }
        }
        Ok(Some(image))
    }

    /// The colours of a client image after scale, bias and maps, slice after slice; `None` for other kinds of pixels.
    pub(crate) fn client_colors(&self, image: &ClientImage<'_>) -> Outcome<Option<ColorImage>> {
        let [width, height, depth] = image.size();
        let count = checked_count([width, height.saturating_mul(depth)])?;
        let mut colors = crate::pixels::zoom::zeroed::<[f32; 4]>(count)?;
        for (i, row) in colors.chunks_exact_mut(width.max(1)).enumerate() {
            let at = [0, i % height.max(1), i / height.max(1)];
            match image.pixel().kind() {
                PixelKind::Color => {
                    image.components(at, row);
                    self.transfer().colors(row);
                }
                PixelKind::Index => image.colors(at, self.transfer(), row),
                PixelKind::Stencil | PixelKind::Depth | PixelKind::DepthStencil => return Ok(None),
            }
        }
        Ok(Some(ColorImage { size: [width, height * depth], colors }))
    }

    /// The colours of a part of the framebuffer after scale, bias and maps; those outside of it are made of 0.
    pub(crate) fn read_colors(&self, [x, y]: [i32; 2], size: [usize; 2]) -> Outcome<ColorImage> {
        let count = checked_count(size)?;
        // Most of a much larger part is outside, with no memory behind it.
        let most = self.framebuffer_pixels().saturating_mul(4).max(1 << 20);
        if count as u64 > most {
            return Err(out_of_memory(format!("{count} groups of a framebuffer; the most is {most} of this one")));
        }
        let mut colors = crate::pixels::zoom::zeroed::<[f32; 4]>(count)?;
        for (i, row) in colors.chunks_exact_mut(size[0].max(1)).enumerate() {
            let y = y.saturating_add(i32::try_from(i).unwrap_or(i32::MAX));
            self.framebuffer.read_float(x, y, row);
            self.transfer().colors(row);
        }
        Ok(ColorImage { size, colors })
    }

    /// Calls `f` with colours as pixels of a display list, RGBA and FLOAT, under a neutral transfer.
    pub(crate) fn with_transferred<T>(
        &mut self,
        image: &ColorImage,
        f: impl FnOnce(&mut Self, (GLenum, GLenum), &Pixels<'_>) -> Outcome<T>,
    ) -> Outcome<T> {
        let bytes = try_copy(crate::num::as_bytes(image.colors.as_flattened()));
        let bytes = Arc::new(bytes.ok_or_else(|| out_of_memory("no memory for the colours of the imaging subset"))?);
        self.pixels_written += image.colors.len() as u64;
        let (pixel, matrix) = (self.state.pixel, *self.state.transform.color.top());
        (self.state.pixel.transfer, self.state.pixel.imaging) = Default::default();
        *self.state.transform.color.top_mut() = DMat4::IDENTITY;
        let result = f(self, (GL_RGBA, GL_FLOAT), &Pixels::Kept(bytes));
        self.state.pixel = pixel;
        *self.state.transform.color.top_mut() = matrix;
        result
    }
}

fn checked_count([width, height]: [usize; 2]) -> Outcome<usize> {
    width.checked_mul(height).filter(|count| *count <= MOST_GROUPS).ok_or_else(|| {
        out_of_memory(format!(
            "{width} by {height} groups at once through the imaging subset; the most is {MOST_GROUPS}"
        ))
    })
}
