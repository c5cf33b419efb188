//! Histogram and minmax (OpenGL 1.5, sections 3.6.3, 6.1.9 and 6.1.10): what passes by in pixel transfer is counted, and its
//! range is kept.

use super::Values;
use super::color_tables::{MAX_TABLE_WIDTH, component_bits, power_of_two, too_large};
use super::engine::Engine;
use super::imaging_tables::{Entries, Histogram, Minmax, color_format};
use crate::enums::*;
use crate::error::{Outcome, not_one};
use crate::pixels::{ClientTarget, PixelFormat, PixelKind, Purpose};
use crate::texture::format::{BaseFormat, InternalFormat};

fn only(target: GLenum, wanted: GLenum, what: &str) -> Outcome {
    if target == wanted { Ok(()) } else { Err(not_one(target, what)) }
}

/// A colour format, which for histogram and minmax has no intensity.
fn countable(internal_format: GLenum) -> Outcome<&'static InternalFormat> {
    color_format(internal_format).and_then(|f| {
        if f.base == BaseFormat::Intensity {
            Err(not_one(internal_format, "a format that can be counted"))
        } else {
            Ok(f)
        }
    })
}

/// A pair that queries of counts and ranges take.
fn queried_pair(format: GLenum, type_: GLenum) -> Outcome<PixelFormat> {
    let pixel = PixelFormat::for_command(format, type_, Purpose::GetTexImage)?;
    if pixel.kind() == PixelKind::Color { Ok(pixel) } else { Err(not_one(format, "a format of colours")) }
}

impl Engine {
    pub(crate) fn histogram(&mut self, target: GLenum, width: i32, internal_format: GLenum, sink: bool) -> Outcome {
        let proxy = target == GL_PROXY_HISTOGRAM;
        if !proxy {
            only(target, GL_HISTOGRAM, "GL_HISTOGRAM or GL_PROXY_HISTOGRAM")?;
        }
        let (format, width) = (countable(internal_format)?, power_of_two(width)?);
        let entries = Entries { format, size: [width, 1], colors: Vec::new() };
        if proxy {
            let fits = width <= MAX_TABLE_WIDTH;
            self.imaging.histogram_proxy = if fits { entries } else { Entries::default() };
            return Ok(());
        }
        if width > MAX_TABLE_WIDTH {
            return Err(too_large(width));
        }
        self.imaging.histogram = Histogram { entries, bins: vec![[0; 4]; width], sink };
        Ok(())
    }

    pub(crate) fn reset_histogram(&mut self, target: GLenum) -> Outcome {
        only(target, GL_HISTOGRAM, "GL_HISTOGRAM")?;
        self.imaging.histogram.bins.fill([0; 4]);
        Ok(())
    }

    /// Counts are numbers of the type, not fractions of its range; the luminance is counted as red.
    pub(crate) fn get_histogram(
        &mut self,
        target: GLenum,
        reset: bool,
        format: GLenum,
        type_: GLenum,
        out: &mut [u8],
    ) -> Outcome {
        only(target, GL_HISTOGRAM, "GL_HISTOGRAM")?;
        let pixel = queried_pair(format, type_)?;
        let Histogram { entries, bins, .. } = &mut self.imaging.histogram;
        let has = super::imaging_tables::components_of(entries.format.base);
        let width = i32::try_from(bins.len()).unwrap_or(i32::MAX);
        let mut target = ClientTarget::new_2d(out, &self.client.pixel_store.pack, [width, 1], pixel)?;
        let counts: Vec<[u32; 4]> =
            bins.iter().map(|bin| std::array::from_fn(|c| if has[c] { bin[c] } else { 0 })).collect();
        target.counts(&counts);
        if reset {
            bins.fill([0; 4]);
        }
        Ok(())
    }

    pub(crate) fn get_histogram_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        let entries = match target {
            GL_HISTOGRAM => &self.imaging.histogram.entries,
            GL_PROXY_HISTOGRAM => &self.imaging.histogram_proxy,
            _ => return Err(not_one(target, "GL_HISTOGRAM or GL_PROXY_HISTOGRAM")),
        };
        // Counters have 32 bits.
        let bits = component_bits(entries.format);
        let size = |i: usize| Values::int(if entries.size[0] == 0 || bits[i] == 0 { 0 } else { 32 });
        Ok(match pname {
            GL_HISTOGRAM_WIDTH => Values::int(entries.size[0] as i32),
            GL_HISTOGRAM_FORMAT => Values::enumerant(entries.format.requested),
            GL_HISTOGRAM_RED_SIZE => size(0),
            GL_HISTOGRAM_GREEN_SIZE => size(1),
            GL_HISTOGRAM_BLUE_SIZE => size(2),
            GL_HISTOGRAM_ALPHA_SIZE => size(3),
            GL_HISTOGRAM_LUMINANCE_SIZE => size(4),
            GL_HISTOGRAM_SINK => Values::boolean(self.imaging.histogram.sink),
            _ => return Err(not_one(pname, "a parameter of the histogram")),
        })
    }

    pub(crate) fn minmax(&mut self, target: GLenum, internal_format: GLenum, sink: bool) -> Outcome {
        only(target, GL_MINMAX, "GL_MINMAX")?;
        self.imaging.minmax = Minmax { format: countable(internal_format)?, range: Minmax::EMPTY, sink };
        Ok(())
    }

    pub(crate) fn reset_minmax(&mut self, target: GLenum) -> Outcome {
        only(target, GL_MINMAX, "GL_MINMAX")?;
        self.imaging.minmax.range = Minmax::EMPTY;
        Ok(())
    }

    pub(crate) fn get_minmax(
        &mut self,
        target: GLenum,
        reset: bool,
        format: GLenum,
        type_: GLenum,
        out: &mut [u8],
    ) -> Outcome {
        only(target, GL_MINMAX, "GL_MINMAX")?;
        let pixel = queried_pair(format, type_)?;
        let Minmax { format, range, .. } = &self.imaging.minmax;
        let entries = Entries { format, size: [2, 1], colors: range.to_vec() };
        self.pack_colors(entries.queried(), 1, pixel, out)?;
        if reset {
            self.imaging.minmax.range = Minmax::EMPTY;
        }
        Ok(())
    }

    pub(crate) fn get_minmax_parameter(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        only(target, GL_MINMAX, "GL_MINMAX")?;
        Ok(match pname {
            GL_MINMAX_FORMAT => Values::enumerant(self.imaging.minmax.format.requested),
            GL_MINMAX_SINK => Values::boolean(self.imaging.minmax.sink),
            _ => return Err(not_one(pname, "GL_MINMAX_FORMAT or GL_MINMAX_SINK")),
        })
    }
}
