//! Projections and the camera (GLU 1.3, chapter 4). Each function makes a matrix and multiplies the current one by it.
//!
//! The matrices are `f64` in GL's order (column by column); the angle of a perspective is reduced in degrees, so that 90
//! gives exactly 1. Arguments that make no matrix (a view of no depth, no aspect, a pick region of no size) leave the
//! current matrix as it is, as GLU does.

use crate::context::Context;
use crate::num::sin_cos_deg;

/// A matrix column by column.
pub type Matrix = [f64; 16];

/// The unit matrix.
pub const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// The matrix of a symmetric view volume: `fovy` degrees high, `aspect` times as wide. `None` where there is none.
#[must_use]
pub fn perspective_matrix(fovy: f64, aspect: f64, near: f64, far: f64) -> Option<Matrix> {
    let (sin, cos) = sin_cos_deg(fovy * 0.5);
    let depth = far - near;
    if sin == 0.0 || aspect == 0.0 || depth == 0.0 {
        return None;
    }
    let f = cos / sin;
    let mut m = [0.0; 16];
    m[0] = f / aspect;
    m[5] = f;
    m[10] = -(far + near) / depth;
    m[11] = -1.0;
    m[14] = -2.0 * near * far / depth;
    Some(m)
}

/// The matrix that takes `eye` to the origin, the way to `center` to -z and `up` into the plane of y and z. A direction
/// of no length stays of no length: the matrix is then singular, and nothing is visible.
#[must_use]
pub fn look_at_matrix(eye: [f64; 3], center: [f64; 3], up: [f64; 3]) -> Matrix {
    let forward = normalized([center[0] - eye[0], center[1] - eye[1], center[2] - eye[2]]);
    let side = normalized(cross(forward, up));
    let up = cross(side, forward);
    let mut m = IDENTITY;
    for i in 0..3 {
        m[i * 4] = side[i];
        m[i * 4 + 1] = up[i];
        m[i * 4 + 2] = -forward[i];
    }
    for row in 0..3 {
        m[12 + row] = -(m[row] * eye[0] + m[4 + row] * eye[1] + m[8 + row] * eye[2]);
    }
    m
}

/// The matrix that stretches the region `width` x `height` around the window position (`x`, `y`) over the whole
/// viewport. `None` for a region of no size.
#[must_use]
pub fn pick_matrix_matrix(x: f64, y: f64, width: f64, height: f64, viewport: &[i32; 4]) -> Option<Matrix> {
    if width <= 0.0 || height <= 0.0 {
        return None;
    }
    let [vx, vy, vw, vh] = viewport.map(f64::from);
    let mut m = IDENTITY;
    m[0] = vw / width;
    m[5] = vh / height;
    m[12] = (vw - 2.0 * (x - vx)) / width;
    m[13] = (vh - 2.0 * (y - vy)) / height;
    Some(m)
}

/// Multiplies the current matrix by a perspective projection (`gluPerspective`).
#[track_caller]
pub fn perspective(cx: &mut Context, fovy: f64, aspect: f64, near: f64, far: f64) {
    if let Some(m) = perspective_matrix(fovy, aspect, near, far) {
        cx.mult_matrixd(&m);
    } else {
        cx.advise_once(
            "gluPerspective",
            format!("nothing is done: there is no view of {fovy} degrees, aspect {aspect}, from {near} to {far}"),
        );
    }
    // GLU has no error for it: all depths become the same, or what is behind the eye is seen.
    if !(near > 0.0 && far > 0.0) {
        cx.advise_once(
            "gluPerspective",
            format!(
                "near is {near} and far is {far}: both must be positive, or no depth is right; use a near like 0.1"
            ),
        );
    }
}

/// Multiplies the current matrix by a parallel projection of depths -1 to 1 (`gluOrtho2D`).
#[track_caller]
pub fn ortho_2d(cx: &mut Context, left: f64, right: f64, bottom: f64, top: f64) {
    cx.ortho(left, right, bottom, top, -1.0, 1.0);
}

/// Multiplies the current matrix by a view from `eye` to `center` (`gluLookAt`).
#[track_caller]
pub fn look_at(cx: &mut Context, eye: [f64; 3], center: [f64; 3], up: [f64; 3]) {
    cx.mult_matrixd(&look_at_matrix(eye, center, up));
}

/// Multiplies the current matrix so that a small region of the viewport fills it, for picking (`gluPickMatrix`).
#[track_caller]
pub fn pick_matrix(cx: &mut Context, x: f64, y: f64, width: f64, height: f64, viewport: &[i32; 4]) {
    if let Some(m) = pick_matrix_matrix(x, y, width, height, viewport) {
        cx.mult_matrixd(&m);
    } else {
        cx.advise_once(
            "gluPickMatrix",
            format!("nothing is done: a region of {width} x {height} pixels; both must be positive"),
        );
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length == 0.0 { v } else { v.map(|c| c / length) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apply(m: &Matrix, v: [f64; 4]) -> [f64; 4] {
        std::array::from_fn(|r| (0..4).map(|c| m[c * 4 + r] * v[c]).sum())
    }

    #[test]
    fn a_right_angle_is_exact() {
        let m = perspective_matrix(90.0, 2.0, 1.0, 3.0).expect("a matrix");
        assert_eq!((m[0], m[5], m[10], m[11], m[14], m[15]), (0.5, 1.0, -2.0, -1.0, -3.0, 0.0));
        // The near and far planes go to -1 and 1, the upper edge of the near plane to y = 1.
        let [_, y, z, w] = apply(&m, [0.0, 1.0, -1.0, 1.0]);
        assert_eq!((y / w, z / w), (1.0, -1.0));
        let [.., z, w] = apply(&m, [0.0, 0.0, -3.0, 1.0]);
        assert_eq!(z / w, 1.0);
        assert_eq!(perspective_matrix(90.0, 0.0, 1.0, 3.0), None);
        assert_eq!(perspective_matrix(90.0, 1.0, 3.0, 3.0), None);
        assert_eq!(perspective_matrix(360.0, 1.0, 1.0, 3.0), None);
    }

    #[test]
    fn the_camera_looks_down_minus_z() {
        let m = look_at_matrix([3.0, 4.0, 5.0], [3.0, 4.0, -1.0], [0.0, 9.0, 0.0]);
        assert_eq!(apply(&m, [3.0, 4.0, 5.0, 1.0]), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(apply(&m, [4.0, 6.0, 2.0, 1.0]), [1.0, 2.0, -3.0, 1.0]);
        let m = look_at_matrix([10.0, 0.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
        assert_eq!(apply(&m, [0.0, 1.0, 2.0, 1.0]), [1.0, 2.0, -10.0, 1.0]);
        // No direction: finite, though singular.
        assert!(look_at_matrix([0.0; 3], [0.0; 3], [0.0; 3]).iter().all(|v| v.is_finite()));
    }

    #[test]
    fn a_pick_region_fills_the_volume() {
        let m = pick_matrix_matrix(60.0, 45.0, 4.0, 2.0, &[10, 20, 100, 50]).expect("a matrix");
        // Window (60, 45) is the middle of the viewport; two pixels right of it is the right edge of the region.
        assert_eq!(apply(&m, [0.0, 0.0, 0.5, 1.0]), [0.0, 0.0, 0.5, 1.0]);
        let [x, y, ..] = apply(&m, [2.0 / 50.0, 1.0 / 25.0, 0.0, 1.0]);
        assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
        assert_eq!(pick_matrix_matrix(0.0, 0.0, 0.0, 1.0, &[0, 0, 1, 1]), None);
    }
}
