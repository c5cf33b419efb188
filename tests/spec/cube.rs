//! Cube maps (OpenGL 1.5, section 3.8.6): the face of a direction, its coordinates, ties, level of detail on a face, and
//! the errors of cube images.

use crate::oracle::scene::Scene;
use crate::oracle::texel::{Texture, cube_face};
use crate::oracle::vertex::Vertex;
use crate::support::bridge::draw;
use crate::support::compare::{EDGES, NEAREST, compare};
use crate::support::images::{bytes, chain, nearest, noise};
use crate::support::raises;
use crate::support::scenes::{heap, replace};
use fixedgl::Context;
use fixedgl::enums::*;

fn faces() -> Texture {
    // Level 0 of face f has the number 8 f, so that noise differs by face.
    chain(GL_TEXTURE_CUBE_MAP, GL_RGBA, [32, 32, 1], |s, n| noise(s, [0; 3], 1 + n as u64, GL_RGBA))
}

/// Every pixel of a heap lies on one face, or near enough to a seam to be doubtful.
fn directions(seed: u64) -> Scene {
    heap(96, 96, 12, 2.0, seed)
}

#[test]
fn nearest_and_linear_on_all_faces() {
    for (filter, doubt) in [(GL_NEAREST, NEAREST), (GL_LINEAR, EDGES)] {
        for seed in [1, 2, 3] {
            let mut t = faces();
            (t.lod.min_filter, t.lod.mag_filter) = (filter, filter);
            t.wrap = [GL_CLAMP_TO_EDGE; 3];
            let mut scene = directions(seed);
            scene.units = vec![replace(t)];
            let f = compare(&scene, doubt);
            f.print(&format!("cube {filter:#x}"));
            assert!(f.drawn > 2000 && f.share() < 2e-3, "{f:?}");
        }
    }
}

#[test]
fn all_faces_are_filtered_trilinearly() {
    let mut t = faces();
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    t.wrap = [GL_CLAMP_TO_EDGE; 3];
    let mut scene = directions(9);
    for v in scene.triangles.iter_mut().flatten() {
        // Directions that change slowly enough to stay on a face for a while, fast enough to reach small levels.
        v.tex[0][2] += 3.0;
    }
    scene.units = vec![replace(t)];
    let f = compare(&scene, EDGES);
    f.print("cube trilinear");
    assert!(f.drawn > 2000 && f.share() < 2e-3, "{f:?}");
}

#[test]
fn each_of_26_directions_reads_the_face_of_the_rule() {
    let mut t = nearest(chain(GL_TEXTURE_CUBE_MAP, GL_RGBA, [1, 1, 1], |s, n| {
        crate::oracle::texel::Image::new(s, [0; 3], |_| bytes([(n / 8 * 40 + 5) as u8, 0, 0, 255]))
    }));
    t.lod.max_level = 0;
    for scale in [1.0, 1e-30, 1e30] {
        for code in 0..27 {
            let r = [f64::from(code % 3 - 1), f64::from(code / 3 % 3 - 1), f64::from(code / 9 - 1)];
            let mut scene = Scene::new(2, 2);
            let v = |x, y| Vertex::at(x, y, 0.0).strq([r[0] * scale, r[1] * scale, r[2] * scale, 1.0]);
            scene.quad([v(-1.0, -1.0), v(1.0, -1.0), v(1.0, 1.0), v(-1.0, 1.0)]);
            scene.units = vec![replace(t.clone())];
            let want = (cube_face(r).0 * 40 + 5) as u8;
            for p in draw(&scene) {
                assert_eq!(p, [want, 0, 0, 255], "direction {r:?} times {scale}");
            }
        }
    }
}

#[test]
fn wrong_cube_images_are_refused() {
    let mut cx = Context::new(4, 4);
    let px = [0u8; 64];
    raises(&mut cx, GL_INVALID_VALUE, |cx| {
        cx.tex_image_2d(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, &px);
    });
    raises(&mut cx, GL_INVALID_ENUM, |cx| {
        cx.tex_image_2d(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &px);
    });
    raises(&mut cx, GL_INVALID_ENUM, |cx| {
        cx.tex_parameteri(GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    });
}
