//! Commands of selection and feedback (OpenGL 1.5, sections 5.2 and 5.3). While one of the two modes is on, no command
//! changes the framebuffer.

use super::Values;
use super::engine::Engine;
use super::render_records::{FeedbackType, RenderMode};
use super::whole_vertex::{raster_vertex, whole_layout};
use crate::enums::*;
use crate::error::{Outcome, invalid_operation, invalid_value, known, stack_overflow, stack_underflow};
use crate::limits::MAX_NAME_STACK_DEPTH;
use crate::raster::vertex::VertexRef;
use crate::state::current::RasterPos;

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
            let (head, slots) = raster_vertex(&self.state.current.raster, &whole_layout());
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
