//! Each row of the [table](super::table): its work is left out where it may be, done in the near miss, and both give the
//! bytes of the general plan.

use super::table::{Draw, ROWS, Row, Work};
use fixedgl::Config;
use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::explain::Counters;
use fixedgl::explain::Explanation;

/// Draws a scene; the picture, the counters and the plan.
fn run(row: &Row, draw: Draw, general_plan: bool) -> (Vec<u8>, Counters, Explanation) {
    let config = Config::default().with_threads(1).with_general_plan(general_plan);
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
            let mut gl = Context::with_config(64, 64, Config::default().with_threads(2));
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

/// Levels that are made late are those that would have been made at once.
#[test]
fn levels_that_are_owed_are_those_of_their_time() {
    let image = |gl: &mut Context, level: i32, size: i32, value: u8| {
        let texels = vec![value; (size * size) as usize];
        gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        gl.tex_image_2d(GL_TEXTURE_2D, level, GL_LUMINANCE8, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &texels);
    };
    let set = |gl: &mut Context, name: GLenum, value: i32| gl.tex_parameteri(GL_TEXTURE_2D, name, value);
    let read = |gl: &mut Context, level: i32| {
        let mut texels = [77u8; 64];
        gl.pixel_storei(GL_PACK_ALIGNMENT, 1);
        gl.get_tex_image(GL_TEXTURE_2D, level, GL_LUMINANCE, GL_UNSIGNED_BYTE, &mut texels);
        texels[0]
    };
    type Change<'a> = &'a dyn Fn(&mut Context);
    let changes: [(&str, Change<'_>, [u8; 4]); 6] = [
        ("nothing", &|_| {}, [10; 4]),
        (
            "a base level that makes none",
            &|gl| (set(gl, GL_GENERATE_MIPMAP, 0), image(gl, 0, 8, 20)).1,
            [20, 10, 10, 10],
        ),
        ("a base level that makes them anew", &|gl| image(gl, 0, 8, 20), [20; 4]),
        ("another level", &|gl| image(gl, 1, 4, 30), [10, 30, 10, 10]),
        (
            "a part of another level",
            &|gl| {
                gl.tex_sub_image_2d(GL_TEXTURE_2D, 2, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &[40u8]);
            },
            [10, 10, 40, 10],
        ),
        (
            "the limits of levels",
            &|gl| {
                set(gl, GL_TEXTURE_MAX_LEVEL, 1);
                image(gl, 0, 8, 50);
            },
            [50, 50, 10, 10],
        ),
    ];
    for (name, change, expected) in changes {
        let mut gl = Context::new(8, 8);
        set(&mut gl, GL_GENERATE_MIPMAP, 1);
        image(&mut gl, 0, 8, 10);
        change(&mut gl);
        let found = [0, 1, 2, 3].map(|level| read(&mut gl, level));
        assert_eq!((found, gl.check()), (expected, Ok(())), "{name}");
    }
}
