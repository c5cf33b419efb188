//! A part of a texture replaced by a smaller image (after the Red Book's `texsub`): the left square is drawn before, the
//! right one after `glTexSubImage2D`. Drawing may wait, but the left square keeps the texels that it was issued with.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::checks;

support::port!(
    "texsub",
    [500, 250],
    "Left: before, right: after a part of the texture is replaced.",
    ["glTexSubImage2D(GL_TEXTURE_2D, 0, 12, 44, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, &part)"]
);

fn square(x: f32) {
    glBegin(GL_QUADS);
    glTexCoord2f(0.0, 0.0);
    glVertex3f(x, -1.0, 0.0);
    glTexCoord2f(0.0, 1.0);
    glVertex3f(x, 1.0, 0.0);
    glTexCoord2f(1.0, 1.0);
    glVertex3f(x + 2.0, 1.0, 0.0);
    glTexCoord2f(1.0, 0.0);
    glVertex3f(x + 2.0, -1.0, 0.0);
    glEnd();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    let image = checks(64, 8, [[0; 3], [255; 3]]);
    let part = checks(16, 4, [[0; 3], [255, 0, 0]]);
    glShadeModel(GL_FLAT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, &image);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    support::reshape(60.0, SIZE, 1.0, 30.0);
    glTranslatef(0.0, 0.0, -2.4);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    square(-2.2);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 12, 44, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, &part);
    square(0.2);
    glFlush();
}
