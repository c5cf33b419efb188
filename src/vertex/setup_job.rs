//! A part of a long Begin/End that the raster thread sets up: vertices with their attributes, and all that is needed to make
//! primitives of them.

use super::draw_worker::{DrawWorker, SourceDraw};
use super::plan::VertexPlan;
use super::vertex_store::VertexStore;
use crate::raster::{FragmentProgram, PrimitiveBuilder, SetupFn};
use crate::simd::{LANES, Level};
use crate::state::primitive::PrimitiveMode;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Vertices to be set up, and what a thread needs for it.
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
    /// The free jobs.
    pub fn idle(&self) -> MutexGuard<'_, Vec<SetupJob>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a job of the whole primitives in `store`, which is swapped for an empty one.
    #[must_use]
    pub fn make<P: FragmentProgram>(
        &self,
        plan: &VertexPlan,
        mode: PrimitiveMode,
        cut: usize,
        store: &mut VertexStore,
    ) -> SetupFn<P> {
        let new = || {
            let plan = VertexPlan::new(Level::BASELINE);
            SetupJob { plan, mode, cut, store: VertexStore::default(), worker: DrawWorker::default() }
        };
        let mut job = self.idle().pop().unwrap_or_else(new);
        job.plan.clone_from(plan);
        (job.mode, job.cut) = (mode, cut);
        std::mem::swap(&mut job.store, store);
        store.clear(0, LANES);
        let idle = self.clone();
        Box::new(move |to| {
            job.set_up(to);
            idle.idle().push(job);
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
