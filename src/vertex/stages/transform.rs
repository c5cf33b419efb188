//! Transformation stages (OpenGL 1.5, sections 2.11 and 2.12): object to eye and clip coordinates, outcodes, the
//! perspective division and the viewport, all in f64, and the snap to 1/256 pixel. The snap rounds the offset from the
//! viewport's centre, so that moving the viewport by whole pixels moves every vertex by exactly as much.

use super::VertFn;
use crate::num;
use crate::raster::vertex::{ScreenPosition, outcode};
use crate::simd::{LANES, stage};
use crate::vertex::batch::VertexBatch;
use crate::vertex::uniforms::{Columns, VertexUniforms, ViewportUniforms};

/// Window positions with a greater absolute coordinate are outside the guard band.
pub const GUARD_BAND: f64 = 32767.0;

/// Row `r` of a matrix times a vector, in written order.
#[inline(always)]
fn row(m: &Columns, r: usize, v: [f64; 4]) -> f64 {
    m[0][r] * v[0] + m[1][r] * v[1] + m[2][r] * v[2] + m[3][r] * v[3]
}

/// Clip coordinates to window coordinates and 1/256 pixels; what comes out of a w that is not positive means nothing.
#[inline(always)]
#[must_use]
pub fn to_window(v: &ViewportUniforms, clip: [f64; 4]) -> ([f64; 3], [i32; 2]) {
    let [x, y, z, w] = clip;
    let rx = x / w * v.half[0];
    let ry = y / w * v.half[1];
    let snap = |r: f64, center: i32| ((r * 256.0 + num::MAGIC_F64).to_bits() as i32).wrapping_add(center);
    (
        [rx + v.center[0], ry + v.center[1], z / w * v.depth_half + v.depth_center],
        [snap(rx, v.center_snapped[0]), snap(ry, v.center_snapped[1])],
    )
}

stage! {
    /// Object to clip coordinates, always by the one product of both matrices: passes with different state cover the same
    /// pixels.
    pub fn CLIP: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let m = u.to_clip;
        let VertexBatch { position: [px, py, pz, pw], clip: [cx, cy, cz, cw], .. } = b;
        for i in 0..n {
            let v = [f64::from(px[i]), f64::from(py[i]), f64::from(pz[i]), f64::from(pw[i])];
            cx[i] = row(&m, 0, v);
            cy[i] = row(&m, 1, v);
            cz[i] = row(&m, 2, v);
            cw[i] = row(&m, 3, v);
        }
    }

    /// Object to eye coordinates.
    pub fn EYE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let m = u.to_eye;
        let VertexBatch { position: [px, py, pz, pw], eye: [ex, ey, ez, ew], .. } = b;
        for i in 0..n {
            let v = [f64::from(px[i]), f64::from(py[i]), f64::from(pz[i]), f64::from(pw[i])];
            ex[i] = row(&m, 0, v);
            ey[i] = row(&m, 1, v);
            ez[i] = row(&m, 2, v);
            ew[i] = row(&m, 3, v);
        }
    }

    /// Eye coordinates divided by w; a point at infinity stays a direction.
    pub fn EYE_POINT: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let whole = u.eye_affine && b.w_is_one;
        let VertexBatch { eye: [ex, ey, ez, ew], point: [x, y, z], .. } = b;
        if whole {
            (*x, *y, *z) = (*ex, *ey, *ez);
        } else {
            for i in 0..n {
                let w = if ew[i] != 0.0 { ew[i] } else { 1.0 };
                x[i] = ex[i] / w;
                y[i] = ey[i] / w;
                z[i] = ez[i] / w;
            }
        }
    }

    /// Outcodes, perspective division, viewport, snap.
    pub fn WINDOW: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let v = u.viewport;
        let VertexBatch { clip: [cx, cy, cz, cw], window: [wx, wy, wz], screen, .. } = b;
        for i in 0..n {
            let (x, y, z, w) = (cx[i], cy[i], cz[i], cw[i]);
            let ([a, b, c], snapped) = to_window(&v, [x, y, z, w]);
            wx[i] = a;
            wy[i] = b;
            wz[i] = c;
            let bit = |on: bool, bit: u32| if on { bit } else { 0 };
            let inside = (a.abs() <= GUARD_BAND) & (b.abs() <= GUARD_BAND);
            let positive = w > 0.0;
            let finite = x * 0.0 + y * 0.0 + z * 0.0 + w * 0.0 == 0.0;
            let code = bit(x < -w, outcode::LEFT)
                | bit(x > w, outcode::RIGHT)
                | bit(y < -w, outcode::BOTTOM)
                | bit(y > w, outcode::TOP)
                | bit(z < -w, outcode::NEAR)
                | bit(z > w, outcode::FAR)
                | bit(!inside, outcode::GUARD)
                | bit(!positive, outcode::BEHIND)
                | bit(!finite, outcode::NAN);
            screen[i] = ScreenPosition::new(snapped, code);
        }
    }

    /// Distance to a user clip plane (section 2.12) and its outcode bit.
    pub fn USER_PLANE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { eye: [ex, ey, ez, ew], user, screen, .. } = b;
        let k = arg as usize;
        let (Some(plane), Some(bit), Some(user)) = (u.user.get(k), u.user_bit.get(k), user.get_mut(k)) else { return };
        for i in 0..n {
            let d = plane[0] * ex[i] + plane[1] * ey[i] + plane[2] * ez[i] + plane[3] * ew[i];
            user[i] = d;
            screen[i].0 |= if d < 0.0 { u64::from(*bit) } else { 0 };
        }
    }

    /// Eye z as the fog coordinate (section 3.10), of which the fragment takes the absolute value where that is asked for
    /// (NV_fog_distance).
    pub fn FOG_PLANE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { eye: [_, _, ez, _], out, .. } = b;
        let Some(fog) = out.get_mut(u.fog_slot) else { return };
        for i in 0..n {
            fog[i] = num::clamp_f32(ez[i] as f32, -f32::MAX, f32::MAX);
        }
    }

    /// Fog coordinate from the distance to the eye (NV_fog_distance).
    pub fn FOG_RADIAL: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { eye: [ex, ey, ez, _], out, .. } = b;
        let Some(fog) = out.get_mut(u.fog_slot) else { return };
        for i in 0..n {
            let (x, y, z) = (ex[i], ey[i], ez[i]);
            fog[i] = num::min_f32((x * x + y * y + z * z).sqrt() as f32, f32::MAX);
        }
    }

    /// Fog coordinate as the program gives it.
    pub fn FOG_COORD: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { fog: coord, out, .. } = b;
        let Some(fog) = out.get_mut(u.fog_slot) else { return };
        for i in 0..n {
            fog[i] = if coord[i].abs() <= f32::MAX { coord[i] } else { 0.0 };
        }
    }

    /// Point size that does not depend on the distance.
    pub fn POINT_SIZE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let [size, least, greatest] = u.point;
        b.point_size = [num::clamp_f32(size, least, greatest); LANES];
    }

    /// Point size by the distance from the eye (section 3.3).
    pub fn POINT_DISTANCE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let [size, least, greatest] = u.point;
        let [k0, k1, k2] = u.point_attenuation;
        let VertexBatch { point: [x, y, z], point_size, .. } = b;
        for i in 0..n {
            let d = (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]).sqrt() as f32;
            let derived = size * (1.0 / (k0 + k1 * d + k2 * (d * d))).sqrt();
            point_size[i] = num::clamp_f32(derived, least, greatest);
        }
    }
}
