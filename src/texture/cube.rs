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

/// sc, tc and |ma| of a vector on the face whose major axis is `axis` (0 x, 1 y, 2 z) with the sign of `ma`.
#[inline(always)]
fn project(axis: u32, ma: f32, [x, y, z]: [f32; 3]) -> [f32; 3] {
    let sc = match axis {
        0 => signed(-z, ma),
        1 => x,
        _ => signed(x, ma),
    };
    let tc = if axis == 1 { signed(z, ma) } else { -y };
    let major = match axis {
        0 => x,
        1 => y,
        _ => z,
    };
    [sc, tc, signed(major, ma)]
}

#[inline(always)]
fn faces(b: &mut TexBatch, derivatives: bool) {
    for i in 0..LANES {
        let r = [b.coord[0][i], b.coord[1][i], b.coord[2][i]];
        let [ax, ay, az] = r.map(f32::abs);
        let axis = if az >= ax && az >= ay {
            2
        } else if ay >= ax {
            1
        } else {
            0
        };
        let ma = match axis {
            0 => r[0],
            1 => r[1],
            _ => r[2],
        };
        let [sc, tc, m] = project(axis, ma, r);
        // Only the zero vector has no largest component; whatever it is divided by gives 0.
        let m = if m > 0.0 { m } else { 1.0 };
        let (s, t) = (sc / m, tc / m);
        b.work.face[i] = 2 * axis + (ma.to_bits() >> 31 & u32::from(ma != 0.0));
        b.coord[0][i] = 0.5 * s + 0.5;
        b.coord[1][i] = 0.5 * t + 0.5;
        if derivatives {
            let half = 0.5 / m;
            for d in [&mut b.ddx, &mut b.ddy] {
                let [dsc, dtc, dm] = project(axis, ma, [d[0][i], d[1][i], d[2][i]]);
                d[0][i] = (dsc - s * dm) * half;
                d[1][i] = (dtc - t * dm) * half;
            }
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
