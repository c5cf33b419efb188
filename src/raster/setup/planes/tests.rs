//! Tests of planes: against the definition, and values that are no numbers.

use super::*;
use crate::fragment::planes::Linear;
use crate::raster::testing::{Random, TestCanvas, value, vertex};
use crate::raster::vertex::Vertex;

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// Barycentric weights of a point, from the definition.
fn weights(p: [[f64; 2]; 3], x: f64, y: f64) -> [f64; 3] {
    let cross = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    let all = cross(p[0], p[1], p[2]);
    let at = [x, y];
    [cross(at, p[1], p[2]) / all, cross(p[0], at, p[2]) / all, cross(p[0], p[1], at) / all]
}

#[test]
fn values_are_perspective_correct() {
    let mut random = Random(5);
    let mut checked = 0;
    for round in 0..300 {
        let ratio = [1.0, 3.0, 1000.0][round % 3];
        let p = [[0.0; 2]; 3].map(|p| p.map(|_| random.between(-10.0, 70.0)));
        let w = [0.0; 3].map(|_| random.between(1.0, ratio));
        // Slivers have slopes so steep that their terms cancel; they are another test.
        let [a, b, c] = p;
        if ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs() < 200.0 {
            continue;
        }
        let slots = [0, 1, 2].map(|_| vec![random.between(0.0, 1.0) as f32, random.between(-8.0, 8.0) as f32]);
        let mut canvas = TestCanvas::new(64, 2, 1, 64, |_| {});
        let v = [0, 1, 2].map(|i: usize| vertex(p[i][0], p[i][1], 0.25, w[i]));
        canvas.triangle(&v, &slots);
        for seen in canvas.seen() {
            let b = weights(p, f64::from(seen.at[0]) + 0.5, f64::from(seen.at[1]) + 0.5);
            if b.iter().any(|b| *b < 0.0) {
                continue;
            }
            let over = [0, 1, 2].map(|i: usize| b[i] / w[i]);
            let below = over[0] + over[1] + over[2];
            for (k, got) in seen.values.iter().enumerate() {
                let f = [0, 1, 2].map(|i: usize| f64::from(slots[i][k]));
                let want = (over[0] * f[0] + over[1] * f[1] + over[2] * f[2]) / below;
                // What f32 arithmetic may lose, by the same estimate by which setup chooses f64.
                let room = (f[0].max(f[1]).max(f[2]) - f[0].min(f[1]).min(f[2])) * 1e-6 * ratio.sqrt() + 1e-6;
                assert!((want - f64::from(*got)).abs() <= room, "{round} {want} {got} {w:?}");
                checked += 1;
            }
            assert!((seen.z - 0.25 * 16_777_215.0).abs() < 1e-6);
        }
    }
    assert!(checked > 20_000, "{checked}");
}

#[test]
fn moving_by_whole_pixels_changes_no_bit() {
    let mut random = Random(6);
    for round in 0..400 {
        // Positions with 20 fraction bits can be moved exactly.
        let grid = |v: f64| (v * 1_048_576.0).round() / 1_048_576.0;
        let p = [[0.0; 2]; 3].map(|p| p.map(|_| grid(random.between(2.0, 30.0))));
        let w = [0.0; 3].map(|_| if round % 2 == 0 { 1.0 } else { random.between(0.5, 20.0) });
        let slots = [0, 1, 2].map(|_| (0..3).map(|_| random.between(-1.0, 3.0) as f32).collect::<Vec<_>>());
        let z = [0.0; 3].map(|_| random.unit());
        let draw = |dx: f64, dy: f64| {
            let mut canvas = TestCanvas::new(2048, 3, 1, 64, |_| {});
            let v = [0, 1, 2].map(|i: usize| vertex(p[i][0] + dx, p[i][1] + dy, z[i], w[i]));
            canvas.triangle(&v, &slots);
            let seen = canvas.seen();
            let at: Vec<_> = seen.iter().map(|s| [s.at[0] - dx as i32, s.at[1] - dy as i32]).collect();
            let values: Vec<_> = seen.iter().map(|s| (bits(&s.values), s.z.to_bits())).collect();
            (at, values)
        };
        if round % 40 < 38 {
            let (dx, dy) = (random.between(0.0, 2000.0).floor(), random.between(0.0, 2000.0).floor());
            assert_eq!(draw(0.0, 0.0), draw(dx, dy), "{round}");
        }
    }
}

#[test]
fn slivers_stay_within_their_corners() {
    let mut random = Random(7);
    let mut fragments = 0;
    let mut canvas = TestCanvas::new(128, 1, 1, 64, |_| {});
    for _ in 0..20_000 {
        let a = [random.between(0.0, 128.0), random.between(0.0, 128.0)];
        let b = [random.between(0.0, 128.0), random.between(0.0, 128.0)];
        let t = random.between(-0.2, 1.2);
        let c = [0, 1].map(|k: usize| a[k] + t * (b[k] - a[k]) + random.between(-0.003, 0.003));
        let slots = [0, 1, 2].map(|_| vec![random.unit() as f32]);
        let w = random.between(1.0, 50.0);
        let v = [vertex(a[0], a[1], 0.1, 1.0), vertex(b[0], b[1], 0.2, w), vertex(c[0], c[1], 0.3, 1.0)];
        canvas.triangle(&v, &slots);
        let (low, high) = slots.iter().fold((9.0f32, -9.0f32), |(l, h), s| (l.min(s[0]), h.max(s[0])));
        for seen in canvas.seen() {
            assert!((low..=high).contains(&seen.values[0]), "{} in {low}..{high}", seen.values[0]);
            let z = seen.z / 16_777_215.0;
            // By an eighth of the range a triangle's depth may agree with others in its plane.
            assert!((0.0749..=0.3251).contains(&z), "{z}");
            fragments += 1;
        }
    }
    assert!(fragments > 1000, "{fragments}");
}

/// Planes of a triangle with corners (0, 0), (8, 0), (0, 8) about the origin pixel.
pub(in crate::raster) fn planes(
    layout: &Layout,
    flat: bool,
    values: &[Vec<f32>; 3],
    w: [f64; 3],
    back: bool,
) -> (Planes, Vec<Plane>) {
    let mut plan = SetupPlan::new(Level::BASELINE);
    plan.set(layout, flat);
    let basis = Basis::triangle([[-2.5, -2.5], [5.5, -2.5], [-2.5, 5.5]], 64.0);
    let (mut of, mut pool) = (Planes::default(), PlaneBuffer::default());
    let corner = [&values[0][..], &values[1], &values[2]];
    let values = CornerValues { corner, provoking: corner[2], back, w };
    plan.planes(&basis, &values, &mut of, &mut pool);
    let planes = pool.all().alone[..pool.len()].to_vec();
    for level in Level::available() {
        let mut other = SetupPlan::new(level);
        other.set(layout, flat);
        let (mut of, mut pool) = (Planes::default(), PlaneBuffer::default());
        other.planes(&basis, &values, &mut of, &mut pool);
        assert!(pool.all().alone.iter().zip(&planes).all(|(a, b)| format!("{a:?}") == format!("{b:?}")), "{level:?}");
    }
    (of, planes)
}

#[test]
fn equal_w_and_equal_values_are_exact() {
    let layout = Layout { count: 2, stride: 2, ..Layout::default() };
    let values = [vec![0.1, 0.7], vec![0.1, 0.2], vec![0.1, -3.0]];
    for w in [3.0, 0.1, 7.77, 1e-30] {
        let (of, pool) = planes(&layout, false, &values, [w; 3], false);
        assert!(of.affine && of.wide == 0);
        assert_eq!(of.d, Linear { at: 1.0, x: 0.0, y: 0.0 });
        assert_eq!(pool[0], constant(0.1));
        assert_eq!(pool, planes(&layout, false, &values, [1.0; 3], false).1);
    }
    let (of, pool) = planes(&layout, false, &values, [1.0, 2.0, 5.0], false);
    assert!(!of.affine);
    assert_eq!(pool[0], constant(0.1));
}

#[test]
fn flat_shading_and_back_faces_choose_colours() {
    // Colour, secondary colour, fog, and the back colours behind them.
    let layout = Layout {
        color: Some(0),
        secondary: Some(4),
        fog: Some(7),
        count: 8,
        back: Some(8),
        stride: 15,
        ..Layout::default()
    };
    let values = [0.0f32, 1.0, 2.0].map(|i| (0..15).map(|k| i * 100.0 + k as f32).collect::<Vec<_>>());
    let corner_values = |pool: &[Plane], of: &Planes, k: usize| {
        [[-2.5, -2.5], [5.5, -2.5], [-2.5, 5.5]].map(|[x, y]: [f32; 2]| value(&pool[k], of, x, y))
    };
    for (flat, back) in [(false, false), (false, true), (true, false), (true, true)] {
        let (of, pool) = planes(&layout, flat, &values, [1.0; 3], back);
        for k in 0..8 {
            let from = if back && k < 7 { k + 8 } else { k };
            let want = [0, 1, 2].map(|i: usize| values[if flat && k < 7 { 2 } else { i }][from]);
            let got = corner_values(&pool, &of, k);
            for (want, got) in want.into_iter().zip(got) {
                assert!((want - got).abs() < 1e-3, "slot {k}, flat {flat}, back {back}: {want} {got}");
            }
        }
    }
}

#[test]
fn values_that_are_no_numbers_do_no_harm() {
    let odd = [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, 0.0];
    let layout = Layout { count: 1, stride: 1, ..Layout::default() };
    for a in odd {
        for b in odd {
            for w in [[1.0; 3], [1.0, 2.0, 3.0], [f64::NAN, 1.0, 1.0], [0.0, 1.0, -1.0], [1e-300, 1e300, 1.0]] {
                let (of, pool) = planes(&layout, false, &[vec![a], vec![b], vec![0.5]], w, false);
                let p = pool[0];
                assert!((p.n0 + p.nx + p.ny).is_finite(), "{a} {b} {w:?} {p:?}");
                assert!((of.d.at + of.d.x + of.d.y).is_finite(), "{w:?}");
            }
        }
    }
    let mut canvas = TestCanvas::new(16, 1, 1, 64, |_| {});
    for bad in [f64::NAN, f64::INFINITY, 1e300, -1e38] {
        for i in 0..3 {
            let mut v = [vertex(1.0, 1.0, 0.5, 1.0), vertex(15.0, 2.0, 0.5, 1.0), vertex(3.0, 14.0, 0.5, 2.0)];
            v[i] = Vertex { window: [bad; 3], clip: [bad; 4], ..v[i] };
            canvas.triangle(&v, &[vec![0.0], vec![1.0], vec![0.5]]);
            v[i].snapped = [i32::MIN, i32::MAX];
            canvas.triangle(&v, &[vec![0.0], vec![1.0], vec![]]);
        }
    }
    for seen in canvas.seen() {
        assert!(seen.z.is_finite() && (0.0..=1.0).contains(&seen.values[0]), "{seen:?}");
    }
}
