//! Drawing from arrays (OpenGL 1.5, section 2.8): DrawArrays, DrawElements and their sisters, ArrayElement. Here are the
//! checks and the arrays as a source of vertices; `draw_source` draws from it.

use super::array_pointers::{ATTRIBUTES, Arrays, Attribute};
use super::begin_end::check_mode;
use super::buffer_objects::Buffers;
use super::draw_source::Drawing;
use super::engine::Engine;
use super::fetch::Sources;
use super::pixels_arg::{ArrayData, Indices, index_size};
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, invalid_value, too_short};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::primitive::PrimitiveMode;
use crate::vertex::cache::IndexList;
use crate::vertex::source::ElementOrder;

/// The values of one element of the enabled vertex arrays, as the attribute commands would give them.
#[derive(Clone, Debug, Default)]
pub(crate) struct ArrayElement {
    /// Edge flag, if its array is enabled.
    pub(crate) edge_flag: Option<bool>,
    /// Fog coordinate.
    pub(crate) fog_coord: Option<f32>,
    /// Colour index.
    pub(crate) index: Option<f32>,
    /// Texture coordinates of each unit whose array is enabled: unit number and coordinates.
    pub(crate) tex_coords: Vec<(u32, [f32; 4])>,
    /// Normal.
    pub(crate) normal: Option<[f32; 3]>,
    /// Secondary colour.
    pub(crate) secondary_color: Option<[f32; 4]>,
    /// Colour.
    pub(crate) color: Option<[f32; 4]>,
    /// Position: without it no vertex is issued.
    pub(crate) vertex: Option<[f32; 4]>,
}

/// Elements beyond the end of the array of positions that DrawArrays still draws, as zeros. Few, since one MultiDrawArrays
/// may ask for them with each of its draws.
const ZEROS: usize = 1 << 8;

/// The index list of a draw.
fn index_list<'a>(
    arrays: &Arrays,
    buffers: &'a Buffers,
    count: i32,
    type_: GLenum,
    indices: &'a Indices<'_>,
) -> Outcome<IndexList<'a>> {
    let size = index_size(type_).ok_or_else(|| {
        invalid_enum(format!(
            "{} is not a type of indices: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT",
            name(type_)
        ))
    })?;
    let len = count.max(0) as usize * size;
    let short =
        |there: usize| invalid_operation(format!("{count} indices take {len} bytes, but only {there} are there"));
    match indices {
        Indices::Bytes(bytes) => {
            let bytes = bytes.get(..len).ok_or_else(|| too_short("indices", len, bytes.len(), "bytes"))?;
            Ok(IndexList { bytes, size })
        }
        Indices::Offset(offset) => {
            let Some(buffer) = buffers.get(arrays.element_buffer) else {
                return match len {
                    0 => Ok(IndexList { bytes: &[], size }),
                    _ => Err(invalid_operation("no indices: give a list, or bind one to GL_ELEMENT_ARRAY_BUFFER")),
                };
            };
            if buffer.mapped {
                return Err(invalid_operation("the buffer object of indices is mapped; call glUnmapBuffer first"));
            }
            let rest = buffer.data.get(*offset..).unwrap_or_default();
            Ok(IndexList { bytes: rest.get(..len).ok_or_else(|| short(rest.len()))?, size })
        }
    }
}

impl Engine {
    /// The checks of all draws; a mapped buffer object must not be read.
    pub(crate) fn check_draw(&mut self, mode: GLenum, count: i32) -> Outcome<PrimitiveMode> {
        let mode = check_mode(mode)?;
        if count < 0 {
            return Err(invalid_value(format!("count = {count} is negative")));
        }
        let mapped = |name: u32| name != 0 && self.buffers.get(name).is_some_and(|buffer| buffer.mapped);
        match self.client.arrays.pointers.iter().find(|p| p.enabled && mapped(p.buffer)) {
            Some(p) => Err(invalid_operation(format!(
                "buffer object {} is mapped and holds an enabled array; call glUnmapBuffer first",
                p.buffer
            ))),
            None => Ok(mode),
        }
    }

    /// Plans for the state, and nothing waiting. False where there is nothing to draw from.
    fn start_arrays(&mut self) -> bool {
        for unit in 0..MAX_TEXTURE_UNITS {
            let p = &self.client.arrays.pointers[Attribute::TexCoord as usize + unit];
            if p.enabled && p.size == 4 {
                self.unit_has_q(unit);
            }
        }
        self.validate();
        self.run_vertices();
        let enabled = self.client.arrays.pointers[Attribute::Vertex as usize].enabled;
        if enabled {
            self.pipe.worker.processor.batch.splat(&self.state.current, self.pipe.plan.needs);
        } else {
            self.note(
                "nothing is drawn: no array has positions; call glEnableClientState(GL_VERTEX_ARRAY) first".to_string(),
            );
        }
        enabled
    }

    /// How many of `count` elements from `first` on are drawn: those that have a position, as far as the length of the
    /// memory is known, and [`ZEROS`] more, since a count of two thousand millions over a short array, or none, must not take minutes.
    pub(crate) fn elements_there(&self, first: i32, count: i32) -> i32 {
        let p = &self.client.arrays.pointers[Attribute::Vertex as usize];
        let (element, stride) = (p.element_bytes(), p.stride_bytes().max(1));
        let (bytes, start) = match (&p.data, p.buffer) {
            (ArrayData::Values(values), 0) => (values.len(), p.offset),
            (ArrayData::Offset(_) | ArrayData::NoMemory, 0) => (0, 0),
            (ArrayData::Client(address), 0) if address.get() != 0 => return count,
            (ArrayData::Client(_), 0) => (0, 0),
            (data, buffer) => {
                let start = if matches!(data, ArrayData::Values(_)) { 0 } else { data.address() };
                (self.buffers.get(buffer).map_or(0, |b| b.data.len()), start.saturating_add(p.offset))
            }
        };
        let there = match bytes.checked_sub(start).and_then(|rest| rest.checked_sub(element)) {
            Some(rest) if p.enabled => rest / stride + 1,
            _ => 0,
        };
        let from_first = there.saturating_sub(first.max(0).unsigned_abs() as usize);
        count.min(i32::try_from(from_first.saturating_add(ZEROS)).unwrap_or(i32::MAX))
    }

    pub(crate) fn draw_arrays(&mut self, mode: GLenum, first: i32, count: i32) -> Outcome {
        let mode = self.check_draw(mode, count)?;
        let there = self.elements_there(first, count).unsigned_abs();
        let Ok(first) = u32::try_from(first) else {
            return Err(invalid_value(format!("first = {first} is negative")));
        };
        if count == 0 || !self.start_arrays() {
            return Ok(());
        }
        let last = first + count.unsigned_abs() - 1;
        let Self { render_modes, pipe, draw_workers, scene, client, buffers, framebuffer, config, queries, .. } = self;
        let needs = pipe.plan.needs;
        let sources = Sources::new(&client.arrays, buffers, (first, last), |place| Sources::wanted(place, needs));
        sources.defaults(&mut pipe.worker.processor.batch);
        let short = sources.too_short(last);
        let (threads, passed) = (config.threads, &mut queries.passed);
        let drawing = Drawing { render_modes, pipe, draw_workers, scene, framebuffer, threads, passed };
        drawing.draw(&sources, mode, ElementOrder::Range(first..first + there));
        if let Some((place, there)) = short {
            self.note(format!(
                "glDrawArrays asks for {count} elements from element {first} on, but the {} array has only {there} of \
                 them; zeros stand for the rest",
                super::array_pointers::place_name(place)
            ));
        }
        Ok(())
    }

    pub(crate) fn draw_elements(&mut self, mode: GLenum, count: i32, type_: GLenum, indices: &Indices<'_>) -> Outcome {
        let mode = self.check_draw(mode, count)?;
        index_list(&self.client.arrays, &self.buffers, count, type_, indices)?;
        if count == 0 || !self.start_arrays() {
            return Ok(());
        }
        let Self {
            render_modes,
            pipe,
            draw_workers,
            scene,
            client,
            buffers,
            framebuffer,
            config,
            queries,
            advised,
            ..
        } = self;
        let list = index_list(&client.arrays, buffers, count, type_, indices)?;
        // Only memory of unknown length needs to know which elements are drawn.
        let limits = (client.arrays.has_client_memory() || *advised).then(|| list.limits());
        let range = limits.unwrap_or((0, u32::MAX));
        let needs = pipe.plan.needs;
        let sources = Sources::new(&client.arrays, buffers, range, |place| Sources::wanted(place, needs));
        let short = limits.and_then(|(_, last)| sources.too_short(last).map(|(place, there)| (place, there, last)));
        sources.defaults(&mut pipe.worker.processor.batch);
        let (threads, passed) = (config.threads, &mut queries.passed);
        Drawing { render_modes, pipe, draw_workers, scene, framebuffer, threads, passed }.draw(
            &sources,
            mode,
            ElementOrder::List(list),
        );
        if let Some((place, there, last)) = short {
            self.note(format!(
                "the indices go to element {last}, but the {} array has only {there} elements; zeros stand for the rest",
                super::array_pointers::place_name(place)
            ));
        }
        Ok(())
    }

    pub(crate) fn draw_range_elements(
        &mut self,
        mode: GLenum,
        start: u32,
        end: u32,
        count: i32,
        type_: GLenum,
        indices: &Indices<'_>,
    ) -> Outcome {
        Self::check_range(start, end)?;
        self.draw_elements(mode, count, type_, indices)
    }

    /// The range of DrawRangeElements.
    pub(crate) fn check_range(start: u32, end: u32) -> Outcome {
        if end < start {
            return Err(invalid_value(format!("end = {end} lies before start = {start}")));
        }
        Ok(())
    }

    /// The checks of a draw of several primitives, all of them before the first is drawn.
    fn check_multi_draw(&mut self, mode: GLenum, counts: &[i32], drawcount: i32) -> Outcome {
        self.check_draw(mode, 0)?;
        if drawcount < 0 {
            return Err(invalid_value(format!("drawcount = {drawcount} is negative")));
        }
        if counts.len() < drawcount.unsigned_abs() as usize {
            return Err(too_short("count", drawcount.unsigned_abs() as usize, counts.len(), "values"));
        }
        match counts.iter().position(|count| *count < 0) {
            Some(i) => Err(invalid_value(format!("count[{i}] = {} is negative; nothing is drawn", counts[i]))),
            None => Ok(()),
        }
    }

    pub(crate) fn check_multi_draw_arrays(
        &mut self,
        mode: GLenum,
        first: &[i32],
        count: &[i32],
        drawcount: i32,
    ) -> Outcome {
        self.check_multi_draw(mode, count, drawcount)?;
        if first.len() < count.len() {
            return Err(too_short("first", count.len(), first.len(), "values"));
        }
        match first.iter().zip(count).position(|(first, count)| *first < 0 && *count > 0) {
            Some(i) => Err(invalid_value(format!("first[{i}] = {} is negative; nothing is drawn", first[i]))),
            None => Ok(()),
        }
    }

    pub(crate) fn multi_draw_arrays(&mut self, mode: GLenum, first: &[i32], count: &[i32], drawcount: i32) -> Outcome {
        self.check_multi_draw_arrays(mode, first, count, drawcount)?;
        let primitives = first.iter().zip(count).filter(|(_, count)| **count > 0);
        primitives.into_iter().try_for_each(|(first, count)| self.draw_arrays(mode, *first, *count))
    }

    pub(crate) fn check_multi_draw_elements(
        &mut self,
        mode: GLenum,
        count: &[i32],
        type_: GLenum,
        lists: &[Indices<'_>],
        drawcount: i32,
    ) -> Outcome {
        self.check_multi_draw(mode, count, drawcount)?;
        index_list(&self.client.arrays, &self.buffers, 0, type_, &Indices::Offset(0))?;
        if lists.len() < count.len() {
            return Err(too_short("indices", count.len(), lists.len(), "lists"));
        }
        for (count, list) in count.iter().zip(lists) {
            index_list(&self.client.arrays, &self.buffers, *count, type_, list)?;
        }
        Ok(())
    }

    pub(crate) fn multi_draw_elements(
        &mut self,
        mode: GLenum,
        count: &[i32],
        type_: GLenum,
        lists: &[Indices<'_>],
        drawcount: i32,
    ) -> Outcome {
        self.check_multi_draw_elements(mode, count, type_, lists, drawcount)?;
        let primitives = count.iter().zip(lists).filter(|(count, _)| **count > 0);
        primitives.into_iter().try_for_each(|(count, list)| self.draw_elements(mode, *count, type_, list))
    }

    /// The indices of `DrawElements` as numbers, for a display list.
    pub(crate) fn element_indices(&mut self, count: i32, type_: GLenum, indices: &Indices<'_>) -> Outcome<Vec<u32>> {
        let list = index_list(&self.client.arrays, &self.buffers, count, type_, indices)?;
        let mut all = Vec::new();
        all.try_reserve_exact(list.len()).map_err(|_| crate::error::out_of_memory("no memory left for the indices"))?;
        all.extend(list.numbers());
        Ok(all)
    }

    /// The values of the enabled arrays at an index.
    pub(crate) fn array_element_values(&mut self, index: i32) -> Outcome<ArrayElement> {
        let Ok(id) = u32::try_from(index) else {
            return Err(invalid_value(format!("index {index} is negative")));
        };
        self.check_draw(GL_POINTS, 0)?;
        let sources = Sources::new(&self.client.arrays, &self.buffers, (id, id), |_| true);
        let value = |attribute: Attribute| sources.element(attribute as usize, id);
        let rgb = |[r, g, b, _]: [f32; 4]| [r, g, b];
        let tex_coords = (Attribute::TexCoord as usize..ATTRIBUTES)
            .filter_map(|place| Some(((place - Attribute::TexCoord as usize) as u32, sources.element(place, id)?)));
        Ok(ArrayElement {
            edge_flag: value(Attribute::EdgeFlag).map(|v| v[0] != 0.0),
            fog_coord: value(Attribute::FogCoord).map(|v| v[0]),
            index: value(Attribute::Index).map(|v| v[0]),
            tex_coords: tex_coords.collect(),
            normal: value(Attribute::Normal).map(rgb),
            secondary_color: value(Attribute::SecondaryColor),
            color: value(Attribute::Color),
            vertex: value(Attribute::Vertex),
        })
    }

    pub(crate) fn array_element(&mut self, i: i32) -> Outcome {
        let element = self.array_element_values(i)?;
        if let Some(flag) = element.edge_flag {
            self.edge_flag(flag);
        }
        if let Some(coordinate) = element.fog_coord {
            self.fog_coord(coordinate);
        }
        if let Some(index) = element.index {
            self.index(index);
        }
        for (unit, coordinates) in element.tex_coords {
            self.multi_tex_coord(GL_TEXTURE0.wrapping_add(unit), coordinates)?;
        }
        if let Some(normal) = element.normal {
            self.normal(normal);
        }
        if let Some(color) = element.secondary_color {
            self.secondary_color(color);
        }
        if let Some(color) = element.color {
            self.color(color);
        }
        if let Some(position) = element.vertex {
            self.vertex(position);
        }
        Ok(())
    }
}
