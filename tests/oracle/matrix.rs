//! Matrices (OpenGL 1.5, section 2.11.2) and the matrices of GLU. `M4(m)` holds rows: `m[r][c]`, and a vector is a column
//! that stands to the right of the matrix, as the specification writes it. GL's arrays of 16 numbers are columns, so they
//! come in through [`M4::from_gl`].

use super::{V3, V4, cross, dot, normalize, sub};

/// A 4 x 4 matrix, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct M4(pub [V4; 4]);

impl M4 {
    /// Ones on the diagonal.
    pub const IDENTITY: M4 =
        M4([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]);

    /// From the 16 numbers of LoadMatrix: a1..a4 are the first column.
    pub fn from_gl(a: [f64; 16]) -> M4 {
        M4(std::array::from_fn(|r| std::array::from_fn(|c| a[4 * c + r])))
    }

    /// The 16 numbers as GetDoublev returns them, column by column.
    pub fn to_gl(self) -> [f64; 16] {
        std::array::from_fn(|i| self.0[i % 4][i / 4])
    }

    /// Rows become columns.
    pub fn transpose(self) -> M4 {
        M4(std::array::from_fn(|r| std::array::from_fn(|c| self.0[c][r])))
    }

    /// self . m: what MultMatrix(m) makes of the current matrix.
    pub fn times(self, m: M4) -> M4 {
        M4(std::array::from_fn(|r| std::array::from_fn(|c| (0..4).map(|k| self.0[r][k] * m.0[k][c]).sum())))
    }

    /// self . v, v a column.
    pub fn apply(self, v: V4) -> V4 {
        std::array::from_fn(|r| dot(&self.0[r], &v))
    }

    /// v . self, v a row: how planes and normals are transformed (by the inverse).
    pub fn apply_row(self, v: V4) -> V4 {
        self.transpose().apply(v)
    }

    /// The inverse by Gauss-Jordan elimination with the largest pivot; nothing for a singular matrix.
    pub fn inverse(self) -> Option<M4> {
        let mut a = self.0;
        let mut b = M4::IDENTITY.0;
        for col in 0..4 {
            let pivot = (col..4).max_by(|&i, &j| a[i][col].abs().total_cmp(&a[j][col].abs()))?;
            if a[pivot][col] == 0.0 {
                return None;
            }
            a.swap(col, pivot);
            b.swap(col, pivot);
            let p = a[col][col];
            a[col] = a[col].map(|x| x / p);
            b[col] = b[col].map(|x| x / p);
            for row in (0..4).filter(|&r| r != col) {
                let f = a[row][col];
                a[row] = std::array::from_fn(|k| a[row][k] - f * a[col][k]);
                b[row] = std::array::from_fn(|k| b[row][k] - f * b[col][k]);
            }
        }
        Some(M4(b))
    }

    /// Translate(x, y, z).
    pub fn translation(x: f64, y: f64, z: f64) -> M4 {
        M4([[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]])
    }

    /// Scale(x, y, z).
    pub fn scaling(x: f64, y: f64, z: f64) -> M4 {
        M4([[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, z, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// Rotate(theta, x, y, z), theta in degrees: R = u u^T + cos theta (I - u u^T) + sin theta S.
    pub fn rotation(theta: f64, axis: V3) -> M4 {
        let u = normalize(axis);
        let (sin, cos) = theta.to_radians().sin_cos();
        let s = [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]];
        let mut m = M4::IDENTITY;
        for r in 0..3 {
            for c in 0..3 {
                let i = if r == c { 1.0 } else { 0.0 };
                let uu = u[r] * u[c];
                m.0[r][c] = uu + cos * (i - uu) + sin * s[r][c];
            }
        }
        m
    }

    /// Frustum(l, r, b, t, n, f).
    pub fn frustum(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> M4 {
        M4([
            [2.0 * n / (r - l), 0.0, (r + l) / (r - l), 0.0],
            [0.0, 2.0 * n / (t - b), (t + b) / (t - b), 0.0],
            [0.0, 0.0, -(f + n) / (f - n), -2.0 * f * n / (f - n)],
            [0.0, 0.0, -1.0, 0.0],
        ])
    }

    /// Ortho(l, r, b, t, n, f).
    pub fn ortho(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> M4 {
        M4([
            [2.0 / (r - l), 0.0, 0.0, -(r + l) / (r - l)],
            [0.0, 2.0 / (t - b), 0.0, -(t + b) / (t - b)],
            [0.0, 0.0, -2.0 / (f - n), -(f + n) / (f - n)],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// gluPerspective: a symmetric frustum from the vertical angle in degrees and width / height.
    pub fn perspective(fovy: f64, aspect: f64, n: f64, f: f64) -> M4 {
        let top = n * (fovy.to_radians() / 2.0).tan();
        M4::frustum(-top * aspect, top * aspect, -top, top, n, f)
    }

    /// gluLookAt: the eye at `eye`, looking at `centre`, `up` towards the top of the picture.
    pub fn look_at(eye: V3, centre: V3, up: V3) -> M4 {
        let f = normalize(sub(centre, eye));
        let s = normalize(cross(f, up));
        let u = cross(s, f);
        let turn =
            M4([[s[0], s[1], s[2], 0.0], [u[0], u[1], u[2], 0.0], [-f[0], -f[1], -f[2], 0.0], [0.0, 0.0, 0.0, 1.0]]);
        turn.times(M4::translation(-eye[0], -eye[1], -eye[2]))
    }

    /// gluPickMatrix: the part of the viewport around (x, y) fills the clip volume.
    pub fn pick(x: f64, y: f64, dx: f64, dy: f64, viewport: [f64; 4]) -> M4 {
        let [vx, vy, vw, vh] = viewport;
        let move_it = M4::translation((vw - 2.0 * (x - vx)) / dx, (vh - 2.0 * (y - vy)) / dy, 0.0);
        move_it.times(M4::scaling(vw / dx, vh / dy, 1.0))
    }
}

/// gluProject: object coordinates to window coordinates (depth range 0 to 1).
pub fn project(object: V3, model: M4, projection: M4, viewport: [f64; 4]) -> Option<V3> {
    let clip = projection.apply(model.apply([object[0], object[1], object[2], 1.0]));
    if clip[3] == 0.0 {
        return None;
    }
    let ndc: V3 = std::array::from_fn(|i| clip[i] / clip[3]);
    let [vx, vy, vw, vh] = viewport;
    Some([vx + vw * (ndc[0] + 1.0) / 2.0, vy + vh * (ndc[1] + 1.0) / 2.0, (ndc[2] + 1.0) / 2.0])
}

/// gluUnProject: the way back.
pub fn unproject(window: V3, model: M4, projection: M4, viewport: [f64; 4]) -> Option<V3> {
    let [vx, vy, vw, vh] = viewport;
    let ndc = [2.0 * (window[0] - vx) / vw - 1.0, 2.0 * (window[1] - vy) / vh - 1.0, 2.0 * window[2] - 1.0, 1.0];
    let object = projection.times(model).inverse()?.apply(ndc);
    (object[3] != 0.0).then(|| std::array::from_fn(|i| object[i] / object[3]))
}

#[cfg(test)]
mod tests {
    use super::super::assert_near;
    use super::*;

    fn near(a: M4, b: M4) {
        assert_near(&a.to_gl(), &b.to_gl(), 1e-12);
    }

    #[test]
    fn a_rotation_by_90_degrees_about_z_turns_x_into_y() {
        let m = M4::rotation(90.0, [0.0, 0.0, 2.0]);
        assert_near(&m.apply([1.0, 0.0, 0.0, 1.0]), &[0.0, 1.0, 0.0, 1.0], 1e-15);
        assert_near(&m.apply([0.0, 1.0, 0.0, 1.0]), &[-1.0, 0.0, 0.0, 1.0], 1e-15);
        let diagonal = M4::rotation(120.0, [1.0, 1.0, 1.0]);
        assert_near(&diagonal.apply([1.0, 2.0, 3.0, 1.0]), &[3.0, 1.0, 2.0, 1.0], 1e-14);
    }

    #[test]
    fn gl_arrays_are_columns() {
        let a: [f64; 16] = std::array::from_fn(|i| i as f64);
        let m = M4::from_gl(a);
        assert_eq!(m.0[0], [0.0, 4.0, 8.0, 12.0]);
        assert_eq!(m.to_gl(), a);
        assert_eq!(m.transpose().0[0], [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(M4::translation(1.0, 2.0, 3.0).to_gl()[12..15], [1.0, 2.0, 3.0]);
    }

    #[test]
    fn frustum_sends_the_near_corner_to_the_corner_of_the_volume() {
        let m = M4::frustum(-1.0, 3.0, -2.0, 2.0, 1.0, 9.0);
        assert_near(&m.apply([3.0, 2.0, -1.0, 1.0]), &[1.0, 1.0, -1.0, 1.0], 1e-15);
        assert_near(&m.apply([-9.0, -18.0, -9.0, 1.0]), &[-9.0, -9.0, 9.0, 9.0], 1e-14);
        let o = M4::ortho(0.0, 4.0, 0.0, 2.0, -1.0, 1.0);
        assert_near(&o.apply([4.0, 1.0, 0.0, 1.0]), &[1.0, 0.0, 0.0, 1.0], 1e-15);
        near(M4::perspective(90.0, 2.0, 1.0, 3.0), M4::frustum(-2.0, 2.0, -1.0, 1.0, 1.0, 3.0));
    }

    #[test]
    fn an_inverse_undoes_its_matrix() {
        let m =
            M4::perspective(50.0, 1.3, 0.5, 20.0).times(M4::look_at([1.0, 2.0, 5.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
        near(m.times(m.inverse().unwrap()), M4::IDENTITY);
        assert_eq!(M4::scaling(1.0, 1.0, 0.0).inverse(), None);
        near(M4::scaling(2.0, 4.0, 8.0).inverse().unwrap(), M4::scaling(0.5, 0.25, 0.125));
    }

    #[test]
    fn look_at_puts_the_centre_on_the_negative_z_axis() {
        let m = M4::look_at([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        near(m, M4::translation(0.0, 0.0, -5.0));
        let side = M4::look_at([3.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        assert_near(&side.apply([0.0, 0.0, 0.0, 1.0]), &[0.0, 0.0, -3.0, 1.0], 1e-15);
        assert_near(&side.apply([3.0, 0.0, -1.0, 1.0]), &[1.0, 0.0, 0.0, 1.0], 1e-15);
    }

    #[test]
    fn project_and_unproject_are_inverse() {
        let p = M4::perspective(60.0, 1.0, 1.0, 10.0);
        let m = M4::translation(0.0, 0.0, -4.0);
        let view = [0.0, 0.0, 100.0, 100.0];
        let w = project([0.0, 0.0, 0.0], m, p, view).unwrap();
        assert_near(&w[..2], &[50.0, 50.0], 1e-12);
        let back = unproject(project([0.3, -0.4, 0.5], m, p, view).unwrap(), m, p, view).unwrap();
        assert_near(&back, &[0.3, -0.4, 0.5], 1e-12);
        let pick = M4::pick(25.0, 75.0, 50.0, 50.0, view);
        assert_near(&pick.apply([-0.5, 0.5, 0.0, 1.0]), &[0.0, 0.0, 0.0, 1.0], 1e-15);
    }
}
