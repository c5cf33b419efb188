//! A checkerboard texture on two squares, one facing the viewer and one turned away by 45 degrees (after the Red Book's
//! `checker`). It shows the life of a texture object and why nearest filtering crawls with distance: three components
//! asked for as the number 3, CLAMP, DECAL.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use std::f32::consts::SQRT_2;

support::port!(
    "checker",
    [500, 250],
    "A texture object on two squares: NEAREST, CLAMP, DECAL.",
    [
        "glTexImage2D(GL_TEXTURE_2D, 0, 3, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, &image)",
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP)",
        "glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL)",
    ]
);

const N: usize = 64;

/// Squares of 8 by 8 texels, black and white.
fn make_check_image() -> [[[GLubyte; 4]; N]; N] {
    let mut image = [[[255; 4]; N]; N];
    for (i, row) in image.iter_mut().enumerate() {
        for (j, texel) in row.iter_mut().enumerate() {
            let c = if (i & 8 == 0) != (j & 8 == 0) { 255 } else { 0 };
            *texel = [c, c, c, 255];
        }
    }
    image
}

fn init() {
    glClearColor(0.0, 0.0, 0.0, 0.0);
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);

    let check_image = make_check_image();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut tex_name: GLuint = 0;
    glGenTextures(1, &mut tex_name);
    glBindTexture(GL_TEXTURE_2D, tex_name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, 3, N as GLsizei, N as GLsizei, 0, GL_RGBA, GL_UNSIGNED_BYTE, &check_image);
}

fn display() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glBegin(GL_QUADS);
    glTexCoord2f(0.0, 0.0);
    glVertex3f(-2.0, -1.0, 0.0);
    glTexCoord2f(0.0, 1.0);
    glVertex3f(-2.0, 1.0, 0.0);
    glTexCoord2f(1.0, 1.0);
    glVertex3f(0.0, 1.0, 0.0);
    glTexCoord2f(1.0, 0.0);
    glVertex3f(0.0, -1.0, 0.0);

    glTexCoord2f(0.0, 0.0);
    glVertex3f(1.0, -1.0, 0.0);
    glTexCoord2f(0.0, 1.0);
    glVertex3f(1.0, 1.0, 0.0);
    glTexCoord2f(1.0, 1.0);
    glVertex3f(2.41421, 1.0, -SQRT_2);
    glTexCoord2f(1.0, 0.0);
    glVertex3f(2.41421, -1.0, -SQRT_2);
    glEnd();
    glFlush();
    glDisable(GL_TEXTURE_2D);
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    support::reshape(60.0, SIZE, 1.0, 30.0);
    glTranslatef(0.0, 0.0, -3.6);
    display();
}
