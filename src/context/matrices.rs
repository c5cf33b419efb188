//! Matrix commands (OpenGL 1.5, section 2.11.2): the current matrix of the current mode, in f64. A matrix is given column
//! by column; every command but Load multiplies from the right, as the specification writes it.

use super::engine::Engine;
use crate::enums::GLenum;
use crate::error::{Outcome, invalid_value, known, stack_overflow, stack_underflow};
use crate::num;
use crate::state::Dirty;
use crate::state::transform::{MatrixMode, MatrixStack};
use glam::DMat4;

impl Engine {
    pub(crate) fn matrix_mode(&mut self, mode: GLenum) -> Outcome {
        let what = "a matrix mode; use GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE or GL_COLOR";
        self.state.transform.matrix_mode = known(MatrixMode::from_gl(mode), mode, what)?;
        Ok(())
    }

    /// The stack that the matrix commands address.
    pub(crate) fn current_stack(&mut self) -> &mut MatrixStack {
        let transform = &mut self.state.transform;
        match transform.matrix_mode {
            MatrixMode::Modelview => &mut transform.modelview,
            MatrixMode::Projection => &mut transform.projection,
            MatrixMode::Texture => &mut transform.texture[self.state.texture.active],
            MatrixMode::Color => &mut transform.color,
        }
    }

    fn change_matrix(&mut self, change: impl FnOnce(DMat4) -> DMat4) {
        let top = self.current_stack().top_mut();
        *top = change(*top);
        self.matrix_changed();
    }

    /// A texture matrix may bring a q that is not 1, which the fragment plan must know.
    fn matrix_changed(&mut self) {
        let texture = self.state.transform.matrix_mode == MatrixMode::Texture;
        self.dirty.add(Dirty { vertex: true, fragment: texture, raster: false });
    }

    pub(crate) fn load_identity(&mut self) {
        self.change_matrix(|_| DMat4::IDENTITY);
    }

    pub(crate) fn load_matrix(&mut self, m: &[f64; 16]) {
        self.change_matrix(|_| DMat4::from_cols_array(m));
    }

    pub(crate) fn mult_matrix(&mut self, m: &[f64; 16]) {
        self.change_matrix(|top| top * DMat4::from_cols_array(m));
    }

    /// A rotation by degrees about an axis, which need not be of unit length; the zero axis rotates nothing.
    pub(crate) fn rotate(&mut self, degrees: f64, x: f64, y: f64, z: f64) {
        let length = (x * x + y * y + z * z).sqrt();
        if length > 0.0 && length.is_finite() {
            let rotation = rotation(degrees, [x / length, y / length, z / length]);
            self.change_matrix(|top| top * rotation);
        }
    }

    pub(crate) fn scale(&mut self, x: f64, y: f64, z: f64) {
        self.change_matrix(|top| DMat4::from_cols(top.x_axis * x, top.y_axis * y, top.z_axis * z, top.w_axis));
    }

    pub(crate) fn translate(&mut self, x: f64, y: f64, z: f64) {
        self.change_matrix(|top| {
            let w = top.x_axis * x + top.y_axis * y + top.z_axis * z + top.w_axis;
            DMat4::from_cols(top.x_axis, top.y_axis, top.z_axis, w)
        });
    }

    pub(crate) fn frustum(&mut self, l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Outcome {
        if n <= 0.0 || f <= 0.0 || l == r || b == t || n == f {
            return Err(invalid_value(format!(
                "a frustum with left {l}, right {r}, bottom {b}, top {t}, near {n}, far {f}: near and far must be \
                 positive, and no two opposite sides may be equal"
            )));
        }
        let m = DMat4::from_cols_array(&[
            2.0 * n / (r - l),
            0.0,
            0.0,
            0.0,
            0.0,
            2.0 * n / (t - b),
            0.0,
            0.0,
            (r + l) / (r - l),
            (t + b) / (t - b),
            -(f + n) / (f - n),
            -1.0,
            0.0,
            0.0,
            -2.0 * f * n / (f - n),
            0.0,
        ]);
        self.change_matrix(|top| top * m);
        Ok(())
    }

    pub(crate) fn ortho(&mut self, l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Outcome {
        if l == r || b == t || n == f {
            return Err(invalid_value(format!(
                "an orthographic volume with left {l}, right {r}, bottom {b}, top {t}, near {n}, far {f}: no two \
                 opposite sides may be equal"
            )));
        }
        let m = DMat4::from_cols_array(&[
            2.0 / (r - l),
            0.0,
            0.0,
            0.0,
            0.0,
            2.0 / (t - b),
            0.0,
            0.0,
            0.0,
            0.0,
            -2.0 / (f - n),
            0.0,
            -(r + l) / (r - l),
            -(t + b) / (t - b),
            -(f + n) / (f - n),
            1.0,
        ]);
        self.change_matrix(|top| top * m);
        Ok(())
    }

    pub(crate) fn push_matrix(&mut self) -> Outcome {
        let mode = self.state.transform.matrix_mode;
        let stack = self.current_stack();
        if stack.push() {
            return Ok(());
        }
        Err(stack_overflow(format!(
            "the {} stack is full: it holds {} matrices; pop one first",
            mode.name(),
            stack.limit
        )))
    }

    pub(crate) fn pop_matrix(&mut self) -> Outcome {
        let mode = self.state.transform.matrix_mode;
        if !self.current_stack().pop() {
            return Err(stack_underflow(format!(
                "the {} stack holds one matrix, which cannot be popped; every pop needs a push before it",
                mode.name()
            )));
        }
        self.matrix_changed();
        Ok(())
    }
}

/// Rotation by an angle in degrees about a unit axis (the formula of section 2.11.2).
fn rotation(degrees: f64, [x, y, z]: [f64; 3]) -> DMat4 {
    let (s, c) = num::sin_cos_deg(degrees);
    let k = 1.0 - c;
    DMat4::from_cols_array(&[
        x * x * k + c,
        y * x * k + z * s,
        z * x * k - y * s,
        0.0,
        x * y * k - z * s,
        y * y * k + c,
        z * y * k + x * s,
        0.0,
        x * z * k + y * s,
        y * z * k - x * s,
        z * z * k + c,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
    ])
}
