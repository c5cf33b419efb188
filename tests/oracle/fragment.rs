//! What happens to a fragment after its texture units (OpenGL 1.5, sections 3.9, 3.10 and 4.1): colour sum, fog, alpha
//! test, depth test, blending, logic operation and the conversion to an 8-bit frame buffer. Colours are RGBA in [0, 1].

use super::{V4, add, clamp01, mul, scale, sub};
use fixedgl::enums::*;

/// Table of the fog state (3.10).
#[derive(Clone, Copy, Debug)]
pub struct Fog {
    pub mode: GLenum,
    pub density: f64,
    pub start: f64,
    pub end: f64,
    pub color: V4,
}

impl Default for Fog {
    fn default() -> Self {
        Fog { mode: GL_EXP, density: 1.0, start: 0.0, end: 1.0, color: [0.0; 4] }
    }
}

impl Fog {
    /// The blending factor f of equations 3.27 to 3.29 at eye distance (or fog coordinate) c.
    pub fn factor(&self, c: f64) -> f64 {
        let f = match self.mode {
            GL_EXP => (-self.density * c).exp(),
            GL_EXP2 => (-(self.density * c).powi(2)).exp(),
            _ => (self.end - c) / (self.end - self.start),
        };
        f.clamp(0.0, 1.0)
    }

    /// C = f Cr + (1 - f) Cf; alpha is not changed.
    pub fn apply(&self, color: V4, c: f64) -> V4 {
        let f = self.factor(c);
        let mixed = |k: usize| f * color[k] + (1.0 - f) * self.color[k];
        [mixed(0), mixed(1), mixed(2), color[3]]
    }
}

/// Colour sum (3.9): R, G and B of the secondary colour are added.
pub fn color_sum(primary: V4, secondary: V4) -> V4 {
    clamp01([primary[0] + secondary[0], primary[1] + secondary[1], primary[2] + secondary[2], primary[3]])
}

/// One of the eight comparison functions: `a` is the incoming value, `b` the reference or the stored one.
pub fn passes(func: GLenum, a: f64, b: f64) -> bool {
    match func {
        GL_NEVER => false,
        GL_ALWAYS => true,
        GL_LESS => a < b,
        GL_LEQUAL => a <= b,
        GL_EQUAL => a == b,
        GL_GEQUAL => a >= b,
        GL_GREATER => a > b,
        GL_NOTEQUAL => a != b,
        other => panic!("the oracle has no comparison {other:#x}"),
    }
}

/// The blending state (4.1.8). RGB first, alpha second.
#[derive(Clone, Copy, Debug)]
pub struct Blend {
    pub equation: [GLenum; 2],
    pub source: [GLenum; 2],
    pub destination: [GLenum; 2],
    pub constant: V4,
}

impl Default for Blend {
    fn default() -> Self {
        Blend { equation: [GL_FUNC_ADD; 2], source: [GL_ONE; 2], destination: [GL_ZERO; 2], constant: [0.0; 4] }
    }
}

impl Blend {
    /// BlendFunc(source, destination).
    pub fn func(source: GLenum, destination: GLenum) -> Blend {
        Blend { source: [source; 2], destination: [destination; 2], ..Blend::default() }
    }

    /// Tables 4.2 and 4.3: the weights of one factor.
    fn factor(&self, factor: GLenum, s: V4, d: V4) -> V4 {
        let one = [1.0; 4];
        match factor {
            GL_ZERO => [0.0; 4],
            GL_ONE => one,
            GL_SRC_COLOR => s,
            GL_ONE_MINUS_SRC_COLOR => sub(one, s),
            GL_DST_COLOR => d,
            GL_ONE_MINUS_DST_COLOR => sub(one, d),
            GL_SRC_ALPHA => [s[3]; 4],
            GL_ONE_MINUS_SRC_ALPHA => [1.0 - s[3]; 4],
            GL_DST_ALPHA => [d[3]; 4],
            GL_ONE_MINUS_DST_ALPHA => [1.0 - d[3]; 4],
            GL_CONSTANT_COLOR => self.constant,
            GL_ONE_MINUS_CONSTANT_COLOR => sub(one, self.constant),
            GL_CONSTANT_ALPHA => [self.constant[3]; 4],
            GL_ONE_MINUS_CONSTANT_ALPHA => [1.0 - self.constant[3]; 4],
            GL_SRC_ALPHA_SATURATE => {
                let f = s[3].min(1.0 - d[3]);
                [f, f, f, 1.0]
            }
            other => panic!("the oracle has no blend factor {other:#x}"),
        }
    }

    /// The blended colour, limited to [0, 1].
    pub fn apply(&self, s: V4, d: V4) -> V4 {
        let weights = |factors: [GLenum; 2]| {
            let (rgb, alpha) = (self.factor(factors[0], s, d), self.factor(factors[1], s, d));
            [rgb[0], rgb[1], rgb[2], alpha[3]]
        };
        let (ws, wd) = (mul(s, weights(self.source)), mul(d, weights(self.destination)));
        let [rgb, alpha] = self.equation.map(|equation| match equation {
            GL_FUNC_ADD => add(ws, wd),
            GL_FUNC_SUBTRACT => sub(ws, wd),
            GL_FUNC_REVERSE_SUBTRACT => sub(wd, ws),
            GL_MIN => std::array::from_fn(|k| s[k].min(d[k])),
            GL_MAX => std::array::from_fn(|k| s[k].max(d[k])),
            other => panic!("the oracle has no blend equation {other:#x}"),
        });
        clamp01([rgb[0], rgb[1], rgb[2], alpha[3]])
    }
}

/// Logical operation on the bits of two 8-bit values (table 4.4).
pub fn logic_op(op: GLenum, s: u8, d: u8) -> u8 {
    match op {
        GL_CLEAR => 0,
        GL_AND => s & d,
        GL_AND_REVERSE => s & !d,
        GL_COPY => s,
        GL_AND_INVERTED => !s & d,
        GL_NOOP => d,
        GL_XOR => s ^ d,
        GL_OR => s | d,
        GL_NOR => !(s | d),
        GL_EQUIV => !(s ^ d),
        GL_INVERT => !d,
        GL_OR_REVERSE => s | !d,
        GL_COPY_INVERTED => !s,
        GL_OR_INVERTED => !s | d,
        GL_NAND => !(s & d),
        GL_SET => 0xFF,
        other => panic!("the oracle has no logic operation {other:#x}"),
    }
}

/// Conversion to 8 bits: the nearest of c / 255 (2.14.9).
pub fn to_byte(c: f64) -> u8 {
    (c.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// The colour as an 8-bit frame buffer keeps it, in [0, 1] again.
pub fn stored(c: V4) -> V4 {
    scale(c.map(|x| f64::from(to_byte(x))), 1.0 / 255.0)
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    #[test]
    fn fog_factors_follow_the_equations() {
        let linear = Fog { mode: GL_LINEAR, start: 2.0, end: 10.0, color: [1.0, 0.0, 0.0, 0.0], ..Fog::default() };
        assert_near(&[linear.factor(4.0), linear.factor(1.0), linear.factor(11.0)], &[0.75, 1.0, 0.0], 1e-15);
        assert_near(&linear.apply([0.0, 1.0, 0.5, 0.3], 4.0), &[0.25, 0.75, 0.375, 0.3], 1e-15);
        let exp = Fog { density: 0.5, ..Fog::default() };
        assert_near(&[exp.factor(2.0)], &[1.0 / std::f64::consts::E], 1e-15);
        assert_near(&[Fog { mode: GL_EXP2, ..exp }.factor(4.0)], &[(-4.0f64).exp()], 1e-15);
    }

    #[test]
    fn blending_is_that_worked_out_by_hand() {
        let (s, d) = ([0.8, 0.4, 0.0, 0.5], [0.2, 0.4, 0.6, 0.75]);
        let over = Blend::func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        assert_near(&over.apply(s, d), &[0.5, 0.4, 0.3, 0.625], 1e-15);
        let saturate = Blend::func(GL_SRC_ALPHA_SATURATE, GL_ONE);
        assert_near(&saturate.apply(s, d), &[0.4, 0.5, 0.6, 1.0], 1e-15);
        let back = Blend { equation: [GL_FUNC_REVERSE_SUBTRACT; 2], ..Blend::func(GL_ONE, GL_ONE) };
        assert_near(&back.apply(s, d), &[0.0, 0.0, 0.6, 0.25], 1e-15);
        let min = Blend { equation: [GL_MIN; 2], ..Blend::func(GL_ZERO, GL_ZERO) };
        assert_near(&min.apply(s, d), &[0.2, 0.4, 0.0, 0.5], 1e-15);
        let apart = Blend { source: [GL_DST_COLOR, GL_ZERO], destination: [GL_ZERO, GL_ONE], ..Blend::default() };
        assert_near(&apart.apply(s, d), &[0.16, 0.16, 0.0, 0.75], 1e-15);
        let constant =
            Blend { constant: [0.5, 0.25, 1.0, 0.5], ..Blend::func(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA) };
        assert_near(&constant.apply(s, d), &[0.5, 0.3, 0.3, 0.625], 1e-15);
    }

    #[test]
    fn bits_and_bytes_are_those_of_the_tables() {
        assert_eq!([to_byte(0.5), to_byte(-1.0), to_byte(7.0), to_byte(0.1)], [128, 0, 255, 26]);
        assert_eq!(logic_op(GL_XOR, 0b1100, 0b1010), 0b0110);
        assert_eq!(logic_op(GL_AND_REVERSE, 0b1100, 0b1010), 0b0100);
        assert_eq!(logic_op(GL_EQUIV, 0b1100, 0b1010), 0b1111_1001);
        assert_near(&color_sum([0.5, 0.5, 0.5, 0.5], [0.25, 0.75, 0.0, 1.0]), &[0.75, 1.0, 0.5, 0.5], 1e-15);
        assert!(passes(GL_LESS, 0.1, 0.2) && passes(GL_GEQUAL, 0.2, 0.2) && !passes(GL_NOTEQUAL, 0.2, 0.2));
    }
}
