//! Setup (OpenGL 1.5, sections 3.3 to 3.5): from processed vertices to what a scene keeps of a primitive, which is its
//! coverage (which pixels) and its planes (which values there).

pub(super) mod aa_coverage;
pub(super) mod coverage;
pub(super) mod line;
pub(super) mod plane_buffer;
pub(super) mod planes;
pub(super) mod point;
pub(super) mod texcoord_planes;
pub(super) mod triangle;
pub(super) mod weights;
