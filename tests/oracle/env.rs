//! The texture environment (OpenGL 1.5, section 3.8.13): what a unit makes of the fragment's colour and the texture's
//! value. Tables 3.22 and 3.23 for REPLACE, MODULATE, DECAL, BLEND and ADD, by base internal format; table 3.24 for
//! COMBINE with its sources, operands, scales, the crossbar and DOT3. Colours come in and go out limited to [0, 1].

use super::{V3, V4, clamp01};
use fixedgl::enums::*;

/// One argument of a combine function.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// GL_TEXTURE, GL_TEXTUREn, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS or GL_ZERO.
    pub source: GLenum,
    /// GL_SRC_COLOR .. GL_ONE_MINUS_SRC_ALPHA.
    pub operand: GLenum,
}

/// The COMBINE state of a unit.
#[derive(Clone, Copy, Debug)]
pub struct Combine {
    pub rgb: GLenum,
    pub alpha: GLenum,
    /// The fourth argument is read by GL_COMBINE4_NV only.
    pub rgb_args: [Argument; 4],
    pub alpha_args: [Argument; 4],
    pub rgb_scale: f64,
    pub alpha_scale: f64,
}

impl Default for Combine {
    fn default() -> Self {
        let arg = |source, operand| Argument { source, operand };
        Combine {
            rgb: GL_MODULATE,
            alpha: GL_MODULATE,
            rgb_args: [
                arg(GL_TEXTURE, GL_SRC_COLOR),
                arg(GL_PREVIOUS, GL_SRC_COLOR),
                arg(GL_CONSTANT, GL_SRC_ALPHA),
                arg(GL_ZERO, GL_ONE_MINUS_SRC_COLOR),
            ],
            alpha_args: [
                arg(GL_TEXTURE, GL_SRC_ALPHA),
                arg(GL_PREVIOUS, GL_SRC_ALPHA),
                arg(GL_CONSTANT, GL_SRC_ALPHA),
                arg(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA),
            ],
            rgb_scale: 1.0,
            alpha_scale: 1.0,
        }
    }
}

/// The environment of one unit.
#[derive(Clone, Copy, Debug)]
pub struct Env {
    pub mode: GLenum,
    /// TEXTURE_ENV_COLOR.
    pub color: V4,
    pub combine: Combine,
}

impl Default for Env {
    fn default() -> Self {
        Env { mode: GL_MODULATE, color: [0.0; 4], combine: Combine::default() }
    }
}

/// What the environment of a unit can see: its own texture, all units' textures (the crossbar), the colours.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a> {
    /// This unit's texture colour, expanded to RGBA, and its base format.
    pub texture: V4,
    pub base_format: GLenum,
    /// The texture colours of all units.
    pub textures: &'a [V4],
    pub primary: V4,
    pub previous: V4,
}

impl Env {
    /// The colour that leaves the unit.
    pub fn apply(&self, i: &Inputs<'_>) -> V4 {
        if matches!(self.mode, GL_COMBINE | GL_COMBINE4_NV) {
            return self.combine(i);
        }
        let (cp, ap) = ([i.previous[0], i.previous[1], i.previous[2]], i.previous[3]);
        let (cs, as_) = ([i.texture[0], i.texture[1], i.texture[2]], i.texture[3]);
        let (cc, ac) = ([self.color[0], self.color[1], self.color[2]], self.color[3]);
        let each = |f: &dyn Fn(usize) -> f64| -> V3 { std::array::from_fn(f) };
        let product = each(&|k| cp[k] * cs[k]);
        let blend = each(&|k| cp[k] * (1.0 - cs[k]) + cc[k] * cs[k]);
        let sum = each(&|k| cp[k] + cs[k]);
        let decal = each(&|k| cp[k] * (1.0 - as_) + cs[k] * as_);
        let (c, a) = match (self.mode, i.base_format) {
            (GL_REPLACE, GL_ALPHA) => (cp, as_),
            (GL_REPLACE, GL_LUMINANCE | GL_RGB) => (cs, ap),
            (GL_REPLACE, GL_LUMINANCE_ALPHA | GL_INTENSITY | GL_RGBA) => (cs, as_),
            (GL_MODULATE, GL_ALPHA) => (cp, ap * as_),
            (GL_MODULATE, GL_LUMINANCE | GL_RGB) => (product, ap),
            (GL_MODULATE, GL_LUMINANCE_ALPHA | GL_INTENSITY | GL_RGBA) => (product, ap * as_),
            (GL_DECAL, GL_RGB) => (cs, ap),
            (GL_DECAL, GL_RGBA) => (decal, ap),
            (GL_BLEND, GL_ALPHA) => (cp, ap * as_),
            (GL_BLEND, GL_LUMINANCE | GL_RGB) => (blend, ap),
            (GL_BLEND, GL_LUMINANCE_ALPHA | GL_RGBA) => (blend, ap * as_),
            (GL_BLEND, GL_INTENSITY) => (blend, ap * (1.0 - as_) + ac * as_),
            (GL_ADD, GL_ALPHA) => (cp, ap * as_),
            (GL_ADD, GL_LUMINANCE | GL_RGB) => (sum, ap),
            (GL_ADD, GL_LUMINANCE_ALPHA | GL_RGBA) => (sum, ap * as_),
            (GL_ADD, GL_INTENSITY) => (sum, ap + as_),
            (mode, format) => panic!("mode {mode:#x} with format {format:#x} is undefined"),
        };
        clamp01([c[0], c[1], c[2], a])
    }

    fn source(&self, source: GLenum, i: &Inputs<'_>) -> V4 {
        match source {
            GL_TEXTURE => i.texture,
            GL_CONSTANT => self.color,
            GL_PRIMARY_COLOR => i.primary,
            GL_PREVIOUS => i.previous,
            GL_ZERO => [0.0; 4],
            unit => i.textures[(unit - GL_TEXTURE0) as usize],
        }
    }

    fn combine(&self, i: &Inputs<'_>) -> V4 {
        let c = &self.combine;
        let rgb: [V3; 4] = c.rgb_args.map(|arg| {
            let s = self.source(arg.source, i);
            std::array::from_fn(|k| match arg.operand {
                GL_SRC_COLOR => s[k],
                GL_ONE_MINUS_SRC_COLOR => 1.0 - s[k],
                GL_SRC_ALPHA => s[3],
                _ => 1.0 - s[3],
            })
        });
        let alpha = c.alpha_args.map(|arg| {
            let s = self.source(arg.source, i);
            if arg.operand == GL_SRC_ALPHA { s[3] } else { 1.0 - s[3] }
        });
        let four = self.mode == GL_COMBINE4_NV;
        let function = |f: GLenum, a: [f64; 4]| match f {
            GL_ADD if four => a[0] * a[1] + a[2] * a[3],
            GL_ADD_SIGNED if four => a[0] * a[1] + a[2] * a[3] - 0.5,
            GL_REPLACE => a[0],
            GL_MODULATE => a[0] * a[1],
            GL_ADD => a[0] + a[1],
            GL_ADD_SIGNED => a[0] + a[1] - 0.5,
            GL_INTERPOLATE => a[0] * a[2] + a[1] * (1.0 - a[2]),
            GL_SUBTRACT => a[0] - a[1],
            other => panic!("the oracle has no combine function {other:#x}"),
        };
        let dot3 = 4.0 * (0..3).map(|k| (rgb[0][k] - 0.5) * (rgb[1][k] - 0.5)).sum::<f64>();
        let color: V3 = match c.rgb {
            GL_DOT3_RGB | GL_DOT3_RGBA => [dot3; 3],
            f => std::array::from_fn(|k| function(f, [rgb[0][k], rgb[1][k], rgb[2][k], rgb[3][k]])),
        };
        let a = if c.rgb == GL_DOT3_RGBA { dot3 } else { function(c.alpha, alpha) };
        let color = color.map(|x| x * c.rgb_scale);
        clamp01([color[0], color[1], color[2], a * c.alpha_scale])
    }
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    fn inputs(format: GLenum, texture: V4) -> Inputs<'static> {
        let previous = [0.5, 0.25, 1.0, 0.5];
        Inputs { texture, base_format: format, textures: &[], primary: [0.1, 0.2, 0.3, 0.4], previous }
    }

    #[test]
    fn the_table_is_that_worked_out_by_hand() {
        let env = |mode| Env { mode, color: [1.0, 0.0, 0.5, 0.75], ..Env::default() };
        let rgba = inputs(GL_RGBA, [0.2, 0.4, 0.6, 0.5]);
        assert_near(&env(GL_REPLACE).apply(&rgba), &[0.2, 0.4, 0.6, 0.5], 1e-15);
        assert_near(&env(GL_MODULATE).apply(&rgba), &[0.1, 0.1, 0.6, 0.25], 1e-15);
        assert_near(&env(GL_DECAL).apply(&rgba), &[0.35, 0.325, 0.8, 0.5], 1e-15);
        assert_near(&env(GL_BLEND).apply(&rgba), &[0.6, 0.15, 0.7, 0.25], 1e-15);
        assert_near(&env(GL_ADD).apply(&rgba), &[0.7, 0.65, 1.0, 0.25], 1e-15);
        let alpha = inputs(GL_ALPHA, [0.0, 0.0, 0.0, 0.5]);
        assert_near(&env(GL_REPLACE).apply(&alpha), &[0.5, 0.25, 1.0, 0.5], 1e-15);
        assert_near(&env(GL_ADD).apply(&alpha), &[0.5, 0.25, 1.0, 0.25], 1e-15);
        let intensity = inputs(GL_INTENSITY, [0.5; 4]);
        assert_near(&env(GL_BLEND).apply(&intensity), &[0.75, 0.125, 0.75, 0.625], 1e-15);
        assert_near(&env(GL_ADD).apply(&intensity), &[1.0, 0.75, 1.0, 1.0], 1e-15);
        let luminance = inputs(GL_LUMINANCE, [0.5, 0.5, 0.5, 1.0]);
        assert_near(&env(GL_MODULATE).apply(&luminance), &[0.25, 0.125, 0.5, 0.5], 1e-15);
    }

    #[test]
    fn combine_functions_are_those_worked_out_by_hand() {
        let i = inputs(GL_RGBA, [0.75, 0.5, 0.0, 0.25]);
        let run = |rgb, scale| {
            let combine = Combine { rgb, alpha: GL_REPLACE, rgb_scale: scale, ..Combine::default() };
            Env { mode: GL_COMBINE, color: [0.0, 0.0, 0.0, 0.5], combine }.apply(&i)
        };
        assert_near(&run(GL_REPLACE, 1.0), &[0.75, 0.5, 0.0, 0.25], 1e-15);
        assert_near(&run(GL_MODULATE, 2.0), &[0.75, 0.25, 0.0, 0.25], 1e-15);
        assert_near(&run(GL_ADD_SIGNED, 1.0), &[0.75, 0.25, 0.5, 0.25], 1e-15);
        assert_near(&run(GL_INTERPOLATE, 1.0), &[0.625, 0.375, 0.5, 0.25], 1e-15);
        assert_near(&run(GL_SUBTRACT, 4.0), &[1.0, 1.0, 0.0, 0.25], 1e-15);
        // 4 (0.25 * 0 + 0 * -0.25 + -0.5 * 0.5) = -1, limited to 0.
        assert_near(&run(GL_DOT3_RGB, 1.0), &[0.0, 0.0, 0.0, 0.25], 1e-15);
    }

    #[test]
    fn the_crossbar_and_operands_choose_arguments() {
        let mut i = inputs(GL_RGBA, [0.75, 0.5, 0.0, 0.25]);
        let textures = [[0.1; 4], [0.2, 0.3, 0.4, 0.5]];
        i.textures = &textures;
        let mut combine = Combine { rgb: GL_REPLACE, alpha: GL_REPLACE, ..Combine::default() };
        combine.rgb_args[0] = Argument { source: GL_TEXTURE1, operand: GL_ONE_MINUS_SRC_COLOR };
        combine.alpha_args[0] = Argument { source: GL_PRIMARY_COLOR, operand: GL_ONE_MINUS_SRC_ALPHA };
        let env = Env { mode: GL_COMBINE, combine, ..Env::default() };
        assert_near(&env.apply(&i), &[0.8, 0.7, 0.6, 0.6], 1e-15);
        let normal = inputs(GL_RGB, [1.0, 0.5, 0.5, 1.0]);
        let combine = Combine { rgb: GL_DOT3_RGBA, ..Combine::default() };
        let env = Env { mode: GL_COMBINE, combine, ..Env::default() };
        let i = Inputs { previous: [0.75, 0.5, 0.5, 0.0], ..normal };
        assert_near(&env.apply(&i), &[0.5; 4], 1e-15);
    }
}
