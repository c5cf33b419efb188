//! What was not as it should be in a file: one sentence for each kind, with the first line where it was met.

use std::path::Path;

/// The notes on one file.
#[derive(Debug, Default)]
pub(super) struct Notes {
    kinds: Vec<Note>,
}

#[derive(Debug)]
struct Note {
    consequence: &'static str,
    first: String,
    more: usize,
}

impl Notes {
    /// Notes what is wrong in a line (0: in the file as a whole). What follows from it (read after "; ") says of which kind it is: only the first of a
    /// kind is kept in words.
    pub fn add(&mut self, line: usize, what: impl FnOnce() -> String, consequence: &'static str) {
        match self.kinds.iter_mut().find(|note| note.consequence == consequence) {
            Some(note) => note.more += 1,
            None => {
                let first = if line == 0 { what() } else { format!("line {line}: {}", what()) };
                self.kinds.push(Note { consequence, first, more: 0 });
            }
        }
    }

    /// The first thing that was wrong, without what follows from it.
    pub fn first(&self) -> Option<&str> {
        self.kinds.first().map(|note| note.first.as_str())
    }

    /// The sentences; `file` is named where they are not about the model's own file.
    pub fn sentences(&self, file: Option<&Path>) -> impl Iterator<Item = String> {
        self.kinds.iter().map(move |Note { consequence, first, more }| {
            let file = file.map_or(String::new(), |file| format!("{}: ", file.display()));
            let more = match more {
                0 => String::new(),
                1 => " (and 1 more like it)".to_owned(),
                more => format!(" (and {more} more like it)"),
            };
            format!("{file}{first}; {consequence}{more}")
        })
    }
}
