//! Tests of the vertex pipe: hand-computed values, topology of the ten primitives, clipping, and the same bits at every
//! level and batch cut.

mod clipping;
mod fuzz;
mod lit;
mod primitives;
mod textured;

use super::hand_on::TakePrimitives;
use super::pipeline::VertexPipeline;
use super::plan::Wants;
use crate::fragment::planes::{Layout, UnitSlots};
use crate::raster::PrimitiveSink;
use crate::raster::vertex::{Vertex, VertexRef};
use crate::simd::Level;
use crate::state::State;
use crate::state::current::Current;
use crate::state::primitive::PrimitiveMode;

/// A primitive as it came out.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Got {
    Triangle(Vec<(Vertex, Vec<f32>)>, usize, [bool; 3]),
    Line(Vec<(Vertex, Vec<f32>)>, usize, bool),
    Point((Vertex, Vec<f32>)),
}

/// Collects primitives; and whether the stipple starts anew with the next line.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Collect(pub Vec<Got>, pub bool);

fn owned(v: VertexRef<'_>) -> (Vertex, Vec<f32>) {
    (*v.head, v.slots.to_vec())
}

impl PrimitiveSink for Collect {
    fn triangle(&mut self, corners: [VertexRef<'_>; 3], provoking: usize, edges: [bool; 3]) {
        self.0.push(Got::Triangle(corners.map(owned).to_vec(), provoking, edges));
    }
    fn line(&mut self, ends: [VertexRef<'_>; 2], provoking: usize) {
        let restart = std::mem::take(&mut self.1);
        self.0.push(Got::Line(ends.map(owned).to_vec(), provoking, restart));
    }
    fn restart_stipple(&mut self) {
        self.1 = true;
    }
    fn point(&mut self, vertex: VertexRef<'_>) {
        self.0.push(Got::Point(owned(vertex)));
    }
}

impl TakePrimitives for Collect {}

/// A vertex with its attributes.
#[derive(Clone, Debug)]
pub(super) struct Given {
    pub position: [f32; 4],
    pub current: Current,
}

pub(super) fn at(x: f32, y: f32, z: f32) -> Given {
    Given { position: [x, y, z, 1.0], current: Current::default() }
}

/// A 100x100 viewport and otherwise the initial state.
pub(super) fn plain_state() -> State {
    let mut state = State::default();
    state.viewport.width = 100;
    state.viewport.height = 100;
    state
}

/// A layout with a colour.
pub(super) fn color_layout() -> Layout {
    Layout { color: Some(0), count: 4, stride: 4, ..Layout::default() }
}

/// A layout with the coordinates s, t, r, q of unit 0.
pub(super) fn tex_layout() -> Layout {
    let mut layout = Layout { count: 4, stride: 4, ..Layout::default() };
    layout.units[0] =
        Some(UnitSlots { base: 0, count: 3, has_q: true, period: [0; 3], size: [64, 64, 1], cube: false });
    layout
}

pub(super) fn run(
    level: Level,
    cut: usize,
    state: &State,
    layout: &Layout,
    mode: PrimitiveMode,
    given: &[Given],
) -> Vec<Got> {
    let mut pipe = VertexPipeline::new(level, cut);
    pipe.rebuild(state, layout, Wants { edges: true, ..Wants::default() });
    let mut out = Collect::default();
    pipe.begin(mode);
    for v in given {
        if pipe.vertex(v.position, &v.current) {
            pipe.run(&mut out);
        }
    }
    pipe.end();
    pipe.run(&mut out);
    out.0
}

/// Runs at every level and several batch cuts, which must agree, and gives the result.
pub(super) fn draw(state: &State, layout: &Layout, mode: PrimitiveMode, given: &[Given]) -> Vec<Got> {
    let want = run(Level::BASELINE, 64, state, layout, mode, given);
    for level in Level::available() {
        for cut in [64, 37, 16, 5, 3, 2, 1] {
            let got = run(level, cut, state, layout, mode, given);
            assert!(got == want, "{level:?} and cut {cut} give something else:\n{got:?}\n{want:?}");
        }
    }
    want
}
