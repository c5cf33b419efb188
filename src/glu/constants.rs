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
    /// TessCallback: triangles or a boundary begin.
    GLU_TESS_BEGIN = 100_100;
    /// The older name.
    GLU_BEGIN = 100_100;
    /// TessCallback: a vertex.
    GLU_TESS_VERTEX = 100_101;
    /// The older name.
    GLU_VERTEX = 100_101;
    /// TessCallback: triangles or a boundary end.
    GLU_TESS_END = 100_102;
    /// The older name.
    GLU_END = 100_102;
    /// TessCallback: an error.
    GLU_TESS_ERROR = 100_103;
    /// TessCallback: whether edges lie on the boundary.
    GLU_TESS_EDGE_FLAG = 100_104;
    /// The older name.
    GLU_EDGE_FLAG = 100_104;
    /// TessCallback: makes the data of a new vertex.
    GLU_TESS_COMBINE = 100_105;
    /// TessCallback: begin, with the polygon's data.
    GLU_TESS_BEGIN_DATA = 100_106;
    /// TessCallback: vertex, with the polygon's data.
    GLU_TESS_VERTEX_DATA = 100_107;
    /// TessCallback: end, with the polygon's data.
    GLU_TESS_END_DATA = 100_108;
    /// TessCallback: error, with the polygon's data.
    GLU_TESS_ERROR_DATA = 100_109;
    /// TessCallback: edge flag, with the polygon's data.
    GLU_TESS_EDGE_FLAG_DATA = 100_110;
    /// TessCallback: combine, with the polygon's data.
    GLU_TESS_COMBINE_DATA = 100_111;
    /// NextContour: a contour that goes around the inside clockwise. (The kind of a contour makes no difference.)
    GLU_CW = 100_120;
    /// NextContour: a contour that goes around the inside counter-clockwise.
    GLU_CCW = 100_121;
    /// NextContour: a contour within the others.
    GLU_INTERIOR = 100_122;
    /// NextContour: a contour around the others.
    GLU_EXTERIOR = 100_123;
    /// NextContour: any contour.
    GLU_UNKNOWN = 100_124;
    /// Winding rule: odd numbers are inside.
    GLU_TESS_WINDING_ODD = 100_130;
    /// Winding rule: all but 0 are inside.
    GLU_TESS_WINDING_NONZERO = 100_131;
    /// Winding rule: 1 and more are inside.
    GLU_TESS_WINDING_POSITIVE = 100_132;
    /// Winding rule: -1 and less are inside.
    GLU_TESS_WINDING_NEGATIVE = 100_133;
    /// Winding rule: 2 and more, -2 and less are inside.
    GLU_TESS_WINDING_ABS_GEQ_TWO = 100_134;
    /// TessProperty: which winding numbers are inside.
    GLU_TESS_WINDING_RULE = 100_140;
    /// TessProperty: whether line loops are made instead of triangles.
    GLU_TESS_BOUNDARY_ONLY = 100_141;
    /// TessProperty: how far vertices may move to fall together.
    GLU_TESS_TOLERANCE = 100_142;
    /// A tessellator function without a polygon that was begun.
    GLU_TESS_MISSING_BEGIN_POLYGON = 100_151;
    /// A vertex without a contour that was begun.
    GLU_TESS_MISSING_BEGIN_CONTOUR = 100_152;
    /// A polygon that was not ended.
    GLU_TESS_MISSING_END_POLYGON = 100_153;
    /// A contour that was not ended.
    GLU_TESS_MISSING_END_CONTOUR = 100_154;
    /// A coordinate beyond `GLU_TESS_MAX_COORD`.
    GLU_TESS_COORD_TOO_LARGE = 100_155;
    /// Edges cross, and there is no combine callback.
    GLU_TESS_NEED_COMBINE_CALLBACK = 100_156;
    /// The number of `GLU_TESS_MISSING_BEGIN_POLYGON`.
    GLU_TESS_ERROR1 = 100_151;
    /// The number of `GLU_TESS_MISSING_BEGIN_CONTOUR`.
    GLU_TESS_ERROR2 = 100_152;
    /// The number of `GLU_TESS_MISSING_END_POLYGON`.
    GLU_TESS_ERROR3 = 100_153;
    /// The number of `GLU_TESS_MISSING_END_CONTOUR`.
    GLU_TESS_ERROR4 = 100_154;
    /// The number of `GLU_TESS_COORD_TOO_LARGE`.
    GLU_TESS_ERROR5 = 100_155;
    /// The number of `GLU_TESS_NEED_COMBINE_CALLBACK`.
    GLU_TESS_ERROR6 = 100_156;
    /// An error that does not occur.
    GLU_TESS_ERROR7 = 100_157;
    /// An error that does not occur.
    GLU_TESS_ERROR8 = 100_158;
}

/// The largest coordinate that the tessellator takes.
pub const GLU_TESS_MAX_COORD: f64 = 1e150;
