//! Texture coordinates (OpenGL 1.5, sections 2.11.4 and 2.11.2): generation in f64, the texture matrix, and the store
//! into the slots that the layout wants. A coordinate that is not finite becomes 0 in the store, the one place for it,
//! so that leaving out an identity matrix changes nothing.

use super::VertFn;
use crate::simd::{LANES, stage};
use crate::vertex::batch::{Lanes, VertexBatch};
use crate::vertex::uniforms::VertexUniforms;

/// Packs a unit and a coordinate into a stage argument.
#[must_use]
pub const fn arg(unit: usize, coordinate: usize) -> u32 {
    (unit * 4 + coordinate) as u32
}

#[inline(always)]
fn unpack(arg: u32) -> (usize, usize) {
    ((arg / 4) as usize, (arg % 4) as usize)
}

/// A coordinate as f32; what is not finite, or too large for f32, is 0.
#[inline(always)]
fn finite(v: f64) -> f32 {
    let v = v as f32;
    if v.abs() <= f32::MAX { v } else { 0.0 }
}

/// Which rows go where: s, t, r as far as they count, then q.
fn rows(u: &crate::vertex::uniforms::UnitUniforms) -> impl Iterator<Item = (usize, usize)> {
    let (base, count) = (u.base, u.count.min(3));
    let q = u.has_q.then_some((3, base + count));
    (0..count).map(move |r| (r, base + r)).chain(q)
}

stage! {
    /// The coordinates as the program gives them, to be changed by generation.
    pub fn TEX_LOAD: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { tex, coord, .. } = b;
        let Some(tex) = tex.get(unpack(arg).0) else { return };
        for (to, from) in coord.iter_mut().zip(tex) {
            for i in 0..n {
                to[i] = f64::from(from[i]);
            }
        }
    }

    /// OBJECT_LINEAR.
    pub fn GEN_OBJECT: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let (unit, c) = unpack(arg);
        let VertexBatch { position: [x, y, z, w], coord, .. } = b;
        let (Some(numbers), Some(to)) = (u.units.get(unit), coord.get_mut(c)) else { return };
        let p = numbers.planes[c];
        for i in 0..n {
            to[i] = p[0] * f64::from(x[i]) + p[1] * f64::from(y[i]) + p[2] * f64::from(z[i]) + p[3] * f64::from(w[i]);
        }
    }

    /// EYE_LINEAR.
    pub fn GEN_EYE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let (unit, c) = unpack(arg);
        let VertexBatch { eye: [x, y, z, w], coord, .. } = b;
        let (Some(numbers), Some(to)) = (u.units.get(unit), coord.get_mut(c)) else { return };
        let p = numbers.planes[c];
        for i in 0..n {
            to[i] = p[0] * x[i] + p[1] * y[i] + p[2] * z[i] + p[3] * w[i];
        }
    }

    /// The reflection vector r = u - 2 n (n . u), for SPHERE_MAP and REFLECTION_MAP; u is the unit vector from the eye.
    pub fn REFLECTION: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, _arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { point: [x, y, z], eye_normal: [nx, ny, nz], reflection: [rx, ry, rz], .. } = b;
        for i in 0..n {
            let square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
            let k = if (square > 0.0) & (square < f64::INFINITY) { 1.0 / square.sqrt() } else { 0.0 };
            let (ux, uy, uz) = (x[i] * k, y[i] * k, z[i] * k);
            let (ax, ay, az) = (f64::from(nx[i]), f64::from(ny[i]), f64::from(nz[i]));
            let twice = 2.0 * (ax * ux + ay * uy + az * uz);
            rx[i] = ux - ax * twice;
            ry[i] = uy - ay * twice;
            rz[i] = uz - az * twice;
        }
    }

    /// SPHERE_MAP for s or t. The sum of squares is written out: its simplification 2 (1 + rz) loses every digit near
    /// r = (0, 0, -1), where s and t are 1/2 by definition here.
    pub fn GEN_SPHERE: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { reflection: [rx, ry, rz], coord, .. } = b;
        let c = unpack(arg).1;
        let Some(to) = coord.get_mut(c) else { return };
        for i in 0..n {
            let z = rz[i] + 1.0;
            let m = 2.0 * (rx[i] * rx[i] + ry[i] * ry[i] + z * z).sqrt();
            let r = if c == 0 { rx[i] } else { ry[i] };
            to[i] = if m > 0.0 { r / m + 0.5 } else { 0.5 };
        }
    }

    /// REFLECTION_MAP for s, t or r.
    pub fn GEN_REFLECTION: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, arg: u32) {
        let VertexBatch { reflection, coord, .. } = b;
        let c = unpack(arg).1;
        if let (Some(from), Some(to)) = (reflection.get(c), coord.get_mut(c)) {
            *to = *from;
        }
    }

    /// NORMAL_MAP for s, t or r.
    pub fn GEN_NORMAL: VertFn = (b: &mut VertexBatch, _u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { eye_normal, coord, .. } = b;
        let c = unpack(arg).1;
        let (Some(from), Some(to)) = (eye_normal.get(c), coord.get_mut(c)) else { return };
        for i in 0..n {
            to[i] = f64::from(from[i]);
        }
    }

    /// Coordinates times the texture matrix into the slots.
    pub fn TEX_MATRIX: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { coord: [s, t, r, q], out, .. } = b;
        let Some(numbers) = u.units.get(unpack(arg).0) else { return };
        for (row, slot) in rows(numbers) {
            let Some(to) = out.get_mut(slot) else { return };
            let m = numbers.matrix.map(|column| column[row]);
            for i in 0..n {
                to[i] = finite(m[0] * s[i] + m[1] * t[i] + m[2] * r[i] + m[3] * q[i]);
            }
        }
    }

    /// Generated coordinates into the slots.
    pub fn TEX_STORE: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let VertexBatch { coord, out, .. } = b;
        let Some(numbers) = u.units.get(unpack(arg).0) else { return };
        for (row, slot) in rows(numbers) {
            let (Some(from), Some(to)) = (coord.get(row), out.get_mut(slot)) else { return };
            for i in 0..n {
                to[i] = finite(from[i]);
            }
        }
    }

    /// Coordinates as the program gives them into the slots.
    pub fn TEX_COPY: VertFn = (b: &mut VertexBatch, u: &VertexUniforms, arg: u32) {
        let n = b.span.min(LANES);
        let unit = unpack(arg).0;
        let VertexBatch { tex, out, .. } = b;
        let (Some(numbers), Some(tex)) = (u.units.get(unit), tex.get(unit)) else { return };
        for (row, slot) in rows(numbers) {
            let (from, Some(to)): (&Lanes, _) = (&tex[row], out.get_mut(slot)) else { return };
            for i in 0..n {
                to[i] = if from[i].abs() <= f32::MAX { from[i] } else { 0.0 };
            }
        }
    }
}
