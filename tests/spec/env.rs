//! The texture environment (OpenGL 1.5, section 3.8.13): every mode with every base format against tables 3.22 and 3.23,
//! several units one after the other, the errors of TexEnv and its initial state.

use crate::oracle::env::Env;
use crate::oracle::scene::Unit;
use crate::oracle::texel::Texture;
use crate::oracle::vertex::CoordUnit;
use crate::support::compare::{EDGES, Figures, compare};
use crate::support::images::{BASE_FORMATS, noise};
use crate::support::scenes::heap;
use crate::support::{Random, get_i, raises};
use fixedgl::Context;
use fixedgl::enums::*;

fn texture(base: GLenum, seed: u64) -> Texture {
    let mut t = Texture::flat(base, noise([16, 16, 1], [0; 3], seed, base));
    t.lod.min_filter = GL_LINEAR;
    t
}

const MODES: [GLenum; 5] = [GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD];

fn is_defined(mode: GLenum, base: GLenum) -> bool {
    mode != GL_DECAL || matches!(base, GL_RGB | GL_RGBA)
}

#[test]
fn the_initial_environment_is_the_tables() {
    let mut cx = Context::new(4, 4);
    let mut v = [0i32; 4];
    cx.get_tex_enviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mut v);
    assert_eq!(v[0] as u32, GL_MODULATE);
    let mut c = [9f32; 4];
    cx.get_tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &mut c);
    assert_eq!(c, [0.0; 4]);
    cx.get_tex_envfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &mut c);
    assert_eq!(c[0], 0.0);
    for (pname, want) in [
        (GL_COMBINE_RGB, GL_MODULATE),
        (GL_COMBINE_ALPHA, GL_MODULATE),
        (GL_SOURCE0_RGB, GL_TEXTURE),
        (GL_SOURCE1_RGB, GL_PREVIOUS),
        (GL_SOURCE2_RGB, GL_CONSTANT),
        (GL_OPERAND0_RGB, GL_SRC_COLOR),
        (GL_OPERAND2_RGB, GL_SRC_ALPHA),
        (GL_OPERAND1_ALPHA, GL_SRC_ALPHA),
    ] {
        cx.get_tex_enviv(GL_TEXTURE_ENV, pname, &mut v);
        assert_eq!(v[0] as u32, want, "{}", fixedgl::enums::name(pname));
    }
    assert!(get_i(&mut cx, GL_MAX_TEXTURE_UNITS) >= 8);
}

#[test]
fn wrong_values_are_refused() {
    let mut cx = Context::new(4, 4);
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_REPLACE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_WRAP_S, GL_REPLACE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPEAT));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR));
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_envf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3.0));
    let mut v = [0i32; 4];
    cx.get_tex_enviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mut v);
    assert_eq!(v[0] as u32, GL_MODULATE, "a wrong command must change nothing");
}

#[test]
fn every_mode_with_every_base_format() {
    let mut all = Figures::default();
    let mut pairs = 0;
    for mode in MODES {
        for base in BASE_FORMATS.into_iter().filter(|&b| is_defined(mode, b)) {
            let mut scene = heap(96, 96, 10, 2.0, u64::from(mode + base));
            let env = Env { mode, color: [0.9, 0.3, 0.6, 0.7], ..Env::default() };
            scene.units = vec![Unit { texture: Some(texture(base, 3)), env }];
            let f = compare(&scene, EDGES);
            assert_eq!(f.off, 0, "mode {mode:#x} base {base:#x}: {f:?}");
            all.merge(&f);
            pairs += 1;
        }
    }
    all.within_one_lsb(&format!("environment, {pairs} pairs of mode and base format"));
}

#[test]
fn eight_units_one_after_the_other() {
    let mut random = Random(17);
    let mut all = Figures::default();
    for round in 0..6 {
        let mut scene = heap(64, 64, 8, 2.0, 50 + round);
        scene.units.clear();
        scene.vertex.units.clear();
        for unit in 0..8 {
            let mode = random.pick(&MODES);
            let base = if mode == GL_DECAL { GL_RGBA } else { random.pick(&BASE_FORMATS) };
            let env = Env { mode, color: std::array::from_fn(|_| random.range(0.0, 1.0)), ..Env::default() };
            let texture = (unit != 5).then(|| texture(base, random.bits() % 50));
            scene.units.push(Unit { texture, env });
            scene.vertex.units.push(CoordUnit::default());
        }
        for v in scene.triangles.iter_mut().flatten() {
            v.tex = (0..8).map(|_| [random.range(-2.0, 2.0), random.range(-2.0, 2.0), 0.0, 1.0]).collect();
        }
        let f = compare(&scene, EDGES);
        f.print(&format!("eight units, round {round}"));
        assert_eq!(f.off, 0, "{f:?}");
        all.merge(&f);
    }
    all.within_one_lsb("eight units");
}
