//! The end of a program: blending, logic op, colour mask and the store.

use super::Builder;
use crate::enums::{GL_CLEAR, GL_COPY, GL_SET, Named};
use crate::fragment::program::{Action, Fate};
use crate::fragment::reference::blend::{BLEND, BLEND_PACKED, BLEND_STORE, Equation, Factor, packed_pair};
use crate::fragment::reference::{env_pack, float_store, logic_op, pack};
use crate::fragment::uniforms::BlendUniforms;
use crate::num::clamp01;

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
                let [src, dst] = [c.blend_src[0], c.blend_dst[0]].map(Named);
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

    /// The logic op's number.
    pub(super) fn logic_op(&mut self) -> Option<u32> {
        let c = &self.state.color_buffer;
        let general = self.options.general && !self.format.float;
        let on = c.logic_op_enabled && (GL_CLEAR..=GL_SET).contains(&c.logic_op);
        let reason = match (on, self.format.float, c.logic_op == GL_COPY) {
            (false, ..) => "GL_COLOR_LOGIC_OP is off",
            (_, true, _) => "floats have no bits to combine",
            (.., true) => "GL_COPY stores the fragment's colour",
            _ => {
                self.decide("logic op", Fate::Kept, format_args!("operation {}", Named(c.logic_op)));
                self.program.reads_framebuffer = true;
                return Some(c.logic_op - GL_CLEAR);
            }
        };
        self.decide("logic op", if general { Fate::Kept } else { Fate::LeftOut }, reason);
        general.then_some(GL_COPY - GL_CLEAR)
    }

    /// Blending, logic op, mask and store.
    pub(super) fn store(&mut self, packed: bool, blend: Option<Blending>, logic_op: Option<u32>) {
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
            self.push(&logic_op::LOGIC_OP, op);
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
