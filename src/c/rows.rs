//! One safe C-named function for every row of the table. Each takes the current context, calls the method of the same
//! row, and puts the context back.
#![expect(non_snake_case, reason = "the names are GL's own")]

use super::current;
use crate::context::table::{arg_kinds::door_ty, chapters::for_each_chapter};

/// What a function of this door returns: `GLboolean` in the place of `bool`.
macro_rules! c_return {
    () => { () };
    (bool) => { u8 };
    (int) => { i32 };
    (str) => { &'static str };
    ($unsigned:ident) => { u32 };
}

macro_rules! c_value {
    (bool, $value:expr) => {
        u8::from($value)
    };
    ($($other:ident)?, $value:expr) => {
        $value
    };
}

/// The functions of some rows.
macro_rules! functions {
    ($( $name:ident $(| $alias:ident)* $snake:ident ( $($a:ident : $k:tt),* ) $([$out:ident : $t:ty])? $(-> $r:tt)? ; )*) => {
        $(
            #[doc = concat!("See [`Context::", stringify!($snake), "`](crate::Context::", stringify!($snake), ").")]
            #[allow(clippy::too_many_arguments, reason = "the commands are GL's")]
            #[allow(clippy::extra_unused_lifetimes, reason = "only memory arguments have the lifetime")]
            #[track_caller]
            pub fn $name<'a>(
                $($a: door_ty!($k),)*
                $($out: &mut (impl crate::context::OutSlice<$t> + ?Sized))?
            ) -> c_return!($($r)?) {
                match current::take().context() {
                    Some(cx) => {
                        let result = cx.$snake($($a,)* $($out)?);
                        c_value!($($r)?, result)
                    }
                    None => {
                        current::missed(stringify!($name));
                        Default::default()
                    }
                }
            }
            $( pub use self::$name as $alias; )*
        )*
    };
}

macro_rules! c_door {
    (
        title $title:literal;
        canonical { $($canonical:tt)* }
        commands { $( $(#[$doc:meta])* $c_class:ident $c_name:ident $(| $c_alias:ident)*
            $c_snake:ident ( $($ca:ident : $ck:tt),* ) ; )* }
        forms { $( family $sentence:literal { $( $(#[$f_doc:meta])* $f_class:ident $f_name:ident $(| $f_alias:ident)*
            $f_snake:ident ( $($fa:ident : $fk:tt),* ) => $op:ident ( $($fe:expr),* ) ; )* } )* }
        context { $( $(#[$o_doc:meta])* $o_class:ident $o_name:ident $(| $o_alias:ident)*
            $o_snake:ident ( $($oa:ident : $ok:tt),* ) $(-> $or:tt)? ; )* }
        now { $( $(#[$n_doc:meta])* $n_class:ident $n_name:ident $(| $n_alias:ident)*
            $n_snake:ident ( $($na:ident : $nk:tt),* ) $(-> $nr:tt)? ; )* }
        queries { $( family $q_sentence:literal { $( $(#[$q_doc:meta])* $q_name:ident $(| $q_alias:ident)*
            $q_snake:ident ( $($qa:ident : $qk:tt),* ) -> $q_type:ident => $query:ident ( $($qe:expr),* ) ; )* } )* }
        answers { $($answers:tt)* }
        manual { $($manual:tt)* }
    ) => {
        functions! {
            $( $c_name $(| $c_alias)* $c_snake ( $($ca : $ck),* ) ; )*
            $( $( $f_name $(| $f_alias)* $f_snake ( $($fa : $fk),* ) ; )* )*
            $( $o_name $(| $o_alias)* $o_snake ( $($oa : $ok),* ) $(-> $or)? ; )*
            $( $n_name $(| $n_alias)* $n_snake ( $($na : $nk),* ) $(-> $nr)? ; )*
            $( $( $q_name $(| $q_alias)* $q_snake ( $($qa : $qk),* ) [params : $q_type] ; )* )*
        }
    };
}

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        $( $crate::context::table::$chapter::$table!(c_door); )*
    };
}
for_each_chapter!(chapters);
