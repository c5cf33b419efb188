//! From a source of vertices to the scene (OpenGL 1.5, section 2.8): what DrawArrays, DrawElements, long Begin/End pairs and
//! display lists have in common. A draw that is worth it is cut into parts for several threads.

use super::engine::Engine;
use super::render_records::RenderModes;
use crate::fragment::program::Program;
use crate::framebuffer::Framebuffer;
use crate::raster::Scene;
use crate::state::primitive::PrimitiveMode;
use crate::vertex::cache::IndexList;
use crate::vertex::draw_worker::{DrawWorker, SourceDraw, SplitSourceDraw};
use crate::vertex::pipeline::VertexPipeline;
use crate::vertex::source::{ElementOrder, VertexSource};

/// The parts of the engine that a draw works with; the rest may be where its vertices are.
pub(crate) struct Drawing<'a> {
    pub(crate) render_modes: &'a mut RenderModes,
    pub(crate) pipe: &'a mut VertexPipeline,
    /// The draw_workers of the second thread and those after it.
    pub(crate) draw_workers: &'a mut Vec<DrawWorker>,
    pub(crate) scene: &'a mut Scene<Program>,
    pub(crate) framebuffer: &'a mut Framebuffer,
    pub(crate) threads: usize,
    /// Counts fragments that have passed.
    pub(crate) passed: &'a mut u64,
}

impl Drawing<'_> {
    /// Draws a primitive. What its vertices have in common must be in the pipe's batch already.
    pub(crate) fn draw<S: VertexSource>(self, source: &S, mode: PrimitiveMode, order: ElementOrder<IndexList<'_>>) {
        let Self { render_modes, pipe, draw_workers, scene, framebuffer, threads, passed } = self;
        let cut = pipe.cut();
        let VertexPipeline { plan, worker, .. } = pipe;
        let draw = SourceDraw { plan, source, mode, cut };
        if let Some(mut capture) = render_modes.capture() {
            return worker.draw(&draw, order, &mut capture, |_| {});
        }
        let threads = if scene.can_be_split() { threads } else { 1 };
        match SplitSourceDraw::new(draw, order, threads) {
            Ok(parts) => {
                draw_workers.resize_with(threads, DrawWorker::default);
                for other in draw_workers.iter_mut() {
                    other.prepare(plan, worker);
                }
                *passed += scene.draw_split(framebuffer, &parts, draw_workers);
            }
            Err((draw, order)) => worker.draw(&draw, order, scene, |scene| {
                if scene.is_full() {
                    *passed += scene.make_room(framebuffer, threads);
                }
            }),
        }
    }
}

impl Engine {
    /// Draws vertices that are the engine's own. What they have in common must be in the pipe's batch already.
    pub(super) fn draw_source<S: VertexSource>(
        &mut self,
        source: &S,
        mode: PrimitiveMode,
        order: ElementOrder<IndexList<'_>>,
    ) {
        let Self { render_modes, pipe, draw_workers, scene, framebuffer, config, queries, .. } = self;
        let (threads, passed) = (config.threads, &mut queries.passed);
        Drawing { render_modes, pipe, draw_workers, scene, framebuffer, threads, passed }.draw(source, mode, order);
    }
}
