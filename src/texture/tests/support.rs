//! What the tests of the samplers share: objects made of small images, and runs of a sampler at every SIMD level, which
//! must agree to the last bit.

use crate::enums::*;
use crate::simd::{LANES, Level};
use crate::state::texture::Target;
use crate::state::texture::TextureFilter;
use crate::texture::batch::TexBatch;
use crate::texture::format::InternalFormat;
use crate::texture::image::{Dimensions, Image, Texels};
use crate::texture::object::TextureObject;
use crate::texture::sampler::{Sampler, dimensions, prepare};
use std::sync::Arc;

/// A fragment's coordinates and their derivatives in x and y.
#[derive(Clone, Copy, Debug, Default)]
pub struct SamplePoint {
    /// s, t, r.
    pub at: [f32; 3],
    /// d/dx.
    pub dx: [f32; 3],
    /// d/dy.
    pub dy: [f32; 3],
}

/// A point without derivatives.
pub fn at(s: f32, t: f32, r: f32) -> SamplePoint {
    SamplePoint { at: [s, t, r], ..SamplePoint::default() }
}

/// Points of a texture of `size` texels whose lambda (of an isotropic footprint) is `lambda`.
pub fn with_lambda(p: SamplePoint, lambda: f64, size: f64) -> SamplePoint {
    let d = (lambda.exp2() / size) as f32;
    SamplePoint { dx: [d, 0.0, 0.0], dy: [0.0, d, 0.0], ..p }
}

/// Stores a colour (or in a depth image its red) as texel (i, j, k).
pub fn set_texel(image: &mut Image, i: i32, j: i32, k: i32, color: [f32; 4]) {
    let at = image.index(i, j, k);
    let color = image.base.expand(color);
    match &mut image.texels {
        Texels::Rgba8(t) => t[at] = u32::from_le_bytes(color.map(crate::num::f32_to_u8)),
        Texels::Float(t) => t[at] = color,
        Texels::Depth(t) => t[at] = color[0],
    }
}

/// An object of a target with `levels` levels, NEAREST filters, whose texel (i, j, k) of a face and level is given by
/// `color(face, level, [i, j, k])`.
pub fn object(
    target: Target,
    format: GLenum,
    size: [u32; 3],
    levels: usize,
    color: impl Fn(usize, usize, [i32; 3]) -> [f32; 4],
) -> TextureObject {
    let mut o = TextureObject::new(target);
    let dims = match dimensions(target) {
        1 => Dimensions::One,
        2 => Dimensions::Two,
        _ => Dimensions::Three,
    };
    for face in 0..o.faces.len() {
        for level in 0..levels {
            let size = size.map(|n| (n >> level).max(1));
            let mut image = Image::new(InternalFormat::find(format).unwrap(), dims, size, 0).unwrap();
            for k in 0..image.depth as i32 {
                for j in 0..image.height as i32 {
                    for i in 0..image.width as i32 {
                        set_texel(&mut image, i, j, k, color(face, level, [i, j, k]));
                    }
                }
            }
            o.faces[face][level] = Some(Arc::new(image));
        }
    }
    o.parameters.min_filter = TextureFilter::Nearest;
    o.parameters.mag_filter = TextureFilter::Nearest;
    o
}

/// A grey of `v` 255ths.
pub fn grey(v: i32) -> [f32; 4] {
    [v as f32 / 255.0; 4]
}

/// Samples points, 64 at a time, at every SIMD level that is there, with what can be left out left out and without, and
/// returns the colours. All must agree to the last bit.
pub fn sample(object: &TextureObject, points: &[SamplePoint]) -> Vec<[f32; 4]> {
    sample_with_bias(object, points, 0.0)
}

/// [`sample`] with a unit's LOD bias.
pub fn sample_with_bias(object: &TextureObject, points: &[SamplePoint], bias: f32) -> Vec<[f32; 4]> {
    let mut object = object.clone();
    prepare(&mut object).unwrap();
    let mut results: Vec<Vec<[f32; 4]>> = Vec::new();
    for level in Level::available() {
        for general in [false, true] {
            let sampler = Sampler::build_with(level, &object, bias, 3, general);
            let mut colors = Vec::new();
            let mut b = TexBatch::new();
            for points in points.chunks(LANES) {
                b.n = points.len();
                b.mask = std::array::from_fn(|i| if i < points.len() { u32::MAX } else { 0 });
                for (i, p) in points.iter().enumerate() {
                    for c in 0..3 {
                        (b.coord[c][i], b.ddx[c][i], b.ddy[c][i]) = (p.at[c], p.dx[c], p.dy[c]);
                    }
                }
                sampler.run(&mut b);
                colors.extend((0..points.len()).map(|i| b.texel[3].map(|channel| channel[i])));
            }
            results.push(colors);
        }
    }
    let bits = |c: &Vec<[f32; 4]>| c.iter().map(|c| c.map(f32::to_bits)).collect::<Vec<_>>();
    for other in &results[1..] {
        assert_eq!(bits(&results[0]), bits(other), "the SIMD levels differ, or leaving out does");
    }
    results.swap_remove(0)
}

/// A channel in 255ths, without the last bits that the factor 1/255 leaves.
pub fn in_255ths(v: f32) -> f32 {
    (v * 255.0 * 1024.0).round() / 1024.0
}

/// The red of a sampled point in 255ths.
pub fn red(object: &TextureObject, p: SamplePoint) -> f32 {
    in_255ths(sample(object, &[p])[0][0])
}
