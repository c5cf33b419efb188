//! The scenes of the benchmark, a row each: what it draws, what its cost is counted in, how often it is drawn in a long
//! frame, how it is set up and drawn. They are those of the table of the issue on speed, through the methods of
//! [`Context`]; meshes lie in buffer objects.

use super::stage::{Stage, Tex};
use fixedgl::Context;
use fixedgl::enums::*;

/// What the cost of a scene is divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// Fragments: the pixels that the scene covers, times the layers that it draws over them.
    Fragment(f64),
    /// Triangles.
    Triangle,
    /// A megapixel that is cleared or uploaded.
    Million(f64),
}

/// A row of the table.
pub struct Scene {
    /// Short name, for the command line.
    pub id: &'static str,
    /// What it draws.
    pub what: &'static str,
    /// What its cost is counted in.
    pub unit: Unit,
    /// The target in ns a unit, one thread, on the machine that the issue speaks of.
    pub target: f64,
    /// How often it is drawn in the longer of the two frames whose difference is the cost; 1 takes the whole frame.
    pub repeat: u32,
    /// Whether `--quick` draws it.
    pub quick: bool,
    /// Brings a fresh context into the state that it is drawn in.
    pub set_up: fn(&mut Stage),
    /// Draws it once.
    pub draw: fn(&mut Stage),
}

/// One layer of fragments over all that is covered.
const LAYER: Unit = Unit::Fragment(1.0);

/// A row of [`SCENES`].
macro_rules! scene {
    ($id:literal, $what:literal, $unit:expr, $target:literal, $repeat:literal, $quick:literal, $set_up:expr, $draw:expr) => {
        Scene {
            id: $id,
            what: $what,
            unit: $unit,
            target: $target,
            repeat: $repeat,
            quick: $quick,
            set_up: $set_up,
            draw: $draw,
        }
    };
}

/// All scenes.
pub const SCENES: &[Scene] = &[
    scene!("S1", "clear colour and depth", Unit::Fragment(1.0), 0.5, 1, true, clear, draw_clear),
    scene!("S2", "flat quad", LAYER, 0.35, 5, true, flat, Stage::quad),
    scene!("S2z", "flat quad, depth", LAYER, 0.7, 5, true, |s| with_depth(s, flat), Stage::quad),
    scene!("S3", "Gouraud quad", LAYER, 0.9, 5, false, gouraud, Stage::quad),
    scene!("S3z", "Gouraud quad, depth", LAYER, 0.9, 5, true, |s| with_depth(s, gouraud), Stage::quad),
    scene!("S4", "NEAREST, REPLACE, 1:1", LAYER, 1.0, 5, true, nearest, Stage::quad),
    scene!("S4p", "NEAREST, REPLACE, perspective, depth", LAYER, 1.4, 5, true, nearest_tilted, Stage::tilted),
    scene!("S5", "LINEAR, MODULATE, turned", LAYER, 2.8, 5, true, bilinear, Stage::quad),
    scene!("S5p", "LINEAR, MODULATE, perspective, depth", LAYER, 3.0, 5, true, bilinear_tilted, Stage::tilted),
    scene!(
        "S6",
        "plane, LINEAR_MIPMAP_NEAREST",
        LAYER,
        4.2,
        5,
        false,
        |s| ground(s, GL_LINEAR_MIPMAP_NEAREST, 1.0),
        Stage::ground
    ),
    scene!("S7", "plane, trilinear", LAYER, 5.8, 5, true, trilinear, Stage::ground),
    scene!(
        "S8",
        "plane, trilinear, 8x anisotropic",
        LAYER,
        22.0,
        2,
        true,
        |s| ground(s, GL_LINEAR_MIPMAP_LINEAR, 8.0),
        Stage::ground
    ),
    scene!("S9", "plane, trilinear and a light map", LAYER, 7.0, 5, true, two_units, Stage::ground),
    scene!("S10", "LINEAR, MODULATE, blended", LAYER, 3.8, 5, false, blended, Stage::quad),
    scene!("S11", "cube map, reflection, 100,000 triangles", Unit::Triangle, 150.0, 3, false, reflections, Stage::mesh),
    scene!("S12", "sphere map, the same mesh", Unit::Triangle, 110.0, 3, false, sphere_map, Stage::mesh),
    scene!(
        "S13",
        "1 M small lit textured triangles",
        Unit::Triangle,
        100.0,
        2,
        true,
        |s| small_triangles(s, false),
        four_meshes
    ),
    scene!("S13b", "the same, all culled", Unit::Triangle, 12.0, 2, false, |s| small_triangles(s, true), four_meshes),
    scene!("S14", "200,000 triangles, immediate mode", Unit::Triangle, 110.0, 2, true, immediate, draw_immediate),
    scene!("S14d", "the same as a display list", Unit::Triangle, 110.0, 2, false, listed, draw_list),
    scene!("S15f", "8 layers front to back", Unit::Fragment(8.0), 0.5, 1, false, layers, front_to_back),
    scene!("S15b", "8 layers back to front", Unit::Fragment(8.0), 4.0, 1, false, layers, back_to_front),
    scene!("S16", "TexImage2D of 1024 x 1024", Unit::Million(1.0), 0.3, 3, false, |s| uploads(s, false), upload),
    scene!("S16g", "the same with GENERATE_MIPMAP", Unit::Million(1.0), 1.0, 3, false, |s| uploads(s, true), upload),
    scene!("S17", "3D texture, trilinear", LAYER, 5.0, 5, false, solid, draw_solid),
    scene!("S18", "alpha test, fog, texture", LAYER, 5.0, 5, false, alpha_fog, Stage::ground),
];

fn with_depth(s: &mut Stage, set_up: fn(&mut Stage)) {
    set_up(s);
    s.depth(GL_LEQUAL);
}

fn clear(s: &mut Stage) {
    s.gl.clear_color(0.2, 0.4, 0.6, 1.0);
    s.depth(GL_LESS);
}

fn draw_clear(s: &mut Stage) {
    s.gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

fn flat(s: &mut Stage) {
    s.gl.shade_model(GL_FLAT);
    s.gl.color4f(0.8, 0.9, 0.7, 1.0);
    s.colored = false;
}

fn gouraud(s: &mut Stage) {
    s.colored = true;
}

fn nearest(s: &mut Stage) {
    s.texture(Tex { size: 256, min: GL_NEAREST, mag: GL_NEAREST, ..Tex::default() });
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    s.turn(1.0 / 256.0, 0.0);
}

fn nearest_tilted(s: &mut Stage) {
    nearest(s);
    s.tilt();
}

fn bilinear(s: &mut Stage) {
    s.texture(Tex { size: 256, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.colored = true;
    s.turn(0.45 / 256.0, 30.0);
}

fn bilinear_tilted(s: &mut Stage) {
    bilinear(s);
    s.tilt();
}

fn ground(s: &mut Stage, min: GLenum, anisotropy: f32) {
    s.texture(Tex { size: 1024, min, mag: GL_LINEAR, ..Tex::default() });
    s.gl.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    s.stand_on_ground();
}

fn trilinear(s: &mut Stage) {
    ground(s, GL_LINEAR_MIPMAP_LINEAR, 1.0);
}

fn two_units(s: &mut Stage) {
    trilinear(s);
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    s.gl.active_texture(GL_TEXTURE1);
    s.texture(Tex { size: 128, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE0);
    s.units = 2;
}

fn blended(s: &mut Stage) {
    bilinear(s);
    s.texture(Tex { size: 256, min: GL_LINEAR, mag: GL_LINEAR, alpha: true, ..Tex::default() });
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    s.depth(GL_LEQUAL);
    s.gl.depth_mask(false);
}

fn generate(gl: &mut Context, coordinates: &[GLenum], mode: GLenum) {
    for (i, coordinate) in coordinates.iter().enumerate() {
        gl.tex_geni(*coordinate, GL_TEXTURE_GEN_MODE, mode);
        gl.enable(GL_TEXTURE_GEN_S + i as u32);
    }
}

fn reflections(s: &mut Stage) {
    for face in 0..6 {
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        s.texture(Tex { target, size: 256, wrap: GL_CLAMP_TO_EDGE, ..Tex::default() });
    }
    generate(&mut s.gl, &[GL_S, GL_T, GL_R], GL_REFLECTION_MAP);
    s.torus();
}

fn sphere_map(s: &mut Stage) {
    s.texture(Tex { size: 256, ..Tex::default() });
    generate(&mut s.gl, &[GL_S, GL_T], GL_SPHERE_MAP);
    s.torus();
}

fn small_triangles(s: &mut Stage, culled: bool) {
    s.texture(Tex { size: 256, ..Tex::default() });
    let gl = &mut s.gl;
    gl.enable(GL_LIGHTING);
    gl.enable(GL_LIGHT0);
    for (pname, values) in
        [(GL_POSITION, [0.3, 0.4, 0.86, 0.0]), (GL_DIFFUSE, [0.9, 0.85, 0.8, 1.0]), (GL_AMBIENT, [0.2, 0.2, 0.25, 1.0])]
    {
        gl.lightfv(GL_LIGHT0, pname, &values);
    }
    for (pname, values) in [(GL_DIFFUSE, [1.0; 4]), (GL_AMBIENT, [1.0; 4]), (GL_SPECULAR, [0.5, 0.5, 0.5, 1.0])] {
        gl.materialfv(GL_FRONT_AND_BACK, pname, &values);
    }
    gl.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 20.0);
    if culled {
        gl.enable(GL_CULL_FACE);
        gl.cull_face(GL_FRONT);
    }
    s.depth(GL_LEQUAL);
    s.grid(353, 354);
    s.bind_mesh();
    s.triangles *= 4;
}

fn four_meshes(s: &mut Stage) {
    for _ in 0..4 {
        s.mesh();
    }
}

fn immediate(s: &mut Stage) {
    s.texture(Tex { size: 256, ..Tex::default() });
    s.depth(GL_LEQUAL);
    s.grid(316, 316);
}

fn draw_immediate(s: &mut Stage) {
    s.gl.begin(GL_TRIANGLES);
    for i in &s.indices {
        let Some([x, y, z, _, _, nz, u, v]) = s.vertices.get(*i as usize).copied() else { continue };
        s.gl.color4f(nz, 1.0, 1.0, 1.0);
        s.gl.tex_coord2f(u, v);
        s.gl.vertex3f(x, y, z);
    }
    s.gl.end();
}

fn listed(s: &mut Stage) {
    immediate(s);
    s.gl.new_list(1, GL_COMPILE);
    draw_immediate(s);
    s.gl.end_list();
}

fn draw_list(s: &mut Stage) {
    s.gl.call_list(1);
}

fn layers(s: &mut Stage) {
    bilinear(s);
    s.texture(Tex { size: 256, ..Tex::default() });
    s.depth(GL_LESS);
}

fn front_to_back(s: &mut Stage) {
    stack(s, [-0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6].map(|z: f32| -z));
}

fn back_to_front(s: &mut Stage) {
    stack(s, [-0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6]);
}

fn stack(s: &mut Stage, depths: [f32; 8]) {
    draw_clear(s);
    for z in depths {
        s.z = z;
        s.quad();
    }
}

fn uploads(s: &mut Stage, mipmaps: bool) {
    s.texture(Tex { size: 1024, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, i32::from(mipmaps));
    s.upload = super::stage::noise(1024, false);
}

/// An upload and a triangle that needs it.
fn upload(s: &mut Stage) {
    s.gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, &s.upload);
    s.gl.begin(GL_TRIANGLES);
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] {
        s.gl.tex_coord2f(x, y);
        s.gl.vertex3f(8.0 * x, 8.0 * y, 0.0);
    }
    s.gl.end();
}

fn solid(s: &mut Stage) {
    let gl = &mut s.gl;
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        gl.tex_parameteri(GL_TEXTURE_3D, pname, GL_LINEAR);
    }
    let texels = super::stage::noise(512, false);
    gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8, 64, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    gl.enable(GL_TEXTURE_3D);
    s.depth(GL_LEQUAL);
}

fn draw_solid(s: &mut Stage) {
    let (w, h) = (s.size as f32, s.size as f32);
    s.gl.begin(GL_QUADS);
    for ([x, y], [u, v, r]) in [
        ([0.0, 0.0], [0.0, 0.0, 0.0]),
        ([w, 0.0], [3.0, 0.2, 0.5]),
        ([w, h], [3.0, 3.0, 1.0]),
        ([0.0, h], [0.0, 2.8, 0.5]),
    ] {
        s.gl.tex_coord3f(u, v, r);
        s.gl.vertex3f(x, y, 0.0);
    }
    s.gl.end();
}

fn alpha_fog(s: &mut Stage) {
    s.texture(Tex { size: 1024, min: GL_LINEAR_MIPMAP_NEAREST, alpha: true, ..Tex::default() });
    s.stand_on_ground();
    let gl = &mut s.gl;
    gl.enable(GL_ALPHA_TEST);
    gl.alpha_func(GL_GREATER, 0.4);
    gl.enable(GL_FOG);
    gl.fogi(GL_FOG_MODE, GL_EXP2);
    gl.fogf(GL_FOG_DENSITY, 0.03);
    gl.fogfv(GL_FOG_COLOR, &[0.6, 0.65, 0.7, 1.0]);
}
