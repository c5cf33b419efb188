//! From a source of vertices to the scene (OpenGL 1.5, section 2.8): what DrawArrays, DrawElements, long Begin/End pairs and
//! display lists have in common. A draw that is worth it is cut into parts for several threads.

use super::engine::Engine;
use crate::enums::GLenum;
use crate::fragment::program::Program;
use crate::framebuffer::Framebuffer;
use crate::raster::Scene;
use crate::vertex::cache::IndexList;
use crate::vertex::draw_worker::{Lane, Parts, SourceDraw};
use crate::vertex::pipeline::Pipe;
use crate::vertex::{Order, Source};

/// The parts of the engine that a draw works with; the rest may be where its vertices are.
pub(crate) struct Drawing<'a> {
    pub(crate) pipe: &'a mut Pipe,
    /// The lanes of the second thread and those after it.
    pub(crate) lanes: &'a mut Vec<Lane>,
    pub(crate) scene: &'a mut Scene<Program>,
    pub(crate) framebuffer: &'a mut Framebuffer,
    pub(crate) threads: usize,
    /// Counts fragments that have passed.
    pub(crate) passed: &'a mut u64,
}

impl Drawing<'_> {
    /// Draws a primitive. What its vertices have in common must be in the pipe's batch already.
    pub(crate) fn draw<S: Source>(self, source: &S, mode: GLenum, order: Order<IndexList<'_>>) {
        let Self { pipe, lanes, scene, framebuffer, threads, passed } = self;
        let cut = pipe.cut();
        let Pipe { plan, lane, .. } = pipe;
        let draw = SourceDraw { plan, source, mode, cut };
        let threads = if scene.can_be_cut() { threads } else { 1 };
        match Parts::new(draw, order, threads) {
            Ok(parts) => {
                lanes.resize_with(threads, Lane::default);
                for other in lanes.iter_mut() {
                    other.prepare(plan, lane);
                }
                *passed += scene.draw_pieces(framebuffer, &parts, lanes);
            }
            Err((draw, order)) => lane.draw(&draw, order, scene, |scene| {
                if scene.is_full() {
                    *passed += scene.make_room(framebuffer, threads);
                }
            }),
        }
    }
}

impl Engine {
    /// Draws vertices that are the engine's own. What they have in common must be in the pipe's batch already.
    pub(super) fn draw_source<S: Source>(&mut self, source: &S, mode: GLenum, order: Order<IndexList<'_>>) {
        let Self { pipe, lanes, scene, framebuffer, config, queries, .. } = self;
        let (threads, passed) = (config.threads, &mut queries.passed);
        Drawing { pipe, lanes, scene, framebuffer, threads, passed }.draw(source, mode, order);
    }
}
