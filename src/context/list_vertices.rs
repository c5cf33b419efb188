//! A Begin/End pair of a display list as an array of vertices (OpenGL 1.5, sections 2.6 and 5.4). When a list is closed,
//! each long pair that holds nothing but attributes and vertices becomes a [`ListVertices`], which is drawn like arrays: no command
//! is looked at again. Afterwards the current values are those that the commands would have left. Where a command would
//! fail or has more to do, the run is taken apart into the commands again.

use super::Context;
use super::engine::Engine;
use super::recorder::Command;
use super::table::vertex::Op;
use crate::enums::*;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::simd::LANES;
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;
use crate::vertex::batch::{self, VertexBatch, needs};
use crate::vertex::source::ElementOrder;
use crate::vertex::vertex_store::VertexStore;
use crate::vertex::weld::Welded;

/// Vertices from which on a pair becomes a run; shorter ones share batches with others as they are.
const LEAST: usize = 48;
/// Bit of `given`, beside those of [`needs`]: the colour index.
const INDEX: u32 = 1 << 31;

/// A Begin/End pair.
#[derive(Clone, Debug)]
pub(crate) struct ListVertices {
    mode: PrimitiveMode,
    /// Positions and those attributes that are given within the pair.
    vertices: VertexStore,
    /// The same with every vertex once, where many are equal.
    welded: Option<Welded>,
    /// Which attributes those are.
    given: u32,
    /// The values that they have at the end.
    last: Box<Current>,
    /// Bit u: a q of unit u is not 1.
    q_units: u32,
}

/// Collects the vertices of a pair.
struct Collector {
    batch: Box<VertexBatch>,
    current: Box<Current>,
    vertices: VertexStore,
    /// Vertices that come at a time.
    each: usize,
    given: u32,
    q_units: u32,
    count: usize,
}

impl Collector {
    /// Takes a command; `None` where it is none that a run may have.
    fn take(&mut self, op: &Op) -> Option<()> {
        let current = &mut self.current;
        let bit = match *op {
            Op::Vertex { position } => {
                self.count += 1;
                self.batch.push(position, current, self.given);
                return if self.batch.n == self.each { self.store() } else { Some(()) };
            }
            Op::Color { color } => {
                current.color = color;
                needs::COLOR
            }
            Op::SecondaryColor { color } => {
                current.secondary_color = color;
                needs::SECONDARY
            }
            Op::Normal { normal } => {
                current.normal = normal;
                needs::NORMAL
            }
            Op::FogCoord { coordinate } => {
                current.fog_coord = coordinate;
                needs::FOG
            }
            Op::Index { index } => {
                current.index = index;
                INDEX
            }
            Op::TexCoord { coordinates } => self.tex_coord(0, coordinates)?,
            Op::MultiTexCoord { target, coordinates } => {
                self.tex_coord(target.wrapping_sub(GL_TEXTURE0) as usize, coordinates)?
            }
            _ => return None,
        };
        // An attribute that comes later than the first vertex has the value of the time of the call for some vertices.
        if self.given & bit == 0 && self.count > 0 {
            return None;
        }
        self.given |= bit;
        Some(())
    }

    fn tex_coord(&mut self, unit: usize, coordinates: [f32; 4]) -> Option<u32> {
        *self.current.tex_coord.get_mut(unit)? = coordinates;
        if coordinates[3] != 1.0 {
            self.q_units |= 1 << unit;
        }
        Some(needs::TEX << unit)
    }

    fn store(&mut self) -> Option<()> {
        if self.vertices.is_empty() {
            self.vertices.clear(self.given & !INDEX, self.each);
        }
        let stored = self.vertices.push(&mut self.batch);
        self.batch.clear();
        stored.then_some(())
    }
}

impl ListVertices {
    /// The pair that a list goes on with, and how many commands it has.
    fn new(commands: &[Command], collector: impl FnOnce() -> Collector) -> Option<(Self, usize)> {
        let (Command::Vertex(Op::glBegin { mode }), rest) = commands.split_first()? else { return None };
        let inside = |c: &Command| matches!(c, Command::Vertex(op) if !matches!(op, Op::glBegin { .. } | Op::glEnd {}));
        let inner = rest.iter().position(|c| !inside(c))?;
        let mode = PrimitiveMode::from_gl(*mode)?;
        if inner < LEAST || !matches!(rest.get(inner)?, Command::Vertex(Op::glEnd {})) {
            return None;
        }
        let mut c = collector();
        c.each = batch::block(mode);
        for command in rest.iter().take(inner) {
            let Command::Vertex(op) = command else { return None };
            c.take(op)?;
        }
        if c.count < LEAST || u32::try_from(c.count).is_err() {
            return None;
        }
        if c.batch.n > 0 {
            c.store()?;
        }
        let Collector { vertices, current: last, given, q_units, .. } = c;
        let welded =
            matches!(mode, PrimitiveMode::Triangles | PrimitiveMode::Quads).then(|| Welded::new(&vertices)).flatten();
        Some((Self { mode, vertices, welded, given, last, q_units }, inner + 2))
    }

    /// Turns long pairs of a list into runs.
    pub(crate) fn compile(commands: Vec<Command>) -> Vec<Command> {
        if !commands.iter().any(|c| matches!(c, Command::Vertex(Op::glBegin { .. }))) {
            return commands;
        }
        let collector = || Collector {
            batch: VertexBatch::new(),
            current: Box::default(),
            vertices: VertexStore::default(),
            each: LANES,
            given: 0,
            q_units: 0,
            count: 0,
        };
        let (mut compiled, mut at, mut skip) = (Vec::new(), 0, 0);
        let runs = (0..commands.len()).filter_map(|i| {
            if i < skip {
                return None;
            }
            let (run, len) = ListVertices::new(commands.get(i..)?, collector)?;
            skip = i + len;
            Some((i, run, len))
        });
        let runs: Vec<_> = runs.collect();
        let mut commands = commands.into_iter();
        for (start, run, len) in runs {
            compiled.extend(commands.by_ref().take(start - at));
            compiled.push(Command::VertexArray(Box::new(run)));
            commands.by_ref().take(len).for_each(drop);
            at = start + len;
        }
        compiled.extend(commands);
        compiled
    }

    /// Carries the pair out.
    #[track_caller]
    pub(crate) fn run(&self, cx: &mut Context) {
        let engine = &mut cx.engine;
        if engine.inside_begin_end() || self.q_units & !engine.q_units != 0 {
            return self.commands(|op| op.run(cx));
        }
        engine.draw_list_vertices(self);
    }

    /// The commands that the pair was made of, in an order that means the same.
    #[track_caller]
    fn commands(&self, mut each: impl FnMut(Op)) {
        let given = |bit: u32| self.given & bit != 0;
        each(Op::glBegin { mode: self.mode.gl() });
        let mut batch = VertexBatch::new();
        for block in 0..self.vertices.blocks() {
            self.vertices.load(block, &mut batch);
            for i in 0..batch.n {
                self.attributes(&batch.current(i), &mut each);
                each(Op::Vertex { position: batch.position.map(|lanes| lanes[i]) });
            }
        }
        self.attributes(&self.last, &mut each);
        if given(INDEX) {
            each(Op::Index { index: self.last.index });
        }
        each(Op::glEnd {});
    }

    /// The commands that set the attributes that are given, but for the colour index.
    #[track_caller]
    fn attributes(&self, values: &Current, each: &mut impl FnMut(Op)) {
        let given = |bit: u32| self.given & bit != 0;
        if given(needs::COLOR) {
            each(Op::Color { color: values.color });
        }
        if given(needs::SECONDARY) {
            each(Op::SecondaryColor { color: values.secondary_color });
        }
        if given(needs::NORMAL) {
            each(Op::Normal { normal: values.normal });
        }
        if given(needs::FOG) {
            each(Op::FogCoord { coordinate: values.fog_coord });
        }
        for (unit, coordinates) in (0..MAX_TEXTURE_UNITS).zip(values.tex_coord) {
            if given(needs::TEX << unit) {
                each(Op::MultiTexCoord { target: GL_TEXTURE0 + unit as u32, coordinates });
            }
        }
    }
}

impl Engine {
    /// Draws a run outside of Begin and End, and leaves the current values that it leaves.
    fn draw_list_vertices(&mut self, run: &ListVertices) {
        self.validate();
        self.run_vertices();
        self.pipe.worker.processor.batch.splat(&self.state.current, self.pipe.plan.needs);
        match &run.welded {
            Some(welded) => self.draw_source(&welded.store, run.mode, ElementOrder::List(welded.list())),
            None => self.draw_source(&run.vertices, run.mode, run.vertices.order()),
        }
        run.attributes(&run.last, &mut |op| self.set_current(&op));
        if run.given & INDEX != 0 {
            self.index(run.last.index);
        }
    }

    /// Sets the current value of an attribute.
    fn set_current(&mut self, op: &Op) {
        match *op {
            Op::Color { color } => self.color(color),
            Op::SecondaryColor { color } => self.secondary_color(color),
            Op::Normal { normal } => self.normal(normal),
            Op::FogCoord { coordinate } => self.fog_coord(coordinate),
            Op::MultiTexCoord { target, coordinates } => _ = self.multi_tex_coord(target, coordinates),
            _ => {}
        }
    }
}
