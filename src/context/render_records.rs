//! Selection and feedback as data (OpenGL 1.5, sections 5.2 and 5.3), and the [`Capture`], which takes primitives in place of the
//! scene: they are clipped and culled as when they are drawn, and then noted, as hits of the names on the name stack, or as
//! tokens and vertices.

use super::whole_vertex::{SLOTS, whole_layout};
use crate::enums::gl_enum;
use crate::enums::*;
use crate::fragment::planes::Layout;
use crate::num::clamp01;
use crate::raster::vertex::{VertexRef, twice_area};
use crate::raster::{PrimitiveSink, RasterState};
use crate::state::State;
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
pub(super) struct Record<T> {
    /// How many values may be written; `None` before the program has said so.
    pub(super) size: Option<usize>,
    pub(super) values: Vec<T>,
    pub(super) overflow: bool,
}

impl<T> Default for Record<T> {
    fn default() -> Self {
        Self { size: None, values: Vec::new(), overflow: false }
    }
}

impl<T> Record<T> {
    pub(super) fn set_size(&mut self, size: usize) {
        (self.size, self.overflow) = (Some(size), false);
        self.values.clear();
    }

    pub(super) fn clear(&mut self) {
        self.values.clear();
        self.overflow = false;
    }

    pub(super) fn push(&mut self, value: T) {
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
    pub(super) feedback_type: FeedbackType,
    pub(super) feedback: Record<f32>,
    pub(super) selection: Record<u32>,
    pub(super) hits: u32,
    pub(super) names: Vec<u32>,
    /// The least and the greatest window z of what was hit since the last record.
    pub(super) hit: Option<[f64; 2]>,
    /// The rasteriser's state and the slots of the vertices that are captured.
    raster: Option<RasterState>,
    layout: Layout,
    /// Whether the line stipple starts anew with the next line.
    restart: bool,
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
    pub(super) fn hit(&mut self, z: f64) {
        let [least, greatest] = self.hit.get_or_insert([z, z]);
        *least = least.min(z);
        *greatest = greatest.max(z);
    }

    /// Writes the record of the hits so far, if there were any.
    pub(super) fn write_hits(&mut self) {
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
    pub(super) fn vertex(&mut self, v: VertexRef<'_>, colors: &[f32], back: bool) {
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

    pub(super) fn token(&mut self, token: GLenum) {
        self.feedback.push(token as f32);
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: Option<&[f32]>, back: bool) {
        let token = if std::mem::take(&mut self.restart) { GL_LINE_RESET_TOKEN } else { GL_LINE_TOKEN };
        self.token(token);
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
                    modes.line([v[i], v[(i + 1) % 3]], provoking, back);
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

    fn restart_stipple(&mut self) {
        self.0.restart = true;
    }

    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize) {
        let modes = &mut *self.0;
        if modes.mode == RenderMode::Select {
            return ends.iter().for_each(|v| modes.hit(v.head.window[2]));
        }
        let flat = modes.raster.as_ref().is_some_and(|rs| rs.flat);
        let provoking = ends.get(provoking).filter(|_| flat).map(|v| v.slots);
        modes.line(ends, provoking, false);
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
