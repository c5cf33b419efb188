//! Clipping: what is left of a primitive, and that it does not depend on the order of its vertices.

use super::*;
use crate::state::primitive::PrimitiveMode;
use glam::DMat4;

fn corners(got: &[Got]) -> Vec<[f64; 4]> {
    let mut all: Vec<[f64; 4]> = got
        .iter()
        .flat_map(|g| match g {
            Got::Triangle(v, ..) | Got::Line(v, ..) => v.iter().map(|v| v.0.clip).collect(),
            Got::Point(v) => vec![v.0.clip],
        })
        .collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all.dedup();
    all
}

#[test]
fn near_cuts_a_triangle_to_a_quadrilateral() {
    let given = [at(0.0, 0.0, -3.0), at(-0.5, 0.0, 1.0), at(0.5, 0.0, 1.0)];
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &given);
    assert_eq!(got.len(), 2);
    // Half way between z = -3 and z = 1 is z = -1, exactly on the near plane.
    assert_eq!(
        corners(&got),
        [[-0.5, 0.0, 1.0, 1.0], [-0.25, 0.0, -1.0, 1.0], [0.25, 0.0, -1.0, 1.0], [0.5, 0.0, 1.0, 1.0]]
    );
    let Got::Triangle(_, _, first) = got[0] else { panic!() };
    let Got::Triangle(_, _, second) = got[1] else { panic!() };
    assert_eq!((first, second), ([true, true, false], [false, true, true]));
}

#[test]
fn clipped_edges_keep_their_flags_and_new_ones_are_boundaries() {
    let mut given = [at(0.0, 0.0, -3.0), at(-0.5, 0.0, 1.0), at(0.5, 0.0, 1.0)];
    given.iter_mut().for_each(|v| v.current.edge_flag = false);
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &given);
    let flags: Vec<bool> = got
        .iter()
        .flat_map(|g| match g {
            Got::Triangle(_, _, edges) => edges.to_vec(),
            _ => vec![],
        })
        .collect();
    assert_eq!(flags.iter().filter(|f| **f).count(), 1, "only the edge along the plane: {flags:?}");
}

#[test]
fn sides_are_left_to_the_rasteriser_up_to_the_guard_band() {
    let given = [at(-5.0, 0.0, 0.0), at(5.0, 0.0, 0.0), at(0.0, 5.0, 0.0)];
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &given);
    assert_eq!(corners(&got).len(), 3);
    let given = [at(-1e30, -0.5, 0.0), at(1e30, -0.5, 0.0), at(0.0, 1e30, 0.0)];
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &given);
    assert!(!got.is_empty());
    for c in corners(&got) {
        assert!((50.0 + 50.0 * c[0] / c[3]).abs() <= 32767.001, "{c:?}");
    }
}

#[test]
fn only_what_has_a_positive_w_is_drawn() {
    let v = |x: f32, y: f32, w: f32| Given { position: [x, y, 0.0, w], ..at(0.0, 0.0, 0.0) };
    for k in [1e-30f32, 1.0, 1e30] {
        let negative = [v(0.0, 0.0, -k), v(0.5 * k, 0.0, -k), v(0.0, 0.5 * k, -k)];
        assert_eq!(draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &negative), []);
        let crossing = [v(-0.5 * k, -0.5 * k, k), v(0.5 * k, -0.5 * k, k), v(0.0, 0.5 * k, -k)];
        let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Triangles, &crossing);
        assert!(!got.is_empty());
        for c in corners(&got) {
            assert!(c[3] > 0.0);
        }
    }
}

#[test]
fn lines_end_at_the_view_volume() {
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Lines, &[at(-3.0, 0.0, 0.0), at(3.0, 0.0, 0.0)]);
    assert_eq!(corners(&got), [[-1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0]]);
    let Got::Line(v, ..) = &got[0] else { panic!() };
    assert_eq!((v[0].0.window[0], v[1].0.window[0]), (0.0, 100.0));
    assert_eq!(
        draw(&plain_state(), &color_layout(), PrimitiveMode::Lines, &[at(-3.0, 0.0, 0.0), at(-2.0, 2.0, 0.0)]),
        []
    );
}

/// Numbers that look random and are the same every time.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn a_clipped_edge_has_the_same_bits_from_both_sides_and_for_both_halves() {
    let mut seed = 7;
    let mut clipped = 0;
    for _ in 0..2000 {
        let mut v = || {
            let mut v = at(0.0, 0.0, 0.0);
            v.position = std::array::from_fn(|_| (random(&mut seed) * 2.0 - 1.0) as f32);
            v.position[3] = 1.0;
            v.current.color = std::array::from_fn(|_| random(&mut seed) as f32);
            v
        };
        let (a, b) = (v(), v());
        let plane: [f64; 4] = std::array::from_fn(|_| random(&mut seed) * 2.0 - 1.0);
        let mut state = plain_state();
        state.transform.clip_plane_enabled[2] = true;
        state.transform.clip_planes[2] = plane;
        let ends = |state: &State, given: &[Given]| -> Vec<(Vertex, Vec<f32>)> {
            match run(Level::BASELINE, 64, state, &color_layout(), PrimitiveMode::Lines, given).pop() {
                Some(Got::Line(v, ..)) => v,
                _ => vec![],
            }
        };
        let forth = ends(&state, &[a.clone(), b.clone()]);
        let mut back = ends(&state, &[b.clone(), a.clone()]);
        back.reverse();
        assert_eq!(forth, back);
        state.transform.clip_planes[2] = plane.map(|v| -v);
        let other = ends(&state, &[a, b]);
        if let ([p, q], [r, s]) = (forth.as_slice(), other.as_slice()) {
            // Cut in two: the halves meet in one vertex.
            clipped += 1;
            assert!(p == s || q == r, "{forth:?} {other:?}");
        }
    }
    assert!(clipped > 500, "{clipped}");
}

#[test]
fn a_floor_under_the_eye_reaches_from_the_near_plane_to_the_horizon() {
    let mut state = plain_state();
    let (near, far) = (1e-6, 1e9);
    *state.transform.projection.top_mut() = DMat4::from_cols_array(&[
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        -(far + near) / (far - near),
        -1.0,
        0.0,
        0.0,
        -2.0 * far * near / (far - near),
        0.0,
    ]);
    let given = [at(0.0, -1.0, 100.0), at(1e6, -1.0, -1e6), at(-1e6, -1.0, -1e6)];
    let got = draw(&state, &color_layout(), PrimitiveMode::Triangles, &given);
    assert!(!got.is_empty());
    let top = corners(&got).iter().map(|c| 50.0 + 50.0 * c[1] / c[3]).fold(f64::MIN, f64::max);
    assert!((top - (50.0 - 50.0 / 1e6)).abs() < 1e-9, "{top}");
}

#[test]
fn flat_shading_keeps_its_colour_through_clipping() {
    let mut state = plain_state();
    state.lighting.shade_model = crate::state::lighting::ShadeModel::Flat;
    let mut given = [at(0.0, 0.0, -3.0), at(-0.5, 0.0, 1.0), at(0.5, 0.0, 1.0)];
    for (v, k) in given.iter_mut().zip([0.25, 0.5, 0.75]) {
        v.current.color = [k; 4];
    }
    for got in draw(&state, &color_layout(), PrimitiveMode::Triangles, &given) {
        let Got::Triangle(v, provoking, _) = got else { panic!() };
        assert_eq!(v[provoking].1, [0.75; 4]);
    }
}
