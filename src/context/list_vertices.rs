//! A Begin/End pair of a display list as an array of vertices (OpenGL 1.5, sections 2.6 and 5.4), which is drawn like
//! arrays: no command is looked at again. Afterwards the current values are those that the commands would have left. Where
//! a command would fail or has more to do, the pair is taken apart into the commands again. `list_compile` makes it.

use super::engine::Engine;
use super::table::ops::vertex::Op;
use crate::enums::GL_TEXTURE0;
use crate::limits::MAX_TEXTURE_UNITS;
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;
use crate::vertex::batch::{VertexBatch, needs};
use crate::vertex::source::ElementOrder;
use crate::vertex::vertex_store::VertexStore;
use crate::vertex::weld::Welded;

/// Bit of `given`, beside those of [`needs`]: the colour index.
pub(super) const INDEX: u32 = 1 << 31;

/// A Begin/End pair.
#[derive(Clone, Debug)]
pub(crate) struct ListVertices {
    pub(super) mode: PrimitiveMode,
    /// Positions and those attributes that are given within the pair.
    pub(super) vertices: VertexStore,
    /// The same with every vertex once, where many are equal.
    pub(super) welded: Option<Welded>,
    /// Which attributes those are.
    pub(super) given: u32,
    /// The values that they have at the end.
    pub(super) last: Box<Current>,
    /// Bit u: a q of unit u is not 1.
    pub(super) q_units: u32,
}

impl ListVertices {
    /// How many vertices there are.
    pub(super) fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The commands that the pair was made of, in an order that means the same.
    #[track_caller]
    pub(super) fn commands(&self, mut each: impl FnMut(Op)) {
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
    pub(super) fn draw_list_vertices(&mut self, run: &ListVertices) {
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
