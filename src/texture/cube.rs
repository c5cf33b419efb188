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

use super::batch::{Derivatives, TexBatch};
use super::uniforms::{SamplerUniforms, TexFn};
use crate::simd::{LANES, stage};

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
    b.limit = [f32::INFINITY; 3];
    b.least = [f32::NEG_INFINITY; 3];
    b.derivatives = Derivatives::PerLane;
    let TexBatch { coord: [cs, ct, cr], ddx: [sx, tx, rx], ddy: [sy, ty, ry], scratch, .. } = b;
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
        scratch.face[i] = if ma < 0.0 { face + 1 } else { face };
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
    pub fn CUBE_FACE: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        faces(b, false);
    }
    /// Face, coordinates on it and their derivatives.
    pub fn CUBE_FACE_DERIVATIVES: TexFn = (b: &mut TexBatch, _u: &SamplerUniforms, _arg: u32) {
        faces(b, true);
    }
}

#[cfg(test)]
mod tests {
    use crate::enums::*;
    use crate::state::texture::Target;
    use crate::state::texture::TextureFilter;
    use crate::state::texture::WrapMode;
    use crate::texture::object::TextureObject;
    use crate::texture::tests::support::*;

    /// Face f has texels 40 f + 4 j + i, four by four.
    fn faces() -> TextureObject {
        let mut o =
            object(Target::Cube, GL_LUMINANCE8, [4, 4, 1], 3, |f, _, [i, j, _]| grey(40 * f as i32 + 4 * j + i));
        o.parameters.wrap = [WrapMode::ClampToEdge; 3];
        o
    }

    #[test]
    fn every_direction_has_its_face_whatever_its_length() {
        let o = faces();
        for x in -1..=1 {
            for y in -1..=1 {
                for z in -1..=1 {
                    let v = [x as f32, y as f32, z as f32];
                    // z before y before x; the zero vector reads +z.
                    let face = match (x, y, z) {
                        (_, _, 1) | (0, 0, 0) => 4,
                        (_, _, -1) => 5,
                        (_, 1, _) => 2,
                        (_, -1, _) => 3,
                        (1, ..) => 0,
                        _ => 1,
                    };
                    for k in [1e-30, 1.0, 1e30] {
                        let texel = red(&o, at(v[0] * k, v[1] * k, v[2] * k)) as i32;
                        assert_eq!(texel / 40, face, "{v:?} times {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn coordinates_on_a_face_follow_the_table() {
        let o = faces();
        // A direction a little off each axis by (0.6, -0.2) in the two other components, and s, t by table 3.18.
        let table: [([f32; 3], f32, f32); 6] = [
            ([1.0, -0.2, 0.6], -0.6, 0.2),
            ([-1.0, -0.2, 0.6], 0.6, 0.2),
            ([0.6, 1.0, -0.2], 0.6, -0.2),
            ([0.6, -1.0, -0.2], 0.6, 0.2),
            ([0.6, -0.2, 1.0], 0.6, 0.2),
            ([0.6, -0.2, -1.0], -0.6, 0.2),
        ];
        for (face, (v, sc, tc)) in table.into_iter().enumerate() {
            let texel = |c: f32| ((c + 1.0) / 2.0 * 4.0).floor() as i32;
            let want = 40 * face as i32 + 4 * texel(tc) + texel(sc);
            assert_eq!(red(&o, at(v[0], v[1], v[2])), want as f32, "{v:?}");
        }
    }

    #[test]
    fn lambda_is_that_of_the_projection() {
        let mut o = object(Target::Cube, GL_LUMINANCE8, [64, 64, 1], 7, |_, l, _| grey(10 + 30 * l as i32));
        (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
        // On face +z at distance m: s = x / 2m, so rho = 64 * dx / 2m; moving along the direction changes nothing.
        let (m, d) = (5.0f32, 0.7f32);
        let p = SamplePoint { at: [0.0, 0.0, m], dx: [d, 0.0, 9.0], dy: [0.0, 0.1, -3.0] };
        let lambda = (64.0 * f64::from(d) / (2.0 * f64::from(m))).log2();
        assert!((f64::from(red(&o, p)) - 10.0 - 30.0 * lambda).abs() < 0.02, "{}", red(&o, p));
        // Away from the centre the change of m counts: ds/dx = (dx - s dm) / 2m with s = x/m.
        let p = SamplePoint { at: [2.0, 0.0, m], dx: [d, 0.0, 0.5], dy: [0.0; 3] };
        let lambda = (64.0 * (0.7 - 0.4 * 0.5) / 10.0f64).log2();
        assert!((f64::from(red(&o, p)) - 10.0 - 30.0 * lambda).abs() < 0.02, "{}", red(&o, p));
    }
}
