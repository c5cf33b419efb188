//! Images (OpenGL 1.5, sections 3.8.1 to 3.8.8): textures of one texel and of one colour, borders, faces of cubes at their
//! edges, chains of odd sizes, the greatest size.

use crate::oracle::texel::cube_face;
use crate::stability::common::{any_size, bytes, cover, everywhere, floats, read};
use crate::stability::coords::MODES;
use crate::stability::row::{Worst, rows};
use crate::support::{Random, get_i, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    one_texel: "T9", "1 x 1, 1 x 16 and 16 x 1 images of one colour, the border of the same; 6 filters x 8 wrap modes x 1D, 2D, 3D; coordinates to 1e30",
        "the colour", 1e-4, "255ths", "nested lerp a + t (b - a) of whole numbers, times 1/255 once";
    one_color: "T10", "a chain of one colour under 60 random triangles; 6 filters, anisotropy 1 and 16, 2D, 3D, cube; all 256 values",
        "the colour, the same float everywhere", 1e-4, "255ths", "lerps and means of equal values are that value";
    borders: "T11", "images with a border and without, 1D, 2D, 3D; s < -1/2N, corners", "border texel or colour; half, 3/4, 7/8 of it",
        1e-4, "255ths", "a ring around each image holds what a wrap mode reads there";
    cube_edges: "T12", "100,000 directions at edges, corners and ties, lengths 1e-30 to 1e30", "the face of a component within 1e-6 of the greatest",
        0.0, "wrong faces", "comparisons of the components; z before y before x";
    cube_oddities: "T12b", "the zero vector, NaN, infinities, ties of all signs", "undefined; ours: face +z for zero, a number everywhere", 0.0,
        "wrong pictures", "division by the greatest component or by 1";
    odd_chains: "T13", "GENERATE_MIPMAP of ramps of every size 2 to 200 and 255, 257, 1000, 1023", "a ramp stays at its place",
        0.03, "texels of the level", "three texels with weights (m - i, m, i + 1)/n where n is odd";
    last_level: "T13b", "GENERATE_MIPMAP of noise of 16 bits, every size 2 to 300 in 1D, 40 random sizes in 2D", "1 x 1 is the mean of the image", 0.51,
        "steps of 16 bits", "weights that are the share of each texel, floats down the chain";
    chain_means: "T14", "GENERATE_MIPMAP of noise, 12 sizes", "the mean of each level is that of the image", 0.5, "255ths",
        "levels from sums or floats, each rounded once";
    greatest_size: "T16", "a texture of 8192 texels, LINEAR; 8193 and more", "texel positions; INVALID_VALUE", 2e-3, "texels of 8192",
        "position s N in f32: 10 bits below a texel are left of s near 1";
}

const FILTERS: [GLenum; 6] = [
    GL_NEAREST,
    GL_LINEAR,
    GL_NEAREST_MIPMAP_NEAREST,
    GL_LINEAR_MIPMAP_NEAREST,
    GL_NEAREST_MIPMAP_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
];

/// Uploads a level of any target, tightly packed RGBA.
fn image(cx: &mut Context, target: GLenum, level: i32, size: [i32; 3], border: i32, texels: &[[u8; 4]]) {
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    let px = texels.as_flattened();
    let [w, h, d] = size.map(|n| n + 2 * border);
    let inner = GL_RGBA8 as i32;
    match target {
        GL_TEXTURE_1D => cx.tex_image_1d(target, level, inner, w, border, GL_RGBA, GL_UNSIGNED_BYTE, px),
        GL_TEXTURE_3D => cx.tex_image_3d(target, level, inner, w, h, d, border, GL_RGBA, GL_UNSIGNED_BYTE, px),
        GL_TEXTURE_CUBE_MAP => (0..6).for_each(|face| {
            let face = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
            cx.tex_image_2d(face, level, inner, w, h, border, GL_RGBA, GL_UNSIGNED_BYTE, px);
        }),
        _ => cx.tex_image_2d(target, level, inner, w, h, border, GL_RGBA, GL_UNSIGNED_BYTE, px),
    }
    no_error(cx);
}

fn filters(cx: &mut Context, target: GLenum, min: GLenum) {
    let mag = if matches!(min, GL_NEAREST | GL_NEAREST_MIPMAP_NEAREST) { GL_NEAREST } else { GL_LINEAR };
    cx.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, min);
    cx.tex_parameteri(target, GL_TEXTURE_MAG_FILTER, mag);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(target);
}

fn wraps(cx: &mut Context, target: GLenum, mode: GLenum) {
    for pname in [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R] {
        cx.tex_parameteri(target, pname, mode);
    }
}

fn see_color(w: &mut Worst, got: &[[f32; 4]], want: [u8; 4], what: impl Fn() -> String) {
    for c in got {
        let off = (0..4).map(|k| (f64::from(c[k]) * 255.0 - f64::from(want[k])).abs()).fold(0.0, f64::max);
        w.see(off, || format!("{}: {c:?}", what()));
    }
}

fn one_texel(w: &mut Worst) {
    let mut random = Random(9);
    let color = [201u8, 77, 3, 129];
    for target in [GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D] {
        for size in [[1, 1, 1], [16, 1, 1], [1, 16, 1], [1, 1, 16]] {
            if target == GL_TEXTURE_1D && size[1] * size[2] > 1 || target == GL_TEXTURE_2D && size[2] > 1 {
                continue;
            }
            for (mode, min) in MODES.iter().flat_map(|m| FILTERS.map(|f| (*m, f))) {
                let mut cx = floats(8, 8);
                for level in 0..if size == [1; 3] { 1 } else { 5 } {
                    let size = size.map(|n: i32| (n >> level).max(1));
                    image(&mut cx, target, level, size, 0, &vec![color; size.iter().product::<i32>() as usize]);
                }
                filters(&mut cx, target, min);
                wraps(&mut cx, target, mode);
                cx.tex_parameterfv(target, GL_TEXTURE_BORDER_COLOR, &color.map(|c| f32::from(c) / 255.0));
                let reach = [1.0, 6.0, 30.0][random.below(3) as usize];
                cover(&mut cx, |cx, _| {
                    let mut at = || any_size(&mut random, -3.0, reach);
                    cx.tex_coord3f(at(), at(), at());
                });
                see_color(w, &read(&mut cx), color, || format!("{target:#x} {size:?} {mode:#x} {min:#x}"));
            }
        }
    }
}

fn one_color(w: &mut Worst) {
    let mut random = Random(10);
    for (target, size) in
        [(GL_TEXTURE_2D, [64, 16, 1]), (GL_TEXTURE_3D, [8, 16, 4]), (GL_TEXTURE_CUBE_MAP, [32, 32, 1])]
    {
        for (min, taps) in FILTERS.iter().flat_map(|f| [(*f, 1.0f32), (*f, 16.0)]) {
            let v = random.below(256) as u8;
            let color = [v, v.wrapping_mul(37), v.wrapping_add(85), 255 - v];
            let mut cx = floats(64, 64);
            for level in 0..7 {
                let size = size.map(|n: i32| (n >> level).max(1));
                image(&mut cx, target, level, size, 0, &vec![color; size.iter().product::<i32>() as usize]);
            }
            filters(&mut cx, target, min);
            cx.tex_parameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, taps);
            cx.begin(GL_TRIANGLES);
            for _ in 0..180 {
                let mut at = |reach: f64| random.range(-reach, reach) as f32;
                cx.tex_coord3f(at(40.0), at(40.0), at(40.0));
                let depth = at(2.0).abs() + 0.5;
                cx.vertex4f(at(1.5) * depth, at(1.5) * depth, 0.0, depth);
            }
            cx.end();
            let drawn: Vec<_> = read(&mut cx).into_iter().filter(|c| *c != [0.0; 4]).collect();
            see_color(w, &drawn, color, || format!("{target:#x} {min:#x} anisotropy {taps}"));
            let one = drawn.iter().all(|c| c.map(f32::to_bits) == drawn[0].map(f32::to_bits));
            w.holds(one, || format!("{target:#x} {min:#x} anisotropy {taps}: not one float"));
        }
    }
    // Every value, by bytes.
    for v in 0..=255u8 {
        let mut cx = bytes(4, 4);
        image(&mut cx, GL_TEXTURE_2D, 0, [2, 2, 1], 0, &[[v; 4]; 4]);
        filters(&mut cx, GL_TEXTURE_2D, GL_LINEAR);
        cover(&mut cx, |cx, i| cx.tex_coord2f(i as f32 * 0.77, i as f32 * -0.31));
        w.holds(cx.pixels().iter().all(|b| *b == v), || format!("{v} became {}", cx.pixels()[0]));
    }
}

fn borders(w: &mut Worst) {
    let (inner, outer) = ([40u8, 80, 120, 255], [200u8, 0, 40, 55]);
    for (target, dims) in [(GL_TEXTURE_1D, 1), (GL_TEXTURE_2D, 2), (GL_TEXTURE_3D, 3)] {
        for (border, mode) in [0, 1].iter().flat_map(|b| [(*b, GL_CLAMP), (*b, GL_CLAMP_TO_BORDER)]) {
            let size: [i32; 3] = std::array::from_fn(|d| if d < dims { 4 } else { 1 });
            let widths: [i32; 3] = std::array::from_fn(|d| if d < dims { 4 + 2 * border } else { 1 });
            let n = widths.iter().product::<i32>();
            let texels: Vec<[u8; 4]> = (0..n)
                .map(|k| {
                    let at = [k % widths[0], k / widths[0] % widths[1], k / widths[0] / widths[1]];
                    let outside = |d: usize| at[d] < border || at[d] >= widths[d] - border;
                    if (0..dims).any(outside) { outer } else { inner }
                })
                .collect();
            let mut cx = floats(4, 4);
            cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
            let px = texels.as_flattened();
            let (format, kind) = (GL_RGBA8 as i32, GL_UNSIGNED_BYTE);
            match target {
                GL_TEXTURE_1D => cx.tex_image_1d(target, 0, format, widths[0], border, GL_RGBA, kind, px),
                GL_TEXTURE_2D => cx.tex_image_2d(target, 0, format, widths[0], widths[1], border, GL_RGBA, kind, px),
                _ => cx.tex_image_3d(target, 0, format, widths[0], widths[1], widths[2], border, GL_RGBA, kind, px),
            }
            no_error(&mut cx);
            filters(&mut cx, target, GL_LINEAR);
            wraps(&mut cx, target, mode);
            cx.tex_parameterfv(target, GL_TEXTURE_BORDER_COLOR, &outer.map(|c| f32::from(c) / 255.0));
            // Far outside CLAMP stops at the edge, where half of each coordinate's weight is the border's.
            for far in [0.0f32, -0.2, -1e6, -1e30] {
                cover(&mut cx, |cx, _| cx.tex_coord3f(far, far, far));
                let within = if mode == GL_CLAMP || far == 0.0 { 0.5f64.powi(dims as i32) } else { 0.0 };
                for c in read(&mut cx) {
                    for k in 0..4 {
                        let want = within * f64::from(inner[k]) + (1.0 - within) * f64::from(outer[k]);
                        let off = f64::from(c[k]) * 255.0 - want;
                        w.see(off, || format!("{target:#x} {mode:#x} border {border} at {far}, size {size:?}: {c:?}"));
                    }
                }
            }
        }
    }
}

/// A cube of six colours, 1 texel a face.
fn six_colors(cx: &mut Context) {
    for face in 0..6 {
        let texel = [(40 * face + 5) as u8, 0, 0, 255];
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        cx.tex_image_2d(target, 0, GL_RGBA8 as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texel);
    }
    cx.tex_parameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.tex_parameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_CUBE_MAP);
}

/// One point a pixel with a direction each.
fn directions(cx: &mut Context, all: &[[f32; 3]]) -> Vec<u8> {
    let (width, height) = cx.size();
    crate::stability::common::window_coordinates(cx, width, height);
    cx.begin(GL_POINTS);
    for (i, r) in all.iter().enumerate() {
        cx.tex_coord3fv(r);
        cx.vertex2f((i as u32 % width) as f32 + 0.5, (i as u32 / width) as f32 + 0.5);
    }
    cx.end();
    no_error(cx);
    cx.pixels().chunks(4).take(all.len()).map(|c| c[0]).collect()
}

fn cube_edges(w: &mut Worst) {
    let mut random = Random(12);
    let all: Vec<[f32; 3]> = (0..100_000)
        .map(|_| {
            let k = any_size(&mut random, -30.0, 30.0).abs();
            let third = random.range(-1.0, 1.0) as f32;
            let sign = |random: &mut Random| if random.below(2) == 0 { k } else { -k };
            let mut r = [sign(&mut random), sign(&mut random), third * k];
            if random.below(4) == 0 {
                r[2] = sign(&mut random);
            }
            let nudge = |v: f32, random: &mut Random| f32::from_bits(v.to_bits() + random.below(3) as u32 - 1);
            r = [nudge(r[0], &mut random), nudge(r[1], &mut random), r[2]];
            r.rotate_left(random.below(3) as usize);
            r
        })
        .collect();
    let mut cx = bytes(400, 250);
    six_colors(&mut cx);
    for (r, got) in all.iter().zip(directions(&mut cx, &all)) {
        let face = (i32::from(got) - 5) / 40;
        let greatest = r.iter().fold(0.0f32, |m, v| m.max(v.abs()));
        let along = r[(face / 2).clamp(0, 2) as usize] * if face % 2 == 0 { 1.0 } else { -1.0 };
        let ours = cube_face(r.map(f64::from)).0 as i32;
        w.fuzzed += 1;
        w.holds(along >= greatest * 0.999_999 && face == ours, || format!("{r:?} reads face {face}, want {ours}"));
    }
}

fn cube_oddities(w: &mut Worst) {
    let odd = [0.0f32, -0.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE, 1e-45, 1.0, -1.0];
    for min in [GL_NEAREST, GL_LINEAR_MIPMAP_LINEAR] {
        let got = everywhere(w, [40, 25], |cx| {
            six_colors(cx);
            filters(cx, GL_TEXTURE_CUBE_MAP, min);
            let all: Vec<[f32; 3]> = (0..1000).map(|i| [odd[i % 10], odd[i / 10 % 10], odd[i / 100]]).collect();
            directions(cx, &all);
        });
        w.holds(got.iter().all(|c| (5.0..=205.001).contains(&(c[0] * 255.0)) && c[3] == 1.0), || {
            "no colour of the cube".into()
        });
        w.holds((got[0][0] * 255.0).round() == 165.0, || format!("zero reads {:?}", got[0]));
        // Triangles whose direction goes through zero, through infinity, and not at all.
        let (m, n) = (f32::MAX, f32::NAN);
        for corners in [
            [[1.0, 1.0, 1.0], [-1.0, -1.0, -1.0], [1.0, -1.0, 0.0]],
            [[m, m, m], [-m, m, -m], [m, -m, 0.0]],
            [[n, 1.0, 0.0]; 3],
            [[1e-45; 3], [-1e-45; 3], [0.0; 3]],
        ] {
            everywhere(w, [16, 16], |cx| {
                six_colors(cx);
                filters(cx, GL_TEXTURE_CUBE_MAP, min);
                cover(cx, |cx, i| cx.tex_coord3fv(&corners[i % 3]));
            });
        }
    }
}

/// The levels of the bound 1D or 2D texture as floats of one channel.
fn level(cx: &mut Context, target: GLenum, n: i32, texels: usize) -> Vec<f32> {
    let mut out = vec![0f32; texels];
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    cx.get_tex_image(target, n, GL_LUMINANCE, GL_FLOAT, &mut out);
    no_error(cx);
    out
}

fn odd_chains(w: &mut Worst) {
    for n in (2..=200).chain([255, 257, 1000, 1023]) {
        let mut cx = bytes(4, 4);
        let ramp: Vec<f32> = (0..n).map(|i| (i as f32 + 0.5) / n as f32).collect();
        cx.tex_parameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, 1);
        cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_LUMINANCE16 as i32, n, 0, GL_LUMINANCE, GL_FLOAT, &ramp);
        let mut size = n;
        let mut step = 0;
        while size > 1 {
            (size, step) = (size / 2, step + 1);
            for (j, v) in level(&mut cx, GL_TEXTURE_1D, step, size as usize).into_iter().enumerate() {
                let off = f64::from(v) * f64::from(size) - (j as f64 + 0.5);
                w.see(off, || format!("N = {n}, level {step} texel {j}"));
            }
        }
    }
}

fn last_level(w: &mut Worst) {
    let mut random = Random(13);
    let lines = (2..=300).map(|n| [n, 1]);
    let sizes: Vec<[i32; 2]> = lines.chain((0..40).map(|_| [0; 2].map(|_: i32| 1 + random.below(90) as i32))).collect();
    for [width, height] in sizes {
        let mut cx = bytes(4, 4);
        let noise: Vec<u16> = (0..width * height).map(|_| random.bits() as u16).collect();
        let mean = noise.iter().map(|v| f64::from(*v) / 65535.0).sum::<f64>() / noise.len() as f64;
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, 2);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
        cx.tex_image_2d(
            GL_TEXTURE_2D,
            0,
            GL_LUMINANCE16 as i32,
            width,
            height,
            0,
            GL_LUMINANCE,
            GL_UNSIGNED_SHORT,
            &noise,
        );
        let last = width.max(height).ilog2() as i32;
        let got = f64::from(level(&mut cx, GL_TEXTURE_2D, last, 1)[0]);
        w.fuzzed += 1;
        w.see((got - mean) * 65535.0, || format!("{width} x {height}: {got}, want {mean}"));
    }
}

fn chain_means(w: &mut Worst) {
    let mut random = Random(14);
    for [width, height] in [
        [256, 256],
        [255, 255],
        [100, 60],
        [37, 53],
        [1023, 1],
        [1, 511],
        [129, 64],
        [3, 3],
        [2, 7],
        [512, 8],
        [81, 27],
        [1000, 3],
    ] {
        let mut cx = bytes(4, 4);
        let noise: Vec<u8> = (0..width * height).map(|_| random.bits() as u8).collect();
        let mean = noise.iter().map(|v| f64::from(*v)).sum::<f64>() / noise.len() as f64;
        cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
        cx.tex_image_2d(
            GL_TEXTURE_2D,
            0,
            GL_LUMINANCE8 as i32,
            width,
            height,
            0,
            GL_LUMINANCE,
            GL_UNSIGNED_BYTE,
            &noise,
        );
        let (mut size, mut step) = ([width, height], 0);
        while size != [1, 1] {
            (size, step) = (size.map(|n| (n / 2).max(1)), step + 1);
            let texels = level(&mut cx, GL_TEXTURE_2D, step, (size[0] * size[1]) as usize);
            let got = texels.iter().map(|v| f64::from(*v) * 255.0).sum::<f64>() / texels.len() as f64;
            w.see(got - mean, || format!("{width} x {height}, level {step}: {got}, want {mean}"));
        }
    }
}

fn greatest_size(w: &mut Worst) {
    let mut cx = floats(8192, 1);
    let n = get_i(&mut cx, GL_MAX_TEXTURE_SIZE);
    w.equal(n, 8192, "MAX_TEXTURE_SIZE");
    for beyond in [n + 1, n * 2, i32::MAX] {
        raises(&mut cx, GL_INVALID_VALUE, |cx| {
            cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, beyond, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]);
        });
    }
    // Neighbours differ by 64, so that a position is seen to 1/64 of a byte's place.
    let texels: Vec<u8> = (0..n).map(|i| (i % 2 * 64) as u8).collect();
    cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_LUMINANCE8 as i32, n, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    filters(&mut cx, GL_TEXTURE_1D, GL_LINEAR);
    for shift in [0.0f32, 0.25, 0.4375] {
        let s = shift / n as f32;
        cover(&mut cx, |cx, i| cx.tex_coord1f(s + if i == 1 || i == 2 { 1.0 } else { 0.0 }));
        for (x, c) in read(&mut cx).into_iter().enumerate().skip(1).take(8190) {
            let want =
                f64::from(s) * f64::from(n) + if x % 2 == 0 { 0.0 } else { 1.0 - 2.0 * f64::from(s) * f64::from(n) };
            w.see(f64::from(c[0]) * 255.0 / 64.0 - want, || format!("{shift} at {x}"));
        }
    }
}
