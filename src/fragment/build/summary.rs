//! From the state to the key, with what is said about each decision. Each condition is exact, never an "almost" on floats; a
//! program built with [`Options::general`](crate::fragment::program::Options::general) keeps everything and gives the same
//! bytes.

use super::Builder;
use crate::fragment::compare::CompareFunc;
use crate::fragment::key::{Blending, ColorWrites, FogFactor, FragmentKey, FragmentSource, Tests};
use crate::fragment::pixel_rect::PixelValues;
use crate::fragment::program::Fate;
use crate::fragment::reference::blend::packed_pair;
use crate::fragment::uniforms::{BlendUniforms, StencilOps, StencilUniforms};
use crate::num::clamp01;
use crate::state::color_buffer::{BlendEquation, BlendFactor, ColorBufferName, LogicOp};
use crate::state::depth_stencil::{StencilFace, StencilOp};
use crate::state::fog::{FogCoordSource, FogDistanceMode, FogMode};
use crate::state::lighting::ColorControl;

impl Builder<'_> {
    /// The key of the state; `textured`: a unit has an enabled and complete texture.
    pub(super) fn summarise(&mut self, textured: bool) -> FragmentKey {
        let colors = self.color_writes();
        let tests = self.tests();
        let needs_color = colors != ColorWrites::Nothing || tests.alpha.is_some();
        let mut key = FragmentKey {
            source: self.source(),
            tests,
            textured,
            colors,
            float: self.format.float,
            counts_samples: self.options.count_samples,
            general: self.options.general,
            ..FragmentKey::default()
        };
        if needs_color {
            key.blend = self.blending();
            key.logic_op = self.logic_op();
            key.color_sum = self.color_sum();
            key.fog = self.fog();
            key.coverage = self.options.coverage || self.options.general;
        }
        key
    }

    /// Where colour and depth come from.
    fn source(&mut self) -> FragmentSource {
        let Some(rect) = self.options.pixels.take() else { return FragmentSource::Primitive };
        let source = match rect.values {
            PixelValues::Packed(_) => FragmentSource::PixelColors { packed: true },
            PixelValues::Colors(_) => FragmentSource::PixelColors { packed: false },
            PixelValues::Depths(_) => FragmentSource::PixelDepths,
        };
        self.program.uniforms.pixels = Some(rect);
        source
    }

    /// Which channels are written; notes masks and units of the stores.
    fn color_writes(&mut self) -> ColorWrites {
        let c = &self.state.color_buffer;
        let mask = crate::framebuffer::packed_mask(c.color_mask);
        let noop = c.logic_op_enabled && c.logic_op == LogicOp::Noop && !self.format.float;
        let u = &mut self.program.uniforms;
        u.color_mask = if c.draw_buffer == ColorBufferName::None || noop { 0 } else { mask };
        u.packed_or = crate::framebuffer::no_alpha_bits(self.format);
        (u.scale, u.limit) = if self.format.float { (1.0, f32::MAX) } else { (255.0, 255.0) };
        u.alpha_ref = clamp01(c.alpha_ref);
        match u.color_mask {
            0 => ColorWrites::Nothing,
            u32::MAX => ColorWrites::All,
            _ => ColorWrites::Masked,
        }
    }

    /// Which tests there are.
    fn tests(&mut self) -> Tests {
        let general = self.options.general;
        let (c, d, s) = (&self.state.color_buffer, &self.state.depth, &self.state.stencil);
        let alpha = if c.alpha_test { c.alpha_func } else { CompareFunc::Always };
        let depth_on = d.test && self.format.depth_bits != 0;
        let depth = if depth_on { d.func } else { CompareFunc::Always };
        let depth_write = depth_on && d.mask && depth != CompareFunc::Never;
        let stencil_on = s.test && self.format.stencil_bits != 0;
        let funcs = s.faces.map(|face| if stencil_on { face.func } else { CompareFunc::Always });
        let op = |on: bool, value| if stencil_on && on { value } else { StencilOp::Keep };
        let ops = |face: StencilFace| StencilOps {
            fail: op(face.func != CompareFunc::Always, face.fail),
            depth_fail: op(face.func != CompareFunc::Never && depth != CompareFunc::Always, face.depth_fail),
            pass: op(face.func != CompareFunc::Never && depth != CompareFunc::Never, face.depth_pass),
        };
        let stencil = StencilUniforms {
            reference: s.reference.clamp(0, 255).cast_unsigned(),
            value_mask: s.value_mask & 0xFF,
            write_mask: if stencil_on { s.write_mask & 0xFF } else { 0 },
            faces: s.faces.map(ops),
        };
        let stencil_write = stencil.write_mask != 0 && stencil.faces != [StencilOps::default(); 2];
        let passes = funcs == [CompareFunc::Always; 2];
        let two_sided = funcs[0] != funcs[1] || (stencil_write && stencil.faces[0] != stencil.faces[1]);
        self.program.uniforms.stencil = stencil;
        let keep_stencil = !passes || stencil_write || (general && self.format.stencil_bits != 0);
        let keep_depth = depth != CompareFunc::Always || depth_write || (general && self.format.depth_bits != 0);
        let off = |on: bool| match on {
            true => "the test is on, but passes every fragment and writes nothing",
            false => "the test is off, or the framebuffer has no such buffer",
        };
        if alpha != CompareFunc::Always || general {
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
            let [front, back] = funcs.map(CompareFunc::name);
            match two_sided {
                false => self.decide("stencil test", Fate::Kept, format_args!("{front}, {writes}")),
                true => self.decide("stencil test", Fate::Kept, format_args!("front {front}, back {back}, {writes}")),
            }
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
            alpha: (alpha != CompareFunc::Always || general).then_some(alpha),
            stencil: keep_stencil.then_some(funcs),
            two_sided: keep_stencil && (two_sided || general),
            stencil_write: stencil_write || (general && keep_stencil),
            depth: keep_depth.then_some(depth),
            depth_write,
        }
    }

    /// Which blending there is.
    fn blending(&mut self) -> Option<Blending> {
        let general = self.options.general;
        let c = &self.state.color_buffer;
        let blend = BlendUniforms {
            src: c.blend_src,
            dst: c.blend_dst,
            equation: c.blend_equation,
            color: c.blend_color.map(clamp01),
        };
        let off = BlendUniforms { src: [BlendFactor::One; 2], dst: [BlendFactor::Zero; 2], ..BlendUniforms::default() };
        let copies = blend.equation == [BlendEquation::Add; 2] && blend.src == off.src && blend.dst == off.dst;
        let reason = match (c.blend, c.logic_op_enabled && !self.format.float, copies) {
            (false, ..) => "GL_BLEND is off",
            (_, true, _) => "a logic op takes its place",
            (.., true) => "ONE, ZERO gives the fragment's colour: the framebuffer is not read",
            _ => {
                let [src, dst] = [c.blend_src[0], c.blend_dst[0]].map(BlendFactor::name);
                self.program.uniforms.blend = blend;
                self.program.reads_framebuffer = true;
                self.decide("blending", Fate::Kept, format_args!("factors {src}, {dst}"));
                let pair = if general || self.format.float { None } else { packed_pair(&blend) };
                return Some(pair.map_or(Blending::Any, Blending::Pair));
            }
        };
        self.decide("blending", if general { Fate::Kept } else { Fate::LeftOut }, reason);
        self.program.uniforms.blend = off;
        general.then_some(Blending::Any)
    }

    /// Which logic op there is.
    fn logic_op(&mut self) -> Option<LogicOp> {
        let c = &self.state.color_buffer;
        let general = self.options.general && !self.format.float;
        let reason = match (c.logic_op_enabled, self.format.float, c.logic_op == LogicOp::Copy) {
            (false, ..) => "GL_COLOR_LOGIC_OP is off",
            (_, true, _) => "floats have no bits to combine",
            (.., true) => "GL_COPY stores the fragment's colour",
            _ => {
                self.decide("logic op", Fate::Kept, format_args!("operation {}", c.logic_op.name()));
                self.program.reads_framebuffer = true;
                return Some(c.logic_op);
            }
        };
        self.decide("logic op", if general { Fate::Kept } else { Fate::LeftOut }, reason);
        general.then_some(LogicOp::Copy)
    }

    /// Whether the secondary colour is added.
    fn color_sum(&mut self) -> bool {
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

    /// The fog factor.
    fn fog(&mut self) -> Option<FogFactor> {
        let f = &self.state.fog;
        let general = self.options.general;
        if !f.enabled || (f.mode != FogMode::Linear && f.density == 0.0) {
            let reason = if f.enabled { "the density is 0, so the factor is 1" } else { "GL_FOG is off" };
            self.decide("fog", if general { Fate::Kept } else { Fate::LeftOut }, reason);
            // Density 0 gives the factor 1, which leaves every colour as it is.
            return general.then_some(FogFactor::Exp);
        }
        let u = &mut self.program.uniforms;
        u.fog_color = [clamp01(f.color[0]), clamp01(f.color[1]), clamp01(f.color[2])];
        (u.fog_scale, u.fog_end) = (f.density, f.end);
        let signed = f.coord_source == FogCoordSource::FogCoord || f.distance_mode == FogDistanceMode::EyePlane;
        u.fog_bits = if signed { u32::MAX } else { u32::MAX >> 1 };
        let factor = match f.mode {
            FogMode::Linear if f.end == f.start => FogFactor::Step,
            FogMode::Linear => {
                u.fog_scale = (1.0 / (f64::from(f.end) - f64::from(f.start))) as f32;
                FogFactor::Linear
            }
            FogMode::Exp2 => FogFactor::Exp2,
            FogMode::Exp => FogFactor::Exp,
        };
        self.decide("fog", Fate::Kept, format_args!("{} for every fragment", f.mode.name()));
        Some(factor)
    }
}
