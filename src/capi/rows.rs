//! One exported function for every row of the table and every alias, with the signature that the headers declare.

use super::{current, memory};
use crate::context::immediate_fast::{ImmediateFast, if_immediate_fast};
use crate::context::param_counts;
use crate::context::table::Query;
use std::collections::BTreeMap;
use std::ffi::{CString, c_void};
use std::sync::Mutex;

/// The type of an argument in C.
macro_rules! c_ty {
    (enum) => { u32 };
    (unit) => { u32 };
    (bits) => { u32 };
    (uint) => { u32 };
    (int) => { i32 };
    (float) => { f32 };
    (bool) => { u8 };
    (size) => { isize };
    ([$t:ty; $n:literal]) => { *const $t };
    ((slice $t:ty : $($count:tt)*)) => { *const $t };
    ((upto $t:ty : $($count:tt)*)) => { *const $t };
    ((out $t:ty : $($count:tt)*)) => { *mut $t };
    ((rect $($size:tt)*)) => { *const c_void };
    ((bytes $size:expr)) => { *const c_void };
    ((indices $count:ident, $type:ident)) => { *const c_void };
    (array) => { *const c_void };
    (($out:ident $($size:tt)*)) => { *mut c_void };
    ($t:ident) => { $t };
}

/// An argument of C as a safe door takes it.
macro_rules! from_c {
    ([$t:ty; $n:literal], $cx:ident, $a:ident) => { unsafe { memory::slice::<$t>($a, $n) } };
    ((slice $t:ty : $($count:tt)*), $cx:ident, $a:ident) => { unsafe { memory::slice::<$t>($a, param_counts::$($count)*) } };
    ((upto $t:ty : $($count:tt)*), $cx:ident, $a:ident) => { unsafe { memory::slice::<$t>($a, param_counts::$($count)*) } };
    ((out $t:ty : $($count:tt)*), $cx:ident, $a:ident) => { unsafe { memory::slice_mut::<$t>($a, param_counts::$($count)*) } };
    ((rect $size:expr, $format:expr, $type:expr), $cx:ident, $a:ident) => {{
        let n = memory::unpack_bytes($cx, $size, $format, $type);
        unsafe { memory::bytes($a, n) }
    }};
    ((bytes $size:expr), $cx:ident, $a:ident) => { unsafe { memory::bytes($a, param_counts::size($size)) } };
    ((rect_out $size:expr, $format:expr, $type:expr), $cx:ident, $a:ident) => {{
        let n = memory::pack_bytes($cx, $size, $format, $type);
        unsafe { memory::bytes_mut($a, n) }
    }};
    ((tex_out $target:expr, $level:expr, $format:expr, $type:expr), $cx:ident, $a:ident) => {{
        let n = $cx.engine.tex_image_bytes($target, $level, $format, $type);
        unsafe { memory::bytes_mut($a, n) }
    }};
    ((imaging_out $target:expr, $format:expr, $type:expr), $cx:ident, $a:ident) => {{
        let n = memory::imaging_bytes($cx, $target, $format, $type);
        unsafe { memory::bytes_mut($a, n) }
    }};
    ((bytes_out compressed_size($target:expr, $level:expr)), $cx:ident, $a:ident) => {{
        let n = $cx.engine.compressed_tex_image_bytes($target, $level);
        unsafe { memory::bytes_mut($a, n) }
    }};
    ((bytes_out $size:expr), $cx:ident, $a:ident) => { unsafe { memory::bytes_mut($a, param_counts::size($size)) } };
    (array, $cx:ident, $a:ident) => { unsafe { memory::array($a) } };
    ((indices $count:ident, $type:ident), $cx:ident, $a:ident) => { unsafe { memory::indices($cx, $a, $count, $type) } };
    ($k:tt, $cx:ident, $a:ident) => { $a };
}

macro_rules! c_return {
    () => { () };
    (bool) => { u8 };
    (int) => { i32 };
    (str) => { *const u8 };
    ($unsigned:ident) => { u32 };
}

macro_rules! c_value {
    (str, $value:expr) => {
        c_string($value)
    };
    (bool, $value:expr) => {
        u8::from($value)
    };
    ($($other:ident)?, $value:expr) => {
        $value
    };
}

/// A string that C may keep for ever: each one is made once. The empty one is null.
fn c_string(text: &'static str) -> *const u8 {
    static STRINGS: Mutex<BTreeMap<&'static str, CString>> = Mutex::new(BTreeMap::new());
    if text.is_empty() {
        return std::ptr::null();
    }
    let mut strings = STRINGS.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    strings.entry(text).or_insert_with(|| CString::new(text).unwrap_or_default()).as_ptr().cast()
}

/// Whether a command shows the drawing to the program.
const fn presents(name: &str) -> bool {
    matches!(name.as_bytes(), b"glFlush" | b"glFinish")
}

/// An argument of C as a command takes it that is tried [at once](crate::context::immediate_fast).
macro_rules! fast_argument {
    ([$t:ty; $n:literal], $a:ident, $out:lifetime) => {
        // SAFETY: the promise of the caller.
        match unsafe { memory::slice::<$t>($a, $n) }.first_chunk::<$n>() {
            Some(values) => values,
            None => break $out false,
        }
    };
    ($k:ident, $a:ident, $out:lifetime) => {
        crate::context::table::arg_kinds::plain!($k, $a)
    };
}

/// One exported function of a command that has a common path: that one is tried first, without a net for panics, of
/// which it has none. Everything else goes the long way, which is the way of all other commands.
macro_rules! quick_function {
    ($symbol:ident $snake:ident ( $($a:ident : $k:tt),* ) $op:ident ( $($e:expr),* )) => {
        /// # Safety
        /// Pointers must point to as much memory as GL asks for.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $symbol($($a: c_ty!($k)),*) {
            #[cold]
            #[inline(never)]
            unsafe extern "C" fn long($($a: c_ty!($k)),*) {
                current::command(stringify!($symbol), |cx| {
                    // SAFETY (of the blocks that the kinds make): the promise of the caller.
                    $( let $a = from_c!($k, cx, $a); )*
                    cx.$snake($($a),*)
                });
            }
            #[allow(unused_labels, reason = "numbers need no look")]
            let done = 'fast: {
                $( let $a = fast_argument!($k, $a, 'fast); )*
                current::quiet().is_some_and(|cx| ImmediateFast::$op(&mut cx.engine, $($e),*))
            };
            if !done {
                // SAFETY: the arguments are those of this call.
                unsafe { long($($a),*) };
            }
        }
    };
}

/// One exported function.
macro_rules! function {
    ($symbol:ident $name:ident $snake:ident ( $($a:ident : $k:tt),* ) [$($r:ident)?]) => {
        /// # Safety
        /// Pointers must point to as much memory as GL asks for.
        #[allow(clippy::too_many_arguments, reason = "the commands are GL's")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $symbol($($a: c_ty!($k)),*) -> c_return!($($r)?) {
            let result = current::command(stringify!($symbol), |cx| {
                // SAFETY (of the blocks that the kinds make): the promise of the caller.
                $( let $a = from_c!($k, cx, $a); )*
                cx.$snake($($a),*)
            });
            if const { presents(stringify!($name)) } {
                crate::capi::present::present();
            }
            c_value!($($r)?, result)
        }
    };
    ($symbol:ident $name:ident $snake:ident ( $($a:ident : $k:tt),* ) [] $t:ty) => {
        /// # Safety
        /// Pointers must point to as much memory as GL asks for.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $symbol($($a: c_ty!($k),)* params: *mut $t) {
            current::command(stringify!($symbol), |cx| {
                if let Some(values) = Query::$snake(cx, $($a),*) {
                    // SAFETY: the promise of the caller.
                    unsafe { memory::write(params, values.converted::<$t>()) };
                }
            });
        }
    };
}

/// The exported functions of one row: its name and its aliases.
macro_rules! exports {
    ($name:ident [$($alias:ident)*] $snake:ident $args:tt $ret:tt $($t:ty)?) => {
        function! { $name $name $snake $args $ret $($t)? }
        exports! { @aliases $name [$($alias)*] $snake $args $ret [$($t)?] }
    };
    (@aliases $name:ident [$($alias:ident)*] $snake:ident $args:tt $ret:tt $t:tt) => {
        $( exports! { @one $alias $name $snake $args $ret $t } )*
    };
    (@one $alias:ident $name:ident $snake:ident $args:tt $ret:tt [$($t:ty)?]) => {
        function! { $alias $name $snake $args $ret $($t)? }
    };
}

/// The exported functions of a typed form.
macro_rules! form_exports {
    ($name:ident [$($alias:ident)*] $snake:ident $args:tt $op:ident $call:tt) => {
        if_immediate_fast! { $op, {
            quick_function! { $name $snake $args $op $call }
            form_exports! { @aliases [$($alias)*] $snake $args $op $call }
        }, {
            exports! { $name [$($alias)*] $snake $args [] }
        } }
    };
    (@aliases [$($alias:ident)*] $snake:ident $args:tt $op:ident $call:tt) => {
        $( form_exports! { $alias [] $snake $args $op $call } )*
    };
}

macro_rules! c_abi {
    (
        title $title:literal;
        canonical { $($canonical:tt)* }
        commands { $( $(#[$doc:meta])* $c_class:ident $c_name:ident $(| $c_alias:ident)* $c_snake:ident $c_args:tt
            ; )* }
        forms { $( family $sentence:literal { $( $(#[$f_doc:meta])* $f_class:ident $f_name:ident $(| $f_alias:ident)*
            $f_snake:ident $f_args:tt => $op:ident $f_call:tt ; )* } )* }
        context { $( $(#[$o_doc:meta])* $o_class:ident $o_name:ident $(| $o_alias:ident)*
            $o_snake:ident $o_args:tt $(-> $or:ident)? ; )* }
        now { $( $(#[$n_doc:meta])* $n_class:ident $n_name:ident $(| $n_alias:ident)*
            $n_snake:ident $n_args:tt $(-> $nr:tt)? ; )* }
        queries { $( family $q_sentence:literal { $( $(#[$q_doc:meta])* $q_name:ident $(| $q_alias:ident)*
            $q_snake:ident $q_args:tt -> $q_type:ident => $query:ident $q_call:tt ; )* } )* }
        answers { $($answers:tt)* }
        manual { $($manual:tt)* }
    ) => {
        $( exports! { $c_name [$($c_alias)*] $c_snake $c_args [] } )*
        $( $( form_exports! { $f_name [$($f_alias)*] $f_snake $f_args $op $f_call } )* )*
        $( exports! { $o_name [$($o_alias)*] $o_snake $o_args [$($or)?] } )*
        $( exports! { $n_name [$($n_alias)*] $n_snake $n_args [$($nr)?] } )*
        $( $( exports! { $q_name [$($q_alias)*] $q_snake $q_args [] $q_type } )* )*

        /// The address of a function of this chapter.
        pub(super) fn find(name: &str) -> Option<*const c_void> {
            Some(match name {
                $( stringify!($c_name) => $c_name as *const c_void, $( stringify!($c_alias) => $c_alias as *const c_void, )* )*
                $( $( stringify!($f_name) => $f_name as *const c_void,
                    $( stringify!($f_alias) => $f_alias as *const c_void, )* )* )*
                $( stringify!($o_name) => $o_name as *const c_void, $( stringify!($o_alias) => $o_alias as *const c_void, )* )*
                $( stringify!($n_name) => $n_name as *const c_void, $( stringify!($n_alias) => $n_alias as *const c_void, )* )*
                $( $( stringify!($q_name) => $q_name as *const c_void,
                    $( stringify!($q_alias) => $q_alias as *const c_void, )* )* )*
                _ => return None,
            })
        }
    };
}

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        $( pub(super) mod $chapter {
            #[allow(unused_imports, reason = "not every chapter has every kind of argument")]
            use super::*;
            #[allow(unused_imports, reason = "size expressions name enumerants")]
            use crate::enums::*;
            #[allow(unused_imports, reason = "only the forms of a vertex are made here from their canonical commands")]
            use crate::context::convert::*;
            crate::context::table::$chapter::$table!(c_abi);
        } )*

        /// The address of an exported function.
        pub(super) fn find(name: &str) -> Option<*const c_void> {
            None $( .or_else(|| $chapter::find(name)) )*
        }
    };
}

crate::context::table::chapters::for_each_chapter!(chapters);
