//! What happens to the commands of a display list when it is closed (OpenGL 1.5, section 5.4): each long Begin/End pair
//! that holds nothing but attributes and vertices becomes a [`ListVertices`].

use super::list_vertices::{INDEX, ListVertices};
use super::recorder::Command;
use super::table::ops::vertex::Op;
use crate::enums::GL_TEXTURE0;
use crate::simd::LANES;
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;
use crate::vertex::batch::{self, VertexBatch, needs};
use crate::vertex::vertex_store::VertexStore;
use crate::vertex::weld::Welded;

/// Vertices from which on a pair becomes a run; shorter ones share batches with others as they are.
const LEAST: usize = 48;

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

/// The pair that a list goes on with, and how many commands it has.
fn pair(commands: &[Command], collector: impl FnOnce() -> Collector) -> Option<(ListVertices, usize)> {
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
    Some((ListVertices { mode, vertices, welded, given, last, q_units }, inner + 2))
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
    let (mut at, mut skip) = (0, 0);
    let runs = (0..commands.len()).filter_map(|i| {
        if i < skip {
            return None;
        }
        let (run, len) = pair(commands.get(i..)?, collector)?;
        skip = i + len;
        Some((i, run, len))
    });
    let runs: Vec<_> = runs.collect();
    let taken: usize = runs.iter().map(|(_, _, len)| len - 1).sum();
    let mut compiled = Vec::new();
    if runs.is_empty() || compiled.try_reserve_exact(commands.len() - taken).is_err() {
        return commands;
    }
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
