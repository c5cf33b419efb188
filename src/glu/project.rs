//! From object to window coordinates and back (GLU 1.3, section 4.2; the viewport of OpenGL 1.5, section 2.11).
//!
//! Pure functions of the two matrices and the viewport: nothing is read from a context. `None` says that there is no
//! such point: w = 0, or matrices whose product has no inverse.

use super::matrices::Matrix;

/// Object coordinates to window coordinates (`gluProject`); depth 0 is near, 1 far.
#[must_use]
pub fn project(object: [f64; 3], model: &Matrix, projection: &Matrix, viewport: &[i32; 4]) -> Option<[f64; 3]> {
    let [x, y, z] = object;
    let [x, y, z, w] = transform(projection, transform(model, [x, y, z, 1.0]));
    if w == 0.0 {
        return None;
    }
    let [vx, vy, vw, vh] = viewport.map(f64::from);
    Some([vx + vw * (x / w * 0.5 + 0.5), vy + vh * (y / w * 0.5 + 0.5), z / w * 0.5 + 0.5])
}

/// Window coordinates to object coordinates (`gluUnProject`).
#[must_use]
pub fn un_project(window: [f64; 3], model: &Matrix, projection: &Matrix, viewport: &[i32; 4]) -> Option<[f64; 3]> {
    let [x, y, z, w] = un_project4(window, 1.0, model, projection, viewport, 0.0, 1.0)?;
    Some([x / w, y / w, z / w])
}

/// Window coordinates with the clip w and the depth range to homogeneous object coordinates (`gluUnProject4`).
#[must_use]
pub fn un_project4(
    window: [f64; 3],
    clip_w: f64,
    model: &Matrix,
    projection: &Matrix,
    viewport: &[i32; 4],
    near: f64,
    far: f64,
) -> Option<[f64; 4]> {
    let inverse = inverse(&product(projection, model))?;
    let [vx, vy, vw, vh] = viewport.map(f64::from);
    let unit = |v: f64, from: f64, size: f64| (v - from) / size * 2.0 - 1.0;
    let clip = [unit(window[0], vx, vw), unit(window[1], vy, vh), unit(window[2], near, far - near), clip_w];
    let point = transform(&inverse, clip);
    (point[3] != 0.0).then_some(point)
}

/// `m * v`.
fn transform(m: &Matrix, [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|r| m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r] * w)
}

/// `a * b`.
fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut m = [0.0; 16];
    for c in 0..4 {
        let column = transform(a, [b[c * 4], b[c * 4 + 1], b[c * 4 + 2], b[c * 4 + 3]]);
        m[c * 4..c * 4 + 4].copy_from_slice(&column);
    }
    m
}

/// The inverse, by elimination with the largest pivot of each column; `None` for a singular matrix.
fn inverse(m: &Matrix) -> Option<Matrix> {
    // Rows of the matrix with the rows of the unit matrix beside them.
    let mut rows: [[f64; 8]; 4] = std::array::from_fn(|r| {
        std::array::from_fn(|c| if c < 4 { m[c * 4 + r] } else { f64::from(u8::from(c - 4 == r)) })
    });
    for c in 0..4 {
        let pivot = (c..4).fold(c, |best, r| if rows[r][c].abs() > rows[best][c].abs() { r } else { best });
        rows.swap(c, pivot);
        let divisor = rows[c][c];
        if divisor == 0.0 || !divisor.is_finite() {
            return None;
        }
        for v in &mut rows[c] {
            *v /= divisor;
        }
        let pivot_row = rows[c];
        for (r, row) in rows.iter_mut().enumerate() {
            let factor = row[c];
            if r != c && factor != 0.0 {
                for (v, p) in row.iter_mut().zip(pivot_row) {
                    *v -= factor * p;
                }
            }
        }
    }
    Some(std::array::from_fn(|i| rows[i % 4][4 + i / 4]))
}

#[cfg(test)]
mod tests {
    use super::super::matrices::{IDENTITY, look_at_matrix, perspective_matrix};
    use super::*;

    const VIEWPORT: [i32; 4] = [0, 0, 100, 50];

    #[test]
    fn the_unit_cube_is_the_viewport() {
        let window = project([0.5, 0.25, 0.125], &IDENTITY, &IDENTITY, &VIEWPORT);
        assert_eq!(window, Some([75.0, 31.25, 0.5625]));
        assert_eq!(un_project([75.0, 31.25, 0.5625], &IDENTITY, &IDENTITY, &VIEWPORT), Some([0.5, 0.25, 0.125]));
        let deep = un_project4([50.0, 25.0, 0.5], 2.0, &IDENTITY, &IDENTITY, &VIEWPORT, 0.0, 1.0);
        assert_eq!(deep, Some([0.0, 0.0, 0.0, 2.0]));
        let deep = un_project4([60.0, 25.0, 0.75], 2.0, &IDENTITY, &IDENTITY, &VIEWPORT, 0.5, 1.0);
        let [x, rest @ ..] = deep.expect("a point");
        assert!((x - 0.2).abs() < 1e-15);
        assert_eq!(rest, [0.0, 0.0, 2.0]);
    }

    #[test]
    fn un_project_undoes_project() {
        let model = look_at_matrix([3.0, -2.0, 7.0], [0.5, 0.0, 0.0], [0.1, 1.0, 0.2]);
        let projection = perspective_matrix(47.0, 1.6, 0.5, 60.0).expect("a matrix");
        for i in 0..200 {
            let t = f64::from(i) * 0.17;
            let point = [t.sin() * 2.0, (t * 1.7).cos(), (t * 0.3).sin() * 3.0];
            let window = project(point, &model, &projection, &VIEWPORT).expect("in front of the eye");
            let back = un_project(window, &model, &projection, &VIEWPORT).expect("an inverse");
            for (a, b) in point.iter().zip(back) {
                assert!((a - b).abs() < 1e-9, "{point:?} came back as {back:?}");
            }
        }
    }

    #[test]
    fn what_has_no_answer_has_none() {
        assert_eq!(project([1.0; 3], &IDENTITY, &[0.0; 16], &VIEWPORT), None);
        assert_eq!(un_project([1.0; 3], &IDENTITY, &[0.0; 16], &VIEWPORT), None);
        assert_eq!(un_project([1.0; 3], &[f64::NAN; 16], &IDENTITY, &VIEWPORT), None);
        let mut flat = IDENTITY;
        flat[10] = 0.0;
        assert_eq!(un_project([1.0; 3], &flat, &IDENTITY, &VIEWPORT), None);
    }
}
