//! Texture environments (OpenGL 1.5, section 3.8.13, tables 3.21 to 3.25): how the texel of each unit changes the colour of
//! the fragment. REPLACE, MODULATE, DECAL, BLEND and ADD are rewritten, base format by base format, into the COMBINE form,
//! so there is one form to run; halves that only move, multiply or add get the cheap stages of it.

pub mod combine;

use super::batch::TexBatch;
use super::format::BaseFormat;
use crate::num::clamp01;
use crate::simd::{Level, Plan, Stage};
use crate::state::texture::{CombineFunction, CombineOperand, CombineSource, Env, EnvMode};
use combine::{
    ALPHA, Argument, COMBINE_ADD, COMBINE_ADD_SIGNED, COMBINE_DOT3, COMBINE_INTERPOLATE, COMBINE_MODULATE,
    COMBINE_REPLACE, COMBINE_SUBTRACT, COMBINE4_ADD, COMBINE4_ADD_SIGNED, ColorSource, Combine, CombineHalf, ENV_ADD,
    ENV_ARGUMENT, ENV_INTERPOLATE, ENV_MODULATE, ENV_REPLACE, EnvFn, EnvUniforms, RGB, argument, direct, function,
    weighted,
};

/// The environments of all units as a plan.
#[derive(Clone, Debug)]
pub struct EnvPlan {
    /// The stages in order. They read `texel` and `primary` and write `previous`.
    pub plan: Plan<EnvFn>,
    /// What they read.
    pub uniforms: EnvUniforms,
}

const fn arg(source: ColorSource, operand: CombineOperand) -> Argument {
    Argument { source, operand }
}

const PREVIOUS: Argument = arg(ColorSource::Previous, CombineOperand::SrcColor);

const fn half(function: CombineFunction, [a, b, c]: [Argument; 3]) -> CombineHalf {
    CombineHalf { function, products: false, args: [a, b, c, c], scale: 1.0 }
}

/// The half that leaves the colour as it comes.
const KEEP: CombineHalf = half(CombineFunction::Replace, [PREVIOUS; 3]);

/// An environment with a texture of this base format, in COMBINE form, for this unit. `enabled` says which units have a
/// texture: a COMBINE that reads the texture of another unit which has none leaves the colour as it comes.
#[must_use]
pub fn combine(env: &Env, base: BaseFormat, unit: usize, enabled: impl Fn(usize) -> bool) -> Combine {
    use BaseFormat::{Alpha, Intensity, LuminanceAlpha, Rgb, Rgba};
    let texture = arg(ColorSource::Texture(unit), CombineOperand::SrcColor);
    let constant = arg(ColorSource::Constant(unit), CombineOperand::SrcColor);
    let replace = half(CombineFunction::Replace, [texture; 3]);
    let modulate = half(CombineFunction::Modulate, [texture, PREVIOUS, PREVIOUS]);
    let add = half(CombineFunction::Add, [texture, PREVIOUS, PREVIOUS]);
    let blend = half(CombineFunction::Interpolate, [constant, PREVIOUS, texture]);
    let decal = half(
        CombineFunction::Interpolate,
        [texture, PREVIOUS, arg(ColorSource::Texture(unit), CombineOperand::SrcAlpha)],
    );
    let has_color = base != Alpha;
    let has_alpha = matches!(base, Alpha | LuminanceAlpha | Intensity | Rgba);
    let color = |f: CombineHalf| if has_color { f } else { KEEP };
    let alpha = |f: CombineHalf| if has_alpha { f } else { KEEP };
    let (rgb, alpha) = match env.mode {
        EnvMode::Modulate => (color(modulate), alpha(modulate)),
        EnvMode::Replace => (color(replace), alpha(replace)),
        EnvMode::Decal => match base {
            Rgb => (replace, KEEP),
            Rgba => (decal, KEEP),
            // The specification leaves the others undefined.
            _ => (KEEP, KEEP),
        },
        EnvMode::Blend => (color(blend), if base == Intensity { blend } else { alpha(modulate) }),
        EnvMode::Add => (color(add), if base == Intensity { add } else { alpha(modulate) }),
        EnvMode::Combine | EnvMode::Combine4 => return general(env, unit, enabled),
    };
    Combine { rgb, alpha }
}

/// COMBINE and COMBINE4 themselves: their names turned into [`Combine`].
fn general(env: &Env, unit: usize, enabled: impl Fn(usize) -> bool) -> Combine {
    let source = |source: CombineSource| match source {
        CombineSource::Texture => ColorSource::Texture(unit),
        CombineSource::Unit(other) => ColorSource::Texture(other),
        CombineSource::Constant => ColorSource::Constant(unit),
        CombineSource::PrimaryColor => ColorSource::Primary,
        CombineSource::Previous => ColorSource::Previous,
        CombineSource::Zero => ColorSource::Zero,
    };
    let sums = env.mode == EnvMode::Combine4;
    let half = |k: usize| CombineHalf {
        function: env.combine[k],
        products: sums && matches!(env.combine[k], CombineFunction::Add | CombineFunction::AddSigned),
        args: std::array::from_fn(|i| arg(source(env.source[i][k]), env.operand[i][k])),
        scale: env.scale[k],
    };
    let (mut rgb, mut alpha) = (half(0), half(1));
    // The dot products of the EXT extension are not scaled.
    if matches!(rgb.function, CombineFunction::Dot3RgbExt | CombineFunction::Dot3RgbaExt) {
        rgb.scale = 1.0;
    }
    if rgb.function == CombineFunction::Dot3RgbaExt {
        alpha.scale = 1.0;
    }
    for argument in &mut alpha.args {
        // Alpha has no colour to read.
        argument.operand = match argument.operand {
            CombineOperand::SrcColor | CombineOperand::SrcAlpha => CombineOperand::SrcColor,
            CombineOperand::OneMinusSrcColor | CombineOperand::OneMinusSrcAlpha => CombineOperand::OneMinusSrcColor,
        };
    }
    let alpha_used = if rgb.function.gives_alpha() { 0 } else { alpha.arity() };
    let mut read = rgb.args[..rgb.arity()].iter().chain(&alpha.args[..alpha_used]);
    if read.any(|a| matches!(a.source, ColorSource::Texture(t) if t != unit && !enabled(t))) {
        return Combine { rgb: KEEP, alpha: KEEP };
    }
    Combine { rgb, alpha }
}

/// A stage that reads its sources in place.
#[derive(Clone, Copy)]
struct Direct {
    stage: &'static Stage<EnvFn>,
    source: ColorSource,
    /// INTERPOLATE: where the weight comes from, and whether it is an alpha.
    weight: Option<(ColorSource, bool)>,
}

impl PartialEq for Direct {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.stage, other.stage) && self.source == other.source && self.weight == other.weight
    }
}

impl CombineHalf {
    /// How many arguments it reads.
    #[must_use]
    pub fn arity(&self) -> usize {
        if self.products { 4 } else { self.function.arity() }
    }

    /// The cheap stage that does what this half does, if there is one.
    fn direct(&self) -> Option<Direct> {
        let plain = |a: &Argument| a.operand == CombineOperand::SrcColor;
        let args = &self.args[..self.arity()];
        if self.products || self.scale != 1.0 || !args.iter().take(2).all(plain) {
            return None;
        }
        let [first, second, third, _] = self.args.map(|a| a.source);
        let other = if second == ColorSource::Previous { first } else { second };
        let onto_previous =
            (first == ColorSource::Previous || second == ColorSource::Previous) && other != ColorSource::Previous;
        let direct = |stage, source| Some(Direct { stage, source, weight: None });
        match self.function {
            CombineFunction::Replace => direct(&ENV_REPLACE, first),
            CombineFunction::Modulate if onto_previous => direct(&ENV_MODULATE, other),
            CombineFunction::Add if onto_previous => direct(&ENV_ADD, other),
            CombineFunction::Interpolate
                if second == ColorSource::Previous
                    && first != ColorSource::Previous
                    && third != ColorSource::Previous =>
            {
                let of_alpha = match self.args[2].operand {
                    CombineOperand::SrcColor => false,
                    CombineOperand::SrcAlpha => true,
                    CombineOperand::OneMinusSrcColor | CombineOperand::OneMinusSrcAlpha => return None,
                };
                Some(Direct { stage: &ENV_INTERPOLATE, source: first, weight: Some((third, of_alpha)) })
            }
            CombineFunction::Modulate
            | CombineFunction::Add
            | CombineFunction::AddSigned
            | CombineFunction::Interpolate
            | CombineFunction::Subtract
            | CombineFunction::Dot3Rgb
            | CombineFunction::Dot3Rgba
            | CombineFunction::Dot3RgbExt
            | CombineFunction::Dot3RgbaExt => None,
        }
    }

    fn stage(&self) -> &'static Stage<EnvFn> {
        match self.function {
            CombineFunction::Replace => &COMBINE_REPLACE,
            CombineFunction::Modulate => &COMBINE_MODULATE,
            CombineFunction::Add if self.products => &COMBINE4_ADD,
            CombineFunction::Add => &COMBINE_ADD,
            CombineFunction::AddSigned if self.products => &COMBINE4_ADD_SIGNED,
            CombineFunction::AddSigned => &COMBINE_ADD_SIGNED,
            CombineFunction::Interpolate => &COMBINE_INTERPOLATE,
            CombineFunction::Subtract => &COMBINE_SUBTRACT,
            CombineFunction::Dot3Rgb
            | CombineFunction::Dot3Rgba
            | CombineFunction::Dot3RgbExt
            | CombineFunction::Dot3RgbaExt => &COMBINE_DOT3,
        }
    }
}

impl EnvPlan {
    /// The plan of the units before `end`: for each unit its environment and the base format of its texture (as
    /// [`Sampler::base`](super::sampler::Sampler::base) says), `None` where it has no enabled, complete texture. After
    /// it has run, `previous` holds the colour after the last unit, also when there is none. With `general` every half
    /// goes the general way, which gives the same bits.
    #[must_use]
    pub fn build_until(level: Level, units: &[Option<(&Env, BaseFormat)>], end: usize, general: bool) -> Self {
        let mut this = Self { plan: Plan::new(level), uniforms: EnvUniforms::default() };
        let mut first = true;
        for (unit, entry) in units.iter().enumerate().take(end) {
            let Some((env, base)) = entry else { continue };
            if let Some(color) = this.uniforms.colors.get_mut(unit) {
                *color = env.color.map(clamp01);
            }
            let form = combine(env, *base, unit, |t| units.get(t).is_some_and(Option::is_some));
            this.push(&form, first, general);
            first = false;
        }
        if first {
            this.plan.push(&ENV_REPLACE, direct(RGB | ALPHA, ColorSource::Primary, false));
        }
        this
    }

    /// Appends the stages of one unit. Of the first unit the colour so far is the primary colour.
    fn push(&mut self, form: &Combine, first: bool, general: bool) {
        let of_first = |source| if first && source == ColorSource::Previous { ColorSource::Primary } else { source };
        let dot4 = form.rgb.function.gives_alpha();
        let direct = |half: &CombineHalf| if general { None } else { half.direct() };
        let (rgb, alpha) = (direct(&form.rgb), if dot4 { None } else { direct(&form.alpha) });
        // Both halves the same: one step does both.
        if let (Some(a), Some(b)) = (rgb, alpha)
            && a == b
        {
            return self.push_direct(a, RGB | ALPHA, first);
        }
        // A half that loads arguments reads the other half's channels only before they are written.
        if rgb.is_none() {
            self.push_arguments(&form.rgb, RGB, of_first);
        }
        if alpha.is_none() && !dot4 {
            self.push_arguments(&form.alpha, ALPHA, of_first);
        }
        match rgb {
            Some(direct) => self.push_direct(direct, RGB, first),
            None => {
                let channels = if dot4 { RGB | ALPHA } else { RGB };
                self.plan.push(form.rgb.stage(), function(channels, form.rgb.scale, form.alpha.scale));
            }
        }
        match alpha {
            Some(direct) => self.push_direct(direct, ALPHA, first),
            None if dot4 => {}
            // The dot products are no functions of alpha.
            None => self.plan.push(form.alpha.stage(), function(ALPHA, form.rgb.scale, form.alpha.scale)),
        }
    }

    fn push_direct(&mut self, Direct { stage, source, weight }: Direct, channels: u32, first: bool) {
        match (source, weight) {
            (_, Some((weight, of_alpha))) => {
                self.plan.push(stage, weighted(channels, source, weight, of_alpha, first));
            }
            // Nothing to do: the colour stays.
            (ColorSource::Previous, _) if !first => {}
            (ColorSource::Previous, _) => self.plan.push(stage, direct(channels, ColorSource::Primary, true)),
            _ => self.plan.push(stage, direct(channels, source, first)),
        }
    }

    fn push_arguments(&mut self, half: &CombineHalf, channels: u32, of_first: impl Fn(ColorSource) -> ColorSource) {
        for (slot, a) in half.args.iter().take(half.arity()).enumerate() {
            let a = Argument { source: of_first(a.source), ..*a };
            self.plan.push(&ENV_ARGUMENT, argument(channels, slot, a));
        }
    }

    /// Runs the environments of all units over a batch.
    pub fn run(&self, batch: &mut TexBatch) {
        for step in &self.plan.steps {
            #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
            unsafe {
                (step.run())(batch, &self.uniforms, step.arg);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::LANES;
    use BaseFormat::*;

    const P: [f32; 4] = [0.1, 0.5, 0.7, 0.45];
    const C: [f32; 4] = [0.3, 0.25, 1.0, 0.7];

    /// The texel as it arrives for a base format.
    fn texel(base: BaseFormat) -> [f32; 4] {
        base.expand([0.55, 0.12, 0.35, 0.8])
    }

    /// Runs units with the given texels over the primary colour `P` at every SIMD level, with shortcuts and without.
    fn run(units: &[Option<(&Env, BaseFormat)>], texels: &[[f32; 4]]) -> [f32; 4] {
        let mut results = Level::available().map(|level| {
            let [shortcuts, general] = [false, true].map(|general| {
                let plan = EnvPlan::build_until(level, units, units.len(), general);
                let mut b = TexBatch::new();
                b.n = LANES;
                b.primary = P.map(|c| [c; LANES]);
                b.previous = [[f32::NAN; LANES]; 4];
                for (unit, texel) in texels.iter().enumerate() {
                    b.texel[unit] = texel.map(|c| [c; LANES]);
                }
                plan.run(&mut b);
                b.previous.map(|c| c[LANES - 1])
            });
            assert_eq!(shortcuts.map(f32::to_bits), general.map(f32::to_bits), "a shortcut changes bits");
            shortcuts
        });
        let first = results.next().unwrap();
        for other in results {
            assert_eq!(first.map(f32::to_bits), other.map(f32::to_bits));
        }
        first
    }

    fn one(mode: EnvMode, base: BaseFormat) -> [f32; 4] {
        let env = Env { mode, color: C, ..Env::default() };
        run(&[Some((&env, base))], &[texel(base)])
    }

    fn close(a: [f32; 4], b: [f32; 4]) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6)
    }

    #[test]
    fn every_mode_and_base_format_follows_the_tables() {
        for base in [Alpha, Luminance, LuminanceAlpha, Intensity, Rgb, Rgba] {
            let t = texel(base);
            let color = base != Alpha;
            let alpha = matches!(base, Alpha | LuminanceAlpha | Intensity | Rgba);
            let pick = |f: &dyn Fn(usize) -> f32| -> [f32; 4] {
                std::array::from_fn(|c| if if c < 3 { color } else { alpha } { f(c) } else { P[c] })
            };
            let mut want_blend = pick(&|c| P[c] * (1.0 - t[c]) + C[c] * t[c]);
            let mut want_add = pick(&|c| (P[c] + t[c]).min(1.0));
            if alpha && base != Intensity {
                want_blend[3] = P[3] * t[3];
                want_add[3] = P[3] * t[3];
            }
            assert_eq!(one(EnvMode::Replace, base), pick(&|c| t[c]), "REPLACE {base:?}");
            assert_eq!(one(EnvMode::Modulate, base), pick(&|c| P[c] * t[c]), "MODULATE {base:?}");
            assert!(close(one(EnvMode::Blend, base), want_blend), "BLEND {base:?}: {:?}", one(EnvMode::Blend, base));
            assert_eq!(one(EnvMode::Add, base), want_add, "ADD {base:?}");
            let want_decal = match base {
                Rgb => [t[0], t[1], t[2], P[3]],
                Rgba => [0, 1, 2, 3].map(|c| if c < 3 { P[c] * (1.0 - t[3]) + t[c] * t[3] } else { P[3] }),
                _ => P,
            };
            assert!(close(one(EnvMode::Decal, base), want_decal), "DECAL {base:?}");
        }
    }

    fn combine_env(rgb: CombineFunction, alpha: CombineFunction) -> Env {
        Env {
            mode: EnvMode::Combine,
            color: C,
            combine: [rgb, alpha],
            source: [
                [CombineSource::Texture; 2],
                [CombineSource::PrimaryColor; 2],
                [CombineSource::Constant; 2],
                [CombineSource::Zero; 2],
            ],
            operand: [[CombineOperand::SrcColor, CombineOperand::SrcAlpha]; 4],
            ..Env::default()
        }
    }

    #[test]
    fn every_combine_function_follows_its_formula_at_every_scale() {
        let t = texel(Rgba);
        let dot = 4.0 * (0..3).map(|c| (t[c] - 0.5) * (P[c] - 0.5)).sum::<f32>();
        type F = fn(f32, f32, f32) -> f32;
        let table: [(CombineFunction, F); 6] = [
            (CombineFunction::Replace, |a, _, _| a),
            (CombineFunction::Modulate, |a, b, _| a * b),
            (CombineFunction::Add, |a, b, _| a + b),
            (CombineFunction::AddSigned, |a, b, _| a + b - 0.5),
            (CombineFunction::Interpolate, |a, b, c| a * c + b * (1.0 - c)),
            (CombineFunction::Subtract, |a, b, _| a - b),
        ];
        for k in [1.0, 2.0, 4.0] {
            for (name, f) in table {
                for (other, g) in table {
                    let env = Env { scale: [k, 1.0], ..combine_env(name, other) };
                    let want = std::array::from_fn(|c| {
                        let v = if c < 3 { f(t[c], P[c], C[c]) * k } else { g(t[c], P[c], C[c]) };
                        v.clamp(0.0, 1.0)
                    });
                    assert!(close(run(&[Some((&env, Rgba))], &[t]), want), "{name:?} {other:?} times {k}");
                }
            }
            let env = Env { scale: [k, 2.0], ..combine_env(CombineFunction::Dot3Rgb, CombineFunction::Replace) };
            let d = (dot * k).clamp(0.0, 1.0);
            assert!(close(run(&[Some((&env, Rgba))], &[t]), [d, d, d, 1.0]));
            let env = Env { scale: [k, 2.0], ..combine_env(CombineFunction::Dot3Rgba, CombineFunction::Replace) };
            assert!(close(run(&[Some((&env, Rgba))], &[t]), [d, d, d, (dot * 2.0).clamp(0.0, 1.0)]));
            let env = Env { scale: [k, 2.0], ..combine_env(CombineFunction::Dot3RgbaExt, CombineFunction::Replace) };
            assert!(close(run(&[Some((&env, Rgba))], &[t]), [dot.clamp(0.0, 1.0); 4]), "not scaled");
        }
    }

    #[test]
    fn combine4_adds_products_and_leaves_other_functions_alone() {
        let t = texel(Rgba);
        let one_minus = [CombineOperand::OneMinusSrcColor, CombineOperand::OneMinusSrcAlpha];
        let plain = [CombineOperand::SrcColor, CombineOperand::SrcAlpha];
        for k in [1.0, 2.0, 4.0] {
            for (function, plus) in [(CombineFunction::Add, 0.0), (CombineFunction::AddSigned, -0.5)] {
                for (last, inverted) in [(plain, false), (one_minus, true)] {
                    // The initial fourth argument is 1 - 0.
                    for (source, d) in [(CombineSource::Texture, t), (CombineSource::Zero, [0.0; 4])] {
                        let mut env = Env { mode: EnvMode::Combine4, scale: [k; 2], ..combine_env(function, function) };
                        (env.source[3], env.operand[3]) = ([source; 2], last);
                        let want = std::array::from_fn(|c| {
                            let d = if inverted { 1.0 - d[c] } else { d[c] };
                            ((t[c] * P[c] + C[c] * d + plus) * k).clamp(0.0, 1.0)
                        });
                        assert!(close(run(&[Some((&env, Rgba))], &[t]), want), "{function:?} times {k}");
                    }
                }
            }
        }
        for function in [CombineFunction::Replace, CombineFunction::Interpolate, CombineFunction::Subtract] {
            let env = combine_env(function, function);
            let four = Env { mode: EnvMode::Combine4, ..env };
            assert_eq!(run(&[Some((&env, Rgba))], &[t]), run(&[Some((&four, Rgba))], &[t]), "{function:?}");
        }
        let env = Env {
            source: [[CombineSource::Zero; 2]; 4],
            ..combine_env(CombineFunction::Replace, CombineFunction::Replace)
        };
        assert_eq!(run(&[Some((&env, Rgba))], &[t]), [0.0; 4]);
    }

    #[test]
    fn operands_and_the_crossbar_follow_the_tables() {
        let t = texel(Rgba);
        let mut env = combine_env(CombineFunction::Replace, CombineFunction::Replace);
        for (operand, want) in [
            (CombineOperand::SrcColor, [t[0], t[1], t[2]]),
            (CombineOperand::OneMinusSrcColor, [1.0 - t[0], 1.0 - t[1], 1.0 - t[2]]),
            (CombineOperand::SrcAlpha, [t[3]; 3]),
            (CombineOperand::OneMinusSrcAlpha, [1.0 - t[3]; 3]),
        ] {
            env.operand[0] = [operand, CombineOperand::OneMinusSrcAlpha];
            assert_eq!(run(&[Some((&env, Rgba))], &[t]), [want[0], want[1], want[2], 1.0 - t[3]]);
        }
        // Unit 0 reads the texture of unit 1, and unit 1 that of unit 0.
        let u = [0.125, 0.25, 0.375, 0.5];
        let mut first = combine_env(CombineFunction::Replace, CombineFunction::Replace);
        first.source[0] = [CombineSource::Unit(1); 2];
        let mut second = combine_env(CombineFunction::Modulate, CombineFunction::Modulate);
        second.source[0] = [CombineSource::Unit(0); 2];
        second.source[1] = [CombineSource::Previous; 2];
        let got = run(&[Some((&first, Rgba)), Some((&second, Rgba))], &[t, u]);
        assert!(close(got, std::array::from_fn(|c| t[c] * u[c])));
        // A texture that is not there leaves the colour as it comes.
        assert_eq!(run(&[Some((&first, Rgba)), None], &[t, u]), P);
        assert_eq!(run(&[None, None], &[]), P);
        assert_eq!(run(&[], &[]), P);
    }

    #[test]
    fn units_follow_each_other_and_gaps_do_not_matter() {
        let modulate = Env::default();
        let add = Env { mode: EnvMode::Add, ..Env::default() };
        let t = texel(Rgba);
        let got = run(
            &[None, Some((&modulate, Rgba)), None, Some((&add, Rgb))],
            &[[0.9; 4], t, [0.9; 4], [0.5, 0.5, 0.5, 1.0]],
        );
        let want = std::array::from_fn(|c| if c < 3 { (P[c] * t[c] + 0.5).min(1.0) } else { P[c] * t[c] });
        assert!(close(got, want), "{got:?} {want:?}");
    }

    #[test]
    fn what_only_moves_or_multiplies_takes_one_step() {
        let steps = |mode, base| {
            let env = Env { mode, ..Env::default() };
            let plan = EnvPlan::build_until(Level::BASELINE, &[Some((&env, base))], 1, false);
            plan.plan.names().collect::<Vec<_>>()
        };
        assert_eq!(steps(EnvMode::Replace, Rgba), ["ENV_REPLACE"]);
        assert_eq!(steps(EnvMode::Modulate, Rgba), ["ENV_MODULATE"]);
        assert_eq!(steps(EnvMode::Modulate, Rgb), ["ENV_MODULATE", "ENV_REPLACE"]);
        let env = Env { mode: EnvMode::Combine, ..Env::default() };
        let plan = EnvPlan::build_until(Level::BASELINE, &[Some((&env, Rgba))], 1, false);
        assert_eq!(plan.plan.steps.len(), 1, "COMBINE with its initial values is MODULATE");
        let env = Env { scale: [2.0, 1.0], ..env };
        assert!(EnvPlan::build_until(Level::BASELINE, &[Some((&env, Rgba))], 1, false).plan.steps.len() > 1);
    }
}
