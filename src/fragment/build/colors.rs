//! The part of a program that makes the fragment's colour: interpolation, colour sum, fog, coverage (texturing is next
//! door); and with it the layout, since every stage that interpolates takes its slots where it is placed.

use super::Builder;
use crate::fragment::compare::Func;
use crate::fragment::program::Fate;
use crate::fragment::reference::{fog, interpolate, pack};
use crate::fragment::uniforms::FragFn;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::num::clamp01;
use crate::simd::Stage;
use crate::state::fog::FogMode;
use crate::state::lighting::ColorControl;
use crate::texture::env::combine;
use crate::texture::env::combine::ColorSource;
use crate::texture::format::BaseFormat;
use crate::texture::object::TextureObject;

impl Builder<'_> {
    /// Everything that makes the fragment's colour. Gives whether that is the interpolated colour and nothing else, and
    /// `packable` with it, so that it is packed as it is interpolated; then it has been, and with `direct` also stored. `blended`: the
    /// number of the pair of factors that it is blended by.
    pub(super) fn colors(
        &mut self,
        textures: [Option<&TextureObject>; MAX_TEXTURE_UNITS],
        alpha_test: Option<Func>,
        (packable, blended): (bool, Option<u32>),
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
            let bare = !sum && fog.is_none() && !coverage && !general && alpha_test.is_none();
            self.texturing(textures, untouched, (alpha_test.is_some(), blended.filter(|_| bare)));
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

    /// Whether any environment reads the primary colour: by name, or as what comes before the first unit.
    pub(super) fn reads_primary(&self, bases: &[Option<BaseFormat>; MAX_TEXTURE_UNITS]) -> bool {
        let mut first = true;
        for (unit, base) in bases.iter().enumerate() {
            let (Some(base), Some(state)) = (base, self.state.texture.units.get(unit)) else { continue };
            let form = combine(&state.env, *base, unit, |t| bases.get(t).is_some_and(Option::is_some));
            let reads = [form.rgb, form.alpha].iter().any(|half| {
                half.args.iter().take(half.function.arity()).any(|a| match a.source {
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

    /// Whether the secondary colour is added.
    pub(super) fn color_sum(&mut self) -> bool {
        let light = &self.state.lighting;
        let separate = light.model.color_control == ColorControl::SeparateSpecularColor;
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
        if !f.enabled || (f.mode != FogMode::Linear && f.density == 0.0) {
            let reason = if f.enabled { "the density is 0, so the factor is 1" } else { "GL_FOG is off" };
            self.decide("fog", if general { Fate::Kept } else { Fate::LeftOut }, reason);
            // Density 0 gives the factor 1, which leaves every colour as it is.
            return general.then_some(&fog::FOG_EXP);
        }
        u.fog_color = [clamp01(f.color[0]), clamp01(f.color[1]), clamp01(f.color[2])];
        u.fog_scale = f.density;
        u.fog_end = f.end;
        self.decide("fog", Fate::Kept, format_args!("{} for every fragment", f.mode.name()));
        let u = &mut self.program.uniforms;
        Some(match f.mode {
            FogMode::Linear if f.end == f.start => &fog::FOG_STEP,
            FogMode::Linear => {
                u.fog_scale = (1.0 / (f64::from(f.end) - f64::from(f.start))) as f32;
                &fog::FOG_LINEAR
            }
            FogMode::Exp2 => &fog::FOG_EXP2,
            FogMode::Exp => &fog::FOG_EXP,
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
