//! The commands that the context carries out itself: lists, draws that a list turns into vertices, the error flag, and
//! the few whose C form keeps a pointer (OpenGL 1.5, sections 2.5, 2.8, 2.9, 5.2 to 5.4). The rows of the table that
//! stand in the section `context` call the functions here; those in `manual` are the methods at the end.

use super::draw_arrays::ArrayElement;
use super::recorder::Command;
use super::table::ops::vertex::Op;
use super::{Context, IndexLists, Indices, Pixels, Values};
use crate::enums::*;
use crate::error::{Outcome, invalid_value};

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
    without_recording(cx, |cx| cx.run_lists(name, Box::new([list])));
    cx.deliver(name);
}

#[track_caller]
pub(crate) fn call_lists(cx: &mut Context, name: &'static str, n: i32, type_: GLenum, lists: &Pixels<'_>) {
    let offsets = match super::lists::offsets(n, type_, lists.bytes().unwrap_or_default()) {
        Ok(offsets) => offsets,
        Err(error) => return cx.fail(name, error),
    };
    if cx.flags.recording() && !cx.record(name, Command::Calls(offsets.clone())) {
        return;
    }
    let base = cx.engine.current_list_base();
    let names = offsets.iter().map(|o| base.wrapping_add(*o)).collect();
    without_recording(cx, |cx| cx.run_lists(name, names));
    cx.deliver(name);
}

/// What a called list does is not recorded again by the list that is open.
#[track_caller]
fn without_recording(cx: &mut Context, f: impl FnOnce(&mut Context)) {
    let open = cx.recorder.open.take();
    cx.flags.set_recording(false);
    f(cx);
    cx.flags.set_recording(open.is_some());
    cx.recorder.open = open;
}

/// Adds the commands that one array element stands for.
fn element_ops(element: ArrayElement, ops: &mut Vec<Op>) {
    let ArrayElement { edge_flag, fog_coord, index, tex_coords, normal, secondary_color, color, vertex } = element;
    ops.extend(edge_flag.map(|flag| Op::EdgeFlag { flag }));
    ops.extend(fog_coord.map(|coordinate| Op::FogCoord { coordinate }));
    ops.extend(index.map(|index| Op::Index { index }));
    ops.extend(tex_coords.into_iter().map(|(unit, coordinates)| match unit {
        0 => Op::TexCoord { coordinates },
        _ => Op::MultiTexCoord { target: GL_TEXTURE0.wrapping_add(unit), coordinates },
    }));
    ops.extend(normal.map(|normal| Op::Normal { normal }));
    ops.extend(secondary_color.map(|color| Op::SecondaryColor { color }));
    ops.extend(color.map(|color| Op::Color { color }));
    ops.extend(vertex.map(|position| Op::Vertex { position }));
}

/// Records array elements as the vertices they stand for. Returns whether the command is to be carried out as well.
#[track_caller]
fn record_elements(
    cx: &mut Context,
    name: &'static str,
    mode: Option<GLenum>,
    elements: impl Iterator<Item = i32>,
) -> bool {
    let mut ops = Vec::new();
    ops.extend(mode.map(|mode| Op::glBegin { mode }));
    for index in elements {
        match cx.engine.array_element_values(index) {
            Ok(element) if ops.try_reserve(16).is_ok() => element_ops(element, &mut ops),
            Ok(_) => return cx.fail(name, crate::error::out_of_memory("no memory left for the display list")),
            Err(error) => return cx.fail(name, error),
        }
    }
    ops.extend(mode.map(|_| Op::glEnd {}));
    ops.into_iter().fold(true, |_, op| cx.record(name, op))
}

#[track_caller]
pub(crate) fn array_element(cx: &mut Context, name: &'static str, i: i32) {
    if cx.flags.recording() && !record_elements(cx, name, None, std::iter::once(i)) {
        return;
    }
    let result = cx.engine.array_element(i);
    cx.record_result(name, result)
}

/// A draw: recorded as its vertices, or carried out. `indices` yields the elements for the record.
#[track_caller]
fn draw(
    cx: &mut Context,
    name: &'static str,
    (mode, count): (GLenum, i32),
    indices: impl FnOnce(&mut Context) -> Outcome<Vec<i32>>,
    run: impl FnOnce(&mut Context) -> Outcome,
) {
    if cx.flags.recording() {
        let elements = cx.engine.check_draw(mode, count).and_then(|_| indices(cx));
        match elements {
            Ok(elements) => {
                if !record_elements(cx, name, Some(mode), elements.into_iter()) {
                    return;
                }
            }
            Err(error) => return cx.fail(name, error),
        }
    }
    outside(cx, name, run);
}

/// Consecutive elements.
fn consecutive(first: i32, count: i32) -> Outcome<Vec<i32>> {
    if first < 0 || first.checked_add(count).is_none() {
        return Err(invalid_value(format!("first = {first}, count = {count}: there are no such elements")));
    }
    let mut all = Vec::new();
    all.try_reserve_exact(super::param_counts::count(count))
        .map_err(|_| crate::error::out_of_memory("no memory left for the display list"))?;
    all.extend(first..first + count.max(0));
    Ok(all)
}

#[track_caller]
pub(crate) fn draw_arrays(cx: &mut Context, name: &'static str, mode: GLenum, first: i32, count: i32) {
    draw(
        cx,
        name,
        (mode, count),
        |cx| consecutive(first, cx.engine.elements_there(first, count)),
        |cx| outcome(cx.engine.draw_arrays(mode, first, count)),
    );
}

/// The elements of an index list, for a record.
fn listed(cx: &mut Context, count: i32, type_: GLenum, indices: &Indices<'_>) -> Outcome<Vec<i32>> {
    let indices = cx.engine.element_indices(count, type_, indices)?;
    Ok(indices.into_iter().map(|i| i as i32).collect())
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
        (mode, count),
        |cx| listed(cx, count, type_, indices),
        |cx| outcome(cx.engine.draw_elements(mode, count, type_, indices)),
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
    if end < start {
        return cx.fail(name, invalid_value(format!("end = {end} lies before start = {start}")));
    }
    draw(
        cx,
        name,
        (mode, count),
        |cx| listed(cx, count, type_, indices),
        |cx| outcome(cx.engine.draw_range_elements(mode, start, end, count, type_, indices)),
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
    if drawcount < 0 {
        return cx.fail(name, invalid_value(format!("drawcount = {drawcount} is negative")));
    }
    for (first, count) in first.iter().zip(count) {
        draw_arrays(cx, name, mode, *first, *count);
    }
}

/// The result of an engine method in whatever shape it comes.
fn outcome<R: super::errors::IntoOutcome>(result: R) -> Outcome<R::Value> {
    result.outcome()
}

impl Context {
    /// Draws several primitives of elements by their indices (section 2.8).
    ///
    /// In C: `glMultiDrawElements`; there `drawcount` says how many lists there are.
    #[track_caller]
    pub fn multi_draw_elements(
        &mut self,
        mode: GLenum,
        count: &(impl super::InSlice<i32> + ?Sized),
        type_: GLenum,
        indices: &(impl IndexLists + ?Sized),
    ) {
        let name = "glMultiDrawElements";
        let lists = indices.lists();
        if self.flags.tracing() {
            self.trace(
                name,
                &[("count", &count.slice()), ("type", &super::show::Enumerant(type_)), ("indices", &lists)],
            );
        }
        for (count, indices) in count.slice().iter().zip(&lists) {
            let needed = super::param_counts::indices(*count, type_);
            match indices {
                Indices::Bytes(bytes) if bytes.len() < needed => {
                    return self.short(name, "indices", needed, bytes.len(), "bytes");
                }
                _ => draw_elements(self, name, mode, *count, type_, indices),
            }
        }
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
            self.trace(name, &[("mode", &super::show::Enumerant(mode))]);
        }
        outside(self, name, |cx| cx.engine.render_mode(mode))
    }

    /// Sets how many values feedback mode may write and which (section 5.3). The memory is the context's.
    ///
    /// In C: `glFeedbackBuffer`.
    #[track_caller]
    pub fn feedback_buffer(&mut self, size: i32, type_: GLenum) {
        let name = "glFeedbackBuffer";
        if self.flags.tracing() {
            self.trace(name, &[("size", &size), ("type", &super::show::Enumerant(type_))]);
        }
        outside(self, name, |cx| cx.engine.feedback_buffer(size, type_))
    }

    /// Sets how many values selection mode may write (section 5.2). The memory is the context's.
    ///
    /// In C: `glSelectBuffer`.
    #[track_caller]
    pub fn select_buffer(&mut self, size: i32) {
        let name = "glSelectBuffer";
        if self.flags.tracing() {
            self.trace(name, &[("size", &size)]);
        }
        outside(self, name, |cx| cx.engine.select_buffer(size))
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
            self.trace(
                name,
                &[("target", &super::show::Enumerant(target)), ("access", &super::show::Enumerant(access))],
            );
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
