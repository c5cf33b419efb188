//! What a display list can hold (OpenGL 1.5, section 5.4): for each chapter an `Op`, whose variants are the commands of
//! the chapter that a list records, in the one form that the engine knows. Only data: how an op is carried out is in
//! `generate.rs`, so that a list does not need the context that holds it.

use super::chapters::for_each_chapter;

/// The commands of some rows.
macro_rules! op {
    () => {};
    ($( $name:ident ( $($a:ident : $k:tt),* ) ; )*) => {
        /// The commands of this chapter that a display list can hold.
        #[expect(non_camel_case_types, reason = "an op carries the name of the command in C")]
        #[allow(clippy::enum_variant_names, reason = "an op carries the name of the command in C")]
        #[derive(Clone, Debug)]
        pub(crate) enum Op {
            $( $name { $($a: $crate::context::table::arg_kinds::owned_ty!($k)),* }, )*
        }
    };
}

macro_rules! ops {
    (
        title $title:literal;
        canonical { $( $class:ident $name:ident $snake:ident ( $($a:ident : $k:tt),* ) ; )* }
        commands { $( $(#[$doc:meta])* $c_class:ident $c_name:ident $(| $c_alias:ident)*
            $c_snake:ident ( $($ca:ident : $ck:tt),* ) ; )* }
        $($others:tt)*
    ) => {
        op! {
            $( $name ( $($a : $k),* ) ; )*
            $( $c_name ( $($ca : $ck),* ) ; )*
        }
    };
}

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        $( pub(crate) mod $chapter {
            $crate::context::table::$chapter::$table!(ops);
        } )*
    };
}
for_each_chapter!(chapters);
