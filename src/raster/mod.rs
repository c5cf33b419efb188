//! Rasterisation (OpenGL 1.5, sections 3.3 to 3.5): from processed vertices to fragments. Setup turns a primitive into
//! coverage (which pixels) and planes (which values there), and a [`Scene`] keeps both until it is flushed. Then a
//! rasteriser emits the pixels of each band of rows in batches of 64 fragments, which the draw's fragment program works on.

mod binning;
mod coverage;
mod draw;
mod emit;
mod geometry;
mod program_trait;
mod raster_thread;
mod rasteriser;
mod scene;
mod scheduler;
mod setup;
mod sink;
pub mod state;
#[cfg(test)]
mod testing;
mod triangle_batch;
pub mod vertex;
mod worker_pool;

pub use draw::{Draw, PrimitiveBuilder};
pub use program_trait::FragmentProgram;
pub use raster_thread::SetupFn;
pub use scene::Scene;
pub use scheduler::SplitDraw;
pub use setup::pixel_rect::BitmapBlock;
pub use sink::PrimitiveSink;
pub use state::RasterState;
pub use triangle_batch::corners::CornerLanes;
