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
fn a_point_has_the_level_of_rho_1() {
    // rho is 1 for points (section 3.8.8), so lambda is the bias.
    for (bias, want) in [(0.0, 10), (-2.0, 10), (0.5, 20), (1.0, 30), (1.25, 35), (3.0, 70), (9.0, 110)] {
        for (size, q) in [(1.0, 1.0f32), (5.0, 1.0), (5.0, 4.0), (40.0, -0.5)] {
            let mut cx = Context::new(SIZE, SIZE);
            named_levels(&mut cx);
            cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, bias);
            cx.point_size(size);
            cx.begin(GL_POINTS);
            cx.tex_coord4f(0.3 * q, 0.7 * q, 0.0, q);
            cx.vertex2f(0.1, 0.1);
            cx.end();
            let got = pixels(&mut cx, SIZE, SIZE);
            let points: Vec<_> = got.iter().filter(|p| **p != [0; 4]).collect();
            assert_eq!(points.len(), (size * size) as usize);
            let right = points.iter().all(|p| i16::from(p[0]).abs_diff(want) <= 1);
            assert!(right, "bias {bias}, size {size}, q {q}: {:?}", points[0]);
        }
    }
}

#[test]
fn a_point_reads_the_same_texel_everywhere_whatever_the_size_of_the_texture() {
    for texels in [1i32, 2, 3, 5, 16, 100] {
        let data: Vec<[u8; 4]> = (0..texels).map(|i| [i as u8 + 1; 4]).collect();
        let mut cx = Context::new(SIZE, SIZE);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, texels, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &data);
        // The filters differ: rho is 1, lambda 0, which is magnified (section 3.8.8).
        cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        cx.enable(GL_TEXTURE_2D);
        cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        cx.point_size(30.0);
        for i in 0..texels {
            cx.clear(GL_COLOR_BUFFER_BIT);
            cx.begin(GL_POINTS);
            cx.tex_coord2f((i as f32 + 0.25) / texels as f32, 0.5);
            cx.vertex2f(0.0, 0.0);
            cx.end();
            let got = pixels(&mut cx, SIZE, SIZE);
            let right = got.iter().filter(|p| **p == [i as u8 + 1; 4]).count();
            assert_eq!(right, 900, "texel {i} of {texels}: {:?}", got[32 * 64 + 32]);
        }
    }
}

#[test]
fn fragments_across_a_wide_line_are_copies_of_the_lowest() {
    // Section 3.4.2: the segment is moved down by (w - 1) / 2 in the minor direction, and each of its fragments replicated.
    let mut r = Random(25);
    let (mut seen, mut worst, mut deepest) = (0, 0.0f64, 0.0f64);
    for width in [2i64, 3, 7, 16] {
        for _ in 0..25 {
            let (a, b) = (end(&mut r), end(&mut r));
            let (da, db) = (r.range(-1.0, 1.0), r.range(-1.0, 1.0));
            let mut cx = Context::new(SIZE, SIZE);
            cx.enable(GL_DEPTH_TEST);
            cx.clear_color(0.0, 0.0, 0.0, 0.0);
            cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            cx.depth_func(GL_ALWAYS);
            cx.line_width(width as f32);
            cx.begin(GL_LINES);
            for (e, z) in [(&a, da), (&b, db)] {
                let [x, y] = e.at.map(|v| v / 32.0 - 1.0);
                cx.color4d(e.color[0], e.color[1], e.color[2], 1.0);
                cx.vertex4d(x * e.w, y * e.w, z * e.w, e.w);
            }
            cx.end();
            let (got, depth) = (pixels(&mut cx, SIZE, SIZE), cx.depths());
            let d = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
            let (minor, down) = (usize::from(d[0].abs() >= d[1].abs()), (width - 1) as f64 / 2.0);
            let moved = |mut p: [f64; 2]| {
                p[minor] -= down;
                p
            };
            let (pa, pb) = (moved(a.at), moved(b.at));
            for low in lines::line(pa.map(snap), pb.map(snap)) {
                // A wide line is clipped as the line in its middle is.
                if !(0..64).contains(&(low[minor] + (width - 1) / 2)) {
                    continue;
                }
                let t = lines::parameter(pa, pb, low.map(|v| v as f64 + 0.5)).clamp(0.0, 1.0);
                let (wa, wb) = ((1.0 - t) / a.w, t / b.w);
                for across in 0..width {
                    let mut p = low;
                    p[minor] += across;
                    if p.iter().any(|v| !(0..64).contains(v)) {
                        continue;
                    }
                    let at = (p[1] * 64 + p[0]) as usize;
                    for k in 0..3 {
                        let want = 255.0 * (a.color[k] * wa + b.color[k] * wb) / (wa + wb);
                        worst = worst.max((f64::from(got[at][k]) - want).abs());
                    }
                    let z = (da + (db - da) * t) * 0.5 + 0.5;
                    deepest = deepest.max((depth[at] - z).abs() * f64::from(1 << 24));
                    seen += 1;
                }
            }
        }
    }
    eprintln!("wide lines: {seen} fragments, worst colour {worst:.3} LSB, worst depth {deepest:.2} steps of 24 bits");
    assert!(seen > 10_000 && worst < 1.0 && deepest < 1.0, "{seen} {worst} {deepest}");
}

/// A stipple of one fragment on, one off, as the columns of the window that it leaves on in the middle row.
fn stippled(draw: impl FnOnce(&mut Context)) -> Vec<usize> {
    let mut cx = Context::new(SIZE, SIZE);
    cx.enable(GL_LINE_STIPPLE);
    cx.line_stipple(1, 0x00FF);
    draw(&mut cx);
    let got = pixels(&mut cx, SIZE, SIZE);
    (0..64).filter(|x| got[32 * 64 + x][0] > 0).collect()
}

/// A vertex in the row 32, a little below its middle, where the start of a line is not in the diamond of the pixel before.
fn middle(cx: &mut Context, x: f64) {
    cx.vertex2d(x / 32.0 - 1.0, 1.0 / 128.0);
}

#[test]
fn begin_starts_the_stipple_anew_also_where_its_first_segments_are_not_seen() {
    // The last segment comes from the left and enters the window at column 0. The first is beyond one side, or beyond a corner,
    // which only clipping finds out.
    for (first, second) in [([-5.0, 3.0], -2.0), ([-0.9, 5.0], -8.0)] {
        for mode in [GL_LINE_STRIP, GL_LINE_LOOP] {
            let got = stippled(|cx| {
                // Leaves the counter at 3.
                cx.begin(GL_LINE_STRIP);
                cx.vertex2d(-0.9, -0.5);
                cx.vertex2d(-0.9 + 3.0 / 32.0, -0.5);
                cx.end();
                cx.begin(mode);
                cx.vertex2dv(&first);
                cx.vertex2d(second, 1.0 / 128.0);
                middle(cx, 64.0);
                cx.end();
            });
            // Where a loop closes it may touch the row once more.
            let got: Vec<usize> = got.into_iter().filter(|x| *x < 56).collect();
            assert_eq!(
                got,
                (0..8).chain(16..24).chain(32..40).chain(48..56).collect::<Vec<_>>(),
                "{mode:#x} {first:?}"
            );
        }
    }
}

#[test]
fn the_stipple_counts_what_clipping_leaves_and_goes_on_through_the_scissor() {
    // From x = -16: the line enters the window at 0, where the counter is 0.
    let got = stippled(|cx| {
        cx.begin(GL_LINES);
        middle(cx, -16.0);
        middle(cx, 64.0);
        cx.end();
    });
    assert_eq!(got, (0..8).chain(16..24).chain(32..40).chain(48..56).collect::<Vec<_>>());
    // Fragments outside the scissor are produced and count.
    let got = stippled(|cx| {
        cx.enable(GL_SCISSOR_TEST);
        cx.scissor(20, 0, 30, 64);
        cx.begin(GL_LINES);
        middle(cx, 0.0);
        middle(cx, 64.0);
        cx.end();
    });
    assert_eq!(got, (20..24).chain(32..40).chain(48..50).collect::<Vec<_>>());
}

#[test]
fn the_stipple_runs_on_around_polygons_in_mode_line() {
    // Corners of squares on pixel centres: each edge has 16 fragments, and the pattern 10 on, 10 off shows where the counter is.
    let outline = |mode: GLenum, corners: &[[i32; 2]]| {
        let mut cx = Context::new(SIZE, SIZE);
        cx.enable(GL_LINE_STIPPLE);
        cx.line_stipple(5, 0x3333);
        cx.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
        cx.begin(mode);
        for [x, y] in corners {
            cx.vertex2d((f64::from(*x) + 0.5) / 32.0 - 1.0, (f64::from(*y) + 0.5) / 32.0 - 1.0);
        }
        cx.end();
        pixels(&mut cx, SIZE, SIZE).iter().map(|p| p[0] > 0).collect::<Vec<_>>()
    };
    // The fragments of the edges from corner to corner, in order.
    let along = |corners: &[[i32; 2]]| {
        let mut all = vec![];
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)).take(corners.len()) {
            let (mut p, step) = (*a, [0, 1].map(|k| (b[k] - a[k]).signum()));
            while p != *b {
                all.push(p);
                p = [p[0] + step[0], p[1] + step[1]];
            }
        }
        all
    };
    let square = [[10, 10], [26, 10], [26, 26], [10, 26]];
    for mode in [GL_QUADS, GL_POLYGON] {
        let got = outline(mode, &square);
        let all = along(&square);
        // The specification does not say with which edge of a quadrilateral the outline begins.
        let fits = |first: usize| {
            (0..all.len()).all(|i| {
                let [x, y] = all[(i + first) % all.len()];
                got[(y * 64 + x) as usize] == ((i / 5) % 4 < 2)
            })
        };
        assert!([0, 16, 32, 48].iter().any(|first| fits(*first)), "{mode:#x}");
    }
    // Each polygon resets the counter (section 3.5.4): the second one of a Begin looks as when it is alone.
    let other = square.map(|[x, y]| [x + 20, y + 20]);
    for mode in [GL_QUADS, GL_TRIANGLES] {
        let (a, b) = if mode == GL_QUADS { (&square[..], &other[..]) } else { (&square[..3], &other[..3]) };
        let (both, first, second) = (outline(mode, &[a, b].concat()), outline(mode, a), outline(mode, b));
        let union: Vec<bool> = first.iter().zip(&second).map(|(a, b)| a | b).collect();
        assert!(both == union && first.contains(&true), "{mode:#x}");
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
