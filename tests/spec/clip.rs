//! Clipping (OpenGL 1.5, section 2.12): the clip volume and user planes against the oracle, complementary planes, vertices
//! behind the eye, at infinity, huge, or no numbers at all.

use crate::oracle::matrix::M4;
use crate::oracle::scene::Scene;
use crate::oracle::vertex::Vertex;
use crate::support::bridge::{as_given, draw};
use crate::support::compare::{EDGES, compare};
use crate::support::scenes::{floor, heap};
use crate::support::{Random, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;

#[test]
fn planes_are_kept_in_eye_coordinates() {
    let mut cx = Context::new(4, 4);
    let mut p = [1.0f64; 4];
    cx.get_clip_plane(GL_CLIP_PLANE3, &mut p);
    assert_eq!(p, [0.0; 4]);
    cx.translatef(0.0, 0.0, -5.0);
    cx.clip_plane(GL_CLIP_PLANE3, &[0.0, 0.0, 1.0, 0.0]);
    cx.get_clip_plane(GL_CLIP_PLANE3, &mut p);
    assert_eq!(p, [0.0, 0.0, 1.0, 5.0]);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.clip_plane(GL_CLIP_PLANE0 + 40, &[0.0; 4]));
}

#[test]
fn the_volume_and_user_planes() {
    let mut random = Random(4);
    for seed in 0..8 {
        let mut scene = heap(96, 96, 10, 1.0, 100 + seed);
        // Wider than the window, nearer than the near plane, behind the eye.
        for v in scene.triangles.iter_mut().flatten() {
            v.position[0] *= 4.0;
            v.position[2] += 3.0;
        }
        scene.clip_planes = (0..seed.min(6))
            .map(|_| {
                [random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(0.0, 3.0)]
            })
            .collect();
        // Edges that clipping makes are where the two may round differently.
        let f = compare(&scene, EDGES);
        f.print(&format!("{} user planes", scene.clip_planes.len()));
        assert!(f.off * 2000 <= f.compared, "{f:?}");
    }
}

#[test]
fn a_plane_and_its_opposite_leave_nothing_out() {
    let mut random = Random(41);
    for _ in 0..60 {
        let plane: [f64; 4] = std::array::from_fn(|i| random.range(-1.0, 1.0) * if i == 3 { 0.5 } else { 1.0 });
        let mut cx = Context::new(64, 64);
        cx.enable(GL_BLEND);
        cx.blend_func(GL_ONE, GL_ONE);
        cx.color4ub(1, 1, 1, 1);
        cx.enable(GL_CLIP_PLANE0);
        for sign in [1.0, -1.0] {
            cx.clip_plane(GL_CLIP_PLANE0, &plane.map(|v| v * sign));
            cx.begin(GL_TRIANGLES);
            for [x, y, z] in [[-1.0f32, -1.0, -0.5], [3.0, -1.0, 0.25], [-1.0, 3.0, 0.5]] {
                cx.vertex3f(x, y, z);
            }
            cx.end();
        }
        no_error(&mut cx);
        let got = pixels(&mut cx, 64, 64);
        let wrong = got.iter().filter(|p| p[0] != 1).count();
        assert_eq!(wrong, 0, "plane {plane:?}");
    }
}

#[test]
fn scaling_all_four_coordinates_changes_nothing() {
    // A vertex at w < 0 and one at w = 0 are part of it.
    let triangle = [[0.2, 0.1, 0.0, -0.5], [-0.8, -0.6, 0.1, 1.0], [0.9, -0.7, 0.0, 0.75]];
    let at = |k: f64| {
        let mut scene = Scene::new(64, 64);
        scene.triangles.push(triangle.map(|p| Vertex { position: p.map(|v| v * k), ..Vertex::at(0.0, 0.0, 0.0) }));
        draw(&scene)
    };
    let one = at(1.0);
    assert!(one.iter().filter(|p| p[3] > 0).count() > 200);
    for k in [1e-30, 1e-10, 1024.0, 1e30] {
        let differ = at(k).iter().zip(&one).filter(|(a, b)| a != b).count();
        assert!(differ <= 2, "{k}: {differ} pixels differ");
    }
    for w in [-1.0, -1e-20] {
        let mut scene = Scene::new(64, 64);
        scene.triangles.push(triangle.map(|p| Vertex { position: [p[0], p[1], p[2], w], ..Vertex::at(0.0, 0.0, 0.0) }));
        assert!(draw(&scene).iter().all(|p| *p == [0; 4]), "w = {w}");
    }
}

#[test]
fn what_is_no_number_is_not_drawn() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for k in 0..4 {
            let mut cx = Context::new(16, 16);
            cx.begin(GL_TRIANGLES);
            for i in 0..3 {
                let mut p = [[-1.0, -1.0, 0.0, 1.0], [3.0, -1.0, 0.0, 1.0], [-1.0f32, 3.0, 0.0, 1.0]][i];
                if i == 1 {
                    p[k] = bad;
                }
                cx.vertex4fv(&p);
            }
            cx.end();
            no_error(&mut cx);
            let drawn = pixels(&mut cx, 16, 16).iter().filter(|p| p[3] > 0).count();
            assert!(drawn == 0 || !bad.is_nan(), "{bad} in coordinate {k}: {drawn} pixels");
        }
    }
}

#[test]
fn huge_triangles_cover_the_half_plane() {
    for size in [1e4, 1e7, 1e12, 1e14] {
        let mut scene = Scene::new(64, 64);
        // The edge x = 0 through the middle of the window, everything else far out.
        scene.triangles.push([Vertex::at(0.0, -size, 0.0), Vertex::at(size, 0.0, 0.0), Vertex::at(0.0, size, 0.0)]);
        let got = draw(&as_given(&scene));
        for (i, p) in got.iter().enumerate() {
            assert_eq!(p[3] > 0, i % 64 >= 32, "size {size}, pixel {} {}", i % 64, i / 64);
        }
    }
}

#[test]
fn a_floor_under_the_eye_with_extreme_planes() {
    for near in [0.1, 1e-3, 1e-6] {
        let mut scene = floor(64, 64, 1000.0, 1.0, 0.0);
        scene.vertex.projection = M4::perspective(60.0, 1.0, near, 1e9);
        scene.vertex.modelview = M4::translation(0.0, -1.0, 0.0);
        let got = draw(&as_given(&scene));
        for (i, p) in got.iter().enumerate() {
            let y = i / 64;
            // The far edge of the floor is at 1/1000 below the horizon, within the row under the middle.
            if y != 31 {
                assert_eq!(p[3] > 0, y < 31, "near {near}, row {y}");
            }
        }
    }
}
