//! From the state to a fragment program. Each stage is kept or left out by an exact condition on the state, never by an
//! "almost" on floats: a program built with [`Options::general`] keeps everything and gives the same bytes. The order is
//! that of the specification (texturing, colour sum, fog, coverage, alpha, stencil, depth, blending, logic op, masks),
//! except that stencil and depth tests move to the front where nothing between them and there can tell the difference.

mod colors;
mod store;
mod summary;
mod texturing;

use super::compare::CompareFunc;
use super::hiz::{HIZ_CULL, HIZ_UPDATE, Hiz, uses_hiz};
use super::key::{FragmentKey, FragmentSource, Tests};
use super::planes::Layout;
use super::program::{Action, Decision, Fate, Options, Program};
use super::reference::interpolate::FIRST;
use super::reference::{alpha, depth, early_depth, env_pack, interpolate, pixel_rect, stencil, texcoord};
use super::span::kernels::SpanKernel;
use super::uniforms::{FragFn, FragUniforms};
use crate::framebuffer::FramebufferFormat;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::simd::{Level, Stage, Step};
use crate::state::State;
use crate::texture::object::TextureObject;
use std::fmt::{self, Display};

/// A program in the making.
struct Builder<'a> {
    level: Level,
    state: &'a State,
    format: &'a FramebufferFormat,
    options: Options,
    /// Whether the next stage that interpolates has to compute 1 / D.
    first: bool,
    /// Whether texturing leaves packed pixels.
    packed: bool,
    program: Program,
}

/// The names of a plan's steps, in small letters.
struct Names<'a, F>(&'a [Step<F>]);

impl<F> Display for Names<'_, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            write!(f, "{}{}", if i > 0 { ", " } else { "" }, step.id.name().to_lowercase())?;
        }
        Ok(())
    }
}

impl Program {
    /// The program for a state. `textures` are the complete textures of the units that have texturing on, their padding
    /// filled ([`crate::texture::sampler::prepare`]).
    #[must_use]
    pub fn build(
        level: Level,
        state: &State,
        textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS],
        format: &FramebufferFormat,
        options: Options,
    ) -> Self {
        let program = Self {
            key: FragmentKey::default(),
            layout: Layout::default(),
            reads_framebuffer: false,
            coverage: options.coverage,
            decisions: Vec::new(),
            uniforms: FragUniforms::default(),
            reference: Vec::with_capacity(16),
            span: None,
            hiz: None,
            raises_depth: false,
            samplers: Vec::new(),
            environments: None,
            tally: None,
        };
        let mut b = Builder { level, state, format, options, first: true, packed: false, program };
        b.build(textures);
        b.program
    }
}

impl Builder<'_> {
    fn build(&mut self, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS]) {
        let key = self.summarise(textures.iter().any(Option::is_some));
        let tests = key.tests;
        self.program.key = key;
        self.program.raises_depth = tests.depth_write && tests.depth.is_some_and(|func| !uses_hiz(func));
        self.early_tests(&key);
        if key.needs_color() {
            self.colors(&key, textures);
            self.finish_layout();
            if !key.tests_first() {
                self.late_tests(&key);
            }
            self.store(&key);
        } else {
            self.decide("colour", Fate::LeftOut, "no colour channel is written and no test looks at alpha");
            if key.general {
                self.stencil_and_depth(&tests, tests.depth_write);
                self.count_and_stop(&key);
            }
        }
        self.program.uniforms.layout = self.program.layout.clone();
        if !key.general {
            self.reciprocals();
        }
        self.span_kernel(&key);
    }

    /// The tests that come before the colour, where nothing between them and there can tell the difference.
    fn early_tests(&mut self, key: &FragmentKey) {
        let (tests, first, depth_first) = (&key.tests, key.tests_first(), key.depth_first());
        match tests.depth {
            Some(func)
                if (first || depth_first)
                    && tests.stencil.is_none()
                    && func != CompareFunc::Always
                    && key.source != FragmentSource::PixelDepths =>
            {
                self.early_depth(func, first && tests.depth_write, tests.depth_write)
            }
            _ => {
                self.push(&depth::BEGIN, 0);
                if first || depth_first {
                    self.stencil_and_depth(tests, first && tests.depth_write);
                }
            }
        }
        if first {
            self.count_and_stop(key);
        } else if depth_first {
            self.program.reference.push(Action::StopIfDead);
        }
        if tests.stencil.is_some() || tests.depth.is_some() {
            let (fate, reason) = match (first, depth_first) {
                (true, _) => (Fate::Hoisted, "no alpha test: fragments that fail are neither coloured nor textured"),
                (_, true) => (Fate::Hoisted, "the depth test comes first, depths are written after the alpha test"),
                _ => (Fate::Kept, "after the alpha test, which decides who comes to them"),
            };
            self.decide("order of the tests", fate, reason);
        }
    }

    /// The tests that come after the colour.
    fn late_tests(&mut self, key: &FragmentKey) {
        let tests = &key.tests;
        self.alpha_test(tests);
        if !key.depth_first() {
            self.stencil_and_depth(tests, tests.depth_write);
        } else if tests.depth_write {
            self.push(&depth::DEPTH_WRITE, 0);
        }
        self.count_and_stop(key);
    }

    /// The kernel of the span path.
    fn span_kernel(&mut self, key: &FragmentKey) {
        let uniforms = &self.program.uniforms;
        let mipmapped = uniforms.levels.iter().any(Option::is_some);
        match SpanKernel::select(self.level, key, uniforms.span.as_ref(), mipmapped) {
            Ok(kernel) => {
                let name = kernel.long.id.name().to_lowercase();
                self.decide("span kernel", Fate::Kept, format_args!("{name}: {}", kernel.reason));
                self.program.span = Some(kernel);
            }
            Err(reason) => self.decide("span kernel", Fate::LeftOut, reason),
        }
    }

    /// Sets the flags of the stages of texture coordinates that say which later stages read the 1 / D that they
    /// compute.
    fn reciprocals(&mut self) {
        let units = self.program.layout.units;
        let divides = |arg: u32| units.get(texcoord::unit_of(arg)).is_some_and(|u| u.is_some_and(|u| !u.has_q));
        let (mut read, mut later) = (false, None::<&mut u32>);
        for action in self.program.reference.iter_mut().rev() {
            let Action::Stage(step) = action else { continue };
            if !step.id.cost().divides {
                continue;
            }
            if step.is(&texcoord::COORDINATES) && divides(step.arg) {
                if !read {
                    step.arg |= texcoord::ALONE;
                }
                if let Some(later) = later {
                    *later |= texcoord::AGAIN;
                    step.arg |= texcoord::SHARED;
                }
                later = Some(&mut step.arg);
            }
            read = true;
        }
    }

    /// Appends a stage.
    fn push(&mut self, stage: &Stage<FragFn>, arg: u32) {
        self.program.reference.push(Action::Stage(stage.step(self.level, arg)));
    }

    /// Notes a decision.
    fn decide(&mut self, stage: impl Display, fate: Fate, reason: impl Display) {
        if !self.options.silent {
            self.program.decisions.push(Decision { stage: stage.to_string(), fate, reason: reason.to_string() });
        }
    }

    /// [`FIRST`] for the first stage that needs 1 / D, 0 for the others.
    fn first(&mut self) -> u32 {
        if std::mem::take(&mut self.first) { FIRST } else { 0 }
    }

    /// Stencil and depth stages.
    fn stencil_and_depth(&mut self, tests: &Tests, depth_write: bool) {
        if let Some([front, back]) = tests.stencil {
            match tests.two_sided {
                false => self.push(&stencil::STENCIL_TEST, front as u32),
                true => self.push(&stencil::STENCIL_TEST_TWO_SIDED, (front as u32) | (back as u32) << 3),
            }
            self.program.reads_framebuffer = true;
        }
        if let Some(func) = tests.depth {
            let from_image = self.program.key.source == FragmentSource::PixelDepths;
            self.push(if from_image { &pixel_rect::PIXEL_DEPTH } else { &depth::DEPTH }, 0);
            if func == CompareFunc::Always && !self.options.general {
                if depth_write {
                    self.push(&depth::DEPTH_WRITE, 0);
                }
            } else {
                self.push(&depth::DEPTH_TEST, (func as u32) << 1 | if depth_write { depth::WRITE } else { 0 });
                self.program.reads_framebuffer = true;
            }
        }
        if tests.stencil.is_some() && tests.stencil_write {
            let stage = if tests.two_sided { &stencil::STENCIL_WRITE_TWO_SIDED } else { &stencil::STENCIL_WRITE };
            self.push(stage, 0);
        }
    }

    /// The primary colour, as the fragment's colour or for texture environments.
    fn primary_color(&mut self, key: &FragmentKey) {
        if let FragmentSource::PixelColors { .. } = key.source {
            self.push(&pixel_rect::PIXEL_COLOR, if key.textured { pixel_rect::TEXTURED } else { 0 });
            return;
        }
        self.program.layout.color = Some(self.slots(4));
        let first = self.first();
        self.push(if key.textured { &interpolate::PRIMARY } else { &interpolate::COLOR }, first);
    }

    /// The depth test as the first stage.
    fn early_depth(&mut self, func: CompareFunc, write: bool, depth_write: bool) {
        let arg = (func as u32) << 1 | if write { depth::WRITE } else { 0 };
        self.push(&early_depth::EARLY_DEPTH, arg);
        self.program.reads_framebuffer = true;
        if uses_hiz(func) {
            let update = depth_write.then(|| HIZ_UPDATE.step(self.level, arg));
            self.program.hiz = Some(Hiz { cull: HIZ_CULL.step(self.level, arg), update });
            let reason = "what lies behind whole blocks fails before any depth is read";
            self.decide("hierarchical depth", Fate::Kept, reason);
        } else {
            self.decide("hierarchical depth", Fate::LeftOut, "the test may pass what lies behind");
        }
    }

    /// What follows when all tests are done.
    fn count_and_stop(&mut self, key: &FragmentKey) {
        if key.counts_samples {
            self.push(&depth::COUNT_SAMPLES, 0);
        }
        if key.tests.any() {
            self.program.reference.push(Action::StopIfDead);
        }
    }

    /// The alpha test.
    fn alpha_test(&mut self, tests: &Tests) {
        if let Some(func) = tests.alpha {
            let stage = match (self.format.float, self.packed) {
                (true, _) => &alpha::ALPHA_TEST_FLOAT,
                (_, true) => &env_pack::ALPHA_TEST_PACKED,
                _ => &alpha::ALPHA_TEST,
            };
            self.push(stage, func as u32);
            if !self.options.general {
                self.program.reference.push(Action::StopIfDead);
            }
        }
    }

    /// Takes `n` slots of a vertex.
    fn slots(&mut self, n: usize) -> usize {
        let slot = self.program.layout.count;
        self.program.layout.count += n;
        slot
    }
}
