//! Tests of whole samplers: every wrap mode, filter and target, with exact values where they can be had and properties
//! (finite, in range, constant stays constant, one lane does not change another) where they cannot.

use super::support::*;
use crate::enums::*;
use crate::simd::Level;
use crate::state::texture::Target;
use crate::state::texture::TextureFilter;
use crate::state::texture::WrapMode;
use crate::texture::sampler::Sampler;

const WRAPS: [WrapMode; 8] = WrapMode::ALL;

const FILTERS: [(TextureFilter, TextureFilter); 12] = [
    (TextureFilter::Nearest, TextureFilter::Nearest),
    (TextureFilter::Linear, TextureFilter::Linear),
    (TextureFilter::Nearest, TextureFilter::Linear),
    (TextureFilter::Linear, TextureFilter::Nearest),
    (TextureFilter::NearestMipmapNearest, TextureFilter::Nearest),
    (TextureFilter::NearestMipmapNearest, TextureFilter::Linear),
    (TextureFilter::LinearMipmapNearest, TextureFilter::Linear),
    (TextureFilter::LinearMipmapNearest, TextureFilter::Nearest),
    (TextureFilter::NearestMipmapLinear, TextureFilter::Nearest),
    (TextureFilter::NearestMipmapLinear, TextureFilter::Linear),
    (TextureFilter::LinearMipmapLinear, TextureFilter::Linear),
    (TextureFilter::LinearMipmapLinear, TextureFilter::Nearest),
];

/// Coordinates that have broken samplers before, and infinities and NaN.
fn awkward() -> Vec<f32> {
    let mut s = vec![0.0, 1e-45, 1e-38, 1e-8, 0.25, 0.5, 0.75, 1.0, 1.0 + 1e-7, 1.5, 2.0, 1e3, 1e6, 4194304.5];
    s.extend([8388607.5, 16777216.0, 1e9, 2.5e9, 1e20, 1e30, 1e38, f32::MAX, f32::INFINITY, f32::NAN]);
    s.iter().flat_map(|&s| [s, -s]).collect()
}

#[test]
fn a_constant_texture_stays_constant_whatever_the_coordinate() {
    let s = awkward();
    let mut points = Vec::new();
    for (i, &a) in s.iter().enumerate() {
        let b = s[(i * 7 + 3) % s.len()];
        points.push(SamplePoint { at: [a, b, a], dx: [b, a, 0.1], dy: [0.3, 0.01, b] });
        points.push(SamplePoint { at: [a, 0.3, b], dx: [0.3, 1e-3, 0.0], dy: [0.001, 0.02, 0.0] });
    }
    for target in [Target::D1, Target::D2, Target::D3, Target::Cube] {
        for wrap in WRAPS {
            for (min, mag) in FILTERS {
                for aniso in [1.0, 5.0] {
                    let mut o = object(target, GL_RGBA8, [8, 8, 8], 4, |_, _, _| [200.0 / 255.0; 4]);
                    o.parameters.border_color = [200.0 / 255.0; 4];
                    o.parameters.wrap = [wrap; 3];
                    (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
                    o.parameters.max_anisotropy = aniso;
                    let want = (200.0 * crate::texture::filter::INV_255).to_bits();
                    for (p, color) in points.iter().zip(sample(&o, &points)) {
                        assert_eq!(color.map(f32::to_bits), [want; 4], "{target:?} {wrap:?} {min:?} {mag:?} {p:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_sampled_lies_within_the_texels() {
    let points: Vec<SamplePoint> = (0..4000)
        .map(|i| {
            let x = i as f32;
            SamplePoint {
                at: [x * 0.0137 - 20.0, x * 0.0071 - 9.0, x * 0.003],
                dx: [x * 1e-4, 0.02, 0.0],
                dy: [0.01; 3],
            }
        })
        .collect();
    for (size, levels) in [([5, 3, 2], 3), ([8, 8, 8], 4), ([1, 1, 1], 1), ([1, 7, 1], 3)] {
        for target in [Target::D1, Target::D2, Target::D3] {
            for wrap in WRAPS {
                for (min, mag) in [
                    (TextureFilter::Linear, TextureFilter::Linear),
                    (TextureFilter::LinearMipmapLinear, TextureFilter::Nearest),
                ] {
                    let mut o = object(target, GL_RGBA8, size, levels, |_, l, [i, j, k]| {
                        grey(60 + (i * 37 + j * 71 + k * 11 + l as i32 * 5) % 100)
                    });
                    o.parameters.border_color = grey(60);
                    o.parameters.wrap = [wrap; 3];
                    (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
                    for (p, color) in points.iter().zip(sample(&o, &points)) {
                        let v = color[0] * 255.0;
                        assert!((59.9999..159.0001).contains(&v), "{target:?} {size:?} {wrap:?} {p:?}: {v}");
                    }
                }
            }
        }
    }
}

/// Texel i of a row is 10 i; the border 200.
fn row(n: u32, wrap: WrapMode, filter: TextureFilter) -> crate::texture::object::TextureObject {
    let mut o = object(Target::D1, GL_LUMINANCE8, [n, 1, 1], 1, |_, _, [i, ..]| grey(10 * i));
    o.parameters.border_color = grey(200);
    o.parameters.wrap = [wrap; 3];
    (o.parameters.min_filter, o.parameters.mag_filter) = (filter, filter);
    o
}

#[test]
fn nearest_reads_the_texel_that_each_wrap_says() {
    // Texel of eight for each coordinate; 20 stands for the border.
    let table: [(f32, [i32; 8]); 15] = [
        //        REPEAT CLAMP EDGE BORDER MIRRORED MIRROR_CLAMP .._EDGE .._BORDER
        (0.0, [0, 0, 0, 0, 0, 0, 0, 0]),
        (-0.0, [0, 0, 0, 0, 0, 0, 0, 0]),
        (0.125, [1, 1, 1, 1, 1, 1, 1, 1]),
        (0.5, [4, 4, 4, 4, 4, 4, 4, 4]),
        (0.99, [7, 7, 7, 7, 7, 7, 7, 7]),
        (1.0, [0, 7, 7, 20, 7, 7, 7, 20]),
        (1.01, [0, 7, 7, 20, 7, 7, 7, 20]),
        (1.3, [2, 7, 7, 20, 5, 7, 7, 20]),
        (2.3, [2, 7, 7, 20, 2, 7, 7, 20]),
        (-1e-8, [7, 0, 0, 20, 0, 0, 0, 0]),
        (-0.01, [7, 0, 0, 20, 0, 0, 0, 0]),
        (-0.3, [5, 0, 0, 20, 2, 2, 2, 2]),
        (-1.3, [5, 0, 0, 20, 5, 7, 7, 20]),
        (1e9, [0, 7, 7, 20, 0, 7, 7, 20]),
        (-1e9, [0, 0, 0, 20, 0, 7, 7, 20]),
    ];
    for (s, texels) in table {
        for (wrap, texel) in WRAPS.into_iter().zip(texels) {
            assert_eq!(
                red(&row(8, wrap, TextureFilter::Nearest), at(s, 0.0, 0.0)),
                10.0 * texel as f32,
                "{wrap:?} s {s}"
            );
        }
    }
}

#[test]
fn linear_blends_the_texels_that_each_wrap_says() {
    // At the centre of texel i, and at the ends; what is beyond an end by wrap.
    for wrap in WRAPS {
        let o = row(8, wrap, TextureFilter::Linear);
        for i in 0..8 {
            assert_eq!(red(&o, at((i as f32 + 0.5) / 8.0, 0.0, 0.0)), 10.0 * i as f32, "{wrap:?}");
        }
        assert_eq!(red(&o, at(0.5, 0.0, 0.0)), 35.0);
        assert_eq!(red(&o, at(0.28125, 0.0, 0.0)), 17.5);
    }
    // s = 0, s = 1, s = -0.0625 (half a texel beyond), s = 1.0625.
    let table: [(WrapMode, [f32; 4]); 8] = [
        (WrapMode::Repeat, [35.0, 35.0, 70.0, 0.0]),
        (WrapMode::Clamp, [100.0, 135.0, 100.0, 135.0]),
        (WrapMode::ClampToEdge, [0.0, 70.0, 0.0, 70.0]),
        (WrapMode::ClampToBorder, [100.0, 135.0, 200.0, 200.0]),
        (WrapMode::MirroredRepeat, [0.0, 70.0, 0.0, 70.0]),
        (WrapMode::MirrorClamp, [0.0, 135.0, 0.0, 135.0]),
        (WrapMode::MirrorClampToEdge, [0.0, 70.0, 0.0, 70.0]),
        (WrapMode::MirrorClampToBorder, [0.0, 135.0, 0.0, 200.0]),
    ];
    for (wrap, values) in table {
        for (s, want) in [0.0, 1.0, -0.0625, 1.0625].into_iter().zip(values) {
            assert_eq!(red(&row(8, wrap, TextureFilter::Linear), at(s, 0.0, 0.0)), want, "{wrap:?} s {s}");
        }
    }
}

#[test]
fn huge_coordinates_repeat_as_the_exact_rational_does() {
    let repeat = row(8, WrapMode::Repeat, TextureFilter::Nearest);
    let mirror = row(8, WrapMode::MirroredRepeat, TextureFilter::Nearest);
    let mut x = 0.37f32;
    for _ in 0..2000 {
        x = -x * 1.021;
        if x.abs() > 1e30 {
            break;
        }
        let s = f64::from(x);
        let texel = (s.rem_euclid(1.0) * 8.0).floor().min(7.0);
        let folded = s.rem_euclid(2.0);
        let mirrored = ((if folded < 1.0 { folded } else { 2.0 - folded }) * 8.0).floor().min(7.0);
        // A product that lies within rounding of a boundary may fall on either side.
        let near = |v: f64| (v * 8.0 - (v * 8.0).round()).abs() < 1e-6;
        if !near(s.rem_euclid(1.0)) {
            assert_eq!(f64::from(red(&repeat, at(x, 0.0, 0.0))), 10.0 * texel, "{x}");
            assert_eq!(f64::from(red(&mirror, at(x, 0.0, 0.0))), 10.0 * mirrored, "{x}");
        }
    }
    for x in [4194305.5f32, -4194305.5, 8388607.5, -8388607.5] {
        assert_eq!(red(&repeat, at(x, 0.0, 0.0)), 40.0, "{x}");
    }
}

#[test]
fn bilinear_and_3d_filters_weigh_by_distance() {
    let plane = |_: usize, _: usize, [i, j, k]: [i32; 3]| grey(10 * i + 40 * j + 100 * k);
    for format in [GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8] {
        let mut o = object(Target::D2, format, [4, 4, 1], 1, plane);
        o.parameters.wrap = [WrapMode::ClampToEdge; 3];
        (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::Linear, TextureFilter::Linear);
        assert_eq!(red(&o, at(0.5, 0.5, 0.0)), 15.0 + 60.0);
        assert_eq!(red(&o, at(0.1875, 0.4375, 0.0)), 2.5 + 50.0);
        let mut o = object(Target::D3, format, [4, 4, 2], 1, plane);
        o.parameters.wrap = [WrapMode::ClampToEdge; 3];
        (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::Linear, TextureFilter::Linear);
        assert_eq!(red(&o, at(0.5, 0.1875, 0.5)), 15.0 + 10.0 + 50.0);
        assert_eq!(red(&o, at(0.5, 0.1875, 0.375)), 15.0 + 10.0 + 25.0);
    }
}

#[test]
fn every_base_format_expands_in_every_filter() {
    let formats = [
        (GL_ALPHA8, [0.0, 0.0, 0.0, 0.8]),
        (GL_LUMINANCE8, [0.2, 0.2, 0.2, 1.0]),
        (GL_LUMINANCE8_ALPHA8, [0.2, 0.2, 0.2, 0.8]),
        (GL_INTENSITY8, [0.2; 4]),
        (GL_RGB8, [0.2, 0.4, 0.6, 1.0]),
        (GL_RGBA8, [0.2, 0.4, 0.6, 0.8]),
        (GL_RGBA16, [0.2, 0.4, 0.6, 0.8]),
        (GL_LUMINANCE16, [0.2, 0.2, 0.2, 1.0]),
    ];
    for (format, want) in formats {
        for target in [Target::D1, Target::D2, Target::D3] {
            for (min, mag) in FILTERS {
                let mut o = object(target, format, [4, 4, 4], 3, |_, _, _| [0.2, 0.4, 0.6, 0.8]);
                (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
                let p = with_lambda(at(0.3, 0.4, 0.6), 1.3, 4.0);
                let got = sample(&o, &[p])[0];
                for c in 0..4 {
                    assert!((got[c] - want[c]).abs() < 2e-7, "{format:x} {target:?} {min:?} {mag:?}: {got:?}");
                }
            }
        }
    }
}

/// Level l of an object is grey of 10 + 40 l, so that the colour tells the level.
fn levels(min: TextureFilter, mag: TextureFilter) -> crate::texture::object::TextureObject {
    let mut o = object(Target::D2, GL_LUMINANCE8, [32, 32, 1], 6, |_, l, _| grey(10 + 40 * l as i32));
    (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
    o
}

fn level_at(o: &crate::texture::object::TextureObject, lambda: f64) -> f32 {
    (red(o, with_lambda(at(0.51, 0.52, 0.0), lambda, 32.0)) - 10.0) / 40.0
}

#[test]
fn mipmap_nearest_takes_the_nearest_level_and_the_finer_of_two() {
    for (min, mag) in [
        (TextureFilter::NearestMipmapNearest, TextureFilter::Nearest),
        (TextureFilter::LinearMipmapNearest, TextureFilter::Linear),
    ] {
        let o = levels(min, mag);
        for (lambda, level) in
            [(-3.0, 0.0), (0.0, 0.0), (0.49, 0.0), (0.51, 1.0), (1.0, 1.0), (1.49, 1.0), (1.51, 2.0), (4.6, 5.0)]
        {
            assert_eq!(level_at(&o, lambda), level, "lambda {lambda}");
        }
        assert_eq!(level_at(&o, 60.0), 5.0);
        // Exact ties by bias: log2 1 + 1/2 is 1/2.
        for (bias, level) in [(0.5, 0.0), (1.5, 1.0), (2.5, 2.0), (3.5, 3.0), (0.500_001, 1.0)] {
            let p = with_lambda(at(0.51, 0.52, 0.0), 0.0, 32.0);
            assert_eq!((in_255ths(sample_with_bias(&o, &[p], bias)[0][0]) - 10.0) / 40.0, level, "bias {bias}");
        }
    }
}

#[test]
fn mipmap_linear_blends_by_the_fraction() {
    for (min, mag) in [
        (TextureFilter::NearestMipmapLinear, TextureFilter::Nearest),
        (TextureFilter::LinearMipmapLinear, TextureFilter::Linear),
    ] {
        let o = levels(min, mag);
        for lambda in [-2.0, 0.0, 0.25, 0.5, 1.0, 2.75, 4.5, 5.0, 9.0] {
            let want = f64::clamp(lambda, 0.0, 5.0) as f32;
            assert!((level_at(&o, lambda) - want).abs() < 1e-4, "lambda {lambda}");
        }
    }
}

#[test]
fn base_and_max_level_and_the_limits_of_lambda_hold() {
    let mut o = levels(TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
    o.parameters.base_level = 1;
    // Lambda counts from the base level, whose size is 16.
    assert!((level_at(&o, 2.0) - 2.0).abs() < 1e-4);
    o.parameters.max_level = 3;
    assert!((level_at(&o, 9.0) - 3.0).abs() < 1e-4);
    let mut o = levels(TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
    (o.parameters.min_lod, o.parameters.max_lod) = (1.5, 2.25);
    assert!((level_at(&o, 0.0) - 1.5).abs() < 1e-4);
    assert!((level_at(&o, 4.0) - 2.25).abs() < 1e-4);
    (o.parameters.min_lod, o.parameters.max_lod) = (2.0, 1.0);
    assert!((level_at(&o, 0.0) - 2.0).abs() < 1e-4);
    let mut o = levels(TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
    o.parameters.lod_bias = 1.0;
    let p = with_lambda(at(0.51, 0.52, 0.0), 1.0, 32.0);
    assert!((sample_with_bias(&o, &[p], 1.5)[0][0] * 255.0 - 10.0 - 40.0 * 3.5).abs() < 1e-2);
    assert_eq!(in_255ths(sample_with_bias(&o, &[p], 1e30)[0][0]), 210.0);
    assert_eq!(in_255ths(sample_with_bias(&o, &[p], -1e30)[0][0]), 10.0);
}

#[test]
fn magnification_begins_at_the_threshold_of_the_filters() {
    // Columns of 0 and 100: at s = 0.5 LINEAR gives 50 and NEAREST 100.
    let make = |min, mag| {
        let mut o = object(Target::D2, GL_LUMINANCE8, [4, 4, 1], 3, |_, _, [i, ..]| grey(100 * (i % 2)));
        (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
        o
    };
    let value = |o: &_, lambda| red(o, with_lambda(at(0.5, 0.5, 0.0), lambda, 4.0));
    let o = make(TextureFilter::Nearest, TextureFilter::Linear);
    assert_eq!((value(&o, -0.01), value(&o, 0.01)), (50.0, 0.0));
    let o = make(TextureFilter::Linear, TextureFilter::Nearest);
    assert_eq!((value(&o, -0.01), value(&o, 0.01)), (0.0, 50.0));
    for min in [TextureFilter::NearestMipmapNearest, TextureFilter::NearestMipmapLinear] {
        let o = make(min, TextureFilter::Linear);
        assert_eq!(value(&o, 0.49), 50.0, "c is 1/2 here");
        // Minified: nearest texels, 0 on level 0 and 100 on level 1.
        let blends = min == TextureFilter::NearestMipmapLinear;
        assert!((value(&o, 0.51) - if blends { 51.0 } else { 100.0 }).abs() < 0.01);
        let o = make(min, TextureFilter::Nearest);
        assert!((value(&o, 0.4) - if blends { 40.0 } else { 0.0 }).abs() < 0.01, "c is 0 here");
    }
    for min in [TextureFilter::LinearMipmapNearest, TextureFilter::LinearMipmapLinear] {
        let o = make(min, TextureFilter::Nearest);
        assert_eq!((value(&o, -0.01), value(&o, 0.01)), (0.0, 50.0), "c is 0 here");
    }
}

#[test]
fn lanes_do_not_change_each_other() {
    // The same points alone, all together, and among others of very different lambda: the paths for one level and for
    // many must agree to the last bit.
    let points: Vec<SamplePoint> = (0..64)
        .map(|i| {
            let (x, l) = (i as f32 * 0.173, f64::from(i % 13) * 0.61 - 1.0);
            let mut p = with_lambda(at(x, 1.0 - x * 0.7, x * 0.31), l, 16.0);
            p.dy[0] = p.dx[0] * (i % 5) as f32;
            p.dx[2] = 0.01 * x;
            p
        })
        .collect();
    for target in [Target::D1, Target::D2, Target::D3, Target::Cube] {
        for (min, mag) in FILTERS {
            for aniso in [1.0, 7.0] {
                let mut o = object(target, GL_RGBA8, [16, 16, 16], 5, |f, l, [i, j, k]| {
                    [f as f32 / 6.0, (i * 31 % 17) as f32 / 17.0, (j * 13 % 11 + k) as f32 / 30.0, l as f32 / 5.0]
                });
                (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
                o.parameters.max_anisotropy = aniso;
                let together = sample(&o, &points);
                for (p, together) in points.iter().zip(together) {
                    let alone = sample(&o, &[*p])[0];
                    assert_eq!(alone.map(f32::to_bits), together.map(f32::to_bits), "{target:?} {min:?} {mag:?} {p:?}");
                }
            }
        }
    }
}

#[test]
fn limits_of_lambda_change_no_bit_that_they_should_not() {
    // `sample` compares what is left out for such limits with what is not.
    let points: Vec<SamplePoint> = (0..40)
        .map(|i| with_lambda(at(i as f32 * 0.31, i as f32 * 0.17, 0.2), f64::from(i) * 0.2 - 2.0, 16.0))
        .collect();
    let limits = [-3.0, 0.0, 0.4, 0.5, 0.6, 1.0, 2.3, 4.0, 9.0];
    for (min, mag) in FILTERS {
        for aniso in [1.0, 3.0] {
            for (i, &least) in limits.iter().enumerate() {
                for &greatest in &limits[i.saturating_sub(1)..] {
                    let mut o = object(Target::D2, GL_RGB8, [16, 8, 1], 5, |_, l, [i, j, _]| {
                        [(i * 7 % 13) as f32 / 13.0, (j * 5 % 11) as f32 / 11.0, l as f32 / 7.0, 1.0]
                    });
                    (o.parameters.min_filter, o.parameters.mag_filter) = (min, mag);
                    (o.parameters.min_lod, o.parameters.max_lod) = (least, greatest);
                    o.parameters.max_anisotropy = aniso;
                    assert!(sample(&o, &points).iter().flatten().all(|c| (0.0..=1.0).contains(c)));
                }
            }
        }
    }
}

#[test]
fn rectangles_count_texels() {
    let mut o = object(Target::Rectangle, GL_LUMINANCE8, [5, 3, 1], 1, |_, _, [i, j, _]| grey(10 * i + 60 * j));
    assert_eq!(red(&o, at(2.5, 1.5, 0.0)), 80.0);
    assert_eq!(red(&o, at(99.0, -1.0, 0.0)), 40.0);
    (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::Linear, TextureFilter::Linear);
    assert_eq!(red(&o, at(2.0, 1.5, 0.0)), 75.0);
    o.parameters.wrap = [WrapMode::Clamp; 3];
    o.parameters.border_color = grey(240);
    assert_eq!(red(&o, at(5.0, 1.5, 0.0)), 170.0);
}

#[test]
fn borders_of_images_are_sampled_by_clamping_wraps() {
    let mut o = row(4, WrapMode::ClampToBorder, TextureFilter::Nearest);
    let mut image = crate::texture::image::Image::new(
        crate::texture::format::InternalFormat::find(GL_LUMINANCE8).unwrap(),
        crate::texture::image::Dimensions::One,
        [4, 1, 1],
        1,
    )
    .unwrap();
    for i in -1..5 {
        set_texel(&mut image, i, 0, 0, grey(100 + 10 * i));
    }
    o.faces[0][0] = Some(std::sync::Arc::new(image));
    assert_eq!(red(&o, at(-0.2, 0.0, 0.0)), 90.0);
    assert_eq!(red(&o, at(1.2, 0.0, 0.0)), 140.0);
    o.parameters.wrap = [WrapMode::Repeat; 3];
    assert_eq!(red(&o, at(1.1, 0.0, 0.0)), 100.0);
    o.parameters.wrap = [WrapMode::Clamp; 3];
    (o.parameters.min_filter, o.parameters.mag_filter) = (TextureFilter::Linear, TextureFilter::Linear);
    assert_eq!(red(&o, at(0.0, 0.0, 0.0)), 95.0);
}

#[test]
fn nothing_is_asked_for_that_is_not_needed() {
    let names =
        |o: &_| Sampler::build(Level::BASELINE, o, 0.0, 0).plan.steps.iter().map(|s| s.id.name()).collect::<Vec<_>>();
    let needs = |o: &_| Sampler::build(Level::BASELINE, o, 0.0, 0).needs;
    let o = levels(TextureFilter::Linear, TextureFilter::Linear);
    assert_eq!(names(&o), ["BILINEAR_2D_LUMINANCE"]);
    assert!(!needs(&o).derivatives);
    let mut o = levels(TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
    assert!(needs(&o).derivatives);
    o.parameters.max_level = 0;
    assert!(!needs(&o).derivatives, "one level");
    o = levels(TextureFilter::LinearMipmapLinear, TextureFilter::Linear);
    (o.parameters.min_lod, o.parameters.max_lod) = (2.0, 2.0);
    assert!(!needs(&o).derivatives, "constant lambda");
    assert!((level_at(&o, 0.0) - 2.0).abs() < 1e-4);
    o.parameters.max_lod = 2.000_001;
    assert!(needs(&o).derivatives, "nearly constant is not constant");
    (o.parameters.min_lod, o.parameters.max_lod) = (-5.0, 0.0);
    assert!(!needs(&o).derivatives, "always magnified");
    let o = levels(TextureFilter::Nearest, TextureFilter::Linear);
    assert!(needs(&o).derivatives, "magnification must be known");
    assert_eq!(needs(&o).period, [1, 1, 0]);
    assert_eq!(needs(&o).size, [32, 32, 1]);
}
