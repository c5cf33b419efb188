//! A program's decisions in one line, for traces.

use crate::fragment::program::{Decision, Fate};

/// Which stages are kept, hoisted and left out, in one line.
#[must_use]
pub fn in_one_line(decisions: &[Decision]) -> String {
    let of = |fate: Fate| {
        let all = decisions.iter().filter(|d| d.fate == fate);
        all.map(|d| d.stage.as_str()).collect::<Vec<_>>().join(", ")
    };
    format!("kept: {}; hoisted: {}; left out: {}", of(Fate::Kept), of(Fate::Hoisted), of(Fate::LeftOut))
}
