//! Two texture objects on two squares (after the Red Book's `texbind`): binding a name brings its image and all of its
//! parameters back at once.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use std::f32::consts::SQRT_2;
use support::textures::checks;

support::port!(
    "texbind",
    [500, 250],
    "Two texture objects, bound in turn: white checks and red checks.",
    ["glGenTextures(2, &mut names)", "glBindTexture(GL_TEXTURE_2D, names[1])"]
);

fn init() -> [GLuint; 2] {
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let images = [checks(64, 8, [[0; 3], [255; 3]]), checks(64, 16, [[0; 3], [255, 0, 0]])];
    let mut names: [GLuint; 2] = [0; 2];
    glGenTextures(2, &mut names);
    for (name, image) in names.iter().zip(&images) {
        glBindTexture(GL_TEXTURE_2D, *name);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    }
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glEnable(GL_TEXTURE_2D);
    names
}

fn square(corners: [[f32; 3]; 4]) {
    glBegin(GL_QUADS);
    for ([s, t], corner) in [[0.0f32, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].into_iter().zip(&corners) {
        glTexCoord2f(s, t);
        glVertex3fv(corner);
    }
    glEnd();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    let names = init();
    support::reshape(60.0, SIZE, 1.0, 30.0);
    glTranslatef(0.0, 0.0, -3.6);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    square([[-2.0, -1.0, 0.0], [-2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]);
    glBindTexture(GL_TEXTURE_2D, names[1]);
    square([[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [2.41421, 1.0, -SQRT_2], [2.41421, -1.0, -SQRT_2]]);
    glFlush();
}
