//! Which vertices make which primitives: tables 2.x of section 2.6 by number of vertex.

use super::*;
use crate::raster::vertex::outcode;
use crate::state::primitive::PrimitiveMode;

/// Vertices whose x tells their number.
fn numbered(n: usize) -> Vec<Given> {
    (0..n).map(|i| at(i as f32 / 128.0, (i % 7) as f32 / 8.0, 0.0)).collect()
}

fn number(v: &(Vertex, Vec<f32>)) -> usize {
    (v.0.clip[0] * 128.0) as usize
}

fn triangles(mode: PrimitiveMode, n: usize) -> Vec<([usize; 3], usize, [bool; 3])> {
    draw(&plain_state(), &color_layout(), mode, &numbered(n))
        .iter()
        .map(|got| match got {
            Got::Triangle(v, provoking, edges) => {
                ([number(&v[0]), number(&v[1]), number(&v[2])], number(&v[*provoking]), *edges)
            }
            other => panic!("{other:?} is no triangle"),
        })
        .collect()
}

fn lines(mode: PrimitiveMode, n: usize) -> Vec<([usize; 2], usize, bool)> {
    draw(&plain_state(), &color_layout(), mode, &numbered(n))
        .iter()
        .map(|got| match got {
            Got::Line(v, provoking, restart) => ([number(&v[0]), number(&v[1])], number(&v[*provoking]), *restart),
            other => panic!("{other:?} is no line"),
        })
        .collect()
}

const ALL: [bool; 3] = [true; 3];

#[test]
fn triangles_and_what_is_left_over() {
    assert_eq!(triangles(PrimitiveMode::Triangles, 8), [([0, 1, 2], 2, ALL), ([3, 4, 5], 5, ALL)]);
    assert_eq!(triangles(PrimitiveMode::Triangles, 2), []);
    assert_eq!(
        triangles(PrimitiveMode::TriangleStrip, 5),
        [([0, 1, 2], 2, ALL), ([2, 1, 3], 3, ALL), ([2, 3, 4], 4, ALL)]
    );
    assert_eq!(triangles(PrimitiveMode::TriangleFan, 4), [([0, 1, 2], 2, ALL), ([0, 2, 3], 3, ALL)]);
}

#[test]
fn quadrilaterals_have_a_diagonal_that_is_no_edge() {
    let got = triangles(PrimitiveMode::Quads, 11);
    assert_eq!(got.len(), 4);
    assert_eq!(got[0], ([0, 1, 3], 3, [true, false, true]));
    assert_eq!(got[1], ([1, 2, 3], 3, [true, true, false]));
    assert_eq!(got[3].0, [5, 6, 7]);
    // The outline of the first is 0 1 3 2, of the second 2 3 5 4.
    let got = triangles(PrimitiveMode::QuadStrip, 7);
    assert_eq!(got.len(), 4);
    assert_eq!(got[0], ([2, 0, 3], 3, [true, false, true]));
    assert_eq!(got[1], ([0, 1, 3], 3, [true, true, false]));
    assert_eq!(got[2].0, [4, 2, 5]);
}

#[test]
fn a_polygon_is_a_fan_with_the_colour_of_its_first_vertex() {
    assert_eq!(triangles(PrimitiveMode::Polygon, 3), [([0, 1, 2], 0, ALL)]);
    assert_eq!(
        triangles(PrimitiveMode::Polygon, 5),
        [
            ([0, 1, 2], 0, [true, true, false]),
            ([0, 2, 3], 0, [false, true, false]),
            ([0, 3, 4], 0, [false, true, true])
        ]
    );
    let mut given = numbered(4);
    given[1].current.edge_flag = false;
    let got = draw(&plain_state(), &color_layout(), PrimitiveMode::Polygon, &given);
    assert!(matches!(&got[0], Got::Triangle(_, 0, [true, false, false])), "{:?}", got[0]);
}

#[test]
fn lines_strips_and_loops() {
    assert_eq!(lines(PrimitiveMode::Lines, 5), [([0, 1], 1, true), ([2, 3], 3, true)]);
    assert_eq!(lines(PrimitiveMode::LineStrip, 4), [([0, 1], 1, true), ([1, 2], 2, false), ([2, 3], 3, false)]);
    assert_eq!(lines(PrimitiveMode::LineLoop, 3), [([0, 1], 1, true), ([1, 2], 2, false), ([2, 0], 0, false)]);
    assert_eq!(lines(PrimitiveMode::LineLoop, 1), []);
    assert_eq!(lines(PrimitiveMode::LineLoop, 2), [([0, 1], 1, true), ([1, 0], 0, false)]);
}

#[test]
fn points_are_drawn_inside_only() {
    let given = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0001, 0.0, 0.0), at(0.0, 0.0, -2.0)];
    assert_eq!(draw(&plain_state(), &color_layout(), PrimitiveMode::Points, &given).len(), 2);
}

#[test]
fn long_primitives_cross_batches() {
    for mode in [
        PrimitiveMode::TriangleStrip,
        PrimitiveMode::TriangleFan,
        PrimitiveMode::Polygon,
        PrimitiveMode::QuadStrip,
        PrimitiveMode::Triangles,
        PrimitiveMode::Quads,
    ] {
        let n = 125;
        let want = match mode {
            PrimitiveMode::Triangles => n / 3,
            PrimitiveMode::Quads => n / 4 * 2,
            PrimitiveMode::QuadStrip => n - 3,
            _ => n - 2,
        };
        assert_eq!(triangles(mode, n).len(), want, "mode {mode:?}");
    }
    assert_eq!(lines(PrimitiveMode::LineLoop, 125).len(), 125);
}

#[test]
fn the_viewport_divides_scales_and_snaps() {
    let mut state = plain_state();
    (state.viewport.x, state.viewport.y) = (10, 20);
    (state.viewport.near, state.viewport.far) = (0.25, 0.75);
    let given = [Given { position: [1.0, -1.0, 0.5, 2.0], current: Current::default() }];
    let got = draw(&state, &color_layout(), PrimitiveMode::Points, &given);
    let Got::Point((v, slots)) = &got[0] else { panic!() };
    assert_eq!(v.clip, [1.0, -1.0, 0.5, 2.0]);
    assert_eq!(v.window, [10.0 + 75.0, 20.0 + 25.0, 0.5 + 0.25 * 0.25]);
    assert_eq!(v.snapped, [85 * 256, 45 * 256]);
    assert_eq!((v.outcode, v.point_size), (0, 1.0));
    assert_eq!(slots, &[1.0; 4]);
}

#[test]
fn wild_positions_are_dropped_and_nothing_panics() {
    let wild = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE, 0.0, -1.0];
    let mut given = Vec::new();
    for x in wild {
        for w in wild {
            given.extend([
                at(0.0, 0.0, 0.0),
                at(0.5, 0.0, 0.0),
                Given { position: [x, 0.5, 0.0, w], ..at(0.0, 0.0, 0.0) },
            ]);
        }
    }
    for mode in PrimitiveMode::ALL {
        for got in draw(&plain_state(), &color_layout(), mode, &given) {
            let vertices = match got {
                Got::Triangle(v, ..) | Got::Line(v, ..) => v,
                Got::Point(v) => vec![v],
            };
            for (v, _) in vertices {
                assert!(v.window.iter().all(|c| c.is_finite() && c.abs() < 40000.0), "{v:?}");
                assert_eq!(v.outcode & outcode::NAN, 0);
            }
        }
    }
}

#[test]
fn small_primitives_share_batches() {
    let mut pipe = VertexPipeline::new(Level::BASELINE, 64);
    pipe.rebuild(&plain_state(), &color_layout(), Wants::default());
    let mut out = Collect::default();
    for i in 0..10 {
        pipe.begin(PrimitiveMode::Triangles);
        for v in numbered(3 + i % 2) {
            assert!(!pipe.vertex(v.position, &v.current));
        }
        assert!(!pipe.end());
    }
    pipe.run(&mut out);
    assert_eq!(out.0.len(), 10);
    assert!(!pipe.is_waiting());
}
