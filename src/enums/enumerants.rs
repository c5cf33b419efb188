//! `enumerants!` makes a table of names: a constant for each row, and `ALL`, the rows as pairs of value and name.

macro_rules! enumerants {
    ($($name:ident = $value:literal;)*) => {
        $(#[doc = concat!("`", stringify!($name), "`")] pub const $name: $crate::enums::GLenum = $value;)*
        pub(super) const ALL: &[($crate::enums::GLenum, &str)] = &[$(($value, stringify!($name))),*];
    };
}
pub(super) use enumerants;
