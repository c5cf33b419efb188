//! Texture coordinate generation and the texture matrix against values computed by hand.

use super::*;
use crate::state::primitive::PrimitiveMode;
use crate::state::texture::TexGenMode;
use glam::{DMat4, DVec3};

fn coordinates(state: &State, layout: &Layout, given: Given) -> Vec<f32> {
    let got = draw(state, layout, PrimitiveMode::Points, &[given]);
    let Got::Point((_, slots)) = &got[0] else { panic!("no point") };
    slots.clone()
}

fn generated(mode: TexGenMode) -> State {
    let mut state = plain_state();
    for generation in &mut state.texture.units[0].generation {
        generation.enabled = true;
        generation.mode = mode;
    }
    state
}

fn given() -> Given {
    let mut v = at(0.5, 0.25, -0.5);
    v.current.normal = [0.0, 0.6, 0.8];
    v.current.tex_coord[0] = [1.0, 2.0, 3.0, 4.0];
    v
}

#[test]
fn given_coordinates_pass_and_the_matrix_turns_them() {
    let mut state = plain_state();
    assert_eq!(coordinates(&state, &tex_layout(), given()), [1.0, 2.0, 3.0, 4.0]);
    *state.transform.texture[0].top_mut() = DMat4::from_translation(DVec3::new(0.5, 0.0, 0.0));
    assert_eq!(coordinates(&state, &tex_layout(), given()), [3.0, 2.0, 3.0, 4.0]);
    let mut v = given();
    v.current.tex_coord[0] = [f32::NAN, f32::INFINITY, 1.0, 1.0];
    assert_eq!(coordinates(&plain_state(), &tex_layout(), v), [0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn linear_planes() {
    let mut state = generated(TexGenMode::ObjectLinear);
    state.texture.units[0].generation[0].object_plane = [1.0, 2.0, 4.0, 8.0];
    assert_eq!(coordinates(&state, &tex_layout(), given()), [7.0, 0.25, 0.0, 0.0]);
    let mut state = generated(TexGenMode::EyeLinear);
    *state.transform.modelview.top_mut() = DMat4::from_translation(DVec3::new(0.25, 0.0, 0.0));
    assert_eq!(coordinates(&state, &tex_layout(), given()), [0.75, 0.25, 0.0, 0.0]);
    // Only s is generated: the others are the program's.
    for c in 1..4 {
        state.texture.units[0].generation[c].enabled = false;
    }
    assert_eq!(coordinates(&state, &tex_layout(), given()), [0.75, 2.0, 3.0, 4.0]);
}

#[test]
fn maps_of_the_normal_and_the_reflection() {
    let mut state = generated(TexGenMode::NormalMap);
    state.texture.units[0].generation[3].enabled = false;
    assert_eq!(coordinates(&state, &tex_layout(), given()), [0.0, 0.6, 0.8, 4.0]);
    let mut state = generated(TexGenMode::ReflectionMap);
    state.texture.units[0].generation[3].enabled = false;
    // u = (0.5, 0.25, -0.5) / 0.75; n . u = 0.2 - 0.5333 = -1/3; r = u + 2/3 n.
    let got = coordinates(&state, &tex_layout(), given());
    let want = [2.0 / 3.0, 1.0 / 3.0 + 0.4, -2.0 / 3.0 + 1.6 / 3.0];
    for (g, w) in got.iter().zip(want) {
        assert!((g - w).abs() < 1e-6, "{got:?} {want:?}");
    }
    let mut state = generated(TexGenMode::SphereMap);
    state.texture.units[0].generation[2].enabled = false;
    state.texture.units[0].generation[3].enabled = false;
    let got = coordinates(&state, &tex_layout(), given());
    let m = 2.0 * (want[0] * want[0] + want[1] * want[1] + (want[2] + 1.0) * (want[2] + 1.0)).sqrt();
    assert!((got[0] - (want[0] / m + 0.5)).abs() < 1e-6 && (got[1] - (want[1] / m + 0.5)).abs() < 1e-6, "{got:?}");
}

#[test]
fn the_point_opposite_the_sphere_map_and_the_eye_itself_are_defined() {
    let mut state = generated(TexGenMode::SphereMap);
    state.texture.units[0].generation[2].enabled = false;
    state.texture.units[0].generation[3].enabled = false;
    // r = u = (0, 0, -1): no normal.
    let mut v = at(0.0, 0.0, -0.5);
    v.current.normal = [0.0; 3];
    assert_eq!(coordinates(&state, &tex_layout(), v)[..2], [0.5, 0.5]);
    assert_eq!(coordinates(&state, &tex_layout(), at(0.0, 0.0, 0.0))[..2], [0.5, 0.5]);
}

#[test]
fn a_scroll_by_whole_periods_changes_no_bit() {
    let mut layout = tex_layout();
    if let Some(unit) = &mut layout.units[0] {
        unit.period = [1, 2, 0];
    }
    let mut state = plain_state();
    let mut run = |x: f64, y: f64| {
        *state.transform.texture[0].top_mut() = DMat4::from_translation(DVec3::new(x, y, 0.0));
        let mut v = given();
        v.current.tex_coord[0] = [0.1, 0.2, 0.0, 1.0];
        coordinates(&state, &layout, v)
    };
    let want = run(0.125, 0.25);
    assert_eq!(run(1e6 + 0.125, 2e6 + 0.25), want);
    assert_ne!(run(1e6 + 0.125, 2e6 + 1.25), want);
}

#[test]
fn fog_and_point_size_take_the_distance() {
    let mut state = plain_state();
    state.fog.enabled = true;
    state.point.size = 8.0;
    state.point.distance_attenuation = [0.0, 0.0, 1.0];
    let layout = Layout { fog: Some(0), count: 1, stride: 1, ..Layout::default() };
    *state.transform.projection.top_mut() = DMat4::from_scale(DVec3::splat(0.1));
    let got = draw(&state, &layout, PrimitiveMode::Points, &[at(0.0, 3.0, -4.0)]);
    let Got::Point((v, slots)) = &got[0] else { panic!() };
    assert_eq!(slots, &[-4.0]);
    assert_eq!(v.point_size, 8.0 / 5.0);
    state.fog.coord_source = crate::state::fog::FogCoordSource::FogCoord;
    let mut v = at(0.0, 3.0, -4.0);
    v.current.fog_coord = 0.75;
    let got = draw(&state, &layout, PrimitiveMode::Points, &[v]);
    let Got::Point((_, slots)) = &got[0] else { panic!() };
    assert_eq!(slots, &[0.75]);
}
