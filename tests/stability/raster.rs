//! Rasterisation (OpenGL 1.5, section 3.5): coverage of huge, thin and empty triangles, shared edges, values that must not
//! depend on where in the window a triangle lies, depths that must be the same when it is drawn again.

use crate::oracle::matrix::M4;
use crate::oracle::raster::{Triangle, Window, coverage_within, snap};
use crate::stability::common::{
    Color, bytes, counting, counts, emit, everywhere, floats, part, read, window_coordinates,
};
use crate::stability::row::{Worst, rows};
use crate::support::{Random, no_error};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    edge_functions: "R1", "20,000 triangles with corners anywhere within +-32767 pixels", "coverage by 128-bit integers",
        0.0, "pixels", "positions on 1/256 pixel, edges in i64";
    shared_edges: "R2", "meshes of 10,000 triangles: crooked grids, thin strips, fans", "each pixel once", 0.0, "pixels",
        "integers and one owner for each edge";
    pixel_centres: "R3", "quads with corners on centres and edges through centres, both windings, side by side",
        "each pixel once", 0.0, "pixels", "left and top edges own their centres";
    empty_triangles: "R4", "10,000 triangles of area 0: equal corners, corners on a line", "nothing", 0.0, "pixels",
        "area of whole numbers; no division by it";
    slivers: "R5", "100,000 random slivers, 1/1000 to 1/2 pixel wide, each with its own range of values",
        "every value within the range of its three corners", 0.0, "of the range",
        "planes limited to the least and greatest corner";
    t_junctions: "R6", "1000 T-junctions on a long edge", "cracks allowed, of one pixel; no pixel of a part twice", 0.0,
        "pixels beyond 1/128 pixel of the edge", "snap to 1/256 pixel";
    far_from_the_start: "R7", "a triangle 16,384 pixels wide with 256 texels in every 64 pixels",
        "equation 3.6, equally good at both ends", 2e-3, "texels", "each fragment from the plane, nothing is stepped";
    moved_by_pixels: "R8", "1000 triangles with texture, colours, fog and depth, moved by up to 8128 x 1984 pixels",
        "the same picture to the last bit", 0.0, "pictures that differ", "planes start at a pixel of the triangle";
    steep_perspective: "R9", "1000 triangles 16,000 pixels from the window's corner, w ratios 1, 1e3, 1e6",
        "equation 3.6", 5e-3, "texels of 256", "differences from the far corner; f64 where f32 would lose 2^-11 texel";
    depth_planes: "R10", "2000 triangles near the corner and 16,000 pixels away", "the plane through the corners, off the grid",
        0.51, "steps of 24 bits", "f64 from unsnapped positions, rounded once";
    drawn_again: "R10b", "100 triangles drawn again with EQUAL: textured, lit, blended, fogged, stippled, offset 0, clipped away from",
        "every fragment passes", 0.0, "fragments that fail", "depth from one matrix and the same weights, whatever else is on";
}

/// A triangle of window positions and its coverage in a window, by whole numbers.
fn covered(t: [[f32; 2]; 3], width: i64, height: i64) -> Vec<[i64; 2]> {
    coverage_within(t.map(|p| p.map(|v| snap(f64::from(v)))), [[0, width - 1], [0, height - 1]])
}

fn edge_functions(w: &mut Worst) {
    let mut random = Random(1);
    let mut cx = counting(16, 16);
    for round in 0..20_000 {
        let reach = [64.0, 1000.0, 32700.0][round % 3];
        // Every other triangle has an edge through the window.
        let mut at = || [random.range(-reach, reach) as f32, random.range(-reach, reach) as f32];
        let (a, b, c) = (at(), at(), at());
        let t = if round % 2 == 0 { [a, b, c] } else { [a, [16.0 - a[0], 16.0 - a[1]], c] };
        let t = t.map(|p| p.map(|v| (v * 256.0).round() / 256.0));
        cx.clear(GL_COLOR_BUFFER_BIT);
        emit(&mut cx, GL_TRIANGLES, &t);
        let mut want = [0u8; 256];
        for [x, y] in covered(t, 16, 16) {
            want[(y * 16 + x) as usize] = 1;
        }
        w.fuzzed += 1;
        let wrong = counts(&mut cx).iter().zip(want).filter(|(a, b)| *a != b).count();
        w.count(wrong as u64, 256, || format!("triangle {t:?}"));
    }
}

fn shared_edges(w: &mut Worst) {
    let mut random = Random(2);
    for (columns, rows, shift) in [(70, 71, 0.24), (71, 70, 0.0), (5, 1000, 0.24), (1000, 5, 0.24)] {
        let mut cx = counting(256, 256);
        let step = [256.0 / f64::from(columns), 256.0 / f64::from(rows)];
        let points: Vec<[f32; 2]> = (0..(columns + 1) * (rows + 1))
            .map(|k| {
                let (i, j) = (k % (columns + 1), k / (columns + 1));
                let mut at = |n: i32, end: i32, step: f64| {
                    let inner = n > 0 && n < end;
                    ((f64::from(n) + if inner { random.range(-shift, shift) } else { 0.0 }) * step) as f32
                };
                [at(i, columns, step[0]), at(j, rows, step[1])]
            })
            .collect();
        cx.begin(GL_TRIANGLES);
        for (i, j) in (0..columns * rows).map(|k| (k % columns, k / columns)) {
            let p = |a: i32, b: i32| points[((j + b) * (columns + 1) + i + a) as usize];
            let quad = [p(0, 0), p(1, 0), p(1, 1), p(0, 1)];
            let order = if (i + j) % 2 == 0 { [0, 1, 2, 2, 3, 0] } else { [1, 2, 3, 0, 1, 3] };
            order.iter().for_each(|&k: &usize| cx.vertex2fv(&quad[k]));
        }
        cx.end();
        w.fuzzed += (2 * columns * rows) as u64;
        let wrong = counts(&mut cx).iter().filter(|n| **n != 1).count();
        w.count(wrong as u64, 65536, || format!("grid {columns} x {rows}, shift {shift}"));
    }
    let mut cx = counting(256, 256);
    let mut fan = vec![[100.123f32, 77.7]];
    for k in 0..10_000 {
        let angle = f64::from(k) / 10_000.0 * std::f64::consts::TAU;
        fan.push([(100.0 + 400.0 * angle.cos()) as f32, (77.0 + 400.0 * angle.sin()) as f32]);
    }
    fan.push(fan[1]);
    emit(&mut cx, GL_TRIANGLE_FAN, &fan);
    w.count(counts(&mut cx).iter().filter(|n| **n != 1).count() as u64, 65536, || "a fan of 10,000".into());
}

fn pixel_centres(w: &mut Worst) {
    for half in [0.0f32, 0.5] {
        for order in [[0, 1, 2, 3], [3, 2, 1, 0]] {
            let mut cx = counting(32, 32);
            for (i, j) in (0..16).map(|k| (k % 4, k / 4)) {
                let at = |a: i32, b: i32| [(8 * (i + a)) as f32 + half, (8 * (j + b)) as f32 + half];
                let quad = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                emit(&mut cx, GL_QUADS, &order.map(|k: usize| quad[k]));
            }
            let got = counts(&mut cx);
            for (i, n) in got.iter().enumerate() {
                let inner = half == 0.0 || i % 32 > 0 && i / 32 > 0;
                w.count(u64::from(if inner { *n != 1 } else { *n > 1 }), 1, || format!("pixel {i}, + {half}"));
            }
        }
    }
    // Diagonals that run through centres.
    let mut cx = counting(32, 32);
    for (a, b, c) in [([0.0, 0.0], [32.0, 0.0], [32.0, 32.0]), ([0.0, 0.0], [32.0, 32.0], [0.0, 32.0])] {
        emit(&mut cx, GL_TRIANGLES, &[a, b, c]);
    }
    w.count(counts(&mut cx).iter().filter(|n| **n != 1).count() as u64, 1024, || "diagonal".into());
}

fn empty_triangles(w: &mut Worst) {
    let mut random = Random(4);
    let mut cx = counting(64, 64);
    for _ in 0..10_000 {
        let whole = |random: &mut Random| [random.below(128) as f32 / 2.0, random.below(128) as f32 / 2.0];
        let (a, d) = (whole(&mut random), whole(&mut random));
        let k = random.below(9) as f32 - 4.0;
        let t = match random.below(4) {
            0 => [a, a, d],
            1 => [a, d, a],
            2 => [a, a, a],
            _ => [a, [a[0] + d[0], a[1] + d[1]], [a[0] + k * d[0], a[1] + k * d[1]]],
        };
        w.fuzzed += 1;
        emit(&mut cx, GL_TRIANGLES, &t);
    }
    w.count(counts(&mut cx).iter().filter(|n| **n != 0).count() as u64, 10_000, || "something was drawn".into());
}

/// Slivers 1000 at a time; the blue channel is a sliver's number, which is the same at its corners.
fn slivers(w: &mut Worst) {
    let mut random = Random(5);
    let mut cx = floats(128, 128);
    window_coordinates(&mut cx, 128, 128);
    let mut seen = 0;
    for round in 0..100 {
        cx.clear(GL_COLOR_BUFFER_BIT);
        let mut ranges = vec![[0f32; 2]];
        cx.begin(GL_TRIANGLES);
        for number in 1..=1000 {
            let p = |random: &mut Random| [random.range(0.0, 128.0), random.range(0.0, 128.0)];
            let (a, b, t) = (p(&mut random), p(&mut random), random.range(-0.2, 1.2));
            let mut near =
                |k: usize| a[k] + t * (b[k] - a[k]) + random.range(-1.0, 1.0) * [0.001, 0.01, 0.1, 0.5][round % 4];
            let c = [near(0), near(1)];
            let values: [f32; 3] = std::array::from_fn(|_| random.range(0.0, 1.0) as f32);
            for (p, v) in [a, b, c].iter().zip(values) {
                cx.color4f(v, 1.0 - v, number as f32 / 1024.0, 1.0);
                let depth = if round % 2 == 0 { 1.0 } else { random.range(0.1, 10.0) as f32 };
                cx.vertex4f(p[0] as f32 * depth, p[1] as f32 * depth, 0.0, depth);
            }
            ranges.push([values.iter().copied().fold(2.0, f32::min), values.iter().copied().fold(-1.0, f32::max)]);
            w.fuzzed += 1;
        }
        cx.end();
        no_error(&mut cx);
        for [value, _, number, alpha] in read(&mut cx) {
            if alpha > 0.0 {
                seen += 1;
                let [low, high] = ranges[(number * 1024.0) as usize];
                let beyond = (low - value).max(value - high).max(0.0);
                w.see(f64::from(beyond), || format!("round {round}: {value} in {low}..{high}"));
            }
        }
    }
    w.holds(seen > 100_000, || format!("only {seen} fragments"));
}

fn t_junctions(w: &mut Worst) {
    let mut random = Random(6);
    for round in 0..1000 {
        let mut cx = counting(32, 32);
        let mut p = |low: f64, high: f64| [random.range(low, high) as f32, random.range(low, high) as f32];
        let (a, b) = (p(-4.0, 8.0), p(24.0, 36.0));
        let t = random.range(0.2, 0.8) as f32;
        let middle = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
        let (left, right) = ([-40.0, 60.0], [60.0, -40.0]);
        for corners in [[a, b, left], [a, right, middle], [middle, right, b]] {
            emit(&mut cx, GL_TRIANGLES, &corners);
        }
        w.fuzzed += 1;
        let [dx, dy] = [f64::from(b[0] - a[0]), f64::from(b[1] - a[1])];
        let lengths = (dx * dx + dy * dy).sqrt();
        for (i, n) in counts(&mut cx).into_iter().enumerate() {
            let at = [(i % 32) as f64 + 0.5 - f64::from(a[0]), (i / 32) as f64 + 0.5 - f64::from(a[1])];
            let beside = ((at[0] * dy - at[1] * dx) / lengths).abs();
            let along = (at[0] * dx + at[1] * dy) / lengths;
            let inside = along > 4.0 && along < lengths - 4.0 && beside < 1.0;
            w.count(u64::from(inside && n != 1 && beside > 1.0 / 128.0 || n > 1 && beside > 1.0 / 128.0), 1, || {
                format!("round {round}, pixel {i}: {n} hits, {beside} beside")
            });
        }
    }
}

/// A texture of 256 texels whose red is the number of the column; LINEAR.
fn ramp(cx: &mut Context) {
    let texels: Vec<u8> = (0..=255).collect();
    cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_LUMINANCE8 as i32, 256, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    cx.tex_parameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_1D);
}

/// The texel position in 0..256 that a colour of the ramp stands for, and its distance from where it should be; nothing
/// over the seam.
fn texels_off(color: Color, s: f64) -> Option<f64> {
    let want = (s * 256.0).rem_euclid(256.0);
    (1.0..255.0).contains(&want).then(|| f64::from(color[0]) * 255.0 + 0.5 - want)
}

fn far_from_the_start(w: &mut Worst) {
    let mut cx = floats(16384, 4);
    window_coordinates(&mut cx, 16384, 4);
    ramp(&mut cx);
    for w_right in [1.0, 3.0] {
        let corners = [[0.0, -9.0, 1.0], [16384.0, -9.0, w_right], [0.0, 19.0, 1.0]];
        cx.begin(GL_TRIANGLES);
        for [x, y, depth] in corners {
            cx.tex_coord2d(x / 64.0, 0.0);
            cx.vertex4d(x * depth, y * depth, 0.0, depth);
        }
        cx.end();
        let triangle = Triangle(corners.map(|[x, y, depth]| Window { x, y, z: 0.0, inv_w: 1.0 / depth }));
        let got = part(&mut cx, [0, 0], [16384, 1]);
        for (x, color) in got.into_iter().enumerate() {
            let (s, _) = triangle.interpolate([x as f64 + 0.5, 0.5], corners.map(|c| c[0] / 64.0), [1.0; 3]);
            let inside = triangle.edge_distance(x as f64 + 0.5, 0.5) > 0.01;
            if let Some(off) = texels_off(color, s).filter(|_| inside) {
                w.see(off, || format!("w = {w_right} at {x}"));
            }
        }
    }
}

fn moved_by_pixels(w: &mut Worst) {
    let mut random = Random(8);
    let mut cx = floats(8192, 2048);
    let noise: Vec<[u8; 4]> = (0..4096).map(|_| (random.bits() as u32).to_le_bytes()).collect();
    cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, noise.as_flattened());
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    cx.matrix_mode(GL_PROJECTION);
    cx.load_matrixd(&M4::perspective(90.0, 1.0, 0.5, 50.0).to_gl());
    for cap in [GL_TEXTURE_2D, GL_DEPTH_TEST, GL_FOG, GL_SCISSOR_TEST] {
        cx.enable(cap);
    }
    cx.fogi(GL_FOG_MODE, GL_LINEAR);
    cx.fogf(GL_FOG_END, 40.0);
    for round in 0..1000 {
        cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, if round % 3 == 0 { 4.0 } else { 1.0 });
        let corners: [[f32; 8]; 3] = std::array::from_fn(|_| {
            let z = random.range(-20.0, if round % 4 == 0 { 1.0 } else { -0.6 });
            let mut v = std::array::from_fn(|_| random.range(-3.0, 3.0) as f32);
            v[..3].copy_from_slice(&[random.range(-1.5, 1.5) * z, random.range(-1.5, 1.5) * z, z].map(|v| v as f32));
            v
        });
        let mut picture = |x: i32, y: i32| {
            cx.viewport(x, y, 64, 64);
            cx.scissor(x, y, 64, 64);
            cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            cx.begin(GL_TRIANGLES);
            for v in corners {
                cx.tex_coord2f(v[3], v[4]);
                cx.color3f(v[5], v[6], v[7]);
                cx.vertex3f(v[0], v[1], v[2]);
            }
            cx.end();
            let mut depths = vec![0u32; 4096];
            cx.read_pixels(x, y, 64, 64, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &mut depths);
            (part(&mut cx, [x, y], [64, 64]), depths)
        };
        let still = picture(0, 0);
        let (x, y) = (random.below(8129) as i32, random.below(1985) as i32);
        w.fuzzed += 1;
        w.holds(picture(x, y) == still, || format!("triangle {round} moved by {x}, {y}"));
    }
}

fn steep_perspective(w: &mut Worst) {
    let mut random = Random(9);
    let mut cx = floats(16384, 32);
    window_coordinates(&mut cx, 16384, 32);
    ramp(&mut cx);
    for round in 0..1000 {
        let ratio: f64 = [1.0, 1e3, 1e6][round % 3];
        let corners: [[f64; 4]; 3] = std::array::from_fn(|i| {
            let depth = f64::from(ratio.powf(if i == 0 { 0.0 } else { random.range(0.0, 1.0) }) as f32);
            let at = [random.range(15_990.0, 16_040.0), random.range(-10.0, 42.0)];
            let clip = [at[0] * depth, at[1] * depth].map(|v| f64::from(v as f32));
            [clip[0], clip[1], depth, random.range(-1.0, 1.0)]
        });
        cx.clear(GL_COLOR_BUFFER_BIT);
        cx.begin(GL_TRIANGLES);
        for [x, y, depth, s] in corners {
            cx.tex_coord2d(s, 0.0);
            cx.vertex4d(x, y, 0.0, depth);
        }
        cx.end();
        let window = |[x, y, depth, _]: [f64; 4]| Window { x: x / depth, y: y / depth, z: 0.0, inv_w: 1.0 / depth };
        let triangle = Triangle(corners.map(window));
        w.fuzzed += 1;
        for (i, color) in part(&mut cx, [15_984, 0], [64, 32]).into_iter().enumerate() {
            let at = [(i % 64) as f64 + 15_984.5, (i / 64) as f64 + 0.5];
            if triangle.edge_distance(at[0], at[1]) > 0.01 {
                let (s, _) = triangle.interpolate(at, corners.map(|c| c[3]), [1.0; 3]);
                if let Some(off) = texels_off(color, s) {
                    w.see(off, || format!("triangle {round} at {at:?}: {corners:?}"));
                }
            }
        }
    }
}

fn depth_planes(w: &mut Worst) {
    let mut random = Random(10);
    let mut cx = bytes(16384, 32);
    window_coordinates(&mut cx, 16384, 32);
    cx.enable(GL_DEPTH_TEST);
    for round in 0..2000 {
        let base = [0.0, 16_000.0][round % 2];
        let corners: [[f64; 3]; 3] = std::array::from_fn(|_| {
            // An f32 near 16,000 holds no more than this.
            let fine = |v: f64| (v * 1024.0).round() / 1024.0;
            [base + fine(random.range(-10.0, 42.0)), fine(random.range(-10.0, 42.0)), random.range(-1.0, 1.0)]
        });
        cx.clear(GL_DEPTH_BUFFER_BIT);
        cx.begin(GL_TRIANGLES);
        corners.iter().for_each(|p| cx.vertex3dv(p));
        cx.end();
        let mut depths = vec![0u32; 1024];
        cx.read_pixels(base as i32, 0, 32, 32, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &mut depths);
        let triangle = Triangle(corners.map(|[x, y, z]| Window { x, y, z: 0.5 - 0.5 * z, inv_w: 1.0 }));
        w.fuzzed += 1;
        for (i, depth) in depths.into_iter().enumerate() {
            let at = [(i % 32) as f64 + base + 0.5, (i / 32) as f64 + 0.5];
            if triangle.edge_distance(at[0], at[1]) > 0.01 {
                let off = f64::from(depth >> 8) - triangle.depth(at) * f64::from((1 << 24) - 1);
                w.see(off, || format!("triangle {round} at {at:?}"));
            }
        }
    }
}

type Change = fn(&mut Context);

/// States that must not move a fragment or its depth.
const CHANGES: &[Change] = &[
    |_| {},
    |cx| cx.enable(GL_TEXTURE_2D),
    |cx| cx.enable(GL_LIGHTING),
    |cx| cx.enable(GL_FOG),
    |cx| cx.enable(GL_BLEND),
    |cx| cx.shade_model(GL_FLAT),
    |cx| cx.enable(GL_TEXTURE_GEN_S),
    |cx| cx.color_mask(true, false, true, false),
    |cx| cx.depth_mask(false),
    |cx| cx.enable(GL_POLYGON_OFFSET_FILL),
    |cx| cx.enable(GL_NORMALIZE),
    |cx| {
        cx.clip_plane(GL_CLIP_PLANE0, &[0.0, 0.0, 0.0, 1.0]);
        cx.enable(GL_CLIP_PLANE0);
    },
    |cx| {
        cx.polygon_stipple(&[0xFFu8; 128]);
        cx.enable(GL_POLYGON_STIPPLE);
    },
    |cx| {
        cx.alpha_func(GL_GEQUAL, 0.0);
        cx.enable(GL_ALPHA_TEST);
    },
];

fn drawn_again(w: &mut Worst) {
    let mut random = Random(11);
    for round in 0..100 {
        let corners: [[f32; 4]; 3] = std::array::from_fn(|_| {
            let z = random.range(-20.0, if round % 3 == 0 { 2.0 } else { -0.6 });
            [random.range(-1.5, 1.5) * z, random.range(-1.5, 1.5) * z, z, 1.0].map(|v| v as f32)
        });
        let change = CHANGES[round % CHANGES.len()];
        let draw = |cx: &mut Context| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[255u8; 4]);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            cx.matrix_mode(GL_PROJECTION);
            cx.load_matrixd(&M4::perspective(70.0, 1.0, 0.5, 50.0).to_gl());
            cx.matrix_mode(GL_MODELVIEW);
            cx.load_matrixd(&M4::rotation(20.0, [0.3, 1.0, -0.2]).to_gl());
            cx.enable(GL_DEPTH_TEST);
            let triangle = |cx: &mut Context| {
                cx.begin(GL_TRIANGLES);
                corners.iter().for_each(|p| cx.vertex4fv(p));
                cx.end();
            };
            triangle(cx);
            cx.push_attrib(GL_ALL_ATTRIB_BITS);
            change(cx);
            cx.depth_func(GL_EQUAL);
            cx.enable(GL_STENCIL_TEST);
            cx.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
            triangle(cx);
            cx.pop_attrib();
        };
        let mut cx = bytes(64, 64);
        draw(&mut cx);
        let (depths, stencils) = (cx.depths(), cx.stencils());
        let failed = depths.iter().zip(stencils).filter(|(d, s)| (**d < 1.0) != (*s == 1)).count();

        w.count(failed as u64, 4096, || format!("triangle {round}, change {}", round % CHANGES.len()));
        if round < CHANGES.len() {
            everywhere(w, [64, 64], draw);
        }
    }
}
