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
    /// Values and bytes that there are of every memory argument.
    memory: usize,
}

/// As much memory as the samples below ask for.
const ENOUGH: usize = 4096;

macro_rules! argument {
    (enum, $s:ident) => {
        $s.name
    };
    (unit, $s:ident) => {
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
        &vec![$s.float as $t; $s.memory.min($n)]
    };
    ((slice $t:ty : $($count:tt)*), $s:ident) => {
        &vec![$s.float as $t; $s.memory.min(64)]
    };
    ((upto $t:ty : $($count:tt)*), $s:ident) => {
        &vec![$s.float as $t; $s.memory.min(64)]
    };
    ((out $t:ty : $($count:tt)*), $s:ident) => {
        &mut vec![0 as $t; $s.memory.min(64)]
    };
    ((rect $($size:tt)*), $s:ident) => {
        &vec![0_u8; $s.memory.min(4096)]
    };
    ((bytes $size:expr), $s:ident) => {
        &vec![0_u8; $s.memory.min(4096)]
    };
    ((indices $count:ident, $type:ident), $s:ident) => {
        &vec![0_u8; $s.memory.min(256)]
    };
    (array, $s:ident) => {
        &[0_u8; 256]
    };
    (($out:ident $($size:tt)*), $s:ident) => {
        &mut vec![0_u8; $s.memory.min(4096)]
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
    for ((name, call), memory) in CALLS.iter().copied().flatten().flat_map(|call| [(call, ENOUGH), (call, 0)]) {
        let mut cx = Context::new(4, 4);
        cx.begin(GL_POINTS);
        assert_eq!(cx.check(), Ok(()));
        let before = cx.engine.state.clone();
        call(&mut cx, Sample { name: GL_LIGHTING, int: 1, float: 1.0, memory });
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

/// Names of every chapter, and some that are none; those of targets and faces first.
const NAMES: [u32; 12] = [
    0,
    GL_TEXTURE_2D,
    GL_FRONT_AND_BACK,
    GL_TEXTURE_ENV,
    GL_S,
    GL_LIGHT0,
    GL_TEXTURE0,
    GL_CLIP_PLANE0,
    GL_PIXEL_MAP_R_TO_R,
    GL_AMBIENT,
    GL_ARRAY_BUFFER,
    u32::MAX,
];

#[test]
fn too_little_memory_is_the_last_error_that_a_command_has() {
    let error = |call: fn(&mut Context, Sample), sample: Sample, list: bool| {
        let mut cx = Context::new(4, 4);
        if list {
            cx.new_list(1, GL_COMPILE);
        }
        call(&mut cx, sample);
        let compiled = cx.check();
        if list {
            cx.end_list();
            cx.call_list(1);
        }
        compiled.and(cx.check())
    };
    let mut seen = 0;
    for (command, call) in CALLS.iter().copied().flatten() {
        for (name, int) in NAMES.into_iter().flat_map(|name| [(name, 1), (name, -1)]) {
            for list in [false, true] {
                let sample = Sample { name, int, float: 1.0, memory: ENOUGH };
                let Err(enough) = error(*call, sample, list) else { continue };
                let Err(none) = error(*call, Sample { memory: 0, ..sample }, list) else {
                    panic!("{command} with {name:#x}, {int} and no memory: no error, but {enough} with memory");
                };
                assert_eq!(none.code, enough.code, "{command} with {name:#x}, {int}: {none}, but {enough}");
                seen += usize::from(enough.code == GL_INVALID_ENUM);
            }
        }
    }
    assert!(seen > 1000, "{seen}");
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
                call(&mut cx, Sample { name, int, float, memory: ENOUGH });
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
            call(&mut cx, Sample { name: GL_RGBA, int, float, memory: ENOUGH });
            cx.end_list();
            let _ = cx.check();
            cx.call_list(i as u32 + 1);
        }
        assert!(!cx.flags.recording() || *name == "glNewList", "{name}");
    }
}
