//! GLU's words: error strings, its version, the search for an extension (GLU 1.3, chapters 2 and 8).

use super::constants::*;
use crate::enums::*;
use std::ffi::CStr;

/// An error code of GL or GLU in words, as C wants them.
pub(crate) fn error_words(error: GLenum) -> Option<&'static CStr> {
    Some(match error {
        GL_NO_ERROR => c"no error",
        GL_INVALID_ENUM | GLU_INVALID_ENUM => c"invalid enumerant",
        GL_INVALID_VALUE | GLU_INVALID_VALUE => c"invalid value",
        GL_INVALID_OPERATION | GLU_INVALID_OPERATION => c"invalid operation",
        GL_STACK_OVERFLOW => c"stack overflow",
        GL_STACK_UNDERFLOW => c"stack underflow",
        GL_OUT_OF_MEMORY | GLU_OUT_OF_MEMORY => c"out of memory",
        GL_TABLE_TOO_LARGE => c"table too large",
        GLU_INCOMPATIBLE_GL_VERSION => c"incompatible gl version",
        GLU_TESS_MISSING_BEGIN_POLYGON => c"gluTessBeginPolygon is missing",
        GLU_TESS_MISSING_BEGIN_CONTOUR => c"gluTessBeginContour is missing",
        GLU_TESS_MISSING_END_POLYGON => c"gluTessEndPolygon is missing",
        GLU_TESS_MISSING_END_CONTOUR => c"gluTessEndContour is missing",
        GLU_TESS_COORD_TOO_LARGE => c"a coordinate is too large",
        GLU_TESS_NEED_COMBINE_CALLBACK => c"edges cross: a combine callback is needed",
        _ => return None,
    })
}

/// GLU's strings, as C wants them.
pub(crate) fn words(name: GLenum) -> Option<&'static CStr> {
    match name {
        GLU_VERSION => Some(c"1.3"),
        GLU_EXTENSIONS => Some(c""),
        _ => None,
    }
}

/// An error code of GL or GLU in words, `None` for a number that is neither.
#[must_use]
pub fn error_string(error: GLenum) -> Option<&'static str> {
    error_words(error)?.to_str().ok()
}

/// GLU's version (`GLU_VERSION`) or its extensions (`GLU_EXTENSIONS`, none), `None` for another name.
#[must_use]
pub fn get_string(name: GLenum) -> Option<&'static str> {
    words(name)?.to_str().ok()
}

/// Whether the list `extensions` (names between blanks) has `name` as a whole word.
#[must_use]
pub fn check_extension(name: &str, extensions: &str) -> bool {
    !name.is_empty() && extensions.split_ascii_whitespace().any(|e| e == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_its_words() {
        assert_eq!(error_string(GL_NO_ERROR), Some("no error"));
        assert_eq!(error_string(GL_STACK_UNDERFLOW), Some("stack underflow"));
        assert_eq!(error_string(GLU_INVALID_VALUE), Some("invalid value"));
        assert_eq!(error_string(1), None);
        assert_eq!(get_string(GLU_VERSION), Some("1.3"));
        assert_eq!(get_string(GL_VERSION), None);
    }

    #[test]
    fn extensions_are_whole_words() {
        assert!(check_extension("GL_A", "GL_AB GL_A"));
        assert!(!check_extension("GL_A", "GL_AB"));
        assert!(!check_extension("", "GL_AB"));
    }
}
