//! Formats and types of client pixels (OpenGL 1.5, section 3.6.4, tables 3.5 to 3.8). A format says which components a
//! group has, a type how they are coded; the packed types put a whole group into one element. The tables come first,
//! [`PixelFormat::new`] reads them: what no table knows is INVALID_ENUM, a packed type with a format it cannot hold is
//! INVALID_OPERATION.

use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_enum, invalid_operation};

/// What the groups of a format are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelKind {
    /// Red, green, blue, alpha, luminance in some selection.
    Color,
    /// A colour index.
    Index,
    /// A stencil index.
    Stencil,
    /// A depth.
    Depth,
    /// A depth and a stencil index in one element.
    DepthStencil,
}

/// A format of table 3.6: the components of a group in the order of memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// COLOR_INDEX
    ColorIndex,
    /// STENCIL_INDEX
    StencilIndex,
    /// DEPTH_COMPONENT
    DepthComponent,
    /// DEPTH_STENCIL of EXT_packed_depth_stencil
    DepthStencil,
    /// RED
    Red,
    /// GREEN
    Green,
    /// BLUE
    Blue,
    /// ALPHA
    Alpha,
    /// RGB
    Rgb,
    /// RGBA
    Rgba,
    /// BGR
    Bgr,
    /// BGRA
    Bgra,
    /// ABGR of EXT_abgr
    Abgr,
    /// LUMINANCE
    Luminance,
    /// LUMINANCE_ALPHA
    LuminanceAlpha,
}

/// Every format with its name, its kind, and where each component goes in R, G, B, A (a luminance goes to R).
const FORMATS: [(GLenum, Format, PixelKind, &[usize]); 15] = [
    (GL_COLOR_INDEX, Format::ColorIndex, PixelKind::Index, &[0]),
    (GL_STENCIL_INDEX, Format::StencilIndex, PixelKind::Stencil, &[0]),
    (GL_DEPTH_COMPONENT, Format::DepthComponent, PixelKind::Depth, &[0]),
    (GL_DEPTH_STENCIL_EXT, Format::DepthStencil, PixelKind::DepthStencil, &[0]),
    (GL_RED, Format::Red, PixelKind::Color, &[0]),
    (GL_GREEN, Format::Green, PixelKind::Color, &[1]),
    (GL_BLUE, Format::Blue, PixelKind::Color, &[2]),
    (GL_ALPHA, Format::Alpha, PixelKind::Color, &[3]),
    (GL_RGB, Format::Rgb, PixelKind::Color, &[0, 1, 2]),
    (GL_RGBA, Format::Rgba, PixelKind::Color, &[0, 1, 2, 3]),
    (GL_BGR, Format::Bgr, PixelKind::Color, &[2, 1, 0]),
    (GL_BGRA, Format::Bgra, PixelKind::Color, &[2, 1, 0, 3]),
    (GL_ABGR_EXT, Format::Abgr, PixelKind::Color, &[3, 2, 1, 0]),
    (GL_LUMINANCE, Format::Luminance, PixelKind::Color, &[0]),
    (GL_LUMINANCE_ALPHA, Format::LuminanceAlpha, PixelKind::Color, &[0, 3]),
];

impl Format {
    fn row(self) -> &'static (GLenum, Format, PixelKind, &'static [usize]) {
        &FORMATS[self as usize]
    }

    /// GL's name.
    #[cfg(test)]
    pub fn name(self) -> GLenum {
        self.row().0
    }

    /// What its groups are.
    #[must_use]
    pub fn kind(self) -> PixelKind {
        self.row().2
    }

    /// Where each component of a group goes in R, G, B, A; a luminance goes to R.
    #[must_use]
    pub fn channels(self) -> &'static [usize] {
        self.row().3
    }

    /// Whether it has a luminance.
    #[must_use]
    pub fn is_luminance(self) -> bool {
        matches!(self, Format::Luminance | Format::LuminanceAlpha)
    }
}

/// A packed type of table 3.8: a group in one element.
#[derive(Debug, PartialEq, Eq)]
pub struct Packing {
    /// GL's name.
    pub name: GLenum,
    /// Bytes of the element: 1, 2 or 4.
    pub bytes: usize,
    /// Bits of each component, the first component first; 0 where there is none.
    pub bits: [u32; 4],
    /// By how much each component is shifted to the left.
    pub shifts: [u32; 4],
}

const fn packing(name: GLenum, bits: [u32; 4], reversed: bool) -> Packing {
    let total = bits[0] + bits[1] + bits[2] + bits[3];
    let mut shifts = [0; 4];
    let (mut i, mut used) = (0, 0);
    while i < 4 {
        shifts[i] = if reversed { used } else { total - used - bits[i] };
        used += bits[i];
        i += 1;
    }
    Packing { name, bytes: total as usize / 8, bits, shifts }
}

/// The packed types. Three components go with RGB, four with RGBA, BGRA and ABGR.
pub static PACKINGS: [Packing; 12] = [
    packing(GL_UNSIGNED_BYTE_3_3_2, [3, 3, 2, 0], false),
    packing(GL_UNSIGNED_BYTE_2_3_3_REV, [3, 3, 2, 0], true),
    packing(GL_UNSIGNED_SHORT_5_6_5, [5, 6, 5, 0], false),
    packing(GL_UNSIGNED_SHORT_5_6_5_REV, [5, 6, 5, 0], true),
    packing(GL_UNSIGNED_SHORT_4_4_4_4, [4, 4, 4, 4], false),
    packing(GL_UNSIGNED_SHORT_4_4_4_4_REV, [4, 4, 4, 4], true),
    packing(GL_UNSIGNED_SHORT_5_5_5_1, [5, 5, 5, 1], false),
    packing(GL_UNSIGNED_SHORT_1_5_5_5_REV, [5, 5, 5, 1], true),
    packing(GL_UNSIGNED_INT_8_8_8_8, [8, 8, 8, 8], false),
    packing(GL_UNSIGNED_INT_8_8_8_8_REV, [8, 8, 8, 8], true),
    packing(GL_UNSIGNED_INT_10_10_10_2, [10, 10, 10, 2], false),
    packing(GL_UNSIGNED_INT_2_10_10_10_REV, [10, 10, 10, 2], true),
];

/// A type of table 3.5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// BITMAP: one bit a group.
    Bitmap,
    /// UNSIGNED_BYTE
    UnsignedByte,
    /// BYTE
    Byte,
    /// UNSIGNED_SHORT
    UnsignedShort,
    /// SHORT
    Short,
    /// UNSIGNED_INT
    UnsignedInt,
    /// INT
    Int,
    /// FLOAT
    Float,
    /// A packed type: a group in one element.
    Packed(&'static Packing),
    /// UNSIGNED_INT_24_8 of EXT_packed_depth_stencil.
    UnsignedInt248,
}

/// The types that are not packed, with the bytes of one element (0 for a bitmap).
const TYPES: [(GLenum, Type, usize); 9] = [
    (GL_BITMAP, Type::Bitmap, 0),
    (GL_UNSIGNED_BYTE, Type::UnsignedByte, 1),
    (GL_BYTE, Type::Byte, 1),
    (GL_UNSIGNED_SHORT, Type::UnsignedShort, 2),
    (GL_SHORT, Type::Short, 2),
    (GL_UNSIGNED_INT, Type::UnsignedInt, 4),
    (GL_INT, Type::Int, 4),
    (GL_FLOAT, Type::Float, 4),
    (GL_UNSIGNED_INT_24_8_EXT, Type::UnsignedInt248, 4),
];

impl Type {
    /// Bytes of one element; 0 for a bitmap.
    #[must_use]
    pub fn bytes(self) -> usize {
        match self {
            Type::Packed(packing) => packing.bytes,
            _ => TYPES.iter().find(|row| row.1 == self).map_or(0, |row| row.2),
        }
    }

    fn find(value: GLenum) -> Option<Type> {
        let packed = || PACKINGS.iter().find(|p| p.name == value).map(Type::Packed);
        TYPES.iter().find(|row| row.0 == value).map(|row| row.1).or_else(packed)
    }
}

/// Which command the pixels are for: they do not all take every format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// ReadPixels (section 4.3.2).
    ReadPixels,
    /// DrawPixels (section 3.6.4).
    DrawPixels,
    /// TexImage and TexSubImage (section 3.8.1).
    TexImage,
    /// GetTexImage (section 6.1.4).
    GetTexImage,
}

/// A legal pair of format and type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelFormat {
    /// The format.
    pub format: Format,
    /// The type.
    pub type_: Type,
}

impl PixelFormat {
    /// The pair, if any command takes it.
    pub fn new(format: GLenum, type_: GLenum) -> Outcome<PixelFormat> {
        let &(_, form, kind, _) = FORMATS.iter().find(|row| row.0 == format).ok_or_else(|| {
            invalid_enum(format!("{} is not a pixel format; pass GL_RGBA, GL_LUMINANCE or the like", name(format)))
        })?;
        let typ = Type::find(type_).ok_or_else(|| {
            invalid_enum(format!("{} is not a pixel type; pass GL_UNSIGNED_BYTE, GL_FLOAT or the like", name(type_)))
        })?;
        let pair = || format!("type {} does not go with format {}", name(type_), name(format));
        match typ {
            Type::Bitmap if !matches!(kind, PixelKind::Index | PixelKind::Stencil) => {
                Err(invalid_enum(format!("{}; a bitmap holds indices only", pair())))
            }
            Type::Packed(packing) => {
                let held = if packing.bits[3] == 0 {
                    form == Format::Rgb
                } else {
                    matches!(form, Format::Rgba | Format::Bgra | Format::Abgr)
                };
                if held {
                    Ok(PixelFormat { format: form, type_: typ })
                } else {
                    let fits = if packing.bits[3] == 0 { "GL_RGB" } else { "GL_RGBA, GL_BGRA or GL_ABGR_EXT" };
                    Err(invalid_operation(format!("{}; it packs {fits}", pair())))
                }
            }
            Type::UnsignedInt248 if form != Format::DepthStencil => {
                Err(invalid_operation(format!("{}; it packs GL_DEPTH_STENCIL_EXT", pair())))
            }
            _ if form == Format::DepthStencil && typ != Type::UnsignedInt248 => {
                Err(invalid_enum(format!("{}; pass GL_UNSIGNED_INT_24_8_EXT", pair())))
            }
            _ => Ok(PixelFormat { format: form, type_: typ }),
        }
    }

    /// The pair for one command: textures take no stencil alone, and GetTexImage returns no indices.
    pub fn for_command(format: GLenum, type_: GLenum, purpose: Purpose) -> Outcome<PixelFormat> {
        let refused = |what: &str| -> GlError {
            invalid_enum(format!("{} is not a format of {what}; pass GL_RGBA, GL_LUMINANCE or the like", name(format)))
        };
        match (purpose, format) {
            (Purpose::TexImage, GL_STENCIL_INDEX) => Err(refused("a texture image")),
            (Purpose::GetTexImage, GL_COLOR_INDEX | GL_STENCIL_INDEX) => Err(refused("GetTexImage")),
            _ => PixelFormat::new(format, type_),
        }
    }

    /// What the groups are.
    #[must_use]
    pub fn kind(self) -> PixelKind {
        self.format.kind()
    }

    /// Elements of a group: one for a packed type.
    #[must_use]
    pub fn elements(self) -> usize {
        match self.type_ {
            Type::Packed(_) | Type::UnsignedInt248 => 1,
            _ => self.format.channels().len(),
        }
    }

    /// Bytes of a group; 0 for a bitmap.
    #[must_use]
    pub fn group_bytes(self) -> usize {
        self.elements() * self.type_.bytes()
    }
}

#[cfg(test)]
pub(crate) fn all_pairs() -> impl Iterator<Item = (GLenum, GLenum)> {
    let types = || TYPES.iter().map(|row| row.0).chain(PACKINGS.iter().map(|p| p.name));
    FORMATS.iter().flat_map(move |row| types().map(move |t| (row.0, t)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_formats_is_in_the_order_of_the_enum() {
        for row in FORMATS {
            assert_eq!(row.1.name(), row.0);
        }
    }

    #[test]
    fn every_pair_is_legal_or_has_the_right_error() {
        let mut legal = 0;
        for (format, type_) in all_pairs() {
            let color =
                !matches!(format, GL_COLOR_INDEX | GL_STENCIL_INDEX | GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL_EXT);
            let want = match type_ {
                GL_BITMAP if color || format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL_EXT => GL_INVALID_ENUM,
                GL_UNSIGNED_BYTE_3_3_2
                | GL_UNSIGNED_BYTE_2_3_3_REV
                | GL_UNSIGNED_SHORT_5_6_5
                | GL_UNSIGNED_SHORT_5_6_5_REV
                    if format != GL_RGB =>
                {
                    GL_INVALID_OPERATION
                }
                GL_UNSIGNED_SHORT_4_4_4_4
                | GL_UNSIGNED_SHORT_4_4_4_4_REV
                | GL_UNSIGNED_SHORT_5_5_5_1
                | GL_UNSIGNED_SHORT_1_5_5_5_REV
                | GL_UNSIGNED_INT_8_8_8_8
                | GL_UNSIGNED_INT_8_8_8_8_REV
                | GL_UNSIGNED_INT_10_10_10_2
                | GL_UNSIGNED_INT_2_10_10_10_REV
                    if format != GL_RGBA && format != GL_BGRA && format != GL_ABGR_EXT =>
                {
                    GL_INVALID_OPERATION
                }
                GL_UNSIGNED_INT_24_8_EXT if format != GL_DEPTH_STENCIL_EXT => GL_INVALID_OPERATION,
                GL_BYTE | GL_UNSIGNED_BYTE | GL_SHORT | GL_UNSIGNED_SHORT | GL_INT | GL_UNSIGNED_INT | GL_FLOAT
                    if format == GL_DEPTH_STENCIL_EXT =>
                {
                    GL_INVALID_ENUM
                }
                _ => GL_NO_ERROR,
            };
            let got = PixelFormat::new(format, type_).map_or_else(|e| e.code, |_| GL_NO_ERROR);
            assert_eq!(got, want, "{} {}", name(format), name(type_));
            legal += usize::from(want == GL_NO_ERROR);
        }
        // 14 formats by 7 plain types, two index formats as bitmaps, 4 types of RGB, 8 types of RGBA, BGRA and ABGR, 24_8.
        assert_eq!(legal, 14 * 7 + 2 + 4 + 24 + 1);
    }

    #[test]
    fn unknown_names_are_invalid_enums() {
        assert_eq!(PixelFormat::new(GL_TEXTURE_2D, GL_FLOAT).unwrap_err().code, GL_INVALID_ENUM);
        assert_eq!(PixelFormat::new(GL_RGBA, GL_DOUBLE).unwrap_err().code, GL_INVALID_ENUM);
        assert_eq!(PixelFormat::new(4, GL_UNSIGNED_BYTE).unwrap_err().code, GL_INVALID_ENUM);
        for (format, purpose) in [
            (GL_STENCIL_INDEX, Purpose::TexImage),
            (GL_COLOR_INDEX, Purpose::GetTexImage),
            (GL_STENCIL_INDEX, Purpose::GetTexImage),
        ] {
            let got = PixelFormat::for_command(format, GL_UNSIGNED_BYTE, purpose);
            assert_eq!(got.unwrap_err().code, GL_INVALID_ENUM);
        }
        assert!(PixelFormat::for_command(GL_COLOR_INDEX, GL_BITMAP, Purpose::TexImage).is_ok());
    }

    #[test]
    fn shifts_of_packed_types_follow_their_bits() {
        let find = |n| PACKINGS.iter().find(|p| p.name == n).unwrap();
        assert_eq!(find(GL_UNSIGNED_BYTE_3_3_2).shifts[..3], [5, 2, 0]);
        assert_eq!(find(GL_UNSIGNED_BYTE_2_3_3_REV).shifts[..3], [0, 3, 6]);
        assert_eq!(find(GL_UNSIGNED_SHORT_5_5_5_1).shifts, [11, 6, 1, 0]);
        assert_eq!(find(GL_UNSIGNED_INT_2_10_10_10_REV).shifts, [0, 10, 20, 30]);
    }
}
