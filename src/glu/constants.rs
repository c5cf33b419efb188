//! The constants of GLU 1.3 that this library takes or returns, with GLU's own names and values.

use crate::enums::GLenum;

/// False.
pub const GLU_FALSE: u8 = 0;
/// True.
pub const GLU_TRUE: u8 = 1;

macro_rules! constants {
    ($($(#[$doc:meta])* $name:ident = $value:literal;)*) => {
        $($(#[$doc])* pub const $name: GLenum = $value;)*
    };
}

constants! {
    /// GetString: the version.
    GLU_VERSION = 100_800;
    /// GetString: the extensions.
    GLU_EXTENSIONS = 100_801;
    /// An enumerant that the function does not take.
    GLU_INVALID_ENUM = 100_900;
    /// A number out of range.
    GLU_INVALID_VALUE = 100_901;
    /// Not enough memory.
    GLU_OUT_OF_MEMORY = 100_902;
    /// A function that the GL cannot carry out.
    GLU_INCOMPATIBLE_GL_VERSION = 100_903;
    /// A combination that is not allowed (a packed type with a format of another size).
    GLU_INVALID_OPERATION = 100_904;
    /// Quadrics are drawn as points.
    GLU_POINT = 100_010;
    /// Quadrics are drawn as lines.
    GLU_LINE = 100_011;
    /// Quadrics are drawn as polygons.
    GLU_FILL = 100_012;
    /// Quadrics are drawn as lines, without those between coplanar faces.
    GLU_SILHOUETTE = 100_013;
    /// A normal a vertex.
    GLU_SMOOTH = 100_000;
    /// A normal a facet.
    GLU_FLAT = 100_001;
    /// No normals.
    GLU_NONE = 100_002;
    /// Normals point outward.
    GLU_OUTSIDE = 100_020;
    /// Normals point inward.
    GLU_INSIDE = 100_021;
    /// QuadricCallback: the function that is told of errors.
    GLU_ERROR = 100_103;
}
