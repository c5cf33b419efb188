//! From state to plans: before vertices are processed, whatever changed since the last draw is rebuilt, in the order in
//! which the rooms depend on each other (textures, fragment program, rasteriser state, vertex plan). Nothing is rebuilt
//! that is not stale, and nothing else in the engine builds a plan.

use super::begin_end::LONG;
use super::engine::Engine;
use crate::enums::name;
use crate::fragment::pixel_rect::PixelRect;
use crate::fragment::program::{Decision, Options, Program};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::raster::{Draw, RasterState};
use crate::simd::{Counters, Tally};
use crate::state::Dirty;
use crate::state::raster::PolygonMode;
use crate::state::texture::Target;
use crate::texture::object::TextureObject;
use crate::texture::sampler;
use crate::vertex::plan::Wants;
use std::sync::Arc;

/// How many pieces of advice are remembered, so that none is given twice.
const ADVICE: usize = 64;

/// The target that applies to a unit: of the enabled ones the last in the order of precedence.
fn effective_target(enabled: [bool; 5]) -> Option<Target> {
    Target::ALL.into_iter().rev().find(|target| enabled[*target as usize])
}

impl Engine {
    /// Brings the plans up to date with the state. Vertices that still wait run by the old plans first.
    pub(crate) fn validate(&mut self) {
        self.unseen = true;
        if !self.dirty.any() && self.drawing {
            return;
        }
        self.run_vertices();
        if !self.renders() {
            return self.validate_capture();
        }
        if self.dirty.fragment || self.program.is_none() {
            self.program = Some(Arc::new(self.build_program(true, None)));
        }
        let Some(program) = self.program.clone() else { return };
        let raster = self.raster_state();
        let polygons_filled = self.state.polygon.mode == [PolygonMode::Fill; 2];
        let wants = Wants { exact_volume: !polygons_filled, edges: !polygons_filled };
        self.pipe.rebuild(&self.state, &program.layout, wants);
        self.scene.begin_draw(Arc::new(Draw { program, raster }));
        self.dirty = Dirty::NONE;
        self.drawing = true;
    }

    /// The same for primitives that are captured: they are clipped to all planes, and have every value that can be asked for.
    fn validate_capture(&mut self) {
        let raster = self.raster_state();
        let layout = self.render_modes.prepare(&self.state, raster);
        self.pipe.rebuild(&self.state, layout, Wants { exact_volume: true, edges: true });
        // The fragment program is still to be brought up to date.
        self.dirty = Dirty { fragment: self.dirty.fragment, ..Dirty::NONE };
        self.drawing = true;
    }

    /// How primitives become fragments in the present state.
    pub(crate) fn raster_state(&self) -> RasterState {
        let (width, height) = (self.framebuffer.width(), self.framebuffer.height());
        RasterState::build(&self.state, width, height, u32::from(self.framebuffer.format().depth_bits))
    }

    /// What is decided about each stage of the present state's program, in words. The programs that draw know none.
    pub(crate) fn decisions(&mut self) -> Vec<Decision> {
        self.build_program(false, None).decisions
    }

    /// The fragment program of the present state, for primitives or for a pixel rectangle.
    pub(crate) fn build_program(&mut self, silent: bool, pixels: Option<Arc<PixelRect>>) -> Program {
        let chosen: [Option<(Target, u32)>; MAX_TEXTURE_UNITS] = std::array::from_fn(|unit| {
            let unit = &self.state.texture.units[unit];
            effective_target(unit.enabled).map(|target| (target, unit.bound[target as usize]))
        });
        let ready: [bool; MAX_TEXTURE_UNITS] =
            std::array::from_fn(|unit| chosen[unit].is_some_and(|(target, texture)| self.ready(unit, target, texture)));
        let textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS] = std::array::from_fn(|unit| {
            let (target, texture) = chosen[unit].filter(|_| ready[unit])?;
            Some(self.textures.object(target, texture))
        });
        let s = &self.state;
        let options = Options {
            general: self.config.general_plan,
            coverage: pixels.is_none() && (s.point.smooth || s.line.smooth || s.polygon.smooth),
            count_samples: self.queries.is_counting(),
            q_units: self.q_units,
            pixels,
            silent,
        };
        let program = Program::build(self.config.level, s, textures, self.framebuffer.format(), options);
        match &self.tally {
            Some(tally) => program.counted(tally),
            None => program,
        }
    }

    /// Counts what is done from now on, or does not. Nothing may wait to be drawn.
    pub(crate) fn count_into(&mut self, tally: Option<Tally>) {
        // What was done before counts for nobody.
        _ = self.gather_counts();
        self.tally = tally;
        self.dirty.fragment = true;
    }

    /// Adds what vertices and primitives went through to the tally; gives all that it holds.
    pub(crate) fn gather_counts(&mut self) -> Counters {
        let mut counters = Counters::default();
        let mut idle = self.setup_jobs.idle();
        let jobs = idle.iter_mut().map(|job| &mut job.worker);
        for worker in std::iter::once(&mut self.pipe.worker).chain(&mut self.draw_workers).chain(jobs) {
            worker.processor.counts.drain_into(&mut counters);
        }
        drop(idle);
        counters.levels_built = std::mem::take(&mut self.textures.levels_built);
        let Some(tally) = &self.tally else { return Counters::default() };
        let mut all = Counters::default();
        Counters::with(tally, |tally| {
            tally.add_vertices(&counters);
            all.clone_from(tally);
        });
        all
    }

    /// Whether the texture of a unit can be sampled, with its rings filled. If not, a note says why.
    fn ready(&mut self, unit: usize, target: Target, texture: u32) -> bool {
        if self.textures.object(target, texture).parameters.min_filter.has_mipmaps()
            && let Err(error) = self.ensure_mip_levels(target, texture)
        {
            self.note(error.message);
        }
        let object = self.textures.object_mut(target, texture);
        let why = match object.complete() {
            Ok(()) => match sampler::prepare(object) {
                Ok(()) => return true,
                Err(error) => error.message,
            },
            Err(why) => why.to_string(),
        };
        self.note(format!("texture unit {unit} draws without its {} texture {texture}: {why}", name(target.gl())));
        false
    }

    /// Runs the vertices that wait, by the plans of when they were issued.
    pub(crate) fn run_vertices(&mut self) {
        if self.pipe.is_waiting() {
            match self.render_modes.capture() {
                Some(mut capture) => self.pipe.run(&mut capture),
                None => self.pipe.run(&mut self.scene),
            }
            self.make_room();
        }
    }

    /// Flushes the scene where its memory is used up.
    pub(crate) fn make_room(&mut self) {
        if self.scene.is_full() {
            let passed = self.scene.make_room(&mut self.framebuffer, self.config.threads);
            self.queries.passed += passed;
        } else if self.batches >= LONG && self.inside_begin_end() {
            self.scene.start_rasterising(&mut self.framebuffer, self.config.threads);
        }
    }

    /// Carries out everything that was drawn so far.
    pub(crate) fn flush_scene(&mut self) {
        self.run_vertices();
        if !self.scene.is_empty() {
            let passed = self.scene.make_room(&mut self.framebuffer, self.config.threads);
            self.queries.passed += passed;
        }
        self.framebuffer.apply_deferred_clear();
    }

    /// Forgets everything that was drawn and has not reached the framebuffer, whose colours are not touched.
    #[cfg_attr(not(feature = "capi"), expect(dead_code, reason = "only C hands over its own memory"))]
    pub(crate) fn discard_scene(&mut self) {
        self.queries.passed += self.scene.wait(&mut self.framebuffer);
        self.pipe.run(&mut self.scene);
        self.scene.discard();
        self.framebuffer.forget_deferred_clear();
        self.unseen = false;
    }

    /// Lets go of the plans of draws that are done, so that a texture that is written next is not held by them and need
    /// not be copied.
    pub(crate) fn release_draws(&mut self) {
        if self.scene.is_empty() && !self.pipe.is_waiting() {
            self.scene.flush(&mut self.framebuffer, 1);
            self.program = None;
            self.drawing = false;
        }
    }

    /// Keeps advice for the debug callback. The same advice is given once (or again after [`ADVICE`] others).
    pub(crate) fn note(&mut self, text: String) {
        if self.told.len() >= ADVICE {
            self.told.clear();
        }
        if self.notes.len() < ADVICE && self.told.insert(text.clone()) {
            self.notes.push(text);
        }
    }

    /// Whether there is advice to fetch.
    pub(crate) fn has_notes(&self) -> bool {
        !self.notes.is_empty()
    }

    /// The advice since the last time.
    pub(crate) fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }
}
