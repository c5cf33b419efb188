//! From the state to a fragment program. Each stage is kept or left out by an exact condition on the state, never by an
//! "almost" on floats: a program built with [`Options::general`] keeps everything and gives the same bytes. The order is
//! that of the specification (texturing, colour sum, fog, coverage, alpha, stencil, depth, blending, logic op, masks),
//! except that stencil and depth tests move to the front where nothing between them and there can tell the difference.

mod colors;
mod store;
mod texturing;

use store::Blending;

use crate::fragment::compare::Func;
use crate::fragment::planes::Layout;
use crate::fragment::program::{Action, Decision, Fate, Options, Program};
use crate::fragment::reference::interpolate::FIRST;
use crate::fragment::reference::{alpha, depth, env_pack, stencil, texcoord};
use crate::fragment::span::{self, long, short};
use crate::fragment::uniforms::{FragFn, FragUniforms, StencilUniforms};
use crate::framebuffer::FramebufferFormat;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::simd::{Level, Stage, Step};
use crate::state::State;
use crate::state::color_buffer::{ColorBufferName, LogicOp};
use crate::state::depth_stencil::StencilOp;
use crate::texture::object::TextureObject;
use crate::texture::rho_ranges::RhoRanges;
use crate::texture::uniforms::LinearImage;
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

/// What the tests do, decided before any stage is placed.
struct Tests {
    alpha: Option<Func>,
    stencil: Option<Func>,
    stencil_write: bool,
    depth: Option<Func>,
    depth_write: bool,
}

impl Program {
    /// The program for a state. `textures` are the complete textures of the units that have texturing on, their rings
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
            layout: Layout::default(),
            reads_framebuffer: false,
            draws_nothing: false,
            coverage: options.coverage,
            decisions: Vec::new(),
            uniforms: FragUniforms::default(),
            actions: Vec::with_capacity(16),
            fill: None,
            fill_levels: None,
            rows: [None, None],
            untextured: false,
            levelled: false,
            hiz_cull: None,
            hiz_update: None,
            raises_depth: false,
            samplers: Vec::new(),
            environments: None,
            tally: None,
        };
        let level = level.at_most_available();
        let mut b = Builder { level, state, format, options, first: true, packed: false, program };
        b.build(textures);
        b.program
    }
}

impl Builder<'_> {
    fn build(&mut self, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS]) {
        let general = self.options.general;
        let writes_color = self.masks();
        let tests = self.tests();
        let count = self.options.count_samples;
        self.program.draws_nothing = !writes_color && !tests.depth_write && !tests.stencil_write && !count;
        let needs_color = writes_color || tests.alpha.is_some();
        self.program.raises_depth = tests.depth_write && tests.depth.is_some_and(|func| !span::depth::coarse(func));
        // With an alpha test and no stencil the depth test may still come first, if depths are written later.
        let early = tests.alpha.is_none() && !general;
        let early_depth = !early && !general && tests.stencil.is_none() && tests.depth.is_some();
        let alone = (early || early_depth) && tests.stencil.is_none();
        match tests.depth {
            Some(func) if alone && func != Func::Always => {
                self.early_depth(func, early && tests.depth_write, tests.depth_write)
            }
            _ => {
                self.push(&depth::BEGIN, 0);
                if early || early_depth {
                    self.stencil_and_depth(&tests, early && tests.depth_write);
                }
            }
        }
        if early {
            self.count_and_stop(&tests, count);
        } else if early_depth {
            self.program.actions.push(Action::StopIfDead);
        }
        if tests.stencil.is_some() || tests.depth.is_some() {
            let (fate, reason) = match (early, early_depth) {
                (true, _) => (Fate::Hoisted, "no alpha test: fragments that fail are neither coloured nor textured"),
                (_, true) => (Fate::Hoisted, "the depth test comes first, depths are written after the alpha test"),
                _ => (Fate::Kept, "after the alpha test, which decides who comes to them"),
            };
            self.decide("order of the tests", fate, reason);
        }
        if needs_color {
            let packed = !self.format.float;
            let blend = self.blending();
            let logic_op = self.logic_op();
            let packable = packed && blend.is_none() && logic_op.is_none();
            let kills = tests.alpha.is_some() || tests.stencil.is_some() || tests.depth.is_some();
            let direct = packable && writes_color && !kills && self.program.uniforms.color_mask == u32::MAX;
            let blended = match blend {
                Some(Blending::Packed(pair)) if logic_op.is_none() => Some(pair),
                _ => None,
            };
            let plain = self.colors(textures, tests.alpha, (packable, blended), direct);
            self.finish_layout();
            if !early {
                self.alpha_test(&tests);
                if early_depth {
                    if tests.depth_write {
                        self.push(&depth::DEPTH_WRITE, 0);
                    }
                } else {
                    self.stencil_and_depth(&tests, tests.depth_write);
                }
                self.count_and_stop(&tests, count);
            }
            let whole = writes_color && self.program.uniforms.color_mask == u32::MAX;
            if early && whole && !count {
                if plain {
                    self.fill(&tests, long::COLOR);
                } else {
                    self.fill_textured(&tests);
                }
            }
            if direct && plain {
                self.decide("store", Fate::Hoisted, "with the colour, since no test can kill a fragment");
            } else if writes_color {
                self.store(plain || self.packed, blend, logic_op);
            }
        } else {
            self.decide("colour", Fate::LeftOut, "no colour channel is written and no test looks at alpha");
            if early && !count {
                self.fill(&tests, 0);
            }
            if general {
                self.stencil_and_depth(&tests, tests.depth_write);
                self.count_and_stop(&tests, count);
            }
        }
        self.program.uniforms.layout = self.program.layout.clone();
        if !general {
            self.reciprocals();
        }
    }

    /// Tells the stages of texture coordinates for whom to keep 1 / D.
    fn reciprocals(&mut self) {
        let units = self.program.layout.units;
        let divides = |arg: u32| units.get(texcoord::unit_of(arg)).is_some_and(|u| u.is_some_and(|u| !u.has_q));
        let (mut read, mut later) = (false, None::<&mut u32>);
        for action in self.program.actions.iter_mut().rev() {
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
        self.program.actions.push(Action::Stage(stage.step(self.level, arg)));
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

    /// Masks and units of the stores; gives whether any colour is written.
    fn masks(&mut self) -> bool {
        let c = &self.state.color_buffer;
        let mask = crate::framebuffer::packed_mask(c.color_mask);
        let noop = c.logic_op_enabled && c.logic_op == LogicOp::Noop && !self.format.float;
        let u = &mut self.program.uniforms;
        u.color_mask = if c.draw_buffer == ColorBufferName::None || noop { 0 } else { mask };
        u.packed_or = crate::framebuffer::no_alpha_bits(self.format);
        u.depth_max = f64::from(self.format.depth_max());
        (u.scale, u.limit) = if self.format.float { (1.0, f32::MAX) } else { (255.0, 255.0) };
        u.alpha_ref = clamp01(c.alpha_ref);
        u.color_mask != 0
    }

    /// Which tests there are.
    fn tests(&mut self) -> Tests {
        let general = self.options.general;
        let (c, d, s) = (&self.state.color_buffer, &self.state.depth, &self.state.stencil);
        let alpha = if c.alpha_test { c.alpha_func } else { Func::Always };
        let depth_on = d.test && self.format.depth_bits != 0;
        let depth = if depth_on { d.func } else { Func::Always };
        let depth_write = depth_on && d.mask && depth != Func::Never;
        let stencil_on = s.test && self.format.stencil_bits != 0;
        let func = if stencil_on { s.func } else { Func::Always };
        let op = |on: bool, value| if stencil_on && on { value } else { StencilOp::Keep };
        let stencil = StencilUniforms {
            reference: s.reference.clamp(0, 255).cast_unsigned(),
            value_mask: s.value_mask & 0xFF,
            write_mask: if stencil_on { s.write_mask & 0xFF } else { 0 },
            fail: op(func != Func::Always, s.fail),
            depth_fail: op(func != Func::Never && depth != Func::Always, s.depth_fail),
            pass: op(func != Func::Never && depth != Func::Never, s.depth_pass),
        };
        let keeps = [stencil.fail, stencil.depth_fail, stencil.pass].iter().all(|op| *op == StencilOp::Keep);
        let stencil_write = stencil.write_mask != 0 && !keeps;
        self.program.uniforms.stencil = stencil;
        let keep_stencil = func != Func::Always || stencil_write || (general && self.format.stencil_bits != 0);
        let keep_depth = depth != Func::Always || depth_write || (general && self.format.depth_bits != 0);
        let off = |on: bool| match on {
            true => "the test is on, but passes every fragment and writes nothing",
            false => "the test is off, or the framebuffer has no such buffer",
        };
        if alpha != Func::Always || general {
            self.decide(
                "alpha test",
                Fate::Kept,
                format_args!("{} on the alpha rounded as the store does", alpha.name()),
            );
        } else {
            self.decide("alpha test", Fate::LeftOut, off(c.alpha_test));
        }
        if keep_stencil {
            let writes = if stencil_write { "writes" } else { "writes nothing" };
            self.decide("stencil test", Fate::Kept, format_args!("{}, {writes}", func.name()));
        } else {
            self.decide("stencil test", Fate::LeftOut, off(stencil_on));
        }
        if keep_depth {
            let writes = if depth_write { "writes" } else { "writes nothing" };
            self.decide("depth test", Fate::Kept, format_args!("{}, {writes}", depth.name()));
        } else {
            self.decide("depth test", Fate::LeftOut, format_args!("no depth is computed: {}", off(depth_on)));
        }
        Tests {
            alpha: (alpha != Func::Always || general).then_some(alpha),
            stencil: keep_stencil.then_some(func),
            stencil_write: stencil_write || (general && keep_stencil),
            depth: keep_depth.then_some(depth),
            depth_write,
        }
    }

    /// Stencil and depth stages.
    fn stencil_and_depth(&mut self, tests: &Tests, depth_write: bool) {
        if let Some(func) = tests.stencil {
            self.push(&stencil::STENCIL_TEST, func as u32);
            self.program.reads_framebuffer = true;
        }
        if let Some(func) = tests.depth {
            self.push(&depth::DEPTH, 0);
            if func == Func::Always && !self.options.general {
                if depth_write {
                    self.push(&depth::DEPTH_WRITE, 0);
                }
            } else {
                self.push(&depth::DEPTH_TEST, (func as u32) << 1 | if depth_write { depth::WRITE } else { 0 });
                self.program.reads_framebuffer = true;
            }
        }
        if tests.stencil.is_some() && tests.stencil_write {
            self.push(&stencil::STENCIL_WRITE, 0);
        }
    }

    /// The depth test as the first stage.
    fn early_depth(&mut self, func: Func, write: bool, depth_write: bool) {
        let arg = (func as u32) << 1 | if write { depth::WRITE } else { 0 };
        self.push(&span::depth::EARLY_DEPTH, arg);
        self.program.reads_framebuffer = true;
        if span::depth::coarse(func) {
            let step = |stage: &Stage<FragFn>| stage.step(self.level, arg);
            self.program.hiz_cull = Some(step(&span::depth::HIZ_CULL));
            self.program.hiz_update = depth_write.then(|| step(&span::depth::HIZ_UPDATE));
            let reason = "what lies behind whole blocks fails before any depth is read";
            self.decide("coarse depth test", Fate::Kept, reason);
        } else {
            self.decide("coarse depth test", Fate::LeftOut, "the test may pass what lies behind");
        }
    }

    /// The stage that does whole runs by itself.
    fn fill(&mut self, tests: &Tests, color: u32) {
        if tests.stencil.is_some() || (tests.depth.is_none() && color == 0) {
            return;
        }
        self.program.untextured = true;
        let reason = "only depth and an interpolated colour: one stage does whole runs of a row";
        self.fill_runs(&long::FILL, tests, color, reason);
        if tests.depth.is_some() && color != 0 {
            self.fill_rows([Some(&short::ROWS_COLOR), None]);
        }
    }

    /// The same with texels that are stored as they are, if they come from one image, or with what such an image shows.
    fn fill_textured(&mut self, tests: &Tests) {
        if tests.stencil.is_some() {
            return;
        }
        if self.program.uniforms.copied.is_some() {
            let reason = "only depth and texels as they are: one stage does whole runs of a row";
            self.fill_runs(&long::FILL_TEXELS, tests, 0, reason);
            self.fill_rows([Some(&short::ROWS_TEXELS), None]);
        } else if self.program.uniforms.last.is_some() {
            let reason = "only depth and two linear images, multiplied: one stage does whole runs of a row";
            self.fill_runs(&long::FILL_TWO_UNITS, tests, 0, reason);
            self.program.levelled = self.program.uniforms.levels.iter().any(Option::is_some);
        } else if let Some(shown) = &self.program.uniforms.shown {
            let levels = self.program.uniforms.levels.get(shown.unit as usize).and_then(Option::as_ref);
            let between = match (&shown.image, shown.blend) {
                _ if !levels.is_some_and(|levels| levels.blends) => None,
                (LinearImage::Rgb(_), None) => Some(&long::FILL_RGB_LEVELS),
                (LinearImage::Rgba(_), None) => Some(&long::FILL_RGBA_LEVELS),
                _ => None,
            };
            let (stage, rows) = match (&shown.image, shown.blend) {
                (LinearImage::Rgb(_), None) => (&long::FILL_RGB, Some(&short::ROWS_RGB)),
                (LinearImage::Rgb(_), _) => (&long::FILL_RGB_BLENDED, Some(&short::ROWS_RGB_BLENDED)),
                (LinearImage::Rgba(_), None) => (&long::FILL_RGBA, Some(&short::ROWS_RGBA)),
                (LinearImage::Rgba(_), _) => (&long::FILL_RGBA_BLENDED, Some(&short::ROWS_RGBA_BLENDED)),
                (LinearImage::Rgb3d(_), None) => (&long::FILL_RGB_3D, None),
                _ => return,
            };
            let rows_between = match (&shown.image, between) {
                (_, None) => None,
                (LinearImage::Rgb(_), _) => Some(&short::ROWS_RGB_LEVELS),
                _ => Some(&short::ROWS_RGBA_LEVELS),
            };
            self.fill_runs(stage, tests, 0, "only depth and one linear image: one stage does whole runs of a row");
            let arg = self.program.fill.map_or(0, |step| step.arg);
            self.program.fill_levels = between.map(|stage| stage.step(self.level, arg));
            self.fill_rows([rows, rows_between]);
            self.program.levelled |= between.is_some();
        }
    }

    /// The stages for rows that are too short for that, which are told the same.
    fn fill_rows(&mut self, stages: [Option<&Stage<FragFn>>; 2]) {
        let arg = self.program.fill.map_or(0, |step| step.arg);
        self.program.rows = stages.map(|stage| stage.map(|stage| stage.step(self.level, arg)));
    }

    fn fill_runs(&mut self, stage: &Stage<FragFn>, tests: &Tests, flags: u32, reason: &str) {
        let writes = if tests.depth_write { depth::WRITE } else { 0 };
        let depth = tests.depth.map_or(0, |func| long::DEPTH | (func as u32) << 1 | writes);
        self.program.fill = Some(stage.step(self.level, depth | flags));
        // Where levels are blended, they are so up to the end of a run, as a rule.
        let nearest = |levels: &Option<RhoRanges>| levels.as_ref().is_some_and(|levels| !levels.blends);
        self.program.levelled = !self.program.untextured && self.program.uniforms.levels.iter().any(nearest);
        self.decide("long runs", Fate::Hoisted, reason);
    }

    /// What follows when all tests are done.
    fn count_and_stop(&mut self, tests: &Tests, count: bool) {
        if count {
            self.push(&depth::COUNT_SAMPLES, 0);
        }
        if tests.stencil.is_some() || tests.depth.is_some() || tests.alpha.is_some() {
            self.program.actions.push(Action::StopIfDead);
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
                self.program.actions.push(Action::StopIfDead);
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
