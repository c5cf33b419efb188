//! A piece of a long Begin/End that another thread is to set up: vertices as they were given, and all that is needed to make
//! primitives of them.

use super::draw_worker::{Lane, SourceDraw};
use super::plan::VertexPlan;
use super::vertex_store::Store;
use crate::enums::GLenum;
use crate::raster::{Builder, SetUp, Shader};
use crate::simd::{LANES, Level};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A piece.
#[derive(Clone, Debug)]
pub struct Piece {
    plan: VertexPlan,
    mode: GLenum,
    cut: usize,
    store: Store,
    /// What the thread works with.
    pub lane: Lane,
}

/// Pieces that nobody works on.
#[derive(Clone, Debug, Default)]
pub struct Pieces(Arc<Mutex<Vec<Piece>>>);

impl Pieces {
    /// The pieces that lie there.
    pub fn idle(&self) -> MutexGuard<'_, Vec<Piece>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a piece of whole primitives: `store` is swapped for an empty one.
    #[must_use]
    pub fn make<P: Shader>(&self, plan: &VertexPlan, mode: GLenum, cut: usize, store: &mut Store) -> SetUp<P> {
        let new = || {
            let plan = VertexPlan::new(Level::Baseline);
            Piece { plan, mode, cut, store: Store::default(), lane: Lane::default() }
        };
        let mut piece = self.idle().pop().unwrap_or_else(new);
        piece.plan.clone_from(plan);
        (piece.mode, piece.cut) = (mode, cut);
        std::mem::swap(&mut piece.store, store);
        store.clear(0, LANES);
        let idle = self.clone();
        Box::new(move |to| {
            piece.set_up(to);
            idle.idle().push(piece);
        })
    }
}

impl Piece {
    fn set_up<P: Shader>(&mut self, to: &mut Builder<'_, P>) {
        let Self { plan, mode, cut, store, lane } = self;
        lane.chunk.pool.reset(plan);
        let draw = SourceDraw { plan, source: store, mode: *mode, cut: *cut };
        lane.draw(&draw, store.order(), to, |_| {});
    }
}
