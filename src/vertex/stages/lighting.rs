//! Lighting, the part of the lights (OpenGL 1.5, section 2.14.1): for each light its direction, attenuation and
//! spot factor, then sums of ambient, diffuse and specular light over all lights. The material multiplies the sums once
//! at the end (`material`), so that one light more costs three products a term, whether colours track or not.
//!
//! A vector is subtracted in f64 and has its length divided out in f32. Zero vectors stay zero, attenuation is limited
//! to 1e30: no sum is ever NaN.

use super::VertFn;
use crate::num;
use crate::simd::{LANES, stage};
use crate::vertex::batch::{F64Lanes, Lanes, VertexBatch};
use crate::vertex::uniforms::{LightUniforms, VertexUniforms};

/// Argument of the sums: the light's number in the low bits, then these flags.
pub mod flag {
    /// Where the light's number is.
    pub const LIGHT: u32 = 15;
    /// The light has a position: attenuation is in the batch.
    pub const ATTENUATED: u32 = 16;
    /// Attenuation is computed from the distance, not 1.
    pub const DISTANCE: u32 = 32;
    /// The light is a spot.
    pub const SPOT: u32 = 64;
    /// The spot exponent is not 0.
    pub const EXPONENT: u32 = 128;
    /// The vector to the viewer differs from vertex to vertex.
    pub const LOCAL_VIEWER: u32 = 256;
    /// The vector to the light differs from vertex to vertex.
    pub const LOCAL_LIGHT: u32 = 512;
}

const GREATEST_ATTENUATION: f32 = 1e30;

fn light(u: &VertexUniforms, arg: u32) -> LightUniforms {
    u.lights.get((arg & flag::LIGHT) as usize).copied().unwrap_or_default()
}

/// `1 / length` of a vector, 0 where the vector has no direction.
#[inline(always)]
fn inverse_length(square: f32) -> f32 {
    if (square > 0.0) & (square < f32::INFINITY) { 1.0 / square.sqrt() } else { 0.0 }
}

/// Vectors from `from` to `to`, and the square of their lengths.
#[inline(always)]
fn unit_vectors(to: [f64; 3], from: &[F64Lanes; 3], out: &mut [Lanes; 3], distance: &mut Lanes, n: usize) {
    let ([px, py, pz], [ox, oy, oz]) = (from, out);
    for i in 0..n.min(LANES) {
        let (x, y, z) = ((to[0] - px[i]) as f32, (to[1] - py[i]) as f32, (to[2] - pz[i]) as f32);
        let square = x * x + y * y + z * z;
        let k = inverse_length(square);
        ox[i] = x * k;
        oy[i] = y * k;
        oz[i] = z * k;
        distance[i] = square * k;
    }
}

stage! {
    /// All sums to zero.
    pub fn LIGHT_CLEAR: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, _arg: u32) {
        let faces = if u.two_side { 2 } else { 1 };
        for face in b.faces.iter_mut().take(faces) {
            face.ambient = [[0.0; LANES]; 3];
            face.diffuse = [[0.0; LANES]; 3];
            face.specular = [[0.0; LANES]; 3];
        }
    }

    /// The unit vector from each vertex to the eye.
    pub fn VIEWER: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, _arg: u32) {
        let n = b.span;
        let VertexBatch { point, to_viewer, n_dot_h, .. } = b;
        unit_vectors([0.0; 3], point, to_viewer, n_dot_h, n);
    }

    /// Direction, attenuation and spot factor of a light that has a position or is a spot.
    pub fn LIGHT_LOCAL: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let l = light(u, arg);
        let VertexBatch { point, to_light, attenuation, n_dot_h: distance, .. } = b;
        if arg & flag::LOCAL_LIGHT != 0 {
            unit_vectors(l.position, point, to_light, distance, n);
        } else {
            *to_light = l.direction.map(|v| [v; LANES]);
        }
        let [k0, k1, k2] = l.attenuation;
        if arg & flag::DISTANCE != 0 {
            for i in 0..n {
                let d = distance[i];
                attenuation[i] = num::clamp_f32(1.0 / (k0 + k1 * d + k2 * (d * d)), 0.0, GREATEST_ATTENUATION);
            }
        } else {
            *attenuation = [1.0; LANES];
        }
        if arg & flag::SPOT != 0 {
            let [x, y, z] = to_light;
            let [sx, sy, sz] = l.spot_direction;
            for i in 0..n {
                let cos = -(x[i] * sx + y[i] * sy + z[i] * sz);
                let factor = if arg & flag::EXPONENT != 0 { num::pow_f32(cos, l.spot_exponent) } else { 1.0 };
                attenuation[i] *= if cos >= l.spot_cos { factor } else { 0.0 };
            }
        }
    }

    /// Ambient light of an attenuated light.
    pub fn LIGHT_AMBIENT: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let l = light(u, arg);
        let faces = if u.two_side { 2 } else { 1 };
        let VertexBatch { faces: sums, attenuation, .. } = b;
        for face in sums.iter_mut().take(faces) {
            for (sum, intensity) in face.ambient.iter_mut().zip(l.ambient) {
                for i in 0..n {
                    sum[i] += attenuation[i] * intensity;
                }
            }
        }
    }

    /// n . l and diffuse light.
    pub fn LIGHT_DIFFUSE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let l = light(u, arg);
        let VertexBatch { eye_normal: [nx, ny, nz], to_light: [lx, ly, lz], attenuation, n_dot_l, faces, .. } = b;
        let [front, back] = faces;
        if arg & flag::ATTENUATED != 0 {
            for i in 0..n {
                n_dot_l[i] = nx[i] * lx[i] + ny[i] * ly[i] + nz[i] * lz[i];
            }
            let [r, g, b] = &mut front.diffuse;
            for i in 0..n {
                let k = attenuation[i] * num::max_f32(n_dot_l[i], 0.0);
                r[i] += k * l.diffuse[0];
                g[i] += k * l.diffuse[1];
                b[i] += k * l.diffuse[2];
            }
        } else {
            let [dx, dy, dz] = l.direction;
            let [r, g, b] = &mut front.diffuse;
            for i in 0..n {
                let dot = nx[i] * dx + ny[i] * dy + nz[i] * dz;
                n_dot_l[i] = dot;
                let k = num::max_f32(dot, 0.0);
                r[i] += k * l.diffuse[0];
                g[i] += k * l.diffuse[1];
                b[i] += k * l.diffuse[2];
            }
        }
        if u.two_side {
            let [r, g, b] = &mut back.diffuse;
            for i in 0..n {
                let a = if arg & flag::ATTENUATED != 0 { attenuation[i] } else { 1.0 };
                let k = a * num::max_f32(-n_dot_l[i], 0.0);
                r[i] += k * l.diffuse[0];
                g[i] += k * l.diffuse[1];
                b[i] += k * l.diffuse[2];
            }
        }
    }

    /// n . h and specular light.
    pub fn LIGHT_SPECULAR: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let l = light(u, arg);
        let VertexBatch { eye_normal: [nx, ny, nz], to_light: [lx, ly, lz], to_viewer: [vx, vy, vz], .. } = b;
        let VertexBatch { attenuation, n_dot_l, n_dot_h, faces, .. } = b;
        if arg & (flag::LOCAL_LIGHT | flag::LOCAL_VIEWER) == 0 {
            let [hx, hy, hz] = l.half;
            for i in 0..n {
                n_dot_h[i] = nx[i] * hx + ny[i] * hy + nz[i] * hz;
            }
        } else {
            let local_light = arg & flag::ATTENUATED != 0;
            let local_viewer = arg & flag::LOCAL_VIEWER != 0;
            let [dx, dy, dz] = l.direction;
            for i in 0..n {
                let (x, y, z) = if local_light { (lx[i], ly[i], lz[i]) } else { (dx, dy, dz) };
                let (ex, ey, ez) = if local_viewer { (vx[i], vy[i], vz[i]) } else { (0.0, 0.0, 1.0) };
                let (x, y, z) = (x + ex, y + ey, z + ez);
                n_dot_h[i] = (nx[i] * x + ny[i] * y + nz[i] * z) * inverse_length(x * x + y * y + z * z);
            }
        }
        let count = if u.two_side { 2 } else { 1 };
        for (k, (face, material)) in faces.iter_mut().zip(&u.materials).enumerate().take(count) {
            let sign = if k == 0 { 1.0 } else { -1.0 };
            let shininess = material.shininess;
            let [r, g, b] = &mut face.specular;
            for i in 0..n {
                let a = if arg & flag::ATTENUATED != 0 { attenuation[i] } else { 1.0 };
                let power = num::pow_f32(num::max_f32(sign * n_dot_h[i], 0.0), shininess);
                let s = if sign * n_dot_l[i] > 0.0 { a * power } else { 0.0 };
                r[i] += s * l.specular[0];
                g[i] += s * l.specular[1];
                b[i] += s * l.specular[2];
            }
        }
    }
}
