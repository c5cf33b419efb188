//! Evaluators (section 5.1): values by the definition of the polynomials in f64, read through feedback.

use crate::support::Random;
use fixedgl::Context;
use fixedgl::enums::*;

/// sum B(i, n, t) p_i by binomials and powers.
fn bernstein(points: &[f64], t: f64) -> f64 {
    let n = points.len() - 1;
    let binomial = |i: usize| (0..i).fold(1.0, |b, k| b * (n - k) as f64 / (k + 1) as f64);
    points.iter().enumerate().map(|(i, p)| binomial(i) * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32) * p).sum()
}

/// The vertices that a drawing gives: x, y, z, w, colour, texture coordinates of each.
fn vertices(gl: &mut Context, draw: impl Fn(&mut Context)) -> Vec<[f32; 12]> {
    gl.feedback_buffer(1 << 20, GL_4D_COLOR_TEXTURE);
    gl.render_mode(GL_FEEDBACK);
    gl.begin(GL_POINTS);
    draw(gl);
    gl.end();
    assert!(gl.render_mode(GL_RENDER) >= 0);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    gl.feedback_values().chunks(13).map(|v| v[1..].try_into().expect("a vertex")).collect()
}

/// A context in which window coordinates are half of object coordinates.
fn context() -> Context {
    let mut gl = Context::new(64, 64);
    gl.ortho(0.0, 128.0, 0.0, 128.0, -1.0, 1.0);
    gl
}

#[test]
fn curves_are_their_polynomials() {
    let mut random = Random(8);
    for order in 1..=30usize {
        let mut gl = context();
        let stride = 4 + random.below(3) as usize;
        let points: Vec<f64> =
            (0..order * stride).map(|i| if i % stride == 2 { 0.0 } else { random.range(10.0, 100.0) }).collect();
        let colors: Vec<f32> = (0..order * 4).map(|_| random.range(0.0, 1.0) as f32).collect();
        gl.map1d(GL_MAP1_VERTEX_3, -1.0, 3.0, stride as i32, order as i32, &points);
        gl.map1f(GL_MAP1_COLOR_4, 0.0, 2.0, 4, order as i32, &colors);
        gl.enable(GL_MAP1_VERTEX_3);
        gl.enable(GL_MAP1_COLOR_4);
        for u in [-1.0, -0.3, 0.0, 0.5, 1.25, 2.0, 3.0] {
            let got = vertices(&mut gl, |gl| gl.eval_coord1d(u));
            let axis = |k: usize| points.iter().skip(k).step_by(stride).copied().collect::<Vec<_>>();
            let inside = [0, 1].map(|k| bernstein(&axis(k), (u + 1.0) / 4.0));
            for k in 0..2 {
                assert!((f64::from(got[0][k]) - inside[k] / 2.0).abs() < 1e-5 * 100.0, "order {order} u {u}");
            }
            let color: Vec<f64> = colors.iter().step_by(4).map(|c| f64::from(*c)).collect();
            let want = bernstein(&color, u / 2.0).clamp(0.0, 1.0);
            if (0.0..=2.0).contains(&u) {
                assert!((f64::from(got[0][4]) - want).abs() < 1e-5, "order {order} u {u}: {} {want}", got[0][4]);
            }
        }
    }
}

#[test]
fn surfaces_are_their_polynomials_and_grids_reach_their_ends() {
    let mut random = Random(9);
    for (uorder, vorder) in [(1, 1), (2, 2), (4, 4), (3, 7), (30, 2)] {
        let mut gl = context();
        let points: Vec<f32> =
            (0..uorder * vorder * 3).map(|i| if i % 3 == 2 { 0.0 } else { random.range(10.0, 100.0) as f32 }).collect();
        // The u index runs faster in memory than the v index.
        let (us, vs) = (3, 3 * uorder);
        gl.map2f(GL_MAP2_VERTEX_3, 0.0, 1.0, us as i32, uorder as i32, 5.0, 9.0, vs as i32, vorder as i32, &points);
        gl.enable(GL_MAP2_VERTEX_3);
        gl.map_grid2d(7, 0.0, 1.0, 3, 5.0, 9.0);
        for (i, j) in [(0, 0), (7, 3), (7, 0), (2, 1), (3, 2), (9, 1)] {
            let (u, v) = (f64::from(i) / 7.0, f64::from(j) / 3.0);
            let got = vertices(&mut gl, |gl| gl.eval_point2(i, j));
            let same = vertices(&mut gl, |gl| gl.eval_coord2d(u, 5.0 + 4.0 * v));
            for k in 0..2 {
                let rows: Vec<f64> = (0..uorder)
                    .map(|a| {
                        let row: Vec<f64> = (0..vorder).map(|b| f64::from(points[a * us + b * vs + k])).collect();
                        bernstein(&row, v)
                    })
                    .collect();
                let want = bernstein(&rows, u) / 2.0;
                if (0.0..64.0).contains(&want) && !got.is_empty() {
                    assert!(
                        (f64::from(got[0][k]) - want).abs() < 1e-4 * (1.0 + want.abs()),
                        "{uorder} {vorder} {i} {j}"
                    );
                    assert!((got[0][k] - same[0][k]).abs() < 1e-3);
                }
            }
        }
    }
}

#[test]
fn the_map_with_the_most_components_counts_and_current_values_stay() {
    let mut gl = context();
    gl.color4f(0.25, 0.5, 0.75, 1.0);
    gl.tex_coord4f(9.0, 8.0, 7.0, 6.0);
    gl.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 1, &[10.0, 20.0, 0.0]);
    gl.map1f(GL_MAP1_VERTEX_4, 0.0, 1.0, 4, 1, &[60.0, 80.0, 0.0, 2.0]);
    gl.map1f(GL_MAP1_TEXTURE_COORD_1, 0.0, 1.0, 1, 1, &[0.5]);
    gl.map1f(GL_MAP1_TEXTURE_COORD_2, 0.0, 1.0, 2, 1, &[0.1, 0.2]);
    gl.map1f(GL_MAP1_COLOR_4, 0.0, 1.0, 4, 1, &[1.0, 0.0, 0.0, 0.5]);
    let colored = [0.25, 0.5, 0.75, 1.0];
    // Without a vertex map there is no vertex, whatever else is enabled.
    gl.enable(GL_MAP1_COLOR_4);
    assert!(vertices(&mut gl, |gl| gl.eval_coord1f(0.5)).is_empty());
    gl.disable(GL_MAP1_COLOR_4);
    gl.enable(GL_MAP1_VERTEX_3);
    let got = vertices(&mut gl, |gl| gl.eval_coord1f(0.5));
    assert_eq!(got[0][..4], [5.0, 10.0, 0.5, 1.0]);
    assert_eq!(got[0][4..8], colored);
    assert_eq!(got[0][8..], [9.0, 8.0, 7.0, 6.0]);
    gl.enable(GL_MAP1_VERTEX_4);
    gl.enable(GL_MAP1_TEXTURE_COORD_1);
    gl.enable(GL_MAP1_TEXTURE_COORD_2);
    gl.enable(GL_MAP1_COLOR_4);
    let got = vertices(&mut gl, |gl| gl.eval_coord1f(0.5));
    assert_eq!(got[0][..4], [15.0, 20.0, 0.5, 2.0]);
    assert_eq!(got[0][4..8], [1.0, 0.0, 0.0, 0.5]);
    assert_eq!(got[0][8..], [0.1, 0.2, 0.0, 1.0]);
    let mut now = [0.0f32; 4];
    gl.get_floatv(GL_CURRENT_COLOR, &mut now);
    assert_eq!(now, colored);
}

#[test]
fn automatic_normals_are_perpendicular_to_the_surface() {
    // A quarter of a cylinder is not polynomial, but this graph is: z = x y / 50 over a square.
    let mut gl = context();
    let points: Vec<f32> = [[0.0, 0.0], [0.0, 100.0], [100.0, 0.0], [100.0, 100.0]]
        .iter()
        .flat_map(|[x, y]| [*x, *y, x * y / 5000.0])
        .collect();
    gl.map2f(GL_MAP2_VERTEX_3, 0.0, 1.0, 6, 2, 0.0, 1.0, 3, 2, &points);
    gl.enable(GL_MAP2_VERTEX_3);
    gl.enable(GL_AUTO_NORMAL);
    // The normal as texture coordinates.
    gl.load_identity();
    gl.enable(GL_TEXTURE_GEN_S);
    gl.enable(GL_TEXTURE_GEN_T);
    gl.enable(GL_TEXTURE_GEN_R);
    for c in [GL_S, GL_T, GL_R] {
        gl.tex_geni(c, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP as i32);
    }
    gl.scalef(0.01, 0.01, 0.01);
    for (u, v) in [(0.0f64, 0.0f64), (0.5, 0.25), (1.0, 1.0)] {
        gl.matrix_mode(GL_MODELVIEW);
        let got = vertices(&mut gl, |gl| gl.eval_coord2d(u, v));
        // Before the modelview matrix, whose inverse transpose scales by 100.
        let (x, y) = (100.0 * u, 100.0 * v);
        let n = [-y / 5000.0, -x / 5000.0, 1.0];
        let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        for k in 0..3 {
            let want = 100.0 * n[k] / length;
            assert!((f64::from(got[0][8 + k]) - want).abs() < 1e-3, "{u} {v}: {:?} {n:?}", &got[0][8..]);
        }
    }
}

#[test]
fn meshes_draw_what_the_specification_writes() {
    let setup = |gl: &mut Context| {
        let points: Vec<f32> =
            (0..9).flat_map(|i| [20.0 + 40.0 * (i / 3) as f32, 10.0 + 50.0 * (i % 3) as f32, 0.0]).collect();
        gl.map2f(GL_MAP2_VERTEX_3, 0.0, 1.0, 9, 3, 0.0, 1.0, 3, 3, &points);
        gl.enable(GL_MAP2_VERTEX_3);
        gl.map_grid2f(8, 0.0, 1.0, 5, 0.0, 1.0);
    };
    let by_hand = |gl: &mut Context, mode: GLenum| match mode {
        GL_POINT => {
            gl.begin(GL_POINTS);
            (0..=5).for_each(|j| (0..=8).for_each(|i| gl.eval_point2(i, j)));
            gl.end();
        }
        GL_LINE => {
            for j in 0..=5 {
                gl.begin(GL_LINE_STRIP);
                (0..=8).for_each(|i| gl.eval_point2(i, j));
                gl.end();
            }
            for i in 0..=8 {
                gl.begin(GL_LINE_STRIP);
                (0..=5).for_each(|j| gl.eval_point2(i, j));
                gl.end();
            }
        }
        _ => {
            for j in 0..5 {
                gl.begin(GL_QUAD_STRIP);
                for i in 0..=8 {
                    gl.eval_point2(i, j);
                    gl.eval_point2(i, j + 1);
                }
                gl.end();
            }
        }
    };
    for mode in [GL_POINT, GL_LINE, GL_FILL] {
        let (mut a, mut b) = (context(), context());
        setup(&mut a);
        setup(&mut b);
        a.eval_mesh2(mode, 0, 8, 0, 5);
        by_hand(&mut b, mode);
        assert_eq!(a.get_error(), GL_NO_ERROR);
        let (a, b) = (a.pixels(), b.pixels());
        assert!(a == b && a.iter().any(|v| *v != 0), "{mode:#X}");
    }
}

#[test]
fn errors_and_queries_are_the_specifications() {
    let mut gl = context();
    type Call = fn(&mut Context);
    let rows: [(&str, Call, GLenum); 11] = [
        ("no map", |gl| gl.map1f(GL_MAP2_VERTEX_3, 0.0, 1.0, 3, 1, &[0.0; 3]), GL_INVALID_ENUM),
        ("empty domain", |gl| gl.map1f(GL_MAP1_VERTEX_3, 1.0, 1.0, 3, 1, &[0.0; 3]), GL_INVALID_VALUE),
        ("stride", |gl| gl.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 2, 1, &[0.0; 3]), GL_INVALID_VALUE),
        ("no order", |gl| gl.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 0, &[0.0; 3]), GL_INVALID_VALUE),
        ("order", |gl| gl.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 31, &[0.0; 93]), GL_INVALID_VALUE),
        ("v stride", |gl| gl.map2f(GL_MAP2_NORMAL, 0.0, 1.0, 3, 1, 0.0, 1.0, 1, 1, &[0.0; 3]), GL_INVALID_VALUE),
        ("grid", |gl| gl.map_grid1f(0, 0.0, 1.0), GL_INVALID_VALUE),
        ("grids", |gl| gl.map_grid2f(1, 0.0, 1.0, -1, 0.0, 1.0), GL_INVALID_VALUE),
        ("mesh", |gl| gl.eval_mesh1(GL_FILL, 0, 1), GL_INVALID_ENUM),
        ("meshes", |gl| gl.eval_mesh2(GL_TRIANGLES, 0, 1, 0, 1), GL_INVALID_ENUM),
        (
            "another unit",
            |gl| {
                gl.active_texture(GL_TEXTURE1);
                gl.map1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 1, &[0.0; 3]);
                gl.active_texture(GL_TEXTURE0);
            },
            GL_INVALID_OPERATION,
        ),
    ];
    for (name, call, want) in rows {
        call(&mut gl);
        assert_eq!(gl.get_error(), want, "{name}");
    }
    gl.map2d(GL_MAP2_TEXTURE_COORD_2, -1.0, 2.0, 2, 2, 3.0, 5.0, 6, 3, &(0..18).map(f64::from).collect::<Vec<_>>());
    let mut values = [0.0; 12];
    gl.get_mapdv(GL_MAP2_TEXTURE_COORD_2, GL_COEFF, &mut values);
    assert_eq!(values, [0.0, 1.0, 6.0, 7.0, 12.0, 13.0, 2.0, 3.0, 8.0, 9.0, 14.0, 15.0]);
    let mut order = [0; 2];
    gl.get_mapiv(GL_MAP2_TEXTURE_COORD_2, GL_ORDER, &mut order);
    assert_eq!(order, [2, 3]);
    let mut domain = [0.0f32; 4];
    gl.get_mapfv(GL_MAP2_TEXTURE_COORD_2, GL_DOMAIN, &mut domain);
    assert_eq!(domain, [-1.0, 2.0, 3.0, 5.0]);
    let mut point = [7.0f32; 4];
    gl.get_mapfv(GL_MAP1_VERTEX_4, GL_COEFF, &mut point);
    assert_eq!(point, [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    // A mesh of absurd size says so at once.
    gl.enable(GL_MAP2_VERTEX_3);
    gl.eval_mesh2(GL_FILL, i32::MIN, i32::MAX, i32::MIN, i32::MAX);
    assert_eq!(gl.get_error(), GL_OUT_OF_MEMORY);
}
