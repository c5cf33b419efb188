//! The scenes of the benchmark, a row each: what it draws, what its cost is counted in, how often it is drawn in a long
//! frame, how it is set up and drawn. They are those of the table of the issue on speed, through the methods of
//! `Context`. A scene has the same name in both.

use super::setups::*;
use super::stage::{Arrays, Stage};
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
    scene!("S4z", "the same, depth", LAYER, 1.4, 5, false, |s| with_depth(s, nearest), Stage::quad),
    scene!("S4p", "NEAREST, REPLACE, perspective, depth", LAYER, 1.4, 5, true, nearest_tilted, Stage::tilted),
    scene!("S5", "LINEAR, MODULATE, turned", LAYER, 2.8, 5, true, bilinear, Stage::quad),
    scene!("S5z", "the same, depth", LAYER, 3.0, 5, false, |s| with_depth(s, bilinear), Stage::quad),
    scene!("S5p", "LINEAR, MODULATE, perspective, depth", LAYER, 3.0, 5, true, bilinear_tilted, Stage::tilted),
    scene!("S6n", "plane, NEAREST", LAYER, 1.4, 5, false, |s| ground(s, GL_NEAREST, 1.0), Stage::ground),
    scene!("S6l", "plane, LINEAR", LAYER, 3.0, 5, false, |s| ground(s, GL_LINEAR, 1.0), Stage::ground),
    scene!(
        "S6m",
        "plane, NEAREST_MIPMAP_NEAREST",
        LAYER,
        2.5,
        5,
        false,
        |s| ground(s, GL_NEAREST_MIPMAP_NEAREST, 1.0),
        Stage::ground
    ),
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
    scene!("S8a2", "plane, trilinear, 2x anisotropic", LAYER, 14.0, 2, false, |s| anisotropic(s, 2.0), Stage::ground),
    scene!("S8", "plane, trilinear, 8x anisotropic", LAYER, 22.0, 2, true, |s| anisotropic(s, 8.0), Stage::ground),
    scene!(
        "S8a16",
        "plane, trilinear, 16x anisotropic",
        LAYER,
        26.0,
        2,
        false,
        |s| anisotropic(s, 16.0),
        Stage::ground
    ),
    scene!("S9", "plane, trilinear and a light map", LAYER, 7.0, 5, true, two_units, Stage::ground),
    scene!("S10", "LINEAR, MODULATE, blended", LAYER, 3.8, 5, false, blended, Stage::quad),
    scene!(
        "S11",
        "cube map, reflection, 100,000 triangles, client arrays",
        Unit::Triangle,
        150.0,
        3,
        false,
        |s| reflections(s, Arrays::Client),
        Stage::mesh
    ),
    scene!(
        "S11v",
        "the same from buffer objects",
        Unit::Triangle,
        150.0,
        3,
        false,
        |s| reflections(s, Arrays::Buffers),
        Stage::mesh
    ),
    scene!("S12", "sphere map, the same mesh, client arrays", Unit::Triangle, 110.0, 3, false, sphere_map, Stage::mesh),
    scene!(
        "S13",
        "1 M small lit textured triangles, client arrays",
        Unit::Triangle,
        100.0,
        2,
        true,
        |s| small_triangles(s, Arrays::Client),
        four_meshes
    ),
    scene!(
        "S13v",
        "the same from buffer objects",
        Unit::Triangle,
        100.0,
        2,
        false,
        |s| small_triangles(s, Arrays::Buffers),
        four_meshes
    ),
    scene!(
        "S13b",
        "the same, all culled, client arrays",
        Unit::Triangle,
        12.0,
        2,
        false,
        culled_triangles,
        four_meshes
    ),
    scene!("S14", "200,000 triangles, immediate mode", Unit::Triangle, 110.0, 2, true, immediate, draw_immediate),
    scene!("S14d", "the same as a display list", Unit::Triangle, 110.0, 2, false, listed, draw_list),
    scene!("S15f", "8 layers front to back", Unit::Fragment(8.0), 0.5, 1, false, layers, front_to_back),
    scene!("S15b", "8 layers back to front", Unit::Fragment(8.0), 4.0, 1, false, layers, back_to_front),
    scene!(
        "S16",
        "TexImage2D of 1024 x 1024",
        Unit::Million(1.0),
        0.3,
        3,
        false,
        |s| uploads(s, GL_LINEAR, false),
        upload
    ),
    scene!(
        "S16s",
        "TexSubImage2D of 1024 x 1024",
        Unit::Million(1.0),
        0.3,
        3,
        false,
        |s| uploads(s, GL_LINEAR, false),
        upload_part
    ),
    scene!(
        "S16g",
        "TexImage2D with GENERATE_MIPMAP",
        Unit::Million(1.0),
        1.0,
        3,
        false,
        |s| uploads(s, GL_LINEAR_MIPMAP_LINEAR, true),
        upload
    ),
    scene!(
        "S16u",
        "gluBuild2DMipmaps of 1024 x 1024",
        Unit::Million(1.0),
        1.2,
        2,
        false,
        |s| uploads(s, GL_LINEAR_MIPMAP_LINEAR, false),
        upload_by_glu
    ),
    scene!("S17", "3D texture, trilinear", LAYER, 5.0, 5, false, solid, draw_solid),
    scene!("S18", "alpha test, fog, texture", LAYER, 5.0, 5, false, alpha_fog, Stage::ground),
];
