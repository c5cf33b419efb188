//! `gl_enum!` makes a Rust enum of the enumerants that one state variable may have. Commands check a [`GLenum`] once, with
//! `from_gl`; from there on state and pipeline know only the enum, so a `match` on it needs no arm for wrong values and a
//! new row does not compile until every `match` has an answer for it.
//!
//! [`GLenum`]: super::GLenum

/// One row for each value: `Variant = GL_NAME`. `from_gl` is the check, `gl` the value, `name` GL's name, `ALL` every
/// value in the order of the rows.
macro_rules! gl_enum {
    (
        $(#[$attribute:meta])*
        $vis:vis enum $Enum:ident { $( $(#[$row:meta])* $Variant:ident = $GL:ident ),+ $(,)? }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $Enum { $( #[doc = concat!("`", stringify!($GL), "`")] $(#[$row])* $Variant ),+ }

        #[allow(dead_code, reason = "every enum has the same methods, whether or not they are asked for")]
        impl $Enum {
            /// Every value, in the order of the rows.
            pub const ALL: [Self; [$(Self::$Variant),+].len()] = [$(Self::$Variant),+];

            /// The value that an enumerant stands for, if it stands for one.
            #[inline]
            #[must_use]
            pub const fn from_gl(value: $crate::enums::GLenum) -> Option<Self> {
                match value {
                    $( $crate::enums::$GL => Some(Self::$Variant), )+
                    _ => None,
                }
            }

            /// The enumerant.
            #[inline]
            #[must_use]
            pub const fn gl(self) -> $crate::enums::GLenum {
                match self { $( Self::$Variant => $crate::enums::$GL, )+ }
            }

            /// The enumerant's name.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $( Self::$Variant => stringify!($GL), )+ }
            }
        }
    };
}
pub(crate) use gl_enum;

#[cfg(test)]
mod tests {
    use crate::enums::{GL_LINEAR, GL_NEAREST, GL_REPEAT};

    gl_enum! {
        /// Two values.
        enum Filter {
            Nearest = GL_NEAREST,
            Linear = GL_LINEAR,
        }
    }

    #[test]
    fn a_row_is_a_check_a_value_and_a_name() {
        assert_eq!(Filter::from_gl(GL_LINEAR), Some(Filter::Linear));
        assert_eq!(Filter::from_gl(GL_REPEAT), None);
        assert_eq!(Filter::ALL.map(Filter::gl), [GL_NEAREST, GL_LINEAR]);
        assert_eq!(Filter::Nearest.name(), "GL_NEAREST");
    }
}
