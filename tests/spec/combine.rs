//! COMBINE (OpenGL 1.5, section 3.8.13, table 3.24; crossbar and DOT3 as ARB_texture_env_crossbar and _dot3 have them):
//! every function, then random arguments, operands and scales over several units.

use crate::oracle::env::{Argument, Combine, Env};
use crate::oracle::scene::{Scene, Unit};
use crate::oracle::texel::Texture;
use crate::oracle::vertex::CoordUnit;
use crate::support::Random;
use crate::support::compare::{EDGES, Figures, compare};
use crate::support::images::{BASE_FORMATS, noise};
use crate::support::scenes::heap;
use fixedgl::enums::*;

const FUNCTIONS: [GLenum; 6] = [GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT];
const SOURCES: [GLenum; 5] = [GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_ZERO];
const COLOR_OPERANDS: [GLenum; 4] = [GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA];
const ALPHA_OPERANDS: [GLenum; 2] = [GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA];

fn scene(units: usize, random: &mut Random) -> Scene {
    let mut scene = heap(64, 64, 8, 2.0, random.bits() | 1);
    scene.vertex.units = vec![CoordUnit::default(); units];
    scene.units.clear();
    for _ in 0..units {
        let base = random.pick(&BASE_FORMATS);
        let mut t = Texture::flat(base, noise([16, 16, 1], [0; 3], random.below(90), base));
        t.lod.min_filter = GL_LINEAR;
        let color = std::array::from_fn(|_| random.range(0.0, 1.0));
        let env = Env { mode: GL_COMBINE, color, ..Env::default() };
        scene.units.push(Unit { texture: Some(t), env });
    }
    for v in scene.triangles.iter_mut().flatten() {
        v.tex = (0..units).map(|_| [random.range(-2.0, 2.0), random.range(-2.0, 2.0), 0.0, 1.0]).collect();
    }
    scene
}

/// Random arguments: any source (of `units` textures, too), any operand.
fn random_combine(random: &mut Random, units: u32, rgb: GLenum, alpha: GLenum) -> Combine {
    let mut combine = Combine { rgb, alpha, ..Combine::default() };
    for i in 0..4 {
        for (args, operands) in
            [(&mut combine.rgb_args, &COLOR_OPERANDS[..]), (&mut combine.alpha_args, &ALPHA_OPERANDS[..])]
        {
            let source = match random.below(8) {
                k @ 0..5 => SOURCES[k as usize],
                _ => GL_TEXTURE0 + random.below(u64::from(units)) as u32,
            };
            args[i] = Argument { source, operand: random.pick(operands) };
        }
    }
    combine.rgb_scale = random.pick(&[1.0, 2.0, 4.0]);
    combine.alpha_scale = random.pick(&[1.0, 2.0, 4.0]);
    combine
}

#[test]
fn every_function_agrees_with_the_oracle_on_random_arguments() {
    let mut random = Random(31);
    let mut all = Figures::default();
    for rgb in FUNCTIONS.into_iter().chain([GL_DOT3_RGB, GL_DOT3_RGBA]) {
        for alpha in FUNCTIONS {
            let mut s = scene(2, &mut random);
            for unit in 0..2 {
                let mut c = random_combine(&mut random, 2, rgb, alpha);
                if rgb == GL_DOT3_RGBA {
                    c.alpha_scale = c.rgb_scale;
                }
                s.units[unit].env.combine = c;
            }
            let f = compare(&s, EDGES);
            assert_eq!(f.off, 0, "rgb {rgb:#x} alpha {alpha:#x}: {f:?} {:?}", s.units.map_envs());
            all.merge(&f);
        }
    }
    all.within_one_lsb("COMBINE, 48 pairs of functions with random arguments");
}

#[test]
fn combine4_agrees_with_the_oracle_on_random_arguments() {
    let mut random = Random(404);
    let mut all = Figures::default();
    for rgb in FUNCTIONS.into_iter().chain([GL_DOT3_RGB]) {
        for alpha in FUNCTIONS {
            let mut s = scene(2, &mut random);
            for unit in 0..2 {
                s.units[unit].env.mode = random.pick(&[GL_COMBINE4_NV, GL_COMBINE4_NV, GL_COMBINE]);
                s.units[unit].env.combine = random_combine(&mut random, 2, rgb, alpha);
            }
            let f = compare(&s, EDGES);
            assert_eq!(f.off, 0, "rgb {rgb:#x} alpha {alpha:#x}: {f:?} {:?}", s.units.map_envs());
            all.merge(&f);
        }
    }
    all.within_one_lsb("COMBINE4, 42 pairs of functions with random arguments");
}

#[test]
fn the_initial_state_of_combine4_and_its_errors_are_told() {
    let mut cx = fixedgl::Context::new(4, 4);
    let get = |cx: &mut fixedgl::Context, pname| {
        let mut value = [0];
        cx.get_tex_enviv(GL_TEXTURE_ENV, pname, &mut value);
        value[0] as GLenum
    };
    for (pname, want) in [
        (GL_SOURCE3_RGB_NV, GL_ZERO),
        (GL_SOURCE3_ALPHA_NV, GL_ZERO),
        (GL_OPERAND3_RGB_NV, GL_ONE_MINUS_SRC_COLOR),
        (GL_OPERAND3_ALPHA_NV, GL_ONE_MINUS_SRC_ALPHA),
    ] {
        assert_eq!(get(&mut cx, pname), want, "{}", name(pname));
    }
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE4_NV);
    cx.tex_enviv(GL_TEXTURE_ENV, GL_SOURCE3_RGB_NV, &[GL_PREVIOUS as i32]);
    cx.tex_envi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, GL_ZERO);
    assert_eq!(cx.check(), Ok(()));
    assert_eq!(get(&mut cx, GL_TEXTURE_ENV_MODE), GL_COMBINE4_NV);
    assert_eq!((get(&mut cx, GL_SOURCE3_RGB_NV), get(&mut cx, GL_SOURCE0_ALPHA)), (GL_PREVIOUS, GL_ZERO));
    cx.tex_envi(GL_TEXTURE_ENV, GL_OPERAND3_ALPHA_NV, GL_SRC_COLOR);
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    cx.tex_envi(GL_TEXTURE_ENV, GL_SOURCE3_RGB_NV, GL_ONE);
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    // EXT_texture has a number of its own for REPLACE.
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE_EXT);
    assert_eq!((cx.check(), get(&mut cx, GL_TEXTURE_ENV_MODE)), (Ok(()), GL_REPLACE));
}

trait Envs {
    fn map_envs(&self) -> Vec<Combine>;
}

impl Envs for Vec<Unit> {
    fn map_envs(&self) -> Vec<Combine> {
        self.iter().map(|u| u.env.combine).collect()
    }
}

#[test]
fn the_crossbar_reaches_four_units() {
    let mut random = Random(77);
    let mut all = Figures::default();
    for _ in 0..12 {
        let mut s = scene(4, &mut random);
        for unit in 0..4 {
            let (rgb, alpha) = (random.pick(&FUNCTIONS), random.pick(&FUNCTIONS));
            s.units[unit].env.combine = random_combine(&mut random, 4, rgb, alpha);
        }
        let f = compare(&s, EDGES);
        assert_eq!(f.off, 0, "{f:?} {:?}", s.units.map_envs());
        all.merge(&f);
    }
    all.within_one_lsb("crossbar over four units");
}
