//! What a model without texture coordinates is textured with: an environment made by code (or an image of the user's) and
//! GL's coordinate generation in its four ways.

use super::support::textures::{Image, checks};
use fixedgl::Context;
use fixedgl::c::*;

/// How texture coordinates are generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Generation {
    /// `GL_REFLECTION_MAP` into a cube map.
    Reflection,
    /// `GL_SPHERE_MAP`.
    Sphere,
    /// `GL_OBJECT_LINEAR`: the pattern sticks to the model.
    Object,
    /// `GL_EYE_LINEAR`: the model moves through the pattern.
    Eye,
}

impl Generation {
    /// The way of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "reflection" => Self::Reflection,
            "sphere" => Self::Sphere,
            "object" => Self::Object,
            "eye" => Self::Eye,
            _ => return None,
        })
    }
}

const SIDE: usize = 128;

/// The colour of the surroundings in a direction: a sky with a sun and soft boxes of light over a tiled ground.
fn surroundings([x, y, z]: [f32; 3]) -> [u8; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    let (dx, dy, dz) = (x / length, y / length, z / length);
    if dy < -0.02 {
        let (u, v) = ((3.0 * dx / -dy + 300.0) as i32, (3.0 * dz / -dy + 300.0) as i32);
        let fade = (-dy * 2.0).min(1.0);
        let tile: [f32; 3] = if (u + v) % 2 == 0 { [205.0, 190.0, 165.0] } else { [105.0, 85.0, 75.0] };
        return tile.map(|c| (160.0 + (c - 160.0) * fade) as u8);
    }
    let sun = dx * 0.48 + dy * 0.72 + dz * 0.5;
    let panel = dz > 0.3 && dx < -0.25 && dx > -0.75 && dy > 0.15 && dy < 0.7;
    match () {
        () if sun > 0.97 || panel => [255, 250, 240],
        () => {
            let t = dy.sqrt();
            [(215.0 - 150.0 * t) as u8, (225.0 - 110.0 * t) as u8, (235.0 - 50.0 * t) as u8]
        }
    }
}

/// The direction of texel (s, t) of a face, by table 3.19 read backwards.
fn direction(face: usize, s: f32, t: f32) -> [f32; 3] {
    let (sc, tc) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    match face {
        0 => [1.0, -tc, -sc],
        1 => [-1.0, -tc, sc],
        2 => [sc, 1.0, tc],
        3 => [sc, -1.0, -tc],
        4 => [sc, -tc, 1.0],
        _ => [-sc, -tc, -1.0],
    }
}

fn image(texel: impl Fn(f32, f32) -> [u8; 3]) -> Image {
    let centre = |i: usize| (i as f32 + 0.5) / SIDE as f32;
    (0..SIDE * SIDE).map(|i| texel(centre(i % SIDE), centre(i / SIDE))).collect()
}

fn parameters(cx: &mut Context, target: GLenum, wrap: GLenum) {
    for coordinate in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
        cx.tex_parameteri(target, coordinate, wrap);
    }
    cx.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    cx.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    cx.tex_parameteri(target, GL_GENERATE_MIPMAP, GL_TRUE);
}

fn texture_2d(cx: &mut Context, own: Option<GLuint>, made: impl FnOnce() -> Image, wrap: GLenum) {
    match own {
        Some(name) => cx.bind_texture(GL_TEXTURE_2D, name),
        None => {
            let mut names = [0];
            cx.gen_textures(1, &mut names);
            cx.bind_texture(GL_TEXTURE_2D, names[0]);
            parameters(cx, GL_TEXTURE_2D, wrap);
            let side = SIDE as GLsizei;
            cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, &made());
        }
    }
    cx.enable(GL_TEXTURE_2D);
}

/// A cube map of the surroundings.
fn sky(cx: &mut Context) {
    let mut names = [0];
    cx.gen_textures(1, &mut names);
    cx.bind_texture(GL_TEXTURE_CUBE_MAP, names[0]);
    parameters(cx, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    for face in 0..6 {
        let picture = image(|s, t| surroundings(direction(face, s, t)));
        let (target, side) = (GL_TEXTURE_CUBE_MAP_POSITIVE_X + face as GLenum, SIDE as GLsizei);
        cx.tex_image_2d(target, 0, GL_RGB8, side, side, 0, GL_RGB, GL_UNSIGNED_BYTE, &picture);
    }
    cx.enable(GL_TEXTURE_CUBE_MAP);
}

/// A sphere map of the surroundings: the texel at (s, t) shows what a mirror ball reflects there.
fn mirror_ball(s: f32, t: f32) -> [u8; 3] {
    let (nx, ny) = (2.0 * s - 1.0, 2.0 * t - 1.0);
    let nz = (1.0 - nx * nx - ny * ny).max(0.0).sqrt();
    surroundings([2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0])
}

const COORDINATES: [(GLenum, GLenum); 3] =
    [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R)];

fn mode(cx: &mut Context, count: usize, mode: GLenum) {
    for (coordinate, cap) in &COORDINATES[..count] {
        cx.tex_geni(*coordinate, GL_TEXTURE_GEN_MODE, mode);
        cx.enable(*cap);
    }
}

/// Switches texturing and generation on. Planes are scaled so that a pattern repeats a few times over the model, whose
/// bounding sphere is given; eye planes are taken as they are when this is called, in the coordinates of the model.
pub fn generate(cx: &mut Context, generation: Generation, own: Option<GLuint>, (centre, radius): ([f32; 3], f32)) {
    let scale = 1.5 / radius.max(1e-30);
    let plane = |axis: usize| {
        let mut plane = [0.0; 4];
        plane[axis] = scale;
        plane[3] = -scale * centre[axis];
        plane
    };
    let pattern = || checks(SIDE, SIDE / 4, [[235, 230, 220], [70, 110, 160]]);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    match generation {
        Generation::Reflection => {
            sky(cx);
            mode(cx, 3, GL_REFLECTION_MAP);
        }
        Generation::Sphere => {
            texture_2d(cx, own, || image(mirror_ball), GL_CLAMP_TO_EDGE);
            mode(cx, 2, GL_SPHERE_MAP);
        }
        Generation::Object => {
            texture_2d(cx, own, pattern, GL_REPEAT);
            mode(cx, 2, GL_OBJECT_LINEAR);
            cx.tex_genfv(GL_S, GL_OBJECT_PLANE, &plane(0));
            cx.tex_genfv(GL_T, GL_OBJECT_PLANE, &plane(1));
        }
        Generation::Eye => {
            texture_2d(cx, own, pattern, GL_REPEAT);
            mode(cx, 2, GL_EYE_LINEAR);
            cx.push_matrix();
            cx.load_identity();
            cx.tex_genfv(GL_S, GL_EYE_PLANE, &[scale, 0.0, 0.0, 0.0]);
            cx.tex_genfv(GL_T, GL_EYE_PLANE, &[0.0, scale, 0.0, 0.0]);
            cx.pop_matrix();
        }
    }
    if matches!(generation, Generation::Reflection | Generation::Sphere) {
        // A mirror shows its surroundings as they are, with a little of the lights' shading.
        cx.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[1.0, 1.0, 1.0, 1.0]);
    }
}
