//! Asking before giving (after the Red Book's `texprox`): a proxy target says whether a texture of a size and format would
//! fit, without an image and without an error. The original prints the answers; here they are drawn as a bar chart, a
//! green bar for a size that fits and a red one for a size that does not.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "texprox",
    [440, 200],
    "Which sizes fit, asked of GL_PROXY_TEXTURE_2D: green fits, red does not.",
    [
        "glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL)",
        "glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &mut width)",
    ]
);

/// Asks for a square texture; the width that the proxy reports, 0 where it does not fit.
fn proxy_width(size: GLsizei, format: GLenum) -> GLint {
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, format, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    let mut width: GLint = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &mut width);
    width
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-1.0, 21.0, -1.0, 21.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClearColor(0.15, 0.15, 0.18, 1.0);
    glClear(GL_COLOR_BUFFER_BIT);
    for power in 0..20 {
        let fits = proxy_width(1 << power, GL_RGBA8) != 0;
        if fits {
            glColor3f(0.3, 0.8, 0.4);
        } else {
            glColor3f(0.85, 0.3, 0.25);
        }
        glRecti(power, 0, power + 1, power + 1);
        glColor3f(0.15, 0.15, 0.18);
        glRectf(power as f32, 0.0, power as f32 + 0.1, 21.0);
    }
    glFlush();
}
