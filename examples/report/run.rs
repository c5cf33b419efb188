//! The measurement: first what every picture ought to be, on all processors; then, one scene after the other on one
//! thread, what each library draws, how far that is from what it ought to be, and how long it takes. Error and time are
//! those of the same context with the same state.

use super::clock::{self, Ready};
use super::front::{Point, front};
use super::gl::{Library, Ours};
use super::knobs::{Knobs, settings};
use super::metrics::{Error, as_floats, ssim};
use super::scenes::Subject;
use super::stages::{self, Expected, Figures, Stage};
use super::truth::{self, Convergence, Filtered, Spec};
use indicatif::ProgressBar;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// How much is measured.
#[derive(Clone, Copy)]
pub struct Effort {
    /// The few settings of a quick run.
    pub quick: bool,
    /// Samples along a side of a pixel of the ideal.
    pub samples: u32,
    /// Seconds of timing for each scene and library.
    pub seconds: f64,
}

/// What the pictures of a scene ought to be.
pub struct Truth {
    pub settings: Vec<Knobs>,
    specs: Vec<Spec>,
    stages: Vec<Expected>,
    ideal: Filtered,
    convergence: Vec<Convergence>,
}

/// A line of the table.
pub struct Row {
    /// The place of the library.
    pub library: usize,
    pub knobs: Knobs,
    /// E_spec, and the share of pixels left out of it because either of two texels is right.
    pub spec: Error,
    pub doubtful: f64,
    /// E_samp under the square and under the Gaussian, and the similarity to the former.
    pub square: Error,
    pub gauss: Error,
    pub ssim: f64,
    /// ns and instructions a fragment.
    pub ns: f64,
    pub instructions: Option<f64>,
    /// Whether the setting is on the library's Pareto front of time and E_samp.
    pub front: bool,
}

/// One picture.
pub type Picture = Vec<[u8; 4]>;

/// All that is known about a scene.
pub struct Outcome {
    pub subject: Subject,
    pub rows: Vec<Row>,
    /// The stages, for each library.
    pub stages: Vec<Vec<(Stage, Option<Figures>)>>,
    /// Pixels missing and doubled, for each library.
    pub coverage: Vec<(usize, usize)>,
    pub convergence: Vec<Convergence>,
    /// The ideal, and what each row drew.
    pub ideal: Picture,
    pub spec: Picture,
    pub pictures: Vec<Picture>,
    /// Fragments of a picture.
    pub fragments: f64,
}

fn truth(ours: &Ours, subject: &Subject, effort: Effort, bar: &ProgressBar) -> Truth {
    let settings = settings(subject.depth, effort.quick);
    let spec = |knobs: &Knobs| {
        let spec = truth::spec(&subject.scene, knobs);
        bar.inc(1);
        spec
    };
    let specs = settings.iter().map(spec).collect();
    let (ideal, convergence) = truth::converged(ours, &subject.scene, effort.samples);
    bar.inc(1);
    Truth { settings, specs, stages: stages::expected(&subject.scene), ideal, convergence }
}

/// The truth about every scene, on all processors.
pub fn truths(ours: &Ours, subjects: &[Subject], effort: Effort, bar: &ProgressBar) -> Vec<Truth> {
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<(usize, Truth)>> = Mutex::new(Vec::new());
    let work = || {
        while let Some(subject) = subjects.get(next.fetch_add(1, Ordering::Relaxed)) {
            let place = subjects.iter().position(|s| std::ptr::eq(s, subject)).unwrap_or(0);
            let truth = truth(ours, subject, effort, bar);
            found.lock().expect("no thread panics with the lock").push((place, truth));
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    std::thread::scope(|scope| (0..threads).for_each(|_| _ = scope.spawn(work)));
    let mut found = found.into_inner().expect("no thread panics with the lock");
    found.sort_by_key(|(place, _)| *place);
    found.into_iter().map(|(_, truth)| truth).collect()
}

/// How many steps the progress bar makes for a scene.
pub fn steps(subject: &Subject, effort: Effort, libraries: usize) -> u64 {
    settings(subject.depth, effort.quick).len() as u64 + 1 + libraries as u64
}

fn rounded(ideal: &[[f32; 4]]) -> Picture {
    ideal.iter().map(|c| c.map(|v| v.round().clamp(0.0, 255.0) as u8)).collect()
}

/// Draws, compares and times a scene with every library.
pub fn measure(
    libraries: &[&dyn Library],
    subject: Subject,
    truth: &Truth,
    effort: Effort,
    bar: &ProgressBar,
) -> Outcome {
    let size = [subject.scene.width, subject.scene.height];
    let drawn: Vec<bool> = truth.specs[0].hits.iter().map(|h| *h > 0).collect();
    let fragments = f64::from(truth.specs[0].hits.iter().sum::<u32>());
    let mut outcome = Outcome {
        rows: Vec::new(),
        stages: Vec::new(),
        coverage: Vec::new(),
        convergence: truth.convergence.clone(),
        ideal: rounded(&truth.ideal.square),
        spec: rounded(&truth.specs[0].ideal),
        pictures: Vec::new(),
        fragments,
        subject,
    };
    for (place, library) in libraries.iter().enumerate() {
        let scene = &outcome.subject.scene;
        outcome.stages.push(stages::measure(*library, &truth.stages));
        outcome.coverage.push(stages::coverage(*library, scene));
        let mut ready: Vec<Ready> = truth.settings.iter().map(|k| Ready::new(*library, scene, k)).collect();
        let pictures: Vec<Picture> = ready.iter_mut().map(Ready::picture).collect();
        let costs = clock::measure(&mut ready, Duration::from_secs_f64(effort.seconds));
        let mut rows = Vec::new();
        for (i, knobs) in truth.settings.iter().enumerate() {
            let (spec, picture) = (&truth.specs[i], &pictures[i]);
            let doubtful = spec.doubtful.iter().filter(|d| **d).count();
            rows.push(Row {
                library: place,
                knobs: knobs.clone(),
                spec: Error::of(picture, &spec.ideal, |p| spec.hits[p] > 0 && !spec.doubtful[p]),
                doubtful: doubtful as f64 / drawn.iter().filter(|d| **d).count().max(1) as f64,
                square: Error::of(picture, &truth.ideal.square, |p| drawn[p]),
                gauss: Error::of(picture, &truth.ideal.gauss, |p| drawn[p]),
                ssim: ssim(&as_floats(picture), &truth.ideal.square, size),
                ns: costs[i] * 1e9 / fragments.max(1.0),
                instructions: None,
                front: false,
            });
        }
        let on_front = front(&points(&rows));
        for (row, on) in rows.iter_mut().zip(on_front) {
            row.front = on;
        }
        outcome.rows.append(&mut rows);
        outcome.pictures.extend(pictures);
        bar.inc(1);
    }
    outcome
}

/// Time and E_samp of rows.
pub fn points<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Vec<Point> {
    rows.into_iter().map(|r| Point { time: r.ns, error: r.square.rmse }).collect()
}

/// The configurations of this crate whose instructions are counted, in order: scene and setting. A picture that is
/// accumulated costs what its frames cost.
fn counted<'a>(subjects: impl Iterator<Item = &'a Subject>, effort: Effort) -> Vec<(usize, Knobs)> {
    let of = |(i, s): (usize, &Subject)| settings(s.depth, effort.quick).into_iter().map(move |k| (i, k));
    subjects.enumerate().flat_map(of).filter(|(_, knobs)| knobs.frames == 1).collect()
}

/// What runs under callgrind: every `parts`-th configuration, once and twice.
pub fn count(ours: &Ours, subjects: &[Subject], effort: Effort, [part, parts]: [usize; 2]) {
    for (scene, knobs) in counted(subjects.iter(), effort).into_iter().skip(part).step_by(parts) {
        let mut ready = Ready::new(ours, &subjects[scene].scene, &knobs);
        clock::counted(&mut ready, 1);
        clock::counted(&mut ready, 2);
    }
}

/// Puts the counts of all parts into the rows of this crate, which is the first library.
pub fn place_counts(outcomes: &mut [Outcome], effort: Effort, counts: &[Vec<u64>]) {
    let order = counted(outcomes.iter().map(|o| &o.subject), effort);
    for (n, (scene, knobs)) in order.into_iter().enumerate() {
        let (part, place) = (n % counts.len(), n / counts.len());
        let outcome = &mut outcomes[scene];
        let row = outcome.rows.iter_mut().find(|r| r.library == 0 && r.knobs == knobs);
        if let (Some(row), Some([one, two])) = (row, counts[part].get(2 * place..2 * place + 2)) {
            row.instructions = Some(two.saturating_sub(*one) as f64 / outcome.fragments.max(1.0));
        }
    }
}
