//! Convolution filters (OpenGL 1.5, sections 3.6.3 and 6.1.8): specification from client memory or the framebuffer,
//! parameters, queries.

use super::color_tables::{color_pixels, expanded};
use super::engine::Engine;
use super::imaging_tables::{Entries, color_format};
use super::{Params, Pixels, Values};
use crate::enums::*;
use crate::error::{Outcome, invalid_value, known, not_one};
use crate::limits::MAX_CONVOLUTION_SIZE;
use crate::pixels::{PixelFormat, Purpose};
use crate::state::imaging::{ConvolutionBorder, FilterTarget};
use crate::texture::format::InternalFormat;

fn filter_target(target: GLenum) -> Outcome<FilterTarget> {
    known(FilterTarget::from_gl(target), target, "a convolution such as GL_CONVOLUTION_2D")
}

/// The one target that a command takes.
fn only(target: GLenum, wanted: FilterTarget) -> Outcome {
    if FilterTarget::from_gl(target) == Some(wanted) { Ok(()) } else { Err(not_one(target, wanted.name())) }
}

fn check_extent(n: i32) -> Outcome<usize> {
    usize::try_from(n)
        .ok()
        .filter(|n| *n <= MAX_CONVOLUTION_SIZE)
        .ok_or_else(|| invalid_value(format!("a filter of {n} groups; it has 0 to {MAX_CONVOLUTION_SIZE} each way")))
}

impl Engine {
    /// Weights of a filter: colours scaled, biased, of the format's components; they are not limited.
    fn weights(
        &self,
        target: FilterTarget,
        format: &'static InternalFormat,
        size: [usize; 2],
        colors: &[[f32; 4]],
    ) -> Entries {
        let by = self.state.pixel.imaging.filters[target as usize].scale;
        let colors = colors.iter().map(|color| format.base.expand(by.apply(*color))).collect();
        Entries { format, size, colors }
    }

    pub(crate) fn convolution_filter_1d(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        width: i32,
        format: GLenum,
        type_: GLenum,
        image: &Pixels<'_>,
    ) -> Outcome {
        only(target, FilterTarget::One)?;
        self.specify_filter(FilterTarget::One, internal_format, [width, 1], (format, type_), image)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn convolution_filter_2d(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
        image: &Pixels<'_>,
    ) -> Outcome {
        only(target, FilterTarget::Two)?;
        self.specify_filter(FilterTarget::Two, internal_format, [width, height], (format, type_), image)
    }

    fn specify_filter(
        &mut self,
        target: FilterTarget,
        internal_format: GLenum,
        [width, height]: [i32; 2],
        (format, type_): (GLenum, GLenum),
        image: &Pixels<'_>,
    ) -> Outcome {
        let internal = color_format(internal_format)?;
        let pixel = color_pixels(format, type_)?;
        let size = [check_extent(width)?, check_extent(height)?];
        let colors = expanded(image, &self.client.pixel_store.unpack, [width, height], pixel)?;
        self.imaging.filters[target as usize] = self.weights(target, internal, size, &colors);
        Ok(())
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn separable_filter_2d(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
        row: &Pixels<'_>,
        column: &Pixels<'_>,
    ) -> Outcome {
        only(target, FilterTarget::Separable)?;
        let internal = color_format(internal_format)?;
        let pixel = color_pixels(format, type_)?;
        let size = [check_extent(width)?, check_extent(height)?];
        let store = self.client.pixel_store.unpack;
        let (row, column) = (expanded(row, &store, [width, 1], pixel)?, expanded(column, &store, [height, 1], pixel)?);
        let of = FilterTarget::Separable;
        self.imaging.column = self.weights(of, internal, [size[1], 1], &column);
        self.imaging.filters[of as usize] = self.weights(of, internal, [size[0], 1], &row);
        Ok(())
    }

    pub(crate) fn copy_convolution_filter_1d(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
    ) -> Outcome {
        only(target, FilterTarget::One)?;
        self.copy_filter(FilterTarget::One, internal_format, [x, y], [width, 1])
    }

    pub(crate) fn copy_convolution_filter_2d(
        &mut self,
        target: GLenum,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
    ) -> Outcome {
        only(target, FilterTarget::Two)?;
        self.copy_filter(FilterTarget::Two, internal_format, [x, y], [width, height])
    }

    fn copy_filter(
        &mut self,
        target: FilterTarget,
        internal_format: GLenum,
        [x, y]: [i32; 2],
        [width, height]: [i32; 2],
    ) -> Outcome {
        let internal = color_format(internal_format)?;
        let size = [check_extent(width)?, check_extent(height)?];
        self.flush_scene();
        let mut colors = vec![[0.0; 4]; size[0] * size[1]];
        for (i, row) in (0..).zip(colors.chunks_exact_mut(size[0].max(1))) {
            self.framebuffer.read_float(x, y.saturating_add(i), row);
        }
        self.imaging.filters[target as usize] = self.weights(target, internal, size, &colors);
        Ok(())
    }

    pub(crate) fn convolution_parameter(&mut self, target: GLenum, pname: GLenum, params: &Params) -> Outcome {
        let target = filter_target(target)?;
        if pname != GL_CONVOLUTION_BORDER_MODE {
            params.vector_only("ConvolutionParameter", pname)?;
        }
        let filter = &mut self.state.pixel.imaging.filters[target as usize];
        match pname {
            GL_CONVOLUTION_BORDER_MODE => {
                let mode = params.enumerant()?;
                filter.border = known(ConvolutionBorder::from_gl(mode), mode, "a border mode such as GL_REDUCE")?;
            }
            GL_CONVOLUTION_BORDER_COLOR => filter.border_color = params.color()?,
            GL_CONVOLUTION_FILTER_SCALE => filter.scale.scale = params.numbers()?,
            GL_CONVOLUTION_FILTER_BIAS => filter.scale.bias = params.numbers()?,
            _ => return Err(not_one(pname, "a parameter of convolution")),
        }
        Ok(())
    }

    pub(crate) fn get_convolution_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        let target = filter_target(target)?;
        let (filter, entries) =
            (&self.state.pixel.imaging.filters[target as usize], &self.imaging.filters[target as usize]);
        let height = match target {
            FilterTarget::One => None,
            FilterTarget::Two => Some(entries.size[1]),
            FilterTarget::Separable => Some(self.imaging.column.size[0]),
        };
        Ok(match (pname, height) {
            (GL_CONVOLUTION_BORDER_MODE, _) => Values::enumerant(filter.border.gl()),
            (GL_CONVOLUTION_BORDER_COLOR, _) => Values::unit(&filter.border_color),
            (GL_CONVOLUTION_FILTER_SCALE, _) => Values::floats(&filter.scale.scale),
            (GL_CONVOLUTION_FILTER_BIAS, _) => Values::floats(&filter.scale.bias),
            (GL_CONVOLUTION_FORMAT, _) => Values::enumerant(entries.format.requested),
            (GL_CONVOLUTION_WIDTH, _) => Values::int(entries.size[0] as i32),
            (GL_MAX_CONVOLUTION_WIDTH, _) | (GL_MAX_CONVOLUTION_HEIGHT, Some(_)) => {
                Values::int(MAX_CONVOLUTION_SIZE as i32)
            }
            // A filter that nobody has specified is empty; a one-dimensional one has no height.
            (GL_CONVOLUTION_HEIGHT, Some(_)) if entries.size[0] == 0 => Values::int(0),
            (GL_CONVOLUTION_HEIGHT, Some(height)) => Values::int(height as i32),
            _ => return Err(not_one(pname, "a parameter of this convolution")),
        })
    }

    pub(crate) fn get_convolution_filter(
        &mut self,
        target: GLenum,
        format: GLenum,
        type_: GLenum,
        out: &mut [u8],
    ) -> Outcome {
        let of = filter_target(target)?;
        if of == FilterTarget::Separable {
            return Err(not_one(target, "GL_CONVOLUTION_1D or GL_CONVOLUTION_2D"));
        }
        let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        let entries = &self.imaging.filters[of as usize];
        self.pack_colors(entries.queried(), entries.size[1], pixel, out)
    }

    pub(crate) fn get_separable_filter(
        &mut self,
        target: GLenum,
        format: GLenum,
        type_: GLenum,
        row: &mut [u8],
        column: &mut [u8],
        _span: &mut [u8],
    ) -> Outcome {
        only(target, FilterTarget::Separable)?;
        let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
        self.pack_colors(self.imaging.filters[FilterTarget::Separable as usize].queried(), 1, pixel, row)?;
        self.pack_colors(self.imaging.column.queried(), 1, pixel, column)
    }
}
