//! DrawPixels, CopyPixels and Bitmap (OpenGL 1.5, sections 3.6.4, 3.7 and 4.3.3). Colours and depths become fragments of the
//! present state's program at the raster position; stencil indices go straight into the stencil buffer. All of them are
//! drawn by the scene, like primitives, so that they keep their place in the order of drawing.

use super::Pixels;
use super::engine::Engine;
use super::tex_image::client_image;
use super::whole_vertex::raster_vertex;
use crate::enums::gl_enum;
use crate::enums::*;
use crate::error::{Outcome, invalid_value, known};
use crate::fragment::pixel_rect::{PixelRect, PixelValues};
use crate::num::clamp01;
use crate::pixels::{ClientImage, PixelFormat, PixelKind, Placement, Purpose};
use crate::raster::state::Rect;
use crate::raster::vertex::VertexRef;
use crate::raster::{BitmapBlock, Draw, RasterState};
use crate::texture::image::Dimensions;
use std::sync::Arc;

/// Blocks of a bitmap that are set up before the scene may be flushed.
const BLOCKS: usize = 1024;

/// The blocks of a bitmap with its lower left bit at a pixel, those that meet a rectangle.
fn blocks<'a>(image: &'a ClientImage<'_>, [x, y]: [i32; 2], clip: Rect) -> impl Iterator<Item = BitmapBlock> + 'a {
    let [width, height, _] = image.size();
    // Blocks that meet the rectangle along an axis: their first bits.
    let range = |at: i32, count: usize, low: i32, high: i32| {
        let count = i64::try_from(count).unwrap_or(i64::MAX);
        let first = (i64::from(low) - i64::from(at)).clamp(0, count) & !7;
        let end = (i64::from(high) - i64::from(at)).clamp(0, count);
        (first..end).step_by(8)
    };
    let columns = range(x, width, clip.x0, clip.x1);
    range(y, height, clip.y0, clip.y1).flat_map(move |row| {
        columns.clone().map(move |column| {
            let bits = (0..8).fold(0, |bits, i| {
                bits | u64::from(image.eight_bits([column as usize, row as usize + i, 0])) << (8 * i)
            });
            ([x.saturating_add(column as i32), y.saturating_add(row as i32)], bits)
        })
    })
}

/// INVALID_VALUE for a size that is negative.
fn check_size(width: i32, height: i32) -> Outcome<[u32; 2]> {
    match (u32::try_from(width), u32::try_from(height)) {
        (Ok(width), Ok(height)) => Ok([width, height]),
        _ => Err(invalid_value(format!("a size of {width} by {height}; neither may be negative"))),
    }
}

gl_enum! {
    /// What CopyPixels copies.
    enum CopyType { Color = GL_COLOR, Depth = GL_DEPTH, Stencil = GL_STENCIL, DepthStencil = GL_DEPTH_STENCIL_EXT }
}

impl CopyType {
    const fn kind(self) -> PixelKind {
        match self {
            Self::Color => PixelKind::Color,
            Self::Depth => PixelKind::Depth,
            Self::Stencil => PixelKind::Stencil,
            Self::DepthStencil => PixelKind::DepthStencil,
        }
    }
}

/// Where groups come from, row by row from below.
enum Source<'a> {
    /// Client memory.
    Client(ClientImage<'a>),
    /// The framebuffer, from this pixel on.
    Framebuffer([i32; 2]),
}

impl Source<'_> {
    fn colors(&self, engine: &Engine, at: [u32; 2], row: &mut [[f32; 4]]) {
        let transfer = engine.transfer();
        match self {
            Self::Client(image) => image.colors(group(at), transfer, row),
            Self::Framebuffer(from) => {
                let [x, y] = pixel(*from, at);
                engine.framebuffer.read_float(x, y, row);
                transfer.colors(row);
                row.iter_mut().for_each(|color| *color = color.map(clamp01));
            }
        }
    }

    /// Whether [`packed`](Self::packed) gives the same colours.
    fn is_packed(&self, engine: &Engine) -> bool {
        match self {
            Self::Client(image) => image.is_rgba8(engine.transfer()),
            Self::Framebuffer(_) => !engine.framebuffer.format().float && engine.transfer().keeps_colors(),
        }
    }

    fn packed(&self, engine: &Engine, at: [u32; 2], row: &mut [u32]) {
        match self {
            Self::Client(image) => image.colors_rgba8(group(at), engine.transfer(), row),
            Self::Framebuffer(from) => {
                let [x, y] = pixel(*from, at);
                engine.framebuffer.read_rgba8(x, y, row);
            }
        }
    }

    /// Depths in units of the depth buffer.
    fn depths(&self, engine: &Engine, at: [u32; 2], row: &mut [u32]) {
        let (transfer, format) = (engine.transfer(), engine.framebuffer.format());
        let mut depths = vec![0.0; row.len()];
        match self {
            Self::Client(image) => image.depths(group(at), transfer, &mut depths),
            Self::Framebuffer(from) => {
                let [x, y] = pixel(*from, at);
                let mut exact = vec![0.0; row.len()];
                engine.framebuffer.read_depth(x, y, &mut exact);
                let moved = exact.into_iter().map(|depth| transfer.depth(depth));
                row.iter_mut().zip(moved).for_each(|(to, depth)| *to = format.quantised_depth(depth));
                return;
            }
        }
        row.iter_mut().zip(depths).for_each(|(to, depth)| *to = format.quantised_depth(depth.into()));
    }

    fn stencils(&self, engine: &Engine, at: [u32; 2], row: &mut [u32]) {
        let transfer = engine.transfer();
        match self {
            Self::Client(image) => image.stencils(group(at), transfer, row),
            Self::Framebuffer(from) => {
                let [x, y] = pixel(*from, at);
                let mut stored = vec![0; row.len()];
                engine.framebuffer.read_stencil(x, y, &mut stored);
                row.iter_mut().zip(stored).for_each(|(to, index)| *to = transfer.stencil(index.into()));
            }
        }
    }
}

/// A group of a client image.
fn group([x, y]: [u32; 2]) -> [usize; 3] {
    [x as usize, y as usize, 0]
}

/// A pixel relative to another one.
fn pixel(from: [i32; 2], at: [u32; 2]) -> [i32; 2] {
    [0, 1].map(|i: usize| from[i].saturating_add_unsigned(at[i]))
}

impl Engine {
    pub(crate) fn draw_pixels(
        &mut self,
        width: i32,
        height: i32,
        format: GLenum,
        type_: GLenum,
        pixels: &Pixels<'_>,
    ) -> Outcome {
        let size = check_size(width, height)?;
        let pixel = PixelFormat::for_command(format, type_, Purpose::DrawPixels)?;
        self.check_has_buffers(pixel.kind())?;
        let store = self.client.pixel_store.unpack;
        let image = client_image(pixels, &store, Dimensions::Two, [width, height, 1], pixel)?;
        match image {
            None if width > 0 && height > 0 => {
                Err(invalid_value(format!("no pixels to draw; pass {width} by {height} of them")))
            }
            None => Ok(()),
            Some(image) => self.draw_rectangle(GL_DRAW_PIXEL_TOKEN, &Source::Client(image), size, pixel.kind()),
        }
    }

    pub(crate) fn copy_pixels(&mut self, x: i32, y: i32, width: i32, height: i32, what: GLenum) -> Outcome {
        let kind = known(CopyType::from_gl(what), what, "what CopyPixels copies")?.kind();
        let size = check_size(width, height)?;
        self.check_has_buffers(kind)?;
        self.flush_scene();
        self.draw_rectangle(GL_COPY_PIXEL_TOKEN, &Source::Framebuffer([x, y]), size, kind)
    }

    /// Draws groups at the raster position, if that is valid.
    fn draw_rectangle(&mut self, token: GLenum, source: &Source<'_>, size: [u32; 2], kind: PixelKind) -> Outcome {
        if size.contains(&0) || !self.state.current.raster.valid || self.captures_pixels(token) {
            return Ok(());
        }
        let raster = self.raster_state();
        if matches!(kind, PixelKind::Color | PixelKind::Index) && self.uses_imaging() {
            return self.draw_imaged(source, size, raster);
        }
        let placed = self.placed(size, raster.clip)?;
        let [width, height] = placed.size();
        self.pixels_written += width as u64 * height as u64;
        let engine = &*self;
        let values = match kind {
            PixelKind::Color | PixelKind::Index if source.is_packed(engine) => {
                PixelValues::Packed(placed.resolve(|at, row| source.packed(engine, at, row))?)
            }
            PixelKind::Color | PixelKind::Index => {
                PixelValues::Colors(placed.resolve(|at, row| source.colors(engine, at, row))?)
            }
            PixelKind::Depth => PixelValues::Depths(placed.resolve(|at, row| source.depths(engine, at, row))?),
            PixelKind::Stencil => {
                let stencils = placed.resolve(|at, row| source.stencils(engine, at, row))?;
                return self.store_stencils(&placed, &stencils, None);
            }
            PixelKind::DepthStencil => {
                let stencils = placed.resolve(|at, row| source.stencils(engine, at, row))?;
                let depths = placed.resolve(|at, row| source.depths(engine, at, row))?;
                return self.store_stencils(&placed, &stencils, Some(&depths));
            }
        };
        self.draw_fragments(&placed, values, raster);
        Ok(())
    }

    /// Where so many groups at the raster position are, cut to what may be written.
    fn placed(&self, size: [u32; 2], clip: Rect) -> Outcome<Placement> {
        let [x, y, ..] = self.state.current.raster.position;
        Placement::new(size, [x, y], self.state.pixel.zoom, [[clip.x0, clip.x1], [clip.y0, clip.y1]])
    }

    /// Colours that the imaging subset changes, perhaps with their number.
    fn draw_imaged(&mut self, source: &Source<'_>, size: [u32; 2], raster: RasterState) -> Outcome {
        let image = match source {
            Source::Client(image) => self.client_colors(image)?,
            Source::Framebuffer(from) => Some(self.read_colors(*from, size.map(|n| n as usize))?),
        };
        let Some(image) = image.map(|image| self.transfer_image(image, 2)).transpose()?.flatten() else {
            return Ok(());
        };
        // Each of them has gone through the tables and filters.
        self.pixels_written += 16 * image.colors.len() as u64;
        let size = image.size.map(|n| u32::try_from(n).unwrap_or(0));
        if size.contains(&0) {
            return Ok(());
        }
        let placed = self.placed(size, raster.clip)?;
        let colors = placed.resolve(|[x, y], row: &mut [[f32; 4]]| {
            let at = y as usize * image.size[0] + x as usize;
            for (to, from) in row.iter_mut().zip(image.colors.get(at..).unwrap_or_default()) {
                *to = from.map(clamp01);
            }
        })?;
        self.draw_fragments(&placed, PixelValues::Colors(colors), raster);
        Ok(())
    }

    /// Colours or depths, as fragments of the present state's program.
    fn draw_fragments(&mut self, placed: &Placement, values: PixelValues, raster: RasterState) {
        self.take_raster_q();
        self.run_vertices();
        self.unseen = true;
        let ([x, y], [width, height]) = (placed.origin, placed.size().map(|n| i32::try_from(n).unwrap_or(0)));
        let image = PixelRect { width: width.unsigned_abs(), values };
        let memory = image.memory();
        let program = Arc::new(self.build_program(true, Some(Arc::new(image))));
        let (head, slots) = raster_vertex(&self.state.current.raster, &program.layout);
        self.scene.begin_draw(Arc::new(Draw { program, raster }));
        // The next primitive begins a draw of its own again.
        self.drawing = false;
        if let Some(mut builder) = self.scene.builder() {
            builder.pixel_rect(VertexRef { head: &head, slots: &slots }, Rect::sized(x, y, width, height), memory);
        }
        self.make_room();
    }

    /// Stencil indices, and depths that come with them, go into the buffers under their masks: no test applies to them but
    /// that of the scissor.
    fn store_stencils(&mut self, placed: &Placement, stencils: &[u32], depths: Option<&[u32]>) -> Outcome {
        self.flush_scene();
        let mask = self.state.stencil.write_mask as u8;
        let depths = depths.filter(|_| self.state.depth.mask);
        let ([x, first], [width, _]) = (placed.origin, placed.size());
        for (row, y) in (first..).take(placed.rows.len()).enumerate() {
            let row = row * width..(row + 1) * width;
            let indices: Vec<u8> = stencils.get(row.clone()).unwrap_or_default().iter().map(|i| *i as u8).collect();
            self.framebuffer.write_stencil(x, y, &indices, mask);
            if let Some(depths) = depths {
                self.framebuffer.write_depth(x, y, depths.get(row).unwrap_or_default());
            }
        }
        Ok(())
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments are GL's")]
    pub(crate) fn bitmap(
        &mut self,
        width: i32,
        height: i32,
        xorig: f32,
        yorig: f32,
        xmove: f32,
        ymove: f32,
        bitmap: &Pixels<'_>,
    ) -> Outcome {
        check_size(width, height)?;
        let pixel = PixelFormat::new(GL_COLOR_INDEX, GL_BITMAP)?;
        let store = self.client.pixel_store.unpack;
        let image = client_image(bitmap, &store, Dimensions::Two, [width, height, 1], pixel)?;
        if !self.state.current.raster.valid {
            return Ok(());
        }
        match image {
            None if width > 0 && height > 0 => {
                return Err(invalid_value(format!("no bitmap to draw; pass {width} by {height} bits")));
            }
            _ if self.captures_pixels(GL_BITMAP_TOKEN) => {}
            Some(image) if width > 0 && height > 0 => self.draw_bitmap(&image, [xorig, yorig]),
            _ => {}
        }
        let [x, y, ..] = &mut self.state.current.raster.position;
        *x += f64::from(xmove);
        *y += f64::from(ymove);
        Ok(())
    }

    /// The set bits of a bitmap as fragments with the values of the raster position.
    fn draw_bitmap(&mut self, image: &ClientImage<'_>, origin: [f32; 2]) {
        self.take_raster_q();
        self.validate();
        self.run_vertices();
        let Some(program) = self.program.clone() else { return };
        let raster = self.state.current.raster;
        let corner = |i: usize| (raster.position[i] - f64::from(origin[i])).floor();
        if !(corner(0).abs() < 1e9 && corner(1).abs() < 1e9) {
            return;
        }
        let (head, slots) = raster_vertex(&raster, &program.layout);
        let position = VertexRef { head: &head, slots: &slots };
        let [width, height, _] = image.size();
        self.pixels_written += (width as u64 * height as u64).min(self.framebuffer_pixels());
        let mut blocks = blocks(image, [corner(0) as i32, corner(1) as i32], self.raster_state().clip).peekable();
        while blocks.peek().is_some() {
            let Some(mut builder) = self.scene.builder() else { return };
            builder.bitmap(position, blocks.by_ref().take(BLOCKS));
            self.make_room();
        }
    }

    /// Programs interpolate a q of the raster position that is not 1.
    fn take_raster_q(&mut self) {
        let coordinates = self.state.current.raster.tex_coord;
        for (unit, [.., q]) in coordinates.iter().enumerate() {
            if *q != 1.0 {
                self.unit_has_q(unit);
            }
        }
    }
}
