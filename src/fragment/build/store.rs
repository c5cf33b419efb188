//! The end of a program: blending, logic op, colour mask and the store.

use super::Builder;
use crate::fragment::program::{Action, Fate};
use crate::fragment::reference::blend::{BLEND, BLEND_PACKED, BLEND_STORE, packed_pair};
use crate::fragment::reference::{env_pack, float_store, logic_op, pack};
use crate::fragment::uniforms::BlendUniforms;
use crate::num::clamp01;
use crate::state::color_buffer::{BlendEquation, BlendFactor, LogicOp};

/// How a program blends.
#[derive(Clone, Copy)]
pub(super) enum Blending {
    /// By a pair of factors that has a loop of its own.
    Packed(u32),
    /// By any factors and equation.
    Any,
}

impl Builder<'_> {
    /// Which blending there is.
    pub(super) fn blending(&mut self) -> Option<Blending> {
        let general = self.options.general;
        let c = &self.state.color_buffer;
        let blend = BlendUniforms {
            src: c.blend_src,
            dst: c.blend_dst,
            equation: c.blend_equation,
            color: c.blend_color.map(clamp01),
        };
        let off = BlendUniforms { src: [BlendFactor::One; 2], dst: [BlendFactor::Zero; 2], ..BlendUniforms::default() };
        let copies = blend.equation == BlendEquation::Add && blend.src == off.src && blend.dst == off.dst;
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
                return Some(pair.map_or(Blending::Any, Blending::Packed));
            }
        };
        self.decide("blending", if general { Fate::Kept } else { Fate::LeftOut }, reason);
        self.program.uniforms.blend = off;
        general.then_some(Blending::Any)
    }

    /// Which logic op there is.
    pub(super) fn logic_op(&mut self) -> Option<LogicOp> {
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

    /// Blending, logic op, mask and store.
    pub(super) fn store(&mut self, packed: bool, blend: Option<Blending>, logic_op: Option<LogicOp>) {
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
        let between = logic_op.is_some() || masked || self.options.general;
        match blend {
            Some(Blending::Packed(pair)) if !between => {
                self.push(&BLEND_STORE, pair);
                self.decide("store", Fate::Hoisted, "with blending: pixels are read, blended and written at once");
                return;
            }
            None if !between && !packed => {
                self.push(&pack::PACK_STORE, 0);
                self.decide("store", Fate::Hoisted, "with rounding to the nearest; dithering is rounding");
                return;
            }
            _ => {}
        }
        if blend.is_none() && !between && self.env_store() {
            self.decide("store", Fate::Hoisted, "with the last environment: what it gives is written at once");
            return;
        }
        if blend.is_some() || between {
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
            self.push(&logic_op::LOGIC_OP, op as u32);
        }
        if masked || self.options.general {
            self.push(&pack::COLOR_MASK, 0);
        }
        self.push(&pack::STORE, 0);
        self.decide("store", Fate::Kept, "rounded to the nearest; dithering is rounding");
    }

    /// Lets the last environment store its pixels itself, if it is the last stage; says whether it is so.
    fn env_store(&mut self) -> bool {
        match self.program.actions.last() {
            Some(Action::Stage(step)) if step.is(&env_pack::ENV_PACK) => {
                let arg = step.arg;
                self.program.actions.pop();
                self.push(&env_pack::ENV_STORE, arg);
                true
            }
            _ => false,
        }
    }
}
