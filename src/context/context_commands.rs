//! The commands that the context carries out itself: lists, draws that a list turns into vertices, the error flag, and
//! the few whose C form keeps a pointer (OpenGL 1.5, sections 2.5, 2.8, 2.9, 5.2 to 5.4). The rows of the table that
//! stand in the section `context` call the functions here; those in `manual` are the methods at the end.

use super::array_pointers::ATTRIBUTES;
use super::draw_arrays::ArrayElement;
use super::engine::Engine;
use super::list_compile::compile;
use super::recorder::{Command, FailedCommand, ListDraw};
use super::show::{Enumerant, Show};
use super::table::ops::vertex::Op;
use super::{Context, IndexLists, Indices, Pixels, Values};
use crate::enums::*;
use crate::error::{GlError, Outcome, invalid_value, out_of_memory};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;

/// The list that is open, for queries; everything else is the engine's.
pub(crate) fn get(cx: &mut Context, pname: GLenum) -> Outcome<Values> {
    let open = cx.recorder.open.as_ref();
    match pname {
        GL_LIST_INDEX => Ok(Values::uint(open.map_or(0, |open| open.name))),
        GL_LIST_MODE => Ok(Values::enumerant(open.map_or(0, |open| open.mode))),
        GL_MAX_LIST_NESTING => Ok(Values::int(super::lists::MAX_LIST_NESTING as i32)),
        _ => cx.engine.get(pname),
    }
}

#[track_caller]
pub(crate) fn get_error(cx: &mut Context, name: &'static str) -> GLenum {
    if cx.engine.inside_begin_end() {
        return cx.refuse_inside(name);
    }
    cx.take_error_code()
}

/// Carries out a command that is not allowed between Begin and End and never recorded.
#[track_caller]
fn outside<T: Default>(cx: &mut Context, name: &'static str, f: impl FnOnce(&mut Context) -> Outcome<T>) -> T {
    if cx.engine.inside_begin_end() {
        return cx.refuse_inside(name);
    }
    let result = f(cx);
    cx.deliver(name);
    cx.record_result(name, result)
}

#[track_caller]
pub(crate) fn new_list(cx: &mut Context, name: &'static str, list: u32, mode: GLenum) {
    outside(cx, name, |cx| cx.open_list(list, mode))
}

#[track_caller]
pub(crate) fn end_list(cx: &mut Context, name: &'static str) {
    outside(cx, name, Context::close_list)
}

#[track_caller]
pub(crate) fn gen_lists(cx: &mut Context, name: &'static str, range: i32) -> u32 {
    outside(cx, name, |cx| cx.reserve_lists(range))
}

#[track_caller]
pub(crate) fn delete_lists(cx: &mut Context, name: &'static str, list: u32, range: i32) {
    outside(cx, name, |cx| cx.remove_lists(list, range))
}

#[track_caller]
pub(crate) fn is_list(cx: &mut Context, name: &'static str, list: u32) -> bool {
    outside(cx, name, |cx| Ok(cx.recorder.names.contains(list)))
}

#[track_caller]
pub(crate) fn call_list(cx: &mut Context, name: &'static str, list: u32) {
    if cx.flags.recording() && !cx.record(name, Command::Call(list)) {
        return;
    }
    without_recording(cx, |cx| cx.run_lists(name, Arc::new(vec![list]), 0));
    cx.deliver(name);
}

#[track_caller]
pub(crate) fn call_lists(cx: &mut Context, name: &'static str, n: i32, type_: GLenum, lists: &Pixels<'_>) {
    let offsets = match super::lists::offsets(n, type_, lists.bytes().unwrap_or_default()) {
        Ok(offsets) => offsets,
        Err(error) => return cx.refuse(name, error),
    };
    if cx.flags.recording() && !cx.record(name, Command::Calls(Arc::clone(&offsets))) {
        return;
    }
    let base = cx.engine.current_list_base();
    without_recording(cx, |cx| cx.run_lists(name, offsets, base));
    cx.deliver(name);
}

/// What a called list does is not recorded again by the list that is open, which stays open where a callback panics.
#[track_caller]
fn without_recording(cx: &mut Context, f: impl FnOnce(&mut Context)) {
    let open = cx.recorder.open.take();
    cx.flags.set_recording(false);
    let result = catch_unwind(AssertUnwindSafe(|| f(cx)));
    cx.flags.set_recording(open.is_some());
    cx.recorder.open = open;
    if let Err(panic) = result {
        resume_unwind(panic);
    }
}

/// Adds the commands that one array element stands for.
fn element_ops(element: ArrayElement, ops: &mut Vec<Command>) {
    let ArrayElement { edge_flag, fog_coord, index, tex_coords, normal, secondary_color, color, vertex } = element;
    let mut add = |op: Option<Op>| ops.extend(op.map(Command::Vertex));
    add(edge_flag.map(|flag| Op::EdgeFlag { flag }));
    add(fog_coord.map(|coordinate| Op::FogCoord { coordinate }));
    add(index.map(|index| Op::Index { index }));
    for (unit, coordinates) in tex_coords {
        add(Some(match unit {
            0 => Op::TexCoord { coordinates },
            _ => Op::MultiTexCoord { target: GL_TEXTURE0.wrapping_add(unit), coordinates },
        }));
    }
    add(normal.map(|normal| Op::Normal { normal }));
    add(secondary_color.map(|color| Op::SecondaryColor { color }));
    add(color.map(|color| Op::Color { color }));
    add(vertex.map(|position| Op::Vertex { position }));
}

/// Adds the attributes and vertices of array elements.
fn elements_ops(cx: &mut Context, elements: impl Iterator<Item = i32>, ops: &mut Vec<Command>) -> Outcome {
    for index in elements {
        let element = cx.engine.array_element_values(index)?;
        ops.try_reserve(2 * ATTRIBUTES).map_err(|_| no_memory())?;
        element_ops(element, ops);
    }
    Ok(())
}

/// Adds a primitive of array elements as a Begin/End pair.
fn pair_ops(cx: &mut Context, mode: GLenum, elements: impl Iterator<Item = i32>, ops: &mut Vec<Command>) -> Outcome {
    ops.push(Command::Vertex(Op::glBegin { mode }));
    elements_ops(cx, elements, ops)?;
    ops.push(Command::Vertex(Op::glEnd {}));
    Ok(())
}

fn no_memory() -> GlError {
    out_of_memory("no memory left for the display list; the command is not in it")
}

/// Adds a command that is wrong to the open list: its error belongs to its execution, apart from one of memory. Returns
/// whether the command is to be carried out as well.
#[track_caller]
fn record_failed(cx: &mut Context, name: &'static str, inside: bool, error: GlError) -> bool {
    if error.code == GL_OUT_OF_MEMORY {
        return cx.fail(name, error);
    }
    cx.record(name, Command::Failed(Box::new(FailedCommand { name, inside, error })))
}

#[track_caller]
pub(crate) fn array_element(cx: &mut Context, name: &'static str, i: i32) {
    if cx.flags.recording() {
        let mut ops = Vec::new();
        let go_on = match elements_ops(cx, std::iter::once(i), &mut ops) {
            Ok(()) => ops.into_iter().fold(cx.executes(), |_, op| cx.record(name, op)),
            Err(error) => record_failed(cx, name, true, error),
        };
        if !go_on {
            return;
        }
    }
    let result = cx.engine.array_element(i);
    cx.record_result(name, result)
}

/// A draw: recorded as one command with the primitives that `pairs` adds, or carried out, or both.
#[track_caller]
fn draw(
    cx: &mut Context,
    name: &'static str,
    pairs: impl FnOnce(&mut Context, &mut Vec<Command>) -> Outcome,
    run: impl FnOnce(&mut Engine) -> Outcome,
) {
    if cx.flags.recording() {
        let mut ops = Vec::new();
        let go_on = match pairs(cx, &mut ops) {
            Ok(()) => cx.record(name, Command::Draw(Box::new(ListDraw { name, pairs: compile(ops) }))),
            Err(error) => record_failed(cx, name, false, error),
        };
        if !go_on {
            return;
        }
    }
    outside(cx, name, |cx| run(&mut cx.engine));
}

/// Adds a primitive of consecutive elements.
fn consecutive(cx: &mut Context, mode: GLenum, first: i32, count: i32, ops: &mut Vec<Command>) -> Outcome {
    cx.engine.check_draw(mode, count)?;
    let count = cx.engine.elements_there(first, count);
    let end = first.checked_add(count).filter(|_| first >= 0);
    let no_such = || invalid_value(format!("first = {first}, count = {count}: there are no such elements"));
    pair_ops(cx, mode, first..end.ok_or_else(no_such)?, ops)
}

/// Adds a primitive of the elements of an index list.
fn listed(
    cx: &mut Context,
    (mode, count): (GLenum, i32),
    type_: GLenum,
    indices: &Indices<'_>,
    ops: &mut Vec<Command>,
) -> Outcome {
    cx.engine.check_draw(mode, count)?;
    let indices = cx.engine.element_indices(count, type_, indices)?;
    pair_ops(cx, mode, indices.into_iter().map(u32::cast_signed), ops)
}

#[track_caller]
pub(crate) fn draw_arrays(cx: &mut Context, name: &'static str, mode: GLenum, first: i32, count: i32) {
    draw(cx, name, |cx, ops| consecutive(cx, mode, first, count, ops), |engine| engine.draw_arrays(mode, first, count));
}

#[track_caller]
pub(crate) fn draw_elements(
    cx: &mut Context,
    name: &'static str,
    mode: GLenum,
    count: i32,
    type_: GLenum,
    indices: &Indices<'_>,
) {
    draw(
        cx,
        name,
        |cx, ops| listed(cx, (mode, count), type_, indices, ops),
        |engine| engine.draw_elements(mode, count, type_, indices),
    );
}

#[track_caller]
#[expect(clippy::too_many_arguments, reason = "the command is GL's")]
pub(crate) fn draw_range_elements(
    cx: &mut Context,
    name: &'static str,
    mode: GLenum,
    start: u32,
    end: u32,
    count: i32,
    type_: GLenum,
    indices: &Indices<'_>,
) {
    draw(
        cx,
        name,
        |cx, ops| {
            Engine::check_range(start, end)?;
            listed(cx, (mode, count), type_, indices, ops)
        },
        |engine| engine.draw_range_elements(mode, start, end, count, type_, indices),
    );
}

#[track_caller]
pub(crate) fn multi_draw_arrays(
    cx: &mut Context,
    name: &'static str,
    mode: GLenum,
    first: &[i32],
    count: &[i32],
    drawcount: i32,
) {
    draw(
        cx,
        name,
        |cx, ops| {
            cx.engine.check_multi_draw_arrays(mode, first, count, drawcount)?;
            for (first, count) in first.iter().zip(count).filter(|(_, count)| **count > 0) {
                consecutive(cx, mode, *first, *count, ops)?;
            }
            Ok(())
        },
        |engine| engine.multi_draw_arrays(mode, first, count, drawcount),
    );
}

#[track_caller]
pub(crate) fn multi_draw_elements(
    cx: &mut Context,
    name: &'static str,
    mode: GLenum,
    count: &[i32],
    type_: GLenum,
    lists: &[Indices<'_>],
    drawcount: i32,
) {
    if cx.flags.tracing() {
        let arguments: [(&str, &dyn Show); 5] = [
            ("mode", &Enumerant(mode)),
            ("count", &count),
            ("type", &Enumerant(type_)),
            ("indices", &lists),
            ("drawcount", &drawcount),
        ];
        cx.trace(name, &arguments);
    }
    draw(
        cx,
        name,
        |cx, ops| {
            cx.engine.check_multi_draw_elements(mode, count, type_, lists, drawcount)?;
            for (count, list) in count.iter().zip(lists).filter(|(count, _)| **count > 0) {
                listed(cx, (mode, *count), type_, list, ops)?;
            }
            Ok(())
        },
        |engine| engine.multi_draw_elements(mode, count, type_, lists, drawcount),
    );
}

impl Context {
    /// The error of a command that may stand between Begin and End, now or when the open list is called.
    #[cold]
    #[track_caller]
    pub(crate) fn refuse(&mut self, name: &'static str, error: GlError) {
        if !self.flags.recording() || record_failed(self, name, true, error.clone()) {
            self.fail(name, error)
        }
    }

    /// Draws several primitives of elements by their indices (section 2.8).
    ///
    /// In C: `glMultiDrawElements`; there `drawcount` says how many lists there are.
    #[track_caller]
    pub fn multi_draw_elements(
        &mut self,
        mode: GLenum,
        count: impl super::InSlice<i32>,
        type_: GLenum,
        indices: impl IndexLists,
    ) {
        let count = count.slice();
        let drawcount = i32::try_from(count.len()).unwrap_or(i32::MAX);
        multi_draw_elements(self, "glMultiDrawElements", mode, count, type_, &indices.lists(), drawcount);
    }

    /// Selects render, selection or feedback mode and returns what the mode that ends has written: hits or values, -1 if
    /// they did not fit (sections 5.2, 5.3). Read them with [`select_values`](Self::select_values) and
    /// [`feedback_values`](Self::feedback_values).
    ///
    /// In C: `glRenderMode`.
    #[track_caller]
    pub fn render_mode(&mut self, mode: GLenum) -> i32 {
        let name = "glRenderMode";
        if self.flags.tracing() {
            self.trace(name, &[("mode", &Enumerant(mode))]);
        }
        outside(self, name, |cx| cx.engine.render_mode(mode))
    }

    /// Sets how many values feedback mode may write and which (section 5.3). The memory is the context's.
    ///
    /// In C: `glFeedbackBuffer`.
    #[track_caller]
    pub fn feedback_buffer(&mut self, size: i32, type_: GLenum) {
        self.takes_feedback_buffer(size, type_);
    }

    /// The same; says whether it was no error.
    #[track_caller]
    pub(crate) fn takes_feedback_buffer(&mut self, size: i32, type_: GLenum) -> bool {
        let name = "glFeedbackBuffer";
        if self.flags.tracing() {
            self.trace(name, &[("size", &size), ("type", &Enumerant(type_))]);
        }
        outside(self, name, |cx| cx.engine.feedback_buffer(size, type_).map(|()| true))
    }

    /// Sets how many values selection mode may write (section 5.2). The memory is the context's.
    ///
    /// In C: `glSelectBuffer`.
    #[track_caller]
    pub fn select_buffer(&mut self, size: i32) {
        self.takes_select_buffer(size);
    }

    /// The same; says whether it was no error.
    #[track_caller]
    pub(crate) fn takes_select_buffer(&mut self, size: i32) -> bool {
        let name = "glSelectBuffer";
        if self.flags.tracing() {
            self.trace(name, &[("size", &size)]);
        }
        outside(self, name, |cx| cx.engine.select_buffer(size).map(|()| true))
    }

    /// What the last feedback mode has written.
    pub fn feedback_values(&mut self) -> &[f32] {
        self.engine.feedback_values()
    }

    /// What the last selection mode has written.
    pub fn select_values(&mut self) -> &[u32] {
        self.engine.select_values()
    }

    /// Maps the buffer object that is bound to a target: its bytes, to be read and written until `unmap_buffer` (section
    /// 2.9). `None` after an error.
    ///
    /// In C: `glMapBuffer`.
    #[track_caller]
    pub fn map_buffer(&mut self, target: GLenum, access: GLenum) -> Option<&mut [u8]> {
        let name = "glMapBuffer";
        if self.flags.tracing() {
            self.trace(name, &[("target", &Enumerant(target)), ("access", &Enumerant(access))]);
        }
        if self.engine.inside_begin_end() {
            return self.refuse_inside(name);
        }
        let Self { engine, error, debug, .. } = self;
        match engine.map_buffer(target, access) {
            Ok(bytes) => Some(bytes),
            Err(failure) => super::errors::note(error, debug, name, failure),
        }
    }
}
