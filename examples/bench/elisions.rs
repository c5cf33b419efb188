//! What each elision saves: instructions a pixel of the scene in which the work is left out and of the near miss in which
//! it is done, for every row of the table that the tests check (`tests/elision/table.rs`).

#[expect(dead_code, reason = "the tests use all of it")]
#[path = "../../tests/elision/random.rs"]
mod random;
#[expect(dead_code, reason = "only the tests look at the counters")]
#[path = "../../tests/elision/table.rs"]
mod table;

use super::Options;
use super::instructions::under_callgrind;
use fixedgl::Config;
use fixedgl::Context;
use std::process::ExitCode;
use table::{Draw, ROWS};

/// Width and height of the picture.
const SIZE: u32 = 128;
/// Drawings of the longer frame.
const REPEAT: u32 = 3;

/// What callgrind counts: it finds this function by its name, and the other one, after which it writes a profile.
#[inline(never)]
fn counted_frame(gl: &mut Context, draw: Draw, count: u32) {
    profiled_frame(gl, draw, count);
    std::hint::black_box(());
}

#[inline(never)]
fn profiled_frame(gl: &mut Context, draw: Draw, count: u32) {
    for _ in 0..count {
        draw(gl);
    }
    gl.finish();
}

/// The frames of all rows: what runs under callgrind.
pub fn draw_counted(options: &Options) {
    let config = Config::default().with_level(options.level).with_threads(1);
    for row in ROWS {
        for draw in [row.near_miss, row.left_out] {
            let mut gl = Context::with_config(SIZE, SIZE, config);
            (row.state)(&mut gl);
            draw(&mut gl);
            gl.finish();
            counted_frame(&mut gl, draw, 1);
            counted_frame(&mut gl, draw, REPEAT);
        }
    }
}

/// Prints the table.
pub fn run() -> ExitCode {
    let costs = match under_callgrind(&["--counted-elisions".into()]) {
        Ok((_, costs)) if costs.len() == 4 * ROWS.len() => costs,
        Ok((_, costs)) => {
            eprintln!("{} profiles where {} were expected", costs.len(), 4 * ROWS.len());
            return ExitCode::FAILURE;
        }
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    println!("| left out | instructions a pixel, done | left out | saved |\n|---|---|---|---|");
    let pixels = f64::from(SIZE * SIZE) * f64::from(REPEAT - 1);
    for (row, costs) in ROWS.iter().zip(costs.chunks_exact(4)) {
        let of = |short: u64, long: u64| long.saturating_sub(short) as f64 / pixels;
        let (done, left_out) = (of(costs[0], costs[1]), of(costs[2], costs[3]));
        let saved = 100.0 * (1.0 - left_out / done.max(1e-9));
        println!("| {} | {done:.1} | {left_out:.1} | {saved:.0} % |", row.name);
    }
    ExitCode::SUCCESS
}
