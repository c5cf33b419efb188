//! Texture coordinates (OpenGL 1.5, sections 3.5.1 and 3.8.7): far out, at texel boundaries, tiny, no numbers at all,
//! divided by a q that is 0 or negative somewhere.

use crate::oracle::raster::{Triangle, Window};
use crate::oracle::texel::{Image as OracleImage, Texture, nearest_index, wrapped};
use crate::stability::common::{any_size, cover, everywhere, float_config, floats, read, window_coordinates};
use crate::stability::row::{Worst, rows};
use crate::support::Random;
use fixedgl::enums::*;
use fixedgl::{Context, SimdLevel};

rows! {
    random_nearest: "T1", "1,000,000 random coordinates for each of 8 wrap modes, 1e-45 to 3e38, around whole numbers and texel boundaries; NEAREST on 16 x 13 texels",
        "the texel that the exact coordinate lies in", 2e-6, "texels outside of it",
        "whole numbers taken off before the product with N; limits before integers";
    random_linear: "T1b", "the same with LINEAR", "the four texels and weights of equations 3.22 to 3.26", 0.001, "255ths",
        "weights from the reduced coordinate, nested lerp";
    far_ramps: "T1c", "coordinates from s0 to s0 + 4 across a triangle, s0 up to 2^22 and down to -2^22; REPEAT, MIRRORED_REPEAT",
        "the f64 interpolation of the same corners", 1e-3, "texels of 256", "whole periods taken off a plane's constant in f64";
    tiny_negative: "T2", "s = -1e-8, -1e-20, -1e-38, and the floats next to every whole number up to 4096, sizes 1 to 256",
        "index within 0..N; for powers of two that of the exact number", 0.0, "wrong texels", "remainder to the nearest whole number, exact in f32";
    boundaries: "T3", "s = k/N for every k, N = 1 to 256, as f32; 8 modes", "texel k for powers of two; k - 1 or k else", 0.0,
        "wrong texels", "s N in f32, floor";
    centres: "T4", "LINEAR at texel centres of powers of two up to 4096; s = 1 and s = 0.5 with NEAREST; s = -0", "texel i exactly; N - 1, N/2; as s = 0",
        0.0, "wrong results", "weight 0 or 1 at a centre";
    no_numbers: "T5", "s, t, r, q NaN, infinite, 3e38 at one or all corners; 8 modes, NEAREST and LINEAR, 2D", "undefined; ours: what is not finite is 0, the result is of the texture",
        0.0, "wrong pictures", "not finite becomes 0 at two places: the vertex store, the quotient";
    denormals: "T6", "s = 1e-38, 1e-45 and their negatives, LINEAR, 8 modes", "as s = 0", 1e-6, "of the colour range", "denormals are ordinary numbers";
    scaled_q: "T7", "s, t, q times 2^-60 to 2^60, 3, 1/7", "the same quotient", 1e-4, "texels of 256", "one division (s/w)/(q/w)";
    q_through_zero: "T7b", "q from +1 to -1 across a window; q = 0 and q = -1 everywhere", "s/q where q > 0; numbers of the texture elsewhere",
        1e-3, "texels of 256, footprints where minified", "as divided; what is not finite is 0";
    steep_q: "T8", "1000 triangles with w ratios and q ratios of 1e6", "equation 3.6 with q", 2e-3, "texels of 256, footprints where minified",
        "Q in place of D; f64 where f32 would lose 2^-11 texel";
}

pub const MODES: [GLenum; 8] = [
    GL_REPEAT,
    GL_CLAMP,
    GL_CLAMP_TO_EDGE,
    GL_CLAMP_TO_BORDER,
    GL_MIRRORED_REPEAT,
    GL_MIRROR_CLAMP_EXT,
    GL_MIRROR_CLAMP_TO_EDGE_EXT,
    GL_MIRROR_CLAMP_TO_BORDER_EXT,
];

/// A texture of one level: red and green are the numbers of column and row; the border is (255, 255).
#[derive(Clone, Copy)]
struct Numbered {
    size: [u32; 2],
    mode: GLenum,
    filter: GLenum,
}

impl Numbered {
    /// The columns and rows that are read at these coordinates. Each is a point of its own, which has the coordinate
    /// everywhere and no derivatives.
    fn texels(self, level: SimdLevel, coords: &[[f32; 2]]) -> Vec<[f64; 2]> {
        const WIDTH: usize = 256;
        let [width, height] = [WIDTH, coords.len().div_ceil(WIDTH)].map(|side| side as u32);
        let mut cx = Context::with_config(width, height, float_config().with_level(level));
        window_coordinates(&mut cx, width, height);
        let [columns, rows] = self.size;
        let texels: Vec<[u8; 4]> =
            (0..columns * rows).map(|k| [(k % columns) as u8, (k / columns) as u8, 0, 255]).collect();
        let [w, h] = self.size.map(|side| side as i32);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.as_flattened());
        cx.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[1.0; 4]);
        filtered(&mut cx, self.mode, self.filter);
        cx.begin(GL_POINTS);
        for (i, coord) in coords.iter().enumerate() {
            cx.tex_coord2fv(coord);
            cx.vertex2f((i % WIDTH) as f32 + 0.5, (i / WIDTH) as f32 + 0.5);
        }
        cx.end();
        read(&mut cx).iter().take(coords.len()).map(|color| [number(color[0]), number(color[1])]).collect()
    }
}

/// The wrap mode and filter of the texture, which is to be the colour.
fn filtered(cx: &mut Context, mode: GLenum, filter: GLenum) {
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        cx.tex_parameteri(GL_TEXTURE_2D, pname, filter);
    }
    for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T] {
        cx.tex_parameteri(GL_TEXTURE_2D, pname, mode);
    }
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
}

/// The number of a column or row that a colour stands for: whole if it is one to the last bits of an f32.
fn number(color: f32) -> f64 {
    let n = f64::from(color) * 255.0;
    if (n - n.round()).abs() < n.abs() * 2e-7 { n.round() } else { n }
}

/// A coordinate of any kind.
fn coordinate(random: &mut Random) -> f32 {
    let near =
        |v: f32, random: &mut Random| f32::from_bits(v.to_bits().wrapping_add(random.below(5) as u32).wrapping_sub(2));
    match random.below(6) {
        0 => any_size(random, -45.0, 38.5),
        1 => any_size(random, -3.0, 7.0),
        2 => near(random.below(2000) as f32 - 1000.0, random),
        3 => near((random.below(2000) as f32 - 1000.0) / 16.0, random),
        4 => near((random.below(2000) as f32 - 1000.0) / 13.0, random),
        _ => random.range(-3.0, 3.0) as f32,
    }
}

const SIZE: [u32; 2] = [16, 13];

fn pairs(random: &mut Random, n: usize) -> Vec<[f32; 2]> {
    let finite = |v: f32| if v.is_finite() { v } else { 0.5 };
    (0..n).map(|_| [finite(coordinate(random)), finite(coordinate(random))]).collect()
}

fn levels() -> Vec<SimdLevel> {
    SimdLevel::available().collect()
}

fn random_nearest(w: &mut Worst) {
    let mut random = Random(11);
    for mode in MODES {
        for (round, level) in levels().into_iter().cycle().take(20).enumerate() {
            let coords = pairs(&mut random, 25_000);
            let texture = Numbered { size: SIZE, mode, filter: GL_NEAREST };
            for (c, got) in coords.iter().zip(texture.texels(level, &coords)) {
                let border = |k: usize| {
                    let i = nearest_index(mode, f64::from(c[k]), i64::from(SIZE[k]));
                    i < 0 || i >= i64::from(SIZE[k])
                };
                for k in 0..2 {
                    let u = wrapped(mode, f64::from(c[k]), i64::from(SIZE[k]));
                    let off = if got[k] == 255.0 {
                        // Border: right where one of the two is outside, or within a rounding of the edge.
                        let edge = |k: usize| {
                            let (u, n) = (wrapped(mode, f64::from(c[k]), i64::from(SIZE[k])), f64::from(SIZE[k]));
                            if border(k) { 0.0 } else { u.min(n - u) }
                        };
                        edge(0).min(edge(1))
                    } else {
                        let off = (got[k] - u).max(u - (got[k] + 1.0)).max(0.0);
                        // At the seam of REPEAT the last texel and the first are neighbours.
                        if mode == GL_REPEAT { off.min(f64::from(SIZE[k]) - off - 1.0).abs() } else { off }
                    };
                    w.fuzzed += 1;
                    w.see(off, || format!("{mode:#x} round {round}: {c:?} reads {got:?}, coordinate {k} is at {u}"));
                }
            }
        }
    }
}

fn random_linear(w: &mut Worst) {
    let mut random = Random(12);
    for mode in MODES {
        let texel = |i: i64, j: i64| [i as f64 / 255.0, j as f64 / 255.0, 0.0, 1.0];
        let mut oracle = Texture::flat(GL_RGBA, OracleImage::from_fn(16, 13, texel));
        oracle.wrap = [mode; 3];
        oracle.border_color = [1.0; 4];
        for (round, level) in levels().into_iter().cycle().take(20).enumerate() {
            let coords = pairs(&mut random, 25_000);
            let texture = Numbered { size: SIZE, mode, filter: GL_LINEAR };
            for (c, got) in coords.iter().zip(texture.texels(level, &coords)) {
                let want = oracle.filter(0, 0, GL_LINEAR, [f64::from(c[0]), f64::from(c[1]), 0.0], 0.0);
                w.fuzzed += 2;
                let off = (got[0] - want[0] * 255.0).abs().max((got[1] - want[1] * 255.0).abs());
                w.see(off, || format!("{mode:#x} round {round}: {c:?} reads {got:?}, want {want:?}"));
                w.cases += 1;
            }
        }
    }
}

/// A one-dimensional texture of 256 texels, red is the number of the texel; LINEAR.
fn ramp(cx: &mut Context, mode: GLenum) {
    let texels: Vec<u8> = (0..=255).collect();
    cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_LUMINANCE8 as i32, 256, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    cx.tex_parameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    cx.tex_parameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, mode);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_1D);
}

/// How far a colour of the ramp is from the coordinate, in texels; nothing over the seam.
fn texels_off(mode: GLenum, red: f32, s: f64) -> Option<f64> {
    let want = wrapped(mode, s, 256);
    (1.0..255.0).contains(&want).then(|| (f64::from(red) * 255.0 + 0.5 - want).abs())
}

fn far_ramps(w: &mut Worst) {
    for mode in [GL_REPEAT, GL_MIRRORED_REPEAT] {
        for power in [0, 4, 10, 14, 17, 20, 22] {
            for start in [2f64.powi(power), -2f64.powi(power), 2f64.powi(power) + 0.5] {
                let mut cx = floats(64, 64);
                ramp(&mut cx, mode);
                let s = [start, start + 4.0, start - 0.5];
                let corners = [[-1.0, -1.0, 1.0], [3.0, -1.0, 2.0], [-1.0, 3.0, 1.5]];
                cx.begin(GL_TRIANGLES);
                for ([x, y, depth], s) in corners.into_iter().zip(s) {
                    cx.tex_coord1d(s);
                    cx.vertex4d(x * depth, y * depth, 0.0, depth);
                }
                cx.end();
                let window = |[x, y, depth]: [f64; 3]| Window {
                    x: 32.0 + 32.0 * x,
                    y: 32.0 + 32.0 * y,
                    z: 0.0,
                    inv_w: 1.0 / depth,
                };
                let triangle = Triangle(corners.map(window));
                for (i, color) in read(&mut cx).into_iter().enumerate() {
                    let at = [(i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5];
                    let (s, _) = triangle.interpolate(at, s.map(|s| f64::from(s as f32)), [1.0; 3]);
                    if let Some(off) = texels_off(mode, color[0], s) {
                        w.see(off, || format!("{mode:#x} from {start} at {at:?}"));
                    }
                }
            }
        }
    }
}

fn tiny_negative(w: &mut Worst) {
    let mut coords: Vec<[f32; 2]> = [-1e-8f32, -1e-20, -1e-38, -1e-45].iter().map(|v| [*v, *v]).collect();
    for whole in -4096i32..=4096 {
        let v = whole as f32;
        let beside = |d: i32| f32::from_bits(v.to_bits().wrapping_add_signed(d));
        let next = |d: i32| if v == 0.0 { v } else { beside(d) };
        coords.push([next(1), next(-1)]);
    }
    for mode in [GL_REPEAT, GL_MIRRORED_REPEAT] {
        for n in [1u32, 2, 3, 7, 16, 64, 100, 255, 256] {
            let texture = Numbered { size: [n, n], mode, filter: GL_NEAREST };
            for (c, got) in coords.iter().zip(texture.texels(SimdLevel::detect(), &coords)) {
                for k in 0..2 {
                    let exact = nearest_index(mode, f64::from(c[k]), i64::from(n)) as f64;
                    let inside = (0.0..f64::from(n)).contains(&got[k]);
                    let right = inside && (!n.is_power_of_two() || got[k] == exact);
                    w.holds(right, || format!("{mode:#x} N = {n}: {} reads {}, want {exact}", c[k], got[k]));
                }
            }
        }
    }
}

fn boundaries(w: &mut Worst) {
    for n in 1..=256u32 {
        let coords: Vec<[f32; 2]> = (0..n).map(|k| [(f64::from(k) / f64::from(n)) as f32; 2]).collect();
        for mode in MODES {
            let texture = Numbered { size: [n, 1], mode, filter: GL_NEAREST };
            for (k, got) in texture.texels(SimdLevel::detect(), &coords).into_iter().enumerate() {
                let k = k as f64;
                let right = got[0] == k || !n.is_power_of_two() && got[0] == k - 1.0;
                w.holds(right, || format!("{mode:#x}: {k}/{n} reads {}", got[0]));
            }
        }
    }
}

fn centres(w: &mut Worst) {
    for n in (0..=12).map(|p| 1u32 << p) {
        let coords: Vec<[f32; 2]> = (0..n).map(|i| [(i as f32 + 0.5) / n as f32, 0.5]).collect();
        let linear = Numbered { size: [n, 1], mode: GL_CLAMP_TO_EDGE, filter: GL_LINEAR };
        for (i, got) in linear.texels(SimdLevel::detect(), &coords).into_iter().enumerate() {
            // Colours are bytes: columns count modulo 256. Texel n + 1 would be 255ths away.
            w.equal(got[0], (i % 256) as f64, &format!("centre {i} of {n}"));
        }
        for mode in [GL_CLAMP, GL_CLAMP_TO_EDGE, GL_MIRROR_CLAMP_EXT] {
            let nearest = Numbered { size: [n, 1], mode, filter: GL_NEAREST };
            let got = nearest.texels(SimdLevel::detect(), &[[1.0, 0.0], [0.5, 0.0], [-0.0, -0.0], [0.0, 0.0]]);
            let columns: Vec<u32> = got.iter().map(|t| t[0].round() as u32).collect();
            w.equal(columns, [n - 1, n / 2, 0, 0].map(|c| c % 256).to_vec(), &format!("{mode:#x}, {n} texels"));
        }
    }
}

/// A context's texture of 16 x 16 numbered texels.
fn numbered(cx: &mut Context, mode: GLenum, filter: GLenum) {
    let texels: Vec<[u8; 4]> = (0..256u32).map(|i| [(16 + i % 16) as u8, (16 + i / 16) as u8, 77, 255]).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.as_flattened());
    cx.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[20.0 / 255.0, 20.0 / 255.0, 77.0 / 255.0, 1.0]);
    filtered(cx, mode, filter);
}

fn no_numbers(w: &mut Worst) {
    for mode in MODES {
        for filter in [GL_NEAREST, GL_LINEAR] {
            let draw = |strq: [[f32; 4]; 4]| {
                move |cx: &mut Context| {
                    numbered(cx, mode, filter);
                    cover(cx, |cx, i| cx.tex_coord4fv(&strq[i]));
                }
            };
            let plain = everywhere(w, [8, 8], draw([[0.0, 0.0, 0.0, 1.0]; 4]));
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN] {
                // Everywhere: as 0. A q that is infinite or none leaves 0 / q and nothing to compare with.
                if !bad.is_finite() {
                    let got = everywhere(w, [8, 8], draw([[bad, bad, bad, 1.0]; 4]));
                    w.holds(got == plain, || format!("{bad} is not read as 0 with {mode:#x}"));
                }
                for (corner, k) in (0..8).map(|i| (i / 4, i % 4)) {
                    let mut strq =
                        [[0.25, 0.5, 0.0, 1.0], [0.75, 0.5, 0.0, 1.0], [0.75, 1.5, 0.0, 1.0], [0.25, 1.5, 0.0, 1.0]];
                    strq[corner][k] = bad;
                    let got = everywhere(w, [8, 8], draw(strq));
                    let inside = |v: f32| (15.999..=31.001).contains(&(v * 255.0));
                    let right = got.iter().all(|c| inside(c[0]) && inside(c[1]) && c[3] == 1.0);
                    w.holds(right, || format!("{bad} as coordinate {k} of corner {corner}, {mode:#x}: {got:?}"));
                }
            }
        }
    }
}

fn denormals(w: &mut Worst) {
    for mode in MODES {
        let at = |s: f32| {
            let mut cx = floats(4, 4);
            numbered(&mut cx, mode, GL_LINEAR);
            cover(&mut cx, |cx, _| cx.tex_coord2f(s, s));
            read(&mut cx)
        };
        let zero = at(0.0);
        for s in [1e-38f32, -1e-38, 1e-45, -1e-45, f32::MIN_POSITIVE] {
            for (a, b) in at(s).as_flattened().iter().zip(zero.as_flattened()) {
                w.see(f64::from((a - b).abs()), || format!("{mode:#x}: {s}"));
            }
        }
    }
}

fn scaled_q(w: &mut Worst) {
    let draw = |k: f64| {
        let mut cx = floats(64, 64);
        ramp(&mut cx, GL_REPEAT);
        cover(&mut cx, |cx, i| {
            let [s, q] = [[0.01, 1.0], [3.2, 4.0], [0.9, 1.25], [0.3, 0.7]][i];
            cx.tex_coord4f((s * k) as f32, 0.0, 0.0, (q * k) as f32);
        });
        read(&mut cx)
    };
    let one = draw(1.0);
    for k in (-60..=60).step_by(5).map(|p| 2f64.powi(p)) {
        let wrong = draw(k).iter().zip(&one).filter(|(a, b)| ((a[0] - b[0]) * 255.0).abs() > 1e-4).count();
        w.count(wrong as u64, 4096, || format!("{k}"));
    }
    // What is no power of two rounds s and q of the corners anew.
    for k in [3.0, 1.0 / 7.0] {
        for (a, b) in draw(k).iter().zip(&one) {
            w.see(f64::from((a[0] - b[0]).abs()) * 255.0 / 2.0, || format!("{k}"));
        }
    }
}

fn q_through_zero(w: &mut Worst) {
    for (left, right) in [(1.0f32, -1.0f32), (1.0, 0.0), (0.0, 0.0), (-1.0, -1.0), (1e-30, -1.0), (1.0, -1e-30)] {
        let draw = |cx: &mut Context| {
            ramp(cx, GL_CLAMP_TO_EDGE);
            cover(cx, |cx, i| cx.tex_coord4f(0.125, 0.0, 0.0, if i == 0 || i == 3 { left } else { right }));
        };
        let got = everywhere(w, [64, 4], draw);
        for (i, color) in got.iter().enumerate() {
            let t = ((i % 64) as f64 + 0.5) / 64.0;
            let q = f64::from(left) * (1.0 - t) + f64::from(right) * t;
            w.holds((0.0..=1.0).contains(&color[0]), || format!("{left}..{right}: {color:?}"));
            let step = (f64::from(left) - f64::from(right)).abs() / 64.0;
            if q > 0.0 {
                // Texels between pixels: 256 s dq / q^2.
                let footprint = (256.0 * 0.125 * step / (q * q)).max(1.0);
                if let Some(off) = texels_off(GL_CLAMP_TO_EDGE, color[0], 0.125 / q) {
                    w.see(off / footprint, || format!("{left}..{right} at {i}: q = {q}"));
                }
            }
        }
    }
}

fn steep_q(w: &mut Worst) {
    let mut random = Random(17);
    for round in 0..1000 {
        let corners: [[f64; 5]; 3] = std::array::from_fn(|_| {
            let depth = f64::from(any_size(&mut random, -3.0, 3.0).abs());
            let q = f64::from(any_size(&mut random, -3.0, 3.0).abs());
            let at = [random.range(-1.5, 1.5), random.range(-1.5, 1.5)].map(|v| f64::from((v * depth) as f32));
            [at[0], at[1], depth, f64::from((q * random.range(-2.0, 2.0)) as f32), q]
        });
        let mut cx = floats(32, 32);
        ramp(&mut cx, GL_REPEAT);
        cx.begin(GL_TRIANGLES);
        for [x, y, depth, s, q] in corners {
            cx.tex_coord4d(s, 0.0, 0.0, q);
            cx.vertex4d(x, y, 0.0, depth);
        }
        cx.end();
        let window = |[x, y, depth, ..]: [f64; 5]| Window {
            x: 16.0 + 16.0 * x / depth,
            y: 16.0 + 16.0 * y / depth,
            z: 0.0,
            inv_w: 1.0 / depth,
        };
        let triangle = Triangle(corners.map(window));
        w.fuzzed += 1;
        for (i, color) in read(&mut cx).into_iter().enumerate() {
            let at = [(i % 32) as f64 + 0.5, (i / 32) as f64 + 0.5];
            if triangle.edge_distance(at[0], at[1]) > 0.02 {
                let (s, [dx, dy]) = triangle.interpolate(at, corners.map(|c| c[3]), corners.map(|c| c[4]));
                let footprint = (256.0 * dx.abs().max(dy.abs())).max(1.0);
                if let Some(off) = texels_off(GL_REPEAT, color[0], s) {
                    w.see(off / footprint, || format!("triangle {round} at {at:?}: {corners:?}"));
                }
            }
        }
    }
}
