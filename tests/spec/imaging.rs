//! The imaging subset (sections 3.6.3, 3.6.5, 6.1.7 to 6.1.10): tables, convolution, colour matrix, histogram and minmax,
//! against the formulas of the specification in f64. Images go in as floats and come out through a float texture or
//! queries, so that no rounding to bytes hides anything.

use crate::support::Random;
use fixedgl::Context;
use fixedgl::enums::*;

type Color = [f64; 4];

fn image(random: &mut Random, n: usize) -> Vec<[f32; 4]> {
    (0..n).map(|_| [(); 4].map(|()| random.range(0.0, 1.0) as f32)).collect()
}

fn wide(color: [f32; 4]) -> Color {
    color.map(f64::from)
}

/// What an image becomes on its way into a texture of 16 bits a component.
fn transferred(gl: &mut Context, size: [i32; 2], colors: &[[f32; 4]], out: [i32; 2]) -> Vec<[f32; 4]> {
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA16 as i32, size[0], size[1], 0, GL_RGBA, GL_FLOAT, colors);
    let mut got = vec![[0.0f32; 4]; (out[0] * out[1]) as usize];
    let mut width = [0; 4];
    gl.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &mut width);
    assert_eq!(width[0], out[0]);
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, &mut got);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    got
}

fn close(got: &[[f32; 4]], want: &[Color], what: &str) {
    assert_eq!(got.len(), want.len(), "{what}");
    for (i, (got, want)) in got.iter().zip(want).enumerate() {
        for c in 0..4 {
            let want = want[c].clamp(0.0, 1.0);
            assert!((f64::from(got[c]) - want).abs() < 2e-5, "{what}: group {i} component {c}: {} {want}", got[c]);
        }
    }
}

/// Which components a base format has.
fn components(format: GLenum) -> [bool; 4] {
    match format {
        GL_ALPHA => [false, false, false, true],
        GL_LUMINANCE | GL_RGB => [true, true, true, false],
        _ => [true; 4],
    }
}

/// A colour as a table or filter of a base format keeps it.
fn kept(format: GLenum, [r, g, b, a]: Color) -> Color {
    match format {
        GL_LUMINANCE | GL_LUMINANCE_ALPHA => [r, r, r, a],
        GL_INTENSITY => [r; 4],
        _ => [r, g, b, a],
    }
}

const FORMATS: [GLenum; 6] = [GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA];

#[test]
fn colour_tables_replace_the_components_that_they_have() {
    let mut random = Random(31);
    for format in FORMATS {
        for width in [1, 2, 16, 256] {
            let mut gl = Context::new(8, 8);
            let (table, colors) = (image(&mut random, width), image(&mut random, 12));
            gl.color_table_parameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_SCALE, &[0.5, 1.0, 2.0, 0.75]);
            gl.color_table_parameterfv(GL_COLOR_TABLE, GL_COLOR_TABLE_BIAS, &[0.25, 0.0, -0.5, 0.1]);
            gl.color_table(GL_COLOR_TABLE, format, width as i32, GL_RGBA, GL_FLOAT, &table);
            gl.enable(GL_COLOR_TABLE);
            let got = transferred(&mut gl, [4, 3], &colors, [4, 3]);
            let entry = |i: usize| {
                let (scale, bias) = ([0.5, 1.0, 2.0, 0.75], [0.25, 0.0, -0.5, 0.1]);
                let c = wide(table[i]);
                kept(format, std::array::from_fn(|k| (c[k] * scale[k] + bias[k]).clamp(0.0, 1.0)))
            };
            let want: Vec<Color> = colors
                .iter()
                .map(|color| {
                    let color = wide(*color);
                    std::array::from_fn(|c| {
                        let i = (color[c] * (width - 1) as f64).round_ties_even() as usize;
                        if components(format)[c] { entry(i)[c] } else { color[c] }
                    })
                })
                .collect();
            // A format of 8 bits would round; these keep what the implementation keeps of a format without a size.
            for (i, (got, want)) in got.iter().zip(&want).enumerate() {
                for c in 0..4 {
                    assert!((f64::from(got[c]) - want[c]).abs() < 0.002, "{format:#X} {width}: {i} {c}");
                }
            }
        }
    }
}

/// Section 3.6.5: the sum over the filter, per border mode.
fn convolved(
    colors: &[[f32; 4]],
    [w, h]: [i32; 2],
    filter: &[Color],
    [fw, fh]: [i32; 2],
    mode: GLenum,
    border: Color,
    format: GLenum,
) -> (Vec<Color>, [i32; 2]) {
    let reduce = mode == GL_REDUCE;
    let size = if reduce { [w - fw + 1, h - fh + 1] } else { [w, h] };
    let (mx, my) = (fw / 2, fh / 2);
    let source = |x: i32, y: i32| {
        if (0..w).contains(&x) && (0..h).contains(&y) {
            wide(colors[(y * w + x) as usize])
        } else if mode == GL_REPLICATE_BORDER {
            wide(colors[(y.clamp(0, h - 1) * w + x.clamp(0, w - 1)) as usize])
        } else {
            border
        }
    };
    let mut out = Vec::new();
    for y in 0..size[1] {
        for x in 0..size[0] {
            let (x, y) = if reduce { (x, y) } else { (x - mx, y - my) };
            let mut sum = [0.0; 4];
            for m in 0..fh {
                for n in 0..fw {
                    for c in 0..4 {
                        sum[c] += source(x + n, y + m)[c] * kept(format, filter[(m * fw + n) as usize])[c];
                    }
                }
            }
            let middle = source(x + mx, y + my);
            out.push(std::array::from_fn(|c| if components(format)[c] { sum[c] } else { middle[c] }));
        }
    }
    (out, size)
}

#[test]
fn convolution_is_the_sum_over_the_filter_in_every_border_mode() {
    let mut random = Random(32);
    for format in FORMATS {
        for mode in [GL_REDUCE, GL_CONSTANT_BORDER, GL_REPLICATE_BORDER] {
            for [fw, fh] in [[1, 1], [3, 3], [2, 5], [5, 2]] {
                let mut gl = Context::new(8, 8);
                let (size, border) = ([9, 7], [0.1, 0.2, 0.3, 0.4]);
                let colors = image(&mut random, 63);
                let filter: Vec<[f32; 4]> = image(&mut random, (fw * fh) as usize)
                    .iter()
                    .map(|c| c.map(|v| (v - 0.25) / (fw * fh) as f32))
                    .collect();
                gl.convolution_filter_2d(GL_CONVOLUTION_2D, format, fw, fh, GL_RGBA, GL_FLOAT, &filter);
                gl.convolution_parameteri(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_MODE, mode as i32);
                gl.convolution_parameterfv(GL_CONVOLUTION_2D, GL_CONVOLUTION_BORDER_COLOR, &border.map(|v| v as f32));
                gl.enable(GL_CONVOLUTION_2D);
                // Numbers below 0 would be cut off: they are lifted, and so compared as well.
                for pname in [GL_POST_CONVOLUTION_RED_BIAS, GL_POST_CONVOLUTION_BLUE_BIAS] {
                    gl.pixel_transferf(pname, 0.25);
                }
                gl.pixel_transferf(GL_POST_CONVOLUTION_GREEN_SCALE, 0.5);
                let filter: Vec<Color> = filter.iter().map(|c| wide(*c)).collect();
                let border = border.map(|v: f64| f64::from(v as f32));
                let (mut want, out) = convolved(&colors, size, &filter, [fw, fh], mode, border, format);
                want.iter_mut().for_each(|c| *c = [c[0] + 0.25, c[1] * 0.5, c[2] + 0.25, c[3]]);
                let got = transferred(&mut gl, size, &colors, out);
                close(&got, &want, &format!("{format:#X} {mode:#X} {fw} x {fh}"));
            }
        }
    }
}

#[test]
fn separable_filters_are_products_and_one_dimensional_ones_serve_rows() {
    let mut random = Random(33);
    let (row, column, colors) = (image(&mut random, 3), image(&mut random, 5), image(&mut random, 80));
    let product: Vec<Color> = column
        .iter()
        .flat_map(|b| {
            row.iter().map(|a| std::array::from_fn(|c| f64::from(a[c]) * f64::from(b[c]))).collect::<Vec<_>>()
        })
        .collect();
    let mut gl = Context::new(8, 8);
    gl.separable_filter_2d(GL_SEPARABLE_2D, GL_RGBA, 3, 5, GL_RGBA, GL_FLOAT, &row, &column);
    gl.enable(GL_SEPARABLE_2D);
    for (pname, value) in [
        (GL_POST_CONVOLUTION_RED_SCALE, 0.1),
        (GL_POST_CONVOLUTION_GREEN_SCALE, 0.1),
        (GL_POST_CONVOLUTION_BLUE_SCALE, 0.1),
        (GL_POST_CONVOLUTION_ALPHA_SCALE, 0.1),
    ] {
        gl.pixel_transferf(pname, value);
    }
    let (mut want, out) = convolved(&colors, [10, 8], &product, [3, 5], GL_REDUCE, [0.0; 4], GL_RGBA);
    want.iter_mut().for_each(|c| *c = c.map(|v| v * f64::from(0.1f32)));
    let got = transferred(&mut gl, [10, 8], &colors, out);
    close(&got, &want, "separable");
    // Back as they were given.
    let (mut a, mut b) = ([[0.0f32; 4]; 3], [[0.0f32; 4]; 5]);
    gl.get_separable_filter(GL_SEPARABLE_2D, GL_RGBA, GL_FLOAT, &mut a, &mut b, fixedgl::NULL);
    assert_eq!((&a[..], &b[..]), (&row[..], &column[..]));
    // One dimension: a row of a 1D texture.
    let mut gl = Context::new(8, 8);
    let weights = row.iter().map(|c| c.map(|v| v / 3.0)).collect::<Vec<_>>();
    gl.convolution_filter_1d(GL_CONVOLUTION_1D, GL_RGBA, 3, GL_RGBA, GL_FLOAT, &weights);
    gl.enable(GL_CONVOLUTION_1D);
    gl.tex_image_1d(GL_TEXTURE_1D, 0, GL_RGBA16 as i32, 10, 0, GL_RGBA, GL_FLOAT, &colors[..10]);
    let mut got = [[0.0f32; 4]; 8];
    gl.get_tex_image(GL_TEXTURE_1D, 0, GL_RGBA, GL_FLOAT, &mut got);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    let weights: Vec<Color> = weights.iter().map(|c| wide(*c)).collect();
    let (want, _) = convolved(&colors[..10], [10, 1], &weights, [3, 1], GL_REDUCE, [0.0; 4], GL_RGBA);
    close(&got, &want, "1D");
    // It is no filter of 2D images.
    let all: Vec<Color> = colors.iter().map(|c| wide(*c)).collect();
    close(&transferred(&mut gl, [10, 8], &colors, [10, 8]), &all, "2D images are left alone");
}

#[test]
fn the_colour_matrix_multiplies_and_the_last_table_follows() {
    let mut random = Random(34);
    let colors = image(&mut random, 16);
    let mut gl = Context::new(8, 8);
    let m: [f64; 16] =
        std::array::from_fn(|i| [0.5, 0.1, 0.0, 0.2, 0.3, 0.4, 0.1, 0.0, 0.0, 0.25, 0.5, 0.0, 0.1, 0.0, 0.2, 0.7][i]);
    gl.matrix_mode(GL_COLOR);
    gl.load_matrixd(&m);
    gl.matrix_mode(GL_MODELVIEW);
    gl.pixel_transferf(GL_POST_COLOR_MATRIX_RED_SCALE, 0.5);
    gl.pixel_transferf(GL_POST_COLOR_MATRIX_ALPHA_BIAS, 0.125);
    let got = transferred(&mut gl, [4, 4], &colors, [4, 4]);
    let want: Vec<Color> = colors
        .iter()
        .map(|color| {
            let c = wide(*color);
            let mut out: Color = std::array::from_fn(|k| (0..4).map(|j| m[4 * j + k] * c[j]).sum());
            out[0] *= 0.5;
            out[3] += 0.125;
            out
        })
        .collect();
    close(&got, &want, "matrix");
    // An inverting table after it.
    gl.color_table(GL_POST_COLOR_MATRIX_COLOR_TABLE, GL_RGB, 2, GL_RGB, GL_FLOAT, &[[1.0f32; 3], [0.0; 3]]);
    gl.enable(GL_POST_COLOR_MATRIX_COLOR_TABLE);
    let got = transferred(&mut gl, [4, 4], &colors, [4, 4]);
    let inverted: Vec<Color> = want
        .iter()
        .map(|c| {
            std::array::from_fn(|k| {
                if k == 3 {
                    c[3]
                } else if c[k].clamp(0.0, 1.0) <= 0.5 {
                    1.0
                } else {
                    0.0
                }
            })
        })
        .collect();
    close(&got, &inverted, "table");
}

#[test]
fn histogram_and_minmax_count_what_passes_and_sinks_keep_it() {
    let mut random = Random(35);
    let colors = image(&mut random, 300);
    let mut gl = Context::new(40, 40);
    gl.histogram(GL_HISTOGRAM, 16, GL_RGBA, false);
    gl.minmax(GL_MINMAX, GL_RGBA, false);
    gl.enable(GL_HISTOGRAM);
    gl.enable(GL_MINMAX);
    gl.draw_pixels(20, 15, GL_RGBA, GL_FLOAT, &colors);
    let mut want = [[0u32; 4]; 16];
    for color in &colors {
        for c in 0..4 {
            want[(f64::from(color[c]) * 15.0).round_ties_even() as usize][c] += 1;
        }
    }
    let mut got = [[0u32; 4]; 16];
    gl.get_histogram(GL_HISTOGRAM, true, GL_RGBA, GL_UNSIGNED_INT, &mut got);
    assert_eq!(got, want);
    gl.get_histogram(GL_HISTOGRAM, false, GL_RGBA, GL_UNSIGNED_INT, &mut got);
    assert_eq!(got, [[0; 4]; 16], "it was reset");
    let range = |pick: fn(f32, f32) -> f32| -> [f32; 4] {
        std::array::from_fn(|c| colors.iter().map(|color| color[c]).reduce(pick).expect("there are colours"))
    };
    let mut got = [[0.0f32; 4]; 2];
    gl.get_minmax(GL_MINMAX, false, GL_RGBA, GL_FLOAT, &mut got);
    assert_eq!(got, [range(f32::min), range(f32::max)]);
    gl.reset_minmax(GL_MINMAX);
    gl.get_minmax(GL_MINMAX, false, GL_RGBA, GL_FLOAT, &mut got);
    assert_eq!(got, [[f32::MAX; 4], [-f32::MAX; 4]]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    // The picture is drawn; with a sink it is not.
    assert!(gl.pixels().iter().any(|v| *v != 0));
    let mut gl = Context::new(40, 40);
    gl.histogram(GL_HISTOGRAM, 256, GL_LUMINANCE, true);
    gl.enable(GL_HISTOGRAM);
    gl.draw_pixels(20, 15, GL_RGBA, GL_FLOAT, &colors);
    assert!(gl.pixels().iter().all(|v| *v == 0));
    let mut counts = [0u16; 256];
    gl.get_histogram(GL_HISTOGRAM, false, GL_LUMINANCE, GL_UNSIGNED_SHORT, &mut counts);
    assert_eq!(counts.iter().map(|n| u32::from(*n)).sum::<u32>(), 300);
}

#[test]
fn pixels_that_are_read_and_copied_go_through_it_too() {
    let mut gl = Context::new(8, 8);
    gl.clear_color(1.0, 0.0, 0.5, 1.0);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl.color_table(GL_COLOR_TABLE, GL_RGB, 2, GL_RGB, GL_FLOAT, &[[1.0f32, 1.0, 1.0], [0.0, 0.0, 0.0]]);
    gl.enable(GL_COLOR_TABLE);
    let mut got = [[0u8; 4]; 64];
    gl.read_pixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, &mut got);
    // 128 / 255 rounds to entry 1.
    assert_eq!(got, [[0, 255, 0, 255]; 64]);
    gl.raster_pos2f(-1.0, -1.0);
    gl.copy_pixels(0, 0, 4, 4, GL_COLOR);
    gl.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 8, 8, 0);
    gl.disable(GL_COLOR_TABLE);
    gl.read_pixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, &mut got);
    let mut texels = [[0u8; 4]; 64];
    gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut texels);
    for i in 0..64 {
        let copied = i % 8 < 4 && i / 8 < 4;
        assert_eq!(got[i], if copied { [0, 255, 0, 255] } else { [255, 0, 128, 255] }, "pixel {i}");
        assert_eq!(texels[i], if copied { [255, 0, 255, 255] } else { [0, 255, 0, 255] }, "texel {i}");
    }
    assert_eq!(gl.get_error(), GL_NO_ERROR);
}

#[test]
fn errors_limits_and_proxies_are_the_specifications() {
    type Call = fn(&mut Context);
    const TOO_LARGE: GLenum = 0x8031;
    let rows: [(&str, Call, GLenum); 14] = [
        ("no table", |gl| gl.color_table(GL_TEXTURE_2D, GL_RGBA, 2, GL_RGBA, GL_FLOAT, &[0.0f32; 8]), GL_INVALID_ENUM),
        (
            "no format",
            |gl| gl.color_table(GL_COLOR_TABLE, GL_DEPTH_COMPONENT, 2, GL_RGBA, GL_FLOAT, &[0.0f32; 8]),
            GL_INVALID_ENUM,
        ),
        (
            "no power of two",
            |gl| gl.color_table(GL_COLOR_TABLE, GL_RGBA, 3, GL_RGBA, GL_FLOAT, &[0.0f32; 12]),
            GL_INVALID_VALUE,
        ),
        (
            "negative",
            |gl| gl.color_table(GL_COLOR_TABLE, GL_RGBA, -1, GL_RGBA, GL_FLOAT, &[0.0f32; 12]),
            GL_INVALID_VALUE,
        ),
        ("large copy", |gl| gl.copy_color_table(GL_COLOR_TABLE, GL_RGBA, 0, 0, 1 << 24), TOO_LARGE),
        ("part", |gl| gl.color_sub_table(GL_COLOR_TABLE, 1, 1, GL_RGBA, GL_FLOAT, &[0.0f32; 4]), GL_INVALID_VALUE),
        (
            "filter target",
            |gl| gl.convolution_filter_2d(GL_CONVOLUTION_1D, GL_RGBA, 1, 1, GL_RGBA, GL_FLOAT, &[0.0f32; 4]),
            GL_INVALID_ENUM,
        ),
        (
            "large filter",
            |gl| gl.convolution_filter_1d(GL_CONVOLUTION_1D, GL_RGBA, 99, GL_RGBA, GL_FLOAT, &[0.0f32; 400]),
            GL_INVALID_VALUE,
        ),
        (
            "border mode",
            |gl| gl.convolution_parameteri(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_MODE, GL_LINEAR as i32),
            GL_INVALID_ENUM,
        ),
        (
            "scalar colour",
            |gl| gl.convolution_parameterf(GL_CONVOLUTION_1D, GL_CONVOLUTION_BORDER_COLOR, 1.0),
            GL_INVALID_ENUM,
        ),
        ("histogram", |gl| gl.histogram(GL_MINMAX, 4, GL_RGBA, false), GL_INVALID_ENUM),
        ("intensity", |gl| gl.histogram(GL_HISTOGRAM, 4, GL_INTENSITY, false), GL_INVALID_ENUM),
        ("large histogram", |gl| gl.histogram(GL_HISTOGRAM, 1 << 24, GL_RGBA, false), TOO_LARGE),
        ("minmax", |gl| gl.minmax(GL_HISTOGRAM, GL_RGBA, false), GL_INVALID_ENUM),
    ];
    for (name, call, want) in rows {
        let mut gl = Context::new(4, 4);
        call(&mut gl);
        assert_eq!(gl.get_error(), want, "{name}");
    }
    let mut gl = Context::new(4, 4);
    let mut value = [0; 4];
    for (width, want) in [(256, 256), (1 << 24, 0)] {
        gl.color_table(GL_PROXY_COLOR_TABLE, GL_RGBA8, width, GL_RGBA, GL_FLOAT, fixedgl::NULL);
        gl.get_color_table_parameteriv(GL_PROXY_COLOR_TABLE, GL_COLOR_TABLE_WIDTH, &mut value);
        assert_eq!(value[0], want);
        gl.histogram(GL_PROXY_HISTOGRAM, width, GL_RGBA, false);
        gl.get_histogram_parameteriv(GL_PROXY_HISTOGRAM, GL_HISTOGRAM_WIDTH, &mut value);
        assert_eq!(value[0], want);
    }
    gl.get_convolution_parameteriv(GL_CONVOLUTION_2D, GL_MAX_CONVOLUTION_WIDTH, &mut value);
    assert!(value[0] >= 3);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    // The attribute stack keeps what is on, scales and borders.
    gl.push_attrib(GL_PIXEL_MODE_BIT);
    gl.enable(GL_CONVOLUTION_2D);
    gl.pixel_transferf(GL_POST_CONVOLUTION_RED_SCALE, 3.0);
    gl.pop_attrib();
    assert!(!gl.is_enabled(GL_CONVOLUTION_2D));
    let mut scale = [0.0f32; 4];
    gl.get_floatv(GL_POST_CONVOLUTION_RED_SCALE, &mut scale);
    assert_eq!(scale[0], 1.0);
}
