//! Two textures at once (after the Red Book's `multitex`): a brick wall in unit 0 and a spot of light in unit 1. Left: the
//! wall alone; middle: the light map alone; right: both in one pass, each with its own coordinates.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::{Image, bricks, spot};

support::port!(
    "multitex",
    [600, 200],
    "A wall, a light map, and the product of both in one pass.",
    ["glActiveTexture(GL_TEXTURE1)", "glMultiTexCoord2f(GL_TEXTURE1, s, t)"]
);

fn texture(unit: GLenum, size: GLsizei, image: &Image, wrap: GLenum) {
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, size, size, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

fn quad(x: f32) {
    glBegin(GL_QUADS);
    for [s, t] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        glMultiTexCoord2f(GL_TEXTURE0, 2.0 * s, 2.0 * t);
        glMultiTexCoord2f(GL_TEXTURE1, s, t);
        glVertex2f(x + 0.9 * s, 0.05 + 0.9 * t);
    }
    glEnd();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    texture(GL_TEXTURE0, 64, &bricks(64), GL_REPEAT);
    texture(GL_TEXTURE1, 64, &spot(64), GL_CLAMP_TO_EDGE);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0.0, 3.0, 0.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT);
    for (x, wall, light) in [(0.05f32, true, false), (1.05, false, true), (2.05, true, true)] {
        for (unit, on) in [(GL_TEXTURE0, wall), (GL_TEXTURE1, light)] {
            glActiveTexture(unit);
            if on {
                glEnable(GL_TEXTURE_2D);
            } else {
                glDisable(GL_TEXTURE_2D);
            }
        }
        quad(x);
    }
    glFlush();
}
