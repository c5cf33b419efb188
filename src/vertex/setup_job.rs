//! A piece of a long Begin/End that another thread is to set up: vertices as they were given, and all that is needed to make
//! primitives of them.

use super::draw_worker::{DrawWorker, SourceDraw};
use super::plan::VertexPlan;
use super::vertex_store::VertexStore;
use crate::raster::{FragmentProgram, PrimitiveBuilder, SetupFn};
use crate::simd::{LANES, Level};
use crate::state::primitive::PrimitiveMode;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A piece.
#[derive(Clone, Debug)]
pub struct SetupJob {
    plan: VertexPlan,
    mode: PrimitiveMode,
    cut: usize,
    store: VertexStore,
    /// What the thread works with.
    pub worker: DrawWorker,
}

/// Free list of jobs.
#[derive(Clone, Debug, Default)]
pub struct SetupJobPool(Arc<Mutex<Vec<SetupJob>>>);

impl SetupJobPool {
    /// The pieces that lie there.
    pub fn idle(&self) -> MutexGuard<'_, Vec<SetupJob>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a piece of whole primitives: `store` is swapped for an empty one.
    #[must_use]
    pub fn make<P: FragmentProgram>(
        &self,
        plan: &VertexPlan,
        mode: PrimitiveMode,
        cut: usize,
        store: &mut VertexStore,
    ) -> SetupFn<P> {
        let new = || {
            let plan = VertexPlan::new(Level::Baseline);
            SetupJob { plan, mode, cut, store: VertexStore::default(), worker: DrawWorker::default() }
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

impl SetupJob {
    fn set_up<P: FragmentProgram>(&mut self, to: &mut PrimitiveBuilder<'_, P>) {
        let Self { plan, mode, cut, store, worker } = self;
        worker.processor.pool.reset(plan);
        let draw = SourceDraw { plan, source: store, mode: *mode, cut: *cut };
        worker.draw(&draw, store.order(), to, |_| {});
    }
}
