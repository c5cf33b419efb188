//! The engine: everything that GL does, without the doors. This is the place holder with the few questions that the
//! doors ask it; the commands come with the chapters.

/// The state machine and the pipeline.
#[derive(Debug, Default)]
pub(crate) struct Engine {}

impl Engine {
    /// An engine with a framebuffer of a size.
    pub(crate) fn new(_width: u32, _height: u32) -> Self {
        Self {}
    }
}
