//! Rasterisation (OpenGL 1.5, sections 3.3 to 3.5): coverage equals the oracle's, pixel for pixel, edges that triangles
//! share are hit exactly once, depth and colour are interpolated, facing, culling, polygon mode and offset, points, lines.

use crate::oracle::fragment::Blend;
use crate::oracle::raster::{coverage, lines, snap};
use crate::oracle::scene::Scene;
use crate::oracle::vertex::Vertex;
use crate::support::bridge::as_given;
use crate::support::compare::{EDGES, compare};
use crate::support::scenes::heap;
use crate::support::{Random, get_f, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;
use std::collections::HashSet;

const SIZE: u32 = 128;

/// A context with window coordinates for object coordinates, and ONE + ONE blending: a pixel counts its fragments.
fn counting(size: u32) -> Context {
    let mut cx = Context::new(size, size);
    cx.matrix_mode(GL_PROJECTION);
    cx.ortho(0.0, f64::from(size), 0.0, f64::from(size), -1.0, 1.0);
    cx.matrix_mode(GL_MODELVIEW);
    cx.enable(GL_BLEND);
    cx.blend_func(GL_ONE, GL_ONE);
    cx.color4ub(1, 1, 1, 1);
    cx
}

/// A window position on the grid of 1/256 pixel.
fn grid(random: &mut Random, size: u32) -> [f32; 2] {
    let n = u64::from(size) * 256;
    std::array::from_fn(|_| random.below(n) as f32 / 256.0)
}

fn counts(cx: &mut Context, size: u32) -> Vec<u8> {
    pixels(cx, size, size).iter().map(|p| p[0]).collect()
}

fn emit(cx: &mut Context, mode: GLenum, points: &[[f32; 2]]) {
    cx.begin(mode);
    for p in points {
        cx.vertex2fv(p);
    }
    cx.end();
}

#[test]
fn the_initial_state_is_the_tables_and_errors_are_told() {
    let mut cx = Context::new(4, 4);
    assert_eq!(get_f::<1>(&mut cx, GL_POINT_SIZE), [1.0]);
    assert_eq!(get_f::<1>(&mut cx, GL_LINE_WIDTH), [1.0]);
    assert_eq!(get_i(&mut cx, GL_CULL_FACE), 0);
    assert_eq!(get_i(&mut cx, GL_CULL_FACE_MODE) as u32, GL_BACK);
    assert_eq!(get_i(&mut cx, GL_FRONT_FACE) as u32, GL_CCW);
    assert_eq!(get_i(&mut cx, GL_SHADE_MODEL) as u32, GL_SMOOTH);
    assert!(get_i(&mut cx, GL_SUBPIXEL_BITS) >= 8);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.point_size(0.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.line_width(-1.0));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.polygon_mode(GL_FRONT, GL_TRIANGLES));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.cull_face(GL_CCW));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.front_face(GL_FRONT));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.begin(10));
}

#[test]
fn triangles_cover_what_the_oracle_covers() {
    let mut random = Random(2);
    let mut fragments = 0;
    for round in 0..400 {
        // Every other triangle has its corners on pixel centres or corners, where the rule decides.
        let mut corner = || {
            let p = grid(&mut random, 64);
            if round % 2 == 0 { p } else { p.map(|v| (v * 2.0).round() / 2.0) }
        };
        let t = [corner(), corner(), corner()];
        let mut cx = counting(64);
        emit(&mut cx, GL_TRIANGLES, &t);
        let want: HashSet<[i64; 2]> =
            coverage(t.map(|p| p.map(|v| snap(f64::from(v))))).into_iter().filter(|p| p[0] < 64 && p[1] < 64).collect();
        fragments += want.len();
        for (i, n) in counts(&mut cx, 64).into_iter().enumerate() {
            let p = [i as i64 % 64, i as i64 / 64];
            assert_eq!(n, u8::from(want.contains(&p)), "triangle {t:?} at {p:?}");
        }
    }
    eprintln!("coverage: 400 triangles, {fragments} fragments, all where the oracle has them");
}

#[test]
fn a_fan_around_a_point_hits_every_pixel_once() {
    let mut random = Random(6);
    for round in 0..60 {
        let centre = grid(&mut random, 64).map(|v| v + 32.0);
        let n = 3 + random.below(40);
        let mut angles: Vec<f64> = (0..n).map(|_| random.range(0.0, 360.0)).collect();
        angles.sort_by(f64::total_cmp);
        let ring: Vec<[f32; 2]> = angles
            .iter()
            .map(|a| {
                let (sin, cos) = a.to_radians().sin_cos();
                let snap = |v: f64| ((v * 256.0).round() / 256.0) as f32;
                [snap(64.0 + 300.0 * cos), snap(64.0 + 300.0 * sin)]
            })
            .collect();
        // The fan closes around the window only if no gap is as wide as half a turn.
        let widest = (0..angles.len())
            .map(|i| (angles[(i + 1) % angles.len()] - angles[i]).rem_euclid(360.0))
            .fold(0.0, f64::max);
        let mut cx = counting(SIZE);
        let mut points = vec![centre];
        points.extend(&ring);
        points.push(ring[0]);
        emit(&mut cx, GL_TRIANGLE_FAN, &points);
        let got = counts(&mut cx, SIZE);
        if widest < 120.0 {
            assert!(got.iter().all(|&c| c == 1), "round {round}: {:?}", got.iter().collect::<HashSet<_>>());
        } else {
            assert!(got.iter().all(|&c| c <= 2));
        }
    }
}

#[test]
fn a_crooked_grid_hits_every_pixel_once() {
    for (seed, step) in [(1, 0.0), (2, 0.5), (3, 2.0), (4, 3.9)] {
        let mut random = Random(seed * 77);
        let n = 16usize;
        let points: Vec<[f32; 2]> = (0..=n * n + 2 * n)
            .map(|k| {
                let (i, j) = (k % (n + 1), k / (n + 1));
                let mut at = |c: usize| {
                    let edge = c == 0 || c == n;
                    let shift = if edge { 0.0 } else { random.range(-step, step) };
                    (((c as f64 * 8.0 + shift) * 256.0).round() / 256.0) as f32
                };
                [at(i), at(j)]
            })
            .collect();
        let mut cx = counting(SIZE);
        cx.begin(GL_TRIANGLES);
        for j in 0..n {
            for i in 0..n {
                let p = |a: usize, b: usize| points[(j + b) * (n + 1) + i + a];
                let flip = (i + j) % 2 == 0;
                let (first, second) = if flip {
                    ([p(0, 0), p(1, 0), p(1, 1)], [p(0, 0), p(1, 1), p(0, 1)])
                } else {
                    ([p(0, 1), p(1, 0), p(0, 0)], [p(1, 0), p(0, 1), p(1, 1)])
                };
                for v in first.iter().chain(&second) {
                    cx.vertex2fv(v);
                }
            }
        }
        cx.end();
        let got = counts(&mut cx, SIZE);
        // A shift of up to 3.9 of 8 keeps every quad from folding over; its diagonal may fold a triangle, not the union.
        let wrong = got.iter().filter(|&&c| c != 1).count();
        if step <= 2.0 {
            assert_eq!(wrong, 0, "step {step}");
        } else {
            assert!(got.iter().all(|&c| c > 0 || step > 3.0), "step {step}: {wrong}");
        }
    }
}

#[test]
fn colours_are_interpolated_in_perspective() {
    let scene = heap(SIZE, SIZE, 20, 1.0, 3);
    compare(&scene, EDGES).within_one_lsb("smooth colours");
    let flat = Scene { flat: true, ..scene };
    compare(&flat, EDGES).within_one_lsb("flat colours");
}

#[test]
fn facing_and_culling_agree_with_the_oracle() {
    for cull in [GL_FRONT, GL_BACK, GL_FRONT_AND_BACK] {
        for clockwise in [false, true] {
            let mut scene = heap(64, 64, 20, 1.0, 5);
            scene.cull = Some(cull);
            scene.clockwise = clockwise;
            let f = compare(&scene, EDGES);
            assert_eq!(f.differ, f.off, "{f:?}");
            assert_eq!(f.off, 0, "{cull:#x} {clockwise}: {f:?}");
            assert_eq!(f.drawn == 0, cull == GL_FRONT_AND_BACK);
        }
    }
}

#[test]
fn depth_is_that_of_the_plane_and_offset_moves_it() {
    let mut random = Random(44);
    for (factor, units) in [(0.0, 0.0), (1.5, 0.0), (0.0, 1000.0), (-2.0, -70.0)] {
        let mut scene = Scene::new(48, 48);
        scene.depth = Some((GL_LESS, true));
        scene.offset = (factor != 0.0 || units != 0.0).then_some((factor, units));
        // Corners on the grid of 1/256 pixel, so that depth means the same with and without rounding.
        let mut v = |x: f64, y: f64| Vertex::at(x / 24.0 - 1.0, y / 24.0 - 1.0, random.range(-0.8, 0.8));
        scene.triangles.push([v(1.5, 2.25), v(46.125, 3.0), v(25.0, 45.75)]);
        let scene = as_given(&scene);
        let ideal = scene.render();
        let mut cx = Context::new(48, 48);
        crate::support::bridge::state(&mut cx, &scene);
        crate::support::bridge::triangles(&mut cx, &scene);
        let mut depth = vec![0f32; 48 * 48];
        cx.read_pixels(0, 0, 48, 48, GL_DEPTH_COMPONENT, GL_FLOAT, &mut depth);
        no_error(&mut cx);
        let steps = |z: f64| z * f64::from((1 << 24) - 1);
        // The slope may be the length of the gradient or its greater component (section 3.5.5): either, but one of them.
        let inside = || ideal.pixels.iter().zip(&depth).filter(|(p, _)| p.hits > 0 && p.nearest_edge > 0.01);
        let worst_against = |shift: f64| {
            inside().map(|(p, d)| (steps(p.depth) + shift - steps(f64::from(*d))).abs()).fold(0.0, f64::max)
        };
        let corners = scene.triangles[0].each_ref().map(|v| scene.viewport.window(v.position));
        let triangle = crate::oracle::raster::Triangle(corners);
        let other = steps(triangle.offset_by_max(factor, 0.0) - triangle.offset(factor, 0.0, 0.0));
        // r is an implementation's constant: here a step and its 1024th part.
        let r = units / 1024.0;
        let worst = worst_against(r).min(worst_against(other + r));
        eprintln!("depth with offset ({factor}, {units}): worst {worst:.2} steps of 24 bits");
        assert!(worst <= 1.5, "{worst}");
    }
}

#[test]
fn thin_and_degenerate_triangles_cover_what_the_oracle_says() {
    let mut random = Random(61);
    for _ in 0..200 {
        let a = grid(&mut random, 64);
        let b = grid(&mut random, 64);
        let near = [a[0] + 1.0 / 256.0, a[1]];
        for t in [[a, a, b], [a, b, b], [a, b, a], [a, a, a], [a, near, b]] {
            let mut cx = counting(64);
            emit(&mut cx, GL_TRIANGLES, &t);
            let want = coverage(t.map(|p| p.map(|v| snap(f64::from(v)))));
            let want = want.iter().filter(|p| p.iter().all(|v| (0..64).contains(v))).count();
            assert_eq!(counts(&mut cx, 64).iter().map(|c| usize::from(*c)).sum::<usize>(), want, "{t:?}");
        }
    }
}

#[test]
fn points_are_squares_of_their_size() {
    let mut random = Random(19);
    for size in [1, 2, 3, 5, 8] {
        for _ in 0..20 {
            let p = grid(&mut random, 48).map(|v| v + 8.0);
            let mut cx = counting(64);
            cx.point_size(size as f32);
            emit(&mut cx, GL_POINTS, &[p]);
            let want: HashSet<[i64; 2]> = lines::point(f64::from(p[0]), f64::from(p[1]), size).into_iter().collect();
            for (i, n) in counts(&mut cx, 64).into_iter().enumerate() {
                let at = [i as i64 % 64, i as i64 / 64];
                assert_eq!(n, u8::from(want.contains(&at)), "point of size {size} at {p:?}: {at:?}");
            }
        }
    }
}

#[test]
fn lines_leave_the_diamonds() {
    let mut random = Random(23);
    let mut differ = 0;
    let mut total = 0;
    for _ in 0..300 {
        let (a, b) = (grid(&mut random, 64), grid(&mut random, 64));
        let mut cx = counting(64);
        emit(&mut cx, GL_LINES, &[a, b]);
        let fixed = |p: [f32; 2]| p.map(|v| snap(f64::from(v)));
        let want: HashSet<[i64; 2]> = lines::line(fixed(a), fixed(b)).into_iter().collect();
        total += want.len();
        for (i, n) in counts(&mut cx, 64).into_iter().enumerate() {
            let at = [i as i64 % 64, i as i64 / 64];
            assert!(n <= 1);
            differ += usize::from(n != u8::from(want.contains(&at)));
        }
    }
    eprintln!("lines: {total} fragments, {differ} pixels differ from the diamond rule");
    // The specification allows an algorithm other than the diamond rule to be off by one pixel a column.
    assert!(differ * 100 <= total, "{differ} of {total}");
}

#[test]
fn a_line_strip_draws_its_joints_once() {
    let mut random = Random(29);
    for _ in 0..50 {
        let mut x = 1.0;
        let mut points = Vec::new();
        while x < 60.0 {
            points.push([x, 20.0 + random.below(16 * 256) as f32 / 256.0]);
            x += 6.0 + random.below(1024) as f32 / 256.0;
        }
        let mut cx = counting(64);
        emit(&mut cx, GL_LINE_STRIP, &points);
        // What the segments draw one by one is what the strip draws: nothing twice at a joint, nothing left out.
        let mut want = vec![0u8; 64 * 64];
        for w in points.windows(2) {
            let fixed = |p: [f32; 2]| p.map(|v| snap(f64::from(v)));
            for [x, y] in lines::line(fixed(w[0]), fixed(w[1])) {
                want[(y * 64 + x) as usize] += 1;
            }
        }
        let got = counts(&mut cx, 64);
        let differ = got.iter().zip(&want).filter(|(a, b)| a != b).count();
        assert!(differ <= 1, "{points:?}: {differ}");
    }
}

#[test]
fn polygon_modes_draw_points_and_lines() {
    let square = [[10.5f32, 10.5], [40.5, 10.5], [40.5, 40.5], [10.5, 40.5]];
    let mut cx = counting(64);
    cx.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
    emit(&mut cx, GL_QUADS, &square);
    assert_eq!(counts(&mut cx, 64).iter().filter(|c| **c == 1).count(), 4);
    let mut cx = counting(64);
    cx.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
    emit(&mut cx, GL_QUADS, &square);
    let got = counts(&mut cx, 64);
    assert_eq!(got.iter().map(|c| usize::from(*c)).sum::<usize>(), 120, "four edges of 30 pixels");
    assert_eq!(got[64 * 20 + 20], 0);
}

#[test]
fn a_large_heap_blended_in_order() {
    let mut scene = heap(SIZE, SIZE, 40, 1.0, 71);
    scene.blend = Some(Blend::func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    let f = compare(&scene, EDGES);
    f.print("40 blended layers");
    // Each layer rounds to 8 bits on top of the last, so a fragment that falls to the other side carries on.
    assert!(f.off == 0 && f.share() < 0.01, "{f:?}");
}
