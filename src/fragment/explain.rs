//! A program's decisions in words: as a table, or in one line for traces.

use crate::fragment::program::{Decision, Fate, Program};

/// Which stages are kept, hoisted and left out, in one line.
#[must_use]
pub fn in_one_line(decisions: &[Decision]) -> String {
    let of = |fate: Fate| {
        let all = decisions.iter().filter(|d| d.fate == fate);
        all.map(|d| d.stage.as_str()).collect::<Vec<_>>().join(", ")
    };
    format!("kept: {}; hoisted: {}; left out: {}", of(Fate::Kept), of(Fate::Hoisted), of(Fate::LeftOut))
}

impl Program {
    /// The decisions as a table in plain text.
    #[must_use]
    pub fn explain(&self) -> String {
        let width = self.decisions.iter().map(|d| d.stage.len()).max().unwrap_or(0);
        let mut text = String::new();
        for d in &self.decisions {
            text.push_str(&format!("{:width$}  {:8}  {}\n", d.stage, d.fate, d.reason));
        }
        text
    }
}
