//! Every row of the table, called: the Begin/End rule of its class, and arguments that no program should pass. The calls
//! are made from the rows, so that a new row is tested as soon as it is there.

use super::chapters::for_each_chapter;
use super::rows::Class;
use crate::Context;
use crate::enums::*;

/// What every argument of a call is made of.
#[derive(Clone, Copy, Debug)]
struct Sample {
    name: u32,
    int: i32,
    float: f64,
}

macro_rules! argument {
    (enum, $s:ident) => {
        $s.name
    };
    (bits, $s:ident) => {
        $s.name
    };
    (uint, $s:ident) => {
        $s.name
    };
    (bool, $s:ident) => {
        $s.int != 0
    };
    (int, $s:ident) => {
        $s.int
    };
    (i32, $s:ident) => {
        $s.int
    };
    (size, $s:ident) => {
        $s.int as isize
    };
    (float, $s:ident) => {
        $s.float as f32
    };
    ([$t:ty; $n:literal], $s:ident) => {
        &[$s.float as $t; $n]
    };
    ((slice $t:ty : $($count:tt)*), $s:ident) => {
        &vec![$s.float as $t; 64]
    };
    ((out $t:ty : $($count:tt)*), $s:ident) => {
        &mut vec![0 as $t; 64]
    };
    ((rect $($size:tt)*), $s:ident) => {
        &[0_u8; 4096]
    };
    ((bytes $size:expr), $s:ident) => {
        &[0_u8; 4096]
    };
    ((indices $count:ident, $type:ident), $s:ident) => {
        &[0_u8; 256]
    };
    (array, $s:ident) => {
        &[0_u8; 256]
    };
    (($out:ident $($size:tt)*), $s:ident) => {
        &mut [0_u8; 4096]
    };
    ($t:ident, $s:ident) => {
        $s.float as $t
    };
}

type Call = (&'static str, fn(&mut Context, Sample));

macro_rules! calls {
    (
        title $title:literal;
        canonical { $($canonical:tt)* }
        commands { $( $(#[$doc:meta])* $c_class:ident $c_name:ident $(| $c_alias:ident)*
            $c_snake:ident ( $($ca:ident : $ck:tt),* ) ; )* }
        forms { $( family $sentence:literal { $( $(#[$f_doc:meta])* $f_class:ident $f_name:ident $(| $f_alias:ident)*
            $f_snake:ident ( $($fa:ident : $fk:tt),* ) => $op:ident $f_call:tt ; )* } )* }
        context { $( $(#[$o_doc:meta])* $o_class:ident $o_name:ident $(| $o_alias:ident)*
            $o_snake:ident ( $($oa:ident : $ok:tt),* ) $(-> $or:tt)? ; )* }
        now { $( $(#[$n_doc:meta])* $n_class:ident $n_name:ident $(| $n_alias:ident)*
            $n_snake:ident ( $($na:ident : $nk:tt),* ) $(-> $nr:tt)? ; )* }
        queries { $( family $q_sentence:literal { $( $(#[$q_doc:meta])* $q_name:ident $(| $q_alias:ident)*
            $q_snake:ident ( $($qa:ident : $qk:tt),* ) -> $q_type:ident => $query:ident $q_call:tt ; )* } )* }
        answers { $($answers:tt)* }
        manual { $($manual:tt)* }
    ) => {
        &[
            $( (stringify!($c_name), |cx, _s| cx.$c_snake($(argument!($ck, _s)),*)), )*
            $( $( (stringify!($f_name), |cx, _s| cx.$f_snake($(argument!($fk, _s)),*)), )* )*
            $( (stringify!($o_name), |cx, _s| { let _ = cx.$o_snake($(argument!($ok, _s)),*); }), )*
            $( (stringify!($n_name), |cx, _s| { let _ = cx.$n_snake($(argument!($nk, _s)),*); }), )*
            $( $( (stringify!($q_name), |cx, _s| {
                cx.$q_snake($(argument!($qk, _s),)* &mut vec![0 as $q_type; 1024]);
            }), )* )*
        ]
    };
}

macro_rules! chapters {
    ($($chapter:ident: $table:ident;)*) => {
        const CALLS: &[&[Call]] = &[$( $crate::context::table::$chapter::$table!(calls) ),*];
    };
}
for_each_chapter!(chapters);

fn class(name: &str) -> Class {
    super::rows::rows().find(|row| row.name == name).map(|row| row.class).expect("every call has a row")
}

/// Rows that are written by hand and therefore are not among the calls.
const MANUAL: [&str; 5] = ["glRenderMode", "glFeedbackBuffer", "glSelectBuffer", "glMultiDrawElements", "glMapBuffer"];

#[test]
fn every_row_is_called_here() {
    let calls: Vec<&str> = CALLS.iter().copied().flatten().map(|call| call.0).collect();
    for row in super::rows::rows() {
        assert!(calls.contains(&row.name) || MANUAL.contains(&row.name), "{}", row.name);
    }
}

#[test]
fn only_commands_of_the_class_begin_stand_between_begin_and_end() {
    for (name, call) in CALLS.iter().copied().flatten() {
        let mut cx = Context::new(4, 4);
        cx.begin(GL_POINTS);
        assert_eq!(cx.check(), Ok(()));
        let before = cx.engine.state.clone();
        call(&mut cx, Sample { name: GL_LIGHTING, int: 1, float: 1.0 });
        let error = cx.check();
        if class(name) == Class::Begin {
            // These may fail for other reasons, but not for the place where they stand.
            let message = error.map_or_else(|error| error.message, |()| String::new());
            assert!(!message.contains("not allowed between"), "{name}: {message}");
        } else {
            let error = error.expect_err(name);
            assert_eq!((error.code, error.command), (GL_INVALID_OPERATION, *name));
            assert!(error.message.contains("not allowed between glBegin and glEnd"), "{name}: {}", error.message);
            assert_eq!(format!("{before:?}"), format!("{:?}", cx.engine.state), "{name}");
        }
    }
}

#[test]
fn no_argument_makes_a_command_panic() {
    let names = [0, 1, GL_TEXTURE_2D, GL_FRONT_AND_BACK, GL_RGBA, GL_FLOAT, GL_TRIANGLES, u32::MAX];
    let numbers = [
        (0, 0.0),
        (1, 1.0),
        (3, 0.5),
        (-1, -1.0),
        (i32::MAX, f64::INFINITY),
        (i32::MIN, f64::NEG_INFINITY),
        (7, f64::NAN),
        (64, 1e300),
    ];
    for (_, call) in CALLS.iter().copied().flatten() {
        let mut cx = Context::new(8, 8);
        for name in names {
            for (int, float) in numbers {
                call(&mut cx, Sample { name, int, float });
            }
        }
        cx.finish();
    }
}

#[test]
fn no_argument_makes_a_recorded_command_panic() {
    for (name, call) in CALLS.iter().copied().flatten() {
        let mut cx = Context::new(8, 8);
        for (i, (int, float)) in [(1, 1.0), (-1, f64::NAN), (i32::MAX, f64::INFINITY)].into_iter().enumerate() {
            cx.new_list(i as u32 + 1, GL_COMPILE);
            call(&mut cx, Sample { name: GL_RGBA, int, float });
            cx.end_list();
            let _ = cx.check();
            cx.call_list(i as u32 + 1);
        }
        assert!(!cx.flags.recording() || *name == "glNewList", "{name}");
    }
}
