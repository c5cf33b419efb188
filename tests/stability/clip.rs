//! Clipping and w (OpenGL 1.5, section 2.12): planes far apart, vertices behind the eye, at infinity, far outside of the
//! guard band; edges that are cut must be the same for both triangles that share them.

use crate::oracle::scene::Scene;
use crate::oracle::vertex::Vertex;
use crate::stability::common::{any_size, bytes, counting, counts, emit, everywhere, floats, read};
use crate::stability::row::{Worst, rows};
use crate::support::bridge::as_given;
use crate::support::{Random, no_error};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    far_and_near: "C1", "a floor h = 1 and 2^-16 under the eye, through the eye plane; near 0.1, 1e-3, 1e-6; far/near 1e3 to 1e15",
        "covered below the horizon; s, t of the ray that meets the floor", 1e-3, "footprints (texels where magnified)",
        "f64 to the window; near plane and guard band in homogeneous coordinates; s, t from unsnapped corners";
    attributes_at_extreme_w: "C2", "random triangles, w of the corners between 1e-5 and 1e6, colours",
        "equation 3.6 at unsnapped positions", 0.01, "255ths", "differences from the corner of least 1/w, r = w_ref/w";
    behind_the_eye: "C3", "one vertex at w = -0.5, 0, 1e-20; all coordinates times 2^-99, 1, 2^100; all w negative",
        "the part with w > 0, the same pixels at each scale; nothing", 0.0, "pixels", "cut by w = 1e-250 first, in f64";
    no_numbers: "C4", "NaN and infinities in each coordinate of each vertex", "undefined; ours: nothing is drawn", 0.0,
        "wrong pictures", "outcode NAN drops the primitive";
    huge_positions: "C5", "triangles around the window or with an edge through it, corners at 1e4 to 1e38 pixels, 3 directions",
        "the window, the half plane", 0.0, "pixels", "guard band of 32767 pixels; where an edge meets it follows from determinants without rounding of products";
    cut_edges_meet: "C6", "1000 planes, each with its opposite, over a triangle; 10,000 clipped triangles in 6 orders of their vertices",
        "each pixel once; the same pixels in each order", 0.0, "pixels", "a point of an edge is a sum of two terms that change places with its ends";
    inside_stays: "C7", "500 triangles with and without user planes that cut nothing", "the same colours and depths", 0.0,
        "pictures that differ", "no plane whose outcode bit is not set is cut by";
    many_planes: "C8", "500 triangles cut by six user planes, near and far", "coverage of the polygon, finite colours", 0.0,
        "pixels beyond 1/32 pixel of an edge", "at most one more corner a plane; corners have fixed room";
    guard_band: "C9", "200 fans around a point in the window, outer corners at 1e2 to 1e30 pixels", "each pixel once", 0.0,
        "pixels", "edges shared inside and outside of the guard band are cut alike";
}

const SIZE: u32 = 64;

/// A texture of 256 x 256 whose red and green are the numbers of its column and row; LINEAR.
fn numbered(cx: &mut Context) {
    let texels: Vec<[u8; 4]> = (0..65536u32).map(|i| [(i % 256) as u8, (i / 256) as u8, 0, 255]).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.as_flattened());
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
}

fn far_and_near(w: &mut Worst) {
    for near in [0.1, 1e-3, 1e-6] {
        for ratio in [1e3, 1e6, 1e9, 1e12, 1e15] {
            for (height, reach) in [(1.0, 1024.0), (1.0, 1_048_576.0), (1.0 / 65536.0, 1_048_576.0)] {
                floor(w, near, near * ratio, height, reach);
            }
        }
    }
}

/// A floor of 4 units for 256 texels, seen with a right angle; `reach` is how far it goes.
fn floor(w: &mut Worst, near: f64, far: f64, height: f64, reach: f64) {
    let mut cx = floats(SIZE, SIZE);
    numbered(&mut cx);
    cx.matrix_mode(GL_PROJECTION);
    cx.frustum(-near, near, -near, near, near, far);
    cx.begin(GL_QUADS);
    for [x, z] in [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        cx.tex_coord2d(x * reach / 4.0, z * reach / 4.0);
        cx.vertex3d(x * reach, -height, z * reach);
    }
    cx.end();
    let got = read(&mut cx);
    let ray = |i: u32| (2.0 * f64::from(i) + 1.0) / f64::from(SIZE) - 1.0;
    let seen = |y: f64| y < 0.0 && -height / y <= reach.min(far) && -height / y >= near;
    for (i, color) in got.iter().enumerate() {
        let (column, row) = (i as u32 % SIZE, i as u32 / SIZE);
        let (x, y) = (ray(column), ray(row));
        let step = 2.0 / f64::from(SIZE);
        if seen(y - step) == seen(y + step) {
            let what = || format!("near {near} far {far} height {height}: coverage at {column}, {row}");
            w.holds((color[3] > 0.0) == seen(y), what);
        }
        if color[3] == 0.0 || y >= 0.0 {
            continue;
        }
        let depth = -height / y;
        let (s, t) = (depth * x * 64.0, -depth * 64.0);
        let (by_x, by_y) = (step * depth * 64.0, (step * depth / y * 64.0).abs() * (1.0 + x * x).sqrt());
        for (k, u) in [s, t].into_iter().enumerate() {
            let within = u.rem_euclid(256.0);
            if (1.0..255.0).contains(&within) {
                let error = (f64::from(color[k]) * 255.0 + 0.5 - within).abs() / by_x.max(by_y).max(1.0);
                w.see(error, || format!("near {near} far {far} height {height}: {k} at {column}, {row}"));
            }
        }
    }
}

fn attributes_at_extreme_w(w: &mut Worst) {
    let mut random = Random(202);
    for round in 0..400 {
        let mut scene = Scene::new(SIZE, SIZE);
        scene.triangles.push(std::array::from_fn(|_| {
            let depth = f64::from(any_size(&mut random, -5.0, 6.0).abs());
            let mut v = Vertex::at(random.range(-1.5, 1.5) * depth, random.range(-1.5, 1.5) * depth, 0.0);
            v.position[3] = depth;
            v.color = std::array::from_fn(|_| random.range(0.0, 1.0));
            v
        }));
        w.fuzzed += 1;
        crate::stability::common::against_oracle(w, &scene, &format!("triangle {round}"));
    }
}

fn triangle_of(cx: &mut Context, corners: &[[f64; 4]; 3]) {
    cx.begin(GL_TRIANGLES);
    for p in corners {
        cx.vertex4dv(p);
    }
    cx.end();
}

fn behind_the_eye(w: &mut Worst) {
    for last in [-0.5, 0.0, 1e-20] {
        let corners = [[0.2, 0.1, 0.0, last], [-0.8, -0.6, 0.1, 1.0], [0.9, -0.7, 0.0, 0.75]];
        let mut pictures = Vec::new();
        for power in [-99, 0, 100] {
            let scaled = corners.map(|p| p.map(|v| f64::from(v as f32) * 2f64.powi(power)));
            pictures.push(everywhere(w, [SIZE, SIZE], |cx| triangle_of(cx, &scaled)));
            let negative = scaled.map(|p| [p[0], p[1], p[2], -p[3].abs()]);
            let drawn = everywhere(w, [SIZE, SIZE], |cx| triangle_of(cx, &negative));
            w.count(drawn.iter().filter(|c| c[3] > 0.0).count() as u64, 1, || format!("w < 0, 2^{power}"));
        }
        let mut scene = Scene::new(SIZE, SIZE);
        scene.triangles.push(corners.map(|p| Vertex { position: p, ..Vertex::at(0.0, 0.0, 0.0) }));
        let ideal = as_given(&scene).render();
        for (k, picture) in pictures.iter().enumerate() {
            let sure = ideal.pixels.iter().zip(picture).filter(|(p, _)| p.nearest_edge > 1.0 / 64.0);
            let wrong = sure.filter(|(p, c)| (p.hits > 0) != (c[3] > 0.0)).count();
            w.count(wrong as u64, 4096, || format!("w = {last}, picture {k} and the oracle"));
            let differ = pictures[0].iter().zip(picture).filter(|(a, b)| a != b).count();
            w.count(differ as u64, 4096, || format!("w = {last}, picture {k} and picture 0"));
            w.holds(picture.iter().filter(|c| c[3] > 0.0).count() > 200, || format!("w = {last}: hardly anything"));
        }
    }
}

fn no_numbers(w: &mut Worst) {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (vertex, k) in (0..12).map(|i| (i / 4, i % 4)) {
            let mut corners = [[-1.0, -1.0, 0.0, 1.0], [3.0, -1.0, 0.0, 1.0], [-1.0, 3.0, 0.0, 1.0]];
            corners[vertex][k] = bad;
            let got = everywhere(w, [16, 16], |cx| triangle_of(cx, &corners));
            w.holds(got.iter().all(|c| *c == [0.0; 4]), || format!("{bad} in coordinate {k} of vertex {vertex}"));
        }
    }
}

fn huge_positions(w: &mut Worst) {
    // Of each: two corners on a line through the middle of the window, the third to the left of it.
    let lines = [[[0.0, 1.0], [-1.0, 0.0]], [[1.0, 0.0], [0.0, 1.0]], [[1.0, 1.0], [-1.0, 1.0]]];
    for exponent in [4, 7, 9, 12, 14, 20, 30, 36] {
        let size = 10f64.powi(exponent);
        for [along, aside] in lines {
            let mut cx = counting(SIZE, SIZE);
            cx.load_identity();
            cx.matrix_mode(GL_PROJECTION);
            cx.load_identity();
            let corners = [along, along.map(|v| -v), aside].map(|p| [p[0] * size, p[1] * size, 0.0, 1.0]);
            triangle_of(&mut cx, &corners);
            for (i, n) in counts(&mut cx).into_iter().enumerate() {
                let at = [i % 64, i / 64].map(|v| v as f64 - 31.5);
                let side = at[0] * aside[0] + at[1] * aside[1];
                if side != 0.0 {
                    w.count(u64::from((n == 1) != (side > 0.0)), 1, || format!("1e{exponent} {along:?} at {at:?}"));
                }
            }
        }
        let mut cx = counting(SIZE, SIZE);
        cx.matrix_mode(GL_PROJECTION);
        cx.load_identity();
        triangle_of(&mut cx, &[[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]].map(|p| [p[0] * size, p[1] * size, 0.0, 1.0]));
        let missing = counts(&mut cx).iter().filter(|n| **n != 1).count();
        w.count(missing as u64, 4096, || format!("around the window at 1e{exponent}"));
    }
}

fn cut_edges_meet(w: &mut Worst) {
    let mut random = Random(41);
    for _ in 0..1000 {
        let plane: [f64; 4] = std::array::from_fn(|i| random.range(-1.0, 1.0) * if i == 3 { 0.5 } else { 1.0 });
        let mut cx = bytes(32, 32);
        cx.enable(GL_BLEND);
        cx.blend_func(GL_ONE, GL_ONE);
        cx.color4ub(1, 1, 1, 1);
        cx.enable(GL_CLIP_PLANE0);
        for sign in [1.0, -1.0] {
            cx.clip_plane(GL_CLIP_PLANE0, &plane.map(|v| v * sign));
            triangle_of(&mut cx, &[[-1.0, -1.0, -0.5, 1.0], [3.0, -1.0, 0.25, 1.0], [-1.0, 3.0, 0.5, 1.0]]);
        }
        let wrong = counts(&mut cx).iter().filter(|n| **n != 1).count();
        w.fuzzed += 1;
        w.count(wrong as u64, 1024, || format!("plane {plane:?}"));
    }
    orders(w, &mut random);
}

/// A clipped triangle covers the same pixels in whatever order its vertices come.
fn orders(w: &mut Worst, random: &mut Random) {
    let mut cx = counting(16, 16);
    cx.matrix_mode(GL_PROJECTION);
    cx.load_identity();
    for round in 0..10_000 {
        let scale = 10f64.powi(random.below(8) as i32);
        let corners: [[f64; 4]; 3] = std::array::from_fn(|_| {
            let p = [random.range(-2.0, 2.0), random.range(-2.0, 2.0)].map(|v| v * scale);
            [p[0], p[1], random.range(-2.0, 2.0), random.range(-0.5, 1.0)]
        });
        cx.clear(GL_COLOR_BUFFER_BIT);
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0], [1, 0, 2], [0, 2, 1]] {
            triangle_of(&mut cx, &order.map(|i: usize| corners[i]));
        }
        // A row is read at a time only where something was drawn.
        let wrong = counts(&mut cx).iter().filter(|n| **n != 0 && **n != 6).count();
        w.fuzzed += 1;
        w.count(wrong as u64, 256, || format!("triangle {round} {corners:?}"));
    }
}

fn inside_stays(w: &mut Worst) {
    let mut random = Random(77);
    for round in 0..500 {
        let corners: [[f64; 4]; 3] = std::array::from_fn(|_| {
            let depth = random.range(0.5, 4.0);
            [random.range(-1.5, 1.5) * depth, random.range(-1.5, 1.5) * depth, random.range(-0.9, 0.9) * depth, depth]
        });
        let draw = |planes: bool| {
            let mut cx = bytes(32, 32);
            cx.enable(GL_DEPTH_TEST);
            for k in 0..6 {
                // x + 100 w > 0 and so on: far away from everything.
                let mut plane = [0.0, 0.0, 0.0, 100.0];
                plane[k as usize / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
                cx.clip_plane(GL_CLIP_PLANE0 + k, &plane);
                if planes {
                    cx.enable(GL_CLIP_PLANE0 + k);
                }
            }
            cx.begin(GL_TRIANGLES);
            for (i, p) in corners.iter().enumerate() {
                cx.color4d(0.1 + 0.3 * i as f64, 0.9 - 0.4 * i as f64, 0.5, 1.0);
                cx.vertex4dv(p);
            }
            cx.end();
            no_error(&mut cx);
            (cx.pixels(), cx.depths())
        };
        w.fuzzed += 1;
        w.holds(draw(false) == draw(true), || format!("triangle {round}"));
    }
}

fn many_planes(w: &mut Worst) {
    let mut random = Random(8);
    for round in 0..500 {
        let mut scene = Scene::new(32, 32);
        scene.clip_planes = (0..6)
            .map(|k| {
                let angle = f64::from(k) + random.range(-0.4, 0.4);
                [angle.cos(), angle.sin(), random.range(-0.5, 0.5), random.range(0.2, 0.8)]
            })
            .collect();
        scene.triangles.push(std::array::from_fn(|_| {
            let mut v = Vertex::at(random.range(-4.0, 4.0), random.range(-4.0, 4.0), random.range(-2.0, 2.0));
            v.position[3] = random.range(0.5, 3.0);
            v
        }));
        let scene = as_given(&scene);
        let ideal = scene.render();
        let mut cx = floats(32, 32);
        crate::support::bridge::state(&mut cx, &scene);
        crate::support::bridge::triangles(&mut cx, &scene);
        let got = read(&mut cx);
        w.fuzzed += 1;
        let sure = ideal.pixels.iter().zip(&got).filter(|(p, _)| p.nearest_edge > 1.0 / 32.0);
        let wrong = sure.filter(|(p, c)| c.iter().any(|v| *v != if p.hits > 0 { 1.0 } else { 0.0 })).count();
        w.count(wrong as u64, 1024, || format!("triangle {round}"));
    }
}

fn guard_band(w: &mut Worst) {
    let mut random = Random(9);
    for round in 0..200 {
        let mut cx = counting(SIZE, SIZE);
        let centre = [random.range(0.0, 64.0) as f32, random.range(0.0, 64.0) as f32];
        let n = 5 + random.below(20);
        let mut fan = vec![centre];
        for k in 0..=n {
            let angle = k as f64 / n as f64 * std::f64::consts::TAU;
            let reach = if k == n { 0.0 } else { f64::from(any_size(&mut random, 2.2, 30.0).abs()) };
            fan.push([(32.0 + reach * angle.cos()) as f32, (32.0 + reach * angle.sin()) as f32]);
        }
        fan[n as usize + 1] = fan[1];
        // The guard band itself and its neighbours are among the corners.
        for (i, at) in [32767.0f32, 32766.996, 32767.004].into_iter().enumerate().filter(|_| round % 4 == 0) {
            let p = &mut fan[2 + i];
            *p = p.map(|v| if v == 0.0 { 0.0 } else { v / p[0].abs().max(p[1].abs()) * at });
        }
        emit(&mut cx, GL_TRIANGLE_FAN, &fan);
        let gap = fan.windows(2).skip(1).any(|e| turns_back(fan[0], e[0], e[1]));
        if gap {
            continue;
        }
        let got = counts(&mut cx);
        w.fuzzed += 1;
        w.count(got.iter().filter(|n| **n != 1).count() as u64, 4096, || format!("fan {round}: {fan:?}"));
    }
}

/// Whether the triangle of these positions is not counter-clockwise: the fan would fold over.
fn turns_back(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> bool {
    let d = |p: [f32; 2], k: usize| f64::from(p[k]) - f64::from(a[k]);
    d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0) <= 0.0
}
