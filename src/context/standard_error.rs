//! Errors and advice on standard error, for programs that have no debug callback: those in C, and any program that is
//! started with `FIXEDGL_DEBUG=1`. Each sentence is written once in a process, so that a fault of every frame is one line.

use super::errors::{DebugCallback, DebugMessage};
use crate::error::code_name;
use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;
use std::sync::Mutex;

/// How many sentences are remembered; after so many others a sentence may come again.
const REMEMBERED: usize = 1024;

/// The callback of a context whose configuration asks for it.
pub(crate) fn callback() -> DebugCallback {
    Box::new(|message| say(&line(message)))
}

/// A message as a line: where it comes from, which command, what was wrong. Commands that came through the C door were
/// called from a place that nobody knows.
fn line(message: &DebugMessage<'_>) -> String {
    let DebugMessage { id, message: text, command, file, line, .. } = message;
    let place = if is_c_door(file) { String::new() } else { format!("{file}:{line}: ") };
    let code = if *id == 0 { String::new() } else { format!("{}: ", code_name(*id)) };
    format!("{place}{command}: {code}{text}")
}

/// Whether a file is one of the C door's.
fn is_c_door(file: &str) -> bool {
    let source = Path::new(file!()).parent().and_then(Path::parent);
    source.is_some_and(|source| Path::new(file).starts_with(source.join("capi")))
}

/// Writes a sentence, unless it has been written before.
pub(crate) fn say(text: &str) {
    if first_time(text) {
        // Nobody can be told that standard error is closed.
        let _ = writeln!(std::io::stderr(), "fixedgl: {text}");
    }
}

fn first_time(text: &str) -> bool {
    static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let mut said = SAID.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if said.len() >= REMEMBERED {
        said.clear();
    }
    said.insert(text.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums::*;

    #[test]
    fn a_line_names_the_place_the_command_and_the_error() {
        let message = |id, file| DebugMessage {
            source: GL_DEBUG_SOURCE_API,
            type_: GL_DEBUG_TYPE_ERROR,
            id,
            severity: GL_DEBUG_SEVERITY_HIGH,
            message: "0x0001 is not a face",
            command: "glCullFace",
            file,
            line: 7,
        };
        assert_eq!(
            line(&message(GL_INVALID_ENUM, "main.rs")),
            "main.rs:7: glCullFace: GL_INVALID_ENUM: 0x0001 is not a face"
        );
        assert_eq!(line(&message(0, "src/capi/rows.rs")), "glCullFace: 0x0001 is not a face");
    }

    #[test]
    fn a_sentence_is_said_once() {
        assert!(first_time("said by this test alone"));
        assert!(!first_time("said by this test alone"));
    }
}
