//! Lines and points (OpenGL 1.5, sections 3.3 and 3.4): what they carry along, widths, flat shading, textures on them and
//! their level of detail. Where they run is measured in `rasterisation`.

use crate::oracle::raster::{lines, snap};
use crate::support::images::{bytes, chain};
use crate::support::{Random, no_error, pixels};
use fixedgl::Context;
use fixedgl::enums::*;
use std::collections::HashSet;

const SIZE: u32 = 64;

/// An end of a line: window position on the grid of 1/256 pixel, w, colour.
#[derive(Clone, Copy, Debug)]
struct End {
    at: [f64; 2],
    w: f64,
    color: [f64; 4],
}

fn end(r: &mut Random) -> End {
    End {
        at: std::array::from_fn(|_| r.below(64 * 256) as f64 / 256.0),
        w: r.pick(&[1.0, 0.5, 2.0, 4.0]),
        color: std::array::from_fn(|_| r.range(0.0, 1.0)),
    }
}

fn emit(cx: &mut Context, e: &End) {
    let [x, y] = e.at.map(|v| v / 32.0 - 1.0);
    cx.color4d(e.color[0], e.color[1], e.color[2], e.color[3]);
    cx.vertex4d(x * e.w, y * e.w, 0.0, e.w);
}

#[test]
fn colours_run_along_the_line_in_perspective() {
    let mut r = Random(5);
    let (mut seen, mut worst) = (0, 0.0f64);
    for width in [1.0, 3.0] {
        for flat in [false, true] {
            for _ in 0..60 {
                let (a, b) = (end(&mut r), end(&mut r));
                let mut cx = Context::new(SIZE, SIZE);
                cx.clear_color(0.0, 0.0, 0.0, 0.0);
                cx.line_width(width);
                cx.shade_model(if flat { GL_FLAT } else { GL_SMOOTH });
                cx.begin(GL_LINES);
                emit(&mut cx, &a);
                emit(&mut cx, &b);
                cx.end();
                let got = pixels(&mut cx, SIZE, SIZE);
                let length = ((a.at[0] - b.at[0]).powi(2) + (a.at[1] - b.at[1]).powi(2)).sqrt();
                if length < 4.0 || width > 1.0 && !flat {
                    // A wide line's fragments take their values from the thin one: only flat colours are told here.
                    continue;
                }
                for (i, p) in got.iter().enumerate().filter(|(_, p)| **p != [0; 4]) {
                    let at = [(i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5];
                    let t = lines::parameter(a.at, b.at, at).clamp(0.0, 1.0);
                    let (wa, wb) = ((1.0 - t) / a.w, t / b.w);
                    for k in 0..4 {
                        let smooth = (a.color[k] * wa + b.color[k] * wb) / (wa + wb);
                        let want = 255.0 * if flat { b.color[k] } else { smooth };
                        worst = worst.max((f64::from(p[k]) - want).abs());
                    }
                    seen += 1;
                }
            }
        }
    }
    eprintln!("lines: {seen} fragments, worst colour {worst:.3} LSB");
    assert!(seen > 3000 && worst < 1.0, "{seen} {worst}");
}

#[test]
fn wide_lines_are_rows_and_columns() {
    let mut r = Random(15);
    let (mut differ, mut total) = (0, 0);
    for width in [2i64, 3, 5, 8] {
        for _ in 0..40 {
            let inside = |r: &mut Random| [0, 1].map(|_| (10.0 * 256.0 + r.below(44 * 256) as f64) / 256.0);
            let (a, b) = (inside(&mut r), inside(&mut r));
            let mut cx = Context::new(SIZE, SIZE);
            cx.line_width(width as f32);
            cx.begin(GL_LINES);
            for p in [a, b] {
                cx.vertex2d(p[0] / 32.0 - 1.0, p[1] / 32.0 - 1.0);
            }
            cx.end();
            let want: HashSet<[i64; 2]> = lines::wide_line(a.map(snap), b.map(snap), width).into_iter().collect();
            total += want.len();
            for (i, p) in pixels(&mut cx, SIZE, SIZE).iter().enumerate() {
                differ += usize::from((p[3] > 0) != want.contains(&[i as i64 % 64, i as i64 / 64]));
            }
        }
    }
    eprintln!("wide lines: {total} fragments, {differ} differ");
    assert!(differ * 100 <= total, "{differ} of {total}");
}

/// Level d of the texture is (20 d + 10) everywhere.
fn named_levels(cx: &mut Context) {
    let t = chain(GL_TEXTURE_2D, GL_RGBA, [32, 32, 1], |s, level| {
        crate::oracle::texel::Image::new(s, [0; 3], |_| bytes([(20 * level + 10) as u8; 4]))
    });
    let mut t = t;
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    crate::support::bridge::texture(cx, &t);
    cx.enable(GL_TEXTURE_2D);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    no_error(cx);
}

#[test]
fn a_point_reads_the_base_level() {
    // rho is 1 for points (section 3.8.8). Here their derivatives are 0, which a positive bias would tell from 1; see
    // spec-notes/texture-filtering.md.
    for (bias, want) in [(0.0, 10), (-2.0, 10)] {
        let mut cx = Context::new(SIZE, SIZE);
        named_levels(&mut cx);
        cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, bias);
        cx.point_size(5.0);
        cx.begin(GL_POINTS);
        cx.tex_coord2f(0.3, 0.7);
        cx.vertex2f(0.1, 0.1);
        cx.end();
        let got = pixels(&mut cx, SIZE, SIZE);
        let points: Vec<_> = got.iter().filter(|p| **p != [0; 4]).collect();
        assert_eq!(points.len(), 25);
        assert!(points.iter().all(|p| i16::from(p[0]).abs_diff(want) <= 1), "bias {bias}: {:?}", points[0]);
    }
}

#[test]
fn a_line_takes_its_level_from_its_own_direction() {
    // 4 texels a pixel along the line: lambda = 2; equation 3.18 in place of the derivatives across a plane.
    let mut cx = Context::new(SIZE, SIZE);
    named_levels(&mut cx);
    cx.begin(GL_LINES);
    for x in [-1.0f32, 1.0] {
        cx.tex_coord2f(x * 4.0, 0.5);
        cx.vertex2f(x, 0.01);
    }
    cx.end();
    let got = pixels(&mut cx, SIZE, SIZE);
    let line: Vec<_> = got.iter().filter(|p| **p != [0; 4]).collect();
    assert!(line.len() >= 63, "{}", line.len());
    assert!(line.iter().all(|p| p[0].abs_diff(50) <= 1), "{:?}", line[10]);
}

#[test]
fn lines_of_no_length_and_points_of_no_place() {
    let mut cx = Context::new(SIZE, SIZE);
    named_levels(&mut cx);
    for mode in [GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP] {
        for width in [1.0f32, 7.0] {
            cx.line_width(width);
            cx.point_size(width);
            cx.begin(mode);
            for p in [[0.1f32, 0.1, 1.0], [0.1, 0.1, 1.0], [f32::NAN, 0.0, 1.0], [0.3, 1e30, 0.0], [0.1, 0.1, -1.0]] {
                cx.tex_coord2f(p[0], f32::INFINITY);
                cx.vertex4f(p[0], p[1], 0.0, p[2]);
            }
            cx.end();
        }
    }
    no_error(&mut cx);
    assert_eq!(pixels(&mut cx, SIZE, SIZE).len(), 4096);
}
