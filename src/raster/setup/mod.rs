//! Setup (OpenGL 1.5, sections 3.3 to 3.5): from processed vertices to what a scene keeps of a primitive, which is its
//! coverage (which pixels) and its planes (which values there).

pub(super) mod basis;
pub(super) mod depth;
pub(super) mod line;
pub(super) mod pixel_rect;
pub(super) mod plane_buffer;
pub(super) mod planes;
pub(super) mod point;
pub(super) mod position;
mod smooth;
pub(super) mod texcoord_planes;
pub(super) mod triangle;
pub(super) mod weights;

use super::state::RasterState;
use planes::SetupPlan;

/// What all setup functions need to know of the draw.
#[derive(Clone, Copy, Debug)]
pub struct SetupContext<'a> {
    /// State of the rasteriser.
    pub rs: &'a RasterState,
    /// What to interpolate.
    pub plan: &'a SetupPlan,
    /// Index of the draw.
    pub draw: u32,
}
