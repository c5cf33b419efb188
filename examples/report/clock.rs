//! What a fragment costs. Time: every configuration of a scene stands ready in a context of its own, and they take turns;
//! a turn draws the picture several times before it finishes, so that what a frame costs by itself hardly counts, and the
//! least of all turns is taken: others that use the machine can only make them longer. The time is the processor's, over
//! all threads of the program, where the system tells it. Instructions: the report runs itself under callgrind, which
//! writes down its counters whenever [`counted`] is called.

use super::gl::{Gl, Library};
use super::knobs::Knobs;
use super::oracle::scene::Scene;
use super::translate;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A context that is ready to draw one configuration.
pub struct Ready {
    gl: Box<dyn Gl>,
    scene: Scene,
    knobs: Knobs,
    /// How often a turn draws.
    repeat: u32,
    first: f64,
    least: f64,
}

/// What the processor has spent on this program, in seconds.
fn processor_time() -> Option<f64> {
    std::thread::yield_now();
    let mut sum = 0.0;
    for task in std::fs::read_dir("/proc/self/task").ok()?.flatten() {
        let text = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
        sum += text.split(' ').next()?.parse::<f64>().ok()? * 1e-9;
    }
    Some(sum)
}

impl Ready {
    /// A context in the state of the scene with these knobs, its first picture drawn.
    pub fn new(library: &dyn Library, scene: &Scene, knobs: &Knobs) -> Ready {
        let scene = knobs.apply(scene);
        let mut gl = library.open([scene.width, scene.height], false);
        translate::state(gl.as_mut(), &scene);
        let start = Instant::now();
        knobs.draw(gl.as_mut(), &scene);
        gl.finish();
        let first = start.elapsed().as_secs_f64();
        Ready { gl, scene, knobs: knobs.clone(), repeat: 0, first, least: f64::MAX }
    }

    /// A picture that takes this long is timed once.
    fn is_slow(&self) -> bool {
        self.first > 1.0
    }

    /// The picture.
    pub fn picture(&mut self) -> Vec<[u8; 4]> {
        self.gl.make_current();
        self.gl.bytes()
    }

    fn frame(&mut self, count: u32) -> f64 {
        self.gl.make_current();
        let (before, start) = (processor_time(), Instant::now());
        for _ in 0..count {
            self.knobs.draw_again(self.gl.as_mut(), &self.scene);
        }
        self.gl.finish();
        let clock = start.elapsed().as_secs_f64();
        match (before, processor_time()) {
            (Some(before), Some(after)) if after > before => after - before,
            _ => clock,
        }
    }

    /// One turn.
    fn turn(&mut self) {
        if self.is_slow() {
            return;
        }
        if self.repeat == 0 {
            self.repeat = (4e-3 / self.frame(1).max(1e-9)).clamp(2.0, 16.0) as u32;
        }
        self.least = self.least.min(self.frame(self.repeat) / f64::from(self.repeat));
    }

    /// The seconds of a picture.
    fn cost(&self) -> f64 {
        if self.is_slow() { self.first } else { self.least }
    }
}

/// The seconds of a picture of each configuration, the least of as many turns as the time allows.
pub fn measure(ready: &mut [Ready], time: Duration) -> Vec<f64> {
    let end = Instant::now() + time;
    let mut rounds = 0;
    while rounds < 3 || Instant::now() < end {
        ready.iter_mut().for_each(Ready::turn);
        rounds += 1;
    }
    ready.iter().map(Ready::cost).collect()
}

/// Draws pictures; callgrind counts what happens in here.
#[inline(never)]
pub fn counted(ready: &mut Ready, pictures: u32) {
    for _ in 0..pictures {
        ready.knobs.draw_again(ready.gl.as_mut(), &ready.scene);
    }
    ready.gl.finish();
}

/// Whether callgrind can be run.
pub fn has_valgrind() -> bool {
    let run = Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    run.is_ok_and(|status| status.success())
}

/// Starts this program under callgrind: part `part` of `parts`, its counts in `folder`.
pub fn start_counting(folder: &Path, part: usize, parts: usize) -> std::io::Result<std::process::Child> {
    let file = folder.join(format!("counts-{part}"));
    Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(format!("--callgrind-out-file={}", file.display()))
        .args(["--toggle-collect=report::clock::counted", "--dump-before=report::clock::counted"])
        .arg(std::env::current_exe()?)
        .args(["--count", &format!("{part}/{parts}")])
        .env("FIXEDGL_SIMD", "avx2")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
}

/// The counts that callgrind has written: one for each time that [`counted`] returned, in order. The first file is of the
/// time before the first call, the last has no number.
pub fn counts(folder: &Path, part: usize) -> Vec<u64> {
    let count = |name: String| -> Option<u64> {
        let text = std::fs::read_to_string(folder.join(name)).ok()?;
        text.lines().find_map(|line| line.strip_prefix("totals: "))?.trim().parse().ok()
    };
    let numbered = (2..).map_while(|number| count(format!("counts-{part}.{number}")));
    numbered.chain(count(format!("counts-{part}"))).collect()
}
