//! Cube maps (after the Red Book's `cubemap`): six checkerboards in six colours around a sphere. Left: NORMAL_MAP, the
//! texture looks at the normal; right: REFLECTION_MAP, the texture looks along the mirrored view, so the environment
//! stays where it is when the sphere turns.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;
use support::textures::checks;

support::port!(
    "cubemap",
    [512, 256],
    "Six coloured faces on two spheres: NORMAL_MAP and REFLECTION_MAP.",
    [
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGB, 32, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, &image)",
        "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP)",
    ]
);

const COLORS: [[GLubyte; 3]; 6] =
    [[255, 60, 60], [60, 255, 255], [60, 255, 60], [255, 60, 255], [80, 80, 255], [255, 255, 60]];

fn init() {
    glEnable(GL_DEPTH_TEST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for wrap in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
        glTexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_TRUE);
    for (face, color) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(&COLORS) {
        let image = checks(32, 4, [*color, color.map(|c| c / 3)]);
        glTexImage2D(face, 0, GL_RGB, 32, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, &image);
    }
    glEnable(GL_TEXTURE_CUBE_MAP);
    for cap in [GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R] {
        glEnable(cap);
    }
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, &[1.0, 1.0, 1.0, 1.0]);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &[0.5, 0.5, 0.5, 1.0]);
}

fn ball(x: f32, mode: GLenum) {
    for coord in [GL_S, GL_T, GL_R] {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, mode);
    }
    glPushMatrix();
    glTranslatef(x, 0.0, 0.0);
    glRotatef(25.0, 1.0, 0.5, 0.0);
    support::shapes::textured_sphere(1.2, 40, 30);
    glPopMatrix();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    support::reshape(40.0, SIZE, 1.0, 30.0);
    glTranslatef(0.0, 0.0, -5.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    ball(-1.4, GL_NORMAL_MAP);
    ball(1.4, GL_REFLECTION_MAP);
    glFlush();
}
