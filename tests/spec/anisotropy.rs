//! EXT_texture_filter_anisotropic: the example method of the extension (N taps along the longer derivative) against the
//! oracle, its limits, and that a degree of 1 changes nothing.

use crate::oracle::texel::Texture;
use crate::support::bridge::{as_given, draw};
use crate::support::compare::{EDGES, compare};
use crate::support::images::{bytes, chain, noise};
use crate::support::scenes::{floor, heap, replace};
use crate::support::{get_f, no_error, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn pyramid() -> Texture {
    let mut t = chain(GL_TEXTURE_2D, GL_RGBA, [128, 128, 1], |s, level| noise(s, [0; 3], level as u64, GL_RGBA));
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    t
}

#[test]
fn the_initial_value_is_one_and_wrong_ones_are_refused() {
    let mut cx = Context::new(4, 4);
    let mut v = [0f32];
    cx.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &mut v);
    no_error(&mut cx);
    assert_eq!(v[0], 1.0);
    assert_eq!(get_f::<1>(&mut cx, GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT), [16.0]);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5));
}

#[test]
fn taps_are_those_of_the_example_method() {
    for degree in [2.0, 4.0, 8.0, 16.0] {
        let mut t = pyramid();
        t.lod.anisotropy = degree;
        let mut scene = floor(96, 96, 60.0, 0.25, 19.0);
        scene.units = vec![replace(t)];
        let f = compare(&scene, EDGES);
        f.print(&format!("anisotropy {degree}"));
        // Where Pmax / Pmin is a whole number the count of taps may fall to either side, hence a share that may be off.
        assert!(f.drawn > 3000 && f.share() < 2e-3, "{f:?}");
    }
}

#[test]
fn degree_one_is_isotropic_and_a_constant_stays_constant() {
    let mut scene = floor(64, 64, 60.0, 0.9, 19.0);
    scene.units = vec![replace(pyramid())];
    compare(&scene, EDGES).within_one_lsb("anisotropy 1");
    let mut t = chain(GL_TEXTURE_2D, GL_RGBA, [64, 64, 1], |s, _| {
        crate::oracle::texel::Image::new(s, [0; 3], |_| bytes([90, 180, 33, 255]))
    });
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    t.lod.anisotropy = 16.0;
    let mut scene = heap(64, 64, 8, 9.0, 2);
    scene.units = vec![replace(t)];
    let (ideal, got) = (as_given(&scene).render(), draw(&as_given(&scene)));
    for (p, g) in ideal.pixels.iter().zip(got).filter(|(p, _)| p.hits > 0 && p.nearest_edge > 0.01) {
        assert_eq!(g, [90, 180, 33, 255], "{:?}", p.story);
    }
}
