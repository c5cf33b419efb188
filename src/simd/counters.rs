//! What was done: vertices, primitives, fragments into and out of each stage, texels read, divisions, logarithms. Nothing
//! is counted unless somebody asks for it ([`Tally`] is handed to the plans); the counts tell what leaving out left out.

use std::fmt;
use std::ops::AddAssign;
use std::sync::{Arc, Mutex};

/// What one stage did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StageCount {
    /// The stage, as a plan names it.
    pub name: &'static str,
    /// Batches that it ran over.
    pub batches: u64,
    /// Fragments that came to it alive.
    pub fragments: u64,
    /// Fragments that it killed.
    pub killed: u64,
}

/// What a pixel of a span costs, or many do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelCost {
    /// Texels read.
    pub texels: u64,
    /// Divisions by w.
    pub divisions: u64,
    /// Logarithms for the level of detail.
    pub logarithms: u64,
    /// Texture coordinates wrapped.
    pub wraps: u64,
}

impl PixelCost {
    /// What so many pixels cost.
    #[must_use]
    pub fn times(self, n: u64) -> Self {
        let Self { texels, divisions, logarithms, wraps } = self;
        Self { texels: n * texels, divisions: n * divisions, logarithms: n * logarithms, wraps: n * wraps }
    }
}

impl AddAssign for PixelCost {
    fn add_assign(&mut self, other: Self) {
        self.texels += other.texels;
        self.divisions += other.divisions;
        self.logarithms += other.logarithms;
        self.wraps += other.wraps;
    }
}

/// What was done since counting began.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counters {
    /// Vertices whose position was transformed.
    pub vertices: u64,
    /// Vertices that were lit, and whose texture coordinates were made: those of primitives that can be seen.
    pub vertices_valued: u64,
    /// Triangles, lines and points that can be seen, before clipping.
    pub primitives: u64,
    /// Primitives that had to be clipped.
    pub clipped: u64,
    /// Triangles that were culled for the side that they show.
    pub culled: u64,
    /// Primitives outside of the view volume.
    pub outside: u64,
    /// Fragments that came to the fragment program.
    pub fragments: u64,
    /// Fragments that passed all tests.
    pub passed: u64,
    /// Texels read.
    pub texels: u64,
    /// Divisions by w or q, one for each fragment and divisor.
    pub divisions: u64,
    /// Logarithms for the level of detail.
    pub logarithms: u64,
    /// Texture coordinates that were wrapped, one for each fragment, level and coordinate.
    pub wraps: u64,
    /// Mipmap levels that were built.
    pub levels_built: u64,
    /// What each stage did, in the order in which they were met.
    pub stages: Vec<StageCount>,
}

/// Counters that several workers add to.
pub type Tally = Arc<Mutex<Counters>>;

impl Counters {
    /// What a stage did; zeros if it never ran. Names are compared without regard to case.
    #[must_use]
    pub fn stage(&self, name: &str) -> StageCount {
        self.stages.iter().find(|s| s.name.eq_ignore_ascii_case(name)).copied().unwrap_or_default()
    }

    /// Adds a batch of a stage: `fragments` were alive before it, `left` after it.
    pub fn add_stage(&mut self, name: &'static str, fragments: u64, left: u64) {
        let at = self.stages.iter().position(|s| s.name == name).unwrap_or_else(|| {
            self.stages.push(StageCount { name, ..StageCount::default() });
            self.stages.len() - 1
        });
        if let Some(stage) = self.stages.get_mut(at) {
            stage.batches += 1;
            stage.fragments += fragments;
            stage.killed += fragments.saturating_sub(left);
        }
    }

    /// Adds what the pixels of a span cost.
    pub fn add_pixels(&mut self, cost: PixelCost) {
        self.texels += cost.texels;
        self.divisions += cost.divisions;
        self.logarithms += cost.logarithms;
        self.wraps += cost.wraps;
    }

    /// Adds what another one counted of vertices, primitives and levels.
    pub fn add_vertices(&mut self, other: &Self) {
        self.vertices += other.vertices;
        self.vertices_valued += other.vertices_valued;
        self.primitives += other.primitives;
        self.clipped += other.clipped;
        self.culled += other.culled;
        self.outside += other.outside;
        self.levels_built += other.levels_built;
    }

    /// Adds to a tally, whatever became of another worker that held it.
    pub fn with(tally: &Tally, add: impl FnOnce(&mut Self)) {
        add(&mut tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner));
    }

    /// The sums by name, as a table shows them.
    fn rows(&self) -> [(&'static str, u64); 13] {
        [
            ("vertices transformed", self.vertices),
            ("vertices lit and textured", self.vertices_valued),
            ("primitives that can be seen", self.primitives),
            ("primitives clipped", self.clipped),
            ("triangles culled", self.culled),
            ("primitives outside the view", self.outside),
            ("fragments", self.fragments),
            ("fragments that passed all tests", self.passed),
            ("texels read", self.texels),
            ("divisions by w or q", self.divisions),
            ("logarithms", self.logarithms),
            ("coordinates wrapped", self.wraps),
            ("mipmap levels built", self.levels_built),
        ]
    }
}

impl fmt::Display for Counters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, count) in self.rows() {
            writeln!(f, "{name:32} {count:>12}")?;
        }
        if !self.stages.is_empty() {
            writeln!(f, "{:32} {:>12} {:>12} {:>12}", "stage", "batches", "fragments", "killed")?;
        }
        for s in &self.stages {
            writeln!(f, "{:32} {:>12} {:>12} {:>12}", s.name.to_lowercase(), s.batches, s.fragments, s.killed)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_add_up_by_name() {
        let tally = Tally::default();
        Counters::with(&tally, |c| c.add_stage("ALPHA_TEST", 64, 60));
        Counters::with(&tally, |c| c.add_stage("STORE", 60, 60));
        Counters::with(&tally, |c| c.add_stage("ALPHA_TEST", 10, 0));
        let counters = tally.lock().expect("nobody panicked").clone();
        let want = StageCount { name: "ALPHA_TEST", batches: 2, fragments: 74, killed: 14 };
        assert_eq!(counters.stage("alpha_test"), want);
        assert_eq!(counters.stage("fog_exp"), StageCount::default());
        assert!(counters.to_string().contains("alpha_test"));
    }
}
