//! Rasterisation (OpenGL 1.5, sections 3.3 to 3.5): from processed vertices to runs of fragments. Setup turns a primitive
//! into a shape (which pixels) and planes (which values there); a [`scene::Scene`] keeps both until it is flushed; the
//! walk over a band of rows appends row runs to batches of 64 fragments, which the draw's fragment program works on.

mod bands;
mod coordinate;
mod corners;
mod crew;
mod emit;
mod geometry;
mod group;
mod group_planes;
mod line;
mod masks;
mod plane;
mod point;
mod polygon;
mod pool;
mod rounds;
mod rows;
mod scene;
mod setup;
mod shader;
mod smooth;
pub mod state;
#[cfg(test)]
mod testing;
pub mod vertex;
mod walker;
mod weights;

pub use corners::Corners;
pub use geometry::Span;
pub use rounds::Pieces;
pub use scene::{Builder, Draw, Scene};
pub use shader::Shader;
pub use state::RasterState;
pub use walker::SetUp;

/// A processed vertex as setup reads it.
#[derive(Clone, Copy, Debug)]
pub struct VertexRef<'a> {
    /// The position part.
    pub head: &'a vertex::Vertex,
    /// The values of its slots, at least the layout's stride of them.
    pub slots: &'a [f32],
}
