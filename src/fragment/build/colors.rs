//! The part of a program that makes the fragment's colour: interpolation, colour sum, fog, coverage (texturing is in
//! `texturing.rs`); and with it the layout, since every stage that interpolates takes its slots where it is placed.

use super::Builder;
use crate::fragment::key::{FogFactor, FragmentKey, FragmentSource};
use crate::fragment::program::Fate;
use crate::fragment::reference::{fog, interpolate, pack};
use crate::limits::MAX_TEXTURE_UNITS;
use crate::texture::env::combine;
use crate::texture::env::combine::ColorSource;
use crate::texture::format::BaseFormat;
use crate::texture::object::TextureObject;

impl Builder<'_> {
    /// Everything that makes the fragment's colour. Where that is the interpolated colour and nothing else it is packed as it is
    /// interpolated, and where no fragment can be killed also stored.
    pub(super) fn colors(&mut self, key: &FragmentKey, textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS]) {
        if key.textured {
            self.texturing(key, textures);
        } else {
            self.decide("texturing", Fate::LeftOut, "no unit has an enabled and complete texture");
            if key.is_plain() {
                self.program.layout.color = Some(self.slots(4));
                let first = self.first();
                self.push(if key.stores_at_once() { &pack::COLOR_STORE } else { &pack::COLOR_PACKED }, first);
                self.decide(
                    "colour",
                    Fate::Hoisted,
                    "packed as it is interpolated, once a primitive where it is constant",
                );
            } else {
                self.primary_color(key);
                let from_image = matches!(key.source, FragmentSource::PixelColors { .. });
                self.decide("colour", Fate::Kept, if from_image { "of the pixel rectangle" } else { "interpolated" });
            }
        }
        if key.color_sum {
            self.program.layout.secondary = Some(self.slots(3));
            let first = self.first();
            self.push(&interpolate::SECONDARY, first);
            self.push(&fog::COLOR_SUM, 0);
        }
        if let Some(factor) = key.fog {
            self.program.layout.fog = Some(self.slots(1));
            let first = self.first();
            self.push(&interpolate::FOG_COORDINATE, first);
            let stage = match factor {
                FogFactor::Step => &fog::FOG_STEP,
                FogFactor::Linear => &fog::FOG_LINEAR,
                FogFactor::Exp => &fog::FOG_EXP,
                FogFactor::Exp2 => &fog::FOG_EXP2,
            };
            self.push(stage, 0);
        }
        if key.coverage {
            if !self.options.coverage {
                self.push(&fog::FULL_COVERAGE, 0);
            }
            self.push(&fog::COVERAGE, 0);
        }
    }

    /// Whether any environment reads the primary colour: by name, or as what comes before the first unit.
    pub(super) fn reads_primary(&self, bases: &[Option<BaseFormat>; MAX_TEXTURE_UNITS]) -> bool {
        let mut first = true;
        for (unit, base) in bases.iter().enumerate() {
            let (Some(base), Some(state)) = (base, self.state.texture.units.get(unit)) else { continue };
            let form = combine(&state.env, *base, unit, |t| bases.get(t).is_some_and(Option::is_some));
            let reads = [form.rgb, form.alpha].iter().any(|half| {
                half.args.iter().take(half.arity()).any(|a| match a.source {
                    ColorSource::Primary => true,
                    ColorSource::Previous => first,
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
