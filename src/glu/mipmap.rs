//! Building mipmaps (GLU 1.3, section 3.2): an image of any size becomes all levels of a texture.
//!
//! Each dimension goes to a power of two (the nearer one: from 1.5 times a power of two on to the next), is halved until
//! the GL takes the texture (its proxy says so), and every level is the mean of 2, 4 or 8 texels of the one before. What
//! needs no scaling reaches the GL as the program gave it; everything else goes as floats, so that a level is rounded
//! once, to its internal format, however many levels lie above it. An error of the image returns a code of GLU; what the
//! GL says to the levels stays in the GL.

use super::grid::{Grid, Kernel};
use super::pyramid::Pyramid;
use super::scale::ImageError;
use crate::context::{Context, Pixels};
use crate::enums::*;
use crate::error::{invalid_enum, invalid_value};
use crate::num::as_bytes;
use crate::pixels::format::{PixelFormat, PixelKind, Purpose};
use crate::pixels::unpack::ClientImage;
use crate::state::pixel::PixelStore;
use crate::texture::format::{BaseFormat, InternalFormat, Storage};
use std::borrow::Cow;
use std::ops::RangeInclusive;

/// Which levels a `...MipmapLevels` function loads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MipmapLevels {
    /// The level that the image is.
    pub level: i32,
    /// The first level to load.
    pub base: i32,
    /// The last level to load.
    pub max: i32,
}

/// The image that a mipmap is built of, and for what.
pub(super) struct MipmapJob<'a> {
    pub dimensions: usize,
    pub target: GLenum,
    pub internal_format: i32,
    pub size: [i32; 3],
    pub format: GLenum,
    pub type_: GLenum,
    pub data: &'a Pixels<'a>,
}

/// Builds the levels that are asked for: all from 0 on unless `levels` says otherwise. 0 or a code of GLU.
#[track_caller]
pub(super) fn build(cx: &mut Context, name: &'static str, job: &MipmapJob<'_>, levels: Option<MipmapLevels>) -> i32 {
    match try_build(cx, job, levels) {
        Ok(()) => 0,
        Err(error) => {
            let code = error.code();
            if let ImageError::Gl(error) = error {
                cx.advise(name, &error.message);
            }
            code as i32
        }
    }
}

#[track_caller]
fn try_build(cx: &mut Context, job: &MipmapJob<'_>, levels: Option<MipmapLevels>) -> Result<(), ImageError> {
    let proxy = proxy(job.dimensions, job.target)
        .ok_or_else(|| invalid_enum(format!("{} is not a target for this function", crate::enums::name(job.target))))?;
    let pixel = PixelFormat::for_command(job.format, job.type_, Purpose::TexImage)?;
    if job.size.iter().any(|&n| n < 1) {
        return Err(invalid_value("the size of an image must be at least 1").into());
    }
    let size = match levels {
        None => fitting(cx, job, proxy),
        Some(levels) => {
            legal(levels, job.size)?;
            job.size
        }
    };
    let MipmapLevels { level, base, max } = levels.unwrap_or(MipmapLevels { level: 0, base: 0, max: i32::MAX });
    let last = level + size.iter().map(|n| n.ilog2() as i32).max().unwrap_or(0);
    let wanted = base..=max.min(last);
    let Some(bytes) = job.data.bytes() else {
        // No memory: levels of undefined content, as TexImage makes of it.
        for l in wanted {
            upload(cx, job, l, size.map(|n| (n >> (l - level)).max(1)), job.type_, Pixels::Null);
        }
        return Ok(());
    };
    if size == job.size && wanted.contains(&level) {
        upload(cx, job, level, size, job.type_, borrowed(job.data, bytes));
    }
    let untouched = size == job.size;
    if untouched && *wanted.end() <= level {
        return Ok(());
    }
    let store = cx.engine.unpack_store();
    let layout = if job.data.is_tight() { PixelStore::TIGHT } else { store };
    let image = if job.dimensions == 3 {
        ClientImage::new_3d(bytes, &layout, job.size, pixel)?
    } else {
        ClientImage::new_2d(bytes, &layout, [job.size[0], job.size[1]], pixel)?
    };
    let wanted = base.max(level + i32::from(untouched))..=*wanted.end();
    if untouched && keeps_bytes(cx, job) {
        let pyramid = Pyramid::of(&image, cx.engine.config.level).ok_or(ImageError::Memory)?;
        cx.with_tight_rows(|cx| upload_bytes(cx, job, pixel, pyramid, level, wanted))
    } else {
        let target = size.map(|n| n.unsigned_abs() as usize);
        let grid = Grid::unpack(&image).and_then(|g| g.resized(target, Kernel::Area)).ok_or(ImageError::Memory)?;
        cx.with_tight_rows(|cx| upload_levels(cx, job, pixel, grid, level, wanted))
    }
}

/// Hands levels to the GL as bytes, the last ones as floats; the pyramid begins below level `at`.
#[track_caller]
fn upload_bytes(
    cx: &mut Context,
    job: &MipmapJob<'_>,
    pixel: PixelFormat,
    pyramid: Pyramid,
    at: i32,
    wanted: RangeInclusive<i32>,
) -> Result<(), ImageError> {
    let packed = MipmapJob { format: GL_RGBA, ..*job };
    let last = at + pyramid.levels.len() as i32;
    for (l, below) in (at + 1..).zip(&pyramid.levels).filter(|(l, _)| wanted.contains(l)) {
        let size = [below.width, below.texels.len() / below.width, 1].map(|n| n as i32);
        let bytes = Pixels::Bytes(Cow::Borrowed(as_bytes(&below.texels)));
        upload(cx, &packed, l, size, GL_UNSIGNED_INT_8_8_8_8_REV, bytes);
    }
    upload_levels(cx, job, pixel, pyramid.last, last, *wanted.start().max(&(last + 1))..=*wanted.end())
}

/// Whether the levels of an image may be handed over as bytes: where it is one of bytes, the texture keeps bytes and
/// nothing is done to them on the way. A display list must hold floats, as pixel transfer is up to whoever calls it.
fn keeps_bytes(cx: &Context, job: &MipmapJob<'_>) -> bool {
    let keeps = |format: &InternalFormat| format.storage == Storage::Rgba8 && format.base != BaseFormat::Depth;
    job.dimensions == 2
        && job.type_ == GL_UNSIGNED_BYTE
        && job.size[..2].iter().all(|&n| n > 1)
        && PixelFormat::new(job.format, job.type_).is_ok_and(|pixel| pixel.kind() == PixelKind::Color)
        && InternalFormat::of_tex_image(job.internal_format).is_ok_and(keeps)
        && cx.engine.transfer().keeps_colors()
        && !cx.flags.recording()
}

/// Hands levels to the GL as floats; `grid` is level `at`.
#[track_caller]
fn upload_levels(
    cx: &mut Context,
    job: &MipmapJob<'_>,
    pixel: PixelFormat,
    mut grid: Grid,
    at: i32,
    wanted: RangeInclusive<i32>,
) -> Result<(), ImageError> {
    for l in at..=*wanted.end() {
        if l > at {
            grid.halve().ok_or(ImageError::Memory)?;
        }
        if wanted.contains(&l) {
            let floats = grid.components(pixel).ok_or(ImageError::Memory)?;
            let bytes = Pixels::Bytes(Cow::Borrowed(as_bytes(&floats)));
            upload(cx, job, l, grid.size.map(|n| n as i32), GL_FLOAT, bytes);
        }
    }
    Ok(())
}

/// The same memory without a copy of it.
fn borrowed<'a>(data: &'a Pixels<'a>, bytes: &'a [u8]) -> Pixels<'a> {
    if data.is_tight() { data.clone() } else { Pixels::Bytes(Cow::Borrowed(bytes)) }
}

/// Hands a level to the GL.
#[track_caller]
fn upload(cx: &mut Context, job: &MipmapJob<'_>, level: i32, [w, h, d]: [i32; 3], type_: GLenum, data: Pixels<'_>) {
    let (target, inner, format) = (job.target, job.internal_format, job.format);
    match job.dimensions {
        1 => cx.tex_image_1d(target, level, inner, w, 0, format, type_, data),
        2 => cx.tex_image_2d(target, level, inner, w, h, 0, format, type_, data),
        _ => cx.tex_image_3d(target, level, inner, w, h, d, 0, format, type_, data),
    }
}

/// The proxy of a target that a function for images of these dimensions takes.
fn proxy(dimensions: usize, target: GLenum) -> Option<GLenum> {
    match (dimensions, target) {
        (1, GL_TEXTURE_1D) => Some(GL_PROXY_TEXTURE_1D),
        (2, GL_TEXTURE_2D) => Some(GL_PROXY_TEXTURE_2D),
        (2, GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z) => Some(GL_PROXY_TEXTURE_CUBE_MAP),
        (3, GL_TEXTURE_3D) => Some(GL_PROXY_TEXTURE_3D),
        _ => None,
    }
}

/// The nearer power of two: from 1.5 times one on it is the next.
fn nearest_power(n: i32) -> i32 {
    let n = n.clamp(1, 1 << 29);
    let below = 1i32 << n.ilog2();
    if 2 * n >= 3 * below { below * 2 } else { below }
}

/// The size of level 0: powers of two, as large as the GL takes them.
#[track_caller]
fn fitting(cx: &mut Context, job: &MipmapJob<'_>, proxy: GLenum) -> [i32; 3] {
    let mut size = job.size.map(nearest_power);
    let mut limit = [0];
    cx.get_integerv(
        match proxy {
            GL_PROXY_TEXTURE_3D => GL_MAX_3D_TEXTURE_SIZE,
            GL_PROXY_TEXTURE_CUBE_MAP => GL_MAX_CUBE_MAP_TEXTURE_SIZE,
            _ => GL_MAX_TEXTURE_SIZE,
        },
        &mut limit,
    );
    // An internal format that there is not fails at every size: the upload will say so, once.
    if InternalFormat::of_tex_image(job.internal_format).is_err() || limit[0] < 1 {
        return size;
    }
    while size.iter().any(|&n| n > limit[0]) {
        size = size.map(|n| (n / 2).max(1));
    }
    while size != [1; 3] && !taken(cx, job, proxy, size) {
        size = size.map(|n| (n / 2).max(1));
    }
    size
}

/// Whether the proxy takes a texture of a size.
#[track_caller]
fn taken(cx: &mut Context, job: &MipmapJob<'_>, proxy: GLenum, size: [i32; 3]) -> bool {
    let probe = MipmapJob { target: proxy, data: &Pixels::Null, ..*job };
    upload(cx, &probe, 0, size, job.type_, Pixels::Null);
    let mut width = [0];
    cx.get_tex_level_parameteriv(proxy, 0, GL_TEXTURE_WIDTH, &mut width);
    width[0] != 0
}

/// The rules of the `...MipmapLevels` functions: powers of two, and base and max among the levels that there are.
fn legal(levels: MipmapLevels, size: [i32; 3]) -> Result<(), ImageError> {
    let MipmapLevels { level, base, max } = levels;
    let power = size.iter().all(|n| n.count_ones() == 1);
    let last = size.iter().map(|n| n.ilog2() as i32).max().unwrap_or(0);
    if !power {
        return Err(invalid_value("the sizes must be powers of two; gluBuildMipmaps scales other ones").into());
    }
    // 64 levels are more than any size has, and keep the sums small.
    if !(0..=64).contains(&level) || base < level || max < base || max > level + last {
        return Err(invalid_value("level <= base <= max must hold, and max must be one of the image's levels").into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_go_to_the_nearer_power_of_two() {
        let table = [
            (1, 1),
            (2, 2),
            (3, 4),
            (4, 4),
            (5, 4),
            (6, 8),
            (7, 8),
            (8, 8),
            (10, 8),
            (12, 16),
            (23, 16),
            (24, 32),
            (48, 64),
            (60, 64),
            (95, 64),
            (97, 128),
            (100, 128),
            (191, 128),
            (193, 256),
            (255, 256),
            (256, 256),
        ];
        for (n, want) in table {
            assert_eq!(nearest_power(n), want, "{n}");
        }
        assert_eq!(nearest_power(i32::MAX), 1 << 29);
    }

    #[test]
    fn levels_must_be_in_order_and_exist() {
        let ok = |level, base, max, size| legal(MipmapLevels { level, base, max }, size).is_ok();
        assert!(ok(0, 0, 3, [8, 1, 1]) && ok(1, 2, 3, [8, 4, 1]) && ok(0, 0, 0, [1, 1, 1]));
        assert!(!ok(0, 0, 4, [8, 1, 1]) && !ok(1, 0, 3, [8, 1, 1]) && !ok(0, 2, 1, [8, 1, 1]));
        assert!(!ok(0, 0, 1, [6, 2, 1]) && !ok(-1, 0, 0, [8, 1, 1]) && !ok(i32::MAX, i32::MAX, i32::MAX, [8, 1, 1]));
    }
}
