//! Matrices, normals, generated coordinates, lighting (OpenGL 1.5, sections 2.11 to 2.14): singular and ill-conditioned
//! matrices, what accumulates over a day, the pole of the sphere map, powers and attenuations at their ends.

use crate::oracle::matrix::M4;
use crate::stability::common::{Color, bytes, cover, everywhere, floats, read};
use crate::stability::row::{Worst, rows};
use crate::support::{Random, get_i, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

rows! {
    sphere_pole: "V1", "reflections 1e-1 to 1e-8 rad from (0, 0, -1), 16 directions", "r/m + 1/2 of the given normal", 2e-3, "texels of 256",
        "m as the root of the written-out sum";
    no_direction: "V2", "SPHERE_MAP, REFLECTION_MAP, lighting of a vertex at the eye, of a zero normal, at the pole itself", "undefined; ours: u = 0, n = 0, s = t = 1/2",
        0.0, "wrong pictures", "what has no length stays zero";
    random_normals: "V4", "100,000 random matrices of whole numbers, condition 1 to 1e15, NORMALIZE", "cofactors by 128-bit integers; either sign where the determinant is under 2^-50 of its terms", 1e-6, "radians",
        "cofactors in f64 and the sign of the determinant, no division by it";
    odd_normals: "V4b", "singular, zero, huge, tiny, infinite, NaN matrices; NORMALIZE, RESCALE_NORMAL, neither", "diag(1, 1, 0) leaves (0, 0, 1); numbers", 0.0,
        "wrong pictures", "scaled by a power of two first; not finite gives the zero normal";
    random_planes: "V5", "100,000 random matrices of determinant 1 and condition up to 1e12 under TexGen and ClipPlane", "p M^-1 by whole numbers", 1e-15,
        "of the condition number", "adjugate in f64";
    singular_planes: "V5b", "EYE_LINEAR and ClipPlane under singular, NaN and huge matrices", "undefined; ours: the zero plane", 0.0, "wrong planes",
        "what is not finite is zero";
    many_rotations: "V6", "360,000 rotations by 1 degree about (1, 2, 3)", "the identity", 1e-9, "in determinant and elements", "stacks in f64, sines of degrees exact";
    day_of_scrolling: "V7", "24 hours of 60 translations a second by 0.01f32 on a texture matrix; REPEAT", "the sum in f64", 1e-3, "texels of 256",
        "stacks in f64, whole periods taken off in f64";
    whole_offsets: "V7b", "texture matrices that translate by k + 1/8 and k + 1,000,000 + 1/8", "the same picture to the last bit", 0.0, "pictures that differ",
        "whole periods taken off in f64";
    stacks: "V8", "every matrix and attribute stack one push too far, one pop too far", "STACK_OVERFLOW, STACK_UNDERFLOW, nothing else", 0.0, "wrong answers",
        "checked before anything changes";
    powers: "V9", "1600 lit points: n.h from 0 to 1 and beside it, shininess 0, 1e-3, 1, 10, 127.5, 128", "(n.h)^s, 0^0 = 1", 1e-4, "255ths", "pow through f64";
    odd_lights: "V9b", "attenuation 0, 1e-38, 1e38; lights in a vertex, at 1e18, at infinity; colours of 1e38 and -1e38; spots of 0, 90, 180", "limited to 0..1, numbers",
        0.0, "wrong pictures", "attenuation limited to 1e30, zero vectors stay zero";
}

/// A ramp of 256 texels for s and one for t, at the given units; colours are (texel of s, ., .).
fn ramp(cx: &mut Context) {
    let texels: Vec<[u8; 4]> = (0..65536u32).map(|i| [(i % 256) as u8, (i / 256) as u8, 0, 255]).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.as_flattened());
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
}

/// A projection that puts the eye's point (0, 0, -z) on the middle of a pixel.
fn aim(cx: &mut Context, [width, height]: [u32; 2], index: u32) {
    let at = |i: u32, n: u32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
    cx.matrix_mode(GL_PROJECTION);
    cx.load_matrixd(&M4::translation(at(index % width, width), at(index / width, height), 0.0).to_gl());
    cx.matrix_mode(GL_MODELVIEW);
}

fn generate(cx: &mut Context, mode: GLenum) {
    for (coord, cap) in [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T)] {
        cx.tex_geni(coord, GL_TEXTURE_GEN_MODE, mode);
        cx.enable(cap);
    }
}

fn sphere_pole(w: &mut Worst) {
    let mut cx = floats(16, 8);
    ramp(&mut cx);
    generate(&mut cx, GL_SPHERE_MAP);
    let mut want = Vec::new();
    for index in 0..128u32 {
        let eps = 10f64.powi(-1 - index as i32 / 16);
        let angle = f64::from(index % 16) * 0.39 + 0.1;
        // n nearly across the view: r = u - 2 n (n.u) with u = (0, 0, -1).
        let n = [angle.cos(), angle.sin(), eps / 2.0].map(|v| v as f32);
        aim(&mut cx, [16, 8], index);
        cx.begin(GL_POINTS);
        cx.normal3fv(&n);
        cx.vertex3f(0.0, 0.0, -0.5);
        cx.end();
        let n = n.map(f64::from);
        let r = [2.0 * n[2] * n[0], 2.0 * n[2] * n[1], -1.0 + 2.0 * n[2] * n[2]];
        let m = 2.0 * (r[0] * r[0] + r[1] * r[1] + (r[2] + 1.0) * (r[2] + 1.0)).sqrt();
        want.push([r[0] / m + 0.5, r[1] / m + 0.5]);
    }
    no_error(&mut cx);
    for (i, (color, want)) in read(&mut cx).into_iter().zip(want).enumerate() {
        for k in 0..2 {
            let texel = (want[k] * 256.0).rem_euclid(256.0);
            if (1.0..255.0).contains(&texel) {
                w.see(f64::from(color[k]) * 255.0 + 0.5 - texel, || format!("point {i}: {color:?}, want {want:?}"));
            }
        }
    }
}

fn no_direction(w: &mut Worst) {
    for (mode, lit) in [(GL_SPHERE_MAP, false), (GL_REFLECTION_MAP, false), (GL_SPHERE_MAP, true)] {
        for (position, normal) in [
            ([0.0f32, 0.0, 0.0], [0.0f32, 0.0, 1.0]),
            ([0.0, 0.0, -0.5], [0.0, 0.0, 0.0]),
            ([0.0; 3], [0.0; 3]),
            ([0.0, 0.0, -0.5], [1.0, 0.0, 0.0]),
            ([0.0, 0.0, 0.5], [f32::NAN, 0.0, 1.0]),
        ] {
            let got = everywhere(w, [1, 1], |cx| {
                ramp(cx);
                generate(cx, mode);
                for cap in [GL_NORMALIZE, GL_LIGHT0].into_iter().chain(lit.then_some(GL_LIGHTING)) {
                    cx.enable(cap);
                }
                cx.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
                cx.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, 0.0, 1.0]);
                cx.begin(GL_POINTS);
                cx.normal3fv(&normal);
                cx.vertex3fv(&position);
                cx.end();
            });
            // SPHERE_MAP: 1/2 where r is zero or (0, 0, -1). REFLECTION_MAP of the same: 0 and so the seam of the texture.
            let pole = position[2] <= 0.0 && !normal[0].is_nan();
            let right =
                if mode == GL_SPHERE_MAP && pole { (got[0][0] * 255.0 - 127.5).abs() < 0.01 } else { got[0][3] > 0.0 };
            w.holds(right, || format!("{mode:#x} {position:?} {normal:?}: {got:?}"));
        }
    }
}

/// Six lamps that show a normal: colour = 1/2 + n/2.
fn show_normals(cx: &mut Context) {
    cx.enable(GL_LIGHTING);
    cx.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
    cx.materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &[1.0; 4]);
    cx.materialfv(GL_FRONT_AND_BACK, GL_EMISSION, &[0.5, 0.5, 0.5, 1.0]);
    for k in 0..6u32 {
        let (axis, sign) = ((k / 2) as usize, if k % 2 == 0 { 1.0 } else { -1.0 });
        let along = |v: f32| std::array::from_fn::<f32, 4, _>(|i| if i == axis { v } else { 0.0 });
        cx.lightfv(GL_LIGHT0 + k, GL_DIFFUSE, &along(0.5 * sign));
        cx.lightfv(GL_LIGHT0 + k, GL_SPECULAR, &[0.0; 4]);
        cx.lightfv(GL_LIGHT0 + k, GL_POSITION, &along(sign));
        cx.enable(GL_LIGHT0 + k);
    }
}

fn normal_of(c: Color) -> [f64; 3] {
    [0, 1, 2].map(|k: usize| 2.0 * f64::from(c[k]) - 1.0)
}

/// Three columns of whole numbers, sometimes nearly dependent.
fn whole_matrix(random: &mut Random) -> [[i64; 3]; 3] {
    let bits = [4, 12, 24][random.below(3) as usize];
    let mut whole = |bits: u32| random.below(2 << bits) as i64 - (1 << bits);
    let mut m: [[i64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| whole(bits)));
    let (a, b) = (whole(10), whole(10));
    match whole(1) {
        -2 => {}
        -1 => m[2] = std::array::from_fn(|k| a * m[0][k] + b * m[1][k] + whole(1)),
        0 => m[1] = std::array::from_fn(|k| (1 << 20) * m[0][k] + whole(2)),
        _ => m[0] = std::array::from_fn(|k| a * m[1][k] - m[2][k] + whole(3)),
    }
    m
}

fn random_normals(w: &mut Worst) {
    let mut random = Random(40);
    let size = [400u32, 250];
    let mut cx = floats(size[0], size[1]);
    show_normals(&mut cx);
    cx.enable(GL_NORMALIZE);
    let mut want = Vec::new();
    for index in 0..size[0] * size[1] {
        let m = whole_matrix(&mut random);
        let n: [i64; 3] = std::array::from_fn(|_| random.below(2001) as i64 - 1000);
        let at = |i: u32, n: u32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
        let mut columns = [0.0; 16];
        for (c, r) in (0..9).map(|i| (i / 3, i % 3)) {
            columns[4 * c + r] = m[c][r] as f64;
        }
        columns[12..].copy_from_slice(&[at(index % size[0], size[0]), at(index / size[0], size[1]), 0.0, 1.0]);
        cx.load_matrixd(&columns);
        cx.begin(GL_POINTS);
        cx.normal3f(n[0] as f32, n[1] as f32, n[2] as f32);
        cx.vertex3f(0.0, 0.0, 0.0);
        cx.end();
        want.push(exact_normal(&m, n));
    }
    no_error(&mut cx);
    for (i, (color, want)) in read(&mut cx).into_iter().zip(want).enumerate() {
        w.fuzzed += 1;
        let got = normal_of(color);
        let (want, sure) = want;
        let off = |sign: f64| (0..3).map(|k| (got[k] - sign * want[k]).powi(2)).sum::<f64>().sqrt();
        let off = if sure { off(1.0) } else { off(1.0).min(off(-1.0)) };
        w.see(off, || format!("matrix {i}: {got:?}, want {want:?}"));
    }
}

/// The direction of n M^-1: cofactors times the sign of the determinant, whole numbers to the last. And whether that sign
/// is more than rounding in f64: matrices that are singular to the last bit may turn the normal round.
fn exact_normal(m: &[[i64; 3]; 3], n: [i64; 3]) -> ([f64; 3], bool) {
    let m = m.map(|c| c.map(i128::from));
    let cofactor = |c: usize, r: usize| {
        let (c1, c2, r1, r2) = ((c + 1) % 3, (c + 2) % 3, (r + 1) % 3, (r + 2) % 3);
        m[c1][r1] * m[c2][r2] - m[c1][r2] * m[c2][r1]
    };
    let determinant: i128 = (0..3).map(|r| m[0][r] * cofactor(0, r)).sum();
    let sign = if determinant < 0 { -1.0 } else { 1.0 };
    let v: [f64; 3] =
        std::array::from_fn(|r| sign * (0..3).map(|c| cofactor(c, r) * i128::from(n[c])).sum::<i128>() as f64);
    let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
    let terms: f64 = (0..3).map(|r| (m[0][r] as f64 * m[1][(r + 1) % 3] as f64 * m[2][(r + 2) % 3] as f64).abs()).sum();
    let other: f64 = (0..3).map(|r| (m[0][r] as f64 * m[1][(r + 2) % 3] as f64 * m[2][(r + 1) % 3] as f64).abs()).sum();
    let sure = (determinant as f64).abs() > (terms + other) * 2f64.powi(-50);
    (if length == 0.0 { v } else { v.map(|v| v / length) }, sure)
}

fn odd_normals(w: &mut Worst) {
    let d = |x: f64, y: f64, z: f64| M4::scaling(x, y, z).to_gl();
    let matrices = [
        d(1.0, 1.0, 0.0),
        d(0.0, 0.0, 0.0),
        d(1e-30, 1e-30, 1e-30),
        d(1e30, 1e30, 1e30),
        d(1e150, 1.0, 1e-150),
        d(f64::INFINITY, 1.0, 1.0),
        d(1.0, f64::NAN, 1.0),
        d(1e300, 1e300, 1e300),
        d(1e-300, 1e-300, 1e-300),
    ];
    for (i, matrix) in matrices.iter().enumerate() {
        for cap in [GL_NORMALIZE, GL_RESCALE_NORMAL, GL_DITHER] {
            let got = everywhere(w, [1, 1], |cx| {
                show_normals(cx);
                cx.enable(cap);
                cx.load_matrixd(matrix);
                cx.begin(GL_POINTS);
                cx.normal3f(0.0, 0.0, 1.0);
                cx.vertex3f(0.0, 0.0, 0.0);
                cx.end();
            });
            let n = normal_of(got[0]);
            let unit = matches!(i, 0 | 2 | 3 | 7 | 8) && cap == GL_NORMALIZE
                || matches!(i, 2 | 3 | 7 | 8) && cap == GL_RESCALE_NORMAL;
            // A matrix with NaN or infinity has no place for the vertex either: nothing is drawn.
            let nothing = got[0] == [0.0; 4];
            let right = if unit {
                (n[2] - 1.0).abs() < 1e-6 && n[0].abs() + n[1].abs() < 1e-6
            } else {
                nothing || got[0].iter().all(|v| (0.0..=1.0).contains(v))
            };
            w.holds(right, || format!("matrix {i}, {cap:#x}: {got:?}"));
        }
    }
}

/// A product of shears: determinant 1, whole numbers, and its inverse, whole too.
fn shears(random: &mut Random) -> (M4, M4) {
    let (mut m, mut inverse) = (M4::IDENTITY, M4::IDENTITY);
    for _ in 0..3 + random.below(7) {
        let (i, j) = (random.below(4) as usize, random.below(4) as usize);
        if i != j {
            let k = random.below(17) as f64 - 8.0;
            let (mut a, mut b) = (M4::IDENTITY, M4::IDENTITY);
            (a.0[i][j], b.0[i][j]) = (k, -k);
            (m, inverse) = (m.times(a), b.times(inverse));
        }
    }
    (m, inverse)
}

fn greatest(m: M4) -> f64 {
    m.0.as_flattened().iter().fold(0.0, |a: f64, v| a.max(v.abs()))
}

fn random_planes(w: &mut Worst) {
    let mut random = Random(50);
    let mut cx = bytes(1, 1);
    for round in 0..100_000 {
        let (m, inverse) = shears(&mut random);
        let condition = greatest(m) * greatest(inverse);
        if condition > 1e12 {
            continue;
        }
        let plane: [f64; 4] = std::array::from_fn(|_| random.below(2001) as f64 - 1000.0);
        // Rows in other units, so that numbers are not whole: p (D M)^-1 = p M^-1 D^-1.
        let units: [f64; 4] = std::array::from_fn(|_| random.range(0.1, 10.0));
        let scaled = M4(std::array::from_fn(|r| m.0[r].map(|v| v * units[r])));
        let want = inverse.apply_row(plane);
        let want: [f64; 4] = std::array::from_fn(|k| want[k] / units[k]);
        cx.load_matrixd(&scaled.to_gl());
        let mut got = [0.0; 4];
        if round % 2 == 0 {
            cx.clip_plane(GL_CLIP_PLANE0, &plane);
            cx.get_clip_plane(GL_CLIP_PLANE0, &mut got);
        } else {
            cx.tex_gendv(GL_S, GL_EYE_PLANE, &plane);
            cx.get_tex_gendv(GL_S, GL_EYE_PLANE, &mut got);
        }
        w.fuzzed += 1;
        let size = plane.iter().fold(1.0, |a: f64, v| a.max(v.abs())) * greatest(inverse) * 40.0;
        let off = (0..4).map(|k| (got[k] - want[k]).abs()).fold(0.0, f64::max) / (size * condition);
        w.see(off, || format!("{m:?}: {got:?}, want {want:?}"));
    }
    no_error(&mut cx);
}

fn singular_planes(w: &mut Worst) {
    let d = |x: f64, y: f64, z: f64| M4::scaling(x, y, z).to_gl();
    let mut flat = d(1.0, 1.0, 1.0);
    flat.copy_within(0..4, 4);
    for (i, m) in [
        d(1.0, 1.0, 0.0),
        d(0.0, 0.0, 0.0),
        flat,
        d(f64::NAN, 1.0, 1.0),
        d(f64::INFINITY, 1.0, 1.0),
        [0.0; 16],
        [1.0; 16],
    ]
    .into_iter()
    .enumerate()
    {
        let mut cx = bytes(1, 1);
        cx.load_matrixd(&m);
        let (mut plane, mut eye) = ([1.0; 4], [1.0; 4]);
        cx.clip_plane(GL_CLIP_PLANE0, &[1.0, 2.0, 3.0, 4.0]);
        cx.get_clip_plane(GL_CLIP_PLANE0, &mut plane);
        cx.tex_gendv(GL_S, GL_EYE_PLANE, &[1.0, 2.0, 3.0, 4.0]);
        cx.get_tex_gendv(GL_S, GL_EYE_PLANE, &mut eye);
        w.equal((plane, eye), ([0.0; 4], [0.0; 4]), &format!("matrix {i}"));
    }
    // Scales far from 1 are no singularity.
    for k in [1e-30, 1e-20, 1e20, 1e30, 1e60, 1e-60, 1e90, 1e-90] {
        let mut cx = bytes(1, 1);
        cx.load_matrixd(&d(k, k, k));
        let mut plane = [0.0; 4];
        cx.clip_plane(GL_CLIP_PLANE0, &[1.0, 2.0, 3.0, 4.0]);
        cx.get_clip_plane(GL_CLIP_PLANE0, &mut plane);
        let right = (0..3).all(|i| (plane[i] * k / (i as f64 + 1.0) - 1.0).abs() < 1e-12) && plane[3] == 4.0;
        w.holds(right, || format!("scale {k}: {plane:?}"));
    }
    for m in [d(1.0, 1.0, 0.0), d(f64::NAN, 1.0, 1.0), d(1e300, 1e300, 1e-300)] {
        everywhere(w, [8, 8], |cx| {
            ramp(cx);
            generate(cx, GL_EYE_LINEAR);
            cx.push_matrix();
            cx.load_matrixd(&m);
            cx.tex_gendv(GL_S, GL_EYE_PLANE, &[1.0, 2.0, 3.0, 4.0]);
            cx.clip_plane(GL_CLIP_PLANE0, &[1.0, 2.0, 3.0, 4.0]);
            cx.enable(GL_CLIP_PLANE0);
            cx.pop_matrix();
            cover(cx, |_, _| {});
        });
    }
}

fn modelview(cx: &mut Context) -> M4 {
    let mut m = [0.0; 16];
    cx.get_doublev(GL_MODELVIEW_MATRIX, &mut m);
    M4::from_gl(m)
}

fn many_rotations(w: &mut Worst) {
    let mut cx = bytes(1, 1);
    for _ in 0..360_000 {
        cx.rotatef(1.0, 1.0, 2.0, 3.0);
    }
    let m = modelview(&mut cx);
    let a = m.0;
    let minor = |i: usize, j: usize| a[1][i] * a[2][j] - a[1][j] * a[2][i];
    let determinant = a[0][0] * minor(1, 2) - a[0][1] * minor(0, 2) + a[0][2] * minor(0, 1);
    w.see(determinant - 1.0, || format!("determinant {determinant}"));
    for (got, want) in m.0.as_flattened().iter().zip(M4::IDENTITY.0.as_flattened()) {
        w.see(got - want, || format!("{m:?}"));
    }
}

fn day_of_scrolling(w: &mut Worst) {
    let frames = 24 * 3600 * 60;
    let mut cx = floats(64, 4);
    ramp(&mut cx);
    cx.matrix_mode(GL_TEXTURE);
    for _ in 0..frames {
        cx.translatef(0.01, 0.0, 0.0);
    }
    cover(&mut cx, |cx, i| cx.tex_coord2f(if i == 1 || i == 2 { 1.0 } else { 0.0 }, 0.5));
    let offset = f64::from(frames) * f64::from(0.01f32);
    for (i, color) in read(&mut cx).into_iter().enumerate() {
        let texel = ((((i % 64) as f64 + 0.5) / 64.0 + offset) * 256.0).rem_euclid(256.0);
        if (1.0..255.0).contains(&texel) {
            w.see(f64::from(color[0]) * 255.0 + 0.5 - texel, || format!("pixel {i}: {color:?}, want {texel}"));
        }
    }
}

fn whole_offsets(w: &mut Worst) {
    for k in [0.0, 1.0, 7.0, 4096.0, 65_535.0] {
        let picture = |offset: f64| {
            let mut cx = floats(64, 64);
            ramp(&mut cx);
            cx.matrix_mode(GL_TEXTURE);
            cx.translated(offset, 2.0 * offset, 0.0);
            cx.rotated(33.0, 0.0, 0.0, 1.0);
            cover(&mut cx, |cx, i| {
                cx.tex_coord2f(if i == 1 || i == 2 { 2.5 } else { 0.0 }, if i > 1 { 1.7 } else { -0.3 })
            });
            read(&mut cx).as_flattened().iter().map(|v| v.to_bits()).collect::<Vec<_>>()
        };
        w.holds(picture(k + 0.125) == picture(k + 1_000_000.0 + 0.125), || format!("{k}"));
    }
}

fn stacks(w: &mut Worst) {
    let mut cx = bytes(2, 2);
    let stacks = [
        (GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH),
        (GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH),
        (GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH),
    ];
    for (mode, depth, limit) in stacks {
        cx.matrix_mode(mode);
        let limit = get_i(&mut cx, limit);
        for k in 1..limit {
            cx.translatef(1.0, 0.0, 0.0);
            cx.push_matrix();
            w.equal(get_i(&mut cx, depth), k + 1, "depth");
        }
        for _ in 0..1000 {
            raises(&mut cx, GL_STACK_OVERFLOW, |cx| cx.push_matrix());
        }
        w.equal(get_i(&mut cx, depth), limit, "depth at the limit");
        for _ in 1..limit {
            cx.pop_matrix();
        }
        for _ in 0..1000 {
            raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_matrix());
        }
        w.equal(get_i(&mut cx, depth), 1, "depth at the end");
    }
    // One translation was made before the first push.
    cx.matrix_mode(GL_MODELVIEW);
    w.equal(modelview(&mut cx), M4::translation(1.0, 0.0, 0.0), "the matrix under the stack");
    for _ in 0..16 {
        cx.push_attrib(GL_ALL_ATTRIB_BITS);
        cx.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }
    cx.point_size(7.0);
    raises(&mut cx, GL_STACK_OVERFLOW, |cx| cx.push_attrib(GL_POINT_BIT));
    raises(&mut cx, GL_STACK_OVERFLOW, |cx| cx.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS));
    w.equal(get_i(&mut cx, GL_POINT_SIZE), 7, "state after an overflow");
    for _ in 0..16 {
        cx.pop_attrib();
        cx.pop_client_attrib();
    }
    raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_attrib());
    raises(&mut cx, GL_STACK_UNDERFLOW, |cx| cx.pop_client_attrib());
    w.equal(get_i(&mut cx, GL_POINT_SIZE), 1, "state after all pops");
}

fn powers(w: &mut Worst) {
    let shininess = [0.0f32, 1e-3, 1.0, 10.0, 127.5, 128.0];
    for s in shininess {
        let mut cx = floats(40, 40);
        cx.enable(GL_LIGHTING);
        cx.enable(GL_LIGHT0);
        cx.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
        cx.materialfv(GL_FRONT, GL_DIFFUSE, &[0.0, 0.0, 0.0, 1.0]);
        cx.materialfv(GL_FRONT, GL_SPECULAR, &[1.0; 4]);
        cx.materialf(GL_FRONT, GL_SHININESS, s);
        // The light is where the viewer is: h = (0, 0, 1), n.h = n_z.
        let mut want = Vec::new();
        for index in 0..1600u32 {
            aim(&mut cx, [40, 40], index);
            let z = match index {
                0 => 0.0,
                1 => 1e-45,
                2 => 1e-38,
                3 => 1e-20,
                4 => f32::from_bits(1f32.to_bits() - 1),
                5 => 1.0,
                6 => 2.0,
                7 => -1.0,
                _ => index as f32 / 1600.0,
            };
            cx.begin(GL_POINTS);
            cx.normal3f(0.0, 0.0, z);
            cx.vertex3f(0.0, 0.0, 0.0);
            cx.end();
            // Without light on the front there is no highlight: n.l = n_z must be positive.
            want.push(if z > 0.0 { f64::from(z).powf(f64::from(s)).min(1.0) } else { 0.0 });
        }
        for (i, (color, want)) in read(&mut cx).into_iter().zip(want).enumerate() {
            w.see((f64::from(color[0]) - want) * 255.0, || format!("shininess {s}, point {i}: {color:?}, want {want}"));
        }
    }
}

fn odd_lights(w: &mut Worst) {
    let mut random = Random(90);
    let numbers = [0.0f32, 1e-38, 1e-10, 1.0, 1e10, 1e38];
    for round in 0..300 {
        let mut pick = |all: &[f32]| all[random.below(all.len() as u64) as usize];
        let attenuation = [pick(&numbers), pick(&numbers), pick(&numbers)];
        let position = [
            pick(&[0.0, 1e18, -1e30, 0.5, 3e38]),
            pick(&[0.0, 1.0]),
            pick(&[0.0, -0.5, 1e18]),
            pick(&[0.0, 1.0, 1e-30]),
        ];
        let color: [f32; 4] = [0; 4].map(|_| pick(&[0.0, 1.0, 1e38, -1e38, 0.5]));
        let (exponent, cutoff) = (pick(&[0.0, 1.0, 128.0]), pick(&[0.0, 90.0, 180.0, 45.0]));
        let shininess = pick(&[0.0, 1.0, 128.0]);
        let draw = |cx: &mut Context| {
            cx.enable(GL_LIGHTING);
            cx.enable(GL_LIGHT3);
            cx.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, round & 1);
            cx.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, round >> 1 & 1);
            cx.lightfv(GL_LIGHT3, GL_POSITION, &position);
            for pname in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR] {
                cx.lightfv(GL_LIGHT3, pname, &color);
                cx.materialfv(GL_FRONT_AND_BACK, pname, &color);
            }
            cx.materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
            for (pname, k) in
                [GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION].into_iter().zip(attenuation)
            {
                cx.lightf(GL_LIGHT3, pname, k);
            }
            cx.lightf(GL_LIGHT3, GL_SPOT_EXPONENT, exponent);
            cx.lightf(GL_LIGHT3, GL_SPOT_CUTOFF, cutoff);
            cover(cx, |cx, i| cx.normal3f(if i == 0 { 0.0 } else { 0.3 }, 0.0, i as f32 - 1.0));
            no_error(cx);
        };
        let got = if round < 60 {
            everywhere(w, [4, 4], draw)
        } else {
            let mut cx = floats(4, 4);
            draw(&mut cx);
            read(&mut cx)
        };
        w.holds(got.as_flattened().iter().all(|v| (0.0..=1.0).contains(v)), || format!("light {round}: {got:?}"));
    }
}
