//! The part of a program that textures (OpenGL 1.5, section 3.8): coordinates and sampler of each unit, then the
//! environments. Where nothing but the alpha test comes between the last environment and the store, its colour is rounded
//! as it is made, or never leaves the packed form in which the texel was stored.

use super::{Builder, Names};
use crate::fragment::key::{Blending, EnvStep, FragmentKey, LightMap, LinearTexture, NearestTexture, SpanTexture};
use crate::fragment::planes::UnitSlots;
use crate::fragment::program::{Action, Fate};
use crate::fragment::reference::{env_pack, texcoord};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::texture::{CombineFunction, CombineOperand, Env};
use crate::texture::env::combine::{ColorSource, CombineHalf};
use crate::texture::env::{EnvPlan, combine};
use crate::texture::format::BaseFormat;
use crate::texture::object::TextureObject;
use crate::texture::sampler::Sampler;
use crate::texture::uniforms::LinearImage;

/// The base format of each unit's texture, as environments see it.
type Bases = [Option<BaseFormat>; MAX_TEXTURE_UNITS];

/// How the colour leaves texturing.
#[derive(Clone, Copy)]
enum Leaves {
    /// As floats.
    Floats,
    /// As the texels that the one sampler found; the number is that of [`env_pack::PACK_TEXEL`].
    Texels(u32),
    /// Rounded by the last unit's environment; the number is that of [`env_pack::ENV_PACK`]. The steps of colour and alpha where
    /// that is the only environment and there is no alpha test.
    Packed { unit: usize, number: u32, steps: Option<[EnvStep; 2]> },
}

/// What a half of an environment does, if it is one of the steps that can round at once. `operands` are those that read
/// the half's own channels.
fn step(half: &CombineHalf, unit: usize, operands: &[CombineOperand]) -> Option<EnvStep> {
    let args = half.args.get(..half.arity())?;
    if half.scale != 1.0 || !args.iter().all(|a| operands.contains(&a.operand)) {
        return None;
    }
    let texel = ColorSource::Texture(unit);
    match (half.function, args) {
        (CombineFunction::Replace, [a]) if a.source == texel => Some(EnvStep::Texel),
        (CombineFunction::Replace, [a]) if a.source == ColorSource::Previous => Some(EnvStep::Keep),
        (CombineFunction::Modulate, [a, b])
            if [a.source, b.source] == [texel, ColorSource::Previous]
                || [a.source, b.source] == [ColorSource::Previous, texel] =>
        {
            Some(EnvStep::Product)
        }
        _ => None,
    }
}

impl Builder<'_> {
    /// Sampling and environments of all units.
    pub(super) fn texturing(&mut self, key: &FragmentKey, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS]) {
        let state = self.state;
        let mut bases: Bases = [None; MAX_TEXTURE_UNITS];
        let mut samplers: Vec<(usize, Sampler)> = Vec::new();
        for (unit, texture) in textures.iter().enumerate() {
            let (Some(texture), Some(unit_state)) = (texture, state.texture.units.get(unit)) else { continue };
            let sampler = Sampler::build_with(self.level, texture, unit_state.env.lod_bias, unit, self.options.general);
            bases[unit] = Some(sampler.base);
            samplers.push((unit, sampler));
        }
        if !self.options.general {
            for unit in self.unused(&bases) {
                bases[unit] = None;
                samplers.retain(|(of, _)| *of != unit);
                let reason = "no later environment takes its colour, and none its texture";
                self.decide(format_args!("unit {unit}"), Fate::LeftOut, reason);
            }
        }
        // What they give is rounded and stored, with nothing between but perhaps the alpha test.
        let untouched = key.is_packed() && key.ends_with_texturing();
        let alpha_test = key.tests.alpha.is_some();
        let leaves = if untouched { self.leaves(&mut samplers, alpha_test) } else { Leaves::Floats };
        let reads_primary = match leaves {
            Leaves::Texels(number) => number & env_pack::PRIMARY_ALPHA != 0,
            _ => self.reads_primary(&bases) || self.options.general,
        };
        if reads_primary {
            self.primary_color(key);
            self.decide("colour", Fate::Kept, "a texture environment reads it");
        } else {
            self.decide("colour", Fate::LeftOut, "no texture environment reads the primary colour");
        }
        self.program.uniforms.span = self.span_texture(key, &samplers, leaves);
        for (unit, sampler) in samplers {
            self.unit(unit, sampler);
        }
        self.environments(bases, leaves);
    }

    /// What a span kernel shows, where the samplers and environments come to something so simple.
    fn span_texture(&self, key: &FragmentKey, samplers: &[(usize, Sampler)], leaves: Leaves) -> Option<SpanTexture> {
        if samplers.iter().any(|(unit, _)| self.has_q(*unit, false)) {
            return None;
        }
        match samplers {
            [(unit, sampler)] => self.one_texture(key, *unit, sampler, leaves),
            [first, last] => self.light_mapped(first, last, leaves),
            _ => None,
        }
    }

    /// That of one texture.
    fn one_texture(&self, key: &FragmentKey, unit: usize, sampler: &Sampler, leaves: Leaves) -> Option<SpanTexture> {
        let (steps, blend) = match (leaves, key.blend) {
            (Leaves::Texels(0), _) => {
                return Some(SpanTexture::Nearest(NearestTexture {
                    unit: unit as u32,
                    image: sampler.nearest_image()?,
                }));
            }
            (Leaves::Packed { steps, .. }, _) => (steps?, None),
            (Leaves::Floats, Some(Blending::Pair(pair))) if key.ends_with_texturing() && key.tests.alpha.is_none() => {
                (self.steps(unit, sampler, 1u32.checked_shl(unit as u32).unwrap_or(0))?, Some(pair))
            }
            _ => return None,
        };
        let unit = unit as u32;
        let light_map = None;
        Some(match sampler.linear_image()? {
            LinearImage::Rgb(image) => SpanTexture::LinearRgb(LinearTexture { unit, image, steps, blend, light_map }),
            LinearImage::Rgba(image) => SpanTexture::LinearRgba(LinearTexture { unit, image, steps, blend, light_map }),
            LinearImage::Rgb3d(image) => {
                SpanTexture::LinearRgb3d(LinearTexture { unit, image, steps, blend, light_map })
            }
        })
    }

    /// That of two opaque textures, where the colour of one is multiplied with that of another one, which has no levels.
    fn light_mapped(&self, first: &(usize, Sampler), last: &(usize, Sampler), leaves: Leaves) -> Option<SpanTexture> {
        let Leaves::Packed { number, .. } = leaves else { return None };
        let enabled = 1 << (first.0 & 31) | 1 << (last.0 & 31);
        let [steps, [color, alpha]] = [self.steps(first.0, &first.1, enabled)?, self.steps(last.0, &last.1, enabled)?];
        // Alpha of the last one is 1 everywhere.
        let multiplies = color == EnvStep::Product && alpha != EnvStep::Texel;
        if !multiplies || number & env_pack::TESTED != 0 || last.1.rho_ranges.is_some() {
            return None;
        }
        let (LinearImage::Rgb(image), LinearImage::Rgb(other)) = (first.1.linear_image()?, last.1.linear_image()?)
        else {
            return None;
        };
        let light_map = Some(LightMap { unit: last.0 as u32, image: other });
        let unit = first.0 as u32;
        Some(SpanTexture::LinearRgb(LinearTexture { unit, image, steps, blend: None, light_map }))
    }

    /// The units of which nothing comes: a later environment starts anew, and none reads their texture.
    fn unused(&self, bases: &Bases) -> Vec<usize> {
        let (mut color_taken, mut textures) = (true, 0u32);
        let mut idle = Vec::new();
        for (unit, base) in bases.iter().enumerate().rev() {
            let (Some(base), Some(state)) = (base, self.state.texture.units.get(unit)) else { continue };
            if !color_taken {
                idle.push(unit);
                continue;
            }
            let form = combine(&state.env, *base, unit, |t| bases.get(t).is_some_and(Option::is_some));
            color_taken = false;
            for argument in [form.rgb, form.alpha].iter().flat_map(|half| half.args.into_iter().take(half.arity())) {
                match argument.source {
                    ColorSource::Texture(t) => textures |= 1u32.checked_shl(t as u32).unwrap_or(0),
                    ColorSource::Previous => color_taken = true,
                    _ => {}
                }
            }
        }
        idle.retain(|unit| textures >> unit & 1 == 0);
        idle
    }

    /// Coordinates and sampler of a unit.
    fn unit(&mut self, unit: usize, sampler: Sampler) {
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
        let flags = first | if derivatives { texcoord::DERIVATIVES } else { 0 };
        self.push(&texcoord::COORDINATES, flags | (unit as u32) << 2);
        let q = if has_q { "divided by q" } else { "q is 1" };
        let d = if derivatives { "with derivatives" } else { "no derivatives, the level cannot differ" };
        self.decide(format_args!("unit {unit} coordinates"), Fate::Kept, format_args!("{count} of s, t, r, {q}, {d}"));
        if sampler.once {
            let reason = "once a batch where w is constant over its primitive: derivatives are then constants";
            self.decide(format_args!("unit {unit} level of detail"), Fate::Hoisted, reason);
        }
        if let Some(levels) = &sampler.rho_ranges
            && let Some(place) = self.program.uniforms.levels.get_mut(unit)
        {
            *place = Some(levels.clone());
            let reason = "not where the least and the greatest rho of a row leave one level";
            self.decide(format_args!("unit {unit} derivatives"), Fate::Hoisted, reason);
        }
        self.program.reference.push(Action::Sample(self.program.samplers.len()));
        self.decide(format_args!("unit {unit} sampler"), Fate::Kept, Names(&sampler.plan.steps));
        if sampler.wraps {
            let reason = "with the fetch, and only where a primitive's coordinates leave 0 to 1";
            self.decide(format_args!("unit {unit} wrap"), Fate::Hoisted, reason);
        }
        if sampler.opaque {
            let reason = "it is 1 in every texel, so it is 1 without a filter";
            self.decide(format_args!("unit {unit} alpha"), Fate::LeftOut, reason);
        }
        self.program.samplers.push(sampler);
    }

    /// The environments of all units.
    fn environments(&mut self, bases: Bases, leaves: Leaves) {
        let state = self.state;
        let units: Vec<Option<(&Env, BaseFormat)>> =
            bases.iter().enumerate().map(|(u, base)| Some((&state.texture.units.get(u)?.env, (*base)?))).collect();
        let end = match leaves {
            Leaves::Texels(number) => {
                self.packed = true;
                self.push(&env_pack::PACK_TEXEL, number);
                self.decide(
                    "environments",
                    Fate::LeftOut,
                    "REPLACE with the nearest 8-bit texel: it is stored as it is, without a way through floats",
                );
                return;
            }
            Leaves::Packed { unit, .. } => unit,
            Leaves::Floats => units.len(),
        };
        if matches!(leaves, Leaves::Floats) || units.iter().take(end).any(Option::is_some) {
            let environments = EnvPlan::build_until(self.level, &units, end, self.options.general);
            self.decide("environments", Fate::Kept, Names(&environments.plan.steps));
            self.program.environments = Some(environments);
            self.program.reference.push(Action::Environments);
        }
        if let Leaves::Packed { unit, number, .. } = leaves {
            self.packed = true;
            self.push(&env_pack::ENV_PACK, number);
            self.decide(
                format_args!("unit {unit} environment"),
                Fate::Hoisted,
                "its colour is rounded as it is made: nothing that needs floats comes before the store",
            );
        }
    }

    /// What a unit's environment does with colour and alpha, if that is so simple. Bit u of `enabled`: unit u has a texture.
    fn steps(&self, unit: usize, sampler: &Sampler, enabled: u32) -> Option<[EnvStep; 2]> {
        let state = self.state.texture.units.get(unit)?;
        let form = combine(&state.env, sampler.base, unit, |t| t < 32 && enabled >> t & 1 != 0);
        let color = step(&form.rgb, unit, &[CombineOperand::SrcColor])?;
        Some([color, step(&form.alpha, unit, &[CombineOperand::SrcColor, CombineOperand::SrcAlpha])?])
    }

    /// How the colour leaves texturing where only the alpha test and the store follow. Makes the sampler give packed
    /// texels where they are the colour.
    fn leaves(&self, samplers: &mut [(usize, Sampler)], alpha_test: bool) -> Leaves {
        let enabled = samplers.iter().fold(0u32, |set, (unit, _)| set | 1 << (unit & 31));
        let one = samplers.len() == 1;
        let Some((unit, sampler)) = samplers.last_mut() else { return Leaves::Floats };
        let unit = *unit;
        let Some([color, alpha]) = self.steps(unit, sampler, enabled) else { return Leaves::Floats };
        let tested = if alpha_test { env_pack::TESTED } else { 0 };
        let unseen = !alpha_test && self.program.uniforms.packed_or >> 24 == 0xFF;
        let texels = match alpha {
            EnvStep::Texel => Some(0),
            _ if unseen => Some(0),
            EnvStep::Keep => Some(env_pack::PRIMARY_ALPHA),
            EnvStep::Product => None,
        };
        match texels {
            Some(number) if one && color == EnvStep::Texel && sampler.pack() => Leaves::Texels(number | tested),
            _ => {
                let later = if one { 0 } else { env_pack::LATER };
                let number = env_pack::env_pack(unit, [color, alpha], later | tested);
                Leaves::Packed { unit, number, steps: (later | tested == 0).then_some([color, alpha]) }
            }
        }
    }
}
