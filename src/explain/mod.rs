//! Explaining: what the present state makes of the pipeline, stage by stage, each kept, left out or hoisted with the
//! reason in a sentence; and counters of what was really done. This room looks at everything and is used by nothing.
//!
//! ```
//! use fixedgl::{Context, enums::*};
//! let mut gl = Context::new(64, 64);
//! gl.enable(GL_DEPTH_TEST);
//! gl.set_counting(true);
//! gl.rectf(-0.5, -0.5, 0.5, 0.5);
//! gl.finish();
//! let explanation = gl.explain();
//! assert!(explanation.kept("depth test") && !explanation.kept("fog"));
//! assert_eq!(gl.counters().passed, 32 * 32);
//! println!("{explanation}{}", gl.counters());
//! ```

mod vertices;

use crate::context::Context;
pub use crate::fragment::program::{Decision, Fate};
use crate::simd::Tally;
pub use crate::simd::{Counters, StageCount};
use std::fmt;

/// What becomes of every stage in the present state.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Explanation {
    /// A line for each stage, in the order of the pipeline.
    pub decisions: Vec<Decision>,
    /// The names of the vertex stages that run, in order.
    pub vertex_stages: Vec<&'static str>,
    /// The names of the fragment stages that run over batches of fragments, in order.
    pub fragment_stages: Vec<&'static str>,
    /// The names of the span kernels that do rows of a primitive instead of those: one for long rows, one for the short rows of
    /// a primitive together. None where no kernel covers the state; the line "span kernel" says why.
    pub span_kernels: Vec<&'static str>,
}

impl Explanation {
    /// The line of a stage.
    #[must_use]
    pub fn decision(&self, stage: &str) -> Option<&Decision> {
        self.decisions.iter().find(|d| d.stage == stage)
    }

    /// Whether a stage is kept.
    #[must_use]
    pub fn kept(&self, stage: &str) -> bool {
        self.decision(stage).is_some_and(|d| d.fate == Fate::Kept)
    }

    /// Everything in one line, for traces.
    #[must_use]
    pub fn in_one_line(&self) -> String {
        crate::fragment::explain::in_one_line(&self.decisions)
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.decisions.iter().map(|d| d.stage.len()).max().unwrap_or(0);
        for d in &self.decisions {
            writeln!(f, "{:width$}  {:8}  {}", d.stage, d.fate, d.reason)?;
        }
        writeln!(f, "vertex stages: {}", self.vertex_stages.join(", ").to_lowercase())?;
        writeln!(f, "fragment stages: {}", self.fragment_stages.join(", ").to_lowercase())?;
        let kernels =
            if self.span_kernels.is_empty() { "none".into() } else { self.span_kernels.join(", ").to_lowercase() };
        writeln!(f, "span kernels: {kernels}")
    }
}

impl Context {
    /// What becomes of every stage if something is drawn in the present state. Inside of Begin and End it is what the
    /// vertices get that are given now. Nothing is drawn, no error is recorded.
    pub fn explain(&mut self) -> Explanation {
        self.engine.validate();
        let fragments = self.engine.decisions();
        let engine = &self.engine;
        let Some(program) = &engine.program else { return Explanation::default() };
        let mut decisions = vertices::decisions(&engine.state, &engine.pipe.plan);
        decisions.extend(fragments);
        Explanation {
            decisions,
            vertex_stages: engine.pipe.plan.plan.names().collect(),
            fragment_stages: program.stage_names(),
            span_kernels: program.span_names(),
        }
    }

    /// Begins or ends counting. What is counted changes no pixel and costs some time, so it is off at first. Beginning
    /// sets all counters to zero.
    pub fn set_counting(&mut self, on: bool) {
        self.engine.flush_scene();
        self.engine.count_into(on.then(Tally::default));
    }

    /// What was done since counting began, waiting draws included; zeros where nobody counts.
    pub fn counters(&mut self) -> Counters {
        self.engine.flush_scene();
        self.engine.gather_counts()
    }
}
