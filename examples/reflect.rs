//! Environment mapping by a sphere map (after SGI's `reflect` demo): the picture of a chrome ball in a room is painted on a
//! torus by the direction of the reflected view. The map is made by code: for each texel of the ball the reflected ray is
//! followed to a room with a window, a floor of tiles and four walls.

#[path = "support/mod.rs"]
mod support;

use fixedgl::c::*;

support::port!(
    "reflect",
    [512, 384],
    "A chrome torus: SPHERE_MAP with a map that shows a tiled floor and a window. In the corner the map itself.",
    ["glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP)", "glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP)",]
);

const N: usize = 256;

/// The colour of the room in a direction.
fn room([x, y, z]: [f32; 3]) -> [GLubyte; 3] {
    if y < 0.0 && -y > 0.3 * (x.abs().max(z.abs())) {
        let (u, v) = ((4.0 * x / -y + 40.0) as i32, (4.0 * z / -y + 40.0) as i32);
        return if (u + v) % 2 == 0 { [190, 170, 140] } else { [70, 45, 35] };
    }
    let window = z > 0.35 && y > 0.1 && y < 0.75 && x.abs() < 0.45;
    let frame = (x.abs() % 0.225) < 0.02 || ((y - 0.1) % 0.325) < 0.02;
    match () {
        () if window && !frame => [225, 240, 255],
        () if window => [60, 50, 45],
        () if y > 0.8 => [235, 230, 220],
        () => [(120.0 + 60.0 * x) as GLubyte, (130.0 + 40.0 * y) as GLubyte, (150.0 - 40.0 * z) as GLubyte],
    }
}

/// The texel of the map at (s, t): a mirror ball seen along -z reflects the view into direction r.
fn map_texel(i: usize) -> [GLubyte; 3] {
    let (s, t) = (((i % N) as f32 + 0.5) / N as f32, ((i / N) as f32 + 0.5) / N as f32);
    let (nx, ny) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    let r2 = nx * nx + ny * ny;
    if r2 >= 1.0 {
        return [40, 35, 35];
    }
    let nz = (1.0 - r2).sqrt();
    room([2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0])
}

fn init() {
    let map: Vec<[GLubyte; 3]> = (0..N * N).map(map_texel).collect();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, N as GLsizei, N as GLsizei, GL_RGB, GL_UNSIGNED_BYTE, &map);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

/// The map itself in the lower left corner.
fn show_map() {
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluOrtho2D(0.0, f64::from(SIZE[0]), 0.0, f64::from(SIZE[1]));
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    glBegin(GL_QUADS);
    for [s, t] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        glTexCoord2f(s, t);
        glVertex2f(8.0 + 96.0 * s, 8.0 + 96.0 * t);
    }
    glEnd();
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
}

/// Draws the scene into the current context.
pub(crate) fn draw() {
    init();
    support::reshape(40.0, SIZE, 1.0, 30.0);
    glClearColor(0.3, 0.33, 0.38, 1.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    show_map();
    glEnable(GL_DEPTH_TEST);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glEnable(GL_NORMALIZE);
    glTranslatef(0.0, 0.0, -6.0);
    glRotatef(-55.0, 1.0, 0.2, 0.0);
    support::shapes::solid_torus(0.7, 1.5, 48, 72);
    glFlush();
}
