//! The part of a program that makes the fragment's colour: interpolation, texturing of all units, colour sum, fog,
//! coverage; and with it the layout, since every stage that interpolates takes its slots where it is placed.

use super::super::compare::Func;
use super::super::planes::UnitSlots;
use super::super::program::{Action, Fate};
use super::super::uniforms::FragFn;
use super::super::{coordinates, fog, interpolate, pack, texel};
use super::Builder;
use crate::batch::Stage;
use crate::enums::{GL_EXP2, GL_LINEAR, GL_SEPARATE_SPECULAR_COLOR, name};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::texture::combine::{Function, Half, Operand, Source};
use crate::texture::env::{EnvPlan, combine};
use crate::texture::format::BaseFormat;
use crate::texture::object::TextureObject;
use crate::texture::sampler::Sampler;

impl Builder<'_> {
    /// Everything that makes the fragment's colour. Gives whether that is the interpolated colour and nothing else, and
    /// `packable` with it, so that it is packed as it is interpolated; then it has been, and with `direct` also stored.
    pub(super) fn colors(
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
            let untouched = packable && !sum && fog.is_none() && !coverage && !general;
            self.texturing(textures, untouched, alpha_test.is_some());
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

    /// Sampling and environments of all units. `untouched`: what they give is rounded and stored, with nothing between but
    /// perhaps the alpha test.
    fn texturing(&mut self, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS], untouched: bool, alpha_test: bool) {
        let state = self.state;
        let mut bases: [Option<BaseFormat>; MAX_TEXTURE_UNITS] = [None; MAX_TEXTURE_UNITS];
        let mut samplers: Vec<(usize, Sampler)> = Vec::new();
        for (unit, texture) in textures.iter().enumerate() {
            let (Some(texture), Some(unit_state)) = (texture, state.texture.units.get(unit)) else { continue };
            let sampler = Sampler::build_with(self.level, texture, unit_state.env.lod_bias, unit, self.options.general);
            bases[unit] = Some(sampler.base);
            samplers.push((unit, sampler));
        }
        let alpha = if untouched { self.texel_alpha(&mut samplers, alpha_test) } else { None };
        self.texel = alpha.is_some();
        let reads_primary = match alpha {
            Some(alpha) => alpha == texel::PRIMARY_ALPHA,
            None => self.reads_primary(&bases) || self.options.general,
        };
        if reads_primary {
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
        if let Some(alpha) = alpha {
            self.push(&texel::PACK_TEXEL, alpha);
            self.decide(
                "environments",
                Fate::LeftOut,
                "REPLACE with the nearest 8-bit texel: it is stored as it is, without a way through floats",
            );
            return;
        }
        let units: Vec<_> =
            bases.iter().enumerate().map(|(u, base)| Some((&state.texture.units.get(u)?.env, (*base)?))).collect();
        let environments = EnvPlan::build_with(self.level, &units, self.options.general);
        let steps: Vec<_> = environments.plan.steps.iter().map(|s| s.name.to_lowercase()).collect();
        self.decide("environments", Fate::Kept, steps.join(", "));
        self.program.environments = Some(environments);
        self.program.actions.push(Action::Environments);
    }

    /// Where the one unit puts the nearest 8-bit texel in the place of the colour: makes its sampler give packed texels,
    /// and says where alpha comes from, as [`texel::PACK_TEXEL`] has it.
    fn texel_alpha(&self, samplers: &mut [(usize, Sampler)], alpha_test: bool) -> Option<u32> {
        let [(unit, sampler)] = samplers else { return None };
        let form = combine(&self.state.texture.units.get(*unit)?.env, sampler.base, *unit, |_| false);
        let of_texel = |half: &Half, operands: &[Operand]| {
            let [first, ..] = half.args;
            half.function == Function::Replace
                && half.scale == 1.0
                && first.source == Source::Texture(*unit)
                && operands.contains(&first.operand)
        };
        let keeps = form.alpha.function == Function::Replace
            && form.alpha.scale == 1.0
            && matches!(form.alpha.args[0].source, Source::Previous | Source::Primary)
            && matches!(form.alpha.args[0].operand, Operand::Color | Operand::Alpha);
        let no_alpha = !alpha_test && self.program.uniforms.packed_or >> 24 == 0xFF;
        let alpha = if no_alpha || of_texel(&form.alpha, &[Operand::Color, Operand::Alpha]) {
            0
        } else if keeps && !alpha_test {
            texel::PRIMARY_ALPHA
        } else {
            return None;
        };
        (of_texel(&form.rgb, &[Operand::Color]) && sampler.pack()).then_some(alpha)
    }

    /// Whether any environment reads the primary colour: by name, or as what comes before the first unit.
    pub(super) fn reads_primary(&self, bases: &[Option<BaseFormat>; MAX_TEXTURE_UNITS]) -> bool {
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
    pub(super) fn has_q(&self, unit: usize, cube: bool) -> bool {
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
    pub(super) fn color_sum(&mut self) -> bool {
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
    pub(super) fn fog(&mut self) -> Option<&'static Stage<FragFn>> {
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

    /// Back colours, strides.
    pub(super) fn finish_layout(&mut self) {
        let l = &mut self.program.layout;
        l.stride = l.count;
        let two_sided = self.state.lighting.enabled && self.state.lighting.model.two_side;
        if two_sided && (l.color.is_some() || l.secondary.is_some()) {
            l.back = Some(l.count);
            l.stride += 4 + if l.secondary.is_some() { 3 } else { 0 };
        }
    }
}
