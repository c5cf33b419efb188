//! The property: whatever the state and the primitives, the plan that leaves things out and the general plan leave the
//! same bytes in all buffers.

use super::random::Random;
use super::states::{primitive, state, textures};
use fixedgl::Config;
use fixedgl::Context;
use fixedgl::SimdLevel;
use fixedgl::enums::*;

/// Wide enough for whole batches of one row.
const SIZE: [u32; 2] = [150, 24];
/// Random states, with one to three primitives each.
const CASES: u64 = 24_000;
/// States that one pair of contexts goes through before it is made anew.
const ROUND: u64 = 200;

fn context(config: Config) -> Context {
    let mut cx = Context::with_config(SIZE[0], SIZE[1], config);
    textures(&mut cx);
    cx
}

/// A picture with something in every buffer.
fn clear(cx: &mut Context, r: &mut Random) {
    let [red, green, blue, alpha] = r.color();
    cx.clear_color(red, green, blue, alpha);
    cx.clear_depth(r.of(&[1.0, 0.6]));
    cx.clear_stencil(r.below(5) as i32);
    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

fn draw(cx: &mut Context, mut r: Random) -> (Vec<u8>, Vec<u64>, Vec<u8>) {
    cx.push_attrib(GL_ALL_ATTRIB_BITS);
    cx.push_matrix();
    clear(cx, &mut r);
    for _ in 0..1 + r.below(2) {
        cx.push_attrib(GL_ALL_ATTRIB_BITS);
        reset_matrices(cx);
        state(cx, &mut r);
        for _ in 0..1 + r.below(2) {
            primitive(cx, &mut r);
        }
        cx.pop_attrib();
    }
    cx.pop_matrix();
    cx.pop_attrib();
    let depths = cx.depths().iter().map(|depth| depth.to_bits()).collect();
    (cx.pixels(), depths, cx.stencils())
}

/// Matrices are not kept by attribute groups.
fn reset_matrices(cx: &mut Context) {
    for unit in 0..3 {
        cx.active_texture(GL_TEXTURE0 + unit);
        cx.matrix_mode(GL_TEXTURE);
        cx.load_identity();
    }
    cx.active_texture(GL_TEXTURE0);
    for mode in [GL_PROJECTION, GL_MODELVIEW] {
        cx.matrix_mode(mode);
        cx.load_identity();
    }
}

#[test]
fn the_general_plan_gives_the_same_bytes() {
    let levels: Vec<SimdLevel> = SimdLevel::available().collect();
    let shares: Vec<u64> = (0..2).collect();
    let drawn: u64 = std::thread::scope(|scope| {
        let work = |share: u64| {
            let levels = &levels;
            move || (0..CASES / ROUND).filter(|round| round % 2 == share).map(|round| cases(round, levels)).sum::<u64>()
        };
        let handles: Vec<_> = shares.iter().map(|share| scope.spawn(work(*share))).collect();
        handles.into_iter().map(|handle| handle.join().expect("no case fails")).sum()
    });
    eprintln!("{CASES} states: the same bytes; {drawn} of them changed the picture");
    assert!(drawn > CASES / 2, "only {drawn} of {CASES} states drew anything");
}

/// A round of cases; returns how many drew something.
fn cases(round: u64, levels: &[SimdLevel]) -> u64 {
    let mut r = Random::new(round.wrapping_mul(31));
    let special =
        Config::default().with_level(r.of(levels)).with_threads(r.of(&[1, 1, 2])).with_batch_cut(r.of(&[64, 64, 23]));
    let general = Config::default().with_level(r.of(levels)).with_threads(1).with_general_plan(true);
    let (mut a, mut b) = (context(special), context(general));
    let (mut drawn, mut wrong) = (0, 0);
    for case in round * ROUND..(round + 1) * ROUND {
        let r = Random::new(case);
        let (found, expected) = (draw(&mut a, r.clone()), draw(&mut b, r));
        if found != expected {
            eprintln!("case {case}, {special:?}, {}", a_difference(&found.0, &expected.0));
            wrong += 1;
        }
        drawn += u64::from(found.0.chunks(4).any(|p| p != &found.0[..4]));
    }
    assert_eq!((a.check(), b.check()), (Ok(()), Ok(())));
    assert_eq!(wrong, 0, "FIXEDGL_CASE=n cargo test --test invariance one_case -- --nocapture draws a case in words");
    drawn
}

fn a_difference(a: &[u8], b: &[u8]) -> String {
    let mut differing = a.chunks(4).zip(b.chunks(4)).enumerate().filter(|(_, (a, b))| a != b);
    let width = SIZE[0] as usize;
    match differing.next() {
        Some((i, (a, b))) => format!("pixel ({}, {}): {a:?} and {b:?}", i % width, i / width),
        None => "colours are equal, depths or stencil values are not".into(),
    }
}

/// Draws one case, which `FIXEDGL_CASE` names, in several ways and prints its commands and which ways differ.
#[test]
fn one_case_is_drawn_in_words() {
    let Some(case) = std::env::var("FIXEDGL_CASE").ok().and_then(|case| case.parse().ok()) else { return };
    let base = Config::default().with_threads(1);
    let mut a = context(base.with_general_plan(true));
    a.set_trace_callback(Some(Box::new(|call| println!("{call:?}"))));
    let expected = draw(&mut a, Random::new(case));
    let ways = SimdLevel::available()
        .flat_map(|level| [true, false].map(|general_plan| base.with_level(level).with_general_plan(general_plan)));
    for config in ways.chain([base.with_threads(2), base.with_batch_cut(23)]) {
        let found = draw(&mut context(config), Random::new(case));
        let word = if found == expected { "equal" } else { "differs" };
        println!("{word} {config:?}: {}", a_difference(&found.0, &expected.0));
    }
}

/// An image in its own size, half, a quarter of it: lambda is on a step between two levels, and next to it.
#[test]
fn levels_on_a_step_are_those_of_the_general_plan() {
    const SIDE: i32 = 128;
    let picture = |general_plan: bool, scale: f32, bias: f32, filters: [GLenum; 2]| {
        let config = Config::default().with_general_plan(general_plan).with_threads(1);
        let mut cx = Context::with_config(SIDE as u32, SIDE as u32, config);
        let texels: Vec<u8> = (0..128 * 128 * 4u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 128, 128, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filters[0] as i32);
        cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filters[1] as i32);
        cx.tex_envf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
        cx.enable(GL_TEXTURE_2D);
        cx.begin(GL_QUADS);
        for [x, y] in [[-1.0f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            cx.tex_coord2f(scale * x, scale * y);
            cx.vertex2f(x, y);
        }
        cx.end();
        let mut bytes = vec![0; (SIDE * SIDE * 4) as usize];
        cx.read_pixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
        assert_eq!(cx.get_error(), GL_NO_ERROR);
        bytes
    };
    let own = 0.5;
    let filters = [
        [GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR],
        [GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR],
        [GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST],
        [GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR],
    ];
    for filters in filters {
        for scale in [own, 2.0 * own, 4.0 * own, own * 1.000_001, own * 0.999_999, 3.0 * own, 400.0 * own] {
            for bias in [0.0, 1.0, -1.0, 0.3] {
                let same = picture(false, scale, bias, filters) == picture(true, scale, bias, filters);
                assert!(same, "{filters:X?}, scale {scale}, bias {bias}");
            }
        }
    }
}
