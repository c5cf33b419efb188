//! Contours by texture coordinate generation (after the Red Book's `texgen`): a one-dimensional texture of stripes, its
//! coordinate generated from a plane. Left: in object coordinates, so the stripes turn with the torus; right: in eye
//! coordinates, so the torus turns through fixed stripes.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "texgen",
    [512, 256],
    "Stripes from a plane: OBJECT_LINEAR on the left, EYE_LINEAR on the right.",
    [
        "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR)",
        "glTexGenfv(GL_S, GL_OBJECT_PLANE, &[1.0, 1.0, 1.0, 0.0])",
        "glTexImage1D(GL_TEXTURE_1D, 0, 4, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, &stripes)",
    ]
);

fn init() {
    let stripes: Vec<[GLubyte; 4]> =
        (0..32).map(|j: u8| [if j <= 4 { 255 } else { 0 }, if j > 4 { 255 } else { 0 }, 0, 255]).collect();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_1D, name);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage1D(GL_TEXTURE_1D, 0, 4, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, &stripes);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_1D);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glMaterialf(GL_FRONT, GL_SHININESS, 64.0);
}

fn torus(x: f32) {
    glPushMatrix();
    glTranslatef(x, 0.0, 0.0);
    glRotatef(-50.0, 1.0, 0.0, 0.3);
    support::shapes::solid_torus(0.5, 1.2, 24, 36);
    glPopMatrix();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-4.0, 4.0, -2.0, 2.0, -4.0, 4.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, &[1.0, 1.0, 1.0, 0.0]);
    torus(-2.0);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
    glTexGenfv(GL_S, GL_EYE_PLANE, &[1.0, 0.0, 0.0, 0.0]);
    torus(2.0);
    glFlush();
}
