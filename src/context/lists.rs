//! Display lists: compiling, calling, names (OpenGL 1.5, section 5.4). Lists call lists without recursion: a stack of
//! positions takes the place of the machine's stack, so that 64 levels are 64 small frames, and a list that calls itself
//! ends there as the specification says.

use super::list_compile::compile;
use super::list_vertices::ListVertices;
use super::recorder::{Command, FailedCommand, List, ListDraw, OpenList, Other};
use super::{Context, param_counts};
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, invalid_value, out_of_memory, too_short};
use crate::state::pixel::PixelStore;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;

/// Depth of lists within lists (`MAX_LIST_NESTING`).
pub(crate) const MAX_LIST_NESTING: usize = 64;

/// Work that one CallList may always lead to, in vertices (see [`Command::work`]): less than a second. A list that calls
/// itself twice would otherwise run 2^64 times.
const WORK: u64 = 1 << 23;

/// How often, beyond [`WORK`], all that the lists of a context hold may be carried out by one CallList.
const TIMES: u64 = 64;

/// Texels or pixels that take as long as a vertex.
const PIXELS_OF_A_VERTEX: u64 = 16;

/// A position in what is being carried out.
enum Frame {
    /// A list and the next command in it.
    List(List, usize),
    /// The offsets of a CallLists, the next of them, and the list base at the time of the call.
    Names(Arc<Vec<u32>>, usize, u32),
}

/// The names of a CallLists as offsets from the list base (section 5.4).
pub(crate) fn offsets(n: i32, type_: GLenum, bytes: &[u8]) -> Outcome<Arc<Vec<u32>>> {
    let Some(size) = param_counts::list_name_size(type_) else {
        let what = name(type_);
        return Err(invalid_enum(format!(
            "{what} is no type of list names; use GL_UNSIGNED_BYTE, GL_UNSIGNED_INT, ..."
        )));
    };
    if n < 0 {
        return Err(invalid_value(format!("n = {n} is negative")));
    }
    let needed = param_counts::list_names(n, type_);
    let bytes = bytes.get(..needed).ok_or_else(|| too_short("lists", needed, bytes.len(), "bytes"))?;
    let names = bytes.chunks_exact(size);
    let mut all = Vec::new();
    all.try_reserve_exact(names.len()).map_err(|_| out_of_memory("no memory left for list names"))?;
    all.extend(names.map(|b| match (type_, b) {
        (GL_BYTE, [a]) => i32::from(*a as i8) as u32,
        (GL_SHORT, [a, b]) => i32::from(i16::from_ne_bytes([*a, *b])) as u32,
        (GL_UNSIGNED_SHORT, [a, b]) => u32::from(u16::from_ne_bytes([*a, *b])),
        (GL_FLOAT, [a, b, c, d]) => f32::from_ne_bytes([*a, *b, *c, *d]) as i64 as u32,
        (GL_INT | GL_UNSIGNED_INT, [a, b, c, d]) => u32::from_ne_bytes([*a, *b, *c, *d]),
        // 2_BYTES to 4_BYTES: the first byte is the most significant one on every machine.
        _ => b.iter().fold(0, |value, byte| value << 8 | u32::from(*byte)),
    }));
    Ok(Arc::new(all))
}

impl Context {
    /// Adds a command to the open list. Returns whether it is to be carried out as well.
    #[cold]
    #[track_caller]
    pub(crate) fn record(&mut self, name: &'static str, op: impl Into<Command>) -> bool {
        let Some(open) = &mut self.recorder.open else { return true };
        if open.commands.try_reserve(1).is_err() {
            return self.fail(name, out_of_memory("no memory left for the display list; the command is not in it"));
        }
        open.commands.push(op.into());
        self.executes()
    }

    /// Whether the open list is carried out as well.
    pub(crate) fn executes(&self) -> bool {
        self.recorder.open.as_ref().is_none_or(|open| open.mode == GL_COMPILE_AND_EXECUTE)
    }

    pub(crate) fn open_list(&mut self, list: u32, mode: GLenum) -> Outcome {
        if list == 0 {
            return Err(invalid_value("0 is no name of a list; take one from glGenLists"));
        }
        if !matches!(mode, GL_COMPILE | GL_COMPILE_AND_EXECUTE) {
            let mode = name(mode);
            return Err(invalid_enum(format!("mode is {mode}; use GL_COMPILE or GL_COMPILE_AND_EXECUTE")));
        }
        if let Some(open) = &self.recorder.open {
            return Err(invalid_operation(format!("list {} is open; call glEndList first", open.name)));
        }
        self.recorder.open = Some(OpenList { name: list, mode, commands: Vec::new() });
        self.flags.set_recording(true);
        Ok(())
    }

    pub(crate) fn close_list(&mut self) -> Outcome {
        let Some(open) = self.recorder.open.take() else {
            return Err(invalid_operation("no list is open; call glNewList first"));
        };
        self.flags.set_recording(false);
        self.recorder.names.insert(open.name, open.name);
        self.recorder.insert(open.name, compile(open.commands));
        Ok(())
    }

    pub(crate) fn reserve_lists(&mut self, range: i32) -> Outcome<u32> {
        if range < 0 {
            return Err(invalid_value(format!("range = {range} is negative")));
        }
        let n = range.unsigned_abs();
        match self.recorder.names.find_free(n.max(1)) {
            Some(first) if n > 0 => {
                self.recorder.names.insert(first, first + (n - 1));
                Ok(first)
            }
            _ => Ok(0),
        }
    }

    pub(crate) fn remove_lists(&mut self, list: u32, range: i32) -> Outcome {
        if range < 0 {
            return Err(invalid_value(format!("range = {range} is negative")));
        }
        if let Some(more) = range.unsigned_abs().checked_sub(1) {
            let last = list.saturating_add(more);
            self.recorder.names.remove(list, last);
            self.recorder.remove(list, last);
        }
        Ok(())
    }

    /// Calls `f` while the unpack state is that of memory without gaps, also where a callback of the program panics.
    pub(crate) fn with_tight_rows<T>(&mut self, f: impl FnOnce(&mut Self) -> T) -> T {
        let store = self.engine.unpack_store();
        self.engine.set_unpack_store(PixelStore::TIGHT);
        let result = catch_unwind(AssertUnwindSafe(|| f(self)));
        self.engine.set_unpack_store(store);
        result.unwrap_or_else(|panic| resume_unwind(panic))
    }

    /// Carries out lists by their offsets from a base. Images that lists hold are tight: so is the unpack state meanwhile.
    #[track_caller]
    pub(crate) fn run_lists(&mut self, command: &'static str, offsets: Arc<Vec<u32>>, base: u32) {
        self.with_tight_rows(|cx| cx.run_stack(command, offsets, base));
    }

    #[track_caller]
    fn run_stack(&mut self, command: &'static str, offsets: Arc<Vec<u32>>, base: u32) {
        let mut stack = vec![Frame::Names(offsets, 0, base)];
        let (mut depth, mut work) = (0, 0);
        let (pixels, most) =
            (self.engine.pixels_written, WORK.saturating_add(self.recorder.work.saturating_mul(TIMES)));
        while let Some(top) = stack.last_mut() {
            let called = match top {
                Frame::Names(offsets, next, base) => {
                    let Some(offset) = offsets.get(*next).copied() else {
                        stack.pop();
                        continue;
                    };
                    *next += 1;
                    base.wrapping_add(offset)
                }
                Frame::List(list, next) => {
                    let list = List::clone(list);
                    let run = list.commands.get(*next..).unwrap_or_default();
                    let call = run.iter().position(|c| matches!(c, Command::Call(_) | Command::Calls(_)));
                    *next += call.map_or(run.len(), |i| i + 1);
                    for op in run.iter().take(call.unwrap_or(run.len())) {
                        op.run(self);
                    }
                    match call.and_then(|i| run.get(i)) {
                        Some(Command::Call(name)) => *name,
                        Some(Command::Calls(offsets)) => {
                            stack.push(Frame::Names(Arc::clone(offsets), 0, self.engine.current_list_base()));
                            continue;
                        }
                        _ => {
                            stack.pop();
                            depth -= 1;
                            continue;
                        }
                    }
                }
            };
            work += 1;
            if depth < MAX_LIST_NESTING
                && let Some(list) = self.recorder.lists.get(&called)
            {
                work += list.work;
                stack.push(Frame::List(List::clone(list), 0));
                depth += 1;
            }
            let written = self.engine.pixels_written.wrapping_sub(pixels) / PIXELS_OF_A_VERTEX;
            if work.saturating_add(written) > most {
                return self.fail(command, invalid_operation(format!(
                    "gave up after {work} vertices and commands: does a list call itself? One call may lead to {WORK} of \
                     them, and {TIMES} times what all lists hold"
                )));
            }
        }
    }
}

impl Command {
    /// Carries the command out, unless it is a call of lists: those are the affair of `Context::run_lists`.
    #[track_caller]
    fn run(&self, cx: &mut Context) {
        match self {
            Command::Vertex(op) => op.run(cx),
            Command::VertexArray(vertices) => run_vertices(cx, vertices),
            Command::Other(other) => other.run(cx),
            Command::Draw(draw) => run_draw(cx, draw),
            Command::Failed(failed) => run_failed(cx, failed),
            Command::Call(_) | Command::Calls(_) => {}
        }
    }
}

impl Other {
    /// Carries the command out.
    #[track_caller]
    fn run(&self, cx: &mut Context) {
        match self {
            Other::Transform(op) => op.run(cx),
            Other::Lighting(op) => op.run(cx),
            Other::Raster(op) => op.run(cx),
            Other::Texture(op) => op.run(cx),
            Other::Pixels(op) => op.run(cx),
            Other::Fragment(op) => op.run(cx),
            Other::Lists(op) => op.run(cx),
            Other::Evaluators(op) => op.run(cx),
            Other::Imaging(op) => op.run(cx),
        }
    }
}

/// Carries a Begin/End pair out.
#[track_caller]
fn run_vertices(cx: &mut Context, vertices: &ListVertices) {
    let engine = &mut cx.engine;
    if engine.inside_begin_end() || vertices.q_units & !engine.q_units != 0 {
        return vertices.commands(|op| op.run(cx));
    }
    engine.draw_list_vertices(vertices);
}

/// Carries a draw from arrays out.
#[track_caller]
fn run_draw(cx: &mut Context, draw: &ListDraw) {
    if cx.engine.inside_begin_end() {
        return cx.refuse_inside(draw.name);
    }
    let current = cx.engine.state.current;
    for command in &draw.pairs {
        command.run(cx);
    }
    cx.engine.state.current = current;
    cx.engine.track_color();
}

/// Raises the error of a command that was wrong when it was recorded.
#[track_caller]
fn run_failed(cx: &mut Context, failed: &FailedCommand) {
    if !failed.inside && cx.engine.inside_begin_end() {
        return cx.refuse_inside(failed.name);
    }
    cx.fail(failed.name, failed.error.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_every_type_are_read() {
        let read = |type_, bytes: &[u8]| offsets(1, type_, bytes).map(|o| o.first().copied());
        assert_eq!(read(GL_BYTE, &[0xFF]), Ok(Some(u32::MAX)));
        assert_eq!(read(GL_2_BYTES, &[1, 2]), Ok(Some(0x102)));
        assert_eq!(read(GL_3_BYTES, &[1, 2, 3]), Ok(Some(0x1_0203)));
        assert_eq!(read(GL_4_BYTES, &[1, 2, 3, 4]), Ok(Some(0x102_0304)));
        assert_eq!(read(GL_FLOAT, &7.9_f32.to_ne_bytes()), Ok(Some(7)));
        assert!(read(GL_DOUBLE, &[]).is_err());
    }
}
