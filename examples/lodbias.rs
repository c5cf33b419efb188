//! The bias of the level of detail (after the `lodbias` demo): the same plane five times, with a bias of the texture unit
//! from -2 (sharp and glittering) to +4 (blurred). The bias is added to lambda before the level is chosen.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::checks;

support::port!(
    "lodbias",
    [600, 240],
    "LOD bias -2, -1, 0, 2, 4 on the same receding plane.",
    ["glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias)"]
);

fn init() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    let image = checks(128, 16, [[230, 225, 215], [110, 40, 50]]);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 128, 128, GL_RGB, GL_UNSIGNED_BYTE, &image);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    glClearColor(0.5, 0.65, 0.85, 1.0);
    glClear(GL_COLOR_BUFFER_BIT);
    let width = SIZE[0] as GLsizei / 5;
    for (i, bias) in [-2.0f32, -1.0, 0.0, 2.0, 4.0].into_iter().enumerate() {
        glViewport(i as GLint * width + 2, 2, width - 4, SIZE[1] as GLsizei - 4);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        gluPerspective(60.0, f64::from(width) / f64::from(SIZE[1]), 0.5, 200.0);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glRotatef(15.0, 1.0, 0.0, 0.0);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
        glBegin(GL_QUADS);
        for (s, x) in [(0.0f32, -20.0), (1.0, 20.0)] {
            for z in if s == 0.0 { [0.0f32, -80.0] } else { [-80.0, 0.0] } {
                glTexCoord2f(s * 10.0, z / 4.0);
                glVertex3f(x, -1.5, z);
            }
        }
        glEnd();
    }
    glFlush();
}
