//! Scenes that many chapters use: a quad that fills the window, a floor that runs to the horizon, a heap of random
//! triangles in perspective, a ball with normals.

use super::Random;
use crate::oracle::env::Env;
use crate::oracle::matrix::M4;
use crate::oracle::scene::{Scene, Unit};
use crate::oracle::texel::Texture;
use crate::oracle::vertex::Vertex;
use fixedgl::enums::*;

/// A unit that replaces the colour by the texture's.
pub fn replace(texture: Texture) -> Unit {
    Unit { texture: Some(texture), env: Env { mode: GL_REPLACE, ..Env::default() } }
}

/// A quad that fills the window, texture coordinates from `low` at the lower left to `high` at the upper right.
pub fn facing(width: u32, height: u32, low: [f64; 2], high: [f64; 2]) -> Scene {
    let mut scene = Scene::new(width, height);
    let v = |x: f64, y: f64| {
        let at = |k: usize, u: f64| if u > 0.0 { high[k] } else { low[k] };
        Vertex::at(x, y, 0.0).st(at(0, x), at(1, y))
    };
    scene.quad([v(-1.0, -1.0), v(1.0, -1.0), v(1.0, 1.0), v(-1.0, 1.0)]);
    scene
}

/// A floor 1 below the eye, from behind the eye to `far` in front of it, `repeat` textures a unit of length, turned by
/// `angle` degrees so that no axis of the texture is one of the window.
pub fn floor(width: u32, height: u32, far: f64, repeat: f64, angle: f64) -> Scene {
    let mut scene = Scene::new(width, height);
    scene.vertex.projection = M4::perspective(60.0, f64::from(width) / f64::from(height), 0.125, 4.0 * far);
    scene.vertex.modelview = M4::rotation(15.0, [1.0, 0.0, 0.0]).times(M4::translation(0.0, -1.0, 0.0));
    let turn = M4::rotation(angle, [0.0, 1.0, 0.0]);
    let v = |x: f64, z: f64| {
        let p = turn.apply([x, 0.0, z, 1.0]);
        Vertex::at(x, 0.0, z).st(p[0] * repeat, p[2] * repeat)
    };
    scene.quad([v(-far, 4.0), v(far, 4.0), v(far, -far), v(-far, -far)]);
    scene
}

/// `n` random triangles in perspective with random colours, normals and texture coordinates within `range`.
pub fn heap(width: u32, height: u32, n: usize, range: f64, seed: u64) -> Scene {
    let mut random = Random(seed);
    let mut scene = Scene::new(width, height);
    scene.vertex.projection = M4::perspective(70.0, f64::from(width) / f64::from(height), 0.5, 100.0);
    for _ in 0..n {
        let vertex = |random: &mut Random| {
            let z = random.range(-12.0, -1.5);
            let mut v = Vertex::at(random.range(-1.2, 1.2) * z, random.range(-1.2, 1.2) * z, z);
            v.color = std::array::from_fn(|_| random.range(0.0, 1.0));
            v.secondary = [random.range(0.0, 0.5), random.range(0.0, 0.5), random.range(0.0, 0.5), 1.0];
            v.fog_coord = random.range(0.0, 10.0);
            v.strq([random.range(-range, range), random.range(-range, range), random.range(-range, range), 1.0])
        };
        scene.triangles.push([vertex(&mut random), vertex(&mut random), vertex(&mut random)]);
    }
    scene
}

/// A ball of radius 1 at z = -3, with normals; texture coordinates are longitude and latitude.
pub fn ball(width: u32, height: u32) -> Scene {
    let mut scene = Scene::new(width, height);
    scene.vertex.projection = M4::perspective(45.0, f64::from(width) / f64::from(height), 1.0, 10.0);
    scene.vertex.modelview = M4::translation(0.0, 0.0, -3.0).times(M4::rotation(20.0, [1.0, 0.5, 0.0]));
    let (rings, sides) = (8, 12);
    let v = |ring: i32, side: i32| {
        let (s, t) = (f64::from(side) / f64::from(sides), f64::from(ring) / f64::from(rings));
        let (around, up) = ((s * 360.0).to_radians(), (t * 180.0).to_radians());
        let n = [up.sin() * around.cos(), -up.cos(), up.sin() * around.sin()];
        let mut v = Vertex::at(n[0], n[1], n[2]).st(s, t).colored([s, t, 1.0 - s, 0.25 + t / 2.0]);
        v.normal = n;
        v
    };
    for ring in 0..rings {
        for side in 0..sides {
            scene.quad([v(ring, side), v(ring + 1, side), v(ring + 1, side + 1), v(ring, side + 1)]);
        }
    }
    scene.cull = Some(GL_BACK);
    scene
}
