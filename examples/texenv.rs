//! The table of texture environments in one picture (after SGI's `texenv`): a row for each base format, a column for each
//! function. The fragment's colour is a blend from yellow to blue with alpha 0.5 to 1, the environment colour is red, and
//! the texture is a disc whose colour and alpha fade outwards. What a format does not have, a function does not change.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "texenv",
    [500, 600],
    "REPLACE, MODULATE, DECAL, BLEND, ADD by ALPHA, LUMINANCE, LUMINANCE_ALPHA, INTENSITY, RGB, RGBA (bottom to top).",
    ["glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND)", "glTexImage2D(.., GL_LUMINANCE_ALPHA, ..)"]
);

const N: usize = 32;
const FORMATS: [GLenum; 6] = [GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA];
const MODES: [GLenum; 5] = [GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD];

fn image() -> Vec<[GLubyte; 4]> {
    let texel = |i: usize| {
        let half = N as f32 / 2.0;
        let (x, y) = ((i % N) as f32 + 0.5 - half, (i / N) as f32 + 0.5 - half);
        let v = (1.15 - (x * x + y * y).sqrt() / half).clamp(0.0, 1.0);
        [(255.0 * v) as GLubyte, (200.0 * v) as GLubyte, (120.0 * v) as GLubyte, (255.0 * v) as GLubyte]
    };
    (0..N * N).map(texel).collect()
}

/// What lies behind: checks, so that alpha shows.
fn background() {
    for i in 0..50 {
        for j in 0..60 {
            if (i + j) % 2 == 0 {
                glColor3f(0.45, 0.45, 0.45);
            } else {
                glColor3f(0.6, 0.6, 0.6);
            }
            glRectf(i as f32 / 10.0, j as f32 / 10.0, (i + 1) as f32 / 10.0, (j + 1) as f32 / 10.0);
        }
    }
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0.0, 5.0, 0.0, 6.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT);
    background();
    let image = image();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[1.0, 0.1, 0.1, 0.0]);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (row, format) in FORMATS.into_iter().enumerate() {
        glTexImage2D(GL_TEXTURE_2D, 0, format, N as GLsizei, N as GLsizei, 0, GL_RGBA, GL_UNSIGNED_BYTE, &image);
        for (column, mode) in MODES.into_iter().enumerate() {
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
            let (x, y) = (column as f32 + 0.05, row as f32 + 0.05);
            glBegin(GL_QUADS);
            for [s, t] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                glColor4f(0.9 - 0.7 * t, 0.8 - 0.5 * t, 0.2 + 0.7 * t, 0.5 + 0.5 * s);
                glTexCoord2f(s, t);
                glVertex2f(x + 0.9 * s, y + 0.9 * t);
            }
            glEnd();
        }
    }
    glFlush();
}
