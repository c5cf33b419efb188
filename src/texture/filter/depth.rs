//! Depth textures (OpenGL 1.5, section 3.8.14): a depth is read as luminance, intensity or alpha, or is compared with r.
//!
//! A comparison gives 1 or 0 for each texel that a filter reads, and LINEAR blends those: the edge of a shadow is as soft
//! as a texel, and away from edges the result is exactly 0 or 1. (Section 3.8.14 leaves open how a filter and a comparison
//! go together.) r is limited to 0..1 first, as the depths are. The third coordinate is r for 1D and 2D textures alike.

use super::float::{each_lane, neighbours};
use crate::num::clamp01;
use crate::simd::{Cost, LANES, Stage};
use crate::state::compare::CompareFunc;
use crate::state::texture::DepthTextureMode;
use crate::texture::batch::{Lanes, TexBatch};
use crate::texture::filter::{SECOND, destination, lerp};
use crate::texture::format::BaseFormat;
use crate::texture::image::Texels;
use crate::texture::uniforms::{MipLevel, SamplerUniforms, TexFn, sampler_stages};

/// In a stage's argument from this bit on: how the depth is read ([`mode`]).
const MODE_SHIFT: u32 = 8;

/// DEPTH_TEXTURE_MODE for a stage's argument.
#[must_use]
pub fn mode(base: BaseFormat) -> u32 {
    let code = match base {
        BaseFormat::Intensity => 1,
        BaseFormat::Alpha => 2,
        _ => 0,
    };
    code << MODE_SHIFT
}

/// The base format that a depth texture has for environments.
#[must_use]
pub fn base_format(depth_mode: DepthTextureMode) -> BaseFormat {
    match depth_mode {
        DepthTextureMode::Luminance => BaseFormat::Luminance,
        DepthTextureMode::Intensity => BaseFormat::Intensity,
        DepthTextureMode::Alpha => BaseFormat::Alpha,
    }
}

#[inline(always)]
fn texels(image: &MipLevel) -> &[f32] {
    match &image.image.texels {
        Texels::Depth(texels) => texels,
        _ => &[],
    }
}

/// Replaces depths by whether r compares so with them.
#[inline(always)]
fn compare(func: CompareFunc, r: &Lanes, depths: &mut Lanes) {
    #[inline(always)]
    fn each(r: &Lanes, depths: &mut Lanes, passes: impl Fn(f32, f32) -> bool) {
        for i in 0..LANES {
            depths[i] = if passes(clamp01(r[i]), depths[i]) { 1.0 } else { 0.0 };
        }
    }
    match func {
        CompareFunc::Never => *depths = [0.0; LANES],
        CompareFunc::Less => each(r, depths, |r, d| r < d),
        CompareFunc::Equal => each(r, depths, |r, d| r == d),
        CompareFunc::Lequal => each(r, depths, |r, d| r <= d),
        CompareFunc::Greater => each(r, depths, |r, d| r > d),
        CompareFunc::Notequal => each(r, depths, |r, d| r != d),
        CompareFunc::Gequal => each(r, depths, |r, d| r >= d),
        CompareFunc::Always => *depths = [1.0; LANES],
    }
}

/// Writes a depth as its mode says.
#[inline(always)]
fn expand(out: &mut [Lanes; 4], depth: &Lanes, arg: u32) {
    *out = match arg >> MODE_SHIFT & 3 {
        0 => [*depth, *depth, *depth, [1.0; LANES]],
        1 => [*depth; 4],
        _ => [[0.0; LANES], [0.0; LANES], [0.0; LANES], *depth],
    };
}

#[inline(always)]
fn read<const DIMS: usize, const LINEAR: bool, const COMPARE: bool>(b: &mut TexBatch, u: &SamplerUniforms, arg: u32) {
    let pass = usize::from(arg & SECOND != 0);
    if pass == 1 && !b.scratch.two_levels {
        return;
    }
    let n = b.n;
    let TexBatch { texel, scratch, coord, .. } = b;
    // Texels (0, 0), (1, 0), (0, 1), (1, 1) of each lane.
    let mut found = [[0.0; LANES]; 4];
    each_lane::<DIMS>(scratch, n, u, pass, |i, image, at| {
        if !LINEAR {
            found[0][i] = texels(image).get(at).copied().unwrap_or(0.0);
        } else if DIMS == 1 {
            let [row] = neighbours::<f32, 1>(texels(image), at, 0, 0);
            [found[0][i], found[1][i]] = row;
        } else {
            let [row, next] = neighbours::<f32, 2>(texels(image), at, image.stride as usize, 0);
            [found[0][i], found[1][i]] = row;
            [found[2][i], found[3][i]] = next;
        }
    });
    let taps = if LINEAR { 2 * DIMS } else { 1 };
    if COMPARE {
        for depths in found.iter_mut().take(taps) {
            compare(u.compare_func, &coord[2], depths);
        }
    }
    let [mut depth, right, up, across] = found;
    if LINEAR {
        let [ws, wt, _] = &scratch.weight;
        for i in 0..LANES {
            let row = lerp(depth[i], right[i], ws[i]);
            depth[i] = if DIMS == 1 { row } else { lerp(row, lerp(up[i], across[i], ws[i]), wt[i]) };
        }
    }
    if let Some((out, _)) = destination(texel, &mut scratch.color, u.unit, arg, 1.0) {
        expand(out, &depth, arg);
    }
}

sampler_stages! {
    DEPTH_NEAREST_1D [Cost::texels(1)] = read::<1, false, false>;
    DEPTH_NEAREST_2D [Cost::texels(1)] = read::<2, false, false>;
    DEPTH_LINEAR_1D [Cost::texels(2)] = read::<1, true, false>;
    DEPTH_BILINEAR_2D [Cost::texels(4)] = read::<2, true, false>;
    SHADOW_NEAREST_1D [Cost::texels(1)] = read::<1, false, true>;
    SHADOW_NEAREST_2D [Cost::texels(1)] = read::<2, false, true>;
    SHADOW_LINEAR_1D [Cost::texels(2)] = read::<1, true, true>;
    SHADOW_BILINEAR_2D [Cost::texels(4)] = read::<2, true, true>;
}

/// The stage for this many dimensions.
#[must_use]
pub fn stage(dims: usize, linear: bool, compare: bool) -> &'static Stage<TexFn> {
    match (dims, linear, compare) {
        (1, false, false) => &DEPTH_NEAREST_1D,
        (_, false, false) => &DEPTH_NEAREST_2D,
        (1, true, false) => &DEPTH_LINEAR_1D,
        (_, true, false) => &DEPTH_BILINEAR_2D,
        (1, false, true) => &SHADOW_NEAREST_1D,
        (_, false, true) => &SHADOW_NEAREST_2D,
        (1, true, true) => &SHADOW_LINEAR_1D,
        (_, true, true) => &SHADOW_BILINEAR_2D,
    }
}

#[cfg(test)]
mod tests {
    use crate::enums::*;
    use crate::state::compare::CompareFunc;
    use crate::state::texture::DepthTextureMode;
    use crate::state::texture::Target;
    use crate::state::texture::TextureCompareMode;
    use crate::state::texture::TextureFilter;
    use crate::state::texture::WrapMode;
    use crate::texture::object::TextureObject;
    use crate::texture::tests::support::*;

    /// Depths 0, 1/4, 1/2, 3/4 by column.
    fn depths(mode: DepthTextureMode, filter: TextureFilter) -> TextureObject {
        let mut o = object(Target::D2, GL_DEPTH_COMPONENT24, [4, 4, 1], 1, |_, _, [i, ..]| [0.25 * i as f32; 4]);
        o.parameters.wrap = [WrapMode::ClampToEdge; 3];
        o.parameters.depth_mode = mode;
        (o.parameters.min_filter, o.parameters.mag_filter) = (filter, filter);
        o
    }

    #[test]
    fn depths_are_read_as_the_mode_says() {
        for (mode, want) in [
            (DepthTextureMode::Luminance, [0.5, 0.5, 0.5, 1.0]),
            (DepthTextureMode::Intensity, [0.5; 4]),
            (DepthTextureMode::Alpha, [0.0, 0.0, 0.0, 0.5]),
        ] {
            assert_eq!(sample(&depths(mode, TextureFilter::Nearest), &[at(0.6, 0.5, 0.9)])[0], want);
            assert_eq!(sample(&depths(mode, TextureFilter::Linear), &[at(0.625, 0.5, 0.9)])[0], want);
        }
        assert_eq!(
            sample(&depths(DepthTextureMode::Intensity, TextureFilter::Linear), &[at(0.5, 0.5, 0.0)])[0],
            [0.375; 4]
        );
    }

    #[test]
    fn every_comparison_against_less_equal_and_greater() {
        // r below, at and above the depth 1/2.
        let table = [
            (CompareFunc::Never, [0.0, 0.0, 0.0]),
            (CompareFunc::Less, [1.0, 0.0, 0.0]),
            (CompareFunc::Equal, [0.0, 1.0, 0.0]),
            (CompareFunc::Lequal, [1.0, 1.0, 0.0]),
            (CompareFunc::Greater, [0.0, 0.0, 1.0]),
            (CompareFunc::Notequal, [1.0, 0.0, 1.0]),
            (CompareFunc::Gequal, [0.0, 1.0, 1.0]),
            (CompareFunc::Always, [1.0, 1.0, 1.0]),
        ];
        for filter in [TextureFilter::Nearest, TextureFilter::Linear] {
            for (func, want) in table {
                let mut o = depths(DepthTextureMode::Intensity, filter);
                (o.parameters.compare_mode, o.parameters.compare_func) = (TextureCompareMode::CompareRToTexture, func);
                let points = [0.4, 0.5, 0.6].map(|r| at(0.625, 0.5, r));
                let got: Vec<f32> = sample(&o, &points).iter().map(|c| c[0]).collect();
                assert_eq!(got, want, "{func:?} {filter:?}");
            }
        }
    }

    #[test]
    fn linear_blends_comparisons_and_not_depths() {
        let mut o = depths(DepthTextureMode::Intensity, TextureFilter::Linear);
        (o.parameters.compare_mode, o.parameters.compare_func) =
            (TextureCompareMode::CompareRToTexture, CompareFunc::Lequal);
        // Between the columns of 1/4 and 1/2, three quarters of the way: r = 0.3 passes in the second only.
        assert_eq!(sample(&o, &[at(0.5 - 0.0625, 0.5, 0.3)])[0][0], 0.25);
        assert_eq!(sample(&o, &[at(0.5625, 0.5, 0.3)])[0][0], 0.75);
        // r is limited to 0..1: beyond 1 it equals a depth of 1.
        let mut o = object(Target::D1, GL_DEPTH_COMPONENT24, [2, 1, 1], 1, |_, _, _| [1.0; 4]);
        (o.parameters.compare_mode, o.parameters.compare_func) =
            (TextureCompareMode::CompareRToTexture, CompareFunc::Equal);
        assert_eq!(
            sample(&o, &[at(0.2, 0.0, 7.0), at(0.2, 0.0, 0.99)]).iter().map(|c| c[0]).collect::<Vec<_>>(),
            [1.0, 0.0]
        );
    }
}
