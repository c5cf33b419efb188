//! The benchmark: what a fragment, a triangle and an upload cost, scene by scene, in time and in instructions, and how cost
//! grows with what is drawn.
//!
//! ```text
//! cargo run --release --example bench [-- --quick] [--scenes S5,S7] [--threads 2] [--level avx2] [--size 1024]
//!                                     [--seconds 1] [--frames 100]
//! ```
//!
//! Without more it measures times: see `bench/timing.rs`. `--frames n` draws n short frames of each scene and measures
//! nothing: for profilers. `--instructions` counts instructions a fragment or triangle with callgrind, where valgrind is
//! installed; `--bless FILE` keeps the numbers and `--check FILE` compares with those that are kept
//! (`bench/instructions.rs`). `--growth` prints how cost grows with fragments, triangles, texels, units and draws
//! (`bench/growth.rs`). `--elisions` prints what leaving out saves (`bench/elisions.rs`).

#[path = "bench/elisions.rs"]
mod elisions;
#[path = "bench/growth.rs"]
mod growth;
#[path = "bench/instructions.rs"]
mod instructions;
#[path = "bench/scenes.rs"]
mod scenes;
#[path = "bench/setups.rs"]
mod setups;
#[path = "bench/stage.rs"]
mod stage;
#[path = "bench/timing.rs"]
mod timing;

use fixedgl::Config;
use fixedgl::SimdLevel;
use scenes::{SCENES, Scene};
use std::path::PathBuf;
use std::process::{ExitCode, exit};

const USAGE: &str = "usage: bench [--quick] [--scenes S5,S7] [--threads n] [--level baseline|avx2|avx512] [--size n] \
                     [--seconds n] [--list | --frames n | --growth | --elisions | --instructions | --bless FILE | --check FILE]";

/// What is to be done.
#[derive(Clone)]
enum Task {
    /// Times.
    Times,
    /// So many frames and nothing else.
    Frames(u32),
    /// How cost grows.
    Growth,
    /// How much memory a frame of so many triangles takes: what `--growth` runs in processes of their own.
    Peak(usize),
    /// What each elision saves.
    Elisions,
    /// The frames that are counted for that.
    CountedElisions,
    /// Instructions: print them.
    Instructions,
    /// Keep them in a file.
    Bless(PathBuf),
    /// Compare them with a file.
    Check(PathBuf),
    /// The frames whose instructions are counted: what `--instructions` runs under callgrind.
    Counted,
}

/// What the command line asks for.
struct Options {
    task: Task,
    scenes: Vec<&'static Scene>,
    threads: usize,
    level: SimdLevel,
    size: u32,
    seconds: f64,
}

fn wrong(message: &str) -> ! {
    eprintln!("{message}\n{USAGE}");
    exit(2)
}

fn options() -> Options {
    let config = Config::from_env();
    let (mut quick, mut size) = (false, None);
    let mut names: Option<Vec<String>> = None;
    let mut options = Options {
        task: Task::Times,
        scenes: Vec::new(),
        threads: config.threads,
        level: config.level,
        size: 1024,
        seconds: 1.0,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().unwrap_or_else(|| wrong(&format!("{argument} needs a value")));
        fn number<T: std::str::FromStr>(text: &str) -> T {
            text.parse().unwrap_or_else(|_| wrong(&format!("{text} is not a number of the kind that is needed")))
        }
        match argument.as_str() {
            "--help" | "-h" => {
                println!("{USAGE}");
                exit(0);
            }
            "--quick" => quick = true,
            "--list" => {
                SCENES.iter().for_each(|scene| println!("{:5} {}", scene.id, scene.what));
                exit(0);
            }
            "--scenes" => names = Some(value().split(',').map(String::from).collect()),
            "--threads" => options.threads = number::<usize>(&value()).clamp(1, 256),
            "--size" => size = Some(number::<u32>(&value()).clamp(16, 4096)),
            "--seconds" => options.seconds = number(&value()),
            "--frames" => options.task = Task::Frames(number(&value())),
            "--growth" => options.task = Task::Growth,
            "--peak" => options.task = Task::Peak(number(&value())),
            "--instructions" => options.task = Task::Instructions,
            "--bless" => options.task = Task::Bless(value().into()),
            "--check" => options.task = Task::Check(value().into()),
            "--elisions" => options.task = Task::Elisions,
            "--counted-elisions" => options.task = Task::CountedElisions,
            "--counted" => options.task = Task::Counted,
            "--level" => {
                let name = value();
                options.level =
                    SimdLevel::from_name(&name).unwrap_or_else(|| wrong(&format!("there is no level {name}")));
            }
            _ => wrong(&format!("{argument} is not known")),
        }
    }
    if quick {
        options.seconds = options.seconds.min(0.4);
    }
    let counts = matches!(options.task, Task::Instructions | Task::Bless(_) | Task::Check(_) | Task::Counted);
    options.size = size.unwrap_or(if counts { instructions::SIZE } else { 1024 });
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

fn main() -> ExitCode {
    let options = options();
    match &options.task {
        Task::Times => timing::run(&options),
        Task::Growth => growth::run(&options),
        Task::Peak(n) => growth::peak(&options, *n),
        Task::Frames(frames) => {
            for scene in &options.scenes {
                let (mut stage, _) = timing::prepare(scene, &options, options.threads);
                (0..*frames).for_each(|_| _ = timing::frame(scene, &mut stage, 1));
            }
        }
        Task::Elisions => return elisions::run(),
        Task::CountedElisions => elisions::draw_counted(&options),
        Task::Counted => instructions::draw_counted(&options),
        Task::Instructions | Task::Bless(_) | Task::Check(_) => return instructions::run(&options),
    }
    ExitCode::SUCCESS
}
