//! Every exported command that has a common path, called twice: once with nobody listening, when the common path is tried
//! first, and once with a trace, when it goes the long way. What it leaves behind must be the same. The calls are made
//! from the rows.

use super::osmesa::*;
use super::rows::vertex as doors;
use crate::Context;
use crate::context::immediate_fast::if_immediate_fast;
use crate::context::table::vertex::vertex_table;
use crate::enums::*;
use std::ptr::null_mut;

/// What every argument of a call is made of.
#[derive(Clone, Copy)]
struct Sample {
    unit: u32,
    float: f64,
}

macro_rules! argument {
    (enum, $s:ident, $i:ident) => {
        GL_TEXTURE0 + $s.unit
    };
    (unit, $s:ident, $i:ident) => {
        GL_TEXTURE0 + $s.unit
    };
    (bool, $s:ident, $i:ident) => {
        ($s.float > 0.5) as u8
    };
    ([$t:ty; $n:literal], $s:ident, $i:ident) => {
        std::array::from_fn::<$t, $n, _>(|i| ($s.float * (i + 1) as f64) as $t).as_ptr()
    };
    ($t:ident, $s:ident, $i:ident) => {{
        $i += 1.0;
        ($s.float * $i) as $t
    }};
}

type Call = (&'static str, fn(Sample));

macro_rules! calls {
    (
        title $title:literal;
        canonical { $($canonical:tt)* }
        commands { $($commands:tt)* }
        forms { $( family $sentence:literal { $( $(#[$doc:meta])* $class:ident $name:ident $(| $alias:ident)*
            $snake:ident ( $($a:ident : $k:tt),* ) => $op:ident $call:tt ; )* } )* }
        $($rest:tt)*
    ) => {
        {
            let mut calls: Vec<Call> = Vec::new();
            $( $( if_immediate_fast! { $op, {
                calls.push((stringify!($name), |s: Sample| {
                    let mut _i = 0.0;
                    // SAFETY: arrays are as long as their rows say and live as long as the call.
                    unsafe { doors::$name($(argument!($k, s, _i)),*) }
                }));
            }, {} } )* )*
            calls
        }
    };
}

/// What a command can leave behind here: current values, vertices that wait, an error.
fn left(cx: &mut Context) -> String {
    let batch = &cx.engine.pipe.worker.processor.batch;
    let vertices: Vec<_> = (0..batch.n).map(|i| (batch.position.map(|lanes| lanes[i]), batch.current(i))).collect();
    let (current, units) = (&cx.engine.state.current, cx.engine.q_units);
    let left = format!("{current:?} {units} {:?} {vertices:?}", cx.engine.state.lighting.materials);
    format!("{left} {:?}", cx.check().map_err(|error| error.code))
}

#[test]
fn the_common_path_and_the_long_way_leave_the_same_behind() {
    let calls = vertex_table!(calls);
    assert!(calls.len() > 150, "{}", calls.len());
    let mut pixels = vec![0_u32; 64];
    for tracking in [false, true] {
        for (name, call) in &calls {
            for sample in
                [(0, 0.25), (1, 3.0), (7, -1.0), (8, 1.0), (3, f64::NAN)].map(|(unit, float)| Sample { unit, float })
            {
                let [quick, long] = [false, true].map(|traced| {
                    // SAFETY: the memory is large enough and outlives the context.
                    unsafe {
                        let handle = OSMesaCreateContext(GL_RGBA, null_mut());
                        assert_eq!(OSMesaMakeCurrent(handle, pixels.as_mut_ptr().cast(), GL_UNSIGNED_BYTE, 8, 8), 1);
                        let cx = &mut (*handle).context;
                        cx.enable(GL_LIGHTING);
                        if tracking {
                            cx.enable(GL_COLOR_MATERIAL);
                        }
                        cx.set_trace_callback(if traced { Some(Box::new(|_| {})) } else { None });
                        cx.begin(GL_POINTS);
                        call(sample);
                        (*handle).context.vertex2f(0.5, 0.5);
                        call(sample);
                        let left = left(&mut (*handle).context);
                        OSMesaDestroyContext(handle);
                        left
                    }
                });
                assert_eq!(quick, long, "{name}");
            }
        }
    }
}
