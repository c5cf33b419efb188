//! The accumulation buffer (OpenGL 1.5, section 4.2.4). It is allocated at its first use, since few programs use it. Values are
//! floats limited to [-1, 1] where the specification limits them, so that 64 frames of weight 1/64 lose nothing.

use super::clear::Rect;
use super::{Framebuffer, filled};
use crate::error::{Outcome, invalid_operation};
use crate::num::{clamp_f32, f32_to_u8, u8_to_f32};

/// The operations of `glAccum`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccumOp {
    /// `GL_ACCUM`: colours times the value are added to the buffer.
    Accumulate,
    /// `GL_LOAD`: colours times the value replace the buffer.
    Load,
    /// `GL_RETURN`: the buffer times the value goes to the colour buffer.
    Return,
    /// `GL_MULT`: the buffer is multiplied with the value.
    Multiply,
    /// `GL_ADD`: the value is added to the buffer.
    Add,
}

impl Framebuffer {
    /// The accumulation buffer, made now if this is the first use.
    fn accum_buffer(&mut self) -> Outcome<&mut Vec<[f32; 4]>> {
        if self.format.accum_bits == 0 {
            return Err(invalid_operation(
                "there is no accumulation buffer; make the context with accumulation bits to use glAccum",
            ));
        }
        if self.accum.is_empty() {
            let (a, b) = self.color.slices();
            let len = a.len().max(b.len());
            self.accum = filled(len, [0.0; 4], "accumulation")?;
        }
        Ok(&mut self.accum)
    }

    /// Sets the pixels of a rectangle of the accumulation buffer; nothing where there is none.
    pub(super) fn clear_accum(&mut self, value: [f32; 4], rect: Rect) -> Outcome {
        if self.format.accum_bits == 0 {
            return Ok(());
        }
        let value = value.map(|v| clamp_f32(v, -1.0, 1.0));
        let len = self.accum_buffer()?.len();
        for run in self.runs(rect, len) {
            if let Some(row) = self.accum.get_mut(run) {
                row.fill(value);
            }
        }
        Ok(())
    }

    /// `glAccum` on the pixels of a rectangle (the scissor box or the whole window). RETURN writes the colour channels
    /// that `mask` lets through.
    pub fn accumulate(&mut self, op: AccumOp, value: f32, rect: Rect, mask: [bool; 4]) -> Outcome {
        self.apply_deferred_clear();
        let len = self.accum_buffer()?.len();
        let no_alpha = self.format.color_bits[3] == 0;
        for run in self.runs(rect, len) {
            let Some(accum) = self.accum.get_mut(run.clone()) else { continue };
            let (packed, float) = self.color.slices_mut();
            let packed = packed.get_mut(run.clone()).unwrap_or_default();
            let float = float.get_mut(run).unwrap_or_default();
            match op {
                AccumOp::Multiply => accum.iter_mut().flatten().for_each(|a| *a = clamp_f32(*a * value, -1.0, 1.0)),
                AccumOp::Add => accum.iter_mut().flatten().for_each(|a| *a = clamp_f32(*a + value, -1.0, 1.0)),
                AccumOp::Accumulate | AccumOp::Load => {
                    let keep = if op == AccumOp::Load { 0.0 } else { 1.0 };
                    let add = |a: &mut [f32; 4], c: [f32; 4]| {
                        for k in 0..4 {
                            a[k] = a[k] * keep + c[k] * value;
                        }
                    };
                    accum.iter_mut().zip(packed).for_each(|(a, p)| add(a, p.to_le_bytes().map(u8_to_f32)));
                    accum.iter_mut().zip(float).for_each(|(a, c)| add(a, *c));
                }
                AccumOp::Return => {
                    let write = [mask[0], mask[1], mask[2], mask[3] && !no_alpha];
                    for (a, p) in accum.iter().zip(packed) {
                        let mut bytes = p.to_le_bytes();
                        for k in 0..4 {
                            if write[k] {
                                bytes[k] = f32_to_u8(a[k] * value);
                            }
                        }
                        *p = u32::from_le_bytes(bytes);
                    }
                    for (a, c) in accum.iter().zip(float) {
                        for k in 0..4 {
                            if write[k] {
                                c[k] = crate::num::clamp01(a[k] * value);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }
}
