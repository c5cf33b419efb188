//! The context: GL as one owned value (OpenGL 1.5, chapter 2.5). A [`Context`] is the engine plus what surrounds every
//! command: the Begin/End rule, the open display list, the trace, the first error. Its command methods are generated
//! from the one table in [`table`], where each command is a row; the methods of the engine do the work.

pub(crate) mod args;
pub(crate) mod array_pointers;
pub(crate) mod arrays;
pub(crate) mod attrib;
pub(crate) mod attribute_stack;
pub(crate) mod begin_end;
pub(crate) mod buffer_objects;
pub(crate) mod buffers;
pub(crate) mod capture;
pub(crate) mod color_tables;
pub(crate) mod config;
pub(crate) mod context_commands;
pub(crate) mod convert;
pub(crate) mod convolution;
pub(crate) mod draw_arrays;
pub(crate) mod draw_source;
#[cfg(test)]
mod draw_tests;
pub(crate) mod enable;
pub(crate) mod engine;
pub(crate) mod errors;
pub(crate) mod evaluators;
pub(crate) mod fetch;
pub(crate) mod flush;
pub(crate) mod fragment_state;
pub(crate) mod get;
pub(crate) mod get_limits;
pub(crate) mod get_params;
pub(crate) mod histogram;
pub(crate) mod imaging;
pub(crate) mod imaging_tables;
pub(crate) mod immediate_fast;
pub(crate) mod lighting_state;
pub(crate) mod list_compile;
pub(crate) mod list_names;
pub(crate) mod list_vertices;
pub(crate) mod lists;
pub(crate) mod matrices;
pub(crate) mod param_counts;
pub(crate) mod params;
pub(crate) mod pixel_rectangles;
pub(crate) mod pixel_state;
pub(crate) mod pixels_arg;
pub(crate) mod proxies;
pub(crate) mod queries;
pub(crate) mod query_objects;
pub(crate) mod raster_position;
pub(crate) mod raster_state;
pub(crate) mod readback;
pub(crate) mod recorder;
pub(crate) mod render_modes;
pub(crate) mod render_records;
pub(crate) mod show;
pub(crate) mod standard_error;
pub mod table;
pub(crate) mod tex_image;
pub(crate) mod tex_query;
pub(crate) mod tex_sub_image;
pub(crate) mod tex_unit;
pub(crate) mod texture_objects;
pub(crate) mod textures;
pub(crate) mod trace;
pub(crate) mod validate;
pub(crate) mod values;
pub(crate) mod vertex_array_objects;
pub(crate) mod vertex_arrays;
pub(crate) mod whole_vertex;

pub use args::{Element, InSlice, IntoGl, OutSlice};
pub use config::Config;
pub use errors::{DebugCallback, DebugMessage, Error};
pub use pixels_arg::{
    ArrayData, ClientAddress, IndexLists, Indices, IntoArray, IntoIndices, IntoPixels, IntoPixelsMut, NULL, Null,
    Pixels, PixelsMut,
};
pub use trace::{Call, TraceCallback};

pub(crate) use params::Params;
pub(crate) use values::Values;

use engine::Engine;

/// What a command has to look at before it reaches the engine: one byte, zero in the common case.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CallFlags(u8);

impl CallFlags {
    const TRACING: u8 = 1;
    const RECORDING: u8 = 2;

    /// Whether there is nothing to look at.
    #[cfg(feature = "capi")]
    #[inline]
    pub(crate) fn none(self) -> bool {
        self.0 == 0
    }

    /// Whether a trace callback listens.
    #[inline]
    pub(crate) fn tracing(self) -> bool {
        self.0 & Self::TRACING != 0
    }

    /// Whether a display list is open.
    #[inline]
    pub(crate) fn recording(self) -> bool {
        self.0 & Self::RECORDING != 0
    }

    pub(crate) fn set_tracing(&mut self, on: bool) {
        self.0 = self.0 & !Self::TRACING | if on { Self::TRACING } else { 0 };
    }

    pub(crate) fn set_recording(&mut self, on: bool) {
        self.0 = self.0 & !Self::RECORDING | if on { Self::RECORDING } else { 0 };
    }
}

/// A GL context: all state, all objects, a framebuffer, and the commands as methods.
pub struct Context {
    pub(crate) engine: Box<Engine>,
    pub(crate) flags: CallFlags,
    pub(crate) error: Option<Box<Error>>,
    pub(crate) recorder: recorder::Recorder,
    pub(crate) debug: Option<DebugCallback>,
    pub(crate) trace: Option<TraceCallback>,
    /// The program that the trace has told of last.
    pub(crate) traced: std::sync::Weak<crate::fragment::program::Program>,
}

impl Context {
    /// A context in GL's initial state with a framebuffer of a size. Where there can be no such framebuffer, its size is
    /// 0 by 0 and the error `OUT_OF_MEMORY` is recorded, which [`check`](Self::check) reports; [`try_new`](Self::try_new)
    /// returns it.
    #[must_use]
    #[track_caller]
    pub fn new(width: u32, height: u32) -> Self {
        Self::with_config(width, height, Config::from_env())
    }

    /// The same, run as a [`Config`] says.
    #[must_use]
    #[track_caller]
    pub fn with_config(width: u32, height: u32, config: Config) -> Self {
        let (engine, outcome) = Engine::new(width, height, config);
        let mut cx = Self::from_engine(engine);
        cx.record_result("Context::new", outcome);
        cx
    }

    /// A context in GL's initial state with a framebuffer of a size.
    ///
    /// # Errors
    /// `OUT_OF_MEMORY` if a side is beyond the limit of 16384 pixels, or if there is not enough memory.
    #[track_caller]
    pub fn try_new(width: u32, height: u32) -> Result<Self, Error> {
        Self::try_with_config(width, height, Config::from_env())
    }

    /// The same, run as a [`Config`] says.
    ///
    /// # Errors
    /// See [`try_new`](Self::try_new).
    #[track_caller]
    pub fn try_with_config(width: u32, height: u32, config: Config) -> Result<Self, Error> {
        let mut cx = Self::with_config(width, height, config);
        cx.check().map(|()| cx)
    }

    /// A context around an engine.
    pub(crate) fn from_engine(engine: Box<Engine>) -> Self {
        let debug = engine.config.debug;
        let mut cx = Self {
            engine,
            flags: CallFlags::default(),
            error: None,
            recorder: recorder::Recorder::default(),
            debug: None,
            trace: None,
            traced: std::sync::Weak::new(),
        };
        if debug {
            cx.set_debug_callback(Some(standard_error::callback()));
        }
        cx
    }
}

impl std::fmt::Debug for Context {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Context").field("error", &self.error).field("flags", &self.flags).finish_non_exhaustive()
    }
}
