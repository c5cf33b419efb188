//! Each row of the [table](super::table): its work is left out where it may be, done in the near miss, and both give the
//! bytes of the general plan.

use crate::table::{Draw, ROWS, Row, Work};
use fixedgl::Context;
use fixedgl::batch::Counters;
use fixedgl::context::Config;
use fixedgl::enums::*;
use fixedgl::teach::Explanation;

/// Draws a scene; the picture, the counters and the plan.
fn run(row: &Row, draw: Draw, general_plan: bool) -> (Vec<u8>, Counters, Explanation) {
    let config = Config { threads: 1, general_plan, ..Config::default() };
    let mut gl = Context::with_config(64, 64, config);
    gl.clear_color(0.2, 0.4, 0.6, 0.8);
    gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    (row.state)(&mut gl);
    gl.set_counting(!general_plan);
    draw(&mut gl);
    let plan = gl.explain();
    let counters = gl.counters();
    gl.set_counting(false);
    assert_eq!(gl.check(), Ok(()), "{}", row.name);
    (gl.pixels(), counters, plan)
}

#[test]
fn each_elision_leaves_its_work_out_and_no_near_miss_is_taken_for_it() {
    for row in ROWS {
        for (draw, is_left_out) in [(row.left_out, true), (row.near_miss, false)] {
            let (pixels, counters, plan) = run(row, draw, false);
            let count = (row.count)(&Work { counters: &counters, plan: &plan });
            assert_eq!(count == 0, is_left_out, "{}: counted {count}\n{plan}{counters}", row.name);
            let (general, _, _) = run(row, draw, true);
            assert!(pixels == general, "{}: other bytes", row.name);
        }
        eprintln!("| {} |", row.name);
    }
}

#[test]
fn counting_changes_no_byte() {
    for row in ROWS {
        let draw = |counting: bool| {
            let mut gl = Context::with_config(64, 64, Config { threads: 2, ..Config::default() });
            (row.state)(&mut gl);
            gl.set_counting(counting);
            (row.near_miss)(&mut gl);
            gl.pixels()
        };
        assert!(draw(true) == draw(false), "{}", row.name);
    }
}

#[test]
fn a_trace_tells_each_new_plan_once() {
    let plans = std::sync::Arc::new(std::sync::Mutex::new(Vec::new()));
    let seen = std::sync::Arc::clone(&plans);
    let mut gl = Context::new(8, 8);
    gl.set_trace_callback(Some(Box::new(move |call| {
        if call.name == "plan" {
            seen.lock().expect("one thread").push(call.args.clone());
        }
    })));
    for func in [GL_LESS, GL_ALWAYS] {
        gl.enable(GL_DEPTH_TEST);
        gl.depth_func(func);
        gl.depth_mask(false);
        for _ in 0..3 {
            gl.rectf(-1.0, -1.0, 1.0, 1.0);
        }
        gl.flush();
    }
    let plans = plans.lock().expect("one thread");
    let kept = plans.iter().map(|plan| plan.split(';').next().unwrap_or_default().contains("depth test"));
    assert_eq!(kept.collect::<Vec<_>>(), [true, false], "{plans:?}");
}
