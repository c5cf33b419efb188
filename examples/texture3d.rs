//! Three-dimensional textures (after the Red Book's `texture3d` and SGI's `stex3d`): left, a cube of colours cut by two
//! squares; right, a torus carved out of a block of marble, whose texture coordinates are its object coordinates.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::marble;

support::port!(
    "texture3d",
    [512, 256],
    "Two cuts through a cube of colours, and a torus of marble.",
    [
        "glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 16, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, &colours)",
        "glTexGenfv(GL_R, GL_OBJECT_PLANE, &[0.0, 0.0, 0.4, 0.5])",
    ]
);

const N: usize = 32;

fn volume(size: usize, texel: impl Fn([f64; 3]) -> [GLubyte; 3]) -> GLuint {
    let at = |i: usize| [i % size, i / size % size, i / size / size].map(|c| c as f64 / size as f64);
    let image: Vec<[GLubyte; 3]> = (0..size * size * size).map(|i| texel(at(i))).collect();
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_3D, name);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    let n = size as GLsizei;
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, n, n, n, 0, GL_RGB, GL_UNSIGNED_BYTE, &image);
    name
}

/// A square with its own texture coordinates at the four corners.
fn square(x: f32, corners: [[f32; 3]; 4]) {
    glBegin(GL_QUADS);
    for ([dx, dy], tex) in [[0.0f32, 0.0], [0.0, 2.0], [1.1, 2.0], [1.1, 0.0]].into_iter().zip(&corners) {
        glTexCoord3fv(tex);
        glVertex3f(x + dx, dy - 1.0, 0.0);
    }
    glEnd();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glEnable(GL_DEPTH_TEST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let colours = volume(16, |p| p.map(|c| (17.0 * 15.0 * c) as GLubyte));
    let stone = volume(N, |p| {
        let v = marble(p.map(|c| 6.0 * c));
        [(90.0 + 150.0 * v) as GLubyte, (85.0 + 145.0 * v) as GLubyte, (80.0 + 120.0 * v) as GLubyte]
    });
    support::reshape(60.0, SIZE, 1.0, 30.0);
    glTranslatef(0.0, 0.0, -3.0);
    glClearColor(0.2, 0.2, 0.25, 1.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_3D);

    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBindTexture(GL_TEXTURE_3D, colours);
    square(-3.0, [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
    square(-1.6, [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);

    glBindTexture(GL_TEXTURE_3D, stone);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    for (coord, cap, plane) in [
        (GL_S, GL_TEXTURE_GEN_S, [0.4, 0.0, 0.0, 0.5]),
        (GL_T, GL_TEXTURE_GEN_T, [0.0, 0.4, 0.0, 0.5]),
        (GL_R, GL_TEXTURE_GEN_R, [0.0, 0.0, 0.4, 0.5]),
    ] {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        glTexGenfv(coord, GL_OBJECT_PLANE, &plane);
        glEnable(cap);
    }
    glTranslatef(1.6, 0.0, 0.0);
    glRotatef(-50.0, 1.0, 0.2, 0.0);
    support::shapes::solid_torus(0.4, 0.9, 24, 36);
    glFlush();
}
