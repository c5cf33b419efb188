//! What the rows share: contexts whose colours are floats, so that a result is seen unrounded; a picture drawn in every
//! way of running; window coordinates; the greatest distance of a picture from the oracle's.

use crate::everywhere::{reference, variants};
use crate::oracle::scene::Scene;
use crate::stability::row::Worst;
use crate::support::bridge::{self, as_given};
use crate::support::{Random, no_error};
use fixedgl::Config;
use fixedgl::Context;
use fixedgl::FramebufferFormat;
use fixedgl::enums::*;

/// A colour as the framebuffer has it.
pub type Color = [f32; 4];

/// Colours are kept as floats.
pub fn float_config() -> Config {
    let mut format = FramebufferFormat::default();
    format.color_bits = [32; 4];
    format.float = true;
    reference().with_format(format)
}

/// A context of one thread whose colours are floats.
pub fn floats(width: u32, height: u32) -> Context {
    Context::with_config(width, height, float_config())
}

/// A context of one thread with bytes.
pub fn bytes(width: u32, height: u32) -> Context {
    Context::with_config(width, height, reference())
}

/// A part of the framebuffer as floats, rows from the bottom.
#[track_caller]
pub fn part(cx: &mut Context, [x, y]: [i32; 2], [width, height]: [i32; 2]) -> Vec<Color> {
    let mut colors = vec![[0f32; 4]; (width * height) as usize];
    cx.read_pixels(x, y, width, height, GL_RGBA, GL_FLOAT, &mut colors);
    no_error(cx);
    colors
}

/// The whole framebuffer as floats.
#[track_caller]
pub fn read(cx: &mut Context) -> Vec<Color> {
    let (width, height) = cx.size();
    part(cx, [0, 0], [width as i32, height as i32])
}

/// Draws a picture in every way of running; they have to agree to the last bit and to hold numbers only.
pub fn everywhere(w: &mut Worst, [width, height]: [u32; 2], draw: impl Fn(&mut Context)) -> Vec<Color> {
    let run = |config: Config| {
        let mut cx = Context::with_config(width, height, config.with_format(float_config().format));
        draw(&mut cx);
        let colors = read(&mut cx);
        let bits: Vec<[u32; 4]> = colors.iter().map(|c| c.map(f32::to_bits)).collect();
        let depths: Vec<u64> = cx.depths().iter().map(|d| d.to_bits()).collect();
        (colors, bits, depths)
    };
    let (colors, bits, depths) = run(reference());
    w.holds(colors.as_flattened().iter().all(|v| v.is_finite()), || "not finite".into());
    for config in variants() {
        let other = run(config);
        w.holds(other.1 == bits && other.2 == depths, || format!("differs with {config:?}"));
    }
    colors
}

/// A context with window coordinates for object coordinates in which a pixel counts its fragments.
pub fn counting(width: u32, height: u32) -> Context {
    let mut cx = bytes(width, height);
    window_coordinates(&mut cx, width, height);
    cx.enable(GL_BLEND);
    cx.blend_func(GL_ONE, GL_ONE);
    cx.color4ub(1, 1, 1, 1);
    cx
}

/// Object coordinates are window coordinates.
pub fn window_coordinates(cx: &mut Context, width: u32, height: u32) {
    cx.matrix_mode(GL_PROJECTION);
    cx.load_identity();
    cx.ortho(0.0, f64::from(width), 0.0, f64::from(height), -1.0, 1.0);
    cx.matrix_mode(GL_MODELVIEW);
}

/// How often each pixel of a counting context was hit.
pub fn counts(cx: &mut Context) -> Vec<u8> {
    let colors = cx.pixels();
    colors.chunks(4).map(|c| c[0]).collect()
}

/// A primitive of window positions.
pub fn emit(cx: &mut Context, mode: GLenum, points: &[[f32; 2]]) {
    cx.begin(mode);
    for p in points {
        cx.vertex2fv(p);
    }
    cx.end();
}

/// The corners of a quad over the whole window, each with something to say before its vertex.
pub fn cover(cx: &mut Context, mut before: impl FnMut(&mut Context, usize)) {
    cx.begin(GL_QUADS);
    for (i, [x, y]) in [[-1.0f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].into_iter().enumerate() {
        before(cx, i);
        cx.vertex2f(x, y);
    }
    cx.end();
}

/// A number of any magnitude from 1e`low` to 1e`high` and either sign, as an f32 holds it.
pub fn any_size(random: &mut Random, low: f64, high: f64) -> f32 {
    let v = 10f64.powf(random.range(low, high)) as f32;
    if random.below(2) == 0 { v } else { -v }
}

/// Draws a scene with floats and with the oracle, and sees the distance of each sure pixel in 255ths.
pub fn against_oracle(w: &mut Worst, scene: &Scene, name: &str) {
    let scene = as_given(scene);
    let ideal = scene.render();
    let mut cx = floats(scene.width, scene.height);
    bridge::state(&mut cx, &scene);
    bridge::triangles(&mut cx, &scene);
    for (i, (p, got)) in ideal.pixels.iter().zip(read(&mut cx)).enumerate() {
        if p.nearest_edge > 1.0 / 128.0 {
            let error = |k: usize| (f64::from(got[k]) - p.ideal[k]).abs() * 255.0;
            let worst = (0..4).map(error).fold(0.0, |a: f64, b| if b.is_nan() { f64::NAN } else { a.max(b) });
            w.see(worst, || format!("{name}, pixel {i}: {got:?}, want {:?}", p.ideal));
        }
    }
}
