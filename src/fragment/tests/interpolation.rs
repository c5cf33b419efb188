//! Interpolation against f64, texture coordinates and their derivatives, and invariance under whole-pixel moves.

use super::{Feed, Random, Scene, contents, draw, program};
use crate::fragment::batch::{FragmentBatch, Segment};
use crate::fragment::planes::{Layout, Linear, Plane, PlanePool, Planes, UnitSlots};
use crate::fragment::program::Options;
use crate::fragment::reference::interpolate::FIRST;
use crate::fragment::reference::texcoord::{COORDINATES, DERIVATIVES};
use crate::fragment::uniforms::{FragUniforms, Work};
use crate::framebuffer::{Framebuffer, FramebufferFormat};
use crate::simd::Level;
use crate::state::State;

#[test]
fn colours_are_interpolated_in_perspective() {
    let format = FramebufferFormat { float: true, ..FramebufferFormat::default() };
    let mut r = Random::new(77);
    for level in Level::available() {
        for case in 0..60 {
            let corner = |r: &mut Random| [r.unit() * 0.5, r.unit() * 0.5, r.unit() * 0.5];
            let w = [1.0, 0.02 + 0.9 * r.unit(), 0.4 + 0.5 * r.unit()];
            let w = if case % 4 == 0 { [1.0; 3] } else { w };
            let slots: Vec<_> = (0..4).map(|_| corner(&mut r)).collect();
            let mut scene = Scene::default();
            scene.push([0, 0], [100.0, 10.0], [0.0; 3], w, &slots);
            let mut f = Framebuffer::new(100, 10, format).unwrap();
            let p = program(level, &State::default(), &format, Options::default());
            draw(&p, &scene, &mut f, Feed::Rows, &[(0, [0, 0, 99, 10])]);
            for (x, y) in [(0, 0), (98, 0), (40, 5), (17, 9), (1, 2)] {
                let (s, t) = (f64::from(x) / 100.0, f64::from(y) / 10.0);
                let at = |v: [f64; 3]| v[0] + (v[1] - v[0]) * s + (v[2] - v[0]) * t;
                let d = at(w);
                if d < 0.01 {
                    continue;
                }
                for (c, slot) in slots.iter().enumerate() {
                    let low = slot.iter().fold(slot[1] + slot[2] - slot[0], |a, b| a.min(*b));
                    let high = slot.iter().fold(slot[1] + slot[2] - slot[0], |a, b| a.max(*b));
                    let exact = at(std::array::from_fn(|i| slot[i] * w[i])) / d;
                    let want = exact.clamp(low, high).clamp(0.0, 1.0);
                    let got = f64::from(super::pixel(&f, x, y)[c]);
                    assert!((got - want).abs() < 3e-5, "{level:?} ({x}, {y}) channel {c}: {got} for {want}");
                }
            }
        }
    }
}

#[test]
fn moving_a_primitive_by_whole_pixels_changes_nothing() {
    let format = FramebufferFormat { float: true, ..FramebufferFormat::default() };
    let mut state = State::default();
    (state.depth.test, state.depth.func) = (true, crate::state::compare::CompareFunc::Always);
    let p = program(Level::detect(), &state, &format, Options::default());
    let mut r = Random::new(6);
    for _ in 0..40 {
        let w = [1.0, 0.1 + r.unit(), 0.1 + r.unit()].map(|v| v.min(1.0));
        let slots: Vec<_> = (0..4).map(|_| [r.unit(), r.unit(), r.unit()]).collect();
        let z = std::array::from_fn(|_| r.unit() * 1.6e7);
        let mut pictures = Vec::new();
        for (ox, oy) in [(0u32, 0u32), (13, 5), (1900, 40)] {
            let mut scene = Scene::default();
            scene.push([ox as i32, oy as i32], [50.0, 9.0], z, w, &slots);
            let mut f = Framebuffer::new(ox + 60, oy + 10, format).unwrap();
            draw(&p, &scene, &mut f, Feed::Rows, &[(0, [ox, oy, 50, 9])]);
            let (color, depth, _) = contents(&f);
            let at = |x: u32, y: u32| ((oy + y) * f.width() + ox + x) as usize;
            let part: Vec<_> = (0..9)
                .flat_map(|y| (0..50).map(move |x| (x, y)))
                .map(|(x, y)| (color[at(x, y)], depth[at(x, y)]))
                .collect();
            pictures.push(part);
        }
        assert!(pictures[0] == pictures[1] && pictures[0] == pictures[2]);
    }
}

/// Coordinates and derivatives of pixels `x..x + n` of row y, by rows or by scattered lanes.
fn coordinates(
    level: Level,
    slots: UnitSlots,
    planes: Planes,
    pool: &[Plane],
    at: [i32; 2],
    n: u32,
    row: bool,
) -> Box<FragmentBatch> {
    let mut layout = Layout { count: 4, stride: 4, ..Layout::default() };
    layout.units[2] = Some(slots);
    let uniforms = FragUniforms { layout, ..FragUniforms::default() };
    let mut b = Box::new(FragmentBatch::new());
    if row {
        b.push_row(0, at[0], at[1], 0, n);
    } else {
        for i in 0..n as usize {
            b.dx[i] = (at[0] + i as i32 - planes.origin[0]) as f32;
            b.dy[i] = (at[1] - planes.origin[1]) as f32;
        }
        // Two segments, so that the second one starts in the middle of a chunk.
        b.segments[0] = Segment { prim: 0, start: 0, len: 5.min(n), ..Segment::default() };
        b.segments[1] = Segment { prim: 0, start: 5.min(n), len: n - 5.min(n), ..Segment::default() };
        b.segment_count = if n > 5 { 2 } else { 1 };
        b.tex.n = n as usize;
    }
    let mut f = Framebuffer::new(1, 1, FramebufferFormat::default()).unwrap();
    let mut band = f.band();
    let mut work =
        Work { planes: &[planes], pool: PlanePool { alone: pool, groups: &[] }, band: &mut band, counts: None };
    #[expect(unsafe_code, reason = "the level is one that the processor has")]
    // SAFETY: `Level::available` gave it.
    unsafe {
        (COORDINATES.at(level))(&mut b, &uniforms, &mut work, FIRST | DERIVATIVES | 2 << 2);
    }
    b
}

#[test]
fn coordinates_and_derivatives_are_those_of_the_planes() {
    let mut r = Random::new(15);
    for level in Level::available() {
        for case in 0..120 {
            let (has_q, wide) = (case % 2 == 1, case % 3 == 0);
            let size = [64.0, 8.0];
            let linear = |a: f64, b: f64, c: f64| Linear { at: a, x: (b - a) / size[0], y: (c - a) / size[1] };
            let d = linear(1.0, 0.3 + 0.7 * r.unit(), 0.6 + 0.4 * r.unit());
            let q = linear(0.9, 0.4 + 0.5 * r.unit(), 0.7);
            let c = (r.unit() * 8.0 - 4.0) as f32;
            let scale = if wide { 1000.0 } else { 2.0 };
            let mut pool: Vec<_> = (0..2)
                .map(|_| {
                    let n = linear(r.unit() * scale, r.unit() * scale, r.unit() * scale);
                    Plane { c, min: -1e6, max: 1e6, n0: n.at, nx: n.x, ny: n.y }
                })
                .collect();
            pool.push(Plane { n0: q.at, nx: q.x, ny: q.y, ..Plane::default() });
            let planes = Planes { origin: [10, 20], d, wide: if wide { 1 << 2 } else { 0 }, ..Planes::default() };
            let slots = UnitSlots { base: 0, count: 2, has_q, period: [0; 3], size: [256; 3], cube: false };
            let by_row = coordinates(level, slots, planes, &pool, [12, 25], 61, true);
            let dense = coordinates(level, slots, planes, &pool, [12, 25], 61, false);
            let divisor = if has_q { q } else { d };
            for i in 0..61 {
                let (x, y) = (2.0 + i as f64, 5.0);
                let at = |l: &Linear| l.at + l.x * x + l.y * y;
                let qv = at(&divisor);
                for k in 0..2 {
                    let p = &pool[k];
                    let t = at(&Linear { at: p.n0, x: p.nx, y: p.ny }) / qv;
                    let want = f64::from(p.c) + t;
                    let (dx, dy) = ((p.nx - t * divisor.x) / qv, (p.ny - t * divisor.y) / qv);
                    let got = &by_row.tex;
                    let rounding = want.abs() * 1.2e-7 + if wide { 1e-9 } else { 5e-7 * (t.abs() + 1.0) };
                    assert!((f64::from(got.coord[k][i]) - want).abs() <= rounding, "{} for {want}", got.coord[k][i]);
                    let unit = (p.nx.abs() + t.abs() * divisor.x.abs()) / qv;
                    assert!((f64::from(got.ddx[k][i]) - dx).abs() < 1e-5 * unit, "{} for {dx}", got.ddx[k][i]);
                    let unit = (p.ny.abs() + t.abs() * divisor.y.abs()) / qv;
                    assert!((f64::from(got.ddy[k][i]) - dy).abs() < 1e-5 * unit, "{} for {dy}", got.ddy[k][i]);
                    for (a, b) in
                        [(&got.coord, &dense.tex.coord), (&got.ddx, &dense.tex.ddx), (&got.ddy, &dense.tex.ddy)]
                    {
                        assert_eq!(a[k][i].to_bits(), b[k][i].to_bits(), "lane {i} by row and dense");
                    }
                }
            }
        }
    }
}

#[test]
fn wide_coordinates_lose_whole_periods_and_nothing_else() {
    for level in Level::available() {
        for (period, offset) in [(1u8, 1e6), (2, 4e5), (1, -3e9)] {
            let planes = Planes { d: Linear { at: 1.0, x: -0.01, y: 0.0 }, wide: 1 << 2, ..Planes::default() };
            let pool = [Plane { c: offset as f32, min: f32::MIN, max: f32::MAX, n0: 0.125, nx: 0.5, ny: 0.0 }; 2];
            let slots =
                UnitSlots { base: 0, count: 1, has_q: false, period: [period, 0, 0], size: [256; 3], cube: false };
            let b = coordinates(level, slots, planes, &pool, [0, 0], 60, true);
            for i in 0..60 {
                let x = i as f64;
                let exact = f64::from(offset as f32) + (0.125 + 0.5 * x) / (1.0 - 0.01 * x);
                let got = f64::from(b.tex.coord[0][i]);
                let turns = (exact - got) / f64::from(period);
                assert!((turns - turns.round()).abs() < 2e-6, "{exact} became {got}");
                assert!(got.abs() <= f64::from(period));
            }
        }
    }
}

#[test]
fn coordinates_are_finite_whatever_comes() {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e-320, 1e308, -1.0, 3.0];
    let mut r = Random::new(2);
    for level in Level::available() {
        for _ in 0..400 {
            let mut n = || r.pick(&odd);
            let d = Linear { at: n(), x: n(), y: n() };
            let pool: Vec<_> = (0..4)
                .map(|_| Plane { c: n() as f32, min: n() as f32, max: n() as f32, n0: n(), nx: n(), ny: n() })
                .collect();
            for wide in [0, u32::MAX] {
                for (has_q, row) in [(false, true), (true, false), (true, true)] {
                    let planes = Planes { d, wide, ..Planes::default() };
                    let slots = UnitSlots { base: 0, count: 3, has_q, period: [1, 2, 0], size: [4; 3], cube: false };
                    let b = coordinates(level, slots, planes, &pool, [1, 1], 40, row);
                    assert!(b.tex.coord.iter().all(|c| c[..40].iter().all(|v| v.is_finite())));
                }
            }
        }
    }
}
