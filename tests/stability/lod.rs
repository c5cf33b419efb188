//! Level of detail (OpenGL 1.5, section 3.8.8). A pyramid whose level d has the value 16 d shows lambda as a colour: the
//! trilinear mixture of 16 d and 16 (d + 1) is 16 lambda, and a framebuffer of floats keeps it to 1e-6.

use crate::stability::common::{bytes, cover, everywhere, floats, read};
use crate::stability::row::{Worst, rows};
use crate::support::{Random, no_error};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    rho_zero: "L1", "the same coordinates everywhere; MIN_LOD -1000, 0, 2.5; bias", "the base level; MIN_LOD", 1e-5, "levels",
        "log2 of 0 is -127, then the limits";
    rho_huge: "L2", "1e3 to 1e36 texels a pixel, coordinates to 3e38", "the last level; MAX_LOD", 1e-5, "levels", "log2 of infinity is 128, then the limits";
    rho_no_number: "L3", "coordinates of +-3e38 at the corners, w ratios of 1e38: slopes that are infinite or none; anisotropy 1 and 16",
        "undefined; ours: a level of the texture", 0.0, "wrong pictures", "max and min of comparisons take NaN to MIN_LOD";
    limits_crossed: "L4", "MIN_LOD above MAX_LOD, NaN and infinite limits and biases", "undefined; ours: MIN_LOD counts", 1e-5, "levels",
        "min first, then max";
    ties: "L5", "lambda at 0.5, 1.5, 2.5, ... and 2^-18 beside them, by bias; c = 0 and 0.5", "ties go to the finer level; magnified up to c", 0.0,
        "wrong levels", "ceil(lambda - 1/2); log2 of powers of two is exact";
    bias_and_range: "L6", "sums of biases beyond MAX_TEXTURE_LOD_BIAS, base and max level, base above max", "clamped sum; levels counted from base; no texture", 1e-5,
        "levels", "bias limited before it is added";
    horizon: "L7", "a floor down to 0.01 pixel from its horizon, 1e-3 to 1e4 texels a unit", "log2 of rho of the ray", 1e-4, "levels",
        "derivatives from the planes, (N_x - (N/Q) Q_x)/Q";
    seam: "L8", "4 texels a pixel over the seam of REPEAT and MIRRORED_REPEAT, far from 0", "lambda 2 everywhere", 1e-5, "levels",
        "derivatives before wrapping";
    anisotropy: "L9", "ratios of the footprint's sides up to 1e6 and infinite; degrees 1 to 16", "log2(Pmax/N), N limited", 1e-3, "levels",
        "0 under the ratio gives the greatest degree; 2^-10 above a whole number is one";
    points_and_lines: "L10", "points of size 1 and 9, lines of length 0, 1e-30 and 60, a mipmapped texture", "the base level of points; a number", 0.0,
        "wrong pictures", "rho 1 for points, no slopes for lines without length";
}

/// A pyramid of 64 x 64 whose level d has the value 16 d, and filters that show lambda.
fn pyramid(cx: &mut Context, size: i32) {
    for level in 0..=size.ilog2() as i32 {
        let n = (size >> level).max(1);
        let texels = vec![(16 * level) as u8; (n * n) as usize];
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        cx.tex_image_2d(GL_TEXTURE_2D, level, GL_LUMINANCE8 as i32, n, n, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    }
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
    no_error(cx);
}

fn lambda_of(color: [f32; 4]) -> f64 {
    f64::from(color[0]) * 255.0 / 16.0
}

/// A quad with `k` texels of 64 a pixel in s and `l` in t over a window of 32.
fn scaled(cx: &mut Context, k: f32, l: f32) {
    cover(cx, |cx, i| cx.tex_coord2f(if i == 1 || i == 2 { k * 0.5 } else { 0.0 }, if i > 1 { l * 0.5 } else { 0.0 }));
}

/// Lambda of every pixel of such a quad, after some change of state.
fn lambdas(k: f32, l: f32, change: impl Fn(&mut Context)) -> Vec<f64> {
    let mut cx = floats(32, 32);
    pyramid(&mut cx, 64);
    change(&mut cx);
    scaled(&mut cx, k, l);
    no_error(&mut cx);
    read(&mut cx).into_iter().map(lambda_of).collect()
}

fn see_lambda(w: &mut Worst, got: &[f64], want: f64, what: impl Fn() -> String) {
    for l in got {
        w.see(l - want, || format!("{}: {l}, want {want}", what()));
    }
}

fn parameter(cx: &mut Context, pname: GLenum, v: f32) {
    cx.tex_parameterf(GL_TEXTURE_2D, pname, v);
}

fn rho_zero(w: &mut Worst) {
    for (least, bias) in [(-1000.0f32, 0.0f32), (0.0, 0.0), (2.5, 0.0), (2.5, -14.0), (-3.0, 14.0), (1.0, 14.0)] {
        let got = lambdas(0.0, 0.0, |cx| {
            parameter(cx, GL_TEXTURE_MIN_LOD, least);
            parameter(cx, GL_TEXTURE_LOD_BIAS, bias);
        });
        see_lambda(w, &got, f64::from(least.max(0.0)), || format!("MIN_LOD {least}, bias {bias}"));
    }
}

fn rho_huge(w: &mut Worst) {
    for k in [1e3f32, 1e6, 1e12, 1e18, 1e19, 1e20, 1e30, 1e36] {
        for most in [1000.0f32, 3.25] {
            for (s, t) in [(k, k), (k, 0.0), (0.0, k), (-k, k)] {
                let got = lambdas(s, t, |cx| parameter(cx, GL_TEXTURE_MAX_LOD, most));
                see_lambda(w, &got, f64::from(most.min(6.0)), || format!("{k} texels a pixel, MAX_LOD {most}"));
            }
        }
    }
}

fn rho_no_number(w: &mut Worst) {
    let m = f32::MAX;
    let corners = [
        [[m, m, 1.0], [-m, -m, 1.0], [m, -m, 1.0]],
        [[m, 0.0, 1e-30], [-m, 0.0, 1.0], [0.0, m, 1e30]],
        [[1.0, 0.0, 1e-38], [0.0, 1.0, 1e38], [0.0, 0.0, 1.0]],
        [[f32::NAN, 1.0, 1.0], [f32::INFINITY, 0.0, 1.0], [0.0, 1.0, 1.0]],
        [[1e-45, 0.0, 1.0], [0.0, 1e-45, 1.0], [0.0, 0.0, 1.0]],
    ];
    for (three, taps) in corners.iter().flat_map(|c| [(c, 1.0f32), (c, 16.0)]) {
        let got = everywhere(w, [32, 32], |cx| {
            pyramid(cx, 64);
            parameter(cx, GL_TEXTURE_MAX_ANISOTROPY_EXT, taps);
            cx.begin(GL_TRIANGLES);
            for ([s, t, depth], [x, y]) in three.iter().zip([[-1.0f32, -1.0], [3.0, -1.0], [-1.0, 3.0]]) {
                cx.tex_coord2f(*s, *t);
                cx.vertex4f(x * depth, y * depth, 0.0, *depth);
            }
            cx.end();
        });
        w.holds(got.iter().all(|c| (0.0..=6.0001).contains(&lambda_of(*c))), || format!("{three:?}"));
    }
}

fn limits_crossed(w: &mut Worst) {
    for (least, most, want) in [(2.0f32, 1.0f32, 2.0), (5.0, -5.0, 5.0), (0.5, 0.25, 0.5), (1000.0, -1000.0, 6.0)] {
        for k in [0.0f32, 1.0, 4.0, 1e30] {
            let got = lambdas(k, k, |cx| {
                parameter(cx, GL_TEXTURE_MIN_LOD, least);
                parameter(cx, GL_TEXTURE_MAX_LOD, most);
            });
            see_lambda(w, &got, want, || format!("{least}..{most} at {k}"));
        }
    }
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-45];
    for pname in [GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_LOD_BIAS] {
        for v in odd {
            let got = everywhere(w, [16, 16], |cx| {
                pyramid(cx, 64);
                parameter(cx, pname, v);
                scaled(cx, 4.0, 4.0);
            });
            let inside = got.iter().all(|c| (0.0..=6.0001).contains(&lambda_of(*c)));
            w.see(if inside { 0.0 } else { 1.0 }, || format!("{pname:#x} {v}"));
        }
    }
}

fn ties(w: &mut Worst) {
    for step in 0..6 {
        for beside in [-1i32, 0, 1] {
            let bias = step as f32 + 0.5 + beside as f32 * 2f32.powi(-18);
            for min in [GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST] {
                let got = lambdas(1.0, 1.0, |cx| {
                    parameter(cx, GL_TEXTURE_LOD_BIAS, bias);
                    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min);
                });
                let want = if beside > 0 { step + 1 } else { step };
                let wrong = got.iter().filter(|l| l.round() != f64::from(want)).count();
                w.count(wrong as u64, 1024, || format!("lambda {bias} with {min:#x}: {}", got[0]));
            }
        }
    }
    // Whether a fragment is magnified: LINEAR or NEAREST in a texture of two colours, at the middle between texels.
    for (min, mag, c) in [
        (GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR, 0.5f32),
        (GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, 0.5),
        (GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, 0.0),
        (GL_NEAREST, GL_LINEAR, 0.0),
    ] {
        for (bias, above) in [(c - 2f32.powi(-18), false), (c, false), (c + 2f32.powi(-18), true)] {
            let mut cx = floats(4, 4);
            for level in 0..=2 {
                let n = 4 >> level;
                let texels: Vec<u8> = (0..n * n).map(|i| if level > 0 { 200 } else { i % 2 * 128 } as u8).collect();
                cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
                cx.tex_image_2d(
                    GL_TEXTURE_2D,
                    level,
                    GL_LUMINANCE8 as i32,
                    n,
                    n,
                    0,
                    GL_LUMINANCE,
                    GL_UNSIGNED_BYTE,
                    &texels,
                );
            }
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag);
            parameter(&mut cx, GL_TEXTURE_LOD_BIAS, bias);
            cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            cx.enable(GL_TEXTURE_2D);
            // One texel a pixel, half a texel off: LINEAR gives 64, NEAREST 0 or 128 of level 0.
            cover(&mut cx, |cx, i| {
                cx.tex_coord2f(if i == 1 || i == 2 { 1.125 } else { 0.125 }, if i > 1 { 1.0 } else { 0.0 })
            });
            let linear = (read(&mut cx)[5][0] * 255.0).round() == 64.0;
            w.holds(linear == (mag == GL_LINEAR && !above), || format!("{min:#x} {mag:#x} at {bias}"));
        }
    }
}

fn bias_and_range(w: &mut Worst) {
    for (object, unit, k, want) in [
        (1.0f32, 1.0f32, 1.0f32, 2.0),
        (14.0, 14.0, 2f32.powi(-12), 2.0),
        (-20.0, 1.0, 2f32.powi(16), 2.0),
        (1e30, -1e30, 4.0, 2.0),
        (9.0, 9.0, 2f32.powi(-10), 4.0),
    ] {
        let got = lambdas(k, k, |cx| {
            parameter(cx, GL_TEXTURE_LOD_BIAS, object);
            cx.tex_envf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unit);
        });
        see_lambda(w, &got, want, || format!("biases {object} + {unit} at {k}"));
    }
    for (base, last, k, want) in [
        (1, 1000, 1.0f32, 1.0),
        (2, 4, 4.0, 2.0),
        (2, 4, 16.0, 4.0),
        (3, 3, 1e6, 3.0),
        (6, 1000, 1e6, 6.0),
        (0, 0, 1e6, 0.0),
    ] {
        let got = lambdas(k, k, |cx| {
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
        });
        see_lambda(w, &got, want, || format!("levels {base}..{last} at {k}"));
    }
    // An incomplete texture is none: the colour of the fragment stays.
    for (base, last) in [(3, 2), (7, 1000), (i32::MAX, i32::MAX)] {
        let got = lambdas(1.0, 1.0, |cx| {
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
        });
        see_lambda(w, &got, 255.0 / 16.0, || format!("levels {base}..{last}"));
    }
}

fn horizon(w: &mut Worst) {
    // The window's middle lies 0.01 pixel under the horizon.
    let (size, reach) = (64.0, 1_048_576.0);
    for texels in (-3..=4).map(|p| 10f64.powi(p)) {
        let mut cx = floats(64, 64);
        pyramid(&mut cx, 1024);
        cx.matrix_mode(GL_PROJECTION);
        let shift = (31.5 + 0.01) / 32.0 - 1.0;
        cx.frustum(-0.1, 0.1, -0.1 * (1.0 + shift), 0.1 * (1.0 - shift), 0.1, 1e9);
        let scale = f64::from((texels / 1024.0) as f32);
        cx.matrix_mode(GL_TEXTURE);
        cx.scaled(scale, scale, 1.0);
        cx.begin(GL_QUADS);
        for [x, z] in [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            cx.tex_coord2d(x * reach, z * reach);
            cx.vertex3d(x * reach, -1.0, z * reach);
        }
        cx.end();
        no_error(&mut cx);
        for (i, color) in read(&mut cx).into_iter().enumerate() {
            let x = ((i % 64) as f64 + 0.5) / 32.0 - 1.0;
            let y = ((i / 64) as f64 + 0.5) / 32.0 - 1.0 - shift;
            if y >= 0.0 {
                continue;
            }
            let (depth, step) = (-1.0 / y, 2.0 / size);
            let by_x = depth * step;
            let by_y = depth / -y * step * (1.0 + x * x).sqrt();
            let want = (by_x.max(by_y) * scale * 1024.0).log2().clamp(0.0, 10.0);
            w.see(lambda_of(color) - want, || {
                format!("{texels} texels a unit, pixel {i}: {}, want {want}", lambda_of(color))
            });
        }
    }
}

fn seam(w: &mut Worst) {
    for (mode, start) in [GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE]
        .iter()
        .flat_map(|m| [0.0f32, -1.0, 1000.5, 65536.0].map(|s| (*m, s)))
    {
        let mut cx = floats(32, 32);
        pyramid(&mut cx, 64);
        for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T] {
            cx.tex_parameteri(GL_TEXTURE_2D, pname, mode);
        }
        cover(&mut cx, |cx, i| {
            cx.tex_coord2f(start + if i == 1 || i == 2 { 2.0 } else { 0.0 }, start + if i > 1 { 2.0 } else { 0.0 })
        });
        let got: Vec<f64> = read(&mut cx).into_iter().map(lambda_of).collect();
        see_lambda(w, &got, 2.0, || format!("{mode:#x} from {start}"));
    }
}

fn anisotropy(w: &mut Worst) {
    for degree in [1.0f32, 2.0, 4.0, 7.0, 16.0] {
        for ratio in [1.0f32, 1.5, 2.0, 3.7, 16.0, 17.0, 1e3, 1e6, f32::INFINITY] {
            for long in [8.0f32, 64.0, 1e5] {
                let got = lambdas(long, long / ratio, |cx| parameter(cx, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree));
                let n = f64::from(ratio).ceil().min(f64::from(degree));
                let want = (f64::from(long) / n).log2().clamp(0.0, 6.0);
                see_lambda(w, &got, want, || format!("{long} to {ratio}, degree {degree}"));
                let turned = lambdas(long / ratio, long, |cx| parameter(cx, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree));
                see_lambda(w, &turned, want, || format!("{long} to {ratio}, degree {degree}, turned"));
            }
        }
    }
}

fn points_and_lines(w: &mut Worst) {
    let mut random = Random(10);
    for (mode, size) in [(GL_POINTS, 1.0f32), (GL_POINTS, 9.0), (GL_LINES, 1.0), (GL_LINES, 5.0)] {
        for length in [0.0f32, 1e-30, 1e-5, 1.9] {
            let at = [random.range(-0.5, 0.0) as f32, random.range(-0.9, 0.9) as f32];
            let got = everywhere(w, [32, 32], |cx| {
                pyramid(cx, 64);
                cx.point_size(size);
                cx.line_width(size);
                cx.begin(mode);
                for (i, s) in [0.0f32, 40.0].into_iter().enumerate() {
                    cx.tex_coord2f(s, -s);
                    cx.vertex2f(at[0] + i as f32 * length, at[1]);
                }
                cx.end();
            });
            let drawn = |c: &&[f32; 4]| c[3] > 0.0;
            let level = |c: &[f32; 4]| lambda_of(*c);
            let right = got
                .iter()
                .filter(drawn)
                .all(|c| if mode == GL_POINTS { level(c) == 0.0 } else { (0.0..=6.0001).contains(&level(c)) });
            w.holds(right && (mode == GL_LINES || got.iter().any(|c| c[3] > 0.0)), || {
                format!("{mode:#x} of {size}, {length}")
            });
        }
    }
    let mut cx = bytes(8, 8);
    cx.begin(GL_LINES);
    cx.vertex2f(0.1, 0.1);
    cx.vertex2f(0.1, 0.1);
    cx.end();
    w.holds(cx.pixels().iter().filter(|b| **b > 0).count() <= 4, || "a line of length 0".into());
}
