//! Level of detail (OpenGL 1.5, section 3.8.8). A pyramid whose levels are black and white in turn shows lambda in a
//! trilinear picture: the colour between level d and d + 1 is the fraction of lambda. Three further units that subtract a
//! constant and multiply by 4 stretch it, so that 8 bits resolve 2^-14 of a level.

use crate::oracle::V4;
use crate::oracle::env::{Argument, Combine, Env};
use crate::oracle::scene::{Scene, Unit};
use crate::oracle::texel::{Image, Texture};
use crate::oracle::vertex::CoordUnit;
use crate::support::bridge::{as_given, draw};
use crate::support::compare::{EDGES, compare};
use crate::support::images::{bytes, chain};
use crate::support::scenes::{facing, floor, heap, replace};
use fixedgl::enums::*;

/// Level d is white if d is odd.
fn striped(size: i64, f: impl Fn(i64) -> V4) -> Texture {
    let mut t = chain(GL_TEXTURE_2D, GL_RGBA, [size, size, 1], |s, level| Image::new(s, [0; 3], |_| f(level)));
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    t
}

fn black_and_white(level: i64) -> V4 {
    if level % 2 == 1 { [1.0; 4] } else { [0.0; 4] }
}

/// (previous - constant) * 4.
fn stretch(constant: f64) -> Env {
    let arg = |source| Argument { source, operand: GL_SRC_COLOR };
    let combine = Combine {
        rgb: GL_SUBTRACT,
        alpha: GL_REPLACE,
        rgb_args: [arg(GL_PREVIOUS), arg(GL_CONSTANT), arg(GL_CONSTANT), arg(GL_ZERO)],
        rgb_scale: 4.0,
        ..Combine::default()
    };
    Env { mode: GL_COMBINE, color: [constant; 4], combine }
}

/// A scene whose unit 0 shows lambda and whose units 1 to 3 show 1/64 of the range from `from` on.
fn magnified(mut scene: Scene, texture: Texture, from: f64) -> Scene {
    let plain = {
        let mut t = Texture::flat(GL_RGBA, Image::from_fn(1, 1, |_, _| [1.0; 4]));
        t.lod.min_filter = GL_NEAREST;
        t
    };
    scene.units = vec![replace(texture)];
    // After unit k the value is 4^k (x - from): only the first constant is not zero.
    for constant in [from, 0.0, 0.0] {
        scene.units.push(Unit { texture: Some(plain.clone()), env: stretch(f64::from(constant as f32)) });
    }
    scene.vertex.units = vec![CoordUnit::default(); 4];
    for v in scene.triangles.iter_mut().flatten() {
        v.tex.resize(4, [0.0, 0.0, 0.0, 1.0]);
    }
    scene
}

#[test]
fn lambda_is_exact_to_a_ten_thousandth() {
    let mut worst = 0.0f64;
    let mut measured = 0;
    for step in 0..64 {
        let from = f64::from(step) / 64.0;
        for scene in [floor(96, 64, 50.0, 1.3, 27.0), heap(96, 64, 6, 8.0, 5)] {
            let scene = as_given(&magnified(scene, striped(256, black_and_white), from));
            let (ideal, got) = (scene.render(), draw(&scene));
            for (p, g) in ideal.pixels.iter().zip(got) {
                let Some(story) = p.story.as_ref().filter(|_| p.nearest_edge > 1.0 / 128.0) else { continue };
                let lambda = story.samples[0].map_or(0.0, |s| s.lambda);
                // Only bytes inside the range say anything.
                if (3..=252).contains(&g[0]) && lambda < 7.9 {
                    let fraction = lambda - lambda.floor();
                    let shown = if lambda.floor() % 2.0 == 0.0 { fraction } else { 1.0 - fraction };
                    let got = f64::from(from as f32) + f64::from(g[0]) / 255.0 / 64.0;
                    // A byte stands for a range of 2^-14 of lambda: half of it is the conversion's.
                    worst = worst.max(((got - shown).abs() - 0.5 / 255.0 / 64.0).max(0.0));
                    measured += 1;
                }
            }
        }
    }
    eprintln!(
        "lambda: {measured} fragments measured, worst |delta lambda| = {worst:.2e} beyond the conversion to 8 bits"
    );
    assert!(measured > 3000, "{measured}");
    assert!(worst <= 1e-4, "{worst}");
}

/// A quad whose texture has `k` texels a pixel: lambda = log2 k everywhere.
fn scaled(texture: &Texture, k: f64, size: u32) -> Scene {
    let n = texture.levels[0][0].size[0] as f64;
    let mut scene = facing(size, size, [0.0, 0.0], [k * f64::from(size) / n, k * f64::from(size) / n]);
    scene.units = vec![replace(texture.clone())];
    scene
}

/// What one pixel in the middle shows.
fn middle(scene: &Scene) -> [u8; 4] {
    draw(&as_given(scene))[(scene.width * scene.height / 2 + scene.width / 2) as usize]
}

/// A texture whose level d is (16 d + 8) in all channels, so that a colour names a level.
fn named() -> Texture {
    striped(64, |level| bytes([(16 * level + 8) as u8; 4]))
}

#[test]
fn ties_between_levels_go_down() {
    let mut t = named();
    t.lod.min_filter = GL_LINEAR_MIPMAP_NEAREST;
    for (k, want) in [(1.4, 0), (1.43, 1), (2.8, 1), (2.9, 2), (5.6, 2), (5.7, 3), (60.0, 6), (900.0, 6)] {
        assert_eq!(middle(&scaled(&t, k, 16))[0], 16 * want + 8, "{k} texels a pixel");
    }
}

#[test]
fn the_switch_over_is_at_one_half_for_nearest_mipmaps_and_a_linear_magnifier() {
    // Levels 0 and 1 with different colours: a magnified fragment shows level 0 alone.
    let t = named();
    for (min, mag, k, want) in [
        (GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, 1.4, 8),
        (GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST, 1.4, 16),
        (GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 1.4, 16),
        (GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, 1.5, 17),
    ] {
        let mut t = t.clone();
        (t.lod.min_filter, t.lod.mag_filter) = (min, mag);
        let got = middle(&scaled(&t, k, 16))[0];
        assert!((i16::from(got) - want).abs() <= 1, "{min:#x} {mag:#x} {k}: {got}, want {want}");
    }
}

#[test]
fn biases_add_and_limits_hold() {
    let t = named();
    let level = |t: &Texture, k: f64| (f64::from(middle(&scaled(t, k, 16))[0]) - 8.0) / 16.0;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 0.07, "{a} is not {b}");
    near(level(&t, 4.0), 2.0);
    let mut biased = t.clone();
    (biased.lod.object_bias, biased.lod.unit_bias) = (1.0, 0.5);
    near(level(&biased, 4.0), 3.5);
    biased.lod.object_bias = -2.25;
    near(level(&biased, 4.0), 0.25);
    let mut limited = t.clone();
    limited.lod.max_lod = 1.25;
    near(level(&limited, 4.0), 1.25);
    limited.lod.min_lod = 1.0;
    near(level(&limited, 0.125), 1.0);
    let mut ranged = t.clone();
    (ranged.lod.base_level, ranged.lod.max_level) = (2, 4);
    // Texels are those of level 2 now: 16 of them across, so the coordinates stay and lambda is 2 less.
    near(level(&ranged, 4.0), 2.0);
    near(level(&ranged, 16.0), 4.0);
    near(level(&ranged, 500.0), 4.0);
}

#[test]
fn every_state_of_lod_against_the_oracle() {
    let mut t = striped(64, |level| bytes([(level * 37 + 11) as u8, (level * 91) as u8, 255 - level as u8, 255]));
    let mut random = crate::support::Random(3);
    let mut all = crate::support::compare::Figures::default();
    for round in 0..24 {
        t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
        t.lod.object_bias = random.range(-2.0, 2.0);
        t.lod.unit_bias = random.range(-1.0, 1.0);
        t.lod.min_lod = random.range(-2.0, 2.0);
        t.lod.max_lod = t.lod.min_lod + random.range(0.0, 5.0);
        t.lod.base_level = random.below(3) as u32;
        t.lod.max_level = t.lod.base_level + random.below(5) as u32;
        let mut scene = floor(64, 64, 40.0, 1.1, 13.0 * f64::from(round));
        scene.units = vec![replace(t.clone())];
        let f = compare(&scene, EDGES);
        assert_eq!(f.off, 0, "round {round} {:?}: {f:?}", t.lod);
        all.merge(&f);
    }
    all.within_one_lsb("24 random states of LOD");
}
