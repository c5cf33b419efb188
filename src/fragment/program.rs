//! The fragment program: the list of stages that the state needs, built once for a draw and run over every batch. What
//! the state makes a no-op is left out, each time for a condition under which the stage would change no bit; the list of
//! what was kept and left out, with the reasons, stays with the program so that it can be explained.

use super::batch::FragmentBatch;
use super::compare::Func;
use super::planes::{Layout, Plane, Planes};
use super::uniforms::{FragFn, FragUniforms, Work};
use super::{depth, interpolate, pack};
use crate::batch::{Level, Stage, Step};
use crate::enums::GL_NONE;
use crate::framebuffer::{Band, FramebufferFormat};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::State;
use crate::texture::object::TextureObject;

/// How a program is to be built, apart from the state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Leave nothing out that could be kept: a program that gives the same bytes, for tests of exactly that.
    pub general: bool,
    /// The draw's primitives have coverage (smooth points, lines or polygons): the rasteriser writes
    /// [`FragmentBatch::coverage`] for each lane.
    pub coverage: bool,
    /// An occlusion query is active: count the fragments that pass the tests in [`Band::samples`].
    pub count_samples: bool,
}

/// What became of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is in the program.
    Kept,
    /// It is not: it would change nothing.
    LeftOut,
    /// It is done earlier or less often than for every fragment in the spec's order.
    Hoisted,
}

/// A line of a program's explanation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decision {
    /// What the stage does, in a word or two.
    pub stage: String,
    /// What became of it.
    pub fate: Fate,
    /// Why, in a sentence.
    pub reason: String,
}

/// One step of a program.
#[derive(Clone, Copy, Debug)]
enum Action {
    /// A fragment stage.
    Stage(Step<FragFn>),
    /// Go on only if a fragment is alive.
    StopIfDead,
}

/// A fragment program.
#[derive(Clone, Debug)]
pub struct Program {
    /// Which values the vertex stages and setup have to provide.
    pub layout: Layout,
    /// Whether the program reads what earlier fragments wrote: then a pixel must not be twice in a batch.
    pub reads_framebuffer: bool,
    /// Whether nothing can change by drawing: the whole draw may be dropped.
    pub draws_nothing: bool,
    /// Whether the rasteriser has to write [`FragmentBatch::coverage`].
    pub coverage: bool,
    /// What was decided about each stage.
    pub decisions: Vec<Decision>,
    level: Level,
    uniforms: FragUniforms,
    actions: Vec<Action>,
}

impl Program {
    /// The program for a state. `textures` are the complete textures of the units that have texturing on.
    #[must_use]
    pub fn build(
        level: Level,
        state: &State,
        _textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS],
        format: &FramebufferFormat,
        options: Options,
    ) -> Self {
        let mut p = Self {
            layout: Layout::default(),
            reads_framebuffer: false,
            draws_nothing: false,
            coverage: options.coverage,
            decisions: Vec::new(),
            level: level.at_most_available(),
            uniforms: FragUniforms::default(),
            actions: Vec::new(),
        };
        let color_mask = crate::framebuffer::packed_mask(state.color_buffer.color_mask);
        p.uniforms.color_mask = if state.color_buffer.draw_buffer == GL_NONE { 0 } else { color_mask };
        p.uniforms.packed_or = crate::framebuffer::no_alpha_bits(format);
        p.uniforms.depth_max = f64::from(format.depth_max());
        p.layout.color = Some(0);
        p.layout.count = 4;
        p.layout.stride = 4;
        p.uniforms.layout = p.layout.clone();
        p.stage(&depth::BEGIN, 0);
        if state.depth.test && format.depth_bits != 0 {
            let func = Func::from_enum(state.depth.func);
            p.stage(&depth::DEPTH, 0);
            p.stage(&depth::DEPTH_TEST, (func as u32) << 1 | u32::from(state.depth.mask));
            p.actions.push(Action::StopIfDead);
            p.reads_framebuffer = true;
        }
        p.stage(&pack::COLOR_PACKED, interpolate::FIRST);
        if p.uniforms.color_mask != u32::MAX {
            p.stage(&pack::LOAD, 0);
            p.stage(&pack::COLOR_MASK, 0);
        }
        p.stage(&pack::STORE, 0);
        p
    }

    /// Appends a stage.
    fn stage(&mut self, stage: &Stage<FragFn>, arg: u32) {
        self.actions.push(Action::Stage(Step { name: stage.name, run: stage.levels[self.level as usize], arg }));
    }

    /// Runs the program over a batch: `segments` and `tex.n` are set, and for lanes of segments that are no rows
    /// `offset`, `dx` and `dy`. `planes` and `pool` are the scene's. The batch can be cleared and filled again after it.
    #[inline]
    pub fn run(&self, batch: &mut FragmentBatch, planes: &[Planes], pool: &[Plane], band: &mut Band<'_>) {
        let mut work = Work { planes, pool, band };
        for action in &self.actions {
            match action {
                Action::Stage(step) => {
                    #[expect(unsafe_code, reason = "the level was checked when the program was built")]
                    // SAFETY: `build` takes no level that the processor does not have.
                    unsafe {
                        (step.run)(batch, &self.uniforms, &mut work, step.arg);
                    }
                }
                Action::StopIfDead if !batch.alive => return,
                Action::StopIfDead => {}
            }
        }
    }
}
