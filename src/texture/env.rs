//! Texture environments (OpenGL 1.5, section 3.8.13, tables 3.21 to 3.25): how the texel of each unit changes the colour of
//! the fragment. REPLACE, MODULATE, DECAL, BLEND and ADD are rewritten, base format by base format, into the COMBINE form,
//! so there is one form to run; halves that only move, multiply or add get the cheap stages of it.

use super::batch::TexBatch;
use super::combine::{
    ALPHA, Argument, COMBINE_ADD, COMBINE_ADD_SIGNED, COMBINE_DOT3, COMBINE_INTERPOLATE, COMBINE_MODULATE,
    COMBINE_REPLACE, COMBINE_SUBTRACT, Combine, ENV_ADD, ENV_ARGUMENT, ENV_MODULATE, ENV_REPLACE, EnvFn, EnvUniforms,
    Function, Half, Operand, RGB, Source, argument, direct, function,
};
use super::format::BaseFormat;
use crate::batch::{Level, Plan, Stage};
use crate::enums::*;
use crate::num::clamp01;
use crate::state::texture::Env;

/// The environments of all units as a plan.
#[derive(Clone, Debug)]
pub struct EnvPlan {
    /// The stages in order. They read `texel` and `primary` and write `previous`.
    pub plan: Plan<EnvFn>,
    /// What they read.
    pub uniforms: EnvUniforms,
}

const fn arg(source: Source, operand: Operand) -> Argument {
    Argument { source, operand }
}

const PREVIOUS: Argument = arg(Source::Previous, Operand::Color);

const fn half(function: Function, args: [Argument; 3]) -> Half {
    Half { function, args, scale: 1.0 }
}

/// The half that leaves the colour as it comes.
const KEEP: Half = half(Function::Replace, [PREVIOUS; 3]);

/// An environment with a texture of this base format, in COMBINE form, for this unit. `enabled` says which units have a
/// texture: a COMBINE that reads the texture of another unit which has none leaves the colour as it comes.
#[must_use]
pub fn combine(env: &Env, base: BaseFormat, unit: usize, enabled: impl Fn(usize) -> bool) -> Combine {
    use BaseFormat::{Alpha, Intensity, LuminanceAlpha, Rgb, Rgba};
    let texture = arg(Source::Texture(unit), Operand::Color);
    let constant = arg(Source::Constant(unit), Operand::Color);
    let replace = half(Function::Replace, [texture; 3]);
    let modulate = half(Function::Modulate, [texture, PREVIOUS, PREVIOUS]);
    let add = half(Function::Add, [texture, PREVIOUS, PREVIOUS]);
    let blend = half(Function::Interpolate, [constant, PREVIOUS, texture]);
    let decal = half(Function::Interpolate, [texture, PREVIOUS, arg(Source::Texture(unit), Operand::Alpha)]);
    let has_color = base != Alpha;
    let has_alpha = matches!(base, Alpha | LuminanceAlpha | Intensity | Rgba);
    let color = |f: Half| if has_color { f } else { KEEP };
    let alpha = |f: Half| if has_alpha { f } else { KEEP };
    let (rgb, alpha) = match env.mode {
        GL_REPLACE => (color(replace), alpha(replace)),
        GL_DECAL => match base {
            Rgb => (replace, KEEP),
            Rgba => (decal, KEEP),
            // The specification leaves the others undefined.
            _ => (KEEP, KEEP),
        },
        GL_BLEND => (color(blend), if base == Intensity { blend } else { alpha(modulate) }),
        GL_ADD => (color(add), if base == Intensity { add } else { alpha(modulate) }),
        GL_COMBINE => return general(env, unit, enabled),
        _ => (color(modulate), alpha(modulate)),
    };
    Combine { rgb, alpha }
}

/// COMBINE itself: its names turned into [`Combine`].
fn general(env: &Env, unit: usize, enabled: impl Fn(usize) -> bool) -> Combine {
    let source = |name: GLenum| match name {
        GL_TEXTURE => Source::Texture(unit),
        GL_CONSTANT => Source::Constant(unit),
        GL_PRIMARY_COLOR => Source::Primary,
        GL_TEXTURE0..=GL_TEXTURE31 => Source::Texture((name - GL_TEXTURE0) as usize),
        _ => Source::Previous,
    };
    let operand = |name: GLenum| match name {
        GL_ONE_MINUS_SRC_COLOR => Operand::OneMinusColor,
        GL_SRC_ALPHA => Operand::Alpha,
        GL_ONE_MINUS_SRC_ALPHA => Operand::OneMinusAlpha,
        _ => Operand::Color,
    };
    let function = |name: GLenum| match name {
        GL_MODULATE => Function::Modulate,
        GL_ADD => Function::Add,
        GL_ADD_SIGNED => Function::AddSigned,
        GL_INTERPOLATE => Function::Interpolate,
        GL_SUBTRACT => Function::Subtract,
        GL_DOT3_RGB | GL_DOT3_RGB_EXT => Function::Dot3Rgb,
        GL_DOT3_RGBA | GL_DOT3_RGBA_EXT => Function::Dot3Rgba,
        _ => Function::Replace,
    };
    let half = |k: usize| Half {
        function: function(env.combine[k]),
        args: std::array::from_fn(|i| arg(source(env.source[i][k]), operand(env.operand[i][k]))),
        scale: env.scale[k],
    };
    let (mut rgb, mut alpha) = (half(0), half(1));
    // The dot products of the EXT extension are not scaled.
    if matches!(env.combine[0], GL_DOT3_RGB_EXT | GL_DOT3_RGBA_EXT) {
        rgb.scale = 1.0;
    }
    if env.combine[0] == GL_DOT3_RGBA_EXT {
        alpha.scale = 1.0;
    }
    for argument in &mut alpha.args {
        // Alpha has no colour to read.
        argument.operand = match argument.operand {
            Operand::Color | Operand::Alpha => Operand::Color,
            Operand::OneMinusColor | Operand::OneMinusAlpha => Operand::OneMinusColor,
        };
    }
    let alpha_used = if rgb.function == Function::Dot3Rgba { 0 } else { alpha.function.arity() };
    let mut read = rgb.args[..rgb.function.arity()].iter().chain(&alpha.args[..alpha_used]);
    if read.any(|a| matches!(a.source, Source::Texture(t) if t != unit && !enabled(t))) {
        return Combine { rgb: KEEP, alpha: KEEP };
    }
    Combine { rgb, alpha }
}

impl Half {
    /// The cheap stage that does what this half does, and the source that it reads, if there is one.
    fn direct(&self) -> Option<(&'static Stage<EnvFn>, Source)> {
        if self.scale != 1.0 || self.args[..self.function.arity()].iter().any(|a| a.operand != Operand::Color) {
            return None;
        }
        let [first, second, _] = self.args.map(|a| a.source);
        let other = if second == Source::Previous { first } else { second };
        let one_is_previous = first == Source::Previous || second == Source::Previous;
        match self.function {
            Function::Replace => Some((&ENV_REPLACE, first)),
            Function::Modulate if one_is_previous && other != Source::Previous => Some((&ENV_MODULATE, other)),
            Function::Add if one_is_previous && other != Source::Previous => Some((&ENV_ADD, other)),
            _ => None,
        }
    }

    fn stage(&self) -> &'static Stage<EnvFn> {
        match self.function {
            Function::Replace => &COMBINE_REPLACE,
            Function::Modulate => &COMBINE_MODULATE,
            Function::Add => &COMBINE_ADD,
            Function::AddSigned => &COMBINE_ADD_SIGNED,
            Function::Interpolate => &COMBINE_INTERPOLATE,
            Function::Subtract => &COMBINE_SUBTRACT,
            Function::Dot3Rgb | Function::Dot3Rgba => &COMBINE_DOT3,
        }
    }
}

impl EnvPlan {
    /// The plan of all units: for each its environment and the base format of its texture (as
    /// [`Sampler::base`](super::sampler::Sampler::base) says), `None` where it has no enabled, complete texture. After
    /// it has run, `previous` holds the colour after the last unit, also when there is none.
    #[must_use]
    pub fn build(level: Level, units: &[Option<(&Env, BaseFormat)>]) -> Self {
        let mut this = Self { plan: Plan::new(level), uniforms: EnvUniforms::default() };
        let mut first = true;
        for (unit, entry) in units.iter().enumerate() {
            let Some((env, base)) = entry else { continue };
            if let Some(color) = this.uniforms.colors.get_mut(unit) {
                *color = env.color.map(clamp01);
            }
            let form = combine(env, *base, unit, |t| units.get(t).is_some_and(Option::is_some));
            this.push(&form, first);
            first = false;
        }
        if first {
            this.plan.push(&ENV_REPLACE, direct(RGB | ALPHA, Source::Primary, false));
        }
        this
    }

    /// Appends the stages of one unit. Of the first unit the colour so far is the primary colour.
    fn push(&mut self, form: &Combine, first: bool) {
        let of_first = |source| if first && source == Source::Previous { Source::Primary } else { source };
        let dot4 = form.rgb.function == Function::Dot3Rgba;
        let (rgb, alpha) = (form.rgb.direct(), if dot4 { None } else { form.alpha.direct() });
        // Both halves the same: one step does both.
        if let (Some((a, from_a)), Some((b, from_b))) = (rgb, alpha)
            && std::ptr::eq(a, b)
            && from_a == from_b
        {
            return self.push_direct(a, RGB | ALPHA, from_a, first);
        }
        // A half that loads arguments reads the other half's channels only before they are written.
        if rgb.is_none() {
            self.push_arguments(&form.rgb, RGB, of_first);
        }
        if alpha.is_none() && !dot4 {
            self.push_arguments(&form.alpha, ALPHA, of_first);
        }
        match rgb {
            Some((stage, source)) => self.push_direct(stage, RGB, source, first),
            None => {
                let channels = if dot4 { RGB | ALPHA } else { RGB };
                self.plan.push(form.rgb.stage(), function(channels, form.rgb.scale, form.alpha.scale));
            }
        }
        match alpha {
            Some((stage, source)) => self.push_direct(stage, ALPHA, source, first),
            None if dot4 => {}
            // The dot products are no functions of alpha.
            None => self.plan.push(form.alpha.stage(), function(ALPHA, form.rgb.scale, form.alpha.scale)),
        }
    }

    fn push_direct(&mut self, stage: &'static Stage<EnvFn>, channels: u32, source: Source, first: bool) {
        match source {
            // Nothing to do: the colour stays.
            Source::Previous if !first => {}
            Source::Previous => self.plan.push(stage, direct(channels, Source::Primary, true)),
            _ => self.plan.push(stage, direct(channels, source, first)),
        }
    }

    fn push_arguments(&mut self, half: &Half, channels: u32, of_first: impl Fn(Source) -> Source) {
        for (slot, a) in half.args.iter().take(half.function.arity()).enumerate() {
            let a = Argument { source: of_first(a.source), ..*a };
            self.plan.push(&ENV_ARGUMENT, argument(channels, slot, a));
        }
    }

    /// Runs the environments of all units over a batch.
    pub fn run(&self, batch: &mut TexBatch) {
        for step in &self.plan.steps {
            #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
            unsafe {
                (step.run)(batch, &self.uniforms, step.arg);
            }
        }
    }
}
