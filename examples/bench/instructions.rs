//! Instructions a fragment, triangle or texel, counted by callgrind: a measure that does not depend on how busy a machine
//! is, and that a file can keep (tests/baseline/instructions.tsv).
//!
//! The benchmark runs itself once under valgrind. There each scene draws two frames in [`counted_frame`], one drawing
//! and several; callgrind counts inside that function only and writes a profile for each call. The difference of
//! the two is the cost of the further drawings. The level is AVX2, the most that valgrind knows, with one thread. Only
//! instructions of the program itself count: the C library picks its copying and clearing by the processor, so its part
//! would depend on the machine. What is copied or cleared by the library is thus not seen here: times are for that.

use super::scenes::{SCENES, Scene, Unit};
use super::stage::Stage;
use super::{Options, Task, timing};
use fixedgl::SimdLevel;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

/// Width and height of the framebuffer: small, since a program under valgrind takes some thirty times as long.
pub const SIZE: u32 = 256;
/// By how much a scene may exceed what is kept.
const TOLERANCE: f64 = 0.02;

/// What a scene costs.
struct Count {
    scene: &'static Scene,
    instructions: f64,
}

/// What callgrind counts: it finds this function by its name. At the end of another one within it writes a profile, as it
/// does one thing only for a function.
#[inline(never)]
fn counted_frame(scene: &Scene, stage: &mut Stage, count: u32) {
    profiled_frame(scene, stage, count);
    std::hint::black_box(());
}

#[inline(never)]
fn profiled_frame(scene: &Scene, stage: &mut Stage, count: u32) {
    for _ in 0..count {
        (scene.draw)(stage);
    }
    stage.gl.finish();
}

/// How many drawings the longer frame has.
fn repeat(scene: &Scene) -> u32 {
    scene.repeat.clamp(2, 3)
}

/// The frames of all scenes, each after one that is not counted; prints the number of units of a drawing.
pub fn draw_counted(options: &Options) {
    for scene in &options.scenes {
        let (mut stage, _) = timing::prepare(scene, options, 1);
        counted_frame(scene, &mut stage, 1);
        counted_frame(scene, &mut stage, repeat(scene));
        let units = match scene.unit {
            Unit::Fragment(_) => timing::fragments(scene, &mut stage),
            Unit::Triangle => stage.triangles as f64,
            Unit::Million(n) => n * 1024.0 * 1024.0,
        };
        println!("{}\t{units}", scene.id);
    }
}

/// Counts, then prints, keeps or compares.
pub fn run(options: &Options) -> ExitCode {
    if !SimdLevel::available().any(|level| level.name() == "avx2") {
        eprintln!("this processor has no AVX2, for which instructions are counted: nothing was compared");
        return ExitCode::SUCCESS;
    }
    let kept = match &options.task {
        Task::Check(file) => match read(file) {
            Ok(kept) => Some(kept),
            Err(error) => return failed(&format!("{}: {error}", file.display())),
        },
        _ => None,
    };
    let wanted = |scene: &&&Scene| kept.as_ref().is_none_or(|kept| kept.contains_key(scene.id));
    let scenes: Vec<_> = options.scenes.iter().filter(wanted).copied().collect();
    let counts = match count(&scenes, options.size) {
        Ok(counts) => counts,
        Err(error) => return failed(&error),
    };
    match (&options.task, kept) {
        (Task::Check(_), Some(kept)) => return check(&counts, &kept),
        (Task::Bless(file), _) => {
            if let Err(error) = fs::write(file, table(&counts, options.size)) {
                return failed(&format!("{}: {error}", file.display()));
            }
        }
        _ => {}
    }
    print!("{}", table(&counts, options.size));
    ExitCode::SUCCESS
}

fn failed(message: &str) -> ExitCode {
    eprintln!("{message}");
    ExitCode::FAILURE
}

/// Runs the benchmark under callgrind with these arguments: what it prints, and the cost of each profile that it leaves.
pub fn under_callgrind(arguments: &[String]) -> Result<(String, Vec<u64>), String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let folder = std::env::temp_dir().join(format!("fixedgl-instructions-{}", std::process::id()));
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--toggle-collect=*counted_frame*", "--dump-after=*profiled_frame*"])
        .arg(format!("--callgrind-out-file={}", folder.join("profile").display()))
        .arg(&program)
        .args(["--level", "avx2", "--threads", "1"])
        .args(arguments)
        .stderr(Stdio::piped())
        .output()
        .map_err(|error| format!("valgrind: {error}; it has to be installed"))?;
    let costs = (1..).map_while(|n| {
        let text = fs::read_to_string(folder.join(format!("profile.{n}"))).ok()?;
        Some(own_cost(&text, &program).unwrap_or(0))
    });
    let costs = costs.collect();
    // What is left behind does no harm.
    _ = fs::remove_dir_all(&folder);
    if output.status.success() {
        Ok((String::from_utf8_lossy(&output.stdout).into_owned(), costs))
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

/// Counts scenes: two profiles a scene, in order.
fn count(scenes: &[&'static Scene], size: u32) -> Result<Vec<Count>, String> {
    let names: Vec<_> = scenes.iter().map(|scene| scene.id).collect();
    let arguments = ["--counted", "--size", &size.to_string(), "--scenes", &names.join(",")].map(String::from);
    let (printed, costs) = under_callgrind(&arguments)?;
    let mut counts = Vec::new();
    for ((scene, line), costs) in scenes.iter().zip(printed.lines()).zip(costs.chunks_exact(2)) {
        let units = line.split_once('\t').filter(|(id, _)| *id == scene.id).and_then(|(_, units)| units.parse().ok());
        let units: f64 = units.ok_or_else(|| format!("{line:?} where {} was to be", scene.id))?;
        let (short, long) = (costs[0] as f64, costs[1] as f64);
        let instructions = (long - short) / f64::from(repeat(scene) - 1) / units.max(1.0);
        counts.push(Count { scene, instructions });
    }
    if counts.len() == scenes.len() { Ok(counts) } else { Err("the counted program ended too early".into()) }
}

/// The instructions that a profile counts in an object: lines of a position and a cost, under the last line `ob=`. The
/// line after `calls=` holds what was called and counts elsewhere. Names are given once, then by their number.
fn own_cost(profile: &str, program: &Path) -> Option<u64> {
    let program = program.to_string_lossy();
    let (mut number, mut inside, mut called, mut sum) = (None, false, false, 0u64);
    for line in profile.lines() {
        if let Some(object) = line.strip_prefix("ob=") {
            let (id, name) = object.split_once(' ').unwrap_or((object, ""));
            if name == program {
                number = Some(id);
            }
            inside = number == Some(id);
        } else if let Some(object) = line.strip_prefix("cob=") {
            if let Some((id, name)) = object.split_once(' ')
                && name == program
            {
                number = Some(id);
            }
        } else if line.starts_with("calls=") {
            called = true;
        } else if line.starts_with(|c: char| c.is_ascii_digit() || "+-*".contains(c)) {
            if inside && !called {
                sum += line.split(' ').nth(1)?.parse::<u64>().ok()?;
            }
            called = false;
        }
    }
    (sum > 0).then_some(sum)
}

/// The numbers as they are kept.
fn table(counts: &[Count], size: u32) -> String {
    let mut text = format!(
        "# Instructions outside of the C library, {size} x {size}, AVX2, one thread. `bench --bless FILE` writes this.\n\
         # scene\tunit\tinstructions\n"
    );
    for Count { scene, instructions } in counts {
        let unit = match scene.unit {
            Unit::Fragment(_) => "fragment",
            Unit::Triangle => "triangle",
            Unit::Million(_) => "texel",
        };
        text += &format!("{}\t{unit}\t{instructions:.3}\n", scene.id);
    }
    text
}

/// The numbers that a file keeps, by scene.
fn read(file: &Path) -> Result<BTreeMap<&'static str, f64>, String> {
    let text = fs::read_to_string(file).map_err(|error| error.to_string())?;
    let mut kept = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()) {
        let mut cells = line.split('\t');
        let scene = cells.next().and_then(|id| SCENES.iter().find(|scene| scene.id == id));
        let number = cells.nth(1).and_then(|number| number.parse().ok());
        let (Some(scene), Some(number)) = (scene, number) else { return Err(format!("what is {line:?}?")) };
        kept.insert(scene.id, number);
    }
    if kept.is_empty() { Err("no scene is kept in it".into()) } else { Ok(kept) }
}

/// Prints all scenes with what was kept, and fails if one needs more.
fn check(counts: &[Count], kept: &BTreeMap<&'static str, f64>) -> ExitCode {
    let mut worse = 0;
    println!("scene      kept       now  difference");
    for Count { scene, instructions } in counts {
        let Some(&before) = kept.get(scene.id) else { continue };
        // The last digit that is kept must not decide.
        let over = *instructions > before * (1.0 + TOLERANCE) + 0.001;
        worse += usize::from(over);
        let difference = 100.0 * (instructions / before - 1.0);
        let remark = if over { "  more than is kept" } else { "" };
        println!("{:5} {before:>9.3} {instructions:>9.3} {difference:>+9.2} %{remark}", scene.id);
    }
    if worse == 0 {
        return ExitCode::SUCCESS;
    }
    failed(&format!(
        "{worse} scenes need over 2 % more instructions; if that has to be, `bench --bless FILE` keeps them"
    ))
}
