//! The engine: everything that GL does, without the doors (OpenGL 1.5, figure 2.1). It owns the state, the objects, the
//! framebuffer and the two ends of the pipeline. Its commands are spread over the files of this room, a chapter a file,
//! none of which this file uses: it only says what there is.

use super::array_pointers::Arrays;
use super::attribute_stack::AttributeStack;
use super::buffer_objects::Buffers;
use super::config::Config;
use super::imaging_tables::ImagingTables;
use super::proxies::{Proxies, Proxy};
use super::query_objects::Queries;
use super::render_records::RenderModes;
use super::texture_objects::Textures;
use super::vertex_array_objects::VertexArrays;
use super::whole_vertex::RasterPosProcessor;
use crate::error::{Outcome, out_of_memory};
use crate::fragment::program::Program;
use crate::framebuffer::Framebuffer;
use crate::limits::MAX_TEXTURE_LEVELS;
use crate::raster::Scene;
use crate::simd::Tally;
use crate::state::pixel::PixelStores;
use crate::state::{Dirty, State};
use crate::vertex::draw_worker::DrawWorker;
use crate::vertex::pipeline::VertexPipeline;
use crate::vertex::setup_job::SetupJobPool;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Client state: what `glPushClientAttrib` keeps (section 6.1.14).
#[derive(Clone, Debug, Default)]
pub(crate) struct Client {
    pub(crate) pixel_store: PixelStores,
    pub(crate) arrays: Arrays,
}

/// Whether the engine is between Begin and End.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Primitive {
    /// It is not.
    #[default]
    Outside,
    /// It is.
    Inside,
    /// It is, and something has changed since the last vertex that the plans must know before the next.
    Stale,
}

/// The state machine and the pipeline.
#[derive(Debug)]
pub(crate) struct Engine {
    /// Server state, group by group.
    pub(crate) state: State,
    /// What has changed since plans were built.
    pub(crate) dirty: Dirty,
    /// How the engine runs.
    pub(crate) config: Config,
    /// Client state.
    pub(crate) client: Client,
    /// The attribute stack.
    pub(crate) attributes: AttributeStack,
    /// The client attribute stack: what was saved, and which of it counts.
    pub(crate) client_attributes: Vec<(u32, Client)>,
    /// Texture objects.
    pub(crate) textures: Textures,
    /// What the proxy targets answer.
    pub(crate) proxies: Box<Proxies>,
    /// Buffer objects.
    pub(crate) buffers: Buffers,
    /// Vertex array objects.
    pub(crate) vertex_arrays: VertexArrays,
    /// Whether a Begin has no End yet.
    pub(crate) primitive: Primitive,
    /// Full batches since the last Begin.
    pub(crate) batches: usize,
    /// What RasterPos works with, once it has been called.
    pub(crate) raster_pos: Option<Box<RasterPosProcessor>>,
    /// Vertices on their way to primitives.
    pub(crate) pipe: VertexPipeline,
    /// What threads beside this one need for large draws.
    pub(crate) draw_workers: Vec<DrawWorker>,
    /// Free list of setup jobs: what another thread needs to set up a part of a long Begin/End.
    pub(crate) setup_jobs: SetupJobPool,
    /// Draws that wait for a flush.
    pub(crate) scene: Scene<Program>,
    /// The fragment program of the present state.
    pub(crate) program: Option<Arc<Program>>,
    /// Whether the scene has a draw of the present state.
    pub(crate) drawing: bool,
    /// Whether the framebuffer has been drawn into, or will be, since somebody has looked at it.
    pub(crate) unseen: bool,
    /// Bit u: some vertex has given unit u a q that is not 1. Set for good by the first one, so that programs that never
    /// use q never pay for it.
    pub(crate) q_units: u32,
    /// Advice that the debug callback has not had yet, and all that was given.
    pub(crate) notes: Vec<String>,
    pub(crate) told: BTreeSet<String>,
    /// Whether somebody hears advice: what costs something to find out is looked for only then.
    pub(crate) advised: bool,
    /// Texels and pixels that commands have written without drawing; what a display list may lead to is limited by them.
    pub(crate) pixels_written: u64,
    /// Where what is done is counted, if somebody wants to know.
    pub(crate) tally: Option<Tally>,
    /// Tables and filters of the imaging subset.
    pub(crate) imaging: Box<ImagingTables>,
    /// Selection and feedback.
    pub(crate) render_modes: RenderModes,
    /// Occlusion queries.
    pub(crate) queries: Queries,
    /// The buffers that are drawn into.
    pub(crate) framebuffer: Framebuffer,
}

impl Engine {
    /// An engine in the initial state with a framebuffer of a size. Where there can be no such framebuffer it has no
    /// pixels, and the second value says why.
    pub(crate) fn new(width: u32, height: u32, config: Config) -> (Box<Self>, Outcome) {
        let config = config.checked();
        let (framebuffer, outcome) = match Framebuffer::new(width, height, config.format) {
            Ok(framebuffer) => (framebuffer, Ok(())),
            Err(error) => (Framebuffer::empty(config.format), Err(out_of_memory(error.message))),
        };
        (Self::with_framebuffer(framebuffer, config), outcome)
    }

    /// An engine in the initial state that draws into a framebuffer. Some 40 KiB, which are on the stack only here.
    #[inline(never)]
    pub(crate) fn with_framebuffer(framebuffer: Framebuffer, config: Config) -> Box<Self> {
        // Before the large frame of the engine itself: its parts are made on the stack as well.
        let scene = Scene::new(config.threads, config.batch_cut, config.level);
        let mut engine = Box::new(Self {
            state: State::default(),
            dirty: Dirty::ALL,
            config,
            client: Client::default(),
            attributes: AttributeStack::default(),
            client_attributes: Vec::new(),
            textures: Textures::default(),
            proxies: Box::new([[Proxy::default(); MAX_TEXTURE_LEVELS]; 5]),
            buffers: Buffers::default(),
            vertex_arrays: VertexArrays::default(),
            primitive: Primitive::default(),
            batches: 0,
            raster_pos: None,
            pipe: VertexPipeline::new(config.level, config.batch_cut),
            draw_workers: Vec::new(),
            setup_jobs: SetupJobPool::default(),
            scene,
            program: None,
            drawing: false,
            unseen: false,
            q_units: 0,
            notes: Vec::new(),
            told: BTreeSet::new(),
            advised: false,
            pixels_written: 0,
            tally: None,
            imaging: Box::default(),
            render_modes: RenderModes::default(),
            queries: Queries::default(),
            framebuffer,
        });
        engine.window_sized();
        engine
    }

    /// The viewport and the scissor box become those of the framebuffer, as when a context meets its first window.
    pub(crate) fn window_sized(&mut self) {
        let (width, height) = (self.framebuffer.width().cast_signed(), self.framebuffer.height().cast_signed());
        let viewport = &mut self.state.viewport;
        (viewport.x, viewport.y, viewport.width, viewport.height) = (0, 0, width, height);
        let scissor = &mut self.state.scissor;
        (scissor.x, scissor.y, scissor.width, scissor.height) = (0, 0, width, height);
        self.dirty = Dirty::ALL;
    }
}
