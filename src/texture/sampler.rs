//! Samplers (OpenGL 1.5, sections 3.8.7 to 3.8.9): from the state of a complete texture object to the list of stages that
//! turn texture coordinates into a filtered colour. Only what the state needs is in the list: no derivatives and no level
//! of detail where the level cannot differ, no filter for channels that the format does not have.

use super::batch::TexBatch;
use super::filter::{self, depth, float, linear_rgba8, nearest_rgba8};
use super::format::{BaseFormat, Storage};
use super::image::Image;
use super::object::TextureObject;
use super::padding::PaddingKey;
use super::rho_ranges::RhoRanges;
use super::uniforms::{LinearImage, TexFn, UnitUniforms, WrappedImage, level_range};
use super::wrap::{self, Wrap, general};
use super::{anisotropy, cube, lod};
use crate::error::Outcome;
use crate::simd::{Level, Plan, Stage, Step};
use crate::state::texture::TextureCompareMode;
use crate::state::texture::TextureFilter;
use crate::state::texture::{Target, TexParameters};
use std::sync::Arc;

/// What a sampler has to be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SamplerNeeds {
    /// How many of s, t, r it reads.
    pub coordinates: usize,
    /// Whether it reads their derivatives.
    pub derivatives: bool,
    /// Whether s, t, r are a direction (cube maps), so that q plays no part.
    pub cube: bool,
    /// For each coordinate the whole number that may be taken off: 0 none, 1 or 2.
    pub period: [u8; 3],
    /// Size of the base level in texels; 1 where the coordinate is not one of texels.
    pub size: [u32; 3],
}

/// What a sampler comes to as a whole. All but [`General`](SamplerKind::General) read one image without borders, which
/// spans of a row can do without batches: of the base level or, where the sampler has [`Sampler::rho_ranges`], of one
/// level that rho is known to select. Each coordinate is wrapped by REPEAT where its flag is set, by CLAMP or
/// CLAMP_TO_EDGE where it is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplerKind {
    /// The nearest texel of 8-bit 2D images, left packed ([`Sampler::pack`]).
    NearestPacked([bool; 2]),
    /// LINEAR in three channels of 8-bit 2D images; alpha is 1.
    LinearRgb([bool; 2]),
    /// LINEAR in all channels of 8-bit 2D images.
    LinearRgba([bool; 2]),
    /// LINEAR in three channels of 8-bit 3D images; alpha is 1.
    LinearRgb3d([bool; 3]),
    /// Anything else: only the stages tell.
    General,
}

/// The stages that sample one texture, with the numbers and images that they read.
#[derive(Clone, Debug)]
pub struct Sampler {
    /// The stages in order.
    pub plan: Plan<TexFn>,
    /// What they read.
    pub uniforms: UnitUniforms,
    /// What they have to be given.
    pub needs: SamplerNeeds,
    /// The base format as environments see it: that of the texture, or for a depth texture its DEPTH_TEXTURE_MODE.
    pub base: BaseFormat,
    /// Whether lambda is worked out once a batch where derivatives are the same in all lanes.
    pub once: bool,
    /// The levels of a filter that may get one level instead of derivatives ([`Derivatives::OneLevel`](super::batch::Derivatives)).
    pub rho_ranges: Option<RhoRanges>,
    /// The steps that are run once for each tap of an anisotropic filter: start and end in the plan.
    pub taps: Option<(usize, usize)>,
    /// Whether alpha is not filtered although the format has it: it is 255 in every texel.
    pub opaque: bool,
    /// Whether the filter stage wraps the coordinates too.
    pub wraps: bool,
    /// What the stages come to.
    pub kind: SamplerKind,
    /// Where the last stage reads the nearest texel of 8-bit images: how to read it packed.
    packed: Option<Packed>,
}

/// The last stage of a sampler of nearest texels that leaves them packed.
#[derive(Clone, Debug)]
struct Packed {
    stage: &'static Stage<TexFn>,
    arg: u32,
    kind: SamplerKind,
}

/// Fills the rings of the images that sampling reads, for the wraps and the border colour of the object. To be called
/// before a draw when the object has changed; costs little when nothing is to be done.
pub fn prepare(object: &mut TextureObject) -> Outcome {
    let key =
        PaddingKey::new(object.parameters.wrap.map(|mode| wrap::row(mode).padding), object.parameters.border_color);
    let (base, last) = level_range(object);
    for face in &mut object.faces {
        for image in face.iter_mut().skip(base).take(last - base + 1).flatten() {
            if !image.is_padded_for(&key) {
                Image::writable(image)?.fill_padding(&key)?;
            }
        }
    }
    Ok(())
}

/// How many coordinates address the texels of a target.
#[must_use]
pub fn dimensions(target: Target) -> usize {
    match target {
        Target::D1 => 1,
        Target::D2 | Target::Rectangle | Target::Cube => 2,
        Target::D3 => 3,
    }
}

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
fn is_anisotropic(p: &TexParameters, u: &UnitUniforms) -> bool {
    u.max_taps > 1.0 && p.min_filter.has_mipmaps() && p.min_filter.is_linear()
}

impl LodCase {
    /// Nothing is known beforehand.
    fn general(p: &TexParameters) -> Self {
        let (mag, min) = (p.mag_filter.is_linear(), p.min_filter.is_linear());
        LodCase::Varies { mixed: mag != min, linear: min }
    }

    /// Decides from the filters and the limits of lambda. Only exact conditions count.
    fn of(p: &TexParameters, u: &UnitUniforms) -> Self {
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

impl Sampler {
    /// The sampler of a complete texture object whose rings are filled ([`prepare`]), for a unit with this LOD bias.
    #[cfg(test)]
    pub fn build(level: Level, object: &TextureObject, unit_bias: f32, unit: usize) -> Self {
        Self::build_with(level, object, unit_bias, unit, false)
    }

    /// [`Sampler::build`]; with `general` nothing is left out that could be: lambda is worked out and levels are chosen
    /// whatever the limits, and all four channels are filtered. The bits are the same.
    #[must_use]
    pub fn build_with(level: Level, object: &TextureObject, unit_bias: f32, unit: usize, general: bool) -> Self {
        let p = &object.parameters;
        let uniforms = UnitUniforms::new(object, unit_bias, unit);
        let dims = dimensions(object.target);
        let lod = if general { LodCase::general(p) } else { LodCase::of(p, &uniforms) };
        let image = uniforms.images.first().map(|image| Arc::clone(&image.image));
        let format = image.as_ref().map_or(BaseFormat::Rgba, |image| image.base);
        let depth = format == BaseFormat::Depth;
        let compare = depth && p.compare_mode == TextureCompareMode::CompareRToTexture;
        let cube = object.target == Target::Cube;
        let derivatives = matches!(lod, LodCase::Varies { .. });
        let base = if depth { depth::base_format(p.depth_mode) } else { format };

        let has_alpha = matches!(base, BaseFormat::Rgba | BaseFormat::LuminanceAlpha);
        let opaque = has_alpha && !general && uniforms.images.iter().all(|image| image.image.is_opaque());
        let mut builder = SamplerBuilder {
            plan: Plan::new(level),
            wraps: p.wrap.map(wrap::row),
            dims,
            cube,
            compare,
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
        if cube {
            builder.push(if derivatives { &cube::CUBE_FACE_DERIVATIVES } else { &cube::CUBE_FACE }, 0);
        }
        let mut taps = None;
        let one_of_many = p.min_filter.has_mipmaps() && !p.min_filter.blends_levels();
        let nearest_level = one_of_many && !is_anisotropic(p, &uniforms) && !general;
        match lod {
            LodCase::Base { linear } => {
                if cube {
                    builder.push(&lod::LEVEL_BASE, lod::CUBE);
                }
                builder.pass(linear, false, 0);
            }
            LodCase::Constant { lambda, linear } => {
                builder.push(&lod::LAMBDA_CONSTANT, lambda.to_bits());
                builder.levels(p.min_filter, linear, false);
            }
            LodCase::Varies { mixed: false, linear } if nearest_level => {
                builder.push(lod::nearest_level_stage(dims), builder.lod_arg());
                builder.pass(linear, false, 0);
            }
            LodCase::Varies { mixed, linear } => {
                let anisotropic = is_anisotropic(p, &uniforms);
                let detail = builder.lod_arg();
                match anisotropic {
                    true => builder.push(anisotropy::footprint_stage(dims), 0),
                    false => builder.push(lod::lambda_stage(dims), detail),
                }
                if mixed {
                    builder.push(&lod::MAGNIFY, 0);
                }
                if anisotropic {
                    if mixed {
                        builder.push(&anisotropy::NEAREST_ONE_TAP, 0);
                    }
                    builder.push(&anisotropy::COUNT_TAPS, 0);
                    taps = Some(builder.taps(p.min_filter, mixed));
                } else if p.min_filter.has_mipmaps() {
                    builder.levels(p.min_filter, linear, mixed);
                } else {
                    if cube {
                        builder.push(&lod::LEVEL_BASE, lod::CUBE);
                    }
                    builder.pass(linear, mixed, 0);
                }
            }
        }
        let size = uniforms.size;
        let needs = SamplerNeeds {
            coordinates: if cube || compare { 3 } else { dims },
            derivatives,
            cube,
            period: std::array::from_fn(|c| if c < dims && !cube { builder.wraps[c].period } else { 0 }),
            size: std::array::from_fn(|c| match (cube, uniforms.unnormalised) {
                (true, _) => size[0] as u32,
                (_, false) if c < dims => size[c] as u32,
                _ => 1,
            }),
        };
        let one_level = match lod {
            LodCase::Base { linear } => !linear,
            LodCase::Constant { linear, .. } => !linear && !p.min_filter.blends_levels(),
            LodCase::Varies { mixed, linear } => !linear && !mixed && !p.min_filter.blends_levels(),
        };
        let once = derivatives && builder.lod_arg() & lod::ONCE != 0;
        let certain = once && p.min_filter.has_mipmaps() && !matches!(lod, LodCase::Varies { mixed: true, .. });
        let rho_ranges = certain.then(|| RhoRanges::new(&uniforms, dims, p.min_filter.blends_levels()));
        // Where one level is all that is read, the second pass of a filter of two and their mix only bring it to 0..1.
        let one_image = rho_ranges.is_some() || !cube && matches!(lod, LodCase::Base { .. });
        let packed = (one_level && builder.storage == Some(Storage::Rgba8)).then(|| builder.packed(one_image));
        let kind = match lod {
            LodCase::Base { linear: true } | LodCase::Varies { linear: true, .. } if one_image => builder.linear_kind(),
            _ => SamplerKind::General,
        };
        let wraps = builder.wraps_itself;
        Self { plan: builder.plan, uniforms, needs, base, once, rho_ranges, taps, opaque, wraps, kind, packed }
    }

    /// Makes the sampler write packed texels (`packed` of the batch) and nothing else, if each of its texels is one 8-bit
    /// texel of an image; says whether it is so.
    pub fn pack(&mut self) -> bool {
        let Some(Packed { stage, arg, kind }) = self.packed else { return false };
        self.plan.steps.pop();
        self.plan.push(stage, arg);
        self.kind = kind;
        true
    }

    /// The images with their wraps, if the sampler leaves their nearest texels packed and does nothing else.
    #[must_use]
    pub fn nearest_image(&self) -> Option<WrappedImage<2>> {
        match self.kind {
            SamplerKind::NearestPacked(repeats) => Some(self.wrapped(repeats)),
            _ => None,
        }
    }

    /// The images with their wraps, if the sampler filters one of them linearly and does nothing else.
    #[must_use]
    pub fn linear_image(&self) -> Option<LinearImage> {
        match self.kind {
            SamplerKind::LinearRgb(repeats) => Some(LinearImage::Rgb(self.wrapped(repeats))),
            SamplerKind::LinearRgba(repeats) => Some(LinearImage::Rgba(self.wrapped(repeats))),
            SamplerKind::LinearRgb3d(repeats) => Some(LinearImage::Rgb3d(self.wrapped(repeats))),
            SamplerKind::NearestPacked(_) | SamplerKind::General => None,
        }
    }

    fn wrapped<const K: usize>(&self, repeats: [bool; K]) -> WrappedImage<K> {
        WrappedImage { levels: self.uniforms.images.clone(), repeats }
    }

    /// Samples all lanes of a batch: reads coordinates and derivatives, writes the texel of the unit.
    pub fn run(&self, batch: &mut TexBatch) {
        batch.scratch.same = [Some(0); 2];
        batch.scratch.two_levels = false;
        let steps = &self.plan.steps;
        let Some((start, end)) = self.taps else { return self.run_steps(batch, steps) };
        let (before, rest) = steps.split_at(start.min(steps.len()));
        let (each, after) = rest.split_at((end.saturating_sub(start)).min(rest.len()));
        batch.scratch.taps = 1;
        self.run_steps(batch, before);
        for tap in 1..=batch.scratch.taps {
            batch.scratch.tap = tap;
            self.run_steps(batch, each);
        }
        self.run_steps(batch, after);
    }

    fn run_steps(&self, batch: &mut TexBatch, steps: &[Step<TexFn>]) {
        for step in steps {
            #[expect(unsafe_code, reason = "a plan is made for a level that the processor has")]
            unsafe {
                (step.run)(batch, &self.uniforms, step.arg);
            }
        }
    }
}

/// A plan being built.
struct SamplerBuilder {
    plan: Plan<TexFn>,
    wraps: [Wrap; 3],
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

    fn level(&mut self, filter: TextureFilter) {
        let stage = if filter.blends_levels() { &lod::LEVEL_LINEAR } else { &lod::LEVEL_NEAREST };
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
    fn levels(&mut self, filter: TextureFilter, linear: bool, mixed: bool) {
        self.level(filter);
        if filter.blends_levels() {
            self.pass(linear, mixed, filter::PARTIAL);
            self.pass(linear, mixed, filter::PARTIAL | filter::SECOND);
            self.push(&lod::MIX_LEVELS, self.unit_factor());
        } else {
            self.pass(linear, mixed, 0);
        }
    }

    /// The same for each tap of an anisotropic filter: where in the plan the taps start and end.
    fn taps(&mut self, filter: TextureFilter, mixed: bool) -> (usize, usize) {
        self.level(filter);
        let start = self.plan.steps.len();
        self.push(&anisotropy::TAP, self.dims as u32);
        self.pass(true, mixed, filter::PARTIAL);
        if filter.blends_levels() {
            self.pass(true, mixed, filter::PARTIAL | filter::SECOND);
        }
        self.push(&anisotropy::ADD_TAP, 0);
        let end = self.plan.steps.len();
        self.push(&anisotropy::MEAN_OF_TAPS, 0);
        self.push(&lod::MIX_LEVELS, self.unit_factor());
        (start, end)
    }
}
