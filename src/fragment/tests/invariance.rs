//! The same bytes whatever is left out, however the fragments come, at every level; and no panic whatever comes.

use super::{Feed, Random, Scene, contents, draw, program};
use crate::fragment::planes::{Linear, Plane, Planes};
use crate::fragment::program::Options;
use crate::framebuffer::{Clear, Framebuffer, FramebufferFormat};
use crate::simd::Level;
use crate::state::State;
use crate::state::color_buffer::{BlendEquation, BlendFactor, LogicOp};
use crate::state::compare::CompareFunc;
use crate::state::depth_stencil::{StencilFace, StencilOp};
use crate::state::fog::FogMode;
use crate::state::lighting::ColorControl;

/// A random state of everything after interpolation.
fn state(r: &mut Random) -> State {
    let mut s = State::default();
    s.depth.test = r.bool();
    s.depth.func = r.pick(&CompareFunc::ALL);
    s.depth.mask = r.bool();
    s.stencil.test = r.below(3) == 0;
    s.stencil.reference = r.below(300) as i32 - 20;
    s.stencil.value_mask = r.pick(&[u32::MAX, 0x0F]);
    s.stencil.write_mask = r.pick(&[u32::MAX, 0xF0, 0]);
    let mut face = || StencilFace {
        func: r.pick(&CompareFunc::ALL),
        fail: r.pick(&StencilOp::ALL),
        depth_fail: r.pick(&StencilOp::ALL),
        depth_pass: r.pick(&StencilOp::ALL),
    };
    let (front, back) = (face(), face());
    s.stencil.faces = [front, if r.bool() { front } else { back }];
    let c = &mut s.color_buffer;
    c.alpha_test = r.below(3) == 0;
    c.alpha_func = r.pick(&CompareFunc::ALL);
    c.alpha_ref = r.unit() as f32;
    c.blend = r.bool();
    let (src, dst) = match r.below(3) {
        0 => (BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha),
        1 => r.pick(&[
            (BlendFactor::One, BlendFactor::One),
            (BlendFactor::One, BlendFactor::Zero),
            (BlendFactor::SrcAlpha, BlendFactor::One),
            (BlendFactor::One, BlendFactor::OneMinusSrcAlpha),
            (BlendFactor::DstColor, BlendFactor::Zero),
            (BlendFactor::Zero, BlendFactor::SrcColor),
        ]),
        _ => (r.pick(&BlendFactor::ALL), r.pick(&BlendFactor::ALL)),
    };
    (c.blend_src, c.blend_dst) = ([src; 2], [dst; 2]);
    if r.below(8) == 0 {
        (c.blend_src[1], c.blend_dst[1]) = (r.pick(&BlendFactor::ALL), r.pick(&BlendFactor::ALL));
    }
    c.blend_equation = match r.below(4) {
        0 => [r.pick(&BlendEquation::ALL); 2],
        1 => [r.pick(&BlendEquation::ALL), r.pick(&BlendEquation::ALL)],
        _ => [BlendEquation::Add; 2],
    };
    c.blend_color = std::array::from_fn(|_| r.unit() as f32);
    c.logic_op_enabled = r.below(6) == 0;
    c.logic_op = LogicOp::ALL[r.below(16) as usize];
    c.color_mask = if r.below(3) == 0 { std::array::from_fn(|_| r.bool()) } else { [true; 4] };
    s.fog.enabled = r.below(3) == 0;
    s.fog.mode = r.pick(&[FogMode::Linear, FogMode::Exp, FogMode::Exp2]);
    s.fog.density = r.pick(&[0.0, 0.3, 2.0]);
    (s.fog.start, s.fog.end) = r.pick(&[(0.0, 1.0), (0.7, 0.7), (3.0, 1.0)]);
    s.fog.color = std::array::from_fn(|_| r.unit() as f32);
    s.fog.color_sum = r.below(4) == 0;
    s.lighting.enabled = r.below(4) == 0;
    s.lighting.model.color_control = r.pick(&[ColorControl::SingleColor, ColorControl::SeparateSpecularColor]);
    s
}

/// Two overlapping primitives with values for every slot that any program asks for: colour, secondary colour, fog.
fn scene(r: &mut Random, secondary: bool, fog: bool) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..2 {
        let affine = r.bool();
        let w = if affine { [1.0; 3] } else { [1.0, 0.2 + 0.8 * r.unit(), 0.3 + 0.7 * r.unit()] };
        let flat = r.below(3) == 0;
        let mut corners = || {
            let v = [r.unit() * 0.5, r.unit() * 0.5, r.unit() * 0.5];
            if flat { [v[0]; 3] } else { v }
        };
        let all: Vec<_> = (0..8).map(|_| corners()).collect();
        let mut slots = all[..if secondary { 7 } else { 4 }].to_vec();
        slots.extend(fog.then(|| all[7].map(|v| v * 3.0)));
        let z = if r.below(4) == 0 { [8e6; 3] } else { std::array::from_fn(|_| r.unit() * 1.7e7) };
        scene.push([3, -2], [90.0, 20.0], z, w, &slots);
        if r.below(4) == 0 {
            scene.planes.last_mut().unwrap().wide = Planes::WIDE_W;
        }
    }
    scene
}

#[test]
fn nothing_that_is_left_out_changes_a_bit() {
    let mut r = Random::new(11);
    let rects = [(0, [2, 0, 90, 15]), (1, [40, 3, 37, 16])];
    let (mut shorter, mut filled) = (0, 0);
    for case in 0..700 {
        let state = state(&mut r);
        let format = FramebufferFormat {
            float: r.below(5) == 0,
            depth_bits: r.pick(&[24, 24, 16, 32, 0]),
            stencil_bits: r.pick(&[8, 8, 0]),
            color_bits: [8, 8, 8, r.pick(&[8, 8, 0])],
            accum_bits: 0,
        };
        let (coverage, count_samples) = (false, r.bool());
        let mut want = None;
        let seed = r.next();
        for level in Level::available() {
            for general in [true, false] {
                let options = Options { general, coverage, count_samples, q_units: 0, pixels: None, silent: true };
                let p = program(level, &state, &format, options);
                if !general && p.stage_names().len() < 10 {
                    shorter += 1;
                }
                filled += usize::from(p.span.is_some());
                let scene = scene(&mut Random::new(seed), p.layout.secondary.is_some(), p.layout.fog.is_some());
                for feed in Feed::ALL {
                    let mut f = Framebuffer::new(96, 20, format).unwrap();
                    let clear = Clear {
                        color: Some(([0.2, 0.4, 0.6, 0.8], [true; 4])),
                        depth: Some(0.5),
                        stencil: Some((0x5A, 0xFF)),
                        accum: None,
                    };
                    f.clear(&clear, None).unwrap();
                    let samples = draw(&p, &scene, &mut f, feed, &rects);
                    let got = (contents(&f), samples);
                    match &want {
                        None => want = Some(got),
                        Some(want) => assert!(
                            *want == got,
                            "case {case} {level:?} general {general} {feed:?}\n{}{:?}",
                            crate::fragment::explain::in_one_line(&p.decisions),
                            p.stage_names()
                        ),
                    }
                }
            }
        }
    }
    assert!(shorter > 300, "only {shorter} programs left much out");
    assert!(filled > 30, "only {filled} programs fill");
}

#[test]
fn no_plane_makes_it_panic() {
    let mut r = Random::new(5);
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, 0.0, -0.0, 1e-320, 5e9];
    for _ in 0..300 {
        let state = state(&mut r);
        let format = FramebufferFormat::default();
        let mut scene = Scene::default();
        let number = |r: &mut Random| if r.bool() { r.pick(&odd) } else { r.unit() * 4.0 - 2.0 };
        for _ in 0..12 {
            let (n0, nx, ny) = (number(&mut r), number(&mut r), number(&mut r));
            let (c, min, max) = (number(&mut r) as f32, number(&mut r) as f32, number(&mut r) as f32);
            scene.pool.push(Plane { c, min, max, n0, nx, ny });
        }
        let linear = |r: &mut Random| Linear { at: number(r), x: number(r), y: number(r) };
        for first in [0, 7, 11, u32::MAX] {
            let (z, d) = (linear(&mut r), linear(&mut r));
            let z_range = [number(&mut r), number(&mut r)];
            let (affine, wide) = (r.bool(), r.pick(&[0, u32::MAX]));
            let origin = [r.pick(&[0, i32::MAX, i32::MIN]), r.pick(&[0, i32::MAX, i32::MIN])];
            scene.planes.push(Planes { origin, z, z_range, d, affine, back: r.bool(), wide, first, member: None });
        }
        for level in Level::available() {
            for general in [false, true] {
                let p = program(level, &state, &format, Options { general, ..Options::default() });
                for feed in [Feed::Rows, Feed::SingleRows, Feed::Runs, Feed::Together] {
                    let mut f = Framebuffer::new(70, 3, format).unwrap();
                    let rects: Vec<_> = (0..4).map(|i| (i, [0, 0, 70, 3])).collect();
                    draw(&p, &scene, &mut f, feed, &rects);
                }
            }
        }
    }
}

#[test]
fn segments_that_lie_leave_the_band_alone() {
    use crate::fragment::batch::{FragmentBatch, Segment};
    let mut state = State::default();
    state.depth.test = true;
    let format = FramebufferFormat::default();
    let scene = super::flat([1.0; 4], 5.0);
    for level in Level::available() {
        let p = program(level, &state, &format, Options::default());
        let mut b = Box::new(FragmentBatch::new());
        for (start, len, offset, row, n) in [
            (0, 64, u32::MAX, true, 64),
            (0, 64, 30, true, 64),
            (60, 64, 0, true, 64),
            (u32::MAX, u32::MAX, 5, true, usize::MAX),
            (0, 64, 0, false, 64),
            (3, 9, 2, true, 64),
        ] {
            let mut f = Framebuffer::new(10, 6, format).unwrap();
            b.segments[0] = Segment { prim: 0, start, len, x: 0, y: 0, offset, row };
            b.segments[1] = Segment { prim: 9, ..b.segments[0] };
            b.offset = [u32::MAX; 64];
            (b.segment_count, b.tex.n) = (2, n);
            p.run(&mut b, &scene.planes, &scene.pool, &mut f.band());
            let run = Segment { start: 0, len: len.min(100), ..b.segments[0] };
            p.row(&mut Box::new(FragmentBatch::new()), run, &scene.planes, &scene.pool, &mut f.band());
            p.rows(&mut b, &scene.planes, &scene.pool, &mut f.band());
            b.segment_count = usize::MAX;
            p.rows(&mut b, &scene.planes, &scene.pool, &mut f.band());
            p.run(&mut b, &scene.planes, &scene.pool, &mut f.band());
        }
    }
}

#[test]
fn coarse_depths_change_no_bit() {
    let mut r = Random::new(23);
    let format = FramebufferFormat::default();
    let (mut lowered, mut skipped) = (0, 0);
    for case in 0..60 {
        let mut scene = Scene::default();
        let mut frames = [(); 2].map(|()| Framebuffer::new(200, 12, format).unwrap());
        let level = r.pick(&Level::available().collect::<Vec<_>>());
        for prim in 0..12 {
            let z = if r.bool() {
                [f64::from(r.below(1 << 24) as u32); 3]
            } else {
                std::array::from_fn(|_| r.unit() * 1.7e7)
            };
            let slots: Vec<_> = (0..4).map(|_| [r.unit(), r.unit(), r.unit()]).collect();
            scene.push([0, 0], [200.0, 12.0], z, [1.0; 3], &slots);
            let mut state = State::default();
            state.depth.test = true;
            state.depth.func = r.pick(&[
                CompareFunc::Less,
                CompareFunc::Less,
                CompareFunc::Lequal,
                CompareFunc::Lequal,
                CompareFunc::Equal,
                CompareFunc::Greater,
                CompareFunc::Always,
            ]);
            state.depth.mask = r.below(4) != 0;
            state.color_buffer.alpha_test = r.below(4) == 0;
            (state.color_buffer.alpha_func, state.color_buffer.alpha_ref) = (CompareFunc::Greater, 0.5);
            // With blending there is no stage that fills.
            state.color_buffer.blend = r.bool();
            (state.color_buffer.blend_src, state.color_buffer.blend_dst) =
                ([BlendFactor::DstColor; 2], [BlendFactor::SrcAlpha; 2]);
            let (x, y) = (r.below(120) as u32, r.below(8) as u32);
            let rects = [(prim, [x, y, 80 - r.below(40) as u32, 1 + r.below(4) as u32]), (prim, [0, 11, 200, 1])];
            for (general, frame) in [true, false].into_iter().zip(&mut frames) {
                let p = program(level, &state, &format, Options { general, ..Options::default() });
                draw(&p, &scene, frame, if general { Feed::Rows } else { Feed::Runs }, &rects);
                skipped += usize::from(p.hiz.is_some());
            }
            let [want, got] = frames.each_ref().map(contents);
            assert!(want == got, "case {case} {level:?} primitive {prim}");
            let max = f64::from(format.depth_max());
            for (y, depths) in got.1.chunks(200).enumerate() {
                let band = frames[1].band();
                for (limit, depths) in band.hier_z.row(y).iter().zip(depths.chunks(64)) {
                    let greatest = depths.iter().map(|d| (f64::from_bits(*d) * max).round() as u32).max().unwrap();
                    assert!(*limit >= greatest, "case {case} primitive {prim} row {y}: {limit} < {greatest}");
                    lowered += usize::from(*limit < format.depth_max());
                }
            }
        }
    }
    assert!(lowered > 500 && skipped > 200, "{lowered} {skipped}");
}
