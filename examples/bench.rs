//! The benchmark: what a fragment, a triangle and an upload cost, scene by scene, with one thread and with all of them.
//!
//! ```text
//! cargo run --release --example bench [-- --quick] [--scenes S5,S7] [--threads 2] [--level avx2] [--size 1024]
//!                                     [--seconds 1] [--frames 100]
//! ```
//!
//! A frame is a scene drawn once or several times, and Finish. The cost is that of one drawing more: the difference of a
//! long and a short frame, so that what a frame costs by itself does not count. Frames of either length and with either
//! number of threads take turns, and the shortest of each counts: a machine that others use can only make them longer.
//! With one thread the time is the processor's, with several the clock's.
//! `--frames n` draws n short frames of each scene and measures nothing: for profilers.

#[path = "bench/scenes.rs"]
mod scenes;
#[path = "bench/stage.rs"]
mod stage;

use fixedgl::batch::Level;
use fixedgl::context::Config;
use indicatif::{ProgressBar, ProgressStyle};
use scenes::{SCENES, Scene, Unit};
use stage::Stage;
use std::process::exit;
use std::time::{Duration, Instant};

const USAGE: &str = "usage: bench [--quick] [--scenes S5,S7] [--threads n] [--level baseline|avx2|avx512] [--size n] \
                     [--seconds n] [--frames n] [--list]";

/// What the command line asks for.
struct Options {
    scenes: Vec<&'static Scene>,
    threads: usize,
    level: Level,
    size: u32,
    seconds: f64,
    frames: Option<u32>,
}

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

fn wrong(message: &str) -> ! {
    eprintln!("{message}\n{USAGE}");
    exit(2)
}

fn options() -> Options {
    let config = Config::from_env();
    let mut quick = false;
    let mut names: Option<Vec<String>> = None;
    let mut options = Options {
        scenes: Vec::new(),
        threads: config.threads,
        level: config.level,
        size: 1024,
        seconds: 1.0,
        frames: None,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().unwrap_or_else(|| wrong(&format!("{argument} needs a value")));
        fn number<T: std::str::FromStr>(text: &str) -> T {
            text.parse().unwrap_or_else(|_| wrong(&format!("{text} is not a number of the kind that is needed")))
        }
        match argument.as_str() {
            "--quick" => quick = true,
            "--list" => {
                SCENES.iter().for_each(|scene| println!("{:5} {}", scene.id, scene.what));
                exit(0);
            }
            "--scenes" => names = Some(value().split(',').map(String::from).collect()),
            "--threads" => options.threads = number::<usize>(&value()).clamp(1, 256),
            "--size" => options.size = number::<u32>(&value()).clamp(16, 4096),
            "--seconds" => options.seconds = number(&value()),
            "--frames" => options.frames = Some(number(&value())),
            "--level" => {
                let name = value();
                options.level = Level::from_name(&name).unwrap_or_else(|| wrong(&format!("there is no level {name}")));
            }
            _ => wrong(&format!("{argument} is not known")),
        }
    }
    options.level = options.level.at_most_available();
    if quick {
        options.seconds = options.seconds.min(0.4);
    }
    if let Some(unknown) = names.iter().flatten().find(|name| SCENES.iter().all(|scene| scene.id != **name)) {
        wrong(&format!("there is no scene {unknown}; --list shows them"));
    }
    let wanted = |scene: &&Scene| match &names {
        Some(names) => names.iter().any(|name| name == scene.id),
        None => scene.quick || !quick,
    };
    options.scenes = SCENES.iter().filter(wanted).collect();
    options
}

/// What the processor has spent on this thread, in seconds, where the system says it. It brings the number up to date
/// whenever the thread yields.
fn processor_time() -> Option<f64> {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split(' ').next()?.parse::<f64>().ok()? * 1e-9)
}

/// Draws a frame and says how long it took: with one thread the time of the processor, which others that use the machine
/// lengthen less, else the time on the clock.
fn frame(scene: &Scene, stage: &mut Stage, count: u32) -> f64 {
    let alone = stage.gl.config().threads == 1;
    let before = if alone { processor_time() } else { None };
    let start = Instant::now();
    for _ in 0..count {
        (scene.draw)(stage);
    }
    stage.gl.finish();
    let clock = start.elapsed().as_secs_f64();
    match (before, before.and_then(|_| processor_time())) {
        (Some(before), Some(after)) if after > before => after - before,
        _ => clock,
    }
}

/// A scene set up, its first frame drawn.
fn prepare(scene: &Scene, options: &Options, threads: usize) -> (Stage, f64) {
    let config = Config { threads, level: options.level, ..Config::default() };
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
    let fragments = match scene.unit {
        Unit::Fragment(layers) if scene.id == "S1" => layers * f64::from(options.size) * f64::from(options.size),
        Unit::Fragment(layers) => layers * stages[0].0.covered(scene.draw) as f64,
        Unit::Triangle => stages[0].0.covered(scene.draw) as f64,
        Unit::Million(_) => 0.0,
    };
    Line { scene, fragments, triangles, times }
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

fn main() {
    let options = options();
    if let Some(frames) = options.frames {
        for scene in &options.scenes {
            let (mut stage, _) = prepare(scene, &options, options.threads);
            (0..frames).for_each(|_| _ = frame(scene, &mut stage, 1));
        }
        return;
    }
    let bar = ProgressBar::new(options.scenes.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    let mut lines = Vec::new();
    for scene in &options.scenes {
        bar.set_message(scene.what);
        lines.push(measure(scene, &options));
        bar.inc(1);
    }
    bar.finish_and_clear();
    print(&lines, &options);
}
