//! Texture coordinate generation and texture matrices (OpenGL 1.5, sections 2.11.2 and 2.11.4): every mode on a ball, with
//! NEAREST, where a wrong coordinate would show as a wrong texel; initial planes and errors.

use crate::oracle::matrix::M4;
use crate::oracle::texel::Texture;
use crate::oracle::vertex::TexGen;
use crate::support::compare::{EDGES, NEAREST, compare};
use crate::support::images::{chain, nearest, noise, numbered};
use crate::support::scenes::{ball, replace};
use crate::support::{get_i, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn texture() -> Texture {
    nearest(Texture::flat(GL_RGBA, numbered([64, 64, 1], [0; 3], 0)))
}

#[test]
fn the_initial_state_is_the_tables_and_errors_are_told() {
    let mut cx = Context::new(4, 4);
    let coords = [GL_S, GL_T, GL_R, GL_Q];
    for (i, coord) in coords.into_iter().enumerate() {
        let mut mode = [0i32];
        cx.get_tex_geniv(coord, GL_TEXTURE_GEN_MODE, &mut mode);
        assert_eq!(mode[0] as u32, GL_EYE_LINEAR);
        for pname in [GL_OBJECT_PLANE, GL_EYE_PLANE] {
            let mut p = [9f32; 4];
            cx.get_tex_genfv(coord, pname, &mut p);
            assert_eq!(p, std::array::from_fn(|k| if k == i && i < 2 { 1.0 } else { 0.0 }));
        }
        assert_eq!(get_i(&mut cx, GL_TEXTURE_GEN_S + i as u32), 0);
    }
    no_error(&mut cx);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_Q, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_TEXTURE_2D, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, GL_MODULATE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_geni(GL_S, GL_OBJECT_PLANE, 1));
}

#[test]
fn object_and_eye_planes_generate_what_the_oracle_does() {
    for mode in [GL_OBJECT_LINEAR, GL_EYE_LINEAR] {
        let mut scene = ball(96, 96);
        let plane = |a, b, c, d| {
            let mut g = TexGen::new(mode);
            (g.object_plane, g.eye_plane) = ([a, b, c, d], [a, b, c, d]);
            Some(g)
        };
        scene.vertex.units[0].texgen =
            [plane(1.25, 0.5, 0.0, 0.25), plane(-0.5, 0.75, 1.0, 0.0), None, plane(0.0, 0.125, 0.0, 1.5)];
        scene.units = vec![replace(texture())];
        compare(&scene, NEAREST).exact(&format!("texgen {}", fixedgl::enums::name(mode)));
    }
}

#[test]
fn a_sphere_map_lies_on_a_ball() {
    let mut scene = ball(96, 96);
    scene.vertex.units[0].texgen = [Some(TexGen::new(GL_SPHERE_MAP)), Some(TexGen::new(GL_SPHERE_MAP)), None, None];
    scene.units = vec![replace(texture())];
    compare(&scene, NEAREST).exact("sphere map");
    scene.vertex.modelview = scene.vertex.modelview.times(M4::scaling(1.2, 0.7, 0.9));
    scene.vertex.normalize = true;
    compare(&scene, NEAREST).exact("sphere map, normalised");
}

#[test]
fn reflection_and_normal_maps_on_a_ball() {
    for mode in [GL_REFLECTION_MAP, GL_NORMAL_MAP] {
        let mut t = chain(GL_TEXTURE_CUBE_MAP, GL_RGBA, [32, 32, 1], |s, n| noise(s, [0; 3], 1 + n as u64, GL_RGBA));
        (t.lod.min_filter, t.lod.mag_filter) = (GL_LINEAR, GL_LINEAR);
        t.wrap = [GL_CLAMP_TO_EDGE; 3];
        let mut scene = ball(96, 96);
        let g = Some(TexGen::new(mode));
        scene.vertex.units[0].texgen = [g, g, g, None];
        scene.units = vec![replace(t)];
        let f = compare(&scene, EDGES);
        f.print(&format!("texgen {}", fixedgl::enums::name(mode)));
        // Next to a seam of the cube either face may be read.
        assert!(f.drawn > 3000 && f.share() < 3e-3, "{f:?}");
    }
}

#[test]
fn texture_matrices_turn_coordinates() {
    let mut scene = ball(96, 96);
    scene.vertex.units[0].matrix =
        M4::translation(0.5, 0.25, 0.0).times(M4::rotation(30.0, [0.0, 0.0, 1.0])).times(M4::scaling(3.0, 2.0, 1.0));
    scene.units = vec![replace(texture())];
    compare(&scene, NEAREST).exact("texture matrix");
    // A projective one: q = 1 + s/4.
    scene.vertex.units[0].matrix.0[3] = [0.25, 0.0, 0.0, 1.0];
    compare(&scene, NEAREST).exact("projective texture matrix");
}

#[test]
fn projective_texture_from_a_second_viewpoint() {
    let mut scene = ball(96, 96);
    let g = |k: usize| {
        let mut g = TexGen::new(GL_OBJECT_LINEAR);
        g.object_plane[k] = 1.0;
        Some(g)
    };
    scene.vertex.units[0].texgen = [g(0), g(1), g(2), g(3)];
    let view = M4::look_at([2.0, 3.0, 4.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    scene.vertex.units[0].matrix = M4::translation(0.5, 0.5, 0.5)
        .times(M4::scaling(0.5, 0.5, 0.5))
        .times(M4::perspective(30.0, 1.0, 1.0, 20.0))
        .times(view);
    scene.units = vec![replace(texture())];
    compare(&scene, NEAREST).exact("projector");
}
