//! Cube maps (OpenGL 1.5, section 3.8.6, table 3.18): a direction selects one of six faces by its largest component, and
//! the other two components divided by it are the coordinates on that face.
//!
//! ```text
//!   major axis   face    sc    tc           s = (sc / |ma| + 1) / 2
//!   +x, -x       0, 1   -z,+z  -y           ds/dx = (dsc/dx - sc/|ma| d|ma|/dx) / (2 |ma|)
//!   +y, -y       2, 3   +x     +z,-z
//!   +z, -z       4, 5   +x,-x  -y
//! ```
//!
//! Of equal components z goes before y and y before x. The zero vector reads the middle of face +z. Derivatives are those
//! of the projection on the fragment's own face, so no edge between faces ever enters a level of detail.

use super::batch::TexBatch;
use super::uniforms::{TexFn, UnitUniforms};
use crate::batch::{LANES, stage};

/// `v` with the sign of `ma` applied.
#[inline(always)]
fn signed(v: f32, ma: f32) -> f32 {
    f32::from_bits(v.to_bits() ^ (ma.to_bits() & 0x8000_0000))
}

/// sc, tc and |ma| of a vector (x, y, z) on the face whose major axis is x or y (`is_x`, `is_y`; else z) and `ma` along it.
#[inline(always)]
fn project(is_x: bool, is_y: bool, ma: f32, x: f32, y: f32, z: f32) -> (f32, f32, f32) {
    let sc = signed(if is_x { -z } else { x }, if is_y { 1.0 } else { ma });
    let tc = if is_y { signed(z, ma) } else { -y };
    let major = if is_x { x } else { z };
    let major = if is_y { y } else { major };
    (sc, tc, signed(major, ma))
}

#[inline(always)]
fn faces(b: &mut TexBatch, derivatives: bool) {
    let TexBatch { coord: [cs, ct, cr], ddx: [sx, tx, rx], ddy: [sy, ty, ry], work, .. } = b;
    for i in 0..LANES {
        let (x, y, z) = (cs[i], ct[i], cr[i]);
        let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
        let is_z = az >= ax && az >= ay;
        let is_y = ay >= ax && !is_z;
        let is_x = !is_y && !is_z;
        let ma = if is_y { y } else { z };
        let ma = if is_x { x } else { ma };
        let (sc, tc, m) = project(is_x, is_y, ma, x, y, z);
        // Only the zero vector has no largest component; whatever it is divided by gives 0.
        let m = if m > 0.0 { m } else { 1.0 };
        let (s, t) = (sc / m, tc / m);
        let face = if is_y { 2 } else { 4 };
        let face = if is_x { 0 } else { face };
        work.face[i] = if ma < 0.0 { face + 1 } else { face };
        cs[i] = 0.5 * s + 0.5;
        ct[i] = 0.5 * t + 0.5;
        if derivatives {
            let half = 0.5 / m;
            let (dsc, dtc, dm) = project(is_x, is_y, ma, sx[i], tx[i], rx[i]);
            sx[i] = (dsc - s * dm) * half;
            tx[i] = (dtc - t * dm) * half;
            let (dsc, dtc, dm) = project(is_x, is_y, ma, sy[i], ty[i], ry[i]);
            sy[i] = (dsc - s * dm) * half;
            ty[i] = (dtc - t * dm) * half;
        }
    }
}

stage! {
    /// Face and coordinates on it.
    pub fn CUBE_FACE: TexFn = (b: &mut TexBatch, _u: &UnitUniforms, _arg: u32) {
        faces(b, false);
    }
    /// Face, coordinates on it and their derivatives.
    pub fn CUBE_FACE_DERIVATIVES: TexFn = (b: &mut TexBatch, _u: &UnitUniforms, _arg: u32) {
        faces(b, true);
    }
}
