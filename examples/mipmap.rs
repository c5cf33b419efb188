//! A long wall whose mipmap levels have one colour each (after the Red Book's `mipmap`): yellow, magenta, red, green,
//! blue, white. The picture shows at a glance which level each pixel is taken from.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "mipmap",
    [500, 500],
    "Six levels in six colours on a wall that runs away from the viewer.",
    [
        "glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, &image)",
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST)",
    ]
);

const COLORS: [[GLubyte; 4]; 6] = [
    [255, 255, 0, 255],
    [255, 0, 255, 255],
    [255, 0, 0, 255],
    [0, 255, 0, 255],
    [0, 0, 255, 255],
    [255, 255, 255, 255],
];

fn init() {
    glEnable(GL_DEPTH_TEST);
    glShadeModel(GL_FLAT);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut tex_name: GLuint = 0;
    glGenTextures(1, &mut tex_name);
    glBindTexture(GL_TEXTURE_2D, tex_name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (level, color) in COLORS.iter().enumerate() {
        let size = 32 >> level;
        let image = vec![*color; size * size];
        let size = size as GLsizei;
        glTexImage2D(GL_TEXTURE_2D, level as GLint, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, &image);
    }
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

fn display() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_QUADS);
    glTexCoord2f(0.0, 0.0);
    glVertex3f(-2.0, -1.0, 0.0);
    glTexCoord2f(0.0, 8.0);
    glVertex3f(-2.0, 1.0, 0.0);
    glTexCoord2f(8.0, 8.0);
    glVertex3f(2000.0, 1.0, -6000.0);
    glTexCoord2f(8.0, 0.0);
    glVertex3f(2000.0, -1.0, -6000.0);
    glEnd();
    glFlush();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    support::reshape(60.0, SIZE, 1.0, 30000.0);
    glTranslatef(0.0, 0.0, -3.6);
    display();
}
