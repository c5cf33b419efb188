//! How a context runs: which instruction set, how many threads, which buffers. Nothing here changes a bit of a picture
//! (apart from the buffers themselves); that is what the invariance tests check.

use crate::framebuffer::FramebufferFormat;
use crate::simd::{LANES, Level};

/// How a context runs: `Config::default().with_threads(1)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Config {
    /// The instruction set of the stages.
    pub level: Level,
    /// How many threads draw; 1 draws in the calling thread.
    pub threads: usize,
    /// How many fragments a batch holds at most, 1 to 64. Smaller batches are slower and give the same picture.
    pub batch_cut: usize,
    /// Runs every stage even where the state makes it a no-op. Slower, the same picture.
    pub general_plan: bool,
    /// Whether every error and all advice of the library is written to standard error, each sentence once.
    pub debug: bool,
    /// The buffers of the framebuffer.
    pub format: FramebufferFormat,
}

impl Default for Config {
    /// The highest level and all processors.
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            level: Level::detect(),
            threads,
            batch_cut: LANES,
            general_plan: false,
            debug: false,
            format: FramebufferFormat::default(),
        }
    }
}

impl Config {
    /// The default with what the environment says: `FIXEDGL_THREADS` is a number of threads, `FIXEDGL_SIMD` is
    /// `baseline`, `avx2` or `avx512`, `FIXEDGL_DEBUG` is 1 for [`Config::debug`]. What cannot be read is ignored.
    #[must_use]
    pub fn from_env() -> Self {
        let value = |name: &str| std::env::var(name).ok();
        let default = Self::default();
        let threads = value("FIXEDGL_THREADS").and_then(|v| v.trim().parse().ok()).unwrap_or(default.threads);
        let level = value("FIXEDGL_SIMD").and_then(|v| Level::from_name(v.trim())).unwrap_or(default.level);
        let debug = value("FIXEDGL_DEBUG").is_some_and(|v| !matches!(v.trim(), "" | "0"));
        Self { level, threads, debug, ..default }.checked()
    }

    /// The same with another instruction set.
    #[must_use]
    pub const fn with_level(self, level: Level) -> Self {
        Self { level, ..self }
    }

    /// The same with another number of threads.
    #[must_use]
    pub const fn with_threads(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// The same with batches of at most so many fragments.
    #[must_use]
    pub const fn with_batch_cut(self, batch_cut: usize) -> Self {
        Self { batch_cut, ..self }
    }

    /// The same with every stage running, or only those that the state needs.
    #[must_use]
    pub const fn with_general_plan(self, general_plan: bool) -> Self {
        Self { general_plan, ..self }
    }

    /// The same with errors and advice written to standard error, or not.
    #[must_use]
    pub const fn with_debug(self, debug: bool) -> Self {
        Self { debug, ..self }
    }

    /// The same with other buffers.
    #[must_use]
    pub const fn with_format(self, format: FramebufferFormat) -> Self {
        Self { format, ..self }
    }

    /// The same with every number in its range.
    #[must_use]
    pub(crate) fn checked(self) -> Self {
        Self { threads: self.threads.clamp(1, 256), batch_cut: self.batch_cut.clamp(1, LANES), ..self }
    }
}
