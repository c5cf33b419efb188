//! Selection and feedback (OpenGL 1.5, sections 5.2 and 5.3): in these modes the vertex pipeline ends in a [`Capture`] in
//! place of the scene, so that primitives are clipped and culled as when they are drawn, and then noted: as hits of the names
//! on the name stack, or as tokens and vertices. No command changes the framebuffer meanwhile.

use super::Values;
use super::engine::Engine;
use super::raster_position::{SLOTS, whole_layout};
use crate::enums::gl_enum;
use crate::enums::*;
use crate::error::{Outcome, invalid_operation, invalid_value, known, stack_overflow, stack_underflow};
use crate::fragment::planes::Layout;
use crate::limits::MAX_NAME_STACK_DEPTH;
use crate::num::clamp01;
use crate::raster::vertex::{VertexRef, twice_area};
use crate::raster::{PrimitiveSink, RasterState};
use crate::state::State;
use crate::state::current::RasterPos;
use crate::state::raster::PolygonMode;
use crate::vertex::hand_on::TakePrimitives;

gl_enum! {
    /// What becomes of primitives.
    #[derive(Default)]
    pub(crate) enum RenderMode {
        #[default]
        Render = GL_RENDER,
        Select = GL_SELECT,
        Feedback = GL_FEEDBACK,
    }
}

gl_enum! {
    /// What feedback writes of a vertex.
    #[derive(Default)]
    pub(crate) enum FeedbackType {
        #[default]
        D2 = GL_2D,
        D3 = GL_3D,
        D3Color = GL_3D_COLOR,
        D3ColorTexture = GL_3D_COLOR_TEXTURE,
        D4ColorTexture = GL_4D_COLOR_TEXTURE,
    }
}

/// A buffer of the program's size, which is not allocated before it is written.
#[derive(Clone, Debug)]
struct Record<T> {
    /// How many values may be written; `None` before the program has said so.
    size: Option<usize>,
    values: Vec<T>,
    overflow: bool,
}

impl<T> Default for Record<T> {
    fn default() -> Self {
        Self { size: None, values: Vec::new(), overflow: false }
    }
}

impl<T> Record<T> {
    fn set_size(&mut self, size: usize) {
        (self.size, self.overflow) = (Some(size), false);
        self.values.clear();
    }

    fn clear(&mut self) {
        self.values.clear();
        self.overflow = false;
    }

    fn push(&mut self, value: T) {
        if self.values.len() < self.size.unwrap_or(0) && self.values.try_reserve(1).is_ok() {
            self.values.push(value);
        } else {
            self.overflow = true;
        }
    }
}

/// The state of both modes.
#[derive(Clone, Debug, Default)]
pub(crate) struct RenderModes {
    pub(crate) mode: RenderMode,
    feedback_type: FeedbackType,
    feedback: Record<f32>,
    selection: Record<u32>,
    hits: u32,
    names: Vec<u32>,
    /// The least and the greatest window z of what was hit since the last record.
    hit: Option<[f64; 2]>,
    /// The rasteriser's state and the slots of the vertices that are captured.
    raster: Option<RasterState>,
    layout: Layout,
}

impl RenderModes {
    /// The sink of primitives that are captured, unless they are drawn.
    pub(crate) fn capture(&mut self) -> Option<Capture<'_>> {
        match self.mode {
            RenderMode::Render => None,
            RenderMode::Select | RenderMode::Feedback => Some(Capture(self)),
        }
    }

    /// Takes the state for the primitives to come; gives the layout of their vertices.
    pub(crate) fn prepare(&mut self, state: &State, raster: RasterState) -> &Layout {
        self.layout = match self.mode {
            RenderMode::Feedback => {
                let mut layout = whole_layout();
                if state.lighting.enabled && state.lighting.model.two_side {
                    layout.back = Some(layout.count);
                    layout.stride += 7;
                }
                layout
            }
            RenderMode::Render | RenderMode::Select => Layout::default(),
        };
        self.raster = Some(raster);
        &self.layout
    }

    /// Notes that the clip volume was hit at a window z.
    fn hit(&mut self, z: f64) {
        let [least, greatest] = self.hit.get_or_insert([z, z]);
        *least = least.min(z);
        *greatest = greatest.max(z);
    }

    /// Writes the record of the hits so far, if there were any.
    fn write_hits(&mut self) {
        let Some(depths) = self.hit.take() else { return };
        let scaled = |z: f64| (z.clamp(0.0, 1.0) * f64::from(u32::MAX)).round() as u32;
        self.hits += 1;
        self.selection.push(self.names.len() as u32);
        depths.into_iter().for_each(|z| self.selection.push(scaled(z)));
        for name in &self.names {
            self.selection.push(*name);
        }
    }

    /// Writes a vertex; its colours are those of `colors`, of a back face or not.
    fn vertex(&mut self, v: VertexRef<'_>, colors: &[f32], back: bool) {
        let [x, y, z] = v.head.window.map(|c| c as f32);
        let w = v.head.clip[3] as f32;
        let color = if back { self.layout.back } else { None }.unwrap_or(SLOTS.color);
        let part = |slots: &[f32], at: usize| -> [f32; 4] {
            slots.get(at..).and_then(|s| s.first_chunk()).copied().unwrap_or_default()
        };
        let (color, coordinates) = (part(colors, color).map(clamp01), part(v.slots, SLOTS.coordinates));
        let position: &[f32] = match self.feedback_type {
            FeedbackType::D2 => &[x, y],
            FeedbackType::D4ColorTexture => &[x, y, z, w],
            FeedbackType::D3 | FeedbackType::D3Color | FeedbackType::D3ColorTexture => &[x, y, z],
        };
        let (has_color, has_coordinates) = match self.feedback_type {
            FeedbackType::D2 | FeedbackType::D3 => (false, false),
            FeedbackType::D3Color => (true, false),
            FeedbackType::D3ColorTexture | FeedbackType::D4ColorTexture => (true, true),
        };
        position.iter().for_each(|v| self.feedback.push(*v));
        if has_color {
            color.into_iter().for_each(|v| self.feedback.push(v));
        }
        if has_coordinates {
            coordinates.into_iter().for_each(|v| self.feedback.push(v));
        }
    }

    fn token(&mut self, token: GLenum) {
        self.feedback.push(token as f32);
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: Option<&[f32]>, back: bool, restart: bool) {
        self.token(if restart { GL_LINE_RESET_TOKEN } else { GL_LINE_TOKEN });
        for v in ends {
            self.vertex(v, provoking.unwrap_or(v.slots), back);
        }
    }
}

/// Takes primitives as hits or as feedback.
#[derive(Debug)]
pub(crate) struct Capture<'a>(&'a mut RenderModes);

impl PrimitiveSink for Capture<'_> {
    fn triangle(&mut self, v: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        let modes = &mut *self.0;
        let Some(rs) = &modes.raster else { return };
        let area = twice_area(&v.map(|v| v.head.snapped));
        let back = area == 0 || (area > 0) != rs.ccw_is_front;
        if rs.cull[usize::from(back)] {
            return;
        }
        if modes.mode == RenderMode::Select {
            return v.iter().for_each(|v| modes.hit(v.head.window[2]));
        }
        let (mode, flat) = (rs.mode[usize::from(back)], rs.flat);
        let colors = |i: usize| if flat { v[provoking].slots } else { v[i].slots };
        match mode {
            PolygonMode::Fill => {
                modes.token(GL_POLYGON_TOKEN);
                modes.feedback.push(3.0);
                (0..3).for_each(|i| modes.vertex(v[i], colors(i), back));
            }
            PolygonMode::Line => {
                for i in (0..3).filter(|i| edges[*i]) {
                    let provoking = if flat { Some(v[provoking].slots) } else { None };
                    modes.line([v[i], v[(i + 1) % 3]], provoking, back, i == 0);
                }
            }
            PolygonMode::Point => {
                for i in (0..3).filter(|i| edges[*i]) {
                    modes.token(GL_POINT_TOKEN);
                    modes.vertex(v[i], colors(i), back);
                }
            }
        }
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize, restart: bool) {
        let modes = &mut *self.0;
        if modes.mode == RenderMode::Select {
            return ends.iter().for_each(|v| modes.hit(v.head.window[2]));
        }
        let flat = modes.raster.as_ref().is_some_and(|rs| rs.flat);
        let provoking = ends.get(provoking).filter(|_| flat).map(|v| v.slots);
        modes.line(ends, provoking, false, restart);
    }

    fn point(&mut self, vertex: VertexRef<'_>) {
        let modes = &mut *self.0;
        if modes.mode == RenderMode::Select {
            return modes.hit(vertex.head.window[2]);
        }
        modes.token(GL_POINT_TOKEN);
        modes.vertex(vertex, vertex.slots, false);
    }

    fn culls(&self) -> [bool; 2] {
        self.0.raster.as_ref().map_or([false; 2], RasterState::culls)
    }
}

impl TakePrimitives for Capture<'_> {}

impl Engine {
    pub(crate) fn render_mode(&mut self, mode: GLenum) -> Outcome<i32> {
        let mode = known(RenderMode::from_gl(mode), mode, "GL_RENDER, GL_SELECT or GL_FEEDBACK")?;
        let modes = &self.render_modes;
        let needed = match mode {
            RenderMode::Render => None,
            RenderMode::Select => modes.selection.size.is_none().then_some("glSelectBuffer"),
            RenderMode::Feedback => modes.feedback.size.is_none().then_some("glFeedbackBuffer"),
        };
        if let Some(command) = needed {
            return Err(invalid_operation(format!("there is no buffer to write to; call {command} first")));
        }
        self.run_vertices();
        let modes = &mut self.render_modes;
        let written = match modes.mode {
            RenderMode::Render => Some(0),
            RenderMode::Select => {
                modes.write_hits();
                Some(modes.hits.cast_signed()).filter(|_| !modes.selection.overflow)
            }
            RenderMode::Feedback => {
                let written = i32::try_from(modes.feedback.values.len()).unwrap_or(i32::MAX);
                Some(written).filter(|_| !modes.feedback.overflow)
            }
        };
        match mode {
            RenderMode::Render => {}
            RenderMode::Select => modes.selection.clear(),
            RenderMode::Feedback => modes.feedback.clear(),
        }
        (modes.mode, modes.hits, modes.hit) = (mode, 0, None);
        modes.names.clear();
        // The next primitive is prepared for the new mode.
        self.drawing = false;
        Ok(written.unwrap_or(-1))
    }

    pub(crate) fn feedback_buffer(&mut self, size: i32, type_: GLenum) -> Outcome {
        let type_ = known(FeedbackType::from_gl(type_), type_, "a feedback type (GL_2D to GL_4D_COLOR_TEXTURE)")?;
        let size = self.check_buffer(size, RenderMode::Feedback)?;
        self.render_modes.feedback_type = type_;
        self.render_modes.feedback.set_size(size);
        Ok(())
    }

    pub(crate) fn select_buffer(&mut self, size: i32) -> Outcome {
        let size = self.check_buffer(size, RenderMode::Select)?;
        self.render_modes.selection.set_size(size);
        Ok(())
    }

    fn check_buffer(&self, size: i32, mode: RenderMode) -> Outcome<usize> {
        let size =
            usize::try_from(size).map_err(|_| invalid_value(format!("a size of {size}; it must not be negative")))?;
        if self.render_modes.mode == mode {
            return Err(invalid_operation(format!("the mode is {} already; end it first", mode.name())));
        }
        Ok(size)
    }

    /// What the last feedback mode has written.
    pub(crate) fn feedback_values(&self) -> &[f32] {
        &self.render_modes.feedback.values
    }

    /// What the last selection mode has written.
    pub(crate) fn select_values(&self) -> &[u32] {
        &self.render_modes.selection.values
    }

    /// Whether primitives are drawn, and commands change the framebuffer.
    pub(crate) fn renders(&self) -> bool {
        self.render_modes.mode == RenderMode::Render
    }

    /// Before the name stack changes: what was hit by the names so far is written. False outside of selection mode, where
    /// commands of the name stack do nothing.
    fn selects(&mut self) -> bool {
        if self.render_modes.mode != RenderMode::Select {
            return false;
        }
        self.run_vertices();
        true
    }

    pub(crate) fn init_names(&mut self) {
        if self.selects() {
            self.render_modes.write_hits();
            self.render_modes.names.clear();
        }
    }

    pub(crate) fn load_name(&mut self, name: u32) -> Outcome {
        if !self.selects() {
            return Ok(());
        }
        if self.render_modes.names.is_empty() {
            return Err(invalid_operation("the name stack is empty; glPushName puts the first name on it"));
        }
        self.render_modes.write_hits();
        if let Some(top) = self.render_modes.names.last_mut() {
            *top = name;
        }
        Ok(())
    }

    pub(crate) fn push_name(&mut self, name: u32) -> Outcome {
        if !self.selects() {
            return Ok(());
        }
        if self.render_modes.names.len() >= MAX_NAME_STACK_DEPTH {
            return Err(stack_overflow(format!("the name stack holds {MAX_NAME_STACK_DEPTH} names already")));
        }
        self.render_modes.write_hits();
        self.render_modes.names.push(name);
        Ok(())
    }

    pub(crate) fn pop_name(&mut self) -> Outcome {
        if !self.selects() {
            return Ok(());
        }
        if self.render_modes.names.is_empty() {
            return Err(stack_underflow("the name stack is empty"));
        }
        self.render_modes.write_hits();
        self.render_modes.names.pop();
        Ok(())
    }

    pub(crate) fn pass_through(&mut self, token: f32) {
        if self.render_modes.mode == RenderMode::Feedback {
            self.run_vertices();
            self.render_modes.token(GL_PASS_THROUGH_TOKEN);
            self.render_modes.feedback.push(token);
        }
    }

    /// A valid raster position hits the clip volume.
    pub(crate) fn select_raster_position(&mut self) {
        let RasterPos { position: [.., z, _], valid, .. } = self.state.current.raster;
        if valid && self.selects() {
            self.render_modes.hit(z);
        }
    }

    /// The token of a command that draws at the raster position, with the position as a vertex. False where the command is to
    /// draw.
    pub(crate) fn captures_pixels(&mut self, token: GLenum) -> bool {
        if self.render_modes.mode == RenderMode::Feedback {
            self.run_vertices();
            let (head, slots) = super::raster_position::raster_vertex(&self.state.current.raster, &whole_layout());
            self.render_modes.token(token);
            self.render_modes.vertex(VertexRef { head: &head, slots: &slots }, &slots, false);
        }
        !self.renders()
    }

    /// State of both modes, for Get.
    pub(crate) fn render_mode_value(&self, pname: GLenum) -> Option<Values> {
        let modes = &self.render_modes;
        let size = |size: Option<usize>| Values::int(i32::try_from(size.unwrap_or(0)).unwrap_or(i32::MAX));
        Some(match pname {
            GL_RENDER_MODE => Values::enumerant(modes.mode.gl()),
            GL_NAME_STACK_DEPTH => Values::int(modes.names.len() as i32),
            GL_FEEDBACK_BUFFER_SIZE => size(modes.feedback.size),
            GL_FEEDBACK_BUFFER_TYPE => Values::enumerant(modes.feedback_type.gl()),
            GL_SELECTION_BUFFER_SIZE => size(modes.selection.size),
            _ => return None,
        })
    }
}
