//! Texture completeness (OpenGL 1.5, section 3.8.10): whether the images of an object fit together so that it can be
//! sampled, and if not, why, and what the program has to change. An incomplete texture switches texturing of its unit off
//! without a GL error, so the reason is given in words.

use super::image::Image;
use super::object::TextureObject;
use crate::limits::MAX_TEXTURE_LEVELS;
use crate::state::texture::Target;
use crate::state::texture::TextureFilter;
use std::fmt;

/// Why a texture is incomplete. `Display` says it in a sentence with the remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Incomplete {
    /// `TEXTURE_BASE_LEVEL` is above `TEXTURE_MAX_LEVEL` or beyond all levels.
    Levels {
        /// The base level.
        base: i32,
        /// The last level.
        max: i32,
    },
    /// The base level has no image (of a face).
    NoBase {
        /// The face of a cube map, 0 for other targets.
        face: usize,
        /// The base level.
        level: usize,
        /// How many levels below the base level do have an image.
        others: usize,
    },
    /// A mipmap filter is set, but a level is missing.
    MissingLevel {
        /// The face of a cube map, 0 for other targets.
        face: usize,
        /// The level without an image.
        level: usize,
        /// The size that the image has to have.
        size: [u32; 3],
        /// The minification filter.
        filter: TextureFilter,
    },
    /// A level does not have the size that follows from the base level.
    WrongSize {
        /// The face.
        face: usize,
        /// The level.
        level: usize,
        /// The size that it has.
        found: [u32; 3],
        /// The size that it has to have.
        expected: [u32; 3],
    },
    /// A level or a face differs from the base level in internal format or border.
    Differs {
        /// The face.
        face: usize,
        /// The level.
        level: usize,
        /// What differs.
        what: &'static str,
    },
    /// The faces of a cube map do not have one square size.
    NotSquare {
        /// The face that is not square or differs from the first.
        face: usize,
    },
}

impl fmt::Display for Incomplete {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |face: &usize| if *face == 0 { String::new() } else { format!(" of cube face {face}") };
        match self {
            Self::Levels { base, max } => write!(
                f,
                "GL_TEXTURE_BASE_LEVEL is {base} and GL_TEXTURE_MAX_LEVEL is {max}; the base level must exist and, for a \
                 filter that uses mipmaps, must not be above the last one"
            ),
            Self::NoBase { face, level, others: 0 } => {
                write!(f, "there is no image at level {level}{}; specify one with glTexImage", of(face))
            }
            Self::NoBase { face, level, others } => write!(
                f,
                "there is no image at level {level}{}, the base level, although {others} other levels have one; specify \
                 level {level} or set GL_TEXTURE_BASE_LEVEL",
                of(face)
            ),
            Self::MissingLevel { face, level, size: [w, h, d], filter } => write!(
                f,
                "the minification filter is {} and level {level}{} is missing; specify it with {w} x {h} x {d} texels, \
                 let GL_GENERATE_MIPMAP or gluBuild2DMipmaps make all levels, limit GL_TEXTURE_MAX_LEVEL, or set \
                 GL_TEXTURE_MIN_FILTER to GL_LINEAR (the initial filter uses mipmaps)",
                filter.name(),
                of(face)
            ),
            Self::WrongSize { face, level, found, expected } => write!(
                f,
                "level {level}{} has {} x {} x {} texels and needs {} x {} x {}: each level has half the size of the one \
                 before, rounded down, at least 1",
                of(face),
                found[0],
                found[1],
                found[2],
                expected[0],
                expected[1],
                expected[2]
            ),
            Self::Differs { face, level, what } => write!(
                f,
                "level {level}{} has another {what} than the base level; specify all levels and faces alike",
                of(face)
            ),
            Self::NotSquare { face } => {
                write!(f, "face {face} of the cube map is not square or not as large as face 0; make all six alike")
            }
        }
    }
}

impl TextureObject {
    /// Whether the object can be sampled with its present filters; if not, why.
    pub fn complete(&self) -> Result<(), Incomplete> {
        let p = &self.parameters;
        let levels = Incomplete::Levels { base: p.base_level, max: p.max_level };
        let base = match usize::try_from(p.base_level) {
            // The last level counts only for a filter that uses mipmaps (section 3.8.10).
            Ok(base) if base < MAX_TEXTURE_LEVELS && (p.base_level <= p.max_level || !p.min_filter.has_mipmaps()) => {
                base
            }
            _ => return Err(levels),
        };
        let first = self.base_image(0, base)?;
        for face in 0..self.faces.len() {
            let image = self.base_image(face, base)?;
            if self.target == Target::Cube && (image.width != image.height || image.width != first.width) {
                return Err(Incomplete::NotSquare { face });
            }
            alike(image, first, face, base)?;
            if p.min_filter.has_mipmaps() {
                self.levels_follow(face, base, image)?;
            }
        }
        Ok(())
    }

    fn base_image(&self, face: usize, level: usize) -> Result<&Image, Incomplete> {
        let image = self.image(face, level).map(AsRef::as_ref).filter(|image| !image.is_null());
        image.ok_or_else(|| {
            let others = self.faces.get(face).map_or(0, |levels| levels.iter().flatten().count());
            Incomplete::NoBase { face, level, others }
        })
    }

    /// The levels from the base to the last one, each half the size of the one before.
    fn levels_follow(&self, face: usize, base: usize, first: &Image) -> Result<(), Incomplete> {
        let last = usize::try_from(self.parameters.max_level).unwrap_or(0);
        let mut expected = [first.width, first.height, first.depth];
        for level in base + 1..=last {
            if expected == [1; 3] {
                break;
            }
            expected = expected.map(|n| (n / 2).max(1));
            let filter = self.parameters.min_filter;
            let Some(image) = self.image(face, level) else {
                return Err(Incomplete::MissingLevel { face, level, size: expected, filter });
            };
            let found = [image.width, image.height, image.depth];
            if found != expected {
                return Err(Incomplete::WrongSize { face, level, found, expected });
            }
            alike(image, first, face, level)?;
        }
        Ok(())
    }
}

fn alike(image: &Image, first: &Image, face: usize, level: usize) -> Result<(), Incomplete> {
    let differs = |what| Err(Incomplete::Differs { face, level, what });
    if image.internal_format != first.internal_format || image.format.requested != first.format.requested {
        return differs("internal format");
    }
    if image.border != first.border {
        return differs("border");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::*;
    use crate::state::texture::TextureFilter;
    use crate::texture::format::InternalFormat;
    use crate::texture::image::Dimensions;
    use std::sync::Arc;

    fn object(levels: &[(usize, u32)], filter: TextureFilter) -> TextureObject {
        let mut object = TextureObject::new(Target::D2);
        object.parameters.min_filter = filter;
        let format = InternalFormat::find(GL_RGBA8).expect("a format");
        for (level, size) in levels {
            let image = Image::new(format, Dimensions::Two, [*size, *size, 1], 0).expect("an image");
            object.faces[0][*level] = Some(Arc::new(image));
        }
        object
    }

    #[test]
    fn every_incomplete_texture_says_why() {
        let full = [(0, 4), (1, 2), (2, 1)];
        type Case<'a> = (&'a [(usize, u32)], TextureFilter, &'a str);
        let rows: [Case<'_>; 6] = [
            (&full, TextureFilter::LinearMipmapLinear, ""),
            (&full[..1], TextureFilter::Linear, ""),
            (&full[..2], TextureFilter::NearestMipmapLinear, "level 2 is missing"),
            (&[], TextureFilter::Linear, "no image at level 0"),
            (&full[1..], TextureFilter::Linear, "2 other levels"),
            (&[(0, 4), (1, 3), (2, 1)], TextureFilter::LinearMipmapNearest, "needs 2 x 2 x 1"),
        ];
        for (levels, filter, reason) in rows {
            match object(levels, filter).complete() {
                Ok(()) => assert_eq!(reason, ""),
                Err(why) => assert!(!reason.is_empty() && why.to_string().contains(reason), "{why}"),
            }
        }
    }

    #[test]
    fn a_last_level_limits_what_is_needed() {
        let mut limited = object(&[(0, 8), (1, 4)], TextureFilter::LinearMipmapLinear);
        assert!(limited.complete().is_err());
        limited.parameters.max_level = 1;
        assert_eq!(limited.complete(), Ok(()));
        limited.parameters.base_level = 2;
        assert_eq!(limited.complete(), Err(Incomplete::Levels { base: 2, max: 1 }));
        limited.parameters.min_filter = TextureFilter::Linear;
        assert!(matches!(limited.complete(), Err(Incomplete::NoBase { level: 2, .. })));
        (limited.parameters.base_level, limited.parameters.max_level) = (1, 0);
        assert_eq!(limited.complete(), Ok(()), "the base level alone is read");
    }
}
