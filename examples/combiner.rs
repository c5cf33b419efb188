//! Texture combiners (after the Red Book's `combiner`): one picture, eight functions of it and the colour beneath. Top
//! row: the texture, the colour, MODULATE, ADD; bottom row: ADD_SIGNED, SUBTRACT, INTERPOLATE by the constant's alpha,
//! and DOT3 of the texture as a normal map with the light's direction as the colour.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "combiner",
    [512, 256],
    "Texture, colour, MODULATE, ADD / ADD_SIGNED, SUBTRACT, INTERPOLATE, DOT3 on a bump map.",
    [
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE)",
        "glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB)",
        "glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR)",
    ]
);

const N: usize = 64;

fn texture(texel: impl Fn(f32, f32) -> [GLubyte; 3]) -> GLuint {
    let centre = |i: usize| (i as f32 + 0.5) / N as f32;
    let image: Vec<[GLubyte; 3]> = (0..N * N).map(|i| texel(centre(i % N), centre(i / N))).collect();
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, N as GLsizei, N as GLsizei, 0, GL_RGB, GL_UNSIGNED_BYTE, &image);
    name
}

/// A vector of unit length as a colour: components from [-1, 1] to [0, 255].
fn as_color(v: [f32; 3]) -> [GLubyte; 3] {
    let length = v.iter().map(|c| c * c).sum::<f32>().sqrt();
    v.map(|c| (127.5 * (c / length) + 128.0) as GLubyte)
}

/// The normals of a dome in the middle of a plane.
fn dome(x: f32, y: f32) -> [GLubyte; 3] {
    let (dx, dy) = (2.0 * x - 1.0, 2.0 * y - 1.0);
    let r2 = dx * dx + dy * dy;
    as_color(if r2 < 0.7 { [dx, dy, (1.0 - r2).sqrt()] } else { [0.0, 0.0, 1.0] })
}

/// A square whose colour runs from dark red at the bottom to light green at the top, or one colour throughout.
fn square(i: usize, color: Option<[GLubyte; 3]>) {
    let (x, y) = ((i % 4) as f32 + 0.03, (1 - i / 4) as f32 + 0.03);
    glBegin(GL_QUADS);
    for [s, t] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        match color {
            Some(color) => glColor3ubv(&color),
            None => glColor3f(0.6 - 0.3 * t, 0.2 + 0.6 * t, 0.25),
        }
        glTexCoord2f(s, t);
        glVertex2f(x + 0.94 * s, y + 0.94 * t);
    }
    glEnd();
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    let rings = texture(|x, y| {
        let r = ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)).sqrt();
        if (12.0 * r) as i32 % 2 == 0 { [230, 220, 200] } else { [60, 80, 110] }
    });
    let normals = texture(dome);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0.0, 4.0, 0.0, 2.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, rings);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.0, 0.0, 0.0, 0.3]);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_CONSTANT);
    let functions = [GL_REPLACE, GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_SUBTRACT, GL_INTERPOLATE];
    for (i, function) in functions.into_iter().enumerate() {
        glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, if i == 1 { GL_PRIMARY_COLOR } else { GL_TEXTURE });
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, function);
        square(i, None);
    }
    glBindTexture(GL_TEXTURE_2D, normals);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    square(7, Some(as_color([-0.5, 0.6, 0.6])));
    glFlush();
}
