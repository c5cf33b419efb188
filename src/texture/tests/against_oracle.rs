//! Sections 3.8.6 to 3.8.9 and 3.8.14: samplers against the oracle. Random textures of every target, wrap and filter,
//! random limits, biases and footprints; the sampler gets the same coordinates and derivatives as the oracle, so what is
//! measured is sampling alone. Fragments at a discontinuity (a texel boundary under NEAREST, a tie between levels) are
//! left out and counted.

use super::oracle::lod::Levels;
use super::oracle::texel::{Image as OracleImage, Sampled, Texture, nearest_index};
use crate::enums::*;
use crate::limits::MAX_TEXTURE_LOD_BIAS;
use crate::simd::{LANES, Level};
use crate::state::compare::CompareFunc;
use crate::state::texture::DepthTextureMode;
use crate::state::texture::Target;
use crate::state::texture::TextureCompareMode;
use crate::state::texture::TextureFilter;
use crate::state::texture::WrapMode;
use crate::texture::batch::TexBatch;
use crate::texture::format::InternalFormat;
use crate::texture::image::{Dimensions, Image, Texels};
use crate::texture::object::TextureObject;
use crate::texture::sampler::{Sampler, prepare};
use std::sync::Arc;

/// A small generator of random numbers: what it gives is the same everywhere.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }
    fn unit(&mut self) -> f64 {
        f64::from(self.bits()) / 2_147_483_648.0
    }
    fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    fn of<T: Copy>(&mut self, choice: &[T]) -> T {
        choice[self.bits() as usize % choice.len()]
    }
}

const WRAPS: [WrapMode; 8] = WrapMode::ALL;
const MIN: [TextureFilter; 6] = [
    TextureFilter::Nearest,
    TextureFilter::Linear,
    TextureFilter::NearestMipmapNearest,
    TextureFilter::LinearMipmapNearest,
    TextureFilter::NearestMipmapLinear,
    TextureFilter::LinearMipmapLinear,
];

/// A texture twice: as an object of the crate and as the oracle has it.
struct Pair {
    object: TextureObject,
    oracle: Texture,
    unit_bias: f32,
}

fn texture(random: &mut Random, target: Target, depth: bool) -> Pair {
    let sizes = [1u32, 2, 3, 5, 8, 16, 31];
    let name = match target {
        Target::D1 => GL_TEXTURE_1D,
        Target::D2 => GL_TEXTURE_2D,
        Target::D3 => GL_TEXTURE_3D,
        Target::Cube => GL_TEXTURE_CUBE_MAP,
        Target::Rectangle => GL_TEXTURE_RECTANGLE_ARB,
    };
    let mut size = [random.of(&sizes), random.of(&sizes), random.of(&sizes)];
    let dimensions = match target {
        Target::D1 => Dimensions::One,
        Target::D3 => Dimensions::Three,
        _ => Dimensions::Two,
    };
    match target {
        Target::D1 => size = [size[0], 1, 1],
        Target::Cube => size = [size[0], size[0], 1],
        Target::D2 | Target::Rectangle => size[2] = 1,
        Target::D3 => {}
    }
    let format = if depth { GL_DEPTH_COMPONENT24 } else { GL_RGBA8 };
    let mut object = TextureObject::new(target);
    let count = if target == Target::Rectangle { 1 } else { size.iter().max().unwrap().ilog2() as usize + 1 };
    let mut levels: Vec<Vec<OracleImage>> = Vec::new();
    for level in 0..count {
        let size = size.map(|n| (n >> level).max(1));
        let mut faces = Vec::new();
        for face in 0..object.faces.len() {
            let mut image = Image::new(InternalFormat::find(format).unwrap(), dimensions, size, 0).unwrap();
            let mut texels = std::collections::HashMap::new();
            for k in 0..size[2] as i32 {
                for j in 0..size[1] as i32 {
                    for i in 0..size[0] as i32 {
                        let at = image.index(i, j, k);
                        let v = random.bits();
                        let color = match &mut image.texels {
                            Texels::Rgba8(t) => {
                                t[at] = v;
                                v.to_le_bytes().map(|c| f64::from(c) / 255.0)
                            }
                            Texels::Depth(t) => {
                                t[at] = (v & 15) as f32 / 16.0;
                                [f64::from(t[at]); 4]
                            }
                            Texels::Float(_) => unreachable!("no float format here"),
                        };
                        texels.insert([i64::from(i), i64::from(j), i64::from(k)], color);
                    }
                }
            }
            object.faces[face][level] = Some(Arc::new(image));
            faces.push(OracleImage::new(size.map(i64::from), [0; 3], |at| texels[&at]));
        }
        levels.push(faces);
    }
    let mut oracle = Texture::new(name, if depth { GL_DEPTH_COMPONENT } else { GL_RGBA }, levels);
    let p = &mut object.parameters;
    let rectangle = target == Target::Rectangle;
    let wraps = if rectangle { &WRAPS[1..4] } else { &WRAPS[..] };
    p.wrap = [random.of(wraps), random.of(wraps), random.of(wraps)];
    let border = random.bits();
    p.border_color = border.to_le_bytes().map(|c| f32::from(c) / 255.0);
    p.min_filter = random.of(if rectangle { &MIN[..2] } else { &MIN[..] });
    p.mag_filter = random.of(&[TextureFilter::Nearest, TextureFilter::Linear]);
    if random.bits().is_multiple_of(3) {
        (p.min_lod, p.max_lod) = (random.within(-1.0, 2.0) as f32, random.within(2.0, 4.0) as f32);
    }
    p.lod_bias = random.of(&[0.0, 0.0, 0.7, -0.4]);
    let unit_bias = random.of(&[0.0, 0.0, 0.3, -1.1]);
    if !rectangle {
        p.base_level = (random.bits() % 2).min(count as u32 - 1) as i32;
        p.max_level = random.of(&[1000, 1000, 2]).max(p.base_level);
    }
    // The crate filters anisotropically where the filter within a level is linear and there are mipmaps.
    if p.mag_filter == TextureFilter::Linear
        && matches!(p.min_filter, TextureFilter::LinearMipmapLinear | TextureFilter::LinearMipmapNearest)
    {
        p.max_anisotropy = random.of(&[1.0, 2.0, 5.0, 16.0]);
    }
    if depth {
        p.depth_mode = random.of(&[DepthTextureMode::Luminance, DepthTextureMode::Intensity, DepthTextureMode::Alpha]);
        let funcs = [GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER];
        if random.bits().is_multiple_of(2) {
            p.compare_mode = TextureCompareMode::CompareRToTexture;
            let func = random.of(&funcs);
            p.compare_func = CompareFunc::from_gl(func).unwrap();
            oracle.compare = Some(func);
        }
    }
    oracle.wrap = p.wrap.map(WrapMode::gl);
    oracle.border_color = p.border_color.map(f64::from);
    oracle.depth_mode = p.depth_mode.gl();
    let l = &mut oracle.lod;
    (l.min_filter, l.mag_filter) = (p.min_filter.gl(), p.mag_filter.gl());
    (l.min_lod, l.max_lod) = (f64::from(p.min_lod), f64::from(p.max_lod));
    (l.object_bias, l.unit_bias) = (f64::from(p.lod_bias), f64::from(unit_bias));
    l.max_bias = f64::from(MAX_TEXTURE_LOD_BIAS);
    (l.base_level, l.max_level) = (p.base_level as u32, p.max_level as u32);
    l.anisotropy = f64::from(p.max_anisotropy);
    prepare(&mut object).unwrap();
    Pair { object, oracle, unit_bias }
}

/// Whether a result is near a place where it jumps, so that rounding may decide.
fn at_a_jump(pair: &Pair, s: &Sampled, at: [f64; 3], dx: [f64; 3], dy: [f64; 3]) -> bool {
    let p = &pair.object.parameters;
    let filter = match s.levels {
        Levels::One { filter, .. } | Levels::Two { filter, .. } => filter,
    };
    if filter == GL_NEAREST && s.to_boundary < 1.0 / 1024.0 {
        return true;
    }
    let near = |a: f64| (a - a.round()).abs() < 2e-4;
    let level_jumps = matches!(p.min_filter, TextureFilter::NearestMipmapNearest | TextureFilter::LinearMipmapNearest);
    let kinds_differ = (p.mag_filter == TextureFilter::Linear)
        != matches!(
            p.min_filter,
            TextureFilter::Linear | TextureFilter::LinearMipmapNearest | TextureFilter::LinearMipmapLinear
        );
    let limits = s.lambda == f64::from(p.min_lod) || s.lambda == f64::from(p.max_lod);
    if !limits && (level_jumps && near(s.lambda - 0.5) || kinds_differ && near(2.0 * s.lambda)) {
        return true;
    }
    if pair.object.target == Target::Cube {
        let mut a = at.map(f64::abs);
        a.sort_by(f64::total_cmp);
        if a[2] - a[1] < 1e-5 {
            return true;
        }
    }
    if p.max_anisotropy > 1.0 {
        // The number of taps jumps where the ratio of the sides is a whole number.
        let n = pair.oracle.dimensions();
        let long = |v: [f64; 3]| (0..n).map(|d| (v[d] * pair.oracle.texels(d)).powi(2)).sum::<f64>().sqrt();
        let (a, b) = (long(dx), long(dy));
        let ratio = a.max(b) / a.min(b);
        return (ratio - ratio.round()).abs() < 0.005 || pair.object.target == Target::Cube && ratio < 64.0;
    }
    // An EQUAL comparison may hang on the last bit of r.
    p.compare_mode != TextureCompareMode::None && ((at[2] * 16.0) - (at[2] * 16.0).round()).abs() < 1e-6
}

#[test]
fn samplers_agree_with_the_oracle() {
    let mut random = Random(20_031_015);
    let targets = [Target::D1, Target::D2, Target::D2, Target::D3, Target::Cube, Target::Rectangle];
    let (mut compared, mut left_out, mut off, mut worst) = (0u32, 0u32, 0u32, 0.0f64);
    let mut b = TexBatch::new();
    for round in 0..600 {
        let target = random.of(&targets);
        let depth = matches!(target, Target::D1 | Target::D2) && random.bits().is_multiple_of(4);
        let pair = texture(&mut random, target, depth);
        let level = Level::available().nth(round % Level::available().count()).unwrap();
        let sampler = Sampler::build(level, &pair.object, pair.unit_bias, 0);
        let base = pair.object.image(0, pair.object.parameters.base_level as usize).unwrap();
        let size = [base.width, base.height, base.depth].map(f64::from);
        let reach = random.of(&[1.5, 4.0, 900.0]);
        b.n = LANES;
        b.mask = [u32::MAX; LANES];
        for i in 0..LANES {
            let rho = random.within(-2.0, 6.0).exp2();
            let squeeze = random.of(&[1.0, 0.3, 0.07]);
            for c in 0..3 {
                let per_texel = if target == Target::Rectangle { 1.0 } else { 1.0 / size[c] };
                let scale = if target == Target::Rectangle { size[c] } else { 1.0 };
                b.coord[c][i] = (random.within(-reach, reach) * scale) as f32;
                b.ddx[c][i] = (random.within(-1.0, 1.0) * rho * per_texel) as f32;
                b.ddy[c][i] = (random.within(-1.0, 1.0) * rho * per_texel * squeeze) as f32;
            }
            if depth {
                b.coord[2][i] = random.within(-0.1, 1.1) as f32;
            }
        }
        let of = |a: &[[f32; LANES]; 3], i: usize| -> [f64; 3] { std::array::from_fn(|c| f64::from(a[c][i])) };
        let inputs: Vec<_> = (0..LANES).map(|i| (of(&b.coord, i), of(&b.ddx, i), of(&b.ddy, i))).collect();
        sampler.run(&mut b);
        for (i, &(at, dx, dy)) in inputs.iter().enumerate() {
            let want = pair.oracle.sample(at, dx, dy);
            if at_a_jump(&pair, &want, at, dx, dy) {
                left_out += 1;
                continue;
            }
            for c in 0..4 {
                let got = f64::from(b.texel[0][c][i]);
                let error = (got - want.color[c]).abs() * 255.0;
                compared += 1;
                off += u32::from((got * 255.0).round() != (want.color[c] * 255.0).round());
                worst = worst.max(error);
                // 1/20 of a step, and what the last bit of a far coordinate is worth.
                let bound = 0.05 + 255.0 * 31.0 * at.iter().fold(1.0f64, |m, v| m.max(v.abs())) / 4_194_304.0;
                let p = &pair.object.parameters;
                assert!(
                    error <= bound,
                    "round {round} lane {i} channel {c}: {got} and not {} ({error:.3} of 255ths), lambda {}, {at:?} {dx:?} {dy:?}\n{target:?} {size:?} {p:?}",
                    want.color[c],
                    want.lambda
                );
            }
        }
    }
    println!(
        "{compared} channels: worst error {worst:.4} of 255ths, {off} round differently; {left_out} fragments at a jump"
    );
    assert!(compared > 100_000, "only {compared} were compared");
    assert!(f64::from(off) < 0.001 * f64::from(compared), "{off} of {compared} round differently");
}

#[test]
fn floats_beside_whole_numbers_read_the_texel_of_the_exact_number() {
    let mut coords: Vec<f32> = vec![-1e-8, -1e-20, -1e-38, -1e-45];
    for whole in (-4096i32..=4096).filter(|n| *n != 0) {
        let v = whole as f32;
        coords.extend([v.next_up(), v.next_down()]);
    }
    let mut b = TexBatch::new();
    for mode in [WrapMode::Repeat, WrapMode::MirroredRepeat] {
        for n in [1u32, 2, 16, 64, 256] {
            let mut image = Image::new(InternalFormat::find(GL_RGBA8).unwrap(), Dimensions::One, [n, 1, 1], 0).unwrap();
            for i in 0..n as i32 {
                let at = image.index(i, 0, 0);
                let Texels::Rgba8(texels) = &mut image.texels else { unreachable!("RGBA8 is packed") };
                texels[at] = i as u32;
            }
            let mut object = TextureObject::new(Target::D1);
            object.faces[0][0] = Some(Arc::new(image));
            object.parameters.wrap = [mode; 3];
            object.parameters.min_filter = TextureFilter::Nearest;
            object.parameters.mag_filter = TextureFilter::Nearest;
            prepare(&mut object).unwrap();
            let sampler = Sampler::build(Level::detect(), &object, 0.0, 0);
            for part in coords.chunks(LANES) {
                b.n = LANES;
                b.mask = [u32::MAX; LANES];
                b.coord[0][..part.len()].copy_from_slice(part);
                sampler.run(&mut b);
                for (i, s) in part.iter().enumerate() {
                    let want = nearest_index(mode.gl(), f64::from(*s), i64::from(n));
                    assert_eq!((f64::from(b.texel[0][0][i]) * 255.0).round() as i64, want, "{mode:?} N = {n}: {s}");
                }
            }
        }
    }
}
