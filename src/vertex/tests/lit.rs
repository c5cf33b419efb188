//! Lighting against values computed by hand from the equation of section 2.14.1.

use super::*;
use crate::state::lighting::ColorControl;
use crate::state::lighting::MaterialColor;
use crate::state::primitive::PrimitiveMode;

/// The colours of one vertex at the origin with a normal.
fn lit(state: &State, layout: &Layout, normal: [f32; 3]) -> Vec<f32> {
    let mut v = at(0.0, 0.0, 0.0);
    v.current.normal = normal;
    v.current.color = [0.5, 0.25, 0.125, 0.5];
    let got = draw(state, layout, PrimitiveMode::Points, &[v]);
    let Got::Point((_, slots)) = &got[0] else { panic!("no point") };
    slots.clone()
}

fn close(got: &[f32], want: &[f32]) {
    assert_eq!(got.len(), want.len());
    for (g, w) in got.iter().zip(want) {
        assert!((g - w).abs() < 1e-6, "{got:?} instead of {want:?}");
    }
}

fn one_light() -> State {
    let mut state = plain_state();
    state.lighting.enabled = true;
    state.lighting.lights[0].enabled = true;
    state
}

#[test]
fn the_initial_light_shines_from_the_viewer() {
    // 0.2 * 0.2 ambient of the scene, 0.8 diffuse.
    close(&lit(&one_light(), &color_layout(), [0.0, 0.0, 1.0]), &[0.84, 0.84, 0.84, 1.0]);
    close(&lit(&one_light(), &color_layout(), [0.0, 0.6, 0.8]), &[0.68, 0.68, 0.68, 1.0]);
    close(&lit(&one_light(), &color_layout(), [0.0, 0.0, -1.0]), &[0.04, 0.04, 0.04, 1.0]);
    close(&lit(&one_light(), &color_layout(), [f32::NAN, 0.0, 1.0]), &[0.04, 0.04, 0.04, 1.0]);
}

#[test]
fn specular_light_goes_where_it_is_told() {
    let mut state = one_light();
    state.lighting.materials[0].specular = [0.5, 0.25, 0.0, 1.0];
    state.lighting.materials[0].shininess = 2.0;
    // n . h = 0.8, squared 0.64.
    close(&lit(&state, &color_layout(), [0.0, 0.6, 0.8]), &[1.0, 0.84, 0.68, 1.0]);
    state.lighting.model.color_control = ColorControl::SeparateSpecularColor;
    let layout = Layout { color: Some(0), secondary: Some(4), count: 7, stride: 7, ..Layout::default() };
    close(&lit(&state, &layout, [0.0, 0.6, 0.8]), &[0.68, 0.68, 0.68, 1.0, 0.32, 0.16, 0.0]);
    state.lighting.model.color_control = ColorControl::SingleColor;
    close(&lit(&state, &layout, [0.0, 0.6, 0.8])[4..], &[0.0; 3]);
}

#[test]
fn a_lamp_fades_with_the_distance_and_a_spot_at_its_edge() {
    let mut state = one_light();
    state.lighting.model.ambient = [0.0; 4];
    let light = &mut state.lighting.lights[0];
    light.position = [0.0, 0.0, 2.0, 1.0];
    light.attenuation = [1.0, 0.5, 0.25];
    light.ambient = [0.5; 4];
    // 1 / (1 + 1 + 1): ambient 0.2 * 0.5 / 3, diffuse 0.8 / 3.
    close(&lit(&state, &color_layout(), [0.0, 0.0, 1.0]), &[0.3, 0.3, 0.3, 1.0]);
    // The spot looks along (0, 0.6, -0.8): the vertex is at cosine 0.8 of its axis.
    let light = &mut state.lighting.lights[0];
    light.spot_direction = [0.0, 3.0, -4.0];
    light.spot_cutoff = 45.0;
    light.spot_exponent = 2.0;
    close(&lit(&state, &color_layout(), [0.0, 0.0, 1.0]), &[0.192, 0.192, 0.192, 1.0]);
    state.lighting.lights[0].spot_cutoff = 30.0;
    close(&lit(&state, &color_layout(), [0.0, 0.0, 1.0]), &[0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn a_local_viewer_moves_the_highlight() {
    let mut state = one_light();
    state.lighting.model.local_viewer = true;
    state.lighting.model.ambient = [0.0; 4];
    state.lighting.materials[0].diffuse = [0.0, 0.0, 0.0, 1.0];
    state.lighting.materials[0].specular = [1.0; 4];
    state.lighting.materials[0].shininess = 1.0;
    // The vertex at (0, 0.6, -0.8) sees the eye along (0, -0.6, 0.8); h = (0, -0.6, 1.8) / sqrt(3.6).
    let mut v = at(0.0, 0.6, -0.8);
    v.current.normal = [0.0, 0.0, 1.0];
    let got = draw(&state, &color_layout(), PrimitiveMode::Points, &[v]);
    let Got::Point((_, slots)) = &got[0] else { panic!() };
    let want = 1.8 / 3.6f32.sqrt();
    close(slots, &[want, want, want, 1.0]);
}

#[test]
fn colours_track_and_two_sides_differ() {
    let mut state = one_light();
    state.lighting.color_material = true;
    close(&lit(&state, &color_layout(), [0.0, 0.0, 1.0]), &[0.6, 0.3, 0.15, 0.5]);
    state.lighting.color_material_mode = MaterialColor::Emission;
    close(&lit(&state, &color_layout(), [0.0, 0.0, -1.0]), &[0.54, 0.29, 0.165, 1.0]);
    let mut state = one_light();
    state.lighting.model.two_side = true;
    state.lighting.materials[1].diffuse = [0.0, 0.5, 0.0, 0.25];
    let layout = Layout { color: Some(0), count: 4, back: Some(4), stride: 8, ..Layout::default() };
    close(&lit(&state, &layout, [0.0, 0.0, -1.0]), &[0.04, 0.04, 0.04, 1.0, 0.04, 0.54, 0.04, 0.25]);
}

#[test]
fn unlit_colours_are_clamped() {
    let state = plain_state();
    let mut v = at(0.0, 0.0, 0.0);
    v.current.color = [2.0, -1.0, f32::NAN, 0.5];
    let got = draw(&state, &color_layout(), PrimitiveMode::Points, &[v]);
    let Got::Point((_, slots)) = &got[0] else { panic!() };
    assert_eq!(slots, &[1.0, 0.0, 0.0, 0.5]);
}

#[test]
fn wild_lights_give_colours_in_range() {
    let wild = [0.0, 1e-30, 1e30, f32::MAX, f32::INFINITY, f32::NAN];
    for a in wild {
        for b in wild {
            let mut state = one_light();
            let l = &mut state.lighting.lights[0];
            l.position = [f64::from(a), f64::from(b), 0.0, 1.0];
            l.attenuation = [a, b, 0.0];
            l.diffuse = [b; 4];
            l.specular = [1.0; 4];
            l.spot_cutoff = 60.0;
            l.spot_direction = [f64::from(b), 0.0, -1.0];
            state.lighting.model.local_viewer = true;
            state.lighting.materials[0].specular = [a; 4];
            state.lighting.materials[0].shininess = 128.0;
            for v in lit(&state, &color_layout(), [b, a, 1.0]) {
                assert!((0.0..=1.0).contains(&v), "{a} {b}: {v}");
            }
        }
    }
}
