//! Normals in eye coordinates (OpenGL 1.5, section 2.11.3). A normal is transformed by the inverse of the modelview's upper
//! 3x3, which is its cofactor matrix divided by its determinant. With NORMALIZE only the determinant's sign matters, and
//! RESCALE_NORMAL's factor is the length of a column of cofactors: neither divides by the determinant, so both are
//! defined for a singular matrix too.

use super::VertFn;
use crate::simd::{LANES, stage};
use crate::vertex::batch::VertexBatch;
use crate::vertex::uniforms::{NormalMatrix, VertexUniforms};
use glam::DMat4;

/// How normals are brought to their length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rescale {
    /// Not at all: the inverse as it is.
    None,
    /// RESCALE_NORMAL: one factor for all, right for uniform scales.
    Matrix,
    /// NORMALIZE: the length is divided out for each normal, so that any positive factor may stay in the matrix.
    Each,
}

/// The matrix for normals. A modelview with a number that is not finite gives the zero matrix; a singular one without
/// rescaling gives its cofactors.
#[must_use]
pub fn normal_matrix(modelview: &DMat4, rescale: Rescale) -> NormalMatrix {
    let m: [[f64; 3]; 3] = [modelview.x_axis, modelview.y_axis, modelview.z_axis].map(|c| c.truncate().to_array());
    let greatest = m.as_flattened().iter().fold(0.0f64, |a, v| if v.abs() > a || v.is_nan() { v.abs() } else { a });
    if !(greatest > 0.0 && greatest.is_finite()) {
        return [[0.0; 3]; 3];
    }
    // A power of two, so that the usual matrices keep their bits and no product overflows.
    let unit = f64::from_bits(greatest.to_bits() & 0x7ff0_0000_0000_0000).max(f64::MIN_POSITIVE);
    let m = m.map(|column| column.map(|v| v / unit));
    let cofactor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1]
    };
    let cofactors: NormalMatrix = std::array::from_fn(|i| std::array::from_fn(|j| cofactor(i, j)));
    let determinant = (0..3).map(|j| m[0][j] * cofactors[0][j]).sum::<f64>();
    let sign = if determinant < 0.0 { -1.0 } else { 1.0 };
    let divisor = match rescale {
        Rescale::Each => sign,
        // Row 3 of the inverse is column 3 of its transpose.
        Rescale::Matrix => sign * cofactors[2].iter().map(|v| v * v).sum::<f64>().sqrt(),
        Rescale::None => determinant * unit,
    };
    let divisor = if divisor != 0.0 && divisor.is_finite() { divisor } else { sign };
    let scaled = cofactors.map(|column| column.map(|v| v / divisor));
    if scaled.as_flattened().iter().all(|v| v.is_finite()) { scaled } else { [[0.0; 3]; 3] }
}

/// Object to eye coordinates for lane `i`.
#[inline(always)]
fn transformed(m: &NormalMatrix, n: [f32; 3]) -> [f64; 3] {
    let [x, y, z] = n.map(f64::from);
    [
        m[0][0] * x + m[1][0] * y + m[2][0] * z,
        m[0][1] * x + m[1][1] * y + m[2][1] * z,
        m[0][2] * x + m[1][2] * y + m[2][2] * z,
    ]
}

stage! {
    /// The normal in eye coordinates.
    pub fn NORMAL: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let m = u.to_normal;
        let VertexBatch { normal: [nx, ny, nz], eye_normal: [ex, ey, ez], .. } = b;
        for i in 0..n {
            let [x, y, z] = transformed(&m, [nx[i], ny[i], nz[i]]);
            let finite = x * 0.0 + y * 0.0 + z * 0.0 == 0.0;
            let keep = |v: f64| if finite { v as f32 } else { 0.0 };
            ex[i] = keep(x);
            ey[i] = keep(y);
            ez[i] = keep(z);
        }
    }

    /// The normal in eye coordinates with length 1; zero stays zero.
    pub fn NORMAL_UNIT: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let m = u.to_normal;
        let VertexBatch { normal: [nx, ny, nz], eye_normal: [ex, ey, ez], .. } = b;
        for i in 0..n {
            let [x, y, z] = transformed(&m, [nx[i], ny[i], nz[i]]);
            let square = x * x + y * y + z * z;
            let scale = 1.0 / square.sqrt();
            let usable = (square > 0.0) & (square < f64::INFINITY);
            let keep = |v: f64| if usable { (v * scale) as f32 } else { 0.0 };
            ex[i] = keep(x);
            ey[i] = keep(y);
            ez[i] = keep(z);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DMat3, DVec3};

    fn apply(m: &NormalMatrix, n: [f32; 3]) -> DVec3 {
        DVec3::from_array(transformed(m, n))
    }

    #[test]
    fn identity_and_rotation_keep_normals() {
        for rescale in [Rescale::None, Rescale::Matrix, Rescale::Each] {
            assert_eq!(normal_matrix(&DMat4::IDENTITY, rescale), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
        let quarter = DMat4::from_mat3(DMat3::from_cols(DVec3::Y, -DVec3::X, DVec3::Z));
        assert_eq!(apply(&normal_matrix(&quarter, Rescale::None), [1.0, 0.0, 0.0]), DVec3::Y);
    }

    #[test]
    fn scales_go_the_inverse_way() {
        let scale = DMat4::from_scale(DVec3::new(2.0, 4.0, 8.0));
        let m = normal_matrix(&scale, Rescale::None);
        assert_eq!(apply(&m, [1.0, 1.0, 1.0]), DVec3::new(0.5, 0.25, 0.125));
        let three = DMat4::from_scale(DVec3::splat(3.0));
        let m = normal_matrix(&three, Rescale::Matrix);
        assert!((apply(&m, [0.0, 0.6, 0.8]) - DVec3::new(0.0, 0.6, 0.8)).length() < 1e-7);
        // A mirror image negates x and nothing else.
        let mirror = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
        assert_eq!(apply(&normal_matrix(&mirror, Rescale::Each), [1.0, 0.0, 1.0]), DVec3::new(-1.0, 0.0, 1.0));
    }

    #[test]
    fn singular_and_wild_matrices_stay_finite() {
        let flat = DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0));
        assert_eq!(apply(&normal_matrix(&flat, Rescale::Each), [0.0, 0.0, 1.0]), DVec3::Z);
        for k in [0.0, 1e-300, 1e300, f64::INFINITY, f64::NAN] {
            for rescale in [Rescale::None, Rescale::Matrix, Rescale::Each] {
                let m = normal_matrix(&DMat4::from_scale(DVec3::new(k, 1.0, k)), rescale);
                assert!(m.as_flattened().iter().all(|v| v.is_finite()), "{k} {rescale:?}: {m:?}");
            }
        }
    }
}
