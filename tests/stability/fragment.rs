//! Depth, fog, blending and the rest of the way into the framebuffer (OpenGL 1.5, sections 3.5.5, 3.10 and chapter 4):
//! infinite slopes, undefined fog, every pair of bytes, many frames in one.

use crate::oracle::fragment::Fog;
use crate::oracle::matrix::M4;
use crate::stability::common::{any_size, bytes, cover, everywhere, floats, read, window_coordinates};
use crate::stability::row::{Worst, rows};
use crate::support::{Random, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    depth_order: "D1", "near/far 1/1e3, 0.1/1e4, 1e-3/1e4, 1e-6/1e3; 400 distances of equal ratio each", "depth grows with distance; the step of 24 bits nearest to the formula", 1.0,
        "steps of 24 bits", "f64 to the last rounding";
    offset_slopes: "D2", "triangles edge-on to 1/256 pixel, factors 0, 1, -1, 1e38, infinite, NaN, units to 1e38", "depths in 0..1; factor = units = 0 as disabled", 0.0,
        "wrong pictures", "factor 0 skips the slope; the offset is limited to twice the range";
    depth_ranges: "D3", "DepthRange (1, 0), (0.25, 0.25), (0, 1) over 64 depths", "the reversed order; one depth", 1.0, "steps of 24 bits", "f64 to the last rounding";
    fog_values: "D4", "50,000 random fog states and coordinates 1e-38 to 1e38, LINEAR, EXP, EXP2", "equations 3.27 to 3.29", 2e-3, "255ths", "exp by a polynomial of degree 6 after exact reduction";
    odd_fog: "D4b", "end = start, densities 0, 1e38, infinite; coordinates infinite and NaN; all modes", "undefined; ours: LINEAR of end = start is a step, f within 0..1", 0.0,
        "wrong pictures", "coordinates limited to 3e38, f limited last";
    blend_exhaustive: "B1", "all 256^3 of source, alpha, destination; SRC_ALPHA, ONE_MINUS_SRC_ALPHA", "the nearest byte of (s a + d (255 - a))/255", 0.0, "wrong bytes",
        "floats of c/255, one rounding of the sum";
    byte_products: "B1b", "all pairs: DST_COLOR x source, ONE + ONE, ZERO, texture x colour", "the nearest byte; limited sum; zero", 0.0, "wrong bytes", "one rounding at the end";
    eight_modulates: "B2", "1, 2, 4 and 8 units that modulate, random bytes", "the product in f64, rounded once", 0.51, "255ths", "floats between units";
    accumulated: "B3", "4, 16 and 64 random frames accumulated with 1/n, and 64 with weights of both signs", "the mean", 0.502, "255ths",
        "floats in the accumulation buffer";
    dither: "B4", "DITHER on and off over a ramp, at two places of the window", "the nearest byte everywhere", 0.0, "pixels that differ", "dithering is rounding";
    long_lists: "B5", "a list of 1,000,000 commands; lists that call each other 10,000 deep and themselves", "executed; nesting stops at 64", 0.0, "wrong answers",
        "lists run on a stack of their own";
    odd_windows: "B6", "viewports of 0 x 0, 1 x 1, 16384 x 16384 at +-2^31, negative; scissors likewise", "clipped to the framebuffer; INVALID_VALUE", 0.0, "wrong pictures",
        "limits in 64 bits";
}

const STEPS: f64 = 16_777_215.0;

fn depth_order(w: &mut Worst) {
    for (near, far) in [(1.0f64, 1e3f64), (0.1, 1e4), (1e-3, 1e4), (1e-6, 1e3)] {
        let mut cx = bytes(400, 1);
        cx.enable(GL_DEPTH_TEST);
        let mut want = Vec::new();
        for i in 0..400u32 {
            let z = f64::from((near * (far / near).powf((f64::from(i) + 0.5) / 400.0)) as f32);
            let x = (2.0 * f64::from(i) + 1.0) / 400.0 - 1.0;
            cx.matrix_mode(GL_PROJECTION);
            cx.load_matrixd(
                &M4([
                    [1.0, 0.0, -x, 0.0],
                    [0.0, 1.0, 0.0, 0.0],
                    M4::frustum(-1.0, 1.0, -1.0, 1.0, near, far).0[2],
                    [0.0, 0.0, -1.0, 0.0],
                ])
                .to_gl(),
            );
            cx.begin(GL_POINTS);
            cx.vertex3d(0.0, 0.0, -z);
            cx.end();
            want.push((far * (z - near) / (z * (far - near))) * STEPS);
        }
        let depths = cx.depths();
        for (i, (got, want)) in depths.iter().zip(&want).enumerate() {
            w.see(got * STEPS - want, || format!("{near}..{far} at {i}"));
        }
        w.holds(depths.windows(2).all(|p| p[0] <= p[1]), || format!("{near}..{far} is not in order"));
        no_error(&mut cx);
    }
}

fn offset_slopes(w: &mut Worst) {
    let odd = [0.0f32, 1.0, -1.0, 1e38, -1e38, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
    for (factor, units) in odd.iter().flat_map(|f| odd.map(|u| (*f, u))) {
        let draw = |on: bool| {
            move |cx: &mut Context| {
                window_coordinates(cx, 16, 16);
                cx.enable(GL_DEPTH_TEST);
                cx.depth_func(GL_ALWAYS);
                if on {
                    cx.enable(GL_POLYGON_OFFSET_FILL);
                    cx.polygon_offset(factor, units);
                }
                for width in [1.0f32 / 256.0, 1.0, 16.0] {
                    cx.begin(GL_TRIANGLES);
                    for [x, y, z] in [[8.498, 0.0, -1.0], [8.498 + width, 0.0, 1.0], [8.5, 16.0, 0.5]] {
                        cx.vertex3f(x, y, z);
                    }
                    cx.end();
                }
            }
        };
        let depths = |draw: &dyn Fn(&mut Context)| {
            let mut cx = bytes(16, 16);
            draw(&mut cx);
            cx.depths()
        };
        let with = depths(&draw(true));
        w.holds(with.iter().all(|d| (0.0..=1.0).contains(d)), || format!("{factor} {units}"));
        if factor == 0.0 && units == 0.0 {
            w.holds(with == depths(&draw(false)), || "an offset of nothing".into());
        }
        everywhere(w, [16, 16], draw(true));
    }
}

fn depth_ranges(w: &mut Worst) {
    for (near, far) in [(1.0, 0.0), (0.25, 0.25), (0.0, 1.0), (0.75, 0.5)] {
        let mut cx = bytes(64, 1);
        cx.depth_range(near, far);
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(GL_ALWAYS);
        cx.begin(GL_POINTS);
        for i in 0..64u32 {
            cx.vertex3f((2.0 * i as f32 + 1.0) / 64.0 - 1.0, 0.0, i as f32 / 31.5 - 1.0);
        }
        cx.end();
        for (i, got) in cx.depths().into_iter().enumerate() {
            let z = (f64::from(i as f32 / 31.5 - 1.0) + 1.0) / 2.0;
            let want = near + (far - near) * z;
            w.see((got - want) * STEPS, || format!("{near}..{far} at {i}: {got}, want {want}"));
        }
    }
}

fn fog_values(w: &mut Worst) {
    let mut random = Random(400);
    for round in 0..500 {
        let mode = [GL_LINEAR, GL_EXP, GL_EXP2][round % 3];
        let reach = random.range(-3.0, 3.0);
        let size = |random: &mut Random| f64::from(any_size(random, reach - 2.0, reach + 2.0).abs());
        let fog = Fog {
            mode,
            density: f64::from((1.0 / size(&mut random)) as f32),
            start: size(&mut random),
            end: size(&mut random),
            color: [0.0, 0.0, 0.0, 0.0],
        };
        // The slope of a LINEAR fog is known as well as its two ends: keep them apart.
        if (fog.end - fog.start).abs() < 0.01 * fog.end.max(fog.start) {
            continue;
        }
        let mut cx = floats(10, 10);
        window_coordinates(&mut cx, 10, 10);
        cx.enable(GL_FOG);
        cx.fogi(GL_FOG_MODE, mode);
        cx.fogf(GL_FOG_DENSITY, fog.density as f32);
        cx.fogf(GL_FOG_START, fog.start as f32);
        cx.fogf(GL_FOG_END, fog.end as f32);
        cx.fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
        let coords: Vec<f32> = (0..100)
            .map(|i| {
                if i % 10 == 0 {
                    any_size(&mut random, -38.0, 38.0).abs()
                } else {
                    any_size(&mut random, reach - 3.0, reach + 3.0).abs()
                }
            })
            .collect();
        cx.begin(GL_POINTS);
        for (i, c) in coords.iter().enumerate() {
            cx.fog_coordf(*c);
            cx.vertex2f((i % 10) as f32 + 0.5, (i / 10) as f32 + 0.5);
        }
        cx.end();
        no_error(&mut cx);
        for (color, c) in read(&mut cx).into_iter().zip(coords) {
            let want = fog.factor(f64::from(c));
            w.fuzzed += 1;
            w.see((f64::from(color[0]) - want) * 255.0, || format!("{fog:?} at {c}: {}, want {want}", color[0]));
        }
    }
}

fn odd_fog(w: &mut Worst) {
    for (density, start, end) in [
        (0.0f32, 1.0f32, 1.0f32),
        (1e38, 5.0, 5.0),
        (0.0, f32::MAX, f32::MIN),
        (f32::INFINITY, 0.0, 1e-45),
        (1e-45, f32::NAN, 1.0),
        (1.0, 0.0, f32::INFINITY),
    ] {
        for mode in [GL_LINEAR, GL_EXP, GL_EXP2] {
            let got = everywhere(w, [8, 1], |cx| {
                window_coordinates(cx, 8, 1);
                cx.enable(GL_FOG);
                cx.fogi(GL_FOG_MODE, mode);
                cx.fogf(GL_FOG_DENSITY, density);
                cx.fogf(GL_FOG_START, start);
                cx.fogf(GL_FOG_END, end);
                cx.fogfv(GL_FOG_COLOR, &[0.25, 0.25, 0.25, 1.0]);
                cx.fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
                cx.begin(GL_POINTS);
                for (i, c) in [0.0f32, 0.5, 1.0, 5.0, f32::MAX, f32::INFINITY, f32::NAN, -1.0].into_iter().enumerate() {
                    cx.fog_coordf(c);
                    cx.vertex2f(i as f32 + 0.5, 0.5);
                }
                cx.end();
                while cx.get_error() != 0 {}
            });
            let inside = got.iter().all(|c| (0.25..=1.0).contains(&c[0]) && c[3] == 1.0);
            let step = mode != GL_LINEAR
                || start != end
                || got.iter().take(5).zip([0.0, 0.5, 1.0, 5.0, f32::MAX]).all(|(c, at)| (c[0] == 1.0) == (at < end));
            w.holds(inside && step, || format!("{mode:#x} {density} {start} {end}: {got:?}"));
        }
    }
}

/// A texture of 256 x 256 texels, a texel a pixel, without filter.
fn all_pairs(cx: &mut Context, texel: impl Fn(u8, u8) -> [u8; 4]) {
    let texels: Vec<[u8; 4]> = (0..65536u32).map(|i| texel((i % 256) as u8, (i / 256) as u8)).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.as_flattened());
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        cx.tex_parameteri(GL_TEXTURE_2D, pname, GL_NEAREST);
    }
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
}

fn one_to_one(cx: &mut Context) {
    cover(cx, |cx, i| cx.tex_coord2f(if i == 1 || i == 2 { 1.0 } else { 0.0 }, if i > 1 { 1.0 } else { 0.0 }));
}

fn blend_exhaustive(w: &mut Worst) {
    let mut cx = bytes(256, 256);
    all_pairs(&mut cx, |s, a| [s, s, s, a]);
    cx.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    cx.enable(GL_BLEND);
    // Three destinations at a time, one in each channel.
    for first in (0..=255u32).step_by(3) {
        let d = [first, (first + 1).min(255), (first + 2).min(255)];
        let [r, g, b] = d.map(|v| v as f32 / 255.0);
        cx.clear_color(r, g, b, 0.0);
        cx.clear(GL_COLOR_BUFFER_BIT);
        one_to_one(&mut cx);
        let got = cx.pixels();
        let mut wrong = 0;
        for (i, c) in got.chunks_exact(4).enumerate() {
            let (s, a) = (i as u32 % 256, i as u32 / 256);
            for k in 0..3 {
                // 255 is odd: there are no ties.
                let want = (2 * (s * a + d[k] * (255 - a)) + 255) / 510;
                wrong += u64::from(u32::from(c[k]) != want);
            }
        }
        w.count(wrong, 3 * 65536, || format!("destinations {d:?}"));
    }
}

/// What becomes of a source and a destination.
type Rule = fn(u32, u32) -> u32;

/// The nearest byte of s d / 255; 255 is odd, so there are no ties.
fn product(s: u32, d: u32) -> u32 {
    (2 * s * d + 255) / 510
}

fn byte_products(w: &mut Worst) {
    let rules: [(GLenum, GLenum, Rule); 5] = [
        (GL_DST_COLOR, GL_ZERO, product),
        (GL_ZERO, GL_SRC_COLOR, product),
        (GL_ONE, GL_ONE, |s, d| (s + d).min(255)),
        (GL_ONE, GL_ZERO, |s, _| s),
        (GL_ZERO, GL_ONE, |_, d| d),
    ];
    for (source, destination, rule) in rules {
        let mut cx = bytes(256, 256);
        all_pairs(&mut cx, |_, d| [d; 4]);
        one_to_one(&mut cx);
        all_pairs(&mut cx, |s, _| [s; 4]);
        cx.enable(GL_BLEND);
        cx.blend_func(source, destination);
        one_to_one(&mut cx);
        let wrong = cx
            .pixels()
            .chunks_exact(4)
            .enumerate()
            .filter(|(i, c)| c.iter().any(|c| u32::from(*c) != rule(*i as u32 % 256, *i as u32 / 256)))
            .count();
        w.count(wrong as u64, 65536, || format!("{source:#x} {destination:#x}"));
    }
    let mut cx = bytes(256, 1);
    for color in 0..=255u8 {
        all_pairs(&mut cx, |s, _| [s; 4]);
        cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        cx.color4ub(color, color, color, color);
        one_to_one(&mut cx);
        let wrong = cx
            .pixels()
            .chunks_exact(4)
            .enumerate()
            .filter(|(s, c)| c.iter().any(|c| u32::from(*c) != product(*s as u32, u32::from(color))))
            .count();
        w.count(wrong as u64, 256, || format!("texture x {color}"));
    }
}

fn eight_modulates(w: &mut Worst) {
    let mut random = Random(2);
    for round in 0..200 {
        let n = 1 << (round % 4);
        let mut cx = bytes(1, 1);
        let mut want = 255.0;
        for unit in 0..n {
            // Large enough for the product to say something.
            let v = 128 + random.below(128) as u8;
            want *= f64::from(v) / 255.0;
            cx.active_texture(GL_TEXTURE0 + unit);
            cx.bind_texture(GL_TEXTURE_2D, unit + 1);
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[v; 4]);
            cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            cx.enable(GL_TEXTURE_2D);
        }
        cover(&mut cx, |_, _| {});
        for c in cx.pixels() {
            w.see(f64::from(c) - want, || format!("{n} units: {c}, want {want}"));
        }
    }
}

fn accumulated(w: &mut Worst) {
    let mut random = Random(3);
    for n in [4u32, 16, 64] {
        for sign in [1.0f32, -1.0] {
            let mut cx = bytes(16, 16);
            let mut sum = vec![0f64; 16 * 16 * 4];
            cx.clear(GL_ACCUM_BUFFER_BIT);
            cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
            let mut weights = 0.0;
            for frame in 0..n {
                let texels: Vec<u8> = (0..1024).map(|_| random.bits() as u8).collect();
                cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
                for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
                    cx.tex_parameteri(GL_TEXTURE_2D, pname, GL_NEAREST);
                }
                cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
                cx.enable(GL_TEXTURE_2D);
                one_to_one(&mut cx);
                let weight = if sign < 0.0 && frame % 4 == 3 { -1.0 } else { 1.0 } / n as f32;
                weights += f64::from(weight);
                cx.accum(GL_ACCUM, weight);
                sum.iter_mut().zip(&texels).for_each(|(s, t)| *s += f64::from(weight) * f64::from(*t));
            }
            cx.accum(GL_RETURN, (1.0 / weights) as f32);
            no_error(&mut cx);
            for (got, sum) in cx.pixels().into_iter().zip(sum) {
                let want = (sum * f64::from((1.0 / weights) as f32)).clamp(0.0, 255.0);
                w.see(f64::from(got) - want, || format!("{n} frames, sign {sign}: {got}, want {want}"));
            }
        }
    }
}

fn dither(w: &mut Worst) {
    let picture = |on: bool, x: i32| {
        let mut cx = bytes(80, 4);
        if on {
            cx.enable(GL_DITHER)
        } else {
            cx.disable(GL_DITHER)
        }
        cx.viewport(x, 0, 64, 4);
        cover(&mut cx, |cx, i| cx.color4f(if i == 1 || i == 2 { 0.3 } else { 0.1 }, 0.5, 0.4999, 1.0));
        (0..64 * 4)
            .map(|i| {
                let at = ((i / 64) * 80 + i % 64 + x as usize) * 4;
                cx.pixels()[at..at + 4].to_vec()
            })
            .collect::<Vec<_>>()
    };
    let plain = picture(false, 0);
    for (i, c) in plain.iter().enumerate() {
        let want = 0.1 + 0.2 * ((i % 64) as f64 + 0.5) / 64.0;
        w.holds((f64::from(c[0]) - want * 255.0).abs() < 0.501 && c[1] == 128 && c[2] == 127, || format!("{i}: {c:?}"));
    }
    for (on, x) in [(true, 0), (true, 5), (false, 5)] {
        let differ = picture(on, x).iter().zip(&plain).filter(|(a, b)| a != b).count();
        w.count(differ as u64, 256, || format!("dither {on} at {x}"));
    }
}

fn long_lists(w: &mut Worst) {
    let mut cx = bytes(4, 4);
    cx.new_list(1, GL_COMPILE);
    for _ in 0..500_000 {
        cx.rotatef(90.0, 0.0, 0.0, 1.0);
        cx.color4ub(9, 8, 7, 6);
    }
    cx.end_list();
    cx.call_list(1);
    let mut m = [0f64; 16];
    cx.get_doublev(GL_MODELVIEW_MATRIX, &mut m);
    w.equal(m.to_vec(), M4::IDENTITY.to_gl().to_vec(), "500,000 quarter turns");
    // Each list translates by 1 and calls the next: 64 of them run.
    cx.load_identity();
    for list in 10..10_010 {
        cx.new_list(list, GL_COMPILE);
        cx.translatef(1.0, 0.0, 0.0);
        cx.call_list(list + 1);
        cx.end_list();
    }
    cx.call_list(10);
    cx.get_doublev(GL_MODELVIEW_MATRIX, &mut m);
    w.equal(m[12], 64.0, "lists that ran");
    cx.new_list(7, GL_COMPILE);
    cx.translatef(0.0, 1.0, 0.0);
    cx.call_list(7);
    cx.call_list(7);
    cx.end_list();
    while cx.get_error() != 0 {}
}

fn odd_windows(w: &mut Worst) {
    let mut cx = bytes(16, 16);
    for [width, height] in [[-1, 1], [1, -1], [i32::MIN, i32::MAX]] {
        raises(&mut cx, GL_INVALID_VALUE, |cx| cx.viewport(0, 0, width, height));
        raises(&mut cx, GL_INVALID_VALUE, |cx| cx.scissor(0, 0, width, height));
    }
    // A viewport that holds the framebuffer is drawn over all of it, one beside it over nothing.
    for (x, y, width, height, covered) in [
        (0, 0, 0, 0, 0),
        (3, 4, 1, 1, 1),
        (-8000, -8000, 16384, 16384, 256),
        (i32::MAX, i32::MAX, 16384, 16384, 0),
        (i32::MIN, i32::MIN, i32::MAX, i32::MAX, 0),
        (15, 15, i32::MAX, i32::MAX, 1),
        (-4, -4, 12, 12, 64),
    ] {
        let got = everywhere(w, [16, 16], |cx| {
            cx.viewport(x, y, width, height);
            cover(cx, |_, _| {});
        });
        let drawn = got.iter().filter(|c| c[3] > 0.0).count();
        w.equal(drawn, covered, &format!("viewport {x} {y} {width} {height}"));
        let got = everywhere(w, [16, 16], |cx| {
            cx.enable(GL_SCISSOR_TEST);
            cx.scissor(x, y, width, height);
            cover(cx, |_, _| {});
            cx.clear(GL_DEPTH_BUFFER_BIT);
        });
        w.equal(got.iter().filter(|c| c[3] > 0.0).count(), covered, &format!("scissor {x} {y} {width} {height}"));
    }
}
