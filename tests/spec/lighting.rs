//! Lighting (OpenGL 1.5, section 2.14): random materials and lights on a ball against the oracle's equation, one and two
//! sides, spots, attenuation, separate specular colour, colour material; initial state and errors.

use crate::oracle::light::{Light, Lighting, Material};
use crate::oracle::matrix::M4;
use crate::oracle::scene::Scene;
use crate::support::compare::{EDGES, Figures, compare};
use crate::support::scenes::ball;
use crate::support::{Random, get_f, get_i, no_error, pixels, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn color(random: &mut Random, high: f64) -> [f64; 4] {
    std::array::from_fn(|_| random.range(0.0, high))
}

fn material(random: &mut Random) -> Material {
    Material {
        ambient: color(random, 0.5),
        diffuse: color(random, 1.0),
        specular: color(random, 1.0),
        emission: color(random, 0.2),
        shininess: random.range(0.0, 60.0),
    }
}

fn light(random: &mut Random, kind: u64) -> Light {
    let mut at = |low, high| random.range(low, high);
    let mut l = Light {
        position: [at(-3.0, 3.0), at(-3.0, 3.0), at(-1.5, 1.0), 1.0],
        attenuation: [at(0.2, 1.0), at(0.0, 0.3), at(0.0, 0.2)],
        ..Light::default()
    };
    if kind == 0 {
        l.position[3] = 0.0;
        l.position[2] = 1.0;
    }
    if kind == 2 {
        l.spot_direction = [-l.position[0], -l.position[1], -3.0 - l.position[2]];
        l.spot_cutoff = at(20.0, 60.0);
        l.spot_exponent = at(0.0, 20.0);
    }
    l.ambient = color(random, 0.2);
    l.diffuse = color(random, 0.9);
    l.specular = color(random, 0.9);
    l
}

fn run(name: &str, rounds: u64, change: impl Fn(&mut Random, &mut Lighting, &mut Scene)) {
    let mut all = Figures::default();
    for seed in 1..=rounds {
        let mut random = Random(seed * 1001);
        let count = 1 + random.below(8);
        let mut l = Lighting {
            lights: (0..count)
                .map(|_| {
                    let kind = random.below(3);
                    light(&mut random, kind)
                })
                .collect(),
            scene_ambient: color(&mut random, 0.3),
            front: material(&mut random),
            back: material(&mut random),
            ..Lighting::default()
        };
        let mut scene = ball(72, 72);
        change(&mut random, &mut l, &mut scene);
        scene.vertex.lighting = Some(l);
        let f = compare(&scene, EDGES);
        assert_eq!(f.off, 0, "{name} {seed}: {f:?}");
        all.merge(&f);
    }
    all.print(name);
    assert!(all.share() < 2e-3, "{all:?}");
}

#[test]
fn the_initial_state_is_the_tables() {
    let mut cx = Context::new(4, 4);
    let mut v = [9f32; 4];
    for (face, pname, want) in [
        (GL_FRONT, GL_AMBIENT, [0.2, 0.2, 0.2, 1.0]),
        (GL_BACK, GL_DIFFUSE, [0.8, 0.8, 0.8, 1.0]),
        (GL_FRONT, GL_SPECULAR, [0.0, 0.0, 0.0, 1.0]),
        (GL_BACK, GL_EMISSION, [0.0, 0.0, 0.0, 1.0]),
    ] {
        cx.get_materialfv(face, pname, &mut v);
        assert_eq!(v, want);
    }
    for i in 0..8 {
        let l = GL_LIGHT0 + i;
        cx.get_lightfv(l, GL_DIFFUSE, &mut v);
        assert_eq!(v, if i == 0 { [1.0; 4] } else { [0.0, 0.0, 0.0, 1.0] });
        cx.get_lightfv(l, GL_POSITION, &mut v);
        assert_eq!(v, [0.0, 0.0, 1.0, 0.0]);
        cx.get_lightfv(l, GL_SPOT_CUTOFF, &mut v);
        assert_eq!(v[0], 180.0);
        cx.get_lightfv(l, GL_CONSTANT_ATTENUATION, &mut v);
        assert_eq!(v[0], 1.0);
    }
    no_error(&mut cx);
    assert_eq!(get_f::<4>(&mut cx, GL_LIGHT_MODEL_AMBIENT), [0.2, 0.2, 0.2, 1.0]);
    assert_eq!(get_i(&mut cx, GL_LIGHT_MODEL_TWO_SIDE), 0);
    assert_eq!(get_i(&mut cx, GL_LIGHT_MODEL_COLOR_CONTROL) as u32, GL_SINGLE_COLOR);
    assert_eq!(get_i(&mut cx, GL_COLOR_MATERIAL_FACE) as u32, GL_FRONT_AND_BACK);
    assert_eq!(get_i(&mut cx, GL_COLOR_MATERIAL_PARAMETER) as u32, GL_AMBIENT_AND_DIFFUSE);
}

#[test]
fn wrong_arguments_are_refused() {
    let mut cx = Context::new(4, 4);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.lightf(GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 10.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1.0));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.lightf(GL_LIGHT0, GL_AMBIENT, 1.0));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.materialf(GL_FRONT, GL_SHININESS, 128.5));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.materialf(GL_LEFT, GL_SHININESS, 1.0));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.color_material(GL_FRONT, GL_SHININESS));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.light_modeli(GL_LIGHT0, 1));
}

#[test]
fn one_side_and_an_infinite_viewer_are_lit_as_by_the_oracle() {
    run("lighting", 24, |_, _, scene| scene.vertex.normalize = true);
}

#[test]
fn a_local_viewer_and_separate_specular_light_are_those_of_the_oracle() {
    run("local viewer", 16, |random, l, scene| {
        l.local_viewer = true;
        l.separate_specular = random.below(2) == 0;
        scene.vertex.normalize = true;
    });
}

#[test]
fn back_faces_have_their_own_light() {
    run("two-sided", 16, |random, l, scene| {
        l.two_side = true;
        scene.cull = Some(if random.below(2) == 0 { GL_FRONT } else { GL_BACK });
        l.local_viewer = random.below(2) == 0;
    });
}

#[test]
fn materials_follow_the_current_colour() {
    run("colour material", 20, |random, l, _| {
        let face = random.pick(&[GL_FRONT, GL_BACK, GL_FRONT_AND_BACK]);
        let mode = random.pick(&[GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE]);
        l.color_material = Some((face, mode));
    });
}

#[test]
fn normals_are_rescaled_and_normalised() {
    run("rescale normal", 8, |random, _, scene| {
        let k = random.range(0.5, 1.2);
        scene.vertex.modelview = scene.vertex.modelview.times(M4::scaling(k, k, k));
        scene.vertex.rescale_normal = true;
    });
    run("normalize", 8, |random, _, scene| {
        let k = [random.range(0.5, 1.2), random.range(0.5, 1.2), random.range(0.5, 1.2)];
        scene.vertex.modelview = scene.vertex.modelview.times(M4::scaling(k[0], k[1], k[2]));
        scene.vertex.normalize = true;
    });
}

#[test]
fn light_positions_move_with_the_matrix() {
    let mut cx = Context::new(4, 4);
    cx.translatef(0.0, 0.0, -5.0);
    cx.rotatef(90.0, 0.0, 1.0, 0.0);
    cx.lightfv(GL_LIGHT2, GL_POSITION, &[1.0, 0.0, 0.0, 1.0]);
    cx.lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, &[1.0, 0.0, 0.0]);
    let mut v = [0f32; 4];
    cx.get_lightfv(GL_LIGHT2, GL_POSITION, &mut v);
    crate::oracle::assert_near(&v.map(f64::from), &[0.0, 0.0, -6.0, 1.0], 1e-6);
    cx.get_lightfv(GL_LIGHT2, GL_SPOT_DIRECTION, &mut v);
    crate::oracle::assert_near(&v.map(f64::from)[..3], &[0.0, 0.0, -1.0], 1e-6);
    no_error(&mut cx);
}

const TRACKED: [f32; 4] = [0.25, 0.5, 0.75, 0.125];
const OTHER: [f32; 4] = [0.5, 0.125, 0.25, 1.0];

fn front(cx: &mut Context, pname: GLenum) -> [f32; 4] {
    let mut v = [0f32; 4];
    cx.get_materialfv(GL_FRONT, pname, &mut v);
    v
}

/// What is done while the current colour is [`TRACKED`], and what the front's diffuse colour is then and after Disable.
type Tracking = (&'static str, fn(&mut Context), [f32; 4]);

const TRACKING: &[Tracking] = &[
    ("Enable", |cx| cx.enable(GL_COLOR_MATERIAL), TRACKED),
    ("Enable, Color", |cx| (cx.enable(GL_COLOR_MATERIAL), cx.color4fv(&OTHER)).1, OTHER),
    ("Enable, Material", |cx| (cx.enable(GL_COLOR_MATERIAL), cx.materialfv(GL_FRONT, GL_DIFFUSE, &OTHER)).1, TRACKED),
    (
        "Enable for the back only",
        |cx| (cx.color_material(GL_BACK, GL_DIFFUSE), cx.enable(GL_COLOR_MATERIAL)).1,
        [0.8, 0.8, 0.8, 1.0],
    ),
    (
        "ColorMaterial goes on to another property",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.color_material(GL_FRONT_AND_BACK, GL_EMISSION);
            cx.color4fv(&OTHER);
        },
        TRACKED,
    ),
    (
        "ColorMaterial comes to this property",
        |cx| {
            cx.color_material(GL_FRONT, GL_SPECULAR);
            cx.enable(GL_COLOR_MATERIAL);
            cx.color_material(GL_FRONT, GL_DIFFUSE);
        },
        TRACKED,
    ),
    (
        "PopAttrib of the enable",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.push_attrib(GL_ENABLE_BIT);
            cx.disable(GL_COLOR_MATERIAL);
            cx.color4fv(&OTHER);
            cx.pop_attrib();
        },
        OTHER,
    ),
    (
        "PopAttrib of lighting",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.push_attrib(GL_LIGHTING_BIT);
            cx.color4fv(&OTHER);
            cx.pop_attrib();
        },
        OTHER,
    ),
    (
        "PopAttrib of lighting with tracking off",
        |cx| {
            cx.push_attrib(GL_LIGHTING_BIT);
            cx.enable(GL_COLOR_MATERIAL);
            cx.pop_attrib();
        },
        [0.8, 0.8, 0.8, 1.0],
    ),
    (
        "PopAttrib of the current values",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.push_attrib(GL_CURRENT_BIT);
            cx.color4fv(&OTHER);
            cx.pop_attrib();
        },
        TRACKED,
    ),
    (
        "PopAttrib of a group that has nothing to do with it",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.push_attrib(GL_FOG_BIT);
            cx.color4fv(&OTHER);
            cx.pop_attrib();
        },
        OTHER,
    ),
    (
        "ArrayElement",
        |cx| {
            cx.color_pointer(4, GL_FLOAT, 0, &OTHER);
            cx.enable_client_state(GL_COLOR_ARRAY);
            cx.enable(GL_COLOR_MATERIAL);
            cx.array_element(0);
            cx.disable_client_state(GL_COLOR_ARRAY);
        },
        OTHER,
    ),
    (
        "a draw from arrays leaves the current colour",
        |cx| {
            cx.color_pointer(4, GL_FLOAT, 0, &[OTHER; 3]);
            cx.vertex_pointer(2, GL_FLOAT, 0, &[[0f32; 2]; 3]);
            cx.enable_client_state(GL_COLOR_ARRAY);
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.enable(GL_COLOR_MATERIAL);
            cx.draw_arrays(GL_TRIANGLES, 0, 3);
            cx.disable_client_state(GL_COLOR_ARRAY);
            cx.disable_client_state(GL_VERTEX_ARRAY);
        },
        TRACKED,
    ),
    (
        "colours of a short Begin/End",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.begin(GL_TRIANGLES);
            cx.color4fv(&OTHER);
            cx.vertex2f(0.0, 0.0);
            cx.end();
        },
        OTHER,
    ),
    (
        "colours of a long Begin/End",
        |cx| {
            cx.enable(GL_COLOR_MATERIAL);
            cx.begin(GL_TRIANGLES);
            for _ in 0..300 {
                cx.color4fv(&OTHER);
                cx.vertex2f(0.0, 0.0);
            }
            cx.end();
        },
        OTHER,
    ),
];

#[test]
fn a_material_that_tracks_is_the_current_colour_at_once_and_stays_it_after_disable() {
    for (name, change, want) in TRACKING {
        for in_a_list in [false, true] {
            let mut cx = Context::new(8, 8);
            cx.color4fv(&TRACKED);
            if in_a_list {
                cx.new_list(1, GL_COMPILE);
                change(&mut cx);
                cx.end_list();
                cx.call_list(1);
            } else {
                change(&mut cx);
            }
            no_error(&mut cx);
            assert_eq!(front(&mut cx, GL_DIFFUSE), *want, "{name}, list: {in_a_list}");
            cx.disable(GL_COLOR_MATERIAL);
            // Light 0 from the viewer's side: ambient 0, so the colour is the diffuse one, its alpha too.
            cx.color4f(1.0, 1.0, 1.0, 1.0);
            cx.materialfv(GL_FRONT_AND_BACK, GL_EMISSION, &[0.0, 0.0, 0.0, 1.0]);
            cx.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &[0.0, 0.0, 0.0, 1.0]);
            cx.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
            cx.enable(GL_LIGHTING);
            cx.enable(GL_LIGHT0);
            cx.rectf(-1.0, -1.0, 1.0, 1.0);
            let drawn = pixels(&mut cx, 8, 8)[9];
            let want = want.map(|c| (c * 255.0).round() as u8);
            assert_eq!(drawn, want, "{name}, list: {in_a_list}, drawn after Disable");
        }
    }
}
