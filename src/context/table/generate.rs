//! What a chapter of the table becomes on the Rust side (OpenGL 1.5, chapter 2.5 and 5.4): the way of every op to the
//! engine, the public methods of `Context`, and the rows as data.
//! `methods.rs` hands the rows of each chapter to [`chapter!`].

/// Whether a command of a class may stand between Begin and End: only then it needs no check.
macro_rules! allowed_inside {
    (begin) => {
        true
    };
    ($class:ident) => {
        false
    };
}

/// Whether a recorded command is carried out at once although a list is open: images of proxy targets and switches of
/// client state are.
macro_rules! immediate {
    (proxy, $target:ident $(, $rest:ident)*) => {
        $crate::context::param_counts::is_proxy($target)
    };
    (client, $capability:ident) => {
        $crate::context::arrays::is_array($capability)
    };
    ($class:ident $(, $a:ident)*) => {
        false
    };
}

/// The way of every op of a chapter to the engine, from a list and from a method.
macro_rules! dispatch {
    () => {};
    ($( $class:ident $name:ident $snake:ident ( $($a:ident : $k:tt),* ) ; )*) => {
        impl Op {
            /// Carries the command out as a display list does: with the checks of its class.
            #[track_caller]
            pub(crate) fn run(&self, cx: &mut $crate::context::Context) {
                match *self {
                    $( Op::$name { $(ref $a),* } => {
                        if !$crate::context::table::generate::allowed_inside!($class) && cx.engine.inside_begin_end() {
                            return cx.refuse_inside(stringify!($name));
                        }
                        let result = cx.engine.$snake($($crate::context::table::arg_kinds::lent!($k, $a)),*);
                        cx.record_result(stringify!($name), result)
                    } )*
                }
            }
        }

        #[allow(clippy::too_many_arguments, reason = "the commands are GL's")]
        impl $crate::context::table::Dispatch {
            $(
                #[inline]
                #[track_caller]
                pub(crate) fn $snake(
                    cx: &mut $crate::context::Context,
                    name: &'static str,
                    $($a: $crate::context::table::arg_kinds::engine_ty!($k)),*
                ) {
                    if cx.flags.recording() && !$crate::context::table::generate::immediate!($class $(, $a)*) {
                        let op = Op::$name { $($a: $crate::context::table::arg_kinds::owned!($k, cx, name, $a)),* };
                        if !cx.record(name, op) {
                            return;
                        }
                    }
                    if !$crate::context::table::generate::allowed_inside!($class) && cx.engine.inside_begin_end() {
                        return cx.refuse_inside(name);
                    }
                    let result = cx.engine.$snake($($a),*);
                    cx.record_result(name, result);
                    if const { $crate::context::errors::tells(!$crate::context::table::generate::allowed_inside!($class), stringify!($snake)) } {
                        cx.deliver(name);
                    }
                }
            )*
        }
    };
}

/// A question to the engine. The open display list is the context's own affair.
macro_rules! ask {
    ($cx:ident, get($pname:expr)) => { $crate::context::context_commands::get($cx, $pname) };
    ($cx:ident, $query:ident($($e:expr),*)) => { $cx.engine.$query($($e),*) };
}

/// The start of every door: plain values, and a line of trace if somebody listens.
macro_rules! enter {
    ($cx:ident, $name:expr, $( $a:ident : $k:tt ),*) => {
        $( #[allow(unused_mut, reason = "only memory that is written needs it")]
           let mut $a = $crate::context::table::arg_kinds::plain!($k, $a); )*
        $( let _ = &mut $a; )*
        if $cx.flags.tracing() {
            $cx.trace($name, &[ $( (stringify!($a), $crate::context::table::arg_kinds::shown!($k, $a)) ),* ]);
        }
    };
}

/// A command that is not allowed between Begin and End is refused there before its memory is looked at. While a list is
/// open that has to wait until the command has been recorded.
macro_rules! refuse_inside {
    (begin, $cx:ident, $name:ident) => {};
    ($class:ident, $cx:ident, $name:ident) => {
        if !$cx.flags.recording() && $cx.engine.inside_begin_end() {
            return $cx.refuse_inside($name);
        }
    };
}

/// A chapter of the table: see `table/mod.rs` for the shape of the rows.
macro_rules! chapter {
    (
        title $title:literal;
        canonical { $( $class:ident $name:ident $snake:ident ( $($a:ident : $k:tt),* ) ; )* }
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
        answers { $( $answer:ident ( $($aa:ident : $ak:tt),* ) ; )* }
        manual { $( $h_class:ident $h_name:ident $(| $h_alias:ident)* ; )* }
    ) => {
        $crate::context::table::generate::dispatch! {
            $( $class $name $snake ( $($a : $k),* ) ; )*
            $( $c_class $c_name $c_snake ( $($ca : $ck),* ) ; )*
        }
        /// The rows of this chapter.
        #[cfg(test)]
        pub(crate) const ROWS: &[$crate::context::table::rows::Row] = &[
            $( $crate::context::table::rows::row!($c_class $c_name $(| $c_alias)*), )*
            $( $( $crate::context::table::rows::row!($f_class $f_name $(| $f_alias)*), )* )*
            $( $crate::context::table::rows::row!($o_class $o_name $(| $o_alias)*), )*
            $( $crate::context::table::rows::row!($n_class $n_name $(| $n_alias)*), )*
            $( $( $crate::context::table::rows::row!(now $q_name $(| $q_alias)*), )* )*
            $( $crate::context::table::rows::row!($h_class $h_name $(| $h_alias)*), )*
        ];

        #[doc = concat!("# ", $title)]
        #[allow(clippy::too_many_arguments, reason = "the commands are GL's")]
        #[allow(clippy::extra_unused_lifetimes, reason = "only memory arguments have the lifetime")]
        impl $crate::context::Context {
            $(
                $(#[$doc])*
                #[doc = concat!("\n\nIn C: `", stringify!($c_name), "`.")]
                #[inline]
                #[track_caller]
                pub fn $c_snake<'a>(&mut self, $($ca: $crate::context::table::arg_kinds::door_ty!($ck)),*) {
                    let (cx, name) = (self, stringify!($c_name));
                    $crate::context::table::generate::enter!(cx, name, $($ca : $ck),*);
                    $crate::context::table::generate::refuse_inside!($c_class, cx, name);
                    $( let $ca = $crate::context::table::arg_kinds::checked!($ck, cx, name, $ca); )*
                    $crate::context::table::Dispatch::$c_snake(cx, name, $($ca),*)
                }
            )*
            $( $(
                #[doc = $sentence]
                #[doc = concat!("\n\nIn C: `", stringify!($f_name), "`.")]
                $(#[$f_doc])*
                #[inline]
                #[track_caller]
                pub fn $f_snake<'a>(&mut self, $($fa: $crate::context::table::arg_kinds::door_ty!($fk)),*) {
                    let (cx, name) = (self, stringify!($f_name));
                    $crate::context::table::generate::enter!(cx, name, $($fa : $fk),*);
                    $crate::context::table::generate::refuse_inside!($f_class, cx, name);
                    $( let $fa = $crate::context::table::arg_kinds::checked!($fk, cx, name, $fa); )*
                    $crate::context::table::Dispatch::$op(cx, name, $($fe),*)
                }
            )* )*
            $(
                $(#[$o_doc])*
                #[doc = concat!("\n\nIn C: `", stringify!($o_name), "`.")]
                #[track_caller]
                pub fn $o_snake<'a>(
                    &mut self, $($oa: $crate::context::table::arg_kinds::door_ty!($ok)),*
                ) $(-> $crate::context::table::arg_kinds::return_ty!($or))? {
                    let (cx, name) = (self, stringify!($o_name));
                    $crate::context::table::generate::enter!(cx, name, $($oa : $ok),*);
                    $crate::context::table::generate::refuse_inside!($o_class, cx, name);
                    $( let $oa = $crate::context::table::arg_kinds::checked!($ok, cx, name, $oa); )*
                    $crate::context::context_commands::$o_snake(cx, name, $($oa),*)
                }
            )*
            $(
                $(#[$n_doc])*
                #[doc = concat!("\n\nIn C: `", stringify!($n_name), "`.")]
                #[track_caller]
                pub fn $n_snake<'a>(
                    &mut self, $($na: $crate::context::table::arg_kinds::door_ty!($nk)),*
                ) $(-> $crate::context::table::arg_kinds::return_ty!($nr))? {
                    let (cx, name) = (self, stringify!($n_name));
                    $crate::context::table::generate::enter!(cx, name, $($na : $nk),*);
                    if cx.engine.inside_begin_end() {
                        return cx.refuse_inside(name);
                    }
                    $( let $na = $crate::context::table::arg_kinds::checked!($nk, cx, name, $na); )*
                    let result = cx.engine.$n_snake($($na),*);
                    cx.deliver(name);
                    cx.record_result(name, result)
                }
            )*
            $( $(
                #[doc = $q_sentence]
                #[doc = concat!("\n\nIn C: `", stringify!($q_name), "`.")]
                $(#[$q_doc])*
                #[track_caller]
                pub fn $q_snake(
                    &mut self,
                    $($qa: $crate::context::table::arg_kinds::door_ty!($qk),)*
                    params: &mut (impl $crate::context::OutSlice<$q_type> + ?Sized),
                ) {
                    if let Some(values) = $crate::context::table::Query::$q_snake(self, $($qa),*) {
                        self.answer(stringify!($q_name), &values, params.slice_mut())
                    }
                }
            )* )*
        }

        impl $crate::context::table::Query {
            $( $(
                #[track_caller]
                pub(crate) fn $q_snake(
                    cx: &mut $crate::context::Context,
                    $($qa: $crate::context::table::arg_kinds::door_ty!($qk)),*
                ) -> Option<$crate::context::Values> {
                    let name = stringify!($q_name);
                    $crate::context::table::generate::enter!(cx, name, $($qa : $qk),*);
                    if cx.engine.inside_begin_end() {
                        return cx.refuse_inside(name);
                    }
                    match $crate::context::table::generate::ask!(cx, $query($($qe),*)) {
                        Ok(values) => Some(values),
                        Err(error) => cx.fail(name, error),
                    }
                }
            )* )*
        }
    };
}

pub(crate) use {allowed_inside, ask, chapter, dispatch, enter, immediate, refuse_inside};
