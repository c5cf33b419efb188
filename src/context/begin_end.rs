//! Begin, End and what stands between them (OpenGL 1.5, sections 2.6, 2.7 and 2.10): the current attributes, vertices,
//! rectangles. A vertex is one append to the batch that waits in the pipe; the batch runs when it is full, or when
//! something asks for what was drawn. State cannot change between Begin and End, except for materials: before one
//! changes, the vertices that wait run with the material of their time.

use super::engine::{Engine, Primitive};
use super::immediate_fast::ImmediateFast;
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation, known};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::primitive::PrimitiveMode;

/// Batches from which on a Begin/End is long: it may come to as much again, so another thread is worth its start, whom End
/// has to wait for.
pub(super) const LONG: usize = 96;

/// A mode of Begin and of the draw commands, or INVALID_ENUM.
pub(crate) fn check_mode(mode: GLenum) -> Outcome<PrimitiveMode> {
    known(PrimitiveMode::from_gl(mode), mode, "a primitive; there are GL_POINTS (0) to GL_POLYGON (9)")
}

#[cold]
fn nested() -> GlError {
    invalid_operation("glBegin inside of glBegin and glEnd; call glEnd first")
}

impl Engine {
    /// Whether a Begin has been carried out and its End has not.
    #[inline]
    pub(crate) fn inside_begin_end(&mut self) -> bool {
        self.primitive != Primitive::Outside
    }

    pub(crate) fn begin(&mut self, mode: GLenum) -> Outcome {
        if self.primitive != Primitive::Outside {
            return Err(nested());
        }
        let mode = check_mode(mode)?;
        self.validate();
        self.primitive = Primitive::Inside;
        self.batches = 0;
        self.pipe.begin(mode);
        Ok(())
    }

    pub(crate) fn end(&mut self) -> Outcome {
        if std::mem::take(&mut self.primitive) == Primitive::Outside {
            return Err(invalid_operation("glEnd without a glBegin before it"));
        }
        // What is left is set up while a thread walks; after the command nobody but this one writes to the framebuffer.
        if self.pipe.end() || self.scene.is_rasterising() {
            self.run_vertices();
        } else {
            self.draw_collected();
        }
        self.queries.passed += self.scene.wait(&mut self.framebuffer);
        Ok(())
    }

    /// A vertex with the current attributes. Outside of Begin and End it does nothing.
    #[inline]
    pub(crate) fn vertex(&mut self, position: [f32; 4]) {
        if !ImmediateFast::vertex(self, position) {
            self.rare_vertex(position);
        }
    }

    /// A vertex that fills its batch, that comes after a change, or that is outside.
    #[inline(never)]
    fn rare_vertex(&mut self, position: [f32; 4]) {
        match self.primitive {
            Primitive::Inside => {
                if self.pipe.vertex(position, &self.state.current) {
                    self.batch_is_full();
                }
            }
            Primitive::Outside => {}
            Primitive::Stale => self.vertex_after_change(position),
        }
    }

    /// Runs the full batch. Where several threads draw, the vertices of a long primitive are collected for them first. Two
    /// threads share out small triangles in another way: one walks, and gets some of the vertices.
    pub(crate) fn batch_is_full(&mut self) {
        self.batches += 1;
        let collects = match self.config.threads {
            1 => false,
            2 => self.scene.wants_setup_work() || self.scene.has_large_primitives() || self.pipe.has_collected(),
            _ => true,
        };
        if collects && self.renders() && self.scene.can_be_split() && self.pipe.collect() {
            self.draw_collected();
        } else {
            self.run_vertices();
        }
    }

    fn draw_collected(&mut self) {
        if self.scene.is_rasterising() {
            if let Some(job) = self.pipe.take_setup_job(&self.setup_jobs) {
                self.scene.set_up(job);
            }
            return;
        }
        let Some((mode, store)) = self.pipe.take_collected() else { return };
        self.draw_source(&store, mode, store.order());
        self.pipe.give_back(store);
    }

    #[cold]
    fn vertex_after_change(&mut self, position: [f32; 4]) {
        self.primitive = Primitive::Inside;
        self.validate();
        self.vertex(position);
    }

    #[inline]
    pub(crate) fn color(&mut self, color: [f32; 4]) {
        if !ImmediateFast::color(self, color) {
            self.state.current.color = color;
            self.track_color();
        }
    }

    #[inline]
    pub(crate) fn secondary_color(&mut self, color: [f32; 4]) {
        ImmediateFast::secondary_color(self, color);
    }

    #[inline]
    pub(crate) fn normal(&mut self, normal: [f32; 3]) {
        ImmediateFast::normal(self, normal);
    }

    #[inline]
    pub(crate) fn tex_coord(&mut self, coordinates: [f32; 4]) {
        if !ImmediateFast::tex_coord(self, coordinates) {
            self.state.current.tex_coord[0] = coordinates;
            self.unit_has_q(0);
        }
    }

    /// A unit is given a q that is not 1: from now on its q is interpolated.
    pub(crate) fn unit_has_q(&mut self, unit: usize) {
        let bit = 1u32.checked_shl(unit as u32).unwrap_or(0);
        if self.q_units & bit == bit {
            return;
        }
        self.q_units |= bit;
        self.dirty.fragment = true;
        if self.primitive != Primitive::Outside {
            self.run_vertices();
            self.primitive = Primitive::Stale;
        }
    }

    #[inline]
    pub(crate) fn multi_tex_coord(&mut self, target: GLenum, coordinates: [f32; 4]) -> Outcome {
        if ImmediateFast::multi_tex_coord(self, target, coordinates) {
            return Ok(());
        }
        let unit = target.wrapping_sub(GL_TEXTURE0) as usize;
        match self.state.current.tex_coord.get_mut(unit) {
            Some(current) => {
                *current = coordinates;
                self.unit_has_q(unit);
                Ok(())
            }
            None => Err(invalid_enum(format!(
                "{} is not a texture unit; there are GL_TEXTURE0 to GL_TEXTURE{}",
                name(target),
                MAX_TEXTURE_UNITS - 1
            ))),
        }
    }

    #[inline]
    pub(crate) fn fog_coord(&mut self, coordinate: f32) {
        ImmediateFast::fog_coord(self, coordinate);
    }

    #[inline]
    pub(crate) fn index(&mut self, index: f32) {
        ImmediateFast::index(self, index);
    }

    #[inline]
    pub(crate) fn edge_flag(&mut self, flag: bool) {
        ImmediateFast::edge_flag(self, flag);
    }

    /// A rectangle with sides parallel to the axes, as a polygon.
    pub(crate) fn rect(&mut self, [x1, y1, x2, y2]: [f32; 4]) -> Outcome {
        self.begin(GL_POLYGON)?;
        for [x, y] in [[x1, y1], [x2, y1], [x2, y2], [x1, y2]] {
            self.vertex([x, y, 0.0, 1.0]);
        }
        self.end()
    }

    /// Vertices that were issued before keep the material of their time.
    pub(crate) fn before_material_change(&mut self) {
        if self.primitive != Primitive::Outside {
            self.run_vertices();
            self.primitive = Primitive::Stale;
        }
    }
}
