//! Depth of fragments (OpenGL 1.5, sections 2.11.1, 3.4.1, 3.5.1, 3.5.5): polygons in one plane agree whatever their corners,
//! one unit of polygon offset can be resolved, and no depth leaves the range of its primitive. The right values are those of
//! the plane through the eye's ray, in f64.

use crate::support::{Random, get_i, no_error};
use fixedgl::enums::*;
use fixedgl::{Config, Context, FramebufferFormat};

const SIDE: u32 = 200;

fn with_depth(bits: u8) -> Config {
    let mut format = FramebufferFormat::default();
    format.depth_bits = bits;
    Config::default().with_format(format)
}

/// A context with so many depth bits that looks along -z with a field of view of 40 degrees.
fn context(depth_bits: u8) -> Context {
    let mut cx = Context::with_config(SIDE, SIDE, with_depth(depth_bits));
    assert_eq!(get_i(&mut cx, GL_DEPTH_BITS), i32::from(depth_bits));
    cx.matrix_mode(GL_PROJECTION);
    let half = NEAR * 20f64.to_radians().tan();
    cx.frustum(-half, half, -half, half, NEAR, FAR);
    cx.matrix_mode(GL_MODELVIEW);
    cx.enable(GL_DEPTH_TEST);
    cx
}

const NEAR: f64 = 0.1;
const FAR: f64 = 100.0;
const AWAY: f64 = 5.0;

/// Tilts in degrees.
const TILTS: [f64; 14] = [0.0, 3.0, 20.0, 45.0, 60.0, 70.0, 75.0, 80.0, 83.0, 85.0, 87.0, 88.0, 88.5, 89.0];

/// Axes around which the plane is tilted.
const AXES: [[f64; 3]; 3] = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.3, 1.0, 0.1]];

/// Looks at the plane z = 0 that is tilted and 5 units away.
fn tilt(cx: &mut Context, degrees: f64, [x, y, z]: [f64; 3]) {
    cx.load_identity();
    cx.translated(0.0, 0.0, -AWAY);
    cx.rotated(degrees, x, y, z);
}

/// The depth of that plane at the centre of a pixel, in steps of the depth buffer.
fn plane_depth([px, py]: [usize; 2], degrees: f64, axis: [f64; 3], steps: f64) -> f64 {
    let length = axis.iter().map(|v| v * v).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|v| v / length);
    let (sin, cos) = degrees.to_radians().sin_cos();
    // The third column of the rotation: the plane's normal.
    let normal = [x * z * (1.0 - cos) + y * sin, y * z * (1.0 - cos) - x * sin, z * z * (1.0 - cos) + cos];
    let ray = |p: usize| ((p as f64 + 0.5) / f64::from(SIDE) * 2.0 - 1.0) * 20f64.to_radians().tan();
    let dot = normal[0] * ray(px) + normal[1] * ray(py) - normal[2];
    let eye = AWAY * -normal[2] / dot;
    let device = (FAR + NEAR) / (FAR - NEAR) - 2.0 * FAR * NEAR / ((FAR - NEAR) * eye);
    (device * 0.5 + 0.5) * steps
}

/// The corners of a square of `n` by `n` cells around (x, y), each moved a little.
fn crooked(random: &mut Random, [x, y]: [f64; 2], size: f64, n: usize) -> Vec<Vec<[f32; 2]>> {
    let cell = size / n as f64;
    let mut at = |i: usize, from: f64| {
        let moved = random.range(-0.3, 0.3);
        (from - size / 2.0 + (i as f64 + moved) * cell) as f32
    };
    (0..=n).map(|j| (0..=n).map(|i| [at(i, x), at(j, y)]).collect()).collect()
}

fn mesh(cx: &mut Context, corners: &[Vec<[f32; 2]>]) {
    for rows in corners.windows(2) {
        cx.begin(GL_TRIANGLE_STRIP);
        for (low, high) in rows[0].iter().zip(&rows[1]) {
            cx.vertex2fv(low);
            cx.vertex2fv(high);
        }
        cx.end();
    }
}

fn depths(cx: &mut Context) -> Vec<f64> {
    let steps = f64::from(u32::MAX >> (32 - get_i(cx, GL_DEPTH_BITS)));
    let all = cx.depths();
    no_error(cx);
    all.iter().map(|z| z * steps).collect()
}

#[test]
fn triangulations_of_one_plane_have_the_planes_depth_within_one_step_of_24_bits_at_every_tilt() {
    let mut random = Random(81);
    let steps = f64::from((1 << 24) - 1);
    let (mut compared, mut worst) = (0, 0.0f64);
    for axis in AXES {
        for degrees in TILTS {
            for n in [1, 2, 7, 23] {
                let mut cx = context(24);
                cx.clear(GL_DEPTH_BUFFER_BIT);
                tilt(&mut cx, degrees, axis);
                let corners = crooked(&mut random, [0.0; 2], 2.5, n);
                mesh(&mut cx, &corners);
                for (i, z) in depths(&mut cx).into_iter().enumerate().filter(|(_, z)| *z < steps) {
                    let at = [i % SIDE as usize, i / SIDE as usize];
                    let want = plane_depth(at, degrees, axis, steps);
                    worst = worst.max((z - want).abs());
                    assert!((z - want).abs() <= 0.51, "{degrees} around {axis:?}, {n} cells, {at:?}: {z} for {want}");
                    compared += 1;
                }
            }
        }
    }
    eprintln!("depth of tilted planes: {compared} pixels, worst {worst:.3} steps of 24 bits");
    assert!(compared > 500_000, "{compared}");
}

#[test]
fn a_decal_one_unit_nearer_passes_at_every_tilt_and_depth_format() {
    let mut random = Random(82);
    for depth_bits in [16, 24, 32] {
        for axis in AXES {
            for degrees in TILTS {
                let mut cx = context(depth_bits);
                tilt(&mut cx, degrees, axis);
                let base = crooked(&mut random, [0.0; 2], 3.4, 3);
                let decals: Vec<_> = (0..49)
                    .map(|i| crooked(&mut random, [i % 7, i / 7].map(|k| (f64::from(k) - 3.0) * 0.36), 0.25, 2))
                    .collect();
                let mut green = |offset: bool| {
                    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                    cx.disable(GL_POLYGON_OFFSET_FILL);
                    cx.depth_func(GL_LESS);
                    cx.color3f(1.0, 0.0, 0.0);
                    mesh(&mut cx, &base);
                    if offset {
                        cx.enable(GL_POLYGON_OFFSET_FILL);
                        cx.polygon_offset(0.0, -1.0);
                    } else {
                        cx.depth_func(GL_ALWAYS);
                    }
                    cx.color3f(0.0, 1.0, 0.0);
                    decals.iter().for_each(|decal| mesh(&mut cx, decal));
                    crate::support::pixels(&mut cx, SIDE, SIDE).iter().filter(|p| p[1] == 255).count()
                };
                let (all, passed) = (green(false), green(true));
                assert!(all > 0 && passed == all, "{depth_bits} bits, {degrees} around {axis:?}: {passed} of {all}");
            }
        }
    }
}

#[test]
fn each_unit_of_offset_makes_a_difference_at_every_depth_and_depth_format() {
    for depth_bits in [16u8, 24, 32] {
        let steps = f64::from(u32::MAX >> (32 - u32::from(depth_bits)));
        let mut cx = Context::with_config(64, 1, with_depth(depth_bits));
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(GL_ALWAYS);
        cx.enable(GL_POLYGON_OFFSET_FILL);
        let mut random = Random(83);
        for round in 0..40 {
            // Ties between two steps as well, up to the ends of the range.
            let from = match round {
                0 => 3.0,
                1 => steps - 40.0,
                _ => 4.0 + (random.range(0.0, 1.0) * (steps - 50.0)).floor(),
            };
            let units = [-2.0, -1.0, 0.0, 1.0, 2.0];
            let rows = units.map(|units| {
                cx.polygon_offset(0.0, units);
                for i in 0..64 {
                    let z = (from + f64::from(i) * 0.5) / steps;
                    cx.depth_range(z, z);
                    let [x0, x1] = [0, 1].map(|k| (i + k) as f32 / 32.0 - 1.0);
                    cx.rectf(x0, -1.0, x1, 1.0);
                }
                depths(&mut cx)
            });
            for i in 0..64 {
                for pair in rows.windows(2) {
                    let moved = pair[1][i] - pair[0][i];
                    assert!((0.9..=2.1).contains(&moved), "{depth_bits} bits at {from} + {i}/2: moved by {moved}");
                }
            }
        }
    }
}

/// The least and the greatest depth of what `draw` draws with depths from 0.4 to 0.6 at its vertices.
fn range_of(draw: impl FnOnce(&mut Context, &mut Random), seed: u64) -> Option<[f64; 2]> {
    let mut cx = Context::new(SIDE, SIDE);
    cx.ortho(0.0, f64::from(SIDE), 0.0, f64::from(SIDE), 1.0, -1.0);
    cx.enable(GL_DEPTH_TEST);
    cx.depth_func(GL_ALWAYS);
    cx.clear_depth(0.0);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    draw(&mut cx, &mut Random(seed));
    let drawn: Vec<f64> = cx.depths().into_iter().filter(|z| *z > 0.0).collect();
    no_error(&mut cx);
    let least = drawn.iter().copied().fold(f64::INFINITY, f64::min);
    (!drawn.is_empty()).then(|| [least, drawn.iter().copied().fold(0.0, f64::max)])
}

#[test]
fn partly_covered_pixels_lines_and_points_have_depths_of_their_primitive() {
    let (low, high, step) = (0.4, 0.6, 1.0 / f64::from(1 << 24));
    let vertex = |cx: &mut Context, random: &mut Random, at: [f64; 2], reach: f64| {
        let z = random.pick(&[low, high, 0.5]);
        cx.vertex3d(at[0] + random.range(0.0, reach), at[1] + random.range(0.0, reach), 2.0 * z - 1.0);
    };
    for seed in 1..300 {
        for (mode, smooth) in [
            (GL_TRIANGLES, Some(GL_POLYGON_SMOOTH)),
            (GL_LINES, Some(GL_LINE_SMOOTH)),
            (GL_LINES, None),
            (GL_POINTS, Some(GL_POINT_SMOOTH)),
            (GL_POINTS, None),
        ] {
            let got = range_of(
                |cx, random| {
                    if let Some(smooth) = smooth {
                        cx.enable(smooth);
                    }
                    let size = random.range(1.0, 9.0) as f32;
                    cx.line_width(size);
                    cx.point_size(size);
                    let reach = random.pick(&[0.2, 2.0, 40.0]);
                    cx.begin(mode);
                    (0..6).for_each(|_| vertex(cx, random, [50.0, 60.0], reach));
                    cx.end();
                },
                seed,
            );
            if let Some([least, greatest]) = got {
                let right = least >= low - step && greatest <= high + step;
                assert!(right, "{mode:#x}, smooth {smooth:?}, {seed}: {least}..{greatest}");
            }
        }
    }
}

#[test]
fn depths_read_as_integers_are_those_of_the_buffer() {
    // Section 4.3.2, table 4.6: c = (2^b - 1) f, or (c + 1/2) (2 / (2^b - 1)) of signed types, rounded; f = k / (2^n - 1).
    let mut random = Random(84);
    for depth_bits in [16u8, 24, 32] {
        let steps = u64::from(u32::MAX >> (32 - u32::from(depth_bits)));
        let mut cx = Context::with_config(64, 64, with_depth(depth_bits));
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(GL_ALWAYS);
        cx.enable(GL_SCISSOR_TEST);
        for round in 0..6 {
            let values: Vec<u64> = (0..4096)
                .map(|i| match round {
                    // Where f32 has its coarsest steps.
                    0 => steps - i,
                    1 => i,
                    2 => steps / 2 + i,
                    _ => random.below(steps + 1),
                })
                .collect();
            for (i, k) in values.iter().enumerate() {
                cx.scissor(i as i32 % 64, i as i32 / 64, 1, 1);
                cx.clear_depth(*k as f64 / steps as f64);
                cx.clear(GL_DEPTH_BUFFER_BIT);
            }
            let rounded =
                |k: u64, max: u64| (u128::from(k) * u128::from(max) * 2 + u128::from(steps)) / (2 * u128::from(steps));
            let mut ints = vec![0u32; 4096];
            cx.read_pixels(0, 0, 64, 64, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &mut ints);
            let mut shorts = vec![0u16; 4096];
            cx.read_pixels(0, 0, 64, 64, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, &mut shorts);
            let mut pairs = vec![0u32; 4096];
            cx.read_pixels(0, 0, 64, 64, GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT, &mut pairs);
            no_error(&mut cx);
            for (i, k) in values.iter().enumerate() {
                assert_eq!(u128::from(ints[i]), rounded(*k, u32::MAX.into()), "{k} of {depth_bits} bits");
                assert_eq!(u128::from(shorts[i]), rounded(*k, u16::MAX.into()), "{k} of {depth_bits} bits");
                assert_eq!(u128::from(pairs[i] >> 8), rounded(*k, (1 << 24) - 1), "{k} of {depth_bits} bits");
            }
        }
    }
}
