//! Each stage against its equation, evaluated in f64 or in integers straight from the specification.

use super::{Feed, Random, Scene, draw, flat, pixel, program};
use crate::fragment::program::{Fate, Options};
use crate::framebuffer::{Clear, Framebuffer, FramebufferFormat};
use crate::simd::Level;
use crate::state::State;
use crate::state::color_buffer::{BlendEquation, BlendFactor, LogicOp};
use crate::state::compare::CompareFunc;
use crate::state::depth_stencil::StencilOp;
use crate::state::fog::FogMode;

/// An operation on two bytes.
type Bytes = fn(u8, u8) -> u8;

fn clear_to(f: &mut Framebuffer, color: [f32; 4], depth: f64, stencil: u8) {
    let clear =
        Clear { color: Some((color, [true; 4])), depth: Some(depth), stencil: Some((stencil, 0xFF)), accum: None };
    f.clear(&clear, None).unwrap();
}

/// Draws one pixel of a colour and depth; returns bytes, depth integer and stencil.
fn one(state: &State, src: [f64; 4], z: f64, dst: [u8; 4], depth: u32, stencil: u8) -> ([u8; 4], u32, u8) {
    let format = FramebufferFormat::default();
    let mut f = Framebuffer::new(1, 1, format).unwrap();
    clear_to(&mut f, dst.map(|b| f32::from(b) / 255.0), f64::from(depth) / 16_777_215.0, stencil);
    let p = program(Level::detect(), state, &format, Options::default());
    draw(&p, &flat(src, z), &mut f, Feed::Rows, &[(0, [0, 0, 1, 1])]);
    let (mut c, mut d, mut s) = ([0u32], [0.0], [0]);
    f.read_rgba8(0, 0, &mut c);
    f.read_depth(0, 0, &mut d);
    f.read_stencil(0, 0, &mut s);
    (c[0].to_le_bytes(), (d[0] * 16_777_215.0).round() as u32, s[0])
}

/// A factor of channel c by the specification's table 4.1 and 4.2, in f64.
fn factor(name: BlendFactor, c: usize, s: [f64; 4], d: [f64; 4], k: [f64; 4]) -> f64 {
    match name {
        BlendFactor::Zero => 0.0,
        BlendFactor::One => 1.0,
        BlendFactor::SrcColor => s[c],
        BlendFactor::OneMinusSrcColor => 1.0 - s[c],
        BlendFactor::DstColor => d[c],
        BlendFactor::OneMinusDstColor => 1.0 - d[c],
        BlendFactor::SrcAlpha => s[3],
        BlendFactor::OneMinusSrcAlpha => 1.0 - s[3],
        BlendFactor::DstAlpha => d[3],
        BlendFactor::OneMinusDstAlpha => 1.0 - d[3],
        BlendFactor::ConstantColor => k[c],
        BlendFactor::OneMinusConstantColor => 1.0 - k[c],
        BlendFactor::ConstantAlpha => k[3],
        BlendFactor::OneMinusConstantAlpha => 1.0 - k[3],
        BlendFactor::SrcAlphaSaturate if c == 3 => 1.0,
        BlendFactor::SrcAlphaSaturate => s[3].min(1.0 - d[3]),
    }
}

#[test]
fn blending_is_the_equation() {
    let mut r = Random::new(3);
    let mut state = State::default();
    state.color_buffer.blend = true;
    for equation in BlendEquation::ALL {
        for sf in BlendFactor::ALL {
            for df in BlendFactor::ALL {
                let (sa, da) = (r.pick(&BlendFactor::ALL), r.pick(&BlendFactor::ALL));
                let (sa, da) = if r.bool() { (sf, df) } else { (sa, da) };
                let dst: [u8; 4] = std::array::from_fn(|_| r.below(256) as u8);
                let src: [f64; 4] = std::array::from_fn(|_| f64::from(r.unit() as f32));
                let k: [f32; 4] = std::array::from_fn(|_| r.unit() as f32);
                let c = &mut state.color_buffer;
                (c.blend_src, c.blend_dst, c.blend_equation, c.blend_color) = ([sf, sa], [df, da], [equation; 2], k);
                let (got, ..) = one(&state, src, 0.0, dst, 0, 0);
                let (d, k) = (dst.map(|b| f64::from(b) / 255.0), k.map(f64::from));
                for c in 0..4 {
                    let (sn, dn) = if c == 3 { (sa, da) } else { (sf, df) };
                    let (s, t) = (src[c] * factor(sn, c, src, d, k), d[c] * factor(dn, c, src, d, k));
                    let want = match equation {
                        BlendEquation::Add => s + t,
                        BlendEquation::Subtract => s - t,
                        BlendEquation::ReverseSubtract => t - s,
                        BlendEquation::Min => src[c].min(d[c]),
                        BlendEquation::Max => src[c].max(d[c]),
                    };
                    let want = want.clamp(0.0, 1.0) * 255.0;
                    let error = (f64::from(got[c]) - want).abs();
                    assert!(error <= 0.5001, "{equation:?} {sf:?} {df:?}: {} for {want}", got[c]);
                }
            }
        }
    }
}

#[test]
fn blending_is_exact_at_its_ends() {
    let mut state = State::default();
    state.color_buffer.blend = true;
    let mut set = |src, dst| {
        (state.color_buffer.blend_src, state.color_buffer.blend_dst) = ([src; 2], [dst; 2]);
        state.clone()
    };
    for value in 0..=255u8 {
        let v = f64::from(f32::from(value) / 255.0);
        let dst = [value, 255 - value, 7, value];
        let alpha = set(BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha);
        assert_eq!(one(&alpha, [v, v, v, 1.0], 0.0, dst, 0, 0).0, [value, value, value, 255], "opaque");
        assert_eq!(one(&alpha, [0.3, 0.7, 1.0, 0.0], 0.0, dst, 0, 0).0, dst, "transparent");
        assert_eq!(one(&set(BlendFactor::DstColor, BlendFactor::Zero), [1.0; 4], 0.0, dst, 0, 0).0, dst, "times white");
        assert_eq!(one(&set(BlendFactor::Zero, BlendFactor::SrcColor), [1.0; 4], 0.0, dst, 0, 0).0, dst, "times white");
        assert_eq!(one(&set(BlendFactor::One, BlendFactor::One), [0.0; 4], 0.0, dst, 0, 0).0, dst, "plus black");
        assert_eq!(
            one(&set(BlendFactor::OneMinusDstColor, BlendFactor::One), [1.0; 4], 0.0, dst, 0, 0).0,
            [255; 4],
            "screen"
        );
    }
}

#[test]
fn depth_is_rounded_to_the_buffer() {
    let mut state = State::default();
    (state.depth.test, state.depth.func) = (true, CompareFunc::Always);
    for (z, want) in [
        (0.0, 0),
        (0.5, 0),
        (0.500_001, 1),
        (1.5, 2),
        (16_777_214.4, 16_777_214),
        (16_777_216.0, 16_777_215),
        (-3.0, 0),
        (1e30, 16_777_215),
        (f64::NAN, 0),
    ] {
        assert_eq!(one(&state, [1.0; 4], z, [0; 4], 77, 0).1, want, "{z}");
    }
    for (bits, max) in [(16u8, 65_535u32), (24, 16_777_215), (32, u32::MAX)] {
        let format = FramebufferFormat { depth_bits: bits, ..FramebufferFormat::default() };
        assert_eq!(format.depth_max(), max);
        let mut f = Framebuffer::new(1, 1, format).unwrap();
        let p = program(Level::detect(), &state, &format, Options::default());
        let mut scene = flat([1.0; 4], f64::from(max) - 1.0);
        scene.planes[0].z_range[1] = f64::from(max);
        draw(&p, &scene, &mut f, Feed::Rows, &[(0, [0, 0, 1, 1])]);
        let mut d = [0.0];
        f.read_depth(0, 0, &mut d);
        assert_eq!(d[0], (f64::from(max) - 1.0) / f64::from(max), "{bits} bits");
    }
}

#[test]
fn the_depth_test_compares_and_writes() {
    type Pass = fn(u32, u32) -> bool;
    let funcs: [(CompareFunc, Pass); 8] = [
        (CompareFunc::Never, |_, _| false),
        (CompareFunc::Less, |a, b| a < b),
        (CompareFunc::Equal, |a, b| a == b),
        (CompareFunc::Lequal, |a, b| a <= b),
        (CompareFunc::Greater, |a, b| a > b),
        (CompareFunc::Notequal, |a, b| a != b),
        (CompareFunc::Gequal, |a, b| a >= b),
        (CompareFunc::Always, |_, _| true),
    ];
    let mut state = State::default();
    state.depth.test = true;
    for (func, pass) in funcs {
        for mask in [true, false] {
            for z in [99, 100, 101] {
                (state.depth.func, state.depth.mask) = (func, mask);
                let (c, d, _) = one(&state, [1.0; 4], f64::from(z), [0; 4], 100, 0);
                let passed = pass(z, 100);
                assert_eq!(c, if passed { [255; 4] } else { [0; 4] }, "{} {z}", func.name());
                assert_eq!(d, if passed && mask { z } else { 100 }, "{} {z} mask {mask}", func.name());
            }
        }
    }
    state.depth.test = false;
    assert_eq!(one(&state, [1.0; 4], 5.0, [0; 4], 100, 0).1, 100, "no test, no write");
}

#[test]
fn stencil_operations_are_those_of_the_three_cases() {
    let ops: [(StencilOp, Bytes); 8] = [
        (StencilOp::Keep, |s, _| s),
        (StencilOp::Zero, |_, _| 0),
        (StencilOp::Replace, |_, r| r),
        (StencilOp::Incr, |s, _| s.saturating_add(1)),
        (StencilOp::Decr, |s, _| s.saturating_sub(1)),
        (StencilOp::Invert, |s, _| !s),
        (StencilOp::IncrWrap, |s, _| s.wrapping_add(1)),
        (StencilOp::DecrWrap, |s, _| s.wrapping_sub(1)),
    ];
    let mut r = Random::new(9);
    for (op, f) in ops {
        for s in [0u8, 1, 77, 254, 255] {
            for case in 0..3 {
                let mut state = State::default();
                (state.stencil.test, state.depth.test) = (true, true);
                state.stencil.reference = 0x35;
                state.stencil.write_mask = r.pick(&[0xFF, 0x0F, 0xFFFF_FF80]);
                let face = &mut state.stencil.faces[0];
                face.func = if case == 0 { CompareFunc::Never } else { CompareFunc::Always };
                *[&mut face.fail, &mut face.depth_fail, &mut face.depth_pass][case] = op;
                state.depth.func = if case == 1 { CompareFunc::Greater } else { CompareFunc::Less };
                let mask = state.stencil.write_mask as u8;
                let (c, d, got) = one(&state, [1.0; 4], 50.0, [0; 4], 100, s);
                assert_eq!(got, (f(s, 0x35) & mask) | (s & !mask), "{op:?} of {s}, case {case}");
                assert_eq!((c, d), if case == 2 { ([255; 4], 50) } else { ([0; 4], 100) });
            }
        }
    }
    let mut state = State::default();
    (state.stencil.test, state.stencil.faces[0].func) = (true, CompareFunc::Less);
    (state.stencil.reference, state.stencil.value_mask) = (0x41, 0x0F);
    assert_eq!(one(&state, [1.0; 4], 0.0, [0; 4], 0, 0x32).0, [255; 4], "1 < 2 under the mask");
    assert_eq!(one(&state, [1.0; 4], 0.0, [0; 4], 0, 0xF1).0, [0; 4], "1 < 1 under the mask");
}

#[test]
fn the_alpha_test_looks_at_bytes() {
    let mut state = State::default();
    state.color_buffer.alpha_test = true;
    state.color_buffer.alpha_func = CompareFunc::Equal;
    state.color_buffer.alpha_ref = 100.3 / 255.0;
    let drawn = |a: f64| one(&state, [1.0, 1.0, 1.0, a / 255.0], 0.0, [0; 4], 0, 0).0[0] == 255;
    assert!(drawn(99.6) && drawn(100.4) && !drawn(100.6) && !drawn(99.4));
}

#[test]
fn logic_operations_are_those_of_the_table() {
    let ops: [(LogicOp, Bytes); 16] = [
        (LogicOp::Clear, |_, _| 0),
        (LogicOp::And, |s, d| s & d),
        (LogicOp::AndReverse, |s, d| s & !d),
        (LogicOp::Copy, |s, _| s),
        (LogicOp::AndInverted, |s, d| !s & d),
        (LogicOp::Noop, |_, d| d),
        (LogicOp::Xor, |s, d| s ^ d),
        (LogicOp::Or, |s, d| s | d),
        (LogicOp::Nor, |s, d| !(s | d)),
        (LogicOp::Equiv, |s, d| !(s ^ d)),
        (LogicOp::Invert, |_, d| !d),
        (LogicOp::OrReverse, |s, d| s | !d),
        (LogicOp::CopyInverted, |s, _| !s),
        (LogicOp::OrInverted, |s, d| !s | d),
        (LogicOp::Nand, |s, d| !(s & d)),
        (LogicOp::Set, |_, _| 255),
    ];
    let mut state = State::default();
    (state.color_buffer.logic_op_enabled, state.color_buffer.blend) = (true, true);
    for (op, f) in ops {
        state.color_buffer.logic_op = op;
        let (src, dst) = ([0x3Cu8, 0x0F, 0xFF, 0x5A], [0x55u8, 0xAA, 0x33, 0xC3]);
        let got = one(&state, src.map(|b| f64::from(f32::from(b) / 255.0)), 0.0, dst, 0, 0).0;
        assert_eq!(got, std::array::from_fn(|c| f(src[c], dst[c])), "{op:?}");
    }
}

#[test]
fn fog_is_the_equation() {
    let mut r = Random::new(21);
    let format = FramebufferFormat { float: true, ..FramebufferFormat::default() };
    for mode in FogMode::ALL {
        for _ in 0..100 {
            let mut state = State::default();
            state.fog.enabled = true;
            state.fog.mode = mode;
            state.fog.density = r.unit() as f32 * 2.0;
            (state.fog.start, state.fog.end) = (r.unit() as f32, 2.0 + r.unit() as f32);
            state.fog.color = [0.1, 0.5, 0.9, 0.3];
            let c = r.unit() * 3.0;
            let mut scene = Scene::default();
            scene.push([0, 0], [1.0; 2], [0.0; 3], [1.0; 3], &[[0.9; 3], [0.2; 3], [0.4; 3], [0.6; 3], [c; 3]]);
            let mut f = Framebuffer::new(1, 1, format).unwrap();
            let p = program(Level::detect(), &state, &format, Options::default());
            assert_eq!(p.layout.fog, Some(4));
            draw(&p, &scene, &mut f, Feed::Rows, &[(0, [0, 0, 1, 1])]);
            let (d, s, e) = (f64::from(state.fog.density), f64::from(state.fog.start), f64::from(state.fog.end));
            let factor = match mode {
                FogMode::Exp => (-d * c).exp(),
                FogMode::Exp2 => (-(d * c) * (d * c)).exp(),
                _ => (e - c) / (e - s),
            }
            .clamp(0.0, 1.0);
            let got = pixel(&f, 0, 0);
            for (k, (color, fog)) in [(0.9, 0.1), (0.2, 0.5), (0.4, 0.9)].into_iter().enumerate() {
                let want = factor * color + (1.0 - factor) * fog;
                assert!((f64::from(got[k]) - want).abs() < 1e-6, "{mode:?} {c}: {} for {want}", got[k]);
            }
            assert_eq!(got[3], 0.6, "alpha has no fog");
        }
    }
}

#[test]
fn coverage_comes_after_fog_and_before_the_alpha_test() {
    use crate::fragment::batch::FragmentBatch;
    let mut state = State::default();
    (state.color_buffer.alpha_test, state.color_buffer.alpha_func) = (true, CompareFunc::Gequal);
    state.color_buffer.alpha_ref = 0.5;
    let format = FramebufferFormat::default();
    let mut f = Framebuffer::new(3, 1, format).unwrap();
    let p = program(Level::detect(), &state, &format, Options { coverage: true, ..Options::default() });
    let scene = flat([1.0, 1.0, 1.0, 0.8], 0.0);
    let mut b = FragmentBatch::new();
    b.push_row(0, 0, 0, 0, 3);
    b.coverage[..3].copy_from_slice(&[1.0, 0.65, 0.6]);
    p.run(&mut b, &scene.planes, &scene.pool, &mut f.band());
    let alpha: Vec<_> = (0..3).map(|x| (pixel(&f, x, 0)[3] * 255.0).round()).collect();
    assert_eq!(alpha, [204.0, 133.0, 0.0]);
}

#[test]
fn samples_are_those_that_pass() {
    let mut state = State::default();
    state.depth.test = true;
    let format = FramebufferFormat::default();
    for alpha_test in [false, true] {
        state.color_buffer.alpha_test = alpha_test;
        state.color_buffer.alpha_func = CompareFunc::Greater;
        let p = program(Level::detect(), &state, &format, Options { count_samples: true, ..Options::default() });
        let mut f = Framebuffer::new(90, 9, format).unwrap();
        let mut scene = flat([1.0; 4], 100.0);
        scene.push([0, 0], [9.0; 2], [50.0; 3], [1.0; 3], &[[0.5; 3]; 4]);
        let rects = [(1, [10, 2, 5, 3]), (0, [0, 0, 90, 9])];
        assert_eq!(draw(&p, &scene, &mut f, Feed::Rows, &rects), 15 + 90 * 9 - 15);
    }
}

#[test]
fn a_pixel_weighs_more_with_every_thing_that_is_done_to_it() {
    let format = FramebufferFormat::default();
    let mut state = State::default();
    let same = flat([0.5; 4], 100.0);
    let mut varied = flat([0.5; 4], 100.0);
    varied.pool[0].max = 1.0;
    let mut weigh = |change: fn(&mut State), scene: &Scene| {
        change(&mut state);
        let p = program(Level::BASELINE, &state, &format, Options::default());
        p.weight(&scene.planes[0], (&scene.pool).into())
    };
    let weights = [
        weigh(|_| (), &same),
        weigh(|state| state.depth.test = true, &same),
        weigh(|state| state.depth.test = false, &varied),
        weigh(|state| state.depth.test = true, &varied),
        weigh(|state| state.color_buffer.blend = true, &varied),
        weigh(|state| state.color_buffer.blend_dst = [BlendFactor::One; 2], &varied),
    ];
    assert_eq!(weights, [1, 3, 4, 6, 6, 32]);
}

#[test]
fn a_program_says_what_it_does() {
    let format = FramebufferFormat::default();
    let plain = program(Level::BASELINE, &State::default(), &format, Options::default());
    assert_eq!(plain.stage_names(), ["BEGIN", "COLOR_STORE"]);
    assert!(!plain.reads_framebuffer && !plain.draws_nothing());
    let fate = |p: &crate::fragment::program::Program, stage: &str| {
        p.decisions.iter().find(|d| d.stage == stage).map(|d| d.fate)
    };
    for stage in ["alpha test", "stencil test", "depth test", "texturing", "fog", "colour sum", "blending", "logic op"]
    {
        assert_eq!(
            fate(&plain, stage),
            Some(Fate::LeftOut),
            "{stage}\n{}",
            crate::fragment::explain::in_one_line(&plain.decisions)
        );
    }
    let mut state = State::default();
    state.depth.test = true;
    state.color_buffer.alpha_test = true;
    state.color_buffer.alpha_func = CompareFunc::Greater;
    let p = program(Level::BASELINE, &state, &format, Options::default());
    let names = p.stage_names();
    let at = |n: &str| names.iter().position(|s| *s == n).unwrap_or_else(|| panic!("{n} in {names:?}"));
    assert!(at("EARLY_DEPTH") < at("COLOR") && at("ALPHA_TEST") < at("DEPTH_WRITE"));
    assert!(p.reads_framebuffer);
    state.color_buffer.color_mask = [false; 4];
    state.depth.mask = false;
    assert!(program(Level::BASELINE, &state, &format, Options::default()).draws_nothing());
    // Almost is not enough: factors that are not ONE, ZERO are kept whatever the alphas may be.
    let mut state = State::default();
    state.color_buffer.blend = true;
    (state.color_buffer.blend_src, state.color_buffer.blend_dst) =
        ([BlendFactor::SrcAlpha; 2], [BlendFactor::OneMinusSrcAlpha; 2]);
    assert_eq!(fate(&program(Level::BASELINE, &state, &format, Options::default()), "blending"), Some(Fate::Kept));
    (state.fog.enabled, state.fog.density) = (true, 1e-30);
    assert_eq!(fate(&program(Level::BASELINE, &state, &format, Options::default()), "fog"), Some(Fate::Kept));
}
