//! The end of a program: blending, logic op, colour mask and the store.

use super::Builder;
use crate::fragment::key::{Blending, ColorWrites, FragmentKey};
use crate::fragment::program::{Action, Fate};
use crate::fragment::reference::blend::{BLEND, BLEND_PACKED, BLEND_STORE};
use crate::fragment::reference::{env_pack, float_store, logic_op, pack};

impl Builder<'_> {
    /// Blending, logic op, mask and store.
    pub(super) fn store(&mut self, key: &FragmentKey) {
        let FragmentKey { blend, logic_op, colors, general, .. } = *key;
        if key.is_plain() && key.stores_at_once() {
            return self.decide("store", Fate::Hoisted, "with the colour, since no test can kill a fragment");
        }
        if colors == ColorWrites::Nothing {
            return;
        }
        let packed = key.is_plain() || self.packed;
        let masked = colors == ColorWrites::Masked;
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
        let between = logic_op.is_some() || masked || general;
        match blend {
            Some(Blending::Pair(pair)) if !between => {
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
            Some(Blending::Pair(pair)) => self.push(&BLEND_PACKED, pair),
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
        if masked || general {
            self.push(&pack::COLOR_MASK, 0);
        }
        self.push(&pack::STORE, 0);
        self.decide("store", Fate::Kept, "rounded to the nearest; dithering is rounding");
    }

    /// Lets the last environment store its pixels itself, if it is the last stage; says whether it is so.
    fn env_store(&mut self) -> bool {
        match self.program.reference.last() {
            Some(Action::Stage(step)) if step.is(&env_pack::ENV_PACK) => {
                let arg = step.arg;
                self.program.reference.pop();
                self.push(&env_pack::ENV_STORE, arg);
                true
            }
            _ => false,
        }
    }
}
