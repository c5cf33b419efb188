//! Fog (OpenGL 1.5, section 3.10): the three modes with depth and with fog coordinates against the oracle, the initial
//! state, the errors.

use crate::oracle::fragment::Fog;
use crate::support::compare::{EDGES, compare};
use crate::support::scenes::heap;
use crate::support::{get_f, get_i, raises};
use fixedgl::Context;
use fixedgl::enums::*;

#[test]
fn the_initial_state_is_the_tables_and_errors_are_told() {
    let mut cx = Context::new(4, 4);
    assert_eq!(get_i(&mut cx, GL_FOG), 0);
    assert_eq!(get_i(&mut cx, GL_FOG_MODE) as u32, GL_EXP);
    assert_eq!(get_f::<1>(&mut cx, GL_FOG_DENSITY), [1.0]);
    assert_eq!(get_f::<1>(&mut cx, GL_FOG_START), [0.0]);
    assert_eq!(get_f::<1>(&mut cx, GL_FOG_END), [1.0]);
    assert_eq!(get_f::<4>(&mut cx, GL_FOG_COLOR), [0.0; 4]);
    assert_eq!(get_i(&mut cx, GL_FOG_COORDINATE_SOURCE) as u32, GL_FRAGMENT_DEPTH);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.fogf(GL_FOG_DENSITY, -1.0));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.fogi(GL_FOG_MODE, GL_NEAREST));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.fogf(GL_LIGHT0, 1.0));
    assert_eq!(get_f::<1>(&mut cx, GL_FOG_DENSITY), [1.0]);
}

#[test]
fn every_mode_and_source_agrees_with_the_oracle() {
    for mode in [GL_LINEAR, GL_EXP, GL_EXP2] {
        for from_coordinate in [false, true] {
            let mut scene = heap(96, 96, 12, 1.0, 8);
            scene.vertex.fog_from_coordinate = from_coordinate;
            let color = [0.5, 0.75, 0.125, 1.0];
            scene.fog = Some(Fog { mode, density: 0.1875, start: 2.0, end: 11.0, color });
            let name = format!("fog {} from coordinate {from_coordinate}", fixedgl::enums::name(mode));
            compare(&scene, EDGES).within_one_lsb(&name);
        }
    }
}

#[test]
fn every_distance_mode_agrees_with_the_oracle() {
    let mut cx = Context::new(4, 4);
    assert_eq!(get_i(&mut cx, GL_FOG_DISTANCE_MODE_NV) as u32, GL_EYE_PLANE_ABSOLUTE_NV);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.fogi(GL_FOG_DISTANCE_MODE_NV, GL_EYE_LINEAR));
    for distance in [GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV] {
        cx.fogiv(GL_FOG_DISTANCE_MODE_NV, &[distance as i32]);
        assert_eq!(get_i(&mut cx, GL_FOG_DISTANCE_MODE_NV) as u32, distance);
        for mode in [GL_LINEAR, GL_EXP] {
            let mut scene = heap(96, 96, 12, 1.0, 8);
            scene.vertex.fog_distance = distance;
            let color = [0.5, 0.75, 0.125, 1.0];
            // Eye z is negative in front of the eye.
            let (start, end) = if distance == GL_EYE_PLANE { (-2.0, -11.0) } else { (2.0, 11.0) };
            scene.fog = Some(Fog { mode, density: 0.1875, start, end, color });
            let name = format!("fog distance {}", fixedgl::enums::name(distance));
            compare(&scene, EDGES).within_one_lsb(&name);
        }
    }
}

#[test]
fn the_colour_sum_comes_before_fog() {
    let mut scene = heap(96, 96, 12, 1.0, 18);
    scene.color_sum = true;
    compare(&scene, EDGES).within_one_lsb("colour sum");
    scene.fog = Some(Fog { density: 0.25, color: [1.0, 0.0, 0.0, 0.0], ..Fog::default() });
    compare(&scene, EDGES).within_one_lsb("colour sum and fog");
}

#[test]
fn the_distance_is_that_of_the_fragment_where_a_primitive_reaches_behind_the_eye() {
    // z from -8 to 4 in a parallel projection, which draws what lies behind the eye: 3.10 takes |z| of each fragment.
    let n = 96;
    let mut cx = Context::new(n, 1);
    cx.matrix_mode(GL_PROJECTION);
    cx.ortho(0.0, f64::from(n), 0.0, 1.0, -10.0, 10.0);
    cx.enable(GL_FOG);
    cx.fogi(GL_FOG_MODE, GL_LINEAR as i32);
    cx.fogf(GL_FOG_START, 0.0);
    cx.fogf(GL_FOG_END, 8.0);
    cx.fogfv(GL_FOG_COLOR, &[0.0; 4]);
    for mode in [GL_QUADS, GL_LINES] {
        cx.clear(GL_COLOR_BUFFER_BIT);
        cx.matrix_mode(GL_MODELVIEW);
        cx.begin(mode);
        let (x, ys): (f64, &[f64]) = (f64::from(n), if mode == GL_QUADS { &[0.0, 1.0] } else { &[0.5] });
        for (x, z, ys) in [(0.0, -8.0, ys.to_vec()), (x, 4.0, ys.iter().rev().copied().collect())] {
            ys.iter().for_each(|y| cx.vertex3d(x, *y, z));
        }
        cx.end();
        // A line leaves out its last fragment.
        for (i, p) in crate::support::pixels(&mut cx, n, 1).iter().enumerate().take(n as usize - 1) {
            let z = -8.0 + 12.0 * (i as f64 + 0.5) / f64::from(n);
            let want = 255.0 * (8.0 - z.abs()) / 8.0;
            assert!((f64::from(p[0]) - want).abs() < 0.51, "{mode:#x} at {i}: {} for {want}", p[0]);
        }
    }
}
