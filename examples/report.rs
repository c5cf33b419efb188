//! Error against run time: how far each picture is from what the specification says and from what sampling aims at, and
//! what a fragment costs, for every setting of GL's own knobs, from the same contexts in the same run.
//!
//! ```text
//! cargo run --release --example report [-- --quick] [--out FOLDER] [--scenes plane,star] [--peer /path/to/libOSMesa.so.8]
//!                                       [--check tests/baseline/report.tsv] [--bless]
//! ```
//!
//! Prints the tables, writes `report.html` (one file with plots and pictures in it), `report.csv` and `stages.csv`. The
//! exit code tells whether the promises about E_spec in the default setting hold, and whether E_spec has risen by more
//! than 2 % over a baseline (`--check`). `--bless` writes that baseline. `spec-notes/report.md` explains the measures.

#[path = "report/clock.rs"]
mod clock;
#[path = "report/front.rs"]
mod front;
#[path = "report/gl.rs"]
mod gl;
#[path = "report/hints.rs"]
mod hints;
#[path = "report/knobs.rs"]
mod knobs;
#[path = "report/metrics.rs"]
mod metrics;
#[path = "../tests/oracle/mod.rs"]
mod oracle;
#[path = "report/page.rs"]
mod page;
#[path = "report/patterns.rs"]
mod patterns;
#[path = "report/peer.rs"]
mod peer;
#[path = "report/plot.rs"]
mod plot;
#[path = "report/run.rs"]
mod run;
#[path = "report/scenes.rs"]
mod scenes;
#[path = "report/stages.rs"]
mod stages;
#[path = "report/table.rs"]
mod table;
#[path = "report/translate.rs"]
mod translate;
#[path = "report/truth.rs"]
mod truth;
#[path = "report/words.rs"]
mod words;

use fixedgl::Config;
use gl::{Library, Ours};
use indicatif::{ProgressBar, ProgressStyle};
use run::{Effort, Outcome};
use scenes::Subject;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

const USAGE: &str =
    "usage: report [--quick] [--out FOLDER] [--scenes NAME,NAME] [--peer LIBRARY] [--check FILE] [--bless]";

/// The baseline that `--bless` writes if `--check` names no other.
const BASELINE: &str = "tests/baseline/report.tsv";

/// What the command line asks for.
struct Options {
    quick: bool,
    bless: bool,
    out: PathBuf,
    scenes: Option<Vec<String>>,
    peer: Option<String>,
    check: Option<PathBuf>,
    /// Count instructions: this part of so many. The report starts itself so under callgrind.
    count: Option<[usize; 2]>,
}

fn options() -> Result<Options, String> {
    let mut o = Options {
        quick: false,
        bless: false,
        out: PathBuf::from("out/report"),
        scenes: None,
        peer: None,
        check: None,
        count: None,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value\n{USAGE}"));
        match argument.as_str() {
            "--help" | "-h" => {
                println!("{USAGE}");
                std::process::exit(0);
            }
            "--quick" => o.quick = true,
            "--bless" => o.bless = true,
            "--out" => o.out = PathBuf::from(value()?),
            "--scenes" => o.scenes = Some(value()?.split(',').map(String::from).collect()),
            "--peer" => o.peer = Some(value()?),
            "--check" => o.check = Some(PathBuf::from(value()?)),
            "--count" => {
                let text = value()?;
                let numbers: Vec<usize> = text.split('/').filter_map(|n| n.parse().ok()).collect();
                o.count = <[usize; 2]>::try_from(numbers).ok().filter(|[part, parts]| part < parts);
            }
            _ => return Err(format!("{argument} is not known\n{USAGE}")),
        }
    }
    Ok(o)
}

fn subjects(wanted: Option<&Vec<String>>) -> Result<Vec<Subject>, String> {
    let mut all = scenes::all();
    if let Some(wanted) = wanted {
        let names: Vec<&str> = all.iter().map(|s| s.name.as_str()).collect();
        if let Some(unknown) = wanted.iter().find(|w| !names.contains(&w.as_str())) {
            return Err(format!("there is no scene {unknown}; there are {}", names.join(", ")));
        }
        all.retain(|s| wanted.contains(&s.name));
    }
    Ok(all)
}

/// Instructions a fragment, where callgrind can be run; says whether they are there.
fn instructions(outcomes: &mut [Outcome], o: &Options, effort: Effort, bar: &ProgressBar) -> Result<bool, String> {
    if o.quick || o.scenes.is_some() || !clock::has_valgrind() {
        return Ok(false);
    }
    bar.set_message("instructions, under callgrind");
    let folder = o.out.join("counts");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let parts = std::thread::available_parallelism().map_or(1, std::num::NonZero::get).min(4);
    let started: Result<Vec<_>, _> = (0..parts).map(|p| clock::start_counting(&folder, p, parts)).collect();
    let mut ended = true;
    for mut child in started.map_err(|e| format!("valgrind: {e}"))? {
        ended &= child.wait().is_ok_and(|status| status.success());
    }
    let counts: Vec<Vec<u64>> = (0..parts).map(|p| clock::counts(&folder, p)).collect();
    let _ = std::fs::remove_dir_all(&folder);
    run::place_counts(outcomes, effort, &counts);
    Ok(ended && counts.iter().all(|c| !c.is_empty()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}

/// Prints what failed; whether nothing did.
fn verdict(checks: &[table::Check], risen: &[String]) -> bool {
    let failed: Vec<_> = checks.iter().filter(|c| !c.kept).collect();
    println!("\npromises in the default setting: {} of {} kept", checks.len() - failed.len(), checks.len());
    failed.iter().for_each(|c| println!("FAIL  {}: {}: {}", c.scene, c.what, c.figure));
    risen.iter().for_each(|words| println!("RISEN  {words}"));
    failed.is_empty() && risen.is_empty()
}

fn report(o: &Options) -> Result<bool, String> {
    let begin = Instant::now();
    let level = Config::from_env().level;
    let ours = Ours { level };
    let effort =
        Effort { quick: o.quick, samples: if o.quick { 12 } else { 48 }, seconds: if o.quick { 0.15 } else { 1.2 } };
    let subjects = subjects(o.scenes.as_ref())?;
    if let Some(part) = o.count {
        run::count(&ours, &subjects, effort, part);
        return Ok(true);
    }
    let peer = o.peer.as_deref().map(peer::Peer::load).transpose()?;
    let mut libraries: Vec<&dyn Library> = vec![&ours];
    libraries.extend(peer.as_ref().map(|p| p as &dyn Library));
    let names: Vec<&str> = libraries.iter().map(|l| l.name()).collect();
    let bar = ProgressBar::new(subjects.iter().map(|s| run::steps(s, effort, libraries.len())).sum());
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}") {
        bar.set_style(style);
    }
    bar.set_message("what the pictures ought to be");
    let truths = run::truths(&ours, &subjects, effort, &bar);
    bar.set_message("hints");
    let verdicts = hints::verdicts(&ours, &subjects, effort.samples, effort.seconds);
    let mut outcomes = Vec::new();
    for (subject, truth) in subjects.into_iter().zip(&truths) {
        bar.set_message(subject.name.clone());
        outcomes.push(run::measure(&libraries, subject, truth, effort, &bar));
    }
    let counted = instructions(&mut outcomes, o, effort, &bar)?;
    bar.finish_and_clear();
    let checks = table::checks(&outcomes);
    let conclusions = words::conclusions(&outcomes);
    println!("{}\n{}", table::text(&outcomes, &names), table::stages(&outcomes, &names));
    conclusions.iter().for_each(|(_, text)| println!("{text}\n"));
    for v in &verdicts {
        println!("{}: {}. {}\n", v.hint, v.words(), v.text);
    }
    let run = page::Run {
        names: &names,
        level: format!("{level:?}"),
        samples: effort.samples,
        seconds: begin.elapsed().as_secs_f64(),
        instructions: counted,
    };
    let html = o.out.join("report.html");
    write(&html, &page::page(&outcomes, &checks, &conclusions, &verdicts, &run))?;
    write(&o.out.join("report.csv"), &table::csv(&outcomes, &names))?;
    write(&o.out.join("stages.csv"), &table::stages_csv(&outcomes, &names))?;
    let now = table::baseline(&outcomes);
    let mut risen = Vec::new();
    if o.bless {
        write(o.check.as_deref().unwrap_or(Path::new(BASELINE)), &now)?;
    } else if let Some(path) = &o.check {
        let kept = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        risen = table::risen(&now, &kept);
    }
    let fine = verdict(&checks, &risen);
    println!("{} in {:.0} s", html.display(), begin.elapsed().as_secs_f64());
    Ok(fine)
}

fn main() -> ExitCode {
    let options = match options() {
        Ok(options) => options,
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    };
    match report(&options) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
