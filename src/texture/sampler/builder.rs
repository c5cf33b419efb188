//! From the state of a texture object to the plan of its sampler (OpenGL 1.5, sections 3.8.7 to 3.8.9): first what the
//! limits of lambda leave to be decided for each fragment, then the stages, then what the stages come to as a whole.

use super::{Packed, Sampler, SamplerKind, SamplerNeeds, dimensions};
use crate::simd::{Level, Plan, Stage};
use crate::state::texture::{Target, TexParameters, TextureCompareMode, TextureFilter};
use crate::texture::filter::{self, depth, float, linear_rgba8, nearest_rgba8};
use crate::texture::format::{BaseFormat, Storage};
use crate::texture::object::TextureObject;
use crate::texture::rho_ranges::RhoRanges;
use crate::texture::uniforms::{SamplerUniforms, TexFn};
use crate::texture::wrap::{self, Wrap, general};
use crate::texture::{anisotropy, cube, lod};

/// What the limits of lambda leave to be decided fragment by fragment.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LodCase {
    /// Nothing: every fragment reads the base level, with the filter that this says is LINEAR or not.
    Base { linear: bool },
    /// Every fragment has this lambda, and none is magnified with another filter.
    Constant { lambda: f32, linear: bool },
    /// Lambda decides. `mixed`: magnified and minified fragments differ in LINEAR and NEAREST within a level; if not,
    /// `linear` says which all of them use.
    Varies { mixed: bool, linear: bool },
}

/// Whether taps are taken along the footprint: MAX_ANISOTROPY is above 1 and the minification filter one of mipmaps that
/// is linear within a level.
fn is_anisotropic(p: &TexParameters, u: &SamplerUniforms) -> bool {
    u.max_taps > 1.0 && p.min_filter.has_mipmaps() && p.min_filter.is_linear()
}

impl LodCase {
    /// Nothing is known beforehand.
    fn general(p: &TexParameters) -> Self {
        let (mag, min) = (p.mag_filter.is_linear(), p.min_filter.is_linear());
        LodCase::Varies { mixed: mag != min, linear: min }
    }

    /// Decides from the filters and the limits of lambda. Only exact conditions count.
    fn of(p: &TexParameters, u: &SamplerUniforms) -> Self {
        let (mag, min) = (p.mag_filter.is_linear(), p.min_filter.is_linear());
        if is_anisotropic(p, u) {
            // How many taps there are is decided before lambda is limited, so every fragment needs its footprint.
            return LodCase::Varies { mixed: !mag, linear: true };
        }
        let (least, greatest) = (u.min_lod, if u.max_lod > u.min_lod { u.max_lod } else { u.min_lod });
        if greatest <= u.magnify_below {
            return LodCase::Base { linear: mag };
        }
        let mixed = mag != min && least <= u.magnify_below;
        if u.last == 0.0 || !p.min_filter.has_mipmaps() {
            return if mixed { LodCase::Varies { mixed, linear: min } } else { LodCase::Base { linear: min } };
        }
        if !mixed {
            if greatest <= 0.0 || (!p.min_filter.blends_levels() && greatest <= 0.5) {
                return LodCase::Base { linear: min };
            }
            if least >= u.last || least == greatest {
                return LodCase::Constant { lambda: least, linear: min };
            }
        }
        LodCase::Varies { mixed, linear: min }
    }
}

/// The sampler of [`Sampler::build_with`].
pub(super) fn build(level: Level, object: &TextureObject, unit_bias: f32, unit: usize, general: bool) -> Sampler {
    let p = &object.parameters;
    let uniforms = SamplerUniforms::new(object, unit_bias, unit);
    let lod = if general { LodCase::general(p) } else { LodCase::of(p, &uniforms) };
    let image = uniforms.images.first().map(|image| &image.image);
    let format = image.map_or(BaseFormat::Rgba, |image| image.base);
    let depth = format == BaseFormat::Depth;
    let base = if depth { depth::base_format(p.depth_mode) } else { format };
    let has_alpha = matches!(base, BaseFormat::Rgba | BaseFormat::LuminanceAlpha);
    let opaque = has_alpha && !general && uniforms.images.iter().all(|image| image.image.is_opaque());
    let mut builder = SamplerBuilder {
        plan: Plan::new(level),
        wraps: p.wrap.map(wrap::row),
        min_filter: p.min_filter,
        dims: dimensions(object.target),
        cube: object.target == Target::Cube,
        compare: depth && p.compare_mode == TextureCompareMode::CompareRToTexture,
        base,
        format: match base {
            _ if general => BaseFormat::Rgba,
            BaseFormat::Rgba if opaque => BaseFormat::Rgb,
            BaseFormat::LuminanceAlpha if opaque => BaseFormat::Luminance,
            _ => base,
        },
        storage: image.map(|image| image.format.storage),
        unnormalised: uniforms.unnormalised,
        anisotropic: is_anisotropic(p, &uniforms),
        wraps_itself: false,
        general,
    };
    let taps = builder.stages(lod);
    let needs = builder.needs(lod, uniforms.size);
    let blends = p.min_filter.blends_levels();
    let one_level = match lod {
        LodCase::Base { linear } => !linear,
        LodCase::Constant { linear, .. } => !linear && !blends,
        LodCase::Varies { mixed, linear } => !linear && !mixed && !blends,
    };
    let once = needs.derivatives && builder.lod_arg() & lod::ONCE != 0;
    let certain = once && p.min_filter.has_mipmaps() && !matches!(lod, LodCase::Varies { mixed: true, .. });
    let rho_ranges = certain.then(|| RhoRanges::new(&uniforms, builder.dims, blends));
    // Where one level is all that is read, the second pass of a filter of two and their mix only bring it to 0..1.
    let one_image = rho_ranges.is_some() || !builder.cube && matches!(lod, LodCase::Base { .. });
    let packed = (one_level && builder.storage == Some(Storage::Rgba8)).then(|| builder.packed(one_image));
    let kind = match lod {
        LodCase::Base { linear: true } | LodCase::Varies { linear: true, .. } if one_image => builder.linear_kind(),
        _ => SamplerKind::General,
    };
    let SamplerBuilder { plan, wraps_itself: wraps, .. } = builder;
    Sampler { plan, uniforms, needs, base, once, rho_ranges, taps, opaque, wraps, kind, packed }
}

/// A plan being built.
struct SamplerBuilder {
    plan: Plan<TexFn>,
    wraps: [Wrap; 3],
    min_filter: TextureFilter,
    dims: usize,
    cube: bool,
    compare: bool,
    base: BaseFormat,
    /// Which channels are filtered.
    format: BaseFormat,
    storage: Option<Storage>,
    /// Coordinates count texels.
    unnormalised: bool,
    /// Taps are taken along the footprint, which writes lambda lane by lane.
    anisotropic: bool,
    /// Whether a linear filter wraps its coordinates itself.
    wraps_itself: bool,
    /// Nothing is left out.
    general: bool,
}

impl SamplerBuilder {
    /// All stages; where in the plan the taps of an anisotropic filter start and end.
    fn stages(&mut self, lod: LodCase) -> Option<(usize, usize)> {
        let mipmaps = self.min_filter.has_mipmaps();
        if self.cube {
            let derivatives = matches!(lod, LodCase::Varies { .. });
            self.push(if derivatives { &cube::CUBE_FACE_DERIVATIVES } else { &cube::CUBE_FACE }, 0);
        }
        match lod {
            LodCase::Base { linear } => self.base_level(linear, false),
            LodCase::Constant { lambda, linear } => {
                self.push(&lod::LAMBDA_CONSTANT, lambda.to_bits());
                self.levels(linear, false);
            }
            LodCase::Varies { mixed, linear } if self.anisotropic => {
                self.push(anisotropy::footprint_stage(self.dims), 0);
                if mixed {
                    self.push(&lod::MAGNIFY, 0);
                    self.push(&anisotropy::NEAREST_ONE_TAP, 0);
                }
                self.push(&anisotropy::COUNT_TAPS, 0);
                debug_assert!(linear, "an anisotropic filter is linear within a level");
                return Some(self.taps(mixed));
            }
            LodCase::Varies { mixed: false, linear }
                if mipmaps && !self.min_filter.blends_levels() && !self.general =>
            {
                self.push(lod::nearest_level_stage(self.dims), self.lod_arg());
                self.pass(linear, false, 0);
            }
            LodCase::Varies { mixed, linear } => {
                self.push(lod::lambda_stage(self.dims), self.lod_arg());
                if mixed {
                    self.push(&lod::MAGNIFY, 0);
                }
                if mipmaps {
                    self.levels(linear, mixed);
                } else {
                    self.base_level(linear, mixed);
                }
            }
        }
        None
    }

    /// Filters the base level.
    fn base_level(&mut self, linear: bool, mixed: bool) {
        if self.cube {
            self.push(&lod::LEVEL_BASE, lod::CUBE);
        }
        self.pass(linear, mixed, 0);
    }

    /// What the sampler has to be given. `size` is that of the base level.
    fn needs(&self, lod: LodCase, size: [f32; 3]) -> SamplerNeeds {
        let SamplerBuilder { dims, cube, .. } = *self;
        SamplerNeeds {
            coordinates: if cube || self.compare { 3 } else { dims },
            derivatives: matches!(lod, LodCase::Varies { .. }),
            cube,
            period: std::array::from_fn(|c| if c < dims && !cube { self.wraps[c].period } else { 0 }),
            size: std::array::from_fn(|c| match (cube, self.unnormalised) {
                (true, _) => size[0] as u32,
                (_, false) if c < dims => size[c] as u32,
                _ => 1,
            }),
        }
    }

    fn push(&mut self, stage: &'static Stage<TexFn>, arg: u32) {
        self.plan.push(stage, arg);
    }

    /// Wraps and filters one image: `flags` are SECOND and PARTIAL. `mixed`: every lane filters linearly, but for lanes
    /// that are marked the nearest texel has all the weight.
    fn pass(&mut self, linear: bool, mixed: bool, flags: u32) {
        let linear = linear || mixed;
        match self.bounded() {
            Some(repeats) if linear && !mixed => {
                self.wraps_itself = true;
                let stage = linear_rgba8::stage(self.dims, self.format);
                return self.push(stage, flags | linear_rgba8::WRAPS | filter::repeat_flags(repeats));
            }
            Some(repeats) if !linear && self.dims == 2 => {
                return self.push(&nearest_rgba8::WRAP_NEAREST_2D, flags | filter::repeat_flags(repeats));
            }
            _ => {}
        }
        for c in 0..self.dims {
            let Wrap { linear: two, nearest: one, .. } = self.wraps[c];
            let arg = c as u32 | flags & general::SECOND | if self.general { general::PLAIN } else { 0 };
            self.push(if linear { two } else { one }, arg);
            if mixed {
                self.push(one, arg | general::MERGE);
            }
        }
        let stage = match self.storage {
            Some(Storage::Float) => float::stage(self.dims, linear),
            Some(Storage::Depth) => depth::stage(self.dims, linear, self.compare),
            _ if linear => linear_rgba8::stage(self.dims, self.format),
            _ => nearest_rgba8::nearest(self.dims),
        };
        self.push(stage, flags | depth::mode(self.base));
    }

    /// Which coordinates repeat, if filters of 8-bit texels wrap all of them themselves ([`bounded`](super::wrap::bounded)).
    fn bounded(&self) -> Option<[bool; 3]> {
        let mut repeats = [false; 3];
        for c in 0..self.dims {
            repeats[c] = self.wraps[c].repeats?;
        }
        let known = self.storage == Some(Storage::Rgba8) && !self.unnormalised && !self.general;
        known.then_some(repeats)
    }

    /// What a sampler is that filters one image linearly.
    fn linear_kind(&self) -> SamplerKind {
        match (self.bounded(), self.dims, self.format) {
            (Some([s, t, _]), 2, BaseFormat::Rgb) => SamplerKind::LinearRgb([s, t]),
            (Some([s, t, _]), 2, BaseFormat::Rgba) => SamplerKind::LinearRgba([s, t]),
            (Some(repeats), 3, BaseFormat::Rgb) => SamplerKind::LinearRgb3d(repeats),
            _ => SamplerKind::General,
        }
    }

    /// How the nearest texels are left packed. `one_image`: all are of one image, or of one level that rho tells.
    fn packed(&self, one_image: bool) -> Packed {
        match self.bounded() {
            Some(repeats) if self.dims == 2 => {
                let kind =
                    if one_image { SamplerKind::NearestPacked([repeats[0], repeats[1]]) } else { SamplerKind::General };
                Packed { stage: &nearest_rgba8::WRAP_NEAREST_2D_PACKED, arg: filter::repeat_flags(repeats), kind }
            }
            _ => Packed { stage: nearest_rgba8::nearest_packed(self.dims), arg: 0, kind: SamplerKind::General },
        }
    }

    /// The factor from texels to 0..1, as bits.
    fn unit_factor(&self) -> u32 {
        match self.storage {
            Some(Storage::Float | Storage::Depth) => 1.0f32.to_bits(),
            _ => filter::INV_255.to_bits(),
        }
    }

    fn level(&mut self) {
        let stage = if self.min_filter.blends_levels() { &lod::LEVEL_LINEAR } else { &lod::LEVEL_NEAREST };
        self.push(stage, self.lod_arg());
    }

    /// The argument of the stages of lambda and levels.
    fn lod_arg(&self) -> u32 {
        match (self.cube, self.general || self.anisotropic) {
            (true, _) => lod::CUBE,
            (false, true) => 0,
            (false, false) => lod::ONCE,
        }
    }

    /// Chooses the levels by lambda and filters them.
    fn levels(&mut self, linear: bool, mixed: bool) {
        self.level();
        if self.min_filter.blends_levels() {
            self.pass(linear, mixed, filter::PARTIAL);
            self.pass(linear, mixed, filter::PARTIAL | filter::SECOND);
            self.push(&lod::MIX_LEVELS, self.unit_factor());
        } else {
            self.pass(linear, mixed, 0);
        }
    }

    /// The same for each tap of an anisotropic filter: where in the plan the taps start and end.
    fn taps(&mut self, mixed: bool) -> (usize, usize) {
        self.level();
        let start = self.plan.steps.len();
        self.push(&anisotropy::TAP, self.dims as u32);
        self.pass(true, mixed, filter::PARTIAL);
        if self.min_filter.blends_levels() {
            self.pass(true, mixed, filter::PARTIAL | filter::SECOND);
        }
        self.push(&anisotropy::ADD_TAP, 0);
        let end = self.plan.steps.len();
        self.push(&anisotropy::MEAN_OF_TAPS, 0);
        self.push(&lod::MIX_LEVELS, self.unit_factor());
        (start, end)
    }
}
