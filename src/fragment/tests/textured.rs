//! Programs with textures: what is left out changes no bit either, q included, and texels reach the right pixels.

use super::{Corners, DEPTH_MAX, Feed, Random, Scene, contents, draw, pixel};
use crate::enums::*;
use crate::fragment::planes::{Layout, Linear, Plane, Planes};
use crate::fragment::program::Options;
use crate::fragment::program::Program;
use crate::framebuffer::{Framebuffer, FramebufferFormat};
use crate::simd::Level;
use crate::state::State;
use crate::state::color_buffer::BlendFactor;
use crate::state::compare::CompareFunc;
use crate::state::lighting::ColorControl;
use crate::state::texture::EnvMode;
use crate::state::texture::Target;
use crate::state::texture::TextureFilter;
use crate::state::texture::WrapMode;
use crate::texture::format::InternalFormat;
use crate::texture::image::{Dimensions, Image, Texels};
use crate::texture::object::TextureObject;
use crate::texture::sampler::prepare;
use std::sync::Arc;

/// A complete texture of noise with all levels.
fn texture(
    r: &mut Random,
    format: GLenum,
    size: [u32; 2],
    filters: [TextureFilter; 2],
    wrap: WrapMode,
) -> TextureObject {
    let mut object = TextureObject::new(Target::D2);
    (object.parameters.min_filter, object.parameters.mag_filter) = (filters[0], filters[1]);
    object.parameters.wrap = [wrap; 3];
    object.parameters.border_color = [0.2, 0.9, 0.4, 0.6];
    let row = InternalFormat::find(format).unwrap();
    let mut size = size;
    for level in 0..14 {
        let mut image = Image::new(row, Dimensions::Two, [size[0], size[1], 1], 0).unwrap();
        if let Texels::Rgba8(texels) = &mut image.texels {
            texels.iter_mut().for_each(|t| *t = row.base.expand_rgba8(r.next() as u32));
        }
        object.faces[0][level] = Some(Arc::new(image));
        if size == [1, 1] {
            break;
        }
        size = size.map(|s| (s / 2).max(1));
    }
    prepare(&mut object).unwrap();
    object
}

/// A primitive with values for every slot of a layout; the same ones for layouts that differ in what they leave out. With
/// `flats` 1 all colours are white, with 2 alpha is the same everywhere.
fn scene(r: &mut Random, layout: &Layout, affine: bool, wide: bool, flats: u64) -> Scene {
    let size = [90.0, 20.0];
    let linear = |v: Corners| Linear { at: v[0], x: (v[1] - v[0]) / size[0], y: (v[2] - v[0]) / size[1] };
    let w: Corners = if affine { [1.0; 3] } else { [1.0, 0.2 + 0.8 * r.unit(), 0.3 + 0.7 * r.unit()] };
    let plane = |s: Corners| {
        let n = linear(std::array::from_fn(|i| w[i] * (s[i] - s[0])));
        Plane { c: s[0] as f32, min: -50.0, max: 50.0, n0: n.at, nx: n.x, ny: n.y }
    };
    let mut pool = vec![Plane::default(); layout.count];
    let mut corners = |scale: f64| [r.unit() * scale, r.unit() * scale, r.unit() * scale];
    // Setup limits colours to those of the vertices, which are in 0..1: environments rely on it.
    let mut colors: Vec<_> = (0..8).map(|_| Plane { min: 0.0, max: 1.0, ..plane(corners(0.5)) }).collect();
    let flat = |v: f32| Plane { c: v, min: v, max: v, ..Plane::default() };
    match flats {
        1 => colors.fill(flat(1.0)),
        2 => colors[3] = flat(0.6),
        _ => {}
    }
    for (slot, from) in [(layout.color, 0..4), (layout.secondary, 4..7), (layout.fog, 7..8)] {
        let Some(slot) = slot else { continue };
        for (k, from) in from.enumerate() {
            pool[slot + k] = colors[from];
        }
    }
    for slots in &layout.units {
        let coords: Vec<_> = (0..3).map(|_| plane(corners(if wide { 40.0 } else { 3.0 }))).collect();
        let Some(slots) = slots else { continue };
        pool[slots.base..slots.base + slots.count].copy_from_slice(&coords[..slots.count]);
        if slots.has_q {
            let q = linear(w);
            pool[slots.base + slots.count] = Plane { n0: q.at, nx: q.x, ny: q.y, ..Plane::default() };
        }
    }
    let planes = Planes {
        origin: [2, 0],
        z: linear(corners(1.6e7)),
        z_range: [0.0, DEPTH_MAX],
        d: linear(w),
        affine,
        back: false,
        wide: if wide { 0b101 } else { 0 },
        first: 0,
        member: None,
    };
    Scene { planes: vec![planes], pool }
}

#[test]
fn textured_programs_leave_out_nothing_that_shows() {
    let mut r = Random::new(31);
    let format = FramebufferFormat::default();
    for case in 0..150 {
        let mut state = State::default();
        state.depth.test = r.bool();
        state.color_buffer.blend = r.below(3) == 0;
        state.color_buffer.blend_src = [BlendFactor::SrcAlpha; 2];
        state.color_buffer.blend_dst = [BlendFactor::OneMinusSrcAlpha; 2];
        state.color_buffer.alpha_test = r.below(3) == 0;
        (state.color_buffer.alpha_func, state.color_buffer.alpha_ref) = (CompareFunc::Greater, 0.2);
        (state.fog.enabled, state.fog.color_sum) = (r.below(3) == 0, r.below(3) == 0);
        let mut textures = Vec::new();
        for unit in 0..3 {
            let filters = [
                r.pick(&[
                    TextureFilter::Nearest,
                    TextureFilter::Linear,
                    TextureFilter::LinearMipmapLinear,
                    TextureFilter::LinearMipmapNearest,
                ]),
                r.pick(&[TextureFilter::Nearest, TextureFilter::Linear]),
            ];
            let kind = r.pick(&[GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8]);
            let wrap = r.pick(&[WrapMode::Repeat, WrapMode::Clamp, WrapMode::ClampToEdge, WrapMode::MirroredRepeat]);
            let object = texture(&mut r, kind, [16, 8], filters, wrap);
            textures.push((unit == 0 || r.below(3) == 0).then_some(object));
            let modes = [EnvMode::Replace, EnvMode::Modulate, EnvMode::Decal, EnvMode::Blend, EnvMode::Add];
            state.texture.units[unit].env.mode = r.pick(&modes);
        }
        let units = std::array::from_fn(|u| textures.get(u).and_then(Option::as_ref));
        same_bytes(&mut r, case, &state, &format, units);
    }
}

/// Draws with every level, with and without what can be left out, and as every feed. Gives the names of the stages.
fn same_bytes(
    r: &mut Random,
    case: usize,
    state: &State,
    format: &FramebufferFormat,
    units: [Option<&TextureObject>; 8],
) -> Vec<&'static str> {
    let (affine, wide, seed, flats) = (r.bool(), r.below(3) == 0, r.next(), r.below(4));
    let (mut want, mut names) = (None, Vec::new());
    for level in Level::available() {
        for general in [true, false] {
            let options = Options { general, q_units: 0, ..Options::default() };
            let p = Program::build(level, state, units, format, options);
            names = p.stage_names();
            names.extend(p.span_names());
            let scene = scene(&mut Random::new(seed), &p.layout, affine, wide, flats);
            for feed in Feed::ALL {
                let mut f = Framebuffer::new(96, 20, *format).unwrap();
                draw(&p, &scene, &mut f, feed, &[(0, [2, 0, 90, 20])]);
                let got = contents(&f);
                match &want {
                    None => want = Some(got),
                    Some(want) => assert!(
                        *want == got,
                        "case {case} {level:?} general {general} {feed:?} wide {wide}\n{}{:?}",
                        crate::fragment::explain::in_one_line(&p.decisions),
                        p.stage_names()
                    ),
                }
            }
        }
    }
    names
}

#[test]
fn texels_that_become_pixels_at_once_are_the_same() {
    let mut r = Random::new(77);
    let (mut texels, mut rounded) = (0, 0);
    for case in 0..240 {
        let mut state = State::default();
        state.color_buffer.alpha_test = r.below(3) == 0;
        (state.color_buffer.alpha_func, state.color_buffer.alpha_ref) = (CompareFunc::Greater, 0.4);
        (state.depth.test, state.depth.mask) = (r.bool(), r.bool());
        let format = FramebufferFormat { color_bits: [8, 8, 8, r.pick(&[8, 0])], ..FramebufferFormat::default() };
        let count = r.pick(&[1, 1, 2]);
        let textures: Vec<_> = (0..count)
            .map(|unit| {
                let filters = [
                    TextureFilter::Nearest,
                    TextureFilter::NearestMipmapNearest,
                    TextureFilter::NearestMipmapLinear,
                    TextureFilter::LinearMipmapNearest,
                    TextureFilter::LinearMipmapLinear,
                ];
                let filters = [
                    r.pick(&filters),
                    r.pick(&[TextureFilter::Nearest, TextureFilter::Nearest, TextureFilter::Linear]),
                ];
                let kind = r.pick(&[GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_INTENSITY8, GL_ALPHA8]);
                let wrap =
                    r.pick(&[WrapMode::Repeat, WrapMode::Clamp, WrapMode::ClampToEdge, WrapMode::MirroredRepeat]);
                state.texture.units[unit].env.mode =
                    r.pick(&[EnvMode::Replace, EnvMode::Replace, EnvMode::Modulate, EnvMode::Decal]);
                let size = r.pick(&[[16, 8], [64, 64], [12, 10], [1, 4]]);
                let mut object = texture(&mut r, kind, size, filters, wrap);
                object.parameters.lod_bias = r.pick(&[0.0, -1.5, 2.0]);
                object.parameters.max_lod = r.pick(&[1000.0, 1.3]);
                object
            })
            .collect();
        let units = std::array::from_fn(|u| textures.get(u));
        let names = same_bytes(&mut r, case, &state, &format, units);
        texels += usize::from(names.contains(&"PACK_TEXEL"));
        rounded += usize::from(names.contains(&"ENV_PACK") || names.contains(&"ENV_STORE"));
    }
    assert!(texels > 15 && rounded > 60, "{texels} programs store texels, {rounded} round at once");
}

/// A complete 3D texture of noise.
fn volume(r: &mut Random, size: u32) -> TextureObject {
    let mut object = TextureObject::new(Target::D3);
    (object.parameters.min_filter, object.parameters.mag_filter) = (TextureFilter::Linear, TextureFilter::Linear);
    let row = InternalFormat::find(GL_RGB8).unwrap();
    let mut image = Image::new(row, Dimensions::Three, [size; 3], 0).unwrap();
    if let Texels::Rgba8(texels) = &mut image.texels {
        texels.iter_mut().for_each(|t| *t = row.base.expand_rgba8(r.next() as u32));
    }
    object.faces[0][0] = Some(Arc::new(image));
    object
}

#[test]
fn whole_runs_give_the_same_bytes_as_batches() {
    let mut r = Random::new(5);
    let (mut runs, mut levels) = ([0; 4], [0; 2]);
    for case in 0..500 {
        let mut state = State::default();
        (state.depth.test, state.depth.mask) = (r.bool(), r.bool());
        state.depth.func = r.pick(&[CompareFunc::Less, CompareFunc::Greater, CompareFunc::Always]);
        state.texture.units[0].env.mode = r.pick(&[EnvMode::Replace, EnvMode::Modulate]);
        state.color_buffer.blend = r.below(3) == 0;
        let factors = [
            (BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha),
            (BlendFactor::SrcAlpha, BlendFactor::One),
            (BlendFactor::DstColor, BlendFactor::Zero),
        ];
        let (src, dst) = r.pick(&factors);
        (state.color_buffer.blend_src, state.color_buffer.blend_dst) = ([src; 2], [dst; 2]);
        let format = FramebufferFormat { color_bits: [8, 8, 8, r.pick(&[8, 0])], ..FramebufferFormat::default() };
        let size = r.pick(&[[16, 8], [64, 64], [12, 10], [2, 256]]);
        let filters = r.pick(&[
            [TextureFilter::Nearest; 2],
            [TextureFilter::Linear; 2],
            [TextureFilter::NearestMipmapNearest, TextureFilter::Nearest],
            [TextureFilter::LinearMipmapNearest, TextureFilter::Linear],
            [TextureFilter::LinearMipmapLinear, TextureFilter::Linear],
        ]);
        let kind = r.pick(&[GL_RGBA8, GL_RGBA8, GL_RGB8]);
        let mut object = match r.below(4) {
            0 => volume(&mut r, [8, 6][case % 2]),
            _ => texture(&mut r, kind, size, filters, WrapMode::Repeat),
        };
        let wraps = [
            r.pick(&[WrapMode::Repeat, WrapMode::Clamp]),
            r.pick(&[WrapMode::Repeat, WrapMode::ClampToEdge]),
            WrapMode::Repeat,
        ];
        object.parameters.wrap = wraps;
        object.parameters.lod_bias = r.pick(&[0.0, -2.5, 3.0]);
        prepare(&mut object).unwrap();
        let mut units = [None; 8];
        units[0] = Some(&object);
        let names = same_bytes(&mut r, case, &state, &format, units);
        let stages = ["LONG_NEAREST", "LONG_LINEAR_RGB", "LONG_LINEAR_RGBA", "LONG_LINEAR_RGB_3D"];
        for (n, name) in runs.iter_mut().zip(stages) {
            *n += usize::from(names.contains(&name));
        }
        let filled = stages.iter().any(|stage| names.contains(stage));
        for (n, name) in levels.iter_mut().zip(["NEAREST_LEVEL_2D", "LAMBDA_2D"]) {
            *n += usize::from(filled && names.contains(&name));
        }
    }
    assert!(runs.iter().chain(&levels).all(|n| *n > 15), "{runs:?} programs do whole runs, {levels:?} with levels");
}

#[test]
fn a_texel_a_pixel_is_a_copy() {
    let mut r = Random::new(8);
    let object = texture(&mut r, GL_RGBA8, [64, 32], [TextureFilter::Nearest; 2], WrapMode::Repeat);
    let mut state = State::default();
    state.texture.units[0].env.mode = EnvMode::Replace;
    let format = FramebufferFormat::default();
    let mut units = [None; 8];
    units[0] = Some(&object);
    let options = Options { q_units: 0, ..Options::default() };
    let p = Program::build(Level::detect(), &state, units, &format, options);
    assert_eq!(
        p.layout.color,
        None,
        "REPLACE of an RGBA texture needs no colour\n{}",
        crate::fragment::explain::in_one_line(&p.decisions)
    );
    assert_eq!(p.layout.count, 2);
    let plane = |n: f64, x: f64, y: f64| Plane { c: 0.0, min: 0.0, max: 1.0, n0: n, nx: x, ny: y };
    // Pixel centres: the planes are those of (x + 1/2) / 64 and (y + 1/2) / 32.
    let scene = Scene {
        pool: vec![plane(0.5 / 64.0, 1.0 / 64.0, 0.0), plane(0.5 / 32.0, 0.0, 1.0 / 32.0)],
        planes: vec![Planes { d: Linear { at: 1.0, x: 0.0, y: 0.0 }, affine: true, ..Planes::default() }],
    };
    let mut f = Framebuffer::new(64, 32, format).unwrap();
    draw(&p, &scene, &mut f, Feed::Rows, &[(0, [0, 0, 64, 32])]);
    let image = object.image(0, 0).unwrap();
    for (x, y) in (0..32).flat_map(|y| (0..64).map(move |x| (x, y))) {
        assert_eq!(pixel(&f, x, y), image.texel(x, y, 0), "({x}, {y})");
    }
}

#[test]
fn layouts_hold_what_is_needed() {
    let mut r = Random::new(4);
    let format = FramebufferFormat::default();
    let object = texture(
        &mut r,
        GL_RGB8,
        [16, 16],
        [TextureFilter::LinearMipmapLinear, TextureFilter::Linear],
        WrapMode::Repeat,
    );
    let mut state = State::default();
    state.texture.units[1].env.mode = EnvMode::Decal;
    let mut units = [None; 8];
    units[1] = Some(&object);
    let build = |state: &State, q_units| {
        Program::build(Level::BASELINE, state, units, &format, Options { q_units, ..Options::default() })
    };
    // DECAL of an RGB texture replaces the colours and keeps the alpha of the primary colour.
    let p = build(&state, 0);
    let unit = p.layout.units[1].unwrap();
    assert_eq!((p.layout.color, unit.base, unit.count, unit.has_q), (Some(0), 4, 2, false));
    assert_eq!((unit.period, unit.size), ([1, 1, 0], [16, 16, 1]));
    assert!(build(&state, 2).layout.units[1].unwrap().has_q, "vertices may give q");
    state.texture.units[1].generation[3].enabled = true;
    assert!(build(&state, 0).layout.units[1].unwrap().has_q, "q is generated");
    state.texture.units[1].generation[3].enabled = false;
    state.transform.texture[1].top_mut().x_axis.w = 0.25;
    assert!(build(&state, 0).layout.units[1].unwrap().has_q, "the texture matrix makes a q");
    state.lighting.enabled = true;
    state.lighting.model.two_side = true;
    state.lighting.model.color_control = ColorControl::SeparateSpecularColor;
    let l = build(&state, 0).layout;
    assert_eq!((l.secondary, l.count, l.back, l.stride), (Some(7), 10, Some(10), 17));
}
