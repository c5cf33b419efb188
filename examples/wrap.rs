//! Every wrap mode on the same square (after the Red Book's `wrap`): coordinates from -1 to 2 in both directions, so the
//! texture itself is the middle ninth. From left to right and bottom to top: REPEAT, MIRRORED_REPEAT, CLAMP with LINEAR
//! (half of the border colour at the edge), CLAMP_TO_EDGE, CLAMP_TO_BORDER, and REPEAT in s with CLAMP_TO_EDGE in t.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "wrap",
    [480, 320],
    "REPEAT, MIRRORED_REPEAT, CLAMP / CLAMP_TO_EDGE, CLAMP_TO_BORDER, REPEAT x CLAMP_TO_EDGE; coordinates -1 to 2.",
    [
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER)",
        "glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0, 0.8, 0.0, 1.0])",
    ]
);

/// An arrow-like pattern without any symmetry, so that mirroring shows.
fn image() -> Vec<[GLubyte; 3]> {
    let texel = |i: usize| {
        let (x, y) = (i % 8, i / 8);
        match (x, y) {
            (1, 1..=6) | (2..=5, 6) | (2..=4, 4) => [235, 235, 235],
            _ => [40 + 20 * x as u8, 70, 60 + 20 * y as u8],
        }
    };
    (0..64).map(texel).collect()
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, &image());
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0, 0.8, 0.0, 1.0]);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0.0, 3.0, 0.0, 2.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClearColor(0.1, 0.1, 0.1, 1.0);
    glClear(GL_COLOR_BUFFER_BIT);
    let modes = [
        (GL_REPEAT, GL_REPEAT, GL_NEAREST),
        (GL_MIRRORED_REPEAT, GL_MIRRORED_REPEAT, GL_NEAREST),
        (GL_CLAMP, GL_CLAMP, GL_LINEAR),
        (GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_NEAREST),
        (GL_CLAMP_TO_BORDER, GL_CLAMP_TO_BORDER, GL_NEAREST),
        (GL_REPEAT, GL_CLAMP_TO_EDGE, GL_LINEAR),
    ];
    for (i, (s, t, filter)) in modes.into_iter().enumerate() {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, s);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, t);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        let (x, y) = ((i % 3) as f32 + 0.03, (i / 3) as f32 + 0.03);
        glBegin(GL_QUADS);
        for [a, b] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            glTexCoord2f(3.0 * a - 1.0, 3.0 * b - 1.0);
            glVertex2f(x + 0.94 * a, y + 0.94 * b);
        }
        glEnd();
    }
    glFlush();
}
