//! The scenes of the report, each written once as a state of the oracle. They are the hard cases of texture mapping: a
//! rolled floor, rings and spokes of every frequency, a plane seen at 89.9 degrees, curved surfaces, projected light with
//! q of one and of both signs, depth from 1e-6 to 1e9, sprites whose sides are no powers of two and whose coordinates lie
//! a million repeats off, and eight units on top of each other. The default setting is trilinear.

use super::oracle::env::{Argument, Combine, Env};
use super::oracle::fragment::{Blend, Fog};
use super::oracle::matrix::M4;
use super::oracle::scene::{Scene, Unit};
use super::oracle::texel::{Image, Texture};
use super::oracle::vertex::{CoordUnit, TexGen, Vertex};
use super::patterns::{self, texture};
use super::translate::as_given;
use fixedgl::enums::*;
use std::f64::consts::PI;

/// Width and height of every picture.
pub const SIZE: u32 = 192;

/// What scenes have in common, for the conclusions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Floors in perspective.
    Floors,
    /// Flat test charts.
    Charts,
    /// Curved surfaces.
    Curved,
    /// Projected textures.
    Projected,
    /// Sprites.
    Sprites,
    /// Several units.
    Units,
}

/// All families with the words for them.
pub const FAMILIES: [(Family, &str); 6] = [
    (Family::Floors, "floors and walls that recede"),
    (Family::Charts, "flat pictures that are turned and scaled"),
    (Family::Curved, "curved surfaces"),
    (Family::Projected, "projected light"),
    (Family::Sprites, "sprites"),
    (Family::Units, "stacks of texture units"),
];

/// How many configurations a scene is drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// All of them.
    Full,
    /// The filters, one anisotropy, one accumulation.
    Medium,
    /// Those of a quick run.
    Short,
}

/// A scene with its name.
pub struct Subject {
    /// Short name.
    pub name: String,
    /// What it shows.
    pub what: &'static str,
    /// What it belongs to.
    pub family: Family,
    /// How many configurations.
    pub depth: Depth,
    /// The state in the default setting.
    pub scene: Scene,
}

/// All scenes.
pub fn all() -> Vec<Subject> {
    let mut subjects = Vec::new();
    let mut add = |name: &str, what, family, depth, scene: Scene| {
        subjects.push(Subject { name: name.to_string(), what, family, depth, scene: as_given(scene) });
    };
    use {Depth::*, Family::*};
    add("plane", "a chequered floor, the camera rolled by 0.35", Floors, Full, plane());
    add("grazing", "a plane seen at 89.9 degrees through a long lens", Floors, Full, grazing());
    add("extremes", "a floor under the eye, near 1e-6, far 1e9, fog", Floors, Medium, extremes());
    for turn in 0..7 {
        let depth = if turn == 3 { Full } else { Short };
        let angle = 15 * turn;
        add(
            &format!("zone {angle:02}"),
            "a zone plate, reduced 3.2 times and turned",
            Charts,
            depth,
            zone(angle.into()),
        );
    }
    add("star large", "a Siemens star of 72 spokes, magnified 8 times", Charts, Medium, star_large());
    add("star small", "a Siemens star of 72 spokes, reduced 8 times", Charts, Full, star_small());
    add("sphere", "a chequered sphere of 4096 triangles", Curved, Medium, sphere());
    add("sphere map", "a torus in a sphere map", Curved, Medium, sphere_map());
    add("spot", "a projected spot, q > 0", Projected, Medium, spot([0.0, 4.0, 2.0], [0.0, -1.0, -6.0]));
    add("spot behind", "a projected spot, q crosses 0", Projected, Medium, spot([0.0, 1.5, -6.0], [0.0, -1.0, -14.0]));
    add("sprites", "100 x 60 sprites, blended, s and t from 1e6 on", Sprites, Medium, sprites());
    add("eight units", "a stack of eight units in eight modes", Units, Medium, eight_units());
    subjects
}

/// A scene of one unit with this texture in a mode.
fn with(image: &Image, mode: GLenum) -> Scene {
    let mut scene = Scene::new(SIZE, SIZE);
    scene.units[0] = unit(texture(image), mode);
    scene.clear = [64.0 / 255.0, 77.0 / 255.0, 102.0 / 255.0, 1.0];
    scene
}

fn unit(texture: Texture, mode: GLenum) -> Unit {
    Unit { texture: Some(texture), env: Env { mode, ..Env::default() } }
}

/// A floor at y = -1 from x = -w to w and from z0 to z1 (far), with s = x / ds, t = z / dt.
fn floor(scene: &mut Scene, w: f64, [z0, z1]: [f64; 2], [ds, dt]: [f64; 2]) {
    let v = |x: f64, z: f64| Vertex::at(x, -1.0, z).st(x / ds, z / dt);
    scene.quad([v(-w, z0), v(w, z0), v(w, z1), v(-w, z1)]);
}

fn plane() -> Scene {
    let mut scene = with(&patterns::checks(256), GL_REPLACE);
    scene.vertex.projection = M4::perspective(60.0, 1.0, 0.25, 400.0);
    let roll = M4::rotation(0.35f64.to_degrees(), [0.0, 0.0, 1.0]);
    scene.vertex.modelview = roll.times(M4::rotation(14.0, [1.0, 0.0, 0.0]));
    scene.depth = Some((GL_LEQUAL, true));
    floor(&mut scene, 240.0, [20.0, -360.0], [4.0, 4.0]);
    scene
}

fn grazing() -> Scene {
    let mut scene = with(&patterns::checks(256), GL_REPLACE);
    scene.vertex.projection = M4::perspective(0.08, 1.0, 10.0, 20_000.0);
    scene.vertex.modelview = M4::rotation(0.1, [1.0, 0.0, 0.0]);
    scene.depth = Some((GL_LEQUAL, true));
    floor(&mut scene, 4.0, [-100.0, -2000.0], [1.0, 40.0]);
    scene
}

fn extremes() -> Scene {
    let mut scene = with(&patterns::checks(256), GL_REPLACE);
    scene.vertex.projection = M4::perspective(75.0, 1.0, 1e-6, 1e9);
    scene.vertex.modelview = M4::rotation(20.0, [1.0, 0.0, 0.0]);
    scene.depth = Some((GL_LEQUAL, true));
    scene.fog = Some(Fog { mode: GL_EXP2, density: 0.06, color: [0.5, 0.6, 0.7, 1.0], ..Fog::default() });
    // Two parts: one reaches behind the eye, the other, with all that is seen of the fog, to the horizon.
    floor(&mut scene, 1e5, [1e4, -0.5], [4.0, 4.0]);
    floor(&mut scene, 1e5, [-0.5, -1e5], [4.0, 4.0]);
    scene
}

/// A square of `side` pixels in the middle of the picture, its texture coordinates from `low` to `high`.
fn square(scene: &mut Scene, side: f64, low: [f64; 2], high: [f64; 2]) {
    let half = f64::from(SIZE) / 2.0;
    scene.vertex.projection = M4::ortho(-half, half, -half, half, -1.0, 1.0);
    let h = side / 2.0;
    let v = |x: f64, y: f64, s: f64, t: f64| Vertex::at(x, y, 0.0).st(s, t);
    let corners = [v(-h, -h, low[0], low[1]), v(h, -h, high[0], low[1]), v(h, h, high[0], high[1])];
    let [a, b, c] = corners;
    scene.quad([a, b, c, v(-h, h, low[0], high[1])]);
}

fn zone(angle: f64) -> Scene {
    let mut scene = with(&patterns::zone_plate(512), GL_REPLACE);
    square(&mut scene, 160.0, [0.0; 2], [1.0; 2]);
    scene.vertex.modelview = M4::rotation(angle, [0.0, 0.0, 1.0]);
    scene
}

fn star_large() -> Scene {
    let mut scene = with(&patterns::star(256, 72.0), GL_REPLACE);
    let texels = f64::from(SIZE) / 8.0 / 256.0;
    square(&mut scene, f64::from(SIZE), [0.61, 0.55], [0.61 + texels, 0.55 + texels]);
    scene
}

fn star_small() -> Scene {
    let mut scene = with(&patterns::star(512, 72.0), GL_REPLACE);
    square(&mut scene, f64::from(SIZE), [0.0; 2], [3.0; 2]);
    scene
}

/// The triangles of a grid of n x m cells on a closed surface: f(u, v) gives a vertex for u and v from 0 to 1.
fn surface(scene: &mut Scene, [n, m]: [u32; 2], f: impl Fn(f64, f64) -> Vertex) {
    let at = |i: u32, j: u32| f(f64::from(i) / f64::from(n), f64::from(j) / f64::from(m));
    for j in 0..m {
        for i in 0..n {
            scene.quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
}

fn curved(scene: &mut Scene, distance: f64) {
    scene.vertex.projection = M4::perspective(40.0, 1.0, 1.0, 20.0);
    scene.vertex.modelview = M4::translation(0.0, 0.0, -distance)
        .times(M4::rotation(35.0, [1.0, 0.0, 0.0]))
        .times(M4::rotation(25.0, [0.0, 1.0, 0.0]));
    scene.vertex.normalize = true;
    scene.cull = Some(GL_BACK);
    scene.depth = Some((GL_LEQUAL, true));
}

fn sphere() -> Scene {
    let image = patterns::colored_checks(256, 8, [0.9, 0.85, 0.7], [0.15, 0.3, 0.5]);
    let mut scene = with(&image, GL_MODULATE);
    curved(&mut scene, 3.3);
    surface(&mut scene, [64, 32], |u, v| {
        let (a, b) = (2.0 * PI * u, PI * (v - 0.5));
        let p = [b.cos() * a.sin(), b.sin(), b.cos() * a.cos()];
        Vertex { normal: p, ..Vertex::at(p[0], p[1], p[2]) }.st(4.0 * u, 2.0 * v).colored([
            0.75 + 0.25 * p[0],
            0.75 + 0.25 * p[1],
            0.75 + 0.25 * p[2],
            1.0,
        ])
    });
    scene
}

fn sphere_map() -> Scene {
    let mut scene = with(&patterns::surroundings(256), GL_REPLACE);
    curved(&mut scene, 4.2);
    let generated = Some(TexGen::new(GL_SPHERE_MAP));
    scene.vertex.units[0].texgen = [generated, generated, None, None];
    surface(&mut scene, [64, 32], |u, v| {
        let (a, b) = (2.0 * PI * u, 2.0 * PI * v);
        let n = [b.cos() * a.sin(), b.sin(), b.cos() * a.cos()];
        let p = [a.sin() + 0.45 * n[0], 0.45 * n[1], a.cos() + 0.45 * n[2]];
        Vertex { normal: n, ..Vertex::at(p[0], p[1], p[2]) }
    });
    scene
}

/// A floor that is lit by a projector at `eye` which looks at `target`, in world coordinates.
fn spot(eye: [f64; 3], target: [f64; 3]) -> Scene {
    let mut scene = with(&patterns::spot(256), GL_MODULATE);
    let view = M4::rotation(22.0, [1.0, 0.0, 0.0]).times(M4::translation(0.0, -1.0, -1.0));
    scene.vertex.projection = M4::perspective(60.0, 1.0, 0.5, 100.0);
    scene.vertex.modelview = view;
    scene.depth = Some((GL_LEQUAL, true));
    let to_texture = M4::translation(0.5, 0.5, 0.5).times(M4::scaling(0.5, 0.5, 0.5));
    let projector =
        to_texture.times(M4::perspective(50.0, 1.0, 0.5, 50.0)).times(M4::look_at(eye, target, [0.0, 1.0, 0.0]));
    let plane = |row: usize| Some(TexGen::new(GL_EYE_LINEAR).set_eye_plane(projector.0[row], view));
    scene.vertex.units[0].texgen = [plane(0), plane(1), plane(2), plane(3)];
    if let Some(texture) = &mut scene.units[0].texture {
        texture.wrap = [GL_CLAMP_TO_BORDER; 3];
        texture.border_color = [0.0, 0.0, 0.0, 1.0];
    }
    // Strips, so that the colour of the floor is not linear over all of it.
    for k in 0..8 {
        let strip = |x: f64, k: i32| {
            let shade = if k % 2 == 0 { [1.0, 0.95, 0.9, 1.0] } else { [0.6, 0.7, 0.8, 1.0] };
            Vertex::at(x, -1.0, 2.0 - 4.0 * f64::from(k)).colored(shade)
        };
        scene.quad([strip(-20.0, k), strip(20.0, k), strip(20.0, k + 1), strip(-20.0, k + 1)]);
    }
    scene
}

fn sprites() -> Scene {
    let mut scene = with(&patterns::sprite(100, 60), GL_REPLACE);
    scene.vertex.projection = M4::ortho(0.0, f64::from(SIZE), 0.0, f64::from(SIZE), -1.0, 1.0);
    scene.blend = Some(Blend::func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    let million = 1_000_000.0;
    let mut sprite = |x: f64, y: f64, scale: f64, turn: f64, offset: f64, repeats: f64| {
        let (sin, cos) = turn.to_radians().sin_cos();
        let v = |a: f64, b: f64| {
            let (dx, dy) = (50.0 * scale * repeats * (2.0 * a - 1.0), 30.0 * scale * repeats * (2.0 * b - 1.0));
            let (px, py) = (x + cos * dx - sin * dy, y + sin * dx + cos * dy);
            Vertex::at(px, py, 0.0).st(offset + repeats * a, offset + repeats * b)
        };
        scene.quad([v(0.0, 0.0), v(1.0, 0.0), v(1.0, 1.0), v(0.0, 1.0)]);
    };
    sprite(96.0, 96.0, 0.5, 30.0, million, 5.0);
    sprite(52.0, 152.0, 1.0, 0.0, 0.0, 1.0);
    sprite(140.25, 150.75, 1.0, 0.0, million, 1.0);
    sprite(60.0, 64.0, 1.5, 0.0, million, 1.0);
    sprite(140.0, 50.0, 1.2, -25.0, -million, 1.0);
    scene
}

fn eight_units() -> Scene {
    let mut scene = with(&patterns::colored_checks(256, 16, [0.8, 0.6, 0.5], [0.3, 0.5, 0.7]), GL_REPLACE);
    let images = [
        patterns::checks(64),
        patterns::colored_checks(128, 8, [0.2, 0.1, 0.3], [0.1, 0.3, 0.2]),
        patterns::sprite(128, 128),
        patterns::star(128, 24.0),
        patterns::zone_plate(64),
        patterns::colored_checks(64, 4, [0.6, 0.5, 0.4], [0.4, 0.5, 0.6]),
        patterns::checks(128),
    ];
    let modes = [GL_MODULATE, GL_ADD, GL_DECAL, GL_COMBINE, GL_BLEND, GL_COMBINE, GL_MODULATE];
    for (k, (image, mode)) in images.iter().zip(modes).enumerate() {
        let mut u = unit(texture(image), mode);
        u.env.color = [0.25, 0.5, 0.75, 0.5];
        let function = if k == 3 { GL_INTERPOLATE } else { GL_ADD_SIGNED };
        let arg = |source, operand| Argument { source, operand };
        u.env.combine = Combine {
            rgb: function,
            alpha: GL_REPLACE,
            rgb_args: [
                arg(GL_TEXTURE, GL_SRC_COLOR),
                arg(GL_PREVIOUS, GL_SRC_COLOR),
                arg(GL_CONSTANT, GL_SRC_ALPHA),
                arg(GL_ZERO, GL_SRC_COLOR),
            ],
            alpha_args: [arg(GL_PREVIOUS, GL_SRC_ALPHA); 4],
            ..Combine::default()
        };
        scene.units.push(u);
    }
    scene.vertex.units = vec![CoordUnit::default(); 8];
    scene.vertex.projection = M4::perspective(50.0, 1.0, 0.5, 50.0);
    scene.vertex.modelview = M4::translation(0.0, 0.0, -4.0).times(M4::rotation(-50.0, [1.0, 0.2, 0.0]));
    let v = |x: f64, y: f64| {
        let mut v = Vertex::at(x, y, 0.0).colored([1.0, 0.9 + 0.02 * x, 0.8 - 0.02 * y, 0.7]);
        v.tex = (0..8).map(|k| [x * (0.5 + 0.2 * f64::from(k)), y * (0.9 - 0.1 * f64::from(k)), 0.0, 1.0]).collect();
        v
    };
    scene.quad([v(-3.0, -3.0), v(3.0, -3.0), v(3.0, 4.0), v(-3.0, 4.0)]);
    scene
}
