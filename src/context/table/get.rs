//! Chapter of the table: queries of state (OpenGL 1.5, chapter 6). The engine answers with the kind of the variable, and
//! the answer is converted to the type that the command asks for (section 6.1.2).

macro_rules! get_table { ($generate:ident) => { $generate! {
    title "Queries (chapter 6)";
    canonical {}
    commands {}
    forms {}
    context {
        /// The code of the first error since the last question, or `NO_ERROR`; asking clears it (section 2.5).
        now glGetError get_error() -> enum;
    }
    now {
        /// Whether a capability is on (section 6.1.1). `INVALID_ENUM` if there is none of this name.
        now glIsEnabled is_enabled(cap: enum) -> bool;
        /// Vendor, renderer, version or extensions (section 6.1.11). `INVALID_ENUM` for other names.
        now glGetString get_string(name: enum) -> str;
    }
    queries {
        family "State variables by name (section 6.1.1). `INVALID_ENUM` for names that do not exist, `INVALID_VALUE` if the slice is too short for the answer." {
            glGetBooleanv get_booleanv(pname: enum) -> u8 => get(pname);
            #[doc = include_str!("examples/get.md")]
            glGetIntegerv get_integerv(pname: enum) -> i32 => get(pname);
            glGetFloatv get_floatv(pname: enum) -> f32 => get(pname);
            glGetDoublev get_doublev(pname: enum) -> f64 => get(pname);
        }
        family "The address (or the offset) that a pointer command has set (section 6.1.11)." {
            glGetPointerv | glGetPointervEXT get_pointerv(pname: enum) -> usize => get_pointer(pname);
        }
    }
    answers {
        get(pname: enum);
        get_pointer(pname: enum);
    }
    manual {}
} } }

pub(crate) use get_table;
