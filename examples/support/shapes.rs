//! The solids that GLUT programs draw, with normals, made from GL calls as GLUT makes them.

use fixedgl::c::*;
use fixedgl::math::sin_cos;
use std::f64::consts::TAU;

/// A torus around the z axis, as `glutSolidTorus`: radius of the tube, radius of the ring, and how finely both are cut.
pub fn solid_torus(inner: f64, outer: f64, sides: u32, rings: u32) {
    for ring in 0..rings {
        glBegin(GL_QUAD_STRIP);
        for side in (0..=sides).rev() {
            let (sp, cp) = sin_cos(TAU * f64::from(side % sides) / f64::from(sides));
            for edge in [ring + 1, ring] {
                let (st, ct) = sin_cos(TAU * f64::from(edge % rings) / f64::from(rings));
                glNormal3d(ct * cp, st * cp, sp);
                glVertex3d(ct * (outer + inner * cp), st * (outer + inner * cp), inner * sp);
            }
        }
        glEnd();
    }
}

/// A cube around the origin, as `glutSolidCube`, with texture coordinates from corner to corner of each side.
pub fn solid_cube(size: f32) {
    const SIDES: [([f32; 3], [f32; 3], [f32; 3]); 6] = [
        ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    ];
    let h = size / 2.0;
    glBegin(GL_QUADS);
    for (normal, right, up) in &SIDES {
        glNormal3fv(normal);
        for (s, t) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            let at: [f32; 3] =
                std::array::from_fn(|i| h * (normal[i] + (2.0 * s - 1.0) * right[i] + (2.0 * t - 1.0) * up[i]));
            glTexCoord2f(s, t);
            glVertex3fv(&at);
        }
    }
    glEnd();
}

/// A sphere around the origin with normals and texture coordinates, as `gluSphere` with texturing on.
pub fn textured_sphere(radius: f64, slices: i32, stacks: i32) {
    let q = gluNewQuadric();
    gluQuadricTexture(&q, GL_TRUE);
    gluSphere(&q, radius, slices, stacks);
    gluDeleteQuadric(q);
}
