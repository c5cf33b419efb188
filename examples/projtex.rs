//! Projective texturing (after SGI's `projtex` and Segal et al. 1992): a slide projector throws its picture on a room and a
//! ball. The texture matrix is bias x projection x view of the projector, applied to eye-linear coordinates, and each
//! fragment divides by q. Behind the projector q is negative and the picture would appear again, upside down; a clip
//! plane at the projector's place keeps that half dark.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::hash;

support::port!(
    "projtex",
    [512, 384],
    "A slide projected on a corner and a ball: s/q, t/q per fragment.",
    [
        "glTexGenfv(GL_Q, GL_EYE_PLANE, &[0.0, 0.0, 0.0, 1.0])",
        "glMatrixMode(GL_TEXTURE)",
        "gluPerspective(38.0, 1.0, 1.0, 60.0)",
    ]
);

const N: usize = 128;

/// A slide: a sun over hills, and a frame.
fn slide() -> Vec<[GLubyte; 3]> {
    let texel = |i: usize| {
        let (x, y) = ((i % N) as f32 / N as f32, (i / N) as f32 / N as f32);
        let edge = x.min(1.0 - x).min(y.min(1.0 - y));
        let hill = 0.35 + 0.1 * (1.0 - (4.0 * x - 1.3) * (4.0 * x - 1.3)).max(-0.6);
        let sun = (x - 0.68) * (x - 0.68) + (y - 0.7) * (y - 0.7) < 0.012;
        let grain = (hash(i as u32) % 24) as u8;
        match () {
            () if edge < 0.02 => [0; 3],
            () if edge < 0.05 => [255; 3],
            () if sun => [255, 230, 90],
            () if y < hill => [50, 110 + grain, 60],
            () => [90 + (120.0 * (1.0 - y)) as u8, 150, 230],
        }
    };
    (0..N * N).map(texel).collect()
}

fn room() {
    glBegin(GL_QUADS);
    glNormal3f(0.0, 1.0, 0.0);
    for (x, z) in [(-8.0f32, 8.0), (8.0, 8.0), (8.0, -8.0), (-8.0, -8.0)] {
        glVertex3f(x, -4.0, z);
    }
    glNormal3f(0.0, 0.0, 1.0);
    for (x, y) in [(-8.0f32, -4.0), (8.0, -4.0), (8.0, 6.0), (-8.0, 6.0)] {
        glVertex3f(x, y, -8.0);
    }
    glNormal3f(1.0, 0.0, 0.0);
    for (y, z) in [(-4.0f32, 8.0), (-4.0, -8.0), (6.0, -8.0), (6.0, 8.0)] {
        glVertex3f(-8.0, y, z);
    }
    glEnd();
    glPushMatrix();
    glTranslatef(-1.0, -2.0, -2.5);
    support::shapes::textured_sphere(2.0, 40, 30);
    glPopMatrix();
}

fn projector() {
    gluLookAt(7.0, 4.0, 9.0, -2.0, -0.5, -4.0, 0.0, 1.0, 0.0);
}

fn init() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, N as GLsizei, N as GLsizei, GL_RGB, GL_UNSIGNED_BYTE, &slide());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &[0.3, 0.3, 0.33, 1.0]);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, &[0.35, 0.35, 0.35, 1.0]);
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    support::reshape(50.0, SIZE, 1.0, 60.0);
    gluLookAt(4.0, 3.0, 14.0, -1.5, -0.5, -3.0, 0.0, 1.0, 0.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightfv(GL_LIGHT0, GL_POSITION, &[7.0, 4.0, 9.0, 1.0]);
    glEnable(GL_LIGHTING);
    room();

    // The picture is added to what the lamp gives.
    glDisable(GL_LIGHTING);
    for (coord, cap, plane) in [
        (GL_S, GL_TEXTURE_GEN_S, [1.0, 0.0, 0.0, 0.0]),
        (GL_T, GL_TEXTURE_GEN_T, [0.0, 1.0, 0.0, 0.0]),
        (GL_R, GL_TEXTURE_GEN_R, [0.0, 0.0, 1.0, 0.0]),
        (GL_Q, GL_TEXTURE_GEN_Q, [0.0, 0.0, 0.0, 1.0]),
    ] {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(coord, GL_EYE_PLANE, &plane);
        glEnable(cap);
    }
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5, 0.5, 0.5);
    glScalef(0.5, 0.5, 0.5);
    gluPerspective(38.0, 1.0, 1.0, 60.0);
    projector();
    glMatrixMode(GL_MODELVIEW);
    // Only what lies before the projector: the plane through its place, looking where it looks.
    glClipPlane(GL_CLIP_PLANE0, &[-9.0, -4.5, -13.0, 7.0 * 9.0 + 4.0 * 4.5 + 9.0 * 13.0]);
    glEnable(GL_CLIP_PLANE0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glColor3f(0.7, 0.7, 0.7);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthFunc(GL_LEQUAL);
    glPolygonOffset(-1.0, -1.0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    room();
    glFlush();
}
