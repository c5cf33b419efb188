//! From the state to a fragment program. Each stage is kept or left out by an exact condition on the state, never by an
//! "almost" on floats: a program built with [`Options::general`] keeps everything and gives the same bytes. The order is
//! that of the specification (texturing, colour sum, fog, coverage, alpha, stencil, depth, blending, logic op, masks),
//! except that stencil and depth tests move to the front where nothing between them and there can tell the difference.

use super::blend::{BLEND, BLEND_PACKED, Equation, Factor, packed_pair};
use super::compare::Func;
use super::interpolate::FIRST;
use super::planes::{Layout, UnitSlots};
use super::program::{Action, Decision, Fate, Options, Program};
use super::stencil::StencilOp;
use super::uniforms::{BlendUniforms, FragFn, FragUniforms, StencilUniforms};
use super::{alpha, coordinates, depth, float_store, fog, interpolate, logic_op, pack, stencil};
use crate::batch::{Level, Stage, Step};
use crate::enums::{GL_CLEAR, GL_COPY, GL_EXP2, GL_LINEAR, GL_NONE, GL_NOOP, GL_SEPARATE_SPECULAR_COLOR, GL_SET, name};
use crate::framebuffer::FramebufferFormat;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::state::State;
use crate::texture::combine::Source;
use crate::texture::env::{EnvPlan, combine};
use crate::texture::format::BaseFormat;
use crate::texture::object::TextureObject;
use crate::texture::sampler::Sampler;

/// A program in the making.
struct Builder<'a> {
    level: Level,
    state: &'a State,
    format: &'a FramebufferFormat,
    options: Options,
    /// Whether the next stage that interpolates has to compute 1 / D.
    first: bool,
    program: Program,
}

/// How a program blends.
#[derive(Clone, Copy)]
enum Blending {
    /// By a pair of factors that has a loop of its own.
    Packed(u32),
    /// By any factors and equation.
    Any,
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
            actions: Vec::new(),
            samplers: Vec::new(),
            environments: None,
        };
        let level = level.at_most_available();
        let mut b = Builder { level, state, format, options, first: true, program };
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
        self.push(&depth::BEGIN, 0);
        // With an alpha test and no stencil the depth test may still come first, if depths are written later.
        let early = tests.alpha.is_none() && !general;
        let early_depth = !early && !general && tests.stencil.is_none() && tests.depth.is_some();
        if early {
            self.stencil_and_depth(&tests, tests.depth_write);
            self.count_and_stop(&tests, count);
        } else if early_depth {
            self.stencil_and_depth(&tests, false);
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
            let plain = self.colors(textures, tests.alpha, packable, direct);
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
            if direct && plain {
                self.decide("store", Fate::Hoisted, "with the colour, since no test can kill a fragment");
            } else if writes_color {
                self.store(plain, blend, logic_op);
            }
        } else {
            self.decide("colour", Fate::LeftOut, "no colour channel is written and no test looks at alpha");
            if general {
                self.stencil_and_depth(&tests, tests.depth_write);
                self.count_and_stop(&tests, count);
            }
        }
        self.program.uniforms.layout = self.program.layout.clone();
    }

    /// Appends a stage.
    fn push(&mut self, stage: &Stage<FragFn>, arg: u32) {
        let run = stage.levels[self.level as usize];
        self.program.actions.push(Action::Stage(Step { name: stage.name, run, arg }));
    }

    /// Notes a decision.
    fn decide(&mut self, stage: impl Into<String>, fate: Fate, reason: impl Into<String>) {
        self.program.decisions.push(Decision { stage: stage.into(), fate, reason: reason.into() });
    }

    /// [`FIRST`] for the first stage that needs 1 / D, 0 for the others.
    fn first(&mut self) -> u32 {
        if std::mem::take(&mut self.first) { FIRST } else { 0 }
    }

    /// Masks and units of the stores; gives whether any colour is written.
    fn masks(&mut self) -> bool {
        let c = &self.state.color_buffer;
        let mask = crate::framebuffer::packed_mask(c.color_mask);
        let noop = c.logic_op_enabled && c.logic_op == GL_NOOP && !self.format.float;
        let u = &mut self.program.uniforms;
        u.color_mask = if c.draw_buffer == GL_NONE || noop { 0 } else { mask };
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
        let alpha = if c.alpha_test { Func::from_enum(c.alpha_func) } else { Func::Always };
        let depth_on = d.test && self.format.depth_bits != 0;
        let depth = if depth_on { Func::from_enum(d.func) } else { Func::Always };
        let depth_write = depth_on && d.mask && depth != Func::Never;
        let stencil_on = s.test && self.format.stencil_bits != 0;
        let func = if stencil_on { Func::from_enum(s.func) } else { Func::Always };
        let op = |on: bool, value| if stencil_on && on { StencilOp::from_enum(value) } else { StencilOp::Keep };
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
        let off = |on: bool, what: &str| match on {
            true => format!("{what} is on, but passes every fragment and writes nothing"),
            false => format!("{what} is off, or the framebuffer has no such buffer"),
        };
        if alpha != Func::Always || general {
            self.decide("alpha test", Fate::Kept, format!("{} on the alpha rounded as the store does", alpha.name()));
        } else {
            self.decide("alpha test", Fate::LeftOut, off(c.alpha_test, "the alpha test"));
        }
        if keep_stencil {
            let writes = if stencil_write { "writes" } else { "writes nothing" };
            self.decide("stencil test", Fate::Kept, format!("{}, {writes}", func.name()));
        } else {
            self.decide("stencil test", Fate::LeftOut, off(stencil_on, "the stencil test"));
        }
        if keep_depth {
            let writes = if depth_write { "writes" } else { "writes nothing" };
            self.decide("depth test", Fate::Kept, format!("{}, {writes}", depth.name()));
        } else {
            self.decide("depth test", Fate::LeftOut, format!("no depth is computed: {}", off(depth_on, "the test")));
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
            let stage = if self.format.float { &alpha::ALPHA_TEST_FLOAT } else { &alpha::ALPHA_TEST };
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

    /// Everything that makes the fragment's colour. Gives whether that is the interpolated colour and nothing else, and
    /// `packable` with it, so that it is packed as it is interpolated; then it has been, and with `direct` also stored.
    fn colors(
        &mut self,
        textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS],
        alpha_test: Option<Func>,
        packable: bool,
        direct: bool,
    ) -> bool {
        let general = self.options.general;
        let textured = textures.iter().any(Option::is_some);
        let sum = self.color_sum();
        let fog = self.fog();
        let coverage = self.options.coverage || general;
        let plain = packable && !textured && !sum && fog.is_none() && !coverage && alpha_test.is_none() && !general;
        if textured {
            self.texturing(textures);
        } else {
            self.decide("texturing", Fate::LeftOut, "no unit has an enabled and complete texture");
            self.program.layout.color = Some(self.slots(4));
            let first = self.first();
            if plain {
                self.push(if direct { &pack::COLOR_STORE } else { &pack::COLOR_PACKED }, first);
                self.decide(
                    "colour",
                    Fate::Hoisted,
                    "packed as it is interpolated, once a primitive where it is constant",
                );
            } else {
                self.push(&interpolate::COLOR, first);
                self.decide("colour", Fate::Kept, "interpolated");
            }
        }
        if sum {
            self.program.layout.secondary = Some(self.slots(3));
            let first = self.first();
            self.push(&interpolate::SECONDARY, first);
            self.push(&fog::COLOR_SUM, 0);
        }
        if let Some(stage) = fog {
            self.program.layout.fog = Some(self.slots(1));
            let first = self.first();
            self.push(&interpolate::FOG_COORDINATE, first);
            self.push(stage, 0);
        }
        if coverage {
            if !self.options.coverage {
                self.push(&fog::FULL_COVERAGE, 0);
            }
            self.push(&fog::COVERAGE, 0);
        }
        plain
    }

    /// Sampling and environments of all units.
    fn texturing(&mut self, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS]) {
        let state = self.state;
        let mut bases: [Option<BaseFormat>; MAX_TEXTURE_UNITS] = [None; MAX_TEXTURE_UNITS];
        let mut samplers: Vec<(usize, Sampler)> = Vec::new();
        for (unit, texture) in textures.iter().enumerate() {
            let (Some(texture), Some(unit_state)) = (texture, state.texture.units.get(unit)) else { continue };
            let sampler = Sampler::build_with(self.level, texture, unit_state.env.lod_bias, unit, self.options.general);
            bases[unit] = Some(sampler.base);
            samplers.push((unit, sampler));
        }
        if self.reads_primary(&bases) || self.options.general {
            self.program.layout.color = Some(self.slots(4));
            let first = self.first();
            self.push(&interpolate::PRIMARY, first);
            self.decide("colour", Fate::Kept, "a texture environment reads it");
        } else {
            self.decide("colour", Fate::LeftOut, "no texture environment reads the primary colour");
        }
        for (unit, sampler) in samplers {
            let has_q = self.has_q(unit, sampler.needs.cube);
            let count = sampler.needs.coordinates.clamp(1, 3);
            let base = self.slots(count + usize::from(has_q));
            let slots = UnitSlots {
                base,
                count,
                has_q,
                period: sampler.needs.period,
                size: sampler.needs.size,
                cube: sampler.needs.cube,
            };
            if let Some(place) = self.program.layout.units.get_mut(unit) {
                *place = Some(slots);
            }
            let derivatives = sampler.needs.derivatives || self.options.general;
            // A unit with q does not need 1 / D and leaves it to a later stage.
            let first = if has_q { 0 } else { self.first() };
            let flags = first | if derivatives { coordinates::DERIVATIVES } else { 0 };
            self.push(&coordinates::COORDINATES, flags | (unit as u32) << 2);
            let q = if has_q { "divided by q" } else { "q is 1" };
            let d = if derivatives { "with derivatives" } else { "no derivatives, the level cannot differ" };
            self.decide(format!("unit {unit} coordinates"), Fate::Kept, format!("{count} of s, t, r, {q}, {d}"));
            self.program.actions.push(Action::Sample(self.program.samplers.len()));
            let steps: Vec<_> = sampler.plan.steps.iter().map(|s| s.name.to_lowercase()).collect();
            self.decide(format!("unit {unit} sampler"), Fate::Kept, steps.join(", "));
            self.program.samplers.push(sampler);
        }
        let units: Vec<_> =
            bases.iter().enumerate().map(|(u, base)| Some((&state.texture.units.get(u)?.env, (*base)?))).collect();
        let environments = EnvPlan::build_with(self.level, &units, self.options.general);
        let steps: Vec<_> = environments.plan.steps.iter().map(|s| s.name.to_lowercase()).collect();
        self.decide("environments", Fate::Kept, steps.join(", "));
        self.program.environments = Some(environments);
        self.program.actions.push(Action::Environments);
    }

    /// Whether any environment reads the primary colour: by name, or as what comes before the first unit.
    fn reads_primary(&self, bases: &[Option<BaseFormat>; MAX_TEXTURE_UNITS]) -> bool {
        let mut first = true;
        for (unit, base) in bases.iter().enumerate() {
            let (Some(base), Some(state)) = (base, self.state.texture.units.get(unit)) else { continue };
            let form = combine(&state.env, *base, unit, |t| bases.get(t).is_some_and(Option::is_some));
            let reads = [form.rgb, form.alpha].iter().any(|half| {
                half.args.iter().take(half.function.arity()).any(|a| match a.source {
                    Source::Primary => true,
                    Source::Previous => first,
                    _ => false,
                })
            });
            if reads {
                return true;
            }
            first = false;
        }
        false
    }

    /// Whether a unit's q may differ from 1.
    fn has_q(&self, unit: usize, cube: bool) -> bool {
        if cube {
            return false;
        }
        if self.options.general {
            return true;
        }
        let generated = self.state.texture.units.get(unit).is_some_and(|u| u.generation[3].enabled);
        let given = unit < 32 && self.options.q_units >> unit & 1 != 0;
        let from_matrix = self.state.transform.texture.get(unit).is_some_and(|stack| {
            let last_row = stack.top().row(3);
            last_row.to_array() != [0.0, 0.0, 0.0, 1.0]
        });
        generated || given || from_matrix
    }

    /// Whether the secondary colour is added.
    fn color_sum(&mut self) -> bool {
        let light = &self.state.lighting;
        let separate = light.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
        let (on, reason) = match (light.enabled, separate, self.state.fog.color_sum) {
            (true, true, _) => (true, "lighting gives a separate specular colour"),
            (true, false, _) => (false, "lighting gives no separate specular colour: the secondary colour is black"),
            (false, _, true) => (true, "GL_COLOR_SUM is on"),
            (false, _, false) => (false, "GL_COLOR_SUM is off"),
        };
        self.decide("colour sum", if on { Fate::Kept } else { Fate::LeftOut }, reason);
        on
    }

    /// The fog stage.
    fn fog(&mut self) -> Option<&'static Stage<FragFn>> {
        let f = &self.state.fog;
        let general = self.options.general;
        let u = &mut self.program.uniforms;
        if !f.enabled || (f.mode != GL_LINEAR && f.density == 0.0) {
            let reason = if f.enabled { "the density is 0, so the factor is 1" } else { "GL_FOG is off" };
            self.decide("fog", if general { Fate::Kept } else { Fate::LeftOut }, reason);
            // Density 0 gives the factor 1, which leaves every colour as it is.
            return general.then_some(&fog::FOG_EXP);
        }
        u.fog_color = [clamp01(f.color[0]), clamp01(f.color[1]), clamp01(f.color[2])];
        u.fog_scale = f.density;
        u.fog_end = f.end;
        self.decide("fog", Fate::Kept, format!("{} for every fragment", name(f.mode)));
        let u = &mut self.program.uniforms;
        Some(match f.mode {
            GL_LINEAR if f.end == f.start => &fog::FOG_STEP,
            GL_LINEAR => {
                u.fog_scale = (1.0 / (f64::from(f.end) - f64::from(f.start))) as f32;
                &fog::FOG_LINEAR
            }
            GL_EXP2 => &fog::FOG_EXP2,
            _ => &fog::FOG_EXP,
        })
    }

    /// Which blending there is.
    fn blending(&mut self) -> Option<Blending> {
        let general = self.options.general;
        let c = &self.state.color_buffer;
        let blend = BlendUniforms {
            src: c.blend_src.map(Factor::from_enum),
            dst: c.blend_dst.map(Factor::from_enum),
            equation: Equation::from_enum(c.blend_equation),
            color: c.blend_color.map(clamp01),
        };
        let off = BlendUniforms { src: [Factor::One; 2], dst: [Factor::Zero; 2], ..BlendUniforms::default() };
        let copies = blend.equation == Equation::Add && blend.src == off.src && blend.dst == off.dst;
        let reason = match (c.blend, c.logic_op_enabled && !self.format.float, copies) {
            (false, ..) => "GL_BLEND is off",
            (_, true, _) => "a logic op takes its place",
            (.., true) => "ONE, ZERO gives the fragment's colour: the framebuffer is not read",
            _ => {
                let names = [c.blend_src[0], c.blend_dst[0]].map(name);
                self.program.uniforms.blend = blend;
                self.program.reads_framebuffer = true;
                self.decide("blending", Fate::Kept, format!("factors {}, {}", names[0], names[1]));
                let pair = if general || self.format.float { None } else { packed_pair(&blend) };
                return Some(pair.map_or(Blending::Any, Blending::Packed));
            }
        };
        self.decide("blending", if general { Fate::Kept } else { Fate::LeftOut }, reason);
        self.program.uniforms.blend = off;
        general.then_some(Blending::Any)
    }

    /// The logic op's number.
    fn logic_op(&mut self) -> Option<u32> {
        let c = &self.state.color_buffer;
        let general = self.options.general && !self.format.float;
        let on = c.logic_op_enabled && (GL_CLEAR..=GL_SET).contains(&c.logic_op);
        let (fate, reason) = match (on, self.format.float, c.logic_op == GL_COPY) {
            (false, ..) => (Fate::LeftOut, "GL_COLOR_LOGIC_OP is off".to_string()),
            (_, true, _) => (Fate::LeftOut, "floats have no bits to combine".to_string()),
            (.., true) => (Fate::LeftOut, "GL_COPY stores the fragment's colour".to_string()),
            _ => (Fate::Kept, format!("operation {}", c.logic_op - GL_CLEAR)),
        };
        self.decide("logic op", if general { Fate::Kept } else { fate }, reason);
        match fate {
            Fate::Kept => {
                self.program.reads_framebuffer = true;
                Some(c.logic_op - GL_CLEAR)
            }
            _ => general.then_some(GL_COPY - GL_CLEAR),
        }
    }

    /// Back colours, strides.
    fn finish_layout(&mut self) {
        let l = &mut self.program.layout;
        l.stride = l.count;
        let two_sided = self.state.lighting.enabled && self.state.lighting.model.two_side;
        if two_sided && (l.color.is_some() || l.secondary.is_some()) {
            l.back = Some(l.count);
            l.stride += 4 + if l.secondary.is_some() { 3 } else { 0 };
        }
    }

    /// Blending, logic op, mask and store.
    fn store(&mut self, packed: bool, blend: Option<Blending>, logic_op: Option<u32>) {
        let masked = self.program.uniforms.color_mask != u32::MAX;
        if masked {
            self.program.reads_framebuffer = true;
            self.decide("colour mask", Fate::Kept, "some channels are protected: they are read and written back");
        } else {
            self.decide("colour mask", Fate::LeftOut, "all channels are written");
        }
        if self.format.float {
            if blend.is_some() {
                self.push(&float_store::LOAD_FLOAT, 0);
                self.push(&BLEND, 0);
            } else {
                self.push(&float_store::COPY_FLOAT, 0);
            }
            self.push(&float_store::STORE_FLOAT, 0);
            return;
        }
        if blend.is_some() || logic_op.is_some() || masked || self.options.general {
            self.push(&pack::LOAD, 0);
        }
        match blend {
            Some(Blending::Packed(pair)) => self.push(&BLEND_PACKED, pair),
            Some(Blending::Any) => {
                self.push(&pack::UNPACK, 0);
                self.push(&BLEND, 0);
                self.push(&pack::PACK_BLENDED, 0);
            }
            None if !packed => self.push(&pack::PACK, 0),
            None => {}
        }
        if let Some(op) = logic_op {
            self.push(&logic_op::LOGIC_OP, op);
        }
        if masked || self.options.general {
            self.push(&pack::COLOR_MASK, 0);
        }
        self.push(&pack::STORE, 0);
        self.decide("store", Fate::Kept, "rounded to the nearest; dithering is rounding");
    }
}
