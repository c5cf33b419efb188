//! E_spec stage by stage, seen from outside through GL's own words. The framebuffer holds floats, so what a stage computes
//! is not hidden by 8 bits; the state of the scene stays, but its texture becomes an instrument:
//!
//! - window position: a vertex is drawn as a point and the projection moved until it hops to the next pixel;
//! - s and t: columns (in red) and rows (in green) are black and white in turn under LINEAR, a slope of 1 a texel;
//! - lambda: levels are black and white in turn, trilinear, a slope of 1 a level;
//! - filtered texel: the scene's own texture, REPLACE; environment: its modes over textures of one texel;
//! - fog: white becomes black, so the colour is f; depth: read back.
//!
//! The oracle draws the very same state, and the difference of the two is the error in the stage's own unit.

use super::gl::{Gl, Library};
use super::metrics::p999;
use super::oracle::env::Env;
use super::oracle::scene::Scene;
use super::oracle::texel::{Image, Texture};
use super::oracle::vertex::Vertex;
use super::translate;
use fixedgl::enums::*;

/// What is observed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Position,
    Coordinates,
    Lambda,
    Texel,
    Environment,
    Fog,
    Depth,
}

/// All stages with their names and units.
pub const STAGES: [(Stage, &str, &str); 7] = [
    (Stage::Position, "window position", "pixels"),
    (Stage::Coordinates, "s, t", "texels"),
    (Stage::Lambda, "lambda", "levels"),
    (Stage::Texel, "filtered texel", "LSB"),
    (Stage::Environment, "environment", "LSB"),
    (Stage::Fog, "fog", "LSB"),
    (Stage::Depth, "depth", "steps of 24 bits"),
];

/// The figures of a stage.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    /// The greatest error.
    pub max: f64,
    /// Root of the mean square.
    pub rmse: f64,
    /// What a thousandth exceeds.
    pub p999: f64,
    /// How many values were compared.
    pub count: usize,
}

impl Figures {
    fn of(errors: Vec<f64>) -> Option<Figures> {
        let count = errors.len();
        let squares: f64 = errors.iter().map(|e| e * e).sum();
        let max = errors.iter().copied().fold(0.0, f64::max);
        let rmse = (squares / count.max(1) as f64).sqrt();
        (count > 0).then(|| Figures { max, rmse, p999: p999(errors), count })
    }
}

/// What the oracle says about a stage of a scene.
pub struct Expected {
    stage: Stage,
    scene: Scene,
    /// A value a pixel (colours from 0 to 1, or depth in the first place), where something is drawn.
    values: Vec<Option<[f64; 4]>>,
}

/// The colours of the texels of the environment's instrument.
const TEXELS: [[u8; 4]; 8] = [
    [201, 90, 33, 180],
    [240, 180, 200, 140],
    [30, 40, 20, 220],
    [90, 200, 60, 77],
    [180, 20, 150, 120],
    [60, 130, 220, 200],
    [140, 150, 110, 60],
    [220, 230, 240, 250],
];

fn trilinear(mut texture: Texture) -> Texture {
    texture.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    texture
}

/// The scene in which a stage is observed; `scene` is in its default setting.
fn observed(stage: Stage, scene: &Scene) -> Option<Scene> {
    let mut scene = scene.clone();
    scene.clear = [0.0; 4];
    scene.blend = None;
    if stage != Stage::Fog {
        scene.fog = None;
    }
    let replace = Env { mode: GL_REPLACE, ..Env::default() };
    let own = scene.units[0].texture.clone();
    let only = |scene: &mut Scene, texture: Option<Texture>| {
        scene.units.truncate(1);
        scene.vertex.units.truncate(1);
        scene.triangles.iter_mut().flatten().for_each(|v| v.tex.truncate(1));
        scene.units[0].texture = texture;
        scene.units[0].env = replace;
    };
    match stage {
        Stage::Coordinates => {
            let mut texture = own?;
            let [w, h, _] = texture.levels[0][0].size;
            let odd = |i: i64| f64::from(u8::from(i & 1 == 1));
            texture.levels = vec![vec![Image::from_fn(w, h, |i, j| [odd(i), odd(j), 0.0, 1.0])]];
            texture.lod.min_filter = GL_LINEAR;
            only(&mut scene, Some(texture));
        }
        Stage::Lambda => {
            let mut texture = trilinear(own?);
            texture.wrap = [GL_REPEAT; 3];
            for (level, faces) in texture.levels.iter_mut().enumerate() {
                let v = if level % 2 == 1 { 1.0 } else { 0.0 };
                faces[0].texels.fill([v, v, v, 1.0]);
            }
            only(&mut scene, Some(texture));
        }
        Stage::Texel => only(&mut scene, own),
        Stage::Environment => {
            for (unit, color) in scene.units.iter_mut().zip(TEXELS) {
                if let Some(texture) = &mut unit.texture {
                    let color = color.map(|c| f64::from(c) / 255.0);
                    texture.levels = vec![vec![Image::from_fn(1, 1, |_, _| color)]];
                    texture.wrap = [GL_REPEAT; 3];
                    (texture.lod.min_filter, texture.lod.mag_filter) = (GL_NEAREST, GL_NEAREST);
                }
            }
        }
        Stage::Fog => {
            scene.fog.as_mut()?.color = [0.0; 4];
            only(&mut scene, None);
            scene.triangles.iter_mut().flatten().for_each(|v| v.color = [1.0; 4]);
        }
        Stage::Position => only(&mut scene, None),
        Stage::Depth => {
            scene.depth?;
            only(&mut scene, None);
        }
    }
    Some(scene)
}

/// The oracle's side of every stage that the scene has.
pub fn expected(scene: &Scene) -> Vec<Expected> {
    let one = |(stage, _, _): (Stage, &str, &str)| {
        let scene = observed(stage, scene)?;
        let values = if stage == Stage::Position { Vec::new() } else { values(stage, &scene) };
        Some(Expected { stage, scene, values })
    };
    STAGES.into_iter().filter_map(one).collect()
}

fn values(stage: Stage, scene: &Scene) -> Vec<Option<[f64; 4]>> {
    let value = |p: &super::oracle::scene::Pixel| {
        let v = if stage == Stage::Depth { [p.depth, 0.0, 0.0, 0.0] } else { p.ideal };
        (p.hits > 0).then_some(v)
    };
    scene.render().pixels.iter().map(value).collect()
}

/// The errors of a library in the stages that were expected.
pub fn measure(library: &dyn Library, expected: &[Expected]) -> Vec<(Stage, Option<Figures>)> {
    expected.iter().map(|e| (e.stage, one(library, e))).collect()
}

fn one(library: &dyn Library, e: &Expected) -> Option<Figures> {
    let mut gl = library.open([e.scene.width, e.scene.height], e.stage != Stage::Position);
    translate::state(gl.as_mut(), &e.scene);
    if e.stage == Stage::Position {
        return Figures::of(positions(gl.as_mut(), &e.scene));
    }
    translate::picture(gl.as_mut());
    if e.stage == Stage::Depth {
        let depths = gl.depths();
        let steps = |v: u32| f64::from(v) / f64::from(u32::MAX) * f64::from((1 << 24) - 1);
        let error = |(want, got): (&Option<[f64; 4]>, &u32)| {
            want.map(|w| (steps(*got) - w[0] * f64::from((1 << 24) - 1)).abs())
        };
        return Figures::of(e.values.iter().zip(&depths).filter_map(error).collect());
    }
    let scale = if matches!(e.stage, Stage::Coordinates | Stage::Lambda) { 1.0 } else { 255.0 };
    let error = |(want, got): (&Option<[f64; 4]>, &[f32; 4])| {
        want.map(|w| scale * (0..3).map(|c| (f64::from(got[c]) - w[c].clamp(0.0, 1.0)).abs()).fold(0.0, f64::max))
    };
    Figures::of(e.values.iter().zip(&gl.floats()).filter_map(error).collect())
}

/// How many vertices of a scene have their place measured, and to how many halvings of a pixel.
const POINTS: usize = 12;
const HALVINGS: u32 = 16;

/// The errors of the window coordinates of some vertices, in pixels.
fn positions(gl: &mut dyn Gl, scene: &Scene) -> Vec<f64> {
    let size = [f64::from(scene.width), f64::from(scene.height)];
    let window = |v: &Vertex| {
        let clip = scene.vertex.run(v).clip;
        let w = scene.viewport.window(clip);
        let seen = clip[3] > 0.0 && clip[2].abs() <= clip[3];
        let inside = [w.x, w.y].iter().zip(size).all(|(p, n)| *p > 2.0 && *p < n - 2.0);
        (seen && inside).then_some([w.x, w.y])
    };
    let mut places: Vec<(&Vertex, [f64; 2])> =
        scene.triangles.iter().flatten().filter_map(|v| Some((v, window(v)?))).collect();
    places.dedup_by_key(|(_, at)| *at);
    let step = places.len().div_ceil(POINTS).max(1);
    let mut errors = Vec::new();
    gl.disable(GL_CULL_FACE);
    gl.disable(GL_DEPTH_TEST);
    for (vertex, at) in places.into_iter().step_by(step) {
        for axis in 0..2 {
            errors.push((hop(gl, scene, vertex, axis) - at[axis]).abs());
        }
    }
    errors
}

/// The window coordinate of a vertex on an axis: how far it has to be moved to enter the next pixel.
fn hop(gl: &mut dyn Gl, scene: &Scene, vertex: &Vertex, axis: usize) -> f64 {
    let mut pixel = |by: f64| {
        translate::projection(gl, scene, if axis == 0 { [by, 0.0] } else { [0.0, by] });
        gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.begin(GL_POINTS);
        translate::vertex(gl, &Vertex { color: [1.0; 4], ..vertex.clone() });
        gl.end();
        let place = gl.bytes().iter().position(|c| c[0] > 0).unwrap_or(0);
        let width = scene.width as usize;
        if axis == 0 { place % width } else { place / width }
    };
    let first = pixel(0.0);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if pixel(middle) == first { low = middle } else { high = middle }
    }
    first as f64 + 1.0 - high
}

/// Pixels that a library covers a different number of times than the oracle, without any test: (missing, doubled).
pub fn coverage(library: &dyn Library, scene: &Scene) -> (usize, usize) {
    let Some(mut scene) = observed(Stage::Position, scene) else { return (0, 0) };
    scene.depth = None;
    scene.triangles.iter_mut().flatten().for_each(|v| v.color = [1.0 / 255.0; 4]);
    let hits: Vec<u32> = scene.render().pixels.iter().map(|p| p.hits).collect();
    let mut gl = library.open([scene.width, scene.height], false);
    translate::state(gl.as_mut(), &scene);
    gl.enable(GL_BLEND);
    gl.blend_func(GL_ONE, GL_ONE);
    translate::picture(gl.as_mut());
    let got = gl.bytes();
    let pairs = || got.iter().zip(&hits).map(|(g, h)| (u32::from(g[0]), *h));
    (pairs().filter(|(g, h)| g < h).count(), pairs().filter(|(g, h)| g > h).count())
}
