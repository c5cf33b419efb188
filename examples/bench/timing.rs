//! Measuring times: a frame with a scene drawn once and one with it drawn several times take turns, with one thread and
//! with all, and the shortest of each counts: a machine that others use can only make them longer. The cost is that of
//! one drawing more, so what a frame costs by itself does not count. With one thread the time is the processor's, with
//! several the clock's.

use super::Options;
use super::scenes::{Scene, Unit};
use super::stage::Stage;
use fixedgl::Config;
use indicatif::{ProgressBar, ProgressStyle};
use std::process::exit;
use std::time::{Duration, Instant};

/// The least times of a frame, in seconds.
#[derive(Clone, Copy)]
struct Times {
    first: f64,
    short: f64,
    long: f64,
}

/// A line of the table.
struct Line {
    scene: &'static Scene,
    fragments: f64,
    triangles: usize,
    /// With one thread, and with all.
    times: [Times; 2],
}

/// What the processor has spent on this thread, in seconds, where the system says it. It brings the number up to date
/// whenever the thread yields.
fn processor_time() -> Option<f64> {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split(' ').next()?.parse::<f64>().ok()? * 1e-9)
}

/// Draws a frame and says how long it took.
pub fn frame(scene: &Scene, stage: &mut Stage, count: u32) -> f64 {
    timed(stage, |stage| (0..count).for_each(|_| (scene.draw)(stage)))
}

/// How long something takes, Finish included: with one thread the time of the processor, which others that use the
/// machine lengthen less, else the time on the clock.
pub fn timed(stage: &mut Stage, draw: impl FnOnce(&mut Stage)) -> f64 {
    let alone = stage.gl.config().threads == 1;
    let before = if alone { processor_time() } else { None };
    let start = Instant::now();
    draw(stage);
    stage.gl.finish();
    let clock = start.elapsed().as_secs_f64();
    match (before, before.and_then(|_| processor_time())) {
        (Some(before), Some(after)) if after > before => after - before,
        _ => clock,
    }
}

/// A scene set up, its first frame drawn.
pub fn prepare(scene: &Scene, options: &Options, threads: usize) -> (Stage, f64) {
    let config = Config::default().with_threads(threads).with_level(options.level);
    let mut stage = Stage::new(options.size, config);
    (scene.set_up)(&mut stage);
    let first = frame(scene, &mut stage, 1);
    if let Err(error) = stage.gl.check() {
        eprintln!("{}: {error}", scene.id);
        exit(1);
    }
    (stage, first)
}

fn measure(scene: &'static Scene, options: &Options) -> Line {
    let mut stages = [1, options.threads].map(|threads| prepare(scene, options, threads));
    let mut times = stages.each_ref().map(|(_, first)| Times { first: *first, short: f64::MAX, long: f64::MAX });
    let end = Instant::now() + Duration::from_secs_f64(options.seconds.clamp(0.0, 3600.0));
    let mut rounds = 0;
    while rounds < 3 || Instant::now() < end {
        for ((stage, _), times) in stages.iter_mut().zip(&mut times) {
            times.short = times.short.min(frame(scene, stage, 1));
            times.long = times.long.min(frame(scene, stage, scene.repeat));
        }
        rounds += 1;
    }
    let triangles = stages[0].0.triangles;
    Line { scene, fragments: fragments(scene, &mut stages[0].0), triangles, times }
}

/// How many fragments one drawing has. The scene is of no use afterwards.
pub fn fragments(scene: &Scene, stage: &mut Stage) -> f64 {
    match scene.unit {
        Unit::Fragment(layers) if scene.id == "S1" => layers * f64::from(stage.size) * f64::from(stage.size),
        Unit::Fragment(layers) => layers * stage.covered(scene.draw) as f64,
        Unit::Triangle => stage.covered(scene.draw) as f64,
        Unit::Million(_) => 0.0,
    }
}

/// Nanoseconds a unit; milliseconds a million.
fn cost(line: &Line, times: Times) -> f64 {
    let scene = line.scene;
    let once = match scene.repeat {
        0 | 1 => times.short,
        n => (times.long - times.short).max(0.0) / f64::from(n - 1),
    };
    match scene.unit {
        Unit::Fragment(_) => once * 1e9 / line.fragments.max(1.0),
        Unit::Triangle => once * 1e9 / line.triangles.max(1) as f64,
        Unit::Million(n) => once * 1e3 / n,
    }
}

fn print(lines: &[Line], options: &Options) {
    println!(
        "{0} x {0}, {1:?}, ns a unit, the least of all repetitions; {2} threads on the right",
        options.size, options.level, options.threads
    );
    println!("scene  fragments triangles  unit      target  1 thread  threads   gain  first/later  what");
    for line in lines {
        let unit = match line.scene.unit {
            Unit::Fragment(_) => "fragment",
            Unit::Triangle => "triangle",
            Unit::Million(_) => "ms",
        };
        let [one, all] = line.times.map(|times| cost(line, times));
        println!(
            "{:5} {:>10} {:>9}  {unit:8} {:7.2} {one:9.2} {all:8.2} {:6.2} {:12.2}  {}",
            line.scene.id,
            line.fragments,
            line.triangles,
            line.scene.target,
            one / all.max(1e-9),
            line.times[0].first / line.times[0].short.max(1e-9),
            line.scene.what
        );
    }
}

/// Measures the scenes and prints the table.
pub fn run(options: &Options) {
    let bar = ProgressBar::new(options.scenes.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    let mut lines = Vec::new();
    for scene in &options.scenes {
        bar.set_message(scene.what);
        lines.push(measure(scene, options));
        bar.inc(1);
    }
    bar.finish_and_clear();
    print(&lines, options);
}
